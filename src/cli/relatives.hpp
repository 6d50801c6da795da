#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "nature/relative.hpp"
#include "notation/relative_reader.hpp"
#include "render/picture.hpp"

namespace algae::cli {

/// An option of a verb that says a statement of the relative's file instead of it.
struct RelativeOption {
    std::string option;  // "--points"
    std::string key;     // "points"
    std::string type;    // "N"; empty for a flag, which says yes
    std::string help;
};

/// Options that all verbs of relatives have, and those of each.
struct RelativeOptions {
    std::string verb;  // its name is the end of the file's name as well
    std::string file, output, format, width, height, caption, rate;
    bool captions = false, json = false, text = false;
    std::vector<std::pair<RelativeOption, std::string>>
        said;  // with what stands on the command line
    Bounds bounds;
};

/// A verb for one kind of relatives: FILE or options, -o, --json. With `run` something else happens
/// than `run_relative`; with `text_help` there is an option --text.
CLI::App& add_relative_verb(Verbs& verbs, const std::string& verb, const std::string& description,
                            const std::string& examples, const std::vector<RelativeOption>& options,
                            int (*run)(const RelativeOptions&),
                            const std::string& text_help = "");
/// Draws the figures to -o and prints what is known, as a page or as JSON.
int run_relative(const RelativeOptions& options);

/// The relative that FILE and the options say; the options alone if there is no FILE.
std::unique_ptr<Relative> chosen_relative(const RelativeOptions& options, const Budget& budget);
/// Whether the end of its name says that FILE holds a relative.
bool is_relative(const std::string& file);
/// The relative in FILE; statements that `changes` name are as these say.
std::unique_ptr<Relative> open_relative(
    const std::string& file, const Budget& budget,
    const std::vector<std::pair<RelativeOption, std::string>>& changes = {});

/// Draws all figures of a relative, several as panels or on pages of a pdf. `-` is standard output.
Drawn draw_relative(const Relative& relative, const std::string& output, PictureFormat format,
                    const PictureOptions& picture, bool captions, const std::string& caption,
                    const Budget& budget);
/// What is known of it and what was drawn, as one JSON object.
nlohmann::ordered_json relative_json(const Relative& relative, const std::optional<Drawn>& drawn,
                                     const std::string& output, const Budget& budget);

}  // namespace algae::cli
