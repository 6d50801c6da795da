#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "base/error.hpp"

namespace algae {

/// What those who set the bounds of a budget call them, as a command its options; for messages.
struct BoundNames {
    const char *letters, *memory, *time;
};

/// What a piece of work may use, and whether somebody wants it to stop. A budget is an argument,
/// never a global; long loops call `check` every few thousand steps.
class Budget {
public:
    static constexpr std::uint64_t default_letters = 1'000'000'000;
    static constexpr std::uint64_t default_memory = std::uint64_t{4} << 30;  // bytes

    std::uint64_t letters = default_letters;  // letters of a word that may be written out
    std::uint64_t memory = default_memory;    // bytes that tables and sets may take
    std::optional<std::chrono::steady_clock::time_point> deadline;
    const std::atomic<bool>* stop = nullptr;  // set by a signal handler
    /// Called by every `check`, by several threads at once; throws a `Stopped` to stop the work. For signals that
    /// another language keeps, and for tests that stop the work wherever it can be stopped.
    const std::function<void()>* at_check = nullptr;
    const BoundNames* names = nullptr;

    /// Throws `Interrupted` if the work was asked to stop, `BoundReached` past the deadline.
    void check() const;

    /// Throws `BoundReached` if `bytes` is more than `memory`; `what` names the table or set.
    void check_memory(std::uint64_t bytes, const char* what) const;

    /// " by NAME" where whoever set the bound calls it so, to follow "allowed" or "set" in a message; nothing
    /// where it has no name.
    std::string by(Bound bound) const;
};

/// How far some work has come, from 0 to 1. Called now and then; may do nothing.
class Progress {
public:
    virtual ~Progress() = default;
    virtual void report(double done) = 0;
};

}  // namespace algae
