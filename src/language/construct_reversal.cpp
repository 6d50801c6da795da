#include "language/construct_reversal.hpp"

#include <algorithm>

namespace algae {

ET0L reversed(const ET0L& system) {
    ET0L result = system;
    std::reverse(result.axiom.begin(), result.axiom.end());
    for (Table& rules : result.tables)
        for (auto& successors : rules)
            for (Word& word : successors) std::reverse(word.begin(), word.end());
    return result;
}

}  // namespace algae
