#include "render/scene_text.hpp"

#include <fmt/format.h>

namespace algae {

void SceneText::add(std::string_view text) {
    text_ += text;
    if (text_.size() > 1 << 16) flush();
}

void SceneText::vector(const Vector& v) {
    add(fmt::format("{} {} {}", single(v.x), single(v.y), single(v.z)));
}

void SceneText::colour(const Colour& c) { vector({c.red, c.green, c.blue}); }

void SceneText::turn(const AxisTurn& turn) {
    vector(turn.axis);
    add(fmt::format(" {}", single(turn.radians)));
}

void SceneText::points(const std::vector<Vector>& points) {
    for (const Vector& point : points) {
        vector(point);
        add(", ");
    }
}

void SceneText::triangles(const std::vector<Mesh::Triangle>& triangles) {
    for (const auto& [a, b, c] : triangles) add(fmt::format("{},{},{},-1, ", a, b, c));
}

void SceneText::strokes(const SceneGraph::Lines& lines) {
    std::uint32_t point = 0;
    for (const std::uint32_t count : lines.strokes) {
        for (std::uint32_t i = 0; i < count; ++i) add(fmt::format("{},", point++));
        add("-1, ");
    }
}

void SceneText::flush() {
    budget_.check();
    output_.write(text_.data(), text_.size());
    text_.clear();
}

}  // namespace algae
