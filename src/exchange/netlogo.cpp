#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exchange/detail/formats.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "exchange/detail/scanner.hpp"
#include "model/model.hpp"

// Setup procedures of NetLogo models of L-systems.
//
// A model keeps rules as `add-rule LETTER SUCCESSOR COMMAND`: what a letter is rewritten to and, apart from
// that, what the turtle does at it. So a letter's command becomes an interpretation, unless the letter does
// just that by itself. Of several rules for a letter the model picks one at random, all equally likely: equal
// successors are counted and become probabilities, and in print a rule stands there as often as the common
// denominator asks (at most 100).
//
// Headings count clockwise from the north there and counter-clockwise from x here (`turned_compass`). Numbers
// are expressions that stay expressions where they are not exact: `1 / sqrt 2` is read and printed as such.
// In NetLogo operators need blanks around them, `-8` is a number and `(- x)` a sign, and `^` groups to the
// left.

namespace algae {

namespace {

/// NetLogo's reporters of one number, by what the notation calls them.
const std::map<std::string, std::string>& reporters() {
    static const std::map<std::string, std::string> all{
        {"abs", "abs"}, {"cos", "cos"},   {"exp", "exp"}, {"log", "ln"},
        {"sin", "sin"}, {"sqrt", "sqrt"}, {"tan", "tan"}};
    return all;
}

using Binding = ExpressionDialect::Binding;
const ExpressionDialect netlogo{{{"+", "+", Binding::sum},
                                 {"-", "-", Binding::sum},
                                 {"*", "*", Binding::product},
                                 {"/", "/", Binding::product},
                                 {"^", "^", Binding::power}},
                                {},
                                ExpressionDialect::Powers::to_the_left,
                                true};

/// Operators with blanks around them are those of the dialect. What it has besides is read here: signs
/// within numbers, `(- x)`, and functions whose argument has no brackets.
class NumberReader {
public:
    explicit NumberReader(Scanner& scanner) : scanner_(scanner) {}

    Expression sum(std::size_t depth) {
        return scanner_.expression(
            netlogo, [&] { return atom(depth); }, [&](std::size_t at) { count(at); });
    }

private:
    Expression atom(std::size_t depth) {
        constexpr std::size_t most = 100;
        if (depth == most)
            scanner_.fail_at(scanner_.offset(), "more than 100 brackets inside each other");
        const std::string_view rest = scanner_.rest();
        const std::size_t sign = rest.starts_with('-') ? 1 : 0;
        if (const std::size_t size = number_size(rest.substr(sign))) {
            const std::size_t at = scanner_.offset();
            const std::string_view text = rest.substr(0, sign + size);
            scanner_.take(text);
            try {
                return quantity(Rational(plain_number(text))).expression;
            } catch (const Diagnostics&) {
                throw;
            } catch (const Error& error) {
                scanner_.fail_at(at, error.what());
            }
        }
        if (scanner_.take("(")) {
            const bool minus = take_minus();
            Expression inner = minus ? atom(depth + 1) : sum(depth + 1);
            scanner_.expect(")", "or an operator between blanks");
            if (!minus) return inner;
            count(scanner_.offset());
            return made_expression(Expression::Kind::unary, "-", {std::move(inner)});
        }
        for (const auto& [name, reporter] : reporters())
            if (scanner_.take_word(reporter)) {
                count(scanner_.offset());
                return made_expression(Expression::Kind::call, name, {atom(depth + 1)});
            }
        scanner_.fail("a number");
    }

    /// A minus with a blank behind it.
    bool take_minus() {
        const std::string_view rest = scanner_.rest();
        if (rest.size() < 2 || rest[0] != '-' || !std::isspace(static_cast<unsigned char>(rest[1])))
            return false;
        count(scanner_.offset());
        return scanner_.take("-");
    }
    void count(std::size_t at) {
        constexpr std::size_t most = 100;
        if (++operators_ > most) scanner_.fail_at(at, "more than 100 operators in a number");
    }

    Scanner& scanner_;
    std::size_t operators_ = 0;
};

/// Reads a number as NetLogo writes it: `-8`, `1 / sqrt 2`, `(- 3) * 2e-1`, with blanks around
/// operators; `^` groups to the left there. Throws `Diagnostics` where there is no number or it has no
/// value. Brackets nest at most 100 deep, and there are at most 100 operators.
Quantity read_netlogo_number(Scanner& scanner) {
    const std::size_t at = scanner.offset();
    const Expression expression = NumberReader(scanner).sum(0);
    Quantity number;
    try {
        number = evaluate(expression, {});
    } catch (const Diagnostics& error) {
        scanner.fail_at(at, error.findings().front().message);
    }
    constexpr double most = 1e9;
    if (!(std::fabs(number.value) <= most))
        scanner.fail_at(at, "expected a number from -10^9 to 10^9");
    return number;
}

std::string value_of(const Quantity& number) {
    if (!number.exact) return shortest_decimal(number.value);
    if (const auto text = exact_decimal(*number.exact); text && text->size() < 40) return *text;
    return shortest_decimal(number.value);
}

/// The expression in NetLogo, in brackets where `inner` says so; empty where it knows something else.
std::string written(const Expression& expression, bool inner) {
    std::string out;
    switch (expression.kind) {
        case Expression::Kind::number: {
            const auto text = exact_decimal(expression.value);
            return text && text->size() < 40 ? *text : "";
        }
        case Expression::Kind::unary: {
            if (expression.name != "-") return "";
            const std::string of = written(expression.operands[0], true);
            if (of.empty()) return "";
            return std::isdigit(static_cast<unsigned char>(of[0])) ? '-' + of : "(- " + of + ')';
        }
        case Expression::Kind::binary: {
            const std::string left = written(expression.operands[0], true);
            const std::string right = written(expression.operands[1], true);
            if (std::string("+-*/^").find(expression.name) == std::string::npos || left.empty() ||
                right.empty())
                return "";
            out = left + ' ' + expression.name + ' ' + right;
            return inner ? '(' + out + ')' : out;
        }
        case Expression::Kind::call: {
            const auto reporter = reporters().find(expression.name);
            if (reporter == reporters().end() || expression.operands.size() != 1) return "";
            const auto& operand = expression.operands[0];
            const std::string of = written(operand, true);
            const bool nests = operand.kind == Expression::Kind::call;
            if (of.empty()) return "";
            return reporter->second + ' ' + (nests ? '(' + of + ')' : of);
        }
        default:
            return "";
    }
}

}  // namespace

std::string netlogo_number(const Quantity& number) {
    const std::string text = written(number.expression, false);
    return text.empty() ? value_of(number) : text;
}

Quantity negated(const Quantity& number) {
    if (number.exact) return quantity(-*number.exact);
    const Expression& expression = number.expression;
    const bool minus = expression.kind == Expression::Kind::unary && expression.name == "-";
    return {minus ? expression.operands[0]
                  : made_expression(Expression::Kind::unary, "-", {expression}),
            std::nullopt, -number.value};
}

Quantity turned_compass(const Quantity& degrees) {
    const Quantity ninety = quantity(90);
    if (degrees.exact) return quantity(*ninety.exact - *degrees.exact);
    const Expression& expression = degrees.expression;
    const bool turned = expression.kind == Expression::Kind::binary && expression.name == "-" &&
                        expression.operands[0] == ninety.expression;
    return {turned
                ? expression.operands[1]
                : made_expression(Expression::Kind::binary, "-", {ninety.expression, expression}),
            std::nullopt, 90 - degrees.value};
}

namespace {

/// A system as a NetLogo setup procedure says it. Each character of a text is a letter.
struct NetlogoSystem {
    struct Rule {
        std::string letter;
        std::string successor;
        std::string command;
    };
    std::vector<Rule> rules;
    std::string chain;
    std::map<std::string, Quantity> numbers;  // d, delta, x0, y0, delta-0, k-shorten, d-delta, k
};

/// The command that a text stands for: itself where the model knows it, otherwise "". The model
/// knows F f + - [ ] and S, and * where k is set.
std::string netlogo_command(const std::string& text, bool has_k) {
    if (text == "*") return has_k ? text : "";
    const bool known = text.size() == 1 && std::string("Ff+-[]S").find(text) != std::string::npos;
    return known ? text : "";
}

/// Whether a turtle of the notation does something at this symbol, so that it must be told not to.
bool acts(const std::string& symbol, bool has_k) {
    if (symbol == "*") return has_k;
    return symbol.size() == 1 &&
           std::string("FfG+-|[]{}.'%&^\\/$@").find(symbol) != std::string::npos;
}

/// Texts, and how many times each of them stands there.
using Counted = std::vector<std::pair<std::string, long>>;

void count(Counted& all, const std::string& thing) {
    const auto known = std::ranges::find(all, thing, &Counted::value_type::first);
    if (known != all.end())
        ++known->second;
    else
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
    static std::string word(const std::string& text) {
        Alphabet alphabet;
        ModuleWord word;
        for (const std::string_view letter : characters(text))
            word.letters.push_back(alphabet.symbol(letter));
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
        std::string words = system_.chain;
        for (const std::string& letter : letters_)
            for (const auto& [successor, times] : successors_.at(letter))
                words += letter + successor;
        for (const std::string_view letter : characters(words)) seen.symbol(letter);
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

/// The same system in the notation. The numbers must not lack d, delta and k-shorten, and [ and ]
/// must be commands of themselves only.
std::string netlogo_notation(const NetlogoSystem& system) { return Notation(system).text(); }

constexpr std::size_t most_rules = 10'000;

/// Commands without arguments that models begin and end with, and that say nothing of the system.
// clang-format off
constexpr const char* passed_over[] = {
    "clear-all", "ca", "clear-drawing", "cd", "clear-turtles", "ct", "clear-patches", "cp",
    "clear-links", "clear-globals", "clear-ticks", "clear-output", "clear-plot",
    "clear-all-plots", "reset-ticks", "reset-timer", "reset-perspective", "rp", "tick",
    "setup-plots", "update-plots", "display", "no-display"};
// clang-format on

/// A string between quotation marks, without them.
struct PlacedString : PlacedWord {
    std::size_t offset = 0;  // of the first mark
};

class Reader {
public:
    Reader(std::string_view text, const std::string& name)
        : name_(name), source_(text, name), findings_(source_), scanner_(text, name, {";"}) {}

    Model read() {
        while (!scanner_.at_end() && rules_.size() <= most_rules) {
            const std::size_t from = scanner_.offset();
            try {
                statement();
            } catch (const Diagnostics& error) {
                add(findings_, error);
                leave_line(from);
            }
        }
        if (inside_)
            findings_.add(
                source_.text().size(),
                fmt::format("expected 'end' of the procedure {}, found the end of the file",
                            procedures_.back().first));
        if (procedures_.size() > 1) refuse_procedures();
        if (findings_.empty()) check_all();
        findings_.throw_if_any();
        return read_written(netlogo_notation(system_), name_);
    }

private:
    void statement() {
        skip_line_numbers();
        if (scanner_.at_end()) return;
        const std::size_t at = scanner_.offset();
        if (scanner_.take_word("to")) return begin(at);
        if (scanner_.take_word("end")) {
            if (!std::exchange(inside_, false))
                scanner_.fail_at(at, "'end' without 'to' before it");
            return;
        }
        if (!procedures_.empty() && !inside_) fail("'to' or the end of the file behind 'end'");
        if (scanner_.take_word("add-rule")) return add_rule();
        if (scanner_.take_word("set")) return set();
        for (const char* command : passed_over)
            if (scanner_.take_word(command)) return;
        fail("'add-rule' or 'set'");
    }

    /// Fails with the whole word that stands here: NetLogo's have `-`, `?` and the like in them.
    [[noreturn]] void fail(const std::string& expectation) {
        const std::string_view rest = scanner_.rest();
        if (rest.empty() || !std::isalpha(static_cast<unsigned char>(rest[0])))
            scanner_.fail(expectation);
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n()[]\";"));
        scanner_.fail_at(scanner_.offset(),
                         "expected " + expectation + ", found " + algae::quoted(word));
    }

    /// At the beginnings of lines, as listings have them.
    void skip_line_numbers() {
        while (true) {
            const std::size_t at = scanner_.offset();
            const std::size_t before = source_.text().substr(0, at).find_last_not_of(" \t\r");
            if (before != std::string_view::npos && source_.text()[before] != '\n') return;
            const std::string_view rest = scanner_.rest();
            std::size_t size = 0;
            while (size < rest.size() && is_digit(static_cast<unsigned char>(rest[size]))) ++size;
            const bool ends =
                size == rest.size() || std::isspace(static_cast<unsigned char>(rest[size]));
            if (size == 0 || !ends) return;
            scanner_.take(rest.substr(0, size));
        }
    }

    /// Goes to the end of the line of the byte `from`, unless the scanner is past it.
    void leave_line(std::size_t from) {
        const std::string_view text = source_.text();
        const std::size_t end = std::min(text.find('\n', from), text.size());
        const std::size_t here = scanner_.offset();
        if (here < end) scanner_.take(text.substr(here, end - here));
    }

    void begin(std::size_t at) {
        if (inside_)
            scanner_.fail_at(at, fmt::format("expected 'end' of the procedure {} before 'to'",
                                             procedures_.back().first));
        const std::string name = scanner_.name("the name of a procedure behind 'to'");
        procedures_.emplace_back(name, at);
        inside_ = true;
        if (procedures_.size() == 1 && (!rules_.empty() || has_chain_))
            scanner_.fail_at(at, "expected no 'to' behind settings outside a procedure");
    }
    void refuse_procedures() {
        std::vector<std::string> names;
        for (const auto& [name, at] : procedures_) names.push_back(name);
        findings_.add(procedures_[1].second,
                      fmt::format("expected one procedure, found {}; put the one you want into a "
                                  "file of its own",
                                  listed(names, " and ")));
    }

    PlacedString string(const std::string& what) {
        PlacedString out;
        out.offset = scanner_.offset();
        const std::string_view rest = scanner_.rest();
        if (!rest.starts_with('"')) fail(what);
        std::size_t here = 1;
        while (true) {
            if (here == rest.size() || rest[here] == '\n')
                scanner_.fail_at(
                    out.offset,
                    "expected '\"' at the end of the string, found the end of the line");
            if (rest[here] == '"') break;
            const std::size_t at = out.offset + here;
            std::size_t bytes = first_character(rest.substr(here)).bytes;
            std::string character(rest.substr(here, bytes));
            if (character == "\\") {
                const std::string escaped(rest.substr(here, 2));
                if (escaped != "\\\\" && escaped != "\\\"")
                    scanner_.fail_at(at,
                                     fmt::format("expected '\\\\' or '\\\"' in a string, found {}",
                                                 algae::quoted(escaped)));
                character = escaped.substr(1);
                bytes = 2;
            }
            out.add(character, at);
            here += bytes;
        }
        scanner_.take(rest.substr(0, here + 1));
        return out;
    }

    /// A string of symbols.
    PlacedString word(const std::string& what) {
        PlacedString out = string(what);
        std::size_t i = 0;
        for (const std::string_view character : characters(out.text)) {
            check_symbol(character, out.offsets[i]);
            i += character.size();
        }
        check_brackets(out, findings_);
        return out;
    }
    void check_symbol(std::string_view character, std::size_t at) const {
        if (undeclared_length(character) != character.size())
            scanner_.fail_at(at, fmt::format("expected a symbol of the notation, found {}",
                                             algae::quoted(character)));
        if (character.size() == 4)
            scanner_.fail_at(
                at, fmt::format("expected a character of NetLogo, found {}, which is two there",
                                algae::quoted(character)));
    }

    void add_rule() {
        const std::size_t at = scanner_.offset();
        const PlacedString letter = string("a letter in quotation marks behind 'add-rule'");
        if (!is_character(letter.text))
            scanner_.fail_at(letter.offset,
                             fmt::format("expected one letter, found \"{}\"", letter.text));
        check_symbol(letter.text, letter.offsets[0]);
        const PlacedString successor = word("a successor in quotation marks");
        const PlacedString command = string("a command in quotation marks");
        rules_.emplace_back(command.offset, command.text);
        if (rules_.size() > most_rules) findings_.add(at, "more than 10000 rules");
        system_.rules.push_back({letter.text, successor.text, command.text});
    }

    void set() {
        static const std::vector<std::string> names{"chain",   "d",         "delta",   "x0", "y0",
                                                    "delta-0", "k-shorten", "d-delta", "k"};
        const std::size_t at = scanner_.offset();
        std::string name = scanner_.name("a setting behind 'set'");
        for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        if (std::ranges::count(names, name) == 0)
            scanner_.fail_at(at, "expected one of " + joined(names, ", ") + ", found " +
                                     algae::quoted(name) + did_you_mean(name, names));
        if (name == "chain") {
            chain_ = word("a word in quotation marks behind 'set chain'");
            has_chain_ = true;
            return;
        }
        const std::size_t where = scanner_.offset();
        const Quantity number = read_netlogo_number(scanner_);
        if (number.value == 0 && (name == "d" || name == "k-shorten" || name == "k"))
            scanner_.fail_at(where, fmt::format("expected a number other than 0 for {}", name));
        system_.numbers.insert_or_assign(name, number);
    }

    void check_all() {
        std::string missing = has_chain_ ? "" : "chain";
        for (const char* name : {"d", "delta", "k-shorten"})
            if (!system_.numbers.contains(name))
                missing += (missing.empty() ? "" : ", ") + std::string(name);
        if (!missing.empty())
            findings_.add(source_.text().size(),
                          "expected 'set' for " + missing + ", found the end of the file");
        system_.chain = chain_.text;
        const bool has_k = system_.numbers.contains("k");
        for (std::size_t i = 0; i < rules_.size(); ++i) {
            const std::string command = netlogo_command(rules_[i].second, has_k);
            const std::string& letter = system_.rules[i].letter;
            const bool stacks = command == "[" || command == "]";
            if ((stacks || letter == "[" || letter == "]") && command != letter)
                findings_.add(rules_[i].first,
                              fmt::format("expected '[' and ']' to stand for themselves, found the "
                                          "command \"{}\" of '{}'",
                                          rules_[i].second, letter));
        }
    }

    std::string name_;
    Source source_;
    Findings findings_;
    Scanner scanner_;
    NetlogoSystem system_;
    std::vector<std::pair<std::size_t, std::string>>
        rules_;  // where their commands stand, and these
    PlacedString chain_;
    bool has_chain_ = false;
    std::vector<std::pair<std::string, std::size_t>> procedures_;
    bool inside_ = false;
};

class Writer : FormatWriter {
public:
    explicit Writer(const Model& system) : FormatWriter(system, "netlogo") {}

    std::string text() {
        check_plain_rules(true);
        check_plain_settings();
        for (const Symbol symbol : system_.axiom.letters) see(symbol, "the axiom");
        for (const Production& rule : system_.rules) {
            const std::string where = "the rule " + print_rule(system_.alphabet, rule);
            see(rule.predecessor.symbol, where);
            for (const Symbol symbol : rule.successor.letters) see(symbol, where);
            rules_[rule.predecessor.symbol].push_back(&rule);
        }
        std::string out = commented("; ", {system_.title});
        if (std::ranges::any_of(std::views::values(rules_), [](const auto& rules) {
                return rules.size() > 1 && !rules[0]->probability;
            }))
            out += "; several rules for a letter: the model picks one at random\n";
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
    bool has_scale() const { return system_.drawing.scale.has_value(); }

    void see(Symbol symbol, const std::string& where) {
        const std::string& text = name(symbol);
        const auto starts = std::count_if(text.begin(), text.end(), [](char byte) {
            return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
        });
        if (starts != 1 || text.size() > 3)
            refuse(fmt::format("the symbol {} in {}, expected one character", text, where));
        if (std::ranges::count(seen_, symbol) == 0) seen_.push_back(symbol);
    }

    /// As often as the rules of a letter must stand there so that each is chosen with its
    /// probability.
    Integer repetitions(const Production& rule) const {
        if (!rule.probability) return 1;
        Integer common = 1;
        for (const Production* other : rules_.at(rule.predecessor.symbol))
            common = lcm(common, other->probability->denominator());
        if (common > 100)
            refuse(fmt::format(
                "the probabilities of {}: their common denominator is {}, expected at most 100",
                name(rule.predecessor.symbol), to_string(common)));
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
        for (const TurtleModule& module : interpreted(symbol)) {
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
        const Drawing& drawing = system_.drawing;
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
        for (const Drawing::Stamp& stamp : drawing.stamps)
            if (stamp.symbol == module.symbol) {
                if (stamp.shape != StampShape::square || !is(2)) fails();
                return "S";
            }
        if (std::ranges::count(drawing.solids, module.symbol, &SolidSetting::symbol) > 0) fails();
        if (of == "F" || of.starts_with("F_") || of == "G") return is(1) ? "F" : (fails(), "");
        if (of == "f" || of.starts_with("f_")) return is(1) ? "f" : (fails(), "");
        if (of.size() != 1) return "";
        const double angle = drawing.angle ? drawing.angle->value : 90;
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
                if (!has_scale() || !is(drawing.scale->value)) fails();
                return of;
            case '!':
                if (drawing.narrow || !module.parameters.empty()) fails();
                return "";
            default:
                if (std::strchr("|{}.%&^\\/$@", of[0])) fails();
                return "";
        }
    }

    std::string numbers() const {
        const Drawing& drawing = system_.drawing;
        const auto set = [](const char* name, const Quantity& number) {
            return "set " + (name + (' ' + netlogo_number(number))) + "\n";
        };
        const Quantity zero = quantity(0), one = quantity(1);
        const Quantity angle = drawing.angle.value_or(quantity(90));
        const Drawing::Start start = drawing.start.value_or(Drawing::Start{zero, zero, zero});
        std::string out = set("d", drawing.step.value_or(one)) +
                          set("delta", drawing.clockwise ? negated(angle) : angle) +
                          set("x0", start.x) + set("y0", start.y) +
                          set("delta-0", turned_compass(start.heading)) +
                          set("k-shorten", drawing.shrink.value_or(one));
        if (drawing.spin) out += set("d-delta", negated(*drawing.spin));
        if (drawing.scale) out += set("k", *drawing.scale);
        return out;
    }

    std::vector<Symbol> seen_;  // in the order of the words
    std::map<Symbol, std::vector<const Production*>> rules_;
};

}  // namespace

Model read_netlogo(std::string_view text, const std::string& name) {
    return Reader(text, name).read();
}

std::string print_netlogo(const Model& system) { return Writer(with_plain_angle(system)).text(); }

}  // namespace algae
