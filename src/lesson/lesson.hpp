#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

// lesson: the lessons that come with algae, and exercises whose answers the theory marks. An exercise is a task and a list of
// demands on an answer (a system, a language, a word, or a claim that defines names); an answer is right if every demand is
// proved, wrong as soon as one is refuted, and otherwise undecided.

namespace algae {

/// Something that must hold of the answer, and what to tell those whose answer it does not hold of.
struct Demand {
    std::string text;  // a statement as claims write it, or one of an exercise's own
    std::string hint;
    Place place;  // of the text
    std::optional<OwnStatement> own;
};

/// A file `*.exercise` (NOTATION.md): a task and what must hold of an answer, in the order in which it is looked at.
///
///     exercise  Squares
///     task      Write a PD0L system whose words have the lengths 1, 2, 5, 10, 17, ...
///     answer    system
///     show      answer is PD0L
///     show      growth(answer) = n^2 + 1
///     hint      A letter that makes one a step grows by one; what makes such letters grows ...
///
/// `exercise`, `task`, `source`, `answer` and `hint` take the rest of their line; several `task` lines
/// are one text, an empty one begins a paragraph; a `hint` belongs to the `show` above it. All other lines are the `let`,
/// `alphabet` and `allow` of a claim (NOTATION.md) that speaks of `answer`, or of the names that the answer defines.
///
/// Statements of exercises' own, all about systems: `answer is D0L` and other forms of systems, S0L and
/// parametric too; `answer has 2 rules`, `answer has at most 2 rules`, letters or symbols in the
/// axiom likewise (`answer has 1 axiom symbol`); `figure(answer, 4) is similar to figure(koch, 4)`, `is
/// congruent to`, or `==` where they must lie in the same place; the second is from the gallery.
struct Exercise {
    enum class Kind {
        system,    // a `.lsys` file, called `answer`
        language,  // an expression as claims write it, called `answer`
        word,      // one word; `answer` is the language that has no other
        claim,     // a `.claim` file that defines `names`
    };
    std::size_t lesson = 0, number = 0;  // 0 of an exercise that belongs to no lesson
    std::string file;                    // for messages
    std::string title, source, task;
    Kind kind = Kind::system;
    std::vector<std::string> names;
    std::vector<Demand> demands;
    std::string text;   // of the file
    std::string claim;  // the text of the file with all but clauses of claims blanked out

    /// "3.2", as people call it; of one that belongs to no lesson the file's name without folder and ending.
    std::string label() const;
    /// How the name of a file with an answer ends: `lsys`, `claim`, or `txt`.
    std::string ending() const;
};

/// The exercise that a text says; `name` is that of its file without the ending. One named as `03-2` is
/// the second of lesson 3, others belong to no lesson. Statements of claims are not read yet. Throws
/// Diagnostics with all that is wrong with its lines.
///
/// Example: read_exercise("exercise One\ntask Write a.\nanswer word\nshow answer == {a}", "01-2").label() == "1.2"
/// Example: read_exercise("exercise One\ntask Write a.\nanswer word\nshow answer == {a}", "mine/a").label() == "a"
Exercise read_exercise(std::string_view text, const std::string& name);

/// Looks through the statements of an exercise before there is an answer: names that are defined nowhere, families that
/// there are not, systems that `open` does not know. What is wrong counts if it is wrong with each of
/// several answers of its kind. Where `files_may_follow`, systems in files that cannot be opened are
/// passed over: they may stand beside the answer. Throws Diagnostics, and what `open` throws but Error.
void check_exercise(const Exercise& exercise, const SystemSource& open,
                    bool files_may_follow = false);

/// What came of one demand.
struct MarkedDemand {
    std::string text, hint;
    Judgement judgement;
};

/// What came of an answer: right if all demands are proved, wrong if one is refuted.
struct Mark {
    Truth verdict = Truth::proved;  // right, wrong, undecided
    std::vector<MarkedDemand> demands;
};

/// Which demands are looked at.
enum class Demands {
    to_first_refuted,  // who answers mends one thing after the other
    all,               // for partial credit; one that makes no sense of the answer is undecided
};

/// Marks an answer. `text` is what stands in the file `name`; `open` knows the gallery and the files
/// beside the answer. Throws Error or Diagnostics where the answer cannot be read, or demands cannot be
/// about it; what `decide` throws.
Mark mark(const Exercise& exercise, const std::string& text, const std::string& name,
          const SystemSource& open, const Budget& budget = {},
          Demands looked_at = Demands::to_first_refuted);

/// How many demands of an exercise are proved of an answer of which all were looked at; statements of the answer's own do not count.
///
/// Example: points(Exercise{}, Mark{}) == 0
std::size_t points(const Exercise& exercise, const Mark& mark);

/// The mark as a report: what was asked, what was found instead, and a hint.
std::string report(const Exercise& exercise, const Mark& mark);

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

/// A fenced block of a lesson's Markdown: ```KIND name=FILE or region=FILE#NAME.
struct Fence {
    std::string kind, name, region;
    std::string_view text;  // its lines, each with its line break
};

/// The fenced blocks of a text, in order. They refer to it. One that is not closed ends with the text. Linear.
///
/// Example: fences("Look:\n```lsys name=a.lsys\naxiom a\n```\n").at(0).text == "axiom a\n"
std::vector<Fence> fences(std::string_view markdown);

/// The lines between `//> NAME` and `//< NAME` in a file of code, moved to the left by what the first of
/// them is indented by; empty if it is not there. Linear.
///
/// Example: region_of("//> one\n    int a;\n//< one\n", "one") == "int a;\n"
std::string region_of(std::string_view code, std::string_view name);

}  // namespace algae
