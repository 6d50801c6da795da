#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "exchange/detail/formats.hpp"
#include "exchange/detail/maple.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "model/model.hpp"

// Systems as Maple worksheets.
//
// First the system is checked (`Check`): which of the three procedures can say it, the one with parameters if
// a module has any, the stochastic one if a rule has a probability, and what none can say, which is refused
// by name. Then the worksheet is written: constants that are really used, functions, where the turtle of
// GRAFICO starts, and the call. What has to be asked of a module while it is written, such as a parameter for
// the turtle, is asked there.

namespace algae {

namespace {

/// Prints with the brackets that Maple asks for: none may stand before a sign or between powers.
class ExpressionPrinter {
public:
    explicit ExpressionPrinter(std::function<std::string(const std::string&)> name_text)
        : name_text_(std::move(name_text)) {}

    enum Binding { sign, sum, product, atom };

    std::string text(const Expression& expression, Binding least) const {
        const auto [bare, binding] = bare_text(expression);
        return binding < least ? "(" + bare + ")" : bare;
    }

private:
    using Bare = std::pair<std::string, Binding>;

    [[noreturn]] static void fail(const Expression& expression) {
        throw Error(algae::quoted(to_text(expression)) + " in arithmetic");
    }

    Bare bare_text(const Expression& expression) const {
        switch (expression.kind) {
            case Expression::Kind::number: {
                const std::string text = shortest_text(expression.value);
                return {text, text.starts_with('-')             ? sign
                              : exact_decimal(expression.value) ? atom
                                                                : product};
            }
            case Expression::Kind::name:
                return {name_text_(expression.name), atom};
            case Expression::Kind::unary:
                if (expression.name != "-") break;
                return {"-" + text(expression.operands[0], atom), sign};
            case Expression::Kind::binary:
                return binary_text(expression);
            case Expression::Kind::call:
                return call_text(expression);
            case Expression::Kind::word:
                break;
        }
        fail(expression);
    }

    Bare binary_text(const Expression& expression) const {
        const std::string& name = expression.name;
        const bool adds = name == "+" || name == "-", multiplies = name == "*" || name == "/";
        if (!adds && !multiplies && name != "^") fail(expression);
        const Binding own = adds ? sum : multiplies ? product : atom;
        const Binding tighter = adds ? product : atom;
        const std::string text = this->text(expression.operands[0], own) + name +
                                 this->text(expression.operands[1], tighter);
        // A power may be a factor and no base.
        return {text, name == "^" ? product : own};
    }

    Bare call_text(const Expression& expression) const {
        const auto* function =
            std::find_if(std::begin(maple_functions), std::end(maple_functions),
                         [&](const MapleFunction& one) { return expression.name == one.name; });
        if (function == std::end(maple_functions)) fail(expression);
        const bool angle = function->angle == MapleFunction::Angle::argument;
        const std::string arguments = joined(expression.operands, ",", [&](const Expression& one) {
            return text(one, angle ? product : sign);
        });
        const std::string call = function->maple + ("(" + arguments);
        if (angle) return {call + "*Pi/180)", atom};
        if (function->angle == MapleFunction::Angle::value) return {call + ")*180/Pi", product};
        return {call + ")", atom};
    }

    std::function<std::string(const std::string&)> name_text_;
};

/// Refuses what none of the procedures says.
class Check : FormatWriter {
public:
    explicit Check(const Model& system) : FormatWriter(system, "maple"), form_(form()) {}

    MapleForm all() const {
        rules();
        drawing();
        symbols(system_.axiom);
        for (const Production& rule : system_.rules) {
            check_name(name(rule.predecessor.symbol));
            symbols(rule.successor);
        }
        return form_;
    }

private:
    MapleForm form() const {
        bool parametric = !system_.axiom.arguments.empty(), stochastic = false;
        for (const Production& rule : system_.rules) {
            parametric = parametric || !rule.predecessor.parameters.empty() ||
                         !rule.successor.arguments.empty();
            stochastic = stochastic || rule.probability.has_value();
        }
        return parametric   ? MapleForm::parametric
               : stochastic ? MapleForm::stochastic
                            : MapleForm::strings;
    }

    void rules() const {
        check_parts();
        if (!system_.axiom.splices.empty()) refuse("the axiom's words");
        std::map<Symbol, const Production*> first;
        for (const Production& rule : system_.rules) {
            if (const std::string why = beyond_plain(rule, true); !why.empty()) refuse(rule, why);
            if (!rule.successor.splices.empty()) refuse(rule, "it holds words");
            if (rule.probability && form_ == MapleForm::parametric)
                refuse(rule, "it has a probability beside modules with parameters");
            const bool is_new = first.emplace(rule.predecessor.symbol, &rule).second;
            if (form_ == MapleForm::stochastic && first.size() > 1)
                refuse(rule, "the rules have several predecessors, and one list of probabilities");
            if (form_ != MapleForm::stochastic && !is_new)
                refuse(rule, "it is the second for its letter");
        }
    }

    void drawing() const {
        check_plain_settings();
        const Drawing& drawing = system_.drawing;
        if (!is_usual(drawing.shrink, 1)) refuse("steps that shrink");
        if (!is_usual(drawing.spin, 0)) refuse("a spin");
        if (drawing.clockwise) refuse("that + turns clockwise");
        if (!drawing.stamps.empty()) refuse("stamps");
        if (!drawing.solids.empty()) refuse("solids");
        if (form_ == MapleForm::parametric && !is_usual(drawing.step, 1))
            refuse("a step beside lengths as parameters");
    }

    /// Symbols that mean something to one of the turtles alone.
    void symbols(const ModuleWord& word) const {
        for (std::size_t i = 0; i < word.letters.size(); ++i) {
            const Symbol symbol = word.letters[i];
            const std::string& name = this->name(symbol);
            const auto arguments = word.arguments.find(i);
            check_name(name);
            const bool silent =
                is_silent(symbol, arguments == word.arguments.end() ? 0 : arguments->second.size());
            const MapleMeaning meaning = maple_meaning(form_, name);
            if (meaning == MapleMeaning::refused || (meaning == MapleMeaning::none && !silent))
                refuse("the symbol " + name + ", which is nothing to its turtle");
            if (meaning == MapleMeaning::same && silent && maple_need(name) != MapleNeed::any)
                refuse("the interpretation of " + name);
            if (form_ == MapleForm::parametric || silent) continue;
            if (name == "*" && system_.drawing.scale) refuse("the scale of the symbol *");
            if (name == "!" && system_.drawing.narrow) refuse("the setting narrow");
        }
    }

    void check_name(const std::string& name) const {
        if (!is_character(name)) refuse("the symbol " + name + ", which has several characters");
        if (name == "\"") refuse("the symbol \", which ends a string");
    }

    /// Whether the interpretation leaves the module out.
    bool is_silent(Symbol symbol, std::size_t arity) const {
        bool silent = false;
        for (const Production& rule : system_.interpretation) {
            if (rule.predecessor.symbol != symbol || rule.predecessor.parameters.size() != arity)
                continue;
            if (!rule.successor.letters.empty() || !rule.successor.splices.empty() ||
                rule.condition || rule.probability)
                refuse("the interpretation of " + name(symbol));
            silent = true;
        }
        return silent;
    }

    const MapleForm form_;
};

class Worksheet : FormatWriter {
public:
    explicit Worksheet(const Model& system)
        : FormatWriter(system, "maple"), form_(Check(system).all()) {}

    std::string all() {
        std::string call;
        if (form_ == MapleForm::parametric) {
            for (const Production& rule : system_.rules) functions_ += function(rule);
            call = "AXIOMA := " + modules(system_.axiom, {}) + ":\nLsystem(AXIOMA, ";
            functions_ += identities();
        } else {
            call = "Lsystem(" + string(system_.axiom.letters) + ", " + rules() + ", ";
            if (form_ == MapleForm::stochastic) call += probabilities() + ", ";
            call += number(angle()) + ", ";
        }
        const auto& generations = system_.drawing.generations;
        call += (generations ? std::to_string(generations->second) : "N") + ");\n";
        const std::string start = this->start();
        return commented("# ", {system_.title, system_.source}) + constants() + functions_ + start +
               call;
    }

private:
    std::string character(Symbol symbol) const {
        const std::string& text = name(symbol);
        return text == "\\" ? "?" : text;
    }
    std::string string(const Word& word) const {
        std::string text = "\"";
        for (const Symbol symbol : word) text += character(symbol);
        return text + '"';
    }

    std::string rules() const {
        const bool many = system_.rules.size() > 1;
        const std::string all = joined(system_.rules, ",", [&](const Production& rule) {
            return (many ? "\n  " : "") + string({rule.predecessor.symbol}) + ", " +
                   string(rule.successor.letters);
        });
        return "[" + all + (many ? "\n]" : "]");
    }

    /// Percentages where they are whole, as the procedure draws from 1 to 100; otherwise fractions.
    std::string probabilities() const {
        const bool whole = std::ranges::all_of(system_.rules, [](const Production& rule) {
            return (*rule.probability * 100).is_integer();
        });
        return "[" +
               joined(system_.rules, ",",
                      [&](const Production& rule) {
                          return shortest_text(*rule.probability * (whole ? 100 : 1));
                      }) +
               "]";
    }

    Expression angle() const {
        return system_.drawing.angle ? system_.drawing.angle->expression : quantity(90).expression;
    }

    /// The text of an expression without parameters; its constants will be assigned.
    std::string number(const Expression& expression) { return text(expression, {}); }

    std::string text(const Expression& expression, const std::vector<std::string>& parameters) {
        const auto place = [&](const std::string& name) {
            return std::find(parameters.begin(), parameters.end(), name) - parameters.begin();
        };
        const auto is_parameter = [&](const std::string& name) {
            return place(name) < static_cast<std::ptrdiff_t>(parameters.size());
        };
        meet_constants(expression, is_parameter);
        try {
            return ExpressionPrinter([&](const std::string& name) {
                       return is_parameter(name) ? "L[" + std::to_string(place(name) + 1) + "]"
                                                 : name;
                   })
                .text(expression, ExpressionPrinter::sign);
        } catch (const Error& error) {
            refuse(error.what());
        }
    }

    template <class IsParameter>
    void meet_constants(const Expression& expression, const IsParameter& is_parameter) {
        if (expression.kind == Expression::Kind::name && !is_parameter(expression.name) &&
            constants_.insert(expression.name).second)
            check_constant(expression.name);
        for (const Expression& operand : expression.operands) meet_constants(operand, is_parameter);
    }

    void check_constant(const std::string& name) const {
        for (const char* kept : {"D", "I", "Pi", "N", "L", "AXIOMA", "PONTOA", "ANGULO", "SEGMENTO",
                                 "vH", "vL", "vU", "Lsystem", "GRAFICO", "restart", "with", "proc"})
            if (name == kept) refuse("the constant " + name + ": the name is taken");
        const auto is_plain = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
        if (!std::all_of(name.begin(), name.end(), is_plain))
            refuse("the constant " + name + ": names have letters of ASCII");
        if (is_maple_capital(name) && form_ == MapleForm::parametric && system_.alphabet.find(name))
            refuse("the constant " + name + " beside a module " + name);
    }

    std::string modules(const ModuleWord& word, const std::vector<std::string>& parameters) {
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < word.letters.size(); ++i) {
            const std::string module = character(word.letters[i]);
            std::vector<std::string> list;
            if (const auto arguments = word.arguments.find(i); arguments != word.arguments.end())
                for (const Expression& argument : arguments->second)
                    list.push_back(text(argument, parameters));
            const bool has_list = !list.empty() || is_maple_capital(module);
            texts.push_back(fmt::format(
                "[\"{}\"{}]", module, has_list ? fmt::format(",[{}]", fmt::join(list, ",")) : ""));
            check_module(word.letters[i], list.size());
        }
        return fmt::format("[{}]", fmt::join(texts, ", "));
    }

    void check_module(Symbol symbol, std::size_t arity) {
        const std::string& name = this->name(symbol);
        if (maple_need(name) == MapleNeed::one && arity == 0)
            refuse("the module " + name + " without a parameter beside modules that have some");
        if (maple_need(name) == MapleNeed::none && arity > 0)
            refuse("parameters of the module " + name);
        const auto rule = std::ranges::find(
            system_.rules, symbol, [](const Production& one) { return one.predecessor.symbol; });
        const bool has_rule = rule != system_.rules.end();
        if (!has_rule && is_maple_capital(name)) staying_.insert(name);
        if (has_rule && rule->predecessor.parameters.size() != arity)
            refuse(*rule,
                   fmt::format("a module {} with another number of parameters, {}, would not "
                               "stay",
                               name, arity));
    }

    std::string function(const Production& rule) {
        const std::string& name = this->name(rule.predecessor.symbol);
        if (!is_maple_capital(name))
            refuse(rule, "functions are called for the capital letters A to Z alone");
        if (name == "D" || name == "I")
            refuse(rule, "Maple keeps the name " + name + " for itself");
        return name + " := L -> " + modules(rule.successor, rule.predecessor.parameters) + ":\n";
    }

    /// Capital letters that stay need a function too.
    std::string identities() const {
        std::string text;
        for (const std::string& name : staying_) {
            if (name == "D" || name == "I")
                refuse("the module " + name + ": Maple keeps the name for itself");
            text += name + " := L -> [[\"" + name + "\",L]]:\n";
        }
        return text;
    }

    /// Where GRAFICO starts, if not as it is printed.
    std::string start() {
        const bool upward = form_ == MapleForm::stochastic;
        Drawing::Start start{quantity(0), quantity(0), quantity(0)};
        if (system_.drawing.start) start = *system_.drawing.start;
        for (const Quantity* one : {&start.x, &start.y, &start.heading})
            if (!one->exact) refuse("the start " + to_text(one->expression) + ", no fraction");
        std::string text;
        if (!start.x.exact->is_zero() || !start.y.exact->is_zero())
            text += "PONTOA := [" + shortest_text(*start.x.exact) + "," +
                    shortest_text(*start.y.exact) + "]:\n";
        if (*start.heading.exact != (upward ? 90 : 0))
            text += "ANGULO := " + shortest_text(*start.heading.exact) + "*Pi/180:\n";
        const auto& step = system_.drawing.step;
        if (step && step->value != 1) text += "SEGMENTO := " + number(step->expression) + ":\n";
        return text.empty() ? text : "# where the turtle of GRAFICO starts\n" + text;
    }

    std::string constants() {
        std::string text;
        for (std::size_t i = system_.constants.size();
             i-- > 0;) {  // those that others use come first
            const auto& [name, value] = system_.constants[i];
            if (!constants_.contains(name)) continue;
            text.insert(0, name + " := " + number(value.expression) + ":\n");
        }
        return text;
    }

    const MapleForm form_;
    std::string functions_;
    std::set<std::string> constants_, staying_;
};

}  // namespace

std::string print_maple(const Model& system) { return Worksheet(with_plain_angle(system)).all(); }

}  // namespace algae
