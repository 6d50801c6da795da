#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "exact/exact.hpp"

namespace algae::oracle {

/// What a statement of a certificate says, written as a claim; nothing where claims cannot say it.
std::optional<std::string> claim_of(const nlohmann::ordered_json& certificate,
                                    const nlohmann::ordered_json& statement);

/// Whether a statement of a certificate is true, and how that is known.
struct CertificateTruth {
    std::optional<bool> holds;
    std::string by;  // "judge" or "words"; where it does not hold, why
};

/// The statement is written as a claim and read anew. The judge of claims decides it, which shares no code with `verify`; and
/// languages are compared word by word, up to six letters, by their definition. What either of them knows is told, and where
/// one of them says no, it does not hold.
CertificateTruth truth_of(const nlohmann::ordered_json& certificate,
                          const nlohmann::ordered_json& statement, const Budget& budget);

}  // namespace algae::oracle
