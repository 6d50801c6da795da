#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "dimension/dimension_formula.hpp"
#include "dimension/recurrent_set.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// What the rules of a system say of the dimension of its limit curve.
struct ExactDimension {
    enum class Status {
        exact,        // the Hausdorff and the box dimension
        upper_bound,  // of both: some condition could not be verified
        unfinished,   // the letters or the memory of the budget were used up before it was found
        none          // the rules give no formula; `conditions` says why
    };

    Status status = Status::none;
    std::optional<DimensionFormula> value;
    /// log rate / log |mu|, with multiplicity: where parts coincide it is too large.
    std::optional<DimensionFormula> similarity;
    /// Of the boundary, where the limit set has interior points.
    std::optional<DimensionFormula> boundary;
    /// The rate at which pairs of parts that meet multiply, where there are finitely many ways.
    std::optional<Rate> meeting;
    /// The parts of the limit, where they were found; its generations can be measured on them.
    std::shared_ptr<const RecurrentSet> limit;
    /// What was verified, or could not be, in sentences.
    std::vector<std::string> conditions;
};

/// The dimension of the recurrent set of a D0L system with a turtle in the plane, as the logarithm of
/// the rate at which parts multiply over that of the factor by which they shrink.
///
/// It is exact if there are finitely many ways in which parts meet (`Neighbours`): with all parts, if
/// none coincide, otherwise with the different ones (`distinct_growth`). If these cannot be found
/// within the memory of the budget or by this method, the value with multiplicity is an upper bound. Several components of letters
/// each have their own dimension; the largest is that of the whole.
///
/// Throws BoundReached past the deadline, Interrupted: neither says anything about the rules.
///
/// Of a parametric system whose rules multiply lengths by constants, it is `parametric_dimension`.
///
/// Example: exact_dimension(read_lsystem("axiom F; F -> F+F--F+F; angle 60", "")).value->text() == "log 4 / log 3"
ExactDimension exact_dimension(const LSystem& system, const Budget& budget = {});

/// What no set in the plane for which the rules give this upper bound exceeds; 2 for other ones.
double greatest_dimension(const ExactDimension& exact);

}  // namespace algae
