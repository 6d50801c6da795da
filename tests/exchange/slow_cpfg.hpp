#pragma once
// Words of cpfg as the program derives them, step by step and module by module, without the library.

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "turtle/turtle.hpp"

namespace algae::exchange_tests {

struct SlowModule {
    char symbol = 0;
    std::string value;  // the text of its only number, or empty
};
using SlowWord = std::vector<SlowModule>;

/// `left < symbol > right : Q < below --> successor`; in the successor the value `Q` stands for the number of the step.
struct SlowRule {
    std::string left;
    char symbol = 0;
    std::string right;
    std::optional<int> below;
    SlowWord successor;
};

struct SlowSystem {
    SlowWord axiom;
    std::string ignored;
    std::vector<SlowRule> rules;
    bool ring = false;

    bool skips(char symbol) const { return ignored.find(symbol) != std::string::npos; }

    static std::string text(const SlowWord& word) {
        std::string out;
        for (const SlowModule& module : word) {
            out += module.symbol;
            if (!module.value.empty()) out += "(" + module.value + ")";
        }
        return out;
    }

    std::string file() const {
        std::string out = "Lsystem: 1\nderivation length: 3\n";
        if (ring) out += "ring lsystem\n";
        if (!ignored.empty()) out += "ignore: " + ignored + "\n";
        out += "Axiom: " + text(axiom) + "\n";
        for (const SlowRule& rule : rules) {
            if (!rule.left.empty()) out += rule.left + " < ";
            out += rule.symbol;
            if (!rule.right.empty()) out += " > " + rule.right;
            if (rule.below) out += " : Q < " + std::to_string(*rule.below);
            out += " --> " + (rule.successor.empty() ? "*" : text(rule.successor)) + "\n";
        }
        return out + "endlsystem\n";
    }

    /// The end of the branch in which a place is.
    static std::size_t branch_end(const SlowWord& word, std::size_t at) {
        for (int depth = 0; at < word.size(); ++at) {
            if (word[at].symbol == '[') ++depth;
            if (word[at].symbol == ']' && depth-- == 0) break;
        }
        return at;
    }

    /// As the program goes through a right context: `=` skips to the end of the branch, other branches are skipped where none is named.
    bool fits_right(const SlowWord& word, std::size_t at, const std::string& context) const {
        for (std::size_t i = 0, steps = 0; i < context.size(); ++steps) {
            if (ring && at == word.size()) at = 0;
            if (steps > 2 * word.size() + 2) return false;  // nothing is seen
            if (context[i] == '=') {
                at = branch_end(word, at);
                ++i;
                continue;
            }
            if (at == word.size()) return false;
            const SlowModule& here = word[at];
            if (skips(here.symbol)) {
                ++at;
            } else if (here.symbol == '[' && context[i] != '[') {
                at = branch_end(word, at + 1) + 1;
            } else {
                if (here.symbol != context[i] || !here.value.empty()) return false;
                ++at;
                ++i;
            }
        }
        return true;
    }

    bool fits_left(const SlowWord& word, std::size_t at, std::string context) const {
        for (std::size_t steps = 0; !context.empty(); ++steps) {
            if (ring && at == 0) at = word.size();
            if (at == 0 || steps > 2 * word.size() + 2) return false;
            const SlowModule& here = word[--at];
            if (here.symbol == ']') {
                for (int depth = 1; depth > 0;) {
                    --at;
                    depth += word[at].symbol == ']' ? 1 : word[at].symbol == '[' ? -1 : 0;
                }
            } else if (here.symbol != '[' && !skips(here.symbol)) {
                if (here.symbol != context.back() || !here.value.empty()) return false;
                context.pop_back();
            }
        }
        return true;
    }

    SlowWord next(const SlowWord& word, int step) const {
        SlowWord out;
        for (std::size_t at = 0; at < word.size();) {
            const SlowRule* used = nullptr;
            for (const SlowRule& rule : rules)
                if (!used && word[at].symbol == rule.symbol && word[at].value.empty() &&
                    fits_right(word, at + 1, rule.right) && fits_left(word, at, rule.left) &&
                    (!rule.below || step < *rule.below))
                    used = &rule;
            if (used) {
                for (const SlowModule& module : used->successor)
                    out.push_back(
                        {module.symbol, module.value == "Q" ? std::to_string(step) : module.value});
                ++at;
            } else if (word[at].symbol == '%') {
                at = branch_end(word, at + 1);
            } else {
                out.push_back(word[at++]);
            }
        }
        return out;
    }

    /// Without what `%` cuts in the next step.
    static SlowWord kept(const SlowWord& word) {
        SlowWord out;
        for (std::size_t at = 0; at < word.size();)
            if (word[at].symbol == '%')
                at = branch_end(word, at + 1);
            else
                out.push_back(word[at++]);
        return out;
    }
};

/// The word of a generation of a system that was read: without the letters that only the notation needs.
inline SlowWord own_word(const Model& system, std::uint64_t n) {
    const DerivedModules derived = derived_modules(system, n, {});
    std::string said = ModuleText(system.alphabet, derived.kinds).text(derived.word);
    std::erase(said, ' ');
    if (said == "ε") said.clear();
    SlowWord word;
    for (std::size_t at = 0; at < said.size();) {
        std::string name(1, said[at++]);
        if (name == "X" && at < said.size() && said[at] == '_')
            while (at < said.size() &&
                   (said[at] == '_' || std::isdigit(static_cast<unsigned char>(said[at])) != 0))
                name += said[at++];
        SlowModule module{name == "X_38" ? '%' : name[0], ""};
        if (at < said.size() && said[at] == '(') {
            const std::size_t end = said.find(')', at);
            module.value = said.substr(at + 1, end - at - 1);
            at = end + 1;
        }
        const bool is_end = name.size() == 6;  // X_1000
        if (name != "X_60" && name != "X_81" && name != "X_93" && !is_end) word.push_back(module);
    }
    return word;
}

}  // namespace algae::exchange_tests
