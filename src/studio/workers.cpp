// Processes that answer questions.
//
// The server must outlive every question: one that allocates without end, one that hits a fault of a library, one whose computation never
// looks at its budget. Only a process can be ended at any point, so each question has one. To start the program anew would take thirty
// milliseconds, a tenth of a second with a cold disk; a copy of a process that has loaded everything takes one.
//
// Three kinds of processes share one program. The maker is a copy of the server from the time before it had threads. It waits for
// four descriptors on a socket (question, output, errors, line), copies itself for them, and forgets them. The copy is the worker: it
// puts the descriptors in the places of the standard streams, bounds itself, does the work, sends its status over the line and ends by a
// signal to itself, because nothing that the server would do at its end is to be done twice.
//
// What is subtle: the maker's children are reaped by the kernel (SIGCHLD is ignored there), but a worker wants to wait for children of its
// own, so it takes that back. The file size limit of 0 makes every write to a file fail, but not to a pipe; the signal that comes with it must
// be ignored for the failure to be reported. The line is watched by a thread, so that a worker ends within its work too.

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "studio/detail/workers.hpp"

namespace algae {

namespace {

constexpr std::size_t descriptors = 4;
enum { question_at, output_at, errors_at, line_at };

/// A descriptor that is closed with this.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() { close(); }
    void close() {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }
    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }

private:
    int number_ = -1;
};

[[noreturn]] void end_process() {
    for (;;) ::kill(::getpid(), SIGKILL);
}

/// Ends the process when the line breaks or the time is over.
void watch(int line, double seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            end - std::chrono::steady_clock::now());
        if (left.count() <= 0) end_process();
        pollfd waits{line, POLLIN | POLLHUP, 0};
        const int found = ::poll(&waits, 1, static_cast<int>(std::min(left.count(), 3'600'000L)));
        if (found > 0 || (found < 0 && errno != EINTR)) end_process();
    }
}

std::string all_of(int file) {
    std::string text;
    std::array<char, 1 << 16> piece{};
    for (;;) {
        const ssize_t count = ::read(file, piece.data(), piece.size());
        if (count <= 0) return text;
        text.append(piece.data(), static_cast<std::size_t>(count));
    }
}

[[noreturn]] void be_worker(const std::array<int, descriptors>& given,
                            const std::function<int(const std::string&)>& work,
                            const StudioShare& share) {
    std::signal(SIGCHLD, SIG_DFL);
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_DFL);
    const rlimit nothing{0, 0};
    ::setrlimit(RLIMIT_FSIZE, &nothing);
    ::setrlimit(RLIMIT_CORE, &nothing);
    ::nice(5);  // the server comes first
    const std::string question = all_of(given[question_at]);
    ::close(given[question_at]);
    const int empty = ::open("/dev/null", O_RDONLY);
    ::dup2(empty, STDIN_FILENO);
    ::dup2(given[output_at], STDOUT_FILENO);
    ::dup2(given[errors_at], STDERR_FILENO);
    for (const int spare : {empty, given[output_at], given[errors_at]})
        if (spare > STDERR_FILENO) ::close(spare);
    std::thread(watch, given[line_at], share.seconds).detach();
    const int status = work(question);
    ::send(given[line_at], &status, sizeof status, MSG_NOSIGNAL);
    end_process();
}

/// The space of a message with descriptors.
struct Parcel {
    Parcel() {
        message.msg_iov = &bytes;
        message.msg_iovlen = 1;
        message.msg_control = control;
        message.msg_controllen = sizeof control;
    }
    char byte = 'q';
    iovec bytes{&byte, 1};
    alignas(cmsghdr) char control[CMSG_SPACE(descriptors * sizeof(int))] = {};
    msghdr message = {};
};

/// Makes a worker for each parcel that comes, until the line breaks.
[[noreturn]] void be_maker(int line, const std::function<int(const std::string&)>& work,
                           const StudioShare& share) {
    std::signal(SIGCHLD, SIG_IGN);
    for (;;) {
        Parcel parcel;
        const ssize_t count = ::recvmsg(line, &parcel.message, 0);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) end_process();
        const cmsghdr* head = CMSG_FIRSTHDR(&parcel.message);
        if (!head || head->cmsg_len != CMSG_LEN(descriptors * sizeof(int))) continue;
        std::array<int, descriptors> given{};
        std::memcpy(given.data(), CMSG_DATA(head), sizeof given);
        const pid_t child = ::fork();
        if (child == 0) {
            ::close(line);
            be_worker(given, work, share);
        }
        for (const int one : given) ::close(one);  // without a child the line breaks, which says so
    }
}

Error system_error(const std::string& what) { return Error(what + ": " + std::strerror(errno)); }

}  // namespace

Workers::Workers(std::function<int(const std::string&)> work, const StudioShare& share)
    : share_(share) {
    int pair[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pair) != 0)
        throw system_error("the system gives no socket");
    const pid_t maker = ::fork();
    if (maker < 0) {
        const int reason = errno;
        ::close(pair[0]);
        ::close(pair[1]);
        errno = reason;
        throw system_error("the system gives no process");
    }
    if (maker == 0) {
        ::close(pair[0]);
        be_maker(pair[1], work, share);
    }
    ::close(pair[1]);
    maker_ = pair[0];
}

Workers::~Workers() { ::close(maker_); }

Answered Workers::run(const std::string& question,
                      const std::function<bool(const std::string&)>& goes_on) {
    Descriptor asked(::memfd_create("question", MFD_CLOEXEC));
    int output[2], errors[2], line[2];
    if (!asked.is_open()) throw system_error("the system gives no memory for a question");
    if (::pipe2(output, O_CLOEXEC) != 0) throw system_error("the system gives no pipe");
    Descriptor out(output[0]), out_end(output[1]);
    if (::pipe2(errors, O_CLOEXEC) != 0) throw system_error("the system gives no pipe");
    Descriptor said(errors[0]), said_end(errors[1]);
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, line) != 0)
        throw system_error("the system gives no socket");
    Descriptor status(line[0]), line_end(line[1]);

    for (std::size_t done = 0; done < question.size();) {
        const ssize_t count =
            ::write(asked.number(), question.data() + done, question.size() - done);
        if (count <= 0) throw system_error("a question cannot be written");
        done += static_cast<std::size_t>(count);
    }
    ::lseek(asked.number(), 0, SEEK_SET);
    {
        Parcel parcel;
        cmsghdr* head = CMSG_FIRSTHDR(&parcel.message);
        head->cmsg_level = SOL_SOCKET;
        head->cmsg_type = SCM_RIGHTS;
        head->cmsg_len = CMSG_LEN(descriptors * sizeof(int));
        const std::array<int, descriptors> given{asked.number(), out_end.number(),
                                                 said_end.number(), line_end.number()};
        std::memcpy(CMSG_DATA(head), given.data(), sizeof given);
        const std::lock_guard lock(asking_);
        if (::sendmsg(maker_, &parcel.message, MSG_NOSIGNAL) < 0)
            throw system_error("the process that makes workers is gone");
    }
    for (Descriptor* end : {&asked, &out_end, &said_end, &line_end}) end->close();

    Answered found;
    const auto begun = std::chrono::steady_clock::now();
    bool has_status = false, line_open = true;
    const auto last_line = [&] {
        const std::size_t end = found.said.find_last_of('\n');
        if (end == std::string::npos || end == 0) return std::string();
        const std::size_t begin = found.said.find_last_of('\n', end - 1);
        const std::size_t from = begin == std::string::npos ? 0 : begin + 1;
        return found.said.substr(from, end - from);
    };
    std::array<char, 1 << 16> piece{};
    while (out.is_open() || said.is_open() || line_open) {
        std::array<pollfd, 3> waits{{{out.number(), POLLIN, 0},
                                     {said.number(), POLLIN, 0},
                                     {line_open ? status.number() : -1, POLLIN, 0}}};
        ::poll(waits.data(), waits.size(), 50);
        const auto take = [&](Descriptor& from, const pollfd& seen, std::string& into) {
            if (!from.is_open() || seen.revents == 0) return;
            const ssize_t count = ::read(from.number(), piece.data(), piece.size());
            if (count > 0)
                into.append(piece.data(), static_cast<std::size_t>(count));
            else if (count == 0 || errno != EINTR)
                from.close();
        };
        take(out, waits[0], found.answer);
        take(said, waits[1], found.said);
        if (waits[2].revents != 0) {
            const ssize_t count = ::recv(status.number(), &found.status, sizeof found.status, 0);
            if (count == sizeof found.status)
                has_status = true;
            else
                line_open = false;
        }
        if (found.answer.size() + found.said.size() > share_.answer) {
            found.end = Answered::End::size;
            return found;
        }
        if (!goes_on(last_line())) {
            found.end = Answered::End::gone;
            return found;  // the line breaks with `status`, and the worker ends
        }
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    found.end = has_status                       ? Answered::End::answered
                : took.count() >= share_.seconds ? Answered::End::time
                                                 : Answered::End::broken;
    return found;
}

std::vector<Answered> answer_apart(const std::vector<std::string>& questions,
                                   const std::function<int(const std::string&)>& answer,
                                   const StudioShare& share,
                                   const std::function<bool(std::size_t done)>& goes_on) {
    Workers workers(answer, share);  // before there are threads
    std::vector<Answered> answers(questions.size());
    std::atomic<std::size_t> next = 0, done = 0;
    std::atomic<bool> stopped = false;
    std::mutex failing;
    std::exception_ptr failure;
    const auto work = [&] {
        for (std::size_t at = next++; at < questions.size(); at = next++) {
            answers[at].end = Answered::End::gone;
            if (stopped) continue;
            try {
                answers[at] =
                    workers.run(questions[at], [&](const std::string&) { return !stopped.load(); });
            } catch (...) {
                const std::lock_guard lock(failing);
                failure = std::current_exception();
                stopped = true;
            }
            ++done;
        }
    };
    std::vector<std::thread> threads;
    const std::size_t count = std::min<std::size_t>(std::max(1U, share.at_once), questions.size());
    for (std::size_t i = 0; i < count; ++i) threads.emplace_back(work);
    constexpr auto glance = std::chrono::milliseconds(50);
    while (done < questions.size() && !stopped) {
        if (!goes_on(done)) stopped = true;
        std::this_thread::sleep_for(glance);
    }
    for (std::thread& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
    return answers;
}

}  // namespace algae
