#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/claims.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "lesson/lessons.hpp"
#include "lesson/mark.hpp"
#include "notation/gallery.hpp"

namespace algae::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::size_t lesson = 0, exercise = 0;
    std::string answer;
    bool json = false;
    Bounds bounds;
};

Json as_json(const Exercise& exercise) {
    Json json{{"exercise", exercise.label()}, {"title", exercise.title}};
    if (!exercise.source.empty()) json["source"] = exercise.source;
    json["task"] = exercise.task;
    return json;
}

Json as_json(const Lesson& lesson) {
    Json exercises = Json::array();
    for (const Exercise& exercise : lesson.exercises) exercises.push_back(as_json(exercise));
    return {{"lesson", lesson.number},
            {"title", lesson.title},
            {"path", lesson.path},
            {"exercises", std::move(exercises)}};
}

int list(const Options& options) {
    Json all = Json::array();
    std::string text;
    for (const Lesson& lesson : lessons()) {
        all.push_back(as_json(lesson));
        text += fmt::format("{:>2}  {}\n", lesson.number, lesson.title);
        for (const Exercise& exercise : lesson.exercises)
            text += fmt::format("      {:<5} {}{}\n", exercise.label(), exercise.title,
                                exercise.source.empty() ? "" : " (" + exercise.source + ")");
    }
    print(options.json ? Json{{"lessons", all}}.dump(2) + "\n" : text);
    return success;
}

Lesson chosen_lesson(const Options& options) {
    std::vector<Lesson> all = lessons();
    for (Lesson& lesson : all)
        if (lesson.number == options.lesson) return std::move(lesson);
    throw Error("expected a lesson from 1 to " + std::to_string(all.size()) + ", found " +
                std::to_string(options.lesson));
}

const Exercise& chosen_exercise(const Options& options, const Lesson& lesson) {
    for (const Exercise& exercise : lesson.exercises)
        if (exercise.number == options.exercise) return exercise;
    throw Error("lesson " + std::to_string(lesson.number) + " has the exercises 1 to " +
                std::to_string(lesson.exercises.size()) + ", found " +
                std::to_string(options.exercise));
}

Json as_json(const Exercise& exercise, const Mark& marked) {
    Json statements = Json::array();
    for (const MarkedDemand& demand : marked.demands) {
        Json entry{{"text", demand.text},
                   {"verdict", to_string(demand.judgement.truth)},
                   {"argument", demand.judgement.argument}};
        if (demand.judgement.truth == Truth::refuted && !demand.hint.empty())
            entry["hint"] = demand.hint;
        statements.push_back(std::move(entry));
    }
    return {{"exercise", exercise.label()},
            {"title", exercise.title},
            {"verdict", marked.verdict == Truth::proved    ? "right"
                        : marked.verdict == Truth::refuted ? "wrong"
                                                           : "undecided"},
            {"statements", std::move(statements)}};
}

int mark_answer(const Options& options, const Exercise& exercise) {
    const Budget budget = options.bounds.budget();
    const std::string text = file_text(options.answer, budget);
    const bool piped = options.answer == "-";
    const std::string folder =
        piped ? "" : std::filesystem::path(options.answer).parent_path().string();
    const Mark marked = mark(exercise, text, piped ? "standard input" : options.answer,
                             systems_from(folder.empty() ? "." : folder, budget), budget);
    print(options.json ? as_json(exercise, marked).dump(2) + "\n" : report(exercise, marked));
    return marked.verdict == Truth::proved    ? success
           : marked.verdict == Truth::refuted ? refuted
                                              : undecided;
}

int lesson(const Options& options) {
    if (options.lesson == 0) return list(options);
    const Lesson chosen = chosen_lesson(options);
    if (options.exercise == 0) {
        print(options.json ? as_json(chosen).dump(2) + "\n" : lesson_text(chosen));
        return success;
    }
    const Exercise& exercise = chosen_exercise(options, chosen);
    if (!options.answer.empty()) return mark_answer(options, exercise);
    print(options.json ? as_json(exercise).dump(2) + "\n" : task_text(exercise));
    return success;
}

/// "1|2|3"
std::string numbers_to(std::size_t last) {
    std::string all;
    for (std::size_t i = 1; i <= last; ++i) all += (i > 1 ? "|" : "") + std::to_string(i);
    return all;
}

}  // namespace

void add_lesson(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb =
        add_verb(verbs, "lesson", "Lessons, and exercises that algae marks",
                 "  algae lesson 3\n  algae lesson 3 --exercise 2 my-answer.lsys", options, lesson);
    CLI::Option* const number =
        verb.add_option("NUMBER", options->lesson, "a lesson; without one all are listed")
            ->type_name(numbers_to(lesson_texts().size()));
    CLI::Option* const exercise =
        verb.add_option("--exercise", options->exercise,
                        "print the task of an exercise, or mark its answer")
            ->needs(number)
            ->check(CLI::PositiveNumber.description(""))
            ->type_name("K");
    verb.add_option("ANSWER", options->answer, "a file with an answer, or - for standard input")
        ->type_name("FILE")
        ->needs(exercise);
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
