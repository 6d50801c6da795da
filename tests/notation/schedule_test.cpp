#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "notation/said.hpp"

using namespace algae;

namespace {

const std::string two_tables = "axiom a\ntable light\na -> ab\ntable dark\na -> b\nb -> aa\n";

}  // namespace

TEST_CASE("a schedule names tables, wherever it stands") {
    const Model system = read_lsystem("schedule light dark\tlight\n" + two_tables, "x.lsys");
    CHECK(system.schedule == std::vector<std::size_t>{0, 1, 0});
    CHECK(schedule_names(system) == std::vector<std::string>{"light", "dark", "light"});
    CHECK(scheduled_table(system, 0) == 0);
    CHECK(scheduled_table(system, 1) == 1);
    CHECK(scheduled_table(system, 2) == 0);
    CHECK(scheduled_table(system, 3) == 0);
    CHECK(scheduled_table(system, 4) == 1);
    CHECK(leaves_tables_open(read_lsystem(two_tables, "x.lsys")));
    CHECK_FALSE(leaves_tables_open(system));
    CHECK_FALSE(leaves_tables_open(read_lsystem("axiom a; table t; a -> b", "x.lsys")));
    CHECK_FALSE(system == read_lsystem(two_tables, "x.lsys"));
}

TEST_CASE("a schedule is printed below the tables, with its comments") {
    CHECK(
        format_lsystem("axiom a\n# days\nschedule  dark light # and again\n" + two_tables.substr(8),
                       "x.lsys") == two_tables + "# days\nschedule dark light # and again\n");
    const std::string canonical = two_tables + "schedule dark light\nangle 30\n";
    CHECK(print_lsystem(read_lsystem(canonical, "x.lsys")) == canonical);
}

TEST_CASE("schedules that are wrong") {
    CHECK(findings(two_tables + "schedule light drak light") ==
          "x.lsys:7:16: error: expected a table (light, dark), found 'drak'; did you mean 'dark'?\n"
          "  schedule light drak light\n"
          "                 ^");
    CHECK(findings(two_tables + "schedule light, dark") ==
          "x.lsys:7:10: error: expected a table (light, dark), found 'light,'; did you mean "
          "'light'?\n"
          "  schedule light, dark\n"
          "           ^");
    CHECK(findings(two_tables + "schedule 1 2")
              .starts_with("x.lsys:7:10: error: expected a table (light, dark), found '1'\n"));
    CHECK(findings("axiom a\na -> b\nschedule light") ==
          "x.lsys:3:10: error: expected tables for the schedule, such as 'table light' before "
          "rules, found none\n"
          "  schedule light\n"
          "           ^");
    CHECK(findings(two_tables + "schedule") ==
          "x.lsys:7:9: error: expected a value after 'schedule', found the end of the line\n"
          "  schedule\n"
          "          ^");
    CHECK(findings(two_tables + "schedule dark; schedule light")
              .starts_with("x.lsys:7:16: error: 'schedule' is given twice, first in line 7\n"));
    CHECK(findings(two_tables + "shedule dark")
              .starts_with("x.lsys:7:1: error: expected a setting or a rule with '->', found "
                           "'shedule'; did you mean 'schedule'?\n"));
    CHECK(findings("system s { axiom a; schedule x }\n" + two_tables)
              .starts_with("x.lsys:1:21: error: expected 'axiom', 'ignore' or a rule in a system "
                           "within another, found 'schedule'\n"));
}

TEST_CASE("a table with two names is one finding, and the first of them is known") {
    CHECK(findings("axiom a\ntable light dark\na -> b\nschedule light") ==
          "x.lsys:2:13: error: expected the end of the line, found 'dark'\n"
          "  table light dark\n"
          "              ^");
}

TEST_CASE("of very many tables the message names twenty") {
    std::string text = "axiom a\n", known;
    for (int i = 0; i < 1000; ++i) text += "table t" + std::to_string(i) + "\na -> b\n";
    for (int i = 0; i < 20; ++i) known += 't' + std::to_string(i) + ", ";
    CHECK(findings(text + "schedule winter")
              .find("error: expected a table (" + known + "... (1000 tables)), found 'winter'\n") !=
          std::string::npos);
}
