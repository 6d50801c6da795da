#pragma once
// Statements decided, written as a certificate, and checked again by the room verify.

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

#include "language/language.hpp"
#include "random_languages.hpp"
#include "verify/verify.hpp"

namespace algae::random {

/// A claim of one statement about these systems.
inline Claim claim_of(Statement statement,
                      std::vector<std::shared_ptr<const SourceSystem>> systems) {
    Claim claim;
    claim.title = "random";
    claim.alphabet = letters();
    claim.systems = std::move(systems);
    claim.statements.push_back({std::move(statement), ClaimedStatement::Purpose::show, ""});
    return claim;
}

/// What came of a statement, and what verify says of its certificate.
struct Certified {
    Judgement judgement;
    nlohmann::ordered_json proof;  // null where there is none
    verify::Finding finding;
    std::string text;  // of the certificate

    bool is_sound() const {
        using Outcome = verify::Finding::Outcome;
        if (judgement.truth == Truth::undecided) return finding.outcome == Outcome::undecided;
        return finding.outcome == Outcome::checked || finding.outcome == Outcome::not_checked;
    }
    bool is_checked() const { return finding.outcome == verify::Finding::Outcome::checked; }
    std::string rule() const { return proof.is_null() ? "" : proof.at("by").get<std::string>(); }
};

/// Deciding and verifying take a second each at most; what takes longer is undecided or not checked.
inline Certified certified(const Claim& claim) {
    const auto bounded = [] {
        Budget budget;
        budget.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(1);
        return budget;
    };
    const CheckedClaim checked = check(claim, bounded());
    const Answer& answer = checked.statements.front().answer;
    const Alphabet& alphabet = *checked.claim.alphabet;
    Certified found{in_sentences(answer, alphabet),
                    certificate(answer, alphabet),
                    {},
                    certificate(checked).dump(1)};
    found.finding = verify::check_certificate(found.text, "certificate", bounded()).front();
    return found;
}

/// The same, and a failure of the property where verify finds a proof wrong.
inline Certified sound(const Claim& claim) {
    Certified found = certified(claim);
    if (!found.is_sound())
        RC_FAIL(verify::to_string(found.finding.outcome) + ": " + found.finding.path + ": " +
                found.finding.reason + "\n" + found.text);
    return found;
}

}  // namespace algae::random
