#include "system/lsystem.hpp"

namespace algae {

bool LSystem::operator==(const LSystem& other) const {
    return title == other.title && source == other.source && identifiers == other.identifiers &&
           alphabet == other.alphabet && declared == other.declared &&
           constants == other.constants && axiom == other.axiom && rules == other.rules &&
           tables == other.tables && ignored == other.ignored && terminals == other.terminals &&
           interpretation == other.interpretation &&
           environments == other.environments && settings == other.settings &&
           expectations == other.expectations;
}

}  // namespace algae
