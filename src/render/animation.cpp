#include "render/animation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "base/error.hpp"
#include "render/film.hpp"
#include "render/gif.hpp"
#include "render/output.hpp"
#include "render/plan.hpp"
#include "render/webp.hpp"

namespace algae {
namespace {

constexpr double shortest_time = 0.02, longest_time = 600;  // seconds; programs slow down less

std::uint32_t hundredths(const char* what, double seconds) {
    if (!(seconds >= shortest_time && seconds <= longest_time)) {
        char text[120];
        std::snprintf(text, sizeof text, "the time of %s must be from %g to %g seconds, not %g",
                      what, shortest_time, longest_time, seconds);
        throw Error(text);
    }
    return static_cast<std::uint32_t>(std::lround(100 * seconds));
}

std::vector<std::uint32_t> times(const AnimationTiming& timing, std::size_t frames) {
    const std::uint32_t each = hundredths("a frame", timing.frame);
    const double hold = std::clamp(3 * timing.frame, 2.0, longest_time);
    const std::uint32_t last = hundredths("the last frame", timing.last.value_or(hold));
    if (timing.plays > 65'535)
        throw Error("an animation is shown at most 65535 times, or for ever, not " +
                    std::to_string(timing.plays) + " times");
    std::vector<std::uint32_t> found(frames, each);
    if (!found.empty()) found.back() = last;
    return found;
}

/// Draws all frames and packs them, before there is a file.
template <class Open>
Drawn draw(std::span<const Plate> plates, AnimationFormat format, const PictureOptions& options,
           const AnimationTiming& timing, const Budget& budget, Progress* progress, Open open) {
    const std::vector<std::uint32_t> hundredths = times(timing, plates.size());
    if (format == AnimationFormat::gif && options.background == "transparent")
        throw Error(
            "a gif has no half-transparent pixels: expected a colour as its background, or "
            "webp");
    const Plan decided = plan(plates, PictureFormat::png, Arrangement::frames, options, budget);
    Drawn drawn;
    const Film frames = film(plates, decided, budget, progress, drawn);
    open([&](Output& output) {
        if (format == AnimationFormat::gif)
            write_gif(frames, hundredths, timing.plays, output, budget);
        else
            write_webp(frames, hundredths, timing.plays, output, budget);
    });
    if (progress) progress->report(1);
    return drawn;
}

}  // namespace

std::optional<AnimationFormat> animation_format(std::string_view path) {
    const auto ends = [&](std::string_view ending) {
        return path.size() > ending.size() &&
               std::equal(ending.rbegin(), ending.rend(), path.rbegin(), [](char low, char other) {
                   return low == (other >= 'A' && other <= 'Z' ? other - 'A' + 'a' : other);
               });
    };
    if (ends(".gif")) return AnimationFormat::gif;
    if (ends(".webp")) return AnimationFormat::webp;
    return std::nullopt;
}

Drawn draw_animation(std::span<const Plate> plates, const std::string& path, AnimationFormat format,
                     const PictureOptions& options, const AnimationTiming& timing,
                     const Budget& budget, Progress* progress) {
    return draw(plates, format, options, timing, budget, progress, [&](auto write) {
        FileOutput file(path);
        write(file);
        file.commit();
    });
}

Drawn draw_animation(std::span<const Plate> plates, std::ostream& stream, AnimationFormat format,
                     const PictureOptions& options, const AnimationTiming& timing,
                     const Budget& budget, Progress* progress) {
    return draw(plates, format, options, timing, budget, progress, [&](auto write) {
        StreamOutput output(stream);
        write(output);
        output.finish();
    });
}

}  // namespace algae
