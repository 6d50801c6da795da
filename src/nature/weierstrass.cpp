#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "nature/detail/figures.hpp"

// Weierstrass's function, continuous and without a derivative anywhere, and its graph.
//
// The terms a^n cos(b^n pi x) are summed in doubles. The angle is reduced modulo 2 before it is
// multiplied by pi, and the sum ends where the frequency times x is too large for the angle to be
// known. The dimension of the graph is 2 + log a / log b: the box dimension for all parameters
// (Kaplan, Mallet-Paret and Yorke 1984), the Hausdorff dimension for whole numbers b (Shen 2018).

namespace algae {

namespace {

constexpr std::size_t measured_points = std::size_t{1} << 18;
constexpr double breadth = 2;

std::vector<Path> graph(const WeierstrassFunction& function, double from, double to,
                        std::uint64_t count, std::size_t points, const Budget& budget) {
    std::vector<double> heights;
    for (std::size_t i = 0; i <= points; ++i) {
        if (i % 1024 == 0) budget.check();
        heights.push_back(function.sum(
            from + (to - from) * static_cast<double>(i) / static_cast<double>(points), count));
    }
    return {{.points = graph_path(heights, breadth)}};
}

}  // namespace

void WeierstrassFunction::check() const {
    require(a > 0 && a < 1, "a: expected a number between 0 and 1, found {}", {a});
    require(b > 1 && std::isfinite(b), "b: expected a number above 1, found {}", {b});
    require(a * b >= 1,
            "a b: expected at least 1, below which the function has a derivative, found {} * {} = "
            "{:.6g}",
            {a, b, a * b});
    const auto check_terms = [](std::uint64_t count) {
        require(count >= 1 && count <= 1000, "terms: expected 1 to 1000, found {}", {count});
    };
    std::ranges::for_each(terms, check_terms);
    check_terms(most_terms);
    require(zooms <= 12, "zoom: expected 0 to 12, found {}", {zooms});
    require(from < to, "interval: expected from < to, found {} and {}", {from, to});
    require(points >= 2 && points <= 10'000'000, "points: expected 2 to 10000000, found {}",
            {std::uint64_t{points}});
}

double WeierstrassFunction::sum(double x, std::uint64_t count) const {
    double total = 0, height = 1, frequency = 1;
    for (std::uint64_t n = 0; n < count; ++n) {
        // Beyond this, the angle is not known to a thousandth of a turn.
        if (frequency * std::max(std::fabs(x), 1.0) > 1e13) break;
        total += height * std::cos(std::numbers::pi * std::fmod(frequency * x, 2.0));
        height *= a;
        frequency *= b;
    }
    return total;
}

double WeierstrassFunction::dimension() const { return 2 + std::log(a) / std::log(b); }

std::vector<GeneratorFigure> WeierstrassFunction::figures(const Budget& budget) const {
    check();
    std::vector<GeneratorFigure> made;
    const auto add = [&](double left, double right, std::uint64_t count, const std::string& what) {
        made.push_back(pictured(*this, graph(*this, left, right, count, points, budget), what));
    };
    for (const std::uint64_t count : terms) add(from, to, count, counted(count, "term"));
    if (!terms.empty() && zooms == 0) return made;
    for (std::uint64_t k = 0; k <= zooms; ++k) {
        // Around the lower quarter, so that the parts lie within each other.
        const double middle = from + (to - from) / 4, scale = std::pow(b, static_cast<double>(k));
        const double left = k == 0 ? from : middle - (to - from) / 2 / scale;
        const double right = k == 0 ? to : middle + (to - from) / 2 / scale;
        add(left, right, most_terms,
            k == 0 ? fmt::format("x from {:.4g} to {:.4g}", left, right)
                   : fmt::format("x from {:.4g} to {:.4g}, {:.4g} times as large", left, right,
                                 scale));
    }
    return made;
}

GeneratorFigure WeierstrassFunction::measured_figure(const Budget& budget) const {
    check();
    return {std::make_unique<PathFigure>(
                graph(*this, from, to, most_terms, measured_points, budget), style),
            heading() + ", the graph by " + std::to_string(measured_points) + " segments", ""};
}

std::vector<GeneratorFact> WeierstrassFunction::facts(const Budget&) const {
    check();
    const bool whole = b == std::floor(b);
    std::vector<GeneratorFact> found;
    found.push_back({"function",
                     fmt::format("the sum of {}^n cos({}^n pi x), n = 0, 1, 2, ...", a, b),
                     {{"a", a}, {"b", b}}});
    found.push_back(
        {"dimension",
         fmt::format("2 + log {} / log {} = {:.6f}, of the graph: the box dimension "
                     "(Kaplan, Mallet-Paret and Yorke 1984){}",
                     a, b, dimension(),
                     whole && a * b > 1 ? " and the Hausdorff dimension (Shen 2018)" : ""),
         dimension()});
    found.push_back({"derivative",
                     std::string("none anywhere (Hardy 1916)") +
                         (a * b > 1 + 1.5 * std::numbers::pi && whole && std::fmod(b, 2) == 1
                              ? ", by Weierstrass's own proof"
                              : ""),
                     nullptr});
    return found;
}

}  // namespace algae
