// Runs by Lyndon roots (Bannai, I, Inenaga, Nakashima, Takeda and Tsuruta, "The runs theorem", 2017): each run has a root that is the longest
// Lyndon word from its place on, in one of the two orders of letters. So these n + n words are all that has to be looked at.

#include <algorithm>
#include <map>
#include <tuple>

#include "combinatorics/detail/suffix_array.hpp"
#include "watch/watch.hpp"

namespace algae {

namespace {

/// By place: where the longest Lyndon word from there on ends: where the next suffix begins that is smaller (or greater).
std::vector<std::int32_t> ends_of_lyndon_words(const SuffixArray& suffixes, bool upwards) {
    const std::size_t n = suffixes.size();
    std::vector<std::int32_t> ends(n);
    for (std::size_t i = n; i-- > 0;) {
        std::size_t end = i + 1;
        while (end < n && (suffixes.rank(end) > suffixes.rank(i)) == upwards)
            end = static_cast<std::size_t>(ends[end]);
        ends[i] = static_cast<std::int32_t>(end);
    }
    return ends;
}

std::vector<Run> runs_of(const Word& word, const SuffixArray& suffixes, const CommonPrefixes& alike,
                         const Budget& budget) {
    const std::size_t n = word.size();
    const Word turned(word.rbegin(), word.rend());
    const SuffixArray turned_suffixes(turned, budget);
    const CommonPrefixes alike_before(turned_suffixes);
    std::vector<Run> found;
    WorkCount letters("letter for repetitions", 2 * n);
    for (const bool upwards : {true, false}) {
        budget.check();
        const std::vector<std::int32_t> ends = ends_of_lyndon_words(suffixes, upwards);
        for (std::size_t i = 0; i < n; ++i) {
            if (i % 65536 == 0) budget.check();
            ++letters;
            const auto end = static_cast<std::size_t>(ends[i]);
            if (end == n && !upwards)
                continue;  // downwards the end is the greatest letter, and belongs to this word
            const std::size_t after = alike(i, end), before = alike_before(n - i, n - end);
            const std::size_t period = end - i;
            if (before + after >= period) found.push_back({i - before, end + after, period});
        }
    }
    const auto key = [](const Run& run) { return std::tuple(run.begin, run.period, run.end); };
    std::ranges::sort(found, {}, key);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

/// How many numbers below `period` lie in some of the intervals, which go round; each has a beginning below `period` and a length of at most that.
std::uint64_t covered(std::vector<std::pair<std::size_t, std::size_t>> intervals,
                      std::size_t period) {
    for (std::size_t i = 0, size = intervals.size(); i < size; ++i) {
        auto& [begin, length] = intervals[i];
        if (begin + length <= period) continue;
        const std::size_t over = begin + length - period;
        length -= over;
        intervals.emplace_back(0, over);
    }
    std::ranges::sort(intervals);
    std::uint64_t count = 0;
    std::size_t done = 0;
    for (const auto& [begin, length] : intervals) {
        const std::size_t end = begin + length;
        if (end <= done) continue;
        count += end - std::max(begin, done);
        done = end;
    }
    return count;
}

/// A square is (uu)^k with u primitive: a rotation of the root of the runs in which it occurs. So the runs with one root are looked at
/// together, and rotations are counted.
std::uint64_t distinct_squares(const Word& word, const std::vector<Run>& runs,
                               const SuffixArray& suffixes, const CommonPrefixes& alike,
                               const Budget& budget) {
    struct Rooted {
        std::size_t period, rank, root;
        const Run* run;
    };
    std::vector<Rooted> rooted;
    rooted.reserve(runs.size());
    for (const Run& run : runs) {
        const auto at = word.begin() + static_cast<std::ptrdiff_t>(run.begin);
        const std::size_t root =
            run.begin + least_rotation(Word(at, at + static_cast<std::ptrdiff_t>(run.period)));
        rooted.push_back({run.period, suffixes.rank(root), root, &run});
    }
    std::ranges::sort(rooted, {},
                      [](const Rooted& one) { return std::pair(one.period, one.rank); });
    std::uint64_t count = 0;
    for (std::size_t first = 0, last = 0; first < rooted.size(); first = last) {
        budget.check();
        const std::size_t period = rooted[first].period;
        std::map<std::size_t, std::vector<std::pair<std::size_t, std::size_t>>>
            rotations;  // by exponent
        for (last = first;
             last < rooted.size() && rooted[last].period == period &&
             (last == first || alike(rooted[last - 1].root, rooted[last].root) >= period);
             ++last) {
            const Run& run = *rooted[last].run;
            const std::size_t length = run.end - run.begin;
            const std::size_t begin = (run.begin + period - rooted[last].root % period) % period;
            for (std::size_t k = 1; 2 * k * period <= length; ++k)
                rotations[k].emplace_back(begin, std::min(period, length - 2 * k * period + 1));
        }
        for (auto& [exponent, intervals] : rotations)
            count += covered(std::move(intervals), period);
    }
    return count;
}

}  // namespace

WordRepetitions repetitions_in(const Word& word, const Budget& budget) {
    if (word.empty()) return {};
    budget.check_memory(std::uint64_t{60} * word.size(), "the runs of the word");
    const SuffixArray suffixes(word, budget);
    const CommonPrefixes alike(suffixes);
    WordRepetitions found;
    found.runs = runs_of(word, suffixes, alike, budget);
    found.distinct_squares = distinct_squares(word, found.runs, suffixes, alike, budget);
    for (const Run& run : found.runs) {
        const Rational exponent(Integer(run.end - run.begin), Integer(run.period));
        if (!found.greatest_exponent || *found.greatest_exponent < exponent)
            found.greatest_exponent = exponent;
    }
    return found;
}

}  // namespace algae
