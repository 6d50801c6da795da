#include <algorithm>
#include <cctype>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "notation/detail/expression_grammar.hpp"
#include "notation/detail/grammar.hpp"

// Expressions: numbers, names, words in quotes, operators and calls, `2*x^(n-1)`, `leaf(3)`, `length("F[+F]")`.
//
// The grammar is flat. It says only what may follow what: prefixes and opening brackets, an operand, closing
// brackets, then an operator or a comma. What belongs together is found by Dijkstra's shunting yard
// (`ExpressionBuilder`), which is told the tokens from left to right and keeps its own stack. So no text,
// however deep its brackets, can exhaust the program's stack, and the limits (200 brackets, 500 operators
// inside each other) protect whoever walks the result. Only `^` groups to the right; relations do not chain.
// Which operators there are is a table, `ExpressionDialect`: with their tables the same grammar reads the arithmetic of
// other programs, whose readers say what an operand is.
// Words in quotes are read by words.cpp, which calls back for their arguments. A call of a function that the file makes for itself becomes
// the expression that it stands for (`OwnFunctions`): what reads expressions afterwards needs to know fourteen functions and no more.

namespace algae {

namespace {

namespace x3 = grammar::x3;
using grammar::text_of;
using grammar::wanted;

/// Substitutes expressions for names, counting what it makes.
class Substitution {
public:
    static constexpr std::size_t most = 10'000;

    /// What a name becomes; nullptr where it stays.
    using Replaced = std::function<const Expression*(const std::string& name)>;

    /// Nothing if more than `most` parts would be made.
    std::optional<Expression> of(const Expression& from, const Replaced& replaced) {
        Expression out;
        if (!fill(from, replaced, out)) return std::nullopt;
        return out;
    }
    std::size_t made() const { return made_; }

private:
    bool fill(const Expression& from, const Replaced& replaced, Expression& out) {
        if (++made_ > most) return false;
        if (from.kind == Expression::Kind::name)
            if (const Expression* const other = replaced(from.name))
                return fill(
                    *other, [](const std::string&) { return nullptr; }, out);
        out = {from.kind, from.value, from.name, {}, from.word, from.place};
        out.operands.resize(from.operands.size());
        for (std::size_t i = 0; i < from.operands.size(); ++i)
            if (!fill(from.operands[i], replaced, out.operands[i])) return false;
        return true;
    }

    std::size_t made_ = 0;
};

using Binding = ExpressionDialect::Binding;
using Operator = ExpressionDialect::Operator;
using Powers = ExpressionDialect::Powers;

/// Puts an expression together from its tokens, given from left to right: Dijkstra's shunting yard.
/// It keeps its own stack, so no nesting can exhaust the program's. All throw `SyntaxError`.
class ExpressionBuilder {
public:
    /// `systems` are names that are called as functions of one number; `functions` may be null.
    ExpressionBuilder(const Source& source, const ExpressionDialect& dialect,
                      const std::vector<std::string>& systems, const OwnFunctions* functions)
        : source_(source), dialect_(dialect), systems_(systems), functions_(functions) {}

    /// What becomes of each operator and its operands, if not what they are.
    std::function<Expression(Expression)> made;

    void number(std::string_view text) {
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

    void name(std::string_view text) {
        Expression out;
        out.kind = Expression::Kind::name;
        out.name = text;
        out.place = source_.place(text.data());
        push(std::move(out), 0, text.data());
    }

    /// An operand that was read elsewhere.
    void operand(Expression read, const char* where) { push(std::move(read), 0, where); }

    /// Whether a prefix may stand here: an exponent without brackets takes one sign.
    bool takes(const Operator& prefix) const {
        const bool signed_already = !pending_.empty() && pending_.back().kind == Kind::prefix;
        return !is_exponent() || (!signed_already && *prefix.name);
    }

    void prefix(const Operator& prefix, const char* where) {
        if (pending_.size() > most_levels + most_brackets) throw too_deep(where);
        if (*prefix.name) pending_.push_back({Kind::prefix, prefix.name, prefix.binding, where, 0});
    }

    void infix(const Operator& infix, const char* where) {
        if (infix.binding == Binding::power && is_exponent())
            throw unexpected("brackets that say which power is taken first", where);
        // Where ^ groups to the right, a pending ^ waits for its right side.
        const bool waits =
            infix.binding == Binding::power && dialect_.powers == Powers::to_the_right;
        reduce_to(static_cast<Binding>(static_cast<int>(infix.binding) + (waits ? 1 : 0)));
        pending_.push_back({Kind::infix, infix.name, infix.binding, where, 0});
    }

    void open_bracket(const char* where) {
        open({Kind::bracket, {}, Binding::disjunction, where, 0});
    }
    void open_call(std::string_view function) {
        if (!function_arity(function) && std::ranges::count(systems_, function) == 0 &&
            !own(function)) {
            if (functions_ && functions_->is_broken(function)) throw DependsOnError();
            if (functions_ && functions_->is_being_defined(function))
                throw SyntaxError{function.data(),
                                  quoted(function) + " stands in its own definition"};
            std::vector<std::string> known = function_names();
            known.insert(known.end(), systems_.begin(), systems_.end());
            if (functions_)
                for (std::string& name : functions_->names()) known.push_back(std::move(name));
            throw SyntaxError{function.data(),
                              (systems_.empty() ? "expected a function, found "
                                                : "expected a function or a system, found ") +
                                  quoted(function) + did_you_mean(function, known)};
        }
        open({Kind::call, std::string(function), Binding::disjunction, function.data(),
              operands_.size()});
    }

    void comma() { reduce_to_bracket(); }

    void close(const char* where) {
        reduce_to_bracket();
        Pending top = std::move(pending_.back());
        pending_.pop_back();
        --open_;
        if (top.kind == Kind::bracket) return;
        const std::size_t given = operands_.size() - top.operands;
        const OwnFunctions::Function* const own_function = own(top.name);
        const Arity arity = own_function ? Arity{own_function->parameters.size(), false}
                                         : function_arity(top.name).value_or(Arity{1, false});
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
        if (own_function && !functions_->keeps_calls()) {
            Expression meant = functions_->called(out, top.where);
            levels += depth(own_function->body);
            return push(std::move(meant), levels, where);
        }
        push(std::move(out), levels + 1, where);
    }

    bool is_inside_brackets() const { return open_ > 0; }
    bool is_inside_call() const {
        const auto innermost =
            std::find_if(pending_.rbegin(), pending_.rend(), [](const Pending& pending) {
                return pending.kind == Kind::bracket || pending.kind == Kind::call;
            });
        return innermost != pending_.rend() && innermost->kind == Kind::call;
    }

    Expression finish() {
        reduce_to_bracket();
        return pop();
    }

private:
    static constexpr std::size_t most_brackets = 200;
    static constexpr std::size_t most_levels = 500;

    static SyntaxError too_deep(const char* where) {
        return {where, "an expression with more than " + std::to_string(most_levels) +
                           " operators inside each other"};
    }

    enum class Kind { prefix, infix, bracket, call };
    struct Pending {
        Kind kind;
        std::string name;
        Binding binding;
        const char* where;
        std::size_t operands;  // of a call: how many stood before it
    };
    void open(Pending pending) {
        if (++open_ > most_brackets)
            throw SyntaxError{pending.where, "more than " + std::to_string(most_brackets) +
                                                 " brackets inside each other"};
        pending_.push_back(std::move(pending));
    }

    void push(Expression expression, std::size_t levels, const char* where) {
        if (levels > most_levels) throw too_deep(where);
        operands_.push_back(std::move(expression));
        levels_.push_back(levels);
    }

    /// Whether powers need brackets and what is read now is an exponent, perhaps behind a sign.
    bool is_exponent() const {
        if (dialect_.powers != Powers::in_brackets) return false;
        auto innermost = pending_.rbegin();
        if (innermost != pending_.rend() && innermost->kind == Kind::prefix) ++innermost;
        return innermost != pending_.rend() && innermost->kind == Kind::infix &&
               innermost->binding == Binding::power;
    }

    /// The pending operator at the top.
    void reduce() {
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
        push(made ? made(std::move(out)) : std::move(out), levels + 1, top.where);
    }

    /// All pending operators that bind at least so tightly.
    void reduce_to(Binding least) {
        while (!pending_.empty()) {
            const Pending& top = pending_.back();
            if (top.kind == Kind::bracket || top.kind == Kind::call || top.binding < least) return;
            if (top.binding == Binding::relation && least == Binding::relation)
                throw SyntaxError{top.where, "relations do not chain: write 'a < b & b < c'"};
            reduce();
        }
    }

    void reduce_to_bracket() {
        while (!pending_.empty() && pending_.back().kind != Kind::bracket &&
               pending_.back().kind != Kind::call)
            reduce();
    }

    const OwnFunctions::Function* own(std::string_view name) const {
        return functions_ ? functions_->find(name) : nullptr;
    }

    static std::size_t depth(const Expression& expression) {
        std::size_t deepest = 0;
        for (const Expression& operand : expression.operands)
            deepest = std::max(deepest, depth(operand));
        return deepest + 1;
    }

    Expression pop() {
        Expression top = std::move(operands_.back());
        operands_.pop_back();
        levels_.pop_back();
        return top;
    }

    void check_distance(const Expression& distance) const {
        const Expression &axis = distance.operands.at(0), &symbol = distance.operands.at(1);
        const auto refuse = [&](const std::string& wanted, const Expression& found) {
            throw SyntaxError{source_.text().data() + source_.offset(found.place),
                              "expected " + wanted + ", found " + algae::quoted(to_text(found))};
        };
        if (axis.kind != Expression::Kind::name || axis.name.size() != 1 ||
            std::string_view("XYZ").find(axis.name) == std::string_view::npos)
            refuse("an axis, X, Y or Z", axis);
        if (symbol.kind != Expression::Kind::name) refuse("a symbol", symbol);
    }

    const Source& source_;
    const ExpressionDialect& dialect_;
    const std::vector<std::string>& systems_;
    const OwnFunctions* functions_;
    std::vector<Pending> pending_;
    std::vector<Expression> operands_;
    std::vector<std::size_t> levels_;  // how deep each operand is
    std::size_t open_ = 0;
};

struct Operators : x3::symbols<Operator> {
    explicit Operators(const std::vector<Operator>& all) {
        for (const Operator& one : all) add(one.written, one);
    }
};

const ExpressionDialect own_dialect{{{"|", "|", Binding::disjunction},
                                     {"||", "|", Binding::disjunction},
                                     {"&", "&", Binding::conjunction},
                                     {"&&", "&", Binding::conjunction},
                                     {"<", "<", Binding::relation},
                                     {"<=", "<=", Binding::relation},
                                     {"≤", "<=", Binding::relation},
                                     {">", ">", Binding::relation},
                                     {">=", ">=", Binding::relation},
                                     {"≥", ">=", Binding::relation},
                                     {"=", "=", Binding::relation},
                                     {"==", "=", Binding::relation},
                                     {"!=", "!=", Binding::relation},
                                     {"≠", "!=", Binding::relation},
                                     {"+", "+", Binding::sum},
                                     {"-", "-", Binding::sum},
                                     {"*", "*", Binding::product},
                                     {"/", "/", Binding::product},
                                     {"^", "^", Binding::power}},
                                    {{"-", "-", Binding::prefix}, {"!", "!", Binding::prefix}}};
const Operators own_infixes(own_dialect.infixes), own_prefixes(own_dialect.prefixes);

const auto digits = +x3::char_('0', '9');
const auto number = x3::lexeme[((digits >> -('.' >> digits)) | ('.' >> digits)) >>
                               -(x3::char_("eE") >> -x3::char_("+-") >> digits)];

/// A word in quotes, where there is a lexicon to read it by.
struct QuotedWord : x3::parser<QuotedWord> {
    using attribute_type = Expression;
    [[maybe_unused]] static constexpr bool has_attribute = true;

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context& context, RuleContext&,
               Attribute& attribute) const {
        x3::skip_over(first, last, context);
        if (!lexicon || first == last || *first != '"') return false;
        x3::traits::move_to(parse_quoted(first, last, *lexicon, *source, quotes), attribute);
        return true;
    }

    Lexicon* lexicon;
    const Source* source;
    std::size_t quotes;
};

/// White space and comments as another program's reader knows them.
struct Between : x3::parser<Between> {
    using attribute_type = x3::unused_type;
    [[maybe_unused]] static constexpr bool has_attribute = false;

    explicit Between(const ExpressionReader& of) : reader(&of) {}

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const&, const Context&, RuleContext&,
               Attribute&) const {
        return std::exchange(first, reader->next(first)) != first;
    }

    const ExpressionReader* reader;
};

}  // namespace

Expression read_expression(const char*& here, const char* end, const Source& source,
                           const ExpressionDialect& dialect, const ExpressionReader& reader) {
    static const std::vector<std::string> no_systems;
    ExpressionBuilder builder(source, dialect, no_systems, nullptr);
    builder.made = reader.made;
    const Operators infixes(dialect.infixes), prefixes(dialect.prefixes);
    Operator met{};
    const auto on_operator = [&](auto& c) { met = x3::_attr(c); };
    const auto on_prefix = [&](auto& c) {
        if (!(x3::_pass(c) = builder.takes(met))) return;
        builder.prefix(met, x3::_attr(c).begin());
        reader.met(x3::_attr(c).begin());
    };
    const auto on_infix = [&](auto& c) {
        const char* const behind = x3::_attr(c).end();
        if (dialect.spaced &&
            (behind == end || !std::isspace(static_cast<unsigned char>(*behind)))) {
            x3::_pass(c) = false;
            return;
        }
        builder.infix(met, x3::_attr(c).begin());
        reader.met(x3::_attr(c).begin());
    };
    const grammar::ByHand operand([&](const char*& first, const char*) {
        first = reader.next(first);
        const char* const where = first;
        builder.operand(reader.operand(first), where);
    });
    x3::phrase_parse(here, end,
                     (*x3::raw[prefixes[on_operator]][on_prefix] >> operand) %
                         x3::raw[infixes[on_operator]][on_infix],
                     Between(reader));
    return builder.finish();
}

const OwnFunctions::Function* OwnFunctions::find(std::string_view name) const {
    const auto found = std::ranges::find(all_, name, &Function::name);
    return found == all_.end() ? nullptr : &*found;
}

std::vector<std::string> OwnFunctions::names() const {
    std::vector<std::string> out;
    for (const Function& function : all_) out.push_back(function.name);
    return out;
}

Expression OwnFunctions::called(const Expression& call, const char* where) const {
    constexpr std::size_t most_in_all = 1'000'000;
    const Function& function = *find(call.name);
    Substitution substitution;
    auto made = substitution.of(function.body, [&](const std::string& name) -> const Expression* {
        const auto at = std::ranges::find(function.parameters, name);
        return at == function.parameters.end()
                   ? nullptr
                   : &call.operands[static_cast<std::size_t>(at - function.parameters.begin())];
    });
    made_ += substitution.made();
    if (made && made_ <= most_in_all) return std::move(*made);
    throw SyntaxError{where, "the call of " + quoted(call.name) + " stands for more than " +
                                 (made ? "1,000,000 numbers, names and operators with all before it"
                                       : "10,000 numbers, names and operators")};
}

Expression OwnFunctions::expanded(const Expression& expression, const char* where) const {
    Expression out = expression;
    for (Expression& operand : out.operands) operand = expanded(operand, where);
    return out.kind == Expression::Kind::call && find(out.name) ? called(out, where) : out;
}

namespace {

Expression parse(const char*& here, const char* end, const Source& source, Lexicon* lexicon,
                 const OwnFunctions* functions, std::size_t quotes) {
    static const std::vector<std::string> no_systems;
    ExpressionBuilder builder(source, own_dialect, lexicon ? lexicon->systems() : no_systems,
                              functions);
    std::string_view function;
    Operator met{};
    const auto on_number = [&](auto& c) { builder.number(text_of(x3::_attr(c))); };
    const auto on_name = [&](auto& c) { builder.name(text_of(x3::_attr(c))); };
    const auto on_word = [&](auto& c) {
        const char* const where = source.text().data() + source.offset(x3::_attr(c).place);
        builder.operand(std::move(x3::_attr(c)), where);
    };
    const auto on_operator = [&](auto& c) { met = x3::_attr(c); };
    const auto on_prefix = [&](auto& c) { builder.prefix(met, x3::_attr(c).begin()); };
    const auto on_open = [&](auto& c) { builder.open_bracket(text_of(x3::_attr(c)).data()); };
    const auto on_function = [&](auto& c) { function = text_of(x3::_attr(c)); };
    const auto on_call = [&](auto&) { builder.open_call(function); };
    const auto on_close = [&](auto& c) { builder.close(text_of(x3::_attr(c)).data()); };
    const auto on_comma = [&](auto&) { builder.comma(); };
    const auto on_infix = [&](auto& c) { builder.infix(met, x3::_attr(c).begin()); };
    const auto inside_brackets = [&](auto& c) { x3::_pass(c) = builder.is_inside_brackets(); };
    const auto inside_call = [&](auto& c) { x3::_pass(c) = builder.is_inside_call(); };

    const auto prefix = x3::raw[own_prefixes[on_operator]][on_prefix] |
                        x3::raw[x3::lit('(')][on_open] |
                        (x3::raw[grammar::name][on_function] >> x3::lit('(')[on_call]);
    const auto operand = x3::raw[number][on_number] | x3::raw[grammar::name][on_name] |
                         QuotedWord{{}, lexicon, &source, quotes}[on_word];
    const auto close = x3::eps[inside_brackets] >> x3::raw[x3::lit(')')][on_close];
    const auto separator = x3::raw[own_infixes[on_operator]][on_infix] |
                           (x3::eps[inside_call] >> x3::lit(',')[on_comma]);
    const auto expression =
        (*prefix >> wanted("a number or a name")[operand] >> *close) % separator;

    x3::phrase_parse(here, end, expression, grammar::blank);
    if (builder.is_inside_call()) throw unexpected("an operator, ',' or ')'", here);
    if (builder.is_inside_brackets()) throw unexpected("an operator or ')'", here);
    return builder.finish();
}

template <class Read>
std::vector<Expression> arguments_of(const char*& here, const char* end, Read read) {
    std::vector<Expression> arguments;
    do {
        ++here;  // the bracket or the comma
        arguments.push_back(read());
    } while (here != end && *here == ',');
    if (here == end || *here != ')') throw unexpected("an operator, ',' or ')'", here);
    ++here;
    return arguments;
}

}  // namespace

Expression parse_expression(const char*& here, const char* end, const Source& source,
                            Lexicon* lexicon, std::size_t quotes) {
    return parse(here, end, source, lexicon, lexicon ? lexicon->functions() : nullptr, quotes);
}

Expression parse_expression(const char*& here, const char* end, const Source& source,
                            const OwnFunctions* functions) {
    return parse(here, end, source, nullptr, functions, 0);
}

Expression parse_expression(std::string_view text, const Source& source,
                            const OwnFunctions* functions) {
    const char* here = text.data();
    const char* const end = here + text.size();
    Expression expression = parse_expression(here, end, source, functions);
    if (here != end) throw unexpected("an operator", here);
    return expression;
}

std::vector<Expression> parse_arguments(const char*& here, const char* end, const Source& source,
                                        Lexicon* lexicon, std::size_t quotes) {
    return arguments_of(here, end,
                        [&] { return parse_expression(here, end, source, lexicon, quotes); });
}

std::vector<Expression> parse_arguments(const char*& here, const char* end, const Source& source,
                                        const OwnFunctions* functions) {
    return arguments_of(here, end, [&] { return parse_expression(here, end, source, functions); });
}

}  // namespace algae
