#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exact/exact.hpp"
#include "language/detail/letters.hpp"
#include "language/detail/regular.hpp"
#include "language/language.hpp"
#include "language/regular_any.hpp"
#include "oracle/random_tables.hpp"

using namespace algae;

namespace {

Word word_of(const ET0L& system, const std::string& text) {
    Word word;
    for (const char letter : text)
        word.push_back(system.alphabet->find(std::string(1, letter)).value());
    return word;
}

bool is_terminal(const ET0L& system, const Word& word) {
    return std::all_of(word.begin(), word.end(), [&](Symbol a) { return system.terminal[a] != 0; });
}

/// All words by these tables.
std::set<std::string> words_by(const oracle::WrittenTables& written,
                               const std::vector<std::uint32_t>& tables) {
    std::set<std::string> words{written.axiom};
    for (const std::uint32_t table : tables) {
        std::set<std::string> next;
        for (const std::string& word : words) next.merge(oracle::words_after(written, table, word));
        words = std::move(next);
    }
    return words;
}

}  // namespace

TEST_CASE("a first meeting of tables is where trying every choice finds it") {
    const bool holds = rc::check("ET0L systems and regular languages", [] {
        const auto written = *oracle::any_tables(2, true, {"", "a", "ab", "bc"});
        const ET0L system = oracle::et0l_of(written);
        const RegularLanguage language = regular_tests::any_listed(2).language;
        const Meeting found = first_meeting(system, language);
        if (found.derivation) {
            const Word& word = found.derivation->words.back();
            RC_ASSERT(is_derivation(system, *found.derivation));
            RC_ASSERT(found.derivation->choices.size() == found.step);
            RC_ASSERT(language.contains(word));
            RC_ASSERT(is_terminal(system, word));
            if (found.step <= 3 && !found.derivation->tables.empty())
                for (const std::string& text : words_by(written, found.derivation->tables))
                    if (written.is_terminal_word(text) && language.contains(word_of(system, text)))
                        RC_ASSERT(text.size() >= word.size());
        }
        for (unsigned n = 0; n <= 3; ++n) {
            const auto words = oracle::words_of_generation(written, n);
            if (words.size() > 300) break;
            const bool meets =
                std::any_of(words.begin(), words.end(), [&](const std::string& text) {
                    return written.is_terminal_word(text) &&
                           language.contains(word_of(system, text));
                });
            if (meets) {
                RC_ASSERT(found.derivation.has_value());
                RC_ASSERT(found.step == n);
                break;
            }
            RC_ASSERT(!found.derivation || found.step > n);
        }
    });
    CHECK(holds);
}

TEST_CASE("inclusion in a regular language, where all short words are known") {
    const bool holds = rc::check("outside", [] {
        const auto written = *oracle::any_tables(2, true, {"", "a", "ab"});
        const auto listed = oracle::short_words(written, 3, 300);
        if (!listed) return;
        const ET0L system = oracle::et0l_of(written);
        const RegularLanguage language = regular_tests::any_listed(2).language;
        const Meeting found = first_outside(system, language);
        if (found.derivation) {
            RC_ASSERT(is_derivation(system, *found.derivation));
            RC_ASSERT(!language.contains(found.derivation->words.back()));
            RC_ASSERT(is_terminal(system, found.derivation->words.back()));
        } else {
            for (const std::string& text : *listed)
                RC_ASSERT(language.contains(word_of(system, text)));
        }
    });
    CHECK(holds);
}

TEST_CASE("a language is empty if its short and its long words are none") {
    std::size_t empty = 0;
    const bool holds = rc::check("emptiness", [&] {
        const auto written = *oracle::any_tables(2, true, {"a", "b", "ab"});
        const ET0L system = oracle::et0l_of(written);
        const Meeting found = first_word(system);
        if (found.derivation) {
            RC_ASSERT(is_derivation(system, *found.derivation));
            RC_ASSERT(is_terminal(system, found.derivation->words.back()));
        } else {
            ++empty;
            RC_ASSERT(found.states <= 8u);
        }
        // Whether a sequence of up to eight tables, as many as there are sets of letters, ends in
        // terminals.
        std::vector<std::vector<std::size_t>> sequences{{}};
        std::optional<std::size_t> first;
        for (std::size_t i = 0; i < sequences.size() && !first; ++i) {
            if (oracle::longest_by(written, sequences[i])) first = sequences[i].size();
            if (sequences[i].size() < 8)
                for (std::size_t t = 0; t < written.tables.size(); ++t) {
                    sequences.push_back(sequences[i]);
                    sequences.back().push_back(t);
                }
        }
        RC_ASSERT(first.has_value() == found.derivation.has_value());
        if (first) RC_ASSERT(*first == found.step);
    });
    CHECK(holds);
    CHECK(empty > 0);
}

TEST_CASE("terminals decide what is met") {
    const ET0L system = et0l("S", {{{'S', "aSb"}, {'S', "ab"}, {'a', "a"}, {'b', "b"}}}, "ab");
    const Symbol a = *system.alphabet->find("a"), b = *system.alphabet->find("b"),
                 s = *system.alphabet->find("S");
    CHECK(first_word(system).step == 1);
    CHECK_FALSE(first_meeting(system, plus(finite_set({{a, s}, {b}}))).derivation);
    CHECK_FALSE(first_outside(system, concatenated(all_words({a}), all_words({b}))).derivation);
    const Meeting long_word =
        first_meeting(system, concatenated(finite_set({Word(20, a)}), all_words({a, b})));
    REQUIRE(long_word.derivation);
    CHECK(long_word.step == 20);
    const Meeting outside = first_outside(system, all_words({a}));
    REQUIRE(outside.derivation);
    CHECK(spell(*system.alphabet, outside.derivation->words.back()) == "ab");
    CHECK_FALSE(first_word(et0l("S", {{{'S', "aS"}}, {{'S', "SS"}}}, "a")).derivation);
    CHECK_FALSE(first_meeting(system, RegularLanguage()).derivation);
}
