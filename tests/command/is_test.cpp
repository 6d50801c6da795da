#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

TEST_CASE("is says yes with the system, no with the proof by cases") {
    const Run yes = run("is D0L '{a, b}'");
    CHECK(yes.status == 0);
    CHECK(yes.out == "yes\nThe system with axiom b; a -> a; b -> a generates it.\n");
    const Run no = run("is 0L '{a} | {aa}'");
    CHECK(no.status == 1);
    CHECK(no.out ==
          "no\n"
          "{a} | {aa} = {a, aa}.\n"
          "{a, aa} is not 0L.\n"
          "Suppose that a system generates it. Each letter occurs in a word of the language, and "
          "what that word gives is "
          "in the language again. So an image of a letter is one of the factors of its words: ε, a "
          "or aa.\n"
          "a -> ε is impossible: a would give ε, which is not in the language.\n"
          "a -> aa is impossible: aa would give aaaa, which is not in the language.\n"
          "a -> a is left.\n"
          "By what is left, no other word gives a, and no other word gives aa. The axiom is not "
          "both, so one of these words "
          "is never reached.\n"
          "So {a, aa} is not 0L.\n");
    CHECK(no.err.empty());
}

TEST_CASE("is says what it did not decide, and ends with 3") {
    const Run open = run("is 0L '{b a^(2^n) : n >= 0}*'");
    CHECK(open.status == 3);
    CHECK(
        open.out ==
        "undecided\n{b a^(2^n) : n >= 0}* was not found to be finite or regular; that no 0L system "
        "does is decided for few other languages\n");
    const json found = json::parse(run("is 0L '{b a^(2^n) : n >= 0}*' --json").out);
    CHECK(found["verdict"] == "undecided");
    CHECK(found["argument"].size() == 1);
    CHECK(!found.contains("witness"));
    CHECK(!found.contains("obstruction"));
}

TEST_CASE("is --json has the witness or the obstruction") {
    const Run yes = run("is 0L '{ε, a, aa}' --json");
    CHECK(yes.status == 0);
    const json witness = json::parse(yes.out);
    CHECK(witness["verdict"] == "proved");
    CHECK(witness["witness"]["by"] == "system");
    CHECK(witness["witness"]["system"].contains("axiom"));
    const Run no = run("is 0L '{a, aa}' --json");
    CHECK(no.status == 1);
    const json found = json::parse(no.out);
    CHECK(found["verdict"] == "refuted");
    CHECK(found["obstruction"]["by"] == "cases");
    CHECK(found["obstruction"]["obstruction"]["root"]["end"] == "sources");
    CHECK(found["argument"].back() == "So {a, aa} is not 0L.");
}

TEST_CASE("is knows more than families of systems") {
    CHECK(run("is finite '{a, aa}'").out == "yes\n{a, aa} has 2 words.\n");
    CHECK(run("is infinite '/a+/'").status == 0);
    CHECK(run("is infinite '{a}'").status == 1);
    CHECK(run("is empty '{}'").out == "yes\n{} has no word.\n");
    CHECK(run("is empty '/a/'").out == "no\na is a word of {a}.\n");
    CHECK(run("is regular 'L(fibonacci)'").status == 1);
    CHECK(run("is context-free '/a(ab)*/'").status == 0);
    CHECK(run("is PD0L 'L(fibonacci)'").out == "yes\nL(fibonacci) is given by a PD0L system.\n");
    CHECK(run("is E0L 'L(fibonacci)'").out == "yes\nL(fibonacci) is given by an E0L system.\n");
}

TEST_CASE("is --allow-empty-axiom lets systems begin with the empty word") {
    CHECK(run("is 0L '{ε}'").status == 1);
    const Run allowed = run("is 0L '{ε}' --allow-empty-axiom");
    CHECK(allowed.status == 0);
    CHECK(allowed.out == "yes\nThe system with axiom ε generates it.\n");
}

TEST_CASE("is reads systems from files") {
    const Scratch files;
    const std::string file = files.file("one.lsys", "axiom a; a -> aa");
    CHECK(run("is PD0L 'L(" + file + ")'").status == 0);
}

TEST_CASE("is refuses what it cannot read") {
    const auto refused = [](const std::string& arguments, const std::string& message) {
        const Run found = run("is " + arguments);
        CHECK(found.status == 2);
        CHECK(found.out.empty());
        CAPTURE(found.err);
        CHECK(found.err.find(message) != std::string::npos);
    };
    refused("0L X", "expression:1:1: error: expected a name that is defined above, found 'X'");
    refused("0L '{a'", "expression:1:3: error: expected ',' or '}'");
    refused("XL '{a}'", "XL is no family of languages");
    refused("0L 'L(nothing-of-that-name)'", "no file \"nothing-of-that-name\"");
    refused("0L ''", "expression");
    refused("0L", "EXPR is required");
}
