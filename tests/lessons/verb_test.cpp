#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "command/run.hpp"

using nlohmann::json;

TEST_CASE("lesson lists the lessons, prints one, and prints the task of an exercise") {
    const Run all = run("lesson");
    CHECK(all.status == 0);
    CHECK(all.out.find(" 3  Growth\n") != std::string::npos);
    CHECK(all.out.find("3.2   The squares and one\n") != std::string::npos);
    const Run one = run("lesson 3");
    CHECK(one.status == 0);
    CHECK(one.out.starts_with("# 3. Growth\n"));
    CHECK(one.out.find("### Exercise 3.2: The squares and one\n") != std::string::npos);
    const Run task = run("lesson 3 --exercise 2");
    CHECK(task.status == 0);
    CHECK(task.out.starts_with("Exercise 3.2: The squares and one\n\nWrite a PD0L system"));
    CHECK(run("lesson 15").status == 2);
    CHECK(run("lesson 3 --exercise 9").status == 2);
    CHECK(run("lesson --exercise 1").status == 2);
    CHECK(run("lesson 3 answer.lsys").status == 2);
    CHECK(run("lesson three").err.find("from 1 to 14") != std::string::npos);
}

TEST_CASE(
    "lesson prints code of algae where the lesson names a region, and writes the files of a "
    "lesson") {
    const Run one = run("lesson 3");
    CHECK(one.out.find("```cpp region=src/fold/fold.hpp#fold\n```") == std::string::npos);
    CHECK(one.out.find("\n#include") == std::string::npos);
    CHECK(one.out.find("fold(const ") != std::string::npos);
    const Scratch folder;
    const Run written = run("lesson 3 --out " + folder.file("here"));
    CHECK(written.status == 0);
    CHECK(text_of(folder.file("here/squares.lsys")) == "axiom a\na -> abcc\nb -> bcc\nc -> c\n");
}

TEST_CASE(
    "an exercise that belongs to no lesson is marked as the others are, with systems beside it") {
    const Scratch files;
    const std::string mine = files.file(
        "doubling.exercise",
        "exercise Doubling\ntask Write a D0L system that grows like the model.\nanswer system\n"
        "let model = D0L model.lsys\nshow growth(answer) == growth(model)\nhint Each letter "
        "doubles.\n");
    files.file("model.lsys", "axiom a\na -> aa\n");
    const Scratch elsewhere;
    const Run task = run("lesson " + mine);
    CHECK(task.status == 0);
    CHECK(task.out.starts_with("Exercise doubling: Doubling\n\nWrite a D0L system"));
    const Run right =
        run("lesson " + mine + " " + elsewhere.file("a.lsys", "axiom b\nb -> cc\nc -> bb\n"));
    CHECK(right.status == 0);
    CHECK(right.out.starts_with("right: exercise doubling, Doubling\n"));
    const Run wrong = run("lesson " + mine + " " + elsewhere.file("b.lsys", "axiom b\nb -> bbb\n"));
    CHECK(wrong.status == 1);
    CHECK(wrong.out.ends_with("  hint   Each letter doubles.\n"));
    const std::string broken = files.file(
        "broken.exercise", "exercise Broken\ntask Write a.\nanswer word\nshow answer === {a}\n");
    const Run undecidable = run("lesson " + broken + " " + elsewhere.file("c.txt", "a\n"));
    CHECK(undecidable.status == 2);
    CHECK(undecidable.err.find("broken.exercise:4:") != std::string::npos);
    const std::string drawn = files.file(
        "drawn.exercise",
        "exercise Drawn\ntask Write a.\nanswer word\nshow figure(answer, 1) == figure(koch, 1)\n");
    CHECK(run("lesson " + drawn + " " + elsewhere.file("c.txt")).err.find("drawn.exercise:4:1: ") !=
          std::string::npos);
    CHECK(run("lesson " + files.file("empty.exercise", "task Nothing\n")).status == 2);
    CHECK(run("lesson " + mine + " --exercise 1").status == 2);
    CHECK(run("lesson " + files.file("missing.exercise")).status == 2);
}

TEST_CASE("what is wrong with the text of an answer is told with its place in it") {
    const Scratch files;
    const Run found =
        run("lesson 1 --exercise 2 " + files.file("answer.txt", "# two words\na, aa\n"));
    CHECK(found.status == 2);
    CHECK(found.err.find("answer.txt:2:1: error: ") != std::string::npos);
    const Run empty = run("lesson 1 --exercise 1 " + files.file("empty.txt", "# nothing\n"));
    CHECK(empty.status == 2);
    CHECK(empty.err.find("expected a word") != std::string::npos);
    CHECK(run("lesson 1 --exercise 1 --out " + files.file("folder")).status == 2);
}

TEST_CASE(
    "a right answer ends with 0, a wrong one with 1 and a reason, one that cannot be read with 2") {
    const Scratch files;
    const Run right =
        run("lesson 3 --exercise 2 " + files.file("right.lsys", "axiom a\na -> ab\nb -> bcc\n"));
    CHECK(right.status == 0);
    CHECK(right.out.starts_with("right: exercise 3.2, The squares and one\n"));
    const Run wrong =
        run("lesson 3 --exercise 2 " + files.file("wrong.lsys", "axiom a\na -> aa\n"));
    CHECK(wrong.status == 1);
    CHECK(wrong.out ==
          "wrong: exercise 3.2, The squares and one\n"
          "  asked  growth(answer) = n^2 + 1\n"
          "  found  It is false for n = 2:\n"
          "           length(answer,2) is 4, 2^2+1 is 5.\n"
          "  hint   The differences are 1, 3, 5, 7, ... A letter that leaves one b behind in every "
          "step, and a b "
          "that leaves two letters behind in every step.\n");
    const Run unread =
        run("lesson 3 --exercise 2 " + files.file("unread.lsys", "axiom a\na => aa\n"));
    CHECK(unread.status == 2);
    CHECK(unread.out.empty());
    CHECK(unread.err.find("unread.lsys:2:") != std::string::npos);
    CHECK(run("lesson 3 --exercise 5 " + files.file("g.claim", "let G = D0L fibonacci\n")).status ==
          2);
}

TEST_CASE("a bound that is reached leaves an answer undecided") {
    const Scratch files;
    const Run found = run("lesson 4 --exercise 1 --max-letters 10 " +
                          files.file("answer.lsys", "axiom F-F-F-F\nF -> F-F+F+FF-F-F+F\n"));
    CHECK(found.status == 3);
    CHECK(found.out.starts_with("undecided: exercise 4.1"));
}

TEST_CASE("lesson --json tells verdicts, arguments and hints") {
    const Scratch files;
    const Run found =
        run("lesson 3 --exercise 2 --json " + files.file("wrong.lsys", "axiom a\na -> aa\n"));
    CHECK(found.status == 1);
    const json marked = json::parse(found.out);
    CHECK(marked["exercise"] == "3.2");
    CHECK(marked["verdict"] == "wrong");
    CHECK(marked["statements"].size() == 2);
    CHECK(marked["statements"][0]["verdict"] == "proved");
    CHECK(marked["statements"][1]["verdict"] == "refuted");
    CHECK(marked["statements"][1].contains("hint"));
    CHECK(json::parse(run("lesson --json").out)["lessons"][2]["title"] == "Growth");
    CHECK(json::parse(run("lesson 3 --exercise 2 --json").out)["title"] == "The squares and one");
}

TEST_CASE(
    "a statement that makes no sense of an answer is not reached where one above it is refuted") {
    const Scratch files;
    const Run found = run("lesson 1 --exercise 1 " + files.file("answer.txt", "abc\n"));
    CHECK(found.status == 1);
    CHECK(found.out.find("  hint   The word has the letters a and b only") != std::string::npos);
}
