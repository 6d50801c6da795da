#include "nature/nature.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <complex>
#include <map>
#include <set>

#include "dimension/dimension.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"
#include "nature/detail/iterated_functions.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

using Complex = std::complex<double>;

/// The ends of all strokes.
struct Ends : Canvas {
    std::vector<Complex> points;
    void move_to(Point point) override { points.emplace_back(point.x, point.y); }
    void line_to(Point point) override { points.emplace_back(point.x, point.y); }
    void polygon(std::span<const Point>) override {}
    void width(double) override {}
    void width_as_length(double) override {}
    void colour(std::uint32_t) override {}
    void position(double) override {}
};

/// Whether every point of `first` is within `distance` of one of `second`.
bool reaches(const std::vector<Complex>& first, const std::vector<Complex>& second,
             double distance) {
    std::map<std::pair<long, long>, std::vector<Complex>> cells;
    const auto cell = [&](Complex p) {
        return std::pair(std::lround(std::floor(p.real() / distance)),
                         std::lround(std::floor(p.imag() / distance)));
    };
    for (const Complex& p : second) cells[cell(p)].push_back(p);
    for (const Complex& p : first) {
        const auto [x, y] = cell(p);
        bool near = false;
        for (long i = x - 1; i <= x + 1; ++i)
            for (long j = y - 1; j <= y + 1 && !near; ++j)
                if (const auto found = cells.find({i, j}); found != cells.end())
                    for (const Complex& q : found->second)
                        near = near || std::abs(p - q) <= distance;
        if (!near) return false;
    }
    return true;
}

struct Curve {
    const char* text;
    std::uint64_t generation;
    bool exact;  // every generation's way is mu times that before
};

const Curve curves[] = {
    {"axiom F; F -> F+F--F+F; angle 60", 8, true},                               // Koch
    {"axiom F; F -> F+G; G -> F-G; angle 90", 10, true},                         // dragon
    {"axiom L; L -> +RF-LFL-FR+; R -> -LF+RFR+FL-; angle 90", 8, false},         // Hilbert
    {"axiom F; F -> F+G++G-F--FF-G+; G -> -F+GG++G+F--F-G; angle 60", 5, true},  // Gosper
    {"axiom F; F -> F+F-F; angle 120", 10, true},                                // terdragon
    {"axiom F; F -> G-F-G; G -> F+G+F; angle 60", 10, true},                     // arrowhead
    {"axiom X; X -> F[+X]F[-X]+X; F -> FF; angle 20", 8, false},                 // plant
};

ExactDimension functions_of(const std::string& maps) {
    const auto read = read_generator(maps, "maps.ifs");
    return dynamic_cast<const IteratedFunctions&>(*read).exact_dimension({}).value();
}

}  // namespace

TEST_CASE("the attractor of a curve's functions is near its late generations") {
    for (const Curve& curve : curves) {
        INFO(curve.text);
        const Model system = read_lsystem(curve.text, "curve.lsys");
        const IteratedFunctions functions = functions_of_curve(system);
        const RecurrentSet set(system, *as_d0l(system));
        const auto figure = algae::figure(system, curve.generation, {});
        Ends ends;
        figure->draw(ends, 0, {});
        // The way of the whole in the limit, over that of this generation.
        const auto& last = set.axiom().back();
        const Complex way = set.displacement().value(set.displacement().way(last.piece));
        const auto& end = figure->facts().end;
        const Complex scale = way / Complex(end[0].value(), end[1].value());
        for (Complex& point : ends.points) point *= scale;
        // A stroke begins a piece of the last level, which lies in a disc.
        double widest = 0;
        for (std::size_t piece = 0; piece < set.size(); ++piece)
            widest = std::max(widest, std::abs(set.disc(piece).centre) + set.disc(piece).radius);
        const double ratio = std::pow(set.displacement().ratio(), -double(curve.generation));
        // Where ways only come near to multiples, they differ by what is left of the step.
        const double bound = widest * ratio + std::abs(scale) * (curve.exact ? 1 : 4) + 1e-9;
        std::vector<Complex> points;
        const double accuracy = bound / 4;
        send_attractor(functions, accuracy,
                       [&](std::span<const Dot> dots) {
                           for (const Dot& dot : dots)
                               points.emplace_back(dot.place.x, dot.place.y);
                       },
                       {});
        const Box box = attractor_boxes(functions).front();
        CHECK(bound < std::max(box.breadth(), box.height()) / 8);
        CHECK(reaches(ends.points, points, bound + accuracy));
        CHECK(reaches(points, ends.points, bound));
    }
}

TEST_CASE("the similarity dimension of a curve's functions is the curve's exact dimension") {
    for (const Curve& curve : curves) {
        INFO(curve.text);
        const Model system = read_lsystem(curve.text, "curve.lsys");
        Budget brief;  // the plant's parts meet in many ways
        brief.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
        const ExactDimension exact = exact_dimension(system, brief);
        REQUIRE(exact.similarity);
        const std::string text = converted(curve.text, "curve.lsys", "lsys", "ifs", {});
        const auto read = read_generator(text, "curve.ifs");
        const ExactDimension mine =
            similarity_dimension(dynamic_cast<const IteratedFunctions&>(*read));
        REQUIRE(mine.value);
        CHECK(mine.value->text() == exact.similarity->text());
        if (exact.status == ExactDimension::Status::exact)
            CHECK(mine.value->text() == exact.value->text());
    }
}

TEST_CASE("the boundary of an attractor is that of the curve whose functions they are") {
    // The curve's by the ways in which its parts meet, the attractor's by the cells that it does not cover.
    const std::pair<const char*, const char*> known[] = {
        {"axiom F; F -> F+G; G -> F-G; angle 90", "1.523627086"},
        {"axiom F; F -> F+F-F; angle 120", "1.261859507"},
        {"axiom A; A -> A-B--B+A++AA+B-; B -> +A-BB--B-A++A+B; angle 60; interpret A -> F; "
         "interpret B -> F",
         "1.129150068"},
        {"axiom F; F -> F+F-F-FF+F+F-F+F; angle 90", nullptr},
        {"axiom F; F -> +F--F+; angle 45", "1.934007183"},
    };
    std::size_t compared = 0;
    for (const auto& [text, value] : known) {
        INFO(text);
        const ExactDimension exact = exact_dimension(read_lsystem(text, "curve.lsys"));
        const auto read =
            read_generator(converted(text, "curve.lsys", "lsys", "ifs", {}), "curve.ifs");
        const auto mine = dynamic_cast<const IteratedFunctions&>(*read).exact_dimension({});
        REQUIRE(mine);
        REQUIRE(mine->value);
        CHECK(mine->boundary.has_value() == exact.boundary.has_value());
        if (!mine->boundary || !exact.boundary) continue;
        CHECK(mine->boundary->decimal(20) == exact.boundary->decimal(20));
        if (value) CHECK(mine->boundary->decimal(9) == value);
        ++compared;
    }
    CHECK(compared >= 4);
    MESSAGE(compared << " boundaries");
    const auto square = functions_of(
        "similarity 1/2 0 0 0\nsimilarity 1/2 0 1/2 0\nsimilarity 1/2 0 0 1/2\n"
        "similarity 1/2 0 1/2 1/2\n");
    CHECK(square.boundary->text() == "log 2 / log 2 = 1");
    CHECK(!functions_of("similarity 1/2 0 0 0\nsimilarity 1/2 0 1/2 0\n").boundary);
}

TEST_CASE("the functions of curves are exact where those of the curves are") {
    const std::pair<const char*, const char*> known[] = {
        {"axiom F; F -> F+F--F+F; angle 60", "log 4 / log 3"},
        {"axiom F; F -> F+G; G -> F-G; angle 90", "log 2 / log sqrt 2 = 2"},
        {"axiom F; F -> +F--F+; angle 45", "log 2 / log sqrt 2 = 2"},
        {"axiom F; F -> F+F-F; angle 120", "log 3 / log sqrt 3 = 2"},
        {"axiom F; F -> G-F-G; G -> F+G+F; angle 60", "log 3 / log 2"},
        {"axiom F; F -> F+G++G-F--FF-G+; G -> -F+GG++G+F--F-G; angle 60", "log 7 / log sqrt 7 = 2"},
    };
    for (const auto& [text, formula] : known) {
        INFO(text);
        const IteratedFunctions functions = functions_of_curve(read_lsystem(text, "curve.lsys"));
        const ExactDimension found = similarity_dimension(functions);
        const auto read = read_generator(converted(text, "curve.lsys", "lsys", "ifs", {}), "a.ifs");
        const ExactDimension again =
            similarity_dimension(dynamic_cast<const IteratedFunctions&>(*read));
        CHECK(found.status == again.status);
        CHECK(found.value->decimal(9) == again.value->decimal(9));
        if (!formula) continue;
        CHECK(found.status == ExactDimension::Status::exact);
        CHECK(found.value->text() == formula);
    }
}
