#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

namespace algae {

/// Where the bytes of a document go.
class Output {
public:
    virtual ~Output() = default;
    /// Throws Error if the bytes cannot be written, with the system's reason.
    virtual void write(const char* bytes, std::size_t count) = 0;
};

/// A file that appears whole or not at all: its bytes go to a temporary file in the same folder
/// until `commit` gives it its name. What is no ordinary file (a pipe, /dev/stdout) is written
/// directly; a symbolic link is followed.
class FileOutput final : public Output {
public:
    /// Throws Error if `path` is a directory or cannot be written.
    explicit FileOutput(const std::string& path);
    FileOutput(const FileOutput&) = delete;
    FileOutput& operator=(const FileOutput&) = delete;
    /// Without `commit`, nothing is left behind and a file of that name is as it was.
    ~FileOutput() override;

    void write(const char* bytes, std::size_t count) override;
    /// Throws Error if the file cannot be completed.
    void commit();

private:
    [[noreturn]] void fail(int reason) const;
    void flush();

    std::string path_;       // as the caller wrote it, for messages
    std::string target_;     // where symbolic links lead
    std::string temporary_;  // empty if written directly
    std::string buffer_;
    int descriptor_ = -1;
};

/// A stream, such as standard output.
class StreamOutput final : public Output {
public:
    explicit StreamOutput(std::ostream& stream) : stream_(stream) {}
    void write(const char* bytes, std::size_t count) override;
    /// Throws Error if the stream cannot pass on what it holds.
    void finish();

private:
    void check() const;

    std::ostream& stream_;
};

}  // namespace algae
