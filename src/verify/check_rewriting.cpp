#include "base/error.hpp"
#include "verify/proofs.hpp"

namespace algae::verify {

void check_rewriting(const Checking& with, const Statement& statement, bool holds,
                     const Field& proof, const std::string& by) {
    if (by == "environment") {
        proof.only({"by"});
        throw BoundReached(Bound::method, "what environments answer is not worked out again");
    }
    if (by != "rewriting") wrong_kind(proof, by);
    proof.only({"by"});
    const ModuleSystem& system = *statement.rewriting;
    const Rational found = chance(system, statement.modules_from.value_or(system.axiom),
                                  statement.modules, *statement.steps, proof, with.budget);
    const bool is_so = statement.kind == Statement::Kind::chance ? found == *statement.probability
                                                                 : !found.is_zero();
    if (is_so != holds) proof.refuse("the word has the probability " + to_string(found));
}

}  // namespace algae::verify
