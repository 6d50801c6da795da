#include "language/detail/judge.hpp"

#include <nlohmann/json.hpp>

#include "dimension/dimension.hpp"
#include "model/model.hpp"

// Statements about the dimension of limit sets and of their boundaries: by `exact_dimension`, and exactly.
//
// Ratios of logarithms are compared exactly; the solution of an equation by enclosures that get narrower. Two
// numbers that agree in so many digits without a proof that they are equal leave the statement undecided.

namespace algae {

namespace {

using Status = ExactDimension::Status;
constexpr int digits_shown = 12;

nlohmann::ordered_json proof(const ExactDimension& found) {
    return {{"by", "dimension"}, {"conditions", found.conditions}};
}

/// Exactly for ratios of logarithms; the solution of an equation is less or greater where enclosures
/// differ in that many digits.
Order compared(const DimensionFormula& formula, const DimensionValue& claimed) {
    if (const LogRatio* const ratio = formula.log_ratio()) return compare(*ratio, claimed);
    for (long bits = 64; bits <= digits_compared * 7; bits *= 2)
        if (const auto known = sign(formula.enclosure(bits) - claimed.enclosure(bits)))
            return *known < 0 ? Order::less : *known > 0 ? Order::greater : Order::equal;
    return Order::unknown;
}

/// "log 4 / log 3 = 1.261859507143".
std::string text_of(const DimensionFormula& formula) {
    const std::string decimal = formula.decimal(digits_shown);
    if (formula.ratio_sum()) return decimal + ", the s of " + formula.text();
    return formula.text() + (formula.rational() ? "" : " = " + decimal);
}

/// The conditions as sentences.
std::vector<std::string> sentences(const Model& system, const ExactDimension& found) {
    std::vector<std::string> all;
    for (const std::string& condition : found.conditions)
        all.push_back(system.name + ": " + condition + ".");
    return all;
}

std::string agree(const std::string& left, const std::string& right) {
    return left + " and " + right + " agree in " + std::to_string(digits_compared) +
           " digits, but no proof that they are equal was found.";
}

/// That a number known exactly is the claimed one, or at most that.
Judgement judge_exact(const std::string& what, const DimensionFormula& value,
                      const ClaimedDimension& claimed, std::vector<std::string> argument,
                      const nlohmann::ordered_json& by) {
    const Order order = compared(value, claimed.value);
    const std::string known = text_of(value);
    const std::string line = what + " is " + known;
    if (order == Order::unknown) {
        argument.push_back(line + ".");
        argument.push_back(agree(value.text(), claimed.text));
        return Judgement::undecided(std::move(argument));
    }
    const std::string sign = order == Order::equal ? " = " : order == Order::less ? " < " : " > ";
    const bool said = value.text() == claimed.text || known.ends_with(sign + claimed.text);
    argument.push_back(line + (said ? "" : sign + claimed.text) + ".");
    const bool holds = order == Order::equal || (claimed.at_most && order == Order::less);
    return holds ? Judgement::proved(std::move(argument), by)
                 : Judgement::refuted(std::move(argument), by);
}

/// What an upper bound says.
Judgement judge_bounded(const std::string& what, const ExactDimension& found,
                        const ClaimedDimension& claimed, std::vector<std::string> argument) {
    const bool above_plane = compare(found.value->enclosure(64), Ball(2, 64)) == Order::greater;
    const Order order = above_plane ? compare(DimensionValue(Rational(2)), claimed.value)
                                    : compared(*found.value, claimed.value);
    const std::string bound =
        above_plane ? "2, as for every set in the plane" : text_of(*found.value);
    argument.push_back(what + " is at most " + bound + ".");
    if (order == Order::less && !claimed.at_most)
        return Judgement::refuted(std::move(argument), proof(found));
    if (order == Order::less || (order == Order::equal && claimed.at_most))
        return Judgement::proved(std::move(argument), proof(found));
    argument.push_back(order == Order::unknown ? agree(bound, claimed.text)
                                               : "Whether it is smaller is not known: " +
                                                     found.conditions.back() + ".");
    return Judgement::undecided(std::move(argument));
}

}  // namespace

Judgement judge_dimension(const Model& system, const ClaimedDimension& claimed,
                          const Budget& budget) {
    const ExactDimension found = exact_dimension(system, budget);
    std::vector<std::string> argument = sentences(system, found);
    const std::string what = "The dimension of the limit set of " + system.name;
    if (found.status == Status::exact)
        return judge_exact(what, *found.value, claimed, std::move(argument), proof(found));
    if (found.status == Status::upper_bound)
        return judge_bounded(what, found, claimed, std::move(argument));
    if (found.status == Status::none)
        argument.push_back("The rules of " + system.name + " give no formula for the dimension.");
    return Judgement::undecided(std::move(argument));
}

Judgement judge_boundary(const Model& system, const ClaimedDimension& claimed,
                         const Budget& budget) {
    const ExactDimension found = exact_dimension(system, budget);
    std::vector<std::string> argument = sentences(system, found);
    if (found.boundary)
        return judge_exact("The dimension of the boundary of the limit set of " + system.name,
                           *found.boundary, claimed, std::move(argument), proof(found));
    argument.push_back(found.status == Status::exact &&
                               compare(found.value->enclosure(64), Ball(2, 64)) == Order::less
                           ? "The limit set of " + system.name + " has the dimension " +
                                 text_of(*found.value) +
                                 " and no interior points: it is all boundary."
                           : "The boundary of the limit set of " + system.name + " is not known.");
    return Judgement::undecided(std::move(argument));
}

}  // namespace algae
