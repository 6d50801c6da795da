#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

TEST_CASE(
    "growth of a system with interactions derives the lengths, and says whether words repeat or "
    "grow") {
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
    const Run signal = run("growth signal -n 0..2");
    CHECK(signal.out.ends_with(
        "these lengths are derived.\nBut the words repeat: from generation 4 on the word stays "
        "the same, so the lengths are bounded.\n"));
    const auto bounded = nlohmann::json::parse(run("growth signal -n 0..2 --json").out);
    CHECK(bounded["class"] == "bounded");
    CHECK(bounded["preperiod"] == 4);
    const auto rising = nlohmann::json::parse(
        run("growth - -n 0..3 --json", "printf 'axiom ab; a > b -> aa' |").out);
    CHECK(rising["class"] == "unbounded");
    CHECK(rising["rises_from"] == 0);
    CHECK(run("growth - --counts -n 2", "printf 'axiom ab; a > b -> aa | b' |")
              .err.find("a has two rules with the same contexts") != std::string::npos);
    CHECK(run("growth - -n 100 --max-letters 50", "printf 'axiom ab; a -> aa; a < b -> bb' |")
              .status == 3);
}
