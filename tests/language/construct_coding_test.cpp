#include "language/detail/construct.hpp"

#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "language/construct_any.hpp"

using namespace algae;
using namespace algae::construct_tests;

namespace {

constexpr std::size_t longest = 4;

std::set<Word> coded_words(const CodedOL& coded) {
    oracle::Meaning meaning;
    for (const Symbol letter : coded.coding.domain()) {
        RC_ASSERT(coded.coding[letter].size() == 1u);
        meaning[letter] = {coded.coding[letter]};
    }
    return words_of(as_et0l(coded.system), meaning, longest);
}

}  // namespace

TEST_CASE("an E0L language is a coding of an 0L language") {
    Budget budget;
    budget.memory = 1 << 19;
    int small = 0, several = 0;
    CHECK(rc::check("coding", [&] {
        const ET0L system = any_system({1, *rc::gen::arbitrary<bool>(), false, 2});
        RC_LOG() << text_of(system);
        auto words = words_of(system, longest);
        try {
            const CodedOL coded = coding_of_0l(system, budget);
            RC_ASSERT(coded_words(coded) == words);
            RC_ASSERT(coded.coding.domain().size() <= coded.system.alphabet->size());
            ++small;
            if (words.size() > 2) ++several;
        } catch (const BoundReached&) {
            RC_DISCARD("too large");
        } catch (const Error&) {
            words.erase(Word{});
            RC_ASSERT(words.empty());
        }
    }));
    CHECK(small > 20);
    CHECK(several > 5);
}

TEST_CASE("sets that come again after several steps") {
    // Terminal words come in steps 2, 5, 8, ... by way of A and in even steps by way of B.
    const ET0L system = et0l("S",
                             {{{'S', "A"},
                               {'S', "B"},
                               {'A', "aa"},
                               {'A', "C"},
                               {'C', "D"},
                               {'D', "AA"},
                               {'B', "b"},
                               {'B', "E"},
                               {'E', "BB"},
                               {'a', "F"},
                               {'b', "F"}}},
                             "ab");
    const CodedOL coded = coding_of_0l(system);
    oracle::Meaning meaning;
    for (const Symbol letter : coded.coding.domain()) meaning[letter] = {coded.coding[letter]};
    const auto words = oracle::short_words(system, 4);
    REQUIRE(words);
    CHECK(words->size() == 2 + 3);  // a^2, a^4 and b, b^2, b^4
    CHECK(oracle::meant_words(as_et0l(coded.system), meaning, 4) == words);
}

TEST_CASE("no coding where there is no word") {
    CHECK_THROWS_AS(coding_of_0l(et0l("S", {{{'S', "SS"}}}, "a")), Error);
    CHECK_THROWS_AS(coding_of_0l(et0l("a", {{{'a', "b"}}, {{'a', "aa"}}})), Error);
}
