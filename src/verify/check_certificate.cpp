#include <new>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"
#include "verify/verify.hpp"

// Which proof shows which kind of statement, and what is said of each statement of a certificate. A bound that is reached leaves
// a statement unchecked; only a flaw makes it wrong.

namespace algae::verify {

void wrong_kind(const Field& proof, const std::string& by) {
    proof.at("by").refuse("no proof by '" + by + "' shows this");
}

void check_regular(const Checking& with, const Language& language, const Field& proof) {
    if (language->kind == Tree::Kind::generated &&
        !finite_values(language, with.alphabet(), with.budget))
        proof.refuse("a system occurs in the expression whose language is not finite");
    for (const Language& part : language->parts) check_regular(with, part, proof);
}

void check_proof(const Checking& with, const Statement& statement, bool holds, const Field& proof) {
    using Kind = Statement::Kind;
    const std::string by = proof.at("by").text();
    if (by == "construction") {
        proof.only({"by", "system"});
        proof.at("system").only({"axiom", "tables", "terminals"});
        throw BoundReached(Bound::method,
                           "it rests on a system made by the constructions of a theorem");
    }
    if (by == "dimension") {
        proof.only({"by", "conditions"});
        if (statement.kind != Kind::dimension && statement.kind != Kind::boundary)
            wrong_kind(proof, by);
        throw BoundReached(Bound::method,
                           "how the parts of a limit set meet is not worked out again");
    }
    switch (statement.kind) {
        case Kind::family:
            return check_family(with, statement, holds, proof, by);
        case Kind::finite:
        case Kind::empty:
        case Kind::size:
            return check_size(with, statement, holds, proof, by);
        case Kind::equal:
        case Kind::included:
            return check_comparison(with, statement, holds, proof, by);
        case Kind::member:
            return check_membership(with, statement, holds, proof, by);
        case Kind::derives:
            return check_derivation(with, statement, holds, proof, by);
        case Kind::rewrites:
        case Kind::chance:
            return check_rewriting(with, statement, holds, proof, by);
        case Kind::equal_sequences:
            return check_sequences(with, statement, holds, proof, by);
        case Kind::equal_growth:
        case Kind::growth_formula:
        case Kind::growth_class:
            return check_growth(with, statement, holds, proof, by);
        case Kind::dimension:
        case Kind::boundary:
            break;
    }
    wrong_kind(proof, by);
}

namespace {

Finding check(const Checking& with, const Entry& entry) {
    using Outcome = Finding::Outcome;
    Finding found;
    const bool refuted = entry.verdict == Entry::Verdict::refuted;
    found.statement = statement_text(entry.statement, refuted, with.alphabet());
    found.path = entry.field.path();
    found.line = entry.field.line();
    if (entry.verdict == Entry::Verdict::undecided) return found;
    if (entry.verdict == Entry::Verdict::cited) {
        found.outcome = Outcome::cited;
        found.citation = entry.citation;
        return found;
    }
    try {
        check_proof(with, entry.statement, refuted == entry.statement.negated, *entry.proof);
        found.outcome = Outcome::checked;
    } catch (const Flaw& flaw) {
        found.outcome = Outcome::wrong;
        found.path = flaw.path;
        found.line = flaw.line;
        found.reason = flaw.reason;
    } catch (const BoundReached& bound) {
        found.outcome = Outcome::not_checked;
        found.reason = bound.what();
    } catch (const std::bad_alloc&) {
        found.outcome = Outcome::not_checked;
        found.reason = "the machine has no more memory";
    }
    return found;
}

}  // namespace

std::vector<Finding> check_certificate(const Certificate& certificate, const Budget& budget) {
    const Checking with{certificate,
                        Reader(*certificate.alphabet, certificate.systems, certificate.rewritings),
                        budget};
    std::vector<Finding> all;
    for (const Entry& entry : certificate.entries) all.push_back(check(with, entry));
    return all;
}

std::string to_string(Finding::Outcome outcome) {
    using Outcome = Finding::Outcome;
    switch (outcome) {
        case Outcome::checked:
            return "checked";
        case Outcome::cited:
            return "cited: not checked";
        case Outcome::not_checked:
            return "not checked";
        case Outcome::wrong:
            return "WRONG";
        case Outcome::undecided:
            break;
    }
    return "undecided";
}

}  // namespace algae::verify
