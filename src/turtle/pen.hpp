#pragma once

#include <complex>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/cyclotomic.hpp"
#include "turtle/canvas.hpp"
#include "turtle/commands.hpp"
#include "turtle/compass.hpp"
#include "turtle/pieces.hpp"

namespace algae {

/// Where a turtle is: exact coordinates over a root of unity, as machine numbers. They stay below
/// the number of steps walked, so they cannot overflow in a walk that ends.
class LatticePosition {
public:
    explicit LatticePosition(const Compass& compass);

    void step(Compass::Heading heading, double) {
        const std::int64_t* unit = powers_[static_cast<std::size_t>(heading)].data();
        for (std::size_t i = 0; i < degree_; ++i) here_[i] += unit[i];
    }
    std::complex<double> point() const {
        double x = 0, y = 0;
        for (std::size_t i = 0; i < degree_; ++i) {
            x += static_cast<double>(here_[i]) * basis_[i].real();
            y += static_cast<double>(here_[i]) * basis_[i].imag();
        }
        return {x, y};
    }
    void push() { saved_.insert(saved_.end(), here_.begin(), here_.end()); }
    void pop() {
        std::copy(saved_.end() - static_cast<std::ptrdiff_t>(degree_), saved_.end(), here_.begin());
        saved_.resize(saved_.size() - degree_);
    }

private:
    std::size_t degree_;
    std::vector<std::span<const std::int64_t>> powers_;
    std::vector<std::complex<double>> basis_;
    CyclotomicRing ring_;
    std::vector<std::int64_t> here_, saved_;
};

/// Where a turtle is, in doubles.
class FloatingPosition {
public:
    explicit FloatingPosition(const Compass& compass) : compass_(&compass) {}

    void step(Compass::Heading heading, double size) { here_ += size * compass_->direction(heading); }
    void jump(Compass::Heading heading, double size, std::complex<double> move) {
        here_ += size * compass_->direction(heading) * move;
    }
    std::complex<double> point() const { return here_; }
    void push() { saved_.push_back(here_); }
    void pop() {
        here_ = saved_.back();
        saved_.pop_back();
    }

private:
    const Compass* compass_;
    std::complex<double> here_;
    std::vector<std::complex<double>> saved_;
};

/// What a pen needs to know of the figure it draws.
struct PenSettings {
    Point start;          // in the units of the file
    double unit = 1;      // length of a step there
    double scale = 1;     // factor of the command `scale`
    double narrow = 1;    // factor of the command `narrow`
    double letters = 1;   // of the whole word
    std::string figure;   // "generation 5 of koch", for messages
};

/// A turtle with a canvas: does the commands of one letter after the other.
template <class Position>
class Pen {
public:
    Pen(Canvas& canvas, const Compass& compass, const PenSettings& settings);

    /// Does what the letter says. Throws Error on an unmatched ']' or '}'.
    void letter(const std::vector<Command>& commands);
    /// Goes to the end of a part without drawing what is in it: a straight stroke there if it draws.
    void jump(const Pieces::value_type& part, bool stroke);
    /// Throws Error if a '[' or '{' is still open.
    void finish() const;

    Point point() const;
    Compass::Heading heading() const { return state_.heading; }
    double size() const { return state_.size; }
    bool is_cut() const { return cut_; }

private:
    struct State {
        Compass::Heading heading = 0;
        double size = 1;
        double width = 1;
        std::uint32_t colour = 0;
        std::size_t polygons = 0;  // open when a branch began
    };

    void run(Command command);
    void line();
    void corner();
    void restore(const State& state);
    [[noreturn]] void unmatched(const char* what) const;
    void tell_position();

    Canvas& canvas_;
    const Compass& compass_;
    const PenSettings& settings_;
    Position position_;
    State state_;
    std::vector<State> saved_;
    std::vector<std::vector<Point>> polygons_;  // open ones, the innermost last
    double letters_ = 0;
    bool at_pen_ = false;  // whether the canvas' pen stands where the turtle is
    bool cut_ = false;
    std::size_t cut_depth_ = 0;
};

extern template class Pen<LatticePosition>;
extern template class Pen<FloatingPosition>;

}  // namespace algae
