#include <algorithm>
#include <cmath>
#include <numbers>

#include "dimension/detail/ratio_graph.hpp"
#include "dimension/detail/recurrent_set.hpp"

// The similarity dimension for unequal ratios: the s for which the matrix of the sums of (|ratio| /
// m)^s has the spectral radius 1 (Moran 1946 for one state; Mauldin and Williams 1988), with m the
// factor by which whole figures grow.
//
// Ratios are expressions of constants such as 0.21^0.5, which are not algebraic in general
// (0.3^0.7). So nothing here is decided exactly; everything is an enclosure in ball arithmetic, at
// a precision that grows until it suffices.
//
// `WayGrowth` encloses m, the spectral radius of a matrix of complex numbers, by Gelfand's formula:
// with powers P of the matrix, |trace P| / size <= m^power <= |P|, and repeated squaring brings
// both together. Turns must come back, so the product of the matrices over a period is taken. Ways
// could grow by another law (two equal factors one after the other give a factor n, and what grows
// most may cancel); this is looked at in doubles, over the generations 400 to 860.
//
// `RatioSum` finds s by bisection. The spectral radius falls as s grows, and it is below 1 exactly
// if Gaussian elimination in the unit matrix less the matrix meets positive pivots only (a property
// of M-matrices). The middle of an interval may be the solution itself, which no precision decides;
// so a second point is tried.

namespace algae {

namespace {

bool is_number(const Expression& expression, const Rational& value) {
    return rational_value(expression) == value;
}

Ball power_of(const Expression& constant, const Ball& base, long bits) {
    const auto exponent = rational_value(constant.operands[1]);
    if (exponent && exponent->is_integer() && exponent->numerator().fits_int64()) {
        // Of negative numbers too, where logarithms do not exist.
        std::int64_t left = exponent->numerator().to_int64();
        const bool inverse = left < 0;
        if (inverse) left = -left;
        Ball result(1, bits), square = base;
        for (; left != 0; left >>= 1) {
            if (left & 1) result *= square;
            if (left > 1) square *= square;
        }
        return inverse ? Ball(1, bits) / result : result;
    }
    return power(base, enclosure(constant.operands[1], bits));
}

/// The product of two expressions without names, shortened.
Expression times(const Expression& left, const Expression& right) {
    Expression found;
    found.kind = Expression::Kind::binary;
    found.name = "*";
    found.operands = {left, right};
    return shortened(std::move(found));
}

}  // namespace

std::optional<Rational> rational_value(const Expression& expression) {
    if (expression.kind == Expression::Kind::number) return expression.value;
    if (expression.kind == Expression::Kind::name || reads_words(expression)) return std::nullopt;
    return evaluate(expression, {}).exact;
}

Expression shortened(Expression expression) {
    using Kind = Expression::Kind;
    if (expression.kind == Kind::number) return expression;
    for (Expression& operand : expression.operands) operand = shortened(std::move(operand));
    if (const auto exact = rational_value(expression)) return quantity(*exact).expression;
    if (expression.kind != Kind::binary) return expression;
    const Expression &left = expression.operands[0], &right = expression.operands[1];
    if (expression.name == "*" && is_number(left, 1)) return right;
    if ((expression.name == "*" || expression.name == "/") && is_number(right, 1)) return left;
    return expression;
}

Ball enclosure(const Expression& constant, long bits) {
    if (const auto exact = rational_value(constant)) return Ball(*exact, bits);
    const auto operand = [&](std::size_t k) { return enclosure(constant.operands[k], bits); };
    const std::string& name = constant.name;
    if (constant.kind == Expression::Kind::unary && name == "-") return -operand(0);
    if (constant.kind == Expression::Kind::binary) {
        if (name == "+") return operand(0) + operand(1);
        if (name == "-") return operand(0) - operand(1);
        if (name == "*") return operand(0) * operand(1);
        if (name == "/") return operand(0) / operand(1);
        if (name == "^") return power_of(constant, operand(0), bits);
    }
    if (constant.kind == Expression::Kind::call) {
        if (name == "sqrt") return sqrt(operand(0));
        if (name == "exp") return exp(operand(0));
        if (name == "log") return log(operand(0));
        if (name == "abs") return abs(operand(0));
        const auto degrees = rational_value(constant.operands[0]);
        if (degrees && (name == "sin" || name == "cos" || name == "tan")) {
            const Rational part = *degrees / Rational(180);
            if (name == "sin") return sin_pi(part, bits);
            if (name == "cos") return cos_pi(part, bits);
            return sin_pi(part, bits) / cos_pi(part, bits);
        }
        const Ball half_turn(180, bits);
        if (name == "atan") return atan(operand(0)) * half_turn / pi(bits);
        if (name == "asin") return asin(operand(0)) * half_turn / pi(bits);
        if (name == "acos") return acos(operand(0)) * half_turn / pi(bits);
    }
    throw Error("no exact value of '" + to_text(constant) + "' is known");
}

namespace {

constexpr std::size_t most_levels = 1000;
using Matrix = std::vector<std::vector<ComplexBall>>;

Matrix product(const Matrix& left, const Matrix& right) {
    Matrix out = left;
    for (std::size_t i = 0; i < left.size(); ++i)
        for (std::size_t j = 0; j < left.size(); ++j) {
            ComplexBall sum = left[i][0] * right[0][j];
            for (std::size_t k = 1; k < left.size(); ++k) sum = sum + left[i][k] * right[k][j];
            out[i][j] = std::move(sum);
        }
    return out;
}

Ball larger(const Ball& left, const Ball& right) {
    switch (compare(left, right)) {
        case Order::less:
            return right;
        case Order::unknown:
            return hull(left, right);
        default:
            return left;
    }
}

/// Not below the spectral radius, and multiplied by no more than it is for a product: the largest
/// sum of a row, sizes of numbers being |x| + |y|.
Ball norm(const Matrix& matrix) {
    std::optional<Ball> largest;
    for (const auto& row : matrix) {
        Ball sum = abs(row[0].real) + abs(row[0].imaginary);
        for (std::size_t j = 1; j < row.size(); ++j)
            sum += abs(row[j].real) + abs(row[j].imaginary);
        largest = largest ? larger(*largest, sum) : sum;
    }
    return *largest;
}

/// Not above the size of the trace.
Ball trace(const Matrix& matrix) {
    ComplexBall sum = matrix[0][0];
    for (std::size_t i = 1; i < matrix.size(); ++i) sum = sum + matrix[i][i];
    return larger(abs(sum.real), abs(sum.imaginary));
}

}  // namespace

ComplexBall direction(const Rotation& turn, const Expression& angle, long bits) {
    const Rational half_turns = turn.degrees / Rational(180);
    const ComplexBall exact{cos_pi(half_turns, bits), sin_pi(half_turns, bits)};
    if (turn.angles == 0) return exact;
    const Ball radians =
        enclosure(angle, bits) * pi(bits) * Ball(turn.angles, bits) / Ball(180, bits);
    return exact * ComplexBall{cos(radians), sin(radians)};
}

std::vector<const RatioGraph::Part*> stem(const RatioGraph::State& state) {
    std::vector<const RatioGraph::Part*> found;
    std::size_t depth = 0;
    for (const RatioGraph::Part& part : state.parts) {
        if (part.is_fence)
            part.opens ? ++depth : --depth;
        else if (depth == 0)
            found.push_back(&part);
    }
    return found;
}

std::vector<bool> moving_for_ever(const RatioGraph& graph) {
    std::vector<std::vector<std::size_t>> stems;
    std::vector<bool> moves;
    for (const RatioGraph::State& state : graph.states) {
        auto& parts = stems.emplace_back();
        for (const RatioGraph::Part* part : stem(state)) parts.push_back(part->state);
        moves.push_back(state.moves);
    }
    return lasting(stems, moves);
}

WayGrowth::WayGrowth(const RatioGraph& graph, const Budget& budget)
    : angle_(graph.angle), budget_(budget) {
    const std::vector<bool> moving = moving_for_ever(graph);
    std::vector<std::size_t> row(graph.states.size());
    for (std::size_t k = 0; k < graph.states.size(); ++k) {
        if (!moving[k]) continue;
        row[k] = size_++;
        moves_.push_back(graph.states[k].moves);
    }
    if (size_ == 0) throw Error("the turtle does not move in late generations");
    if (size_ > most_moving)
        throw BoundReached(Bound::method,
                           "more than " + std::to_string(most_moving) + " kinds of modules move");

    // The turns of each level until they come back.
    std::vector<Rotation> turns;
    for (const auto& state : graph.states) turns.push_back(state.turn);
    std::map<std::vector<Rotation>, std::size_t> seen;
    while (seen.emplace(turns, levels_.size()).second) {
        if (levels_.size() == most_levels)
            throw BoundReached(Bound::method, "turns do not come back within " +
                                                  std::to_string(most_levels) + " generations");
        budget.check();
        auto& level = levels_.emplace_back();
        std::vector<Rotation> next;
        for (std::size_t k = 0; k < graph.states.size(); ++k) {
            Rotation heading;
            for (const RatioGraph::Part* part : stem(graph.states[k])) {
                if (moving[k] && moving[part->state])
                    level.push_back({row[k], row[part->state], part->ratio, heading});
                heading = heading + turns[part->state];
            }
            next.push_back(heading);
        }
        turns = std::move(next);
    }
    preperiod_ = seen.at(turns);
    period_ = levels_.size() - preperiod_;
    check_evenness();
}

Ball WayGrowth::enclosure(long bits) const {
    for (long precision = 3 * bits + 200;; precision *= 2) {
        if (precision > 20 * (bits + 200))
            throw Error(
                "the ways from the beginnings of figures to their ends do not grow by one factor");
        Matrix power;
        for (std::size_t phase = 0; phase < period_; ++phase) {
            Matrix level(size_,
                         std::vector<ComplexBall>(size_, {Ball(0, precision), Ball(0, precision)}));
            for (const Entry& entry : levels_[preperiod_ + phase]) {
                const Ball ratio = algae::enclosure(entry.ratio, precision);
                const ComplexBall turn = direction(entry.turn, angle_, precision);
                ComplexBall& sum = level[entry.row][entry.column];
                sum = sum + ComplexBall{ratio * turn.real, ratio * turn.imaginary};
            }
            power = phase == 0 ? level : product(level, power);
        }
        if (norm(power).contains(Rational(0)))
            throw Error("the turtle always comes back to where it began");
        Ball exponent(static_cast<std::int64_t>(period_), precision);
        if (size_ == 1) {
            const auto& [x, y] = power[0][0];
            return exp(log(x * x + y * y) / (exponent * Ball(2, precision)));
        }
        // Factors equally large may be multiplied by roots of unity, of orders that 60 times a
        // power of 2 mostly takes away.
        Matrix base = power;
        for (int k = 1; k < 60; ++k) power = product(power, base);
        exponent *= Ball(60, precision);
        for (long squarings = 0; squarings < bits + 40; ++squarings) {
            budget_.check();
            const Ball above = log(norm(power)) / exponent;
            const Ball below =
                log(trace(power) / Ball(static_cast<std::int64_t>(size_), precision)) / exponent;
            const Ball growth = exp(hull(below, above));
            if (growth.is_finite() && growth.has_radius_below(-bits)) return growth;
            power = product(power, power);
            exponent *= Ball(2, precision);
        }
    }
}

/// Ways must grow like powers of the factor: not more, as where two equal factors work one after
/// the other, and not less, as where that which grows most has no part in them.
void WayGrowth::check_evenness() const {
    constexpr std::size_t first = 400, second = 800, window = 60;
    std::vector<std::complex<double>> ways;
    for (const bool moves : moves_) ways.emplace_back(moves ? 1 : 0);
    std::vector<std::vector<std::complex<double>>> factors;
    for (const auto& level : levels_) {
        auto& of_level = factors.emplace_back();
        for (const Entry& entry : level) {
            const ComplexBall turn = direction(entry.turn, angle_, 64);
            of_level.push_back(std::complex(turn.real.midpoint(), turn.imaginary.midpoint()) *
                               algae::enclosure(entry.ratio, 64).midpoint());
        }
    }
    double scale = 0, at_first = -INFINITY, at_second = -INFINITY;
    for (std::size_t n = 0; n < second + window; ++n) {
        double largest = 0;
        for (const auto& way : ways) largest = std::max(largest, std::abs(way));
        if (largest == 0) throw Error("the turtle always comes back to where it began");
        scale += std::log(largest);
        for (auto& way : ways) way /= largest;
        if (n >= first && n < first + window) at_first = std::max(at_first, scale);
        if (n >= second) at_second = std::max(at_second, scale);
        const std::size_t level = n < preperiod_ ? n : preperiod_ + (n - preperiod_) % period_;
        std::vector<std::complex<double>> next(size_, 0);
        for (std::size_t k = 0; k < levels_[level].size(); ++k)
            next[levels_[level][k].row] += factors[level][k] * ways[levels_[level][k].column];
        ways = std::move(next);
    }
    const double expected =
        static_cast<double>(second - first) * std::log(enclosure(32).midpoint());
    if (std::abs(at_second - at_first - expected) > 0.3)
        throw Error(
            "the ways from the beginnings of figures to their ends do not grow by one factor");
}

namespace {

constexpr std::size_t most_terms = 12;
constexpr long largest_dimension = 64;

/// The logarithms of the ratios over m, and what they say of the spectral radius.
class Ratios {
public:
    Ratios(std::size_t states, const std::vector<RatioSum::Entry>& entries, const WayGrowth* growth,
           long precision)
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

RatioSum::RatioSum(std::size_t states, std::vector<Entry> entries,
                   std::shared_ptr<const WayGrowth> growth)
    : states_(states), entries_(std::move(entries)), growth_(std::move(growth)) {
    const Ratios ratios(states_, entries_, growth_.get(), 192);
    if (ratios.radius(Rational(largest_dimension)) != Order::less)
        throw Error("parts do not become smaller than the whole");
}

Components RatioSum::components(std::size_t states, const std::vector<Entry>& entries,
                                const Budget& budget) {
    IntegerMatrix matrix(states, states);
    for (const Entry& entry : entries) matrix(entry.from, entry.to) += Integer(1);
    return algae::components(growth_matrix(matrix), budget);
}

std::vector<RatioSum::Entry> RatioSum::within(const Component& component,
                                              const std::vector<Entry>& entries) {
    const auto& letters = component.letters;
    const auto place = [&](std::size_t state) {
        return static_cast<std::size_t>(std::find(letters.begin(), letters.end(), state) -
                                        letters.begin());
    };
    std::vector<Entry> found;
    for (const Entry& entry : entries)
        if (place(entry.from) < letters.size() && place(entry.to) < letters.size())
            found.push_back({place(entry.from), place(entry.to), entry.ratio});
    return found;
}

Ball RatioSum::enclosure(long bits) const {
    Rational low = 0, high = largest_dimension;
    const Rational width = power(Rational(2), -bits);
    for (long precision = bits + 64;; precision *= 2) {
        if (precision > 64 * (bits + 64))
            throw BoundReached(Bound::digits, "the dimension needs too many digits");
        const Ratios ratios(states_, entries_, growth_.get(), precision);
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
        growth_ ? significant_decimal([&](long bits) { return growth_->enclosure(bits); }, 6) : "";
    const auto ways = returns(states_, entries_);
    std::vector<std::string> terms;
    std::map<std::string, std::size_t> counts;
    if (ways) {
        const bool all_at_once =
            !growth_ || std::all_of(ways->begin(), ways->end(),
                                    [](const Return& way) { return way.generations == 1; });
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
            const std::string text = joined(terms, " + ", [&](const std::string& term) {
                const std::string count = std::to_string(counts[term]);
                return term == "1^s" ? count : counts[term] > 1 ? count + "*" + term : term;
            });
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
