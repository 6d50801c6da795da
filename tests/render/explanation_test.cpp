#include <doctest/doctest.h>

#include <sstream>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "render/detail/layout.hpp"
#include "render/pixels.hpp"
#include "render/render.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

Explanation explained(const std::string& text, std::uint64_t n = 0) {
    const Model system = read_lsystem(text, "small.lsys");
    const DerivedModules derived = derived_modules(system, n, {});
    return explanation(system, derived.kinds, derived.word, n, derived.seed);
}

std::string page(const std::string& text, PictureFormat format,
                 const PictureOptions& options = {}) {
    std::ostringstream out;
    draw_explanation(explained(text), "A small word", out, format, options);
    return out.str();
}

}  // namespace

TEST_CASE("the table of an explanation says place and heading after each step") {
    using Row = std::vector<std::string>;
    const auto rows = explanation_rows(explained("axiom F+F; angle 60"));
    CHECK(rows == std::vector<Row>{
                      {"step", "symbol", "what the turtle does", "then it is at", "heading"},
                      {"", "", "the start", "(0, 0)", "0°"},
                      {"1", "F", "forward 1, drawing", "(1, 0)", "0°"},
                      {"2", "+", "turn left by 60°", "(1, 0)", "60°"},
                      {"3", "F", "forward 1, drawing", "(1.5, 0.866)", "60°"},
                  });
    const auto branched = explanation_rows(explained("axiom [F]"));
    CHECK(branched[0].back() == "open [");
    CHECK(branched[2] == Row{"1", "[", "remember position and heading", "(0, 0)", "0°", "1"});
    CHECK(branched[4] == Row{"3", "]", "go back to where step 1 was", "(0, 0)", "0°", ""});
    const auto in_space = explanation_rows(explained("axiom ^F"));
    CHECK(in_space[3] == Row{"2", "F", "forward 1, drawing", "(0, 0, 1)", "(0, 0, 1)"});
}

TEST_CASE("a page of explanation is the same bytes each time, in every format") {
    for (const PictureFormat format : {PictureFormat::svg, PictureFormat::pdf, PictureFormat::png,
                                       PictureFormat::ps, PictureFormat::eps}) {
        const std::string first = page("axiom F[+F]{F+F+F}f", format);
        CHECK(first.size() > 1000);
        CHECK(page("axiom F[+F]{F+F+F}f", format) == first);
    }
}

TEST_CASE("a page of explanation has the width or height that is asked for") {
    PictureOptions options;
    options.width = 800;
    CHECK(algae::test::Pixels(page("axiom F+F", PictureFormat::png, options)).width == 800);
    options.height = 100;
    const algae::test::Pixels both(page("axiom F+F", PictureFormat::png, options));
    CHECK(both.height <= 100);
    CHECK(both.width <= 800);
    CHECK(page("axiom X", PictureFormat::png).size() > 1000);
    options.width = 1e9;
    options.height.reset();
    CHECK_THROWS_AS(page("axiom F+F", PictureFormat::png, options), Error);
}

TEST_CASE("words too long for a page and turtles in space are refused") {
    CHECK_THROWS_WITH_AS(page("axiom " + std::string(61, 'F'), PictureFormat::svg),
                         "generation 0 of small.lsys has 61 symbols: a page explains at most 60",
                         Error);
    CHECK_THROWS_WITH_AS(page("axiom F^F", PictureFormat::svg),
                         "generation 0 of small.lsys: the symbol ^ leaves the plane: a page "
                         "explains a turtle in the plane",
                         Error);
}

TEST_CASE("labels go where nothing is in the way") {
    LabelPlaces places({0, 0}, {100, 100});
    places.avoid({0, 50}, {100, 50});
    const std::vector<Point> middles{{50, 50}, {50, 30}, {50, 70}, {200, 20}};
    CHECK(places.place(middles, 20, 10).middle == Point{50, 30});
    CHECK(places.place(middles, 20, 10).middle == Point{50, 70});  // the other is taken
    places.avoid({20, 20}, 8.0);
    CHECK(places.place({{20, 20}, {80, 20}}, 20, 10).middle == Point{80, 20});
}
