#pragma once
// verify: certificates, checked again by means that share nothing with the search that found them.

#include <string>
#include <vector>

#include "base/budget.hpp"
#include "verify/certificate.hpp"

namespace algae::verify {

/// What came of one statement of a certificate.
struct Finding {
    enum class Outcome {
        checked,      // its proof shows it, or its opposite if it is said to be refuted
        cited,        // it rests on a source: not checked
        undecided,    // the certificate does not decide it
        not_checked,  // a bound was reached: see `reason`
        wrong         // its proof does not show it: see `path`, `line` and `reason`
    };
    Outcome outcome = Outcome::undecided;
    std::string statement;  // in words, made of the statement itself and not of its text
    std::string citation;
    std::string path;
    std::size_t line = 0;
    std::string reason;
};

/// Checks every statement of a certificate, each by itself. Throws Error where a proof is not as
/// CERTIFICATES.md says, Interrupted if the work was asked to stop.
std::vector<Finding> check_certificate(const Certificate& certificate, const Budget& budget);

/// "checked", "cited: not checked", "undecided", "not checked" or "WRONG".
std::string to_string(Finding::Outcome outcome);

}  // namespace algae::verify
