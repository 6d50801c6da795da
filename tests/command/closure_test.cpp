#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

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
