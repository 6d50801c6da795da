#pragma once
// Random text files of the Brno interpreter.

#include <rapidcheck.h>

#include <string>

#include "oracle/random_systems.hpp"

namespace algae::exchange_tests {

inline int below(int bound) { return *rc::gen::inRange(0, bound); }
inline std::string one_of(const std::vector<std::string>& choices) {
    return choices[static_cast<std::size_t>(below(static_cast<int>(choices.size())))];
}

/// White space, and comments where they may stand.
inline std::string gap() {
    return one_of({"", "", " ", "\n", "\t", " // A -> B,;\n", "\\\\ END\n", "\r\n"});
}

/// A word of modules with brackets that match, now and then with a leaf in it.
inline std::string brno_word(const std::string& letters, int most) {
    std::string word = oracle::balanced(*oracle::any_word(letters + "+-&^\\/|!", most));
    if (below(4) == 0) word += "[" + *oracle::any_word("bb+-|", 5) + "]";
    if (below(4) == 0) word += "{b" + *oracle::any_word("bb+-|&", 4) + "}";
    if (below(6) == 0) word.insert(0, "//");
    return word;
}

/// Blanks and line ends are put between the letters of a word.
inline std::string spread(const std::string& word) {
    std::string out;
    for (const char letter : word) out += letter + (below(6) == 0 ? one_of({" ", "\n", "\t"}) : "");
    return out;
}

/// `b` is the line that stands in polygons.
inline std::string any_brno_text() {
    const auto measure = [] { return std::to_string(1 + below(9)); };
    std::string out = gap() + "modules:" + gap() + "b" + gap() + "=P(" + measure() + ")";
    for (const char letter : std::string("FGfAXK")) {
        out += gap() + "," + gap() + letter + gap();
        switch (below(5)) {
            case 0:
                out += "= c(" + measure() + gap() + "," + measure() + ")";
                break;
            case 1:
                out += "=" + gap() + "P( " + measure() + ")";
                break;
            case 2:
                out += "=s (" + measure() + " )";
                break;
            default:
                break;
        }
    }
    const std::string letters = "FGfAXKFb[]";
    out += gap() + ";" + gap() + "axiom:" + spread(brno_word(letters, 5)) + ";" + gap();
    out += "angles:" + gap();
    for (const char* name : {"L", "U,", "H"})
        out += std::string(name[0] == 'L'   ? ""
                           : name[0] == 'U' ? ","
                                            : ",") +
               name[0] + " = " + std::to_string(below(361));
    out += ";" + gap() + "rules:" + gap();
    const std::string left = "FXA";
    for (int i = 0, count = 1 + below(3); i < count; ++i)
        out += (i > 0 ? "," + gap() : "") + left[static_cast<std::size_t>(i)] + gap() + "->" +
               spread(brno_word(letters, 5));
    return out + ";" + gap() + "END" + one_of({"", "\n", " notes -> ( \xff", "\n;;\x01"});
}

}  // namespace algae::exchange_tests
