#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>

#include "dimension/detail/measures.hpp"
#include "dimension/dimension.hpp"
#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "report/report.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

struct Counted {
    ExactDimension exact;
    LimitCounts counts;
    BoxFit fit;
};

Counted counted(const char* text, const LimitCounting& counting) {
    const Model system = read_lsystem(text, "a.lsys");
    Counted found{exact_dimension(system), {}, {}};
    found.counts = limit_counts(RecurrentSet(system, *as_d0l(system)), counting);
    found.fit = fit_limit(found.counts, found.exact.meeting, 2, lower_terms(found.exact));
    return found;
}

constexpr LimitCounting quick{8, 1, 6'000};

}  // namespace

TEST_CASE("boxes of the limit give the exact dimension within their interval") {
    for (const char* text :
         {"axiom F; F -> F+F--F+F; angle 60", "axiom F; F -> F-F+F+FF-F-F+F",
          "axiom F; F -> F+F-F-F+F", "axiom F; F -> FfF; f -> fff", "axiom F; F -> F[+F][-F]FF",
          "axiom F; F -> -F++G-; G -> +F--G+; angle 45", "axiom F; F -> F+F-F; angle 120",
          "axiom X; X -> -YF+XFX+FY-; Y -> +XF-YFY-FX+", "axiom F; F -> FF-F-F-F-F-F+F",
          "axiom F_a; F_a -> F_b+F_a+F_b; F_b -> F_a-F_b-F_a; angle 60",
          "axiom F; F -> +F--F+; angle 45"}) {
        CAPTURE(text);
        const Counted found = counted(text, quick);
        REQUIRE(found.exact.status == ExactDimension::Status::exact);
        const double exact = found.exact.value->enclosure(64).midpoint();
        REQUIRE(found.fit.estimate);
        CAPTURE(found.fit.estimate->value);
        CAPTURE(exact);
        CHECK(found.fit.estimate->low <= exact + 1e-9);
        CHECK(found.fit.estimate->high >= exact - 1e-9);
    }
}

TEST_CASE("components that follow on each other, and lower ones, do not lead boxes astray") {
    for (const char* text :
         {"axiom X; X -> F[+X]-X; F -> FF; angle 60", "axiom X; X -> F[+X]-X; F -> FF; angle 90",
          "axiom Y; Y -> YFX[+Y][-Y]; X -> X[-FFF][+FFF]FX; angle 180/7",
          "axiom Y; Y -> YFX[+Y][-Y]; X -> X[-FFF][+FFF]FX; angle 60",
          "axiom PffffffffffQ; P -> [P][fP][+f-P][f+f-P]; Q -> [Q][fQ][+f-Q][|f+f+Q]; f -> ff; "
          "interpret P -> F; interpret Q -> F; angle 90"}) {
        CAPTURE(text);
        const Counted found = counted(text, {8, 1, 30'000});
        REQUIRE(found.exact.status == ExactDimension::Status::exact);
        const double exact = found.exact.value->enclosure(64).midpoint();
        REQUIRE(found.fit.estimate);
        CAPTURE(found.fit.estimate->value);
        CAPTURE(found.fit.because);
        CHECK(found.fit.estimate->low <= exact + 1e-9);
        CHECK(found.fit.estimate->high >= exact - 1e-9);
        CHECK(found.fit.estimate->high - found.fit.estimate->low < 0.6);
    }
}

TEST_CASE("the rates that counts are freed of are those of the components") {
    const auto terms = [](const char* text) {
        return lower_terms(exact_dimension(read_lsystem(text, "a.lsys")));
    };
    const LowerTerms chain = terms("axiom X; X -> F[+X]-X; F -> FF; angle 60");
    CHECK(chain.chain == 2);
    CHECK(chain.rates.empty());
    const LowerTerms lower = terms("axiom Y; Y -> YFX[+Y][-Y]; X -> X[-FFF][+FFF]FX; angle 60");
    CHECK(lower.chain == 1);
    CHECK(lower.rates == std::vector<Rate>{Rate(2)});
    CHECK(terms("axiom F; F -> F+F--F+F; angle 60").chain == 1);
    CHECK(terms("axiom F; F -> FF-F-F-F-F-F+F; angle 90").largest == std::nullopt);  // coincide
}

TEST_CASE("an interval that does not hold the exact value is told as such") {
    const Counted counts = counted("axiom F; F -> F+F--F+F; angle 60", quick);
    DimensionReport report{"a curve", counts.exact, {}, counts.counts.boxes, counts.fit};
    const std::string told =
        "; the interval does not hold it: the measurement is wrong, not the exact value\n";
    CHECK(to_text(report).find("\n  error against the exact value: ") != std::string::npos);
    CHECK(to_text(report).find(told) == std::string::npos);
    CHECK(to_json(report).text().find("\"holds_exact\": true") != std::string::npos);
    report.fit.estimate = Estimate{1.3, 1.28, 1.32};
    CHECK(to_text(report).find("error against the exact value: +0.0381" + told) !=
          std::string::npos);
    CHECK(to_json(report).text().find("\"holds_exact\": false") != std::string::npos);
}

TEST_CASE("the boxes of Levy's curve do not pretend to be sure") {
    const Counted found = counted("axiom F; F -> +F--F+; angle 45", quick);
    CHECK(found.fit.because.find("interval is wide") != std::string::npos);
    CHECK(found.fit.estimate->high == 2);
    CHECK(found.fit.estimate->high - found.fit.estimate->low > 0.1);
}

TEST_CASE("nothing is measured above what the rules allow") {
    const Counted found = counted("axiom X; X -> F[+X]F[-X]+X; F -> FF; angle 20", quick);
    REQUIRE(found.exact.status == ExactDimension::Status::upper_bound);
    const double most = greatest_dimension(found.exact);
    CHECK(most == doctest::Approx(1.5849625));
    const BoxFit fit = fit_limit(found.counts, found.exact.meeting, most);
    REQUIRE(fit.estimate);
    CHECK(fit.estimate->low < fit.estimate->value);
    CHECK(fit.estimate->value <= most);
    CHECK(fit.estimate->high <= most);
}

TEST_CASE("boxes of the limit are those of a far generation") {
    // Against the vertices of generation 7, which lie 1/2187 apart, over grids of its own: in cells of
    // 1/72 they miss few.
    const Model system = read_lsystem("axiom F; F -> F+F--F+F; angle 60", "");
    const RecurrentSet set(system, *as_d0l(system));
    LimitCounting counting;
    counting.most_cells = 1000;
    const LimitCounts counts = limit_counts(set, counting);
    const std::size_t scale = 2;
    double sum = 0;
    constexpr int grids = 60;
    const double cell = counts.boxes.scales.cell(scale);
    for (int grid = 0; grid < grids; ++grid) {
        const double angle = 0.7 * grid, x0 = std::fmod(0.618 * grid, 1),
                     y0 = std::fmod(0.414 * grid, 1);
        std::set<std::pair<long, long>> cells;
        std::vector<std::complex<double>> points{0, 1};
        for (int level = 0; level < 7; ++level) {
            std::vector<std::complex<double>> next;
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                const auto step = (points[i + 1] - points[i]) / 3.0;
                next.insert(next.end(),
                            {points[i], points[i] + step,
                             points[i] + step + step * std::polar(1.0, std::numbers::pi / 3),
                             points[i] + 2.0 * step});
            }
            next.push_back(points.back());
            points = std::move(next);
        }
        for (const auto& point : points) {
            const auto turned = point * std::polar(1.0, angle) / cell;
            cells.emplace(std::lround(std::floor(turned.real() + x0)),
                          std::lround(std::floor(turned.imag() + y0)));
        }
        sum += static_cast<double>(cells.size());
    }
    CHECK(counts.boxes.mean(scale) == doctest::Approx(sum / grids).epsilon(0.04));
}

TEST_CASE("the counts of a seed do not change") {
    const Counted one = counted("axiom F; F -> F+F--F+F; angle 60", quick);
    const Counted two = counted("axiom F; F -> F+F--F+F; angle 60", quick);
    CHECK(one.counts.boxes.counts == two.counts.boxes.counts);
}

TEST_CASE("counting on the limit stops when it is asked to") {
    const Model system = read_lsystem("axiom F; F -> F+F--F+F; angle 60", "");
    const RecurrentSet set(system, *as_d0l(system));
    std::atomic<bool> stop = true;
    Budget budget;
    budget.stop = &stop;
    CHECK_THROWS_AS(limit_counts(set, {}, budget), Interrupted);
    budget.stop = nullptr;
    budget.memory = 100;
    CHECK_THROWS_AS(limit_counts(set, {}, budget), BoundReached);
}

TEST_CASE("a witness of a limit has every piece, and there is none without a limit") {
    ExactDimension nothing;
    nothing.status = ExactDimension::Status::exact;
    CHECK_FALSE(limit_witness(nothing));
    for (const char* text : {"axiom F; F -> F+F--F+F; angle 60",
                             "axiom A; A -> A+B; B -> A-B; interpret A -> F; interpret B -> F"}) {
        CAPTURE(text);
        const ExactDimension found = exact_dimension(read_lsystem(text, ""));
        const auto witness = limit_witness(found);
        REQUIRE(witness);
        CHECK(witness->pieces.size() == found.limit->size());
    }
}

TEST_CASE("a witness shows no neighbours where another component is as large as different parts") {
    // Of A, two of three parts coincide; B has as many different parts.
    const ExactDimension found = exact_dimension(
        read_lsystem("axiom A+B; A -> [A]AfA; B -> BfB; f -> fff; angle 90; interpret A -> F; "
                     "interpret B -> F",
                     ""));
    CHECK(found.status == ExactDimension::Status::exact);
    CHECK(found.value->decimal(6) == "0.630930");
    const auto witness = limit_witness(found);
    REQUIRE(witness);
    CHECK_FALSE(witness->neighbours);
}

TEST_CASE("lines of the limit touch as many cells as their length says") {
    // A segment of L cells touches 1 + 4 L / pi of them in the mean over all places and turns (Buffon),
    // and a T of two segments about as many: a few cells at the joint are counted twice here.
    struct Lines {
        const char* text;
        double length, size, more;
    };
    for (const auto& [text, length, size, more] :
         {Lines{"axiom F; F -> FF; f -> ff", 1, 1, 0.2},
          Lines{"axiom [FF][f-FFFFFFFF]; F -> FF; f -> ff", 10, 8, 3}}) {
        CAPTURE(text);
        const Model system = read_lsystem(text, "");
        LimitCounting counting;
        counting.places = 300;
        counting.most_cells = 200;
        const BoxCounts found = limit_counts(RecurrentSet(system, *as_d0l(system)), counting).boxes;
        REQUIRE(found.counts.size() >= 3);
        for (std::size_t scale = 0; scale < 3; ++scale) {
            const double expected =
                1 + 4 / std::numbers::pi * length / size / found.scales.cell(scale);
            CAPTURE(scale);
            CHECK(std::abs(found.mean(scale) - expected) < more + 0.01 * expected);
        }
    }
}

TEST_CASE("boxes do not depend on where the parts of a set begin, nor on how often each is drawn") {
    // Cantor's set, within a line, at its end, and at its beginning.
    const auto boxes = [](const char* text, bool coinciding) {
        const Model system = read_lsystem(text, "");
        LimitCounting counting;
        counting.places = 300;
        counting.most_cells = 200;
        counting.coinciding = coinciding;
        return limit_counts(RecurrentSet(system, *as_d0l(system)), counting).boxes;
    };
    const BoxCounts whole = boxes("axiom F; F -> FfF; f -> fff", false);
    for (const char* text :
         {"axiom F; F -> fFF; f -> fff", "axiom F; F -> FFf; f -> fff",
          "axiom F; F -> [fF][F]FFf; f -> fff", "axiom F; F -> [F]FfF; f -> fff"})
        for (const bool coinciding : {false, true}) {
            CAPTURE(text);
            CAPTURE(coinciding);
            const BoxCounts found = boxes(text, coinciding);
            REQUIRE(found.counts.size() == whole.counts.size());
            for (std::size_t scale = 0; scale < whole.counts.size(); ++scale)
                CHECK(found.mean(scale) == doctest::Approx(whole.mean(scale)).epsilon(0.04));
        }
}

TEST_CASE("counts that are sums of powers are fitted exactly") {
    LimitCounts limit;
    BoxCounts& boxes = limit.boxes;
    boxes.scales.ratio = 10;
    boxes.scales.coarsest = 0.5;
    boxes.scales.count = 12;
    for (std::size_t scale = 0; scale < boxes.scales.count; ++scale) {
        double sum = 0;
        for (const auto& [share, rate] : {std::pair(3, 10), {1, 2}, {5, 7}, {4, 6}, {2, 5}})
            sum += share * std::pow(rate, scale);
        boxes.counts.emplace_back(4, static_cast<std::uint64_t>(std::llround(sum)));
    }
    // The boundary and three further terms are taken out, the largest ones.
    LowerTerms lower;
    lower.rates = {Rate(7), Rate(6), Rate(5), Rate(4), Rate(3)};
    const BoxFit fit = fit_limit(limit, Rate(2), 2, lower);
    REQUIRE(fit.estimate);
    CHECK(fit.estimate->value == doctest::Approx(1));
    CHECK(fit.because.find("in the same way 7, 6, 5 from") != std::string::npos);
    // 3 * 10^j are 3 * coarsest / cell.
    CHECK(std::exp(fit.intercept) == doctest::Approx(3 * boxes.scales.coarsest));
}

TEST_CASE("slopes that come nearer by half each time are followed to their end") {
    LimitCounts limit;
    BoxCounts& boxes = limit.boxes;
    boxes.scales.ratio = 2;
    boxes.scales.coarsest = 0.125;
    double count = 1e9;
    for (const double slope : {1.3, 1.4, 1.45, 0.0}) {
        boxes.counts.emplace_back(4, static_cast<std::uint64_t>(count));
        count *= std::pow(2, slope);
    }
    boxes.scales.count = boxes.counts.size();
    const BoxFit fit = fit_limit(limit, std::nullopt, 2, {});
    REQUIRE(fit.estimate);
    CHECK(fit.estimate->value == doctest::Approx(1.5).epsilon(1e-6));
    // Three slopes lie between the last four scales.
    CHECK(fit.first == 0);
    CHECK(fit.last == 3);
}

TEST_CASE("counts of two places have an error, and a fit says what was taken out of it") {
    // (5 + 3 j) 10^j + 2^j: two components of the rate 10 follow on each other, and parts meet with 2.
    LimitCounts chain, slow;
    for (LimitCounts* limit : {&chain, &slow}) {
        limit->boxes.scales.ratio = 10;
        limit->boxes.scales.count = 10;
        for (std::size_t scale = 0; scale < limit->boxes.scales.count; ++scale) {
            const double j = static_cast<double>(scale);
            const double sum = limit == &chain
                                   ? (5 + 3 * j) * std::pow(10, j) + std::pow(2, j)
                                   : 3 * std::pow(10, j) + std::pow(2, j) + 5 * std::pow(7, j);
            limit->boxes.counts.emplace_back(2, static_cast<std::uint64_t>(std::llround(sum)));
        }
    }
    LowerTerms follow, slower;
    follow.chain = 2;
    follow.largest = Rate(10);
    slower.chain = 1;
    slower.rates = {Rate(7)};
    const BoxFit one = fit_limit(chain, Rate(2), 2, follow);
    const BoxFit other = fit_limit(slow, Rate(2), 2, slower);
    for (const BoxFit* fit : {&one, &other}) {
        REQUIRE(fit->estimate);
        CHECK(fit->estimate->value == doctest::Approx(1).epsilon(1e-6));
        CHECK(fit->estimate->high - fit->estimate->low < 1e-3);
    }
    CHECK(one.because.ends_with("in the same way 10 from components that follow on each other"));
    CHECK(other.because.ends_with("in the same way 7 from components that multiply more slowly"));
}

TEST_CASE("the error of two places is half of what their slopes differ by") {
    LimitCounts limit;
    BoxCounts& boxes = limit.boxes;
    boxes.scales.ratio = 2;
    for (std::size_t scale = 0; scale < 8; ++scale) {
        boxes.counts.emplace_back();
        for (const double slope : {1.2, 1.3})
            boxes.counts.back().push_back(
                static_cast<std::uint64_t>(1e6 * std::pow(2, slope * static_cast<double>(scale))));
    }
    boxes.scales.count = boxes.counts.size();
    const BoxFit fit = fit_limit(limit, std::nullopt, 2, {});
    REQUIRE(fit.estimate);
    // Three errors of 0.05.
    CHECK(fit.estimate->value - fit.estimate->low > 0.149);
    CHECK(fit.estimate->high - fit.estimate->value > 0.149);
}
