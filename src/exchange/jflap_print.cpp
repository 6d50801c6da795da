#include <map>
#include <set>
#include <string>
#include <vector>

#include "exchange/detail/formats.hpp"
#include "exchange/detail/jflap.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "exchange/detail/scanner.hpp"
#include "model/model.hpp"

// A system as a file of JFLAP 4 to 7, and what no such file can say.

namespace algae {

namespace {

/// Writes a system as a file.
class Writer : FormatWriter {
public:
    explicit Writer(const Model& system) : FormatWriter(system, "jff") {}

    std::string written() {
        check_plain_rules(true);
        check_plain_settings();
        const Drawing& drawing = system_.drawing;
        if (!is_usual(drawing.shrink, 1))
            refuse("that steps shrink from one generation to the next");
        if (!is_usual(drawing.spin, 0)) refuse("a spin");
        if (!drawing.stamps.empty()) refuse("stamps");
        if (!drawing.solids.empty()) refuse("solids");
        // Letters that only an interpretation gives stand in no word.
        std::set<Symbol> met(system_.axiom.letters.begin(), system_.axiom.letters.end());
        for (const Production& rule : system_.rules) {
            met.insert(rule.predecessor.symbol);
            met.insert(rule.successor.letters.begin(), rule.successor.letters.end());
        }
        for (const Symbol a : met) name_token(a);
        std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
        if (!system_.title.empty()) out += "<!-- " + without_dashes(system_.title) + " -->\n";
        out += "<structure>\n  <type>lsystem</type>\n  <axiom>" + word(system_.axiom.letters) +
               "</axiom>\n";
        std::set<Symbol> told;
        for (const Production& rule : system_.rules) {
            const Symbol left = rule.predecessor.symbol;
            if (!told.insert(left).second) continue;
            out += "  <production>\n    <left>" + escaped(names_.at(left)) + "</left>\n";
            for (const Production& one : system_.rules)
                if (one.predecessor.symbol == left)
                    for (std::size_t i = repeats(one); i > 0; --i)
                        out += "    <right>" + word(one.successor.letters) + "</right>\n";
            out += "  </production>\n";
        }
        const auto parameter = [&](const std::string& name, const std::string& value) {
            out += "  <parameter>\n    <name>" + name + "</name>\n    <value>" + value +
                   "</value>\n  </parameter>\n";
        };
        parameter("angle", decimal(drawing.angle, Rational(90), "angle"));
        parameter("distance", decimal(drawing.step, Rational(1), "step"));
        return out + "</structure>\n";
    }

private:
    static std::string without_dashes(std::string text) {
        std::ranges::replace(text, '-', ' ');
        return text;
    }
    static std::string escaped(const std::string& text) {
        std::string out;
        for (const char c : text)
            out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
        return out;
    }

    std::string decimal(const std::optional<Quantity>& number, const Rational& usual,
                        const char* what) const {
        const std::optional<Rational> value = number ? number->exact : usual;
        const auto text = value ? exact_decimal(*value) : std::nullopt;
        if (!text)
            refuse(std::string("the ") + what + " " + to_text(number->expression) +
                   ", which is no decimal");
        return *text;
    }

    /// How often a right side stands there: probabilities are made of equal ones.
    std::size_t repeats(const Production& rule) const {
        if (!rule.probability) return 1;
        Integer common = 1;
        for (const Production& one : system_.rules)
            if (one.predecessor.symbol == rule.predecessor.symbol && one.probability)
                common = lcm(common, one.probability->denominator());
        if (common > Integer(100)) refuse(rule, "its probability has a denominator above 100");
        return floor(*rule.probability * Rational(common)).to_uint64();
    }

    void name_token(Symbol a) {
        const std::vector<TurtleModule> modules = interpreted(a);
        std::string does;
        for (const TurtleModule& module : modules) {
            const std::string one = token(a, module);
            if (!one.empty() && !does.empty())
                refuse("the letter " + name(a) + ", which does several things");
            if (!one.empty()) does = one;
        }
        static const std::set<std::string> commands{"g", "f", "+", "-",  "&", "^", "/",
                                                    "*", "%", "[", "]",  "!", "~", "{",
                                                    "}", "#", "@", "##", "@@"};
        std::string chosen = does.empty() ? name(a) : does;
        if (does.empty() &&
            (commands.contains(chosen) || chosen.find_first_of("(=") != std::string::npos ||
             is_jflap_index(chosen)))
            chosen = "X" + std::to_string(a);
        if (!taken_.insert(chosen).second)
            refuse("the letter " + name(a) + ", which does what another letter does");
        names_.emplace(a, chosen);
    }

    std::string token(Symbol a, const TurtleModule& module) const {
        const std::string& what = name(module.symbol);
        const auto fail = [&](const std::string& why) {
            refuse("the letter " + name(a) + ", which " + why);
        };
        const bool line = what == "F" || what == "G" || what.starts_with("F_"),
                   move = what == "f" || what.starts_with("f_");
        std::string number;
        if (!module.parameters.empty()) {
            auto value = module.parameters[0].exact;
            if (value && (line || move))
                *value *= system_.drawing.step ? system_.drawing.step->exact.value_or(Rational(1))
                                               : Rational(1);
            const auto text = value ? exact_decimal(*value) : std::nullopt;
            if (!text) fail("has a number that is no decimal");
            number = "(" + *text + ")";
        }
        if (line) return "g" + number;
        if (move) return "f" + number;
        // + turns to the right there.
        if (what == "+" || what == "-")
            return ((what == "+") == system_.drawing.clockwise ? "+" : "-") + number;
        if (what == "&" || what == "^" || what == "/") return what + number;
        if (what == "\\") return "*" + number;
        if (what == "|") return "%";
        if (what == "[" || what == "]") return what;
        if (what == "'" || (what == "!" && !system_.drawing.narrow)) return "";
        if (what.size() == 1 &&
            std::string_view("{}.!$%~@*").find(what[0]) != std::string_view::npos) {
            if (what == "*" && !system_.drawing.scale && number.empty()) return "";
            fail("is the command " + what + " of the notation");
        }
        return "";
    }

    std::string word(const Word& letters) const {
        std::vector<std::string> tokens;
        for (const Symbol a : letters) tokens.push_back(escaped(names_.at(a)));
        return joined(tokens, " ");
    }

    std::map<Symbol, std::string> names_;
    std::set<std::string> taken_;
};

}  // namespace

std::string print_jflap(const Model& system) { return Writer(with_plain_angle(system)).written(); }

}  // namespace algae
