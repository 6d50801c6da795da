#include <fmt/format.h>

#include <algorithm>

#include "dimension/detail/cells.hpp"
#include "dimension/detail/measures.hpp"
#include "watch/watch.hpp"

// Two measures by distance: the mass within discs around random places (Tel, Fueloep and Vicsek
// 1989), and the correlation sum, the share of pairs of points within a radius (Grassberger and
// Procaccia 1983).
//
// Radii are a whole and its halves, so how many radii reach a distance follows from the exponents
// of two floating-point numbers (`halved_radii`), and sums are kept per ring and added up at the
// end. Of a segment that a disc cuts, the part within is added; of all greater discs the whole.
//
// For the correlation sum, points are sorted by cells as wide as the greatest radius, and each
// point is compared with those in half of the cells around its own, so that every pair is seen
// once.
//
// Radii that hold fewer than four other points on average say little and are not used.
//
// Points with noise are told from points that fill an area by how their slopes reach the dimension of the space: along the edge
// of an area what is missing shrinks by a constant ratio from radius to radius, with noise it stays and then is gone within two or
// three. The thresholds were found by trial over twenty sets with and without noise.

namespace algae {

namespace {

constexpr double fewest_neighbours = 4;

/// The radii that points can say something at: those with at least four other points within them on
/// average and of at least four points' size. `means` falls with the radii.
ScaleRange points_range(const PointSet& points, const std::vector<double>& radii,
                        const std::vector<double>& means, const std::string& scales) {
    ScaleRange range{HUGE_VAL, radii.front()};
    for (std::size_t i = 0; i < radii.size() && means[i] >= fewest_neighbours; ++i)
        range.finest = radii[i];
    range.finest = std::max(range.finest, ScaleRange::details * points.detail);
    range.scales = scales;
    range.finest_is = "those with 4 other " + points.part + "s within them on average";
    if (points.detail > 0) range.finest_is += " and 4 times the size of a detail";
    range.finer_ones_see = "single " + points.part + "s";
    return range;
}

/// Sums per radius: what lies within a radius lies within all greater ones.
class Masses {
public:
    explicit Masses(std::vector<double> radii)
        : radii_(std::move(radii)), greatest_(radii_.front()), within_(radii_.size()) {}

    void add_segment(Point from, Point to, double length, Point centre) {
        const double x = (from.x + to.x) / 2 - centre.x, y = (from.y + to.y) / 2 - centre.y;
        const double reach = greatest_ + length / 2;
        if (std::abs(x) >= reach || std::abs(y) >= reach) return;
        const double away = std::sqrt(x * x + y * y);
        const double nearest = away - length / 2, farthest = away + length / 2;
        if (nearest >= greatest_) return;
        std::size_t i = halved_radii(greatest_, farthest, radii_.size());
        if (i > 0) within_[i - 1] += length;
        for (; i < radii_.size() && radii_[i] > nearest; ++i) {
            const double part = length_within(from, to, centre, radii_[i]);
            within_[i] += part;
            if (i > 0) within_[i - 1] -= part;  // the sum below gives it to all greater ones
        }
    }
    void add_point(double away) {
        const std::size_t i = halved_radii(greatest_, away, radii_.size());
        if (i > 0) within_[i - 1] += 1;
    }
    /// The sums, divided.
    std::vector<double> means(double count) const {
        std::vector<double> all = within_;
        for (std::size_t i = all.size() - 1; i-- > 0;) all[i] += all[i + 1];
        for (double& mean : all) mean /= count;
        return all;
    }

private:
    std::vector<double> radii_;
    double greatest_;
    std::vector<double> within_;  // the radius and no smaller one
};

void check_centres(const Sandboxes& sandboxes) {
    if (sandboxes.centres == 0) throw Error("expected at least one centre, found 0");
}

constexpr double pairs_that_tell = 1000;  // their number is then known to about 3 %
constexpr std::size_t points_that_tell = 5000;

/// Whether there are enough points, and no cells of a picture, to tell noise.
bool may_show_noise(const PointSet& points) {
    return points.detail == 0 && points.columns >= 2 && points.points.size() >= points_that_tell;
}

/// Whether slopes bend to the dimension of the space as those of noisy points do.
bool bend_to(const std::vector<double>& slopes, double space) {
    constexpr double filled = 0.08, least = 0.12, stays = 0.65, gone = 0.36;
    const std::size_t n = slopes.size();
    if (n < 4 || space - (slopes[n - 1] + slopes[n - 2]) / 2 > filled) return false;
    for (std::size_t k = 0; k + 2 < n; ++k) {
        const double missing = space - slopes[k];
        if (missing >= least && missing >= stays * (space - slopes[0]) &&
            space - slopes[k + 2] <= gone * missing)
            return true;
    }
    return false;
}

/// How far the steps of a sum are from those found, and the farthest of them as a slope.
struct Distance {
    double squares = HUGE_VAL, farthest = 0;
};

Distance distance_of(double dimension, int space, double noise, const std::vector<double>& sizes,
                     const std::vector<double>& slopes) {
    constexpr double first_weighs = 0.25;  // it sees the outer shape
    Distance found{0, 0};
    double coarser = noisy_correlation(dimension, space, noise, sizes[0]);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const double finer = noisy_correlation(dimension, space, noise, sizes[i + 1]);
        const double off = slopes[i] - (coarser - finer) / std::log(sizes[i] / sizes[i + 1]);
        found.squares += (i == 0 ? first_weighs : 1) * off * off;
        found.farthest = std::max(found.farthest, std::abs(off));
        coarser = finer;
    }
    return found;
}

/// Frees the estimate of noise, if there is any. `pairs` is how many there are within each radius.
void heed_noise(Scaling& scaling, const std::vector<double>& pairs, const PointSet& points) {
    if (!may_show_noise(points)) return;
    std::vector<double> slopes;
    for (std::size_t i = 0; i + 1 < pairs.size() && pairs[i + 1] >= pairs_that_tell; ++i)
        slopes.push_back(scaling.slopes[i]);
    if (!bend_to(slopes, points.columns)) return;
    const std::vector<double>& sizes = scaling.sizes;
    double noise = 0, dimension = 0;
    Distance best;
    const auto look = [&](double from, double to, double ratio, double low, double high,
                          double step) {
        for (double n = from; n <= to; n *= ratio)
            for (double d = std::max(low, step); d <= high && d < points.columns; d += step) {
                const Distance found = distance_of(d, points.columns, n, sizes, slopes);
                if (!(found.squares < best.squares)) continue;
                best = found;
                noise = n;
                dimension = d;
            }
    };
    constexpr double rough_ratio = 1.1, rough_step = 1.0 / 32;
    look(sizes[slopes.size()] / 8, sizes[0], rough_ratio, 0, points.columns, rough_step);
    const double around_noise = noise, around_dimension = dimension;
    look(around_noise / rough_ratio, around_noise * rough_ratio, 1.01,
         around_dimension - rough_step, around_dimension + rough_step, rough_step / 16);
    if (noise == 0) return;
    // Found by trial, as those of other intervals: the outer shape bends the few radii above much noise.
    const double whole = sizes[0] * ScaleRange::parts_of_whole;
    const double around = 0.035 + best.farthest + 6 * noise / whole;
    scaling.noise = noise;
    scaling.first = 0;
    scaling.last = slopes.size();
    scaling.estimate = Estimate{dimension, std::max(dimension - around, 0.0),
                                std::min(dimension + around, static_cast<double>(points.columns))};
    scaling.because = fmt::format(
        "the slopes bend to {}, so points were moved by chance, by a standard deviation of {:.2g} "
        "each way: the dimension and the "
        "noise that explain the radii from {:.3g} down to {:.3g} best",
        points.columns, noise, sizes[0], sizes[slopes.size()]);
}

Scaling fitted(std::vector<double> radii, std::vector<double> means, ScaleRange range,
               double space) {
    range.follow_rises =
        true;  // balls beyond the ends of the set hold too little, the less the smaller
    Scaling result;
    result.sizes = std::move(radii);
    result.values = std::move(means);
    std::vector<double> powers;
    for (const double mean : result.values) powers.push_back(std::log(mean));
    fit_scaling(result, powers, range, {1, 1, 0}, space);
    return result;
}

}  // namespace

double noisy_correlation(double dimension, int space, double noise, double radius) {
    const double a = (space - dimension) / 2, b = space / 2.0 + 1;
    const double u = radius * radius / (4 * noise * noise);
    constexpr double large = 60;
    double sum = 1, term = 1;
    if (u < large) {
        // 1F1(a; b; -u) = e^-u 1F1(b - a; b; u), whose terms are positive.
        for (int k = 0; term > 1e-16 * sum; ++k) {
            term *= (b - a + k) / (b + k) * u / (k + 1);
            sum += term;
        }
        return space * std::log(radius) + std::log(sum) - u;
    }
    for (int k = 0; k < 20; ++k) {
        term *= (a + k) * (a - b + 1 + k) / ((k + 1) * u);
        sum += term;
    }
    return space * std::log(radius) + std::lgamma(b) - std::lgamma(b - a) - a * std::log(u) +
           std::log(sum);
}

double length_within(Point from, Point to, Point centre, double radius) {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    if (!(length > 0)) return 0;
    const double fx = from.x - centre.x, fy = from.y - centre.y;
    const double foot = -(fx * dx + fy * dy) / length, aside = (fx * dy - fy * dx) / length;
    if (std::abs(aside) >= radius) return 0;
    const double half = std::sqrt((radius - aside) * (radius + aside));
    return std::max(std::min(foot + half, length) - std::max(foot - half, 0.0), 0.0);
}

Scaling mass(const Figure& figure, const Sandboxes& sandboxes, const Budget& budget) {
    check_centres(sandboxes);
    const double whole = scales_of(figure.box(), 2, 1).coarsest;
    const double detail = figure.facts().step;
    const PointSet centres =
        even_sample(figure, sandboxes.centres, Spread::stretches, sandboxes.seed, budget);
    ScaleRange range{ScaleRange::details * detail, whole / ScaleRange::parts_of_whole};
    range.scales = "radii";
    std::vector<double> radii = halved_sizes(range.coarsest, std::min(detail, range.coarsest));
    Masses masses(radii);
    DrawnSegments canvas([&](Point from, Point to, bool) {
        const double length = distance(from, to);
        for (const auto& centre : centres.points)
            masses.add_segment(from, to, length, {centre[0], centre[1]});
    });
    figure.draw(canvas, 0, budget);
    return fitted(std::move(radii), masses.means(static_cast<double>(centres.points.size())), range,
                  2);
}

Scaling mass(const PointSet& points, const Sandboxes& sandboxes, const Budget& budget) {
    check_centres(sandboxes);
    const double whole = longest_side(points);
    const PointSet centres = even_sample(points, sandboxes.centres, sandboxes.seed);
    std::vector<double> radii = halved_sizes(whole / ScaleRange::parts_of_whole, points.detail);
    if (radii.empty()) radii = {whole / ScaleRange::parts_of_whole};
    Masses masses(radii);
    WorkCount done("centre", centres.points.size());
    for (const auto& centre : centres.points) {
        budget.check();
        ++done;
        for (const auto& point : points.points) masses.add_point(distance(point, centre));
    }
    std::vector<double> means = masses.means(static_cast<double>(centres.points.size()));
    for (double& mean : means) mean -= 1;  // the centre itself
    const ScaleRange range = points_range(points, radii, means, "radii");
    Scaling found = fitted(std::move(radii), std::move(means), range, points.columns);
    if (!may_show_noise(points)) return found;
    // All pairs tell more of noise than those of the centres.
    const Scaling pairs = correlation(points, {}, budget);
    if (pairs.noise == 0) return found;
    found.noise = pairs.noise;
    found.estimate = pairs.estimate;
    found.because = "by the correlation sum: " + pairs.because;
    return found;
}

namespace {

using Cell = std::array<std::int64_t, 3>;

/// Points in the order of their cells.
struct Celled {
    Cell cell;
    std::array<double, 3> point;
};

Cell cell_of(const std::array<double, 3>& point, const std::array<double, 3>& low, double width) {
    Cell cell{};
    for (std::size_t i = 0; i < 3; ++i)
        cell[i] = static_cast<std::int64_t>(std::floor((point[i] - low[i]) / width));
    return cell;
}

bool by_cell(const Celled& a, const Celled& b) { return a.cell < b.cell; }

}  // namespace

std::vector<std::uint64_t> near_pairs(const PointSet& set, double greatest, std::size_t radii,
                                      const Budget& budget) {
    if (!(greatest > 0))
        throw Error("expected a radius above 0, found " + std::to_string(greatest));
    budget.check_memory(set.points.size() * sizeof(Celled), "the points in their cells");
    std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
    for (const auto& point : set.points)
        for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], point[i]);
    // A hair wider, so that no rounding puts two points this near into cells further apart.
    const double width = greatest * (1 + 1e-6);
    std::vector<Celled> points;
    points.reserve(set.points.size());
    for (const auto& point : set.points) points.push_back({cell_of(point, low, width), point});
    std::sort(points.begin(), points.end(), by_cell);

    std::vector<std::uint64_t> pairs(radii);
    const auto compare = [&](std::size_t i, std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t within =
                halved_radii(greatest, distance(points[i].point, points[k].point), radii);
            if (within > 0) ++pairs[within - 1];
        }
    };
    WorkCount done("point", points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % 256 == 0) budget.check();
        done.at(i);
        // Three cells that follow each other are one stretch of the list. Every pair is seen from
        // the point that comes first.
        for (std::int64_t column = 0; column <= 1; ++column)
            for (std::int64_t row = column == 0 ? 0 : -1; row <= 1; ++row) {
                Celled from = points[i], to = points[i];
                from.cell[0] += column, to.cell[0] += column;
                from.cell[1] += row, to.cell[1] += row;
                from.cell[2] -= 1, to.cell[2] += 1;
                const auto begin = std::lower_bound(points.begin(), points.end(), from, by_cell);
                const auto end = std::upper_bound(begin, points.end(), to, by_cell);
                const auto first = static_cast<std::size_t>(begin - points.begin());
                compare(i, std::max(first, i + 1), static_cast<std::size_t>(end - points.begin()));
            }
    }
    for (std::size_t i = radii; i-- > 1;) pairs[i - 1] += pairs[i];
    return pairs;
}

Scaling correlation(const PointSet& all, const CorrelationSample& sample, const Budget& budget) {
    if (all.points.size() < 2 || sample.points < 2)
        throw Error("expected at least 2 points to take the distance of, found " +
                    std::to_string(std::min(all.points.size(), sample.points)));
    const PointSet points = even_sample(all, sample.points, sample.seed);
    const double coarsest = longest_side(points) / ScaleRange::parts_of_whole;
    Scaling result;
    result.sizes = halved_sizes(coarsest, std::min(points.detail, coarsest));
    const auto pairs = near_pairs(points, coarsest, result.sizes.size(), budget);
    const double count = static_cast<double>(points.points.size());
    std::vector<double> neighbours, powers, numbers(pairs.begin(), pairs.end());
    for (const std::uint64_t pair : pairs) {
        const double share = 2 * static_cast<double>(pair) / (count * (count - 1));
        result.values.push_back(share);
        powers.push_back(std::log(share));
        neighbours.push_back(share * (count - 1));
    }
    fit_scaling(result, powers, points_range(points, result.sizes, neighbours, "radii"), {1, 1, 0},
                points.columns);
    heed_noise(result, numbers, points);
    return result;
}

Scaling correlation(const Figure& figure, const CorrelationSample& sample, const Budget& budget) {
    return correlation(even_sample(figure, sample.points, Spread::independent, sample.seed, budget),
                       sample, budget);
}

}  // namespace algae
