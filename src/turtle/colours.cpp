#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "turtle/turtle.hpp"

// Colours by name: those of CSS that figures are likely to want, in the only list of their names; reading, printing and
// completion ask it.

namespace algae {
namespace {

struct NamedColour {
    std::string_view name;
    std::uint32_t code;
};

// The names of CSS Color Module Level 4 that figures are likely to want, in alphabetical order.
constexpr NamedColour names[] = {
    {"aqua", 0x00ffff},        {"aquamarine", 0x7fffd4},  {"beige", 0xf5f5dc},
    {"black", 0x000000},       {"blue", 0x0000ff},        {"brown", 0xa52a2a},
    {"chartreuse", 0x7fff00},  {"chocolate", 0xd2691e},   {"coral", 0xff7f50},
    {"crimson", 0xdc143c},     {"cyan", 0x00ffff},        {"darkblue", 0x00008b},
    {"darkcyan", 0x008b8b},    {"darkgray", 0xa9a9a9},    {"darkgreen", 0x006400},
    {"darkgrey", 0xa9a9a9},    {"darkmagenta", 0x8b008b}, {"darkolivegreen", 0x556b2f},
    {"darkorange", 0xff8c00},  {"darkred", 0x8b0000},     {"darkviolet", 0x9400d3},
    {"deeppink", 0xff1493},    {"deepskyblue", 0x00bfff}, {"dimgray", 0x696969},
    {"dimgrey", 0x696969},     {"dodgerblue", 0x1e90ff},  {"firebrick", 0xb22222},
    {"forestgreen", 0x228b22}, {"fuchsia", 0xff00ff},     {"gold", 0xffd700},
    {"goldenrod", 0xdaa520},   {"gray", 0x808080},        {"green", 0x008000},
    {"greenyellow", 0xadff2f}, {"grey", 0x808080},        {"hotpink", 0xff69b4},
    {"indianred", 0xcd5c5c},   {"indigo", 0x4b0082},      {"ivory", 0xfffff0},
    {"khaki", 0xf0e68c},       {"lavender", 0xe6e6fa},    {"lawngreen", 0x7cfc00},
    {"lightblue", 0xadd8e6},   {"lightgray", 0xd3d3d3},   {"lightgreen", 0x90ee90},
    {"lightgrey", 0xd3d3d3},   {"lime", 0x00ff00},        {"limegreen", 0x32cd32},
    {"magenta", 0xff00ff},     {"maroon", 0x800000},      {"midnightblue", 0x191970},
    {"navy", 0x000080},        {"olive", 0x808000},       {"olivedrab", 0x6b8e23},
    {"orange", 0xffa500},      {"orangered", 0xff4500},   {"orchid", 0xda70d6},
    {"palegreen", 0x98fb98},   {"peru", 0xcd853f},        {"pink", 0xffc0cb},
    {"plum", 0xdda0dd},        {"purple", 0x800080},      {"red", 0xff0000},
    {"royalblue", 0x4169e1},   {"saddlebrown", 0x8b4513}, {"salmon", 0xfa8072},
    {"seagreen", 0x2e8b57},    {"sienna", 0xa0522d},      {"silver", 0xc0c0c0},
    {"skyblue", 0x87ceeb},     {"slateblue", 0x6a5acd},   {"slategray", 0x708090},
    {"slategrey", 0x708090},   {"springgreen", 0x00ff7f}, {"steelblue", 0x4682b4},
    {"tan", 0xd2b48c},         {"teal", 0x008080},        {"tomato", 0xff6347},
    {"turquoise", 0x40e0d0},   {"violet", 0xee82ee},      {"wheat", 0xf5deb3},
    {"white", 0xffffff},       {"yellow", 0xffff00},      {"yellowgreen", 0x9acd32},
};

Colour from_code(std::uint32_t code) {
    const auto part = [code](int shift) { return ((code >> shift) & 255u) / 255.0; };
    return {part(16), part(8), part(0)};
}

/// How many letters must be inserted, left out or changed to make one text the other.
std::size_t edit_distance(std::string_view left, std::string_view right) {
    std::vector<std::size_t> row(right.size() + 1);
    for (std::size_t j = 0; j <= right.size(); ++j) row[j] = j;
    for (std::size_t i = 0; i < left.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < right.size(); ++j) {
            const std::size_t changed = diagonal + (left[i] != right[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j + 1] + 1, row[j] + 1, changed});
        }
    }
    return row.back();
}

Colour from_hexadecimal(std::string_view text) {
    const std::string_view digits = text.substr(1);
    const bool valid = (digits.size() == 3 || digits.size() == 6) &&
                       std::all_of(digits.begin(), digits.end(),
                                   [](unsigned char digit) { return std::isxdigit(digit) != 0; });
    if (!valid)
        throw Error("expected a colour like #080 or #008000, found \"" +
                    std::string(text.substr(0, 40)) + "\"");
    std::string six(digits);
    if (six.size() == 3) six = {six[0], six[0], six[1], six[1], six[2], six[2]};
    return from_code(static_cast<std::uint32_t>(std::stoul(six, nullptr, 16)));
}

}  // namespace

Colour colour_named(std::string_view text) {
    if (text.starts_with('#')) return from_hexadecimal(text);
    std::string name(text.substr(0, 40));
    for (char& letter : name)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    std::string_view nearest;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const NamedColour& candidate : names) {
        if (candidate.name == name && text.size() == name.size()) return from_code(candidate.code);
        const std::size_t distance = edit_distance(name, candidate.name);
        if (distance < least) {
            least = distance;
            nearest = candidate.name;
        }
    }
    std::string message = "there is no colour \"" + std::string(text.substr(0, 40)) + "\"";
    if (least <= 1 + name.size() / 3)
        message += "; did you mean \"" + std::string(nearest) + "\"?";
    else
        message += "; expected a name such as \"red\" or \"darkgreen\", or a code such as #008000";
    throw Error(message);
}

std::vector<std::string_view> colour_names() {
    std::vector<std::string_view> all;
    for (const NamedColour& colour : names) all.push_back(colour.name);
    return all;
}

Colour hue(double degrees) {
    const auto part = [degrees](double peak) {
        const double away = std::fabs(std::remainder(degrees - peak, 360.0));
        return std::clamp(2.0 - away / 60.0, 0.0, 1.0);
    };
    return {part(0), part(120), part(240)};
}

}  // namespace algae
