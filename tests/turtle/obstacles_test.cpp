#include <doctest/doctest.h>

#include <chrono>
#include <cmath>

#include "exact/exact.hpp"
#include "turtle/detail/environments.hpp"
#include "turtle/random_scene.hpp"

using namespace algae;

namespace {

std::vector<double> first_answers(Environment& environment, const Traversal& course) {
    std::vector<const Query*> queries;
    for (const Query& query : course.queries) queries.push_back(&query);
    std::vector<double> out;
    for (const auto& answer : environment.answers(course, queries, {})) out.push_back(answer.at(0));
    return out;
}

}  // namespace

TEST_CASE("collisions are those that looking at all lines finds") {
    CHECK(rc::check([] {
        const RandomScene random = random_scene();
        const int radius = *rc::gen::inRange(1, 999);  // hundredths; 100 and such are on the border
        CollisionEnvironment collision(radius / 100.0);
        const auto found = first_answers(collision, random.course);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto [drawn, place] = random.asked[i];
            const auto others = oracle::others(random.lines, drawn, place);
            // Roundings may decide on the border.
            const bool inner = oracle::is_near(others, place, radius * 20 - 1, 2000);
            const bool outer = oracle::is_near(others, place, radius * 20 + 1, 2000);
            RC_ASSERT(found[i] == 0 || outer);
            RC_ASSERT(found[i] == 1 || !inner);
        }
    }));
}

TEST_CASE("light is what the widest free column lets through") {
    CHECK(rc::check([] {
        const RandomScene random = random_scene();
        const double radius = *rc::gen::inRange(1, 999) / 100.0;
        LightEnvironment light(radius);
        const auto found = first_answers(light, random.course);
        const std::size_t up = random.course.is_in_space() ? 2 : 1;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto [drawn, place] = random.asked[i];
            const double column =
                oracle::free_column(oracle::others(random.lines, drawn, place), place, up, radius);
            RC_ASSERT(std::abs(found[i] * radius - column) < 1e-6);
        }
    }));
}

TEST_CASE("what meets the turtle is in nobody's way") {
    Traversal course;
    const auto line = [&](Vector from, Vector to) {
        course.segments.push_back({from, to, 10 * course.segments.size()});
    };
    const auto ask = [&](std::size_t module, Vector place) {
        course.queries.push_back({"?E", module, {0}, place, {}});
    };
    line({0, 0, 0}, {0, 1, 0});   // 0: the way to the branching
    line({0, 1, 0}, {1, 2, 0});   // 10: two branches
    line({0, 1, 0}, {-1, 2, 0});  // 20
    line({-1, 2, 0}, {0, 0, 0});  // 30: back to the start
    ask(5, {0, 1, 0});            // before the branches
    ask(15, {0, 1, 0});           // between them
    ask(25, {0, 1, 0});           // after them
    ask(35, {0, 0, 0});           // at the start, again
    CollisionEnvironment near(0.1);
    CHECK(first_answers(near, course) == std::vector<double>{0, 0, 0, 1});
    LightEnvironment light(2);
    CHECK(first_answers(light, course) == std::vector<double>{0.25, 0.25, 0.25, 0});
    CollisionEnvironment wide(2);
    CHECK(first_answers(wide, course) == std::vector<double>{1, 1, 1, 1});
}

TEST_CASE("up is z as soon as the word leaves the plane") {
    Traversal course;
    course.segments.push_back({{-1, 1, 0}, {1, 1, 0}, 0});
    course.queries.push_back({"?E", 1, {0}, {0.5, 0, 0}, {}});
    LightEnvironment light(4);
    CHECK(first_answers(light, course) == std::vector<double>{0});
    course.segments.push_back({{2, 2, 0}, {2, 2, 1}, 0});
    CHECK(first_answers(light, course)[0] == doctest::Approx(std::sqrt(2.25 + 4) / 4));
}

TEST_CASE("the grid takes lines of any length and place") {
    Traversal course;
    for (const double far : {0.0, 1e3, 1e9, 1e18, 1e300, -1e300})
        course.segments.push_back({{far, 0, 0}, {far + 1, 1, 0}, course.segments.size()});
    course.segments.push_back({{-1e6, 5, 0}, {1e6, 5, 0}, course.segments.size()});
    for (const double far : {0.5, 1e9, 1e300, 4e5})
        course.queries.push_back({"?E", 100, {0}, {far, far == 4e5 ? 5.01 : 0.5, 0}, {}});
    CollisionEnvironment near(0.6);
    CHECK(first_answers(near, course) == std::vector<double>{1, 1, 1, 1});
    Budget small;
    small.memory = 100;
    CHECK_THROWS_WITH_AS(SegmentGrid(course.segments, 1, small),
                         "the grid of an environment would take more than the 0 MiB allowed",
                         BoundReached);
}

TEST_CASE("a hundred thousand lines and questions take no hundred thousand squared steps") {
    Traversal course;
    for (int i = 0; i < 100'000; ++i) {
        const Vector from{static_cast<double>(i % 300), static_cast<double>(i / 300), 0};
        course.segments.push_back(
            {from, from + Vector{0.5, 0.5, 0}, static_cast<std::size_t>(2 * i)});
        course.queries.push_back(
            {"?E", static_cast<std::size_t>(2 * i + 1), {0}, from + Vector{0.5, 0.5, 0}, {}});
    }
    CollisionEnvironment near(0.4);
    const auto begin = std::chrono::steady_clock::now();
    CHECK(first_answers(near, course) == std::vector<double>(100'000, 0.0));
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
}
