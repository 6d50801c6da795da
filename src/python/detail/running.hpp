#pragma once
// Work of the library for Python: without the interpreter's lock, stopped by Ctrl-C, bounded in time, letters and memory.

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "exact/exact.hpp"

namespace algae::python {

namespace py = pybind11;

/// What a call from Python may use: until when, letters and bytes, and whom to tell how far the work is. Several pieces of work with the
/// same limits must all be done by then.
struct Limits {
    std::optional<std::chrono::steady_clock::time_point> deadline;
    std::optional<std::uint64_t> letters, memory;
    py::object progress =
        py::none();  // called with a number from 0 to 1, or None where it is not known
};

/// The state of one piece of work. It is made and destroyed with the interpreter's lock held; in between the lock is free.
///
/// Only the main thread of Python gets signals. If it runs the work, Ctrl-C sets a flag, which the budget reads, before Python's own
/// handler is called: so work stops within some thousand steps, in all of its threads, and nobody waits for the lock.
/// Python's handler then says what happens, as for any other code.
class Running : private Progress {
public:
    explicit Running(const Limits& limits);
    ~Running() override;
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    const Budget& budget() const { return budget_; }
    /// Null where nobody wants to be told.
    Progress* progress() { return wants_progress_ ? this : nullptr; }

    /// Raises what stopped the work: what a signal handler or a callback raised, otherwise KeyboardInterrupt.
    [[noreturn]] void raise();

private:
    void report(double done) override { tell(done); }
    /// Calls `progress`, at most a few times a second. An error of it stops the work.
    void tell(std::optional<double> done);

    Budget budget_;
    std::function<void()> at_check_;
    py::object callback_;
    bool wants_progress_ = false, has_signals_ = false, was_stopped_ = false;
    std::atomic<bool> own_stop_{false};
    std::atomic<std::int64_t> told_{0};  // when, in nanoseconds
    std::optional<py::error_already_set> error_;
    struct sigaction before_ {};
};

/// Does the work, `work(budget, progress)`, without the interpreter's lock; it must not touch objects of Python.
template <class Work>
auto run(const Limits& limits, Work work) -> std::invoke_result_t<Work, const Budget&, Progress*> {
    Running here(limits);
    try {
        const py::gil_scoped_release free;
        return work(here.budget(), here.progress());
    } catch (const Interrupted&) {
        here.raise();
    }
}

/// For functions that neither touch objects of Python nor have a budget, such as readers of texts: they leave the lock free.
using Unlocked = py::call_guard<py::gil_scoped_release>;

/// Asked in loops that make objects of Python, which cannot leave the lock: now and then signals are let in, and what their handlers raise,
/// KeyboardInterrupt for one, is thrown.
inline void let_signals_in(std::size_t round) {
    if (round % 4096 == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// The same for work that only asks for a budget.
template <class Work>
auto run(const Limits& limits, Work work) -> std::invoke_result_t<Work, const Budget&> {
    return run(limits, [&](const Budget& budget, Progress*) { return work(budget); });
}

}  // namespace algae::python
