// How many derivations a word has in a system with context: against strings rewritten by the definition.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

struct Rules {
    struct Rule {
        std::string left;
        char letter;
        std::string right, successor;
    };
    std::string axiom;
    std::vector<Rule> rules;

    std::string text() const {
        std::string all = "axiom " + axiom;
        for (const auto& [left, letter, right, successor] : rules)
            all += "; " + (left.empty() ? "" : left + " < ") + letter +
                   (right.empty() ? "" : " > " + right) + " -> " + successor;
        return all;
    }

    /// What a letter of a word may become: the rules with the longest contexts, the first ones of the file.
    std::set<std::string> successors(const std::string& word, std::size_t place) const {
        const std::string before = word.substr(0, place), behind = word.substr(place + 1);
        const Rule* best = nullptr;
        for (const Rule& rule : rules)
            if (rule.letter == word[place] && before.ends_with(rule.left) &&
                behind.starts_with(rule.right) &&
                (!best ||
                 rule.left.size() + rule.right.size() > best->left.size() + best->right.size()))
                best = &rule;
        if (!best) return {std::string(1, word[place])};
        std::set<std::string> all;
        for (const Rule& rule : rules)
            if (rule.letter == best->letter && rule.left == best->left && rule.right == best->right)
                all.insert(rule.successor);
        return all;
    }

    /// The words of generation n of at most `longest` letters on all the way, each with its number of derivations.
    std::map<std::string, long> derivations(std::size_t n, std::size_t longest) const {
        std::map<std::string, long> counts;
        if (axiom.size() <= longest) counts[axiom] = 1;
        for (std::size_t t = 0; t < n; ++t) {
            std::map<std::string, long> next;
            for (const auto& [word, count] : counts) {
                std::vector<std::string> made{""};  // one for each way of choosing
                for (std::size_t i = 0; i < word.size(); ++i) {
                    std::vector<std::string> longer;
                    for (const std::string& start : made)
                        for (const std::string& successor : successors(word, i))
                            if (start.size() + successor.size() <= longest)
                                longer.push_back(start + successor);
                    made = std::move(longer);
                }
                for (const std::string& one : made) next[one] += count;
            }
            counts = std::move(next);
        }
        return counts;
    }
};

rc::Gen<Rules> any_rules() {
    return rc::gen::resize(
        100, rc::gen::exec([] {
            const auto word = [](std::size_t least, std::size_t most) {
                std::string made(*rc::gen::inRange(least, most + 1), ' ');
                for (char& c : made) c = *rc::gen::elementOf(std::string("ab"));
                return made;
            };
            Rules made{word(1, 3), {}};
            const std::size_t count = *rc::gen::inRange<std::size_t>(2, 6);
            for (std::size_t i = 0; i < count; ++i) {
                const std::size_t left = *rc::gen::inRange(0, 3) == 0,
                                  right = *rc::gen::inRange(0, 3) == 0;
                Rules::Rule rule{word(left, left), word(1, 1).front(), word(right, right),
                                 word(1, 2)};
                if (!made.rules.empty() && *rc::gen::inRange(0, 2) == 0) {  // a choice
                    const std::string successor = rule.successor;
                    rule = made.rules.back();
                    rule.successor = successor;
                }
                made.rules.push_back(rule);
            }
            return made;
        }));
}

IL system_of(const std::string& text) { return *as_il(read_lsystem(text, "x")); }

Word letters_of(const IL& system, const std::string& text) {
    Word word;
    for (const char c : text) word.push_back(system.alphabet->find(std::string(1, c)).value());
    return word;
}

bool knows(const IL& system, const std::string& text) {
    return std::all_of(text.begin(), text.end(), [&](char c) {
        return system.alphabet->find(std::string(1, c)).has_value();
    });
}

/// Whether the words follow from each other by the choices.
bool is_derivation_of(const IL& system, const Derivation& derivation) {
    if (derivation.words.front() != system.axiom ||
        derivation.choices.size() + 1 != derivation.words.size())
        return false;
    ContextStep step(system);
    for (std::size_t t = 0; t < derivation.choices.size(); ++t) {
        const auto successors = step.successors(derivation.words[t]);
        Word next;
        for (std::size_t i = 0; i < successors.size(); ++i) {
            const Word& one = successors[i]->at(derivation.choices[t].at(i));
            next.insert(next.end(), one.begin(), one.end());
        }
        if (next != derivation.words[t + 1]) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("derivations with contexts are counted as by the definition") {
    std::size_t compared = 0, many = 0, listed = 0;
    CHECK(rc::check("of n steps", [&] {
        const Rules rules = *any_rules();
        RC_LOG() << rules.text() << '\n';
        const IL system = system_of(rules.text());
        const std::size_t n = *rc::gen::inRange<std::size_t>(1, 6), longest = 5;
        const auto expected = rules.derivations(n, longest);
        std::set<std::string> tried{"a", "ab", "bab", "bbbb"};
        for (const auto& [word, count] : expected)
            if (tried.size() < 16 || count > 1) tried.insert(word);
        for (const std::string& word : tried) {
            if (!knows(system, word)) continue;
            const auto known = expected.find(word);
            const long count = known == expected.end() ? 0 : known->second;
            const Word letters = letters_of(system, word);
            RC_ASSERT(number_of_derivations(system, letters, n) == Integer(count));
            ++compared;
            many += count > 1;
            const std::size_t most = *rc::gen::inRange<std::size_t>(0, 100);
            const auto all = derivations(system, letters, n, most);
            RC_ASSERT(static_cast<long>(all.size()) == std::min(count, static_cast<long>(most)));
            std::set<std::tuple<std::vector<Word>, std::vector<std::vector<std::uint32_t>>>> apart;
            for (const Derivation& one : all) {
                RC_ASSERT(one.words.back() == letters);
                RC_ASSERT(one.words.size() == n + 1);
                RC_ASSERT(is_derivation_of(system, one));
                RC_ASSERT(apart.emplace(one.words, one.choices).second);
                ++listed;
            }
        }
    }));
    CHECK(compared > 300);
    CHECK(many > 1);
    CHECK(listed > 30);
}

TEST_CASE("all derivations with contexts, and whether they are finitely many") {
    std::size_t finite = 0, infinite = 0, members = 0;
    CHECK(rc::check("in all", [&] {
        const Rules rules = *any_rules();
        RC_LOG() << rules.text() << '\n';
        const IL system = system_of(rules.text());
        const std::string word = *rc::gen::elementOf(
            std::vector<std::string>{"a", "b", "ab", "ba", "aab", "bab", "bbb"});
        if (!knows(system, word)) return;
        const DerivationCounts found = derivation_counts(system, letters_of(system, word), 5);
        // There are at most 14 words so short: more steps than that come back to one of them.
        constexpr std::size_t words = 14;
        Integer sum = 0;
        std::map<std::uint64_t, long> by_steps;
        for (std::size_t n = 0; n <= 2 * words; ++n) {
            const auto counts = rules.derivations(n, word.size());
            if (counts.empty()) break;
            if (std::any_of(counts.begin(), counts.end(),
                            [](const auto& one) { return one.second > 1'000'000; }))
                return;  // soon more than a long holds
            const auto known = counts.find(word);
            if (known == counts.end()) continue;
            by_steps[n] = known->second;
            sum += known->second;
        }
        const bool is_infinite = !by_steps.empty() && by_steps.rbegin()->first >= words;
        RC_ASSERT(is_infinite == !found.total);
        if (found.total) RC_ASSERT(*found.total == sum);
        for (const auto& [steps, count] : found.by_steps)
            if (steps <= 2 * words) RC_ASSERT(Integer(by_steps[steps]) == count);
        const auto shortest = shortest_derivation(system, letters_of(system, word));
        RC_ASSERT(shortest.has_value() == !by_steps.empty());
        if (shortest) {
            RC_ASSERT(is_derivation_of(system, *shortest));
            RC_ASSERT(shortest->words.size() == by_steps.begin()->first + 1);
            RC_ASSERT(shortest->words.back() == letters_of(system, word));
            ++members;
        }
        ++(found.total ? finite : infinite);
    }));
    CHECK(finite > 10);
    CHECK(infinite > 0);
    CHECK(members > 2);
}

TEST_CASE("counts of derivations with contexts: by hand, long and without end") {
    const IL choices = il("ab", {"a > b -> aa", "a > b -> b"});
    CHECK(number_of_derivations(choices, {0, 0, 1}, 1) == 1);
    CHECK(number_of_derivations(choices, {0, 0, 1}, 7) == 0);
    CHECK(*derivation_counts(choices, {0, 0, 1}).total == 1);
    CHECK_FALSE(derivation_counts(choices, {1, 1}).total);  // bb stays
    CHECK(derivation_counts(choices, {1, 1}, 3).by_steps ==
          std::vector<DerivationCounts::Steps>{{1, 1}, {2, 1}, {3, 1}});
    CHECK(*derivation_counts(choices, {1, 0}).total == 0);
    // Each letter of a^40 becomes a or aa: those that double are chosen from 40.
    const IL wide = il(std::string(40, 'a'), {"a > b -> b", "a -> a", "a -> aa"});
    CHECK(number_of_derivations(wide, Word(60, 0), 1) == Integer("137846528820"));
    // With an erasing rule longer words may lead to short ones, so nothing but memory bounds the search.
    Budget small;
    small.memory = 100'000;
    const IL endless = il("ab", {"a > b -> aa", "a > a -> a", "a > a -> aa", "b -> b", "b > b ->"});
    CHECK_THROWS_AS(derivation_counts(endless, {1}, 3, small), BoundReached);
    Budget late;
    late.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    CHECK_THROWS_AS(derivation_counts(choices, {0, 0, 0, 0, 1}, 3, late), BoundReached);
}

TEST_CASE(
    "the tree of a derivation with contexts has its words and the letters that rules look at") {
    const Model model = read_lsystem("axiom ab; a > b -> aa | b", "x");
    const IL system = *as_il(model);
    const auto steps = shortest_derivation(system, letters_of(system, "abb"));
    REQUIRE(steps);
    CHECK(steps->words.size() == 3);
    const Rewriting rewriting(model, {.evenly = true});
    const ModuleTrace trace = traced(rewriting, system, *steps);
    const DerivationTree tree = derivation_tree(rewriting, trace);
    CHECK(tree.nodes.size() == 8);
    CHECK(context_count(tree) == 2);  // the b to the right of an a, in both steps
    std::string leaves_text;
    for (const Symbol a : leaves(tree)) leaves_text += tree.alphabet->name(a);
    CHECK(leaves_text == "abb");
}
