#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/detail/scanner.hpp"
#include "model/model.hpp"

// The declarative part of a program of lpfg, whose language is L+C.
//
//     #include <lpfgall.h>
//     const float STEP = 2;
//     derivation length: 3;
//     module A(float);
//     Axiom: A(1);
//     production:
//     A(x) : { if (x < 4) produce F(x) Left(30) A(x*STEP); }
//
// All else is C++, and refused with its place. Lines mean nothing; statements end with `;`.

namespace algae {

namespace {

class LpfgFile : CpfgReader {
public:
    LpfgFile(const Source& source, const CpfgDialect& dialect) : CpfgReader(source, dialect) {}

    CpfgSystem read(const Placed& text) {
        std::vector<CpfgRule>* rules = &system_.rules;
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
                system_.generation =
                    std::to_string(number(up_to_semicolon(text, at, at), "a derivation length"));
            } else if (keyword({"maximum depth:"})) {
                const std::uint64_t depth = number(up_to_semicolon(text, at, at), "a depth");
                if (rules == &system_.decomposition) system_.depth = depth;
                if (rules == &system_.interpretation) system_.drawn_depth = depth;
            } else if (keyword({"Axiom:", "axiom:"})) {
                if (!system_.axiom.text.empty()) fail(place, "a second axiom");
                system_.axiom = up_to_semicolon(text, at, at);
            } else if (keyword({"ignore:"})) {
                system_.ignored = up_to_semicolon(text, at, at);
                system_.considered.reset();
            } else if (keyword({"consider:"})) {
                system_.considered = up_to_semicolon(text, at, at);
                system_.ignored.reset();
            } else if (keyword({"production:", "productions:"})) {
                rules = &system_.rules;
            } else if (keyword({"decomposition:"})) {
                rules = &system_.decomposition;
            } else if (keyword({"homomorphism:", "interpretation:"})) {
                rules = &system_.interpretation;
            } else if (keyword({"ring L-system:", "ring lsystem:"})) {
                if (number(up_to_semicolon(text, at, at), "0 or 1") != 0) system_.ring = place;
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
        return std::move(system_);
    }

private:
    /// What stands up to the `;`, behind a keyword.
    Placed up_to_semicolon(const Placed& text, std::size_t from, std::size_t& at) const {
        const std::size_t end = text.text.find(';', from);
        if (end == std::string::npos)
            fail(text.place(from), "expected ';' behind " + shown(text, at) + ", found none");
        at = end + 1;
        return text.part(from, end).trimmed();
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
        declare(name, said.place(0));
        system_.types[name] = types;
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
        system_.constants.emplace_back(name, said.part(equals + 1, said.text.size()).trimmed());
        if (type == "int") system_.integers.insert(name);
    }

    /// `left < A(x) > right : { ... }`; gives where the text goes on.
    std::size_t plus_rule(const Placed& text, std::size_t at, std::vector<CpfgRule>& all) {
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
        const CpfgRule head = head_of(text.part(begin, colon));
        const std::size_t end = closing(text, brace);
        Local local;
        for (const auto* side : {&head.left, &head.right})
            for (const CpfgModule& module : *side) add_formals(module, local);
        add_formals(head.predecessor, local);
        plus_block(text.part(brace + 1, end), head, {}, local, all);
        return end + 1;
    }

    /// What a block has assigned so far, and the types of the names that it may assign: its own, and the parameters of the rule.
    struct Local {
        std::map<std::string, Placed> values;
        std::map<std::string, std::string> types;
    };
    void add_formals(const CpfgModule& module, Local& local) const {
        const auto types = system_.types.find(module.symbol);
        for (std::size_t i = 0; i < module.arguments.size(); ++i)
            local.types[module.arguments[i].text] =
                types != system_.types.end() && i < types->second.size() ? types->second[i]
                                                                         : "float";
    }
    /// `x = 0.5*t`, `float x = 0.5*t`: with the type that the value gets.
    void assign_local(const Placed& said, Local& local) const {
        constexpr std::size_t longest = 10'000;
        std::size_t at = 0;
        std::string type = name_at(said, 0);
        if (type == "const") type = name_at(said, at = next(said, type.size()));
        const bool declares = type == "int" || type == "float" || type == "double";
        if (declares) at = next(said, at + type.size());
        const std::string name = name_at(said, at);
        const std::size_t sign = next(said, at + name.size());
        const bool assigns = !name.empty() && sign < said.text.size() && said.text[sign] == '=' &&
                             (sign + 1 == said.text.size() || said.text[sign + 1] != '=') &&
                             outside(said.text.substr(sign), ',') == std::string::npos;
        if (!assigns)
            refuse(said.place(0), "a statement of C++",
                   "is not read: expected produce, if, else or NAME = number; found " +
                       shown(said, 0));
        if (!declares && !local.types.contains(name))
            refuse(said.place(at), "an assignment to " + name,
                   "is read only of parameters of the rule and of names that the same block "
                   "declares, as in `float " +
                       name + " = 1;`");
        if (!declares) type = local.types.at(name);
        Placed value;
        for (const char c : type == "int" ? std::string_view("int(") : std::string_view("float("))
            value.add(c, said.place(sign));
        const Placed given = said.part(sign + 1, said.text.size()).trimmed();
        if (given.text.empty()) fail(said.place(sign), "expected a number behind '='");
        value.append(cpfg_with(given, local.values));
        value.add(')', said.place(sign));
        if (value.text.size() > longest)
            refuse(said.place(0), "a block",
                   "that gives an expression of more than 10000 characters");
        local.types[name] = type;
        local.values[name] = std::move(value);
    }

    void plus_block(const Placed& block, const CpfgRule& head, const std::vector<Placed>& path,
                    Local local, std::vector<CpfgRule>& all) const {
        for (std::size_t at = next(block, 0); at < block.text.size(); at = next(block, at))
            at = plus_statement(block, at, head, path, local, all);
    }

    /// Reads one statement; gives where the text goes on.
    std::size_t plus_statement(const Placed& text, std::size_t at, const CpfgRule& head,
                               std::vector<Placed> path, Local& local,
                               std::vector<CpfgRule>& all) const {
        constexpr std::size_t deepest = 100;
        if (at >= text.text.size())
            fail(text.place(at), "expected a statement, found the end of the block");
        if (path.size() > deepest)
            fail(text.place(at), "more than 100 conditions within each other");
        const std::size_t place = text.place(at);
        if (text.text[at] == ';') return at + 1;
        if (text.text[at] == '{') {
            const std::size_t end = closing(text, at);
            plus_block(text.part(at + 1, end), head, path, within(local), all);
            return end + 1;
        }
        const std::string word = name_at(text, at);
        if (word == "produce") {
            std::size_t end = at;
            add_produced(
                all, head, path,
                cpfg_with_in_numbers(up_to_semicolon(text, at + word.size(), end), local.values),
                place);
            return end;
        }
        if (word == "if") {
            const std::size_t open = next(text, at + word.size());
            if (open >= text.text.size() || text.text[open] != '(')
                fail(text.place(open), "expected '(' behind 'if', found " + shown(text, open));
            const std::size_t close = closing(text, open);
            const Placed condition = cpfg_with(text.part(open + 1, close).trimmed(), local.values);
            Local inner = within(local), other_inner = inner;
            path.push_back(side(condition, true));
            at = plus_statement(text, next(text, close + 1), head, path, inner, all);
            const std::size_t other = next(text, at);
            if (name_at(text, other) != "else") return at;
            path.back() = side(condition, false);
            return plus_statement(text, next(text, other + 4), head, path, other_inner, all);
        }
        if (word == "nproduce")
            refuse(place, "nproduce",
                   "goes on behind what it makes, which is not read: expected produce");
        std::size_t end = text.text.find(';', at);
        if (end == std::string::npos) end = text.text.size();
        assign_local(text.part(at, end).trimmed(), local);
        return end + 1;
    }
    /// In a block within another what that one assigned may be read and not assigned, since it would be known behind the block.
    static Local within(const Local& local) { return {local.values, {}}; }
};

}  // namespace

Model read_lpfg(std::string_view text, const std::string& name) {
    const std::string kept(text);
    const Source source(kept, name);
    const CpfgDialect dialect{false, "lpfg", 45, true};
    return cpfg_model(source, dialect,
                      LpfgFile(source, dialect).read(preprocessed(source, dialect)));
}

}  // namespace algae
