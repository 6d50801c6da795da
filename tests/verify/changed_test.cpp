// Certificates of each kind of proof, and small changes of them: what is found of each stands beside it, word by word, so a
// check that is left out, or that looks at another place, is noticed. Tests of other files say which of them can be true.

#include "verify/changed.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "places.hpp"

namespace {

using changed::Found, changed::Json;

Json cases_of(const std::string& file) {
    std::ifstream text(source_folder() + "/tests/verify/certificates/" + file + ".json");
    REQUIRE(text);
    return Json::parse(text);
}

void check_all(const std::string& file, std::size_t least) {
    std::size_t count = 0;
    const Json cases = cases_of(file);
    CHECK(!cases.empty());
    for (const Json& each : cases) {
        const Json certificate = changed::certificate_of(each);
        INFO(each["case"].get<std::string>());
        const Found whole = changed::found(certificate);
        CHECK(whole.outcome == each["outcome"].get<std::string>());
        CHECK(whole.says == each["says"].get<std::string>());
        for (const Json& one : each["changes"]) {
            Json other = certificate;
            changed::change(other, one[0]);
            INFO(one[0].dump());
            const Found then = changed::found(other);
            CHECK(then.outcome == one[1].get<std::string>());
            if (!then.says.empty())
                CHECK(then.says == (one.size() > 2 ? one[2].get<std::string>() : whole.says));
            ++count;
        }
    }
    CHECK(count >= least);
}

/// Every fourth file of those that `tools/mutants verify --hunt` writes: changes that notice mutants of the checker.
void check_noticed(std::size_t first) {
    std::vector<std::string> files;
    const std::string folder = source_folder() + "/tests/verify/certificates/mutants";
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files.push_back(entry.path().stem().string());
    std::sort(files.begin(), files.end());
    REQUIRE(files.size() > 20);
    for (std::size_t i = first; i < files.size(); i += 4) check_all("mutants/" + files[i], 0);
}

}  // namespace

TEST_CASE("changed proofs about systems: derivations, families, sequences and growth") {
    check_all("systems", 300);
}

TEST_CASE("changed proofs by cases that a finite language is not of a family") {
    check_all("finite", 60);
}

TEST_CASE("changed proofs about languages: families, finiteness, equality and inclusion") {
    check_all("languages", 600);
}

TEST_CASE("changed proofs about numbers, words that depend on them, and modules") {
    check_all("numbers", 400);
}

TEST_CASE("changed statements: powers, codes, automata, quantifiers, and what is no certificate") {
    check_all("statements", 500);
}

TEST_CASE("statements are written from what was read") { check_all("written", 80); }

TEST_CASE("changes that mutants of the checker are noticed by: first files") { check_noticed(0); }

TEST_CASE("changes that mutants of the checker are noticed by: second files") { check_noticed(1); }

TEST_CASE("changes that mutants of the checker are noticed by: third files") { check_noticed(2); }

TEST_CASE("changes that mutants of the checker are noticed by: fourth files") { check_noticed(3); }
