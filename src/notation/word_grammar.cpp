#include "notation/word_grammar.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "notation/characters.hpp"
#include "notation/expression_grammar.hpp"
#include "notation/print.hpp"

namespace algae {

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
        } else if (const Character next = first_character(rest);
                   is_blank(next.code) || next.code == U'ε') {
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
