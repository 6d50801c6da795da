#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"
#include "places.hpp"

TEST_CASE("derive prints the word of a generation, or all of them") {
    CHECK(run("derive koch -n 1").out == "F+F--F+F\n");
    CHECK(run("derive koch -n 1 --all").out == "F\nF+F--F+F\n");
    CHECK(run("derive koch -n 0..1").out == "F\nF+F--F+F\n");
    CHECK(nlohmann::json::parse(run("derive koch -n 1 --all --json").out)["words"] ==
          nlohmann::json({"F", "F+F--F+F"}));
}

TEST_CASE("derive reads a system from standard input") {
    CHECK(run("derive - -n 5", "printf 'axiom b; a -> ab; b -> a' |").out == "abaababa\n");
}

TEST_CASE("the empty word is printed as epsilon") {
    const Scratch scratch;
    const std::string file = scratch.file("dies.lsys", "axiom a\na ->\n");
    CHECK(run("derive " + file + " -n 1").out == "ε\n");
    CHECK(nlohmann::json::parse(run("derive " + file + " -n 1 --json").out)["words"][0] == "ε");
}

TEST_CASE("subscripts print without blanks, and with one where digits would run together") {
    CHECK(run("derive - -n 1", "printf 'axiom F_r; F_r -> F_l F_r F_l' |").out == "F_lF_rF_l\n");
    CHECK(run("derive - -n 1", "printf 'axiom a; a -> X_1 2 X_1' |").out == "X_1 2X_1\n");
}

TEST_CASE("all words of a nondeterministic system, each once, in shortlex order") {
    const std::string system = "printf 'axiom aa; a -> ; a -> a; a -> b' |";
    CHECK(run("derive - -n 1 --all-words", system).out == "ε\na\nb\naa\nab\nba\nbb\n");
    CHECK(run("derive - -n 1 --all-words --longest 1", system).out == "ε\na\nb\n");
    CHECK(run("derive - --all-words --longest 3", "printf 'axiom a; a -> aa; a -> aaa' |").out ==
          "a\naa\naaa\n");
}

TEST_CASE("a seed picks the same word every time") {
    const std::string system = "printf 'axiom F; F -> F[+F]F; F -> F[-F]F' |";
    const Run first = run("derive - -n 5 --seed 7", system);
    CHECK(first.status == 0);
    CHECK(first.out == run("derive - -n 5 --seed 7", system).out);
    CHECK(first.out != run("derive - -n 5 --seed 8", system).out);
    CHECK(run("derive - -n 2 --seed 7", system).out == "F[+F]F[-F[+F]F]F[-F]F\n");
}

TEST_CASE("a system with choices says what to do instead") {
    const Run refused = run("derive - -n 3", "printf 'axiom a; a -> a; a -> aa' |");
    CHECK(refused.status == 2);
    CHECK(refused.err ==
          "algae: not a D0L system: a has 2 rules; say --all-words for all words, or --seed S for "
          "one picked at random\n");
}

TEST_CASE("a generation that is too long is answered at once with its length") {
    const Run long_word = run("derive dragon -n 60");
    CHECK(long_word.status == 3);
    CHECK(long_word.err ==
          "algae: generation 60 has 4611686018427387902 letters, more than the 1000000000 that "
          "--max-letters allows. "
          "`algae letter -n 60 --at P` gives any part of it, `algae growth -n 60` its length, "
          "`algae draw -n 60` its "
          "picture\n");
    CHECK(run("derive koch -n 1000000000000").status == 3);
}

TEST_CASE("parameters, conditions and modules elsewhere") {
    CHECK(run("derive - -n 2 --all",
              "printf 'axiom A(1); let k = 0.5; A(x) : x < 2 -> A(x+1)B(k*x)' |")
              .out == "A(1)\nA(2)B(0.5)\nA(2)B(0.5)\n");
    CHECK(run("derive - -n 1",
              "printf 'axiom C(3,8)D(-1)B(5)A(1); A(x) ? B(y), C(r,z) : x < y + r -> D(x)E(y+r)' |")
              .out == "C(3,8)D(-1)B(5)D(1)E(8)\n");
    CHECK(nlohmann::json::parse(run("derive - -n 1 --json", "printf 'axiom A(1); A(x) -> A(x/3)' |")
                                    .out)["words"][0] == "A(1/3)");
    const Run failed = run("derive - -n 5", "printf 'axiom A(2)\nA(x) -> A(x-1)B(1/x)' |");
    CHECK(failed.status == 2);
    CHECK(failed.err ==
          "algae: standard input:2:1: the rule for A(0) at position 0 of generation 2: division by "
          "0 in '1/x'\n");
    CHECK(run("derive - -n 30 --max-letters 1000", "printf 'axiom A(2); A(x) -> A(x)A(x)' |")
              .status == 3);
}

TEST_CASE("probabilities: a seed, a panel of seeds, all words, expected numbers") {
    const std::string system = "printf 'axiom F; F -(1/3)-> FF; F -(2/3)-> F' |";
    CHECK(run("derive - -n 4", system).out == run("derive - -n 4 --seed 1", system).out);
    const std::string panel = run("derive - -n 4 --seeds 1..3", system).out;
    CHECK(panel == run("derive - -n 4 --seed 1", system).out +
                       run("derive - -n 4 --seed 2", system).out +
                       run("derive - -n 4 --seed 3", system).out);
    CHECK(run("derive - -n 2 --distribution", system).out ==
          "4/9  F\n10/27  FF\n4/27  FFF\n1/27  FFFF\n");
    CHECK(nlohmann::json::parse(
              run("derive - -n 1 --distribution --json", system).out)["words"][1]["probability"] ==
          "1/3");
    CHECK(run("derive - -n 2 --expected", system).out ==
          "F  16/9  1.777778\nlength  16/9  1.777778\n");
    CHECK(nlohmann::json::parse(
              run("derive - -n 2 --expected --json", system).out)["letters"]["F"] == "16/9");
}

TEST_CASE("tables and terminals") {
    const std::string tables =
        "printf 'axiom a; table light; a -> ab; table dark; a -> b; b -> aa' |";
    CHECK(run("derive - --tables light,dark", tables).out == "baa\n");
    CHECK(run("derive - --tables 12 --all", tables).out == "a\nab\nbaa\n");
    CHECK(run("derive - -n 3 --seed 2", tables).status == 0);
    CHECK(run("derive - -n 3", tables).err ==
          "algae: it has 2 tables and no schedule; say --tables SEQUENCE, or --seed S for random "
          "ones\n");
    CHECK(run("derive - -n 3 --tables 12", tables).err ==
          "algae: --tables: expected a table for each of 3 steps, found 2\n");
    CHECK(run("derive - -n 2 --language", tables).out == "a\nb\naa\nab\nabb\nbaa\n");
    CHECK(run("derive - -n 3 --language", "printf 'axiom S; S -> aSb; S -> ab; terminals a b' |")
              .out == "ab\naabb\naaabbb\n");
    CHECK(run("derive - -n 1", "printf 'axiom S; S -> a; terminals a' |").out == "a\n");
}

TEST_CASE("what derive does not decide by itself is refused by name") {
    const auto refused = [](const std::string& system) {
        const Run run_of = run("derive - -n 1", "printf '" + system + "' |");
        CHECK(run_of.status == 2);
        return run_of.err;
    };
    CHECK(refused("axiom ba; b < a -> b; b < a -> a")
              .find("a has two rules with the same contexts") != std::string::npos);
    CHECK(refused("axiom A(1); A(x) : x > 0 -> B; A(x) : x < 2 -> C").find("matches too") !=
          std::string::npos);
    CHECK(refused("axiom A?E(0); A -> AA").find("nothing fills the communication module ?E") !=
          std::string::npos);
}

TEST_CASE("numbers out of range are refused with what was expected") {
    CHECK(run("derive koch -n -1").err ==
          "algae: -n: expected a whole number from 0 on, found \"-1\"\n");
    CHECK(run("derive koch -n -1").status == 2);
    CHECK(run("derive koch -n 99999999999999999999").err ==
          "algae: -n: expected a number below 2^63, found \"99999999999999999999\"\n");
    CHECK(run("derive koch -n 99999999999999999999").status == 2);
    CHECK(run("derive koch -n 6..0").status == 2);
    CHECK(run("derive koch").err == "algae: -n is missing: which generation?\n");
    CHECK(run("derive koch -n 3 --max-letters many").status == 2);
    CHECK(run("derive koch -n 3 --max-letters 5").status == 3);
}

TEST_CASE("a full output is an error, a closed pipe ends the command") {
    const Scratch scratch;
    if (std::filesystem::exists("/dev/full")) {
        const int ended = std::system(
            ("'" + built_command() + "' derive koch -n 10 >/dev/full 2>/dev/null").c_str());
        CHECK(WEXITSTATUS(ended) == 2);
    }
    const int ended = std::system(
        ("'" + built_command() + "' derive koch -n 13 | head -c 10 >/dev/null").c_str());
    CHECK(WEXITSTATUS(ended) == 0);
}

TEST_CASE("a word written in pieces is the word written at once") {
    const Run big = run("derive koch -n 9");
    CHECK(big.out.size() == 611669);
    CHECK(run("derive koch -n 9 --json").out.find(big.out.substr(0, big.out.size() - 1)) !=
          std::string::npos);
}

TEST_CASE("derive with contexts: words, ranges, JSON, trees, bounds") {
    const std::string signal = "printf 'axiom baaa; b < a -> b; b -> a' |";
    CHECK(run("derive - -n 2", signal).out == "aaba\n");
    CHECK(run("derive - -n 4 --all", signal).out == "baaa\nabaa\naaba\naaab\naaaa\n");
    CHECK(nlohmann::json::parse(run("derive - -n 1..2 --json", signal).out)["words"] ==
          nlohmann::json({"abaa", "aaba"}));
    CHECK(
        run("derive - -n 1", "printf 'axiom ABC[DE][SG[HI[JK]L]MNO]; BC < S > G[H]M -> X' |").out ==
        "ABC[DE][XG[HI[JK]L]MNO]\n");
    CHECK(run("derive - -n 2 --all", "printf 'axiom ab; a < b -> ; a -> ' |").out == "ab\nε\nε\n");
    const Run bounded =
        run("derive - -n 100 --max-letters 1000", "printf 'axiom ab; a < b -> bb; b -> bb' |");
    CHECK(bounded.status == 3);
    CHECK(bounded.out.empty());
    CHECK(bounded.err ==
          "algae: generation 10 has more than 1000 letters, the bound set by --max-letters\n");
    // Long words come out whole.
    CHECK(
        run("derive - -n 7 | wc -c",
            "{ printf 'axiom '; head -c 300000 /dev/zero | tr '\\0' a; printf '; a < a -> b'; } |")
            .out == "300001\n");
}
