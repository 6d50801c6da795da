#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "rewrite/detail/free_step.hpp"
#include "watch/watch.hpp"

// One step of rules that do not look at other modules, by several threads.
//
// The word is cut into parts. First every part chooses its rules and counts what comes of them, then all write their
// successors to places that are known by then. Programs run over all modules of a part with the same rule at once. Where something
// has no value, or more than one rule matches, the modules are looked at one by one, so that the message names the first of the
// word and does not depend on threads.

namespace algae {

void OutcomeTable::add(std::uint32_t successor, const ModuleKind* kinds, std::size_t size,
                       std::size_t values, std::uint32_t arity) {
    outcomes.push_back({successor, static_cast<std::uint32_t>(size),
                        static_cast<std::uint32_t>(values), arity,
                        padded_.data() + padded_.size()});
    padded_.insert(padded_.end(), kinds, kinds + size);
    padded_.insert(padded_.end(), near, 0);
}

OutcomeTable::OutcomeTable(const CompiledRules& rules, const RuleSet& set) {
    const std::size_t kinds = rules.kinds.size();
    const std::size_t count = kinds + rules.successors.size();
    if (count > 65'535)
        throw BoundReached(Bound::method, "the system has more than 65535 rules and letters");
    std::size_t letters = 0;
    for (const Successor& successor : rules.successors) letters += successor.kinds.size();
    padded_.reserve(letters + kinds + count * near);  // so that outcomes may point into it
    for (std::size_t k = 0; k < kinds; ++k) {
        const auto kind = static_cast<ModuleKind>(k);
        add(0, &kind, 1, rules.kinds.arity(kind), rules.kinds.arity(kind));
    }
    ways.resize(kinds);
    closer.assign(kinds, 0);
    number_of.assign(rules.successors.size(), 0);
    for (std::size_t k = 0; k < kinds; ++k) {
        const auto kind = static_cast<ModuleKind>(k);
        ways[k].thresholds.fill(~std::uint64_t{0});
        ways[k].outcomes.fill(kind);
        for (const Alternatives& alternatives : set.of[k])
            for (const std::uint32_t successor : alternatives.successors) {
                number_of[successor] = static_cast<Number>(outcomes.size());
                const Successor& to = rules.successors[successor];
                add(successor, to.kinds.data(), to.kinds.size(), to.values.size(),
                    rules.kinds.arity(kind));
            }
        if (set.of[k].empty()) continue;
        const Alternatives& first = set.of[k].front();
        const std::size_t choices = first.successors.size();
        closer[k] = set.of[k].size() > 1 || first.condition || choices > 4 ||
                    (choices > 1 && first.thresholds.empty());
        any_closer = any_closer || closer[k];
        if (closer[k]) continue;
        random = random || choices > 1;
        for (std::size_t i = 0; i < 4; ++i) {
            ways[k].outcomes[i] = number_of[first.successors[std::min(i, choices - 1)]];
            if (i + 1 < choices) ways[k].thresholds[i] = first.thresholds[i];
        }
    }
}

}  // namespace algae

namespace algae {

/// What a thread works with, kept from part to part.
struct FreeStep::Room {
    std::vector<std::vector<Row>> rows;         // by kind, or by outcome
    std::vector<std::vector<double>> gathered;  // columns of parameters
    std::vector<const double*> columns;         // the same, for programs
    std::vector<char> is_gathered;              // by parameter
    std::vector<double> values;                 // what a program gives
    std::vector<std::uint32_t> found;           // by row: the rules that match, counted from 1
    Program::Columns programs;
};

FreeStep::FreeStep(const Rewriting& rewriting, const RuleSet& set, const ModuleString& word,
                   std::uint64_t generation, const Budget& budget)
    : rewriting_(rewriting),
      rules_(rewriting.rules_),
      set_(set),
      word_(word),
      generation_(generation),
      budget_(budget),
      draws_(rewriting.choices_.seed, generation),
      table_(rules_, set) {
    cut();
}

void FreeStep::cut() {
    const std::size_t size = word_.kinds.size();
    std::uint64_t values = 0;
    for (std::size_t begin = 0; begin < size; begin += part_size) {
        parts_.push_back({begin, std::min(begin + part_size, size), values});
        if (!word_.values.empty())
            for (std::size_t i = begin; i < parts_.back().end; ++i)
                values += rules_.kinds.arity(word_.kinds[i]);
    }
}

void FreeStep::gather(const Program& program, const std::vector<Row>& rows, Room& room) const {
    for (const std::size_t parameter : program.reads()) {
        if (room.is_gathered.size() <= parameter) {
            room.is_gathered.resize(parameter + 1, 0);
            room.gathered.resize(parameter + 1);
            room.columns.resize(parameter + 1, nullptr);
        }
        if (room.is_gathered[parameter]) continue;
        room.is_gathered[parameter] = 1;
        auto& column = room.gathered[parameter];
        if (column.size() < rows.size()) column.resize(part_size);
        const double* values = word_.values.data() + parameter;
        for (std::size_t i = 0; i < rows.size(); ++i) column[i] = values[rows[i].values];
        room.columns[parameter] = column.data();
    }
}

void FreeStep::all(void (FreeStep::*work)(Part&, Room&)) {
    const unsigned threads = rules_.kinds.words() ? 1 : rewriting_.choices_.threads;  // one list
    each_part(parts_.size(), threads, budget_, [this, work] {
        return [this, work, room = std::make_shared<Room>()](std::size_t part) {
            (this->*work)(parts_[part], *room);
        };
    });
}

ModuleString FreeStep::next() {
    WorkCount modules("modules");
    modules.at(word_.kinds.size());
    chosen_.resize(word_.kinds.size());
    all(&FreeStep::choose);
    std::uint64_t letters = 0, values = 0;
    for (Part& part : parts_) {
        letters += std::exchange(part.letters_out, letters);
        values += std::exchange(part.values_out, values);
    }
    if (letters > budget_.letters)
        throw BoundReached(Bound::letters, "generation " + std::to_string(generation_ + 1) +
                                               " has " + std::to_string(letters) +
                                               " letters, more than the " +
                                               std::to_string(budget_.letters) + " allowed" +
                                               budget_.by(Bound::letters));
    budget_.check_memory(letters * sizeof(ModuleKind) + values * sizeof(double), "a word");
    out_.kinds.resize(static_cast<std::size_t>(letters));
    out_.values.resize(static_cast<std::size_t>(values));
    all(&FreeStep::write);
    return std::move(out_);
}

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
            rewriting_.refuse(undefined, rule, kind, values, row.position, generation_);
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
                rewriting_.refuse(undefined, *successor.rule, word_.kinds[row.position], values,
                                  row.position, generation_);
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
