#pragma once
// Curves whose Hausdorff dimension is known, and random generators of such curves.

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace algae {

struct KnownCurve {
    std::string name;
    std::string system;  // in the notation
    double dimension = 0;
};

/// From the literature: Koch 1904, Mandelbrot 1982, Dekking 1982, Davis and Knuth 1970, Levy 1938,
/// Gilbert 1982, Prusinkiewicz and Lindenmayer 1990. Those where pieces coincide have the dimension
/// of the different pieces.
inline const std::vector<KnownCurve>& known_curves() {
    static const double koch = std::log(4) / std::log(3), five = std::log(5) / std::log(3),
                        gasket = std::log(3) / std::log(2), island = std::log(18) / std::log(6);
    static const std::vector<KnownCurve> all{
        {"Koch curve", "axiom F; F -> F+F--F+F; angle 60", koch},
        {"Koch snowflake", "axiom F--F--F; F -> F+F--F+F; angle 60", koch},
        {"quadratic Koch curve", "axiom F; F -> F+F-F-F+F; angle 90", five},
        {"Minkowski sausage", "axiom F-F-F-F; F -> F-F+F+FF-F-F+F; angle 90", 1.5},
        {"quadratic Koch island", "axiom F-F-F-F; F -> F+FF-FF-F-F+F+FF-F-F+F+FF+FF-F; angle 90",
         island},
        {"islands and lakes",
         "axiom F+F+F+F; F -> F+f-FF+F+FF+Ff+FF-f+FF-F-FF-Ff-FFF; f -> ffffff; angle 90", island},
        {"Koch variation with coinciding pieces", "axiom F-F-F-F; F -> FF-F-F-F-F-F+F; angle 90",
         std::log(6) / std::log(std::sqrt(10))},
        {"Koch variation with a spike", "axiom F-F-F-F; F -> FF-F--F-F; angle 90", five},
        {"Cesaro curve", "axiom F; F -> F+F--F+F; angle 90", 2},
        {"pentadendrite", "axiom F; F -> F+F-F--F+F+F; angle 72", 1.69953985},
        {"pentaplexity", "axiom F++F++F++F++F; F -> F++F++F|F-F++F; angle 36", 1.86171596},
        {"Heighway dragon", "axiom F_l; F_l -> -F_l++F_r-; F_r -> +F_l--F_r+; angle 45", 2},
        {"twindragon", "axiom F_l++++F_l; F_l -> -F_l++F_r-; F_r -> +F_l--F_r+; angle 45", 2},
        {"terdragon", "axiom F; F -> F+F-F; angle 120", 2},
        {"cross", "axiom F+F+F+F; F -> F+FF++F+F; angle 90", 2},
        {"Gosper curve",
         "axiom F_l; F_l -> F_l-F_r--F_r+F_l++F_lF_l+F_r-; F_r -> +F_l-F_rF_r--F_r-F_l++F_l+F_r; "
         "angle 60",
         2},
        {"Hilbert curve", "axiom X; X -> -YF+XFX+FY-; Y -> +XF-YFY-FX+; angle 90", 2},
        {"Peano curve", "axiom X; X -> XFYFX+F+YFXFY-F-XFYFX; Y -> YFXFY-F-XFYFX+F+YFXFY; angle 90",
         2},
        {"Sierpinski curve", "axiom F+XF+F+XF; X -> XF-F+F-XF+F+XF-F+F-X; angle 90", 2},
        {"arrowhead", "axiom F_a; F_a -> +F_b-F_a-F_b+; F_b -> -F_a+F_b+F_a-; angle 60", gasket},
        {"gasket", "axiom F-F_g-F_g; F -> F-F_g+F+F_g-F; F_g -> F_gF_g; angle 120", gasket},
        {"Vicsek tree", "axiom F; F -> F[+F][-F]FF; angle 90", five},
        {"right-angled tree", "axiom F; F -> F[+F]F[-F]F; angle 90", five},
        {"Cantor set", "axiom F; F -> FfF; f -> fff; angle 90", std::log(2) / std::log(3)},
        {"hexagonal Koch variation", "axiom F+F+F; F -> F+F-F+F; angle 60", 2},
    };
    return all;
}

/// Whether no two edges of the curve coincide, in either direction, up to some ten thousand edges. On
/// a lattice, where pieces that do not coincide satisfy the open set condition, the dimension is then
/// log of the number of edges over log of the distance.
inline bool has_distinct_edges(const std::vector<int>& headings,
                               const std::vector<std::pair<long, long>>& units) {
    const int order = static_cast<int>(units.size());
    std::vector<int> path{0};
    while (path.size() * headings.size() <= 60'000) {
        std::vector<int> next;
        for (const int a : path)
            for (const int b : headings) next.push_back((a + b) % order);
        path = std::move(next);
    }
    std::set<std::pair<long, long>> middles;
    long x = 0, y = 0;
    for (const int heading : path) {
        const auto [dx, dy] = units[static_cast<std::size_t>(heading)];
        if (!middles.emplace(2 * x + dx, 2 * y + dy).second) return false;
        x += dx;
        y += dy;
    }
    return true;
}

/// A curve from a random generator: a path on the square or triangular lattice without coinciding
/// pieces, or Koch's generator with a random angle.
inline KnownCurve random_curve(std::mt19937_64& random) {
    const auto below = [&](std::uint64_t bound) { return static_cast<int>(random() % bound); };
    const int kind = below(4);
    if (kind == 0) {
        const int tenths = 200 + below(600);
        const double radians = tenths * std::numbers::pi / 1800;
        const std::string degrees = std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
        return {"Koch at " + degrees, "axiom F; F -> F+F--F+F; angle " + degrees,
                std::log(4) / std::log(2 + 2 * std::cos(radians))};
    }
    const bool square = kind == 1;
    const std::vector<std::pair<long, long>> units =
        square ? std::vector<std::pair<long, long>>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}
               : std::vector<std::pair<long, long>>{{1, 0},  {0, 1},  {-1, 1},
                                                    {-1, 0}, {0, -1}, {1, -1}};
    const int order = static_cast<int>(units.size());
    while (true) {
        std::string rule = "F";
        std::vector<int> headings{0};
        const int edges = 3 + below(7);
        while (static_cast<int>(headings.size()) < edges) {
            const int most = square ? 1 : 2,
                      turn = below(static_cast<std::uint64_t>(2 * most + 1)) - most;
            rule +=
                std::string(static_cast<std::size_t>(std::abs(turn)), turn > 0 ? '+' : '-') + "F";
            headings.push_back((headings.back() + turn + order) % order);
        }
        if (headings.back() != 0) continue;
        std::complex<double> end = 0;
        for (const int heading : headings)
            end += std::polar(1.0, 2 * std::numbers::pi * heading / order);
        if (std::abs(end) < 1.5) continue;
        const double dimension = std::log(edges) / std::log(std::abs(end));
        if (dimension < 1.02 || dimension > 2 + 1e-9 || !has_distinct_edges(headings, units))
            continue;
        return {rule, "axiom F; F -> " + rule + "; angle " + (square ? "90" : "60"), dimension};
    }
}

}  // namespace algae
