#include "language/language.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exact/exact.hpp"
#include "language/detail/regular.hpp"
#include "oracle/random_tables.hpp"

using namespace algae;

namespace {

std::vector<std::size_t> tables_of(const Course& course) {
    std::vector<std::size_t> tables;
    for (const TableUse& use : course) tables.push_back(use.table);
    return tables;
}

/// The longest word by the tables before, n rounds and the tables after.
std::optional<std::uint64_t> longest_after_rounds(const oracle::WrittenTables& written,
                                                  const EndlessTables& proof, std::size_t n) {
    std::vector<std::size_t> tables = tables_of(proof.before);
    const auto append = [&](const std::vector<std::size_t>& more) {
        tables.insert(tables.end(), more.begin(), more.end());
    };
    while (n-- > 0) append(tables_of(proof.round));
    append(tables_of(proof.after));
    return oracle::longest_by(written, tables);
}

/// The longest word by any sequence of up to six tables.
std::uint64_t longest_of_first(const oracle::WrittenTables& written) {
    std::vector<std::vector<std::size_t>> sequences{{}};
    std::uint64_t longest = 0;
    for (std::size_t i = 0; i < sequences.size(); ++i) {
        longest = std::max(longest, oracle::longest_by(written, sequences[i]).value_or(0));
        if (sequences[i].size() < 6)
            for (std::size_t t = 0; t < written.tables.size(); ++t) {
                sequences.push_back(sequences[i]);
                sequences.back().push_back(t);
            }
    }
    return longest;
}

std::size_t longest_word(const RegularLanguage& language) {
    std::size_t length = 0, seen = 0;
    const Integer all = *number_of_words(language);
    for (Integer words = 0; words != all; ++length)
        if (const Integer more = number_of_words(language, length); !more.is_zero()) {
            words = words + more;
            seen = length;
        }
    return seen;
}

}  // namespace

TEST_CASE(
    "finite ET0L languages have the words that all sequences of tables give, infinite ones a "
    "proof") {
    for (const bool erasing : {false, true}) {
        std::size_t finite = 0, infinite = 0, counted = 0;
        const bool holds = rc::check("finiteness of tables", [&] {
            const auto written = *oracle::any_tables(2, erasing, {"", "a", "ab", "bc", "c"});
            const ET0L system = oracle::et0l_of(written);
            const TablesFiniteness found = finiteness(system);
            RC_ASSERT(found.finite != found.endless.has_value());
            if (!found.finite) {
                ++infinite;
                RC_ASSERT(is_proof(system, *found.endless));
                for (std::size_t n = 0; n <= 6; ++n)
                    RC_ASSERT(longest_after_rounds(written, *found.endless, n).value_or(0) >= n);
                return;
            }
            ++finite;
            const RegularLanguage words = finite_words(system);
            const std::size_t longest = longest_word(words);
            RC_ASSERT(longest_of_first(written) <= longest);
            RC_ASSERT(number_of_words(system) == *number_of_words(words));
            if (longest > 8) return;
            const auto listed = oracle::short_words(written, longest + 3, 200);
            if (!listed) return;
            ++counted;
            RC_ASSERT(Integer(listed->size()) == *number_of_words(words));
            for (const std::string& text : *listed) {
                Word word;
                for (const char letter : text)
                    word.push_back(*system.alphabet->find(std::string(1, letter)));
                RC_ASSERT(words.contains(word));
            }
        });
        CHECK(holds);
        CHECK(finite > 10);
        CHECK(infinite > 10);
        CHECK(counted > 10);
    }
}

TEST_CASE("one table without terminals: the theorem of 0L systems says the same") {
    const bool holds = rc::check("0L", [] {
        const auto written = *oracle::any_tables(1, true, {""});
        const ET0L system = oracle::et0l_of(written);
        RC_ASSERT(finiteness(system).finite == finiteness(without_terminals(system)).finite);
    });
    CHECK(holds);
}

TEST_CASE("finite and infinite by the least that makes the difference") {
    const auto is_finite = [](const ET0L& system) { return finiteness(system).finite; };
    CHECK_FALSE(is_finite(et0l("a", {{{'a', "b"}}, {{'b', "aa"}}})));
    CHECK(is_finite(et0l("a", {{{'a', "b"}}, {{'b', "c"}}, {{'c', "cd"}, {'d', ""}}})));
    // What a table adds the next erases, but need not be used.
    CHECK_FALSE(is_finite(et0l("a", {{{'a', "ab"}}, {{'b', ""}}})));
    // It must: b becomes no terminal otherwise.
    CHECK(is_finite(et0l("a", {{{'a', "ab"}}, {{'b', ""}}}, "a")));
    CHECK(number_of_words(et0l("a", {{{'a', "ab"}}, {{'b', ""}}}, "a")) == 1);
    // S grows, but what it grows never ends.
    CHECK(is_finite(et0l("S", {{{'S', "SN"}, {'S', "a"}}}, "a")));
    CHECK(number_of_words(et0l("S", {{{'S', "SN"}, {'S', "a"}}}, "a")) == 1);
    // Two letters that return by different tables never grow together.
    CHECK(is_finite(et0l("a", {{{'a', "ab"}, {'b', ""}}, {{'a', ""}}})));
    CHECK_FALSE(is_finite(et0l("a", {{{'a', "ab"}, {'b', ""}}, {{'b', "a"}}})));
    // The round is six steps long, and b, or b and d, are no terminals on the way.
    const auto rounds = [](const std::string& terminals) {
        return et0l("a", {{{'a', "b"}, {'b', "ac"}, {'c', "d"}, {'d', "e"}, {'e', "c"}}},
                    terminals);
    };
    CHECK_FALSE(is_finite(rounds("acde")));
    CHECK(is_finite(rounds("ace")));
    CHECK(number_of_words(rounds("ace")) == 3);  // a, ac, ace; then a letter c is d, or there is b
    CHECK(is_finite(et0l("", {{{'a', "aa"}}})));
    CHECK(number_of_words(et0l("", {{{'a', "aa"}}})) == 1);
    CHECK(number_of_words(et0l("S", {{{'S', "S"}}}, "a")) == 0);
    CHECK_THROWS_WITH_AS(finite_words(et0l("a", {{{'a', "aa"}}})), "the language is infinite",
                         Error);
}

TEST_CASE("a proof that was tampered with is none") {
    const ET0L system = et0l("SS",
                             {{{'S', "aT"}, {'T', "b"}},
                              {{'T', "SU"}, {'a', ""}, {'U', "U"}, {'b', "N"}},
                              {{'U', "b"}, {'S', "b"}}},
                             "ab");
    const TablesFiniteness found = finiteness(system);
    REQUIRE(found.endless);
    REQUIRE(is_proof(system, *found.endless));
    const auto is_broken = [&](auto change) {
        EndlessTables proof = *found.endless;
        change(proof);
        return !is_proof(system, proof);
    };
    CHECK(is_broken([](EndlessTables& proof) { proof.round.clear(); }));
    CHECK(is_broken([](EndlessTables& proof) { proof.beside = proof.round; }));
    CHECK(is_broken([](EndlessTables& proof) { proof.after.pop_back(); }));
    CHECK(is_broken([](EndlessTables& proof) { proof.kept.front().table = 9; }));
    CHECK(is_broken([](EndlessTables& proof) { proof.kept.back().choice = 9; }));
    CHECK(is_broken([](EndlessTables& proof) { proof.round.front().place = 9; }));
    CHECK(is_broken([](EndlessTables& proof) { std::swap(proof.again, proof.other); }));
    CHECK(is_broken([](EndlessTables& proof) { proof.other = 99; }));
    CHECK_FALSE(is_proof(system, EndlessTables{}));
}

TEST_CASE("more words than could be listed are counted, with tables too") {
    const ET0L system = et0l(std::string(100, 'a'), {{{'a', "b"}, {'a', "c"}}, {{'b', "d"}}});
    // a^100; the words of b and c; those with a b, every b then d; no word has both.
    CHECK(number_of_words(system) == 1 + power(Integer(2), 100) + (power(Integer(2), 100) - 1));
    Budget budget;
    budget.memory = 1 << 10;
    CHECK_THROWS_AS(number_of_words(system, budget), BoundReached);
}

TEST_CASE("rounds after which a letter of the axiom never finishes are no proof") {
    // c becomes d, which is no terminal: by itself a has endlessly many words, beside c only one.
    const ET0L system =
        oracle::et0l_of({"ac", {{{'a', {"ab"}}, {'b', {"b"}}, {'c', {"d"}}, {'d', {"d"}}}}, "abc"});
    EndlessTables proof;
    proof.again = 0;
    proof.other = 1;
    proof.round = {{0, 0, 0, 0}};
    proof.beside = {{0, 0, 0, 1}};
    proof.kept = {{0, 1, 0, 0}};
    CHECK(finiteness(system).finite);
    CHECK_FALSE(is_proof(system, proof));
    ET0L alone = system;
    alone.axiom = {0};
    alone.tables[0][2] = {{2}};
    CHECK(is_proof(alone, proof));
}
