#include "notation/terrain_file.hpp"

#include <algorithm>
#include <map>

#include "nature/terrain.hpp"
#include "notation/characters.hpp"
#include "notation/relative_values.hpp"
#include "notation/suggestion.hpp"

namespace algae {

namespace {

std::vector<Terrain::View> views_of(const RelativeFile& file, const RelativeStatement& statement) {
    static const std::map<std::string, Terrain::View> known{{"map", Terrain::View::map},
                                                            {"contours", Terrain::View::contours},
                                                            {"solid", Terrain::View::solid},
                                                            {"coast", Terrain::View::coast},
                                                            {"grid", Terrain::View::grid}};
    std::vector<Terrain::View> found;
    for (const RelativeWord& word : statement.words) {
        const auto view = known.find(word.text);
        if (view == known.end()) {
            std::vector<std::string> names;
            for (const auto& [name, which] : known) names.push_back(name);
            file.fail(statement, word,
                      "expected view map, contours, solid, coast or grid, found " +
                          algae::quoted(word.text) + did_you_mean(word.text, names));
        }
        found.push_back(view->second);
    }
    return found;
}

std::unique_ptr<Relative> make(const RelativeFile& file) {
    auto land = std::make_unique<Terrain>();
    file.describe(*land);
    if (const auto levels = level_values(file, "levels", most_surface_levels)) {
        land->surface.levels = levels->second;
        if (levels->first != levels->second) land->levels = levels;
    }
    if (const auto rough = hurst_values(file, "roughness")) {
        file.check_words(*file.find("roughness"), 1, 1, "H");
        land->surface.hurst = rough->front();
    }
    land->surface.sigma = positive_value(file, "height").value_or(land->surface.sigma);
    land->exact = file.choice("method", {"exact", "midpoint"}).value_or("midpoint") == "exact";
    land->water = file.number("water", 0, 1).value_or(land->water);
    land->lines = file.natural("lines", 0, 1000).value_or(land->lines);
    if (const RelativeStatement* view = file.find("view")) land->views = views_of(file, *view);
    if (const RelativeStatement* camera = file.find("camera")) {
        file.check_words(*camera, 2, 2, "AZIMUTH ELEVATION");
        land->camera.azimuth = file.number(*camera, camera->words[0], -360, 360);
        land->camera.elevation = file.number(*camera, camera->words[1], -90, 90);
    }
    land->seed = seed_value(file);
    land->check();
    return land;
}

}  // namespace

RelativeKind terrain_kind() {
    return {"terrain",
            "a landscape",
            {{"levels", "N or N..M"},
             {"roughness", "H"},
             {"height", "NUMBER"},
             {"method", "exact|midpoint"},
             {"water", "SHARE"},
             {"lines", "N"},
             {"view", "map|contours|solid|coast|grid ..."},
             {"camera", "AZIMUTH ELEVATION"},
             {"seed", "S"}},
            make};
}

}  // namespace algae
