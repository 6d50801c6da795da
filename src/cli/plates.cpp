#include "cli/plates.hpp"

#include "base/error.hpp"
#include "rewrite/rewriting.hpp"
#include "system/d0l.hpp"
#include "system/ol.hpp"
#include "system/s0l.hpp"

namespace algae::cli {

namespace {

/// The word that `algae derive` picks for this seed.
Word picked_word(const LSystem& system, std::uint64_t n, std::optional<std::uint64_t> seed, const Budget& budget) {
    RewritingChoices choices;
    choices.evenly = bool(as_ol(system));
    if (seed) choices.seed = *seed;
    const Rewriting rewriting(system, choices);
    return letters(rewriting.rules().kinds, derive(rewriting, n, {}, budget));
}

}  // namespace

FigurePlates::FigurePlates(const LSystem& system, std::pair<std::uint64_t, std::uint64_t> generations,
                           std::optional<std::uint64_t> seed, const Budget& budget)
    : title_(system.title.empty() ? system.name : system.title) {
    if (const auto& angle = system.settings.angle) {
        const auto decimal = angle->exact ? exact_decimal(*angle->exact) : std::nullopt;
        angle_ = (decimal ? *decimal : to_text(angle->expression)) + "°";
    }
    const bool stochastic = !as_ol(system) && as_s0l(system);
    if (seed && !stochastic && !as_ol(system)) as_ol(system).value();  // says why not
    if (!seed && as_ol(system))
        if (const View<D0L> rules = as_d0l(system); !rules)
            throw Error(rules.reason() + "; say --seed S to draw one word picked at random");
    for (std::uint64_t n = generations.first; n <= generations.second; ++n) {
        FigurePlate& plate = figures.emplace_back();
        plate.generation = n;
        plate.name = "generation " + std::to_string(n) + " of " + system.name;
        if (seed || stochastic) {
            plate.figure = figure(system, picked_word(system, n, seed, budget), n, budget);
        } else {
            plate.figure = figure(system, n, budget);
        }
    }
}

void FigurePlates::caption(const std::string& text) {
    for (FigurePlate& plate : figures) plate.caption = text;
}

void FigurePlates::caption_with_facts() {
    for (FigurePlate& plate : figures) {
        plate.caption = title_ + ", n = " + std::to_string(plate.generation);
        if (!angle_.empty()) plate.caption += ", " + angle_;
    }
}

std::vector<Plate> FigurePlates::plates() const {
    std::vector<Plate> found;
    for (const FigurePlate& plate : figures) found.push_back({plate.figure.get(), plate.name, plate.caption});
    return found;
}

std::pair<std::uint64_t, std::uint64_t> shown_generations(const LSystem& system) {
    if (!system.settings.generations)
        throw Error(system.name + " does not say which generation its figure shows; expected a line such as `generation 4` in it, or "
                    "-n of `algae draw`");
    return *system.settings.generations;
}

}  // namespace algae::cli
