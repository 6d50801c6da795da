// The exact half of the room against words written out on a lattice.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dimension/detail/recurrent_set.hpp"
#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/lattice_parts.hpp"
#include "system/system.hpp"

using namespace algae;
using oracle::LatticePart;
using oracle::LatticeParts;
using oracle::LatticeSystem;

namespace {

/// Numbers that a successor is made from; any will do.
struct Recipe {
    std::vector<int> turns;    // before each letter but the first
    std::vector<int> letters;  // of the three successors, one after the other
    int closing = 0;  // the turn behind the last letter, if the path shall not end as it began
    int shift = 0;    // of the headings of G and f
    int branch = 0, branch_letter = 0;
};

LatticeSystem system_of(bool hexagonal, const Recipe& recipe) {
    LatticeSystem system{hexagonal, {}};
    const int order = system.order(), most = hexagonal ? 2 : 1;
    const auto turned = [&](int by) {
        by = ((by % order) + order + order / 2) % order - order / 2;
        return std::string(static_cast<std::size_t>(std::abs(by)), by > 0 ? '+' : '-');
    };
    std::vector<int> headings{0};
    for (const int turn : recipe.turns) headings.push_back(headings.back() + turn % (most + 1));
    const bool straight = recipe.closing > 1;  // the path ends in the direction that it began with
    const std::size_t count = headings.size();
    for (std::size_t k = 0; k < 3; ++k) {
        std::vector<int> own = headings;
        if (straight && k > 0)
            std::rotate(own.begin(), own.begin() + recipe.shift % static_cast<int>(count),
                        own.end());
        std::string word;
        int heading = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const auto letter =
                static_cast<std::size_t>(recipe.letters[(k * count + i) % recipe.letters.size()]);
            word += turned(own[i] - heading);
            heading = own[i];
            if (k == 0 && static_cast<int>(i) == recipe.branch)
                word += std::string(recipe.branch_letter % 2 == 0 ? "[+" : "[-") +
                        "FFGf"[recipe.branch_letter % 4] + "]";
            word += i == 0 ? "FGf"[k] : "FFFGf"[letter % 5];
        }
        word += straight ? turned(-heading) : turned(headings.back() + recipe.closing - heading);
        system.successors["FGf"[k]] = word;
    }
    return system;
}

rc::Gen<LatticeSystem> any_lattice_system() {
    const auto recipe = rc::gen::build<Recipe>(
        rc::gen::set(&Recipe::turns,
                     rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 7),
                                     [](std::size_t size) {
                                         return rc::gen::container<std::vector<int>>(
                                             size, rc::gen::inRange(-2, 3));
                                     })),
        rc::gen::set(&Recipe::letters,
                     rc::gen::container<std::vector<int>>(11, rc::gen::inRange(0, 5))),
        rc::gen::set(&Recipe::closing, rc::gen::inRange(0, 6)),
        rc::gen::set(&Recipe::shift, rc::gen::inRange(0, 6)),
        rc::gen::set(&Recipe::branch, rc::gen::inRange(0, 20)),
        rc::gen::set(&Recipe::branch_letter, rc::gen::inRange(0, 4)));
    return rc::gen::apply(system_of, rc::gen::arbitrary<bool>(), recipe);
}

/// What the library makes of a system, with the neighbours of the component of its first letter.
struct Analysis {
    RecurrentSet set;
    std::size_t component;
    Neighbours neighbours;

    static std::optional<Analysis> of(const Model& system) {
        try {
            RecurrentSet set(system, *as_d0l(system));
            const std::size_t component = set.components().of_letter[set.axiom().front().piece];
            const auto& rate = set.components().list[component].rate;
            if (!rate || !(*rate > Rate(1))) return std::nullopt;
            Neighbours neighbours(set, component, {}, 1000);
            return Analysis{std::move(set), component, std::move(neighbours)};
        } catch (const Error&) {
            return std::nullopt;
        } catch (const BoundReached&) {
            return std::nullopt;
        }
    }

    std::size_t piece() const { return set.components().list[component].letters.front(); }
    std::size_t letters() const { return set.unfolding().letters.size(); }
    std::size_t phase(std::size_t piece) const { return piece / letters(); }
    char letter(const Model& system, std::size_t piece) const {
        return system.alphabet.name(set.unfolding().letters[piece % letters()])[0];
    }
    std::size_t piece_of(const Model& system, char letter, std::size_t phase) const {
        const Symbol symbol = *system.alphabet.find(std::string(1, letter));
        const auto& all = set.unfolding().letters;
        return phase * letters() +
               static_cast<std::size_t>(std::find(all.begin(), all.end(), symbol) - all.begin());
    }
    /// A generation of words that turn as the pieces of this phase do.
    unsigned generation(std::size_t phase, unsigned more = 0) const {
        const Unfolding& unfolding = set.unfolding();
        return static_cast<unsigned>(unfolding.preperiod + phase + more * unfolding.phases);
    }
    std::size_t phase_below(std::size_t phase, unsigned levels) const {
        const std::size_t phases = set.unfolding().phases;
        return (phase + phases * levels - levels) % phases;
    }
};

/// The most generations, at most 6, in which the words stay short.
unsigned short_enough(const LatticeSystem& system, std::size_t most) {
    std::size_t longest = 0;
    for (const auto& [letter, successor] : system.successors)
        longest = std::max(longest, successor.size());
    unsigned n = 0;
    for (double size = 1; n < 6 && size * static_cast<double>(longest) < static_cast<double>(most);
         ++n)
        size *= static_cast<double>(longest);
    return n;
}

}  // namespace

TEST_CASE("different parts are as many as those of words written out on a lattice") {
    int looked_at = 0, with_coincidences = 0, with_phases = 0;
    CHECK(rc::check([&] {
        const LatticeSystem written = *any_lattice_system();
        const Model system = read_lsystem(written.text(), "random");
        const auto found = Analysis::of(system);
        if (!found) return;
        DistinctGrowth growth;
        try {
            growth = distinct_growth(found->set, found->component, found->neighbours, {}, 200);
        } catch (const BoundReached&) {
            return;
        }
        ++looked_at;
        const LatticeParts parts(written);
        const std::size_t piece = found->piece(), phase = found->phase(piece);
        const char letter = found->letter(system, piece);
        const std::string counted = parts.companions(letter);
        bool seen = false;
        for (unsigned n = 0; n <= short_enough(written, 8'000); ++n) {
            const auto all =
                parts.parts(letter, n, found->generation(found->phase_below(phase, n), 1), counted);
            const std::set<LatticePart> different(all.begin(), all.end());
            seen = seen || different.size() < all.size();
            RC_ASSERT(growth.first_counts[n] == Integer(different.size()));
        }
        const Rate& all = *found->set.components().list[found->component].rate;
        if (seen) RC_ASSERT(found->neighbours.parts_coincide());
        RC_ASSERT(found->neighbours.parts_coincide() == (growth.rate < all));
        with_coincidences += seen;
        with_phases += found->set.unfolding().phases > 1;
    }));
    CHECK(looked_at >= 20);
    CHECK(with_coincidences >= 2);
    MESSAGE(looked_at, " systems, ", with_coincidences, " with parts that coincide, ", with_phases,
            " with several phases");
}

TEST_CASE(
    "a regular limit has one component of letters, and no parts of it coincide on a lattice") {
    int regular = 0, others = 0;
    CHECK(rc::check([&] {
        const LatticeSystem written = *any_lattice_system();
        const Model system = read_lsystem(written.text(), "random");
        const ExactDimension found = exact_dimension(system, {}, 500);
        if (found.status != ExactDimension::Status::exact) return;
        if (!found.is_regular) {
            ++others;
            return;
        }
        ++regular;
        const auto analysis = Analysis::of(system);
        RC_ASSERT(analysis.has_value());
        const LatticeParts parts(written);
        // f draws where F or G come from it.
        const std::string own = parts.companions('F');
        std::set<char> reached{'F'};
        for (std::size_t before = 0; before != reached.size();) {
            before = reached.size();
            for (const char letter : std::set<char>(reached))
                for (const char next : written.successors.at(letter))
                    if (std::isalpha(next)) reached.insert(next);
        }
        for (const char letter : reached) {
            const std::string companions = parts.companions(letter);
            const bool draws = companions.find_first_of("FG") != std::string::npos;
            if (draws)
                RC_ASSERT(std::set(companions.begin(), companions.end()) ==
                          std::set(own.begin(), own.end()));
        }
        const std::size_t phase = analysis->phase(analysis->piece());
        const char letter = analysis->letter(system, analysis->piece());
        for (unsigned n = 0; n <= short_enough(written, 8'000); ++n) {
            const auto all = parts.parts(
                letter, n, analysis->generation(analysis->phase_below(phase, n), 1), own);
            RC_ASSERT(std::set<LatticePart>(all.begin(), all.end()).size() == all.size());
        }
    }));
    CHECK(regular >= 15);
    CHECK(others >= 5);
    MESSAGE(regular, " regular limits, ", others, " others");
}

TEST_CASE("pairs of parts meet exactly if their parts come near again and again") {
    int apart = 0, near = 0;
    CHECK(rc::check([&] {
        const LatticeSystem written = *any_lattice_system();
        const Model system = read_lsystem(written.text(), "random");
        const auto found = Analysis::of(system);
        if (!found) return;
        const LatticeParts parts(written);
        const std::size_t piece = found->piece();
        const char letter = found->letter(system, piece);
        const std::string counted = parts.companions(letter);
        const std::size_t below = found->phase_below(found->phase(piece), 2);
        constexpr unsigned levels = 16;
        const unsigned generation =
            found->generation(below, static_cast<unsigned>(40 / found->set.unfolding().phases + 1));

        // The same parts by the library: of the parts of the piece.
        const Placement whole{piece, 0, found->set.displacement().zero()};
        std::vector<Placement> placements;
        for (const auto& part : parts_within(found->set, piece))
            for (const auto& smaller : parts_within(found->set, part.piece))
                placements.push_back(placed(found->set, placed(found->set, whole, part), smaller));
        const auto all = parts.parts(letter, 2, generation, counted);
        RC_ASSERT(all.size() == placements.size());
        const auto pairs = static_cast<int>(all.size() * all.size());
        for (int tries = 0; tries < 3; ++tries) {
            const int pair = *rc::gen::inRange(0, pairs);
            const auto i = static_cast<std::size_t>(pair) / all.size(),
                       j = static_cast<std::size_t>(pair) % all.size();
            RC_ASSERT(found->letter(system, placements[i].piece) == all[i].letter);
            RC_ASSERT(placements[i].heading == all[i].heading);
            if (placements[i] == placements[j]) {
                RC_ASSERT(all[i] == all[j]);
                continue;
            }
            const auto met = [&](std::size_t x, std::size_t y) {
                return found->neighbours
                    .find(placements[x].piece, seen_from(found->set, placements[x], placements[y]))
                    .has_value();
            };
            const bool alive = met(i, j) || met(j, i);
            RC_ASSERT(parts.come_near(all[i], all[j], generation, levels, counted) == alive);
            ++(alive ? near : apart);
        }
    }));
    CHECK(near >= 10);
    CHECK(apart >= 10);
    MESSAGE(near, " pairs meet, ", apart, " lie apart");
}
