#include "dimension/dimension.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>
#include <random>

#include "dimension/detail/cells.hpp"
#include "dimension/measured.hpp"
#include "exact/exact.hpp"

using namespace algae;

namespace {

const std::vector<double> orders{-5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5};

/// Cantor's set to a depth, with a share p of what lies in each third in its left part.
std::pair<PointSet, std::vector<double>> binomial_cantor(double p, int depth) {
    PointSet points{1, {{0, 0, 0}}};
    std::vector<double> weights{1};
    double width = 1;
    for (int i = 0; i < depth; ++i) {
        width /= 3;
        const std::size_t count = weights.size();
        for (std::size_t k = 0; k < count; ++k) {
            points.points.push_back({points.points[k][0] + 2 * width, 0, 0});
            weights.push_back(weights[k] * (1 - p));
            weights[k] *= p;
        }
    }
    return {points, weights};
}

double binomial_dimension(double p, double q) {
    if (q == 1) return -(p * std::log(p) + (1 - p) * std::log(1 - p)) / std::log(3);
    return std::log(std::pow(p, q) + std::pow(1 - p, q)) / ((1 - q) * std::log(3));
}

void check_holds(const GeneralisedDimension& found, double dimension, double within) {
    CAPTURE(found.order);
    check_holds(found.scaling, dimension, within);
}

}  // namespace

TEST_CASE("the binomial measure on Cantor's set has the dimensions of the closed form") {
    for (const double p : {0.5, 0.4, 0.3}) {
        CAPTURE(p);
        const auto [points, weights] = binomial_cantor(p, 14);
        for (const auto& found : generalised_dimensions(points, weights, orders, 16, Budget()))
            check_holds(found, binomial_dimension(p, found.order), 0.08);
    }
}

TEST_CASE("the binomial cascade on an interval has its dimensions of negative order") {
    // Adjacent parts differ by powers of 0.7 / 0.3, and grids do not lie as the parts do.
    constexpr double p = 0.7;
    const auto dimension = [&](double q) {
        return q == 1 ? -(p * std::log2(p) + (1 - p) * std::log2(1 - p))
                      : std::log2(std::pow(p, q) + std::pow(1 - p, q)) / (1 - q);
    };
    PointSet points{1, {}};
    std::vector<double> weights{1};
    for (int depth = 0; depth < 16; ++depth) {
        std::vector<double> next;
        for (const double weight : weights) {
            next.push_back(p * weight);
            next.push_back((1 - p) * weight);
        }
        weights = std::move(next);
    }
    for (std::size_t i = 0; i < weights.size(); ++i)
        points.points.push_back({static_cast<double>(i), 0, 0});
    const auto exact = generalised_dimensions(points, weights, orders, 16, Budget());
    for (const auto& found : exact) {
        CAPTURE(found.order);
        REQUIRE(found.scaling.estimate);
        CAPTURE(found.scaling.estimate->value);
        CAPTURE(found.scaling.estimate->low);
        CAPTURE(found.scaling.estimate->high);
        CHECK(std::abs(found.scaling.estimate->value - dimension(found.order)) < 0.15);
        CHECK(found.scaling.estimate->low <= dimension(found.order));
        CHECK(found.scaling.estimate->high >= dimension(found.order));
    }
    // Samples of it: what they do not resolve is refused, and the rest is right.
    int refused = 0, measured = 0, held = 0;
    for (unsigned seed = 1; seed <= 8; ++seed) {
        std::mt19937_64 random(seed);
        PointSet sample{1, {}};
        for (int i = 0; i < 40'000; ++i) {
            double x = 0;
            for (int k = 1; k <= 30; ++k)
                if (static_cast<double>(random() >> 11) * 0x1p-53 > p) x += std::ldexp(1.0, -k);
            sample.points.push_back({x, 0, 0});
        }
        for (const auto& [order, scaling] : generalised_dimensions(
                 sample, {}, std::vector<double>{-5, -4, -3, -2, -1}, 16, Budget())) {
            CAPTURE(order);
            if (!scaling.estimate) {
                CHECK(scaling.because.find("boxes that decide hold") != std::string::npos);
                ++refused;
                continue;
            }
            ++measured;
            if (scaling.estimate->low <= dimension(order) &&
                scaling.estimate->high >= dimension(order))
                ++held;
            else
                MESSAGE("order " << order << ": " << dimension(order) << " is not in ["
                                 << scaling.estimate->low << ", " << scaling.estimate->high << "]");
        }
    }
    MESSAGE(refused << " refused, " << held << " of " << measured << " held");
    CHECK(refused >= 8);
    CHECK(measured >= 4);
    CHECK(held * 10 >= measured * 9);
}

TEST_CASE("a line has dimension 1 and a filled square 2 for every order") {
    const auto line = drawn("axiom F; F -> FF; angle 60", 12);
    for (const auto& found : generalised_dimensions(*line, orders, 16, Budget()))
        check_holds(found, 1, found.order < 0 ? 0.08 : 0.03);
    PointSet square;
    for (int i = 0; i < 512; ++i)
        for (int k = 0; k < 512; ++k)
            square.points.push_back({static_cast<double>(i), static_cast<double>(k), 0});
    square.detail = 1;
    square.part = "pixel";
    for (const auto& found : generalised_dimensions(square, {}, orders, 8, Budget()))
        check_holds(found, 2, found.order < 0 ? 0.3 : 0.1);  // the edge, see the header
}

TEST_CASE("the Koch curve has its dimension for every order, negative ones too") {
    const auto koch = drawn("axiom F; F -> F+F--F+F; angle 60", 9);
    for (const auto& found : generalised_dimensions(*koch, orders, 16, Budget()))
        check_holds(found, std::log(4) / std::log(3), 0.06);
}

TEST_CASE("order 0 is the box dimension, counts and estimate") {
    for (const char* text :
         {"axiom F; F -> F+F--F+F; angle 60", "axiom F; F -> F[+F]F[-F]F; angle 25.7",
          "axiom F; F -> FfF; f -> fff; angle 90"}) {
        const auto figure = drawn(text, 6);
        const std::vector<double> zero{0};
        const Scaling found = generalised_dimensions(*figure, zero, 4, Budget())[0].scaling;
        const BoxCounts counts = box_counts(
            *figure, scales_of(figure->box(), 2, found.sizes.size()), even_offsets(4), Budget());
        for (std::size_t i = 0; i < found.sizes.size(); ++i)
            CHECK(found.values[i] == counts.mean(i));
        const BoxFit fit = fit_dimension(counts);
        REQUIRE(found.estimate.has_value() == fit.estimate.has_value());
        if (!fit.estimate) continue;
        CHECK(found.estimate->value == doctest::Approx(fit.estimate->value));
        CHECK(found.estimate->low == doctest::Approx(fit.estimate->low));
    }
}

TEST_CASE("sums over boxes are those of a list of boxes, and of boxes three times as wide") {
    CHECK(rc::check("boxes", [] {
        const int columns = *rc::gen::inRange(1, 4);
        PointSet set{columns, {}};
        std::vector<double> weights;
        for (int i = *rc::gen::inRange(2, 30); i > 0; --i) {
            std::array<double, 3> point{};
            for (int k = 0; k < columns; ++k)
                point[static_cast<std::size_t>(k)] = *rc::gen::inRange(0, 1000) / 7.0;
            set.points.push_back(point);
            weights.push_back(*rc::gen::inRange(1, 9));
        }
        set.points.push_back({200, 0, 0});  // so that they differ
        weights.push_back(1);
        set.detail = 200.0 / 64;  // five scales, down to four details
        const auto found = generalised_dimensions(set, weights, orders, 1, Budget());
        std::array<double, 3> low = set.points[0], high = low;
        double whole = 0, all = 0;
        for (const auto& point : set.points)
            for (std::size_t k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], point[k]);
                high[k] = std::max(high[k], point[k]);
                whole = std::max(whole, high[k] - low[k]);
            }
        for (const double weight : weights) all += weight;
        const auto shares = even_places(1)[0];
        for (std::size_t scale = 0; scale < found[0].scaling.sizes.size(); ++scale) {
            const double cell = found[0].scaling.sizes[scale];
            std::map<std::array<long, 3>, double> boxes;
            for (std::size_t i = 0; i < set.points.size(); ++i) {
                std::array<long, 3> box{};
                for (std::size_t k = 0; k < static_cast<std::size_t>(columns); ++k)
                    box[k] = static_cast<long>(
                        std::floor((set.points[i][k] - low[k] + shares[k] * whole) / cell + 1e-7));
                boxes[box] += weights[i] / all;
            }
            for (const auto& [order, scaling] : found) {
                double sum = 0;
                for (const auto& [box, share] : boxes) {
                    double around = 0;
                    for (const auto& [other, part] : boxes) {
                        bool near = true;
                        for (std::size_t k = 0; k < 3; ++k)
                            near = near && std::abs(box[k] - other[k]) <= 1;
                        if (near) around += part;
                    }
                    sum += order == 1 ? -share * std::log(share)
                                      : std::pow(order < 0 ? around : share, order);
                }
                RC_ASSERT(std::abs(scaling.values[scale] - sum) <= 1e-9 * std::abs(sum));
            }
        }
    }));
}

TEST_CASE("lengths in boxes add up, and are those of many small pieces") {
    const auto figure = drawn("axiom F; F -> F[+F]F[-F]F; angle 25.7", 3);
    const Grid grid = Grid::before(figure->box(), 2.3, {0.3, 0.6}, 2.3);
    const auto cells = drawn_masses(*figure, grid, Budget());
    double sum = 0;
    for (const CellMass& cell : cells) sum += cell.mass;
    CHECK(sum == doctest::Approx(125));
    CHECK(rc::check("lengths", [] {
        const auto angle = *rc::gen::inRange(0, 3600) / 10.0;
        const std::string text =
            "axiom F; F -> F; angle 90; step 7; start 0 0 " + std::to_string(angle);
        const auto line = drawn(text.c_str(), 0);
        const Grid squares = Grid::before(line->box(), 1, {0.21, 0.43}, 1);
        std::map<std::uint64_t, double> lengths;
        const double radians = angle * std::acos(-1) / 180;
        for (int k = 0; k < 70'000; ++k) {
            const double way = (k + 0.5) / 10'000;
            const GridPoint at = squares.at({way * std::cos(radians), way * std::sin(radians)});
            lengths[Morton(static_cast<std::uint64_t>(at.column()),
                           static_cast<std::uint64_t>(at.row()))
                        .code] += 1e-4;
        }
        for (const CellMass& cell : drawn_masses(*line, squares, Budget()))
            RC_ASSERT(std::abs(cell.mass - lengths[cell.code]) < 1e-3);
    }));
}

TEST_CASE("what has no measure is refused") {
    const std::vector<double> none, two{2};
    const PointSet pair{2, {{0, 0, 0}, {1, 0, 0}}};
    CHECK_THROWS_WITH_AS(generalised_dimensions(pair, {}, none, 1, Budget()),
                         "expected at least one order and one offset, found 0 and 1", Error);
    CHECK_THROWS_WITH_AS(generalised_dimensions(pair, two, two, 1, Budget()),
                         "expected a weight for each point, found 1 weights for 2 points", Error);
    CHECK_THROWS_WITH_AS(generalised_dimensions(pair, std::vector<double>{0, 0}, two, 1, Budget()),
                         "expected something with a length or a weight to measure, found 0.000000 "
                         "of it",
                         Error);
    CHECK_THROWS_WITH_AS(generalised_dimensions(*drawn("axiom f; f -> ff", 3), two, 1, Budget()),
                         "nothing is drawn: expected something to measure", Error);
    CHECK(!generalised_dimensions(pair, {}, two, 1, Budget())[0].scaling.estimate);
}
