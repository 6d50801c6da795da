#include "verify/family.hpp"

#include "base/error.hpp"

namespace algae {

std::string to_string(Family family) {
    return std::string(family.propagating ? "P" : "") + (family.deterministic ? "D" : "") +
           (family.tables ? "T" : "") + "0L";
}

Family family_named(std::string_view name) {
    for (const Family family : all_families())
        if (to_string(family) == name) return family;
    throw Error(
        "expected one of the families 0L, P0L, D0L, PD0L, T0L, PT0L, DT0L and PDT0L, found '" +
        std::string(name) + "'");
}

const std::array<Family, 8>& all_families() {
    static constexpr std::array<Family, 8> all = {{{false, false, false},
                                                   {true, false, false},
                                                   {false, true, false},
                                                   {true, true, false},
                                                   {false, false, true},
                                                   {true, false, true},
                                                   {false, true, true},
                                                   {true, true, true}}};
    return all;
}

}  // namespace algae
