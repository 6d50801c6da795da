#include "turtle/turtle.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/any_turtle.hpp"
#include "turtle/recording.hpp"

using namespace algae;

namespace {

Explanation explained(const Model& system, std::uint64_t n = 0) {
    const DerivedModules derived = derived_modules(system, n, {});
    return explanation(system, derived.kinds, derived.word, n, derived.seed);
}

Explanation explained(const std::string& text, std::uint64_t n = 0) {
    return explained(read_lsystem(text, "small.lsys"), n);
}

std::vector<std::string> meanings(const std::string& text) {
    std::vector<std::string> found;
    for (const ExplainedStep& step : explained(text).steps) found.push_back(step.meaning);
    return found;
}

using Meanings = std::vector<std::string>;

/// The commands that lead from the start of a word to its end: branches that are closed lead
/// nowhere.
std::string way_to_end(const std::string& word) {
    std::string way;
    std::vector<std::size_t> open;
    for (const char c : word) {
        if (c == '[') {
            open.push_back(way.size());
        } else if (c == ']') {
            way.resize(open.back());
            open.pop_back();
        } else {
            way += c;
        }
    }
    return way;
}

rc::Gen<std::string> any_word() {
    return rc::gen::map(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 9)),
                        [](const std::vector<int>& picks) {
                            std::string word;
                            int open = 0;
                            for (const int pick : picks) {
                                const char c = "FFf+-|X[]"[pick];
                                if (c == ']' && open == 0) continue;
                                open += c == '[' ? 1 : c == ']' ? -1 : 0;
                                word += c;
                            }
                            return word + std::string(static_cast<std::size_t>(open), ']');
                        });
}

}  // namespace

TEST_CASE("the turtle after each step is where a slower one is after that part of the word") {
    CHECK(rc::check([] {
        const std::string word = *any_word();
        oracle::TurtleSettings settings = *any_turtle();
        settings.spin = settings.shrink = {1, 1};
        Model system = read_lsystem("axiom " + (word.empty() ? "X" : word), "");
        system.drawing = oracle::settings_of(settings);
        const Explanation found = explained(system);
        if (word.empty()) return;
        RC_ASSERT(found.steps.size() == word.size());
        RC_ASSERT(found.word == word);
        std::vector<oracle::Stroke> strokes;
        for (std::size_t i = 0; i < word.size(); ++i) {
            const TurtleState& state = found.steps[i].after;
            const std::string way = way_to_end(word.substr(0, i + 1));
            const oracle::Spot at = oracle::drawing_of(way, settings, 0).end;
            const oracle::Spot next = oracle::drawing_of(way + "F", settings, 0).end;
            RC_ASSERT(near(at, {state.position.x, state.position.y}));
            const Vector& heading = state.attitude.heading();
            const oracle::Spot ahead = (next - at) / settings.step.value();
            RC_ASSERT(near(ahead, {heading.x, heading.y}));
            const double angle = heading_angle(state).value() * (std::acos(-1.0) / 180);
            RC_ASSERT(near(ahead, {std::cos(angle), std::sin(angle)}));
            for (const ExplainedLine& line : found.steps[i].lines)
                if (line.drawn)
                    strokes.push_back({{line.from.x, line.from.y}, {line.to.x, line.to.y}, 1, 0});
        }
        const std::vector<oracle::Stroke> expected = oracle::drawing_of(word, settings, 0).strokes;
        RC_ASSERT(strokes.size() == expected.size());
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            RC_ASSERT(near(strokes[i].from, expected[i].from));
            RC_ASSERT(near(strokes[i].to, expected[i].to));
        }
    }));
}

TEST_CASE("steps are told in words") {
    CHECK(meanings("axiom F+f-|; angle 60; step 2") ==
          Meanings{"forward 2, drawing", "turn left by 60°", "forward 2, pen up",
                   "turn right by 60°", "turn back"});
    CHECK(meanings("axiom +-; angle 60; turn clockwise") ==
          Meanings{"turn right by 60°", "turn left by 60°"});
    CHECK(meanings("axiom +(270)-(190)F(-3)+(180)-(180)") ==
          Meanings{"turn left by 270°", "turn right by 190°", "back 3, drawing",
                   "turn left by 180°", "turn right by 180°"});
    CHECK(meanings("axiom F[+F]X") ==
          Meanings{"forward 1, drawing", "remember position and heading", "turn left by 90°",
                   "forward 1, drawing", "go back to where step 2 was", "nothing"});
    CHECK(meanings("axiom F%F[F]") ==
          Meanings{"forward 1, drawing", "leave out the rest of the branch",
                   "left out: the branch was cut", "left out: the branch was cut",
                   "left out: the branch was cut", "left out: the branch was cut"});
    CHECK(meanings("axiom [F%F]F").back() == "forward 1, drawing");
    CHECK(meanings("axiom {F+F.}") == Meanings{"begin a polygon, its first corner here",
                                               "forward 1, drawing", "turn left by 90°",
                                               "forward 1, drawing", "a corner of the polygon here",
                                               "fill the polygon of 4 corners"});
    CHECK(meanings("axiom !(2)'*F; colour red green; scale 0.5") ==
          Meanings{"lines 2 wide", "colour 1, green", "steps are now 0.5 long",
                   "forward 0.5, drawing"});
    CHECK(
        meanings("axiom L-; interpret L -> F+F; angle 45") ==
        Meanings{"forward 1, drawing; turn left by 45°; forward 1, drawing", "turn right by 45°"});
    CHECK(meanings("axiom S; stamp S square") == Meanings{"leave a square of side 2"});
}

TEST_CASE("a turtle in space is explained too") {
    CHECK(meanings("axiom &F^\\/; angle 30") == Meanings{"pitch down by 30°", "forward 1, drawing",
                                                         "pitch up by 30°", "roll left by 30°",
                                                         "roll right by 30°"});
    const Explanation found = explained("axiom ^(90)F");
    CHECK_FALSE(heading_angle(found.steps.back().after));
    CHECK(found.steps.back().after.position == Vector{0, 0, 1});
}

TEST_CASE("numbers for people have no more than four decimals") {
    CHECK(rounded(1.0 / 3) == "0.3333");
    CHECK(rounded(-0.5) == "-0.5");
    CHECK(rounded(-0.00001) == "0");
    CHECK(rounded(100) == "100");
    CHECK(rounded(1e20) == "1e+20");
}

TEST_CASE("an explanation keeps what the turtle refuses") {
    CHECK_THROWS_WITH_AS(explained("axiom F]"), doctest::Contains("unmatched ']'"), Error);
}
