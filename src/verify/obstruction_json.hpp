#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "verify/finite_obstruction.hpp"
#include "verify/reader.hpp"

namespace algae {

/// A word as certificates have it: the names of its symbols with a blank between any two.
///
/// Example: certificate_text(*finite_language({"ab"}).alphabet, {0, 1, 0}) == "a b a"
std::string certificate_text(const Alphabet& alphabet, const Word& word);

/// What a certificate holds of a proof by cases (CERTIFICATES.md): the cases and the impossible tables. The
/// family and the language are those of the statement that it proves.
nlohmann::ordered_json to_json(const FamilyObstruction& obstruction);

namespace verify {

/// The proof by cases that a certificate holds; its family and language are left as they begin.
FamilyObstruction read_obstruction(const Reader& reader, const Field& field);

}  // namespace verify

}  // namespace algae
