#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "turtle/turtle.hpp"

// Colours by name: those of CSS that figures are likely to want, in the only list of their names; reading, printing and
// completion ask it. And colours for many places of a word, even to the eye.

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
    if (name == "currentcolor") return {};  // what a page decides is black elsewhere
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

namespace {

// Oklab (Ottosson 2020): lightness, and two axes of colour whose distances are those that one sees.

struct Oklab {
    double lightness = 0, a = 0, b = 0;
};

double to_linear(double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

double from_linear(double part) {
    return part <= 0.0031308 ? 12.92 * part : 1.055 * std::pow(part, 1 / 2.4) - 0.055;
}

Oklab oklab(const Colour& colour) {
    const double r = to_linear(colour.red), g = to_linear(colour.green), b = to_linear(colour.blue);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b),
                 m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b),
                 s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

/// Parts below 0 or above 1 are those of no screen.
Colour linear_rgb(const Oklab& lab) {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lab.lightness + 0.3963377774 * lab.a + 0.2158037573 * lab.b),
                 m = cube(lab.lightness - 0.1055613458 * lab.a - 0.0638541728 * lab.b),
                 s = cube(lab.lightness - 0.0894841775 * lab.a - 1.2914855480 * lab.b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

/// The most vivid colour of this lightness and these axes' direction that a screen has, up to these axes themselves.
Colour shown(Oklab lab) {
    const auto within = [&](double share) {
        const Colour rgb = linear_rgb({lab.lightness, share * lab.a, share * lab.b});
        const auto [least, most] = std::minmax({rgb.red, rgb.green, rgb.blue});
        return least >= -1e-6 && most <= 1 + 1e-6;
    };
    double share = 1;
    if (!within(share)) {
        double inside = 0, outside = 1;
        for (int i = 0; i < 20; ++i) {
            const double middle = (inside + outside) / 2;
            (within(middle) ? inside : outside) = middle;
        }
        share = inside;
    }
    const Colour rgb = linear_rgb({lab.lightness, share * lab.a, share * lab.b});
    const auto part = [](double value) { return from_linear(std::clamp(value, 0.0, 1.0)); };
    return {part(rgb.red), part(rgb.green), part(rgb.blue)};
}

/// How light a colour is to WCAG 2.
double luminance(const Colour& colour) {
    return 0.2126 * to_linear(colour.red) + 0.7152 * to_linear(colour.green) +
           0.0722 * to_linear(colour.blue);
}

double contrast(const Colour& one, const Colour& other) {
    const auto [dark, light] = std::minmax({luminance(one), luminance(other)});
    return (light + 0.05) / (dark + 0.05);
}

// Colours of the schemes at equal shares, between which it is straight (van der Walt and Smith 2015, public domain; Nuñez, Anderton and Renslow 2018).
constexpr std::uint32_t viridis[] = {0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c,
                                     0x28ae80, 0x5ec962, 0xaddc30, 0xfde725};
constexpr std::uint32_t cividis[] = {0x00204d, 0x00336f, 0x39486b, 0x575c6d, 0x707173,
                                     0x8a8779, 0xa69d75, 0xc4b56c, 0xe4cf5b, 0xffea46};

Colour between(std::span<const std::uint32_t> codes, double share) {
    const double at = share * static_cast<double>(codes.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(at), codes.size() - 2);
    const double rest = at - static_cast<double>(below);
    const Colour low = from_code(codes[below]), high = from_code(codes[below + 1]);
    if (rest == 1) return high;
    return {low.red + rest * (high.red - low.red), low.green + rest * (high.green - low.green),
            low.blue + rest * (high.blue - low.blue)};
}

/// Hues of one lightness, which are read on white (3 to 1) and on black (6 to 1).
Colour on_circle(double share) {
    constexpr double lightness = 0.65, vivid = 0.16, first = 25;  // degrees: it begins with red
    const double angle = (first + 360 * share) * std::numbers::pi / 180;
    return shown({lightness, vivid * std::cos(angle), vivid * std::sin(angle)});
}

}  // namespace

const std::vector<std::string>& colour_schemes() {
    static const std::vector<std::string> names_of_schemes{"along", "viridis", "cividis"};
    return names_of_schemes;
}

bool is_scheme(std::string_view name) {
    return std::ranges::find(colour_schemes(), name) != colour_schemes().end();
}

Colour scheme_colour(std::string_view scheme, double share) {
    const double within = std::clamp(share, 0.0, 1.0);
    if (scheme == "along") return on_circle(within);
    if (scheme == "viridis") return between(viridis, within);
    if (scheme == "cividis") return between(cividis, within);
    throw Error("expected along, viridis or cividis, found \"" + std::string(scheme.substr(0, 40)) +
                '"');
}

Colour readable_on(const Colour& colour, const Colour& background) {
    constexpr double enough = 3;
    if (contrast(colour, background) >= enough) return colour;
    Oklab lab = oklab(colour);
    const bool lighter = luminance(background) < 0.18;  // white has more contrast there than black
    double still = lab.lightness, read = lighter ? 1 : 0;
    for (int i = 0; i < 20; ++i) {
        lab.lightness = (still + read) / 2;
        (contrast(shown(lab), background) >= enough ? read : still) = lab.lightness;
    }
    lab.lightness = read;
    return shown(lab);
}

}  // namespace algae
