#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "verify/finite_obstruction.hpp"

namespace algae {

/// The rules still possible at some point of a proof, for its sentences.
using RulesLeft = std::map<Symbol, std::set<Word>>;

/// The single sentences of a proof that a finite language is not of a family.
class FiniteSentences {
public:
    explicit FiniteSentences(const FiniteLanguage& language) : language_(language) {}

    std::string word(const Word& word) const { return spell(*language_.alphabet, word); }
    std::string rule(const LetterRule& rule) const;
    /// "a -> a and b -> ε | b".
    std::string rules(const std::vector<LetterRule>& rules) const;
    std::string left(const RulesLeft& rules) const;
    /// Why rules of one letter are impossible, by one word whatever the rules left for other letters,
    /// or by one step with rules that are there.
    std::string impossible(std::span<const ExcludedRule> same, const RulesLeft& left) const;
    /// "by a -> aa and b -> b, ab gives aab, which is not in the language".
    std::string departure(const Word& from, const std::vector<Word>& images) const;
    /// Why the words of these sets are not all reached.
    std::string never_reached(const std::vector<std::vector<Word>>& sets) const;

    /// "x, y and z".
    static std::string listed(const std::vector<std::string>& items,
                              const std::string& last = " and ");

private:
    std::string form(const ExcludedRule& excluded) const;
    bool has_form(const ExcludedRule& excluded) const;

    const FiniteLanguage& language_;
};

}  // namespace algae
