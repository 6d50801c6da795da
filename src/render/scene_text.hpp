#pragma once

#include <string>
#include <string_view>

#include "base/budget.hpp"
#include "render/output.hpp"
#include "render/scene_graph.hpp"

namespace algae {

/// A number as files of scenes have it: of single precision, in the fewest digits; 0 has no sign.
inline float single(double x) { return static_cast<float>(x) + 0.0f; }

/// The text of a scene on its way out.
class SceneText {
public:
    SceneText(Output& output, const Budget& budget) : output_(output), budget_(budget) {}

    void add(std::string_view text);
    void vector(const Vector& v);
    void colour(const Colour& c);
    void turn(const AxisTurn& turn);
    /// Points with commas between.
    void points(const std::vector<Vector>& points);
    /// Corners of triangles, -1 after each, with commas, which XML and VRML97 take for blanks.
    void triangles(const std::vector<Mesh::Triangle>& triangles);
    /// The points of strokes, -1 after each stroke.
    void strokes(const SceneGraph::Lines& lines);
    void flush();

private:
    Output& output_;
    const Budget& budget_;
    std::string text_;
};

}  // namespace algae
