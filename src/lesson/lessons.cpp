#include <algorithm>
#include <charconv>
#include <sstream>

#include "lesson/lesson.hpp"
#include "notation/notation.hpp"

// Lessons as they are read: Markdown with fenced blocks that name files and regions of code.
//
// The texts of lessons, exercises and code are built into the library. A block ```lsys name=a.lsys is a file that
// commands of the lesson use, and is written out as it stands. A block with region=FILE#NAME is empty in the source; the lines between
// `//> NAME` and `//< NAME` of that file are put in, moved to the left, so that a lesson always shows the code as it is.

namespace algae {

namespace {

/// Cuts off the first line, with its line break.
std::string_view take_line(std::string_view& text) {
    const std::size_t size = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, size);
    text.remove_prefix(size);
    return line;
}

std::string_view without_break(std::string_view line) {
    return line.ends_with('\n') ? line.substr(0, line.size() - 1) : line;
}

/// What the opening line of a block says.
Fence opened(std::string_view line) {
    Fence fence;
    std::istringstream words{std::string(line.substr(3))};
    words.exceptions(std::ios::badbit);
    words >> fence.kind;
    for (std::string word; words >> word;) {
        if (word.starts_with("name=")) fence.name = word.substr(5);
        if (word.starts_with("region=")) fence.region = word.substr(7);
    }
    return fence;
}

}  // namespace

std::vector<Fence> fences(std::string_view markdown) {
    std::vector<Fence> all;
    while (!markdown.empty()) {
        const std::string_view line = take_line(markdown);
        if (!line.starts_with("```")) continue;
        Fence fence = opened(line);
        const char* const begin = markdown.data();
        while (!markdown.empty() && !markdown.starts_with("```")) take_line(markdown);
        fence.text = {begin, static_cast<std::size_t>(markdown.data() - begin)};
        all.push_back(std::move(fence));
        if (!markdown.empty()) take_line(markdown);
    }
    return all;
}

std::string region_of(std::string_view code, std::string_view name) {
    std::string region;
    std::size_t indent = std::string_view::npos;
    bool inside = false;
    while (!code.empty()) {
        const std::string_view line = take_line(code);
        const std::string_view plain = without_break(line);
        const std::size_t begin = std::min(plain.find_first_not_of(' '), plain.size());
        const std::string_view words = plain.substr(begin);
        const bool mark = words.size() > 4 && words.substr(4) == name;
        if (mark && words.starts_with("//< ")) inside = false;
        if (inside) {
            if (indent == std::string_view::npos) indent = begin;
            region += line.substr(std::min(indent, begin));
        }
        if (mark && words.starts_with("//> ")) inside = true;
    }
    return region;
}

namespace {

constexpr std::size_t width = 100;

/// Broken into lines between words; paragraphs stay.
std::string wrapped(const std::string& text) {
    std::string result;
    std::size_t column = 0, breaks = 0;
    std::string word;
    const auto put = [&] {
        if (word.empty()) return;
        const auto size = static_cast<std::size_t>(
            std::count_if(word.begin(), word.end(), [](char c) { return (c & 0xC0) != 0x80; }));
        if (breaks > 1 || (column > 0 && column + 1 + size > width)) {
            result += breaks > 1 ? "\n\n" : "\n";
            column = 0;
        } else if (column > 0) {
            result += ' ';
            ++column;
        }
        result += word;
        column += size;
        word.clear();
        breaks = 0;
    };
    for (const char c : text) {
        if (c == ' ' || c == '\n') {
            put();
            breaks += c == '\n';
        } else {
            word += c;
        }
    }
    put();
    return result;
}

std::string what_to_hand_in(const Exercise& exercise) {
    switch (exercise.kind) {
        case Exercise::Kind::system:
            return "The answer is a system, a file `my-answer.lsys`.";
        case Exercise::Kind::language:
            return "The answer is a language as claims write it, such as `{a, aa}` or `/a*/`, in a "
                   "file "
                   "`my-answer.txt`.";
        case Exercise::Kind::word:
            return "The answer is one word, in a file `my-answer.txt`.";
        case Exercise::Kind::claim: {
            std::string names;
            for (const std::string& name : exercise.names)
                names += (names.empty()                   ? ""
                          : name == exercise.names.back() ? " and "
                                                          : ", ") +
                         name;
            return "The answer is a file `my-answer.claim` that defines " + names + " (`let " +
                   exercise.names.front() + " = ...`).";
        }
    }
    return {};
}

std::string title_of(std::string_view text) {
    std::string line(text.substr(0, text.find('\n')));
    const std::size_t begin = line.find_first_not_of("# ");
    if (begin == std::string::npos) return line;
    line.erase(0, begin);
    const std::size_t point = line.find(". ");
    return point < 3 ? line.substr(point + 2) : line;
}

}  // namespace

std::vector<Lesson> lessons() {
    std::vector<Lesson> all;
    for (const GalleryEntry& entry : lesson_texts()) {
        Lesson lesson;
        std::from_chars(entry.name.data(), entry.name.data() + entry.name.size(), lesson.number);
        lesson.title = title_of(entry.text);
        lesson.text = entry.text;
        lesson.path = entry.path;
        for (const GalleryEntry& text : exercise_texts()) {
            Exercise exercise = read_exercise(text.text, std::string(text.name));
            if (exercise.lesson == lesson.number) lesson.exercises.push_back(std::move(exercise));
        }
        std::sort(lesson.exercises.begin(), lesson.exercises.end(),
                  [](const Exercise& a, const Exercise& b) { return a.number < b.number; });
        all.push_back(std::move(lesson));
    }
    return all;
}

std::string task_text(const Exercise& exercise) {
    return "Exercise " + exercise.label() + ": " + exercise.title +
           (exercise.source.empty() ? "" : " (" + exercise.source + ")") + "\n\n" +
           wrapped(exercise.task + "\n\n" + what_to_hand_in(exercise)) + "\n";
}

std::vector<LessonFile> lesson_files(const Lesson& lesson) {
    std::vector<LessonFile> files;
    for (const Fence& fence : fences(lesson.text))
        if (!fence.name.empty()) files.push_back({fence.name, std::string(fence.text)});
    return files;
}

std::string lesson_text(const Lesson& lesson) {
    std::string text;
    const char* here = lesson.text.data();
    for (const Fence& fence : fences(lesson.text)) {
        text.append(here, fence.text.data());
        here = fence.text.data();
        const std::size_t hash = fence.region.find('#');
        for (const GalleryEntry& code : lesson_code())
            if (hash != std::string::npos && code.path == fence.region.substr(0, hash))
                text += region_of(code.text, fence.region.substr(hash + 1));
    }
    text.append(here, lesson.text.data() + lesson.text.size());
    if (!lesson.exercises.empty()) text += "\n## Exercises\n";
    for (const Exercise& exercise : lesson.exercises) text += "\n### " + task_text(exercise);
    if (!lesson.exercises.empty())
        text += "\n`algae lesson " + std::to_string(lesson.number) + " --exercise 1 my-answer." +
                lesson.exercises.front().ending() + "` marks an answer to the first one.\n";
    return text;
}

}  // namespace algae
