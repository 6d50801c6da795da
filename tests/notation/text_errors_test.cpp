#include <doctest/doctest.h>

#include <string>

#include "model/model.hpp"

#include "notation/said.hpp"

using namespace algae;

TEST_CASE("bytes that are no text") {
    using namespace std::string_literals;
    CHECK(findings("axiom F\0F\0\ntitle \xff\x01\naxiom \xc0\xaf\ntitle \x1b[1m"s) ==
          "x.lsys:1:8: error: expected a text, found a NUL byte\n"
          "  axiom F\uFFFDF\uFFFD\n"
          "         ^\n"
          "x.lsys:2:7: error: expected UTF-8, found the byte 0xFF\n"
          "  title \uFFFD\uFFFD\n"
          "        ^\n"
          "x.lsys:3:7: error: expected UTF-8, found the byte 0xC0\n"
          "  axiom \uFFFD\uFFFD\n"
          "        ^\n"
          "x.lsys:4:7: error: found the control character U+001B\n"
          "  title \uFFFD[1m\n"
          "        ^");
    CHECK(findings("axiom \xed\xa0\x80")
              .starts_with("x.lsys:1:7: error: expected UTF-8, found the byte 0xED"));
    CHECK(findings("axiom \xf4\x90\x80\x80").starts_with("x.lsys:1:7: error: expected UTF-8"));
    CHECK(findings("axiom a\xe2\x82").starts_with("x.lsys:1:8: error: expected UTF-8"));
    CHECK(findings("\xEF\xBB\xBF"
                   "axiom a\r\na -> b\r\n") == "");
}

TEST_CASE("columns count characters, long lines are cut around the caret, tabs are one column") {
    CHECK(findings("axiom αβγ)") ==
          "x.lsys:1:10: error: expected a symbol, found ')'\n"
          "  axiom αβγ)\n"
          "           ^");
    CHECK(findings("axiom\ta)\r\n") ==
          "x.lsys:1:8: error: expected a symbol, found ')'\n"
          "  axiom a)\n"
          "         ^");
    const std::string finding =
        findings("axiom " + std::string(1000, 'a') + ")" + std::string(1000, 'b'));
    CHECK(finding == "x.lsys:1:1007: error: expected a symbol, found ')'\n  ..." +
                         std::string(70, 'a') + ")" + std::string(39, 'b') + "...\n  " +
                         std::string(73, ' ') + "^");
}

TEST_CASE("of very many findings the first twenty are shown, in order of place") {
    std::string text = "axiom a\n";
    for (int i = 0; i < 50; ++i) text += i % 2 == 0 ? "foo\n" : "a -> ]\n";
    try {
        read_lsystem(text, "x.lsys");
        FAIL("expected findings");
    } catch (const Diagnostics& error) {
        REQUIRE(error.findings().size() == 21);
        for (std::size_t i = 0; i < 20; ++i) CHECK(error.findings()[i].place.line == i + 2);
        CHECK(error.findings().back().text() == "x.lsys: error: 30 more errors");
    }
}
