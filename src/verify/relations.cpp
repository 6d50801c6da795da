#include "verify/relations.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "base/error.hpp"

namespace algae::verify {

BooleanMatrix relation_of(const Word& word, const Relations& relations, std::size_t states) {
    BooleanMatrix product = BooleanMatrix::identity(states);
    for (const Symbol a : word) product = product.then(relations.at(a));
    return product;
}

Relations one_step_earlier(const Relations& relations, const System::Successors& table,
                           std::size_t states) {
    Relations earlier;
    for (const auto& [a, relation] : relations) {
        BooleanMatrix all(states);
        for (const Word& word : table[a]) all |= relation_of(word, relations, states);
        earlier.emplace(a, std::move(all));
    }
    return earlier;
}

namespace {

/// Counts the work of steps, and ends it before it would take too long.
class Work {
public:
    Work(const System& system, const Relations& relations, std::size_t states, const Budget& budget)
        : budget_(budget) {
        std::uint64_t letters = 1;
        for (const auto& table : system.tables)
            for (const auto& [a, relation] : relations)
                for (const Word& word : table[a]) letters += word.size() + 1;
        const double rows = static_cast<double>(states) * static_cast<double>(states);
        one_step_ = static_cast<double>(letters) * rows * (1 + static_cast<double>(states) / 128);
    }

    void add() {
        budget_.check();
        done_ += one_step_;
        if (done_ > most)
            throw BoundReached(Bound::method,
                               "the tables of what letters derive would take too long");
    }

private:
    static constexpr double most = 5e10;  // operations: minutes

    const Budget& budget_;
    double one_step_ = 0, done_ = 0;
};

std::uint64_t bytes_of(const Relations& relations) {
    std::uint64_t bytes = 64;
    for (const auto& [a, relation] : relations) bytes += 64 + relation.bytes();
    return bytes;
}

}  // namespace

bool some_relations(const System& system, const Relations& start, std::size_t states,
                    const std::function<bool(const Relations&)>& stop, const Budget& budget) {
    budget.check_memory(bytes_of(start), "the table of what letters derive");
    Work work(system, start, states, budget);
    std::set<Relations> known{start};
    std::vector<const Relations*> open{&*known.begin()};
    std::uint64_t bytes = bytes_of(start);
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (stop(*open[i])) return true;
        for (const auto& table : system.tables) {
            work.add();
            const auto [place, is_new] = known.insert(one_step_earlier(*open[i], table, states));
            if (!is_new) continue;
            bytes += bytes_of(*place);
            budget.check_memory(bytes, "the tables of what letters derive");
            open.push_back(&*place);
        }
    }
    return false;
}

bool some_relations_after(const System& system, const Relations& start, std::size_t states,
                          const Integer& steps, const std::function<bool(const Relations&)>& stop,
                          const Budget& budget) {
    Work work(system, start, states, budget);
    std::map<std::set<Relations>, std::size_t> known;
    std::vector<const std::set<Relations>*> levels;
    std::set<Relations> level{start};
    std::uint64_t bytes = 0;
    for (;;) {
        for (const Relations& relations : level) bytes += bytes_of(relations);
        budget.check_memory(bytes, "the tables of what letters derive");
        const auto [place, is_new] = known.emplace(level, levels.size());
        std::size_t wanted = levels.size();
        if (!is_new) {  // from the level before on they come round again
            const std::size_t first = place->second, period = levels.size() - first;
            wanted = first + static_cast<std::size_t>(
                                 remainder(steps - first, Integer(period)).to_uint64());
        } else {
            levels.push_back(&place->first);
        }
        if (!is_new || steps == wanted)
            return std::any_of(levels[wanted]->begin(), levels[wanted]->end(), stop);
        std::set<Relations> next;
        for (const Relations& relations : level)
            for (const auto& table : system.tables) {
                budget.check_memory(bytes + (next.size() + 1) * bytes_of(relations),
                                    "the tables of what letters derive");
                work.add();
                next.insert(one_step_earlier(relations, table, states));
            }
        level = std::move(next);
    }
}

}  // namespace algae::verify
