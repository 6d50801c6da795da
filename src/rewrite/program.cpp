#include "rewrite/program.hpp"

#include <algorithm>
#include <utility>

#include "rewrite/inner_systems.hpp"
#include "rewrite/module_text.hpp"
#include "rewrite/operations.hpp"

namespace algae {

namespace {

using Operation = Program::Operation;

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
            add({Operation::number, 0, evaluate(expression, constants_).value, &expression}, 1);
            return;
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
    : systems_(words.systems) {
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

}  // namespace algae
