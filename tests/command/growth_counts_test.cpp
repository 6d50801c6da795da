#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

TEST_CASE("growth --counts gives lengths, letters and drawn segments of any generation") {
    CHECK(run("growth plant-f -n 5 --counts")
              .out.starts_with("n = 5: length 6263, segments 1488, letters"));
    const auto found =
        nlohmann::json::parse(run("growth koch -n 2..3 --counts --json").out)["generations"];
    CHECK(found[0]["letters"] == nlohmann::json({{"F", 16}, {"+", 10}, {"-", 10}}));
    CHECK(found[1]["segments"] == 64);
    CHECK(found[1]["length"] == 148);
    const auto far =
        nlohmann::json::parse(run("growth koch -n 1000000 --counts --json").out)["generations"][0];
    CHECK(far["segments"].get<std::string>().size() == 602060);
    CHECK(run("growth koch --counts").status == 2);
}
