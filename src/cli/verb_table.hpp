#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace algae::cli {

/// An option or an argument of a verb.
struct VerbOption {
    std::vector<std::string> names;  // "-o", "--output"; of an argument its name, "FILE"
    std::string type;                // "N", "FILE|NAME", "map|solid"; empty for a flag
    std::string help;
    bool required = false, repeated = false;
    bool bounds = false;  // one of those that bound the work

    /// The longest of the names.
    const std::string& name() const { return names.back(); }
};

/// All names that FILE may be, those of other generators with their ends, `fern.ifs`.
std::vector<std::string> gallery_names();

/// What may stand for a value: the words of a set, and paths.
struct Values {
    std::vector<std::string> words;
    bool files = false, folders = false;
};

/// A verb as its help shows it.
struct VerbEntry {
    std::string name, help;
    std::vector<VerbOption> options, arguments;  // without --help
    std::vector<std::string> examples;           // a line each

    /// "algae draw [OPTIONS] FILE"
    std::string usage() const;
    /// Whether it runs one kind of generator, and its names from the gallery are those of the kind.
    bool is_generator() const;
    /// What the type of one of its options allows; nothing where any text may stand.
    Values values(const VerbOption& option) const;
};

/// The verbs of the command with all their options, but for hidden ones.
std::vector<VerbEntry> verb_table(const CLI::App& app);

}  // namespace algae::cli
