#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/verify.hpp"

// What is counted of the figure of a generation: different segments, and squares that they meet.
//
// A turtle that turns by k/m of a full turn and makes steps of length 1 stands on sums of powers of zeta = exp(2 pi i / m). These are
// polynomials in zeta modulo the cyclotomic polynomial Phi_m, the product of (1 - x^d)^mu(m/d) over the divisors d of m > 1. Phi_m is
// irreducible, so two places are the same if and only if their coefficients are. Squares are counted where m is 4 and places are
// pairs of integers.
//
// The walk follows the derivation down and keeps no word, only the path to the letter at hand.

namespace algae::verify {

namespace {

constexpr std::int64_t largest_denominator = 360;
constexpr std::uint64_t latest_generation = 100'000, most_letters = 50'000'000,
                        most_found = 1'000'000;

[[noreturn]] void too_hard(const std::string& why) { throw BoundReached(Bound::method, why); }

Rational part_of_turn(const Field& field) {
    constexpr std::size_t longest = 100;
    if (field.text().size() > longest) field.fail("expected a part of a full turn");
    try {
        const Rational part(field.text());
        return part - Rational(floor(part));
    } catch (const Error& error) {
        field.fail(error.what());
    }
}

/// The coefficients of Phi_m, m > 1.
std::vector<std::int64_t> cyclotomic_polynomial(std::size_t m) {
    const auto moebius = [](std::size_t n) {
        int sign = 1;
        for (std::size_t p = 2; p <= n; ++p) {
            if (n % p != 0) continue;
            n /= p;
            if (n % p == 0) return 0;
            sign = -sign;
        }
        return sign;
    };
    std::vector<std::int64_t> series(m + 1, 0);  // up to x^m
    series[0] = 1;
    for (const int exponent : {1, -1})
        for (std::size_t d = 1; d <= m; ++d) {
            if (m % d != 0 || moebius(m / d) != exponent) continue;
            if (exponent > 0)
                for (std::size_t i = m; i >= d; --i) series[i] -= series[i - d];
            else
                for (std::size_t i = d; i <= m; ++i) series[i] += series[i - d];
        }
    while (series.back() == 0) series.pop_back();
    return series;
}

/// A place: the coefficients of a polynomial in zeta of the degree of the field at most.
using Spot = std::vector<std::int64_t>;

/// zeta^0, ..., zeta^(m-1).
std::vector<Spot> powers_of_zeta(std::size_t m) {
    const std::vector<std::int64_t> phi = cyclotomic_polynomial(m);
    const std::size_t degree = phi.size() - 1;
    Spot now(degree, 0);
    now[0] = 1;
    std::vector<Spot> all;
    for (std::size_t k = 0; k < m; ++k) {
        all.push_back(now);
        const std::int64_t top = now.back();  // of x^degree, which is minus the rest of phi
        std::rotate(now.begin(), now.end() - 1, now.end());
        now[0] = 0;
        for (std::size_t i = 0; i < degree; ++i) now[i] -= top * phi[i];
    }
    return all;
}

/// The different segments of a figure, each as the numbers of its ends.
struct Drawing {
    std::map<Spot, std::uint32_t> spots;
    std::set<std::pair<std::uint32_t, std::uint32_t>> segments;
};

/// The walk of one turtle over a generation; headings are multiples of a full turn divided by m.
class Walk {
public:
    Walk(const Turtle& turtle, std::size_t m, const Rational& heading, const Field& where,
         const Budget& budget)
        : turtle_(turtle), zeta_(powers_of_zeta(m)), where_(where), budget_(budget) {
        turn_ = units(turtle.turn);
        here_ = {Spot(zeta_.front().size(), 0), units(heading)};
    }

    Drawing over(const System& system, std::uint64_t generation) {
        if (length_of_generation(system, Integer(generation), budget_) > Integer(most_letters))
            too_hard("a figure of more than 50000000 letters is not walked");
        const System::Successors& rules = system.tables.front();
        struct Level {
            const Word* word;
            std::size_t next = 0;
        };
        std::vector<Level> path{{&system.axiom}};
        std::uint64_t letters = 0;
        while (!path.empty()) {
            Level& level = path.back();
            if (level.next == level.word->size()) {
                path.pop_back();
                continue;
            }
            const Symbol letter = (*level.word)[level.next++];
            if (++letters > most_letters)
                throw BoundReached(Bound::letters,
                                   "a figure of more than 50000000 letters is not "
                                   "walked");
            if (letters % 1024 == 0) check_budget(path.size());
            if (path.size() <= generation)
                path.push_back({&rules[letter].front()});
            else if (const auto told = turtle_.letters.find(letter); told != turtle_.letters.end())
                for (const char command : told->second) obey(command);
        }
        return std::move(drawn_);
    }

private:
    struct State {
        Spot spot;
        std::size_t heading = 0;
    };

    /// A part of a full turn as a number of headings, less than all.
    std::size_t units(const Rational& part) const {
        const Rational within = part - Rational(floor(part));
        return static_cast<std::size_t>(
            (within * Rational(Integer(std::uint64_t{zeta_.size()}))).numerator().to_uint64());
    }

    void check_budget(std::size_t levels) const {
        const std::uint64_t spot = 100 + 8 * zeta_.front().size();
        budget_.check();
        budget_.check_memory((drawn_.spots.size() + saved_.size()) * spot +
                                 drawn_.segments.size() * 64 + levels * 16,
                             "the segments of a figure");
    }

    void obey(char command) {
        const std::size_t m = zeta_.size();
        switch (command) {
            case 'F':
                step(true);
                break;
            case 'f':
                step(false);
                break;
            case '+':
                here_.heading = (here_.heading + turn_) % m;
                break;
            case '-':
                here_.heading = (here_.heading + m - turn_) % m;
                break;
            case '|':
                here_.heading = (here_.heading + m / 2) % m;
                break;
            case '[':
                saved_.push_back(here_);
                if (saved_.size() % 1024 == 0) check_budget(0);
                break;
            default:  // ]
                if (saved_.empty()) where_.refuse("a bracket ] of the figure closes nothing");
                here_ = std::move(saved_.back());
                saved_.pop_back();
        }
    }

    void step(bool drawn) {
        const std::uint32_t from = drawn ? number() : 0;
        const Spot& way = zeta_[here_.heading];
        for (std::size_t i = 0; i < way.size(); ++i) here_.spot[i] += way[i];
        if (!drawn) return;
        drawn_.segments.insert(std::minmax(from, number()));
        if (drawn_.segments.size() > most_found)
            too_hard("more than 1000000 segments are not counted");
    }
    std::uint32_t number() {
        const auto fresh = static_cast<std::uint32_t>(drawn_.spots.size());
        return drawn_.spots.try_emplace(here_.spot, fresh).first->second;
    }

    const Turtle& turtle_;
    std::vector<Spot> zeta_;
    const Field& where_;
    const Budget& budget_;
    std::size_t turn_ = 0;
    State here_;
    std::vector<State> saved_;
    Drawing drawn_;
};

void expect_generation(std::uint64_t generation) {
    if (generation > latest_generation) too_hard("figures beyond generation 100000 are not drawn");
}

}  // namespace

Turtle read_turtle(const Field& field, const Alphabet& alphabet) {
    field.only({"turn", "heading", "spin", "letters"});
    Turtle read;
    read.turn = part_of_turn(field.at("turn"));
    if (field.has("heading")) read.heading = part_of_turn(field.at("heading"));
    if (field.has("spin")) read.spin = part_of_turn(field.at("spin"));
    for (const auto& [name, told] : field.at("letters").object()) {
        const auto letter = alphabet.find(name);
        if (!letter) told.fail("'" + name + "' is not a letter of the alphabet");
        if (told.text().find_first_not_of("Ff+-|[]") != std::string::npos)
            told.fail("expected commands of a turtle: F f + - | [ ]");
        read.letters[*letter] = told.text();
    }
    return read;
}

Integer distinct_segments(const System& system, const Turtle& turtle, std::uint64_t generation,
                          const Field& where, const Budget& budget) {
    expect_generation(generation);
    const Integer denominator = turtle.turn.denominator();
    if (denominator > Integer(largest_denominator))
        too_hard("turns by parts of a full turn with a denominator beyond 360 are not checked");
    const auto m = static_cast<std::size_t>(lcm(Integer(2), denominator).to_uint64());
    Walk walk(turtle, m, Rational(0), where, budget);
    return Integer(std::uint64_t{walk.over(system, generation).segments.size()});
}

Integer met_boxes(const System& system, const Turtle& turtle, std::uint64_t generation,
                  const Rational& side, const Field& where, const Budget& budget) {
    expect_generation(generation);
    if (side <= 0) where.refuse("the side of boxes is not above 0");
    const Rational heading = turtle.heading + turtle.spin * Rational(Integer(generation));
    const auto is_quarters = [](const Rational& part) { return (part * Rational(4)).is_integer(); };
    if (!is_quarters(turtle.turn) || !is_quarters(heading))
        too_hard("boxes are counted of figures along the axes only");
    Walk walk(turtle, 4, heading, where, budget);
    const Drawing drawn = walk.over(system, generation);
    std::vector<const Spot*> spots(drawn.spots.size());
    for (const auto& [spot, number] : drawn.spots) spots[number] = &spot;
    const auto box = [&](std::int64_t coordinate) {
        return floor(Rational(Integer(coordinate)) / side);
    };
    std::set<std::pair<Integer, Integer>> met;
    for (const auto& [one, other] : drawn.segments) {
        const Spot &a = *spots[one], &b = *spots[other];
        const Integer right = box(std::max(a[0], b[0])), top = box(std::max(a[1], b[1]));
        for (Integer x = box(std::min(a[0], b[0])); x <= right; x += Integer(1))
            for (Integer y = box(std::min(a[1], b[1])); y <= top; y += Integer(1)) {
                budget.check();
                met.emplace(x, y);
                if (met.size() > most_found) too_hard("more than 1000000 boxes are not counted");
            }
    }
    return Integer(std::uint64_t{met.size()});
}

std::vector<std::string> turtle_texts(const Certificate& certificate) {
    std::vector<std::string> lines;
    const Field root(certificate.header, "", certificate.file);
    if (!root.has("turtles")) return lines;
    for (const auto& [name, field] : root.at("turtles").object()) {
        const Turtle turtle = read_turtle(field, *certificate.alphabet);
        std::string text = "the turtle of " + system_name(name) + ": turns by " +
                           to_string(turtle.turn) + " of a full turn";
        if (!turtle.heading.is_zero())
            text += ", starts at " + to_string(turtle.heading) + " of it";
        if (!turtle.spin.is_zero())
            text += ", for each generation " + to_string(turtle.spin) + " more";
        for (const auto& [letter, commands] : turtle.letters)
            text += "; " + letter_text(certificate.alphabet->name(letter)) + " does " + commands;
        lines.push_back(std::move(text));
    }
    return lines;
}

}  // namespace algae::verify
