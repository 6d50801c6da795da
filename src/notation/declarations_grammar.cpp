#include <utility>

#include "notation/expression_grammar.hpp"
#include "notation/grammar.hpp"
#include "notation/settings_grammar.hpp"

namespace algae {

namespace {

namespace x3 = grammar::x3;
using grammar::between;
using grammar::wanted;

constexpr std::size_t longest_name = 200;  // reading looks so far ahead for a declared name

}  // namespace

void read_constant(const Clause& clause, Reading& reading) {
    const std::string_view value = clause.value();
    const char* here = value.data();
    const char* const end = here + value.size();
    std::string name;
    const auto on_name = [&](auto& c) { name.assign(x3::_attr(c).begin(), x3::_attr(c).end()); };
    const auto head = wanted("a constant's name")[x3::raw[grammar::name][on_name]];
    x3::phrase_parse(here, end, head, grammar::blank);
    try {
        if (here == end || *here != '=') throw unexpected("'='", here);
        if (reading.constants.count(name))
            throw SyntaxError{value.data(), "the constant " + quoted(name) + " is given twice"};
        Quantity quantity =
            reading.quantity(parse_expression(between(here + 1, end), reading.source));
        reading.constants.emplace(name, reading.system.constants.size());
        reading.system.constants.emplace_back(name, std::move(quantity));
    } catch (...) {
        reading.broken.insert(name);
        throw;
    }
}

void read_alphabet(const Clause& clause, Reading& reading) {
    for (const std::string_view name : pieces(clause.value())) {
        // These open statements that contain arrows, or shape successors: a rule could not be told.
        for (const char* keyword : {"title", "source", "interpret", "div", "repeat"})
            if (name == keyword)
                throw SyntaxError{name.data(), "expected another name, " + quoted(name) +
                                                   " has a meaning in the notation"};
        if (name.size() > longest_name)
            throw SyntaxError{name.data(), "expected names of at most " + std::to_string(longest_name) +
                                               " bytes, found one of " + std::to_string(name.size())};
        const std::size_t first = name.front() == '?' && name.size() > 1 ? 1 : 0;
        for (std::size_t i = first; i < name.size();) {
            const Character next = first_character(name.substr(i));
            if (is_reserved(next.code))
                throw SyntaxError{name.data() + i,
                                  "expected names without " + quoted(name.substr(i, next.bytes))};
            i += next.bytes;
        }
        const Symbol symbol = reading.lexicon.declare(name);
        auto& declared = reading.system.declared;
        if (symbol == declared.size()) declared.push_back(symbol);  // else it is there already
    }
}

}  // namespace algae
