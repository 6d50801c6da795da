#include <fmt/format.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <kissfft/kissfft.hh>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "nature/detail/figures.hpp"
#include "nature/detail/random.hpp"
#include "watch/watch.hpp"

// Random walks and fractional Brownian motion, in one to three dimensions.
//
// All chance comes from numbers with a position: number k of a stream of a seed is the same in
// whatever order it is asked for. Two draws give two normal numbers (Box and Muller 1958).
//
// Fractional Brownian motion with the exponent H has var(X(t) - X(s)) = sigma^2 |t - s|^(2H)
// (Mandelbrot and Van Ness 1968). Two methods:
//
// - `midpoint_path`: random midpoint displacement (Fournier, Fussell and Carpenter 1982). Fast, and
//   coarser paths are parts of finer ones, but for H != 1/2 increments are not stationary;
//   `midpoint_increment_variance` computes by how much, exactly, by following both ends of an
//   increment up the levels.
// - `exact_path`: the covariance of the increments is embedded in a circulant matrix of twice the
//   size, whose eigenvalues are its Fourier transform and are not negative; the square root times
//   white noise, transformed again, has exactly the distribution (Davies and Harte 1987). For large
//   lags the covariance is a difference of nearly equal powers and is computed as a series.
//
// H is estimated from second differences over one and two steps, whose error falls as the root of
// the number of values for every H.
//
// KISS FFT is used through `fourier_transform` only.

namespace algae {

double Gaussians::at(std::uint64_t position) const {
    const std::uint64_t first = position & ~std::uint64_t{1};
    const double radius = std::sqrt(-2 * std::log(unit_interval(draws_.at(first))));
    const double angle = 2 * std::numbers::pi * unit_interval(draws_.at(first + 1));
    return radius * (position == first ? std::cos(angle) : std::sin(angle));
}

std::vector<std::complex<double>> fourier_transform(
    const std::vector<std::complex<double>>& values) {
    if (values.empty()) return {};
    const kissfft<double> transform(values.size(), false);
    std::vector<std::complex<double>> out(values.size());
    transform.transform(values.data(), out.data());
    return out;
}

void fourier_transform_square(std::vector<std::complex<double>>& values, std::size_t side) {
    if (side == 0) return;
    const kissfft<double> transform(side, false);
    std::vector<std::complex<double>> line(side), out(side);
    for (std::size_t row = 0; row < side; ++row) {
        transform.transform(values.data() + row * side, out.data());
        std::copy(out.begin(), out.end(), values.begin() + static_cast<std::ptrdiff_t>(row * side));
    }
    for (std::size_t column = 0; column < side; ++column) {
        for (std::size_t row = 0; row < side; ++row) line[row] = values[row * side + column];
        transform.transform(line.data(), out.data());
        for (std::size_t row = 0; row < side; ++row) values[row * side + column] = out[row];
    }
}

namespace {

void check_dimensions(int dimensions) {
    require(dimensions >= 1 && dimensions <= 3, "dimensions: expected 1, 2 or 3, found {}",
            {dimensions});
}

}  // namespace

std::vector<Vector> random_walk(const RandomWalk& walk, const Budget& budget) {
    check_dimensions(walk.dimensions);
    require(walk.deviation > 0 && std::isfinite(walk.deviation),
            "deviation: expected a number above 0, found {:f}", {walk.deviation});
    if (walk.steps >= budget.memory / sizeof(Vector))
        throw BoundReached(Bound::memory,
                           fmt::format("a walk of {} steps takes more memory than the {} bytes "
                                       "allowed{}; use fewer steps",
                                       walk.steps, budget.memory, budget.by(Bound::memory)));
    const Gaussians across(walk.seed, 0), along(walk.seed, 1), upward(walk.seed, 2);
    std::vector<Vector> places(walk.steps + 1);
    WorkCount steps("step", walk.steps);
    for (std::uint64_t t = 0; t < walk.steps; ++t) {
        if (t % 4096 == 0) budget.check();
        steps.at(t);
        const double y = walk.dimensions > 1 ? along.at(t) : 0;
        const double z = walk.dimensions > 2 ? upward.at(t) : 0;
        places[t + 1] = places[t] + walk.deviation * Vector{across.at(t), y, z};
    }
    return places;
}

namespace {

/// A rod without thickness from each place to the next, in the colours of the style.
Scene path_scene(const std::vector<Vector>& places, const Generator& walker) {
    Scene made;
    made.name = walker.heading();
    made.colours = walker.style.colours;
    for (std::uint32_t i = 1; i < places.size(); ++i) {
        Rod rod;
        rod.from = places[i - 1];
        rod.to = places[i];
        if (i > 1) rod.before = i - 2;
        made.rods.push_back(rod);
    }
    return made;
}

/// The places as the usual camera sees them from far away.
std::vector<Point> seen_path(const std::vector<Vector>& places) {
    SpaceBox box;
    for (const Vector& place : places) box.add(place);
    if (box.empty) return {};
    const Projection projection(Camera{}, box);
    std::vector<Point> points;
    points.reserve(places.size());
    for (const Vector& place : places) {
        const Seen seen = projection(place);
        points.push_back({seen.x, seen.y});
    }
    return points;
}

/// A walk as a line: in one dimension its graph against time, in two its path, in three its path as
/// it is seen.
Path walk_path(const std::vector<Vector>& places, int dimensions) {
    Path path;
    if (dimensions == 1) {
        std::vector<double> heights;
        for (const Vector& place : places) heights.push_back(place.x);
        path.points = graph_path(heights, 2);
    } else if (dimensions == 2) {
        for (const Vector& place : places) path.points.push_back({place.x, place.y});
    } else {
        path.points = seen_path(places);
    }
    return path;
}

std::vector<Vector> longest(const RandomWalks& walks, const Budget& budget) {
    walks.check();
    RandomWalk walk = walks.walk;
    walk.steps = *std::max_element(walks.steps.begin(), walks.steps.end());
    return random_walk(walk, budget);
}

}  // namespace

void RandomWalks::check() const {
    require(!steps.empty() && std::ranges::count(steps, 0u) == 0,
            "steps: expected at least 1, found 0");
    RandomWalk short_walk = walk;
    short_walk.steps = 0;
    random_walk(short_walk, {});
}

std::vector<GeneratorFigure> RandomWalks::figures(const Budget& budget) const {
    const std::vector<Vector> all = longest(*this, budget);
    std::vector<GeneratorFigure> made;
    for (const std::uint64_t count : steps) {
        const std::vector<Vector> places(all.begin(),
                                         all.begin() + static_cast<std::ptrdiff_t>(count) + 1);
        made.push_back(pictured(*this, {walk_path(places, walk.dimensions)},
                                counted(count, "step") + ", seed " + std::to_string(walk.seed)));
    }
    return made;
}

std::vector<GeneratorFact> RandomWalks::facts(const Budget& budget) const {
    const std::vector<Vector> all = longest(*this, budget);
    std::vector<GeneratorFact> found;
    found.push_back({"dimensions", std::to_string(walk.dimensions), walk.dimensions});
    found.push_back({"seed", std::to_string(walk.seed), walk.seed});
    for (const std::uint64_t count : steps) {
        const Vector end = all[count];
        // Each of `count` steps adds the square of the deviation in each dimension.
        const double expected =
            walk.deviation * std::sqrt(static_cast<double>(count) * walk.dimensions);
        const double distance = length(end);
        found.push_back(
            {fmt::format("after_{}_steps", count),
             fmt::format(
                 "{:.6g} from the start; the root of the mean square of all walks is {:.6g}",
                 distance, expected),
             {{"distance", distance}, {"expected", expected}}});
    }
    return found;
}

std::optional<Scene> RandomWalks::scene(const Budget& budget) const {
    if (walk.dimensions != 3) return std::nullopt;
    return path_scene(longest(*this, budget), *this);
}

void check_parameters(const BrownianMotion& motion) {
    constexpr int most = BrownianMotion::most_levels;
    require(motion.hurst > 0 && motion.hurst < 1,
            "hurst: expected a number between 0 and 1, found {}", {motion.hurst});
    require(motion.sigma > 0 && std::isfinite(motion.sigma),
            "sigma: expected a number above 0, found {}", {motion.sigma});
    require(motion.levels >= 0 && motion.levels <= most, "levels: expected 0 to {}, found {}",
            {most, motion.levels});
}

double displacement_variance(const BrownianMotion& motion, int level) {
    return motion.sigma * motion.sigma * std::exp2(-2 * motion.hurst * level) *
           (1 - std::exp2(2 * motion.hurst - 2));
}

std::vector<double> midpoint_path(const BrownianMotion& motion, const Gaussians& numbers,
                                  const Budget& budget) {
    check_parameters(motion);
    const std::size_t pieces = std::size_t{1} << motion.levels;
    budget.check_memory((pieces + 1) * sizeof(double), "a path");
    std::vector<double> path(pieces + 1);
    path[pieces] = motion.sigma * numbers.at(0);
    WorkCount levels("level", static_cast<std::uint64_t>(motion.levels));
    for (int level = 1; level <= motion.levels; ++level) {
        budget.check();
        levels.at(static_cast<std::uint64_t>(level));
        const double deviation = std::sqrt(displacement_variance(motion, level));
        const std::size_t half = pieces >> level;  // from a midpoint to its neighbours
        std::uint64_t number = std::uint64_t{1} << (level - 1);
        for (std::size_t i = half; i < pieces; i += 2 * half)
            path[i] = (path[i - half] + path[i + half]) / 2 + deviation * numbers.at(number++);
    }
    return path;
}

double midpoint_increment_variance(const BrownianMotion& motion, std::uint64_t from,
                                   std::uint64_t to) {
    check_parameters(motion);
    const std::uint64_t pieces = std::uint64_t{1} << motion.levels;
    require(from <= pieces && to <= pieces, "expected values 0 to {} of a path, found {} and {}",
            {pieces, from, to});
    // The increment as a sum of values times factors; at most four of them at every level.
    std::map<std::uint64_t, double> factors;
    factors[to] += 1;
    factors[from] -= 1;
    double variance = 0;
    for (int level = motion.levels; level >= 1; --level) {
        std::map<std::uint64_t, double> above;
        for (const auto& [place, factor] : factors) {
            if (place % 2 == 0) {
                above[place / 2] += factor;
                continue;
            }
            variance += factor * factor * displacement_variance(motion, level);
            above[place / 2] += factor / 2;
            above[place / 2 + 1] += factor / 2;
        }
        factors = std::move(above);
    }
    return variance + factors[1] * factors[1] * motion.sigma * motion.sigma;
}

double increment_covariance(double hurst, std::uint64_t lag) {
    const double exponent = 2 * hurst, k = static_cast<double>(lag);
    if (lag == 0) return 1;
    if (lag < 16)
        return (std::pow(k + 1, exponent) + std::pow(k - 1, exponent)) / 2 - std::pow(k, exponent);
    // k^(2H) times the even part of the binomial series in 1/k, without its first term.
    double term = 1, sum = 0;
    for (int j = 1; j <= 8; ++j) {
        term *=
            (exponent - (2 * j - 2)) * (exponent - (2 * j - 1)) / ((2 * j - 1) * (2 * j) * k * k);
        sum += term;
    }
    return std::pow(k, exponent) * sum;
}

std::vector<double> exact_path(const BrownianMotion& motion, const Gaussians& numbers,
                               const Budget& budget) {
    check_parameters(motion);
    const std::size_t steps = std::size_t{1} << motion.levels, around = 2 * steps;
    budget.check_memory(5 * around * sizeof(std::complex<double>), "a path");
    std::vector<std::complex<double>> values(around);
    WorkCount lags("covariance", steps);
    for (std::size_t lag = 0; lag <= steps; ++lag) {
        if (lag % 4096 == 0) budget.check();
        lags.at(lag);
        values[lag] = increment_covariance(motion.hurst, lag);
        if (lag > 0 && lag < steps) values[around - lag] = values[lag];
    }
    WorkCount frequencies("frequency", around);
    values = fourier_transform(values);
    for (std::size_t k = 0; k < around; ++k) {
        if (k % 4096 == 0) budget.check();
        frequencies.at(k);
        const double share = std::max(values[k].real(), 0.0) / static_cast<double>(around);
        values[k] = std::sqrt(share) * std::complex(numbers.at(2 * k), numbers.at(2 * k + 1));
    }
    budget.check();
    values = fourier_transform(values);
    const double scale = motion.sigma * std::exp2(-motion.hurst * motion.levels);
    std::vector<double> path(steps + 1);
    for (std::size_t i = 0; i < steps; ++i) path[i + 1] = path[i] + scale * values[i].real();
    return path;
}

double estimated_hurst(const std::vector<double>& path) {
    require(path.size() >= 6, "expected a path of at least 6 values, found {}",
            {std::uint64_t{path.size()}});
    const auto mean_square = [&](std::size_t step) {
        double sum = 0;
        const std::size_t count = path.size() - 2 * step;
        for (std::size_t i = 0; i < count; ++i) {
            const double second = path[i + 2 * step] - 2 * path[i + step] + path[i];
            sum += second * second;
        }
        return sum / static_cast<double>(count);
    };
    const double near = mean_square(1), far = mean_square(2);
    require(near > 0 && far > 0, "expected a rough path, found values on a line");
    return std::log2(far / near) / 2;
}

void BrownianPaths::check() const {
    require(!hurst.empty(), "hurst: expected a number between 0 and 1, found none");
    for (const double h : hurst)
        for (const int level : {levels.first, levels.second}) check_parameters({h, sigma, level});
    check_dimensions(dimensions);
}

std::vector<std::vector<double>> BrownianPaths::coordinates(double h, int level,
                                                            const Budget& budget) const {
    std::vector<std::vector<double>> made;
    for (int k = 0; k < dimensions; ++k) {
        const Gaussians numbers(seed, static_cast<std::uint64_t>(k));
        made.push_back(exact ? exact_path({h, sigma, level}, numbers, budget)
                             : midpoint_path({h, sigma, level}, numbers, budget));
    }
    return made;
}

std::vector<Vector> BrownianPaths::places(double h, int level, const Budget& budget) const {
    const auto of = coordinates(h, level, budget);
    std::vector<Vector> made(of[0].size());
    for (std::size_t i = 0; i < made.size(); ++i)
        made[i] = {of[0][i], dimensions > 1 ? of[1][i] : 0, dimensions > 2 ? of[2][i] : 0};
    return made;
}

std::vector<GeneratorFigure> BrownianPaths::figures(const Budget& budget) const {
    check();
    std::vector<GeneratorFigure> made;
    WorkCount paths("path",
                    hurst.size() * static_cast<std::size_t>(levels.second - levels.first + 1));
    for (const double h : hurst)
        for (int level = levels.first; level <= levels.second; ++level) {
            ++paths;
            std::string caption = fmt::format("H = {}", h);
            if (levels.first != levels.second)
                caption = (hurst.size() > 1 ? caption + ", " : "") +
                          counted(static_cast<std::uint64_t>(level), "displacement");
            made.push_back(
                pictured(*this, {walk_path(places(h, level, budget), dimensions)}, caption));
        }
    return made;
}

std::vector<GeneratorFact> BrownianPaths::facts(const Budget& budget) const {
    check();
    std::vector<GeneratorFact> found;
    found.push_back({"method", exact ? "exact, by circulant embedding" : "midpoint displacement",
                     exact ? "exact" : "midpoint"});
    found.push_back({"seed", std::to_string(seed), seed});
    for (const double h : hurst) {
        const std::string of = hurst.size() > 1 ? fmt::format("_for_H_{}", h) : "";
        const double dimension = dimensions == 1 ? 2 - h : std::min(1 / h, 1.0 * dimensions);
        found.push_back({"dimension" + of,
                         dimensions == 1
                             ? fmt::format("2 - H = {:.6g} almost surely, of the graph", dimension)
                             : fmt::format("min(1/H, {}) = {:.6g} almost surely, of the path",
                                           dimensions, dimension),
                         dimension});
        if (levels.second >= 3) {
            const double estimate = estimated_hurst(coordinates(h, levels.second, budget)[0]);
            found.push_back(
                {"estimated_H" + of,
                 fmt::format("{:.4f}, from second differences of the first coordinate", estimate),
                 estimate});
        }
        if (exact || levels.second < 2) continue;
        const BrownianMotion two{h, sigma, 2};
        const double wanted = sigma * sigma * std::exp2(-2 * h);
        const double middle = midpoint_increment_variance(two, 1, 3);
        found.push_back(
            {"variance_over_half_the_time" + of,
             fmt::format("{:.6g} at the beginning and {:.6g} in the middle; {}",
                         midpoint_increment_variance(two, 0, 2), middle,
                         h == 0.5 ? "the same, as it should be"
                                  : fmt::format("fractional Brownian motion has {:.6g} everywhere",
                                                wanted)),
             {{"beginning", midpoint_increment_variance(two, 0, 2)},
              {"middle", middle},
              {"wanted", wanted}}});
    }
    return found;
}

std::optional<Scene> BrownianPaths::scene(const Budget& budget) const {
    check();
    if (dimensions != 3) return std::nullopt;
    return path_scene(places(hurst.back(), levels.second, budget), *this);
}

}  // namespace algae
