#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/exact.hpp"

// studio: a server that shows one page in a browser and answers what the page asks, and the views of a system that only such a
// page has: a figure as numbers for a canvas, a derivation with every letter's ancestor, a walk step by step.
//
// What a page asks is text from the network. The server never reads it: each question goes to a process of its own, which may
// write no file, holds so much memory and lives so many seconds, and ends when the page hangs up. What that process does is the
// caller's: `algae studio` runs verbs in it.

namespace algae {

struct Model;

/// What one question may take, and how many are answered at a time; the others wait.
struct StudioShare {
    double seconds = 30;
    std::uint64_t memory = std::uint64_t{1} << 30;    // bytes
    std::uint64_t question = std::uint64_t{1} << 20;  // bytes that a page may send
    std::uint64_t answer = std::uint64_t{1} << 26;    // bytes that it gets
    unsigned at_once = 4;
};

/// A studio: where it is served, and how it answers.
struct Studio {
    std::string host = "127.0.0.1";
    std::uint16_t port = 0;  // 0: one that is free
    /// Addresses begin with it, and nobody else gets an answer: at least 16 letters or digits.
    std::string token;
    std::string_view page;  // HTML
    StudioShare share;
    /// Answers one question, in a process of its own whose standard output is the answer and whose standard error goes to the
    /// page line by line; returns the exit status. The function gets the bytes that the page sent, whatever they are.
    std::function<int(const std::string& question)> answer;
    /// Called when the server listens, with the address of the page.
    std::function<void(const std::string& address)> listening;
    /// Looked at twenty times a second: whether to end.
    std::function<bool()> is_stopped;
};

/// Serves until it is stopped; then unfinished questions end at once. Call it before the process has threads.
///
/// A request without the token, from a page of another origin, or to another host than the one served gets status 403, an unknown
/// address 404, a question that is too long 413, one that is not said to be JSON 415. Throws Error if the address cannot be listened on.
void serve(const Studio& studio);

/// How a question ended.
struct Answered {
    enum class End {
        answered,
        gone,    // nobody waited for it any more
        time,    // its process ran out of its time
        size,    // the answer was longer than may be
        broken,  // its process ended before it had answered
    };
    End end = End::broken;
    int status = 0;            // what the function returned, if it did
    std::string answer, said;  // what it wrote
};

/// Answers questions without a page, each in a process of its own as `serve` does, so that one that hangs or bursts costs its own share
/// only. The answers come in the order of the questions. `goes_on` is asked twenty times a second with the number of those that are
/// answered; when it says no, work ends at once, and what is not answered is `gone`. Throws Error if the system gives no process.
std::vector<Answered> answer_apart(const std::vector<std::string>& questions,
                                   const std::function<int(const std::string&)>& answer,
                                   const StudioShare& share,
                                   const std::function<bool(std::size_t done)>& goes_on);

/// 32 hexadecimal digits from the system's source of chance.
///
/// Example: random_token().size() == 32
std::string random_token();

/// The page that comes with algae.
///
/// Example: studio_page().substr(0, 15) == "<!DOCTYPE html>"
std::string_view studio_page();

/// What a page wants to see of a figure.
struct FigureQuestion {
    std::uint64_t generation = 0;
    std::optional<std::uint64_t> seed;
    /// In the plane: the part that is shown, in the units of the figure; without it all.
    struct Part {
        double x = 0, y = 0, width = 0, height = 0;
    };
    std::optional<Part> part;
    double pixels = 1000;  // the longer side of the picture: finer detail is left out
    std::uint64_t most_strokes =
        400'000;  // if there are more, detail gets coarser until there are not
};

/// A figure for a canvas: a line of JSON that says what follows, then numbers of 4 bytes, the lower byte first.
///
/// In the plane `runs` are strokes of one look: `first` and `count` of the strokes, each four floats x1, y1, x2, y2 seen from
/// `middle`; behind them, for each stroke, the place in the word of the symbol that draws it. `areas` are polygons with their corners.
/// In space there are `corners` corners with six floats each, place and normal, then `indices` numbers, three for a triangle;
/// `runs` are triangles of one colour.
///
/// Throws what `open_figure`, `scene` and `mesh_of` throw; BoundReached at the end of the budget.
std::string figure_view(const Model& system, const FigureQuestion& question, const Budget& budget);

/// The words of generations 0 to `n` as JSON: symbols, for each symbol the place of its ancestor in the word before, and the rule that made
/// it. Words stop before one that has more than `most` symbols; `full` says whether they did.
std::string derivation_view(const Model& system, std::uint64_t n, std::optional<std::uint64_t> seed,
                            std::uint64_t most, const Budget& budget);

/// What each symbol of a word does to the turtle, as JSON: its text and meaning, the turtle before and after, what is drawn. Throws
/// BoundReached if the word has more than `most` symbols.
std::string walk_view(const Model& system, std::uint64_t n, std::optional<std::uint64_t> seed,
                      std::uint64_t most, const Budget& budget);

}  // namespace algae
