#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "claim/judgement.hpp"
#include "language/language.hpp"

namespace algae {

/// What may be used besides the language itself.
struct FamilyQuestion {
    std::string family;        // REG, CF or a family of L-systems, as `system_form` reads it
    bool empty_axiom = false;  // whether the empty word may be an axiom
    std::vector<std::shared_ptr<const SourceSystem>> systems;  // that may generate the language
};

/// Whether the language is of the family. Finite languages are decided for 0L, P0L, D0L, PD0L, T0L, PT0L,
/// DT0L, PDT0L; families that have all finite languages, and regular expressions for REG and CF, by theorem. Of other
/// languages it is seen that they are: given by a system of the form, equal to the language of one of
/// `systems`, or made by operations under which the family is closed. That an infinite one is not is seen of languages of
/// D0L systems that are too sparse to be regular or context-free; otherwise it is undecided.
///
/// Throws Error if the family has no such name, what budget.check throws, BoundReached where a table is too large.
Judgement judge_family(const Language& language, const FamilyQuestion& question,
                       const Alphabet& alphabet, const Budget& budget = {});

}  // namespace algae
