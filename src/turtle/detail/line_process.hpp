#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include <sys/types.h>

#include "exact/exact.hpp"

namespace algae {

/// A program that runs beside this one, reads lines and answers each with a line. Its standard error
/// is that of this program. It is a process group of its own, so that Ctrl-C ends it by way of this
/// program, and it ends with this object: it gets two seconds to go after its input ends, none if an
/// answer went wrong. Never a signal for this program if it ends early, never a zombie.
class LineProcess {
public:
    /// Runs `command` by /bin/sh -c. Throws Error if no process can be made.
    explicit LineProcess(std::string command);
    ~LineProcess();
    LineProcess(const LineProcess&) = delete;
    LineProcess& operator=(const LineProcess&) = delete;

    /// How long an answer may take where the budget has no deadline.
    static constexpr std::chrono::seconds patience{60};

    /// Sends a line and gives the next line of the program, both without their line breaks. `what`
    /// is how messages call the answer. Throws Error if the program ends before, its answer has more
    /// than `longest` bytes or it takes longer than `wait`, BoundReached at the budget's deadline,
    /// which replaces that of `wait`.
    std::string answer(std::string_view line, const std::string& what, std::size_t longest,
                       const Budget& budget, std::chrono::milliseconds wait = patience);

private:
    [[noreturn]] void fail(const std::string& what_happened);
    [[noreturn]] void fail_at_end(const std::string& what);
    void check_time(const std::string& what, std::chrono::steady_clock::time_point begin,
                    std::chrono::milliseconds wait, const Budget& budget);
    void send(std::string_view& rest);
    void receive(const std::string& what);
    void check_silence(const std::string& what);
    bool ended_within(std::chrono::milliseconds time);
    void close_all();

    std::string command_;
    int input_ = -1, output_ = -1;  // our ends of the program's input and output
    pid_t process_ = -1;            // -1 once it has been waited for
    pid_t group_ = -1;              // of processes, by the number of the first
    int status_ = 0;                // as waitpid gives it, once it has been waited for
    std::string received_;          // what came in and is not given out yet
    bool asked_ = false, failed_ = false;
};

}  // namespace algae
