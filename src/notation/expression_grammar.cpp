#include "notation/expression_grammar.hpp"

#include <utility>

#include "notation/expression_builder.hpp"
#include "notation/grammar.hpp"
#include "notation/word_grammar.hpp"

namespace algae {

namespace {

namespace x3 = grammar::x3;
using grammar::between;
using grammar::wanted;

struct Operator {
    const char* name;
    Binding binding;
};

struct Operators : x3::symbols<Operator> {
    Operators() {
        add("|", {"|", Binding::disjunction})("||", {"|", Binding::disjunction});
        add("&", {"&", Binding::conjunction})("&&", {"&", Binding::conjunction});
        add("<", {"<", Binding::relation})("<=", {"<=", Binding::relation});
        add(">", {">", Binding::relation})(">=", {">=", Binding::relation});
        add("=", {"=", Binding::relation})("==", {"=", Binding::relation});
        add("!=", {"!=", Binding::relation})("≠", {"!=", Binding::relation});
        add("≤", {"<=", Binding::relation})("≥", {">=", Binding::relation});
        add("+", {"+", Binding::sum})("-", {"-", Binding::sum});
        add("*", {"*", Binding::product})("/", {"/", Binding::product});
        add("^", {"^", Binding::power});
    }
};
const Operators operators;

const auto digits = +x3::char_('0', '9');
const auto number = x3::lexeme[((digits >> -('.' >> digits)) | ('.' >> digits)) >>
                               -(x3::char_("eE") >> -x3::char_("+-") >> digits)];

std::string_view text_of(const boost::iterator_range<const char*>& range) {
    return between(range.begin(), range.end());
}

/// A word in quotes, where there is a lexicon to read it by.
struct QuotedWord : x3::parser<QuotedWord> {
    using attribute_type = Expression;
    static constexpr bool has_attribute = true;

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

}  // namespace

// A flat grammar: what may follow what. The builder keeps the nesting.
Expression parse_expression(const char*& here, const char* end, const Source& source,
                            Lexicon* lexicon, std::size_t quotes) {
    static const std::vector<std::string> no_systems;
    ExpressionBuilder builder(source, lexicon ? lexicon->systems() : no_systems);
    std::string_view function;
    Operator infix{};
    const auto on_number = [&](auto& c) { builder.number(text_of(x3::_attr(c))); };
    const auto on_name = [&](auto& c) { builder.name(text_of(x3::_attr(c))); };
    const auto on_word = [&](auto& c) { builder.word(std::move(x3::_attr(c))); };
    const auto on_prefix = [&](auto& c) { builder.prefix(text_of(x3::_attr(c))); };
    const auto on_open = [&](auto& c) { builder.open_bracket(text_of(x3::_attr(c)).data()); };
    const auto on_function = [&](auto& c) { function = text_of(x3::_attr(c)); };
    const auto on_call = [&](auto&) { builder.open_call(function); };
    const auto on_close = [&](auto& c) { builder.close(text_of(x3::_attr(c)).data()); };
    const auto on_comma = [&](auto&) { builder.comma(); };
    const auto on_operator = [&](auto& c) { infix = x3::_attr(c); };
    const auto on_infix = [&](auto& c) {
        builder.infix(infix.name, infix.binding, text_of(x3::_attr(c)).data());
    };
    const auto inside_brackets = [&](auto& c) { x3::_pass(c) = builder.is_inside_brackets(); };
    const auto inside_call = [&](auto& c) { x3::_pass(c) = builder.is_inside_call(); };

    const auto prefix = x3::raw[x3::char_("-!")][on_prefix] | x3::raw[x3::lit('(')][on_open] |
                        (x3::raw[grammar::name][on_function] >> x3::lit('(')[on_call]);
    const auto operand = x3::raw[number][on_number] | x3::raw[grammar::name][on_name] |
                         QuotedWord{{}, lexicon, &source, quotes}[on_word];
    const auto close = x3::eps[inside_brackets] >> x3::raw[x3::lit(')')][on_close];
    const auto separator = x3::raw[operators[on_operator]][on_infix] |
                           (x3::eps[inside_call] >> x3::lit(',')[on_comma]);
    const auto expression =
        (*prefix >> wanted("a number or a name")[operand] >> *close) % separator;

    x3::phrase_parse(here, end, expression, grammar::blank);
    if (builder.is_inside_call()) throw unexpected("an operator, ',' or ')'", here);
    if (builder.is_inside_brackets()) throw unexpected("an operator or ')'", here);
    return builder.finish();
}

Expression parse_expression(std::string_view text, const Source& source) {
    const char* here = text.data();
    const char* const end = here + text.size();
    Expression expression = parse_expression(here, end, source);
    if (here != end) throw unexpected("an operator", here);
    return expression;
}

std::vector<Expression> parse_arguments(const char*& here, const char* end, const Source& source,
                                        Lexicon* lexicon, std::size_t quotes) {
    std::vector<Expression> arguments;
    do {
        ++here;  // the bracket or the comma
        arguments.push_back(parse_expression(here, end, source, lexicon, quotes));
    } while (here != end && *here == ',');
    if (here == end || *here != ')') throw unexpected("an operator, ',' or ')'", here);
    ++here;
    return arguments;
}

}  // namespace algae
