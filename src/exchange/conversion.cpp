#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"
#include "nature/nature.hpp"

// What can become what: the registry of formats and the conversions between them.
//
// Formats of other programs for systems all go by way of `lsys`: to it and from it, and so from any one to
// any other. A printed table goes to and from the kind of file that says the same. Only two conversions go
// between kinds of generators: a curve drawn by a system to its graph-directed iterated function system, and
// a cellular automaton on a line to a system with interactions. For the latter, each local configuration is a
// rule, and near the ends of the word, where context is missing, rules with shorter contexts take the fixed
// state outside for it; the longest context wins.

namespace algae {

namespace {

/// Files that end in `.l` are those of three programs, or panels of vlab, which hold no system.
Model read_l(std::string_view text, const std::string& name) {
    const bool is_of_vlab =
        looks_like_cpfg(text) || looks_like_lpfg(text) || looks_like_panel(text);
    return is_of_vlab ? read_cpfg(text, name) : read_fractint(text, name);
}

}  // namespace

const std::vector<SystemFormat>& system_formats() {
    static const std::vector<SystemFormat> all{
        {"brno", "a text file of a geometric interpreter of D0L systems", read_brno, print_brno},
        {"maple", "a worksheet that calls the Maple procedure Lsystem", read_maple, print_maple},
        {"netlogo", "the setup procedure of a NetLogo model of L-systems", read_netlogo,
         print_netlogo},
        {"l", "a file of systems of Fractint, of which FILE.l:NAME is one, or of cpfg", read_l,
         print_fractint},
        {"cpfg", "a system of cpfg", read_cpfg, print_cpfg},
        {"lpfg", "the declarative part of a program of lpfg", read_lpfg, print_lpfg},
        {"lpy", "the declarative part of a system of L-Py", read_lpy, print_lpy},
        {"inkscape", "the fields of Inkscape's L-system", read_inkscape, print_inkscape},
        {"tikz", "a system of the TikZ library lindenmayersystems", read_tikz, print_tikz},
        {"jff", "an L-system of JFLAP", read_jflap, print_jflap},
        {"walnut", "a morphism or a word automaton of Walnut", read_walnut, print_walnut},
        {"sage", "a WordMorphism of Sage", read_sage, print_sage},
    };
    return all;
}

namespace {

/// The format whose files end as this name does; nullptr if none of them is it.
template <class Format>
const Format* ending(std::string_view file_name, const std::vector<Format>& formats) {
    const auto found = std::ranges::find_if(
        formats, [&](const Format& one) { return file_name.ends_with("." + one.name); });
    return found == formats.end() ? nullptr : &*found;
}

}  // namespace

std::pair<std::string, std::string> file_and_entry(const std::string& name) {
    const std::size_t dot = name.rfind(".l:");
    if (dot == std::string::npos) return {name, {}};
    return {name.substr(0, dot + 2), name.substr(dot + 3)};
}

const SystemFormat* system_format(std::string_view file_name) {
    if (const auto [file, entry] = file_and_entry(std::string(file_name)); !entry.empty())
        return ending(file, system_formats());
    return ending(file_name, system_formats());
}

const SystemFormat* system_format_of(std::string_view text) {
    if (looks_like_cpfg(text) || looks_like_lpfg(text)) return system_format(".cpfg");
    if (looks_like_fractint(text)) return system_format(".l");
    if (looks_like_walnut(text)) return system_format(".walnut");
    return nullptr;
}

const std::vector<GeneratorFormat>& generator_formats() {
    static const std::vector<GeneratorFormat> all{
        {"ca-table", "ca", "the table of a rule of cells on a line", read_ca_table, print_ca_table},
        {"ifs-table", "ifs", "the table of an iterated function system", read_ifs_table,
         print_ifs_table}};
    return all;
}

const GeneratorFormat* generator_format(std::string_view file_name) {
    return ending(file_name, generator_formats());
}

namespace {

constexpr std::size_t most_rules = 20'000;

std::size_t power(std::size_t base, std::size_t exponent) {
    std::size_t product = 1;
    while (exponent-- > 0) product = std::min(product * base, most_rules + 1);
    return product;
}

}  // namespace

Model system_of_cells(const CellularAutomaton& automaton) {
    const CellRule& rule = automaton.rule;
    if (rule.dimensions != 1)
        throw Error(automaton.name + ": lies in the plane, and the letters of a word on a line");
    if (automaton.boundary.periodic)
        throw Error(automaton.name +
                    ": its edges are joined, and no context of a word reaches from its end to its "
                    "beginning; expected `boundary fixed 0` or another state");
    const auto radius = static_cast<std::size_t>(rule.radius());
    std::size_t count = 0;
    for (std::size_t left = 0; left <= radius; ++left)
        for (std::size_t right = 0; right <= radius; ++right)
            count += power(rule.states, left + 1 + right);
    if (count > most_rules) throw Error(automaton.name + ": would have more than 20000 rules");
    std::string text;
    if (!automaton.title.empty()) text += "title " + automaton.title + "\n";
    if (!automaton.source.empty()) text += "source " + automaton.source + "\n";
    text += "axiom " + state_text(automaton.start.cells) + "\n";
    // The longest contexts first.
    for (std::size_t size = 2 * radius + 1; size-- > 0;)
        for (std::size_t left = size > radius ? size - radius : 0; left <= std::min(size, radius);
             ++left) {
            const std::size_t right = size - left;
            for (std::size_t number = 0; number < power(rule.states, size + 1); ++number) {
                const auto seen = local_configuration(number, rule.states, size + 1);
                std::size_t local = 0;
                for (std::size_t i = 0; i < 2 * radius + 1; ++i) {
                    const bool inside = i + left >= radius && i <= radius + right;
                    local = local * rule.states +
                            (inside ? seen[i + left - radius] : automaton.boundary.outside);
                }
                const std::string word = state_text(seen);
                if (left > 0) text += word.substr(0, left) + " < ";
                text += word[left];
                if (right > 0) text += " > " + word.substr(left + 1);
                text += fmt::format(" -> {}\n", state_character(rule.table[local]));
            }
        }
    return read_lsystem(text, automaton.name);
}

namespace {

std::string curve_to_functions(std::string_view text, const std::string& name,
                               const Budget& budget) {
    return print_generator_file(ifs_file(functions_of_curve(read_lsystem(text, name), budget)));
}

/// The generator of a kind that the text of a file says, whatever the end of its name.
std::unique_ptr<Generator> generator_of(const std::string& kind_name, std::string_view text,
                                        const std::string& name) {
    const GeneratorKind& kind = *generator_kind("." + kind_name);
    return kind.make(read_generator_file(text, name, kind.keys));
}

std::string cells_to_system(std::string_view text, const std::string& name, const Budget&) {
    const auto generator = generator_of("ca", text, name);
    return print_lsystem(system_of_cells(dynamic_cast<const CellularAutomaton&>(*generator)));
}

/// Between kinds of generators.
struct Bridge : Conversion {
    std::string (*convert)(std::string_view text, const std::string& name, const Budget& budget);
};

const std::vector<Bridge>& bridges() {
    static const std::vector<Bridge> all{
        {{"ca", "lsys", "a cellular automaton as a system with interactions"}, cells_to_system},
        {{"lsys", "ifs", "a curve's graph-directed iterated function system"}, curve_to_functions},
        {{"jff", "claim", "a finite automaton or a grammar of JFLAP as a language"},
         [](std::string_view text, const std::string& name, const Budget&) {
             return language_of_jflap(text, name);
         }}};
    return all;
}

/// The format that is a table of the other kind of generators; nullptr if it is none.
const GeneratorFormat* table_of(const std::string& name, const std::string& kind) {
    const GeneratorFormat* const format = generator_format("." + name);
    return format && format->kind == kind ? format : nullptr;
}

/// What else a file of a format can become.
std::vector<std::string> targets(const std::string& from) {
    std::vector<std::string> all;
    const auto add = [&](const std::string& to) {
        if (to != from && std::ranges::count(all, to) == 0) all.push_back(to);
    };
    for (const Conversion& one : conversions())
        if (one.from == from) add(one.to);
    if (system_format("." + from))
        for (const SystemFormat& other : system_formats()) add(other.name);  // by way of lsys
    return all;
}

/// Every format, in the order of the alphabet.
std::vector<std::string> format_names() {
    std::vector<std::string> all{"lsys", "claim"};
    for (const GeneratorKind& kind : generator_kinds()) all.push_back(kind.ending);
    for (const SystemFormat& format : system_formats()) all.push_back(format.name);
    for (const GeneratorFormat& format : generator_formats()) all.push_back(format.name);
    std::sort(all.begin(), all.end());
    return all;
}

[[noreturn]] void refuse(const std::string& name, const std::string& from, const std::string& to) {
    const std::vector<std::string> known = format_names();
    const auto check = [&](const std::string& format, const std::vector<std::string>& expected) {
        if (std::ranges::count(known, format) == 0)
            throw Error(fmt::format("{}: {} is no format; expected {}{}", name,
                                    algae::quoted(format), expected.size() > 1 ? "one of " : "",
                                    fmt::join(expected, ", ")));
    };
    check(from, known);
    std::vector<std::string> possible = targets(from);
    possible.push_back(from);
    check(to, possible);
    possible.pop_back();
    throw Error(fmt::format("{0}: cannot convert {1} to {2}; {1} converts to {3}", name, from, to,
                            possible.empty() ? "nothing" : listed(possible, " and ")));
}

/// The text of a format in its canonical form; nothing where that takes another way.
std::optional<std::string> canonical_text(std::string_view text, const std::string& name,
                                          const std::string& format) {
    if (format == "lsys") return format_lsystem(text, name);
    if (const GeneratorKind* kind = generator_kind("." + format)) {
        const GeneratorFile file = read_generator_file(text, name, kind->keys);
        kind->make(file);
        return print_generator_file(file);
    }
    if (const GeneratorFormat* table = generator_format("." + format)) {
        const GeneratorKind& kind = *generator_kind("." + table->kind);
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
    for (const GeneratorFormat& format : generator_formats()) {
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
    if (const GeneratorFormat* table = table_of(from, to))
        return print_generator_file(table->read(text, name));
    if (const GeneratorFormat* table = table_of(to, from))
        return table->print(*generator_of(from, text, name));
    const SystemFormat *source = system_format("." + from), *target = system_format("." + to);
    if ((source || from == "lsys") && (target || to == "lsys") && (source || target)) {
        const Model system = source ? source->read(text, name) : read_lsystem(text, name);
        return target ? target->print(system) : print_lsystem(system);
    }
    refuse(name, from, to);
}

}  // namespace algae
