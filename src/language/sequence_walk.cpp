#include "language/sequence_walk.hpp"

namespace algae {

OverflowWalk::OverflowWalk(const SequencePair& systems, const Budget& budget)
    : systems_(systems),
      budget_(budget),
      matrix_(growth_matrix(systems.left)),
      row_(systems.alphabet->size(), 0) {
    for (std::size_t i = 0; i < systems.left.letters.size(); ++i) row_[systems.left.letters[i]] = i;
    lengths_.push_back(std::vector<Integer>(matrix_.size(), Integer(1)));
    number_of({});
}

std::optional<Integer> OverflowWalk::next_difference() {
    lengths_.push_back(matrix_ * lengths_.back());
    for (const Integer& length : lengths_.back()) kept_ += sizeof(Integer) + bit_length(length) / 8;
    led_.emplace_back();
    check_memory();
    std::vector<Reading> open{{&systems_.left.axiom, generations_, 0, 0}};
    for (std::uint64_t turn = 1;; ++turn) {
        if (turn % 1024 == 0) check_memory();
        Reading& top = open.back();
        if (top.read == top.word->size()) {
            const Reading done = top;
            open.pop_back();
            if (open.empty()) {
                if (!overflows_[done.at].word.empty()) return position({done}, 0);
                break;
            }
            Reading& outer = open.back();
            const Symbol letter = (*outer.word)[outer.read++];
            led_[outer.level].emplace(std::uint64_t{letter} << 32 | outer.at, done.at);
            kept_ += 48;
            outer.at = done.at;
            continue;
        }
        const Symbol letter = (*top.word)[top.read];
        const auto known = led_[top.level].find(std::uint64_t{letter} << 32 | top.at);
        if (known != led_[top.level].end()) {
            top.at = known->second;
            ++top.read;
        } else if (top.level > 0) {
            open.push_back({&systems_.left.successor(letter), top.level - 1, 0, top.at});
        } else if (const auto next = first_step(letter, top.at)) {
            led_[0].emplace(std::uint64_t{letter} << 32 | top.at, *next);
            kept_ += 48;
            top.at = *next;
            ++top.read;
        } else {
            return position(open, agreed_);
        }
    }
    ++generations_;
    return std::nullopt;
}

std::optional<OverflowWalk::Number> OverflowWalk::first_step(Symbol letter, Number from) {
    OverflowStep step = overflow_step(systems_, overflows_[from], letter);
    if (step.next) return number_of(std::move(*step.next));
    agreed_ = step.agreed;
    return std::nullopt;
}

OverflowWalk::Number OverflowWalk::number_of(Overflow overflow) {
    const auto [place, is_new] =
        numbers_.emplace(std::move(overflow), static_cast<Number>(overflows_.size()));
    if (is_new) {
        overflows_.push_back(place->first);
        kept_ += 2 * sizeof(Symbol) * place->first.word.size() + 160;
    }
    return place->second;
}

/// What was read stands for a prefix of the last word; the overflow where reading stopped and the letters
/// agreed on after it say how far the next words agree.
Integer OverflowWalk::position(const std::vector<Reading>& open, std::size_t agreed) const {
    Integer found(agreed);
    for (const Reading& reading : open)
        for (std::size_t i = 0; i < reading.read; ++i)
            found += lengths_[reading.level + 1][row_[(*reading.word)[i]]];
    const Overflow& overflow = overflows_[open.back().at];
    if (overflow.ahead == Overflow::Ahead::left) found -= Integer(overflow.word.size());
    return found;
}

void OverflowWalk::check_memory() const {
    budget_.check();
    budget_.check_memory(kept_, "the overflows of one word over the other");
}

}  // namespace algae
