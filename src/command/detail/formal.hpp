#pragma once

#include <set>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "language/language.hpp"

namespace algae::command {

class Verb;

/// The compiled proofs in Coq of theory/formal, as tools/formal left them in a folder.
class FormalProofs {
public:
    /// No proofs: every theorem is cited.
    FormalProofs() = default;

    /// Those in a folder; none where the name is empty. Throws Error unless the folder has the sources that this algae carries,
    /// and what Coq compiled of these very sources.
    FormalProofs(const std::string& folder, const Budget& budget);

    /// Whether what the fact says is proved: the fact names its theorem, which `read_claim` compares with the table of
    /// theory/formal, and Coq found that the theorem rests on no axiom.
    bool prove(const ClosureFact& fact) const;

    /// "cited" or "proved formally".
    std::string verdict(const ClosureFact& fact) const;

    /// By what, as "Coq 8.16.1 and coqchk".
    const std::string& checkers() const { return checkers_; }

    /// Lets the theorem of a claim rest on its proof, where it is cited and the proof is here.
    void settle(CheckedClaim& checked) const;

private:
    std::set<std::string> theorems_;
    std::string checkers_;
};

/// `--formal FOLDER`
void add_formal_option(Verb& verb, std::string& folder);

/// What Spec.v says of a family, an operation and closure, in words: the statement, and what the family is.
std::vector<std::string> formal_words(const std::string& family, const std::string& operation,
                                      bool closed);

}  // namespace algae::command
