#pragma once

#include <sys/uio.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/exact.hpp"
#include "report/report.hpp"
#include "system/system.hpp"

namespace algae::command {

/// Prints text to standard output. Throws Error if it cannot be written.
void print(std::string_view text);

/// Prints one of the two views of a report, or of what else has both.
template <class Report>
void print_report(const Report& report, bool json) {
    print(json ? to_json(report).text() : to_text(report));
}

/// A note on standard error: "algae: note: TEXT".
void note(const std::string& text);

/// Writes a file, which appears whole or not at all. `is_input`: it replaces the one that was read.
void write_file(const std::string& path, const std::string& text, bool is_input = false);

/// The text with what steers a terminal instead of being shown written as \x1b or \u202e: control characters other than the end of a
/// line, signs that turn the direction of writing, and bytes that are no UTF-8.
std::string printable(std::string_view text);

/// A field of a table with commas between its fields, quoted where it has to be.
std::string csv_field(const std::string& text);

/// Standard output for long words: pieces are handed to the system where they lie, many at once.
class StandardOutput : public TextSink {
public:
    StandardOutput();
    void write(std::string_view piece) override;
    void flush() override;

private:
    static constexpr std::size_t small = 2048;  // shorter pieces are gathered, it is cheaper
    static constexpr std::size_t gathered = std::size_t{1} << 17;

    std::vector<iovec> pieces_;
    std::string gathered_;
    std::size_t begun_ = 0;  // where in gathered_ the piece that still grows begins
};

/// The inside of a JSON string on its way to standard output: what needs escaping is escaped.
class JsonString : public TextSink {
public:
    explicit JsonString(StandardOutput& output) : output_(output) {}
    void write(std::string_view piece) override;
    void flush() override { output_.flush(); }

private:
    StandardOutput& output_;
    std::string escaped_;
};

/// A JSON text that is printed part by part. Where an error ends the work while it lives, the error's object follows what was printed,
/// between these two texts, and the text is whole.
class OpenJson {
public:
    OpenJson(std::string before, std::string after);
    ~OpenJson();
    OpenJson(const OpenJson&) = delete;
    OpenJson& operator=(const OpenJson&) = delete;
    void set_before(std::string before);

private:
    int errors_;  // that are on their way where it is made
};

/// Prints the object of an error, `{"error": ...}`, or ends the JSON text that is open with it.
void print_error_object(const Json& error);

/// A value as it stands in an array or object, without the end of its last line.
std::string json_element(const Json& value);

/// Says on standard error, while it lives, what works, where in its work it is (see watch/watch.hpp) and for how long: after five seconds,
/// then every ten, a line each; on a terminal one line that changes. Where a ProgressBar lives it says how far that is. The environment
/// variable ALGAE_PROGRESS has other seconds for both.
class Heartbeat {
public:
    explicit Heartbeat(std::string label);
    ~Heartbeat();
    Heartbeat(const Heartbeat&) = delete;
    Heartbeat& operator=(const Heartbeat&) = delete;

private:
    struct Beat;
    std::unique_ptr<Beat> beat_;
};

/// From now on heartbeats end the program where work goes on for two seconds after it was told to stop, or after its time was over: in a
/// library that asks nobody, or where a check was forgotten. Unfinished files are removed. For `main`, not for tests.
void end_late_work();

/// When the time of the work is over, and the option that says so.
void set_deadline(std::optional<std::chrono::steady_clock::time_point> time, const char* option);

/// A bar on standard error, if that is a terminal; otherwise the heartbeat tells of it.
class ProgressBar : public Progress {
public:
    explicit ProgressBar(std::string label);
    ~ProgressBar() override;
    void report(double done) override;

private:
    std::string label_;
    bool shown_ = false;
    bool terminal_;
    int last_ = -1;
};

}  // namespace algae::command
