#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/growth_interaction.hpp"
#include "cli/growth_realise.hpp"
#include "cli/growth_report.hpp"
#include "cli/growth_words.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "growth/incidence.hpp"
#include "render/plot.hpp"
#include "turtle/segments.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file, generation, plot, sequence;
    bool bounds_wanted = false, words = false, counts = false, json = false;
    Bounds bounds;
};

/// The exact lengths only.
int print_lengths(const D0L& system, const Options& options, const Budget& budget) {
    const auto [first, last] = range("-n", options.generation);
    std::string text;
    nlohmann::json found = nlohmann::json::array();
    for (std::uint64_t n = first; n <= last; ++n) {
        const Integer letters = length(system, n, budget);
        if (options.json)
            found.push_back(json_number(letters));
        else
            text += to_string(letters) + '\n';
    }
    print(options.json ? nlohmann::json{{"lengths", found}}.dump(2) + "\n" : text);
    return success;
}

/// Lengths, how often each letter occurs, and how many segments are drawn.
int print_counts(const LSystem& system, const D0L& rules, const Options& options, const Budget& budget) {
    if (options.generation.empty()) throw Error("--counts needs a generation: -n");
    const Commands commands(system, rules.letters);
    const auto [first, last] = range("-n", options.generation);
    std::string text;
    nlohmann::ordered_json generations = nlohmann::ordered_json::array();
    for (std::uint64_t n = first; n <= last; ++n) {
        const auto counts = parikh_vector(rules, n, budget);
        Integer sum = 0;
        nlohmann::ordered_json letters;
        std::string listed;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            sum += counts[i];
            const std::string& name = system.alphabet.name(rules.letters[i]);
            letters[name] = json_number(counts[i]);
            listed += "  " + name + ' ' + to_string(counts[i]);
        }
        const Integer segments = drawn_segments(commands, rules.letters, counts);
        generations.push_back({{"generation", n}, {"length", json_number(sum)}, {"segments", json_number(segments)}, {"letters", letters}});
        text += "n = " + std::to_string(n) + ": length " + to_string(sum) + ", segments " + to_string(segments) +
                ", letters" + listed + '\n';
    }
    print(options.json ? nlohmann::ordered_json{{"generations", generations}}.dump(2) + "\n" : text);
    return success;
}

int print_bounds(const LSystem& system, const Options& options, const Budget& budget) {
    const View<OL> rules = as_ol(system);
    const auto [first, last] = range("-n", options.generation.empty() ? "0..10" : options.generation);
    const LengthBounds bounds = length_bounds(*rules, last, budget);
    print(options.json ? bounds_json(*rules, bounds, first).dump(2) + "\n" : bounds_page(*rules, bounds, first));
    return success;
}

/// A system without a growth function says why, and what to ask instead.
D0L with_growth_function(const LSystem& system) {
    View<D0L> rules = as_d0l(system);
    if (rules) return *rules;
    throw Error("no growth function: " + rules.reason() +
                (as_ol(system) ? "; --bounds gives the least and the greatest length of each generation" : ""));
}

int growth(const Options& options) {
    const Budget budget = options.bounds.budget();
    if (!options.sequence.empty()) return growth_realise(options.sequence, options.json, budget);
    if (options.file.empty()) throw Error("expected FILE, or --realise with a sequence; `algae growth --help` shows examples");
    const LSystem system = open_system(options.file, budget);
    if (options.words) return growth_words(system, options.json, budget);
    if (options.bounds_wanted) return print_bounds(system, options, budget);
    if (const View<IL> context = as_il(system); context && !as_ol(system) && options.plot.empty())
        return growth_interaction(*context, range("-n", options.generation.empty() ? "0..100" : options.generation),
                                  options.json, budget);
    const D0L rules = with_growth_function(system);
    if (!options.plot.empty()) {
        const auto [first, last] = range("-n", options.generation.empty() ? "0..20" : options.generation);
        draw_plot(growth_plot(rules, first, last, budget), options.plot, budget);
        return success;
    }
    if (options.counts) return print_counts(system, rules, options, budget);
    if (!options.generation.empty()) return print_lengths(rules, options, budget);
    const GrowthAnalysis analysis = growth_analysis(rules, budget);
    print(options.json ? growth_json(rules, analysis).dump(2) + "\n" : growth_page(rules, analysis));
    return success;
}

}  // namespace

void add_growth(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "growth", "How the words of a D0L system grow: recurrence, closed form, class",
                              "  algae growth koch\n"
                              "  algae growth my.lsys -n 0..6 --json\n"
                              "  algae growth dragon --plot growth.pdf\n"
                              "  algae growth plant-f --words\n"
                              "  algae growth --realise \"n^2+1\"",
                              options, growth);
    verb.add_option("FILE", options->file, file_help)->type_name(file_type);
    verb.add_option("-n", options->generation, "only the exact length of a generation, or of a range such as 0..6")->type_name("N[..M]");
    verb.add_flag("--counts", options->counts, "with -n: how often each letter occurs, and how many segments are drawn");
    verb.add_flag("--bounds", options->bounds_wanted, "the least and greatest lengths of an 0L system, for -n (default 0..10)");
    verb.add_option("--plot", options->plot, "draw length against n, for -n (default 0..20): .svg, .pdf, .png, .ps or .eps")->type_name("FILE");
    verb.add_flag("--words", options->words, "factors and their complexity class, pushiness, repetitions, locally catenative formulas");
    verb.add_option("--realise", options->sequence,
                    "instead of FILE: a D0L system with these lengths, as terms \"1,1,2,3,5,8\", a recurrence "
                    "\"a(n) = a(n-1) + a(n-2); 1, 1\" or a polynomial \"n^2+1\"")->type_name("SEQUENCE");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
