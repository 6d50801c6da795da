#include "language/detail/finite_verdicts.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "language/detail/finite_family.hpp"
#include "language/detail/judge.hpp"
#include "notation/notation.hpp"
#include "oracle/finite_systems.hpp"

using namespace algae;
using oracle::FiniteSystems;

namespace {

std::vector<Word> spelled(const std::vector<std::string>& words) {
    std::vector<Word> all;
    for (const std::string& word : words) {
        auto& letters = all.emplace_back();
        for (const char c : word) letters.push_back(static_cast<Symbol>(c - 'a'));
    }
    return all;
}

/// By family, the languages over so many letters, words up to so long, that are found to be of it.
std::array<std::set<std::uint64_t>, 8> found(int letters, std::size_t longest) {
    const auto words = FiniteSystems::words(letters, longest);
    FamilyVerdicts verdicts;
    std::array<std::set<std::uint64_t>, 8> languages;
    for (std::uint64_t bits = 1; bits < std::uint64_t{1} << words.size(); ++bits) {
        const auto families = verdicts.of(spelled(oracle::words_of(words, bits)));
        REQUIRE(families);
        for (std::size_t f = 0; f < 8; ++f)
            if (*families >> f & 1) languages[f].insert(bits);
    }
    return languages;
}

std::vector<std::string> random_words(std::mt19937_64& random, std::size_t most_words,
                                      std::size_t longest, std::size_t letters) {
    std::set<std::string> words;
    const std::size_t count = 1 + random() % most_words;
    for (std::size_t i = 0; i < count; ++i) {
        std::string word;
        for (std::size_t left = random() % (longest + 1); left > 0; --left)
            word += static_cast<char>('a' + random() % letters);
        words.insert(word);
    }
    return {words.begin(), words.end()};
}

/// The least text under all renamings, each tried.
std::string least_text(const std::vector<std::string>& words, std::size_t letters) {
    std::string names = std::string("abcdef").substr(0, letters), least;
    do {
        std::set<std::string> renamed;
        for (std::string word : words) {
            for (char& c : word) c = names[static_cast<std::size_t>(c - 'a')];
            renamed.insert(word);
        }
        std::string text;
        for (const std::string& word : renamed) text += word + ',';
        if (least.empty() || text < least) least = text;
    } while (std::next_permutation(names.begin(), names.end()));
    return least;
}

}  // namespace

TEST_CASE("verdicts without proofs agree with writing down and running all small systems") {
    for (const auto& [letters, longest] : {std::pair{1, 6}, {2, 2}, {3, 1}}) {
        const auto languages = found(letters, static_cast<std::size_t>(longest));
        for (std::size_t f = 0; f < 8; ++f) {
            const Family family = all_families()[f];
            INFO(to_string(family), " ", letters, " ", longest);
            const FiniteSystems systems(letters, static_cast<std::size_t>(longest),
                                        family.propagating, family.deterministic);
            CHECK(languages[f] ==
                  (family.tables ? systems.with_tables() : systems.without_tables()));
        }
    }
}

TEST_CASE("all languages of words of at most three letters a and b, in eight families") {
    const auto languages = found(2, 3);
    CHECK(languages[2] == FiniteSystems(2, 3, false, true).without_tables());
    CHECK(languages[3] == FiniteSystems(2, 3, true, true).without_tables());
    CHECK(languages[6] == FiniteSystems(2, 3, false, true).with_tables());
    CHECK(languages[7] == FiniteSystems(2, 3, true, true).with_tables());
    // The other families by the search that proves what it says.
    std::mt19937_64 random(1);
    const auto words = FiniteSystems::words(2, 3);
    for (int i = 0; i < 1500; ++i) {
        const std::uint64_t bits = 1 + random() % 32767;
        const FiniteLanguage language = finite_language(oracle::words_of(words, bits));
        for (const std::size_t f : {0u, 1u, 4u, 5u}) {
            INFO(to_string(language), " ", to_string(all_families()[f]));
            CHECK((decide_family(language, all_families()[f]).truth == Truth::proved) ==
                  (languages[f].count(bits) > 0));
        }
    }
}

TEST_CASE("verdicts without proofs are those of the search that proves them") {
    std::size_t compared = 0;
    std::array<std::size_t, 8> members{};
    CHECK(rc::check([&](std::uint64_t seed) {
        std::mt19937_64 random(seed);
        const auto words = random_words(random, 6, 4, 1 + random() % 4);
        const bool empty_axiom = random() % 2 == 0;
        const FiniteLanguage language = finite_language(words);
        FamilyVerdicts verdicts(empty_axiom);
        const auto families = verdicts.of(spelled(words));
        if (!families) return;
        FamilyOptions options;
        options.empty_axiom = empty_axiom;
        options.cases = 20'000;
        for (std::size_t f = 0; f < 8; ++f) {
            const FamilyAnswer answer = decide_family(language, all_families()[f], options);
            if (answer.truth == Truth::undecided) continue;
            ++compared;
            const bool in = *families >> f & 1;
            if (in) ++members[f];
            if (in != (answer.truth == Truth::proved))
                RC_FAIL(to_string(language) + " " + to_string(all_families()[f]));
        }
    }));
    CHECK(compared > 500);
    for (const std::size_t count : members) CHECK(count > 0);
}

TEST_CASE("what is remembered of other languages changes no verdict") {
    FamilyVerdicts long_lived;
    CHECK(rc::check([&](std::uint64_t seed) {
        std::mt19937_64 random(seed);
        auto words = random_words(random, 5, 3, 3);
        const auto families = FamilyVerdicts().of(spelled(words));
        RC_ASSERT(long_lived.of(spelled(words)) == families);
        std::reverse(words.begin(), words.end());
        for (std::string& word : words) {
            std::reverse(word.begin(), word.end());
            for (char& c : word) c = static_cast<char>('a' + (c - 'a' + 1) % 3);
        }
        RC_ASSERT(long_lived.of(spelled(words)) == families);
    }));
}

TEST_CASE("languages too large for a verdict have none") {
    std::vector<Word> many;
    for (Symbol i = 0; i < 65; ++i) many.push_back({i});
    CHECK_FALSE(FamilyVerdicts().of(many));
    CHECK_FALSE(FamilyVerdicts().of({Word(1000, 0)}));
    CHECK(FamilyVerdicts().of({}) == 0u);
    CHECK(FamilyVerdicts().of({Word{}}) == 0u);
    CHECK(FamilyVerdicts(true).of({Word{}}) == 255u);
}

TEST_CASE("a text stands for a language up to renaming") {
    std::size_t same = 0, different = 0;
    CHECK(rc::check([&](std::uint64_t seed) {
        std::mt19937_64 random(seed);
        const std::size_t letters = 1 + random() % 5;
        const auto words = random_words(random, 4, 3, letters);
        std::vector<std::size_t> to(letters);
        std::iota(to.begin(), to.end(), 0u);
        std::shuffle(to.begin(), to.end(), random);
        auto other = words;
        for (std::string& word : other)
            for (char& c : word) c = static_cast<char>('a' + to[static_cast<std::size_t>(c - 'a')]);
        std::shuffle(other.begin(), other.end(), random);
        RC_ASSERT(up_to_renaming(spelled(words)) == up_to_renaming(spelled(other)));
        // One letter changed, or two more words of the same length exchanged for others.
        if (!other.front().empty())
            other.front().front() = static_cast<char>('a' + random() % letters);
        if (std::set<std::string>(other.begin(), other.end()).size() != other.size()) return;
        const bool alike = least_text(words, letters) == least_text(other, letters);
        ++(alike ? same : different);
        RC_ASSERT((up_to_renaming(spelled(words)) == up_to_renaming(spelled(other))) == alike);
    }));
    CHECK(same > 10);
    CHECK(different > 10);
}

TEST_CASE("a quick truth is that of the statement's judge") {
    std::size_t known = 0, unknown = 0, proved = 0;
    CHECK(rc::check([&](std::uint64_t seed) {
        std::mt19937_64 random(seed);
        const auto set = [&] {
            const auto words = random_words(random, 3, 2, 2);
            return "{" +
                   joined(words, ", ",
                          [](const std::string& word) {
                              return word.empty() ? std::string("ε") : word;
                          }) +
                   "}";
        };
        const auto rules = [&] {
            const auto images = [&] {
                const auto words = random_words(random, 2, 2, 2);
                return joined(words, " | ", [](const std::string& word) {
                    return word.empty() ? std::string("ε") : word;
                });
            };
            return "let G = 0L { axiom ab; a -> " + images() + "; b -> " + images() + " }\n";
        };
        std::string text = "claim T\n" + rules() + "let A = " + set() + "\nlet B = " + set() +
                           "\nlet h = { a -> b; b -> ab }\n";
        for (const char* said :
             {"A | B is 0L", "A B is D0L", "A & B is T0L", "A \\ B is not PT0L", "A^R is DT0L",
              "h(A) is 0L", "A == B", "A <= A | B", "A is empty", "ab in A B", "|A| = 2",
              "L(G) is finite", "L(G) is D0L", "L(G) is P0L", "L(G) <= A", "|L(G)| = 3",
              "A is 0L and B is 0L", "A is 0L or L(G) is D0L", "L(G) is E0L"})
            text += std::string("show ") + said + "\n";
        const Claim claim = read_claim(text, "t.claim", {});
        const Budget budget;
        QuickJudge quick(claim, budget);
        for (const ClaimedStatement& claimed : claim.statements) {
            const auto truth = quick.truth(claimed.statement);
            ++(truth ? known : unknown);
            if (!truth) continue;
            if (*truth == Truth::proved) ++proved;
            if (*truth != decide(claimed.statement, claim).truth)
                RC_FAIL(text + claimed.statement.text);
        }
    }));
    CHECK(known > 500);
    CHECK(unknown > 50);
    CHECK(proved > 200);
    CHECK(known - proved > 200);
}

TEST_CASE("verdicts of tables with several images of a letter, and of letters with many images") {
    // Two sets of words that only tables with two images of one letter enter.
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"", "aa", "ac", "c", "ca", "cc"},
          {"", "aa", "ab", "b", "ba", "bb"}}) {
        const auto families = FamilyVerdicts().of(spelled(words));
        REQUIRE(families);
        for (std::size_t f = 0; f < 8; ++f)
            CHECK(
                (*families >> f & 1) ==
                (decide_family(finite_language(words), all_families()[f]).truth == Truth::proved));
    }
    // 0L by y -> ε, z -> ε, and three images of x. In closed maps x has as many as the longest word is long, and nine.
    for (std::size_t length = 54; length <= 58; ++length) {
        const auto families =
            FamilyVerdicts().of(spelled({"yxz", std::string(length, 'a'), "b", "bb"}));
        if (families) CHECK((*families & 1) == 1);
        CHECK(families.has_value() == (length + 9 <= 64));
    }
}
