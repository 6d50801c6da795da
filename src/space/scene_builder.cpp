#include "space/scene_builder.hpp"

#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "system/colour.hpp"

namespace algae {

SceneBuilder::SceneBuilder(const Settings& settings, std::string name, std::size_t modules,
                           const Budget& budget)
    : budget_(budget), modules_(static_cast<double>(modules)) {
    scene_.name = std::move(name);
    scene_.colours = settings.colours;
    for (const std::string& colour : settings.colours) {
        along_.push_back(colour == "along");
        runs_along_ = runs_along_ || along_.back();
    }
}

void SceneBuilder::before(std::size_t module, const TurtleState&) {
    fraction_ = static_cast<double>(module) / modules_;
}

Paint SceneBuilder::paint_now() const {
    constexpr double hues = 256;
    if (paint_.colour || !runs_along_ || !along_[paint_.index % along_.size()]) return paint_;
    return {paint_.index, hue(360 * std::floor(fraction_ * hues) / hues)};
}

void SceneBuilder::check_memory() const {
    budget_.check();
    budget_.check_memory(
        scene_.rods.capacity() * sizeof(Rod) + scene_.corners.capacity() * sizeof(Vector) +
            scene_.faces.capacity() * sizeof(Face) + scene_.solids.capacity() * sizeof(Solid) +
            2 * depths_.capacity() * sizeof(std::uint32_t),
        "the scene");
}

void SceneBuilder::stroke(const Vector& from, const TurtleState& state) {
    if (scene_.rods.size() % 65536 == 0) check_memory();
    if (scene_.rods.size() == Rod::none)
        throw BoundReached(Bound::method, scene_.name + " has more than 2^32 - 1 segments");
    Rod rod;
    rod.from = from;
    rod.to = state.position;
    if (state.width.is_length)
        rod.radius = state.width.amount / 2;
    else
        rod.line_width = state.width.amount;
    rod.paint = paint_now();
    rod.before = last_;
    last_ = static_cast<std::uint32_t>(scene_.rods.size());
    scene_.rods.push_back(rod);
    depths_.push_back(static_cast<std::uint32_t>(saved_.size()));
}

void SceneBuilder::returned(const TurtleState&) {
    last_ = saved_.back();
    saved_.pop_back();
}

void SceneBuilder::polygon(std::span<const Vector> corners) {
    if (scene_.faces.size() % 65536 == 0) check_memory();
    scene_.add_face(corners, paint_now());
}

void SceneBuilder::solid(SolidShape shape, const Vector& size, const TurtleState& state) {
    if (scene_.solids.size() % 65536 == 0) check_memory();
    scene_.solids.push_back({shape, state.position, state.attitude, size, paint_now()});
}

void SceneBuilder::name_branches() {
    std::vector<std::uint32_t> next(scene_.rods.size(), Rod::none);  // the one that goes on
    for (std::uint32_t i = 0; i < scene_.rods.size(); ++i) {
        const std::uint32_t before = scene_.rods[i].before;
        if (before == Rod::none) continue;
        if (next[before] == Rod::none || depths_[i] < depths_[next[before]]) next[before] = i;
    }
    for (std::uint32_t i = 0; i < scene_.rods.size(); ++i) {
        Rod& rod = scene_.rods[i];
        rod.branch = rod.before != Rod::none && next[rod.before] != i;
    }
}

Scene SceneBuilder::finished() {
    check_memory();
    name_branches();
    return std::move(scene_);
}

}  // namespace algae
