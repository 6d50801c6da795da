#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "system/ol.hpp"

namespace algae {

/// The factors of one word, and how the rules of one system put them together. A factor is a pair of
/// places from <= to in the word. The system must outlive it.
class FactorTables {
public:
    /// Which letters derive which factors in exactly t steps, for one t: for every letter and every
    /// place a row of bits, one for each place where a factor may end.
    using Table = std::vector<std::uint64_t>;
    using Row = std::vector<std::uint64_t>;

    FactorTables(const OL& system, const Word& word);

    /// Bytes of one table.
    std::uint64_t bytes() const { return system_->letters.size() * places_ * width_ * sizeof(std::uint64_t); }
    /// t = 0: every letter derives itself.
    Table first() const;
    /// The table of t + 1 steps from that of t.
    void next(const Table& table, Table& following) const;
    /// Whether this word of letters derives the whole word.
    bool derives(const Table& table, const Word& letters) const;
    /// Where the factors of the letters end when `letters` derives the factor from..to; nothing if it
    /// does not.
    std::optional<std::vector<std::size_t>> split(const Table& table, const Word& letters, std::size_t from,
                                                  std::size_t to) const;

private:
    /// A beginning of some successors: a shorter one and a letter. The first is the empty word.
    struct Beginning {
        std::size_t shorter = 0;
        std::size_t letter = 0;             // place in OL::letters
        std::vector<std::size_t> whole_of;  // letters that have it as a successor
    };

    const std::uint64_t* row(const Table& table, std::size_t letter, std::size_t place) const {
        return table.data() + (letter * places_ + place) * width_;
    }
    /// to := to united with the ends of factors of `letter` that begin where a factor in `ends` ended.
    void extend(const Table& table, const std::uint64_t* ends, std::size_t letter, std::uint64_t* to) const;

    const OL* system_;
    const Word* word_;
    std::size_t places_;  // one more than the word has letters
    std::size_t width_;   // of a row, in words of 64 bits
    std::vector<std::size_t> index_;  // of a symbol in OL::letters
    std::vector<Beginning> beginnings_;
};

}  // namespace algae
