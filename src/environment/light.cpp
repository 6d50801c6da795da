#include "environment/light.hpp"

#include "environment/joint.hpp"
#include "environment/segment_grid.hpp"

namespace algae {

namespace {

/// Heights and plans: what is seen from above.
class Plan {
public:
    explicit Plan(const Traversal& course) : space_(course.is_in_space()) {
        for (const Segment& line : course.segments)
            lines_.push_back({of(line.from), of(line.to), line.module});
    }
    double height(const Vector& point) const { return space_ ? point.z : point.y; }
    Vector of(const Vector& point) const { return {point.x, space_ ? point.y : 0, 0}; }
    const std::vector<Segment>& lines() const { return lines_; }

private:
    bool space_;
    std::vector<Segment> lines_;
};

}  // namespace

std::vector<std::vector<double>> LightEnvironment::answers(const Traversal& course,
                                                           std::span<const Query* const> queries,
                                                           const Budget& budget) {
    const Plan plan(course);
    const SegmentGrid grid(plan.lines(), radius_, budget);
    std::vector<std::vector<double>> out;
    for (const Query* query : queries) {
        budget.check();
        const Vector place = plan.of(query->position);
        const double height = plan.height(query->position);
        Joint joint(course.segments, *query);
        grid.any_near(place, [&](std::size_t i) {
            joint.look_at(i);
            return false;
        });
        double column = radius_;
        grid.any_near(place, [&](std::size_t i) {
            double low = plan.height(course.segments[i].from),
                   high = plan.height(course.segments[i].to);
            Vector lower = plan.lines()[i].from, upper = plan.lines()[i].to;
            if (low > high) {
                std::swap(low, high);
                std::swap(lower, upper);
            }
            if (high <= height || joint.has(i)) return false;
            if (low < height) lower = lower + ((height - low) / (high - low)) * (upper - lower);
            column = std::min(column, distance(place, lower, upper));
            return column == 0;
        });
        out.push_back({column / radius_});
    }
    return out;
}

}  // namespace algae
