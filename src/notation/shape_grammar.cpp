#include "notation/shape_grammar.hpp"

#include <algorithm>
#include <utility>

#include "notation/expression_grammar.hpp"
#include "notation/grammar.hpp"
#include "notation/rule_grammar.hpp"

namespace algae {

namespace {

namespace x3 = grammar::x3;
using grammar::between;
using grammar::wanted;

/// A size: an expression, `r` behind it if it is relative.
struct Size : x3::parser<Size> {
    using attribute_type = x3::unused_type;
    static constexpr bool has_attribute = false;

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context&, RuleContext&,
               Attribute&) const {
        ShapeSuccessor::Size size{parse_expression(first, last, *source), false};
        if (first != last && *first == 'r') {
            size.relative = true;
            ++first;
        }
        sizes->push_back(std::move(size));
        return true;
    }

    std::vector<ShapeSuccessor::Size>* sizes;
    const Source* source;
};

/// Throws unless each axis has its sizes, and repeat one axis with one size.
void check_sizes(const ShapeSuccessor& shape, const std::vector<std::size_t>& lists, const char* start,
                 const char* axes) {
    for (std::size_t i = 0; i < shape.axis.size(); ++i)
        if (shape.axis.find(shape.axis[i]) != i)
            throw SyntaxError{axes, "expected different axes, found '" + shape.axis + "'"};
    if (shape.operation == "repeat" && shape.sizes.size() != 1)
        throw SyntaxError{start, "expected one size of repeat, found " + std::to_string(shape.sizes.size())};
    if (shape.operation == "repeat" && shape.axis.size() != 1)
        throw SyntaxError{axes, "expected one axis of repeat, found '" + shape.axis + "'"};
    if (shape.axis.size() == 1 && lists.size() > 1)
        throw SyntaxError{start, "expected sizes for one axis, found " + std::to_string(lists.size()) +
                                     " lists with ':' between"};
    if (shape.axis.size() != lists.size())
        throw SyntaxError{start, "expected sizes for each of " + std::to_string(shape.axis.size()) +
                                     " axes, with ':' between, found " + std::to_string(lists.size())};
}

ShapeSuccessor parse_division(std::string_view text, Reading& reading) {
    const char* here = text.data();
    const char* const end = here + text.size();
    const char* axes = here;
    std::vector<std::size_t> lists;  // how many sizes there are up to the end of each list
    ShapeSuccessor shape;
    const auto on_operation = [&](auto& c) {
        shape.operation.assign(x3::_attr(c).begin(), x3::_attr(c).end());
        if (shape.operation == "Split") shape.operation = "div";
    };
    const auto on_axes = [&](auto& c) {
        axes = x3::_attr(c).begin();
        shape.axis.assign(axes, x3::_attr(c).end());
    };
    const auto on_list = [&](auto&) { lists.push_back(shape.sizes.size()); };
    const auto on_part = [&](auto& c) { shape.parts.push_back(x3::_attr(c)); };

    const auto operation = x3::raw[x3::lit("div") | "repeat" | "Split"][on_operation];
    const auto axis =
        wanted("an axis, X, Y or Z")[x3::raw[x3::lexeme[+x3::char_("XYZ")]][on_axes]];
    const auto size = Size{{}, &shape.sizes, &reading.source};
    const auto list = (size % ',') >> x3::eps[on_list];
    const auto sizes = wanted("',' and a size")[x3::lit(',')] >> (list % ':') >>
                       wanted("',' or ')'")[x3::lit(')')];
    const auto part = (grammar::SymbolParser(reading.lexicon) - '}')[on_part];
    const auto parts = wanted("'{' and the parts")[x3::lit('{')] >> wanted("a symbol")[+part] >>
                       wanted("a symbol or '}'")[x3::lit('}')];
    x3::phrase_parse(here, end, operation >> '(' >> axis >> sizes >> parts, grammar::blank);
    if (here != end) throw unexpected("the end of the rule", here);
    check_sizes(shape, lists, text.data(), axes);
    if (lists.size() > 1) {
        const std::string named = std::move(shape.axis);
        shape.axis.clear();
        for (std::size_t i = 0; i < lists.size(); ++i) shape.axis.resize(lists[i], named[i]);
    }
    return shape;
}

}  // namespace

std::optional<ShapeSuccessor> parse_shape(std::string_view text, const Production& production,
                                          Reading& reading) {
    if (text.starts_with("div(") || text.starts_with("repeat(") || text.starts_with("Split("))
        return parse_division(text, reading);
    const std::vector<std::string> sizes = parameters(production);
    if (!text.starts_with("I(") || text.back() != ')' || (!sizes.empty() && sizes.size() != 3)) return {};
    const std::string_view inner = trimmed(text.substr(2, text.size() - 3));
    if (inner.empty() || !is_letter(first_character(inner).code) ||
        reading.lexicon.length(inner) != inner.size() ||
        reading.constants.count(std::string(inner)) || std::ranges::count(sizes, inner))
        return {};
    std::string_view rest = inner;
    return ShapeSuccessor{"I", {}, {}, {*reading.lexicon.next(rest)}};
}

}  // namespace algae
