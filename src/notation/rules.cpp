#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/model.hpp"
#include "notation/detail/blank_byte.hpp"
#include "notation/detail/grammar.hpp"
#include "notation/detail/reading.hpp"

// Rules: `L < a(x) > R : x > 0 -(1/2)-> b(x-1)c` and those of shapes.
//
// A rule is split at its first arrow, before anything is parsed, because what stands on its two sides is cut
// into symbols differently: on the left are patterns with formal parameters, an optional context on either
// side, an optional `? modules` elsewhere and an optional condition; on the right is a word whose arguments
// are expressions, or a shape successor. The probability stands in the arrow, `-(p)->`, and `-(a)` may also
// be a module, so what stands before it decides.
//
// A `|` between blanks on the right separates successors, as in textbooks: `a -> a | aa` is two rules, which
// share what stands left of the arrow. A `|` that has no blank on some side is the letter `|`, a turn, and so
// is each in a file whose `alphabet` has longer names, as words are written with blanks there. The canonical
// text has a rule for each successor, and `|` between blanks only in such files.
//
// The probabilities of all rules with the same left side must add up to 1. Two left sides are the same if
// they have the same symbols and arities at the same places and the same condition up to the names of
// parameters, which is compared as a text in which parameters are numbers (`LeftSide`).

namespace algae {

namespace {

namespace x3 = grammar::x3;
using grammar::between;
using grammar::text_of;
using grammar::wanted;

/// The arrow of a rule: what stands before it, in it and behind it.
struct Arrow {
    std::string_view left_side;
    std::string_view probability;  // of `-(p)->`; empty for `->`
    std::string_view right_side;
};

/// The names of all formal parameters of a production.
std::vector<std::string> parameters(const Production& production) {
    std::vector<std::string> names = production.predecessor.parameters;
    for (const Pattern* pattern : {&production.left, &production.right, &production.elsewhere})
        for (const ModulePattern& module : *pattern)
            names.insert(names.end(), module.parameters.begin(), module.parameters.end());
    return names;
}

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

/// Splits a rule at its first arrow. `-(a)` where something must still come is no beginning of an
/// arrow but a module or a number: `-(a)-> b` has the predecessor -(a).
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
        if (is_blank_byte(*open)) return out;
    }
    if (open == begin || open[-1] != '-') return out;
    const std::string_view before = trimmed(between(begin, open - 1));
    constexpr std::string_view unfinished = "<>?,:=(";
    if (before.empty() || unfinished.find(before.back()) != std::string_view::npos) return out;
    out.left_side = before;
    out.probability = between(open + 1, arrow - 1);
    return out;
}

/// Where the bracket at `open`, an opening one, is closed; `end` if nowhere. Those in quotes do not count.
const char* closing(const char* open, const char* end) {
    std::size_t depth = 0;
    bool quoted = false;
    for (const char* here = open; here != end; ++here) {
        if (*here == '"') quoted = !quoted;
        if (quoted) continue;
        if (*here == '(') ++depth;
        if (*here == ')' && --depth == 0) return here;
    }
    return end;
}

/// Where a part of a successor that is no letter ends, a shape successor, arguments or a splice, which
/// begins at `here`; `here` if none does. `begins`: only blanks stand before it.
const char* behind_part(const char* here, const char* end, bool begins) {
    const std::string_view rest = between(here, end);
    if (begins)
        for (const std::string_view shape : {"div(", "repeat(", "Split("})
            if (rest.starts_with(shape)) {
                const char* const close = closing(here + shape.size() - 1, end);
                return std::find(close, end, '}');
            }
    if (*here == '(') return closing(here, end);
    if (*here != '<') return here;
    bool quoted = false;
    while (++here != end && (quoted || *here != '>')) {
        if (*here == '"') quoted = !quoted;
        if (*here == '(' && !quoted) here = std::min(closing(here, end), end - 1);
    }
    return here;
}

}  // namespace

std::vector<std::string_view> separate_successors(std::string_view text) {
    std::vector<std::string_view> found;
    if (text.find('|') == std::string_view::npos) return {text};
    const char* const end = text.data() + text.size();
    const char* begin = text.data();  // of this successor
    bool begins = true, behind_blank = true;
    std::size_t depth = 0;  // of brackets in the word
    for (const char* here = begin; here != end;) {
        if (const char* const behind = behind_part(here, end, begins); behind != here) {
            here = behind == end ? end : behind + 1;
            begins = behind_blank = false;
            continue;
        }
        const Character next = first_character(between(here, end));
        const bool blank = is_blank(next.code);
        const bool is_bar =
            next.code == '|' && behind_blank &&
            (here + 1 == end || is_blank(first_character(between(here + 1, end)).code));
        if (next.code == '[' || next.code == '{') ++depth;
        if ((next.code == ']' || next.code == '}') && depth > 0) --depth;
        if (is_bar && text.size() > 1) {
            if (depth > 0)
                throw SyntaxError{
                    here,
                    "expected '|' between successors outside brackets; as a letter it "
                    "is written without blanks"};
            found.push_back(trimmed(between(begin, here)));
            begin = here + 1;
        }
        begins = is_bar || (begins && blank);
        behind_blank = is_bar || blank;
        here += next.bytes;
    }
    found.push_back(trimmed(between(begin, end)));
    return found;
}

std::size_t successor_count(const Clause& clause, bool spaced) {
    if (spaced || !clause.arrow) return 1;
    return separate_successors(split_at_arrow(clause.text, clause.arrow).right_side).size();
}

namespace {

/// What stands before the arrow: contexts, predecessor, context condition and condition, into a
/// production. Throws `SyntaxError`.
void parse_left_side(std::string_view text, Lexicon& lexicon, const Source& source,
                     Production& production) {
    const char* here = text.data();
    const char* const end = here + text.size();
    Modules modules, predecessor;
    std::vector<std::string_view> names;

    const auto on_symbol = [&](auto& c) {
        std::string_view symbol = text_of(x3::_attr(c));
        modules.places.push_back(symbol.data());
        modules.pattern.push_back({*lexicon.next(symbol), {}});
    };
    const auto on_name = [&](auto& c) {
        names.push_back(text_of(x3::_attr(c)));
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
    const auto expression = grammar::ByHand([&](const char*& first, const char* last) {
        production.condition = parse_expression(first, last, source, &lexicon);
    });
    const auto condition = ':' >> ((x3::lit('*') >> x3::eoi) | expression);
    const auto left_side = predecessor_word >> -left_context >> x3::eps[on_predecessor] >>
                           -right_context >> -elsewhere >> -condition;

    x3::phrase_parse(here, end, left_side, grammar::blank);
    if (predecessor.pattern.size() > 1 && predecessor.places[1][0] == '-')
        throw unexpected("an arrow '->' after one symbol", predecessor.places[1]);
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

/// Throws unless each axis has its sizes, and repeat one axis with one size.
void check_sizes(const ShapeSuccessor& shape, const std::vector<std::size_t>& lists,
                 const char* start, const char* axes) {
    for (std::size_t i = 0; i < shape.axis.size(); ++i)
        if (shape.axis.find(shape.axis[i]) != i)
            throw SyntaxError{axes, "expected different axes, found '" + shape.axis + "'"};
    if (shape.operation == "repeat" && shape.sizes.size() != 1)
        throw SyntaxError{
            start, "expected one size of repeat, found " + std::to_string(shape.sizes.size())};
    if (shape.operation == "repeat" && shape.axis.size() != 1)
        throw SyntaxError{axes, "expected one axis of repeat, found '" + shape.axis + "'"};
    if (shape.axis.size() == 1 && lists.size() > 1)
        throw SyntaxError{start, "expected sizes for one axis, found " +
                                     std::to_string(lists.size()) + " lists with ':' between"};
    if (shape.axis.size() != lists.size())
        throw SyntaxError{start, "expected sizes for each of " + std::to_string(shape.axis.size()) +
                                     " axes, with ':' between, found " +
                                     std::to_string(lists.size())};
}

ShapeSuccessor parse_division(std::string_view text, Reading& reading) {
    const char* here = text.data();
    const char* const end = here + text.size();
    const char* axes = here;
    std::vector<std::size_t> lists;  // how many sizes there are up to the end of each list
    ShapeSuccessor shape;
    const auto on_operation = [&](auto& c) {
        shape.operation = text_of(x3::_attr(c));
        if (shape.operation == "Split") shape.operation = "div";
    };
    const auto on_axes = [&](auto& c) {
        axes = x3::_attr(c).begin();
        shape.axis.assign(axes, x3::_attr(c).end());
    };
    const auto on_list = [&](auto&) { lists.push_back(shape.sizes.size()); };
    const auto on_part = [&](auto& c) { shape.parts.push_back(x3::_attr(c)); };

    const auto operation = x3::raw[x3::lit("div") | "repeat" | "Split"][on_operation];
    const auto axis = wanted("an axis, X, Y or Z")[x3::raw[x3::lexeme[+x3::char_("XYZ")]][on_axes]];
    const auto size = grammar::ByHand([&](const char*& first, const char* last) {
        ShapeSuccessor::Size made{parse_expression(first, last, reading.source, &reading.functions),
                                  false};
        if (first != last && *first == 'r') {  // relative
            made.relative = true;
            ++first;
        }
        shape.sizes.push_back(std::move(made));
    });
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

/// The shape successor `div(Y, 3, 1r, 1r){ B C C }`, `div(XZ, 1r, 1r : 2, 1r){ B }`, `repeat(Y, 0.3){ C }`
/// or `I(B)`, or nothing if the text is none of them. `Split` is read as `div`. `I(B)` is one only if
/// the production has no parameters, or three, and B is neither one of them nor a constant;
/// otherwise it is a module with an argument. Throws `SyntaxError`.
std::optional<ShapeSuccessor> parse_shape(std::string_view text, const Production& production,
                                          Reading& reading) {
    if (text.starts_with("div(") || text.starts_with("repeat(") || text.starts_with("Split("))
        return parse_division(text, reading);
    const std::vector<std::string> sizes = parameters(production);
    if (!text.starts_with("I(") || text.back() != ')' || (!sizes.empty() && sizes.size() != 3))
        return {};
    const std::string_view inner = trimmed(text.substr(2, text.size() - 3));
    if (inner.empty() || !is_letter(first_character(inner).code) ||
        reading.lexicon.length(inner) != inner.size() ||
        reading.constants.count(std::string(inner)) || std::ranges::count(sizes, inner))
        return {};
    std::string_view rest = inner;
    return ShapeSuccessor{"I", {}, {}, {*reading.lexicon.next(rest)}};
}

Rational parse_probability(std::string_view text, Reading& reading) {
    const Quantity value =
        reading.quantity(parse_expression(text, reading.source, &reading.functions));
    if (!value.exact)
        throw SyntaxError{text.data(), "expected a rational probability, found " + quoted(text)};
    if (sign(*value.exact) <= 0 || *value.exact > 1)
        throw SyntaxError{text.data(), "expected a probability above 0 and at most 1, found " +
                                           shortest_text(*value.exact)};
    return *value.exact;
}

void parse_successor(std::string_view text, Production& production, Reading& reading) {
    if (text.empty()) return;
    if ((production.shape = parse_shape(text, production, reading))) return;
    production.successor = parse_word(text, reading.lexicon, reading.source, true);
    check_brackets(production.successor, text, reading.lexicon, reading.source, reading.findings);
    reading.gather_slips(text, true);
}

void check_names_in_condition(const Production& production, Reading& reading) {
    if (production.condition)
        reading.check_names(*production.condition, parameters(production),
                            production.shape.has_value());
}

void check_names_in_successor(const Production& production, Reading& reading) {
    const std::vector<std::string> names = parameters(production);
    for (const auto& [position, arguments] : production.successor.arguments)
        for (const Expression& argument : arguments) reading.check_names(argument, names);
    for (const auto& [position, words] : production.successor.splices)
        for (const Expression& word : words) reading.check_names(word, names);
    if (production.shape)
        for (const ShapeSuccessor::Size& size : production.shape->sizes)
            reading.check_names(size.value, names);
}

/// Throws unless several successors may share this left side.
void check_may_share(const Arrow& split, const std::vector<std::string_view>& successors) {
    const auto behind_first = [&] {
        return std::find(successors[0].end(), split.right_side.end(), '|');
    };
    if (split.probability.data())
        throw SyntaxError{behind_first(),
                          "expected one successor behind an arrow with a probability; write a rule "
                          "for each alternative"};
    constexpr std::size_t most = 10'000'000;  // bytes of left sides if each were written
    if (split.left_side.size() > most / successors.size())
        throw SyntaxError{split.left_side.data(), "more than " + std::to_string(most) +
                                                      " bytes in the left sides of rules that "
                                                      "'|' separates"};
}

/// The rules that one text says, one for each successor. A fault in one of several becomes a finding.
/// Throws `SyntaxError`.
std::vector<Production> parse_productions(std::string_view text, const char* arrow,
                                          Reading& reading) {
    Production shared;
    shared.place = reading.source.place(text.data());
    const Arrow split = split_at_arrow(text, arrow);
    if (split.left_side.empty()) throw unexpected("a symbol before the arrow", text.data());
    try {
        parse_left_side(split.left_side, reading.lexicon, reading.source, shared);
    } catch (const SyntaxError&) {
        // The arrow of cpfg. Before it is what may be a letter, so it is named only where nothing else can be read.
        if (*arrow != '-' || arrow == text.data() || arrow[-1] != '-') throw;
        throw SyntaxError{arrow - 1, "expected an arrow, found '-->'; did you mean '->'?"};
    }
    if (split.probability.data())
        shared.probability = parse_probability(split.probability, reading);
    const std::vector<std::string_view> successors =
        reading.spaced ? std::vector{split.right_side} : separate_successors(split.right_side);
    if (successors.size() > 1) check_may_share(split, successors);
    std::vector<Production> all;
    const auto add = [&](std::string_view successor) {
        Production production = shared;
        parse_successor(successor, production, reading);
        if (all.empty() || all.front().shape.has_value() != production.shape.has_value())
            check_names_in_condition(production, reading);
        check_names_in_successor(production, reading);
        all.push_back(std::move(production));
    };
    if (successors.size() == 1) {
        add(successors.front());
        return all;
    }
    for (const std::string_view successor : successors) try {
            if (successor.empty())
                throw unexpected(
                    "a successor (the empty word is ε; the letter '|' is written without blanks)",
                    successor.data());
            if (successor.data() != successors.front().data())
                shared.place = reading.source.place(successor.data());
            add(successor);
        } catch (const SyntaxError& error) {
            reading.findings.add(error);
            reading.broken_rules = true;
        }
    return all;
}

}  // namespace

void read_rule(const Clause& clause, Reading& reading) {
    for (Production& production : parse_productions(clause.text, clause.arrow, reading)) {
        if (!reading.system.tables.empty()) production.table = reading.system.tables.size() - 1;
        reading.system.rules.push_back(std::move(production));
    }
}

void read_interpretation(const Clause& clause, Reading& reading) {
    const std::string_view rule = clause.value();
    if (!clause.arrow) throw unexpected("a rule with '->'", rule.data() + rule.size());
    for (Production& production : parse_productions(rule, clause.arrow, reading))
        reading.system.interpretation.push_back(std::move(production));
}

namespace {

/// A text that is the same for two rules just when they apply to the same letters in the same
/// places: symbols and arities of the patterns, and the condition with its parameters numbered.
class LeftSide {
public:
    explicit LeftSide(const Production& production) : names_(parameters(production)) {
        key_ = std::to_string(production.table) + '/';
        add(production.left);
        add({production.predecessor});
        add(production.right);
        add(production.elsewhere);
        if (production.condition) add(*production.condition);
    }

    const std::string& key() const { return key_; }

private:
    void add(const Pattern& pattern) {
        for (const ModulePattern& module : pattern) {
            key_ += std::to_string(module.symbol) + '(';
            for (const std::string& name : module.parameters) add_name(name);
            key_ += ')';
        }
        key_ += '/';
    }
    void add(const Expression& expression) {
        key_ += '(';
        if (expression.kind == Expression::Kind::number)
            key_ += to_string(expression.value);
        else
            add_name(expression.name);
        for (const Expression& operand : expression.operands) add(operand);
        key_ += ')';
    }
    void add_name(const std::string& name) {
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (names_[i] == name) {
                key_ += '$' + std::to_string(i) + ',';
                return;
            }
        key_ += name + ',';
    }

    std::vector<std::string> names_;
    std::string key_;
};

/// The rules with one left side.
struct SameLeftSide {
    const Production* with = nullptr;     // the first rule with a probability
    const Production* without = nullptr;  // the first rule without
    Rational sum;
};

}  // namespace

void check_probabilities(const std::vector<Production>& rules, Reading& reading) {
    if (reading.broken_rules) return;  // the missing rule may have the missing probability
    std::map<std::string, SameLeftSide> all;
    for (const Production& rule : rules) {
        SameLeftSide& alternatives = all[LeftSide(rule).key()];
        const Production*& first = rule.probability ? alternatives.with : alternatives.without;
        if (!first) first = &rule;
        if (rule.probability) alternatives.sum += *rule.probability;
    }
    for (const auto& [key, alternatives] : all) {
        if (!alternatives.with) continue;
        const std::string& name =
            reading.system.alphabet.name(alternatives.with->predecessor.symbol);
        if (alternatives.without)
            reading.findings.add(alternatives.without->place,
                                 "expected a probability, as other rules of " + name + " have one");
        else if (alternatives.sum != 1)
            reading.findings.add(alternatives.with->place,
                                 "the probabilities of " + name + " add up to " +
                                     to_string(alternatives.sum) + ", expected 1");
    }
}

namespace {

/// Whether a text is a whole number, such as the -1 of a coding.
bool is_integer(std::string_view text) {
    if (text.starts_with('-')) text.remove_prefix(1);
    if (text.size() > 1 && text.starts_with('0')) return false;
    return !text.empty() && text.size() <= 9 &&
           std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

void read_coding(const Clause& clause, Reading& reading) {
    const std::string_view value = clause.value();
    if (!value.starts_with('{')) throw unexpected("'{' after 'coding'", value.data());
    if (!value.ends_with('}')) throw SyntaxError{value.data(), "'{' is never closed"};
    const std::string_view inside = value.substr(1, value.size() - 2);
    for (std::size_t begin = 0; begin <= inside.size();) {
        const std::size_t end = std::min(inside.find_first_of(";,\n", begin), inside.size());
        const std::string_view rule = trimmed(inside.substr(begin, end - begin));
        begin = end + 1;
        if (rule.empty()) continue;
        const std::size_t ascii = rule.find("->"), arrow = std::min(ascii, rule.find("→"));
        if (arrow == std::string_view::npos)
            throw SyntaxError{
                rule.data(),
                "expected a letter and its image, such as a -> 0, found " + quoted(rule)};
        const std::string_view left = trimmed(rule.substr(0, arrow)),
                               image = trimmed(rule.substr(arrow + (arrow == ascii ? 2 : 3)));
        const auto known = reading.lexicon.known(left);
        if (!known)
            throw SyntaxError{rule.data(), "expected a letter of the system, found " +
                                               (left.empty() ? "'->'" : quoted(left))};
        if (image.empty() || (undeclared_length(image) != image.size() && !is_integer(image)))
            throw SyntaxError{image.empty() ? rule.data() : image.data(),
                              "expected one letter as the image of " + quoted(left) + ", found " +
                                  (image.empty() ? "none" : quoted(image)) +
                                  "; it is one symbol or a whole number"};
        for (const auto& [letter, before] : reading.coding.images)
            if (letter == *known)
                throw SyntaxError{rule.data(),
                                  "the letter " + quoted(left) + " has an image already"};
        reading.coding.images.emplace_back(*known, image);
    }
    std::sort(reading.coding.images.begin(), reading.coding.images.end());
    for (const Production& rule : reading.system.rules)
        if (!rule.predecessor.parameters.empty() || !rule.successor.arguments.empty() || rule.shape)
            throw SyntaxError{
                clause.text.data(),
                "expected a system without parameters and shape rules in a file with a coding"};
    if (!reading.system.axiom.arguments.empty())
        throw SyntaxError{clause.text.data(),
                          "expected an axiom without parameters in a file with a coding"};
}

}  // namespace algae
