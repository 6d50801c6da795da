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
        std::string arguments;
        const bool angle = function->angle == MapleFunction::Angle::argument;
        for (const Expression& one : expression.operands)
            arguments += (arguments.empty() ? "" : ",") + text(one, angle ? product : sign);
        const std::string call = function->maple + ("(" + arguments);
        if (angle) return {call + "*Pi/180)", atom};
        if (function->angle == MapleFunction::Angle::value) return {call + ")*180/Pi", product};
        return {call + ")", atom};
    }

    std::function<std::string(const std::string&)> name_text_;
};

/// Refuses what none of the procedures says.
class Check {
public:
    explicit Check(const Model& system) : system_(system), form_(form()) {}

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
    [[noreturn]] void refuse(const std::string& what) const { cannot_say(system_, "maple", what); }
    [[noreturn]] void refuse(const Production& rule, const std::string& why) const {
        cannot_say(system_, "maple", rule, why);
    }
    const std::string& name(Symbol symbol) const { return system_.alphabet.name(symbol); }

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
        if (!system_.inner.empty()) refuse("systems within a system");
        if (!system_.tables.empty()) refuse("tables");
        if (!system_.terminals.empty()) refuse("terminals");
        if (!system_.axiom.splices.empty()) refuse("the axiom's words");
        std::map<Symbol, const Production*> first;
        for (const Production& rule : system_.rules) {
            if (!rule.left.empty() || !rule.right.empty()) refuse(rule, "it has a context");
            if (!rule.elsewhere.empty()) refuse(rule, "it has a context condition");
            if (rule.condition) refuse(rule, "it has a condition");
            if (rule.shape) refuse(rule, "it is a shape rule");
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
        check_plain_settings(system_, "maple");
        const Drawing& drawing = system_.drawing;
        const auto is_one = [](const std::optional<Quantity>& said) {
            return !said || said->value == 1;
        };
        if (!is_one(drawing.shrink)) refuse("steps that shrink");
        if (drawing.spin && drawing.spin->value != 0) refuse("a spin");
        if (drawing.clockwise) refuse("that + turns clockwise");
        if (!drawing.stamps.empty()) refuse("stamps");
        if (!drawing.solids.empty()) refuse("solids");
        if (form_ == MapleForm::parametric && !is_one(drawing.step))
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
        if (first_character(name).bytes != name.size())
            refuse("the symbol " + name + ", which has several characters");
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

    const Model& system_;
    const MapleForm form_;
};

class Worksheet {
public:
    explicit Worksheet(const Model& system) : system_(system), form_(Check(system).all()) {}

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
        return comments() + constants() + functions_ + start + call;
    }

private:
    [[noreturn]] void refuse(const std::string& what) const { cannot_say(system_, "maple", what); }
    [[noreturn]] void refuse(const Production& rule, const std::string& why) const {
        cannot_say(system_, "maple", rule, why);
    }
    const std::string& name(Symbol symbol) const { return system_.alphabet.name(symbol); }

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
        std::string text;
        for (const Production& rule : system_.rules) {
            text += text.empty() ? "" : ",";
            text += many ? "\n  " : "";
            text += string({rule.predecessor.symbol}) + ", " + string(rule.successor.letters);
        }
        return "[" + text + (many ? "\n]" : "]");
    }

    /// Percentages where they are whole, as the procedure draws from 1 to 100; otherwise fractions.
    std::string probabilities() const {
        bool whole = true;
        for (const Production& rule : system_.rules)
            whole = whole && (*rule.probability * 100).is_integer();
        std::string text;
        for (const Production& rule : system_.rules)
            text += (text.empty() ? "" : ",") +
                    shortest_text(whole ? *rule.probability * 100 : *rule.probability);
        return "[" + text + "]";
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
        std::string text;
        for (std::size_t i = 0; i < word.letters.size(); ++i) {
            const std::string module = character(word.letters[i]);
            const bool capital = is_maple_capital(module);
            const auto arguments = word.arguments.find(i);
            text += (text.empty() ? "[\"" : ", [\"") + module + '"';
            std::string list;
            const std::size_t arity =
                arguments == word.arguments.end() ? 0 : arguments->second.size();
            for (std::size_t k = 0; k < arity; ++k)
                list += (list.empty() ? "" : ",") + this->text(arguments->second[k], parameters);
            if (arity > 0 || capital) text += ",[" + list + "]";
            text += "]";
            check_module(word.letters[i], arity);
        }
        return "[" + text + "]";
    }

    void check_module(Symbol symbol, std::size_t arity) {
        const std::string& name = this->name(symbol);
        if (maple_need(name) == MapleNeed::one && arity == 0)
            refuse("the module " + name + " without a parameter beside modules that have some");
        if (maple_need(name) == MapleNeed::none && arity > 0)
            refuse("parameters of the module " + name);
        const Production* rule = rule_of(symbol);
        if (!rule && is_maple_capital(name)) staying_.insert(name);
        if (rule && rule->predecessor.parameters.size() != arity)
            refuse(*rule, "a module " + name + " with another number of parameters, " +
                              std::to_string(arity) + ", would not stay");
    }

    const Production* rule_of(Symbol symbol) const {
        for (const Production& rule : system_.rules)
            if (rule.predecessor.symbol == symbol) return &rule;
        return nullptr;
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

    std::string comments() const {
        std::string text;
        for (const std::string* line : {&system_.title, &system_.source})
            if (!line->empty()) text += "# " + *line + "\n";
        return text;
    }

    const Model& system_;
    const MapleForm form_;
    std::string functions_;
    std::set<std::string> constants_, staying_;
};

}  // namespace

std::string print_maple(const Model& system) { return Worksheet(system).all(); }

}  // namespace algae
