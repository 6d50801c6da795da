#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "language/equivalence_counts.hpp"

namespace algae {

/// For all n: word number left + n step of one sequence and number right + n stride of the other.
struct Section {
    std::uint64_t left = 0, step = 1, right = 0, stride = 1;
    bool operator==(const Section&) const = default;
};

/// Which words of two sequences are to be compared: single ones (numbers on the left and on the right), and
/// sections. Each sequence's numbers all occur, each once.
struct SectionPlan {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> words;
    std::vector<Section> sections;
};

/// The plan that pairs words with the same letter counts, for all n, if there is one that shows in the
/// generations worked out. That counts agree throughout a section is proved: both obey linear recurrences
/// whose orders are the numbers of accessible letters, so as many first terms as both together decide.
/// May work out further generations.
std::optional<SectionPlan> section_plan(GenerationCounts& left, GenerationCounts& right,
                                        std::size_t letters, const Budget& budget);

/// Whether every number from 0 on is one of these, or of these arithmetic progressions (first, difference).
///
/// Example: covers_all({0}, {{1, 2}, {2, 2}}) && !covers_all({}, {{0, 2}})
bool covers_all(const std::vector<std::uint64_t>& single,
                const std::vector<std::pair<std::uint64_t, std::uint64_t>>& progressions);

}  // namespace algae
