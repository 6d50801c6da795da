#pragma once
// What a file of JFLAP says, between its reader and the source that says it in the notation.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "notation/notation.hpp"

namespace algae {

struct Model;

/// A symbol, or another piece of the text, and where it stands.
struct JflapToken {
    std::string text;
    std::size_t offset = 0;
};
using JflapWord = std::vector<JflapToken>;

struct JflapRule {
    JflapWord left;         // the neighbourhood
    std::size_t index = 0;  // of the symbol that is rewritten
    std::vector<JflapWord> rights;
};

struct JflapSystem {
    JflapWord axiom;
    std::vector<JflapRule> rules;
    bool has_context = false;
    std::map<std::string, std::string> parameters;  // numbers, by their names
    std::string colour;                             // that of the parameter
};

inline bool is_jflap_colour(const std::string& name) {
    return name == "color" || name == "polygonColor";
}
/// Whether a token is the number of a symbol before a context.
inline bool is_jflap_index(const std::string& text) {
    return !text.empty() && text.size() < 6 &&
           text.find_first_not_of("0123456789") == std::string::npos;
}
/// The variable that a name stands for.
inline std::string jflap_variable(const std::string& name) {
    return name == "angleIncrement" ? "angle" : name;
}

/// The model that a system is in the notation. Throws Diagnostics with the places of what it cannot say.
Model jflap_model(const Source& source, JflapSystem system);

}  // namespace algae
