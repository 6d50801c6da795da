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

#include "cli/command.hpp"
#include "cli/ending.hpp"

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
    CLI::App app;
    algae::cli::Verbs verbs{app, {}};
    algae::cli::add_verbs(verbs);
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    const auto flush = [] {
        std::cout.flush();
        std::fflush(stdout);
        std::fflush(stderr);
    };
    flush();
    Captured out(STDOUT_FILENO, folder / "printed"), err(STDERR_FILENO, folder / "said");
    Ran ran;
    ran.status = algae::cli::run(verbs.chosen);
    flush();
    ran.out = out.text();
    ran.err = err.text();
    return ran;
}

}  // namespace in_process
