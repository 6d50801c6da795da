#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "command/detail/verb.hpp"

namespace in_process {

/// How a verb ended and what it printed.
struct Ran {
    int status = -1;
    std::string out, err;
    bool operator==(const Ran&) const = default;
};

/// A stream of this process that goes to a file for a while.
class Captured {
public:
    Captured(int stream, const std::string& path)
        : stream_(stream), before_(dup(stream)), path_(path) {
        const int file = open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
        dup2(file, stream_);
        close(file);
    }
    std::string text() {
        dup2(before_, stream_);
        close(before_);
        std::ostringstream text;
        text << std::ifstream(path_, std::ios::binary).rdbuf();
        return text.str();
    }

private:
    int stream_, before_;
    std::string path_;
};

/// What `algae ARGUMENTS` does, by the same functions, but in this process.
inline Ran run(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
    std::vector<std::string> words{"algae"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const auto flush = [] {
        std::cout.flush();
        std::fflush(stdout);
        std::fflush(stderr);
    };
    flush();
    Captured out(STDOUT_FILENO, folder / "printed"), err(STDERR_FILENO, folder / "said");
    Ran ran;
    ran.status = algae::command::run_command(static_cast<int>(words.size()), pointers.data());
    flush();
    ran.out = out.text();
    ran.err = err.text();
    return ran;
}

}  // namespace in_process
