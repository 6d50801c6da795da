#pragma once
// What is true of the language of a small system over the letters a and b (and S, which is not a terminal): by strings, tables of
// truth values and exhausted sets, with nothing of the library. Where no proof is at hand, nothing is said.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace algae::oracle {

/// A system on paper. Its rules for a letter in a table are never missing.
struct SmallSystem {
    struct InContext {
        std::string left;
        char letter = 'a';
        std::string right;
        std::vector<std::string> successors;
        bool operator==(const InContext&) const = default;
    };
    std::string family, axiom;  // 0L, EPDT0L, PDIL, ...; the axiom is not empty
    std::vector<std::map<char, std::vector<std::string>>> tables;
    std::vector<InContext> in_context;
    bool operator==(const SmallSystem&) const = default;

    /// Whether the name of the family has the letter: E, P, D or T.
    bool is(char letter) const { return family.find(letter) != std::string::npos; }
    bool has_context() const { return !is('0'); }
    /// Of the letter at place i: by the rule that matches with the most letters in its contexts, the first of several.
    const std::vector<std::string>& successors(std::size_t table, const std::string& word,
                                               std::size_t i) const;
    bool erases() const;
    /// As claims write it.
    std::string text() const;
};

/// What a word does to the states of two automata with at most eight states each: bit 8 i + j is set where it leads from state i
/// to state j.
using Relation = std::array<std::uint64_t, 2>;
Relation identity();
Relation followed_by(const Relation& first, const Relation& second);
/// Read backwards.
Relation transposed(const Relation& relation);

/// A regular expression over a and b with at most seven letters, and its automaton of positions (Glushkov): state 0 is the start.
struct SmallExpression {
    std::string text;  // as claims write it, without the slashes
    std::map<char, std::uint64_t> steps;
    std::uint64_t final = 0;  // a bit for each state

    /// Whether a word that does this to the states is accepted.
    bool accepts(std::uint64_t relation) const { return (relation & 255 & final) != 0; }
    bool accepts(const std::string& word) const;
};
/// Of `written`, with | * + ? ( ) and ε.
SmallExpression small_expression(const std::string& written);

/// The relations of the words of a language: all of `some` are, and all that are, are in `all`.
struct Relations {
    std::set<Relation> some, all;
};

class SmallLanguage {
public:
    explicit SmallLanguage(SmallSystem system);

    const SmallSystem& system() const { return system_; }
    /// Whether it has the word.
    std::optional<bool> has(const std::string& word) const;
    /// Of words by what a and b do to states.
    Relations relations(const std::map<char, Relation>& letters) const;
    /// All words, where they are finitely many and could be written out.
    std::optional<std::set<std::string>> all_words() const;
    /// Whether it is finite: all words, or all lengths, were exhausted; or some part of a word repeats itself and leaves something
    /// behind for ever; or every word that a closed set of factors allows has a longer successor.
    std::optional<bool> finite() const;
    /// Words that it has.
    const std::set<std::string>& words() const { return words_; }
    /// The words of the first generations of a system with one of each.
    std::vector<std::string> sequence(std::size_t generations) const;

private:
    using Lengths = std::vector<int>;  // by letter; -1: there is none
    /// Factors of five places that words may have, by number in base 3, and whether the empty word is one of them.
    struct Factors {
        std::vector<bool> seen = std::vector<bool>(243);
        bool empty_word = false;
    };

    void write_out();
    void exhaust_short();
    bool exhaust_lengths(std::vector<Lengths>& all) const;
    bool repeats(const std::string& letters, const std::set<char>& accessible) const;
    bool always_grows() const;
    Factors factors(const std::string& from, bool longest_only) const;
    const Factors& all_factors() const;
    std::set<Relation> context_free_relations(const std::map<char, Relation>& letters,
                                              bool& complete) const;

    SmallSystem system_;
    std::string letters_;
    std::set<std::string> words_;  // of terminals
    bool whole_ = false;           // there are no others
    std::size_t complete_ = 0;     // nor are there others that are shorter than this
    std::set<char> accessible_;    // letters of the words that were written out
    mutable std::optional<Factors> factors_;
    mutable std::optional<std::optional<bool>> finite_;
};

}  // namespace algae::oracle
