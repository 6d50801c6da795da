#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/budget.hpp"
#include "render/picture.hpp"

namespace algae {

enum class AnimationFormat { gif, webp };

/// The animation that the end of a file's name stands for, in any case; nothing if none.
///
/// Example: animation_format("plant.GIF") == AnimationFormat::gif
std::optional<AnimationFormat> animation_format(std::string_view path);

/// How an animation goes by.
struct AnimationTiming {
    double frame = 0.8;  // seconds, from 0.02 to 600, in hundredths
    /// The last frame. Nothing: three times as long as the others, at least 2 seconds.
    std::optional<double> last;
    std::uint32_t plays = 0;  // how often, below 65,536; 0: for ever
};

/// An animation of figures, a frame each, all of one size in pixels; sizes are as in png. A frame
/// shows its figure as large as it can; with the option common_scale all show the same part of the
/// plane, in which figures grow and stay where they are. Files appear complete or not at all and are
/// the same bytes whenever they are made. A gif has the pixels of a png exactly as long as all
/// frames together have at most 256 colours, otherwise the 256 most like them; a webp always.
///
/// Throws Error on options out of range, a transparent background in gif, figures that draw nothing,
/// or a file that cannot be written; BoundReached if the frames take more memory than the budget has,
/// or past its deadline; Interrupted. O(strokes + frames * pixels) time.
Drawn draw_animation(std::span<const Plate> plates, const std::string& path, AnimationFormat format,
                     const PictureOptions& options, const AnimationTiming& timing,
                     const Budget& budget, Progress* progress = nullptr);
/// The same to a stream.
Drawn draw_animation(std::span<const Plate> plates, std::ostream& stream, AnimationFormat format,
                     const PictureOptions& options, const AnimationTiming& timing,
                     const Budget& budget, Progress* progress = nullptr);

}  // namespace algae
