#include "render/render.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <limits>
#include <regex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "exact/exact.hpp"
#include "render/figures.hpp"
#include "render/pixels.hpp"

#ifdef __SANITIZE_ADDRESS__
/// Fontconfig keeps what it has read about fonts.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }
#endif

using namespace algae;
using namespace algae::test;
namespace files = std::filesystem;

namespace {

constexpr PictureFormat all_formats[] = {PictureFormat::svg, PictureFormat::pdf, PictureFormat::png,
                                         PictureFormat::ps, PictureFormat::eps};

Plate plate(const Figure& figure, std::string caption = "") {
    return {&figure, "generation 3 of koch.lsys", std::move(caption)};
}

std::string picture(const Figure& figure, PictureFormat format, const PictureOptions& options = {},
                    const std::string& caption = "") {
    std::ostringstream out;
    draw_picture(plate(figure, caption), out, format, options, Budget{});
    return out.str();
}

std::string message(const Figure& figure, PictureFormat format, const PictureOptions& options) {
    try {
        picture(figure, format, options);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

/// The numbers of the paths of an SVG document.
std::vector<double> path_numbers(const std::string& svg) {
    std::vector<double> numbers;
    for (std::size_t at = svg.find(" d=\"M"); at != std::string::npos;
         at = svg.find(" d=\"M", at + 1)) {
        std::istringstream path(svg.substr(at + 4, svg.find('"', at + 5) - at - 4));
        for (std::string word; path >> word;)
            if (word != "M" && word != "L") numbers.push_back(std::stod(word));
    }
    return numbers;
}

}  // namespace

TEST_CASE("the format is the end of the name") {
    CHECK(picture_format("koch.svg") == PictureFormat::svg);
    CHECK(picture_format("figures/koch.SVG") == PictureFormat::svg);
    CHECK(picture_format("a.b/koch.Pdf") == PictureFormat::pdf);
    CHECK(picture_format("koch.png") == PictureFormat::png);
    CHECK(picture_format("koch.ps") == PictureFormat::ps);
    CHECK(picture_format("koch.eps") == PictureFormat::eps);
    for (const char* path : {"koch", "koch.gif", "a.svg/koch", "", ".", "koch.svg "})
        CHECK_THROWS_WITH_AS(picture_format(path),
                             ("expected a picture file ending in .svg, .pdf, .png, .ps or .eps, "
                              "found \"" +
                              std::string(path) + "\"")
                                 .c_str(),
                             Error);
}

TEST_CASE("documents begin as their format does and have the size asked for") {
    const DrawnFigure figure = koch(3);
    PictureOptions options;
    options.width = 300;
    options.height = 200;
    CHECK(picture(figure, PictureFormat::svg, options).starts_with("<?xml"));
    CHECK(picture(figure, PictureFormat::svg, options).find("width=\"300pt\" height=\"200pt\"") !=
          std::string::npos);
    CHECK(picture(figure, PictureFormat::pdf, options).starts_with("%PDF-1."));
    CHECK(picture(figure, PictureFormat::pdf, options).find("/MediaBox [ 0 0 300 200 ]") !=
          std::string::npos);
    CHECK(picture(figure, PictureFormat::ps, options).starts_with("%!PS-Adobe-3.0\n"));
    CHECK(picture(figure, PictureFormat::ps, options).find("300 200") != std::string::npos);
    CHECK(picture(figure, PictureFormat::eps, options).starts_with("%!PS-Adobe-3.0 EPSF-3.0"));
    const Pixels pixels(picture(figure, PictureFormat::png, options));
    CHECK(pixels.width == 300);
    CHECK(pixels.height == 200);

    std::ostringstream out;
    const Drawn drawn = draw_picture(plate(figure), out, PictureFormat::svg, {}, Budget{});
    CHECK(drawn.width == doctest::Approx(600));
    CHECK(drawn.height == doctest::Approx(20 + 580 * std::sqrt(3.0) / 6));
    CHECK(drawn.lines == 64);
    CHECK_FALSE(drawn.as_image);
    CHECK_FALSE(drawn.fine);
}

TEST_CASE("equal figures are equal files") {
    const DrawnFigure figure = koch(3), fine = dragon(13);
    const std::string caption = "Koch's curve, n = 3, \u03b4 = 60\u00b0";
    PictureOptions image;
    image.route = PictureOptions::Route::cells;
    std::vector<std::string> first;
    for (const PictureFormat format : all_formats) {
        first.push_back(picture(figure, format, {}, caption));
        first.push_back(picture(fine, format, image, caption));
    }
    // Dates in documents count seconds.
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    std::size_t i = 0;
    for (const PictureFormat format : all_formats) {
        CHECK(first[i++] == picture(figure, format, {}, caption));
        CHECK(first[i++] == picture(fine, format, image, caption));
    }
    for (const std::string& document : first) CHECK(document.find("Date") == std::string::npos);
}

TEST_CASE("pictures drawn at once by several threads are the same too") {
    const DrawnFigure figure = koch(4);
    const std::string alone = picture(figure, PictureFormat::svg, {}, "Koch");
    std::atomic<int> equal{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            for (int j = 0; j < 5; ++j)
                equal += picture(figure, PictureFormat::svg, {}, "Koch") == alone;
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(equal == 20);
}

TEST_CASE("Koch's curve lies where a hand puts it") {
    PictureOptions options;
    options.width = 320;  // 300 for the curve, 100 a side
    const std::string svg = picture(koch(1), PictureFormat::svg, options);
    const double height = 20 + 50 * std::sqrt(3.0), base = height - 10;
    const std::vector<double> expected = {10,  base, 110, base, 160, base - 50 * std::sqrt(3.0),
                                          210, base, 310, base};
    const std::vector<double> found = path_numbers(svg);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        CHECK(std::fabs(found[i] - expected[i]) <=
              1 / 512.0 + 1e-6);  // Cairo counts in 1/256 point
}

TEST_CASE("the pixels of a square") {
    // A square of 40 pixels with lines of 2, on whole pixels.
    const DrawnFigure square = polyline({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}});
    PictureOptions options;
    options.width = 60;
    options.line_width = 2;
    options.colours = {"red"};
    for (const auto route : {PictureOptions::Route::strokes, PictureOptions::Route::cells}) {
        options.route = route;
        const Pixels pixels(picture(square, PictureFormat::png, options));
        CHECK(pixels.width == 60);
        CHECK(pixels.height == 60);
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 60; ++x) {
                CAPTURE(x);
                CAPTURE(y);
                const int edge = std::min({std::abs(2 * x + 1 - 20), std::abs(2 * x + 1 - 100)});
                const int side = std::min({std::abs(2 * y + 1 - 20), std::abs(2 * y + 1 - 100)});
                const bool corner = (x == 9 || x == 50) && (y == 9 || y == 50);  // rounded
                if (corner) continue;
                const bool inside = x >= 9 && x < 51 && y >= 9 && y < 51;
                const bool line = inside && (edge == 1 || side == 1);
                CHECK(pixels.red(x, y) == 255);
                CHECK(pixels.green(x, y) == (line ? 0 : 255));
                CHECK(pixels.blue(x, y) == (line ? 0 : 255));
            }
    }
}

TEST_CASE("backgrounds and polygons") {
    const DrawnFigure shape([](Canvas& canvas, double) {
        const Point corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        canvas.colour(1);
        canvas.polygon(corners);
    });
    PictureOptions options;
    options.width = 40;
    options.colours = {"black", "blue"};
    for (const auto route : {PictureOptions::Route::strokes, PictureOptions::Route::cells}) {
        options.route = route;
        options.background = "transparent";
        const Pixels clear(picture(shape, PictureFormat::png, options));
        CHECK(clear.opacity(2, 2) == 0);
        CHECK(clear.opacity(20, 20) == 255);
        CHECK(clear.blue(20, 20) == 255);
        CHECK(clear.red(20, 20) == 0);
        CHECK(clear.opacity(9, 20) == 0);
        CHECK(clear.opacity(10, 20) == 255);
        CHECK(clear.opacity(30, 20) == 0);
        options.background = "#ff0";
        const Pixels yellow(picture(shape, PictureFormat::png, options));
        CHECK(yellow.red(2, 2) == 255);
        CHECK(yellow.blue(2, 2) == 0);
    }
}

TEST_CASE("hues run along the curve") {
    const DrawnFigure figure = dragon(10);
    PictureOptions options;
    options.colours = {"along"};
    const std::string svg = picture(figure, PictureFormat::svg, options);
    CHECK(occurrences(svg, "<path") == 360);
    const double red_first = 100 * scheme_colour("along", 0).red;
    CHECK(svg.find("stroke:rgb(" + std::to_string(red_first).substr(0, 6)) != std::string::npos);
    options.width = 100;
    options.route = PictureOptions::Route::cells;
    const Pixels pixels(picture(figure, PictureFormat::png, options));
    bool reddish = false, greenish = false;
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x) {
            const int red = pixels.red(x, y), green = pixels.green(x, y);
            reddish = reddish || red > green + 80;
            greenish = greenish || green > red + 80;
        }
    CHECK(reddish);
    CHECK(greenish);
}

TEST_CASE("widths and flat ends") {
    const DrawnFigure figure([](Canvas& canvas, double) {
        canvas.move_to({0, 0});
        canvas.line_to({0, 10});
        canvas.width(0.5);
        canvas.move_to({10, 0});
        canvas.line_to({10, 10});
    });
    PictureOptions options;
    options.line_width = 6;
    options.flat_ends = true;
    const std::string svg = picture(figure, PictureFormat::svg, options);
    CHECK(svg.find("stroke-width:6;stroke-linecap:butt") != std::string::npos);
    CHECK(svg.find("stroke-width:3;stroke-linecap:butt") != std::string::npos);
    CHECK(picture(figure, PictureFormat::svg).find("stroke-linecap:round") != std::string::npos);

    // Long curves with flat ends are cut into paths that overlap by a line.
    const std::string curve = picture(koch(6), PictureFormat::svg, options);
    CHECK(occurrences(curve, "<path") == 5);
    CHECK(path_numbers(curve).size() == 2 * (4096 + 1 + 4 * 2));
}

TEST_CASE("strokes that grow wider make room for themselves, up to a limit") {
    DrawnFigure figure([](Canvas& canvas, double) {
        canvas.move_to({0, 0});
        canvas.line_to({10, 0});
        canvas.width(-50);
        canvas.move_to({0, 0});
        canvas.line_to({10, 0});
    });
    figure.own.narrow = Quantity{};
    figure.own.narrow->value = -50;
    std::ostringstream out;
    CHECK(draw_picture(plate(figure), out, PictureFormat::png, {}, Budget{}).height == 50);
    PictureOptions options;
    options.line_width = 1000;
    CHECK(message(figure, PictureFormat::pdf, options) ==
          "the widest stroke is 50000 points wide: the setting narrow lets the symbol ! widen "
          "strokes too much");
    options.line_width.reset();
    options.width = 100;
    for (const auto route : {PictureOptions::Route::strokes, PictureOptions::Route::cells}) {
        options.route = route;
        const Pixels pixels(picture(figure, PictureFormat::png, options));
        CHECK(pixels.height == 50);
        CHECK(pixels.red(50, 0) == 0);
        CHECK(pixels.red(50, 49) == 0);
    }
}

TEST_CASE("a width that is a length grows with the picture, which has room for it") {
    const DrawnFigure figure([](Canvas& canvas, double) {
        canvas.move_to({0, 0});
        canvas.line_to({0, 10});
        canvas.width_as_length(2);
        canvas.move_to({10, 0});
        canvas.line_to({10, 10});
        canvas.width(1);
    });
    PictureOptions options;
    options.width = 140;  // ten pixels a unit: margins of 10, and half the width on each side
    for (const auto route : {PictureOptions::Route::strokes, PictureOptions::Route::cells}) {
        options.route = route;
        const Pixels pixels(picture(figure, PictureFormat::png, options));
        CHECK(pixels.height == 140);
        for (const int x : {20, 112, 120, 128}) CHECK(pixels.red(x, 70) < 140);
        for (const int x : {10, 15, 25, 60, 107, 133}) CHECK(pixels.red(x, 70) == 255);
        CHECK(pixels.red(120, 12) == 0);
        CHECK(pixels.red(120, 7) == 255);
    }
}

TEST_CASE("a stroke is never cut off by the margin") {
    const DrawnFigure line = polyline({{0, 0}, {1, 0}});
    PictureOptions options;
    options.width = 100;
    options.margin = 0;
    options.line_width = 20;
    const Pixels pixels(picture(line, PictureFormat::png, options));
    CHECK(pixels.height == 20);
    CHECK(pixels.red(50, 0) == 0);
    CHECK(pixels.red(50, 19) == 0);
    CHECK(pixels.red(0, 0) > 200);  // a round end
}

TEST_CASE("a figure without strokes is an error, in a row it is a blank") {
    const DrawnFigure nothing([](Canvas&, double) {}), figure = koch(1);
    CHECK(
        message(nothing, PictureFormat::svg, {}) ==
        "generation 3 of koch.lsys draws nothing: symbols that draw are F, G, F_x and polygons in "
        "braces");
    const Plate plates[] = {plate(nothing, "n = 0"), plate(figure, "n = 1")};
    std::ostringstream out;
    const Drawn drawn = draw_panels(plates, out, PictureFormat::svg, {}, Budget{});
    CHECK(drawn.blank == std::vector<std::size_t>{0});
    CHECK(drawn.lines == 4);
    CHECK_THROWS_AS(draw_panels(std::span(plates, 1), out, PictureFormat::svg, {}, Budget{}),
                    Error);
    CHECK_THROWS_WITH_AS(draw_pages({}, out, PictureFormat::pdf, {}, Budget{}),
                         "there is no figure to draw", Error);
}

TEST_CASE("pages and panels") {
    std::vector<DrawnFigure> figures;
    for (int n = 0; n < 7; ++n) figures.push_back(koch(n));
    std::vector<Plate> plates;
    for (const DrawnFigure& figure : figures)
        plates.push_back(plate(figure, "n = " + std::to_string(plates.size())));

    std::ostringstream pdf, ps, svg;
    const Drawn drawn = draw_pages(plates, pdf, PictureFormat::pdf, {}, Budget{});
    CHECK(pdf.str().find("/Count 7") != std::string::npos);
    CHECK(drawn.lines == 1 + 4 + 16 + 64 + 256 + 1024 + 4096);
    draw_pages(plates, ps, PictureFormat::ps, {}, Budget{});
    CHECK(ps.str().find("%%Pages: 7") != std::string::npos);
    for (const PictureFormat format : {PictureFormat::svg, PictureFormat::png, PictureFormat::eps})
        CHECK_THROWS_AS(draw_pages(plates, svg, format, {}, Budget{}), Error);
    CHECK_THROWS_WITH_AS(
        draw_pages(plates, svg, PictureFormat::svg, {}, Budget{}),
        "a svg file holds one page; several generations need pdf or ps, or stand side by side "
        "as panels",
        Error);
    CHECK(svg.str().empty());
    const Drawn panels = draw_panels(plates, svg, PictureFormat::svg, {}, Budget{});
    CHECK(panels.width == doctest::Approx(600));
    CHECK(occurrences(svg.str(), "<path style=\"fill:none;stroke-width:0.6;") == 5 + 2 + 5);
}

TEST_CASE("options out of range are errors before any work") {
    const DrawnFigure figure = koch(1);
    PictureOptions options;
    options.width = 0;
    CHECK(message(figure, PictureFormat::svg, options) ==
          "the width must be from 1 to 14400 points in svg, not 0");
    options = {};
    options.height = 30'000;
    CHECK(message(figure, PictureFormat::png, options) ==
          "the height must be from 1 to 20000 pixels in png, not 30000");
    options.height = std::numeric_limits<double>::quiet_NaN();
    CHECK(message(figure, PictureFormat::pdf, options) ==
          "the height must be from 1 to 14400 points in pdf, not nan");
    options = {};
    options.margin = -1;
    CHECK(message(figure, PictureFormat::eps, options) ==
          "the margin must be from 0 to 7200 points in eps, not -1");
    options = {};
    options.line_width = 0;
    CHECK(message(figure, PictureFormat::ps, options) ==
          "the line width must be from 0.001 to 14400 points in ps, not 0");
    options = {};
    options.colours = {"rde"};
    CHECK(message(figure, PictureFormat::svg, options) ==
          "there is no colour \"rde\"; did you mean \"red\"?");
    options = {};
    options.background = "whit";
    CHECK(message(figure, PictureFormat::svg, options) ==
          "there is no colour \"whit\"; did you mean \"white\"?");
    options = {};
    options.columns = 0;
    CHECK(message(figure, PictureFormat::svg, options) ==
          "a row of panels must have at least 1 column, not 0");
    options = {};
    options.width = 20;
    CHECK(message(figure, PictureFormat::svg, options) ==
          "margins and captions leave no room in a width of 20 points");

    const DrawnFigure endless = polyline({{0, 0}, {std::numeric_limits<double>::infinity(), 0}});
    CHECK(message(endless, PictureFormat::svg, {}) ==
          "generation 3 of koch.lsys reaches beyond the range of numbers; its step or shrink makes "
          "it "
          "too large to draw");
    const DrawnFigure needle = polyline({{0, 0}, {1, 1000}});
    options = {};
    options.width = 600;
    CHECK(message(needle, PictureFormat::png, options) ==
          "the height must be from 1 to 20000 pixels in png, not 580020");
}

TEST_CASE("memory, time and interruption bound the work") {
    const DrawnFigure figure = dragon(14);
    PictureOptions options;
    options.width = 2000;
    Budget budget;
    budget.memory = 1 << 20;
    std::ostringstream out;
    CHECK_THROWS_WITH_AS(draw_picture(plate(figure), out, PictureFormat::png, options, budget),
                         "a picture of 2000 x 1337 pixels would take more than the 1 MiB allowed",
                         BoundReached);
    budget = {};
    budget.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    CHECK_THROWS_AS(draw_picture(plate(figure), out, PictureFormat::png, options, budget),
                    BoundReached);
    budget = {};
    const std::atomic<bool> stop{true};
    budget.stop = &stop;
    for (const PictureFormat format : all_formats)
        CHECK_THROWS_AS(draw_picture(plate(figure), out, format, options, budget), Interrupted);
    CHECK(out.str().empty());
}

TEST_CASE("a vector format takes an image where strokes are too many") {
    const DrawnFigure figure = dragon(12);
    PictureOptions options;
    options.most_strokes = 4000;
    for (const PictureFormat format : all_formats) {
        std::ostringstream out;
        const Drawn drawn = draw_picture(plate(figure), out, format, options, Budget{});
        CHECK(drawn.as_image == (format != PictureFormat::png));
        CHECK(drawn.lines == 4096);
    }
    const std::string svg = picture(figure, PictureFormat::svg, options);
    CHECK(occurrences(svg, "data:image/png;base64") == 1);
    CHECK(svg.find("width=\"2400\"") != std::string::npos);  // 4 pixels a point
}

TEST_CASE("files: whole or not at all") {
    const files::path folder =
        files::temp_directory_path() / ("algae-picture-" + std::to_string(::getpid()));
    files::create_directories(folder);
    const std::string path = (folder / "koch.svg").string();
    const DrawnFigure figure = koch(6);
    draw_picture(plate(figure), path, PictureFormat::svg, {}, Budget{});
    CHECK(files::file_size(path) == picture(figure, PictureFormat::svg).size());

    const DrawnFigure broken([](Canvas& canvas, double resolution) {
        canvas.move_to({0, 0});
        canvas.line_to({1, 1});
        static int calls = 0;
        if (++calls > 1) throw Error("unmatched ']'");
        (void)resolution;
    });
    CHECK_THROWS_WITH_AS(draw_picture(plate(broken), path, PictureFormat::svg, {}, Budget{}),
                         "unmatched ']'", Error);
    CHECK(files::file_size(path) == picture(figure, PictureFormat::svg).size());
    for (const PictureFormat format : all_formats)
        CHECK_THROWS_WITH_AS(draw_picture(plate(figure), "/dev/full", format, {}, Budget{}),
                             "cannot write /dev/full: No space left on device", Error);
    CHECK_THROWS_WITH_AS(
        draw_picture(plate(figure), folder.string(), PictureFormat::svg, {}, Budget{}),
        ("cannot write " + folder.string() + ": Is a directory").c_str(), Error);
    CHECK(std::distance(files::directory_iterator(folder), files::directory_iterator()) == 1);
    files::remove_all(folder);
}

TEST_CASE("progress rises to 1") {
    struct Watch : Progress {
        void report(double done) override {
            CHECK(done >= last);
            CHECK(done <= 1);
            last = done;
            ++reports;
        }
        double last = 0;
        int reports = 0;
    };
    const DrawnFigure figure = dragon(17);
    for (const auto route : {PictureOptions::Route::strokes, PictureOptions::Route::cells}) {
        PictureOptions options;
        options.route = route;
        Watch watch;
        std::ostringstream out;
        draw_picture(plate(figure), out, PictureFormat::png, options, Budget{}, &watch);
        CHECK(watch.last == 1);
        CHECK(watch.reports > 1);
    }
}
