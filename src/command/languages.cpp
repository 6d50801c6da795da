// Questions about languages: is a word in one (`member`), is it finite (`finite`), have two systems the same
// one (`equal`), is it of a family (`is`).
//
// Every answer comes with what proves it and ends with the status of a question: 0 yes, 1 no, 3 undecided.
// `equal` proves a difference by a word or a length, and equality of sequences by a bound on how far one
// morphism may be ahead of the other, with the automaton of what is ahead; an undecided comparison is an
// answer in JSON too. `is` takes a language as claims write it, which may name systems as L(NAME).

#include <nlohmann/json.hpp>

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "report/report.hpp"

namespace algae::command {

namespace {

// member

struct MemberOptions {
    std::string file, word;
    bool brief = false, json = false;
    Bounds bounds;
};

int member(const MemberOptions& options) {
    const Budget budget = options.bounds.budget();
    const LSystem written = open_system(options.file, budget);
    const View<ET0L> system = as_et0l(written);
    Alphabet alphabet = *system->alphabet;
    const ModuleWord read = read_word(options.word, alphabet);
    if (!read.arguments.empty())
        throw Error("WORD has parameters, and the words of a system without parameters have none");
    const Word& word = read.letters;
    const Membership found = membership(*system, word, budget);
    std::optional<Derivation> witness;
    if (found.member && !options.brief) witness = derivation(*system, word, found, budget);
    const std::string text = spell(alphabet, word);
    if (options.json) {
        Json out{{"member", found.member}};
        out.set("step", found.member ? Json(found.step) : Json());
        if (witness) out.set("derivation", to_json(*witness, *system));
        if (!found.member) out.set("reason", reason(found, alphabet, word));
        print(out.text());
    } else if (found.member) {
        print("yes: " + text + " is in the language, first in " + "generation " +
              std::to_string(found.step) + '\n' + (witness ? to_text(*witness, *system) : ""));
    } else {
        print("no: " + text + " is not in the language: " + reason(found, alphabet, word) + '\n');
    }
    return found.member ? success : refuted;
}

// finite

struct FiniteOptions {
    std::string file;
    bool json = false;
    Bounds bounds;
};

std::string words_text(const Integer& count) {
    return "finite: " + readable(count) + (count == 1 ? " word" : " words");
}

/// Prints that the language is infinite and why.
int say_infinite(const FiniteOptions& options, const std::string& text, const Json& round) {
    print(options.json ? Json{{"finite", false}, {"count", nullptr}, {"round", round}}.text()
                       : text);
    return refuted;
}

int finite_of_0l(const FiniteOptions& options, const OL& system, const Budget& budget) {
    const Finiteness found = finiteness(system);
    if (!found.finite)
        return say_infinite(options, to_text(*found.round, system), to_json(*found.round, system));
    Json out{{"finite", true}};
    std::string text;
    if (is_deterministic(system)) {
        const Repetition words = repetition(system, budget);
        const Integer count = Integer(words.preperiod) + words.period;
        out.set("count", count);
        out.set("preperiod", words.preperiod);
        out.set("period", words.period);
        text = words_text(count) + "; from generation " + std::to_string(words.preperiod) +
               " on they repeat with period " + readable(words.period) + '\n';
    } else {
        const Integer count = number_of_words(system, budget);
        out.set("count", count);
        text = words_text(count) + '\n';
    }
    print(options.json ? out.text() : text);
    return success;
}

int finite(const FiniteOptions& options) {
    const Budget budget = options.bounds.budget();
    const View<ET0L> system = as_et0l(open_system(options.file, budget));
    if (system->tables.size() == 1 && has_only_terminals(*system))
        return finite_of_0l(options, without_terminals(*system), budget);
    const TablesFiniteness found = finiteness(*system, budget);
    if (!found.finite)
        return say_infinite(options, to_text(*found.endless, *system),
                            to_json(*found.endless, *system));
    const Integer count = number_of_words(*system, budget);
    print(options.json
              ? Json{{"finite", true}, {"count", count}}.text()
              : words_text(count) + (count.is_zero() ? "; the language is empty\n" : "\n"));
    return success;
}

// equal: A and B are the systems as they stand on the command line.

enum class As { language, sequence, growth };

struct EqualOptions {
    std::string left, right;
    As as = As::language;
    bool json = false;
    Bounds bounds;
};

/// What is printed.
struct Comparison {
    bool equal = false;
    Json witness;
    std::string text;
};

Comparison growth_answer(const D0L& left, const D0L& right, const Budget& budget) {
    const GrowthComparison found = equal_growth(left, right, budget);
    Json witness{{"bound", found.bound}};
    if (found.difference)
        witness = {{"generation", found.difference->generation},
                   {"lengths", Json::array({found.difference->left, found.difference->right})}};
    return {found.equal, std::move(witness), to_text(found)};
}

Comparison sequence_answer(const D0L& left, const D0L& right, const Budget& budget) {
    const SequenceEquality found = equal_sequences(left, right, budget);
    const auto alphabet = over_common_alphabet(left, right).alphabet;
    Json witness(found.equal ? balance_certificate(*found.balance, *alphabet)
                             : difference_certificate(*found.difference));
    if (!found.equal) {
        witness.set("lengths",
                    Json::array({found.difference->left_length, found.difference->right_length}));
        witness.set("from", found.difference->from);
        witness.set("letters", Json::array({spell(*alphabet, found.difference->left),
                                            spell(*alphabet, found.difference->right)}));
    }
    return {found.equal, std::move(witness), to_text(found, *alphabet)};
}

Comparison language_answer(const D0L& left, const D0L& right, const Budget& budget) {
    const LanguageEquality found = equal_languages(left, right, budget);
    const auto alphabet = over_common_alphabet(left, right).alphabet;
    if (found.equal)
        return {true, Json(language_certificate(found, *alphabet)), to_text(found, *alphabet)};
    const LanguageDifference& difference = *found.difference;
    Json witness{{"by", "word"},
                 {"of", difference.in_left ? "A" : "B"},
                 {"generation", difference.generation},
                 {"length", difference.length}};
    witness.set("word", difference.word ? Json(spell(*alphabet, *difference.word)) : Json());
    return {false, std::move(witness), to_text(found, *alphabet)};
}

int equal(const EqualOptions& options) {
    const Budget budget = options.bounds.budget();
    const View<D0L> left = as_d0l(open_system(options.left, budget));
    const View<D0L> right = as_d0l(open_system(options.right, budget));
    try {
        const auto answer_of = options.as == As::growth     ? growth_answer
                               : options.as == As::sequence ? sequence_answer
                                                            : language_answer;
        const Comparison found = answer_of(*left, *right, budget);
        const Json out{{"verdict", found.equal ? "equal" : "different"},
                       {"witness", found.witness}};
        print(options.json ? out.text() : found.text);
        return found.equal ? success : refuted;
    } catch (const BoundReached& bound) {
        if (!options.json) throw;
        print(Json{{"verdict", "undecided"}, {"witness", {{"tried", bound.what()}}}}.text());
        return undecided;
    }
}

// is

struct IsOptions {
    std::string family, expression;
    bool empty_axiom = false, json = false;
    Bounds bounds;
};

Answer judged(const IsOptions& options, const WrittenLanguage& written, const Budget& budget) {
    if (options.family == "finite")
        return judge_finite(written.language, *written.alphabet, budget);
    if (options.family == "infinite")
        return opposite(judge_finite(written.language, *written.alphabet, budget));
    if (options.family == "empty") return judge_empty(written.language, *written.alphabet, budget);
    const std::string family = options.family == "regular"        ? "REG"
                               : options.family == "context-free" ? "CF"
                                                                  : options.family;
    return judge_family(written.language, {family, options.empty_axiom, {}}, *written.alphabet,
                        budget);
}

int is(const IsOptions& options) {
    const Budget budget = options.bounds.budget();
    const WrittenLanguage written = read_language(options.expression, systems_from({"."}, budget));
    const Answer found = judged(options, written, budget);
    std::string text = found.truth == Truth::proved    ? "yes"
                       : found.truth == Truth::refuted ? "no"
                                                       : "undecided";
    text += '\n';
    const std::vector<std::string> argument = sentences(found, *written.alphabet);
    for (const std::string& line : argument) text += line + '\n';
    if (options.json) {
        Json out{{"verdict", to_string(found.truth)}, {"argument", argument}};
        if (found.proof)
            out.set(found.truth == Truth::proved ? "witness" : "obstruction",
                    certificate(found, *written.alphabet));
        text = out.text();
    }
    print(text);
    return status_of(found.truth);
}

}  // namespace

void add_member(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("member", "Whether a word is in the language, with its derivation",
                  {"algae member fibonacci abaab", "algae member my.lsys ε --json"}, member);
    verb.option("FILE", options.file, file_type, file_help).required = true;
    verb.option("WORD", options.word, "TEXT", "the word; ε is the empty word").required = true;
    verb.flag("--brief", options.brief, "leave the derivation out");
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

void add_finite(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("finite", "Whether the language is finite, and how many words it has",
                  {"algae finite koch", "algae finite my.lsys --json"}, finite);
    verb.option("FILE", options.file, file_type, file_help).required = true;
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

void add_equal(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "equal", "Whether two D0L systems have the same language, sequence of words, or growth",
        {"algae equal koch my.lsys", "algae equal a.lsys b.lsys --as sequence --json"}, equal);
    verb.option("A", options.left, file_type, file_help).required = true;
    verb.option("B", options.right, file_type, file_help).required = true;
    verb.choice("--as", options.as,
                {{"sequence", As::sequence}, {"language", As::language}, {"growth", As::growth}},
                "language|sequence|growth",
                "what is compared: language, the set of words; sequence, the word of every "
                "generation; growth, its length");
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

void add_is(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("is", "Whether a language is of a family, with the system or the proof",
                  {"algae is 0L '{a, aa}'", "algae is PD0L 'L(fibonacci)' --json"}, is);
    verb.option("CLASS", options.family,
                "0L|P0L|D0L|PD0L|T0L|PT0L|DT0L|PDT0L|E0L|ET0L|EDT0L|IL|regular|context-free|"
                "finite|infinite|empty",
                "a family of languages, or what else a language may be")
        .required = true;
    verb.option("EXPR", options.expression, "TEXT",
                "a language as in claims: {a, aa}, /a(ab)*/, L(NAME), | & \\ . * + ~")
        .required = true;
    verb.flag("--allow-empty-axiom", options.empty_axiom,
              "systems may have the empty word as axiom");
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
