#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "notation/rule_grammar.hpp"
#include "notation/rules.hpp"

namespace algae {

namespace {

/// A text that is the same for two rules just when they apply to the same letters in the same
/// places: symbols and arities of the patterns, and the condition with its parameters numbered.
class LeftSide {
public:
    explicit LeftSide(const Production& production) : names_(parameters(production)) {
        key_ = std::to_string(production.table) + '/';
        add(production.left);
        add({production.predecessor});
        add(production.right);
        add(production.elsewhere);
        if (production.condition) add(*production.condition);
    }

    const std::string& key() const { return key_; }

private:
    void add(const Pattern& pattern) {
        for (const ModulePattern& module : pattern) {
            key_ += std::to_string(module.symbol) + '(';
            for (const std::string& name : module.parameters) add_name(name);
            key_ += ')';
        }
        key_ += '/';
    }
    void add(const Expression& expression) {
        key_ += '(';
        if (expression.kind == Expression::Kind::number)
            key_ += to_string(expression.value);
        else
            add_name(expression.name);
        for (const Expression& operand : expression.operands) add(operand);
        key_ += ')';
    }
    void add_name(const std::string& name) {
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (names_[i] == name) {
                key_ += '$' + std::to_string(i) + ',';
                return;
            }
        key_ += name + ',';
    }

    std::vector<std::string> names_;
    std::string key_;
};

struct Alternatives {
    const Production* with = nullptr;     // the first rule with a probability
    const Production* without = nullptr;  // the first rule without
    Rational sum;
};

}  // namespace

void check_probabilities(const std::vector<Production>& rules, Reading& reading) {
    if (reading.broken_rules) return;  // the missing rule may have the missing probability
    std::map<std::string, Alternatives> all;
    for (const Production& rule : rules) {
        Alternatives& alternatives = all[LeftSide(rule).key()];
        const Production*& first = rule.probability ? alternatives.with : alternatives.without;
        if (!first) first = &rule;
        if (rule.probability) alternatives.sum += *rule.probability;
    }
    for (const auto& [key, alternatives] : all) {
        if (!alternatives.with) continue;
        const std::string& name =
            reading.system.alphabet.name(alternatives.with->predecessor.symbol);
        if (alternatives.without)
            reading.findings.add(alternatives.without->place,
                                 "expected a probability, as other rules of " + name + " have one");
        else if (alternatives.sum != 1)
            reading.findings.add(alternatives.with->place,
                                 "the probabilities of " + name + " add up to " +
                                     to_string(alternatives.sum) + ", expected 1");
    }
}

}  // namespace algae
