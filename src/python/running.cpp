// Signals, progress and errors between Python and the library.
//
// The library asks a budget every few thousand steps whether it is to stop. Here the answer is an atomic flag. A handler of SIGINT that is
// installed only while the main thread of Python works sets it and calls Python's own handler, which
// notes the signal; when the work has stopped, Python is asked what the signal means: KeyboardInterrupt, unless a
// program says otherwise. Other threads of Python get no signals, so their work is stopped by their bounds or by their own callback.
//
// Errors become exceptions of `algae.errors`: the class says what kind it is, and the findings of Diagnostics keep their places. A bound
// of time is a TimeoutError too.

#include "python/detail/running.hpp"

#include <chrono>

#include "python/detail/values.hpp"
#include "report/report.hpp"

namespace algae::python {

namespace {

/// Set by SIGINT while the main thread works. A handler may touch nothing else.
std::atomic<bool> interrupted{false};
void (*handler_before)(int) = nullptr;

void note_interrupt(int signal) {
    interrupted = true;
    if (handler_before) handler_before(signal);
}

constexpr BoundNames bound_names{"letters=", "memory=", "timeout="};
constexpr std::int64_t told_every = 200'000'000;  // nanoseconds

std::int64_t now() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

bool is_main_thread() {
    const py::object main = py::module_::import("threading").attr("main_thread")().attr("ident");
    return !main.is_none() && main.cast<unsigned long>() == PyThread_get_thread_ident();
}

/// The time so many seconds from now; none where it would not fit the clock.
std::optional<std::chrono::steady_clock::time_point> deadline_in(std::optional<double> seconds) {
    constexpr double longest = 1e9;
    if (!seconds || *seconds >= longest) return std::nullopt;
    return std::chrono::steady_clock::now() +
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(
               std::chrono::duration<double>(*seconds));
}

const char* name_of(Bound bound) {
    static const char* const names[] = {"letters", "memory", "time", "nodes", "digits", "method"};
    return names[static_cast<std::size_t>(bound)];
}

/// A message as Python has it. One that was cut within a character, or that quotes bytes of something else, has U+FFFD there.
py::str message_text(const std::string& message) {
    PyObject* text =
        PyUnicode_DecodeUTF8(message.data(), static_cast<Py_ssize_t>(message.size()), "replace");
    if (!text) throw py::error_already_set();
    return py::reinterpret_steal<py::str>(text);
}

/// Raises an exception of `algae.errors` that is made of these arguments.
template <class... Arguments>
void raise_own(const char* name, Arguments&&... arguments) {
    const py::object type = py::module_::import("algae.errors").attr(name);
    const py::object error = type(std::forward<Arguments>(arguments)...);
    PyErr_SetObject(type.ptr(), error.ptr());
}

py::list findings_of(const Diagnostics& error) {
    py::list all;
    for (const Diagnostic& finding : error.findings()) {
        const MessageParts parts = parts_of(finding.message);
        py::dict one;
        one["file"] = message_text(finding.place.file);
        one["line"] = finding.place.line;
        one["column"] = finding.place.column;
        one["end"] = end_column(finding);
        one["message"] = message_text(finding.message);
        one["text"] = message_text(finding.line);
        one["caret"] = finding.caret;
        one["expected"] = message_text(parts.expected);
        one["found"] = message_text(parts.found);
        one["suggestion"] = message_text(parts.suggestion);
        all.append(one);
    }
    return all;
}

void translate(std::exception_ptr raised) {
    try {
        if (raised) std::rethrow_exception(raised);
    } catch (const Diagnostics& error) {
        raise_own("NotationError", message_text(error.what()), findings_of(error));
    } catch (const Error& error) {
        raise_own("Error", message_text(error.what()));
    } catch (const BoundReached& bound) {
        raise_own(bound.bound() == Bound::time ? "Timeout" : "BoundReached",
                  message_text(bound.what()), name_of(bound.bound()));
    } catch (const Interrupted&) {
        PyErr_SetNone(PyExc_KeyboardInterrupt);
    } catch (const Stopped& stop) {
        raise_own("Stopped", message_text(stop.what()));
    }
}

}  // namespace

Running::Running(const Limits& limits) : callback_(limits.progress) {
    budget_.names = &bound_names;
    if (limits.letters) budget_.letters = *limits.letters;
    if (limits.memory) budget_.memory = *limits.memory;
    budget_.deadline = limits.deadline;
    wants_progress_ = !callback_.is_none();
    told_ = now();
    if (wants_progress_) {
        at_check_ = [this] { tell(std::nullopt); };
        budget_.at_check = &at_check_;
    }
    budget_.stop = &own_stop_;
    if (!is_main_thread()) return;
    struct sigaction current {};
    if (sigaction(SIGINT, nullptr, &current) != 0 || (current.sa_flags & SA_SIGINFO) != 0 ||
        current.sa_handler == SIG_DFL || current.sa_handler == SIG_IGN)
        return;
    was_stopped_ = interrupted.exchange(false);
    if (current.sa_handler != note_interrupt) handler_before = current.sa_handler;
    struct sigaction own = current;
    own.sa_handler = note_interrupt;
    if (sigaction(SIGINT, &own, &before_) != 0) return;
    has_signals_ = true;
    budget_.stop = &interrupted;
}

Running::~Running() {
    if (!has_signals_) return;
    sigaction(SIGINT, &before_, nullptr);
    interrupted = was_stopped_;
}

void Running::raise() {
    if (error_) throw std::move(*error_);
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
}

void Running::tell(std::optional<double> done) {
    std::int64_t before = told_;
    const std::int64_t time = now();
    if (time - before < told_every || !told_.compare_exchange_strong(before, time)) return;
    const py::gil_scoped_acquire lock;
    if (error_) return;
    try {
        if (done)
            callback_(*done);
        else
            callback_(py::none());
    } catch (py::error_already_set& error) {
        error_.emplace(error);
        if (has_signals_)
            interrupted = true;
        else
            own_stop_ = true;
    }
}

void add_running(py::module_& module) {
    py::register_exception_translator(translate);
    py::class_<Limits>(module, "Limits")
        .def(py::init([](std::optional<double> timeout, std::optional<std::uint64_t> letters,
                         std::optional<std::uint64_t> memory, py::object progress) {
                 return Limits{deadline_in(timeout), letters, memory, std::move(progress)};
             }),
             py::arg("timeout") = py::none(), py::arg("letters") = py::none(),
             py::arg("memory") = py::none(), py::arg("progress") = py::none());
    module.def(
        "work_for",
        [](const Limits& limits) {
            run(limits, [](const Budget& budget) {
                while (true) budget.check();
            });
        },
        py::arg("limits"), "Works until it is stopped: for tests of Ctrl-C and of bounds.");
}

}  // namespace algae::python
