// Long work says where it is: which cell, statement, generation or point, with numbers, on a pipe as on a terminal.

#include <doctest/doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <regex>
#include <string>
#include <vector>

#include "command/run.hpp"

namespace {

/// Runs a command whose standard error is a pipe, until a line there matches, and kills it then. The line; empty where none came in a
/// minute, or before the end.
std::string told(const std::string& arguments, const std::regex& wanted, std::string& all) {
    std::array<int, 2> ends{};
    REQUIRE(pipe(ends.data()) == 0);
    const std::string command = "ALGAE_PROGRESS=0.2 exec '" + built_command() + "' " + arguments;
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]);
        close(ends[1]);
        dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
        execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    close(ends[1]);
    std::string found;
    std::size_t begin = 0;
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (found.empty() && std::chrono::steady_clock::now() < end) {
        pollfd waiting{ends[0], POLLIN, 0};
        if (poll(&waiting, 1, 1000) <= 0) continue;
        std::array<char, 4096> bytes{};
        const ssize_t count = read(ends[0], bytes.data(), bytes.size());
        if (count <= 0) break;
        all.append(bytes.data(), static_cast<std::size_t>(count));
        for (std::size_t line = all.find('\n', begin); line != std::string::npos && found.empty();
             begin = line + 1, line = all.find('\n', begin))
            if (const std::string text = all.substr(begin, line - begin);
                std::regex_match(text, wanted))
                found = text;
    }
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    close(ends[0]);
    return found;
}

/// Text with 3,000,000 letters, without any order.
std::string many_letters() {
    std::string text;
    unsigned next = 1;
    for (int i = 0; i < 3'000'000; ++i) {
        next = next * 1103515245 + 12345;
        text += static_cast<char>('a' + (next >> 16) % 3);
    }
    return text;
}

}  // namespace

TEST_CASE("every verb with long work says where it is, with numbers, on a pipe") {
    const Scratch files;
    const std::string out = files.file("out");
    const std::string doubling = files.file("doubling.lsys", "axiom A(1)\nA(x) -> A(x+1) A(x-1)\n");
    const std::string seen =
        files.file("seen.lsys", "axiom A(1)\nA(y) < A(x) -> A(x+y) A(x)\nA(x) -> A(x) A(x)\n");
    std::string digraph = "alphabet", rules;
    unsigned next = 1;
    for (int i = 0; i < 500; ++i) {
        digraph += " x" + std::to_string(i);
        rules += "x" + std::to_string(i) + " ->";
        for (int k = 0; k < 6; ++k) {
            next = next * 1103515245 + 12345;
            rules += " x" + std::to_string((next >> 16) % 500);
        }
        rules += "\n";
    }
    const std::string many = files.file("many.lsys", digraph + "\naxiom x0\n" + rules);
    const std::string n = "[0-9][0-9,]*";
    const std::vector<std::array<std::string, 2>> works{
        {"closure", "cell " + n + " of " + n + " \\([^)]*\\)(, .*)?"},
        {"check --say 'for all 0L languages A, B: A B is EDT0L' --instances 1000000000 --size 99",
         "claim 1 of 1.*, statement 1 of 1, instance " + n + " of 1,000,000,000 \\(size " + n +
             "\\)(, .*)?"},
        {"check theory",
         "claim " + n + " of " + n + " \\(.*\\), statement " + n + " of " + n + ".*"},
        {"derive " + doubling + " -n 60 --max-letters 100000000000",
         "generation " + n + " of 60, modules " + n},
        {"derive " + seen + " -n 60", "generation " + n + " of 60, module " + n + " of " + n},
        {"derive " +
             files.file("cells.lsys",
                        "axiom b a a b a b b b\na < a > b -> b\nb < b > b -> a\na < b > a -> b\n") +
             " -n 1000000000",
         "generation " + n + " of 1,000,000,000, letters " + n},
        {"tree " + files.file("tree.lsys", "axiom F\nF -> F[+F]F[-F]F\n") +
             " -n 9 --max-nodes 100000000 -o " + out + ".svg",
         "(generation|nodes) .*" + n + ".*"},
        {"tree " + many + " --graph -o " + out + ".svg", "nodes being placed by Graphviz 500"},
        {"growth koch -n 300000000", "(squaring|generation) " + n + " of " + n},
        {"draw bush-3d -n 9 -o " + out + ".obj",
         "(module of the walk|rod|part of the mesh|colour of the mesh|triangles being written) " +
             n + ".*"},
        {"draw bush-3d -n 9 -o " + out + ".glb",
         "(module of the walk|rod|part of the mesh|colour of the mesh|triangles being written) " +
             n + ".*"},
        {"draw bush-3d -n 9 -o " + out + ".stl",
         "(module of the walk|rod|part of the mesh|colour of the mesh|triangles being written) " +
             n + ".*"},
        {"ifs fern --points 1000000000 -o " + out + ".png",
         "point " + n + " of 1,000,000,000(, .*)?"},
        {"brownian --levels 24 -o " + out + ".svg",
         "path 1 of 1, (covariance|frequency) " + n + " of " + n},
        {"ca --rule 30 --cells 30000 -n 30000 -o " + out + ".png", "generation " + n + " of " + n},
        {"dla --particles 10000000 -o " + out + ".png", "particle " + n + " of 10,000,000"},
        {"terrain --levels 13 --view solid -o " + out + ".png",
         "(level " + n + " of 13|row of the land " + n + " of .*)"},
        {"words --letters " + files.file("letters", many_letters()),
         "(suffix|letter for palindromes|letter for repetitions) " + n + " of " + n + ".*"},
        {"words thue-morse --to 6000", "(window|factors of length) " + n + ".*"},
        {"dimension --table", "figure " + n + " of " + n + " \\(.*\\).*"},
        {"dimension koch -n 14", "segments being counted " + n},
    };
    std::size_t number = 0;
    for (const auto& [work, where] : works) {
        INFO(work);
        std::string all;
        const std::string verb = work.substr(0, work.find(' '));
        const std::string line =
            told(work, std::regex("algae: " + verb + ": " + where + ", ([^,]*[0-9]+ %, )?[0-9]+ s"),
                 all);
        CHECK_MESSAGE(!line.empty(), "found only: " << all);
        ++number;
    }
    MESSAGE(number << " works said where they are");
}

TEST_CASE("verify says which statement it checks") {
    const Scratch files;
    const std::string claim = files.file("few.claim",
                                         "claim few\nlet G = D0L { axiom a; a -> ab; b -> a "
                                         "}\nshow abaab in L(G)\nshow ab in L(G)\n");
    const std::string certificate = files.file("few.json");
    REQUIRE(run("check " + claim + " --certificate " + certificate).status == 0);
    const std::string text = text_of(certificate);
    // The end of the text does not come.
    const std::string waits = files.file("waits.json");
    REQUIRE(mkfifo(waits.c_str(), 0600) == 0);
    const int pipe = open(waits.c_str(), O_RDWR);
    // It is read in pieces of 64 KiB.
    const std::string begun = text.substr(0, text.rfind(']')) + std::string(1 << 17, ' ');
    REQUIRE(fcntl(pipe, F_SETPIPE_SZ, 1 << 20) >= 1 << 18);
    REQUIRE(write(pipe, begun.data(), begun.size()) == static_cast<ssize_t>(begun.size()));
    std::string all;
    const std::string line =
        told("verify " + waits, std::regex("algae: verify: statement 2, [0-9]+ s"), all);
    close(pipe);
    CHECK_MESSAGE(!line.empty(), "found only: " << all);
}

TEST_CASE("ALGAE_PROGRESS takes seconds only") {
    for (const char* const wrong : {"soon", "", "0", "-1", "1s", "nan"}) {
        INFO(wrong);
        const Run refused = run("show koch", "ALGAE_PROGRESS='" + std::string(wrong) + "'");
        CHECK(refused.status == 2);
        CHECK(refused.err ==
              "algae: ALGAE_PROGRESS: expected seconds, from 0.1 to 1000000, found '" +
                  std::string(wrong) + "'\n");
    }
    CHECK(run("show koch", "ALGAE_PROGRESS=2.5").status == 0);
}
