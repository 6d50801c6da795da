#include "fold/walk.hpp"

namespace algae {

Fates::Fates(const D0L& system)
    : constant_(system.alphabet->size(), 0), gone_(lifetimes(system.rules.images)) {
    for (const Symbol a : system.letters) constant_[a] = system.successor(a) == Word{a};
}

}  // namespace algae
