#pragma once

#include <fmt/format.h>

#include <iterator>

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

    template <class... Parts>
    void add(fmt::format_string<Parts...> pattern, Parts&&... parts) {
        fmt::format_to(std::back_inserter(text_), pattern, std::forward<Parts>(parts)...);
        if (text_.size() > 1 << 16) flush();
    }
    void vector(const Vector& v) { add("{} {} {}", single(v.x), single(v.y), single(v.z)); }
    void colour(const Colour& c) {
        add("{} {} {}", single(c.red), single(c.green), single(c.blue));
    }
    void turn(const AxisTurn& turn) {
        vector(turn.axis);
        add(" {}", single(turn.radians));
    }
    /// Points with commas between.
    void points(const std::vector<Vector>& points) {
        for (const Vector& point : points) {
            vector(point);
            add(", ");
        }
    }
    /// Corners of triangles, -1 after each, with commas, which XML and VRML97 take for blanks.
    void triangles(const std::vector<Mesh::Triangle>& triangles) {
        for (const auto& [a, b, c] : triangles) add("{},{},{},-1, ", a, b, c);
    }
    /// The points of strokes, -1 after each stroke.
    void strokes(const SceneGraph::Lines& lines) {
        std::uint32_t point = 0;
        for (const std::uint32_t count : lines.strokes) {
            for (std::uint32_t i = 0; i < count; ++i) add("{},", point++);
            add("-1, ");
        }
    }
    void flush() {
        budget_.check();
        output_.write(text_.data(), text_.size());
        text_.clear();
    }

private:
    Output& output_;
    const Budget& budget_;
    fmt::memory_buffer text_;
};

}  // namespace algae
