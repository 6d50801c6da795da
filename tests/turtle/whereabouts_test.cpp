#include "turtle/detail/environments.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

using namespace algae;

namespace {

std::vector<double> answer(const std::string& kind, std::size_t parameters, const Query& from,
                           const std::vector<double>& numbers = {}) {
    EnvironmentSetting setting{0, kind, {}};
    for (const double number : numbers) {
        setting.numbers.emplace_back();
        setting.numbers.back().value = number;
    }
    Query query = from;
    query.parameters.assign(parameters, 0);
    const Query* const queries[] = {&query};
    return Whereabouts(setting).answers({}, queries, {}).at(0);
}

Query at(Vector place, double yaw = 0, double pitch = 0) {
    Query query{"?E", 0, {}, place, {}};
    query.attitude.yaw(turn_by(yaw));
    query.attitude.pitch(turn_by(pitch));
    return query;
}

using Numbers = std::vector<double>;

}  // namespace

TEST_CASE("coordinates and positions") {
    const Query query = at({1, -2.5, 3});
    CHECK(answer("x", 1, query) == Numbers{1});
    CHECK(answer("y", 1, query) == Numbers{-2.5});
    CHECK(answer("z", 1, query) == Numbers{3});
    CHECK(answer("position", 1, query) == Numbers{1});
    CHECK(answer("position", 2, query) == Numbers{1, -2.5});
    CHECK(answer("position", 3, query) == Numbers{1, -2.5, 3});
}

TEST_CASE("headings are degrees from 0 to below 360, or vectors") {
    CHECK(answer("heading", 1, at({})) == Numbers{0});
    CHECK(answer("heading", 1, at({}, 90)) == Numbers{90});
    CHECK(answer("heading", 1, at({}, -90)) == Numbers{270});
    CHECK(answer("heading", 1, at({}, 180)) == Numbers{180});
    CHECK(answer("heading", 1, at({}, 45)) == Numbers{45});
    CHECK(answer("heading", 1, at({}, 30, -90)) == Numbers{0});
    CHECK(answer("heading", 1, at({}, -1e-20)) == Numbers{0});
    CHECK(answer("heading", 3, at({}, 90)) == Numbers{0, 1, 0});
    CHECK(answer("heading", 3, at({}, 90, -90)) == Numbers{0, 0, 1});
    CHECK(rc::check([](int degrees) {
        const double found = answer("heading", 1, at({}, degrees)).at(0);
        const double expected = std::remainder(found - degrees, 360.0);
        RC_ASSERT(found >= 0 && found < 360);
        RC_ASSERT(std::abs(expected) < 1e-9);
    }));
}

TEST_CASE(
    "a box has its border, and its inside is where walking along the axes leads out of it on both "
    "sides") {
    CHECK(rc::check([] {
        const auto number = [] { return static_cast<double>(*rc::gen::inRange(-4, 5)); };
        const auto dimension = *rc::gen::element<std::size_t>(2, 3);
        Numbers low, high, corners, place;
        for (std::size_t i = 0; i < dimension; ++i) {
            low.push_back(number());
            high.push_back(low[i] + std::abs(number()));
        }
        corners = low;
        corners.insert(corners.end(), high.begin(), high.end());
        const Vector here{number(), number(), number()};
        const Numbers all{here.x, here.y, here.z};
        bool inside = true;
        for (std::size_t i = 0; i < dimension; ++i) {
            int steps = 0;  // whole numbers from the low corner to the high one that the place is
            for (double k = low[i]; k <= high[i]; ++k) steps += k == all[i];
            inside = inside && steps == 1;
        }
        RC_ASSERT(answer("clip", 1, at(here), corners) == Numbers{inside ? 1.0 : 0.0});
    }));
}
