#include <doctest/doctest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "command/run.hpp"

TEST_CASE("a cell of the closure table for which the time is over is undecided") {
    const std::string over = "the time allowed by --timeout is over";
    for (const char* cell : {"0L union", "E0L union"}) {
        CAPTURE(cell);
        const std::string asked = "closure " + std::string(cell);
        CHECK(run(asked).status < 2);
        const Run text = run(asked + " --timeout 0.001");
        CHECK(text.status == 3);
        CHECK(text.out.starts_with("Whether "));
        CHECK(text.out.find(over) != std::string::npos);
        const Run json = run(asked + " --timeout 0.001 --json");
        CHECK(json.status == 3);
        const auto found = nlohmann::json::parse(json.out);
        CHECK(found["verdict"] == "undecided");
        CHECK(found["cell"]["status"] == "undecided");
        CHECK(found["cell"]["closed"].is_null());
        CHECK(found["proof"].dump().find(over) != std::string::npos);
    }
    CHECK(run("closure 0L --timeout 0.001").status == 3);
}

TEST_CASE("a cell without + is refuted by the least counterexample where a finite one is found") {
    const Run cell = run("closure 0L union --json");
    CHECK(cell.status == 1);
    const auto found = nlohmann::json::parse(cell.out)["cell"];
    CHECK(found["status"] == "refuted");
    CHECK(found["closed"] == false);
    CHECK(found["counterexample"] == nlohmann::json{{"A", "{a}"}, {"B", "{aa}"}});
    const Run text = run("closure DT0L inverse-homomorphism");
    CHECK(text.out.starts_with(
        "DT0L languages are not closed under inverse homomorphism (theory/closure/"));
    CHECK(text.out.find("Theorem. not for all DT0L languages A and morphisms h: h^-1(A) is DT0L: "
                        "proved.\n") != std::string::npos);
    const nlohmann::json table = nlohmann::json::parse(run("closure --json").out)["table"];
    std::map<std::string, int> counts;
    for (const auto& one : table) ++counts[one["status"].get<std::string>()];
    CHECK(counts["refuted"] >= 70);
    // Reversal, and the complement of P0L; of the others examples of a construction hold.
    CHECK(counts["proved"] == 17);
    CHECK(counts["undecided"] == 0);
}
