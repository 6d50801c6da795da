#pragma once

#include <string>
#include <vector>

#include "base/budget.hpp"
#include "claim/judgement.hpp"
#include "lesson/exercise.hpp"
#include "notation/read_claim.hpp"

namespace algae {

/// What came of one demand.
struct MarkedDemand {
    std::string text, hint;
    Judgement judgement;
};

/// What came of an answer: right if all demands are proved, wrong as soon as one is refuted; those behind
/// it are not looked at.
struct Mark {
    Truth verdict = Truth::proved;  // right, wrong, undecided
    std::vector<MarkedDemand> demands;
};

/// Marks an answer. `text` is what stands in the file `name`; `open` knows the gallery and the files
/// beside the answer. Throws Error or Diagnostics where the answer cannot be read, or demands cannot be
/// about it; what `decide` throws.
Mark mark(const Exercise& exercise, const std::string& text, const std::string& name,
          const SystemSource& open, const Budget& budget = {});

/// The mark as a report: what was asked, what was found instead, and a hint.
std::string report(const Exercise& exercise, const Mark& mark);

}  // namespace algae
