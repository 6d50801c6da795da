#include "exchange/detail/plain_rules.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace algae {

namespace {

/// Lets all rules stand in the whole file.
void clear_places(LSystem& system) {
    for (auto* rules : {&system.rules, &system.interpretation})
        for (Production& rule : *rules) rule.place.line = rule.place.column = 0;
    system.axiom_place.line = system.axiom_place.column = 0;
    for (InnerSystem& inner : system.inner) clear_places(inner.system);
}

}  // namespace

Model read_written(const std::string& text, const std::string& file) {
    try {
        Model system = read_lsystem(text, file);
        clear_places(system);
        return system;
    } catch (const Diagnostics& error) {
        throw Error(file +
                    ": the notation cannot say this system: " + error.findings().front().message);
    }
}

std::string beyond_plain(const Production& rule, bool parameters) {
    if (!rule.left.empty() || !rule.right.empty()) return "it has a context";
    if (!rule.elsewhere.empty()) return "it has a context condition";
    if (rule.condition) return "it has a condition";
    if (rule.shape) return "it is a shape rule";
    if (!parameters && !rule.predecessor.parameters.empty()) return "it has parameters";
    return "";
}

Model with_plain_angle(const Model& system) {
    const auto is_turn = [&](Symbol letter) {
        const std::string& said = system.alphabet.name(letter);
        return said.size() == 1 && std::string_view("+-&^/\\").find(said) != std::string_view::npos;
    };
    // The angles of turns, by their letters.
    std::map<Symbol, Rational> angles;
    const auto is_angle = [&](const Production& rule) {
        const Symbol turn = rule.predecessor.symbol;
        const ModuleWord& image = rule.successor;
        if (!is_turn(turn) || !beyond_plain(rule, false).empty() || rule.probability ||
            image.letters != Word{turn} || !image.arguments.contains(0))
            return false;
        const std::vector<Expression>& numbers = image.arguments.at(0);
        return numbers.size() == 1 && numbers[0].kind == Expression::Kind::number &&
               angles.emplace(turn, numbers[0].value).second;
    };
    Model plain = system;
    std::erase_if(plain.interpretation, is_angle);
    if (angles.empty()) return system;
    const Rational angle = angles.begin()->second;
    for (const auto& [turn, other] : angles)
        if (other != angle) return system;
    // The other turns without a number would turn by another angle.
    const auto has_other = [&](const ModuleWord& word) {
        for (std::size_t i = 0; i < word.letters.size(); ++i)
            if (is_turn(word.letters[i]) && !word.arguments.contains(i) &&
                !angles.contains(word.letters[i]))
                return true;
        return false;
    };
    if (has_other(plain.axiom)) return system;
    for (const auto* rules : {&plain.rules, &plain.interpretation})
        for (const Production& rule : *rules)
            if (has_other(rule.successor) ||
                (rules == &plain.interpretation && angles.contains(rule.predecessor.symbol)))
                return system;
    // A number means its own sense, a turn without one that of the file.
    if (plain.drawing.clockwise) return system;
    plain.drawing.angle = quantity(angle);
    return plain;
}

void FormatWriter::refuse(const std::string& what) const {
    throw Error((system_.name.empty() ? "" : system_.name + ": ") + format_ + " cannot say " +
                what);
}

void FormatWriter::refuse(const Production& rule, const std::string& why) const {
    const std::string place = rule.place.line > 0 ? to_string(rule.place) : system_.name;
    throw Error((place.empty() ? "" : place + ": ") + format_ + " cannot say the rule " +
                print_rule(system_.alphabet, rule) + ": " + why);
}

void FormatWriter::check_parts() const {
    if (!system_.inner.empty()) refuse("systems within a system");
    if (!system_.tables.empty()) refuse("tables");
    if (!system_.terminals.empty()) refuse("terminals");
}

void FormatWriter::check_plain_rules(bool choices) const {
    check_parts();
    if (!system_.axiom.arguments.empty()) refuse("the axiom's parameters");
    if (!system_.axiom.splices.empty()) refuse("the axiom's words");
    std::set<Symbol> seen;
    for (const Production& rule : system_.rules) {
        std::string why = beyond_plain(rule, false);
        if (!rule.successor.arguments.empty()) why = "it has parameters";
        if (!rule.successor.splices.empty()) why = "it holds words";
        if (!choices && rule.probability) why = "it has a probability";
        if (!choices && why.empty() && !seen.insert(rule.predecessor.symbol).second)
            why = "it is the second for its letter";
        if (!why.empty()) refuse(rule, why);
    }
}

void FormatWriter::check_plain_settings() const {
    const Drawing& drawing = system_.drawing;
    if (!system_.coding.empty()) refuse("a coding");
    if (!system_.environments.empty()) refuse("environments");
    if (drawing.tropism) refuse("a tropism");
    if (!drawing.surfaces.empty()) refuse("surfaces");
    if (!drawing.plotters.empty()) refuse("plots");
}

void FormatWriter::check_programs() const {
    check_parts();
    check_plain_settings();
    const Drawing& drawing = system_.drawing;
    if (!drawing.stamps.empty()) refuse("stamps");
    if (!drawing.solids.empty()) refuse("solids");
    if (drawing.scale) refuse("the setting scale");
    if (drawing.narrow) refuse("the setting narrow");
    if (!system_.axiom.splices.empty()) refuse("the axiom's words");
    check_first_wins();
    for (const Production& rule : system_.rules) {
        if (rule.shape) refuse(rule, "it is a shape rule");
        if (!rule.elsewhere.empty()) refuse(rule, "it looks elsewhere in the word");
        if (!rule.successor.splices.empty()) refuse(rule, "it holds words");
    }
}

void FormatWriter::check_first_wins() const {
    std::set<std::vector<std::size_t>> seen;  // letters with their numbers of parameters, by place
    for (const Production& rule : system_.rules) {
        if (rule.probability || rule.condition) continue;
        std::vector<std::size_t> key;
        for (const Pattern& part : {rule.left, Pattern{rule.predecessor}, rule.right}) {
            key.push_back(part.size());
            for (const ModulePattern& one : part) {
                key.push_back(one.symbol);
                key.push_back(one.parameters.size());
            }
        }
        if (!seen.insert(std::move(key)).second)
            refuse(rule,
                   "it is one of several for its letter, of which the first is always taken there");
    }
}

std::vector<const Production*> FormatWriter::rules_by_reach() const {
    const auto reach = [&](const Pattern& pattern) {
        return std::ranges::count_if(pattern, [&](const ModulePattern& one) {
            return name(one.symbol) != "[" && name(one.symbol) != "]";
        });
    };
    std::vector<const Production*> rules;
    for (const Production& rule : system_.rules) rules.push_back(&rule);
    std::ranges::stable_sort(rules, std::greater<>(), [&](const Production* rule) {
        return reach(rule->left) + reach(rule->right);
    });
    return rules;
}

void FormatWriter::interpret(const TurtleModule& module, std::size_t depth, std::size_t& steps,
                             std::vector<TurtleModule>& modules) const {
    const Production* found = nullptr;
    for (const Production& rule : system_.interpretation) {
        if (rule.predecessor.symbol != module.symbol ||
            rule.predecessor.parameters.size() != module.parameters.size())
            continue;
        if (rule.probability || found) refuse(rule, "it is one of several interpretations");
        if (const std::string why = beyond_plain(rule, false); !why.empty()) refuse(rule, why);
        if (!rule.successor.splices.empty()) refuse(rule, "it holds words");
        found = &rule;
    }
    if (!found) return modules.push_back(module);
    constexpr std::size_t most = 1000, most_steps = 100'000;
    if (depth == most || ++steps == most_steps || modules.size() > most)
        refuse(*found, "it goes round in circles or gives too much");
    const auto constant = [&](const std::string& name) -> const Quantity* {
        const auto known =
            std::ranges::find(system_.constants, name, &std::pair<std::string, Quantity>::first);
        return known == system_.constants.end() ? nullptr : &known->second;
    };
    const ModuleWord& word = found->successor;
    for (std::size_t i = 0; i < word.letters.size(); ++i) {
        TurtleModule part{word.letters[i], {}};
        if (const auto arguments = word.arguments.find(i); arguments != word.arguments.end())
            for (const Expression& argument : arguments->second)
                part.parameters.push_back(evaluate(argument, constant));
        interpret(part, depth + 1, steps, modules);
    }
}

std::vector<TurtleModule> FormatWriter::interpreted(Symbol letter) const {
    std::vector<TurtleModule> modules;
    std::size_t steps = 0;
    interpret({letter, {}}, 0, steps, modules);
    return modules;
}

}  // namespace algae
