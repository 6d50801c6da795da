#include "cli/verb_table.hpp"

#include <algorithm>
#include <sstream>

#include "cli/command.hpp"
#include "notation/gallery.hpp"
#include "notation/relative_gallery.hpp"
#include "notation/relative_reader.hpp"
#include "system/colour.hpp"

namespace algae::cli {

namespace {

VerbOption option_of(const CLI::Option& option) {
    VerbOption found;
    if (option.get_positional()) found.names = {option.get_name(true)};
    for (const std::string& name : option.get_snames()) found.names.push_back('-' + name);
    for (const std::string& name : option.get_lnames()) found.names.push_back("--" + name);
    if (option.get_type_size() != 0) found.type = option.get_type_name();
    found.help = option.get_description();
    found.required = option.get_required();
    found.repeated = option.get_positional() && option.get_items_expected_max() > 1;
    found.bounds = option.get_group() == bounds_group;
    return found;
}

/// The lines of "Examples:\n  algae ...\n  algae ...".
std::vector<std::string> examples_of(const CLI::App& verb) {
    std::istringstream lines(verb.get_footer());
    std::vector<std::string> found;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("  ")) found.push_back(line.substr(2));
    return found;
}

/// The names of one kind of generator.
std::vector<std::string> names_of_kind(const std::string& kind) {
    std::vector<std::string> names;
    for (const GalleryEntry& entry : relative_gallery())
        if (file_name(entry).ends_with('.' + kind)) names.emplace_back(entry.name);
    return names;
}

}  // namespace

std::vector<std::string> gallery_names() {
    std::vector<std::string> names;
    for (const GalleryEntry& entry : gallery()) names.emplace_back(entry.name);
    for (const GalleryEntry& entry : relative_gallery()) names.emplace_back(file_name(entry));
    return names;
}

bool VerbEntry::is_generator() const { return relative_kind("file." + name) != nullptr; }

std::string VerbEntry::usage() const {
    std::string text = "algae " + name + " [OPTIONS]";
    for (const VerbOption& option : options)
        if (option.required) text += ' ' + option.name() + ' ' + option.type;
    for (const VerbOption& argument : arguments) {
        const std::string shown = argument.name() + (argument.repeated ? "..." : "");
        text += argument.required ? ' ' + shown : " [" + shown + ']';
    }
    return text;
}

Values VerbEntry::values(const VerbOption& option) const {
    Values found;
    const std::string type = option.type.substr(0, option.type.find(",..."));
    std::istringstream parts(type);
    for (std::string part; std::getline(parts, part, '|');) {
        if (part == "FILE")
            found.files = true;
        else if (part == "DIR")
            found.folders = true;
        else if (part == "NAME")
            found.words = is_generator() ? names_of_kind(name) : gallery_names();
        else if (part == "COLOUR")
            for (const std::string_view colour : colour_names()) found.words.emplace_back(colour);
        else if (type.find('|') != std::string::npos)
            found.words.push_back(part);
    }
    return found;
}

std::vector<VerbEntry> verb_table(const CLI::App& app) {
    std::vector<VerbEntry> table;
    for (const CLI::App* verb : app.get_subcommands({})) {
        if (verb->get_group().empty()) continue;
        VerbEntry entry{verb->get_name(), verb->get_description(), {}, {}, examples_of(*verb)};
        for (const CLI::Option* option : verb->get_options())
            if (option != verb->get_help_ptr())
                (option->get_positional() ? entry.arguments : entry.options)
                    .push_back(option_of(*option));
        table.push_back(std::move(entry));
    }
    return table;
}

}  // namespace algae::cli
