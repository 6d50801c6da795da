#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "language/finite_words.hpp"
#include "verify/finite_obstruction.hpp"

namespace algae {

/// Which rules of a table may still be there, and which are known to be, by letter and image number.
struct PossibleRules {
    std::vector<std::vector<char>> possible;
    std::vector<std::vector<char>> there;
};

/// By word: the words it gives in one step.
using StepRelation = std::vector<std::vector<char>>;

/// The search for rules under which a finite language is closed, and, if wanted, from one word of
/// which all others come. Sets of rules are narrowed from above: a rule goes when no closed table
/// has it, and where a derivation that leaves the language uses several rules, one of them must go.
/// Leaving rules out keeps a language closed and makes fewer words reachable, so a set of possible
/// rules from which the language cannot be reached needs no more cases. What is ruled out is written
/// down as an ObstructionCase.
class RuleSearch {
public:
    /// `cases` bounds the number of cases; throws BoundReached beyond it. All arguments must
    /// outlive the search.
    RuleSearch(const FiniteLanguage& language, const FiniteWords& words, Family family,
               bool empty_axiom, std::uint64_t cases, const Budget& budget);

    /// All factors as images of all letters, but the empty word in a propagating family.
    PossibleRules all_rules() const;

    /// Whether some of the rules, with all that are `there`, keep the language closed and, with
    /// `generating`, generate it. Then `rules` becomes such a set; otherwise `why` says why not.
    bool narrow_to_solution(PossibleRules& rules, bool generating, ObstructionCase& why);

    /// The steps between words of the language by these rules; in a deterministic family each letter
    /// has one image throughout a step.
    StepRelation steps(const PossibleRules& rules);

    /// The disjoint sets of words, none reached from outside it, that show that no axiom gives all
    /// words; nothing if some axiom does. Smaller sets first.
    std::optional<std::vector<std::vector<std::uint32_t>>> unreached(
        const StepRelation& steps) const;
    /// The smallest sets of words that give each other and that nothing else gives.
    static std::vector<std::vector<std::uint32_t>> sources(const StepRelation& steps);
    /// Those of these sets, none reached from outside it, that rule every axiom out; or nothing.
    std::optional<std::vector<std::vector<std::uint32_t>>> ruling_out(
        const std::vector<std::vector<std::uint32_t>>& closed_sets) const;

    /// Takes out rules that are in no closed table, until neither one word nor rules known to be
    /// there show any more. False if none can be closed; then `why` has an end.
    bool narrow(PossibleRules& rules, ObstructionCase& why);

    LetterRule rule(std::uint32_t letter, FiniteWords::Image image) const;
    std::vector<std::vector<Word>> spelled(
        const std::vector<std::vector<std::uint32_t>>& sets) const;
    const FiniteWords& words() const { return words_; }
    bool is_deterministic() const { return family_.deterministic; }

private:
    struct Pair {
        std::uint32_t letter;
        FiniteWords::Image image;
        auto operator<=>(const Pair&) const = default;
    };
    /// A derivation step out of the language.
    struct Departure {
        std::uint32_t word = 0;
        std::vector<FiniteWords::Image> images;
        std::vector<Pair> open;  // the rules it uses that are not known to be there
    };

    bool narrow_by_words(PossibleRules& rules, ObstructionCase& why);
    bool lands(std::uint32_t word, std::size_t position, FiniteWords::Node node,
               const PossibleRules& rules);
    bool exclude(PossibleRules& rules, ObstructionCase& why, Pair pair, ExcludedRule reason);
    std::optional<Departure> departure(const PossibleRules& rules);
    void depart(std::uint32_t word, const PossibleRules& rules,
                const std::vector<std::vector<FiniteWords::Image>>& images,
                std::optional<Departure>& best);
    bool split_by_departure(PossibleRules& rules, bool generating, ObstructionCase& why);
    bool split_by_choice(PossibleRules& rules, bool generating, ObstructionCase& why);
    void land_everywhere(std::uint32_t word, std::size_t position, FiniteWords::Node node,
                         const PossibleRules& rules, std::vector<char>& ends);
    std::vector<std::vector<FiniteWords::Image>> listed(const PossibleRules& rules) const;
    std::vector<Word> spelled_images(const std::vector<FiniteWords::Image>& images) const;
    FiniteWords::Node after(FiniteWords::Node node, FiniteWords::Image image) const;
    void tick();

    const FiniteLanguage& language_;
    const FiniteWords& words_;
    Family family_;
    bool empty_axiom_;
    std::uint64_t cases_;
    const Budget& budget_;
    std::uint64_t ticks_ = 0;
    std::vector<FiniteWords::Image> chosen_;   // by letter, while a word is followed
    std::optional<Departure> open_departure_;  // found by narrow, left for the split
};

}  // namespace algae
