#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/derive_options.hpp"
#include "cli/environment_option.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "environment/open_development.hpp"
#include "rewrite/expectation.hpp"
#include "rewrite/module_text.hpp"
#include "rewrite/rewriting.hpp"
#include "rewrite/terminal_words.hpp"
#include "system/classes.hpp"

namespace algae::cli {

namespace {

constexpr std::uint64_t usual_seed = 1;

RewritingChoices choices(const DeriveOptions& options, const LSystem& system) {
    RewritingChoices out;
    out.seed = options.seed.empty() ? usual_seed : natural("--seed", options.seed);
    // A seed says that rules without probabilities may be picked too.
    const bool seeded = !options.seed.empty() || !options.seeds.empty();
    out.evenly = !class_of(system).stochastic && seeded;
    out.random_tables = seeded;
    return out;
}

std::uint64_t one_generation(const DeriveOptions& options, const std::string& option) {
    if (options.generation.empty()) throw Error("-n is missing: which generation?");
    if (options.all || options.generation.find("..") != std::string::npos)
        throw Error(option + " needs one generation");
    return natural("-n", options.generation);
}

std::vector<std::size_t> tables(const DeriveOptions& options, const LSystem& system) {
    if (options.tables.empty()) {
        if (leaves_tables_open(system) && options.seed.empty() && options.seeds.empty())
            throw Error("it has " + std::to_string(system.tables.size()) +
                        " tables and no schedule; say --tables SEQUENCE, or --seed S for random ones");
        return {};
    }
    return table_sequence(system.tables, options.tables);
}

/// The word of one generation after the other.
class Generations {
public:
    Generations(const LSystem& system, const RewritingChoices& choices, const std::string& program,
                std::vector<std::size_t> sequence, const Budget& budget)
        : development_(system, choices, external_environment(program, system), budget),
          text_(development_.rules().system->alphabet, development_.rules().kinds),
          sequence_(std::move(sequence)),
          budget_(budget) {}

    bool write(std::uint64_t n, TextSink& sink) {
        development_.go_to(n, sequence_, budget_);
        return text_.write(development_.word(), sink, budget_);
    }

private:
    OpenDevelopment development_;
    ModuleText text_;
    std::vector<std::size_t> sequence_;
    const Budget& budget_;
};

void check_long_enough(const std::vector<std::size_t>& sequence, std::uint64_t n) {
    if (!sequence.empty() && sequence.size() < n)
        throw Error("--tables: expected a table for each of " + std::to_string(n) +
                    " steps, found " + std::to_string(sequence.size()));
}

}  // namespace

void derive_modules(const DeriveOptions& options, const LSystem& system, const Budget& budget) {
    const auto sequence = tables(options, system);
    if (!options.seeds.empty()) {
        const std::uint64_t n = one_generation(options, "--seeds");
        check_long_enough(sequence, n);
        const auto [first, last] = range("--seeds", options.seeds);
        print_lines(options.json, first, last, [&](std::uint64_t seed, TextSink& sink) {
            RewritingChoices own = choices(options, system);
            own.seed = seed;
            return Generations(system, own, options.environment, sequence, budget).write(n, sink);
        });
        return;
    }
    const auto [from, last] = options.generation.empty() ? std::pair<std::uint64_t, std::uint64_t>(
                                                               sequence.size(), sequence.size())
                                                         : range("-n", options.generation);
    check_long_enough(sequence, last);
    Generations generations(system, choices(options, system), options.environment, sequence, budget);
    print_lines(options.json, options.all ? 0 : from, last,
                [&](std::uint64_t n, TextSink& sink) { return generations.write(n, sink); });
}

void derive_distribution(const DeriveOptions& options, const LSystem& system,
                         const Budget& budget) {
    if (class_of(system).open)
        throw Error("it has communication modules, and --distribution asks no environment");
    const std::uint64_t n = one_generation(options, "--distribution");
    if (leaves_tables_open(system) && options.tables.empty())
        throw Error("it has tables and no schedule; say --tables SEQUENCE");
    const auto sequence = tables(options, system);
    check_long_enough(sequence, n);
    const Rewriting rewriting(system, choices(options, system), budget);
    const ModuleText text(rewriting.rules().system->alphabet, rewriting.rules().kinds);
    nlohmann::json words = nlohmann::json::array();
    for (const LikelyWord& likely : distribution(rewriting, n, sequence, budget)) {
        const std::string word = text.text(likely.word),
                          probability = to_string(likely.probability);
        if (options.json)
            words.push_back({{"word", word}, {"probability", probability}});
        else
            print(probability + "  " + word + '\n');
    }
    if (options.json) print(nlohmann::json({{"words", words}}).dump(2) + "\n");
}

void derive_expected(const DeriveOptions& options, const LSystem& system, const Budget& budget) {
    const std::uint64_t n = one_generation(options, "--expected");
    const View<S0L> rules = as_s0l(system);
    const std::vector<Rational> counts = expected_counts(*rules, n, budget);
    Rational length;
    nlohmann::json letters = nlohmann::json::object();
    std::string text;
    for (Symbol a = 0; a < counts.size(); ++a) {
        length += counts[a];
        letters[system.alphabet.name(a)] = to_string(counts[a]);
        text += system.alphabet.name(a) + "  " + to_string(counts[a]) + "  " +
                decimal(counts[a], 6) + '\n';
    }
    if (options.json)
        print(nlohmann::json({{"letters", letters}, {"length", to_string(length)}}).dump(2) + "\n");
    else
        print(text + "length  " + to_string(length) + "  " + decimal(length, 6) + '\n');
}

void derive_language(const DeriveOptions& options, const LSystem& system, const Budget& budget) {
    const std::uint64_t n = one_generation(options, "--language");
    const auto longest = options.longest.empty()
                             ? std::nullopt
                             : std::optional<std::size_t>(natural("--longest", options.longest));
    print_words(options.json, system.alphabet,
                terminal_words(*as_et0l(system), n, longest, budget));
}

}  // namespace algae::cli
