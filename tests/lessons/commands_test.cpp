#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "cli/run.hpp"
#include "lesson/lessons.hpp"
#include "lessons/markdown.hpp"

using namespace algae;

namespace {

/// Runs `algae ...` of a lesson in a folder, as a shell there would.
Run run_in(const Scratch& folder, const std::string& command) {
    return run(command.substr(std::string("algae ").size()),
               "cd '" + folder.path().string() + "' &&");
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

}  // namespace

TEST_CASE(
    "every command in a lesson prints what the lesson shows, and makes the pictures it shows") {
    CHECK(lessons().size() == 12);
    for (const Lesson& lesson : lessons()) {
        const Scratch folder;
        CAPTURE(lesson.path);
        for (const Block& block : blocks(lesson.text)) {
            if (!block.name.empty()) folder.file(block.name, joined(block.lines));
            if (block.kind != "console") continue;
            for (const Command& command : commands(block)) {
                CAPTURE(command.line);
                REQUIRE(command.line.starts_with("algae "));
                const Run found = run_in(folder, command.line);
                const std::string said = found.out + found.err;
                CHECK_MESSAGE(matches(command.shown, 0, split(said), 0), said);
                CHECK(found.status <= 3);
            }
        }
        const std::vector<std::string> shown = pictures(lesson.text);
        CHECK(!shown.empty());
        for (const std::string& picture : shown) {
            CAPTURE(picture);
            CHECK(std::filesystem::exists(folder.path() / picture));
        }
    }
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
            const std::string text =
                text_of(std::string(ALGAE_SOURCE_DIR) + "/" + block.region.substr(0, hash));
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
