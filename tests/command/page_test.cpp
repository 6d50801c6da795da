// Pages of HTML, opened in a browser without a window where there is one.

#include <doctest/doctest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "command/run.hpp"

using nlohmann::json;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The command that runs Chromium; empty if there is none.
std::string browser() {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
        if (std::system(("command -v " + std::string(name) + " >/dev/null").c_str()) == 0)
            return name;
    return {};
}

/// A page as the browser has it after its program has run.
class Browser {
public:
    explicit Browser(const Scratch& scratch) : scratch_(scratch) {}

    std::string page(const std::string& file, const std::string& options = "--dump-dom") const {
        const std::string out = scratch_.file("dom"), log = scratch_.file("log");
        const std::string command =
            browser() +
            " --headless --no-sandbox --disable-gpu --disable-dev-shm-usage "
            "--no-first-run --virtual-time-budget=4000 --user-data-dir='" +
            scratch_.file("profile") + "' " + options + " 'file://" + file + "' > '" + out +
            "' 2> '" + log + "'";
        const int status = std::system(command.c_str());
        INFO(text_of(log));
        CHECK(status == 0);
        return text_of(out);
    }

private:
    const Scratch& scratch_;
};

bool asks_the_network(const std::string& page) {
    return holds(page, "src=") || holds(page, "<link") || holds(page, "@import") ||
           holds(page, "fetch(");
}

}  // namespace

TEST_CASE("pages of figures in space and of plots are whole, and say what is wrong") {
    const Scratch scratch;
    const std::string file = scratch.file("hilbert.html");
    const Run drawn = run("draw hilbert-3d -n 1..2 --json -o '" + file + "'");
    INFO(drawn.err);
    REQUIRE(drawn.status == 0);
    CHECK(json::parse(drawn.out)["scenes"] == 2);
    const std::string page = text_of(file);
    CHECK(page.starts_with("<!DOCTYPE html>"));
    CHECK(!asks_the_network(page));
    CHECK(run("draw hilbert-3d -n 1..2 -o '" + scratch.file("again.html") + "'").status == 0);
    CHECK(text_of(scratch.file("again.html")) == page);
    CHECK(holds(run("draw hilbert-3d -n 2 --width 100 -o '" + file + "'").err,
                "--width: a page shows one figure in space at a time"));
    CHECK(holds(run("draw 'axiom &' -n 0 -o '" + file + "'").err, "draws nothing"));
    const std::string plot = scratch.file("growth.html"), counts = scratch.file("boxes.html");
    CHECK(run("growth fibonacci --plot '" + plot + "'").status == 0);
    CHECK(holds(text_of(plot), "<td>20</td>"));
    CHECK(!asks_the_network(text_of(plot)));
    CHECK(run("dimension koch -n 5 --plot '" + counts + "'").status != 2);
    CHECK(holds(text_of(counts), "cells touched"));
}

TEST_CASE("a browser draws the pages") {
    if (browser().empty()) {
        MESSAGE("Chromium is not here: pages of HTML were NOT opened; tools/browser installs it");
        return;
    }
    const Scratch scratch;
    const Browser opened(scratch);
    const std::string space = scratch.file("space.html"), plane = scratch.file("plane.html"),
                      plot = scratch.file("plot.html"), solid = scratch.file("solid.html");
    REQUIRE(run("draw hilbert-3d -n 1..2 -o '" + space + "'").status == 0);
    const std::string all = opened.page(space);
    CHECK(holds(all, "data-drawn=\"63\""));
    CHECK(holds(all, "63 of 63"));
    CHECK(holds(opened.page(space + "#figure=0&parts=5&azimuth=10"), "data-drawn=\"5\""));
    CHECK(holds(opened.page(space + "#figure=0"), "7 of 7"));
    REQUIRE(run("draw 'axiom A&A; solid A box' -n 0 -o '" + solid + "'").status == 0);
    CHECK(holds(opened.page(solid), "data-drawn=\"12\""));  // six sides each

    REQUIRE(run("draw koch -n 0..3 -o '" + plane + "'").status == 0);
    CHECK(holds(opened.page(plane + "#figure=2&strokes=7"), "data-drawn=\"7\""));
    CHECK(holds(opened.page(plane), "64 of 64"));

    REQUIRE(run("growth fibonacci --plot '" + plot + "'").status == 0);
    CHECK(holds(opened.page(plot), "data-seen=\"0 0 480 320\""));
    CHECK(holds(opened.page(plot + "#zoom=2"), "data-seen=\"120 80 240 160\""));

    // Something is seen: a picture of the page is no blank sheet.
    const std::string shot = scratch.file("shot.png");
    opened.page(space, "--window-size=400,400 --screenshot='" + shot + "'");
    REQUIRE(text_of(shot).starts_with("\x89PNG"));
    CHECK(run("dimension '" + shot + "' --json").status != 2);
    CHECK(text_of(shot).size() > 5000);
}

TEST_CASE("standard input may be asked for more than once") {
    // A page of a figure asked whether it is in space, and then for the system; a panel for each value opened it anew.
    const Scratch files;
    const std::string system =
        files.file("koch.lsys", "let a = 60\naxiom F\nF -> F+F--F+F\nangle a\n");
    const std::string page = files.file("koch.html"), panels = files.file("panels.svg");
    const Run drawn = run("draw - -n 3 -o '" + page + "' <'" + system + "'");
    CHECK(drawn.err == "");
    CHECK(drawn.status == 0);
    CHECK(text_of(page).find("<html") != std::string::npos);
    CHECK(run("draw - -n 3 --let a=30..60:30 --panels -o '" + panels + "' <'" + system + "'").err ==
          "");
    CHECK(std::filesystem::exists(panels));
}
