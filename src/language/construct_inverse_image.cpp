#include "language/construct_inverse_image.hpp"

#include <vector>

#include "language/construct_draft.hpp"
#include "language/construct_gsm.hpp"

namespace algae {

namespace {

/// Reads the images of letters after each other and writes the letters.
Gsm decoder(const std::map<Symbol, Word>& morphism) {
    Gsm machine{0, {1}, {}};
    for (const auto& [letter, image] : morphism) {
        std::size_t state = 0;
        for (std::size_t i = 0; i < image.size(); ++i) {
            const bool end = i + 1 == image.size();
            if (!end) machine.accepting.push_back(0);
            const std::size_t next = end ? 0 : machine.states() - 1;
            machine.moves.push_back({state, image[i], next, end ? Word{letter} : Word{}});
            state = next;
        }
    }
    return machine;
}

/// The words of the system with any of these letters inserted anywhere: a table makes waiting letters of
/// terminals, another lets inserted letters come before them, and before a mark at the right end.
ET0L inserted(const ET0L& system, const Word& letters) {
    Draft draft(*system.alphabet, 0);
    draft.add_tables(system);
    const auto copies = draft.copies(system);
    const Symbol mark = draft.fresh("R");
    Word axiom = replaced(system.axiom, copies);
    axiom.push_back(mark);
    for (std::size_t t = 0; t < system.tables.size(); ++t) {
        draft.add_rules(t, system, t, copies);
        draft.add_rule(t, mark, {mark});
    }
    const std::size_t wait = draft.add_table(), insert = draft.add_table(), end = draft.add_table();
    const auto add_insertions = [&](Symbol letter) {
        draft.add_rule(insert, letter, {letter});
        for (const Symbol a : draft.terminals(*system.alphabet, letters))
            draft.add_rule(insert, letter, {a, letter});
    };
    draft.add_rule(wait, mark, {mark});
    draft.add_rule(end, mark, {});
    add_insertions(mark);
    for (Symbol a = 0; a < copies.size(); ++a) {
        if (!system.terminal[a]) continue;
        const Symbol waiting = draft.fresh(system.alphabet->name(a));
        draft.add_rule(wait, copies[a], {waiting});
        draft.add_rule(end, waiting, draft.terminals(*system.alphabet, {a}));
        add_insertions(waiting);
    }
    for (const Symbol a : draft.terminals(*system.alphabet, letters)) {
        draft.add_rule(insert, a, {a});
        draft.add_rule(end, a, {a});
    }
    return draft.system(axiom, "inverse image");
}

}  // namespace

ET0L table_inverse_image(const ET0L& system, const std::map<Symbol, Word>& morphism,
                         const Budget& budget) {
    ET0L result = table_gsm_image(system, decoder(morphism), budget);
    Word without_image;
    for (const auto& [letter, image] : morphism)
        if (image.empty()) without_image.push_back(letter);
    if (!without_image.empty())
        result = trimmed(inserted(result, without_image), *system.alphabet, "");
    result.name = "inverse image";
    return result;
}

}  // namespace algae
