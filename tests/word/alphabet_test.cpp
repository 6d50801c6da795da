#include "word/word.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <set>

#include "oracle/random_systems.hpp"

using namespace algae;

TEST_CASE("an alphabet numbers names in the order in which they come") {
    Alphabet alphabet;
    CHECK(alphabet.symbol("b") == 0);
    CHECK(alphabet.symbol("F_l") == 1);
    CHECK(alphabet.symbol("b") == 0);
    CHECK(alphabet.size() == 2);
    CHECK(alphabet.find("F_l") == 1);
    CHECK(!alphabet.find("F"));
    CHECK(alphabet.name(1) == "F_l");
    CHECK_THROWS(alphabet.name(2));
}

TEST_CASE("ranks follow the code points of names") {
    Alphabet alphabet;
    for (const char* name : {"b", "α", "a", "ab", "B"}) alphabet.symbol(name);
    CHECK(alphabet.ranks() == std::vector<std::uint32_t>{3, 4, 1, 2, 0});
}

TEST_CASE("short names are one character, or a letter with a subscript of one letter or digits") {
    for (const char* name : {"a", "α", "+", "F_l", "X_12", "a_β", "?E", "?E_1"})
        CHECK_MESSAGE(is_short_name(name), name);
    for (const char* name : {"", "ab", "wall", "F_", "F_ab", "F_1a", "αβ", "?wall"})
        CHECK_MESSAGE(!is_short_name(name), name);
}

TEST_CASE("words are spelled with blanks only where they are needed") {
    Alphabet alphabet;
    const auto spelled = [&](std::initializer_list<const char*> names) {
        Word word;
        for (const char* name : names) word.push_back(alphabet.symbol(name));
        return spell(alphabet, word);
    };
    CHECK(spelled({}) == "ε");
    CHECK(spelled({"F_l", "+", "F_r"}) == "F_l+F_r");
    CHECK(spelled({"X_1", "2"}) == "X_1 2");
    CHECK(spelled({"X_1", "a"}) == "X_1a");
    CHECK(spelled({"X", "_", "1"}) == "X _1");
    CHECK(spelled({"2", "2"}) == "22");
}

TEST_CASE("a long name has blanks around it") {
    Alphabet alphabet;
    const Word word{alphabet.symbol("wall"), alphabet.symbol("F"), alphabet.symbol("wall"),
                    alphabet.symbol("wall")};
    CHECK(spell(alphabet, word) == "wall F wall wall");
}

TEST_CASE("short names that together look like a declared name are kept apart") {
    Alphabet alphabet;
    const Symbol w = alphabet.symbol("w"), a = alphabet.symbol("a"), l = alphabet.symbol("l");
    CHECK(spell(alphabet, {w, a, l, l}) == "wall");
    alphabet.symbol("wall");
    CHECK(spell(alphabet, {w, a, l, l}) == "w all");
    CHECK(spell(alphabet, {w, l, a, l}) == "wlal");
}

TEST_CASE("what is spelled is read back, and the monoid of spellings spells the same") {
    const bool holds = rc::check("texts are unambiguous", [] {
        static const std::vector<std::string> pool{"a",  "b", "X",   "X_1",  "X_12", "X_a", "1",
                                                   "2",  "_", "F_l", "+",    "ab",   "aba", "ba",
                                                   "αβ", "α", "β",   "b_1a", "X_1a", "-",   "β_2"};
        const auto names = *rc::gen::unique<std::vector<std::string>>(rc::gen::elementOf(pool));
        RC_PRE(!names.empty());
        Alphabet alphabet;
        std::set<std::string> declared;
        for (const std::string& name : names) {
            alphabet.symbol(name);
            if (!is_short_name(name)) declared.insert(name);
        }
        const auto word = *rc::gen::container<Word>(
            rc::gen::inRange<Symbol>(0, static_cast<Symbol>(names.size())));
        std::vector<std::string> written;
        for (const Symbol a : word) written.push_back(alphabet.name(a));
        if (word.empty()) {
            RC_ASSERT(spell(alphabet, word) == "ε");
            return;
        }
        RC_ASSERT(oracle::names_in(spell(alphabet, word), declared) == written);
        const Spellings spellings(alphabet);
        auto text = spellings.one();
        for (const Symbol a : word) spellings.append(text, spellings.letter(a));
        RC_ASSERT(text.text == spell(alphabet, word));
    });
    CHECK(holds);
}
