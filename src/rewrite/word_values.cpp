#include "rewrite/word_values.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace algae {

namespace {

constexpr std::uint64_t quiet = 0x7FF8'0000'0000'0000;  // the bits of a number that is none
constexpr std::uint64_t place_bits = 0x0007'FFFF'FFFF'FFFF;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t next) {
    hash = (hash ^ next) * 0x9E37'79B9'7F4A'7C15;
    return hash ^ (hash >> 29);
}

std::uint64_t hash_of(const ModuleString& word) {
    std::uint64_t hash = word.kinds.size();
    for (const ModuleKind kind : word.kinds) hash = mixed(hash, kind);
    for (const double value : word.values)  // 0 and -0 are equal
        hash = mixed(hash, std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value));
    return hash;
}

}  // namespace

const WordValues::Held& WordValues::held(double value) const {
    return all_.at((std::bit_cast<std::uint64_t>(value) & place_bits) - 1);
}

double WordValues::value(ModuleString word, const Budget& budget) {
    const auto value_at = [](std::size_t place) {
        return std::bit_cast<double>(quiet | (place + 1));
    };
    const std::uint64_t hash = hash_of(word);
    const auto [first, last] = places_.equal_range(hash);
    for (auto known = first; known != last; ++known)
        if (all_[known->second].word == word) return value_at(known->second);

    Held next{std::move(word), 0, 1};
    next.modules = next.word.kinds.size();
    for (const double value : next.word.values) {
        if (!is_word(value)) continue;
        const Held& within = held(value);
        next.modules += within.modules;  // far below 2^64: each is at most the bound
        next.depth = std::max(next.depth, within.depth + 1);
        if (next.modules > budget.letters) break;
    }
    constexpr std::size_t deepest = 100;
    if (next.depth > deepest)
        throw BoundReached(Bound::method, "words stand in words as parameters more than " +
                                              std::to_string(deepest) + " deep");
    if (next.modules > budget.letters)
        throw BoundReached(Bound::letters,
                           "a word that is a parameter has more than " +
                               std::to_string(budget.letters) +
                               " letters with those of its own parameters, the bound set" +
                               budget.by(Bound::letters));
    bytes_ += sizeof(Held) + next.word.kinds.size() * sizeof(ModuleKind) +
              next.word.values.size() * sizeof(double);
    budget.check_memory(bytes_, "the words that are parameters");
    places_.emplace(hash, all_.size());
    all_.push_back(std::move(next));
    return value_at(all_.size() - 1);
}

}  // namespace algae
