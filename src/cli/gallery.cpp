#include "notation/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "notation/read.hpp"

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
    for (const GalleryEntry& entry : gallery()) {
        const LSystem system = read_lsystem(entry.text, std::string(entry.name));
        text += fmt::format("{:<{}}  {}{}\n", entry.name, widest, system.title,
                            system.source.empty() ? "" : " (" + system.source + ")");
        entries.push_back({{"name", entry.name}, {"title", system.title}, {"source", system.source}, {"path", entry.path}});
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
