#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "base/error.hpp"
#include "exchange/maple_file.hpp"
#include "exchange/maple_words.hpp"
#include "notation/characters.hpp"
#include "notation/print.hpp"

namespace algae {

namespace {

class Worksheet {
public:
    explicit Worksheet(const LSystem& system) : system_(system), form_(form()) {}

    std::string all() {
        check_rules();
        check_settings();
        check_symbols(system_.axiom);
        for (const Production& rule : system_.rules) check_symbols(rule.successor);
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
    [[noreturn]] void refuse(const std::string& what) const {
        throw Error((system_.name.empty() ? "" : system_.name + ": ") +
                    "a worksheet cannot say " + what);
    }
    [[noreturn]] void refuse(const Production& rule, const std::string& what) const {
        refuse(what + ", of the rule " + print_rule(system_.alphabet, rule));
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

    void check_rules() const {
        if (!system_.inner.empty()) refuse("systems within a system");
        if (!system_.tables.empty()) refuse("tables of rules");
        if (!system_.terminals.empty()) refuse("terminals");
        if (!system_.environments.empty()) refuse("environments");
        if (!system_.axiom.splices.empty()) refuse("words as parameters");
        std::map<Symbol, const Production*> first;
        for (const Production& rule : system_.rules) {
            if (rule.shape) refuse(rule, "shapes");
            if (!rule.left.empty() || !rule.right.empty()) refuse(rule, "the context");
            if (!rule.elsewhere.empty()) refuse(rule, "the context condition");
            if (rule.condition) refuse(rule, "the condition");
            if (!rule.successor.splices.empty()) refuse(rule, "words as parameters");
            if (rule.probability && form_ == MapleForm::parametric)
                refuse(rule, "the probability of modules with parameters");
            const auto [found, is_new] = first.emplace(rule.predecessor.symbol, &rule);
            if (form_ == MapleForm::stochastic) {
                if (first.size() > 1) refuse(rule, "probabilities for several predecessors");
            } else if (!is_new) {
                refuse(rule, "a second rule for a symbol");
            }
        }
    }

    void check_settings() const {
        const Settings& settings = system_.settings;
        const auto is_one = [](const std::optional<Quantity>& said) { return !said || said->value == 1; };
        if (!is_one(settings.shrink)) refuse("the setting shrink");
        if (settings.spin && settings.spin->value != 0) refuse("the setting spin");
        if (settings.clockwise) refuse("`turn clockwise`: + turns left");
        if (!settings.plotters.empty()) refuse("the setting plot");
        if (!settings.stamps.empty()) refuse("the setting stamp");
        if (!settings.solids.empty()) refuse("the setting solid");
        if (!settings.surfaces.empty()) refuse("the setting surface");
        if (settings.tropism) refuse("the setting tropism");
        if (form_ != MapleForm::parametric) return;
        if (!is_one(settings.step))
            refuse("the setting step: lengths are the parameters of modules");
    }

    /// Symbols that mean something to the turtle of one side only.
    void check_symbols(const ModuleWord& word) const {
        const Settings& settings = system_.settings;
        for (std::size_t i = 0; i < word.letters.size(); ++i) {
            const Symbol symbol = word.letters[i];
            const std::string& name = this->name(symbol);
            const auto arguments = word.arguments.find(i);
            const std::size_t arity =
                arguments == word.arguments.end() ? 0 : arguments->second.size();
            check_name(name);
            const bool silent = is_silent(symbol, arity);
            const MapleMeaning meaning = maple_meaning(form_, name);
            if (meaning == MapleMeaning::refused || (meaning == MapleMeaning::none && !silent))
                refuse("the symbol " + name + ": it is nothing to the turtle of the procedure");
            if (meaning == MapleMeaning::same && silent && draws(name))
                refuse("the interpretation of " + name);
            if ((name == "*" && settings.scale && !silent) ||
                (name == "!" && settings.narrow && form_ != MapleForm::parametric))
                refuse("the setting " + std::string(name == "*" ? "scale" : "narrow"));
        }
    }

    static bool draws(const std::string& name) {
        return std::string_view("Ff+-&^\\/|[]!@").find(name) != std::string_view::npos;
    }

    void check_name(const std::string& name) const {
        if (first_character(name).bytes != name.size())
            refuse("the symbol " + name + ": symbols are single characters");
        if (name == "\"") refuse("the symbol \": it ends a string");
    }

    /// Whether the interpretation leaves the module out.
    bool is_silent(Symbol symbol, std::size_t arity) const {
        bool silent = false;
        for (const Production& rule : system_.interpretation) {
            if (rule.predecessor.symbol != symbol || rule.predecessor.parameters.size() != arity)
                continue;
            if (!rule.successor.letters.empty() || rule.condition || rule.probability)
                refuse("the interpretation of " + name(symbol));
            silent = true;
        }
        return silent;
    }

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
            check_name(name(rule.predecessor.symbol));
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
    std::string number(const Expression& expression) {
        return text(expression, {});
    }

    std::string text(const Expression& expression, const std::vector<std::string>& parameters) {
        try {
            return maple_text(expression, [&](const std::string& name) {
                const auto found = std::find(parameters.begin(), parameters.end(), name);
                if (found != parameters.end())
                    return "L[" + std::to_string(found - parameters.begin() + 1) + "]";
                return constant(name);
            });
        } catch (const Error& error) {
            refuse(error.what());
        }
    }

    const std::string& constant(const std::string& name) {
        for (const char* kept : {"D", "I", "Pi", "N", "L", "AXIOMA", "PONTOA", "ANGULO", "SEGMENTO",
                                 "vH", "vL", "vU", "Lsystem", "GRAFICO", "restart", "with", "proc"})
            if (name == kept) refuse("the constant " + name + ", which is something else there");
        if (next_name(name) != name) refuse("the constant " + name);
        constants_.insert(name);
        if (name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z' && form_ == MapleForm::parametric &&
            system_.alphabet.find(name))
            refuse("the constant " + name + " beside a module " + name);
        return name;
    }

    static std::string next_name(const std::string& name) {
        Scanner scanner(name, "", {});
        return next_maple_name(scanner);
    }

    std::string modules(const ModuleWord& word, const std::vector<std::string>& parameters) {
        std::string text;
        for (std::size_t i = 0; i < word.letters.size(); ++i) {
            const std::string module = character(word.letters[i]);
            const bool capital = is_capital(module);
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

    static bool is_capital(const std::string& name) {
        return name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z';
    }

    void check_module(Symbol symbol, std::size_t arity) {
        const std::string& name = this->name(symbol);
        if (name.size() == 1 && std::string_view("Ff+-&^\\/!").find(name[0]) != std::string_view::npos &&
            arity == 0)
            refuse("the module " + name + " without its parameter beside modules with theirs");
        if (name.size() == 1 && std::string_view("|@[]").find(name[0]) != std::string_view::npos &&
            arity > 0)
            refuse("parameters of the module " + name);
        const Production* rule = rule_of(symbol);
        if (!rule && is_capital(name)) staying_.insert(name);
        if (rule && rule->predecessor.parameters.size() != arity)
            refuse(*rule, "the module " + name + " with " + std::to_string(arity) +
                              " parameters, which stays,");
    }

    const Production* rule_of(Symbol symbol) const {
        for (const Production& rule : system_.rules)
            if (rule.predecessor.symbol == symbol) return &rule;
        return nullptr;
    }

    std::string function(const Production& rule) {
        const std::string& name = this->name(rule.predecessor.symbol);
        if (!is_capital(name)) refuse(rule, "rules for other than capital letters");
        if (name == "D" || name == "I")
            refuse(rule, "functions called " + name + ", which Maple keeps for itself");
        return name + " := L -> " + modules(rule.successor, rule.predecessor.parameters) + ":\n";
    }

    /// Capital letters that stay need a function too.
    std::string identities() const {
        std::string text;
        for (const std::string& name : staying_) {
            if (name == "D" || name == "I")
                refuse("the module " + name + ", whose name Maple keeps for itself");
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
            text += "PONTOA := [" + shortest_text(*start.x.exact) + "," + shortest_text(*start.y.exact) +
                    "]:\n";
        if (*start.heading.exact != (upward ? 90 : 0))
            text += "ANGULO := " + shortest_text(*start.heading.exact) + "*Pi/180:\n";
        const auto& step = system_.settings.step;
        if (step && step->value != 1) text += "SEGMENTO := " + number(step->expression) + ":\n";
        return text.empty() ? text : "# where the turtle of GRAFICO starts\n" + text;
    }

    std::string constants() {
        std::string text;
        for (std::size_t i = system_.constants.size(); i-- > 0;) {  // those that others use come first
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
