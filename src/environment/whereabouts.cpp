#include "environment/whereabouts.hpp"

#include <cmath>
#include <numbers>

namespace algae {

namespace {

double degrees(const Vector& heading) {
    if (heading.x == 0 && heading.y == 0) return 0;
    double angle = std::atan2(heading.y, heading.x) * (180 / std::numbers::pi);
    if (angle < 0) angle += 360;
    return angle < 360 ? angle : 0;  // the sum may be rounded up
}

std::vector<double> first_of(const Vector& vector, std::size_t count) {
    const double all[] = {vector.x, vector.y, vector.z};
    return {all, all + count};
}

}  // namespace

bool Whereabouts::is_inside(const Vector& place) const {
    const std::size_t dimension = setting_.numbers.size() / 2;
    const std::vector<double> coordinates = first_of(place, dimension);
    for (std::size_t i = 0; i < dimension; ++i)
        if (coordinates[i] < setting_.numbers[i].value ||
            coordinates[i] > setting_.numbers[dimension + i].value)
            return false;
    return true;
}

std::vector<double> Whereabouts::answer(const Query& query) const {
    const std::string& kind = setting_.kind;
    const std::size_t count = query.parameters.size();
    if (kind == "x") return {query.position.x};
    if (kind == "y") return {query.position.y};
    if (kind == "z") return {query.position.z};
    if (kind == "position") return first_of(query.position, count);
    if (kind == "clip") return {is_inside(query.position) ? 1.0 : 0.0};
    const Vector& heading = query.attitude.heading();
    if (count == 1) return {degrees(heading)};
    return first_of(heading, count);
}

std::vector<std::vector<double>> Whereabouts::answers(const Traversal&,
                                                      std::span<const Query* const> queries,
                                                      const Budget&) {
    std::vector<std::vector<double>> out;
    for (const Query* query : queries) out.push_back(answer(*query));
    return out;
}

}  // namespace algae
