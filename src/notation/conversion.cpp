#include "notation/conversion.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "nature/curve_functions.hpp"
#include "notation/ifs_file.hpp"
#include "notation/print.hpp"
#include "notation/read.hpp"
#include "notation/relative_reader.hpp"

namespace algae {

namespace {

std::string curve_to_functions(std::string_view text, const std::string& name,
                               const Budget& budget) {
    return print_relative_file(ifs_file(functions_of_curve(read_lsystem(text, name), budget)));
}

std::string cells_to_system(std::string_view text, const std::string& name, const Budget&) {
    const RelativeKind kind =
        *std::find_if(relative_kinds().begin(), relative_kinds().end(),
                      [](const RelativeKind& one) { return one.ending == "ca"; });
    const auto relative = kind.make(read_relative_file(text, name, kind.keys));
    return print_lsystem(system_of_cells(dynamic_cast<const CellularAutomaton&>(*relative)));
}

}  // namespace

const std::vector<Conversion>& conversions() {
    static const std::vector<Conversion> all{
        {"ca", "lsys", "a cellular automaton as a system with interactions", cells_to_system},
        {"lsys", "ifs", "a curve's graph-directed iterated function system", curve_to_functions}};
    return all;
}

std::string converted(std::string_view text, const std::string& name, const std::string& from,
                      const std::string& to, const Budget& budget) {
    std::string known;
    for (const Conversion& one : conversions()) {
        if (one.from == from && one.to == to) return one.convert(text, name, budget);
        known += (known.empty() ? "" : ", ") + one.from + " to " + one.to;
    }
    throw Error(name + ": cannot convert " + from + " to " + to + "; expected one of " + known);
}

}  // namespace algae
