#include "turtle/detail/module_turtle.hpp"
#include "turtle/turtle.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"

using namespace algae;

namespace {

/// All that a walk tells.
class Heard : public TurtleEvents {
public:
    explicit Heard(bool modules = false) : modules_(modules) {}
    void before(std::size_t module, const TurtleState& state) override {
        before_.push_back({module, state.position});
    }
    bool wants_modules() const override { return modules_; }
    void stroke(const Vector& from, const TurtleState& state) override {
        strokes.push_back({from, state.position});
        widths.push_back(state.width);
        colours.push_back(state.colour);
        total += length(state.position - from);
    }
    void move(const Vector&, const TurtleState&) override { ++moves; }
    void returned(const TurtleState&) override { ++returns; }
    void polygon(std::span<const Vector> corners) override {
        polygons.emplace_back(corners.begin(), corners.end());
    }

    std::vector<std::pair<Vector, Vector>> strokes;
    std::vector<std::pair<std::size_t, Vector>> before_;
    std::vector<StrokeWidth> widths;
    std::vector<std::uint32_t> colours;
    std::vector<std::vector<Vector>> polygons;
    int moves = 0, returns = 0;
    double total = 0;

private:
    bool modules_;
};

struct Walked {
    Heard heard;
    TurtleState end;
};

Walked walked(const std::string& text, std::uint64_t n = 0, std::uint64_t seed = 1) {
    const Model system = read_lsystem(text, "walk.lsys");
    const Rewriting rewriting(system);
    const ModuleString word = derive(rewriting, n);
    const ModuleTurtle turtle(system, rewriting.rules().kinds, n, seed);
    Walked out{Heard(true), {}};
    out.end = turtle.walk(word, out.heard);
    return out;
}

bool near(const Vector& a, const Vector& b) { return length(a - b) < 1e-12; }

std::string message(const std::string& text) {
    try {
        walked(text);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("the first parameter says how far and by how many degrees") {
    const Walked triangle = walked("axiom F(1)+(90)F(1)+(135)F(2^0.5)");
    CHECK(triangle.heard.strokes.size() == 3);
    CHECK(near(triangle.end.position, {0, 0, 0}));
    const Walked scaled = walked("axiom F(2,9)f(1)-F; step 3; shrink 1/2; start 1 2 90; angle 90");
    CHECK(scaled.end.position == Vector{4, 11, 0});
    CHECK(scaled.heard.moves == 1);
    CHECK(walked("axiom F(-2)").end.position == Vector{-2, 0, 0});
    CHECK(near(walked("axiom +(30)F; turn clockwise").end.position, {std::sqrt(3) / 2, -0.5, 0}));
    CHECK(walked("axiom +&F; angle 90; turn clockwise").end.position == Vector{0, 0, -1});
}

TEST_CASE("widths, colours and steps are set by parameters and come back behind a branch") {
    const Walked walk = walked("axiom F!(0.5)F[!'(3)*(2)F]'F!F; narrow 0.5; colour red green");
    const auto& widths = walk.heard.widths;
    REQUIRE(widths.size() == 5);
    CHECK(widths[0] == StrokeWidth{1, false});
    CHECK(widths[1] == StrokeWidth{0.5, true});
    CHECK(widths[2] == StrokeWidth{0.25, true});
    CHECK(widths[3] == StrokeWidth{0.5, true});
    CHECK(widths[4] == StrokeWidth{0.25, true});
    CHECK(walk.heard.colours == std::vector<std::uint32_t>{0, 0, 3, 1, 1});
    CHECK(walk.heard.strokes[2].second == Vector{4, 0, 0});
    CHECK(walk.end.position == Vector{4, 0, 0});
}

TEST_CASE("each module is announced with the turtle as it gets there") {
    const Walked walk = walked("axiom A[F]F(2)B; interpret A -> FF");
    const auto& before = walk.heard.before_;
    REQUIRE(before.size() == 6);
    const std::array<double, 6> at{0, 2, 2, 3, 2, 4};
    for (std::size_t i = 0; i < at.size(); ++i) {
        CHECK(before[i].first == i);
        CHECK(before[i].second == Vector{at[i], 0, 0});
    }
    CHECK(walk.heard.returns == 1);
}

TEST_CASE("polygons take their corners where the turtle stands") {
    const Walked walk = walked("axiom {F(2)+(90)f(1)+(90)G(1).}[{+(90)F(3)F}]{F}");
    REQUIRE(walk.heard.polygons.size() == 2);
    CHECK(walk.heard.polygons[0].size() == 4);
    CHECK(walk.heard.polygons[0].back() == Vector{1, 1, 0});
    CHECK(walk.heard.polygons[1].back() == Vector{1, -3, 0});
}

TEST_CASE("interpretations have parameters, conditions and probabilities") {
    CHECK(walked("axiom A(3); interpret A(n) : n > 0 -> F(n)A(n-1)").end.position ==
          Vector{6, 0, 0});
    // Where no condition holds, the module means what it means.
    CHECK(walked("axiom F(3)F(-1); interpret F(n) : n > 0 -> F(-n)").end.position ==
          Vector{-4, 0, 0});
    const std::string text =
        "axiom AAAAAAAAAAAAAAAAAAAA; interpret A -(1/2)-> F; interpret A -(1/2)-> f";
    std::set<int> counts;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Walked walk = walked(text, 0, seed);
        CHECK(walk.end.position == Vector{20, 0, 0});
        CHECK(walked(text, 0, seed).heard.strokes == walk.heard.strokes);
        counts.insert(walk.heard.moves);
    }
    CHECK(counts.size() > 3);
}

TEST_CASE("the turtle in space") {
    CHECK(walked("axiom &F^F; angle 90").end.position == Vector{1, 0, -1});
    CHECK(walked("axiom ^F; angle 90").end.position == Vector{0, 0, 1});
    CHECK(walked("axiom \\+F; angle 90").end.position == Vector{0, 0, -1});
    CHECK(walked("axiom /+F; angle 90").end.position == Vector{0, 0, 1});
    // The matrices of the other convention give a distance of 1.
    CHECK(length(walked("axiom FF+\\&F; angle 90").end.position) == doctest::Approx(3));
    const Walked level = walked("axiom ^(40)/(70)@+(90)F");
    CHECK(std::fabs(level.end.position.z) < 1e-15);
    CHECK(near(level.end.position, {0, 1, 0}));
}

TEST_CASE("Hilbert's curve in space visits every point of its cube once") {
    for (std::uint64_t n = 1; n <= 3; ++n) {
        const Model system = read_lsystem(
            "axiom A; angle 90\n"
            "A -> B-F+CFC+F-D&F^D-F+&&CFC+F+B//\n"
            "B -> A&F^CFB^F^D^^-F-D^|F^B|FC^F^A//\n"
            "C -> |D^|F^B-F+C^F^A&&FA&F^C+F+B^F^D//\n"
            "D -> |CFB-F+B|FA&F^A&&FB-F+B|FC//\n",
            "hilbert");
        const Rewriting rewriting(system);
        const ModuleTurtle turtle(system, rewriting.rules().kinds, n);
        Heard heard;
        const ModuleString word = derive(rewriting, n);
        turtle.walk(word, heard);
        std::set<std::array<double, 3>> points{{0, 0, 0}};
        std::array<double, 3> low{}, high{};
        for (const auto& [from, to] : heard.strokes) {
            const std::array<double, 3> at{to.x, to.y, to.z};
            for (std::size_t i = 0; i < 3; ++i) {
                CHECK(at[i] == std::round(at[i]));
                low[i] = std::min(low[i], at[i]);
                high[i] = std::max(high[i], at[i]);
            }
            points.insert(at);
        }
        CHECK(points.size() == std::size_t{1} << 3 * n);
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(high[i] - low[i] == static_cast<double>((1 << n) - 1));
        CHECK(turtle.symbol_of_space(word));
    }
}

TEST_CASE("Honda's tree grows upward to the height it should have") {
    const Walked tree = walked(
        "axiom ^(90)A(1,0.04)\n"
        "let r1 = 0.9; let r2 = 0.8; let a0 = 45; let a2 = 45; let d = 137.5; let wr = 0.707\n"
        "A(l,w) -> !(w)F(l)[&(a0)B(r2*l,wr*w)]/(d)A(r1*l,wr*w)\n"
        "B(l,w) -> !(w)F(l)[-(a2)@C(r2*l,wr*w)]C(r1*l,wr*w)\n"
        "C(l,w) -> !(w)F(l)[+(a2)@B(r2*l,wr*w)]B(r1*l,wr*w)\n",
        8);
    CHECK(tree.heard.strokes.size() == 255);
    CHECK(std::fabs(tree.heard.total - 98.2251) < 5e-5);
    double height = 0, thinnest = 1, low = 0;
    for (const auto& [from, to] : tree.heard.strokes) {
        height = std::max(height, to.z);
        low = std::min(low, to.z);
    }
    for (const StrokeWidth& width : tree.heard.widths) {
        CHECK(width.is_length);
        thinnest = std::min(thinnest, width.amount);
    }
    CHECK(std::fabs(height - 5.6953) < 5e-5);
    CHECK(low == 0);
    CHECK(std::fabs(thinnest - 0.003532) < 5e-7);
}

TEST_CASE("errors of a walk name the place") {
    // The notation refuses such words; a derivation may make them.
    const auto without = [](std::ptrdiff_t module) -> std::string {
        const Model system = read_lsystem("axiom F(1)[]", "walk.lsys");
        const Rewriting rewriting(system);
        ModuleString word = rewriting.axiom();
        word.kinds.erase(word.kinds.begin() + module);
        Heard heard;
        try {
            ModuleTurtle(system, rewriting.rules().kinds, 3).walk(word, heard);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    CHECK(without(1) == "generation 3 of walk.lsys, position 1: unmatched ']'");
    CHECK(without(2) == "generation 3 of walk.lsys: '[' is never closed");
    CHECK(message("axiom F(1)}") == "generation 0 of walk.lsys, position 1: unmatched '}'");
    CHECK(message("axiom {F(1)") == "generation 0 of walk.lsys: '{' is never closed");
    CHECK(message("axiom FA(2); interpret A(x) -> !(-x)") ==
          "generation 0 of walk.lsys, position 1, in the interpretation of A(2): !(-2): expected a "
          "width of at least 0");
    CHECK(message("axiom F(1e308)F(1e308)") ==
          "generation 0 of walk.lsys, position 1: F(1e308): leads to a place that is not finite");
    CHECK(message("axiom !(-1)") ==
          "generation 0 of walk.lsys, position 0: !(-1): expected a width of at least 0");
    CHECK(message("axiom '(0.5)") ==
          "generation 0 of walk.lsys, position 0: '(0.5): expected the number of a colour, counted "
          "from 0");
    CHECK(message("axiom ^(90)@F") ==
          "generation 0 of walk.lsys, position 1: @: the heading is vertical, so that there is no "
          "level direction to roll to");
    CHECK(message("axiom A; interpret A -> A").find("without an end") != std::string::npos);
    CHECK(message("axiom A(0); interpret A(x) -> F(1/x)").find("division by 0") !=
          std::string::npos);
    CHECK(message("axiom A; B -> A; interpret A < B -> F").find("has a context") !=
          std::string::npos);
}
