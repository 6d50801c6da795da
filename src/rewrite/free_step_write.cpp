#include <algorithm>
#include <cstring>

#include "rewrite/free_step_room.hpp"

namespace algae {

void FreeStep::compute(const OutcomeTable::Outcome& outcome, const std::vector<Row>& rows,
                       Room& room) {
    const Successor& successor = rules_.successors[outcome.successor];
    std::fill(room.is_gathered.begin(), room.is_gathered.end(), 0);
    room.values.resize(part_size);
    for (const Successor::Slot& slot : successor.slots) {
        gather(slot.value, rows, room);
        double* const out = out_.values.data() + slot.at;
        if (slot.value.run_many(room.columns, rows.size(), room.values.data(), room.programs)) {
            for (std::size_t i = 0; i < rows.size(); ++i) out[rows[i].out] = room.values[i];
            continue;
        }
        for (const Row& row : rows) {
            const double* values = word_.values.data() + row.values;
            try {
                out[row.out] = slot.value.run(values);
            } catch (const Undefined& undefined) {
                rewriting_.refuse(undefined.reason, *successor.rule, word_.kinds[row.position],
                                  values, row.position, generation_);
            }
        }
    }
}

void FreeStep::write(Part& part, Room& room) {
    ModuleKind* letters = out_.kinds.data() + part.letters_out;
    const ModuleKind* const letters_end =
        out_.kinds.data() + (&part == &parts_.back() ? out_.kinds.size() : (&part)[1].letters_out);
    for (std::size_t i = part.begin; i < part.end; ++i) {
        const OutcomeTable::Outcome& outcome = table_.outcomes[chosen_[i]];
        if (outcome.letters <= OutcomeTable::near && letters + OutcomeTable::near <= letters_end)
            std::memcpy(letters, outcome.kinds, OutcomeTable::near * sizeof(ModuleKind));
        else
            std::copy_n(outcome.kinds, outcome.letters, letters);
        letters += outcome.letters;
    }
    if (out_.values.empty()) return;
    room.rows.resize(table_.outcomes.size());
    for (auto& rows : room.rows) rows.clear();
    const double* from = word_.values.data() + part.values;
    double* to = out_.values.data() + part.values_out;
    for (std::size_t i = part.begin; i < part.end; ++i) {
        const OutcomeTable::Outcome& outcome = table_.outcomes[chosen_[i]];
        const double* source = from;
        if (outcome.successor != 0) {
            const Successor& successor = rules_.successors[outcome.successor];
            source = successor.values.data();
            if (!successor.slots.empty())
                room.rows[chosen_[i]].push_back(
                    {i, static_cast<std::uint64_t>(from - word_.values.data()),
                     static_cast<std::uint64_t>(to - out_.values.data())});
        }
        for (std::uint32_t k = 0; k < outcome.values; ++k) to[k] = source[k];
        to += outcome.values;
        from += outcome.arity;
    }
    for (std::size_t number = 0; number < table_.outcomes.size(); ++number)
        if (!room.rows[number].empty()) compute(table_.outcomes[number], room.rows[number], room);
}

}  // namespace algae
