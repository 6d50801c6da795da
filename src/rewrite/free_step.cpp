#include "rewrite/free_step.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "rewrite/free_step_room.hpp"
#include "base/parts.hpp"

namespace algae {

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
    each_part(parts_.size(), rewriting_.choices_.threads, budget_, [this, work] {
        return [this, work, room = std::make_shared<Room>()](std::size_t part) {
            (this->*work)(parts_[part], *room);
        };
    });
}

ModuleString FreeStep::next() {
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
    out_.kinds.resize(letters);
    out_.values.resize(values);
    all(&FreeStep::write);
    return std::move(out_);
}

}  // namespace algae
