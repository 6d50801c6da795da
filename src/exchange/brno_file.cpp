#include "exchange/brno_file.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <set>

#include "base/error.hpp"
#include "exchange/brno_modules.hpp"
#include "exchange/brno_words.hpp"
#include "exchange/placed_word.hpp"
#include "exchange/scanner.hpp"
#include "notation/characters.hpp"
#include "notation/findings.hpp"
#include "notation/read.hpp"
#include "system/expression.hpp"

namespace algae {

namespace {

/// Pixels beyond these no screen has.
constexpr long most_pixels = 1'000'000;

bool is_module(char c) { return std::isalpha(static_cast<unsigned char>(c)); }

/// Behind `END` anything may follow, text or not: then the text up to there.
std::string_view readable(std::string_view text) {
    if (Source(text, "").bad_bytes().empty()) return text;
    for (std::size_t at = text.find("END"); at != std::string_view::npos;
         at = text.find("END", at + 3)) {
        const std::size_t before = text.substr(0, at).find_last_not_of(" \t\r");
        const bool begins =
            before == std::string_view::npos || text[before] == ';' || text[before] == '\n';
        const bool ends =
            at + 3 == text.size() || !std::isalnum(static_cast<unsigned char>(text[at + 3]));
        if (begins && ends) return text.substr(0, at + 3);
    }
    return text;
}

class Reader {
public:
    Reader(std::string_view text, const std::string& name)
        : name_(name), source_(text, name), findings_(source_), scanner_(text, name, comments()) {}

    LSystem read() {
        try {
            section("modules", "at the beginning", [&] { read_module(); });
            keyword("axiom", "behind the modules");
            words_.emplace_back(0, word("the axiom"));
            scanner_.expect(";", "behind the axiom");
            section("angles", "behind the axiom", [&] { read_angle(); });
            section("rules", "behind the angles", [&] { read_rule(); });
            if (!scanner_.take_word("END")) scanner_.fail("'END' behind the rules");
        } catch (const Diagnostics& error) {
            note(error);
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
        return read_lsystem(brno_notation(system_), name_);
    }

private:
    /// Thrown where a section ends in the middle of a faulty item.
    struct CannotGoOn {};

    static std::vector<std::string> comments() { return {"//", "\\\\"}; }

    void note(const Diagnostics& error) {
        for (const Diagnostic& finding : error.findings())
            findings_.add(finding.place, finding.message);
    }

    void keyword(const std::string& name, const std::string& where) {
        const std::size_t at = scanner_.offset();
        if (scanner_.take_word(name)) return scanner_.expect(":", "behind '" + name + "'");
        scanner_.fail_at(at, "expected '" + name + ":' " + where + ", found " + found_next());
    }
    std::string found_next() {
        const std::string_view rest = scanner_.rest();
        return rest.empty() ? "the end of the file" : found(rest.substr(0, rest.find('\n')));
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
                note(error);
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
        if (!rest.starts_with("END")) return false;
        const std::size_t at = scanner_.offset();
        const std::string_view before = source_.text().substr(0, at);
        const std::size_t last = before.find_last_not_of(" \t\r");
        return (last == std::string_view::npos || before[last] == '\n') &&
               (rest.size() == 3 || !std::isalnum(static_cast<unsigned char>(rest[3])));
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
            scanner_.fail_at(at, "expected " + what + ", found '" + shortest_text(value) + "'");
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
            findings_.add(at, std::string("the module ") + name + " is declared twice");
    }
    BrnoPrimitive read_primitive() {
        const std::string what = "C(diameter, height), P(length) or S(diameter)";
        const std::string_view rest = scanner_.rest();
        if (rest.empty() || !std::strchr("CPScps", rest[0]) || rest[0] == 0) scanner_.fail(what);
        BrnoPrimitive primitive;
        const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(letter(what))));
        primitive.kind = kind;
        const std::string behind = std::string("behind ") + kind;
        scanner_.expect("(", behind);
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
            scanner_.fail_at(at, std::string("expected an angle, L, U or H, found '") + name + "'");
        scanner_.expect("=", std::string("behind the angle ") + name);
        const long degrees = whole("a whole number of degrees", 0, 360);
        if (!system_.angles.emplace(name, degrees).second)
            findings_.add(at, std::string("the angle ") + name + " is given twice");
    }

    void read_rule() {
        const std::size_t at = scanner_.offset();
        const char name = letter("a rule, which begins with a module");
        check_declared(name, at);
        scanner_.expect("->", std::string("behind ") + name);
        for (std::size_t i = 1; i < words_.size(); ++i)
            if (words_[i].first == name) {
                findings_.add(at, std::string("the second rule for ") + name + ", expected one");
                break;
            }
        words_.emplace_back(name, word(std::string("the rule for ") + name));
    }

    void check_declared(char letter, std::size_t at, const std::string& hint = "") {
        if (system_.modules.contains(letter)) return;
        const std::string message =
            std::string("expected a declared module, found '") + letter + "'" + hint;
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
                scanner_.fail_at(at, "expected a module, a symbol of the turtle, ',' or ';' in " +
                                         what + ", found " + quoted(character) + hint);
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

}  // namespace

LSystem read_brno(std::string_view text, const std::string& name) {
    return Reader(readable(text), name).read();
}

}  // namespace algae
