#pragma once

#include <nlohmann/json_fwd.hpp>

#include "language/equivalence_language.hpp"
#include "language/sequence_equality.hpp"

namespace algae {

// Proofs that sequences and languages are equal, or not, as a certificate writes them (CERTIFICATES.md).

/// Equal sequences: by `balance`. The alphabet is that of both systems.
nlohmann::ordered_json balance_certificate(const Balance& balance, const Alphabet& alphabet);

/// Sequences that differ: by `generation`, with the position of the first difference.
nlohmann::ordered_json difference_certificate(const SequenceDifference& difference);

/// Equal languages: by `values` if they are finite, otherwise by `sections`. The alphabet is that of both
/// systems; the languages must be equal.
nlohmann::ordered_json language_certificate(const LanguageEquality& equality,
                                            const Alphabet& alphabet);

}  // namespace algae
