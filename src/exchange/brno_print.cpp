#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "exchange/brno_file.hpp"
#include "exchange/brno_modules.hpp"
#include "exchange/plain_rules.hpp"
#include "exchange/polygon_letters.hpp"
#include "notation/print.hpp"

namespace algae {

namespace {

constexpr const char* format = "brno";

/// Finds what a system says that a file can say, and throws Error where it cannot.
class Writer {
public:
    explicit Writer(const LSystem& system) : system_(system) {}

    BrnoSystem written() {
        check_plain_rules(system_, format, false);
        check_plain_settings(system_, format);
        check_start();
        out_.axiom = letters(system_.axiom.letters, "the axiom");
        std::map<char, std::string> rules;
        for (const Production& rule : system_.rules) {
            const std::string what = "the rule " + print_rule(system_.alphabet, rule);
            const std::string left = letters({rule.predecessor.symbol}, what);
            if (!is_module(left[0])) refuse(what + ": its left side is no letter");
            const std::string right = letters(rule.successor.letters, what);
            rules.emplace(left[0], right);
            out_.rules.emplace_back(left[0], right);
        }
        drawn_ = polygon_letters(out_.axiom, rules);
        for (const auto& [letter, symbol] : symbols_)
            if (is_module(letter)) out_.modules.emplace(letter, primitive(symbol));
        for (const char vector : {'U', 'L', 'H'}) add_angle(vector);
        for (const char letter : {'|', '[', ']', '{', '}', '!'}) check_meaning(letter);
        check_widths();
        return std::move(out_);
    }

private:
    static bool is_module(char letter) { return std::isalpha(static_cast<unsigned char>(letter)); }
    const std::string& name(Symbol symbol) const { return system_.alphabet.name(symbol); }
    [[noreturn]] void refuse(const std::string& what) const { cannot_say(system_, format, what); }

    void check_start() const {
        const Settings& settings = system_.settings;
        const auto is = [](const std::optional<Quantity>& number, double value) {
            return !number || number->value == value;
        };
        if (settings.clockwise) refuse("that + turns clockwise");
        if (!is(settings.shrink, 1)) refuse("that steps shrink from one generation to the next");
        if (!is(settings.spin, 0)) refuse("that the start turns from one generation to the next");
        if (const auto& start = settings.start)
            if (start->x.value != 0 || start->y.value != 0 || start->heading.value != 0)
                refuse("where the turtle starts, expected 'start 0 0 0'");
    }

    std::string letters(const Word& word, const std::string& where) {
        std::string out;
        for (const Symbol symbol : word) {
            const std::string& letter = name(symbol);
            const bool known = letter.size() == 1 && (is_module(letter[0]) ||
                                                      std::strchr(brno_turtle_symbols, letter[0]));
            if (!known)
                refuse("the symbol " + letter + " in " + where + ", expected letters and " +
                       brno_turtle_symbols);
            symbols_.emplace(letter[0], symbol);
            out += letter;
        }
        const std::vector<std::size_t> depths = brace_depths(out);
        for (std::size_t i = 0; i < out.size(); ++i)
            if (depths[i] > 0) fenced_.insert(out[i]);
        return out;
    }

    /// What a letter makes the turtle do, without colours and what it ignores.
    std::vector<TurtleModule> deeds(Symbol symbol) const {
        std::vector<TurtleModule> all = interpreted(system_, symbol, format);
        std::erase_if(all, [&](const TurtleModule& module) { return !acts(module); });
        return all;
    }
    bool acts(const TurtleModule& module) const {
        const std::string& of = name(module.symbol);
        const Settings& settings = system_.settings;
        for (const Settings::Stamp& stamp : settings.stamps)
            if (stamp.symbol == module.symbol) return true;
        if (solid(module.symbol) || steps(of)) return true;
        if (of == "*") return !module.parameters.empty() || settings.scale;
        if (of == "!") return !module.parameters.empty() || settings.narrow;
        return of.size() == 1 && std::strchr("G+-&^\\/|$@[]{}.%", of[0]);
    }
    static bool steps(const std::string& of) {
        return of == "F" || of == "f" || of.starts_with("F_") || of.starts_with("f_");
    }
    const SolidSetting* solid(Symbol symbol) const {
        for (const SolidSetting& setting : system_.settings.solids)
            if (setting.symbol == symbol) return &setting;
        return nullptr;
    }

    BrnoPrimitive primitive(Symbol symbol) {
        const std::vector<TurtleModule> all = deeds(symbol);
        if (all.empty()) return {};
        const TurtleModule& last = all.back();
        const std::string& of = name(last.symbol);
        if (all.size() > 2) refuse_module(symbol);
        if (all.size() == 1 && solid(last.symbol)) return ball(symbol, last);
        if (solid(last.symbol) || !(steps(of) || of == "G")) refuse_module(symbol);
        const char letter = name(symbol)[0];
        const bool inside = drawn_.inside.contains(letter),
                   outside = drawn_.outside.contains(letter);
        BrnoPrimitive out{'P', 0, pixels(symbol, step() * length(last), "the length")};
        if (all.size() == 2) {
            const TurtleModule& width = all.front();
            if (name(width.symbol) != "!" || width.parameters.size() != 1 || of[0] == 'f')
                refuse_module(symbol);
            out.diameter = pixels(symbol, width.parameters[0].value, "the diameter");
            if (!fenced_.contains(letter)) {
                out.kind = 'C';
            } else if (outside && out.diameter == 1 && of != "G") {
                lines_.insert(letter);
            } else {
                refuse("the cylinder " + name(symbol) +
                       " between braces, where turns and lines stand");
            }
        } else if (of[0] == 'f' && outside) {
            refuse(name(symbol) + ", a step that draws nothing");
        } else if (of[0] != 'f' && inside && (!outside || of == "G")) {
            refuse(name(symbol) +
                   " between braces, where a line is a side of the polygon and nothing else");
        }
        return out;
    }
    [[noreturn]] void refuse_module(Symbol symbol) const {
        refuse("the module " + name(symbol) +
               ": expected a line, a cylinder, a ball or nothing to be seen");
    }
    static double length(const TurtleModule& module) {
        return module.parameters.empty() ? 1 : module.parameters[0].value;
    }
    BrnoPrimitive ball(Symbol symbol, const TurtleModule& module) const {
        const SolidSetting& setting = *solid(module.symbol);
        if (setting.kind != "sphere") refuse_module(symbol);
        const auto at = std::find(setting.measures.begin(), setting.measures.end(), "radius");
        const auto place = static_cast<std::size_t>(at - setting.measures.begin());
        const double radius = place < module.parameters.size() ? module.parameters[place].value : 1;
        if (fenced_.contains(name(symbol)[0]))
            refuse("the ball " + name(symbol) + " between braces, where turns and lines stand");
        return {'S', pixels(symbol, 2 * radius * step(), "the diameter"), 0};
    }
    double step() const { return system_.settings.step ? system_.settings.step->value : 1; }

    long whole(double value, long least, long most, const std::string& what) const {
        if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most)) ||
            value != std::floor(value))
            refuse(what + ", expected a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most));
        return static_cast<long>(value);
    }
    long pixels(Symbol symbol, double value, const char* what) const {
        return whole(value, 1, 1'000'000, std::string(what) + " of the module " + name(symbol));
    }

    /// Among cylinders lines are one wide, and they are so only there.
    void check_widths() const {
        bool cylinders = false;
        for (const auto& [letter, primitive] : out_.modules)
            cylinders = cylinders || primitive.kind == 'C';
        if (!cylinders && !lines_.empty())
            refuse(std::string("the width of ") + *lines_.begin() +
                   ", a line where there are no cylinders");
        for (const auto& [letter, primitive] : out_.modules)
            if (cylinders && primitive.kind == 'P' && drawn_.outside.contains(letter) &&
                !lines_.contains(letter))
                refuse(std::string("the width of ") + letter + ", a line among cylinders");
    }

    void add_angle(char vector) {
        std::optional<long> found;
        for (const char* turn = brno_turns(vector); *turn; ++turn) {
            const auto symbol = symbols_.find(*turn);
            if (symbol == symbols_.end()) continue;
            const long angle = turned(*turn, symbol->second);
            if (found && *found != angle)
                refuse(std::string("that ") + brno_turns(vector)[0] + " and " +
                       brno_turns(vector)[1] + " turn by different angles");
            found = angle;
        }
        if (found) out_.angles[vector] = *found;
    }
    long turned(char turn, Symbol symbol) const {
        const std::vector<TurtleModule> all = deeds(symbol);
        if (all.size() != 1 || name(all[0].symbol) != std::string(1, turn)) refuse_meaning(turn);
        const auto& angle = system_.settings.angle;
        const double degrees = !all[0].parameters.empty() ? all[0].parameters[0].value
                               : angle                    ? angle->value
                                                          : 90;
        return whole(degrees, 0, 360, std::string("the angle of ") + turn);
    }
    [[noreturn]] void refuse_meaning(char letter) const {
        refuse(std::string("another meaning of ") + letter);
    }
    void check_meaning(char letter) const {
        const auto symbol = symbols_.find(letter);
        if (symbol == symbols_.end()) return;
        const std::vector<TurtleModule> all = deeds(symbol->second);
        const bool same = letter == '!' ? all.empty()
                                        : all.size() == 1 && all[0].symbol == symbol->second &&
                                              all[0].parameters.empty();
        if (!same) refuse_meaning(letter);
    }

    const LSystem& system_;
    std::map<char, Symbol> symbols_;  // of the words
    std::set<char> fenced_;           // written between braces
    PolygonLetters drawn_;
    std::set<char> lines_;  // that have the width 1
    BrnoSystem out_;
};

}  // namespace

std::string print_brno(const LSystem& system) {
    return brno_text(Writer(system).written(), system.title);
}

}  // namespace algae
