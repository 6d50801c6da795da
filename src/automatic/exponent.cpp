#include <algorithm>
#include <map>
#include <set>

#include "automatic/detail/relations.hpp"
#include "combinatorics/combinatorics.hpp"

// The critical exponent of an infinite word.
//
// For each period p the greatest m such that a factor of m + p letters has it is found by automata, for all p at once. Pairs with m >= t p, for a number
// t a little below m/p of a factor that occurs, are mostly few: paths u v^k w of the automaton for finitely many u, v, w. Along each of them n and p are
// linear recurrences in k, sums of a constant, a multiple of the power of the greatest root of the recurrence of the lengths, and what vanishes. So the
// limit of n/p is a number in the field of that root, the sign of n/p minus the limit is decided from some k on, and those before are looked at.
// (That critical exponents of such words are algebraic: Krieger, On critical exponents in fixed points of non-erasing morphisms, 2007.)
//
// Without automata, so where addition is not regular too: by words v that occur again p letters later, whose numbers of letters go through one affine
// map again and again (`greatest_repetitions`). With L the left eigenvector of the matrix for its greatest root r, the limit of |v|/p along a chain
// is ((r - 1) L v + L added)/((r - 1) L p). A value t above the limit is above all later |v|/p as soon as t p - v exceeds, in every letter, a
// vector y with (matrix) y - added >= y. Where |v|/p comes near to the greatest limit itself, |v| minus the limit times p is
// a sum of powers of the other roots and of 1, of which the greatest one that occurs decides if it is above 0; otherwise some value is above the limit.

namespace algae {

namespace {

/// Digits before, round and behind a cycle; the cycle may be gone round any number of times. Without a cycle it is one path.
struct Family {
    std::vector<std::uint32_t> before, cycle, after;
};

/// The paths of an automaton as families; nothing if some path meets two cycles, or if there are many.
class Families {
public:
    explicit Families(const AutomaticRelation& relation) : relation_(relation) {}

    std::optional<std::vector<Family>> all() {
        constexpr std::size_t most_states = 4'000;
        if (relation_.states() > most_states) return std::nullopt;
        find_components();
        Family path;
        for (std::uint32_t e = relation_.first[0]; e < relation_.first[1]; ++e) {
            if (relation_.edges[e].column == 0) continue;  // zeros before the digits
            path.before = {relation_.edges[e].column};
            if (!walk(relation_.edges[e].target, path, none)) return std::nullopt;
        }
        return std::move(found_);
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// States that reach each other have one number; by Kosaraju's algorithm.
    void find_components() {
        const auto states = static_cast<std::uint32_t>(relation_.states());
        std::vector<std::vector<std::uint32_t>> back(states);
        for (std::uint32_t s = 0; s < states; ++s)
            for (std::uint32_t e = relation_.first[s]; e < relation_.first[s + 1]; ++e)
                back[relation_.edges[e].target].push_back(s);
        std::vector<std::uint32_t> order, at(states);
        std::vector<char> seen(states, 0);
        for (std::uint32_t s = 0; s < states; ++s) at[s] = relation_.first[s];
        for (std::uint32_t root = 0; root < states; ++root) {
            if (seen[root]) continue;
            seen[root] = 1;
            for (std::vector<std::uint32_t> stack{root}; !stack.empty();) {
                const std::uint32_t s = stack.back();
                if (at[s] == relation_.first[s + 1]) {
                    order.push_back(s);
                    stack.pop_back();
                    continue;
                }
                const std::uint32_t to = relation_.edges[at[s]++].target;
                if (seen[to]) continue;
                seen[to] = 1;
                stack.push_back(to);
            }
        }
        component_.assign(states, none);
        std::uint32_t count = 0;
        for (auto root = order.rbegin(); root != order.rend(); ++root) {
            if (component_[*root] != none) continue;
            component_[*root] = count;
            for (std::vector<std::uint32_t> stack{*root}; !stack.empty();) {
                const std::uint32_t s = stack.back();
                stack.pop_back();
                for (const std::uint32_t from : back[s])
                    if (component_[from] == none) {
                        component_[from] = count;
                        stack.push_back(from);
                    }
            }
            ++count;
        }
    }

    /// The only edge that stays in the component; `none` without one, and nothing if there are several.
    std::optional<std::uint32_t> edge_on_cycle(std::uint32_t state) const {
        std::uint32_t found = none;
        for (std::uint32_t e = relation_.first[state]; e < relation_.first[state + 1]; ++e) {
            if (component_[relation_.edges[e].target] != component_[state]) continue;
            if (found != none) return std::nullopt;
            found = e;
        }
        return found;
    }

    /// All paths on from a state; `entry` is the state where the path came to its cycle. False if they are no families.
    bool walk(std::uint32_t state, Family& path, std::uint32_t entry) {
        constexpr std::size_t most = 4'000;
        const auto round = edge_on_cycle(state);
        if (!round || found_.size() > most) return false;
        const bool is_on_cycle = *round != none;
        if (is_on_cycle && entry != none && component_[entry] != component_[state]) return false;
        if (is_on_cycle && entry == none) {
            entry = state;
            path.cycle.clear();
            std::uint32_t at = state;
            do {
                const auto edge = edge_on_cycle(at);
                if (!edge) return false;
                path.cycle.push_back(relation_.edges[*edge].column);
                at = relation_.edges[*edge].target;
            } while (at != state);
        }
        if (relation_.accepting[state]) found_.push_back(path);
        for (std::uint32_t e = relation_.first[state]; e < relation_.first[state + 1]; ++e) {
            const auto [column, target] = relation_.edges[e];
            if (entry != none && target == entry) continue;  // once more round
            auto& digits = entry == none ? path.before : path.after;
            digits.push_back(column);
            if (!walk(target, path, entry)) return false;
            digits.pop_back();
        }
        if (entry == state) path.cycle.clear();
        return true;
    }

    const AutomaticRelation& relation_;
    std::vector<std::uint32_t> component_;
    std::vector<Family> found_;
};

/// A quotient of two numbers of Z[r], the lower one above 0, for the greatest root r of the recurrence of the lengths.
struct Quotient {
    Polynomial above, below = 1;
};

/// n below - p above: its sign is that of n/p - above/below.
Polynomial apart(const std::pair<Integer, Integer>& one, const Quotient& limit) {
    return Polynomial(one.first) * limit.below - Polynomial(one.second) * limit.above;
}

/// The sign of a number of Z[r], reduced by the minimal polynomial of r, so that it is 0 only if the polynomial is.
int sign_at(const Rate& r, const Polynomial& reduced, const Budget& budget) {
    if (reduced.is_zero()) return 0;
    for (long bits = 128;; bits *= 2) {
        budget.check();
        if (const auto found = sign(reduced(r.enclosure(bits)))) return *found;
    }
}

/// What is known of n/p so far.
class Suprema {
public:
    Suprema(const AutomaticWord& word, const Polynomial& lengths, const Budget& budget)
        : numeration_(word.numeration),
          budget_(budget),
          field_(without_zeros(lengths)),
          first_(static_cast<std::size_t>(lengths.degree() - field_.modulus().degree())),
          rate_(rate_of(field_.modulus())) {}

    void add(const Family& family) {
        if (family.cycle.empty()) return note(pair(family, 0));
        follow(family);
    }

    CriticalExponent found() const {
        CriticalExponent all;
        const auto number = [&](const Quotient& one) {
            return Frequency(rate_, one.above, one.below);
        };
        if (limit_) all.asymptotic = number(*limit_);
        all.attained = best_ && (!limit_ || sign_of(apart(*best_, *limit_)) >= 0);
        if (all.attained) {
            all.factor = best_;
            all.value = number({best_->first, best_->second});
        } else {
            all.value = all.asymptotic;
        }
        return all;
    }

private:
    using Pair = std::pair<Integer, Integer>;  // n, p

    static Polynomial without_zeros(const Polynomial& polynomial) {
        std::vector<Integer> all = polynomial.coefficients();
        while (all.front().is_zero()) all.erase(all.begin());
        return Polynomial(std::move(all));
    }
    static Rate rate_of(const Polynomial& minimal) {
        if (minimal.degree() == 1) return Rate(-minimal.coefficient(0));
        Integer above = 1;  // Cauchy's bound
        for (const Integer& one : minimal.coefficients()) above += abs(one);
        return Rate(minimal, Rational(above));
    }

    Pair pair(const Family& family, std::size_t rounds) const {
        std::vector<std::uint32_t> m, p;
        const auto read = [&](const std::vector<std::uint32_t>& columns) {
            for (const std::uint32_t column : columns) {
                m.push_back(column % numeration_.base());
                p.push_back(column / numeration_.base());
            }
        };
        read(family.before);
        for (std::size_t k = 0; k < rounds; ++k) read(family.cycle);
        read(family.after);
        const Integer period = numeration_.value(p).value();
        return {numeration_.value(m).value() + period, period};
    }

    void note(const Pair& one) {
        if (best_) {
            const Integer left = one.first * best_->second, right = best_->first * one.second;
            if (left < right || (left == right && one.second >= best_->second)) return;
        }
        best_ = one;
    }

    Ball value(const Polynomial& one, long bits) const { return one(rate_.enclosure(bits)); }

    int sign_of(const Polynomial& one) const {
        return sign_at(rate_, field_.reduced(one), budget_);
    }

    void follow(const Family& family) {
        const long degree = field_.modulus().degree();
        const std::size_t size = static_cast<std::size_t>(degree);
        // The roots of `powers` are those of the recurrence to the length of the cycle.
        IntegerMatrix step(size, size), steps = IntegerMatrix::identity(size);
        for (std::size_t i = 0; i < size; ++i) {
            if (i + 1 < size) step(i, i + 1) = 1;
            step(size - 1, i) = -field_.modulus().coefficient(i);
        }
        for (std::size_t i = 0; i < family.cycle.size(); ++i) steps = steps * step;
        const Polynomial powers = characteristic_polynomial(steps);
        const Polynomial all = powers * Polynomial({-1, 1});
        const std::size_t from = first_ / family.cycle.size() + 1;
        std::vector<Pair> pairs;
        const auto at = [&](std::size_t k) -> const Pair& {
            budget_.check();
            while (pairs.size() <= k) pairs.push_back(pair(family, pairs.size()));
            return pairs[k];
        };
        for (std::size_t k = from; k < from + size + 2; ++k) {
            Pair sum{0, 0};
            for (std::size_t i = 0; i <= size + 1; ++i) {
                sum.first += all.coefficient(i) * at(k + i).first;
                sum.second += all.coefficient(i) * at(k + i).second;
            }
            if (!sum.first.is_zero() || !sum.second.is_zero())
                throw Error("lengths and periods of repetitions do not follow their recurrence");
        }
        // Quotients of `all` by x - root, weighted with the first values, give what is before the powers of the root.
        const Polynomial root = field_.power(Polynomial::monomial(1, 1), family.cycle.size());
        Quotient limit{0, 0};
        for (std::size_t j = 0; j <= size; ++j) {
            Polynomial weight;
            for (std::size_t i = size + 1; i > j; --i)
                weight = field_.reduced(weight * root) + Polynomial(all.coefficient(i));
            limit.above += weight * Polynomial(at(from + j).first);
            limit.below += weight * Polynomial(at(from + j).second);
        }
        limit.above = field_.reduced(limit.above);
        limit.below = field_.reduced(limit.below);
        if (sign_of(limit.below) <= 0) throw Error("periods of repetitions do not grow");
        if (!limit_ || sign_of(limit.above * limit_->below - limit_->above * limit.below) > 0)
            limit_ = limit;
        for (std::size_t k = 0; k < from; ++k) note(at(k));
        decide_from(from, powers, all, limit, at);
    }

    /// Notes the greatest n/p of k >= from, or that all are below the limit.
    template <class At>
    void decide_from(std::size_t from, const Polynomial& powers, const Polynomial& all,
                     const Quotient& limit, At at) {
        const std::size_t size = static_cast<std::size_t>(powers.degree());
        bool is_constant = true;
        for (std::size_t k = from; k <= from + size; ++k)
            is_constant = is_constant && sign_of(apart(at(k), limit)) == 0;
        if (is_constant) return note(at(from));
        // n below - p above = stays + what vanishes: both times powers(1).
        Pair ones{0, 0};
        for (std::size_t j = 0; j <= size; ++j) {
            ones.first += powers.coefficient(j) * at(from + j).first;
            ones.second += powers.coefficient(j) * at(from + j).second;
        }
        const Polynomial stays = apart(ones, limit);
        const long bits = 512;
        const Ball constant = abs(value(stays, bits) / Ball(powers(Integer(1)), bits));
        const auto vanishing = vanishing_parts(from, powers, all, limit, at, bits);
        const auto bound = [&](std::size_t k) {
            Ball sum(0, bits);
            for (const auto& [size_of, factor] : vanishing)
                sum += size_of * power(factor, Ball(Integer(k - from), bits));
            return sum;
        };
        constexpr std::size_t longest = 2'000;
        const bool stays_away = sign_of(stays) != 0;
        std::optional<Pair> above;  // the best that is greater than the limit
        for (std::size_t k = from; k < from + longest; ++k) {
            const int side = sign_of(apart(at(k), limit));
            if (side >= 0) note(at(k));
            if (side > 0 && (!above || at(k).first * above->second > above->first * at(k).second))
                above = at(k);
            const Ball rest = bound(k);
            if (stays_away && sign(constant - rest) == 1 &&
                (sign_of(stays) > 0) != (powers(Integer(1)) > 0))
                return;  // all further ones are below the limit
            // Further ones are at most (constant + rest) / p above the limit.
            if (above && sign(value(apart(*above, limit), bits) / Ball(above->second, bits) -
                              (constant + rest) / Ball(at(k).second, bits)) == 1)
                return;
        }
        throw BoundReached(Bound::method,
                           "whether repetitions reach the limit of their exponents is not decided");
    }

    /// Of the roots inside the unit circle: how much of each there is at k = from, and its size.
    template <class At>
    std::vector<std::pair<Ball, Ball>> vanishing_parts(std::size_t from, const Polynomial& powers,
                                                       const Polynomial& all, const Quotient& limit,
                                                       At at, long bits) const {
        const auto size_of = [](const ComplexBall& z) {
            return sqrt(z.real * z.real + z.imaginary * z.imaginary);
        };
        const std::size_t size = static_cast<std::size_t>(powers.degree());
        const Polynomial slope = derivative(all);
        std::vector<std::pair<Ball, Ball>> found;
        for (const Root& one : roots(powers, bits)) {
            const ComplexBall root{one.real, one.imaginary};
            const Ball size_of_root = size_of(root);
            if (compare(size_of_root, Ball(1, bits)) != Order::less) continue;  // the greatest one
            ComplexBall part{Ball(0, bits), Ball(0, bits)};
            for (std::size_t j = 0; j <= size; ++j) {
                ComplexBall weight{Ball(0, bits), Ball(0, bits)};
                for (std::size_t i = size + 1; i > j; --i)
                    weight =
                        weight * root + ComplexBall{Ball(all.coefficient(i), bits), Ball(0, bits)};
                const Ball value_of = value(apart(at(from + j), limit), bits);
                part = part + weight * ComplexBall{value_of, Ball(0, bits)};
            }
            found.emplace_back(size_of(part / value_at(slope, root)), size_of_root);
        }
        return found;
    }

    const Numeration& numeration_;
    const Budget& budget_;
    NumberField field_;
    std::size_t first_;  // from this power on lengths follow the polynomial without zeros
    Rate rate_;
    std::optional<Pair> best_;
    std::optional<Quotient> limit_;
};

/// An exponent that occurs, by the letters of a beginning of the word.
Rational occurring_exponent(const AutomaticWord& word, const Budget& budget) {
    constexpr std::size_t letters = 4'000, longest_period = 400;
    std::vector<std::uint32_t> states{0};
    for (std::size_t i = 0; states.size() < letters; ++i) {
        const auto& image = word.numeration.image(states[i]);
        states.insert(states.end(), image.begin() + (i == 0 ? 1 : 0), image.end());
    }
    Rational best = 1;
    for (std::size_t p = 1; p <= longest_period; ++p) {
        budget.check();
        std::size_t same = 0, most = 0;
        for (std::size_t i = 0; i + p < states.size(); ++i) {
            same = word.letters[states[i]] == word.letters[states[i + p]] ? same + 1 : 0;
            most = std::max(most, same);
        }
        best = std::max(best, Rational(Integer(most + p), Integer(p)));
    }
    return best;
}

}  // namespace

namespace {

using Counts = std::vector<Integer>;

/// The greatest |v|/p of repetitions, where words are images of themselves.
class GreatestQuotient {
public:
    GreatestQuotient(const GreatestRepetitions& all, const Budget& budget)
        : all_(all),
          budget_(budget),
          rate_(*components(growth_matrix(all.step), budget).list.front().rate),
          field_(rate_.minimal_polynomial()) {
        find_eigenvector();
        for (const RepetitionChain& chain : all.chains) {
            limits_.push_back(limit_of(chain));
            if (!limit_ || is_above(limits_.back(), *limit_)) limit_ = limits_.back();
        }
    }

    /// In the field of `rate`, if the other one is in it.
    CriticalExponent found(const Rate& rate) {
        if (!limit_) throw Error("repetitions do not go on");
        for (const auto& [n, p] : all_.single) note(n, p);
        constexpr std::size_t first = 12;
        for (const RepetitionChain& chain : all_.chains) {
            Walk walk(*this, chain);
            for (std::size_t k = 0; k < first; ++k, walk.step())
                note(walk.length(), walk.distance());
        }
        for (std::size_t i = 0; i < limits_.size() && side(best_) <= 0; ++i) {
            if (is_above(*limit_, limits_[i]))
                stays_below(all_.chains[i], between(limits_[i], *limit_));
            else
                near_limit(all_.chains[i]);
        }
        for (bool is_greatest = side(best_) <= 0; !is_greatest;) {
            const Pair greatest = best_;
            for (const RepetitionChain& chain : all_.chains)
                stays_below(chain, Rational(best_.first, best_.second));
            is_greatest = greatest == best_;
        }
        CriticalExponent answer;
        const auto number = [&](const Quotient& one) {
            return in_field_of(rate, one.above + one.below, one.below);
        };
        if (!is_above({all_.least.numerator(), all_.least.denominator()}, *limit_))
            answer.asymptotic = number(*limit_);
        answer.attained = side(best_) >= 0;
        if (answer.attained) {
            answer.factor = {best_.first + best_.second, best_.second};
            answer.value = Frequency(rate, best_.first + best_.second, best_.second);
        } else {
            answer.value = answer.asymptotic;
        }
        return answer;
    }

private:
    using Pair = std::pair<Integer, Integer>;  // |v| and p

    /// The repetitions of a chain one after the other.
    class Walk {
    public:
        Walk(const GreatestQuotient& of, const RepetitionChain& chain)
            : of_(of), chain_(chain), word_(chain.word), period_(chain.period) {}

        void step() {
            of_.budget_.check();
            for (std::size_t i = 0; i < chain_.rounds; ++i) {
                word_ = of_.all_.step * word_;
                period_ = of_.all_.step * period_;
            }
            for (std::size_t a = 0; a < word_.size(); ++a) word_[a] += chain_.added[a];
        }
        Integer length() const { return dot(of_.all_.lengths, word_) + chain_.behind; }
        Integer distance() const { return dot(of_.all_.lengths, period_); }
        const Counts& word() const { return word_; }
        const Counts& period() const { return period_; }

    private:
        const GreatestQuotient& of_;
        const RepetitionChain& chain_;
        Counts word_, period_;
    };

    /// A row of the adjugate of x - matrix, at the greatest root.
    void find_eigenvector() {
        const std::size_t size = all_.step.rows();
        const Polynomial characteristic = characteristic_polynomial(all_.step);
        Counts row(size);
        row[0] = 1;
        left_.assign(size, Polynomial());
        for (std::size_t k = size; k-- > 0;) {
            budget_.check();
            for (std::size_t a = 0; a < size; ++a) left_[a] += Polynomial::monomial(row[a], k);
            row = row * all_.step;
            row[0] += characteristic.coefficient(k);
        }
        for (Polynomial& one : left_) one = field_.reduced(one);
    }

    Polynomial weight(const Counts& counts) const {
        Polynomial sum;
        for (std::size_t a = 0; a < counts.size(); ++a) sum += left_[a] * Polynomial(counts[a]);
        return sum;
    }

    Quotient limit_of(const RepetitionChain& chain) const {
        const Polynomial less_one =
            field_.power(Polynomial::monomial(1, 1), chain.rounds) - Polynomial(1);
        return {field_.reduced(less_one * weight(chain.word) + weight(chain.added)),
                field_.multiply(less_one, weight(chain.period))};
    }

    Ball value(const Polynomial& one, long bits) const { return one(rate_.enclosure(bits)); }

    int sign_of(const Polynomial& one) const {
        return sign_at(rate_, field_.reduced(one), budget_);
    }

    bool is_above(const Quotient& one, const Quotient& other) const {
        return sign_of(one.above * other.below - other.above * one.below) > 0;
    }
    /// Whether it is above the greatest limit, or on it.
    int side(const Pair& one) const { return sign_of(apart(one, *limit_)); }

    void note(const Integer& n, const Integer& p) {
        const Integer left = n * best_.second, right = best_.first * p;
        if (left > right || (left == right && p < best_.second)) best_ = {n, p};
    }

    Rational between(const Quotient& low, const Quotient& high) const {
        for (long bits = 128;; bits *= 2) {
            budget_.check();
            const Rational below = (value(low.above, bits) / value(low.below, bits)).upper(),
                           above = (value(high.above, bits) / value(high.below, bits)).lower();
            if (below < above) {
                // With few digits, for what is reckoned with it.
                for (Integer scale = 16;; scale *= 16)
                    if (Rational found(ceiling(above * Rational(scale)) - Integer(1), scale);
                        found > below)
                        return found;
            }
        }
    }

    /// Notes the |v|/p of a chain until all further ones are at most `most`, which is above the limit.
    void stays_below(const RepetitionChain& chain, const Rational& most) {
        const Integer &above = most.numerator(), &below = most.denominator();
        // sum - matrix^rounds sum is above 0 in all places, as matrix^rounds of its last term is 2 or more.
        Counts sum(all_.lengths.size()), power(all_.lengths.size(), Integer(1));
        Integer times = below * chain.behind + 1;
        for (const Integer& one : chain.added) times = std::max(times, below * one);
        while (
            std::any_of(power.begin(), power.end(), [](const Integer& one) { return one < 2; })) {
            for (std::size_t a = 0; a < sum.size(); ++a) sum[a] += power[a];
            for (std::size_t i = 0; i < chain.rounds; ++i) power = all_.step * power;
        }
        for (Walk walk(*this, chain);; walk.step()) {
            note(walk.length(), walk.distance());
            bool is_far = true;
            for (std::size_t a = 0; is_far && a < sum.size(); ++a)
                is_far = above * walk.period()[a] - below * walk.word()[a] >= times * sum[a];
            if (is_far) return;
        }
    }

    [[noreturn]] static void not_decided() {
        throw BoundReached(Bound::method,
                           "whether repetitions reach the limit of their exponents is not decided");
    }

    /// The same of a chain that has the greatest limit: until all further ones are at most it, or one is above.
    void near_limit(const RepetitionChain& chain) {
        IntegerMatrix steps = all_.step;
        for (std::size_t i = 1; i < chain.rounds; ++i) steps = steps * all_.step;
        Polynomial all = characteristic_polynomial(steps) * Polynomial({-1, 1});
        const auto size = static_cast<std::size_t>(all.degree());
        std::vector<Polynomial> values;  // |v| - limit p, times the divisor of the limit
        Walk walk(*this, chain);
        const auto at = [&](std::size_t k) -> const Polynomial& {
            for (; values.size() <= k; walk.step()) {
                note(walk.length(), walk.distance());
                values.push_back(field_.reduced(apart({walk.length(), walk.distance()}, *limit_)));
            }
            return values[k];
        };
        const auto sum = [&](const Polynomial& with, std::size_t from) {
            Polynomial found;
            for (std::size_t i = 0; i < with.coefficients().size(); ++i)
                found += at(from + i) * Polynomial(with.coefficients()[i]);
            return field_.reduced(found);
        };
        // The least multiple of some factors that the values satisfy.
        for (const auto& [factor, exponent] : factorise(all).powers)
            for (unsigned i = 0; i < exponent; ++i) {
                const Polynomial rest = *exact_divide(all, factor);
                bool is_enough = true;
                for (std::size_t k = 0; is_enough && k < size; ++k)
                    is_enough = sum(rest, k).is_zero();
                if (is_enough) all = rest;
            }
        std::size_t from = 0;  // powers of 0 are gone
        for (; all.coefficient(0).is_zero(); ++from)
            all = *exact_divide(all, Polynomial::monomial(1, 1));
        if (all.degree() == 0) return;  // they are all 0, and the first ones are noted
        if (!is_squarefree(all)) not_decided();
        const long bits = 512;
        std::vector<Part> parts = parts_of(chain, all, from, at, bits);
        constexpr std::size_t longest = 2'000;
        for (std::size_t k = from; k < from + longest; ++k) {
            // If one is above, what is noted decides which is the greatest.
            if (sign_of(at(k)) > 0) return;
            for (const Part& one : parts) {
                if (!one.falls) continue;
                Ball others(0, bits);
                bool is_greatest = true;
                for (const Part& other : parts) {
                    if (&other == &one) continue;
                    is_greatest = is_greatest && compare(other.root, one.root) == Order::less;
                    others += other.size;
                }
                if (is_greatest && sign(one.size - others) == 1) return;
            }
            for (Part& one : parts) one.size *= one.root;
        }
        not_decided();
    }

    /// A power of a root in a sum.
    struct Part {
        Ball size, root;     // absolute values
        bool falls = false;  // the root is above 0, and its part below
    };

    /// The parts of roots in values from some place on. The root of the limit has none.
    template <class At>
    std::vector<Part> parts_of(const RepetitionChain& chain, const Polynomial& all,
                               std::size_t from, At at, long bits) const {
        const auto size_of = [](const ComplexBall& z) {
            return sqrt(z.real * z.real + z.imaginary * z.imaginary);
        };
        const Ball rate = power(rate_.enclosure(bits), Ball(Integer(chain.rounds), bits));
        const Polynomial slope = derivative(all);
        const auto size = static_cast<std::size_t>(all.degree());
        std::vector<Part> found;
        for (const Root& one : roots(all, bits)) {
            const ComplexBall root{one.real, one.imaginary};
            if (one.is_real && one.real.overlaps(rate)) continue;
            ComplexBall part{Ball(0, bits), Ball(0, bits)};
            for (std::size_t j = 0; j < size; ++j) {
                ComplexBall weight_of{Ball(0, bits), Ball(0, bits)};
                for (std::size_t i = size; i > j; --i)
                    weight_of = weight_of * root +
                                ComplexBall{Ball(all.coefficient(i), bits), Ball(0, bits)};
                part = part + weight_of * ComplexBall{value(at(from + j), bits), Ball(0, bits)};
            }
            part = part / value_at(slope, root);
            found.push_back({size_of(part), size_of(root),
                             one.is_real && sign(one.real) == 1 && sign(part.real) == -1});
        }
        return found;
    }

    /// A quotient of numbers of the field by the rate of another one, of which the rate is a power; as it is where that does not show.
    Frequency in_field_of(const Rate& other, const Polynomial& above,
                          const Polynomial& below) const {
        constexpr std::size_t most = 64;
        if (rate_ == other || rate_.degree() <= 2) return Frequency(rate_, above, below);
        const NumberField field(other.minimal_polynomial());
        Polynomial power = 1;
        for (std::size_t j = 1; j <= most; ++j) {
            power = field.multiply(power, Polynomial::monomial(1, 1));
            const auto put = [&](const Polynomial& polynomial) {
                Polynomial found;
                for (std::size_t k = polynomial.coefficients().size(); k-- > 0;)
                    found = field.reduced(found * power + Polynomial(polynomial.coefficients()[k]));
                return found;
            };
            if (!put(rate_.minimal_polynomial()).is_zero()) continue;
            // It is a root of the polynomial, and the greatest one if it is that and no other is near.
            std::size_t near = 0;
            constexpr long bits = 512;
            for (const Root& one : roots(rate_.minimal_polynomial(), bits))
                near += one.is_real && one.real.overlaps(power(other.enclosure(bits)));
            if (near != 1 || !rate_.enclosure(bits).overlaps(power(other.enclosure(bits))))
                continue;
            return Frequency(other, put(above), put(below));
        }
        throw BoundReached(Bound::method,
                           "the critical exponent is in another field than the "
                           "lengths of the words");
    }

    const GreatestRepetitions& all_;
    const Budget& budget_;
    Rate rate_;
    NumberField field_;
    std::vector<Polynomial> left_;   // the eigenvector
    std::vector<Quotient> limits_;   // by chain
    std::optional<Quotient> limit_;  // the greatest one
    Pair best_{0, 1};
};

}  // namespace

CriticalExponent critical_exponent(const D0L& system, const Budget& budget) {
    if (system.axiom.empty()) throw Error("the axiom is empty, so there is no infinite word");
    Symbol first = system.axiom.front();
    for (std::size_t i = 0; i < system.letters.size(); ++i) {
        const Word& image = system.successor(first);
        if (image.empty()) throw Error("the first letter of the infinite word vanishes");
        first = image.front();
    }
    CriticalExponent found;
    D0L own = system;  // whose words begin the infinite word, where one begins the next
    own.axiom = {first};
    found.infinite = system.successor(first).front() == first &&
                     system.successor(first).size() > 1 &&
                     !infinite_repetitions(own, budget).empty();
    if (found.infinite) return found;
    const GreatestRepetitions all = greatest_repetitions(system.rules, first, budget);
    found.infinite = all.periodic;
    if (found.infinite) return found;
    Rate rate;
    for (const Component& part : components(growth_matrix(system), budget).list)
        if (part.rate) rate = std::max(rate, *part.rate);
    return GreatestQuotient(all, budget).found(rate);
}

CriticalExponent critical_exponent(const AutomaticWord& word, const Budget& budget) {
    const auto relation = [&](const std::string& statement) {
        return decide_first_order(read_first_order(statement, "exponent", "T", word.letters), word,
                                  budget)
            .relation;
    };
    Relations relations(word, budget, {});
    const AutomaticRelation with_period =
        relation("p >= 1 and for some i: for all u with i <= u < i + m: T[u] = T[u + p]");
    CriticalExponent found;
    const AutomaticRelation longest =
        relations.both(with_period, relations.complement(relations.one_more(with_period, "m")));
    if (relations.without(longest, {"m"}) != relations.without(with_period, {"m"})) {
        found.infinite = true;
        return found;
    }
    const Rational occurs = occurring_exponent(word, budget) - Rational(1);
    std::optional<Rational> last;
    for (const int part : {1, 2, 3, 4, 6, 8, 12, 16, 24}) {
        const Integer times = ceiling(occurs * Rational(part)) - Integer(1);
        const Rational least(times, part);
        if (times < 0 || (last && least <= *last)) continue;
        last = least;
        const auto families =
            Families(relations.both(longest, relation(std::to_string(part) +
                                                      " * m >= " + to_string(times) + " * p")))
                .all();
        if (!families) continue;
        Suprema suprema(word, relations.recurrence(), budget);
        for (const Family& family : *families) suprema.add(family);
        return suprema.found();
    }
    throw BoundReached(Bound::method,
                       "repetitions near the critical exponent are too many to follow each");
}

}  // namespace algae
