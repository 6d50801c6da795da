#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/formats.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "exchange/detail/scanner.hpp"
#include "model/model.hpp"

// Morphisms of Walnut and of Sage, and the word automata of Walnut.
//
// A word automaton reads the digits of n, the first one first, and gives the letter at position n of an infinite word. In base K it is a
// K-uniform morphism, state to states by the digits 0 to K-1, followed by the coding of states by their outputs (Cobham 1972). In the
// number systems of Fibonacci and of Tribonacci some digits may not follow each other, so a letter is a state together with what the number
// system remembers, and has an image letter for each digit that may come next: words of digits in their order are numbers in
// theirs. In each case the word begins with the initial state, which the digit 0 must not leave.
//
// What a reader makes is a text of the notation, with blanks between letters, as numbers of several digits are letters too.

namespace algae {

namespace {

constexpr std::size_t most_states = 10'000, most_digits = 1000, most_image = 1'000'000;

/// A line without its comment, and where it begins.
struct Line {
    std::size_t offset = 0;
    std::string_view text;
};

std::vector<Line> lines_of(std::string_view text, std::string_view comment) {
    std::vector<Line> found;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view whole = text.substr(begin, end - begin);
        const std::string_view line = trimmed(whole.substr(0, whole.find(comment)));
        if (!line.empty())
            found.push_back({static_cast<std::size_t>(line.data() - text.data()), line});
        begin = end + 1;
    }
    return found;
}

/// What the two formats share: a text with places.
class Text {
public:
    Text(std::string_view text, const std::string& name) : text_(text), source_(text, name) {
        Findings(source_).throw_if_no_text();
    }

    [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
        throw Diagnostics({source_.finding(offset, message)});
    }
    /// `message` and what stands there.
    [[noreturn]] void expected(std::size_t offset, const std::string& what) const {
        const std::string_view rest = text_.substr(std::min(offset, text_.size()));
        fail(offset,
             "expected " + what + ", found " +
                 (rest.empty() ? "the end of the file" : found(rest.substr(0, rest.find('\n')))));
    }
    std::string_view text() const { return text_; }
    const std::string& file() const { return source_.file(); }

private:
    std::string_view text_;
    Source source_;
};

/// A morphism with the axiom and the coding, letters by their names.
struct Written {
    std::string axiom;  // with blanks
    std::vector<std::pair<std::string, std::vector<std::string>>> rules;
    std::vector<std::pair<std::string, std::string>> coding;
};

Model model_of(const Written& written, const std::string& name, const std::string& title = "") {
    std::string longer, rules, coding;
    for (const auto& [letter, image] : written.rules) {
        if (!is_character(letter)) longer += " " + letter;
        rules += letter + " -> " + spaced_word(image) + "\n";
    }
    for (const auto& [letter, image] : written.coding)
        coding += (coding.empty() ? "" : "; ") + letter + " -> " + image;
    return read_written((title.empty() ? "" : "title " + title + "\n") +
                            (longer.empty() ? "" : "alphabet" + longer + "\n") + "axiom " +
                            written.axiom + "\n" + rules +
                            (coding.empty() ? "" : "coding { " + coding + " }\n"),
                        name);
}

// Walnut.

/// The number systems whose words of digits are known: each digit leads from what is remembered on, or may not come next.
struct NumberSystem {
    std::vector<std::vector<std::optional<std::size_t>>> next;  // by state and digit

    std::size_t digits() const { return next.front().size(); }
};

/// The number system without two (or three) ones in a row.
NumberSystem without_ones(std::size_t most) {
    NumberSystem system;
    for (std::size_t ones = 0; ones < most; ++ones)
        system.next.push_back({0, ones + 1 < most ? std::optional(ones + 1) : std::nullopt});
    return system;
}

class WalnutReader {
public:
    WalnutReader(std::string_view text, const std::string& name) : text_(text, name) {}

    Model read() {
        const std::vector<Line> lines = lines_of(text_.text(), "#");
        if (lines.empty()) text_.expected(0, "a morphism or a word automaton");
        if (looks_like_walnut(text_.text())) return automaton(lines);
        return morphism(lines);
    }

private:
    Model morphism(const std::vector<Line>& lines) {
        Written written;
        std::set<std::string> known;
        for (const Line& line : lines) {
            std::size_t at = 0;
            // The command `morphism NAME "..."` says the same.
            if (line.text.starts_with("morphism")) {
                const std::size_t open = line.text.find('"');
                if (open == std::string::npos)
                    text_.fail(line.offset,
                               "expected the images between quotation marks, such as "
                               "morphism h \"0->01 1->10\"");
                if (line.text.find('"', open + 1) == std::string::npos)
                    text_.fail(line.offset + open, "the quotation mark is never closed");
                at = open + 1;
            }
            const auto skip = [&] {
                while (at < line.text.size() &&
                       std::string_view(" \t,\";:").find(line.text[at]) != std::string_view::npos)
                    ++at;
            };
            for (skip(); at < line.text.size(); skip()) {
                const std::size_t place = line.offset + at;
                const std::string letter = number(line, at, false);
                if (!known.insert(letter).second)
                    text_.fail(place, "the letter " + letter + " has an image already");
                blanks(line, at);
                if (!line.text.substr(at).starts_with("->"))
                    text_.expected(line.offset + at, "'->' behind the letter " + letter);
                at += 2;
                blanks(line, at);
                std::vector<std::string> image;
                while (
                    at < line.text.size() &&
                    (is_digit(static_cast<unsigned char>(line.text[at])) || line.text[at] == '[')) {
                    image.push_back(number(line, at, true));
                    if (image.size() > most_image)
                        text_.fail(place, "an image of more than a million letters");
                }
                written.rules.emplace_back(letter, std::move(image));
            }
        }
        if (written.rules.empty())
            text_.expected(lines.front().offset, "a letter and its image, such as 0 -> 01");
        written.axiom = written.rules.front().first;
        add_missing(written);
        return model_of(written, text_.file());
    }

    /// Letters of images without an image of their own stay, and are letters.
    static void add_missing(Written& written) {
        std::set<std::string> known;
        for (const auto& [letter, image] : written.rules) known.insert(letter);
        std::vector<std::string> missing;
        for (const auto& [letter, image] : written.rules)
            for (const std::string& other : image)
                if (known.insert(other).second) missing.push_back(other);
        for (const std::string& letter : missing) written.rules.push_back({letter, {letter}});
    }

    static void blanks(const Line& line, std::size_t& at) {
        while (at < line.text.size() && (line.text[at] == ' ' || line.text[at] == '\t')) ++at;
    }

    /// A letter: before an arrow a number, in an image a digit or a number in brackets.
    std::string number(const Line& line, std::size_t& at, bool in_image) const {
        const std::size_t place = line.offset + at;
        const bool bracket = at < line.text.size() && line.text[at] == '[';
        std::size_t here = at + (bracket ? 1 : 0);
        std::string sign;
        if (bracket && here < line.text.size() && line.text[here] == '-') sign = line.text[here++];
        std::size_t end = here;
        while (end < line.text.size() && is_digit(static_cast<unsigned char>(line.text[end])) &&
               (bracket || !in_image || end == here))
            ++end;
        if (end == here) text_.expected(line.offset + here, "a number as a letter");
        if (end - here > 9) text_.fail(place, "expected a number of at most 9 digits");
        const std::string digits(line.text.substr(here, end - here));
        const std::size_t zeros = std::min(digits.find_first_not_of('0'), digits.size() - 1);
        if (bracket && (end == line.text.size() || line.text[end] != ']'))
            text_.expected(line.offset + end, "']' behind the number");
        at = end + (bracket ? 1 : 0);
        return (digits.substr(zeros) == "0" ? "" : sign) + digits.substr(zeros);
    }

    // Automata.

    struct State {
        std::string output;
        std::map<std::size_t, std::size_t> next;  // by digit
        std::size_t place = 0;
    };

    NumberSystem number_system(const Line& line) const {
        std::string name(line.text);
        const auto refuse = [&](const std::string& why) {
            text_.fail(line.offset, "the number system " + quoted(name) + " " + why);
        };
        if (name.find_first_of(" \t{") != std::string::npos)
            text_.fail(
                line.offset,
                "expected one number system, as of an automaton that reads one number, found " +
                    quoted(name));
        if (name.starts_with("lsd"))
            refuse(
                "has the last digit first; a morphism is that of an automaton which reads the "
                "first digit first, and Walnut's `reverse` makes one");
        if (name == "msd") name = "msd_2";
        if (!name.starts_with("msd")) name = "msd_" + name;
        const std::string base =
            name.substr(name.find_first_not_of("msd_") == std::string::npos ? name.size() : 4);
        if (base == "fib") return without_ones(2);
        if (base == "trib") return without_ones(3);
        if (base.empty() || base.size() > 4 ||
            !std::ranges::all_of(base, [](char c) { return c >= '0' && c <= '9'; }))
            refuse("is not known here; expected msd_K for a number K, msd_fib or msd_trib");
        const std::size_t digits = std::stoul(base);
        if (digits < 2 || digits > most_digits) refuse("has no base from 2 to 1000");
        return {{std::vector<std::optional<std::size_t>>(digits, 0)}};
    }

    Model automaton(const std::vector<Line>& lines) {
        const NumberSystem numbers = number_system(lines.front());
        std::vector<std::size_t> order;
        std::map<std::size_t, State> states;
        for (std::size_t i = 1; i < lines.size(); ++i) {
            const Line& line = lines[i];
            if (line.text.find("->") == std::string_view::npos) {
                const auto [state, output] = declaration(line);
                if (!states.emplace(state, State{output, {}, line.offset}).second)
                    text_.fail(line.offset, fmt::format("the state {} is given twice", state));
                order.push_back(state);
                if (order.size() > most_states) text_.fail(line.offset, "more than 10000 states");
            } else {
                if (order.empty())
                    text_.expected(line.offset, "a state and its output, such as 0 0");
                transition(line, order.back(), states.at(order.back()), numbers.digits());
            }
        }
        if (order.empty())
            text_.expected(text_.text().size(), "a state and its output, such as 0 0");
        for (const auto& [state, all] : states)
            for (const auto& [digit, to] : all.next)
                if (!states.contains(to))
                    text_.fail(all.place,
                               fmt::format("the state {} goes to the state {}, which is not given",
                                           state, to));
        return model_of(morphism_of(order.front(), states, numbers), text_.file(), title());
    }

    /// A comment above the automaton.
    std::string title() const {
        const std::string_view first = text_.text().substr(0, text_.text().find('\n'));
        if (!first.starts_with('#')) return {};
        std::string title(trimmed(first.substr(1)));
        while (title.ends_with('.')) title.pop_back();
        return title.find(';') == std::string::npos && title.find(" #") == std::string::npos ? title
                                                                                             : "";
    }

    std::pair<std::size_t, std::string> declaration(const Line& line) const {
        const auto parts = blank_separated(line.text);
        const auto is_number = [](std::string_view text, bool sign) {
            if (sign && (text.starts_with('-') || text.starts_with('+'))) text.remove_prefix(1);
            return !text.empty() && text.size() <= 9 &&
                   std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
        };
        if (parts.size() != 2 || !is_number(parts[0], false) || !is_number(parts[1], true))
            text_.fail(line.offset,
                       "expected a state and its output, such as 0 1, or a transition, such as 1 "
                       "-> 0, found " +
                           quoted(line.text.substr(0, 60)));
        return {std::stoul(std::string(parts[0])),
                std::to_string(std::stol(std::string(parts[1])))};
    }

    void transition(const Line& line, std::size_t state, State& from, std::size_t digits) const {
        const std::size_t arrow = line.text.find("->");
        const auto left = blank_separated(line.text.substr(0, arrow)),
                   right = blank_separated(line.text.substr(arrow + 2));
        const auto value = [&](std::string_view text, const char* what) {
            if (text.empty() || text.size() > 9 ||
                !std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; }))
                text_.fail(static_cast<std::size_t>(text.data() - text_.text().data()),
                           std::string("expected ") + what + ", found " + quoted(text));
            return std::stoul(std::string(text));
        };
        if (left.size() != 1)
            text_.fail(
                line.offset,
                "expected one digit before the arrow, as of an automaton that reads one number");
        if (right.size() != 1)
            text_.fail(line.offset, right.empty() ? "expected a state behind the arrow, found none"
                                                  : "expected one state behind the arrow, as of a "
                                                    "deterministic automaton, found " +
                                                        std::to_string(right.size()));
        const std::size_t to = value(right[0], "a state");
        const auto add = [&](std::size_t digit) {
            if (!from.next.emplace(digit, to).second)
                text_.fail(line.offset, fmt::format("the state {} has a transition for {} already",
                                                    state, digit));
        };
        if (left[0] == "*")
            for (std::size_t digit = 0; digit < digits; ++digit) add(digit);
        else if (const std::size_t digit = value(left[0], "a digit"); digit < digits)
            add(digit);
        else
            text_.fail(line.offset,
                       fmt::format("expected a digit from 0 to {}, found {}", digits - 1, digit));
    }

    Written morphism_of(std::size_t first, const std::map<std::size_t, State>& states,
                        const NumberSystem& numbers) const {
        using Pair =
            std::pair<std::size_t, std::size_t>;  // a state and what the number system remembers
        std::vector<Pair> found{{first, 0}};
        std::map<Pair, std::size_t> known{{found.front(), 0}};
        std::vector<std::vector<std::size_t>> images;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto [state, memory] = found[i];
            images.emplace_back();
            for (std::size_t digit = 0; digit < numbers.digits(); ++digit) {
                const auto after = numbers.next[memory][digit];
                if (!after) continue;  // no number has this digit here
                const State& from = states.at(state);
                const auto to = from.next.find(digit);
                if (to == from.next.end())
                    text_.fail(from.place,
                               fmt::format("the state {} has no transition for the digit {}", state,
                                           digit));
                const Pair next{to->second, *after};
                const auto [at, is_new] = known.emplace(next, found.size());
                if (is_new) found.push_back(next);
                if (found.size() > most_states)
                    text_.fail(from.place,
                               "more than 10000 states with what the number system remembers");
                images.back().push_back(at->second);
            }
        }
        if (images.front().front() != 0)
            text_.fail(states.at(first).place,
                       fmt::format("the first state {} must go to itself by the digit 0: no word "
                                   "begins with it otherwise",
                                   first));
        std::set<std::size_t> single;
        bool ambiguous = false;
        for (const auto& [state, memory] : found)
            ambiguous = !single.insert(state).second || ambiguous;
        const auto name = [&](std::size_t i) {
            return std::to_string(ambiguous ? i : found[i].first);
        };
        Written written;
        written.axiom = name(0);
        bool coded = false;
        for (std::size_t i = 0; i < found.size(); ++i) {
            std::vector<std::string> image;
            for (const std::size_t j : images[i]) image.push_back(name(j));
            written.rules.emplace_back(name(i), std::move(image));
            written.coding.emplace_back(name(i), states.at(found[i].first).output);
            coded = coded || written.coding.back().first != written.coding.back().second;
        }
        if (!coded) written.coding.clear();
        return written;
    }

    Text text_;
};

bool is_natural(std::string_view name) {
    return !name.empty() && name.size() <= 9 && (name == "0" || name[0] != '0') &&
           std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
}

/// What both writers need: a D0L system by letters, each with its image.
class MorphismWriter : FormatWriter {
public:
    MorphismWriter(const Model& system, const char* format) : FormatWriter(system, format) {
        check_plain_rules(false);
        if (!system_.ignored.empty()) refuse("symbols that contexts skip");
        for (const Symbol a : system_.axiom.letters) meet(a);
        for (std::size_t i = 0; i < letters_.size(); ++i) {
            const auto rule = std::ranges::find_if(system_.rules, [&](const Production& one) {
                return one.predecessor.symbol == letters_[i];
            });
            images_[letters_[i]] =
                rule == system_.rules.end() ? Word{letters_[i]} : rule->successor.letters;
            for (const Symbol a : images_[letters_[i]]) meet(a);
        }
    }

    std::string walnut() {
        if (system_.axiom.letters.size() != 1)
            refuse("an axiom of " + counted(system_.axiom.letters.size(), "letter"));
        std::map<Symbol, std::string> outputs;
        const bool integers =
            std::ranges::all_of(letters_, [&](Symbol a) { return is_integer(image_name(a)); });
        std::map<std::string, std::string> numbers;
        std::string comments = system_.title.empty() ? "" : "# " + system_.title + "\n";
        for (const Symbol a : letters_) {
            const std::string& shown = image_name(a);
            const auto [at, is_new] =
                numbers.emplace(shown, integers ? shown : std::to_string(numbers.size()));
            if (is_new && !integers) comments += "# " + at->second + " is " + shown + "\n";
            outputs[a] = at->second;
        }
        const std::size_t size = images_.at(letters_.front()).size();
        const bool uniform =
            size >= 2 && size <= most_digits &&
            images_.at(letters_.front()).front() == letters_.front() &&
            std::ranges::all_of(letters_, [&](Symbol a) { return images_.at(a).size() == size; });
        std::map<Symbol, std::size_t> state;
        for (const Symbol a : letters_) state.emplace(a, state.size());
        std::string out = comments;
        if (uniform) {
            out += fmt::format("msd_{}\n", size);
            for (const Symbol a : letters_) {
                out += fmt::format("\n{} {}\n", state.at(a), outputs.at(a));
                for (std::size_t digit = 0; digit < size; ++digit)
                    out += fmt::format("{} -> {}\n", digit, state.at(images_.at(a)[digit]));
            }
            return out;
        }
        if (!system_.coding.empty()) refuse("a coding of a morphism that is not uniform");
        if (integers &&
            !std::ranges::all_of(letters_, [&](Symbol a) { return is_natural(outputs.at(a)); }))
            refuse("letters below 0");
        for (const Symbol a : letters_) {
            out += outputs.at(a) + " -> ";
            for (const Symbol b : images_.at(a))
                out += outputs.at(b).size() == 1 ? outputs.at(b) : "[" + outputs.at(b) + "]";
            out += "\n";
        }
        return out;
    }

    std::string sage() const {
        std::string morphism, coding;
        for (const Symbol a : letters_) {
            morphism += (morphism.empty() ? "" : ",") + character(name(a)) + "->";
            for (const Symbol b : images_.at(a)) morphism += character(name(b));
            coding +=
                (coding.empty() ? "" : ",") + character(name(a)) + "->" + character(image_name(a));
        }
        std::string axiom;
        for (const Symbol a : system_.axiom.letters) axiom += character(name(a));
        if (axiom.empty()) refuse("an empty axiom, for which Sage has its first letter");
        const std::uint64_t n =
            system_.drawing.generations ? system_.drawing.generations->second : 5;
        std::string out = system_.title.empty() ? "" : "# " + system_.title + "\n";
        out += "m = WordMorphism('" + morphism + "')\n";
        if (!system_.coding.empty()) out += "c = WordMorphism('" + coding + "')\n";
        const std::string call = fmt::format("m('{}', {})", axiom, n);
        return out + (system_.coding.empty() ? call : "c(" + call + ")") + "\n";
    }

private:
    static bool is_integer(std::string_view text) {
        return is_natural(text.starts_with('-') && text != "-0" ? text.substr(1) : text);
    }
    const std::string& image_name(Symbol a) const {
        for (const auto& [letter, image] : system_.coding.images)
            if (letter == a) return image;
        return name(a);
    }
    std::string character(const std::string& letter) const {
        if (!is_character(letter) || letter == "," || letter == "'" || letter == "\\")
            refuse("the letter " + letter +
                   ": its letters are single characters, and none of , ' and \\");
        return letter;
    }
    void meet(Symbol a) {
        if (std::ranges::count(letters_, a) == 0) letters_.push_back(a);
    }

    std::vector<Symbol> letters_;
    std::map<Symbol, Word> images_;
};

// Sage.

/// The text with blanks instead of comments, from `#` to the end of a line, outside quotation marks.
std::string without_python_comments(std::string_view text) {
    std::string out(text);
    char mark = 0;
    bool is_comment = false;
    for (char& c : out) {
        if (c == '\n') {
            mark = 0;
            is_comment = false;
        } else if (is_comment || (c == '#' && mark == 0)) {
            is_comment = true;
            c = ' ';
        } else if (mark == 0 && (c == '\'' || c == '"')) {
            mark = c;
        } else if (c == mark) {
            mark = 0;
        }
    }
    return out;
}

class SageReader {
public:
    SageReader(std::string_view text, const std::string& name)
        : text_(text, name), said_(without_python_comments(text)) {}

    Model read() {
        const std::string_view text = said_;
        check_operations();
        Written written;
        std::size_t end = 0;
        const auto first = quoted_morphism(0, end);
        written.rules = morphism(first);
        std::size_t after = end;
        if (text.find("WordMorphism", end) != std::string_view::npos) {
            const std::string_view second = quoted_morphism(end, after);
            for (const auto& [letter, image] : morphism(second)) {
                if (image.size() != 1)
                    text_.fail(
                        offset(second),
                        "expected a coding, each image one letter: it follows the first morphism");
                written.coding.emplace_back(letter, image.front());
            }
        }
        std::set<std::string> known;
        for (const auto& [letter, image] : written.rules) known.insert(letter);
        std::size_t at = offset(first);
        for (const auto& [letter, image] : written.rules)
            for (const std::string& other : image)
                if (!known.contains(other))
                    text_.fail(at, "the letter " + quoted(other) +
                                       " has no image, so the morphism cannot be iterated; " +
                                       quoted(other + "->" + other) + " keeps it");
        written.axiom = axiom(after, known);
        if (written.axiom.empty()) written.axiom = written.rules.front().first;
        // Brackets that stay need no rule in the notation, which has none for them.
        std::erase_if(written.rules, [](const auto& rule) {
            return (rule.first == "[" || rule.first == "]") &&
                   rule.second == std::vector<std::string>{rule.first};
        });
        return model_of(written, text_.file());
    }

private:
    std::size_t offset(std::string_view part) const {
        return static_cast<std::size_t>(part.data() - said_.data());
    }

    /// Refuses what makes another morphism than the one that stands there.
    void check_operations() const {
        const std::string_view text = said_;
        for (std::size_t i = 0; (i = text.find_first_of("'\"^*.", i)) < text.size(); ++i) {
            const char c = text[i];
            if (c == '\'' || c == '"') {  // what is quoted goes to the mark or the end of the line
                i = std::min(text.find_first_of(std::string{c, '\n'}, i + 1), text.size());
            } else if (c == '.') {
                static constexpr std::string_view other[] = {
                    "reversal", "conjugate",          "restrict_domain", "extend_by",
                    "dual_map", "list_of_conjugates", "inverse"};
                for (const std::string_view method : other)
                    if (text.substr(i + 1).starts_with(method))
                        refuse_other(
                            i, "." + std::string(method) + " makes another morphism, which is");
            } else if (const std::size_t line = text.rfind('\n', i) + 1;
                       c == '^' || !trimmed(text.substr(line, i - line)).ends_with("import")) {
                refuse_other(i, "powers and products make other morphisms, which are");
            }
        }
    }
    [[noreturn]] void refuse_other(std::size_t offset, const std::string& what) const {
        text_.fail(offset, what +
                               " not computed here; expected WordMorphism('a->ab,b->a') and a call "
                               "such as m('a', 5)");
    }

    /// What stands between the quotation marks of the next WordMorphism(...); the whole text where the word is missing.
    std::string_view quoted_morphism(std::size_t from, std::size_t& end) const {
        const std::string_view text = said_;
        constexpr std::string_view word = "WordMorphism";
        const std::size_t at = text.find(word, from);
        if (at == std::string_view::npos) {
            const std::string_view whole = trimmed(text);
            end = text.size();
            if (whole.find("->") == std::string_view::npos)
                text_.expected(0, "WordMorphism('a->ab,b->a')");
            return whole;
        }
        std::size_t open = at + word.size();
        while (open < text.size() &&
               (text[open] == '(' || is_blank(static_cast<unsigned char>(text[open]))))
            ++open;
        if (open == text.size() || (text[open] != '\'' && text[open] != '"'))
            text_.expected(
                open, "a morphism between quotation marks, such as WordMorphism('a->ab,b->a')");
        const std::size_t close = text.find(text[open], open + 1);
        if (close == std::string_view::npos ||
            text.substr(open, close - open).find('\n') != std::string_view::npos)
            text_.fail(open, "the quotation mark is never closed");
        end = close + 1;
        return text.substr(open + 1, close - open - 1);
    }

    /// Images between commas: a character, `->` and characters, blanks among them.
    std::vector<std::pair<std::string, std::vector<std::string>>> morphism(
        std::string_view text) const {
        std::vector<std::pair<std::string, std::vector<std::string>>> rules;
        std::set<std::string> known;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find(',', begin), text.size());
            const std::string_view image = text.substr(begin, end - begin);
            const std::size_t at = offset(image);
            const std::size_t size = image.empty() ? 0 : first_character(image).bytes;
            if (image.empty())
                text_.fail(at, "expected a letter and its image between commas, found none");
            if (!image.substr(size).starts_with("->"))
                text_.fail(
                    at,
                    "expected '->' behind the first character, as in a->ab without blanks, found " +
                        quoted(image));
            const std::string letter = checked(image.substr(0, size));
            if (!known.insert(letter).second)
                text_.fail(at, "the letter " + quoted(letter) + " is defined twice");
            std::vector<std::string> letters;
            for (const std::string_view one : characters(image.substr(size + 2)))
                letters.push_back(checked(one));
            rules.emplace_back(letter, std::move(letters));
            begin = end + 1;
        }
        if (rules.empty()) text_.expected(offset(text), "a letter and its image, such as a->ab");
        return rules;
    }

    std::string checked(std::string_view letter) const {
        if (is_blank(static_cast<unsigned char>(letter[0])))
            text_.fail(offset(letter),
                       "a blank is a letter in an image, which the notation cannot say; expected "
                       "letters without blanks");
        if (std::string_view("()<>:;?#=").find(letter) != std::string_view::npos)
            text_.fail(offset(letter), quoted(letter) + " is no letter of the notation");
        return std::string(letter);
    }

    /// The word of a call m('...', n) or of m.fixed_point('a'); empty where there is none.
    std::string axiom(std::size_t from, const std::set<std::string>& known) const {
        const std::string_view text = said_;
        for (std::size_t at = text.find('(', from); at != std::string_view::npos;
             at = text.find('(', at + 1)) {
            if (at + 1 >= text.size() || (text[at + 1] != '\'' && text[at + 1] != '"')) continue;
            const std::size_t close = text.find(text[at + 1], at + 2);
            if (close == std::string_view::npos)
                text_.fail(at + 1, "the quotation mark is never closed");
            std::vector<std::string> word;
            for (const std::string_view one : characters(text.substr(at + 2, close - at - 2))) {
                if (!known.contains(std::string(one)))
                    text_.fail(offset(one), "the letter " + quoted(one) + " has no image");
                word.emplace_back(one);
            }
            return spaced_word(word);
        }
        return {};
    }

    Text text_;
    std::string said_;  // without comments
};

}  // namespace

Model read_walnut(std::string_view text, const std::string& name) {
    return WalnutReader(text, name).read();
}

std::string print_walnut(const Model& system) { return MorphismWriter(system, "walnut").walnut(); }

bool looks_like_walnut(std::string_view text) {
    for (const Line& line : lines_of(text.substr(0, 10'000), "#"))
        return line.text.starts_with("msd") || line.text.starts_with("lsd") ||
               (line.text.starts_with('{') &&
                line.text.find_first_not_of("{}0123456789-, \t") >= line.text.find('}')) ||
               std::ranges::all_of(line.text, [](char c) { return c >= '0' && c <= '9'; });
    return false;
}

Model read_sage(std::string_view text, const std::string& name) {
    return SageReader(text, name).read();
}

std::string print_sage(const Model& system) { return MorphismWriter(system, "sage").sage(); }

}  // namespace algae
