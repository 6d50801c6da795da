#pragma once
// notation: reading and printing `.lsys` files, and what a reader is told about a faulty one.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/place.hpp"

namespace algae {

/// The text of a file with its places. The text itself is not copied and must outlive the source.
class Source {
public:
    /// Reads through the text once: checks that it is UTF-8 without control characters and
    /// remembers the place of every few thousandth byte.
    Source(std::string_view text, std::string file);

    std::string_view text() const { return text_; }
    const std::string& file() const { return file_; }

    /// The place of a byte. Fast for offsets that mostly grow, never more than a few thousand steps.
    Place place(std::size_t offset) const;
    Place place(const char* here) const { return place(offset(here)); }
    std::size_t offset(const char* here) const {
        return static_cast<std::size_t>(here - text_.data());
    }
    /// The byte at a place of this source.
    std::size_t offset(const Place& place) const;

    /// A finding about a byte, with its line: whole, or the part around the caret if it is long.
    Diagnostic finding(std::size_t offset, std::string message) const;

    /// The offsets of bytes that are no UTF-8 or no character of a text, with what is wrong. One a
    /// line, and no more of them than anybody reads.
    struct BadByte {
        std::size_t offset;
        std::string message;
    };
    const std::vector<BadByte>& bad_bytes() const { return bad_bytes_; }
    std::size_t bad_lines() const { return bad_lines_; }

private:
    struct Mark {
        std::size_t offset = 0, line = 1, column = 1;
    };
    void note_bad_byte(const Mark& mark, std::string message);

    static constexpr std::size_t mark_distance = 4096;
    static constexpr std::size_t most_bad_bytes = 20;

    std::string_view text_;
    std::string file_;
    std::vector<Mark> marks_;
    mutable Mark latest_;
    std::vector<BadByte> bad_bytes_;
    std::size_t bad_lines_ = 0, last_bad_line_ = 0;
};

}  // namespace algae
