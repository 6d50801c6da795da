#include "turtle/turtle.hpp"

#include <doctest/doctest.h>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/recording.hpp"

using namespace algae;

namespace {

/// What is drawn on a canvas, and the box around it.
struct Counted : Recording {
    void line_to(Point point) override {
        Recording::line_to(point);
        box.add(point);
    }
    void polygon(std::span<const Point> corners) override {
        Recording::polygon(corners);
        for (const Point corner : corners) box.add(corner);
    }
    double line_width() const override { return 0.01; }
    Box box;
};

}  // namespace

TEST_CASE("views of a word part by part share a camera and a box, and grow") {
    const Model system =
        read_lsystem("axiom F[+F^F]/(40)[&F{F+F+F}]!(0.2)F$F; angle 50", "grown.lsys");
    const DerivedModules derived = derived_modules(system, 0, {});
    const auto symbols = frames_of_progress(derived.word.kinds.size(), 100);
    for (const bool perspective : {false, true}) {
        ViewChoices choices;
        choices.camera.perspective = perspective;
        const auto views = partial_views(system, derived, 0, symbols, choices, {});
        REQUIRE(views.size() == derived.word.kinds.size() + 1);
        std::size_t before = 0;
        for (const auto& view : views) {
            Counted canvas;
            view->draw(canvas, 0.01, {});
            const Box& room = view->box();
            CHECK(room == views.front()->box());
            CHECK(canvas.box.low.x >= room.low.x - 1e-9);
            CHECK(canvas.box.low.y >= room.low.y - 1e-9);
            CHECK(canvas.box.high.x <= room.high.x + 1e-9);
            CHECK(canvas.box.high.y <= room.high.y + 1e-9);
            CHECK(canvas.polygons.size() >= 4);  // the turtle
            const std::size_t marks = canvas.strokes.size() + canvas.polygons.size();
            CHECK(marks + 40 >= before);  // nothing goes but what the turtle hid
            before = marks;
            CHECK(view->place({0.5, 0.25, 1}) == views.front()->place({0.5, 0.25, 1}));
        }
        Counted first, last;
        views.front()->draw(first, 0.01, {});
        views.back()->draw(last, 0.01, {});
        CHECK(first.strokes.empty());
        CHECK(last.strokes.size() >= 7);
        CHECK(last.polygons.size() > first.polygons.size());
    }
}

TEST_CASE(
    "turned views keep the middle of a scene and its size, and each is what its camera sees") {
    const Model system = read_lsystem("axiom !(0.2)F[+F^F]/(40)[&F{F+F+F}]$F; angle 50", "t.lsys");
    const SpaceDerivation derived = scene(system, 0, {});
    const SpaceBox around = box_of(derived.scene);
    const Vector middle = 0.5 * (around.low + around.high);
    for (const bool perspective : {false, true}) {
        std::vector<Camera> cameras;
        for (int azimuth = 0; azimuth < 360; azimuth += 30)
            cameras.push_back({double(azimuth), 25, perspective});
        const auto views = turned_views(derived, style_of(system.drawing), {}, cameras, {});
        REQUIRE(views.size() == cameras.size());
        for (std::size_t i = 0; i < views.size(); ++i) {
            const Box& box = views[i]->box();
            CHECK(box.breadth() == doctest::Approx(views[0]->box().breadth()));
            CHECK(box.height() == doctest::Approx(views[0]->box().height()));
            const auto at = views[i]->place(middle);
            REQUIRE(at);
            CHECK(at->x == doctest::Approx((box.low.x + box.high.x) / 2));
            CHECK(at->y == doctest::Approx((box.low.y + box.high.y) / 2));
            ViewChoices alone;
            alone.camera = cameras[i];
            const SpaceView view(derived.scene, style_of(system.drawing), {}, alone, {});
            Counted turned, single;
            views[i]->draw(turned, 0.01, {});
            view.draw(single, 0.01, {});
            CHECK(turned.strokes.size() == single.strokes.size());
            CHECK(turned.polygons == single.polygons);
            CHECK(turned.box.low.x >= box.low.x - 1e-9);
            CHECK(turned.box.high.y <= box.high.y + 1e-9);
        }
    }
    CHECK(turned_views(scene(read_lsystem("axiom A; A -> &A", ""), 0, {}), {}, {}, {Camera{}}, {})
              .front()
              ->box()
              .empty);
}
