#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "turtle/any_turtle.hpp"
#include "turtle/recording.hpp"

using namespace algae;
using oracle::Real;
using oracle::Spot;

namespace {

Recording drawn(const Model& system, std::uint64_t n, double resolution) {
    Recording canvas;
    figure(system, n, Budget())->draw(canvas, resolution, Budget());
    return canvas;
}

/// A canvas that keeps blocks, and records their strokes.
class BlockRecording : public BlockCanvas {
public:
    void move_to(Point point) override { all.move_to(point); }
    void line_to(Point point) override { all.line_to(point); }
    void polygon(std::span<const Point> corners) override { all.polygon(corners); }
    void block(const StrokeBlock& block, Point from) override {
        kept.resize(std::max(kept.size(), block.number + 1));
        auto& known = kept[block.number];
        if (known.empty()) {
            for (const auto& stroke : block.strokes) known.push_back(stroke.to);
        } else {
            changed = changed || known.size() != block.strokes.size();
            ++repeated;
        }
        for (std::size_t i = 0; i < block.strokes.size(); ++i) {
            const auto& stroke = block.strokes[i];
            changed = changed || !(known[i].x == stroke.to.x && known[i].y == stroke.to.y);
            const Point to{from.x + stroke.to.x, from.y + stroke.to.y};
            stroke.lifted ? all.move_to(to) : all.line_to(to);
        }
    }

    Recording all;
    std::vector<std::vector<Point>> kept;  // by number
    std::size_t repeated = 0;
    bool changed = false;  // a block was not the one of its number
};

/// The distance of a point from the nearest stroke.
Real distance(Spot point, const std::vector<oracle::Stroke>& strokes) {
    Real least = std::numeric_limits<Real>::infinity();
    for (const auto& stroke : strokes)
        least = std::min(least, oracle::distance(point, stroke.from, stroke.to));
    return least;
}

/// How far points of `some` lie from `others` at most, looking at the ends and the middle of strokes.
Real farthest(const std::vector<oracle::Stroke>& some, const std::vector<oracle::Stroke>& others) {
    Real most = 0;
    for (const auto& stroke : some)
        for (const Spot point : {stroke.from, stroke.to, (stroke.from + stroke.to) / Real(2)})
            most = std::max(most, distance(point, others));
    return most;
}

/// Whether the drawing with a resolution lies within it of the true one, and the other way.
bool is_close(const oracle::WrittenSystem& written, const oracle::TurtleSettings& settings,
              unsigned n, double resolution) {
    const auto truth = oracle::drawing_of(oracle::rewritten(written, n), settings, n).strokes;
    const Recording canvas = drawn(drawn_system(written, settings), n, resolution);
    if (canvas.lost || canvas.strokes.size() > truth.size() ||
        canvas.strokes.empty() != truth.empty())
        return false;
    // Parts are remembered on a grid of a thousandth of the resolution.
    const Real bound = resolution * 1.002L + 1e-9L;
    return farthest(truth, canvas.strokes) <= bound && farthest(canvas.strokes, truth) <= bound;
}

}  // namespace

TEST_CASE("strokes are those of walking letter by letter, one by one, with width and colour") {
    const bool holds = rc::check("strokes", [] {
        const auto written = *oracle::any_bracketed("*!'.");
        auto settings = *any_turtle();
        if (*rc::gen::arbitrary<bool>()) settings.scale = oracle::Fraction{3, 4};
        if (*rc::gen::arbitrary<bool>()) settings.narrow = oracle::Fraction{1, 2};
        const unsigned n = oracle::last_generation_within(written, 300, 4);
        const auto truth = oracle::drawing_of(oracle::rewritten(written, n), settings, n);
        const Recording canvas = drawn(drawn_system(written, settings), n, 0);
        RC_ASSERT(!canvas.lost);
        RC_ASSERT(canvas.strokes.size() == truth.strokes.size());
        for (std::size_t i = 0; i < truth.strokes.size(); ++i) {
            RC_ASSERT(near(truth.strokes[i].from, canvas.strokes[i].from));
            RC_ASSERT(near(truth.strokes[i].to, canvas.strokes[i].to));
            RC_ASSERT(near(truth.strokes[i].width, canvas.strokes[i].width));
            RC_ASSERT(truth.strokes[i].colour == canvas.strokes[i].colour);
        }
    });
    CHECK(holds);
}

TEST_CASE("polygons have the corners that the turtle visits, branches included") {
    const bool holds = rc::check("polygons", [] {
        const auto inside = oracle::balanced(*oracle::any_word("FfG.+-[]FX", 8));
        const oracle::WrittenSystem written{
            "F{" + inside + "}F", {{'F', {*oracle::any_word("F+f", 2)}}, {'X', {"X{F+F+FX}"}}}};
        const auto settings = *any_turtle();
        const unsigned n = oracle::last_generation_within(written, 300, 3);
        const auto truth = oracle::drawing_of(oracle::rewritten(written, n), settings, n);
        const Recording canvas =
            drawn(drawn_system(written, settings), n, *rc::gen::element(0.0, 0.5));
        RC_ASSERT(canvas.polygons.size() == truth.polygons.size());
        for (std::size_t i = 0; i < truth.polygons.size(); ++i) {
            RC_ASSERT(canvas.polygons[i].size() == truth.polygons[i].size());
            for (std::size_t k = 0; k < truth.polygons[i].size(); ++k)
                RC_ASSERT(near(truth.polygons[i][k], canvas.polygons[i][k]));
        }
    });
    CHECK(holds);
}

TEST_CASE("a stroke that goes on where the last one ended does not lift the pen") {
    CHECK(drawn(drawn_system({"FFF+F-F", {}}, {}), 0, 0).moves == 1);
    CHECK(drawn(drawn_system({"F[+F]F", {}}, {}), 0, 0).moves == 2);
    CHECK(drawn(drawn_system({"FfF", {}}, {}), 0, 0).moves == 2);
    CHECK(drawn(drawn_system({"fff", {}}, {}), 0, 0).moves == 0);
}

TEST_CASE("positions run from above 0 to 1 along the word") {
    Recording canvas;
    canvas.wanting = true;
    figure(drawn_system({"F", {{'F', {"FF"}}}}, {}), 3, Budget())->draw(canvas, 0, Budget());
    REQUIRE(canvas.positions.size() == 8);
    CHECK(std::is_sorted(canvas.positions.begin(), canvas.positions.end()));
    CHECK(canvas.positions.front() >= 0);
    CHECK(canvas.positions.back() <= 1);
}

TEST_CASE("with a resolution nothing is drawn, and nothing left out, farther off than that") {
    const bool holds = rc::check("any bracketed system", [] {
        const auto written = *oracle::any_bracketed();
        const auto settings = *any_turtle();
        const unsigned n = oracle::last_generation_within(written, 250, 5);
        Real unit = settings.step.value();
        for (unsigned k = 0; k < n; ++k) unit *= settings.shrink.value();
        RC_ASSERT(
            is_close(written, settings, n,
                     static_cast<double>(unit) * *rc::gen::element(0.3, 1.0, 2.5, 7.0, 20.0)));
    });
    CHECK(holds);
}

TEST_CASE("the same for curves that run over themselves, plants, and steps without a line") {
    const oracle::WrittenSystem overlapping{"F", {{'F', {"FF-F-F-F-F-F+F"}}}};
    const oracle::WrittenSystem plant{"X", {{'X', {"F-[[X]+X]+F[+FX]-X"}}, {'F', {"FF"}}}};
    const oracle::WrittenSystem islands{
        "F+F+F+F", {{'F', {"F+f-FF+F+FF+Ff+FF-f+FF-F-FF-Ff-FFF"}}, {'f', {"ffffff"}}}};
    oracle::TurtleSettings plain, leaning;
    leaning.angle = {45, 2};
    leaning.heading = {90, 1};
    for (const double resolution : {0.5, 1.5, 4.0, 9.0}) {
        CAPTURE(resolution);
        CHECK(is_close(overlapping, plain, 3, resolution));
        CHECK(is_close(plant, leaning, 3, resolution));
        CHECK(is_close(islands, plain, 1, resolution));
        CHECK(is_close({"X", {{'X', {"Ffffffff"}}}}, plain, 1, resolution));
        CHECK(is_close({"X", {{'X', {"fffffffF"}}}}, plain, 1, resolution));
    }
}

TEST_CASE("the work for a resolution is bounded by the figure, not by the word") {
    // Generation 30 of the dragon: a box of some 50000 units, seen at 100 and 50 dots across.
    class Counter : public Recording {
        void line_to(Point) override { ++lines; }

    public:
        std::uint64_t lines = 0;
    };
    const auto dragon =
        figure(drawn_system({"FX", {{'X', {"X+YF+"}}, {'Y', {"-FX-Y"}}}}, {}), 30, Budget());
    const double size = std::max(dragon->box().breadth(), dragon->box().height());
    Counter fine, coarse;
    dragon->draw(fine, size / 100, Budget());
    dragon->draw(coarse, size / 50, Budget());
    CHECK(fine.lines < 300'000);
    CHECK(coarse.lines * 2 < fine.lines);
    CHECK(coarse.lines > 1000);
}

TEST_CASE("drawing stops when it is told to") {
    std::atomic<bool> stop = false;
    Budget budget;
    budget.stop = &stop;
    const auto dragon =
        figure(drawn_system({"FX", {{'X', {"X+YF+"}}, {'Y', {"-FX-Y"}}}}, {}), 40, budget);
    stop = true;
    Recording canvas;
    CHECK_THROWS_AS(dragon->draw(canvas, 0, budget), Interrupted);
}

TEST_CASE("a figure draws the same as often as one likes") {
    const auto plant =
        figure(drawn_system({"X", {{'X', {"F[+X]F[-X]+X"}}, {'F', {"FF"}}}}, {}), 4, Budget());
    Recording first, second;
    plant->draw(first, 1, Budget());
    plant->draw(second, 1, Budget());
    REQUIRE(first.strokes.size() == second.strokes.size());
    for (std::size_t i = 0; i < first.strokes.size(); ++i)
        CHECK(first.strokes[i].to == second.strokes[i].to);
}

TEST_CASE("blocks draw what single letters draw, stroke for stroke and digit for digit") {
    CHECK(rc::check("blocks", [] {
        const auto written = *oracle::any_bracketed();
        const auto settings = *any_turtle();
        const unsigned n = oracle::last_generation_within(written, 20'000, 12);
        const auto figure = algae::figure(drawn_system(written, settings), n, Budget());
        Recording blocks, letters;
        letters.wanting = true;  // positions are told letter by letter
        figure->draw(blocks, 0, Budget());
        figure->draw(letters, 0, Budget());
        RC_ASSERT(!blocks.lost);
        RC_ASSERT(blocks.moves == letters.moves);
        RC_ASSERT(blocks.strokes.size() == letters.strokes.size());
        for (std::size_t i = 0; i < blocks.strokes.size(); ++i)
            RC_ASSERT((blocks.strokes[i].from == letters.strokes[i].from &&
                       blocks.strokes[i].to == letters.strokes[i].to));
    }));
}

TEST_CASE("a canvas that keeps blocks gets all strokes, each where it is") {
    std::size_t compared = 0, repeated = 0;
    CHECK(rc::check("kept blocks", [&] {
        auto written = *oracle::any_bracketed();
        written.axiom = "FXFX" + written.axiom;  // the same letters, often in the same direction
        auto settings = *any_turtle();
        settings.angle = {*rc::gen::element(90L, 60L, 120L), 1};
        settings.heading = {*rc::gen::element(0L, 60L, 180L), 1};
        settings.spin = {0, 1};
        const unsigned n = oracle::last_generation_within(written, 20'000, 12);
        const auto figure = algae::figure(drawn_system(written, settings), n, Budget());
        BlockRecording blocks;
        Recording letters;
        letters.wanting = true;  // positions are told letter by letter
        figure->draw(blocks, 0, Budget());
        figure->draw(letters, 0, Budget());
        RC_ASSERT(!blocks.changed);
        RC_ASSERT(!blocks.all.lost);
        RC_ASSERT(blocks.all.moves == letters.moves);
        RC_ASSERT(blocks.all.strokes.size() == letters.strokes.size());
        for (std::size_t i = 0; i < letters.strokes.size(); ++i)
            RC_ASSERT((near(blocks.all.strokes[i].from, letters.strokes[i].from) &&
                       near(blocks.all.strokes[i].to, letters.strokes[i].to)));
        repeated += blocks.repeated > 0 ? 1 : 0;
        ++compared;
    }));
    CHECK(compared == 100);
    CHECK(repeated >= 10);
}

TEST_CASE("polygons of a figure are counted before they are drawn") {
    const auto leaves = figure(drawn_system({"F", {{'F', {"F[+{.F.-F.}]F"}}}}, {}), 3, Budget());
    Recording canvas;
    leaves->draw(canvas, 0, Budget());
    CHECK(!canvas.polygons.empty());
    CHECK(leaves->strokes() == canvas.strokes.size() + canvas.polygons.size());
}
