#include "exchange/conversion.hpp"

#include "base/error.hpp"
#include "exchange/relative_format.hpp"
#include "exchange/system_format.hpp"
#include "exchange/system_of_cells.hpp"
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
    const RelativeKind& kind = *relative_kind(".ca");
    const auto relative = kind.make(read_relative_file(text, name, kind.keys));
    return print_lsystem(system_of_cells(dynamic_cast<const CellularAutomaton&>(*relative)));
}

/// Between kinds of generators.
struct Bridge : Conversion {
    std::string (*convert)(std::string_view text, const std::string& name, const Budget& budget);
};

const std::vector<Bridge>& bridges() {
    static const std::vector<Bridge> all{
        {{"ca", "lsys", "a cellular automaton as a system with interactions"}, cells_to_system},
        {{"lsys", "ifs", "a curve's graph-directed iterated function system"}, curve_to_functions}};
    return all;
}

/// The format that is a table of the other kind of relatives; nullptr if it is none.
const RelativeFormat* table_of(const std::string& name, const std::string& kind) {
    const RelativeFormat* const format = relative_format("." + name);
    return format && format->kind == kind ? format : nullptr;
}

const SystemFormat* format_called(const std::string& name) { return system_format("." + name); }

}  // namespace

std::vector<Conversion> conversions() {
    std::vector<Conversion> all(bridges().begin(), bridges().end());
    for (const SystemFormat& format : system_formats()) {
        all.push_back({format.name, "lsys", format.what});
        all.push_back({"lsys", format.name, format.what});
    }
    for (const RelativeFormat& format : relative_formats()) {
        all.push_back({format.name, format.kind, format.what});
        all.push_back({format.kind, format.name, format.what});
    }
    return all;
}

std::string converted(std::string_view text, const std::string& name, const std::string& from,
                      const std::string& to, const Budget& budget) {
    for (const Bridge& one : bridges())
        if (one.from == from && one.to == to) return one.convert(text, name, budget);
    if (const RelativeFormat* table = table_of(from, to))
        return print_relative_file(table->read(text, name));
    if (const RelativeFormat* table = table_of(to, from)) {
        const RelativeKind& kind = *relative_kind("." + from);
        return table->print(*kind.make(read_relative_file(text, name, kind.keys)));
    }
    const SystemFormat *source = format_called(from), *target = format_called(to);
    if ((source || from == "lsys") && (target || to == "lsys") && (source || target)) {
        const LSystem system = source ? source->read(text, name) : read_lsystem(text, name);
        return target ? target->print(system) : print_lsystem(system);
    }
    std::string known;
    for (const Conversion& one : conversions())
        known += (known.empty() ? "" : ", ") + one.from + " to " + one.to;
    throw Error(name + ": cannot convert " + from + " to " + to + "; expected one of " + known);
}

}  // namespace algae
