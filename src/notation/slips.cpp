#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/model.hpp"

#include "notation/detail/reading.hpp"

// What textbooks write in place of a word: a power `a^n`, three dots, λ for the empty word.
//
// All of these are words of the notation too, as `^` pitches the turtle, `.` is a corner of a polygon and λ a letter
// like others. To read them as such makes a true claim false in silence, and to refuse them always would refuse
// turtles. So a slip is refused only if none of its signs is a letter otherwise: `alphabet` declares it, a rule or
// a setting is about it, or it stands in a word elsewhere than in slips. This is known only when all of a file
// has been read, so slips are gathered with their places (`gather_slips`) and judged at the end
// (`check_slips`). A word by itself is judged by the letters that are known before it (`refuse_slips`).
//
// What is refused depends on symbols and not on blanks, so that the canonical text of a system that was read can
// be read.

namespace algae {

namespace {

/// A letter of a word: where it stands, and whether arguments follow.
struct Letter {
    std::string_view name;
    bool has_arguments = false;
};

/// Where what begins with the bracket at `here` ends: behind the closing one, brackets in quotes not counted.
std::size_t behind_brackets(std::string_view word, std::size_t here) {
    const char open = word[here], close = open == '(' ? ')' : '>';
    std::size_t depth = 0;
    bool quoted = false;
    for (; here < word.size(); ++here) {
        if (word[here] == '"') quoted = !quoted;
        if (quoted) continue;
        if (word[here] == '(' || (depth == 0 && word[here] == open)) ++depth;
        if (word[here] == ')' || (depth == 1 && word[here] == close)) --depth;
        if (depth == 0) return here + 1;
    }
    return here;
}

/// The letters of a word; an empty name stands where a splice is.
std::vector<Letter> letters_of(std::string_view word, const Lexicon& lexicon) {
    std::vector<Letter> letters;
    for (std::size_t here = 0; here < word.size();) {
        const std::string_view rest = word.substr(here);
        if (const std::size_t bytes = lexicon.length(rest); bytes > 0) {
            letters.push_back({rest.substr(0, bytes)});
            here += bytes;
        } else if (rest.front() == '(' || rest.front() == '<') {
            if (rest.front() == '<')
                letters.emplace_back();
            else if (!letters.empty())
                letters.back().has_arguments = true;
            here = behind_brackets(word, here);
        } else {
            here += first_character(rest).bytes;
        }
    }
    return letters;
}

bool is_digit_name(std::string_view name) {
    return name.size() == 1 && is_digit(static_cast<unsigned char>(name[0]));
}

/// Whether a letter can only be an exponent for a reader: a digit, or a small letter that no turtle obeys.
bool is_exponent(const Letter& letter) {
    const std::string_view name = letter.name;
    if (letter.has_arguments || name.size() != 1 || name == "f") return false;
    return is_digit_name(name) || (name[0] >= 'a' && name[0] <= 'z');
}

bool is_plain(const Letter& letter, std::string_view name) {
    return letter.name == name && !letter.has_arguments;
}

/// Adds the power whose `^` is the letter number `at`; returns the number of its last letter, or `at`.
std::size_t add_power(const std::vector<Letter>& letters, std::size_t at,
                      std::vector<Slip>& found) {
    if (at == 0 || at + 1 >= letters.size() || !is_plain(letters[at], "^")) return at;
    const Letter& base = letters[at - 1];
    if (base.name.empty() || base.has_arguments || !is_letter(first_character(base.name).code) ||
        !is_exponent(letters[at + 1]))
        return at;
    std::size_t last = at + 1;
    Slip slip{base.name.data(), {}, {letters[at].name, letters[last].name}};
    std::string exponent(letters[last].name);
    while (is_digit_name(letters[last].name) && last + 1 < letters.size() &&
           is_exponent(letters[last + 1]) && is_digit_name(letters[last + 1].name)) {
        slip.signs.push_back(letters[++last].name);
        exponent += letters[last].name;
    }
    const std::string name(base.name);
    slip.message = "expected letters, found the power '" + name + '^' + exponent + "': write " +
                   name + ' ' + name + ' ' + name +
                   " out; if ^ is a letter, declare it by 'alphabet'";
    found.push_back(std::move(slip));
    return last;
}

}  // namespace

std::vector<Slip> slips(std::string_view word, const Lexicon& lexicon, bool of_rule) {
    constexpr std::string_view ellipsis = "…";
    std::vector<Slip> found;
    const std::string_view alone = trimmed(word);
    if (of_rule && (alone == "λ" || alone == "Λ"))
        found.push_back({alone.data(),
                         "the empty word is written ε; if " + std::string(alone) +
                             " is a letter, declare it by 'alphabet'",
                         {alone}});
    if (word.find('^') == std::string_view::npos && word.find(ellipsis) == std::string_view::npos &&
        std::count(word.begin(), word.end(), '.') < 3)
        return found;
    const std::vector<Letter> letters = letters_of(word, lexicon);
    for (std::size_t i = 0; i < letters.size(); ++i) {
        i = add_power(letters, i, found);
        std::size_t dots = 0;
        while (i + dots < letters.size() && is_plain(letters[i + dots], ".")) ++dots;
        if (dots < 3 && letters[i].name != ellipsis) continue;
        const std::string_view sign = letters[i].name;
        const bool is_one = sign == ellipsis;
        found.push_back({sign.data(),
                         "expected letters, found '" + std::string(is_one ? ellipsis : "...") +
                             "': write the word out; if " + std::string(sign) +
                             " is a letter, declare it by 'alphabet'",
                         std::vector<std::string_view>(is_one ? 1 : dots, sign)});
        if (!is_one) i += dots - 1;
    }
    return found;
}

void refuse_slips(std::string_view word, const Lexicon& lexicon, bool of_rule) {
    for (const Slip& slip : slips(word, lexicon, of_rule))
        if (std::ranges::none_of(
                slip.signs, [&](std::string_view sign) { return lexicon.known(sign).has_value(); }))
            throw SyntaxError{slip.where, slip.message};
}

bool is_declared_only(std::string_view name) {
    return undeclared_length(name) != name.size() && first_character(name).bytes != name.size();
}

void Reading::declare(const std::string& name) {
    spaced = spaced || is_declared_only(name);
    letters.push_back(name);
}

void Reading::gather_slips(std::string_view word, bool of_rule) {
    std::vector<Slip> more = algae::slips(word, lexicon, of_rule);
    slips.insert(slips.end(), std::make_move_iterator(more.begin()),
                 std::make_move_iterator(more.end()));
}

namespace {

/// How often the signs of slips stand in the words of a system, and that some are letters anyway.
class Occurrences {
public:
    explicit Occurrences(const Reading& reading) : of_(reading.system.alphabet.size(), 0) {
        for (const std::string& name : reading.letters)
            if (const auto symbol = reading.lexicon.known(name)) make_letter(*symbol);
        add(reading.system);
        for (const InnerSystem& inner : reading.system.inner) add(inner.system);
        for (const Symbol plotter : reading.drawing.plotters) make_letter(plotter);
        for (const Symbol symbol : reading.drawing.elastic) make_letter(symbol);
        for (const auto& stamp : reading.drawing.stamps) make_letter(stamp.symbol);
        for (const auto& solid : reading.drawing.solids) make_letter(solid.symbol);
        for (const auto& surface : reading.drawing.surfaces) make_letter(surface.symbol);
    }

    std::size_t of(Symbol symbol) const { return symbol < of_.size() ? of_[symbol] : 0; }

private:
    static constexpr std::size_t always = ~std::size_t{0};

    void make_letter(Symbol symbol) {
        if (symbol >= of_.size()) of_.resize(symbol + std::size_t{1}, 0);
        of_[symbol] = always;
    }
    void add(const ModuleWord& word) {
        for (const Symbol symbol : word.letters) {
            if (symbol >= of_.size()) of_.resize(symbol + std::size_t{1}, 0);
            if (of_[symbol] != always) ++of_[symbol];
        }
    }
    void add(const Production& rule) {
        make_letter(rule.predecessor.symbol);
        for (const Pattern* pattern : {&rule.left, &rule.right, &rule.elsewhere})
            for (const ModulePattern& module : *pattern) make_letter(module.symbol);
        if (rule.shape)
            for (const Symbol part : rule.shape->parts) make_letter(part);
        add(rule.successor);
    }
    void add(const LSystem& system) {
        add(system.axiom);
        for (const Production& rule : system.rules) add(rule);
        for (const Production& rule : system.interpretation) add(rule);
        for (const Symbol symbol : system.ignored) make_letter(symbol);
        for (const Symbol symbol : system.terminals) make_letter(symbol);
    }

    std::vector<std::size_t> of_;  // by symbol
};

}  // namespace

void Reading::check_slips() {
    if (slips.empty() || broken_rules) return;  // the missing rule may be about a sign
    std::unordered_map<std::string_view, std::size_t> in_slips;
    for (const Slip& slip : slips)
        for (const std::string_view sign : slip.signs) ++in_slips[sign];
    const Occurrences occurrences(*this);
    const auto is_letter_otherwise = [&](std::string_view sign) {
        const auto symbol = lexicon.known(sign);
        return symbol && occurrences.of(*symbol) > in_slips[sign];
    };
    for (const Slip& slip : slips)
        if (std::ranges::none_of(slip.signs, is_letter_otherwise))
            findings.add(slip.where, slip.message);
}

}  // namespace algae
