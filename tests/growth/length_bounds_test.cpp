#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "growth/growth.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

TEST_CASE("the shortest and the longest words of a generation, against a list of all words") {
    CHECK(rc::check([] {
        const oracle::WrittenSystem written = *oracle::any_0l(2, *rc::gen::arbitrary<bool>());
        const LengthBounds found = length_bounds(oracle::ol_of(written), 3);
        RC_ASSERT(found.least.size() == 4u);
        for (unsigned n = 0; n <= 3; ++n) {
            std::size_t least = std::string::npos, most = 0;
            for (const std::string& word : oracle::words_of_generation(written, n)) {
                least = std::min(least, word.size());
                most = std::max(most, word.size());
            }
            RC_ASSERT(found.least[n] == Integer(least));
            RC_ASSERT(found.most[n] == Integer(most));
        }
    }));
}

TEST_CASE("a D0L system has only one length") {
    const OL system = ol("a", {{'a', "ab"}, {'b', "a"}});
    const LengthBounds found = length_bounds(system, 20);
    CHECK(found.least == found.most);
    CHECK(found.least[20] == 17711);
}

TEST_CASE("a choice of rules is a D0L system between the bounds") {
    CHECK(rc::check([] {
        const OL system = oracle::ol_of(*oracle::any_0l(3, true));
        const LengthBounds found = length_bounds(system, 8);
        for (const auto& choices : {found.least_choice, found.most_choice}) {
            const std::vector<Integer> lengths_of_choice =
                lengths(chosen_system(system, choices), 9);
            for (std::size_t n = 0; n <= 8; ++n) {
                RC_ASSERT(found.least[n] <= lengths_of_choice[n]);
                RC_ASSERT(lengths_of_choice[n] <= found.most[n]);
            }
        }
    }));
}

TEST_CASE("letters may have to change their minds") {
    // a -> b or cc, b -> dddd, c -> d: the longest word takes cc with one step to go, b with two.
    const OL system = ol("a", {{'a', "b"}, {'a', "cc"}, {'b', "dddd"}, {'c', "d"}});
    CHECK(length_bounds(system, 3).most == std::vector<Integer>{1, 2, 4, 4});
    CHECK(length_bounds(system, 1).most_choice[0] == 1);
    CHECK(length_bounds(system, 2).most_choice[0] == 0);
}
