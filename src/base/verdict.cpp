#include "base/verdict.hpp"

namespace algae {

std::string_view to_string(Truth truth) {
    switch (truth) {
        case Truth::proved:
            return "proved";
        case Truth::refuted:
            return "refuted";
        case Truth::undecided:
            break;
    }
    return "undecided";
}

Truth opposite(Truth truth) {
    if (truth == Truth::undecided) return truth;
    return truth == Truth::proved ? Truth::refuted : Truth::proved;
}

}  // namespace algae
