#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

TEST_CASE("growth --words says what the words have in common") {
    const Scratch scratch;
    const std::string file = scratch.file("fibonacci.lsys", "axiom a\na -> ab\nb -> a\n");
    const Run page = run("growth '" + file + "' --words");
    CHECK(page.status == 0);
    CHECK(page.out.starts_with("factors            1 2 3 4 5 6 7 8 "));
    CHECK(page.out.find("\nclass              n\n") != std::string::npos);
    CHECK(page.out.find("\npushy              no") != std::string::npos);
    CHECK(page.out.find("\nrepetitive         no") != std::string::npos);
    CHECK(page.out.find("\nlocally catenative w(n) = w(n-1) w(n-2) for n >= 2: ") !=
          std::string::npos);
    const auto object = nlohmann::json::parse(run("growth '" + file + "' --words --json").out);
    CHECK(object.at("factor_complexity").at(20) == 21);
    CHECK(object.at("infinite_word") == true);
    CHECK(object.at("complexity_class").at("at_most") == "n");
    CHECK(object.at("locally_catenative").at("back") == std::vector<int>{1, 2});
}

TEST_CASE("growth --words names what is pushed and repeated") {
    const Scratch scratch;
    const std::string file = scratch.file("thread.lsys", "axiom a\na -> ab\nb -> bc\n");
    const Run page = run("growth '" + file + "' --words");
    CHECK(page.status == 0);
    CHECK(page.out.find("\nclass              n^2\n") != std::string::npos);
    CHECK(page.out.find(
              "\npushy              yes: b leads to ...b c in 1 step, and c does not grow\n") !=
          std::string::npos);
    CHECK(page.out.find("\nrepetitive         yes: all powers of c are factors\n") !=
          std::string::npos);
}

TEST_CASE("growth --words needs a D0L system") {
    const Scratch scratch;
    const Run refused =
        run("growth '" + scratch.file("two.lsys", "axiom a\na -> ab\na -> b\n") + "' --words");
    CHECK(refused.status == 2);
    CHECK(refused.err.find("a has 2 rules") != std::string::npos);
}

TEST_CASE("growth --words refuses what it does not heed") {
    const Run generation = run("growth fibonacci --words -n 0..60");
    CHECK(generation.status == 2);
    CHECK(generation.err ==
          "algae: --words does not go with -n (`algae words --to N` has factors of N letters)\n");
    const Run coding = run("growth rudin-shapiro --words");
    CHECK(coding.status == 2);
    CHECK(coding.err ==
          "algae: rudin-shapiro: expected a system without a coding for --words, found one with a "
          "coding; `algae words rudin-shapiro` counts the factors after it\n");
}
