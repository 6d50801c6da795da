#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "growth/expanded.hpp"
#include "growth/growth.hpp"

using namespace algae;

namespace {

/// Whether a letter grows, by the size of its word far out: bounded ones stay far below 2^21.
bool grows(const oracle::WrittenSystem& written, char letter) {
    oracle::WrittenSystem from_letter = written;
    from_letter.axiom = std::string(1, letter);
    return estimated_log2_length(oracle::d0l_of(from_letter), 1'000'000'000) > 21;
}

}  // namespace

TEST_CASE("a letter that pushes others before it is found with what it pushes") {
    const D0L thread = d0l("a", {{'a', "ab"}, {'b', "b"}});
    const auto pusher = pusher_of(thread);
    REQUIRE(pusher);
    CHECK(thread.alphabet->name(pusher->letter) == "a");
    CHECK(pusher->steps == 1);
    CHECK(spell(*thread.alphabet, pusher->run) == "b");
    CHECK(!pusher->left);
    const auto other_way = pusher_of(d0l("a", {{'a', "ba"}, {'b', "b"}}));
    REQUIRE(other_way);
    CHECK(other_way->left);
}

TEST_CASE("letters that do not grow need not be pushed") {
    CHECK(!pusher_of(d0l("a", {{'a', "aaba"}, {'b', "b"}})));
    CHECK(!pusher_of(d0l("a", {{'a', "ab"}, {'b', "a"}})));
    CHECK(!pusher_of(d0l("b", {{'a', "ab"}, {'b', "b"}})));             // a does not occur
    CHECK(!pusher_of(d0l("a", {{'a', "ab"}, {'b', "k"}, {'k', ""}})));  // nor does it grow here
}

TEST_CASE(
    "what is said to be pushed is seen in the words, and nothing is pushed without being said") {
    CHECK(rc::check([] {
        const auto written = *rc::gen::oneOf(any_growing_d0l(), oracle::any_d0l());
        const D0L system = oracle::d0l_of(written);
        const auto pusher = pusher_of(system);
        const auto repetitions = infinite_repetitions(system);
        RC_ASSERT(pusher.has_value() == std::any_of(repetitions.begin(), repetitions.end(),
                                                    [](const auto& r) { return !r.grows; }));
        if (!pusher) {
            // Where growth is polynomial, some letter lengthens a run of letters that do not grow.
            if (estimated_log2_length(system, 1'000'000'000) > 21)
                RC_ASSERT(estimated_log2_length(system, 1'000'000'000) > 1000);
            return;
        }
        const std::string letter = system.alphabet->name(pusher->letter),
                          run = spell(*system.alphabet, pusher->run);
        RC_ASSERT(!pusher->run.empty());
        RC_ASSERT(grows(written, letter[0]));
        for (const char c : run) RC_ASSERT(!grows(written, c));
        oracle::WrittenSystem from_letter = written;
        from_letter.axiom = letter;
        const std::string word =
            oracle::rewritten(from_letter, static_cast<unsigned>(pusher->steps));
        RC_ASSERT((pusher->left ? word.starts_with(run + letter) : word.ends_with(letter + run)));
    }));
}
