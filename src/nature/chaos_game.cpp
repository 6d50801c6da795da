#include "nature/chaos_game.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "rewrite/draws.hpp"

namespace algae {

namespace {

constexpr std::size_t at_a_time = 1 << 14;

/// The maps, and the largest numbers drawn for which each is taken.
struct Game {
    std::vector<AffineMap> maps;
    std::vector<std::uint64_t> last;  // of each map but the last one
    std::uint64_t seed = 1;
    std::uint64_t count = 0;
    Point begin;

    std::size_t picked(std::uint64_t number) const {
        std::size_t map = 0;
        for (const std::uint64_t bound : last) map += number > bound;
        return map;
    }

    void play(const TakeDots& take, const Budget& budget) const {
        const Draws draws(seed, 0);
        std::vector<Dot> dots(std::min<std::uint64_t>(count, at_a_time));
        Point here = begin;
        for (std::uint64_t t = 0; t < count;) {
            budget.check();
            const auto some = std::min<std::uint64_t>(count - t, at_a_time);
            //> game
            for (std::size_t i = 0; i < some; ++i, ++t) {
                const std::size_t map = picked(draws.at(t));
                here = maps[map](here);
                dots[i] = {here, static_cast<std::uint32_t>(map)};
            }
            //< game
            take(std::span(dots).first(some));
        }
    }
};

}  // namespace

std::unique_ptr<PointFigure> chaos_game(const IteratedFunctions& system, std::uint64_t count,
                                        const Budget& budget) {
    if (system.states.size() > 1)
        throw Error(
            system.name + ": has " + std::to_string(system.states.size()) +
            " states, and the chaos game is for one; its attractor is drawn without points");
    Game game;
    game.count = count;
    game.seed = system.seed;
    game.begin = system.from.value_or(fixed_point(system.maps.front().map));
    double sum = 0;
    for (const double chance : system.chances()) {
        sum += chance;
        const double share = std::ldexp(sum, 64);
        game.last.push_back(share >= 0x1p64 ? std::numeric_limits<std::uint64_t>::max()
                                            : static_cast<std::uint64_t>(share));
    }
    game.last.pop_back();
    for (const auto& map : system.maps) game.maps.push_back(map.map);
    Box box;
    game.play(
        [&](std::span<const Dot> dots) {
            for (const Dot& dot : dots) box.add(dot.place);
        },
        budget);
    return std::make_unique<PointFigure>(
        [game = std::move(game)](const TakeDots& take, const Budget& within) {
            game.play(take, within);
        },
        count, box, system.settings);
}

}  // namespace algae
