// Messages for mistakes that newcomers make: each names what was found and how to say it right.

#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "command/run.hpp"

namespace {

/// What the command says of a text as a system.
std::string said_of(const std::string& text) {
    const Scratch files;
    const Run refused = run("fmt '" + files.file("x.lsys", text) + "'");
    CHECK(refused.status == 2);
    return refused.err;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("arrows and comments of other notations are recognised") {
    for (const std::string arrow : {"=>", "=", "::=", ":="}) {
        INFO(arrow);
        CHECK(has(said_of("axiom a\na " + arrow + " ab\n"),
                  "did you mean '->' instead of '" + arrow + "'?"));
    }
    CHECK(has(said_of("axiom a\na --> ab\n"), "expected an arrow '->' after one symbol"));
    for (const std::string comment : {"// text", "/* text */", "% text", "-- text"}) {
        INFO(comment);
        CHECK(has(said_of(comment + "\naxiom a\na -> ab\n"), "a comment begins with '#'"));
    }
}

TEST_CASE("families in other spellings are recognised") {
    for (const auto& [written, meant] :
         {std::pair<std::string, std::string>{"OL", "0L"}, {"0l", "0L"}, {"pd0l", "PD0L"}}) {
        INFO(written);
        const std::string hint = "did you mean '" + meant + "'?";
        const Run is = run("is " + written + " '{a}'");
        CHECK(is.status == 2);
        CHECK(is.err == "algae: " + written + " is no family of languages; " + hint + "\n");
        CHECK(has(run("closure " + written).err, hint));
        CHECK(has(run("check --say '{a} is " + written + "'").err, hint));
    }
    CHECK(has(run("check --say 'closed under kleene: 0L'").err, "did you mean 'star'?"));
}

TEST_CASE("names and options in other words are recognised") {
    CHECK(has(run("draw snowflake -o x.svg").err, "did you mean 'koch-snowflake'?"));
    CHECK(has(run("draw koch --color red -o x.svg").err, "did you mean '--colour'?"));
    CHECK(has(run("draw koch --outptu x.svg").err, "did you mean '--output'?"));
}

TEST_CASE("files of other programs are named") {
    for (const auto& [begins, what] :
         {std::pair<std::string, std::string>{"\x89PNG\r\n", "a PNG picture"},
          {"<svg>", "XML, such as an SVG picture"},
          {"{\"axiom\": 1}", "JSON"}}) {
        INFO(begins);
        const Scratch files;
        const Run refused = run("show '" + files.file("other", begins) + "'");
        CHECK(refused.status == 2);
        CHECK(has(refused.err, "looks like " + what + ", expected an L-system"));
    }
}

TEST_CASE("a probability of something that is no derivation is refused with its place") {
    const Scratch files;
    const Run refused = run("check '" +
                            files.file("m.claim",
                                       "claim x\nlet G = 0L { axiom a }\n"
                                       "show P(G) ==> b in 2 steps = 1\n") +
                            "'");
    CHECK(refused.status == 2);
    CHECK(has(refused.err,
              "m.claim:3:8: error: expected a derivation such as 'G ==> ab in 3 steps'"));
}

TEST_CASE("a damaged picture is said to be damaged") {
    const Scratch files;
    const std::string whole = files.file("k.png");
    REQUIRE(run("draw koch -n 2 -o '" + whole + "'").status == 0);
    const std::string text = text_of(whole);
    std::string changed = text;
    changed[text.size() / 2] = static_cast<char>(changed[text.size() / 2] ^ 0x55);
    for (const std::string& bad : {text.substr(0, 300), text.substr(0, 20), changed}) {
        const std::string path = files.file("broken.png", bad);
        const Run refused = run("dimension '" + path + "'");
        CHECK(refused.status == 2);
        CHECK(refused.err ==
              "algae: " + path +
                  ": expected a PNG image, found one that is damaged or ends too early\n");
    }
    // 60,000 x 60,000 pixels in a few bytes.
    std::string bomb = text;
    for (const std::size_t at : {16u, 20u}) bomb.replace(at, 4, std::string("\0\0\xea\x60", 4));
    const Run bounded = run("dimension '" + files.file("bomb.png", bomb) + "' --max-memory 300M");
    CHECK(bounded.status == 3);
    CHECK(has(bounded.err, "--max-memory"));
}

TEST_CASE("control characters of names do not reach the terminal") {
    const Run refused = run("show \"$(printf '\\033[31mx')\"");
    CHECK(refused.status == 2);
    CHECK(has(refused.err, "no file \"\\x1b[31mx\""));
}
