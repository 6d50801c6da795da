#include "dimension/mass.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "dimension/box_counts.hpp"
#include "dimension/drawn_segments.hpp"
#include "dimension/even_sample.hpp"
#include "dimension/halved_radii.hpp"

namespace algae {

namespace {

constexpr std::size_t most_scales = 20;

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
    std::vector<double> radii =
        halved_sizes(range.coarsest, std::min(detail, range.coarsest), most_scales);
    Masses masses(radii);
    DrawnSegments canvas([&](Point from, Point to, bool) {
        const double length = std::hypot(to.x - from.x, to.y - from.y);
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
    std::vector<double> radii =
        halved_sizes(whole / ScaleRange::parts_of_whole, points.detail, most_scales);
    if (radii.empty()) radii = {whole / ScaleRange::parts_of_whole};
    Masses masses(radii);
    for (const auto& centre : centres.points) {
        budget.check();
        for (const auto& point : points.points) masses.add_point(distance(point, centre));
    }
    std::vector<double> means = masses.means(static_cast<double>(centres.points.size()));
    for (double& mean : means) mean -= 1;  // the centre itself
    const ScaleRange range = points_range(points, radii, means, "radii");
    return fitted(std::move(radii), std::move(means), range, points.columns);
}

}  // namespace algae
