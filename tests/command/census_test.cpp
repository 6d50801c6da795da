#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

TEST_CASE("census counts systems and languages up to renaming") {
    // Counts of two programs that share nothing with this one.
    const auto column = [](const std::string& of, const std::string& by, const std::string& name) {
        const Run found =
            run("census '" + of + "' --format json" + (by.empty() ? "" : " --by " + by));
        CHECK(found.status == 0);
        std::vector<int> counts;
        const json census = json::parse(found.out);
        for (const json& row : census["rows"])
            counts.push_back(name.empty() ? row["all"].get<int>() : row[name]["proved"].get<int>());
        return counts;
    };
    CHECK(column("D0L systems up to size 12", "", "") ==
          std::vector<int>{0, 1, 2, 5, 17, 64, 256, 1109, 5206, 26133, 138858, 777449});
    CHECK(column("PD0L systems up to size 9", "", "") ==
          std::vector<int>{0, 0, 1, 2, 5, 20, 82, 334, 1463});
    CHECK(column("0L systems up to size 7", "finite", "finite") ==
          std::vector<int>{0, 1, 2, 5, 17, 61, 231});
    CHECK(column("D0L systems up to size 7", "finite", "finite") ==
          std::vector<int>{0, 1, 2, 4, 15, 47, 169});
    CHECK(column("0L systems up to size 6", "finite", "") == std::vector<int>{0, 1, 2, 6, 20, 81});
    CHECK(column("P0L systems up to size 7", "finite", "") ==
          std::vector<int>{0, 0, 1, 2, 5, 21, 87});
}

TEST_CASE("every D0L system has one class of growth") {
    const Run found = run("census 'D0L systems up to size 7' --by growth --format json");
    const json census = json::parse(found.out);
    for (const json& row : census["rows"])
        CHECK(row["zero"]["proved"].get<int>() + row["bounded"]["proved"].get<int>() +
                  row["polynomial"]["proved"].get<int>() +
                  row["exponential"]["proved"].get<int>() ==
              row["all"].get<int>());
}

TEST_CASE("census prints a table, CSV and a b-file, the same for every number of threads") {
    const std::string asked = "census 'finite languages up to size 5' --by 0L,D0L --first 2";
    const Run table = run(asked);
    CHECK(table.status == 0);
    CHECK(table.out ==
          "size  all  0L  D0L\n"
          "   1    1   0    0\n"
          "   2    1   1    1\n"
          "   3    3   3    3\n"
          "   4    8   8    8\n"
          "   5   26  25   25\n"
          "first 0L: a   ε,a\n"
          "first D0L: a   ε,a\n");
    CHECK(run(asked + " --threads 1").out == table.out);
    CHECK(run(asked + " --threads 3").out == table.out);
    CHECK(run("census 'finite languages up to size 3' --by 0L --format csv").out ==
          "size,all,0L,0L undecided\n"
          "1,1,0,0\n"
          "2,1,1,0\n"
          "3,3,3,0\n");
    CHECK(run("census 'D0L systems up to size 5' --format bfile").out ==
          "# D0L systems up to size 5, by size\n"
          "1 0\n"
          "2 1\n"
          "3 2\n"
          "4 5\n"
          "5 17\n");
    CHECK(run("census 'D0L systems up to size 5' --by 'L(X) is infinite' --format bfile").out ==
          "# D0L systems up to size 5, by size; L(X) is infinite\n1 0\n2 0\n3 0\n4 1\n5 2\n");
}

TEST_CASE("census says what is wrong with the question") {
    const auto refused = [](const std::string& arguments, const std::string& message) {
        const Run found = run("census " + arguments);
        CHECK(found.status == 2);
        CHECK(found.out.empty());
        CHECK(found.err.find(message) != std::string::npos);
    };
    refused("'D0L systems'", "expected a bound of the census, such as 'up to size 8'");
    refused("'DOL systems up to size 3'", "found 'DOL'; did you mean 'D0L', with a zero?");
    refused("'D0L systems up to size 3' --by 0LX", "0LX");
    refused("'D0L systems up to size 3' --by finite,growth --format bfile",
            "--format bfile: expected at most one property behind --by, found 5");
}
