#pragma once
// nature: the other generators of natural geometry, each as a Relative that has Figures.

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "dimension/exact_dimension.hpp"
#include "space/scene.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// One picture of a relative: what messages call it, and what is written underneath.
struct RelativeFigure {
    std::unique_ptr<Figure> figure;
    std::string name, caption;
};

/// Something that is known of a relative: `key` in JSON, with the value there; on a page the key
/// with blanks for underscores, and the text.
struct RelativeFact {
    std::string key, text;
    nlohmann::ordered_json value;
};

/// A generator of natural geometry that is no L-system: an iterated function system, an automaton,
/// a path of Brownian motion. What it gives depends on itself alone: random ones hold their seed.
class Relative {
public:
    virtual ~Relative() = default;

    /// What messages call it, usually the name of its file.
    std::string name;
    /// As in .lsys files; may be empty.
    std::string title, source;
    /// How its figures want to be drawn: `colour` and `width`.
    Settings settings;

    /// The pictures that a page of it shows, at least one. Throws what making them throws.
    virtual std::vector<RelativeFigure> figures(const Budget& budget) const = 0;

    /// The pictures of an animation of it; those of the page where it says nothing else.
    virtual std::vector<RelativeFigure> frames(const Budget& budget) const {
        return figures(budget);
    }
    /// The one whose dimension is measured: the last of its figures.
    virtual RelativeFigure measured_figure(const Budget& budget) const {
        return std::move(figures(budget).back());
    }
    /// What is known of its dimension without measuring, if anything.
    virtual std::optional<ExactDimension> exact_dimension(const Budget&) const {
        return std::nullopt;
    }
    /// What is worth saying of it, in the order of a page.
    virtual std::vector<RelativeFact> facts(const Budget&) const { return {}; }
    /// The same in space, for those that lie there.
    virtual std::optional<Scene> scene(const Budget&) const { return std::nullopt; }
};

}  // namespace algae
