#include <fmt/format.h>

#include <algorithm>
#include <cctype>
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
#include "turtle/turtle.hpp"

// L-systems of JFLAP: XML with an axiom, productions and parameters. Grammars and finite automata, as languages of claims.
//
//     <structure><type>lsystem</type>
//       <axiom>g X</axiom>
//       <production><left>X</left><right>g X</right><right>X</right></production>
//       <parameter><name>angle</name><value>45</value></parameter>
//     </structure>
//
// Symbols are separated by blanks, so `gfgg` is one symbol. Several right sides are a choice at random, all equally likely. A left side that
// begins with a number i is a context, `1 a b c`: b between a and c, where words are plain strings, brackets are letters like others
// and nothing is skipped.
//
// JFLAP 8 writes `<structure type="lsystem">` with the parts in structures of their own, `<lhs>` and `<rhs>`, and words without blanks: they
// are cut into the symbols that the file lists, the longest first; a character that begins none of them is one itself.
//
// A finite automaton becomes a right-linear grammar, `regular { ... }`, with a letter for each state; a grammar whose left sides are single letters
// is written as it stands, `CF { ... }`.
//
// The turtle starts upward, + turns to the right, g draws, % turns back, * rolls left. Tokens with a number, `g(2)`, are symbols of their
// own, `g·2`.
//
// Assignments, `angle=20` or `a=a+1`, change what the symbols behind them do, up to the end of their branch. The notation has no such
// state, so the values are put where they are used: a step or a turn whose value is a number becomes the symbol with that number, `-·20`, and
// a letter from which symbols are derived that read a variable carries the value as a parameter, unless it is the same number wherever the
// letter stands. That says everything as long as no symbol reads a variable which a letter before it goes on changing from one generation to
// the next; such files are refused. `!` and `~` change the width in the same way, and where it cannot be known widths are left out, as no
// place of the figure depends on them. Hues of lines are left out.
//
// Contexts: JFLAP picks among all productions that match. For each union of contexts that can match together there is a rule with all of
// their right sides, and of those that match the notation takes the longest, which is the union of all that do.

namespace algae {

namespace {

constexpr std::size_t most_depth = 100;

/// A piece of a text and where it stands.
struct Placed {
    std::string text;
    std::size_t offset = 0;
};

struct Element {
    std::string name;
    std::size_t offset = 0;
    Placed text;
    std::vector<Element> children;
    std::string attributes;  // as they stand in the tag

    /// The value of an attribute; empty if there is none.
    std::string attribute(const std::string& wanted) const {
        const std::size_t at = attributes.find(" " + wanted + "=\"");
        if (at == std::string::npos) return {};
        const std::size_t begin = at + wanted.size() + 3;
        return attributes.substr(begin, attributes.find('"', begin) - begin);
    }
    const Element* child(std::string_view wanted) const {
        const auto found = std::ranges::find(children, wanted, &Element::name);
        return found == children.end() ? nullptr : &*found;
    }
};

/// Reads the elements of an XML text.
class Xml {
public:
    Xml(std::string_view text, const Source& source) : text_(text), source_(source) {}

    Element root() {
        std::vector<Element> open;
        while (at_ < text_.size()) {
            if (text_[at_] != '<') {
                const std::size_t end = std::min(text_.find('<', at_), text_.size());
                if (!open.empty())
                    add_text(open.back(), at_, end);
                else if (!trimmed(text_.substr(at_, end - at_)).empty() &&
                         text_.substr(at_, end - at_) != "\xef\xbb\xbf")
                    fail(at_, "expected an element of XML, such as <structure>");
                at_ = end;
            } else if (text_.substr(at_).starts_with("<!--")) {
                skip("-->", "the comment is never closed");
            } else if (text_.substr(at_).starts_with("<?") || text_.substr(at_).starts_with("<!")) {
                skip(">", "'<' is never closed");
            } else {
                const std::size_t begin = at_, end = text_.find('>', at_);
                if (end == std::string_view::npos) fail(at_, "'<' is never closed");
                std::string_view tag = text_.substr(at_ + 1, end - at_ - 1);
                at_ = end + 1;
                const bool closes = tag.starts_with('/'), empty = tag.ends_with('/');
                if (closes) tag.remove_prefix(1);
                const std::string name(tag.substr(0, tag.find_first_of(" \t\r\n/")));
                if (name.empty()) fail(begin, "expected the name of an element");
                if (!closes) {
                    if (open.size() == most_depth)
                        fail(begin, "more than 100 elements within each other");
                    open.push_back({name, begin, {"", end + 1}, {}, ""});
                    open.back().attributes = " " + std::string(tag.substr(name.size()));
                    std::ranges::replace(open.back().attributes, '\n', ' ');
                    if (!empty) continue;
                }
                if (open.empty() || open.back().name != name)
                    fail(begin, open.empty() ? "expected no </" + name + ">"
                                             : "expected </" + open.back().name + ">, found </" +
                                                   name + ">");
                Element whole = std::move(open.back());
                open.pop_back();
                if (open.empty()) return whole;
                open.back().children.push_back(std::move(whole));
            }
        }
        if (!open.empty()) fail(open.back().offset, "<" + open.back().name + "> is never closed");
        fail(0, "expected <structure>, found no element");
    }

private:
    [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
        throw Diagnostics({source_.finding(offset, message)});
    }
    void skip(std::string_view end, const std::string& message) {
        const std::size_t found = text_.find(end, at_);
        if (found == std::string_view::npos) fail(at_, message);
        at_ = found + end.size();
    }
    void add_text(Element& to, std::size_t begin, std::size_t end) const {
        static constexpr std::pair<std::string_view, char> entities[] = {
            {"&lt;", '<'},    {"&gt;", '>'},  {"&amp;", '&'}, {"&quot;", '"'},
            {"&apos;", '\''}, {"&#13;", ' '}, {"&#10;", ' '}};
        if (to.text.text.empty()) to.text.offset = begin;
        while (begin < end) {
            if (text_[begin] == '&') {
                const auto found = std::ranges::find_if(entities, [&](const auto& one) {
                    return text_.substr(begin).starts_with(one.first);
                });
                if (found == std::end(entities))
                    fail(begin, "expected &lt; &gt; &amp; &quot; or &apos; behind '&'");
                to.text.text += found->second;
                begin += found->first.size();
            } else {
                to.text.text += text_[begin++];
            }
        }
    }

    std::string_view text_;
    const Source& source_;
    std::size_t at_ = 0;
};

/// A symbol of JFLAP.
using Tokens = std::vector<Placed>;

struct Rule {
    Tokens left;            // the neighbourhood
    std::size_t index = 0;  // of the symbol that is rewritten
    std::vector<Tokens> rights;
};

bool is_integer(const std::string& text) {
    return !text.empty() && text.size() < 6 &&
           text.find_first_not_of("0123456789") == std::string::npos;
}

class Reader {
public:
    Reader(std::string_view text, const std::string& name)
        : source_(text, name), findings_(source_) {
        findings_.throw_if_no_text();
    }

    Model read() {
        const Element root = Xml(source_.text(), source_).root();
        if (root.name != "structure")
            fail(root.offset, "expected <structure>, found <" + root.name + ">");
        check_type(root);
        const Element* axiom = nullptr;
        if (is_eighth_) find_symbols(root);
        std::ranges::stable_sort(listed_, std::greater<>(), &std::string::size);
        read_parts(root, axiom);
        if (!axiom) findings_.add(root.offset, "expected an <axiom>, found none");
        if (axiom) axiom_ = tokens(axiom->text);
        findings_.throw_if_any();
        free_brackets();
        find_state();
        findings_.throw_if_any();
        State start;
        std::string rules = "axiom " + word(axiom_, start) + "\n";
        rules += rules_text();
        findings_.throw_if_any();
        return read_lsystem((alphabet_.empty() ? "" : "alphabet" + alphabet_ + "\n") + rules +
                                interpretation_ + settings(),
                            source_.file());
    }

private:
    [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
        throw Diagnostics({source_.finding(offset, message)});
    }

    void check_type(const Element& root) {
        const Element* const type = root.child("type");
        const std::string eighth = root.attribute("type");
        if (!type && eighth.empty()) fail(root.offset, "expected <type>lsystem</type>, found none");
        is_eighth_ = !type;
        const std::string what = type ? std::string(trimmed(type->text.text)) : eighth;
        if (what == "lsystem") return;
        const bool is_language = what == "fa" || what == "grammar";
        fail(type ? type->offset : root.offset,
             "expected an L-system of JFLAP, found the type " + quoted(what) +
                 (is_language ? ", which converts to a claim" : ""));
    }

    /// The symbols that a file of JFLAP 8 lists, wherever they stand.
    void find_symbols(const Element& element) {
        if (element.name == "symbol") listed_.emplace_back(trimmed(element.text.text));
        for (const Element& child : element.children) find_symbols(child);
    }

    /// The axiom, productions and parameters of an element, in JFLAP 8 also of structures within.
    void read_parts(const Element& element, const Element*& axiom) {
        for (const Element& child : element.children) {
            if (child.name == "axiom" && (!is_eighth_ || child.children.empty()))
                axiom = &child;
            else if (child.name == "production")
                add_production(child);
            else if (child.name == "parameter" || (is_eighth_ && child.child("value")))
                add_parameter(child);
            else if (is_eighth_)
                read_parts(child, axiom);
        }
    }

    Tokens tokens(const Placed& text) const {
        Tokens found;
        for (const std::string_view one : blank_separated(text.text)) {
            // Behind an entity offsets are those of the element's text, so places are near enough.
            const std::size_t offset =
                text.offset + static_cast<std::size_t>(one.data() - text.text.data());
            for (std::size_t at = 0; at < one.size();) {
                std::size_t size = one.size();
                if (is_eighth_) {
                    const auto symbol = std::ranges::find_if(listed_, [&](const std::string& name) {
                        return !name.empty() && one.substr(at).starts_with(name);
                    });
                    size = symbol == listed_.end() ? first_character(one.substr(at)).bytes
                                                   : symbol->size();
                }
                found.push_back({std::string(one.substr(at, size)), offset + at});
                at += std::max<std::size_t>(size, 1);
            }
        }
        return found;
    }

    void add_production(const Element& production) {
        Rule rule;
        const char *const left_name = is_eighth_ ? "lhs" : "left", *const right_name =
                                                                       is_eighth_ ? "rhs" : "right";
        const Element* const left = production.child(left_name);
        if (!left)
            return findings_.add(production.offset, std::string("expected <") + left_name +
                                                        "> in a production, found none");
        rule.left = tokens(left->text);
        if (rule.left.empty())
            return findings_.add(
                left->offset, std::string("expected a symbol in <") + left_name + ">, found none");
        if (rule.left.size() > 1) {
            if (!is_integer(rule.left[0].text))
                return findings_.add(
                    rule.left[0].offset,
                    "expected the number of the symbol that is rewritten before a context, as in 1 "
                    "a b c; JFLAP ignores the production otherwise");
            rule.index = std::stoul(rule.left[0].text);
            rule.left.erase(rule.left.begin());
            if (rule.index >= rule.left.size())
                return findings_.add(left->text.offset,
                                     fmt::format("expected a number from 0 to {}, found {}",
                                                 rule.left.size() - 1, rule.index));
            has_context_ = has_context_ || rule.left.size() > 1;
        }
        for (const Element& child : production.children)
            if (child.name == right_name) rule.rights.push_back(tokens(child.text));
        if (rule.rights.empty())
            return findings_.add(production.offset, std::string("expected <") + right_name +
                                                        "> in a production, found none");
        rules_.push_back(std::move(rule));
    }

    void add_parameter(const Element& parameter) {
        const auto part = [&](const char* name) -> const Element* {
            const auto found = std::ranges::find(parameter.children, name, &Element::name);
            return found == parameter.children.end() ? nullptr : &*found;
        };
        const Element *name = part("name"), *value = part("value");
        if (!name || !value)
            return findings_.add(parameter.offset, "expected <name> and <value> in a parameter");
        const std::string what(trimmed(name->text.text)), number(trimmed(value->text.text));
        if (is_colour(what)) {
            if (what == "color") colour_ = number;
            return;
        }
        const bool minus = number.starts_with('-');
        const std::string digits = number.substr(minus ? 1 : 0);
        const bool is_number = !digits.empty() && number_size(digits) == digits.size() &&
                               digits.find_first_of("eE") == std::string::npos;
        const std::string name_here = canonical(what);
        if (!is_number) {
            if (name_here != "angle" && name_here != "distance") return;  // of the program's window
            return findings_.add(value->text.offset,
                                 "expected a number as " + what + ", found " + quoted(number));
        }
        parameters_[name_here] = (minus ? "-" : "") +
                                 (digits.starts_with('.') ? "0" : std::string()) +
                                 plain_number(digits);
    }

    // --- Variables ---

    static bool is_colour(const std::string& name) {
        return name == "color" || name == "polygonColor";
    }
    static std::string canonical(const std::string& name) {
        return name == "angleIncrement" ? "angle" : name;
    }

    /// What a variable is at first.
    std::string parameter(const std::string& name) const {
        if (const auto known = parameters_.find(name); known != parameters_.end())
            return known->second;
        if (name == "angle" || name == "distance") return "15";
        if (name == "lineWidth" || name == "lineIncrement") return "1";
        if (name == "hueChange") return "10";
        return "0";
    }

    /// What a token says of variables.
    struct Reading {
        std::string command, argument;  // of `g(2)`
        bool has_argument = false;
        std::string assigned;  // the variable that it sets to `argument`
    };
    static Reading reading(const std::string& token) {
        Reading found;
        found.command = token;
        const std::size_t equals = token.find('='), open = token.find('(');
        if (equals != std::string::npos && equals > 0) {
            found.assigned = canonical(token.substr(0, equals));
            found.argument = token.substr(equals + 1);
            found.has_argument = true;
        } else if (open != std::string::npos && open > 0 && token.ends_with(')')) {
            found.command = token.substr(0, open);
            found.argument = token.substr(open + 1, token.size() - open - 2);
            found.has_argument = true;
        }
        const bool widens = found.command == "!" || found.command == "~";
        if (widens && found.assigned.empty()) {
            found.assigned = "lineWidth";
            found.argument = std::string("lineWidth") + (found.command == "!" ? "+" : "-") + "(" +
                             (found.has_argument ? found.argument : "lineIncrement") + ")";
        }
        return found;
    }
    static bool is_step(const std::string& command) { return command == "g" || command == "f"; }
    static bool is_turn(const std::string& command) {
        return command.size() == 1 &&
               std::string_view("+-&^/*").find(command[0]) != std::string_view::npos;
    }

    /// Names in an expression.
    static std::set<std::string> names_in(const std::string& expression) {
        std::set<std::string> found;
        for_names(expression, [&](const std::string& name) {
            found.insert(canonical(name));
            return name;
        });
        return found;
    }
    template <class Said>
    static std::string for_names(const std::string& expression, Said said) {
        std::string out;
        const auto part = [&](std::size_t i) {
            return std::isalnum(static_cast<unsigned char>(expression[i])) || expression[i] == '_';
        };
        for (std::size_t i = 0; i < expression.size();) {
            if (!part(i) || std::isdigit(static_cast<unsigned char>(expression[i]))) {
                // A number with its digits, which are no part of a name.
                do out += expression[i++];
                while (i < expression.size() && part(i) && !out.empty() &&
                       std::isdigit(static_cast<unsigned char>(out.back())));
                continue;
            }
            std::size_t end = i;
            while (end < expression.size() && part(end)) ++end;
            out += said(expression.substr(i, end - i));
            i = end;
        }
        return out;
    }

    /// The variables that a token itself reads, and those that what is derived from it reads.
    std::set<std::string> read_by(const Placed& token) const {
        const Reading said = reading(token.text);
        std::set<std::string> found;
        if (!said.assigned.empty()) {
            if (!is_colour(said.assigned)) found = names_in(said.argument);
        } else if (is_step(said.command) || is_turn(said.command)) {
            if (said.has_argument)
                found = names_in(said.argument);
            else
                found.insert(is_step(said.command) ? "distance" : "angle");
        }
        if (const auto derived = reads_.find(token.text); derived != reads_.end())
            found.insert(derived->second.begin(), derived->second.end());
        std::erase_if(found, [&](const std::string& name) { return !varying_.contains(name); });
        return found;
    }
    /// Those that it changes behind it, itself or what is derived from it.
    std::set<std::string> changed_by(const Placed& token) const {
        std::set<std::string> found;
        const Reading said = reading(token.text);
        if (varying_.contains(said.assigned)) found.insert(said.assigned);
        if (const auto derived = changes_.find(token.text); derived != changes_.end())
            found.insert(derived->second.begin(), derived->second.end());
        return found;
    }
    bool is_rewritten(const Placed& token) const { return left_sides_.contains(token.text); }

    /// Values of variables as expressions of the notation, and those whose value is not known.
    struct State {
        std::map<std::string, std::string> values;
        std::map<std::string, std::string> unknown;  // by which letter they are changed
    };

    std::string value_of(const std::string& name, const State& state) const {
        const auto known = state.values.find(name);
        return known == state.values.end() ? parameter(name) : known->second;
    }
    /// The expression with the values for its names; a number where it is one.
    std::string put_in(const std::string& expression, const State& state) const {
        return simplified(for_names(expression, [&](const std::string& name) {
            return is_function(name) ? name : "(" + value_of(canonical(name), state) + ")";
        }));
    }
    static bool is_function(const std::string& name) {
        static const std::set<std::string> all{"sin", "cos", "tan", "sqrt", "exp", "log", "abs"};
        return all.contains(name);
    }
    static std::string simplified(const std::string& expression) {
        constexpr std::size_t longest = 10'000;
        if (expression.size() > longest)
            throw Error("an expression that would be longer than 10000 characters");
        const Expression read = read_expression(expression);
        try {
            const Quantity value =
                evaluate(read, [](const std::string&) -> const Quantity* { return nullptr; });
            if (value.exact) {
                const auto decimal = exact_decimal(*value.exact);
                return decimal ? *decimal : to_string(*value.exact);
            }
        } catch (const Error&) {
        }
        return expression;
    }

    /// Goes along a word: `each` is called for a token with the state before it, which then is the one behind it.
    template <class Each>
    void walk(const Tokens& tokens, State state, Each each) {
        std::vector<State> open;
        for (const Placed& token : tokens) {
            each(token, state);
            if (token.text == "[") open.push_back(state);
            if (token.text == "]" && !open.empty()) {
                state = open.back();
                open.pop_back();
            }
            const Reading said = reading(token.text);
            if (varying_.contains(said.assigned)) {
                try {
                    state.values[said.assigned] = put_in(said.argument, state);
                } catch (const Error&) {
                    findings_.add(token.offset, "expected an expression behind '=', found " +
                                                    quoted(said.argument));
                    state.values[said.assigned] = "0";
                }
                state.unknown.erase(said.assigned);
            }
            if (const auto derived = changes_.find(token.text); derived != changes_.end())
                for (const std::string& name : derived->second) state.unknown[name] = token.text;
        }
    }

    template <class Each>
    void for_words(Each each) const {
        each("", axiom_);
        for (const Rule& rule : rules_)
            for (const Tokens& right : rule.rights) each(rule.left[rule.index].text, right);
    }

    /// Which variables change, what letters carry of them, and whether the values can be put where they are used.
    void find_state() {
        for (const Rule& rule : rules_) left_sides_.insert(rule.left[rule.index].text);
        std::set<std::string> all;
        for_words([&](const std::string&, const Tokens& word) {
            for (const Placed& token : word) {
                const Reading said = reading(token.text);
                if (!said.assigned.empty() && !is_colour(said.assigned)) all.insert(said.assigned);
            }
        });
        varying_ = all;
        if (!find_use()) return;
        // Widths are no matter of the figure's places: they are left out where they cannot be known.
        if (!varying_.contains("lineWidth") || (!unknown_ && !has_context_)) return check_state();
        varying_.erase("lineWidth");
        if (find_use()) check_state();
    }
    void check_state() {
        if (has_context_ && !varying_.empty())
            for_words([&](const std::string&, const Tokens& word) {
                for (const Placed& token : word)
                    if (varying_.contains(reading(token.text).assigned))
                        findings_.add(
                            token.offset,
                            "assignments beside contexts have no meaning in the notation");
            });
        if (unknown_)
            findings_.add(unknown_->first.offset,
                          quoted(unknown_->first.text) + " depends on the variable " +
                              unknown_->second.first + ", which " +
                              quoted(unknown_->second.second) +
                              " before it goes on changing, and the notation has no variables");
    }

    /// False if no variable changes.
    bool find_use() {
        reads_.clear();
        changes_.clear();
        carried_.clear();
        unknown_.reset();
        if (varying_.empty()) return false;
        for (bool more = true; more;) {
            more = false;
            for_words([&](const std::string& letter, const Tokens& word) {
                if (letter.empty()) return;
                const std::size_t before = reads_[letter].size() + changes_[letter].size();
                std::vector<std::set<std::string>> open;
                std::set<std::string> assigned;  // surely
                for (const Placed& token : word) {
                    for (const std::string& name : read_by(token))
                        if (!assigned.contains(name)) reads_[letter].insert(name);
                    if (token.text == "[") open.push_back(assigned);
                    if (token.text == "]" && !open.empty()) {
                        assigned = open.back();
                        open.pop_back();
                    }
                    const Reading said = reading(token.text);
                    if (varying_.contains(said.assigned)) assigned.insert(said.assigned);
                    if (open.empty())
                        for (const std::string& name : changed_by(token))
                            changes_[letter].insert(name);
                }
                more = more || reads_[letter].size() + changes_[letter].size() != before;
            });
        }
        // Values that letters carry: one number wherever they stand, or several.
        for (bool more = true; more;) {
            more = false;
            for_words([&](const std::string& letter, const Tokens& word) {
                walk(word, state_of(letter), [&](const Placed& token, const State& state) {
                    for (const std::string& name : read_by(token)) {
                        if (const auto changed = state.unknown.find(name);
                            changed != state.unknown.end() && !unknown_)
                            unknown_ = std::pair{token, std::pair{name, changed->second}};
                        if (!is_rewritten(token)) continue;
                        const std::string value = value_of(name, state);
                        const bool is_number =
                            value.find_first_not_of("0123456789./-") == std::string::npos;
                        auto& carried = carried_[token.text];
                        const auto [known, is_new] = carried.emplace(name, value);
                        const std::string now = is_number && known->second == value ? value : "";
                        more = more || is_new || known->second != now;
                        known->second = now;
                    }
                });
            });
        }
        return true;
    }

    /// The state where a word of a letter begins: the numbers that it always has, and its parameters.
    State state_of(const std::string& letter) const {
        State state;
        if (const auto carried = carried_.find(letter); carried != carried_.end())
            for (const auto& [name, value] : carried->second)
                state.values[name] = value.empty() ? parameter_name(name) : value;
        return state;
    }
    static std::string parameter_name(const std::string& variable) { return "v_" + variable; }
    /// The variables that a letter has as parameters.
    std::vector<std::string> parameters_of(const std::string& letter) const {
        std::vector<std::string> found;
        if (const auto carried = carried_.find(letter); carried != carried_.end())
            for (const auto& [name, value] : carried->second)
                if (value.empty()) found.push_back(name);
        return found;
    }

    /// `]` without `[` does nothing there, and `[` without `]` keeps what nothing goes back to. Where no branch stands around, they are letters
    /// that do nothing here; elsewhere they would close the branches of other words. Beside contexts all brackets are letters there, and are refused.
    void free_brackets() {
        if (has_context_) {
            for_all_tokens([&](Placed& token) {
                if ((token.text == "[" || token.text == "]") && findings_.empty())
                    findings_.add(token.offset,
                                  "brackets are letters beside contexts in JFLAP, and branches in "
                                  "the notation");
            });
            return;
        }
        std::set<std::string> inside;  // letters that stand in branches
        std::map<std::string, std::set<std::string>> derived;
        for_words([&](const std::string& letter, const Tokens& word) {
            // Depths by brackets that have a partner.
            std::vector<int> change(word.size());
            std::vector<std::size_t> opened;
            for (std::size_t i = 0; i < word.size(); ++i) {
                if (word[i].text == "[") opened.push_back(i);
                if (word[i].text != "]" || opened.empty()) continue;
                change[opened.back()] = 1;
                change[i] = -1;
                opened.pop_back();
            }
            int open = 0;
            for (std::size_t i = 0; i < word.size(); ++i) {
                open += change[i];
                derived[letter].insert(word[i].text);
                if (open > 0) inside.insert(word[i].text);
            }
        });
        for (bool more = true; more;) {
            const std::size_t before = inside.size();
            for (const auto& [letter, all] : derived)
                if (inside.contains(letter)) inside.insert(all.begin(), all.end());
            more = inside.size() != before;
        }
        const auto free = [&](const std::string& letter, Tokens& word) {
            std::vector<std::size_t> open;
            std::vector<std::size_t> unmatched;
            for (std::size_t i = 0; i < word.size(); ++i) {
                if (word[i].text == "[") open.push_back(i);
                if (word[i].text != "]") continue;
                if (open.empty())
                    unmatched.push_back(i);
                else
                    open.pop_back();
            }
            unmatched.insert(unmatched.end(), open.begin(), open.end());
            for (const std::size_t i : unmatched) {
                if (inside.contains(letter))
                    findings_.add(word[i].offset,
                                  "unmatched '" + word[i].text + "' in a word of " +
                                      quoted(letter) +
                                      ", which stands in branches: it would end or open another "
                                      "branch, which has no meaning in the notation");
                word[i].text = word[i].text == "[" ? lone_opens : lone_closes;
            }
        };
        free("", axiom_);
        for (Rule& rule : rules_)
            for (Tokens& right : rule.rights) free(rule.left[rule.index].text, right);
    }
    template <class Each>
    void for_all_tokens(Each each) {
        for (Placed& token : axiom_) each(token);
        for (Rule& rule : rules_) {
            for (Placed& token : rule.left) each(token);
            for (Tokens& right : rule.rights)
                for (Placed& token : right) each(token);
        }
    }
    static constexpr const char *lone_opens = "X_91_0", *lone_closes = "X_93_0";

    // --- Words ---

    /// The symbol of the notation for a token, with what it does to the turtle said.
    std::string symbol(const Placed& token) {
        const auto inserted = symbols_.emplace(token.text, "");
        const auto known = inserted.first;
        if (!inserted.second) return known->second;
        const Reading said = reading(token.text);
        std::string name = said.command, number;
        const auto give_up = [&](const std::string& why) {
            findings_.add(token.offset, why);
            return known->second = "X";
        };
        const bool assigns = token.text.find('=', 1) != std::string::npos;
        if (!assigns && said.has_argument) {
            number = said.argument;
            const std::string digits = number.substr(number.starts_with('-') ? 1 : 0);
            const bool is_number = !digits.empty() && number_size(digits) == digits.size() &&
                                   digits.find_first_of("eE") == std::string::npos;
            if (is_number) {
                number = (number.starts_with('-') ? "-" : "") +
                         (digits.starts_with('.') ? "0" : std::string()) + plain_number(digits);
            } else if (is_step(name) || is_turn(name)) {
                return give_up("expected a number or an expression between the brackets of " +
                               quoted(token.text));
            } else {
                name = token.text;
                number.clear();
            }
        }
        const std::string command = name;
        if (is_character(name) &&
            std::string_view("()<>:,;?#=").find(name) != std::string_view::npos)
            name = fmt::format("X_{}", static_cast<unsigned char>(name[0]));
        else
            name = allowed(name);
        if (!number.empty()) name += "·" + number;
        for (const auto& [other, taken] : symbols_)
            if (taken == name)
                return give_up(quoted(token.text) + " and " + quoted(other) +
                               " would be one symbol");
        known->second = name;
        if (undeclared_length(name) != name.size()) alphabet_ += " " + name;
        const std::string does = assigns ? colour_of(token.text) : meaning(command, number);
        if (does != name && (does != "ε" || acts(name)))
            interpretation_ += "interpret " + name + " -> " + does + "\n";
        return name;
    }

    /// A name without the signs of the notation.
    static std::string allowed(const std::string& name) {
        static const std::map<char, const char*> others{
            {'(', "⟨"},  {')', "⟩"},  {'<', "‹"}, {'>', "›"}, {':', "꞉"}, {',', "‚"},
            {';', "；"}, {'?', "？"}, {'=', "≔"}, {'#', "♯"}, {'|', "¦"}};
        if (name.size() == 1) return name;
        std::string out;
        for (const char c : name) {
            const auto other = others.find(c);
            out += other == others.end() ? std::string(1, c) : other->second;
        }
        return out;
    }

    /// What `color=red` does; the colours are counted from that of the parameter.
    std::string colour_of(const std::string& assignment) {
        if (!assignment.starts_with("color=")) return "ε";
        const std::string colour = known_colour(assignment.substr(6));
        if (colour.empty()) return "ε";
        if (colours_.empty()) colours_.push_back(first_colour());
        auto found = std::ranges::find(colours_, colour);
        if (found == colours_.end()) found = colours_.insert(found, colour);
        return "'(" + std::to_string(found - colours_.begin()) + ")";
    }
    std::string first_colour() const {
        const std::string colour = known_colour(colour_);
        return colour.empty() ? "black" : colour;
    }
    /// The name as the notation has it; empty if it has none.
    static std::string known_colour(std::string name) {
        for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        const auto names = colour_names();
        return std::ranges::count(names, name) > 0 ? name : "";
    }

    /// A token where it stands in a word: the symbol, and the values that it needs.
    std::string module(const Placed& token, const State& state) {
        const Reading said = reading(token.text);
        const bool step = is_step(said.command), turn = is_turn(said.command);
        if (is_rewritten(token)) return module_of_letter(token, state);
        std::string value, bare;
        try {
            if (varying_.contains("lineWidth") && said.assigned == "lineWidth" &&
                (said.command == "!" || said.command == "~")) {
                value = put_in(said.argument, state);
                bare = "lineWidth";
            } else if ((step || turn) && said.has_argument && !names_in(said.argument).empty()) {
                value = put_in(said.argument, state);
                bare = said.command;
            } else if ((step || turn) && !said.has_argument) {
                const std::string name = step ? "distance" : "angle";
                value = value_of(name, state);
                bare = said.command;
                if (value == parameter(name)) value.clear();
            }
        } catch (const Error&) {
            findings_.add(token.offset,
                          "expected an expression between the brackets of " + quoted(token.text));
            return "X";
        }
        if (value.empty()) return symbol(token);
        if (number_size(value.substr(value.starts_with('-') ? 1 : 0)) ==
            value.size() - (value.starts_with('-') ? 1 : 0))
            return symbol({bare + "(" + value + ")", token.offset});
        const std::string name = symbol({bare, token.offset});
        const std::string does = meaning(bare, "x");
        if (does != name + "(x)" && with_value_.insert(name).second)
            interpretation_ += "interpret " + name + "(x) -> " + does + "\n";
        return name + "(" + value + ")";
    }
    /// A letter with the values of the variables that it carries.
    std::string module_of_letter(const Placed& token, const State& state) {
        const std::vector<std::string> names = parameters_of(token.text);
        const std::string name = symbol(token);
        if (names.empty()) return name;
        std::vector<std::string> values, own;
        for (const std::string& one : names) {
            values.push_back(value_of(one, state));
            own.push_back(parameter_name(one));
        }
        if (with_value_.insert(name).second) {
            const Reading said = reading(token.text);
            std::string does = "ε";
            if (is_step(said.command) || is_turn(said.command)) {
                const State inside = state_of(token.text);
                does =
                    meaning(said.command,
                            said.has_argument
                                ? put_in(said.argument, inside)
                                : value_of(is_step(said.command) ? "distance" : "angle", inside));
            } else if (!acts(name)) {
                does.clear();
            }
            if (!does.empty())
                interpretation_ +=
                    "interpret " + name + "(" + joined(own, ",") + ") -> " + does + "\n";
        }
        return name + "(" + joined(values, ",") + ")";
    }

    /// Whether the turtle of the notation does something for a symbol.
    static bool acts(const std::string& name) {
        return name == "F" || name == "f" || name == "G" || name.starts_with("F_") ||
               name.starts_with("f_") ||
               (name.size() == 1 &&
                std::string_view("+-&^\\/|[]{}.!'$%~@*").find(name[0]) != std::string_view::npos);
    }

    std::string meaning(const std::string& token, const std::string& number) const {
        const std::string degrees = number.empty() ? "" : "(" + number + ")";
        if (token == "g" || token == "f") {
            const std::string step = token == "g" ? "F" : "f";
            if (number.empty()) return is_still() ? step + "(0)" : step;
            return step + "(" + number + "/(" + unit() + "))";
        }
        if (token == "lineWidth" && !number.empty()) return "!(" + number + ")";
        for (const auto& [name, does] :
             {std::pair("+", "+"), {"-", "-"}, {"&", "&"}, {"^", "^"}, {"/", "/"}, {"*", "\\"}})
            if (token == name) return does + degrees;
        if (token == "%") return "|";
        if (token == "[" || token == "]" || token == "{" || token == "}") return token;
        return "ε";
    }

    /// The length of a step of the notation: that of the parameter, unless it is 0.
    std::string unit() const { return is_still() ? "1" : parameter("distance"); }
    bool is_still() const {
        return parameter("distance").find_first_not_of("-0.") == std::string::npos;
    }

    std::string word(const Tokens& tokens, const State& state) {
        std::vector<std::string> names;
        walk(tokens, state,
             [&](const Placed& token, const State& now) { names.push_back(module(token, now)); });
        return spaced_word(names);
    }

    /// A letter and what stands beside it.
    struct Pattern {
        Placed letter;
        Tokens left, right;

        static bool ends(const Tokens& word, const Tokens& end) {
            return end.size() <= word.size() &&
                   std::equal(end.rbegin(), end.rend(), word.rbegin(),
                              [](const Placed& a, const Placed& b) { return a.text == b.text; });
        }
        static bool begins(const Tokens& word, const Tokens& begin) {
            return begin.size() <= word.size() &&
                   std::equal(begin.begin(), begin.end(), word.begin(),
                              [](const Placed& a, const Placed& b) { return a.text == b.text; });
        }
        /// Whether the other matches wherever this one does.
        bool implies(const Pattern& other) const {
            return letter.text == other.letter.text && ends(left, other.left) &&
                   begins(right, other.right);
        }
        /// The least that both match; nothing if they never match together.
        std::optional<Pattern> with(const Pattern& other) const {
            if (letter.text != other.letter.text) return std::nullopt;
            const Tokens& longer_left = left.size() >= other.left.size() ? left : other.left;
            const Tokens& longer_right = right.size() >= other.right.size() ? right : other.right;
            const Pattern both{letter, longer_left, longer_right};
            if (!both.implies(*this) || !both.implies(other)) return std::nullopt;
            return both;
        }
    };
    static Pattern pattern_of(const Rule& rule) {
        const auto at = rule.left.begin() + static_cast<std::ptrdiff_t>(rule.index);
        return {*at, {rule.left.begin(), at}, {at + 1, rule.left.end()}};
    }

    /// The patterns of all rules and their unions, each once.
    std::vector<Pattern> patterns() {
        constexpr std::size_t most = 2000;
        std::vector<Pattern> found;
        const auto add = [&](const Pattern& one) {
            if (std::ranges::none_of(found, [&](const Pattern& other) {
                    return one.implies(other) && other.implies(one);
                }))
                found.push_back(one);
        };
        for (const Rule& rule : rules_) add(pattern_of(rule));
        for (std::size_t i = 0; has_context_ && i < found.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                if (const auto both = found[i].with(found[k])) add(*both);
                if (found.size() > most) {
                    findings_.add(found[i].letter.offset,
                                  "the contexts of " + quoted(found[i].letter.text) +
                                      " match together in too many ways: more than 2000");
                    return {};
                }
            }
        return found;
    }
    std::string context(const Tokens& tokens) {
        std::vector<std::string> names;
        for (const Placed& token : tokens) names.push_back(symbol(token));
        return spaced_word(names);
    }
    std::string module_of_left(const Placed& letter) {
        return module_of_letter(letter, state_of(letter.text));
    }

    std::string rules_text() {
        // All right sides of one left side are one choice. Beside contexts it is one between all productions that match.
        std::vector<std::pair<std::string, std::vector<std::string>>> all;
        for (const Pattern& pattern : patterns()) {
            std::string left = spaced_word({module_of_left(pattern.letter)});
            if (!pattern.left.empty()) left = context(pattern.left) + " < " + left;
            if (!pattern.right.empty()) left += " > " + context(pattern.right);
            std::vector<std::string> rights;
            for (const Rule& rule : rules_)
                if (pattern.implies(pattern_of(rule)))
                    for (const Tokens& right : rule.rights)
                        rights.push_back(word(right, state_of(pattern.letter.text)));
            all.emplace_back(left, std::move(rights));
        }
        std::string text;
        for (const auto& [left, rights] : all) {
            std::map<std::string, std::size_t> counts;
            for (const std::string& right : rights) ++counts[right];
            std::set<std::string> said;
            for (const std::string& right : rights) {
                if (!said.insert(right).second) continue;
                const bool chance = counts.size() > 1;
                text +=
                    left +
                    (chance ? fmt::format(" -({}/{})-> ", counts[right], rights.size()) : " -> ") +
                    right + "\n";
            }
        }
        return text;
    }

    std::string settings() const {
        std::string colours;
        for (const std::string& colour : colours_) colours += " " + colour;
        if (colours.empty() && !colour_.empty()) colours = " " + first_colour();
        const std::string width = parameter("lineWidth");
        return "angle " + parameter("angle") + "\nstep " + unit() +
               "\nstart 0 0 90\nturn clockwise\n" +
               (width == "1" || width.starts_with('-') || width == "0" ? ""
                                                                       : "width " + width + "\n") +
               (colours.empty() || colours == " black" ? "" : "colour" + colours + "\n");
    }

    Source source_;
    Findings findings_;
    Tokens axiom_;
    std::vector<Rule> rules_;
    bool has_context_ = false, is_eighth_ = false;
    std::vector<std::string> listed_;                // symbols of JFLAP 8, the longest first
    std::map<std::string, std::string> parameters_;  // numbers, by their names
    std::string colour_;                             // that of the parameter
    std::vector<std::string> colours_;               // those of `'`
    std::set<std::string> left_sides_;               // letters that are rewritten
    std::set<std::string> varying_;                  // variables that words assign
    std::map<std::string, std::set<std::string>> reads_, changes_;  // by letter
    // Of each letter: what it carries, a number that it always has, or nothing if there are several.
    std::map<std::string, std::map<std::string, std::string>> carried_;
    std::optional<std::pair<Placed, std::pair<std::string, std::string>>> unknown_;
    std::set<std::string> with_value_;  // symbols whose meaning with parameters is said
    std::map<std::string, std::string> symbols_;
    std::string alphabet_, interpretation_;
};

/// A grammar or a finite automaton as a language of claims.
class LanguageReader {
public:
    LanguageReader(std::string_view text, const std::string& name) : source_(text, name) {}

    std::string claim() {
        const Element root = Xml(source_.text(), source_).root();
        const Element* const type = root.child("type");
        const std::string what =
            type ? std::string(trimmed(type->text.text)) : root.attribute("type");
        if (what != "fa" && what != "grammar")
            fail(root.offset, "expected a grammar or a finite automaton of JFLAP, found the type " +
                                  quoted(what));
        const std::string language = what == "fa" ? automaton(root) : grammar(root);
        const std::size_t slash = source_.file().rfind('/');
        return "claim The language of " +
               source_.file().substr(slash == std::string::npos ? 0 : slash + 1) +
               "\nlet A = " + language + "\n";
    }

private:
    [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
        throw Diagnostics({source_.finding(offset, message)});
    }

    /// A terminal as claims write it.
    std::string letter(std::string_view name, std::size_t offset) const {
        if (std::string_view("(){}<>:,;?#=|. \t\"'").find(name) != std::string_view::npos)
            fail(offset, "the letter " + quoted(name) + " is a sign of claims");
        return std::string(name);
    }

    std::string automaton(const Element& root) const {
        const Element* const inside = root.child("automaton");
        const Element& all = inside ? *inside : root;
        std::map<std::string, std::vector<std::string>> rules;
        std::vector<std::string> order;
        std::string start;
        std::set<std::string> letters;
        for (const Element& one : all.children) {
            if (one.name != "transition") continue;
            const Element* const read = one.child("read");
            if (read && !trimmed(read->text.text).empty())
                for (const std::string_view c : characters(trimmed(read->text.text)))
                    letters.emplace(c);
        }
        const auto state = [&](const std::string& id) {
            // Not the name of a letter that is read.
            std::string name = "Q_" + id;
            while (letters.contains(name)) name += "0";
            return name;
        };
        for (const Element& one : all.children) {
            if (one.name != "state") continue;
            const std::string id = one.attribute("id");
            if (id.empty() || id.find_first_not_of("0123456789") != std::string::npos)
                fail(one.offset, "expected a state with a number as id");
            order.push_back(id);
            rules[id];
            if (one.child("initial")) start = id;
            if (one.child("final")) rules[id].push_back("ε");
        }
        if (start.empty()) fail(all.offset, "expected a state with <initial/>, found none");
        for (const Element& one : all.children) {
            if (one.name != "transition") continue;
            const Element *const from = one.child("from"), *const to = one.child("to"),
                                 *const read = one.child("read");
            const std::string source(from ? trimmed(from->text.text) : std::string_view()),
                target(to ? trimmed(to->text.text) : std::string_view());
            if (!rules.contains(source) || !rules.contains(target))
                fail(one.offset, "expected a transition from a state to a state");
            std::string word;
            if (read)
                for (const std::string_view c : characters(trimmed(read->text.text)))
                    word += letter(c, read->offset) + " ";
            rules[source].push_back(word + state(target));
        }
        std::string text = "regular { start " + state(start);
        for (const std::string& id : order)
            for (const std::string& word : rules[id]) text += "; " + state(id) + " -> " + word;
        return text + " }";
    }

    std::string grammar(const Element& root) const {
        std::string text = "CF { ";
        std::size_t count = 0;
        for (const Element& one : root.children) {
            if (one.name != "production") continue;
            const Element *const left = one.child("left"), *const right = one.child("right");
            const std::string from(left ? trimmed(left->text.text) : std::string_view());
            if (!is_character(from))
                fail(one.offset,
                     "expected one letter on the left, as in context-free grammars, "
                     "found " +
                         quoted(from));
            std::string word;
            if (right)
                for (const std::string_view c : characters(trimmed(right->text.text)))
                    word += letter(c, right->offset);
            text += (count++ > 0 ? "; " : "") + from + " -> " + (word.empty() ? "ε" : word);
        }
        if (count == 0) fail(root.offset, "expected <production>, found none");
        return text + " }";
    }

    Source source_;
};

/// Writes a system as a file.
class Writer : FormatWriter {
public:
    explicit Writer(const Model& system) : FormatWriter(system, "jff") {}

    std::string written() {
        check_plain_rules(true);
        check_plain_settings();
        const Drawing& drawing = system_.drawing;
        if (!system_.coding.empty()) refuse("a coding");
        if (!is_usual(drawing.shrink, 1))
            refuse("that steps shrink from one generation to the next");
        if (!is_usual(drawing.spin, 0)) refuse("a spin");
        if (!drawing.stamps.empty()) refuse("stamps");
        if (!drawing.solids.empty()) refuse("solids");
        for (Symbol a = 0; a < system_.alphabet.size(); ++a) name_token(a);
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
        if (does.empty() && (commands.contains(chosen) ||
                             chosen.find_first_of("(=") != std::string::npos || is_integer(chosen)))
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

Model read_jflap(std::string_view text, const std::string& name) {
    return Reader(text, name).read();
}

std::string language_of_jflap(std::string_view text, const std::string& name) {
    return LanguageReader(text, name).claim();
}

std::string print_jflap(const Model& system) { return Writer(system).written(); }

}  // namespace algae
