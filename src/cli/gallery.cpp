#include "notation/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "notation/read.hpp"
#include "notation/relative_gallery.hpp"
#include "notation/relative_reader.hpp"

namespace algae::cli {

namespace {

struct Options {
    bool json = false;
};

int list(const Options& options) {
    nlohmann::ordered_json entries = nlohmann::ordered_json::array();
    std::string text;
    std::size_t widest = 0;
    for (const GalleryEntry& entry : gallery()) widest = std::max(widest, entry.name.size());
    for (const GalleryEntry& entry : relative_gallery())
        widest = std::max(widest, file_name(entry).size());
    const auto add = [&](const GalleryEntry& entry, std::string_view shown,
                         const std::string& title, const std::string& source) {
        text += fmt::format("{:<{}}  {}{}\n", shown, widest, title,
                            source.empty() ? "" : " (" + source + ")");
        entries.push_back(
            {{"name", entry.name}, {"title", title}, {"source", source}, {"path", entry.path}});
    };
    for (const GalleryEntry& entry : gallery()) {
        const LSystem system = read_lsystem(entry.text, std::string(entry.name));
        add(entry, entry.name, system.title, system.source);
    }
    for (const GalleryEntry& entry : relative_gallery()) {
        const auto relative = read_relative(entry.text, std::string(file_name(entry)));
        add(entry, file_name(entry), relative->title, relative->source);
    }
    print(options.json ? nlohmann::ordered_json{{"figures", entries}}.dump(2) + "\n" : text);
    return success;
}

}  // namespace

void add_gallery(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "gallery", "The names that FILE may be besides files",
                              "  algae gallery\n  algae gallery --json", options, list);
    verb.add_flag("--json", options->json, "print one JSON object");
}

}  // namespace algae::cli
