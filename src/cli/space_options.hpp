#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "render/picture.hpp"
#include "space/view.hpp"
#include "system/lsystem.hpp"

namespace algae::cli {

/// What `draw` takes for figures in space.
struct SpaceOptions {
    std::string camera, light, fog;

    void add_to(CLI::App& verb);
    /// What the command line says. Throws Error where it makes no sense.
    std::optional<Camera> chosen_camera() const;
    std::optional<Light> chosen_light() const;
    std::optional<double> chosen_fog() const;
    /// Throws Error if an option is given that only figures in space have.
    void check_unused(const std::string& name) const;
};

/// How the scenes of a system are looked at: as the options say, and where they do not, its file.
/// `background` is that of the picture.
ViewChoices view_choices(const SpaceOptions& options, const LSystem& system,
                         const std::optional<std::string>& background);

/// A label as --label says it, "TEXT@x,y" or "TEXT@x,y,z". Throws Error.
PointLabel point_label(const std::string& text);

}  // namespace algae::cli
