#pragma once
// turtle: words to Figures; exact where the angle allows it. Knows no picture format.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "rewrite/module_string.hpp"
#include "system/lsystem.hpp"
#include "turtle/canvas.hpp"
#include "turtle/coordinate.hpp"
#include "turtle/derived_modules.hpp"
#include "turtle/pose.hpp"

namespace algae {

/// What is known of a drawing without drawing it.
struct Facts {
    Integer segments;                   // drawn, with multiplicity
    std::vector<Coordinate> end;        // where the turtle stops: x, y
    std::vector<Coordinate> low, high;  // the box around what is drawn; empty if nothing is
    bool exact = false;                 // whether the coordinates are exact numbers
    double step = 1;                    // length of a segment, before any change of scale; of the
                                        // shortest where lengths are parameters
    double widest = 0;                  // of the strokes whose width is a length, that of the widest
};

/// A drawing of one generation of a system, ready to be sent to a canvas as often as one likes.
/// It holds the rules, not the strokes: drawing streams, and takes memory for one path down the
/// derivation only.
class Figure {
public:
    virtual ~Figure() = default;

    /// The box around everything that is drawn (strokes and polygons, not invisible moves),
    /// without line widths. Empty if nothing is drawn.
    virtual const Box& box() const = 0;
    /// How many segments are drawn, with multiplicity; polygons do not count.
    virtual const Integer& segments() const = 0;
    /// The same and more, as exactly as the system allows.
    virtual const Facts& facts() const = 0;
    /// The lines and polygons this figure sends to a canvas at most, or nothing if the bound is
    /// not known to fit 64 bits.
    virtual std::optional<std::uint64_t> strokes() const = 0;
    /// How this figure wants to be drawn, unless the caller knows better.
    virtual const Settings& settings() const = 0;

    /// Draws everything. A part of the derivation whose drawing lies within `resolution` (in the
    /// figure's own units, 0 for none) of the straight way from its start to its end may be replaced
    /// by that stroke, or left out where the same part was drawn at the same place
    /// before: then the work depends on box and resolution, not on the length of the word.
    /// Throws Error if brackets or braces do not match, with the generation and the position, counted from 0.
    virtual void draw(Canvas& canvas, double resolution, const Budget& budget) const = 0;

    /// Whether what is drawn later hides what is drawn before: a picture of something in space. Then
    /// `resolution` is the size of a pixel or a point, and says how fine its facets are.
    virtual bool is_layered() const { return false; }
    /// Where a point of what is drawn lies in the plane, or nothing if it lies nowhere. A figure in
    /// the plane has no points above it.
    virtual std::optional<Point> place(const Vector& point) const {
        return point.z == 0 ? std::optional(Point{point.x, point.y}) : std::nullopt;
    }
    /// Whether lengths are the same everywhere in the figure.
    virtual bool has_scale() const { return true; }
};

/// The figure of generation `n` of a system, derived as Rewriting says where it is no D0L system.
/// Systems without parameters have exact figures wherever their angles and steps allow it.
///
/// Throws Error if the system is not one that a turtle in the plane can draw, or leaves a choice
/// that nobody made (the message names the rule or symbol), BoundReached if the budget does not
/// suffice. For D0L systems O(n * size of the rules) exact operations, for others the length of
/// the words.
std::unique_ptr<Figure> figure(const LSystem& system, std::uint64_t n, const Budget& budget,
                               const FigureChoices& choices = {});

/// The figure of one word of a system, drawn as its generation `n` is.
std::unique_ptr<Figure> figure(const LSystem& system, const Word& word, std::uint64_t n,
                               const Budget& budget);

/// The same of a word of modules over these kinds. The seed is for interpretations that have
/// probabilities. Exact where nothing in the word or the system has parameters.
std::unique_ptr<Figure> figure(const LSystem& system, const ModuleKinds& kinds, ModuleString word,
                               std::uint64_t n, std::uint64_t seed, const Budget& budget);

}  // namespace algae
