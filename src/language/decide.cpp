#include <algorithm>

#include "exact/exact.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"

// From a claim to its verdicts: each statement goes to its judge, a bound that is reached
// leaves it undecided, and an error gets the place of the statement.

namespace algae {

Answer opposite(Answer answer) {
    answer.truth = opposite(answer.truth);
    return answer;
}

namespace {

/// What a statement says, each form to its judge.
struct Judge {
    const Claim& claim;
    const Budget& budget;
    const SearchLimits& limits;
    const Alphabet& alphabet = *claim.alphabet;

    Answer operator()(const InFamily& said) const {
        return judge_family(said.language, {said.family, claim.empty_axiom, claim.systems},
                            alphabet, budget);
    }
    Answer operator()(const IsFinite& said) const {
        return judge_finite(said.language, alphabet, budget);
    }
    Answer operator()(const IsEmpty& said) const {
        return judge_empty(said.language, alphabet, budget);
    }
    Answer operator()(const EqualLanguages& said) const {
        return judge_equality(said.left, said.right, alphabet, budget);
    }
    Answer operator()(const IncludedIn& said) const {
        return judge_inclusion(said.inner, said.outer, alphabet, budget);
    }
    Answer operator()(const HasWord& said) const {
        return judge_membership(said.language, said.word, alphabet, budget);
    }
    Answer operator()(const HasSize& said) const {
        return judge_size(said.language, said.size, alphabet, budget);
    }
    Answer operator()(const IsCode& said) const {
        return judge_code(said.language, said.prefix, alphabet, budget);
    }
    Answer operator()(const IsPalindrome& said) const { return judge_palindrome(said.word); }
    Answer operator()(const Derives& said) const {
        return judge_derivation(said, alphabet, budget);
    }
    Answer operator()(const EqualSequences& said) const {
        return judge_sequences(*said.left, *said.right, budget);
    }
    Answer operator()(const EqualGrowth& said) const {
        return judge_growth(*said.left, *said.right, budget);
    }
    Answer operator()(const HasGrowthClass& said) const { return judge_growth_class(said, budget); }
    Answer operator()(const IsIncreasing& said) const { return judge_increasing(said, budget); }
    Answer operator()(const ComparesNumbers& said) const { return judge_numbers(said, budget); }
    Answer operator()(const ComparesWords& said) const {
        return judge_words(said, alphabet, budget);
    }
    Answer operator()(const Rewrites& said) const { return judge_rewriting(said, budget); }
    Answer operator()(const HasChance& said) const { return judge_chance(said, budget); }
    Answer operator()(const HasDimension& said) const { return judge_dimension(said, budget); }
    Answer operator()(const BoundaryHasDimension& said) const {
        return judge_boundary(said, budget);
    }
    Answer operator()(const Joint& said) const { return judge_joint(said, claim, budget, limits); }
    Answer operator()(const Quantified& said) const {
        return judge_quantified(said, claim, budget, limits);
    }
};

}  // namespace

//> decide
Answer decide(const Statement& statement, const Claim& claim, const Budget& budget,
              const SearchLimits& limits) {
    try {
        Answer found = std::visit(Judge{claim, budget, limits}, statement.says);
        return statement.negated ? opposite(std::move(found)) : found;
    } catch (const BoundReached& error) {
        return undecided(error.what());
    } catch (const Error& error) {
        const std::string what = error.what(), file = statement.place.file;
        if (statement.place.line == 0 || (!file.empty() && what.starts_with(file + ":"))) throw;
        throw Error(to_string(statement.place) + ": " + what);
    }
}
//< decide

Answer decide_part(const Statement& statement, const Claim& claim, const Budget& budget,
                   const SearchLimits& limits) {
    try {
        Answer found = std::visit(Judge{claim, budget, limits}, statement.says);
        if (found.out_of_time) throw BoundReached(Bound::time, found.tried.at(0));
        return statement.negated ? opposite(std::move(found)) : found;
    } catch (const BoundReached& error) {
        if (error.bound() == Bound::time) throw;
        return undecided(error.what());
    }
}

namespace {

using Outcome = CheckedStatement::Outcome;
using Purpose = ClaimedStatement::Purpose;

Outcome outcome(const ClaimedStatement& claimed, Truth truth) {
    if (truth == Truth::undecided)
        return claimed.citation.empty() ? Outcome::undecided : Outcome::cited;
    const Truth expected = claimed.purpose == Purpose::refute ? Truth::refuted : Truth::proved;
    return truth == expected ? Outcome::holds : Outcome::fails;
}

}  // namespace

bool CheckedStatement::is_vacuous() const {
    return answer.searched && answer.searched->instances == 0 && answer.searched->undecided == 0 &&
           !answer.searched->witness && !answer.searched->finite_only;
}

std::optional<std::size_t> CheckedClaim::theorem() const {
    for (std::size_t i = 0; i < statements.size(); ++i)
        if (claim.statements[i].purpose == Purpose::theorem) return i;
    return std::nullopt;
}

std::pair<std::size_t, std::size_t> CheckedClaim::examples() const {
    std::pair<std::size_t, std::size_t> found;
    for (std::size_t i = 0; i < statements.size(); ++i) {
        if (claim.statements[i].purpose == Purpose::theorem) continue;
        ++found.second;
        if (statements[i].outcome == Outcome::holds) ++found.first;
    }
    return found;
}

CheckedStatement::Outcome CheckedClaim::worst() const {
    Outcome worst = Outcome::holds;
    for (const CheckedStatement& statement : statements) worst = std::max(worst, statement.outcome);
    return worst;
}

ClaimVerdict CheckedClaim::verdict() const {
    if (worst() == Outcome::fails) return ClaimVerdict::refuted;
    const std::optional<std::size_t> which = theorem();
    const Outcome decisive = which ? statements[*which].outcome : worst();
    if (decisive == Outcome::cited) return ClaimVerdict::cited;
    if (which && statements[*which].is_vacuous()) return ClaimVerdict::vacuous;
    if (decisive == Outcome::undecided) return ClaimVerdict::undecided;
    return which ? ClaimVerdict::proved : ClaimVerdict::examples;
}

CheckedClaim check(Claim claim, const Budget& budget, const SearchLimits& limits) {
    CheckedClaim checked;
    for (const ClaimedStatement& claimed : claim.statements) {
        CheckedStatement found;
        try {
            found.answer = decide(claimed.statement, claim, budget, limits);
        } catch (const Error& error) {  // the other statements are decided all the same
            found.answer = undecided(error.what());
        }
        found.outcome = outcome(claimed, found.answer.truth);
        checked.statements.push_back(std::move(found));
    }
    checked.claim = std::move(claim);
    return checked;
}

std::string_view to_string(ClaimVerdict verdict) {
    static constexpr std::string_view names[] = {"proved",  "examples",  "cited",
                                                 "vacuous", "undecided", "refuted"};
    return names[static_cast<std::size_t>(verdict)];
}

std::string verdict_text(const CheckedStatement& checked) {
    if (checked.outcome == Outcome::cited) return "cited";
    if (checked.is_vacuous()) return "vacuous";
    return std::string(to_string(checked.answer.truth));
}

}  // namespace algae
