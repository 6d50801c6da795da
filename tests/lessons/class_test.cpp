#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "command/run.hpp"
#include "exact/exact.hpp"
#include "lesson/lesson.hpp"
#include "lessons/answers.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::optional<Mark> marked(const Exercise& exercise, const std::string& text, Demands looked_at) {
    try {
        return mark(exercise, text, "answer", from_gallery, {}, looked_at);
    } catch (const Error&) {
        return std::nullopt;  // Diagnostics too
    }
}

/// A class that answers exercise 4.1: right ones, wrong ones, and those that want to do harm.
void write_class(const Scratch& scratch, int pupils) {
    const fs::path folder = scratch.path() / "class";
    fs::create_directories(folder);
    const auto write = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder / name, std::ios::binary) << text;
    };
    for (int i = 0; i < pupils; ++i)
        write("pupil-" + std::to_string(100 + i) + ".lsys",
              i % 2 == 0 ? text_of((answers / "04-1.lsys").string())
                         : "axiom F\nF -> F+F-F\nangle 60\n");
    std::string long_rule = "axiom F\nF -> ", deep = "axiom ";
    for (int i = 0; i < 3000; ++i) long_rule += "F+";
    write("x-hangs.lsys", long_rule + "\nangle 7.1\n");
    for (int i = 0; i < 50'000; ++i) deep += "[";
    write("x-deep.lsys", deep + "F\n");
    write("x-binary.lsys", std::string("axiom\0F\n", 8));
    write("x-large.lsys", "axiom " + std::string((1 << 20) + 1, 'F'));
    write("=cmd,\"x\".lsys", "axiom F\nF -> F\n");
    scratch.file("secret.lsys", "axiom F-F-F-F\n");
    fs::create_symlink(scratch.path() / "secret.lsys", folder / "x-link.lsys");
}

}  // namespace

TEST_CASE("all demands of an answer agree with the marking that ends at the first refuted one") {
    std::size_t right = 0, wrong = 0, unreadable = 0, partly = 0;
    for (const fs::path& folder : {answers, answers / "wrong"})
        for (const auto& entry : fs::directory_iterator(folder)) {
            if (!entry.is_regular_file()) continue;
            const std::string name = entry.path().stem().string().substr(0, 4);
            CAPTURE(entry.path().filename().string());
            for (const Lesson& lesson : lessons())
                for (const Exercise& exercise : lesson.exercises) {
                    if (!name.starts_with(exercise.file.substr(0, exercise.file.find('.'))))
                        continue;
                    const std::string text = text_of(entry.path().string());
                    const auto first = marked(exercise, text, Demands::to_first_refuted);
                    const auto all = marked(exercise, text, Demands::all);
                    REQUIRE(first.has_value() == all.has_value());
                    if (!all) {
                        ++unreadable;
                        continue;
                    }
                    CHECK(all->verdict == first->verdict);
                    CHECK(all->demands.size() >= exercise.demands.size());
                    // What was looked at first is the same.
                    for (std::size_t i = 0; i < first->demands.size(); ++i)
                        CHECK(all->demands[i].judgement.truth == first->demands[i].judgement.truth);
                    const std::size_t found = points(exercise, *all);
                    CHECK((found == exercise.demands.size() || all->verdict != Truth::proved));
                    if (all->verdict == Truth::proved) ++right;
                    if (all->verdict == Truth::refuted) ++wrong;
                    if (all->verdict == Truth::refuted && found > 0) ++partly;
                }
        }
    CHECK(right >= 54);
    CHECK(wrong > 80);
    CHECK(partly > 20);
    MESSAGE(right << " right, " << wrong << " wrong, of which " << partly << " have points, "
                  << unreadable << " unreadable");
}

TEST_CASE("a class is marked, and an answer that wants to do harm costs its own time only") {
    const Scratch scratch;
    write_class(scratch, 20);
    const std::string folder = "'" + scratch.file("class") + "'", feedback = scratch.file("marked");
    const Run table =
        run("lesson 4 --exercise 1 " + folder + " --timeout 4 --feedback '" + feedback + "'");
    CHECK(table.status == 0);
    std::map<std::string, std::string> rows;
    std::istringstream lines(table.out);
    std::string line;
    std::getline(lines, line);
    CHECK(line == "answer,verdict,points,of,why");
    while (std::getline(lines, line)) rows[line.substr(0, line.find(".lsys"))] = line;
    CHECK(rows.size() == 26);
    for (int i = 0; i < 20; ++i)
        CHECK(rows["pupil-" + std::to_string(100 + i)].find(
                  i % 2 == 0 ? "right,4,4" : "wrong,1,4") != std::string::npos);
    CHECK(rows["x-hangs"].find("undecided,1,4,") != std::string::npos);
    CHECK(rows["x-deep"].find("right") == std::string::npos);
    CHECK(rows["x-binary"].find("unreadable,0,4") != std::string::npos);
    CHECK(rows["x-large"].find("expected at most 1048576 bytes") != std::string::npos);
    CHECK(rows["x-link"].find("unreadable,0,4,\"expected a file, found a link") !=
          std::string::npos);
    // What a spreadsheet would take for a formula is a text.
    CHECK(table.out.find("\"'=cmd,\"\"x\"\".lsys\",wrong") != std::string::npos);
    // Names stand in the table, not in what is said on the way, nor in the feedback's text.
    CHECK(table.err.find("pupil") == std::string::npos);
    const std::string said = text_of(feedback + "/pupil-101.lsys.txt");
    CHECK(said.find("wrong: exercise 4.1") == 0);
    CHECK(said.find("hint   Compare the form first") != std::string::npos);
    CHECK(said.find("points: 1 of 4") != std::string::npos);
    CHECK(said.find("pupil") == std::string::npos);
    CHECK(text_of(feedback + "/x-binary.lsys.txt").find("found a NUL byte") != std::string::npos);

    const json found = json::parse(
        run("lesson 4 --exercise 1 " + folder + " --timeout 4 --json").out, nullptr, false);
    REQUIRE(found.is_object());
    CHECK(found["answers"].size() == 26);
    std::size_t looked_at = 0;
    for (const json& answer : found["answers"]) {
        std::size_t proved = 0;
        for (const json& statement : answer["statements"])
            if (statement["verdict"] == "proved") ++proved;
        CHECK(proved == answer["points"]);
        looked_at += answer["statements"].size();
    }
    CHECK(looked_at >= 84);
    const std::string suite =
        run("lesson 4 --exercise 1 " + folder + " --timeout 4 --table junit").out;
    CHECK(suite.find("tests=\"26\" failures=\"") != std::string::npos);
    CHECK(suite.find("name=\"=cmd,&quot;x&quot;.lsys\"><failure message=") != std::string::npos);
}

TEST_CASE(
    "an answer cannot open those of others, a folder of answers is not that of the feedback") {
    const Scratch scratch;
    fs::create_directories(scratch.path() / "class");
    scratch.file("class/theirs.lsys", "axiom a\na -> aa\n");
    scratch.file("class/mine.claim", "let A = L(D0L theirs.lsys)\nlet B = {a}\n");
    const std::string folder = "'" + scratch.file("class") + "'";
    const json found =
        json::parse(run("lesson 10 --exercise 1 " + folder + " --json").out, nullptr, false);
    REQUIRE(found["answers"].size() == 2);
    for (const json& answer : found["answers"]) CHECK(answer["verdict"] == "unreadable");
    const Run same = run("lesson 10 --exercise 1 " + folder + " --feedback " + folder);
    CHECK(same.status == 2);
    CHECK(same.err.find("expected another folder than that of the answers") != std::string::npos);
    fs::create_directories(scratch.path() / "empty");
    const Run empty = run("lesson 10 --exercise 1 '" + scratch.file("empty") + "'");
    CHECK(empty.status == 2);
    CHECK(empty.err.find("expected files with answers, found none") != std::string::npos);
    const Run single =
        run("lesson 1 --exercise 1 '" + (answers / "01-1.txt").string() + "' --table csv");
    CHECK(single.status == 2);
    CHECK(single.err.find("--table is for the answers of a class") != std::string::npos);
}

TEST_CASE("the time of an answer is not that of its class") {
    const Scratch scratch;
    const std::filesystem::path folder = scratch.path() / "class";
    std::filesystem::create_directories(folder);
    std::string long_rule = "axiom F\nF -> ";
    for (int i = 0; i < 3000; ++i) long_rule += "F+";
    constexpr int answers_that_hang = 10;
    for (int i = 0; i < answers_that_hang; ++i)
        std::ofstream(folder / ("x-hangs-" + std::to_string(i) + ".lsys"))
            << long_rule << "\nangle 7.1\n";
    std::ofstream(folder / "zz.lsys") << "axiom F\nF -> F\n";
    const Run table = run("lesson 4 --exercise 1 '" + folder.string() + "' --timeout 1");
    CHECK(table.status == 0);
    CHECK(std::count(table.out.begin(), table.out.end(), '\n') == answers_that_hang + 2);
}
