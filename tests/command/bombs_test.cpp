// Inputs that ask for more memory than there is: whatever they ask for, the bound of --max-memory holds for what the program
// holds at its greatest, it ends by itself with a message, and no part of a file stays.

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "command/run.hpp"
#include "places.hpp"

namespace {

// Sanitizers have an account of their own: the one of algae is off under them, and their shadow counts as memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool has_own_account = false;
#else
constexpr bool has_own_account = true;
#endif

/// A command line; `@` is the file with the text, `%` a file that is written.
struct Bomb {
    std::string arguments, text;
};

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

std::vector<Bomb> bombs() {
    const std::string doubling = "axiom A(1)\nA(x) -> A(x)A(x)\n";
    const std::string deep = repeated("[", 2'000'000), letters = repeated("a", 3'000'000);
    const std::string context =
        "axiom " + repeated("ab", 200) + "\na < b > a -> ab\nb < a > b -> ba\n";
    const std::string long_context = "axiom a\n" + repeated("ab", 3000) + " < a -> aa\na -> aab\n";
    const std::string shapes =
        "axiom A(1, 1, 1)\nA -> div(Y, 2, 1r, 1r){ A B }\nB -> div(X, 2, 1r, 1r){ A A }\n"
        "generation 40\n";
    const std::string choices = "axiom ab\na -> a | ab | ba | b\nb -> a | bb | ab\n";
    const std::string tables = "axiom a\ntable x\na -> ab\nb -> ba\ntable y\na -> bb\nb -> ab\n";
    const std::string squares = "axiom A(3)\nA(x) -> A(x*x)A(x+1)\n";
    const std::string erasing = "axiom ab\na > b -> aab | b\na < b -> b | ε\n";
    const std::string ternary = "axiom a\na -> aaa\n";
    std::vector<Bomb> all{
        {"derive @ -n 60", doubling},
        {"derive @ -n 60 --json", doubling},
        {"derive @ -n 40", squares},
        {"derive @ -n 100 --all", ternary},
        {"derive @ -n 100", context},
        {"derive @ -n 30", long_context},
        {"show @", long_context},
        {"derive @ --all-words -n 12", choices},
        {"derive @ --all-words --longest 60", choices},
        {"derive @ --distribution -n 30", "axiom a\na -(1/2)-> ab\na -(1/2)-> ba\nb -> a\n"},
        {"derive @ --language -n 40", tables},
        {"derive @ -n 30", shapes},
        {"derive plant-a -n 40", ""},
        {"derive honda-a -n 40", ""},
        {"letter @ -n 90 --at 0 --count 100000000000", ternary},
        {"letter @ -n 30 --at 1000000 --count 1000000000", context},
        {"growth @ -n 100000000", ternary},
        {"growth @ -n 0..100000000", ternary},
        {"growth @ --counts -n 50000000", "axiom ab\na -> aab\nb -> abb\n"},
        {"growth @ --bounds -n 0..10000000", choices},
        {"growth --realise 1,1,2,3,5,8,13,21,34,55,89,144,233,377,610,987,1597,2584", ""},
        {"growth @ --words", "axiom a\na -> " + repeated("ab", 5000) + "\nb -> ba\n"},
        {"draw honda-a -n 40 -o %.svg", ""},
        {"draw koch -n 40 -o %.svg", ""},
        {"draw koch -n 40 -o %.png", ""},
        {"draw koch -n 14 --progressive -o %.gif", ""},
        {"draw koch -n 3 -o %.png --width 60000 --height 60000", ""},
        {"draw koch -n 3 -o %.webp --width 16000 --height 16000", ""},
        {"draw koch -n 0..400 --panels -o %.pdf", ""},
        {"draw koch -n 3 --seeds 1..100000 -o %.svg", ""},
        {"draw bush-3d -n 12 -o %.obj", ""},
        {"draw bush-3d -n 12 -o %.glb", ""},
        {"draw bush-3d -n 12 -o %.stl", ""},
        {"draw bush-3d -n 12 -o %.png", ""},
        {"draw bush-3d -n 8 --facets 256 -o %.ply", ""},
        {"draw @ -n 0 -o %.svg", "axiom " + deep + "\nF -> F\n"},
        {"tree plant-a -n 12 --max-nodes 100000000 -o %.svg", ""},
        {"tree plant-a -n 12 --max-nodes 100000000 -o %.dot", ""},
        {"tree @ -n 30 --max-nodes 100000000 --json -o %.svg", doubling},
        {"tree @ --graph -o %.svg", "axiom a\na -> " + letters.substr(0, 200'000) + "\n"},
        {"dimension koch -n 40", ""},
        {"dimension sierpinski-gasket -n 40 --measure mass", ""},
        {"dimension @", repeated("0.25 0.75\n", 3'000'000)},
        {"member @ " + repeated("ab", 3000), choices},
        {"member @ " + repeated("ab", 200) + " --all --max-derivations 100000000", choices},
        {"member @ bbb", erasing},
        {"finite @", tables},
        {"finite @", erasing},
        {"equal @ plant-a", tables},
        {"list '/(a|b)*/' --length 60", ""},
        {"list '/(a|b|c|d)*/' --words 1000000000", ""},
        {"list '~{a} & /(a|b)*/ {b}*' --counts --length 100000", ""},
        {"is 0L '/((a|b)(a|b)(a|b)(a|b)(a|b)(a|b)(a|b)(a|b)(a|b)(a|b)(a|b)(a|b)(a|b)(a|b)a)*/'",
         ""},
        {"is D0L '{" + repeated("ab", 40) + "}{a, b}{a, bb}{aa, b}{a, b}{a, b}{a, b}{a, b}{a, b}'",
         ""},
        {"check --say 'for all 0L languages A, B: A | B is 0L' --instances 1000000000 --size 99",
         ""},
        {"census '0L systems up to size 40' --distinct languages", ""},
        {"ifs fern --points 1000000000 -o %.png", ""},
        {"ifs fern --iterations 40 -o %.png", ""},
        {"walk --steps 1000000000 -o %.svg", ""},
        {"brownian --levels 40 -o %.svg", ""},
        {"brownian --levels 26 --method exact -o %.svg", ""},
        {"terrain --levels 20 -o %.png", ""},
        {"dla --particles 1000000000 -o %.png", ""},
        {"ca --rule 30 --cells 100000000 -n 1000000 -o %.png", ""},
        {"ca --rule 30 --cells 1000000 -n 100000000 --text", ""},
        {"show @", letters},
        {"show @", "axiom " + letters + "\na -> " + letters + "\n"},
        {"fmt @", repeated("a -> b\n", 500'000)},
        {"check @", "claim x\n" + repeated("show {a, b} {a, b} == {aa, ab, ba, bb}\n", 20'000)},
        {"verify @", "{\"format\": 1, \"statements\": " + repeated("[", 3'000'000)},
        {"convert @ --from netlogo --to lsys", letters},
    };
    return all;
}

struct Ended {
    int status = -1;
    std::uint64_t peak = 0;  // bytes
};

/// In bytes.
std::uint64_t peak_of(const struct rusage& used) {
    return static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
}

/// The most that this program has held, which its children are said to have held too.
std::uint64_t own_peak() {
    struct rusage used = {};
    getrusage(RUSAGE_SELF, &used);
    return peak_of(used);
}

/// Runs a command and measures the most it held.
Ended measured(const std::string& command) {
    const pid_t child = fork();
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", ("exec " + command).c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    int status = 0;
    struct rusage used = {};
    wait4(child, &status, 0, &used);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), peak_of(used)};
}

std::string with(std::string text, char sign, const std::string& value) {
    for (std::size_t at = text.find(sign); at != std::string::npos;
         at = text.find(sign, at + value.size()))
        text.replace(at, 1, value);
    return text;
}

}  // namespace

TEST_CASE("whatever an input asks for, the bound of memory holds" *
          doctest::skip(!has_own_account)) {
    constexpr std::uint64_t bound = 100 << 20;
    constexpr std::uint64_t most = bound + bound / 5 + (std::uint64_t{100} << 20);
    std::uint64_t greatest = 0;
    int count = 0;
    const bool peaks_are_seen = own_peak() < most;  // not where sanitizers hold more
    if (!peaks_are_seen) MESSAGE("PEAKS ARE NOT SEEN: this program holds more itself");
    for (const Bomb& bomb : bombs()) {
        INFO(bomb.arguments.substr(0, 200));
        const Scratch files, out;
        const std::string file = files.file("bomb.lsys", bomb.text);
        const std::string command =
            "timeout -s KILL 60 '" + built_command() + "' " +
            with(with(bomb.arguments, '@', "'" + file + "'"), '%', out.file("made")) +
            " --max-memory 100M --timeout 2 >/dev/null 2>'" + files.file("err") + "'";
        const Ended ended = measured(command);
        CHECK((ended.status == 0 || ended.status == 1 || ended.status == 2 || ended.status == 3));
        if (peaks_are_seen) CHECK(ended.peak <= most);
        const std::string said = text_of(files.file("err"));
        const bool is_list =
            bomb.arguments.starts_with("list");  // says below its words that they are not all
        if (ended.status == 2 || (ended.status == 3 && !is_list)) CHECK(!said.empty());
        for (const auto& entry : std::filesystem::directory_iterator(out.path()))
            CHECK(entry.path().string().find(".part") == std::string::npos);
        greatest = std::max(greatest, ended.peak);
        ++count;
    }
    MESSAGE(count << " bombs, the greatest peak is " << (greatest >> 20) << " MiB of "
                  << (most >> 20));
    CHECK(count >= 60);
}
