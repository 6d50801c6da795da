#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a system is typed wherever FILE stands") {
    const std::string fibonacci = "'a -> ab, b -> a'";
    CHECK(run("derive " + fibonacci + " -n 5").out == "abaababaabaab\n");
    CHECK(run("derive '0->01,1->10' -n 3").out == "01101001\n");
    CHECK(run("letter " + fibonacci + " -n 100 --at 100000000000000 --count 5").status == 0);
    CHECK(json::parse(run("show " + fibonacci + " --json").out)["class"] == "PD0L");
    CHECK(run("fmt 'a->ab,b->a'").out == "axiom a\na -> ab\nb -> a\n");
    CHECK(run("convert " + fibonacci + " --to sage").out ==
          "m = WordMorphism('a->ab,b->a')\nm('a', 5)\n");
    CHECK(run("member " + fibonacci + " abaab").status == 0);
    CHECK(run("finite " + fibonacci).status == 1);
    CHECK(run("growth " + fibonacci + " -n 10").status == 0);
    CHECK(run("equal " + fibonacci + " 'axiom a; b -> a; a -> ab'").status == 0);
    CHECK(run("list \"L('a -> ab, b -> a')\"").out.starts_with("a\nab\naba\n"));
    CHECK(run("is 0L \"L('a -> aa')\"").out == "yes\nL('a -> aa') is given by a 0L system.\n");
    const Scratch scratch;
    CHECK(run("draw 'F->F+F--F+F,angle 60' -n 2 -o '" + scratch.file("k.svg") + "'").status == 0);
    CHECK(run("tree " + fibonacci + " -n 2 -o '" + scratch.file("t.dot") + "'").status == 0);
    CHECK(run("dimension 'F->F+F--F+F,angle 60' -n 4").out ==
          run("dimension 'F -> F+F--F+F; angle 60' -n 4").out);
    const std::string claim = scratch.file(
        "c.claim",
        "claim T\nshow abaab in L('a -> ab, b -> a')\nshow b not in L(\"a -> ab, b -> a\")\n");
    CHECK(run("check '" + claim + "'").status == 0);
}

TEST_CASE("what is no file and no system says how either is given") {
    const auto said = [](const std::string& arguments) {
        const Run all = run(arguments);
        CHECK(all.status == 2);
        return all.err;
    };
    CHECK(holds(said("derive 'a -> ab]' -n 2"),
                "typed system:1:8: error: unmatched ']'\n  a -> ab]\n"));
    CHECK(holds(said("show 'a=ab,b=a'"), "a system is typed with arrows: 'a -> ab, b -> a'"));
    CHECK(holds(said("show a-"), "the shell takes '>' for itself"));
    CHECK(holds(said("show 'a->b.lsys'"), "no file \"a->b.lsys\""));
    CHECK(holds(said("list \"L('a -> ]')\""), "expression:1:9: error: unmatched ']'"));
    CHECK(holds(said("list \"L('a -> b\""), "expected ' at the end of the system"));
    CHECK(holds(said("ifs 'a -> ab'"), "expected an iterated function system"));
    // A file of this name comes first.
    const Scratch scratch;
    scratch.file("a->b", "axiom c");
    CHECK(run("derive 'a->b' -n 0", "cd '" + scratch.path().string() + "' &&").out == "c\n");
}

TEST_CASE("--let sets constants") {
    const std::string system = "'let k = 2; axiom A(k); A(x) -> A(x*k)'";
    CHECK(run("derive " + system + " -n 3 --let k=3").out == "A(81)\n");
    CHECK(run("derive " + system + " -n 1 --let k=1/2").out == "A(0.25)\n");
    CHECK(holds(run("fmt " + system + " --let k=3").out, "let k = 3\n"));
    const auto said = [&](const std::string& let) {
        const Run all = run("derive " + system + " -n 1 " + let);
        CHECK(all.status == 2);
        return all.err;
    };
    CHECK(holds(said("--let q=3"), "has no constant 'q'; it has k"));
    CHECK(holds(said("--let k"), "--let: expected NAME=VALUE, such as a1=35, found \"k\""));
    CHECK(holds(said("--let k=x"), "--let k=x: expected a number or a constant, found 'x'"));
    CHECK(holds(said("--let k=1 --let k=2"), "--let: the constant 'k' is given twice"));
    CHECK(holds(said("--let k=1..3"), "a range"));
    const Scratch scratch;
    const std::string tree =
        "draw 'let a = 20; F->F[+(a)F]F' -n 2 --json -o '" + scratch.file("t.svg") + "' --let ";
    const json panels = json::parse(run(tree + "a=20..60:10").out);
    CHECK(panels["figures"].size() == 5);
    CHECK(panels["figures"][4]["figure"] == "generation 2 of typed system, a = 60");
    CHECK(json::parse(run(tree + "a=20..40:10 --captions").out)["figures"].size() == 3);
    CHECK(holds(run(tree + "a=20..60:-10").err, "the step does not lead from 20 to 60"));
    CHECK(holds(run(tree + "a=20..x").err,
                "expected a rational number behind '..', such as in a1=20..60:10, found \"x\""));
    CHECK(holds(run(tree + "a=1..1000").err, "has more than 100 values"));
}

TEST_CASE("codings are heeded where words are shown") {
    CHECK(run("derive rudin-shapiro -n 4").out == "0001001000011101\n");
    CHECK(run("letter paperfolding -n 4 --at 0 --count 16").out == "1101100111001001\n");
    CHECK(run("derive paperfolding -n 0..2").out == "1\n11\n1101\n");
    CHECK(json::parse(run("show paperfolding --json").out)["coding"][2] ==
          json{{"letter", "c"}, {"image", "0"}});
    CHECK(holds(run("show arshon").out, "coding         a -> 0, "));
    CHECK(run("derive 'axiom ab; a < b -> a; coding { a -> 0; b -> 1 }' -n 0..1").out ==
          "01\n00\n");
    CHECK(run("derive 'a -(1/2)-> b; a -(1/2)-> c; coding { b -> 1; c -> 1 }' -n 1 --seed 3").out ==
          "1\n");
    CHECK(holds(run("derive 'a -> a | b; coding { a -> 0 }' -n 1 --all-words").err,
                "--all-words: is for words before the coding"));
    // The same letters, whether a word is written whole or in pieces.
    const std::string whole = run("derive arshon -n 11").out;
    CHECK(whole.size() == 177148);
    CHECK(run("letter arshon -n 11 --at 65530 --count 20").out == whole.substr(65530, 20) + "\n");
}

TEST_CASE("the gallery is searched") {
    const Run found = run("gallery --find tree");
    CHECK(found.status == 0);
    CHECK(holds(found.out, "tree"));
    CHECK(!holds(found.out, "thue-morse"));
    CHECK(holds(run("gallery --find 'THUE 1912'").out, "thue-morse"));
    CHECK(holds(run("gallery --find pd0l").out, "tribonacci"));
    CHECK(!holds(run("gallery --find pd0l").out, "padovan-like"));
    const Run nothing = run("gallery --find nothing-like-this");
    CHECK(nothing.status == 1);
    CHECK(nothing.out.empty());
    CHECK(holds(nothing.err, "nothing in the gallery has the words nothing-like-this"));
    for (const char* name :
         {"thue-morse", "tribonacci", "tetranacci", "period-doubling", "rudin-shapiro",
          "paperfolding", "chacon", "cantor-word", "pell", "arshon"})
        CHECK(holds(run("gallery").out, std::string("\n") + name + " "));
}

TEST_CASE("files of Fractint, Walnut and Sage are systems") {
    const Scratch scratch;
    const std::string many = scratch.file(
        "two.l",
        "Koch {\n Angle 6\n Axiom F--F--F\n F=F+F--F+F\n}\nTwo {\n Angle 4\n Axiom F\n F=F+F\n}\n");
    CHECK(run("derive '" + many + ":Two' -n 2").out == "F+F+F+F\n");
    CHECK(holds(run("show '" + many + "'").err, "has several systems: Koch, Two; say which"));
    CHECK(holds(run("show '" + many + ":Tow'").err, "did you mean 'Two'?"));
    CHECK(run("convert '" + many + ":Koch' --to lsys").out ==
          "title Koch\naxiom F--F--F\nF -> F+F--F+F\nangle 60\n");
    CHECK(holds(run("convert koch --to l").out, "  Angle 6\n"));
    const std::string automaton =
        scratch.file("T.txt", "# Thue-Morse\nmsd_2\n0 0\n0 -> 0\n1 -> 1\n1 1\n0 -> 1\n1 -> 0\n");
    CHECK(run("derive '" + automaton + "' -n 3").out == "01101001\n");
    CHECK(holds(run("convert '" + automaton + "' --to sage").out, "WordMorphism('0->01,1->10')"));
    CHECK(run("derive - -n 2", "printf 'msd_2\\n0 0\\n* -> 0\\n' |").out == "0000\n");
    const std::string morphism = scratch.file("m.sage", "WordMorphism('a->ab,b->a')\n");
    CHECK(run("derive '" + morphism + "' -n 4").out == "abaababa\n");
}

TEST_CASE("growth reads and writes b-files of the OEIS") {
    const Scratch scratch;
    const Run written = run("growth fibonacci -n 0..30 --b-file");
    CHECK(written.out.starts_with("0 1\n1 1\n2 2\n3 3\n4 5\n"));
    const std::string file = scratch.file("b.txt", written.out);
    const Run read = run("growth --realise '" + file + "'");
    CHECK(read.status == 0);
    CHECK(holds(read.out, "a(n) = a(n-1) + a(n-2)"));
    CHECK(holds(read.out, "31 terms"));
    const std::string wrong = scratch.file("w.txt", "0 1\n1 x\n");
    CHECK(holds(run("growth --realise '" + wrong + "'").err,
                "w.txt:2:3: error: expected a(n), a whole number, found 'x'"));
    CHECK(run("growth fibonacci --b-file").status == 2);
}

TEST_CASE("equal --as growth compares lengths with a b-file of the OEIS") {
    const Scratch scratch;
    const std::string terms =
        scratch.file("b.txt", "# lengths\n" + run("growth fibonacci -n 0..40 --b-file").out);
    const Run same = run("equal fibonacci '" + terms + "' --as growth");
    CHECK(same.status == 0);
    CHECK(same.out == "equal: generations 0 to 40 have the lengths that are in " + terms +
                          "; it says nothing of later ones\n");
    CHECK(run("equal '" + terms + "' fibonacci --as growth").status == 0);
    const json witness =
        json::parse(run("equal fibonacci '" + terms + "' --as growth --json").out)["witness"];
    CHECK(witness["from"] == 0);
    CHECK(witness["to"] == 40);
    // The sequence itself, 0 1 1 2 3 5 ..., of which the lengths are those from the second on.
    const std::string moved = scratch.file("m.txt", "0 0\n1 1\n2 1\n3 2\n4 3\n5 5\n6 8\n7 13\n");
    const Run other = run("equal fibonacci '" + moved + "' --as growth");
    CHECK(other.status == 1);
    CHECK(holds(other.out, "different: generation 0 has 1 letter, and a(0) is 0 in "));
    CHECK(holds(other.out, "generation n has a(n+1) letters, as far as the file goes"));
    const json found = json::parse(run("equal fibonacci '" + moved + "' --as growth --json").out);
    CHECK(found["verdict"] == "different");
    CHECK(found["witness"]["shift"] == 1);
    CHECK(found["witness"]["lengths"] == json{1, 0});
    // From another n on, and one that is wrong at the end.
    CHECK(run("equal fibonacci '" + scratch.file("k.txt", "3 3\n4 5\n") + "' --as growth").status ==
          0);
    const std::string wrong = scratch.file("w.txt", "0 1\n1 1\n2 2\n3 3\n4 5\n5 9\n");
    CHECK(holds(run("equal fibonacci '" + wrong + "' --as growth").out,
                "different: generation 5 has 8 letters, and a(5) is 9"));
    const std::pair<std::string, std::string> malformed[] = {
        {"0 1\n2 2\n", ":2:1: error: expected the term of n = 1, found n = 2"},
        {"0 1\n1 1.5\n", ":2:3: error: expected a(n), a whole number, found '1.5'"},
        {"0 1\n1\n", ":2:1: error: expected a line `n a(n)`, found 1 piece"},
        {"0 1\n1 1 1\n", ":2:5: error: expected a line `n a(n)`, found 3 pieces"},
        {"-1 1\n0 1\n",
         ": expected terms from n = 0 on, as generations begin with 0; found n = -1"},
    };
    for (const auto& [text, message] : malformed) {
        const std::string file = scratch.file("bad.txt", text);
        const Run refused = run("equal fibonacci '" + file + "' --as growth");
        INFO(refused.err);
        CHECK(refused.status == 2);
        CHECK(holds(refused.err, file + message));
    }
    CHECK(holds(run("equal fibonacci '" + terms + "'").err,
                "is a b-file, which holds lengths: expected --as growth with it"));
    CHECK(holds(run("equal '" + moved + "' '" + terms + "' --as growth").err,
                "are b-files: expected a system and a b-file"));
    CHECK(holds(run("show '" + terms + "'").err,
                "looks like a b-file of the OEIS, which `algae growth --realise`"));
    CHECK(holds(run("equal fibonacci '" + terms + "' --as growth --certificate x.json").err,
                "there is no proof to write"));
}
