#include "language/equivalence_language.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "fold/derive.hpp"
#include "growth/incidence.hpp"
#include "language/equivalence_finite.hpp"
#include "language/finiteness.hpp"
#include "language/sequence_equality.hpp"

namespace algae {

namespace {

constexpr std::size_t first_size = 16;              // generations that are counted to begin with
constexpr std::uint64_t longest_tried = 4096;       // words up to this length are compared at once
constexpr std::uint64_t longest_shown = 1'000'000;  // letters of a witness

LanguageEquality not_equal(const SequencePair& systems, bool in_left, std::uint64_t generation,
                           std::optional<std::uint64_t> alike, const Budget& budget) {
    const D0L& system = in_left ? systems.left : systems.right;
    LanguageEquality found;
    found.difference = LanguageDifference{in_left, generation, length(system, generation, budget),
                                          std::nullopt, alike};
    if (found.difference->length <= Integer(std::min(longest_shown, budget.letters)))
        found.difference->word = derive(system, generation, budget);
    return found;
}

/// The system whose generation n is generation first + n step of this one.
D0L section_of(const D0L& system, std::uint64_t first, std::uint64_t step, const Budget& budget) {
    std::vector<Word> images(system.rules.images.size());
    for (const Symbol a : system.letters) images[a] = {a};
    for (std::uint64_t n = 0; n < step; ++n) {
        std::uint64_t letters = 0;
        for (const Symbol a : system.letters) {
            images[a] = system.rules(images[a]);
            letters += images[a].size();
            budget.check_memory(letters * sizeof(Symbol),
                                "the images of the letters under a power of the rules");
        }
        budget.check();
    }
    return make_d0l(system.alphabet, derive(system, first, budget), std::move(images), system.name);
}

/// Both languages infinite.
class InfiniteComparison {
public:
    InfiniteComparison(const SequencePair& systems, const Budget& budget)
        : systems_(systems),
          budget_(budget),
          left_(systems.left, budget),
          right_(systems.right, budget) {}

    LanguageEquality decided() {
        const std::size_t letters = systems_.left.letters.size() + systems_.right.letters.size();
        for (size_ = first_size;; size_ *= 2) {
            left_.extend(size_);
            right_.extend(size_);
            if (auto found = short_difference()) return std::move(*found);
            if (const auto plan = section_plan(left_, right_, letters, budget_))
                return compared(*plan);
        }
    }

    std::string tried() const {
        return "the numbers of letters of generations 0 to " + std::to_string(size_) +
               " were compared, and neither language is known to have a word that the other has "
               "not";
    }

private:
    /// Of the generations counted: the first word that is not in the other language, as far as that shows in
    /// letter counts, or it is short.
    std::optional<LanguageEquality> short_difference() {
        const Integer least_left = left_.least_later_length(),
                      least_right = right_.least_later_length();
        for (std::uint64_t n = 0; n < std::min(left_.size(), right_.size()); ++n) {
            const auto partner = right_.generation_of(left_[n]);
            if (!partner && left_.length(n) < least_right)
                return not_equal(systems_, true, n, std::nullopt, budget_);
            if (!left_.generation_of(right_[n]) && right_.length(n) < least_left)
                return not_equal(systems_, false, n, std::nullopt, budget_);
            if (partner && left_.length(n) <= Integer(longest_tried) && !same_word(n, *partner))
                return not_equal(systems_, true, n, partner, budget_);
        }
        return std::nullopt;
    }

    bool same_word(std::uint64_t left, std::uint64_t right) const {
        return derive(systems_.left, left, budget_) == derive(systems_.right, right, budget_);
    }

    LanguageEquality compared(const SectionPlan& plan) const {
        LanguageEquality found;
        found.words = plan.words;
        for (const auto& [left, right] : plan.words)
            if (!same_word(left, right)) return not_equal(systems_, true, left, right, budget_);
        std::optional<std::pair<std::uint64_t, std::uint64_t>> different;
        for (const Section& section : plan.sections) {
            SequenceEquality sequences = equal_sequences(
                section_of(systems_.left, section.left, section.step, budget_),
                section_of(systems_.right, section.right, section.stride, budget_), budget_);
            if (sequences.equal) {
                found.sections.push_back({section, std::move(*sequences.balance)});
                continue;
            }
            const std::uint64_t n = sequences.difference->generation;
            const std::pair at{section.left + n * section.step, section.right + n * section.stride};
            if (!different || at < *different) different = at;
        }
        if (different)
            return not_equal(systems_, true, different->first, different->second, budget_);
        found.equal = true;
        return found;
    }

    const SequencePair& systems_;
    const Budget& budget_;
    GenerationCounts left_, right_;
    std::size_t size_ = 0;
};

/// At least one language finite.
LanguageEquality finite_comparison(const SequencePair& systems, bool left_finite, bool right_finite,
                                   const Budget& budget) {
    std::set<Word> left, right;
    if (right_finite) {
        right = words_of(systems.right, budget);
        if (const auto n = first_generation_outside(systems.left, right, budget))
            return not_equal(systems, true, *n, std::nullopt, budget);
    }
    if (left_finite) {
        left = words_of(systems.left, budget);
        if (const auto n = first_generation_outside(systems.right, left, budget))
            return not_equal(systems, false, *n, std::nullopt, budget);
    }
    return {true, true, left.size(), {}, {}, std::nullopt};
}

}  // namespace

LanguageEquality equal_languages(const D0L& left, const D0L& right, const Budget& budget) {
    const SequencePair systems = over_common_alphabet(left, right);
    const bool left_finite = finiteness(ol_of(systems.left)).finite,
               right_finite = finiteness(ol_of(systems.right)).finite;
    if (left_finite || right_finite)
        return finite_comparison(systems, left_finite, right_finite, budget);
    InfiniteComparison comparison(systems, budget);
    try {
        return comparison.decided();
    } catch (const BoundReached& bound) {
        throw BoundReached(bound.bound(), bound.what(), comparison.tried());
    }
}

}  // namespace algae
