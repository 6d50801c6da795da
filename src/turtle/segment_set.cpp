#include "turtle/segment_set.hpp"

#include <algorithm>

namespace algae {

void SegmentSet::add(std::uint32_t from, std::uint32_t to) {
    const auto [low, high] = std::minmax(from, to);
    segments_.push_back(std::uint64_t{high} << 32 | low);
    if (segments_.size() % 65536 == 0)
        budget_.check_memory(segments_.capacity() * sizeof(std::uint64_t) + points_.bytes(),
                             "the segments");
}

Trace SegmentSet::result() {
    // Those of a curve that never crosses itself come in order.
    if (!std::is_sorted(segments_.begin(), segments_.end()))
        std::sort(segments_.begin(), segments_.end());
    const auto last = std::unique(segments_.begin(), segments_.end());
    std::vector<char> is_end(points_.size());
    for (auto it = segments_.begin(); it != last; ++it)
        is_end[*it & 0xFFFFFFFF] = is_end[*it >> 32] = 1;
    const auto vertices = std::count(is_end.begin(), is_end.end(), 1);
    return {static_cast<std::uint64_t>(last - segments_.begin()),
            static_cast<std::uint64_t>(vertices)};
}

}  // namespace algae
