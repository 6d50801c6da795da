#include <nlohmann/json.hpp>
#include <random>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "fold/choices.hpp"
#include "fold/derive.hpp"
#include "fold/interaction.hpp"
#include "growth/incidence.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file, generation, seed, longest;
    bool all = false, all_words = false, json = false;
    Bounds bounds;
};

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
    throw BoundReached("generation " + std::to_string(n) + " has " + count + " letters, more than the " +
                       std::to_string(budget.letters) + " that --max-letters allows. `algae letter -n " +
                       std::to_string(n) + " --at P` gives any part of it, `algae growth -n " +
                       std::to_string(n) + "` its length, `algae draw -n " + std::to_string(n) + "` its picture");
}

std::string spelled(const Alphabet& alphabet, const Word& word) { return spell(alphabet, word); }

void print_words(const Options& options, const Alphabet& alphabet, const std::vector<Word>& words) {
    if (options.json) {
        nlohmann::json out;
        out["words"] = nlohmann::json::array();
        for (const Word& word : words) out["words"].push_back(spelled(alphabet, word));
        print(out.dump(2) + "\n");
        return;
    }
    std::string text;
    for (const Word& word : words) {
        text += spelled(alphabet, word) + '\n';
        if (text.size() > (std::size_t{1} << 20)) {
            print(text);
            text.clear();
        }
    }
    print(text);
}

/// Prints a line for each generation; write(n, sink) sends the word of generation n as derive_text
/// does.
template <class Write>
void print_generations(const Options& options, std::uint64_t first, std::uint64_t last, Write write) {
    // Words may be larger than memory: the JSON around them is written by hand.
    StandardOutput output;
    JsonString json(output);
    TextSink& sink = options.json ? static_cast<TextSink&>(json) : output;
    if (options.json) print("{\n  \"words\": [\n");
    for (std::uint64_t n = first; n <= last; ++n) {
        if (options.json) print("    \"");
        if (!write(n, sink)) print("ε");
        print(options.json ? (n < last ? "\",\n" : "\"\n") : "\n");
    }
    if (options.json) print("  ]\n}\n");
}

void print_generations(const Options& options, const D0L& system, std::uint64_t first, std::uint64_t last,
                       const Budget& budget) {
    check_length(system, last, budget);
    if (first != last)
        for (std::uint64_t n = first; n < last; ++n) check_length(system, n, budget);
    print_generations(options, first, last, [&](std::uint64_t n, TextSink& sink) {
        return derive_text(system, n, sink, budget);
    });
}

void print_generations(const Options& options, const IL& system, std::uint64_t first, std::uint64_t last,
                       const Budget& budget) {
    Development development(system, budget);
    development.steps(first);
    print_generations(options, first, last, [&](std::uint64_t n, TextSink& sink) {
        development.steps(n - development.generation());
        if (development.length() == 0) return false;
        const std::string text = spell(*system.alphabet, development.word());  // until flush
        sink.write(text);
        sink.flush();
        return true;
    });
}

int derive_verb(const Options& options) {
    const Budget budget = options.bounds.budget();
    const LSystem system = open_system(options.file, budget);
    const auto longest = options.longest.empty() ? std::nullopt
                                                 : std::optional<std::size_t>(natural("--longest", options.longest));
    if (options.all_words) {
        const View<OL> rules = as_ol(system);
        if (options.generation.empty() && !longest)
            throw Error("--all-words needs a generation (-n) or a greatest length (--longest)");
        if (options.generation.empty())
            print_words(options, system.alphabet, words_up_to(*rules, *longest, budget));
        else
            print_words(options, system.alphabet,
                        words_of_generation(*rules, natural("-n", options.generation), longest, budget));
        return success;
    }
    if (longest) throw Error("--longest goes with --all-words");
    if (options.generation.empty()) throw Error("-n is missing: which generation?");
    const auto [from, last] = range("-n", options.generation);
    const std::uint64_t first = options.all ? 0 : from;
    if (!options.seed.empty()) {
        const View<OL> rules = as_ol(system);
        std::mt19937_64 generator(natural("--seed", options.seed));
        std::vector<Word> words;
        for (std::uint64_t n = first; n <= last; ++n) {
            std::mt19937_64 same = generator;  // every generation of one development
            words.push_back(random_word(*rules, n, same, budget));
        }
        print_words(options, system.alphabet, words);
        return success;
    }
    if (!as_ol(system)) {
        const View<IL> interactive = as_il(system);
        if (!interactive)
            throw Error("algae derives 0L systems and deterministic systems with context, and this is " +
                        interactive.reason());
        print_generations(options, *interactive, first, last, budget);
        return success;
    }
    const View<D0L> rules = as_d0l(system);
    if (!rules)
        throw Error(rules.reason() + "; say --all-words for all words, or --seed S for one picked at random");
    print_generations(options, *rules, first, last, budget);
    return success;
}

}  // namespace

void add_derive(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "derive", "The word of a generation",
                              "  algae derive koch -n 3\n  algae derive signal.lsys -n 0..5\n"
                              "  algae derive my.lsys -n 4 --all-words --longest 10", options,
                              derive_verb);
    verb.add_option("FILE", options->file, file_help)->required();
    verb.add_option("-n", options->generation, "the generation, or a range such as 0..6")->type_name("N");
    verb.add_flag("--all", options->all, "all generations from 0 on, a line each");
    verb.add_flag("--all-words", options->all_words, "every word of the generation, in shortlex order (0L systems)");
    verb.add_option("--longest", options->longest,
                    "with --all-words: words of at most M letters; without -n, of the whole language")
        ->type_name("M");
    verb.add_option("--seed", options->seed, "pick one word of a nondeterministic system at random")->type_name("S");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
