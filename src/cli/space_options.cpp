#include "cli/space_options.hpp"

#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "cli/numbers.hpp"
#include "system/colour.hpp"

namespace algae::cli {

namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& expected, const std::string& found) {
    throw Error(option + ": expected " + expected + ", found \"" + found + '"');
}

/// A number of any sign, or nothing.
std::optional<double> number(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

/// The parts of a text between commas, empty ones too.
std::vector<std::string> parts_of(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ',') parts.emplace_back();
        else parts.back() += c;
    }
    return parts;
}

}  // namespace

void SpaceOptions::add_to(CLI::App& verb) {
    verb.add_option("--camera", camera, "of figures in space: where the camera stands in degrees, from +x towards +y and above the horizon (default -60,15), and whether it sees in perspective")
        ->type_name("AZIMUTH,ELEVATION[,perspective[:DEGREES]]");
    verb.add_option("--light", light, "of figures in space: where the light comes from (default: over the camera's left shoulder)")->type_name("AZIMUTH,ELEVATION");
    verb.add_option("--fog", fog, "of figures in space: the share of the background in the colour of what is farthest, 0 to 1 (default 0)")->type_name("F");
}

std::optional<Camera> SpaceOptions::chosen_camera() const {
    if (camera.empty()) return std::nullopt;
    const std::string expected = "AZIMUTH,ELEVATION or AZIMUTH,ELEVATION,perspective[:DEGREES]";
    const std::vector<std::string> parts = parts_of(camera);
    const auto azimuth = number(parts[0]);
    const auto elevation = parts.size() > 1 ? number(parts[1]) : std::nullopt;
    if (!azimuth || !elevation || parts.size() > 3) refuse("--camera", expected, camera);
    Camera found{*azimuth, *elevation};
    if (parts.size() == 3) {
        const std::string word = "perspective";
        const std::string& said = parts[2];
        const bool opens = said.starts_with(word + ':');
        const auto opening = opens ? number(said.substr(word.size() + 1)) : std::nullopt;
        if ((said != word && !opens) || (opens && !opening)) refuse("--camera", expected, camera);
        found.perspective = true;
        if (opening) found.opening = *opening;
    }
    try {
        check_camera(found);
    } catch (const Error& error) {
        throw Error(std::string("--camera: ") + error.what());
    }
    return found;
}

std::optional<Light> SpaceOptions::chosen_light() const {
    if (light.empty()) return std::nullopt;
    const std::vector<std::string> parts = parts_of(light);
    const auto azimuth = number(parts[0]);
    const auto elevation = parts.size() == 2 ? number(parts[1]) : std::nullopt;
    if (!azimuth || !elevation) refuse("--light", "AZIMUTH,ELEVATION", light);
    if (std::fabs(*elevation) > 90) refuse("--light", "an elevation from -90 to 90 degrees", parts[1]);
    return Light{*azimuth, *elevation};
}

std::optional<double> SpaceOptions::chosen_fog() const {
    if (fog.empty()) return std::nullopt;
    const auto share = number(fog);
    if (!share || *share < 0 || *share > 1) refuse("--fog", "a number from 0 to 1", fog);
    return share;
}

void SpaceOptions::check_unused(const std::string& name) const {
    for (const auto& [option, value] : {std::pair("--camera", &camera), {"--light", &light}, {"--fog", &fog}})
        if (!value->empty()) throw Error(std::string(option) + " is for figures in space, and those of " + name + " stay in the plane");
}

ViewChoices view_choices(const SpaceOptions& options, const LSystem& system, const std::optional<std::string>& background) {
    ViewChoices choices = view_choices(system.settings);
    if (const auto camera = options.chosen_camera()) choices.camera = *camera;
    if (const auto light = options.chosen_light()) choices.light = *light;
    if (const auto fog = options.chosen_fog()) choices.fog = *fog;
    if (background && *background != "transparent") choices.background = colour_named(*background);
    return choices;
}

PointLabel point_label(const std::string& text) {
    const std::string expected = "TEXT@x,y or TEXT@x,y,z";
    const auto at = text.rfind('@');
    if (at == std::string::npos || at == 0) refuse("--label", expected, text);
    const std::vector<std::string> parts = parts_of(text.substr(at + 1));
    if (parts.size() != 2 && parts.size() != 3) refuse("--label", expected, text);
    PointLabel label{text.substr(0, at), {}};
    double* const into[] = {&label.place.x, &label.place.y, &label.place.z};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto value = number(parts[i]);
        if (!value) refuse("--label", expected, text);
        *into[i] = *value;
    }
    return label;
}

}  // namespace algae::cli
