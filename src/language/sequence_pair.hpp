#pragma once

#include <memory>

#include "system/d0l.hpp"

namespace algae {

/// Two D0L systems over one alphabet, so that their words can be compared. Letters are the same if their
/// names are.
struct SequencePair {
    std::shared_ptr<const Alphabet> alphabet;
    D0L left, right;
};

/// The same systems over the letters of both, those of the left one first with the numbers they have. A
/// letter that only the other system has stays as it is.
///
/// Example: over_common_alphabet(d0l("a", {{'a', "b"}}), d0l("b", {{'b', "a"}})).right.axiom == Word{1}
SequencePair over_common_alphabet(const D0L& left, const D0L& right);

}  // namespace algae
