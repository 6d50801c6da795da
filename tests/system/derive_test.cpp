#include "system/system.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exact/exact.hpp"
#include "oracle/random_systems.hpp"
#include "system/names.hpp"
#include "word/word.hpp"

using namespace algae;

namespace {

/// The names of a word.
std::vector<std::string> names_of(const Alphabet& alphabet, const Word& word) {
    std::vector<std::string> names;
    for (const Symbol a : word) names.push_back(alphabet.name(a));
    return names;
}

/// Counts pieces and bytes, and keeps nothing.
class CountingSink : public TextSink {
public:
    void write(std::string_view piece) override {
        ++pieces;
        bytes += piece.size();
    }
    void flush() override { flushed = true; }
    std::uint64_t pieces = 0, bytes = 0;
    bool flushed = false;
};

}  // namespace

TEST_CASE("derived words and texts are those of rewriting letter by letter") {
    const bool holds = rc::check("derive and derived_text", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        for (unsigned n = 0; n <= oracle::last_generation_within(written, 3000, 12); ++n) {
            const std::string word = oracle::rewritten(written, n);
            RC_ASSERT(oracle::text_of(*system.alphabet, derive(system, n)) == word);
            RC_ASSERT(derived_text(system, n) == word);
        }
    });
    CHECK(holds);
}

TEST_CASE("texts of names that need blanks are read back as the word they are of") {
    const bool holds = rc::check("subscripts and declared names", [] {
        static const std::vector<std::string> names{"a", "b",    "X_1", "2",   "1",   "_",
                                                    "X", "wall", "w",   "all", "F_l", "l"};
        const auto any_names = [&](int most) {
            return *rc::gen::mapcat(rc::gen::inRange(0, most + 1), [](int size) {
                return rc::gen::container<std::vector<std::string>>(static_cast<std::size_t>(size),
                                                                    rc::gen::elementOf(names));
            });
        };
        std::vector<std::pair<std::string, std::vector<std::string>>> rules;
        for (const char* predecessor : {"a", "X_1", "wall", "2"})
            rules.emplace_back(predecessor, any_names(3));
        const D0L system = named_d0l(names, any_names(4), rules);
        for (unsigned n = 0; n <= 5; ++n) {
            const Word word = oracle::rewritten(system.axiom, system.rules.images(), n);
            const std::string text = derived_text(system, n);
            RC_ASSERT(oracle::names_in(text, {"wall", "all"}) == names_of(*system.alphabet, word));
            RC_ASSERT(text == (word.empty() ? "" : spell(*system.alphabet, word)));
            RC_ASSERT(derive(system, n) == word);
        }
    });
    CHECK(holds);
}

TEST_CASE("the empty word stays empty, and what dies out is empty") {
    CHECK(derived_text(d0l("", {{'a', "ab"}}), 0).empty());
    CHECK(derived_text(d0l("", {{'a', "ab"}}), 1'000'000).empty());
    CHECK(derived_text(d0l("kak", {{'k', "m"}, {'m', ""}, {'a', "k"}}), 2) == "m");
    CHECK(derived_text(d0l("kak", {{'k', "m"}, {'m', ""}, {'a', "k"}}), 3).empty());
    CHECK(derive(d0l("kak", {{'k', "m"}, {'m', ""}, {'a', "k"}}), 1'000'000'000).empty());
}

TEST_CASE("an axiom of constants is its own word in every generation") {
    const D0L system = d0l("c+c", {{'a', "aa"}});
    CHECK(derived_text(system, UINT64_MAX) == "c+c");
    CHECK(derive(system, UINT64_MAX).size() == 3);
}

TEST_CASE("words that grow slowly are derived at large generations") {
    const std::string text = derived_text(d0l("b", {{'b', "aba"}}), 5000);
    CHECK(text == std::string(5000, 'a') + 'b' + std::string(5000, 'a'));
    // Growth of degree 2: generation n has 1 + n + n(n-1)/2 letters.
    CHECK(derived_text(d0l("a", {{'a', "ab"}, {'b', "bc"}}), 300).size() ==
          1 + 300 + 300 * 299 / 2);
    // Letters that take turns never repeat within the first generations.
    CHECK(derived_text(d0l("p", {{'p', "q"}, {'q', "p"}}), 1'000'001) == "q");
}

TEST_CASE("large alphabets: each letter becomes the next") {
    std::vector<std::string> names;
    for (int i = 0; i < 5000; ++i) names.push_back("X_" + std::to_string(i));
    std::vector<std::pair<std::string, std::vector<std::string>>> rules;
    for (std::size_t i = 0; i + 1 < names.size(); ++i)
        rules.push_back({names[i], {names[i + 1], names[0]}});
    const D0L system = named_d0l(names, {"X_0"}, rules);
    CHECK(derived_text(system, 3) == "X_3X_0X_1X_0X_2X_0X_1X_0");
    CHECK(derive(system, 10).size() == 1024);
}

TEST_CASE("blocks are sent whole: the number of pieces does not grow with the word") {
    CountingSink sink;
    derive_text(d0l("F", {{'F', "FF"}}), 28, sink);
    CHECK(sink.bytes == 1u << 28);
    CHECK(sink.pieces <= 1u << 10);
    CHECK(sink.flushed);
}

TEST_CASE("a sink is flushed even if there is nothing to write") {
    CountingSink sink;
    derive_text(d0l("", {}), 3, sink);
    CHECK(sink.flushed);
    CHECK(sink.pieces == 0);
}

TEST_CASE("a word of more letters than allowed is refused, one of as many is not") {
    Budget budget;
    budget.letters = 8;
    const D0L system = d0l("F", {{'F', "FF"}});
    CHECK(derive(system, 3, budget).size() == 8);
    CHECK_THROWS_WITH_AS(derive(system, 4, budget),
                         "generation 4 has more than 8 letters, the bound set", BoundReached);
}

TEST_CASE("a derivation that is told to stop stops, also where no letter has come out yet") {
    std::atomic<bool> stop = true;
    Budget budget;
    budget.stop = &stop;
    CountingSink sink;
    CHECK_THROWS_AS(derive_text(d0l("F", {{'F', "FF"}}), 60, sink, budget), Interrupted);
    const D0L turns = d0l("p", {{'p', "q"}, {'q', "p"}});
    CHECK_THROWS_AS(derive_text(turns, UINT64_MAX, sink, budget), Interrupted);
    CHECK_THROWS_AS(derive(turns, UINT64_MAX, budget), Interrupted);
}

TEST_CASE("a derivation past its deadline stops, also where no letter has come out yet") {
    Budget budget;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
    const D0L turns = d0l("p", {{'p', "q"}, {'q', "p"}});
    CountingSink sink;
    CHECK_THROWS_WITH_AS(derive_text(turns, UINT64_MAX, sink, budget), "the time allowed is over",
                         BoundReached);
    CHECK_THROWS_AS(derive(turns, UINT64_MAX, budget), BoundReached);
}
