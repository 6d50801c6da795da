#pragma once
// What the grammars share. It includes Spirit X3 and is included by the grammars' .cpp files only.

#include <algorithm>
#include <boost/spirit/home/x3.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "notation/detail/expression_grammar.hpp"

namespace algae::grammar {

namespace x3 = boost::spirit::x3;

inline std::string_view between(const char* first, const char* last) {
    return {first, static_cast<std::size_t>(last - first)};
}

inline std::string_view text_of(const boost::iterator_range<const char*>& range) {
    return between(range.begin(), range.end());
}

inline bool is_one_of(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Skips what is white space within a line.
struct Blank : x3::parser<Blank> {
    using attribute_type = x3::unused_type;
    static constexpr bool has_attribute = false;

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context&, RuleContext&,
               Attribute&) const {
        if (first == last) return false;
        const Character next = first_character(between(first, last));
        if (!is_blank(next.code)) return false;
        first += next.bytes;
        return true;
    }
};
inline constexpr Blank blank;

/// What a function reads, which moves its first argument on: the grammar of expressions is compiled apart. If it
/// returns a bool, that says whether it matches.
template <class Function>
struct ByHand : x3::parser<ByHand<Function>> {
    using attribute_type = x3::unused_type;
    static constexpr bool has_attribute = false;

    explicit ByHand(Function read) : function(std::move(read)) {}

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context& context, RuleContext&,
               Attribute&) const {
        x3::skip_over(first, last, context);
        if constexpr (std::is_void_v<std::invoke_result_t<Function, const char*&, const char*>>) {
            function(first, last);
            return true;
        } else {
            return function(first, last);
        }
    }

    Function function;
};

/// A parameter's or constant's name: a letter or `_`, then letters, digits and `_`.
struct Name : x3::parser<Name> {
    using attribute_type = x3::unused_type;
    static constexpr bool has_attribute = false;

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context& context, RuleContext&,
               Attribute&) const {
        x3::skip_over(first, last, context);
        const char* here = first;
        while (here != last) {
            const Character next = first_character(between(here, last));
            const bool fits =
                is_letter(next.code) || next.code == '_' || (here != first && is_digit(next.code));
            if (!fits) break;
            here += next.bytes;
        }
        if (here == first) return false;
        first = here;
        return true;
    }
};
inline constexpr Name name;

/// An action that is told the text which `raw` matched.
template <class Tell>
auto told(Tell tell) {
    return [tell = std::move(tell)](auto& context) { tell(text_of(x3::_attr(context))); };
}

/// An action that sets a value.
template <class Value, class New>
auto sets(Value& value, New to) {
    return [&value, to = std::move(to)](auto&) { value = to; };
}

/// Where the next token begins; and told to a variable.
inline const auto here = x3::raw[x3::eps];
inline auto place(const char*& to) {
    return here[told([&to](std::string_view at) { to = at.data(); })];
}

/// What a function `read(first, last)` reads, which moves its first argument on, into a variable.
template <class Value, class Read>
auto into(Value& to, Read read) {
    return ByHand([&to, read](const char*& first, const char* last) { to = read(first, last); });
}

inline const auto digits = x3::raw[x3::lexeme[+x3::char_('0', '9')]];

/// What stands up to the next blank.
inline const auto piece = x3::raw[x3::lexeme[+(x3::char_ - blank)]];

/// A name in claims: an ASCII letter, then letters, digits, `_` and `'`.
inline const auto behind_letter = x3::ascii::alnum | x3::char_("_'");
inline const auto claim_name = x3::raw[x3::lexeme[x3::ascii::alpha >> *behind_letter]];

/// A name that is this one.
inline auto word(const char* text) { return x3::lexeme[x3::lit(text) >> !behind_letter]; }

/// A symbol, by the lexicon: the word grammars are fed their alphabet by hand.
struct SymbolParser : x3::parser<SymbolParser> {
    using attribute_type = Symbol;
    static constexpr bool has_attribute = true;

    explicit SymbolParser(Lexicon& known) : lexicon(&known) {}

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context& context, RuleContext&,
               Attribute& attribute) const {
        x3::skip_over(first, last, context);
        std::string_view rest = between(first, last);
        const auto symbol = lexicon->next(rest);
        if (!symbol) return false;
        first = rest.data();
        x3::traits::move_to(Symbol{*symbol}, attribute);
        return true;
    }

    Lexicon* lexicon;
};

/// `wanted("a number")[parser]`: where the parser does not match, the text is wrong, and the error
/// says what was expected.
template <class Subject>
struct Wanted : x3::unary_parser<Subject, Wanted<Subject>> {
    using base_type = x3::unary_parser<Subject, Wanted<Subject>>;
    static constexpr bool is_pass_through_unary = true;

    Wanted(const Subject& inner, const char* what) : base_type(inner), expectation(what) {}

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context& context,
               RuleContext& rule_context, Attribute& attribute) const {
        x3::skip_over(first, last, context);
        const char* const where = first;
        if (this->subject.parse(first, last, context, rule_context, attribute)) return true;
        throw unexpected(expectation, where);
    }

    const char* expectation;
};

struct wanted {
    const char* expectation;

    explicit wanted(const char* what) : expectation(what) {}

    template <class Subject>
    auto operator[](const Subject& inner) const {
        using Value = typename x3::extension::as_parser<Subject>::value_type;
        return Wanted<Value>(x3::as_parser(inner), expectation);
    }
};

/// Reads the text from `first` on by the grammar, with blanks between its tokens, and moves `first` behind it;
/// false if it does not match.
template <class Grammar>
bool read(const char*& first, const char* last, const Grammar& grammar) {
    return x3::phrase_parse(first, last, grammar, blank);
}

/// The same of the whole text; throws that `rest` was expected where it goes on behind the grammar.
template <class Grammar>
bool read_all(std::string_view text, const Grammar& grammar, const char* rest) {
    const char* first = text.data();
    const char* const last = first + text.size();
    const bool matches = read(first, last, grammar);
    if (matches && first != last) throw unexpected(rest, first);
    return matches;
}

}  // namespace algae::grammar
