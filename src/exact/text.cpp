#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "exact/exact.hpp"

// The pieces that sentences and messages are made of, for all rooms: lists, counts, quotations, and machine numbers as decimals.
// Decimals are written by std::to_chars, so that they do not depend on a program's locale. Where the library converts integers
// only (libc++ 14), by streams that say the same.

namespace algae {

std::string joined(const std::vector<std::string>& texts, std::string_view between) {
    return joined(texts, between, std::identity());
}

std::string listed(const std::vector<std::string>& texts, std::string_view before_last) {
    std::string all;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (i > 0) all += i + 1 == texts.size() ? before_last : ", ";
        all += texts[i];
    }
    return all;
}

std::string counted(std::uint64_t count, std::string_view noun) {
    return std::to_string(count) + ' ' + std::string(noun) + (count == 1 ? "" : "s");
}

std::string with_article(const std::string& name) {
    return (!name.empty() && (name.front() == 'E' || name.front() == 'I') ? "an " : "a ") + name;
}

std::string beginning(std::string_view text, std::size_t longest) {
    if (text.size() <= longest) return std::string(text);
    std::size_t length = longest;
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
    return std::string(text.substr(0, length)) + "...";
}

std::string quoted(std::string_view text) { return '\'' + beginning(text, 40) + '\''; }

#ifdef __cpp_lib_to_chars

std::string shortest_decimal(double value) {
    std::array<char, 32> digits;
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string rounded_decimal(double value, int significant_digits) {
    std::array<char, 64> digits;
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                         std::chars_format::general, significant_digits)
                               .ptr};
}

#else

namespace {

std::string streamed(double value, int precision, std::ios_base::fmtflags notation = {}) {
    std::ostringstream out;
    out.exceptions(std::ios::badbit);
    out.imbue(std::locale::classic());
    out.flags(notation);
    out << std::setprecision(precision) << value;
    return out.str();
}

bool is_read_as(const std::string& text, double value) {
    std::istringstream in(text);
    in.exceptions(std::ios::badbit);
    in.imbue(std::locale::classic());
    double read = 0;
    in >> read;
    return read == value;
}

}  // namespace

std::string shortest_decimal(double value) {
    if (!std::isfinite(value)) return streamed(value, 1);
    int places = 0;  // after the point of the shortest number with an exponent
    std::string with_exponent = streamed(value, places, std::ios_base::scientific);
    while (!is_read_as(with_exponent, value) &&
           places + 1 < std::numeric_limits<double>::max_digits10)
        with_exponent = streamed(value, ++places, std::ios_base::scientific);
    const int exponent = std::stoi(with_exponent.substr(with_exponent.find('e') + 1));
    std::string without = streamed(value, std::max(0, places - exponent), std::ios_base::fixed);
    return without.size() <= with_exponent.size() ? without : with_exponent;
}

std::string rounded_decimal(double value, int significant_digits) {
    return streamed(value, significant_digits);
}

#endif

}  // namespace algae
