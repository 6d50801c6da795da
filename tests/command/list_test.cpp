#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

TEST_CASE("list prints words line by line, and what is known of others") {
    const Run some = run("list '/b|a/ {b}*' --words 3");
    CHECK(some.status == 0);
    CHECK(some.out == "a\nb\nab\nThese are the first 3 words.\n");
    CHECK(run("list '/b|a/ {b}*' --length 2").out ==
          "a\nb\nab\nbb\nThese are all words of at most 2 letters.\n");
    CHECK(run("list '{a, ε}'").out == "ε\na\nThese are all words.\n");
    CHECK(run("list '{}'").out == "The language has no word.\n");
    CHECK(run("list '/a+b/' --length 1").out == "There is no word of at most 1 letter.\n");
    CHECK(run("list '/a*/' --words 1").out == "ε\nThis is the first word.\n");
    CHECK(run("list 'L(fibonacci)' --words 4").out ==
          "a\nb\nab\naba\nThese are the first 4 words.\n");
    const Run far = run("list 'L(fibonacci)'");
    CHECK(far.status == 0);
    CHECK(far.out.ends_with("These are all words of at most 100 letters.\n"));
}

TEST_CASE("list says over which letters complements are") {
    CHECK(run("list '~{a} & /a*/ | {b}' --length 2").out ==
          "ε\nb\naa\nThese are all words of at most 2 letters.\n~ is over the letters a, b.\n");
    CHECK(run("list '~{a}' --length 1 --alphabet 'b, c'").out ==
          "ε\nb\nc\nThese are all words of at most 1 letter.\n~ is over the letters a, b, c.\n");
    const json found = json::parse(run("list '~{a}' --length 1 --alphabet b --json").out);
    CHECK(found["complement_letters"] == json({"a", "b"}));
    CHECK(run("is regular '~{a}' --alphabet b").out.ends_with("~ is over the letters a, b.\n"));
    CHECK(run("check --say '~{a} == {ε} | /aa+/'").status == 0);
    const Run more = run("check --say '~{a} == {ε} | /aa+/' --alphabet b");
    CHECK(more.status == 1);
    CHECK(more.out.find("~ is over the letters a, b.") != std::string::npos);
    const Run bad = run("list '~{a}' --alphabet ' '");
    CHECK(bad.status == 2);
    CHECK(bad.err.find("--alphabet: expected letters such as 'a b c'") != std::string::npos);
    CHECK(run("list '~{a}' --alphabet '('").err.find("the alphabet: expected names without '('") !=
          std::string::npos);
}

TEST_CASE("list --counts has the numbers of words and the generating function") {
    CHECK(run("list '/(a|bb)*/' --counts --length 3").out ==
          "0 letters: 1 word\n1 letter: 1 word\n2 letters: 2 words\n3 letters: 3 words\n"
          "generating function: 1/(1 - x - x^2)\n");
    CHECK(run("list '{a}' --counts --length 2").out ==
          "0 letters: 0 words\n1 letter: 1 word\n2 letters: 0 words\nNo word is longer.\n"
          "generating function: x\n");
    const json found = json::parse(run("list '/(a|b)*/' --counts --length 70 --json").out);
    CHECK(found["counts"][3] == 8);
    CHECK(found["counts"][70] == "1180591620717411303424");
    CHECK(found["generating_function"]["denominator"] == json({1, -2}));
    CHECK(found["whole"] == false);
    CHECK(found["stopped"].is_null());
    const json powers = json::parse(run("list '{a^n b^n : n >= 0}' --counts --json").out);
    CHECK(powers["counts"].size() == 13);
    CHECK(powers["generating_function"].is_null());
}

TEST_CASE("list --random draws words of a length") {
    const Run drawn = run("list '/(a|b)*/' --random 3 --length 20 --seed 5");
    CHECK(drawn.status == 0);
    CHECK(drawn.out.size() == 3 * 21);
    CHECK(drawn.out == run("list '/(a|b)*/' --random 3 --length 20 --seed 5").out);
    CHECK(drawn.out != run("list '/(a|b)*/' --random 3 --length 20").out);
    const json found = json::parse(run("list '/(a|b)*/' --random 3 --length 20 --json").out);
    CHECK(found["words"].size() == 3);
    CHECK(found["seed"] == 1);
    const Run none = run("list '/(aa)*/' --random 3 --length 5");
    CHECK(none.status == 1);
    CHECK(none.out == "The language has no word of 5 letters.\n");
    CHECK(run("list '/a*/' --random 3").status == 2);
    CHECK(run("list '/a*/' --seed 3").status == 2);
    CHECK(run("list '/a*/' --random 3 --length 2 --counts").status == 2);
}

TEST_CASE("list follows all choices of a system with context") {
    const Scratch files;
    const auto of = [&](const std::string& rules) {
        return "list 'L(" + files.file("choices.lsys", rules) + ")'";
    };
    CHECK(run(of("axiom ab; a > b -> aa | b") + " --length 3").out ==
          "ab\nbb\naab\nabb\nbbb\nThese are all words of at most 3 letters.\n");
    CHECK(run(of("axiom aab; a > b -> a | b")).out == "aab\nabb\nbbb\nThese are all words.\n");
    const Run erasing = run(of("axiom ab; a > b -> aab | b; a < b -> b | ε") + " --length 2");
    CHECK(erasing.status == 3);
    CHECK(erasing.out.find("are not all, and later ones may be shorter") != std::string::npos);
}

TEST_CASE("list ends with 3 where words may be missing") {
    const Scratch files;
    const std::string file = files.file("back.lsys", "axiom ab; a -> aa; a < b -> ε; b -> ab");
    const Run open = run("list 'L(" + file + ")' --length 4");
    CHECK(open.status == 3);
    CHECK(open.out.find("At least these are words of the language, and others may be missing: ") !=
          std::string::npos);
    const json found = json::parse(run("list 'L(" + file + ")' --length 4 --json").out);
    CHECK(found["length"].is_null());
    CHECK(found["stopped"].is_string());
    const Run bounded = run("list '/(a|b)*/' --length 40 --max-memory 1M");
    CHECK(bounded.status == 3);
    CHECK(bounded.out.find("--max-memory") != std::string::npos);
    CHECK(bounded.out.starts_with("ε\na\nb\naa\n"));
    CHECK(run("list 'X'").status == 2);
    CHECK(run("list").status == 2);
}
