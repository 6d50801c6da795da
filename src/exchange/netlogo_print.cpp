#include <algorithm>
#include <cctype>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "exchange/netlogo_file.hpp"
#include "exchange/netlogo_number.hpp"
#include "exchange/netlogo_system.hpp"
#include "exchange/plain_rules.hpp"
#include "notation/print.hpp"

namespace algae {

namespace {

constexpr const char* format = "netlogo";

class Writer {
public:
    explicit Writer(const LSystem& system) : system_(system) {}

    std::string text() {
        check_plain_rules(system_, format, true);
        check_plain_settings(system_, format);
        for (const Symbol symbol : system_.axiom.letters) see(symbol, "the axiom");
        for (const Production& rule : system_.rules) {
            const std::string where = "the rule " + print_rule(system_.alphabet, rule);
            see(rule.predecessor.symbol, where);
            for (const Symbol symbol : rule.successor.letters) see(symbol, where);
            rules_[rule.predecessor.symbol].push_back(&rule);
        }
        std::string out = system_.title.empty() ? "" : "; " + system_.title + "\n";
        for (const auto& [symbol, rules] : rules_)
            if (rules.size() > 1 && !rules[0]->probability) {
                out += "; several rules for a letter: the model picks one at random\n";
                break;
            }
        for (const Production& rule : system_.rules)
            for (Integer times = repetitions(rule); times > 0; times -= 1)
                out += line(rule.predecessor.symbol, rule.successor.letters);
        // Letters without rules are commands of themselves, unless a rule that keeps them says more.
        for (const Symbol symbol : seen_)
            if (!rules_.contains(symbol) &&
                netlogo_command(name(symbol), has_scale()) != command(symbol))
                out += line(symbol, {symbol});
        return out + "set chain " + string(system_.axiom.letters) + "\n" + numbers();
    }

private:
    const std::string& name(Symbol symbol) const { return system_.alphabet.name(symbol); }
    bool has_scale() const { return system_.settings.scale.has_value(); }
    [[noreturn]] void refuse(const std::string& what) const { cannot_say(system_, format, what); }

    void see(Symbol symbol, const std::string& where) {
        const std::string& text = name(symbol);
        const auto starts = std::count_if(text.begin(), text.end(), [](char byte) {
            return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
        });
        if (starts != 1 || text.size() > 3)
            refuse("the symbol " + text + " in " + where + ", expected one character");
        if (std::find(seen_.begin(), seen_.end(), symbol) == seen_.end()) seen_.push_back(symbol);
    }

    /// As often as the rules of a letter must stand there so that each is chosen with its
    /// probability.
    Integer repetitions(const Production& rule) const {
        if (!rule.probability) return 1;
        Integer common = 1;
        for (const Production* other : rules_.at(rule.predecessor.symbol))
            common = lcm(common, other->probability->denominator());
        if (common > 100)
            refuse("the probabilities of " + name(rule.predecessor.symbol) +
                   ": their common denominator is " + to_string(common) + ", expected at most 100");
        return rule.probability->numerator() *
               exact_divide(common, rule.probability->denominator());
    }

    std::string string(const Word& word) const {
        std::string out = "\"";
        for (const Symbol symbol : word) {
            const std::string& character = name(symbol);
            out += (character == "\"" || character == "\\" ? "\\" : "") + character;
        }
        return out + '"';
    }
    std::string line(Symbol letter, const Word& successor) const {
        const std::string& own = name(letter);
        std::string does = command(letter);
        // A letter that does nothing has its own name for a command, where that is none.
        if (does.empty() && own.size() == 1 && std::isalpha(static_cast<unsigned char>(own[0])) &&
            netlogo_command(own, true).empty())
            does = own;
        return "add-rule " + string({letter}) + ' ' + string(successor) + " \"" + does + "\"\n";
    }

    /// The one command that a letter stands for.
    std::string command(Symbol symbol) const {
        std::string found;
        bool any = false;
        for (const TurtleModule& module : interpreted(system_, symbol, format)) {
            const std::string one = command_of(symbol, module);
            if (one.empty()) continue;
            if (std::exchange(any, true))
                refuse("the letter " + name(symbol) + ", which stands for several commands");
            found = one;
        }
        return found;
    }
    std::string command_of(Symbol symbol, const TurtleModule& module) const {
        const std::string& of = name(module.symbol);
        const Settings& settings = system_.settings;
        const auto is = [&](double value) {
            return module.parameters.empty() ||
                   (module.parameters.size() == 1 && module.parameters[0].value == value);
        };
        const auto fails = [&] {
            std::string what = "the symbol " + of;
            if (!module.parameters.empty()) what += " with a parameter";
            if (module.symbol != symbol) what += ", for which " + name(symbol) + " stands";
            refuse(what + ": its commands are F f + - [ ] *, and S for a square");
        };
        for (const Settings::Stamp& stamp : settings.stamps)
            if (stamp.symbol == module.symbol) {
                if (stamp.shape != StampShape::square || !is(2)) fails();
                return "S";
            }
        for (const SolidSetting& solid : settings.solids)
            if (solid.symbol == module.symbol) fails();
        if (of == "F" || of.starts_with("F_") || of == "G") return is(1) ? "F" : (fails(), "");
        if (of == "f" || of.starts_with("f_")) return is(1) ? "f" : (fails(), "");
        if (of.size() != 1) return "";
        const double angle = settings.angle ? settings.angle->value : 90;
        switch (of[0]) {
            case '+':
            case '-':
                return is(angle) ? of : (fails(), "");
            case '[':
            case ']':
                if (module.symbol != symbol) fails();
                return of;
            case '*':
                if (!has_scale() && module.parameters.empty()) return "";
                if (!has_scale() || !is(settings.scale->value)) fails();
                return of;
            case '!':
                if (settings.narrow || !module.parameters.empty()) fails();
                return "";
            default:
                if (std::strchr("|{}.%&^\\/$@", of[0])) fails();
                return "";
        }
    }

    std::string numbers() const {
        const Settings& settings = system_.settings;
        const auto set = [](const char* name, const Quantity& number) {
            return "set " + (name + (' ' + netlogo_number(number))) + "\n";
        };
        const Quantity zero = quantity(0), one = quantity(1);
        const Quantity angle = settings.angle.value_or(quantity(90));
        const Settings::Start start = settings.start.value_or(Settings::Start{zero, zero, zero});
        std::string out = set("d", settings.step.value_or(one)) +
                          set("delta", settings.clockwise ? negated(angle) : angle) +
                          set("x0", start.x) + set("y0", start.y) +
                          set("delta-0", turned_compass(start.heading)) +
                          set("k-shorten", settings.shrink.value_or(one));
        if (settings.spin) out += set("d-delta", negated(*settings.spin));
        if (settings.scale) out += set("k", *settings.scale);
        return out;
    }

    const LSystem& system_;
    std::vector<Symbol> seen_;  // in the order of the words
    std::map<Symbol, std::vector<const Production*>> rules_;
};

}  // namespace

std::string print_netlogo(const LSystem& system) { return Writer(system).text(); }

}  // namespace algae
