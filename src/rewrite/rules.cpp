#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "rewrite/detail/inner_systems.hpp"
#include "rewrite/rewrite.hpp"

// Rules compiled: for each table and each kind of module (a letter with its number of parameters) the rules that may apply, with their
// contexts, conditions and successors as programs over the parameters of the left side.
//
// A condition is split into its conjuncts, and each is tested as soon as the modules that it names are known, so that the search for a
// context gives up early. Systems within a system are compiled together with it, since all must know the same kinds.

namespace algae {

namespace {

/// The conjuncts of a condition, from left to right.
void split(const Expression& condition, std::vector<const Expression*>& parts) {
    if (condition.kind == Expression::Kind::binary && condition.name == "&")
        for (const Expression& part : condition.operands) split(part, parts);
    else
        parts.push_back(&condition);
}
/// Compiles one rule: its left side with what it asks for, and successors whose arguments are programs
/// over the parameters of that side.
class RuleCompiler {
public:
    /// Both must outlive the compiler.
    RuleCompiler(CompiledRules& rules, const Production& rule) : rules_(rules), rule_(rule) {
        add_names(rule.predecessor);
        for (const Pattern* pattern : {&rule.left, &rule.right, &rule.elsewhere})
            for (const ModulePattern& module : *pattern) {
                add_names(module);
                if (pattern == &rule.elsewhere) known_.push_back(names_.size());
            }
    }

    /// The contexts, the condition and how many parameters there are; without alternatives.
    Alternatives left_side() {
        Alternatives side;
        side.left = kinds(rule_.left);
        side.right = kinds(rule_.right);
        side.elsewhere = kinds(rule_.elsewhere);
        for (const auto* pattern : {&side.left, &side.right, &side.elsewhere})
            for (const ModuleKind kind : *pattern) side.context += !is_bracket(kind);
        side.parameters = names_.size();
        if (rule_.condition) side.condition = program(*rule_.condition, true);
        if (rule_.condition && !rule_.elsewhere.empty()) {
            std::vector<const Expression*> parts;
            split(*rule_.condition, parts);
            for (const Expression* part : parts) {
                Program holds = program(*part, true);
                side.conjuncts.push_back({items_needed(holds), std::move(holds)});
            }
            std::stable_sort(
                side.conjuncts.begin(), side.conjuncts.end(),
                [](const auto& a, const auto& b) { return a.elsewhere < b.elsewhere; });
        }
        return side;
    }

    /// What the rule makes, or the axiom, in which no parameters stand.
    Successor successor(const ModuleWord& word) {
        Successor out;
        out.rule = &rule_;
        auto arguments = word.arguments.begin();
        auto splices = word.splices.begin();
        for (std::size_t i = 0;; ++i) {
            if (splices != word.splices.end() && splices->first == i)
                for (const Expression& expression : (splices++)->second)
                    out.splices.push_back({static_cast<std::uint32_t>(i),
                                           static_cast<std::uint32_t>(out.values.size()),
                                           program(expression, false), &expression});
            if (i == word.letters.size()) break;
            const bool bare = arguments == word.arguments.end() || arguments->first != i;
            const std::size_t arity = bare ? 0 : arguments->second.size();
            out.kinds.push_back(rules_.kinds.kind(word.letters[i], arity));
            if (bare) continue;
            for (const Expression& argument : arguments->second) add_value(argument, out);
            ++arguments;
        }
        return out;
    }

private:
    void add_names(const ModulePattern& module) {
        names_.insert(names_.end(), module.parameters.begin(), module.parameters.end());
    }

    bool is_bracket(ModuleKind kind) const {
        const std::string& name = rules_.system->alphabet.name(rules_.kinds.letter(kind));
        return name == "[" || name == "]";
    }

    std::vector<ModuleKind> kinds(const Pattern& pattern) {
        std::vector<ModuleKind> out;
        for (const ModulePattern& module : pattern)
            out.push_back(rules_.kinds.kind(module.symbol, module.parameters.size()));
        return out;
    }

    /// The value of a word in quotes, whose arguments are the same everywhere.
    double literal(const ModuleWord& word) {
        ModuleString out;
        const Successor written = successor(word);
        append(written, nullptr, rules_.kinds.words(), out);
        return rules_.inner->value(std::move(out));
    }

    Program program(const Expression& expression, bool number) {
        WordValues* const held = rules_.kinds.held().get();
        const WordsOfPrograms words{rules_.inner.get(), held && held->is_exact() ? held : nullptr,
                                    [this](const ModuleWord& word) { return literal(word); },
                                    number && held};
        return Program(
            expression,
            [&](const std::string& name) -> std::optional<std::size_t> {
                const auto found = std::find(names_.begin(), names_.end(), name);
                if (found == names_.end()) return std::nullopt;
                return static_cast<std::size_t>(found - names_.begin());
            },
            [&](const std::string& name) -> const Quantity* {
                for (const auto& [constant, value] : rules_.system->constants)
                    if (constant == name) return &value;
                return nullptr;
            },
            words);
    }

    void add_value(const Expression& argument, Successor& out) {
        Program value = program(argument, false);
        const auto constant = value.constant();
        if (!constant)
            out.slots.push_back({static_cast<std::uint32_t>(out.values.size()), std::move(value)});
        out.values.push_back(constant.value_or(0));
    }

    /// How many of the modules elsewhere must be known before it can be worked out.
    std::size_t items_needed(const Program& holds) const {
        const auto reads = holds.reads();
        const std::size_t names = reads.empty() ? 0 : reads.back() + 1;
        std::size_t items = 0;
        const std::size_t before = known_.front() - rule_.elsewhere.front().parameters.size();
        if (names > before)
            while (known_[items++] < names) {
            }
        return items;
    }

    CompiledRules& rules_;
    const Production& rule_;
    std::vector<std::string> names_;
    std::vector<std::size_t> known_;  // after each module elsewhere, how many names there are
};

/// A probability as a part of 2^64, rounded down; all bits for 1.
std::uint64_t threshold(const Rational& sum) {
    if (sum >= 1) return ~std::uint64_t{0};
    return floor(sum * Rational(power(Integer(2), 64))).to_uint64();
}

/// Throws Error where a right context leaves a branch that it has not gone into; where brackets are ignored they are no branches.
void check_right_context(const LSystem& system, const Production& rule) {
    const auto brackets = brackets_of(system.alphabet);
    const auto is_ignored = [&](Symbol a) {
        return std::find(system.ignored.begin(), system.ignored.end(), a) != system.ignored.end();
    };
    if (!brackets || (is_ignored(brackets->open) && is_ignored(brackets->close))) return;
    std::size_t open = 0;
    for (const ModulePattern& module : rule.right) {
        if (module.symbol == brackets->open) ++open;
        if (module.symbol != brackets->close || open-- > 0) continue;
        throw Error(to_string(rule.place) +
                    ": expected a right context that is a tree, found a ']' that closes nothing");
    }
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
    check_right_context(*rules.system, rule);
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
                                                   words->text(given)};
        const ModuleString& word = words->word(given);
        add(word.kinds, 0, word.kinds.size(), word.values, 0, word.values.size());
    }
    add(successor.kinds, kind, successor.kinds.size(), values, value, values.size());
}

CompiledRules compiled_rules(const LSystem& system, const Budget& budget, const ModuleKinds* seen,
                             Arithmetic arithmetic) {
    CompiledRules rules;
    rules.system = std::make_shared<const LSystem>(system);
    if (seen) rules.kinds = *seen;
    if (!rules.kinds.words() && (holds_words(system) || arithmetic == Arithmetic::exact)) {
        rules.kinds.hold(std::make_shared<WordValues>(arithmetic));
        rules.kinds.held()->set_memory(budget.memory);
    }
    if (holds_words(system) || (rules.kinds.words() && !rules.kinds.words()->is_exact())) {
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
        const std::string text =
            to_string(undefined.at->place) + ": the axiom: " + undefined.reason;
        if (undefined.is_undecided) throw UndecidedValue(text);
        throw Error(text);
    }
    return rules;
}

}  // namespace algae
