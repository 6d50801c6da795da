#include "environment/environment.hpp"

#include <algorithm>

#include "rewrite/module_text.hpp"

namespace algae {

bool Traversal::is_in_space() const {
    return std::any_of(segments.begin(), segments.end(), [](const Segment& segment) {
        return segment.from.z != 0 || segment.to.z != 0;
    });
}

std::string place_of(const Query& query, const Traversal& course) {
    std::string out = query.name;
    for (std::size_t i = 0; i < query.parameters.size(); ++i)
        out += (i == 0 ? "(" : ",") + number_text(query.parameters[i]);
    if (!query.parameters.empty()) out += ')';
    return out + " at position " + std::to_string(query.module) + " of generation " +
           std::to_string(course.generation);
}

}  // namespace algae
