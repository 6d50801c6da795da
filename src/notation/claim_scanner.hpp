#pragma once

#include <string_view>

namespace algae {

/// A place in a clause of a claim that moves on over what is read there.
struct ClaimScanner {
    const char* here;
    const char* end;

    explicit ClaimScanner(std::string_view text)
        : here(text.data()), end(text.data() + text.size()) {}

    /// What is still to be read, after blanks.
    std::string_view rest();
    bool at_end() { return rest().empty(); }

    /// Moves over the token if it stands next.
    bool take(std::string_view token);
    /// Moves over the word if it stands next and nothing sticks to it.
    bool take_word(std::string_view word);
    /// The name that stands next: a letter, then letters, digits, `_` and `'`; empty if there is none.
    std::string_view name();
    std::string_view take_name();
    /// Moves over what stands up to the next blank.
    std::string_view take_piece();
};

/// Where `word` stands in the text between blanks (or the ends) and outside braces; npos if nowhere.
std::size_t find_word(std::string_view text, std::string_view word);

}  // namespace algae
