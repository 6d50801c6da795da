#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/detail/scanner.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"

// L-systems of cpfg (`*.l`), and the declarative parts of L-Py (`*.lpy`) and of lpfg (`*.l`): contexts, parameters, conditions, choices, a homomorphism.
//
//     #define STEP 2                        s = 2                        # L-Py
//     Lsystem: 1                            Axiom: A(1)
//     derivation length: 3                  derivation length: 3
//     Axiom: A(1)                           production:
//     A(x) : x < 4 --> F(x)+A(x*STEP)       A(x) --> F(x)+A(x*s)
//     endlsystem                            endlsystem
//
// A file of cpfg is read as its preprocessor leaves it: comments are gone and `#define` is replaced, each character keeping the place where
// it stood. Then lines are joined where the next one begins with a tabulator. Each module is a single character; in L-Py a name that `module`
// declares is one symbol. Reading writes a text of the notation, with each expression in brackets as the program groups it.
//
// Meanings differ, and each difference is either said in the notation or refused. cpfg tries the rules of a module in the order of the file
// and takes the first that applies; the notation takes the one with the longest contexts. So a rule behind another with the same contexts, or
// with none, gets the negation of the earlier condition, one that can never be reached is left out, and other rules with longer contexts
// behind shorter ones are refused. A decomposition, which rewrites what a rule gives within the same step, is put into the successors. A branch
// in a right context, `A > [B]C`, is the whole branch there and the beginning of one in the notation: it is read where no other
// letter can follow in it. `[B=]C` is the beginning. Commands of several symbols, `@v`, are one symbol each, by which a rule for a part of
// the last of them is one for the command too. With `seed:` all rules that apply take part with their weights: those of one module must have the
// same contexts here. A block of `produce`, `if` and `else` is a rule with conditions for each `produce`, in this order. The turtle looks up the page, `+` turns to the left, by 45 degrees where no view file says otherwise, in L-Py by 60.
// cpfg's `/` rolls the other way than that of the notation, where it is `\`; that of L-Py is the same. In expressions of cpfg `^` groups
// from the left and a sign binds tighter than it, so -2^2 is 4; parameters are numbers of 32 bits there, which nothing here imitates.

namespace algae {

namespace {

/// A module: its symbol and the texts of its arguments.
struct Module {
    std::string symbol;
    std::size_t place = 0;
    std::vector<Placed> arguments;
    bool has_arguments = false;
    bool open = false;  // in a context: `=` stands behind it
};

struct Rule {
    std::vector<Module> left, right;
    Module predecessor;
    std::vector<Module> several;  // a predecessor of more than one module
    std::optional<Placed> condition, weight;
    Placed successor;
    std::size_t place = 0;

    std::string letter() const {
        return predecessor.symbol + "/" + std::to_string(predecessor.arguments.size());
    }
    /// Modules of both contexts; brackets do not count where the longest context is chosen.
    std::size_t reach() const {
        std::size_t count = 0;
        for (const auto* side : {&left, &right})
            for (const Module& module : *side)
                count += module.symbol == "[" || module.symbol == "]" ? 0 : 1;
        return count;
    }
};

class Reader {
public:
    /// Of several systems of a file of cpfg `entry` is the label of one.
    Reader(std::string_view text, const std::string& name, const CpfgDialect& dialect,
           std::string entry = {})
        : dialect_(dialect),
          text_(text),
          source_(text_, name),
          findings_(source_),
          entry_(std::move(entry)) {}

    Model read() {
        const Placed whole = preprocessed(source_, dialect_);
        if (dialect_.python) generation_ = "1";
        if (dialect_.python)
            read_python(whole);
        else if (dialect_.plus)
            read_plus(whole);
        else
            read_cpfg(whole);
        if (axiom_.text.empty()) fail(0, "expected an axiom, found none");
        const std::string text = notation();
        findings_.throw_if_any();
        try {
            return read_lsystem(text, source_.file());
        } catch (const Diagnostics& error) {
            // What the notation refuses of a text that is written here is refused as a whole.
            fail(0, "the notation cannot say this system: " + error.findings().front().message);
        }
    }

private:
    [[noreturn]] void fail(std::size_t place, const std::string& message) const {
        throw Diagnostics({source_.finding(std::min(place, text_.size()), message)});
    }
    [[noreturn]] void refuse(std::size_t place, const std::string& what,
                             const std::string& why) const {
        fail(place, what + " " + why);
    }

    /// Lines, joined where the next one begins with a tabulator, or within brackets.
    std::vector<Placed> statements(const Placed& whole) const {
        std::vector<Placed> out(1);
        int open = 0;
        for (std::size_t i = 0; i < whole.text.size(); ++i) {
            const char c = whole.text[i];
            if (c == '(') ++open;
            if (c == ')') open = std::max(0, open - 1);
            const bool goes_on =
                !dialect_.python && i + 1 < whole.text.size() && whole.text[i + 1] == '\t';
            if (c != '\n') {
                out.back().add(c, whole.at[i]);
            } else if (goes_on || (open > 0 && dialect_.python)) {
                out.back().add(' ', whole.at[i]);
            } else {
                out.emplace_back();
                open = 0;
            }
        }
        return out;
    }

    // --- Files ---

    /// What stands behind one of these keywords at the start of a line, blanks in it being optional; nothing if none does.
    static std::optional<Placed> behind(const Placed& line,
                                        std::initializer_list<const char*> keywords) {
        for (const char* keyword : keywords) {
            std::size_t at = 0;
            bool fits = true;
            for (const char* c = keyword; *c && fits; ++c) {
                if (*c == ' ') {
                    while (at < line.text.size() && line.text[at] == ' ') ++at;
                } else {
                    fits = at < line.text.size() && line.text[at++] == *c;
                }
            }
            if (fits) return line.part(at, line.text.size()).trimmed();
        }
        return std::nullopt;
    }

    static bool is_end(const Placed& said) {
        return said.text == "endlsystem" || said.text == "Endlsystem" || said.text == "EndLsystem";
    }

    /// The lines of the system that is meant, with that of its label and its end.
    std::vector<Placed> system_lines(std::vector<Placed> lines) const {
        struct Part {
            std::string label;
            std::size_t begin = 0, end = 0, place = 0;
        };
        std::vector<Part> parts;
        bool inside = false;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Placed said = lines[i].trimmed();
            if (inside) {
                parts.back().end = i + 1;
                inside = !is_end(said);
                continue;
            }
            if (said.text.empty()) continue;
            const std::size_t place = said.at.front();
            const auto label = behind(said, {"Lsystem:", "lsystem:"});
            if (!label)
                fail(place, parts.empty()
                                ? "expected 'Lsystem: 1', found '" + said.text.substr(0, 40) + "'"
                                : "expected another 'Lsystem:' or the end of the file "
                                  "behind 'endlsystem', found '" +
                                      said.text.substr(0, 40) + "'");
            parts.push_back({label->text, i, i + 1, place});
            inside = true;
        }
        if (parts.empty()) fail(0, "expected 'Lsystem: 1', found none");
        if (inside) fail(text_.size(), "expected 'endlsystem', found the end of the file");
        std::vector<std::string> labels;
        for (const Part& part : parts) labels.push_back(part.label);
        const auto named = std::ranges::find(labels, entry_);
        if (entry_.empty() && parts.size() > 1)
            fail(parts[1].place, "a second system: say which of " + joined(labels, ", ") +
                                     " is meant, as in " + source_.file() + ":" + labels[0]);
        if (!entry_.empty() && named == labels.end())
            fail(parts[0].place, "there is no system " + quoted(entry_) +
                                     did_you_mean(entry_, labels) + "; there is " +
                                     joined(labels, ", "));
        const Part& chosen =
            entry_.empty() ? parts[0] : parts[static_cast<std::size_t>(named - labels.begin())];
        return {lines.begin() + static_cast<std::ptrdiff_t>(chosen.begin),
                lines.begin() + static_cast<std::ptrdiff_t>(chosen.end)};
    }

    void read_cpfg(const Placed& whole) {
        enum { before, header, rules, decomposition, homomorphism, after } state = before;
        bool has_rules = false;  // a rule or an empty line
        for (const Placed& line : system_lines(statements(whole))) {
            const Placed said = line.trimmed();
            has_rules = has_rules || (state == rules && said.text != "endlsystem");
            if (said.text.empty()) continue;
            const std::size_t place = said.at.front();
            if (state == before) {
                state = header;
                continue;
            }
            if (is_end(said)) {
                if (!has_rules)
                    fail(place, "expected a rule or an empty line before '" + said.text + "'");
                state = after;
                continue;
            }
            if (line.text.front() == ' ' && state != header)
                fail(place,
                     "a line that begins with a blank: expected a tabulator, which continues "
                     "the line above, or nothing");
            if (state == header && read_header(said)) continue;
            if (const auto value = behind(said, {"Axiom:", "axiom:"})) {
                if (state != header) fail(place, "a second axiom");
                axiom_ = *value;
                state = rules;
                continue;
            }
            if (behind(said, {"decomposition"})) {
                state = decomposition;
                continue;
            }
            if (behind(said, {"homomorphism"})) {
                state = homomorphism;
                continue;
            }
            if (const auto depth = behind(said, {"maximum depth:"}); depth && state > rules) {
                (state == decomposition ? depth_ : drawn_depth_) = number(*depth, "a depth");
                continue;
            }
            if (state == homomorphism && behind(said, {"seed:"}))
                refuse(place, "a homomorphism with choices", "has no meaning in the notation");
            if (state == header)
                fail(place, "expected a line of the header or 'Axiom:', found '" +
                                said.text.substr(0, 40) + "'");
            (state == rules           ? rules_
             : state == decomposition ? decomposition_
                                      : interpretation_)
                .push_back(rule(said));
        }
    }

    /// A line of the header of cpfg, or of the declarations of L-Py.
    bool read_header(const Placed& said) {
        const std::size_t place = said.at.front();
        if (const auto value = behind(said, {"derivation length:", "Derivation length:"})) {
            generation_ = std::to_string(number(*value, "a derivation length"));
            return true;
        }
        if (const auto value = behind(said, {"seed:", "Seed:"})) {
            stochastic_ = true;
            return true;
        }
        if (const auto value = behind(said, {"ignore:", "Ignore:"})) {
            ignored_ = *value;
            considered_.reset();
            return true;
        }
        if (const auto value = behind(said, {"consider:", "Consider:"})) {
            considered_ = *value;
            ignored_.reset();
            return true;
        }
        if (behind(said, {"ring lsystem", "Ring lsystem"}))
            refuse(place, "a ring",
                   "joins the ends of a word, which has no meaning in the notation");
        if (behind(said, {"define:", "Define:"}))
            refuse(place, "arrays", "have no meaning in the notation");
        for (const char* block : {"Start:", "StartEach:", "EndEach:", "End:"})
            if (behind(said, {block}))
                refuse(place, std::string("the block ") + block,
                       "holds statements, which have no meaning in the notation");
        return false;
    }

    /// The whole number from 0 on that an expression of constants is.
    std::uint64_t number(const Placed& text, const char* what) const {
        const auto none = [](const std::string&) -> const Quantity* { return nullptr; };
        constexpr int most = 1'000'000'000;
        try {
            const Quantity value = evaluate(read_expression(expression(text, {})), none);
            if (value.exact && value.exact->is_integer() && sign(*value.exact) >= 0 &&
                *value.exact <= Rational(most))
                return floor(*value.exact).to_uint64();
        } catch (const Diagnostics&) {
        }
        fail(text.place(0), std::string("expected ") + what +
                                ", a whole number from 0 on, found '" + text.text + "'");
    }

    void read_python(const Placed& whole) {
        enum { header, rules, decomposition, homomorphism, after } state = header;
        const std::vector<Placed> lines = statements(whole);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Placed said = lines[i].trimmed();
            if (said.text.empty() || state == after) continue;
            const std::size_t place = said.at.front();
            if (said.text == "endlsystem") {
                state = after;
                continue;
            }
            if (behind(said, {"production:"})) {
                state = rules;
                continue;
            }
            if (behind(said, {"homomorphism:", "interpretation:"})) {
                state = homomorphism;
                continue;
            }
            if (behind(said, {"decomposition:"})) {
                state = decomposition;
                continue;
            }
            for (const char* word : {"group", "endgroup"})
                if (said.text.starts_with(word))
                    refuse(place, "groups", "have no meaning in the notation");
            if (const auto depth = behind(said, {"maximum depth:"})) {
                (state == decomposition ? depth_ : drawn_depth_) = number(*depth, "a depth");
                continue;
            }
            if (const auto value = behind(said, {"Axiom:", "axiom:"})) {
                axiom_ = *value;
                continue;
            }
            if (state == header && read_header(said)) continue;
            if (const auto names = behind(said, {"module "})) {
                std::string name;
                for (const char c : names->text + ",") {
                    if (is_name_part(c))
                        name += c;
                    else if (c == '(')
                        break;
                    else if (!name.empty()) {
                        modules_.push_back(name);
                        name.clear();
                    }
                }
                continue;
            }
            std::vector<Rule>& all = state == homomorphism    ? interpretation_
                                     : state == decomposition ? decomposition_
                                                              : rules_;
            if (said.text.find("-->") != std::string::npos) {
                all.push_back(rule(said));
                continue;
            }
            if (const std::size_t colon = outside(said.text, ':');
                state != header && colon != std::string::npos) {
                const Rule found = head_of(said.part(0, colon));
                i = python_block(lines, i, colon, found, {}, all);
                continue;
            }
            const std::size_t equals = said.text.find('=');
            const std::string name = said.part(0, equals).trimmed().text;
            if (state == header && equals != std::string::npos && !name.empty() &&
                is_name_start(name[0]) && std::ranges::all_of(name, is_name_part)) {
                constants_.emplace_back(name, said.part(equals + 1, said.text.size()).trimmed());
                continue;
            }
            refuse(place, "a line of Python",
                   "is not read: expected `NAME = number` or a rule with -->; found '" +
                       said.text.substr(0, 40) + "'");
        }
    }

    // --- Blocks with produce ---

    /// A rule for each `produce`, with the conditions that lead to it; the first that applies is used there too, and where none
    /// does the block falls through and the rule is not used.
    void add_produced(std::vector<Rule>& all, const Rule& head, const std::vector<Placed>& path,
                      Placed successor, std::size_t place) const {
        Rule one = head;
        one.place = place;
        successor = successor.trimmed();
        if (successor.text == "*") successor = {};
        one.successor = std::move(successor);
        if (!path.empty()) {
            Placed condition;
            for (const Placed& part : path) {
                const std::size_t at = part.place(0);
                if (!condition.text.empty())
                    for (const char c : std::string_view(dialect_.python ? " and " : " && "))
                        condition.add(c, at);
                condition.append(part);
            }
            one.condition = std::move(condition);
        }
        all.push_back(std::move(one));
    }
    /// The condition in brackets, or its negation.
    Placed side(const Placed& condition, bool holds) const {
        Placed out;
        const std::size_t place = condition.place(0);
        if (!holds)
            for (const char c : std::string_view(dialect_.python ? "not " : "!")) out.add(c, place);
        out.add('(', place);
        out.append(condition);
        out.add(')', place);
        Placed whole;
        whole.add('(', place);
        whole.append(out);
        whole.add(')', place);
        return whole;
    }

    static std::size_t indent_of(const Placed& line) {
        std::size_t columns = 0;
        for (const char c : line.text) {
            if (c == '\t')
                columns = columns / 8 * 8 + 8;
            else if (c == ' ')
                ++columns;
            else
                break;
        }
        return columns;
    }

    /// Reads what stands behind the colon at `colon` of the trimmed line `i`: statements on the line itself, or on lines that are indented
    /// deeper. Gives the last line that it read.
    std::size_t python_block(const std::vector<Placed>& lines, std::size_t i, std::size_t colon,
                             const Rule& head, const std::vector<Placed>& path,
                             std::vector<Rule>& all) {
        const Placed said = lines[i].trimmed();
        const Placed rest = said.part(colon + 1, said.text.size()).trimmed();
        if (!rest.text.empty()) {
            python_statement(rest, head, path, all);
            return i;
        }
        const std::size_t outer = indent_of(lines[i]);
        std::size_t last = i, inner = 0;
        std::vector<Placed> failed;  // the conditions of `if` and `elif` that came before an `else`
        bool chained = false, some = false;
        for (std::size_t k = i + 1; k < lines.size(); ++k) {
            const Placed line = lines[k].trimmed();
            if (line.text.empty()) continue;
            const std::size_t depth = indent_of(lines[k]), place = line.at.front();
            if (depth <= outer) break;
            if (!some) inner = depth;
            some = true;
            if (depth != inner)
                fail(place, "expected the indentation of the lines of this block, " +
                                std::to_string(inner) + " columns, found " + std::to_string(depth));
            last = k;
            const auto word = [&](std::string_view wanted) {
                return line.text.starts_with(wanted) && (line.text.size() == wanted.size() ||
                                                         !is_name_part(line.text[wanted.size()]));
            };
            const bool is_if = word("if"), is_elif = word("elif"), is_else = word("else");
            if (!is_if && !is_elif && !is_else) {
                chained = false;
                python_statement(line, head, path, all);
                continue;
            }
            if (!is_if && !chained)
                fail(place, std::string(is_elif ? "elif" : "else") + " without if");
            const std::size_t end = outside(line.text, ':');
            if (end == std::string::npos)
                fail(place,
                     "expected ':' behind the condition of '" + line.text.substr(0, 40) + "'");
            if (is_if) failed.clear();
            chained = !is_else;
            std::vector<Placed> inside = path;
            inside.insert(inside.end(), failed.begin(), failed.end());
            if (!is_else) {
                const Placed condition = line.part(is_if ? 2 : 4, end).trimmed();
                if (condition.text.empty())
                    fail(place, "expected a condition behind '" + line.text.substr(0, end) + "'");
                inside.push_back(side(condition, true));
                failed.push_back(side(condition, false));
            }
            k = last = python_block(lines, k, end, head, inside, all);
        }
        if (!some) fail(said.place(colon), "expected a block with produce behind ':', found none");
        return last;
    }

    void python_statement(const Placed& said, const Rule& head, const std::vector<Placed>& path,
                          std::vector<Rule>& all) const {
        const std::size_t place = said.at.front();
        if (said.text == "pass") return;
        if (said.text == "produce" || said.text.starts_with("produce ")) {
            add_produced(all, head, path, said.part(7, said.text.size()), place);
            return;
        }
        if (said.text.starts_with("nproduce"))
            refuse(place, "nproduce",
                   "goes on behind what it makes, which is not read: expected produce");
        refuse(place, "a line of Python",
               "is not read: expected produce, if, elif or else; found '" +
                   said.text.substr(0, 40) + "'");
    }

    // --- lpfg ---

    /// Where something stands next in a text of L+C that is no blank.
    static std::size_t next(const Placed& text, std::size_t at) {
        while (at < text.text.size() && std::isspace(static_cast<unsigned char>(text.text[at])))
            ++at;
        return at;
    }
    /// Where the bracket closes that stands at this place.
    std::size_t closing(const Placed& text, std::size_t at) const {
        const char open = text.text[at], close = open == '(' ? ')' : '}';
        int depth = 0;
        for (std::size_t i = at; i < text.text.size(); ++i) {
            if (text.text[i] == open) ++depth;
            if (text.text[i] == close && --depth == 0) return i;
        }
        fail(text.place(at), std::string("unmatched '") + open + "'");
    }
    /// The name at this place; empty if there is none.
    static std::string name_at(const Placed& text, std::size_t at) {
        std::size_t end = at;
        if (end < text.text.size() && is_name_start(text.text[end]))
            while (end < text.text.size() && is_name_part(text.text[end])) ++end;
        return text.text.substr(at, end - at);
    }
    static std::string shown(const Placed& text, std::size_t at) {
        const std::string rest = text.text.substr(at, 40);
        return at >= text.text.size() ? "the end of the file"
                                      : "'" + rest.substr(0, rest.find('\n')) + "'";
    }

    /// What stands up to the `;`, behind a keyword.
    Placed up_to_semicolon(const Placed& text, std::size_t from, std::size_t& at) const {
        const std::size_t end = text.text.find(';', from);
        if (end == std::string::npos)
            fail(text.place(from), "expected ';' behind " + shown(text, at) + ", found none");
        at = end + 1;
        return text.part(from, end).trimmed();
    }

    void read_plus(const Placed& text) {
        std::vector<Rule>* rules = &rules_;
        for (std::size_t at = next(text, 0); at < text.text.size(); at = next(text, at)) {
            const std::size_t place = text.place(at);
            const Placed rest = text.part(at, text.text.size());
            const auto keyword = [&](std::initializer_list<const char*> words) {
                const std::optional<std::size_t> size = keyword_size(rest, words);
                if (size) at += *size;
                return size.has_value();
            };
            if (text.text[at] == ';') {
                ++at;
            } else if (keyword({"derivation length:"})) {
                generation_ =
                    std::to_string(number(up_to_semicolon(text, at, at), "a derivation length"));
            } else if (keyword({"maximum depth:"})) {
                const std::uint64_t depth = number(up_to_semicolon(text, at, at), "a depth");
                if (rules == &decomposition_) depth_ = depth;
                if (rules == &interpretation_) drawn_depth_ = depth;
            } else if (keyword({"Axiom:", "axiom:"})) {
                if (!axiom_.text.empty()) fail(place, "a second axiom");
                axiom_ = up_to_semicolon(text, at, at);
            } else if (keyword({"ignore:"})) {
                ignored_ = up_to_semicolon(text, at, at);
                considered_.reset();
            } else if (keyword({"consider:"})) {
                considered_ = up_to_semicolon(text, at, at);
                ignored_.reset();
            } else if (keyword({"production:", "productions:"})) {
                rules = &rules_;
            } else if (keyword({"decomposition:"})) {
                rules = &decomposition_;
            } else if (keyword({"homomorphism:", "interpretation:"})) {
                rules = &interpretation_;
            } else if (keyword({"ring L-system:", "ring lsystem:"})) {
                refuse(place, "a ring",
                       "joins the ends of a word, which has no meaning in the notation");
            } else if (keyword({"StartEach:", "Start:", "EndEach:", "End:"})) {
                at = next(text, at);
                if (at == text.text.size() || text.text[at] != '{')
                    fail(text.place(at), "expected a block { ... }, found " + shown(text, at));
                const std::size_t end = closing(text, at);
                if (!text.part(at + 1, end).trimmed().text.empty())
                    refuse(place, "the block " + rest.text.substr(0, rest.text.find(':') + 1),
                           "holds statements of C++, which have no meaning in the notation");
                at = end + 1;
            } else if (const std::string word = name_at(text, at); word == "module") {
                declare_module(up_to_semicolon(text, at + word.size(), at));
            } else if (word == "const") {
                constant_of(up_to_semicolon(text, at + word.size(), at));
            } else {
                at = plus_rule(text, at, *rules);
            }
        }
    }

    static std::optional<std::size_t> keyword_size(const Placed& text,
                                                   std::initializer_list<const char*> words) {
        for (const char* word : words) {
            std::size_t at = 0;
            bool fits = true;
            for (const char* c = word; *c && fits; ++c) {
                if (*c == ' ') {
                    const std::size_t from = at;
                    at = next(text, at);
                    fits = at > from;
                } else {
                    if (*c == ':') at = next(text, at);
                    fits = at < text.text.size() && text.text[at++] == *c;
                }
            }
            if (fits) return at;
        }
        return std::nullopt;
    }

    /// `Apex(int, float)`
    void declare_module(const Placed& said) {
        const std::string name = name_at(said, 0);
        const std::size_t open = next(said, name.size());
        const bool is_whole = open < said.text.size() && said.text[open] == '(';
        if (name.empty() || (!is_whole && open != said.text.size()))
            fail(said.place(name.size()),
                 "expected a module as in `module Apex(float);`, found " + shown(said, 0));
        std::vector<std::string> types;
        if (is_whole) {
            const std::size_t end = closing(said, open);
            std::string type;
            for (const char c : said.text.substr(open + 1, end - open - 1) + ",") {
                if (c != ',') {
                    type += c;
                    continue;
                }
                Placed one;
                for (const char letter : type) one.add(letter, said.place(open));
                type = one.trimmed().text;
                if (type != "int" && type != "float" && type != "double" && !type.empty() &&
                    type != "void")
                    refuse(said.place(open), "a parameter of the type " + type,
                           "has no meaning in the notation: expected int, float or double");
                if (!type.empty() && type != "void") types.push_back(type);
                type.clear();
            }
        }
        if (name.starts_with("F_") || name.starts_with("f_"))
            fail(said.place(0), "the turtle of the notation draws and moves with names such as " +
                                    name + ": expected another name");
        modules_.push_back(name);
        types_[name] = types;
    }

    /// `float STEP = 2`
    void constant_of(const Placed& said) {
        const std::string type = name_at(said, 0);
        const std::size_t at = next(said, type.size());
        const std::string name = name_at(said, at);
        const std::size_t equals = next(said, at + name.size());
        if ((type != "int" && type != "float" && type != "double") || name.empty() ||
            equals >= said.text.size() || said.text[equals] != '=')
            refuse(said.place(0), "this constant",
                   "is not read: expected `const float NAME = number;`");
        constants_.emplace_back(name, said.part(equals + 1, said.text.size()).trimmed());
        if (type == "int") integers_.insert(name);
    }

    /// `left < A(x) > right : { ... }`; gives where the text goes on.
    std::size_t plus_rule(const Placed& text, std::size_t at, std::vector<Rule>& all) {
        const std::size_t begin = at;
        std::size_t brace = at, colon = std::string::npos;
        int open = 0;
        for (; brace < text.text.size(); ++brace) {
            const char c = text.text[brace];
            if (c == '(') ++open;
            if (c == ')') --open;
            if (open == 0 && (c == '{' || c == ';')) break;
            if (open == 0 && c == ':' && colon == std::string::npos) colon = brace;
        }
        static const std::set<std::string> words{"int",     "float",  "double", "void",    "struct",
                                                 "class",   "bool",   "char",   "using",   "static",
                                                 "typedef", "extern", "enum",   "template"};
        if (words.contains(name_at(text, begin)))
            refuse(text.place(begin), "a declaration of C++",
                   "is not read: expected constants, `const float NAME = number;`, modules and "
                   "rules; found " +
                       shown(text, begin));
        if (colon == std::string::npos || brace == text.text.size() || text.text[brace] != '{' ||
            next(text, colon + 1) != brace)
            fail(text.place(begin),
                 "expected a rule `A(x) : { produce B(x); }` or a line of the header, found " +
                     shown(text, begin));
        const Rule head = head_of(text.part(begin, colon));
        const std::size_t end = closing(text, brace);
        plus_block(text.part(brace + 1, end), head, {}, all);
        return end + 1;
    }

    void plus_block(const Placed& block, const Rule& head, const std::vector<Placed>& path,
                    std::vector<Rule>& all) const {
        for (std::size_t at = next(block, 0); at < block.text.size(); at = next(block, at))
            at = plus_statement(block, at, head, path, all);
    }

    /// Reads one statement; gives where the text goes on.
    std::size_t plus_statement(const Placed& text, std::size_t at, const Rule& head,
                               std::vector<Placed> path, std::vector<Rule>& all) const {
        constexpr std::size_t deepest = 100;
        if (at >= text.text.size())
            fail(text.place(at), "expected a statement, found the end of the block");
        if (path.size() > deepest)
            fail(text.place(at), "more than 100 conditions within each other");
        const std::size_t place = text.place(at);
        if (text.text[at] == ';') return at + 1;
        if (text.text[at] == '{') {
            const std::size_t end = closing(text, at);
            plus_block(text.part(at + 1, end), head, path, all);
            return end + 1;
        }
        const std::string word = name_at(text, at);
        if (word == "produce") {
            std::size_t end = at;
            add_produced(all, head, path, up_to_semicolon(text, at + word.size(), end), place);
            return end;
        }
        if (word == "if") {
            const std::size_t open = next(text, at + word.size());
            if (open >= text.text.size() || text.text[open] != '(')
                fail(text.place(open), "expected '(' behind 'if', found " + shown(text, open));
            const std::size_t close = closing(text, open);
            const Placed condition = text.part(open + 1, close).trimmed();
            path.push_back(side(condition, true));
            at = plus_statement(text, next(text, close + 1), head, path, all);
            const std::size_t other = next(text, at);
            if (name_at(text, other) != "else") return at;
            path.back() = side(condition, false);
            return plus_statement(text, next(text, other + 4), head, path, all);
        }
        if (word == "nproduce")
            refuse(place, "nproduce",
                   "goes on behind what it makes, which is not read: expected produce");
        refuse(place, "a statement of C++",
               "is not read: expected produce, if or else; found " + shown(text, at));
    }

    // --- Rules ---

    Rule rule(const Placed& line) const {
        const std::size_t arrow = line.text.find("-->");
        if (arrow == std::string::npos) {
            if (line.text.find("-o>") != std::string::npos)
                refuse(line.at.front(), "-o>", "has no meaning in the notation");
            fail(line.at.front(),
                 "expected a rule with '-->', found '" + line.text.substr(0, 40) + "'");
        }
        Placed head = line.part(0, arrow), body = line.part(arrow + 3, line.text.size()).trimmed();
        std::optional<Placed> condition;
        if (const std::size_t colon = outside(head.text, ':'); colon != std::string::npos) {
            condition = head.part(colon + 1, head.text.size()).trimmed();
            head = head.part(0, colon);
            if (dialect_.python)
                refuse(condition->place(0), "a rule with a block", "is Python: expected only -->");
            if (condition->text.find_first_of("{}") != std::string::npos)
                refuse(condition->place(0), "a block of statements",
                       "has no meaning in the notation");
            if (condition->text == "*") condition.reset();
        }
        Rule found = head_of(head);
        found.condition = condition;
        if (!dialect_.python)
            if (const std::size_t colon = outside(body.text, ':'); colon != std::string::npos) {
                found.weight = body.part(colon + 1, body.text.size()).trimmed();
                body = body.part(0, colon).trimmed();
            }
        if (body.text.empty() && !dialect_.python)
            fail(line.place(arrow), "expected a successor behind '-->', or * for none");
        if (body.text == "*") body = {};
        if (dialect_.python && body.text.find("produce") != std::string::npos)
            refuse(body.place(0), "produce", "is Python: expected only modules behind -->");
        found.successor = body;
        return found;
    }

    /// The contexts and the predecessor of a rule.
    Rule head_of(Placed head) const {
        Rule found;
        head = head.trimmed();
        found.place = head.place(0);
        for (const char* pair : {"<<", ">>"})
            if (const std::size_t at = head.text.find(pair); at != std::string::npos)
                refuse(head.place(at), std::string("the context ") + pair,
                       "looks at the string being made, which has no meaning in the notation");
        if (const std::size_t at = outside(head.text, '<'); at != std::string::npos) {
            found.left = context(head.part(0, at));
            head = head.part(at + 1, head.text.size());
        }
        if (const std::size_t at = outside(head.text, '>'); at != std::string::npos) {
            found.right = context(head.part(at + 1, head.text.size()));
            head = head.part(0, at);
        }
        const std::vector<Module> strict = modules(head);
        if (strict.empty()) fail(found.place, "expected a module before '-->'");
        found.predecessor = strict.front();
        for (const Module& module : strict) check_formals(module);
        if (strict.size() > 1) found.several = strict;
        return found;
    }

    /// The first of these characters outside brackets.
    static std::size_t outside(const std::string& text, char wanted) {
        int open = 0;
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '(') ++open;
            if (text[i] == ')') --open;
            if (text[i] == wanted && open == 0) return i;
        }
        return std::string::npos;
    }

    std::vector<Module> context(const Placed& text) const {
        const Placed said = text.trimmed();
        if (said.text == "*" || said.text.empty()) return {};
        std::vector<Module> found = modules(said), kept;
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (found[i].symbol == "=") {
                if (i + 1 == found.size() || found[i + 1].symbol != "]")
                    refuse(found[i].place, "= in a context",
                           "skips what follows in a branch, and has a meaning in the notation only "
                           "before its ]");
                kept.back().open = true;
                continue;
            }
            check_formals(found[i]);
            kept.push_back(std::move(found[i]));
        }
        return kept;
    }

    void check_formals(const Module& module) const {
        for (const Placed& formal : module.arguments)
            if (formal.text.empty() || !is_name_start(formal.text[0]) ||
                !std::ranges::all_of(formal.text, is_name_part))
                fail(formal.place(0), "expected a name as parameter, found '" + formal.text + "'");
    }

    /// Names of L-Py's own modules, with the symbols that say the same.
    static const std::vector<std::pair<std::string, std::string>>& lpy_names() {
        static const std::vector<std::pair<std::string, std::string>> all{
            {"Left", "+"},       {"Right", "-"},       {"Down", "&"},     {"Up", "^"},
            {"RollL", "/"},      {"RollR", "\\"},      {"Sphere", "@O"},  {"SetColor", ";"},
            {"TurnAround", "|"}, {"RollToVert", "@v"}, {"SetWidth", "!"}, {"Cut", "%"}};
        return all;
    }

    /// Modules, each command of several symbols being one: `@v`, `~l`, `?P`.
    std::vector<Module> modules(const Placed& text) const {
        std::vector<Module> found;
        for (Module& module : single_modules(text)) {
            const std::string first = found.empty() ? "" : found.back().symbol;
            if (first != "@" && first != "~" && first != "?" &&
                (first != "@G" || dialect_.python)) {
                found.push_back(std::move(module));
                continue;
            }
            if (found.back().has_arguments)
                refuse(found.back().place, "the symbol " + first,
                       first == "?" ? "begins a system within another, which has no meaning in the "
                                      "notation"
                                    : "with a number has no meaning in the notation");
            module.symbol = first + module.symbol;
            module.place = found.back().place;
            found.back() = std::move(module);
        }
        return found;
    }

    /// The name of a module of lpfg as a symbol; gives its length in the text.
    std::size_t plus_name(const Placed& text, std::size_t at, Module& module) const {
        static const std::map<std::string, std::string> known{
            {"F", "F"},      {"f", "f"},        {"G", "G"},          {"g", "g"},
            {"Left", "+"},   {"Right", "-"},    {"Down", "&"},       {"Up", "^"},
            {"RollL", "\\"}, {"RollR", "/"},    {"TurnAround", "|"}, {"RollToVert", "@v"},
            {"SB", "["},     {"EB", "]"},       {"SP", "{"},         {"EP", "}"},
            {"PP", "."},     {"SetWidth", "!"}, {"SetColor", ";"},   {"IncColor", ";"},
            {"Cut", "%"}};
        const std::string name = name_at(text, at);
        if (name.empty())
            fail(text.place(at), "expected the name of a module, found " + shown(text, at));
        std::vector<std::string> names = modules_;
        if (std::ranges::count(modules_, name) > 0) {
            module.symbol = name;
            return name.size();
        }
        const auto found = known.find(name);
        if (found == known.end()) {
            for (const auto& [own, symbol] : known) names.push_back(own);
            fail(text.place(at),
                 "the module " + quoted(name) + " is not declared" + did_you_mean(name, names) +
                     ": expected one of the file or of F, f, G, g, Left, Right, Down, "
                     "Up, RollL, RollR, TurnAround, RollToVert, SB, EB, SP, EP, PP, "
                     "SetWidth, SetColor, IncColor, Cut");
        }
        module.symbol = found->second;
        return name.size();
    }

    std::vector<Module> single_modules(const Placed& text) const {
        std::vector<Module> found;
        for (std::size_t i = 0; i < text.text.size();) {
            const char c = text.text[i];
            if (c == ' ' || c == '\t' || (dialect_.plus && (c == '\n' || c == '\r'))) {
                ++i;
                continue;
            }
            Module module;
            module.place = text.place(i);
            if (c == '(' || c == ')') fail(module.place, std::string("unmatched '") + c + "'");
            if (static_cast<unsigned char>(c) >= 0x80)
                fail(module.place, "expected a symbol of ASCII");
            std::size_t size = 1;
            if (dialect_.plus) size = plus_name(text, i, module);
            for (const std::string& name : modules_)
                if (!dialect_.plus && name.size() > size &&
                    text.text.compare(i, name.size(), name) == 0)
                    size = name.size();
            if (!dialect_.plus) module.symbol = text.text.substr(i, size);
            if (dialect_.python && size == 1)
                for (const auto& [longer, short_name] : lpy_names())
                    if (longer.size() > size && text.text.compare(i, longer.size(), longer) == 0) {
                        size = longer.size();
                        module.symbol = short_name;
                    }
            i += size;
            std::size_t open = i;
            while (open < text.text.size() && text.text[open] == ' ') ++open;
            if (open < text.text.size() && text.text[open] == '(') {
                module.has_arguments = true;
                int depth = 0;
                std::size_t from = open + 1, k = open;
                for (; k < text.text.size(); ++k) {
                    if (text.text[k] == '(') ++depth;
                    const bool ends = text.text[k] == ')' && --depth == 0;
                    if (ends || (text.text[k] == ',' && depth == 1)) {
                        module.arguments.push_back(text.part(from, k).trimmed());
                        from = k + 1;
                    }
                    if (ends) break;
                }
                if (k == text.text.size()) fail(text.place(open), "unmatched '('");
                if (module.arguments.size() == 1 && module.arguments[0].text.empty())
                    module.arguments.clear();
                i = k + 1;
            }
            found.push_back(std::move(module));
        }
        return found;
    }

    // --- Predecessors of several modules ---

    static std::string kind_of(const Module& module) {
        return module.symbol + "/" + std::to_string(module.arguments.size());
    }
    /// Whether the end of one predecessor is the beginning of another, less than all of both.
    static bool overlaps(const std::vector<Module>& one, const std::vector<Module>& other) {
        for (std::size_t size = 1; size < std::max(one.size(), other.size()); ++size) {
            if (size > one.size() || size > other.size()) break;
            if (size == one.size() && size == other.size()) break;
            bool same = true;
            for (std::size_t i = 0; i < size && same; ++i)
                same = kind_of(one[one.size() - size + i]) == kind_of(other[i]);
            if (same) return true;
        }
        return false;
    }
    static bool holds_part(const std::vector<Module>& word, const std::vector<Module>& part) {
        for (std::size_t at = 0; at + part.size() <= word.size(); ++at) {
            bool same = part.size() < word.size();
            for (std::size_t i = 0; i < part.size() && same; ++i)
                same = kind_of(word[at + i]) == kind_of(part[i]);
            if (same) return true;
        }
        return false;
    }

    /// `AB --> C` as rules for its modules: A before B becomes C, B behind A nothing. That is the same where no two places of such
    /// predecessors can share a module, contexts skip nothing and no earlier rule takes one of the modules.
    void split_predecessors() {
        const auto first =
            std::ranges::find_if(rules_, [](const Rule& rule) { return !rule.several.empty(); });
        if (first == rules_.end()) return;
        const char* const why =
            "is one rule for all of them, which has a meaning in the notation only ";
        const auto fail_for = [&](const Rule& rule, const char* where) {
            refuse(rule.several[1].place, "a predecessor of several modules",
                   std::string(why) + where);
        };
        if (stochastic_) fail_for(*first, "without a seed");
        if (ignored_ || considered_) fail_for(*first, "where contexts skip no symbols");
        std::vector<std::vector<Module>> words{modules(axiom_)};
        for (const auto* all : {&rules_, &decomposition_})
            for (const Rule& rule : *all) words.push_back(modules(rule.successor));
        for (const std::vector<Module>& word : words)
            for (const Module& module : word)
                if (module.symbol == "[" || module.symbol == "]")
                    fail_for(*first, "in words without branches, which contexts skip");
        std::set<std::string> single;  // modules of the rules so far that have one
        for (const Rule& rule : rules_) {
            if (rule.several.empty()) {
                single.insert(rule.letter());
                continue;
            }
            for (const Module& module : rule.several)
                if (single.contains(kind_of(module)))
                    fail_for(rule, "before all other rules for one of these modules");
            for (const Rule& other : rules_) {
                if (other.several.empty()) continue;
                if (overlaps(rule.several, other.several) ||
                    overlaps(other.several, rule.several) ||
                    holds_part(rule.several, other.several))
                    fail_for(rule, "where two such predecessors cannot share modules of a word");
            }
        }
        std::vector<Rule> split;
        for (const Rule& rule : rules_) {
            if (rule.several.empty()) {
                split.push_back(rule);
                continue;
            }
            for (std::size_t i = 0; i < rule.several.size(); ++i) {
                Rule one = rule;
                one.several.clear();
                one.predecessor = rule.several[i];
                const auto at = rule.several.begin() + static_cast<std::ptrdiff_t>(i);
                one.left.insert(one.left.end(), rule.several.begin(), at);
                one.right.insert(one.right.begin(), at + 1, rule.several.end());
                if (i > 0) one.successor = {};
                split.push_back(std::move(one));
            }
        }
        rules_ = std::move(split);
    }

    // --- Rules for parts of commands ---

    /// Where a rule rewrites the last symbol of a command, `F --> X` that of `~F`, the command has a rule of its own, `~F --> ~X`.
    void add_command_rules() {
        std::vector<Module> todo;
        std::set<std::string> known;
        const auto meet = [&](const Placed& word) {
            for (const Module& module : modules(word))
                if (module.symbol.size() > 1 && is_command(module.symbol) &&
                    known.insert(kind_of(module)).second)
                    todo.push_back(module);
        };
        meet(axiom_);
        for (const auto* all : {&rules_, &decomposition_, &interpretation_})
            for (const Rule& rule : *all) meet(rule.successor);
        while (!todo.empty()) {
            const Module command = todo.back();
            todo.pop_back();
            const std::string prefix = command.symbol.substr(0, command.symbol.size() - 1),
                              last = command.symbol.substr(command.symbol.size() - 1);
            const std::vector<Rule> rules = rules_;
            for (const Rule& rule : rules) {
                if (rule.predecessor.symbol != last ||
                    rule.predecessor.arguments.size() != command.arguments.size())
                    continue;
                const std::vector<Module> image = modules(rule.successor);
                if (image.empty() || is_command(image[0].symbol) || stochastic_)
                    refuse(rule.predecessor.place, "a rule for " + last,
                           "rewrites a part of the command " + command.symbol +
                               ", which is one symbol in the notation");
                Rule own = rule;
                own.predecessor.symbol = command.symbol;
                own.successor = {};
                for (const char c : prefix) own.successor.add(c, rule.successor.place(0));
                own.successor.append(rule.successor.trimmed());
                meet(own.successor);
                rules_.push_back(std::move(own));
            }
        }
    }
    static bool is_command(const std::string& symbol) {
        return std::string_view("@~?").find(symbol[0]) != std::string_view::npos;
    }

    // --- The notation ---

    /// The symbol's name there.
    std::string name(const Module& module) const {
        const std::string& symbol = module.symbol;
        if (dialect_.plus && std::ranges::count(modules_, symbol) > 0) return symbol;
        if (symbol.size() > 1)
            return std::string_view("@~?").find(symbol[0]) == std::string_view::npos
                       ? symbol
                       : command(module);
        const char c = symbol[0];
        if (!dialect_.python && c == '/') return "\\";
        if (!dialect_.python && c == '\\') return "/";
        if (c == '_' || (c == '#' && dialect_.python))
            refuse(module.place, "the symbol " + symbol,
                   dialect_.python ? "makes lines wider by what its editor says"
                                   : "goes by a tropism of the view file");
        if (c == '@' || c == '?' || c == '~')
            refuse(module.place, "the symbol " + symbol, "stands before no symbol");
        if (c == '%' && (rewrites_cut_ || !module.arguments.empty())) return "X_37";
        if (c == '%' && !cut_) cut_ = module.place;
        if (c == 'g' && !move_) move_ = module.place;
        if (c == '{' && !polygon_) polygon_ = module.place;
        if (module.has_arguments && (c == '{' || c == '}' || c == '.'))
            refuse(module.place, "the symbol " + symbol + " with a number",
                   "belongs to generalized cylinders, which have no meaning in the notation");
        if (c == '=' || c == ':' || c == '<' || c == '>')
            fail(module.place, "expected a symbol, found '" + symbol + "'");
        // What the notation has no symbols like, or others that look alike.
        if (std::string_view(";,#$'\"").find(c) != std::string_view::npos)
            return "X_" + std::to_string(static_cast<int>(c));
        return symbol;
    }

    /// A command of several symbols, as the notation calls it.
    std::string command(const Module& module) const {
        const std::string& symbol = module.symbol;
        if (symbol[0] == '~') return symbol;
        if (symbol == "@v" || (symbol == "?P" && !module.arguments.empty())) return symbol;
        if (symbol == "?H" && module.arguments.size() == 3) return symbol;
        if ((symbol == "@c" || symbol == "@O") && module.has_arguments) return symbol;
        if (symbol == "@c" || symbol == "@O")
            refuse(module.place, symbol + " without a size", "goes by the view file");
        // Generalized cylinders are drawn as their axes; what follows @G otherwise means nothing there.
        if (symbol.size() == 3 && symbol.starts_with("@G") && symbol[2] != 't' && symbol[2] != 'r')
            return symbol;
        refuse(module.place, "the command " + symbol, "has no meaning in the notation");
    }

    /// What the turtle does with symbols of the file that the notation takes otherwise, for those that occur.
    std::string own_meanings(const std::set<std::string>& interpreted) const {
        // By the symbol and the number of parameters.
        static const std::vector<std::pair<std::string, std::string>> all{
            {"X_59/0", "'"}, {"X_59/1", "'(x)"}, {"X_44/1", "'(x)"}, {"X_35/1", "!(x)"},
            {"@v/0", "$"},   {"g/0", "f"},       {"g/1", "f(x)"},    {"@O/1", "X_79(x/2)"},
        };
        std::string text;
        for (const std::string& met : met_kinds_) {
            if (interpreted.contains(met)) continue;
            const auto known =
                std::ranges::find(all, met, &std::pair<std::string, std::string>::first);
            if (known == all.end()) continue;
            const std::string symbol = met.substr(0, met.find('/'));
            std::string image = known->second;
            if (symbol == "@O" && dialect_.python) image = "X_79(x)";
            text +=
                "interpret " + symbol + (met.ends_with("/1") ? "(x)" : "") + " -> " + image + "\n";
        }
        if (met_.contains("@O")) text += "solid X_79 sphere radius\n";
        if (met_.contains("@c")) text += "surface @c disc\n";
        return text;
    }

    /// Symbols that begin commands may have no rules of their own here, and contexts see commands whole.
    void check_commands() const {
        for (const std::string& met : met_) {
            if (met.size() < 2 || !is_command(met)) continue;
            const auto check = [&](const Module& module, const char* what, bool last_too) {
                for (std::size_t i = 0; i + (last_too ? 0 : 1) < met.size(); ++i)
                    if (module.symbol == met.substr(i, 1))
                        refuse(module.place, std::string(what) + module.symbol,
                               "sees a part of the command " + met +
                                   ", which is one symbol in the notation");
            };
            for (const auto* rules : {&rules_, &interpretation_, &decomposition_})
                for (const Rule& rule : *rules) {
                    check(rule.predecessor, "a rule for ", rules != &rules_);
                    for (const auto* side : {&rule.left, &rule.right})
                        for (const Module& module : *side) check(module, "the context ", true);
                }
        }
    }

    std::string written(const std::vector<Module>& word, const std::set<std::string>& names) {
        std::vector<std::string> parts;
        for (const Module& module : word) {
            std::string text = name(module);
            if (const auto types = types_.find(module.symbol);
                types != types_.end() && types->second.size() != module.arguments.size())
                fail(module.place, "the module " + module.symbol + " has " +
                                       std::to_string(types->second.size()) +
                                       " parameters, found " +
                                       std::to_string(module.arguments.size()));
            met_.insert(text);
            met_kinds_.insert(text + "/" + std::to_string(module.arguments.size()));
            if (!module.arguments.empty()) {
                std::vector<std::string> arguments;
                for (std::size_t i = 0; i < module.arguments.size(); ++i)
                    arguments.push_back(
                        expression(module.arguments[i], names, is_integer(module, i)));
                text += "(" + joined(arguments, ",") + ")";
            }
            parts.push_back(text);
        }
        return parts.empty() ? "ε" : spaced_word(parts);
    }

    /// Whether a parameter of a module is a whole number: those of lpfg have types.
    bool is_integer(const Module& module, std::size_t parameter) const {
        const auto types = types_.find(module.symbol);
        return types != types_.end() && parameter < types->second.size() &&
               types->second[parameter] == "int";
    }

    std::set<std::string> formals(const Rule& rule) const {
        std::set<std::string> names;
        integer_formals_.clear();
        const auto add = [&](const Module& module) {
            for (std::size_t i = 0; i < module.arguments.size(); ++i) {
                names.insert(module.arguments[i].text);
                if (is_integer(module, i)) integer_formals_.insert(module.arguments[i].text);
            }
        };
        add(rule.predecessor);
        for (const auto* side : {&rule.left, &rule.right})
            for (const Module& module : *side) add(module);
        return names;
    }

    /// What the contexts of a rule are, whatever their parameters are called.
    std::string contexts(const Rule& rule) const {
        std::string text;
        for (const auto* side : {&rule.left, &rule.right}) {
            for (const Module& module : *side)
                text += module.symbol + "/" + std::to_string(module.arguments.size()) + " ";
            text += "|";
        }
        return text;
    }

    std::string head(const Rule& rule, const std::string& condition) {
        const std::set<std::string> names = formals(rule);
        std::string text;
        if (!rule.left.empty()) text += written(rule.left, names) + " < ";
        text += written({rule.predecessor}, names);
        if (!rule.right.empty()) text += " > " + written(rule.right, names);
        if (!condition.empty()) text += " : " + condition;
        return text;
    }

    /// A text in which names stand for others, those of the same places.
    static Placed with(const Placed& text, const std::map<std::string, Placed>& values) {
        Placed out;
        for (std::size_t i = 0; i < text.text.size();) {
            std::size_t stop = i;
            if (is_name_start(text.text[i]) && (i == 0 || !is_name_part(text.text[i - 1])))
                while (stop < text.text.size() && is_name_part(text.text[stop])) ++stop;
            const auto value = values.find(text.text.substr(i, stop - i));
            if (stop == i || value == values.end()) {
                for (stop = std::max(stop, i + 1); i < stop; ++i)
                    out.add(text.text[i], text.place(i));
                continue;
            }
            const std::size_t place = text.place(i);
            out.add('(', place);
            for (std::size_t k = 0; k < value->second.text.size(); ++k)
                out.add(value->second.text[k], value->second.place(k));
            out.add(')', place);
            i = stop;
        }
        return out;
    }

    /// What a value is that is given to a parameter that is a whole number.
    static Placed whole(const Placed& value) {
        Placed out;
        for (const char c : std::string_view("int(")) out.add(c, value.place(0));
        out.append(value);
        out.add(')', value.place(0));
        return out;
    }

    /// Bounds the work where letters that vanish are made of many.
    void count_step(const Module& module, const char* what) const {
        constexpr std::size_t most = 2'000'000;
        if (++steps_ > most) refuse(module.place, what, "that takes more than 2000000 steps");
    }

    /// What a decomposition makes of a word, as deep as it goes.
    std::vector<Module> decomposed(const std::vector<Module>& word, std::uint64_t depth) const {
        constexpr std::size_t longest = 100'000;
        std::vector<Module> found;
        for (const Module& module : word) {
            count_step(module, "a decomposition");
            const Rule* const rule = depth == 0 ? nullptr : decomposition_of(module);
            if (!rule) {
                found.push_back(module);
            } else {
                std::map<std::string, Placed> values;
                for (std::size_t i = 0; i < module.arguments.size(); ++i)
                    values.emplace(
                        rule->predecessor.arguments[i].text,
                        is_integer(module, i) ? whole(module.arguments[i]) : module.arguments[i]);
                std::vector<Module> image = modules(rule->successor);
                for (Module& one : image) {
                    one.place = module.place;
                    for (Placed& argument : one.arguments) argument = with(argument, values);
                }
                for (Module& one : decomposed(image, depth - 1)) found.push_back(std::move(one));
            }
            if (found.size() > longest)
                refuse(module.place, "a decomposition", "that gives more than 100000 modules");
        }
        return found;
    }
    const Rule* decomposition_of(const Module& module) const {
        const auto found = std::ranges::find_if(decomposition_, [&](const Rule& rule) {
            return rule.predecessor.symbol == module.symbol &&
                   rule.predecessor.arguments.size() == module.arguments.size();
        });
        return found == decomposition_.end() ? nullptr : &*found;
    }

    /// What a homomorphism makes of an image of it, as deep as it goes. What it would rewrite still deeper draws as the turtle takes it, so
    /// such letters get other names or, where they do nothing, are left out; % means nothing in it.
    std::vector<Module> drawn(std::vector<Module> image, std::uint64_t depth,
                              const std::set<std::string>& interpreted) const {
        constexpr std::size_t longest = 100'000;
        constexpr std::uint64_t deepest = 1000;
        std::erase_if(image, [](const Module& module) { return module.symbol == "%"; });
        const auto is_interpreted = [&](const Module& module) {
            return interpreted.contains(name(module) + "/" +
                                        std::to_string(module.arguments.size()));
        };
        std::vector<Module> found;
        for (Module& module : image) {
            count_step(module, "a homomorphism");
            if (!is_interpreted(module)) {
                found.push_back(std::move(module));
                continue;
            }
            if (depth > 1) {
                const auto rule = std::ranges::find_if(interpretation_, [&](const Rule& one) {
                    return kind_of(one.predecessor) == kind_of(module);
                });
                if (rule->condition)
                    refuse(module.place,
                           "a homomorphism with conditions of what a homomorphism gives",
                           "has no meaning in the notation");
                if (depth > deepest)
                    refuse(module.place, "a homomorphism", "that is more than 1000 deep");
                std::map<std::string, Placed> values;
                for (std::size_t i = 0; i < module.arguments.size(); ++i)
                    values.emplace(rule->predecessor.arguments[i].text, module.arguments[i]);
                std::vector<Module> deeper = modules(rule->successor);
                for (Module& one : deeper) {
                    one.place = module.place;
                    for (Placed& argument : one.arguments) argument = with(argument, values);
                }
                for (Module& one : drawn(std::move(deeper), depth - 1, interpreted))
                    found.push_back(std::move(one));
            } else if (module.symbol == "F" || module.symbol == "f") {
                module.symbol += "_h";
                found.push_back(std::move(module));
            } else if (!std::isalpha(static_cast<unsigned char>(module.symbol[0])) ||
                       module.symbol == "G" || module.symbol == "g") {
                refuse(module.place, "a homomorphism of what a homomorphism gives",
                       "is applied " +
                           (drawn_depth_ == 1 ? std::string("once")
                                              : std::to_string(drawn_depth_) + " times") +
                           " there, and until nothing is left in the notation, which has no other "
                           "name for " +
                           module.symbol);
            }
            if (found.size() > longest)
                refuse(module.place, "a homomorphism", "that gives more than 100000 modules");
        }
        return found;
    }

    std::vector<Module> successor(const Rule& rule) const {
        return decomposed(modules(rule.successor), depth_);
    }

    /// A rule for each module that no other rule rewrites and a decomposition does.
    void add_decompositions() {
        if (decomposition_.empty()) return;
        for (const Rule& rule : decomposition_) {
            if (rule.condition || rule.weight || !rule.left.empty() || !rule.right.empty())
                refuse(rule.place, "a decomposition with contexts, conditions or weights",
                       "has no meaning in the notation");
            if (decomposition_of(rule.predecessor) != &rule) continue;
            const auto same = [&](const Rule& one) { return one.letter() == rule.letter(); };
            if (stochastic_ && std::ranges::any_of(rules_, same)) {
                if (!std::ranges::find_if(rules_, same)->reach()) continue;  // some rule applies
                refuse(rule.place, "a decomposition of what rules with contexts may leave",
                       "beside weights has no meaning in the notation");
            }
            Rule last;
            last.predecessor = rule.predecessor;
            last.place = rule.place;
            for (const char c : rule.predecessor.symbol)
                last.successor.add(c, rule.predecessor.place);
            if (!rule.predecessor.arguments.empty()) {
                char sign = '(';
                for (const Placed& argument : rule.predecessor.arguments) {
                    last.successor.add(sign, rule.place);
                    for (std::size_t i = 0; i < argument.text.size(); ++i)
                        last.successor.add(argument.text[i], argument.place(i));
                    sign = ',';
                }
                last.successor.add(')', rule.place);
            }
            added_.push_back(std::move(last));
        }
        rules_.insert(rules_.end(), added_.begin(), added_.end());
    }

    /// Letters behind which no letter but the end of their branch can stand.
    std::set<std::string> last_letters() const {
        std::vector<std::pair<std::string, std::vector<Module>>> words{
            {"", decomposed(modules(axiom_), 0)}};
        for (const Rule& rule : rules_)
            words.emplace_back(rule.predecessor.symbol, successor(rule));
        std::set<std::string> last;
        for (const auto& [owner, word] : words)
            for (const Module& module : word) last.insert(module.symbol);
        for (const auto& [owner, word] : words)
            if (owner == "[" || owner == "]") return {};
        for (bool changed = true; changed;) {
            changed = false;
            for (const auto& [owner, word] : words)
                for (std::size_t i = 0; i < word.size(); ++i) {
                    const bool ends = i + 1 < word.size() ? word[i + 1].symbol == "]"
                                                          : !owner.empty() && last.contains(owner);
                    if (!ends && last.erase(word[i].symbol) > 0) changed = true;
                }
        }
        return last;
    }

    /// `[B]` is a whole branch there and the beginning of one in the notation.
    void check_branches() const {
        if (dialect_.python) return;
        const std::set<std::string> last = last_letters();
        for (const Rule& rule : rules_)
            for (std::size_t i = 1; i < rule.right.size(); ++i) {
                const Module &before = rule.right[i - 1], &end = rule.right[i];
                if (end.symbol != "]" || before.open || last.contains(before.symbol)) continue;
                refuse(end.place, "a branch in a context that ends without =",
                       "is the whole branch there, and has no meaning in the notation: say [" +
                           before.symbol + "=] for one that begins so");
            }
    }

    /// What is cut stays in the words of the notation, where contexts would see it.
    void check_cuts() const {
        if (!cut_) return;
        for (const Rule& rule : rules_)
            if (!rule.left.empty() || !rule.right.empty())
                refuse(*cut_, "% beside contexts",
                       "cuts words there and figures in the notation, so contexts see what is cut");
    }

    /// g leaves no corner; the notation has no move that does so.
    void check_moves() const {
        if (move_ && polygon_)
            refuse(*move_, "g beside polygons",
                   "leaves no corner, and a move of the notation does");
    }

    /// The condition of an earlier rule for the module of a rule, in the names of its parameters.
    std::string condition_of(const Rule& earlier, const Rule& rule) {
        const std::vector<std::string> theirs = formal_order(earlier), ours = formal_order(rule);
        std::map<std::string, Placed> values;
        for (std::size_t i = 0; i < std::min(theirs.size(), ours.size()); ++i) {
            Placed name;
            for (const char c : ours[i]) name.add(c, rule.place);
            values.emplace(theirs[i], std::move(name));
        }
        return expression(with(*earlier.condition, values), formals(rule));
    }

    /// The rules in the notation, where the longest context comes first and not the first rule.
    std::string rule_lines() {
        std::string text;
        std::map<std::string, std::vector<const Rule*>> before;
        for (const Rule& rule : rules_) {
            auto& earlier = before[rule.letter()];
            const std::set<std::string> names = formals(rule);
            if (stochastic_) {
                if (!earlier.empty() && contexts(*earlier.front()) != contexts(rule))
                    refuse(rule.place, "a choice between rules with different contexts",
                           "has no meaning in the notation");
                earlier.push_back(&rule);
                continue;
            }
            std::string condition = rule.condition ? expression(*rule.condition, names) : "";
            bool reached = true;
            for (const Rule* other : earlier) {
                const bool anywhere = other->left.empty() && other->right.empty();
                if (other->reach() < rule.reach() && !anywhere)
                    refuse(rule.place, "a rule with longer contexts behind one with shorter ones",
                           "is not used there if the first applies; the notation would use it: "
                           "move it above, if that is meant");
                if (!anywhere && contexts(*other) != contexts(rule)) continue;
                if (!other->condition) {
                    reached = false;
                    break;
                }
                const std::string no = "!(" + condition_of(*other, rule) + ")";
                condition = condition.empty() ? no : no + " & (" + condition + ")";
            }
            earlier.push_back(&rule);
            if (!reached) continue;
            text += head(rule, condition) + " -> " + written(successor(rule), names) + "\n";
        }
        if (!stochastic_) return text;
        for (const Rule& rule : rules_) {
            auto& all = before[rule.letter()];
            if (all.empty()) continue;
            if (std::ranges::any_of(all,
                                    [](const Rule* one) { return one->condition.has_value(); })) {
                text += conditional_choice(all);
            } else if (all.size() == 1) {
                text += head(rule, "") + " -> " + written(successor(rule), formals(rule)) + "\n";
            } else {
                Rational sum = 0;
                for (const Rule* one : all) sum += weight(*one);
                for (const Rule* one : all)
                    text += head(*one, "") + " -(" + to_string(weight(*one) / sum) + ")-> " +
                            written(successor(*one), formals(*one)) + "\n";
            }
            all.clear();
        }
        return text;
    }

    /// Rules of one module with weights and conditions: those whose conditions hold share the choice, so there is one for each set of them.
    std::string conditional_choice(const std::vector<const Rule*>& all) {
        constexpr std::size_t most = 8;
        if (all.size() > most)
            refuse(all.back()->place, "a choice between more than 8 rules with conditions",
                   "would take too many rules of the notation");
        std::string text;
        for (std::size_t set = 1; set < std::size_t{1} << all.size(); ++set) {
            const auto taken = [&](std::size_t i) { return (set >> i & 1) != 0; };
            bool possible = true;
            Rational sum = 0;
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (taken(i)) sum += weight(*all[i]);
                possible = possible && (taken(i) || all[i]->condition);
            }
            if (!possible) continue;  // one without a condition always takes part
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (!taken(i)) continue;
                std::string condition;
                for (std::size_t k = 0; k < all.size(); ++k) {
                    if (!all[k]->condition) continue;
                    condition += (condition.empty() ? "" : " & ") +
                                 std::string(taken(k) ? "" : "!") + "(" +
                                 condition_of(*all[k], *all[i]) + ")";
                }
                const std::set<std::string> names = formals(*all[i]);
                text += head(*all[i], condition) + " -(" + to_string(weight(*all[i]) / sum) +
                        ")-> " + written(successor(*all[i]), names) + "\n";
            }
        }
        return text;
    }

    /// Names of the predecessor's parameters, then of those of the contexts.
    static std::vector<std::string> formal_order(const Rule& rule) {
        std::vector<std::string> order;
        for (const Placed& formal : rule.predecessor.arguments) order.push_back(formal.text);
        for (const auto* side : {&rule.left, &rule.right})
            for (const Module& module : *side)
                for (const Placed& formal : module.arguments) order.push_back(formal.text);
        return order;
    }

    Rational weight(const Rule& rule) const {
        if (!rule.weight) return 1;
        const auto none = [](const std::string&) -> const Quantity* { return nullptr; };
        try {
            const Quantity value = evaluate(read_expression(expression(*rule.weight, {})), none);
            if (value.exact && sign(*value.exact) > 0) return *value.exact;
        } catch (const Diagnostics&) {
        }
        fail(rule.weight->place(0),
             "expected a weight above 0 as a plain number, found '" + rule.weight->text + "'");
    }

    std::string notation() {
        std::string text;
        std::set<std::string> names;
        std::string constants;
        for (const auto& [called, value] : constants_) {
            constants +=
                "let " + called + " = " + expression(value, {}, integers_.contains(called)) + "\n";
            known_.emplace(called, called);
        }
        if (!dialect_.python && !dialect_.plus) {
            known_.emplace("Q", "");
            known_.emplace("Z", generation_.empty() ? "0" : generation_);
        }
        rewrites_cut_ = std::ranges::any_of(
            rules_, [](const Rule& rule) { return rule.predecessor.symbol == "%"; });
        split_predecessors();
        if (!dialect_.python && !dialect_.plus) add_command_rules();
        add_decompositions();
        std::string axiom = written(modules(axiom_), {});
        const std::string rules = rule_lines();
        std::string interpret;
        std::set<std::string> interpreted;
        const auto kind = [&](const Module& module) {
            return name(module) + "/" + std::to_string(module.arguments.size());
        };
        for (const Rule& rule : interpretation_) interpreted.insert(kind(rule.predecessor));
        for (const Rule& rule : interpretation_) {
            if (drawn_depth_ == 0) continue;
            if (!rule.left.empty() || !rule.right.empty() || rule.weight)
                refuse(rule.place, "a homomorphism with contexts or weights",
                       "has no meaning in the notation");
            const std::set<std::string> own = formals(rule);
            std::vector<Module> image = drawn(modules(rule.successor), drawn_depth_, interpreted);
            interpret += "interpret " +
                         head(rule, rule.condition ? expression(*rule.condition, own) : "") +
                         " -> " + written(image, own) + "\n";
        }
        check_branches();
        check_cuts();
        check_moves();
        check_commands();
        interpret += own_meanings(interpreted);
        // Where @v asks for what is level, the turtle must look along z.
        if (met_.contains("@v")) {
            axiom = std::string(cpfg_upward) + " " + axiom;
            interpret += std::string("interpret ") + cpfg_upward + " -> ^(90)\n";
        } else if (!dialect_.python && std::ranges::any_of(met_, [](const std::string& symbol) {
                       return symbol == "&" || symbol == "^" || symbol == "/" || symbol == "\\";
                   })) {
            interpret += "camera -90 90\n";  // the page, as the program shows it
        }
        std::vector<std::string> longer;
        for (const std::string& symbol : met_)
            if (undeclared_length(symbol) != symbol.size()) longer.push_back(symbol);
        if (!longer.empty()) text += "alphabet " + joined(longer, " ") + "\n";
        text += constants + "axiom " + axiom + "\n" + rules;
        if (ignored_) text += ignored_line(modules(*ignored_));
        if (considered_) text += considered_line();
        text += interpret;
        text += "angle " + std::to_string(static_cast<int>(dialect_.angle)) + "\nstart 0 0 90\n";
        if (!generation_.empty()) text += "generation " + generation_ + "\n";
        return text;
    }

    std::string ignored_line(const std::vector<Module>& all) const {
        std::vector<std::string> names;
        for (const Module& module : all)
            if (const std::string symbol = name(module); met_.contains(symbol))
                names.push_back(symbol);
        return names.empty() ? "" : "ignore " + spaced_word(names) + "\n";
    }
    std::string considered_line() const {
        std::set<std::string> seen{"[", "]"};
        for (const Module& module : modules(*considered_)) seen.insert(name(module));
        std::vector<std::string> names;
        for (const std::string& symbol : met_)
            if (!seen.contains(symbol)) names.push_back(symbol);
        return names.empty() ? "" : "ignore " + spaced_word(names) + "\n";
    }

    std::string expression(const Placed& text, const std::set<std::string>& names,
                           bool integer = false) const {
        CpfgIntegers integers{integers_, integer};
        for (const std::string& name : names)
            if (integer_formals_.contains(name))
                integers.names.insert(name);
            else
                integers.names.erase(name);
        return cpfg_expression(source_, dialect_, text, names, known_, integers);
    }

    CpfgDialect dialect_;
    std::string text_;
    Source source_;
    Findings findings_;
    std::string entry_;
    std::vector<std::pair<std::string, Placed>> constants_;
    CpfgNames known_;
    std::vector<std::string> modules_;
    std::map<std::string, std::vector<std::string>> types_;  // of the parameters of lpfg's modules
    std::set<std::string> integers_;                         // its constants that are whole numbers
    mutable std::set<std::string> integer_formals_;  // of the rule whose names were asked for last
    Placed axiom_;
    std::vector<Rule> rules_, decomposition_, interpretation_, added_;
    std::uint64_t depth_ = 1;        // of the decomposition
    std::uint64_t drawn_depth_ = 1;  // of the homomorphism
    std::optional<Placed> ignored_, considered_;
    std::string generation_;
    bool stochastic_ = false, rewrites_cut_ = false;
    std::set<std::string> met_, met_kinds_;  // symbols, and with the number of their parameters
    mutable std::size_t steps_ = 0;          // of decompositions and homomorphisms
    mutable std::optional<std::size_t> cut_, move_, polygon_;  // where the first stands
};

/// Where the first line stands, outside comments of C, that such a test holds of.
std::optional<std::size_t> first_line_that(std::string_view text, bool (*holds)(std::string_view)) {
    std::string bare(text);
    for (std::size_t i = 0; i + 1 < bare.size(); ++i) {
        if (bare[i] != '/' || (bare[i + 1] != '/' && bare[i + 1] != '*')) continue;
        const bool is_line = bare[i + 1] == '/';
        std::size_t end = is_line ? bare.find('\n', i) : bare.find("*/", i + 2);
        end = end == std::string::npos ? bare.size() : is_line ? end : end + 2;
        for (; i < end; ++i)
            if (bare[i] != '\n') bare[i] = ' ';
        --i;
    }
    for (std::size_t begin = 0; begin < bare.size();) {
        const std::size_t end = std::min(bare.find('\n', begin), bare.size());
        if (holds(std::string_view(bare).substr(begin, end - begin))) return begin;
        begin = end + 1;
    }
    return std::nullopt;
}

bool is_system_line(std::string_view line) {
    return line.starts_with("Lsystem:") || line.starts_with("lsystem:");
}
/// A line that only a program in L+C has.
bool is_plus_line(std::string_view line) {
    const std::string_view said = trimmed(line);
    return (said.starts_with("#include") && said.find("lpfgall.h") != std::string_view::npos) ||
           (said.starts_with("module ") && said.find('(') != std::string_view::npos &&
            said.ends_with(';'));
}
bool is_panel_line(std::string_view line) {
    return line.starts_with("panel name:") || line.starts_with("target:");
}

}  // namespace

Model read_cpfg(std::string_view text, const std::string& name) {
    if (looks_like_panel(text)) {
        const std::string kept(text);
        const Source source(kept, name);
        throw Diagnostics({source.finding(
            first_line_that(text, is_panel_line).value_or(0),
            "a control panel of vlab, which holds no system: expected the system that it is for")});
    }
    if (looks_like_lpfg(text)) return read_lpfg(text, name);
    const auto [file, entry] = file_and_entry(name);
    return Reader(text, file, {false, "cpfg", 45}, entry).read();
}

Model read_lpfg(std::string_view text, const std::string& name) {
    return Reader(text, name, {false, "lpfg", 45, true}).read();
}

Model read_lpy(std::string_view text, const std::string& name) {
    return Reader(text, name, {true, "lpy", 60}).read();
}

bool looks_like_cpfg(std::string_view text) {
    return first_line_that(text, is_system_line).has_value();
}

bool looks_like_lpfg(std::string_view text) {
    return !looks_like_cpfg(text) && first_line_that(text, is_plus_line).has_value();
}

bool looks_like_panel(std::string_view text) {
    return !looks_like_cpfg(text) && !looks_like_fractint(text) &&
           first_line_that(text, is_panel_line).has_value();
}

}  // namespace algae
