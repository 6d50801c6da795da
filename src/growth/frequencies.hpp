#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "exact/ball.hpp"
#include "growth/components.hpp"
#include "growth/growth_class.hpp"
#include "growth/growth_matrix.hpp"
#include "growth/number_field.hpp"
#include "system/d0l.hpp"

namespace algae {

/// The limit of the share of a letter, a number in the field of a rate of growth r.
class Frequency {
public:
    /// The quotient above(r)/below(r).
    Frequency(const Rate& rate, const Polynomial& above, const Polynomial& below);

    /// Where the degree of the rate is at most 8: "1/3", "(-1+sqrt(5))/2", "(r^2 - 1)/2" with r the rate.
    const std::optional<AlgebraicNumber>& number() const { return number_; }
    std::string exact() const;
    Ball enclosure(long bits) const;
    /// Correctly rounded to so many digits after the point.
    std::string decimal(int digits_after_point) const;

    friend bool operator==(const Frequency& left, const Frequency& right);

private:
    Rate rate_;
    Polynomial above_, below_;
    std::optional<AlgebraicNumber> number_;
};

/// The shares of the letters in h^n(axiom) as n grows.
struct LetterFrequencies {
    /// 1 if all shares have limits; otherwise the least p for which they have limits over n = r mod p.
    Integer period = 1;
    /// limits[r][i]: the limit for the i-th letter over n = r mod period. Empty if the words die out,
    /// or if the period is greater than `largest_period`.
    std::vector<std::vector<Frequency>> limits;

    static constexpr std::uint64_t largest_period = 24;
};

/// By the residues of the generating function of all letter counts at the rate of growth.
///
/// Example: letter_frequencies(d0l("a", {{'a', "ab"}, {'b', "a"}})).limits[0][0].exact() == "(-1+sqrt(5))/2"
LetterFrequencies letter_frequencies(const D0L& system, const Budget& budget = {});
LetterFrequencies letter_frequencies(const std::vector<Integer>& counts, const GrowthMatrix& matrix,
                                     const Components& components, const Budget& budget = {});

}  // namespace algae
