#pragma once

#include <sys/uio.h>

#include <cstddef>
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

/// Writes a file, which appears whole or not at all.
void write_file(const std::string& path, const std::string& text);

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

/// A bar on standard error, if that is a terminal.
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
