#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>
#include <vector>

#include "command/run.hpp"
#include "places.hpp"

// A real Ctrl-C: `algae verify` is a process of its own, at work on a certificate whose check takes long, and gets SIGINT.

namespace {

/// A process with its output in files.
class Process {
public:
    Process(const std::vector<std::string>& arguments, const std::string& out,
            const std::string& err) {
        std::vector<std::string> words{built_command()};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> pointers;
        for (std::string& word : words) pointers.push_back(word.data());
        pointers.push_back(nullptr);
        id_ = fork();
        if (id_ != 0) return;
        for (const auto& [stream, path] : {std::pair(STDOUT_FILENO, out), {STDERR_FILENO, err}})
            dup2(open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), stream);
        execv(pointers[0], pointers.data());
        _exit(127);
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process() {
        if (ended_) return;
        kill(id_, SIGKILL);
        waitpid(id_, nullptr, 0);
    }

    void interrupt() const { kill(id_, SIGINT); }
    bool has_ended() {
        if (!ended_) ended_ = waitpid(id_, &status_, WNOHANG) == id_;
        return ended_;
    }
    /// The exit status; -1 if a signal ended it.
    int status() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }

    /// Whether the program has a handler for SIGINT.
    bool catches_interrupts() const {
        std::istringstream lines(text_of("/proc/" + std::to_string(id_) + "/status"));
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with("SigCgt:"))
                return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
        return false;
    }
    /// The seconds of processor time that the program has had.
    double seconds_at_work() const {
        const std::string text = text_of("/proc/" + std::to_string(id_) + "/stat");
        const std::size_t name_ends = text.rfind(')');
        if (name_ends == std::string::npos) return 0;
        std::istringstream fields(text.substr(name_ends + 1));
        std::string skipped;
        for (int i = 0; i < 11; ++i) fields >> skipped;
        double user = 0, system = 0;
        fields >> user >> system;
        return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
    }

private:
    pid_t id_ = -1;
    int status_ = 0;
    bool ended_ = false;
};

/// Waits until something is so; a machine may be busy, so the limit is generous.
bool comes_true(const std::function<bool()>& is_so) {
    const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(5);
    while (!is_so()) {
        if (std::chrono::steady_clock::now() > limit) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

/// A certificate with a statement that is checked at once and one that takes long. Letters go round in cycles of
/// 2, 3, 5, ..., 19 letters, so that 9,699,690 steps differ in what the automaton makes of them. The two letters of the
/// first cycle are always equal, so that no word of the system is the one that the inclusion leaves out.
std::string long_certificate() {
    std::string letters, table, axiom, word;
    for (const int length : {2, 3, 5, 7, 11, 13, 17, 19}) {
        const auto name = [&](int i) {
            return "c" + std::to_string(length) + "_" + std::to_string(i % length);
        };
        for (int i = 0; i < length; ++i) {
            letters += (letters.empty() ? "\"" : ", \"") + name(i) + "\"";
            table += (table.empty() ? "\"" : ", \"") + name(i) + "\": [\"" + name(i + 1) + "\"]";
        }
        axiom += (axiom.empty() ? name(0) : "") + std::string(" ") + name(0);
        word += (word.empty() ? name(1) : "") + std::string(" ") + name(0);
    }
    std::string all;  // with blanks between
    for (const char c : letters)
        if (c != '"' && c != ',') all += c;
    return R"({"format": "algae certificate 1", "claim": "cycles", "alphabet": [)" + letters +
           R"(], "systems": {"G": {"axiom": ")" + axiom + R"(", "tables": [{)" + table +
           R"(}]}}, "statements": [{"text": "axiom", "statement": {"member": ")" + axiom +
           R"(", "language": {"generated": "G"}}, "verdict": "proved", "proof": {"by": "membership"}},
{"text": "inclusion", "statement": {"included": [{"generated": "G"}, {"complement": {"words": [")" +
           word + R"("]}, "letters": ")" + all +
           R"("}]}, "verdict": "proved", "proof": {"by": "relations"}}]})";
}

}  // namespace

TEST_CASE("Ctrl-C while verify checks a certificate judges nothing") {
    const Scratch scratch;
    const std::string file = scratch.file("long.json", long_certificate());
    for (const char* json : {"", "--json"}) {
        INFO(json);
        std::vector<std::string> arguments{"verify", file};
        if (*json) arguments.emplace_back(json);
        const std::string out = scratch.file("out"), err = scratch.file("err");
        Process verify(arguments, out, err);
        REQUIRE(comes_true([&] {
            return verify.has_ended() ||
                   (verify.catches_interrupts() && verify.seconds_at_work() >= 0.3);
        }));
        INFO(text_of(out) << text_of(err));
        REQUIRE(!verify.has_ended());  // it is at work
        verify.interrupt();
        REQUIRE(comes_true([&] { return verify.has_ended(); }));
        CHECK(verify.status() == 130);
        // It prints as it goes: at most what was checked before, and nothing of what it was at work on.
        const std::string printed = text_of(out);
        CHECK(printed.find("WRONG") == std::string::npos);
        CHECK(printed.find("complement of") == std::string::npos);
        CHECK(printed.find("2 checked") == std::string::npos);
        CHECK(text_of(err) == "algae: interrupted\n");
    }
}
