#include "language/detail/judge.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "exact/exact.hpp"

// From a claim to its verdicts and its certificate: each statement goes to its judge, a bound that is reached
// leaves it undecided, and an error gets the place of the statement. Also the table of closure that claims
// settle together.

namespace algae {

namespace {

Judgement judged(Truth truth, std::vector<std::string> argument,
                 const nlohmann::ordered_json& proof) {
    return {truth, std::move(argument), std::make_shared<const nlohmann::ordered_json>(proof)};
}

}  // namespace

Judgement Judgement::proved(std::vector<std::string> argument,
                            const nlohmann::ordered_json& proof) {
    return judged(Truth::proved, std::move(argument), proof);
}

Judgement Judgement::refuted(std::vector<std::string> argument,
                             const nlohmann::ordered_json& proof) {
    return judged(Truth::refuted, std::move(argument), proof);
}

Judgement Judgement::undecided(std::vector<std::string> tried) {
    return {Truth::undecided, std::move(tried), nullptr};
}

Judgement opposite(Judgement judgement) {
    judgement.truth = opposite(judgement.truth);
    return judgement;
}

namespace {

/// What a statement says, each form to its judge.
struct Judge {
    const Claim& claim;
    const Budget& budget;
    const Alphabet& alphabet = *claim.alphabet;

    Judgement operator()(const InFamily& said) const {
        return judge_family(said.language, {said.family, claim.empty_axiom, claim.systems},
                            alphabet, budget);
    }
    Judgement operator()(const IsFinite& said) const {
        return judge_finite(said.language, alphabet, budget);
    }
    Judgement operator()(const IsEmpty& said) const {
        return judge_empty(said.language, alphabet, budget);
    }
    Judgement operator()(const EqualLanguages& said) const {
        return judge_equality(said.left, said.right, alphabet, budget);
    }
    Judgement operator()(const IncludedIn& said) const {
        return judge_inclusion(said.inner, said.outer, alphabet, budget);
    }
    Judgement operator()(const HasWord& said) const {
        return judge_membership(said.language, said.word, alphabet, budget);
    }
    Judgement operator()(const HasSize& said) const {
        return judge_size(said.language, said.size, alphabet, budget);
    }
    Judgement operator()(const Derives& said) const {
        return judge_derivation(said, alphabet, budget);
    }
    Judgement operator()(const EqualSequences& said) const {
        return judge_sequences(*said.left, *said.right, alphabet, budget);
    }
    Judgement operator()(const EqualGrowth& said) const {
        return judge_growth(*said.left, *said.right, budget);
    }
    Judgement operator()(const HasGrowthFormula& said) const {
        return judge_growth_formula(*said.system, said.formula, budget);
    }
    Judgement operator()(const HasGrowthClass& said) const {
        return judge_growth_class(said, budget);
    }
    Judgement operator()(const Rewrites& said) const { return judge_rewriting(said, budget); }
    Judgement operator()(const HasChance& said) const { return judge_chance(said, budget); }
    Judgement operator()(const HasDimension& said) const {
        return judge_dimension(*said.system, said.dimension, budget);
    }
    Judgement operator()(const BoundaryHasDimension& said) const {
        return judge_boundary(*said.system, said.dimension, budget);
    }
};

}  // namespace

//> decide
Judgement decide(const Statement& statement, const Claim& claim, const Budget& budget) {
    try {
        Judgement found = std::visit(Judge{claim, budget}, statement.says);
        return statement.negated ? opposite(std::move(found)) : found;
    } catch (const BoundReached& error) {
        return Judgement::undecided({error.what()});
    } catch (const Error& error) {
        const std::string what = error.what(), file = statement.place.file;
        if (statement.place.line == 0 || (!file.empty() && what.starts_with(file + ":"))) throw;
        throw Error(to_string(statement.place) + ": " + what);
    }
}
//< decide

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
        if (const auto* said = std::get_if<Derives>(&claimed.statement.says);
            said && said->from && said->system->name == system.name)
            letters.insert(letters.end(), said->from->begin(), said->from->end());
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
    static const char* const names[] = {"proved", "cited", "undecided", "WRONG"};
    return names[static_cast<std::size_t>(outcome)];
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
