#include "language/equivalence_counts.hpp"

#include <algorithm>

#include "language/equivalence_finite.hpp"
#include "language/finiteness_letters.hpp"

namespace algae {

GenerationCounts::GenerationCounts(const D0L& system, const Budget& budget)
    : system_(system),
      budget_(budget),
      matrix_(growth_matrix(system)),
      row_(axiom_counts(system)),
      letter_lengths_(matrix_.size(), Integer(1)) {
    const LetterFutures futures = letter_futures(ol_of(system));
    for (std::size_t i = 0; i < system.letters.size(); ++i)
        if (futures.growing[system.letters[i]]) growing_.push_back(i);
}

void GenerationCounts::extend(std::uint64_t size) {
    while (counts_.size() < size) {
        budget_.check();
        LetterCounts counts(system_.alphabet->size());
        Integer length;
        for (std::size_t i = 0; i < row_.size(); ++i) {
            length += row_[i];
            kept_ += 4 * sizeof(Integer) + bit_length(row_[i]) / 4;
            counts[system_.letters[i]] = std::move(row_[i]);
        }
        budget_.check_memory(kept_, "the numbers of letters of the generations");
        for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = counts[system_.letters[i]];
        row_ = row_ * matrix_;
        letter_lengths_ = matrix_ * letter_lengths_;
        generations_.emplace(counts, counts_.size());
        counts_.push_back(std::move(counts));
        lengths_.push_back(std::move(length));
    }
}

std::optional<std::uint64_t> GenerationCounts::generation_of(const LetterCounts& counts) const {
    const auto found = generations_.find(counts);
    return found == generations_.end() ? std::nullopt : std::optional(found->second);
}

Integer GenerationCounts::least_later_length() const {
    Integer least = letter_lengths_[growing_.front()];
    for (const std::size_t i : growing_) least = std::min(least, letter_lengths_[i]);
    return least;
}

}  // namespace algae
