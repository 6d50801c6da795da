#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "nature/detail/iterated_functions.hpp"
#include "rewrite/rewrite.hpp"
#include "watch/watch.hpp"

// Iterated function systems: the maps, what may be asked of them, and two of the ways to draw what
// they define.
//
// Finitely many contractions of the plane have exactly one nonempty compact set that is the union
// of its images, the attractor (Hutchinson 1981). With several states it is graph-directed (Mauldin
// and Williams 1988): only maps whose state can be reached again need to contract, since a path
// uses every other map once.
//
// - `copies` is the multiple reduction copy machine: generation n is the union of the images of a
//   polygon under all compositions of n maps. The number of copies grows exponentially and is
//   bounded.
// - `chaos_game` follows one point, to which a map picked at random is applied again and again; its
//   orbit becomes dense in the attractor. Maps are picked by comparing 64 random bits with the sums
//   of the chances, scaled to 2^64. The game is played once to find the box, and again whenever it
//   is drawn, from the same seed.
// - The attractor itself, to a given accuracy, is drawn by attractor.cpp.
//
// The chances of maps that the file does not give are in proportion to the areas they leave, so
// that points spread evenly; maps that flatten the plane get a hundredth of the largest.

namespace algae {

AffineMap composed(const AffineMap& outer, const AffineMap& inner) {
    const Point shift = outer({inner.e, inner.f});
    return {outer.a * inner.a + outer.b * inner.c,
            outer.a * inner.b + outer.b * inner.d,
            outer.c * inner.a + outer.d * inner.c,
            outer.c * inner.b + outer.d * inner.d,
            shift.x,
            shift.y};
}

// With the parts that keep and that reverse directions of the matrix, of sizes p and q, the
// singular values are p + q and |p - q|.
double norm(const AffineMap& map) {
    return (std::hypot(map.a + map.d, map.c - map.b) + std::hypot(map.a - map.d, map.c + map.b)) /
           2;
}

double least_stretch(const AffineMap& map) {
    return std::fabs(std::hypot(map.a + map.d, map.c - map.b) -
                     std::hypot(map.a - map.d, map.c + map.b)) /
           2;
}

double determinant(const AffineMap& map) { return map.a * map.d - map.b * map.c; }

Point fixed_point(const AffineMap& map) {
    const double p = 1 - map.a, q = 1 - map.d, det = p * q - map.b * map.c;
    return {(q * map.e + map.b * map.f) / det, (map.c * map.e + p * map.f) / det};
}

namespace {

/// "0.99", exactly where all of them are exact.
std::string sum_text(const std::vector<IteratedFunctions::Map>& maps, double sum) {
    Rational exact = 0;
    for (const auto& map : maps) {
        if (!map.probability->exact) return rounded_decimal(sum, 6);
        exact += *map.probability->exact;
    }
    return shortest_text(exact);
}

}  // namespace

std::vector<std::vector<bool>> reachable(const IteratedFunctions& system) {
    const std::size_t count = system.states.size();
    std::vector<std::vector<bool>> found(count, std::vector<bool>(count));
    for (const auto& map : system.maps) found[map.from][map.to] = true;
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t i = 0; i < count; ++i)
            if (found[i][k])
                for (std::size_t j = 0; j < count; ++j)
                    if (found[k][j]) found[i][j] = true;
    return found;
}

std::vector<bool> IteratedFunctions::recurrent_states() const {
    const auto led = reachable(*this);
    std::vector<bool> found(states.size());
    for (std::size_t i = 0; i < found.size(); ++i) found[i] = led[i][i];
    return found;
}

void IteratedFunctions::check() const {
    require(!maps.empty(), "{}: has no maps; expected lines such as `map 0.5 0 0 0.5 0 0`", {name});
    const std::vector<bool> recurrent = recurrent_states();
    std::vector<bool> mapped(states.size());
    for (const Map& map : maps) {
        mapped[map.from] = true;
        const double stretch = norm(map.map);
        require(!recurrent[map.from] || stretch < 1,
                "{}: {} does not contract: its norm is {:.6g}, expected less than 1",
                {name, map.name, stretch});
    }
    for (std::size_t i = 0; i < states.size(); ++i)
        require(mapped[i], "{}: the state {} has no map", {name, states[i]});
    const bool said = std::any_of(maps.begin(), maps.end(),
                                  [](const Map& map) { return map.probability.has_value(); });
    if (!said) return;
    double sum = 0;
    for (const Map& map : maps) {
        require(map.probability.has_value(), "{}: {} has no probability, others do",
                {name, map.name});
        require(map.probability->value > 0,
                "{}: the probability of {} is {:.6g}, expected more than 0",
                {name, map.name, map.probability->value});
        sum += map.probability->value;
    }
    require(!(std::fabs(sum - 1) > 1e-12), "{}: the probabilities add up to {}, expected 1",
            {name, sum_text(maps, sum)});
}

double IteratedFunctions::contraction() const {
    const std::vector<bool> recurrent = recurrent_states();
    double largest = 0;
    for (const Map& map : maps)
        if (recurrent[map.from]) largest = std::max(largest, norm(map.map));
    return largest;
}

std::vector<double> IteratedFunctions::chances() const {
    std::vector<double> found;
    if (maps.front().probability) {
        for (const Map& map : maps) found.push_back(map.probability->value);
        return found;
    }
    double largest = 0, sum = 0;
    for (const Map& map : maps) largest = std::max(largest, std::fabs(determinant(map.map)));
    for (const Map& map : maps) {
        found.push_back(largest > 0 ? std::max(std::fabs(determinant(map.map)), largest / 100)
                                    : 1.0);
        sum += found.back();
    }
    for (double& chance : found) chance /= sum;
    return found;
}

std::vector<GeneratorFigure> IteratedFunctions::figures(const Budget& budget) const {
    const std::string what = heading();
    std::vector<GeneratorFigure> found;
    if (generations) {
        for (std::uint64_t n = generations->first; n <= generations->second; ++n)
            found.push_back({copies(*this, n, budget), what + ", generation " + std::to_string(n),
                             "n = " + std::to_string(n)});
    } else if (points) {
        const std::string count = std::to_string(*points) + " points";
        found.push_back(
            {chaos_game(*this, *points, budget), what + ", " + count, what + ", " + count});
    } else {
        found.push_back({attractor_figure(*this), what + ", the attractor", what});
    }
    return found;
}

GeneratorFigure IteratedFunctions::measured_figure(const Budget& budget) const {
    if (points || generations) return Generator::measured_figure(budget);
    return {attractor_figure(*this), heading() + ", the attractor", ""};
}

std::optional<ExactDimension> IteratedFunctions::exact_dimension(const Budget& budget) const {
    if (auto carpet = carpet_dimension(*this)) return carpet;
    ExactDimension found = similarity_dimension(*this, budget);
    if (found.status != ExactDimension::Status::exact || found.value->rational() != Rational(2))
        return found;
    try {
        if (auto boundary = boundary_dimension(lattice_set(*this, budget), budget))
            found.boundary = std::move(*boundary);
    } catch (const BoundReached& bound) {
        if (bound.bound() == Bound::time) throw;
        found.conditions.push_back(std::string("the boundary is not known: ") + bound.what());
    } catch (const Error& reason) {
        found.conditions.push_back(std::string("the boundary is not known: ") + reason.what());
    }
    return found;
}

std::optional<std::vector<double>> IteratedFunctions::exact_spectrum(std::span<const double> orders,
                                                                     const Budget& budget) const {
    if (states.size() != 1 || maps.empty() || !maps.front().probability) return std::nullopt;
    std::vector<double> ratios;
    for (const Map& map : maps) {
        const auto ratio = exact_ratio(map);
        if (!ratio) return std::nullopt;
        const Ball value = enclosure(*ratio, 64);
        if (sign(value) != 1) return std::nullopt;
        ratios.push_back(value.midpoint());
    }
    if (separation(*this, {0}, budget) != Separation::apart) return std::nullopt;
    const std::vector<double> chance = chances();
    std::vector<double> found;
    for (const double q : orders) {
        if (q == 1) {
            double entropy = 0, shrinking = 0;
            for (std::size_t m = 0; m < maps.size(); ++m) {
                entropy -= chance[m] * std::log(chance[m]);
                shrinking -= chance[m] * std::log(ratios[m]);
            }
            found.push_back(entropy / shrinking);
            continue;
        }
        // The sum falls as the exponent of the ratios rises; by logarithms, as powers of chances may be huge.
        const auto logarithm = [&](double exponent) {
            double largest = -HUGE_VAL, sum = 0;
            std::vector<double> terms;
            for (std::size_t m = 0; m < maps.size(); ++m) {
                terms.push_back(q * std::log(chance[m]) + exponent * std::log(ratios[m]));
                largest = std::max(largest, terms.back());
            }
            for (const double term : terms) sum += std::exp(term - largest);
            return largest + std::log(sum);
        };
        double low = -1, high = 1;
        while (logarithm(low) < 0) low *= 2;
        while (logarithm(high) > 0) high *= 2;
        for (int round = 0; round < 100; ++round) {
            const double middle = (low + high) / 2;
            (logarithm(middle) > 0 ? low : high) = middle;
        }
        found.push_back(low / (1 - q));
    }
    return found;
}

std::vector<GeneratorFact> IteratedFunctions::facts(const Budget& budget) const {
    std::vector<GeneratorFact> found;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    std::string text = std::to_string(maps.size());
    const std::vector<double> chance = chances();
    for (std::size_t m = 0; m < maps.size(); ++m) {
        const Point fixed = fixed_point(maps[m].map);
        const bool own = maps[m].from == maps[m].to && norm(maps[m].map) < 1;
        nlohmann::ordered_json one{{"norm", norm(maps[m].map)}};
        text += "\n  " + maps[m].name + ": norm " + rounded_decimal(norm(maps[m].map), 6);
        if (own) {
            one["fixed_point"] = {fixed.x, fixed.y};
            text += ", fixed point (" + rounded_decimal(fixed.x, 6) + ", " +
                    rounded_decimal(fixed.y, 6) + ")";
        }
        if (states.size() == 1) {
            one["probability"] = chance[m];
            text += ", probability " + rounded_decimal(chance[m], 6);
        } else {
            one["from"] = states[maps[m].from];
            one["to"] = states[maps[m].to];
        }
        all.push_back(std::move(one));
    }
    found.push_back({"maps", text, all});
    const double s = contraction();
    found.push_back({"contraction", rounded_decimal(s, 6), s});
    Box box = attractor_boxes(*this).front();
    const double rounding = 1e-9 * std::max(box.breadth(), box.height());
    for (double* const side : {&box.low.x, &box.low.y, &box.high.x, &box.high.y})
        if (std::fabs(*side) < rounding) *side = 0;
    found.push_back({"bounding_box",
                     "[" + rounded_decimal(box.low.x, 6) + ", " + rounded_decimal(box.high.x, 6) +
                         "] x [" + rounded_decimal(box.low.y, 6) + ", " +
                         rounded_decimal(box.high.y, 6) + "]",
                     {{"min", {box.low.x, box.low.y}}, {"max", {box.high.x, box.high.y}}}});
    const ExactDimension dimension = similarity_dimension(*this, budget);
    if (dimension.value)
        found.push_back(
            {"similarity_dimension",
             dimension.value->text() +
                 (dimension.value->rational() ? "" : " = " + dimension.value->decimal(6)) +
                 ", an upper bound unless the open set condition holds",
             {{"formula", dimension.value->text()},
              {"value", dimension.value->enclosure(64).midpoint()}}});
    else
        found.push_back({"similarity_dimension", "none: " + dimension.conditions.front(), nullptr});
    return found;
}

namespace {

constexpr std::size_t most_copies = 1'000'000;
constexpr double flat = 1e-12;  // the share of its squared length that a flat polygon's area has

/// The polygon that a map makes of `corners`, or a line where it is flat.
Path image(const AffineMap& map, const std::vector<Point>& corners, std::uint32_t colour) {
    Path path;
    path.colour = colour;
    double area = 0, around = 0;
    for (const Point& corner : corners) path.points.push_back(map(corner));
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const Point a = path.points[i], b = path.points[(i + 1) % path.points.size()];
        area += a.x * b.y - a.y * b.x;
        around += distance(a, b);
    }
    path.filled = std::fabs(area) > flat * around * around;
    if (!path.filled) path.points.push_back(path.points.front());
    return path;
}

}  // namespace

std::unique_ptr<PathFigure> copies(const IteratedFunctions& system, std::uint64_t generation,
                                   const Budget& budget) {
    struct Copy {
        AffineMap map;
        std::size_t state;
        std::uint32_t colour;
    };
    std::vector<Copy> made{{{}, 0, 0}};
    WorkCount rounds("iteration", generation);
    for (std::uint64_t round = 0; round < generation; ++round) {
        rounds.at(round + 1);
        std::vector<Copy> next;
        for (const Copy& copy : made) {
            if ((next.size() & 0xfff) == 0) budget.check();
            for (std::size_t m = 0; m < system.maps.size(); ++m) {
                if (system.maps[m].from != copy.state) continue;
                next.push_back({composed(copy.map, system.maps[m].map), system.maps[m].to,
                                round == 0 ? static_cast<std::uint32_t>(m) : copy.colour});
            }
        }
        if (next.size() > most_copies)
            throw BoundReached(
                Bound::method,
                fmt::format(
                    "{}, generation {}: has {} copies, of which at most 1000000 can be drawn; "
                    "its attractor, without `generation`, has no such bound",
                    system.name, round + 1, next.size()));
        made = std::move(next);
    }
    std::vector<Path> paths;
    for (const Copy& copy : made) paths.push_back(image(copy.map, system.start, copy.colour));
    return std::make_unique<PathFigure>(std::move(paths), system.style);
}

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
        WorkCount points("point", count);
        for (std::uint64_t t = 0; t < count;) {
            budget.check();
            points.at(t);
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
    require(
        system.states.size() == 1,
        "{}: has {} states, and the chaos game is for one; its attractor is drawn without points",
        {system.name, std::uint64_t{system.states.size()}});
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
        count, box, system.style);
}

}  // namespace algae
