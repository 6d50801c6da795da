#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "growth/characteristic.hpp"
#include "growth/closed_form.hpp"
#include "growth/components.hpp"
#include "growth/frequencies.hpp"
#include "growth/growth_class.hpp"
#include "growth/growth_matrix.hpp"
#include "growth/letters.hpp"
#include "growth/recurrence.hpp"
#include "system/d0l.hpp"

namespace algae {

/// Everything this room says about the lengths of a D0L system and its letters, exactly.
struct GrowthAnalysis {
    std::vector<Integer> lengths;  // of generations 0 to 10
    GrowthMatrix matrix;
    Components components;
    MatrixPolynomials polynomials;
    Recurrence recurrence;
    GeneratingFunction generating_function;
    ClosedForm closed_form;
    GrowthClass growth;
    // By place in D0L::letters:
    std::vector<GrowthOrder> letters;
    std::vector<std::optional<std::uint64_t>> lifetimes;
    LetterFrequencies frequencies;
    Primitivity primitivity;
    std::vector<Prolongation> prolongations;
};

/// Example: growth_analysis(d0l("F", {{'F', "F+F--F+F"}})).closed_form.text() == "(7*4^n - 4)/3"
GrowthAnalysis growth_analysis(const D0L& system, const Budget& budget = {});

}  // namespace algae
