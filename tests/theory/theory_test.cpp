// The claims of the folder theory: each is as it says, and what is proved of it is checked again.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "places.hpp"
#include "verify/verify.hpp"

using namespace algae;

namespace {

Model from_gallery(const std::string& name) {
    for (const GalleryEntry& entry : gallery())
        if (entry.name == name) return read_lsystem(entry.text, name);
    throw Error("there is no " + name + " in the gallery");
}

std::vector<std::filesystem::path> files() {
    std::vector<std::filesystem::path> found;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(source_folder() + "/theory"))
        if (entry.path().extension() == ".claim") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

Claim read(const std::filesystem::path& path) {
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    return read_claim(text.str(), path.filename().string(), from_gallery);
}

const std::vector<CheckedClaim>& theory() {
    static const std::vector<CheckedClaim> all = [] {
        std::vector<CheckedClaim> checked;
        for (const auto& path : files()) checked.push_back(check(read(path)));
        return checked;
    }();
    return all;
}

}  // namespace

TEST_CASE(
    "every statement of the theory is as its claim says, or rests on a source that it names") {
    REQUIRE(theory().size() >= 80);
    for (const CheckedClaim& checked : theory())
        for (std::size_t i = 0; i < checked.statements.size(); ++i) {
            const auto outcome = checked.statements[i].outcome;
            CHECK_MESSAGE((outcome == CheckedStatement::Outcome::holds ||
                           outcome == CheckedStatement::Outcome::cited),
                          to_string(checked.claim.statements[i].statement.place), ": ",
                          checked.claim.statements[i].statement.text);
        }
}

TEST_CASE("more claims of the theory are decided in all their parts than cited") {
    const auto decided =
        std::count_if(theory().begin(), theory().end(), [](const CheckedClaim& checked) {
            return checked.worst() == CheckedStatement::Outcome::holds;
        });
    CHECK(decided >= 80);
    CHECK(2 * static_cast<std::size_t>(decided) > theory().size());
}

TEST_CASE("certificates of the theory hold; finite refutations are checked to the last") {
    using verify::Finding;
    std::size_t by_cases = 0;
    for (const CheckedClaim& checked : theory()) {
        std::vector<bool> expected;
        for (const CheckedStatement& statement : checked.statements) {
            const auto proof = algae::certificate(statement.answer, *checked.claim.alphabet);
            expected.push_back(!proof.is_null() && proof.at("by") == "cases");
        }
        const auto count = std::count(expected.begin(), expected.end(), true);
        Budget budget;  // what else takes longer is not checked, which no test here is about
        if (count == 0)
            budget.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(3);
        const auto findings =
            verify::check_certificate(certificate(checked).dump(1), checked.claim.name, budget);
        REQUIRE(findings.size() == checked.statements.size());
        for (std::size_t i = 0; i < findings.size(); ++i) {
            CHECK_MESSAGE(findings[i].outcome != Finding::Outcome::wrong, checked.claim.name, ": ",
                          findings[i].statement, ": ", findings[i].reason);
            if (expected[i])
                CHECK_MESSAGE(findings[i].outcome == Finding::Outcome::checked, checked.claim.name,
                              ": ", findings[i].statement, ": ", findings[i].reason);
        }
        by_cases += static_cast<std::size_t>(count);
    }
    CHECK(by_cases > 0);
}

TEST_CASE("every cell of the table of closure is settled by one claim") {
    std::vector<Claim> claims;
    for (const CheckedClaim& checked : theory()) claims.push_back(checked.claim);
    const ClosureTable table(claims);
    for (const std::string& operation : closure_operations())
        for (const std::string& family : closure_families())
            CHECK_MESSAGE(table.cell(family, operation), family, " under ", operation);
}
