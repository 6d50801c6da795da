#pragma once

#include <cctype>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "notation/notation.hpp"

namespace algae {

// What the readers of cpfg and L-Py share: texts whose characters know where they stood, the preprocessor, expressions.

/// Which of the three programs: cpfg, L-Py or lpfg, whose language is L+C.
struct CpfgDialect {
    bool python = false;
    const char* name = "cpfg";
    double angle = 45;
    bool plus = false;  // lpfg
};

/// The first letter of an axiom that stands the turtle up along z, where the notation looks for what is level.
inline constexpr const char* cpfg_upward = "X_118";

/// A text whose characters know where they stood.
struct Placed {
    std::string text;
    std::vector<std::size_t> at;

    void add(char c, std::size_t place) {
        text += c;
        at.push_back(place);
    }
    void append(const Placed& more) {
        text += more.text;
        at.insert(at.end(), more.at.begin(), more.at.end());
    }
    Placed part(std::size_t from, std::size_t to) const {
        to = std::min(to, text.size());
        from = std::min(from, to);
        return {text.substr(from, to - from),
                {at.begin() + static_cast<std::ptrdiff_t>(from),
                 at.begin() + static_cast<std::ptrdiff_t>(to)}};
    }
    Placed trimmed() const {
        std::size_t from = 0, to = text.size();
        while (from < to && std::isspace(static_cast<unsigned char>(text[from]))) ++from;
        while (to > from && std::isspace(static_cast<unsigned char>(text[to - 1]))) --to;
        return part(from, to);
    }
    std::size_t place(std::size_t i) const {
        return at.empty() ? 0 : i < at.size() ? at[i] : at.back() + 1;
    }
};

inline bool is_name_start(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
inline bool is_name_part(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The text without comments, with macros replaced; of L-Py without what its editor saves. Throws Diagnostics for directives other than #define, for
/// macros that go round in circles and comments that are never closed.
Placed preprocessed(const Source& source, const CpfgDialect& dialect);

/// Names that are no parameters, with what the notation says for them; nothing for one that it cannot say.
using CpfgNames = std::map<std::string, std::string>;

/// What is a whole number in C by its type: names, and the expression where it stands for such a parameter.
struct CpfgIntegers {
    std::set<std::string> names;
    bool wanted = false;
};

/// An expression in the notation, with the brackets that keep the grouping of the program. Names are those of parameters and `known` ones;
/// others are 0 in cpfg. Throws Diagnostics with the place of what is wrong or has no meaning in the notation.
std::string cpfg_expression(const Source& source, const CpfgDialect& dialect, const Placed& text,
                            const std::set<std::string>& names, const CpfgNames& known,
                            const CpfgIntegers& integers = {});

}  // namespace algae
