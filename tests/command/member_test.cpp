#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

TEST_CASE("member says yes with the derivation, no with the reason") {
    const std::string system = "printf 'axiom ab; a -> a; a -> aa; b -> ; b -> b' |";
    const Run yes = run("member - aaa", system);
    CHECK(yes.status == 0);
    CHECK(yes.out ==
          "yes: aaa is in the language, first in generation 2\n"
          "     0  ab\n"
          "        a -> aa, b -> ε\n"
          "     1  aa\n"
          "        a -> aa, a -> a\n"
          "     2  aaa\n");
    const Run no = run("member - ε", system);
    CHECK(no.status == 1);
    CHECK(
        no.out.starts_with("no: ε is not in the language: what the letters derive within it in "));
    CHECK(run("member - abx", system).out ==
          "no: abx is not in the language: the letter x at position 2 occurs in no word of the "
          "language\n");
    CHECK(run("member - aaa --brief", system).out ==
          "yes: aaa is in the language, first in generation 2\n");
}

TEST_CASE("member of a D0L system") {
    CHECK(run("member - FFFF", "printf 'axiom F; F -> FF' |").out ==
          "yes: FFFF is in the language, first in generation 2\n     0  F\n        F -> FF\n     1 "
          " FF\n"
          "        F -> FF (2 times)\n     2  FFFF\n");
    CHECK(run("member - FFF", "printf 'axiom F; F -> FF' |").out ==
          "no: FFF is not in the language: no generation before 2 has it, and from generation 2 on "
          "every word is longer\n");
    CHECK(run("member - a", "printf 'axiom ab; a -> b; b -> a' |").status == 1);
}

TEST_CASE("member in JSON has the rule of every letter") {
    const Run yes =
        run("member - aa --json", "printf 'axiom ab; a -> a; a -> aa; b -> ; b -> b' |");
    const auto found = nlohmann::json::parse(yes.out);
    CHECK(found["member"] == true);
    CHECK(found["step"] == 1);
    CHECK(found["derivation"] ==
          nlohmann::json::parse(R"([{"word":"ab","successors":["aa","ε"]},{"word":"aa"}])"));
    const auto refused =
        nlohmann::json::parse(run("member - aaa --json", "printf 'axiom a; a -> aa' |").out);
    CHECK(refused["member"] == false);
    CHECK(refused["step"].is_null());
}

TEST_CASE("member refuses what is no word of an 0L system, and bounds") {
    CHECK(run("member - 'A(1)'", "printf 'axiom a; a -> aa' |").status == 2);
    CHECK(run("member - a", "printf 'axiom A(1); A(x) -> A(x+1)' |").status == 2);
    CHECK(run("member - aaaaaaaaaaaaaaaaaaaaaaaaaaa --max-memory 500",
              "printf 'axiom a; a -> aa; a -> aaa' |")
              .status == 3);
}

TEST_CASE("finite says how many words there are, or why there is no end") {
    CHECK(run("finite - ", "printf 'axiom aa; a -> ; a -> a' |").out == "finite: 3 words\n");
    CHECK(run("finite - ", "printf 'axiom c; c -> ab; a -> b; b -> a' |").out ==
          "finite: 3 words; from generation 1 on they repeat with period 2\n");
    const Run endless = run("finite - ", "printf 'axiom a; a -> b; b -> ac' |");
    CHECK(endless.status == 1);
    CHECK(endless.out ==
          "infinite: by b -> ac, a -> b the letter b has b in what it becomes, and beside it c, "
          "which can go on for ever\n");
    const auto found =
        nlohmann::json::parse(run("finite - --json", "printf 'axiom a; a -> b; b -> a' |").out);
    CHECK(found ==
          nlohmann::json({{"finite", true}, {"count", 2}, {"preperiod", 0}, {"period", 2}}));
    const auto infinite = nlohmann::json::parse(run("finite koch --json").out);
    CHECK(infinite["finite"] == false);
    CHECK(infinite["count"].is_null());
}

TEST_CASE("member with tables names the table of each step, and with terminals looks at them") {
    const std::string system =
        "printf 'axiom SS\\nterminals a b\\ntable grow\\nS -> aT; T -> b\\n"
        "table turn\\nT -> SU; a -> ; b -> N\\ntable end\\nU -> b; S -> b\\n' |";
    const Run yes = run("member - bbbb", system);
    CHECK(yes.status == 0);
    CHECK(yes.out ==
          "yes: bbbb is in the language, first in generation 3\n"
          "     0  SS\n"
          "        table grow: S -> aT (2 times)\n"
          "     1  aTaT\n"
          "        table turn: a -> ε, T -> SU, a -> ε, T -> SU\n"
          "     2  SUSU\n"
          "        table end: S -> b, U -> b, S -> b, U -> b\n"
          "     3  bbbb\n");
    const auto found = nlohmann::json::parse(run("member - bbbb --json", system).out);
    CHECK(found["step"] == 3);
    CHECK(found["derivation"][0] ==
          nlohmann::json::parse(R"({"word":"SS","table":"grow","successors":["aT","aT"]})"));
    const Run no = run("member - bbb", system);
    CHECK(no.status == 1);
    CHECK(no.out.starts_with(
        "no: bbb is not in the language: what the letters derive within it by "));
    CHECK(run("member - aSb", system).out ==
          "no: aSb is not in the language: the letter S at position 1 is not a terminal\n");
}

TEST_CASE("member of an E0L system needs no tables") {
    const Run yes = run("member - aabb", "printf 'axiom S; terminals a b; S -> aSb; S -> ab' |");
    CHECK(yes.status == 0);
    CHECK(yes.out.ends_with("     1  aSb\n        S -> ab\n     2  aabb\n"));
}

TEST_CASE("finite with tables and terminals") {
    CHECK(run("finite -", "printf 'axiom S; terminals a; S -> SN; S -> a' |").out ==
          "finite: 1 word\n");
    CHECK(run("finite -", "printf 'axiom S; terminals a; S -> SN' |").out ==
          "finite: 0 words; the language is empty\n");
    const std::string tables = "printf 'axiom a\\ntable p\\na -> b\\ntable q\\nb -> aa\\n' |";
    const Run endless = run("finite -", tables);
    CHECK(endless.status == 1);
    CHECK(endless.out ==
          "infinite: by p: a -> b, q: b -> aa the letter a has a in what it becomes, and beside it "
          "a once more\n");
    const auto found = nlohmann::json::parse(run("finite - --json", tables).out);
    CHECK(found["finite"] == false);
    CHECK(found["count"].is_null());
    CHECK(found["round"]["again"] == "a");
    CHECK(
        found["round"]["round"] ==
        nlohmann::json::parse(R"([{"table":"p","rule":"a -> b"},{"table":"q","rule":"b -> aa"}])"));
    CHECK(
        run("finite -", "printf 'axiom S; terminals a x; S -> aSx; S -> ; a -> a; x -> x' |").out ==
        "infinite: by S -> aSx the letter S has S in what it becomes, and beside it a, which has a "
        "in what it becomes by a -> a; "
        "a can end by a -> a; and all letters beside them can become terminals by the same "
        "tables\n");
    CHECK(nlohmann::json::parse(
              run("finite - --json", "printf 'axiom S; terminals a; S -> a; S -> aa' |").out) ==
          nlohmann::json({{"finite", true}, {"count", 2}}));
}

TEST_CASE("member and finite refuse systems with parameters, and say why") {
    for (const std::string verb : {"member - a", "finite -"}) {
        CHECK(run(verb, "printf 'axiom A(1); A(x) -> A(x+1)' |").status == 2);
    }
}
