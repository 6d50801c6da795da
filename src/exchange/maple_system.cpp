#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "exchange/detail/formats.hpp"
#include "exchange/detail/maple.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "model/model.hpp"

// Systems from Maple worksheets: the three procedures Lsystem and what their arguments mean.
//
// Strings: each character of axiom and rules is a symbol, `?` stands for the backslash. Stochastic: the same
// with a probability for each rule, of one predecessor; brackets may be round there. Parametric: modules
// ["A",[1,10]], whose rules are functions A := L -> [...] that Maple calls for capital letters only, so every
// capital letter needs one; those that give the module back unchanged are no rules here. The parameters L[1],
// L[2], ... get names that are not taken otherwise.
//
// The turtles of the three procedures know different symbols. What is nothing to a turtle but something in
// the notation is interpreted away (`maple_meaning`), and what cannot be interpreted away is refused at its
// place.

namespace algae {

namespace {

bool is_one_of(std::string_view symbols, const std::string& name) {
    return name.size() == 1 && symbols.find(name[0]) != std::string_view::npos;
}

}  // namespace

MapleMeaning maple_meaning(MapleForm form, const std::string& symbol) {
    const bool parametric = form == MapleForm::parametric;
    const bool stochastic = form == MapleForm::stochastic;
    if (symbol == "$" || (stochastic && is_one_of("&^\\/", symbol))) return MapleMeaning::refused;
    if (is_one_of("G{}.'%", symbol) || (parametric ? symbol == "*" : symbol == "@") ||
        (stochastic && symbol == "|"))
        return MapleMeaning::none;
    return MapleMeaning::same;
}

MapleNeed maple_need(const std::string& symbol) {
    if (is_one_of("Ff+-&^\\/!", symbol)) return MapleNeed::one;
    if (is_one_of("|@[]", symbol)) return MapleNeed::none;
    return MapleNeed::any;
}

bool is_maple_capital(const std::string& symbol) {
    return symbol.size() == 1 && symbol[0] >= 'A' && symbol[0] <= 'Z';
}

namespace {

/// The symbol that a character of a string stands for: `?` for `\`, in the stochastic form `(` and `)`
/// for brackets. Fails at the offset where it is no symbol.
std::string maple_symbol(const Scanner& scanner, MapleForm form, std::string_view character,
                         std::size_t offset) {
    if (character == "?") return "\\";
    if (form == MapleForm::stochastic && character == "(") return "[";
    if (form == MapleForm::stochastic && character == ")") return "]";
    if (character == "\\")
        scanner.fail_at(offset, "expected '?', which stands for the backslash, found '\\'");
    if (undeclared_length(character) != character.size())
        scanner.fail_at(offset,
                        fmt::format("expected a symbol, found {}", algae::quoted(character)));
    return std::string(character);
}

/// Checks that brackets match, one `meet` after the other and `end` last.
class MapleBrackets {
public:
    MapleBrackets(const Scanner& scanner) : scanner_(scanner) {}
    void meet(const std::string& symbol, std::size_t offset) {
        if (symbol == "[") open_.push_back(offset);
        if (symbol != "]") return;
        if (open_.empty()) scanner_.fail_at(offset, "a bracket that closes none");
        open_.pop_back();
    }

    void end() const {
        if (!open_.empty()) scanner_.fail_at(open_.back(), "a bracket that is never closed");
    }

private:
    const Scanner& scanner_;
    std::vector<std::size_t> open_;
};

/// Adds axiom and rules of strings.
class WordReader {
public:
    WordReader(MapleValues& values, Model& system)
        : values_(values),
          scanner_(values.scanner()),
          system_(system),
          form_(values.sheet().arguments.size() == 5 ? MapleForm::stochastic : MapleForm::strings) {
    }

    void all() {
        const auto& arguments = values_.sheet().arguments;
        system_.axiom.letters = word(values_.text(arguments[0], "the axiom, a string"));
        rules(values_.list(arguments[1], "the rules, a list of strings"));
        if (form_ == MapleForm::stochastic)
            probabilities(arguments[2], values_.list(arguments[2], "a list of probabilities"));
    }

private:
    Word word(const MapleValue& text) {
        Word letters;
        MapleBrackets brackets(scanner_);
        std::size_t offset = text.offset + 1;
        for (const std::string_view character : characters(text.text)) {
            const std::string symbol = maple_symbol(scanner_, form_, character, offset);
            if (symbol == "[" || symbol == "]") check_kind(character[0], offset);
            brackets.meet(symbol, offset);
            letters.push_back(known(symbol, offset));
            offset += character.size();
        }
        brackets.end();
        return letters;
    }

    /// The stochastic procedure is printed with ( and ) for brackets; a worksheet has one kind.
    void check_kind(char character, std::size_t offset) {
        const bool round = character == '(' || character == ')';
        if (!round_) round_ = round;
        if (*round_ != round)
            scanner_.fail_at(offset, fmt::format("brackets are written {} before, found '{}'",
                                                 *round_ ? "( )" : "[ ]", character));
    }

    Symbol known(const std::string& name, std::size_t offset) {
        if (const auto found = system_.alphabet.find(name)) return *found;
        const Symbol symbol = system_.alphabet.symbol(name);
        const MapleMeaning meaning = maple_meaning(form_, name);
        if (meaning == MapleMeaning::refused)
            scanner_.fail_at(
                offset,
                fmt::format("{} turns the turtle in space, and is nothing to this procedure",
                            algae::quoted(name)));
        if (meaning == MapleMeaning::none) {
            Production silent;
            silent.predecessor.symbol = symbol;
            system_.interpretation.push_back(std::move(silent));
        }
        return symbol;
    }

    void rules(const MapleValue& list) {
        for (std::size_t i = 0; i < list.items.size(); i += 2) {
            const MapleValue& left = values_.text(list.items[i], "a predecessor, a string");
            const Word predecessor = word(left);
            if (predecessor.size() != 1)
                values_.fail(list.items[i],
                             fmt::format("expected a predecessor of one character, found {}",
                                         algae::quoted(left.text)));
            if (i + 1 == list.items.size())
                values_.fail(list.items[i], fmt::format("the predecessor {} has no successor",
                                                        algae::quoted(left.text)));
            check_new(list.items[i], predecessor.front());
            Production rule;
            rule.predecessor.symbol = predecessor.front();
            rule.successor.letters = word(values_.text(list.items[i + 1], "a successor, a string"));
            system_.rules.push_back(std::move(rule));
        }
    }

    void check_new(const MapleValue& left, Symbol predecessor) {
        const bool is_new = predecessors_.insert(predecessor).second;
        const auto name = [&](Symbol symbol) {
            return algae::quoted(system_.alphabet.name(symbol));
        };
        if (form_ == MapleForm::strings && !is_new)
            values_.fail(left, fmt::format("a second rule for {}, which the procedure never uses",
                                           name(predecessor)));
        if (form_ == MapleForm::stochastic && predecessors_.size() > 1)
            values_.fail(
                left,
                fmt::format("a rule for {} behind one for {}; the probabilities are those of all "
                            "rules, for one predecessor",
                            name(predecessor), name(system_.rules.front().predecessor.symbol)));
    }

    void probabilities(const MapleValue& argument, const MapleValue& list) {
        if (list.items.size() != system_.rules.size())
            values_.fail(argument,
                         fmt::format("expected a probability for each of the {} rules, found {}",
                                     system_.rules.size(), list.items.size()));
        Rational sum;
        for (const MapleValue& item : list.items) {
            const Rational probability = values_.rational(item, "a probability");
            if (sign(probability) <= 0)
                values_.fail(item, fmt::format("expected a probability above 0, found {}",
                                               shortest_text(probability)));
            sum += probability;
        }
        if (!list.items.empty() && sum != 1 && sum != 100)
            values_.fail(
                argument,
                fmt::format("the probabilities add up to {}, expected 100, of percentages, or 1",
                            shortest_text(sum)));
        for (std::size_t i = 0; i < list.items.size(); ++i)
            system_.rules[i].probability = values_.rational(list.items[i], "a probability") / sum;
    }

    MapleValues& values_;
    const Scanner& scanner_;
    Model& system_;
    MapleForm form_;
    std::set<Symbol> predecessors_;
    std::optional<bool> round_;
};

constexpr std::size_t most_parameters = 1000;

/// Adds an axiom of modules and the functions that it calls.
class ModuleReader {
public:
    ModuleReader(MapleValues& values, Model& system)
        : values_(values), scanner_(values.scanner()), system_(system) {}

    void all() {
        const auto& assignments = values_.sheet().assignments;
        system_.axiom =
            word(values_.list(values_.sheet().arguments[0], "the axiom, a list of modules"), 0);
        while (!open_.empty()) {
            const std::string letter = std::move(open_.back());
            open_.pop_back();
            read_rule(letter);
        }
        for (const auto& assignment : assignments)  // in the order of the worksheet
            if (const auto found = rules_.find(assignment.name); found != rules_.end())
                system_.rules.push_back(std::move(found->second));
        name_parameters();
    }

private:
    struct Seen {
        std::size_t arity, offset;
    };

    ModuleWord word(const MapleValue& list, std::size_t parameters) {
        ModuleWord made;
        MapleBrackets brackets(scanner_);
        for (const MapleValue& item : list.items) {
            const MapleValue& module = values_.list(item, "a module, such as [\"F\",[1]]");
            if (module.items.empty() || module.items.size() > 2)
                values_.fail(
                    item,
                    fmt::format(
                        "expected the name of a module and a list of its parameters, found {} "
                        "values",
                        module.items.size()));
            const std::string symbol = name(module.items[0]);
            std::vector<Expression> arguments;
            const bool has_list = module.items.size() == 2;
            if (has_list) arguments = this->arguments(module.items[1], parameters);
            brackets.meet(symbol, item.offset);
            check(symbol, arguments.size(), has_list, item.offset);
            if (!arguments.empty()) made.arguments[made.letters.size()] = std::move(arguments);
            made.letters.push_back(system_.alphabet.symbol(symbol));
        }
        brackets.end();
        return made;
    }

    std::string name(const MapleValue& value) const {
        const MapleValue& text = values_.text(value, "the name of a module, a string");
        if (!is_character(text.text))
            values_.fail(value,
                         fmt::format("expected the name of a module, one character, found {}",
                                     algae::quoted(text.text)));
        return maple_symbol(scanner_, MapleForm::parametric, text.text, text.offset + 1);
    }

    std::vector<Expression> arguments(const MapleValue& value, std::size_t parameters) {
        const MapleValue& list = values_.resolved(value);
        std::vector<Expression> found;
        if (list.kind == MapleValue::Kind::parameters) {
            for (std::size_t i = 1; i <= parameters; ++i)
                found.push_back(entry(list.parameters, i));
            return found;
        }
        for (const MapleValue& item : values_.list(value, "a list of parameters").items) {
            if (item.expression.most_index > parameters)
                values_.fail(item, fmt::format("uses parameter {} of a module that has {}",
                                               item.expression.most_index, parameters));
            found.push_back(values_.number(item, "a parameter, a number"));
        }
        if (found.size() > most_parameters)
            values_.fail(value, "a module with more than 1000 parameters");
        return found;
    }

    static Expression entry(const std::string& list, std::size_t i) {
        return made_expression(Expression::Kind::name, fmt::format("{}[{}]", list, i), {});
    }

    /// What a module needs: parameters for the turtle, and a capital letter a function.
    void check(const std::string& symbol, std::size_t arity, bool has_list, std::size_t offset) {
        const MapleMeaning meaning = maple_meaning(MapleForm::parametric, symbol);
        if (meaning == MapleMeaning::refused)
            scanner_.fail_at(offset, fmt::format("{} is nothing to this procedure, expected '@'",
                                                 algae::quoted(symbol)));
        if (maple_need(symbol) == MapleNeed::one && arity == 0)
            scanner_.fail_at(offset, fmt::format("the module {} has no parameter", shown(symbol)));
        if (maple_need(symbol) == MapleNeed::none && has_list)
            scanner_.fail_at(offset, fmt::format("the module {} takes no parameters", symbol));
        if (meaning == MapleMeaning::none && silent_.insert({symbol, arity}).second) {
            Production silent;
            silent.predecessor.symbol = system_.alphabet.symbol(symbol);
            for (std::size_t i = 1; i <= arity; ++i)
                silent.predecessor.parameters.push_back("p" + std::to_string(i));
            system_.interpretation.push_back(std::move(silent));
        }
        const MapleValue* function = values_.sheet().find(symbol);
        const bool has_function = function && function->kind == MapleValue::Kind::function;
        if (!is_maple_capital(symbol)) {
            if (has_function)
                values_.fail(
                    *function,
                    fmt::format("the procedure rewrites capital letters alone, and never calls {}",
                                algae::quoted(symbol)));
            return;
        }
        if (!has_function)
            scanner_.fail_at(
                offset,
                fmt::format("no function is assigned to the capital letter {0}; one that stays "
                            "needs {0} := L -> [[\"{0}\",L]]",
                            symbol));
        if (!has_list)
            scanner_.fail_at(
                offset,
                fmt::format("the module {0} has no list for its function, expected [\"{0}\",[]]",
                            symbol));
        if (is_identity(*function, symbol)) return;
        const auto [seen, is_new] = seen_.emplace(symbol, Seen{arity, offset});
        if (seen->second.arity != arity)
            scanner_.fail_at(
                offset,
                fmt::format("the module {} has {} parameters here and {} in line {}", symbol, arity,
                            seen->second.arity, scanner_.source().place(seen->second.offset).line));
        if (is_new) open_.push_back(symbol);
    }

    static std::string shown(const std::string& symbol) { return symbol == "\\" ? "?" : symbol; }

    /// Whether it is L -> [["F",L]].
    static bool is_identity(const MapleValue& function, const std::string& symbol) {
        const MapleValue& list = function.items.front();
        if (list.items.size() != 1 || list.items[0].items.size() != 2) return false;
        const std::vector<MapleValue>& module = list.items[0].items;
        return module[0].kind == MapleValue::Kind::text && module[0].text == symbol &&
               module[1].kind == MapleValue::Kind::parameters;
    }

    void read_rule(const std::string& letter) {
        const MapleValue& function = *values_.sheet().find(letter);
        const std::size_t arity = seen_.at(letter).arity;
        Production rule;
        rule.predecessor.symbol = system_.alphabet.symbol(letter);
        for (std::size_t i = 1; i <= arity; ++i)
            rule.predecessor.parameters.push_back(entry(function.parameters, i).name);
        rule.successor = word(function.items.front(), arity);
        ModuleWord same{{rule.predecessor.symbol}, {}};
        for (std::size_t i = 1; i <= arity; ++i)
            same.arguments[0].push_back(entry(function.parameters, i));
        if (rule.successor != same) rules_.emplace(letter, std::move(rule));
    }

    /// L[1] becomes p1, or a longer name where a constant is called so.
    void name_parameters() {
        std::string prefix = "p";
        for (const auto& [name, value] : values_.constants())
            while (name.starts_with(prefix)) prefix += 'p';
        for (Production& rule : system_.rules) {
            for (std::string& name : rule.predecessor.parameters) name = prefix + number_in(name);
            for (auto& [position, arguments] : rule.successor.arguments)
                for (Expression& argument : arguments) rename(argument, prefix);
        }
    }

    static std::string number_in(const std::string& entry) {
        const std::size_t open = entry.find('[');
        return entry.substr(open + 1, entry.size() - open - 2);
    }

    static void rename(Expression& expression, const std::string& prefix) {
        if (expression.kind == Expression::Kind::name && expression.name.ends_with(']'))
            expression.name = prefix + number_in(expression.name);
        for (Expression& operand : expression.operands) rename(operand, prefix);
    }

    MapleValues& values_;
    const Scanner& scanner_;
    Model& system_;
    std::map<std::string, Seen> seen_;
    std::vector<std::string> open_;  // letters whose functions are still to be read
    std::map<std::string, Production> rules_;
    std::set<std::pair<std::string, std::size_t>> silent_;
};

/// Whether the three numbers of a vector are these.
bool is_vector(const MapleValues& values, const MapleValue& list, const std::vector<int>& entries) {
    return std::ranges::equal(list.items, entries, [&](const MapleValue& item, int entry) {
        return values.rational(item, "a number") == entry;
    });
}

void read_position(const MapleValues& values, const MapleValue& said, Drawing::Start& start) {
    const MapleValue& point = values.list(said, "the position, a list of coordinates");
    if (point.items.size() != 2 && point.items.size() != 3)
        values.fail(said,
                    fmt::format("expected two or three coordinates, found {}", point.items.size()));
    if (point.items.size() == 3 &&
        !values.rational(point.items[2], "the third coordinate").is_zero())
        values.fail(point.items[2], "expected 0: figures begin in the plane of x and y");
    start.x = quantity(values.rational(point.items[0], "a coordinate"));
    start.y = quantity(values.rational(point.items[1], "a coordinate"));
}

/// An angle in radians as degrees.
Quantity degrees(const MapleValues& values, const MapleValue& said) {
    const Rational pi("3.14159265358979323846264338327950288419716939937511");
    return quantity(values.rational(said, "the heading, radians such as Pi/2") * 180 / pi);
}

/// Where the turtle starts: as GRAFICO says, if the worksheet holds it; otherwise along x, in the
/// stochastic procedure upward.
void read_start(MapleValues& values, MapleForm form, Model& system) {
    Drawing::Start start{quantity(0), quantity(0),
                         quantity(form == MapleForm::stochastic ? 90 : 0)};
    const auto& said = values.sheet().start;
    if (const auto found = said.find("PONTOA"); found != said.end())
        read_position(values, found->second, start);
    if (const auto found = said.find("ANGULO"); found != said.end())
        start.heading = degrees(values, found->second);
    const std::pair<const char*, std::vector<int>> frame[] = {
        {"vH", {1, 0, 0}}, {"vL", {0, 1, 0}}, {"vU", {0, 0, 1}}};
    for (const auto& [name, entries] : frame)
        if (const auto found = said.find(name); found != said.end())
            if (!is_vector(values, values.list(found->second, "a vector"), entries))
                values.fail(
                    found->second,
                    fmt::format(
                        "expected {} as in the procedure: figures in space begin along x, with "
                        "z up",
                        name));
    const bool at_rest =
        start.x.exact->is_zero() && start.y.exact->is_zero() && start.heading.exact->is_zero();
    if (!at_rest) system.drawing.start = start;
    if (const auto found = said.find("SEGMENTO"); found != said.end()) {
        const Quantity step = values.setting(found->second, "the length of a step");
        if (!(step.value > 0)) values.fail(found->second, "expected a length above 0");
        if (step.value != 1) system.drawing.step = step;
    }
}

void read_generation(const MapleValues& values, const MapleValue& said, Model& system) {
    if (bare_name(said) == "N" && !values.sheet().find("N")) return;
    const Rational count = values.rational(said, "the number of steps");
    if (!count.is_integer() || sign(count) < 0 || count >= power(Rational(2), 63))
        values.fail(said,
                    fmt::format("expected a whole number of steps from 0 to 2^63 - 1, found {}",
                                shortest_text(count)));
    const std::uint64_t generation = std::stoull(to_string(count));
    system.drawing.generations = {generation, generation};
}

}  // namespace

Model read_maple(std::string_view text, const std::string& name) {
    Scanner scanner(text, name, {"#"}, '>');
    const MapleWorksheet sheet = read_maple_worksheet(scanner);
    MapleValues values(scanner, sheet);
    const std::vector<MapleValue>& arguments = sheet.arguments;
    if (arguments.size() != 2 && arguments.size() != 4 && arguments.size() != 5)
        scanner.fail_at(
            sheet.call,
            fmt::format("expected Lsystem(AXIOMA, REGRAS, INCREMENTO, N), Lsystem(AXIOMA, REGRAS, "
                        "PROB, INCREMENTO, N) or Lsystem(AXIOMA, N), found {} arguments",
                        arguments.size()));
    const MapleForm form = arguments.size() == 2   ? MapleForm::parametric
                           : arguments.size() == 4 ? MapleForm::strings
                                                   : MapleForm::stochastic;
    Model system;
    if (form == MapleForm::parametric)
        ModuleReader(values, system).all();
    else
        WordReader(values, system).all();
    if (form != MapleForm::parametric)
        system.drawing.angle =
            values.setting(arguments[arguments.size() - 2], "the increment, degrees");
    read_start(values, form, system);
    read_generation(values, arguments.back(), system);
    system.constants = values.constants();
    return read_written(print_lsystem(system), name);
}

}  // namespace algae
