#include <doctest/doctest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "places.hpp"

using namespace algae;

namespace {

std::string file_text(const std::string& name) {
    std::ifstream file(source_folder() + "/" + name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The row of the reference for a statement.
std::string row(const StatementHelp& help) {
    std::string forms;
    for (const std::string& form : help.forms) forms += (forms.empty() ? "`" : ", `") + form + '`';
    return "| " + forms + " | " + help.meaning + " |" +
           (help.otherwise.empty() ? "" : ' ' + help.otherwise) + " |";
}

}  // namespace

TEST_CASE("the reference in NOTATION.md has a row for each statement, and no other") {
    const std::string text = file_text("NOTATION.md");
    const std::size_t begin = text.find("| statement | means | without it |\n|---|---|---|\n");
    REQUIRE(begin != std::string::npos);
    std::istringstream lines(text.substr(begin));
    std::string line;
    std::getline(lines, line);
    std::getline(lines, line);
    for (const StatementHelp& help : system_statements()) {
        REQUIRE(std::getline(lines, line));
        CHECK(line == row(help));
    }
    std::getline(lines, line);
    CHECK(line.empty());
}

TEST_CASE("each statement is shown as it is written") {
    std::set<std::string> keywords;
    for (const StatementHelp& help : system_statements()) {
        CAPTURE(help.keyword);
        CHECK(keywords.insert(help.keyword).second);
        CHECK(!help.forms.empty());
        CHECK(!help.meaning.empty());
        for (const std::string& form : help.forms) CHECK(form.starts_with(help.keyword + ' '));
    }
}

TEST_CASE("names that may stand behind a keyword are read there") {
    const auto reads = [](const std::string& statement) {
        CHECK_NOTHROW_MESSAGE(read_lsystem("axiom F?E(0)\n" + statement, "x.lsys"), statement);
    };
    for (const StatementHelp& help : system_statements())
        for (const std::string& word : help.words) {
            if (help.keyword == "stamp" || help.keyword == "turn" || help.keyword == "colour")
                reads(help.keyword + (help.keyword == "stamp" ? " S " : " ") + word);
            if (help.keyword == "camera") reads("camera 30 20 " + word);
            if (help.keyword == "expect") reads("expect " + word + " 1: 2");
        }
}
