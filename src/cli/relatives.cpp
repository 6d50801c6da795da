#include "cli/relatives.hpp"

#include <algorithm>
#include <iostream>
#include <sstream>

#include "base/error.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "render/animation.hpp"

namespace algae::cli {

namespace {

std::vector<std::string> words(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> found;
    for (std::string word; in >> word;) found.push_back(word);
    return found;
}

void change(RelativeFile& file,
            const std::vector<std::pair<RelativeOption, std::string>>& changes) {
    for (const auto& [option, text] : changes)
        if (!text.empty()) file.set(option.key, words(text), option.option);
}

}  // namespace

bool is_relative(const std::string& file) { return relative_kind(file) != nullptr; }

std::unique_ptr<Relative> open_relative(
    const std::string& file, const Budget& budget,
    const std::vector<std::pair<RelativeOption, std::string>>& changes) {
    const SourceText source = open_text(file, budget);
    const RelativeKind* kind = relative_kind(source.name);
    if (!kind) return read_relative(source.text, source.name);  // throws what is expected
    RelativeFile read = read_relative_file(source.text, source.name, kind->keys);
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

std::unique_ptr<Relative> chosen_relative(const RelativeOptions& options, const Budget& budget) {
    const RelativeKind* kind = relative_kind("." + options.verb);
    if (!options.file.empty() && relative_kind(options.file) == kind)
        return open_relative(options.file, budget, options.said);
    RelativeFile file;
    if (!options.file.empty()) {
        const SourceText source = open_text(options.file, budget);
        file = read_relative_file(source.text, source.name, kind->keys);
    } else {
        file.name = options.verb;
    }
    change(file, options.said);
    return kind->make(file);
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

int run_relative(const RelativeOptions& options) {
    const Budget budget = options.bounds.budget();
    std::optional<PictureFormat> format;
    std::optional<AnimationFormat> animation;
    if (!options.output.empty()) {
        if (options.output == "-" && options.format.empty())
            throw Error("-o -: say which format with --format: svg, pdf, png, ps or eps");
        const std::string named =
            options.format.empty() ? options.output : "figure." + options.format;
        animation = animation_format(named);
        format = animation ? PictureFormat::png : picture_format(named);
    }
    if (!animation && !options.rate.empty())
        throw Error("--rate is for animations: expected -o with .gif or .webp");
    PictureOptions picture;
    if (!options.width.empty()) picture.width = positive("--width", options.width);
    if (!options.height.empty()) picture.height = positive("--height", options.height);
    const std::unique_ptr<Relative> relative = chosen_relative(options, budget);
    std::optional<Drawn> drawn;
    if (animation)
        drawn = animate_relative(*relative, options, *animation, picture, budget);
    else if (format)
        drawn = draw_relative(*relative, options.output, *format, picture, options.captions,
                              options.caption, budget);
    if (options.output == "-") return success;
    if (options.json) {
        print(relative_json(*relative, drawn, options.output, budget).dump(2) + "\n");
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
        "a file ending in ." + verb + ", or - for standard input; options say what the file would");
    app.add_option(
           "-o,--output", chosen->output,
           "the picture: .svg, .pdf, .png, .ps or .eps, the animation: .gif or .webp; - for "
           "standard output")
        ->type_name("FILE");
    app.add_option("--format", chosen->format, "the format, where the name does not say it")
        ->type_name("FORMAT");
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
