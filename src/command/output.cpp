// The output of the command: texts, long words piece by piece, and a bar for the progress.
//
// Words of a generation may be larger than memory, so they are written in pieces, which are copied as little as
// possible (writev), and the JSON around them is written by hand. All other JSON is a value of
// report/report.hpp.

#include "command/detail/output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <iostream>

#include "exact/exact.hpp"
#include "render/render.hpp"

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

void note(const std::string& text) { std::cerr << "algae: note: " << text << '\n'; }

void write_file(const std::string& path, const std::string& text) {
    FileOutput file(path);
    file.write(text.data(), text.size());
    file.commit();
}

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)), terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::report(double done) {
    if (!terminal_) return;
    const int percent = static_cast<int>(100 * std::clamp(done, 0.0, 1.0));
    if (percent == last_) return;
    last_ = percent;
    shown_ = true;
    const int marks = percent * 30 / 100;
    std::fprintf(stderr, "\r%s [%s%s] %3d%%", label_.c_str(),
                 std::string(static_cast<std::size_t>(marks), '#').c_str(),
                 std::string(static_cast<std::size_t>(30 - marks), ' ').c_str(), percent);
    std::fflush(stderr);
}

}  // namespace algae::command
