#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "rewrite/inner_systems.hpp"
#include "rewrite/module_text.hpp"
#include "rewrite/operations.hpp"
#include "rewrite/program.hpp"

namespace algae {

namespace {

using Operation = Program::Operation;

/// Why an operation has no value, in the words of `evaluate`.
std::string reason(Operation operation, double x, double y, const Expression& at) {
    using enum Program::Operation;
    const std::string text = "'" + to_text(at) + "'";
    if (operation == divide && y == 0) return "division by 0 in " + text;
    if (operation == power && x == 0 && y < 0) return "a negative power of 0 in " + text;
    if (operation == power && x < 0 && y != std::floor(y))
        return "a power of a negative number that is not whole in " + text;
    if (operation == sqrt && x < 0) return "the square root of a negative number in " + text;
    if (operation == log && x <= 0)
        return "the logarithm of a number that is not positive in " + text;
    if (operation == asin || operation == acos) return text + " needs a number from -1 to 1";
    if (operation == tan) return text + " has no value";
    return "the value of " + text + " is too large";
}

struct OneValue {
    double* top;  // one past the topmost number
    template <Operation operation>
    double one() const {
        return unary<operation>(top[-1]);
    }
    template <Operation operation>
    double two() const {
        return binary<operation>(top[-2], top[-1]);
    }
};

constexpr bool is_unary(Operation operation) {
    return operation >= Operation::negate && operation <= Operation::log;
}

}  // namespace

double Program::run(const double* parameters) const {
    if (systems_) return run_with_words(parameters);
    std::array<double, 16> few;
    std::vector<double> many;
    double* stack = few.data();
    if (depth_ > few.size()) {
        many.resize(depth_);
        stack = many.data();
    }
    double* top = stack;
    for (std::size_t i = 0; i < instructions_.size(); ++i) {
        const Instruction& next = instructions_[i];
        switch (next.operation) {
            case Operation::number:
                *top++ = next.number;
                break;
            case Operation::parameter:
                *top++ = parameters[next.index];
                break;
            case Operation::skip_if_false:
            case Operation::skip_if_true:
                if ((top[-1] != 0) == (next.operation == Operation::skip_if_true)) {
                    top[-1] = top[-1] != 0 ? 1 : 0;
                    i = next.index - 1;
                }
                break;
            default: {
                const double value = dispatch(next.operation, OneValue{top});
                if (!std::isfinite(value)) {
                    const bool one = is_unary(next.operation);
                    throw Undefined{next.at, reason(next.operation, one ? top[-1] : top[-2],
                                                    top[-1], *next.at)};
                }
                if (!is_unary(next.operation)) --top;
                top[-1] = value;
            }
        }
    }
    return top[-1];
}

double Program::run_with_words(const double* parameters) const {
    std::vector<double> stack;
    for (std::size_t i = 0; i < instructions_.size(); ++i) {
        const Instruction& next = instructions_[i];
        const auto check_number = [&](double value) {
            if (WordValues::is_word(value))
                throw Undefined{next.at,
                                "expected numbers in '" + to_text(*next.at) + "', found a word"};
        };
        switch (next.operation) {
            case Operation::number:
                stack.push_back(next.number);
                break;
            case Operation::parameter:
                stack.push_back(parameters[next.index]);
                break;
            case Operation::length:
                if (!WordValues::is_word(stack.back()))
                    throw Undefined{next.at, "expected a word in '" + to_text(*next.at) +
                                                 "', found " + number_text(stack.back())};
                stack.back() =
                    static_cast<double>(systems_->words().word(stack.back()).kinds.size());
                break;
            case Operation::generation:
                check_number(stack.back());
                stack.back() = systems_->word(next.index, stack.back(), *next.at);
                break;
            case Operation::skip_if_false:
            case Operation::skip_if_true:
                check_number(stack.back());
                if ((stack.back() != 0) == (next.operation == Operation::skip_if_true)) {
                    stack.back() = stack.back() != 0 ? 1 : 0;
                    i = next.index - 1;
                }
                break;
            default: {
                const bool one = is_unary(next.operation);
                const double right = stack.back(), left = one ? right : stack[stack.size() - 2];
                check_number(right);
                check_number(left);
                const double value =
                    dispatch(next.operation, OneValue{stack.data() + stack.size()});
                if (!std::isfinite(value))
                    throw Undefined{next.at, reason(next.operation, left, right, *next.at)};
                if (!one) stack.pop_back();
                stack.back() = value;
            }
        }
    }
    return stack.back();
}

namespace {

/// A column of numbers, or one number that stands for a whole column.
struct Operand {
    const double* column;
    double number;
};

/// One operation on whole columns; false if a value is not finite.
struct ManyValues {
    const Operand& left;
    const Operand& right;
    std::size_t count;
    double* out;

    template <class Value>
    bool each(Value value) const {
        bool finite = true;
        for (std::size_t i = 0; i < count; ++i) {
            const double result = value(i);
            out[i] = result;
            finite &= result - result == 0;
        }
        return finite;
    }
    template <Operation operation>
    bool one() const {
        const double* x = right.column;
        return each([x](std::size_t i) { return unary<operation>(x[i]); });
    }
    template <Operation operation>
    bool two() const {
        const double *x = left.column, *y = right.column;
        if (!x && !y)
            return each(
                [this](std::size_t) { return binary<operation>(left.number, right.number); });
        if (!x)
            return each([a = left.number, y](std::size_t i) { return binary<operation>(a, y[i]); });
        if (!y)
            return each(
                [x, b = right.number](std::size_t i) { return binary<operation>(x[i], b); });
        return each([x, y](std::size_t i) { return binary<operation>(x[i], y[i]); });
    }
};

}  // namespace

bool Program::run_many(const std::vector<const double*>& parameters, std::size_t count, double* out,
                       Columns& room) const {
    if (systems_) return false;
    if (room.size() < depth_) room.resize(depth_);
    for (auto& column : room)
        if (column.size() < count) column.resize(count);
    std::vector<Operand> stack;
    stack.reserve(depth_);
    const Operand none{nullptr, 0};
    for (std::size_t i = 0; i < instructions_.size(); ++i) {
        const Instruction& next = instructions_[i];
        switch (next.operation) {
            case Operation::number:
                stack.push_back({nullptr, next.number});
                break;
            case Operation::parameter:
                stack.push_back({parameters[next.index], 0});
                break;
            case Operation::skip_if_false:
            case Operation::skip_if_true:
                break;  // both sides are worked out where all of it has a value
            default: {
                const Operand right = stack.back();
                stack.pop_back();
                Operand left = none;
                if (!is_unary(next.operation)) {
                    left = stack.back();
                    stack.pop_back();
                }
                double* to = i + 1 == instructions_.size() ? out : room[stack.size()].data();
                if (!dispatch(next.operation, ManyValues{left, right, count, to})) return false;
                stack.push_back({to, 0});
            }
        }
    }
    const Operand& value = stack.back();
    if (!value.column)
        std::fill_n(out, count, value.number);
    else if (value.column != out)
        std::copy_n(value.column, count, out);
    return true;
}

}  // namespace algae
