#include "cli/growth_interaction.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "fold/interaction.hpp"

namespace algae::cli {

int growth_interaction(const IL& system, std::pair<std::uint64_t, std::uint64_t> generations, bool json,
                       const Budget& budget) {
    auto lengths = derived_lengths(system, generations.second, budget);
    lengths.erase(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(generations.first));
    if (json)
        print(nlohmann::ordered_json{{"class", "unknown"}, {"from", generations.first}, {"lengths", lengths}}.dump(2) + "\n");
    else
        print(fmt::format("lengths, n = {}..{}\n{}\n"
                          "Letters look at their neighbours, so there is no growth matrix and no recurrence to go by:\n"
                          "these lengths are derived, and nothing is claimed beyond them.\n",
                          generations.first, generations.second, fmt::join(lengths, ", ")));
    return success;
}

}  // namespace algae::cli
