#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "base/place.hpp"

namespace algae {

/// Bad input or bad usage. The message names the place, what was expected and what was found.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A bound (letters, memory, time) was reached before the answer. The message names the bound,
/// how far the work came and what to use instead.
struct BoundReached : Error {
    using Error::Error;
};

/// Somebody asked the work to stop (Ctrl-C).
struct Interrupted : Error {
    Interrupted() : Error("interrupted") {}
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
