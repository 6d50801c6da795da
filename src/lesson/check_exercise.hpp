#pragma once

#include "lesson/exercise.hpp"
#include "notation/read_claim.hpp"

namespace algae {

/// Looks through the statements of an exercise before there is an answer: names that are defined nowhere, families that
/// there are not, systems that `open` does not know. What is wrong counts if it is wrong with each of
/// several answers of its kind. Where `files_may_follow`, systems in files that cannot be opened are
/// passed over: they may stand beside the answer. Throws Diagnostics, and what `open` throws but Error.
void check_exercise(const Exercise& exercise, const SystemSource& open,
                    bool files_may_follow = false);

}  // namespace algae
