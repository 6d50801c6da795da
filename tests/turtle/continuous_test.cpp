#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <complex>
#include <map>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/detail/module_turtle.hpp"
#include "turtle/turtle.hpp"

// Growth between two generations: by ContinuousDevelopment, and by a recursion over strings that knows nothing of modules.

using namespace algae;

namespace {

struct Line {
    std::complex<double> from, to;
};

/// The strokes and the end of a walk.
struct Strokes : TurtleEvents {
    void stroke(const Vector& from, const TurtleState& state) override {
        lines.push_back({{from.x, from.y}, {state.position.x, state.position.y}});
    }
    std::vector<Line> lines;
};

std::vector<Line> strokes_of(const Model& system, const DerivedModules& derived, std::uint64_t n) {
    Strokes strokes;
    ModuleTurtle(system, derived.kinds, n, derived.seed).walk(derived.word, strokes);
    return strokes.lines;
}

std::vector<Line> strokes_of(const Model& system, std::uint64_t n) {
    return strokes_of(system, derived_modules(system, n, {}, {}), n);
}

std::vector<Line> grown(const Model& system, std::uint64_t n, double share) {
    const ContinuousDevelopment development(system, n, {}, {});
    return strokes_of(development.system(), development.at(share), n + 1);
}

double length(const std::vector<Line>& lines) {
    double sum = 0;
    for (const Line& line : lines) sum += std::abs(line.to - line.from);
    return sum;
}

/// The farthest that a point of one polyline lies from the strokes of the other.
double distance(const std::vector<Line>& from, const std::vector<Line>& to) {
    double most = 0;
    for (const Line& line : from)
        for (const std::complex<double> point : {line.from, line.to}) {
            double least = 1e300;
            for (const Line& other : to) {
                const std::complex<double> along = other.to - other.from;
                double at =
                    std::norm(along) > 0
                        ? ((point - other.from) * std::conj(along)).real() / std::norm(along)
                        : 0;
                at = std::min(1.0, std::max(0.0, at));
                least = std::min(least, std::abs(point - other.from - at * along));
            }
            most = std::max(most, least);
        }
    return most;
}

bool same(const std::vector<Line>& a, const std::vector<Line>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (std::abs(a[i].from - b[i].from) + std::abs(a[i].to - b[i].to) > 1e-9) return false;
    return true;
}

std::vector<Line> drawn(const std::vector<Line>& lines) {
    std::vector<Line> out;
    for (const Line& line : lines)
        if (std::abs(line.to - line.from) > 1e-12) out.push_back(line);
    return out;
}

Model read(const std::string& text) { return read_lsystem(text, "x.lsys"); }

}  // namespace

TEST_CASE("a stroke that becomes several begins as these in a line") {
    const Model koch = read("axiom F; F -> F+F--F+F; angle 60");
    const std::vector<Line> begin = grown(koch, 0, 0);
    REQUIRE(begin.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(std::abs(begin[i].from - 0.25 * static_cast<double>(i)) < 1e-12);
        CHECK(std::abs(begin[i].to - 0.25 * static_cast<double>(i + 1)) < 1e-12);
    }
    // Half way the strokes are 5/8 long and turn by half of their angles.
    const std::vector<Line> half = grown(koch, 0, 0.5);
    CHECK(std::abs(half[1].to - half[1].from - std::polar(0.625, M_PI / 6)) < 1e-12);
    CHECK(std::abs(half[2].to - half[2].from - std::polar(0.625, -M_PI / 6)) < 1e-12);
    CHECK(same(grown(koch, 0, 1), strokes_of(koch, 1)));
}

TEST_CASE(
    "what grows older has parameters on the way, and what is new beside it begins without length") {
    const Model plant = read("axiom F(1); F(x) -> F(3*x)[+(40)F(2)]-(20)G(x); angle 30");
    CHECK(same(drawn(grown(plant, 0, 0)), strokes_of(plant, 0)));
    const std::vector<Line> half = grown(plant, 0, 0.5);
    REQUIRE(half.size() == 3);
    CHECK(std::abs(half[0].to - 2.0) < 1e-12);
    CHECK(std::abs(half[1].to - half[1].from - std::polar(1.0, 40 * M_PI / 180)) < 1e-12);
    CHECK(std::abs(half[2].to - half[2].from - std::polar(0.5, -10 * M_PI / 180)) < 1e-12);
}

TEST_CASE(
    "leaves grow, rules interpret what is on the way, and the start turns with the generation") {
    const Model plant = read(
        "axiom A(0); A(t) -> F[+L]A(t+1); interpret A(t) : t < 0.25 -> G; interpret A(t) : t >= "
        "0.25 -> "
        "F(t); interpret L -> S; stamp S square; spin 90; shrink 1/2");
    CHECK(same(grown(plant, 1, 1), strokes_of(plant, 2)));
    // Before the quarter of the first step A is a stroke of one step, then its parameter.
    const ContinuousDevelopment development(plant, 0, {}, {});
    const auto last = [&](double share) {
        const auto lines = strokes_of(development.system(), development.at(share), 1);
        return std::abs(lines.back().to - lines.back().from);
    };
    CHECK(std::abs(last(0.2) - 0.5 * (0.8 * 2 + 0.2)) < 1e-12);
    CHECK(std::abs(last(0.5) - 0.5 * (0.5 * 2 + 0.5) * 0.5) < 1e-12);
    const auto at_first = strokes_of(development.system(), development.at(0), 1);
    const std::complex<double> way = at_first.back().to - at_first.back().from;
    CHECK(std::abs(way - 1.0) < 1e-12);  // heading and step are those of generation 0
}

TEST_CASE("systems that ask their surroundings, and shape rules, do not grow between generations") {
    CHECK_THROWS_WITH_AS(
        ContinuousDevelopment(read("axiom F?E(0); ?E(x) -> F?E(x); environment ?E y"), 0, {}, {}),
        "cannot grow x.lsys between generations: it has communication modules, which are asked "
        "once in "
        "each",
        Error);
    CHECK_THROWS_AS(ContinuousDevelopment(read("axiom A; A -> div(Y, 1r, 1r){ B B }"), 0, {}, {}),
                    Error);
    CHECK_THROWS_AS(ContinuousDevelopment(read("axiom F; F -> FF; F -> F"), 0, {}, {}), Error);
}

namespace {

/// A growing plane figure by recursion over plain strings: letters F and G draw, X does not, and + - [ ] are what they are.
class SlowGrowth {
public:
    SlowGrowth(std::map<char, std::string> rules, double angle)
        : rules_(std::move(rules)), angle_(angle) {}

    std::vector<Line> at(const std::string& word, double share) {
        lines_.clear();
        place_ = 0;
        heading_ = 0;
        saved_.clear();
        for (const char letter : word) {
            const auto rule = rules_.find(letter);
            if (rule == rules_.end()) {
                walk(letter, 1, 1);
                continue;
            }
            const std::string& to = rule->second;
            int own = 0, drawn = 0, depth = 0;
            std::size_t where = 0;
            for (std::size_t i = 0; i < to.size(); ++i) {
                depth += to[i] == '[' ? 1 : to[i] == ']' ? -1 : 0;
                if (depth > 0) continue;
                if (to[i] == letter) ++own, where = i;
                if (is_drawn(to[i])) ++drawn;
            }
            const bool goes_on = own == 1;
            for (std::size_t i = 0; i < to.size(); ++i) {
                depth += to[i] == '[' ? 1 : to[i] == ']' ? -1 : 0;
                const bool outside = depth == 0;
                if (goes_on && i == where)
                    walk(to[i], 1, 1);
                else if (!outside)
                    walk(to[i], share, 1);
                else if (!goes_on && is_drawn(letter) && drawn > 0)
                    walk(to[i], share + (1 - share) / drawn, share);
                else
                    walk(to[i], share, share);
            }
        }
        return lines_;
    }

private:
    static bool is_drawn(char letter) { return letter == 'F' || letter == 'G'; }

    void walk(char letter, double way, double turn) {
        if (letter == '[') saved_.emplace_back(place_, heading_);
        if (letter == ']') {
            std::tie(place_, heading_) = saved_.back();
            saved_.pop_back();
        }
        if (letter == '+') heading_ += angle_ * turn;
        if (letter == '-') heading_ -= angle_ * turn;
        if (!is_drawn(letter)) return;
        const auto to = place_ + std::polar(way, heading_ * M_PI / 180);
        lines_.push_back({place_, to});
        place_ = to;
    }

    std::map<char, std::string> rules_;
    double angle_;
    std::vector<Line> lines_;
    std::complex<double> place_;
    double heading_ = 0;
    std::vector<std::pair<std::complex<double>, double>> saved_;
};

std::string any_word(int most, int depth = 0) {
    std::string out;
    for (int i = *rc::gen::inRange(1, most + 1); i > 0; --i) {
        const char letter = *rc::gen::element('F', 'F', 'G', 'X', '+', '-', '[');
        if (letter != '[')
            out += letter;
        else if (depth < 2)
            out += '[' + any_word(3, depth + 1) + ']';
    }
    return out;
}

}  // namespace

TEST_CASE("growth is that of a recursion over strings, and joins the figures of the generations") {
    int compared = 0, joined = 0;
    CHECK(rc::check([&] {
        std::map<char, std::string> rules;
        for (const char letter : {'F', 'G', 'X'})
            if (*rc::gen::inRange(0, 4) > 0) rules[letter] = any_word(6);
        const std::string axiom = any_word(3);
        const int angle = *rc::gen::element(36, 60, 90, 25);
        std::string text = "axiom " + axiom + "\nangle " + std::to_string(angle) + "\n";
        for (const auto& [letter, to] : rules) text += std::string(1, letter) + " -> " + to + "\n";
        const Model system = read(text);
        const auto n = static_cast<std::uint64_t>(*rc::gen::inRange(0, 3));
        std::string word = axiom;
        for (std::uint64_t i = 0; i < n; ++i) {
            std::string next;
            for (const char letter : word)
                next += rules.count(letter) ? rules[letter] : std::string(1, letter);
            word = next;
        }
        RC_PRE(word.size() < 300);
        SlowGrowth slow(rules, angle);
        for (const double share : {0.0, 0.3, 0.75, 1.0}) {
            // A stroke without length may be left out by neither.
            const auto fast = grown(system, n, share);
            RC_ASSERT(same(fast, slow.at(word, share)));
            ++compared;
        }
        RC_ASSERT(same(grown(system, n, 1), strokes_of(system, n + 1)));
        // At the beginning it is the earlier figure, unless a stroke became nothing that is drawn outside brackets.
        for (const char letter : {'F', 'G'}) {
            if (!rules.count(letter)) continue;
            int depth = 0, drawn_outside = 0;
            for (const char c : rules[letter]) {
                depth += c == '[' ? 1 : c == ']' ? -1 : 0;
                drawn_outside += depth == 0 && (c == 'F' || c == 'G') ? 1 : 0;
            }
            if (drawn_outside == 0) return;
        }
        const auto before = strokes_of(system, n), begin = drawn(grown(system, n, 0));
        RC_ASSERT(std::fabs(length(before) - length(begin)) < 1e-9 * (1 + length(before)));
        RC_ASSERT(distance(before, begin) < 1e-9 && distance(begin, before) < 1e-9);
        ++joined;
    }));
    CHECK(compared >= 400);
    CHECK(joined >= 20);
}
