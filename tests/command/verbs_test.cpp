#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

TEST_CASE("show has the keys that programs rely on") {
    const json shown = json::parse(run("show koch --json").out);
    CHECK(shown["class"] == "PD0L");
    CHECK(shown["alphabet"] == json({"F", "+", "-"}));
    CHECK(shown["axiom"] == "F");
    CHECK(shown["rules"] == json({"F -> F+F--F+F"}));
    CHECK(shown["deterministic"] == true);
    CHECK(shown["propagating"] == true);
    CHECK(shown["stochastic"] == false);
    CHECK(shown["parametric"] == false);
    CHECK(shown["bracketed"] == false);
    CHECK(shown["context"] == json({0, 0}));
    CHECK(shown["tables"] == json::array());
    CHECK(shown["terminals"] == json::array());
}

TEST_CASE("show names the class of every kind of system") {
    const auto class_of = [](const std::string& system) {
        return json::parse(run("show - --json", "printf '" + system + "' |").out)["class"]
            .get<std::string>();
    };
    CHECK(class_of("axiom a; a -> ab; b -> ") == "D0L");
    CHECK(class_of("axiom a; a -> a; a -> aa") == "P0L");
    CHECK(class_of("axiom a; a -> a; a -> ") == "0L");
    CHECK(class_of("axiom F; F -(1/3)-> F; F -(2/3)-> FF") == "PS0L");
    CHECK(class_of("axiom a; table one; a -> b; table two; a -> c") == "PDT0L");
    CHECK(class_of("axiom S; S -> a; S -> SS; terminals a") == "EP0L");
    CHECK(class_of("axiom baaa; b < a -> b; b -> a") == "PD(1,0)L");
    CHECK(class_of("axiom B(2)A(4,4); A(x,y) : y <= 3 -> A(x*2, x+y); B(x) : x < 1 -> C") ==
          "parametric PD0L");
}

TEST_CASE("show says of parametric rules whether they exclude each other") {
    const auto line = [](const std::string& system, const std::string& label) {
        const std::string page = run("show -", "printf '" + system + "' |").out;
        const std::size_t at = page.find(label);
        return at == std::string::npos ? "" : page.substr(at, page.find('\n', at) - at);
    };
    const auto deterministic = [&](const std::string& rules) {
        return line("axiom A(1); " + rules, "deterministic");
    };
    CHECK(deterministic("A(x) : x < 2 -> A(x+1); A(x) : x >= 2 -> B") == "deterministic  yes");
    CHECK(deterministic("A(x) : x < 3 -> A(x+1); A(x) : x > 2 -> B") ==
          "deterministic  no: the rules at standard input:1:13 and standard input:1:37 both match "
          "A(2.5)");
    CHECK(deterministic("A(x) -> A(x+1); A(x) -> B") ==
          "deterministic  no: the rules at standard input:1:13 and standard input:1:29 both match "
          "A(0)");
    CHECK(deterministic("A(x) : x*x < 0 -> B; A(x) -> C") ==
          "deterministic  possibly: whether the rules at standard input:1:13 and standard "
          "input:1:34 can match the same module is not decided");
    CHECK(deterministic("B(y) < A(x) : y > x -> C; B(y) < A(x) -> A(x)") ==
          "deterministic  no: the rules at standard input:1:13 and standard input:1:39 both match "
          "B(1) < A(0)");
    CHECK(line("axiom A(1); A(x) : x*x < 0 -> B; A(x) -> C", "class") ==
          "class          parametric P0L");
    CHECK(line("axiom a; a -> b; a -> c", "deterministic") == "deterministic  no");
    const auto shown = [](const std::string& system) {
        return json::parse(run("show - --json", "printf '" + system + "' |").out);
    };
    const json both = shown("axiom A(1); A(x) : x < 3 -> A(x+1); A(x) : x > 2 -> B");
    CHECK(both["deterministic"] == false);
    CHECK(both["overlaps"].size() == 1);
    CHECK(both["overlaps"][0]["rules"] == json({"standard input:1:13", "standard input:1:37"}));
    CHECK(both["overlaps"][0]["match"] == "A(2.5)");
    const json open = shown("axiom A(1); A(x) : x*x < 0 -> B; A(x) -> C");
    CHECK(open["deterministic"].is_null());
    CHECK(open["overlaps"][0]["match"].is_null());
    CHECK(shown("axiom A(1); A(x) -> B")["overlaps"] == json::array());
}

TEST_CASE("show prints constants, and modules that no rule can match") {
    const std::string system =
        "printf 'let k = 1/3\nlet h = sqrt(k*6)\nlet d = k*3\naxiom A(1)\nA(x) -> A(x,h)A\n' |";
    const std::string page = run("show -", system).out;
    CHECK(page.find("constants      k = 1/3\n"
                    "               h = sqrt(k*6), about 1.4142135623730951\n"
                    "               d = k*3 = 1\n") != std::string::npos);
    CHECK(page.find("notes          no rule matches A(_,_): the rules for A take 1 parameter\n"
                    "               no rule matches A: the rules for A take 1 parameter\n") !=
          std::string::npos);
    const json shown = json::parse(run("show - --json", system).out);
    CHECK(shown["constants"][0] ==
          json({{"name", "k"}, {"written", "1/3"}, {"exact", "1/3"}, {"value", 1.0 / 3}}));
    CHECK(shown["constants"][1]["exact"].is_null());
    CHECK(shown["unmatched"][0] ==
          json({{"module", "A(_,_)"}, {"parameters", 2}, {"expected", {1}}}));
    CHECK(run("show koch").out.find("notes") == std::string::npos);
    CHECK(run("show koch").out.find("constants") == std::string::npos);
    // A system within has rules of its own.
    const json within = json::parse(run("show - --json",
                                        "printf 'axiom F(leaf(1)); system leaf { axiom A(1); A(x) "
                                        "-> A(x,1); A(y) : y > 3 -> B }' |")
                                        .out);
    CHECK(within["unmatched"].size() == 1);
    CHECK(within["overlaps"].size() == 1);
}

TEST_CASE("fmt prints the canonical form and can check it") {
    const Scratch scratch;
    const std::string file =
        scratch.file("loose.lsys", "# a remark\naxiom   F ;F->F F\nangle 60.0\n");
    const Run formatted = run("fmt " + file);
    CHECK(formatted.status == 0);
    CHECK(formatted.out.starts_with("# a remark\n"));
    CHECK(run("fmt --in-place koch").status == 2);
    CHECK(run("fmt --check " + file).status == 1);
    CHECK(run("fmt --in-place " + file).status == 0);
    CHECK(text_of(file) == formatted.out);
    CHECK(run("fmt --check " + file).status == 0);
}

TEST_CASE("letter finds letters without the word") {
    CHECK(run("letter koch -n 1 --at 4").out == "-\n");
    CHECK(run("letter koch -n 1 --at 0 --count 100").out == "F+F--F+F\n");
    CHECK(json::parse(run("letter koch -n 1 --at 2 --count 3 --json").out)["letters"] == "F--");
    const Run past = run("letter koch -n 1 --at 8");
    CHECK(past.status == 2);
    CHECK(past.err == "algae: position 8 is past the end: generation 1 has 8 letters\n");
    CHECK(run("letter koch -n 1 --at -3").status == 2);
    const std::string googol = "1" + std::string(100, '0');
    const Run far = run("letter fibonacci -n 1000000 --at " + googol);
    CHECK(far.status == 0);
    CHECK((far.out == "a\n" || far.out == "b\n"));
}

TEST_CASE("growth -n gives exact lengths") {
    CHECK(run("growth koch -n 6").out == "9556\n");
    CHECK(json::parse(run("growth koch -n 0..3 --json").out)["lengths"] == json({1, 8, 36, 148}));
    CHECK(json::parse(run("growth koch -n 100 --json").out)["lengths"][0].is_string());
    CHECK(run("growth koch -n 100000").out.size() == 60208);
    CHECK(run("growth koch -n 9000000000000").status == 3);
}

TEST_CASE("draw writes what the name's ending says and tells what it drew") {
    const Scratch scratch;
    const Run drawn = run("draw koch -n 3 --json -o " + scratch.file("koch.svg"));
    CHECK(drawn.status == 0);
    const json facts = json::parse(drawn.out);
    CHECK(facts["segments"] == 64);
    CHECK(facts["end"] == json({27.0, 0.0}));
    CHECK(facts["bounding_box"]["min"] == json({0.0, 0.0}));
    CHECK(facts["bounding_box"]["max"][0] == 27.0);
    CHECK(text_of(scratch.file("koch.svg")).find("<svg") != std::string::npos);
    CHECK(run("draw koch -n 0..3 -o " + scratch.file("pages.pdf")).status == 0);
    CHECK(run("draw koch -n 0..3 --panels --captions -o " + scratch.file("row.png")).status == 0);
    CHECK(run("draw koch -n 2 --format svg -o -").out.find("<svg") != std::string::npos);
}

TEST_CASE("draw leaves nothing behind when it fails") {
    const Scratch scratch;
    CHECK(run("draw koch -n 3 -o " + scratch.file("koch.jpeg")).status == 2);
    CHECK(run("draw koch -n 3 -o " + scratch.file("no/such/folder.svg")).status == 2);
    CHECK(run("draw koch -n 0..3 -o " + scratch.file("several.svg")).status == 2);
    CHECK(run("draw koch -n -1 -o " + scratch.file("koch.svg")).status == 2);
    CHECK(run("draw koch -n 99999999999999999999 -o " + scratch.file("koch.svg")).status == 2);
    CHECK(run("draw - -n 1 -o " + scratch.file("x.svg"), "printf 'axiom F; F -> F]' |").status ==
          2);
    CHECK(run("draw koch -n 30 --timeout 0.001 --width 20000 --height 20000 -o " +
              scratch.file("late.png"))
              .status == 3);
    CHECK(scratch.size() == 0);
}

TEST_CASE("a system with choices is drawn with a seed") {
    const Scratch scratch;
    const std::string system = "printf 'axiom F; F -> F[+F]F; F -> F[-F]F' |";
    CHECK(run("draw - -n 4 -o " + scratch.file("a.svg"), system).status == 2);
    CHECK(run("draw - -n 4 --seed 1 -o " + scratch.file("a.svg"), system).status == 0);
    CHECK(run("draw - -n 4 --seed 1 -o " + scratch.file("b.svg"), system).status == 0);
    CHECK(text_of(scratch.file("a.svg")) == text_of(scratch.file("b.svg")));
}

TEST_CASE("systems with parameters, probabilities and tables are drawn") {
    const Scratch scratch;
    const std::string tree = scratch.file(
        "tree.lsys", "axiom A(2)\nA(x) -> F(x)[+(45)A(x/2)][-(45)A(x/2)]\nstart 0 0 90\n");
    const json drawn =
        json::parse(run("draw " + tree + " -n 3 --json -o " + scratch.file("tree.pdf")).out);
    CHECK(drawn["segments"] == 7);
    CHECK(drawn["exact"] == false);
    CHECK(drawn["end"] == json({0, 2}));
    const std::string plant = scratch.file(
        "plant.lsys", "axiom F; F -(1/2)-> F[+F]; F -(1/2)-> FF; generation 3; seed 2..4\n");
    const json own =
        json::parse(run("draw " + plant + " --json -o " + scratch.file("own.svg")).out);
    REQUIRE(own["figures"].size() == 3);
    CHECK(own["figures"][0]["seed"] == 2);
    const json panel = json::parse(
        run("draw " + plant + " --seeds 2..2 --json -o " + scratch.file("one.svg")).out);
    CHECK(panel["segments"] == own["figures"][0]["segments"]);
    CHECK(panel["end"] == own["figures"][0]["end"]);
    CHECK(run("draw " + plant + " --seeds 1..9 --captions -o " + scratch.file("nine.png")).status ==
          0);
    CHECK(run("draw " + plant + " --seeds 1..9 --seed 1 -o " + scratch.file("nine.png")).status ==
          2);
    const std::string tables =
        scratch.file("tables.lsys", "axiom F; table a; F -> FF; table b; F -> F[+F]F\n");
    CHECK(run("draw " + tables + " -n 2 -o " + scratch.file("t.svg")).err.find("--tables") !=
          std::string::npos);
    CHECK(json::parse(run("draw " + tables + " -n 2 --tables ab --json -o " + scratch.file("t.svg"))
                          .out)["segments"] == 6);
    CHECK(run("draw " + tables + " -n 3 --tables ab -o " + scratch.file("t.svg")).status == 2);
}

TEST_CASE("figures draws a folder, tells what does not come out as expected, and is repeatable") {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path() / "in");
    scratch.file("in/good.lsys", "axiom F\nF -> FF\ngeneration 2\nexpect length 2: 4\n");
    scratch.file("in/wrong.lsys", "axiom F\nF -> FF\ngeneration 2\nexpect length 2: 5\n");
    const Run drawn = run("figures " + scratch.file("in") + " --out " + scratch.file("out"));
    CHECK(drawn.status == 1);
    CHECK(drawn.err.find("wrong.lsys:4:1: error: expected length 2: 5, found 4") !=
          std::string::npos);
    CHECK(drawn.out.find("2 systems, 4 pictures") != std::string::npos);
    const std::string before = text_of(scratch.file("out/good.pdf"));
    CHECK(run("figures " + scratch.file("in") + " --out " + scratch.file("out")).status == 1);
    CHECK(before == text_of(scratch.file("out/good.pdf")));
    CHECK(run("figures " + scratch.file("nowhere")).status == 2);
}

TEST_CASE("every verb has help with two examples, and bad usage ends with 2") {
    for (const std::string verb :
         {"show", "fmt", "derive", "letter", "growth", "draw", "figures", "gallery"}) {
        CAPTURE(verb);
        const Run help = run(verb + " --help");
        CHECK(help.status == 0);
        const auto first = help.out.find("  algae " + verb);
        CHECK(first != std::string::npos);
        CHECK(help.out.find("  algae " + verb, first + 1) != std::string::npos);
        CHECK(run(verb + " --no-such-option").status == 2);
    }
    CHECK(run("").status == 2);
    CHECK(run("drwa koch").err ==
          "algae: no verb drwa; did you mean 'draw'?; `algae --help` lists them\n");
    CHECK(run("--version").out.starts_with("algae 0."));
}

TEST_CASE("files that cannot be read are named") {
    const Scratch scratch;
    CHECK(run("show " + scratch.file("missing.lsys")).status == 2);
    CHECK(run("show " + scratch.path().string()).err.find("is a folder, expected a file") !=
          std::string::npos);
    CHECK(run("show " + scratch.file("nul.lsys", std::string("axiom F\0F\n", 10))).status == 2);
    CHECK(run("show " + scratch.file("bad.lsys", "axiom \xff\xfe\n")).status == 2);
    CHECK(run("show " + scratch.file("empty.lsys", "")).status == 2);
    const Run typo = run("show " + scratch.file("k.lsys", "axiom F\nF -> F+F]--F+F\n"));
    CHECK(typo.status == 2);
    CHECK(typo.err.find("k.lsys:2:9: error: unmatched ']'\n  F -> F+F]--F+F\n          ^\n") !=
          std::string::npos);
    const Run suggestion = run("show kohc");
    CHECK(suggestion.err.find("did you mean 'koch'?") != std::string::npos);
}

TEST_CASE("a file larger than its memory allows is refused, not read") {
    const Scratch scratch;
    const std::string file =
        scratch.file("large.lsys", "axiom " + std::string(200'000, 'F') + "\n");
    CHECK(run("show " + file + " --max-memory 1M").status == 3);
    CHECK(run("derive " + file + " -n 0").out.size() == 200'001);
    CHECK(run("show " + file).out.find("F ... (200000 letters)\n") != std::string::npos);
}
