#include <fmt/format.h>

#include <algorithm>
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
// and nothing is skipped. JFLAP picks one of all productions that match; the notation prefers longer contexts, so a letter whose
// productions have contexts of different lengths is refused.
//
// JFLAP 8 writes `<structure type="lsystem">` with the parts in structures of their own, `<lhs>` and `<rhs>`, and words without blanks: they
// are cut into the symbols that the file lists, the longest first; a character that begins none of them is one itself.
//
// A finite automaton becomes a right-linear grammar, `regular { ... }`, with a letter for each state; a grammar whose left sides are single letters
// is written as it stands, `CF { ... }`.
//
// The turtle starts upward, + turns to the right, g draws, % turns back, * rolls left. Tokens with a number, `g(2)`, are symbols of their
// own, `g·2`. Assignments, `angle=20`, change what later symbols do, which has no meaning in the notation. Hues and widths of lines are
// no part of the figures here.

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
        std::string rules = "axiom " + word(axiom_) + "\n";
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
        if (what != "angle" && what != "angleIncrement" && what != "distance")
            return;  // colours, widths, variables
        const bool minus = number.starts_with('-');
        const std::string digits = number.substr(minus ? 1 : 0);
        if (digits.empty() || number_size(digits) != digits.size() ||
            digits.find_first_of("eE") != std::string::npos)
            return findings_.add(value->text.offset,
                                 "expected a number as " + what + ", found " + quoted(number));
        (what == "distance" ? distance_ : angle_) =
            (minus ? "-" : "") + (digits.starts_with('.') ? "0" : std::string()) +
            plain_number(digits);
    }

    /// The symbol of the notation for a token, with what it does to the turtle said.
    std::string symbol(const Placed& token) {
        const auto [known, is_new] = symbols_.emplace(token.text, "");
        if (!is_new) return known->second;
        std::string name = token.text, number;
        const auto give_up = [&](const std::string& why) {
            findings_.add(token.offset, why);
            return known->second = "X";
        };
        if (name.find('=') != std::string::npos)
            return give_up("the assignment " + quoted(name) +
                           " changes what later symbols do, which has no meaning in the notation");
        const std::size_t open = name.find('(');
        if (open != std::string::npos && open > 0 && name.ends_with(')')) {
            number = name.substr(open + 1, name.size() - open - 2);
            const std::string digits = number.substr(number.starts_with('-') ? 1 : 0);
            if (digits.empty() || number_size(digits) != digits.size() ||
                digits.find_first_of("eE") != std::string::npos)
                return give_up("expected a number between the brackets of " + quoted(name) +
                               "; variables have no meaning in the notation");
            number = (number.starts_with('-') ? "-" : "") +
                     (digits.starts_with('.') ? "0" : std::string()) + plain_number(digits);
            name = name.substr(0, open);
        }
        const std::string command = name;
        if (is_character(name) &&
            std::string_view("()<>:,;?#=").find(name) != std::string_view::npos)
            name = fmt::format("X_{}", static_cast<unsigned char>(name[0]));
        else if (name.find_first_of("()<>:,;?") != std::string::npos)
            return give_up(quoted(token.text) +
                           " is no symbol of the notation, which has no ( ) < > : , ; ? in names");
        std::ranges::replace(name, '#', '\x01');
        for (std::size_t at = name.find('\x01'); at != std::string::npos; at = name.find('\x01'))
            name.replace(at, 1, "♯");
        if (!number.empty()) name += "·" + number;
        for (const auto& [other, taken] : symbols_)
            if (taken == name)
                return give_up(quoted(token.text) + " and " + quoted(other) +
                               " would be one symbol");
        known->second = name;
        if (undeclared_length(name) != name.size()) alphabet_ += " " + name;
        const std::string does = meaning(command, number);
        if (does != name && (does != "ε" || acts(name)))
            interpretation_ += "interpret " + name + " -> " + does + "\n";
        return name;
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
            return number.empty() ? step : step + "(" + number + "/(" + distance_ + "))";
        }
        for (const auto& [name, does] :
             {std::pair("+", "+"), {"-", "-"}, {"&", "&"}, {"^", "^"}, {"/", "/"}, {"*", "\\"}})
            if (token == name) return does + degrees;
        if (token == "%") return "|";
        if (token == "[" || token == "]" || token == "{" || token == "}") return token;
        return "ε";
    }

    std::string word(const Tokens& tokens) {
        std::vector<std::string> names;
        for (const Placed& one : tokens) names.push_back(symbol(one));
        return spaced_word(names);
    }

    std::string rules_text() {
        // All right sides of one left side are one choice.
        std::vector<std::pair<std::string, std::vector<std::string>>> all;
        std::map<std::string, std::pair<std::size_t, std::size_t>>
            lengths;  // of contexts, by the letter
        for (const Rule& rule : rules_) {
            const Placed& letter = rule.left[rule.index];
            const std::pair context{rule.index, rule.left.size() - rule.index - 1};
            if (const auto [known, is_new] = lengths.emplace(letter.text, context);
                has_context_ && !is_new && known->second != context)
                findings_.add(letter.offset,
                              "the productions of " + quoted(letter.text) +
                                  " have contexts of different lengths, of which JFLAP picks any "
                                  "that match and the notation the longest");
            if (has_context_)
                for (const Placed& one : rule.left)
                    if (one.text == "[" || one.text == "]")
                        findings_.add(one.offset,
                                      "brackets are letters in contexts of JFLAP, and branches in "
                                      "the notation");
            const auto part = [&](std::size_t begin, std::size_t end) {
                return word({rule.left.begin() + static_cast<std::ptrdiff_t>(begin),
                             rule.left.begin() + static_cast<std::ptrdiff_t>(end)});
            };
            std::string left = part(rule.index, rule.index + 1);
            if (rule.index > 0) left = part(0, rule.index) + " < " + left;
            if (rule.index + 1 < rule.left.size())
                left += " > " + part(rule.index + 1, rule.left.size());
            auto known = std::ranges::find(
                all, left, &std::pair<std::string, std::vector<std::string>>::first);
            if (known == all.end()) known = all.insert(all.end(), {left, {}});
            for (const Tokens& right : rule.rights) known->second.push_back(word(right));
        }
        if (has_context_ && (symbols_.contains("[") || symbols_.contains("]")))
            findings_.add(
                rules_.front().left.front().offset,
                "brackets are letters beside contexts in JFLAP, and branches in the notation");
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
        return "angle " + angle_ + "\nstep " + distance_ + "\nstart 0 0 90\nturn clockwise\n";
    }

    Source source_;
    Findings findings_;
    Tokens axiom_;
    std::vector<Rule> rules_;
    bool has_context_ = false, is_eighth_ = false;
    std::vector<std::string> listed_;  // symbols of JFLAP 8, the longest first
    std::string angle_ = "15", distance_ = "15";
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
