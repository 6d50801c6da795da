#include <doctest/doctest.h>

#include <iterator>
#include <regex>
#include <set>

#include "house/files.hpp"

using namespace algae::house;

namespace {

std::string text_of(const char* file) {
    std::string text;
    for (const std::string& line : lines(file))
        // What TeX or the shell takes for a comment, and definitions of commands with arguments, do not count.
        if (!line.starts_with("%") && !line.starts_with("#") &&
            line.find("#1") == std::string::npos)
            text += line + '\n';
    return text;
}

/// The first group of every match.
std::set<std::string> all(const std::string& text, const char* expression) {
    const std::regex pattern(expression);
    std::set<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
        found.insert((*at)[1]);
    return found;
}

const std::string paper = text_of("paper/paper.tex"), script = text_of("tools/paper");

}  // namespace

TEST_CASE("every claim that the paper names is a file") {
    const std::set<std::string> named = all(paper, R"(\\(?:claim|instances|argued)\{([^}]*)\})");
    CHECK(named.size() > 30);
    for (const std::string& claim : named) {
        CAPTURE(claim);
        CHECK(fs::is_regular_file(root() / "theory" / (claim + ".claim")));
    }
}

TEST_CASE("every number in the paper that is found is written by tools/paper, and no other") {
    const std::set<std::string> used = all(paper, R"(\\found\{([^}]*)\})");
    CHECK(used.size() > 30);
    CHECK(used == all(script, R"((?:^|\n) *number ([a-z]+) )"));
}

TEST_CASE("every table, figure and listing of the paper is written by tools/paper") {
    std::set<std::string> parts =
        all(paper, R"(\\(?:verbatiminput|includegraphics)(?:\[[^\]]*\])?\{([^}]*)\})");
    for (const std::string& part : all(paper, R"(\\input\{([^}]*)\})")) parts.insert(part + ".tex");
    CHECK(parts.size() > 10);
    for (const std::string& part : parts) {
        CAPTURE(part);
        CHECK(std::regex_search(
            script, std::regex(R"([ /])" + std::regex_replace(part, std::regex(R"(\.)"), R"(\.)") +
                               R"([\s"])")));
    }
    CHECK(paper.find("\\begin{verbatim}") == std::string::npos);
}

TEST_CASE("the paper cites what it lists, and lists what it cites") {
    std::set<std::string> cited;
    for (const std::string& keys : all(paper, R"(\\cite\{([^}]*)\})"))
        for (const std::string& key : all(keys, R"(([a-z0-9]+))")) cited.insert(key);
    CHECK(cited == all(paper, R"(\\bibitem\{([^}]*)\})"));
}
