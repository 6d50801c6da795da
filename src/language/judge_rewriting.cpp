#include <algorithm>

#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"
#include "model/model.hpp"
#include "rewrite/rewrite.hpp"
#include "turtle/turtle.hpp"

// Statements about systems whose words are derived module by module: with parameters, probabilities, contexts
// of trees or environments.
//
// The two words of a statement are read as one axiom, so that their modules are numbered alike and constants
// are evaluated as the system does. A system with probabilities is asked for the whole distribution; an open
// system develops with its environments.

namespace algae {

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
