// Work that goes on after it was told to stop, or after its time: the program ends all the same, and soon.

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "command/run.hpp"

namespace {

/// A digraph of 500 letters, on whose layout Graphviz works for minutes.
std::string many_letters() {
    std::string alphabet = "alphabet", rules;
    unsigned next = 1;
    for (int i = 0; i < 500; ++i) {
        const std::string letter = "x" + std::to_string(i);
        alphabet += " " + letter;
        rules += letter + " ->";
        for (int k = 0; k < 6; ++k) {
            next = next * 1103515245 + 12345;
            rules += " x" + std::to_string((next >> 16) % 500);
        }
        rules += "\n";
    }
    return alphabet + "\naxiom x0\n" + rules;
}

/// 100,000 rules for a letter.
std::string many_rules() {
    std::string text = "axiom a\n";
    for (unsigned i = 0; i < 100'000; ++i) {
        text += "a -> ";
        for (unsigned bit = 0; bit < 17; ++bit) text += i >> bit & 1 ? 'a' : 'b';
        text += "\n";
    }
    return text;
}

std::vector<std::string> long_work(const Scratch& files) {
    const std::string letters = "'" + files.file("letters.lsys", many_letters()) + "'";
    const std::string rules = "'" + files.file("rules.lsys", many_rules()) + "'";
    const std::string out = files.file("out"), waits = files.file("waits.lsys");
    mkfifo(waits.c_str(), 0600);  // nobody writes into it
    return {
        "show " + waits,
        "draw bush-3d -n 9 -o " + out + ".glb",
        "draw bush-3d -n 9 -o " + out + ".stl",
        "ifs fern --points 1000000000 -o " + out + ".png",
        "brownian --levels 24 -o " + out + ".svg",
        "tree " + letters + " --graph -o " + out + ".svg",
        "derive " + rules + " --all-words -n 3",
        "finite " + rules,
        "draw bush-3d -n 8 -o " + out + ".obj",
        "draw koch -n 8 --progressive --max-frames 10000 -o " + out + ".gif",
        "ca --rule 30 --cells 30000 -n 30000 -o " + out + ".png",
        "dla --particles 10000000 -o " + out + ".png",
        "growth koch -n 300000000",
        "census '0L systems up to size 40'",
        "check --say 'for all 0L languages A, B: A B is EDT0L' --instances 1000000000 --size 99"};
}

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration time) { return std::chrono::duration<double>(time).count(); }

struct Ended {
    int status = -1;
    double late = 0;  // seconds from the signal to the end
    std::string err;
};

/// Starts a command, sends it a signal after a second, and waits for its end.
Ended stopped(const std::string& arguments, int signal, const Scratch& files) {
    const std::string err = files.file("err");
    const std::string command = "exec timeout --foreground -s KILL 90 '" + built_command() + "' " +
                                arguments + " >/dev/null 2>'" + err + "'";
    const pid_t child = fork();
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    std::this_thread::sleep_for(std::chrono::seconds(1));
    const auto told = Clock::now();
    kill(child, signal);  // which `timeout` passes on
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            seconds(Clock::now() - told), text_of(err)};
}

}  // namespace

// How long the ends took is printed and not tested, as the machine may be busy with other work.

TEST_CASE("Ctrl-C, SIGTERM and SIGHUP end every work") {
    const Scratch files, said;
    const std::vector<std::pair<std::string, int>> signals{
        {"INT", SIGINT}, {"TERM", SIGTERM}, {"HUP", SIGHUP}};
    std::vector<std::string> works = long_work(files);
    works.push_back("closure");  // whose cells say themselves where the time ended
    std::size_t number = 0;
    std::pair<double, std::string> latest;
    for (const std::string& work : works) {
        const auto& [name, signal] = signals[number++ % signals.size()];
        INFO(name << " " << work);
        const Ended ended = stopped(work, signal, said);
        CHECK(ended.status == 130);
        CHECK(ended.err.ends_with("algae: interrupted\n"));
        latest = std::max(latest, {ended.late, work});
    }
    for (const auto& entry : std::filesystem::directory_iterator(files.path()))
        CHECK(entry.path().string().find(".part") == std::string::npos);
    MESSAGE(number << " works were stopped; the latest ended " << latest.first
                   << " s after the signal: " << latest.second);
}

TEST_CASE("--timeout ends every work, and says so") {
    const Scratch files;
    std::size_t number = 0;
    std::pair<double, std::string> latest;
    for (const std::string& work : long_work(files)) {
        INFO(work);
        const auto begin = Clock::now();
        const Run ended = run(work + " --timeout 0.5", "timeout -k 1 60");
        CHECK(ended.status == 3);
        CHECK((ended.err + ended.out).find("--timeout") != std::string::npos);
        latest = std::max(latest, {seconds(Clock::now() - begin) - 0.5, work});
        ++number;
    }
    MESSAGE("the time of " << number << " works was over; the latest ended " << latest.first
                           << " s after it: " << latest.second);
}

TEST_CASE("work of more than five seconds says where it is, on a pipe too") {
    const Run told = run("census '0L systems up to size 40'", "timeout -s INT 7");
    CHECK(told.err.find("algae: census: ") != std::string::npos);
    CHECK(told.err.find("5 s\n") != std::string::npos);
}
