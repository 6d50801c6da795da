#include "render/render.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "command/run.hpp"
#include "exact/exact.hpp"
#include "render/detail/colour_table.hpp"
#include "render/figures.hpp"
#include "render/frames.hpp"
#include "render/pixels.hpp"

using namespace algae;
using namespace algae::test;

namespace {

std::string animation(const std::vector<DrawnFigure>& figures, AnimationFormat format,
                      const PictureOptions& options = {}, const AnimationTiming& timing = {},
                      const Budget& budget = {}) {
    std::vector<Plate> plates;
    for (const DrawnFigure& figure : figures)
        plates.push_back({&figure, "figure " + std::to_string(plates.size()), ""});
    std::ostringstream out;
    draw_animation(plates, out, format, options, timing, budget);
    return out.str();
}

std::vector<DrawnFigure> koch_curves(int last) {
    std::vector<DrawnFigure> figures;
    for (int n = 0; n <= last; ++n) figures.push_back(koch(n));
    return figures;
}

/// The pixels of a picture of one figure in png.
std::vector<std::uint32_t> png_pixels(const Figure& figure, const PictureOptions& options) {
    std::ostringstream out;
    draw_picture({&figure, "figure", ""}, out, PictureFormat::png, options, {});
    const Pixels pixels(out.str());
    std::vector<std::uint32_t> found;
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x)
            found.push_back(static_cast<std::uint32_t>(pixels.opacity(x, y)) << 24 |
                            static_cast<std::uint32_t>(pixels.red(x, y)) << 16 |
                            static_cast<std::uint32_t>(pixels.green(x, y)) << 8 |
                            static_cast<std::uint32_t>(pixels.blue(x, y)));
    return found;
}

}  // namespace

TEST_CASE("the frames of an animation are the pictures of its figures, pixel by pixel") {
    PictureOptions options;
    options.width = 200;
    options.height = 80;
    const std::vector<DrawnFigure> figures = koch_curves(4);
    const std::string gif = animation(figures, AnimationFormat::gif, options);
    const std::string webp = animation(figures, AnimationFormat::webp, options);
    for (const Frames& frames : {decoded_gif(gif), decoded_webp(webp)}) {
        CHECK(frames.width == 200);
        CHECK(frames.height == 80);
        CHECK(frames.milliseconds == std::vector{800, 800, 800, 800, 2400});
        CHECK(frames.plays == 0);
        REQUIRE(frames.pictures.size() == figures.size());
        for (std::size_t i = 0; i < figures.size(); ++i)
            CHECK(frames.pictures[i] == png_pixels(figures[i], options));
    }
    CHECK(animation(figures, AnimationFormat::gif, options) == gif);
    CHECK(animation(figures, AnimationFormat::webp, options) == webp);
}

TEST_CASE("a webp keeps half-transparent pixels, a gif refuses them") {
    PictureOptions options;
    options.width = 120;
    options.height = 60;
    options.background = "transparent";
    const std::vector<DrawnFigure> figures = koch_curves(2);
    const Frames frames = decoded_webp(animation(figures, AnimationFormat::webp, options));
    REQUIRE(frames.pictures.size() == 3);
    for (std::size_t i = 0; i < figures.size(); ++i)
        CHECK(frames.pictures[i] ==
              png_pixels(figures[i], options));  // black: any opacity is exact
    CHECK_THROWS_WITH_AS(
        animation(figures, AnimationFormat::gif, options),
        "a gif or a video has no half-transparent pixels: expected a colour as its background, "
        "or webp",
        Error);
}

TEST_CASE("a gif of more than 256 colours has those most like them") {
    PictureOptions options;
    options.width = 300;
    options.height = 200;
    options.line_width = 3;
    options.colours = {"along"};
    const std::vector<DrawnFigure> figures{dragon(6), dragon(8)};
    const Frames gif = decoded_gif(animation(figures, AnimationFormat::gif, options));
    REQUIRE(gif.pictures.size() == 2);
    CHECK(gif.colours == 256);
    std::set<std::uint32_t> colours;
    int grey_paper = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::vector<std::uint32_t> png = png_pixels(figures[i], options);
        double worst = 0, sum = 0;
        for (std::size_t at = 0; at < png.size(); ++at) {
            colours.insert(png[at]);
            grey_paper += png[at] == 0xffffffff && gif.pictures[i][at] != 0xffffffff;
            for (const int shift : {0, 8, 16}) {
                const double error =
                    std::abs(static_cast<double>(png[at] >> shift & 0xff) -
                             static_cast<double>(gif.pictures[i][at] >> shift & 0xff));
                worst = std::max(worst, error);
                sum += error;
            }
        }
        CHECK(worst < 50);
        CHECK(sum / static_cast<double>(3 * png.size()) < 1);
    }
    CHECK(grey_paper == 0);
    CHECK(colours.size() > 256);
}

TEST_CASE("with a common scale figures stay where they are") {
    PictureOptions options;
    options.width = 220;
    options.height = 120;
    options.common_scale = true;
    const std::vector<DrawnFigure> figures{polyline({{0, 0}, {1, 0}}),
                                           polyline({{0, 0}, {1, 0}, {1, 1}, {2, 1}})};
    const Frames frames = decoded_gif(animation(figures, AnimationFormat::gif, options));
    REQUIRE(frames.pictures.size() == 2);
    // The box is 2 x 1; its lower left corner is at (10, 110), a unit is 100 pixels.
    const auto dark = [&](std::size_t frame, std::size_t x, std::size_t y) {
        return (frames.pictures[frame][y * 220 + x] & 0xff) < 200;
    };
    for (std::size_t frame : {0U, 1U}) {
        CHECK(dark(frame, 60, 110));
        CHECK(dark(frame, 110, 60) == (frame == 1));
        CHECK(dark(frame, 160, 10) == (frame == 1));
    }
}

TEST_CASE("frames have the times that were asked for and come as often as that") {
    PictureOptions options;
    options.width = 40;
    options.height = 40;
    const std::vector<DrawnFigure> figures = koch_curves(1);
    for (const std::uint32_t plays : {0U, 1U, 2U, 65'535U}) {
        AnimationTiming timing;
        timing.frame = 0.05;
        timing.plays = plays;
        const Frames gif = decoded_gif(animation(figures, AnimationFormat::gif, options, timing));
        CHECK(gif.plays == static_cast<int>(plays));
        CHECK(gif.milliseconds == std::vector{50, 2000});
        timing.last = 1.25;
        const Frames webp =
            decoded_webp(animation(figures, AnimationFormat::webp, options, timing));
        CHECK(webp.plays == static_cast<int>(plays));
        CHECK(webp.milliseconds == std::vector{50, 1250});
    }
    AnimationTiming timing;
    timing.frame = 0.01;
    CHECK_THROWS_WITH_AS(animation(figures, AnimationFormat::gif, options, timing),
                         "the time of a frame must be from 0.02 to 600 seconds, not 0.01", Error);
    timing.frame = 1;
    timing.plays = 65'536;
    CHECK_THROWS_WITH_AS(animation(figures, AnimationFormat::webp, options, timing),
                         "an animation is shown at most 65535 times, or for ever, not 65536 times",
                         Error);
}

TEST_CASE("equal frames stay frames in gif and become a longer one in webp") {
    PictureOptions options;
    options.width = 40;
    const std::vector<DrawnFigure> figures{koch(1), koch(1), koch(2)};
    const Frames gif = decoded_gif(animation(figures, AnimationFormat::gif, options));
    REQUIRE(gif.pictures.size() == 3);
    CHECK(gif.pictures[0] == gif.pictures[1]);
    const Frames webp = decoded_webp(animation(figures, AnimationFormat::webp, options));
    CHECK(webp.milliseconds == std::vector{1600, 2400});
    const Frames single = decoded_gif(animation({koch(1)}, AnimationFormat::gif, options));
    CHECK(single.pictures.size() == 1);
    CHECK(single.plays == 1);
}

TEST_CASE("frames that need more memory than there is are refused") {
    Budget budget;
    budget.memory = 1 << 20;
    CHECK_THROWS_AS(animation(koch_curves(1), AnimationFormat::webp, {}, {}, budget), BoundReached);
    budget.memory = 8 << 20;
    CHECK_THROWS_WITH_AS(animation(koch_curves(9), AnimationFormat::webp, {}, {}, budget),
                         doctest::Contains("what changes from frame to frame of an animation"),
                         BoundReached);
}

TEST_CASE("a table of colours has them all if it can, and the most frequent one in any case") {
    ColourTable few;
    few.count(std::vector<std::uint32_t>{0xff123456, 0x00123456, 0xffffffff});
    few.choose();
    CHECK(few.is_exact());
    CHECK(few.colours() == std::vector<std::uint32_t>{0x123456, 0xffffff});
    CHECK(few.index(0xff123456) == 0);

    ColourTable many;
    std::vector<std::uint32_t> pixels(10'000, 0xfedcba);
    for (std::uint32_t i = 0; i < 1000; ++i) pixels.push_back(i * 16'777);
    many.count(pixels);
    many.choose();
    CHECK_FALSE(many.is_exact());
    CHECK(many.colours().size() == 256);
    CHECK(many.colours()[many.index(0xfedcba)] == 0xfedcba);
}

namespace {

/// A program named ffmpeg that comes first on the PATH, or alone there.
class StandIn {
public:
    explicit StandIn(const std::string& script, bool alone = false)
        : before_(std::getenv("PATH") ? std::getenv("PATH") : "") {
        const std::string file = folder_.file("ffmpeg", script);
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
        const std::string here = std::filesystem::path(file).parent_path().string();
        setenv("PATH", (alone ? here : here + ':' + before_).c_str(), 1);
        if (script.empty()) std::filesystem::remove(file);
    }
    StandIn(const StandIn&) = delete;
    StandIn& operator=(const StandIn&) = delete;
    ~StandIn() { setenv("PATH", before_.c_str(), 1); }

private:
    Scratch folder_;
    std::string before_;
};

}  // namespace

TEST_CASE(
    "a video's frames go to ffmpeg, each as often as its time is a multiple of the shortest") {
    PictureOptions options;
    options.width = 121;
    options.height = 61;
    const std::vector<DrawnFigure> figures = koch_curves(2);
    const StandIn ffmpeg("#!/bin/sh\nbytes=$(wc -c)\necho \"$bytes $*\" >/dev/fd/3\n");
    for (const AnimationFormat format : {AnimationFormat::mp4, AnimationFormat::webm}) {
        const std::string said = animation(figures, format, options);
        // 0.8, 0.8 and 2.4 seconds are five frames of 122 by 62 pixels, four bytes each.
        CHECK(said.starts_with(std::to_string(5 * 122 * 62 * 4) + ' '));
        CHECK(said.find(" -video_size 122x62 -framerate 100/80 ") != std::string::npos);
        CHECK(said.find(format == AnimationFormat::mp4 ? " libx264 " : " libvpx-vp9 ") !=
              std::string::npos);
    }
    AnimationTiming timing;
    timing.frame = timing.last.emplace(0.04);
    const std::string said = animation(figures, AnimationFormat::mp4, options, timing);
    CHECK(said.starts_with(std::to_string(3 * 122 * 62 * 4) + ' '));
    CHECK(said.find(" -framerate 100/4 ") != std::string::npos);
}

TEST_CASE("what goes wrong with a video is said, and no file is left") {
    const Scratch scratch;
    const std::string file = scratch.file("koch.mp4");
    const std::vector<DrawnFigure> figures = koch_curves(3);
    const auto refused = [&](const std::string& script, const std::string& message,
                             const AnimationTiming& timing = {}) {
        const StandIn ffmpeg(script, script.empty());
        std::vector<Plate> plates;
        for (const DrawnFigure& figure : figures) plates.push_back({&figure, "koch", ""});
        CHECK_THROWS_WITH_AS(draw_animation(plates, file, AnimationFormat::mp4, {}, timing, {}),
                             message.c_str(), Error);
        CHECK(scratch.size() == 0);
    };
    refused("",
            "mp4 and webm are packed by the program ffmpeg, which is not on the PATH; expected it "
            "there (Debian: apt-get install ffmpeg), or .gif or .webp");
    refused("#!/bin/sh\ncat >/dev/null\necho first >&2\necho 'no such codec' >&2\nexit 1\n",
            "ffmpeg could not pack the video: no such codec");
    refused("#!/bin/sh\nexec 0</dev/null\nsleep 0.1\nexit 0\n",
            "ffmpeg ended before it had read all frames of the video");
    AnimationTiming twice;
    twice.plays = 2;
    refused("#!/bin/sh\n", "a video does not say how often it is shown; gif and webp do", twice);
}

TEST_CASE("a video ends with its deadline, and ffmpeg with it") {
    const StandIn ffmpeg("#!/bin/sh\nexec sleep 1000\n");
    Budget budget;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
    CHECK_THROWS_AS(animation(koch_curves(2), AnimationFormat::webm, {}, {}, budget), BoundReached);
}
