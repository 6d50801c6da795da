#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "dimension/log_ratio.hpp"
#include "dimension/ratio_sum.hpp"

namespace algae {

/// A dimension as a formula: log rate / log ratio where all parts shrink alike, otherwise the solution
/// of an equation between powers.
class DimensionFormula {
public:
    DimensionFormula(LogRatio formula) : formula_(std::move(formula)) {}
    DimensionFormula(RatioSum formula) : formula_(std::move(formula)) {}

    const LogRatio* log_ratio() const { return std::get_if<LogRatio>(&formula_); }
    const RatioSum* ratio_sum() const { return std::get_if<RatioSum>(&formula_); }

    /// The number itself where it is known to be rational.
    std::optional<Rational> rational() const {
        return log_ratio() ? log_ratio()->rational() : std::nullopt;
    }
    Ball enclosure(long bits) const {
        return std::visit([&](const auto& formula) { return formula.enclosure(bits); }, formula_);
    }
    std::string text() const {
        return std::visit([](const auto& formula) { return formula.text(); }, formula_);
    }
    /// Correctly rounded to so many digits after the point.
    std::string decimal(int digits) const {
        return std::visit([&](const auto& formula) { return formula.decimal(digits); }, formula_);
    }

private:
    std::variant<LogRatio, RatioSum> formula_;
};

}  // namespace algae
