#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/derive_boxes.hpp"
#include "cli/derive_options.hpp"
#include "cli/environment_option.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "fold/choices.hpp"
#include "fold/derive.hpp"
#include "fold/interaction.hpp"
#include "growth/incidence.hpp"
#include "system/classes.hpp"

namespace algae::cli {

namespace {

/// Throws BoundReached, with the exact length and other ways to an answer, if a word is too long.
void check_length(const D0L& system, std::uint64_t n, const Budget& budget) {
    constexpr double worked_out = 4096;  // binary digits of a length that are said in full
    const double estimate = estimated_log2_length(system, n, budget);
    std::string count;
    if (estimate <= worked_out) {
        const Integer letters = length(system, n, budget);
        if (letters <= Integer(budget.letters)) return;
        count = readable(letters);
    } else {
        count = "about 10^" + std::to_string(static_cast<std::uint64_t>(estimate * 0.30102999566398120));
    }
    throw BoundReached(Bound::letters,
                       "generation " + std::to_string(n) + " has " + count +
                           " letters, more than the " + std::to_string(budget.letters) +
                           " that --max-letters allows. `algae letter -n " + std::to_string(n) +
                           " --at P` gives any part of it, `algae growth -n " + std::to_string(n) +
                           "` its length, `algae draw -n " + std::to_string(n) + "` its picture");
}

}  // namespace

void print_words(bool json, const Alphabet& alphabet, const std::vector<Word>& words) {
    if (json) {
        nlohmann::json out;
        out["words"] = nlohmann::json::array();
        for (const Word& word : words) out["words"].push_back(spell(alphabet, word));
        print(out.dump(2) + "\n");
        return;
    }
    std::string text;
    for (const Word& word : words) {
        text += spell(alphabet, word) + '\n';
        if (text.size() > (std::size_t{1} << 20)) {
            print(text);
            text.clear();
        }
    }
    print(text);
}

void print_lines(bool json, std::uint64_t first, std::uint64_t last,
                 const std::function<bool(std::uint64_t, TextSink&)>& write) {
    // Words may be larger than memory: the JSON around them is written by hand.
    StandardOutput output;
    JsonString inside(output);
    TextSink& sink = json ? static_cast<TextSink&>(inside) : output;
    if (json) print("{\n  \"words\": [\n");
    for (std::uint64_t n = first; n <= last; ++n) {
        if (json) print("    \"");
        if (!write(n, sink)) print("ε");
        print(json ? (n < last ? "\",\n" : "\"\n") : "\n");
    }
    if (json) print("  ]\n}\n");
}

namespace {

void print_generations(const DeriveOptions& options, const D0L& system, std::uint64_t first, std::uint64_t last,
                       const Budget& budget) {
    check_length(system, last, budget);
    if (first != last)
        for (std::uint64_t n = first; n < last; ++n) check_length(system, n, budget);
    print_lines(options.json, first, last, [&](std::uint64_t n, TextSink& sink) {
        return derive_text(system, n, sink, budget);
    });
}

void print_generations(const DeriveOptions& options, const IL& system, std::uint64_t first, std::uint64_t last,
                       const Budget& budget) {
    Development development(system, budget);
    development.steps(first);
    print_lines(options.json, first, last, [&](std::uint64_t n, TextSink& sink) {
        development.steps(n - development.generation());
        if (development.length() == 0) return false;
        const std::string text = spell(*system.alphabet, development.word());  // until flush
        sink.write(text);
        sink.flush();
        return true;
    });
}

void derive_shapes(const DeriveOptions& options, const LSystem& system, const Budget& budget) {
    const bool words = options.all_words || options.language || options.distribution || options.expected ||
                       !options.seed.empty() || !options.seeds.empty() || !options.tables.empty() || !options.longest.empty();
    if (words) throw Error("a system of shape rules derives boxes; derive takes -n, --all and --json for it");
    if (options.generation.empty()) throw Error("-n is missing: which generation?");
    const auto [first, last] = range("-n", options.generation);
    derive_boxes(system, options.all ? 0 : first, last, options.json, budget);
}

void derive_all_words(const DeriveOptions& options, const LSystem& system, const Budget& budget) {
    const auto longest = options.longest.empty() ? std::nullopt
                                                 : std::optional<std::size_t>(natural("--longest", options.longest));
    const View<OL> rules = as_ol(system);
    if (options.generation.empty() && !longest)
        throw Error("--all-words needs a generation (-n) or a greatest length (--longest)");
    print_words(options.json, system.alphabet,
                options.generation.empty()
                    ? words_up_to(*rules, *longest, budget)
                    : words_of_generation(*rules, natural("-n", options.generation), longest, budget));
}

int derive_verb(const DeriveOptions& options) {
    const Budget budget = options.bounds.budget();
    const LSystem system = open_system(options.file, budget);
    if (class_of(system).shape) {
        derive_shapes(options, system, budget);
        return success;
    }
    if (!options.longest.empty() && !options.all_words && !options.language)
        throw Error("--longest goes with --all-words or --language");
    if (options.all_words) derive_all_words(options, system, budget);
    else if (options.language) derive_language(options, system, budget);
    else if (options.distribution) derive_distribution(options, system, budget);
    else if (options.expected) derive_expected(options, system, budget);
    if (options.all_words || options.language || options.distribution || options.expected) return success;
    if (options.generation.empty() && options.tables.empty()) throw Error("-n is missing: which generation?");
    const bool picked = !options.seed.empty() || !options.seeds.empty() || !options.tables.empty();
    if (!options.environment.empty() || class_of(system).open) {
        derive_modules(options, system, budget);
        return success;
    }
    const View<D0L> rules = as_d0l(system);
    if (const View<OL> choices = as_ol(system); !picked && !rules && choices)
        throw Error(rules.reason() + "; say --all-words for all words, or --seed S for one picked at random");
    const View<IL> interactive = as_il(system);
    if (picked || (!rules && !interactive)) {
        derive_modules(options, system, budget);
        return success;
    }
    const auto [from, last] = range("-n", options.generation);
    const std::uint64_t first = options.all ? 0 : from;
    if (rules) print_generations(options, *rules, first, last, budget);
    else print_generations(options, *interactive, first, last, budget);
    return success;
}

}  // namespace

void add_derive(Verbs& verbs) {
    auto options = std::make_shared<DeriveOptions>();
    CLI::App& verb = add_verb(verbs, "derive", "The word of a generation, or its boxes",
                              "  algae derive koch -n 3\n  algae derive signal.lsys -n 0..5\n"
                              "  algae derive my.lsys -n 4 --all-words --longest 10\n"
                              "  algae derive stochastic.lsys -n 6 --seeds 1..9", options,
                              derive_verb);
    verb.add_option("FILE", options->file, file_help)->type_name(file_type)->required();
    verb.add_option("-n", options->generation, "the generation, or a range such as 0..6")->type_name("N");
    verb.add_flag("--all", options->all, "all generations from 0 on, a line each");
    verb.add_flag("--all-words", options->all_words, "every word of the generation, in shortlex order (0L systems)");
    verb.add_flag("--language", options->language, "the words over the terminals of generations up to N, in shortlex order");
    verb.add_option("--longest", options->longest,
                    "with --all-words and --language: words of at most M letters; with --all-words and without -n, of the "
                    "whole language")
        ->type_name("M");
    verb.add_option("--seed", options->seed,
                    "what is picked at random: the same seed, the same word (1 for systems with probabilities)")
        ->type_name("S");
    verb.add_option("--seeds", options->seeds, "a word for each of these seeds, such as 1..9")->type_name("A..B");
    verb.add_option("--tables", options->tables, "the table of each step: light,dark or, of one character each, abab or 1212")
        ->type_name("SEQUENCE");
    add_environment_option(verb, options->environment);
    verb.add_flag("--distribution", options->distribution, "all words of the generation with their exact probabilities");
    verb.add_flag("--expected", options->expected, "the exact expected numbers of letters of the generation");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
