#pragma once

#include <optional>

#include "space/lighting.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// How a scene is looked at.
struct ViewChoices {
    Camera camera;
    std::optional<Light> light;  // none: over the camera's left shoulder
    double fog = 0;              // the share of the background in what is farthest
    Colour background{1, 1, 1};  // what is behind the scene
    /// What is kept free beside lines without thickness where they pass in front of others, as a
    /// multiple of the line width. None: 1 for a scene without branches, otherwise 0.
    std::optional<double> gap;
    /// What the camera is set up for, and the fog. None: the scene.
    std::optional<SpaceBox> sight;
};

/// How the settings of a file want their scenes to be looked at.
///
/// Example: view_choices(read_lsystem("axiom F; camera 30 20", "").settings).camera == Camera{30, 20}
ViewChoices view_choices(const Settings& settings);

/// What is known of a scene that its rods do not tell.
struct SceneFacts {
    Vector end;       // where the turtle stopped
    double step = 1;  // the turtle's, at its start
};

/// A picture of a scene: what a camera sees of it, in the light, in the plane's units. What is in
/// front hides what is behind.
///
/// Things are convex: pieces of rods, solids, polygons. They are painted in the order that
/// painting_order finds; those that hide each other in a ring are halved until an order is right, a
/// few times at most. Tubes and balls are drawn in facets as fine as the picture shows.
class SpaceView : public Figure {
public:
    /// Throws Error on a camera, light or fog out of bounds, BoundReached if the scene takes more than
    /// the budget's memory.
    SpaceView(Scene scene, const Settings& settings, const SceneFacts& facts,
              const ViewChoices& choices, const Budget& budget);

    const Box& box() const override { return box_; }
    const Integer& segments() const override { return facts_.segments; }
    /// Box and end have three coordinates: those of the scene.
    const Facts& facts() const override { return facts_; }
    std::optional<std::uint64_t> strokes() const override { return scene_.parts(); }
    const Settings& settings() const override { return settings_; }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;
    bool is_layered() const override { return true; }
    std::optional<Point> place(const Vector& point) const override;
    bool has_scale() const override { return !choices_.camera.perspective; }

    const Scene& scene() const { return scene_; }
    const Projection& projection() const { return projection_; }

private:
    Scene scene_;
    Settings settings_;
    ViewChoices choices_;
    Projection projection_;
    Facts facts_;
    Box box_;
    double farthest_ = 0, nearest_ = 0;
    std::vector<std::uint32_t> next_;  // by rod: the one that goes on where it ends
    std::vector<char> adjoins_;  // by corner: another polygon goes on at the edge that begins there
    bool branches_ = false;
};

}  // namespace algae
