#pragma once
// How scenes come about: from a walk, and from the boxes of shape rules.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "turtle/detail/module_turtle.hpp"

namespace algae {

/// The sum of the lengths of all rods.
///
/// Example: total_length(Scene{}) == 0
double total_length(const Scene& scene);

/// The boxes that shape rules made, as solids. Their Y is up: X is x, Y is z and Z is -y, as in the
/// documents that draw buildings so. A box has the colour whose number is its symbol's in the
/// alphabet.
///
/// Example: box_scene(read_lsystem("axiom A", ""), {{0, {0, 0, 0}, {1, 2, 3}}}).solids.front().size == Vector{1, 3, 2}
Scene box_scene(const Model& system, const std::vector<ShapeBox>& boxes);

/// Makes a Scene of what a turtle does.
class SceneBuilder : public TurtleEvents {
public:
    /// For a word of so many modules.
    SceneBuilder(const Drawing& drawing, std::string name, std::size_t modules,
                 const Budget& budget);

    void before(std::size_t module, const TurtleState&) override;
    bool wants_modules() const override { return runs_along_; }
    void stroke(const Vector& from, const TurtleState& state) override;
    void move(const Vector&, const TurtleState&) override { last_ = Rod::none; }
    void branched(const TurtleState&) override { saved_.push_back(last_); }
    void returned(const TurtleState&) override;
    void polygon(std::span<const Vector> corners) override;
    void solid(SolidShape shape, const Vector& size, const TurtleState& state) override;
    void colour(std::uint32_t index) override { paint_ = {index, {}}; }
    void paint(const Colour& colour) override { paint_.colour = colour; }

    /// The scene, once the turtle has stopped.
    Scene finished();

private:
    Paint paint_now() const;
    void check_memory() const;
    void name_branches();

    Scene scene_;
    const Budget& budget_;
    std::vector<std::string> schemes_;  // by colour: the one that runs with the word; may be empty
    bool runs_along_ = false;
    double modules_, fraction_ = 0;
    Paint paint_;
    std::uint32_t last_ = Rod::none;     // the rod at whose end the turtle stands
    std::vector<std::uint32_t> saved_;   // the same by open branch
    std::vector<std::uint32_t> depths_;  // by rod: how many branches were open
};

}  // namespace algae
