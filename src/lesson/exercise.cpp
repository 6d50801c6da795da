#include "lesson/exercise.hpp"

#include <charconv>

#include "lesson/exercise_lines.hpp"
#include "notation/claim_scanner.hpp"
#include "notation/findings.hpp"

namespace algae {

namespace {

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
    exercise.text = text;
    read_label(name_of(exercise.file), exercise);
    const Source source(text, exercise.file);
    Findings findings(source);
    findings.throw_if_no_text();
    read_exercise_lines(text, exercise, source, findings);
    findings.throw_if_any();
    return exercise;
}

}  // namespace algae
