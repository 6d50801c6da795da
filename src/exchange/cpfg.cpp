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

// L-systems of cpfg (`*.l`) and the declarative part of L-Py (`*.lpy`): contexts, parameters, conditions, choices, a homomorphism.
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
// them is refused. With `seed:` all rules that apply take part with their weights: those of one module must have the same contexts
// and no conditions here. The turtle looks up the page, `+` turns to the left, by 45 degrees where no view file says otherwise, in L-Py by 60.
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
    Reader(std::string_view text, const std::string& name, const CpfgDialect& dialect)
        : dialect_(dialect), text_(text), source_(text_, name), findings_(source_) {}

    Model read() {
        const Placed whole = preprocessed(source_, dialect_);
        if (dialect_.python) generation_ = "1";
        if (dialect_.python)
            read_python(whole);
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

    void read_cpfg(const Placed& whole) {
        enum { before, header, rules, decomposition, homomorphism, after } state = before;
        bool has_rules = false;  // a rule or an empty line
        for (const Placed& line : statements(whole)) {
            const Placed said = line.trimmed();
            has_rules = has_rules || (state == rules && said.text != "endlsystem");
            if (said.text.empty() || state == after) continue;
            const std::size_t place = said.at.front();
            if (state == before) {
                if (!behind(said, {"Lsystem:", "lsystem:"}))
                    fail(place, "expected 'Lsystem: 1', found '" + said.text.substr(0, 40) + "'");
                state = header;
                continue;
            }
            if (said.text == "endlsystem" || said.text == "Endlsystem" ||
                said.text == "EndLsystem") {
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
                if (state == decomposition) depth_ = number(*depth, "a depth");
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
        if (state == before) fail(0, "expected 'Lsystem: 1', found none");
        if (state != after) fail(text_.size(), "expected 'endlsystem', found the end of the file");
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
        for (const Placed& line : statements(whole)) {
            const Placed said = line.trimmed();
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
                if (state == decomposition) depth_ = number(*depth, "a depth");
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
            if (said.text.find("-->") != std::string::npos) {
                (state == homomorphism    ? interpretation_
                 : state == decomposition ? decomposition_
                                          : rules_)
                    .push_back(rule(said));
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

    // --- Rules ---

    Rule rule(const Placed& line) const {
        const std::size_t arrow = line.text.find("-->");
        if (arrow == std::string::npos) {
            if (line.text.find("-o>") != std::string::npos)
                refuse(line.at.front(), "-o>", "has no meaning in the notation");
            fail(line.at.front(),
                 "expected a rule with '-->', found '" + line.text.substr(0, 40) + "'");
        }
        Rule found;
        found.place = line.at.front();
        Placed head = line.part(0, arrow), body = line.part(arrow + 3, line.text.size()).trimmed();
        if (const std::size_t colon = outside(head.text, ':'); colon != std::string::npos) {
            found.condition = head.part(colon + 1, head.text.size()).trimmed();
            head = head.part(0, colon);
            if (dialect_.python)
                refuse(found.condition->place(0), "a rule with a block",
                       "is Python: expected only -->");
            if (found.condition->text.find_first_of("{}") != std::string::npos)
                refuse(found.condition->place(0), "a block of statements",
                       "has no meaning in the notation");
            if (found.condition->text == "*") found.condition.reset();
        }
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
        if (strict.size() > 1)
            refuse(strict[1].place, "a predecessor of several modules",
                   "is one rule for all of them, which has no meaning in the notation");
        found.predecessor = strict.front();
        check_formals(found.predecessor);
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
            if (first != "@" && first != "~" && first != "?") {
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

    std::vector<Module> single_modules(const Placed& text) const {
        std::vector<Module> found;
        for (std::size_t i = 0; i < text.text.size();) {
            const char c = text.text[i];
            if (c == ' ' || c == '\t') {
                ++i;
                continue;
            }
            Module module;
            module.place = text.place(i);
            if (c == '(' || c == ')') fail(module.place, std::string("unmatched '") + c + "'");
            if (static_cast<unsigned char>(c) >= 0x80)
                fail(module.place, "expected a symbol of ASCII");
            std::size_t size = 1;
            for (const std::string& name : modules_)
                if (name.size() > size && text.text.compare(i, name.size(), name) == 0)
                    size = name.size();
            module.symbol = text.text.substr(i, size);
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

    // --- The notation ---

    /// The symbol's name there.
    std::string name(const Module& module) const {
        const std::string& symbol = module.symbol;
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

    /// Symbols that are parts of commands may have no rules of their own here.
    void check_commands() const {
        for (const std::string& met : met_) {
            if (met.size() != 2 || std::string_view("@~?").find(met[0]) == std::string_view::npos)
                continue;
            for (const auto* rules : {&rules_, &interpretation_, &decomposition_})
                for (const Rule& rule : *rules) {
                    const std::string& symbol = rule.predecessor.symbol;
                    if (symbol == met.substr(0, 1) || symbol == met.substr(1))
                        refuse(rule.predecessor.place, "a rule for " + symbol,
                               "rewrites a part of the command " + met +
                                   ", which is one symbol in the notation");
                }
        }
    }

    std::string written(const std::vector<Module>& word, const std::set<std::string>& names) {
        std::vector<std::string> parts;
        for (const Module& module : word) {
            std::string text = name(module);
            met_.insert(text);
            met_kinds_.insert(text + "/" + std::to_string(module.arguments.size()));
            if (!module.arguments.empty()) {
                std::vector<std::string> arguments;
                for (const Placed& argument : module.arguments)
                    arguments.push_back(expression(argument, names));
                text += "(" + joined(arguments, ",") + ")";
            }
            parts.push_back(text);
        }
        return parts.empty() ? "ε" : spaced_word(parts);
    }

    static std::set<std::string> formals(const Rule& rule) {
        std::set<std::string> names;
        const auto add = [&](const Module& module) {
            for (const Placed& formal : module.arguments) names.insert(formal.text);
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

    /// What a decomposition makes of a word, as deep as it goes.
    std::vector<Module> decomposed(const std::vector<Module>& word, std::uint64_t depth) const {
        constexpr std::size_t longest = 100'000;
        std::vector<Module> found;
        for (const Module& module : word) {
            const Rule* const rule = depth == 0 ? nullptr : decomposition_of(module);
            if (!rule) {
                found.push_back(module);
            } else {
                std::map<std::string, Placed> values;
                for (std::size_t i = 0; i < module.arguments.size(); ++i)
                    values.emplace(rule->predecessor.arguments[i].text, module.arguments[i]);
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
                if (rule.condition)
                    refuse(
                        rule.condition->place(0), "a condition beside weights",
                        "changes the weights of the others, which has no meaning in the notation");
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
            if (all.size() == 1) {
                text += head(rule, "") + " -> " + written(successor(rule), formals(rule)) + "\n";
                all.clear();
                continue;
            }
            Rational sum = 0;
            for (const Rule* one : all) sum += weight(*one);
            for (const Rule* one : all)
                text += head(*one, "") + " -(" + to_string(weight(*one) / sum) + ")-> " +
                        written(successor(*one), formals(*one)) + "\n";
            all.clear();
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
            constants += "let " + called + " = " + expression(value, {}) + "\n";
            known_.emplace(called, called);
        }
        if (!dialect_.python) {
            known_.emplace("Q", "");
            known_.emplace("Z", generation_.empty() ? "0" : generation_);
        }
        rewrites_cut_ = std::ranges::any_of(
            rules_, [](const Rule& rule) { return rule.predecessor.symbol == "%"; });
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
            if (!rule.left.empty() || !rule.right.empty() || rule.weight)
                refuse(rule.place, "a homomorphism with contexts or weights",
                       "has no meaning in the notation");
            const std::set<std::string> own = formals(rule);
            std::vector<Module> image = modules(rule.successor);
            std::erase_if(image, [](const Module& module) { return module.symbol == "%"; });
            for (const Module& module : image)
                if (interpreted.contains(kind(module)))
                    refuse(module.place, "a homomorphism of what a homomorphism gives",
                           "is applied once there, and until nothing is left in the notation");
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

    std::string expression(const Placed& text, const std::set<std::string>& names) const {
        return cpfg_expression(source_, dialect_, text, names, known_);
    }

    CpfgDialect dialect_;
    std::string text_;
    Source source_;
    Findings findings_;
    std::vector<std::pair<std::string, Placed>> constants_;
    CpfgNames known_;
    std::vector<std::string> modules_;
    Placed axiom_;
    std::vector<Rule> rules_, decomposition_, interpretation_, added_;
    std::uint64_t depth_ = 1;  // of the decomposition
    std::optional<Placed> ignored_, considered_;
    std::string generation_;
    bool stochastic_ = false, rewrites_cut_ = false;
    std::set<std::string> met_, met_kinds_;  // symbols, and with the number of their parameters
    mutable std::optional<std::size_t> cut_, move_, polygon_;  // where the first stands
};

}  // namespace

Model read_cpfg(std::string_view text, const std::string& name) {
    if (text.find("#include <lpfgall.h>") != std::string_view::npos ||
        text.find("produce") != std::string_view::npos)
        throw Error(name +
                    ": is a program of lpfg in L+C; only declarative systems of cpfg are read");
    return Reader(text, name, {false, "cpfg", 45}).read();
}

Model read_lpy(std::string_view text, const std::string& name) {
    return Reader(text, name, {true, "lpy", 60}).read();
}

bool looks_like_cpfg(std::string_view text) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        if (line.starts_with("Lsystem:") || line.starts_with("lsystem:")) return true;
        begin = end + 1;
    }
    return false;
}

}  // namespace algae
