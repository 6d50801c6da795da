#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

#include "model/model.hpp"
#include "oracle/random_tables.hpp"
#include "rewrite/rewrite.hpp"
#include "rewrite/words.hpp"

using namespace algae;

namespace {

const std::string two_tables = "axiom a; table light; a -> ab; b -> b; table dark; a -> b; b -> aa";

std::string by_tables(const std::string& sequence) {
    const Rewriting rewriting(read_lsystem(two_tables, "t.lsys"));
    const std::vector<std::size_t> tables =
        table_sequence(rewriting.rules().system->tables, sequence);
    return ModuleText(rewriting.rules().system->alphabet, rewriting.rules().kinds)
        .text(derive(rewriting, tables.size(), tables));
}

}  // namespace

TEST_CASE("each step uses the table that is said") {
    CHECK(by_tables("light") == "ab");
    CHECK(by_tables("light,dark") == "baa");
    CHECK(by_tables("12") == "baa");
    CHECK(by_tables("1,2,1") == "babab");
    CHECK(by_tables("2222") == "aaaa");
}

TEST_CASE("tables by names of one character") {
    CHECK(table_sequence({"p", "q"}, "pqqp") == std::vector<std::size_t>{0, 1, 1, 0});
    CHECK(table_sequence({"ž", "q"}, "žqž") == std::vector<std::size_t>{0, 1, 0});
    CHECK(table_sequence({"ab"}, "ab") == std::vector<std::size_t>{0});
    CHECK_THROWS_WITH(table_sequence({"p", "q"}, "pr"),
                      "expected a table (p, q, or a number from 1 to 2), found \"r\"");
    CHECK_THROWS_WITH(table_sequence({"p", "q"}, "3"),
                      "expected a table (p, q, or a number from 1 to 2), found \"3\"");
    CHECK_THROWS_AS(table_sequence({}, "1"), Error);
}

TEST_CASE("random tables are the same for the same seed, and all are used") {
    const LSystem system = read_lsystem(two_tables, "t.lsys");
    const Rewriting one(system, {.seed = 4}), same(system, {.seed = 4});
    std::set<std::size_t> used;
    for (std::uint64_t generation = 0; generation < 20; ++generation) {
        CHECK(one.random_table(generation) == same.random_table(generation));
        used.insert(one.random_table(generation));
    }
    CHECK(used.size() == 2);
    CHECK(derive(one, 8) == derive(same, 8));
}

TEST_CASE("steps without a table said take that of the schedule, again and again") {
    const LSystem system = read_lsystem(two_tables + "; schedule light dark light", "t.lsys");
    const Rewriting own(system), seeded(system, {.seed = 4, .random_tables = true}),
        unscheduled(read_lsystem(two_tables, "t.lsys"), {.seed = 4});
    for (std::uint64_t n = 0; n < 10; ++n) {
        const std::vector<std::size_t> said{0, 1, 0, 0, 1, 0, 0, 1, 0, 0};
        CHECK(own.own_table(n) == said[n]);
        CHECK(derive(own, n) == derive(own, n, said));
        CHECK(derive(seeded, n) == derive(unscheduled, n));
    }
    CHECK(derive(own, 2, {1, 1}) == derive(unscheduled, 2, {1, 1}));
}

TEST_CASE("words by a schedule are those that a table of letters gives") {
    CHECK(rc::check([] {
        const auto image = rc::gen::container<std::string>(rc::gen::elementOf(std::string("abc")));
        const auto steps = *rc::gen::nonEmpty(
            rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, 3)));
        std::vector<std::map<char, std::string>> tables(3);
        std::string text = "axiom abca\n", word = "abca";
        for (std::size_t t = 0; t < tables.size(); ++t) {
            text += "table t" + std::to_string(t) + '\n';
            for (const char letter : {'a', 'b', 'c'}) {
                const std::string successor = (*image).substr(0, 2);
                tables[t][letter] = successor;
                text += std::string(1, letter) + " -> " + successor + '\n';
            }
        }
        text += "schedule";
        for (const std::size_t t : steps) text += " t" + std::to_string(t);
        const Rewriting rewriting(read_lsystem(text, "t.lsys"));
        const ModuleText spelled(rewriting.rules().system->alphabet, rewriting.rules().kinds);
        for (std::uint64_t n = 0; n <= 8; ++n) {
            RC_ASSERT(spelled.text(derive(rewriting, n)) == (word.empty() ? "ε" : word));
            std::string next;
            for (const char letter : word) next += tables[steps[n % steps.size()]][letter];
            word = next;
        }
    }));
}

TEST_CASE("the language of a system does not depend on its schedule") {
    const auto language = [](const std::string& text) {
        const ET0L system = *as_et0l(read_lsystem(text, "t.lsys"));
        std::set<std::string> words;
        for (const Word& word : terminal_words(system, 4))
            words.insert(spell(*system.alphabet, word));
        return words;
    };
    CHECK(language(two_tables) == language(two_tables + "; schedule dark"));
    CHECK(language(two_tables).size() > 5);
}

TEST_CASE("the words over the terminals are those found by trying everything") {
    CHECK(rc::check([] {
        const auto written = *oracle::any_tables(2, true, {"", "ab", "c", "abc"});
        const ET0L system = oracle::et0l_of(written);
        const unsigned n = *rc::gen::inRange(0u, 4u);
        std::set<std::string> expected;
        for (unsigned k = 0; k <= n; ++k)
            for (const std::string& word : oracle::words_of_generation(written, k))
                if (written.is_terminal_word(word)) expected.insert(word);
        std::set<std::string> found, shortest;
        std::size_t last = 0;
        for (const Word& word : terminal_words(system, n)) {
            std::string text;
            for (const Symbol a : word) text += system.alphabet->name(a);
            RC_ASSERT(text.size() >= last);
            last = text.size();
            RC_ASSERT(found.insert(text).second);
        }
        RC_ASSERT(found == expected);
        std::size_t of_two = 0;
        for (const std::string& word : expected) of_two += word.size() <= 2;
        RC_ASSERT(terminal_words(system, n, 2).size() == of_two);
    }));
}
