#pragma once

#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "nature/nature.hpp"
#include "render/render.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"

namespace algae::command {

/// What --format takes, for types of options.
inline constexpr const char* picture_formats = "svg|pdf|png|ps|eps|gif|webp|mp4|webm";
inline constexpr const char* text_formats = "tex|typ|csv|geojson|dxf|html|abc|mid";
inline constexpr const char* mesh_formats = "glb|obj|ply|stl|x3d|wrl|vrml1|pov";

/// The format of a picture by the extension of this name. Throws Error, which lists the other formats.
PictureFormat picture_of(const std::string& named);

/// A name whose extension says the format: that of the output unless --format is given. Throws Error if
/// neither says it.
std::string named_format(const std::string& output, const std::string& format);

/// Throws Error if an option is given that makes no sense for a file of a figure in space.
void refuse_on_mesh(const std::vector<std::pair<const char*, bool>>& given, MeshFormat format);

/// Standard output if the path is `-`, otherwise the file.
Target target_of(const std::string& output);

/// Throws Error, the option and then `why`, at the first option that is given.
void refuse_given(const std::vector<std::pair<const char*, bool>>& given, const std::string& why);

/// Where a camera stands, or where it goes on the way around a figure: `--camera 0..360,15`.
struct MovingCamera {
    Camera camera;               // where it stands, or begins
    std::optional<double> last;  // the azimuth to which it goes

    /// The cameras of the frames, about 5 degrees apart. Where it comes round to its beginning, that is not shown twice.
    std::vector<Camera> stations() const;
};

/// The options of `draw` for figures in space.
struct SpaceOptions {
    std::optional<MovingCamera> camera;
    std::optional<Light> light;
    std::optional<double> fog;

    void add_to(Verb& verb);
    /// Throws Error if one of these options is given.
    void check_unused(const std::string& name) const;
    /// Whether the camera goes around the figure.
    bool turns() const { return camera && camera->last; }
};

/// Options that stand for settings of the file: `--angle` and `--start`.
struct SettingOptions {
    std::string angle, start;

    void add_to(Verb& verb);
    /// The system with these settings instead of its own. Throws Error, naming the option, if one cannot be read.
    Model applied_to(Model system) const;
};

/// How light the page is that a picture is for.
enum class Theme { light, dark, print };

/// A reader of the text of --theme.
Theme theme(const std::string& option, const std::string& text);

/// What a picture is drawn on and in for a theme, where the command line does not say. On a dark page black becomes
/// light, and colours that could not be read become lighter; in print all are greys.
struct ThemeColours {
    std::optional<std::string> background;
    std::vector<std::string> colours;
};

/// `own` are the colours of the file; `background` that of the command line.
ThemeColours theme_colours(Theme theme, const std::vector<std::string>& own,
                           const std::optional<std::string>& background);

/// Whether panels of a system have one scale where the command line does not say: as its file says, otherwise
/// if they show generations of which none is many times as large as another.
bool has_common_scale(const Drawing& drawing, std::span<const Plate> plates);

/// Whether the picture of a system is one that draw_other draws, and not figures of its turtle.
bool is_other_picture(const Drawing& drawing);

/// Draws what the setting `picture` names: the table of a turtle's commands, a derivation tree, a plot of lengths. Throws Error if several
/// generations are asked for where one can be shown, or the system has none of this.
void draw_other(const Model& system, std::pair<std::uint64_t, std::uint64_t> generations,
                const std::string& path, PictureFormat format, const PictureOptions& picture,
                const Budget& budget);

/// How the scenes of a system are seen: as the options say, otherwise as its file says.
/// `background` is that of the picture.
ViewChoices view_choices(const SpaceOptions& options, const Model& system,
                         const std::optional<std::string>& background);

/// A reader of the text of --label, "TEXT@x,y" or "TEXT@x,y,z".
PointLabel point_label(const std::string& option, const std::string& text);

/// The labels that a file wants.
std::vector<PointLabel> labels_of(const Drawing& drawing);

/// One word of a system, ready to be drawn.
struct FigurePlate {
    std::uint64_t generation = 0;
    std::optional<std::uint64_t> seed;
    std::unique_ptr<Figure> figure;
    std::string name, caption;
    const Model* system = nullptr;  // that it shows, where the caller keeps it
    std::shared_ptr<const DerivedModules>
        derived;  // the word, where it has parameters and is short
    std::shared_ptr<const ContinuousDevelopment>
        development;  // of a figure between two generations
};

/// The choices of a picture of a system with choices; what is not set comes from the file.
struct PlateChoices {
    std::optional<std::pair<std::uint64_t, std::uint64_t>> seeds;  // a word for each
    std::vector<std::size_t> tables;                               // one for each step
    std::string environment;                                       // the program of --environment
    SpaceOptions space;                                            // for figures in space
    std::optional<std::string> background;                         // of the picture
    std::vector<std::string> colours;                              // instead of those of the file
    std::uint64_t between = 1;  // figures from a generation to the next, that one counted
};

/// The words of a system that a picture shows: its generations, each for every seed.
class FigurePlates {
public:
    /// Throws Error if the system leaves a choice and neither `choices` nor the file says which.
    FigurePlates(const Model& system, std::pair<std::uint64_t, std::uint64_t> generations,
                 const PlateChoices& choices, const Budget& budget);

    /// The same caption under every generation.
    void caption(const std::string& text);
    /// Title, generation, angle, and the seed if there are several: "Koch curve, n = 3, 60°".
    void caption_with_facts();

    std::vector<Plate> plates() const;
    std::vector<FigurePlate> figures;

private:
    std::string title_, angle_;
    bool many_seeds_ = false;
};

/// "generation 8 of plant" with the reason why its parameters are doubles.
using Rounded = std::pair<std::string, std::string>;

/// Those of these figures whose parameters are doubles.
std::vector<Rounded> rounded_figures(const std::vector<FigurePlate>& figures);

/// What to note of figures whose parameters are doubles; "" of none.
std::string rounding_text(const std::vector<Rounded>& figures);
void note_rounding(const std::vector<Rounded>& figures);
void note_rounding(const Model& system, std::uint64_t n, const std::string& reason);

/// Figures with the letters of their words where this format names them, and their exact points where it has these and they are known.
/// What would take more letters or memory than the budget has is left out. Everything must outlive the result.
class FigureSources {
public:
    FigureSources(const std::vector<FigurePlate>& plates, const PlateChoices& choices,
                  FigureFormat format, bool plotter, const Budget& budget);
    std::vector<FigureSource> all;

private:
    struct Letters;
    std::vector<std::shared_ptr<Letters>> letters_;
};

/// How figures are written as text.
struct TextChoices {
    std::string output;
    PictureOptions picture;
    bool plotter = false, panels = false, json = false;
};

/// Writes figures as text, notes what a plotter needs to know, and with `json` prints the facts and what was written. Gives the
/// exit status.
int write_as_text(const std::vector<FigureSource>& all, FigureFormat format,
                  const TextChoices& choices, Json facts, const Budget& budget);

/// The generations that the figure shows according to its file. Throws Error if the file does not say it.
std::pair<std::uint64_t, std::uint64_t> shown_generations(const Model& system);

/// Writes a scene, to standard output for `-`, and describes it as JSON.
Json write_mesh(const Scene& scene, const std::string& output, MeshFormat format,
                const MeshChoices& choices, const Budget& budget);

/// The scene of a generator. Throws Error if the generator lies in the plane.
Scene scene_of(const Generator& generator, MeshFormat format, const Budget& budget);

/// One plate as a picture of its own, several side by side.
Drawn draw_plates(std::span<const Plate> plates, const std::string& output, PictureFormat format,
                  const PictureOptions& picture, const Budget& budget,
                  Progress* progress = nullptr);

/// Figures of a generator with a caption underneath: the text, or if it is empty the caption of each figure.
std::vector<Plate> generator_plates(const std::vector<GeneratorFigure>& figures, bool captions,
                                    const std::string& caption);

/// Draws all figures of a generator, several as panels or on pages of a pdf. `-` is standard output.
Drawn draw_generator(const Generator& generator, const std::string& output, PictureFormat format,
                     const PictureOptions& picture, bool captions, const std::string& caption,
                     const Budget& budget);

/// The facts about a generator and the picture that was drawn, as one JSON object.
Json generator_json(const Generator& generator, const std::optional<Drawn>& drawn,
                    const std::string& output, const Budget& budget);

}  // namespace algae::command
