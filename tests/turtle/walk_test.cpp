// Walks in space against the slow route of slow_walk.hpp.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/slow_walk.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

using slow_walk::Module;
using slow_walk::Place;

int below(int bound) { return *rc::gen::inRange(0, bound); }

Module any_module(char symbol) {
    Module out{symbol, {}};
    const auto degrees = [] { return *rc::gen::inRange(-360, 361) + 0.25 * below(4); };
    const auto size = [] { return 0.25 * (1 + below(12)); };
    if (symbol == 'B')
        for (int i = below(4); i > 0; --i) out.values.push_back(size());
    else if (symbol == 'E')
        for (int i = 1 + below(2); i > 0; --i) out.values.push_back(0.25 * below(9) - 0.75);
    else if (symbol == 'R')
        out.values = {degrees(), degrees(), degrees()};
    else if (symbol == 'T')
        out.values = {size() - 1, size() - 2, size()};
    else if (symbol == 'F' || symbol == 'f' || symbol == '!')
        out.values = {size()};
    else if (symbol != '[' && symbol != ']')
        out.values = {degrees()};
    return out;
}

std::vector<Module> any_word() {
    const std::string symbols = "FFFFf!+-&^\\/RTBE[[]]";
    std::vector<Module> out;
    int open = 0;
    for (int i = below(40); i > 0; --i) {
        const char symbol =
            symbols[static_cast<std::size_t>(below(static_cast<int>(symbols.size())))];
        if (symbol == ']' && open == 0) continue;
        open += symbol == '[' ? 1 : symbol == ']' ? -1 : 0;
        out.push_back(any_module(symbol));
    }
    for (; open > 0; --open) out.push_back({']', {}});
    return out;
}

bool near(const Vector& found, const Place& wanted) {
    return std::fabs(static_cast<long double>(found.x) - wanted[0]) < 1e-10L &&
           std::fabs(static_cast<long double>(found.y) - wanted[1]) < 1e-10L &&
           std::fabs(static_cast<long double>(found.z) - wanted[2]) < 1e-10L;
}

Place column(const slow_walk::Matrix& frame, std::size_t j) {
    return {frame[0][j], frame[1][j], frame[2][j]};
}

}  // namespace

TEST_CASE("any walk in space is that of matrices and recursion") {
    const bool holds = rc::check("space walks", [] {
        const std::vector<Module> word = any_word();
        slow_walk::Walk truth;
        const bool bends = below(2) == 1;
        std::string settings =
            "\nsolid B box height width depth\nsolid R rotation x y z\n"
            "solid T _typeTranslation _x _y _z\nelasticity E\n";
        if (bends) {
            truth.tropism = {0.5L, -1.0L, 0.25L * below(3)};
            truth.susceptibility = 0.125L * below(9);
            truth.before = below(2) == 1;
            settings += "tropism 0.5 -1 " + std::to_string(static_cast<double>(truth.tropism[2])) +
                        (truth.before ? " before" : "") + "\nsusceptibility " +
                        std::to_string(static_cast<double>(truth.susceptibility)) + '\n';
        }
        truth.all(word);
        const Model system = read_lsystem(
            "axiom " + (word.empty() ? std::string("ε") : slow_walk::text(word)) + settings, "");
        const SpaceDerivation found = scene(system, 0, {});
        RC_ASSERT(found.scene.rods.size() == truth.strokes.size());
        for (std::size_t i = 0; i < truth.strokes.size(); ++i) {
            const Rod& rod = found.scene.rods[i];
            const slow_walk::Stroke& stroke = truth.strokes[i];
            RC_ASSERT(near(rod.from, stroke.from) && near(rod.to, stroke.to));
            RC_ASSERT(rod.radius == std::max(0.0, static_cast<double>(stroke.diameter / 2)));
            RC_ASSERT(rod.before == (stroke.before ? *stroke.before : Rod::none));
            RC_ASSERT(rod.branch == slow_walk::is_branch(truth.strokes, i));
        }
        RC_ASSERT(near(found.end.position, truth.end));
        RC_ASSERT(found.scene.solids.size() == truth.solids.size());
        for (std::size_t i = 0; i < truth.solids.size(); ++i) {
            const Solid& solid = found.scene.solids[i];
            const slow_walk::Solid& wanted = truth.solids[i];
            RC_ASSERT(near(solid.middle, wanted.middle));
            RC_ASSERT(near(solid.attitude.heading(), column(wanted.frame, 0)));
            RC_ASSERT(near(solid.attitude.left(), column(wanted.frame, 1)));
            RC_ASSERT(near(solid.attitude.up(), column(wanted.frame, 2)));
            const auto measure = [&](std::size_t at) {
                return at < wanted.values.size() ? wanted.values[at] : 1;
            };
            RC_ASSERT(solid.size == (Vector{measure(1), measure(0), measure(2)}));
        }
    });
    CHECK(holds);
}

TEST_CASE("boxes of solids are the smallest that hold many points of them") {
    const bool holds = rc::check("boxes of solids", [] {
        Solid solid;
        solid.shape = static_cast<SolidShape>(below(4));
        solid.middle = {0.5 * below(9), -0.5 * below(9), 0.25};
        solid.size = {0.25 * (1 + below(8)), 0.25 * (1 + below(8)), 0.25 * (1 + below(8))};
        solid.attitude.yaw(turn_by(below(360)));
        solid.attitude.pitch(turn_by(below(360)));
        solid.attitude.roll(turn_by(below(360)));
        // The farthest points of a convex solid in a direction are on its rims and corners.
        SpaceBox around;
        const auto add = [&](double ahead, double left, double up) {
            around.add(solid.middle + ahead * solid.attitude.heading() +
                       left * solid.attitude.left() + up * solid.attitude.up());
        };
        const double x = solid.size.x / 2, y = solid.size.y, z = solid.size.z / 2;
        constexpr int steps = 720;
        for (int i = 0; i < steps; ++i) {
            const Turn turn = turn_by(360.0 * i / steps);
            if (solid.shape == SolidShape::cylinder) add(x, y * turn.cosine, y * turn.sine);
            if (solid.shape == SolidShape::cylinder || solid.shape == SolidShape::cone)
                add(-x, y * turn.cosine, y * turn.sine);
        }
        if (solid.shape == SolidShape::cone) add(x, 0, 0);
        if (solid.shape == SolidShape::box)
            for (int corner = 0; corner < 8; ++corner)
                add(corner & 1 ? x : -x, corner & 2 ? y / 2 : -y / 2, corner & 4 ? z : -z);
        if (solid.shape == SolidShape::sphere) {
            const double r = solid.size.x;
            around.add(solid.middle + Vector{r, r, r});
            around.add(solid.middle - Vector{r, r, r});
        }
        const SpaceBox found = box_of(solid);
        RC_ASSERT(length(found.low - around.low) < 1e-4 * y + 1e-12);
        RC_ASSERT(length(found.high - around.high) < 1e-4 * y + 1e-12);
    });
    CHECK(holds);
}

TEST_CASE("a million turns and bends leave the vectors orthonormal") {
    Attitude attitude;
    std::uint64_t number = 1;
    for (int i = 0; i < 1'000'000; ++i) {
        number = number * 6364136223846793005u + 1442695040888963407u;
        const Turn turn = turn_by(static_cast<double>(number >> 40) / 1000);
        switch (number >> 33 & 3) {
            case 0:
                attitude.yaw(turn);
                break;
            case 1:
                attitude.pitch(turn);
                break;
            case 2:
                attitude.roll(turn);
                break;
            default:
                attitude.bend({0.5, -1, static_cast<double>(number >> 62)}, 0.3);
        }
    }
    CHECK(std::fabs(dot(attitude.heading(), attitude.left())) < 1e-12);
    CHECK(std::fabs(dot(attitude.left(), attitude.up())) < 1e-12);
    CHECK(std::fabs(length(attitude.heading()) - 1) < 1e-12);
    CHECK(length(cross(attitude.heading(), attitude.left()) - attitude.up()) < 1e-12);
}
