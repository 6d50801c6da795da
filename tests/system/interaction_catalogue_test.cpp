// The systems with context of the documents, with the words that are printed there, and what
// holds of all systems.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <sstream>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/interaction.hpp"
#include "system/detail/interaction.hpp"

using namespace algae;

namespace {

IL system_of(const std::string& text) { return *as_il(read_lsystem(text, "written.lsys")); }

std::vector<std::string> words(const std::string& text, std::uint64_t last) {
    const IL system = system_of(text);
    std::vector<std::string> found;
    for (Development development(system);; development.step()) {
        found.push_back(spell(*system.alphabet, development.word()));
        if (development.generation() == last) return found;
    }
}

using Generations = std::vector<std::string>;

}  // namespace

TEST_CASE("propagation of a signal: S-042, S-120, S-402") {
    const std::string rules = "; b < a -> b; b -> a";
    CHECK(words("axiom baaa" + rules, 5) ==
          Generations{"baaa", "abaa", "aaba", "aaab", "aaaa", "aaaa"});
    CHECK(words("axiom baaaaaaaaa" + rules, 5) == Generations{"baaaaaaaaa", "abaaaaaaaa",
                                                              "aabaaaaaaa", "aaabaaaaaa",
                                                              "aaaabaaaaa", "aaaaabaaaa"});
    // C-133: the same with a border o, where every letter has a left neighbour.
    CHECK(
        words("axiom obaaa; b < a -> b; a < a -> a; o < a -> a; b < b -> a; a < b -> a; o < b -> a",
              4) == Generations{"obaaa", "oabaa", "oaaba", "oaaab", "oaaaa"});
}

TEST_CASE("cellular automata with borders that stay: S-912, S-916") {
    const std::string axiom = "axiom 00000000100000000";
    CHECK(
        words(
            axiom +
                "; 0 < 0 > 0 -> 0; 0 < 0 > 1 -> 1; 0 < 1 > 0 -> 1; 0 < 1 > 1 -> 1; 1 < 0 > 0 -> 1; "
                "1 < 0 > 1 -> 1; 1 < 1 > 0 -> 1; 1 < 1 > 1 -> 0",
            3) == Generations{"00000000100000000", "00000001110000000", "00000011011000000",
                              "00000111111100000"});
    CHECK(
        words(
            axiom +
                "; 0 < 0 > 0 -> 0; 0 < 0 > 1 -> 1; 0 < 1 > 0 -> 1; 0 < 1 > 1 -> 0; 1 < 0 > 0 -> 1; "
                "1 < 0 > 1 -> 1; 1 < 1 > 0 -> 0; 1 < 1 > 1 -> 0",
            3) == Generations{"00000000100000000", "00000001110000000", "00000010001000000",
                              "00000111011100000"});
}

TEST_CASE("context beats no context: S-907") {
    CHECK(words("axiom a; a < a -> ; a -> aa", 3) == Generations{"a", "aa", "aa", "aa"});
}

TEST_CASE("signals in trees, up from the root and down from the tips") {
    CHECK(words("axiom J[I]I[I]I[I]I; J < I -> J", 3) ==
          Generations{"J[I]I[I]I[I]I", "J[J]J[I]I[I]I", "J[J]J[J]J[I]I", "J[J]J[J]J[J]J"});
    CHECK(words("axiom I[I]I[I]I[J]I; I > J -> J", 1) ==
          Generations{"I[I]I[I]I[J]I", "I[I]I[I]I[J]I"});
    CHECK(words("axiom I[I]I[I]I[I]J; I > J -> J", 3) ==
          Generations{"I[I]I[I]I[I]J", "I[I]I[I]J[I]J", "I[I]J[I]J[I]J", "J[I]J[I]J[I]J"});
    CHECK(words("axiom I[I]I[I]I[IJ]I; I > J -> J; I > [J] -> J", 4) ==
          Generations{"I[I]I[I]I[IJ]I", "I[I]I[I]I[JJ]I", "I[I]I[I]J[JJ]I", "I[I]J[I]J[JJ]I",
                      "J[I]J[I]J[JJ]I"});
}

TEST_CASE("a system without context derives as 0L") {
    CHECK(rc::check([] {
        const oracle::WrittenSystem written = *oracle::any_d0l();
        const IL system = *as_il(oracle::lsystem_of(written));
        const unsigned last = oracle::last_generation_within(written, 1000, 6);
        RC_ASSERT(oracle::text_of(*system.alphabet, derive(system, last)) ==
                  oracle::rewritten(written, last));
    }));
}

TEST_CASE("a (1,1)L system is a (2,2)L system") {
    CHECK(rc::check([] {
        const std::string letters = "abc";
        oracle::WrittenInteraction narrow{*oracle::any_nonempty_word(letters, 30), {}, "", false};
        for (const char left : letters)
            for (const char letter : letters)
                for (const char right : letters)
                    narrow.rules.push_back(
                        {{left}, letter, {right}, *oracle::any_word(letters, 2)});
        oracle::WrittenInteraction wide = narrow;  // the narrow rules still serve near the ends
        for (const auto& [left, letter, right, successor] : narrow.rules)
            for (const char before : letters) {
                wide.rules.push_back({before + left, letter, right, successor});
                wide.rules.push_back({left, letter, right + before, successor});
                for (const char behind : letters)
                    wide.rules.push_back({before + left, letter, right + behind, successor});
            }
        std::ostringstream narrow_text, wide_text;
        narrow_text << narrow;
        wide_text << wide;
        RC_ASSERT(words(narrow_text.str(), 4) == words(wide_text.str(), 4));
    }));
}
