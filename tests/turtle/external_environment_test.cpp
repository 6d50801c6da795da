#include "turtle/turtle.hpp"

#include <doctest/doctest.h>

#include "exact/exact.hpp"

using namespace algae;

namespace {

Traversal two_queries() {
    Traversal course;
    course.generation = 3;
    course.queries.push_back({"?E", 2, {0.5, 4}, {1, 2.5, -1e-20}, {}});
    course.queries.push_back({"?E", 7, {1}, {}, {}});
    return course;
}

std::vector<std::vector<double>> answers(const std::string& command) {
    const Traversal course = two_queries();
    const Query* const queries[] = {&course.queries[0], &course.queries[1]};
    return ExternalEnvironment(command).answers(course, queries, {});
}

/// What is said against a line that a program writes.
std::string refusal(const std::string& line) {
    const std::string command = "cat >/dev/null & echo '" + line + "'",
                      before = "the environment program '" + command + "', ";
    try {
        answers(command);
    } catch (const Error& error) {
        const std::string message = error.what();
        REQUIRE(message.starts_with(before));
        return message.substr(before.size());
    }
    return "";
}

}  // namespace

TEST_CASE("the question is one line of JSON") {
    const std::string question =
        R"({"generation":3,"queries":[{"module":"?E","index":2,"parameters":[0.5,4],"position":[1,2.5,-1e-20],)"
        R"("heading":[1,0,0],"left":[0,1,0],"up":[0,0,1]},{"module":"?E","index":7,"parameters":[1],)"
        R"("position":[0,0,0],"heading":[1,0,0],"left":[0,1,0],"up":[0,0,1]}]})";
    const std::string command =
        "read -r line; if [ \"$line\" = '" + question +
        "' ]; then echo '{\"answers\":[[1,2],[3]]}'; else echo \"$line\" >&2; fi";
    CHECK(answers(command) == std::vector<std::vector<double>>{{1, 2}, {3}});
}

TEST_CASE("answers may have blanks, other keys and numbers of any form") {
    CHECK(answers("echo ' { \"time\": [1], \"answers\" : [[-1e3, 0.25], [ 7 ]] } '") ==
          std::vector<std::vector<double>>{{-1000, 0.25}, {7}});
}

TEST_CASE("answers that are none") {
    const std::string expected =
        "generation 3: expected a line such as {\"answers\":[[1],[2]]}, found ";
    CHECK(refusal("hello") == expected + "'hello'");
    CHECK(refusal("") == expected + "''");
    CHECK(refusal("[[1,2],[3]]") == expected + "'[[1,2],[3]]'");
    CHECK(refusal("{\"answers\":3}") == expected + "'{\"answers\":3}'");
    CHECK(refusal("{\"answers\":[[1e999,0],[3]]}") == expected + "'{\"answers\":[[1e999,0],[3]]}'");
    CHECK(refusal(std::string(70, 'x') + "\t\xC3\xBC") ==
          expected + '\'' + std::string(60, 'x') + "...'");
    CHECK(refusal("\t\xC3\xBC") == expected +
                                       "'?"
                                       "?"
                                       "?'");
    CHECK(refusal("{\"answers\":[[1,2]]}") == "generation 3: expected 2 answers, found 1");
    CHECK(refusal("{\"answers\":[]}") == "generation 3: expected 2 answers, found 0");
    const std::string first =
        "generation 3: expected an array of 2 numbers for ?E(0.5,4) at position 2 of generation 3, "
        "found ";
    CHECK(refusal("{\"answers\":[[1],[3]]}") == first + "'[1]'");
    CHECK(refusal("{\"answers\":[[1,2,3],[3]]}") == first + "'[1,2,3]'");
    CHECK(refusal("{\"answers\":[[1,null],[3]]}") == first + "'[1,null]'");
    CHECK(refusal("{\"answers\":[[1,\"2\"],[3]]}") == first + "'[1,\"2\"]'");
    CHECK(refusal("{\"answers\":[[1,2],3]}") ==
          "generation 3: expected an array of 1 number for ?E(1) at position 7 of generation 3, "
          "found '3'");
}
