#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

TEST_CASE("what --realise prints has the lengths that were asked for") {
    const Scratch scratch;
    for (const auto& [sequence, lengths] :
         {std::pair("1,1,2,3,5,8", "1\n1\n2\n3\n5\n8\n13\n"),
          std::pair("n^2+1", "1\n2\n5\n10\n17\n26\n37\n"),
          std::pair("a(n) = a(n-2) + a(n-3); 1, 1, 1", "1\n1\n1\n2\n2\n3\n4\n")}) {
        INFO(sequence);
        const Run realised = run(std::string("growth --realise '") + sequence + "'");
        CHECK(realised.status == 0);
        const Run read = run("growth '" + scratch.file("found.lsys", realised.out) + "' -n 0..6");
        CHECK(read.status == 0);
        CHECK(read.out == lengths);
    }
}

TEST_CASE("what cannot be realised is said with the reason and a status") {
    const Run square = run("growth --realise 'n^2'");
    CHECK(square.status == 1);
    CHECK(square.out.find("# there is no D0L system with these lengths: a(0) = 0 but a(1) = 1") !=
          std::string::npos);
    CHECK(square.out.find("\naxiom a\n") != std::string::npos);
    const Run few = run("growth --realise '1,2,4,9,3'");
    CHECK(few.status == 3);
    CHECK(few.out.find("# not known: the 5 terms determine no recurrence") != std::string::npos);
    const Run unreadable = run("growth --realise '2^n'");
    CHECK(unreadable.status == 2);
    CHECK(unreadable.err ==
          "algae: the sequence \"2^n\", place 3: expected an exponent written as a number, found "
          "\"n\"\n");
    CHECK(run("growth").status == 2);
}

TEST_CASE("--realise as one JSON object") {
    const auto object = nlohmann::json::parse(run("growth --realise '1,2,4,8,16' --json").out);
    CHECK(object.at("verdict") == "found");
    CHECK(object.at("sequence") == "a(n) = 2 a(n-1) for n >= 1; 1");
    CHECK(object.at("system") == "title lengths 1, 2, 4, 8, 16, 32, ...\naxiom a\na -> aa\n");
}

TEST_CASE("--realise refuses what it does not heed") {
    for (const std::string option :
         {"--let", "-n", "--counts", "--bounds", "--words", "--plot", "--latex"}) {
        INFO(option);
        const std::string value = option == "--let"    ? " k=3"
                                  : option == "-n"     ? " 3"
                                  : option == "--plot" ? " x.svg"
                                                       : "";
        const Run asked = run("growth --realise 1,2,4 " + option + value);
        CHECK(asked.status == 2);
        CHECK(asked.err == "algae: --realise does not go with " + option + "\n");
    }
    CHECK(run("growth koch --realise 1,2,4").err ==
          "algae: --realise stands instead of FILE, found both: \"koch\"\n");
}
