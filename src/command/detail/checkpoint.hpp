#pragma once
// Files in which long work is written down while it is done, so that it goes on after a stop or a crash.

#include <functional>
#include <string>

#include "exact/exact.hpp"

namespace algae::command {

/// A file of lines: a header, which says what the work is, and lines with results. A line is written at once, by one
/// call, so a process that is killed leaves at most one torn line, the last one. One process at a time adds lines.
class Checkpoint {
public:
    Checkpoint() = default;
    Checkpoint(const Checkpoint&) = delete;
    Checkpoint& operator=(const Checkpoint&) = delete;
    ~Checkpoint();

    /// Makes a new file with the header. Throws Error if there is one.
    void begin(const std::string& path, const std::string& header);

    /// Reads a file. `take` is called with each line but headers and a torn last line, and says whether it is one of
    /// results. With `adds`, lines will be added behind the whole ones. Throws Error if a header is another one or a line is none.
    void go_on(const std::string& path, const std::string& header, bool adds,
               const std::function<bool(const std::string&)>& take, const Budget& budget);

    /// Whether lines are added to a file.
    bool is_open() const { return file_ >= 0; }

    void write(const std::string& line);

private:
    void lock() const;
    void expect(bool holds, const char* what) const;

    std::string path_;
    int file_ = -1;
};

}  // namespace algae::command
