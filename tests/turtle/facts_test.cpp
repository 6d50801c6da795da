#include <doctest/doctest.h>
#include <fmt/format.h>
#include <rapidcheck.h>

#include <complex>
#include <numbers>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/any_turtle.hpp"
#include "turtle/recording.hpp"

using namespace algae;
using oracle::Real;

namespace {

/// A coordinate against the oracle's: the number, and whether it is rational and which.
void check_coordinate(const Coordinate& found, Real expected, std::optional<long> twice,
                      const Rational& factor, const Rational& offset) {
    RC_ASSERT(near(static_cast<Real>(found.value()), expected));
    RC_ASSERT(found.rational().has_value() == twice.has_value());
    if (twice) RC_ASSERT(*found.rational() == Rational(Integer(*twice), 2) * factor + offset);
}

Rational rational(const oracle::Fraction& fraction) {
    return Rational(Integer(fraction.numerator), Integer(fraction.denominator));
}

void check_facts(const oracle::WrittenSystem& written, const oracle::TurtleSettings& settings,
                 unsigned n) {
    const auto drawing = oracle::drawing_of(oracle::rewritten(written, n), settings, n);
    const auto figure = algae::figure(drawn_system(written, settings), n, Budget());
    const Facts& facts = figure->facts();
    RC_ASSERT(facts.segments == drawing.strokes.size());
    RC_ASSERT(figure->segments() == drawing.strokes.size());
    RC_ASSERT(facts.end.size() == 2u);
    RC_ASSERT(near(static_cast<Real>(facts.end[0].value()), drawing.end.real()));
    RC_ASSERT(near(static_cast<Real>(facts.end[1].value()), drawing.end.imag()));
    if (drawing.points.empty()) {
        RC_ASSERT(figure->box().empty);
        RC_ASSERT(facts.low.empty());
        RC_ASSERT(facts.high.empty());
    } else {
        oracle::Spot low = drawing.points[0], high = low;
        for (const oracle::Spot point : drawing.points) {
            low = {std::min(low.real(), point.real()), std::min(low.imag(), point.imag())};
            high = {std::max(high.real(), point.real()), std::max(high.imag(), point.imag())};
        }
        const Box& box = figure->box();
        RC_ASSERT(!box.empty);
        RC_ASSERT(near(low, oracle::Spot(box.low.x, box.low.y)));
        RC_ASSERT(near(high, oracle::Spot(box.high.x, box.high.y)));
        RC_ASSERT(near(static_cast<Real>(facts.low[0].value()), low.real()));
        RC_ASSERT(near(static_cast<Real>(facts.high[1].value()), high.imag()));
    }
    const bool exact = drawing.order <= 360 && drawing.polygons.empty() && !settings.scale;
    if (!exact) return;
    RC_ASSERT(facts.exact);
    Rational unit = rational(settings.step);
    for (unsigned k = 0; k < n; ++k) unit *= rational(settings.shrink);
    const long m = drawing.order;
    check_coordinate(facts.end[0], drawing.end.real(),
                     oracle::twice_real_part(drawing.exact_end, m), unit, rational(settings.x));
    check_coordinate(facts.end[1], drawing.end.imag(),
                     oracle::twice_imaginary_part(drawing.exact_end, m), unit,
                     rational(settings.y));
    if (drawing.touched.empty()) return;
    std::size_t highest = 0;
    for (std::size_t i = 1; i < drawing.points.size(); ++i)
        if (drawing.points[i].imag() > drawing.points[highest].imag()) highest = i;
    check_coordinate(facts.high[1], drawing.points[highest].imag(),
                     oracle::twice_imaginary_part(drawing.touched[highest], m), unit,
                     rational(settings.y));
}

}  // namespace

TEST_CASE("the cyclotomic polynomials of the second route are the known ones") {
    CHECK(oracle::cyclotomic_polynomial(4) == oracle::Polynomial{1, 0, 1});
    CHECK(oracle::cyclotomic_polynomial(12) == oracle::Polynomial{1, 0, -1, 0, 1});
    CHECK(oracle::cyclotomic_polynomial(72).size() == 25);
}

TEST_CASE("end, box and segments are those of walking letter by letter") {
    const bool holds = rc::check("bracketed systems, any turtle", [] {
        const auto written = *oracle::any_bracketed();
        const auto settings = *any_turtle();
        const unsigned n = oracle::last_generation_within(written, 400, 4);
        check_facts(written, settings, n);
    });
    CHECK(holds);
}

TEST_CASE("the same with polygons, sizes, widths, colours and cut branches") {
    const bool holds = rc::check("all commands", [] {
        auto written = *oracle::any_bracketed("*!'.%");
        auto settings = *any_turtle();
        settings.scale = oracle::Fraction{3, 4};
        settings.narrow = oracle::Fraction{1, 2};
        if (*rc::gen::arbitrary<bool>()) written.axiom = "{" + written.axiom + "}F";
        const unsigned n = oracle::last_generation_within(written, 400, 4);
        std::string word = oracle::rewritten(written, n);
        RC_PRE(written.axiom[0] != '{' || word.find('%') == std::string::npos);
        check_facts(written, settings, n);
    });
    CHECK(holds);
}

TEST_CASE("segments of cut branches are not counted") {
    const auto segments = [](const char* axiom) {
        return figure(drawn_system({axiom, {}}, {}), 0, Budget())->segments();
    };
    CHECK(segments("F[F%FF]F") == 3);
    CHECK(segments("F[F%F[F]F]F%FF") == 3);
    CHECK(segments("%F") == 0);
    CHECK(segments("F[{F%F}F]F") == 3);  // the polygon ends with its branch
    CHECK(segments("{F%F}") == 1);
}

TEST_CASE("the box of a long word without a lattice is that of walking") {
    // Words longer than 3 * 10^5 letters are measured by their parts.
    const char* const successors[] = {"F[+F]F[-F]F", "FF-[-F+F+F]+[+F-F-F]", "F+F--F+F",
                                      "[+F][-F]FF", "F-F+F[+F]"};
    std::size_t compared = 0;
    for (const char* const successor : successors)
        for (const double angle : {25.7, 33.3, 101.9, 7.13}) {
            std::string word = "F";
            unsigned n = 0;
            for (; word.size() < 400'000; ++n) {
                std::string next;
                for (const char letter : word)
                    next += letter == 'F' ? successor : std::string(1, letter);
                word = std::move(next);
            }
            std::complex<long double> at = 0;
            long double heading = 0, low = 0, high = 0, lowest = 0, highest = 0;
            std::vector<std::pair<std::complex<long double>, long double>> kept;
            for (const char letter : word) {
                const auto turn = std::numbers::pi_v<long double> / 180 * angle;
                if (letter == '+') heading += turn;
                if (letter == '-') heading -= turn;
                if (letter == '[') kept.emplace_back(at, heading);
                if (letter == ']') {
                    std::tie(at, heading) = kept.back();
                    kept.pop_back();
                }
                if (letter != 'F') continue;
                at += std::polar(1.0L, heading);
                low = std::min(low, at.real()), high = std::max(high, at.real());
                lowest = std::min(lowest, at.imag()), highest = std::max(highest, at.imag());
            }
            const std::string text = "axiom F\nF -> " + std::string(successor) + "\nangle " +
                                     fmt::format("{}", angle) + "\n";
            const auto drawn = algae::figure(read_lsystem(text, "long"), n, Budget());
            const Box& box = drawn->box();
            const long double size = std::max(high - low, highest - lowest);
            for (const auto& [found, expected] :
                 {std::pair<long double, long double>{box.low.x, low},
                  {box.high.x, high},
                  {box.low.y, lowest},
                  {box.high.y, highest}}) {
                CAPTURE(text);
                CHECK(std::abs(found - expected) < 1e-10L * size);
                ++compared;
            }
        }
    CHECK(compared == 80);
}

TEST_CASE("facts of far generations are exact and quick") {
    const oracle::WrittenSystem dragon{"FX", {{'X', {"X+YF+"}}, {'Y', {"-FX-Y"}}}};
    const auto figure = algae::figure(drawn_system(dragon, {}), 1000, Budget());
    CHECK(figure->facts().exact);
    CHECK(figure->segments() == power(Integer(2), 1000));
    // The dragon's end turns by 45 degrees and grows by sqrt(2) a generation: (1 + i)^1000 = 2^500.
    CHECK(figure->facts().end[0].rational() == Rational(power(Integer(2), 500)));
    CHECK(figure->facts().end[1].rational() == Rational(0));
}

TEST_CASE("a step that is no rational number does not make far generations slow") {
    // 2^30 letters that fill the plane: the end stays where it is, because sqrt(2) is undone.
    Model system = drawn_system({"FX", {{'X', {"X+YF+"}}, {'Y', {"-FX-Y"}}}}, {});
    system.drawing.shrink = quantity(Rational(1));
    system.drawing.shrink->exact.reset();
    system.drawing.shrink->value = std::sqrt(0.5);
    system.drawing.spin = quantity(Rational(-45));
    const auto figure = algae::figure(system, 30, Budget());
    CHECK(!figure->facts().exact);
    CHECK(figure->segments() == power(Integer(2), 30));
    CHECK(std::abs(figure->facts().end[0].value() - 1) < 1e-9);
    CHECK(std::abs(figure->facts().end[1].value()) < 1e-9);
    CHECK(figure->box().breadth() == doctest::Approx(1.5).epsilon(1e-3));
    CHECK(figure->box().height() == doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE("an angle that is no part of a turn does not make far generations slow") {
    // Fills the plane nearly as the dragon does.
    oracle::TurtleSettings settings;
    settings.angle = {8999, 100};
    const oracle::WrittenSystem dragon{"FX", {{'X', {"X+YF+"}}, {'Y', {"-FX-Y"}}}};
    Budget budget;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    const auto far = figure(drawn_system(dragon, settings), 40, budget);
    CHECK(far->segments() == power(Integer(2), 40));
    CHECK(!far->box().empty);
}

TEST_CASE("a bracket that is interpreted is not a branch") {
    Model system = drawn_system({"F[+F]F", {}}, {});
    const auto interpret = [&](const char* symbol, const char* successor) {
        Production rule;
        rule.predecessor.symbol = system.alphabet.symbol(symbol);
        for (const char* c = successor; *c; ++c)
            rule.successor.letters.push_back(system.alphabet.symbol(std::string(1, *c)));
        system.interpretation.push_back(rule);
    };
    interpret("[", "F");
    interpret("]", "+");
    const auto figure = algae::figure(system, 0, Budget());  // F F + F + F
    CHECK(figure->segments() == 4);
    CHECK(figure->facts().end[0].value() == doctest::Approx(1));
    CHECK(figure->facts().end[1].value() == doctest::Approx(1));
}

TEST_CASE("brackets that fall apart while deriving are an error with generation and letter") {
    const auto complaint = [](const oracle::WrittenSystem& written,
                              std::uint64_t n) -> std::string {
        try {
            figure(drawn_system(written, {}), n, Budget());
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    CHECK(complaint({"F[F]F", {{'[', {""}}}}, 0) == "");
    CHECK(complaint({"F[F]F", {{'[', {""}}}}, 1) ==
          "generation 1 of written, position 2: unmatched ']'");
    CHECK(complaint({"F[F]F", {{']', {""}}}}, 2) == "generation 2 of written: '[' is never closed");
    CHECK(complaint({"F}", {}}, 0) == "generation 0 of written, position 1: unmatched '}'");
    CHECK(complaint({"{F", {}}, 0) == "generation 0 of written: '{' is never closed");
}

TEST_CASE("a word of a system with choices is drawn as its generation is") {
    oracle::TurtleSettings settings;
    settings.shrink = {1, 2};
    Model system = drawn_system({"F", {{'F', {"F+F", "FF"}}}}, settings);
    CHECK_THROWS_WITH_AS(figure(system, 1, Budget()),
                         "cannot draw written: not a D0L system: F has 2 rules", Error);
    const Symbol draw = *system.alphabet.find("F");
    const auto figure = algae::figure(system, Word{draw, draw}, 1, Budget());
    CHECK(figure->segments() == 2);
    CHECK(figure->facts().end[0].rational() == Rational(1));
}
