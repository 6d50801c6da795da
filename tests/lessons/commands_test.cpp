#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "command/run.hpp"
#include "lesson/lesson.hpp"
#include "lessons/markdown.hpp"
#include "places.hpp"

using namespace algae;

namespace {

/// Runs `algae ...` of a lesson in a folder, as a shell there would. On a busy machine nothing says how far it is.
Run run_in(const Scratch& folder, const std::string& command) {
    return run(command.substr(std::string("algae ").size()),
               "cd '" + folder.path().string() + "' && ALGAE_PROGRESS=1000000");
}

/// Whether the lines are those printed, where a line `...` stands for any lines.
bool matches(const std::vector<std::string>& shown, std::size_t i,
             const std::vector<std::string>& printed, std::size_t j) {
    if (i == shown.size()) return j == printed.size();
    if (shown[i] == "...") {
        for (std::size_t k = j; k <= printed.size(); ++k)
            if (matches(shown, i + 1, printed, k)) return true;
        return false;
    }
    return j < printed.size() && shown[i] == printed[j] && matches(shown, i + 1, printed, j + 1);
}

/// Types the commands of a page in an empty folder, with the files that the page names, and compares
/// what they print with what stands below them.
void check_page(std::string_view text, const Scratch& folder) {
    for (const Block& block : blocks(text)) {
        if (!block.name.empty()) {
            std::filesystem::create_directories((folder.path() / block.name).parent_path());
            folder.file(block.name, joined(block.lines));
        }
        if (block.kind != "console") continue;
        for (const auto& command : commands(block)) {
            CAPTURE(command.line);
            REQUIRE(command.line.starts_with("algae "));
            const Run found = run_in(folder, command.line);
            const std::string said = found.out + found.err;
            CHECK_MESSAGE(matches(command.shown, 0, split(said), 0), said);
            CHECK(found.status <= 3);
        }
    }
}

std::string page(const std::string& name) { return text_of(source_folder() + "/" + name); }

}  // namespace

TEST_CASE(
    "every command in a lesson prints what the lesson shows, and makes the pictures it shows") {
    CHECK(lessons().size() == 14);
    for (const Lesson& lesson : lessons()) {
        const Scratch folder;
        CAPTURE(lesson.path);
        check_page(lesson.text, folder);
        const std::vector<std::string> shown = pictures(lesson.text);
        CHECK(!shown.empty());
        for (const std::string& picture : shown) {
            CAPTURE(picture);
            CHECK(std::filesystem::exists(folder.path() / picture));
        }
    }
}

TEST_CASE("the tour uses every verb, and its commands print what it shows") {
    const std::string tour = page("TOUR.md");
    const Scratch folder;
    check_page(tour, folder);
    CHECK(std::filesystem::exists(folder.path() / "pictures/index.html"));
    std::istringstream help(run("--help").out);
    std::size_t verbs = 0;
    for (std::string line; std::getline(help, line) && !line.starts_with("Subcommands:");) continue;
    for (std::string line; std::getline(help, line) && line.starts_with("  ");) {
        std::string verb;
        std::istringstream(line) >> verb;
        CAPTURE(verb);
        CHECK(tour.find('`' + verb + '`') != std::string::npos);
        ++verbs;
    }
    CHECK(verbs > 20);
}

TEST_CASE("the README quotes what the command prints") {
    std::string quoted, command;
    std::size_t rows = 0;
    for (const std::string& line : split(page("README.md"))) {
        const std::size_t begin = line.find("`algae "), end = line.find('`', begin + 1);
        if (begin != std::string::npos) {
            command = line.substr(begin + 7, end - begin - 7);
            quoted.clear();
        }
        if (line.starts_with("> ")) quoted += line.substr(2) + "\n";
        if (line.starts_with("| ") && line != "| | |" && command.starts_with("growth")) {
            const std::size_t bar = line.find(" | ", 2);
            const std::string key = line.substr(2, bar - 2),
                              value = line.substr(bar + 3, line.size() - bar - 5);
            CAPTURE(line);
            ++rows;
            const std::vector<std::string> printed = split(run(command).out);
            CHECK(std::any_of(printed.begin(), printed.end(), [&](const std::string& one) {
                return one.starts_with(key + " ") && one.ends_with(" " + value);
            }));
        }
        if (line.empty() && !quoted.empty()) {
            CAPTURE(command);
            CHECK(run(command).out == "no\n" + quoted);
            quoted.clear();
            ++rows;
        }
    }
    CHECK(rows == 4);
}

TEST_CASE("code in a lesson is a region of a file, and not retyped") {
    std::size_t regions = 0;
    for (const Lesson& lesson : lessons())
        for (const Block& block : blocks(lesson.text)) {
            CAPTURE(lesson.path);
            CHECK((block.kind != "cpp" || !block.region.empty()));
            if (block.region.empty()) continue;
            ++regions;
            CAPTURE(block.region);
            CHECK(block.lines.empty());
            const std::size_t hash = block.region.find('#');
            REQUIRE(hash != std::string::npos);
            const std::string text = text_of(source_folder() + "/" + block.region.substr(0, hash));
            const std::string name = block.region.substr(hash + 1);
            CHECK(text.find("//> " + name + "\n") != std::string::npos);
            CHECK(text.find("//< " + name + "\n") != std::string::npos);
        }
    CHECK(regions > 5);
}

TEST_CASE("a lesson is about one sitting and ends with four to six exercises") {
    for (const Lesson& lesson : lessons()) {
        CAPTURE(lesson.path);
        CHECK(lesson.title.size() > 5);
        CHECK(lesson.exercises.size() >= 4);
        CHECK(lesson.exercises.size() <= 6);
        for (std::size_t i = 0; i < lesson.exercises.size(); ++i)
            CHECK(lesson.exercises[i].number == i + 1);
    }
}
