#include "system/il.hpp"
#include "word/renaming.hpp"

#include <algorithm>

namespace algae {

namespace {

std::string at(const Place& place) { return "the rule at " + to_string(place); }

std::string beyond_il(const Production& rule) {
    const auto plain = [](const Pattern& pattern) {
        return std::all_of(pattern.begin(), pattern.end(), [](const ModulePattern& m) { return m.parameters.empty(); });
    };
    if (!rule.elsewhere.empty()) return at(rule.place) + " has a context condition";
    if (rule.condition) return at(rule.place) + " has a condition";
    if (!rule.predecessor.parameters.empty() || !rule.successor.arguments.empty() || !plain(rule.left) || !plain(rule.right))
        return at(rule.place) + " has parameters";
    if (!rule.successor.splices.empty()) return at(rule.place) + " splices a word in";
    if (rule.shape) return at(rule.place) + " is a shape rule";
    if (rule.probability && *rule.probability != Rational(1)) return at(rule.place) + " has a probability";
    return {};
}

Word letters(const Pattern& pattern) {
    Word word;
    for (const ModulePattern& module : pattern) word.push_back(module.symbol);
    return word;
}

std::string beyond_il(const LSystem& system) {
    if (!system.inner.empty()) return "there are systems within it";
    if (!system.axiom.arguments.empty()) return "the axiom has parameters";
    if (!system.axiom.splices.empty()) return "the axiom has a word spliced in";
    if (!system.tables.empty()) return "it has tables";
    if (!system.terminals.empty()) return "it has terminals";
    for (const Production& rule : system.rules)
        if (std::string reason = beyond_il(rule); !reason.empty()) return reason;
    return {};
}

/// The brackets that make trees of words: none where both are ignored.
std::optional<Brackets> fences(const LSystem& system) {
    const std::optional<Brackets> brackets = brackets_of(system.alphabet);
    if (!brackets) return std::nullopt;
    const auto is_ignored = [&](Symbol a) {
        return std::find(system.ignored.begin(), system.ignored.end(), a) != system.ignored.end();
    };
    return is_ignored(brackets->open) && is_ignored(brackets->close) ? std::nullopt : brackets;
}

/// Why the brackets cannot be those of trees, or nothing.
std::string beyond_trees(const LSystem& system, const Brackets& brackets) {
    for (const Symbol a : system.ignored)
        if (a == brackets.open || a == brackets.close)
            return "it ignores one bracket and not the other";
    for (const Production& rule : system.rules) {
        for (const ModulePattern& module : rule.left)
            if (module.symbol == brackets.open || module.symbol == brackets.close)
                return at(rule.place) +
                       " has a bracket in its left context, which is a path and has no branches";
        std::size_t depth = 0;
        for (const ModulePattern& module : rule.right) {
            if (module.symbol == brackets.open) ++depth;
            if (module.symbol == brackets.close && depth-- == 0)
                return at(rule.place) + " has an unmatched ']' in its right context";
        }
        if (depth > 0) return at(rule.place) + " has an unmatched '[' in its right context";
    }
    return {};
}

std::size_t letters_in(const IL::Rule& rule, const std::optional<Brackets>& brackets) {
    std::size_t count = rule.left.size() + rule.right.size();
    if (brackets)
        for (const Symbol a : rule.right) count -= a == brackets->open || a == brackets->close;
    return count;
}

}  // namespace

View<IL> as_il(const LSystem& system) {
    if (std::string reason = beyond_il(system); !reason.empty())
        return View<IL>::refused("not a deterministic IL system: " + reason);
    IL il;
    il.brackets = fences(system);
    if (il.brackets)
        if (std::string reason = beyond_trees(system, *il.brackets); !reason.empty())
            return View<IL>::refused("not a deterministic IL system: " + reason);
    il.alphabet = std::make_shared<const Alphabet>(system.alphabet);
    il.axiom = system.axiom.letters;
    il.name = system.name;
    il.rules.resize(il.alphabet->size());
    il.ignored.assign(il.alphabet->size(), 0);
    for (const Symbol a : system.ignored) il.ignored[a] = 1;
    for (const Production& rule : system.rules) {
        auto& known = il.rules[rule.predecessor.symbol];
        IL::Rule fresh{letters(rule.left), letters(rule.right), rule.successor.letters};
        for (const IL::Rule& other : known)
            if (other.left == fresh.left && other.right == fresh.right && other.successor != fresh.successor)
                return View<IL>::refused("not a deterministic IL system: " + system.alphabet.name(rule.predecessor.symbol) +
                                         " has two rules with the same contexts");
        known.push_back(std::move(fresh));
    }
    for (auto& known : il.rules)
        std::stable_sort(known.begin(), known.end(), [&](const IL::Rule& left, const IL::Rule& right) {
            return letters_in(left, il.brackets) > letters_in(right, il.brackets);
        });
    return il;
}

IL over(const IL& system, std::shared_ptr<const Alphabet> alphabet) {
    const std::vector<Symbol> letters = renaming(*system.alphabet, *alphabet);
    IL moved{alphabet, replaced(system.axiom, letters), {}, std::vector<char>(alphabet->size(), 0), system.name};
    if (system.brackets)
        moved.brackets = Brackets{letters[system.brackets->open], letters[system.brackets->close]};
    moved.rules.resize(alphabet->size());
    for (Symbol a = 0; a < letters.size(); ++a) {
        moved.ignored[letters[a]] = system.ignored[a];
        for (const IL::Rule& rule : system.rules[a])
            moved.rules[letters[a]].push_back({replaced(rule.left, letters), replaced(rule.right, letters), replaced(rule.successor, letters)});
    }
    return moved;
}

}  // namespace algae
