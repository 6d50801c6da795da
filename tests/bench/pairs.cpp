// Times commands against each other: the two of a pair take turns, so that what else the machine
// does falls on both. Prints each one's fastest and middle time, its peak memory, and the ratio of
// the middles.
//
//     pairs ROUNDS LABEL COMMAND LABEL COMMAND [UNITS UNIT]
//     pairs ROUNDS LABEL COMMAND
//
// Commands run in sh; UNITS is how much the first one makes, for a rate.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

struct Contender {
    std::string label, command;
    std::vector<double> seconds;
    long kibibytes = 0;

    void run() {
        const auto start = std::chrono::steady_clock::now();
        const pid_t child = fork();
        if (child == 0) {
            execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
            _exit(127);
        }
        int status = 0;
        rusage usage{};
        wait4(child, &status, 0, &usage);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
            std::fprintf(stderr, "failed: %s\n", command.c_str());
            std::exit(1);
        }
        seconds.push_back(taken.count());
        kibibytes = std::max(kibibytes, usage.ru_maxrss);
    }
    double middle() {
        std::sort(seconds.begin(), seconds.end());
        return seconds[seconds.size() / 2];
    }
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4 && argc != 6 && argc != 8) {
        std::fprintf(stderr, "usage: pairs ROUNDS LABEL COMMAND [LABEL COMMAND [UNITS UNIT]]\n");
        return 2;
    }
    const int rounds = std::max(1, std::atoi(argv[1]));
    std::vector<Contender> contenders;
    for (int i = 2; i + 1 < std::min(argc, 6); i += 2)
        contenders.push_back({argv[i], argv[i + 1], {}});
    for (Contender& one : contenders) {  // to warm up
        one.run();
        one.seconds.clear();
    }
    for (int i = 0; i < rounds; ++i)
        for (Contender& one : contenders) one.run();
    for (Contender& one : contenders) {
        const double middle = one.middle();
        std::printf("  %-34s min %.3f s  median %.3f s  peak %6.1f MiB", one.label.c_str(),
                    one.seconds.front(), middle, static_cast<double>(one.kibibytes) / 1024);
        if (argc == 8) std::printf("  %.3g %s/s", std::atof(argv[6]) / middle, argv[7]);
        std::printf("\n");
    }
    if (contenders.size() == 2)
        std::printf("  speed of the first relative to the second: %.2f\n",
                    contenders[1].middle() / contenders[0].middle());
}
