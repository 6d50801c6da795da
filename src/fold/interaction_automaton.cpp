#include "fold/interaction_automaton.hpp"

#include <algorithm>

#include "base/error.hpp"

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

}  // namespace algae
