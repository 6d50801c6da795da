#include <algorithm>

#include "rewrite/free_step_room.hpp"

namespace algae {

OutcomeTable::Number FreeStep::outcome_of(const Alternatives& alternatives, ModuleKind kind,
                                          const Row& row) const {
    rewriting_.check_choice(alternatives, kind, word_.values.data() + row.values, row.position,
                            generation_);
    const std::uint64_t number = alternatives.successors.size() > 1 ? draws_.at(row.position) : 0;
    return table_.number_of[rewriting_.pick(alternatives, number)];
}

/// One module by itself: what has no value is found here.
void FreeStep::look_at(ModuleKind kind, const Row& row) {
    const double* values = word_.values.data() + row.values;
    const Alternatives* found = nullptr;
    for (const Alternatives& next : set_.of[kind]) {
        const Production& rule = *rules_.successors[next.successors.front()].rule;
        try {
            if (next.condition && next.condition->run(values) == 0) continue;
        } catch (const Undefined& undefined) {
            rewriting_.refuse(undefined.reason, rule, kind, values, row.position, generation_);
        }
        if (found) rewriting_.refuse_both(*found, next, kind, values, row.position, generation_);
        found = &next;
    }
    chosen_[row.position] = found ? outcome_of(*found, kind, row) : kind;
}

/// All modules of a kind at once; false if something has no value or too many rules match.
bool FreeStep::look_at_all(ModuleKind kind, const std::vector<Row>& rows, Room& room) {
    std::fill(room.is_gathered.begin(), room.is_gathered.end(), 0);
    room.found.assign(rows.size(), 0);
    room.values.resize(part_size);
    const auto& rules = set_.of[kind];
    for (std::uint32_t rule = 0; rule < rules.size(); ++rule) {
        if (rules[rule].condition) {
            gather(*rules[rule].condition, rows, room);
            if (!rules[rule].condition->run_many(room.columns, rows.size(), room.values.data(),
                                                 room.programs))
                return false;
        } else {
            std::fill_n(room.values.begin(), rows.size(), 1.0);
        }
        bool twice = false;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const bool holds = room.values[i] != 0;
            twice |= holds && room.found[i] != 0;
            room.found[i] = holds ? rule + 1 : room.found[i];
        }
        if (twice) return false;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::uint32_t found = room.found[i];
        chosen_[rows[i].position] = found == 0 ? kind
                                    : rules[found - 1].successors.size() == 1
                                        ? table_.number_of[rules[found - 1].successors.front()]
                                        : outcome_of(rules[found - 1], kind, rows[i]);
    }
    return true;
}

void FreeStep::look_closer(ModuleKind kind, const std::vector<Row>& rows, Room& room) {
    if (rows.empty() || look_at_all(kind, rows, room)) return;
    for (const Row& row : rows) look_at(kind, row);
}

void FreeStep::choose(Part& part, Room& room) {
    if (table_.random) {
        for (std::size_t i = part.begin; i < part.end; ++i) {
            const OutcomeTable::Way& way = table_.ways[word_.kinds[i]];
            const std::uint64_t number = draws_.at(i);
            const auto steps = static_cast<std::size_t>(number >= way.thresholds[0]) +
                               static_cast<std::size_t>(number >= way.thresholds[1]) +
                               static_cast<std::size_t>(number >= way.thresholds[2]);
            chosen_[i] = way.outcomes[steps];
        }
    } else {
        for (std::size_t i = part.begin; i < part.end; ++i)
            chosen_[i] = table_.ways[word_.kinds[i]].outcomes[0];
    }
    if (table_.any_closer) {
        room.rows.resize(table_.closer.size());
        for (auto& rows : room.rows) rows.clear();
        std::uint64_t values = part.values;
        for (std::size_t i = part.begin; i < part.end; ++i) {
            const ModuleKind kind = word_.kinds[i];
            if (table_.closer[kind]) room.rows[kind].push_back({i, values, 0});
            values += rules_.kinds.arity(kind);
        }
        for (std::size_t kind = 0; kind < table_.closer.size(); ++kind)
            look_closer(static_cast<ModuleKind>(kind), room.rows[kind], room);
    }
    std::uint64_t letters = 0, values = 0;
    for (std::size_t i = part.begin; i < part.end; ++i) {
        letters += table_.outcomes[chosen_[i]].letters;
        values += table_.outcomes[chosen_[i]].values;
    }
    part.letters_out = letters;
    part.values_out = values;
}

}  // namespace algae
