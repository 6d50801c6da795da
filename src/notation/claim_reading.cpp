#include <algorithm>

#include "model/model.hpp"

#include "notation/detail/blank_byte.hpp"
#include "notation/detail/claim_reading.hpp"

// Claims on their way from their text: clauses, and the names that a claim defines.
//
// Clauses are separated by line breaks and `;` outside braces, so a system or a set may go over lines. A
// brace that is never closed must not swallow the rest of the file: unclosed braces are found in a first walk
// and do not count in the second; the clause that has one is reported. Texts for people (`claim`, `note`,
// ...) may contain any brace.
//
// A name may be used only below its definition and not in it, so definitions are acyclic. `ClaimReading`
// keeps what each name stands for; `find` throws where a use stands too early, and `DependsOnError` where the
// definition was faulty. All systems of a claim are put over one alphabet, which grows while the claim is
// read: so each is kept over its own alphabet and put over the common one when it is added, and once more in
// the end (`finish`), when all letters are known. Complements are over the letters of the whole file, so they get these in the
// end too, and what depends on the letters of a complement is looked at only then (`finish_complements`).

namespace algae {

namespace {

/// Whether a clause that begins here is a text for people.
bool is_prose(std::string_view rest) {
    const std::size_t begin = rest.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return false;
    rest.remove_prefix(begin);
    for (const std::string_view word : {"claim", "source", "note", "title"})
        if (rest.starts_with(word) && is_before_blank(rest, word.size())) return true;
    return false;
}

/// Tells `on(offset)` of every brace, line break and `;` outside comments, and of every `#` that opens one,
/// until it says false.
template <class On>
void walk(std::string_view text, On on) {
    std::size_t begin = 0;
    bool prose = is_prose(text);
    for (std::size_t here = 0; here < text.size(); ++here) {
        const char byte = text[here];
        if (byte == '\n' || byte == ';') {
            if (!on(here)) return;
            begin = here + 1;
            prose = is_prose(text.substr(begin));
        } else if (byte == '#' && (here == begin || is_behind_blank(text, here))) {
            if (!on(here)) return;
            here = std::min(text.find('\n', here), text.size()) - 1;
        } else if ((byte == '{' || byte == '}') && !prose) {
            if (!on(here)) return;
        }
    }
}

/// The places of braces `{` without `}`, in increasing order.
std::vector<std::size_t> unclosed_braces(std::string_view text) {
    std::vector<std::size_t> open;
    walk(text, [&](std::size_t here) {
        if (text[here] == '{') open.push_back(here);
        if (text[here] == '}' && !open.empty()) open.pop_back();
        return true;
    });
    return open;
}

}  // namespace

std::string_view ClaimClause::value() const { return trimmed(text.substr(keyword.size())); }

std::vector<ClaimClause> claim_clauses(std::string_view text) {
    std::vector<ClaimClause> found;
    const std::vector<std::size_t> unclosed = unclosed_braces(text);
    auto next_unclosed = unclosed.begin();
    const char* first_unclosed = nullptr;  // of this clause
    std::size_t begin = 0, depth = 0;
    const auto add = [&](std::size_t end) {
        ClaimClause clause;
        clause.text = trimmed(text.substr(begin, end - begin));
        clause.unclosed = first_unclosed;
        first_unclosed = nullptr;
        if (clause.text.empty()) return;
        const auto blank = std::find_if(clause.text.begin(), clause.text.end(), is_blank_byte);
        clause.keyword =
            clause.text.substr(0, static_cast<std::size_t>(blank - clause.text.begin()));
        found.push_back(clause);
    };
    walk(text, [&](std::size_t here) {
        const char byte = text[here];
        if (byte == '{') {
            if (next_unclosed != unclosed.end() && *next_unclosed == here) {
                ++next_unclosed;
                if (!first_unclosed) first_unclosed = text.data() + here;
            } else {
                ++depth;
            }
        } else if (byte == '}') {
            if (depth > 0) --depth;
        } else if (depth == 0) {
            add(here);
            begin = byte == '#' ? std::min(text.find('\n', here), text.size()) : here + 1;
        }
        return true;
    });
    add(text.size());
    return found;
}

const char* closing_brace(const char* open, const char* end) {
    const std::string_view text{open, static_cast<std::size_t>(end - open)};
    std::size_t depth = 0, close = 0;
    walk(text, [&](std::size_t here) {
        if (text[here] == '{') ++depth;
        if (text[here] == '}' && --depth == 0) close = here;
        return close == 0;
    });
    return close > 0 ? open + close : nullptr;
}

namespace {

bool is_name_character(char byte, bool first) {
    const auto code = static_cast<unsigned char>(byte);
    return (code < 0x80 && is_letter(code)) ||
           (!first && (is_digit(code) || byte == '_' || byte == '\''));
}

}  // namespace

bool is_claim_name(std::string_view text) {
    return !text.empty() && is_name_character(text[0], true) &&
           std::all_of(text.begin(), text.end(),
                       [](char c) { return is_name_character(c, false); });
}

std::size_t find_word(std::string_view text, std::string_view word) {
    const auto is_bound = [&](std::size_t i) { return i >= text.size() || is_blank_byte(text[i]); };
    std::size_t depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '{') ++depth;
        if (text[i] == '}' && depth > 0) --depth;
        if (depth == 0 && text.substr(i).starts_with(word) && (i == 0 || is_bound(i - 1)) &&
            is_bound(i + word.size()))
            return i;
    }
    return std::string_view::npos;
}

namespace {

constexpr std::size_t most_suggested = 1000;  // to choose from more would take long and help little

/// The words that cannot be names of claims.
const std::vector<std::string>& claim_keywords() {
    static const std::vector<std::string> all{"is",     "in",       "not",       "by",
                                              "growth", "sequence", "dimension", "boundary",
                                              "word",   "CF",       "regular"};
    return all;
}

std::string kind_text(ClaimName::Kind kind) {
    switch (kind) {
        case ClaimName::Kind::system:
            return "a system";
        case ClaimName::Kind::morphism:
            return "a morphism";
        case ClaimName::Kind::word:
            return "a word";
        case ClaimName::Kind::number:
            return "a number";
        case ClaimName::Kind::rewriting:
            return "a system with probabilities, parameters or contexts of trees, of which claims "
                   "say what "
                   "it derives and how likely that is";
        default:
            return "a language";
    }
}

}  // namespace

ClaimReading::ClaimReading(const Source& text_source, Findings& text_findings,
                           const SystemSource& system_source)
    : source(text_source),
      findings(text_findings),
      open(system_source),
      alphabet(std::make_shared<Alphabet>()),
      lexicon(*alphabet) {}

namespace {

void check_name(std::string_view name) {
    const auto& keywords = claim_keywords();
    if (std::find(keywords.begin(), keywords.end(), name) != keywords.end() || system_form(name) ||
        is_rewriting_family(name))
        throw SyntaxError{name.data(),
                          "expected another name, " + quoted(name) + " has a meaning in claims"};
}

}  // namespace

ClaimName& ClaimReading::define(std::string_view name) {
    const auto [entry, is_new] = names_.try_emplace(std::string(name));
    if (!is_new)
        throw SyntaxError{name.data(), quoted(name) + " is defined twice, first in line " +
                                           std::to_string(source.place(entry->second.where).line)};
    entry->second.where = name.data();
    check_name(name);
    return entry->second;
}

ClaimName& ClaimReading::bind(std::string_view name, bool has_letters) {
    check_name(name);
    const auto [entry, is_new] = names_.try_emplace(std::string(name));
    hidden_.push_back(
        {std::string(name), is_new ? std::nullopt : std::optional(std::move(entry->second))});
    entry->second = {};
    entry->second.where = name.data();
    entry->second.end = name.data() + name.size();
    entry->second.variable = uses.size();
    uses.emplace_back();
    binds = binds || has_letters;
    return entry->second;
}

void ClaimReading::release(std::size_t bound) {
    for (; hidden_.size() > bound; hidden_.pop_back()) {
        auto& [name, meaning] = hidden_.back();
        if (meaning)
            names_.at(name) = std::move(*meaning);
        else
            names_.erase(name);
    }
}

const ClaimName* ClaimReading::find(std::string_view name) const {
    const auto found = names_.find(std::string(name));
    if (found == names_.end()) return nullptr;
    const ClaimName& known = found->second;
    if (known.where < name.data() && name.data() < known.end)
        throw SyntaxError{name.data(), quoted(name) + " stands in its own definition"};
    if (known.where >= name.data())
        throw SyntaxError{name.data(), "expected a name that is defined above, found " +
                                           quoted(name) + ", which is defined in line " +
                                           std::to_string(source.place(known.where).line)};
    if (known.kind == ClaimName::Kind::broken) throw DependsOnError();
    return &known;
}

const ClaimName& ClaimReading::expect(std::string_view name) const {
    if (const ClaimName* known = find(name)) return *known;
    throw SyntaxError{name.data(), "expected a name that is defined above, found " + quoted(name) +
                                       suggestion(name)};
}

std::string ClaimReading::suggestion(std::string_view name) const {
    std::vector<std::string> candidates;
    if (names_.size() < most_suggested)
        for (const auto& [known, meaning] : names_) candidates.push_back(known);
    std::sort(candidates.begin(), candidates.end());
    if (std::string meant = did_you_mean(name, candidates); !meant.empty()) return meant;
    std::string with_zero(name);
    std::replace(with_zero.begin(), with_zero.end(), 'O', '0');
    if (system_form(with_zero)) return "; did you mean '" + with_zero + "', with a zero?";
    const bool is_word =
        std::all_of(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    constexpr std::size_t longest = 40;
    const char* const behind = name.data() + name.size();
    const bool is_applied =
        behind != source.text().data() + source.text().size() && (*behind == '(' || *behind == '^');
    if (!is_word || is_applied || name.size() > longest) return {};
    return "; the language of one word is written {" + std::string(name) + "}";
}

std::shared_ptr<const SourceSystem> ClaimReading::system(std::string_view name) {
    const ClaimName* known = is_claim_name(name) ? find(name) : nullptr;
    if (!known && opens_systems) {
        const std::string key(name);
        if (const auto found = opened_.find(key); found != opened_.end()) return found->second;
        return opened_[key] = add_system(key, opened(key, name.data()), name.data());
    }
    if (!known) known = &expect(name);
    if (!known->system)
        throw SyntaxError{name.data(), "expected a system, found " + quoted(name) + ", " +
                                           kind_text(known->kind)};
    return known->system;
}

std::shared_ptr<const SourceSystem> ClaimReading::typed_system(std::string_view text) {
    const std::string key = "'" + std::string(text) + "'";
    if (const auto found = opened_.find(key); found != opened_.end()) return found->second;
    const std::size_t faults = findings.count();
    std::vector<std::string> declared_names;
    for (const Symbol symbol : declared) declared_names.push_back(alphabet->name(symbol));
    const Model system =
        read_system(text, source, findings, key, long_names, declared_names, {}, true);
    if (findings.count() > faults) {
        if (opens_systems) findings.throw_if_any();  // nothing else is read that could be faulty
        throw DependsOnError();
    }
    return opened_[key] = add_system(key, system, text.data());
}

std::shared_ptr<const LSystem> ClaimReading::rewriting(std::string_view name) const {
    const ClaimName* known = is_claim_name(name) ? find(name) : nullptr;
    return known ? known->rewriting : nullptr;
}

std::shared_ptr<const Model> ClaimReading::written(std::string_view name) const {
    const ClaimName& known = expect(name);
    if (!known.written)
        throw SyntaxError{
            name.data(), "expected a system, found " + quoted(name) + ", " + kind_text(known.kind)};
    return known.written;
}

bool ClaimReading::spaced() const {
    return std::ranges::any_of(
        declared, [&](Symbol symbol) { return is_declared_only(alphabet->name(symbol)); });
}

Symbol ClaimReading::declare(std::string_view name) {
    if (const std::optional<Symbol> known = alphabet->find(name)) return *known;
    if (undeclared_length(name) == name.size()) return alphabet->symbol(name);
    long_names.emplace_back(name);
    return lexicon.declare(name);
}

Model ClaimReading::opened(const std::string& name, const char* where) const {
    if (!open)
        throw SyntaxError{where,
                          "expected a system between braces: none can be opened by its name here"};
    try {
        return open(name);
    } catch (const Diagnostics& error) {
        const Diagnostic& first = error.findings().front();
        throw SyntaxError{
            where, "the system cannot be read: " + to_string(first.place) + ": " + first.message};
    } catch (const Error& error) {
        throw SyntaxError{where, error.what()};
    }
}

std::shared_ptr<const SourceSystem> ClaimReading::add_system(const std::string& name,
                                                             const LSystem& written,
                                                             const char* where) {
    Owned owned{std::make_shared<SourceSystem>(), {}};
    if (View<ET0L> tables = as_et0l(written)) {
        owned.own.tables = *tables;
    } else if (View<IL> interactive = as_il(written); interactive && !interactive->brackets) {
        owned.own.interactive = *interactive;
    } else {
        const bool has_context = std::any_of(
            written.rules.begin(), written.rules.end(),
            [](const Production& rule) { return !rule.left.empty() || !rule.right.empty(); });
        throw SyntaxError{
            where, "expected a system without context or one with plain contexts, but " + name +
                       " is " +
                       (interactive   ? "one with context whose words have brackets"
                        : has_context ? interactive.reason()
                                      : tables.reason())};
    }
    owned.own.name = name;
    for (Symbol symbol = 0; symbol < written.alphabet.size(); ++symbol)
        declare(written.alphabet.name(symbol));
    put_over_alphabet(owned);
    systems_.push_back(owned);
    return owned.system;
}

std::shared_ptr<const SourceSystem> ClaimReading::add_grammar(const std::string& name, ET0L system,
                                                              const std::string& grammar) {
    for (const auto& known : grammars)
        if (known->name == name && known->grammar == grammar) return known;
    Owned owned{std::make_shared<SourceSystem>(), {}};
    system.name = name;
    owned.own.name = name;
    owned.own.grammar = grammar;
    owned.own.tables = std::move(system);
    put_over_alphabet(owned);
    systems_.push_back(owned);
    grammars.push_back(owned.system);
    return owned.system;
}

void ClaimReading::put_over_alphabet(Owned& owned) const {
    owned.system->name = owned.own.name;
    owned.system->grammar = owned.own.grammar;
    if (owned.own.tables) owned.system->tables = over(*owned.own.tables, alphabet);
    if (owned.own.interactive) owned.system->interactive = over(*owned.own.interactive, alphabet);
}

bool is_open(const Language& language) {
    return language->variable || (language->system && language->system->variable) ||
           std::any_of(language->parts.begin(), language->parts.end(), is_open);
}

void ClaimReading::add_letters(const Word& word) {
    for (const Symbol letter : word) {
        if (letters.contains(letter)) continue;
        if (std::find(bound_letters.begin(), bound_letters.end(), letter) != bound_letters.end()) {
            const auto named = names_.find(alphabet->name(letter));
            if (named != names_.end() && named->second.variable &&
                named->second.kind == ClaimName::Kind::word)
                continue;
        }
        letters.insert(letter);
    }
}

Language ClaimReading::complement(Language language, const char* where) {
    auto tree = std::make_shared<LanguageTree>(*complement_language(std::move(language), Word()));
    complements_.push_back({tree, where});
    return tree;
}

Language ClaimReading::with_name(Language language, std::string name) {
    Language known = named(language, std::move(name));
    if (known->kind != LanguageTree::Kind::complement) return known;
    auto tree = std::make_shared<LanguageTree>(*known);
    for (const Complement& each : complements_)
        if (each.tree == language) {
            complements_.push_back({tree, each.where});
            break;
        }
    return tree;
}

namespace {

bool has_complement(const Language& language) {
    return language->kind == LanguageTree::Kind::complement ||
           std::any_of(language->parts.begin(), language->parts.end(), has_complement);
}

}  // namespace

void ClaimReading::check_images(const Language& language, const Morphism& morphism,
                                const char* where) {
    for (const Symbol letter : letters_of(language))
        if (!morphism.maps(letter))
            throw SyntaxError{where,
                              "expected a morphism with an image for each letter of the language, "
                              "found none for " +
                                  alphabet->name(letter)};
    if (has_complement(language)) images_.push_back({language, morphism, where});
}

std::vector<Symbol> ClaimReading::finish_complements() {
    if (complements_.empty()) return {};
    add_letters(declared);
    for (const Owned& owned : systems_) add_letters(letters_of(generated_language(owned.system)));
    const std::vector<Symbol> all(letters.begin(), letters.end());
    for (const Complement& each : complements_) {
        each.tree->letters = all;
        if (all.empty() && !is_open(each.tree))
            throw SyntaxError{each.where,
                              "expected letters for the words of a complement, found none; "
                              "'alphabet a b' says what letters there are"};
    }
    for (const Images& each : std::exchange(images_, {}))
        check_images(each.language, each.morphism, each.where);
    return all;
}

void ClaimReading::finish() {
    for (Owned& owned : systems_) put_over_alphabet(owned);
}

}  // namespace algae
