#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "command/run.hpp"
#include "lessons/answers.hpp"

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// Two right answers to 3.2, a wrong one, and one that cannot be read.
std::string class_of(const Scratch& scratch) {
    fs::create_directories(scratch.path() / "class");
    scratch.file("class/ada.lsys", "axiom a\na -> ab\nb -> bcc\n");
    scratch.file("class/bea.lsys", "axiom a\na -> aa\n");
    scratch.file("class/cem.lsys", "axiom a\na => aa\n");
    scratch.file("class/dan.lsys", "axiom x\nx -> xy\ny -> yzz\n");
    return "'" + scratch.file("class") + "'";
}

}  // namespace

TEST_CASE("mark says of an exercise by its number what lesson says of it, in every form of table") {
    const Scratch scratch;
    const std::string folder = class_of(scratch);
    std::size_t compared = 0;
    for (const std::string form : {"", " --json", " --table csv", " --table junit"}) {
        CAPTURE(form);
        const Run by_mark = run("mark 3.2 " + folder + form),
                  by_lesson = run("lesson 3 --exercise 2 " + folder + form);
        CHECK(by_mark.status == 0);
        CHECK(by_mark.out == by_lesson.out);
        CHECK(by_mark.out.find("bea.lsys") != std::string::npos);
        ++compared;
    }
    CHECK(compared == 4);
    const Run table = run("mark 3.2 " + folder);
    CHECK(table.out.starts_with("answer,verdict,points,of,why\nada.lsys,right,2,2,\n"));
    CHECK(table.out.find("\nbea.lsys,wrong,1,2,") != std::string::npos);
    CHECK(table.out.find("\ncem.lsys,unreadable,0,2,") != std::string::npos);
    CHECK(table.out.find("\ndan.lsys,right,2,2,\n") != std::string::npos);
    const json found = json::parse(run("mark 3.2 " + folder + " --json").out);
    CHECK(found["exercise"] == "3.2");
    REQUIRE(found["answers"].size() == 4);
    CHECK(found["answers"][1]["verdict"] == "wrong");
    CHECK(run("mark 3.2 " + folder + " --table junit")
              .out.find("tests=\"4\" failures=\"1\" errors=\"1\"") != std::string::npos);
}

TEST_CASE("mark writes feedback, and marks one answer with the exit status of its verdict") {
    const Scratch scratch;
    const std::string folder = class_of(scratch), marked = scratch.file("marked");
    CHECK(run("mark 3.2 " + folder + " --feedback '" + marked + "'").status == 0);
    CHECK(text_of(marked + "/bea.lsys.txt").find("  hint   The differences are 1, 3, 5, 7") !=
          std::string::npos);
    CHECK(text_of(marked + "/bea.lsys.txt").ends_with("points: 1 of 2\n"));
    const std::string one = "'" + scratch.file("class/");
    CHECK(run("mark 3.2 " + one + "ada.lsys'").status == 0);
    CHECK(run("mark 3.2 " + one + "bea.lsys'").status == 1);
    CHECK(run("mark 3.2 " + one + "cem.lsys'").status == 2);
    CHECK(run("mark 3.2 --max-letters 1 " + one + "ada.lsys'").out.starts_with("right"));
    CHECK(run("mark 3.2 " + one + "bea.lsys' --table csv").err.find("expected a folder") !=
          std::string::npos);
}

TEST_CASE("mark takes an exercise of one's own from a file, with the systems beside it") {
    const Scratch scratch;
    const std::string mine = scratch.file(
        "doubling.exercise",
        "exercise Doubling\ntask Write a D0L system that grows like the model.\nanswer system\n"
        "let model = D0L model.lsys\nshow growth(answer) == growth(model)\n");
    scratch.file("model.lsys", "axiom a\na -> aa\n");
    const Run table = run("mark '" + mine + "' " + class_of(scratch));
    CHECK(table.status == 0);
    CHECK(table.out.find("ada.lsys,wrong,0,1,") != std::string::npos);
    CHECK(table.out.find("bea.lsys,right,1,1,") != std::string::npos);
}

TEST_CASE("mark says what an exercise is called where it is given another word") {
    const Scratch scratch;
    const std::string folder = class_of(scratch);
    const std::string expected =
        "expected an exercise: lesson.exercise such as 4.1, or a file ending in .exercise, found ";
    std::size_t refused = 0;
    for (const std::string word : {"squares", "4.", ".1", "4.1.2", "-1.2", "4.x", "4,1",
                                   "99999999999999999999.1", "4.99999999999999999999"}) {
        CAPTURE(word);
        const Run found = run("mark -- " + word + " " + folder);
        CHECK(found.status == 2);
        CHECK(found.err.find(expected + word) != std::string::npos);
        ++refused;
    }
    CHECK(refused == 9);
    CHECK(run("mark 4 " + folder).err.find("the first exercise of this lesson is 4.1") !=
          std::string::npos);
    CHECK(run("mark 99.1 " + folder).err.find("expected a lesson from 1 to 14") !=
          std::string::npos);
    CHECK(run("mark 3.99 " + folder).err.find("lesson 3 has the exercises 1 to ") !=
          std::string::npos);
    CHECK(run("mark 3.2").status == 2);
    CHECK(run("mark").status == 2);
    CHECK(run("mark 3.2 '" + scratch.file("nobody") + "'").status == 2);
}
