// Rauzy fractals against what is published, and against points of them, which share nothing with the search.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "nature/nature.hpp"

using namespace algae;

namespace {

using Complex = std::complex<double>;

D0L substitution(const std::vector<std::string>& images) {
    std::vector<std::pair<char, std::string>> rules;
    for (std::size_t a = 0; a < images.size(); ++a)
        rules.emplace_back(static_cast<char>('a' + a), images[a]);
    if (images.size() == 2) return d0l("a", {{'a', images[0]}, {'b', images[1]}});
    return d0l("a", {{'a', images[0]}, {'b', images[1]}, {'c', images[2]}});
}

double boundary_of(const std::vector<std::string>& images) {
    const RauzyFractal found = rauzy_fractal(substitution(images));
    CHECK(found.tiles);
    return found.boundary(64)->midpoint();
}

/// Balanced pairs (Livshits; Sirvent and Solomyak 2002): whether pairs of words with the same letters, begun with
/// (ab, ba) and divided where they can be, become finitely many and all lead to a pair of one letter with itself.
bool has_coincidences(const std::vector<std::string>& images, std::size_t most) {
    const auto image = [&](const std::string& word) {
        std::string found;
        for (const char c : word) found += images[static_cast<std::size_t>(c - 'a')];
        return found;
    };
    using Pair = std::pair<std::string, std::string>;
    const auto divided = [](const std::string& left, const std::string& right) {
        std::vector<Pair> found;
        std::map<char, int> balance;
        std::size_t begin = 0;
        for (std::size_t i = 0; i < left.size(); ++i) {
            ++balance[left[i]];
            --balance[right[i]];
            if (std::any_of(balance.begin(), balance.end(), [](auto& b) { return b.second != 0; }))
                continue;
            found.emplace_back(left.substr(begin, i + 1 - begin),
                               right.substr(begin, i + 1 - begin));
            begin = i + 1;
        }
        return found;
    };
    std::map<Pair, std::vector<Pair>> next;
    std::vector<Pair> open = divided("ab", "ba");
    while (!open.empty()) {
        const Pair pair = open.back();
        open.pop_back();
        if (next.contains(pair)) continue;
        if (next.size() > most) return false;
        next[pair] = divided(image(pair.first), image(pair.second));
        for (const Pair& each : next[pair]) open.push_back(each);
    }
    std::set<Pair> good;
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [pair, parts] : next) {
            const bool is = (pair.first == pair.second && pair.first.size() == 1) ||
                            std::any_of(parts.begin(), parts.end(),
                                        [&](const Pair& part) { return good.contains(part); });
            if (is && good.insert(pair).second) changed = true;
        }
    }
    return good.size() == next.size();
}

/// Points of the parts of a fractal with complex conjugates, from the prefixes of the infinite word of a.
struct Points {
    std::vector<std::vector<Complex>> of;  // by letter
    std::vector<Complex> unit;             // what letters move by
};

Points points_of(const std::vector<std::string>& images, std::size_t count) {
    // The contracting eigenvalue, by dividing the cubic by its real root; then its eigenvector.
    double m[3][3] = {};
    for (std::size_t b = 0; b < 3; ++b)
        for (const char c : images[b]) m[b][c - 'a'] += 1;
    const double trace = m[0][0] + m[1][1] + m[2][2];
    const double minors = m[0][0] * m[1][1] - m[0][1] * m[1][0] + m[0][0] * m[2][2] -
                          m[0][2] * m[2][0] + m[1][1] * m[2][2] - m[1][2] * m[2][1];
    const double det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                       m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                       m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    double beta = trace + 1;
    for (int i = 0; i < 200; ++i)
        beta -= (((beta - trace) * beta + minors) * beta - det) /
                ((3 * beta - 2 * trace) * beta + minors);
    const double sum = trace - beta, product = det / beta;
    const Complex alpha = (sum + std::sqrt(Complex(sum * sum - 4 * product))) / 2.0;
    // (m - alpha) r = 0, by the product of two of its rows.
    Complex rows[3][3];
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) rows[i][k] = m[i][k] - (i == k ? alpha : Complex(0));
    Points found;
    found.of.resize(3);
    for (int skip = 0; skip < 3; ++skip) {
        const auto& x = rows[(skip + 1) % 3];
        const auto& y = rows[(skip + 2) % 3];
        std::vector<Complex> cross = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2],
                                      x[0] * y[1] - x[1] * y[0]};
        if (std::abs(cross[0]) + std::abs(cross[1]) + std::abs(cross[2]) < 1e-6) continue;
        const Complex first = cross[0];
        for (Complex& each : cross) each /= first;
        found.unit = cross;
        break;
    }
    std::string word = "a";
    while (word.size() < count) {
        std::string next;
        for (const char c : word) next += images[static_cast<std::size_t>(c - 'a')];
        word = next;
    }
    Complex here = 0;
    for (const char c : word) {
        const auto letter = static_cast<std::size_t>(c - 'a');
        found.of[letter].push_back(here);
        here += found.unit[letter];
    }
    return found;
}

}  // namespace

TEST_CASE("published dimensions of the boundaries of Rauzy fractals") {
    // Ito and Kimura 1991; the root of x^4 - 2x - 1.
    CHECK(boundary_of({"ab", "ac", "a"}) == doctest::Approx(1.0933641642).epsilon(1e-9));
    const RauzyFractal tribonacci = rauzy_fractal(substitution({"ab", "ac", "a"}));
    CHECK(tribonacci.meeting.exact() == "the largest real root of x^4 - 2x - 1");
    CHECK(tribonacci.connected);
    CHECK(tribonacci.parts_connected);
    // With two letters parts are intervals, or dust with a boundary of dimension 0 to 1.
    CHECK(boundary_of({"ab", "a"}) == 0);
    CHECK(boundary_of({"aab", "ab"}) >= 0);
}

TEST_CASE("substitutions that have no such fractal are refused") {
    for (const auto& images : {std::vector<std::string>{"ab", "ba"},  // determinant 0
                               {"ab", "aa"},                          // determinant -2
                               {"ab", "c", "b"},                      // reducible
                               {"aab", "c", "abbc"}})
        CHECK_THROWS_AS(rauzy_fractal(substitution(images)), Error);
    CHECK_THROWS_AS(rauzy_functions(substitution({"ab", "a"})), Error);
    try {
        rauzy_fractal(substitution({"ab", "aa"}));
    } catch (const Error& error) {
        CHECK(std::string(error.what()).find("found the determinant -2") != std::string::npos);
    }
}

TEST_CASE("tiles as balanced pairs say") {
    std::size_t compared = 0, of_three = 0;
    const auto compare = [&](const std::vector<std::string>& images) {
        RauzyFractal found;
        try {
            found = rauzy_fractal(substitution(images));
        } catch (const Error&) {
            return;
        } catch (const BoundReached&) {
            return;
        }
        CAPTURE(images[0]);
        CAPTURE(images[1]);
        if (!has_coincidences(images, 3'000)) return;
        CHECK(found.tiles);
        ++compared;
        of_three += images.size() == 3 ? 1 : 0;
    };
    const std::vector<std::string> two = {"a", "b", "ab", "ba", "aab", "aba", "baa", "abb", "bab"};
    for (const auto& first : two)
        for (const auto& second : two) compare({first, second});
    for (const char* first : {"ab", "ba", "abc", "cab", "aab"})
        for (const char* second : {"ac", "ca", "c", "bc"})
            for (const char* third : {"a", "b"}) compare({first, second, third});
    MESSAGE(compared, " compared, of three letters ", of_three);
    CHECK(compared > 20);
    CHECK(of_three > 3);
}

TEST_CASE("parts that meet come near each other in points, others do not") {
    std::size_t meet = 0, apart = 0;
    for (const auto& images : {std::vector<std::string>{"ab", "ac", "a"}, {"ab", "ca", "a"}}) {
        const RauzyFractal found = rauzy_fractal(substitution(images));
        const Points points = points_of(images, 60'000);
        const std::set<RauzyNeighbour> neighbours(found.neighbours.begin(), found.neighbours.end());
        constexpr double cell = 0.03;
        std::vector<std::set<std::pair<long, long>>> cells(3);
        for (std::size_t a = 0; a < 3; ++a)
            for (const Complex z : points.of[a])
                cells[a].insert({std::lround(z.real() / cell), std::lround(z.imag() / cell)});
        for (std::int64_t x = -2; x <= 2; ++x)
            for (std::int64_t y = -2; y <= 2; ++y)
                for (std::int64_t z = -2; z <= 2; ++z)
                    for (std::size_t a = 0; a < 3; ++a)
                        for (std::size_t b = 0; b < 3; ++b) {
                            const RauzyNeighbour pair{a, b, {x, y, z}};
                            const Complex moved = static_cast<double>(x) * points.unit[0] +
                                                  static_cast<double>(y) * points.unit[1] +
                                                  static_cast<double>(z) * points.unit[2];
                            bool near = false;
                            for (const Complex p : points.of[b]) {
                                const Complex q = p + moved;
                                const long i = std::lround(q.real() / cell),
                                           k = std::lround(q.imag() / cell);
                                for (long dx = -1; dx <= 1 && !near; ++dx)
                                    for (long dy = -1; dy <= 1 && !near; ++dy)
                                        near = cells[a].contains({i + dx, k + dy});
                                if (near) break;
                            }
                            if (neighbours.contains(pair)) {
                                CHECK(near);
                                ++meet;
                            } else if (!near) {
                                ++apart;
                            }
                        }
        for (const RauzyNeighbour& pair : found.neighbours) {
            RauzyNeighbour back{pair.other, pair.first, pair.vector};
            for (auto& entry : back.vector) entry = -entry;
            CHECK(neighbours.contains(back));
        }
    }
    MESSAGE(meet, " pairs meet, ", apart, " are apart in points");
    CHECK(meet > 30);
    CHECK(apart > 1'000);
}

TEST_CASE("the functions of a fractal have its parts as states") {
    const IteratedFunctions functions = rauzy_functions(substitution({"ab", "ac", "a"}));
    CHECK(functions.states == std::vector<std::string>{"all", "a", "b", "c"});
    CHECK(functions.maps.size() == 8);
    CHECK(functions.contraction() == doctest::Approx(0.737353));
}

namespace {

/// Whether a point lies within a closed polygon, by how often it goes around.
bool is_within(const std::vector<Point>& polygon, Complex at) {
    int around = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double side = (b.x - a.x) * (at.imag() - a.y) - (b.y - a.y) * (at.real() - a.x);
        if (a.y <= at.imag() && b.y > at.imag() && side > 0) ++around;
        if (a.y > at.imag() && b.y <= at.imag() && side < 0) --around;
    }
    return around != 0;
}

double distance_to(const std::vector<Point>& polygon, Complex at) {
    double least = HUGE_VAL;
    for (const Point& corner : polygon)
        least = std::min(least, std::hypot(corner.x - at.real(), corner.y - at.imag()));
    return least;
}

}  // namespace

TEST_CASE(
    "polygons of Rauzy fractals hold the points of their parts, and their copies tile the plane") {
    std::size_t compared = 0, covered = 0;
    for (const std::vector<std::string>& images : {std::vector<std::string>{"ab", "ac", "a"},
                                                   {"ab", "ca", "a"},
                                                   {"ab", "c", "a"},
                                                   {"aab", "ac", "a"}}) {
        CAPTURE(images);
        const D0L system = substitution(images);
        const auto polygons = rauzy_polygons(system);
        REQUIRE(polygons.size() == 3);
        const Points points = points_of(images, 3'000);
        // The plane of one may be the mirror image of that of the other: letters lie on one side or the other.
        for (std::size_t letter = 0; letter < 3; ++letter) {
            std::size_t far_mirrored = 0, far = 0;
            for (const Complex& at : points.of[letter]) {
                constexpr double grain = 0.05;
                far +=
                    !is_within(polygons[letter], at) && distance_to(polygons[letter], at) > grain;
                far_mirrored += !is_within(polygons[letter], std::conj(at)) &&
                                distance_to(polygons[letter], std::conj(at)) > grain;
            }
            CHECK(std::min(far, far_mirrored) == 0);
            compared += points.of[letter].size();
        }
        // All moves by i (a - c) + k (b - c) of all parts: a point lies in one of them.
        bool mirrored = false;
        for (const Complex& at : points.of[0])
            mirrored =
                mirrored || (!is_within(polygons[0], at) && distance_to(polygons[0], at) > 0.05);
        const auto turned = [&](Complex z) { return mirrored ? std::conj(z) : z; };
        const Complex x = turned(points.unit[0] - points.unit[2]),
                      y = turned(points.unit[1] - points.unit[2]);
        std::size_t once = 0, tries = 0;
        for (int u = 0; u < 12; ++u)
            for (int v = 0; v < 12; ++v) {
                const Complex at = (u + 0.37) / 12.0 * x + (v + 0.61) / 12.0 * y;
                int times = 0;
                for (int i = -6; i <= 6; ++i)
                    for (int k = -6; k <= 6; ++k)
                        for (const auto& polygon : polygons)
                            times += is_within(polygon, at + static_cast<double>(i) * x +
                                                            static_cast<double>(k) * y);
                ++tries;
                once += times == 1;
                CHECK(times >= 0);
            }
        CHECK(once == tries);
        covered += once;
    }
    CHECK(compared >= 12'000);
    CHECK(covered == 4 * 144);
    MESSAGE(compared << " points of parts, " << covered << " points of the plane");
}

TEST_CASE("what fractals look like in their periodic tiling") {
    using Answer = Tile::Answer;
    // Tribonacci: a disc with six neighbours (Rauzy 1982; Messaoudi, Frontiere du fractal de Rauzy, 2000). The flipped one is not
    // (Siegel and Thuswaldner 2009).
    const Tile known = tile(rauzy_lattice_set(substitution({"ab", "ac", "a"})));
    CHECK(known.is_tile.answer == Answer::yes);
    CHECK(known.is_periodic);
    CHECK(known.cells == Rational(1));
    CHECK(known.most_neighbours == 6);
    CHECK(known.connected.answer == Answer::yes);
    CHECK(known.disk_like.answer == Answer::yes);
    const Tile flipped = tile(rauzy_lattice_set(substitution({"ab", "ca", "a"})));
    CHECK(flipped.most_neighbours > 8);
    CHECK(flipped.disk_like.answer == Answer::no);
    for (const std::vector<std::string>& images : {std::vector<std::string>{"ab", "ac", "a"},
                                                   {"ab", "ca", "a"},
                                                   {"aab", "ac", "a"},
                                                   {"abc", "a", "b"}}) {
        const D0L system = substitution(images);
        const RauzyFractal fractal = rauzy_fractal(system);
        const Tile found = tile(rauzy_lattice_set(system));
        if (!fractal.tiles) continue;
        CHECK(found.connected.answer != (fractal.connected ? Answer::no : Answer::yes));
        CHECK(found.neighbours.size() % 2 == 0);
    }
}
