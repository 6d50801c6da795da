#include "turtle/detail/line_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include <sys/wait.h>
#include <nlohmann/json.hpp>

#include "turtle/detail/environments.hpp"

// An environment that is another program: lines of JSON to it and from it.
//
// The program is untrusted as far as it goes: it may end, hang, answer too much, too early or nonsense, and
// each of these is an Error that names the command and the answer that was wanted, never a signal, a zombie
// or a wait without end. So both ends are non-blocking and polled together (the program may answer before it
// has read all), SIGPIPE is blocked while writing, and the process has a group of its own that is ended with
// the object. The shell that runs the command may have children: the group is killed, not the process.

extern char** environ;

namespace algae {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// Two ends of a pipe, closed with this object and in programs that are started.
struct Pipe {
    int ends[2] = {-1, -1};

    Pipe() {
        if (pipe(ends) != 0)
            throw Error(std::string("no pipe to an environment program: ") + std::strerror(errno));
        for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
    }
    ~Pipe() {
        for (const int end : ends)
            if (end >= 0) close(end);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    int take(int which) { return std::exchange(ends[which], -1); }
};

/// What a process begins with: its files, a group of its own, signals as a shell expects them.
struct Beginning {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;

    Beginning(const Pipe& input, const Pipe& output) {
        posix_spawn_file_actions_init(&files);
        posix_spawn_file_actions_adddup2(&files, input.ends[0], STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&files, output.ends[1], STDOUT_FILENO);
        posix_spawnattr_init(&attributes);
        posix_spawnattr_setflags(
            &attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
        posix_spawnattr_setpgroup(&attributes, 0);
        sigset_t none, usual;
        sigemptyset(&none);
        sigemptyset(&usual);
        sigaddset(&usual, SIGPIPE);
        posix_spawnattr_setsigmask(&attributes, &none);
        posix_spawnattr_setsigdefault(&attributes, &usual);
    }
    ~Beginning() {
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&attributes);
    }
    Beginning(const Beginning&) = delete;
    Beginning& operator=(const Beginning&) = delete;
};

/// While it lives, writing to a pipe that nobody reads is an error and no signal.
class WithoutPipeSignal {
public:
    WithoutPipeSignal() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        sigset_t pending;
        sigpending(&pending);
        was_pending_ = sigismember(&pending, SIGPIPE) == 1;
        pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
    }
    ~WithoutPipeSignal() {
        sigset_t pending;
        sigpending(&pending);
        int signal = 0;
        if (!was_pending_ && sigismember(&pending, SIGPIPE) == 1) sigwait(&pipe_, &signal);
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    WithoutPipeSignal(const WithoutPipeSignal&) = delete;
    WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

private:
    sigset_t pipe_, before_;
    bool was_pending_;
};

bool would_wait() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

LineProcess::LineProcess(std::string command) : command_(std::move(command)) {
    Pipe input, output;
    const Beginning beginning(input, output);
    std::string shell = "sh", option = "-c";
    char* const arguments[] = {shell.data(), option.data(), command_.data(), nullptr};
    const int error = posix_spawn(&process_, "/bin/sh", &beginning.files, &beginning.attributes,
                                  arguments, environ);
    if (error != 0) {
        process_ = -1;
        throw Error("the environment program '" + command_ +
                    "' cannot be started: " + std::strerror(error));
    }
    group_ = process_;
    input_ = input.take(1);
    output_ = output.take(0);
    for (const int end : {input_, output_}) fcntl(end, F_SETFL, fcntl(end, F_GETFL) | O_NONBLOCK);
}

LineProcess::~LineProcess() {
    close_all();
    if (!failed_ && ended_within(2s)) return;
    if (group_ > 0) kill(-group_, SIGKILL);
    while (process_ >= 0 && waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
    }
}

void LineProcess::close_all() {
    for (int* end : {&input_, &output_})
        if (*end >= 0) close(std::exchange(*end, -1));
}

bool LineProcess::ended_within(std::chrono::milliseconds time) {
    const auto end = Clock::now() + time;
    for (auto pause = 1ms; process_ >= 0; pause = std::min(2 * pause, 50ms)) {
        if (waitpid(process_, &status_, WNOHANG) == process_) process_ = -1;
        if (process_ < 0 || Clock::now() >= end) break;
        std::this_thread::sleep_for(pause);
    }
    return process_ < 0;
}

void LineProcess::fail(const std::string& what_happened) {
    failed_ = true;
    throw Error("the environment program '" + command_ + "' " + what_happened);
}

void LineProcess::fail_at_end(const std::string& what) {
    std::string how = "closed its input or output";
    if (ended_within(1s)) {
        if (WIFSIGNALED(status_))
            how = "was ended by signal " + std::to_string(WTERMSIG(status_));
        else
            how = "ended with status " + std::to_string(WEXITSTATUS(status_));
    }
    fail(how + " before it gave " + what);
}

void LineProcess::check_time(const std::string& what, Clock::time_point begin,
                             std::chrono::milliseconds wait, const Budget& budget) {
    try {
        budget.check();
    } catch (const BoundReached& bound) {
        failed_ = true;
        throw BoundReached(bound.bound(), std::string(bound.what()) +
                                              ", and the environment program '" + command_ +
                                              "' has not given " + what);
    } catch (const Stopped&) {
        failed_ = true;
        throw;
    }
    if (budget.deadline || Clock::now() - begin <= wait) return;
    const std::string by = budget.by(Bound::time);
    fail("has not given " + what + " within " +
         std::to_string(std::chrono::duration_cast<std::chrono::seconds>(wait).count()) +
         " seconds. Does it write out each line at once? A deadline" +
         (by.empty() ? "" : " set" + by) + " lets it take longer");
}

void LineProcess::send(std::string_view& rest) {
    const WithoutPipeSignal guard;
    const ssize_t sent = write(input_, rest.data(), rest.size());
    if (sent >= 0)
        rest.remove_prefix(static_cast<std::size_t>(sent));
    else if (!would_wait())
        rest = {};  // it reads no more, but may have answered
}

void LineProcess::receive(const std::string& what) {
    char piece[1 << 14];
    const ssize_t got = read(output_, piece, sizeof piece);
    if (got == 0 || (got < 0 && !would_wait())) fail_at_end(what);
    if (got > 0) received_.append(piece, static_cast<std::size_t>(got));
}

void LineProcess::check_silence(const std::string& what) {
    pollfd end = {output_, POLLIN, 0};
    if (received_.empty() && poll(&end, 1, 0) > 0) receive(what);
    if (!received_.empty()) fail("has written more than one line before it was asked for " + what);
}

std::string LineProcess::answer(std::string_view line, const std::string& what, std::size_t longest,
                                const Budget& budget, std::chrono::milliseconds wait) {
    const std::string text = std::string(line) + '\n';
    std::string_view rest = text;
    if (asked_) check_silence(what);
    asked_ = true;
    const auto begin = Clock::now();
    std::size_t end;
    while ((end = received_.find('\n')) == std::string::npos || !rest.empty()) {
        check_time(what, begin, wait, budget);
        if (std::min(end, received_.size()) > longest)
            fail("has written more than " + std::to_string(longest) +
                 " bytes without a line break instead of " + what);
        const bool wanted = end == std::string::npos;
        pollfd ends[] = {{wanted ? output_ : -1, POLLIN, 0},
                         {rest.empty() ? -1 : input_, POLLOUT, 0}};
        if (poll(ends, 2, 50) <= 0) continue;
        if (ends[1].revents != 0) send(rest);
        if (ends[0].revents != 0) receive(what);
    }
    std::string found = received_.substr(0, end);
    received_.erase(0, end + 1);
    return found;
}

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// Whole numbers without a point.
ordered_json number(double value) {
    constexpr double exact = 9007199254740992;  // 2^53
    if (std::abs(value) < exact && std::floor(value) == value)
        return static_cast<std::int64_t>(value);
    return value;
}

ordered_json numbers(std::span<const double> values) {
    ordered_json out = ordered_json::array();
    for (const double value : values) out.push_back(number(value));
    return out;
}

ordered_json numbers(const Vector& vector) {
    const double values[] = {vector.x, vector.y, vector.z};
    return numbers(values);
}

std::string question(const Traversal& course, std::span<const Query* const> queries) {
    ordered_json all = ordered_json::array();
    for (const Query* query : queries)
        all.push_back({{"module", query->name},
                       {"index", query->module},
                       {"parameters", numbers(query->parameters)},
                       {"position", numbers(query->position)},
                       {"heading", numbers(query->attitude.heading())},
                       {"left", numbers(query->attitude.left())},
                       {"up", numbers(query->attitude.up())}});
    return ordered_json{{"generation", course.generation}, {"queries", all}}.dump();
}

/// The beginning of what a program wrote, in quotes, as it can be shown.
std::string shown(const std::string& text) {
    constexpr std::size_t most = 60;
    std::string out;
    for (const char byte : text.substr(0, most)) out += byte >= 0x20 && byte < 0x7F ? byte : '?';
    return '\'' + out + (text.size() > most ? "...'" : "'");
}

/// Reads the line that answers these queries.
class Answer {
public:
    Answer(const std::string& command, const Traversal& course,
           std::span<const Query* const> queries)
        : command_(command), course_(course), queries_(queries) {}

    std::vector<std::vector<double>> read(const std::string& line) const {
        const json all = json::parse(line, nullptr, false);
        if (!all.is_object() || !all.contains("answers") || !all["answers"].is_array())
            fail("expected a line such as {\"answers\":[[1],[2]]}, found " + shown(line));
        const json& list = all["answers"];
        if (list.size() != queries_.size())
            fail("expected " + std::to_string(queries_.size()) + " answers, found " +
                 std::to_string(list.size()));
        std::vector<std::vector<double>> out;
        for (std::size_t i = 0; i < list.size(); ++i)
            out.push_back(parameters(list[i], *queries_[i]));
        return out;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error("the environment program '" + command_ + "', generation " +
                    std::to_string(course_.generation) + ": " + what);
    }

    std::vector<double> parameters(const json& answer, const Query& query) const {
        const std::size_t count = query.parameters.size();
        const std::string expected = "expected an array of " + counted(count, "number") + " for " +
                                     place_of(query, course_) + ", found ";
        if (!answer.is_array() || answer.size() != count) fail(expected + shown(answer.dump()));
        std::vector<double> out;
        for (const json& value : answer) {
            if (!value.is_number()) fail(expected + shown(answer.dump()));
            out.push_back(value.get<double>());
        }
        return out;
    }

    const std::string& command_;
    const Traversal& course_;
    std::span<const Query* const> queries_;
};

}  // namespace

ExternalEnvironment::ExternalEnvironment(const std::string& command)
    : ExternalEnvironment(command, LineProcess::patience) {}

ExternalEnvironment::ExternalEnvironment(const std::string& command, std::chrono::milliseconds wait)
    : command_(command), program_(std::make_unique<LineProcess>(command)), wait_(wait) {}

ExternalEnvironment::~ExternalEnvironment() = default;

std::vector<std::vector<double>> ExternalEnvironment::answers(const Traversal& course,
                                                              std::span<const Query* const> queries,
                                                              const Budget& budget) {
    std::size_t longest = 1 << 16;  // bytes: room for more than the numbers need
    for (const Query* query : queries) longest += 64 + 64 * query->parameters.size();
    const std::string what = "the answer to generation " + std::to_string(course.generation);
    const std::string line =
        program_->answer(question(course, queries), what, longest, budget, wait_);
    return Answer(command_, course, queries).read(line);
}

}  // namespace algae
