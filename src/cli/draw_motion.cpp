#include "cli/draw_motion.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "cli/environment_option.hpp"
#include "cli/numbers.hpp"
#include "environment/open_modules.hpp"

namespace algae::cli {

void MotionOptions::add_to(CLI::App& verb) {
    verb.add_option("--frame-time", frame_time,
                    "of an animation: seconds a frame (default 0.8; with --progressive 0.05)")
        ->type_name("SECONDS");
    verb.add_option("--loop", loop,
                    "of an animation: how often it is shown; 0, the default, for ever")
        ->type_name("N");
    verb.add_flag(
        "--progressive", progressive,
        "one generation symbol by symbol, with the turtle where it is: gif, webp, or pages "
        "of pdf or ps");
    verb.add_option("--max-frames", max_frames,
                    "of --progressive: several symbols a frame where there would be more (default "
                    "240)")
        ->type_name("N");
    verb.add_flag(
        "--explain", explain,
        "numbered steps, the turtle at every corner and a table of what each symbol does; "
        "without -o the table alone");
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

void MotionOptions::check(bool moves) const {
    if (explain && progressive) throw Error("--explain and --progressive: expected one of them");
    if (!max_frames.empty() && !progressive) throw Error("--max-frames: only --progressive has it");
    const char* const used = !frame_time.empty() ? "--frame-time"
                             : !loop.empty()     ? "--loop"
                                                 : nullptr;
    if (used && !moves)
        throw Error(std::string(used) +
                    ": only animations have it: expected a file ending in .gif or .webp");
}

DerivedModules word_to_walk(const LSystem& system, std::uint64_t n, const PlateChoices& choices,
                            const Budget& budget) {
    const auto seeds = choices.seeds ? choices.seeds : system.settings.seeds;
    FigureChoices found;
    if (seeds) found.seed = seeds->first;
    found.tables = choices.tables;
    found.random_tables = choices.seeds.has_value();
    return open_modules(system, n, found, external_environment(choices.environment, system),
                        budget);
}

}  // namespace algae::cli
