#include "oracle/lattice_parts.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>
#include <tuple>

namespace algae::oracle {

std::string LatticeSystem::text() const {
    std::string text = "axiom F";
    for (const auto& [letter, successor] : successors)
        text += std::string("; ") + letter + " -> " + successor;
    return text + "; angle " + (hexagonal ? "60" : "90");
}

std::ostream& operator<<(std::ostream& out, const LatticeSystem& system) {
    return out << system.text();
}

std::string LatticeParts::companions(char letter) const {
    const auto reached = [&](char from) {
        std::string found;
        std::string open(1, from);
        while (!open.empty()) {
            const char a = open.back();
            open.pop_back();
            for (const char b : system_.successors.at(a))
                if (system_.successors.contains(b) && found.find(b) == std::string::npos) {
                    found += b;
                    open += b;
                }
        }
        return found;
    };
    std::string found;
    for (const char other : reached(letter))
        if (reached(other).find(letter) != std::string::npos) found += other;
    return found;
}

int LatticeParts::turn(char letter, unsigned generation) const {
    if (letter == '+') return 1;
    if (letter == '-') return system_.order() - 1;
    std::map<char, int> turns{{'F', 0}, {'G', 0}, {'f', 0}};
    for (unsigned n = 0; n < generation; ++n) {
        std::map<char, int> next;
        for (const auto& [a, successor] : system_.successors) {
            int sum = 0, depth = 0;
            for (const char b : successor) {
                if (b == '[') ++depth;
                if (b == ']') --depth;
                if (depth > 0 || b == ']') continue;
                sum += b == '+' ? 1 : b == '-' ? -1 : turns.at(b);
            }
            next[a] = ((sum % system_.order()) + system_.order()) % system_.order();
        }
        turns = next;
    }
    return turns.at(letter);
}

Place LatticeParts::product(Place left, Place right) const {
    const auto [a, b] = left;
    const auto [c, d] = right;
    // zeta^2 is -1, or zeta - 1.
    return {a * c - b * d, a * d + b * c + (system_.hexagonal ? b * d : 0)};
}

Place LatticeParts::unit(int heading) const {
    Place place{1, 0};
    for (int k = 0; k < heading; ++k) place = product(place, {0, 1});
    return place;
}

Place LatticeParts::way(unsigned generation) const {
    // Where the path without its branches ends.
    Place end{0, 0};
    int heading = 0, depth = 0;
    for (const char b : system_.successors.at('F')) {
        if (b == '[') ++depth;
        if (b == ']') --depth;
        if (depth > 0 || b == ']') continue;
        if (b != '+' && b != '-') {
            const Place step = unit(heading);
            end = {end.first + step.first, end.second + step.second};
        }
        heading = (heading + turn(b, generation - 1)) % system_.order();
    }
    return end;
}

std::vector<LatticePart> LatticeParts::parts(char letter, unsigned n, unsigned below,
                                             const std::string& counted) const {
    std::string word(1, letter);
    for (unsigned k = 0; k < n; ++k) {
        std::string next;
        for (const char a : word) {
            const auto successor = system_.successors.find(a);
            next += successor == system_.successors.end() ? std::string(1, a) : successor->second;
        }
        word = std::move(next);
    }
    std::map<char, int> turns;
    for (const char a : std::string("FGf+-")) turns[a] = turn(a, below);
    std::vector<Place> units;
    for (int heading = 0; heading < system_.order(); ++heading) units.push_back(unit(heading));
    std::vector<LatticePart> found;
    std::vector<std::pair<Place, int>> saved;
    Place here{0, 0};
    int heading = 0;
    for (const char a : word) {
        if (a == '[') {
            saved.emplace_back(here, heading);
        } else if (a == ']') {
            std::tie(here, heading) = saved.back();
            saved.pop_back();
        } else {
            if (counted.find(a) != std::string::npos) found.push_back({a, heading, here});
            if (a != '+' && a != '-') {
                const Place& step = units[static_cast<std::size_t>(heading)];
                here = {here.first + step.first, here.second + step.second};
            }
            heading = (heading + turns.at(a)) % system_.order();
        }
    }
    return found;
}

bool LatticeParts::come_near(const LatticePart& first, const LatticePart& second,
                             unsigned generation, unsigned levels,
                             const std::string& counted) const {
    const auto size = [&](Place place) {
        const auto x = static_cast<double>(place.first), y = static_cast<double>(place.second);
        return std::sqrt(x * x + y * y + (system_.hexagonal ? x * y : 0));
    };
    // No part of a generation is farther from its beginning than this, in ways of the generation.
    std::vector<double> reach{0};
    std::vector<Place> ways{{1, 0}};
    for (unsigned n = 1; n <= generation; ++n) {
        double farthest = 0;
        for (const char a : counted)
            for (const LatticePart& part : parts(a, 1, n - 1, counted))
                farthest = std::max(farthest, size(part.at));
        ways.push_back(way(n));
        reach.push_back((farthest + reach.back()) / size(ways.back()));
    }
    struct Pair {
        LatticePart first, second;
        bool operator<(const Pair& other) const {
            return std::tie(first, second) < std::tie(other.first, other.second);
        }
    };
    const auto seen = [&](LatticePart a, LatticePart b) {
        // Only the difference counts.
        b.at = {b.at.first - a.at.first, b.at.second - a.at.second};
        a.at = {0, 0};
        return Pair{a, b};
    };
    std::vector<Place> units;
    for (int heading = 0; heading < system_.order(); ++heading) units.push_back(unit(heading));
    std::vector<std::map<char, std::vector<LatticePart>>> parts_of(levels);
    for (unsigned level = 0; level < levels; ++level)
        for (const char a : counted)
            parts_of[level][a] = parts(a, 1, generation - level - 1, counted);
    // Depth first, as pairs that meet have long paths.
    std::vector<std::pair<Pair, unsigned>> open{{seen(first, second), 0}};
    std::set<std::pair<Pair, unsigned>> known;
    while (!open.empty()) {
        const auto [pair, level] = open.back();
        open.pop_back();
        if (level == levels) return true;
        const unsigned below = generation - level - 1;
        const auto within = [&](const LatticePart& whole, const LatticePart& part) {
            const Place start = product(ways[below + 1], whole.at),
                        offset = product(units[static_cast<std::size_t>(whole.heading)], part.at);
            return LatticePart{part.letter,
                               (whole.heading + part.heading) % system_.order(),
                               {start.first + offset.first, start.second + offset.second}};
        };
        for (const LatticePart& x : parts_of[level][pair.first.letter])
            for (const LatticePart& y : parts_of[level][pair.second.letter]) {
                const Pair next = seen(within(pair.first, x), within(pair.second, y));
                if (size(next.second.at) <= 2 * reach[below] + 1e-6 &&
                    known.emplace(next, level + 1).second)
                    open.emplace_back(next, level + 1);
            }
    }
    return false;
}

}  // namespace algae::oracle
