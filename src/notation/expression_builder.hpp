#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "notation/findings.hpp"
#include "notation/source.hpp"
#include "system/expression.hpp"

namespace algae {

/// How tightly the operators of an expression bind, loosest first.
enum class Binding { disjunction, conjunction, relation, sum, product, prefix, power };

/// Puts an expression together from its tokens, given from left to right: Dijkstra's shunting yard.
/// It keeps its own stack, so no nesting can exhaust the program's. All throw `SyntaxError`.
class ExpressionBuilder {
public:
    static constexpr std::size_t most_brackets = 200;
    static constexpr std::size_t most_levels = 500;

    /// `systems` are names that are called as functions of one number.
    ExpressionBuilder(const Source& source, const std::vector<std::string>& systems)
        : source_(source), systems_(systems) {}

    void number(std::string_view text);
    void name(std::string_view text);
    void word(Expression quoted);
    void prefix(std::string_view text);
    void infix(std::string_view name, Binding binding, const char* where);
    void open_bracket(const char* where) {
        open({Kind::bracket, {}, Binding::disjunction, where, 0});
    }
    void open_call(std::string_view function);
    void comma();
    void close(const char* where);

    bool is_inside_brackets() const { return open_ > 0; }
    bool is_inside_call() const;
    Expression finish();

private:
    enum class Kind { prefix, infix, bracket, call };
    struct Pending {
        Kind kind;
        std::string name;
        Binding binding;
        const char* where;
        std::size_t operands;  // of a call: how many stood before it
    };
    void open(Pending pending);
    void push(Expression expression, std::size_t levels, const char* where);
    void reduce();                  // the pending operator at the top
    void reduce_to(Binding least);  // all pending operators that bind at least so tightly
    void reduce_to_bracket();
    Expression pop();
    void check_distance(const Expression& distance) const;

    const Source& source_;
    const std::vector<std::string>& systems_;
    std::vector<Pending> pending_;
    std::vector<Expression> operands_;
    std::vector<std::size_t> levels_;  // how deep each operand is
    std::size_t open_ = 0;
};

}  // namespace algae
