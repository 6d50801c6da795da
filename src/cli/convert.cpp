#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "exchange/conversion.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file, from, to;
    Bounds bounds;
};

/// What the end of a file's name says; systems from the gallery have names without one.
std::string format_of(const std::string& name) {
    const std::size_t dot = name.find_last_of('.'), slash = name.find_last_of('/');
    if (dot == std::string::npos || (slash != std::string::npos && slash > dot)) return "lsys";
    return name.substr(dot + 1);
}

int convert(const Options& options) {
    const Budget budget = options.bounds.budget();
    const SourceText source = open_text(options.file, budget);
    const std::string from = options.from.empty() ? format_of(source.name) : options.from;
    print(converted(source.text, source.name, from, options.to, budget));
    return success;
}

}  // namespace

void add_convert(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "convert", "The same in another format, to standard output",
                              "  algae convert dragon --to ifs > dragon.ifs\n"
                              "  algae convert rule-110.ca --to lsys",
                              options, convert);
    std::string known;
    std::set<std::string> from, to, told;
    const std::vector<Conversion> all = conversions();
    for (const Conversion& one : all) {
        from.insert(one.from);
        to.insert(one.to);
        if (!told.insert(one.what).second) continue;  // the other way of the same
        const bool is_both = std::any_of(all.begin(), all.end(), [&](const Conversion& two) {
            return two.from == one.to && two.to == one.from;
        });
        known += (known.empty() ? "" : "; ") + one.from + (is_both ? " and " : " to ") + one.to +
                 ", " + one.what;
    }
    verb.add_option("FILE", options->file, file_help)->type_name(file_type)->required();
    verb.add_option("--to", options->to, "the format; there are " + known)
        ->type_name(fmt::format("{}", fmt::join(to, "|")))
        ->required();
    verb.add_option("--from", options->from, "the format of FILE, where its name does not say it")
        ->type_name(fmt::format("{}", fmt::join(from, "|")));
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
