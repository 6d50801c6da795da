// Messages for mistakes that newcomers make: each names what was found and how to say it right.

#include <doctest/doctest.h>

#include <filesystem>
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
    for (const std::string rule : {"a --> ab", "a(x) : x < 3 --> a(x+1)", "a -(1/2)--> ab"}) {
        INFO(rule);
        CHECK(has(said_of("axiom a\n" + rule + "\n"),
                  "expected an arrow, found '-->'; did you mean '->'?"));
    }
    for (const std::string comment : {"// text", "/* text */", "% text", "-- text"}) {
        INFO(comment);
        CHECK(has(said_of(comment + "\naxiom a\na -> ab\n"),
                  "a comment begins with '#', did you mean '# text'?"));
        const Scratch files;
        for (const auto& [name, rest] :
             {std::pair<std::string, std::string>{"x.claim", "claim x\nshow {a} is 0L\n"},
              {"x.ifs", "map 0.5 0 0 0.5 0 0\n"}}) {
            const std::string file = files.file(name, comment + "\n" + rest);
            const Run refused = run((name == "x.ifs" ? "ifs '" : "check '") + file + "'");
            CHECK(refused.status == 2);
            CHECK(has(refused.err, "a comment begins with '#', did you mean '# text'?"));
        }
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

TEST_CASE(
    "what the system refuses of files and folders is said in one line, with the path and the "
    "reason") {
    const Scratch files;
    const std::string file = files.file("file", "text"), below = file + "/below";
    const std::string figures = files.file("figures"), out = files.file("out");
    for (const std::string& folder : {figures, figures + "/group", out, files.file("claims")})
        std::filesystem::create_directory(folder);
    const std::string system = files.file("figures/group/a.lsys", "axiom F\ngeneration 0\n");
    files.file("out/group", "a file where a folder is to be");
    const std::string circle = "claims/circle.claim", round = files.file(circle);
    std::filesystem::create_symlink(round, round);
    const std::string long_name(300, 'a');
    const std::string not_a_folder = ": Not a directory\n",
                      in_a_circle = ": Too many levels of symbolic links\n";
    const auto said = [](const std::string& arguments, const std::string& expected,
                         const std::string& before = "") {
        INFO(arguments);
        const Run refused = run(arguments, before);
        CHECK(refused.status == 2);
        CHECK(refused.err == expected);
    };
    said("check '" + files.file("claims") + "'", "algae: cannot read " + round + in_a_circle);
    said("dimension --table '" + files.file("claims") + "'",
         "algae: cannot read " + round + in_a_circle);
    said("figures '" + files.file("claims") + "' --out '" + out + "'",
         "algae: cannot read " + round + in_a_circle);
    said("figures '" + figures + "' --out '" + below + "'",
         "algae: cannot make the folder " + below + not_a_folder);
    said("figures '" + figures + "' --formats svg --out '" + out + "'",
         system + ": cannot make the folder " + out + "/group" + not_a_folder);
    said("figures '" + long_name + "' --out '" + out + "'",
         "algae: " + long_name + ": expected a folder of .lsys files and of files of generators\n");
    said("lsp --editors '" + below + "'",
         "algae: cannot make the folder " + below + "/lezer" + not_a_folder);
    said("lesson 1 --out '" + below + "'", "algae: cannot make the folder " + below + not_a_folder);
    // A link in a circle under the name of a file of the lesson.
    const std::string lesson = files.file("lesson");
    REQUIRE(run("lesson 1 --out '" + lesson + "'").status == 0);
    const std::string first = std::filesystem::directory_iterator(lesson)->path().string();
    std::filesystem::remove(first);
    std::filesystem::create_symlink(first, first);
    said("lesson 1 --out '" + lesson + "'", "algae: cannot write " + first + in_a_circle);
    CHECK(std::filesystem::is_symlink(first));
    // A system that is typed is not the name of a file, however long.
    said("fmt --in-place 'a -> " + long_name + "'",
         "algae: --in-place: expected a file, found a system that is typed\n");
    said("studio --port 0",
         "algae: cannot use the folder for temporary files, which TMPDIR names: No such file or "
         "directory\n",
         "TMPDIR=/no-such-folder");
}

TEST_CASE("control characters of names do not reach the terminal") {
    const Run refused = run("show \"$(printf '\\033[31mx')\"");
    CHECK(refused.status == 2);
    CHECK(has(refused.err, "no file \"\\x1b[31mx\""));
}

TEST_CASE("what steers a terminal is escaped in names, in whatever encoding") {
    for (const auto& [written, shown] : {std::pair<std::string, std::string>{"\x9b", "\\x9b"},
                                         {"\xc2\x9b", "\\u009b"},
                                         {"\xe2\x80\xae", "\\u202e"},
                                         {"\xe2\x81\xa6", "\\u2066"},
                                         {"\xe2\x80\x8f", "\\u200f"},
                                         {"\xd8\x9c", "\\u061c"},
                                         {"\xff", "\\xff"},
                                         {"\xe2\x80", "\\xe2\\x80"},
                                         {"\x7f", "\\x7f"}}) {
        INFO(shown);
        const Run refused = run("show '" + written + "31mx'");
        CHECK(refused.status == 2);
        CHECK(has(refused.err, "no file \"" + shown + "31mx\""));
    }
    for (const std::string plain : {"ä", "€", "𝔸", "λ"})
        CHECK(has(run("show '" + plain + "x'").err, "no file \"" + plain + "x\""));
}

TEST_CASE("names of figures are escaped in what figures says of them") {
    const Scratch files;
    files.file("\x1b[31m.lsys", "axiom F\nexpect length 0: 2\n");
    const Run said = run("figures '" + files.path().string() + "' --check");
    CHECK(said.status == 1);
    CHECK(has(said.err, "\\x1b[31m.lsys"));
    CHECK(!has(said.err, "\x1b"));
}
