// Languages that compose: what was proved serves later statements, and languages of linear systems are regular.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "exact/exact.hpp"
#include "language/detail/judge.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

using namespace algae;
using Outcome = verify::Finding::Outcome;

namespace {

const std::string systems =
    "let H = 0L { axiom ab; b -> bb | b }\n"
    "let W = D0L { axiom ab; a -> b; b -> a }\n"
    "let G = 0L { axiom a; a -> ab | b }\n"
    "let D = D0L { axiom a; a -> bac }\n"
    "let E = D0L { axiom cab; a -> abb }\n"
    "let P = D0L { axiom a; a -> bc; b -> a; c -> cd }\n";

CheckedClaim checked(const std::string& statements) {
    return check(read_claim("claim T\n" + systems + statements, "x", {}));
}

/// Of each statement: p, r or u, and behind it what verify says of it: c, w, n or u.
std::string verdicts(const std::string& statements) {
    const CheckedClaim claim = checked(statements);
    const auto found = verify::check_certificate(certificate(claim).dump());
    std::string text;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Truth truth = claim.statements[i].answer.truth;
        text += truth == Truth::proved ? 'p' : truth == Truth::refuted ? 'r' : 'u';
        text += found[i].outcome == Outcome::checked     ? "c "
                : found[i].outcome == Outcome::wrong     ? "w "
                : found[i].outcome == Outcome::undecided ? "u "
                                                         : "n ";
    }
    return text;
}

/// A system in whose words all letters are constant but the last or the first one.
std::string random_linear_system() {
    const bool is_last = *rc::gen::arbitrary<bool>();
    const auto word = [&](bool with_active) {
        std::string text;
        for (int left = *rc::gen::inRange(0, 3); left > 0; --left)
            text += *rc::gen::element('x', 'y');
        if (!with_active && *rc::gen::inRange(0, 3) > 0) return text;
        const char active = *rc::gen::element('a', 'b', 'c');
        return is_last ? text + active : active + text;
    };
    const auto or_empty = [](const std::string& text) {
        return text.empty() ? std::string("ε") : text;
    };
    std::string system = "0L { axiom " + word(true);
    for (const char letter : {'a', 'b', 'c'})
        for (int rules = *rc::gen::inRange(1, 3); rules > 0; --rules)
            system += std::string("; ") + letter + " -> " + or_empty(word(false));
    return system + " }";
}

/// All words that are derived and have at most so many letters; the words of linear systems on the way are longer by the
/// active letter at most.
std::set<Word> words_by_definition(const OL& system, std::size_t longest) {
    std::set<Word> seen{system.axiom}, open{system.axiom};
    while (!open.empty()) {
        std::set<Word> next;
        for (const Word& word : open) {
            std::set<Word> made{{}};
            for (const Symbol a : word) {
                std::set<Word> longer;
                for (const Word& beginning : made)
                    for (const Word& successor : system.successors[a]) {
                        Word whole = beginning;
                        whole.insert(whole.end(), successor.begin(), successor.end());
                        longer.insert(std::move(whole));
                    }
                made = std::move(longer);
            }
            for (const Word& word_after : made)
                if (word_after.size() <= longest + 1 && seen.insert(word_after).second)
                    next.insert(word_after);
        }
        open = std::move(next);
    }
    std::erase_if(seen, [&](const Word& word) { return word.size() > longest; });
    return seen;
}

}  // namespace

TEST_CASE(
    "a word of the image of a language with context is found by the first words of the language") {
    const std::string with_context =
        "let C = PDIL { axiom ba; a -> b; b -> bb; ab < a -> b }\n"
        "let Q = IL { axiom a; a -> a; a -> ab; b -> a; b -> b; a < b > b -> ε; a < b > b -> a; b "
        "> b -> ε; b > b -> ab }\n"
        "let R = PIL { axiom a; a -> a; a -> bb; b -> a; a < a > aa -> a; a < a > aa -> ab; a < b "
        "> a -> aa; a < b > a -> b }\n";
    CHECK(verdicts(with_context + "show { a -> ε; b -> b }(L(C)) <= /a/\n"
                                  "show { a -> ε; b -> b }(L(Q)) is empty\n"
                                  "show a in { a -> ε; b -> a }(L(R))\n"
                                  "show { a -> ab; b -> ε }(L(C)) == /(ab)+/\n") == "rc rc pc rc ");
}

TEST_CASE("what is proved of languages serves later statements, and verify checks it") {
    CHECK(verdicts("show L(H) == /ab+/\nshow L(H) is regular\nshow L(H)^R == /b+a/\n"
                   "show { a -> b; b -> a }(L(H)) == /ba+/\nshow L(H) | /ab*/ == /ab*/\n") ==
          "pc pc pc pc pc ");
    CHECK(verdicts("show L(G) == /ab*|b+/\nshow L(H) == /ab+/\nshow L(H) <= L(G)\n"
                   "show L(W) & L(H) == {ab}\nrefute L(G) <= L(H)\n") == "pc pc pc pc rc ");
    // Without the first statement nobody says what L(H) is.
    CHECK(verdicts("show L(H)^R == /b+a/\nshow L(H) == /ab+/\nshow L(H)^R == /b+a/\n") ==
          "uu pc pc ");
    // Each side may be the one with systems, and the fact may be one of an expression.
    CHECK(verdicts("show /ab+/ == L(H)\nshow L(H) L(H) == /ab+ab+/\nshow L(H) is a code\n") ==
          "pc pc pc ");
}

TEST_CASE(
    "linear systems and D0L systems of linear growth are regular or not, without being told") {
    CHECK(verdicts("show L(G) is regular\nshow L(G) == /ab*|b+/\nrefute L(G) == /ab*/\n"
                   "show L(G)^R == /b*a|b+/\nshow L(G) | L(E) is regular\n") == "pc pc rc pc pc ");
    CHECK(verdicts("show L(E) is regular\nshow L(E) == /ca(bb)*b/\n") == "pc pc ");
    CHECK(verdicts("show not L(D) is regular\nshow L(D) is CF\n") == "pc pc ");
}

TEST_CASE("the expression of a linear system has the words that it derives") {
    std::size_t compared = 0, words = 0;
    CHECK(rc::check([&] {
        const std::string text = *rc::gen::resize(100, rc::gen::exec(random_linear_system));
        const Claim claim =
            read_claim("claim T\nlet G = " + text + "\nshow L(G) is regular\n", "x", {});
        const Language generated =
            std::get<InFamily>(claim.statements.front().statement.says).language;
        const auto forms = likely_forms(generated);
        RC_ASSERT(forms.size() == 1);
        const auto regular = regular_value(forms.front(), *claim.alphabet);
        RC_ASSERT(regular);
        const std::size_t longest = 5;
        const std::set<Word> wanted =
            words_by_definition(without_terminals(*generated->system->tables), longest);
        const auto found = words_up_to(*regular, longest);
        RC_ASSERT(std::set<Word>(found.begin(), found.end()) == wanted);
        const CheckedClaim decided = check(claim);
        RC_ASSERT(decided.statements.front().answer.truth == Truth::proved);
        RC_ASSERT(verify::check_certificate(certificate(decided).dump()).front().outcome ==
                  Outcome::checked);
        ++compared;
        words += wanted.size();
    }));
    MESSAGE(compared << " systems compared, " << words << " words");
    CHECK(compared >= 100);
}

TEST_CASE("a false fact is found wrong, and so is one of a system that is not linear") {
    const auto written = certificate(checked("show L(G) is regular\n"));
    const auto outcome = [](const nlohmann::ordered_json& one) {
        return verify::check_certificate(one.dump()).front();
    };
    const auto& proof = written["statements"][0]["proof"];
    REQUIRE(proof["by"] == "facts");
    CHECK(outcome(written).outcome == Outcome::checked);
    auto other = written;
    other["statements"][0]["proof"]["facts"][0]["equal"][1] = {{"words", {"a"}}};
    CHECK(outcome(other).outcome == Outcome::wrong);
    other = written;  // D is not linear: a stands between b and c
    other["statements"][0]["statement"]["language"]["generated"] = "D";
    other["statements"][0]["proof"]["facts"][0]["equal"][0]["generated"] = "D";
    CHECK(outcome(other).reason == "a system is not linear");
    other = written;  // the fact is put into nothing
    other["statements"][0]["statement"]["language"]["generated"] = "H";
    CHECK(outcome(other).outcome != Outcome::checked);
    other = written;
    other["statements"][0]["proof"]["facts"][0]["replaced"] = 1;
    CHECK(outcome(other).outcome != Outcome::checked);
    other = written;
    other["statements"][0]["verdict"] = "refuted";
    CHECK(outcome(other).outcome == Outcome::wrong);
}

TEST_CASE(
    "a system with all rules of another one, from whose axiom it comes to the other's, derives all "
    "that the other does") {
    const std::string some =
        "let X = 0L { axiom b; a -> bb; b -> ε | a }\n"
        "let Y = 0L { axiom b; a -> bb; b -> ε | a }\n"
        "let Z = 0L { axiom a; a -> bb | b; b -> ε | a | ba }\n"
        "let T = PDT0L { axiom aab; table t; a -> b; b -> a; table u; a -> aa; b -> a }\n"
        "let U = PDT0L { axiom bba; table t; a -> b; b -> a; table u; a -> aa; b -> a }\n"
        "let V = PT0L { axiom aab; table u; a -> aa | b; b -> a; table t; a -> b; b -> a; table w; "
        "a -> a; b -> ab }\n"
        "let M = E0L { axiom aa; terminals a b; S -> aS | aa; a -> bS; b -> ε | SS }\n"
        "let N = E0L { axiom aa; terminals a b; S -> aS | aa; a -> ε | bS; b -> ε | SS }\n"
        "let I = PIL { axiom ab; a -> bb; b -> b; a > a -> ab; b < b -> ab; ba < b -> b | bb }\n"
        "let J = PIL { axiom ab; a -> bb; b -> a | b; a > a -> ab; b < b -> ab; ba < b -> b | bb "
        "}\n"
        "let K = 1L { axiom ab; a > b -> aa }\n"
        "let L = 1L { axiom ab; a > b -> aa; a -> b }\n";
    CHECK(verdicts(some + "show L(X) <= L(Y); show L(X) == L(Y); show L(X) <= L(Z)") ==
          "pc pc pc ");
    CHECK(verdicts(some + "show L(U) <= L(T); show L(T) == L(U); show L(T) <= L(V)") ==
          "pc pc pc ");
    CHECK(verdicts(some + "show L(M) <= L(N); show L(I) <= L(J)") == "pc pc ");
    CHECK(verdicts(some + "show L(K) <= L(L)") ==
          "rc ");  // a new context takes the place of another one
    const CheckedClaim claim =
        checked(some + "show L(U) <= L(T); show L(X) <= L(Z); show L(M) <= L(N)");
    const auto said = [&](std::size_t i) {
        std::string text;
        for (const std::string& each : sentences(claim.statements[i].answer, *claim.claim.alphabet))
            text += (text.empty() ? "" : " ") + each;
        return text;
    };
    CHECK(said(0) ==
          "All rules of each table of U are rules of one table of T, which derives bba, the axiom "
          "of U. So T derives all that U does.");
    CHECK(said(1) ==
          "All rules of X are rules of Z, which derives b, the axiom of X. So Z derives all that X "
          "does.");
    CHECK(said(2) ==
          "All rules of M are rules of N, and both systems have the same axiom. So N derives all "
          "that M does.");
}

TEST_CASE(
    "a language with the empty word is of no propagating family, with terminals or contexts too") {
    const std::string some =
        "let X = T0L { axiom ab; table t; a -> ab | b; b -> ε | ba; table u; a -> b; b -> ε }\n"
        "let Y = DT0L { axiom baa; table t; a -> b; b -> b; table u; a -> ε; b -> ε }\n"
        "let Z = PD1L { axiom bba; a -> b; b -> a; a > a -> b; b > b -> ab }\n";
    CHECK(
        verdicts(some +
                 "show L(X) is PIL; show L(X) is PD1L; show L(X) is EPT0L; show L(Y) is EPDT0L") ==
        "rn rn rn rn ");
    CHECK(verdicts(
              some +
              "show L(Z) is EPT0L; show L(Z) is EP0L; show L(Z) is EPDT0L; show {ab} is EPD0L") ==
          "pn pn pn pn ");
    CHECK(verdicts(some + "show L(Y) is EPD0L; show L(Z) is EPD0L; show {a, ε} is ED0L") ==
          "rn uu uu ");
}

TEST_CASE(
    "the first words of a system with context tell that a language is not empty, before all of its "
    "words are looked for") {
    const CheckedClaim claim = [] {
        std::size_t checks = 0;
        const std::function<void()> count = [&checks] { ++checks; };
        Budget budget;
        budget.at_check = &count;
        CheckedClaim found = check(read_claim("claim T\nlet X = P1L { axiom aaa; a -> ab; b -> aa "
                                              "| ba; a > b -> b | bb; b > b -> a | aa; "
                                              "b > a -> bb }\nshow a in factors(X)",
                                              "x", {}),
                                   budget);
        CHECK(checks < 1'000);
        return found;
    }();
    CHECK(claim.statements[0].answer.truth == Truth::proved);
    const std::string some =
        "let X = PDIL { axiom baa; a < a -> aa; aa < a -> ba }\n"
        "let Y = PD1L { axiom aaa; b -> bb; b > a -> a; b > b -> ab; a > a -> bb }\n"
        "let Z = PDIL { axiom baaa; a < a -> aa; aa < a -> ba }\n";
    CHECK(verdicts(some + "show L(X) L(Z) is not empty; show L(X)^R L(H) is not empty; show ~L(Y) "
                          "is not empty") == "pc pc pc ");
}

TEST_CASE("an undecided answer names the theorem by which no method decides all such questions") {
    const CheckedClaim claim = checked(
        "let X = 0L { axiom S; S -> aSb | ab | S }\n"
        "let Y = 0L { axiom S; S -> aSb | aaSbb | ab | S }\n"
        "let F = E0L { axiom S; terminals a b; S -> aSb | ab | S }\n"
        "show L(Y) <= L(X); show L(X) == L(Y); show L(F) is regular");
    const auto names = [&](std::size_t i, const std::string& theorem) {
        const CheckedStatement& found = claim.statements.at(i);
        CHECK(found.answer.truth == Truth::undecided);
        std::string text;
        for (const std::string& each : sentences(found.answer, *claim.claim.alphabet)) text += each;
        CHECK_MESSAGE(text.find(theorem) != std::string::npos, text);
    };
    names(0, "Inclusion of 0L languages is undecidable, as their equality is (Blattner 1973)");
    names(1, "Equality of 0L languages is undecidable (Blattner 1973)");
    names(2, "is regular is undecidable (Bar-Hillel, Perles and Shamir 1961)");
}
