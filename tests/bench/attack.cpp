// Decisions about random systems against what is worked out by other means (tools/attack): attack CASES FIRST_SEED FILE. Prints the table by
// family and kind; defects go to standard error, and what was not decided though it is known to FILE.

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <fstream>

#include "language/attack.hpp"

int main(int argc, char** argv) {
    using namespace algae::attack;
    constexpr std::uint64_t every = 20;  // of which certificates are verified
    const std::uint64_t cases = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000;
    const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    std::ofstream undecided;
    if (argc > 3) undecided.open(argv[3]);
    Counts counts;
    std::size_t reported = 0, written = 0;
    for (std::uint64_t i = 0; i < cases; ++i) {
        run_case(first + i, every, counts);
        for (; reported < counts.defects.size(); ++reported)
            fmt::print(stderr, "DEFECT: {}\n", counts.defects[reported]);
        for (; written < counts.undecided.size(); ++written)
            undecided << counts.undecided[written] << '\n';
    }
    const auto table = [](const std::string& title, const auto& rows, const Count& all) {
        fmt::print(
            "| {} | asked | decided | known | comparable | % | agreeing |\n"
            "|---|---:|---:|---:|---:|---:|---:|\n",
            title);
        const auto row = [](const std::string& name, const Count& count) {
            fmt::print("| {} | {} | {} | {} | {} | {:.1f} | {} |\n", name, count.asked,
                       count.decided, count.known, count.comparable,
                       100.0 * static_cast<double>(count.comparable) /
                           static_cast<double>(std::max<std::uint64_t>(1, count.asked)),
                       count.agreeing);
        };
        for (const auto& [name, count] : rows) row(name, count);
        row("all", all);
        fmt::print("\n");
    };
    table("family", counts.by_family, counts.all);
    table("kind", counts.by_kind, counts.all);
    fmt::print(
        "{} certificates verified, {} of them checked; {} cases out of time; {} defects; {} s\n",
        counts.verified, counts.checked, counts.out_of_time, counts.defects.size(),
        std::clock() / CLOCKS_PER_SEC);
    return counts.defects.empty() ? 0 : 1;
}
