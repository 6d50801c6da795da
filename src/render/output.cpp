#include "render/output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <system_error>

#include "base/error.hpp"

namespace algae {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16;

/// Names of temporary files differ between processes and, by the counter, between threads.
std::string temporary_name(const std::string& target) {
    static std::atomic<unsigned> counter{0};
    return target + ".part-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
}

}  // namespace

FileOutput::FileOutput(const std::string& path) : path_(path), target_(path) {
    namespace files = std::filesystem;
    std::error_code ignored;
    if (path.empty()) throw Error("cannot write a file without a name");
    if (files::is_symlink(path, ignored)) {
        const files::path leads_to = files::weakly_canonical(path, ignored);
        if (!ignored) target_ = leads_to.string();
    }
    const files::file_status status = files::status(target_, ignored);
    if (files::is_directory(status)) fail(EISDIR);
    if (files::exists(status) && ::access(target_.c_str(), W_OK) != 0) fail(errno);

    const bool direct = files::exists(status) && !files::is_regular_file(status);
    if (!direct) temporary_ = temporary_name(target_);
    const int flags = O_WRONLY | O_CLOEXEC | (direct ? 0 : O_CREAT | O_EXCL);
    descriptor_ = ::open(direct ? target_.c_str() : temporary_.c_str(), flags, 0666);
    if (descriptor_ < 0) {
        const int reason = errno;
        temporary_.clear();
        fail(reason);
    }
    struct stat old;
    if (!direct && ::stat(target_.c_str(), &old) == 0) ::fchmod(descriptor_, old.st_mode & 07777);
    buffer_.reserve(buffer_size);
}

FileOutput::~FileOutput() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void FileOutput::fail(int reason) const {
    throw Error("cannot write " + path_ + ": " + std::generic_category().message(reason));
}

void FileOutput::flush() {
    std::size_t written = 0;
    while (written < buffer_.size()) {
        const ssize_t count =
            ::write(descriptor_, buffer_.data() + written, buffer_.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(errno);
        written += static_cast<std::size_t>(count);
    }
    buffer_.clear();
}

void FileOutput::write(const char* bytes, std::size_t count) {
    buffer_.append(bytes, count);
    if (buffer_.size() >= buffer_size) flush();
}

void FileOutput::commit() {
    flush();
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail(errno);
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    temporary_.clear();
}

void StreamOutput::write(const char* bytes, std::size_t count) {
    errno = 0;
    stream_.write(bytes, static_cast<std::streamsize>(count));
    check();
}

void StreamOutput::finish() {
    errno = 0;
    stream_.flush();
    check();
}

void StreamOutput::check() const {
    const int reason = errno;
    if (stream_.good()) return;
    throw Error("cannot write the picture" +
                (reason ? ": " + std::generic_category().message(reason) : std::string()));
}

}  // namespace algae
