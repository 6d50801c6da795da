#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "claim/claim.hpp"
#include "claim/judgement.hpp"

namespace algae {

/// What came of one statement of a claim. It stands if it is as the claim says: proved, or refuted where the claim
/// says `refute`. Cited is one that is undecided here and rests on a source that the claim names.
struct CheckedStatement {
    enum class Outcome { stands, cited, undecided, wrong };
    Outcome outcome = Outcome::undecided;
    Judgement judgement;
};

/// What came of a claim: one entry for each of its statements.
struct CheckedClaim {
    Claim claim;
    std::vector<CheckedStatement> statements;

    /// The worst of its statements, of `wrong`, `undecided`, `cited`, `stands`.
    CheckedStatement::Outcome outcome() const;
};

/// Decides all statements of a claim. Throws what `decide` throws.
CheckedClaim check(Claim claim, const Budget& budget = {});

/// "proved", "cited", "undecided" or "WRONG", as reports print it.
std::string to_string(CheckedStatement::Outcome outcome);

/// "proved", "refuted", "cited", "undecided" or "WRONG", as reports print it.
std::string verdict_text(const ClaimedStatement& statement, const CheckedStatement& checked);

/// The claim as a page: its title and source, the definitions, its notes, then each statement with its verdict and the
/// argument in sentences, in lines of at most 100 characters. With a family, what is said of a language and other
/// families is left out where the same is said of this one.
std::string explanation(const CheckedClaim& checked, const std::string& family = {});

/// The claim as a certificate (CERTIFICATES.md).
nlohmann::ordered_json certificate(const CheckedClaim& checked);

}  // namespace algae
