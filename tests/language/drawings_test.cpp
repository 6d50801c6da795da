#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

// Different segments and boxes of figures, by a second route: words as strings, walked in doubles or by the compass points, points
// compared with each other point, and squares tried one by one.

using namespace algae;

namespace {

using Outcome = verify::Finding::Outcome;

struct Found {
    std::string verdict;
    std::vector<std::string> argument;
    nlohmann::ordered_json certificate;
    verify::Finding finding;
};

Found judged(const std::string& definitions, const std::string& theorem,
             const Budget& budget = {}) {
    const CheckedClaim checked = check(
        read_claim("claim T\n" + definitions + "\ntheorem " + theorem, "x.claim", {}), budget);
    Found all{verdict_text(checked.statements.at(0)),
              sentences(checked.statements.at(0).answer, *checked.claim.alphabet),
              certificate(checked),
              {}};
    all.finding = verify::check_certificate(all.certificate.dump(1), "x.json", {}).at(0);
    return all;
}

/// A turtle system as strings.
struct TextTurtle {
    std::string axiom;
    std::map<char, std::string> rules;
    std::string of_x, angle;
    double degrees = 90;
    bool clockwise = false;
    int start = 0, spin = 0;  // right angles

    std::string word(int n) const {
        std::string now = axiom;
        for (; n > 0; --n) {
            std::string next;
            for (const char letter : now)
                next += rules.contains(letter) ? rules.at(letter) : std::string(1, letter);
            now = next;
        }
        std::string told;
        for (const char letter : now) told += letter == 'X' ? of_x : std::string(1, letter);
        return told;
    }
    std::string text() const {
        const auto shown = [](const std::string& word) {
            return word.empty() ? std::string("ε") : word;
        };
        std::string made = "let G = D0L { axiom " + axiom;
        for (const auto& [letter, image] : rules)
            made += std::string("; ") + letter + " -> " + shown(image);
        made += "; interpret X -> " + shown(of_x) + "; angle " + angle;
        if (clockwise) made += "; turn clockwise";
        if (start != 0) made += "; start 1 2 " + std::to_string(90 * start);
        if (spin != 0) made += "; spin " + std::to_string(90 * spin);
        return made + " }";
    }
};

/// From the first to before the last, however small the case is to be.
int any(int from, int to) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(from, to)); }

std::string any_word(const std::string& letters, int most, int depth = 0) {
    std::string made;
    for (int i = any(0, most + 1); i > 0; --i) {
        if (depth < 2 && any(0, 5) == 0)
            made += "[" + any_word(letters, 3, depth + 1) + "]";
        else
            made += letters[static_cast<std::size_t>(any(0, static_cast<int>(letters.size())))];
    }
    return made;
}

TextTurtle any_turtle(bool right_angles) {
    TextTurtle made;
    made.axiom = "F" + any_word("FX+-", 3);
    made.rules = {{'F', any_word("FFFXf+-|", 5)}, {'X', any_word("FXf+-", 4)}};
    made.of_x = *rc::gen::element<std::string>("", "F", "f+F", "[-F]");
    static const std::vector<std::pair<std::string, double>> angles{
        {"90", 90}, {"60", 60},           {"45", 45},   {"36", 36}, {"72", 72},
        {"20", 20}, {"180/7", 180.0 / 7}, {"120", 120}, {"24", 24}, {"0", 0}};
    std::tie(made.angle, made.degrees) =
        right_angles ? *rc::gen::element(angles[0], std::pair<std::string, double>{"180", 180},
                                         std::pair<std::string, double>{"-90", -90})
                     : *rc::gen::elementOf(angles);
    made.clockwise = *rc::gen::arbitrary<bool>();
    made.start = any(0, 4);
    made.spin = any(0, 4);
    return made;
}

/// Calls `step` with the number of the heading and whether it draws; places are kept by `save` and `restore`.
template <class Place, class Step>
void walk(const std::string& word, Place place, double degrees, double heading, Step step) {
    std::vector<std::pair<Place, double>> saved;
    for (const char command : word) {
        if (command == 'F' || command == 'f') {
            const Place from = place;
            place = step(from, heading, command == 'F');
        }
        if (command == '+') heading += degrees;
        if (command == '-') heading -= degrees;
        if (command == '|') heading += 180;
        if (command == '[') saved.emplace_back(place, heading);
        if (command == ']') {
            std::tie(place, heading) = saved.back();
            saved.pop_back();
        }
    }
}

std::size_t segments_of(const TextTurtle& system, const std::string& word) {
    using Point = std::complex<double>;
    std::vector<Point> points;
    const auto number = [&](Point point) {
        for (std::size_t i = 0; i < points.size(); ++i)
            if (std::abs(points[i] - point) < 1e-9) return i;
        points.push_back(point);
        return points.size() - 1;
    };
    std::set<std::set<std::size_t>> seen;
    walk(word, Point(), system.clockwise ? -system.degrees : system.degrees, 0,
         [&](Point from, double heading, bool drawn) {
             const Point to = from + std::polar(1.0, heading * std::numbers::pi / 180);
             if (drawn) seen.insert({number(from), number(to)});
             return to;
         });
    return seen.size();
}

/// Squares with the corner (a side, b side) that meet a segment: there is a point of both.
std::size_t boxes_of(const TextTurtle& system, const std::string& word, int n,
                     const Rational& side) {
    using Point = std::pair<int, int>;
    std::vector<std::pair<Point, Point>> drawn;
    int reach = 1;
    walk(word, Point(), system.clockwise ? -system.degrees : system.degrees,
         90.0 * (system.start + n * system.spin), [&](Point from, double heading, bool is_drawn) {
             static const std::array<Point, 4> ways{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
             const int quarter = ((static_cast<int>(std::lround(heading / 90)) % 4) + 4) % 4;
             const Point way = ways[static_cast<std::size_t>(quarter)];
             const Point to{from.first + way.first, from.second + way.second};
             if (is_drawn) drawn.emplace_back(std::min(from, to), std::max(from, to));
             if (is_drawn)
                 for (const int c : {from.first, from.second, to.first, to.second})
                     reach = std::max(reach, std::abs(c));
             return to;
         });
    const auto meets = [&](int low, int high, int corner) {  // on one axis
        const Rational left = side * Rational(corner), right = side * Rational(corner + 1);
        return std::max(Rational(low), left) <= Rational(high) &&
               std::max(Rational(low), left) < right;
    };
    const int most = 2 + static_cast<int>((Rational(reach) / side).to_double());
    std::size_t count = 0;
    for (int a = -most; a <= most; ++a) {
        std::vector<std::pair<Point, Point>> column = drawn;
        std::erase_if(
            column, [&](const auto& one) { return !meets(one.first.first, one.second.first, a); });
        for (int b = -most; b <= most && !column.empty(); ++b)
            count += std::any_of(column.begin(), column.end(), [&](const auto& one) {
                return meets(one.first.second, one.second.second, b);
            });
    }
    return count;
}

void expect_number(const TextTurtle& system, const std::string& term, std::size_t number) {
    const Found right = judged(system.text(), term + " = " + std::to_string(number));
    RC_ASSERT(right.verdict == "proved");
    RC_ASSERT(right.finding.outcome == Outcome::checked);
    const Found wrong = judged(system.text(), term + " = " + std::to_string(number + 1));
    RC_ASSERT(wrong.verdict == "refuted");
    RC_ASSERT(wrong.finding.outcome == Outcome::checked);
    // A certificate that says the other verdict is rejected.
    auto turned = right.certificate;
    turned["statements"][0]["verdict"] = "refuted";
    RC_ASSERT(verify::check_certificate(turned.dump(), "x", {}).at(0).outcome == Outcome::wrong);
}

}  // namespace

TEST_CASE("different segments are those of a walk in doubles") {
    int compared = 0, repeated = 0;
    CHECK(rc::check([&] {
        const TextTurtle system = any_turtle(false);
        const int n = any(0, 4);
        const std::string word = system.word(n);
        RC_PRE(word.size() < 600);
        const std::size_t number = segments_of(system, word);
        expect_number(system, "distinct segments(G, " + std::to_string(n) + ")", number);
        ++compared;
        repeated += number < static_cast<std::size_t>(std::count(word.begin(), word.end(), 'F'));
    }));
    CHECK(compared >= 90);
    CHECK(repeated >= 5);
}

TEST_CASE("boxes are those that a search through all squares finds") {
    int compared = 0, large = 0;
    CHECK(rc::check([&] {
        const TextTurtle system = any_turtle(true);
        const int n = any(0, 4);
        const std::string word = system.word(n);
        RC_PRE(word.size() < 80);
        const std::string side = *rc::gen::element<std::string>("1", "2", "1/2", "3/2", "5/3");
        const std::size_t number = boxes_of(system, word, n, Rational(side));
        expect_number(system, "boxes(G, " + std::to_string(n) + ", " + side + ")", number);
        ++compared;
        large += number > 8;
    }));
    CHECK(compared >= 90);
    CHECK(large >= 1);
}

TEST_CASE("figures of the catalogue have as many different segments as it says") {
    const std::vector<std::array<std::string, 2>> known{
        {"F; F -> F+F--F+F; angle 60", "distinct segments(G, 3) = 64"},
        {"F--F--F; F -> F+F--F+F; angle 60", "distinct segments(G, 4) = 768"},
        {"F; F -> F[+F]F[-F][F]; angle 20; start 0 0 90", "distinct segments(G, 5) = 1760"},
        {"F; F -> FF-[-F+F+F]+[+F-F-F]; angle 22.5", "distinct segments(G, 4) = 3344"},
        {"X; X -> F[+X][-X]FX; F -> FF; angle 180/7", "distinct segments(G, 7) = 4118"},
        {"X; X -> F[+X][+X]FX; F -> FF; angle 180/7", "distinct segments(G, 7) = 896"},
        {"F-F-F-F; F -> FF-F-F-F-F; angle 90", "distinct segments(G, 4) = 544"},
        {"F; F -> F-F+F; angle 120", "distinct segments(G, 5) = 243"}};
    for (const auto& [system, statement] : known) {
        INFO(system << " " << statement);
        const Found found = judged("let G = D0L { axiom " + system + " }", statement);
        CHECK(found.verdict == "proved");
        CHECK(found.finding.outcome == Outcome::checked);
    }
}

TEST_CASE("terms of figures stand in sums and in statements about bounded numbers") {
    const std::string dragon =
        "let D = D0L { axiom X; X -> X+Y; Y -> X-Y; interpret X -> F; interpret Y -> F }\n"
        "let H = D0L { axiom R; L -> +RF-LFL-FR+; R -> -LF+RFR+FL-; start 0 0 90 }";
    for (const std::string statement :
         {"for all numbers n <= 8: distinct segments(D, n) = segments(D, n)",
          "for all numbers n <= 3: boxes(H, n + 1, 1) = 4^(n+1) and boxes(H, n + 1, 2^(n+1)) = 1",
          "2*distinct segments(D, 3) + boxes(H, 1, 1/2) = 16 + 7",
          "for some numbers n <= 3: distinct segments(H, n) > 60",
          "distinct segments(D, 2) < distinct segments(D, 3) and not distinct segments(D, 0) = 2",
          "segments(D, n) >= 0*distinct segments(D, 4)"}) {
        INFO(statement);
        const Found found = judged(dragon, statement);
        CHECK(found.verdict.starts_with("proved"));
        CHECK_MESSAGE(found.finding.outcome == Outcome::checked, found.finding.reason);
        CHECK(found.certificate["turtles"].contains("D") ==
              (statement.find("ments(D") != std::string::npos &&
               statement.find("distinct segments(D") != std::string::npos));
    }
    // A letter that never comes is told the turtle too.
    const Found rare =
        judged("let G = D0L { axiom F; F -> FF; Y -> F+Z; Z -> Y; interpret Z -> F }",
               "distinct segments(G, 3) = 8");
    CHECK(rare.finding.outcome == Outcome::checked);
    const Found said = judged(dragon, "distinct segments(D, 3) = 2^3");
    CHECK(said.argument.size() == 1);
    CHECK(said.argument.front() == "distinct segments(D,3) is 8, 2^3 is 8.");
    CHECK(said.certificate["turtles"].dump() ==
          R"({"D":{"turn":"1/4","letters":{"X":"F","+":"+","Y":"F","-":"-"}}})");
}

TEST_CASE("what cannot be counted of a figure is told") {
    const std::string koch =
        "let K = D0L { axiom F; F -> F+F--F+F; angle 60 }\n"
        "let E = D0L { axiom F; F -> FF }";
    const auto told = [&](const std::string& statement) {
        INFO(statement);
        const Found found = judged(koch, statement);
        CHECK(found.verdict == "undecided");
        return found.argument.empty() ? std::string() : found.argument.front();
    };
    CHECK(told("distinct segments(K, n) = 4^n") ==
          "x.claim:4:9: expected the figure of one generation, such as distinct segments(G, 3), or "
          "a bound of "
          "the numbers, such as 'for all numbers n <= 4:', found distinct segments(K,n)");
    CHECK(told("boxes(E, 2, 0) = 4") ==
          "x.claim:4:21: expected a side of boxes above 0, in steps, such as 1 or 1/3, found 0");
    CHECK(told("boxes(E, 2, sqrt(2)) = 4").find("expected a side of boxes") != std::string::npos);
    CHECK(told("distinct segments(K, 1/2) = 4") ==
          "x.claim:4:30: expected the number of a generation, found 1/2");
    CHECK(told("distinct segments(E, 30) = 4").find("more than") != std::string::npos);
    CHECK(told("distinct segments(E, 10^30) = 4").find("up to generation 100000") !=
          std::string::npos);
    CHECK(told("boxes(E, 3, 1/10^9) = 4").find("more than 1000000 boxes are not counted") !=
          std::string::npos);
}
