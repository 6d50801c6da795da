// Lower bounds of dimensions by pairs of parts in cells: the number up to which they are shown, for sets whose parts are written down
// here, and between what a slow computation with doubles finds of slightly smaller and slightly larger cells.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/limit_set.hpp"

using namespace algae;
using namespace algae::verify;
using namespace algae::verify::limits;

namespace {

using Complex = std::complex<double>;

/// A part: its heading, and its place in the lattice of 1 and a root of unity, where the whole is mu times larger.
struct Part {
    int heading;
    long x, y;
};

/// One piece that is made of such parts. Headings count turns of 1/order, which is 1/4 or 1/6.
struct Whole {
    int order;
    long mu_x, mu_y;
    std::vector<Part> parts;
};

struct Fixture {
    Whole whole;
    Complex zeta, mu, centre;
    double radius = 0;
    Certificate certificate;
    Budget budget;
    JsonValue nothing;
    std::string file = "x.json";
    std::unique_ptr<Reader> reader;
    Statement statement;
    std::unique_ptr<Obligation> task;
    LimitSet set;
    std::unique_ptr<Places> places;

    Complex value(long x, long y) const {
        return static_cast<double>(x) + static_cast<double>(y) * zeta;
    }
    Complex turn(int heading) const { return std::polar(1.0, 2 * M_PI * heading / whole.order); }

    explicit Fixture(Whole given) : whole(std::move(given)) {
        zeta = turn(1);
        mu = value(whole.mu_x, whole.mu_y);
        certificate.alphabet = std::make_shared<Alphabet>();
        reader = std::make_unique<Reader>(*certificate.alphabet, certificate.systems,
                                          certificate.rewritings);
        task = std::make_unique<Obligation>(
            Obligation{certificate, *reader, budget, statement, true, Field(nothing, "", file)});
        set.order = whole.order;
        set.rank = 2;
        set.letters = 1;
        const Integer one = 1, none = 0, turned = whole.order == 6 ? 1 : 0;
        const IntegerMatrix times_zeta({Row{none, one}, Row{Integer(-1), turned}});
        set.turns.push_back(IntegerMatrix::identity(2));
        for (int i = 0; i < whole.order; ++i) set.turns.push_back(set.turns.back() * times_zeta);
        const Row first{Integer(whole.mu_x), Integer(whole.mu_y)};
        set.scale = IntegerMatrix({first, first * times_zeta});
        set.numbers = {number(1), set.zeta(1)};
        set.factor = set.value(first);
        const long norm = whole.mu_x * whole.mu_x + whole.mu_y * whole.mu_y +
                          (whole.order == 6 ? whole.mu_x * whole.mu_y : 0);
        set.ratio = Operand{Integer(norm), Rational(1, 2), {}, [norm](long bits) {
                                return sqrt(Ball(Integer(norm), bits));
                            }};
        for (const Part& part : whole.parts)
            set.parts[0].push_back({0, part.heading, {Integer(part.x), Integer(part.y)}});
        set.axiom = {{0, 0, Row(2)}};
        const Integer count(std::uint64_t{whole.parts.size()});
        set.components = {
            {{0}, Operand{count, 1, {}, [count](long bits) { return Ball(count, bits); }}}};
        std::tie(centre, radius) = disc(0, whole.parts);
        places = std::make_unique<Places>(Places{*task, set, {}});
    }

    /// Finds a disc that holds the piece, in thousandths.
    std::pair<Complex, double> disc(std::size_t piece, const std::vector<Part>& parts) {
        Complex offsets, turns;
        for (const Part& part : parts) {
            offsets += value(part.x, part.y);
            turns += turn(part.heading);
        }
        const auto count = static_cast<double>(parts.size());
        Complex middle = offsets / count / (mu - turns / count);
        middle = {std::round(middle.real() * 1000) / 1000, std::round(middle.imag() * 1000) / 1000};
        double farthest = 0;
        for (const Part& part : parts)
            farthest = std::max(farthest, std::abs(turn(part.heading) * middle +
                                                   value(part.x, part.y) - mu * middle));
        farthest = std::ceil(farthest / (std::abs(mu) - 1) * 1000) / 1000;
        const auto thousandths = [](double x) {
            return Rational(Integer(static_cast<long>(std::lround(x * 1000))), Integer(1000));
        };
        set.discs.emplace(piece,
                          Disc{number(thousandths(middle.real()), thousandths(middle.imag())),
                               Ball(thousandths(farthest), bits)});
        return {middle, farthest};
    }

    /// The rate of the boundary's cells.
    double boundary() const { return rate_of_boundary(*places).enclose(64).midpoint(); }

    /// Whether k/100000 is shown to lie below the dimension.
    bool is_shown(long k, int levels, int across) const {
        Parts parts(*places, set.components.front());
        return is_above_by_pairs(parts, static_cast<std::uint64_t>(levels),
                                 static_cast<std::uint64_t>(across),
                                 Ball(Rational(Integer(k), Integer(100'000)), bits), budget);
    }
};

/// The same with doubles: the number up to which it is shown, if cells are so much wider and all those count that come so near to the disc of
/// places.
class Slowly {
public:
    Slowly(const Fixture& of, int levels, int across, double wider, double farther)
        : of_(of), across_(across), wider_(wider) {
        block_ = {{0, {0, 0}}};
        for (int i = 0; i < levels; ++i) {
            std::vector<std::pair<int, Complex>> next;
            for (const auto& [heading, place] : block_)
                for (const Part& part : of.whole.parts)
                    next.emplace_back((heading + part.heading) % of.whole.order,
                                      place * of.mu + of.turn(heading) * of.value(part.x, part.y));
            block_.clear();  // different ones only
            for (const auto& one : next)
                if (std::none_of(block_.begin(), block_.end(), [&](const auto& known) {
                        return known.first == one.first &&
                               std::abs(known.second - one.second) < 1e-6;
                    }))
                    block_.push_back(one);
        }
        // Which one is seen from the other matters to the cells: in the order of headings and of the lattice.
        const auto order = [&](const std::pair<int, Complex>& one) {
            const double y = std::round(one.second.imag() / of.zeta.imag());
            return std::tuple(one.first, std::round(one.second.real() - y * of.zeta.real()), y);
        };
        std::sort(block_.begin(), block_.end(),
                  [&](const auto& left, const auto& right) { return order(left) < order(right); });
        stretch_ = std::pow(of.mu, levels);
        const double reach = 2 * of.radius + 0.001;
        half_ = reach / across;
        reach_ = reach + farther * half_;
        for (std::size_t i = 0; i < block_.size(); ++i)
            for (std::size_t k = i + 1; k < block_.size(); ++k) {
                const auto [heading, place] =
                    seen(block_[i], block_[k].first, block_[k].second, Complex{});
                meet(place, 1e-6, 0, [&](int x, int y) { number(heading, x, y); });
            }
        for (std::size_t k = 0; k < cells_.size(); ++k) follow(k);
        const auto count = static_cast<double>(block_.size());
        const double ratio = levels * std::log(std::abs(of.mu));
        shown = (2 * std::log(count) - std::log(std::max(rate(), count))) / ratio;
    }
    double shown = 0;

private:
    /// Where a piece with this heading and place, which a whole piece stands at `shift` beside, is seen from the first.
    std::pair<int, Complex> seen(const std::pair<int, Complex>& first, int heading, Complex place,
                                 Complex shift) const {
        const int turned = (heading - first.first + of_.whole.order) % of_.whole.order;
        const Complex at = (place + shift - first.second) * of_.turn(-first.first);
        return {turned, at + of_.turn(turned) * of_.centre - of_.centre};
    }
    std::size_t number(int heading, int x, int y) {
        const auto [at, is_new] = numbers_.try_emplace({heading, x, y}, cells_.size());
        if (is_new) cells_.emplace_back(heading, x, y);
        return at->second;
    }
    Complex middle(int x, int y) const {
        return {half_ * (2 * x + 1 - across_), half_ * (2 * y + 1 - across_)};
    }
    /// The cells that meet a square around `at`, of half this side and turned by the angle, and come near the disc.
    template <class See>
    void meet(Complex at, double half, double angle, const See& see) const {
        const Complex along = std::polar(1.0, angle);
        const double spread = std::abs(along.real()) + std::abs(along.imag());
        for (int x = 0; x < across_; ++x)
            for (int y = 0; y < across_; ++y) {
                const Complex apart = middle(x, y) - at, turned = apart * std::conj(along);
                const double straight = half_ + half * spread + wider_,
                             askew = half + half_ * spread + wider_;
                if (std::abs(middle(x, y)) <= reach_ && std::abs(apart.real()) <= straight &&
                    std::abs(apart.imag()) <= straight && std::abs(turned.real()) <= askew &&
                    std::abs(turned.imag()) <= askew)
                    see(x, y);
            }
    }
    void follow(std::size_t k) {
        const auto [heading, x, y] = cells_[k];
        const Complex place = middle(x, y) - of_.turn(heading) * of_.centre + of_.centre;
        auto& steps = steps_.emplace_back();
        for (const auto& first : block_)
            for (const auto& [turn, other] : block_) {
                const auto [to, at] = seen(first, (heading + turn) % of_.whole.order,
                                           of_.turn(heading) * other, stretch_ * place);
                std::vector<std::size_t> targets;
                meet(at, half_ * std::abs(stretch_), std::arg(stretch_ * of_.turn(-first.first)),
                     [&, to = to](int i, int j) { targets.push_back(number(to, i, j)); });
                steps.push_back(std::move(targets));
            }
    }
    /// The growth of the sums of the largest weights that steps come to.
    double rate() const {
        std::vector<double> weights(cells_.size(), 1), next(cells_.size());
        double grown = 0;
        constexpr int rounds = 400;
        for (int round = 0; round < rounds; ++round) {
            double largest = 0;
            for (std::size_t k = 0; k < cells_.size(); ++k) {
                next[k] = 0;
                for (const auto& targets : steps_[k]) {
                    double most = 0;
                    for (const std::size_t to : targets) most = std::max(most, weights[to]);
                    next[k] += most;
                }
                largest = std::max(largest, next[k]);
            }
            if (largest == 0) return 0;
            if (round >= rounds / 2) grown += std::log(largest) / (rounds / 2);
            for (double& one : next) one /= largest;
            weights.swap(next);
        }
        return std::exp(grown);
    }

    const Fixture& of_;
    int across_;
    double wider_, half_ = 0, reach_ = 0;
    Complex stretch_;
    std::vector<std::pair<int, Complex>> block_;
    std::map<std::tuple<int, int, int>, std::size_t> numbers_;
    std::vector<std::tuple<int, int, int>> cells_;
    std::vector<std::vector<std::vector<std::size_t>>> steps_;
};

struct Known {
    int levels, across;
    long shown;  // of 100000, and no more
};

void expect_shown(const Whole& whole, const std::vector<Known>& all) {
    const Fixture made(whole);
    for (const auto& [levels, across, shown] : all) {
        CAPTURE(levels);
        CAPTURE(across);
        CHECK(made.is_shown(shown, levels, across));
        CHECK_FALSE(made.is_shown(shown + 1, levels, across));
        const double least = Slowly(made, levels, across, 1e-2, 1.6).shown,
                     most = Slowly(made, levels, across, -1e-3, 1.4).shown;
        CHECK(static_cast<double>(shown) / 100'000 >= least - 0.001);
        CHECK(static_cast<double>(shown) / 100'000 <= most + 0.001);
    }
}

}  // namespace

// How much is shown by cells is known, and lies between what doubles find.

TEST_CASE("pairs in cells: Koch's curve") {
    expect_shown({6, 3, 0, {{0, 0, 0}, {1, 1, 0}, {5, 1, 1}, {0, 2, 0}}}, {{1, 8, 70280}});
}

TEST_CASE("pairs in cells: Koch's curve by two levels") {
    expect_shown({6, 3, 0, {{0, 0, 0}, {1, 1, 0}, {5, 1, 1}, {0, 2, 0}}}, {{2, 4, 43077}});
}

TEST_CASE("pairs in cells: a triangle of three triangles") {
    expect_shown({6, 2, 0, {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {{1, 8, 59348}, {1, 16, 91690}});
}

TEST_CASE("pairs in cells: three parts that lie apart") {
    expect_shown({4, 3, 1, {{0, 0, 0}, {1, 2, 1}, {3, -1, 2}}}, {{1, 8, 95424}});
}

TEST_CASE("pairs in cells: the dragon curve") {
    expect_shown({4, 1, 1, {{0, 0, 0}, {1, 1, 0}}}, {{1, 12, 14623}});
}

TEST_CASE("pairs in cells: the dragon curve by two levels") {
    expect_shown({4, 1, 1, {{0, 0, 0}, {1, 1, 0}}}, {{2, 8, 55686}});
}

TEST_CASE("pairs in cells: four parts that are turned") {
    expect_shown({6, 2, 1, {{0, 0, 0}, {1, 1, 1}, {3, -1, 1}, {2, 0, 2}}}, {{1, 7, 60224}});
    expect_shown({4, 2, 1, {{0, 0, 0}, {1, 1, 1}, {3, -1, 1}, {2, 0, 2}}}, {{1, 9, 82099}});
}

TEST_CASE("pairs in cells: parts that coincide") {
    expect_shown({4, 2, 1, {{0, 0, 0}, {1, 1, 0}, {2, 1, 1}, {0, 0, 0}}}, {{1, 8, 41823}});
}

TEST_CASE("pairs in cells: parts that coincide by two levels") {
    expect_shown({4, 2, 1, {{0, 0, 0}, {1, 1, 0}, {2, 1, 1}, {0, 0, 0}}}, {{2, 6, 41076}});
}

TEST_CASE("pairs in cells: two parts that overlap, far from the first") {
    const Whole whole{4, 4, 0, {{0, 0, 0}, {0, 9, 0}, {1, 10, 0}}};
    expect_shown(whole, {{1, 6, 54375}});
}

TEST_CASE("pairs in cells: parts that lie farther apart than places are known") {
    expect_shown({4, 10, 0, {{0, 0, 0}, {0, 180, 0}}}, {{1, 6, 30102}});
}

TEST_CASE("blocks of two levels of pieces in turn do not all lead to each other") {
    Fixture made({4, 2, 0, {{0, 0, 0}, {0, 1, 0}}});
    made.set.letters = 2;
    made.set.parts[1] = made.set.parts[0];
    for (Seen& part : made.set.parts[0]) part.piece = 1;
    made.set.components.front().pieces = {0, 1};
    const Parts parts(*made.places, made.set.components.front());
    CHECK(rate_of_blocks(parts, 1, made.budget).enclose(64).midpoint() == doctest::Approx(2));
    CHECK_THROWS_WITH_AS(rate_of_blocks(parts, 2, made.budget),
                         "pieces do not all lead to each other in blocks of levels", BoundReached);
}

TEST_CASE("pairs in cells: random parts" * doctest::test_suite("long")) {
    std::mt19937 generator(3);
    const auto below = [&](int bound) {
        return static_cast<int>(generator() % static_cast<unsigned>(bound));
    };
    std::size_t sets = 0, refused = 0;
    while (sets < 40) {
        Whole whole{below(2) == 0 ? 4 : 6, 1 + below(3), below(3), {}};
        for (int i = 2 + below(3); i > 0; --i)
            whole.parts.push_back({below(whole.order), below(5) - 2, below(5) - 2});
        if (whole.mu_x + whole.mu_y < 2) continue;
        const Fixture made(whole);
        const int levels = 1 + below(2), across = 4 + below(9);
        const auto shows = [&](double number) {
            return made.is_shown(static_cast<long>(std::floor(number * 100'000)), levels, across);
        };
        try {
            const double least = Slowly(made, levels, across, 1e-2, 1.6).shown,
                         most = Slowly(made, levels, across, -1e-3, 1.4).shown;
            CAPTURE(least);
            CAPTURE(most);
            CHECK(shows(least - 0.005));
            CHECK_FALSE(shows(most + 0.005));
            ++sets;
        } catch (const BoundReached&) {
            ++refused;
        }
    }
    MESSAGE(sets, " sets of parts, ", refused, " refused");
}

namespace {

/// The rate of the boundary's cells of a tile without turns, as counted: places of parts of a late level, beside one that is none.
double counted_boundary(const Whole& tile) {
    std::set<std::pair<long, long>> places{{0, 0}};
    std::vector<double> counts;
    while (places.size() < 20'000) {
        std::set<std::pair<long, long>> next;
        for (const auto& [x, y] : places)
            for (const Part& part :
                 tile.parts)  // times mu, where the square of zeta is -1 or zeta - 1
                next.emplace(
                    x * tile.mu_x - y * tile.mu_y + part.x,
                    x * tile.mu_y + y * (tile.mu_x + (tile.order == 6 ? tile.mu_y : 0)) + part.y);
        places = std::move(next);
        double beside = 0;
        for (const auto& [x, y] : places)
            for (const auto& [i, j] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}})
                beside += !places.contains({x + i, y + j});
        counts.push_back(beside);
    }
    return std::pow(counts.back() / counts[counts.size() - 5], 0.25);
}

}  // namespace

TEST_CASE("the boundary of a tile has as many cells as are counted") {
    const Whole square{4, 2, 0, {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}}},
        rough{4, 2, 0, {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, -1}}},
        twin{4, 1, 1, {{0, 0, 0}, {0, 1, 0}}}, three{6, 1, 1, {{0, 0, 0}, {0, 1, 0}, {0, -1, 0}}},
        far{4, 2, 0, {{0, 0, 0}, {0, 3, 0}, {0, 0, 1}, {0, 1, 1}}},
        five{4, 2, 1, {{0, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}},
        seven{6,
              2,
              1,
              {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 1}, {0, -1, 0}, {0, 0, -1}, {0, 1, -1}}};
    for (const Whole& tile : {square, rough, twin, three, far, five, seven}) {
        CAPTURE(tile.mu_x);
        CAPTURE(tile.parts.size());
        CHECK(Fixture(tile).boundary() == doctest::Approx(counted_boundary(tile)).epsilon(0.005));
    }
    // A smooth tile, and a rough one five places beside it.
    Fixture two(square);
    two.set.letters = 2;
    for (const Part& part : rough.parts)
        two.set.parts[1].push_back({1, part.heading, {Integer(part.x), Integer(part.y)}});
    two.disc(1, rough.parts);
    for (const auto& [x, y] : {std::pair(5, 0), {0, 5}, {-5, 0}, {0, -5}, {7, 7}}) {
        two.set.axiom = {{0, 0, Row(2)}, {1, 0, {Integer(x), Integer(y)}}};
        CHECK(two.boundary() == doctest::Approx(3));
    }
}

TEST_CASE("the boundary of random tiles has as many cells as are counted" *
          doctest::test_suite("long")) {
    std::mt19937 generator(5);
    const auto around = [&] { return static_cast<long>(generator() % 3) - 1; };
    double largest = 0;
    std::size_t tiles = 0, too_large = 0;
    while (tiles < 40) {
        Whole tile{4, 2, 0, {{0, 0, 0}}};
        for (const auto& [x, y] : {std::pair(1, 0), {0, 1}, {1, 1}})
            tile.parts.push_back({0, x + 2 * around(), y + 2 * around()});
        long index = 0;  // of the lattice that they make
        for (const Part& one : tile.parts)
            for (const Part& other : tile.parts)
                index = std::gcd(index, one.x * other.y - one.y * other.x);
        if (index != 1) continue;
        double found = 0;
        try {
            found = Fixture(tile).boundary();
        } catch (const BoundReached&) {
            ++too_large;
            continue;
        }
        std::string text;
        for (const Part& part : tile.parts)
            text += " (" + std::to_string(part.x) + ", " + std::to_string(part.y) + ")";
        CAPTURE(text);
        CHECK(found == doctest::Approx(counted_boundary(tile)).epsilon(0.03));
        largest = std::max(largest, found);
        ++tiles;
    }
    MESSAGE(tiles, " tiles, the largest rate is ", largest, "; ", too_large, " refused");
    CHECK(largest > 3);
}
