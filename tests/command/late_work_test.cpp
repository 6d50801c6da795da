// Work that goes on after it was told to stop, or after its time: the program ends all the same, and soon.

#include <doctest/doctest.h>

#include <string>
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
    const std::string out = files.file("out");
    return {
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

}  // namespace

TEST_CASE("Ctrl-C, SIGTERM and SIGHUP end every work") {
    const Scratch files;
    std::size_t number = 0;
    for (const std::string& work : long_work(files)) {
        const std::string signal = std::vector<std::string>{"INT", "TERM", "HUP"}[number++ % 3];
        INFO(signal << " " << work);
        const Run ended = run(work, "timeout --preserve-status -k 60 -s " + signal +
                                        " 1");  // 137 if it has to be killed
        CHECK(ended.status == 130);
        CHECK(ended.err.ends_with("algae: interrupted\n"));
    }
    for (const auto& entry : std::filesystem::directory_iterator(files.path()))
        CHECK(entry.path().string().find(".part") == std::string::npos);
}

TEST_CASE("--timeout ends every work, and says so") {
    const Scratch files;
    for (const std::string& work : long_work(files)) {
        INFO(work);
        const Run ended = run(work + " --timeout 0.5", "timeout -k 1 60");
        CHECK(ended.status == 3);
        CHECK((ended.err + ended.out).find("--timeout") != std::string::npos);
    }
}

TEST_CASE("work of more than five seconds says where it is, on a pipe too") {
    const Run told = run("census '0L systems up to size 40'", "timeout -s INT 7");
    CHECK(told.err.find("algae: census: ") != std::string::npos);
    CHECK(told.err.find("5 s\n") != std::string::npos);
}
