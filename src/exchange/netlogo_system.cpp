#include "exchange/netlogo_system.hpp"

#include <string_view>
#include <utility>

#include "exchange/netlogo_number.hpp"
#include "notation/characters.hpp"
#include "notation/print.hpp"

namespace algae {

namespace {

/// Whether a turtle of the notation does something at this symbol, so that it must be told not to.
bool acts(const std::string& symbol, bool has_k) {
    if (symbol == "*") return has_k;
    return symbol.size() == 1 &&
           std::string("FfG+-|[]{}.'%&^\\/$@").find(symbol) != std::string::npos;
}

/// Texts, and how many times each of them stands there.
using Counted = std::vector<std::pair<std::string, long>>;

void count(Counted& all, const std::string& thing) {
    for (auto& [known, times] : all)
        if (known == thing) {
            ++times;
            return;
        }
    all.emplace_back(thing, 1);
}

long total(const Counted& all) {
    long sum = 0;
    for (const auto& [thing, times] : all) sum += times;
    return sum;
}

/// Writes one line after the other.
class Notation {
public:
    explicit Notation(const NetlogoSystem& system) : system_(system) {
        has_k_ = system.numbers.contains("k");
        for (const NetlogoSystem::Rule& rule : system.rules) {
            if (!successors_.contains(rule.letter)) letters_.push_back(rule.letter);
            count(successors_[rule.letter], rule.successor);
            count(commands_[rule.letter], netlogo_command(rule.command, has_k_));
        }
    }

    std::string text() {
        std::string out = "axiom " + word(system_.chain) + "\n";
        for (const std::string& letter : letters_) {
            const auto& all = successors_[letter];
            for (const auto& [successor, times] : all)
                out += rule(letter, Rational(times, total(all)), word(successor));
        }
        for (const std::string& letter : occurring()) out += meaning(letter);
        return out + numbers() + stamps_ + "colour along\n";
    }

private:
    /// Calls `letter` for each character.
    template <class Letter>
    static void each(std::string_view text, Letter letter) {
        while (!text.empty()) {
            const std::size_t bytes = first_character(text).bytes;
            letter(text.substr(0, bytes));
            text.remove_prefix(bytes);
        }
    }
    static std::string word(const std::string& text) {
        Alphabet alphabet;
        ModuleWord word;
        each(text,
             [&](std::string_view letter) { word.letters.push_back(alphabet.symbol(letter)); });
        return print_word(alphabet, word);
    }
    static std::string rule(const std::string& letter, const Rational& probability,
                            const std::string& successor) {
        const std::string arrow =
            probability == 1 ? " -> " : " -(" + shortest_text(probability) + ")-> ";
        return letter + arrow + successor + "\n";
    }

    /// All characters of the words, in the order of the notation's symbols.
    std::vector<std::string> occurring() const {
        Alphabet seen;
        const auto add = [&](std::string_view letter) { seen.symbol(letter); };
        each(system_.chain, add);
        for (const std::string& letter : letters_)
            for (const auto& [successor, times] : successors_.at(letter)) {
                add(letter);
                each(successor, add);
            }
        std::vector<std::string> all;
        for (Symbol symbol = 0; symbol < seen.size(); ++symbol) all.push_back(seen.name(symbol));
        return all;
    }

    Counted commands(const std::string& letter) const {
        const auto found = commands_.find(letter);
        if (found != commands_.end()) return found->second;
        return {{netlogo_command(letter, has_k_), 1}};
    }
    /// Whether the letter does what it stands for, always.
    bool is_own(const std::string& letter) const {
        const auto all = commands(letter);
        return all.size() == 1 && all[0].first == letter;
    }

    std::string meaning(const std::string& letter) {
        const auto all = commands(letter);
        if (is_own(letter)) {
            if (letter == "S") stamps_ += "stamp S square\n";
            return "";
        }
        if (all.size() == 1 && all[0].first.empty() && !acts(letter, has_k_)) return "";
        std::string out;
        for (const auto& [command, times] : all)
            out += "interpret " + rule(letter, Rational(times, total(all)), module(command));
        return out;
    }
    /// A module that does what a command says, whatever else its own symbol is made to do.
    std::string module(const std::string& command) {
        if (command.empty()) return "ε";
        if (command == "S") {
            if (stamps_.find("S_1") == std::string::npos) stamps_ += "stamp S_1 square\n";
            return "S_1";
        }
        if (is_own(command)) return command;
        if (command == "F" || command == "f") return command + "_1";
        return command + '(' +
               to_text(system_.numbers.at(command == "*" ? "k" : "delta").expression) + ')';
    }

    Quantity number(const char* name) const {
        const auto found = system_.numbers.find(name);
        return found == system_.numbers.end() ? quantity(0) : found->second;
    }
    /// As one of several values of a setting.
    static std::string piece(const Quantity& number) {
        return '(' + to_text(number.expression) + ')';
    }
    std::string numbers() const {
        const auto line = [](const char* name, const Quantity& number) {
            return name + (' ' + to_text(number.expression)) + "\n";
        };
        std::string out = line("angle", number("delta")) + "start " + piece(number("x0")) + ' ' +
                          piece(number("y0")) + ' ' + piece(turned_compass(number("delta-0"))) +
                          "\n" + line("step", number("d")) + line("shrink", number("k-shorten"));
        if (system_.numbers.contains("d-delta")) out += line("spin", negated(number("d-delta")));
        if (has_k_) out += line("scale", number("k"));
        return out;
    }

    const NetlogoSystem& system_;
    bool has_k_ = false;
    std::vector<std::string> letters_;  // with rules, in the order of the file
    std::map<std::string, Counted> successors_;
    std::map<std::string, Counted> commands_;
    std::string stamps_;
};

}  // namespace

std::string netlogo_command(const std::string& text, bool has_k) {
    if (text == "*") return has_k ? text : "";
    const bool known = text.size() == 1 && std::string("Ff+-[]S").find(text) != std::string::npos;
    return known ? text : "";
}

std::string netlogo_notation(const NetlogoSystem& system) { return Notation(system).text(); }

}  // namespace algae
