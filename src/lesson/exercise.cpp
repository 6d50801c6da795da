#include "lesson/exercise.hpp"

#include <charconv>
#include <sstream>

#include "base/error.hpp"
#include "notation/characters.hpp"
#include "notation/claim_families.hpp"
#include "notation/claim_rewriting.hpp"
#include "notation/claim_scanner.hpp"

namespace algae {

namespace {

[[noreturn]] void refuse(const Place& place, const std::string& message) {
    throw Error(to_string(place) + ": " + message);
}

/// "03-2" of "lessons/exercises/03-2.exercise".
std::string name_of(const std::string& file) {
    const std::size_t slash = file.rfind('/');
    const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
    return file.substr(begin, file.rfind('.') - begin);
}

/// The numbers of the lesson and the exercise in the name of a file, if they are there.
void read_label(const std::string& name, Exercise& exercise) {
    const auto number = [](std::string_view digits) {
        std::size_t value = 0;
        const char* const end = digits.data() + digits.size();
        const auto [stop, error] = std::from_chars(digits.data(), end, value);
        return error == std::errc() && stop == end ? value : 0;
    };
    const std::size_t dash = name.find('-');
    if (dash == std::string::npos) return;
    const std::size_t lesson = number(std::string_view(name).substr(0, dash));
    const std::size_t place = number(std::string_view(name).substr(dash + 1));
    if (lesson == 0 || place == 0) return;
    exercise.lesson = lesson;
    exercise.number = place;
}

void read_kind(std::string_view value, const Place& place, Exercise& exercise) {
    ClaimScanner scanner(value);
    const std::string kind(scanner.take_piece());
    if (kind == "system") {
        exercise.kind = Exercise::Kind::system;
    } else if (kind == "language") {
        exercise.kind = Exercise::Kind::language;
    } else if (kind == "word") {
        exercise.kind = Exercise::Kind::word;
    } else if (kind == "claim") {
        exercise.kind = Exercise::Kind::claim;
        while (!scanner.at_end()) exercise.names.emplace_back(scanner.take_piece());
    } else {
        refuse(place, "expected system, language, word or claim and names, found '" + kind + "'");
    }
}

void add_task(std::string_view value, std::string& task) {
    if (value.empty()) {
        task += "\n\n";
        return;
    }
    if (!task.empty() && task.back() != '\n') task += ' ';
    task += value;
}

}  // namespace

std::string Exercise::label() const {
    if (lesson == 0) return name_of(file);
    return std::to_string(lesson) + "." + std::to_string(number);
}

bool is_own_statement(std::string_view text, Exercise::Kind kind) {
    ClaimScanner scanner(text);
    if (scanner.name() == "figure") return true;
    if (kind != Exercise::Kind::system || !scanner.take_word("answer")) return false;
    return scanner.name() == "is" || scanner.name() == "has";
}

Exercise read_exercise(std::string_view text, const std::string& name) {
    Exercise exercise;
    exercise.file = name + ".exercise";
    read_label(name_of(exercise.file), exercise);
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        begin = end + 1;
        const Place place{exercise.file, number + 1, 1};
        ClaimScanner scanner(line);
        const std::string_view keyword = scanner.name();
        const std::string_view value =
            keyword.empty() ? line : trimmed(scanner.rest().substr(keyword.size()));
        bool kept = false;
        if (keyword == "exercise") {
            exercise.title = value;
        } else if (keyword == "source") {
            exercise.source = value;
        } else if (keyword == "task") {
            add_task(value, exercise.task);
        } else if (keyword == "answer") {
            read_kind(value, place, exercise);
        } else if (keyword == "hint") {
            if (exercise.demands.empty()) refuse(place, "expected a 'show' above the hint");
            std::string& hint = exercise.demands.back().hint;
            hint += (hint.empty() ? "" : " ") + std::string(value);
        } else if (keyword == "show") {
            exercise.demands.push_back({std::string(value), "", place});
            kept = !is_own_statement(value, exercise.kind);
        } else {
            kept = true;
        }
        if (kept) exercise.claim += line;
        exercise.claim += '\n';
    }
    if (exercise.title.empty()) refuse({exercise.file, 1, 1}, "expected a line 'exercise TITLE'");
    if (exercise.task.empty()) refuse({exercise.file, 1, 1}, "expected a line 'task TEXT'");
    if (exercise.demands.empty()) refuse({exercise.file, 1, 1}, "expected a line 'show STATEMENT'");
    return exercise;
}

}  // namespace algae
