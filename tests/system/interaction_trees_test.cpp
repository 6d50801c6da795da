#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <sstream>
#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/interaction.hpp"
#include "system/detail/interaction.hpp"

using namespace algae;

namespace {

IL system_of(const std::string& text) { return *as_il(read_lsystem(text, "written.lsys")); }

std::string reason(const std::string& text) { return as_il(read_lsystem(text, "w.lsys")).reason(); }

std::string word(const IL& system, std::uint64_t n) {
    return spell(*system.alphabet, derive(system, n));
}

/// One step of these rules and settings from the word.
std::string once(const std::string& axiom, const std::string& rules) {
    return word(system_of("axiom " + axiom + "; " + rules), 1);
}

void check_against_oracle(const oracle::WrittenInteraction& written) {
    std::ostringstream text;
    text << written;
    Development development(system_of(text.str()));
    std::string expected = written.axiom;
    for (unsigned n = 0; n < 5 && expected.size() < 400; ++n) {
        RC_ASSERT(oracle::text_of(read_lsystem(text.str(), "w").alphabet, development.word()) ==
                  expected);
        if (written.trees && oracle::balanced(expected) != expected) {
            RC_ASSERT_THROWS_AS(development.step(), Error);
            return;
        }
        expected = oracle::after(written, expected);
        development.step();
    }
}

}  // namespace

TEST_CASE("the example of the documents: BC < S > G[H]M") {
    const std::string rule = "BC < S > G[H]M -> X";
    CHECK(once("ABC[DE][SG[HI[JK]L]MNO]", rule) == "ABC[DE][XG[HI[JK]L]MNO]");
    // As one document prints the word, the axis goes on with L after G.
    CHECK(once("ABC[DE][SG[HI][JK]L]MNO", rule) == "ABC[DE][SG[HI][JK]L]MNO");
}

TEST_CASE("the left context is the path to the root") {
    CHECK(once("a[b][c]d", "a < d -> x") == "a[b][c]x");
    CHECK(once("a[b][c]d", "b < d -> x") == "a[b][c]d");
    CHECK(once("a[[[d]]]", "a < d -> x") == "a[[[x]]]");
    CHECK(once("ab[c[e]]d[f]", "abd < f -> x") == "ab[c[e]]d[x]");
}

TEST_CASE("the right context is a tree: named branches in order, the others skipped") {
    CHECK(once("a[b]c", "a > c -> x") == "x[b]c");
    CHECK(once("a[b]c", "a > b -> x") == "a[b]c");
    CHECK(once("a[b]c", "a > [b] -> x") == "x[b]c");
    CHECK(once("a[b][c]d", "a > [b][c]d -> x") == "x[b][c]d");
    CHECK(once("a[b][c]d", "a > [c][b] -> x") == "a[b][c]d");
    CHECK(once("a[b][e][c]d", "a > [b][c]d -> x") == "x[b][e][c]d");
    CHECK(once("a[b]", "a > [b][b] -> x") == "a[b]");
    CHECK(once("a[bc]", "a > [c] -> x") == "a[bc]");
    CHECK(once("a[b[e]c[f]g]h", "a > [bc[f]]h -> x") == "x[b[e]c[f]g]h");
    CHECK(once("a[[b]]", "a > [[b]] -> x") == "x[[b]]");
    CHECK(once("a[[b]]", "a > [b] -> x") == "a[[b]]");
    CHECK(once("a[e]", "a > [] -> x") == "x[e]");
    // A branch ends where it is closed.
    CHECK(once("[a]b", "a > b -> x") == "[a]b");
}

TEST_CASE("ignored letters are not seen between branches either") {
    CHECK(once("a+[+b]+c", "a > [b]c -> x; ignore +") == "x+[+b]+c");
    CHECK(once("a[+b]", "a < b -> x; ignore +") == "a[+x]");
    CHECK(once("a[b]c", "a > bc -> x; ignore [ ]") == "x[b]c");
    CHECK(once("a+", "a > + -> x; ignore +") == "a+");
}

TEST_CASE("brackets count for nothing when the longest context is sought") {
    CHECK(once("a[b]cd", "a > [b]c -> x; a > cd -> y") == "x[b]cd");
    CHECK(once("a[b]cd", "a > cd -> y; a > [b]c -> x") == "y[b]cd");
    CHECK(once("a[b]cd", "a > [b] -> x; a > cd -> y") == "y[b]cd");
}

TEST_CASE("brackets are rewritten where rules say so") {
    CHECK(once("a[b]c", "a < [ > b -> x; b < ] > c -> y") == "axbyc");
    CHECK(once("a[b]c", "a < [ > c -> x; a < ] -> y; ] > b -> z") == "a[b]c");
    CHECK(once("a[b][c]", "a < [ > c -> []x; c < ] -> y") == "a[b][]xcy");
    CHECK(once("a[b]c", "[ -> ; ] -> ") == "abc");
}

TEST_CASE("brackets that do not match are refused, with the generation") {
    const IL unmatched = system_of("axiom a[b]; b < ] -> c");
    CHECK(word(unmatched, 1) == "a[bc");
    CHECK_THROWS_WITH_AS(derive(unmatched, 2),
                         "generation 1 has a '[' that is never closed, at letter 2", Error);
    CHECK_THROWS_WITH_AS(derive(system_of("axiom [b]; [ > b -> c"), 2),
                         "generation 1 has an unmatched ']'", Error);
    CHECK(reason("axiom a[b]; a[b] < c -> d") ==
          "not an IL system: the rule at w.lsys:1:13 has a bracket in its left context, "
          "which is a path and has no branches");
    CHECK(reason("axiom a[b]; a > b -> d; ignore [") ==
          "not an IL system: it ignores one bracket and not the other");
}

TEST_CASE("words with and without brackets, by the automaton and by building the tree") {
    CHECK(rc::check("words", [] { check_against_oracle(*oracle::any_interaction(false)); }));
    CHECK(rc::check("trees", [] { check_against_oracle(*oracle::any_interaction(true)); }));
}
