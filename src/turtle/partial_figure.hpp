#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "turtle/derived_modules.hpp"
#include "turtle/figure.hpp"
#include "turtle/watched_walk.hpp"

namespace algae {

/// A figure in the plane as far as a turtle has come, and the turtle where it is.
class PartialFigure : public Figure {
public:
    /// What is drawn before this part of the word, from 0 to 1. `room` holds every part of the whole
    /// figure, and the turtle wherever it is.
    PartialFigure(std::shared_ptr<const Figure> whole, double part, const TurtleState& turtle,
                  double size, const Box& room)
        : whole_(std::move(whole)), part_(part), turtle_(turtle), size_(size), room_(room) {}

    const Box& box() const override { return room_; }
    const Integer& segments() const override { return whole_->segments(); }
    const Facts& facts() const override { return whole_->facts(); }
    std::optional<std::uint64_t> strokes() const override { return whole_->strokes(); }
    const Settings& settings() const override { return whole_->settings(); }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;

private:
    std::shared_ptr<const Figure> whole_;
    double part_;
    TurtleState turtle_;
    double size_;
    Box room_;
};

/// The figure of a word after each of these numbers of symbols, which rise; all in one box. Throws
/// what `figure` and ModuleTurtle throw. Linear in the length of the word.
std::vector<std::unique_ptr<Figure>> partial_figures(const LSystem& system,
                                                     const DerivedModules& derived, std::uint64_t n,
                                                     const std::vector<std::size_t>& symbols,
                                                     const Budget& budget);

}  // namespace algae
