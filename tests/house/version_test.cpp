#include <doctest/doctest.h>

#include <optional>
#include <regex>
#include <set>

#include "house/files.hpp"

using namespace algae::house;

namespace {

/// What the first line of a file that matches says.
std::optional<std::string> said(const fs::path& file, const std::string& pattern) {
    std::smatch found;
    for (const std::string& line : lines(file))
        if (std::regex_search(line, found, std::regex(pattern))) return found[1].str();
    return std::nullopt;
}

}  // namespace

TEST_CASE("the build, the changes and the citation name one version") {
    const auto version = said("CMakeLists.txt", R"(^project\(algae VERSION ([0-9.]+) )");
    REQUIRE(version);
    CHECK(said("CHANGELOG.md", "^## ([0-9.]+)") == version);
    CHECK(said("CITATION.cff", "^version: ([0-9.]+)$") == version);
}

TEST_CASE("the citation has what the format 1.2.0 asks for") {
    CHECK(said("CITATION.cff", "^cff-version: (.*)$") == "1.2.0");
    CHECK(said("CITATION.cff", "^title: (.+)$"));
    CHECK(said("CITATION.cff", "^message: (.+)$"));
    CHECK(said("CITATION.cff", "^  - name: (.+)$"));
    CHECK(said("CITATION.cff", "^license: (.+)$") == "MIT");
    const std::set<std::string> known = {"abstract", "authors", "cff-version",
                                         "keywords", "license", "message",
                                         "title",    "type",    "version"};
    for (const std::string& line : lines("CITATION.cff")) {
        std::smatch key;
        if (std::regex_search(line, key, std::regex("^([a-z-]+):")))
            CHECK(known.contains(key[1].str()));
    }
}
