#include "cli/axes.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "axial/tree_system.hpp"
#include "cli/output.hpp"
#include "notation/characters.hpp"

namespace algae::cli {

void print_axes(const LSystem& system, std::uint64_t n, bool json, const Budget& budget) {
    const View<TreeSystem> trees = as_tree_system(*as_d0l(system));
    std::vector<char> edges;
    for (Symbol a = 0; a < system.alphabet.size(); ++a)
        edges.push_back(is_letter(first_character(system.alphabet.name(a)).code));
    const std::vector<OrderCount> counts =
        order_counts(restricted(derived_tree(*trees, n, budget), edges));
    if (json) {
        nlohmann::ordered_json orders = nlohmann::ordered_json::array();
        for (std::size_t order = 0; order < counts.size(); ++order)
            orders.push_back(
                {{"order", order}, {"axes", counts[order].axes}, {"edges", counts[order].edges}});
        print(nlohmann::ordered_json{{"orders", orders}}.dump(2) + "\n");
        return;
    }
    std::string text = counts.empty() ? "no edges\n" : "";
    for (std::size_t order = 0; order < counts.size(); ++order) {
        const auto& [axes, found] = counts[order];
        text += fmt::format("order {}: {} {}, {} {}\n", order, axes, axes == 1 ? "axis" : "axes",
                            found, found == 1 ? "edge" : "edges");
    }
    print(text);
}

}  // namespace algae::cli
