#include <algorithm>
#include <array>
#include <utility>

#include "notation/detail/blank_byte.hpp"
#include "notation/notation.hpp"

// Texts, their places and what is found wrong with them.
//
// All texts of algae are UTF-8. A place is a line and a column counted in characters, as editors count them,
// so to find the place of a byte the text before it has to be walked over. `Source` walks once, to check the
// bytes, and keeps a mark every 4096 bytes; a place is then found from the mark before it, or from the last
// place that was asked for, as questions mostly come in order. Readers work with pointers into the text and
// ask for places only of what they keep or report.
//
// What a reader reports are findings: all of them at once, in the order of the text, each with its line and a
// caret, at most twenty. A message says what was expected and what was found (`found`), with a hint for
// frequent slips: a character that only looks like a minus sign, a name that is close to a known one
// (`did_you_mean`).

namespace algae {

namespace {

constexpr std::string_view hexadecimal_digits = "0123456789ABCDEF";

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

}  // namespace

Character first_character(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    if (lead < 0x80) return {lead, 1};
    if (lead < 0xC2 || lead > 0xF4) return {};
    const std::size_t bytes = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (text.size() < bytes) return {};
    char32_t code = lead & (0xFFU >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if (!is_continuation(text[i])) return {};
        code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3FU);
    }
    // Written longer than needed, half of a UTF-16 pair, or beyond Unicode.
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    if (code < least[bytes] || (code >= 0xD800 && code < 0xE000) || code > 0x10FFFF) return {};
    return {code, bytes};
}

bool is_blank(char32_t code) {
    if (code < 0x80) return code == ' ' || (code >= '\t' && code <= '\r');
    return code == 0x85 || code == 0xA0 || code == 0x1680 || (code >= 0x2000 && code <= 0x200B) ||
           code == 0x2028 || code == 0x2029 || code == 0x202F || code == 0x205F || code == 0x3000 ||
           code == 0xFEFF;
}

bool is_letter(char32_t code) {
    if (code < 0x80) return (code | 0x20) >= 'a' && (code | 0x20) <= 'z';
    if (code < 0xC0) return code == 0xAA || code == 0xB5 || code == 0xBA;
    if (code == 0xD7 || code == 0xF7 || code == 0x3B5) return false;  // times, divided by, epsilon
    return !(code >= 0x2000 && code < 0x2C00) && code != 0xFFFFFFFF && !is_blank(code);
}

bool is_false_minus(char32_t code) {
    return code == 0x2212 || (code >= 0x2010 && code <= 0x2015) || code == 0xFE63 || code == 0xFF0D;
}

std::string_view trimmed(std::string_view text) {
    const char* const end = text.data() + text.size();
    const char* blanks_from = text.data();  // where the blanks at the end begin
    const char* begin = nullptr;
    if (!text.empty() && static_cast<unsigned char>(text.front()) < 0x80 &&
        static_cast<unsigned char>(text.back()) < 0x80) {
        while (!text.empty() && is_blank_byte(text.front())) text.remove_prefix(1);
        while (!text.empty() && is_blank_byte(text.back())) text.remove_suffix(1);
        if (text.empty() || (static_cast<unsigned char>(text.front()) < 0x80 &&
                             static_cast<unsigned char>(text.back()) < 0x80))
            return text;
    }
    for (const char* here = text.data(); here != text.data() + text.size();) {
        const Character next =
            first_character({here, static_cast<std::size_t>(text.data() + text.size() - here)});
        if (!is_blank(next.code)) {
            if (!begin) begin = here;
            blanks_from = here + next.bytes;
        }
        here += next.bytes;
    }
    if (!begin) return {end, 0};
    return {begin, static_cast<std::size_t>(blanks_from - begin)};
}

std::vector<std::string_view> blank_separated(std::string_view text) {
    std::vector<std::string_view> found;
    std::size_t begin = 0;  // of a piece
    for (std::size_t here = 0; here < text.size();) {
        const Character next = first_character(text.substr(here));
        if (is_blank(next.code)) {
            if (here > begin) found.push_back(text.substr(begin, here - begin));
            begin = here + next.bytes;
        }
        here += next.bytes;
    }
    if (begin < text.size()) found.push_back(text.substr(begin));
    return found;
}

std::string code_point_name(char32_t code) {
    std::string hexadecimal;
    for (; code != 0 || hexadecimal.size() < 4; code >>= 4)
        hexadecimal += hexadecimal_digits[code & 15];
    std::reverse(hexadecimal.begin(), hexadecimal.end());
    return "U+" + hexadecimal;
}

std::string found(std::string_view rest) {
    if (rest.empty()) return "the end of the line";
    const Character first = first_character(rest);
    if (!first.is_valid()) return "a byte that is no character";
    if (is_blank(first.code)) return "a blank";
    if (first.code == ';') return "';'";
    if (is_false_minus(first.code))
        return "'" + std::string(rest.substr(0, first.bytes)) + "' (" +
               code_point_name(first.code) + "); did you mean '-'?";
    if (rest.starts_with("->")) return "'->'";
    // A whole name or number, unless it is very long.
    constexpr std::size_t longest = 60;
    std::size_t length = first.bytes;
    if (is_letter(first.code) || is_digit(first.code)) {
        while (length < rest.size() && length < longest) {
            const Character next = first_character(rest.substr(length));
            if (!is_letter(next.code) && !is_digit(next.code) && next.code != '_') break;
            length += next.bytes;
        }
    }
    return quoted(rest.substr(0, length));
}

void Source::note_bad_byte(const Mark& mark, std::string message) {
    if (mark.line == last_bad_line_) return;
    last_bad_line_ = mark.line;
    ++bad_lines_;
    if (bad_bytes_.size() < most_bad_bytes) bad_bytes_.push_back({mark.offset, std::move(message)});
}

void Source::advance(Mark& mark) const {
    if (text_[mark.offset] == '\n') {
        ++mark.line;
        mark.column = 1;
    } else if (!is_continuation(text_[mark.offset])) {
        ++mark.column;
    }
    ++mark.offset;
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
                note_bad_byte(now, std::string("expected UTF-8, found the byte 0x") +
                                       hexadecimal_digits[byte >> 4] +
                                       hexadecimal_digits[byte & 15]);
            else if (next.code < 0xA0 && next.code != 0x85)
                note_bad_byte(now, "found the control character " + code_point_name(next.code));
        } else if (byte < 0x20 || byte == 0x7F) {
            if (byte == 0)
                note_bad_byte(now, "expected a text, found a NUL byte");
            else if (!is_blank(byte))
                note_bad_byte(now, "found the control character " + code_point_name(byte));
        }
        for (; bytes > 0; --bytes) advance(now);
    }
}

Place Source::place(std::size_t offset) const {
    offset = std::min(offset, text_.size());
    auto mark = std::upper_bound(marks_.begin(), marks_.end(), offset,
                                 [](std::size_t here, const Mark& m) { return here < m.offset; });
    Mark now = *std::prev(mark);
    if (latest_.offset <= offset && latest_.offset > now.offset) now = latest_;
    while (now.offset < offset) advance(now);
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
        advance(now);
        while (now.offset < text_.size() && is_continuation(text_[now.offset])) ++now.offset;
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
        for (int i = 0; i < 3 && begin > 0 && is_continuation(text_[begin]); ++i) --begin;
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

SyntaxError unexpected(const std::string& expectation, const char* where) {
    return {where, "expected " + expectation + ", found ", false};
}

SyntaxError unknown_word(const std::string& expectation, std::string_view found,
                         const std::vector<std::string>& known) {
    return {found.data(),
            "expected " + expectation + ", found " + quoted(found) + did_you_mean(found, known)};
}

SyntaxError given_twice(std::string_view keyword, const char* first, const Source& source) {
    return {keyword.data(), quoted(keyword) + " is given twice, first in line " +
                                std::to_string(source.place(first).line)};
}

void Findings::add(const SyntaxError& error) {
    if (error.names_found) return add(error.where, error.message);
    const std::string_view text = source_.text();
    std::size_t here = source_.offset(error.where);
    while (here < text.size() && text[here] != '\n') {
        const Character next = first_character(text.substr(here));
        if (!is_blank(next.code)) break;
        here += next.bytes;
    }
    const bool is_comment =
        here > source_.offset(error.where) && text.substr(here).starts_with('#');
    if (here == text.size() || text[here] == '\n' || is_comment)
        return add(error.where, error.message + "the end of the line");
    add(here, error.message + found(text.substr(here, text.find('\n', here) - here)));
}

void Findings::add(std::size_t offset, std::string message) {
    ++count_;
    if (findings_.size() < most_kept) findings_.push_back({offset, std::move(message)});
}

void Findings::throw_if_no_text() {
    for (const Source::BadByte& bad : source_.bad_bytes()) add(bad.offset, bad.message);
    count_ += source_.bad_lines() - source_.bad_bytes().size();
    throw_if_any();
}

void Findings::throw_if_any() const {
    if (empty()) return;
    std::vector<Finding> sorted = findings_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Finding& a, const Finding& b) { return a.offset < b.offset; });
    const std::size_t shown = std::min(sorted.size(), most_shown);
    std::vector<Diagnostic> diagnostics;
    for (std::size_t i = 0; i < shown; ++i)
        diagnostics.push_back(source_.finding(sorted[i].offset, sorted[i].message));
    if (count_ > shown)
        diagnostics.push_back(
            {Place{source_.file(), 0, 0}, counted(count_ - shown, "more error"), {}, 0});
    throw Diagnostics(std::move(diagnostics));
}

std::size_t edit_distance(std::string_view left, std::string_view right) {
    const std::size_t width = right.size() + 1;
    std::vector<std::size_t> rows(3 * width);  // of a letter of `left`, and of the two before it
    std::size_t *row = rows.data(), *before = row + width, *earlier = before + width;
    for (std::size_t i = 0; i <= left.size(); ++i) {
        for (std::size_t j = 0; j < width; ++j) {
            if (i == 0 || j == 0) {
                row[j] = i + j;
                continue;
            }
            const std::size_t replaced = left[i - 1] == right[j - 1] ? 0 : 1;
            row[j] = std::min({before[j] + 1, row[j - 1] + 1, before[j - 1] + replaced});
            if (i > 1 && j > 1 && left[i - 1] == right[j - 2] && left[i - 2] == right[j - 1])
                row[j] = std::min(row[j], earlier[j - 2] + 1);
        }
        std::swap(earlier, before);
        std::swap(before, row);
    }
    return before[right.size()];
}

namespace {

/// A word as it is when small and capital letters are not told apart, nor a zero and the letter O.
std::string folded(std::string_view word) {
    std::string all;
    for (const char c : word)
        all += c == 'O' || c == 'o'
                   ? '0'
                   : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return all;
}

/// What others call by another word.
std::string_view usual_word(std::string_view word) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 14> words{
        {{"kleene", "star"},
         {"closure", "star"},
         {"concat", "concatenation"},
         {"product", "concatenation"},
         {"cup", "union"},
         {"cap", "intersection"},
         {"mirror", "reversal"},
         {"reverse", "reversal"},
         {"morphism", "homomorphism"},
         {"snowflake", "koch-snowflake"},
         {"color", "colour"},
         {"colors", "colours"},
         {"start", "axiom"},
         {"omega", "axiom"}}};
    const std::string plain = folded(word);
    for (const auto& [other, usual] : words)
        if (other.size() == plain.size() && folded(other) == plain) return usual;
    return word;
}

}  // namespace

std::string did_you_mean(std::string_view written, const std::vector<std::string>& candidates) {
    constexpr std::size_t shortest = 3, longest = 40;
    if (written.empty() || written.size() > longest) return {};
    const std::string usual = folded(usual_word(written));
    for (const std::string& candidate : candidates)
        if (candidate.size() == usual.size() && folded(candidate) == usual)
            return "; did you mean '" + candidate + "'?";
    const std::string* best = nullptr;
    std::size_t least = (written.size() + 1) / 4;  // further than this is another word
    for (const std::string& candidate : candidates) {
        if (written.size() < shortest || candidate.size() < shortest || candidate.size() > longest)
            continue;
        const std::size_t bound = least + (best ? 0 : 1);
        if (written.size() >= candidate.size() + bound ||
            candidate.size() >= written.size() + bound)
            continue;
        const std::size_t distance = edit_distance(written, candidate);
        if (distance >= bound) continue;
        best = &candidate;
        least = distance;
    }
    return best ? "; did you mean '" + *best + "'?" : "";
}

}  // namespace algae
