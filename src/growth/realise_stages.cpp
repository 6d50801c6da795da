#include "growth/realise_stages.hpp"

#include <algorithm>

namespace algae {

namespace {

constexpr std::size_t most_divisors = 256;
constexpr std::size_t most_tries = 4'000;  // for each draft

/// x^k - c1 x^(k-1) - ... - ck as c1, ..., ck, if these are natural numbers.
std::optional<std::vector<Integer>> natural_coefficients(const Polynomial& polynomial) {
    std::vector<Integer> coefficients;
    for (long i = polynomial.degree() - 1; i >= 0; --i) {
        coefficients.push_back(-polynomial.coefficient(static_cast<std::size_t>(i)));
        if (sign(coefficients.back()) < 0) return std::nullopt;
    }
    return coefficients;
}

/// What a divisor may be multiplied by: 1, then monic polynomials of small degree and coefficients.
const std::vector<Polynomial>& multipliers() {
    static const std::vector<Polynomial> all = [] {
        std::vector<Polynomial> found{Polynomial(1)};
        for (int degree = 1; degree <= 3; ++degree) {
            std::vector<Integer> coefficients(static_cast<std::size_t>(degree) + 1, -1);
            coefficients.back() = 1;
            for (std::size_t i = 0; i < static_cast<std::size_t>(degree);) {
                found.emplace_back(coefficients);
                for (i = 0; i < static_cast<std::size_t>(degree); ++i) {
                    if (coefficients[i] < 3) {
                        coefficients[i] += 1;
                        break;
                    }
                    coefficients[i] = -1;
                }
            }
        }
        return found;
    }();
    return all;
}

/// p(x + c).
Polynomial moved(const Polynomial& p, const Integer& c) {
    const Polynomial x_and_c({c, 1});
    Polynomial result;
    for (long i = p.degree(); i >= 0; --i)
        result = result * x_and_c + Polynomial(p.coefficient(static_cast<std::size_t>(i)));
    return result;
}

/// (E - c) f, where E is the shift: f(n+1) - c f(n).
std::vector<Integer> step(const std::vector<Integer>& f, const Integer& c) {
    std::vector<Integer> g;
    for (std::size_t n = 0; n + 1 < f.size(); ++n) g.push_back(f[n + 1] - c * f[n]);
    return g;
}

bool all_zero(const std::vector<Integer>& f) {
    return std::all_of(f.begin(), f.end(), [](const Integer& value) { return value.is_zero(); });
}

}  // namespace

StageSearch::StageSearch(const Polynomial& characteristic, const Budget& budget) : budget_(budget) {
    for (const auto& power : factorise(characteristic).powers) powers_.push_back(power);
}

bool StageSearch::is_small() const {
    std::size_t count = 1;
    for (const auto& power : powers_) count *= std::min<std::size_t>(power.exponent + 1, most_divisors + 1);
    return powers_.size() <= 8 && count <= most_divisors;
}

std::optional<StageDraft> StageSearch::draft(const std::vector<Integer>& f, bool fillings_stay) {
    fillings_stay_ = fillings_stay;
    tries_ = 0;
    rules_.clear();
    std::vector<unsigned> all;
    for (const auto& power : powers_) all.push_back(power.exponent);
    const auto axiom = staged(f, all);
    if (!axiom) return std::nullopt;
    return StageDraft{*axiom, rules_};
}

/// The axiom of a system for f, whose rules are added to rules_.
std::optional<StageRule> StageSearch::staged(const std::vector<Integer>& f, const std::vector<unsigned>& left) {
    if (++tries_ > most_tries) return std::nullopt;
    budget_.check();
    std::vector<std::vector<unsigned>> choices{left};
    std::vector<unsigned> chosen(left.size(), 0);
    for (;;) {  // all parts of what is left, small ones first
        std::size_t i = 0;
        while (i < left.size() && chosen[i] == left[i]) chosen[i++] = 0;
        if (i == left.size()) break;
        ++chosen[i];
        if (chosen != left) choices.push_back(chosen);
    }
    for (const auto& choice : choices) {
        std::vector<unsigned> rest = left;
        for (std::size_t i = 0; i < left.size(); ++i) rest[i] -= choice[i];
        const bool is_last = std::all_of(rest.begin(), rest.end(), [](unsigned e) { return e == 0; });
        for (const StageForm& form : forms(choice)) {
            const std::size_t k = form.coefficients.size();
            if (f.size() < k + 1) continue;
            std::vector<Integer> g = f, sizes;  // of w_0, ..., w_(k-1)
            std::vector<std::vector<Integer>> stages;
            for (std::size_t i = 0; i < k; ++i) {
                stages.push_back(g);
                sizes.push_back(g[0]);
                g = step(g, form.c);
            }
            if (std::any_of(sizes.begin(), sizes.end(), [](const Integer& size) { return size < 1; })) continue;
            if (std::any_of(sizes.begin(), sizes.end(),
                            [](const Integer& size) { return size > Integer(longest_stage_rule); })) {
                too_long_ = true;
                continue;
            }
            for (std::size_t n = 0; n < g.size(); ++n)
                for (std::size_t i = 0; i < k; ++i) g[n] -= form.coefficients[i] * stages[k - 1 - i][n];
            const std::size_t before = rules_.size();
            rules_.resize(before + k);
            std::optional<StageRule> addend = StageRule{{}, 0};
            if (!is_last) addend = all_zero(g) ? std::nullopt : staged(g, rest);
            if (addend && set_rules(before, form, sizes, *addend)) return StageRule{{before}, f[0] - 1};
            rules_.resize(before);
        }
    }
    return std::nullopt;
}

bool StageSearch::set_rules(std::size_t first, const StageForm& form, const std::vector<Integer>& sizes, const StageRule& addend) {
    const std::size_t k = sizes.size();
    for (std::size_t i = 0; i < k; ++i) {
        StageRule rule;
        const auto add = [&](std::size_t which, const Integer& times) {
            if (times + Integer(rule.letters.size()) > Integer(longest_stage_rule)) return false;
            rule.letters.insert(rule.letters.end(), static_cast<std::size_t>(times.to_uint64()), first + which);
            rule.filling += times * (sizes[which] - 1);
            return true;
        };
        bool fits = add(i, form.c);
        if (i + 1 < k) {
            fits = fits && add(i + 1, 1);
        } else {
            for (std::size_t j = 0; j < k; ++j) fits = fits && add(k - 1 - j, form.coefficients[j]);
            rule.letters.insert(rule.letters.end(), addend.letters.begin(), addend.letters.end());
            rule.filling += addend.filling;
        }
        if (fillings_stay_) rule.filling -= sizes[i] - 1;
        if (sign(rule.filling) < 0) return false;
        if (!fits || rule.filling > Integer(longest_stage_rule)) {
            too_long_ = true;
            return false;
        }
        rules_[first + i] = std::move(rule);
    }
    return true;
}

/// The first forms of multiples of a divisor. Natural c1, ..., ck leave one root above c, and a
/// simple one, if any is not 0 (Descartes).
const std::vector<StageForm>& StageSearch::forms(const std::vector<unsigned>& exponents) {
    const auto [place, is_new] = forms_.try_emplace(exponents);
    if (!is_new) return place->second;
    Polynomial divisor = 1;
    for (std::size_t i = 0; i < exponents.size(); ++i) divisor *= power(powers_[i].factor, exponents[i]);
    for (const Polynomial& multiplier : multipliers())
        for (int c = 0; c <= (multiplier.degree() == 0 ? 12 : 2); ++c) {
            if (const auto found = natural_coefficients(moved(divisor * multiplier, c)))
                place->second.push_back({c, *found});
            if (place->second.size() == 4) return place->second;
        }
    return place->second;
}

}  // namespace algae
