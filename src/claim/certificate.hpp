#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "claim/claim.hpp"
#include "language/language.hpp"

namespace algae {

// Systems, languages and statements as a certificate writes them (CERTIFICATES.md).

nlohmann::ordered_json to_json(const ET0L& system, const Alphabet& alphabet,
                               const Word& other = {});
/// With the rules for `other` letters too, and those derived from them.
nlohmann::ordered_json to_json(const SourceSystem& system, const Alphabet& alphabet,
                               const Word& other = {});
nlohmann::ordered_json to_json(const Language& language, const Alphabet& alphabet);
nlohmann::ordered_json to_json(const Statement& statement, const Alphabet& alphabet);

}  // namespace algae
