#include <algorithm>
#include <map>
#include <set>

#include "automatic/detail/relations.hpp"

// The critical exponent of an infinite word.
//
// For each period p the greatest m such that a factor of m + p letters has it is found by automata, for all p at once. Pairs with m >= t p, for a number
// t a little below m/p of a factor that occurs, are mostly few: paths u v^k w of the automaton for finitely many u, v, w. Along each of them n and p are
// linear recurrences in k, sums of a constant, a multiple of the power of the greatest root of the recurrence of the lengths, and what vanishes. So the
// limit of n/p is a number in the field of that root, the sign of n/p minus the limit is decided from some k on, and those before are looked at.
// (That critical exponents of such words are algebraic: Krieger, On critical exponents in fixed points of non-erasing morphisms, 2007.)

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

    /// n below - p above: its sign is that of n/p - above/below.
    static Polynomial apart(const Pair& one, const Quotient& limit) {
        return Polynomial(one.first) * limit.below - Polynomial(one.second) * limit.above;
    }

    Ball value(const Polynomial& one, long bits) const { return one(rate_.enclosure(bits)); }

    int sign_of(const Polynomial& one) const {
        const Polynomial reduced = field_.reduced(one);
        if (reduced.is_zero()) return 0;
        for (long bits = 128;; bits *= 2) {
            budget_.check();
            if (const auto found = sign(value(reduced, bits))) return *found;
        }
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
