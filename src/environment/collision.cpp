#include "environment/collision.hpp"

#include "environment/joint.hpp"
#include "environment/segment_grid.hpp"

namespace algae {

std::vector<std::vector<double>> CollisionEnvironment::answers(
    const Traversal& course, std::span<const Query* const> queries, const Budget& budget) {
    const SegmentGrid grid(course.segments, radius_, budget);
    std::vector<std::vector<double>> out;
    for (const Query* query : queries) {
        budget.check();
        Joint joint(course.segments, *query);
        grid.any_near(query->position, [&](std::size_t i) {
            joint.look_at(i);
            return false;
        });
        const bool collides = grid.any_near(query->position, [&](std::size_t i) {
            const Segment& line = course.segments[i];
            return distance(query->position, line.from, line.to) <= radius_ && !joint.has(i);
        });
        out.push_back({collides ? 1.0 : 0.0});
    }
    return out;
}

}  // namespace algae
