#include "language/membership_table.hpp"

#include <algorithm>
#include <bit>
#include <map>

namespace algae {

FactorTables::FactorTables(const OL& system, const Word& word)
    : system_(&system),
      word_(&word),
      places_(word.size() + 1),
      width_((places_ + 63) / 64),
      index_(system.alphabet->size(), 0),
      beginnings_(1) {
    for (std::size_t i = 0; i < system.letters.size(); ++i) index_[system.letters[i]] = i;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;
    for (std::size_t i = 0; i < system.letters.size(); ++i)
        for (const Word& successor : system.successors[system.letters[i]]) {
            std::size_t at = 0;
            for (const Symbol b : successor) {
                const auto [found, is_new] = known.try_emplace({at, index_[b]}, beginnings_.size());
                if (is_new) beginnings_.push_back({at, index_[b], {}});
                at = found->second;
            }
            beginnings_[at].whole_of.push_back(i);
        }
}

void FactorTables::extend(const Table& table, const std::uint64_t* ends, std::size_t letter, std::uint64_t* to) const {
    for (std::size_t block = 0; block < width_; ++block)
        for (std::uint64_t bits = ends[block]; bits != 0; bits &= bits - 1) {
            const std::size_t place = block * 64 + static_cast<std::size_t>(std::countr_zero(bits));
            const std::uint64_t* const further = row(table, letter, place);
            for (std::size_t k = block; k < width_; ++k) to[k] |= further[k];
        }
}

FactorTables::Table FactorTables::first() const {
    Table table(system_->letters.size() * places_ * width_, 0);
    for (std::size_t place = 0; place + 1 < places_; ++place) {
        const std::size_t letter = index_[(*word_)[place]];
        table[(letter * places_ + place) * width_ + (place + 1) / 64] |= std::uint64_t{1} << ((place + 1) % 64);
    }
    return table;
}

void FactorTables::next(const Table& table, Table& following) const {
    following.assign(table.size(), 0);
    std::vector<std::uint64_t> ends(beginnings_.size() * width_);
    for (std::size_t place = 0; place < places_; ++place) {
        std::fill(ends.begin(), ends.end(), 0);
        ends[place / 64] = std::uint64_t{1} << (place % 64);
        for (std::size_t i = 0; i < beginnings_.size(); ++i) {
            const Beginning& beginning = beginnings_[i];
            std::uint64_t* const here = ends.data() + i * width_;
            if (i > 0) extend(table, ends.data() + beginning.shorter * width_, beginning.letter, here);
            for (const std::size_t letter : beginning.whole_of) {
                std::uint64_t* const to = following.data() + (letter * places_ + place) * width_;
                for (std::size_t k = place / 64; k < width_; ++k) to[k] |= here[k];
            }
        }
    }
}

bool FactorTables::derives(const Table& table, const Word& letters) const {
    Row ends(width_, 0);
    ends[0] = 1;
    for (const Symbol a : letters) {
        Row further(width_, 0);
        extend(table, ends.data(), index_[a], further.data());
        ends = std::move(further);
    }
    return (ends[(places_ - 1) / 64] >> ((places_ - 1) % 64) & 1) != 0;
}

std::optional<std::vector<std::size_t>> FactorTables::split(const Table& table, const Word& letters, std::size_t from,
                                                            std::size_t to) const {
    std::vector<Row> ends(letters.size() + 1, Row(width_, 0));
    const auto has = [](const std::uint64_t* bits, std::size_t place) { return (bits[place / 64] >> (place % 64) & 1) != 0; };
    ends[0][from / 64] = std::uint64_t{1} << (from % 64);
    for (std::size_t i = 0; i < letters.size(); ++i)
        extend(table, ends[i].data(), index_[letters[i]], ends[i + 1].data());
    if (!has(ends.back().data(), to)) return std::nullopt;
    std::vector<std::size_t> stops(letters.size());
    for (std::size_t i = letters.size(); i-- > 0;) {
        stops[i] = to;
        std::size_t begin = to;  // the last place where it can begin
        while (!has(ends[i].data(), begin) || !has(row(table, index_[letters[i]], begin), to)) --begin;
        to = begin;
    }
    return stops;
}

}  // namespace algae
