#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace algae {

/// What is known of a statement. There is no conversion to bool: `undecided` is neither.
enum class Truth { proved, refuted, undecided };

/// The answer to a question that may be undecidable, and how it is known: the theorem or the
/// witness, the counterexample, or what was tried and which bound was reached. A bound that is
/// reached gives `undecided`, never one of the others.
struct Verdict {
    Truth truth = Truth::undecided;
    std::string explanation;

    static Verdict proved(std::string because) { return {Truth::proved, std::move(because)}; }
    static Verdict refuted(std::string because) { return {Truth::refuted, std::move(because)}; }
    static Verdict undecided(std::string tried) { return {Truth::undecided, std::move(tried)}; }

    bool operator==(const Verdict&) const = default;
};

/// "proved", "refuted" or "undecided".
///
/// Example: to_string(Truth::proved) == "proved"
std::string_view to_string(Truth truth);

/// The verdict on the opposite statement.
///
/// Example: opposite(Truth::proved) == Truth::refuted
Truth opposite(Truth truth);

}  // namespace algae
