#include "language/sequence_overflow.hpp"

#include <algorithm>

namespace algae {

OverflowStep overflow_step(const SequencePair& systems, const Overflow& overflow, Symbol letter) {
    const auto extended = [&](Overflow::Ahead side, const Word& image) {
        Word word = overflow.ahead == side ? overflow.word : Word{};
        word.insert(word.end(), image.begin(), image.end());
        return word;
    };
    const Word left = extended(Overflow::Ahead::left, systems.left.successor(letter));
    const Word right = extended(Overflow::Ahead::right, systems.right.successor(letter));
    const auto [at, other] = std::mismatch(left.begin(), left.end(), right.begin(), right.end());
    OverflowStep step;
    step.agreed = static_cast<std::size_t>(at - left.begin());
    if (at != left.end() && other != right.end()) return step;
    step.next = at != left.end() || other == right.end()
                    ? Overflow{Overflow::Ahead::left, Word(at, left.end())}
                    : Overflow{Overflow::Ahead::right, Word(other, right.end())};
    return step;
}

}  // namespace algae
