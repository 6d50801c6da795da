#include <doctest/doctest.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "command/run.hpp"

using nlohmann::json;

namespace {

const std::string koch = "title Koch\naxiom F\nF -> F+F--F+F\nangle 60\n";
const std::string terdragon = "title Terdragon\naxiom F\nF -> F+F-F\nangle 120\n";
const std::string straight = "axiom A\nA -> AB\nB -> B\n";

}  // namespace

TEST_CASE("the table has a line for every system of a folder, and says why others have none") {
    const Scratch scratch;
    scratch.file("koch.lsys", koch);
    scratch.file("terdragon.lsys", terdragon);
    scratch.file("words.lsys", straight);
    const std::string folder = "'" + scratch.path().string() + "'";
    const Run shown = run("dimension --table " + folder + " --quick");
    CHECK(shown.status == 0);
    CHECK(shown.out.find("koch       log 4 / log 3                             1.261860\n") !=
          std::string::npos);
    CHECK(shown.out.find(
              "terdragon  log 3 / log sqrt 3 = 2                    2.000000  1.261860\n") !=
          std::string::npos);
    CHECK(shown.out.find("\nno formula:\nwords  ") != std::string::npos);

    const json found = json::parse(run("dimension --table " + folder + " --quick --json").out);
    REQUIRE(found.size() == 3);
    CHECK(found[0]["name"] == "koch");
    CHECK(found[0]["title"] == "Koch");
    CHECK(found[0]["exact"]["formula"] == "log 4 / log 3");
    CHECK(found[1]["exact"]["boundary"]["formula"] == "log 2 / log sqrt 3");
    CHECK(found[2]["exact"]["status"] == "none");
    CHECK(!found[0].contains("measured"));
}

TEST_CASE("the table measures, and gives the difference") {
    const Scratch scratch;
    scratch.file("koch.lsys", koch);
    const std::string folder = "'" + scratch.path().string() + "'";
    const json found = json::parse(run("dimension --table " + folder + " --grids 4 --json").out);
    CHECK(found[0]["measured"]["low"] <= 1.26186);
    CHECK(found[0]["measured"]["high"] >= 1.26185);
    CHECK(std::abs(found[0]["difference"].get<double>()) < 0.05);
    CHECK(run("dimension --table " + folder).out.find(" in [1.2") != std::string::npos);
}

TEST_CASE("curves that the time does not suffice for are unfinished, and not without a formula") {
    const std::string over = "the time allowed by --timeout is over";
    const Run shown = run("dimension --table --quick --timeout 0.001");
    CHECK(shown.status == 3);
    const std::size_t without = shown.out.find("\nno formula:\n"),
                      unfinished = shown.out.find("\nunfinished:\n");
    REQUIRE(unfinished != std::string::npos);
    CHECK(shown.out.find(over) > unfinished);
    CHECK(shown.out.find("gosper", unfinished) != std::string::npos);
    if (without != std::string::npos) CHECK(without < unfinished);

    for (const char* quick : {" --quick", ""}) {
        const Run listed = run("dimension --table --timeout 0.001 --json" + std::string(quick));
        CHECK(listed.status == 3);
        std::size_t late = 0;
        for (const json& row : json::parse(listed.out)) {
            const bool is_late = row["exact"]["conditions"].dump().find(over) != std::string::npos;
            CHECK(is_late == (row["exact"]["status"] == "unfinished"));
            late += is_late ? 1 : 0;
        }
        CHECK(late > 10);
    }
    // Those that are done in time have their line, and the rest has none: 0.3 seconds are enough for some
    // curves, or for all; on a busy machine not even for the reading of the gallery.
    const Run some = run("dimension --table --quick --timeout 0.3");
    if (some.out.empty()) {
        CHECK(some.status == 3);
        return;
    }
    CHECK(some.status == (some.out.find("\nunfinished:\n") == std::string::npos ? 0 : 3));
    CHECK((some.out.find(over) == std::string::npos) == (some.status == 0));
}

TEST_CASE("a search that takes long leaves its bound in the table, and time for the others") {
    const Scratch scratch;
    // Plant c at 60 degrees: a search of half a minute.
    scratch.file("a-plant.lsys", "axiom F\nF -> FF-[-F+F+F]+[+F-F-F]\nangle 60\n");
    scratch.file("koch.lsys", koch);
    const std::string folder = "'" + scratch.path().string() + "'";
    const Run listed = run("dimension --table " + folder + " --quick --json --timeout 4");
    CHECK(listed.status == 3);
    const json found = json::parse(listed.out);
    REQUIRE(found.size() == 2);
    CHECK(found[0]["exact"]["status"] == "unfinished");
    CHECK(found[0]["exact"]["at_most"]["formula"] == "log 8 / log 2 = 3");
    CHECK(found[0]["exact"]["at_most"]["value"] == 2);
    CHECK(found[0]["exact"]["conditions"].dump().find("whether parts coincide is not known") !=
          std::string::npos);
    CHECK(found[1]["exact"]["formula"] == "log 4 / log 3");
    const Run shown = run("dimension --table " + folder + " --quick --timeout 4");
    CHECK(shown.status == 3);
    const std::size_t unfinished = shown.out.find("\nunfinished:\na-plant ");
    REQUIRE(unfinished != std::string::npos);
    CHECK(shown.out.find("<=2.000000", unfinished) != std::string::npos);
    CHECK(shown.out.find("whether parts coincide is not known", unfinished) != std::string::npos);
}

TEST_CASE("rows of a table are there before the next ones are") {
    const Scratch scratch;
    scratch.file("a-koch.lsys", koch);
    scratch.file("plant.lsys", "axiom F\nF -> FF-[-F+F+F]+[+F-F-F]\nangle 60\n");
    const std::string command = "exec '" + built_command() + "' dimension --table '" +
                                scratch.path().string() + "' --quick --json --timeout 20";
    FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe);
    const auto begin = std::chrono::steady_clock::now();
    std::string text;
    for (int c = 0;
         text.find("log 4 / log 3") == std::string::npos && (c = std::fgetc(pipe)) != EOF;)
        text += static_cast<char>(c);
    const auto first = std::chrono::steady_clock::now() - begin;
    CHECK(text.find("log 4 / log 3") != std::string::npos);
    for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
    pclose(pipe);
    CHECK(json::parse(text).size() == 2);
    // The search of the second row takes a third of the time.
    CHECK(std::chrono::steady_clock::now() - begin - first > std::chrono::seconds(4));
}

TEST_CASE("the table refuses what it cannot be made of") {
    const auto message = [](const std::string& arguments) {
        const Run refused = run("dimension " + arguments);
        CHECK(refused.status == 2);
        return refused.err;
    };
    const Scratch scratch;
    CHECK(message("--table '" + scratch.path().string() + "'")
              .find("expected .lsys files in this folder") != std::string::npos);
    CHECK(message("--table koch") ==
          "algae: koch: expected a folder with .lsys files for --table\n");
    CHECK(message("koch --quick") == "algae: --quick is for --table\n");
    CHECK(message("") == "algae: dimension: expected FILE, or --table\n");
}
