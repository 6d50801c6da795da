#include "verify/proofs.hpp"

#include "verify/values.hpp"

#include "base/error.hpp"

namespace algae::verify {

void wrong_kind(const Field& proof, const std::string& by) {
    proof.at("by").refuse("no proof by '" + by + "' shows this");
}

void check_regular(const Checking& with, const Language& language, const Field& proof) {
    if (language->kind == Tree::Kind::generated && !finite_values(language, with.alphabet(), with.budget))
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

}  // namespace algae::verify
