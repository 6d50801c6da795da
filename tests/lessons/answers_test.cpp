#include <doctest/doctest.h>

#include <filesystem>
#include <map>

#include "command/run.hpp"
#include "exact/exact.hpp"
#include "lesson/lesson.hpp"
#include "lessons/answers.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;
namespace fs = std::filesystem;

namespace {

/// The files of a folder by their names without the ending.
std::map<std::string, fs::path> files_of(const fs::path& folder) {
    std::map<std::string, fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) files[entry.path().stem().string()] = entry.path();
    return files;
}

std::string key(const Exercise& exercise) {
    return exercise.file.substr(0, exercise.file.find('.'));
}

}  // namespace

TEST_CASE("every model answer is marked right") {
    const auto files = files_of(answers);
    std::size_t count = 0;
    for (const Lesson& lesson : lessons())
        for (const Exercise& exercise : lesson.exercises) {
            ++count;
            CAPTURE(exercise.file);
            REQUIRE(files.contains(key(exercise)));
            const fs::path& file = files.at(key(exercise));
            const Mark marked =
                mark(exercise, text_of(file), file.filename().string(), from_gallery);
            CHECK_MESSAGE(marked.verdict == Truth::proved, report(exercise, marked));
            CHECK(marked.demands.size() >= exercise.demands.size());
        }
    CHECK(files.size() == count);
}

TEST_CASE("nothing is wrong with the statements of any exercise before there is an answer") {
    for (const Lesson& lesson : lessons())
        for (const Exercise& exercise : lesson.exercises) {
            CAPTURE(exercise.file);
            CHECK_NOTHROW(check_exercise(exercise, from_gallery));
        }
}

TEST_CASE("of every exercise three wrong answers are refused, each for its reason") {
    const auto files = files_of(answers / "wrong");
    std::size_t count = 0;
    for (const Lesson& lesson : lessons())
        for (const Exercise& exercise : lesson.exercises)
            for (const char* letter : {"-a", "-b", "-c"}) {
                ++count;
                CAPTURE(exercise.file);
                REQUIRE(files.contains(key(exercise) + letter));
                const fs::path& file = files.at(key(exercise) + letter);
                CAPTURE(file.filename().string());
                const std::string text = text_of(file), sign = "# refused: ";
                REQUIRE(text.starts_with(sign));
                const std::string reason = text.substr(sign.size(), text.find('\n') - sign.size());
                CHECK(reason.size() > 5);
                try {
                    const Mark marked =
                        mark(exercise, text, file.filename().string(), from_gallery);
                    CHECK(marked.verdict == Truth::refuted);
                    CHECK_MESSAGE(report(exercise, marked).find(reason) != std::string::npos,
                                  report(exercise, marked));
                } catch (const Error& error) {
                    FAIL_CHECK(error.what());
                }
            }
    CHECK(files.size() == count);
}

TEST_CASE("no file that a lesson shows is the answer to one of its exercises") {
    for (const Lesson& lesson : lessons())
        for (const LessonFile& file : lesson_files(lesson))
            for (const Exercise& exercise : lesson.exercises) {
                if (exercise.kind != Exercise::Kind::system || !file.name.ends_with(".lsys"))
                    continue;
                CAPTURE(exercise.file);
                CAPTURE(file.name);
                bool right = false;
                try {
                    right =
                        mark(exercise, file.text, file.name, from_gallery).verdict == Truth::proved;
                } catch (const Error&) {
                }
                CHECK_FALSE(right);
            }
}
