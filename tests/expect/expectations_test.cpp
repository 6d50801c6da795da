#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "expect/expectations.hpp"
#include "notation/read.hpp"

using namespace algae;
namespace fs = std::filesystem;

namespace {

LSystem read_file(const fs::path& path) {
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
        const LSystem system = read_file(entry.path());
        CAPTURE(system.name);
        CHECK(!system.expectations.empty());
        for (const Disappointment& unmet : unmet_expectations(system)) FAIL_CHECK(to_string(unmet.place), ": ", unmet.message);
    }
    return files;
}

std::string first_unmet(const std::string& text) {
    const auto unmet = unmet_expectations(read_lsystem(text, "x.lsys"));
    return unmet.empty() ? "" : to_string(unmet.front().place) + ": " + unmet.front().message;
}

}  // namespace

TEST_CASE("every figure comes out as its file expects") {
    CHECK(check_folder(ALGAE_SOURCE_DIR "/figures") >= 60);
}

TEST_CASE("every system that is no figure comes out as its file expects") {
    CHECK(check_folder(ALGAE_SOURCE_DIR "/systems") >= 20);
}

TEST_CASE("an expectation that does not hold says what was found") {
    const std::string koch = "axiom F\nF -> F+F--F+F\nangle 60\n";
    CHECK(first_unmet(koch + "expect length 3: 149\n") == "x.lsys:4:1: expected length 3: 149, found 148");
    CHECK(first_unmet(koch + "expect word 1: F+F-F+F\n") == "x.lsys:4:1: expected word 1: F+F-F+F, found F+F--F+F");
    CHECK(first_unmet(koch + "expect segments 3: 63\n") == "x.lsys:4:1: expected segments 3: 63, found 64");
    CHECK(first_unmet(koch + "expect distinct 3: 63\n") == "x.lsys:4:1: expected distinct 3: 63, found 64");
    CHECK(first_unmet(koch + "expect vertices 3: 64\n") == "x.lsys:4:1: expected vertices 3: 64, found 65");
    CHECK(first_unmet(koch + "expect end 3: 27 1\n") == "x.lsys:4:1: expected end 3: 27 1, found 27 0");
    CHECK(first_unmet(koch + "expect box 1: 0 0 3 0.867\n") == "x.lsys:4:1: expected box 1: 0 0 3 0.867, found 0 0 3 0.866");
    CHECK(first_unmet("axiom a\na -> a\na -> aa\nexpect lengths 1: 1,3\n") == "x.lsys:4:1: expected lengths 1: 1,3, found 1,2");
    CHECK(first_unmet(koch + "expect box 1: 0 0 3 0.866\n").empty());
}

TEST_CASE("an expectation that cannot be answered is not met") {
    CHECK(first_unmet("axiom a\na -> a\na -> aa\nexpect length 1: 1\n")
              .find("found no answer: not a D0L system: a has 2 rules") != std::string::npos);
}
