#include "notation/expression_builder.hpp"

#include <algorithm>
#include <utility>

#include "notation/characters.hpp"
#include "notation/suggestion.hpp"

namespace algae {

namespace {

SyntaxError too_deep(const char* where) {
    return {where, "an expression with more than " +
                       std::to_string(ExpressionBuilder::most_levels) +
                       " operators inside each other"};
}

}  // namespace

void ExpressionBuilder::push(Expression expression, std::size_t levels, const char* where) {
    if (levels > most_levels) throw too_deep(where);
    operands_.push_back(std::move(expression));
    levels_.push_back(levels);
}

Expression ExpressionBuilder::pop() {
    Expression top = std::move(operands_.back());
    operands_.pop_back();
    levels_.pop_back();
    return top;
}

void ExpressionBuilder::number(std::string_view text) {
    constexpr std::size_t longest = 1000;
    if (text.size() > longest)
        throw SyntaxError{text.data(),
                          "a number of more than " + std::to_string(longest) + " characters"};
    Expression out;
    try {
        out.value = Rational(text);
    } catch (const Error&) {
        throw SyntaxError{text.data(), "the number " + quoted(text) + " is out of range"};
    }
    out.place = source_.place(text.data());
    push(std::move(out), 0, text.data());
}

void ExpressionBuilder::name(std::string_view text) {
    Expression out;
    out.kind = Expression::Kind::name;
    out.name = text;
    out.place = source_.place(text.data());
    push(std::move(out), 0, text.data());
}

void ExpressionBuilder::word(Expression quoted) {
    const char* const where = source_.text().data() + source_.offset(quoted.place);
    push(std::move(quoted), 0, where);
}

void ExpressionBuilder::prefix(std::string_view text) {
    if (pending_.size() > most_levels + most_brackets) throw too_deep(text.data());
    pending_.push_back({Kind::prefix, std::string(text), Binding::prefix, text.data(), 0});
}

void ExpressionBuilder::infix(std::string_view name, Binding binding, const char* where) {
    // Only ^ groups to the right: a pending ^ waits for its right side.
    const int least = static_cast<int>(binding) + (binding == Binding::power ? 1 : 0);
    reduce_to(static_cast<Binding>(least));
    pending_.push_back({Kind::infix, std::string(name), binding, where, 0});
}

void ExpressionBuilder::open(Pending pending) {
    if (++open_ > most_brackets)
        throw SyntaxError{pending.where, "more than " + std::to_string(most_brackets) +
                                             " brackets inside each other"};
    pending_.push_back(std::move(pending));
}

void ExpressionBuilder::open_call(std::string_view function) {
    if (!function_arity(function) && std::ranges::count(systems_, function) == 0) {
        std::vector<std::string> known = function_names();
        known.insert(known.end(), systems_.begin(), systems_.end());
        throw SyntaxError{function.data(),
                          (systems_.empty() ? "expected a function, found "
                                            : "expected a function or a system, found ") +
                              quoted(function) + did_you_mean(function, known)};
    }
    open({Kind::call, std::string(function), Binding::disjunction, function.data(),
          operands_.size()});
}

bool ExpressionBuilder::is_inside_call() const {
    const auto innermost =
        std::find_if(pending_.rbegin(), pending_.rend(), [](const Pending& pending) {
            return pending.kind == Kind::bracket || pending.kind == Kind::call;
        });
    return innermost != pending_.rend() && innermost->kind == Kind::call;
}

void ExpressionBuilder::comma() { reduce_to_bracket(); }

void ExpressionBuilder::reduce() {
    Pending top = std::move(pending_.back());
    pending_.pop_back();
    const bool is_infix = top.kind == Kind::infix;
    std::size_t levels = levels_.back();
    Expression out;
    out.kind = is_infix ? Expression::Kind::binary : Expression::Kind::unary;
    out.name = std::move(top.name);
    Expression right = pop();
    if (is_infix) {
        levels = std::max(levels, levels_.back());
        out.operands.push_back(pop());
        out.place = out.operands.front().place;
    } else {
        out.place = source_.place(top.where);
    }
    out.operands.push_back(std::move(right));
    push(std::move(out), levels + 1, top.where);
}

void ExpressionBuilder::reduce_to(Binding least) {
    while (!pending_.empty()) {
        const Pending& top = pending_.back();
        if (top.kind == Kind::bracket || top.kind == Kind::call || top.binding < least) return;
        if (top.binding == Binding::relation && least == Binding::relation)
            throw SyntaxError{top.where, "relations do not chain: write 'a < b & b < c'"};
        reduce();
    }
}

void ExpressionBuilder::reduce_to_bracket() {
    while (!pending_.empty() && pending_.back().kind != Kind::bracket &&
           pending_.back().kind != Kind::call)
        reduce();
}

void ExpressionBuilder::close(const char* where) {
    reduce_to_bracket();
    Pending top = std::move(pending_.back());
    pending_.pop_back();
    --open_;
    if (top.kind == Kind::bracket) return;
    const std::size_t given = operands_.size() - top.operands;
    const Arity arity = function_arity(top.name).value_or(Arity{1, false});
    if (given < arity.least || (given > arity.least && !arity.or_more))
        throw SyntaxError{where, "expected " + std::to_string(arity.least) +
                                     (arity.or_more ? " or more" : "") + " argument" +
                                     (arity.least == 1 ? "" : "s") + " of " + top.name +
                                     ", found " + std::to_string(given)};
    Expression out;
    out.kind = Expression::Kind::call;
    out.name = std::move(top.name);
    out.place = source_.place(top.where);
    std::size_t levels = 0;
    out.operands.resize(given);
    for (std::size_t i = given; i-- > 0;) {
        levels = std::max(levels, levels_.back());
        out.operands[i] = pop();
    }
    if (is_distance(out)) check_distance(out);
    push(std::move(out), levels + 1, where);
}

void ExpressionBuilder::check_distance(const Expression& distance) const {
    const Expression &axis = distance.operands.at(0), &symbol = distance.operands.at(1);
    const auto refuse = [&](const std::string& wanted, const Expression& found) {
        throw SyntaxError{source_.text().data() + source_.offset(found.place),
                          "expected " + wanted + ", found " + quoted(to_text(found))};
    };
    if (axis.kind != Expression::Kind::name || axis.name.size() != 1 ||
        std::string_view("XYZ").find(axis.name) == std::string_view::npos)
        refuse("an axis, X, Y or Z", axis);
    if (symbol.kind != Expression::Kind::name) refuse("a symbol", symbol);
}

Expression ExpressionBuilder::finish() {
    reduce_to_bracket();
    return pop();
}

}  // namespace algae
