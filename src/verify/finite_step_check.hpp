#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "verify/finite_obstruction.hpp"

namespace algae {

/// What is wrong with a proof.
struct ProofFlaw {
    std::string text;
};

/// What single derivation steps do to the words of a finite language, for the checking of a proof:
/// letter by letter on words, nothing shared with the search.
class StepCheck {
public:
    using Possible = std::map<Symbol, std::set<Word>>;
    using Rules = std::set<LetterRule>;

    /// Both must outlive this. Throws BoundReached where the factors of the words would take too much.
    StepCheck(const FamilyObstruction& proof, const Budget& budget);

    const std::set<Word>& words() const { return words_; }
    std::string spelled(const Word& word) const;
    std::string spelled(const LetterRule& rule) const;

    /// The factors of words, the first possible images of every letter.
    Possible factors() const;
    /// Throws ProofFlaw if this is not a word of the language.
    void must_be_word(const Word& word) const;
    /// The rules of a step that must leave the language. Only without determinism may every
    /// occurrence of a letter take any of its rules. Throws ProofFlaw if the step does not leave it.
    Rules leaving(const Word& word, const std::vector<Word>& images) const;
    /// Whether some choice of one possible image for each letter, this rule among them, sends the
    /// word into the language.
    bool lands(const Word& word, const LetterRule& rule, const Possible& possible) const;
    /// Throws ProofFlaw if possible rules that no impossible table contains take one word to the other.
    void must_not_give(const Word& from, const Word& to, const Possible& possible) const;

private:
    using Places = std::set<std::pair<std::size_t, std::size_t>>;

    bool lands_after(const Word& word, std::size_t position, const Word& built,
                     const Possible& possible, std::map<Symbol, Word>& chosen) const;
    void follow(const Word& from, std::size_t position, const Word& to, std::size_t done,
                const Possible& possible, Rules& used, Places& seen) const;

    const FamilyObstruction& proof_;
    const Budget& budget_;
    std::set<Word> words_;
    std::set<Word> beginnings_;
};

}  // namespace algae
