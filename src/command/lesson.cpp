// `algae lesson`: lessons, the files that they use, and exercises whose answers algae marks. `algae mark`: the answers alone.
//
// LESSON is the number of a lesson or a file with an exercise of your own; EXERCISE is such a file, or 4.1, the first exercise of
// lesson 4. An answer becomes a claim by the statements of the exercise, so marking means checking: right, wrong with a hint, or
// undecided, with the exit status of a question. Both verbs mark by the same functions.
//
// ANSWER may be a folder with the answers of a class. Each is then marked in a process of its own, so that one that hangs or bursts costs
// its own share of time and memory and nothing else, and all statements are looked at, for partial credit. An answer can open systems
// of the gallery and those beside the exercise, not the answers of others; messages about it do not hold its file's name, which stands in
// the table and in the names of the feedback files only. A broken answer is a row of the table, not an error of the command.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <thread>

#include "command/detail/files.hpp"
#include "command/detail/marking.hpp"
#include "command/detail/memory.hpp"
#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "language/language.hpp"
#include "lesson/lesson.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "studio/studio.hpp"

namespace algae::command {

Json as_json(const Exercise& exercise) {
    Json json{{"exercise", exercise.label()}, {"title", exercise.title}};
    if (!exercise.source.empty()) json.set("source", exercise.source);
    json.set("task", exercise.task);
    json.set("ending", exercise.ending());
    return json;
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

namespace {

constexpr std::string_view ending = ".exercise";

struct Options {
    std::string lesson;  // its number, or a file with an exercise
    std::string answer, out, feedback;
    enum class Table { none, csv, junit } table = Table::none;
    std::optional<std::uint64_t> exercise;
    bool json = false, outside = false;
    Bounds bounds;
};

Json lesson_json(const Lesson& lesson) {
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
        all.add(lesson_json(lesson));
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

// A class

constexpr const char* answer_name = "answer";  // in messages, instead of the file's

/// What the table says of one answer.
struct Row {
    std::string file, verdict, why, feedback;
    std::size_t points = 0;
    nlohmann::json statements = nlohmann::json::array();
};

/// In a process of its own: marks a text and prints what `row_of` reads.
int mark_apart(const Options& options, const Exercise& exercise, const StudioShare& share,
               const std::string& text) {
    nlohmann::json out;
    int status = success;
    try {
        bound_memory(share.memory);
        Budget budget = options.bounds.budget();
        budget.memory = share.memory;
        std::vector<std::string> folders;
        if (options.lesson.ends_with(ending)) folders.push_back(folder_of(exercise.file));
        const Mark marked = mark(exercise, text, answer_name, systems_from(folders, budget, false),
                                 budget, Demands::all);
        out = nlohmann::json::parse(as_json(exercise, marked).text());
        out["points"] = points(exercise, marked);
        out["report"] = report(exercise, marked);
    } catch (const std::bad_alloc&) {
        out = {{"why", "it needs more memory than an answer may take"}};
        status = undecided;
    } catch (const Stopped& stopped) {
        out = {{"why", stopped.what()}};
        status = undecided;
    } catch (const std::exception& error) {
        out = {{"why", printable(error.what())}};
        status = bad_input;
    }
    print(out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    std::cout.flush();
    std::fflush(stdout);
    return status;
}

Row row_of(const Exercise& exercise, const std::string& file, const Answered& answered,
           double seconds) {
    Row row{file, "undecided", "", "", 0, nlohmann::json::array()};
    const nlohmann::json found = nlohmann::json::parse(answered.answer, nullptr, false);
    if (answered.end == Answered::End::time) {
        row.why =
            fmt::format("it took longer than the {} seconds that an answer may take", seconds);
    } else if (answered.end != Answered::End::answered || !found.is_object()) {
        row.why = "it took more than its share of memory, or its work broke";
    } else if (found.contains("why")) {
        row.why = found["why"];
        if (answered.status == bad_input) row.verdict = "unreadable";
    } else {
        row.verdict = found["verdict"];
        row.points = found["points"];
        row.statements = found["statements"];
        row.feedback = found["report"];
        for (const auto& one : row.statements)
            if (row.why.empty() && one["verdict"] != "proved")
                row.why = one["text"].get<std::string>() + ": " + one["verdict"].get<std::string>();
    }
    if (row.feedback.empty())
        row.feedback = row.verdict + ": exercise " + exercise.label() + ", " + exercise.title +
                       "\n  found  " + row.why + "\n";
    row.why = row.why.substr(0, row.why.find('\n'));  // the caret's lines are for the feedback
    row.feedback += fmt::format("points: {} of {}\n", row.points, exercise.demands.size());
    return row;
}

/// A field of the table; what a spreadsheet would take for a formula begins with an apostrophe.
std::string plain_field(const std::string& text) {
    const bool is_formula =
        !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos;
    return csv_field(is_formula ? "'" + text : text);
}

std::string xml_text(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else if (code >= ' ' || c == '\n')
            out += c;
    }
    return out;
}

std::string table_of(const Options& options, const Exercise& exercise,
                     const std::vector<Row>& rows) {
    const std::size_t most = exercise.demands.size();
    if (options.json) {
        nlohmann::json answers = nlohmann::json::array();
        for (const Row& row : rows)
            answers.push_back({{"answer", row.file},
                               {"verdict", row.verdict},
                               {"points", row.points},
                               {"of", most},
                               {"why", row.why},
                               {"statements", row.statements}});
        const nlohmann::json out{{"exercise", exercise.label()},
                                 {"title", exercise.title},
                                 {"answers", std::move(answers)}};
        return out.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    }
    std::string text;
    if (options.table == Options::Table::junit) {
        std::size_t wrong = 0, open = 0;
        for (const Row& row : rows) {
            if (row.verdict == "wrong") ++wrong;
            if (row.verdict == "undecided" || row.verdict == "unreadable") ++open;
        }
        const std::string name = xml_text("exercise " + exercise.label() + ", " + exercise.title);
        text = fmt::format(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" "
            "failures=\"{}\" errors=\"{}\">\n",
            name, rows.size(), wrong, open);
        for (const Row& row : rows) {
            const std::string begin = fmt::format("  <testcase classname=\"{}\" name=\"{}\"", name,
                                                  xml_text(printable(row.file)));
            const char* kind = row.verdict == "wrong" ? "failure" : "error";
            text += row.verdict == "right"
                        ? begin + "/>\n"
                        : fmt::format("{}><{} message=\"{}\">{}</{}></testcase>\n", begin, kind,
                                      xml_text(row.why), xml_text(row.feedback), kind);
        }
        return text + "</testsuite>\n";
    }
    text = "answer,verdict,points,of,why\n";
    for (const Row& row : rows)
        text += fmt::format("{},{},{},{},{}\n", plain_field(printable(row.file)), row.verdict,
                            row.points, most, plain_field(row.why));
    return text;
}

/// The files of a folder that are answers, in the order of their names.
std::vector<std::string> answers_in(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with('.') && !entry.is_directory()) names.push_back(name);
    }
    if (failed) throw_unreadable("the folder " + folder, failed);
    if (names.empty()) throw Error(folder + ": expected files with answers, found none");
    std::ranges::sort(names);
    return names;
}

int mark_class(const Options& options, const Exercise& exercise) {
    std::error_code failed;
    if (!options.feedback.empty()) {
        make_folders(options.feedback);
        if (std::filesystem::equivalent(options.feedback, options.answer, failed))
            throw Error("--feedback: expected another folder than that of the answers, found " +
                        options.feedback);
    }
    constexpr double usual_seconds = 10;
    constexpr std::uint64_t usual_memory = std::uint64_t{1} << 30, longest = std::uint64_t{1} << 20;
    StudioShare share;
    const double seconds = options.bounds.timeout.value_or(usual_seconds);
    // Work ends by itself when its time is over, and what was found by then counts; what goes on is ended later.
    constexpr double grace = 10;
    share.seconds = seconds + grace;
    share.memory = options.bounds.memory.value_or(usual_memory);
    share.at_once = std::max(1U, std::thread::hardware_concurrency());
    const std::vector<std::string> names = answers_in(options.answer);
    const auto feedback_of = [&](const std::string& name) {
        return (std::filesystem::path(options.feedback) / (name + ".txt")).string();
    };
    if (!options.feedback.empty())
        for (const std::string& name : names)
            const FileOutput writable(feedback_of(name));  // throws where it is not
    std::vector<Row> rows(names.size());
    std::vector<std::string> texts;
    std::vector<std::size_t> of_text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::filesystem::path path = std::filesystem::path(options.answer) / names[i];
        const auto refuse_file = [&](const std::string& why) {
            rows[i] = row_of(
                exercise, names[i],
                {Answered::End::answered, bad_input, nlohmann::json{{"why", why}}.dump(), ""},
                seconds);
        };
        const auto status = std::filesystem::symlink_status(path, failed);
        if (!std::filesystem::is_regular_file(status)) {
            refuse_file("expected a file, found a link or something else");
        } else if (std::filesystem::file_size(path, failed) > longest) {
            refuse_file(fmt::format("expected at most {} bytes", longest));
        } else {
            try {
                texts.push_back(file_text(path.string(), options.bounds.budget()));
                of_text.push_back(i);
            } catch (const Error&) {
                refuse_file("it cannot be read");
            }
        }
    }
    // The time is that of each answer; reading them has set it for the whole.
    set_deadline(std::nullopt, "--timeout");
    const std::vector<Answered> answers = answer_apart(
        texts, [&](const std::string& text) { return mark_apart(options, exercise, share, text); },
        share, [](std::size_t) { return !stop.load(); });
    if (stop) throw Interrupted();
    for (std::size_t k = 0; k < answers.size(); ++k)
        rows[of_text[k]] = row_of(exercise, names[of_text[k]], answers[k], seconds);
    if (!options.feedback.empty()) {
        std::size_t replaced = 0;
        for (const Row& row : rows) {
            const std::string path = feedback_of(row.file);
            if (std::ifstream there(path, std::ios::binary); there)
                if (std::string(std::istreambuf_iterator<char>(there), {}) != row.feedback)
                    ++replaced;
            write_file(path, row.feedback);
        }
        if (replaced > 0)
            note(counted(replaced, "file") + " in " + options.feedback + " had another text and " +
                 (replaced == 1 ? "is" : "are") + " replaced; --no-clobber keeps what is there");
    }
    print(table_of(options, exercise, rows));
    return success;
}

int print_task_or_mark(const Options& options, const Exercise& exercise) {
    std::error_code ignored;
    if (!options.answer.empty() && std::filesystem::is_directory(options.answer, ignored))
        return mark_class(options, exercise);
    if (!options.feedback.empty() || options.table != Options::Table::none)
        throw Error((options.feedback.empty() ? "--table" : "--feedback") +
                    std::string(" is for the answers of a class: expected a folder, found ") +
                    options.answer);
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
    make_folders(options.out);
    std::error_code ignored;
    std::size_t count = 0;
    for (const LessonFile& file : lesson_files(lesson)) {
        const std::string path = (std::filesystem::path(options.out) / file.name).string();
        std::string place = path;
        // A file that is there and is another one may be an answer: it stays.
        for (int n = 1; std::filesystem::exists(place, ignored) &&
                        file_text(place, options.bounds.budget()) != file.text;
             ++n)
            place = path + ".new" + (n == 1 ? "" : std::to_string(n));
        if (place != path)
            note(path + " was changed and stays; the file of the lesson is " + place);
        if (!std::filesystem::exists(place, ignored)) write_file(place, file.text);
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
    print(options.json ? lesson_json(chosen).text() : lesson_text(chosen));
    return success;
}

/// EXERCISE of `mark` as `lesson` writes it: a file stays, "4.1" is exercise 1 of lesson 4.
Options as_of_lesson(Options options) {
    if (options.lesson.ends_with(ending)) return options;
    const std::size_t point = options.lesson.find('.');
    const auto is_number = [](std::string_view digits) {
        return !digits.empty() && digits.size() < 10 &&
               digits.find_first_not_of("0123456789") == std::string_view::npos;
    };
    const std::string before = options.lesson.substr(0, point),
                      behind = point == std::string::npos ? "" : options.lesson.substr(point + 1);
    if (!is_number(before) || !is_number(behind))
        throw Error("expected an exercise: lesson.exercise such as 4.1, or a file ending in " +
                    std::string(ending) + ", found " + options.lesson +
                    (is_number(before) && point == std::string::npos
                         ? "; the first exercise of this lesson is " + before + ".1"
                         : std::string()));
    options.lesson = before;
    options.exercise = std::stoull(behind);
    return options;
}

int mark(const Options& given) {
    const Options options = as_of_lesson(given);
    if (options.lesson.ends_with(ending)) return print_task_or_mark(options, own_exercise(options));
    return print_task_or_mark(options, chosen_exercise(options, chosen_lesson(options)));
}

/// The options of both verbs that are about the answer.
void add_marking_options(Verb& verb, Options& options) {
    verb.choice("--table", options.table,
                {{"csv", Options::Table::csv}, {"junit", Options::Table::junit}}, "csv|junit",
                "how the answers of a class are listed (default csv)")
        .excludes = {"--json"};
    verb.output(
            "--feedback", options.feedback, "DIR",
            "write what was found, with counterexamples and hints, into this folder, a file for "
            "each answer of a class")
        .needs = {"ANSWER"};
}

constexpr const char* answer_help =
    "a file with an answer, - for standard input, or a folder with those of a class, each "
    "of which may take --timeout seconds (10 if not given) and --max-memory (1G)";

void add_mark(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "mark", "Mark the answer to an exercise, or those of a class, by the theory",
        {"algae mark 4.1 answers-of-my-class --feedback marked",
         "algae mark squares.exercise answers --table junit", "algae mark 3.2 my-answer.lsys"},
        mark);
    verb.option("EXERCISE", options.lesson, "FILE",
                "lesson.exercise such as 4.1, or a file ending in .exercise with one of your own")
        .required = true;
    verb.option("ANSWER", options.answer, "FILE|DIR", answer_help).required = true;
    add_marking_options(verb, options);
    add_outside_flag(verb, options.outside);
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
}

}  // namespace

void add_lesson(Verbs& verbs) {
    auto [verb, options] =
        verbs.add("lesson", "Lessons, and exercises that algae marks",
                  {"algae lesson 3", "algae lesson 3 --exercise 2 my-answer.lsys",
                   "algae lesson squares.exercise my-answer.lsys",
                   "algae lesson 3 --exercise 2 answers-of-my-class --feedback marked"},
                  lesson);
    std::string numbers;
    for (std::size_t i = 1; i <= lesson_texts().size(); ++i) numbers += std::to_string(i) + '|';
    verb.option("LESSON", options.lesson, numbers + "FILE",
                "its number, or a file ending in .exercise with one of your own; without it all "
                "lessons are listed");
    verb.option("--exercise", options.exercise, natural, "K",
                "print the task of an exercise, or mark its answer")
        .needs = {"LESSON"};
    verb.option("ANSWER", options.answer, "FILE|DIR", answer_help);
    add_marking_options(verb, options);
    Option& out = verb.output("--out", options.out, "DIR",
                              "write the files that the lesson uses into this folder");
    out.needs = {"LESSON"};
    out.excludes = {"--exercise"};
    add_outside_flag(verb, options.outside);
    verb.json_flag(options.json);
    verb.bounded_by(options.bounds);
    add_mark(verbs);
}

}  // namespace algae::command
