// Questions about languages: is a word in one (`member`) and by how many derivations, is it finite (`finite`), have two systems the same
// one (`equal`), is it of a family (`is`), which are its words (`list`).
//
// Every answer comes with what proves it and ends with the status of a question: 0 yes, 1 no, 3 undecided.
// `equal` proves a difference by a word or a length, and equality of sequences by a bound on how far one
// morphism may be ahead of the other, with the automaton of what is ahead; an undecided comparison is an
// answer in JSON too. `is` takes a language as claims write it, which may name systems as L(NAME).
//
// Questions about systems with context are decided as claims, and answered in their sentences.
//
// With `--certificate` the answer is written as the certificate of a claim whose theorem is the question. The claim is
// decided like any other, so a certificate has the proof that the rooms of claims find, and `verify` checks it as such.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
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
#include "report/report.hpp"

namespace algae::command {

namespace {

// Certificates

/// Whether it is a system with context, which the functions for other families do not take.
bool has_context(const LSystem& system) { return !as_et0l(system) && as_il(system); }

/// A claim about systems, which are called A, B, ... there, and about words with these letters.
/// Of a system with context the family is IL, whatever is given.
Claim claim_about(const std::vector<const Model*>& systems, const std::string& family,
                  const std::set<std::string>& letters = {}) {
    for (const Model* system : systems)
        if (const View<IL> rules = as_il(*system); has_context(*system) && rules->brackets)
            throw Error(system->name +
                        ": expected a system without context or one with plain contexts, found "
                        "one with context whose words have brackets");
    std::string text = "claim T\n";
    if (!letters.empty()) text += "alphabet " + joined(letters, " ") + '\n';
    std::string name = "A";
    for (std::size_t i = 0; i < systems.size(); ++i, ++name[0])
        text +=
            "let " + name + " = " + (has_context(*systems[i]) ? "IL" : family) + ' ' + name + '\n';
    return read_claim(text, "the certificate", [&](const std::string& called) {
        return *systems.at(static_cast<std::size_t>(called[0] - 'A'));
    });
}

/// Writes the certificate of the claim with this theorem, which is decided if its answer is not known.
void write_certificate(const std::string& file, Claim claim, Statement statement, std::string text,
                       const Budget& budget, std::optional<Answer> known = std::nullopt) {
    if (file.empty()) return;
    claim.title = text;
    statement.text = std::move(text);
    claim.statements.push_back({std::move(statement), ClaimedStatement::Purpose::theorem, {}});
    CheckedClaim checked;
    if (known)
        checked = {std::move(claim), {{CheckedStatement::Outcome::holds, std::move(*known)}}};
    else
        checked = check(std::move(claim), budget);
    write_file(file, Json(certificate(checked)).text(1));
}

/// How an answer is printed.
enum class Form { text, json, latex };

Form form_of(bool json, bool latex) { return json ? Form::json : latex ? Form::latex : Form::text; }

/// Prints the answer to a question, in the sentences of the claim that it was decided as. `fields`: of the JSON, before the others.
int say_answer(Answer found, Claim claim, Statement statement, std::string text,
               const std::string& file, Form form, const std::function<Json(Truth)>& fields,
               const Budget& budget) {
    const Alphabet alphabet = *claim.alphabet;
    const std::vector<std::string> argument = sentences(found, alphabet);
    std::string shown = found.truth == Truth::proved    ? "yes: "
                        : found.truth == Truth::refuted ? "no: "
                                                        : "undecided: ";
    for (std::size_t i = 0; i < argument.size(); ++i) shown += argument[i] + '\n';
    if (form == Form::latex) shown = latex(found, alphabet);
    if (form == Form::json) {
        Json out = fields(found.truth);
        out.set("argument", argument);
        if (found.proof) out.set("proof", Json(certificate(found, alphabet)));
        shown = out.text();
    }
    const Truth truth = found.truth;
    if (truth != Truth::undecided)
        write_certificate(file, std::move(claim), std::move(statement), std::move(text), budget,
                          std::move(found));
    print(shown);
    return status_of(truth);
}

int answer_as_claim(Claim claim, Statement statement, std::string text, const std::string& file,
                    Form form, const std::function<Json(Truth)>& fields, const Budget& budget) {
    Answer found = decide(statement, claim, budget);
    return say_answer(std::move(found), std::move(claim), std::move(statement), std::move(text),
                      file, form, fields, budget);
}

/// true, false, or null where it is undecided.
Json known(Truth truth) {
    return truth == Truth::undecided ? Json() : Json(truth == Truth::proved);
}

void add_certificate_option(Verb& verb, std::string& file) {
    verb.output("--certificate", file, "FILE", "write what algae verify checks again");
}

// member

struct MemberOptions {
    std::string file, word, certificate;
    std::vector<std::string> let;
    std::optional<Range> steps;
    std::optional<std::uint64_t> most;
    bool brief = false, count = false, all = false, json = false, latex = false;
    Bounds bounds;
};

void check_usage(const MemberOptions& options) {
    if (options.steps && !options.count && !options.all)
        throw Error("-n goes with --count or --all: derivations of so many steps");
    if (options.most && !options.all) throw Error("--max-derivations goes with --all");
    if (options.brief && options.all)
        throw Error("--brief leaves out the derivations that --all asks for");
    if (options.latex)
        refuse_with(
            "--latex",
            {{"--brief", options.brief}, {"--count", options.count}, {"--all", options.all}});
}

/// The derivations of the word by their numbers of steps: those of -n, otherwise all, or the first ones where they are
/// infinitely many.
template <class System>
DerivationCounts asked_counts(const MemberOptions& options, const System& system, const Word& word,
                              const Budget& budget) {
    if (!options.steps) return derivation_counts(system, word, 10, budget);
    DerivationCounts found;
    found.total = 0;
    for (std::uint64_t n = options.steps->first; n <= options.steps->last; ++n) {
        Integer count = number_of_derivations(system, word, n, budget);
        *found.total += count;
        found.by_steps.push_back({n, std::move(count)});
    }
    return found;
}

/// Prints the numbers of derivations of a member, and with --all the derivations. `first` is its first generation, where that
/// is known.
template <class System>
void print_derivations(const MemberOptions& options, std::optional<std::uint64_t> first,
                       const System& system, const Word& word, const Budget& budget) {
    constexpr std::uint64_t usual_most = 20;
    const std::uint64_t most = options.most.value_or(usual_most);
    const DerivationCounts counts = asked_counts(options, system, word, budget);
    if (!first && !options.steps && !counts.by_steps.empty()) first = counts.by_steps.front().steps;
    std::string text = "yes: " + spell(*system.alphabet, word) + " is in the language" +
                       (first ? ", first in generation " + std::to_string(*first) : "") + '\n' +
                       to_text(counts);
    Json out{{"member", true}, {"step", first}};
    out.update(to_json(counts));
    if (options.all) {
        Json list = Json::array();
        std::uint64_t shown = 0;
        for (const auto& [steps, count] : counts.by_steps) {
            if (shown == most) break;
            std::uint64_t number = 0;
            for (const Derivation& one :
                 derivations(system, word, steps, static_cast<std::size_t>(most - shown), budget)) {
                text += "derivation " + std::to_string(++number) + " of " + std::to_string(steps) +
                        (steps == 1 ? " step\n" : " steps\n") + to_text(one, system);
                list.add(Json{{"steps", steps}, {"derivation", to_json(one, system)}});
            }
            shown += number;
        }
        const bool is_all = counts.total && *counts.total == Integer(shown);
        if (!is_all)
            text += (counts.total ? readable(*counts.total - Integer(shown)) : "infinitely many") +
                    " more; --max-derivations shows more than " + std::to_string(most) + '\n';
        out.set("derivations", std::move(list));
        out.set("complete", is_all);
    }
    print(options.json ? out.text() : text);
}

/// Prints that a word is first in the language after so many steps, and its derivation if there is one.
template <class System>
void print_member(bool json, std::uint64_t steps, const std::optional<Derivation>& derivation,
                  const System& system, const Word& word) {
    Json out{{"member", true}, {"step", steps}};
    if (derivation) out.set("derivation", to_json(*derivation, system));
    print(json ? out.text()
               : "yes: " + spell(*system.alphabet, word) +
                     " is in the language, first in generation " + std::to_string(steps) + '\n' +
                     (derivation ? to_text(*derivation, system) : ""));
}

/// The claim about L(A) for a system A, and that it has the word.
std::pair<Claim, Statement> claim_of_member(const Model& system, const Word& word,
                                            const Alphabet& alphabet) {
    std::set<std::string> letters;
    for (const Symbol a : word) letters.insert(alphabet.name(a));
    Claim claim = claim_about({&system}, "ET0L", letters);
    HasWord said{generated_language(claim.systems.front()), {}};
    for (const Symbol a : word) said.word.push_back(claim.alphabet->find(alphabet.name(a)).value());
    return {std::move(claim), {std::move(said)}};
}

/// Writes that the word is in L(A), or not, for a system A.
void certify_member(const MemberOptions& options, const Model& system, const Word& word,
                    const Alphabet& alphabet, const Budget& budget) {
    if (options.certificate.empty()) return;
    auto [claim, said] = claim_of_member(system, word, alphabet);
    write_certificate(options.certificate, std::move(claim), std::move(said),
                      spell(alphabet, word) + " in L(A)", budget);
}

int member_with_context(const MemberOptions& options, const Model& system, const Budget& budget) {
    Alphabet alphabet = system.alphabet;
    const ModuleWord read = read_word(options.word, alphabet);
    if (!read.arguments.empty())
        throw Error("WORD has parameters, and the words of a system without parameters have none");
    const Word& word = read.letters;
    auto [claim, said] = claim_of_member(system, word, alphabet);
    std::string text = spell(alphabet, word) + " in L(A)";
    Answer found = decide(said, claim, budget);
    if (found.truth == Truth::proved && !options.latex) {
        const View<IL> rules = as_il(system);
        const IL own = over(*rules, std::make_shared<const Alphabet>(alphabet));
        if (options.count || options.all) {
            print_derivations(options, std::nullopt, own, word, budget);
        } else {
            std::optional<Derivation> shortest = shortest_derivation(own, word, budget);
            const std::uint64_t steps = shortest->words.size() - 1;
            if (options.brief) shortest.reset();
            print_member(options.json, steps, shortest, own, word);
        }
        write_certificate(options.certificate, std::move(claim), std::move(said), std::move(text),
                          budget, std::move(found));
        return success;
    }
    const auto fields = [&](Truth truth) {
        Json out{{"member", known(truth)}};
        if (truth == Truth::refuted) out.set("step", Json());
        if (truth == Truth::refuted && options.count)
            out.update(to_json(DerivationCounts{{}, Integer(0)}));
        return out;
    };
    return say_answer(std::move(found), std::move(claim), std::move(said), std::move(text),
                      options.certificate, form_of(options.json, options.latex), fields, budget);
}

int member(const MemberOptions& options) {
    check_usage(options);
    const Budget budget = options.bounds.budget();
    const Model written = open_model(options.file, budget, options.let);
    if (has_context(written)) return member_with_context(options, written, budget);
    const View<ET0L> system = as_et0l(written);
    Alphabet alphabet = *system->alphabet;
    const ModuleWord read = read_word(options.word, alphabet);
    if (!read.arguments.empty())
        throw Error("WORD has parameters, and the words of a system without parameters have none");
    const Word& word = read.letters;
    const Membership found = membership(*system, word, budget);
    if (found.member && (options.count || options.all)) {
        certify_member(options, written, word, alphabet, budget);
        print_derivations(options, found.step, *system, word, budget);
        return success;
    }
    std::optional<Derivation> witness;
    if (found.member && !options.brief) witness = derivation(*system, word, found, budget);
    certify_member(options, written, word, alphabet, budget);
    if (found.member && options.latex) {
        print(derivation_latex(witness->words, *system->alphabet));
    } else if (found.member) {
        print_member(options.json, found.step, witness, *system, word);
    } else if (options.json) {
        Json out{{"member", false}, {"step", nullptr}, {"reason", reason(found, alphabet, word)}};
        if (options.count) out.update(to_json(DerivationCounts{{}, Integer(0)}));
        print(out.text());
    } else {
        print("no: " + spell(alphabet, word) +
              " is not in the language: " + reason(found, alphabet, word) + '\n');
    }
    return found.member ? success : refuted;
}

// finite

struct FiniteOptions {
    std::string file, certificate;
    std::vector<std::string> let;
    bool json = false, latex = false;
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
    const Model written = open_model(options.file, budget, options.let);
    if (has_context(written) || options.latex) {
        Claim claim = claim_about({&written}, "ET0L");
        Statement said{IsFinite{generated_language(claim.systems.front())}};
        return answer_as_claim(
            std::move(claim), std::move(said), "L(A) is finite", options.certificate,
            form_of(options.json, options.latex),
            [](Truth truth) {
                return Json{{"finite", known(truth)}};
            },
            budget);
    }
    const View<ET0L> system = as_et0l(written);
    if (!options.certificate.empty()) {
        Claim claim = claim_about({&written}, "ET0L");
        Statement said{IsFinite{generated_language(claim.systems.front())}};
        write_certificate(options.certificate, std::move(claim), std::move(said), "L(A) is finite",
                          budget);
    }
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
    std::vector<std::string> let;
    std::string left, right, certificate;
    As as = As::language;
    bool json = false, latex = false;
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

/// That the languages, sequences or growth of two systems A and B are equal.
std::pair<Statement, std::string> equality(As as, const Claim& claim) {
    const auto &a = claim.systems.at(0), &b = claim.systems.at(1);
    if (as == As::growth) return {{EqualGrowth{a, b}}, "growth(A) == growth(B)"};
    if (as == As::sequence) return {{EqualSequences{a, b}}, "sequence(A) == sequence(B)"};
    return {{EqualLanguages{generated_language(a), generated_language(b)}}, "L(A) == L(B)"};
}

/// Writes that they are, or not.
void certify_equal(const EqualOptions& options, const Model& left, const Model& right,
                   const Budget& budget) {
    if (options.certificate.empty()) return;
    Claim claim = claim_about({&left, &right}, "D0L");
    auto [said, text] = equality(options.as, claim);
    write_certificate(options.certificate, std::move(claim), std::move(said), text, budget);
}

/// The terms in a file, if it is a b-file of the OEIS.
std::optional<BFile> b_file_of(const std::string& path, const Budget& budget) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return std::nullopt;
    const std::string text = file_text(path, budget);
    if (!looks_like_b_file(text)) return std::nullopt;
    return read_b_file(text, path);
}

/// How far the lengths are moved against the terms where that makes them the same, with at least five compared.
std::optional<long> shift_between(const D0L& system, const BFile& file, const Budget& budget) {
    constexpr long farthest = 10;
    constexpr std::size_t fewest = 5;
    const Integer count(file.terms.size());
    for (long distance = 1; distance <= farthest; ++distance)
        for (const long shift : {distance, -distance}) {
            // The term of n + shift is the length of generation n.
            std::size_t compared = 0;
            bool same = true;
            for (std::size_t i = 0; i < file.terms.size() && same; ++i) {
                const Integer n = file.first + Integer(i) - Integer(shift);
                if (sign(n) < 0) continue;
                same = length(system, n.to_uint64(), budget) == file.terms[i];
                ++compared;
            }
            if (same && compared >= fewest) return shift;
        }
    return std::nullopt;
}

/// Whether the lengths of a system are the terms of a b-file.
int equal_to_terms(const EqualOptions& options, const std::string& system_file,
                   const std::string& path, const BFile& file, const Budget& budget) {
    if (!options.certificate.empty() || options.latex)
        throw Error(path +
                    " holds lengths, so there is no proof to write: expected two systems "
                    "with --certificate and --latex");
    if (sign(file.first) < 0)
        throw Error(path +
                    ": expected terms from n = 0 on, as generations begin with 0; found n = " +
                    to_string(file.first));
    const Model model = open_model(system_file, budget, options.let);
    const View<D0L> system = as_d0l(model);
    const std::string last = to_string(file.first + Integer(file.terms.size() - 1));
    for (std::size_t i = 0; i < file.terms.size(); ++i) {
        const Integer n = file.first + Integer(i);
        const Integer letters = length(*system, n.to_uint64(), budget);
        if (letters == file.terms[i]) continue;
        const std::optional<long> shift = shift_between(*system, file, budget);
        std::string text = "different: generation " + to_string(n) + " has " + to_string(letters) +
                           (letters == 1 ? " letter" : " letters") + ", and a(" + to_string(n) +
                           ") is " + to_string(file.terms[i]) + " in " + path + "\n";
        if (shift)
            text += std::string("  generation n has a(n") + (*shift < 0 ? "-" : "+") +
                    std::to_string(std::abs(*shift)) + ") letters, as far as the file goes\n";
        Json witness{{"by", "term"}, {"n", n}, {"lengths", Json::array({letters, file.terms[i]})}};
        witness.set("shift", shift ? Json(*shift) : Json());
        print(options.json ? Json{{"verdict", "different"}, {"witness", witness}}.text() : text);
        return refuted;
    }
    print(options.json
              ? Json{{"verdict", "equal"},
                     {"witness", Json{{"by", "terms"},
                                      {"from", file.first},
                                      {"to", file.first + Integer(file.terms.size() - 1)}}}}
                    .text()
              : "equal: generations " + to_string(file.first) + " to " + last +
                    " have the lengths that are in " + path + "; it says nothing of later ones\n");
    return success;
}

int equal(const EqualOptions& options) {
    const Budget budget = options.bounds.budget();
    const std::optional<BFile> left_terms = b_file_of(options.left, budget),
                               right_terms = b_file_of(options.right, budget);
    if (left_terms || right_terms) {
        const std::string& path = right_terms ? options.right : options.left;
        if (options.as != As::growth)
            throw Error(path + " is a b-file, which holds lengths: expected --as growth with it");
        if (left_terms && right_terms)
            throw Error(options.left + " and " + options.right +
                        " are b-files: expected a system and a b-file");
        return equal_to_terms(options, right_terms ? options.left : options.right, path,
                              right_terms ? *right_terms : *left_terms, budget);
    }
    const Model left_model = open_model(options.left, budget, options.let),
                right_model = open_model(options.right, budget, options.let);
    const bool with_context =
        options.as == As::language && (has_context(left_model) || has_context(right_model));
    if (with_context || options.latex) {
        Claim claim = claim_about({&left_model, &right_model}, with_context ? "ET0L" : "D0L");
        auto [said, text] = equality(options.as, claim);
        return answer_as_claim(
            std::move(claim), std::move(said), text, options.certificate,
            form_of(options.json, options.latex),
            [](Truth truth) {
                return Json{{"verdict", truth == Truth::proved    ? "equal"
                                        : truth == Truth::refuted ? "different"
                                                                  : "undecided"}};
            },
            budget);
    }
    const View<D0L> left = as_d0l(left_model), right = as_d0l(right_model);
    try {
        certify_equal(options, left_model, right_model, budget);
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

// Languages as expressions

WrittenLanguage read_expression(const std::string& expression,
                                const std::vector<std::string>& alphabet, const Budget& budget) {
    return read_language(expression, systems_from({"."}, budget, true), "expression", alphabet);
}

/// Which letters complements are over, where there are any.
std::string complement_line(const WrittenLanguage& written) {
    const std::string text = complement_text(written.letters, *written.alphabet);
    return text.empty() ? text : text + '\n';
}

void set_complement_letters(Json& out, const WrittenLanguage& written) {
    if (written.letters.empty()) return;
    std::vector<std::string> names;
    for (const Symbol letter : written.letters) names.push_back(written.alphabet->name(letter));
    std::ranges::sort(names);
    out.set("complement_letters", names);
}

void add_expression_options(Verb& verb, std::string& expression,
                            std::vector<std::string>& alphabet) {
    verb.option("EXPR", expression, "TEXT",
                "a language as in claims: {a, aa}, /a(ab)*/, L(NAME), | & \\ . * + ~")
        .required = true;
    verb.option("--alphabet", alphabet, letters, "LETTERS", alphabet_help);
}

// is

struct IsOptions {
    std::string family, expression, certificate;
    std::vector<std::string> alphabet;
    bool empty_axiom = false, json = false, latex = false;
    Bounds bounds;
};

std::string family_of(const IsOptions& options) {
    return options.family == "regular"        ? "REG"
           : options.family == "context-free" ? "CF"
                                              : options.family;
}

/// Throws Error unless there is such a class.
void must_be_known(const std::string& name) {
    static const std::vector<std::string> known{
        "finite", "infinite", "empty", "regular", "context-free", "REG",  "CF",    "0L",
        "P0L",    "D0L",      "PD0L",  "T0L",     "PT0L",         "DT0L", "PDT0L", "E0L",
        "ET0L",   "EDT0L",    "IL"};
    if (std::ranges::count(known, name) == 0 && !system_form(name))
        throw Error(name + " is no family of languages" + did_you_mean(name, known));
}

Answer judged(const IsOptions& options, const WrittenLanguage& written, const Budget& budget) {
    if (options.family == "finite")
        return judge_finite(written.language, *written.alphabet, budget);
    if (options.family == "infinite")
        return opposite(judge_finite(written.language, *written.alphabet, budget));
    if (options.family == "empty") return judge_empty(written.language, *written.alphabet, budget);
    return judge_family(written.language, {family_of(options), options.empty_axiom, {}, true},
                        *written.alphabet, budget);
}

/// The systems that occur in an expression, each once.
void add_systems(const Language& language,
                 std::vector<std::shared_ptr<const SourceSystem>>& systems) {
    const auto is_known = [&](const auto& known) { return known->name == language->system->name; };
    if (language->system && std::none_of(systems.begin(), systems.end(), is_known))
        systems.push_back(language->system);
    for (const Language& part : language->parts) add_systems(part, systems);
}

void certify_is(const IsOptions& options, const WrittenLanguage& written, const Answer& found,
                const Budget& budget) {
    Claim claim;
    claim.alphabet = written.alphabet;
    claim.letters = written.letters;
    claim.empty_axiom = options.empty_axiom;
    add_systems(written.language, claim.systems);
    Statement said{InFamily{written.language, family_of(options)}};
    if (options.family == "finite" || options.family == "infinite")
        said.says = IsFinite{written.language};
    if (options.family == "empty") said.says = IsEmpty{written.language};
    said.negated = options.family == "infinite";
    write_certificate(options.certificate, std::move(claim), std::move(said),
                      options.expression + " is " + options.family, budget, found);
}

int is(const IsOptions& options) {
    must_be_known(options.family);
    const Budget budget = options.bounds.budget();
    const WrittenLanguage written = read_expression(options.expression, options.alphabet, budget);
    const Answer found = judged(options, written, budget);
    certify_is(options, written, found, budget);
    std::string text = found.truth == Truth::proved    ? "yes"
                       : found.truth == Truth::refuted ? "no"
                                                       : "undecided";
    text += '\n';
    const std::vector<std::string> argument = sentences(found, *written.alphabet);
    for (const std::string& line : argument) text += line + '\n';
    text += complement_line(written);
    if (options.json) {
        Json out{{"verdict", to_string(found.truth)}, {"argument", argument}};
        set_complement_letters(out, written);
        if (found.proof)
            out.set(found.truth == Truth::proved ? "witness" : "obstruction",
                    certificate(found, *written.alphabet));
        text = out.text();
    }
    if (options.latex) text = latex(found, *written.alphabet);
    print(text);
    return status_of(found.truth);
}

// list

struct ListOptions {
    std::string expression;
    std::vector<std::string> alphabet;
    std::optional<std::uint64_t> length, words, random, seed;
    bool counts = false, json = false;
    Bounds bounds;
};

Json words_json(const std::vector<Word>& words, const Alphabet& alphabet) {
    Json all = Json::array();
    for (const Word& word : words) all.add(spell(alphabet, word));
    return all;
}

Json reason_json(const std::string& stopped) { return stopped.empty() ? Json() : Json(stopped); }

/// What the list is of the language, as a sentence.
std::string standing(const WordList& list) {
    const std::string letters = list.decided == 0
                                    ? ""
                                    : " of at most " + std::to_string(list.decided - 1) +
                                          (list.decided == 2 ? " letter" : " letters");
    if (!list.stopped.empty()) {
        const std::string known =
            list.words.empty() ? "No word is found" : "At least these are words of the language";
        return known +
               (list.decided == 0 ? ", and others" : ": all words" + letters + "; longer ones") +
               " may be missing: " + list.stopped + ".";
    }
    if (list.whole)
        return list.words.empty() ? "The language has no word." : "These are all words.";
    if (!list.full)
        return (list.words.empty() ? "There is no word" : "These are all words") + letters + ".";
    return list.words.size() == 1
               ? "This is the first word."
               : "These are the first " + std::to_string(list.words.size()) + " words.";
}

int list_first_words(const ListOptions& options, const WrittenLanguage& written,
                     const Budget& budget) {
    constexpr std::uint64_t some = 100, far = 1000, all = std::uint64_t{1} << 62;
    ListLimits limits;
    limits.length = options.length.value_or(options.words ? far : some);
    limits.words = options.words.value_or(options.length ? all : some);
    const WordList list = list_words(written.language, *written.alphabet, limits, budget);
    if (options.json) {
        Json out{{"words", words_json(list.words, *written.alphabet)}};
        out.set("length", list.decided == 0 ? Json() : Json(list.decided - 1));
        out.set("full", list.full);
        out.set("whole", list.whole);
        out.set("stopped", reason_json(list.stopped));
        set_complement_letters(out, written);
        print(out.text());
    } else {
        std::string text;
        for (const Word& word : list.words) text += spell(*written.alphabet, word) + '\n';
        print(text + standing(list) + '\n' + complement_line(written));
    }
    return list.stopped.empty() ? success : undecided;
}

int list_counts(const ListOptions& options, const WrittenLanguage& written, const Budget& budget) {
    constexpr std::uint64_t some = 12;
    const std::uint64_t longest = options.length.value_or(some);
    const WordCounts found = count_words(written.language, *written.alphabet, longest, budget);
    if (options.json) {
        Json out{{"counts", found.counts}, {"whole", found.whole}};
        out.set("generating_function",
                found.function ? Json{{"numerator", found.function->numerator.coefficients()},
                                      {"denominator", found.function->denominator.coefficients()}}
                               : Json());
        out.set("stopped", reason_json(found.stopped));
        set_complement_letters(out, written);
        print(out.text());
    } else {
        std::string text;
        for (std::size_t length = 0; length < found.counts.size(); ++length)
            text += std::to_string(length) + (length == 1 ? " letter: " : " letters: ") +
                    to_string(found.counts[length]) +
                    (found.counts[length] == 1 ? " word" : " words") + '\n';
        if (found.whole) text += "No word is longer.\n";
        if (found.function) text += "generating function: " + to_string(*found.function) + '\n';
        if (!found.stopped.empty())
            text +=
                "Of longer words it is not decided how many there are: " + found.stopped + ".\n";
        print(text + complement_line(written));
    }
    return found.stopped.empty() ? success : undecided;
}

int list_random(const ListOptions& options, const WrittenLanguage& written, const Budget& budget) {
    const std::uint64_t seed = options.seed.value_or(1);
    const std::vector<Word> drawn = draw_words(written.language, *written.alphabet, *options.length,
                                               *options.random, seed, budget);
    const bool is_none = drawn.empty() && *options.random > 0;
    if (options.json) {
        Json out{{"words", words_json(drawn, *written.alphabet)},
                 {"length", *options.length},
                 {"seed", seed}};
        set_complement_letters(out, written);
        print(out.text());
    } else if (is_none) {
        print("The language has no word of " + std::to_string(*options.length) +
              (*options.length == 1 ? " letter.\n" : " letters.\n") + complement_line(written));
    } else {
        std::string text;
        for (const Word& word : drawn) text += spell(*written.alphabet, word) + '\n';
        print(text);
    }
    return is_none ? refuted : success;
}

int list_language(const ListOptions& options) {
    const Budget budget = options.bounds.budget();
    const WrittenLanguage written = read_expression(options.expression, options.alphabet, budget);
    if (options.counts) return list_counts(options, written, budget);
    if (options.random) return list_random(options, written, budget);
    return list_first_words(options, written, budget);
}

}  // namespace

void add_member(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "member", "Whether a word is in the language, with its derivation",
        {"algae member fibonacci abaab", "algae member my.lsys ε --json",
         "algae member all-powers aaaa --count", "algae member all-powers aaaa --all -n 3",
         "algae member fibonacci abaab --certificate my.json"},
        member);
    verb.option("FILE", options.file, file_type, file_help).required = true;
    add_let_option(verb, options.let);
    verb.option("WORD", options.word, "TEXT", "the word; ε is the empty word").required = true;
    verb.flag("--brief", options.brief, "leave the derivation out");
    verb.flag("--count", options.count,
              "how many derivations there are, exactly, by their numbers of steps: choices of a "
              "rule for each letter and of a table for each step");
    verb.flag("--all", options.all, "the different derivations, fewest steps first");
    verb.option("-n", options.steps, range, "N",
                "with --count and --all: derivations of N steps, or of a range such as 0..6");
    verb.option("--max-derivations", options.most, natural, "K",
                "with --all: derivations that are shown (default 20)");
    add_certificate_option(verb, options.certificate);
    verb.json_flag(options.json);
    verb.latex_flag(options.latex, "print the derivation as LaTeX, which needs amsmath");
    verb.bounded_by(options.bounds);
}

void add_finite(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("finite", "Whether the language is finite, and how many words it has",
                  {"algae finite koch", "algae finite my.lsys --json",
                   "algae finite koch --certificate my.json"},
                  finite);
    verb.option("FILE", options.file, file_type, file_help).required = true;
    add_let_option(verb, options.let);
    add_certificate_option(verb, options.certificate);
    verb.json_flag(options.json);
    verb.latex_flag(options.latex, "print the argument as LaTeX, which needs amsmath");
    verb.bounded_by(options.bounds);
}

void add_equal(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "equal",
        "Whether two systems have the same language, or D0L systems the same sequence or growth",
        {"algae equal koch my.lsys", "algae equal a.lsys b.lsys --as sequence --json",
         "algae equal fibonacci b000045.txt --as growth",
         "algae equal koch my.lsys --certificate my.json"},
        equal);
    verb.option("A", options.left, file_type, file_help).required = true;
    verb.option("B", options.right, file_type, file_help).required = true;
    add_let_option(verb, options.let);
    verb.choice("--as", options.as,
                {{"sequence", As::sequence}, {"language", As::language}, {"growth", As::growth}},
                "language|sequence|growth",
                "what is compared: language, the set of words; sequence, the word of every "
                "generation; growth, its length, which may stand in a b-file of the OEIS");
    add_certificate_option(verb, options.certificate);
    verb.json_flag(options.json);
    verb.latex_flag(options.latex, "print the argument as LaTeX, which needs amsmath");
    verb.bounded_by(options.bounds);
}

void add_is(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("is", "Whether a language is of a family, with the system or the proof",
                  {"algae is 0L '{a, aa}'", "algae is PD0L 'L(fibonacci)' --json",
                   "algae is 0L '{a, aa}' --certificate my.json"},
                  is);
    verb.option("CLASS", options.family,
                "0L|P0L|D0L|PD0L|T0L|PT0L|DT0L|PDT0L|E0L|ET0L|EDT0L|IL|regular|context-free|"
                "finite|infinite|empty",
                "a family of languages, or what else a language may be")
        .required = true;
    add_expression_options(verb, options.expression, options.alphabet);
    verb.flag("--allow-empty-axiom", options.empty_axiom,
              "systems may have the empty word as axiom");
    add_certificate_option(verb, options.certificate);
    verb.json_flag(options.json);
    verb.latex_flag(options.latex, "print the argument as LaTeX, which needs amsmath");
    verb.bounded_by(options.bounds);
}

void add_list(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "list", "The words of a language, shortest first, or how many there are of each length",
        {"algae list 'L(fibonacci) | /a*/' --words 10", "algae list '~/(a|b)*bb(a|b)*/' --counts",
         "algae list '/(a|bb)*/' --random 5 --length 40"},
        list_language);
    add_expression_options(verb, options.expression, options.alphabet);
    verb.option(
        "--length", options.length, natural, "N",
        "up to N letters: 100 if neither this nor --words is given, 1000 with --words, 12 with "
        "--counts; of --random just this length");
    verb.option("--words", options.words, natural, "K",
                "at most K words: 100 if neither this nor --length is given")
        .excludes = {"--counts", "--random"};
    verb.flag("--counts", options.counts,
              "how many words of each length there are; of a regular language also the generating "
              "function");
    Option& random = verb.option("--random", options.random, natural, "K",
                                 "K words of a length, all equally likely");
    random.needs = {"--length"};
    random.excludes = {"--counts"};
    verb.option("--seed", options.seed, natural, "S", "which words these are, 1 if not given")
        .needs = {"--random"};
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
