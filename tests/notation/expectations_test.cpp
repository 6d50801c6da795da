#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "model/model.hpp"

#include "notation/notation.hpp"
#include "places.hpp"

using namespace algae;
namespace fs = std::filesystem;

namespace {

Model read_file(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return read_lsystem(text.str(), path.filename().string());
}

std::size_t check_folder(const std::string& folder) {
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".lsys") continue;
        ++files;
        const Model system = read_file(entry.path());
        CAPTURE(system.name);
        CHECK(!system.expectations.empty());
        for (const Mismatch& unmet : unmet_expectations(system))
            FAIL_CHECK(to_string(unmet.place), ": ", unmet.message);
    }
    return files;
}

std::string first_unmet(const std::string& text) {
    const auto unmet = unmet_expectations(read_lsystem(text, "x.lsys"));
    return unmet.empty() ? "" : to_string(unmet.front().place) + ": " + unmet.front().message;
}

}  // namespace

TEST_CASE("every figure comes out as its file expects") {
    CHECK(check_folder(source_folder() + "/figures") >= 60);
}

TEST_CASE("every system that is no figure comes out as its file expects") {
    CHECK(check_folder(source_folder() + "/systems") >= 20);
}

TEST_CASE("an expectation that does not hold says what was found") {
    const std::string koch = "axiom F\nF -> F+F--F+F\nangle 60\n";
    CHECK(first_unmet(koch + "expect length 3: 149\n") ==
          "x.lsys:4:1: expected length 3: 149, found 148");
    CHECK(first_unmet(koch + "expect word 1: F+F-F+F\n") ==
          "x.lsys:4:1: expected word 1: F+F-F+F, found F+F--F+F");
    CHECK(first_unmet(koch + "expect segments 3: 63\n") ==
          "x.lsys:4:1: expected segments 3: 63, found 64");
    CHECK(first_unmet(koch + "expect distinct 3: 63\n") ==
          "x.lsys:4:1: expected distinct 3: 63, found 64");
    CHECK(first_unmet(koch + "expect vertices 3: 64\n") ==
          "x.lsys:4:1: expected vertices 3: 64, found 65");
    CHECK(first_unmet(koch + "expect end 3: 27 1\n") ==
          "x.lsys:4:1: expected end 3: 27 1, found 27 0");
    CHECK(first_unmet(koch + "expect box 1: 0 0 3 0.867\n") ==
          "x.lsys:4:1: expected box 1: 0 0 3 0.867, found 0 0 3 0.866");
    CHECK(first_unmet("axiom a\na -> a\na -> aa\nexpect lengths 1: 1,3\n") ==
          "x.lsys:4:1: expected lengths 1: 1,3, found 1,2");
    CHECK(first_unmet(koch + "expect box 1: 0 0 3 0.866\n").empty());
}

TEST_CASE("an expectation that cannot be answered is not met") {
    CHECK(first_unmet("axiom a\na -> a\na -> aa\nexpect length 1: 1\n")
              .find("found no answer: not a D0L system: a has 2 rules") != std::string::npos);
}

TEST_CASE("words with parameters are compared letter by letter, numbers as they are written") {
    const std::string modules =
        "axiom B(2)A(4,4)\nA(x,y) : y <= 3 -> A(2*x,x+y)\nA(x,y) : y > 3 -> B(x)A(x/y,0)\n"
        "B(x) : x < 1 -> C\nB(x) : x >= 1 -> B(x-1)\n";
    CHECK(first_unmet(modules + "expect word 1: B(1) B(4) A(1, 0)\n") == "");
    CHECK(first_unmet(modules + "expect word 5: CB(0)B(8)A(8/7,0)\n") == "");
    CHECK(first_unmet(modules + "expect word 5: CB(0)B(8)A(1.143,0)\n") == "");
    CHECK(
        first_unmet(modules + "expect word 5: CB(0)B(8)A(1.142,0)\n") ==
        "x.lsys:6:1: expected word 5: CB(0)B(8)A(1.142,0), found CB(0)B(8)A(1.1428571428571428,0)");
    CHECK(first_unmet(modules + "expect word 1: B(1)B(4)A(1)\n") != "");
    CHECK(first_unmet(modules + "expect word 1: B(1)B(4)A(1,0)C\n") != "");
    CHECK(first_unmet(modules + "expect length 5: 4\n") == "");
    CHECK(first_unmet(modules + "expect segments 5: 0\n") == "");
    CHECK(first_unmet("axiom F(1)\nF(x) -> F(x/2)[+(60)F(x/4)]\nexpect end 2: 0.25 0\nexpect box "
                      "1: 0 0 0.625 0.217\n") == "");
}

TEST_CASE("of a system with choices the expected word is that of its first seed") {
    const std::string plant = "axiom F\nF -(1/2)-> F[+F]\nF -(1/2)-> FF\n";
    const std::string of_one = first_unmet(plant + "expect word 4: F\n"),
                      of_two = first_unmet(plant + "seed 2\nexpect word 4: F\n");
    CHECK(of_one.substr(of_one.find("found")) != of_two.substr(of_two.find("found")));
    CHECK(of_one.substr(of_one.find("found")) == [&] {
        const auto said = first_unmet(plant + "seed 1..5\nexpect word 4: F\n");
        return said.substr(said.find("found"));
    }());
    CHECK(first_unmet("axiom a\na -> a\na -> aa\nseed 3\nexpect length 0: 1\n") == "");
    CHECK(first_unmet("axiom F; table a; F -> FF; table b; F -> F\nexpect length 1: 2\n")
              .find("no seed picks") != std::string::npos);
    CHECK(first_unmet("axiom F; table a; F -> F; F -> FF; schedule a\nexpect length 1: 1\n")
              .find("neither has a probability") != std::string::npos);
    const std::string scheduled = "axiom F; table a; F -> FF; table b; F -> F[+F]F; schedule b a\n";
    CHECK(first_unmet(scheduled + "expect word 3: F[+F]FF[+F]F[+F[+F]FF[+F]F]F[+F]FF[+F]F\n") ==
          "");
    CHECK(first_unmet(scheduled + "seed 5\nexpect word 2: FF[+FF]FF\nexpect segments 3: 18\n") ==
          "");
    CHECK(first_unmet(scheduled + "expect segments 2: 5\n") ==
          "x.lsys:2:1: expected segments 2: 5, found 6");
}

TEST_CASE("what is expected of figures in space has three coordinates") {
    const std::string turns = "axiom F^(90)F(2)[F]&(90)+(90)F(2)|F(2)\n";
    CHECK(first_unmet(turns + "expect segments 0: 5\nexpect distinct 0: 4\nexpect vertices 0: 5\n"
                              "expect end 0: 1 0 2\nexpect box 0: 0 0 0 1 2 3") == "");
    CHECK(first_unmet(turns + "expect end 0: 1 0") ==
          "x.lsys:2:1: expected end 0: 1 0, found 1 0 2.000000");
    CHECK(first_unmet("axiom A(1,2,3)\nA -> I(B)\nexpect box 1: 0 -3 0 1 0 2") == "");
    CHECK(first_unmet("axiom &\nexpect box 0: 1") ==
          "x.lsys:2:1: expected box 0: 1, found nothing drawn");
}
