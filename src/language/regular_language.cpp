#include "language/detail/regular.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "language/detail/lengths.hpp"

// Operations on regular languages, their words, and a proof by induction that a regular language is within L(G).
//
// Boolean operations run over pairs of states of both automata; the others connect nondeterministic automata by
// silent moves. A letter that an automaton does not know leads to a state that refuses, so operands may have
// different alphabets (`widened`).
//
// Words are found through the distances of states to an accepting one: a shortest word follows decreasing
// distances, words up to a length are extended only while the distance still fits, and a language is finite if
// its useful states have no cycle, which also gives the order in which words are counted.
//
// Over one letter a word is its length, and the automaton a tail and a cycle. There the induction knows more: a step with rules that erase
// counts too, if only the length before was a smaller one.

namespace algae {

namespace {

/// Both automata side by side; `accepts` says from the two whether to accept.
template <class Accepts>
RegularLanguage product(const RegularLanguage& left, const RegularLanguage& right,
                        const Budget& budget, Accepts accepts) {
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
            budget.check_memory(pairs.size() * (letters + 8) * sizeof(std::size_t),
                                "a product of automata");
        }
        for (Symbol letter = 0; letter < letters; ++letter)
            found.transitions.push_back(number_of(a.step(pairs[i] / b.states(), letter),
                                                  b.step(pairs[i] % b.states(), letter)));
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

RegularLanguage united(const RegularLanguage& left, const RegularLanguage& right,
                       const Budget& budget) {
    return product(left, right, budget, [](bool l, bool r) { return l || r; });
}

RegularLanguage intersected(const RegularLanguage& left, const RegularLanguage& right,
                            const Budget& budget) {
    return product(left, right, budget, [](bool l, bool r) { return l && r; });
}

RegularLanguage difference(const RegularLanguage& left, const RegularLanguage& right,
                           const Budget& budget) {
    return product(left, right, budget, [](bool l, bool r) { return l && !r; });
}

RegularLanguage symmetric_difference(const RegularLanguage& left, const RegularLanguage& right,
                                     const Budget& budget) {
    return product(left, right, budget, [](bool l, bool r) { return l != r; });
}

RegularLanguage complement(const RegularLanguage& language, const std::vector<Symbol>& letters,
                           const Budget& budget) {
    return difference(all_words(letters), language, budget);
}

RegularLanguage concatenated(const RegularLanguage& left, const RegularLanguage& right,
                             const Budget& budget) {
    Nfa both = as_nfa(left.automaton());
    const std::size_t size = both.states.size();
    const Nfa second = as_nfa(right.automaton());
    const std::size_t shift = both.add_states(second);
    for (std::size_t s = 0; s < size; ++s) {
        if (!both.states[s].accepting) continue;
        both.states[s].accepting = false;
        for (const std::size_t begin : second.initial)
            both.states[s].silent.push_back(begin + shift);
    }
    return RegularLanguage(both, budget);
}

RegularLanguage plus(const RegularLanguage& language, const Budget& budget) {
    Nfa again = as_nfa(language.automaton());
    for (Nfa::State& state : again.states)
        if (state.accepting)
            state.silent.insert(state.silent.end(), again.initial.begin(), again.initial.end());
    return RegularLanguage(again, budget);
}

RegularLanguage star(const RegularLanguage& language, const Budget& budget) {
    return united(plus(language, budget), finite_set({Word{}}), budget);
}

RegularLanguage reversed(const RegularLanguage& language, const Budget& budget) {
    return RegularLanguage(reversed(as_nfa(language.automaton())), budget);
}

namespace {

template <class Image>
const Image& image_of(Symbol a, const std::vector<Image>& images) {
    if (a >= images.size()) throw Error("letter number " + std::to_string(a) + " has no image");
    return images[a];
}

/// The language of the automaton's states with other moves: `put(words, from, letter, to)` puts the words for the
/// letter between two states.
template <class Put>
RegularLanguage with_moves(const RegularLanguage& language, const Budget& budget, Put put) {
    const Nfa letters = as_nfa(language.automaton());
    Nfa words;
    for (const Nfa::State& state : letters.states) words.add_state(state.accepting);
    words.initial = letters.initial;
    for (std::size_t s = 0; s < letters.states.size(); ++s)
        for (const auto& [letter, to] : letters.states[s].moves) put(words, s, letter, to);
    return RegularLanguage(words, budget);
}

}  // namespace

RegularLanguage image(const RegularLanguage& language, const std::vector<Word>& images,
                      const Budget& budget) {
    return with_moves(language, budget,
                      [&](Nfa& words, std::size_t from, Symbol letter, std::size_t to) {
                          words.add_path(from, image_of(letter, images), to);
                      });
}

RegularLanguage image(const RegularLanguage& language, const std::vector<RegularLanguage>& images,
                      const Budget& budget) {
    return with_moves(language, budget,
                      [&](Nfa& words, std::size_t from, Symbol letter, std::size_t to) {
                          const Nfa part = as_nfa(image_of(letter, images).automaton());
                          const std::size_t shift = words.add_states(part);
                          for (const std::size_t begin : part.initial)
                              words.states[from].silent.push_back(begin + shift);
                          for (std::size_t t = shift; t < words.states.size(); ++t)
                              if (words.states[t].accepting) {
                                  words.states[t].accepting = false;
                                  words.states[t].silent.push_back(to);
                              }
                      });
}

RegularLanguage inverse_image(const RegularLanguage& language, const std::vector<Word>& images,
                              const std::vector<Symbol>& domain) {
    std::size_t letters = language.automaton().letters;
    for (const Symbol a : domain)
        for (const Symbol b : image_of(a, images)) letters = std::max<std::size_t>(letters, b + 1);
    const Dfa before = widened(language.automaton(), letters);
    Nfa found;
    for (const char accepting : before.accepting) found.add_state(accepting != 0);
    found.initial.push_back(before.initial);
    for (std::size_t s = 0; s < before.states(); ++s)
        for (const Symbol a : domain) {
            std::size_t to = s;
            for (const Symbol b : images[a]) to = before.step(to, b);
            found.states[s].moves.emplace_back(a, to);
        }
    return RegularLanguage(found);
}

namespace {

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

bool is_finite(const RegularLanguage& language) {
    return without_cycle(language.automaton()).has_value();
}

std::optional<Integer> number_of_words(const RegularLanguage& language) {
    const Dfa& automaton = language.automaton();
    const auto order = without_cycle(automaton);
    if (!order) return std::nullopt;
    std::vector<Integer> count(automaton.states(),
                               Integer(0));  // of words accepted from each state
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

std::vector<Word> words_up_to(const RegularLanguage& language, std::size_t longest,
                              const Budget& budget) {
    const Dfa& automaton = language.automaton();
    const std::vector<std::size_t> distance = distances(automaton);
    std::vector<Word> found;
    std::uint64_t bytes = 0;
    // Of one length, with the states they lead to.
    std::vector<std::pair<Word, std::size_t>> beginnings;
    if (distance[automaton.initial] <= longest && distance[automaton.initial] < automaton.states())
        beginnings.emplace_back(Word{}, automaton.initial);
    for (std::size_t length = 0; !beginnings.empty(); ++length) {
        budget.check();
        std::vector<std::pair<Word, std::size_t>> longer;
        for (const auto& [word, state] : beginnings) {
            if (automaton.accepting[state]) found.push_back(word);
            for (Symbol a = 0; a < automaton.letters; ++a) {
                const std::size_t to = automaton.step(state, a);
                if (distance[to] == automaton.states() || length + 1 + distance[to] > longest)
                    continue;
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

std::optional<Word> first_outside(const RegularLanguage& inner, const RegularLanguage& outer,
                                  const Budget& budget) {
    return shortest_word(difference(inner, outer, budget));
}

std::optional<Word> first_difference(const RegularLanguage& left, const RegularLanguage& right,
                                     const Budget& budget) {
    return shortest_word(symmetric_difference(left, right, budget));
}

namespace {

/// The successors with at least so many of these letters.
RegularLanguage successors(const std::vector<Word>& all, const std::vector<char>& counted,
                           std::size_t least) {
    std::vector<Word> words;
    for (const Word& successor : all)
        if (static_cast<std::size_t>(std::count_if(successor.begin(), successor.end(),
                                                   [&](Symbol a) { return counted[a] != 0; })) >=
            least)
            words.push_back(successor);
    return finite_set(words);
}

}  // namespace

RegularLanguage marked_once(const RegularLanguage& language, const Budget& budget) {
    const Symbol letters = static_cast<Symbol>(language.automaton().letters);
    std::vector<Symbol> plain, marked, all;
    std::vector<Word> unmarked(2 * letters);
    for (Symbol a = 0; a < letters; ++a) {
        plain.push_back(a);
        marked.push_back(a + letters);
        unmarked[a] = unmarked[a + letters] = {a};
    }
    all = plain;
    all.insert(all.end(), marked.begin(), marked.end());
    std::vector<Word> one_mark;
    for (const Symbol a : marked) one_mark.push_back({a});
    const RegularLanguage once = concatenated(
        concatenated(all_words(plain), finite_set(one_mark), budget), all_words(plain), budget);
    return intersected(inverse_image(language, unmarked, all), once, budget);
}

namespace {

/// The words of the language that no step makes of another one with fewer counted letters, if they are at most `most`.
std::optional<RegularInduction> induction_by(const std::vector<char>& counted,
                                             const RegularLanguage& once,
                                             const RegularLanguage& language,
                                             const std::vector<Table>& tables, std::size_t most,
                                             const Budget& budget) {
    const Symbol letters = static_cast<Symbol>(language.automaton().letters);
    RegularLanguage base = language;
    for (const Table& table : tables) {
        std::vector<RegularLanguage> images(2 * letters);
        for (Symbol a = 0; a < letters; ++a) {
            const std::size_t kept = counted[a] != 0 ? 1 : 0;
            images[a] = successors(table[a], counted, kept);
            images[a + letters] = successors(table[a], counted, kept + 1);
        }
        base = difference(base, image(once, images, budget), budget);
    }
    const std::optional<Integer> count = number_of_words(base);
    if (!count || *count > Integer(most)) return std::nullopt;
    RegularInduction found{words_up_to(base, base.automaton().states(), budget), {}};
    for (Symbol a = 0; a < counted.size(); ++a)
        if (counted[a] != 0) found.counted.push_back(a);
    return found;
}

}  // namespace

std::optional<RegularInduction> regular_induction(const RegularLanguage& language,
                                                  const std::vector<Table>& tables,
                                                  std::size_t most, const Budget& budget) {
    return regular_induction(language, marked_once(language, budget), tables, most, budget);
}

std::optional<RegularInduction> regular_induction(const RegularLanguage& language,
                                                  const RegularLanguage& once,
                                                  const std::vector<Table>& tables,
                                                  std::size_t most, const Budget& budget) {
    constexpr Symbol most_letters = 4;  // of which all subsets are tried
    const Symbol letters = static_cast<Symbol>(language.automaton().letters);
    if (tables.empty() || letters > tables.front().size()) return std::nullopt;
    std::vector<char> counted(tables.front().size(), 1);
    if (auto found = induction_by(counted, once, language, tables, most, budget)) return found;
    if (letters > most_letters) return std::nullopt;
    for (unsigned set = (1U << letters) - 2; set > 0 && letters > 0; --set) {
        for (Symbol a = 0; a < letters; ++a) counted[a] = static_cast<char>(set >> a & 1);
        if (auto found = induction_by(counted, once, language, tables, most, budget)) return found;
    }
    return std::nullopt;
}

std::optional<LengthSet> lengths_of(const RegularLanguage& language) {
    const Dfa& automaton = language.automaton();
    const std::vector<std::size_t> distance = distances(automaton);
    const auto is_useful = [&](std::size_t s) { return distance[s] < automaton.states(); };
    std::optional<Symbol> letter;
    for (std::size_t s = 0; s < automaton.states(); ++s)
        for (Symbol a = 0; a < automaton.letters; ++a) {
            if (!is_useful(s) || !is_useful(automaton.step(s, a)) || letter == a) continue;
            if (letter) return std::nullopt;
            letter = a;
        }
    if (!letter) return std::nullopt;
    LengthSet found{*letter, 0, 1, {}};
    std::vector<std::size_t> first(automaton.states(), automaton.states());
    for (std::size_t s = automaton.initial;; s = automaton.step(s, *letter)) {
        if (first[s] < automaton.states()) {
            found.tail = first[s];
            found.period = found.has.size() - first[s];
            return found;
        }
        first[s] = found.has.size();
        found.has.push_back(automaton.accepting[s]);
    }
}

Numbers from_shorter(const LengthSet& set, const LengthTable& table, std::size_t limit,
                     std::size_t least, const Budget& budget) {
    Numbers found(limit), sums(limit);
    sums.set(0);
    for (std::size_t x = 1; x < limit; ++x) {
        budget.check();
        Numbers next(limit);
        if (table.step > 0) {
            for (const std::size_t k : table.endless)
                if (k <= limit) next.add(sums, k);
            for (std::size_t step = table.step; step <= limit; step *= 2)
                next.add(Numbers(next), step);
        }
        for (const std::size_t k : table.lengths)
            if (k <= limit) next.add(sums, k);
        if (next.empty()) break;
        const bool is_new = next != sums;
        sums = std::move(next);
        if (x < least || !set.contains(x)) continue;
        Numbers longer = sums;
        longer.clear_up_to(x);
        found.add(longer);
        if (!is_new) break;  // nor are there others by more letters
    }
    return found;
}

namespace {

/// Of a table the first lengths that it makes of shorter ones from the tail on, by their rest when divided by the period times its least
/// length that is not 0.
struct FirstMade {
    std::size_t table = 0;
    std::size_t modulus = 0;
    std::vector<std::size_t> first;  // `never` where there is none
};

/// By rest when divided by the modulus, the first length from which on all are made by the tables; 0 where none is in the set.
std::vector<std::size_t> first_made(const LengthSet& set, const std::vector<FirstMade>& tables,
                                    std::size_t modulus, std::size_t never) {
    std::vector<std::size_t> first(modulus, 0);
    for (std::size_t rest = 0; rest < modulus; ++rest) {
        if (!set.contains_long(rest)) continue;
        first[rest] = never;
        for (const FirstMade& table : tables)
            first[rest] = std::min(first[rest], table.first[rest % table.modulus]);
    }
    return first;
}

/// From where on some of the tables make all lengths of the set, taken as long as they make more; the base is left to the caller.
std::optional<LengthInduction> made_from(const LengthSet& set, std::vector<FirstMade> tables,
                                         std::size_t never) {
    constexpr std::size_t most = 200'000;
    std::sort(tables.begin(), tables.end(), [](const FirstMade& one, const FirstMade& other) {
        return one.modulus < other.modulus;
    });
    std::vector<FirstMade> used;
    std::size_t modulus = set.period;
    std::vector<std::size_t> first = first_made(set, used, modulus, never);
    for (FirstMade& table : tables) {
        const std::size_t next = std::lcm(modulus, table.modulus);
        if (next > most) continue;
        used.push_back(std::move(table));
        std::vector<std::size_t> with = first_made(set, used, next, never);
        const auto left = [&](const std::vector<std::size_t>& in) {
            return static_cast<std::size_t>(std::count(in.begin(), in.end(), never));
        };
        if (left(with) == left(first) * (next / modulus)) {
            used.pop_back();
            continue;
        }
        modulus = next;
        first = std::move(with);
        if (left(first) > 0) continue;
        LengthInduction found{
            {}, std::max(set.tail, *std::max_element(first.begin(), first.end())), {}};
        for (const FirstMade& each : used) found.tables.push_back(each.table);
        return found;
    }
    return std::nullopt;
}

}  // namespace

std::optional<LengthInduction> length_induction(const LengthSet& set,
                                                const std::vector<LengthTable>& tables,
                                                std::size_t most, std::size_t limit,
                                                const Budget& budget) {
    for (std::size_t reach = std::min(2 * set.has.size() + 8, limit);;
         reach = std::min(2 * reach, limit)) {
        Numbers made(reach);
        std::vector<FirstMade> late;
        for (std::size_t t = 0; t < tables.size(); ++t) {
            const LengthTable& table = tables[t];
            made.add(from_shorter(set, table, reach, 0, budget));
            const auto least = std::find_if(table.lengths.begin(), table.lengths.end(),
                                            [](std::size_t k) { return k > 0; });
            if (least == table.lengths.end()) continue;
            FirstMade first{t, set.period * *least, {}};
            if (first.modulus > reach) continue;
            const Numbers some =
                from_shorter(set, table, reach, std::max<std::size_t>(set.tail, 1), budget);
            first.first.assign(first.modulus, reach + 1);
            for (std::size_t s = reach + 1; s-- > 0;)
                if (some.at(s)) first.first[s % first.modulus] = s;
            late.push_back(std::move(first));
        }
        std::vector<std::size_t> base;
        for (std::size_t s = 0; s <= reach; ++s)
            if (set.contains(s) && !made.at(s)) base.push_back(s);
        if (base.size() > most) return std::nullopt;
        if (auto found = made_from(set, std::move(late), reach + 1)) {
            found->base = std::move(base);
            return found;
        }
        if (reach == limit) return std::nullopt;
    }
}

}  // namespace algae
