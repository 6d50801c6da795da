#include "language/detail/finite_family.hpp"

#include <doctest/doctest.h>

#include "language/detail/proof.hpp"

using namespace algae;

namespace {

std::string said(const std::vector<std::string>& words, const std::string& family) {
    const FiniteLanguage language = finite_language(words);
    const FamilyAnswer answer = decide_family(language, family_named(family));
    if (answer.witness)
        return to_string(language) + " is " + family + ": " + to_string(*answer.witness) + ".";
    std::string text;
    for (const std::string& line : marked_proof(answer.obstruction.value()))
        text += plain(line) + "\n";
    return text;
}

}  // namespace

TEST_CASE("why {a, aa}, the union of two 0L languages, is not 0L") {
    CHECK(said({"a", "aa"}, "0L") ==
          "{a, aa} is not 0L.\n"
          "Suppose that a system generates it. Each letter occurs in a word of the language, and "
          "what that word gives is in "
          "the language again. So an image of a letter is one of the factors of its words: ε, a or "
          "aa.\n"
          "a -> ε is impossible: a would give ε, which is not in the language.\n"
          "a -> aa is impossible: aa would give aaaa, which is not in the language.\n"
          "a -> a is left.\n"
          "By what is left, no other word gives a, and no other word gives aa. The axiom is not "
          "both, so one of these words is "
          "never reached.\n"
          "So {a, aa} is not 0L.\n");
}

TEST_CASE("a proof by cases") {
    CHECK(
        said({"", "aa", "ab", "ba", "bb"}, "0L") ==
        "{ε, aa, ab, ba, bb} is not 0L.\n"
        "Suppose that a system generates it. Each letter occurs in a word of the language, and "
        "what that word gives is in "
        "the language again. So an image of a letter is one of the factors of its words: ε, a, b, "
        "aa, ab, ba or bb.\n"
        "a -> aa | ab | ba | bb are impossible: aa would give aaaa, abab, baba or bbbb, which are "
        "not in the language.\n"
        "b -> aa | ab | ba | bb are impossible: bb would give aaaa, abab, baba or bbbb, which are "
        "not in the language.\n"
        "a -> ε | a | b and b -> ε | a | b are left.\n"
        "By a -> ε | a, aa gives a, which is not in the language. So a -> ε or a -> a is missing.\n"
        "Case 1: a -> ε is missing.\n"
        "  b -> ε is impossible: whichever of the rules left for a goes with it, ab would give no "
        "word of the language.\n"
        "  a -> a | b and b -> a | b are left.\n"
        "  No other word gives ε, and the axiom is not empty, so ε is never reached.\n"
        "Case 2: a -> ε is there, a -> a is missing.\n"
        "  a -> b is impossible: by a -> ε | b, aa gives b, which is not in the language.\n"
        "  b -> a | b are impossible: with a -> ε, all that is left for a, ab would give a or b, "
        "which are not in the "
        "language.\n"
        "  a -> ε and b -> ε are left.\n"
        "  By what is left, no other word gives aa, and no other word gives ab. The axiom is not "
        "both, so one of these words "
        "is never reached.\n"
        "So {ε, aa, ab, ba, bb} is not 0L.\n");
}

TEST_CASE("all tables at once") {
    CHECK(said({"", "aa", "aaa"}, "T0L") ==
          "{ε, aa, aaa} is not T0L.\n"
          "Suppose that a system generates it. Each letter occurs in a word of the language, and "
          "what that word gives is in "
          "the language again. So an image of a letter, in any table, is one of the factors of its "
          "words: ε, a, aa or aaa.\n"
          "a -> aa | aaa are impossible: aa would give aaaa or aaaaaa, which are not in the "
          "language.\n"
          "a -> ε | a are left.\n"
          "No table has a -> ε | a together: by a -> ε | a, aa gives a, which is not in the "
          "language.\n"
          "By what is left, no other word gives aa, and no other word gives aaa. The axiom is not "
          "both, so one of these words "
          "is never reached.\n"
          "So {ε, aa, aaa} is not T0L.\n");
}

TEST_CASE("one image for each letter") {
    CHECK(said({"aa", "ab", "ba", "bb"}, "PD0L") ==
          "{aa, ab, ba, bb} is not PD0L.\n"
          "Suppose that a system generates it. Each letter occurs in a word of the language, and "
          "what that word gives is in "
          "the language again. So an image of a letter is one of the factors of its words other "
          "than ε: a, b, aa, ab, ba or "
          "bb.\n"
          "a -> aa | ab | ba | bb are impossible: aa would give aaaa, abab, baba or bbbb, which "
          "are not in the language.\n"
          "b -> aa | ab | ba | bb are impossible: whichever of the rules left for a goes with "
          "them, ab would give no word of "
          "the language.\n"
          "a -> a | b and b -> a | b are left.\n"
          "Case 1: a -> a.\n"
          "  By what is left, no other word gives ab, and no other word gives ba. The axiom is not "
          "both, so one of these words "
          "is never reached.\n"
          "Case 2: a -> b.\n"
          "  Case 2.1: b -> a.\n"
          "    By what is left, no word outside {aa, bb} gives a word of it, and no word outside "
          "{ab, ba} gives a word of it. "
          "The axiom is not in both, so the words of one are never reached.\n"
          "  Case 2.2: b -> b.\n"
          "    By what is left, no other word gives aa, and no other word gives ab. The axiom is "
          "not both, so one of these "
          "words is never reached.\n"
          "So {aa, ab, ba, bb} is not PD0L.\n");
}

TEST_CASE("a system is a proof, a bound is none") {
    CHECK(said({"a"}, "PD0L") == "{a} is PD0L: axiom a; a -> a.");
    CHECK(said({"", "a", "aa"}, "0L") == "{ε, a, aa} is 0L: axiom aa; a -> ε | a.");
    CHECK(said({"", "aa", "ab", "ba", "bb"}, "T0L") ==
          "{ε, aa, ab, ba, bb} is T0L: axiom bb; [a -> a; b -> a | b]; [a -> ε; b -> ε].");
    CHECK(said({}, "0L").find("The axiom would be a word of the language, but there is none.") !=
          std::string::npos);
    FamilyOptions options;
    options.cases = 0;
    const FiniteLanguage language = finite_language({"a"});
    CHECK(decide_family(language, Family{}, options).truth == Truth::undecided);
}

TEST_CASE("a rule that no table has stands alone, two stand together") {
    CHECK(said({"ab", "ac", "cb"}, "T0L").find("No table has c -> ab. Suppose one has:") !=
          std::string::npos);
    CHECK(said({"", "aa", "aaa"}, "T0L").find("No table has a -> ε | a together: ") !=
          std::string::npos);
}
