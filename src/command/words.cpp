// `algae words`: combinatorics on words, of one word or of the factors of a D0L system.
//
// What is written is a system if it is a file, a name from the gallery or has an arrow; otherwise it is a word. `--word` and
// `--letters` say that it is a word.

#include <algorithm>
#include <filesystem>

#include "automatic/automatic.hpp"
#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "growth/growth.hpp"
#include "model/model.hpp"
#include "nature/nature.hpp"
#include "notation/notation.hpp"
#include "report/report.hpp"
#include "system/system.hpp"
#include "watch/watch.hpp"

namespace algae::command {

namespace {

struct WordsOptions {
    std::string what, file;
    std::optional<std::string> word, say, count;
    std::string walnut;
    std::optional<AutomatonFormat> as;
    std::vector<std::string> order, let;
    std::optional<std::uint64_t> to;
    bool prove = false, json = false, latex = false;
    Bounds bounds;
};

std::string given_word(const std::string&, const std::string& text) { return text; }

/// A word and the names of its letters, which are numbered in the order of code points, or as --order says.
struct Letters {
    std::vector<std::string> names;
    Word word;
};

Letters in_order(const Word& word, const Alphabet& alphabet,
                 const std::vector<std::string>& order) {
    std::vector<std::string> names;
    for (Symbol letter = 0; letter < alphabet.size(); ++letter)
        names.push_back(alphabet.name(letter));
    Letters found;
    found.names = order;
    if (order.empty()) {
        found.names = names;
        std::ranges::sort(found.names);  // bytes of UTF-8 are in the order of code points
    }
    std::vector<Symbol> numbers(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto at = std::ranges::find(found.names, names[i]);
        if (at == found.names.end())
            throw Error("--order: expected all letters of the word, found none of the name '" +
                        names[i] + "'");
        numbers[i] = static_cast<Symbol>(at - found.names.begin());
    }
    for (std::size_t i = 0; i < order.size(); ++i)
        if (std::ranges::count(order, order[i]) > 1)
            throw Error("--order: expected each letter once, found '" + order[i] + "' again");
    found.word = word;
    for (Symbol& letter : found.word) letter = numbers[letter];
    return found;
}

/// Each character of a text but white space is a letter.
Letters of_characters(const std::string& text, const WordsOptions& options, const Budget& budget) {
    budget.check_memory(text.size() * sizeof(Symbol), "the word");
    Alphabet alphabet;
    Word word;
    word.reserve(text.size());
    std::vector<Symbol> of_byte(128, ~Symbol{0});
    for (std::size_t here = 0; here < text.size();) {
        const auto byte = static_cast<unsigned char>(text[here]);
        if (byte < 128) {
            ++here;
            if (byte <= ' ') continue;
            Symbol& letter = of_byte[byte];
            if (letter == ~Symbol{0})
                letter = alphabet.symbol(std::string(1, static_cast<char>(byte)));
            word.push_back(letter);
            continue;
        }
        const Character next = first_character(std::string_view(text).substr(here));
        if (!next.is_valid())
            throw Error(options.file + ": expected text in UTF-8, found another byte at " +
                        std::to_string(here));
        if (!is_blank(next.code))
            word.push_back(alphabet.symbol(std::string_view(text).substr(here, next.bytes)));
        here += next.bytes;
    }
    return in_order(word, alphabet, options.order);
}

Letters of_text(const std::string& text, const WordsOptions& options) {
    Alphabet alphabet;
    const ModuleWord read = read_word(text, alphabet);
    if (!read.arguments.empty()) throw Error("a word of letters is expected, without parameters");
    return in_order(read.letters, alphabet, options.order);
}

bool is_system(const std::string& what) {
    std::error_code ignored;
    const std::vector<std::string> names = gallery_names();
    return what == "-" || std::filesystem::exists(what, ignored) ||
           std::ranges::count(names, what) > 0 || what.find("->") != std::string::npos;
}

/// The infinite word of a system, after its coding.
AutomaticWord word_of(const Model& model, const D0L& rules) {
    std::optional<LetterCoding> coding;
    if (!model.coding.empty()) coding.emplace(model.alphabet, model.coding);
    return automatic_word(rules, [&](Symbol letter) {
        return coding ? coding->alphabet.name(coding->morphism[letter].front())
                      : model.alphabet.name(letter);
    });
}

/// Says why something was not proved, beside what was said of it before.
void add_reason(FactorValues& report, const std::string& reason) {
    report.not_proved += (report.not_proved.empty() ? "" : "; ") + reason;
}

/// The values up to a length; where there is a time limit, up to shorter ones first, which are kept at the end of the
/// time; `late` says so then.
FactorValues values_to(std::size_t to, const Model& model, const D0L& rules, const Budget& budget,
                       bool& late) {
    constexpr std::size_t few = 8;
    if (!budget.deadline || to <= few) return factor_values(rules, model.coding, to, budget);
    FactorValues report = factor_values(rules, model.coding, few, budget);
    for (std::size_t next = 2 * few; report.to < to; next *= 2) try {
            report = factor_values(rules, model.coding, std::min(next, to), budget);
        } catch (const BoundReached& bound) {
            if (bound.bound() != Bound::time) throw;
            add_reason(report, "factors of more than " + std::to_string(report.to) +
                                   " letters: " + bound.what());
            late = true;
            break;
        }
    return report;
}

/// Adds what can be proved for all lengths, with automata that take little memory unless --prove says otherwise. `late` says
/// that the time is over.
void prove(FactorValues& report, const WordsOptions& options, const Model& model, const D0L& rules,
           Budget budget, bool& late) {
    constexpr std::uint64_t little = std::uint64_t{96} << 20;
    if (!report.infinite_word) {
        add_reason(report,
                   "the factors are those of all words, and not those of one infinite word");
        return;
    }
    if (!options.prove) budget.memory = std::min(budget.memory, little);
    bool is_listed = false;  // what needs large automata
    const auto each = [&](const char* what, auto decide) {
        if (late) return;
        try {
            decide();
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time || bound.bound() == Bound::method) {
                late = bound.bound() == Bound::time;
                is_listed = false;
                add_reason(report, std::string(what) + (late ? " and what comes after: " : ": ") +
                                       bound.what());
                return;
            }
            if (bound.bound() != Bound::memory || options.prove) throw;
            if (is_listed)
                report.not_proved += std::string(", ") + what;
            else
                add_reason(
                    report,
                    std::string("the automata are large, --prove goes on with them: ") + what);
            is_listed = true;
        }
    };
    if (model.coding.empty())
        each("critical exponent by return words", [&] {
            try {
                report.exponent = critical_exponent(rules, budget);
            } catch (const Error&) {  // the first letter does not come back
            }
        });
    const MorphismProperties& morphism = report.morphism;
    constexpr std::size_t few_letters = 4;  // of which the parts of the fractal are quickly found
    if (model.coding.empty() && morphism.pisot && morphism.irreducible &&
        (morphism.determinant == Integer(1) || morphism.determinant == Integer(-1)) &&
        (rules.letters.size() <= few_letters || options.prove))
        each("spectrum", [&] { report.pure_point = rauzy_fractal(rules, budget).tiles; });
    try {
        const AutomaticWord word = word_of(model, rules);
        each(report.for_all ? "palindromic complexity" : "complexities",
             [&] { report.proofs = complexity_proofs(word, budget); });
        if (!report.not_reversed)
            each("closed under reversal", [&] {
                report.closed_under_reversal = has_property(word, "closed under reversal", budget);
            });
        if (!report.exponent)
            each("critical exponent", [&] { report.exponent = critical_exponent(word, budget); });
        if (!report.rich) each("rich", [&] { report.rich = has_property(word, "rich", budget); });
    } catch (const Error& error) {
        if (options.prove) throw;
        add_reason(report, error.what());
    }
}

/// Writes what Walnut has to know of the word into its folder.
int write_for_walnut(const WordsOptions& options, const Model& model, const D0L& rules,
                     const Budget& budget) {
    const auto files = walnut_files(word_of(model, rules), model.name, budget);
    for (const auto& [path, text] : files) {
        const std::filesystem::path whole = std::filesystem::path(options.walnut) / path;
        make_folders(whole.parent_path());
        write_file(whole.string(), text);
        print(whole.string() + "\n");
    }
    return success;
}

/// Decides --say.
int decide(const WordsOptions& options, const Model& model, const D0L& rules,
           const Budget& budget) {
    const AutomaticWord word = word_of(model, rules);
    const FirstOrderStatement statement =
        read_first_order(*options.say, "statement", "T", word.letters);
    WorkCount largest("states of the largest automaton so far:");
    const auto progress = [&](std::size_t states) { largest.at(states); };
    FirstOrderReport report{*options.say, model.name, word, statement.free(),
                            decide_first_order(statement, word, budget, progress)};
    if (options.count) {
        if (std::ranges::count(report.free, *options.count) == 0)
            throw Error(
                "--count: expected a number that no quantifier binds" +
                (report.free.empty() ? std::string() : ", one of " + joined(report.free, ", ")) +
                ", found '" + *options.count + "'");
        if (report.free.size() != 2)
            throw Error(
                "--count: expected a statement with two numbers that no quantifier binds, " +
                std::string("of which one is counted, found ") +
                std::to_string(report.free.size()));
        report.count = counts(report.answer.relation, *options.count, word.numeration);
        report.counted = *options.count;
    }
    if (options.as)
        print(report.count && *options.as == AutomatonFormat::sage
                  ? matrices_text(*report.count)
                  : automaton_text(report, *options.as));
    else
        print(options.json ? to_json(report).text() : to_text(report));
    return report.answer.holds ? success : refuted;
}

int words_of_system(const WordsOptions& options, const Budget& budget) {
    if (options.say && options.latex)
        throw Error(
            "--latex is for values, and --say is answered by numbers and automata; --json has "
            "these for other programs");
    if (options.say && options.to)
        throw Error(
            "--to is for the factors of a system, and --say is for a statement about its word");
    if (!options.say && (options.as || options.count))
        throw Error(std::string(options.as ? "--as" : "--count") +
                    " is for the numbers that make a statement true, which --say gives");
    if (options.as && (options.json || options.latex))
        throw Error("--as, --json and --latex are different forms of one answer; give one of them");
    if (!options.walnut.empty() && (options.say || options.json || options.latex || options.to))
        throw Error(
            "--walnut writes files on the word itself; --say ... --as walnut prints the automaton "
            "of a "
            "statement");
    if (!options.order.empty())
        throw Error("--order is for one word, and " + options.what + " is a system");
    const Model model = open_model(options.what, budget, options.let);
    const View<D0L> rules = as_d0l(model);
    if (!rules)
        throw Error(
            options.what +
            ": expected a D0L system, whose words follow one from another, found one with " +
            std::string(as_dil(model) ? "contexts" : "choices") + "; --word " + options.what +
            " is the word");
    if (options.say) return decide(options, model, *rules, budget);
    if (!options.walnut.empty()) return write_for_walnut(options, model, *rules, budget);
    bool late = false;
    FactorValues report = values_to(options.to.value_or(24), model, *rules, budget, late);
    prove(report, options, model, *rules, budget, late);
    print(options.json    ? to_json(report).text()
          : options.latex ? to_latex(report)
                          : to_text(report));
    return late ? undecided : success;
}

int words(const WordsOptions& options) {
    const Budget budget = options.bounds.budget();
    const int given = !options.what.empty() + !options.file.empty() + options.word.has_value();
    if (given != 1)
        throw Error(given == 0 ? "expected a word, a system, --word WORD or --letters FILE"
                               : "expected one of a word, a system, --word WORD and --letters "
                                 "FILE, found several");
    if (!options.what.empty() && is_system(options.what)) return words_of_system(options, budget);
    if (options.prove)
        throw Error("--prove is for the infinite word of a system, and one finite word is given");
    if (options.say)
        throw Error("--say is for the infinite word of a system, and one finite word is given");
    if (options.as || options.count || !options.walnut.empty())
        throw Error(
            "--as, --count and --walnut are for the infinite word of a system, and one finite word "
            "is given");
    if (!options.let.empty())
        throw Error("--let is for the constants of a system, and one word has none");
    if (options.to)
        throw Error("--to is for the factors of a system, and one word has finitely many");
    const Letters found = options.file.empty()
                              ? of_text(options.word.value_or(options.what), options)
                              : of_characters(file_text(options.file, budget), options, budget);
    const WordReport report = word_report(found.word, found.names, budget);
    print(options.json    ? to_json(report).text()
          : options.latex ? to_latex(report)
                          : to_text(report));
    return success;
}

}  // namespace

void add_words(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "words", "Combinatorics on words: of one word, or of the factors of a D0L system",
        {"algae words abaab", "algae words fibonacci --to 40",
         "algae words --word wall --order 'w a l'", "algae words --letters genome.txt --json",
         "algae words thue-morse --say 'for some i, n with n >= 1: for all k <= n: T[i+k] = "
         "T[i+n+k]'",
         "algae words fibonacci --say 'n >= 1 and for some i: equal(i, i+n, 2n)' --as walnut"},
        words);
    verb.option("WHAT", options.what, "FILE|NAME",
                "a word; or a system: a file, - for standard input, or a name from the gallery");
    add_let_option(verb, options.let);
    verb.option("--word", options.word, given_word, "WORD",
                "a word, whatever files there are of this name");
    verb.option("--letters", options.file, "FILE",
                "a text whose characters but white space are the letters of a word");
    verb.option("--order", options.order, letters, "LETTERS",
                "the order of letters for conjugates and Lyndon words, with blanks between "
                "(default: of code points)");
    verb.option("--to", options.to, natural, "N",
                "of a system: factors of at most N letters (default 24)");
    verb.option("--say", options.say, given_word, "STATEMENT",
                "decides a first-order statement about the infinite word T of a system; exit 1 if "
                "it is refuted");
    verb.choice<std::optional<AutomatonFormat>>(
        "--as", options.as,
        {{"walnut", AutomatonFormat::walnut},
         {"gv", AutomatonFormat::graphviz},
         {"sage", AutomatonFormat::sage}},
        "walnut|gv|sage",
        "with --say: prints the automaton of the numbers that no quantifier binds as Walnut, "
        "Graphviz or Sage read it; with --count, matrices for Sage");
    verb.option("--count", options.count, given_word, "NUMBER",
                "with --say and two numbers that no quantifier binds: how many values of the other "
                "one there are for each value of this one");
    verb.output("--walnut", options.walnut, "FOLDER",
                "of a system: writes its infinite word, and its number system where Walnut has "
                "none, into the folder of Walnut");
    verb.flag("--prove", options.prove,
              "of a system: proves complexities for all lengths by automata of any size, or says "
              "why not");
    verb.json_flag(options.json);
    verb.latex_flag(options.latex, "print the values as LaTeX, which needs amsmath");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
