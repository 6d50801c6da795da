#include "cli/draw_progress.hpp"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/space_options.hpp"
#include "rewrite/module_text.hpp"
#include "space/partial_view.hpp"
#include "space/space_figure.hpp"
#include "turtle/derived_modules.hpp"
#include "turtle/partial_figure.hpp"

namespace algae::cli {

namespace {

constexpr std::uint64_t usual_frames = 240, most_frames = 10'000;
constexpr double usual_time = 0.05;                // seconds a frame
constexpr std::uint64_t most_strokes = 5'000'000;  // of all pages together

std::uint64_t shown_generation(const LSystem& system, const std::string& written) {
    const auto wished = written.empty() ? shown_generations(system) : range("-n", written);
    if (!written.empty() && wished.first != wished.second)
        throw Error("-n " + written + ": --progressive shows one generation");
    return wished.second;
}

std::size_t frame_bound(const MotionOptions& motion) {
    if (motion.max_frames.empty()) return usual_frames;
    const std::uint64_t bound = natural("--max-frames", motion.max_frames);
    if (bound < 2 || bound > most_frames)
        throw Error("--max-frames must be from 2 to " + std::to_string(most_frames) + ", not " +
                    motion.max_frames);
    return bound;
}

/// The symbols of a word one by one, as text.
std::vector<std::string> symbol_texts(const LSystem& system, const DerivedModules& derived) {
    const ModuleText text(system.alphabet, derived.kinds);
    std::vector<std::string> found;
    const double* values = derived.word.values.data();
    for (const ModuleKind kind : derived.word.kinds) {
        found.push_back(text.text(kind, values));
        values += derived.kinds.arity(kind);
    }
    return found;
}

/// A number with as many places as the largest, so that captions do not jump.
std::string padded(std::size_t number, std::size_t largest) {
    std::string digits = std::to_string(number);
    std::string blanks;
    for (std::size_t i = digits.size(); i < std::to_string(largest).size(); ++i) blanks += "\u2007";
    return blanks + digits;
}

/// A system in the colours of the picture: scenes have their own.
LSystem painted(LSystem system, const PictureOptions& picture) {
    if (!picture.colours.empty()) system.settings.colours = picture.colours;
    return system;
}

}  // namespace

int draw_progress(const LSystem& system, const ProgressRequest& request, const Budget& budget) {
    const std::string named = request.format.empty() ? request.output : "figure." + request.format;
    const auto animation = animation_format(named);
    const PictureFormat format = animation ? PictureFormat::png : picture_format(named);
    if (!animation && format != PictureFormat::pdf && format != PictureFormat::ps)
        throw Error(
            std::string("--progressive: expected gif or webp for an animation, or pdf or ps "
                        "for pages, found ") +
            format_name(format));
    request.motion.check(animation.has_value());
    const AnimationTiming timing = request.motion.timing(usual_time);
    const std::size_t bound = frame_bound(request.motion);
    const std::uint64_t n = shown_generation(system, request.generation);
    const DerivedModules derived = word_to_walk(system, n, request.choices, budget);
    const std::size_t length = derived.word.kinds.size();
    if (length == 0)
        throw Error("generation " + std::to_string(n) + " of " + system.name +
                    " is the empty word: a turtle has nothing to do");
    const std::vector<std::size_t> symbols = frames_of_progress(length, bound);
    const std::size_t stride = symbols[1];
    const bool in_space = leaves_plane(system);
    if (!in_space) request.choices.space.check_unused(system.name);
    const auto figures =
        in_space
            ? partial_views(painted(system, request.picture), derived, n, symbols,
                            view_choices(request.choices.space, system, request.choices.background),
                            budget)
            : partial_figures(system, derived, n, symbols, budget);

    const std::vector<std::string> texts =
        request.captions ? symbol_texts(system, derived) : std::vector<std::string>();
    const std::string title = system.title.empty() ? system.name : system.title;
    std::vector<Plate> plates;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        Plate& plate = plates.emplace_back();
        plate.figure = figures[i].get();
        plate.name = "generation " + std::to_string(n) + " of " + system.name;
        plate.caption = request.caption;
        if (!request.captions || !plate.caption.empty()) continue;
        plate.caption = title + ", n = " + std::to_string(n) + ": " + padded(symbols[i], length) +
                        " of " + std::to_string(length);
        if (stride == 1 && symbols[i] > 0) plate.caption += "  " + texts[symbols[i] - 1];
    }
    const std::uint64_t each = figures.front()->strokes().value_or(most_strokes);
    if (!animation && each > 2 * most_strokes / figures.size())
        throw Error("--progressive: the " + std::to_string(figures.size()) +
                    " pages would hold more than " + std::to_string(most_strokes) +
                    " strokes; use gif or webp, a smaller -n or a smaller --max-frames");
    if (stride > 1)
        std::cerr << "algae: note: " << length << " symbols in " << figures.size() << " frames, "
                  << stride << " symbols a frame; --max-frames allows more frames\n";

    ProgressBar bar("Drawing");
    const auto draw_to = [&](auto& target) {
        if (animation)
            return draw_animation(plates, target, *animation, request.picture, timing, budget,
                                  &bar);
        return draw_pages(plates, target, format, request.picture, budget, &bar);
    };
    const Drawn drawn = request.output == "-" ? draw_to(std::cout) : draw_to(request.output);
    if (request.json) {
        nlohmann::ordered_json out;
        out["generation"] = n;
        out["symbols"] = length;
        out["frames"] = figures.size();
        out["symbols_a_frame"] = stride;
        out["output"] = request.output;
        out["width"] = drawn.width;
        out["height"] = drawn.height;
        print(out.dump(2) + "\n");
    }
    return success;
}

}  // namespace algae::cli
