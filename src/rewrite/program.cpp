#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "rewrite/detail/exact_numbers.hpp"
#include "rewrite/detail/inner_systems.hpp"
#include "rewrite/rewrite.hpp"

// Expressions compiled to programs for a small machine of registers, and their runs, for one module or for columns of many.
//
// Parameters are doubles while a word is derived. A program that runs over columns does one instruction for many modules at a time;
// where a value is not finite (a division by 0, a root of a negative number) the column run only says so, and the one module
// is run again alone, to name the place in the words that `evaluate` uses. Sines and tangents of multiples of 30 degrees are
// exact, as in exact evaluation.

namespace algae {

namespace {

using Operation = Program::Operation;

/// The angle from 0 to below a full or half turn.
double reduced(double degrees, double turn) {
    const double angle = std::fmod(degrees, turn);
    return angle < 0 ? angle + turn : angle;
}

/// The sine of an angle in degrees, exact where it is -1, -1/2, 0, 1/2 or 1.
double sine_of_degrees(double degrees) {
    const double angle = reduced(degrees, 360);
    if (angle == 0 || angle == 180) return 0;
    if (angle == 30 || angle == 150) return 0.5;
    if (angle == 90) return 1;
    if (angle == 210 || angle == 330) return -0.5;
    if (angle == 270) return -1;
    return std::sin(angle * std::numbers::pi / 180);
}

double cosine_of_degrees(double degrees) {
    const double angle = reduced(degrees, 360);
    if (angle == 90 || angle == 270) return 0;
    if (angle == 60 || angle == 300) return 0.5;
    if (angle == 0) return 1;
    if (angle == 120 || angle == 240) return -0.5;
    if (angle == 180) return -1;
    return std::cos(angle * std::numbers::pi / 180);
}

/// Not a number at odd multiples of 90 degrees.
double tangent_of_degrees(double degrees) {
    const double angle = reduced(degrees, 180);
    if (angle == 90) return std::nan("");
    if (angle == 0) return 0;
    if (angle == 45) return 1;
    if (angle == 135) return -1;
    return std::tan(angle * std::numbers::pi / 180);
}

/// The value of an operation with one operand; not finite where there is none.
template <Operation operation>
double unary(double x) {
    using enum Program::Operation;
    if constexpr (operation == negate) return -x;
    if constexpr (operation == invert) return x == 0 ? 1 : 0;
    if constexpr (operation == truth) return x != 0 ? 1 : 0;
    if constexpr (operation == abs) return std::abs(x);
    if constexpr (operation == floor) return std::floor(x);
    if constexpr (operation == ceil) return std::ceil(x);
    if constexpr (operation == sin) return sine_of_degrees(x);
    if constexpr (operation == cos) return cosine_of_degrees(x);
    if constexpr (operation == tan) return tangent_of_degrees(x);
    if constexpr (operation == asin) return std::asin(x) * 180 / std::numbers::pi;
    if constexpr (operation == acos) return std::acos(x) * 180 / std::numbers::pi;
    if constexpr (operation == atan) return std::atan(x) * 180 / std::numbers::pi;
    if constexpr (operation == sqrt) return std::sqrt(x);
    if constexpr (operation == exp) return std::exp(x);
    if constexpr (operation == log) return std::log(x);
}

/// The value of an operation with two operands; not finite where there is none.
template <Operation operation>
double binary(double x, double y) {
    using enum Program::Operation;
    if constexpr (operation == add) return x + y;
    if constexpr (operation == subtract) return x - y;
    if constexpr (operation == multiply) return x * y;
    if constexpr (operation == divide) return x / y;
    if constexpr (operation == power) return std::pow(x, y);
    if constexpr (operation == minimum) return y < x ? y : x;
    if constexpr (operation == maximum) return x < y ? y : x;
    if constexpr (operation == less) return x < y ? 1 : 0;
    if constexpr (operation == less_equal) return x <= y ? 1 : 0;
    if constexpr (operation == greater) return x > y ? 1 : 0;
    if constexpr (operation == greater_equal) return x >= y ? 1 : 0;
    if constexpr (operation == equal) return x == y ? 1 : 0;
    if constexpr (operation == unequal) return x != y ? 1 : 0;
    if constexpr (operation == both) return x != 0 && y != 0 ? 1 : 0;
    if constexpr (operation == either) return x != 0 || y != 0 ? 1 : 0;
}

#define ALGAE_CASE(name, shape)    \
    case Program::Operation::name: \
        return visit.template shape<Program::Operation::name>()

/// visit.one<operation>() or visit.two<operation>(), for an operation on one or two numbers.
template <class Visit>
decltype(auto) dispatch(Program::Operation operation, Visit&& visit) {
    switch (operation) {
        ALGAE_CASE(negate, one);
        ALGAE_CASE(invert, one);
        ALGAE_CASE(truth, one);
        ALGAE_CASE(abs, one);
        ALGAE_CASE(floor, one);
        ALGAE_CASE(ceil, one);
        ALGAE_CASE(sin, one);
        ALGAE_CASE(cos, one);
        ALGAE_CASE(tan, one);
        ALGAE_CASE(asin, one);
        ALGAE_CASE(acos, one);
        ALGAE_CASE(atan, one);
        ALGAE_CASE(sqrt, one);
        ALGAE_CASE(exp, one);
        ALGAE_CASE(log, one);
        ALGAE_CASE(add, two);
        ALGAE_CASE(subtract, two);
        ALGAE_CASE(multiply, two);
        ALGAE_CASE(divide, two);
        ALGAE_CASE(power, two);
        ALGAE_CASE(minimum, two);
        ALGAE_CASE(maximum, two);
        ALGAE_CASE(less, two);
        ALGAE_CASE(less_equal, two);
        ALGAE_CASE(greater, two);
        ALGAE_CASE(greater_equal, two);
        ALGAE_CASE(equal, two);
        ALGAE_CASE(unequal, two);
        ALGAE_CASE(both, two);
        default:
            return visit.template two<Program::Operation::either>();
    }
}

#undef ALGAE_CASE

Operation operation_of(const Expression& expression) {
    using enum Program::Operation;
    static const std::vector<std::pair<std::string, Operation>> binary{
        {"+", add},      {"-", subtract},    {"*", multiply}, {"/", divide},         {"^", power},
        {"<", less},     {"<=", less_equal}, {">", greater},  {">=", greater_equal}, {"=", equal},
        {"!=", unequal}, {"&", both},        {"|", either}};
    static const std::vector<std::pair<std::string, Operation>> called{
        {"abs", abs}, {"floor", floor}, {"ceil", ceil},   {"sin", sin},    {"cos", cos},
        {"tan", tan}, {"asin", asin},   {"acos", acos},   {"atan", atan},  {"sqrt", sqrt},
        {"exp", exp}, {"log", log},     {"min", minimum}, {"max", maximum}};
    if (expression.kind == Expression::Kind::unary) return expression.name == "!" ? invert : negate;
    const auto& table = expression.kind == Expression::Kind::binary ? binary : called;
    return std::find_if(table.begin(), table.end(),
                        [&](const auto& entry) { return entry.first == expression.name; })
        ->second;
}

}  // namespace

bool has_parameters(const Expression& expression, const Program::Numbering& parameters) {
    if (expression.kind == Expression::Kind::name) return parameters(expression.name).has_value();
    if (is_distance(expression)) return false;  // its operands are an axis and a symbol
    return std::any_of(expression.operands.begin(), expression.operands.end(),
                       [&](const Expression& part) { return has_parameters(part, parameters); });
}

std::optional<Rational> exact_value(const Expression& expression, const Names& constants) {
    const std::optional<Rational> value = evaluate(expression, constants).exact;
    if (expression.kind == Expression::Kind::name) {
        const Quantity* const constant = constants(expression.name);
        return constant->expression == expression ? value
                                                  : exact_value(constant->expression, constants);
    }
    if (is_distance(expression)) return value;
    for (const Expression& operand : expression.operands)
        if (!exact_value(operand, constants)) return std::nullopt;
    return value;
}

class Program::Compiler {
public:
    Compiler(Program& program, const Numbering& parameters, const Names& constants,
             const WordsOfPrograms& words)
        : program_(program), parameters_(parameters), constants_(constants), words_(words) {}

    void compile_whole(const Expression& expression) {
        compile(expression);
        if (words_.number) add({Operation::truth, 0, 0, &expression}, 0);
    }

    void compile(const Expression& expression) {
        const bool is_word_or_call =
            expression.kind == Expression::Kind::word || expression.kind == Expression::Kind::call;
        if (reads_words(expression) && is_word_or_call && compile_word(expression)) return;
        if (!has_parameters(expression, parameters_) &&
            !(words_.systems && reads_words(expression))) {
            const double rounded = evaluate(expression, constants_).value;
            const auto value = words_.exact ? exact_value(expression, constants_) : std::nullopt;
            if (!words_.exact || value) {
                const double number = words_.exact ? words_.exact->number({*value, 0, 1}) : rounded;
                add({Operation::number, 0, number, &expression}, 1);
                return;
            }
            if (expression.kind == Expression::Kind::name) {  // of a constant that is not rational
                compile(constants_(expression.name)->expression);
                return;
            }
        }
        if (expression.kind == Expression::Kind::name) {
            const auto index = static_cast<std::uint32_t>(*parameters_(expression.name));
            add({Operation::parameter, index, 0, &expression}, 1);
            return;
        }
        const Operation operation = operation_of(expression);
        if (operation == Operation::both || operation == Operation::either) {
            compile_decided(expression, operation);
            return;
        }
        compile(expression.operands.front());
        if (expression.operands.size() == 1) add({operation, 0, 0, &expression}, 0);
        for (std::size_t i = 1; i < expression.operands.size(); ++i) {
            compile(expression.operands[i]);
            add({operation, 0, 0, &expression}, -1);
        }
    }

private:
    void add(Instruction instruction, int growth) {
        program_.instructions_.push_back(instruction);
        height_ = static_cast<std::size_t>(static_cast<int>(height_) + growth);
        program_.depth_ = std::max(program_.depth_, height_);
    }

    /// False for a function of numbers.
    bool compile_word(const Expression& expression) {
        if (!words_.systems) evaluate(expression, constants_);  // says that it is no number
        if (expression.kind == Expression::Kind::word) {
            add({Operation::number, 0, words_.literal(*expression.word), &expression}, 1);
            return true;
        }
        const auto system = words_.systems->find(expression.name);
        if (!system && expression.name != "length") return false;
        compile(expression.operands.front());
        add({system ? Operation::generation : Operation::length,
             static_cast<std::uint32_t>(system.value_or(0)), 0, &expression},
            0);
        return true;
    }

    void compile_decided(const Expression& expression, Operation operation) {
        const bool both = operation == Operation::both;
        compile(expression.operands[0]);
        const std::size_t skip = program_.instructions_.size();
        add({both ? Operation::skip_if_false : Operation::skip_if_true, 0, 0, &expression}, 0);
        compile(expression.operands[1]);
        add({operation, 0, 0, &expression}, -1);
        program_.instructions_[skip].index =
            static_cast<std::uint32_t>(program_.instructions_.size());
    }

    Program& program_;
    const Numbering& parameters_;
    const Names& constants_;
    const WordsOfPrograms& words_;
    std::size_t height_ = 0;
};

Program::Program(const Expression& expression, const Numbering& parameters, const Names& constants,
                 const WordsOfPrograms& words)
    : systems_(words.systems), exact_(words.exact) {
    Compiler(*this, parameters, constants, words).compile_whole(expression);
}

std::optional<double> Program::constant() const {
    if (instructions_.size() != 1 || instructions_[0].operation != Operation::number)
        return std::nullopt;
    return instructions_[0].number;
}

std::vector<std::size_t> Program::reads() const {
    std::vector<std::size_t> found;
    for (const Instruction& instruction : instructions_)
        if (instruction.operation == Operation::parameter) found.push_back(instruction.index);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

bool Program::operator==(const Program& other) const {
    return std::equal(instructions_.begin(), instructions_.end(), other.instructions_.begin(),
                      other.instructions_.end(), [](const Instruction& a, const Instruction& b) {
                          return a.operation == b.operation && a.index == b.index &&
                                 same_value(a.number, b.number);
                      });
}

std::string reason(Program::Operation operation, double x, double y, const Expression& at) {
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

namespace {

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

}  // namespace

double Program::run(const double* parameters) const {
    if (systems_ || exact_) return run_with_held(parameters);
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

double Program::run_with_held(const double* parameters) const {
    std::array<double, 16> few;
    std::vector<double> many;
    double* stack = few.data();
    if (depth_ > few.size()) {
        many.resize(depth_);
        stack = many.data();
    }
    double* top = stack;  // one past the topmost number
    for (std::size_t i = 0; i < instructions_.size(); ++i) {
        const Instruction& next = instructions_[i];
        const auto text_of = [&](double value) {
            return exact_ ? exact_->text(value) : number_text(value);
        };
        const auto check_number = [&](double value) {
            if (WordValues::is_word(value))
                throw Undefined{next.at,
                                "expected numbers in '" + to_text(*next.at) + "', found a word"};
        };
        switch (next.operation) {
            case Operation::number:
                *top++ = next.number;
                break;
            case Operation::parameter:
                *top++ = parameters[next.index];
                break;
            case Operation::length:
                if (!WordValues::is_word(top[-1]))
                    throw Undefined{next.at, "expected a word in '" + to_text(*next.at) +
                                                 "', found " + text_of(top[-1])};
                top[-1] = static_cast<double>(systems_->words().word(top[-1]).kinds.size());
                break;
            case Operation::generation:
                check_number(top[-1]);
                top[-1] = systems_->word(next.index, top[-1], *next.at);
                break;
            case Operation::skip_if_false:
            case Operation::skip_if_true:
                check_number(top[-1]);
                if ((top[-1] != 0) == (next.operation == Operation::skip_if_true)) {
                    top[-1] = top[-1] != 0 ? 1 : 0;
                    i = next.index - 1;
                }
                break;
            default: {
                const bool one = is_unary(next.operation);
                const double right = top[-1], left = one ? right : top[-2];
                check_number(right);
                check_number(left);
                double value = 0;
                if (exact_) {
                    value = apply_exactly(next.operation, left, right, *exact_, *next.at);
                } else {
                    value = dispatch(next.operation, OneValue{top});
                    if (!std::isfinite(value))
                        throw Undefined{next.at, reason(next.operation, left, right, *next.at)};
                }
                if (!one) --top;
                top[-1] = value;
            }
        }
    }
    return top[-1];
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
    if (systems_ || exact_) return false;
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
