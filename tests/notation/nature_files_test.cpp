#include <doctest/doctest.h>

#include <chrono>
#include <string>

#include "exact/exact.hpp"
#include "nature/nature.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

/// The message with which a file is refused.
std::string refused(const std::string& text, const std::string& name) {
    try {
        read_generator(text, name);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("files of walks, paths, landscapes and clusters say their parameters") {
    const auto land =
        read_generator("title Hills\nlevels 3..5\nroughness 0.9\nview map coast\n", "a.terrain");
    const auto& terrain = dynamic_cast<const Terrain&>(*land);
    CHECK(terrain.title == "Hills");
    CHECK(terrain.surface.hurst == 0.9);
    CHECK(terrain.levels == std::pair(3, 5));
    CHECK(terrain.views.size() == 2);
    CHECK(land->figures({}).size() == 6);
    const auto cluster = read_generator("particles 20 50\noff-lattice yes\nseed 4", "a.dla");
    CHECK(dynamic_cast<const Aggregates&>(*cluster).off_lattice);
    const auto figures = cluster->figures({});
    REQUIRE(figures.size() == 2);
    CHECK(figures[1].caption == "50 particles");
    CHECK(figures[1].figure->segments() == Integer(51));
    CHECK(read_generator("steps 5", "a.walk")->figures({})[0].figure->segments() == Integer(5));
    CHECK(read_generator("levels 4", "a.brownian")->figures({})[0].figure->segments() ==
          Integer(16));
    CHECK(read_generator("set segment\ncells 1 1/2 1/4", "a.boxes")->figures({})[2].caption ==
          "m = 1/4, N = 4");
    CHECK(read_generator("set square\ncells 1/3", "a.boxes")->figures({})[0].caption ==
          "m = 1/3, N = 9");
}

TEST_CASE("turned with its copies, 3 * 4^(n-1) squares of the side 3^-n cover Koch's curve") {
    const auto cover =
        read_generator("set koch\nsquares turned\ncells 1/3 1/9 1/27 1/81", "a.boxes");
    const auto figures = cover->figures({});
    CHECK(figures[0].caption == "m = 1/3, N = 3");
    CHECK(figures[1].caption == "m = 1/9, N = 12");
    CHECK(figures[2].caption == "m = 1/27, N = 48");
    CHECK(figures[3].caption == "m = 1/81, N = 192");
    for (const GeneratorFact& fact : cover->facts({}))
        if (fact.key == "slope") CHECK(fact.text == "1.261860");
}

TEST_CASE("a file of particles says kinds, and what is born") {
    const auto show = read_generator(
        "sky #0b1026\ngravity 0.1\nshow 3\n"
        "kind drop\nspeed 2 +- 1\nangle 90 +- 5\nlife 10\nbursts spark 5 +- 1\n"
        "kind spark\nsize 0.5\ntint #ffffff red\nborn drop 3 at (0,0) to (2,0) until 8 every 2\n",
        "a.particles");
    const auto& system = dynamic_cast<const ParticleShow&>(*show).system;
    REQUIRE(system.kinds.size() == 2);
    CHECK(system.kinds[0].speed == Scatter{2, 1});
    CHECK(system.kinds[0].bursts_into == 1);
    CHECK(system.kinds[1].dying == Colour{1, 0, 0});
    CHECK(system.force == Point{0, -0.1});
    REQUIRE(system.emitters.size() == 1);
    CHECK(system.emitters[0].to == Point{2, 0});
    CHECK(system.emitters[0].last == 8);
    CHECK(show->figures({}).size() == 1);
    CHECK(show->frames({}).size() == 4);
}

TEST_CASE("files of generators that make no sense are refused at their place") {
    CHECK(refused("hurst 1.2", "a.brownian") ==
          "a.brownian:1:7: error: expected hurst with a number between 0 and 1, found '1.2'\n"
          "  hurst 1.2\n"
          "        ^");
    CHECK(refused("levels 99", "a.terrain") ==
          "a.terrain:1:8: error: expected levels with a whole number from 0 to 13, found '99'\n"
          "  levels 99\n"
          "         ^");
    CHECK(refused("particles -3", "a.dla") ==
          "a.dla:1:11: error: expected particles with a whole number from 1 to 100000000, found "
          "'-3'\n"
          "  particles -3\n"
          "            ^");
    CHECK(refused("off-lattice yes\nregion 5", "a.dla") ==
          "a.dla:2:1: error: clusters off the lattice have no region\n"
          "  region 5\n"
          "  ^");
    CHECK(refused("view mpa", "a.terrain") ==
          "a.terrain:1:6: error: expected view map, contours, solid, coast or grid, found 'mpa'; "
          "did you mean 'map'?\n"
          "  view mpa\n"
          "       ^");
    CHECK(refused("kind a\nborn b 3 at (0,0)", "a.particles") ==
          "a.particles:2:6: error: no kind 'b'; expected one that a line `kind NAME` begins\n"
          "  born b 3 at (0,0)\n"
          "       ^");
    CHECK(
        refused("kind a\n", "a.particles") ==
        "a.particles: expected a line `born KIND COUNT at (x,y)`, found no particle that is born");
    CHECK(
        refused("a 0.2\nb 3", "a.function") ==
        "a b: expected at least 1, below which the function has a derivative, found 0.2 * 3 = 0.6");
    CHECK(
        refused("sigma 0", "a.brownian")
            .starts_with("a.brownian:1:7: error: expected sigma with a number above 0, found '0'"));
}

TEST_CASE("a file is read without the particles and the grid that it asks for") {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < 50; ++i) {
        const auto flame = read_generator(
            "kind flame\nborn flame 6018446744073709551615 at (0,0)\n", "x.particles");
        Budget budget;
        budget.memory = 1 << 20;
        CHECK_THROWS_WITH_AS(flame->figures(budget), doctest::Contains("a particle system"),
                             BoundReached);
        read_generator("region 16383\n", "x.dla");
    }
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(5));
}
