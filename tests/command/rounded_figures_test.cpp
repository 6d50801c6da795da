// Which figures have rounded parameters is said on standard error and in JSON.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

namespace {

using nlohmann::json;

const std::string many = "printf 'axiom A(1); A(x) -> F(x)A(x/3)A(x/2)' |";
const std::string reason = "the words up to it have more than 20000 modules together";

}  // namespace

TEST_CASE("draw shows no module that only doubles derive, and says where parameters are doubles") {
    const Scratch scratch;
    const std::string tiny =
        "printf 'axiom A(1); A(x) : x > 0 -> A(x/1024)F; A(x) : x = 0 -> B; interpret B -> FFFFF' "
        "|";
    const Run exact = run("draw - -n 125 --json -o " + scratch.file("a.svg"), tiny);
    CHECK(exact.status == 0);
    CHECK(exact.err.empty());
    const json facts = json::parse(exact.out);
    CHECK(facts["segments"] == 125);
    CHECK(facts["rounded"].is_null());

    const Run few = run("draw - -n 5 --json -o " + scratch.file("b.svg"), many);
    CHECK(few.err.empty());
    CHECK(json::parse(few.out)["rounded"].is_null());
    const Run rounded = run("draw - -n 14 --json -o " + scratch.file("c.svg"), many);
    CHECK(rounded.status == 0);
    CHECK(rounded.err.find("algae: note: the parameters of generation 14 of ") == 0);
    CHECK(rounded.err.find(" are doubles, rounded in each step: " + reason + "\n") !=
          std::string::npos);
    CHECK(json::parse(rounded.out)["rounded"] == reason);
    const Run several = run("draw - -n 12..15 --panels -o " + scratch.file("d.svg"), many);
    CHECK(several.err.find(" other figure") != std::string::npos);
    CHECK(several.err.find("note") == several.err.rfind("note"));  // one note for all of them

    const Run large = run("draw - -n 14 --json -o " + scratch.file("e.svg"),
                          "printf 'axiom A(1.0001); A(x) -> F(x)A(x*x)' |");
    CHECK(large.err.find("1:32: the value of 'x*x' has more than 10,000 digits") !=
          std::string::npos);
    const Run undecided =
        run("draw - -n 1 -o " + scratch.file("f.svg"),
            "printf 'axiom A(1); A(x) : exp(x)*exp(0-x) = 1 -> F; A(x) : exp(x)*exp(0-x) != 1 -> "
            "FF' |");
    CHECK(undecided.status == 0);
    CHECK(undecided.err.find("the enclosures of 512 bits do not say which value") !=
          std::string::npos);
    // In a verdict the same is no figure's matter: it is undecided, and the word is refused.
    const std::string choice =
        "axiom A(1); A(x) : exp(x)*exp(0-x) = 1 -> B; A(x) : exp(x)*exp(0-x) != 1 -> C";
    const Run verdict = run("check -", "printf 'claim c\nlet G = parametric { " + choice +
                                           " }\nshow G ==> B in 1 step' |");
    CHECK(verdict.status == 3);
    CHECK(verdict.out.find("the enclosures of 512 bits do not say which value") !=
          std::string::npos);
    CHECK(run("derive - -n 1", "printf '" + choice + "' |").status == 2);
}

TEST_CASE("explanations, animations, meshes and folders say that parameters are doubles") {
    const Scratch scratch;
    const std::string large = "printf 'axiom A(1.0001); A(x) -> F(x)A(x*x)' |";
    const auto notes = [](const Run& asked) {
        CHECK(asked.status == 0);
        CHECK(asked.err.find("has more than 10,000 digits") != std::string::npos);
        return json::parse(asked.out);
    };
    CHECK(notes(run("draw - -n 14 --explain --json", large))["rounded"].is_string());
    CHECK(notes(run("draw - -n 14 --progressive --json -o " + scratch.file("a.gif"),
                    large))["rounded"]
              .is_string());
    CHECK(notes(run("draw - -n 14 --json -o " + scratch.file("a.obj"),
                    "printf 'axiom A(1.0001); A(x) -> &F(x)A(x*x)' |"))["rounded"]
              .is_string());
    std::filesystem::create_directory(scratch.file("in"));
    scratch.file("in/large.lsys", "axiom A(1.0001)\nA(x) -> F(x)A(x*x)\ngeneration 14\n");
    scratch.file("in/small.lsys", "axiom A(1)\nA(x) -> F(x)A(x/3)\ngeneration 4\n");
    const json folder = notes(run("figures '" + scratch.file("in") +
                                  "' --json --formats svg --out " + scratch.file("out")));
    CHECK(folder["figures"][0]["rounded"].size() == 1);
    CHECK(folder["figures"][1]["rounded"].empty());
}
