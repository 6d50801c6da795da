#include "notation/suggestion.hpp"

#include <algorithm>

namespace algae {

std::size_t edit_distance(std::string_view left, std::string_view right) {
    std::vector<std::vector<std::size_t>> distance(left.size() + 1,
                                                   std::vector<std::size_t>(right.size() + 1));
    for (std::size_t i = 0; i <= left.size(); ++i) {
        for (std::size_t j = 0; j <= right.size(); ++j) {
            if (i == 0 || j == 0) {
                distance[i][j] = i + j;
                continue;
            }
            const std::size_t replaced = left[i - 1] == right[j - 1] ? 0 : 1;
            distance[i][j] = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1,
                                       distance[i - 1][j - 1] + replaced});
            if (i > 1 && j > 1 && left[i - 1] == right[j - 2] && left[i - 2] == right[j - 1])
                distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
        }
    }
    return distance[left.size()][right.size()];
}

std::string did_you_mean(std::string_view written, const std::vector<std::string>& candidates) {
    constexpr std::size_t shortest = 3, longest = 40;
    if (written.size() < shortest || written.size() > longest) return {};
    const std::string* best = nullptr;
    std::size_t least = (written.size() + 1) / 4;  // further than this is another word
    for (const std::string& candidate : candidates) {
        if (candidate.size() < shortest || candidate.size() > longest) continue;
        const std::size_t distance = edit_distance(written, candidate);
        if (distance >= least + (best ? 0 : 1)) continue;
        best = &candidate;
        least = distance;
    }
    return best ? "; did you mean '" + *best + "'?" : "";
}

}  // namespace algae
