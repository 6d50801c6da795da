#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <optional>
#include <ranges>
#include <set>
#include <string>
#include <utility>

#include "exchange/detail/formats.hpp"
#include "exchange/detail/plain_rules.hpp"
#include "exchange/detail/scanner.hpp"
#include "model/model.hpp"

// Text files of a geometric interpreter of D0L systems (Brno, 2008).
//
// A file has sections: modules, axiom, angles, rules. Modules are letters, each with a primitive that it
// draws: a cylinder C(diameter, height), a line P(length), a ball S(diameter) or nothing; `+ - & ^ \ /` turn
// by the three angles U, L and H. Reading makes the text of a `.lsys` file of it, which is read in turn, so
// nothing is said in two ways. Where all lines are equally long they become F and f with a `step`, otherwise
// modules are interpreted with their measures.
//
// The turtle of the notation treats lines between braces as sides of a polygon, which are f there, and
// elsewhere as lines. So it matters where letters stand in the words of the system, which is decided from
// axiom and rules (`polygon_letters`). Printing goes the other way: what each letter makes the turtle do once
// `interpret` rules are applied must be one of the primitives, and all numbers whole; anything else is
// refused by name, so a file that is printed reads back as a system with the same words and figures.

namespace algae {

namespace {

bool braces_match(const std::string& word) {
    long depth = 0, least = 0;
    for (const char letter : word)
        least = std::min(least, depth += letter == '{' ? 1 : letter == '}' ? -1 : 0);
    return depth == 0 && least == 0;
}

}  // namespace

PolygonLetters polygon_letters(const std::string& axiom, const std::map<char, std::string>& rules) {
    const bool match =
        braces_match(axiom) && std::ranges::all_of(std::views::values(rules), braces_match);
    PolygonLetters letters;
    // Words still to be looked at, and whether they stand inside a polygon as a whole.
    std::vector<std::pair<const std::string*, bool>> words{{&axiom, false}};
    while (!words.empty()) {
        const auto [word, fenced] = words.back();
        words.pop_back();
        long depth = fenced ? 1 : 0;
        for (const char letter : *word) {
            if (letter == '{' || letter == '}') {
                if (match) depth += letter == '{' ? 1 : -1;
                continue;
            }
            const bool is_new =
                (depth > 0 ? letters.inside : letters.outside).insert(letter).second;
            const auto rule = rules.find(letter);
            if (is_new && rule != rules.end()) words.emplace_back(&rule->second, depth > 0);
        }
    }
    return letters;
}

std::vector<std::size_t> brace_depths(const std::string& word) {
    std::vector<std::size_t> depths;
    std::size_t depth = 0;
    for (const char letter : word) {
        if (letter == '{') ++depth;
        if (letter == '}' && depth > 0) --depth;
        depths.push_back(depth);
    }
    return depths;
}

namespace {

/// Every letter that occurs, in the order of the notation's symbols.
std::string letters_of(const BrnoSystem& system) {
    std::string letters;
    const auto add = [&](const std::string& word) {
        for (const char letter : word)
            if (letters.find(letter) == std::string::npos) letters += letter;
    };
    add(system.axiom);
    for (const auto& [letter, successor] : system.rules) add(letter + successor);
    return letters;
}

/// Writes what `interpret` and settings say of modules.
class Interpretations {
public:
    explicit Interpretations(const BrnoSystem& system)
        : system_(system), letters_(letters_of(system)) {
        drawn_ = polygon_letters(system.axiom, {system.rules.begin(), system.rules.end()}).outside;
    }

    std::string text() {
        const long length = equal_length();
        for (const char letter : letters_)
            if (std::isalpha(static_cast<unsigned char>(letter))) {
                const std::string own(1, letter);
                const std::string image = length > 0 ? step(letter) : measured(letter);
                const bool acts = own == "F" || own == "f" || own == "G";
                if (image != own && !(image == "ε" && !acts)) interpret(own, image);
            }
        const std::string angle = add_turns();
        return out_ + angle + (length > 1 ? "step " + std::to_string(length) + "\n" : "") + solids_;
    }

private:
    BrnoPrimitive primitive(char letter) const {
        const auto found = system_.modules.find(letter);
        return found == system_.modules.end() ? BrnoPrimitive() : found->second;
    }
    bool occurs(char letter) const { return letters_.find(letter) != std::string::npos; }

    /// A line that is nowhere but between braces is a side of a polygon.
    bool is_side(char letter) const { return !drawn_.contains(letter); }
    std::string step(char letter) const {
        if (primitive(letter).kind == 0) return "ε";
        return is_side(letter) ? "f" : "F";
    }

    /// The length of all lines if there is nothing but lines of one length, and F and f mean what
    /// they always do where others are to mean the same; otherwise 0.
    long equal_length() const {
        long length = 0;
        for (const char letter : letters_) {
            const BrnoPrimitive of = primitive(letter);
            if (of.kind == 0) continue;
            if (of.kind != 'P' || (length > 0 && of.length != length)) return 0;
            const char image = step(letter)[0];
            if (occurs(image) && (primitive(image).kind == 0 || step(image)[0] != image)) return 0;
            length = of.length;
        }
        return length;
    }

    std::string measured(char letter) {
        const BrnoPrimitive of = primitive(letter);
        const std::string length = fmt::format("({})", of.length);
        if (of.kind == 'C') return fmt::format("!({})F{}", of.diameter, length);
        if (of.kind == 'P' && is_side(letter)) return 'f' + length;
        if (of.kind == 'P') return (has_cylinders() ? "!(1)F" : "F") + length;
        if (of.kind != 'S') return "ε";
        // F and f stand for steps elsewhere.
        const std::string ball = letter == 'F' || letter == 'f' ? "B_1" : std::string(1, letter);
        if (solids_.find(' ' + ball + ' ') == std::string::npos)
            solids_ += "solid " + ball + " sphere radius\n";
        return ball + '(' + shortest_text(Rational(of.diameter, 2)) + ')';
    }
    bool has_cylinders() const {
        return std::ranges::any_of(letters_,
                                   [&](char letter) { return primitive(letter).kind == 'C'; });
    }

    /// Interprets turns by other angles than the first that is needed, which it gives.
    std::string add_turns() {
        long first = -1;
        for (const char vector : {'U', 'L', 'H'})
            for (const char* turn = brno_turns(vector); *turn; ++turn) {
                if (!occurs(*turn)) continue;
                const long angle = system_.angles.at(vector);
                if (first < 0) first = angle;
                const std::string own(1, *turn);
                if (angle != first) interpret(own, own + '(' + std::to_string(angle) + ')');
            }
        return first < 0 ? "" : "angle " + std::to_string(first) + "\n";
    }

    void interpret(const std::string& letter, const std::string& image) {
        out_ += "interpret " + letter + " -> " + image + "\n";
    }

    const BrnoSystem& system_;
    std::string letters_;
    std::set<char> drawn_;  // outside polygons
    std::string out_, solids_;
};

std::string word(const std::string& letters) { return letters.empty() ? "ε" : letters; }

}  // namespace

const char* brno_turns(char vector) { return vector == 'U' ? "+-" : vector == 'L' ? "&^" : "\\/"; }

std::string brno_notation(const BrnoSystem& system) {
    std::string out = "axiom " + word(system.axiom) + "\n";
    for (const auto& [letter, successor] : system.rules)
        out += letter + (" -> " + word(successor)) + "\n";
    return out + Interpretations(system).text();
}

namespace {

/// Between braces stand turns and lines only.
void check_polygons(const PlacedWord& word, const BrnoSystem& system, Findings& findings) {
    const std::vector<std::size_t> depths = brace_depths(word.text);
    for (std::size_t i = 0; i < word.text.size(); ++i) {
        const auto module = system.modules.find(word.text[i]);
        if (depths[i] == 0 || module == system.modules.end()) continue;
        const char kind = module->second.kind;
        if (kind == 'C' || kind == 'S')
            findings.add(
                word.offsets[i],
                fmt::format("expected turns and lines between '{{' and '}}', found '{}', a {}",
                            word.text[i], kind == 'C' ? "cylinder" : "ball"));
    }
}

/// Adds a finding for each bracket of a word that has no other, for each cylinder and ball between
/// braces, and for each angle that the word needs and the file does not give, unless it is among
/// those that are `missing` already.
void check_brno_word(const PlacedWord& word, const BrnoSystem& system, std::set<char>& missing,
                     Findings& findings) {
    check_brackets(word, findings);
    check_polygons(word, system, findings);
    for (const char vector : {'U', 'L', 'H'}) {
        const std::size_t at = word.text.find_first_of(brno_turns(vector));
        if (at == std::string::npos || system.angles.contains(vector) ||
            !missing.insert(vector).second)
            continue;
        findings.add(word.offsets[at],
                     fmt::format("expected the angle {} among the angles, as '{}' turns by it",
                                 vector, word.text[at]));
    }
}

/// Pixels beyond these no screen has.
constexpr long most_pixels = 1'000'000;

bool is_module(char c) { return std::isalpha(static_cast<unsigned char>(c)); }

/// Whether a line begins with the word `END` here, or what stands behind one of these.
bool is_end(std::string_view text, std::size_t at, std::string_view behind = "\n") {
    if (!text.substr(at).starts_with("END")) return false;
    const std::size_t before = text.substr(0, at).find_last_not_of(" \t\r");
    return (before == std::string_view::npos || behind.find(text[before]) != behind.npos) &&
           (at + 3 == text.size() || !std::isalnum(static_cast<unsigned char>(text[at + 3])));
}

/// Behind `END` anything may follow, text or not: then the text up to there.
std::string_view readable(std::string_view text) {
    if (Source(text, "").bad_bytes().empty()) return text;
    for (std::size_t at = text.find("END"); at != std::string_view::npos;
         at = text.find("END", at + 3))
        if (is_end(text, at, ";\n")) return text.substr(0, at + 3);
    return text;
}

class Reader {
public:
    Reader(std::string_view text, const std::string& name)
        : name_(name), source_(text, name), findings_(source_), scanner_(text, name, comments()) {}

    Model read() {
        try {
            section("modules", "at the beginning", [&] { read_module(); });
            keyword("axiom", "behind the modules");
            words_.emplace_back(0, word("the axiom"));
            scanner_.expect(";", "behind the axiom");
            section("angles", "behind the axiom", [&] { read_angle(); });
            section("rules", "behind the angles", [&] { read_rule(); });
            if (!scanner_.take_word("END")) scanner_.fail("'END' behind the rules");
        } catch (const Diagnostics& error) {
            add(findings_, error);
        } catch (const CannotGoOn&) {
        }
        std::set<char> missing;
        if (findings_.empty())
            for (const auto& [name, word] : words_)
                check_brno_word(word, system_, missing, findings_);
        findings_.throw_if_any();
        system_.axiom = words_.front().second.text;
        for (std::size_t i = 1; i < words_.size(); ++i)
            system_.rules.emplace_back(words_[i].first, words_[i].second.text);
        return read_written(brno_notation(system_), name_);
    }

private:
    /// Thrown where a section ends in the middle of a faulty item.
    struct CannotGoOn {};

    static std::vector<std::string> comments() { return {"//", "\\\\"}; }

    void keyword(const std::string& name, const std::string& where) {
        const std::size_t at = scanner_.offset();
        if (scanner_.take_word(name)) return scanner_.expect(":", "behind '" + name + "'");
        scanner_.fail_at(
            at, fmt::format("expected '{}:' {}, found {}", name, where, scanner_.found_next()));
    }

    /// A keyword, then items with ',' between them and ';' behind the last. Goes on behind a faulty
    /// item.
    template <class Item>
    void section(const std::string& name, const std::string& where, Item item) {
        keyword(name, where);
        if (name == "angles" && scanner_.take(";")) return;  // no word turns
        do {
            try {
                item();
                if (!at_item_end()) scanner_.fail("',' or ';'");
            } catch (const Diagnostics& error) {
                add(findings_, error);
                scanner_.set_comments(comments());
                while (!at_item_end() || at_measure()) {
                    if (scanner_.at_end() || at_keyword()) throw CannotGoOn();
                    scanner_.character("");
                }
            }
        } while (scanner_.take(","));
        scanner_.expect(";", "");
    }
    bool at_item_end() {
        const std::string_view rest = scanner_.rest();
        return rest.starts_with(',') || rest.starts_with(';');
    }
    /// Whether a comma stands between the numbers of a primitive.
    bool at_measure() {
        std::string_view rest = scanner_.rest();
        if (!rest.starts_with(',')) return false;
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t", 1), rest.size()));
        return !rest.empty() && is_digit(static_cast<unsigned char>(rest[0]));
    }
    /// Whether the next section begins, so that no word goes on.
    bool at_keyword() {
        const std::string_view rest = scanner_.rest();
        for (const char* name : {"modules:", "axiom:", "angles:", "rules:"})
            if (rest.starts_with(name)) return true;
        return is_end(source_.text(), scanner_.offset());
    }

    char letter(const std::string& expectation) {
        const std::string_view rest = scanner_.rest();
        if (rest.empty() || !is_module(rest[0])) scanner_.fail(expectation);
        if (rest.size() > 1 && std::isalnum(static_cast<unsigned char>(rest[1])))
            scanner_.fail(expectation);
        return scanner_.character("")[0];
    }

    long whole(const std::string& what, long least, long most) {
        const std::size_t at = scanner_.offset();
        const Rational value = scanner_.number(what, least, most);
        if (!value.is_integer())
            scanner_.fail_at(at,
                             fmt::format("expected {}, found '{}'", what, shortest_text(value)));
        return static_cast<long>(value.numerator().to_int64());
    }
    long pixels(const std::string& what) {
        return whole(what + ", a whole number of pixels", 1, most_pixels);
    }

    void read_module() {
        const std::size_t at = scanner_.offset();
        const char name = letter("a module, one letter");
        BrnoPrimitive primitive;
        try {
            if (scanner_.take("=")) primitive = read_primitive();
        } catch (const Diagnostics&) {
            system_.modules.emplace(name, primitive);  // declared, if not well
            throw;
        }
        if (!system_.modules.emplace(name, primitive).second)
            findings_.add(at, fmt::format("the module {} is declared twice", name));
    }
    BrnoPrimitive read_primitive() {
        const std::string what = "C(diameter, height), P(length) or S(diameter)";
        const std::string_view rest = scanner_.rest();
        if (rest.empty() || !std::strchr("CPScps", rest[0]) || rest[0] == 0) scanner_.fail(what);
        BrnoPrimitive primitive;
        const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(letter(what))));
        primitive.kind = kind;
        scanner_.expect("(", fmt::format("behind {}", kind));
        if (kind != 'P') primitive.diameter = pixels("a diameter");
        if (kind == 'C') scanner_.expect(",", "behind the diameter");
        if (kind != 'S') primitive.length = pixels(kind == 'C' ? "a height" : "a length");
        scanner_.expect(")", kind == 'S'   ? "behind the diameter"
                             : kind == 'C' ? "behind the height"
                                           : "behind the length");
        return primitive;
    }

    void read_angle() {
        const std::size_t at = scanner_.offset();
        const char name = letter("an angle, L, U or H");
        if (!std::strchr("LUH", name))
            scanner_.fail_at(at, fmt::format("expected an angle, L, U or H, found '{}'", name));
        scanner_.expect("=", fmt::format("behind the angle {}", name));
        const long degrees = whole("a whole number of degrees", 0, 360);
        if (!system_.angles.emplace(name, degrees).second)
            findings_.add(at, fmt::format("the angle {} is given twice", name));
    }

    void read_rule() {
        const std::size_t at = scanner_.offset();
        const char name = letter("a rule, which begins with a module");
        check_declared(name, at);
        scanner_.expect("->", fmt::format("behind {}", name));
        if (std::ranges::count(words_, name, &std::pair<char, PlacedWord>::first) > 0)
            findings_.add(at, fmt::format("the second rule for {}, expected one", name));
        words_.emplace_back(name, word(fmt::format("the rule for {}", name)));
    }

    void check_declared(char letter, std::size_t at, const std::string& hint = "") {
        if (system_.modules.contains(letter)) return;
        const std::string message =
            fmt::format("expected a declared module, found '{}'{}", letter, hint);
        if (!hint.empty()) scanner_.fail_at(at, message);
        if (undeclared_.insert(letter).second) findings_.add(at, message);
    }

    /// Modules and symbols of the turtle up to ',', ';' or the next section. Two rolls begin no
    /// comment here.
    PlacedWord word(const std::string& what) {
        scanner_.set_comments({});
        PlacedWord word;
        std::string hint;
        while (!scanner_.at_end() && !at_item_end() && !at_keyword()) {
            const std::size_t at = scanner_.offset();
            const std::string character = scanner_.character("");
            const char letter = character[0];
            if (is_module(letter))
                check_declared(letter, at, hint);
            else if (letter == 0 || !std::strchr(brno_turtle_symbols, letter))
                scanner_.fail_at(
                    at, fmt::format("expected a module, a symbol of the turtle, ',' or ';' in {}, "
                                    "found {}{}",
                                    what, algae::quoted(character), hint));
            if ((letter == '/' || letter == '\\') && word.text.ends_with(letter))
                hint = "; in words two rolls begin no comment";
            word.add(character, at);
        }
        scanner_.set_comments(comments());
        return word;
    }

    std::string name_;
    Source source_;
    Findings findings_;
    Scanner scanner_;
    BrnoSystem system_;
    std::vector<std::pair<char, PlacedWord>> words_;  // the axiom, then those of the rules
    std::set<char> undeclared_;                       // told already
};

std::string text_of(const BrnoPrimitive& primitive) {
    const auto& [kind, diameter, length] = primitive;
    if (kind == 'C') return fmt::format(" = C({},{})", diameter, length);
    if (kind == 'P') return fmt::format(" = P({})", length);
    return kind == 'S' ? fmt::format(" = S({})", diameter) : "";
}

/// The same system as a file. No section is empty: what one would say of nothing is added.
std::string brno_text(BrnoSystem system, const std::string& title) {
    if (system.modules.empty()) system.modules['A'];
    if (system.rules.empty()) {
        const char letter = system.modules.begin()->first;
        system.rules.emplace_back(letter, std::string(1, letter));
    }
    std::string out = title.empty() ? "" : "// " + title + "\n\n";
    const char* before = "modules:\n    ";
    for (const auto& [letter, primitive] : system.modules) {
        out += before + (letter + text_of(primitive));
        before = ", ";
    }
    out += ";\n\naxiom:\n    " + system.axiom;
    out += ";\n\nangles:\n    ";
    before = "";
    for (const char vector : {'L', 'U', 'H'})
        if (system.angles.contains(vector)) {
            out += fmt::format("{}{} = {}", before, vector, system.angles[vector]);
            before = ", ";
        }
    before = ";\n\nrules:\n    ";
    for (const auto& [letter, successor] : system.rules) {
        out += fmt::format("{}{} -> {}", before, letter, successor);
        before = ",\n    ";
    }
    return out + ";\n\nEND\n";
}

/// Finds what a system says that a file can say, and throws Error where it cannot.
class Writer : FormatWriter {
public:
    explicit Writer(const Model& system) : FormatWriter(system, "brno") {}

    BrnoSystem written() {
        check_plain_rules(false);
        check_plain_settings();
        check_start();
        out_.axiom = letters(system_.axiom.letters, "the axiom");
        std::map<char, std::string> rules;
        for (const Production& rule : system_.rules) {
            const std::string what = "the rule " + print_rule(system_.alphabet, rule);
            const std::string left = letters({rule.predecessor.symbol}, what);
            if (!is_module(left[0])) refuse(what + ": its left side is no letter");
            const std::string right = letters(rule.successor.letters, what);
            rules.emplace(left[0], right);
            out_.rules.emplace_back(left[0], right);
        }
        drawn_ = polygon_letters(out_.axiom, rules);
        for (const auto& [letter, symbol] : symbols_)
            if (is_module(letter)) out_.modules.emplace(letter, primitive(symbol));
        for (const char vector : {'U', 'L', 'H'}) add_angle(vector);
        for (const char letter : {'|', '[', ']', '{', '}', '!'}) check_meaning(letter);
        check_widths();
        return std::move(out_);
    }

private:
    void check_start() const {
        const Drawing& drawing = system_.drawing;
        if (drawing.clockwise) refuse("that + turns clockwise");
        if (!is_usual(drawing.shrink, 1))
            refuse("that steps shrink from one generation to the next");
        if (!is_usual(drawing.spin, 0))
            refuse("that the start turns from one generation to the next");
        // How a figure stands the format does not say; its viewer turns it.
        if (const auto& start = drawing.start; start && !start->upward)
            if (start->x.value != 0 || start->y.value != 0 || start->heading.value != 0)
                refuse("where the turtle starts, expected 'start 0 0 0'");
    }

    std::string letters(const Word& word, const std::string& where) {
        std::string out;
        for (const Symbol symbol : word) {
            const std::string& letter = name(symbol);
            const bool known = letter.size() == 1 && (is_module(letter[0]) ||
                                                      std::strchr(brno_turtle_symbols, letter[0]));
            if (!known)
                refuse(fmt::format("the symbol {} in {}, expected letters and {}", letter, where,
                                   brno_turtle_symbols));
            symbols_.emplace(letter[0], symbol);
            out += letter;
        }
        const std::vector<std::size_t> depths = brace_depths(out);
        for (std::size_t i = 0; i < out.size(); ++i)
            if (depths[i] > 0) fenced_.insert(out[i]);
        return out;
    }

    /// What a letter makes the turtle do, without colours and what it ignores.
    std::vector<TurtleModule> deeds(Symbol symbol) const {
        std::vector<TurtleModule> all = interpreted(symbol);
        std::erase_if(all, [&](const TurtleModule& module) { return !acts(module); });
        return all;
    }
    bool acts(const TurtleModule& module) const {
        const std::string& of = name(module.symbol);
        const Drawing& drawing = system_.drawing;
        if (std::ranges::count(drawing.stamps, module.symbol, &Drawing::Stamp::symbol) > 0)
            return true;
        if (solid(module.symbol) || steps(of)) return true;
        if (of == "*") return !module.parameters.empty() || drawing.scale;
        if (of == "!") return !module.parameters.empty() || drawing.narrow;
        return of.size() == 1 && std::strchr("G+-&^\\/|$@[]{}.%", of[0]);
    }
    static bool steps(const std::string& of) {
        return of == "F" || of == "f" || of.starts_with("F_") || of.starts_with("f_");
    }
    const SolidSetting* solid(Symbol symbol) const {
        for (const SolidSetting& setting : system_.drawing.solids)
            if (setting.symbol == symbol) return &setting;
        return nullptr;
    }

    BrnoPrimitive primitive(Symbol symbol) {
        const std::vector<TurtleModule> all = deeds(symbol);
        if (all.empty()) return {};
        const TurtleModule& last = all.back();
        const std::string& of = name(last.symbol);
        if (all.size() > 2) refuse_module(symbol);
        if (all.size() == 1 && solid(last.symbol)) return ball(symbol, last);
        if (solid(last.symbol) || !(steps(of) || of == "G")) refuse_module(symbol);
        const char letter = name(symbol)[0];
        const bool inside = drawn_.inside.contains(letter),
                   outside = drawn_.outside.contains(letter);
        BrnoPrimitive out{'P', 0, pixels(symbol, step() * length(last), "the length")};
        if (all.size() == 2) {
            const TurtleModule& width = all.front();
            if (name(width.symbol) != "!" || width.parameters.size() != 1 || of[0] == 'f')
                refuse_module(symbol);
            out.diameter = pixels(symbol, width.parameters[0].value, "the diameter");
            if (!fenced_.contains(letter)) {
                out.kind = 'C';
            } else if (outside && out.diameter == 1 && of != "G") {
                lines_.insert(letter);
            } else {
                refuse(fmt::format("the cylinder {} between braces, where turns and lines stand",
                                   name(symbol)));
            }
        } else if (of[0] == 'f' && outside) {
            refuse(name(symbol) + ", a step that draws nothing");
        } else if (of[0] != 'f' && inside && (!outside || of == "G")) {
            refuse(name(symbol) +
                   " between braces, where a line is a side of the polygon and nothing else");
        }
        return out;
    }
    [[noreturn]] void refuse_module(Symbol symbol) const {
        refuse("the module " + name(symbol) +
               ": expected a line, a cylinder, a ball or nothing to be seen");
    }
    static double length(const TurtleModule& module) {
        return module.parameters.empty() ? 1 : module.parameters[0].value;
    }
    BrnoPrimitive ball(Symbol symbol, const TurtleModule& module) const {
        const SolidSetting& setting = *solid(module.symbol);
        if (setting.kind != "sphere") refuse_module(symbol);
        const auto at = std::find(setting.measures.begin(), setting.measures.end(), "radius");
        const auto place = static_cast<std::size_t>(at - setting.measures.begin());
        const double radius = place < module.parameters.size() ? module.parameters[place].value : 1;
        if (fenced_.contains(name(symbol)[0]))
            refuse("the ball " + name(symbol) + " between braces, where turns and lines stand");
        return {'S', pixels(symbol, 2 * radius * step(), "the diameter"), 0};
    }
    double step() const { return system_.drawing.step ? system_.drawing.step->value : 1; }

    long whole(double value, long least, long most, const std::string& what) const {
        if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most)) ||
            value != std::floor(value))
            refuse(fmt::format("{}, expected a whole number from {} to {}", what, least, most));
        return static_cast<long>(value);
    }
    long pixels(Symbol symbol, double value, const char* what) const {
        return whole(value, 1, most_pixels, std::string(what) + " of the module " + name(symbol));
    }

    /// Among cylinders lines are one wide, and they are so only there.
    void check_widths() const {
        const bool cylinders =
            std::ranges::count(std::views::values(out_.modules), 'C', &BrnoPrimitive::kind) > 0;
        if (!cylinders && !lines_.empty())
            refuse(fmt::format("the width of {}, a line where there are no cylinders",
                               *lines_.begin()));
        for (const auto& [letter, primitive] : out_.modules)
            if (cylinders && primitive.kind == 'P' && drawn_.outside.contains(letter) &&
                !lines_.contains(letter))
                refuse(fmt::format("the width of {}, a line among cylinders", letter));
    }

    void add_angle(char vector) {
        std::optional<long> found;
        for (const char* turn = brno_turns(vector); *turn; ++turn) {
            const auto symbol = symbols_.find(*turn);
            if (symbol == symbols_.end()) continue;
            const long angle = turned(*turn, symbol->second);
            if (found && *found != angle)
                refuse(fmt::format("that {} and {} turn by different angles", brno_turns(vector)[0],
                                   brno_turns(vector)[1]));
            found = angle;
        }
        if (found) out_.angles[vector] = *found;
    }
    long turned(char turn, Symbol symbol) const {
        const std::vector<TurtleModule> all = deeds(symbol);
        if (all.size() != 1 || name(all[0].symbol) != std::string(1, turn)) refuse_meaning(turn);
        const auto& angle = system_.drawing.angle;
        const double degrees = !all[0].parameters.empty() ? all[0].parameters[0].value
                               : angle                    ? angle->value
                                                          : 90;
        return whole(degrees, 0, 360, fmt::format("the angle of {}", turn));
    }
    [[noreturn]] void refuse_meaning(char letter) const {
        refuse(fmt::format("another meaning of {}", letter));
    }
    void check_meaning(char letter) const {
        const auto symbol = symbols_.find(letter);
        if (symbol == symbols_.end()) return;
        const std::vector<TurtleModule> all = deeds(symbol->second);
        const bool same = letter == '!' ? all.empty()
                                        : all.size() == 1 && all[0].symbol == symbol->second &&
                                              all[0].parameters.empty();
        if (!same) refuse_meaning(letter);
    }

    std::map<char, Symbol> symbols_;  // of the words
    std::set<char> fenced_;           // written between braces
    PolygonLetters drawn_;
    std::set<char> lines_;  // that have the width 1
    BrnoSystem out_;
};

}  // namespace

Model read_brno(std::string_view text, const std::string& name) {
    return Reader(readable(text), name).read();
}

std::string print_brno(const Model& system) {
    return brno_text(Writer(with_plain_angle(system)).written(), system.title);
}

}  // namespace algae
