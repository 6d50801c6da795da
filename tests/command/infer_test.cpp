#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

TEST_CASE("infer gives a system that derives the words again") {
    const Run found = run("infer c b ac cb");
    CHECK(found.status == 0);
    CHECK(found.out.starts_with("axiom c\nc -> b\nb -> ac\na -> c\n# size "));
    CHECK(run("derive - -n 3", "printf 'axiom c; c -> b; b -> ac; a -> c' |").out == "cb\n");
}

TEST_CASE("infer in JSON has the keys that programs rely on") {
    const json found = json::parse(run("infer a ab aba --json").out);
    CHECK(found["family"] == "D0L");
    CHECK(found["words"] == json({"a", "ab", "aba"}));
    CHECK(found["as"] == "generations");
    CHECK(found["system"] == "axiom a\na -> ab\nb -> a\n");
    CHECK(found["size"] == 6);
    CHECK(found["smaller_refuted"] == true);
    const Run none = run("infer a aa aaa --json");
    CHECK(none.status == 1);
    CHECK(json::parse(none.out)["system"].is_null());
    CHECK(json::parse(none.out)["smaller_refuted"] == true);
}

TEST_CASE("infer finds tables, contexts and choices") {
    CHECK(run("infer a aa aaaaaa --family DT0L")
              .out.starts_with(
                  "axiom a\ntable t_1\na -> aa\ntable t_2\na -> aaa\nschedule t_1 t_2\n# size 8"));
    CHECK(run("infer a aa aaa --family 0L").status == 0);
    CHECK(run("infer a aa aaa --family T0L").out.find("# the smallest T0L system: ") !=
          std::string::npos);
    const Run context = run("infer ab ba ab bb ab --family DIL");
    CHECK(context.status == 1);
    CHECK(run("infer ab ba bb aa --family DIL").status == 0);
}

TEST_CASE("infer has samples, and says when larger systems may have them") {
    const json found = json::parse(run("infer aaaa a aa --sample --json").out);
    CHECK(found["system"] == "axiom a\na -> aa\n");
    CHECK(found["size"] == 4);
    const Run open = run("infer a b ab abb --sample --max-size 4");
    CHECK(open.status == 3);
    CHECK(open.out.starts_with("no D0L system of a size up to 4 has all these words"));
}

TEST_CASE("infer says what is wrong and how to say it right") {
    const auto error = [](const std::string& arguments) {
        const Run ran = run("infer " + arguments);
        CHECK(ran.status == 2);
        return ran.err;
    };
    CHECK(error("a ab --family E0L").find("expected D0L, PD0L, 0L") != std::string::npos);
    CHECK(error("ε a").find("the first word is empty") != std::string::npos);
    CHECK(error("'A(1)' a").find("has parameters") != std::string::npos);
    CHECK(error("a ab --max-size 4").find("--max-size is for --sample") != std::string::npos);
    CHECK(error("a ab --family DIL --sample").find("samples are of") != std::string::npos);
}
