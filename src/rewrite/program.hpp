#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "system/expression.hpp"

namespace algae {

/// An expression that has no value for the parameters at hand: where and why.
struct Undefined {
    const Expression* at;
    std::string reason;  // "division by 0 in 'x/y'"
};

class InnerSystems;

/// What a program needs to know of words, where its system holds some.
struct WordsOfPrograms {
    InnerSystems* systems = nullptr;
    std::function<double(const ModuleWord&)> literal;  // the value of a word in quotes
    bool number = false;                               // whether the program's value must be a number
};

/// An expression over numbered parameters, compiled: a row of instructions for a stack of doubles.
///
/// What has no parameters is worked out once, exactly where `evaluate` can; all else is arithmetic
/// of doubles, one rounding an operation. Angles are in degrees; sines, cosines and tangents of
/// multiples of 30 and 45 degrees that are rational are exact. `&` and `|` do not look at their
/// right side where the left one decides.
///
/// Of parameters that may be words (WordValues) a program makes no arithmetic and no comparison: that
/// is `Undefined`, as is `length` of a number.
class Program {
public:
    /// The number of a parameter, or nothing where the name is no parameter.
    using Numbering = std::function<std::optional<std::size_t>(const std::string&)>;

    /// `expression` must outlive the program. Throws what `evaluate` throws for parts without
    /// parameters.
    /// Without `words` all parameters must be numbers; words in the expression then have no value.
    Program(const Expression& expression, const Numbering& parameters, const Names& constants,
            const WordsOfPrograms& words = {});

    /// The value for these parameters: finite, or a word. Throws `Undefined`.
    double run(const double* parameters) const;

    /// Room for `run_many`, to be used again and again.
    using Columns = std::vector<std::vector<double>>;

    /// The values for `count` rows of parameters, given as columns, into `out`. False if some value
    /// on the way is not finite, or the system holds words; then `out` is of no use and `run` says, row
    /// by row, what holds.
    bool run_many(const std::vector<const double*>& parameters, std::size_t count, double* out,
                  Columns& room) const;

    /// The value, if it depends on no parameter.
    std::optional<double> constant() const;
    /// The numbers of the parameters that it reads, each once, in order.
    std::vector<std::size_t> reads() const;

    /// Whether they compute the same in the same way.
    bool operator==(const Program& other) const;

    enum class Operation : std::uint8_t {
        number,
        parameter,
        negate,
        invert,
        truth,
        abs,
        floor,
        ceil,
        sin,
        cos,
        tan,
        asin,
        acos,
        atan,
        sqrt,
        exp,
        log,
        add,
        subtract,
        multiply,
        divide,
        power,
        minimum,
        maximum,
        less,
        less_equal,
        greater,
        greater_equal,
        equal,
        unequal,
        both,
        either,
        skip_if_false,
        skip_if_true,
        length,
        generation
    };

private:
    struct Instruction {
        Operation operation;
        std::uint32_t index = 0;  // of a parameter or a system; where to go on after a skip
        double number = 0;
        const Expression* at = nullptr;
    };

    class Compiler;
    double run_with_words(const double* parameters) const;

    InnerSystems* systems_ = nullptr;  // where parameters may be words
    std::vector<Instruction> instructions_;
    std::size_t depth_ = 0;  // of the stack
};

/// Whether the expression reads one of the names that `parameters` knows.
bool has_parameters(const Expression& expression, const Program::Numbering& parameters);

}  // namespace algae
