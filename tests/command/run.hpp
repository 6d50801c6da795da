#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "places.hpp"

/// What the command printed and how it ended.
struct Run {
    int status = -1;  // exit status; 128 + signal if it was killed
    std::string out, err;
};

/// A folder for the files of one test, gone when the test is over.
class Scratch {
public:
    Scratch() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "algae-test-XXXXXX").string();
        if (!mkdtemp(pattern.data())) std::abort();
        path_ = pattern;
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    /// Writes a file and returns its path.
    std::string file(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return file(name);
    }
    std::size_t size() const {
        std::size_t count = 0;
        for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_))
            ++count;
        return count;
    }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

inline std::string text_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Runs `algae ARGUMENTS` in a shell.
inline Run run(const std::string& arguments, const std::string& before = "") {
    const Scratch scratch;
    const std::string out = scratch.file("out"), err = scratch.file("err");
    const std::string command =
        before + " '" + built_command() + "' " + arguments + " >'" + out + "' 2>'" + err + "'";
    const int ended = std::system(command.c_str());
    Run result;
    result.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : 128 + WTERMSIG(ended);
    result.out = text_of(out);
    result.err = text_of(err);
    return result;
}
