#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exchange/compared.hpp"
#include "exchange/detail/formats.hpp"
#include "exchange/exchange.hpp"
#include "exchange/slow_cpfg.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

// Contexts, cuts and the number of the step of cpfg, against a derivation that goes through words as the program does.

using namespace algae;
using namespace algae::exchange_tests;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string file(const std::string& rules, const std::string& axiom,
                 const std::string& header = "") {
    return "Lsystem: 1\nderivation length: 1\n" + header + "Axiom: " + axiom + "\n" + rules +
           "endlsystem\n";
}

std::string kept_word(const Model& system, std::uint64_t n) {
    return SlowSystem::text(SlowSystem::kept(own_word(system, n)));
}
std::string kept_word(const std::string& text, std::uint64_t n = 1) {
    return kept_word(read_cpfg(text, "x.l"), n);
}

}  // namespace

TEST_CASE(
    "contexts of cpfg mean what they mean there: the first rule, the first branch, all of a "
    "branch") {
    const std::pair<std::string, const char*> all[] = {
        // The first rule that applies, though another has longer contexts.
        {file("A > B --> X\nBC < A --> Y\n", "BCABCA"), "BCXBCY"},
        {file("A > B --> X\nC < A > B --> Y\nA --> Z\n", "CABAA"), "CXBZZ"},
        {file("A > B : 1 < 0 --> X\nC < A > B --> Y\n", "CABAB"), "CYBAB"},
        // All of a branch, and one that begins so.
        {file("A > [B]C --> Y\n", "A[BDE]CA[B]CA[B[D]]C"), "A[BDE]CY[B]CY[B[D]]C"},
        {file("A > [B=]C --> Y\n", "A[BDE]CA[B]C"), "Y[BDE]CY[B]C"},
        {file("A > [B]C --> Y\n", "A[B+]CA[+B]CA[B+D]C", "ignore: +\n"), "Y[B+]CY[+B]CA[B+D]C"},
        // Two branches, of which the first is named, or both.
        {file("A > [+B=] --> Y\n", "A[+B][-B]A[+C][-B]"), "Y[+B][-B]A[+C][-B]"},
        {file("A > [=][-B=] --> Y\n", "A[+B][-B]A[+C][-C]"), "Y[+B][-B]A[+C][-C]"},
    };
    for (const auto& [text, expected] : all) {
        INFO(text);
        CHECK(kept_word(text) == expected);
    }
    const auto fault = [](const std::string& text) {
        return refusal([&] { read_cpfg(text, "x.l"); });
    };
    // The second branch begins as the context says, which the program does not look at.
    CHECK(holds(fault(file("A > [C=] --> Y\n", "A[B][C]")),
                "x.l:4:5: error: a branch in a context is the first of those that stand together "
                "there, and any of them in the notation: expected words in which no other of them "
                "begins so"));
    CHECK(
        holds(fault(file("A > [C=] --> Y\nD --> *\n", "A[B]D[C]")), "x.l:4:5: error: a branch in"));
    CHECK(fault(file("A > [C=] --> Y\nD --> E\n", "A[B]D[C]")).empty());
    CHECK(holds(fault(file("A > [] --> Y\n", "A[B][]")), "x.l:4:5: error: a branch in"));
    CHECK(kept_word(file("A > [] --> Y\n", "A[B]A[]")) == "A[B]Y[]");
    CHECK(holds(fault(file("A > [[B=]=] --> Y\n", "A[C][[B]]")), "x.l:4:5: error: a branch in"));
    CHECK(holds(fault(file("A > [B][C][D][E][F] --> Y\n", "A[BX][CX][DX][EX][FX]")),
                "x.l:4:1: error: a context with more than 4 whole branches"));
}

TEST_CASE("what % cuts is seen by contexts in the step in which it is cut, and never again") {
    const std::pair<std::string, const char*> all[] = {
        {file("B < A --> X\n", "B[A%C]"), "B[X]"},
        {file("A > C --> X\n", "A%C"), "A"},
        // Skipped, or named.
        {file("A > C --> X\n", "A%C", "ignore: %\n"), "X"},
        {file("A > C --> X\n", "A%C", "consider: AC\n"), "X"},
        {file("A > C --> X\n", "A%C", "consider: AC%\n"), "A"},
        {file("A > % --> X\n", "AA%C"), "AX"},
    };
    for (const auto& [text, expected] : all) {
        INFO(text);
        CHECK(kept_word(text) == expected);
    }
    // The second step does not see what the first one cut: A that comes then finds nothing.
    const std::string later = file("A > C --> X\nD --> A\n", "D%C", "ignore: %\n"),
                      named = file("A > % --> X\nD --> A\n", "D%C");
    CHECK(kept_word(later, 1) == "A");
    CHECK(kept_word(later, 2) == "A");
    CHECK(kept_word(named, 2) == "A");
    // What is drawn ends at % as well, also at one that cuts only in the next step.
    CHECK(figure(read_cpfg(file("F < F --> F\n", "F[F%FF]F", "ignore: %\n"), "x"), 0, {})
              ->segments() == Integer(3));
    const auto fault = [](const std::string& text) {
        return refusal([&] { read_cpfg(text, "x.l"); });
    };
    CHECK(holds(fault(file("C --> ]D\n", "A[B%C]")),
                "x.l:3:11: error: % beside rules that open or close a branch alone"));
}

TEST_CASE("Q is the number of the step, in rules, conditions and decompositions") {
    const std::string counted = file("A : Q < 2 --> AB(Q,Z)\nA --> C(Q*2)\n", "A(Q)A");
    CHECK(kept_word(counted, 0) == "A(0)A");
    CHECK(kept_word(counted, 1) == "A(0)AB(1,1)");
    CHECK(kept_word(counted, 3) == "A(0)C(4)B(1,1)");
    CHECK(kept_word(file("A --> B\ndecomposition\nB : Q > 1 --> C(Q)\n", "AB"), 2) == "C(2)C(2)");
    // A parameter of this name is a parameter.
    CHECK(kept_word(file("A(Q) --> A(Q+5)\n", "A(1)"), 2) == "A(11)");
    CHECK(kept_word(file("A(Q_) --> A(Q_+Q)\n", "A(1)"), 2) == "A(4)");
    const auto fault = [](const std::string& text) {
        return refusal([&] { read_cpfg(text, "x.l"); });
    };
    CHECK(holds(fault(file("A --> A\nhomomorphism\nA --> F(Q)\n", "A")),
                "x.l:6:1: error: Q in a homomorphism is the number of the step, which only rules"));
    CHECK(holds(fault(file("A --> A : Q\nA --> B\n", "A", "seed: 1\n")),
                "expected a weight above 0 as a plain number, found 'Q'"));
}

namespace {

/// A random system as it is read from the text of its file; nothing where the notation cannot say it.
std::optional<Model> read_if_sayable(const SlowSystem& system) {
    const std::string text = system.file();
    RC_LOG() << text;
    try {
        return read_cpfg(text, "any.l");
    } catch (const Diagnostics&) {
        return std::nullopt;
    }
}

}  // namespace

TEST_CASE(
    "random systems of cpfg with contexts, branches, cuts and steps have the words of the "
    "program") {
    std::size_t compared = 0, changed = 0, cut = 0;
    CHECK(rc::check([&] {
        const auto below = [](int from, int to) {
            return *rc::gen::resize(100, rc::gen::inRange(from, to));
        };
        const auto one_of = [](const std::vector<std::string>& all) {
            return *rc::gen::elementOf(all);
        };
        const auto word = [&](int most, bool may_be_empty) {
            SlowWord out;
            const int count = below(may_be_empty ? 0 : 1, most);
            int open = 0;
            for (int i = 0; i < count; ++i) {
                const char c = *rc::gen::elementOf(std::string("AABBCC+[[]]%F"));
                if (c == ']' && open == 0) continue;
                open += c == '[' ? 1 : c == ']' ? -1 : 0;
                const bool counts = c == 'F' && below(0, 2) == 0;
                out.push_back({c, counts ? "Q" : ""});
            }
            for (; open > 0; --open) out.push_back({']', ""});
            return out;
        };
        SlowSystem system;
        system.axiom = word(12, false);
        for (SlowModule& module : system.axiom)
            if (module.value == "Q") module.value = "0";
        system.ignored = one_of({"", "", "+", "%", "+%"});
        const int rules = below(1, 6);
        for (int i = 0; i < rules; ++i) {
            SlowRule rule;
            rule.left = one_of({"", "", "A", "B", "AB", "F"});
            rule.symbol = one_of({"A", "A", "B", "C"})[0];
            rule.right = one_of({"", "", "", "A", "B", "CB", "[B]", "[B=]", "[B]C", "[B=]C", "[=]A",
                                 "[A=][C=]", "[B[C]=]", "[]", "%", "C[B]"});
            if (below(0, 4) == 0) rule.below = below(1, 4);
            rule.successor = word(5, true);
            system.rules.push_back(rule);
        }
        const std::optional<Model> read = read_if_sayable(system);
        if (!read) return;  // a branch that is not the first may be taken for it
        SlowWord slow = system.axiom;
        for (int n = 0; n < 4 && slow.size() < 500; ++n) {
            if (n > 0) {
                const SlowWord next = system.next(slow, n);
                if (SlowSystem::text(next) != SlowSystem::text(slow)) ++changed;
                slow = next;
            }
            if (SlowSystem::kept(slow).size() < slow.size()) ++cut;
            ++compared;
            RC_ASSERT(kept_word(*read, static_cast<std::uint64_t>(n)) ==
                      SlowSystem::text(SlowSystem::kept(slow)));
        }
    }));
    MESSAGE(compared << " words compared, " << changed << " of them other than the one before, "
                     << cut << " with something cut");
    CHECK(compared >= 100);
    CHECK(changed >= 20);
    CHECK(cut >= 10);
}

TEST_CASE("in a ring the last letter stands before the first one") {
    const std::pair<std::string, const char*> all[] = {
        {file("C < A --> X\nA --> Y\n", "ABC", "ring lsystem\n"), "XBC"},
        {file("C > A --> X\n", "ABC", "ring lsystem\n"), "ABX"},
        // The only letter is its own neighbour.
        {file("A < A > A --> X\n", "A", "ring lsystem\n"), "X"},
        {file("A < A > B --> X\n", "A", "ring lsystem\n"), "A"},
        // Numbers go round too, and what contexts skip.
        {file("A(l) < A(x) > A(r) --> A(l+r)\n", "A(1)A(2)A(4)", "ring lsystem\n"), "A(6)A(5)A(3)"},
        {file("A(l) < A(x) --> A(l)\n", "+A(1)+A(2)A(4)+", "ignore: +\nring lsystem\n"),
         "+A(4)+A(1)A(2)+"},
        // Without contexts it means nothing.
        {file("A --> [B]A\n", "A", "ring lsystem\n"), "[B]A"},
    };
    for (const auto& [text, expected] : all) {
        INFO(text);
        CHECK(kept_word(text) == expected);
    }
    // A corner that is cut, again and again.
    const std::string cut =
        file("P(l) < P(x) > P(r) --> P((l+3*x)/4)P((3*x+r)/4)\n", "P(0)P(4)P(8)", "ring lsystem\n");
    CHECK(kept_word(cut) == "P(2)P(1)P(3)P(5)P(7)P(6)");
    CHECK(kept_word(cut, 2) ==
          "P(3)P(1.75)P(1.25)P(1.5)P(2.5)P(3.5)P(4.5)P(5.5)P(6.5)P(6.75)P(6.25)P(5)");
    CHECK(kept_word(
              "#include <lpfgall.h>\nring L-system: 1;\nmodule A(int);\nAxiom: A(1) A(2) A(4);\n"
              "production:\nA(l) < A(x) : { produce A(l/2); }\n") == "A(2)A(0)A(1)");
}

TEST_CASE("random rings of cpfg have the words of the program") {
    std::size_t compared = 0, changed = 0;
    CHECK(rc::check([&] {
        const auto below = [](int from, int to) {
            return *rc::gen::resize(100, rc::gen::inRange(from, to));
        };
        const auto one_of = [](const std::vector<std::string>& all) {
            return *rc::gen::elementOf(all);
        };
        SlowSystem system;
        system.ring = true;
        system.ignored = one_of({"", "+", "+-"});
        const auto word = [&](int least, int most) {
            SlowWord out;
            for (int i = below(least, most); i > 0; --i)
                out.push_back({*rc::gen::elementOf(std::string("AABBC+-")), ""});
            if (below(0, 4) > 0) out.push_back({*rc::gen::elementOf(std::string("ABC")), ""});
            return out;
        };
        system.axiom = word(1, 6);
        for (int i = below(1, 7); i > 0; --i) {
            SlowRule rule;
            rule.left = one_of({"", "A", "B", "C"});
            rule.symbol = one_of({"A", "B", "C"})[0];
            rule.right = one_of({"", "", "A", "B", "C"});
            if (below(0, 4) == 0) rule.below = below(1, 4);
            rule.successor = word(0, 3);
            system.rules.push_back(rule);
        }
        const std::optional<Model> read = read_if_sayable(system);
        if (!read) return;  // a letter may vanish
        SlowWord slow = system.axiom;
        for (int n = 0; n < 4 && slow.size() < 500; ++n) {
            if (n > 0) {
                const SlowWord next = system.next(slow, n);
                if (SlowSystem::text(next) != SlowSystem::text(slow)) ++changed;
                slow = next;
            }
            ++compared;
            RC_ASSERT(kept_word(*read, static_cast<std::uint64_t>(n)) == SlowSystem::text(slow));
        }
    }));
    MESSAGE(compared << " words of rings compared, " << changed
                     << " of them other than the one before");
    CHECK(compared >= 50);
    CHECK(changed >= 20);
}
