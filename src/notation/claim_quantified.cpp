#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "notation/detail/blank_byte.hpp"
#include "notation/detail/claim_reading.hpp"
#include "notation/detail/grammar.hpp"

// Statements made of others: `for all 0L languages A, B with A != B: A | B is 0L`, and statements joined by `not`,
// `and`, `or`, `implies` and `iff`, the tightest first.
//
//     QUANTIFIED = ("for all" | "for some") BINDING {"and" BINDING} ["with" STATEMENT {"and" STATEMENT}] ":" STATEMENT
//     BINDING    = NOUN NAME {"," NAME}, with bounds behind the noun or the names
//
// A statement is cut at words outside brackets, the loosest first, and what is left are single statements. Words that
// join are words between blanks, so none of the single statements has one. A head is cut at its colon, at `with`
// and at `and`; each binding is then a few words: an adjective or the name of a family, a noun, names and bounds.
// "for every", "for each" and "there is" are read as the same two quantifiers, and nouns in singular or plural.
//
// A bound name is known from its binding to the end of the statement. A bound word or letter stands in words as a
// letter of the alphabet would; so it must not be a letter of the claim already.

namespace algae {

namespace {

using grammar::between;

/// Calls `on(offset)` for each byte outside brackets of all kinds, until it says false.
template <class On>
void outside_brackets(std::string_view text, On on) {
    std::size_t depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char byte = text[i];
        if (byte == '(' || byte == '{' || byte == '[') ++depth;
        if (depth == 0 && !on(i)) return;
        if ((byte == ')' || byte == '}' || byte == ']') && depth > 0) --depth;
    }
}

bool is_blank_at(std::string_view text, std::size_t i);

/// The words of a text, cut at blanks outside brackets.
std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    std::size_t begin = 0;
    const auto end_at = [&](std::size_t i) {
        if (i > begin) words.push_back(text.substr(begin, i - begin));
        begin = i + 1;
    };
    outside_brackets(text, [&](std::size_t i) {
        if (is_blank_at(text, i)) end_at(i);
        return true;
    });
    end_at(text.size());
    return words;
}

bool is_blank_at(std::string_view text, std::size_t i) {
    return i >= text.size() || is_blank_byte(text[i]) || text[i] == '\n';
}

/// Where a word stands outside brackets from `from` on; npos if nowhere.
std::size_t find_joint(std::string_view text, std::string_view word, std::size_t from = 0) {
    std::size_t found = std::string_view::npos;
    outside_brackets(text, [&](std::size_t i) {
        const bool here =
            i >= from && text.substr(i).starts_with(word) &&
            (i == 0 || is_blank_at(text, i - 1) || text[i - 1] == ')' || text[i - 1] == '}') &&
            (is_blank_at(text, i + word.size()) || text[i + word.size()] == '(' ||
             text[i + word.size()] == '{');
        if (here) found = i;
        return !here;
    });
    return found;
}

/// The parts of a text between words outside brackets.
std::vector<std::string_view> split(std::string_view text, std::string_view word) {
    std::vector<std::string_view> parts;
    std::size_t begin = 0;
    for (std::size_t at; (at = find_joint(text, word, begin)) != std::string_view::npos;) {
        parts.push_back(text.substr(begin, at - begin));
        begin = at + word.size();
    }
    parts.push_back(text.substr(begin));
    return parts;
}

/// Takes words off the front of a text, if it begins with them.
bool take_words(std::string_view& text, std::initializer_list<const char*> words) {
    const char* here = text.data();
    const char* const end = here + text.size();
    for (const char* const word : words)
        if (!grammar::read(here, end, grammar::word(word))) return false;
    text = between(here, end);
    return true;
}

// --- Bindings ---

/// A noun that names may range over, with what stands in front of it.
struct Noun {
    std::string_view adjective;  // words in front; a family in front if there is none here
    std::string_view singular, plural;
    Domain domain;
};

const std::vector<Noun>& nouns() {
    using Kind = Domain::Kind;
    static const std::vector<Noun> all{
        {"", "language", "languages", {.kind = Kind::language}},
        {"finite", "language", "languages", {.kind = Kind::language}},
        {"", "system", "systems", {.kind = Kind::system}},
        {"", "word", "words", {.kind = Kind::word}},
        {"", "letter", "letters", {.kind = Kind::letter}},
        {"", "morphism", "morphisms", {.kind = Kind::morphism}},
        {"non-erasing", "morphism", "morphisms", {.kind = Kind::morphism, .nonerasing = true}},
        {"letter-to-letter",
         "morphism",
         "morphisms",
         {.kind = Kind::morphism, .nonerasing = true, .letter_to_letter = true}},
        {"",
         "coding",
         "codings",
         {.kind = Kind::morphism, .nonerasing = true, .letter_to_letter = true}},
        {"finite", "substitution", "substitutions", {.kind = Kind::substitution}},
        {"non-erasing finite",
         "substitution",
         "substitutions",
         {.kind = Kind::substitution, .nonerasing = true}},
        {"", "number", "numbers", {.kind = Kind::number}}};
    return all;
}

constexpr const char* domains =
    "what the name ranges over (0L languages, finite languages, D0L systems, words, letters, "
    "morphisms, ...)";

/// Reads one binding, word by word.
class BindingReader {
public:
    BindingReader(std::string_view text, Quantified& said, ClaimReading& reading)
        : text_(text), words_(words_of(text)), said_(said), reading_(reading) {}

    void read() {
        if (words_.empty()) throw unexpected(domains, text_.data());
        const Noun& noun = read_noun();
        binding_.domain = noun.domain;
        while (next_ < words_.size())
            if (!read_bound() && !read_compared()) read_names();
        if (names_.empty())
            throw unexpected("a name behind " + quoted(words_.back()), text_.data() + text_.size());
        for (const std::string_view name : names_) bind(name);
        for (const std::string_view condition : conditions_)
            said_.conditions.push_back(parse_statement(condition, reading_));
    }

private:
    const Noun& read_noun() {
        const auto is_noun = [](std::string_view word) {
            return std::any_of(nouns().begin(), nouns().end(), [&](const Noun& noun) {
                return word == noun.singular || word == noun.plural;
            });
        };
        const auto at = std::find_if(words_.begin(), words_.end(), is_noun);
        if (at == words_.end() && is_number_list()) {
            binding_.text = "numbers";
            return nouns().back();
        }
        if (at == words_.end()) {
            std::vector<std::string> known;
            for (const Noun& noun : nouns()) known.emplace_back(noun.plural);
            const std::size_t second = words_.size() > 1 ? 1 : 0;
            throw unknown_word(domains, words_[second], known);
        }
        next_ = static_cast<std::size_t>(at - words_.begin()) + 1;
        std::vector<std::string_view> before(words_.begin(), at);
        if (!before.empty() && (before[0] == "a" || before[0] == "an"))
            before.erase(before.begin());
        const std::string adjective = joined(before, " ");
        binding_.text = (adjective.empty() ? "" : adjective + " ");
        const Noun* plain = nullptr;
        for (const Noun& noun : nouns()) {
            if (*at != noun.singular && *at != noun.plural) continue;
            binding_.text += noun.plural;
            if (noun.adjective == adjective) return plain_noun(noun);
            if (noun.adjective.empty()) plain = &noun;
            binding_.text.resize(binding_.text.size() - noun.plural.size());
        }
        const auto family = language_family(adjective);
        const bool is_language = plain && plain->domain.kind == Domain::Kind::language;
        const bool is_system = plain && plain->domain.kind == Domain::Kind::system;
        if (!family || (!is_language && !is_system)) refuse(before, *at);
        return is_language ? languages_of(*plain, *family) : systems_of(*plain, *family, before[0]);
    }

    /// `n`, `n >= 1`, `k, n`: names without a noun are numbers, as textbooks write.
    bool is_number_list() const {
        const auto is_sign = [](char c) {
            return c == '<' || c == '>' || c == '=' || c == ',' ||
                   is_digit(static_cast<unsigned char>(c)) || is_blank_byte(c);
        };
        std::size_t names = 0, signs = 0;
        for (const std::string_view word : words_) {
            names += is_claim_name(word.substr(0, 1)) ? 1 : 0;
            signs += std::count_if(word.begin(), word.end(), is_sign) > 0 ? 1 : 0;
            const bool is_plain = std::all_of(word.begin(), word.end(), [&](char c) {
                return is_sign(c) || (c >= 'a' && c <= 'z');
            });
            if (!is_plain) return false;
        }
        return names == 1 || (names > 1 && signs > 0);
    }

    [[noreturn]] void refuse(const std::vector<std::string_view>& before,
                             std::string_view noun) const {
        std::vector<std::string> known;
        for (const Noun& one : nouns())
            if ((noun == one.singular || noun == one.plural) && !one.adjective.empty())
                known.emplace_back(one.adjective);
        if (noun.starts_with("language") || noun.starts_with("system"))
            known.insert(known.end(), common_families().begin(), common_families().end());
        if (before.empty())
            throw unexpected("a family of systems (0L, D0L, PD0L, ...) before 'systems'",
                             noun.data());
        const std::string expected =
            known.empty() ? "no word before " + quoted(noun)
                          : "one of " + joined(known, ", ") + " before " + quoted(noun);
        std::string with_zero(before[0]);
        std::replace(with_zero.begin(), with_zero.end(), 'O', '0');
        if (with_zero != before[0] && language_family(with_zero))
            throw SyntaxError{before[0].data(), "expected " + expected + ", found " +
                                                    quoted(before[0]) + "; did you mean '" +
                                                    with_zero + "', with a zero?"};
        throw unknown_word(expected, before[0], known);
    }

    const Noun& plain_noun(const Noun& noun) const {
        if (noun.domain.kind == Domain::Kind::system) refuse({}, words_[next_ - 1]);
        return noun;
    }

    const Noun& languages_of(const Noun& noun, const std::string& family) {
        binding_.family = family;
        binding_.text = family + " languages";
        return noun;
    }

    const Noun& systems_of(const Noun& noun, const std::string& family, std::string_view where) {
        const auto form = system_form(family);
        if (!form || form->extended || form->interactive)
            throw SyntaxError{
                where.data(),
                "expected a family of 0L systems with or without tables (0L, P0L, D0L, PD0L, "
                "T0L, PT0L, DT0L, PDT0L), found " +
                    quoted(where)};
        Noun made = noun;
        made.domain.deterministic = form->deterministic;
        made.domain.propagating = form->propagating;
        made.domain.tables = form->tables;
        binding_.text = family + " systems";
        own_ = made;
        return own_;
    }

    bool next_is(std::string_view word) const {
        return next_ < words_.size() && words_[next_] == word;
    }

    void expect(std::string_view word) {
        if (!next_is(word)) throw unexpected(quoted(word), where());
        ++next_;
    }
    const char* where() const {
        return next_ < words_.size() ? words_[next_].data() : text_.data() + text_.size();
    }

    std::uint64_t number() {
        const bool is_number = next_ < words_.size() &&
                               std::all_of(words_[next_].begin(), words_[next_].end(), [](char c) {
                                   return is_digit(static_cast<unsigned char>(c));
                               });
        if (!is_number) throw unexpected("a number", where());
        const Integer read = natural_number(words_[next_]);
        constexpr std::uint64_t most = 1'000'000;
        if (read > Integer(most))
            throw SyntaxError{words_[next_].data(), "expected a number up to 1000000"};
        ++next_;
        return read.to_uint64();
    }

    /// `up to size 8`, `up to 20`, `with words up to length 3`, `over {a, b}`, `over different letters`.
    bool read_bound() {
        using Kind = Domain::Kind;
        if (next_is("with")) {
            ++next_;
            expect("words");
            expect("up");
            expect("to");
            expect("length");
            binding_.domain.max_word_length = number();
        } else if (next_is("up")) {
            ++next_;
            expect("to");
            if (binding_.domain.kind == Kind::number) {
                binding_.domain.max_number = number();
            } else if (binding_.domain.kind == Kind::word && next_is("length")) {
                ++next_;
                binding_.domain.max_word_length = number();
            } else {
                expect("size");
                binding_.domain.max_size = number();
            }
        } else if (next_is("over")) {
            ++next_;
            if (next_is("different") || next_is("disjoint")) {
                const bool different = next_is("different");
                ++next_;
                expect(different ? "letters" : "alphabets");
                said_.disjoint = true;
            } else {
                read_letters();
            }
        } else {
            return false;
        }
        return true;
    }

    void read_letters() {
        const std::string_view set = next_ < words_.size() ? words_[next_] : std::string_view();
        if (!set.starts_with('{') || !set.ends_with('}'))
            throw unexpected("letters between braces, such as {a, b}, or 'different letters'",
                             where());
        if (said_.over)
            throw SyntaxError{
                set.data(),
                "expected 'over' and letters once, found them twice; they hold for all names"};
        said_.over.emplace();
        std::string_view rest = set.substr(1, set.size() - 2);
        while (true) {
            const std::size_t comma = rest.find(',');
            const std::string_view letter = trimmed(rest.substr(0, comma));
            if (letter.empty()) throw unexpected("a letter", letter.data());
            const Symbol symbol = reading_.declare(letter);
            if (std::count(said_.over->begin(), said_.over->end(), symbol) > 0)
                throw SyntaxError{letter.data(),
                                  "the letter " + quoted(letter) + " stands there twice"};
            said_.over->push_back(symbol);
            reading_.add_letters({symbol});
            if (comma == std::string_view::npos) break;
            rest.remove_prefix(comma + 1);
        }
        ++next_;
    }

    /// `k < n`, `n >= 1`: numbers with conditions on them, up to the next bound.
    bool read_compared() {
        if (binding_.domain.kind != Domain::Kind::number || !names_.empty()) return false;
        std::string_view rest = between(words_[next_].data(), text_.data() + text_.size());
        if (rest.find_first_of("<>") == std::string_view::npos) return false;
        next_ = words_.size();
        while (!rest.empty()) {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            const std::string_view piece = trimmed(rest.substr(0, comma));
            rest.remove_prefix(std::min(comma + 1, rest.size()));
            for (std::size_t i = 0; i < piece.size(); ++i) {
                if (!is_claim_name(piece.substr(i, 1))) continue;
                const std::size_t begin = i;
                while (i + 1 < piece.size() && is_claim_name(piece.substr(begin, i + 2 - begin)))
                    ++i;
                const std::string_view name = piece.substr(begin, i + 1 - begin);
                if (std::find(names_.begin(), names_.end(), name) == names_.end())
                    names_.push_back(name);
            }
            if (piece.empty()) throw unexpected("a name", piece.data());
            if (!is_claim_name(piece)) conditions_.push_back(piece);
        }
        if (const auto most = greatest()) {
            binding_.domain.max_number = *most;
            conditions_.clear();
        }
        return true;
    }

    /// `n < 5`, `n <= 4` of the only name: few numbers, each of which is looked at.
    std::optional<std::uint64_t> greatest() const {
        if (names_.size() != 1 || conditions_.size() != 1) return std::nullopt;
        std::string_view rest = conditions_.front();
        if (!rest.starts_with(names_.front())) return std::nullopt;
        rest = trimmed(rest.substr(names_.front().size()));
        if (!rest.starts_with('<')) return std::nullopt;
        const bool is_less = !rest.starts_with("<=");
        rest = trimmed(rest.substr(is_less ? 1 : 2));
        constexpr std::uint64_t few = 10'000;
        if (rest.empty() || !std::all_of(rest.begin(), rest.end(), [](char c) {
                return is_digit(static_cast<unsigned char>(c));
            }))
            return std::nullopt;
        const Integer bound = natural_number(rest);
        if (bound > Integer(few) || (is_less && bound.is_zero())) return std::nullopt;
        return bound.to_uint64() - (is_less ? 1 : 0);
    }

    /// `A, B`.
    void read_names() {
        if (!names_.empty())
            throw unexpected("a bound (up to, over, with words up to length), 'and', 'with' or ':'",
                             where());
        bool more = true;
        while (more) {
            if (next_ == words_.size()) throw unexpected("a name", where());
            std::string_view piece = words_[next_];
            more = false;
            while (!piece.empty()) {
                const std::size_t comma = piece.find(',');
                const std::string_view name = piece.substr(0, comma);
                if (!is_claim_name(name))
                    throw unexpected("a name (letters, digits, _ and ')", piece.data());
                names_.push_back(name);
                more = comma != std::string_view::npos;
                piece = more ? piece.substr(comma + 1) : std::string_view();
            }
            ++next_;
        }
    }

    void bind(std::string_view name) {
        for (const QuantifiedName& other : said_.bindings)
            if (other.name == name)
                throw SyntaxError{name.data(), "the name " + quoted(name) + " is bound twice"};
        ClaimName& bound = reading_.bind(name, binding_.domain.kind != Domain::Kind::number);
        QuantifiedName made = binding_;
        made.name = name;
        using Kind = Domain::Kind;
        switch (binding_.domain.kind) {
            case Kind::language: {
                LanguageTree tree;
                tree.kind = LanguageTree::Kind::variable;
                tree.variable = BoundName{*bound.variable, std::string(name)};
                bound.language = {std::make_shared<const LanguageTree>(std::move(tree)), 0, 1};
                bound.kind = ClaimName::Kind::language;
                break;
            }
            case Kind::system: {
                auto system = std::make_shared<SourceSystem>();
                system->name = name;
                system->variable = bound.variable;
                bound.system = std::move(system);
                bound.kind = ClaimName::Kind::system;
                break;
            }
            case Kind::word:
            case Kind::letter:
                made.letter = bound_letter(name);
                bound.kind = ClaimName::Kind::word;
                break;
            case Kind::number:
                bound.kind = ClaimName::Kind::number;
                // Conditions between the names use them where they are bound.
                bound.where = bound.end = text_.data() - 1;
                break;
            default:
                bound.kind = ClaimName::Kind::morphism;
        }
        said_.bindings.push_back(std::move(made));
    }

    Symbol bound_letter(std::string_view name) const {
        if (const auto known = reading_.alphabet->find(name);
            known &&
            std::count(reading_.bound_letters.begin(), reading_.bound_letters.end(), *known) == 0)
            throw SyntaxError{
                name.data(),
                "expected a name that is not a letter of the claim, found " + quoted(name)};
        const Symbol letter = reading_.declare(name);
        reading_.bound_letters.push_back(letter);
        return letter;
    }

    std::string_view text_;
    std::vector<std::string_view> words_;
    std::size_t next_ = 0;
    Quantified& said_;
    ClaimReading& reading_;
    QuantifiedName binding_;
    Noun own_;
    std::vector<std::string_view> names_;
    std::vector<std::string_view> conditions_;  // on numbers, between their names
};

// --- Statements made of others ---

class ComposedReader {
public:
    explicit ComposedReader(ClaimReading& reading) : reading_(reading) {}

    Statement read(std::string_view text, std::size_t depth = 0) {
        text = trimmed(text);
        if (text.empty()) throw unexpected("a statement", text.data());
        constexpr std::size_t most = 100;
        if (depth > most)
            throw SyntaxError{text.data(), "more than 100 statements inside each other"};
        if (const auto system = first_order_system(text, reading_))
            return parse_first_order(*system, text, reading_);
        if (is_on_complexities(text)) return parse_single_statement(text, reading_);
        std::string_view rest = text;
        bool denied = false;
        while (take_words(rest, {"not"})) {
            if (denied)
                throw SyntaxError{rest.data(),
                                  "expected at most one negation, found a second behind 'not'"};
            denied = true;
        }
        if (const auto universal = quantifier(rest)) {
            Statement read = quantified(*universal, rest, depth);
            read.negated = denied;
            return placed(std::move(read), text);
        }
        if (is_closure_fact(rest)) return placed(closed_under(denied, rest), text);
        using Joined = Joint::Kind;
        for (const auto& [word, kind] :
             {std::pair{"iff", Joined::iff}, std::pair{"implies", Joined::implies},
              std::pair{"or", Joined::any}, std::pair{"and", Joined::all}}) {
            std::vector<std::string_view> parts = split(text, word);
            if (parts.size() < 2) continue;
            if (kind == Joined::iff && parts.size() > 2)
                throw SyntaxError{trimmed(parts[2]).data(),
                                  "expected one 'iff', found a second; use brackets"};
            if (kind == Joined::implies && parts.size() > 2)  // from right to left
                parts = {parts[0], between(parts[1].data(), text.data() + text.size())};
            Joint joint{kind, {}};
            for (const std::string_view part : parts) joint.parts.push_back(read(part, depth + 1));
            Statement made;
            made.says = std::move(joint);
            return placed(std::move(made), text);
        }
        const std::string_view inner = trimmed(denied ? rest : text);
        if (is_bracketed(inner)) {
            Statement made = read(inner.substr(1, inner.size() - 2), depth + 1);
            if (denied) made.negated = !made.negated;
            return placed(std::move(made), text);
        }
        return parse_single_statement(text, reading_);
    }

private:
    /// Whether the first bracket closes at the end, and a statement stands within and not a language.
    static bool is_bracketed(std::string_view text) {
        if (!text.starts_with('(') || !text.ends_with(')')) return false;
        std::size_t outside = 0;
        outside_brackets(text, [&](std::size_t) {
            ++outside;
            return true;
        });
        return outside == 0;
    }

    /// Whether the colon at an offset is that of a condition `G : x ==> y`: behind `with` or `and` and a name.
    static bool is_of_derivation(std::string_view text, std::size_t colon) {
        const std::vector<std::string_view> before = words_of(text.substr(0, colon));
        const std::string_view behind = text.substr(colon + 1);
        return before.size() > 1 && is_claim_name(before.back()) &&
               (before[before.size() - 2] == "with" || before[before.size() - 2] == "and") &&
               behind.substr(0, behind.find(':')).find("==>") != std::string_view::npos;
    }

    static std::optional<bool> quantifier(std::string_view& rest) {
        for (const char* word : {"all", "every", "each"})
            if (take_words(rest, {"for", word})) return true;
        if (take_words(rest, {"for", "some"}) || take_words(rest, {"there", "is"}) ||
            take_words(rest, {"there", "are"}))
            return false;
        return std::nullopt;
    }

    /// `closed under union: 0L P0L`: each of the families is, or with `not` none of them.
    Statement closed_under(bool denied, std::string_view text) {
        const ClosureFact fact = parse_closure_fact(text, reading_);
        Joint joint{Joint::Kind::all, {}};
        for (const std::string& family : fact.families) {
            auto one = closure_statement(family, fact.operation, !denied, reading_.uses.size());
            if (!one)
                throw SyntaxError{text.data(), "expected another operation than " + fact.operation +
                                                   ", of which no statement about all languages "
                                                   "can be made"};
            reading_.uses.resize(reading_.uses.size() +
                                 std::get<Quantified>(one->says).bindings.size());
            if (denied) one->text = "not " + one->text;
            one->negated = denied;
            one->place = reading_.source.place(text.data());
            joint.parts.push_back(std::move(*one));
        }
        reading_.binds = true;
        if (joint.parts.size() == 1) return joint.parts.front();
        Statement made;
        made.says = std::move(joint);
        return made;
    }

    Statement placed(Statement statement, std::string_view text) const {
        statement.text = text;
        statement.place = reading_.source.place(text.data());
        return statement;
    }

    /// What stands behind `for all`.
    Statement quantified(bool universal, std::string_view text, std::size_t depth) {
        std::size_t colon = std::string_view::npos;
        outside_brackets(text, [&](std::size_t i) {
            if (text[i] == ':' && !is_of_derivation(text, i)) colon = i;
            return colon == std::string_view::npos;
        });
        if (colon == std::string_view::npos)
            throw unexpected("':' and a statement behind what the names range over",
                             text.data() + text.size());
        if (++alternations_ > 2)
            throw SyntaxError{text.data(),
                              "expected at most one quantifier inside another, found a third"};
        std::string_view head = text.substr(0, colon), conditions;
        for (std::size_t at = 0; (at = find_joint(head, "with", at)) != std::string_view::npos;
             ++at) {
            std::string_view behind = head.substr(at);
            if (take_words(behind, {"with", "words", "up"})) continue;
            conditions = head.substr(at + std::string_view("with").size());
            head = head.substr(0, at);
            break;
        }
        struct Scope {  // in which the names are bound
            explicit Scope(ClaimReading& of) : reading(of), before(of.bound()) {}
            ~Scope() { reading.release(before); }
            ClaimReading& reading;
            std::size_t before;
        } scope(reading_);
        Quantified said;
        said.universal = universal;
        said.first = reading_.uses.size();
        for (const std::string_view part : split(head, "and"))
            BindingReader(part, said, reading_).read();
        if (conditions.data())
            for (const std::string_view part : split(conditions, "and"))
                said.conditions.push_back(read(part, depth + 1));
        said.body.push_back(read(text.substr(colon + 1), depth + 1));
        const auto is_mapping = [](const QuantifiedName& name) {
            using Kind = Domain::Kind;
            return name.domain.kind == Kind::morphism || name.domain.kind == Kind::substitution;
        };
        for (std::size_t i = 0; i < said.bindings.size(); ++i) {
            QuantifiedName& name = said.bindings[i];
            if (!is_mapping(name)) continue;
            if (i + 1 < said.bindings.size() && !is_mapping(said.bindings[i + 1]))
                throw SyntaxError{text.data(),
                                  "expected the languages before the morphism that is applied to "
                                  "them, found " +
                                      quoted(said.bindings[i + 1].name) + " behind " +
                                      quoted(name.name)};
            if (!reading_.uses[said.first + i].inverse) continue;
            if (name.domain.kind == Domain::Kind::substitution)
                throw SyntaxError{text.data(),
                                  "expected a morphism where an inverse is used, found "
                                  "the finite substitution " +
                                      quoted(name.name)};
            name.domain.kind = Domain::Kind::inverse_morphism;
        }
        --alternations_;
        Statement made;
        made.says = std::move(said);
        return made;
    }

    ClaimReading& reading_;
    std::size_t alternations_ = 0;
};

}  // namespace

Statement parse_statement(std::string_view text, ClaimReading& reading) {
    return ComposedReader(reading).read(text);
}

}  // namespace algae
