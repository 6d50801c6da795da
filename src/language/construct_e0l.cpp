#include "language/construct_e0l.hpp"

#include "language/construct_draft.hpp"
#include "language/construct_synchronised.hpp"

namespace algae {

namespace {

/// The rules of a synchronised system for the same language, as part of the draft; its axiom.
Symbol part(Draft& draft, const ET0L& system, const char* operation) {
    require_one_table(system, operation);
    const ET0L separate = synchronised(system);
    const auto letters = draft.letters(separate);
    draft.add_rules(0, separate, 0, letters);
    return letters[separate.axiom.front()];
}

ET0L several(const ET0L& system, bool none, const char* operation) {
    Draft draft(*system.alphabet);
    const Symbol axiom = part(draft, system, operation), start = draft.fresh("S"),
                 more = draft.fresh("R");
    draft.keep(axiom);
    draft.add_rule(0, start, {more});
    if (none) draft.add_rule(0, start, {});
    draft.add_rule(0, more, {more, axiom});
    draft.add_rule(0, more, {axiom});
    return draft.system({start}, operation);
}

}  // namespace

ET0L e0l_union(const ET0L& left, const ET0L& right) {
    Draft draft(*left.alphabet);
    const Symbol first = part(draft, left, "union"), second = part(draft, right, "union"),
                 start = draft.fresh("S");
    draft.add_rule(0, start, {first});
    draft.add_rule(0, start, {second});
    return draft.system({start}, "union");
}

ET0L e0l_concatenation(const ET0L& left, const ET0L& right) {
    Draft draft(*left.alphabet);
    const Symbol first = part(draft, left, "concatenation"),
                 second = part(draft, right, "concatenation");
    draft.keep(first);
    draft.keep(second);
    return draft.system({first, second}, "concatenation");
}

ET0L e0l_plus(const ET0L& system) { return several(system, false, "plus"); }

ET0L e0l_star(const ET0L& system) { return several(system, true, "star"); }

}  // namespace algae
