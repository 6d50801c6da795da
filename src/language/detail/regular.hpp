#pragma once

// Regular languages as minimal automata, their operations and words.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

namespace algae {

/// A complete deterministic automaton over the symbols 0, 1, ..., letters - 1. It has at least one
/// state. Words with other symbols are not accepted.
struct Dfa {
    std::size_t letters = 0;
    std::size_t initial = 0;
    std::vector<char> accepting;           // by state
    std::vector<std::size_t> transitions;  // of state s with letter a: transitions[s * letters + a]

    std::size_t states() const { return accepting.size(); }
    std::size_t step(std::size_t state, Symbol letter) const {
        return transitions[state * letters + letter];
    }
    bool accepts(const Word& word) const;
    bool operator==(const Dfa&) const = default;
};

/// A nondeterministic automaton with silent moves.
struct Nfa {
    struct State {
        std::vector<std::pair<Symbol, std::size_t>> moves;
        std::vector<std::size_t> silent;  // where it can go without reading
        bool accepting = false;
    };
    std::vector<State> states;
    std::vector<std::size_t> initial;

    /// A new state; its number.
    std::size_t add_state(bool accepting = false);
    /// A way from one state to another that reads the word, through new states.
    void add_path(std::size_t from, const Word& word, std::size_t to);
    /// All states of another automaton, none of them initial; what must be added to their numbers.
    std::size_t add_states(const Nfa& other);
};

/// By state: the least number of letters to an accepting one; the number of states if there is none.
std::vector<std::size_t> distances(const Dfa& automaton);

/// The automaton as a nondeterministic one, without the states from which nothing is accepted.
Nfa as_nfa(const Dfa& automaton);

/// The automaton that reads words backwards.
Nfa reversed(const Nfa& automaton);

/// The same language over more letters: a state is added that refuses them.
Dfa widened(const Dfa& automaton, std::size_t letters);

/// By sets of states (Rabin and Scott 1959): up to 2^states of them. Throws BoundReached if the result
/// takes more than budget.memory.
///
/// Example: determinised(as_nfa(Dfa{1, 0, {1}, {0}})).accepts({0, 0})
Dfa determinised(const Nfa& automaton, const Budget& budget = {});

/// The automaton with the least number of states, in a form that depends on the language alone: it has
/// as many letters as needed to have every letter of the language's words, and its states are
/// numbered in shortlex order of the first words that lead to them. By Hopcroft's algorithm (1971), O(letters *
/// states * log(states)).
///
/// Example: minimal(Dfa{1, 0, {1, 1}, {1, 0}}) == Dfa{1, 0, {1}, {0}}
Dfa minimal(const Dfa& automaton);

/// A regular language, kept as its minimal automaton: languages are equal when their automata are.
/// Words are over the symbols of some alphabet that the caller knows. Operations that make automata
/// grow throw BoundReached when one takes more than budget.memory.
class RegularLanguage {
public:
    /// No word at all.
    RegularLanguage() : RegularLanguage(Dfa{0, 0, {0}, {}}) {}
    explicit RegularLanguage(const Dfa& automaton) : automaton_(minimal(automaton)) {}
    explicit RegularLanguage(const Nfa& automaton, const Budget& budget = {})
        : RegularLanguage(determinised(automaton, budget)) {}

    const Dfa& automaton() const { return automaton_; }
    bool contains(const Word& word) const { return automaton_.accepts(word); }
    bool operator==(const RegularLanguage&) const = default;

private:
    Dfa automaton_;
};

/// A finite set of words.
///
/// Example: finite_set({{0}, {0, 1}}).contains({0, 1})
RegularLanguage finite_set(const std::vector<Word>& words);

/// All words over these letters.
///
/// Example: all_words({0, 1}) == star(finite_set({{0}, {1}}))
RegularLanguage all_words(const std::vector<Symbol>& letters);

/// Union.
///
/// Example: united(finite_set({{0}}), finite_set({{1}})) == finite_set({{0}, {1}})
RegularLanguage united(const RegularLanguage& left, const RegularLanguage& right,
                       const Budget& budget = {});
/// Example: intersected(all_words({0}), finite_set({{0}, {1}})) == finite_set({{0}})
RegularLanguage intersected(const RegularLanguage& left, const RegularLanguage& right,
                            const Budget& budget = {});
/// The words of the first that are not in the second; the complement of a language over some
/// letters is difference(all_words(letters), language).
///
/// Example: difference(finite_set({{0}, {1}}), finite_set({{1}, {2}})) == finite_set({{0}})
RegularLanguage difference(const RegularLanguage& left, const RegularLanguage& right,
                           const Budget& budget = {});
/// The words that are in one of the two only.
RegularLanguage symmetric_difference(const RegularLanguage& left, const RegularLanguage& right,
                                     const Budget& budget = {});
/// All words over the letters that are not in the language.
///
/// Example: complement(all_words({0, 1}), {0, 1}) == RegularLanguage()
RegularLanguage complement(const RegularLanguage& language, const std::vector<Symbol>& letters,
                           const Budget& budget = {});

/// Example: concatenated(finite_set({{0}, {}}), finite_set({{1}})) == finite_set({{1}, {0, 1}})
RegularLanguage concatenated(const RegularLanguage& left, const RegularLanguage& right,
                             const Budget& budget = {});
/// Example: star(RegularLanguage()) == finite_set({{}})
RegularLanguage star(const RegularLanguage& language, const Budget& budget = {});
/// One word of the language or several after each other.
///
/// Example: !plus(finite_set({{0}})).contains({})
RegularLanguage plus(const RegularLanguage& language, const Budget& budget = {});
/// Example: reversed(finite_set({{0, 1}})) == finite_set({{1, 0}})
RegularLanguage reversed(const RegularLanguage& language, const Budget& budget = {});

/// h(L) for the homomorphism with these images, by symbol. Throws Error if a letter of L has no image.
///
/// Example: image(plus(finite_set({{0}})), std::vector<Word>{{1, 1}}) == plus(finite_set({{1, 1}}))
RegularLanguage image(const RegularLanguage& language, const std::vector<Word>& images,
                      const Budget& budget = {});

/// The words in which every letter of a word of L is replaced by some word of its language, by
/// symbol: the image under a regular substitution. Throws Error if a letter of L has no language.
///
/// Example: image(finite_set({{0}}), std::vector<RegularLanguage>{all_words({0, 1})}) == all_words({0, 1})
RegularLanguage image(const RegularLanguage& language, const std::vector<RegularLanguage>& images,
                      const Budget& budget = {});

/// h^-1(L): the words over the letters of `domain` whose images are in L. `images` is by symbol.
/// Throws Error if a letter of the domain has no image. O(states * size of the images).
///
/// Example: inverse_image(finite_set({{0, 0, 0}}), {{0}, {0, 0}}, {0, 1}) == finite_set({{0, 1}, {1, 0}, {0, 0, 0}})
RegularLanguage inverse_image(const RegularLanguage& language, const std::vector<Word>& images,
                              const std::vector<Symbol>& domain);

// The words of a regular language. Shortlex order is by the numbers of the symbols.

/// Example: is_empty(RegularLanguage())
bool is_empty(const RegularLanguage& language);

/// The first word in shortlex order, if there is one. Linear time.
///
/// Example: shortest_word(plus(finite_set({{1}, {0, 0}}))) == Word{1}
std::optional<Word> shortest_word(const RegularLanguage& language);

/// Whether there are finitely many words. Linear time.
///
/// Example: !is_finite(plus(finite_set({{0}})))
bool is_finite(const RegularLanguage& language);

/// How many words there are; nothing if there is no end to them. Linear time.
///
/// Example: number_of_words(finite_set({{}, {0}})) == Integer(2)
std::optional<Integer> number_of_words(const RegularLanguage& language);

/// How many words of this length there are, by the automaton's transitions: O(length * states * letters).
///
/// Example: number_of_words(all_words({0, 1}), 100) == power(Integer(2), 100)
Integer number_of_words(const RegularLanguage& language, std::size_t length);

/// The words of at most `longest` letters in shortlex order. Throws BoundReached if they take more
/// than budget.memory.
///
/// Example: words_up_to(all_words({0}), 2) == std::vector<Word>{{}, {0}, {0, 0}}
std::vector<Word> words_up_to(const RegularLanguage& language, std::size_t longest,
                              const Budget& budget = {});

/// The first word in shortlex order that is in the first language and not in the second: nothing if the
/// first is contained in the second.
///
/// Example: first_outside(all_words({0}), finite_set({{}, {0, 0}})) == Word{0}
std::optional<Word> first_outside(const RegularLanguage& inner, const RegularLanguage& outer,
                                  const Budget& budget = {});

/// The first word in shortlex order that is in one language only: nothing if they are equal.
///
/// Example: !first_difference(star(plus(finite_set({{0}}))), all_words({0}))
std::optional<Word> first_difference(const RegularLanguage& left, const RegularLanguage& right,
                                     const Budget& budget = {});

/// A finite L(G) as the automaton of its words, of which there may be far more than could be listed. Throws
/// Error if the language is infinite, BoundReached if automata or families of them take more than
/// budget.memory.
///
/// Example: finite_words(et0l("S", {{{'S', "a"}}, {{'S', "b"}}}, "ab")) == finite_set({{1}, {2}})
RegularLanguage finite_words(const ET0L& system, const Budget& budget = {});

/// A proof by induction that a regular language R is contained in the language of tables: every word of R but those
/// of `base`, which are derived, comes in one step by one of the tables from a word of R with fewer of the letters `counted`:
/// each of these becomes a word with one at least, and some letter a word with one more than it is.
struct RegularInduction {
    std::vector<Word> base;
    std::vector<Symbol> counted;  // increasing; all symbols where it is an induction on the length
};

/// The words of R that no step as above gives are regular again, as is the image of R under a substitution
/// with one marked letter; if they are at most `most` they are the base, whose membership is left to the caller. First all
/// letters are counted, then, of at most four letters, each subset.
/// Nothing if there are more: then R may be contained in the language all the same.
///
/// Example: regular_induction(plus(finite_set({{0}})), {{{{0}, {0, 0}}}})->base == std::vector<Word>{{0}}
std::optional<RegularInduction> regular_induction(const RegularLanguage& language,
                                                  const std::vector<Table>& tables,
                                                  std::size_t most = 100,
                                                  const Budget& budget = {});

/// The words of the language with exactly one letter a marked, that is, replaced by a + n, n being the number of letters of the automaton.
RegularLanguage marked_once(const RegularLanguage& language, const Budget& budget = {});

/// The same with the words of the language that are marked once.
std::optional<RegularInduction> regular_induction(const RegularLanguage& language,
                                                  const RegularLanguage& marked,
                                                  const std::vector<Table>& tables,
                                                  std::size_t most, const Budget& budget);

}  // namespace algae
