#pragma once

#include "base/budget.hpp"
#include "verify/certificate.hpp"
#include "verify/reader.hpp"

namespace algae::verify {

/// What a proof is checked with.
struct Checking {
    const Certificate& certificate;
    Reader reader;
    const Budget& budget;

    const Alphabet& alphabet() const { return *certificate.alphabet; }
};

/// Checks that a proof shows a statement (`holds`) or its opposite. Returns if it does; throws Flaw if
/// it does not, Error if the proof is not as CERTIFICATES.md says, BoundReached if it cannot be
/// checked within the budget. The statement's own `negated` does not matter.
void check_proof(const Checking& with, const Statement& statement, bool holds, const Field& proof);

// The same for statements of these kinds; `by` is what the proof says of itself.
void check_family(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                  const std::string& by);
void check_size(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                const std::string& by);  // finite, empty, size
void check_comparison(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by);  // equal, included
void check_membership(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by);
void check_derivation(const Checking& with, const Statement& statement, bool holds,
                      const Field& proof, const std::string& by);
void check_rewriting(const Checking& with, const Statement& statement, bool holds,
                     const Field& proof, const std::string& by);  // rewrites, chance
void check_sequences(const Checking& with, const Statement& statement, bool holds,
                     const Field& proof, const std::string& by);
void check_growth(const Checking& with, const Statement& statement, bool holds, const Field& proof,
                  const std::string& by);  // equal growth, formula, class

/// How the lengths of a D0L system grow: "zero", "bounded", "polynomial" or "exponential", and the degree.
struct Growth {
    std::string name;
    std::size_t degree = 0;
};
Growth growth_of(const System& system);

/// Checks that a language is infinite.
void check_infinite(const Checking& with, const Language& language, const Field& proof,
                    const std::string& by);
/// Checks that two D0L systems have the same sequence, by the automaton of overflows in the proof.
void check_balance(const Checking& with, const System& left, const System& right,
                   const Field& proof);
/// Checks that two D0L systems generate the same language, by the sections of their sequences in the proof.
void check_sections(const Checking& with, const System& left, const System& right,
                    const Field& proof);
/// Throws Flaw if a system occurs in the expression whose language is not finite.
void check_regular(const Checking& with, const Language& language, const Field& proof);

/// Checks by induction on the length that a regular language is within that of a system.
void check_induction(const Checking& with, const Language& left, const Language& right,
                     const Field& proof);

/// The proof is of no kind that shows such a statement: throws Flaw.
[[noreturn]] void wrong_kind(const Field& proof, const std::string& by);

/// Checks a derivation from one word to the other: the fields `words` and `tables` of a proof.
void check_steps(const Checking& with, const System& system, const Word& from, const Word& to,
                 const Field& field);

}  // namespace algae::verify
