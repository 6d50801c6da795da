// Runs ten verbs again and again, each time with one fault of the machine (see faults.c), and looks at what is left: the exit status, the
// output of before, parts of files. Prints a line for each verb and kind of fault, what went wrong, and a line for each kind; ends with 1
// if anything went wrong.
//
//   inject ALGAE FAULTS.so FOLDER [EVERY[@FROM] [VERB...]]   EVERY 7: each seventh allocation only, from the one of number FROM on
//   inject --self-test
//
// Crashes inside of Cairo, Pango, fontconfig and Graphviz, which do not look whether there is memory, are told apart: they are listed with
// the library's name, and fail nothing. The frame that crashed decides, with those of the C and C++ libraries passed over, as a null
// pointer is given to strlen, and abort is called: a crash of our own code is ours, also where a library called it and where the
// allocation that failed was the library's. Where one of these libraries goes on without the memory, and a picture has another font, or
// goes round for ever, the frame that allocated decides in the same way.

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

/// A verb: its arguments, where @ is a file with the text and % the file that it writes, if it writes one.
struct Work {
    std::string name, arguments, text, ends;
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
    {"draw", "draw koch -n 2 -o %.svg", "", ".svg"},
    {"tree", "tree @ -n 2 -o %.svg", "axiom a\na -> ab\nb -> a\n", ".lsys"},
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
        prepare();
        const pid_t child = fork();
        if (child == 0) {
            alarm(20);
            become(fault);
        }
        int status = 0;
        waitpid(child, &status, 0);
        return ended(status);
    }

    /// Lets allocations fail whose numbers are first, first + step ..., in forks of one process, which are ten times as fast as
    /// processes of their own, and calls judge(number, exit status) after each. Returns the least of these numbers that was not tried, as
    /// the process was to write by then.
    template <class Judge>
    long fork_at_each(long first, long step, const Judge& judge) {
        int said[2], told[2];
        if (pipe(said) != 0 || pipe(told) != 0) return first;
        prepare();
        const pid_t child = fork();
        if (child == 0) {
            dup2(said[1], 198);
            dup2(told[0], 199);
            for (const int end : {said[0], said[1], told[0], told[1]}) close(end);
            become("memory:each:" + std::to_string(first) + ":" + std::to_string(step));
        }
        close(said[1]);
        close(told[0]);
        FILE* const lines = fdopen(said[0], "r");
        std::array<char, 100> line;
        long next = first, number = 0;
        int status = 0;
        while (std::fgets(line.data(), line.size(), lines) &&
               std::sscanf(line.data(), "%ld %d", &number, &status) == 2) {
            judge(number, ended(status));
            next = number + step;
            prepare();
            if (write(told[1], "g", 1) != 1) break;
        }
        std::fclose(lines);
        close(told[1]);
        waitpid(child, &status, 0);
        return next;
    }

    std::string out() const { return text_of(folder_ + "/out"); }
    std::string err() const { return text_of(folder_ + "/err"); }
    std::string crash() const { return text_of(folder_ + "/crash"); }
    std::string failed() const { return text_of(folder_ + "/failed"); }
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

    void prepare() {
        if (!output_.empty()) std::ofstream(output_) << old;
        for (const char* const name : {"count", "crash", "failed"})
            unlink((folder_ + "/" + name).c_str());
    }

    [[noreturn]] void become(const std::string& fault) {
        setenv("LD_PRELOAD", library_.c_str(), 1);
        setenv("ALGAE_FAULT", fault.c_str(), 1);
        for (const auto& [name, file] : {std::pair{"COUNT", "count"},
                                         {"CRASH", "crash"},
                                         {"FAILED", "failed"},
                                         {"OUT", "out"},
                                         {"ERR", "err"}})
            setenv((std::string("ALGAE_FAULT_") + name).c_str(), (folder_ + "/" + file).c_str(), 1);
        const int out = open((folder_ + "/out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        const int err = open((folder_ + "/err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        dup2(out, 1);
        dup2(err, 2);
        std::vector<char*> all{command_.data()};
        for (std::string& each : arguments_) all.push_back(each.data());
        all.push_back(nullptr);
        execv(command_.c_str(), all.data());
        _exit(127);
    }

    /// What `run` gives for a status of wait.
    static int ended(int status) {
        if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) return -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

    std::string command_, library_, folder_;
    Work work_;
    std::string output_;
    std::vector<std::string> arguments_;
};

/// Where frames say that something happened: the program or library of the first one outside of the C and C++ libraries.
std::string place_of(const std::string& frames) {
    std::istringstream lines(frames);
    for (std::string line; std::getline(lines, line);) {
        const std::string name = line.substr(0, line.find(' '));
        bool is_passed = false;
        for (const char* const passed : {"libc.so", "libm.so", "ld-linux", "libstdc++", "libgcc_s",
                                         "libpthread", "faults.so", "linux-vdso"})
            is_passed = is_passed || name.starts_with(passed);
        if (!is_passed) return name;
    }
    return "an unknown place";
}

/// Whether a library is one of those that crash where memory ends, and that algae cannot change. GMP and FLINT are not among them: their
/// allocations are algae's.
bool is_foreign(const std::string& library) {
    for (const char* const known :
         {"libcairo",    "libpango",   "libfontconfig", "libfreetype", "libpixman",   "libpng",
          "libharfbuzz", "libfribidi", "libthai",       "libdatrie",   "libglib",     "libgobject",
          "libgio",      "libgvc",     "libcgraph",     "libcdt",      "libpathplan", "libxdot",
          "libgvplugin", "libexpat",   "libltdl"})
        if (library.starts_with(known)) return true;
    return false;
}

/// What a crash in these frames is called, and whether it is a library's.
int self_test() {
    struct Case {
        const char *frames, *place;
        bool foreign;
    };
    const Case cases[] = {
        {"libcairo.so.2 cairo_set_font\nalgae \nlibc.so.6 __libc_start_main\n", "libcairo.so.2",
         true},
        {"libc.so.6 strlen\nlibcgraph.so.6 agstrdup\nalgae \n", "libcgraph.so.6", true},
        {"libc.so.6 raise\nlibc.so.6 abort\nlibglib-2.0.so.0 g_malloc\nlibpango-1.0.so.0 x\nalgae "
         "\n",
         "libglib-2.0.so.0", true},
        // A library called our code, or allocated in vain and told us: what crashed is ours.
        {"algae \nlibcairo.so.2 write\nalgae \n", "algae", false},
        {"libc.so.6 raise\nlibc.so.6 abort\nlibstdc++.so.6 std::terminate\nalgae \nlibcairo.so.2 "
         "x\n",
         "algae", false},
        {"libc.so.6 memcpy\nalgae \nlibgvc.so.6 gvLayout\n", "algae", false},
        {"libc.so.6 abort\nlibgmp.so.10 __gmp_default_allocate\nalgae \n", "libgmp.so.10", false},
        {"", "an unknown place", false},
    };
    int wrong = 0;
    for (const Case& each : cases) {
        const std::string place = place_of(each.frames);
        if (place == each.place && is_foreign(place) == each.foreign) continue;
        ++wrong;
        std::printf("expected %s, found %s for\n%s\n", each.place, place.c_str(), each.frames);
    }
    std::printf("%d of %zu crashes are placed wrongly\n", wrong, std::size(cases));
    return wrong == 0 ? 0 : 1;
}

struct Normal {
    int status = 0;
    std::string out, made;
};

/// What is wrong with the end of a run; empty if nothing is.
std::string flaw(Runner& runner, const Normal& normal, const std::string& kind, int status) {
    const bool has_parts = runner.has_parts();
    const std::string made = runner.made();
    const bool is_old = made == Runner::old, is_new = made == normal.made;
    if (status == -1) return "hangs in " + place_of(runner.failed());
    if (runner.has_output() && !is_old && !is_new)
        return status == normal.status
                   ? "success with another output, in " + place_of(runner.failed())
                   : "a damaged output";
    if (kind == "kill" && status == 128 + SIGKILL) return "";
    if (status > 128)
        return "signal " + std::to_string(status - 128) + " in " + place_of(runner.crash());
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
    if (argc == 2 && std::string(argv[1]) == "--self-test") return self_test();
    if (argc < 4) {
        std::fprintf(stderr, "inject ALGAE FAULTS.so FOLDER [EVERY[@FROM] [VERB...]]\n");
        return 2;
    }
    const std::string command = argv[1], library = argv[2], folder = argv[3];
    const long every = argc > 4 ? std::atol(argv[4]) : 1;
    const char* const at = argc > 4 ? std::strchr(argv[4], '@') : nullptr;
    const long from = at ? std::atol(at + 1) : 1;
    if (every < 1 || from < 1) {
        std::fprintf(stderr, "inject: expected a number from 1 on, found '%s'\n", argv[4]);
        return 2;
    }
    const std::vector<std::string> chosen(argv + std::min(argc, 5), argv + argc);
    for (const std::string& name : chosen)
        if (std::ranges::find(works, name, &Work::name) == works.end()) {
            std::fprintf(stderr, "inject: no verb '%s'\n", name.c_str());
            return 2;
        }
    struct Counts {
        long tried = 0, wrong = 0, foreign = 0;
    };
    std::map<std::string, Counts> counts;  // by kind
    for (const Work& work : works) {
        if (!chosen.empty() && std::ranges::find(chosen, work.name) == chosen.end()) continue;
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
                    const bool many = kind == "memory";
                    const long step = many ? every : 1;
                    const auto judge = [&](long n, int status) {
                        std::fprintf(report, "%ld\t%s\n", n,
                                     flaw(runner, own, kind, status).c_str());
                    };
                    long n = (many ? from : 1) + part * step;
                    if (many) n = runner.fork_at_each(n, 2 * step, judge);
                    for (; n <= count; n += 2 * step)
                        judge(n, runner.run(kind + ":" + std::to_string(n)));
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
            Counts& of_kind = counts[kind];
            of_kind.tried += tried;
            std::string said;
            for (const auto& [what, found] : flaws) {
                const std::size_t in = what.find(" in ");
                const bool foreign = in != std::string::npos && is_foreign(what.substr(in + 4));
                (foreign ? of_kind.foreign : of_kind.wrong) += found.first;
                said += "; " + std::to_string(found.first) + " " + what +
                        (foreign ? " (not ours)" : "") + ", first at " +
                        std::to_string(found.second);
            }
            std::printf("%-10s %-7s %6ld of %ld%s\n", work.name.c_str(), kind.c_str(), tried, count,
                        said.c_str());
            std::fflush(stdout);
        }
    }
    const auto print = [](const char* name, const Counts& of) {
        std::printf("%-18s %7ld tried, %ld went wrong, %ld crashed in a library\n", name, of.tried,
                    of.wrong, of.foreign);
    };
    std::printf("\n");
    const std::map<std::string, const char*> names{{"memory", "failed allocations"},
                                                   {"full", "full disks"},
                                                   {"broken", "broken disks"},
                                                   {"short", "short writes"},
                                                   {"kill", "kills"}};
    Counts all;
    for (const std::string& kind : kinds) {
        const Counts& of = counts[kind];
        print(names.at(kind), of);
        all.tried += of.tried;
        all.wrong += of.wrong;
        all.foreign += of.foreign;
    }
    print("all", all);
    return all.wrong == 0 ? 0 : 1;
}
