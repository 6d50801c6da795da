#include "system/system.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "oracle/random_systems.hpp"

using namespace algae;

TEST_CASE("a walk meets the letters of the word from left to right") {
    const bool holds = rc::check("all letters", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const Fates fates(system);
        for (unsigned n = 0; n <= oracle::last_generation_within(written, 2000, 8); ++n) {
            Word word;
            walk(system, fates, n, [&](Symbol a, std::uint64_t steps) {
                if (steps == 0) word.push_back(a);
                return true;
            });
            RC_ASSERT(oracle::text_of(*system.alphabet, word) == oracle::rewritten(written, n));
        }
    });
    CHECK(holds);
}

TEST_CASE("a walk that does not go into letters meets the letters of an earlier generation") {
    const bool holds = rc::check("cut at k steps to go", [] {
        const auto written = *oracle::any_propagating_d0l();
        const D0L system = oracle::d0l_of(written);
        const unsigned n = oracle::last_generation_within(written, 500, 5);
        const unsigned k = *rc::gen::inRange(0u, n + 1);
        Word met;
        walk(system, Fates(system), n, [&](Symbol a, std::uint64_t steps) {
            if (steps > k) return true;
            met.push_back(a);
            return false;
        });
        RC_ASSERT(oracle::text_of(*system.alphabet, met) == oracle::rewritten(written, n - k));
    });
    CHECK(holds);
}

TEST_CASE("fates are what happens to each letter") {
    const bool holds = rc::check("lifetimes and constants", [] {
        auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const Fates fates(system);
        for (const Symbol a : system.letters) {
            const std::string name = system.alphabet->name(a);
            written.axiom = name;
            RC_ASSERT(fates.is_constant(a) == (oracle::rewritten(written, 1) == name));
            // A mortal letter is gone after as many steps as there are letters (Rozenberg and
            // Salomaa 1980, I.3); longer words than that alphabet's mortal ones can make are not mortal.
            unsigned steps = 0;
            std::set<char> alive{name[0]};
            while (!alive.empty() && steps <= 10) {
                std::set<char> next;
                for (const char letter : alive) {
                    const auto found = written.successors.find(letter);
                    if (found == written.successors.end())
                        next.insert(letter);
                    else
                        next.insert(found->second[0].begin(), found->second[0].end());
                }
                alive = next;
                ++steps;
            }
            RC_ASSERT(fates.lifetime(a) == (alive.empty() ? steps : Fates::never));
            if (alive.empty()) {
                RC_ASSERT(fates.is_gone(a, steps));
                RC_ASSERT(!fates.is_gone(a, steps - 1));
            } else {
                RC_ASSERT(!fates.is_gone(a, 1'000'000));
            }
        }
    });
    CHECK(holds);
}

TEST_CASE("a constant is visited once, whatever the generation") {
    const D0L system = d0l("c", {});
    std::uint64_t visits = 0;
    walk(system, Fates(system), 1'000'000, [&](Symbol, std::uint64_t steps) {
        CHECK(steps == 0);
        ++visits;
        return true;
    });
    CHECK(visits == 1);
}

TEST_CASE("letters of which nothing is left are not visited") {
    const D0L system = d0l("mam", {{'m', ""}, {'a', "am"}});
    std::string met;
    walk(system, Fates(system), 2, [&](Symbol a, std::uint64_t steps) {
        met += system.alphabet->name(a) + std::to_string(steps);
        return true;
    });
    CHECK(met == "a2a1a0m0");
}

TEST_CASE("nothing is gone in generation 2^64 - 1 but mortal letters") {
    const Fates fates(d0l("am", {{'a', "aa"}, {'m', ""}}));
    CHECK(!fates.is_gone(0, UINT64_MAX));
    CHECK(fates.is_gone(1, UINT64_MAX));
}

TEST_CASE("a walk keeps no place to come back to where only mortal letters follow") {
    // One position a generation would be several GB here.
    const D0L system = d0l("a", {{'a', "am"}, {'m', ""}});
    std::string word;
    walk(system, Fates(system), 200'000'000, [&](Symbol a, std::uint64_t steps) {
        if (steps == 0) word += system.alphabet->name(a);
        return true;
    });
    CHECK(word == "am");
}
