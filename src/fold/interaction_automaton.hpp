#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/budget.hpp"
#include "system/il.hpp"

namespace algae {

/// Steps of a system with interactions, for every one: contexts of any length, trees, ignored
/// letters. Which beginnings of left contexts the path to a letter ends with is a state of an
/// automaton that reads the word from left to right and goes back at `]` to the state of the `[`;
/// which ends of right contexts match behind it, a state of one that reads from right to left and
/// joins a branch and what follows it at `[`. The states (Shift-And; Baeza-Yates and Gonnet 1992)
/// are made when they are first reached and kept for all steps, so a step takes O(length of the
/// word), whatever the contexts.
class ContextAutomaton {
public:
    explicit ContextAutomaton(const IL& system);

    /// Chooses the rules for all letters; the length of the next word. Throws Error if the brackets
    /// of a tree do not match; `name` is how the message calls the word.
    std::uint64_t choose(const Word& word, const std::string& name, const Budget& budget);

    /// The next word of the one that rules were chosen for.
    void write(Word& next) const;

private:
    using State = std::uint32_t;
    using Set = std::vector<std::uint64_t>;  // of places in contexts, a bit each
    static constexpr State unknown = UINT32_MAX;

    /// The states reached so far and where letters lead from them.
    struct States {
        std::map<Set, State> numbers;
        std::vector<Set> sets;
        std::vector<State> after;  // by state and letter
        State number_of(const Set& set, std::size_t letters);
    };
    /// What one context needs to match in a state: a bit of its set, or nothing if it is empty.
    struct Place {
        bool anywhere = true;
        std::size_t bit = 0;
        bool in(const Set& set) const { return anywhere || (set[bit / 64] >> bit % 64 & 1); }
    };
    struct Rule {
        Place left, right;
        std::uint32_t successor;
    };
    struct Branch {  // a place in a right context where a branch is wanted
        Place at, inside, behind;
    };

    void add_successor(const Word& successor);
    Place left_place(const Word& context);
    Place right_place(const Word& context, const std::optional<Brackets>& brackets);
    State after_left(State state, Symbol letter);
    State before_right(State state, Symbol letter);
    State before_branch(State inside, State behind);
    std::uint32_t chosen(State left, Symbol letter, State right);
    std::uint64_t memory() const;  // bytes
    void check(const Budget& budget) const;
    void read_right_contexts(const Word& word, const std::string& name, const Budget& budget);

    std::size_t letters_;
    std::optional<Brackets> brackets_;
    std::vector<char> ignored_;
    std::vector<std::vector<Rule>> rules_;  // by letter, in the order in which they are tried
    struct Successor {
        std::size_t begin, size;  // in texts_
    };
    std::vector<Successor> successors_;  // first of letters that stay, by letter, then of rules
    Word texts_;

    std::map<Word, Place> known_left_, known_right_;
    std::vector<Symbol> left_letters_;      // by bit: the letter that is wanted
    std::vector<std::size_t> left_starts_;  // bits at which left contexts begin
    std::vector<Symbol> right_letters_;     // by bit: the letter, or a bracket
    std::vector<std::size_t> right_ends_;   // bits that stand behind contexts and branches of them
    std::vector<Branch> branches_;
    States left_, right_;
    std::unordered_map<std::uint64_t, State> joined_;  // by the states inside and behind a branch
    std::vector<std::vector<std::uint32_t>> choices_;  // by left state and letter, then right state
    std::uint64_t choices_made_ = 0;

    State left_start_ = 0, right_end_ = 0;
    std::vector<std::uint32_t> chosen_;  // by place in the word: first right states, then rules
    std::vector<State> open_;
};

}  // namespace algae
