// The output of the command: texts, long words piece by piece, and a bar for the progress.
//
// Words of a generation may be larger than memory, so they are written in pieces, which are copied as little as
// possible (writev), and the JSON around them is written by hand. All other JSON is a value of
// report/report.hpp.

#include "command/detail/output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iostream>
#include <limits>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "render/render.hpp"
#include "watch/watch.hpp"

namespace algae::command {

namespace {

[[noreturn]] void fail() {
    throw Error(std::string("cannot write to standard output: ") + std::strerror(errno));
}

void write_all(iovec* next, std::size_t count) {
    while (count > 0) {
        const ssize_t written =
            ::writev(STDOUT_FILENO, next, static_cast<int>(std::min<std::size_t>(count, IOV_MAX)));
        if (written < 0) {
            if (errno == EINTR) continue;
            fail();
        }
        auto left = static_cast<std::size_t>(written);
        while (count > 0 && left >= next->iov_len) {
            left -= next->iov_len;
            ++next;
            --count;
        }
        if (count > 0) {
            next->iov_base = static_cast<char*>(next->iov_base) + left;
            next->iov_len -= left;
        }
    }
}

}  // namespace

StandardOutput::StandardOutput() {
    gathered_.reserve(gathered + small);
    pieces_.reserve(256);
#ifdef F_SETPIPE_SZ
    ::fcntl(STDOUT_FILENO, F_SETPIPE_SZ, 1 << 20);  // fewer changes between writer and reader
#endif
}

void StandardOutput::write(std::string_view piece) {
    if (piece.size() <= small) {
        gathered_ += piece;
        if (gathered_.size() >= gathered) flush();
        return;
    }
    if (begun_ < gathered_.size()) {
        pieces_.push_back({gathered_.data() + begun_, gathered_.size() - begun_});
        begun_ = gathered_.size();
    }
    pieces_.push_back({const_cast<char*>(piece.data()), piece.size()});
    if (pieces_.size() >= 128) flush();
}

void StandardOutput::flush() {
    if (begun_ < gathered_.size())
        pieces_.push_back({gathered_.data() + begun_, gathered_.size() - begun_});
    write_all(pieces_.data(), pieces_.size());
    pieces_.clear();
    gathered_.clear();
    begun_ = 0;
}

void JsonString::write(std::string_view piece) {
    if (piece.find_first_of("\"\\") == std::string_view::npos) return output_.write(piece);
    escaped_.clear();
    for (const char c : piece) {
        if (c == '"' || c == '\\') escaped_ += '\\';
        escaped_ += c;
    }
    output_.write(escaped_);
    output_.flush();  // before the bytes are used again
}

void print(std::string_view text) {
    iovec piece{const_cast<char*>(text.data()), text.size()};
    if (!text.empty()) write_all(&piece, 1);
}

namespace {

/// What stands around an error where a JSON text is open.
struct Around {
    std::string before, after;
};

std::optional<Around> open_json;

}  // namespace

OpenJson::OpenJson(std::string before, std::string after) : errors_(std::uncaught_exceptions()) {
    open_json = Around{std::move(before), std::move(after)};
}

OpenJson::~OpenJson() {
    if (std::uncaught_exceptions() == errors_) open_json.reset();
}

void OpenJson::set_before(std::string before) { open_json->before = std::move(before); }

void print_error_object(const Json& error) {
    if (!open_json) return print(Json{{"error", error}}.text());
    const std::string text = json_element(error);
    print(open_json->before + "\"error\": " + text.substr(text.find_first_not_of(' ')) +
          open_json->after);
    open_json.reset();
}

std::string json_element(const Json& value) {
    std::string text = "  ";
    for (const char c : value.text()) {
        text += c;
        if (c == '\n') text += "  ";
    }
    return text.substr(0, text.find_last_of('\n'));
}

void note(const std::string& text) { std::cerr << "algae: note: " << printable(text) << '\n'; }

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

namespace {

/// A character that steers a terminal instead of being shown: of ASCII, of its second set of controls, or one that turns the direction in
/// which a line is written.
bool steers(std::uint32_t code) {
    if (code < 0x20) return code != '\n' && code != '\t';
    return (code >= 0x7f && code < 0xa0) || code == 0x61c || code == 0x200e || code == 0x200f ||
           (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

/// The code of the character of UTF-8 that a text begins with, and its bytes; 0 bytes if there is none.
std::pair<std::uint32_t, std::size_t> decoded(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return {first, 1};
    const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < bytes) return {0, 0};
    std::uint32_t code = first & (0x7fU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {0, 0};
        code = code << 6 | (byte(i) & 0x3fU);
    }
    return {code, bytes};
}

}  // namespace

std::string printable(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string all;
    while (!text.empty()) {
        const auto [code, bytes] = decoded(text);
        if (bytes > 0 && !steers(code)) {
            all += text.substr(0, bytes);
        } else if (code < 0x80) {  // a byte that is no text is one of controls for some terminals
            const auto byte = static_cast<unsigned char>(text[0]);
            all += "\\x";
            all += digits[byte >> 4];
            all += digits[byte & 15];
        } else {
            all += "\\u";
            for (const unsigned shift : {12U, 8U, 4U, 0U}) all += digits[code >> shift & 15];
        }
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    return all;
}

void write_file(const std::string& path, const std::string& text, bool is_input) {
    FileOutput file(path, is_input);
    file.write(text.data(), text.size());
    file.commit();
}

// --- Progress ---

namespace {

/// What standard error has of the progress; bars come and go in one thread, the heartbeat is another.
struct Shown {
    std::mutex guard;
    std::string bar;    // label of the bar that lives
    int percent = -1;   // of it
    bool line = false;  // an unfinished line is on the terminal
};
Shown& shown() {
    static Shown all;
    return all;
}

void clear_line() {
    if (std::exchange(shown().line, false)) std::fputs("\r\033[K", stderr);
}

}  // namespace

namespace {

std::atomic<bool> ends_late_work = false;
constexpr std::int64_t no_deadline = std::numeric_limits<std::int64_t>::max();
std::atomic<std::int64_t> deadline = no_deadline;  // of steady_clock, in its ticks
std::atomic<const char*> deadline_option = "--timeout";

/// How long the first thread has waited for a processor that others had. Nothing is allocated, as there may be no memory.
std::chrono::nanoseconds kept_off() {
    long long ran = 0, waited = 0;
    const int file = ::open("/proc/self/schedstat", O_RDONLY | O_CLOEXEC);
    if (file < 0) return {};
    std::array<char, 80> text{};
    const ssize_t size = ::read(file, text.data(), text.size() - 1);
    ::close(file);
    if (size <= 0 || std::sscanf(text.data(), "%lld %lld", &ran, &waited) != 2) return {};
    return std::chrono::nanoseconds(waited);
}

/// Whether the first thread does all work: besides it there is that of the heartbeat.
bool works_alone() {
    struct stat threads;
    return ::stat("/proc/self/task", &threads) == 0 && threads.st_nlink <= 2 + 2;
}

/// Whether a condition has held so long that work that heeds it would have ended: nearly two seconds of work, or of waiting for something
/// else than a processor, such as a reader or a writer. On a machine that does others' work it may take twice that.
class Overdue {
public:
    bool operator()(bool holds) {
        const auto now = std::chrono::steady_clock::now();
        if (holds && !held_) {
            since_ = now;
            worked_ = std::clock();
            kept_off_ = kept_off();
        }
        held_ = holds;
        using namespace std::chrono_literals;
        const auto time = now - since_;
        if (!holds || time < 1400ms) return false;
        return std::clock() - worked_ >= CLOCKS_PER_SEC * 6 / 5 || time >= 4s ||
               (works_alone() && time - (kept_off() - kept_off_) >= 1400ms);
    }

private:
    bool held_ = false;  // the last time
    std::chrono::steady_clock::time_point since_;
    std::clock_t worked_ = 0;
    std::chrono::nanoseconds kept_off_{};
};

/// Ends the program in the middle of its work, which has no lasting state but files without a name yet.
[[noreturn]] void end_now(const std::string& message, int status) {
    remove_unfinished_files();
    std::fprintf(stderr, "algae: %s\n", message.c_str());
    std::_Exit(status);
}

}  // namespace

namespace {

/// After how much time work is told of first, and then again and again.
struct Intervals {
    std::chrono::milliseconds first, next;
};

Intervals intervals_of(bool terminal) {
    using namespace std::chrono_literals;
    if (const char* const asked = std::getenv("ALGAE_PROGRESS")) {
        char* end = nullptr;
        const double seconds = std::strtod(asked, &end);
        if (end == asked || *end != '\0' || !(seconds >= 0.1 && seconds <= 1e6))
            throw Error(
                std::string("ALGAE_PROGRESS: expected seconds, from 0.1 to 1000000, found ") +
                quoted(asked));
        const auto every = std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000));
        return {every, every};
    }
    return {5s, terminal ? 1s : 10s};
}

}  // namespace

void end_late_work() { ends_late_work = true; }

void set_deadline(std::optional<std::chrono::steady_clock::time_point> time, const char* option) {
    deadline_option = option;
    deadline = time ? time->time_since_epoch().count() : no_deadline;
}

struct Heartbeat::Beat {
    std::string label;
    bool terminal = ::isatty(STDERR_FILENO) != 0;
    Intervals intervals = intervals_of(terminal);
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    std::mutex guard;
    std::condition_variable ended;
    bool is_over = false;
    WorkWatch watch;
    std::thread thread;

    void run() {
        using namespace std::chrono_literals;
        std::unique_lock lock(guard);
        auto next = begin + intervals.first;
        Overdue stopped, late;
        while (!ended.wait_for(lock, 100ms, [&] { return is_over; })) {
            const auto now = std::chrono::steady_clock::now();
            if (now >= next) {
                tell();
                next = now + intervals.next;
            }
            if (!ends_late_work) continue;
            if (stopped(stop)) end_now("interrupted", interrupted);
            if (late(now.time_since_epoch().count() > deadline))
                end_now(std::string("the time allowed by ") + deadline_option.load() + " is over",
                        undecided);
        }
    }

    void tell() const {
        const std::lock_guard lock(shown().guard);
        if (terminal && shown().percent >= 0) return;  // the bar is there
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(
                                 std::chrono::steady_clock::now() - begin)
                                 .count();
        std::string text = "algae: " + label + ": ";
        if (const std::string where = printable(watch.where()); !where.empty())
            text += where + ", ";
        if (shown().percent >= 0)
            text += (shown().bar == label ? "" : shown().bar + " ") +
                    std::to_string(shown().percent) + " %, ";
        text += std::to_string(seconds) + " s";
        if (terminal) {
            std::fprintf(stderr, "\r%s\033[K", text.c_str());
            shown().line = true;
        } else {
            std::fprintf(stderr, "%s\n", text.c_str());
        }
        std::fflush(stderr);
    }
};

Heartbeat::Heartbeat(std::string label) : beat_(std::make_unique<Beat>()) {
    beat_->label = std::move(label);
    sigset_t all, before;
    sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, &before);  // signals are for the thread that works
    try {
        beat_->thread = std::thread([beat = beat_.get()] { beat->run(); });
    } catch (const std::system_error&) {
        // Without a thread nothing is told.
    }
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Heartbeat::~Heartbeat() {
    {
        const std::lock_guard lock(beat_->guard);
        beat_->is_over = true;
    }
    beat_->ended.notify_one();
    if (beat_->thread.joinable()) beat_->thread.join();
    const std::lock_guard lock(shown().guard);
    clear_line();
}

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)), terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    const std::lock_guard lock(shown().guard);
    shown().percent = -1;
    if (shown_) clear_line();
}

void ProgressBar::report(double done) {
    const int percent = static_cast<int>(100 * std::clamp(done, 0.0, 1.0));
    if (percent == last_) return;
    last_ = percent;
    const std::lock_guard lock(shown().guard);
    shown().bar = label_;
    shown().percent = percent;
    if (!terminal_) return;
    shown_ = shown().line = true;
    const int marks = percent * 30 / 100;
    std::fprintf(stderr, "\r%s [%s%s] %3d%%", label_.c_str(),
                 std::string(static_cast<std::size_t>(marks), '#').c_str(),
                 std::string(static_cast<std::size_t>(30 - marks), ' ').c_str(), percent);
    std::fflush(stderr);
}

}  // namespace algae::command
