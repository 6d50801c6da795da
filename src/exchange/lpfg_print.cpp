#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exchange/detail/formats.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"

// Systems as programs of lpfg in L+C.
//
// All modules are names there, which are declared with their parameters, and those of the turtle have the numbers that they need. So `F` and `+`
// are F(1) and Left(60), as people write it, wherever no letter of the system is F with a number already and nothing else stands in the way; then
// the letter is a module of its own, and the interpretation says what it draws. A letter that is used with several numbers of parameters is a
// module for each. Numbers are `float`, and quotients of whole numbers are written as those of numbers that are not.

namespace algae {

namespace {

/// A letter with its number of parameters.
using Kind = std::pair<Symbol, std::size_t>;

/// The modules of the turtle by the letters of the notation, with the number of their parameters.
struct TurtleName {
    const char* letter;
    const char* module;
    std::size_t parameters;
};
constexpr TurtleName turtle_names[] = {
    {"F", "F", 1},       {"f", "f", 1},          {"G", "G", 1},  {"+", "Left", 1},
    {"-", "Right", 1},   {"&", "Down", 1},       {"^", "Up", 1}, {"/", "RollL", 1},
    {"\\", "RollR", 1},  {"|", "TurnAround", 0}, {"[", "SB", 0}, {"]", "EB", 0},
    {"{", "SP", 0},      {"}", "EP", 0},         {".", "PP", 0}, {"!", "SetWidth", 1},
    {"'", "SetColor", 1}};

/// What names of modules, constants and parameters may not be.
bool is_reserved(const std::string& said) {
    static const std::set<std::string> all{"f",
                                           "g",
                                           "F",
                                           "G",
                                           "Left",
                                           "Right",
                                           "Down",
                                           "Up",
                                           "RollL",
                                           "RollR",
                                           "TurnAround",
                                           "RollToVert",
                                           "SB",
                                           "EB",
                                           "SP",
                                           "EP",
                                           "PP",
                                           "SetWidth",
                                           "SetColor",
                                           "IncColor",
                                           "Sphere",
                                           "Cut",
                                           "Axiom",
                                           "axiom",
                                           "derivation",
                                           "length",
                                           "ignore",
                                           "consider",
                                           "production",
                                           "productions",
                                           "decomposition",
                                           "homomorphism",
                                           "interpretation",
                                           "maximum",
                                           "depth",
                                           "ring",
                                           "Start",
                                           "StartEach",
                                           "End",
                                           "EndEach",
                                           "module",
                                           "produce",
                                           "nproduce",
                                           "alignas",
                                           "asm",
                                           "auto",
                                           "bool",
                                           "break",
                                           "case",
                                           "catch",
                                           "char",
                                           "class",
                                           "const",
                                           "continue",
                                           "default",
                                           "delete",
                                           "do",
                                           "double",
                                           "else",
                                           "enum",
                                           "explicit",
                                           "extern",
                                           "false",
                                           "float",
                                           "for",
                                           "friend",
                                           "goto",
                                           "if",
                                           "inline",
                                           "int",
                                           "long",
                                           "mutable",
                                           "namespace",
                                           "new",
                                           "operator",
                                           "private",
                                           "protected",
                                           "public",
                                           "register",
                                           "return",
                                           "short",
                                           "signed",
                                           "sizeof",
                                           "static",
                                           "struct",
                                           "switch",
                                           "template",
                                           "this",
                                           "throw",
                                           "true",
                                           "try",
                                           "typedef",
                                           "typename",
                                           "union",
                                           "unsigned",
                                           "using",
                                           "virtual",
                                           "void",
                                           "volatile",
                                           "while",
                                           "sin",
                                           "cos",
                                           "tan",
                                           "asin",
                                           "acos",
                                           "atan",
                                           "exp",
                                           "log",
                                           "sqrt",
                                           "fabs",
                                           "abs",
                                           "floor",
                                           "ceil",
                                           "min",
                                           "max",
                                           "pow",
                                           "trunc"};
    return all.contains(said);
}
bool is_plain_name(const std::string& said) {
    return !said.empty() && std::isalpha(static_cast<unsigned char>(said[0])) != 0 &&
           std::ranges::all_of(said, [](char c) {
               return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
           });
}

class ProgramPrinter final : public FormatWriter {
public:
    explicit ProgramPrinter(const Model& system) : FormatWriter(system, "lpfg") {}

    std::string text() {
        check();
        find_kinds();
        find_names();
        std::string out =
            "#include <lpfgall.h>\n" + commented("// ", {system_.title, system_.source});
        for (const auto& [called, value] : system_.constants)
            out += "const float " + called + " = " + expression(value.expression) + ";\n";
        const auto& shown = system_.drawing.generations;
        out += "derivation length: " + std::to_string(shown ? shown->second : 5) + ";\n";
        for (const auto& [kind, module] : own_) {
            out += "module " + module + "(";
            for (std::size_t i = 0; i < kind.second; ++i) out += i == 0 ? "float" : ", float";
            out += ");\n";
        }
        if (const std::string ignored = ignored_modules(); !ignored.empty())
            out += "ignore: " + ignored + ";\n";
        out += "Axiom: " + word(system_.axiom) + ";\nproduction:\n";
        for (const Production* rule : rules_by_reach()) out += line(*rule, false);
        const std::string drawn = interpretation();
        return drawn.empty() ? out : out + "interpretation:\n" + drawn;
    }

private:
    void check() const {
        check_programs();
        for (const Production& rule : system_.rules) {
            if (rule.probability) refuse(rule, "a choice is a program there");
            for (const ModulePattern& one : rule.right)
                if (name(one.symbol) == "[" || name(one.symbol) == "]")
                    refuse(rule, "its context has branches");
        }
        for (const Production& rule : system_.interpretation)
            if (rule.probability || !rule.left.empty() || !rule.right.empty())
                refuse(rule, "it is an interpretation with contexts or chance");
        for (const auto& [called, value] : system_.constants)
            if (!is_plain_name(called) || is_reserved(called))
                refuse("the constant " + called + ": it is no name there, or another one's");
    }

    void meet(const ModuleWord& word) {
        for (std::size_t i = 0; i < word.letters.size(); ++i) {
            const auto numbers = word.arguments.find(i);
            kinds_.emplace(word.letters[i],
                           numbers == word.arguments.end() ? 0 : numbers->second.size());
        }
    }
    void meet(const Pattern& pattern) {
        for (const ModulePattern& one : pattern) kinds_.emplace(one.symbol, one.parameters.size());
    }

    void find_kinds() {
        meet(system_.axiom);
        for (const auto* rules : {&system_.rules, &system_.interpretation})
            for (const Production& rule : *rules) {
                meet({rule.predecessor});
                if (rules == &system_.rules) meet(rule.successor);
                meet(rule.left);
                meet(rule.right);
            }
        for (const Production& rule : system_.interpretation)
            interpreted_.emplace(rule.predecessor.symbol, rule.predecessor.parameters.size());
        for (const Production& rule : system_.interpretation)
            for (std::size_t i = 0; i < rule.successor.letters.size(); ++i) {
                const auto numbers = rule.successor.arguments.find(i);
                const std::size_t count =
                    numbers == rule.successor.arguments.end() ? 0 : numbers->second.size();
                if (interpreted_.contains({rule.successor.letters[i], count}))
                    refuse(rule, "it is an interpretation of what another one gives");
                if (turtle_name({rule.successor.letters[i], count}).empty())
                    kinds_.emplace(rule.successor.letters[i], count);
            }
    }

    /// The turtle's module that draws what a letter does; empty if it does nothing.
    std::string turtle_name(const Kind& kind) const {
        const std::string& said = name(kind.first);
        if (said == "$" || said == "@" || said == "%" || said.starts_with("?"))
            refuse("the letter " + said + ": it means something else there");
        if (said == "*" && kind.second > 0) refuse("the letter * with a number");
        if (said == "'" && kind.second == 0) return "IncColor";
        if (said == "'" && kind.second != 1) refuse("the letter ' with three numbers");
        if (said == "!" && kind.second == 0) return "";  // does nothing without `narrow`
        if (said.starts_with("F_")) return "F";
        if (said.starts_with("f_")) return "f";
        for (const TurtleName& one : turtle_names)
            if (said == one.letter) {
                if (system_.drawing.clockwise && (said == "+" || said == "-"))
                    return said == "+" ? "Right" : "Left";
                return one.module;
            }
        return "";
    }
    /// Whether the module has a number there, which is given where the letter has none.
    static bool has_number(const std::string& module) {
        const auto found = std::ranges::find_if(
            turtle_names, [&](const TurtleName& one) { return module == one.module; });
        return found != std::end(turtle_names) && found->parameters == 1;
    }
    static bool steps(const std::string& module) {
        return module == "F" || module == "f" || module == "G";
    }
    bool says_step() const { return system_.drawing.step && system_.drawing.step->value != 1; }

    /// Names of modules: the turtle's where the letter means the same, otherwise ones of their own.
    void find_names() {
        std::set<std::string> taken;
        for (const auto& [called, value] : system_.constants) taken.insert(called);
        for (const Kind& kind : kinds_) {
            const std::string turtle = turtle_name(kind);
            const bool is_branch = turtle == "SB" || turtle == "EB";
            if (is_branch && kind.second > 0) refuse("a bracket with numbers");
            const bool changes_numbers = kind.second == 1 && steps(turtle) && says_step();
            const bool has_both =
                kind.second == 0 && has_number(turtle) && kinds_.contains({kind.first, 1});
            const bool is_same = !turtle.empty() && name(kind.first).size() == 1 &&
                                 kind.second <= (has_number(turtle) ? 1 : 0);
            if (is_same && !changes_numbers && !has_both && !interpreted_.contains(kind)) {
                turtles_.emplace(kind, turtle);
                continue;
            }
            std::string called = name(kind.first);
            if (!is_plain_name(called) || called.starts_with("F_") || called.starts_with("f_") ||
                called.starts_with("X_") || is_reserved(called)) {
                std::string code;
                for (const char c : called)
                    code += std::isalnum(static_cast<unsigned char>(c)) != 0
                                ? std::string(1, c)
                                : std::to_string(static_cast<int>(static_cast<unsigned char>(c)));
                called = "S" + code;
            }
            if (taken.contains(called)) called += "_" + std::to_string(kind.second);
            while (taken.contains(called)) called += "_";
            taken.insert(called);
            own_.emplace(kind, called);
        }
        taken_ = std::move(taken);
    }

    std::string ignored_modules() const {
        std::vector<std::string> all;
        for (const Symbol letter : system_.ignored)
            for (const Kind& kind : kinds_)
                if (kind.first == letter) {
                    const auto own = own_.find(kind);
                    const std::string module = own == own_.end() ? turtles_.at(kind) : own->second;
                    if (std::ranges::find(all, module) == all.end()) all.push_back(module);
                }
        return joined(all, " ");
    }

    std::string amount(const Quantity& value) const {
        return value.exact ? number(*value.exact) : shortest_decimal(value.value);
    }
    /// What a module of the turtle has for a letter without a number.
    std::string usual(const std::string& module) const {
        const Drawing& drawing = system_.drawing;
        if (steps(module)) return drawing.step ? amount(*drawing.step) : "1";
        return drawing.angle ? amount(*drawing.angle) : "90";
    }

    /// The turtle's module for a letter.
    std::string drawn(const std::string& module, const std::vector<std::string>& numbers) const {
        if (!has_number(module)) return module + "()";
        std::string said = numbers.empty() ? usual(module) : numbers[0];
        if (!numbers.empty() && steps(module) && says_step())
            said = "(" + said + ")*" + amount(*system_.drawing.step);
        return module + "(" + said + ")";
    }

    std::string module(const Kind& kind, const std::vector<std::string>& numbers,
                       bool as_drawn) const {
        if (as_drawn && !interpreted_.contains(kind))
            if (const std::string turtle = turtle_name(kind); !turtle.empty())
                return drawn(turtle, numbers);
        const auto own = own_.find(kind);
        if (own != own_.end()) return own->second + "(" + joined(numbers, ", ") + ")";
        const std::string& turtle = turtles_.at(kind);
        if (has_number(turtle) && numbers.empty()) return turtle + "(" + usual(turtle) + ")";
        return turtle + "(" + joined(numbers, ", ") + ")";
    }

    std::string word(const ModuleWord& written, bool as_drawn = false) const {
        std::vector<std::string> parts;
        for (std::size_t i = 0; i < written.letters.size(); ++i) {
            std::vector<std::string> numbers;
            if (const auto found = written.arguments.find(i); found != written.arguments.end())
                for (const Expression& one : found->second) numbers.push_back(expression(one));
            parts.push_back(module({written.letters[i], numbers.size()}, numbers, as_drawn));
        }
        return joined(parts, " ");
    }

    /// Names for the parameters of a rule, which a module of the turtle has where the letter has none.
    std::string pattern(const ModulePattern& one) {
        const Kind kind{one.symbol, one.parameters.size()};
        const auto turtle = turtles_.find(kind);
        std::vector<std::string> names;
        for (const std::string& parameter : one.parameters)
            names.push_back(parameter_name(parameter));
        if (turtle != turtles_.end() && has_number(turtle->second) && names.empty())
            names.push_back(fresh());
        const std::string& called = turtle == turtles_.end() ? own_.at(kind) : turtle->second;
        return called + "(" + joined(names, ", ") + ")";
    }
    std::string fresh() {
        std::string found;
        do {
            found = "x" + std::to_string(++names_given_);
        } while (taken_.contains(found) || std::ranges::find(parameters_, found, [](const auto& e) {
                                               return e.second;
                                           }) != parameters_.end());
        return found;
    }
    std::string parameter_name(const std::string& parameter) {
        const bool is_usable =
            is_plain_name(parameter) && !is_reserved(parameter) && !taken_.contains(parameter);
        const auto [entry, is_new] = parameters_.emplace(parameter, parameter);
        if (is_new && !is_usable) {
            entry->second.clear();
            entry->second = fresh();
        }
        return entry->second;
    }

    std::string line(const Production& rule, bool as_drawn) {
        parameters_.clear();
        names_given_ = 0;
        // Names that are kept come first, so that no fresh one is another's.
        for (const Pattern* side : {&rule.left, &rule.right})
            for (const ModulePattern& one : *side)
                for (const std::string& parameter : one.parameters) parameter_name(parameter);
        for (const std::string& parameter : rule.predecessor.parameters) parameter_name(parameter);
        std::string out;
        const auto side = [&](const Pattern& modules) {
            std::vector<std::string> parts;
            for (const ModulePattern& one : modules) parts.push_back(pattern(one));
            return joined(parts, " ");
        };
        if (!rule.left.empty()) out += side(rule.left) + " < ";
        out += pattern(rule.predecessor);
        if (!rule.right.empty()) out += " > " + side(rule.right);
        out += " :\n{\n  ";
        if (rule.condition) out += "if (" + expression(*rule.condition) + ") ";
        const std::string made = word(rule.successor, as_drawn);
        return out + "produce" + (made.empty() ? "" : " ") + made + ";\n}\n";
    }

    std::string interpretation() {
        std::string out;
        for (const auto& [kind, called] : own_) {
            if (interpreted_.contains(kind)) continue;
            const std::string turtle = turtle_name(kind);
            if (turtle.empty()) continue;
            std::vector<std::string> names;
            for (std::size_t i = 0; i < kind.second; ++i)
                names.push_back("x" + std::to_string(i + 1));
            out += called + "(" + joined(names, ", ") + ") :\n{\n  produce " +
                   drawn(turtle, names) + ";\n}\n";
        }
        for (const Production& rule : system_.interpretation) out += line(rule, true);
        return out;
    }

    static std::string number(const Rational& value) {
        const auto decimal = exact_decimal(value);
        if (decimal) return *decimal;
        const std::string said = to_string(value);
        const std::size_t slash = said.find('/');
        return "(" + said.substr(0, slash) + ".0/" + said.substr(slash + 1) + ")";
    }

    /// Whether C takes the value for a whole number, whose quotients are whole.
    static bool is_whole(const Expression& said) {
        switch (said.kind) {
            case Expression::Kind::number:
                return said.value.is_integer();
            case Expression::Kind::unary:
                return said.name == "!" || is_whole(said.operands[0]);
            case Expression::Kind::binary:
                if (said.name == "/" || said.name == "^") return false;
                if (said.name == "+" || said.name == "-" || said.name == "*")
                    return is_whole(said.operands[0]) && is_whole(said.operands[1]);
                return true;
            default:
                return false;
        }
    }

    std::string expression(const Expression& said) const {
        switch (said.kind) {
            case Expression::Kind::number: {
                const std::string digits = number(said.value);
                return sign(said.value) < 0 ? "(" + digits + ")" : digits;
            }
            case Expression::Kind::name: {
                const auto found = parameters_.find(said.name);
                return found == parameters_.end() ? said.name : found->second;
            }
            case Expression::Kind::unary:
                return "(" + said.name + "(" + expression(said.operands[0]) + "))";
            case Expression::Kind::binary: {
                static const std::map<std::string, std::string> signs{
                    {"=", "=="}, {"&", "&&"}, {"|", "||"}};
                const std::string left = expression(said.operands[0]),
                                  right = expression(said.operands[1]);
                if (said.name == "^") return "pow(" + left + ", " + right + ")";
                const bool divides =
                    said.name == "/" && is_whole(said.operands[0]) && is_whole(said.operands[1]);
                const auto other = signs.find(said.name);
                return "(" + (divides ? "float(" + left + ")" : left) +
                       (other == signs.end() ? said.name : other->second) + right + ")";
            }
            case Expression::Kind::call: {
                static const std::set<std::string> known{"exp",   "log",  "sqrt", "abs",
                                                         "floor", "ceil", "min",  "max"};
                if (!known.contains(said.name))
                    refuse("the function " + said.name +
                           (said.name.ends_with("sin") || said.name.ends_with("cos") ||
                                    said.name.ends_with("tan")
                                ? ": it takes radians there"
                                : ""));
                return (said.name == "abs" ? "fabs" : said.name) + "(" +
                       joined(said.operands, ", ",
                              [&](const Expression& e) { return expression(e); }) +
                       ")";
            }
            case Expression::Kind::word:
                refuse("words as parameters");
        }
        return "";
    }

    std::set<Kind> kinds_, interpreted_;
    std::map<Kind, std::string> turtles_, own_;  // what modules are called
    std::set<std::string> taken_;
    std::map<std::string, std::string>
        parameters_;  // of the rule that is written: their names there
    std::size_t names_given_ = 0;
};

}  // namespace

std::string print_lpfg(const Model& system) { return ProgramPrinter(system).text(); }

}  // namespace algae
