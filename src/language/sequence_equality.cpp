#include "language/sequence_equality.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "fold/letter.hpp"
#include "growth/incidence.hpp"
#include "language/sequence_walk.hpp"

namespace algae {

namespace {

constexpr std::uint64_t letters_before = 8, letters_shown = 20;

Word letters_from(const D0L& system, std::uint64_t generation, const Integer& from,
                  const Integer& length, const Budget& budget) {
    return from < length ? letters_at(system, generation, from, letters_shown, budget) : Word{};
}

SequenceEquality different(const SequencePair& systems, std::uint64_t generation, Integer position,
                           const Budget& budget) {
    SequenceDifference found;
    found.generation = generation;
    found.from = std::max<Integer>(Integer(0), position - letters_before);
    found.position = std::move(position);
    found.left_length = length(systems.left, generation, budget);
    found.right_length = length(systems.right, generation, budget);
    found.left = letters_from(systems.left, generation, found.from, found.left_length, budget);
    found.right = letters_from(systems.right, generation, found.from, found.right_length, budget);
    return {false, std::nullopt, std::move(found)};
}

std::string tried(const OverflowWalk& walk) {
    std::size_t longest = 0;
    for (const Overflow& overflow : walk.overflows())
        longest = std::max(longest, overflow.word.size());
    return "generations 0 to " + std::to_string(walk.generations()) + " are the same, with " +
           std::to_string(walk.overflows().size()) + " overflows of up to " +
           std::to_string(longest) + " letters so far, and these do not prove that all are";
}

}  // namespace

SequenceEquality equal_sequences(const D0L& left, const D0L& right, const Budget& budget) {
    const SequencePair systems = over_common_alphabet(left, right);
    const Word &first = systems.left.axiom, &second = systems.right.axiom;
    if (first != second) {
        const auto at =
            std::mismatch(first.begin(), first.end(), second.begin(), second.end()).first;
        return different(systems, 0, Integer(at - first.begin()), budget);
    }
    OverflowWalk walk(systems, budget);
    try {
        for (std::uint64_t next_attempt = 0;;) {
            const std::size_t known = walk.overflows().size();
            const std::uint64_t generation = walk.generations();
            if (auto position = walk.next_difference())
                return different(systems, generation + 1, std::move(*position), budget);
            if (generation < next_attempt || walk.overflows().size() > known) continue;
            BalanceAttempt attempt = try_balance(systems, walk.overflows(), budget);
            if (attempt.balance) return {true, std::move(attempt.balance), std::nullopt};
            next_attempt = attempt.generation + 1;
        }
    } catch (const BoundReached& bound) {
        throw BoundReached(bound.bound(), bound.what(), tried(walk));
    }
}

}  // namespace algae
