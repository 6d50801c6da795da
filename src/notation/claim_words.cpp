#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "notation/detail/claim_reading.hpp"

// Languages as textbooks write them: sets of words with powers, `{a^n b^(2n+1) : n >= 0}`, and grammars,
// `CF { S -> aSb | ε }` and `regular { S -> aS | b }`.
//
// Before the colon stands a word, in which letters and words between brackets have exponents; behind it what the
// numbers in them are. An exponent is computed while it is read, as a sum of terms c n^k b^n: there are no negative
// numbers, a power has a constant above or below, and with two numbers a term has one of them. Powers of constants are
// written out, so a set in which no exponent depends on a number cannot be written so.
//
// The letters before the arrows of a grammar are those that are rewritten; a capital letter without a rule is taken for
// one that was forgotten. A context-free grammar stands for the E0L system with its rules and A -> A for each letter that is
// rewritten, which generates the same words. Of a right-linear grammar a regular expression is made by solving its
// equations, X = u X | v being u* v (Arden 1961), from the last letter to the first.

namespace algae {

namespace {

using Kind = LanguageTree::Kind;
using Term = Powers::Term;

std::string_view between(const char* first, const char* last) {
    return {first, static_cast<std::size_t>(last - first)};
}

bool is_latin(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

void skip_blanks(const char*& here, const char* end) {
    while (here != end) {
        const Character next = first_character(between(here, end));
        if (!is_blank(next.code) && next.code != '\n') return;
        here += next.bytes;
    }
}

bool take(const char*& here, const char* end, std::string_view token) {
    const char* behind = here;
    skip_blanks(behind, end);
    if (!between(behind, end).starts_with(token)) return false;
    here = behind + token.size();
    return true;
}

/// What stands where the token is a name: a letter and more letters and digits; empty if there is none.
std::string_view name_at(const char*& here, const char* end) {
    skip_blanks(here, end);
    const char* const begin = here;
    while (here != end &&
           (is_latin(*here) || (here != begin && is_digit(static_cast<unsigned char>(*here)))))
        ++here;
    return between(begin, here);
}

std::string_view digits_at(const char*& here, const char* end) {
    skip_blanks(here, end);
    const char* const begin = here;
    while (here != end && is_digit(static_cast<unsigned char>(*here))) ++here;
    return between(begin, here);
}

// --- Powers ---

constexpr std::uint64_t most_least = 1000;    // the least value of a number
constexpr std::uint64_t most_power = 20;      // the exponent of a number
constexpr std::uint64_t most_factor = 1000;   // by which a number is multiplied above a constant
constexpr std::size_t most_letters = 10'000;  // of what is written out
constexpr std::size_t most_brackets = 200;

struct Condition {
    std::vector<Powers::Number> numbers;
    const char* begin = nullptr;  // where it stands
};

constexpr const char* wanted_condition = "a condition such as 'n >= 0'";

/// `n >= 0`, `n, m >= 1`, `n >= 0, m > 0`. Throws `SyntaxError`.
Condition parse_condition(const char* here, const char* end) {
    Condition read;
    read.begin = here;
    std::size_t bounded = 0;
    do {
        const std::string_view name = name_at(here, end);
        if (name.empty()) throw unexpected(wanted_condition, here);
        for (const Powers::Number& known : read.numbers)
            if (known.name == name)
                throw SyntaxError{name.data(),
                                  "the number " + quoted(name) + " stands there twice"};
        read.numbers.push_back({std::string(name), 0});
        if (read.numbers.size() > 2)
            throw SyntaxError{name.data(),
                              "expected one or two numbers, found a third one, " + quoted(name)};
        skip_blanks(here, end);
        if (here != end && *here == ',') continue;
        const bool at_least = take(here, end, ">=") || take(here, end, "≥");
        if (!at_least && !take(here, end, ">")) throw unexpected("'>=' and a number", here);
        const std::string_view digits = digits_at(here, end);
        if (digits.empty()) throw unexpected("a number", here);
        const Integer least = natural_number(digits) + Integer(at_least ? 0 : 1);
        if (least > Integer(most_least))
            throw SyntaxError{digits.data(),
                              "expected a number up to " + std::to_string(most_least)};
        for (; bounded < read.numbers.size(); ++bounded)
            read.numbers[bounded].least = least.to_uint64();
    } while (take(here, end, ","));
    skip_blanks(here, end);
    if (here != end) throw unexpected("',' or the end of the set", here);
    if (bounded < read.numbers.size()) throw unexpected("'>=' and a number", here);
    return read;
}

/// Whether numbers with a bound stand there.
bool is_condition(const char* here, const char* end) {
    do {
        if (name_at(here, end).empty()) return false;
    } while (take(here, end, ","));
    return take(here, end, ">=") || take(here, end, "≥");
}

/// Where the condition of a set begins: its sign, or nullptr if there is none.
const char* condition_sign(std::string_view inside, const Lexicon& lexicon) {
    if (const std::size_t comment = inside.find('#'); comment != std::string_view::npos)
        return condition_sign(inside.substr(0, comment), lexicon);
    if (!lexicon.known(":"))
        if (const std::size_t colon = inside.find(':'); colon != std::string_view::npos)
            return inside.data() + colon;
    const std::size_t bar = inside.rfind('|');
    if (bar == std::string_view::npos) return nullptr;
    const char* const end = inside.data() + inside.size();
    return is_condition(inside.data() + bar + 1, end) ? inside.data() + bar : nullptr;
}

/// A sum of terms, by what they are multiples of.
class Sum {
public:
    using Key = std::tuple<std::optional<std::size_t>, std::uint64_t, Integer>;

    static Sum constant(Integer value) {
        Sum sum;
        sum.add({std::nullopt, 0, Integer(1)}, std::move(value));
        return sum;
    }
    static Sum number(std::size_t which) {
        Sum sum;
        sum.add({which, 1, Integer(1)}, Integer(1));
        return sum;
    }

    void add(const Key& key, const Integer& coefficient) {
        if (coefficient.is_zero()) return;
        terms_.try_emplace(key, 0).first->second += coefficient;
    }
    void add(const Sum& other) {
        for (const auto& [key, coefficient] : other.terms_) add(key, coefficient);
    }

    /// Nothing if a product has two numbers.
    std::optional<Sum> times(const Sum& other) const {
        Sum product;
        for (const auto& [key, coefficient] : terms_)
            for (const auto& [other_key, other_coefficient] : other.terms_) {
                const auto& [which, power, base] = key;
                const auto& [other_which, other_power, other_base] = other_key;
                if (which && other_which && which != other_which) return std::nullopt;
                product.add({which ? which : other_which, power + other_power, base * other_base},
                            coefficient * other_coefficient);
            }
        return product;
    }

    /// The value, where it depends on no number.
    std::optional<Integer> value() const {
        if (terms_.empty()) return Integer(0);
        if (terms_.size() > 1 || std::get<0>(terms_.begin()->first)) return std::nullopt;
        return terms_.begin()->second;
    }

    const std::map<Key, Integer>& terms() const { return terms_; }

private:
    std::map<Key, Integer> terms_;
};

/// Reads an exponent as a sum.
class ExponentReader {
public:
    ExponentReader(const std::vector<Powers::Number>& numbers, const char* end)
        : numbers_(numbers), end_(end) {}

    /// What stands behind `^` without brackets, or between brackets.
    Sum atom(const char*& here) {
        skip_blanks(here, end_);
        const char* const begin = here;
        if (take(here, end_, "(")) {
            if (++depth_ > most_brackets)
                throw SyntaxError{begin, "more than " + std::to_string(most_brackets) +
                                             " brackets inside each other"};
            Sum inside = sum(here);
            if (!take(here, end_, ")")) {
                if (here != end_ && *here == '-')
                    throw SyntaxError{here,
                                      "expected '+', '*', '^' or ')' in an exponent, found '-': "
                                      "exponents have no negative terms"};
                throw unexpected("'+', '*', '^' or ')' in an exponent", here);
            }
            --depth_;
            return inside;
        }
        if (const std::string_view digits = digits_at(here, end_); !digits.empty()) {
            const Integer value = natural_number(digits);
            if (value > Integer(1'000'000'000))
                throw SyntaxError{digits.data(), "expected a number up to 1000000000"};
            return Sum::constant(value);
        }
        std::optional<std::size_t> found;  // the longest name that stands there
        for (std::size_t i = 0; i < numbers_.size(); ++i)
            if (between(here, end_).starts_with(numbers_[i].name) &&
                (!found || numbers_[*found].name.size() < numbers_[i].name.size()))
                found = i;
        if (found) {
            here += numbers_[*found].name.size();
            return Sum::number(*found);
        }
        const std::string_view name = name_at(here, end_);
        here = begin;
        if (name.empty()) throw unexpected("an exponent: n, 2, (2n+1), (2^n)", here);
        throw SyntaxError{begin,
                          "expected a number of the condition behind ':', found " + quoted(name)};
    }

    /// `2`, `n`, `n^2`, `2^n`: powers bind to the right.
    Sum power(const char*& here) {
        const char* const begin = here;
        Sum below = atom(here);
        if (!take(here, end_, "^")) return below;
        if (++depth_ > most_brackets)
            throw SyntaxError{
                begin, "more than " + std::to_string(most_brackets) + " powers above each other"};
        const Sum above = power(here);
        --depth_;
        if (const auto times = above.value()) {
            if (*times > Integer(most_power))
                throw SyntaxError{begin, "expected a power up to " + std::to_string(most_power)};
            Sum product = Sum::constant(1);
            for (std::uint64_t i = times->to_uint64(); i > 0; --i)
                product = multiplied(product, below, begin);
            return product;
        }
        return exponential(below, above, begin);
    }

private:
    Sum sum(const char*& here) {
        Sum all = product(here);
        while (take(here, end_, "+")) all.add(product(here));
        return all;
    }

    Sum product(const char*& here) {
        Sum all = power(here);
        for (;;) {
            skip_blanks(here, end_);
            const char* const begin = here;
            const bool goes_on = take(here, end_, "*") ||
                                 (here != end_ && (is_latin(*here) || *here == '(' ||
                                                   is_digit(static_cast<unsigned char>(*here))));
            if (!goes_on) return all;
            all = multiplied(all, power(here), begin);
        }
    }

    static Sum multiplied(const Sum& left, const Sum& right, const char* where) {
        auto product = left.times(right);
        if (!product)
            throw SyntaxError{
                where,
                "with two numbers exponents are sums such as 2n+m+1, without products "
                "of both"};
        if (product->terms().size() > 100)
            throw SyntaxError{where, "an exponent with more than 100 terms"};
        return *product;
    }

    /// A constant to the power of a n + b.
    static Sum exponential(const Sum& below, const Sum& above, const char* where) {
        const auto base = below.value();
        Integer factor = 0, constant = 0;
        std::optional<std::size_t> number;
        bool linear = base && *base > 0;
        for (const auto& [key, coefficient] : above.terms()) {
            const auto& [which, power, other_base] = key;
            if (!which) {
                constant = coefficient;
                continue;
            }
            linear = linear && !number && power == 1 && other_base == 1;
            number = which;
            factor = coefficient;
        }
        if (!linear)
            throw SyntaxError{
                where,
                "expected an exponent such as n, 2n+1, n^2 or 3*2^(n+1), found a power "
                "of another kind"};
        if (factor > Integer(most_factor) || constant > Integer(most_factor))
            throw SyntaxError{where,
                              "expected numbers up to " + std::to_string(most_factor) + " there"};
        if (*base == 1) return Sum::constant(1);
        Sum found;
        found.add({number, 0, algae::power(*base, factor.to_uint64())},
                  algae::power(*base, constant.to_uint64()));
        return found;
    }

    const std::vector<Powers::Number>& numbers_;
    const char* end_;
    std::size_t depth_ = 0;
};

/// The words before the condition on their way.
class PowersReader {
public:
    PowersReader(std::string_view words, const Condition& condition, ClaimReading& reading)
        : here_(words.data()),
          end_(here_ + words.size()),
          condition_(condition),
          exponents_(condition.numbers, end_),
          reading_(reading) {}

    Language read() {
        while (skip_blanks(here_, end_), here_ != end_) factor();
        flush();
        if (!depends_)
            throw SyntaxError{
                end_,
                "expected powers such as a^n before ':', as in {a^n b^(2n+1) : n >= 0}; other sets "
                "of words are written by operations on languages, as /(a|b)*/ & ~L(G)"};
        powers_.numbers = condition_.numbers;
        try {
            return powers_language(std::move(powers_));
        } catch (const Error& error) {
            throw SyntaxError{condition_.begin, error.what()};
        }
    }

private:
    /// One letter, or a word between brackets, and its exponent.
    void factor() {
        const char* const begin = here_;
        Word word;
        if (*here_ == '(') {
            const char* const close = std::find(here_, end_, ')');
            if (close == end_) throw SyntaxError{begin, "'(' is never closed"};
            word = letters(between(here_ + 1, close));
            here_ = close + 1;
        } else {
            word = letter();
        }
        if (!take(here_, end_, "^")) return append(word, begin);
        const Sum exponent = exponents_.power(here_);
        if (here_ != end_ && is_latin(*here_) && here_[-1] != ')' &&
            is_number(between(here_, here_ + 1)))
            throw SyntaxError{here_,
                              "expected brackets around an exponent of several signs, as in "
                              "a^(2n)"};
        if (const auto times = exponent.value()) {
            if (*times * Integer(word.size()) > Integer(most_letters))
                throw SyntaxError{
                    begin, "a word with more than " + std::to_string(most_letters) + " letters"};
            for (std::uint64_t i = times->to_uint64(); i > 0; --i) append(word, begin);
            return;
        }
        if (word.empty()) throw SyntaxError{begin, "expected a letter or word before '^', found ε"};
        flush();
        Powers::Block block{std::move(word), {}};
        for (const auto& [key, coefficient] : exponent.terms()) {
            const auto& [which, power, base] = key;
            block.exponent.push_back({coefficient, which, power, base});
            if (which && !condition_.numbers.empty() && condition_.numbers.size() > 1 &&
                (power != 1 || base != 1))
                throw SyntaxError{begin,
                                  "with two numbers exponents are sums such as 2n+m+1, without "
                                  "powers of them"};
        }
        // The largest terms first; a constant last.
        std::reverse(block.exponent.begin(), block.exponent.end());
        powers_.blocks.push_back(std::move(block));
        depends_ = true;
    }

    Word letter() {
        const std::string_view rest = between(here_, end_);
        std::size_t bytes = reading_.lexicon.length(rest);
        if (rest.starts_with("ε")) bytes = std::string_view("ε").size();
        if (bytes == 0 || *here_ == '^' || *here_ == ')')
            throw unexpected("a letter, or a word between brackets", here_);
        here_ += bytes;
        return letters(rest.substr(0, bytes));
    }

    Word letters(std::string_view text) {
        refuse_slips(text, reading_.lexicon);
        for (const Powers::Number& number : condition_.numbers)
            if (const std::size_t at = text.find(number.name); at != std::string_view::npos)
                throw SyntaxError{text.data() + at,
                                  "expected letters, found " + quoted(number.name) +
                                      ", a number of the condition: exponents of several signs "
                                      "stand between brackets, a^(2n)"};
        Word word = parse_symbols(text, reading_.lexicon);
        reading_.add_letters(word);
        return word;
    }

    bool is_number(std::string_view name) const {
        return std::any_of(condition_.numbers.begin(), condition_.numbers.end(),
                           [&](const Powers::Number& number) { return number.name == name; });
    }

    void append(const Word& word, const char* where) {
        fixed_.insert(fixed_.end(), word.begin(), word.end());
        if (fixed_.size() > most_letters)
            throw SyntaxError{where,
                              "a word with more than " + std::to_string(most_letters) + " letters"};
    }
    void flush() {
        if (!fixed_.empty()) powers_.blocks.push_back({std::exchange(fixed_, {}), {Term{}}});
    }

    const char* here_;
    const char* end_;
    const Condition& condition_;
    ExponentReader exponents_;
    ClaimReading& reading_;
    Powers powers_;
    Word fixed_;
    bool depends_ = false;
};

}  // namespace

bool is_set_with_condition(std::string_view inside, const ClaimReading& reading) {
    return condition_sign(inside, reading.lexicon) != nullptr;
}

Language parse_powers(std::string_view inside, ClaimReading& reading) {
    const char* const sign = condition_sign(inside, reading.lexicon);
    const std::string_view words = between(inside.data(), sign);
    if (words.find('^') == std::string_view::npos)
        throw SyntaxError{sign, "expected powers such as a^n before '" + std::string(1, *sign) +
                                    "', as in {a^n b^(2n+1) : n >= 0}; other sets of words are "
                                    "written by operations on "
                                    "languages, as /(a|b)*/ & ~L(G)"};
    const Condition condition = parse_condition(sign + 1, inside.data() + inside.size());
    return PowersReader(words, condition, reading).read();
}

// --- Grammars ---

namespace {

struct Grammar {
    Symbol start = 0;
    std::vector<Symbol>
        letters;  // that are rewritten: the start first, then in the order of their rules
    std::map<Symbol, std::vector<std::pair<Word, const char*>>> rules;

    bool rewrites(Symbol letter) const { return rules.count(letter) > 0; }
};

bool is_capital(const std::string& name) { return name[0] >= 'A' && name[0] <= 'Z'; }

/// Throws `SyntaxError`.
Grammar parse_rules(std::string_view text, ClaimReading& reading) {
    Grammar grammar;
    std::string_view start;
    for (const Clause& clause : clauses(text)) {
        if (!clause.arrow) {
            if (!clause.has_word("start"))
                throw unexpected("a rule such as 'S -> aSb | ε', or 'start' and a letter",
                                 clause.text.data());
            start = clause.value();
            if (start.empty())
                throw unexpected("a letter after 'start'", clause.text.data() + clause.text.size());
            continue;
        }
        const std::string_view left = trimmed(between(clause.text.data(), clause.arrow));
        const Word letter = parse_symbols(left, reading.lexicon);
        if (letter.size() != 1)
            throw SyntaxError{clause.text.data(),
                              "expected one letter before the arrow, found " + quoted(left)};
        const std::size_t arrow_size = *clause.arrow == '-' ? 2 : std::string_view("→").size();
        const char* here = clause.arrow + arrow_size;
        const char* const end = clause.text.data() + clause.text.size();
        if (!grammar.rewrites(letter[0])) grammar.letters.push_back(letter[0]);
        for (;;) {
            const char* const bar = std::find(here, end, '|');
            const std::string_view right = trimmed(between(here, bar));
            if (right.empty()) throw unexpected("a word (the empty word is ε)", bar);
            refuse_slips(right, reading.lexicon, true);
            grammar.rules[letter[0]].emplace_back(parse_symbols(right, reading.lexicon),
                                                  right.data());
            if (bar == end) break;
            here = bar + 1;
        }
    }
    if (grammar.letters.empty()) throw unexpected("a rule such as 'S -> aSb | ε'", text.data());
    grammar.start = grammar.letters.front();
    if (!start.empty()) {
        const Word named = parse_symbols(start, reading.lexicon);
        if (named.size() != 1 || !grammar.rewrites(named[0]))
            throw SyntaxError{start.data(),
                              "expected a letter that has a rule, found " + quoted(start)};
        grammar.start = named[0];
        std::rotate(grammar.letters.begin(),
                    std::find(grammar.letters.begin(), grammar.letters.end(), grammar.start),
                    grammar.letters.end());
    }
    for (const auto& [left, successors] : grammar.rules)
        for (const auto& [right, where] : successors)
            for (const Symbol a : right) {
                const std::string& name = reading.alphabet->name(a);
                const auto& declared = reading.declared;
                if (is_capital(name) && !grammar.rewrites(a) &&
                    !std::binary_search(declared.begin(), declared.end(), a))
                    throw SyntaxError{where, "expected a rule for " + quoted(name) +
                                                 ", found none; if it is a terminal, declare it by "
                                                 "'alphabet'"};
            }
    return grammar;
}

/// `CF { S -> aSb | ε; ... }`.
std::string grammar_text(const Grammar& grammar, const Alphabet& alphabet) {
    return "CF { " +
           joined(grammar.letters, "; ",
                  [&](Symbol letter) {
                      return alphabet.name(letter) + " -> " +
                             joined(grammar.rules.at(letter), " | ", [&](const auto& right) {
                                 return spell(alphabet, right.first);
                             });
                  }) +
           " }";
}

/// The system with these rules and A -> A, over an alphabet of its own.
ET0L grammar_system(const Grammar& grammar, const Alphabet& common) {
    auto alphabet = std::make_shared<Alphabet>();
    const auto word = [&](const Word& from) {
        Word own;
        for (const Symbol a : from) own.push_back(alphabet->symbol(common.name(a)));
        return own;
    };
    ET0L system;
    system.axiom = word({grammar.start});
    Table table;
    std::map<Symbol, std::vector<Word>> rules;
    for (const auto& [left, successors] : grammar.rules) {
        const Word own = word({left});
        std::vector<Word>& all = rules[own[0]];
        for (const auto& right : successors) all.push_back(word(right.first));
        all.push_back(own);
    }
    for (Symbol a = 0; a < alphabet->size(); ++a) {
        const auto found = rules.find(a);
        std::vector<Word> all = found == rules.end() ? std::vector<Word>{{a}} : found->second;
        std::vector<Word> distinct;
        for (Word& each : all)
            if (std::find(distinct.begin(), distinct.end(), each) == distinct.end())
                distinct.push_back(std::move(each));
        table.push_back(std::move(distinct));
        system.terminal.push_back(found == rules.end() ? 1 : 0);
    }
    system.alphabet = std::move(alphabet);
    system.tables = {std::move(table)};
    system.table_names = {{}};
    return system;
}

/// The regular expressions for the letters of a right-linear grammar.
class Equations {
public:
    Equations(const Grammar& grammar, const ClaimReading& reading) : grammar_(grammar) {
        for (const auto& [left, successors] : grammar.rules)
            for (const auto& [right, where] : successors) {
                const auto rewritten = [&](Symbol a) { return grammar.rewrites(a); };
                const auto first = std::find_if(right.begin(), right.end(), rewritten);
                if (first != right.end() && first + 1 != right.end())
                    throw SyntaxError{
                        where,
                        "expected at most one letter that is rewritten, at the end of the "
                        "word, found " +
                            quoted(spell(*reading.alphabet, right)) +
                            "; other grammars are written CF { ... }"};
                std::vector<Word>& words = words_[left][first == right.end() ? none : *first];
                words.emplace_back(right.begin(), first);
            }
    }

    LanguageOperand solve(const char* where) {
        where_ = where;
        std::map<Symbol, Row> rows;
        for (const auto& [left, row] : words_)
            for (const auto& [to, words] : row)
                rows[left].emplace(to, LanguageOperand{words_language(words), 0, 1});
        for (std::size_t i = grammar_.letters.size(); i-- > 0;) {
            const Symbol letter = grammar_.letters[i];
            Row solved = closed(std::move(rows[letter]), letter);
            if (i == 0) {
                const auto found = solved.find(none);
                return found == solved.end() ? LanguageOperand{words_language({}), 0, 1}
                                             : found->second;
            }
            for (std::size_t j = 0; j < i; ++j) put(rows[grammar_.letters[j]], letter, solved);
        }
        return {words_language({}), 0, 1};
    }

private:
    static constexpr Symbol none = ~Symbol{0};
    /// X = u1 Y1 | u2 Y2 | ... | v: what stands before each letter, and v for `none`.
    using Row = std::map<Symbol, LanguageOperand>;

    /// Without the letter itself on its right side.
    Row closed(Row row, Symbol letter) const {
        const auto self = row.find(letter);
        if (self == row.end()) return row;
        const LanguageOperand rounds = made(Kind::star, {self->second});
        row.erase(self);
        for (auto& [to, language] : row) language = product(rounds, language);
        return row;
    }
    /// With the right side of the letter in its place.
    void put(Row& row, Symbol letter, const Row& solved) const {
        const auto found = row.find(letter);
        if (found == row.end()) return;
        const LanguageOperand before = found->second;
        row.erase(found);
        for (const auto& [to, language] : solved) {
            const LanguageOperand more = product(before, language);
            const auto [place, is_new] = row.try_emplace(to, more);
            if (!is_new) place->second = sum(place->second, more);
        }
    }

    static const std::vector<Word>* words_of(const LanguageOperand& operand) {
        return operand.language->kind == Kind::words ? &operand.language->words : nullptr;
    }
    LanguageOperand product(const LanguageOperand& left, const LanguageOperand& right) const {
        const auto is_empty_word = [](const LanguageOperand& operand) {
            const auto* words = words_of(operand);
            return words && words->size() == 1 && words->front().empty();
        };
        if (is_empty_word(left)) return right;
        if (is_empty_word(right)) return left;
        return made(Kind::concatenated, {left, right});
    }
    LanguageOperand sum(const LanguageOperand& left, const LanguageOperand& right) const {
        const auto *one = words_of(left), *other = words_of(right);
        if (!one || !other) return made(Kind::united, {left, right});
        std::vector<Word> all = *one;
        all.insert(all.end(), other->begin(), other->end());
        return {words_language(std::move(all)), 0, 1};
    }
    LanguageOperand made(Kind kind, const std::vector<LanguageOperand>& parts) const {
        LanguageOperand whole;
        whole.parts = 0;
        std::vector<Language> languages;
        for (const LanguageOperand& part : parts) {
            whole.levels = std::max(whole.levels, part.levels + 1);
            whole.parts += part.parts;
            languages.push_back(part.language);
        }
        if (whole.levels > 1000 || whole.parts > 100'000)
            throw SyntaxError{
                where_,
                "the regular expression of this grammar has more than 1000 operations "
                "inside each other, or more than 100000 parts"};
        whole.language = combined(kind, std::move(languages));
        return whole;
    }

    const Grammar& grammar_;
    const char* where_ = nullptr;
    std::map<Symbol, std::map<Symbol, std::vector<Word>>> words_;
};

constexpr std::string_view grammar_words[] = {"CF", "regular"};

/// The brace behind the word that a grammar begins with; nullptr if none begins here.
const char* brace_of_grammar(const char* here, const char* end) {
    for (const std::string_view word : grammar_words) {
        if (!between(here, end).starts_with(word)) continue;
        const char* brace = here + word.size();
        skip_blanks(brace, end);
        if (brace != end && *brace == '{' && is_morphism(brace, end)) return brace;
    }
    return nullptr;
}

}  // namespace

bool is_grammar(const char* here, const char* end) {
    return brace_of_grammar(here, end) != nullptr;
}

LanguageOperand parse_grammar(const char*& here, const char* end, ClaimReading& reading,
                              const std::string& name) {
    const char* const begin = here;
    const char* const open = brace_of_grammar(here, end);
    const char* const close = closing_brace(open, end);
    const Grammar grammar = parse_rules(between(open + 1, close), reading);
    here = close + 1;
    for (const auto& [left, successors] : grammar.rules)
        for (const auto& [right, where] : successors)
            for (const Symbol a : right)
                if (!grammar.rewrites(a)) reading.add_letters({a});
    if (*begin == 'r') return Equations(grammar, reading).solve(begin);
    const std::string text = grammar_text(grammar, *reading.alphabet);
    return {generated_language(reading.add_grammar(
                name.empty() ? text : name, grammar_system(grammar, *reading.alphabet), text)),
            0, 1};
}

}  // namespace algae
