#include "claim/closure_table.hpp"

#include "base/error.hpp"

namespace algae {

const std::vector<std::string>& closure_operations() {
    static const std::vector<std::string> all{"union",
                                              "concatenation",
                                              "star",
                                              "plus",
                                              "intersection",
                                              "intersection with regular",
                                              "complement",
                                              "homomorphism",
                                              "non-erasing homomorphism",
                                              "inverse homomorphism",
                                              "reversal",
                                              "finite substitution",
                                              "substitution",
                                              "gsm mapping"};
    return all;
}

const std::vector<std::string>& closure_families() {
    static const std::vector<std::string> all{"REG", "CF",   "D0L",   "PD0L", "0L",
                                              "P0L", "DT0L", "PDT0L", "T0L",  "PT0L",
                                              "E0L", "ET0L", "EDT0L", "IL"};
    return all;
}

ClosureTable::ClosureTable(const std::vector<Claim>& claims) {
    std::map<std::pair<std::string, std::string>, Place> places;
    for (std::size_t i = 0; i < claims.size(); ++i)
        for (const ClosureFact& fact : claims[i].closure)
            for (const std::string& family : fact.families) {
                const auto key = std::pair(family, fact.operation);
                const auto [place, is_new] = places.emplace(key, fact.place);
                if (!is_new)
                    throw Error(to_string(fact.place) + ": whether " + family +
                                " is closed under " + fact.operation + " is settled at " +
                                to_string(place->second) + " already");
                cells_.emplace(key, Cell{fact.closed, i});
            }
}

std::optional<ClosureTable::Cell> ClosureTable::cell(std::string_view family,
                                                     std::string_view operation) const {
    const auto found = cells_.find(std::pair(std::string(family), std::string(operation)));
    return found == cells_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace algae
