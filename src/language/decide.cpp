#include <algorithm>
#include <map>

#include "exact/exact.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"

// From a claim to its verdicts: each statement goes to its judge, a bound that is reached
// leaves it undecided, and an error gets the place of the statement. Also the table of closure that claims
// settle together.

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
    Answer operator()(const Derives& said) const {
        return judge_derivation(said, alphabet, budget);
    }
    Answer operator()(const EqualSequences& said) const {
        return judge_sequences(*said.left, *said.right, budget);
    }
    Answer operator()(const EqualGrowth& said) const {
        return judge_growth(*said.left, *said.right, budget);
    }
    Answer operator()(const HasGrowthFormula& said) const {
        return judge_growth_formula(*said.system, said.formula, budget);
    }
    Answer operator()(const HasGrowthClass& said) const { return judge_growth_class(said, budget); }
    Answer operator()(const Rewrites& said) const { return judge_rewriting(said, budget); }
    Answer operator()(const HasChance& said) const { return judge_chance(said, budget); }
    Answer operator()(const HasDimension& said) const { return judge_dimension(said, budget); }
    Answer operator()(const BoundaryHasDimension& said) const {
        return judge_boundary(said, budget);
    }
};

}  // namespace

//> decide
Answer decide(const Statement& statement, const Claim& claim, const Budget& budget) {
    try {
        Answer found = std::visit(Judge{claim, budget}, statement.says);
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

namespace {

using Outcome = CheckedStatement::Outcome;

Outcome outcome(const ClaimedStatement& claimed, Truth truth) {
    if (truth == Truth::undecided)
        return claimed.citation.empty() ? Outcome::undecided : Outcome::cited;
    const Truth expected =
        claimed.purpose == ClaimedStatement::Purpose::refute ? Truth::refuted : Truth::proved;
    return truth == expected ? Outcome::stands : Outcome::wrong;
}

}  // namespace

CheckedStatement::Outcome CheckedClaim::outcome() const {
    Outcome worst = Outcome::stands;
    for (const CheckedStatement& statement : statements) worst = std::max(worst, statement.outcome);
    return worst;
}

CheckedClaim check(Claim claim, const Budget& budget) {
    CheckedClaim checked;
    for (const ClaimedStatement& claimed : claim.statements) {
        CheckedStatement found;
        found.answer = decide(claimed.statement, claim, budget);
        found.outcome = outcome(claimed, found.answer.truth);
        checked.statements.push_back(std::move(found));
    }
    checked.claim = std::move(claim);
    return checked;
}

std::string to_string(CheckedStatement::Outcome outcome) {
    static const char* const names[] = {"proved", "cited", "undecided", "WRONG"};
    return names[static_cast<std::size_t>(outcome)];
}

std::string verdict_text(const ClaimedStatement& statement, const CheckedStatement& checked) {
    const bool refuted = statement.purpose == ClaimedStatement::Purpose::refute;
    return checked.outcome == Outcome::stands && refuted ? "refuted" : to_string(checked.outcome);
}

const std::vector<std::string>& closure_operations() {
    static const std::vector<std::string> all{"union",
                                              "concatenation",
                                              "star",
                                              "plus",
                                              "intersection",
                                              "intersection with regular",
                                              "complement",
                                              "homomorphism",
                                              "non-erasing homomorphism",
                                              "inverse homomorphism",
                                              "reversal",
                                              "finite substitution",
                                              "substitution",
                                              "gsm mapping"};
    return all;
}

const std::vector<std::string>& closure_families() {
    static const std::vector<std::string> all{"REG", "CF",   "D0L",   "PD0L", "0L",
                                              "P0L", "DT0L", "PDT0L", "T0L",  "PT0L",
                                              "E0L", "ET0L", "EDT0L", "IL"};
    return all;
}

ClosureTable::ClosureTable(const std::vector<Claim>& claims) {
    std::map<std::pair<std::string, std::string>, Place> places;
    for (std::size_t i = 0; i < claims.size(); ++i)
        for (const ClosureFact& fact : claims[i].closure)
            for (const std::string& family : fact.families) {
                const auto key = std::pair(family, fact.operation);
                const auto [place, is_new] = places.emplace(key, fact.place);
                if (!is_new)
                    throw Error(to_string(fact.place) + ": whether " + family +
                                " is closed under " + fact.operation + " is settled at " +
                                to_string(place->second) + " already");
                cells_.emplace(key, Cell{fact.closed, i});
            }
}

std::optional<ClosureTable::Cell> ClosureTable::cell(std::string_view family,
                                                     std::string_view operation) const {
    const auto found = cells_.find(std::pair(std::string(family), std::string(operation)));
    return found == cells_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace algae
