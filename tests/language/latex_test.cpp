// Proofs as LaTeX: that the text is one, whatever the statement, and how words, systems and numbers are set.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "language/language.hpp"
#include "notation/notation.hpp"

using namespace algae;

namespace {

CheckedClaim checked(const std::string& text) {
    return check(read_claim("claim 50% of A & B_1 {sic}; " + text, "t.claim", {}));
}

/// What is wrong with the braces, the environments and the mathematics of a text; "" if nothing is.
std::string flaw(const std::string& text) {
    std::vector<std::string> open;
    bool mathematics = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto environment = [&](const std::string& command) {
            if (text.compare(i, command.size(), command) != 0) return std::string();
            const std::size_t begin = i + command.size();
            return text.substr(begin, text.find('}', begin) - begin);
        };
        if (const std::string name = environment("\\begin{"); !name.empty()) {
            open.push_back(name);
        } else if (const std::string ended = environment("\\end{"); !ended.empty()) {
            if (open.empty() || open.back() != ended) return ended + " is not open";
            open.pop_back();
        }
        switch (text[i]) {
            case '\\':
                ++i;  // escapes what follows
                break;
            case '{':
                open.emplace_back("{");
                break;
            case '}':
                if (open.empty() || open.back() != "{") return "a brace is not open";
                open.pop_back();
                break;
            case '$':
                mathematics = !mathematics;
                break;
            case '^':
            case '_':
                if (!mathematics) return "a power or an index outside mathematics";
                break;
            case '%':
            case '&':
            case '#':
                return "a special character";
            default:
                if (static_cast<unsigned char>(text[i]) < ' ' && text[i] != '\n')
                    return "a control character";
        }
    }
    if (mathematics) return "mathematics does not end";
    return open.empty() ? "" : open.back() + " is not closed";
}

std::string argument(const std::string& text) {
    const CheckedClaim found = checked(text);
    return latex(found.statements.at(0).answer, *found.claim.alphabet);
}

}  // namespace

TEST_CASE("words, systems and numbers are mathematics") {
    CHECK(argument("let G = D0L { axiom ab; a -> aab }; show aabb in L(G)") ==
          "$\\mathit{aabb}$ is in $L(G)$: $\\mathit{ab}$ $\\Rightarrow$ $\\mathit{aabb}$.\n");
    CHECK(argument("let G = D0L { axiom a; a -> aa }; show growth(G) = 2^n") ==
          "The difference of both sides obeys a linear recurrence of order $2$ at most in $n$; "
          "it is 0 for the first $2$ numbers, so it always is.\n");
    CHECK(argument("let A = {ε, b}; let B = {b}; show |A & B| = 1").find("$A \\cap B = \\{b\\}$") !=
          std::string::npos);
}

TEST_CASE("what has a meaning in LaTeX is escaped") {
    const std::string text = latex(checked("show a in {a}"));
    CHECK(text.starts_with("\\section*{50\\% of A \\& B\\_1 \\{sic\\}}\n"));
    CHECK(text.find("\\begin{proof}\n$a$ is in $\\{a\\}$.\n\\end{proof}\n") != std::string::npos);
    CHECK(argument("let G = D0L { axiom F_l; F_l -> F_l+^&$ }; show L(G) is infinite")
              .find("F\\_l") != std::string::npos);
}

TEST_CASE("proofs of all kinds have braces and environments that match") {
    for (const char* statement : {"show {a, aa} is not 0L",
                                  "show {ε, aa, ab, ba, bb} is not 0L",
                                  "show {a, aa} is ET0L",
                                  "show L(F) is not regular",
                                  "show L(F) != L(H)",
                                  "show L(F) is infinite",
                                  "show a in ~/a*b/",
                                  "show ab in h^-1({b} | /ab*/)",
                                  "show L(T) is infinite",
                                  "show /a(ab)*/ is infinite",
                                  "show L(F) & /a*/ is empty",
                                  "show F : a ==> ab in 1 step",
                                  "show not F ==> aa",
                                  "show growth(F) ~ exponential",
                                  "show growth(F) = 2^n",
                                  "show sequence(F) == sequence(F)",
                                  "show P(S ==> b in 1 step) = 1/3",
                                  "show Q ==> A(4)B in 1 step",
                                  "show dimension(K) = log 4 / log 3",
                                  "show bb in L(C)",
                                  "show FF in {F, FF}",
                                  "show L(F)^R is D0L",
                                  "show L(T) . {a} is empty"}) {
        CAPTURE(statement);
        const CheckedClaim found = checked(
            "let F = D0L { axiom a; a -> ab; b -> a }; let H = D0L { axiom b; a -> ab; b -> a }; "
            "let T = T0L { axiom a; table p; a -> aa; table q; a -> b }; let h = { a -> ab; b -> ε "
            "}; "
            "let S = S0L { axiom b; a -(1)-> a; b -(1/3)-> b; b -(2/3)-> a }; "
            "let Q = parametric { axiom A(2); A(x) : x < 9 -> A(2*x)B }; "
            "let K = D0L { axiom F; F -> F+F--F+F; angle 60 }; "
            "let C = 1L { axiom ab; a > b -> aa; b > a -> ε; b -> bb }; " +
            std::string(statement));
        const std::string text = latex(found);
        INFO(text);
        CHECK(flaw(text) == "");
    }
}
