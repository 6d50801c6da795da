#include "turtle/segments.hpp"

#include <algorithm>

namespace algae {

Integer drawn_segments(const Commands& commands, const std::vector<Symbol>& letters,
                       const std::vector<Integer>& counts) {
    Integer sum = 0;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const auto& does = commands.of(letters[i]);
        const auto drawn = std::count_if(does.begin(), does.end(), [](Command command) {
            return command == Command::draw || command == Command::draw_unmarked;
        });
        if (drawn > 0) sum += counts[i] * Integer(drawn);
    }
    return sum;
}

}  // namespace algae
