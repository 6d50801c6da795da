#include "verify/lengths.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"

namespace algae::verify {

Lengths::Lengths(const System& system)
    : system_(system), symbols_(accessible_letters(system, system.axiom)) {
    for (const Symbol a : symbols_)
        counts_.emplace_back(std::count(system.axiom.begin(), system.axiom.end(), a));
}

Integer Lengths::length() const {
    Integer all;
    for (const Integer& count : counts_) all += count;
    return all;
}

void Lengths::next() {
    std::vector<Integer> later(counts_.size());
    for (std::size_t i = 0; i < symbols_.size(); ++i)
        for (const Symbol b : system_.tables.front()[symbols_[i]].front()) {
            const auto place = std::lower_bound(symbols_.begin(), symbols_.end(), b);
            later[static_cast<std::size_t>(place - symbols_.begin())] += counts_[i];
        }
    counts_ = std::move(later);
}

Integer length_of_generation(const System& system, const Integer& generation,
                             const Budget& budget) {
    if (generation > 100'000)
        throw BoundReached(Bound::method, "generation " + to_string(generation) +
                                              " is not counted, only those up to 100000");
    Lengths lengths(system);
    for (std::uint64_t n = 0; generation != n; ++n) {
        budget.check();
        lengths.next();
    }
    return lengths.length();
}

std::optional<Symbol> letter_of_generation(const System& system, std::uint64_t generation,
                                           Integer position, const Budget& budget) {
    const auto symbols = accessible_letters(system, system.axiom);
    const auto& table = system.tables.front();
    std::vector<std::map<Symbol, Integer>> lengths(1);  // of what a letter becomes, by steps
    for (const Symbol a : symbols) lengths[0][a] = 1;
    std::uint64_t bytes = 0;
    for (std::uint64_t step = 1; step <= generation; ++step) {
        budget.check();
        auto& later = lengths.emplace_back();
        for (const Symbol a : symbols) {
            Integer& length = later[a];
            for (const Symbol b : table[a].front())
                length += lengths[static_cast<std::size_t>(step) - 1].at(b);
            bytes += 64 + bit_length(length) / 8;
        }
        budget.check_memory(bytes, "the lengths of what letters become");
    }
    const Word* word = &system.axiom;
    for (std::uint64_t left = generation + 1; left-- > 0;) {
        std::optional<Symbol> at;
        for (const Symbol a : *word) {
            const Integer& length = lengths[static_cast<std::size_t>(left)].at(a);
            if (position < length) {
                at = a;
                break;
            }
            position -= length;
        }
        if (!at || left == 0) return at;
        word = &table[*at].front();
    }
    return std::nullopt;
}

}  // namespace algae::verify
