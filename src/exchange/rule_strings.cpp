#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "exchange/detail/formats.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "exchange/detail/scanner.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"

// Systems as drawing programs have them in the fields of a form: Inkscape's extension, and the library of TikZ.
//
//     axiom = F                      \pgfdeclarelindenmayersystem{koch}{\rule{F -> F-F++F-F}}
//     rules = F=F+F--F+F             \draw l-system [l-system={koch, axiom=F++F++F, order=3, angle=60}];
//     order = 3
//     langle = 60
//     rangle = 60
//
// Inkscape writes everything in capitals, draws with A to F, moves with G to L, and looks up the page. Its angles are those of a page whose y
// axis points down: what its form calls left turns to the right. A piece of the rules without exactly one `=` is dropped there, and a left side of several
// characters never matches; both are refused here, as nobody means them. TikZ looks along x, draws with F, moves with f, turns to the left
// by +; `\symbol{X}{...}` lets other symbols do the same. Both know only words of single characters and two turns, each with its angle; what is
// random there is refused.

namespace algae {

namespace {

constexpr const char* inkscape_draws = "ABCDEF";
constexpr const char* inkscape_moves = "GHIJKL";
constexpr const char* inkscape_free = "MNOPQRSTUVWXYZ";

class Text {
public:
    Text(std::string_view text, const std::string& name) : Text(text, name, std::string(text)) {}
    /// A text of which `said` is to be read, of the same length.
    Text(std::string_view text, const std::string& name, std::string said)
        : text_(std::move(said)), source_(text, name) {}
    const std::string& text() const { return text_; }
    const Source& source() const { return source_; }
    [[noreturn]] void fail(std::size_t place, const std::string& message) const {
        throw Diagnostics({source_.finding(std::min(place, text_.size()), message)});
    }
    /// A number, exactly.
    std::string number(const std::string& text, std::size_t place, const char* what) const {
        const bool negative = text.starts_with('-');
        const std::string_view digits = std::string_view(text).substr(negative ? 1 : 0);
        if (digits.empty() || number_size(digits) != digits.size())
            fail(place, std::string("expected a number as ") + what + ", found " + quoted(text));
        std::string plain = plain_number(digits);
        if (plain.starts_with('.')) plain = "0" + plain;
        return (negative ? "-" : "") + plain;
    }

private:
    std::string text_;
    Source source_;
};

/// A symbol of the notation for a character of these programs.
std::string symbol_of(const Text& text, char c, std::size_t place) {
    const std::string name(1, c);
    if (static_cast<unsigned char>(c) >= 0x80 || c <= ' ')
        text.fail(place, "expected symbols of ASCII without blanks");
    if (std::string_view("()<>:,;?#=").find(c) == std::string_view::npos) return name;
    return "X_" + std::to_string(static_cast<int>(c));
}

struct Strings {
    std::string axiom;
    std::vector<std::pair<std::string, std::string>> rules;  // words of the notation
    std::vector<std::string> interpretations;                // lines
    std::string angle, step, order, start;
    bool clockwise = false;
};

Model model_of(const Strings& strings, const std::string& name) {
    std::string text = "axiom " + strings.axiom + "\n";
    for (const auto& [left, right] : strings.rules) text += left + " -> " + right + "\n";
    for (const std::string& line : strings.interpretations) text += "interpret " + line + "\n";
    text += "angle " + strings.angle + "\n";
    if (!strings.step.empty()) text += "step " + strings.step + "\n";
    if (!strings.start.empty()) text += "start " + strings.start + "\n";
    if (strings.clockwise) text += "turn clockwise\n";
    if (!strings.order.empty()) text += "generation " + strings.order + "\n";
    return read_written(text, name);
}

/// The word, with the brackets that must match; the characters that occur are added.
std::string word_of(const Text& text, const std::string& word, std::size_t place,
                    std::set<char>& met, bool capitals) {
    std::vector<std::string> names;
    int open = 0;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const char c = capitals
                           ? static_cast<char>(std::toupper(static_cast<unsigned char>(word[i])))
                           : word[i];
        if (c == ' ' || c == '\t') continue;
        if (c == '[') ++open;
        if (c == ']' && --open < 0) text.fail(place + i, "unmatched ']'");
        met.insert(c);
        names.push_back(symbol_of(text, c, place + i));
    }
    if (open > 0) text.fail(place, "unmatched '['");
    return names.empty() ? "ε" : spaced_word(names);
}

std::string trimmed_text(std::string text) {
    text.erase(0, std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    text.erase(text.find_last_not_of(" \t\r\n") + 1);
    return text;
}

}  // namespace

Model read_inkscape(std::string_view whole, const std::string& name) {
    const Text text(whole, name);
    std::map<std::string, std::pair<std::string, std::size_t>> fields;
    for (std::size_t begin = 0; begin < text.text().size();) {
        const std::size_t end = std::min(text.text().find('\n', begin), text.text().size());
        std::string line = text.text().substr(begin, end - begin);
        line = line.substr(0, std::min(line.find(" #"), line.find("\t#")));
        const std::string said = trimmed_text(line);
        if (!said.empty() && !said.starts_with('#')) {
            const std::size_t equals = line.find('=');
            const std::string field = trimmed_text(line.substr(0, equals));
            static const std::set<std::string> known{"axiom",         "rules",         "order",
                                                     "step",          "langle",        "rangle",
                                                     "randomizestep", "randomizeangle"};
            if (equals == std::string::npos || !known.contains(field))
                text.fail(begin, "expected a line such as `axiom = F`, for " + joined(known, ", ") +
                                     "; found " + quoted(said.substr(0, 40)) +
                                     did_you_mean(field, {known.begin(), known.end()}));
            if (!fields.emplace(field, std::pair(line.substr(equals + 1), begin + equals + 1))
                     .second)
                text.fail(begin, "a second line for " + quoted(field));
        }
        begin = end + 1;
    }
    const auto number = [&](const char* field, const char* usual) {
        const auto found = fields.find(field);
        if (found == fields.end()) return std::string(usual);
        return text.number(trimmed_text(found->second.first), found->second.second, field);
    };
    for (const char* random : {"randomizestep", "randomizeangle"})
        if (number(random, "0") != "0")
            text.fail(fields.at(random).second, std::string(random) +
                                                    " changes each step at random, "
                                                    "which has no meaning here");
    if (!fields.contains("axiom")) text.fail(0, "expected a line `axiom = F`, found none");
    Strings strings;
    std::set<char> met;
    strings.axiom = word_of(text, fields["axiom"].first, fields["axiom"].second, met, true);
    if (fields.contains("rules")) {
        const auto& [rules, place] = fields["rules"];
        for (std::size_t begin = 0; begin < rules.size();) {
            const std::size_t end = std::min(rules.find(';', begin), rules.size());
            const std::string piece = rules.substr(begin, end - begin);
            const std::size_t at = place + begin;
            begin = end + 1;
            if (trimmed_text(piece).empty()) continue;
            const std::size_t equals = piece.find('=');
            if (std::ranges::count(piece, '=') != 1)
                text.fail(at, "expected a rule with one '=', such as F=F+F; Inkscape drops " +
                                  quoted(trimmed_text(piece)));
            std::string left = trimmed_text(piece.substr(0, equals));
            if (left.size() != 1)
                text.fail(at, "expected a rule for one character; one for " + quoted(left) +
                                  " is never used");
            left[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(left[0])));
            met.insert(left[0]);
            const std::string symbol = symbol_of(text, left[0], at);
            // The last rule for a symbol wins.
            std::erase_if(strings.rules, [&](const auto& rule) { return rule.first == symbol; });
            strings.rules.emplace_back(
                symbol, word_of(text, piece.substr(equals + 1), at + equals + 1, met, true));
        }
    }
    const std::string left = number("langle", "16"), right = number("rangle", "16");
    strings.angle = left;
    strings.order = number("order", "3");
    if (strings.order.find_first_not_of("0123456789") != std::string::npos)
        text.fail(fields["order"].second, "expected a whole number as order");
    strings.start = "0 0 90";
    strings.clockwise = true;
    for (const char c : met) {
        const std::string symbol = symbol_of(text, c, 0);
        if (c != 'F' && std::string_view(inkscape_draws).find(c) != std::string_view::npos)
            strings.interpretations.push_back(symbol + " -> F");
        else if (std::string_view(inkscape_moves).find(c) != std::string_view::npos)
            strings.interpretations.push_back(symbol + " -> f");
        else if (c == '-' && right != left)
            strings.interpretations.push_back("- -> -(" + right + ")");
        else if (std::string_view("F+-|[]").find(c) == std::string_view::npos &&
                 !std::isupper(static_cast<unsigned char>(c)) &&
                 std::string_view("&^\\/$!'.{}%*@~").find(c) != std::string_view::npos)
            strings.interpretations.push_back(symbol + " -> ε");  // nothing there
    }
    return model_of(strings, name);
}

// --- TikZ ---

namespace {

/// The text with blanks instead of comments, from `%` to the end of a line.
std::string without_tex_comments(std::string_view text) {
    std::string out(text);
    bool is_comment = false;
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (out[i] == '\n') is_comment = false;
        if (out[i] == '%' && (i == 0 || out[i - 1] != '\\')) is_comment = true;
        if (is_comment) out[i] = ' ';
    }
    return out;
}

class TikzReader {
public:
    TikzReader(std::string_view whole, const std::string& name)
        : text_(whole, name, without_tex_comments(whole)), name_(name) {}

    Model read() {
        const std::string& text = text_.text();
        find_declarations();
        // The options first: `\symbol` may stand before them.
        for (const char* key : {"l-system={", "lindenmayer system={"})
            for (std::size_t at = text.find(key); at != std::string::npos;
                 at = text.find(key, at + 1))
                options(at + std::string(key).size());
        choose_declaration();
        for (std::size_t at = text.find("\\rule{"); at != std::string::npos;
             at = text.find("\\rule{", at + 1)) {
            if (is_of_another(at)) continue;
            const std::size_t from = at + 6;
            rule(text.substr(from, end_of(from) - from), from);
        }
        for (std::size_t at = text.find("\\symbol{"); at != std::string::npos;
             at = text.find("\\symbol{", at + 1))
            if (!is_of_another(at)) symbol(at + 8);
        if (strings_.rules.empty() && axiom_.empty())
            text_.fail(
                0,
                "expected \\pgfdeclarelindenmayersystem{NAME}{\\rule{F -> F-F}} or l-system={rule "
                "set={F -> F-F}, axiom=F}, found neither");
        strings_.axiom = axiom_.empty() ? strings_.rules.front().first
                                        : word_of(text_, axiom_, axiom_place_, met_, false);
        strings_.angle = left_;
        interpret();
        for (const char c : met_)
            if (!images_.contains(c) &&
                std::string_view("|&^\\/$!'.{}%*@~G").find(c) != std::string_view::npos)
                strings_.interpretations.push_back(symbol_of(text_, c, 0) + " -> ε");
        return model_of(strings_, name_);
    }

private:
    /// `\pgfdeclarelindenmayersystem{NAME}{...}`: its name, and from where to where it stands.
    struct Declaration {
        std::string name;
        std::size_t begin = 0, end = 0;
    };

    void find_declarations() {
        const std::string& text = text_.text();
        const std::string command = "\\pgfdeclarelindenmayersystem{";
        for (std::size_t at = text.find(command); at != std::string::npos;
             at = text.find(command, at + 1)) {
            const std::size_t from = at + command.size(), to = end_of(from);
            const std::size_t open = text.find_first_not_of(" \t\r\n%", to + 1);
            if (open == std::string::npos || text[open] != '{')
                text_.fail(at, "expected {...} with the rules behind the name of a system");
            declared_.push_back({trimmed_text(text.substr(from, to - from)), at, end_of(open + 1)});
        }
    }

    /// Of several declarations the options name one.
    void choose_declaration() {
        std::vector<std::string> names;
        for (const Declaration& one : declared_) names.push_back(one.name);
        const auto found = std::ranges::find(names, chosen_);
        if (found != names.end()) {
            if (const auto again = std::find(found + 1, names.end(), chosen_); again != names.end())
                text_.fail(declared_[static_cast<std::size_t>(again - names.begin())].begin,
                           "a second system of the name " + quoted(chosen_));
            used_ = &declared_[static_cast<std::size_t>(found - names.begin())];
        } else if (!chosen_.empty() && !names.empty()) {
            text_.fail(chosen_place_, "no system " + quoted(chosen_) + " is declared" +
                                          did_you_mean(chosen_, names) + "; declared are " +
                                          joined(names, ", "));
        } else if (names.size() > 1) {
            text_.fail(declared_[1].begin, "a second system: say which of " + joined(names, ", ") +
                                               " is drawn, l-system={" + names[0] +
                                               ", axiom=..., order=...}");
        }
    }

    /// Whether a place stands in a declaration that is not the one drawn.
    bool is_of_another(std::size_t at) const {
        return used_ && std::ranges::any_of(declared_, [&](const Declaration& one) {
                   return &one != used_ && one.begin <= at && at < one.end;
               });
    }

    /// Interpretations of symbols that do something else than their names say. Turns that stand for each other are `turn clockwise`.
    void interpret() {
        const auto image = [&](char c) {
            const auto said = images_.find(c);
            return said == images_.end() ? std::string(1, c) : said->second;
        };
        const bool swapped = (image('+') == "-" && (image('-') == "+" || !met_.contains('-'))) ||
                             (image('-') == "+" && (image('+') == "-" || !met_.contains('+')));
        if (swapped) {
            if (left_ != right_)
                text_.fail(0, "turns that stand for each other, with different angles");
            strings_.clockwise = true;
            images_.erase('+');
            images_.erase('-');
        }
        for (auto& [symbol, what] : images_) {
            const bool turns = what.find_first_of("+-") != std::string::npos;
            if ((symbol == '+' || symbol == '-') && turns && what != std::string(1, symbol))
                text_.fail(0, "\\symbol makes " + quoted(std::string(1, symbol)) +
                                  " turn otherwise, which has no meaning here");
            if (what == std::string(1, symbol)) continue;
            std::string written;
            for (const char c : what) {
                const char said = !swapped ? c : c == '+' ? '-' : c == '-' ? '+' : c;
                written += said;
                if (c == '-' && right_ != left_) written += "(" + right_ + ")";
            }
            strings_.interpretations.push_back(symbol_of(text_, symbol, 0) + " -> " +
                                               (written.empty() ? "ε" : written));
        }
        if (right_ != left_ && met_.contains('-') && !images_.contains('-'))
            strings_.interpretations.push_back("- -> -(" + right_ + ")");
    }

    /// Where the brace closes that was opened before this place.
    std::size_t end_of(std::size_t from) const {
        int open = 1;
        for (std::size_t i = from; i < text_.text().size(); ++i) {
            if (text_.text()[i] == '{') ++open;
            if (text_.text()[i] == '}' && --open == 0) return i;
        }
        text_.fail(from - 1, "unmatched '{'");
    }

    void rule(const std::string& said, std::size_t place) {
        const std::size_t arrow = said.find("->");
        if (arrow == std::string::npos)
            text_.fail(place, "expected a rule with '->', found " + quoted(trimmed_text(said)));
        const std::string left = trimmed_text(said.substr(0, arrow));
        if (left.size() != 1)
            text_.fail(place, "expected one character before '->', found " + quoted(left));
        met_.insert(left[0]);
        const std::string symbol = symbol_of(text_, left[0], place);
        std::erase_if(strings_.rules, [&](const auto& rule) { return rule.first == symbol; });
        strings_.rules.emplace_back(
            symbol, word_of(text_, said.substr(arrow + 2), place + arrow + 2, met_, false));
    }

    void options(std::size_t from) {
        const std::size_t end = end_of(from);
        int open = 0;
        std::size_t begin = from;
        for (std::size_t i = from; i <= end; ++i) {
            const char c = text_.text()[i];
            if (c == '{') ++open;
            if (c == '}' && i < end) --open;
            if ((c == ',' && open == 0) || i == end) {
                option(text_.text().substr(begin, i - begin), begin);
                begin = i + 1;
            }
        }
    }

    void option(const std::string& said, std::size_t place) {
        const std::size_t equals = said.find('=');
        const std::string key = trimmed_text(said.substr(0, equals));
        if (key.empty()) return;
        if (equals == std::string::npos) {
            if (!chosen_.empty() && chosen_ != key)
                text_.fail(place + said.find(key),
                           "a second system: the options before this name " + quoted(chosen_) +
                               ", these " + quoted(key) + "; expected one");
            chosen_ = key;
            chosen_place_ = place + said.find(key);
            return;
        }
        std::size_t at = place + equals + 1;
        std::string value = trimmed_text(said.substr(equals + 1));
        if (value.starts_with('{') && value.ends_with('}')) {
            at += said.substr(equals + 1).find('{') + 1;
            value = value.substr(1, value.size() - 2);
        }
        if (const auto [said_before, is_new] = said_.emplace(key, value);
            !is_new && said_before->second != value)
            text_.fail(place + said.find(key), "a second value of " + quoted(key) + ", which was " +
                                                   quoted(said_before->second) +
                                                   "; expected one figure");
        if (key == "axiom") {
            axiom_ = value;
            axiom_place_ = at;
        } else if (key == "order") {
            if (value.empty() || value.find_first_not_of("0123456789") != std::string::npos)
                text_.fail(at, "expected a whole number as order, found " + quoted(value));
            strings_.order = value;
        } else if (key == "angle") {
            left_ = right_ = text_.number(value, at, "angle");
        } else if (key == "left angle") {
            left_ = text_.number(value, at, "left angle");
        } else if (key == "right angle") {
            right_ = text_.number(value, at, "right angle");
        } else if (key == "rule set") {
            for (std::size_t begin = 0; begin < value.size();) {
                const std::size_t end = std::min(value.find(',', begin), value.size());
                const std::string one = value.substr(begin, end - begin);
                if (!trimmed_text(one).empty()) rule(one, at + begin);
                begin = end + 1;
            }
        } else if (key.starts_with("randomize")) {
            if (value != "0")
                text_.fail(place, key + " changes each step at random, which has no meaning here");
        } else if (key != "step" && key != "anchor" && key != "name") {
            text_.fail(place, "unknown option " + quoted(key) +
                                  did_you_mean(
                                      key, {"axiom", "order", "angle", "left angle", "right angle",
                                            "rule set", "step", "anchor", "name"}));
        }
    }

    /// `\symbol{X}{\pgflsystemdrawforward}`
    void symbol(std::size_t from) {
        const std::size_t end = end_of(from);
        const std::string left = trimmed_text(text_.text().substr(from, end - from));
        const std::size_t open = text_.text().find('{', end);
        if (left.size() != 1 || open == std::string::npos)
            text_.fail(from, "expected \\symbol{X}{...} with one character");
        const std::size_t close = end_of(open + 1);
        const std::string body = text_.text().substr(open + 1, close - open - 1);
        static const std::map<std::string, std::string> commands{{"pgflsystemdrawforward", "F"},
                                                                 {"pgflsystemmoveforward", "f"},
                                                                 {"pgflsystemturnleft", "+"},
                                                                 {"pgflsystemsavestate", "["},
                                                                 {"pgflsystemrestorestate", "]"}};
        std::string image;
        for (std::size_t i = 0; i < body.size();) {
            if (std::isspace(static_cast<unsigned char>(body[i]))) {
                ++i;
                continue;
            }
            std::size_t stop = i + 1;
            while (stop < body.size() && std::isalpha(static_cast<unsigned char>(body[stop])))
                ++stop;
            const std::string command = body.substr(i + 1, stop - i - 1);
            const auto known = commands.find(command);
            if (body[i] == '\\' && command == "pgflsystemturnright")
                image += '-';
            else if (body[i] == '\\' && known != commands.end())
                image += known->second;
            else
                text_.fail(open + 1 + i,
                           "TeX that is none of \\pgflsystemdrawforward, moveforward, turnleft, "
                           "turnright, savestate and restorestate has no meaning here");
            i = stop;
        }
        images_[left[0]] = image;
    }

    Text text_;
    std::string name_;
    Strings strings_;
    std::string axiom_, left_ = "90", right_ = "90";
    std::size_t axiom_place_ = 0;
    std::set<char> met_;
    std::map<char, std::string> images_;  // what `\\symbol` says
    std::vector<Declaration> declared_;
    const Declaration* used_ = nullptr;  // the one that the options name
    std::string chosen_;                 // what they name
    std::size_t chosen_place_ = 0;
    std::map<std::string, std::string> said_;  // the options
};

/// What both writers need of a system: words of single characters, and what each does.
class StringWriter : protected FormatWriter {
protected:
    StringWriter(const Model& system, const char* format) : FormatWriter(system, format) {
        check_plain_rules(false);
        check_plain_settings();
        if (!system.drawing.stamps.empty()) refuse("stamps");
        if (!system.drawing.solids.empty()) refuse("solids");
        angle_ = decimal(system.drawing.angle, 90, "angle");
    }

    std::string decimal(const std::optional<Quantity>& number, long usual, const char* what) const {
        const std::optional<Rational> value = number ? number->exact : Rational(usual);
        const auto text = value ? exact_decimal(*value) : std::nullopt;
        if (!text) refuse(std::string("the ") + what + ", which is no decimal");
        return *text;
    }

    /// What the letter does, as F, f, +, -, |, [ and ], with + to the left; nothing else is said there.
    std::string does(Symbol letter) const {
        std::string all;
        for (const TurtleModule& module : interpreted(letter)) {
            const std::string& what = name(module.symbol);
            const bool line = what == "F" || what == "G" || what.starts_with("F_"),
                       move = what == "f" || what.starts_with("f_");
            if (!module.parameters.empty())
                refuse("the letter " + name(letter) + ", which has parameters");
            if (line)
                all += 'F';
            else if (move)
                all += 'f';
            else if (what == "+" || what == "-")
                all += (what == "+") == system_.drawing.clockwise ? '-' : '+';
            else if (what == "|" || what == "[" || what == "]")
                all += what;
            else if (what == "*" && !system_.drawing.scale)
                continue;
            else if (what.size() == 1 &&
                     std::string_view("&^\\/$!'.{}%*@~").find(what[0]) != std::string_view::npos)
                refuse("the letter " + name(letter) + ", which does " + what);
        }
        return all;
    }

    std::string order() const {
        const auto& shown = system_.drawing.generations;
        return std::to_string(shown ? shown->second : 3);
    }

    std::string angle_;
};

class InkscapeWriter final : StringWriter {
public:
    explicit InkscapeWriter(const Model& system) : StringWriter(system, "inkscape") {}
    std::string text() {
        // Letters that do the same as a command of Inkscape are this one; others get letters of their kind.
        std::string draws = inkscape_draws, moves = inkscape_moves, free = inkscape_free;
        std::map<Symbol, char> names;
        const auto keep_or_take = [&](Symbol letter, std::string& from, const char* kind) {
            const std::string& own = name(letter);
            std::size_t at = own.size() == 1 ? from.find(own[0]) : std::string::npos;
            if (at == std::string::npos && from.empty())
                refuse(std::string("so many letters that ") + kind);
            if (at == std::string::npos) at = from.size() - 1;
            names[letter] = from[at];
            from.erase(at, 1);
        };
        // Letters that keep their names come first.
        for (const bool keeps : {true, false})
            for (Symbol letter = 0; letter < system_.alphabet.size(); ++letter) {
                const std::string what = does(letter), &own = name(letter);
                const std::string& pool = what == "F" ? draws : what == "f" ? moves : free;
                const bool kept = own.size() == 1 && pool.find(own[0]) != std::string::npos;
                if (kept != keeps || names.contains(letter)) continue;
                if (what.empty())
                    keep_or_take(letter, free, "do nothing");
                else if (what == "F")
                    keep_or_take(letter, draws, "draw");
                else if (what == "f")
                    keep_or_take(letter, moves, "move");
                else if (what.size() == 1)
                    // Its + turns to the right on the page.
                    names[letter] = what == "+" ? '-' : what == "-" ? '+' : what[0];
                else
                    refuse("the letter " + own + ", which does several things");
            }
        std::set<char> taken;
        for (const auto& [letter, said] : names)
            if (!taken.insert(said).second)
                refuse("the letter " + name(letter) + ", which does what another letter does");
        const auto word = [&](const Word& letters) {
            std::string out;
            for (const Symbol letter : letters) out += names.at(letter);
            return out;
        };
        std::string rules;
        for (const Production& rule : system_.rules)
            rules += (rules.empty() ? "" : ";") +
                     std::string(1, names.at(rule.predecessor.symbol)) + "=" +
                     word(rule.successor.letters);
        std::string out = commented("# ", {system_.title, system_.source});
        out += "axiom = " + word(system_.axiom.letters) + "\nrules = " + rules +
               "\norder = " + order() + "\nlangle = " + angle_ + "\nrangle = " + angle_ + "\n";
        return out;
    }
};

class TikzWriter final : StringWriter {
public:
    explicit TikzWriter(const Model& system) : StringWriter(system, "tikz") {}
    std::string text() {
        std::string symbols;
        for (Symbol letter = 0; letter < system_.alphabet.size(); ++letter) {
            const std::string& own = name(letter);
            if (own.size() != 1 || static_cast<unsigned char>(own[0]) >= 0x80 ||
                std::string_view("\\{}#%&$~^_,").find(own[0]) != std::string_view::npos)
                refuse("the letter " + own +
                       ": symbols are single characters that TeX leaves alone");
            const std::string what = does(letter);
            const bool usual = std::string_view("Ff+-[]").find(own[0]) != std::string_view::npos;
            if (what == (usual ? own : std::string())) continue;
            symbols += "  \\symbol{" + own + "}{";
            for (const char c : what) {
                if (c == '|') refuse("the letter " + own + ", which turns back");
                symbols += c == 'F'   ? "\\pgflsystemdrawforward"
                           : c == 'f' ? "\\pgflsystemmoveforward"
                           : c == '+' ? "\\pgflsystemturnleft"
                           : c == '-' ? "\\pgflsystemturnright"
                           : c == '[' ? "\\pgflsystemsavestate"
                                      : "\\pgflsystemrestorestate";
            }
            symbols += "}\n";
        }
        const auto word = [&](const Word& letters) {
            std::string out;
            for (const Symbol letter : letters) out += name(letter);
            return out;
        };
        std::string out = commented("% ", {system_.title, system_.source});
        out +=
            "% It needs \\usepackage{tikz} and \\usetikzlibrary{lindenmayersystems}.\n"
            "\\pgfdeclarelindenmayersystem{system}{%\n" +
            symbols;
        for (const Production& rule : system_.rules)
            out += "  \\rule{" + name(rule.predecessor.symbol) + " -> " +
                   word(rule.successor.letters) + "}\n";
        return out + "}\n\\tikz\\draw l-system [l-system={system, axiom=" +
               braced(word(system_.axiom.letters)) + ", order=" + order() + ", angle=" + angle_ +
               ", step=2pt}];\n";
    }

private:
    static std::string braced(const std::string& word) {
        return word.find_first_of("[]") == std::string::npos ? word : "{" + word + "}";
    }
};

}  // namespace

Model read_tikz(std::string_view text, const std::string& name) {
    return TikzReader(text, name).read();
}
std::string print_inkscape(const Model& system) {
    return InkscapeWriter(with_plain_angle(system)).text();
}
std::string print_tikz(const Model& system) { return TikzWriter(with_plain_angle(system)).text(); }

}  // namespace algae
