#include "language/equivalence_sections.hpp"

#include <algorithm>
#include <numeric>

namespace algae {

namespace {

using Partners = std::vector<
    std::uint64_t>;  // by generation of the left system: the right one's with its counts

constexpr std::uint64_t longest_cycle = 1'000'000;  // of the numbers that progressions cover

Partners partners(const GenerationCounts& left, const GenerationCounts& right) {
    Partners found;
    for (std::size_t n = 0; n < left.size(); ++n) {
        const auto partner = right.generation_of(left[n]);
        if (!partner) break;
        found.push_back(*partner);
    }
    return found;
}

/// Sections with this step that begin where the partners become regular, if that is soon enough to believe it.
std::optional<SectionPlan> plan_with_step(const Partners& found, std::size_t step) {
    if (found.size() < 4 * step) return std::nullopt;
    const auto advance = [&](std::size_t n) {
        return static_cast<std::int64_t>(found[n + step] - found[n]);
    };
    std::size_t begin = found.size() - step;
    while (begin > 0 && advance(begin - 1) > 0 &&
           (begin + step > found.size() - step || advance(begin - 1) == advance(begin - 1 + step)))
        --begin;
    if (found.size() - begin < std::max(4 * step, found.size() / 2)) return std::nullopt;
    SectionPlan plan;
    for (std::size_t n = 0; n < begin; ++n) plan.words.emplace_back(n, found[n]);
    for (std::size_t n = begin; n < begin + step; ++n)
        plan.sections.push_back({n, step, found[n], static_cast<std::uint64_t>(advance(n))});
    return plan;
}

bool covers_right(const SectionPlan& plan) {
    std::vector<std::uint64_t> single;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> progressions;
    for (const auto& [left, right] : plan.words) single.push_back(right);
    for (const Section& section : plan.sections)
        progressions.emplace_back(section.right, section.stride);
    return covers_all(single, progressions);
}

bool counts_agree(const SectionPlan& plan, GenerationCounts& left, GenerationCounts& right,
                  std::size_t letters) {
    for (const Section& section : plan.sections) {
        left.extend(section.left + letters * section.step + 1);
        right.extend(section.right + letters * section.stride + 1);
        for (std::size_t k = 0; k < letters; ++k)
            if (left[section.left + k * section.step] != right[section.right + k * section.stride])
                return false;
    }
    return true;
}

}  // namespace

bool covers_all(const std::vector<std::uint64_t>& single,
                const std::vector<std::pair<std::uint64_t, std::uint64_t>>& progressions) {
    std::uint64_t from = 0, cycle = 1;
    for (const std::uint64_t n : single) from = std::max(from, n + 1);
    for (const auto& [first, difference] : progressions) {
        from = std::max(from, first);
        cycle = std::lcm(cycle, difference);
        if (cycle > longest_cycle || from > longest_cycle) return false;
    }
    std::vector<char> covered(static_cast<std::size_t>(from + cycle), 0);
    for (const std::uint64_t n : single) covered[static_cast<std::size_t>(n)] = 1;
    for (const auto& [first, difference] : progressions)
        for (std::uint64_t n = first; n < covered.size(); n += difference)
            covered[static_cast<std::size_t>(n)] = 1;
    return std::find(covered.begin(), covered.end(), 0) == covered.end();
}

std::optional<SectionPlan> section_plan(GenerationCounts& left, GenerationCounts& right,
                                        std::size_t letters, const Budget& budget) {
    const Partners found = partners(left, right);
    for (std::size_t step = 1; 4 * step <= found.size(); ++step) {
        budget.check();
        auto plan = plan_with_step(found, step);
        if (plan && covers_right(*plan) && counts_agree(*plan, left, right, letters)) return plan;
    }
    return std::nullopt;
}

}  // namespace algae
