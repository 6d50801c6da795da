#include "verify/within_regular.hpp"

#include <numeric>

#include "base/error.hpp"
#include "verify/derivatives.hpp"
#include "verify/relations.hpp"
#include "verify/values.hpp"

namespace algae::verify {

namespace {

Language complement_of(const Language& part, const Alphabet& alphabet) {
    Tree tree;
    tree.kind = Tree::Kind::complement;
    tree.letters.resize(alphabet.size());
    std::iota(tree.letters.begin(), tree.letters.end(), Symbol{0});
    tree.parts = {part};
    return std::make_shared<const Tree>(std::move(tree));
}

Language either(const Language& left, const Language& right) {
    return combination(Tree::Kind::united, {left, right});
}

/// The words whose images are in the language or that have no image.
Language before_image(const std::map<Symbol, Word>& morphism, const Language& language,
                      const Alphabet& alphabet) {
    Tree tree;
    tree.kind = Tree::Kind::inverse_image;
    tree.morphism = morphism;
    tree.parts = {language};
    std::vector<Word> letters;
    for (const auto& [a, image] : morphism) letters.push_back({a});
    const Language with_image = combination(Tree::Kind::star, {words_of(std::move(letters))});
    return either(std::make_shared<const Tree>(std::move(tree)),
                  complement_of(with_image, alphabet));
}

bool generated_within(const System& system, const Language& right, const Alphabet& alphabet,
                      const Budget& budget) {
    Derivatives derivatives(alphabet, budget);
    const auto automaton = derivatives.automaton(derivatives.term(right));
    const std::size_t states = automaton.next.size();
    if (system.context) {
        Tree leaf;
        leaf.kind = Tree::Kind::generated;
        leaf.system = std::make_shared<const System>(system);
        for (const Word& word : finite_values_of_leaf(leaf, budget)) {
            std::size_t state = 0;
            for (const Symbol a : word) state = automaton.next[state][a];
            if (!automaton.accepting[state]) return false;
        }
        return true;
    }
    budget.check_memory(states * states / 8, "the relations between derivatives");
    Relations start;
    for (const Symbol a : accessible_letters(system, system.axiom)) {
        BooleanMatrix relation(states);
        if (system.terminal[a])
            for (std::size_t i = 0; i < states; ++i) relation.set(i, automaton.next[i][a]);
        start.emplace(a, std::move(relation));
    }
    const auto leaves = [&](const Relations& relations) {
        const BooleanMatrix words = relation_of(system.axiom, relations, states);
        for (std::size_t i = 0; i < states; ++i)
            if (words.at(0, i) && !automaton.accepting[i]) return true;
        return false;
    };
    return !some_relations(system, start, states, leaves, budget);
}

}  // namespace

bool within_regular(const Language& left, const Language& right, const Alphabet& alphabet,
                    const Budget& budget) {
    const auto both_within = [&](const Language& language, const Language& wider) {
        return within_regular(language, wider, alphabet, budget);
    };
    switch (left->kind) {
        case Tree::Kind::generated:
            return generated_within(*left->system, right, alphabet, budget);
        case Tree::Kind::united:
            return both_within(left->parts[0], right) && both_within(left->parts[1], right);
        case Tree::Kind::reversal:
            return both_within(left->parts[0], combination(Tree::Kind::reversal, {right}));
        case Tree::Kind::image:
            return both_within(left->parts[0], before_image(left->morphism, right, alphabet));
        case Tree::Kind::intersection:
            for (const std::size_t i : {0u, 1u})
                if (is_regular(left->parts[1 - i]))
                    return both_within(left->parts[i],
                                       either(right, complement_of(left->parts[1 - i], alphabet)));
            break;
        case Tree::Kind::difference:
            if (is_regular(left->parts[1]))
                return both_within(left->parts[0], either(right, left->parts[1]));
            break;
        default:
            break;
    }
    if (is_regular(left)) {
        Derivatives derivatives(alphabet, budget);
        return derivatives.included(derivatives.term(left), derivatives.term(right));
    }
    throw Error(
        "the left side is not made of systems by union, image, reversal, and intersection and "
        "difference with regular expressions");
}

}  // namespace algae::verify
