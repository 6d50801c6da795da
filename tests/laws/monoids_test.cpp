// The laws of every monoid in src, on random elements. What each models is checked while compiling.
#include "exact/exact.hpp"
#include "laws/check_laws.hpp"
#include "model/model.hpp"
#include "turtle/detail/plane_figure.hpp"
#include "turtle/turtle.hpp"
#include "word/word.hpp"

using namespace algae;
using namespace algae::laws;

static_assert(Monoid<Words> && !Branching<Words> && !Semiring<Words>);
static_assert(Branching<Sums>);
static_assert(Monoid<Vectors> && !Branching<Vectors>);
static_assert(Monoid<BracketBalance> && !Branching<BracketBalance>);
static_assert(Monoid<Spellings> && !Branching<Spellings>);
static_assert(Semiring<WordSets> && !Branching<WordSets>);
static_assert(Branching<LatticeMotions>);
static_assert(Branching<Pieces>);

namespace {

class Dice {
public:
    long from_to(long least, long most) {
        return least +
               static_cast<long>(generator_() % static_cast<std::uint64_t>(most - least + 1));
    }
    /// Also numbers beyond 64 bits, and close to where machine numbers end.
    Integer integer() {
        switch (from_to(0, 3)) {
            case 0:
                return from_to(-5, 5);
            case 1:
                return power(Integer(2), 62) + from_to(-2, 2);
            case 2:
                return Integer(from_to(-5, 5)) * power(Integer(10), 30);
            default:
                return -power(Integer(2), 62) + from_to(-2, 2);
        }
    }
    Word word(long letters, long most) {
        Word word(static_cast<std::size_t>(from_to(0, most)));
        for (Symbol& letter : word) letter = static_cast<Symbol>(from_to(0, letters - 1));
        return word;
    }

private:
    std::mt19937_64 generator_{2026};
};

bool near(double x, double y) { return std::abs(x - y) <= 1e-9 * (1 + std::abs(x) + std::abs(y)); }
bool near(std::complex<double> x, std::complex<double> y) {
    return near(x.real(), y.real()) && near(x.imag(), y.imag());
}

/// All of a piece but its disc, which depends on the order in which discs were joined.
bool same_motion(const Pieces::value_type& x, const Pieces::value_type& y) {
    return near(x.move, y.move) && x.turn == y.turn && near(x.size, y.size) &&
           near(x.width, y.width) && near(x.colours, y.colours) && near(x.letters, y.letters) &&
           x.draws() == y.draws();
}

Compass compass_of(const char* degrees) {
    Drawing settings;
    settings.angle = quantity(Rational(degrees));
    return Compass(settings, 0);
}

}  // namespace

TEST_CASE("words are a monoid") {
    Dice dice;
    check_monoid_laws(Words{}, [&] { return dice.word(3, 5); });
}

TEST_CASE("integers under addition are a monoid with branches, whatever brackets count") {
    Dice dice;
    for (const long pair : {0, 1, 2}) {
        const Sums sums{pair};
        check_monoid_laws(sums, [&] { return dice.integer(); });
        check_branching_laws(sums, [&] { return dice.integer(); });
        CHECK(sums.branch(sums.one()) == pair);
    }
}

TEST_CASE("vectors under addition are a monoid") {
    Dice dice;
    for (const std::size_t dimension : {0u, 1u, 4u})
        check_monoid_laws(Vectors{dimension}, [&] {
            std::vector<Integer> vector(dimension);
            for (Integer& entry : vector) entry = dice.integer();
            return vector;
        });
}

TEST_CASE("bracket balances are a monoid, and say what a scan of the word says") {
    Dice dice;
    const BracketBalance balances;
    const auto of = [&](const Word& word) {  // 0 is a letter, 1 opens, 2 closes
        auto value = balances.one();
        for (const Symbol a : word)
            balances.append(value, a == 1   ? BracketBalance::value_type{1, 0}
                                   : a == 2 ? BracketBalance::value_type{-1, -1}
                                            : balances.one());
        return value;
    };
    check_monoid_laws(balances, [&] { return of(dice.word(3, 6)); });
    for (int i = 0; i < 1000; ++i) {
        const Word word = dice.word(3, 12);
        long depth = 0, lowest = 0;
        for (const Symbol a : word) {
            depth += a == 1 ? 1 : a == 2 ? -1 : 0;
            lowest = std::min(lowest, depth);
        }
        REQUIRE(of(word) == BracketBalance::value_type{depth, lowest});
    }
}

TEST_CASE("spellings are a monoid, with names that need blanks and names that do not") {
    Dice dice;
    for (const std::vector<std::string>& names : {std::vector<std::string>{"a", "b", "c"},
                                                  {"X_1", "2", "_", "X"},
                                                  {"wall", "w", "a", "l", "?E"}}) {
        Alphabet alphabet;
        for (const std::string& name : names) alphabet.symbol(name);
        const Spellings spellings(alphabet);
        check_monoid_laws(spellings, [&] {
            auto value = spellings.one();
            for (const Symbol a : dice.word(static_cast<long>(names.size()), 4))
                spellings.append(value, spellings.letter(a));
            return value;
        });
    }
}

TEST_CASE("sets of words are a semiring, cut at a length or not") {
    Dice dice;
    const Budget budget;
    for (const std::size_t longest :
         {std::size_t{0}, std::size_t{1}, std::size_t{3}, std::size_t{1000}}) {
        const WordSets sets(budget, longest);
        check_semiring_laws(sets, [&] {
            auto set = sets.zero();
            for (long i = dice.from_to(0, 4); i > 0; --i) {
                const Word word = dice.word(2, 3);
                if (word.size() <= longest) sets.add(set, {word});
            }
            return set;
        });
    }
}

TEST_CASE("lattice motions are a monoid with branches, for every kind of order") {
    Dice dice;
    // 6 and 10 stand for angles of 60 and 36 degrees, whose compass takes 12 and 20.
    for (const std::int64_t order : {4, 6, 8, 10, 12, 16, 20, 72}) {
        CAPTURE(order);
        const LatticeMotions motions(order);
        std::vector<LatticeMotions::value_type> some;
        for (int i = 0; i < 40; ++i) {
            auto value = motions.one();
            for (long k = dice.from_to(0, order == 72 ? 3 : 5); k > 0; --k) {
                const long what = dice.from_to(0, 3);
                auto next = what == 0   ? motions.turned(dice.from_to(-order, order))
                            : what == 1 ? motions.step(false)
                                        : motions.step(true);
                if (what == 3 && !some.empty())
                    next = motions.branch(some[static_cast<std::size_t>(i) / 2]);
                motions.append(value, next);
            }
            some.push_back(value);
        }
        const auto any = [&] { return some[static_cast<std::size_t>(dice.from_to(0, 39))]; };
        if (order ==
            72) {  // the same laws on fewer elements: each has 72 reaches in a ring of degree 24
            for (int i = 0; i < 40; ++i) {
                auto left = any(), middle = any(), right = any();
                auto late = middle;
                motions.append(late, right);
                auto other = left;
                motions.append(other, late);
                motions.append(left, middle);
                motions.append(left, right);
                REQUIRE(left == other);
            }
            continue;
        }
        check_monoid_laws(motions, any);
        check_branching_laws(motions, any);
    }
}

TEST_CASE(
    "pieces are a monoid with branches up to rounding, and their discs hold their parts' discs") {
    Dice dice;
    for (const char* degrees : {"90", "36", "25.7", "137.5"}) {
        const Compass compass = compass_of(degrees);
        const Pieces pieces(compass);
        const auto any = [&] {
            auto value = pieces.one();
            for (long k = dice.from_to(0, 5); k > 0; --k) {
                auto next = pieces.one();
                switch (dice.from_to(0, 4)) {
                    case 0:
                        next.turn = compass.normal(dice.from_to(-3, 3) * compass.turn());
                        break;
                    case 1:
                        next.move = 1;
                        break;
                    case 2:
                        next.size = 0.75;
                        next.width = 0.5;
                        next.colours = 1;
                        break;
                    default:
                        next.move = 1;
                        next.centre = 0.5;
                        next.radius = 0.5;
                        break;
                }
                next.letters = 1;
                pieces.append(value, next);
            }
            return value;
        };
        check_monoid_laws(pieces, any, same_motion);
        check_branching_laws(pieces, any, same_motion);
        for (int i = 0; i < 1000; ++i) {
            const auto x = any(), y = any();
            auto both = x;
            pieces.append(both, y);
            if (x.draws()) CHECK(std::abs(both.centre - x.centre) + x.radius <= both.radius + 1e-9);
            const auto moved = x.move + x.size * compass.direction(x.turn) * y.centre;
            if (y.draws())
                CHECK(std::abs(both.centre - moved) + x.size * y.radius <= both.radius + 1e-9);
        }
    }
}
