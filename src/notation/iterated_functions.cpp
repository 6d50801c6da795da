#include <algorithm>
#include <cmath>

#include "nature/nature.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

// Iterated function systems, `.ifs`, graph-directed ones too.
//
// A map is written by its six numbers, `map a b c d e f`, for (x,y) -> (a x + b y + e, c x + d y + f), or as
// a similarity by its ratio, its angle and its shift; behind them may stand a probability and `-> STATE`.
// With several states a line `state NAME` comes before the maps that leave it. The numbers stay expressions,
// because the dimension of an attractor is computed exactly from the ratios: a map written by six numbers
// gets a ratio if it is a similarity, that is if (a, c) and (b, d) have equal length and a right angle
// between them: d = a and b = -c (a turn), or d = -a and b = c (a reflection). The signs are compared exactly
// where the numbers are rational, otherwise by the text of the expressions, so a similarity may be missed but
// none is invented.

namespace algae {

namespace {

using Map = IteratedFunctions::Map;

Expression number(const Rational& value) { return quantity(value).expression; }

Expression made(Expression::Kind kind, const char* name, std::vector<Expression> operands) {
    Expression expression;
    expression.kind = kind;
    expression.name = name;
    expression.operands = std::move(operands);
    return expression;
}

Expression binary(const char* operation, Expression left, Expression right) {
    return made(Expression::Kind::binary, operation, {std::move(left), std::move(right)});
}

Expression call(const char* function, Expression argument) {
    return made(Expression::Kind::call, function, {std::move(argument)});
}

Expression square(const Expression& value) { return binary("^", value, number(2)); }

/// Whether two numbers are equal, or one the negative of the other: exactly where both are exact, by
/// their text otherwise.
bool same(const Quantity& left, const Quantity& right) {
    if (left.exact && right.exact) return *left.exact == *right.exact;
    return to_text(left.expression) == to_text(right.expression);
}

bool opposite(const Quantity& left, const Quantity& right) {
    if (left.exact && right.exact) return *left.exact == -*right.exact;
    const std::string a = to_text(left.expression), b = to_text(right.expression);
    return a == "-" + b || b == "-" + a;
}

/// The ratio of a map that is a similarity.
std::optional<Expression> ratio_of(const std::array<Quantity, 6>& n) {
    const bool turns = same(n[0], n[3]) && opposite(n[1], n[2]);
    const bool reflects = opposite(n[0], n[3]) && same(n[1], n[2]);
    if (!turns && !reflects) return std::nullopt;
    const Quantity &a = n[0], &c = n[2];
    if (c.exact && c.exact->is_zero() && a.exact) return number(abs(*a.exact));
    if (a.exact && a.exact->is_zero() && c.exact) return number(abs(*c.exact));
    if (a.exact && c.exact) return call("sqrt", number(*a.exact * *a.exact + *c.exact * *c.exact));
    return call("sqrt", binary("+", square(a.expression), square(c.expression)));
}

/// The words before `->`, and the state behind it.
std::size_t take_state(const GeneratorFile& file, const GeneratorStatement& statement,
                       std::vector<GeneratorWord>& words, const std::vector<std::string>& states) {
    const auto arrow = std::find_if(words.begin(), words.end(),
                                    [](const GeneratorWord& word) { return word.text == "->"; });
    if (arrow == words.end()) {
        if (states.size() > 1)
            file.fail(statement,
                      "expected -> and a state behind the numbers: the system has several");
        return 0;
    }
    if (words.end() - arrow != 2) file.fail(statement, *arrow, "expected one state behind ->");
    const std::string name = (arrow + 1)->text;
    const auto state = std::find(states.begin(), states.end(), name);
    if (state == states.end())
        file.fail(statement, *(arrow + 1),
                  "no state of that name; expected one that a line `state " + name + "` begins");
    words.erase(arrow, words.end());
    return static_cast<std::size_t>(state - states.begin());
}

Map read_map(const GeneratorFile& file, const GeneratorStatement& statement,
             const std::vector<std::string>& states) {
    std::vector<GeneratorWord> words = statement.words;
    Map made;
    made.to = take_state(file, statement, words, states);
    const bool similar = statement.key == "similarity";
    const std::size_t least = similar ? 4 : 6;
    if (words.size() < least || words.size() > least + 1)
        file.fail(statement, "expected " + statement.key +
                                 (similar ? " ratio degrees e f" : " a b c d e f") +
                                 " [probability], found " + counted(words.size(), "value"));
    std::vector<Quantity> values;
    for (const GeneratorWord& word : words) values.push_back(file.quantity(statement, word));
    if (values.size() > least) made.probability = values.back();
    if (!similar) {
        std::copy_n(values.begin(), 6, made.numbers.begin());
        made.ratio = ratio_of(made.numbers);
    } else {
        made.similarity = std::pair(values[0], values[1]);
        const auto part = [&](const char* function, bool negative) {
            Expression product =
                binary("*", values[0].expression, call(function, values[1].expression));
            if (negative) product = binary("-", number(0), std::move(product));
            return evaluate(product, {});
        };
        made.numbers = {part("cos", false), part("sin", true), part("sin", false),
                        part("cos", false), values[2],         values[3]};
        made.ratio = values[0].expression;
        if (values[0].value < 0) file.fail(statement, words[0], "expected a ratio of at least 0");
    }
    const auto& n = made.numbers;
    made.map = {n[0].value, n[1].value, n[2].value, n[3].value, n[4].value, n[5].value};
    return made;
}

std::vector<Point> read_start(const GeneratorFile& file, const GeneratorStatement& statement) {
    const std::string& first = statement.words.front().text;
    if (first == "square") return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    if (first == "triangle") return {{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}};
    std::vector<Point> corners;
    for (const GeneratorWord& word : statement.words) {
        if (!word.text.starts_with('('))
            file.fail(statement, word,
                      "expected start square, triangle, or corners such as (0,0) (1,0) (0,1)");
        corners.push_back(file.point(statement, word));
    }
    return corners;
}

std::unique_ptr<Generator> make_ifs(const GeneratorFile& file) {
    auto system = std::make_unique<IteratedFunctions>();
    file.describe(*system);
    std::vector<std::string> states;
    for (const GeneratorStatement& statement : file.statements)
        if (statement.key == "state") {
            const std::string& name = file.only_word(statement, "NAME").text;
            if (std::find(states.begin(), states.end(), name) != states.end())
                file.fail(statement, statement.words.front(),
                          "the state " + name + " is said twice");
            states.push_back(name);
        }
    if (!states.empty()) system->states = states;
    std::optional<std::size_t> state;
    std::size_t in_state = 0;
    for (const GeneratorStatement& statement : file.statements) {
        if (statement.key == "state") {
            state = state ? *state + 1 : 0;
            in_state = 0;
        }
        if (statement.key != "map" && statement.key != "similarity") continue;
        if (!states.empty() && !state)
            file.fail(statement, "expected a line `state NAME` before the first map");
        Map map = read_map(file, statement, system->states);
        map.from = state.value_or(0);
        map.name = "map " + std::to_string(++in_state);
        if (!states.empty()) map.name += " of the state " + states[map.from];
        if (statement.place.line > 0)
            map.name += " (line " + std::to_string(statement.place.line) + ")";
        system->maps.push_back(std::move(map));
    }
    system->points = file.natural("points", 1, std::uint64_t{1} << 40);
    system->generations = file.range("generation", 1000);
    system->seed = file.natural("seed", 0, ~std::uint64_t{0}).value_or(1);
    if (const GeneratorStatement* from = file.find("from")) {
        system->from = file.point(*from, file.only_word(*from, "(x,y)"));
    }
    if (const GeneratorStatement* start = file.find("start"))
        system->start = read_start(file, *start);
    system->check();
    return system;
}

}  // namespace

GeneratorKind ifs_kind() {
    return {"ifs",
            "an iterated function system",
            {{"state", "NAME", true},
             {"map", "a b c d e f [probability] [-> STATE]", true},
             {"similarity", "ratio degrees e f [probability] [-> STATE]", true},
             {"points", "N"},
             {"generation", "N or N..M"},
             {"seed", "S"},
             {"from", "(x,y)"},
             {"start", "square, triangle or corners (x,y) (x,y) (x,y) ..."}},
            make_ifs};
}

GeneratorFile ifs_file(const IteratedFunctions& system) {
    GeneratorFile file;
    file.name = system.name;
    if (!system.title.empty()) file.add("title", {system.title});
    if (!system.source.empty()) file.add("source", {system.source});
    for (std::size_t state = 0; state < system.states.size(); ++state) {
        if (!system.states[state].empty()) file.add("state", {system.states[state]});
        for (const Map& map : system.maps) {
            if (map.from != state) continue;
            std::vector<std::string> words;
            const auto add = [&](const Quantity& number) {
                words.push_back(to_text(number.expression));
            };
            if (map.similarity) {
                add(map.similarity->first);
                add(map.similarity->second);
                std::for_each(map.numbers.begin() + 4, map.numbers.end(), add);
            } else {
                std::for_each(map.numbers.begin(), map.numbers.end(), add);
            }
            if (map.probability) words.push_back(to_text(map.probability->expression));
            if (system.states.size() > 1 || !system.states[state].empty()) {
                words.push_back("->");
                words.push_back(system.states[map.to]);
            }
            file.add(map.similarity ? "similarity" : "map", words);
        }
    }
    return file;
}

}  // namespace algae
