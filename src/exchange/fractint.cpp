#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exchange/detail/formats.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "exchange/detail/scanner.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"

// L-systems of Fractint, Xfractint and Iterated Dynamics: many systems in a file `*.l`.
//
//     Koch1 { ; von Koch's snowflake
//       Angle 6
//       Axiom F--F--F
//       F=F-F++F-F
//     }
//
// A file is bytes: everything is lower case to the program, and several lines for one symbol are one rule, one behind the other.
// A `}` ends an entry only as the first word of its line. What the program rejects is rejected here, with the place.
//
// The turtle has two headings. F and G go along one that + - and | turn by whole units of 360/N degrees; D and M go along another
// that \nn and /nn turn by degrees, and neither sees the turns of the other. Where only one kind of steps occurs the turns of the other do
// nothing and are left out of the interpretation. `!` swaps the meaning of + and -, \ and /; < and > count the colour. `|` turns by floor(N/2)
// units clockwise, so it is half a turn only if N is even.
//
// The notation has one heading, no such flag and no counter. So the reader keeps them: it goes along the words with a state, the difference of
// the headings, the flag and the colour, and a letter of which symbols are derived that ask for a part of the state becomes a letter for
// each of its values. D is then a turn by the difference, a step and the turn back. This says everything unless a letter, from one order to the
// next, changes a part of the state that a symbol behind it asks for; such systems are refused.
//
// Reading writes a text of the notation, in which every symbol or command with its number, `@iq2`, is one symbol: letters are
// capitals, characters that can be no symbols are `X_40` by their codes, and what a symbol does to the turtle, if that is not what the
// notation does for it anyway, is said by `interpret`. So words have a letter for each command, and no parameters.

namespace algae {

namespace {

constexpr const char* reserved_by_fractint = "+-/\\@|!c<>][";
constexpr std::size_t significant = 18;  // characters of a name
constexpr std::size_t most_lines = 100'000;

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }
char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

bool is_gap(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// A line of an entry without its comment.
struct Line {
    std::size_t offset = 0;
    std::string_view text;
};

/// An entry that is whole: its name and the lines between its braces.
struct Entry {
    std::string name;
    std::size_t offset = 0;
    std::vector<Line> lines;
};

std::string folded(std::string_view name) {
    std::string out(name.substr(0, significant));
    std::ranges::transform(out, out.begin(), lower);
    return out;
}

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find(';')); }

/// The entries of a file: the name is the first word of the line on which the brace opens.
std::vector<Entry> entries_of(std::string_view text) {
    std::vector<Entry> found;
    std::optional<Entry> open;
    std::size_t lines = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = without_comment(text.substr(begin, end - begin));
        if (++lines > most_lines) throw Error("more than " + std::to_string(most_lines) + " lines");
        const std::size_t brace = line.find('{'), close = line.find('}');
        if (brace != std::string_view::npos && (!open || brace < close)) {
            std::size_t first = 0;
            while (first < brace && is_gap(line[first])) ++first;
            std::size_t last = first;
            while (last < brace && !is_gap(line[last]) && line[last] != '(') ++last;
            open = Entry{std::string(line.substr(first, last - first)), begin + first, {}};
            open->lines.push_back({begin + brace + 1, line.substr(brace + 1)});
        } else if (open) {
            open->lines.push_back({begin, line});
        }
        const Line* const now = open ? &open->lines.back() : nullptr;
        if (now && now->text.find('}') != std::string_view::npos) {
            if (folded(open->name) != "comment") found.push_back(std::move(*open));
            open.reset();
        }
        begin = end + 1;
    }
    return found;
}

/// A word as commands: each a character, with its number behind `@ \ / c < >`.
struct Command {
    char letter = 0;
    std::string number;
    std::size_t offset = 0;

    std::string text() const { return letter + number; }
};

constexpr unsigned colours = 256;

bool takes_number(char c) { return std::string_view("@/\\c<>").find(c) != std::string_view::npos; }

std::vector<Command> commands_of(const PlacedWord& word) {
    std::vector<Command> out;
    const std::string& text = word.text;
    for (std::size_t i = 0; i < text.size();) {
        Command one{text[i], {}, word.offsets[i]};
        std::size_t end = i + 1;
        if (takes_number(text[i])) {
            for (int roots = 0;
                 roots < 2 && end < text.size() && (text[end] == 'q' || text[end] == 'i'); ++roots)
                ++end;
            while (end < text.size() &&
                   (is_digit(static_cast<unsigned char>(text[end])) || text[end] == '.'))
                ++end;
            one.number = text.substr(i + 1, end - i - 1);
        }
        out.push_back(std::move(one));
        i = end;
    }
    return out;
}

/// The digits of a number without q and i; empty where the program reads 0.
std::string digits_of(const std::string& number) {
    const std::size_t first = std::min(number.find_first_not_of("qi"), number.size());
    const std::string digits = number.substr(first);
    if (digits.find_first_not_of("0.") == std::string::npos) return {};
    // The program reads no further than to a second point.
    std::string plain = plain_number(digits.substr(0, digits.find('.', digits.find('.') + 1)));
    return plain.starts_with('.') ? "0" + plain : plain;
}

/// The value as an expression of the notation: the root first, then the inverse.
std::string expression_of(const std::string& number) {
    std::string value = digits_of(number);
    if (value.empty()) return "0";
    const std::string marks = number.substr(0, number.find_first_not_of("qi"));
    if (marks.find('q') != std::string::npos) value = "sqrt(" + value + ")";
    if (marks.find('i') != std::string::npos) value = "1/" + value;
    return value;
}

class Reader {
public:
    Reader(std::string_view text, const std::string& name)
        : text_(text), shown_(printable(text)), source_(shown_, name), findings_(source_) {}

    Model read(const std::string& file, const std::string& wanted) {
        const Entry entry = chosen(file, wanted);
        for (const Line& line : entry.lines) {
            try {
                if (!read_line(line)) break;
            } catch (const Diagnostics& error) {
                add(findings_, error);
                is_faulty_ = true;
            }
        }
        check(entry);
        findings_.throw_if_any();
        const std::string text = notation(entry);
        findings_.throw_if_any();
        return read_written(text, source_.file());
    }

private:
    /// Bytes beyond ASCII stand in comments only; a message shows them as `?`.
    static std::string printable(std::string_view text) {
        std::string out(text);
        for (char& c : out)
            if (static_cast<unsigned char>(c) >= 0x80 || c == '\0' ||
                (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' && c != '\r') ||
                c == 0x7F)
                c = '?';
        return out;
    }

    [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
        throw Diagnostics({source_.finding(offset, message)});
    }

    Entry chosen(const std::string& file, const std::string& wanted) const {
        const std::vector<Entry> all = entries_of(shown_);
        std::vector<std::string> names;
        for (const Entry& entry : all)
            if (!entry.name.empty()) names.push_back(entry.name);
        const auto some = [&] {
            constexpr std::size_t most = 12;
            std::vector<std::string> shown(
                names.begin(),
                names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size())));
            return joined(shown, ", ") +
                   (names.size() > most ? ", ... (" + std::to_string(names.size()) + ")" : "");
        };
        if (names.empty())
            throw Error(
                file +
                ": expected an entry NAME { ... } with the name and '{' on one line, found none");
        if (wanted.empty() && names.size() > 1)
            throw Error(file + " has several systems: " + some() + "; say which: " + file + ":" +
                        names.front());
        for (const Entry& entry : all)
            if (wanted.empty() ? !entry.name.empty() : folded(entry.name) == folded(wanted))
                return entry;
        throw Error(file + " has no system " + quoted(wanted) + did_you_mean(wanted, names) +
                    "; it has " + some());
    }

    /// The words of a line; in rules `=` separates too, as it does behind a keyword.
    static std::size_t gap(std::string_view text, std::size_t at, bool equals) {
        while (at < text.size() && (is_gap(text[at]) || (equals && text[at] == '='))) ++at;
        return at;
    }
    static std::size_t word_end(std::string_view text, std::size_t at, bool equals) {
        while (at < text.size() && !is_gap(text[at]) && !(equals && text[at] == '=')) ++at;
        return at;
    }

    /// False at the brace that ends the entry.
    bool read_line(const Line& line) {
        const std::string_view text = line.text;
        std::size_t at = gap(text, 0, false);
        if (at == text.size()) return true;
        const std::size_t end = word_end(text, at, true);
        const std::size_t place = line.offset + at;
        const std::string first = word(line, at, end).text;
        if (first.empty()) fail(place, "expected a symbol before '='");
        if (first == "}") return false;
        if (first == "axiom" || first == "angle") {
            // `=` separates right behind the keyword only: `Axiom = F` has a word '='.
            std::size_t from = end;
            if (from < text.size() && text[from] == '=') from = from + 1;
            from = gap(text, from, false);
            const std::size_t to = word_end(text, from, false);
            if (from == to) fail(place, "expected a value after " + quoted(first));
            check_end(line, to, "the value of " + quoted(first));
            if (first == "axiom")
                axiom_ = word(line, from, to);
            else
                read_angle(line, from, to);
            return true;
        }
        if (first.size() > 1) {
            if (first.ends_with("}"))
                fail(place + first.size() - 1, "expected '}' on a line of its own");
            fail(place, "expected 'Axiom', 'Angle', '}' or a rule for one symbol, found " +
                            quoted(first) + did_you_mean(first, {"axiom", "angle"}));
        }
        if (std::string_view(reserved_by_fractint).find(first[0]) != std::string_view::npos)
            fail(place, "the command " + quoted(first) + " cannot be rewritten");
        const std::size_t from = gap(text, end, true), to = word_end(text, from, true);
        if (const std::string_view arrow = std::string_view(text).substr(from, to - from);
            arrow == "->" || arrow == "-->")
            fail(line.offset + from, "expected a rule such as F=F+F, found " + quoted(arrow));
        check_end(line, to, "the rule for " + quoted(first));
        PlacedWord& rule = rules_[first[0]];
        if (places_.emplace(first[0], place).second) order_.push_back(first[0]);
        const PlacedWord more = word(line, from, to);
        for (std::size_t i = 0; i < more.text.size(); ++i)
            rule.add(std::string_view(more.text).substr(i, 1), more.offsets[i]);
        return true;
    }

    void check_end(const Line& line, std::size_t at, const std::string& what) const {
        const std::size_t next = gap(line.text, at, false);
        if (next == line.text.size()) return;
        fail(line.offset + next,
             line.text[next] == '}'
                 ? "expected '}' on a line of its own"
                 : "expected the end of the line after " + what + ", which has no blanks, found " +
                       quoted(line.text.substr(next, word_end(line.text, next, false) - next)));
    }

    PlacedWord word(const Line& line, std::size_t from, std::size_t to) const {
        PlacedWord out;
        for (std::size_t i = from; i < to; ++i) {
            if (static_cast<unsigned char>(text_[line.offset + i]) >= 0x80)
                fail(line.offset + i,
                     "expected symbols of ASCII, found the byte " +
                         std::to_string(static_cast<unsigned char>(text_[line.offset + i])));
            out.add(std::string(1, lower(line.text[i])), line.offset + i);
        }
        return out;
    }

    void read_angle(const Line& line, std::size_t from, std::size_t to) {
        const std::string_view text = line.text.substr(from, to - from);
        std::size_t digits = 0;
        long value = 0;
        while (digits < text.size() && is_digit(static_cast<unsigned char>(text[digits])) &&
               value < 1000)
            value = value * 10 + (text[digits++] - '0');
        if (value < 3 || value > 50)
            fail(line.offset + from,
                 "expected an angle from 3 to 50, the parts of a full turn, found " + quoted(text) +
                     (value > 50 && 360 % value == 0 && 360 / value >= 3
                          ? "; " + std::to_string(value) + " degrees are 'Angle " +
                                std::to_string(360 / value) + "'"
                          : ""));
        angle_ = static_cast<unsigned>(value);
    }

    /// Everything that must hold of the entry as a whole.
    void check(const Entry& entry) {
        if (!axiom_ && !is_faulty_)
            findings_.add(entry.offset,
                          "expected an axiom in " + quoted(entry.name) + ", found none");
        if (angle_ == 0 && !is_faulty_)
            findings_.add(entry.offset, "expected 'Angle' and a number from 3 to 50 in " +
                                            quoted(entry.name) + ", found none");
        if (axiom_) cut(*axiom_);
        for (auto& [symbol, rule] : rules_) cut(rule);
        if (!axiom_ || !findings_.empty()) return;
        // Letters that the axiom reaches, each with the place where it first stands.
        std::vector<char> todo;
        const auto meet = [&](const PlacedWord& word) {
            for (const Command& one : commands_of(word)) {
                if (met_.emplace(one.letter, one.offset).second) todo.push_back(one.letter);
            }
        };
        meet(*axiom_);
        while (!todo.empty()) {
            const auto rule = rules_.find(todo.back());
            todo.pop_back();
            if (rule != rules_.end()) meet(rule->second);
        }
        const auto place = [&](char letter) { return met_.at(letter); };
        indexed_ = met_.contains('f') || met_.contains('g');
        const bool real = met_.contains('d') || met_.contains('m');
        const auto meets = [&](const char* letters) {
            return std::ranges::any_of(std::string_view(letters),
                                       [&](char letter) { return met_.contains(letter); });
        };
        tracked_[flag] = meets("!") && meets("+-/\\");
        tracked_[headings] = indexed_ && real;
        tracked_[colour] = meets("<>");
        for (const char brace : {'{', '}'})
            if (met_.contains(brace))
                findings_.add(place(brace), fmt::format("'{}' cannot stand in a word", brace));
    }

    /// `]` without `[` ends a word; the program never reads what stands behind it.
    void cut(PlacedWord& word) {
        int open = 0;
        for (std::size_t i = 0; i < word.text.size(); ++i) {
            open += word.text[i] == '[' ? 1 : word.text[i] == ']' ? -1 : 0;
            if (open >= 0) continue;
            word.text.resize(i);
            word.offsets.resize(i);
        }
        check_brackets(word, findings_);
    }

    // --- The state ---

    enum Part { flag, headings, colour, parts };
    using Parts = std::array<bool, parts>;

    /// What a word is drawn in beside place and heading.
    struct State {
        bool swapped = false;
        Rational difference = 0;  // how much further to the left the heading of D is, in degrees
        unsigned colour = 0;
        std::array<char, parts> unknown{};  // the letter that changes this part

        bool operator<(const State& other) const {
            return std::tuple(swapped, colour, difference) <
                   std::tuple(other.swapped, other.colour, other.difference);
        }
    };

    bool is_tracking() const { return tracked_[flag] || tracked_[headings] || tracked_[colour]; }

    /// The parts that a command, or what is derived from it, asks for.
    Parts asked_by(const Command& one) const {
        Parts found{};
        if (const auto derived = asks_.find(one.letter); derived != asks_.end())
            found = derived->second;
        const auto is_one_of = [&](const char* letters) {
            return std::string_view(letters).find(one.letter) != std::string_view::npos;
        };
        found[flag] = (found[flag] || is_one_of("+-/\\")) && tracked_[flag];
        found[headings] = (found[headings] || is_one_of("dm")) && tracked_[headings];
        found[colour] = (found[colour] || is_one_of("<>")) && tracked_[colour];
        return found;
    }

    static Rational turned(Rational degrees) {
        return degrees - floor(degrees / Rational(360)) * Rational(360);
    }
    /// The whole number that a command has.
    static unsigned count_of(const Command& one) {
        unsigned count = 0;
        for (const char c : one.number)
            if (is_digit(static_cast<unsigned char>(c)) && count < 100'000)
                count = count * 10 + static_cast<unsigned>(c - '0');
            else
                break;
        return count;
    }

    /// The state behind a command.
    void pass(const Command& one, State& state) {
        const Rational unit = Rational(360) / Rational(angle_);
        const int side = state.swapped ? -1 : 1;
        switch (one.letter) {
            case '!':
                state.swapped = tracked_[flag] && !state.swapped;
                break;
            case '+':
                if (tracked_[headings]) state.difference = turned(state.difference - side * unit);
                break;
            case '-':
                if (tracked_[headings]) state.difference = turned(state.difference + side * unit);
                break;
            case '|':
                if (tracked_[headings])
                    state.difference = turned(state.difference + Rational(angle_ / 2) * unit);
                break;
            case '\\':
            case '/':
                if (!tracked_[headings]) break;
                if (one.number.find('q') != std::string::npos) {
                    if (told_.insert(one.text()).second)
                        findings_.add(one.offset,
                                      "expected a turn without a root where both D or M "
                                      "and F or G go, found " +
                                          quoted(one.text()));
                    break;
                }
                state.difference = turned(state.difference + (one.letter == '\\' ? side : -side) *
                                                                 value_of(one.number));
                break;
            case 'c':
                if (tracked_[colour]) {
                    state.colour = count_of(one) % colours;
                    state.unknown[colour] = 0;
                }
                break;
            case '<':
                if (tracked_[colour]) state.colour = (state.colour + count_of(one)) % colours;
                break;
            case '>':
                if (tracked_[colour])
                    state.colour = (state.colour + colours - count_of(one) % colours) % colours;
                break;
            default:
                break;
        }
        if (const auto derived = changes_.find(one.letter); derived != changes_.end())
            for (int part = 0; part < parts; ++part)
                if (derived->second[static_cast<std::size_t>(part)])
                    state.unknown[static_cast<std::size_t>(part)] = one.letter;
    }
    /// A number without a root.
    static Rational value_of(const std::string& number) {
        const std::string digits = digits_of(number);
        if (digits.empty()) return 0;
        const Rational value(digits);
        return number.find('i') < number.find_first_of("0123456789.") ? Rational(1) / value : value;
    }

    /// Goes along a word: `each` has a command and the state before it.
    template <class Each>
    State walk(const PlacedWord& word, State state, Each each) {
        std::vector<State> open;
        for (const Command& one : commands_of(word)) {
            each(one, state);
            if (one.letter == '[') open.push_back(state);
            if (one.letter == ']' && !open.empty()) {
                state = open.back();
                open.pop_back();
            }
            pass(one, state);
        }
        return state;
    }

    /// Which letters ask for parts of the state, and which do not leave it as it was.
    void find_changes() {
        for (bool more = true; more;) {
            more = false;
            for (const auto& [letter, word] : rules_) {
                const Parts asked = asks_[letter], changed = changes_[letter];
                Parts &asks = asks_[letter], &changes = changes_[letter];
                const State end = walk(word, {}, [&](const Command& one, const State&) {
                    const Parts by = asked_by(one);
                    for (std::size_t part = 0; part < parts; ++part)
                        asks[part] = asks[part] || by[part];
                    if (one.letter == 'c' && tracked_[colour]) changes[colour] = true;
                });
                changes[flag] = changes[flag] || end.swapped || end.unknown[flag];
                changes[headings] =
                    changes[headings] || end.difference != Rational(0) || end.unknown[headings];
                changes[colour] = changes[colour] || end.colour != 0 || end.unknown[colour];
                // The flag decides which way turns go.
                if (end.unknown[flag] != 0 && tracked_[headings]) changes[headings] = true;
                asks[flag] = asks[flag] || (asks[headings] && tracked_[flag]);
                more = more || asks != asked || changes != changed;
            }
        }
    }

    /// A command as it is drawn in a state: the symbol of the notation.
    std::string symbol_in(Command one, const State& before) {
        State state;
        const Parts asked = asked_by(one);
        for (std::size_t part = 0; part < parts; ++part)
            if (asked[part] && before.unknown[part] != 0 && told_.insert(one.text()).second)
                findings_.add(
                    one.offset,
                    fmt::format(
                        "'{}' depends on {}, which '{}' before it changes from one order to "
                        "the next; the notation has no such state",
                        one.text(),
                        part == flag       ? "what ! swaps"
                        : part == headings ? "the difference of the two headings"
                                           : "the colour",
                        before.unknown[part]));
        if (asked[flag]) state.swapped = before.swapped;
        if (asked[headings]) state.difference = before.difference;
        if (asked[colour]) state.colour = before.colour;
        if (state.swapped && !rules_.contains(one.letter)) {
            static constexpr std::string_view turns = "+-/\\", others = "-+\\/";
            if (const std::size_t at = turns.find(one.letter); at != std::string_view::npos)
                one.letter = others[at];
            state.swapped = false;
        }
        if (!rules_.contains(one.letter) && one.letter != 'd' && one.letter != 'm' &&
            one.letter != '<' && one.letter != '>')
            state = {};
        constexpr std::size_t most = 2000;
        auto& known = versions_[one.text()];
        const auto [version, is_new] = known.emplace(state, known.size());
        if (is_new && ++version_count_ > most && told_.insert("").second)
            findings_.add(one.offset,
                          "the state of the turtle has more than 2000 values: that is too many "
                          "letters of the notation");
        if (is_new && rules_.contains(one.letter) && version_count_ <= most)
            todo_.emplace_back(one, state);
        return symbol(one, state, version->second);
    }

    /// The symbol of the notation for a command.
    std::string symbol(const Command& one) { return symbol(one, State(), 0); }
    std::string symbol(const Command& one, const State& state, std::size_t version) {
        std::string name;
        const auto code = static_cast<unsigned char>(one.letter);
        if (std::string_view("(),:;?#=\"<>").find(one.letter) != std::string_view::npos)
            name = fmt::format("X_{}", code) + (one.number.empty() ? "" : "·" + one.number);
        else
            name = upper(one.letter) + one.number;
        if (version > 0) name += "·" + std::to_string(version);
        if (names_.emplace(name, one).second) {
            if (name.size() > 1) alphabet_ += " " + name;
            const std::string meaning = meaning_in(one, state, name);
            if (meaning != name) interpretation_ += "interpret " + name + " -> " + meaning + "\n";
        }
        return name;
    }

    std::string degrees(unsigned units) const {
        const Rational all = Rational(360) * Rational(units) / Rational(angle_);
        return shortest_text(all);
    }

    std::string meaning_in(const Command& one, const State& state, const std::string& name) const {
        const std::string meaning = meaning_of(one);
        if (one.letter == '<' || one.letter == '>') {
            const unsigned by = count_of(one) % colours;
            return fmt::format("'({})",
                               (state.colour + (one.letter == '<' ? by : colours - by)) % colours);
        }
        if (tracked_[headings] && (one.letter == 'd' || one.letter == 'm') &&
            state.difference != Rational(0)) {
            const std::string by = shortest_text(state.difference);
            return "+(" + by + ")" + meaning + "-(" + by + ")";
        }
        // A letter that does nothing may have another name than the one that it does nothing by.
        return meaning == std::string(1, upper(one.letter)) && meaning != "F" ? name : meaning;
    }

    std::string meaning_of(const Command& one) const {
        const std::string number = expression_of(one.number);
        const std::string nothing = "ε";
        switch (one.letter) {
            case 'f':
                return "F";
            case 'g':
            case 'm':
                return "f";
            case 'd':
                return "F";
            case '+':
            case '-':
                return indexed_ ? std::string(1, one.letter) : nothing;
            case '|':
                if (!indexed_) return nothing;
                return angle_ % 2 == 0 ? "|" : "-(" + degrees(angle_ / 2) + ")";
            case '\\':
                return indexed_ || number == "0" ? nothing : "+(" + number + ")";
            case '/':
                return indexed_ || number == "0" ? nothing : "-(" + number + ")";
            case '@':
                return "*(" + number + ")";
            case 'c':
                return fmt::format("'({})", count_of(one) % colours);
            case '[':
                return "[";
            case ']':
                return "]";
            default:
                break;
        }
        // Letters do nothing, in the notation too; other characters may do something there.
        return std::isalnum(static_cast<unsigned char>(one.letter)) ||
                       std::string_view("(),:;?#=\"_").find(one.letter) != std::string_view::npos
                   ? (std::isalnum(static_cast<unsigned char>(one.letter))
                          ? std::string(1, upper(one.letter))
                          : fmt::format("X_{}", static_cast<unsigned char>(one.letter)))
                   : nothing;
    }

    std::string spelled(const PlacedWord& word, const State& state) {
        std::vector<std::string> letters;
        walk(word, state, [&](const Command& one, const State& now) {
            letters.push_back(is_tracking() ? symbol_in(one, now) : symbol(one));
        });
        return spaced_word(letters);
    }

    std::string notation(const Entry& entry) {
        if (is_tracking()) find_changes();
        std::string rules = "axiom " + spelled(*axiom_, {}) + "\n";
        if (!is_tracking())
            for (const char left : order_) {
                const std::string name = symbol({left, {}, 0});
                rules += name + " -> " + spelled(rules_.at(left), {}) + "\n";
            }
        while (!todo_.empty() && findings_.empty()) {
            const auto [letter, state] = todo_.front();
            todo_.pop_front();
            const std::string name = symbol(letter, state, versions_.at(letter.text()).at(state));
            rules += name + " -> " + spelled(rules_.at(letter.letter), state) + "\n";
        }
        std::string head = "title " + entry.name + "\n";
        if (!alphabet_.empty()) head += "alphabet" + alphabet_ + "\n";
        return head + rules + interpretation_ + "angle " + degrees(1) + "\n";
    }

    std::string_view text_;
    std::string shown_;
    Source source_;
    Findings findings_;
    std::optional<PlacedWord> axiom_;
    unsigned angle_ = 0;
    bool is_faulty_ = false;  // some line: what is missing may have been there
    std::map<char, PlacedWord> rules_;
    std::map<char, std::size_t> places_;
    std::vector<char> order_;
    std::map<char, std::size_t> met_;       // letters of words, with their places
    bool indexed_ = false;                  // steps go along the heading of F and G
    Parts tracked_{};                       // parts of the state that occur
    std::map<char, Parts> asks_, changes_;  // by letters with rules
    std::map<std::string, std::map<State, std::size_t>> versions_;  // of a command, by the state
    std::deque<std::pair<Command, State>> todo_;                    // letters without a rule yet
    std::size_t version_count_ = 0;
    std::set<std::string> told_;  // commands that are refused
    std::map<std::string, Command> names_;
    std::string alphabet_, interpretation_;
};

/// Writes a system as an entry.
class Writer : FormatWriter {
public:
    explicit Writer(const Model& system) : FormatWriter(system, "fractint") {}

    std::string written() {
        check_plain_rules(false);
        check_plain_settings();
        const Drawing& drawing = system_.drawing;
        if (drawing.start && drawing.start->heading.value != 0)
            refuse("a start heading other than 0");
        if (!is_usual(drawing.spin, 0)) refuse("a spin");
        if (!drawing.stamps.empty()) refuse("stamps");
        if (!drawing.solids.empty()) refuse("solids");
        find_angle();
        for (const Symbol a : system_.axiom.letters) meet(a);
        for (const Production& rule : system_.rules) {
            meet(rule.predecessor.symbol);
            for (const Symbol a : rule.successor.letters) meet(a);
        }
        for (const Symbol a : order_) name_letter(a);
        std::string out = entry_name() + " {";
        if (!system_.title.empty()) out += " ; " + one_line(system_.title);
        out += fmt::format("\n  Angle {}\n", angle_);
        if (system_.axiom.letters.empty()) refuse("the empty word as axiom");
        out += "  Axiom " + text(system_.axiom.letters) + "\n";
        for (const Production& rule : system_.rules) {
            const std::string& left = names_.at(rule.predecessor.symbol);
            if (left.size() != 1 || std::string_view(reserved_by_fractint).find(lower(left[0])) !=
                                        std::string_view::npos)
                refuse(rule, "its left side is a command there");
            std::string right = text(rule.successor.letters);
            // Lines are cut at 255 characters; a rule goes on in a line of its own, between commands.
            out += "  " + left + "=";
            std::size_t length = 0;
            for (const Symbol a : rule.successor.letters) {
                const std::string& one = names_.at(a);
                if (length + one.size() > 140) {
                    out += "\n  " + left + "=";
                    length = 0;
                }
                out += one;
                length += one.size();
            }
            out += "\n";
        }
        return out + "}\n";
    }

private:
    static std::string one_line(std::string text) {
        std::ranges::replace_if(
            text, [](char c) { return c == '\n' || c == '{' || c == '}'; }, ' ');
        return text;
    }

    std::string entry_name() const {
        std::string name;
        for (const char c : system_.title.empty() ? system_.name : system_.title)
            if (std::isalnum(static_cast<unsigned char>(c)) && name.size() < significant) name += c;
        return name.empty() || folded(name) == "comment" ? "System" : name;
    }

    void find_angle() {
        const auto& angle = system_.drawing.angle;
        const std::optional<Rational> degrees = angle ? angle->exact : Rational(90);
        for (unsigned n = 3; n <= 50 && degrees; ++n)
            if (Rational(360) / Rational(n) == *degrees) angle_ = n;
        if (angle_ != 0) return;
        if (!degrees) refuse("an angle that is not rational");
        // A multiple of a smaller unit does too.
        for (unsigned n = 3; n <= 50; ++n) {
            const Rational units = *degrees * Rational(n) / Rational(360);
            if (units == floor(units) && units > 0 && units < Rational(50)) {
                angle_ = n;
                unit_ = static_cast<unsigned>(floor(units).to_uint64());
                return;
            }
        }
        refuse("the angle " + to_text(angle->expression) +
               ": expected a multiple of 360/N degrees, N from 3 to 50");
    }

    void meet(Symbol a) {
        if (std::ranges::count(order_, a) == 0) order_.push_back(a);
    }

    /// The commands that do what the letter does; nothing if it does nothing.
    std::string commands(Symbol a) const {
        std::string out;
        for (const TurtleModule& module : interpreted(a)) out += command(a, module);
        return out;
    }

    std::string turns(bool left, unsigned count) const {
        return std::string(count, left != system_.drawing.clockwise ? '+' : '-');
    }

    std::string command(Symbol a, const TurtleModule& module) const {
        const std::string& what = name(module.symbol);
        const auto fail = [&](const std::string& why) {
            refuse("the letter " + name(a) + ", which " + why);
        };
        const bool has_number = !module.parameters.empty();
        if (what == "F" || what == "f" || what.starts_with("F_") || what.starts_with("f_") ||
            what == "G") {
            if (has_number && module.parameters[0].value != 1) fail("takes steps of other lengths");
            return what[0] == 'f' ? "G" : "F";
        }
        if (what == "+" || what == "-") {
            if (!has_number) return turns(what == "+", unit_);
            const auto& degrees = module.parameters[0].exact;
            if (!degrees) fail("turns by an angle that is not rational");
            const Rational units = *degrees * Rational(angle_) / Rational(360);
            if (units != floor(units) || abs(units) > Rational(50))
                fail("turns by " + shortest_text(*degrees) + " degrees, no multiple of 360/" +
                     std::to_string(angle_));
            const auto count = static_cast<unsigned>(floor(abs(units)).to_uint64());
            return turns((what == "+") == (sign(units) >= 0), count);
        }
        if (what == "|") {
            if (angle_ % 2 == 0 && !has_number) return "|";
            fail("turns back, and half a turn is no multiple of 360/" + std::to_string(angle_));
        }
        if (what == "[" || what == "]") return what;
        if (what == "*") return scaling(module, fail);
        if (what == "'") return "";  // colours are left out
        if (what.size() == 1 &&
            std::string_view("&^\\/${}.!%~@").find(what[0]) != std::string_view::npos) {
            if (what == "!" && !system_.drawing.narrow && !has_number) return "";
            fail("is the command " + what + " of the notation");
        }
        return "";
    }

    template <class Fail>
    std::string scaling(const TurtleModule& module, Fail fail) const {
        if (module.parameters.empty()) {
            if (system_.drawing.scale) fail("scales by the setting `scale`; expected `*(k)`");
            return "";
        }
        const Quantity& by = module.parameters[0];
        const auto decimal = [](const Rational& value) { return exact_decimal(value); };
        if (by.exact && sign(*by.exact) >= 0) {
            if (const auto text = decimal(*by.exact)) return "@" + *text;
            if (const auto text = decimal(Rational(1) / *by.exact)) return "@i" + *text;
        }
        std::string text = to_text(by.expression);
        const bool inverse = text.starts_with("1/");
        if (inverse) text.erase(0, 2);
        if (text.starts_with("sqrt(") && text.ends_with(")")) {
            text = text.substr(5, text.size() - 6);
            if (!text.empty() && text.find_first_not_of("0123456789.") == std::string::npos)
                return (inverse ? "@iq" : "@q") + text;
        }
        fail("scales by " + to_text(by.expression) + ", which no number of the format says");
        return "";
    }

    void name_letter(Symbol a) {
        const std::string does = commands(a);
        const bool rewritten = std::ranges::any_of(
            system_.rules, [&](const Production& rule) { return rule.predecessor.symbol == a; });
        if (does == "F" && take(a, 'F')) return;
        if (does == "G" && take(a, 'G')) return;
        if (!rewritten && !does.empty() && does.find_first_of("FG") == std::string::npos) {
            names_.emplace(a, does);
            return;
        }
        if (!rewritten && (does == "F" || does == "G" || !does.empty()))
            refuse("the letter " + name(a) + ", which does what another letter does");
        if (!does.empty())
            refuse("the letter " + name(a) + ", which is rewritten and does to the turtle " +
                   quoted(does));
        const std::string& own = name(a);
        if (own.size() == 1 && std::isalnum(static_cast<unsigned char>(own[0])) &&
            take(a, upper(own[0])))
            return;
        for (const char spare : std::string_view("XYZABEHIJKLNOPQRSTUVW#$%&*.,:?_~^'"))
            if (take(a, spare)) return;
        refuse("more letters than a file has characters for");
    }

    /// Names the letter so unless the character is taken, a command, or part of a number.
    bool take(Symbol a, char character) {
        const bool acts = character == 'F' || character == 'G';
        const std::string does = commands(a);
        if (acts != (does == std::string(1, character))) return false;
        if (std::string_view("DMC").find(character) != std::string_view::npos ||
            is_digit(static_cast<unsigned char>(character)))
            return false;
        if (std::string_view("IQ.").find(character) != std::string_view::npos && numbers())
            return false;
        if (!taken_.insert(character).second) return false;
        names_.emplace(a, std::string(1, character));
        return true;
    }

    /// Whether some command has a number, which a letter behind it could go on.
    bool numbers() const {
        return std::ranges::any_of(
            order_, [&](Symbol a) { return commands(a).find('@') != std::string::npos; });
    }

    std::string text(const Word& word) const {
        std::string out;
        for (const Symbol a : word) out += names_.at(a);
        return out;
    }

    unsigned angle_ = 0;  // parts of a full turn
    unsigned unit_ = 1;   // parts that + turns by
    std::vector<Symbol> order_;
    std::map<Symbol, std::string> names_;
    std::set<char> taken_;
};

}  // namespace

Model read_fractint(std::string_view text, const std::string& name) {
    const auto [file, entry] = file_and_entry(name);
    return Reader(text, file).read(file, entry);
}

bool looks_like_fractint(std::string_view text) {
    const std::string_view begin = text.substr(0, 100'000);
    std::vector<Entry> entries;
    try {
        entries = entries_of(begin);
    } catch (const Error&) {
        return false;
    }
    return std::ranges::any_of(entries, [](const Entry& entry) {
        // `system NAME {` is a system within one of the notation.
        return !entry.name.empty() && entry.name != "system" &&
               std::ranges::any_of(entry.lines, [](const Line& line) {
                   std::string word;
                   for (const char c : trimmed(line.text).substr(0, 6)) word += lower(c);
                   return word.starts_with("axiom ") || word.starts_with("angle ");
               });
    });
}

std::string print_fractint(const Model& system) {
    return Writer(with_plain_angle(system)).written();
}

}  // namespace algae
