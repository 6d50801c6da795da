#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/place.hpp"

namespace algae {

/// Bad input or bad usage. The message names the place, what was expected and what was found.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The work was stopped before its answer. This says nothing about the input, so it is no `Error`:
/// who catches errors to go on, or to judge what was given, never catches a stop by that.
class Stopped : public std::exception {
public:
    explicit Stopped(const std::string& message) : message_(message) {}
    const char* what() const noexcept override { return message_.what(); }

private:
    std::runtime_error message_;  // copies of it throw nothing, as copies of an exception must
};

/// Somebody asked the work to stop (Ctrl-C).
struct Interrupted : Stopped {
    Interrupted() : Stopped("interrupted") {}
};

/// What was used up. A budget gives `letters`, `memory` and `time`, and more of it takes the work
/// further; `nodes` are those of a picture that a caller allows. The other two no caller moves: `digits`
/// are those of the numbers that are worked with, and `method` is how far a method goes at all.
enum class Bound { letters, memory, time, nodes, digits, method };

/// Whether a larger budget takes the work further.
///
/// Example: is_of_budget(Bound::time) && !is_of_budget(Bound::method)
inline bool is_of_budget(Bound bound) {
    return bound == Bound::letters || bound == Bound::memory || bound == Bound::time;
}

/// A bound was reached before the answer. The message says which and what to use instead; `came`
/// says how far the work came, where that is known, and ends the message.
class BoundReached : public Stopped {
public:
    BoundReached(Bound bound, const std::string& message, const std::string& came = {})
        : Stopped(came.empty() ? message : message + "; undecided: " + came),
          bound_(bound),
          came_(came) {}
    Bound bound() const { return bound_; }
    const char* came() const { return came_.what(); }

private:
    Bound bound_;
    std::runtime_error came_;
};

/// One finding about a text: where, what, and the line it stands in.
struct Diagnostic {
    Place place;
    std::string message;
    std::string line;  // the line itself, shortened around the place if it is very long
    std::size_t caret = 0;  // 0-based column of the caret within `line`

    /// The finding as a compiler would print it, without a line break at the end:
    ///
    ///     koch.lsys:3:11: error: unmatched ']'
    ///       F -> F+F]--F+F
    ///               ^
    std::string text() const;
};

/// Everything that is wrong with one text, in order of place. Never empty.
class Diagnostics : public Error {
public:
    explicit Diagnostics(std::vector<Diagnostic> findings);
    const std::vector<Diagnostic>& findings() const { return findings_; }

private:
    std::vector<Diagnostic> findings_;
};

}  // namespace algae
