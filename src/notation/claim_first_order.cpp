#include <algorithm>

#include "automatic/automatic.hpp"
#include "model/model.hpp"
#include "notation/detail/blank_byte.hpp"
#include "notation/detail/claim_reading.hpp"
#include "notation/detail/grammar.hpp"

// First-order statements about infinite words in claims.
//
// `in T: ...` says of which system; without it a statement that begins with a quantifier over numbers is one if `T[` stands in it and T
// is a system. The rest is read by the room `automatic`, whose places are put into those of the file.

namespace algae {

namespace {

/// The words `in T:` before a statement.
struct Beginning {
    std::string_view system;
    std::size_t length = 0;
};

std::optional<Beginning> beginning(std::string_view text) {
    if (!text.starts_with("in ")) return std::nullopt;
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const std::string_view name = trimmed(text.substr(3, colon - 3));
    if (!is_claim_name(name)) return std::nullopt;
    return Beginning{name, colon + 1};
}

/// Throws the finding of another reader, made of the text, as one at its place in the file.
[[noreturn]] void rethrow(const Diagnostic& finding, std::string_view text) {
    std::size_t at = 0;
    for (std::size_t line = 1; line < finding.place.line; ++line) at = text.find('\n', at) + 1;
    const auto is_first = [&] { return (static_cast<unsigned char>(text[at]) & 0xC0) != 0x80; };
    for (std::size_t passed = 0; at < text.size(); ++at)
        if (is_first() && passed++ == finding.caret) break;
    throw SyntaxError{text.data() + at, finding.message};
}

}  // namespace

std::optional<std::string_view> first_order_system(std::string_view text,
                                                   const ClaimReading& reading) {
    if (const auto begun = beginning(text)) return begun->system;
    std::string_view rest = text;
    while (rest.starts_with("not ") || rest.starts_with('('))
        rest = trimmed(rest.substr(rest.starts_with('(') ? 1 : 4));
    if (!rest.starts_with("for all ") && !rest.starts_with("for some ") &&
        !rest.starts_with("there is "))
        return std::nullopt;
    if (text.find("==>") != std::string_view::npos) return std::nullopt;
    for (std::size_t open = text.find('['); open != std::string_view::npos;
         open = text.find('[', open + 1)) {
        std::size_t begin = open;
        while (begin > 0 && is_claim_name("a" + std::string(1, text[begin - 1]))) --begin;
        const std::string_view name = text.substr(begin, open - begin);
        const ClaimName* known = name.empty() ? nullptr : reading.find(name);
        if (known && known->written && known->kind == ClaimName::Kind::system) return name;
    }
    return std::nullopt;
}

namespace {

/// The infinite word of a system: which system, and what its letters are called.
struct InfiniteWord {
    InfiniteWord(std::string_view word, ClaimReading& reading)
        : name(word), system(reading.system(word)) {
        const std::shared_ptr<const Model> model = reading.written(word);
        if (!as_d0l(*model))
            throw SyntaxError{word.data(),
                              "expected a D0L system, whose words may begin one infinite "
                              "word, found " +
                                  quoted(word)};
        const LetterCoding given(model->alphabet, model->coding);
        for (Symbol a = 0; a < model->alphabet.size(); ++a) {
            letters.push_back(given.alphabet.name(given.morphism[a].front()));
            if (letters.back() != model->alphabet.name(a))
                coding[model->alphabet.name(a)] = letters.back();
        }
    }

    /// A statement that calls the word by `called`.
    FirstOrderStatement read(std::string_view text, const std::string& called) const {
        return read_first_order(text, "", called, letters);
    }
    /// The same with a name that the statements of this file have.
    std::shared_ptr<const FirstOrderStatement> own(const std::string& text) const {
        return std::make_shared<const FirstOrderStatement>(read(text, "T"));
    }

    std::string_view name;
    std::shared_ptr<const SourceSystem> system;
    std::vector<std::string> letters;
    std::map<std::string, std::string> coding;
};

}  // namespace

Statement parse_first_order(std::string_view system, std::string_view text, ClaimReading& reading) {
    const char* const where = text.data();
    const std::string_view whole = text;
    if (const auto begun = beginning(text)) text = text.substr(begun->length);
    const InfiniteWord word(system, reading);
    HoldsInWord said{word.system, nullptr, word.coding};
    try {
        said.says =
            std::make_shared<const FirstOrderStatement>(word.read(text, std::string(system)));
    } catch (const Diagnostics& error) {
        rethrow(error.findings().front(), text);
    }
    if (!said.says->free().empty())
        throw SyntaxError{where, "expected a quantifier for each number, found " +
                                     quoted(said.says->free().front()) +
                                     " without one; begin with 'for all " +
                                     said.says->free().front() + ":'"};
    Statement made;
    made.text = trimmed(whole);
    made.place = reading.source.place(where);
    made.says = std::move(said);
    return made;
}

namespace {

/// The first words of a text and what is behind them; nothing if it begins in another way.
std::optional<std::string_view> behind(std::string_view text, std::string_view words) {
    text = trimmed(text);
    while (!words.empty()) {
        const std::size_t blank = words.find(' ');
        const std::string_view next = words.substr(0, blank);
        if (!text.starts_with(next)) return std::nullopt;
        text = text.substr(next.size());
        if (is_claim_name(next) && !text.empty() &&
            is_claim_name("a" + std::string(text.substr(0, 1))))
            return std::nullopt;
        text = trimmed(text);
        words = blank == std::string_view::npos ? std::string_view() : words.substr(blank + 1);
    }
    return text;
}

/// The name at the beginning of a text; it is taken away.
std::string_view take_name(std::string_view& text) {
    text = trimmed(text);
    std::size_t size = 0;
    while (size < text.size() && is_claim_name("a" + std::string(1, text[size]))) ++size;
    const std::string_view name = text.substr(0, size);
    if (!is_claim_name(name)) return {};
    text = trimmed(text.substr(size));
    return name;
}

bool take_sign(std::string_view& text, std::string_view sign) {
    const auto rest = behind(text, sign);
    if (rest) text = *rest;
    return rest.has_value();
}

/// The digits at the beginning of a text; they are taken away.
std::optional<Integer> take_number(std::string_view& text) {
    text = trimmed(text);
    const std::string_view digits = text.substr(0, text.find_first_not_of("0123456789"));
    if (digits.empty()) return std::nullopt;
    text = trimmed(text.substr(digits.size()));
    return natural_number(digits);
}

/// What `3-power-free`, `7/3-power-free` or `7/3+-power-free` says of T: no factor has this exponent or more, with `+` more; nothing if it
/// is not that. A factor of m + p letters with period p has the exponent (m + p)/p.
std::optional<std::string> power_freeness(std::string_view property) {
    constexpr std::string_view end = "-power-free";
    if (!property.ends_with(end)) return std::nullopt;
    std::string_view rest = property.substr(0, property.size() - end.size());
    const auto above = take_number(rest);
    if (!above) return std::nullopt;
    Integer below = 1;
    if (take_sign(rest, "/")) {
        const auto written = take_number(rest);
        if (!written) return std::nullopt;
        below = *written;
    }
    const bool is_strict = take_sign(rest, "+");
    if (!rest.empty() || below.is_zero()) return std::nullopt;
    if (*above <= below)
        throw SyntaxError{property.data(), "expected an exponent above 1, which all words have"};
    const std::string times = to_string(*above - below);
    if (below == 1 && !is_strict)
        return "not for some i, n with n >= 1: equal(i, i + n, " + times + "n)";
    return "not for some i, m, p with p >= 1 and " + to_string(below) + "m " +
           (is_strict ? "> " : ">= ") + times + "p: equal(i, i + p, m)";
}

/// What balance says: some palindrome stands between two letters x, and between two letters y, exactly if two factors of one length
/// differ by more than 1 in how often they have a letter (Coven and Hedlund 1973; Lothaire 2002, proposition 2.1.3).
std::string balance(const InfiniteWord& word, const char* where) {
    const std::set<std::string> different(word.letters.begin(), word.letters.end());
    if (different.size() != 2)
        throw SyntaxError{where, "'balanced' is said of words over two letters, and " +
                                     std::string(word.name) + " has " +
                                     std::to_string(different.size())};
    const auto between = [](const std::string& place, const std::string& letter) {
        return "T[" + place + "] = '" + letter + "' and T[" + place + " + n + 1] = '" + letter +
               "'";
    };
    return "not for some i, j, n: palindrome(i + 1, n) and equal(i + 1, j + 1, n) and " +
           between("i", *different.begin()) + " and " + between("j", *different.rbegin());
}

}  // namespace

bool parse_word_property(std::string_view text, Statement& statement, ClaimReading& reading) {
    std::string_view rest = text;
    const std::string_view name = take_name(rest);
    const ClaimName* const known = name.empty() ? nullptr : reading.find(name);
    if (!known || known->kind != ClaimName::Kind::system || !take_sign(rest, "is")) return false;
    statement.negated = take_sign(rest, "not");
    if (language_family(rest) || rest == "finite" || rest == "infinite" || rest == "empty")
        return false;  // of a language, so a mistake that is told with those
    const char* const where = rest.data();
    const InfiniteWord word(name, reading);
    if (rest == "circular") {
        statement.says = IsCircular{word.system};
        return true;
    }
    std::string says;
    if (const auto free = power_freeness(rest)) {
        says = *free;
    } else if (rest == "balanced") {
        says = balance(word, where);
    } else {
        std::vector<std::string> all{"balanced", "circular", "7/3-power-free", "7/3+-power-free"};
        for (const WordProperty& one : word_properties()) {
            all.emplace_back(one.name);
            if (behind(rest, one.name) == "") says = one.says;
        }
        if (says.empty())
            throw SyntaxError{where, "expected a property of the infinite word of " +
                                         std::string(name) + " (" + listed(all) + "), found " +
                                         quoted(rest) + did_you_mean(std::string(rest), all) +
                                         "; of its language, write L(" + std::string(name) + ")"};
    }
    statement.says = HoldsInWord{word.system, word.own(says), word.coding};
    return true;
}

bool parse_critical_exponent(std::string_view text, Statement& statement, ClaimReading& reading) {
    std::string_view rest = text;
    if (take_name(rest) != "critical_exponent") return false;
    if (!take_sign(rest, "(")) throw unexpected("'(' after 'critical_exponent'", rest.data());
    const char* const where = rest.data();
    const std::string_view name = take_name(rest);
    if (name.empty()) throw unexpected("the name of a system", where);
    if (!take_sign(rest, ")")) throw unexpected("')'", rest.data());
    const InfiniteWord word(name, reading);
    HasCriticalExponent said{word.system, Comparison::equal, {}, word.coding};
    const auto sign = std::find_if(std::begin(comparison_signs), std::end(comparison_signs),
                                   [&](std::string_view one) { return rest.starts_with(one); });
    if (sign == std::end(comparison_signs))
        throw unexpected("'=', '!=', '<', '<=', '>' or '>='", rest.data());
    said.comparison = comparisons_said[sign - std::begin(comparison_signs)];
    rest = trimmed(rest.substr(sign->size()));
    const char* here = rest.data();
    const char* const end = here + rest.size();
    said.number = parse_claimed_number(here, end);
    while (here != end && is_blank_byte(*here)) ++here;
    if (here != end) throw unexpected("an operator or the end of the statement", here);
    if (said.comparison == Comparison::unequal) {
        said.comparison = Comparison::equal;
        statement.negated = true;
    }
    statement.says = std::move(said);
    return true;
}

bool parse_factor(std::string_view text, Statement& statement, ClaimReading& reading) {
    const std::size_t in = find_word(text, "in");
    if (in == std::string_view::npos) return false;
    std::string_view rest = text.substr(in + 2);
    if (take_name(rest) != "factors" || !take_sign(rest, "(")) return false;
    const char* const where = rest.data();
    const std::string_view name = take_name(rest);
    if (name.empty()) throw unexpected("the name of a system", where);
    if (!take_sign(rest, ")")) throw unexpected("')'", rest.data());
    if (!rest.empty()) throw unexpected("the end of the statement", rest.data());
    std::string_view word = trimmed(text.substr(0, in));
    if (word.ends_with("not") && word.size() > 3 && is_blank_byte(word[word.size() - 4])) {
        statement.negated = true;
        word = trimmed(word.substr(0, word.size() - 3));
    }
    const Word factor = parse_claimed_word(word, reading);
    reading.add_letters(factor);
    const Language all = reading.complement(words_language({}), where);
    using Kind = LanguageTree::Kind;
    const Language with_factor = combined(
        Kind::concatenated, {combined(Kind::concatenated, {all, words_language({factor})}), all});
    statement.negated = !statement.negated;
    statement.says = IsEmpty{
        combined(Kind::intersected, {generated_language(reading.system(name)), with_factor})};
    return true;
}

namespace {

/// A function that counts factors, and at which of their places it does.
struct FactorFunction {
    std::string_view name, places;  // # is the length
};

constexpr FactorFunction factor_functions[] = {
    {"complexity", "not for some j with j < i: equal(i, j, #)"},
    {"palindromic_complexity", "palindrome(i, #) and not for some j with j < i: equal(i, j, #)"},
};

bool counts_factors(std::string_view text) {
    return text.find("complexity(") != std::string_view::npos;
}

class CountingReader {
public:
    CountingReader(std::string_view text, ClaimReading& reading) : rest_(text), reading_(reading) {}

    /// `for all n with n >= 2:`, if it stands there.
    void condition() {
        if (!take_sign(rest_, "for all")) return;
        take_sign(rest_, "numbers");
        const std::string_view name = take_name(rest_);
        if (name.empty()) fail("the name of a number");
        is_number(name);
        if (take_sign(rest_, "with") && take_name(rest_) != number_)
            fail("'" + std::string(number_) + " >= ' and a number");
        if (take_sign(rest_, ">=")) {
            const auto least = take_number(rest_);
            if (!least) fail("a number");
            says_.from = *least;
        }
        if (!take_sign(rest_, ":")) fail("'>=' and a number, or ':'");
    }

    Statement statement() {
        Statement made;
        side(1);
        const bool unequal = take_sign(rest_, "!=");
        if (!unequal && !take_sign(rest_, "=")) fail("'+', '-', '=' or '!='");
        side(-1);
        if (!rest_.empty()) fail("'+', '-' or the end of the statement");
        made.negated = unequal;
        made.says =
            CountsInWord{word_->system, std::make_shared<const CountingStatement>(std::move(says_)),
                         word_->coding};
        return made;
    }

private:
    [[noreturn]] void fail(const std::string& expected) {
        throw unexpected(expected, rest_.data());
    }

    void side(int sign) {
        bool is_first = true;
        for (int times = sign;; is_first = false) {
            if (take_sign(rest_, "-"))
                times = -sign;
            else if (take_sign(rest_, "+"))
                times = sign;
            else if (!is_first)
                return;
            term(times);
        }
    }

    void term(const Integer& sign) {
        const auto written = take_number(rest_);
        const bool has_sign = written && take_sign(rest_, "*");
        const Integer times = written ? sign * *written : sign;
        const std::string_view name = take_name(rest_);
        if (name.empty() && (!written || has_sign))
            fail("a number, a name of one, or complexity(...)");
        if (name.empty()) {
            says_.constant += times;
        } else if (take_sign(rest_, "(")) {
            says_.parts.push_back({times, places(name)});
        } else {
            is_number(name);
            says_.slope += times;
        }
    }

    void is_number(std::string_view name) {
        if (reading_.find(name))
            throw SyntaxError{
                name.data(), "expected a number of this statement alone, found " + quoted(name) +
                                 ", which stands for something else; 'for all n with n >= 1:' goes "
                                 "before a single statement on complexities"};
        if (number_.empty()) number_ = name;
        if (name != number_)
            throw SyntaxError{name.data(), "expected one number, " + quoted(number_) + ", found " +
                                               quoted(name) + " beside it"};
    }

    /// The places behind `complexity(`.
    FirstOrderStatement places(std::string_view function) {
        const FactorFunction* found = nullptr;
        std::vector<std::string> all;
        for (const FactorFunction& one : factor_functions) {
            all.emplace_back(one.name);
            if (one.name == function) found = &one;
        }
        if (!found) throw unknown_word(listed(all), function, all);
        const std::string_view system = take_name(rest_);
        if (system.empty()) fail("the name of a system");
        if (!word_) word_.emplace(system, reading_);
        if (system != word_->name)
            throw SyntaxError{system.data(),
                              "expected one system in a statement on complexities, " +
                                  quoted(word_->name) + ", found " + quoted(system)};
        if (!take_sign(rest_, ",")) fail("',' and a length");
        std::string length;
        do {
            const auto times = take_number(rest_);
            take_sign(rest_, "*");
            const std::string_view name = take_name(rest_);
            if (!times && name.empty()) fail("a length, such as '2n + 1'");
            if (!name.empty()) is_number(name);
            length += (length.empty() ? "" : " + ") + (times ? to_string(*times) : "") +
                      (name.empty() ? "" : "n");
        } while (take_sign(rest_, "+"));
        if (!take_sign(rest_, ")")) fail("'+' or ')'");
        std::string says;
        for (const char c : found->places) says += c == '#' ? length : std::string(1, c);
        return *word_->own(says);
    }

    std::string_view rest_;
    ClaimReading& reading_;
    std::string_view number_;
    std::optional<InfiniteWord> word_;
    CountingStatement says_;
};

}  // namespace

bool parse_complexities(std::string_view text, Statement& statement, ClaimReading& reading) {
    if (!counts_factors(text)) return false;
    CountingReader reader(text, reading);
    reader.condition();
    Statement made = reader.statement();
    statement.negated = made.negated;
    statement.says = std::move(made.says);
    return true;
}

bool is_on_complexities(std::string_view text) {
    if (!behind(text, "for all") || !counts_factors(text)) return false;
    for (const char* const joint : {"and", "or", "implies", "iff"})
        if (find_word(text, joint) != std::string_view::npos) return false;
    return true;
}

}  // namespace algae
