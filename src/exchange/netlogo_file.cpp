#include "exchange/netlogo_file.hpp"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "exchange/netlogo_number.hpp"
#include "exchange/netlogo_system.hpp"
#include "exchange/placed_word.hpp"
#include "exchange/scanner.hpp"
#include "notation/characters.hpp"
#include "notation/findings.hpp"
#include "notation/lexicon.hpp"
#include "notation/read.hpp"
#include "notation/suggestion.hpp"

namespace algae {

namespace {

constexpr std::size_t most_rules = 10'000;

/// Commands without arguments that models begin and end with, and that say nothing of the system.
constexpr const char* passed_over[] = {"clear-all",
                                       "ca",
                                       "clear-drawing",
                                       "cd",
                                       "clear-turtles",
                                       "ct",
                                       "clear-patches",
                                       "cp",
                                       "clear-links",
                                       "clear-globals",
                                       "clear-ticks",
                                       "clear-output",
                                       "clear-plot",
                                       "clear-all-plots",
                                       "reset-ticks",
                                       "reset-timer",
                                       "reset-perspective",
                                       "rp",
                                       "tick",
                                       "setup-plots",
                                       "update-plots",
                                       "display",
                                       "no-display"};

/// A string between quotation marks, without them.
struct PlacedString : PlacedWord {
    std::size_t offset = 0;  // of the first mark
};

/// Whether the text is one character.
bool is_one_character(std::string_view text) {
    return !text.empty() && first_character(text).bytes == text.size();
}

class Reader {
public:
    Reader(std::string_view text, const std::string& name)
        : name_(name), source_(text, name), findings_(source_), scanner_(text, name, {";"}) {}

    LSystem read() {
        while (!scanner_.at_end() && rules_.size() <= most_rules) {
            const std::size_t from = scanner_.offset();
            try {
                statement();
            } catch (const Diagnostics& error) {
                for (const Diagnostic& finding : error.findings())
                    findings_.add(finding.place, finding.message);
                leave_line(from);
            }
        }
        if (inside_)
            findings_.add(source_.text().size(), "expected 'end' of the procedure " +
                                                     procedures_.back().first +
                                                     ", found the end of the file");
        if (procedures_.size() > 1) refuse_procedures();
        if (findings_.empty()) check_all();
        findings_.throw_if_any();
        return read_lsystem(netlogo_notation(system_), name_);
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
        scanner_.fail_at(scanner_.offset(), "expected " + expectation + ", found " + quoted(word));
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
            scanner_.fail_at(
                at, "expected 'end' of the procedure " + procedures_.back().first + " before 'to'");
        const std::string name = scanner_.name("the name of a procedure behind 'to'");
        procedures_.emplace_back(name, at);
        inside_ = true;
        if (procedures_.size() == 1 && (!rules_.empty() || has_chain_))
            scanner_.fail_at(at, "expected no 'to' behind settings outside a procedure");
    }
    void refuse_procedures() {
        std::string all;
        for (std::size_t i = 0; i < procedures_.size(); ++i)
            all += (i == 0                        ? ""
                    : i + 1 == procedures_.size() ? " and "
                                                  : ", ") +
                   procedures_[i].first;
        findings_.add(procedures_[1].second, "expected one procedure, found " + all +
                                                 "; put the one you want into a file of its own");
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
                    scanner_.fail_at(
                        at, "expected '\\\\' or '\\\"' in a string, found " + quoted(escaped));
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
        for (std::size_t i = 0; i < out.text.size();) {
            const std::size_t bytes = first_character(std::string_view(out.text).substr(i)).bytes;
            check_symbol(out.text.substr(i, bytes), out.offsets[i]);
            i += bytes;
        }
        check_brackets(out, findings_);
        return out;
    }
    void check_symbol(const std::string& character, std::size_t at) const {
        if (undeclared_length(character) != character.size())
            scanner_.fail_at(at, "expected a symbol of the notation, found " + quoted(character));
        if (character.size() == 4)
            scanner_.fail_at(at, "expected a character of NetLogo, found " + quoted(character) +
                                     ", which is two there");
    }

    void add_rule() {
        const std::size_t at = scanner_.offset();
        const PlacedString letter = string("a letter in quotation marks behind 'add-rule'");
        if (!is_one_character(letter.text))
            scanner_.fail_at(letter.offset, "expected one letter, found \"" + letter.text + "\"");
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
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            std::string all;
            for (const std::string& known : names) all += (all.empty() ? "" : ", ") + known;
            scanner_.fail_at(at, "expected one of " + all + ", found " + quoted(name) +
                                     did_you_mean(name, names));
        }
        if (name == "chain") {
            chain_ = word("a word in quotation marks behind 'set chain'");
            has_chain_ = true;
            return;
        }
        const std::size_t where = scanner_.offset();
        const Quantity number = read_netlogo_number(scanner_);
        if (number.value == 0 && (name == "d" || name == "k-shorten" || name == "k"))
            scanner_.fail_at(where, "expected a number other than 0 for " + name);
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
                              "expected '[' and ']' to stand for themselves, found the command \"" +
                                  rules_[i].second + "\" of '" + letter + "'");
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

}  // namespace

LSystem read_netlogo(std::string_view text, const std::string& name) {
    return Reader(text, name).read();
}

}  // namespace algae
