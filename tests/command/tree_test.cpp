#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

namespace {

const std::string fibonacci = "printf 'axiom b; a -> ab; b -> a' |";
const std::string tables = "printf 'axiom a; table s; a -> ab; table t; a -> b; b -> bb' |";
const std::string choices = "printf 'axiom ab; a -> a; a -> aa; b -> ; b -> b' |";

}  // namespace

TEST_CASE("tree draws a generation in every format, once complete") {
    const Scratch folder;
    const std::pair<const char*, const char*> beginnings[] = {
        {"svg", "<?xml"}, {"pdf", "%PDF"},    {"png", "\x89PNG"}, {"ps", "%!PS"},
        {"eps", "%!PS"},  {"dot", "digraph"}, {"gv", "digraph"}};
    for (const auto& [end, beginning] : beginnings) {
        const std::string path = folder.file(std::string("t.") + end);
        const Run drawn = run("tree - -n 5 --json -o '" + path + "'", fibonacci);
        CHECK(drawn.status == 0);
        CHECK(text_of(path).starts_with(beginning));
        const auto facts = nlohmann::json::parse(drawn.out);
        CHECK(facts["nodes"] == 20);
        CHECK(facts["edges"] == 19);
        CHECK(facts["depth"] == 5);
        CHECK(facts["generation"] == 5);
        CHECK(facts["output"] == path);
    }
    CHECK(folder.size() == 7);
    CHECK(run("tree - -n 3 -o - --format dot", fibonacci).out.starts_with("digraph"));
    CHECK(run("tree - -n 3 -o - --format SVG --width 300", fibonacci).out.starts_with("<?xml"));
    CHECK(run("tree - -n 3 -o /no-such-folder/t.pdf", fibonacci).status == 2);
}

TEST_CASE("tree draws the derivation of a member") {
    const auto facts = nlohmann::json::parse(
        run("tree - --word aaa --json -o /dev/null --format svg", choices).out);
    CHECK(facts["generation"] == 2);
    CHECK(facts["nodes"] == 2 + 3 + 3);  // ab, aa ε, aaa
    CHECK(facts["edges"] == 6);
    const Run none = run("tree - --word bb -o /dev/null --format svg", choices);
    CHECK(none.status == 2);
    CHECK(none.err == "algae: --word: bb is not in the language, `algae member` says why\n");
    const std::string terminals = "printf 'axiom S; terminals a; S -> SS; S -> a' |";
    CHECK(nlohmann::json::parse(
              run("tree - --word aa --json -o /dev/null --format svg", terminals).out)["nodes"] ==
          5);
    CHECK(run("tree - --word S -o /dev/null --format svg", terminals).status == 2);
    CHECK(run("tree - --word 'A(1)' -o /dev/null --format svg", choices).status == 2);
}

namespace {

nlohmann::json facts_of(const std::string& options, const std::string& before) {
    return nlohmann::json::parse(
        run("tree - --json -o /dev/null --format svg " + options, before).out);
}

/// The labels of the nodes in Graphviz's language, in their order.
std::string labels(const std::string& options, const std::string& before) {
    const std::string dot = run("tree - -o - --format dot " + options, before).out;
    std::string found;
    for (std::size_t at = 0; (at = dot.find("label=", at)) != std::string::npos;) {
        at += 6;
        const bool quoted = dot[at] == '"';
        const std::size_t from = at + quoted, to = dot.find_first_of(quoted ? "\"" : ",]", from);
        found += dot.substr(from, to - from) + ' ';
    }
    return found;
}

}  // namespace

TEST_CASE("tree draws modules with their exact parameters") {
    const std::string thirds = "printf 'axiom A(1); A(x) : x > 0.2 -> A(x/3)B' |";
    CHECK(labels("-n 3", thirds) == "A(1) A(1/3) B A(1/9) B B A(1/9) B B ");
    CHECK(run("derive - -n 3", thirds).out == "A(1/9)BB\n");
    const auto facts = facts_of("-n 3", thirds);
    CHECK(facts["nodes"] == 9);
    CHECK(facts["contexts"] == 0);
    CHECK_FALSE(facts.contains("seed"));
    CHECK(facts_of("-n 3 --dag", thirds)["nodes"] == 7);
    CHECK(facts_of("-n 3 --depth 1", thirds)["nodes"] == 5);
    const Run large =
        run("tree - -n 60 -o /dev/null --format svg", "printf 'axiom A(1); A(x) -> A(x+1)A(x)' |");
    CHECK(large.status == 3);
    CHECK(large.err ==
          "algae: the tree has more nodes than can be counted, more than the 2000 of --max-nodes; "
          "--depth 9 has 1535\n");
    CHECK(facts_of("-n 60 --depth 3", "printf 'axiom A(1); A(x) -> A(x+1)A(x)' |")["nodes"] == 23);
}

TEST_CASE("tree draws the derivation that derive picks by the same seed") {
    const std::string system =
        "printf 'axiom a; a -(1/2)-> ab; a -(1/2)-> ba; b -(1/3)-> a; "
        "b -(2/3)-> bb' |";
    for (const char* seed : {"1", "2", "7"}) {
        const std::string options = std::string("-n 4 --seed ") + seed;
        std::string word = run("derive - " + options, system).out, last;
        word.pop_back();
        for (const char letter : labels(options, system))
            if (letter != ' ') last += letter;
        CHECK(last.ends_with(word));
        CHECK(facts_of(options, system)["seed"] == std::stoi(seed));
    }
    CHECK(facts_of("-n 4", system)["seed"] == 1);
    CHECK(labels("-n 2", system) == labels("-n 2 --seed 1", system));
    // Rules without probabilities and tables are picked only if a seed is given.
    CHECK(facts_of("-n 3 --seed 4", choices)["seed"] == 4);
    CHECK(facts_of("-n 3 --seed 4", tables)["tables"].size() == 3);
}

TEST_CASE("tree names the tables of the steps") {
    CHECK(facts_of("-n 3 --tables sts", tables)["tables"] == nlohmann::json({"s", "t", "s"}));
    CHECK(labels("-n 3 --tables sts", tables) == "a a b b b b b b b ");
    const std::string scheduled =
        "printf 'axiom a; table s; a -> ab; table t; a -> b; b -> bb; schedule s s t' |";
    CHECK(facts_of("-n 4", scheduled)["tables"] == nlohmann::json({"s", "s", "t", "s"}));
    CHECK(
        run("tree - -n 2 --tables st -o - --format dot", tables).out.find("comment=\"table t\"") !=
        std::string::npos);
}

TEST_CASE("tree draws contexts as thin arcs") {
    const std::string signal = "printf 'axiom baaa; b < a -> b; b -> a' |";
    const auto facts = facts_of("-n 3", signal);
    CHECK(facts["nodes"] == 16);
    CHECK(facts["edges"] == 12);
    CHECK(facts["contexts"] == 3);
    CHECK(labels("-n 3", signal) == "b a a a a b a a a a b a a a a b ");
    const std::string dot = run("tree - -n 1 -o - --format dot", signal).out;
    CHECK(dot.find("penwidth=0.5") != std::string::npos);
    CHECK(dot.find("gray60") != std::string::npos);
    const Scratch folder;
    for (const char* end : {"svg", "pdf", "png", "ps", "eps", "dot"})
        for (const char* shape : {"", " --dag", " --depth 1"}) {
            const std::string file = folder.file(std::string("t.") + end);
            CHECK(run("tree - -n 3 -o " + file + shape, signal).status == 0);
            CHECK(!text_of(file).empty());
        }
}

TEST_CASE("tree merges, cuts, and refuses what is too large with its size") {
    const auto facts = [](const std::string& options) {
        return nlohmann::json::parse(
            run("tree - -o /dev/null --format dot --json " + options, fibonacci).out);
    };
    CHECK(facts("-n 30 --dag")["nodes"] == 60);
    CHECK(facts("-n 30 --depth 6")["nodes"] == 33 + 13);
    CHECK(facts("-n 30 --depth 6")["depth"] == 6);
    CHECK(facts("-n 13 --max-nodes 986")["nodes"] == 986);
    const Run large = run("tree - -n 30 -o /dev/null --format svg", fibonacci);
    CHECK(large.status == 3);
    CHECK(large.err ==
          "algae: the tree has 3524577 nodes, more than the 2000 of --max-nodes; --depth 13 has "
          "1363; --dag has 60\n");
    const Run vast =
        run("tree - -n 1000000000000000 -o /dev/null --format svg", "printf 'axiom a; a -> aa' |");
    CHECK(vast.status == 3);
    CHECK(vast.err ==
          "algae: the tree has more nodes than can be counted, more than the 2000 of --max-nodes; "
          "--depth 9 has 1535; "
          "--dag has 1000000000000001\n");
    CHECK(run("tree - -n 1000000000000000 --depth 2 -o /dev/null --format svg",
              "printf 'axiom a; a -> aa' |")
              .status == 0);
}

TEST_CASE("tree draws the digraph of growth and the families") {
    const auto growth =
        nlohmann::json::parse(run("tree koch --graph --json -o /dev/null --format svg").out);
    CHECK(growth["nodes"] == 3);
    CHECK(growth["edges"] == 5);
    const auto families =
        nlohmann::json::parse(run("tree --families --json -o /dev/null --format pdf").out);
    CHECK(families["nodes"] == 14);
    CHECK(families["edges"] == 19);
    CHECK(run("tree koch --graph --max-nodes 2 -o /dev/null --format svg").err ==
          "algae: the digraph has 3 letters, more than the 2 of --max-nodes\n");
}

TEST_CASE("tree draws Rauzy graphs") {
    const auto asked = [](const std::string& options) {
        return nlohmann::json::parse(
            run("tree " + options + " --json -o /dev/null --format svg").out);
    };
    CHECK(asked("thue-morse --rauzy 4")["nodes"] == 10);
    CHECK(asked("thue-morse --rauzy 4")["edges"] == 12);
    // A Sturmian word has n + 1 factors, and one that is left special and one that is right special.
    CHECK(asked("fibonacci --rauzy 30 --reduced")["nodes"] == 2);
    CHECK(asked("fibonacci --rauzy 30 --reduced")["edges"] == 3);
    CHECK(asked("fibonacci --rauzy 1..5")["nodes"] == 2 + 3 + 4 + 5 + 6);
    // After its coding: 4, 8 and 16 factors of 2, 3 and 4 letters.
    CHECK(asked("rudin-shapiro --rauzy 3")["nodes"] == 8);
    CHECK(asked("rudin-shapiro --rauzy 3")["edges"] == 16);
    const std::string dot = run("tree fibonacci --rauzy 2 --reduced -o - --format dot").out;
    for (const char* part : {"label=ba", "label=ab", "n0 -> n1", "n1 -> n0"}) {
        INFO(part);
        CHECK(dot.find(part) != std::string::npos);
    }
    const Run film = run("tree fibonacci --rauzy 1..3 -o - --format gif");
    CHECK(film.out.starts_with("GIF89a"));
    CHECK(run("tree fibonacci -n 3 -o t.gif").err.find("expected a file ending in .svg") !=
          std::string::npos);
    CHECK(run("tree thue-morse --rauzy 4 --max-nodes 9 -o /dev/null --format svg").err ==
          "algae: the graph has 12 edges up to factors of 5 letters, more than the 9 of "
          "--max-nodes; --reduced draws special ones\n");
    CHECK(run("tree - --rauzy 3 -o t.svg", "printf 'axiom a; a -> b; b -> a' |").err ==
          "algae: --rauzy: expected a number of letters below that of the longest word\n");
}

TEST_CASE("tree says what is wrong with what was asked") {
    const auto refused = [](const std::string& options, const std::string& before,
                            const std::string& message) {
        const Run asked = run("tree " + options, before);
        INFO(options);
        CHECK(asked.status == 2);
        CHECK(asked.err.find(message) != std::string::npos);
        CHECK(asked.out.empty());
    };
    refused("- -o t.svg", fibonacci,
            "say which tree: -n N for a generation, --word WORD for a member");
    refused("- -n 3 --graph -o t.svg", fibonacci,
            "-n, --word, --graph, --rauzy and --families exclude each other");
    refused("-n 3 -o t.svg", "", "FILE is missing");
    refused("koch --families -o t.svg", "",
            "--families draws families of languages and takes no FILE, found \"koch\"");
    refused("koch --graph --reduced -o t.svg", "", "--reduced is for Rauzy graphs: --rauzy N");
    refused("koch --rauzy x -o t.svg", "", "--rauzy: expected");
    refused("- --rauzy 2 -o t.svg", choices, "");
    refused("koch --graph --dag -o t.svg", "", "--dag and --depth are for trees");
    refused("- -n 3 -o t.gif", fibonacci,
            "expected a file ending in .svg, .pdf, .png, .ps, .eps, .tex, .dot or .gv, found "
            "\"t.gif\"");
    refused("- -n 3 -o tree", fibonacci, "expected a file ending in .svg");
    refused("- -n 3 -o -", fibonacci, "-o -: say which format with --format");
    refused("- -n x -o t.svg", fibonacci, "-n: expected a whole number from 0 on, found \"x\"");
    refused("- -n 3 --depth -1 -o t.svg", fibonacci, "--depth");
    refused("- -n 3 --max-nodes 1.5 -o t.svg", fibonacci, "--max-nodes: expected a whole number");
    refused("- -n 3 --width 5 -o t.svg", fibonacci,
            "the width must be from 10 to 14400 points in svg, not 5");
    refused("- -n 3 -o t.svg", choices, "--word draws the derivation of one word");
    refused("- -n 3 -o t.svg", choices, "--seed one picked at random");
    refused("- --word aaa --seed 3 -o t.svg", choices,
            "--seed and --tables go with -n: they say how the generation is derived");
    refused("- --word aaa --tables st -o t.svg", choices, "--seed and --tables go with -n");
    refused("- -n 2 -o t.svg", tables,
            "it has 2 tables and no schedule; say --tables SEQUENCE, or --seed S for random ones");
    refused("- -n 2 --tables s -o t.svg", tables,
            "--tables: expected a table for each of 2 steps, found 1");
    refused("- -n 2 --tables sx -o t.svg", tables, "expected a table (s, t, or a number");
    refused("- --word b -o t.svg", "printf 'axiom ab; a < b -> c' |",
            "--word: b is not in the language");
    refused("- --word b -o t.svg", "printf 'axiom A(1); A(x) -> b' |",
            "-n draws the tree of a generation");
    refused("- -n 1 -o t.svg", "printf 'axiom A(1); A(x) : x > 0 -> B; A(x) -> C' |",
            "matches too");
    refused("- -n 1 -o t.svg", "printf 'axiom A(1); A(x) -> B(1/(x-1))' |", "division by 0");
    refused("- -n 1 -o t.svg", "printf 'axiom F?P(0,0)' |",
            "it has communication modules, which an environment fills between two steps");
    refused("- --graph -o t.svg", choices, "");
    refused("no-such-system -n 3 -o t.svg", "", "nothing of that name in the gallery");
    CHECK(run("tree - -n 2000 --max-nodes 100000000 --timeout 0.001 -o /dev/null --format svg",
              "printf 'axiom a; a -> ab' |")
              .status == 3);
}
