#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "model/model.hpp"

#include "notation/claim_said.hpp"

using namespace algae;

namespace {

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i) all += text;
    return all;
}

}  // namespace

TEST_CASE("what is too deep is said to be, and exhausts no stack") {
    const std::size_t n = 100000;
    CHECK(claim_messages("show " + repeated("(", n) + "{a}" + repeated(")", n) + " is 0L") ==
          "2:206: more than 200 brackets inside each other");
    CHECK(claim_messages("show /" + repeated("(", n) + "a") == "2:6: '/' is never closed");
    CHECK(claim_messages("show /" + repeated("(", n) + "a/") ==
          "2:207: more than 200 brackets inside each other");
    const std::string operations = "a language with more than 1000 operations inside each other";
    CHECK(claim_messages("show " + repeated("~", n) + "{a} is 0L") == "2:1006: " + operations);
    CHECK(claim_messages("show {a}" + repeated("*", n) + " is 0L") == "2:1009: " + operations);
    CHECK(claim_messages("show {a}" + repeated("|{a}", n) + " is 0L") == "2:4009: " + operations);
    std::string chain = "let A0 = {a}\n", doubles = chain;
    for (int i = 1; i < 1100; ++i)
        chain += "let A" + std::to_string(i) + " = A" + std::to_string(i - 1) + "*\n";
    CHECK(claim_messages(chain) == "1003:18: " + operations);
    for (int i = 1; i < 40; ++i) {
        const std::string before = "A" + std::to_string(i - 1);
        doubles += "let A" + std::to_string(i) + " = " + before + " | " + before + "\n";
    }
    CHECK(claim_messages(doubles).ends_with(
        "a language with more than 1000000 parts where its names are written out"));
}

TEST_CASE("twenty findings, and how many more there are") {
    const std::string said = claim_messages(repeated("x\n", 100));
    CHECK(said.ends_with("\n0:0: 80 more errors"));
    CHECK(std::count(said.begin(), said.end(), '\n') == 20);
}

TEST_CASE("any text is read or refused") {
    CHECK(rc::check([] {
        static const std::vector<std::string> pieces{
            "let ",        "A",         "B",      " = ",
            "{",           "}",         "a",      "b",
            ",",           " -> ",      ";",      "\n",
            "show ",       " is ",      "0L",     " D0L ",
            "axiom a",     "(",         ")",      "|",
            "\\",          "&",         ".",      "~",
            "*",           "+",         "^R",     "^-1",
            "/",           "L(",        "ε",      " in ",
            " not ",       "==",        "==>",    "<=",
            "growth(",     "sequence(", " by ",   "#",
            " # ",         "note ",     "claim ", "closed under ",
            "union",       ": ",        "3",      " steps",
            "alphabet ",   "fibonacci", "?",      "table x",
            "terminals a", "G",         "h",      "\t"};
        std::string text;
        for (int i = *rc::gen::inRange(0, 60); i > 0; --i)
            text += pieces[static_cast<std::size_t>(
                *rc::gen::inRange(0, static_cast<int>(pieces.size())))];
        const auto tried = [&](auto read) {
            try {
                read();
            } catch (const Diagnostics&) {
            }
        };
        tried([&] { claim("let G = 0L { axiom a }\nlet h = { a -> b }\n" + text); });
        tried([&] { claim("show " + text); });
        tried([&] { read_language(text, gallery_system); });
    }));
}
