// Runs ten verbs again and again, each time with one fault of the machine (see faults.c), and looks at what is left: the exit status, the
// output of before, parts of files. Prints a line for each verb and kind of fault, and what went wrong; ends with 1 if anything did.
//
//   inject ALGAE FAULTS.so FOLDER [EVERY]   EVERY 7: each seventh place only, beginning anywhere
//
// Crashes inside of Cairo, fontconfig and Graphviz, which say nothing when memory ends, are told apart: they are listed, and fail nothing.

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

/// A verb: its arguments, where @ is a file with the text and % the file that it writes, if it writes one.
struct Work {
    std::string name, arguments, text, ends;
    bool draws = false;  // by Cairo or Graphviz
};

const std::vector<Work> works{
    {"derive", "derive @ -n 5", "axiom a\na -> ab\nb -> a\n", ".lsys"},
    {"fmt", "fmt @", "axiom   a\na->ab # text\n", ".lsys"},
    {"growth", "growth @", "axiom a\na -> ab\nb -> a\n", ".lsys"},
    {"member", "member @ abaab", "axiom a\na -> ab\nb -> a\n", ".lsys"},
    {"is", "is 0L '{a, aa}' --certificate %", "", ".json"},
    {"check", "check @ --certificate %",
     "claim x\nlet G = D0L { axiom a; a -> ab; b -> a }\nshow abaab in L(G)\n", ".claim"},
    {"list", "list '/(a|bb)*/' --length 4", "", ".txt"},
    {"dimension", "dimension koch -n 7", "", ".txt"},
    {"draw", "draw koch -n 2 -o %.svg", "", ".svg", true},
    {"tree", "tree @ -n 2 -o %.svg", "axiom a\na -> ab\nb -> a\n", ".lsys", true},
};
const std::array<std::string, 5> kinds{"memory", "full", "broken", "short", "kill"};

std::string replaced(std::string text, char sign, const std::string& by) {
    for (std::size_t at = text.find(sign); at != std::string::npos;
         at = text.find(sign, at + by.size()))
        text.replace(at, 1, by);
    return text;
}

std::string text_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<std::string> words(const std::string& line) {
    std::vector<std::string> found;
    std::string word;
    bool quoted = false;
    for (const char c : line) {
        if (c == '\'') {
            quoted = !quoted;
        } else if (c == ' ' && !quoted) {
            found.push_back(word);
            word.clear();
        } else {
            word += c;
        }
    }
    found.push_back(word);
    return found;
}

class Runner {
public:
    Runner(std::string command, std::string library, std::string folder, const Work& work)
        : command_(std::move(command)),
          library_(std::move(library)),
          folder_(std::move(folder)),
          work_(work) {
        mkdir(folder_.c_str(), 0777);
        clear();
        std::ofstream(folder_ + "/in" + work.ends) << work.text;
        const std::string written = replaced(work.arguments, '@', folder_ + "/in" + work.ends);
        const std::size_t at = written.find('%');
        if (at != std::string::npos) {
            output_ = folder_ + "/made" + written.substr(at + 1, written.find(' ', at) - at - 1);
            output_.erase(output_.find_last_not_of(' ') + 1);
        }
        arguments_ = words(replaced(written, '%', folder_ + "/made"));
    }

    /// The exit status, 128 + the signal, or -1 after 20 seconds.
    int run(const std::string& fault) {
        if (!output_.empty()) std::ofstream(output_) << old;
        unlink((folder_ + "/count").c_str());
        const pid_t child = fork();
        if (child == 0) {
            setenv("LD_PRELOAD", library_.c_str(), 1);
            setenv("ALGAE_FAULT", fault.c_str(), 1);
            setenv("ALGAE_FAULT_COUNT", (folder_ + "/count").c_str(), 1);
            const int out = open((folder_ + "/out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
            const int err = open((folder_ + "/err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
            dup2(out, 1);
            dup2(err, 2);
            alarm(20);
            std::vector<char*> all{command_.data()};
            for (std::string& each : arguments_) all.push_back(each.data());
            all.push_back(nullptr);
            execv(command_.c_str(), all.data());
            _exit(127);
        }
        int status = 0;
        waitpid(child, &status, 0);
        if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) return -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

    std::string out() const { return text_of(folder_ + "/out"); }
    std::string err() const { return text_of(folder_ + "/err"); }
    std::string made() const { return output_.empty() ? "" : text_of(output_); }
    long count() const { return std::atol(text_of(folder_ + "/count").c_str()); }
    bool has_output() const { return !output_.empty(); }
    static constexpr const char* old = "what was there before";

    /// Whether a part of a file stays; they are removed.
    bool has_parts() {
        bool found = false;
        DIR* const folder = opendir(folder_.c_str());
        while (const dirent* const entry = readdir(folder))
            if (std::strstr(entry->d_name, ".part")) {
                found = true;
                unlink((folder_ + "/" + entry->d_name).c_str());
            }
        closedir(folder);
        return found;
    }

private:
    void clear() { has_parts(); }

    std::string command_, library_, folder_;
    Work work_;
    std::string output_;
    std::vector<std::string> arguments_;
};

struct Normal {
    int status = 0;
    std::string out, made;
};

/// What is wrong with the end of a run; empty if nothing is.
std::string flaw(Runner& runner, const Normal& normal, const std::string& kind, int status) {
    const bool has_parts = runner.has_parts();
    const std::string made = runner.made();
    const bool is_old = made == Runner::old, is_new = made == normal.made;
    if (status == -1) return "hangs";
    if (runner.has_output() && !is_old && !is_new) return "a damaged output";
    if (kind == "kill" && status == 128 + SIGKILL) return "";
    if (status > 128) return "signal " + std::to_string(status - 128);
    if (has_parts) return "a part of a file stays";
    if (status == normal.status) {
        if (runner.has_output() && !is_new) return "success without output";
        return runner.out() == normal.out ? "" : "success with another answer";
    }
    if (kind == "short") return "fails though a short write is no failure";
    const int due = kind == "memory" ? 3 : 2;
    if (status != due) return "status " + std::to_string(status);
    if (runner.err().find("algae: ") == std::string::npos) return "no message";
    return "";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fprintf(stderr, "inject ALGAE FAULTS.so FOLDER [EVERY]\n");
        return 2;
    }
    const std::string command = argv[1], library = argv[2], folder = argv[3];
    const long every = argc > 4 ? std::atol(argv[4]) : 1;
    long all = 0, wrong = 0, foreign = 0;
    for (const Work& work : works) {
        for (const std::string& kind : kinds) {
            Runner first(command, library, folder + "/0", work);
            Normal normal;
            normal.status = first.run(kind + ":0");
            normal.out = first.out();
            normal.made = first.made();
            const long count = first.count();
            // Two processes take turns.
            std::array<int, 2> ends{};
            std::array<FILE*, 2> reports{};
            for (int part = 0; part < 2; ++part) {
                int pipes[2];
                if (pipe(pipes) != 0) return 2;
                if (fork() == 0) {
                    close(pipes[0]);
                    FILE* const report = fdopen(pipes[1], "w");
                    Runner runner(command, library, folder + "/" + std::to_string(part + 1), work);
                    Normal own = normal;
                    own.status = runner.run(kind + ":0");
                    own.out = runner.out();  // with the names of this folder
                    own.made = runner.made();
                    for (long n = 1 + part * every; n <= count; n += 2 * every) {
                        const std::string found =
                            flaw(runner, own, kind, runner.run(kind + ":" + std::to_string(n)));
                        std::fprintf(report, "%ld\t%s\n", n, found.c_str());
                    }
                    std::fclose(report);
                    _exit(0);
                }
                close(pipes[1]);
                ends[static_cast<std::size_t>(part)] = pipes[0];
                reports[static_cast<std::size_t>(part)] = fdopen(pipes[0], "r");
            }
            long tried = 0;
            std::map<std::string, std::pair<long, long>> flaws;  // how many, and the first place
            for (FILE* const report : reports) {
                std::array<char, 512> line;
                while (std::fgets(line.data(), line.size(), report)) {
                    ++tried;
                    std::string text = line.data();
                    text.pop_back();
                    const std::size_t tab = text.find('\t');
                    if (tab + 1 == text.size()) continue;
                    auto& [number, place] = flaws[text.substr(tab + 1)];
                    if (number++ == 0) place = std::atol(text.c_str());
                }
                std::fclose(report);
            }
            while (wait(nullptr) > 0) continue;
            all += tried;
            std::string said;
            for (const auto& [what, found] : flaws) {
                const bool is_foreign =
                    work.draws && kind == "memory" && what.starts_with("signal");
                (is_foreign ? foreign : wrong) += found.first;
                said += "; " + std::to_string(found.first) + " " + what +
                        (is_foreign ? " (library)" : "") + ", first at " +
                        std::to_string(found.second);
            }
            std::printf("%-10s %-7s %6ld of %ld%s\n", work.name.c_str(), kind.c_str(), tried, count,
                        said.c_str());
            std::fflush(stdout);
        }
    }
    std::printf("\n%ld faults tried, %ld went wrong, %ld crashed in a library\n", all, wrong,
                foreign);
    return wrong == 0 ? 0 : 1;
}
