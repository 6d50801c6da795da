#include "turtle/detail/view.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <atomic>

#include "exact/exact.hpp"

using namespace algae;

namespace {

Extent random_extent() {
    const auto number = [] { return *rc::gen::inRange(0, 100) / 10.0; };
    Extent extent;
    extent.left = number();
    extent.right = extent.left + number() + 0.1;
    extent.bottom = number();
    extent.top = extent.bottom + number() + 0.1;
    extent.depth = number();
    return extent;
}

bool meet(const Extent& a, const Extent& b) {
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

}  // namespace

TEST_CASE("everything comes after what it hides") {
    CHECK(rc::check([] {
        const auto count = static_cast<std::uint32_t>(*rc::gen::inRange(0, 60));
        std::vector<Extent> things;
        std::vector<std::uint32_t> height(
            count);  // a hidden order that has nothing to do with depth
        for (std::uint32_t i = 0; i < count; ++i) {
            things.push_back(random_extent());
            height[i] = static_cast<std::uint32_t>(*rc::gen::inRange(0, 1000));
        }
        const Hiding hiding = [&](std::uint32_t a, std::uint32_t b) {
            return height[a] > height[b] ? 1 : height[a] < height[b] ? -1 : 0;
        };
        const PaintingOrder found = painting_order(things, hiding, {});
        RC_ASSERT(found.knotted.empty());
        std::vector<std::uint32_t> sorted = found.order, place(count);
        std::sort(sorted.begin(), sorted.end());
        for (std::uint32_t i = 0; i < count; ++i) RC_ASSERT(sorted[i] == i);
        for (std::uint32_t i = 0; i < count; ++i) place[found.order[i]] = i;
        for (std::uint32_t a = 0; a < count; ++a)
            for (std::uint32_t b = 0; b < count; ++b)
                if (meet(things[a], things[b]) && height[a] > height[b])
                    RC_ASSERT(place[a] > place[b]);
    }));
}

TEST_CASE("what nobody compares is painted by depth") {
    CHECK(rc::check([] {
        std::vector<Extent> things(static_cast<std::size_t>(*rc::gen::inRange(1, 50)));
        for (Extent& thing : things) {
            thing = random_extent();
            thing.slight = true;
        }
        const PaintingOrder found = painting_order(things, [](auto, auto) { return 1; }, {});
        for (std::size_t i = 1; i < found.order.size(); ++i)
            RC_ASSERT(things[found.order[i - 1]].depth <= things[found.order[i]].depth);
    }));
}

TEST_CASE("a ring of things is a knot") {
    std::vector<Extent> things(4, Extent{0, 1, 0, 1, 0, false});
    things[3] = {5, 6, 5, 6, 0, false};
    const PaintingOrder found = painting_order(
        things, [](std::uint32_t a, std::uint32_t b) { return (a + 1) % 3 == b ? -1 : 1; }, {});
    CHECK(found.order.size() == 4);
    std::vector<std::uint32_t> knotted = found.knotted;
    std::sort(knotted.begin(), knotted.end());
    CHECK(knotted == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("painting can be interrupted") {
    const std::atomic<bool> stop = true;
    Budget budget;
    budget.stop = &stop;
    const std::vector<Extent> things(10);
    CHECK_THROWS_AS(painting_order(
                        things, [](auto, auto) { return 0; }, budget),
                    Interrupted);
}
