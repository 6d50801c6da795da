// `algae growth`: how long the words of a system become, and what else its rules say about them.
//
// The full analysis rests on the growth matrix of a D0L system: its characteristic polynomial gives the
// recurrence of the lengths, the generating function, the closed form and the class, all exact; decimals on
// the page are digits of exact numbers. Without a matrix there is less to say, and the page says so: systems with
// context have lengths that were derived and no formula; an 0L system has a least and
// a greatest length for each generation. `--words` analyses factors instead of lengths, `--realise` finds
// a system for given lengths.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "exchange/exchange.hpp"
#include "growth/growth.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "report/report.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"

namespace algae::command {

namespace {

struct Options {
    std::string file, plot, sequence;
    std::vector<std::string> let;
    std::optional<Range> generation;
    bool bounds_wanted = false, words = false, counts = false, json = false, b_file = false,
         latex = false;
    Bounds bounds;

    /// The generations asked for, or the usual ones.
    Range generations(const char* usual) const {
        return generation ? *generation : range("-n", usual);
    }
};

// Systems with interactions.

/// What is proved of all lengths, in words; empty if nothing is.
std::string beyond_lengths(const ContextGrowth& known) {
    if (known.repetition) {
        const auto& [preperiod, period] = *known.repetition;
        const std::string since = "from generation " + std::to_string(preperiod) + " on the word ";
        return "But the words repeat: " +
               (period == 1 ? since + "stays the same"
                            : since + "is that of " + to_string(period) + " steps before") +
               ", so the lengths are bounded.\n";
    }
    if (known.rises_from)
        return "But from generation " + std::to_string(*known.rises_from) +
               " on every word is longer than the one before: an automaton accepts all these "
               "words, and "
               "every step makes what it accepts longer.\n";
    if (known.endless)
        return "But no word comes twice, so the lengths have no bound: an automaton accepts all "
               "words, and every "
               "step raises the sum of weights along its transitions.\n";
    return {};
}

/// Lengths that are derived one generation after the other: there is no matrix, and no formula is fitted. What is known beyond
/// them is that words repeat, or never do.
int growth_interaction(const IL& system, const Range& generations, bool json,
                       const Budget& budget) {
    auto lengths = derived_lengths(system, generations.last, budget);
    lengths.erase(lengths.begin(),
                  lengths.begin() + static_cast<std::ptrdiff_t>(generations.first));
    const ContextGrowth known = system.brackets ? ContextGrowth{} : context_growth(system, budget);
    const std::string beyond = beyond_lengths(known);
    if (json) {
        Json all{{"class", known.repetition ? "bounded"
                           : beyond.empty() ? "unknown"
                                            : "unbounded"},
                 {"from", generations.first},
                 {"lengths", lengths}};
        if (known.repetition)
            all.set("preperiod", known.repetition->preperiod)
                .set("period", known.repetition->period);
        if (known.rises_from) all.set("rises_from", *known.rises_from);
        print(all.text());
    } else {
        print(
            fmt::format("lengths, n = {}..{}\n{}\n"
                        "Letters look at their neighbours, so there is no growth matrix and no "
                        "recurrence to go by:\n"
                        "these lengths are derived{}.\n{}",
                        generations.first, generations.last, fmt::join(lengths, ", "),
                        beyond.empty() ? ", and nothing is claimed beyond them" : "", beyond));
    }
    return success;
}

/// Lengths of the words of one generation.
struct WordsOfGeneration {
    std::uint64_t generation = 0, least = 0, greatest = 0, words = 0;
};

/// A system with context and choices has many words of each generation: all of them are derived, as long as they are few. Whether
/// their lengths have a bound is whether the language is finite, which is decided as a claim.
int growth_of_choices(const Model& model, const IL& system, const Range& generations, bool is_asked,
                      bool json, const Budget& budget) {
    constexpr std::uint64_t most_letters = 2'000'000;  // of the words of one generation
    ContextStep step(system);
    std::set<Word> words{system.axiom};
    std::vector<WordsOfGeneration> found;
    bool is_cut = false;
    for (std::uint64_t n = 0; n <= generations.last; ++n) {
        if (n > 0) {
            std::set<Word> next;
            std::uint64_t letters = 0;
            for (const Word& word : words) {
                Budget rest = budget;
                rest.memory = std::min<std::uint64_t>(budget.memory, std::uint64_t{1} << 28);
                try {
                    for (Word& one : step.next(word, std::nullopt, rest))
                        if (const std::size_t size = one.size(); next.insert(std::move(one)).second)
                            letters += size + 1;
                } catch (const BoundReached& bound) {
                    if (bound.bound() != Bound::memory) throw;
                    letters = most_letters + 1;
                }
                if (letters > most_letters) break;
            }
            if (letters > most_letters) {
                if (is_asked)
                    throw BoundReached(Bound::letters,
                                       "the words of generation " + std::to_string(n) +
                                           " have more than " + std::to_string(most_letters) +
                                           " letters together: -n 0.." + std::to_string(n - 1) +
                                           " has those before");
                is_cut = true;
                break;
            }
            words = std::move(next);
        }
        if (n < generations.first) continue;
        WordsOfGeneration& one = found.emplace_back();
        one.generation = n;
        one.words = words.size();
        one.least = words.empty() ? 0 : words.begin()->size();
        for (const Word& word : words) {
            one.least = std::min<std::uint64_t>(one.least, word.size());
            one.greatest = std::max<std::uint64_t>(one.greatest, word.size());
        }
    }
    const Claim claim =
        read_claim("claim T\nlet A = IL A\n", "growth", [&](const std::string&) { return model; });
    const Statement is_finite{IsFinite{generated_language(claim.systems.front())}};
    const Answer answer = decide(is_finite, claim, budget);
    const std::vector<std::string> argument = sentences(answer, *claim.alphabet);
    const std::string kind = answer.truth == Truth::proved    ? "bounded"
                             : answer.truth == Truth::refuted ? "unbounded"
                                                              : "unknown";
    if (json) {
        Json rows = Json::array();
        for (const WordsOfGeneration& one : found)
            rows.add({{"generation", one.generation},
                      {"least", one.least},
                      {"greatest", one.greatest},
                      {"words", one.words}});
        print(Json{{"class", kind},
                   {"generations", std::move(rows)},
                   {"complete", !is_cut},
                   {"argument", argument}}
                  .text());
        return success;
    }
    std::string text = "least and greatest lengths, and how many words:\n";
    for (const WordsOfGeneration& one : found)
        text += fmt::format("n = {}: {}..{}, {}\n", one.generation, one.least, one.greatest,
                            counted(one.words, "word"));
    if (is_cut) text += "The words of the next generation are too many to derive them all.\n";
    text +=
        "Letters look at their neighbours and choose, so there is no growth matrix: these words "
        "are derived.\n";
    text += kind == "bounded"     ? "Lengths are bounded: "
            : kind == "unbounded" ? "Lengths have no bound: "
                                  : "Whether lengths are bounded is not decided: ";
    for (std::size_t i = 0; i < argument.size(); ++i) text += argument[i] + '\n';
    print(text);
    return success;
}

// Systems for a sequence of lengths.

/// The system as the text of a file.
std::string text_of(const D0L& rules, const std::string& title) {
    Model system;
    system.title = title;
    system.alphabet = *rules.alphabet;
    system.axiom.letters = rules.axiom;
    for (const Symbol a : rules.letters) {
        Production rule;
        rule.predecessor.symbol = a;
        rule.successor.letters = rules.successor(a);
        system.rules.push_back(std::move(rule));
    }
    return print_lsystem(system);
}

/// "lengths 1, 1, 2, 3, 5, 8, ..."
std::string title_of(const SequenceSpecification& sequence) {
    std::string title = "lengths ";
    for (const Rational& value : sequence.values(6)) title += to_string(value) + ", ";
    return title + "...";
}

/// How well the terms determine the recurrence, if the sequence was given by terms.
std::string rests_on(const SequenceSpecification& sequence) {
    const std::size_t needed = 2 * sequence.initial.size();
    if (sequence.terms == 0) return "";
    return fmt::format(
        "the shortest recurrence of the {} terms, {}", sequence.terms,
        sequence.terms < needed ? fmt::format("of which {} would determine it", needed)
        : sequence.terms > needed
            ? fmt::format("{} determine it, {} confirm it", needed, sequence.terms - needed)
            : "which determine it and leave none to confirm it");
}

/// The sequence of a b-file: the recurrence of its first terms, which all the others must obey. Throws Error where they do not.
SequenceSpecification of_b_file(const std::string& path, const Budget& budget) {
    constexpr std::size_t most = 120;  // terms that the recurrence is found from
    const BFile file = read_b_file(file_text(path, budget), path);
    std::vector<Rational> terms;
    for (const Integer& term : file.terms) terms.emplace_back(term);
    const std::vector<Rational> first(
        terms.begin(), terms.begin() + static_cast<std::ptrdiff_t>(std::min(most, terms.size())));
    SequenceSpecification sequence = recurrence_of_terms(first);
    const std::vector<Rational> values = sequence.values(terms.size());
    for (std::size_t i = 0; i < terms.size(); ++i)
        if (values.at(i) != terms[i])
            throw Error(path + ": no linear recurrence of order up to " + std::to_string(most / 2) +
                        ": that of the first " + std::to_string(first.size()) +
                        " terms differs at n = " + to_string(file.first + Integer(i)));
    sequence.terms = terms.size();
    return sequence;
}

int growth_realise(const std::string& specification, bool json, const Budget& budget) {
    std::error_code ignored;
    const SequenceSpecification sequence = std::filesystem::is_regular_file(specification, ignored)
                                               ? of_b_file(specification, budget)
                                               : read_specification(specification);
    const Realisation result = realise(sequence, budget);
    const std::string rests = rests_on(sequence);
    const std::string shift = result.shift == 0 ? "" : "+" + std::to_string(result.shift);
    std::string system;
    if (result.system) system = text_of(*result.system, title_of(shifted(sequence, result.shift)));
    if (json) {
        static const char* const verdicts[] = {"found", "impossible", "unknown"};
        Json all{{"because", result.because}};  // keys in alphabetical order
        if (result.system) all.set("compared", result.compared);
        all.set("sequence", sequence.text());
        if (result.system) all.set("shift", result.shift).set("system", system);
        all.set("terms", sequence.terms);
        all.set("verdict", verdicts[static_cast<std::size_t>(result.kind)]);
        print(all.text());
    } else {
        std::string text = "# " + sequence.text() + "\n";
        if (!rests.empty()) text += "# " + rests + "\n";
        if (result.kind == Realisation::Kind::impossible)
            text += "# there is no D0L system with these lengths: ";
        if (result.kind == Realisation::Kind::not_known) text += "# not known: ";
        text += (result.kind == Realisation::Kind::found ? "# " : "") + result.because + "\n";
        if (result.shift != 0)
            text += fmt::format(
                "# the lengths of the following are a(n{}), equal on {} terms, which proves it\n",
                shift, result.compared);
        print(text + system);
    }
    return result.kind == Realisation::Kind::found        ? success
           : result.kind == Realisation::Kind::impossible ? refuted
                                                          : undecided;
}

// The verb.

/// The exact lengths only.
int print_lengths(const D0L& system, const Options& options, const Budget& budget) {
    const auto& [first, last, written] = *options.generation;
    std::string text;
    Json found = Json::array();
    std::vector<Integer> lengths;
    for (std::uint64_t n = first; n <= last; ++n) {
        const Integer letters = length(system, n, budget);
        lengths.push_back(letters);
        if (options.json)
            found.add(letters);
        else
            text += to_string(letters) + '\n';
    }
    if (options.b_file) text = print_b_file({Integer(first), lengths});
    print(options.json ? Json{{"lengths", found}}.text() : text);
    return success;
}

/// Lengths, how often each letter occurs, and how many segments are drawn.
int print_counts(const Model& system, const D0L& rules, const Options& options,
                 const Budget& budget) {
    if (!options.generation) throw Error("--counts needs a generation: -n");
    const Commands commands(system, rules.letters);
    const auto& [first, last, written] = *options.generation;
    std::string text;
    Json generations = Json::array();
    for (std::uint64_t n = first; n <= last; ++n) {
        const auto counts = parikh_vector(rules, n, budget);
        Integer sum = 0;
        Json letters;
        std::string listed;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            sum += counts[i];
            const std::string& name = system.alphabet.name(rules.letters[i]);
            letters.set(name, counts[i]);
            listed += "  " + name + ' ' + to_string(counts[i]);
        }
        const Integer segments = drawn_segments(commands, rules.letters, counts);
        generations.add(
            {{"generation", n}, {"length", sum}, {"segments", segments}, {"letters", letters}});
        text += "n = " + std::to_string(n) + ": length " + to_string(sum) + ", segments " +
                to_string(segments) + ", letters" + listed + '\n';
    }
    print(options.json ? Json{{"generations", generations}}.text() : text);
    return success;
}

int print_bounds(const LSystem& system, const Options& options, const Budget& budget) {
    const View<OL> rules = as_ol(system);
    const auto [first, last, written] = options.generations("0..10");
    const LengthBoundsReport report{*rules, length_bounds(*rules, last, budget), first};
    print_report(report, options.json);
    return success;
}

/// A system without a growth function says why, and what to ask instead.
D0L with_growth_function(const LSystem& system) {
    View<D0L> rules = as_d0l(system);
    if (rules) return *rules;
    const View<IL> interactive = as_dil(system);
    const bool has_choices = !interactive && as_il(system) && !as_ol(system);
    throw Error("no growth function: " + (has_choices ? interactive.reason() : rules.reason()) +
                (as_ol(system)
                     ? "; --bounds gives the least and the greatest length of each generation"
                     : ""));
}

int growth(const Options& options) {
    const Budget budget = options.bounds.budget();
    if (!options.sequence.empty()) {
        if (!options.file.empty())
            throw Error("--realise stands instead of FILE, found both: \"" + options.file + '"');
        refuse_with("--realise", {{"--let", !options.let.empty()},
                                  {"-n", options.generation.has_value()},
                                  {"--counts", options.counts},
                                  {"--bounds", options.bounds_wanted},
                                  {"--words", options.words},
                                  {"--plot", !options.plot.empty()},
                                  {"--latex", options.latex}});
        return growth_realise(options.sequence, options.json, budget);
    }
    if (options.file.empty())
        throw Error(
            "expected FILE, or --realise with a sequence; `algae growth --help` shows examples");
    const Model system = open_model(options.file, budget, options.let);
    if (options.latex)
        refuse_with("--latex", {{"-n", options.generation.has_value()},
                                {"--words", options.words},
                                {"--counts", options.counts},
                                {"--bounds", options.bounds_wanted},
                                {"--plot", !options.plot.empty()}});
    if (options.words) {
        refuse_with("--words", {{"-n (`algae words --to N` has factors of N letters)",
                                 options.generation.has_value()},
                                {"--counts", options.counts},
                                {"--b-file", options.b_file},
                                {"--bounds", options.bounds_wanted},
                                {"--plot", !options.plot.empty()}});
        if (!system.coding.empty())
            throw Error(options.file +
                        ": expected a system without a coding for --words, found one with a "
                        "coding; `algae words " +
                        options.file + "` counts the factors after it");
        const FactorReport report = factor_report(*as_d0l(system), budget);
        print_report(report, options.json);
        return report.order.is_decided() ? success : undecided;
    }
    if (options.bounds_wanted) return print_bounds(system, options, budget);
    if (const View<IL> context = as_dil(system); context && !as_ol(system) && options.plot.empty())
        return growth_interaction(*context, options.generations("0..100"), options.json, budget);
    if (const View<IL> choices = as_il(system); choices && !as_ol(system) && options.plot.empty() &&
                                                !options.counts && !options.b_file &&
                                                !options.latex)
        return growth_of_choices(system, *choices, options.generations("0..10"),
                                 options.generation.has_value(), options.json, budget);
    const D0L rules = with_growth_function(system);
    if (!options.plot.empty()) {
        const auto [first, last, written] = options.generations("0..20");
        draw_plot(growth_plot(rules, first, last, budget), options.plot, budget);
        return success;
    }
    if (options.counts) return print_counts(system, rules, options, budget);
    if (options.generation) return print_lengths(rules, options, budget);
    const GrowthReport report{rules, growth_analysis(rules, budget)};
    if (options.latex) {
        print(to_latex(report));
        return success;
    }
    print(options.json ? to_json(report).text() : to_text(report, ", all in --json"));
    return success;
}

}  // namespace

void add_growth(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("growth", "How the words of a D0L system grow: recurrence, closed form, class",
                  {"algae growth koch", "algae growth my.lsys -n 0..6 --json",
                   "algae growth dragon --plot growth.pdf", "algae growth plant-f --words",
                   "algae growth --realise \"n^2+1\""},
                  growth);
    verb.option("FILE", options.file, file_type, file_help);
    add_let_option(verb, options.let);
    verb.option("-n", options.generation, range, "N[..M]",
                "only the exact length of a generation, or of a range such as 0..6");
    verb.flag("--counts", options.counts,
              "with -n: how often each letter occurs, and how many segments are drawn");
    verb.flag("--bounds", options.bounds_wanted,
              "the least and greatest lengths of an 0L system, for -n (default 0..10)");
    verb.output(
        "--plot", options.plot, "FILE",
        "draw length against n, for -n (default 0..20): .svg, .pdf, .png, .ps, .eps or .html");
    verb.flag(
        "--words", options.words,
        "factors and their complexity class, pushiness, repetitions, locally catenative formulas");
    verb.option(
        "--realise", options.sequence, "SEQUENCE",
        "instead of FILE: a D0L system with these lengths, as terms \"1,1,2,3,5,8\", a "
        "recurrence \"a(n) = a(n-1) + a(n-2); 1, 1\", a polynomial \"n^2+1\", or the name of a "
        "b-file of the OEIS");
    verb.flag("--b-file", options.b_file, "with -n: lines `n length`, a b-file of the OEIS")
        .needs = {"-n"};
    verb.json_flag(options.json);
    verb.latex_flag(options.latex,
                    "print matrix, polynomials, recurrence, generating function, closed form and "
                    "class as LaTeX, which needs amsmath");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
