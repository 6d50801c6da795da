#pragma once

#include <span>
#include <vector>

#include "space/lighting.hpp"
#include "space/seen_thing.hpp"
#include "turtle/canvas.hpp"

namespace algae {

/// A scene in the light and the measures of its rods: what painting needs to know.
struct LitScene {
    const Scene& scene;
    const Projection& projection;
    const Lighting& lighting;
    std::vector<std::uint32_t> next;  // by rod: the one that goes on where it ends, or Rod::none
    double resolution = 0;            // the size of a pixel in the picture; 0: unknown
    double line_width = 0;            // of lines without thickness, in the picture; 0: unknown
    double gap = 0;                   // kept free beside such lines, as a multiple of their width
    Colour background;
    std::vector<Colour> colours;   // the scene's list
    bool default_colours = false;  // the scene has no list: lines are black, the rest is grey

    Colour colour(const Paint& paint, bool line) const;
    /// The radius at a rod's end: that of the next where it is thinner.
    double end_radius(std::uint32_t rod) const;
};

/// Sends things as a camera sees them to a canvas as shaded polygons and strokes.
class ScenePainter {
public:
    ScenePainter(Canvas& canvas, const LitScene& lit);

    void paint(const SeenThing& thing);

private:
    void paint_thing(const SeenStick& stick);
    void paint_thing(const SeenBall& ball);
    void paint_thing(const SeenBlock& block);
    /// Its edges, darker, where they are long enough to be seen.
    void paint_edges(const SeenFacet& facet);
    void paint_line(const SeenStick& stick);
    void paint_tube(const SeenStick& stick);
    /// A disc at the end of a tube that looks at the camera, with so many corners: those of the tube's
    /// strips, so that nothing shows between them.
    void paint_cap(const Vector& middle, const Vector& outward, const Vector& side, double radius,
                   int count, const Colour& colour);
    void paint_ball(const Seen& middle, double radius, const Colour& colour);
    void paint_stub(std::uint32_t rod, bool at_start, double reach);
    void joint_ball(std::uint32_t rod, const Vector& middle, double radius, const Colour& colour);
    void multiple_width(double factor);
    void length_width(double length);
    void polygon(const Colour& colour, std::span<const Point> corners);

    // Pixels are squares: what covers one that an edge touches reaches sqrt 2 pixels from the edge.
    static constexpr double under =
        1.3;  // pixels that a facet reaches under one that is painted later
    static constexpr double overlap =
        0.5;  // pixels that two that adjoin both reach over their edge

    static Point flat(const Seen& seen) { return {seen.x, seen.y}; }
    /// A facet whose edges are moved outward where others adjoin, or may. Of a solid, a facet reaches
    /// under those that are painted later; of polygons nobody knows which is.
    static void widen(const SeenFacet& facet, double pixel, bool of_solid,
                      std::vector<Point>& corners);

    Canvas& canvas_;
    const LitScene& lit_;
    std::vector<char>
        painted_;  // by rod: drawn already (lines), or the ball at its start is (tubes)
    std::vector<Point> corners_;
    double width_ = 1;  // of the canvas' pen
    bool width_is_length_ = false;
};

}  // namespace algae
