#include "notation/word_grammar.hpp"

#include <algorithm>
#include <utility>

#include "notation/characters.hpp"
#include "notation/expression_grammar.hpp"

namespace algae {

namespace {

/// Reads a word and tells `on_symbol(symbol, where)` and `on_arguments(where)` what it meets. The
/// latter is called at an opening bracket behind a symbol and returns where it closed.
template <class OnSymbol, class OnArguments>
void scan(std::string_view text, Lexicon& lexicon, OnSymbol on_symbol, OnArguments on_arguments) {
    const char* here = text.data();
    const char* const end = here + text.size();
    bool may_open = false;  // a symbol without arguments stands before
    while (here != end) {
        const auto byte = static_cast<unsigned char>(*here);
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
        } else {
            if (byte == '#')
                throw SyntaxError{here,
                                  "expected a symbol, found '#'; a comment needs a blank before"};
            throw unexpected("a symbol", here);
        }
    }
}

}  // namespace

ModuleWord parse_word(std::string_view text, Lexicon& lexicon, const Source& source) {
    ModuleWord word;
    word.letters.reserve(text.size());  // pages that are not written to cost nothing
    const char* const end = text.data() + text.size();
    scan(
        text, lexicon, [&](Symbol symbol, const char*) { word.letters.push_back(symbol); },
        [&](const char* where) {
            auto arguments = parse_arguments(where, end, source);
            word.arguments.emplace_hint(word.arguments.end(), word.letters.size() - 1,
                                        std::move(arguments));
            return where;
        });
    if (word.letters.capacity() > 2 * word.letters.size()) word.letters.shrink_to_fit();
    return word;
}

Word parse_symbols(std::string_view text, Lexicon& lexicon) {
    Word word;
    scan(
        text, lexicon, [&](Symbol symbol, const char*) { word.push_back(symbol); },
        [&](const char* where) -> const char* {
            throw unexpected("symbols without parameters", where);
        });
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
            parse_arguments(where, text.data() + text.size(), source);
            return where;
        });
}

}  // namespace algae
