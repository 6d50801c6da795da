#include "growth/components.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <numeric>

#include "growth/characteristic.hpp"

namespace algae {

namespace {

/// The part of the matrix that stays within a component.
GrowthMatrix part(const GrowthMatrix& matrix, const Component& component, const std::vector<std::size_t>& of_letter,
                  std::vector<std::size_t>& place) {
    const std::size_t self = of_letter[component.letters.front()];
    for (std::size_t i = 0; i < component.letters.size(); ++i) place[component.letters[i]] = i;
    GrowthMatrix found;
    found.rows.resize(component.letters.size());
    for (std::size_t i = 0; i < component.letters.size(); ++i) {
        for (const auto& [column, times] : matrix.rows[component.letters[i]])
            if (of_letter[column] == self) found.rows[i].push_back({place[column], times});
        std::sort(found.rows[i].begin(), found.rows[i].end(),
                  [](const auto& a, const auto& b) { return a.column < b.column; });
    }
    return found;
}

/// The greatest common divisor of all distance(from) + 1 - distance(to).
std::uint64_t cyclicity(const GrowthMatrix& part) {
    std::vector<std::int64_t> distance(part.size(), -1);
    std::vector<std::size_t> queue{0};
    distance[0] = 0;
    std::uint64_t divisor = 0;
    for (std::size_t i = 0; i < queue.size(); ++i)
        for (const auto& entry : part.rows[queue[i]]) {
            if (distance[entry.column] < 0) {
                distance[entry.column] = distance[queue[i]] + 1;
                queue.push_back(entry.column);
            }
            divisor = std::gcd(divisor, static_cast<std::uint64_t>(
                                            std::abs(distance[queue[i]] + 1 - distance[entry.column])));
        }
    return divisor;
}

Integer row_sum(const std::vector<GrowthMatrix::Entry>& row) {
    Integer sum;
    for (const auto& entry : row) sum += entry.times;
    return sum;
}

void analyse(Component& component, const GrowthMatrix& part, const Budget& budget) {
    component.characteristic = factorise(characteristic_polynomial(part, budget));
    if (part.rows[0].empty()) return;  // a letter that never returns: another one would have a way back
    component.cyclicity = cyclicity(part);
    Integer least = row_sum(part.rows[0]), most = least;
    for (const auto& row : part.rows) {
        least = std::min(least, row_sum(row));
        most = std::max(most, row_sum(row));
    }
    if (least == most)
        component.rate = Rate(most);
    else
        component.rate = spectral_radius(component.characteristic.powers, most);
}

}  // namespace

Components components(const GrowthMatrix& matrix, const Budget& budget) {
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
    Graph graph(matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (const auto& entry : matrix.rows[i]) boost::add_edge(i, entry.column, graph);
    Components found;
    found.of_letter.resize(matrix.size());
    const std::size_t count = boost::strong_components(
        graph, boost::make_iterator_property_map(found.of_letter.begin(), boost::get(boost::vertex_index, graph)));
    found.list.resize(count);
    std::vector<std::size_t> place(matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i) found.list[found.of_letter[i]].letters.push_back(i);
    for (std::size_t c = 0; c < count; ++c) {
        budget.check();
        Component& component = found.list[c];
        for (const std::size_t letter : component.letters)
            for (const auto& entry : matrix.rows[letter])
                if (found.of_letter[entry.column] != c) component.below.push_back(found.of_letter[entry.column]);
        std::sort(component.below.begin(), component.below.end());
        component.below.erase(std::unique(component.below.begin(), component.below.end()), component.below.end());
        analyse(component, part(matrix, component, found.of_letter, place), budget);
    }
    return found;
}

}  // namespace algae
