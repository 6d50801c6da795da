#include "cli/plates.hpp"

#include "base/error.hpp"
#include "cli/environment_option.hpp"
#include "environment/open_figure.hpp"
#include "space/space_figure.hpp"
#include "system/d0l.hpp"
#include "system/ol.hpp"

namespace algae::cli {

FigurePlates::FigurePlates(const LSystem& system, std::pair<std::uint64_t, std::uint64_t> generations,
                           const PlateChoices& choices, const Budget& budget)
    : title_(system.title.empty() ? system.name : system.title) {
    if (const auto& angle = system.settings.angle) {
        const auto decimal = angle->exact ? exact_decimal(*angle->exact) : std::nullopt;
        angle_ = (decimal ? *decimal : to_text(angle->expression)) + "°";
    }
    const auto seeds = choices.seeds ? choices.seeds : system.settings.seeds;
    if (!seeds && choices.tables.empty()) {
        if (const View<D0L> rules = as_d0l(system); !rules && as_ol(system))
            throw Error(rules.reason() + "; say --seed S to draw one word picked at random");
        if (leaves_tables_open(system))
            throw Error("it has " + std::to_string(system.tables.size()) +
                        " tables and no schedule; say --tables SEQUENCE, or --seed S for random ones");
    }
    many_seeds_ = seeds && seeds->first != seeds->second;
    const bool in_space = leaves_plane(system);
    if (!in_space) choices.space.check_unused(system.name);
    LSystem painted = system;
    if (!choices.colours.empty()) painted.settings.colours = choices.colours;
    const ViewChoices view_of = view_choices(choices.space, system, choices.background);
    const auto view = [&](std::uint64_t n, std::optional<std::uint64_t> seed) {
        SpaceDerivation found = scene(painted, n, budget, {seed, choices.tables, choices.seeds.has_value()},
                                      external_environment(choices.environment, system));
        return std::make_unique<SpaceView>(std::move(found.scene), painted.settings, SceneFacts{found.end.position, found.facts.step}, view_of, budget);
    };
    const auto add = [&](std::uint64_t n, std::optional<std::uint64_t> seed) {
        FigurePlate& plate = figures.emplace_back();
        plate.generation = n;
        plate.seed = seed;
        plate.name = "generation " + std::to_string(n) + " of " + system.name;
        if (many_seeds_) plate.name += ", seed " + std::to_string(*seed);
        if (in_space) plate.figure = view(n, seed);
        else plate.figure = open_figure(system, n, budget, {seed, choices.tables, choices.seeds.has_value()},
                                   external_environment(choices.environment, system));
    };
    for (std::uint64_t n = generations.first; n <= generations.second; ++n) {
        if (!seeds) add(n, std::nullopt);
        else
            for (std::uint64_t seed = seeds->first; seed <= seeds->second; ++seed) add(n, seed);
    }
}

void FigurePlates::caption(const std::string& text) {
    for (FigurePlate& plate : figures) plate.caption = text;
}

void FigurePlates::caption_with_facts() {
    for (FigurePlate& plate : figures) {
        plate.caption = title_ + ", n = " + std::to_string(plate.generation);
        if (!angle_.empty()) plate.caption += ", " + angle_;
        if (many_seeds_) plate.caption += ", seed " + std::to_string(*plate.seed);
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
