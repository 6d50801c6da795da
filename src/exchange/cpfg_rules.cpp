#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/scanner.hpp"

// Modules and rules of cpfg, L-Py and lpfg, and the lines that files of more than one of them have.
//
// Each module is a single character; in L-Py a name that `module` declares is one symbol, in L+C all modules are names. Commands of several
// symbols, `@v`, are one module each. A rule is `left < A(x) > right : condition --> successor : weight`; a block of `produce`, `if` and `else` is a rule
// with conditions for each `produce`, in this order.

namespace algae {

const std::vector<std::pair<std::string, std::string>>& lpy_names() {
    static const std::vector<std::pair<std::string, std::string>> all{
        {"Left", "+"},       {"Right", "-"},       {"Down", "&"},     {"Up", "^"},
        {"RollL", "/"},      {"RollR", "\\"},      {"Sphere", "@O"},  {"SetColor", ";"},
        {"TurnAround", "|"}, {"RollToVert", "@v"}, {"SetWidth", "!"}, {"Cut", "%"}};
    return all;
}

void CpfgReader::fail(std::size_t place, const std::string& message) const {
    cpfg_fail(source_, place, message);
}

void CpfgReader::refuse(std::size_t place, const std::string& what, const std::string& why) const {
    fail(place, what + " " + why);
}

std::vector<Placed> CpfgReader::statements(const Placed& whole) const {
    std::vector<Placed> out(1);
    int open = 0;
    // Of a line of cpfg: whether it may have blocks, behind a colon and before an arrow, and how many braces are open in them.
    bool may_have_blocks = false, is_word = false;
    int braces = 0;
    const auto begins_word = [&] {
        const std::string& before = out.back().text;
        return before == "Axiom" || before == "axiom" || before == "ignore" || before == "Ignore" ||
               before == "consider" || before == "Consider";
    };
    for (std::size_t i = 0; i < whole.text.size(); ++i) {
        const char c = whole.text[i];
        if (c == '(') ++open;
        if (c == ')') open = std::max(0, open - 1);
        const bool goes_on =
            !dialect_.python && i + 1 < whole.text.size() && whole.text[i + 1] == '\t';
        if (c == ':' && open == 0 && !may_have_blocks && !is_word) {
            is_word = begins_word();
            may_have_blocks = !is_word && !dialect_.python;
        }
        if (may_have_blocks && (c == '{' || c == '}')) braces += c == '{' ? 1 : -1;
        if (c == '>' && out.back().text.ends_with("--")) {
            may_have_blocks = false;
            is_word = true;
        }
        if (c != '\n') {
            out.back().add(c, whole.at[i]);
        } else if (goes_on || (open > 0 && dialect_.python) || (may_have_blocks && braces > 0)) {
            out.back().add(' ', whole.at[i]);
        } else {
            out.emplace_back();
            open = 0;
            may_have_blocks = is_word = false;
            braces = 0;
        }
    }
    return out;
}

std::optional<std::size_t> CpfgReader::keyword_size(
    const Placed& text, std::initializer_list<const char*> keywords) const {
    for (const char* keyword : keywords) {
        std::size_t at = 0;
        bool fits = true;
        for (const char* c = keyword; *c && fits; ++c) {
            if (*c == ' ') {
                const std::size_t from = at;
                if (dialect_.plus)
                    at = next(text, at);
                else
                    while (at < text.text.size() && text.text[at] == ' ') ++at;
                fits = at > from || !dialect_.plus;
            } else {
                if (*c == ':' && dialect_.plus) at = next(text, at);
                fits = at < text.text.size() && text.text[at++] == *c;
            }
        }
        if (fits) return at;
    }
    return std::nullopt;
}

std::optional<Placed> CpfgReader::behind(const Placed& line,
                                         std::initializer_list<const char*> keywords) const {
    const std::optional<std::size_t> size = keyword_size(line, keywords);
    if (!size) return std::nullopt;
    return line.part(*size, line.text.size()).trimmed();
}

std::size_t CpfgReader::next(const Placed& text, std::size_t at) {
    while (at < text.text.size() && std::isspace(static_cast<unsigned char>(text.text[at]))) ++at;
    return at;
}

std::size_t CpfgReader::closing(const Placed& text, std::size_t at) const {
    const char open = text.text[at], close = open == '(' ? ')' : '}';
    int depth = 0;
    for (std::size_t i = at; i < text.text.size(); ++i) {
        if (text.text[i] == open) ++depth;
        if (text.text[i] == close && --depth == 0) return i;
    }
    fail(text.place(at), std::string("unmatched '") + open + "'");
}

std::string CpfgReader::name_at(const Placed& text, std::size_t at) {
    std::size_t end = at;
    if (end < text.text.size() && is_name_start(text.text[end]))
        while (end < text.text.size() && is_name_part(text.text[end])) ++end;
    return text.text.substr(at, end - at);
}

std::string CpfgReader::shown(const Placed& text, std::size_t at) {
    const std::string rest = text.text.substr(at, 40);
    return at >= text.text.size() ? "the end of the file"
                                  : "'" + rest.substr(0, rest.find('\n')) + "'";
}

std::size_t CpfgReader::outside(const std::string& text, char wanted) {
    int open = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(') ++open;
        if (text[i] == ')') --open;
        if (text[i] == wanted && open == 0) return i;
    }
    return std::string::npos;
}

std::uint64_t CpfgReader::number(const Placed& text, const char* what) const {
    const auto none = [](const std::string&) -> const Quantity* { return nullptr; };
    constexpr int most = 1'000'000'000;
    try {
        const Quantity value =
            evaluate(read_expression(cpfg_expression(source_, dialect_, text, {}, {})), none);
        if (value.exact && value.exact->is_integer() && sign(*value.exact) >= 0 &&
            *value.exact <= Rational(most))
            return floor(*value.exact).to_uint64();
    } catch (const Diagnostics&) {
    }
    fail(text.place(0),
         std::string("expected ") + what + ", a whole number from 0 on, found '" + text.text + "'");
}

bool CpfgReader::read_header(const Placed& said) {
    const std::size_t place = said.at.front();
    if (const auto value = behind(said, {"derivation length:", "Derivation length:"})) {
        system_.generation = std::to_string(number(*value, "a derivation length"));
        return true;
    }
    if (const auto value = behind(said, {"seed:", "Seed:"})) {
        system_.stochastic = true;
        return true;
    }
    if (const auto value = behind(said, {"ignore:", "Ignore:"})) {
        system_.ignored = *value;
        system_.considered.reset();
        return true;
    }
    if (const auto value = behind(said, {"consider:", "Consider:"})) {
        system_.considered = *value;
        system_.ignored.reset();
        return true;
    }
    if (behind(said, {"ring lsystem", "Ring lsystem"})) return system_.ring = place, true;
    if (behind(said, {"define:", "Define:"}))
        refuse(place, "arrays", "have no meaning in the notation");
    return read_header_block(said);
}

CpfgRule CpfgReader::rule(const Placed& line) const {
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
        if (condition->text == "*") condition.reset();
    }
    CpfgRule found = head_of(head);
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
    read_blocks(found);
    return found;
}

CpfgRule CpfgReader::head_of(Placed head) const {
    CpfgRule found;
    head = head.trimmed();
    found.place = head.place(0);
    for (const char* pair : {"<<", ">>"})
        if (const std::size_t at = head.text.find(pair); at != std::string::npos)
            refuse(head.place(at), std::string("the context ") + pair,
                   "looks at the string being made, which has no meaning in the notation");
    if (const std::size_t at = outside(head.text, '<'); at != std::string::npos) {
        found.left = context(head.part(0, at));
        refuse_brackets(found.left, "a left context");
        head = head.part(at + 1, head.text.size());
    }
    if (const std::size_t at = outside(head.text, '>'); at != std::string::npos) {
        found.right = context(head.part(at + 1, head.text.size()));
        std::size_t open = 0;
        for (const CpfgModule& module : found.right) {
            open += module.symbol == "[";
            if (module.symbol == "]" && open-- == 0)
                fail(module.place,
                     "expected a right context that is a tree, found a ']' that closes nothing");
        }
        head = head.part(0, at);
    }
    const std::vector<CpfgModule> strict = modules(head);
    if (strict.empty()) fail(found.place, "expected a module before '-->'");
    found.predecessor = strict.front();
    for (const CpfgModule& module : strict) check_formals(module);
    if (strict.size() > 1) {
        refuse_brackets(strict, "a predecessor of several modules");
        found.several = strict;
    }
    return found;
}

void CpfgReader::refuse_brackets(const std::vector<CpfgModule>& modules, const char* where) const {
    for (const CpfgModule& module : modules)
        if (module.symbol == "[" || module.symbol == "]")
            refuse(module.place, std::string("a bracket in ") + where,
                   "has no meaning in the notation, where contexts and predecessors lie on a path "
                   "to the root");
}

std::vector<CpfgModule> CpfgReader::context(const Placed& text) const {
    const Placed said = text.trimmed();
    if (said.text == "*" || said.text.empty()) return {};
    std::vector<CpfgModule> found = modules(said), kept;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i].symbol == "=") {
            if (kept.empty() || i + 1 == found.size() || found[i + 1].symbol != "]")
                refuse(found[i].place, "= in a context",
                       "skips what follows in a branch, and has a meaning in the notation only "
                       "between a module and its ]");
            kept.back().open = true;
            continue;
        }
        check_formals(found[i]);
        kept.push_back(std::move(found[i]));
    }
    return kept;
}

void CpfgReader::check_formals(const CpfgModule& module) const {
    for (const Placed& formal : module.arguments)
        if (formal.text.empty() || !is_name_start(formal.text[0]) ||
            !std::ranges::all_of(formal.text, is_name_part))
            fail(formal.place(0), "expected a name as parameter, found '" + formal.text + "'");
}

void CpfgReader::add_produced(std::vector<CpfgRule>& all, const CpfgRule& head,
                              const std::vector<Placed>& path, Placed successor,
                              std::size_t place) const {
    CpfgRule one = head;
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

Placed CpfgReader::side(const Placed& condition, bool holds) const {
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

void CpfgReader::declare(const std::string& name, std::size_t place) {
    if (name.starts_with("F_") || name.starts_with("f_"))
        fail(place, "the turtle of the notation draws and moves with names such as " + name +
                        ": expected another name");
    if (name.starts_with("X_") && name.find_first_not_of("0123456789", 2) == std::string::npos)
        fail(place, "names such as " + name +
                        " stand for letters that the notation has no symbols for: expected "
                        "another name");
    system_.modules.push_back(name);
}

std::vector<CpfgModule> CpfgReader::modules(const Placed& text) const {
    std::vector<CpfgModule> found;
    for (CpfgModule& module : single_modules(text)) {
        const std::string first = found.empty() ? "" : found.back().symbol;
        const bool takes_two = !dialect_.python && (first == "@G" || first == "@T");
        if (first != "@" && first != "~" && first != "?" && !takes_two) {
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

std::size_t CpfgReader::plus_name(const Placed& text, std::size_t at, CpfgModule& module) const {
    static const std::map<std::string, std::string> known{
        {"F", "F"},      {"f", "f"},        {"G", "G"},          {"g", "g"},
        {"Left", "+"},   {"Right", "-"},    {"Down", "&"},       {"Up", "^"},
        {"RollL", "\\"}, {"RollR", "/"},    {"TurnAround", "|"}, {"RollToVert", "@v"},
        {"SB", "["},     {"EB", "]"},       {"SP", "{"},         {"EP", "}"},
        {"PP", "."},     {"SetWidth", "!"}, {"SetColor", ";"},   {"IncColor", ";"},
        {"Cut", "%"},    {"Sphere", "@O"}};
    const std::string name = name_at(text, at);
    if (name.empty())
        fail(text.place(at), "expected the name of a module, found " + shown(text, at));
    std::vector<std::string> names = system_.modules;
    if (std::ranges::count(system_.modules, name) > 0) {
        module.symbol = name;
        return name.size();
    }
    const auto found = known.find(name);
    if (found == known.end()) {
        for (const auto& [own, symbol] : known) names.push_back(own);
        fail(text.place(at), "the module " + quoted(name) + " is not declared" +
                                 did_you_mean(name, names) +
                                 ": expected one of the file or of F, f, G, g, Left, Right, Down, "
                                 "Up, RollL, RollR, TurnAround, RollToVert, SB, EB, SP, EP, PP, "
                                 "SetWidth, SetColor, IncColor, Sphere, Cut");
    }
    module.symbol = found->second;
    return name.size();
}

std::vector<CpfgModule> CpfgReader::single_modules(const Placed& text) const {
    std::vector<CpfgModule> found;
    for (std::size_t i = 0; i < text.text.size();) {
        const char c = text.text[i];
        if (c == ' ' || c == '\t' || (dialect_.plus && (c == '\n' || c == '\r'))) {
            ++i;
            continue;
        }
        CpfgModule module;
        module.place = text.place(i);
        if (c == '(' || c == ')') fail(module.place, std::string("unmatched '") + c + "'");
        if (static_cast<unsigned char>(c) >= 0x80) fail(module.place, "expected a symbol of ASCII");
        std::size_t size = 1;
        if (dialect_.plus) size = plus_name(text, i, module);
        for (const std::string& name : system_.modules)
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

}  // namespace algae
