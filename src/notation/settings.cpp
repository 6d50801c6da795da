#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/model.hpp"
#include "notation/detail/grammar.hpp"
#include "notation/detail/reading.hpp"
#include "turtle/turtle.hpp"

// The statements of a `.lsys` file that begin with a keyword.
//
// They are one table, `settings`, in the order of the canonical text: the keyword, what users are told of it, when it
// is read, whether a file may have several, the function that reads its value into the system, and the one that prints
// it. Whoever has to know what keywords there are asks this table: reading, printing, suggestions, the reference in
// NOTATION.md, the grammar of editors. The statements of a file are not read in their own order but in that of their
// stages: names before the words in which they occur, constants before the expressions, rules before the
// settings for their symbols. So a file may give them in any order, and symbols are numbered as in the
// canonical text.
//
// A value is a word, an expression, or pieces separated by blanks outside brackets (`pieces`), each a name or
// an expression over the constants. Only `let`, `expect` and ranges such as `0..6` need a grammar of their
// own. A reader throws `SyntaxError` at what is wrong, or `DependsOnError` where it uses a constant whose own
// statement was faulty.

namespace algae {

namespace {

namespace x3 = grammar::x3;
using grammar::between;
using grammar::is_one_of;
using grammar::text_of;
using grammar::wanted;

const char* end_of(const Clause& clause) { return clause.text.data() + clause.text.size(); }

Quantity quantity_of(std::string_view text, const Reading& reading) {
    return reading.quantity(parse_expression(text, reading.source, &reading.functions));
}

[[noreturn]] void refuse(std::string_view found, const std::vector<std::string>& names) {
    throw unknown_word(listed(names), found, names);
}

[[noreturn]] void refuse_many(std::string_view found, const std::vector<std::string>& names) {
    throw unknown_word("one of " + joined(names, ", "), found, names);
}

/// A number as one piece among several.
std::string piece(const Quantity& number) {
    const std::string text = to_text(number.expression);
    return text.find(' ') == std::string::npos ? text : '(' + text + ')';
}

// The names that may stand behind keywords.

std::vector<std::string> environment_names() {
    std::vector<std::string> names;
    for (const EnvironmentKind& kind : environment_kinds()) names.push_back(kind.name);
    return names;
}

std::vector<std::string> solid_names() {
    std::vector<std::string> names;
    for (const SolidKind& kind : solid_kinds()) names.push_back(kind.name.name);
    return names;
}

/// Kinds of solids and their measures.
std::vector<std::string> solid_words() {
    std::vector<std::string> words = solid_names();
    for (const SolidKind& kind : solid_kinds())
        for (const SolidKind::Name& measure : kind.measures)
            if (!is_one_of(words, measure.name)) words.push_back(measure.name);
    return words;
}

std::vector<std::string> colour_words() {
    std::vector<std::string> words = colour_schemes();
    for (const std::string_view name : colour_names()) words.emplace_back(name);
    return words;
}

const std::vector<std::string>& turns() {
    static const std::vector<std::string> names{"clockwise", "counter-clockwise"};
    return names;
}

// Names and constants.

/// A function's body with the values of constants in place of their names: its calls may stand where a rule gives such a name to a
/// parameter of its own. Throws `SyntaxError` at `where` if `budget` constants are not enough.
Expression with_values(Expression body, const std::vector<std::string>& parameters,
                       const Reading& reading, const char* where, std::size_t& budget) {
    for (Expression& operand : body.operands)
        operand = with_values(std::move(operand), parameters, reading, where, budget);
    if (body.kind != Expression::Kind::name || is_one_of(parameters, body.name)) return body;
    const Quantity* const value = reading.constant(body.name);
    if (!value) return body;
    if (budget-- == 0)
        throw SyntaxError{where, "the constants of the function stand for more than 10,000 others"};
    if (value->exact) return quantity(*value->exact).expression;
    return with_values(reading.functions.expanded(value->expression, where), {}, reading, where,
                       budget);
}

/// `f(x,y) = x^2 + y`, from `=` on.
void read_function(const char* here, const char* end, const std::string_view name,
                   const std::vector<std::string_view>& parameters, Reading& reading) {
    if (function_arity(name) || is_one_of(reading.lexicon.systems(), name))
        throw SyntaxError{name.data(),
                          "expected another name, " + quoted(name) +
                              (function_arity(name) ? " is a function already" : " is a system")};
    constexpr std::size_t most = 1000;  // each call looks through them
    if (reading.functions.all().size() == most)
        throw SyntaxError{name.data(), "more than " + std::to_string(most) + " functions"};
    OwnFunctions::Function function;
    function.name = name;
    for (const std::string_view parameter : parameters) {
        if (is_one_of(function.parameters, parameter))
            throw SyntaxError{parameter.data(),
                              "the parameter " + quoted(parameter) + " is given twice"};
        function.parameters.emplace_back(parameter);
    }
    if (here == end || *here != '=') throw unexpected("'='", here);
    const std::string_view text = between(here + 1, end);
    const std::size_t found = reading.findings.count();
    reading.functions.define(name);
    function.said = parse_expression(text, reading.source, &reading.functions);
    reading.check_names(function.said, function.parameters);
    if (reading.findings.count() > found) throw DependsOnError();
    std::size_t budget = 10'000;
    function.body = with_values(reading.functions.expanded(function.said, text.data()),
                                function.parameters, reading, text.data(), budget);
    function.constants = reading.system.constants.size();
    reading.functions.add(std::move(function));
}

void read_constant(const Clause& clause, Reading& reading) {
    const std::string_view value = clause.value();
    const char* here = value.data();
    const char* const end = here + value.size();
    std::string_view name;
    std::vector<std::string_view> parameters;
    const auto on_name = [&](auto& c) { name = text_of(x3::_attr(c)); };
    const auto on_parameter = [&](auto& c) { parameters.push_back(text_of(x3::_attr(c))); };
    const auto parameter = wanted("a parameter's name")[x3::raw[grammar::name][on_parameter]];
    const auto head = wanted("a constant's name")[x3::raw[grammar::name][on_name]] >>
                      -('(' >> parameter % ',' >> wanted("',' or ')'")[x3::lit(')')]);
    x3::phrase_parse(here, end, head, grammar::blank);
    const std::string said(name);
    try {
        if (reading.functions.find(name))
            throw SyntaxError{value.data(),
                              "the function " + algae::quoted(said) + " is given twice"};
        if (!parameters.empty()) {
            if (reading.constants.count(said))
                throw SyntaxError{value.data(), "expected another name, " + algae::quoted(said) +
                                                    " is a constant"};
            return read_function(here, end, name, parameters, reading);
        }
        if (here == end || *here != '=') throw unexpected("'='", here);
        if (reading.constants.count(said))
            throw SyntaxError{value.data(),
                              "the constant " + algae::quoted(said) + " is given twice"};
        Quantity quantity = quantity_of(between(here + 1, end), reading);
        if (reading.replaced)
            for (const auto& [replaced, other] : *reading.replaced)
                if (replaced == name) quantity = other;
        reading.constants.emplace(said, reading.system.constants.size());
        reading.system.constants.emplace_back(said, std::move(quantity));
    } catch (...) {
        reading.broken.insert(said);
        if (!parameters.empty() && !reading.functions.find(said))
            reading.functions.add_broken(said);
        throw;
    }
}

void read_alphabet(const Clause& clause, Reading& reading) {
    for (const std::string_view name : pieces(clause.value())) {
        // These open statements that contain arrows, or shape successors: a rule could not be told.
        for (const char* keyword : {"title", "source", "interpret", "coding", "div", "repeat"})
            if (name == keyword)
                throw SyntaxError{name.data(), "expected another name, " + quoted(name) +
                                                   " has a meaning in the notation"};
        check_symbol_name(name, name.front() == '?' && name.size() > 1 ? 1 : 0, "");
        const Symbol symbol = reading.lexicon.declare(name);
        reading.declare(std::string(name));
        auto& declared = reading.system.declared;
        if (symbol == declared.size()) declared.push_back(symbol);  // else it is there already
    }
}

// Words.

void read_axiom(const Clause& clause, Reading& reading) {
    const std::string_view value = clause.value();
    LSystem& system = reading.system;
    system.axiom_place = reading.source.place(value.data());
    system.axiom = parse_word(value, reading.lexicon, reading.source, true);
    check_brackets(system.axiom, value, reading.lexicon, reading.source, reading.findings);
    reading.gather_slips(value, false);
    for (const auto& [position, arguments] : system.axiom.arguments)
        for (const Expression& argument : arguments) reading.check_names(argument, {});
    for (const auto& [position, words] : system.axiom.splices)
        for (const Expression& word : words) reading.check_names(word, {});
}

/// The symbols of the value, each once, in the order of its first occurrence.
std::vector<Symbol> symbols_of(const Clause& clause, Reading& reading) {
    std::vector<Symbol> out;
    std::vector<bool> seen;
    for (const Symbol symbol : parse_symbols(clause.value(), reading.lexicon)) {
        if (symbol >= seen.size()) seen.resize(symbol + 1);
        if (!seen[symbol]) out.push_back(symbol);
        seen[symbol] = true;
    }
    return out;
}

// Tables.

void read_table(const Clause& clause, Reading& reading) {
    const auto parts = pieces(clause.value());
    if (!reading.tables.emplace(parts.front()).second)
        throw SyntaxError{parts.front().data(),
                          "the table " + quoted(parts.front()) + " is opened twice"};
    reading.system.tables.emplace_back(parts.front());
    if (parts.size() > 1) throw unexpected("the end of the line", parts[1].data());
}

/// The names of tables, for a message; the first of them if there are very many.
std::string listed_tables(const std::vector<std::string>& tables) {
    constexpr std::size_t most = 20;
    if (tables.size() <= most) return listed(tables, ", ");
    return listed({tables.begin(), tables.begin() + most}, ", ") + ", ... (" +
           std::to_string(tables.size()) + " tables)";
}

void read_schedule(const Clause& clause, Reading& reading) {
    const std::string_view value = clause.value();
    const std::vector<std::string>& tables = reading.system.tables;
    if (tables.empty())
        throw SyntaxError{
            value.data(),
            "expected tables for the schedule, such as 'table light' before rules, found none"};
    std::unordered_map<std::string_view, std::size_t> numbers;
    for (std::size_t i = 0; i < tables.size(); ++i) numbers.emplace(tables[i], i);
    for (const std::string_view name : pieces(value)) {
        const auto found = numbers.find(name);
        if (found == numbers.end())
            throw SyntaxError{name.data(), "expected a table (" + listed_tables(tables) +
                                               "), found " + quoted(name) +
                                               did_you_mean(name, tables)};
        reading.system.schedule.push_back(found->second);
    }
}

// Environments.

Symbol communication_symbol(std::string_view piece, Reading& reading) {
    std::string_view rest = piece;
    const auto symbol = reading.lexicon.next(rest);
    if (!symbol || !rest.empty() || !is_communication(piece))
        throw SyntaxError{piece.data(),
                          "expected a communication module, such as ?E, found " + quoted(piece)};
    return *symbol;
}

const EnvironmentKind& environment_named(std::string_view name) {
    for (const EnvironmentKind& kind : environment_kinds())
        if (kind.name == name) return kind;
    refuse_many(name, environment_names());
}

/// Throws where the second corner of a box is below the first in some direction.
void check_corners(const std::vector<std::string_view>& texts,
                   const std::vector<Quantity>& numbers) {
    const std::size_t dimension = numbers.size() / 2;
    for (std::size_t i = 0; i < dimension; ++i)
        if (numbers[i].value > numbers[dimension + i].value)
            throw SyntaxError{texts[dimension + i].data(),
                              "expected a number from " + to_text(numbers[i].expression) +
                                  " on, as the second corner is above the first, found " +
                                  quoted(texts[dimension + i])};
}

/// What fills the communication modules of one name, `environment ?E clip 0 0 4 3`.
void read_environment(const Clause& clause, Reading& reading) {
    const auto parts = pieces(clause.value());
    EnvironmentSetting setting;
    setting.module = communication_symbol(parts[0], reading);
    for (const EnvironmentSetting& other : reading.system.environments)
        if (other.module == setting.module)
            throw SyntaxError{parts[0].data(),
                              "the environment of " + quoted(parts[0]) + " is given twice"};
    if (parts.size() == 1)
        throw unexpected("a kind of environment, such as 'position'", end_of(clause));
    const EnvironmentKind& kind = environment_named(parts[1]);
    setting.kind = kind.name;
    const std::vector<std::string_view> texts(parts.begin() + 2, parts.end());
    const std::size_t most = kind.counts.back();
    if (texts.size() > most)
        throw unexpected("the end of the line" + (most == 0 ? "" : " after " + kind.numbers),
                         texts[most].data());
    if (std::count(kind.counts.begin(), kind.counts.end(), texts.size()) == 0)
        throw unexpected(kind.numbers, end_of(clause));
    for (const std::string_view text : texts) setting.numbers.push_back(quantity_of(text, reading));
    if (kind.name == "clip")
        check_corners(texts, setting.numbers);
    else if (most > 0 && setting.numbers[0].value <= 0)
        throw SyntaxError{texts[0].data(), "expected a radius above 0, found " + quoted(texts[0])};
    reading.system.environments.push_back(std::move(setting));
}

// How figures are drawn.

/// A setting of one number.
template <std::optional<Quantity> Drawing::*number>
void read_number(const Clause& clause, Reading& reading) {
    const std::string_view name = clause.keyword, value = clause.value();
    Quantity quantity = quantity_of(value, reading);
    if (name == "width" && quantity.value <= 0)
        throw SyntaxError{value.data(), "expected a width above 0, found " + quoted(value)};
    if ((name == "step" || name == "shrink" || name == "scale") && quantity.value == 0)
        throw SyntaxError{value.data(), "expected a " + std::string(name) + " other than 0"};
    reading.drawing.*number = std::move(quantity);
}

void read_start(const Clause& clause, Reading& reading) {
    const auto parts = pieces(clause.value());
    if (parts.size() == 1 && parts[0] == "upward") {
        const auto number = [](int value) { return quantity(Rational(value)); };
        reading.drawing.start = Drawing::Start{number(0), number(0), number(90), true};
        return;
    }
    const auto part = [&](std::size_t i, const char* what) {
        if (i >= parts.size()) throw unexpected(what, end_of(clause));
        return quantity_of(parts[i], reading);
    };
    Drawing::Start start{part(0, "x, y and heading, or 'upward'"), part(1, "y and heading"),
                         part(2, "a heading")};
    if (parts.size() > 3)
        throw unexpected("the end of the line after x, y and heading", parts[3].data());
    reading.drawing.start = std::move(start);
}

/// Throws if the symbol has a stamp, a solid or a surface already.
void check_unnamed(Symbol symbol, const char* place, const Reading& reading) {
    const auto check = [&](const auto& all, const char* what) {
        for (const auto& one : all)
            if (one.symbol == symbol)
                throw SyntaxError{place, "the symbol " +
                                             algae::quoted(reading.system.alphabet.name(symbol)) +
                                             " has a " + what + " already"};
    };
    check(reading.drawing.stamps, "stamp");
    check(reading.drawing.solids, "solid");
    check(reading.drawing.surfaces, "surface");
}

/// The one symbol of the text, which has no shape yet; `more` is what else a message expects.
Symbol symbol_of(std::string_view text, Reading& reading, const char* more = "") {
    const Word symbols = parse_symbols(text, reading.lexicon);
    if (symbols.size() != 1)
        throw SyntaxError{text.data(), std::string("expected one symbol") + more + ", found " +
                                           std::to_string(symbols.size()) + " symbols"};
    check_unnamed(symbols.front(), text.data(), reading);
    return symbols.front();
}

void read_stamp(const Clause& clause, Reading& reading) {
    const std::string_view value = clause.value();
    const auto parts = pieces(value);
    if (parts.size() < 2)
        throw unexpected("a symbol and a shape: " + listed(stamp_shapes()), end_of(clause));
    const std::string_view shape = parts.back();
    const Symbol symbol = symbol_of(between(value.data(), shape.data()), reading, " and a shape");
    const auto known = std::find(stamp_shapes().begin(), stamp_shapes().end(), shape);
    if (known == stamp_shapes().end()) refuse(shape, stamp_shapes());
    reading.drawing.stamps.push_back(
        {symbol, static_cast<StampShape>(known - stamp_shapes().begin())});
}

void read_solid(const Clause& clause, Reading& reading) {
    const std::vector<std::string> kinds = solid_names();
    std::vector<std::string> measures;
    const auto parts = pieces(clause.value());
    if (parts.size() < 2) throw unexpected("a symbol and " + listed(kinds), end_of(clause));
    SolidSetting solid;
    solid.symbol = symbol_of(parts[0], reading);
    const SolidKind* const kind = solid_kind(parts[1]);
    if (!kind) refuse(parts[1], kinds);
    solid.kind = kind->name.name;
    for (const SolidKind::Name& measure : kind->measures) measures.push_back(measure.name);
    for (std::size_t i = 2; i < parts.size(); ++i) {
        const auto measure = std::find_if(
            kind->measures.begin(), kind->measures.end(), [&](const SolidKind::Name& name) {
                return name.name == parts[i] || name.reserved == parts[i];
            });
        if (measure == kind->measures.end()) refuse(parts[i], measures);
        if (std::count(solid.measures.begin(), solid.measures.end(), measure->name) > 0)
            throw SyntaxError{parts[i].data(),
                              "the measure " + quoted(parts[i]) + " is given twice"};
        solid.measures.push_back(measure->name);
    }
    reading.drawing.solids.push_back(std::move(solid));
}

Triple point_at(const char*& here, const char* end, Reading& reading) {
    const char* const begin = here;
    const std::vector<Expression> parts =
        parse_arguments(here, end, reading.source, &reading.functions);
    if (parts.size() != 3)
        throw SyntaxError{begin,
                          "expected a point (x,y,z), found " + counted(parts.size(), "number")};
    return {reading.quantity(parts[0]), reading.quantity(parts[1]), reading.quantity(parts[2])};
}

void read_surface(const Clause& clause, Reading& reading) {
    constexpr std::size_t patch_points = 16, least_corners = 3;
    const auto parts = pieces(clause.value());
    if (parts.size() < 2)
        throw unexpected("a symbol and " + listed(surface_kinds()), end_of(clause));
    SurfaceSetting surface;
    surface.symbol = symbol_of(parts[0], reading);
    surface.kind = parts[1];
    if (!is_one_of(surface_kinds(), surface.kind)) refuse(parts[1], surface_kinds());
    const bool is_patch = surface.kind == "patch",
               has_points = is_patch || surface.kind == "polygon";
    if (!has_points && parts.size() > 2) throw unexpected("the end of the line", parts[2].data());
    for (std::size_t i = 2; i < parts.size(); ++i) {
        const char* here = parts[i].data();
        const char* const end = here + parts[i].size();
        while (here != end) {
            if (*here != '(') throw unexpected("a point (x,y,z)", here);
            surface.points.push_back(point_at(here, end, reading));
        }
    }
    const std::string found = ", found " + std::to_string(surface.points.size());
    if (is_patch && surface.points.size() != patch_points)
        throw SyntaxError{parts[1].data(), "expected 16 points for a patch, row by row" + found};
    if (has_points && surface.points.size() < least_corners)
        throw SyntaxError{parts[1].data(), "expected at least three points for a polygon" + found};
    reading.drawing.surfaces.push_back(std::move(surface));
}

/// Two coordinates or a point of space, then the text.
void read_label(const Clause& clause, Reading& reading) {
    const std::string_view value = clause.value();
    const auto parts = pieces(value);
    Drawing::Label label;
    std::size_t used = 2;
    if (parts[0].front() == '(' && parts[0].find(',') != std::string_view::npos) {
        const char* here = parts[0].data();
        const char* const end = here + parts[0].size();
        label.place = point_at(here, end, reading);
        if (here != end) throw unexpected("a blank and the text", here);
        label.in_space = true;
        used = 1;
    }
    if (parts.size() <= used)
        throw unexpected("a point and a text, such as 'label 0 1 B' or 'label (0,0,2) top'",
                         end_of(clause));
    if (!label.in_space)
        label.place = {quantity_of(parts[0], reading), quantity_of(parts[1], reading), {}};
    label.text = between(parts[used].data(), end_of(clause));
    reading.drawing.labels.push_back(std::move(label));
}

/// So many numbers, and no more than that and `words` words behind them; `what` is for messages.
std::vector<Quantity> numbers_of(const Clause& clause, std::size_t count, const char* what,
                                 Reading& reading, std::size_t words = 0) {
    auto parts = pieces(clause.value());
    parts.resize(parts.size() - words);
    if (parts.size() < count) throw unexpected(what, end_of(clause));
    if (parts.size() > count)
        throw unexpected("the end of the line after " + std::string(what), parts[count].data());
    std::vector<Quantity> out;
    for (const std::string_view part : parts) out.push_back(quantity_of(part, reading));
    return out;
}

void read_tropism(const Clause& clause, Reading& reading) {
    const auto words = pieces(clause.value());
    const bool bends_before = words.size() > 3 && words.back() == "before";
    const auto to = numbers_of(clause, 3, "three coordinates", reading, bends_before ? 1 : 0);
    if (to[0].value == 0 && to[1].value == 0 && to[2].value == 0)
        throw SyntaxError{clause.value().data(), "expected a direction, found the zero vector"};
    reading.drawing.tropism = Triple{to[0], to[1], to[2]};
    reading.drawing.bends_before = bends_before;
}

void read_susceptibility(const Clause& clause, Reading& reading) {
    reading.drawing.susceptibility = numbers_of(clause, 1, "a number", reading)[0];
}

void read_elasticity(const Clause& clause, Reading& reading) {
    reading.drawing.elastic = symbols_of(clause, reading);
    for (const Symbol symbol : reading.drawing.elastic)
        if (const std::string& name = reading.system.alphabet.name(symbol); is_turtle_name(name))
            throw SyntaxError{
                clause.value().data(),
                "expected letters that tell the turtle nothing else, found " + quoted(name)};
}

void read_fog(const Clause& clause, Reading& reading) {
    Quantity fog = numbers_of(clause, 1, "a number", reading)[0];
    if (!(fog.value >= 0 && fog.value <= 1))
        throw SyntaxError{clause.value().data(),
                          "expected a share from 0 to 1, found " + quoted(clause.value())};
    reading.drawing.fog = std::move(fog);
}

Direction direction_of(const std::vector<std::string_view>& parts, const Clause& clause,
                       Reading& reading) {
    if (parts.size() < 2)
        throw unexpected("an azimuth and an elevation in degrees", end_of(clause));
    Direction out{quantity_of(parts[0], reading), quantity_of(parts[1], reading)};
    if (!(out.elevation.value >= -90 && out.elevation.value <= 90))
        throw SyntaxError{parts[1].data(), "expected an elevation from -90 to 90 degrees, found " +
                                               quoted(parts[1])};
    return out;
}

void read_camera(const Clause& clause, Reading& reading) {
    const auto parts = pieces(clause.value());
    CameraSetting camera;
    camera.from = direction_of(parts, clause, reading);
    if (parts.size() > 2) {
        if (parts[2] != "perspective") refuse(parts[2], {"perspective"});
        camera.perspective = true;
    }
    if (parts.size() > 3) {
        camera.opening = quantity_of(parts[3], reading);
        if (!(camera.opening->value >= 1 && camera.opening->value <= 120))
            throw SyntaxError{parts[3].data(),
                              "expected degrees from 1 to 120, found " + quoted(parts[3])};
    }
    if (parts.size() > 4) throw unexpected("the end of the line", parts[4].data());
    reading.drawing.camera = std::move(camera);
}

void read_light(const Clause& clause, Reading& reading) {
    const auto parts = pieces(clause.value());
    Direction light = direction_of(parts, clause, reading);
    if (parts.size() > 2) throw unexpected("the end of the line", parts[2].data());
    reading.drawing.light = std::move(light);
}

void read_colours(const Clause& clause, Reading& reading) {
    for (const std::string_view colour : pieces(clause.value())) {
        const bool is_name = std::all_of(colour.begin(), colour.end(), [](char byte) {
            return is_letter(static_cast<unsigned char>(byte)) &&
                   static_cast<unsigned char>(byte) < 0x80;
        });
        if (!is_name && colour.front() != '#')
            throw SyntaxError{colour.data(),
                              "expected a colour's name or #rrggbb, found " + quoted(colour)};
        try {
            if (!is_scheme(colour)) colour_named(colour);
        } catch (const Error& error) {
            throw SyntaxError{colour.data(), error.what()};
        }
        reading.drawing.colours.emplace_back(colour);
    }
}

void read_turn(const Clause& clause, Reading& reading) {
    const std::string_view value = clause.value();
    if (!is_one_of(turns(), value))
        throw unexpected("'clockwise' or 'counter-clockwise'", value.data());
    reading.drawing.clockwise = value == "clockwise";
}

/// A word of those that a setting knows.
std::string word_of(const Clause& clause, const std::vector<std::string>& names) {
    std::string value(clause.value());
    if (!is_one_of(names, value)) refuse(clause.value(), names);
    return value;
}

// Generations, seeds and what is expected of a generation.

const auto digits = x3::raw[x3::lexeme[+x3::char_('0', '9')]];

/// A generation or a seed: below 2^63.
std::uint64_t number_below(std::string_view text, const char* what) {
    constexpr std::size_t most_digits = 19;
    const std::size_t zeros = std::min(text.find_first_not_of('0'), text.size());
    std::uint64_t value = 0;
    if (text.size() - zeros <= most_digits)
        for (const char digit : text) value = value * 10 + static_cast<std::uint64_t>(digit - '0');
    if (text.size() - zeros > most_digits || value >> 63 != 0)
        throw SyntaxError{text.data(),
                          std::string("expected ") + what + " below 2^63, found " + quoted(text)};
    return value;
}

void read_columns(const Clause& clause, Reading& reading) {
    const std::string_view value = clause.value();
    const bool is_number =
        std::ranges::all_of(value, [](char byte) { return byte >= '0' && byte <= '9'; });
    const std::uint64_t columns = is_number ? number_below(value, "a number of panels") : 0;
    if (columns == 0)
        throw SyntaxError{
            value.data(),
            "expected how many panels stand in a row, from 1 on, found " + quoted(value)};
    reading.drawing.columns = columns;
}

/// One number or a range of them, 0..6; `what` is "a generation".
std::pair<std::uint64_t, std::uint64_t> range_of(const Clause& clause, const char* what) {
    const std::string_view value = clause.value();
    const char* here = value.data();
    const char* const end = here + value.size();
    std::string_view first, last;
    const auto on_first = [&](auto& c) { first = last = text_of(x3::_attr(c)); };
    const auto on_last = [&](auto& c) { last = text_of(x3::_attr(c)); };
    const auto range = wanted(what)[digits[on_first]] >> -(".." >> wanted(what)[digits[on_last]]);
    x3::phrase_parse(here, end, range, grammar::blank);
    if (here != end) throw unexpected("'..' or the end of the line", here);
    const std::pair found{number_below(first, what), number_below(last, what)};
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
    if (!is_one_of(expectation_kinds(), kind)) refuse_many(kind, expectation_kinds());
    if (here == end) throw unexpected("a value", here);
    if (*here == '#')  // would be a comment where the canonical text has a blank
        throw SyntaxError{here, "expected a value, found '#'; a comment needs a blank before"};
    reading.expectations.push_back({std::string(kind), number_below(number, "a generation"),
                                    std::string(between(here, end)),
                                    reading.source.place(clause.text.data())});
}

// How values are printed.

using Values = std::vector<std::string>;

template <std::optional<Quantity> Drawing::*number>
Values print_number(const Printing& printing) {
    const std::optional<Quantity>& value = printing.drawing.*number;
    return value ? Values{to_text(value->expression)} : Values{};
}

Values print_constants(const Printing& printing) {
    Values out;
    const auto& constants = printing.system.constants;
    std::size_t printed = 0;
    const auto constants_up_to = [&](std::size_t end) {
        for (; printed < end; ++printed)
            out.push_back(constants[printed].first + " = " +
                          to_text(constants[printed].second.expression));
    };
    if (printing.functions)
        for (const OwnFunctions::Function& function : printing.functions->all()) {
            constants_up_to(function.constants);
            out.push_back(function.name + '(' + joined(function.parameters, ",") +
                          ") = " + to_text(function.said));
        }
    constants_up_to(constants.size());
    return out;
}

Values print_interpretation(const Printing& printing) {
    Values out;
    for (const Production& rule : printing.system.interpretation)
        out.push_back(printing.printer.rule(rule));
    return out;
}

Values print_coding(const Printing& printing) {
    if (printing.coding.empty()) return {};
    Values rules;
    for (const auto& [letter, image] : printing.coding.images)
        rules.push_back(printing.system.alphabet.name(letter) + " -> " + image);
    return {"{ " + joined(rules, "; ") + " }"};
}

Values print_environments(const Printing& printing) {
    Values out;
    for (const EnvironmentSetting& environment : printing.system.environments)
        out.push_back(print_environment(printing.system.alphabet, environment));
    return out;
}

/// What symbols leave where the turtle stands: the symbol, then what `print` says of it.
template <class Shape, class Print>
Values print_shapes(const std::vector<Shape>& shapes, const Printing& printing, Print print) {
    Values out;
    for (const Shape& shape : shapes)
        out.push_back(printing.system.alphabet.name(shape.symbol) + ' ' + print(shape));
    return out;
}

Values print_start(const Printing& printing) {
    const auto& start = printing.drawing.start;
    if (!start) return {};
    if (start->upward) return {"upward"};
    return {joined({piece(start->x), piece(start->y), piece(start->heading)}, " ")};
}

Values print_tropism(const Printing& printing) {
    const auto& to = printing.drawing.tropism;
    if (!to) return {};
    Values parts{piece(to->x), piece(to->y), piece(to->z)};
    if (printing.drawing.bends_before) parts.emplace_back("before");
    return {joined(parts, " ")};
}

std::string print_direction(const Direction& direction) {
    return joined({piece(direction.azimuth), piece(direction.elevation)}, " ");
}

Values print_camera(const Printing& printing) {
    const auto& camera = printing.drawing.camera;
    if (!camera) return {};
    Values parts{print_direction(camera->from)};
    if (camera->perspective) parts.emplace_back("perspective");
    if (camera->opening) parts.push_back(piece(*camera->opening));
    return {joined(parts, " ")};
}

Values print_labels(const Printing& printing) {
    Values out;
    for (const Drawing::Label& label : printing.drawing.labels) {
        const Triple& at = label.place;
        out.push_back((label.in_space
                           ? '(' +
                                 joined({to_text(at.x.expression), to_text(at.y.expression),
                                         to_text(at.z.expression)},
                                        ", ") +
                                 ')'
                           : piece(at.x) + ' ' + piece(at.y)) +
                      ' ' + label.text);
    }
    return out;
}

Values print_range(const std::optional<std::pair<std::uint64_t, std::uint64_t>>& range) {
    if (!range) return {};
    const auto [first, last] = *range;
    return {std::to_string(first) + (last == first ? "" : ".." + std::to_string(last))};
}

Values print_expectations(const Printing& printing) {
    Values out;
    for (const Expectation& expectation : printing.expectations)
        out.push_back(expectation.kind + ' ' + std::to_string(expectation.generation) + ": " +
                      expectation.value);
    return out;
}

}  // namespace

std::string print_environment(const Alphabet& alphabet, const EnvironmentSetting& environment) {
    std::vector<std::string> parts{alphabet.name(environment.module), environment.kind};
    for (const Quantity& number : environment.numbers) parts.push_back(piece(number));
    return joined(parts, " ");
}

std::string print_solid(const SolidSetting& solid) {
    return solid.kind + (solid.measures.empty() ? "" : ' ' + joined(solid.measures, " "));
}

std::string print_surface(const SurfaceSetting& surface) {
    std::string out = surface.kind;
    for (const Triple& point : surface.points)
        out += " (" + to_text(point.x.expression) + ", " + to_text(point.y.expression) + ", " +
               to_text(point.z.expression) + ')';
    return out;
}

const char* shape_name(StampShape shape) {
    return stamp_shapes().at(static_cast<std::size_t>(shape)).c_str();
}

const std::vector<Setting>& settings() {
    using C = const Clause&;
    using R = Reading&;
    using P = const Printing&;
    constexpr Stage other = Stage::other;
    constexpr bool once = false, repeats = true, outside = false, within = true;
    static const std::vector<Setting> all{
        {{"title", {"title Koch snowflake"}, "what the file shows", ""},
         other,
         once,
         outside,
         [](C c, R r) { r.system.title = c.value(); },
         [](P p) -> Values { return {p.system.title}; }},
        {{"source", {"source von Koch 1904"}, "where it is from", ""},
         other,
         once,
         outside,
         [](C c, R r) { r.system.source = c.value(); },
         [](P p) -> Values { return {p.system.source}; }},
        {{"id", {"id S-005 F-007"}, "where a catalogue lists it", ""},
         other,
         repeats,
         outside,
         [](C c, R r) {
             for (const auto name : blank_separated(c.value()))
                 r.system.identifiers.emplace_back(name);
         },
         [](P p) -> Values { return {joined(p.system.identifiers, " ")}; }},
        {{"alphabet",
          {"alphabet wall window"},
          "symbols whose names may be longer; [above](#words-and-rules)",
          "one character, or a letter with a subscript"},
         Stage::alphabet,
         repeats,
         outside,
         read_alphabet,
         [](P p) -> Values { return {p.printer.apart(p.system.declared)}; }},
        {{"let",
          {"let r1 = 0.9", "let f(x) = r1*x^2"},
          "a constant, or a function of one or more numbers, by numbers and what stands above it; "
          "[above](#functions)",
          ""},
         Stage::constant,
         repeats,
         outside,
         read_constant,
         print_constants},
        {{"system",
          {"system leaf { axiom x; x -> F[+x]x }"},
          "a system within, whose words others use; [above](#systems-within-a-system)",
          ""},
         Stage::inner,
         repeats,
         outside,
         read_inner,
         nullptr},
        {{"axiom", {"axiom F--F--F"}, "the word of generation 0", "an error"},
         Stage::axiom,
         once,
         within,
         read_axiom,
         [](P p) -> Values { return {p.printer.word(p.system.axiom)}; }},
        {{"table", {"table light"}, "opens a table for the rules below it", "one table"},
         Stage::rule,
         repeats,
         outside,
         read_table,
         nullptr},
        {{"schedule",
          {"schedule light dark"},
          "the tables of the steps, again and again; [above](#parameters-and-choices)",
          "a seed, or whoever derives a word, must say"},
         other,
         once,
         outside,
         read_schedule,
         [](P p) -> Values { return {joined(schedule_names(p.system), " ")}; }},
        {{"ignore", {"ignore + - F"}, "symbols that contexts skip; [above](#contexts)", "none"},
         Stage::ignore,
         once,
         within,
         [](C c, R r) { r.system.ignored = symbols_of(c, r); },
         [](P p) -> Values { return {p.printer.apart(p.system.ignored)}; }},
        {{"terminals", {"terminals a b"}, "the letters that words of the language have", "all"},
         Stage::terminals,
         once,
         outside,
         [](C c, R r) { r.system.terminals = symbols_of(c, r); },
         [](P p) -> Values { return {p.printer.apart(p.system.terminals)}; }},
        {{"interpret", {"interpret L -> F"}, "what the turtle sees for a symbol", "the symbol"},
         Stage::interpretation,
         repeats,
         outside,
         read_interpretation,
         print_interpretation},
        {{"coding",
          {"coding { a -> 0; b -> 1 }"},
          "the letters that `show`, `derive`, `letter` and `convert` have instead; "
          "[above](#codings)",
          "the letters themselves"},
         other,
         once,
         outside,
         read_coding,
         print_coding},
        {{"environment",
          {"environment ?E y"},
          "what fills a module; [above](#environments)",
          "`?P` position, `?H` heading",
          environment_names()},
         other,
         repeats,
         outside,
         read_environment,
         print_environments},
        {{"angle", {"angle 60"}, "degrees that `+` and `-` turn by", "90"},
         other,
         once,
         outside,
         read_number<&Drawing::angle>,
         print_number<&Drawing::angle>},
        {{"step", {"step 1"}, "length of a step in generation 0", "1"},
         other,
         once,
         outside,
         read_number<&Drawing::step>,
         print_number<&Drawing::step>},
        {{"shrink", {"shrink 1/3"}, "factor on the step for each generation", "1"},
         other,
         once,
         outside,
         read_number<&Drawing::shrink>,
         print_number<&Drawing::shrink>},
        {{"start",
          {"start X Y HEADING", "start upward"},
          "heading 0 looks along +x, 90 along +y; `upward` lets a plant stand, in the plane and in "
          "space; [above](#where-the-turtle-starts)",
          "0 0 0",
          {"upward"}},
         other,
         once,
         outside,
         read_start,
         print_start},
        {{"spin", {"spin 45"}, "added to the heading of the start for each generation", "0"},
         other,
         once,
         outside,
         read_number<&Drawing::spin>,
         print_number<&Drawing::spin>},
        {{"scale",
          {"scale 0.98"},
          "`*` multiplies the turtle's own step by this",
          "`*` means nothing"},
         other,
         once,
         outside,
         read_number<&Drawing::scale>,
         print_number<&Drawing::scale>},
        {{"narrow", {"narrow 0.7"}, "`!` multiplies the width by this", "`!` means nothing"},
         other,
         once,
         outside,
         read_number<&Drawing::narrow>,
         print_number<&Drawing::narrow>},
        {{"plot", {"plot F"}, "`F(x,y)` draws to the point (x,y)", "steps"},
         Stage::plot,
         once,
         outside,
         [](C c, R r) { r.drawing.plotters = symbols_of(c, r); },
         [](P p) -> Values { return {p.printer.apart(p.drawing.plotters)}; }},
        {{"stamp",
          {"stamp S square"},
          "`S` leaves a filled `square`, `circle` or `triangle`; a line for each symbol",
          "`S` means nothing",
          stamp_shapes()},
         Stage::stamp,
         repeats,
         outside,
         read_stamp,
         [](P p) {
             return print_shapes(p.drawing.stamps, p,
                                 [](const auto& stamp) { return shape_name(stamp.shape); });
         }},
        {{"solid",
          {"solid F box"},
          "what a symbol leaves, or how it moves the turtle; [above](#in-space)",
          "it means what it always does",
          solid_words()},
         Stage::solid,
         repeats,
         outside,
         read_solid,
         [](P p) { return print_shapes(p.drawing.solids, p, print_solid); }},
        {{"surface",
          {"surface K leaf"},
          "the surface that a symbol leaves; [above](#in-space)",
          "it means what it always does",
          surface_kinds()},
         Stage::surface,
         repeats,
         outside,
         read_surface,
         [](P p) { return print_shapes(p.drawing.surfaces, p, print_surface); }},
        {{"tropism",
          {"tropism 0 0 -1", "tropism 0 0 -1 before"},
          "where strokes bend to; [above](#in-space)",
          "nowhere"},
         other,
         once,
         outside,
         read_tropism,
         print_tropism},
        {{"susceptibility", {"susceptibility 0.2"}, "how much they do", "1"},
         other,
         once,
         outside,
         read_susceptibility,
         print_number<&Drawing::susceptibility>},
        {{"elasticity",
          {"elasticity T"},
          "`T(e)` makes the susceptibility e, `T(m,a)` m times what it was and a; "
          "[above](#in-space)",
          "it stays"},
         Stage::plot,
         once,
         outside,
         read_elasticity,
         [](P p) -> Values { return {p.printer.apart(p.drawing.elastic)}; }},
        {{"width",
          {"width 2"},
          "of strokes, in points of a picture of the usual size; larger pictures have wider "
          "strokes",
          "1, thinner where strokes are dense"},
         other,
         once,
         outside,
         read_number<&Drawing::width>,
         print_number<&Drawing::width>},
        {{"colour",
          {"colour black red"},
          "names or `#rrggbb`, `'` goes on to the next; `along`, `viridis` and `cividis` run with "
          "the word: "
          "a circle of hues, and two scales from dark to light; `currentColor` is that of the text "
          "around an svg, and black elsewhere",
          "black",
          colour_words()},
         other,
         once,
         outside,
         read_colours,
         [](P p) -> Values { return {joined(p.drawing.colours, " ")}; }},
        {{"turn", {"turn clockwise"}, "`+` turns right", "counter-clockwise", turns()},
         other,
         once,
         outside,
         read_turn,
         [](P p) -> Values { return {p.drawing.clockwise ? "clockwise" : ""}; }},
        {{"camera",
          {"camera 30 20"},
          "how a figure in space is seen: from the azimuth 30 degrees, counter-clockwise from +x "
          "seen from above, 20 degrees above the horizon; `camera 30 20 perspective 40` in "
          "perspective, the figure spanning 40 degrees; from 1 to 120, without a number 40",
          "-60 15",
          {"perspective"}},
         other,
         once,
         outside,
         read_camera,
         print_camera},
        {{"light",
          {"light AZIMUTH ELEVATION"},
          "where the light of a figure in space comes from",
          "over the camera's left shoulder"},
         other,
         once,
         outside,
         read_light,
         [](P p) -> Values { return {p.drawing.light ? print_direction(*p.drawing.light) : ""}; }},
        {{"fog",
          {"fog 0.5"},
          "how much of the background's colour the farthest part takes, from 0 to 1",
          "0"},
         other,
         once,
         outside,
         read_fog,
         print_number<&Drawing::fog>},
        {{"generation",
          {"generation 4", "generation 0..5"},
          "what the figure shows; `draw` and `figures` use it",
          "`-n` must say"},
         other,
         once,
         outside,
         [](C c, R r) { r.drawing.generations = range_of(c, "a generation"); },
         [](P p) { return print_range(p.drawing.generations); }},
        {{"seed",
          {"seed 3", "seed 1..3"},
          "what the figure shows of a system with choices, and `expect` holds of the first",
          "1 if there are probabilities"},
         other,
         once,
         outside,
         [](C c, R r) { r.drawing.seeds = range_of(c, "a seed"); },
         [](P p) { return print_range(p.drawing.seeds); }},
        {{"picture",
          {"picture tree"},
          "what `figures` and `draw` show: a `figure` of the turtle, a `table` of its commands, "
          "the "
          "derivation `tree` of a generation, a `plot` of the lengths of generations",
          "a figure",
          picture_kinds()},
         other,
         once,
         outside,
         [](C c, R r) { r.drawing.picture = word_of(c, picture_kinds()); },
         [](P p) -> Values { return {p.drawing.picture}; }},
        {{"columns", {"columns 3"}, "how many panels stand in a row", "as many as suit"},
         other,
         once,
         outside,
         read_columns,
         [](P p) -> Values {
             return {p.drawing.columns ? std::to_string(*p.drawing.columns) : ""};
         }},
        {{"common-scale",
          {"common-scale yes"},
          "whether panels have one scale; with `no` each figure is as large as its panel",
          "`yes` for generations of which none is 8 times as large as another"},
         other,
         once,
         outside,
         [](C c, R r) {
             r.drawing.common_scale = word_of(c, {"yes", "no"}) == "yes";
         },
         [](P p) -> Values {
             const auto& common = p.drawing.common_scale;
             return {!common ? "" : *common ? "yes" : "no"};
         }},
        {{"label", {"label 0 1 B", "label (0,0,2) top"}, "a text at a point of the figure", ""},
         other,
         repeats,
         outside,
         read_label,
         print_labels},
        {{"expect",
          {"expect segments 4: 768"},
          "what must come out in a generation; [below](#expectations)",
          "",
          expectation_kinds()},
         other,
         repeats,
         outside,
         read_expectation,
         print_expectations}};
    return all;
}

std::vector<StatementHelp> system_statements() {
    std::vector<StatementHelp> all;
    for (const Setting& setting : settings()) all.push_back(setting.help);
    return all;
}

}  // namespace algae
