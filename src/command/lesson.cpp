// `algae lesson`: lessons, the files that they use, and exercises whose answers algae marks.
//
// LESSON is the number of a lesson or a file with an exercise of your own. An answer becomes a claim by the
// statements of the exercise, so marking means checking: right, wrong with a hint, or undecided, with the
// exit status of a question.

#include <fmt/format.h>

#include <filesystem>

#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "language/language.hpp"
#include "lesson/lesson.hpp"
#include "notation/notation.hpp"

namespace algae::command {

namespace {

constexpr std::string_view ending = ".exercise";

struct Options {
    std::string lesson;  // its number, or a file with an exercise
    std::string answer, out;
    std::optional<std::uint64_t> exercise;
    bool json = false, outside = false;
    Bounds bounds;
};

Json as_json(const Exercise& exercise) {
    Json json{{"exercise", exercise.label()}, {"title", exercise.title}};
    if (!exercise.source.empty()) json.set("source", exercise.source);
    json.set("task", exercise.task);
    return json;
}

Json as_json(const Lesson& lesson) {
    Json exercises = Json::array();
    for (const Exercise& exercise : lesson.exercises) exercises.add(as_json(exercise));
    return {{"lesson", lesson.number},
            {"title", lesson.title},
            {"path", lesson.path},
            {"exercises", std::move(exercises)}};
}

int list_lessons(const Options& options) {
    Json all = Json::array();
    std::string text;
    for (const Lesson& lesson : lessons()) {
        all.add(as_json(lesson));
        text += fmt::format("{:>2}  {}\n", lesson.number, lesson.title);
        for (const Exercise& exercise : lesson.exercises)
            text += fmt::format("      {:<5} {}{}\n", exercise.label(), exercise.title,
                                exercise.source.empty() ? "" : " (" + exercise.source + ")");
    }
    text +=
        "\n`algae lesson 1` prints a lesson, `algae lesson 1 --out FOLDER` writes the files that "
        "it uses.\n";
    print(options.json ? Json{{"lessons", all}}.text() : text);
    return success;
}

Lesson chosen_lesson(const Options& options) {
    std::vector<Lesson> all = lessons();
    for (Lesson& lesson : all)
        if (std::to_string(lesson.number) == options.lesson) return std::move(lesson);
    throw Error("expected a lesson from 1 to " + std::to_string(all.size()) +
                " or a file ending in .exercise, found " + options.lesson);
}

const Exercise& chosen_exercise(const Options& options, const Lesson& lesson) {
    const std::uint64_t number = *options.exercise;
    for (const Exercise& exercise : lesson.exercises)
        if (exercise.number == number) return exercise;
    throw Error("lesson " + std::to_string(lesson.number) + " has the exercises 1 to " +
                std::to_string(lesson.exercises.size()) + ", found " + std::to_string(number));
}

Json as_json(const Exercise& exercise, const Mark& marked) {
    Json statements = Json::array();
    for (const MarkedDemand& demand : marked.demands) {
        Json entry{{"text", demand.text},
                   {"verdict", to_string(demand.judgement.truth)},
                   {"argument", demand.judgement.argument}};
        if (demand.judgement.truth == Truth::refuted && !demand.hint.empty())
            entry.set("hint", demand.hint);
        statements.add(std::move(entry));
    }
    return {{"exercise", exercise.label()},
            {"title", exercise.title},
            {"verdict", marked.verdict == Truth::proved    ? "right"
                        : marked.verdict == Truth::refuted ? "wrong"
                                                           : "undecided"},
            {"statements", std::move(statements)}};
}

/// Systems beside the answer; for an exercise of one's own those beside it come first.
SystemSource systems_for(const Options& options, const Exercise& exercise, const Budget& budget) {
    std::vector<std::string> folders{folder_of(options.answer)};
    if (options.lesson.ends_with(ending)) folders.insert(folders.begin(), folder_of(exercise.file));
    return systems_from(folders, budget, options.outside);
}

int mark_answer(const Options& options, const Exercise& exercise) {
    const Budget budget = options.bounds.budget();
    const std::string text = file_text(options.answer, budget);
    const Mark marked =
        mark(exercise, text, options.answer == "-" ? "standard input" : options.answer,
             systems_for(options, exercise, budget), budget);
    print(options.json ? as_json(exercise, marked).text() : report(exercise, marked));
    return status_of(marked.verdict);
}

int print_task_or_mark(const Options& options, const Exercise& exercise) {
    if (!options.answer.empty()) return mark_answer(options, exercise);
    print(options.json ? as_json(exercise).text() : task_text(exercise));
    return success;
}

/// An exercise that does not come with algae.
Exercise own_exercise(const Options& options) {
    if (options.exercise)
        throw Error("--exercise chooses one of a lesson; " + options.lesson + " is one itself");
    if (!options.out.empty())
        throw Error("--out writes the files of a lesson; " + options.lesson + " is an exercise");
    const std::size_t name = options.lesson.size() - ending.size();
    const Budget budget = options.bounds.budget();
    const Exercise exercise =
        read_exercise(file_text(options.lesson, budget), options.lesson.substr(0, name));
    check_exercise(exercise, systems_for(options, exercise, budget), options.answer.empty());
    return exercise;
}

int write_files(const Options& options, const Lesson& lesson) {
    std::filesystem::create_directories(options.out);
    std::size_t count = 0;
    for (const LessonFile& file : lesson_files(lesson)) {
        const std::string path = (std::filesystem::path(options.out) / file.name).string();
        std::string place = path;
        // A file that is there and is another one may be an answer: it stays.
        for (int n = 1; std::filesystem::exists(place) &&
                        file_text(place, options.bounds.budget()) != file.text;
             ++n)
            place = path + ".new" + (n == 1 ? "" : std::to_string(n));
        if (place != path)
            note(path + " was changed and stays; the file of the lesson is " + place);
        if (!std::filesystem::exists(place)) write_file(place, file.text);
        ++count;
    }
    print(counted(count, "file") + " of lesson " + options.lesson + " in " + options.out + "\n");
    return success;
}

int lesson(const Options& options) {
    if (options.lesson.empty()) return list_lessons(options);
    if (options.lesson.ends_with(ending)) return print_task_or_mark(options, own_exercise(options));
    const Lesson chosen = chosen_lesson(options);
    if (options.exercise) return print_task_or_mark(options, chosen_exercise(options, chosen));
    if (!options.answer.empty())
        throw Error("expected --exercise before the answer, found " + options.answer);
    if (!options.out.empty()) return write_files(options, chosen);
    print(options.json ? as_json(chosen).text() : lesson_text(chosen));
    return success;
}

}  // namespace

void add_lesson(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("lesson", "Lessons, and exercises that algae marks",
                  {"algae lesson 3", "algae lesson 3 --exercise 2 my-answer.lsys",
                   "algae lesson squares.exercise my-answer.lsys"},
                  lesson);
    std::string numbers;
    for (std::size_t i = 1; i <= lesson_texts().size(); ++i) numbers += std::to_string(i) + '|';
    verb.option("LESSON", options.lesson, numbers + "FILE",
                "its number, or a file ending in .exercise with one of your own; without it all "
                "lessons are listed");
    verb.option("--exercise", options.exercise, natural, "K",
                "print the task of an exercise, or mark its answer")
        .needs = {"LESSON"};
    verb.option("ANSWER", options.answer, "FILE", "a file with an answer, or - for standard input");
    Option& out = verb.output("--out", options.out, "DIR",
                              "write the files that the lesson uses into this folder");
    out.needs = {"LESSON"};
    out.excludes = {"--exercise"};
    add_outside_flag(verb, options.outside);
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
