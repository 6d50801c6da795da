#include "render/detail/layout.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <vector>

using namespace algae;

namespace {

Box box(double left, double bottom, double right, double top) {
    return {{left, bottom}, {right, top}, false};
}

/// Whether the figure lies in its cell, up to rounding.
bool holds(const Cell& cell, const Box& figure) {
    const Point low = cell.frame(figure.low), high = cell.frame(figure.high);
    const double slack = 1e-9 * (1 + cell.width + cell.height);
    return low.x >= cell.left - slack && high.x <= cell.left + cell.width + slack &&
           high.y >= cell.top - slack && low.y <= cell.top + cell.height + slack;
}

}  // namespace

TEST_CASE("without wishes the longer side is 600") {
    const Box wide = box(0, 0, 3, 1), tall = box(-1, -5, 1, 5);
    const Layout a = layout({{wide}}, {}), b = layout({{tall}}, {});
    CHECK(a.width == doctest::Approx(600));
    CHECK(a.height == doctest::Approx(20 + 580 / 3.0));
    CHECK(b.height == doctest::Approx(600));
    CHECK(b.width == doctest::Approx(20 + 58 * 2));
    CHECK(a.cells[0].frame.scale == doctest::Approx(580 / 3.0));
    CHECK(a.cells[0].frame({0, 0}).x == doctest::Approx(10));
    CHECK(a.cells[0].frame({0, 0}).y == doctest::Approx(a.height - 10));  // y points up
}

TEST_CASE("one wished side decides the other; with both the figure is in the middle") {
    LayoutWishes wishes;
    wishes.width = 220;
    CHECK(layout({{box(0, 0, 2, 1)}}, wishes).height == doctest::Approx(120));
    wishes.height = 220;
    const Layout both = layout({{box(0, 0, 2, 1)}}, wishes);
    CHECK(both.height == 220);
    CHECK(both.cells[0].frame({1, 0.5}).y == doctest::Approx(110));
    wishes.width.reset();
    CHECK(layout({{box(0, 0, 2, 1)}}, wishes).width == doctest::Approx(420));
}

TEST_CASE("a straight line and a single point have a place") {
    const Layout line = layout({{box(0, 0, 7, 0)}}, {});
    CHECK(line.width == doctest::Approx(600));
    CHECK(line.height == doctest::Approx(20));
    const Layout point = layout({{box(3, 3, 3, 3)}}, {});
    CHECK(point.width == doctest::Approx(20));
    CHECK(point.cells[0].frame({3, 3}).x == doctest::Approx(10));
    LayoutWishes wishes;
    wishes.width = 100;
    const Layout upright = layout({{box(0, 0, 0, 7)}}, wishes);
    CHECK(upright.width == 100);
    CHECK(upright.height == doctest::Approx(600));
}

TEST_CASE("panels fill rows") {
    const auto columns = [](std::size_t count, double breadth, double height) {
        return panel_columns(std::vector<Box>(count, box(0, 0, breadth, height)));
    };
    CHECK(columns(1, 1, 1) == 1);
    CHECK(columns(5, 1, 1) == 5);
    CHECK(columns(6, 1, 1) == 3);
    CHECK(columns(7, 1, 1) == 4);
    CHECK(columns(11, 1, 1) == 4);
    CHECK(columns(5, 2, 1) == 5);
    CHECK(columns(3, 3, 1) == 1);
    CHECK(columns(5, 3, 1) == 2);
    CHECK(columns(5, 3, 0) == 1);
    CHECK(columns(9, 3, 1) == 2);
    const std::vector<Box> boxes(7, box(0, 0, 1, 1));
    LayoutWishes wishes;
    wishes.columns = 4;
    wishes.caption = 20;
    const Layout rows = layout(boxes, wishes);
    CHECK(rows.width == doctest::Approx(600));
    CHECK(rows.cells[0].width == doctest::Approx((600 - 80) / 4.0));
    CHECK(rows.cells[4].left == doctest::Approx(10));
    CHECK(rows.cells[4].top > rows.cells[0].caption_top + 20);
    CHECK(rows.height == doctest::Approx(3 * 10 + 2 * (20 + 130)));
}

TEST_CASE("a straight line does not decide how high the panels are") {
    const std::vector<Box> boxes = {box(0, 0, 0, 1), box(0, 0, 2, 1)};
    LayoutWishes wishes;
    wishes.columns = 2;
    const Layout row = layout(boxes, wishes);
    CHECK(row.cells[0].width == doctest::Approx(280));
    CHECK(row.cells[0].height == doctest::Approx(140));
    CHECK(holds(row.cells[0], boxes[0]));
}

TEST_CASE("pages have one size, and one scale if it is wished") {
    const std::vector<Box> boxes = {box(0, 0, 1, 0), box(0, 0, 2, 1), box(0, 0, 1, 3)};
    LayoutWishes wishes;
    const std::vector<Layout> pages = page_layouts(boxes, wishes);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        CHECK(pages[i].width == doctest::Approx(600));
        CHECK(pages[i].height == doctest::Approx(600));
        CHECK(holds(pages[i].cells[0], boxes[i]));
    }
    CHECK(pages[0].cells[0].frame.scale != doctest::Approx(pages[1].cells[0].frame.scale));
    wishes.common_scale = true;
    for (const Layout& page : page_layouts(boxes, wishes))
        CHECK(page.cells[0].frame.scale == doctest::Approx(580 / 3.0));
}

TEST_CASE("every figure lies in its cell and every cell in the picture") {
    CHECK(rc::check("random boxes and wishes", [] {
        std::vector<Box> boxes;
        for (int i = *rc::gen::inRange(1, 9); i > 0; --i) {
            const double x = *rc::gen::inRange(-1000, 1000), y = *rc::gen::inRange(-1000, 1000);
            const double a = *rc::gen::inRange(0, 100), b = *rc::gen::inRange(0, 100);
            boxes.push_back(box(x, y, x + a / 7, y + b));
        }
        LayoutWishes wishes;
        if (*rc::gen::arbitrary<bool>()) wishes.width = *rc::gen::inRange(200, 900);
        if (*rc::gen::arbitrary<bool>()) wishes.height = *rc::gen::inRange(400, 900);
        wishes.columns = *rc::gen::inRange<std::size_t>(1, 6);
        wishes.margin = *rc::gen::inRange(1, 20);
        wishes.caption = *rc::gen::inRange(0, 20);
        wishes.common_scale = *rc::gen::arbitrary<bool>();
        const Layout result = layout(boxes, wishes);
        RC_ASSERT(result.cells.size() == boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Cell& cell = result.cells[i];
            RC_ASSERT(holds(cell, boxes[i]));
            RC_ASSERT(cell.left + cell.width + wishes.margin <= result.width + 1e-6);
            RC_ASSERT(cell.caption_top + wishes.caption + wishes.margin <= result.height + 1e-6);
            if (wishes.common_scale) RC_ASSERT(cell.frame.scale == result.cells[0].frame.scale);
        }
    }));
}
