#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/place.hpp"
#include "nature/relative.hpp"
#include "system/expression.hpp"

namespace algae {

/// What a statement of a relative's file may begin with.
struct RelativeKey {
    std::string name;
    std::string arguments;  // as an error shows them: "a b c d e f [probability]"
    bool repeats = false;   // more than once in a file
};

/// The part of a statement between two blanks (blanks in brackets belong to it).
struct RelativeWord {
    std::string text;
    std::size_t offset = 0;  // of its first byte in the line
    bool operator==(const RelativeWord& other) const { return text == other.text; }
};

/// One line of a relative's file: a key and its words. Equal if both are.
struct RelativeStatement {
    std::string key;
    std::vector<RelativeWord> words;
    Place place;                     // of the key
    std::string line;                // whole, for errors
    std::vector<std::string> above;  // comments on lines of their own
    std::string behind;              // the comment behind it
    bool operator==(const RelativeStatement& other) const {
        return key == other.key && words == other.words;
    }
};

/// The small text file of a relative, such as `fern.ifs`: lines `key value ...`, `#` comments. It is
/// what readers of the kinds read from, what options of the command line change, and what is printed.
/// `title` and `source` have one word, the rest of their line.
struct RelativeFile {
    std::string name;  // as errors call it
    std::vector<RelativeStatement> statements;
    std::vector<std::string> below;  // comments behind the last statement

    bool operator==(const RelativeFile& other) const { return statements == other.statements; }

    /// The statement of this key, which does not repeat; nullptr if there is none.
    const RelativeStatement* find(std::string_view key) const;
    /// Appends a statement.
    void add(const std::string& key, const std::vector<std::string>& words);
    /// Replaces the statement of this key, or appends it; `option` is what errors call its place.
    void set(const std::string& key, const std::vector<std::string>& words,
             const std::string& option);

    /// Throws Diagnostics with this message at a word, at a statement, or about the whole file.
    [[noreturn]] void fail(const RelativeStatement& statement, const RelativeWord& word,
                           const std::string& message) const;
    [[noreturn]] void fail(const RelativeStatement& statement, const std::string& message) const;
    [[noreturn]] void fail(const std::string& message) const;

    /// The number of words; throws unless from `least` to `most`.
    void check_words(const RelativeStatement& statement, std::size_t least, std::size_t most,
                     const std::string& arguments) const;

    /// A word as a number: any expression without names, `1/3`, `sqrt(3)/6`, `cos(60)`. Exact where
    /// `evaluate` is.
    Quantity quantity(const RelativeStatement& statement, const RelativeWord& word) const;
    /// Throws unless it is from `least` to `most`.
    double number(const RelativeStatement& statement, const RelativeWord& word, double least,
                  double most) const;
    std::uint64_t natural(const RelativeStatement& statement, const RelativeWord& word,
                          std::uint64_t least, std::uint64_t most) const;
    /// `(1,2)` as two numbers.
    Point point(const RelativeStatement& statement, const RelativeWord& word) const;

    /// The value of a statement with one word; nothing where the file has no such statement.
    std::optional<double> number(std::string_view key, double least, double most) const;
    std::optional<std::uint64_t> natural(std::string_view key, std::uint64_t least,
                                         std::uint64_t most) const;
    /// `N` or `N..M`.
    std::optional<std::pair<std::uint64_t, std::uint64_t>> range(std::string_view key,
                                                                 std::uint64_t most) const;
    std::optional<std::string> text(std::string_view key) const;
    /// The one of these words that the statement says.
    std::optional<std::string> choice(std::string_view key,
                                      const std::vector<std::string>& choices) const;

    /// Fills in name, title, source and settings (`colour`, `width`) from the file.
    void describe(Relative& relative) const;
};

/// The keys that all files of relatives know: title, source, colour, width.
const std::vector<RelativeKey>& common_relative_keys();

/// Reads the statements of a file and checks their keys. Throws `Diagnostics` with everything that is
/// wrong: unknown keys (with the known ones), keys without words, keys said twice. Title and source
/// come first in the result.
RelativeFile read_relative_file(std::string_view text, const std::string& name,
                                const std::vector<RelativeKey>& keys);

/// The text of a file with its comments, a line for each statement in their order, words one blank
/// apart. It reads back as an equal file.
///
/// Example: print_relative_file(RelativeFile{}) == ""
std::string print_relative_file(const RelativeFile& file);

}  // namespace algae
