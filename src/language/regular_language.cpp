#include "language/regular_language.hpp"

#include <algorithm>
#include <unordered_map>

namespace algae {

namespace {

/// Both automata side by side; `accepts` says from the two whether to accept.
template <class Accepts>
RegularLanguage product(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget, Accepts accepts) {
    const std::size_t letters = std::max(left.automaton().letters, right.automaton().letters);
    const Dfa a = widened(left.automaton(), letters), b = widened(right.automaton(), letters);
    Dfa found{letters, 0, {}, {}};
    std::unordered_map<std::size_t, std::size_t> number;  // of a pair as one number
    std::vector<std::size_t> pairs;
    const auto number_of = [&](std::size_t s, std::size_t t) {
        const auto [place, is_new] = number.try_emplace(s * b.states() + t, pairs.size());
        if (is_new) {
            pairs.push_back(place->first);
            found.accepting.push_back(accepts(a.accepting[s] != 0, b.accepting[t] != 0));
        }
        return place->second;
    };
    number_of(a.initial, b.initial);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (i % 1024 == 0) {
            budget.check();
            budget.check_memory(pairs.size() * (letters + 8) * sizeof(std::size_t), "a product of automata");
        }
        for (Symbol letter = 0; letter < letters; ++letter)
            found.transitions.push_back(number_of(a.step(pairs[i] / b.states(), letter), b.step(pairs[i] % b.states(), letter)));
    }
    return RegularLanguage(found);
}

}  // namespace

RegularLanguage finite_set(const std::vector<Word>& words) {
    // A tree of the words' beginnings; state 1 refuses whatever comes.
    std::size_t letters = 0;
    for (const Word& word : words)
        for (const Symbol a : word) letters = std::max<std::size_t>(letters, a + 1);
    Dfa tree{letters, 0, {0, 0}, std::vector<std::size_t>(2 * letters, 1)};
    for (const Word& word : words) {
        std::size_t state = 0;
        for (const Symbol a : word) {
            if (tree.step(state, a) == 1) {
                tree.transitions[state * letters + a] = tree.states();
                tree.accepting.push_back(0);
                tree.transitions.resize(tree.states() * letters, 1);
            }
            state = tree.step(state, a);
        }
        tree.accepting[state] = 1;
    }
    return RegularLanguage(tree);
}

RegularLanguage all_words(const std::vector<Symbol>& letters) {
    Nfa loop;
    loop.initial.push_back(loop.add_state(true));
    for (const Symbol a : letters) loop.states[0].moves.emplace_back(a, 0);
    return RegularLanguage(loop);
}

RegularLanguage united(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget) {
    return product(left, right, budget, [](bool l, bool r) { return l || r; });
}

RegularLanguage intersected(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget) {
    return product(left, right, budget, [](bool l, bool r) { return l && r; });
}

RegularLanguage difference(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget) {
    return product(left, right, budget, [](bool l, bool r) { return l && !r; });
}

RegularLanguage symmetric_difference(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget) {
    return product(left, right, budget, [](bool l, bool r) { return l != r; });
}

RegularLanguage complement(const RegularLanguage& language, const std::vector<Symbol>& letters, const Budget& budget) {
    return difference(all_words(letters), language, budget);
}

RegularLanguage concatenated(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget) {
    Nfa both = as_nfa(left.automaton());
    const std::size_t size = both.states.size();
    const Nfa second = as_nfa(right.automaton());
    const std::size_t shift = both.add_states(second);
    for (std::size_t s = 0; s < size; ++s) {
        if (!both.states[s].accepting) continue;
        both.states[s].accepting = false;
        for (const std::size_t begin : second.initial) both.states[s].silent.push_back(begin + shift);
    }
    return RegularLanguage(both, budget);
}

RegularLanguage plus(const RegularLanguage& language, const Budget& budget) {
    Nfa again = as_nfa(language.automaton());
    for (Nfa::State& state : again.states)
        if (state.accepting) state.silent.insert(state.silent.end(), again.initial.begin(), again.initial.end());
    return RegularLanguage(again, budget);
}

RegularLanguage star(const RegularLanguage& language, const Budget& budget) {
    return united(plus(language, budget), finite_set({Word{}}), budget);
}

RegularLanguage reversed(const RegularLanguage& language, const Budget& budget) {
    return RegularLanguage(reversed(as_nfa(language.automaton())), budget);
}

}  // namespace algae
