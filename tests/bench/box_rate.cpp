// How fast the cells that a curve touches are counted on 12 dyadic scales, the turtle included:
// prints nanoseconds a segment of processor time, best of ROUNDS, for the turtle alone and with
// counting, and the peak memory of the process.
//
//     box_rate ROUNDS N OFFSETS SYSTEM       (SYSTEM in the notation, its lines separated by ;)
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>

#include "dimension/dimension.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

namespace {

/// A canvas that only looks at what it is given.
class Glass : public algae::Canvas {
public:
    void move_to(algae::Point point) override { sum += point.x; }
    void line_to(algae::Point point) override { sum += point.x + point.y; }
    void polygon(std::span<const algae::Point>) override {}
    void width(double) override {}
    void width_as_length(double) override {}
    void colour(std::uint32_t) override {}
    void position(double) override {}
    double sum = 0;
};

template <class Work>
double best_seconds(int rounds, Work work) {
    double best = 1e300;
    for (int round = 0; round < rounds; ++round) {
        const std::clock_t begun = std::clock();
        work();
        best = std::min(best, static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
    }
    return best;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: box_rate ROUNDS N OFFSETS SYSTEM\n");
        return 2;
    }
    try {
        const int rounds = std::max(1, std::atoi(argv[1]));
        const algae::Budget budget;
        const auto system = algae::read_lsystem(argv[4], "the system");
        const auto figure =
            algae::figure(system, static_cast<std::uint64_t>(std::atoi(argv[2])), budget);
        const auto scales = algae::scales_of(figure->box(), 2, 12);
        const auto offsets = algae::even_offsets(static_cast<std::size_t>(std::atoi(argv[3])));
        Glass glass;
        const double turtle = best_seconds(rounds, [&] { figure->draw(glass, 0, budget); });
        algae::BoxCounts counts;
        const double counting = best_seconds(
            rounds, [&] { counts = algae::box_counts(*figure, scales, offsets, budget); });
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        const double segments = static_cast<double>(counts.parts) / 1e9;
        std::printf(
            "  %llu segments, %zu offsets: turtle %.1f ns, with counting %.1f ns a segment, peak "
            "%.1f MiB%s\n",
            static_cast<unsigned long long>(counts.parts), offsets.size(), turtle / segments,
            counting / segments, static_cast<double>(usage.ru_maxrss) / 1024,
            glass.sum == 0.123 ? " " : "");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
