#include "dimension/ratio_sum.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "dimension/constant_expression.hpp"

namespace algae {

namespace {

constexpr std::size_t most_terms = 12;
constexpr long largest_dimension = 64;

/// The logarithms of the ratios over m, and what they say of the spectral radius.
class Ratios {
public:
    Ratios(std::size_t states, const std::vector<RatioSum::Entry>& entries,
           const std::optional<WayGrowth>& growth, long precision)
        : states_(states), entries_(entries), precision_(precision) {
        const Ball factor = growth ? log(growth->enclosure(precision)) : Ball(0, precision);
        for (const RatioSum::Entry& entry : entries)
            logs_.push_back(log(abs(enclosure(entry.ratio, precision))) - factor);
    }

    /// How the spectral radius for s compares with 1, as far as the precision tells.
    Order radius(const Rational& s) const {
        const Ball exponent(s, precision_);
        std::vector<std::vector<Ball>> rest(states_,
                                            std::vector<Ball>(states_, Ball(0, precision_)));
        for (std::size_t k = 0; k < states_; ++k) rest[k][k] = Ball(1, precision_);
        for (std::size_t k = 0; k < entries_.size(); ++k)
            rest[entries_[k].from][entries_[k].to] -= exp(exponent * logs_[k]);
        for (std::size_t k = 0; k < states_; ++k) {
            const auto pivot = sign(rest[k][k]);
            if (!pivot || *pivot == 0) return Order::unknown;
            if (*pivot < 0) return Order::greater;
            for (std::size_t i = k + 1; i < states_; ++i) {
                const Ball times = rest[i][k] / rest[k][k];
                for (std::size_t j = k + 1; j < states_; ++j) rest[i][j] -= times * rest[k][j];
            }
        }
        return Order::less;
    }

private:
    std::size_t states_;
    const std::vector<RatioSum::Entry>& entries_;
    long precision_;
    std::vector<Ball> logs_;
};

/// A way back to a state: the product of its ratios, and over how many generations.
struct Return {
    Expression ratio;
    std::size_t generations;
};

/// The ways back to a state that every cycle goes through, if there is one with few.
std::optional<std::vector<Return>> returns(std::size_t states,
                                           const std::vector<RatioSum::Entry>& entries) {
    for (std::size_t home = 0; home < states; ++home) {
        std::vector<Return> found;
        bool fits = true;
        const auto follow = [&](const auto& self, std::size_t at, const Return& so_far) -> void {
            for (const RatioSum::Entry& entry : entries) {
                if (entry.from != at || !fits) continue;
                const Return next{times(so_far.ratio, entry.ratio), so_far.generations + 1};
                // A longer path has met some other state twice.
                fits = next.generations <= states && found.size() <= 10 * most_terms;
                if (entry.to == home)
                    found.push_back(next);
                else if (fits)
                    self(self, entry.to, next);
            }
        };
        follow(follow, home, {quantity(Rational(1)).expression, 0});
        if (fits) return found;
    }
    return std::nullopt;
}

bool is_plain(const std::string& text) {
    return text.find_first_not_of("0123456789.") == std::string::npos;
}

}  // namespace

RatioSum::RatioSum(std::size_t states, std::vector<Entry> entries, WayGrowth growth)
    : states_(states), entries_(std::move(entries)), growth_(std::move(growth)) {
    check();
}

RatioSum::RatioSum(std::size_t states, std::vector<Entry> entries)
    : states_(states), entries_(std::move(entries)) {
    check();
}

Ball RatioSum::growth(long bits) const { return growth_ ? growth_->enclosure(bits) : Ball(1, bits); }

void RatioSum::check() const {
    if (Ratios(states_, entries_, growth_, 192).radius(Rational(largest_dimension)) != Order::less)
        throw Error("parts do not become smaller than the whole");
}

Ball RatioSum::enclosure(long bits) const {
    Rational low = 0, high = largest_dimension;
    const Rational width = power(Rational(2), -bits);
    for (long precision = bits + 64;; precision *= 2) {
        if (precision > 64 * (bits + 64))
            throw BoundReached(Bound::digits, "the dimension needs too many digits");
        const Ratios ratios(states_, entries_, growth_, precision);
        for (bool certain = true; certain;) {
            if (high - low <= width) return hull(Ball(low, bits + 16), Ball(high, bits + 16));
            certain = false;
            // One of the two is not the solution itself.
            for (const Rational& share : {Rational(1, 2), Rational(3, 8)}) {
                const Rational middle = low + (high - low) * share;
                const Order order = ratios.radius(middle);
                if (order == Order::unknown) continue;
                (order == Order::less ? high : low) = middle;
                certain = true;
                break;
            }
        }
    }
}

std::string RatioSum::text() const {
    const std::string factor =
        significant_decimal([&](long bits) { return growth(bits); }, 6);
    const auto ways = returns(states_, entries_);
    std::vector<std::string> terms;
    std::map<std::string, std::size_t> counts;
    if (ways) {
        const bool all_at_once = !growth_ || std::all_of(
            ways->begin(), ways->end(), [](const Return& way) { return way.generations == 1; });
        for (const Return& way : *ways) {
            Expression ratio = way.ratio;
            if (sign(algae::enclosure(ratio, 192)) == -1)
                ratio = times(quantity(Rational(-1)).expression, ratio);
            std::string term = to_text(ratio);
            const bool is_single = is_plain(term);
            if (!all_at_once) {
                term = (is_single ? term : "(" + term + ")") + "/m";
                if (way.generations > 1) term += "^" + std::to_string(way.generations);
            }
            if (!all_at_once || !is_single) term = "(" + term + ")";
            term += "^s";
            if (++counts[term] == 1) terms.push_back(term);
        }
        if (terms.size() <= most_terms) {
            std::string text;
            for (const std::string& term : terms) {
                if (!text.empty()) text += " + ";
                const std::string count = std::to_string(counts[term]);
                text += term == "1^s" ? count : counts[term] > 1 ? count + "*" + term : term;
            }
            if (!growth_) return text + " = 1";
            return text + (all_at_once ? " = m^s" : " = 1") + " with m = " + factor;
        }
    }
    const std::string matrix =
        "the matrix of " + std::to_string(states_) + " by " + std::to_string(states_) + " sums of ";
    if (!growth_) return matrix + "ratio^s has the spectral radius 1";
    return matrix + "(ratio/m)^s has the spectral radius 1 with m = " + factor;
}

std::string RatioSum::decimal(int digits) const {
    return algae::decimal([&](long bits) { return enclosure(bits); }, digits);
}

}  // namespace algae
