#include "exchange/conversion.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include "base/error.hpp"
#include "exchange/relative_format.hpp"
#include "exchange/system_format.hpp"
#include "exchange/system_of_cells.hpp"
#include "nature/curve_functions.hpp"
#include "notation/characters.hpp"
#include "notation/format.hpp"
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

/// The relative of a kind that the text of a file says, whatever the end of its name.
std::unique_ptr<Relative> relative_of(const std::string& kind_name, std::string_view text,
                                      const std::string& name) {
    const RelativeKind& kind = *relative_kind("." + kind_name);
    return kind.make(read_relative_file(text, name, kind.keys));
}

std::string cells_to_system(std::string_view text, const std::string& name, const Budget&) {
    const auto relative = relative_of("ca", text, name);
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

/// What else a file of a format can become.
std::vector<std::string> targets(const std::string& from) {
    std::vector<std::string> all;
    const auto add = [&](const std::string& to) {
        if (to != from && std::find(all.begin(), all.end(), to) == all.end()) all.push_back(to);
    };
    for (const Conversion& one : conversions())
        if (one.from == from) add(one.to);
    if (system_format("." + from))
        for (const SystemFormat& other : system_formats()) add(other.name);  // by way of lsys
    return all;
}

/// Every format, in the order of the alphabet.
std::vector<std::string> format_names() {
    std::vector<std::string> all{"lsys"};
    for (const RelativeKind& kind : relative_kinds()) all.push_back(kind.ending);
    for (const SystemFormat& format : system_formats()) all.push_back(format.name);
    for (const RelativeFormat& format : relative_formats()) all.push_back(format.name);
    std::sort(all.begin(), all.end());
    return all;
}

std::string listed(const std::vector<std::string>& names, const char* last) {
    std::string all;
    for (std::size_t i = 0; i < names.size(); ++i)
        all += (i == 0 ? "" : i + 1 == names.size() ? last : ", ") + names[i];
    return all;
}

[[noreturn]] void refuse(const std::string& name, const std::string& from, const std::string& to) {
    const std::vector<std::string> known = format_names();
    const auto is_known = [&](const std::string& format) {
        return std::find(known.begin(), known.end(), format) != known.end();
    };
    const auto no_format = [&](const std::string& format,
                               const std::vector<std::string>& expected) {
        return Error(name + ": " + algae::quoted(format) + " is no format; expected " +
                     (expected.size() > 1 ? "one of " : "") + listed(expected, ", "));
    };
    if (!is_known(from)) throw no_format(from, known);
    std::vector<std::string> possible = targets(from);
    if (!is_known(to)) {
        possible.push_back(from);
        throw no_format(to, possible);
    }
    throw Error(name + ": cannot convert " + from + " to " + to + "; " + from + " converts to " +
                (possible.empty() ? "nothing" : listed(possible, " and ")));
}

const SystemFormat* format_called(const std::string& name) { return system_format("." + name); }

/// The text of a format in its canonical form; nothing where that takes another way.
std::optional<std::string> canonical_text(std::string_view text, const std::string& name,
                                          const std::string& format) {
    if (format == "lsys") return format_lsystem(text, name);
    if (const RelativeKind* kind = relative_kind("." + format)) {
        const RelativeFile file = read_relative_file(text, name, kind->keys);
        kind->make(file);
        return print_relative_file(file);
    }
    if (const RelativeFormat* table = relative_format("." + format)) {
        const RelativeKind& kind = *relative_kind("." + table->kind);
        return table->print(*kind.make(table->read(text, name)));
    }
    return std::nullopt;
}

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
    if (from == to)
        if (const auto canonical = canonical_text(text, name, from)) return *canonical;
    for (const Bridge& one : bridges())
        if (one.from == from && one.to == to) return one.convert(text, name, budget);
    if (const RelativeFormat* table = table_of(from, to))
        return print_relative_file(table->read(text, name));
    if (const RelativeFormat* table = table_of(to, from))
        return table->print(*relative_of(from, text, name));
    const SystemFormat *source = format_called(from), *target = format_called(to);
    if ((source || from == "lsys") && (target || to == "lsys") && (source || target)) {
        const LSystem system = source ? source->read(text, name) : read_lsystem(text, name);
        return target ? target->print(system) : print_lsystem(system);
    }
    refuse(name, from, to);
}

}  // namespace algae
