#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "growth/growth.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"

// Statements about numbers that hold for all n: `length(G, n + 2) = length(G, n + 1) + length(G, n)`, `count(G, F, n) =
// 4^n`, `n^2 <= 2^n` for n >= 4.
//
// Terms. A term in one number n, all else fixed, is an element of a vector space of sequences that is closed under the shift
// n -> n + 1, and of which we know a bound D of the dimension, the order:
//   a number                     1
//   n                            2
//   c^(a n + b)                  1
//   length(G, a n + b)           the letters of G, if a > 0: the counts of letters are multiplied by a matrix
//   u + v, u - v                 the sum of both orders
//   u v                          the product
//   u^k                          C(D + k - 1, k), products of k elements of a space of dimension D
// Theorem: a sequence of such a space whose first D terms are 0 is 0, as D + 1 shifts of it are dependent, and so every term
// is a combination of the D before (Salomaa and Soittola 1978, II.1; the ring of sequences with a linear recurrence). With
// two numbers n and m the same holds for n with m fixed and for m with n fixed, so a difference that is 0 for all n < D
// and m < E is 0. So an equation is decided by looking at finitely many points.
//
// Conditions such as k < n and n >= 1 are taken into the terms: n is 1 + n', or k + 1 + n', where n' is any number.
//
// Inequalities. Let u be the difference, which is to be not negative (or positive). Where no counterexample is found
// among the first terms, we look for numbers c_1, ..., c_s >= 0 such that the last of the sequences u_0 = u, u_i(n) =
// u_{i-1}(n+1) - c_i u_{i-1}(n) has a recurrence u_s(n+r) = a_0 u_s(n) + ... + a_{r-1} u_s(n+r-1) without a negative a_i.
// If the first r terms of u_s and the first term of each u_i are not negative, so are all terms of all of them. The c_i
// are non-negative integral roots of the shortest recurrence of u, taken out one after the other.
//
// Numbers are exact: rational, or a + b sqrt(d) with one d in a statement.
//
// What is counted of figures, `distinct segments(G, 3)` and `boxes(G, 3, 2)`, is no such sequence: it is worked out of one
// generation at a time, where its number and the side are known.

namespace algae {

bool is_so(Comparison comparison, std::strong_ordering order) {
    switch (comparison) {
        case Comparison::equal:
            return order == 0;
        case Comparison::unequal:
            return order != 0;
        case Comparison::less:
            return order < 0;
        case Comparison::at_most:
            return order <= 0;
        case Comparison::greater:
            return order > 0;
        case Comparison::at_least:
            return order >= 0;
    }
    return false;
}

namespace {

constexpr std::uint64_t highest_order = 2'000, most_points = 20'000, latest_generation = 100'000;
constexpr std::uint64_t kept_generations = 4'096;
constexpr std::int64_t highest_power = 100'000;

using Point = std::map<std::string, Integer>;

[[noreturn]] void fail(const Expression& part, const std::string& expected) {
    const std::string where = part.place.line == 0 ? "" : to_string(part.place) + ": ";
    throw Error(where + "expected " + expected + ", found " + to_text(part));
}

// --- Numbers with one square root ---

QuadraticNumber rational(Rational value) { return {std::move(value), Rational(0), 1}; }

bool is_rational(const QuadraticNumber& number) { return number.factor.is_zero(); }

/// The radicand of both. Throws Error at `part` if they have different ones.
Integer radicand_of(const QuadraticNumber& left, const QuadraticNumber& right,
                    const Expression& part) {
    if (is_rational(left)) return is_rational(right) ? Integer(1) : right.radicand;
    if (!is_rational(right) && left.radicand != right.radicand)
        fail(part, "roots of one number in a statement");
    return left.radicand;
}

QuadraticNumber sum(const QuadraticNumber& left, const QuadraticNumber& right,
                    const Expression& part) {
    return {left.rational + right.rational, left.factor + right.factor,
            radicand_of(left, right, part)};
}

QuadraticNumber opposite(const QuadraticNumber& number) {
    return {-number.rational, -number.factor, number.radicand};
}

QuadraticNumber product(const QuadraticNumber& left, const QuadraticNumber& right,
                        const Expression& part) {
    const Integer radicand = radicand_of(left, right, part);
    return {left.rational * right.rational + left.factor * right.factor * Rational(radicand),
            left.rational * right.factor + left.factor * right.rational, radicand};
}

/// Of a number that is not 0.
QuadraticNumber inverse(const QuadraticNumber& number) {
    const Rational norm = number.rational * number.rational -
                          number.factor * number.factor * Rational(number.radicand);
    return {number.rational / norm, -number.factor / norm, number.radicand};
}

bool is_zero(const QuadraticNumber& number) {
    return number.rational.is_zero() && number.factor.is_zero();
}

/// -1, 0 or 1.
int sign_of(const QuadraticNumber& number) {
    const int whole = sign(number.rational), root = sign(number.factor);
    if (whole * root >= 0) return whole != 0 ? whole : root;
    const Rational square = number.rational * number.rational,
                   other = number.factor * number.factor * Rational(number.radicand);
    return square > other ? whole : root;
}

QuadraticNumber root_of(const Expression& part, const QuadraticNumber& of) {
    constexpr std::uint64_t most = 1'000'000;
    if (!is_rational(of) || !of.rational.is_integer() || of.rational < 0 ||
        of.rational > Rational(most))
        fail(part, "the root of a natural number up to 1000000");
    std::uint64_t radicand = of.rational.numerator().to_uint64(), factor = 1;
    if (radicand == 0) return rational(0);
    for (std::uint64_t d = 2; d * d <= radicand; ++d)
        for (; radicand % (d * d) == 0; radicand /= d * d) factor *= d;
    if (radicand == 1) return rational(Rational(factor));
    return {Rational(0), Rational(factor), Integer(radicand)};
}

/// A sum of multiples of numbers and a constant.
struct Linear {
    std::map<std::string, Rational> slopes;  // none is 0
    Rational constant;

    void add(const Linear& other, const Rational& times) {
        for (const auto& [name, slope] : other.slopes) slopes[name] += times * slope;
        std::erase_if(slopes, [](const auto& one) { return one.second.is_zero(); });
        constant += times * other.constant;
    }
};

std::optional<Linear> linear(const Expression& expression) {
    using Kind = Expression::Kind;
    const auto part = [&](std::size_t i) { return linear(expression.operands[i]); };
    switch (expression.kind) {
        case Kind::number:
            return Linear{{}, expression.value};
        case Kind::name:
            return Linear{{{expression.name, Rational(1)}}, Rational(0)};
        case Kind::unary: {
            Linear negative;
            const auto of = part(0);
            if (of) negative.add(*of, Rational(-1));
            return of ? std::optional(negative) : std::nullopt;
        }
        case Kind::binary: {
            auto left = part(0);
            const auto right = part(1);
            if (!left || !right) return std::nullopt;
            const std::string& sign = expression.name;
            Linear made;
            if (sign == "+" || sign == "-")
                left->add(*right, Rational(sign == "+" ? 1 : -1));
            else if (sign == "*" && left->slopes.empty())
                made.add(*right, left->constant);
            else if (sign == "*" && right->slopes.empty())
                made.add(*left, right->constant);
            else if (sign == "/" && right->slopes.empty() && !right->constant.is_zero())
                made.add(*left, Rational(1) / right->constant);
            else
                return std::nullopt;
            return sign == "+" || sign == "-" ? left : made;
        }
        default:
            return std::nullopt;
    }
}

}  // namespace

std::optional<std::pair<Rational, Rational>> slope_and_start(const Expression& term,
                                                             const std::string& name) {
    const auto found = linear(term);
    if (!found) return std::nullopt;
    Rational slope;
    for (const auto& [of, times] : found->slopes) {
        if (of != name) return std::nullopt;
        slope = times;
    }
    return std::pair(slope, found->constant);
}

std::optional<std::map<std::string, std::int64_t>> integral_slopes(const Expression& term) {
    const auto found = linear(term);
    if (!found) return std::nullopt;
    std::map<std::string, std::int64_t> made;
    const auto add = [&](const std::string& name, const Rational& times) {
        constexpr long most = 1'000'000;
        if (!times.is_integer() || abs(times) > Rational(most)) return false;
        if (!times.is_zero()) made[name] = times.numerator().to_int64();
        return true;
    };
    if (!add("1", found->constant)) return std::nullopt;
    for (const auto& [name, slope] : found->slopes)
        if (!add(name, slope)) return std::nullopt;
    return made;
}

namespace {

// --- Terms ---

/// The counts of letters of the generations of a D0L system.
class Generations {
public:
    Generations(const SourceSystem& system, const Budget& budget)
        : system_(as_d0l(system)), matrix_(growth_matrix(system_)), budget_(budget) {
        kept_.push_back(axiom_counts(system_));
    }

    std::size_t letters() const { return system_.letters.size(); }

    /// Of one letter, or of all.
    Integer count(std::uint64_t generation, const std::string* letter) {
        const std::vector<Integer>& counts = of(generation);
        if (!letter) return std::accumulate(counts.begin(), counts.end(), Integer(0));
        const auto symbol = system_.alphabet->find(*letter);
        const auto at = symbol ? std::find(system_.letters.begin(), system_.letters.end(), *symbol)
                               : system_.letters.end();
        return at == system_.letters.end()
                   ? Integer(0)
                   : counts[static_cast<std::size_t>(at - system_.letters.begin())];
    }

private:
    const std::vector<Integer>& of(std::uint64_t generation) {
        if (generation > latest_generation)
            throw BoundReached(Bound::method, "numbers are worked out up to generation " +
                                                  std::to_string(latest_generation));
        while (kept_.size() <= std::min(generation, kept_generations)) {
            budget_.check();
            kept_.push_back(kept_.back() * matrix_);
        }
        if (generation < kept_.size()) return kept_[static_cast<std::size_t>(generation)];
        if (generation < late_) late_ = 0;
        if (late_ == 0) {
            late_ = kept_.size() - 1;
            counts_ = kept_.back();
        }
        for (; late_ < generation; ++late_) {
            budget_.check();
            counts_ = counts_ * matrix_;
        }
        return counts_;
    }

    D0L system_;
    GrowthMatrix matrix_;
    const Budget& budget_;
    std::vector<std::vector<Integer>> kept_;
    std::vector<Integer> counts_;  // of generation `late_`
    std::uint64_t late_ = 0;
};

/// The terms of a statement: their values at points, and their orders.
class Terms {
public:
    Terms(const ComparesNumbers& said, const Budget& budget) : said_(said), budget_(budget) {}

    QuadraticNumber value(const Expression& expression, const Point& point) {
        using Kind = Expression::Kind;
        const auto part = [&](std::size_t i) { return value(expression.operands[i], point); };
        budget_.check();
        switch (expression.kind) {
            case Kind::number:
                return rational(expression.value);
            case Kind::name: {
                const auto found = point.find(expression.name);
                if (found == point.end()) fail(expression, "a number");
                return rational(Rational(found->second));
            }
            case Kind::unary:
                return opposite(part(0));
            case Kind::binary:
                return binary(expression, point);
            case Kind::call:
                if (expression.name == "sqrt") return root_of(expression, part(0));
                return rational(Rational(is_of_figure(expression) ? drawn(expression, point)
                                                                  : counted(expression, point)));
            default:
                fail(expression, "a number");
        }
    }

    /// The left side minus the right one.
    QuadraticNumber difference(const Point& point) {
        return sum(value(said_.left, point), opposite(value(said_.right, point)), said_.left);
    }

    bool holds(const Point& point) {
        return is_so(said_.comparison, sign_of(difference(point)) <=> 0);
    }

    /// The order of a term in one number. `moved`: what its numbers are of others that are free. Throws Error where it is no
    /// such term.
    std::uint64_t order(const Expression& expression, const std::string& in,
                        const std::map<std::string, Linear>& moved) {
        using Kind = Expression::Kind;
        const auto part = [&](std::size_t i) { return order(expression.operands[i], in, moved); };
        switch (expression.kind) {
            case Kind::name: {
                const auto found = moved.find(expression.name);
                if (found == moved.end()) fail(expression, "a number that is bound");
                return found->second.slopes.count(in) ? 2 : 1;
            }
            case Kind::unary:
                if (expression.name != "-") fail(expression, "a formula in n made by + - * / ^");
                return part(0);
            case Kind::call:
                if (expression.name == "sqrt") {
                    if (!is_constant(expression))
                        fail(expression, "the root of a number without n");
                    return 1;
                }
                if (is_of_figure(expression)) {
                    if (!is_constant(expression))
                        fail(expression,
                             "the figure of one generation, such as " + expression.name + "(G, 3" +
                                 (expression.name == "boxes" ? ", 1" : "") +
                                 "), or a bound of the numbers, such as 'for all numbers n <= 4:'");
                    return 1;
                }
                return generation_of(expression, moved).slopes.count(in)
                           ? system(expression).letters()
                           : 1;
            case Kind::binary:
                if (expression.name == "^") return order_of_power(expression, in, moved);
                if (expression.name == "*") return bounded(part(0) * part(1), expression);
                if (expression.name == "/") {
                    check_divisor(expression.operands[1]);
                    return bounded(part(0) * part(1), expression);
                }
                if (expression.name != "+" && expression.name != "-")
                    fail(expression, "a formula in n made by + - * / ^");
                return bounded(part(0) + part(1), expression);
            default:
                return 1;
        }
    }

private:
    /// Whether it is a call of `distinct segments` or `boxes`, whose first operand is a system.
    static bool is_of_figure(const Expression& call) {
        return call.name == "distinct segments" || call.name == "boxes";
    }

    static bool is_constant(const Expression& expression) {
        if (expression.kind == Expression::Kind::name) return false;
        if (expression.kind == Expression::Kind::call && is_of_figure(expression))
            return std::all_of(expression.operands.begin() + 1, expression.operands.end(),
                               is_constant);
        if (expression.kind == Expression::Kind::call && expression.name != "sqrt")
            return is_constant(expression.operands.back());
        return std::all_of(expression.operands.begin(), expression.operands.end(), is_constant);
    }

    /// Throws Error unless the term is never 0 and its inverse is a multiple of a power c^n: numbers, powers with n in the
    /// exponent, and products of these.
    void check_divisor(const Expression& divisor) {
        const bool is_product = divisor.kind == Expression::Kind::binary &&
                                (divisor.name == "*" || divisor.name == "/");
        const bool is_power = divisor.kind == Expression::Kind::binary && divisor.name == "^" &&
                              is_constant(divisor.operands[0]);
        if (is_product || divisor.kind == Expression::Kind::unary)
            for (const Expression& part : divisor.operands) check_divisor(part);
        else if (!is_power && (!is_constant(divisor) || is_zero(value(divisor, {}))))
            fail(divisor, "a number that is not 0 to divide by");
    }

    static std::uint64_t bounded(std::uint64_t order, const Expression& part) {
        if (order > highest_order) fail(part, "a smaller term");
        return order;
    }

    /// The generation that a call speaks of, in free numbers. Throws Error unless it is one for all of these.
    static Linear generation_of(const Expression& call,
                                const std::map<std::string, Linear>& moved) {
        const Expression& written = call.operands.back();
        const auto in_names = linear(written);
        if (!in_names) fail(written, "a generation like n, 2*n + 1 or n + k");
        Linear made{{}, in_names->constant};
        for (const auto& [name, slope] : in_names->slopes) made.add(moved.at(name), slope);
        const auto fits = [](const Rational& number) { return number.is_integer() && number >= 0; };
        if (!fits(made.constant))
            fail(written,
                 "a generation from 0 on for all numbers, such as n + 1, or a bound such as "
                 "'for all numbers n >= 1:'");
        for (const auto& [name, slope] : made.slopes)
            if (!fits(slope))
                fail(written, "a generation that is a natural number for all numbers");
        return made;
    }

    std::uint64_t order_of_power(const Expression& power, const std::string& in,
                                 const std::map<std::string, Linear>& moved) {
        const Expression &base = power.operands[0], &exponent = power.operands[1];
        if (is_constant(exponent)) {
            const auto times = natural(exponent);
            if (!times || *times > 1000) fail(exponent, "an exponent from 0 to 1000");
            std::uint64_t made = 1;  // C(order + i, i + 1), one factor after the other
            const std::uint64_t of = order(base, in, moved);
            for (std::uint64_t i = 0; i < *times; ++i)
                made = bounded(made * (of + i) / (i + 1), power);
            return made;
        }
        if (!is_constant(base) || is_zero(value(base, {})))
            fail(base, "a number that is not 0 as base of a power with n in its exponent");
        const auto found = linear(exponent);
        const auto is_whole = [](const Rational& number) { return number.is_integer(); };
        Linear made;
        if (found) {
            made.constant = found->constant;
            for (const auto& [name, slope] : found->slopes) made.add(moved.at(name), slope);
        }
        if (!found || !is_whole(made.constant) ||
            !std::all_of(made.slopes.begin(), made.slopes.end(),
                         [&](const auto& one) { return is_whole(one.second); }))
            fail(exponent, "an exponent like 2*n+1");
        return 1;
    }

    std::optional<std::uint64_t> natural(const Expression& constant) {
        const QuadraticNumber found = value(constant, {});
        if (!is_rational(found) || !found.rational.is_integer() || found.rational < 0 ||
            !found.rational.numerator().fits_uint64())
            return std::nullopt;
        return found.rational.numerator().to_uint64();
    }

    Generations& system(const Expression& call) {
        const std::string& name = call.operands.front().name;
        if (const auto found = generations_.find(name); found != generations_.end())
            return found->second;
        for (const auto& system : said_.systems)
            if (system->name == name)
                return generations_.emplace(name, Generations(*system, budget_)).first->second;
        fail(call, "a system");
    }

    /// The number of a generation; those that are too late are all the same one.
    std::uint64_t generation_at(const Expression& written, const Point& point) {
        const QuadraticNumber found = value(written, point);
        if (!is_rational(found) || !found.rational.is_integer() || found.rational < 0)
            fail(written, "the number of a generation");
        return found.rational <= Rational(latest_generation)
                   ? found.rational.numerator().to_uint64()
                   : latest_generation + 1;
    }

    Integer counted(const Expression& call, const Point& point) {
        if (call.operands.size() < 2) fail(call, "the length of a word that has a value");
        return system(call).count(generation_at(call.operands.back(), point),
                                  call.name == "count" ? &call.operands[1].name : nullptr);
    }

    /// What is counted of a figure, each once.
    Integer drawn(const Expression& call, const Point& point) {
        const auto turtle = said_.turtles.find(call.operands.front().name);
        if (turtle == said_.turtles.end()) fail(call, "a system with a turtle");
        const std::uint64_t generation = generation_at(call.operands[1], point);
        if (generation > latest_generation)
            throw BoundReached(Bound::method, "figures are drawn up to generation " +
                                                  std::to_string(latest_generation));
        Rational side;  // 0 where segments are counted
        if (call.operands.size() > 2) {
            const QuadraticNumber found = value(call.operands[2], point);
            if (!is_rational(found) || found.rational <= 0)
                fail(call.operands[2], "a side of boxes above 0, in steps, such as 1 or 1/3");
            side = found.rational;
        }
        const auto [known, is_new] = drawn_.try_emplace({turtle->first, generation, side});
        if (is_new)
            known->second = side.is_zero() ? distinct_segments(*turtle->second, generation, budget_)
                                           : met_boxes(*turtle->second, generation, side, budget_);
        return known->second;
    }

    QuadraticNumber binary(const Expression& expression, const Point& point) {
        const QuadraticNumber left = value(expression.operands[0], point),
                              right = value(expression.operands[1], point);
        const std::string& sign = expression.name;
        if (sign == "+") return sum(left, right, expression);
        if (sign == "-") return sum(left, opposite(right), expression);
        if (sign == "*") return product(left, right, expression);
        if (sign == "/") {
            if (is_zero(right)) fail(expression.operands[1], "a number that is not 0 to divide by");
            return product(left, inverse(right), expression);
        }
        if (sign != "^") fail(expression, "a formula in n made by + - * / ^");
        if (!is_rational(right) || !right.rational.is_integer() ||
            abs(right.rational) > Rational(highest_power))
            fail(expression.operands[1],
                 "a whole number up to " + std::to_string(highest_power) + " as exponent");
        return raised(left, right.rational.numerator().to_int64(), expression);
    }

    QuadraticNumber raised(QuadraticNumber base, std::int64_t exponent, const Expression& part) {
        if (exponent < 0 && is_zero(base)) fail(part, "a number that is not 0 to divide by");
        if (exponent < 0) base = inverse(base);
        const std::uint64_t size =
            bit_length(base.rational.numerator()) + bit_length(base.rational.denominator()) +
            bit_length(base.factor.numerator()) + bit_length(base.factor.denominator());
        std::uint64_t left = static_cast<std::uint64_t>(exponent < 0 ? -exponent : exponent);
        budget_.check_memory(size * left, "the digits of a power");
        if (is_rational(base))
            return rational(power(base.rational, static_cast<std::int64_t>(left)));
        QuadraticNumber made = rational(1);
        for (; left > 0; left /= 2, base = product(base, base, part))
            if (left % 2 == 1) made = product(made, base, part);
        return made;
    }

    const ComparesNumbers& said_;
    const Budget& budget_;
    std::map<std::string, Generations> generations_;
    std::map<std::tuple<std::string, std::uint64_t, Rational>, Integer> drawn_;
};

Comparison opposite(Comparison comparison) {
    switch (comparison) {
        case Comparison::equal:
            return Comparison::unequal;
        case Comparison::unequal:
            return Comparison::equal;
        case Comparison::less:
            return Comparison::at_least;
        case Comparison::at_most:
            return Comparison::greater;
        case Comparison::greater:
            return Comparison::at_most;
        case Comparison::at_least:
            return Comparison::less;
    }
    return comparison;
}

std::string text_of(const QuadraticNumber& number) {
    const std::string text = to_string(number);
    constexpr std::size_t most = 60;
    if (text.size() <= most) return text;
    return is_rational(number) && number.rational.is_integer()
               ? "a number of " + std::to_string(text.size()) + " digits"
               : "a number of " + std::to_string(text.size()) + " characters";
}

}  // namespace

std::string to_string(Comparison comparison) {
    static constexpr std::array texts = {"=", "!=", "<", "<=", ">", ">="};
    return texts.at(static_cast<std::size_t>(comparison));
}

Answer judge_numbers(const ComparesNumbers& said, const Budget& budget) {
    if (!said.numbers.empty()) return undecided("it speaks of numbers that are not bound");
    Terms terms(said, budget);
    return decided(terms.holds({}),
                   steps::ComparedNumbers{said, text_of(terms.value(said.left, {})),
                                          text_of(terms.value(said.right, {}))});
}

namespace {

// --- Conditions on numbers ---

/// What the bound numbers are of free ones, by conditions such as k < n and n >= 1; nothing if a condition says something
/// else. Free numbers have the names of those that they belong to.
std::optional<std::map<std::string, Linear>> moved_by(const Quantified& said) {
    std::map<std::string, Linear> least;  // what each number is at least, by its name
    for (const QuantifiedName& name : said.bindings) least[name.name];
    for (const Statement& condition : said.conditions) {
        const auto* compared = std::get_if<ComparesNumbers>(&condition.says);
        if (!compared || condition.negated || !compared->systems.empty()) return std::nullopt;
        const bool to_right =
            compared->comparison == Comparison::less || compared->comparison == Comparison::at_most;
        const bool to_left = compared->comparison == Comparison::greater ||
                             compared->comparison == Comparison::at_least;
        if (!to_right && !to_left) return std::nullopt;
        const Expression &smaller = to_right ? compared->left : compared->right,
                         &larger = to_right ? compared->right : compared->left;
        auto bound = linear(smaller);
        if (larger.kind != Expression::Kind::name || least.count(larger.name) == 0 || !bound ||
            !bound->constant.is_integer())
            return std::nullopt;
        for (const auto& [name, slope] : bound->slopes)
            if (!slope.is_integer() || slope < 0 || least.count(name) == 0) return std::nullopt;
        if (compared->comparison == Comparison::less || compared->comparison == Comparison::greater)
            bound->constant += Rational(1);
        Linear& now = least.at(larger.name);
        if (now.slopes.empty() && bound->slopes.empty()) {
            now.constant = std::max(now.constant, bound->constant);
        } else if (now.slopes.empty() && now.constant.is_zero() && bound->constant >= 0) {
            now = *bound;
        } else {
            return std::nullopt;  // two bounds of one number
        }
    }
    std::map<std::string, Linear> moved;
    while (moved.size() < least.size()) {
        bool more = false;
        for (const auto& [name, bound] : least) {
            const bool is_known =
                std::all_of(bound.slopes.begin(), bound.slopes.end(),
                            [&](const auto& one) { return moved.count(one.first) > 0; });
            if (moved.count(name) || !is_known) continue;
            Linear made{{{name, Rational(1)}}, bound.constant};
            for (const auto& [other, slope] : bound.slopes) made.add(moved.at(other), slope);
            moved[name] = made;
            more = true;
        }
        if (!more) return std::nullopt;  // a circle
    }
    return moved;
}

/// Calls `use` with all points whose numbers add up to `total`, the first names counting up slowest, until it says false,
/// which is then the result.
template <class Use>
bool each_point(const std::vector<std::string>& names, std::uint64_t total, Use use) {
    Point point;
    const auto choose = [&](auto& self, std::size_t i, std::uint64_t left) -> bool {
        if (i + 1 == names.size()) {
            point[names[i]] = Integer(left);
            return use(point);
        }
        for (std::uint64_t n = 0; n <= left; ++n) {
            point[names[i]] = Integer(n);
            if (!self(self, i + 1, left - n)) return false;
        }
        return true;
    };
    return choose(choose, 0, total);
}

}  // namespace

std::optional<std::uint64_t> least_value(const Quantified& said) {
    const auto moved = moved_by(said);
    if (!moved || moved->size() != 1) return std::nullopt;
    return moved->begin()->second.constant.numerator().to_uint64();
}

namespace {

// --- Inequalities ---

/// The shortest recurrence of a sequence, by all its terms: u(n + r) = a_0 u(n) + ... + a_{r-1} u(n+r-1) (Berlekamp 1968,
/// Massey 1969).
std::vector<Rational> shortest_recurrence(const std::vector<Rational>& terms) {
    std::vector<Rational> now, before;  // u(n) = now[0] u(n-1) + now[1] u(n-2) + ...
    Rational failed_by;
    std::size_t failed_at = 0;
    for (std::size_t n = 0; n < terms.size(); ++n) {
        Rational off = terms[n];
        for (std::size_t i = 0; i < now.size(); ++i) off -= now[i] * terms[n - 1 - i];
        if (off.is_zero()) continue;
        if (failed_by.is_zero()) {
            now.assign(n + 1, Rational(0));
        } else {
            std::vector<Rational> next(n - failed_at - 1, Rational(0));
            next.push_back(off / failed_by);
            for (const Rational& one : before) next.push_back(-one * off / failed_by);
            if (next.size() < now.size()) next.resize(now.size());
            for (std::size_t i = 0; i < now.size(); ++i) next[i] += now[i];
            if (static_cast<std::int64_t>(n) - static_cast<std::int64_t>(now.size()) <=
                static_cast<std::int64_t>(failed_at) - static_cast<std::int64_t>(before.size())) {
                now = std::move(next);
                continue;
            }
            before = std::exchange(now, std::move(next));
            failed_by = off;
            failed_at = n;
            continue;
        }
        before.clear();
        failed_by = off;
        failed_at = n;
    }
    return {now.rbegin(), now.rend()};
}

/// The polynomial x^r - a_{r-1} x^{r-1} - ... - a_0 of a recurrence, at x.
Rational characteristic(const std::vector<Rational>& recurrence, const Rational& x) {
    Rational value(1);
    for (auto each = recurrence.rbegin(); each != recurrence.rend(); ++each)
        value = value * x - *each;
    return value;
}

/// The recurrence without a root of its polynomial.
std::vector<Rational> divided(const std::vector<Rational>& recurrence, const Rational& root) {
    std::vector<Rational> made(recurrence.size() - 1);
    Rational value(1);
    for (std::size_t i = recurrence.size(); i-- > 1;) {
        value = value * root - recurrence[i];
        made[i - 1] = -value;
    }
    return made;
}

/// Why the terms behind the first ones are never negative, or always positive, where these fulfil the comparison; nothing if no
/// such reason is found.
std::optional<steps::StaysPositive> stays_positive(const std::vector<Rational>& terms,
                                                   std::uint64_t order, bool strictly) {
    constexpr long largest_root = 100;
    constexpr std::size_t latest = 50;
    for (std::size_t from = 0; from + 2 * order < terms.size() && from < latest; ++from) {
        std::vector<Rational> now(terms.begin() + static_cast<std::ptrdiff_t>(from), terms.end());
        std::vector<Rational> recurrence = shortest_recurrence(now);
        steps::StaysPositive found;
        found.from = from;
        found.strictly = strictly;
        const auto is_fine = [&] {
            const bool is_first = strictly && found.roots.empty();
            const auto is_zero = [](const Rational& one) { return one.is_zero(); };
            return std::all_of(recurrence.begin(), recurrence.end(),
                               [](const Rational& one) { return one >= 0; }) &&
                   std::all_of(
                       now.begin(), now.begin() + static_cast<std::ptrdiff_t>(recurrence.size()),
                       [&](const Rational& one) { return sign(one) >= (is_first ? 1 : 0); }) &&
                   !(is_first && std::all_of(recurrence.begin(), recurrence.end(), is_zero));
        };
        bool goes_on = true;
        while (goes_on && !is_fine()) {
            goes_on = false;
            const bool is_first = strictly && found.roots.empty();
            if (recurrence.empty() || sign(now.front()) < (is_first ? 1 : 0)) break;
            for (long root = is_first ? 1 : 0; root <= largest_root && !goes_on; ++root) {
                if (!characteristic(recurrence, Rational(root)).is_zero()) continue;
                recurrence = divided(recurrence, Rational(root));
                for (std::size_t i = 0; i + 1 < now.size(); ++i)
                    now[i] = now[i + 1] - Rational(root) * now[i];
                now.pop_back();
                found.roots.emplace_back(root);
                goes_on = true;
            }
        }
        if (!is_fine()) continue;
        found.recurrence = recurrence;
        return found;
    }
    return std::nullopt;
}

/// The search for a point where the comparison fails, and the proof that there is none.
class NumbersJudge {
public:
    NumbersJudge(const Quantified& said, const ComparesNumbers& compared,
                 std::map<std::string, Linear> moved, const Budget& budget)
        : said_(said),
          compared_(compared),
          moved_(std::move(moved)),
          budget_(budget),
          terms_(compared, budget) {
        for (const QuantifiedName& name : said.bindings) names_.push_back(name.name);
    }

    /// The first point where it fails; otherwise a proof that there is none, or how far there is none.
    struct Found {
        std::optional<Point> point;
        std::optional<Answer> proof;
    };
    Found judge() {
        std::uint64_t points = 1, total = 0;
        std::vector<std::pair<std::string, std::uint64_t>> orders;
        Point corner;
        for (const std::string& name : names_) {
            const std::uint64_t order = std::max<std::uint64_t>(
                order_of(compared_.left, name) + order_of(compared_.right, name), 1);
            orders.emplace_back(name, order);
            points *= order;
            if (points > most_points)
                throw BoundReached(Bound::method, "it would take more than " +
                                                      std::to_string(most_points) +
                                                      " values of the numbers");
            corner[name] = Integer(order - 1);
        }
        const bool is_equation = compared_.comparison == Comparison::equal;
        for (const std::string& name : names_) total += at(name, corner);
        if (!is_equation)
            total = names_.size() == 1 ? std::max<std::uint64_t>(2 * total + 60, 200) : 60;
        for (std::uint64_t sum = 0; sum <= total; ++sum) {
            Found found;
            each_point(names_, sum, [&](const Point& point) {
                budget_.check();
                if (!meets(point) || terms_.holds(point)) return true;
                found.point = point;
                return false;
            });
            if (found.point) return found;
        }
        if (is_equation) return {{}, proved(steps::ByRecurrences{std::move(orders), points})};
        if (names_.size() == 1)
            if (auto proof = by_positive_terms(orders.front().second))
                return {{}, std::move(proof)};
        return {{},
                undecided("Nothing else is found for numbers that add up to at most " +
                          std::to_string(total) + ".")};
    }

private:
    std::uint64_t order_of(const Expression& term, const std::string& name) {
        if (term.kind == Expression::Kind::number && term.value.is_zero()) return 0;
        return std::max<std::uint64_t>(terms_.order(term, name, moved_), 1);
    }

    /// The value of a bound number where the free numbers are these.
    std::uint64_t at(const std::string& name, const Point& point) const {
        Rational value = moved_.at(name).constant;
        for (const auto& [other, slope] : moved_.at(name).slopes)
            value += slope * Rational(point.at(other));
        return value.numerator().to_uint64();
    }

    bool meets(const Point& point) const {
        for (const Statement& condition : said_.conditions)
            if (!Terms(std::get<ComparesNumbers>(condition.says), budget_).holds(point))
                return false;
        return true;
    }

    std::optional<Answer> by_positive_terms(std::uint64_t order) {
        constexpr std::uint64_t highest = 60;
        if (order > highest) return std::nullopt;
        using enum Comparison;
        const Comparison is = compared_.comparison;
        const std::uint64_t first = moved_.at(names_[0]).constant.numerator().to_uint64();
        std::vector<Rational> terms;
        for (std::uint64_t n = 0; n < 2 * order + 60; ++n) {
            budget_.check();
            const QuadraticNumber value = terms_.difference({{names_[0], Integer(first + n)}});
            if (!is_rational(value)) return std::nullopt;
            terms.push_back(value.rational);
        }
        for (const bool left_is_larger : {true, false}) {
            if (left_is_larger ? is == less || is == at_most : is == greater || is == at_least)
                continue;
            std::vector<Rational> signed_terms = terms;
            if (!left_is_larger)
                for (Rational& term : signed_terms) term = -term;
            auto found =
                stays_positive(signed_terms, order, is == less || is == greater || is == unequal);
            if (!found) continue;
            found->order = order;
            found->left_is_larger = left_is_larger;
            return proved(std::move(*found));
        }
        return std::nullopt;
    }

    const Quantified& said_;
    const ComparesNumbers& compared_;
    std::map<std::string, Linear> moved_;
    const Budget& budget_;
    Terms terms_;
    std::vector<std::string> names_;
};

}  // namespace

Answer by_values(const Quantified& said, const std::map<std::string, Integer>& point,
                 const Claim& claim, const Budget& budget) {
    steps::ByInstance step;
    step.universal = said.universal;
    for (std::size_t i = 0; i < said.bindings.size(); ++i) {
        const QuantifiedName& name = said.bindings[i];
        const Integer& value = point.at(name.name);
        step.values.push_back({said.first + i, name.name, {}, value});
        step.size += value.to_uint64();
    }
    for (const Statement& condition : said.conditions)
        step.conditions.push_back(
            decide_part(with_values(condition, step.values), claim, budget, {}));
    step.statement = with_values(said.body.front(), step.values);
    step.body = decide_part(step.statement, claim, budget, {});
    step.searched.witness = true;
    const Searched searched = step.searched;
    Answer found = decided(!said.universal, std::move(step));
    found.searched = searched;
    return found;
}

std::optional<Answer> judge_all_numbers(const Quantified& said, const Claim& claim,
                                        const Budget& budget) {
    const auto is_free = [](const QuantifiedName& name) {
        return name.domain.kind == Domain::Kind::number && !name.domain.max_number &&
               !name.domain.max_size;
    };
    const Statement& body = said.body.front();
    const auto* compared = std::get_if<ComparesNumbers>(&body.says);
    if (!compared || !std::all_of(said.bindings.begin(), said.bindings.end(), is_free) ||
        compared->numbers.size() > said.bindings.size())
        return std::nullopt;
    for (const BoundName& name : compared->numbers)  // of a quantifier around this one
        if (name.number < said.first) return std::nullopt;
    auto moved = moved_by(said);
    if (!moved) return std::nullopt;
    // That it holds for some numbers is that its opposite does not hold for all.
    ComparesNumbers for_all = *compared;
    if (body.negated == said.universal) for_all.comparison = opposite(for_all.comparison);
    NumbersJudge::Found found = NumbersJudge(said, for_all, std::move(*moved), budget).judge();
    if (found.point) return by_values(said, *found.point, claim, budget);
    return said.universal ? found.proof : opposite(std::move(*found.proof));
}

}  // namespace algae
