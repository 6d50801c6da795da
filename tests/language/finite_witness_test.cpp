#include "language/detail/finite_family.hpp"

#include <doctest/doctest.h>

#include "oracle/finite_systems.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

FiniteWitness witness_of(const std::vector<std::string>& words, const std::string& family) {
    return decide_family(finite_language(words), family_named(family)).witness.value();
}

}  // namespace

TEST_CASE("a witness is a system, and deriving with it gives the language") {
    const auto words = oracle::FiniteSystems::words(2, 2);
    for (std::uint64_t bits = 1; bits < std::uint64_t{1} << words.size(); ++bits) {
        const FiniteLanguage language = finite_language(oracle::words_of(words, bits));
        for (const char* name : {"0L", "P0L", "D0L", "PD0L"}) {
            const Family family = family_named(name);
            const FamilyAnswer answer = decide_family(language, family);
            if (!answer.witness) continue;
            INFO(to_string(language), " ", name, " ", to_string(*answer.witness));
            const LSystem system = to_lsystem(*answer.witness);
            CHECK(words_up_to(as_ol(system).value(), 5) == language.words);
            CHECK((!family.deterministic || class_of(system).deterministic));
            CHECK((!family.propagating || class_of(system).propagating));
        }
    }
}

TEST_CASE("tables have names") {
    const LSystem system = to_lsystem(witness_of({"", "aa", "ab", "ba", "bb"}, "T0L"), "all pairs");
    CHECK(system.name == "all pairs");
    CHECK(system.tables == std::vector<std::string>{"1", "2"});
    CHECK(class_of(system).name() == "T0L");
    CHECK(as_ol(system).reason() != "");
}

TEST_CASE("a system that generates something else, or is of another family, is no witness") {
    const FiniteLanguage language = finite_language({"", "a", "aa"});
    const FiniteWitness good = witness_of({"", "a", "aa"}, "0L");
    CHECK(generates(good, language, Family{}));
    CHECK_FALSE(generates(good, language, family_named("P0L")));
    CHECK_FALSE(generates(good, language, family_named("D0L")));
    CHECK_FALSE(generates(good, finite_language({"", "a"}), Family{}));
    CHECK_FALSE(generates(good, finite_language({"", "a", "aa", "aaa"}), Family{}));
    FiniteWitness bad = good;
    bad.axiom = Word{0};
    CHECK_FALSE(generates(bad, language, Family{}));
    bad = good;
    bad.tables[0][0].push_back(Word{0, 0});
    CHECK_FALSE(generates(bad, language, Family{}));
    bad = good;
    bad.tables.push_back(bad.tables[0]);
    CHECK_FALSE(generates(bad, language, Family{}));
    CHECK(generates(bad, language, family_named("T0L")));
}

TEST_CASE("no rule of a witness can be left out") {
    const std::vector<std::vector<std::string>> languages{{"", "a", "b", "aa", "ab", "bb"},
                                                          {"", "a", "aa"},
                                                          {"", "aa", "ac", "c", "ca", "cc"},
                                                          {"aa", "ab", "ba", "bb"},
                                                          {"", "aa", "ab", "ba", "bb"}};
    for (const auto& words : languages)
        for (const char* name : {"0L", "P0L", "T0L", "PT0L"}) {
            const FiniteLanguage language = finite_language(words);
            const Family family = family_named(name);
            const FamilyAnswer answer = decide_family(language, family);
            if (!answer.witness) continue;
            CAPTURE(to_string(*answer.witness));
            CHECK(generates(*answer.witness, language, family));
            for (std::size_t t = 0; t < answer.witness->tables.size(); ++t)
                for (std::size_t a = 0; a < answer.witness->tables[t].size(); ++a)
                    for (std::size_t i = 0; i < answer.witness->tables[t][a].size(); ++i) {
                        FiniteWitness fewer = *answer.witness;
                        auto& images = fewer.tables[t][a];
                        if (images.size() == 1) continue;
                        images.erase(images.begin() + static_cast<std::ptrdiff_t>(i));
                        CHECK_FALSE(generates(fewer, language, family));
                    }
        }
}

TEST_CASE("a witness with tables that have one image of each letter stays within the language") {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"cb", "acd", "bac", "dbac"}, {"ab", "ba", "bb"}}) {
        const FiniteLanguage language = finite_language(words);
        for (const char* name : {"D0L", "PD0L", "DT0L", "PDT0L"}) {
            const Family family = family_named(name);
            const FamilyAnswer answer = decide_family(language, family);
            if (answer.witness)
                CHECK(generates(*answer.witness, language, family));
            else
                CHECK(flaw_in(answer.obstruction.value()).value_or("sound") == "sound");
        }
    }
}
