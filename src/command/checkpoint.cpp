#include "command/detail/checkpoint.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "command/detail/files.hpp"

// Files of long work. Headers are compared as texts, and may stand in the middle too: files of one question that are put together
// are a file of it.

namespace algae::command {

namespace {

/// What two headers say where they begin to differ.
std::string difference(const std::string& expected, const std::string& found) {
    const auto at = static_cast<std::size_t>(
        std::mismatch(expected.begin(), expected.end(), found.begin(), found.end()).first -
        expected.begin());
    const std::size_t from = at < 60 ? 0 : at - 40;
    const auto excerpt = [&](const std::string& text) {
        return (from > 0 ? "..." : "") + text.substr(from, 120) +
               (text.size() > from + 120 ? "..." : "");
    };
    return "expected " + excerpt(expected) + ", found " + excerpt(found);
}

}  // namespace

Checkpoint::~Checkpoint() {
    if (file_ >= 0) ::close(file_);
}

void Checkpoint::begin(const std::string& path, const std::string& header) {
    path_ = path;
    file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0 && errno == EEXIST)
        throw Error("--checkpoint: " + path + " is there already; --resume " + path +
                    " goes on from it");
    expect(file_ >= 0, "be made");
    lock();
    write(header);
}

void Checkpoint::go_on(const std::string& path, const std::string& header, bool adds,
                       const std::function<bool(const std::string&)>& take, const Budget& budget) {
    path_ = path;
    if (adds) {
        file_ = ::open(path.c_str(), O_RDWR | O_APPEND | O_CLOEXEC);
        expect(file_ >= 0, "be opened");
        lock();
    }
    const std::string text = file_text(path, budget);
    std::size_t from = 0;
    for (std::size_t number = 1; from < text.size(); ++number) {
        const std::size_t end = text.find('\n', from);
        const std::string line = text.substr(from, end - from);
        const std::string place = path + ":" + std::to_string(number) + ": ";
        if (end == std::string::npos) {  // torn
            if (number == 1 && !header.starts_with(line))
                throw Error(place + "this is no checkpoint of the question; " +
                            difference(header, line));
            break;
        }
        if (line != header) {
            if (number == 1 || line.starts_with("{\"format\""))
                throw Error(place + "the checkpoint is of another question; " +
                            difference(header, line));
            if (!take(line)) {
                if (end + 1 == text.size()) break;
                throw Error(place + "expected a line of a checkpoint, found \"" +
                            line.substr(0, 60) + '"');
            }
        }
        from = end + 1;
    }
    if (!adds) return;
    expect(::ftruncate(file_, static_cast<off_t>(from)) == 0, "be cut behind its last whole line");
    if (from == 0) write(header);
}

void Checkpoint::write(const std::string& line) {
    const std::string whole = line + '\n';
    for (std::size_t done = 0; done < whole.size();) {
        const ssize_t written = ::write(file_, whole.data() + done, whole.size() - done);
        if (written < 0 && errno == EINTR) continue;
        expect(written >= 0, "be written");
        done += static_cast<std::size_t>(written);
    }
}

void Checkpoint::lock() const {
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        throw Error(path_ + ": another process adds lines to this file");
}

void Checkpoint::expect(bool holds, const char* what) const {
    if (!holds) throw Error(path_ + ": cannot " + what + ": " + std::strerror(errno));
}

}  // namespace algae::command
