#include "language/detail/judge.hpp"

#include <nlohmann/json.hpp>

#include "verify/verify.hpp"
#include "word/word.hpp"

// Whether a language is finite, empty, or has a given number of words.
//
// If the words can be listed they are. That a language is infinite is shown by a word that can be pumped
// through its automaton, by a round of rules or tables in a system, or by an infinite part. Emptiness of an
// intersection of L(G) with a regular language is a meeting.

namespace algae {

namespace {

using Json = nlohmann::ordered_json;
using Kind = LanguageTree::Kind;

/// A state that is come by twice on the way to an accepted word: words u v^n w of the language.
struct Pump {
    Word prefix, middle, suffix;
};

/// A way from one state to another: the first in shortlex order, not empty if `moving`.
std::optional<Word> way(const Dfa& automaton, std::size_t from, const std::vector<char>& goals,
                        bool moving) {
    if (!moving && goals[from]) return Word{};
    std::vector<std::optional<std::pair<std::size_t, Symbol>>> before(automaton.states());
    std::vector<std::size_t> open{from};
    for (std::size_t i = 0; i < open.size(); ++i)
        for (Symbol a = 0; a < automaton.letters; ++a) {
            const std::size_t to = automaton.step(open[i], a);
            if (goals[to] || (!before[to] && to != from)) {
                if (!before[to]) before[to] = {open[i], a};
                if (!goals[to]) {
                    open.push_back(to);
                    continue;
                }
                Word word{a};
                for (std::size_t at = open[i]; at != from; at = before[at]->first)
                    word.push_back(before[at]->second);
                return Word(word.rbegin(), word.rend());
            }
        }
    return std::nullopt;
}

std::optional<Pump> pump(const Dfa& automaton) {
    for (std::size_t state = 0; state < automaton.states(); ++state) {
        std::vector<char> here(automaton.states(), 0);
        here[state] = 1;
        const auto prefix = way(automaton, automaton.initial, here, false);
        const auto middle = way(automaton, state, here, true);
        const auto suffix = way(automaton, state, automaton.accepting, false);
        if (prefix && middle && suffix) return Pump{*prefix, *middle, *suffix};
    }
    return std::nullopt;
}

Judgement endless_round(const SourceSystem& source, const OL& system, const Alphabet& alphabet) {
    const Finiteness found = finiteness(system);
    Json rules = Json::array();
    std::string text;
    for (const RuleUse& use : found.round->rules) {
        const Word& successor = system.successors[use.letter][use.choice];
        rules.push_back({{"letter", alphabet.name(use.letter)},
                         {"successor", certificate_text(alphabet, successor)}});
        text += (text.empty() ? "" : ", ") + alphabet.name(use.letter) + " -> " +
                spell(alphabet, successor);
    }
    return Judgement::refuted(
        {"L(" + source.name + ") is infinite: by " + text + " the letter " +
         alphabet.name(found.round->rules.front().letter) + " comes back with " +
         alphabet.name(found.round->other) +
         " beside it, which never disappears; so n rounds give n letters and more."},
        {{"by", "endless round"}, {"rules", rules}, {"other", alphabet.name(found.round->other)}});
}

Json course_json(const Course& course, const ET0L& system, const Alphabet& alphabet) {
    Json steps = Json::array();
    for (const TableUse& use : course)
        steps.push_back(
            {{"table", use.table},
             {"letter", alphabet.name(use.letter)},
             {"successor",
              certificate_text(alphabet, system.tables[use.table][use.letter][use.choice])},
             {"place", use.place}});
    return steps;
}

Judgement endless_tables(const std::string& what, const ET0L& system, const EndlessTables& found,
                         const Alphabet& alphabet, const std::string& system_name) {
    Json proof{{"by", "endless tables"},
               {"again", alphabet.name(found.again)},
               {"other", alphabet.name(found.other)}};
    proof["before"] = course_json(found.before, system, alphabet);
    proof["round"] = course_json(found.round, system, alphabet);
    proof["beside"] = course_json(found.beside, system, alphabet);
    proof["kept"] = course_json(found.kept, system, alphabet);
    proof["after"] = course_json(found.after, system, alphabet);
    return Judgement::refuted(
        {what + " is infinite: a derivation of " + system_name + " goes round from " +
         alphabet.name(found.again) + " to " + alphabet.name(found.again) + " and " +
         alphabet.name(found.other) +
         ", which lasts until it becomes a terminal; n rounds give n letters and more."},
        proof);
}

std::optional<Judgement> infinite_generated(const Language& language, const Alphabet& alphabet,
                                            const Budget& budget) {
    const SourceSystem& source = *language->system;
    if (!source.tables) return std::nullopt;
    const TablesFiniteness found = finiteness(*source.tables, budget);
    if (found.finite) return std::nullopt;
    if (source.tables->tables.size() == 1 && has_only_terminals(*source.tables))
        return endless_round(source, without_terminals(*source.tables), alphabet);
    return endless_tables("L(" + source.name + ")", *source.tables, *found.endless, alphabet,
                          source.name);
}

Judgement part_is(const Language& whole, const Judgement& part, std::size_t i,
                  const std::string& why, const Alphabet& alphabet) {
    Judgement result = part;
    result.argument.push_back("So " + to_string(whole, alphabet) + " is infinite" + why + ".");
    result.proof =
        std::make_shared<const Json>(Json{{"by", "part"}, {"index", i}, {"proof", *part.proof}});
    return result;
}

/// A proof that the language is infinite, if one is found; then the judgement on finiteness is `refuted`.
std::optional<Judgement> infinite(const Language& language, const Alphabet& alphabet,
                                  const Budget& budget) {
    budget.check();
    if (const auto regular = regular_value(language, alphabet, budget)) {
        const auto found = pump(regular->automaton());
        if (!found) return std::nullopt;
        const std::string u = spell(alphabet, found->prefix), v = spell(alphabet, found->middle),
                          w = spell(alphabet, found->suffix);
        return Judgement::refuted(
            {to_string(language, alphabet) + " is infinite: it has (" + u + ")(" + v + ")^n(" + w +
             ") for every n, since its automaton is in the same state before and after " + v + "."},
            {{"by", "pumping"},
             {"prefix", certificate_text(alphabet, found->prefix)},
             {"middle", certificate_text(alphabet, found->middle)},
             {"suffix", certificate_text(alphabet, found->suffix)}});
    }
    if (language->kind == Kind::generated) return infinite_generated(language, alphabet, budget);
    const auto part = [&](std::size_t i) { return infinite(language->parts[i], alphabet, budget); };
    switch (language->kind) {
        case Kind::united:
            for (const std::size_t i : {0u, 1u})
                if (const auto found = part(i))
                    return part_is(language, *found, i, ", as a part of it is", alphabet);
            return std::nullopt;
        case Kind::star:
        case Kind::plus:
            if (const auto found = part(0))
                return part_is(language, *found, 0, ", as a part of it is", alphabet);
            return std::nullopt;
        case Kind::reversed:
            if (const auto found = part(0)) return part_is(language, *found, 0, "", alphabet);
            return std::nullopt;
        case Kind::concatenated:
            for (const std::size_t i : {0u, 1u})
                if (judge_empty(language->parts[1 - i], alphabet, budget).truth == Truth::refuted)
                    if (const auto found = part(i))
                        return part_is(language, *found, i, ", as the other part has a word",
                                       alphabet);
            return std::nullopt;
        default:
            return std::nullopt;
    }
}

/// Whether L(G) meets a regular language, where the expression is an intersection of such.
std::optional<Judgement> disjoint(const Language& language, const Alphabet& alphabet,
                                  const Budget& budget) {
    if (language->kind != Kind::intersected) return std::nullopt;
    for (const std::size_t i : {0u, 1u}) {
        const LanguageTree& part = *language->parts[i];
        if (part.kind != Kind::generated || !part.system->tables) continue;
        if (has_system(language->parts[1 - i])) continue;  // then it is worked out otherwise
        const auto regular = regular_value(language->parts[1 - i], alphabet, budget);
        if (!regular) continue;
        const Meeting meeting = first_meeting(*part.system->tables, *regular, budget);
        const std::string name = to_string(language, alphabet);
        if (meeting.derivation) {
            const Word& word = meeting.derivation->words.back();
            return Judgement::refuted({spell(alphabet, word) + " is a word of " + name + ": " +
                                       arrows(*meeting.derivation, alphabet) + "."},
                                      word_proof(word, alphabet));
        }
        return Judgement::proved({"No word of L(" + part.system->name + ") is in " +
                                  to_string(language->parts[1 - i], alphabet) + ": " +
                                  relations_text(meeting, *part.system->tables) +
                                  ", and no generation before has such a word."},
                                 {{"by", "relations"}});
    }
    return std::nullopt;
}

Judgement with(Truth truth, std::vector<std::string> argument, const std::string& last) {
    argument.push_back(last);
    const Json proof{{"by", "values"}};
    return truth == Truth::proved ? Judgement::proved(std::move(argument), proof)
                                  : Judgement::refuted(std::move(argument), proof);
}

}  // namespace

Judgement judge_finite(const Language& language, const Alphabet& alphabet, const Budget& budget) {
    if (const auto known = finite_value(language, alphabet, budget))
        return with(
            Truth::proved, known->argument,
            to_string(language, alphabet) + " has " + counted(known->words.size(), "word") + ".");
    if (auto found = infinite(language, alphabet, budget)) return *found;
    if (const auto tables = table_value(language, alphabet, budget)) {
        const TablesFiniteness found = finiteness(tables->system, budget);
        if (found.finite)
            return Judgement::proved({tables->argument, "The language of this system is finite."},
                                     {{"by", "values"}});
        Judgement result = endless_tables(to_string(language, alphabet), tables->system,
                                          *found.endless, *tables->system.alphabet, "it");
        result.argument.insert(result.argument.begin(), tables->argument);
        result.proof = std::make_shared<const Json>(construction_proof(*tables));
        return result;
    }
    return Judgement::undecided(
        {"no finite set was found for it, and nothing that makes it infinite"});
}

Judgement judge_empty(const Language& language, const Alphabet& alphabet, const Budget& budget) {
    const auto has = [&](const Word& word, const std::string& why) {
        return Judgement::refuted(
            {spell(alphabet, word) + " is a word of " + to_string(language, alphabet) + why + "."},
            word_proof(word, alphabet));
    };
    if (auto found = disjoint(language, alphabet, budget)) return *found;
    if (const auto known = finite_value(language, alphabet, budget)) {
        if (!known->words.empty()) return has(known->words.front(), "");
        return with(Truth::proved, known->argument,
                    to_string(language, alphabet) + " has no word.");
    }
    if (const auto regular = regular_value(language, alphabet, budget)) {
        if (const auto word = shortest_word(*regular)) return has(*word, "");
        return with(Truth::proved, {},
                    to_string(language, alphabet) +
                        " is regular, and its minimal automaton accepts no word.");
    }
    if (const auto tables = table_value(language, alphabet, budget)) {
        const Meeting meeting = first_word(tables->system, budget);
        if (meeting.derivation) return has(meeting.derivation->words.back(), "");
        return Judgement::proved(
            {tables->argument,
             "No sequence of tables makes terminals of all letters of its axiom."},
            construction_proof(*tables));
    }
    Judgement compared = judge_equality(language, words_language({}), alphabet, budget);
    if (compared.truth == Truth::refuted) return compared;
    return Judgement::undecided({"no word of it was found, and no reason why there is none"});
}

Judgement judge_size(const Language& language, const Integer& size, const Alphabet& alphabet,
                     const Budget& budget) {
    if (const auto known = finite_value(language, alphabet, budget)) {
        const bool right = Integer(known->words.size()) == size;
        return with(
            right ? Truth::proved : Truth::refuted, known->argument,
            to_string(language, alphabet) + " has " + counted(known->words.size(), "word") + ".");
    }
    if (const auto regular = regular_value(language, alphabet, budget))
        if (const auto count = number_of_words(*regular))
            return with(*count == size ? Truth::proved : Truth::refuted, {},
                        to_string(language, alphabet) + " has " + to_string(*count) +
                            (*count == 1 ? " word" : " words") +
                            ": so many its automaton accepts.");
    if (auto found = infinite(language, alphabet, budget)) {
        found->proof =
            std::make_shared<const Json>(Json{{"by", "infinite"}, {"proof", *found->proof}});
        return *found;
    }
    return Judgement::undecided({"no finite set was found for it"});
}

}  // namespace algae
