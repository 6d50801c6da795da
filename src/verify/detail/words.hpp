#pragma once

#include <cstddef>
#include <vector>

#include "verify/detail/checking.hpp"

namespace algae::verify {

/// Of letters 0, 1, ... in the order of their first occurrences in an infinite word, which begins with 0.
using Images = std::vector<Word>;

/// The first letter of the infinite word of the statement's system. Throws Flaw where there is no such word.
Symbol first_letter(const Obligation& task);

/// The morphism of the infinite word of the statement's system, which is D0L and not coded. Throws Flaw where there is no such word.
Images morphism_of(const Obligation& task);

/// An infinite word cut into return words to its first letter.
struct Cut {
    std::size_t letters = 0;
    Images returns;
    Images next;  // the morphism of the word of the return words
};

/// The word of each morphism cut, that of h first, until one comes back.
struct Cuts {
    std::vector<Cut> all;
    std::size_t before = 0;  // the word after the last one is that of all[before]
};

/// Throws BoundReached where they get too many or too large.
Cuts cuts_of(Images h, const Obligation& task);

/// That the infinite word of a D0L system has so many factors of n letters for all n, by its bispecial factors.
void check_bispecial(const Obligation& task);
/// That its critical exponent is a number, by repetitions; or infinite, by a word all powers of which are factors.
void check_repetitions(const Obligation& task);
void check_endless_repetition(const Obligation& task);
/// That a D0L system is circular, by windows.
void check_synchronised(const Obligation& task);

}  // namespace algae::verify
