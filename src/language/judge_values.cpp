#include <algorithm>

#include "language/detail/interactive.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/powers.hpp"
#include "language/detail/proof.hpp"
#include "model/model.hpp"
#include "rewrite/rewrite.hpp"
#include "turtle/turtle.hpp"
#include "word/word.hpp"

// Whether a language is finite, empty, or has a given number of words.
//
// If the words can be listed they are. That a language is infinite is shown by a word that can be pumped
// through its automaton, by a round of rules or tables in a system, or by an infinite part. Emptiness of an
// intersection of L(G) with a regular language is a meeting.

namespace algae {

namespace {

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

Answer endless_round(const std::string& name, const OL& system) {
    const EndlessRound round = *finiteness(system).round;
    steps::InfiniteRound found{name, {}, round.other};
    for (const RuleUse& use : round.rules)
        found.rules.emplace_back(use.letter, system.successors[use.letter][use.choice]);
    return refuted(std::move(found));
}

std::optional<Answer> infinite_generated(const Language& language, const Budget& budget) {
    const SourceSystem& source = *language->system;
    if (!source.tables) {
        if (auto found = endless_measure(source, budget)) return refuted(*std::move(found));
        return std::nullopt;
    }
    const TablesFiniteness found = finiteness(*source.tables, budget);
    if (found.finite) return std::nullopt;
    if (source.tables->tables.size() == 1 && has_only_terminals(*source.tables))
        return endless_round(source.name, without_terminals(*source.tables));
    return refuted(steps::InfiniteTables{
        source.name, std::make_shared<const TableValue>(TableValue{*source.tables, language, {}}),
        false, *found.endless});
}

/// A proof that the language is infinite, if one is found; then the judgement on finiteness is `refuted`.
std::optional<Answer> infinite(const Language& language, const Alphabet& alphabet,
                               const Budget& budget) {
    budget.check();
    if (language->kind == Kind::powers) return refuted(steps::LongerPowers{language});
    if (const auto regular = regular_value(language, alphabet, budget)) {
        const auto found = pump(regular->automaton());
        if (!found) return std::nullopt;
        return refuted(steps::Pumped{language, found->prefix, found->middle, found->suffix});
    }
    if (language->kind == Kind::generated) return infinite_generated(language, budget);
    const auto part = [&](std::size_t i) -> std::optional<Answer> {
        const auto found = infinite(language->parts[i], alphabet, budget);
        if (!found) return std::nullopt;
        return refuted(steps::InfinitePart{language, i, found->proof});
    };
    switch (language->kind) {
        case Kind::united:
            if (auto found = part(0)) return found;
            return part(1);
        case Kind::star:
        case Kind::plus:
        case Kind::reversed:
            return part(0);
        case Kind::concatenated:
            for (const std::size_t i : {0u, 1u})
                if (judge_empty(language->parts[1 - i], alphabet, budget).truth == Truth::refuted)
                    if (auto found = part(i)) return found;
            return std::nullopt;
        default:
            return std::nullopt;
    }
}

/// Whether L(G), or a language of powers, meets a regular language, where the expression is an intersection of such.
std::optional<Answer> disjoint(const Language& language, const Alphabet& alphabet,
                               const Budget& budget) {
    if (language->kind != Kind::intersected) return std::nullopt;
    for (const std::size_t i : {0u, 1u}) {
        const LanguageTree& part = *language->parts[i];
        const bool is_system = part.kind == Kind::generated && part.system->tables;
        if (!is_system && part.kind != Kind::powers) continue;
        if (has_system(language->parts[1 - i])) continue;  // then it is worked out otherwise
        const auto regular = regular_value(language->parts[1 - i], alphabet, budget);
        if (!regular) continue;
        const ET0L system =
            is_system ? *part.system->tables : system_of(*part.powers, alphabet, budget);
        const Meeting meeting = first_meeting(system, *regular, budget);
        if (meeting.derivation) {
            steps::FoundWord found{language, meeting.derivation->words.back()};
            if (is_system) found.derivation = *meeting.derivation;
            return refuted(std::move(found));
        }
        return proved(
            steps::Disjoint{language->parts[i], language->parts[1 - i], repeated(meeting, system)});
    }
    return std::nullopt;
}

}  // namespace

std::vector<Word> first_words(const LanguageTree& tree, const Budget& budget) {
    constexpr std::size_t first = 40, longest = 20, most_factors = 5;
    std::vector<Word> words;
    if (tree.kind == Kind::generated && tree.system->interactive) {
        for (Word& word :
             found_words(*tree.system->interactive, {first, 20 * first, {}}, budget).words)
            if (word.size() <= longest) words.push_back(std::move(word));
    } else if (tree.kind == Kind::generated && tree.system->tables) {
        words.push_back(tree.system->tables->axiom);
    } else if (tree.kind == Kind::words) {
        words.assign(tree.words.begin(), tree.words.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                  first, tree.words.size())));
    } else if (tree.kind == Kind::complement) {
        words.emplace_back();
        for (const Symbol a : tree.letters) words.push_back({a});
        for (const Symbol a : tree.letters)
            for (const Symbol b : tree.letters) words.push_back({a, b});
    } else if (tree.kind == Kind::concatenated) {
        auto left = first_words(*tree.parts[0], budget),
             right = first_words(*tree.parts[1], budget);
        left.resize(std::min(left.size(), most_factors));
        right.resize(std::min(right.size(), most_factors));
        for (const Word& one : left)
            for (const Word& other : right) {
                words.push_back(one);
                words.back().insert(words.back().end(), other.begin(), other.end());
            }
    } else if (tree.kind == Kind::image) {
        for (const Word& word : first_words(*tree.parts[0], budget))
            if (auto image = tree.morphism.image_of(word)) words.push_back(std::move(*image));
    } else {
        for (const Language& part : tree.parts)
            for (Word& word : first_words(*part, budget)) {
                if (tree.kind == Kind::reversed) std::reverse(word.begin(), word.end());
                words.push_back(std::move(word));
            }
    }
    return words;
}

Answer judge_finite(const Language& language, const Alphabet& alphabet, const Budget& budget) {
    if (const auto known = finite_value(language, alphabet, budget))
        return proved(steps::Counted{known->known, language, Integer(known->words.size()), false});
    if (auto found = infinite(language, alphabet, budget)) return *found;
    if (auto tables = table_value(language, alphabet, budget)) {
        TablesFiniteness found = finiteness(tables->system, budget);
        if (found.finite) return proved(steps::FiniteConstruction{std::move(*tables)});
        return refuted(steps::InfiniteTables{
            {}, std::make_shared<const TableValue>(std::move(*tables)), true, *found.endless});
    }
    return undecided("no finite set was found for it, and nothing that makes it infinite");
}

Answer judge_empty(const Language& language, const Alphabet& alphabet, const Budget& budget) {
    const auto has = [&](const Word& word) { return refuted(steps::FoundWord{language, word}); };
    if (auto found = disjoint(language, alphabet, budget)) return *found;
    if (has_context(language))  // a word is found sooner than whether there are finitely many
        for (const Word& word : first_words(*language, budget))
            if (Answer found = judge_membership(language, word, alphabet, budget);
                found.truth == Truth::proved)
                return refuted(steps::Distinguished{
                    word, std::move(found),
                    judge_membership(words_language({}), word, alphabet, budget)});
    if (language->kind == Kind::powers) {
        std::vector<std::uint64_t> least;
        for (const Powers::Number& number : language->powers->numbers)
            least.push_back(number.least);
        return has(word_of(*language->powers, least, budget));
    }
    if (const auto known = finite_value(language, alphabet, budget)) {
        if (!known->words.empty()) return has(known->words.front());
        return proved(steps::NoWord{known->known, language, false});
    }
    if (const auto regular = regular_value(language, alphabet, budget)) {
        if (const auto word = shortest_word(*regular)) return has(*word);
        return proved(steps::NoWord{{}, language, true});
    }
    if (auto tables = table_value(language, alphabet, budget)) {
        const Meeting meeting = first_word(tables->system, budget);
        if (meeting.derivation) return has(meeting.derivation->words.back());
        return proved(steps::NoTerminals{std::move(*tables)});
    }
    if (has_context(language)) {
        Answer compared = judge_inclusion(language, words_language({}), alphabet, budget);
        if (compared.truth != Truth::undecided) return compared;
    }
    Answer compared = judge_equality(language, words_language({}), alphabet, budget);
    if (compared.truth == Truth::refuted) return compared;
    return undecided("no word of it was found, and no reason why there is none");
}

Answer judge_size(const Language& language, const Integer& size, const Alphabet& alphabet,
                  const Budget& budget) {
    if (const auto known = finite_value(language, alphabet, budget)) {
        const Integer count(known->words.size());
        return decided(count == size, steps::Counted{known->known, language, count, false});
    }
    if (const auto regular = regular_value(language, alphabet, budget))
        if (const auto count = number_of_words(*regular))
            return decided(*count == size, steps::Counted{{}, language, *count, true});
    if (const auto found = infinite(language, alphabet, budget))
        return refuted(steps::InfiniteSize{found->proof});
    return undecided("no finite set was found for it");
}

// Statements about systems whose words are derived module by module: with parameters, probabilities, contexts
// of trees or environments.
//
// The two words of a statement are read as one axiom, so that their modules are numbered alike and constants
// are evaluated as the system does. A system with probabilities is asked for the whole distribution; an open
// system develops with its environments.

namespace {

constexpr std::size_t longest_shown = 200;

/// A system and the two words that a statement is about, their modules numbered alike.
struct Derived {
    Rewriting rewriting;
    ModuleString from, to;
    std::uint64_t steps;
    std::string name;

    std::string text(const ModuleString& word) const {
        const std::string all =
            ModuleText(rewriting.rules().system->alphabet, rewriting.rules().kinds).text(word);
        return all.size() > longest_shown ? "a word of " + counted(word.kinds.size(), "module")
                                          : all;
    }
};

/// The first modules of a word, and those behind them.
std::pair<ModuleString, ModuleString> parted(const ModuleString& word, const ModuleKinds& kinds,
                                             std::size_t first) {
    std::size_t values = 0;
    for (std::size_t i = 0; i < first; ++i) values += kinds.arity(word.kinds[i]);
    const auto letter = word.kinds.begin() + static_cast<std::ptrdiff_t>(first);
    const auto value = word.values.begin() + static_cast<std::ptrdiff_t>(values);
    return {{{word.kinds.begin(), letter}, {word.values.begin(), value}},
            {{letter, word.kinds.end()}, {value, word.values.end()}}};
}

Derived course(const Rewrites& said, const Budget& budget) {
    LSystem both = *said.system;  // its axiom: the two words one after the other
    if (said.from) both.axiom = *said.from;
    const std::size_t first = both.axiom.letters.size();
    const ModuleWord& goal = said.word;
    both.axiom.letters.insert(both.axiom.letters.end(), goal.letters.begin(), goal.letters.end());
    for (const auto& [position, arguments] : goal.arguments)
        both.axiom.arguments[first + position] = arguments;
    RewritingChoices choices;
    choices.arithmetic = class_of(both).open ? Arithmetic::doubles : Arithmetic::exact;
    Rewriting rewriting(both, choices, budget);
    auto [from, to] = parted(rewriting.axiom(), rewriting.rules().kinds, first);
    return {std::move(rewriting), std::move(from), std::move(to), said.steps, both.name};
}

/// Whether two words are the same. Throws BoundReached where enclosures do not tell.
bool are_same(const Derived& course, const ModuleString& left, const ModuleString& right) {
    if (left.kinds != right.kinds) return false;
    const WordValues* const held = course.rewriting.rules().kinds.words();
    bool known = true;
    for (std::size_t i = 0; i < left.values.size(); ++i) {
        const std::optional<bool> equal = held ? held->equal(left.values[i], right.values[i])
                                               : same_value(left.values[i], right.values[i]);
        if (equal == false) return false;
        known = known && equal.has_value();
    }
    if (!known)
        throw BoundReached(Bound::method, "the numbers of " + course.text(left) + " and " +
                                              course.text(right) +
                                              " are not rational and too close to tell apart");
    return true;
}

/// How likely the word is, of how many.
steps::Likely likely(const Derived& course, const Budget& budget) {
    const auto all = distribution(course.rewriting, course.from, course.steps, {}, budget);
    steps::Likely found{
        course.name, course.text(course.from), course.text(course.to), course.steps, all.size(),
        {}};
    for (const LikelyWord& word : all)
        if (are_same(course, word.word, course.to)) found.probability += word.probability;
    return found;
}

/// The words from the first to the last.
Answer derived(const Derived& course, const Budget& budget) {
    ModuleString word = course.from;
    steps::Rewrites found{course.name, course.steps, {course.text(word)}, true, false};
    std::size_t characters = found.words.front().size();
    for (std::uint64_t n = 0; n < course.steps; ++n) {
        budget.check();
        word = course.rewriting.next(word, n, 0, budget);
        found.all_shown = found.all_shown && characters <= 2 * longest_shown;
        if (!found.all_shown) continue;
        found.words.push_back(course.text(word));
        characters += found.words.back().size() + 4;  // with the arrow
    }
    if (!found.all_shown) found.words.push_back(course.text(word));
    found.holds = are_same(course, word, course.to);
    return decided(found.holds, std::move(found));
}

/// The words of an open system, whose communication modules its environments fill.
Answer developed(const Rewrites& said, const Derived& course, const Budget& budget) {
    Model own{*said.system, said.written->drawing, {}, {}};
    if (said.from) own.axiom = *said.from;
    OpenDevelopment development(own, {}, nullptr, budget);
    const auto text = [&] {
        return ModuleText(development.rules().system->alphabet, development.rules().kinds)
            .text(development.word());
    };
    std::string word = text();
    std::size_t characters = word.size();
    steps::Develops found{course.name, {word}, false};
    for (std::uint64_t n = 1; n <= course.steps; ++n) {
        development.go_to(n, {}, budget);
        word = text();
        if (characters > 2 * longest_shown) continue;
        found.words.push_back(word);
        characters += word.size() + 4;
    }
    found.holds = word == ModuleText(course.rewriting.rules().system->alphabet,
                                     course.rewriting.rules().kinds)
                              .text(course.to);
    return decided(found.holds, std::move(found));
}

bool is_random(const Derived& course) {
    const auto& tables = course.rewriting.rules().tables;
    return std::any_of(tables.begin(), tables.end(),
                       [](const RuleSet& set) { return set.has_probabilities; });
}

}  // namespace

Answer judge_rewriting(const Rewrites& said, const Budget& budget) {
    const Derived begun = course(said, budget);
    if (class_of(*said.system).open) return developed(said, begun, budget);
    if (!is_random(begun)) return derived(begun, budget);
    const steps::Likely found = likely(begun, budget);
    return decided(!found.probability.is_zero(), found);
}

Answer judge_chance(const HasChance& said, const Budget& budget) {
    const steps::Likely found = likely(course(said.derivation, budget), budget);
    return decided(found.probability == said.probability, found);
}

}  // namespace algae
