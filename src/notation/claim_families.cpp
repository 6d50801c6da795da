#include "notation/claim_families.hpp"

#include <algorithm>
#include <map>

#include "system/classes.hpp"
#include "system/et0l.hpp"
#include "system/il.hpp"

namespace algae {

namespace {

/// Whether each letter is one whose rules matter.
std::vector<char> occurring(const LSystem& system) {
    std::vector<char> occurs(system.alphabet.size(), 0);
    std::vector<Word> successors(system.alphabet.size());
    for (const Production& rule : system.rules) {
        Word& all = successors[rule.predecessor.symbol];
        all.insert(all.end(), rule.successor.letters.begin(), rule.successor.letters.end());
    }
    Word next = system.axiom.letters;
    while (!next.empty()) {
        const Symbol letter = next.back();
        next.pop_back();
        if (occurs[letter]) continue;
        occurs[letter] = 1;
        next.insert(next.end(), successors[letter].begin(), successors[letter].end());
    }
    return occurs;
}

std::string erasing(const LSystem& system) {
    const std::vector<char> occurs = occurring(system);
    for (const Production& rule : system.rules)
        if (rule.successor.letters.empty() && occurs[rule.predecessor.symbol])
            return "the rule at " + to_string(rule.place) + " is erasing";
    return {};
}

/// The first rule that rewrites what one before it rewrites, in a system without context.
std::string second_choice(const LSystem& system) {
    const std::vector<char> occurs = occurring(system);
    std::map<std::pair<std::size_t, Symbol>, const Production*> first;
    for (const Production& rule : system.rules) {
        const Symbol letter = rule.predecessor.symbol;
        if (!occurs[letter]) continue;
        const auto [entry, is_new] = first.try_emplace({rule.table, letter}, &rule);
        if (!is_new && entry->second->successor != rule.successor)
            return "the rule at " + to_string(rule.place) + " is a second one for " +
                   system.alphabet.name(letter);
    }
    return {};
}

std::string misfit_without_context(const LSystem& system, const SystemForm& form) {
    const View<ET0L> view = as_et0l(system);
    if (!view) return "it is " + view.reason();
    if (!form.extended && !has_only_terminals(*view))
        for (const Symbol letter : accessible_letters(*view))
            if (!view->terminal[letter])
                return "its letter " + system.alphabet.name(letter) + " is no terminal";
    if (!form.tables && view->tables.size() > 1) return "it has several tables";
    if (form.deterministic && !is_deterministic(*view)) return second_choice(system);
    if (form.propagating && !is_propagating(*view)) return erasing(system);
    return {};
}

std::string misfit_with_context(const LSystem& system, const SystemForm& form) {
    if (const View<IL> view = as_il(system); !view) {
        const View<ET0L> tables = as_et0l(system);
        const bool is_ol = tables && tables->tables.size() == 1 && has_only_terminals(*tables);
        if (!is_ol || form.deterministic) return "it is " + view.reason();
    }
    const auto [left, right] = class_of(system).context;
    const bool fits = form.one_sided ? left + right <= 1
                                     : !form.context || (left <= form.context->first &&
                                                         right <= form.context->second);
    if (!fits)
        return "its contexts are up to " + std::to_string(left) + " on the left and " +
               std::to_string(right) + " on the right";
    if (form.propagating) return erasing(system);
    return {};
}

}  // namespace

std::optional<std::string> language_family(std::string_view name) {
    if (name == "REG" || name == "regular") return "REG";
    if (name == "CF" || name == "context-free") return "CF";
    if (system_form(name)) return std::string(name);
    return std::nullopt;
}

const std::vector<std::string>& common_families() {
    static const std::vector<std::string> all{"0L",   "P0L",  "D0L",   "PD0L",    "T0L",
                                              "PT0L", "DT0L", "PDT0L", "E0L",     "EP0L",
                                              "ED0L", "ET0L", "EPT0L", "EDT0L",   "EPDT0L",
                                              "IL",   "DIL",  "PDIL",  "regular", "context-free"};
    return all;
}

std::string misfit(const LSystem& system, const SystemForm& form) {
    return form.interactive ? misfit_with_context(system, form)
                            : misfit_without_context(system, form);
}

}  // namespace algae
