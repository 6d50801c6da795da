#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <random>
#include <sstream>
#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/interaction.hpp"
#include "system/detail/interaction.hpp"

using namespace algae;

namespace {

IL system_of(const oracle::WrittenInteraction& written) {
    std::ostringstream text;
    text << written;
    return *as_il(read_lsystem(text.str(), "written.lsys"));
}

/// A system over the first so many letters, contexts of up to two letters, axioms that are long
/// enough for several words of a machine.
rc::Gen<oracle::WrittenInteraction> any_plain(bool keeps_length) {
    return rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 8), [=](std::size_t count) {
        const std::string letters = std::string("abcdefg").substr(0, count);
        const auto rule = rc::gen::construct<oracle::WrittenInteraction::Rule>(
            oracle::any_word(letters, 2), rc::gen::elementOf(letters), oracle::any_word(letters, 2),
            keeps_length ? rc::gen::container<std::string>(1, rc::gen::elementOf(letters))
                         : oracle::any_word(letters, 3));
        const auto rules =
            rc::gen::mapcat(rc::gen::inRange<std::size_t>(0, 20), [=](std::size_t size) {
                return rc::gen::container<std::vector<oracle::WrittenInteraction::Rule>>(size,
                                                                                         rule);
            });
        return rc::gen::apply(
            [=](std::size_t length, unsigned seed,
                const std::vector<oracle::WrittenInteraction::Rule>& all) {
                oracle::WrittenInteraction system{letters, {}, "", false};
                std::mt19937 random(seed);
                while (system.axiom.size() < length) system.axiom += letters[random() % count];
                std::set<std::string> known;
                for (const auto& one : all)
                    if (known.insert(one.left + '<' + one.letter + '>' + one.right).second)
                        system.rules.push_back(one);
                return system;
            },
            rc::gen::elementOf(std::vector<std::size_t>{0, 5, 63, 64, 65, 200, 300}),
            rc::gen::arbitrary<unsigned>(), rules);
    });
}

template <class Engine>
void check_engine(const oracle::WrittenInteraction& written, unsigned generations, unsigned& used) {
    const IL system = system_of(written);
    const auto found = windows(system);
    if (!found) return;
    auto engine = Engine::of(system, *found);
    if (!engine) return;
    ++used;
    engine->read(system.axiom);
    std::string expected = written.axiom;
    for (unsigned n = 0; n < generations && expected.size() < 2000; ++n) {
        engine->step({});
        expected = oracle::after(written, expected);
        Word word;
        engine->write(word);
        RC_ASSERT(engine->length() == expected.size());
        RC_ASSERT(oracle::text_of(*system.alphabet, word) == expected);
    }
}

IL written(const std::string& text) { return *as_il(read_lsystem(text, "written.lsys")); }

/// The word after n steps of the automaton alone.
Word by_automaton(const IL& system, unsigned n) {
    ContextAutomaton automaton(system);
    Word word = system.axiom, next;
    for (unsigned i = 0; i < n; ++i) {
        automaton.choose(word, "the word", {});
        automaton.write(next);
        std::swap(word, next);
    }
    return word;
}

std::string automaton_110(std::size_t cells) {
    std::mt19937 random(110);
    std::string text = "axiom ";
    for (std::size_t i = 0; i < cells; ++i) text += random() % 2 ? '1' : '0';
    for (int k = 0; k < 8; ++k)
        text += std::string("; ") + char('0' + k / 4) + " < " + char('0' + k / 2 % 2) + " > " +
                char('0' + k % 2) + " -> " + char('0' + (110 >> k & 1));
    return text;
}

}  // namespace

TEST_CASE("bit planes give the words that the definition gives") {
    unsigned used = 0;
    CHECK(rc::check([&] { check_engine<CellPlanes>(*any_plain(true), 4, used); }));
    CHECK(used > 30);
}

TEST_CASE("tables of windows give the words that the definition gives") {
    unsigned used = 0;
    CHECK(rc::check([&] { check_engine<WindowTable>(*any_plain(false), 4, used); }));
    CHECK(rc::check([&] { check_engine<WindowTable>(*any_plain(true), 4, used); }));
    CHECK(used > 60);
}

TEST_CASE("tables for up to seven bits a letter") {
    for (const unsigned letters : {9u, 17u, 33u, 65u, 100u}) {
        std::string text = "axiom X_0";
        for (unsigned i = 1; i < letters; ++i) text += " X_" + std::to_string(i);
        for (unsigned i = 0; i < letters; ++i)
            text += "; X_" + std::to_string(i * 7 % letters) + " < X_" + std::to_string(i) +
                    " -> X_" + std::to_string((i + 1) % letters) +
                    (i % 3 ? "; X_" + std::to_string(i) + " -> X_" +
                                 std::to_string(i * i % letters) + " X_0"
                           : "");
        const IL system = written(text);
        auto table = WindowTable::of(system, *windows(system));
        REQUIRE(table);
        table->read(system.axiom);
        for (unsigned n = 1; n < 12; ++n) {
            Word word;
            table->step({});
            table->write(word);
            CHECK(word == by_automaton(system, n));
        }
    }
}

TEST_CASE("a long development is the same whoever rewrites it, at any generation") {
    for (const std::string& text :
         {automaton_110(10'000), automaton_110(300),
          std::string("axiom ab; a -> ab; a < b -> bb; b < a > b -> a"),
          std::string("axiom babc; b < a -> ac; c < a > b -> b; a > c -> ; b -> ba")}) {
        const IL system = written(text);
        Development development(system);
        for (unsigned n = 0; n < 30 && development.length() < 200'000; ++n) {
            development.step();
            if (n % 4 == 0) CHECK(development.word() == by_automaton(system, n + 1));
        }
    }
}

TEST_CASE("rule 110 is few instructions, the signal one") {
    const auto instructions = [](const IL& system) {
        const Windows found = *windows(system);
        return WindowProgram(found, window_table(system, found)).instructions().size();
    };
    CHECK(instructions(written(automaton_110(100))) <= 4);
    CHECK(instructions(written("axiom ba; b < a -> b; b -> a")) == 1);
}

TEST_CASE("bounds hold for tables too") {
    Budget budget;
    budget.letters = 100'000;
    CHECK_THROWS_WITH_AS(derive(written("axiom ab; a -> aa; a < b -> bb"), 50, budget),
                         "generation 17 has more than 100000 letters, the bound set", BoundReached);
    Budget small;
    small.memory = 1'000'000;
    Development development(written("axiom ab; a -> aa; a < b -> bb"), small);
    CHECK_THROWS_AS(development.steps(50), BoundReached);
    CHECK(development.length() > 100'000);
}
