#include "dimension/way_growth.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <optional>

#include "base/error.hpp"
#include "dimension/constant_expression.hpp"
#include "growth/complex_ball.hpp"

namespace algae {

namespace {

constexpr std::size_t most_levels = 1000;

using Matrix = std::vector<std::vector<ComplexBall>>;

Rational normal(const Rational& degrees) {
    return degrees - Rational(360) * Rational(floor(degrees / Rational(360)));
}

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

/// The parts outside branches.
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

/// By state, whether it steps outside branches in every later generation, or leads to one that does.
std::vector<bool> moving_for_ever(const RatioGraph& graph) {
    RatioGraph stems;
    std::vector<bool> moves;
    for (const RatioGraph::State& state : graph.states) {
        auto& copy = stems.states.emplace_back();
        for (const RatioGraph::Part* part : stem(state)) copy.parts.push_back(*part);
        moves.push_back(state.moves);
    }
    return lasting(stems, moves);
}

}  // namespace

WayGrowth::WayGrowth(const RatioGraph& graph, const Budget& budget) : budget_(budget) {
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
    std::vector<Rational> turns;
    for (const auto& state : graph.states) turns.push_back(normal(state.degrees));
    std::map<std::vector<Rational>, std::size_t> seen;
    while (seen.emplace(turns, levels_.size()).second) {
        if (levels_.size() == most_levels)
            throw BoundReached(Bound::method, "turns do not come back within " +
                                                  std::to_string(most_levels) + " generations");
        budget.check();
        auto& level = levels_.emplace_back();
        std::vector<Rational> next;
        for (std::size_t k = 0; k < graph.states.size(); ++k) {
            Rational heading;
            for (const RatioGraph::Part* part : stem(graph.states[k])) {
                if (moving[k] && moving[part->state])
                    level.push_back({row[k], row[part->state], part->ratio, heading});
                heading = normal(heading + turns[part->state]);
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
                const Rational half_turns = entry.degrees / Rational(180);
                ComplexBall& sum = level[entry.row][entry.column];
                sum = sum + ComplexBall{ratio * cos_pi(half_turns, precision),
                                        ratio * sin_pi(half_turns, precision)};
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
        // Factors equally large may be multiplied by roots of unity, of orders that 60 times a power
        // of 2 mostly takes away.
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

/// Ways must grow like powers of the factor: not more, as where two equal factors work one after the
/// other, and not less, as where that which grows most has no part in them.
void WayGrowth::check_evenness() const {
    constexpr std::size_t first = 400, second = 800, window = 60;
    std::vector<std::complex<double>> ways;
    for (const bool moves : moves_) ways.emplace_back(moves ? 1 : 0);
    std::vector<std::vector<std::complex<double>>> factors;
    for (const auto& level : levels_) {
        auto& of_level = factors.emplace_back();
        for (const Entry& entry : level)
            of_level.push_back(std::polar(1.0, entry.degrees.to_double() * std::numbers::pi / 180) *
                               algae::enclosure(entry.ratio, 64).midpoint());
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

}  // namespace algae
