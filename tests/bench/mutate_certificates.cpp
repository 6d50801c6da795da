// Changes tokens of the certificates of all claims of the theory and counts what verify makes of them (tools/mutate-certificates).
// mutate_certificates COUNT SEED FILE: writes them for another checker, a line each, and what verify says of them to FILE.verify.

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "verify/mutants.hpp"

namespace {

using namespace algae;
using mutants::Json;

Model from_gallery(const std::string& name) {
    for (const GalleryEntry& entry : gallery())
        if (entry.name == name) return read_lsystem(entry.text, name);
    throw Error("there is no " + name + " in the gallery");
}

/// Of each statement of the theory that is checked within the time, a certificate.
std::vector<Json> certificates(std::chrono::milliseconds time, std::size_t& statements) {
    std::vector<Json> all;
    for (const GalleryEntry& entry : theory_claims()) {
        Budget budget;
        budget.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        const Json whole = certificate(check(
            read_claim(entry.text, std::string(entry.name), from_gallery), budget, {2'000, 9}));
        for (std::size_t i = 0; i < whole["statements"].size(); ++i) {
            ++statements;
            Json one = mutants::with_statement(whole, i);
            const auto finding = mutants::found(one, time);
            if (finding && finding->outcome == verify::Finding::Outcome::checked)
                all.push_back(std::move(one));
        }
    }
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 20'000;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    constexpr std::chrono::milliseconds time{100};
    std::size_t statements = 0;
    const auto all = certificates(time, statements);
    fmt::print("{} statements of the theory, {} of them checked within {} ms\n", statements,
               all.size(), time.count());
    mutants::Mutator mutate(seed);
    mutants::Counts counts;
    std::ofstream lines, findings;
    mutants::OnMutant write;
    if (argc > 3) {
        lines.open(argv[3]);
        findings.open(argv[3] + std::string(".verify"));
        write = [&](const Json& mutant, const std::optional<verify::Finding>& finding) {
            // verify's finding is that of the first statement
            const bool has_others = mutant["statements"].size() > 1;
            lines << (has_others ? mutants::with_statement(mutant, 0) : mutant).dump() << '\n';
            findings << (finding ? to_string(finding->outcome) : "refused") << '\n';
        };
    }
    for (std::size_t i = 0; counts.mutants < count && !all.empty(); ++i)
        counts.add(mutants::judged(all[i % all.size()], all[mutate.below(all.size())], 4, mutate,
                                   time, write));
    fmt::print(
        "{} mutants (seed {}): {} rejected; accepted: {} that say the same, {} confirmed, {} not "
        "decided, {} false\n",
        counts.mutants, seed, counts.rejected, counts.same, counts.confirmed, counts.open,
        counts.wrong);
    for (const std::string& example : counts.examples) fmt::print("FALSE: {}\n", example);
    lines.close();
    findings.close();
    if (argc > 3 && (!lines || !findings)) {
        fmt::print("FAILED: {} is not written\n", argv[3]);
        return 1;
    }
    return counts.wrong == 0 ? 0 : 1;
}
