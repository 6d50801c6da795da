#include "language/construct_tables.hpp"

#include "language/construct_draft.hpp"

namespace algae {

namespace {

/// Copies of the letters of a system and its tables, as part of a draft.
struct Part {
    std::vector<Symbol> copies;
    Word axiom;
    std::size_t first = 0, last = 0;  // its tables: first, ..., last - 1
};

Part part(Draft& draft, const ET0L& system) {
    Part found;
    found.copies = draft.copies(system);
    found.axiom = replaced(system.axiom, found.copies);
    found.first = draft.add_tables(system);
    found.last = draft.tables();
    for (std::size_t t = found.first; t < found.last; ++t)
        draft.add_rules(t, system, t - found.first, found.copies);
    return found;
}

/// In this table copies of terminals become the terminals; the others fail.
void finish(Draft& draft, std::size_t table, const ET0L& system, const Part& part) {
    for (Symbol a = 0; a < part.copies.size(); ++a)
        if (system.terminal[a])
            draft.add_rule(table, part.copies[a], {draft.terminal(system.alphabet->name(a))});
}

Word joined(Word left, Symbol right) {
    left.push_back(right);
    return left;
}

ET0L several(const ET0L& system, bool none) {
    Draft draft(*system.alphabet, 0);
    const Part inner = part(draft, system);
    const Symbol rest = draft.fresh("R");
    for (std::size_t t = inner.first; t < inner.last; ++t) draft.add_rule(t, rest, {rest});
    const std::size_t another = draft.add_table(), end = draft.add_table();
    finish(draft, another, system, inner);
    finish(draft, end, system, inner);
    draft.add_rule(another, rest, joined(inner.axiom, rest));
    draft.add_rule(end, rest, {});
    draft.keep_terminals();
    return draft.system(none ? Word{rest} : joined(inner.axiom, rest), none ? "star" : "plus");
}

}  // namespace

ET0L table_union(const ET0L& left, const ET0L& right) {
    Draft draft(*left.alphabet, 0);
    const Symbol start = draft.fresh("S");
    const Part first = part(draft, left), second = part(draft, right);
    for (std::size_t t = first.first; t < first.last; ++t) draft.add_rule(t, start, first.axiom);
    for (std::size_t t = second.first; t < second.last; ++t) draft.add_rule(t, start, second.axiom);
    const std::size_t end = draft.add_table();
    finish(draft, end, left, first);
    finish(draft, end, right, second);
    return draft.system({start}, "union");
}

ET0L table_concatenation(const ET0L& left, const ET0L& right) {
    Draft draft(*left.alphabet, 0);
    const Symbol rest = draft.fresh("R");
    const Part first = part(draft, left), second = part(draft, right);
    for (std::size_t t = first.first; t < first.last; ++t) draft.add_rule(t, rest, {rest});
    const std::size_t end = draft.add_table();
    finish(draft, end, left, first);
    finish(draft, end, right, second);
    draft.add_rule(end, rest, second.axiom);
    draft.keep_terminals();
    return draft.system(joined(first.axiom, rest), "concatenation");
}

ET0L table_plus(const ET0L& system) { return several(system, false); }

ET0L table_star(const ET0L& system) { return several(system, true); }

}  // namespace algae
