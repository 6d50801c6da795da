#include "language/regular_words.hpp"

#include <algorithm>

namespace algae {

namespace {

/// By state: the least number of letters to an accepting one; the number of states if there is none.
std::vector<std::size_t> distances(const Dfa& automaton) {
    std::vector<std::vector<std::size_t>> before(automaton.states());
    for (std::size_t s = 0; s < automaton.states(); ++s)
        for (Symbol a = 0; a < automaton.letters; ++a) before[automaton.step(s, a)].push_back(s);
    std::vector<std::size_t> distance(automaton.states(), automaton.states()), queue;
    for (std::size_t s = 0; s < automaton.states(); ++s)
        if (automaton.accepting[s]) {
            distance[s] = 0;
            queue.push_back(s);
        }
    for (std::size_t i = 0; i < queue.size(); ++i)
        for (const std::size_t s : before[queue[i]])
            if (distance[s] == automaton.states() && !automaton.accepting[s]) {
                distance[s] = distance[queue[i]] + 1;
                queue.push_back(s);
            }
    return distance;
}

/// The useful states in an order in which every step goes forward; nothing if there is a cycle.
std::optional<std::vector<std::size_t>> without_cycle(const Dfa& automaton) {
    const std::vector<std::size_t> distance = distances(automaton);
    const auto is_useful = [&](std::size_t s) { return distance[s] < automaton.states(); };
    std::vector<std::size_t> arrivals(automaton.states(), 0), order;
    std::size_t useful = 0;
    for (std::size_t s = 0; s < automaton.states(); ++s) {
        if (!is_useful(s)) continue;
        ++useful;
        for (Symbol a = 0; a < automaton.letters; ++a) ++arrivals[automaton.step(s, a)];
    }
    for (std::size_t s = 0; s < automaton.states(); ++s)
        if (is_useful(s) && arrivals[s] == 0) order.push_back(s);
    for (std::size_t i = 0; i < order.size(); ++i)
        for (Symbol a = 0; a < automaton.letters; ++a) {
            const std::size_t to = automaton.step(order[i], a);
            if (--arrivals[to] == 0 && is_useful(to)) order.push_back(to);
        }
    if (order.size() < useful) return std::nullopt;
    return order;
}

}  // namespace

bool is_empty(const RegularLanguage& language) { return language == RegularLanguage(); }

std::optional<Word> shortest_word(const RegularLanguage& language) {
    if (is_empty(language)) return std::nullopt;
    const Dfa& automaton = language.automaton();
    const std::vector<std::size_t> distance = distances(automaton);
    Word word;
    for (std::size_t s = automaton.initial; distance[s] > 0;)
        for (Symbol a = 0; a < automaton.letters; ++a)
            if (distance[automaton.step(s, a)] + 1 == distance[s]) {
                word.push_back(a);
                s = automaton.step(s, a);
                break;
            }
    return word;
}

bool is_finite(const RegularLanguage& language) { return without_cycle(language.automaton()).has_value(); }

std::optional<Integer> number_of_words(const RegularLanguage& language) {
    const Dfa& automaton = language.automaton();
    const auto order = without_cycle(automaton);
    if (!order) return std::nullopt;
    std::vector<Integer> count(automaton.states(), Integer(0));  // of words accepted from each state
    for (std::size_t i = order->size(); i-- > 0;) {
        const std::size_t s = (*order)[i];
        count[s] = automaton.accepting[s] ? 1 : 0;
        for (Symbol a = 0; a < automaton.letters; ++a) count[s] += count[automaton.step(s, a)];
    }
    return count[automaton.initial];
}

Integer number_of_words(const RegularLanguage& language, std::size_t length) {
    const Dfa& automaton = language.automaton();
    std::vector<Integer> count(automaton.states(), Integer(0));
    for (std::size_t s = 0; s < automaton.states(); ++s) count[s] = automaton.accepting[s] ? 1 : 0;
    for (; length > 0; --length) {
        std::vector<Integer> longer(automaton.states(), Integer(0));
        for (std::size_t s = 0; s < automaton.states(); ++s)
            for (Symbol a = 0; a < automaton.letters; ++a) longer[s] += count[automaton.step(s, a)];
        count = std::move(longer);
    }
    return count[automaton.initial];
}

std::vector<Word> words_up_to(const RegularLanguage& language, std::size_t longest, const Budget& budget) {
    const Dfa& automaton = language.automaton();
    const std::vector<std::size_t> distance = distances(automaton);
    std::vector<Word> found;
    std::uint64_t bytes = 0;
    std::vector<std::pair<Word, std::size_t>> beginnings;  // of one length, with the states they lead to
    if (distance[automaton.initial] <= longest && distance[automaton.initial] < automaton.states())
        beginnings.emplace_back(Word{}, automaton.initial);
    for (std::size_t length = 0; !beginnings.empty(); ++length) {
        budget.check();
        std::vector<std::pair<Word, std::size_t>> longer;
        for (const auto& [word, state] : beginnings) {
            if (automaton.accepting[state]) found.push_back(word);
            for (Symbol a = 0; a < automaton.letters; ++a) {
                const std::size_t to = automaton.step(state, a);
                if (distance[to] == automaton.states() || length + 1 + distance[to] > longest) continue;
                longer.emplace_back(word, to);
                longer.back().first.push_back(a);
                bytes += sizeof(Word) + longer.back().first.size() * sizeof(Symbol);
            }
            budget.check_memory(bytes, "the words up to that length");
        }
        beginnings = std::move(longer);
    }
    return found;
}

std::optional<Word> first_outside(const RegularLanguage& inner, const RegularLanguage& outer, const Budget& budget) {
    return shortest_word(difference(inner, outer, budget));
}

std::optional<Word> first_difference(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget) {
    return shortest_word(symmetric_difference(left, right, budget));
}

}  // namespace algae
