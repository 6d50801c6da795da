#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "fold/interaction_windows.hpp"

namespace algae {

/// Words of a system with interactions as bytes, and a table of what becomes of windows: as many
/// letters at a time as the bits of a word of the machine and of the table's index allow. Letters
/// whose windows reach beyond the ends are looked up one by one.
class WindowTable {
public:
    /// Nothing if the windows are too many or too wide, or become too long. The system must outlive
    /// the table.
    static std::optional<WindowTable> of(const IL& system, const Windows& windows);

    void read(const Word& word);
    void write(Word& word) const;
    /// The next word; false, and no step, if it has more than budget.letters letters. O(length of
    /// the two words / letters at a time). Throws BoundReached if the words take more than
    /// budget.memory.
    bool step(const Budget& budget);
    std::size_t length() const { return length_; }

private:
    static constexpr std::size_t most_letters = 15;  // that the letters in the middle become
    /// What the letters in the middle of a window become.
    struct Entry {
        std::array<std::uint8_t, most_letters> letters{};
        std::uint8_t count = 0;
    };

    WindowTable(const IL& system, const Windows& windows) : system_(&system), windows_(windows) {}
    bool build(const std::vector<std::optional<std::vector<std::uint8_t>>>& single,
               std::size_t middle);
    template <std::size_t bits>
    bool step_middle(const Budget& budget, std::size_t& at, std::size_t end);
    void rewrite_alone(std::size_t place);
    void make_room(std::size_t letters);

    const IL* system_;
    Windows windows_;
    std::size_t middle_ = 1;  // letters that are rewritten at a time
    std::vector<Entry> table_;
    std::size_t length_ = 0, next_length_ = 0;
    std::vector<std::uint8_t> word_,
        next_;  // longer than the words, so that whole entries can be read and written
};

}  // namespace algae
