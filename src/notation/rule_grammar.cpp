#include "notation/rule_grammar.hpp"

#include <algorithm>
#include <utility>

#include "notation/expression_grammar.hpp"
#include "notation/grammar.hpp"

namespace algae {

namespace {

namespace x3 = grammar::x3;
using grammar::between;
using grammar::wanted;

/// A condition, up to the end of the text; the grammar of expressions is compiled elsewhere.
struct Condition : x3::parser<Condition> {
    using attribute_type = x3::unused_type;
    static constexpr bool has_attribute = false;

    template <class Context, class RuleContext, class Attribute>
    bool parse(const char*& first, const char* const& last, const Context&, RuleContext&,
               Attribute&) const {
        *condition = parse_expression(first, last, *source, lexicon);
        return true;
    }

    std::optional<Expression>* condition;
    const Source* source;
    Lexicon* lexicon;
};

/// Gathers the modules of one part of a left side, with their places.
struct Modules {
    Pattern pattern;
    std::vector<const char*> places;
};

void check_parameters_differ(const std::vector<std::string_view>& names) {
    constexpr std::size_t most = 1000;
    if (names.size() > most)
        throw SyntaxError{names[most].data(), "more than " + std::to_string(most) + " parameters"};
    std::vector<std::string_view> sorted = names;
    std::stable_sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice == sorted.end()) return;
    throw SyntaxError{std::next(twice)->data(),
                      "the parameter " + quoted(*twice) + " stands twice before the arrow"};
}

}  // namespace

Arrow split_at_arrow(std::string_view rule, const char* arrow) {
    const char* const begin = rule.data();
    const char* const end = begin + rule.size();
    const char* const behind = arrow + (*arrow == '-' ? 2 : 3);  // or the three bytes of →
    Arrow out{trimmed(between(begin, arrow)), {}, trimmed(between(behind, end))};
    if (arrow == begin || arrow[-1] != ')') return out;
    // The bracket that opens before the arrow, with no blank in between.
    const char* open = arrow - 1;
    for (std::size_t depth = 1; depth > 0;) {
        if (open == begin) return out;
        --open;
        if (*open == ')') ++depth;
        if (*open == '(') --depth;
        if (is_blank(static_cast<unsigned char>(*open))) return out;
    }
    if (open == begin || open[-1] != '-') return out;
    const std::string_view before = trimmed(between(begin, open - 1));
    constexpr std::string_view unfinished = "<>?,:=(";
    if (before.empty() || unfinished.find(before.back()) != std::string_view::npos) return out;
    out.left_side = before;
    out.probability = between(open + 1, arrow - 1);
    return out;
}

void parse_left_side(std::string_view text, Lexicon& lexicon, const Source& source,
                     Production& production) {
    const char* here = text.data();
    const char* const end = here + text.size();
    Modules modules, predecessor;
    std::vector<std::string_view> names;

    const auto on_symbol = [&](auto& c) {
        std::string_view symbol{x3::_attr(c).begin(), x3::_attr(c).size()};
        modules.places.push_back(symbol.data());
        modules.pattern.push_back({*lexicon.next(symbol), {}});
    };
    const auto on_name = [&](auto& c) {
        names.emplace_back(x3::_attr(c).begin(), x3::_attr(c).size());
        modules.pattern.back().parameters.emplace_back(names.back());
    };
    const auto on_left = [&](auto&) { production.left = std::exchange(modules, {}).pattern; };
    const auto on_predecessor = [&](auto&) { predecessor = std::exchange(modules, {}); };
    const auto on_right = [&](auto&) { production.right = std::exchange(modules, {}).pattern; };
    const auto on_elsewhere = [&](auto&) {
        production.elsewhere = std::exchange(modules, {}).pattern;
    };

    const auto formal = wanted("a parameter's name")[x3::raw[grammar::name][on_name]];
    const auto formals = '(' >> formal % ',' >> wanted("',' or ')'")[x3::lit(')')];
    const auto module = x3::raw[x3::lexeme[grammar::SymbolParser(lexicon)]][on_symbol] >> -formals;
    const auto word = +(module | "ε");
    const auto predecessor_word = wanted("a symbol before the arrow")[word];
    const auto left_context = x3::lit('<')[on_left] >> predecessor_word;
    const auto right_context = '>' >> wanted("a right context")[word] >> x3::eps[on_right];
    const auto elsewhere = '?' >> wanted("a module")[module] % ',' >> x3::eps[on_elsewhere];
    const auto condition =
        ':' >> ((x3::lit('*') >> x3::eoi) | Condition{{}, &production.condition, &source, &lexicon});
    const auto left_side = predecessor_word >> -left_context >> x3::eps[on_predecessor] >>
                           -right_context >> -elsewhere >> -condition;

    x3::phrase_parse(here, end, left_side, grammar::blank);
    if (predecessor.pattern.size() > 1)
        throw unexpected("'->' or a context after one symbol", predecessor.places[1]);
    if (predecessor.pattern.empty())
        throw SyntaxError{text.data(), "expected a symbol before the arrow, found 'ε'"};
    if (here != end) {
        if (production.condition) throw unexpected("an operator or '->'", here);
        throw unexpected("'->'", here);
    }
    check_parameters_differ(names);
    production.predecessor = std::move(predecessor.pattern.front());
}

std::vector<std::string> parameters(const Production& production) {
    std::vector<std::string> names = production.predecessor.parameters;
    for (const Pattern* pattern : {&production.left, &production.right, &production.elsewhere})
        for (const ModulePattern& module : *pattern)
            names.insert(names.end(), module.parameters.begin(), module.parameters.end());
    return names;
}

}  // namespace algae
