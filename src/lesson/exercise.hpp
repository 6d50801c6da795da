#pragma once
// lesson: the lessons that come with algae, and exercises whose answers the theory marks.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/place.hpp"
#include "lesson/own_statement.hpp"

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
};

/// Whether a statement is one that exercises have and claims have not.
///
/// Example: is_own_statement("answer has 2 rules", Exercise::Kind::system)
/// Example: !is_own_statement("growth(answer) = 2^n", Exercise::Kind::system)
bool is_own_statement(std::string_view text, Exercise::Kind kind);

/// The exercise that a text says; `name` is that of its file without the ending. One named as `03-2` is
/// the second of lesson 3, others belong to no lesson. Statements of claims are not read yet. Throws
/// Diagnostics with all that is wrong with its lines.
///
/// Example: read_exercise("exercise One\ntask Write a.\nanswer word\nshow answer == {a}", "01-2").label() == "1.2"
/// Example: read_exercise("exercise One\ntask Write a.\nanswer word\nshow answer == {a}", "mine/a").label() == "a"
Exercise read_exercise(std::string_view text, const std::string& name);

}  // namespace algae
