#pragma once

#include <string>

#include "verify/certificate.hpp"

namespace algae::verify {

/// A statement, or its opposite, on one line. Long expressions are shortened in the middle.
std::string statement_text(const Statement& statement, bool refuted, const Alphabet& alphabet);

}  // namespace algae::verify
