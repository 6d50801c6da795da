#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "exact/polynomial.hpp"

namespace algae {

/// A word of a system under construction: its letters, each with a rule of its own, and how many
/// letters fill it up.
struct StageRule {
    std::vector<std::size_t> letters;
    Integer filling;
};

/// A system under construction: the axiom and the rules of the letters 0, 1, ...; the filling letter
/// stays or vanishes.
struct StageDraft {
    StageRule axiom;
    std::vector<StageRule> rules;
};

/// A multiple of a divisor written as (x-c)^k - c1 (x-c)^(k-1) - ... - ck with natural c, c1, ..., ck.
struct StageForm {
    Integer c;
    std::vector<Integer> coefficients;  // c1, ..., ck
};

/// Rules with more letters than this are not written.
inline constexpr std::size_t longest_stage_rule = 20'000;

/// Looks for the stages that growth/realise.hpp tells of.
class StageSearch {
public:
    /// For sequences that this polynomial, monic and without the root 0, annuls.
    StageSearch(const Polynomial& characteristic, const Budget& budget);

    /// Whether the polynomial has few enough divisors to try them all.
    bool is_small() const;
    /// Whether something was given up because a rule would be too long.
    bool was_too_long() const { return too_long_; }

    /// A draft of the sequence with these first values, or nothing. `fillings_stay` says that the filling
    /// letter stays, so that the rules may not fall short of it.
    std::optional<StageDraft> draft(const std::vector<Integer>& f, bool fillings_stay);

private:
    std::optional<StageRule> staged(const std::vector<Integer>& f, const std::vector<unsigned>& left);
    bool set_rules(std::size_t first, const StageForm& form, const std::vector<Integer>& sizes, const StageRule& addend);
    const std::vector<StageForm>& forms(const std::vector<unsigned>& exponents);

    const Budget& budget_;
    std::vector<Factorisation::Power> powers_;
    std::map<std::vector<unsigned>, std::vector<StageForm>> forms_;
    std::vector<StageRule> rules_;
    std::size_t tries_ = 0;
    bool fillings_stay_ = false;
    bool too_long_ = false;
};

}  // namespace algae
