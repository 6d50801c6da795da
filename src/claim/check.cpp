#include "claim/check.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "claim/certificate.hpp"
#include "claim/decide.hpp"
#include "claim/rewriting_json.hpp"

namespace algae {

namespace {

using Outcome = CheckedStatement::Outcome;
using Json = nlohmann::ordered_json;

Outcome outcome(const ClaimedStatement& claimed, Truth truth) {
    if (truth == Truth::undecided)
        return claimed.citation.empty() ? Outcome::undecided : Outcome::cited;
    const Truth expected =
        claimed.purpose == ClaimedStatement::Purpose::refute ? Truth::refuted : Truth::proved;
    return truth == expected ? Outcome::stands : Outcome::wrong;
}

Json statement_json(const ClaimedStatement& claimed, const CheckedStatement& checked,
                    const Alphabet& alphabet) {
    Json result{{"text", claimed.statement.text},
                {"statement", to_json(claimed.statement, alphabet)}};
    if (checked.outcome == Outcome::cited) {
        result["verdict"] = "cited";
        result["citation"] = claimed.citation;
        return result;
    }
    result["verdict"] = to_string(checked.judgement.truth);
    if (checked.judgement.proof) result["proof"] = *checked.judgement.proof;
    return result;
}

/// The words that statements let the system begin from.
Word begun_from(const Claim& claim, const SourceSystem& system) {
    Word letters;
    for (const ClaimedStatement& claimed : claim.statements)
        if (claimed.statement.from && claimed.statement.systems.front()->name == system.name)
            letters.insert(letters.end(), claimed.statement.from->begin(),
                           claimed.statement.from->end());
    return letters;
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
        found.judgement = decide(claimed.statement, claim, budget);
        found.outcome = outcome(claimed, found.judgement.truth);
        checked.statements.push_back(std::move(found));
    }
    checked.claim = std::move(claim);
    return checked;
}

std::string to_string(CheckedStatement::Outcome outcome) {
    switch (outcome) {
        case Outcome::stands:
            return "proved";
        case Outcome::cited:
            return "cited";
        case Outcome::undecided:
            return "undecided";
        case Outcome::wrong:
            return "WRONG";
    }
    return {};
}

std::string verdict_text(const ClaimedStatement& statement, const CheckedStatement& checked) {
    const bool refuted = statement.purpose == ClaimedStatement::Purpose::refute;
    return checked.outcome == Outcome::stands && refuted ? "refuted" : to_string(checked.outcome);
}

nlohmann::ordered_json certificate(const CheckedClaim& checked) {
    const Claim& claim = checked.claim;
    Json letters = Json::array(), systems = Json::object(), statements = Json::array();
    for (Symbol a = 0; a < claim.alphabet->size(); ++a) letters.push_back(claim.alphabet->name(a));
    for (const auto& system : claim.systems)
        systems[system->name] = to_json(*system, *claim.alphabet, begun_from(claim, *system));
    for (const auto& system : claim.rewritings) systems[system->name] = to_json(*system);
    for (std::size_t i = 0; i < checked.statements.size(); ++i)
        statements.push_back(
            statement_json(claim.statements[i], checked.statements[i], *claim.alphabet));
    Json result{
        {"format", "algae certificate 1"}, {"claim", claim.title}, {"source", claim.source}};
    if (claim.empty_axiom) result["empty axiom"] = true;
    result["alphabet"] = std::move(letters);
    result["systems"] = std::move(systems);
    result["statements"] = std::move(statements);
    return result;
}

}  // namespace algae
