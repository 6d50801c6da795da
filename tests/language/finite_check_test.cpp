#include "verify/verify.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>

#include "language/detail/finite_family.hpp"
#include "oracle/finite_systems.hpp"

using namespace algae;
using oracle::FiniteSystems;

namespace {

const std::vector<std::string> all_words = FiniteSystems::words(2, 2);

/// A language over a and b, whichever of them occurs in it.
FiniteLanguage language_of(std::uint64_t bits) {
    static const auto alphabet = finite_language({"ab"}).alphabet;
    std::vector<Word> words;
    for (const std::string& word : oracle::words_of(all_words, bits)) {
        Word& symbols = words.emplace_back();
        for (const char letter : word)
            symbols.push_back(alphabet->find(std::string(1, letter)).value());
    }
    return make_finite_language(alphabet, std::move(words));
}

/// Changes one field somewhere in a case or below it.
void change(ObstructionCase& part, const FiniteLanguage& language) {
    const auto any_word = [&] { return Word(*rc::gen::elementOf(language.words)); };
    const auto letters = letters_of(language);
    const auto any_letter = [&] {
        return letters.empty() ? Symbol{0} : *rc::gen::elementOf(letters);
    };
    const auto below = [](std::size_t size) { return *rc::gen::inRange<std::size_t>(0, size); };
    if (!part.cases.empty() && *rc::gen::arbitrary<bool>())
        return change(part.cases[below(part.cases.size())], language);
    switch (*rc::gen::inRange(0, 11)) {
        case 0:
            part.end = static_cast<ObstructionCase::End>(below(5));
            break;
        case 1:
            part.letter = any_letter();
            break;
        case 2:
            part.sources.push_back({any_word()});
            break;
        case 3:
            if (!part.sources.empty()) part.sources.pop_back();
            break;
        case 4:
            part.sources = {{any_word()}, {any_word()}};
            break;
        case 5:
            part.rules.clear();
            part.cases.clear();
            break;
        case 6:
            part.cases.emplace_back();
            break;
        case 7:
            if (!part.excluded.empty())
                part.excluded.erase(part.excluded.begin() +
                                    static_cast<std::ptrdiff_t>(below(part.excluded.size())));
            break;
        case 8:
            part.excluded.push_back({{any_letter(), any_word()}, any_word(), {}});
            break;
        case 9:
            part.word = any_word();
            part.images.assign(part.word.size(), any_word());
            for (std::size_t i = 0; i < part.word.size(); ++i)
                part.rules.push_back({part.word[i], part.images[i]});
            part.cases.resize(part.rules.size());
            break;
        case 10:
            if (!part.excluded.empty())
                part.excluded[below(part.excluded.size())].images.assign(1, any_word());
            break;
    }
}

}  // namespace

TEST_CASE("no changed proof passes for something false") {
    const auto truths = [] {
        std::map<std::string, std::set<std::uint64_t>> all;
        for (const Family family : all_families()) {
            const FiniteSystems systems(2, 2, family.propagating, family.deterministic);
            all[to_string(family)] =
                family.tables ? systems.with_tables() : systems.without_tables();
        }
        return all;
    }();
    CHECK(rc::check([&] {
        // A proof about one language and family, said of a language that is of the family: of another
        // language, or of the same and a larger family.
        const auto bits = *rc::gen::inRange<std::uint64_t>(1, std::uint64_t{1} << all_words.size());
        const auto answer = decide_family(language_of(bits), *rc::gen::elementOf(all_families()));
        if (!answer.obstruction) return;
        FamilyObstruction proof = *answer.obstruction;
        proof.family = *rc::gen::elementOf(all_families());
        const auto& truth = truths.at(to_string(proof.family));
        if (!truth.contains(bits) || *rc::gen::arbitrary<bool>())
            proof.language = language_of(*rc::gen::elementOf(truth));
        RC_ASSERT(flaw_in(proof).has_value());
        for (int changes = *rc::gen::inRange(1, 4); changes > 0; --changes) {
            change(proof.root, proof.language);
            for (ImpossibleTable& table : proof.impossible) change(table.why, proof.language);
            if (!proof.impossible.empty() && !proof.impossible.front().rules.empty() &&
                *rc::gen::arbitrary<bool>())
                proof.impossible.front().rules.pop_back();
        }
        RC_ASSERT(flaw_in(proof).has_value());
    }));
}

TEST_CASE("what is wrong with a proof is said") {
    const FamilyObstruction proof =
        *decide_family(finite_language({"a", "aa"}), Family{}).obstruction;
    REQUIRE(!flaw_in(proof));
    FamilyObstruction bad = proof;
    bad.root.excluded.pop_back();
    CHECK(flaw_in(bad).value_or("sound") == "a may give aa");
    bad = proof;
    bad.root.excluded[0].rule.image = proof.language.words[0];
    CHECK(flaw_in(bad).value_or("sound") == "a can go to a word of the language with a -> a");
    bad = proof;
    bad.root.sources.pop_back();
    CHECK(flaw_in(bad).value_or("sound") == "an axiom may reach all words");
    bad = proof;
    bad.root.sources[1] = bad.root.sources[0];
    CHECK(flaw_in(bad).value_or("sound") == "a is listed twice");
    bad = proof;
    bad.root.end = ObstructionCase::End::choice;
    CHECK(flaw_in(bad).value_or("sound") == "a letter may have more than one image");
    bad = proof;
    bad.family.tables = true;
    CHECK(!flaw_in(bad));  // the same proof says it of all tables
    bad.language = finite_language({"a"});
    CHECK(flaw_in(bad).value_or("sound") == "a -> aa is excluded but was not possible");
    bad = *decide_family(finite_language({"", "aa", "ab", "ba", "bb"}), Family{}).obstruction;
    bad.root.cases.pop_back();
    CHECK(flaw_in(bad).value_or("sound") == "there is not one case for each rule");
    bad.root.rules.pop_back();
    CHECK(flaw_in(bad).value_or("sound") == "the case without a -> a is not looked at");
}
