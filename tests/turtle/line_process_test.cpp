#include "turtle/detail/line_process.hpp"

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <thread>

#include "exact/exact.hpp"

using namespace algae;
using namespace std::chrono_literals;

namespace {

/// What is said when the program is asked this, and how long that took.
struct Refusal {
    std::string message;
    std::chrono::steady_clock::duration time;
};

Refusal refusal(const std::string& command, const std::string& question = "?",
                std::chrono::milliseconds wait = 20s, std::size_t longest = 1000,
                const Budget& budget = {}) {
    const auto begin = std::chrono::steady_clock::now();
    std::string message = "an answer";
    try {
        LineProcess program(command);
        program.answer(question, "an answer", longest, budget, wait);
    } catch (const Error& error) {
        message = error.what();
    } catch (const Stopped& stopped) {
        message = stopped.what();
    }
    return {message, std::chrono::steady_clock::now() - begin};
}

bool has_children() { return waitpid(-1, nullptr, WNOHANG) != -1 || errno != ECHILD; }

}  // namespace

TEST_CASE("a program answers line by line") {
    LineProcess program("while read -r line; do echo \"<$line>\"; done");
    for (const char* line : {"a", "", "b c"})
        CHECK(program.answer(line, "an answer", 1000, {}) == '<' + std::string(line) + '>');
    // Longer than any pipe, both ways at once.
    const std::string long_line(3'000'000, 'x');
    CHECK(LineProcess("cat").answer(long_line, "an answer", 4'000'000, {}) == long_line);
    // One that does not read may answer all the same.
    CHECK(LineProcess("exec <&-; echo 7").answer(long_line, "an answer", 1000, {}) == "7");
}

TEST_CASE("programs that end, by themselves or not") {
    CHECK(refusal("exit 3").message ==
          "the environment program 'exit 3' ended with status 3 before it gave an answer");
    CHECK(refusal("kill -9 $$").message ==
          "the environment program 'kill -9 $$' was ended by signal 9 before it gave an answer");
    CHECK(refusal("exec 2>/dev/null; no-such-program").message ==
          "the environment program 'exec 2>/dev/null; no-such-program' ended with status 127 "
          "before it gave an answer");
    CHECK(refusal("printf half; exit 0", std::string(1'000'000, 'x')).message ==
          "the environment program 'printf half; exit 0' ended with status 0 before it gave an "
          "answer");
    const Refusal closed = refusal("exec >&-; exec sleep 30");
    CHECK(closed.message ==
          "the environment program 'exec >&-; exec sleep 30' closed its input or output before it "
          "gave an answer");
    CHECK(closed.time < 10s);
    CHECK(!has_children());
}

TEST_CASE("programs that never answer") {
    const Refusal silent = refusal("sleep 30 & sleep 30", "?", 1000ms);
    CHECK(silent.message ==
          "the environment program 'sleep 30 & sleep 30' has not given an answer within 1 seconds. "
          "Does it write out "
          "each line at once? A deadline lets it take longer");
    CHECK(silent.time < 10s);
    // Neither reads nor writes, and the question is longer than the pipe.
    CHECK(refusal("sleep 30", std::string(1'000'000, 'x'), 100ms).time < 10s);

    Budget bounded;
    bounded.deadline = std::chrono::steady_clock::now() + 200ms;
    const Refusal late = refusal("sleep 30", "?", 20s, 1000, bounded);
    CHECK(late.message ==
          "the time allowed is over, and the environment program 'sleep 30' has not "
          "given an answer");
    CHECK(late.time < 10s);

    std::atomic<bool> stop = false;
    Budget interrupted;
    interrupted.stop = &stop;
    std::thread later([&] {
        std::this_thread::sleep_for(200ms);
        stop = true;
    });
    CHECK(refusal("sleep 30", "?", 20s, 1000, interrupted).message == "interrupted");
    later.join();
    CHECK(!has_children());
}

TEST_CASE("programs that write too much") {
    CHECK(refusal("cat /dev/zero").message ==
          "the environment program 'cat /dev/zero' has written more than 1000 bytes without a line "
          "break instead of an "
          "answer");
    CHECK(refusal("yes", std::string(1'000'000, 'x'), 500ms).message.find("has not given") !=
          std::string::npos);
    LineProcess twice("read -r line; echo 1; echo 2; cat");
    CHECK(twice.answer("?", "an answer", 1000, {}) == "1");
    std::this_thread::sleep_for(300ms);
    std::string message;
    try {
        twice.answer("?", "the second answer", 1000, {});
    } catch (const Error& error) {
        message = error.what();
    }
    CHECK(message.find("has written more than one line before it was asked for") !=
          std::string::npos);
}

TEST_CASE("a program may finish what it does when its input ends") {
    const auto begin = std::chrono::steady_clock::now();
    { LineProcess program("cat >/dev/null; sleep 0.3; exit 0"); }
    const auto time = std::chrono::steady_clock::now() - begin;
    CHECK(time >= 300ms);
    CHECK(!has_children());
    { LineProcess stubborn("trap '' TERM HUP INT; while :; do sleep 1; done"); }
    CHECK(!has_children());
    // Signals are as they were.
    sigset_t blocked;
    pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
    CHECK(sigismember(&blocked, SIGPIPE) == 0);
}
