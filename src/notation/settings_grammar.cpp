#include "notation/settings_grammar.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "notation/expression_grammar.hpp"
#include "notation/grammar.hpp"
#include "notation/suggestion.hpp"
#include "notation/word_grammar.hpp"
#include "system/colour.hpp"

namespace algae {

namespace {

namespace x3 = grammar::x3;
using grammar::between;
using grammar::wanted;

const auto digits = x3::raw[x3::lexeme[+x3::char_('0', '9')]];

std::string_view text_of(const boost::iterator_range<const char*>& range) {
    return between(range.begin(), range.end());
}

/// A generation or a seed: below 2^63.
std::uint64_t number_below(std::string_view text, const char* what) {
    constexpr std::size_t most_digits = 19;
    const std::size_t zeros = std::min(text.find_first_not_of('0'), text.size());
    std::uint64_t value = 0;
    if (text.size() - zeros <= most_digits)
        for (const char digit : text) value = value * 10 + static_cast<std::uint64_t>(digit - '0');
    if (text.size() - zeros > most_digits || value >> 63 != 0)
        throw SyntaxError{text.data(), std::string("expected ") + what + " below 2^63, found " + quoted(text)};
    return value;
}

using Range = std::pair<std::uint64_t, std::uint64_t>;

/// One number or a range of them, 0..6; `what` is "a generation".
Range range_of(std::string_view value, const char* what) {
    const char* here = value.data();
    const char* const end = here + value.size();
    std::string_view first, last;
    const auto on_first = [&](auto& c) { first = last = text_of(x3::_attr(c)); };
    const auto on_last = [&](auto& c) { last = text_of(x3::_attr(c)); };
    const auto range = wanted(what)[digits[on_first]] >> -(".." >> wanted(what)[digits[on_last]]);
    x3::phrase_parse(here, end, range, grammar::blank);
    if (here != end) throw unexpected("'..' or the end of the line", here);
    const Range found{number_below(first, what), number_below(last, what)};
    if (found.first > found.second)
        throw SyntaxError{last.data(), std::string("expected ") + what + " from " +
                                           std::string(first) + " on, found " + std::string(last)};
    return found;
}

void read_expectation(const Clause& clause, Reading& reading) {
    const std::string_view value = clause.value();
    const char* here = value.data();
    const char* const end = here + value.size();
    std::string_view kind, number;
    const auto on_kind = [&](auto& c) { kind = text_of(x3::_attr(c)); };
    const auto on_number = [&](auto& c) { number = text_of(x3::_attr(c)); };
    const auto head =
        wanted("what is expected, such as 'length'")[x3::raw[grammar::name][on_kind]] >>
        wanted("a generation")[digits[on_number]] >> wanted("':'")[x3::lit(':')];
    x3::phrase_parse(here, end, head, grammar::blank);
    const auto& kinds = expectation_kinds();
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
        std::string all;
        for (const std::string& known : kinds) all += (all.empty() ? "" : ", ") + known;
        throw SyntaxError{kind.data(), "expected one of " + all + ", found " + quoted(kind) +
                                           did_you_mean(kind, kinds)};
    }
    if (here == end) throw unexpected("a value", here);
    reading.system.expectations.push_back({std::string(kind), number_below(number, "a generation"),
                                           std::string(between(here, end)),
                                           reading.source.place(clause.text.data())});
}

void read_start(std::string_view value, Reading& reading) {
    const auto parts = pieces(value);
    const auto part = [&](std::size_t i, const char* what) {
        const char* const end = value.data() + value.size();
        if (i >= parts.size()) throw unexpected(what, end);
        return reading.quantity(parse_expression(parts[i], reading.source));
    };
    Settings::Start start{part(0, "x, y and heading"), part(1, "y and heading"),
                          part(2, "a heading")};
    if (parts.size() > 3)
        throw unexpected("the end of the line after x, y and heading", parts[3].data());
    reading.system.settings.start = std::move(start);
}

void read_stamp(std::string_view value, Reading& reading) {
    const auto parts = pieces(value);
    const char* const end = value.data() + value.size();
    if (parts.size() < 2) throw unexpected("a symbol and a shape: square, circle or triangle", end);
    const std::string_view shape = parts.back();
    const Word symbols = parse_symbols(between(value.data(), shape.data()), reading.lexicon);
    if (symbols.size() != 1)
        throw SyntaxError{value.data(), "expected one symbol and a shape, found " +
                                            std::to_string(symbols.size()) + " symbols"};
    auto& stamps = reading.system.settings.stamps;
    check_unnamed(symbols.front(), value.data(), reading);
    for (const StampShape known : {StampShape::square, StampShape::circle, StampShape::triangle})
        if (shape == shape_name(known)) {
            stamps.push_back({symbols.front(), known});
            return;
        }
    static const std::vector<std::string> shapes{"square", "circle", "triangle"};
    throw SyntaxError{shape.data(), "expected square, circle or triangle, found " + quoted(shape) +
                                        did_you_mean(shape, shapes)};
}

/// The names of tables, for a message; the first of them if there are very many.
std::string listed(const std::vector<std::string>& tables) {
    constexpr std::size_t most = 20;
    std::string out;
    for (std::size_t i = 0; i < std::min(most, tables.size()); ++i)
        out += (i == 0 ? "" : ", ") + tables[i];
    return tables.size() > most ? out + ", ... (" + std::to_string(tables.size()) + " tables)" : out;
}

void read_schedule(std::string_view value, Reading& reading) {
    const std::vector<std::string>& tables = reading.system.tables;
    if (tables.empty())
        throw SyntaxError{value.data(),
                          "expected tables for the schedule, such as 'table light' before rules, found none"};
    std::unordered_map<std::string_view, std::size_t> numbers;
    for (std::size_t i = 0; i < tables.size(); ++i) numbers.emplace(tables[i], i);
    for (const std::string_view name : pieces(value)) {
        const auto found = numbers.find(name);
        if (found == numbers.end())
            throw SyntaxError{name.data(), "expected a table (" + listed(tables) + "), found " +
                                               quoted(name) + did_you_mean(name, tables)};
        reading.system.schedule.push_back(found->second);
    }
}

void read_colours(std::string_view value, Reading& reading) {
    for (const std::string_view colour : pieces(value)) {
        const bool is_name = std::all_of(colour.begin(), colour.end(), [](char byte) {
            return is_letter(static_cast<unsigned char>(byte)) &&
                   static_cast<unsigned char>(byte) < 0x80;
        });
        if (!is_name && colour.front() != '#')
            throw SyntaxError{colour.data(),
                              "expected a colour's name or #rrggbb, found " + quoted(colour)};
        if (colour != "along") {
            try {
                colour_named(colour);
            } catch (const Error& error) {
                throw SyntaxError{colour.data(), error.what()};
            }
        }
        reading.system.settings.colours.emplace_back(colour);
    }
}

std::optional<Quantity>* number_of(std::string_view name, Settings& settings) {
    if (name == "angle") return &settings.angle;
    if (name == "step") return &settings.step;
    if (name == "shrink") return &settings.shrink;
    if (name == "spin") return &settings.spin;
    if (name == "scale") return &settings.scale;
    if (name == "narrow") return &settings.narrow;
    return name == "width" ? &settings.width : nullptr;
}

}  // namespace

const std::vector<std::string>& setting_names() {
    static const std::vector<std::string> names{
        "title",     "source",    "id",     "alphabet", "let",        "axiom", "table", "schedule", "ignore",
        "terminals", "interpret", "environment", "angle",  "step",     "shrink",     "start", "spin",
        "scale",     "narrow",    "plot",      "stamp",  "solid",     "surface", "tropism", "susceptibility",
        "width",     "colour",    "turn",   "camera",   "light",      "fog",   "generation", "seed",  "expect"};
    return names;
}

const std::vector<std::string>& expectation_kinds() {
    static const std::vector<std::string> kinds{"length",   "lengths",  "mean", "word", "segments",
                                                "distinct", "vertices", "end",  "box"};
    return kinds;
}

const char* shape_name(StampShape shape) {
    switch (shape) {
        case StampShape::square: return "square";
        case StampShape::circle: return "circle";
        case StampShape::triangle: return "triangle";
    }
    return "";
}

void read_setting(const Clause& clause, Reading& reading) {
    const std::string_view name = clause.keyword, value = clause.value();
    LSystem& system = reading.system;
    if (name == "title") {
        system.title = value;
    } else if (name == "source") {
        system.source = value;
    } else if (name == "id") {
        for (const std::string_view piece : pieces(value)) system.identifiers.emplace_back(piece);
    } else if (name == "table") {
        const auto parts = pieces(value);
        if (!reading.tables.emplace(parts.front()).second)
            throw SyntaxError{value.data(), "the table " + quoted(parts.front()) + " is opened twice"};
        system.tables.emplace_back(parts.front());
        if (parts.size() > 1) throw unexpected("the end of the line", parts[1].data());
    } else if (name == "schedule") {
        read_schedule(value, reading);
    } else if (name == "turn") {
        if (value != "clockwise" && value != "counter-clockwise")
            throw unexpected("'clockwise' or 'counter-clockwise'", value.data());
        system.settings.clockwise = value == "clockwise";
    } else if (name == "generation") {
        system.settings.generations = range_of(value, "a generation");
    } else if (name == "seed") {
        system.settings.seeds = range_of(value, "a seed");
    } else if (name == "stamp") {
        read_stamp(value, reading);
    } else if (name == "expect") {
        read_expectation(clause, reading);
    } else if (is_space_setting(name)) {
        read_space_setting(clause, reading);
    } else if (name == "environment") {
        read_environment(clause, reading);
    } else if (name == "start") {
        read_start(value, reading);
    } else if (name == "colour") {
        read_colours(value, reading);
    } else if (auto* number = number_of(name, system.settings)) {
        Quantity quantity = reading.quantity(parse_expression(value, reading.source));
        if (name == "width" && quantity.value <= 0)
            throw SyntaxError{value.data(), "expected a width above 0, found " + quoted(value)};
        if ((name == "step" || name == "shrink" || name == "scale") && quantity.value == 0)
            throw SyntaxError{value.data(), "expected a " + std::string(name) + " other than 0"};
        *number = std::move(quantity);
    }
}

}  // namespace algae
