#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "notation/detail/expression_grammar.hpp"

// Words: how a text is cut into symbols, and the arguments, splices and quoted words between them.
//
// A symbol is one character, a letter with a subscript (`F_l`, `x_12`), or either behind `?`; longer names
// are symbols only where they are declared. The longest name wins. Declared names are kept in a trie, so that
// the next symbol takes as many steps as the longest name has bytes; most symbols are single ASCII
// characters, for which a table of 256 entries suffices (`Lexicon::plain`). This is the one part of the
// notation that meets texts of many megabytes (an axiom may be a whole word of a late generation), so it is a
// hand-written loop (`scan`), and a word without arguments takes four bytes a symbol. Brackets `[` and `]`
// are symbols like others; `check_brackets` looks for those without partner.

namespace algae {

bool is_reserved(char32_t code) {
    if (code < 0x80)
        return std::string_view("()<>:,;?#=").find(static_cast<char>(code)) !=
               std::string_view::npos;
    return code == 0x3B5 || code == 0x2192;  // the empty word, the arrow
}

std::size_t undeclared_length(std::string_view text) {
    if (text.empty()) return 0;
    const Character first = first_character(text);
    if (first.code == '?') {
        const std::string_view name = text.substr(1);
        if (name.empty() || !is_letter(first_character(name).code)) return 0;
        return 1 + undeclared_length(name);
    }
    if (!first.is_valid() || is_reserved(first.code) || is_blank(first.code) ||
        is_false_minus(first.code))
        return 0;
    std::size_t length = first.bytes;
    if (!is_letter(first.code) || length + 1 >= text.size() || text[length] != '_') return length;
    const std::string_view subscript = text.substr(length + 1);
    const Character letter = first_character(subscript);
    if (is_letter(letter.code)) return length + 1 + letter.bytes;
    std::size_t digits = 0;
    while (digits < subscript.size() && is_digit(static_cast<unsigned char>(subscript[digits])))
        ++digits;
    return digits > 0 ? length + 1 + digits : length;
}

Lexicon::Lexicon(Alphabet& alphabet) : alphabet_(alphabet) {
    symbols_.fill(unknown);
    for (unsigned byte = 0; byte < 128; ++byte)
        plain_[byte] = byte >= 0x20 && byte != 0x7F && !is_blank(byte) && !is_reserved(byte);
    for (Symbol symbol = 0; symbol < alphabet_.size(); ++symbol) {
        const std::string& name = alphabet_.name(symbol);
        if (undeclared_length(name) != name.size()) declare(name);
    }
}

Symbol Lexicon::declare(std::string_view name) {
    std::uint32_t node = 0;
    for (const char byte : name) {
        const auto fresh = static_cast<std::uint32_t>(trie_.size());
        const auto [edge, is_new] = trie_[node].next.try_emplace(byte, fresh);
        node = edge->second;
        if (is_new) trie_.emplace_back();
    }
    trie_[node].ends = true;
    plain_[static_cast<unsigned char>(name[0])] = false;
    return alphabet_.symbol(name);
}

std::size_t Lexicon::length(std::string_view text) const {
    std::size_t longest = undeclared_length(text);
    std::uint32_t node = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto edge = trie_[node].next.find(text[i]);
        if (edge == trie_[node].next.end()) break;
        node = edge->second;
        if (trie_[node].ends) longest = std::max(longest, i + 1);
    }
    return longest;
}

std::optional<Symbol> Lexicon::next(std::string_view& text) {
    const std::size_t bytes = length(text);
    if (bytes == 0) return std::nullopt;
    const Symbol symbol = alphabet_.symbol(text.substr(0, bytes));
    text.remove_prefix(bytes);
    return symbol;
}

std::optional<Symbol> Lexicon::plain(unsigned char byte) {
    if (!plain_[byte]) return std::nullopt;
    if (symbols_[byte] == unknown) {
        const char name = static_cast<char>(byte);
        symbols_[byte] = alphabet_.symbol({&name, 1});
    }
    return symbols_[byte];
}

namespace {

/// Reads a word and tells `on_symbol(symbol, where)`, `on_arguments(where)` and `on_splice(where)` what
/// it meets. The second is called at an opening bracket behind a symbol, the third at `<`; both return
/// where they ended. Of a quoted word it returns where its end is, otherwise the end of the text.
template <bool quoted = false, class OnSymbol, class OnArguments, class OnSplice>
const char* scan(std::string_view text, Lexicon& lexicon, OnSymbol on_symbol,
                 OnArguments on_arguments, OnSplice on_splice) {
    const char* here = text.data();
    const char* const end = here + text.size();
    bool may_open = false;  // a symbol without arguments stands before
    while (here != end) {
        const auto byte = static_cast<unsigned char>(*here);
        if (quoted && byte == '"') return here;
        if (here + 1 == end || here[1] != '_') {
            if (const auto plain = lexicon.plain(byte)) {
                on_symbol(*plain, here++);
                may_open = true;
                continue;
            }
        }
        std::string_view rest{here, static_cast<std::size_t>(end - here)};
        if (const auto symbol = lexicon.next(rest)) {
            on_symbol(*symbol, here);
            here = rest.data();
            may_open = true;
        } else if (const Character next = first_character(rest); is_blank(next.code)) {
            here += next.bytes;
        } else if (next.code == U'ε') {
            const std::string_view word = quoted ? text.substr(0, text.find('"')) : text;
            if (trimmed(word) != "ε")
                throw SyntaxError{here, "ε is the empty word and stands alone"};
            here += next.bytes;
        } else if (byte == '(' && may_open) {
            here = on_arguments(here);
            may_open = false;
        } else if (byte == '<') {
            here = on_splice(here);
            may_open = false;
        } else {
            if (byte == '#')
                throw SyntaxError{here,
                                  "expected a symbol, found '#'; a comment needs a blank before"};
            throw unexpected("a symbol", here);
        }
    }
    return here;
}

const char* no_splice(const char* where) { throw unexpected("a symbol", where); }

/// Where the `>` stands that ends the splice whose `<` is at `open`: the first outside brackets and
/// words in quotes.
const char* end_of_splice(const char* open, const char* end) {
    std::size_t depth = 0;
    bool quoted = false;
    for (const char* here = open + 1; here != end; ++here) {
        if (*here == '"') quoted = !quoted;
        if (quoted) continue;
        if (*here == '(') ++depth;
        if (*here == ')' && depth > 0) --depth;
        if (*here == '>' && depth == 0) return here;
    }
    throw SyntaxError{open, "'<' is never closed"};
}

Expression parse_splice(const char*& here, const char* end, Lexicon& lexicon,
                        const Source& source) {
    const char* const close = end_of_splice(here, end);
    ++here;
    Expression expression = parse_expression(here, close, source, &lexicon);
    if (here != close) throw unexpected("an operator or '>'", here);
    ++here;
    return expression;
}

}  // namespace

ModuleWord parse_word(std::string_view text, Lexicon& lexicon, const Source& source, bool splices) {
    ModuleWord word;
    word.letters.reserve(text.size());  // pages that are not written to cost nothing
    const char* const end = text.data() + text.size();
    scan(
        text, lexicon, [&](Symbol symbol, const char*) { word.letters.push_back(symbol); },
        [&](const char* where) {
            auto arguments = parse_arguments(where, end, source, &lexicon);
            word.arguments.emplace_hint(word.arguments.end(), word.letters.size() - 1,
                                        std::move(arguments));
            return where;
        },
        [&](const char* where) {
            if (!splices) no_splice(where);
            word.splices[word.letters.size()].push_back(parse_splice(where, end, lexicon, source));
            return where;
        });
    if (word.letters.capacity() > 2 * word.letters.size()) word.letters.shrink_to_fit();
    return word;
}

Expression parse_quoted(const char*& here, const char* end, Lexicon& lexicon, const Source& source,
                        std::size_t quotes) {
    constexpr std::size_t most = 20;
    if (quotes == most)
        throw SyntaxError{here, "more than " + std::to_string(most) + " words inside each other"};
    Expression quoted;
    quoted.kind = Expression::Kind::word;
    quoted.place = source.place(here);
    const char* const open = here++;
    ModuleWord word;
    here = scan<true>(
        {here, static_cast<std::size_t>(end - here)}, lexicon,
        [&](Symbol symbol, const char*) { word.letters.push_back(symbol); },
        [&](const char* where) {
            word.arguments.emplace(word.letters.size() - 1,
                                   parse_arguments(where, end, source, &lexicon, quotes + 1));
            return where;
        },
        no_splice);
    if (here == end) throw SyntaxError{open, "'\"' is never closed"};
    ++here;
    if (!word.letters.empty()) quoted.name = print_word(lexicon.alphabet(), word);
    quoted.word = std::make_shared<const ModuleWord>(std::move(word));
    return quoted;
}

Word parse_symbols(std::string_view text, Lexicon& lexicon) {
    Word word;
    scan(
        text, lexicon, [&](Symbol symbol, const char*) { word.push_back(symbol); },
        [&](const char* where) -> const char* {
            throw unexpected("symbols without parameters", where);
        },
        no_splice);
    return word;
}

void check_brackets(const ModuleWord& word, std::string_view text, Lexicon& lexicon,
                    const Source& source, Findings& findings) {
    constexpr std::size_t most = 20;  // of each kind; more are not shown anyway
    const auto open = lexicon.known("["), close = lexicon.known("]");
    std::vector<std::size_t> unmatched, unclosed;  // positions in the word
    std::size_t depth = 0;
    for (std::size_t i = 0; i < word.letters.size(); ++i) {
        if (word.letters[i] == open) {
            ++depth;
        } else if (word.letters[i] == close) {
            if (depth > 0)
                --depth;
            else if (unmatched.size() < most)
                unmatched.push_back(i);
        }
    }
    std::size_t closed = 0, skipped = depth > most ? depth - most : 0;
    for (std::size_t i = word.letters.size(); depth > 0 && i-- > 0;) {
        if (word.letters[i] == close) {
            ++closed;
        } else if (word.letters[i] == open) {
            if (closed > 0) {
                --closed;
            } else if (--depth; skipped > 0) {
                --skipped;  // the inner ones
            } else {
                unclosed.push_back(i);
            }
        }
    }
    if (unmatched.empty() && unclosed.empty()) return;
    std::size_t position = 0;
    scan(
        text, lexicon,
        [&](Symbol, const char* where) {
            if (std::find(unmatched.begin(), unmatched.end(), position) != unmatched.end())
                findings.add(where, "unmatched ']'");
            if (std::find(unclosed.begin(), unclosed.end(), position) != unclosed.end())
                findings.add(where, "'[' is never closed");
            ++position;
        },
        [&](const char* where) {
            parse_arguments(where, text.data() + text.size(), source, &lexicon);
            return where;
        },
        [&](const char* where) { return end_of_splice(where, text.data() + text.size()) + 1; });
}

}  // namespace algae
