#include <doctest/doctest.h>

#include <regex>

#include "house/files.hpp"

using namespace algae::house;

namespace {

/// Every text of the repository that people wrote, but this file.
std::vector<fs::path> texts() {
    std::vector<fs::path> all = {"CMakeLists.txt",  "CMakePresets.json", "README.md",   "TOUR.md",
                                 "CONTRIBUTING.md", "CHANGELOG.md",      "CITATION.cff"};
    for (const char* folder :
         {"src", "tests", "cmake", "figures", "theory", "lessons", "paper", "tools", "docs"})
        for (const fs::path& file : files(folder, {"", ".hpp", ".cpp", ".cmake", ".awk", ".in",
                                                   ".md", ".txt", ".lsys", ".claim", ".py", ".sh"}))
            if (file.filename() != "prose_test.cpp") all.push_back(file);
    return all;
}

void none_says(const std::vector<fs::path>& where, const std::regex& word, const char* why) {
    for (const fs::path& file : where) {
        std::size_t number = 0;
        for (const std::string& line : lines(file)) {
            ++number;
            std::smatch found;
            if (std::regex_search(line, found, word))
                FAIL_CHECK(file.string() << ":" << number << ": " << found.str() << ": " << why);
        }
    }
}

}  // namespace

TEST_CASE("nothing is left for later") {
    none_says(texts(), std::regex(R"(\b(TODO|FIXME|XXX|HACK)\b)"), "do it or open an issue");
}

TEST_CASE("no path belongs to one machine") {
    none_says(texts(), std::regex(R"((^|[\s"'=(])/(home|work|Users|root|opt|mnt)/)"),
              "a path of one machine");
}

TEST_CASE("only the command line prints or exits") {
    std::vector<fs::path> library;
    for (const fs::path& file : files("src", {".hpp", ".cpp"}))
        if (!file.string().starts_with("src/command/")) library.push_back(file);
    none_says(
        library,
        std::regex(
            R"(std::(cout|cerr|clog|exit|abort|quick_exit)\b|\b(f?printf|puts|fmt::print|_exit)\()"),
        "the library returns or throws");
}

TEST_CASE("a message of the library names no option of the command") {
    for (const fs::path& file : files("src", {".hpp", ".cpp"})) {
        if (file.string().starts_with("src/command/")) continue;
        std::size_t number = 0;
        for (const std::string& line : lines(file)) {
            ++number;
            // The page of a lesson shows whole commands.
            if (std::regex_search(line, std::regex(R"--("[^"]*--[a-z][^"]*")--")) &&
                line.find("`algae ") == std::string::npos)
                FAIL_CHECK(file.string() << ":" << number << ": an option; the command adds it");
        }
    }
}

TEST_CASE("a stop is let through where errors are caught, as it is none") {
    // No ladder of `throw;` stands before an Error: stops are let through by themselves.
    const std::regex ladder(
        R"(catch \(const (Stopped|BoundReached|Interrupted)&\) \{\s*throw;\s*\} catch \(const Error)");
    for (const fs::path& file : files("src", {".hpp", ".cpp"})) {
        std::string text;
        for (const std::string& line : lines(file)) text += line + '\n';
        INFO(file.string());
        CHECK(!std::regex_search(text, ladder));
    }
}

TEST_CASE("a property that does not hold fails its test") {
    for (const fs::path& file : files("tests", {".hpp", ".cpp"})) {
        std::string before;
        std::size_t number = 0;
        for (const std::string& line : lines(file)) {
            ++number;
            if (std::regex_search(line, std::regex(R"(^\s*rc::check\()")) && !before.ends_with("("))
                FAIL_CHECK(file.string() << ":" << number << ": expected CHECK(rc::check(...))");
            if (line.find_first_not_of(' ') != std::string::npos) before = line;
        }
    }
}

TEST_CASE("every header is included once and every file is named for its subject") {
    for (const fs::path& file : files("src", {".hpp"})) {
        INFO(file.string());
        const auto text = lines(file);
        CHECK((!text.empty() && text[0] == "#pragma once"));
    }
    for (const fs::path& file : files("src", {".hpp", ".cpp"})) {
        INFO(file.string());
        CHECK(!std::regex_search(file.string(), std::regex(R"(util|helper|misc|common)")));
    }
}

TEST_CASE("the README opens with the two commands") {
    std::vector<std::string> blocks;  // what stands in its code blocks
    bool inside = false;
    for (const std::string& line : lines("README.md")) {
        if (line.starts_with("```")) {
            inside = !inside;
            if (inside) blocks.emplace_back();
        } else if (inside) {
            blocks.back() += line + '\n';
        }
    }
    REQUIRE(blocks.size() >= 2);
    CHECK(blocks[0] == "tools/demo\n");
    CHECK(blocks[1] == "tools/test\n");
}
