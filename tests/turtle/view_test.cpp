#include "turtle/turtle.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact/exact.hpp"
#include "oracle/ray_caster.hpp"

using namespace algae;

namespace {

double between(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 100'001) / 100'000.0;
}

/// Remembers, for some points of the picture, the colour that was painted over them last.
class Samples : public Canvas {
public:
    explicit Samples(std::vector<Point> points)
        : points_(std::move(points)), colours(points_.size()) {}

    void move_to(Point point) override { here_ = point; }
    void line_to(Point to) override {
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (near_line(points_[i], to)) colours[i] = colour_;
        drawn.add(here_);
        drawn.add(to);
        here_ = to;
    }
    void polygon(std::span<const Point> corners) override {
        for (const Point& corner : corners) drawn.add(corner);
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (inside(points_[i], corners)) colours[i] = colour_;
    }
    void width(double) override { width_ = 0; }
    void width_as_length(double length) override { width_ = length; }
    void colour(std::uint32_t) override {}
    void paint(const Colour& colour) override { colour_ = colour; }
    void position(double) override {}

private:
    bool near_line(Point p, Point to) const {
        const double dx = to.x - here_.x, dy = to.y - here_.y, square = dx * dx + dy * dy;
        const double t =
            square > 0
                ? std::clamp(((p.x - here_.x) * dx + (p.y - here_.y) * dy) / square, 0.0, 1.0)
                : 0;
        return std::hypot(p.x - here_.x - t * dx, p.y - here_.y - t * dy) <= width_ / 2;
    }
    static bool inside(Point p, std::span<const Point> corners) {
        int winding = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point a = corners[i], b = corners[(i + 1) % corners.size()];
            if ((a.y <= p.y) == (b.y <= p.y)) continue;
            if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) winding += a.y < b.y ? 1 : -1;
        }
        return winding != 0;
    }

    std::vector<Point> points_;
    Point here_;
    Colour colour_;
    double width_ = 0;

public:
    std::vector<std::optional<Colour>> colours;
    Box drawn;
};

/// Colours that stay apart in any light: light scales them and adds white.
Colour tag(std::size_t i) {
    const double angle = (static_cast<double>(i) + 0.5) * std::numbers::pi / 2 / 16;
    return {0.1 + 0.8 * std::cos(angle), 0.1 + 0.8 * std::sin(angle), 0.1};
}
std::optional<std::size_t> tagged(const std::optional<Colour>& colour) {
    if (!colour) return std::nullopt;
    const double angle = std::atan2(colour->green - colour->blue, colour->red - colour->blue);
    return static_cast<std::size_t>(angle * 16 / (std::numbers::pi / 2));
}

struct Arrangement3 {
    Scene scene;
    std::vector<oracle::Body> bodies;
    std::vector<SpaceBox> boxes;
};

/// Adds boxes, balls and rods along the axes whose boxes have nothing in common.
Arrangement3 random_arrangement(std::size_t count) {
    Arrangement3 all;
    for (std::size_t tries = 0; tries < 20 * count && all.bodies.size() < count; ++tries) {
        const int kind = *rc::gen::inRange(0, 3);
        const auto side = [] { return between(0.2, *rc::gen::inRange(0, 3) == 0 ? 7.0 : 2.0); };
        const Vector middle{between(-4, 4), between(-4, 4), between(-4, 4)};
        Vector half{side() / 2, side() / 2, side() / 2};
        const int axis = *rc::gen::inRange(0, 3);
        if (kind == 1) half = {half.x, half.x, half.x};
        if (kind == 2) {
            const double radius = between(0.1, 0.5), reach = side() / 2 + radius;
            half = {axis == 0 ? reach : radius, axis == 1 ? reach : radius,
                    axis == 2 ? reach : radius};
        }
        const SpaceBox box{middle - half, middle + half, false};
        const bool free =
            std::none_of(all.boxes.begin(), all.boxes.end(), [&](const SpaceBox& other) {
                return box.low.x < other.high.x && other.low.x < box.high.x &&
                       box.low.y < other.high.y && other.low.y < box.high.y &&
                       box.low.z < other.high.z && other.low.z < box.high.z;
            });
        if (!free) continue;
        all.boxes.push_back(box);
        Paint paint;
        paint.colour = tag(all.bodies.size());
        oracle::Body body;
        if (kind == 2) {
            const double radius = std::min({half.x, half.y, half.z});
            const Vector along = axis == 0   ? Vector{1, 0, 0}
                                 : axis == 1 ? Vector{0, 1, 0}
                                             : Vector{0, 0, 1};
            const double reach = std::max({half.x, half.y, half.z}) - radius;
            Rod rod;
            rod.from = middle - reach * along;
            rod.to = middle + reach * along;
            rod.radius = radius;
            rod.paint = paint;
            all.scene.rods.push_back(rod);
            body = {oracle::Body::Kind::rod,
                    {rod.from.x, rod.from.y, rod.from.z},
                    {rod.to.x, rod.to.y, rod.to.z},
                    radius};
        } else {
            Solid solid;
            solid.shape = kind == 1 ? SolidShape::sphere : SolidShape::box;
            solid.middle = middle;
            solid.size = kind == 1 ? Vector{half.x, 0, 0} : 2 * half;
            solid.paint = paint;
            all.scene.solids.push_back(solid);
            body.kind = kind == 1 ? oracle::Body::Kind::ball : oracle::Body::Kind::box;
            body.low = kind == 1 ? oracle::Triple{middle.x, middle.y, middle.z}
                                 : oracle::Triple{box.low.x, box.low.y, box.low.z};
            body.high = {box.high.x, box.high.y, box.high.z};
            body.radius = half.x;
        }
        all.bodies.push_back(body);
    }
    return all;
}

/// The ball that a camera of this scene holds.
void aim(oracle::Eye& eye, const Scene& scene) {
    SpaceBox box = box_of(scene);
    double radius = 0;
    for (const Rod& rod : scene.rods) radius = std::max(radius, rod.radius);
    const Vector middle = box.low + 0.5 * (box.high - box.low), half = box.high - middle;
    eye.middle = {middle.x, middle.y, middle.z};
    eye.radius = std::sqrt(std::pow(half.x + radius, 2) + std::pow(half.y + radius, 2) +
                           std::pow(half.z + radius, 2));
}

}  // namespace

TEST_CASE("what is painted last is what a line of sight meets first") {
    CHECK(rc::check([] {
        Arrangement3 all = random_arrangement(static_cast<std::size_t>(*rc::gen::inRange(2, 16)));
        ViewChoices choices;
        choices.camera = {between(-180, 180), between(-90, 90), *rc::gen::arbitrary<bool>(),
                          between(10, 60)};
        oracle::Eye eye;
        eye.azimuth = choices.camera.azimuth;
        eye.elevation = choices.camera.elevation;
        eye.opening = choices.camera.perspective ? choices.camera.opening : 0;
        aim(eye, all.scene);
        const SpaceView view(all.scene, {}, {}, choices, {});
        const Box box = view.box();
        constexpr int across = 24;
        const double dx = box.breadth() / across, dy = box.height() / across;
        const double doubt =
            0.02 *
            std::max(box.breadth(), box.height());  // facets for roundness; perspective of balls
        std::vector<Point> points;
        std::vector<std::optional<std::size_t>> expected;
        for (int i = 0; i < across; ++i)
            for (int j = 0; j < across; ++j) {
                const Point at{box.low.x + (i + 0.5) * dx, box.low.y + (j + 0.5) * dy};
                const auto met = oracle::first_met(all.bodies, eye, at.x, at.y);
                bool sure = true;
                for (const auto& [x, y] : {std::pair(1., 0.),
                                           {-1., 0.},
                                           {0., 1.},
                                           {0., -1.},
                                           {.7, .7},
                                           {-.7, .7},
                                           {.7, -.7},
                                           {-.7, -.7}})
                    sure = sure && oracle::first_met(all.bodies, eye, at.x + doubt * x,
                                                     at.y + doubt * y) == met;
                if (!sure) continue;
                points.push_back(at);
                expected.push_back(met);
            }
        Samples samples(points);
        view.draw(samples, box.breadth() / 1000, {});
        for (std::size_t i = 0; i < points.size(); ++i)
            RC_ASSERT(tagged(samples.colours[i]) == expected[i]);
    }));
}

TEST_CASE("the box contains everything drawn") {
    CHECK(rc::check([] {
        Arrangement3 all = random_arrangement(static_cast<std::size_t>(*rc::gen::inRange(1, 8)));
        Solid round;
        round.shape = *rc::gen::arbitrary<bool>() ? SolidShape::cone : SolidShape::cylinder;
        round.attitude.pitch(turn_by(between(0, 360)));
        round.attitude.yaw(turn_by(between(0, 360)));
        round.middle = {between(-9, 9), 0, 0};
        round.size = {between(0.1, 5), between(0.1, 5), 0};
        all.scene.solids.push_back(round);
        const std::vector<Vector> corners{
            {between(-9, 9), 1, 2}, {3, between(-9, 9), 0}, {0, 1, between(-9, 9)}};
        all.scene.add_face(corners, {});
        ViewChoices choices;
        choices.camera = {between(-180, 180), between(-90, 90), *rc::gen::arbitrary<bool>(),
                          between(10, 60)};
        const SpaceView view(all.scene, {}, {}, choices, {});
        Samples samples({});
        const double pixel = view.box().breadth() / 1000, slack = 3 * pixel;
        view.draw(samples, pixel, {});
        RC_ASSERT(samples.drawn.low.x > view.box().low.x - slack);
        RC_ASSERT(samples.drawn.low.y > view.box().low.y - slack);
        RC_ASSERT(samples.drawn.high.x < view.box().high.x + slack);
        RC_ASSERT(samples.drawn.high.y < view.box().high.y + slack);
    }));
}

TEST_CASE("the box of a perspective holds a thick rod that is seen nearly from its end") {
    Scene scene;
    Rod rod;
    rod.from = {3, 0.4, -2};
    rod.to = {-3, 0.4, 2};
    rod.radius = 0.5;
    scene.rods.push_back(rod);
    for (double azimuth = -180; azimuth < 180; azimuth += 7)
        for (const double opening : {20., 52., 60.}) {
            ViewChoices choices;
            choices.camera = {azimuth, 10, true, opening};
            const SpaceView view(scene, {}, {}, choices, {});
            Samples samples({});
            const double pixel = view.box().height() / 100'000;
            view.draw(samples, pixel, {});
            CHECK(samples.drawn.low.x > view.box().low.x - pixel);
            CHECK(samples.drawn.low.y > view.box().low.y - pixel);
            CHECK(samples.drawn.high.x < view.box().high.x + pixel);
            CHECK(samples.drawn.high.y < view.box().high.y + pixel);
        }
}

TEST_CASE("nothing shows between a thick rod and the disc at its end") {
    Scene scene;
    Rod rod;
    rod.from = {-3, -2, -2.5};
    rod.to = {-3, -0.4, -2.5};
    rod.radius = 0.5;
    rod.paint.colour = tag(0);
    scene.rods.push_back(rod);
    ViewChoices choices;
    choices.camera = {82, -46, true, 40};
    choices.sight = SpaceBox{{-5, -4, -4}, {-1, 2, -1}, false};
    const Projection projection(choices.camera, *choices.sight);
    std::vector<Point> points;
    for (int i = 0; i < 3600; ++i) {
        const Turn turn = turn_by(i / 10.0);
        const double almost = 0.998 * rod.radius;
        const Seen seen = projection(rod.to + Vector{almost * turn.cosine, 0, almost * turn.sine});
        points.push_back({seen.x, seen.y});
    }
    const SpaceView view(scene, {}, {}, choices, {});
    Samples samples(points);
    view.draw(samples, view.box().breadth() / 1000, {});
    CHECK(std::all_of(samples.colours.begin(), samples.colours.end(),
                      [](const auto& colour) { return colour.has_value(); }));
}

TEST_CASE("things that hide each other in a ring are halved until an order is right") {
    // Three long beams, each over the next at one end: seen from above.
    Scene scene;
    std::vector<oracle::Body> bodies;
    const auto beam = [&](double angle, double x, double y, double z, double tilt) {
        Rod rod;
        const Vector middle{x, y, z}, along{std::cos(angle), std::sin(angle), tilt};
        rod.from = middle - 3 * along;
        rod.to = middle + 3 * along;
        rod.radius = 0.2;
        rod.paint.colour = tag(bodies.size());
        scene.rods.push_back(rod);
        bodies.push_back({oracle::Body::Kind::rod,
                          {rod.from.x, rod.from.y, rod.from.z},
                          {rod.to.x, rod.to.y, rod.to.z},
                          0.2});
    };
    for (int i = 0; i < 3; ++i) {
        const double turn = i * 2 * std::numbers::pi / 3;
        beam(turn + std::numbers::pi / 2, std::cos(turn), std::sin(turn), 0, 0.4);
    }
    ViewChoices choices;
    choices.camera = {-90, 90};
    oracle::Eye eye;
    eye.azimuth = -90;
    eye.elevation = 90;
    aim(eye, scene);
    const SpaceView view(scene, {}, {}, choices, {});
    std::vector<Point> points;
    std::vector<std::optional<std::size_t>> expected;
    for (double x = -3; x <= 3; x += 0.11)
        for (double y = -3; y <= 3; y += 0.11) {
            const auto met = oracle::first_met(bodies, eye, x, y);
            bool sure = true;
            for (const double d : {-0.08, 0.08})
                sure = sure && oracle::first_met(bodies, eye, x + d, y) == met &&
                       oracle::first_met(bodies, eye, x, y + d) == met;
            if (!sure) continue;
            points.push_back({x, y});
            expected.push_back(met);
        }
    Samples samples(points);
    view.draw(samples, 0.01, {});
    int wrong = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        wrong += tagged(samples.colours[i]) != expected[i];
    CHECK(wrong == 0);
}

TEST_CASE("facts have three coordinates, those of the scene") {
    Scene scene;
    Rod rod;
    rod.to = {1, 2, 3};
    rod.radius = 0.5;
    scene.rods = {rod};
    const SpaceView view(scene, {}, {{1, 2, 3}, 4, {}}, {}, {});
    CHECK(view.segments() == Integer(1));
    REQUIRE(view.facts().low.size() == 3);
    CHECK(view.facts().low[2].value() == 0);
    CHECK(view.facts().high[1].value() == 2);
    CHECK(view.facts().end[2].value() == 3);
    CHECK(view.facts().step == 4);
    CHECK(view.is_layered());
    CHECK(view.has_scale());
    ViewChoices choices;
    choices.camera.perspective = true;
    CHECK_FALSE(SpaceView(scene, {}, {}, choices, {}).has_scale());
}

TEST_CASE("an empty scene has an empty box") {
    const SpaceView view(Scene{}, {}, {}, {}, {});
    CHECK(view.box().empty);
    CHECK(view.facts().low.empty());
    Samples samples({});
    view.draw(samples, 1, {});
    CHECK(samples.drawn.empty);
}

TEST_CASE("a scene beyond the memory is refused before anything is drawn") {
    Scene scene;
    scene.name = "generation 9 of bush";
    scene.rods.resize(10'000);
    Budget budget;
    budget.memory = 1'000'000;
    CHECK_THROWS_WITH_AS(
        SpaceView(scene, {}, {}, {}, budget),
        doctest::Contains("the picture of the 10000 parts of generation 9 of bush"), BoundReached);
}

TEST_CASE("lines without thickness leave a gap where they pass over others") {
    struct Recorder : Samples {
        using Samples::Samples;
        double line_width() const override { return 0.1; }
        void polygon(std::span<const Point> corners) override {
            ++gaps;
            Samples::polygon(corners);
        }
        int gaps = 0;
    };
    Scene scene;
    Rod low, high;
    low.from = {-1, 0, 0};
    low.to = {1, 0, 0};
    high.from = {0, -1, 1};
    high.to = {0, 1, 1};
    scene.rods = {low, high};
    ViewChoices choices;
    choices.camera = {-90, 90};
    choices.background = {0, 0, 1};
    Recorder seen({{0.1, 0}, {0.6, 0}});
    SpaceView(scene, {}, {}, choices, {}).draw(seen, 0.01, {});
    CHECK(seen.gaps == 2);
    CHECK(seen.colours[0] == Colour{0, 0, 1});
    choices.gap = 0;
    Recorder closed({{0.1, 0}});
    SpaceView(scene, {}, {}, choices, {}).draw(closed, 0.01, {});
    CHECK(closed.gaps == 0);
}
