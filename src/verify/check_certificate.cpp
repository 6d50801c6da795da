#include "verify/check_certificate.hpp"

#include <new>

#include "base/error.hpp"
#include "verify/proofs.hpp"
#include "verify/statement_text.hpp"

namespace algae::verify {

namespace {

Finding check(const Checking& with, const Entry& entry) {
    using Outcome = Finding::Outcome;
    Finding found;
    const bool refuted = entry.verdict == Entry::Verdict::refuted;
    found.statement = statement_text(entry.statement, refuted, with.alphabet());
    found.path = entry.field.path();
    found.line = entry.field.line();
    if (entry.verdict == Entry::Verdict::undecided) return found;
    if (entry.verdict == Entry::Verdict::cited) {
        found.outcome = Outcome::cited;
        found.citation = entry.citation;
        return found;
    }
    try {
        check_proof(with, entry.statement, refuted == entry.statement.negated, *entry.proof);
        found.outcome = Outcome::checked;
    } catch (const Flaw& flaw) {
        found.outcome = Outcome::wrong;
        found.path = flaw.path;
        found.line = flaw.line;
        found.reason = flaw.reason;
    } catch (const BoundReached& bound) {
        found.outcome = Outcome::not_checked;
        found.reason = bound.what();
    } catch (const std::bad_alloc&) {
        found.outcome = Outcome::not_checked;
        found.reason = "the machine has no more memory";
    }
    return found;
}

}  // namespace

std::vector<Finding> check_certificate(const Certificate& certificate, const Budget& budget) {
    const Checking with{certificate,
                        Reader(*certificate.alphabet, certificate.systems, certificate.rewritings),
                        budget};
    std::vector<Finding> all;
    for (const Entry& entry : certificate.entries) all.push_back(check(with, entry));
    return all;
}

std::string to_string(Finding::Outcome outcome) {
    using Outcome = Finding::Outcome;
    switch (outcome) {
        case Outcome::checked:
            return "checked";
        case Outcome::cited:
            return "cited: not checked";
        case Outcome::not_checked:
            return "not checked";
        case Outcome::wrong:
            return "WRONG";
        case Outcome::undecided:
            break;
    }
    return "undecided";
}

}  // namespace algae::verify
