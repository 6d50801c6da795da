#include <algorithm>
#include <cctype>
#include <functional>
#include <set>

#include "base/error.hpp"
#include "exchange/maple_expression.hpp"
#include "exchange/maple_file.hpp"
#include "exchange/maple_form.hpp"
#include "exchange/plain_rules.hpp"

namespace algae {

namespace {

class Worksheet {
public:
    explicit Worksheet(const LSystem& system)
        : system_(system), form_(checked_maple_form(system)) {}

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
        const auto& generations = system_.settings.generations;
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
        return system_.settings.angle ? system_.settings.angle->expression
                                      : quantity(90).expression;
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
            return maple_text(expression, [&](const std::string& name) {
                return is_parameter(name) ? "L[" + std::to_string(place(name) + 1) + "]" : name;
            });
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
        Settings::Start start{quantity(0), quantity(0), quantity(0)};
        if (system_.settings.start) start = *system_.settings.start;
        for (const Quantity* one : {&start.x, &start.y, &start.heading})
            if (!one->exact) refuse("the start " + to_text(one->expression) + ", no fraction");
        std::string text;
        if (!start.x.exact->is_zero() || !start.y.exact->is_zero())
            text += "PONTOA := [" + shortest_text(*start.x.exact) + "," +
                    shortest_text(*start.y.exact) + "]:\n";
        if (*start.heading.exact != (upward ? 90 : 0))
            text += "ANGULO := " + shortest_text(*start.heading.exact) + "*Pi/180:\n";
        const auto& step = system_.settings.step;
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

    const LSystem& system_;
    const MapleForm form_;
    std::string functions_;
    std::set<std::string> constants_, staying_;
};

}  // namespace

std::string print_maple(const LSystem& system) { return Worksheet(system).all(); }

}  // namespace algae
