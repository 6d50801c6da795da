#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "exact/exact.hpp"
#include "system/system.hpp"

namespace algae {

/// What the fast ways of deriving need of a system with interactions: words are no trees, no letter
/// that occurs is ignored, so that what becomes of a letter is a function of a window of letters
/// around it. The letters that occur are numbered from 0 on.
struct Windows {
    std::vector<Symbol> letters;        // by number, in order of first access
    std::vector<std::uint8_t> numbers;  // by symbol; 0 too for letters that do not occur
    std::size_t left = 0, right = 0;    // letters of the window on either side
    bool keeps_length = true;           // every letter becomes one letter

    static constexpr std::size_t most_bits = 15;  // of the numbers in a window

    /// Bits that tell the numbers apart, at least 1.
    std::size_t bits() const;
    std::size_t width() const { return left + 1 + right; }
};

/// The windows of a system, if it has them and their letters can be told by few enough bits
/// (most_bits) to tabulate what becomes of each. O(size of the system).
std::optional<Windows> windows(const IL& system);

/// What the letter at this place of a word without trees and ignored letters becomes: beyond the
/// ends of the word nothing matches. The word must outlive the answer.
struct Letters {
    const Symbol* begin = nullptr;
    std::size_t size = 0;
};
Letters successor_at(const IL& system, const Word& word, std::size_t place);

/// successor_at in the middle of every window, by its number: the first letter of the window has the
/// lowest bits. Only windows of letters that occur have one. Numbers of letters.
std::vector<std::optional<std::vector<std::uint8_t>>> window_table(const IL& system,
                                                                   const Windows& windows);

/// Words of a system with interactions as bytes, and a table of what becomes of windows: as many
/// letters at a time as the bits of a word of the machine and of the table's index allow. Letters
/// whose windows reach beyond the ends are looked up one by one.
class WindowTable {
public:
    /// Nothing if the windows are too many or too wide, or become too long. The system must outlive
    /// the table.
    static std::optional<WindowTable> of(const IL& system, const Windows& windows);

    void read(const Word& word);
    void write(Word& word) const;
    /// The next word; false, and no step, if it has more than budget.letters letters. O(length of
    /// the two words / letters at a time). Throws BoundReached if the words take more than
    /// budget.memory.
    bool step(const Budget& budget);
    std::size_t length() const { return length_; }

private:
    static constexpr std::size_t most_letters = 15;  // that the letters in the middle become
    /// What the letters in the middle of a window become.
    struct Entry {
        std::array<std::uint8_t, most_letters> letters{};
        std::uint8_t count = 0;
    };

    WindowTable(const IL& system, const Windows& windows) : system_(&system), windows_(windows) {}
    bool build(const std::vector<std::optional<std::vector<std::uint8_t>>>& single,
               std::size_t middle);
    template <std::size_t bits>
    bool step_middle(const Budget& budget, std::size_t& at, std::size_t end);
    void rewrite_alone(std::size_t place);
    void make_room(std::size_t letters);

    const IL* system_;
    Windows windows_;
    std::size_t middle_ = 1;  // letters that are rewritten at a time
    std::vector<Entry> table_;
    std::size_t length_ = 0, next_length_ = 0;
    std::vector<std::uint8_t> word_,
        next_;  // longer than the words, so that whole entries can be read and written
};

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

    /// What was chosen for each letter: the letter itself if it stays, otherwise the number of letters and the number of the
    /// rule, counted through the rules of all letters in their order.
    const std::vector<std::uint32_t>& chosen() const { return chosen_; }

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

/// A boolean function of the bits of a window, as a program that runs on 64 letters at a time.
///
/// It is made by splitting on one bit after another (Shannon's expansion), where equal parts are
/// made once and what is no letter's number may be any value.
class WindowProgram {
public:
    enum class Operation : std::uint8_t {
        zero,
        one,
        negate,
        both,
        other_only,
        either,
        other_unless,
        differs,
        select
    };
    /// slot to := operation(bit x; slots a, b). `select` is a where the bit is set and b elsewhere.
    struct Instruction {
        Operation operation;
        std::uint32_t to, bit, a, b;
    };

    /// The bits of the successors, from what windows become (see window_table); one letter each.
    WindowProgram(const Windows& windows,
                  const std::vector<std::optional<std::vector<std::uint8_t>>>& table);

    std::size_t slots() const { return slots_; }
    /// The first slots are the bits of the window: those of its first letter first.
    const std::vector<Instruction>& instructions() const { return instructions_; }
    /// The slots of the bits of the successor.
    const std::vector<std::uint32_t>& results() const { return results_; }

private:
    friend class ProgramWriter;
    WindowProgram() = default;
    std::size_t slots_ = 0;
    std::vector<Instruction> instructions_;
    std::vector<std::uint32_t> results_;
};

/// Words of a system that keeps their length, as bit planes: bit i of plane p is bit p of the number
/// of letter i. A step evaluates the rules as boolean functions of the planes, shifted for the
/// neighbours; letters whose windows reach beyond the ends are looked up one by one.
class CellPlanes {
public:
    /// Nothing if letters do not become one letter each, or if functions of so many bits would take
    /// longer than tables. The system must outlive the planes.
    static std::optional<CellPlanes> of(const IL& system, const Windows& windows);

    void read(const Word& word);
    void write(Word& word) const;
    /// O(length of the word / 64 * instructions).
    void step(const Budget& budget);
    std::size_t length() const { return length_; }

private:
    CellPlanes(const IL& system, const Windows& windows, WindowProgram program);
    void run(std::size_t first);
    Symbol letter_at(std::size_t place) const;
    void put(std::size_t place, Symbol letter);
    void step_ends();

    const IL* system_;
    Windows windows_;
    WindowProgram program_;
    std::size_t length_ = 0;
    std::vector<std::vector<std::uint64_t>> planes_, next_;  // with a word of nothing at either end
    std::vector<char> is_read_;                              // by slot
    std::vector<std::uint64_t> scratch_;                     // of one run, by slot
    std::vector<std::uint64_t*> at_;                         // by slot, for one run
};

}  // namespace algae
