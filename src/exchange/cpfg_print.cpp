#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"

// Systems as files of cpfg and of L-Py.
//
// The order of rules becomes the choice between them: those with the longest contexts come first, as the program takes the first that
// applies. What a turtle does with a symbol that has no parameter is said by the homomorphism, `+ --> +(60)`, since a file has no angle
// of its own; so words are the same in both. Expressions have brackets wherever operators meet, as the programs group some of them otherwise.
// Files do not say where a figure stands: it looks up the page there.

namespace algae {

namespace {

bool is_lpy_name(const std::string& said) {
    return std::ranges::any_of(lpy_names(), [&](const auto& one) { return one.first == said; });
}
bool holds_lpy_name(const std::string& said) {
    return std::ranges::any_of(
        lpy_names(), [&](const auto& one) { return said.find(one.first) != std::string::npos; });
}

class FilePrinter final : public FormatWriter {
public:
    FilePrinter(const Model& system, bool python)
        : FormatWriter(system, python ? "lpy" : "cpfg"), python_(python) {}

    std::string text() {
        check();
        std::string out = commented(python_ ? "# " : "// ", {system_.title, system_.source});
        for (const auto& [called, value] : system_.constants)
            out += (python_ ? called + " = " : "#define " + called + " ") +
                   expression(value.expression) + "\n";
        out += python_ ? declarations() : "Lsystem: 1\n";
        const auto& shown = system_.drawing.generations;
        const std::string generation = std::to_string(shown ? shown->second : 5);
        std::string header;
        if (is_stochastic()) {
            if (python_) refuse("probabilities: a choice is a program there");
            header += "seed: 1\n";
        }
        header += "derivation length: " + generation + "\n";
        if (!system_.ignored.empty()) {
            header += "ignore: ";
            for (const Symbol letter : system_.ignored) header += symbol(letter);
            header += "\n";
        }
        out += header + "Axiom: " + word(system_.axiom) + "\n";
        if (python_) out += "production:\n";
        const std::vector<const Production*> rules = rules_by_reach();
        for (const Production* rule : rules) out += line(*rule) + "\n";
        if (rules.empty()) out += "\n";
        const std::string drawn = homomorphism();
        if (!drawn.empty()) out += (python_ ? "interpretation:\n" : "homomorphism:\n") + drawn;
        return out + "endlsystem\n";
    }

private:
    bool is_stochastic() const {
        return std::ranges::any_of(
            system_.rules, [](const Production& rule) { return rule.probability.has_value(); });
    }

    void check() const {
        check_programs();
        if (system_.drawing.clockwise && turns_by_numbers())
            refuse("`turn clockwise` beside turns with numbers");
        std::map<std::pair<Symbol, std::size_t>, const Production*> chosen;
        for (const Production& rule : system_.rules) {
            if (!python_) check_branches(rule);
            if (!is_stochastic()) continue;
            if (rule.condition) refuse(rule, "it has a condition beside probabilities");
            const auto [entry, is_new] = chosen.try_emplace(
                {rule.predecessor.symbol, rule.predecessor.parameters.size()}, &rule);
            if (!is_new &&
                !(entry->second->left == rule.left && entry->second->right == rule.right))
                refuse(rule, "all rules that apply take part in the choice there");
        }
    }

    /// A branch in a context is the first of those that stand together there.
    void check_branches(const Production& rule) const {
        const auto opens = [&](const ModulePattern& one) { return name(one.symbol) == "["; };
        if (std::ranges::none_of(rule.right, opens)) return;
        std::vector<CpfgModule> context;
        for (const ModulePattern& one : rule.right) {
            context.emplace_back();
            context.back().symbol = name(one.symbol);
        }
        std::vector<CpfgWord> words;
        const auto add = [&](const std::string& owner, const ModuleWord& word) {
            words.push_back({owner, {}});
            for (const Symbol letter : word.letters) words.back().letters.push_back(name(letter));
        };
        add("", system_.axiom);
        for (const Production& one : system_.rules)
            add(name(one.predecessor.symbol), one.successor);
        std::set<std::string> skipped;
        for (const Symbol letter : system_.ignored) skipped.insert(name(letter));
        if (!only_first_branches_match(context, words, skipped))
            refuse(rule,
                   "a branch in a context is the first of those that stand together there, and "
                   "another of them may begin so");
    }

    std::string symbol(Symbol letter) const {
        const std::string& said = name(letter);
        if (python_ && is_module_name(said)) return module_name(said);
        if (said.size() != 1 || static_cast<unsigned char>(said[0]) >= 0x80)
            refuse("the letter " + said + ": symbols are " + (python_ ? "names of ASCII or " : "") +
                   "single characters of ASCII");
        if (std::string_view("*@~?$;,_#'%").find(said[0]) != std::string_view::npos)
            refuse("the letter " + said + ": it means something else there");
        if (!python_ && said == "/") return "\\";
        if (!python_ && said == "\\") return "/";
        return said;
    }

    /// Names of several characters that a file of L-Py declares; the turtle of the notation draws and moves with those of F and f.
    static bool is_module_name(const std::string& said) {
        return said.size() > 1 && std::isalpha(static_cast<unsigned char>(said[0])) &&
               !said.starts_with("F_") && !said.starts_with("f_") && !is_lpy_name(said) &&
               std::ranges::all_of(said, [](char c) {
                   return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
               });
    }
    /// Names such as X_36 stand for symbols when a file is read, which may not declare them: SX36.
    std::string module_name(const std::string& said) const {
        if (!said.starts_with("X_") || said.find_first_not_of("0123456789", 2) != std::string::npos)
            return said;
        std::string own = "SX" + said.substr(2);
        while (system_.alphabet.find(own)) own += "_";
        return own;
    }
    std::string declarations() const {
        std::vector<std::string> names;
        for (Symbol letter = 0; letter < system_.alphabet.size(); ++letter)
            if (python_ && is_module_name(name(letter))) names.push_back(symbol(letter));
        return names.empty() ? "" : "module " + joined(names, ", ") + "\n";
    }

    /// With `as_drawn`, as the turtle takes symbols without numbers.
    std::string word(const ModuleWord& written, bool as_drawn = false) const {
        if (written.letters.empty()) return python_ ? "" : "*";
        std::vector<std::string> parts;
        for (std::size_t i = 0; i < written.letters.size(); ++i) {
            const Symbol letter = written.letters[i];
            const auto arguments = written.arguments.find(i);
            const std::string drawn =
                as_drawn && arguments == written.arguments.end() ? turned(letter) : "";
            parts.push_back(drawn.empty() ? symbol(letter) : drawn);
            if (arguments == written.arguments.end()) continue;
            std::string numbers =
                joined(arguments->second, ",", [&](const Expression& e) { return expression(e); });
            if (as_drawn && says_step() && steps(letter))
                numbers =
                    "(" + expression(arguments->second[0]) + ")*" + amount(*system_.drawing.step);
            parts.back() += "(" + numbers + ")";
        }
        std::string out;
        // Together they could be a name that L-Py knows or the file declares.
        const bool apart =
            python_ && (!declarations().empty() || holds_lpy_name(joined(parts, "")));
        for (const std::string& part : parts) {
            // Two of them would begin a comment.
            if (!out.empty() && (apart || (out.ends_with('/') && part.starts_with('/'))))
                out += ' ';
            out += part;
        }
        return out;
    }

    std::string module(const ModulePattern& pattern) const {
        std::string out = symbol(pattern.symbol);
        if (!pattern.parameters.empty()) out += "(" + joined(pattern.parameters, ",") + ")";
        return out;
    }
    /// In cpfg `[B]` is a branch that holds nothing else, and `[B=]` one that begins so.
    std::string context(const Pattern& pattern) const {
        std::string out;
        for (const ModulePattern& one : pattern) {
            if (!python_ && name(one.symbol) == "]") out += "=";
            out += module(one);
        }
        return out;
    }

    std::string line(const Production& rule, bool as_drawn = false) const {
        std::string out;
        if (!rule.left.empty()) out += context(rule.left) + " < ";
        out += module(rule.predecessor);
        if (!rule.right.empty()) out += " > " + context(rule.right);
        if (rule.condition && python_) {
            const std::string made = word(rule.successor, as_drawn);
            return out + " :\n    if " + expression(*rule.condition) + " : produce" +
                   (made.empty() ? "" : " ") + made;
        }
        if (rule.condition) out += " : " + expression(*rule.condition);
        out += " --> " + word(rule.successor, as_drawn);
        if (rule.probability) out += " : " + number(*rule.probability);
        return out;
    }

    /// What the turtle does with symbols that have no parameters, and the interpretation of the file.
    std::string homomorphism() const {
        std::string out;
        std::set<std::pair<Symbol, std::size_t>> interpreted;
        for (const Production& rule : system_.interpretation)
            interpreted.emplace(rule.predecessor.symbol, rule.predecessor.parameters.size());
        std::set<Symbol> bare = bare_symbols(system_.axiom);
        const auto add = [&](const ModuleWord& more) {
            for (const Symbol letter : bare_symbols(more)) bare.insert(letter);
        };
        std::set<Symbol> by_numbers;
        const auto add_numbers = [&](const ModuleWord& word) {
            for (const auto& [place, numbers] : word.arguments)
                if (numbers.size() == 1) by_numbers.insert(word.letters[place]);
        };
        add_numbers(system_.axiom);
        for (const Production& rule : system_.rules) {
            add(rule.successor);
            add_numbers(rule.successor);
        }
        for (const Symbol letter : by_numbers)
            if (name(letter) == "g" && !interpreted.contains({letter, 1}))
                out += nothing(name(letter) + "(x)");
        if (says_step())
            for (const Symbol letter : by_numbers)
                if (steps(letter) && !interpreted.contains({letter, 1}))
                    out += name(letter) + "(x) --> " + name(letter) + "(x*" +
                           amount(*system_.drawing.step) + ")\n";
        for (const Symbol letter : bare) {
            if (interpreted.contains({letter, 0})) continue;
            if (name(letter) == "g") out += nothing(name(letter));
            if (const std::string drawn = turned(letter); !drawn.empty())
                out += symbol(letter) + " --> " + drawn + "\n";
        }
        for (const Production& rule : system_.interpretation) {
            if (rule.probability || !rule.left.empty() || !rule.right.empty())
                refuse(rule, "it is an interpretation with contexts or chance");
            for (std::size_t i = 0; i < rule.successor.letters.size(); ++i) {
                const auto arguments = rule.successor.arguments.find(i);
                const std::size_t arity =
                    arguments == rule.successor.arguments.end() ? 0 : arguments->second.size();
                if (interpreted.contains({rule.successor.letters[i], arity}))
                    refuse(rule, "it is an interpretation of what another one gives");
            }
            out += line(rule, true) + "\n";
        }
        return out;
    }

    /// That a module which moves the turtle there does nothing.
    std::string nothing(const std::string& module) const {
        return module + " -->" + (python_ ? "" : " *") + "\n";
    }

    /// What the turtle does with a symbol without a number where that is other than there: + by 60 degrees is +(60), and -(60) where turns are
    /// clockwise. Otherwise nothing.
    std::string turned(Symbol letter) const {
        const std::string& said = name(letter);
        const Drawing& drawing = system_.drawing;
        const Quantity angle = drawing.angle.value_or(quantity(Rational(90)));
        const bool is_plane = said == "+" || said == "-";
        if (is_plane && drawing.clockwise) return (said == "+" ? "-(" : "+(") + amount(angle) + ")";
        const bool turns =
            said.size() == 1 && std::string_view("+-&^\\/").find(said) != std::string_view::npos;
        if (turns && angle.value != (python_ ? 60 : 45))
            return symbol(letter) + "(" + amount(angle) + ")";
        if (says_step() && steps(letter)) return said + "(" + amount(*drawing.step) + ")";
        return "";
    }
    bool says_step() const { return system_.drawing.step && system_.drawing.step->value != 1; }
    bool steps(Symbol letter) const {
        return name(letter) == "F" || name(letter) == "f" || name(letter) == "G";
    }
    /// Whether + or - has a number somewhere.
    bool turns_by_numbers() const {
        const auto holds = [&](const ModuleWord& written) {
            return std::ranges::any_of(written.arguments, [&](const auto& entry) {
                const std::string& said = name(written.letters[entry.first]);
                return said == "+" || said == "-";
            });
        };
        bool found = holds(system_.axiom);
        for (const auto* rules : {&system_.rules, &system_.interpretation})
            for (const Production& rule : *rules) found = found || holds(rule.successor);
        return found;
    }

    static std::set<Symbol> bare_symbols(const ModuleWord& written) {
        std::set<Symbol> found;
        for (std::size_t i = 0; i < written.letters.size(); ++i)
            if (!written.arguments.contains(i)) found.insert(written.letters[i]);
        return found;
    }

    std::string amount(const Quantity& value) const {
        return value.exact ? number(*value.exact) : shortest_decimal(value.value);
    }

    /// A number as the programs read it: a decimal, or a quotient between brackets.
    static std::string number(const Rational& value) {
        const auto decimal = exact_decimal(value);
        return decimal ? *decimal : "(" + to_string(value) + ")";
    }

    std::string expression(const Expression& said) const {
        switch (said.kind) {
            case Expression::Kind::number: {
                const std::string digits = number(said.value);
                return sign(said.value) < 0 ? "(" + digits + ")" : digits;
            }
            case Expression::Kind::name:
                return said.name;
            case Expression::Kind::unary: {
                const std::string inside = expression(said.operands[0]);
                return "(" + (python_ && said.name == "!" ? "not " : said.name) + "(" + inside +
                       "))";
            }
            case Expression::Kind::binary: {
                static const std::map<std::string, std::pair<const char*, const char*>> signs{
                    {"=", {"==", "=="}},
                    {"&", {"&&", " and "}},
                    {"|", {"||", " or "}},
                    {"^", {"^", "**"}}};
                const auto other = signs.find(said.name);
                const std::string operation = other == signs.end() ? said.name
                                              : python_            ? other->second.second
                                                                   : other->second.first;
                return "(" + expression(said.operands[0]) + operation +
                       expression(said.operands[1]) + ")";
            }
            case Expression::Kind::call: {
                const bool extreme = said.name == "min" || said.name == "max";
                const bool radians = said.name.ends_with("sin") || said.name.ends_with("cos") ||
                                     said.name.ends_with("tan");
                if ((extreme && !python_) || (radians && python_) || said.name == "distance" ||
                    said.name == "length")
                    refuse("the function " + said.name);
                return (said.name == "abs" && !python_ ? "fabs" : said.name) + "(" +
                       joined(said.operands, ",",
                              [&](const Expression& e) { return expression(e); }) +
                       ")";
            }
            case Expression::Kind::word:
                refuse("words as parameters");
        }
        return "";
    }

    bool python_;
};

}  // namespace

std::string print_cpfg(const Model& system) { return FilePrinter(system, false).text(); }
std::string print_lpy(const Model& system) { return FilePrinter(system, true).text(); }

}  // namespace algae
