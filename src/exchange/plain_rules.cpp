#include <algorithm>
#include <set>

#include "model/model.hpp"

#include "exchange/detail/plain_rules.hpp"

namespace algae {

namespace {

/// What of a rule is more than a letter and a word; empty if nothing.
std::string beyond_plain(const Production& rule) {
    if (!rule.left.empty() || !rule.right.empty()) return "it has a context";
    if (!rule.elsewhere.empty()) return "it has a context condition";
    if (rule.condition) return "it has a condition";
    if (rule.shape) return "it is a shape rule";
    if (!rule.predecessor.parameters.empty()) return "it has parameters";
    return "";
}

/// The modules that interpretations give, and how many steps that takes.
class Interpreter {
public:
    Interpreter(const LSystem& system, const std::string& format)
        : system_(system), format_(format) {}

    std::vector<TurtleModule> modules;

    void visit(const TurtleModule& module, std::size_t depth) {
        const Production* found = nullptr;
        for (const Production& rule : system_.interpretation) {
            if (rule.predecessor.symbol != module.symbol ||
                rule.predecessor.parameters.size() != module.parameters.size())
                continue;
            if (rule.probability || found)
                cannot_say(system_, format_, rule, "it is one of several interpretations");
            if (const std::string why = beyond_plain(rule); !why.empty())
                cannot_say(system_, format_, rule, why);
            if (!rule.successor.splices.empty())
                cannot_say(system_, format_, rule, "it holds words");
            found = &rule;
        }
        if (!found) return modules.push_back(module);
        constexpr std::size_t most = 1000, most_steps = 100'000;
        if (depth == most || ++steps_ == most_steps || modules.size() > most)
            cannot_say(system_, format_, *found, "it goes round in circles or gives too much");
        const ModuleWord& word = found->successor;
        for (std::size_t i = 0; i < word.letters.size(); ++i) {
            TurtleModule part{word.letters[i], {}};
            if (const auto arguments = word.arguments.find(i); arguments != word.arguments.end())
                for (const Expression& argument : arguments->second)
                    part.parameters.push_back(evaluate(
                        argument, [&](const std::string& name) { return constant(name); }));
            visit(part, depth + 1);
        }
    }

private:
    const Quantity* constant(const std::string& name) const {
        for (const auto& [known, value] : system_.constants)
            if (known == name) return &value;
        return nullptr;
    }

    const LSystem& system_;
    const std::string& format_;
    std::size_t steps_ = 0;
};

}  // namespace

void cannot_say(const LSystem& system, const std::string& format, const Production& rule,
                const std::string& why) {
    const std::string place = rule.place.line > 0 ? to_string(rule.place) : system.name;
    throw Error((place.empty() ? "" : place + ": ") + format + " cannot say the rule " +
                print_rule(system.alphabet, rule) + ": " + why);
}

void cannot_say(const LSystem& system, const std::string& format, const std::string& what) {
    throw Error((system.name.empty() ? "" : system.name + ": ") + format + " cannot say " + what);
}

void check_plain_rules(const LSystem& system, const std::string& format, bool choices) {
    if (!system.inner.empty()) cannot_say(system, format, "systems within a system");
    if (!system.tables.empty()) cannot_say(system, format, "tables");
    if (!system.terminals.empty()) cannot_say(system, format, "terminals");
    if (!system.axiom.arguments.empty()) cannot_say(system, format, "the axiom's parameters");
    if (!system.axiom.splices.empty()) cannot_say(system, format, "the axiom's words");
    std::set<Symbol> seen;
    for (const Production& rule : system.rules) {
        std::string why = beyond_plain(rule);
        if (!rule.successor.arguments.empty()) why = "it has parameters";
        if (!rule.successor.splices.empty()) why = "it holds words";
        if (!choices && rule.probability) why = "it has a probability";
        if (!choices && why.empty() && !seen.insert(rule.predecessor.symbol).second)
            why = "it is the second for its letter";
        if (!why.empty()) cannot_say(system, format, rule, why);
    }
}

std::vector<TurtleModule> interpreted(const LSystem& system, Symbol letter,
                                      const std::string& format) {
    Interpreter interpreter(system, format);
    interpreter.visit({letter, {}}, 0);
    return std::move(interpreter.modules);
}

void check_plain_settings(const Model& system, const std::string& format) {
    const Drawing& drawing = system.drawing;
    if (!system.environments.empty()) cannot_say(system, format, "environments");
    if (drawing.tropism) cannot_say(system, format, "a tropism");
    if (!drawing.surfaces.empty()) cannot_say(system, format, "surfaces");
    if (!drawing.plotters.empty()) cannot_say(system, format, "plots");
}

}  // namespace algae
