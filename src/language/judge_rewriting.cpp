#include "language/detail/judge.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

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
    std::string in_steps() const { return " in " + counted(steps, "step"); }
    std::string line() const { return name + ": " + text(from) + " ==> "; }
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

Derived course(const Rewrites& said) {
    LSystem both = *said.system;  // its axiom: the two words one after the other
    if (said.from) both.axiom = *said.from;
    const std::size_t first = both.axiom.letters.size();
    const ModuleWord& goal = said.word;
    both.axiom.letters.insert(both.axiom.letters.end(), goal.letters.begin(), goal.letters.end());
    for (const auto& [position, arguments] : goal.arguments)
        both.axiom.arguments[first + position] = arguments;
    Rewriting rewriting(both);
    auto [from, to] = parted(rewriting.axiom(), rewriting.rules().kinds, first);
    return {std::move(rewriting), std::move(from), std::move(to), said.steps, both.name};
}

nlohmann::ordered_json proof() { return {{"by", "rewriting"}}; }

/// How likely the word is, of how many.
struct Chance {
    Rational probability;
    std::size_t words = 0;
};

Chance chance_of(const Derived& course, const Budget& budget) {
    const auto all = distribution(course.rewriting, course.from, course.steps, {}, budget);
    Chance chance{{}, all.size()};
    for (const LikelyWord& likely : all)
        if (likely.word == course.to) chance.probability = likely.probability;
    return chance;
}

std::string chance_sentence(const Derived& course, const Chance& chance) {
    const std::string derived = course.name + ": " + course.text(course.from) + " derives " +
                                counted(chance.words, "word") + course.in_steps();
    if (chance.probability.is_zero())
        return derived + ", and " + course.text(course.to) +
               " is none of them: its probability is 0.";
    return derived + "; the probability of " + course.text(course.to) + " is " +
           to_string(chance.probability) +
           ", the sum over its derivations of the products of the rules' probabilities.";
}

/// The words from the first to the last.
Judgement derived(const Derived& course, const Budget& budget) {
    ModuleString word = course.from;
    std::string arrows = course.text(word);
    bool all_shown = true;
    for (std::uint64_t n = 0; n < course.steps; ++n) {
        budget.check();
        word = course.rewriting.next(word, n, 0, budget);
        all_shown = all_shown && arrows.size() <= 2 * longest_shown;
        if (all_shown) arrows += " => " + course.text(word);
    }
    const std::string line = course.line() + course.text(word) + course.in_steps();
    if (word != course.to) return Judgement::refuted({line + ", and nothing else."}, proof());
    return Judgement::proved({line + (course.steps > 1 && all_shown ? ": " + arrows + "." : ".")},
                             proof());
}

/// The words of an open system, whose communication modules its environments fill.
Judgement developed(const Rewrites& said, const Derived& course, const Budget& budget) {
    LSystem own = *said.system;
    if (said.from) own.axiom = *said.from;
    OpenDevelopment development(own, {}, nullptr, budget);
    const auto text = [&] {
        return ModuleText(development.rules().system->alphabet, development.rules().kinds)
            .text(development.word());
    };
    std::string word = text(), arrows = word;
    for (std::uint64_t n = 1; n <= course.steps; ++n) {
        development.go_to(n, {}, budget);
        word = text();
        if (arrows.size() <= 2 * longest_shown) arrows += " => " + word;
    }
    const std::string line = course.name + ", with its environments: " + arrows;
    const nlohmann::ordered_json by{{"by", "environment"}};
    const std::string wanted =
        ModuleText(course.rewriting.rules().system->alphabet, course.rewriting.rules().kinds)
            .text(course.to);
    return word == wanted ? Judgement::proved({line + "."}, by)
                          : Judgement::refuted({line + ", and nothing else."}, by);
}

bool is_random(const Derived& course) {
    const auto& tables = course.rewriting.rules().tables;
    return std::any_of(tables.begin(), tables.end(),
                       [](const RuleSet& set) { return set.has_probabilities; });
}

}  // namespace

Judgement judge_rewriting(const Rewrites& said, const Budget& budget) {
    const Derived begun = course(said);
    if (class_of(*said.system).open) return developed(said, begun, budget);
    if (!is_random(begun)) return derived(begun, budget);
    const Chance chance = chance_of(begun, budget);
    const std::vector<std::string> argument{chance_sentence(begun, chance)};
    return chance.probability.is_zero() ? Judgement::refuted(argument, proof())
                                        : Judgement::proved(argument, proof());
}

Judgement judge_chance(const HasChance& said, const Budget& budget) {
    const Derived begun = course(said.derivation);
    const Chance chance = chance_of(begun, budget);
    const std::vector<std::string> argument{chance_sentence(begun, chance)};
    return chance.probability == said.probability ? Judgement::proved(argument, proof())
                                                  : Judgement::refuted(argument, proof());
}

}  // namespace algae
