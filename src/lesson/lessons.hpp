#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lesson/exercise.hpp"

namespace algae {

/// A lesson that comes with algae, and its exercises in order.
struct Lesson {
    std::size_t number = 0;
    std::string title;      // its first heading, without the number
    std::string_view text;  // Markdown
    std::string path;       // from the root of the repository
    std::vector<Exercise> exercises;
};

/// All of them, in order.
std::vector<Lesson> lessons();

/// The task of an exercise in plain lines: its number, title, source, what is asked and what the answer is.
std::string task_text(const Exercise& exercise);

/// The lesson with its exercises, as Markdown in lines to be read as they are; code of algae stands where the
/// lesson names its region.
std::string lesson_text(const Lesson& lesson);

/// A file that commands of a lesson use.
struct LessonFile {
    std::string name, text;
};

/// The files of a lesson, in the order in which it shows them.
std::vector<LessonFile> lesson_files(const Lesson& lesson);

}  // namespace algae
