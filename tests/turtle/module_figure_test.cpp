#include "growth/growth.hpp"
#include "turtle/detail/plane_figure.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"
#include "turtle/any_turtle.hpp"
#include "turtle/recording.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

/// A generation of a D0L system by the walker of modules, whatever `figure` would choose.
std::unique_ptr<Figure> by_modules(const Model& system, std::uint64_t n) {
    const Rewriting rewriting(system);
    return module_figure(system, rewriting.rules().kinds, derive(rewriting, n), n, 1, Budget());
}

Recording drawn(const Figure& figure, bool wanting = false) {
    Recording canvas;
    canvas.wanting = wanting;
    figure.draw(canvas, 0, Budget());
    return canvas;
}

std::unique_ptr<Figure> figure_of(const std::string& text, std::uint64_t n,
                                  const FigureChoices& choices = {}) {
    return figure(read_lsystem(text, "x.lsys"), n, Budget(), choices);
}

std::string refusal(const std::string& text, const FigureChoices& choices = {}) {
    try {
        figure_of(text, 1, choices);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("systems without parameters: the walker of modules draws what the exact figure draws") {
    const bool holds = rc::check("by modules", [] {
        const auto written = *oracle::any_bracketed("*!'.|G");
        auto settings = *any_turtle();
        if (*rc::gen::arbitrary<bool>()) settings.scale = oracle::Fraction{3, 4};
        if (*rc::gen::arbitrary<bool>()) settings.narrow = oracle::Fraction{1, 2};
        const unsigned n = oracle::last_generation_within(written, 300, 4);
        const Model system = drawn_system(written, settings);
        const auto exact = figure(system, n, Budget()), modules = by_modules(system, n);
        const Recording truth = drawn(*exact, true), canvas = drawn(*modules, true);
        RC_ASSERT(!canvas.lost);
        RC_ASSERT(canvas.strokes.size() == truth.strokes.size());
        for (std::size_t i = 0; i < truth.strokes.size(); ++i) {
            RC_ASSERT(near(truth.strokes[i].from, canvas.strokes[i].from));
            RC_ASSERT(near(truth.strokes[i].to, canvas.strokes[i].to));
            RC_ASSERT(near(truth.strokes[i].width, canvas.strokes[i].width));
            RC_ASSERT(truth.strokes[i].colour == canvas.strokes[i].colour);
        }
        RC_ASSERT(canvas.positions == truth.positions);
        RC_ASSERT(modules->segments() == exact->segments());
        RC_ASSERT(modules->box().empty == exact->box().empty);
        for (std::size_t i = 0; i < 2; ++i)
            RC_ASSERT(near(modules->facts().end[i].value(), exact->facts().end[i].value()));
        if (exact->box().empty) return;
        for (std::size_t i = 0; i < 2; ++i) {
            RC_ASSERT(near(modules->facts().low[i].value(), exact->facts().low[i].value()));
            RC_ASSERT(near(modules->facts().high[i].value(), exact->facts().high[i].value()));
        }
    });
    CHECK(holds);
}

TEST_CASE("polygons and cut branches are the same by modules") {
    const bool holds = rc::check("polygons by modules", [] {
        const auto inside = oracle::balanced(*oracle::any_word("FfG.+-[]FX%", 8));
        const oracle::WrittenSystem written{
            "F{" + inside + "}F", {{'F', {*oracle::any_word("F+f", 2)}}, {'X', {"X{F+F+FX}"}}}};
        const Model system = drawn_system(written, *any_turtle());
        const unsigned n = oracle::last_generation_within(written, 300, 3);
        const Recording truth = drawn(*figure(system, n, Budget())),
                        canvas = drawn(*by_modules(system, n));
        RC_ASSERT(canvas.strokes.size() == truth.strokes.size());
        RC_ASSERT(canvas.polygons.size() == truth.polygons.size());
        for (std::size_t i = 0; i < truth.polygons.size(); ++i) {
            RC_ASSERT(canvas.polygons[i].size() == truth.polygons[i].size());
            for (std::size_t k = 0; k < truth.polygons[i].size(); ++k)
                RC_ASSERT(near(truth.polygons[i][k], canvas.polygons[i][k]));
        }
    });
    CHECK(holds);
}

TEST_CASE("a curve with lengths as parameters is the one with a step that shrinks") {
    const auto lengths = figure_of(
        "axiom F(1)-(120)F(1)-(120)F(1)\n"
        "F(x) -> F(x/3)+(60)F(x/3)-(120)F(x/3)+(60)F(x/3)",
        4);
    const auto steps = figure_of("axiom F--F--F; F -> F+F--F+F; angle 60; shrink 1/3", 4);
    const Recording one = drawn(*lengths), other = drawn(*steps);
    REQUIRE(one.strokes.size() == 768);
    REQUIRE(other.strokes.size() == 768);
    for (std::size_t i = 0; i < one.strokes.size(); ++i)
        CHECK(near(one.strokes[i].to, other.strokes[i].to));
    CHECK_FALSE(lengths->facts().exact);
    CHECK(steps->facts().exact);
    CHECK(trace(*lengths, Budget()).vertices == trace(*steps, Budget()).vertices);
    CHECK(lengths->facts().step == doctest::Approx(1.0 / 81));
}

TEST_CASE(
    "systems with interactions, choices or tables have exact figures where no module has "
    "parameters") {
    const auto signal = figure_of("axiom F_bF_aF_a; F_b < F_a -> F_b; F_b -> +F_a; angle 60", 2);
    CHECK(signal->facts().exact);
    CHECK(signal->segments() == Integer(3));
    const std::string plant = "axiom F; angle 22.5\nF -(1/2)-> F[+F]F\nF -(1/2)-> F[-F]F";
    const auto first = figure_of(plant, 4);
    CHECK(first->facts().exact);
    CHECK(drawn(*first).strokes.size() == 81);
    CHECK(first->box() == figure_of(plant, 4, {1, {}})->box());
    CHECK_FALSE(first->box() == figure_of(plant, 4, {2, {}})->box());
    const std::string tables = "axiom F; table a; F -> FF; table b; F -> F[+F]";
    CHECK(figure_of(tables, 3, {std::nullopt, {0, 0, 1}})->segments() == Integer(8));
    CHECK(figure_of(tables, 3, {std::nullopt, {0, 0, 1}})->facts().high[1].value() == 1);
    CHECK(refusal(tables).find("2 tables") != std::string::npos);
    CHECK(refusal("axiom F; F -> F; F -> FF") ==
          "cannot draw x.lsys: not a D0L system: F has 2 rules");
    CHECK(refusal("axiom F; F -> F; F -> FF", {3, {}}).empty());
}

TEST_CASE("plots and stamps") {
    const auto plot = figure_of("axiom F(1,2)F(3,0)[F(0,5)]f; plot F; start 1 1 0", 0);
    const Recording lines = drawn(*plot);
    REQUIRE(lines.strokes.size() == 3);
    CHECK(near(lines.strokes[0].from, {1, 1}));
    CHECK(near(lines.strokes[1].to, {3, 0}));
    CHECK(near(lines.strokes[2].to, {0, 5}));
    CHECK(plot->facts().end[0].value() == 4);

    const auto stamps = figure_of(
        "axiom Sf+S(1)fTfC; stamp S square; stamp T triangle; stamp C circle; angle 90", 0);
    const Recording shapes = drawn(*stamps);
    REQUIRE(shapes.polygons.size() == 4);
    CHECK(near(shapes.polygons[0][0], {1, 1}));
    CHECK(near(shapes.polygons[0][2], {-1, -1}));
    CHECK(near(shapes.polygons[1][0], {0.5, 0.5}));
    CHECK(near(shapes.polygons[2][0], {1, 1 + 2 / std::sqrt(3.0L)}));
    CHECK(shapes.polygons[3].size() == 64);
    CHECK(near(shapes.polygons[3][0], {1, 3}));
    CHECK(stamps->segments() == Integer(0));
    CHECK(stamps->strokes() == 4);
}

TEST_CASE("widths that are lengths reach the canvas, and the facts") {
    const auto tree = figure_of("axiom F!(0.5)F[!(0.25)+F]!(2)[f]!(0.1)F", 0);
    CHECK(drawn(*tree).lengths == std::vector<double>{0.5, 0.25, 0.5, 2, 0.1});
    CHECK(tree->facts().widest == 0.5);
}

TEST_CASE("colours by their parts reach the canvas, and end with their branch") {
    class Painted : public Recording {
    public:
        void paint(const Colour& colour) override { paints.push_back(colour); }
        std::vector<Colour> paints;
    };
    Painted canvas;
    figure_of("axiom F'(1,0.5,0)F['(0,0,1)F]F'(2)F", 0)->draw(canvas, 0, {});
    CHECK(canvas.paints == std::vector<Colour>{{1, 0.5, 0}, {0, 0, 1}, {1, 0.5, 0}});
    CHECK(canvas.strokes.back().colour == 2);
}

TEST_CASE("what cannot be drawn in the plane says why") {
    CHECK(refusal("axiom A(1); A(x) -> F(x)&(30)A(x)") ==
          "the symbol & leaves the plane: x.lsys is a figure in space, expected one in the plane");
    CHECK(refusal("axiom A(1); interpret A(x) -> F(x)/(30)") ==
          "the symbol / leaves the plane: x.lsys is a figure in space, expected one in the plane");
    CHECK(refusal("axiom A; A -> div(X, 1r){ A }").find("shape rules") != std::string::npos);
    CHECK(refusal("axiom F?E(0)").find("communication modules") != std::string::npos);
}
