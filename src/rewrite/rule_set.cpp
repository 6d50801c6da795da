#include "rewrite/rule_set.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "rewrite/inner_systems.hpp"
#include "rewrite/module_text.hpp"
#include "rewrite/rule_compiler.hpp"

namespace algae {

namespace {

/// A probability as a part of 2^64, rounded down; all bits for 1.
std::uint64_t threshold(const Rational& sum) {
    if (sum >= 1) return ~std::uint64_t{0};
    return floor(sum * Rational(power(Integer(2), 64))).to_uint64();
}

void add_rule(CompiledRules& rules, const Production& rule) {
    if (rule.shape)
        throw Error(to_string(rule.place) +
                    ": the rule is a shape rule, which divides shapes and not words");
    RuleCompiler compiler(rules, rule);
    Alternatives side = compiler.left_side();
    Successor successor = compiler.successor(rule.successor);
    for (const ModulePattern& module : rule.left)
        if (const std::string& name = rules.system->alphabet.name(module.symbol);
            name == "[" || name == "]")
            throw Error(to_string(rule.place) +
                        ": expected a left context without brackets, a path to the root, "
                        "found '" +
                        name + "'");
    RuleSet& set = rules.tables.at(rule.table);
    const ModuleKind kind =
        rules.kinds.kind(rule.predecessor.symbol, rule.predecessor.parameters.size());
    if (set.of.size() <= kind) set.of.resize(kind + std::size_t{1});
    auto& known = set.of[kind];
    auto same = std::find_if(known.begin(), known.end(), [&](const Alternatives& other) {
        return other.has_same_context(side) && other.condition == side.condition;
    });
    if (same == known.end()) same = known.insert(known.end(), std::move(side));
    if (!rule.probability)
        for (const std::uint32_t other : same->successors)
            if (rules.successors[other].same_as(successor)) return;  // the rule stands there twice
    same->successors.push_back(static_cast<std::uint32_t>(rules.successors.size()));
    if (rule.probability) same->probabilities.push_back(*rule.probability);
    set.has_contexts = set.has_contexts || !same->left.empty() || !same->right.empty() ||
                       !same->elsewhere.empty();  // brackets alone count as no module
    set.has_conditions = set.has_conditions || same->condition;
    set.has_probabilities = set.has_probabilities || rule.probability;
    rules.successors.push_back(std::move(successor));
}

void finish(CompiledRules& rules, RuleSet& set) {
    set.of.resize(rules.kinds.size());
    for (auto& known : set.of) {
        std::stable_sort(
            known.begin(), known.end(),
            [](const Alternatives& a, const Alternatives& b) { return a.context > b.context; });
        for (Alternatives& alternatives : known) {
            for (const ModuleKind kind : alternatives.elsewhere) rules.sought[kind] = 1;
            Rational sum;
            for (const Rational& probability : alternatives.probabilities)
                alternatives.thresholds.push_back(threshold(sum += probability));
        }
    }
}

const Production no_rule;

/// The rules of one system, but for what depends on all kinds of modules; gives its axiom as written.
Successor add_rules(CompiledRules& rules) {
    rules.successors.emplace_back();
    rules.tables.resize(std::max<std::size_t>(1, rules.system->tables.size()));
    Successor axiom = RuleCompiler(rules, no_rule).successor(rules.system->axiom);
    for (const Production& rule : rules.system->rules) add_rule(rules, rule);
    return axiom;
}

void finish(CompiledRules& rules) {
    const LSystem& system = *rules.system;
    rules.sought.assign(rules.kinds.size(), 0);
    for (RuleSet& set : rules.tables) finish(rules, set);
    rules.ignored.assign(rules.kinds.size(), 0);
    rules.opens = rules.closes = rules.ignored;
    for (std::size_t i = 0; i < rules.kinds.size(); ++i) {
        const Symbol letter = rules.kinds.letter(static_cast<ModuleKind>(i));
        rules.ignored[i] = std::count(system.ignored.begin(), system.ignored.end(), letter) > 0;
        rules.opens[i] = system.alphabet.name(letter) == "[";
        rules.closes[i] = system.alphabet.name(letter) == "]";
    }
}

/// Compiles the systems within one, so that all know the same kinds of modules.
void add_inner(CompiledRules& rules) {
    std::vector<CompiledRules> all;
    std::vector<Successor> axioms;
    for (const InnerSystem& inner : rules.system->inner) {
        LSystem system = inner.system;
        system.alphabet = rules.system->alphabet;
        system.constants = rules.system->constants;
        CompiledRules within;
        within.system = std::make_shared<const LSystem>(std::move(system));
        within.of = " of " + inner.name;
        within.inner = std::shared_ptr<InnerSystems>(std::shared_ptr<void>(), rules.inner.get());
        within.kinds = rules.kinds;
        axioms.push_back(add_rules(within));
        rules.kinds = within.kinds;
        all.push_back(std::move(within));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].kinds = rules.kinds;
        finish(all[i]);
        rules.inner->add(Rewriting(std::move(all[i])), std::move(axioms[i]));
    }
}

}  // namespace

bool Successor::same_as(const Successor& other) const {
    const auto same_splice = [](const Splice& a, const Splice& b) {
        return a.at == b.at && a.values_at == b.values_at && a.word == b.word;
    };
    return kinds == other.kinds &&
           std::equal(values.begin(), values.end(), other.values.begin(), other.values.end(),
                      same_value) &&
           std::equal(
               slots.begin(), slots.end(), other.slots.begin(), other.slots.end(),
               [](const Slot& a, const Slot& b) { return a.at == b.at && a.value == b.value; }) &&
           std::equal(splices.begin(), splices.end(), other.splices.begin(), other.splices.end(),
                      same_splice);
}

void append(const Successor& successor, const double* parameters, const WordValues* words,
            ModuleString& to) {
    const auto add = [&to](const auto& kinds, std::size_t kinds_from, std::size_t kinds_to,
                           const auto& values, std::size_t values_from, std::size_t values_to) {
        to.kinds.insert(to.kinds.end(), kinds.data() + kinds_from, kinds.data() + kinds_to);
        to.values.insert(to.values.end(), values.data() + values_from, values.data() + values_to);
    };
    if (successor.splices.empty()) {
        const std::size_t start = to.values.size();
        add(successor.kinds, 0, successor.kinds.size(), successor.values, 0,
            successor.values.size());
        for (const Successor::Slot& slot : successor.slots)
            to.values[start + slot.at] = slot.value.run(parameters);
        return;
    }
    std::vector<double> values = successor.values;
    for (const Successor::Slot& slot : successor.slots)
        values[slot.at] = slot.value.run(parameters);
    std::size_t kind = 0, value = 0;
    for (const Successor::Splice& splice : successor.splices) {
        add(successor.kinds, kind, splice.at, values, value, splice.values_at);
        kind = splice.at;
        value = splice.values_at;
        const double given = splice.word.run(parameters);
        if (!WordValues::is_word(given))
            throw Undefined{splice.expression, "expected a word for '<" +
                                                   to_text(*splice.expression) + ">', found " +
                                                   number_text(given)};
        const ModuleString& word = words->word(given);
        add(word.kinds, 0, word.kinds.size(), word.values, 0, word.values.size());
    }
    add(successor.kinds, kind, successor.kinds.size(), values, value, values.size());
}

CompiledRules compiled_rules(const LSystem& system, const Budget& budget, const ModuleKinds* seen) {
    CompiledRules rules;
    rules.system = std::make_shared<const LSystem>(system);
    if (seen) rules.kinds = *seen;
    if (holds_words(system) || rules.kinds.words()) {
        if (!rules.kinds.words()) rules.kinds.hold(std::make_shared<WordValues>());
        std::vector<std::string> names;
        for (const InnerSystem& inner : system.inner) names.push_back(inner.name);
        rules.inner = std::make_shared<InnerSystems>(std::move(names), rules.kinds.held());
        rules.inner->set_budget(budget);
    }
    const Successor axiom = add_rules(rules);
    if (rules.inner) add_inner(rules);
    finish(rules);
    try {
        append(axiom, nullptr, rules.kinds.words(), rules.axiom);
    } catch (const Undefined& undefined) {
        throw Error(to_string(undefined.at->place) + ": the axiom: " + undefined.reason);
    }
    return rules;
}

}  // namespace algae
