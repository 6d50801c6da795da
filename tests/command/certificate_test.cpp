// Answers to questions as certificates, which verify checks: `is`, `equal`, `member`, `finite`.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

namespace {

/// What verify says of the certificate that the command writes, without the lines on letters and systems.
std::string verified(const std::string& arguments, int status) {
    const Scratch scratch;
    const std::string file = scratch.file("answer.json");
    const Run asked = run(arguments + " --certificate " + file);
    CAPTURE(asked.err);
    CHECK(asked.status == status);
    CHECK(asked.out == run(arguments).out);
    const Run checked = run("verify " + file);
    CHECK(checked.status == (status == 3 ? 3 : 0));
    const std::size_t last = checked.out.rfind("checked: ");
    return last == std::string::npos ? checked.out : checked.out.substr(last);
}

}  // namespace

TEST_CASE("is writes its answer as a certificate") {
    CHECK(verified("is 0L '{a, aa}'", 1) == "checked: {a, aa} is not 0L\n1 checked\n");
    CHECK(verified("is D0L '{a, b}'", 0) == "checked: {a, b} is D0L\n1 checked\n");
    CHECK(verified("is PD0L 'L(fibonacci)'", 0) == "checked: L(fibonacci) is PD0L\n1 checked\n");
    CHECK(verified("is infinite 'L(fibonacci)'", 0) ==
          "checked: L(fibonacci) is not finite\n1 checked\n");
    CHECK(verified("is finite '/a*/'", 1) == "checked: {a}* is not finite\n1 checked\n");
    CHECK(verified("is empty '{a} & {b}'", 0) == "checked: ({a} & {b}) is empty\n1 checked\n");
    CHECK(verified("is regular '/a*b/'", 0) == "checked: ({a}* {b}) is REG\n1 checked\n");
    CHECK(verified("is 0L '{}'", 1) == "checked: {} is not 0L\n1 checked\n");
    CHECK(verified("is 0L '{ε}'", 1) == "checked: {ε} is not 0L\n1 checked\n");
    CHECK(verified("is 0L '{ε}' --allow-empty-axiom", 0) == "checked: {ε} is 0L\n1 checked\n");
    CHECK(verified("is 0L '{b a^(2^n) : n >= 0}*'", 3).ends_with("1 undecided\n"));
}

TEST_CASE("member writes its answer as a certificate") {
    CHECK(verified("member fibonacci abaab", 0) == "checked: abaab is in L(A)\n1 checked\n");
    CHECK(verified("member fibonacci abab --brief", 1) ==
          "checked: abab is not in L(A)\n1 checked\n");
    CHECK(verified("member koch xyz", 1) == "checked: xyz is not in L(A)\n1 checked\n");
    CHECK(verified("member koch 'F+F--F+F'", 0) == "checked: F+F--F+F is in L(A)\n1 checked\n");
    const Scratch scratch;
    const std::string tables =
        scratch.file("t.lsys", "axiom S; terminals a; table x; S -> aS | ε; table y; S -> SS\n");
    CHECK(verified("member " + tables + " aaa", 0) == "checked: aaa is in L(A)\n1 checked\n");
    CHECK(verified("member " + tables + " ε", 0) == "checked: ε is in L(A)\n1 checked\n");
    CHECK(verified("member " + tables + " aS", 1) == "checked: aS is not in L(A)\n1 checked\n");
}

TEST_CASE("finite writes its answer as a certificate") {
    CHECK(verified("finite koch", 1) == "checked: L(A) is not finite\n1 checked\n");
    const Scratch scratch;
    const std::string swap = scratch.file("s.lsys", "axiom ab; a -> b; b -> a\n");
    CHECK(verified("finite " + swap, 0) == "checked: L(A) is finite\n1 checked\n");
    const std::string tables =
        scratch.file("t.lsys", "axiom a; table x; a -> aa; table y; a -> b\n");
    CHECK(verified("finite " + tables, 1) == "checked: L(A) is not finite\n1 checked\n");
}

TEST_CASE("equal writes its answer as a certificate") {
    const Scratch scratch;
    const std::string left = scratch.file("a.lsys", "axiom ab; a -> ab; b -> ab\n"),
                      right = scratch.file("b.lsys", "axiom ab; a -> aba; b -> b\n"),
                      other = scratch.file("c.lsys", "axiom ab; a -> b; b -> abab\n");
    const std::string both = "equal " + left + ' ' + right, differ = "equal " + left + ' ' + other;
    CHECK(verified(both, 0) == "checked: L(A) = L(B)\n1 checked\n");
    CHECK(verified(both + " --as sequence", 0) ==
          "checked: A and B have equal sequences\n1 checked\n");
    CHECK(verified(both + " --as growth", 0) == "checked: A and B have equal lengths\n1 checked\n");
    CHECK(verified(differ, 1) == "checked: L(A) != L(B)\n1 checked\n");
    CHECK(verified(differ + " --as sequence", 1) ==
          "checked: A and B have different sequences\n1 checked\n");
    CHECK(verified(differ + " --as growth", 1) ==
          "checked: A and B have different lengths\n1 checked\n");
}

TEST_CASE("a certificate of an answer is written beside its JSON, and whole or not at all") {
    const Scratch scratch;
    const std::string file = scratch.file("answer.json");
    const json answer = json::parse(run("is 0L '{a, aa}' --json --certificate " + file).out);
    CHECK(answer["verdict"] == "refuted");
    const json written = json::parse(text_of(file));
    CHECK(written["claim"] == "{a, aa} is 0L");
    CHECK(written["statements"][0]["proof"] == answer["obstruction"]);
    const Run failed = run("is 0L '{a, aa}' --certificate " + scratch.file("none/answer.json"));
    CHECK(failed.status == 2);
    CHECK(scratch.size() == 1);
}
