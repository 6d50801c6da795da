// The trees of Honda and of Aono and Kunii against trees.txt, which trees.py worked out.

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>

#include "model/model.hpp"
#include "places.hpp"
#include "turtle/of_gallery.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

bool near(double a, double b) { return std::fabs(a - b) < 1e-12 * (1 + std::fabs(a)); }

}  // namespace

TEST_CASE("trees have the segments, lengths and boxes of an independent computation") {
    std::ifstream numbers(source_folder() + "/tests/turtle/trees.txt");
    REQUIRE(numbers);
    std::map<std::string, Model> trees;
    int compared = 0;
    for (std::string line; std::getline(numbers, line);) {
        if (line.starts_with("#")) continue;
        std::istringstream fields(line);
        std::string name;
        std::uint64_t n = 0;
        std::size_t modules = 0, segments = 0;
        double total = 0, thinnest = 0;
        Vector low, high;
        fields >> name >> n >> modules >> segments >> total >> thinnest >> low.x >> low.y >>
            low.z >> high.x >> high.y >> high.z;
        REQUIRE(fields);
        if (!trees.count(name)) trees.emplace(name, of_gallery(name));
        const Model& tree = trees.at(name);
        CAPTURE(line);
        CHECK(derived_modules(tree, n, {}).word.kinds.size() == modules);
        const SpaceDerivation found = scene(tree, n, {});
        CHECK(found.facts.segments == segments);
        CHECK(found.scene.rods.size() == segments);
        CHECK(near(found.facts.length, total));
        double least = std::numeric_limits<double>::infinity();
        for (const Rod& rod : found.scene.rods) least = std::min(least, 2 * rod.radius);
        CHECK(near(least, thinnest));
        const SpaceBox& box = found.facts.box;
        for (const auto& [is, wanted] : {std::pair{box.low, low}, std::pair{box.high, high}})
            CHECK((near(is.x, wanted.x) && near(is.y, wanted.y) && near(is.z, wanted.z)));
        ++compared;
    }
    CHECK(compared == 40);
}
