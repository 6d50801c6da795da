#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "exact/exact.hpp"
#include "system/detail/interaction.hpp"

// Two engines for steps of systems with interactions.
//
// The automaton reads the word once from each side: a state is the set of contexts that match up to here, so that a
// step takes constant time a letter whatever the contexts are; in a tree the state is pushed at [ and popped at ].
// Bit planes hold the letters of a cellular automaton as bits in machine words, 64 cells at a time; each rule is a
// boolean function of shifted planes.

namespace algae {

namespace {

constexpr std::size_t steps_between_checks = std::size_t{1} << 16;

void put(std::vector<std::uint64_t>& set, std::size_t bit) {
    set[bit / 64] |= std::uint64_t{1} << bit % 64;
}

bool has(const std::vector<std::uint64_t>& set, std::size_t bit) {
    return set[bit / 64] >> bit % 64 & 1;
}

std::vector<std::uint64_t> empty_set(std::size_t bits) {
    return std::vector<std::uint64_t>(bits / 64 + 1);
}

}  // namespace

ContextAutomaton::State ContextAutomaton::States::number_of(const Set& set, std::size_t letters) {
    const auto [known, is_new] = numbers.emplace(set, static_cast<State>(sets.size()));
    if (is_new) {
        sets.push_back(set);
        after.resize(after.size() + letters, unknown);
    }
    return known->second;
}

ContextAutomaton::ContextAutomaton(const IL& system)
    : letters_(system.alphabet->size()),
      brackets_(system.brackets),
      ignored_(system.ignored),
      rules_(system.rules.size()) {
    for (Symbol a = 0; a < letters_; ++a) add_successor({a});
    for (Symbol a = 0; a < system.rules.size(); ++a)
        for (const IL::Rule& rule : system.rules[a]) {
            rules_[a].push_back({left_place(rule.left), right_place(rule.right, brackets_),
                                 static_cast<std::uint32_t>(successors_.size())});
            add_successor(rule.successor);
        }
    left_start_ = left_.number_of(empty_set(left_letters_.size()), letters_);
    Set ends = empty_set(right_letters_.size());
    for (const std::size_t bit : right_ends_) put(ends, bit);
    right_end_ = right_.number_of(ends, letters_);
}

/// A bit for each letter of the context: up to there it has been read.
ContextAutomaton::Place ContextAutomaton::left_place(const Word& context) {
    if (context.empty()) return {};
    const auto [known, is_new] = known_left_.emplace(context, Place{});
    if (is_new) {
        left_starts_.push_back(left_letters_.size());
        left_letters_.insert(left_letters_.end(), context.begin(), context.end());
        known->second = {false, left_letters_.size() - 1};
    }
    return known->second;
}

/// A bit for each letter and bracket, and one for the end: from there on it matches.
ContextAutomaton::Place ContextAutomaton::right_place(const Word& context,
                                                      const std::optional<Brackets>& brackets) {
    if (context.empty()) return {};
    const auto [known, is_new] = known_right_.emplace(context, Place{});
    if (!is_new) return known->second;
    const std::size_t first = right_letters_.size();
    known->second = {false, first};
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < context.size(); ++i) {
        right_letters_.push_back(context[i]);
        if (!brackets) continue;
        if (context[i] == brackets->open) {
            open.push_back(branches_.size());
            branches_.push_back({{false, first + i}, {false, first + i + 1}, {}});
        } else if (context[i] == brackets->close) {
            branches_[open.back()].behind = {false, first + i + 1};
            open.pop_back();
            right_ends_.push_back(first + i);
        }
    }
    right_ends_.push_back(right_letters_.size());
    right_letters_.push_back(static_cast<Symbol>(letters_));  // no letter
    return known->second;
}

ContextAutomaton::State ContextAutomaton::after_left(State state, Symbol letter) {
    const State known = left_.after[state * letters_ + letter];
    if (known != unknown) return known;
    if (ignored_[letter]) return left_.after[state * letters_ + letter] = state;
    Set next = empty_set(left_letters_.size());
    for (std::size_t bit = 0; bit + 1 < left_letters_.size(); ++bit)
        if (has(left_.sets[state], bit) && left_letters_[bit + 1] == letter) put(next, bit + 1);
    for (const std::size_t bit : left_starts_)
        if (left_letters_[bit] == letter) put(next, bit);
    // The last bit of a context also leads to the first of the next one, which is always begun.
    const State found = left_.number_of(next, letters_);
    return left_.after[state * letters_ + letter] = found;
}

ContextAutomaton::State ContextAutomaton::before_right(State state, Symbol letter) {
    const State known = right_.after[state * letters_ + letter];
    if (known != unknown) return known;
    if (ignored_[letter]) return right_.after[state * letters_ + letter] = state;
    Set next = right_.sets[right_end_];
    for (std::size_t bit = 0; bit + 1 < right_letters_.size(); ++bit)
        if (right_letters_[bit] == letter && has(right_.sets[state], bit + 1)) put(next, bit);
    const State found = right_.number_of(next, letters_);
    return right_.after[state * letters_ + letter] = found;
}

/// What matches at a `[`: what matches behind the branch, which is skipped, and contexts that want
/// a branch like this one.
ContextAutomaton::State ContextAutomaton::before_branch(State inside, State behind) {
    if (branches_.empty()) return behind;
    const auto [known, is_new] = joined_.emplace(std::uint64_t{inside} << 32 | behind, unknown);
    if (!is_new) return known->second;
    Set next = right_.sets[behind];
    for (const Branch& branch : branches_)
        if (branch.inside.in(right_.sets[inside]) && branch.behind.in(right_.sets[behind]))
            put(next, branch.at.bit);
    return known->second = right_.number_of(next, letters_);
}

std::uint32_t ContextAutomaton::chosen(State left, Symbol letter, State right) {
    const std::size_t row = left * letters_ + letter;
    if (row >= choices_.size()) choices_.resize(left_.sets.size() * letters_);
    std::vector<std::uint32_t>& choices = choices_[row];
    if (right >= choices.size()) {
        choices_made_ += right_.sets.size() - choices.size();
        choices.resize(right_.sets.size(), unknown);
    }
    if (choices[right] != unknown) return choices[right];
    std::uint32_t successor = letter;
    for (const Rule& rule : rules_[letter])
        if (rule.left.in(left_.sets[left]) && rule.right.in(right_.sets[right])) {
            successor = rule.successor;
            break;
        }
    return choices[right] = successor;
}

/// Puts down for each letter the state of what is on its right.
void ContextAutomaton::read_right_contexts(const Word& word, const std::string& name,
                                           const Budget& budget) {
    open_.clear();
    State state = right_end_;
    for (std::size_t i = word.size(); i-- > 0;) {
        if (i % steps_between_checks == 0) check(budget);
        const Symbol a = word[i];
        chosen_[i] = state;
        if (brackets_ && a == brackets_->close) {
            open_.push_back(state);
            state = right_end_;
        } else if (brackets_ && a == brackets_->open) {
            if (open_.empty())
                throw Error(name + " has a '[' that is never closed, at letter " +
                            std::to_string(i + 1));
            state = before_branch(state, open_.back());
            open_.pop_back();
        } else {
            state = before_right(state, a);
        }
    }
    if (!open_.empty()) throw Error(name + " has an unmatched ']'");
}

std::uint64_t ContextAutomaton::choose(const Word& word, const std::string& name,
                                       const Budget& budget) {
    chosen_.resize(word.size());
    read_right_contexts(word, name, budget);
    open_.clear();
    State state = left_start_;
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (i % steps_between_checks == 0) check(budget);
        const Symbol a = word[i];
        const std::uint32_t rule = chosen_[i] = chosen(state, a, chosen_[i]);
        length += successors_[rule].size;
        if (brackets_ && a == brackets_->open) {
            open_.push_back(state);
        } else if (brackets_ && a == brackets_->close) {
            state = open_.back();
            open_.pop_back();
        } else {
            state = after_left(state, a);
        }
    }
    check(budget);
    return length;
}

void ContextAutomaton::check(const Budget& budget) const {
    budget.check();
    budget.check_memory(memory(), "the states that contexts are read with");
}

std::uint64_t ContextAutomaton::memory() const {
    const auto of = [&](const States& states, std::size_t bits) {
        return states.sets.size() * (4 * letters_ + bits / 4 + 128);
    };
    return of(left_, left_letters_.size()) + of(right_, right_letters_.size()) +
           48 * joined_.size() + 4 * choices_made_ + 24 * choices_.size();
}

void ContextAutomaton::add_successor(const Word& successor) {
    successors_.push_back({texts_.size(), successor.size()});
    texts_.insert(texts_.end(), successor.begin(), successor.end());
}

void ContextAutomaton::write(Word& next) const {
    std::size_t length = 0;
    for (const std::uint32_t rule : chosen_) length += successors_[rule].size;
    next.resize(length);
    Symbol* to = next.data();
    for (const std::uint32_t rule : chosen_) {
        const Successor successor = successors_[rule];
        const Symbol* from = texts_.data() + successor.begin;
        if (successor.size == 1)
            *to = *from;
        else
            std::copy_n(from, successor.size, to);
        to += successor.size;
    }
}

namespace {

using Operation = WindowProgram::Operation;
using Bits = std::uint64_t;

constexpr std::size_t most_inputs = 12;         // bits of a window: 4096 windows
constexpr std::size_t most_instructions = 300;  // more take longer than a table
constexpr std::size_t run_words = 64;           // that each instruction is done for at a time
constexpr std::size_t words_between_checks = std::size_t{1} << 14;

/// Part of a truth table: 0, 1, or anything.
constexpr char any = 2;
using Values = std::string;

bool may_all_be(const Values& values, char value) {
    return std::all_of(values.begin(), values.end(),
                       [&](char v) { return v == value || v == any; });
}

/// Values that are those of both, where one function can be; `flipped` takes the other's negation.
std::optional<Values> united(const Values& one, const Values& other, bool flipped) {
    Values both = one;
    for (std::size_t i = 0; i < both.size(); ++i) {
        const char wanted = other[i] == any ? any : static_cast<char>(other[i] ^ (flipped ? 1 : 0));
        if (both[i] == any)
            both[i] = wanted;
        else if (wanted != any && wanted != both[i])
            return std::nullopt;
    }
    return both;
}

}  // namespace

/// Writes the instructions for functions given by their values, which are in the order of the bits
/// that they are split on.
class ProgramWriter {
public:
    ProgramWriter(std::size_t inputs, std::vector<std::uint32_t> order) : order_(std::move(order)) {
        program_.slots_ = inputs;
    }

    void add_result(const Values& values) { program_.results_.push_back(slot_of(values)); }
    WindowProgram take() { return std::move(program_); }
    std::size_t size() const { return program_.instructions_.size(); }

private:
    std::uint32_t slot_of(const Values& values) {
        if (may_all_be(values, 0)) return put(Operation::zero, 0, 0, 0);
        if (may_all_be(values, 1)) return put(Operation::one, 0, 0, 0);
        if (const auto known = known_.find(values); known != known_.end()) return known->second;
        const std::uint32_t slot = split(values);
        known_.emplace(values, slot);
        return slot;
    }

    std::uint32_t split(const Values& values) {
        std::size_t depth = order_.size();
        for (std::size_t size = values.size(); size > 1; size /= 2) --depth;
        const std::uint32_t bit = order_[depth];
        const Values unset = values.substr(0, values.size() / 2),
                     set = values.substr(values.size() / 2);
        if (const auto both = united(unset, set, false)) return slot_of(*both);
        if (may_all_be(unset, 0) && may_all_be(set, 1)) return bit;
        if (may_all_be(unset, 1) && may_all_be(set, 0)) return put(Operation::negate, bit, 0, 0);
        if (const auto both = united(unset, set, true))
            return put(Operation::differs, bit, slot_of(*both), 0);
        if (may_all_be(unset, 0)) return put(Operation::both, bit, slot_of(set), 0);
        if (may_all_be(set, 0)) return put(Operation::other_only, bit, slot_of(unset), 0);
        if (may_all_be(set, 1)) return put(Operation::either, bit, slot_of(unset), 0);
        if (may_all_be(unset, 1)) return put(Operation::other_unless, bit, slot_of(set), 0);
        const std::uint32_t when_set = slot_of(set), when_unset = slot_of(unset);
        return put(Operation::select, bit, when_set, when_unset);
    }

    std::uint32_t put(Operation operation, std::uint32_t bit, std::uint32_t a, std::uint32_t b) {
        const auto [known, is_new] = written_.emplace(
            std::array<std::uint32_t, 4>{static_cast<std::uint32_t>(operation), bit, a, b},
            static_cast<std::uint32_t>(program_.slots_));
        if (is_new) {
            program_.instructions_.push_back({operation, known->second, bit, a, b});
            ++program_.slots_;
        }
        return known->second;
    }

    std::vector<std::uint32_t> order_;
    WindowProgram program_;
    std::map<Values, std::uint32_t> known_;
    std::map<std::array<std::uint32_t, 4>, std::uint32_t> written_;
};

WindowProgram::WindowProgram(const Windows& windows,
                             const std::vector<std::optional<std::vector<std::uint8_t>>>& table) {
    const std::size_t bits = windows.bits(), inputs = bits * windows.width();
    const auto written = [&](const std::vector<std::uint32_t>& order) {
        ProgramWriter writer(inputs, order);
        for (std::size_t plane = 0; plane < bits; ++plane) {
            Values values(table.size(), any);
            for (std::size_t place = 0; place < values.size(); ++place) {
                std::size_t window = 0;  // the first bit of the order is the highest of the place
                for (std::size_t i = 0; i < inputs; ++i)
                    window |= (place >> (inputs - 1 - i) & 1) << order[i];
                if (table[window])
                    values[place] = static_cast<char>(table[window]->front() >> plane & 1);
            }
            writer.add_result(values);
        }
        return writer;
    };
    // Which bit is split first decides how long the program is: letters are tried in every order
    // where there are few.
    std::vector<std::size_t> letters(windows.width());
    for (std::size_t i = 0; i < letters.size(); ++i) letters[i] = i;
    bool first = true;
    do {
        std::vector<std::uint32_t> order;
        for (const std::size_t letter : letters)
            for (std::size_t plane = bits; plane-- > 0;)
                order.push_back(static_cast<std::uint32_t>(letter * bits + plane));
        ProgramWriter writer = written(order);
        if (first || writer.size() < instructions_.size()) *this = writer.take();
        first = false;
    } while (inputs <= 8 && letters.size() <= 4 &&
             std::next_permutation(letters.begin(), letters.end()));
}

std::optional<CellPlanes> CellPlanes::of(const IL& system, const Windows& windows) {
    if (!windows.keeps_length || windows.bits() * windows.width() > most_inputs)
        return std::nullopt;
    WindowProgram program(windows, window_table(system, windows));
    if (program.instructions().size() > most_instructions) return std::nullopt;
    return CellPlanes(system, windows, std::move(program));
}

CellPlanes::CellPlanes(const IL& system, const Windows& windows, WindowProgram program)
    : system_(&system), windows_(windows), program_(std::move(program)) {
    scratch_.resize(program_.slots() * run_words);
    at_.resize(program_.slots());
    is_read_.resize(program_.slots());
    for (const WindowProgram::Instruction& one : program_.instructions())
        is_read_[one.bit] = is_read_[one.a] = is_read_[one.b] = 1;
    for (const std::uint32_t slot : program_.results()) is_read_[slot] = 1;
}

void CellPlanes::read(const Word& word) {
    length_ = word.size();
    const std::size_t runs = (length_ + 64 * run_words - 1) / (64 * run_words);
    planes_.assign(windows_.bits(), std::vector<Bits>(runs * run_words + 2));
    next_ = planes_;
    for (std::size_t i = 0; i < length_; ++i) put(i, word[i]);
    std::swap(planes_, next_);
}

void CellPlanes::put(std::size_t place, Symbol letter) {
    const std::uint8_t number = windows_.numbers[letter];
    for (std::size_t plane = 0; plane < next_.size(); ++plane) {
        Bits& bits = next_[plane][place / 64 + 1];
        bits = (bits & ~(Bits{1} << place % 64)) | Bits{number >> plane & 1u} << place % 64;
    }
}

Symbol CellPlanes::letter_at(std::size_t place) const {
    std::size_t number = 0;
    for (std::size_t plane = 0; plane < planes_.size(); ++plane)
        number |= (planes_[plane][place / 64 + 1] >> place % 64 & 1) << plane;
    return windows_.letters[number];
}

void CellPlanes::write(Word& word) const {
    word.resize(length_);
    for (std::size_t i = 0; i < length_; ++i) word[i] = letter_at(i);
}

namespace {

// Compiled for several machines, of which the best is taken when the program starts: before sanitizers are there.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ALGAE_WIDEST_VECTORS [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define ALGAE_WIDEST_VECTORS
#endif

template <class Function>
[[gnu::always_inline]] inline void each(Bits* __restrict to, Function function) {
    for (std::size_t i = 0; i < run_words; ++i) to[i] = function(i);
}

ALGAE_WIDEST_VECTORS
void perform(Operation operation, Bits* to, const Bits* bit, const Bits* a, const Bits* b) {
    switch (operation) {
        case Operation::zero:
            return each(to, [](std::size_t) { return Bits{0}; });
        case Operation::one:
            return each(to, [](std::size_t) { return ~Bits{0}; });
        case Operation::negate:
            return each(to, [=](std::size_t i) { return ~bit[i]; });
        case Operation::both:
            return each(to, [=](std::size_t i) { return bit[i] & a[i]; });
        case Operation::other_only:
            return each(to, [=](std::size_t i) { return ~bit[i] & a[i]; });
        case Operation::either:
            return each(to, [=](std::size_t i) { return bit[i] | a[i]; });
        case Operation::other_unless:
            return each(to, [=](std::size_t i) { return ~bit[i] | a[i]; });
        case Operation::differs:
            return each(to, [=](std::size_t i) { return bit[i] ^ a[i]; });
        case Operation::select:
            return each(to, [=](std::size_t i) { return b[i] ^ (bit[i] & (a[i] ^ b[i])); });
    }
}

/// The bits of the letters that stand `by` places before, or behind.
ALGAE_WIDEST_VECTORS
void read_before(Bits* to, const Bits* here, std::size_t by) {
    each(to, [=](std::size_t i) { return here[i] << by | *(here + i - 1) >> (64 - by); });
}

ALGAE_WIDEST_VECTORS
void read_behind(Bits* to, const Bits* here, std::size_t by) {
    each(to, [=](std::size_t i) { return here[i] >> by | here[i + 1] << (64 - by); });
}

}  // namespace

/// Rewrites run_words * 64 letters from the first on.
void CellPlanes::run(std::size_t first) {
    const std::size_t bits = planes_.size();
    for (std::size_t slot = 0; slot < bits * windows_.width(); ++slot) {
        Bits* here = &planes_[slot % bits][first + 1];
        const std::size_t letter = slot / bits;
        if (letter == windows_.left)
            at_[slot] = here;
        else if (is_read_[slot] && letter < windows_.left)
            read_before(at_[slot], here, windows_.left - letter);
        else if (is_read_[slot])
            read_behind(at_[slot], here, letter - windows_.left);
    }
    for (const WindowProgram::Instruction& one : program_.instructions())
        perform(one.operation, at_[one.to], at_[one.bit], at_[one.a], at_[one.b]);
    for (std::size_t plane = 0; plane < bits; ++plane)
        std::copy_n(at_[program_.results()[plane]], run_words, &next_[plane][first + 1]);
}

/// Rewrites the letters whose windows reach beyond the ends.
void CellPlanes::step_ends() {
    const auto rewrite = [&](std::size_t place) {
        const std::size_t from = place - std::min(place, windows_.left);
        Word window;
        for (std::size_t i = from; i < std::min(length_, place + windows_.right + 1); ++i)
            window.push_back(letter_at(i));
        put(place, *successor_at(*system_, window, place - from).begin);
    };
    const std::size_t left = std::min(length_, windows_.left);
    for (std::size_t i = 0; i < left; ++i) rewrite(i);
    for (std::size_t i = std::max(left, length_ - std::min(length_, windows_.right)); i < length_;
         ++i)
        rewrite(i);
}

void CellPlanes::step(const Budget& budget) {
    for (std::size_t slot = 0; slot < at_.size(); ++slot) at_[slot] = &scratch_[slot * run_words];
    for (std::size_t first = 0; first + 2 < planes_.front().size(); first += run_words) {
        if (first % words_between_checks == 0) budget.check();
        run(first);
    }
    step_ends();
    std::swap(planes_, next_);
}

}  // namespace algae
