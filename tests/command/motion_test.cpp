#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

namespace {

const std::string word = "printf 'axiom F+F; F -> F+F-F; angle 60; title Zigzag\\n' |";

void refused(const std::string& arguments, const std::string& message) {
    const Scratch scratch;
    const Run failed = run("draw " + arguments + " -o " + scratch.file("picture.gif"), word);
    CHECK(failed.status == 2);
    CHECK(failed.err == "algae: " + message + "\n");
    CHECK(scratch.size() == 0);
}

}  // namespace

TEST_CASE("draw makes animations of growth") {
    const Scratch scratch;
    const std::string gif = scratch.file("koch.gif"), webp = scratch.file("koch.webp");
    const Run drawn = run("draw koch -n 0..3 --json -o " + gif);
    CHECK(drawn.status == 0);
    CHECK(json::parse(drawn.out)["figures"].size() == 4);
    CHECK(text_of(gif).starts_with("GIF89a"));
    CHECK(run("draw koch -n 0..3 -o " + webp).status == 0);
    CHECK(text_of(webp).substr(8, 4) == "WEBP");
    CHECK(run("draw koch -n 0..3 --format gif -o -").out == text_of(gif));
    // Without -n it is the growth up to what the file shows; one generation is one frame.
    CHECK(json::parse(run("draw koch --json -o " + gif).out)["figures"].size() > 1);
    CHECK(run("draw koch -n 2 -o " + gif).status == 0);
}

TEST_CASE("options of animations are checked before there is a file") {
    refused("- -n 0..2 --frame-time 0.001",
            "the time of a frame must be from 0.02 to 600 seconds, not 0.001");
    refused("- -n 0..2 --loop 70000",
            "an animation is shown at most 65535 times, or for ever, not 70000 times");
    refused("- -n 0..2 --background transparent",
            "a gif or a video has no half-transparent pixels: expected a colour as its background, "
            "or webp");
    refused("- -n 0..2 --panels",
            "--panels: animations and explanations show one figure at a time");
    refused("- -n 0..2 --max-frames 9", "--max-frames: only --progressive has it");
    const Scratch scratch;
    const Run still = run("draw koch -n 2 --loop 2 -o " + scratch.file("koch.png"));
    CHECK(still.status == 2);
    CHECK(still.err ==
          "algae: --loop: only animations have it: expected a file ending in .gif, .webp, .mp4 or "
          ".webm\n");
    const Run pages = run("draw koch -n 0..2 -o " + scratch.file("koch.svg"));
    CHECK(pages.err ==
          "algae: -n 0..2: several generations need --panels, pdf or ps for pages, or gif, webp, "
          "mp4 or webm for an animation\n");
    const Run memory = run("draw koch -n 0..8 --max-memory 9M -o " + scratch.file("koch.webp"));
    CHECK(memory.status == 3);
    CHECK(scratch.size() == 0);
}

TEST_CASE("draw --progressive shows the turtle at work, symbol by symbol") {
    const Scratch scratch;
    const std::string gif = scratch.file("koch.gif");
    const Run drawn = run("draw koch -n 2 --progressive --captions --json -o " + gif);
    CHECK(drawn.status == 0);
    CHECK(drawn.err.empty());
    const json facts = json::parse(drawn.out);
    CHECK(facts["symbols"] == 36);
    CHECK(facts["frames"] == 37);
    CHECK(facts["symbols_a_frame"] == 1);
    const Run fewer = run("draw koch -n 2 --progressive --max-frames 10 --json -o " + gif);
    CHECK(json::parse(fewer.out)["frames"] == 10);
    CHECK(fewer.err ==
          "algae: note: 36 symbols in 10 frames, 4 symbols a frame; --max-frames allows more "
          "frames\n");
    CHECK(run("draw koch -n 1 --progressive -o " + scratch.file("koch.pdf")).status == 0);
    const Run still = run("draw koch -n 2 --progressive -o " + scratch.file("koch.svg"));
    CHECK(still.status == 2);
    CHECK(
        still.err ==
        "algae: --progressive: expected gif, webp, mp4 or webm for an animation, or pdf or ps for "
        "pages, found svg\n");
    refused("- -n 0..2 --progressive", "-n 0..2: --progressive shows one generation");
    refused("- -n 1 --progressive --explain", "--explain and --progressive: expected one of them");
    refused("- -n 1 --progressive --max-frames 1", "--max-frames must be from 2 to 10000, not 1");
}

TEST_CASE("draw --explain prints a table or draws a page") {
    const Run table = run("draw - -n 0 --explain", word);
    CHECK(table.status == 0);
    CHECK(table.out ==
          "F+F\n"
          "step  symbol  what the turtle does  then it is at  heading\n"
          "              the start             (0, 0)         0°\n"
          "   1  F       forward 1, drawing    (1, 0)         0°\n"
          "   2  +       turn left by 60°      (1, 0)         60°\n"
          "   3  F       forward 1, drawing    (1.5, 0.866)   60°\n");
    const json steps = json::parse(run("draw - -n 0 --explain --json", word).out);
    CHECK(steps["word"] == "F+F");
    CHECK(steps["start"]["position"] == json({0.0, 0.0, 0.0}));
    REQUIRE(steps["steps"].size() == 3);
    CHECK(steps["steps"][0]["position"] == json({1.0, 0.0, 0.0}));
    CHECK(steps["steps"][1]["meaning"] == "turn left by 60°");
    CHECK(steps["steps"][1]["angle"].get<double>() == doctest::Approx(60));
    CHECK(steps["steps"][1]["strokes"].empty());
    CHECK(steps["steps"][2]["strokes"].size() == 1);

    const Scratch scratch;
    for (const char* name : {"koch.svg", "koch.pdf", "koch.png"}) {
        const Run page = run("draw koch -n 1 --explain -o " + scratch.file(name));
        CHECK(page.status == 0);
        CHECK(page.out.empty());
    }
    CHECK(scratch.size() == 3);
    // Without -n, the last generation that is short.
    CHECK(run("draw koch --explain").out.starts_with("F+F--F+F+F+F--F+F--F+F--F+F+F+F--F+F\n"));
}

TEST_CASE("words too long to be explained are refused with a shorter one") {
    const Run longer = run("draw koch -n 3 --explain");
    CHECK(longer.status == 2);
    CHECK(longer.err ==
          "algae: generation 3 of koch has 148 symbols: --explain shows words of at most 60, such "
          "as -n 2; --progressive draws longer ones step by step\n");
    const Run huge = run("draw koch -n 60 --explain");
    CHECK(huge.status == 2);
    CHECK(huge.err ==
          "algae: generation 60 of koch has more than 1000000 symbols: --explain shows words of at "
          "most 60, such as -n 2; --progressive draws longer ones step by step\n");
    refused("- -n 0..1 --explain", "-n 0..1: --explain shows one generation");
    const Scratch scratch;
    const Run moving = run("draw koch -n 1 --explain -o " + scratch.file("koch.gif"));
    CHECK(moving.status == 2);
    CHECK(moving.err.starts_with(
        "algae: expected a picture file ending in .svg, .pdf, .png, .ps or .eps, found"));
    CHECK(scratch.size() == 0);
}

TEST_CASE("a camera goes around a figure in space") {
    const Scratch scratch;
    const std::string gif = scratch.file("turn.gif");
    const Run drawn = run("draw hilbert-3d -n 1 --camera 0..360,20 --width 60 --json -o " + gif);
    CHECK(drawn.status == 0);
    CHECK(drawn.err.empty());
    CHECK(json::parse(drawn.out)["figures"].size() == 72);  // 5 degrees apart, the first not twice
    const auto frames = [&](const std::string& camera) {
        const Run some = run("draw hilbert-3d -n 1 --width 40 --json --camera " + camera +
                             " --frame-time 0.1 -o " + gif);
        INFO(some.err);
        CHECK(some.status == 0);
        return json::parse(some.out)["figures"].size();
    };
    CHECK(frames("0..90,15") == 19);  // from both ends on
    CHECK(frames("0..-20,15,perspective") == 5);
    CHECK(frames("10..12") == 2);
    const auto refused_camera = [&](const std::string& arguments, const std::string& message) {
        const Run failed = run("draw " + arguments);
        CHECK(failed.status == 2);
        CHECK(failed.err == "algae: " + message + "\n");
    };
    const std::string goes =
        "--camera: goes around a figure in an animation of one generation; expected a file ending "
        "in .gif, .webp, .mp4 or .webm, or one azimuth";
    refused_camera("hilbert-3d --camera 0..360,20 -o " + scratch.file("a.png"), goes);
    refused_camera("hilbert-3d --camera 0..360,20 -o " + scratch.file("a.glb"), goes);
    refused_camera("hilbert-3d --camera 0..360,20 --format html -o " + scratch.file("a.html"),
                   goes);
    refused_camera("hilbert-3d -n 1 --progressive --camera 0..360,20 -o " + scratch.file("a.gif"),
                   goes);
    refused_camera("hilbert-3d -n 0..2 --camera 0..360,20 -o " + scratch.file("a.gif"),
                   "--camera 0..360: goes around one figure, found several; expected one "
                   "generation, -n N, and one seed");
    refused_camera("koch -n 2 --camera 0..360,20 -o " + scratch.file("a.gif"),
                   "--camera is for figures in space, and those of koch stay in the plane");
    refused_camera("hilbert-3d --camera 0..0,20 -o " + scratch.file("a.gif"),
                   "--camera: expected a turn of at most 3600 degrees, such as 0..360, found "
                   "\"0..0\"");
    CHECK(scratch.size() == 1);
}

TEST_CASE("ffmpeg packs videos, the same each time") {
    if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) {
        MESSAGE("NOT TESTED: videos by ffmpeg, as it is not installed (apt-get install ffmpeg)");
        return;
    }
    const Scratch scratch;
    const auto video = [&](const std::string& name, const std::string& end) {
        const std::string path = scratch.file(name + end);
        const Run drawn = run("draw koch -n 0..3 --width 161 -o " + path);
        INFO(drawn.err);
        CHECK(drawn.status == 0);
        return text_of(path);
    };
    for (const std::string end : {".mp4", ".webm"}) {
        const std::string bytes = video("first", end);
        CHECK(bytes == video("second", end));
        CHECK(bytes.size() > 1000);
        if (end == ".mp4")
            CHECK(bytes.substr(4, 4) == "ftyp");
        else
            CHECK(bytes.starts_with("\x1a\x45\xdf\xa3"));
    }
}

TEST_CASE("draw --watch draws again when its file changes") {
    const Scratch scratch;
    const std::string file = scratch.file("a.lsys", "axiom F\ngeneration 0\n"),
                      svg = scratch.file("a.svg"), said = scratch.file("said");
    // Waits until there are so many notes.
    const auto notes_are = [&](int lines) {
        return "until [ $(grep -c note: '" + said + "') -ge " + std::to_string(lines) +
               " ]; do sleep 0.05; done\n";
    };
    const std::string script =
        "timeout 20 '" + built_command() + "' draw '" + file + "' --watch -o '" + svg + "' 2>'" +
        said + "' &\npid=$!\n" + notes_are(1) + "cp '" + svg + "' '" + scratch.file("one.svg") +
        "'\nprintf 'axiom F+F\\ngeneration 0\\n' >'" + file + "'\n" + notes_are(2) + "cp '" + svg +
        "' '" + scratch.file("two.svg") + "'\nprintf 'axiom\\n' >'" + file + "'\n" + notes_are(3) +
        "kill -TERM $pid\nwait $pid\n";
    const int ended = std::system(("sh '" + scratch.file("script", script) + "'").c_str());
    CHECK(WEXITSTATUS(ended) == 130);
    const std::string one = text_of(scratch.file("one.svg")),
                      two = text_of(scratch.file("two.svg"));
    CHECK(!one.empty());
    CHECK(!two.empty());
    CHECK(one != two);
    CHECK(text_of(svg) == two);  // a mistake leaves what is there
    const std::string notes = text_of(said);
    CHECK(notes.find("a.svg is drawn, and again when") != std::string::npos);
    CHECK(notes.find("expected a word after") != std::string::npos);
    refused("- --watch", "--watch: expected a file that may change, found '-'");
}
