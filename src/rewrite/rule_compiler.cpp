#include "rewrite/rule_compiler.hpp"

#include <algorithm>
#include <utility>

#include "rewrite/inner_systems.hpp"

namespace algae {

namespace {

/// The conjuncts of a condition, from left to right.
void split(const Expression& condition, std::vector<const Expression*>& parts) {
    if (condition.kind == Expression::Kind::binary && condition.name == "&")
        for (const Expression& part : condition.operands) split(part, parts);
    else
        parts.push_back(&condition);
}
}  // namespace

RuleCompiler::RuleCompiler(CompiledRules& rules, const Production& rule)
    : rules_(rules), rule_(rule) {
    add_names(rule.predecessor);
    for (const Pattern* pattern : {&rule.left, &rule.right, &rule.elsewhere})
        for (const ModulePattern& module : *pattern) {
            add_names(module);
            if (pattern == &rule.elsewhere) known_.push_back(names_.size());
        }
}

Alternatives RuleCompiler::left_side() {
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
        std::stable_sort(side.conjuncts.begin(), side.conjuncts.end(),
                         [](const auto& a, const auto& b) { return a.elsewhere < b.elsewhere; });
    }
    return side;
}

/// What the rule makes, or the axiom, in which no parameters stand.
Successor RuleCompiler::successor(const ModuleWord& word) {
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

void RuleCompiler::add_names(const ModulePattern& module) {
    names_.insert(names_.end(), module.parameters.begin(), module.parameters.end());
}

bool RuleCompiler::is_bracket(ModuleKind kind) const {
    const std::string& name = rules_.system->alphabet.name(rules_.kinds.letter(kind));
    return name == "[" || name == "]";
}

std::vector<ModuleKind> RuleCompiler::kinds(const Pattern& pattern) {
    std::vector<ModuleKind> out;
    for (const ModulePattern& module : pattern)
        out.push_back(rules_.kinds.kind(module.symbol, module.parameters.size()));
    return out;
}

/// The value of a word in quotes, whose arguments are the same everywhere.
double RuleCompiler::literal(const ModuleWord& word) {
    ModuleString out;
    const Successor written = successor(word);
    append(written, nullptr, rules_.kinds.words(), out);
    return rules_.inner->value(std::move(out));
}

Program RuleCompiler::program(const Expression& expression, bool number) {
    const WordsOfPrograms words{rules_.inner.get(),
                                [this](const ModuleWord& word) { return literal(word); },
                                number && rules_.inner};
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

void RuleCompiler::add_value(const Expression& argument, Successor& out) {
    Program value = program(argument, false);
    const auto constant = value.constant();
    if (!constant)
        out.slots.push_back({static_cast<std::uint32_t>(out.values.size()), std::move(value)});
    out.values.push_back(constant.value_or(0));
}

/// How many of the modules elsewhere must be known before it can be worked out.
std::size_t RuleCompiler::items_needed(const Program& holds) const {
    const auto reads = holds.reads();
    const std::size_t names = reads.empty() ? 0 : reads.back() + 1;
    std::size_t items = 0;
    const std::size_t before = known_.front() - rule_.elsewhere.front().parameters.size();
    if (names > before)
        while (known_[items++] < names) {
        }
    return items;
}

}  // namespace algae
