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

TEST_CASE("member counts derivations exactly") {
    const std::string powers = "printf 'axiom a; a -> a; a -> aa' |";
    CHECK(run("member - aaa --count -n 2..4", powers).out ==
          "yes: aaa is in the language, first in generation 2\n"
          "of 2 steps: 2 derivations\n"
          "of 3 steps: 6 derivations\n"
          "of 4 steps: 12 derivations\n"
          "20 derivations in all\n");
    const Run infinite = run("member - aaa --count", powers);
    CHECK(infinite.status == 0);
    CHECK(infinite.out.find("of 11 steps: 110 derivations\ninfinitely many derivations: there are "
                            "some of infinitely many numbers of steps\n") != std::string::npos);
    const auto counted = nlohmann::json::parse(run("member - aaa --count --json", powers).out);
    CHECK(counted["infinite"] == true);
    CHECK(counted["total"].is_null());
    CHECK(counted["counts"][1] == nlohmann::json({{"steps", 3}, {"count", 6}}));
    // c(n, t) = c(n, t-1) + sum over i of c(i, t-1) c(n-i, t-1), worked out in another language.
    CHECK(run("member - aaaaaaaaaaaaaaaaaaaaaaaa --count -n 60", powers).out ==
          "yes: aaaaaaaaaaaaaaaaaaaaaaaa is in the language, first in generation 5\nof 60 steps: "
          "26713989030050157853461660800834698711974 derivations\n");
    CHECK(run("member - b --count", powers).status == 1);
    CHECK(nlohmann::json::parse(run("member - b --count --json", powers).out)["total"] == 0);
    CHECK(run("member - aa --count", "printf 'axiom a; a -> b; b -> aa' |").out ==
          "yes: aa is in the language, first in generation 2\nof 2 steps: 1 derivation\n");
}

TEST_CASE("member lists all derivations, each once") {
    const std::string system = "printf 'axiom a; a -> b; a -> bb; b -> cc; b -> c; c -> d' |";
    CHECK(run("member - ccc --all", system).out ==
          "yes: ccc is in the language, first in generation 2\n"
          "of 2 steps: 2 derivations\n"
          "derivation 1 of 2 steps\n"
          "     0  a\n"
          "        a -> bb\n"
          "     1  bb\n"
          "        b -> c, b -> cc\n"
          "     2  ccc\n"
          "derivation 2 of 2 steps\n"
          "     0  a\n"
          "        a -> bb\n"
          "     1  bb\n"
          "        b -> cc, b -> c\n"
          "     2  ccc\n");
    const auto all = nlohmann::json::parse(run("member - cc --all --json", system).out);
    CHECK(all["derivations"].size() == 2);
    CHECK(all["complete"] == true);
    CHECK(all["total"] == 2);
    const std::string powers = "printf 'axiom a; a -> a; a -> aa' |";
    const Run some = run("member - aaa --all -n 6 --max-derivations 3", powers);
    CHECK(some.out.ends_with("27 more; --max-derivations shows more than 3\n"));
    CHECK(some.out.find("derivation 3 of 6 steps\n") != std::string::npos);
    CHECK(run("member - aaa --all", powers)
              .out.ends_with("infinitely many more; --max-derivations shows more than 20\n"));
    const std::string tables = "printf 'axiom a; table s; a -> b; table t; a -> b; b -> c' |";
    const Run named = run("member - c --all", tables);
    CHECK(named.out.find("infinitely many derivations") != std::string::npos);
    CHECK(named.out.find("        table s: a -> b\n     1  b\n        table t: b -> c\n") !=
          std::string::npos);
}

TEST_CASE("member says which options go together") {
    const std::string system = "printf 'axiom a; a -> aa' |";
    const auto refused = [&](const std::string& options, const std::string& message) {
        const Run asked = run("member - aa " + options, system);
        CHECK(asked.status == 2);
        CHECK(asked.err == "algae: " + message + '\n');
    };
    refused("-n 3", "-n goes with --count or --all: derivations of so many steps");
    refused("--max-derivations 3", "--max-derivations goes with --all");
    refused("--all --brief", "--brief leaves out the derivations that --all asks for");
    refused("--count -n x", "-n: expected a whole number from 0 on, found \"x\"");
    CHECK(run("member - aaaaaaaaaaaaaaaaaaaaaaaa --count --max-memory 500",
              "printf 'axiom a; a -> aa; a -> aaa' |")
              .status == 3);
}

TEST_CASE("questions about a language refuse contexts between brackets") {
    // They ended the command by a signal; equal printed an error of the standard library.
    for (const std::string verb :
         {"finite bracketed-context", "finite bracketed-context --json",
          "finite bracketed-context --certificate -", "member bracketed-context ABC",
          "equal bracketed-context bracketed-context"}) {
        const Run refused = run(verb);
        INFO(verb, " ", refused.err);
        CHECK(refused.status == 2);
        CHECK(refused.err.find("algae: bracketed-context: expected a system without context or one "
                               "with plain contexts, found one with context whose words have "
                               "brackets\n") == 0);
    }
}
