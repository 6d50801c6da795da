#include "cli/relatives.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "base/error.hpp"
#include "cli/draw_mesh.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "exchange/relative_format.hpp"
#include "notation/relative_gallery.hpp"
#include "render/animation.hpp"

namespace algae::cli {

namespace {

std::vector<std::string> words(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> found;
    for (std::string word; in >> word;) found.push_back(word);
    return found;
}

/// Whether relatives of this kind may lie in space.
bool in_space(const std::string& kind) {
    return kind == "terrain" || kind == "brownian" || kind == "walk";
}

/// The kind of the relatives in files of this name, be it by way of another format.
const RelativeKind* kind_of(const std::string& name) {
    const RelativeFormat* format = relative_format(name);
    return relative_kind(format ? "." + format->kind : name);
}

RelativeFile read_source(const SourceText& source, const RelativeKind& kind) {
    if (const RelativeFormat* format = relative_format(source.name))
        return format->read(source.text, source.name);
    return read_relative_file(source.text, source.name, kind.keys);
}

void change(RelativeFile& file,
            const std::vector<std::pair<RelativeOption, std::string>>& changes) {
    for (const auto& [option, text] : changes)
        if (!text.empty()) file.set(option.key, words(text), option.option);
}

}  // namespace

bool is_relative(const std::string& file) {
    if (kind_of(file)) return true;
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) return false;
    const auto systems = gallery();
    return find_relative(file) &&
           std::none_of(systems.begin(), systems.end(),
                        [&](const GalleryEntry& entry) { return entry.name == file; });
}

std::unique_ptr<Relative> open_relative(
    const std::string& file, const Budget& budget,
    const std::vector<std::pair<RelativeOption, std::string>>& changes) {
    const SourceText source = open_text(file, budget);
    const RelativeKind* kind = kind_of(source.name);
    if (!kind) return read_relative(source.text, source.name);  // throws what is expected
    RelativeFile read = read_source(source, *kind);
    for (const auto& [option, text] : changes) {
        const bool known =
            std::any_of(kind->keys.begin(), kind->keys.end(),
                        [&](const RelativeKey& key) { return key.name == option.key; });
        if (!text.empty() && !known)
            throw Error(option.option + " is not for " + kind->what + ", and " + source.name +
                        " is one");
    }
    change(read, changes);
    return kind->make(read);
}

/// The text of FILE, which may be a name of the gallery that a system has as well.
static SourceText own_text(const RelativeOptions& options, const Budget& budget) {
    const RelativeKind* kind = relative_kind("." + options.verb);
    std::error_code ignored;
    const bool by_name = options.file != "-" && !std::filesystem::exists(options.file, ignored);
    const std::string own = options.file + "." + options.verb;
    const SourceText source = open_text(by_name && find_relative(own) ? own : options.file, budget);
    const RelativeKind* found = kind_of(source.name);
    const bool system = source.name.ends_with(".lsys") || (by_name && !found);
    if (system || (found && found != kind))
        throw Error(source.name + " is " + (system ? "an L-system" : found->what) + ", expected " +
                    kind->what);
    return source;
}

std::unique_ptr<Relative> chosen_relative(const RelativeOptions& options, const Budget& budget) {
    const RelativeKind& kind = *relative_kind("." + options.verb);
    RelativeFile file;
    file.name = options.verb;
    if (!options.file.empty()) {
        const SourceText source = own_text(options, budget);
        file = read_source(source, kind);
    }
    change(file, options.said);
    return kind.make(file);
}

Drawn draw_relative(const Relative& relative, const std::string& output, PictureFormat format,
                    const PictureOptions& picture, bool captions, const std::string& caption,
                    const Budget& budget) {
    const std::vector<RelativeFigure> figures = relative.figures(budget);
    std::vector<Plate> plates;
    for (const RelativeFigure& figure : figures)
        plates.push_back({figure.figure.get(), figure.name,
                          !caption.empty() ? caption
                          : captions       ? figure.caption
                                           : std::string()});
    ProgressBar bar("Drawing");
    const auto draw_to = [&](auto& target) {
        return plates.size() == 1
                   ? draw_picture(plates.front(), target, format, picture, budget, &bar)
                   : draw_panels(plates, target, format, picture, budget, &bar);
    };
    return output == "-" ? draw_to(std::cout) : draw_to(output);
}

/// All frames one after the other, each showing the same part of the plane.
static Drawn animate_relative(const Relative& relative, const RelativeOptions& options,
                              AnimationFormat format, PictureOptions picture,
                              const Budget& budget) {
    AnimationTiming timing;
    timing.frame = 1 / (options.rate.empty() ? 20 : positive("--rate", options.rate));
    timing.last = timing.frame;
    picture.common_scale = true;
    const std::vector<RelativeFigure> frames = relative.frames(budget);
    std::vector<Plate> plates;
    for (const RelativeFigure& frame : frames)
        plates.push_back({frame.figure.get(), frame.name,
                          !options.caption.empty() ? options.caption
                          : options.captions       ? frame.caption
                                                   : std::string()});
    ProgressBar bar("Drawing");
    return options.output == "-"
               ? draw_animation(plates, std::cout, format, picture, timing, budget, &bar)
               : draw_animation(plates, options.output, format, picture, timing, budget, &bar);
}

nlohmann::ordered_json relative_json(const Relative& relative, const std::optional<Drawn>& drawn,
                                     const std::string& output, const Budget& budget) {
    nlohmann::ordered_json out;
    if (!relative.title.empty()) out["title"] = relative.title;
    for (const RelativeFact& fact : relative.facts(budget)) out[fact.key] = fact.value;
    if (!drawn) return out;
    out["output"] = output;
    out["width"] = drawn->width;
    out["height"] = drawn->height;
    out["as_image"] = drawn->as_image;
    return out;
}

/// What a file of a figure in space has no place for.
static void check_no_page(const RelativeOptions& options, MeshFormat format) {
    for (const auto& [option, given] : {std::pair("--width", !options.width.empty()),
                                        {"--height", !options.height.empty()},
                                        {"--captions", options.captions},
                                        {"--caption", !options.caption.empty()}})
        if (given)
            throw Error(std::string(option) + ": " + mesh_format_name(format) +
                        " is no picture; it holds one figure in space");
}

int run_relative(const RelativeOptions& options) {
    const Budget budget = options.bounds.budget();
    std::optional<PictureFormat> format;
    std::optional<AnimationFormat> animation;
    std::optional<MeshFormat> mesh;
    if (!options.output.empty()) {
        if (options.output == "-" && options.format.empty())
            throw Error(
                "-o -: say which format with --format: svg, pdf, png, ps, eps, gif, webp, " +
                mesh_format_names());
        const std::string named =
            options.format.empty() ? options.output : "figure." + options.format;
        mesh = mesh_format(named);
        animation = animation_format(named);
        if (!mesh) format = animation ? PictureFormat::png : picture_of(named);
    } else if (!options.format.empty()) {
        throw Error("--format: expected -o, where the figure goes");
    }
    if (mesh) check_no_page(options, *mesh);
    if (!animation && !options.rate.empty())
        throw Error("--rate is for animations: expected -o with .gif or .webp");
    PictureOptions picture;
    if (!options.width.empty()) picture.width = positive("--width", options.width);
    if (!options.height.empty()) picture.height = positive("--height", options.height);
    const std::unique_ptr<Relative> relative = chosen_relative(options, budget);
    std::optional<Drawn> drawn;
    nlohmann::ordered_json written;
    if (mesh)
        written = write_mesh(scene_of(*relative, *mesh, budget), options.output, *mesh, {}, budget);
    else if (animation)
        drawn = animate_relative(*relative, options, *animation, picture, budget);
    else if (format)
        drawn = draw_relative(*relative, options.output, *format, picture, options.captions,
                              options.caption, budget);
    if (options.output == "-") return success;
    if (options.json) {
        nlohmann::ordered_json all = relative_json(*relative, drawn, options.output, budget);
        if (mesh) all.update(written);
        print(all.dump(2) + "\n");
        return success;
    }
    std::string page;
    if (!relative->title.empty()) page += relative->title + "\n";
    for (const RelativeFact& fact : relative->facts(budget)) {
        std::string key = fact.key;
        for (char& letter : key) letter = letter == '_' ? ' ' : letter;
        page += key + ": " + fact.text + "\n";
    }
    print(page);
    return success;
}

CLI::App& add_relative_verb(Verbs& verbs, const std::string& verb, const std::string& description,
                            const std::string& examples, const std::vector<RelativeOption>& options,
                            int (*run)(const RelativeOptions&), const std::string& text_help) {
    auto chosen = std::make_shared<RelativeOptions>();
    chosen->verb = verb;
    CLI::App& app = add_verb(verbs, verb, description, examples, chosen, run);
    app.add_option(
        "FILE", chosen->file,
        "a file ending in ." + verb +
            ", - for standard input, or a name from the gallery; options say what the file would")
        ->type_name(file_type);
    app.add_option(
           "-o,--output", chosen->output,
           "the picture: .svg, .pdf, .png, .ps or .eps, the animation: .gif or .webp" +
               std::string(in_space(verb)
                               ? ", the figure in space: .glb, .obj, .ply, .stl, .x3d or .wrl"
                               : "") +
               "; - for standard output")
        ->type_name("FILE");
    app.add_option("--format", chosen->format, "the format, where the name does not say it")
        ->type_name(in_space(verb) ? std::string(picture_formats) + '|' + mesh_formats
                                  : std::string(picture_formats));
    app.add_option("--width", chosen->width, "of the picture, in points (png: pixels)")
        ->type_name("W");
    app.add_option("--height", chosen->height, "of the picture, in points (png: pixels)")
        ->type_name("H");
    app.add_flag("--captions", chosen->captions, "what each figure shows underneath");
    app.add_option("--caption", chosen->caption, "a text underneath")->type_name("TEXT");
    app.add_option("--rate", chosen->rate, "frames a second of an animation (default 20)")
        ->type_name("R");
    app.add_flag("--json", chosen->json, "print one JSON object");
    if (!text_help.empty()) app.add_flag("--text", chosen->text, text_help);
    for (const RelativeOption& option : options) chosen->said.push_back({option, ""});
    for (auto& [option, text] : chosen->said) {
        if (option.type.empty())
            app.add_flag_callback(
                option.option, [&said = text] { said = "yes"; }, option.help);
        else
            app.add_option(option.option, text, option.help)->type_name(option.type);
    }
    chosen->bounds.add_to(app);
    return app;
}

}  // namespace algae::cli
