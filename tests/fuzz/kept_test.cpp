// Gives what once broke something, and the texts of the repository, to all targets of the fuzzer (tools/fuzz).

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "fuzz/targets.hpp"
#include "places.hpp"

using namespace algae;
namespace fs = std::filesystem;

namespace {

/// Far more than any input takes; a hang is longer.
constexpr std::chrono::seconds longest{10};

void survives(const fuzz::Target& target, const std::string& bytes) {
    const auto begin = std::chrono::steady_clock::now();
    CHECK_NOTHROW(fuzz::run(target, bytes));
    CHECK(std::chrono::steady_clock::now() - begin < longest);
}

}  // namespace

TEST_CASE("what once broke something breaks nothing") {
    const fs::path kept = fs::path(source_folder()) / "tests/fuzz/kept";
    if (!fs::exists(kept)) return;
    for (const auto& entry : fs::recursive_directory_iterator(kept)) {
        if (!entry.is_regular_file()) continue;
        CAPTURE(entry.path().string());
        const auto* target = fuzz::target(entry.path().parent_path().filename().string());
        REQUIRE(target != nullptr);
        std::ifstream file(entry.path(), std::ios::binary);
        std::ostringstream bytes;
        bytes << file.rdbuf();
        survives(*target, bytes.str());
    }
}

TEST_CASE("texts of the repository break nothing, nor do they without their second half") {
    constexpr std::size_t most = 40;  // of a target: all of them take a minute
    for (const fuzz::Target& target : fuzz::targets()) {
        CAPTURE(target.name);
        const auto seeds = fuzz::seeds(target);
        CHECK(seeds.size() > 0);
        for (std::size_t i = 0; i < std::min(most, seeds.size()); ++i) {
            const std::string& seed = seeds[i * seeds.size() / std::min(most, seeds.size())];
            CAPTURE(seed);
            survives(target, seed);
            survives(target, seed.substr(0, seed.size() / 2));
        }
    }
}

TEST_CASE("each target has a name of its own, and seeds and words to write inputs with") {
    std::set<std::string> names;
    for (const fuzz::Target& target : fuzz::targets()) {
        CAPTURE(target.name);
        CHECK(names.insert(target.name).second);
        CHECK(fuzz::target(target.name) == &target);
    }
    CHECK(fuzz::target("no such target") == nullptr);
    const auto words = fuzz::dictionary(*fuzz::target("lsystem"));
    CHECK(std::ranges::find(words, "axiom") != words.end());
}

TEST_CASE("what is no error of algae comes out of a target") {
    const auto throwing = [](auto error) {
        return fuzz::Target{"x", "", [error](std::string_view) { throw error; }, {}};
    };
    CHECK_NOTHROW(fuzz::run(throwing(Error("no")), ""));
    CHECK_NOTHROW(fuzz::run(throwing(BoundReached(Bound::time, "no")), ""));
    CHECK_THROWS_AS(fuzz::run(throwing(fuzz::Broken("no")), ""), fuzz::Broken);
    CHECK_THROWS_AS(fuzz::run(throwing(std::out_of_range("no")), ""), std::out_of_range);
    CHECK_THROWS_AS(fuzz::run(throwing(Diagnostics({{{"x", 1, 1}, "", "", 0}})), ""), fuzz::Broken);
}
