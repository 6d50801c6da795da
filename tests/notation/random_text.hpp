#pragma once
// Random systems with every construct of the notation, made part by part as a reader would see them.

#include <rapidcheck.h>

#include <functional>
#include <string>
#include <vector>

namespace algae::random_text {

using Strings = std::vector<std::string>;

/// Where the choices come from: rapidcheck, or whatever a test or the fuzzer puts here.
inline std::function<int(int bound)> choose = [](int bound) { return *rc::gen::inRange(0, bound); };

inline int below(int bound) { return choose(bound); }
inline bool chance(int percent) { return below(100) < percent; }
inline std::string one_of(const Strings& choices) {
    return choices[static_cast<std::size_t>(below(static_cast<int>(choices.size())))];
}

/// A number as people write it.
inline std::string number() {
    return one_of({"0", "1", "2", "3", "0.5", ".25", "25.70", "1e-7", "12E3", "90", "137.5",
                   "0.000000000000000000000000125", "100000000000000000000000000000", "007"});
}

/// An expression over these names, with more brackets and blanks than it needs.
inline std::string expression(const Strings& names, int depth = 3) {
    const int kind = depth == 0 ? below(2) : below(8);
    if (kind == 0 || (kind == 1 && names.empty())) return number();
    if (kind == 1) return one_of(names);
    const auto part = [&] { return expression(names, depth - 1); };
    if (kind == 2) return one_of({"-", "!"}) + part();
    if (kind == 3) return '(' + part() + ')';
    if (kind == 4)
        return one_of({"sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp", "log", "abs",
                       "floor", "ceil"}) +
               '(' + part() + ')';
    if (kind == 5) return one_of({"min", "max "}) + '(' + part() + ", " + part() + ')';
    if (kind == 6)
        return '(' + part() + ") " +
               one_of({"<", "<=", ">", ">=", "=", "==", "!=", "≤", "≥", "≠"}) + " (" + part() + ')';
    // Operands in brackets half the time; a relation among them needs them always.
    const auto operand = [&] {
        return chance(50) ? '(' + part() + ')' : names.empty() ? number() : one_of(names);
    };
    return operand() + one_of({"+", "-", "*", "/", "^", " + ", " & ", "|", " ^ -"}) + operand();
}

/// The word without blanks next to `|`, which would separate successors.
inline std::string without_bars(std::string word) {
    for (const char* const blank : {" |", "| "})
        for (std::size_t at; (at = word.find(blank)) != std::string::npos;)
            word.replace(at, 2, "|");
    return word;
}

/// A symbol that needs no declaration, or a declared one if `longer`.
inline std::string symbol(bool longer) {
    static const Strings plain{"F",    "f", "G", "+", "-", "&",   "^",   "\\",   "/",   "|",
                               "{",    "}", ".", "!", "'", "$",   "%",   "~",    "@",   "*",
                               "\"",   "_", "0", "1", "2", "F_l", "F_r", "X_12", "X_1", "d",
                               "i",    "v", "I", "r", "e", "α",   "β_1", "∧",    "ü",   "?E",
                               "?X_2", "t", "l", "s", "u", "c",   "a",   "b",    "A",   "B"};
    static const Strings declared{"wall", "wallwindow", "F+", "+F",   "ab",
                                  "div_", "?wall",      "_",  "F_lG", "ti"};
    return one_of(longer && chance(30) ? declared : plain);
}

struct Options {
    bool longer = false;
    Strings constants;
};

inline std::string arguments(const Strings& names, int count) {
    std::string out = "(";
    for (int i = 0; i < count; ++i) out += (i > 0 ? "," : "") + expression(names);
    return out + ')';
}

inline std::string word(const Options& options, const Strings& names, bool parametric) {
    std::string out;
    const int letters = below(8);
    int open = 0;
    for (int i = 0; i < letters; ++i) {
        if (chance(15)) {
            out += '[';
            ++open;
        }
        out += symbol(options.longer);
        if (parametric && chance(40)) out += arguments(names, 1 + below(2));
        if (chance(30)) out += ' ';
        if (open > 0 && chance(30)) {
            out += ']';
            --open;
        }
    }
    out += std::string(static_cast<std::size_t>(open), ']');
    return options.longer ? out : without_bars(std::move(out));
}

/// A word of modules with formal parameters, which are added to `names`.
inline std::string pattern(const Options& options, int most, Strings& names,
                           const char* separator) {
    std::string out;
    const int modules = 1 + below(most);
    for (int i = 0; i < modules; ++i) {
        if (i > 0) out += separator;
        out += symbol(options.longer);
        if (!chance(40)) continue;
        const int count = 1 + below(2);
        for (int j = 0; j < count; ++j) {
            names.push_back(one_of({"x", "y", "long_name", "ä"}) + std::to_string(names.size()));
            out += (j == 0 ? "(" : ", ") + names.back();
        }
        out += ')';
    }
    return out;
}

inline std::string left_side(const Options& options, Strings& names) {
    std::string out;
    if (chance(30)) out += pattern(options, 3, names, "") + " < ";
    out += pattern(options, 1, names, "");
    if (chance(30)) out += " > " + pattern(options, 3, names, "");
    if (chance(20)) out += " ? " + pattern(options, 3, names, " , ");
    if (chance(30)) out += " : " + expression(names);
    return "ε " + out;
}

inline std::string successor(const Options& options, const Strings& names) {
    const int kind = below(12);
    const std::string parts = "{ F wall+ X_1 G }";
    if (kind == 0)
        return (chance(50) ? "div(Y, " : "div(ZX, 1r, 3 : ") + expression(names) + ", (" +
               expression(names) + ") r, 2r)" + parts;
    if (kind == 1) return "repeat(X, " + expression(names) + ")" + parts;
    if (kind == 2 && names.empty()) return "I( B )";
    return word(options, names, true);
}

/// One rule, or several with probabilities that add up to 1.
inline std::string rules(const Options& options, const std::string& before = "") {
    Strings names;
    const std::string left = left_side(options, names);
    Strings all = names;
    all.insert(all.end(), options.constants.begin(), options.constants.end());
    const auto rule = [&](const std::string& arrow) {
        return before + left + arrow + successor(options, all) + '\n';
    };
    if (!options.longer && chance(20)) {
        const auto alternative = [&] {
            const std::string next = successor(options, all);
            // The turn alone would be one more separator.
            return next.empty() ? std::string("ε") : next == "|" ? std::string("||") : next;
        };
        std::string alternatives = alternative();
        for (int i = below(3); i >= 0; --i) {
            alternatives += " | " + alternative();
        }
        return before + left + " -> " + alternatives + '\n';
    }
    if (chance(70)) return rule(chance(50) ? " -> " : " →");  // the blank parts it from (x)
    return rule(" -(1/3)-> ") + rule(" -(2/3)→ ");
}

/// The text of a whole system. Left sides may repeat, so that the check of probabilities can fail.
inline std::string system() {
    Options options;
    std::string out;
    if (chance(50)) out += "title A title -> of (many) words: < > = ? , ü\n";
    if (chance(50)) out += "source 000 fig. 2.8; id A-1 A-2 # c\nid B\n";
    options.longer = chance(40);
    // The constants are plain, as a value that cannot be computed is an error.
    const int constants = below(4);
    for (int i = 0; i < constants; ++i) {
        const std::string name = 'k' + std::to_string(i);
        out += "let " + name + " = " + one_of({"1/2", "2^-3", "sqrt(2)", "(1+2)*3", "-1"}) + '\n';
        options.constants.push_back(name);
    }
    if (chance(30)) out += "angle 360/7\nstep (2)\nshrink 1/sqrt(2)\nstart -1 ((1+1)) (1 < 2)\n";
    if (chance(30)) out += "spin 2*45;scale 2;narrow 0.5;width 0.25;colour red #0123Af along\n";
    if (chance(20)) out += "environment ?E clip 0 (1 < 2) 1 2*3 ; environment ?X_2 light (.50)\n";
    if (chance(20)) out += "environment ?P position\n";
    if (chance(20)) out += "turn clockwise\ngeneration 3..7\nseed 2..5\n";
    if (chance(20)) out += "stamp G circle; plot F G ; stamp T_1 triangle\n";
    if (chance(20))
        out += "camera 30 (1+1) perspective\nlight 3 -90; fog 1/2 ; tropism 0 (1 < 2) -.5 before\n";
    if (chance(20))
        out +=
            "susceptibility 2^-2; elasticity  T_9; solid F_l _typeCone _height; solid B_2 sphere "
            "colour\n";
    if (chance(20)) out += "surface ~ petal ; surface D polygon (0,0,0)(1,0,0) ( 0 , 1+1,(2)) \n";
    if (chance(20)) out += "expect length 3: 148\nexpect end 2: 1/2 0\n";
    const bool tables = chance(20);
    const int count = below(8);
    Strings opened;
    for (int i = 0; i < count; ++i) {
        if (tables && (i == 0 || chance(30))) {
            opened.push_back('t' + std::to_string(i));
            out += "table " + opened.back() + '\n';
        }
        out += rules(options);
    }
    if (!opened.empty() && chance(50)) {
        out += "schedule";
        for (int i = 1 + below(6); i > 0; --i) out += ' ' + one_of(opened);
        out += '\n';
    }
    const std::string axiom = word(options, options.constants, true);
    out += "axiom " + (axiom.empty() ? "ε" : axiom) + '\n';
    if (chance(20)) out += "ignore + - F_l " + symbol(options.longer) + '\n';
    if (chance(20)) out += "terminals a b " + symbol(options.longer) + '\n';
    if (chance(20)) out += rules(options, "interpret ");
    if (options.longer) out += "alphabet wall wallwindow F+ +F ab div_ ?wall _ F_lG ti\n";
    return out;
}

}  // namespace algae::random_text
