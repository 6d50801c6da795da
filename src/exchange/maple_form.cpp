#include "exchange/maple_form.hpp"

#include <map>
#include <optional>

#include "exchange/plain_rules.hpp"
#include "notation/characters.hpp"

namespace algae {

namespace {

bool is_one_of(std::string_view symbols, const std::string& name) {
    return name.size() == 1 && symbols.find(name[0]) != std::string_view::npos;
}

/// Refuses what none of the procedures says.
class Check {
public:
    explicit Check(const LSystem& system) : system_(system), form_(form()) {}

    MapleForm all() const {
        rules();
        settings();
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

    void settings() const {
        check_plain_settings(system_, "maple");
        const Settings& settings = system_.settings;
        const auto is_one = [](const std::optional<Quantity>& said) {
            return !said || said->value == 1;
        };
        if (!is_one(settings.shrink)) refuse("steps that shrink");
        if (settings.spin && settings.spin->value != 0) refuse("a spin");
        if (settings.clockwise) refuse("that + turns clockwise");
        if (!settings.stamps.empty()) refuse("stamps");
        if (!settings.solids.empty()) refuse("solids");
        if (form_ == MapleForm::parametric && !is_one(settings.step))
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
            if (name == "*" && system_.settings.scale) refuse("the scale of the symbol *");
            if (name == "!" && system_.settings.narrow) refuse("the setting narrow");
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

    const LSystem& system_;
    const MapleForm form_;
};

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

MapleForm checked_maple_form(const LSystem& system) { return Check(system).all(); }

}  // namespace algae
