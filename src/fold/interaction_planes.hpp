#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "fold/interaction_windows.hpp"

namespace algae {

/// A boolean function of the bits of a window, as a program that runs on 64 letters at a time.
///
/// It is made by splitting on one bit after another (Shannon's expansion), where equal parts are
/// made once and what is no letter's number may be any value.
class WindowProgram {
public:
    enum class Operation : std::uint8_t {
        zero,
        one,
        negate,
        both,
        other_only,
        either,
        other_unless,
        differs,
        select
    };
    /// slot to := operation(bit x; slots a, b). `select` is a where the bit is set and b elsewhere.
    struct Instruction {
        Operation operation;
        std::uint32_t to, bit, a, b;
    };

    /// The bits of the successors, from what windows become (see window_table); one letter each.
    WindowProgram(const Windows& windows,
                  const std::vector<std::optional<std::vector<std::uint8_t>>>& table);

    std::size_t slots() const { return slots_; }
    /// The first slots are the bits of the window: those of its first letter first.
    const std::vector<Instruction>& instructions() const { return instructions_; }
    /// The slots of the bits of the successor.
    const std::vector<std::uint32_t>& results() const { return results_; }

private:
    friend class ProgramWriter;
    WindowProgram() = default;
    std::size_t slots_ = 0;
    std::vector<Instruction> instructions_;
    std::vector<std::uint32_t> results_;
};

/// Words of a system that keeps their length, as bit planes: bit i of plane p is bit p of the number
/// of letter i. A step evaluates the rules as boolean functions of the planes, shifted for the
/// neighbours; letters whose windows reach beyond the ends are looked up one by one.
class CellPlanes {
public:
    /// Nothing if letters do not become one letter each, or if functions of so many bits would take
    /// longer than tables. The system must outlive the planes.
    static std::optional<CellPlanes> of(const IL& system, const Windows& windows);

    void read(const Word& word);
    void write(Word& word) const;
    /// O(length of the word / 64 * instructions).
    void step(const Budget& budget);
    std::size_t length() const { return length_; }

private:
    CellPlanes(const IL& system, const Windows& windows, WindowProgram program);
    void run(std::size_t first);
    Symbol letter_at(std::size_t place) const;
    void put(std::size_t place, Symbol letter);
    void step_ends();

    const IL* system_;
    Windows windows_;
    WindowProgram program_;
    std::size_t length_ = 0;
    std::vector<std::vector<std::uint64_t>> planes_, next_;  // with a word of nothing at either end
    std::vector<char> is_read_;                              // by slot
    std::vector<std::uint64_t> scratch_;                     // of one run, by slot
    std::vector<std::uint64_t*> at_;                         // by slot, for one run
};

}  // namespace algae
