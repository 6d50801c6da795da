#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/formats.hpp"
#include "exchange/detail/jflap.hpp"
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
// and nothing is skipped.
//
// JFLAP 8 writes `<structure type="lsystem">` with the parts in structures of their own, `<lhs>` and `<rhs>`, and words without blanks: they
// are cut into the symbols that the file lists, the longest first; a character that begins none of them is one itself.
//
// A finite automaton becomes a right-linear grammar, `regular { ... }`, with a letter for each state; a grammar whose left sides are single letters
// is written as it stands, `CF { ... }`.

namespace algae {

namespace {

constexpr std::size_t most_depth = 100;

struct Element {
    std::string name;
    std::size_t offset = 0;
    JflapToken text;
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
                    fail(at_, "expected an element of XML, such as <structure>, found " +
                                  quoted(trimmed(text_.substr(at_, end - at_)).substr(0, 40)));
                at_ = end;
            } else if (text_.substr(at_).starts_with("<!--")) {
                skip("-->", "the comment is never closed");
            } else if (text_.substr(at_).starts_with("<![CDATA[")) {
                const std::size_t begin = at_ + std::string_view("<![CDATA[").size();
                skip("]]>", "<![CDATA[ is never closed");
                if (open.empty()) fail(begin, "expected an element of XML, found text");
                JflapToken& text = open.back().text;
                if (text.text.empty()) text.offset = begin;
                text.text += text_.substr(begin, at_ - 3 - begin);
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

/// Reads an L-system.
class Reader {
public:
    explicit Reader(const Source& source) : source_(source), findings_(source_) {
        findings_.throw_if_no_text();
    }

    JflapSystem read() {
        const Element root = Xml(source_.text(), source_).root();
        if (root.name != "structure")
            fail(root.offset, "expected <structure>, found <" + root.name + ">");
        check_type(root);
        const Element* axiom = nullptr;
        if (is_eighth_) find_symbols(root);
        std::ranges::stable_sort(listed_, std::greater<>(), &std::string::size);
        read_parts(root, axiom);
        if (!axiom) findings_.add(root.offset, "expected an <axiom>, found none");
        if (axiom) system_.axiom = tokens(axiom->text);
        findings_.throw_if_any();
        return std::move(system_);
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

    JflapWord tokens(const JflapToken& text) const {
        JflapWord found;
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
        JflapRule rule;
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
            if (!is_jflap_index(rule.left[0].text))
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
            system_.has_context = system_.has_context || rule.left.size() > 1;
        }
        for (const Element& child : production.children)
            if (child.name == right_name) rule.rights.push_back(tokens(child.text));
        if (rule.rights.empty())
            return findings_.add(production.offset, std::string("expected <") + right_name +
                                                        "> in a production, found none");
        system_.rules.push_back(std::move(rule));
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
        if (is_jflap_colour(what)) {
            if (what == "color") system_.colour = number;
            return;
        }
        const bool minus = number.starts_with('-');
        const std::string digits = number.substr(minus ? 1 : 0);
        const bool is_number = !digits.empty() && number_size(digits) == digits.size() &&
                               digits.find_first_of("eE") == std::string::npos;
        const std::string name_here = jflap_variable(what);
        if (!is_number) {
            if (name_here != "angle" && name_here != "distance") return;  // of the program's window
            return findings_.add(value->text.offset,
                                 "expected a number as " + what + ", found " + quoted(number));
        }
        system_.parameters[name_here] = (minus ? "-" : "") +
                                        (digits.starts_with('.') ? "0" : std::string()) +
                                        plain_number(digits);
    }

    const Source& source_;
    Findings findings_;
    JflapSystem system_;
    bool is_eighth_ = false;
    std::vector<std::string> listed_;  // symbols of JFLAP 8, the longest first
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

}  // namespace

Model read_jflap(std::string_view text, const std::string& name) {
    const Source source(text, name);
    return jflap_model(source, Reader(source).read());
}

std::string language_of_jflap(std::string_view text, const std::string& name) {
    return LanguageReader(text, name).claim();
}

}  // namespace algae
