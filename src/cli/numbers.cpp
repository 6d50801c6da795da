#include "cli/numbers.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "base/error.hpp"

namespace algae::cli {

namespace {

bool all_digits(const std::string& text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

[[noreturn]] void refuse(const std::string& option, const std::string& expected, const std::string& found) {
    throw Error(option + ": expected " + expected + ", found \"" + found + '"');
}

}  // namespace

std::uint64_t natural(const std::string& option, const std::string& text) {
    if (!all_digits(text)) refuse(option, "a whole number from 0 on", text);
    const Integer value(text);
    if (bit_length(value) > 63) refuse(option, "a number below 2^63", text);
    return value.to_uint64();
}

std::pair<std::uint64_t, std::uint64_t> range(const std::string& option, const std::string& text) {
    const auto dots = text.find("..");
    if (dots == std::string::npos) {
        const std::uint64_t n = natural(option, text);
        return {n, n};
    }
    if (dots == 0 || dots + 2 == text.size()) refuse(option, "a range such as 0..6", text);
    const std::uint64_t first = natural(option, text.substr(0, dots));
    const std::uint64_t last = natural(option, text.substr(dots + 2));
    if (first > last) refuse(option, "a range that goes up, such as 0..6", text);
    if (last - first >= 100'000) refuse(option, "a range of at most 100000 generations", text);
    return {first, last};
}

std::uint64_t bytes(const std::string& option, const std::string& text) {
    std::string digits = text;
    unsigned shift = 0;
    if (!digits.empty()) {
        const auto unit = std::string("KMGT").find(static_cast<char>(std::toupper(static_cast<unsigned char>(digits.back()))));
        if (unit != std::string::npos) {
            shift = 10 * (static_cast<unsigned>(unit) + 1);
            digits.pop_back();
        }
    }
    if (!all_digits(digits) || digits.size() > 18) refuse(option, "a number of bytes such as 500000, 512M or 2G", text);
    const std::uint64_t value = natural(option, digits);
    if (shift > 0 && value >> (63 - shift) != 0) refuse(option, "less than 2^63 bytes", text);
    return value << shift;
}

double positive(const std::string& option, const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) || value <= 0)
        refuse(option, "a positive number", text);
    return value;
}

std::vector<std::string> list(const std::string& option, const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ',') parts.emplace_back();
        else parts.back() += c;
    }
    for (const std::string& part : parts)
        if (part.empty()) refuse(option, "a list with commas between, such as a,b", text);
    return parts;
}

nlohmann::json json_number(const Integer& value) {
    if (bit_length(value) <= 53) return value.to_int64();
    return to_string(value);
}

std::string readable(const Integer& value) {
    const std::string digits = to_string(value);
    if (digits.size() <= 60) return digits;
    return digits.substr(0, 20) + "... (" + std::to_string(digits.size()) + " digits)";
}

}  // namespace algae::cli
