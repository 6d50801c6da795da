#pragma once
// What the sources of figures in the plane share.

#include <complex>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>

#include "rewrite/rewrite.hpp"
#include "turtle/turtle.hpp"

namespace algae {

/// What a part of a derivation does to a turtle and where it draws, in doubles: enough to leave a
/// part out, or to draw a stroke instead of it, when it is too small to be seen. A part's drawing
/// is kept as a disc around it. The laws of a monoid hold up to rounding.
class Pieces {
public:
    struct value_type {
        std::complex<double> move;  // from its start to its end, turtle looking along +x
        Compass::Heading turn = 0;
        double size = 1;              // factor on the turtle's own step
        double width = 1;             // factor on the line width
        double colours = 0;           // steps in the list of colours
        std::complex<double> centre;  // of a disc around all that is drawn
        double radius = -1;           // negative: nothing is drawn
        double letters = 0;
        bool operator==(const value_type&) const = default;

        bool draws() const { return radius >= 0; }
        /// How far from the start the drawing reaches at most.
        double reach() const { return draws() ? std::abs(centre) + radius : 0; }
        /// How far any point of the straight way from start to end is from any point drawn, at most.
        double extent() const {
            return draws() ? std::max(std::abs(centre), std::abs(move - centre)) + radius : 0;
        }
    };

    explicit Pieces(const Compass& compass) : compass_(&compass) {}

    value_type one() const { return {}; }
    void append(value_type& left, const value_type& right) const;
    value_type branch(const value_type& twig) const;

private:
    const Compass* compass_;
};

/// What a pen needs to know of the figure it draws.
struct PenSettings {
    Point start;         // in the units of the file
    double unit = 1;     // length of a step there
    double scale = 1;    // factor of the command `scale`
    double narrow = 1;   // factor of the command `narrow`
    double letters = 1;  // of the whole word
    std::string figure;  // "generation 5 of koch", for messages
};

/// Draws `steps` steps of `rules` letter by letter as Pen<LatticePosition> does, stroke for stroke
/// and number for number, only faster: what a letter draws in its last few steps is worked out once
/// for each heading and then moved to where the turtle is, in whole numbers.
///
/// Returns false, and draws nothing, where that does not apply: an inexact compass, coordinates of
/// more than four numbers, commands beyond drawing, moving, turning and brackets, a canvas that wants
/// positions. Every letter but the brackets must leave the stack as it found it.
bool draw_lattice_blocks(const D0L& rules, const Fates& fates, std::uint64_t steps,
                         const Commands& commands, const Compass& compass,
                         const PenSettings& settings, Canvas& canvas, const Budget& budget);

/// `steps` steps of a D0L system from its axiom, drawn as generation `generation` of `system`. Facts
/// come from folds where brackets and commands allow it, otherwise from one walk. `rounded` is what Facts says of the parameters.
std::unique_ptr<Figure> plane_figure(const Model& system, D0L rules, std::uint64_t steps,
                                     std::uint64_t generation, const Budget& budget,
                                     const std::string& rounded = {});

/// The figure of a word of modules, walked in doubles whenever it is drawn. Throws Error if a symbol or a
/// tropism leaves the plane, and as ModuleTurtle does. `seed` is for interpretations with probabilities.
std::unique_ptr<Figure> module_figure(const Model& system, const ModuleKinds& kinds,
                                      ModuleString word, std::uint64_t generation,
                                      std::uint64_t seed, const Budget& budget,
                                      const std::string& rounded = {});

/// A canvas that measures what is drawn on it.
class Surveyor : public Canvas {
public:
    void move_to(Point point) override { from_ = point; }
    void line_to(Point point) override {
        ++lines;
        box.add(from_);
        box.add(point);
        widest_length = std::max(widest_length, length_);
        const double x = point.x - from_.x, y = point.y - from_.y;
        const double square = x * x + y * y;
        if (square > 0 && square < shortest_square_) shortest_square_ = square;
        from_ = point;
    }
    void polygon(std::span<const Point> corners) override {
        ++polygons;
        for (const Point corner : corners) box.add(corner);
    }
    void width(double) override { length_ = 0; }
    void width_as_length(double length) override { length_ = length; }

    /// The length of the shortest stroke that has one; infinite if none has.
    double shortest() const { return std::sqrt(shortest_square_); }

    Box box;
    std::uint64_t lines = 0, polygons = 0;
    double widest_length = 0;  // of the strokes whose width is a length

private:
    Point from_;
    double length_ = 0;
    double shortest_square_ = std::numeric_limits<double>::infinity();
};

/// Throws Error if a turtle cannot draw generation `n` of the system, or would have to guess: it has
/// shape rules, communication modules, tables or several rules for a letter that nobody chose from.
void check_choices(const LSystem& system, std::uint64_t n, const FigureChoices& choices);

/// Throws the Error that says that this symbol makes a figure in space of the system's.
[[noreturn]] void refuse_space(const LSystem& system, Symbol symbol);

}  // namespace algae
