#include "cli/draw_motion.hpp"

#include "base/error.hpp"
#include "cli/numbers.hpp"

namespace algae::cli {

void MotionOptions::add_to(CLI::App& verb) {
    verb.add_option("--frame-time", frame_time, "of an animation: seconds a frame (default 0.8)")
        ->type_name("SECONDS");
    verb.add_option("--loop", loop,
                    "of an animation: how often it is shown; 0, the default, for ever")
        ->type_name("N");
}

AnimationTiming MotionOptions::timing(double usual) const {
    AnimationTiming timing;
    timing.frame = frame_time.empty() ? usual : positive("--frame-time", frame_time);
    if (!loop.empty()) {
        const std::uint64_t plays = natural("--loop", loop);
        timing.plays = static_cast<std::uint32_t>(std::min<std::uint64_t>(plays, UINT32_MAX));
    }
    return timing;
}

void MotionOptions::check_unused() const {
    const char* const used = !frame_time.empty() ? "--frame-time"
                             : !loop.empty()     ? "--loop"
                                                 : nullptr;
    if (used)
        throw Error(std::string(used) +
                    ": only animations have it: expected a file ending in .gif or .webp");
}

}  // namespace algae::cli
