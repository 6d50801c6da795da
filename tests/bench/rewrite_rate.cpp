// How fast the engine of rewrite/ derives: reads a system, derives generation N in each round and
// prints the fastest and the middle rate, in modules of the last word a second, and the fastest by
// processor time. The word is not turned into text.
//
//     rewrite_rate ROUNDS THREADS N FILE
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <sstream>
#include <vector>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: rewrite_rate ROUNDS THREADS N FILE\n");
        return 2;
    }
    try {
        std::ifstream in(argv[4]);
        std::ostringstream text;
        text << in.rdbuf();
        algae::RewritingChoices choices;
        choices.threads = static_cast<unsigned>(std::atoi(argv[2]));
        const algae::Rewriting rewriting(algae::read_lsystem(text.str(), argv[4]), choices);
        std::vector<double> seconds, processor;
        std::size_t modules = 0;
        for (int round = std::atoi(argv[1]); round >= 0; --round) {  // the first one to warm up
            const std::clock_t begun = std::clock();
            const auto start = std::chrono::steady_clock::now();
            modules = algae::derive(rewriting, static_cast<std::uint64_t>(std::atoi(argv[3])))
                          .kinds.size();
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
            seconds.push_back(taken.count());
            processor.push_back(static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
        }
        seconds.erase(seconds.begin());
        std::sort(seconds.begin(), seconds.end());
        const double million = static_cast<double>(modules) / 1e6;
        std::printf(
            "  %zu modules: best %.1f, median %.1f million a second; by processor time %.1f\n",
            modules, million / seconds.front(), million / seconds[seconds.size() / 2],
            million / *std::min_element(processor.begin(), processor.end()));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
