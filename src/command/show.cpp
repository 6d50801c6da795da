// The content of a file, and the same in another form: `show`, `fmt`, `convert`, and `gallery`, the files that
// come with algae.
//
// `show` prints the content of a system as one page or completely as JSON; only the page shortens a word that is too
// long for a screen. `fmt` keeps comments and refuses files of other programs, which `convert` reads
// and writes. A table of the room exchange lists the conversions; the help is made from it.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "report/report.hpp"
#include "system/system.hpp"

namespace algae::command {

namespace {

// show

struct ShowOptions {
    std::string file;
    std::vector<std::string> let;
    std::optional<std::uint64_t> generation;
    bool axes = false, json = false, latex = false;
    Bounds bounds;
};

/// How many axes and edges of each order the axial tree of generation n has. Edges are the symbols
/// whose names begin with a letter; signs such as + only say how the turtle turns.
void print_axes(const Model& system, std::uint64_t n, bool json, const Budget& budget) {
    const View<TreeSystem> trees = as_tree_system(*as_d0l(system));
    std::vector<char> edges;
    for (Symbol a = 0; a < system.alphabet.size(); ++a)
        edges.push_back(is_letter(first_character(system.alphabet.name(a)).code));
    const std::vector<OrderCount> counts =
        order_counts(restricted(derived_tree(*trees, n, budget), edges));
    if (json) {
        Json orders = Json::array();
        for (std::size_t order = 0; order < counts.size(); ++order)
            orders.add(
                {{"order", order}, {"axes", counts[order].axes}, {"edges", counts[order].edges}});
        print(Json{{"orders", orders}}.text());
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

int show(const ShowOptions& options) {
    const Budget budget = options.bounds.budget();
    const Model system = open_model(options.file, budget, options.let);
    if (options.axes != options.generation.has_value()) throw Error("--axes and -n go together");
    if (options.latex) refuse_with("--latex", {{"--axes", options.axes}});
    if (options.axes) {
        print_axes(system, *options.generation, options.json, budget);
        return success;
    }
    if (options.latex) {
        print(to_latex(system));
        return success;
    }
    const SystemReport report{system, class_of(system)};
    print_report(report, options.json);
    return success;
}

// fmt

struct FmtOptions {
    std::string file;
    std::vector<std::string> let;
    bool in_place = false;
    bool check = false;
    Bounds bounds;
};

[[noreturn]] void refuse_foreign(const std::string& name, const std::string& what,
                                 const std::string& to) {
    throw Error(name + " is " + what +
                "; expected a file of the notation, as `algae convert --to " + to +
                "` makes of it");
}

int format(const FmtOptions& options) {
    const SourceText source = open_text(options.file, options.bounds.budget(), options.let);
    if (const SystemFormat* foreign = system_format(source.name))
        refuse_foreign(source.name, foreign->what, "lsys");
    if (const GeneratorFormat* foreign = generator_format(source.name))
        refuse_foreign(source.name, foreign->what, foreign->kind);
    const std::string text = generator_kind(source.name)
                                 ? format_generator(source.text, source.name)
                                 : format_lsystem(source.text, source.name);
    if (options.check) return source.text == text ? success : refuted;
    if (!options.in_place) {
        print(text);
        return success;
    }
    std::error_code ignored;
    if (options.file == "-" || !std::filesystem::exists(options.file, ignored))
        throw Error("--in-place: expected a file, found " +
                    std::string(options.file == "-" ? "standard input"
                                : is_typed_system(options.file)
                                    ? "a system that is typed"
                                    : "the figure " + options.file + " of the gallery"));
    write_file(options.file, text, true);
    return success;
}

// convert

struct ConvertOptions {
    std::string file, from, to;
    std::vector<std::string> let;
    Bounds bounds;
};

/// The format of a text: by the extension of its name, which systems from the gallery have none of, otherwise by what stands in it.
std::string format_of(const SourceText& source) {
    const std::string& name = source.name;
    if (const SystemFormat* format = system_format(name)) return format->name;
    if (const SystemFormat* format = system_format_of(source.text);
        format && name != "-" && !name.ends_with(".lsys"))
        return format->name;
    const std::size_t dot = name.find_last_of('.'), slash = name.find_last_of('/');
    if (dot == std::string::npos || (slash != std::string::npos && slash > dot)) return "lsys";
    return name.substr(dot + 1);
}

int convert(const ConvertOptions& options) {
    const Budget budget = options.bounds.budget();
    const SourceText source = open_text(options.file, budget, options.let);
    const std::string from = options.from.empty() ? format_of(source) : options.from;
    print(converted(source.text, source.name, from, options.to, budget));
    return success;
}

// gallery

struct GalleryOptions {
    std::string find;
    bool json = false;
};

/// Whether every word of a search stands in a text, letters of either case.
bool is_found(const std::string& wanted, const std::string& text) {
    const auto lower = [](std::string from) {
        std::ranges::transform(from, from.begin(), [](unsigned char c) { return std::tolower(c); });
        return from;
    };
    const std::string whole = lower(text);
    return std::ranges::all_of(blank_separated(wanted), [&](std::string_view word) {
        return whole.find(lower(std::string(word))) != std::string::npos;
    });
}

int list_gallery(const GalleryOptions& options) {
    Json entries = Json::array();
    std::string text;
    std::size_t widest = 0;
    for (const GalleryEntry& entry : gallery()) widest = std::max(widest, entry.name.size());
    for (const GalleryEntry& entry : generator_gallery())
        widest = std::max(widest, file_name(entry).size());
    bool found = false;
    const auto add = [&](const GalleryEntry& entry, std::string_view shown,
                         const std::string& title, const std::string& source,
                         const std::string& kind) {
        if (!is_found(options.find, std::string(shown) + " " + title + " " + source + " " + kind))
            return;
        found = true;
        text += fmt::format("{:<{}}  {}{}\n", shown, widest, title,
                            source.empty() ? "" : " (" + source + ")");
        entries.add({{"name", entry.name},
                     {"title", title},
                     {"source", source},
                     {"path", entry.path},
                     {"class", kind}});
    };
    for (const GalleryEntry& entry : gallery()) {
        const Model system = read_lsystem(entry.text, std::string(entry.name));
        add(entry, entry.name, system.title, system.source, class_of(system).name());
    }
    for (const GalleryEntry& entry : generator_gallery()) {
        const auto generator = read_generator(entry.text, std::string(file_name(entry)));
        add(entry, file_name(entry), generator->title, generator->source,
            generator_kind(file_name(entry))->what);
    }
    print(options.json ? Json{{"figures", entries}}.text() : text);
    if (!found)
        note("nothing in the gallery has the words " + options.find +
             "; `algae gallery` lists everything");
    return found ? success : refuted;
}

}  // namespace

void add_show(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "show", "Class, alphabet, rules and properties of a system",
        {"algae show koch", "algae show my.lsys --json", "algae show plant-a --axes -n 4"}, show);
    verb.option("FILE", options.file, file_type, file_help).required = true;
    add_let_option(verb, options.let);
    verb.flag("--axes", options.axes,
              "the axes of the tree that the word of generation N describes, by order");
    verb.option("-n", options.generation, natural, "N", "with --axes: the generation");
    verb.json_flag(options.json);
    verb.latex_flag(options.latex, "print axiom and rules as LaTeX, which needs amsmath");
    verb.bounded_by(options.bounds);
}

void add_fmt(Verbs& verbs) {
    auto [verb, options] = verbs.add("fmt", "The canonical text of a system, comments kept",
                                     {"algae fmt koch", "algae fmt --in-place my.lsys"}, format);
    verb.option("FILE", options.file, file_type, file_help).required = true;
    add_let_option(verb, options.let);
    verb.flag("--in-place", options.in_place, "write the file instead of standard output");
    verb.flag("--check", options.check,
              "print nothing; exit 1 if the file is not in canonical form");
    verb.bounded_by(options.bounds);
}

void add_convert(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "convert", "The same in another format, to standard output",
        {"algae convert dragon --to ifs > dragon.ifs", "algae convert rule-110.ca --to lsys"},
        convert);
    std::string known;
    std::set<std::string> from, to, told;
    const std::vector<Conversion> all = conversions();
    for (const Conversion& one : all) {
        from.insert(one.from);
        to.insert(one.to);
        if (!told.insert(one.what).second) continue;  // the other way of the same
        const bool is_both = std::ranges::any_of(
            all, [&](const Conversion& two) { return two.from == one.to && two.to == one.from; });
        known += (known.empty() ? "" : "; ") + one.from + (is_both ? " and " : " to ") + one.to +
                 ", " + one.what;
    }
    verb.option("FILE", options.file, file_type, file_help).required = true;
    add_let_option(verb, options.let);
    verb.option("--to", options.to, fmt::format("{}", fmt::join(to, "|")),
                "the format; there are " + known)
        .required = true;
    verb.option("--from", options.from, fmt::format("{}", fmt::join(from, "|")),
                "the format of FILE, where its name does not say it");
    verb.bounded_by(options.bounds);
}

void add_gallery(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "gallery", "The names that FILE may be besides files",
        {"algae gallery", "algae gallery --find tree", "algae gallery --json"}, list_gallery);
    verb.option("--find", options.find, "WORDS",
                "only those with all these words in name, title, source or class; exit 1 if there "
                "are none");
    verb.json_flag(options.json);
}

}  // namespace algae::command
