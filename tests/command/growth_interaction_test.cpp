#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

TEST_CASE("growth of a system with interactions derives the lengths and claims nothing") {
    const Run page = run("growth square-root-growth -n 0..6");
    CHECK(page.status == 0);
    CHECK(page.out ==
          "lengths, n = 0..6\n3, 4, 4, 5, 5, 5, 6\n"
          "Letters look at their neighbours, so there is no growth matrix and no recurrence to go "
          "by:\n"
          "these lengths are derived, and nothing is claimed beyond them.\n");
    const auto found = nlohmann::json::parse(run("growth logarithmic-growth -n 0..4 --json").out);
    CHECK(found["class"] == "unknown");
    CHECK(found["lengths"] == nlohmann::json({3, 3, 3, 4, 4}));
    CHECK(run("growth - -n 100 --max-letters 50", "printf 'axiom ab; a -> aa; a < b -> bb' |")
              .status == 3);
}
