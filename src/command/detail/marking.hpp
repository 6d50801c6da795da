#pragma once

#include "lesson/lesson.hpp"
#include "report/report.hpp"

namespace algae::command {

/// What `lesson --json` says of an exercise: its number, title, source and task, and how the name of an answer ends.
Json as_json(const Exercise& exercise);

/// What `lesson --json` says of an answer that was marked: the verdict, and each statement with its own, the argument and a hint.
Json as_json(const Exercise& exercise, const Mark& marked);

}  // namespace algae::command
