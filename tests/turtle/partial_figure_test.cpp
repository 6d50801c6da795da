#include "turtle/turtle.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/any_turtle.hpp"
#include "turtle/recording.hpp"

using namespace algae;

namespace {

/// A part of a word, its open branches closed.
std::string closed(std::string word) {
    const auto open = std::count(word.begin(), word.end(), '[');
    const auto shut = std::count(word.begin(), word.end(), ']');
    return word + std::string(static_cast<std::size_t>(open - shut), ']');
}

}  // namespace

TEST_CASE("frames begin with none and end with all symbols") {
    CHECK(frames_of_progress(1, 2) == std::vector<std::size_t>{0, 1});
    CHECK(frames_of_progress(100, 2) == std::vector<std::size_t>{0, 100});
    for (std::size_t symbols = 1; symbols < 60; ++symbols)
        for (std::size_t most = 2; most < 70; ++most) {
            const auto frames = frames_of_progress(symbols, most);
            CHECK(frames.size() <= most);
            CHECK(frames.size() >= std::min(most / 2, symbols));
            CHECK(frames.front() == 0);
            CHECK(frames.back() == symbols);
            CHECK(std::is_sorted(frames.begin(), frames.end()));
        }
}

TEST_CASE("a partial figure has the strokes of that part of the word, and the turtle at its end") {
    for (const char* angle : {"60", "25.7", "30; plot P"}) {  // folded, walked, and by modules
        const std::string word = "F+F[-Ff[+F]F]X{F+F}+[F]F";
        const Model system = read_lsystem("axiom " + word + "; angle " + angle, "");
        oracle::TurtleSettings settings;
        settings.angle = angle[0] == '2'   ? oracle::Fraction{257, 10}
                         : angle[0] == '3' ? oracle::Fraction{30, 1}
                                           : oracle::Fraction{60, 1};
        const DerivedModules derived = derived_modules(system, 0, {});
        std::vector<std::size_t> symbols;
        for (std::size_t i = 0; i <= word.size(); ++i) symbols.push_back(i);
        const auto figures = partial_figures(system, derived, 0, symbols, {});
        REQUIRE(figures.size() == word.size() + 1);
        for (std::size_t i = 0; i <= word.size(); ++i) {
            Recording found;
            figures[i]->draw(found, 0, {});
            CHECK(figures[i]->box() == figures[0]->box());
            std::string part = word.substr(0, i);
            if (std::count(part.begin(), part.end(), '{') >
                std::count(part.begin(), part.end(), '}'))
                part = word.substr(0, word.find('{')) + part.substr(word.find('{') + 1);
            const oracle::Drawing expected = oracle::drawing_of(closed(part), settings, 0);
            REQUIRE(found.strokes.size() == expected.strokes.size());
            for (std::size_t at = 0; at < found.strokes.size(); ++at) {
                CHECK(near(found.strokes[at].from, expected.strokes[at].from));
                CHECK(near(found.strokes[at].to, expected.strokes[at].to));
            }
            REQUIRE(found.polygons.size() == expected.polygons.size() + 2);
            for (const oracle::Spot& corner : found.polygons.back()) {
                CHECK(corner.real() >= figures[0]->box().low.x);
                CHECK(corner.real() <= figures[0]->box().high.x);
                CHECK(corner.imag() >= figures[0]->box().low.y);
                CHECK(corner.imag() <= figures[0]->box().high.y);
            }
        }
        // The turtle after all symbols is where the word ends.
        Recording found;
        figures.back()->draw(found, 0, {});
        const std::vector<oracle::Spot>& glyph = found.polygons.back();
        const oracle::Spot end = oracle::drawing_of(word, settings, 0).end;
        const oracle::Spot middle = (glyph[0] + (glyph[1] + glyph[3]) * 0.5L) * 0.5L;
        CHECK(near(middle, end));
    }
}
