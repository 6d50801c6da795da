#include "exchange/brno_modules.hpp"

#include <cctype>
#include <set>

#include "exact/rational.hpp"
#include "exchange/polygon_letters.hpp"
#include "system/expression.hpp"

namespace algae {

namespace {

/// Every letter that occurs, in the order of the notation's symbols.
std::string letters_of(const BrnoSystem& system) {
    std::string letters;
    const auto add = [&](const std::string& word) {
        for (const char letter : word)
            if (letters.find(letter) == std::string::npos) letters += letter;
    };
    add(system.axiom);
    for (const auto& [letter, successor] : system.rules) add(letter + successor);
    return letters;
}

/// Writes what `interpret` and settings say of modules.
class Interpretations {
public:
    explicit Interpretations(const BrnoSystem& system)
        : system_(system), letters_(letters_of(system)) {
        std::map<char, std::string> rules;
        for (const auto& rule : system.rules) rules.insert(rule);
        drawn_ = polygon_letters(system.axiom, rules).outside;
    }

    std::string text() {
        const long length = equal_length();
        for (const char letter : letters_)
            if (std::isalpha(static_cast<unsigned char>(letter))) {
                const std::string own(1, letter);
                const std::string image = length > 0 ? step(letter) : measured(letter);
                const bool acts = own == "F" || own == "f" || own == "G";
                if (image != own && !(image == "ε" && !acts)) interpret(own, image);
            }
        const std::string angle = add_turns();
        return out_ + angle + (length > 1 ? "step " + std::to_string(length) + "\n" : "") + solids_;
    }

private:
    BrnoPrimitive primitive(char letter) const {
        const auto found = system_.modules.find(letter);
        return found == system_.modules.end() ? BrnoPrimitive() : found->second;
    }
    bool occurs(char letter) const { return letters_.find(letter) != std::string::npos; }

    /// A line that is nowhere but between braces is a side of a polygon.
    bool is_side(char letter) const { return !drawn_.contains(letter); }
    std::string step(char letter) const {
        if (primitive(letter).kind == 0) return "ε";
        return is_side(letter) ? "f" : "F";
    }

    /// The length of all lines if there is nothing but lines of one length, and F and f mean what
    /// they always do where others are to mean the same; otherwise 0.
    long equal_length() const {
        long length = 0;
        for (const char letter : letters_) {
            const BrnoPrimitive of = primitive(letter);
            if (of.kind == 0) continue;
            if (of.kind != 'P' || (length > 0 && of.length != length)) return 0;
            const char image = step(letter)[0];
            if (occurs(image) && (primitive(image).kind == 0 || step(image)[0] != image)) return 0;
            length = of.length;
        }
        return length;
    }

    std::string measured(char letter) {
        const BrnoPrimitive of = primitive(letter);
        const std::string length = '(' + std::to_string(of.length) + ')';
        if (of.kind == 'C') return "!(" + std::to_string(of.diameter) + ")F" + length;
        if (of.kind == 'P' && is_side(letter)) return 'f' + length;
        if (of.kind == 'P') return (has_cylinders() ? "!(1)F" : "F") + length;
        if (of.kind != 'S') return "ε";
        // F and f stand for steps elsewhere.
        const std::string ball = letter == 'F' || letter == 'f' ? "B_1" : std::string(1, letter);
        if (solids_.find(' ' + ball + ' ') == std::string::npos)
            solids_ += "solid " + ball + " sphere radius\n";
        return ball + '(' + shortest_text(Rational(of.diameter, 2)) + ')';
    }
    bool has_cylinders() const {
        for (const char letter : letters_)
            if (primitive(letter).kind == 'C') return true;
        return false;
    }

    /// Interprets turns by other angles than the first that is needed, which it gives.
    std::string add_turns() {
        long first = -1;
        for (const char vector : {'U', 'L', 'H'})
            for (const char* turn = brno_turns(vector); *turn; ++turn) {
                if (!occurs(*turn)) continue;
                const long angle = system_.angles.at(vector);
                if (first < 0) first = angle;
                const std::string own(1, *turn);
                if (angle != first) interpret(own, own + '(' + std::to_string(angle) + ')');
            }
        return first < 0 ? "" : "angle " + std::to_string(first) + "\n";
    }

    void interpret(const std::string& letter, const std::string& image) {
        out_ += "interpret " + letter + " -> " + image + "\n";
    }

    const BrnoSystem& system_;
    std::string letters_;
    std::set<char> drawn_;  // outside polygons
    std::string out_, solids_;
};

std::string word(const std::string& letters) { return letters.empty() ? "ε" : letters; }

}  // namespace

const char* brno_turns(char vector) { return vector == 'U' ? "+-" : vector == 'L' ? "&^" : "\\/"; }

std::string brno_notation(const BrnoSystem& system) {
    std::string out = "axiom " + word(system.axiom) + "\n";
    for (const auto& [letter, successor] : system.rules)
        out += letter + (" -> " + word(successor)) + "\n";
    return out + Interpretations(system).text();
}

}  // namespace algae
