#include "notation/source.hpp"

#include <algorithm>
#include <utility>

#include "notation/characters.hpp"

namespace algae {

namespace {

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

std::string hexadecimal(unsigned char byte) {
    static constexpr std::string_view digits = "0123456789ABCDEF";
    return {'0', 'x', digits[byte >> 4], digits[byte & 15]};
}

}  // namespace

void Source::note_bad_byte(const Mark& mark, std::string message) {
    if (mark.line == last_bad_line_) return;
    last_bad_line_ = mark.line;
    ++bad_lines_;
    if (bad_bytes_.size() < most_bad_bytes) bad_bytes_.push_back({mark.offset, std::move(message)});
}

Source::Source(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
    Mark now;
    marks_.push_back(now);
    while (now.offset < text_.size()) {
        if (now.offset >= marks_.back().offset + mark_distance) marks_.push_back(now);
        const auto byte = static_cast<unsigned char>(text_[now.offset]);
        std::size_t bytes = 1;
        if (byte >= 0x80) {
            const Character next = first_character(text_.substr(now.offset));
            bytes = next.bytes;
            if (!next.is_valid())
                note_bad_byte(now, "expected UTF-8, found the byte " + hexadecimal(byte));
            else if (next.code < 0xA0 && next.code != 0x85)
                note_bad_byte(now, "found the control character " + code_point_name(next.code));
        } else if (byte < 0x20 || byte == 0x7F) {
            if (byte == 0)
                note_bad_byte(now, "expected a text, found a NUL byte");
            else if (!is_blank(byte))
                note_bad_byte(now, "found the control character " + code_point_name(byte));
        }
        if (byte == '\n') {
            ++now.line;
            now.column = 1;
        } else if (starts_character(text_[now.offset])) {
            ++now.column;
        }
        now.offset += bytes;
    }
}

Place Source::place(std::size_t offset) const {
    offset = std::min(offset, text_.size());
    auto mark = std::upper_bound(marks_.begin(), marks_.end(), offset,
                                 [](std::size_t here, const Mark& m) { return here < m.offset; });
    Mark now = *std::prev(mark);
    if (latest_.offset <= offset && latest_.offset > now.offset) now = latest_;
    for (; now.offset < offset; ++now.offset) {
        if (text_[now.offset] == '\n') {
            ++now.line;
            now.column = 1;
        } else if (starts_character(text_[now.offset])) {
            ++now.column;
        }
    }
    latest_ = now;
    return {file_, now.line, now.column};
}

std::size_t Source::offset(const Place& place) const {
    auto mark =
        std::upper_bound(marks_.begin(), marks_.end(), place, [](const Place& p, const Mark& m) {
            return std::pair(p.line, p.column) < std::pair(m.line, m.column);
        });
    Mark now = *std::prev(mark);
    while (now.offset < text_.size() &&
           std::pair(now.line, now.column) != std::pair(place.line, place.column)) {
        if (text_[now.offset] == '\n') {
            ++now.line;
            now.column = 1;
        } else if (starts_character(text_[now.offset])) {
            ++now.column;
        }
        ++now.offset;
        while (now.offset < text_.size() && !starts_character(text_[now.offset])) ++now.offset;
    }
    return now.offset;
}

Diagnostic Source::finding(std::size_t offset, std::string message) const {
    constexpr std::size_t longest = 120;  // columns of a line shown whole
    constexpr std::size_t before = 70, after = 40;
    Diagnostic out{place(offset), std::move(message), {}, 0};

    // The characters around the place, as code points that can be shown.
    const auto shown = [&](std::size_t from) {
        const Character next = first_character(text_.substr(from));
        if (!next.is_valid() || next.code < 0x20 || (next.code >= 0x7F && next.code < 0xA0))
            return std::string(is_blank(next.code) && next.is_valid() ? " " : "\uFFFD");
        return std::string(text_.substr(from, next.bytes));
    };
    std::vector<std::string> left, right;
    std::size_t begin = std::min(offset, text_.size());
    while (begin > 0 && text_[begin - 1] != '\n' && left.size() <= longest) {
        --begin;
        for (int i = 0; i < 3 && begin > 0 && !starts_character(text_[begin]); ++i) --begin;
        left.push_back(shown(begin));
    }
    std::size_t end = std::min(offset, text_.size());
    while (end < text_.size() && text_[end] != '\n' && right.size() <= longest) {
        right.push_back(shown(end));
        end += first_character(text_.substr(end)).bytes;
    }
    if (!right.empty() && right.back() == " ") right.pop_back();  // a carriage return
    std::reverse(left.begin(), left.end());
    if (left.size() + right.size() > longest) {
        if (left.size() > before) {
            left.erase(left.begin(), left.end() - static_cast<std::ptrdiff_t>(before));
            left.insert(left.begin(), "...");
        }
        if (right.size() > after) {
            right.resize(after);
            right.push_back("...");
        }
    }
    for (const std::string& character : left) out.caret += character == "..." ? 3 : 1;
    for (const std::string& character : left) out.line += character;
    for (const std::string& character : right) out.line += character;
    return out;
}

}  // namespace algae
