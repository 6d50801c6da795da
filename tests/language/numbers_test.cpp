#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <array>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

using namespace algae;

namespace {

using Outcome = verify::Finding::Outcome;

struct Found {
    std::string verdict, text;
    std::vector<std::string> argument;
    std::vector<std::pair<std::string, std::string>> values;
    std::string by;
    verify::Finding finding;
};

/// What is decided of a theorem about systems that are defined in front of it, and what verify says of its certificate.
Found judged(const std::string& definitions, const std::string& theorem) {
    const CheckedClaim checked =
        check(read_claim("claim T\n" + definitions + "\ntheorem " + theorem, "x.claim", {}));
    const CheckedStatement& statement = checked.statements.at(0);
    const Alphabet& alphabet = *checked.claim.alphabet;
    const auto written = certificate(checked);
    Found all{verdict_text(statement),
              written.dump(1),
              sentences(statement.answer, alphabet),
              witness_of(statement.answer, alphabet),
              method_of(statement.answer, alphabet),
              {}};
    all.finding = verify::check_certificate(all.text, "x.json", {}).at(0);
    return all;
}

// --- A second route: systems as strings, words written out, terms as functions ---

struct TextSystem {
    std::string axiom;
    std::map<char, std::string> rules;

    std::string word(std::uint64_t n) const {
        std::string now = axiom;
        for (; n > 0; --n) {
            std::string next;
            for (const char letter : now) next += rules.at(letter);
            now = next;
            if (now.size() > 3'000'000) throw std::length_error("too long");
        }
        return now;
    }
    std::string text(const std::string& name) const {
        std::string made = "let " + name + " = D0L { axiom " + axiom;
        for (const auto& [letter, image] : rules)
            made += std::string("; ") + letter + " -> " + (image.empty() ? "ε" : image);
        return made + " }";
    }
};

TextSystem any_system(bool erasing = true) {
    const auto word = [](int least, int most) {
        std::string made;
        for (int i = *rc::gen::inRange(least, most + 1); i > 0; --i)
            made += *rc::gen::element('a', 'b');
        return made;
    };
    return {word(1, 2), {{'a', word(erasing ? 0 : 1, 2)}, {'b', word(erasing ? 0 : 1, 2)}}};
}

/// A term as its text and as a function of n and k.
struct TextTerm {
    std::string text;
    std::function<Rational(std::uint64_t, std::uint64_t)> value;
};

TextTerm any_term(const TextSystem& G, int depth, bool two) {
    const int kind = *rc::gen::inRange(0, depth == 0 ? 5 : 9);
    const auto generation = [&]() -> std::pair<std::string, std::array<std::uint64_t, 3>> {
        const std::uint64_t plus = *rc::gen::inRange<std::uint64_t>(0, 3);
        const std::string more = plus == 0 ? "" : "+" + std::to_string(plus);
        if (two && *rc::gen::arbitrary<bool>()) return {"n+k" + more, {1, 1, plus}};
        if (*rc::gen::inRange(0, 4) == 0) return {"2*n" + more, {2, 0, plus}};
        return {"n" + more, {1, 0, plus}};
    };
    if (kind <= 1) {
        const auto [text, by] = generation();
        const auto at = by;
        return {"length(G, " + text + ")", [G, at](std::uint64_t n, std::uint64_t k) {
                    return Rational(
                        Integer(std::uint64_t{G.word(at[0] * n + at[1] * k + at[2]).size()}));
                }};
    }
    if (kind == 2) {
        const auto [text, by] = generation();
        const auto at = by;
        return {"count(G, a, " + text + ")", [G, at](std::uint64_t n, std::uint64_t k) {
                    const std::string word = G.word(at[0] * n + at[1] * k + at[2]);
                    return Rational(static_cast<long>(std::count(word.begin(), word.end(), 'a')));
                }};
    }
    if (kind == 3)
        return *rc::gen::elementOf(std::vector<TextTerm>{
            {"1", [](auto, auto) { return Rational(1); }},
            {"2", [](auto, auto) { return Rational(2); }},
            {"n", [](auto n, auto) { return Rational(Integer(n)); }},
            {"2^n", [](auto n, auto) { return power(Rational(2), static_cast<std::int64_t>(n)); }},
            {"n^2", [](auto n, auto) { return Rational(Integer(n * n)); }}});
    if (kind == 4 && two) return {"k", [](auto, auto k) { return Rational(Integer(k)); }};
    if (kind == 4) return {"3", [](auto, auto) { return Rational(3); }};
    const TextTerm left = any_term(G, depth - 1, two), right = any_term(G, depth - 1, two);
    const auto join = [&](const char* sign, auto combine) {
        return TextTerm{"(" + left.text + ")" + sign + "(" + right.text + ")",
                        [l = left.value, r = right.value, combine](auto n, auto k) {
                            return combine(l(n, k), r(n, k));
                        }};
    };
    if (kind == 5) return join("-", [](const Rational& x, const Rational& y) { return x - y; });
    if (kind == 6) return join("*", [](const Rational& x, const Rational& y) { return x * y; });
    return join("+", [](const Rational& x, const Rational& y) { return x + y; });
}

/// What a function generates, in its whole range.
template <class Make>
auto whole(Make make) {
    return *rc::gen::resize(100, rc::gen::exec(make));
}

/// A factor of a word as its text and as a function of n.
struct Factor {
    std::string text;
    std::function<std::string(std::uint64_t)> value;
};

auto any_equation() {
    const TextSystem G = any_system();
    const bool two = *rc::gen::inRange(0, 3) == 0;
    TextTerm left = any_term(G, 1, two), right = any_term(G, 1, two);
    // Some that are true.
    const int form = *rc::gen::inRange(0, 4);
    if (form == 0) right = {"(" + left.text + ")*1+0", left.value};
    if (form == 1) right = {"2*(" + left.text + ") - (" + left.text + ")", left.value};
    return std::tuple(G, two, left, right);
}

auto any_inequality() {
    const TextSystem G = any_system(*rc::gen::arbitrary<bool>());
    const TextTerm left = any_term(G, 1, false), right = any_term(G, 1, false);
    return std::tuple(G, left, right, *rc::gen::element<std::string>("<", "<=", "!="));
}

auto any_words() {
    const TextSystem G = any_system(*rc::gen::arbitrary<bool>());
    const auto any_factor = [&]() -> Factor {
        const std::uint64_t plus = *rc::gen::inRange<std::uint64_t>(0, 3);
        const std::string generation =
            "word(G, n" + (plus == 0 ? "" : "+" + std::to_string(plus)) + ")";
        const auto word = [G, plus](std::uint64_t n) { return G.word(n + plus); };
        switch (*rc::gen::inRange(0, 6)) {
            case 0:
                return {generation + "^R", [word](std::uint64_t n) {
                            const std::string one = word(n);
                            return std::string(one.rbegin(), one.rend());
                        }};
            case 1:
                return {"{ a -> b; b -> a }(" + generation + ")", [word](std::uint64_t n) {
                            std::string one = word(n);
                            for (char& c : one) c = c == 'a' ? 'b' : 'a';
                            return one;
                        }};
            case 2:
                return {"a", [](std::uint64_t) { return std::string("a"); }};
            default:
                return {generation, word};
        }
    };
    const auto any_side = [&] {
        std::vector<Factor> all;
        for (int i = *rc::gen::inRange(1, 3); i > 0; --i) all.push_back(any_factor());
        return all;
    };
    std::vector<Factor> left = any_side(), right = any_side();
    if (*rc::gen::inRange(0, 4) == 0) {  // one step written out, which is true
        const std::string image = G.rules.at('a');
        left = {{"word(G, n+1)", [G](std::uint64_t n) { return G.word(n + 1); }}};
        right = {{"{ a -> " + (image.empty() ? "ε" : image) + "; b -> " +
                      (G.rules.at('b').empty() ? "ε" : G.rules.at('b')) + " }(word(G, n))",
                  [G](std::uint64_t n) { return G.word(n + 1); }}};
    }
    return std::tuple(G, left, right,
                      *rc::gen::element<std::string>("==", "begins with", "ends with", "!="));
}

bool holds(const std::string& sign, const Rational& left, const Rational& right) {
    if (sign == "=") return left == right;
    if (sign == "!=") return left != right;
    if (sign == "<") return left < right;
    return left <= right;
}

}  // namespace

TEST_CASE("equations of numbers are decided, as the words that are written out say") {
    std::size_t proved = 0, refuted = 0;
    CHECK(rc::check([&] {
        const auto [G, two, left, right] = whole(any_equation);
        const std::string theorem = (two ? "for all numbers n, k: " : "for all numbers n: ") +
                                    left.text + " = " + right.text;
        RC_LOG() << G.text("G") << '\n' << theorem << '\n';
        const Found found = judged(G.text("G"), theorem);
        RC_ASSERT(found.verdict != "undecided");
        RC_ASSERT(found.finding.outcome == Outcome::checked);
        bool same = true;
        for (std::uint64_t n = 0; n < 7 && same; ++n)
            for (std::uint64_t k = 0; k < (two ? 5u : 1u); ++k) {
                if (2 * n + k > 11) continue;
                same = same && left.value(n, k) == right.value(n, k);
            }
        ++(found.verdict == "proved" ? proved : refuted);
        if (found.verdict == "proved")
            RC_ASSERT(same);
        else if (!two) {
            const auto n = Integer(found.values.at(0).second).to_uint64();
            if (n < 12) RC_ASSERT(left.value(n, 0) != right.value(n, 0));
            for (std::uint64_t before = 0; before < std::min<std::uint64_t>(n, 10); ++before)
                RC_ASSERT(left.value(before, 0) == right.value(before, 0));
        }
    }));
    MESSAGE(proved << " equations proved, " << refuted << " refuted");
    CHECK(proved > 20);
    CHECK(refuted > 20);
}

TEST_CASE("inequalities that are proved hold of the words that are written out") {
    std::map<std::string, std::size_t> count;
    CHECK(rc::check([&] {
        const auto [G, left, right, sign] = whole(any_inequality);
        const std::string theorem =
            "for all numbers n: " + left.text + " " + sign + " " + right.text;
        RC_LOG() << G.text("G") << '\n' << theorem << '\n';
        const Found found = judged(G.text("G"), theorem);
        ++count[found.verdict];
        if (found.verdict == "undecided") return;
        RC_ASSERT(found.finding.outcome == Outcome::checked);
        if (found.verdict == "proved") {
            for (std::uint64_t n = 0; n < 6; ++n)
                RC_ASSERT(holds(sign, left.value(n, 0), right.value(n, 0)));
        } else {
            const auto n = Integer(found.values.at(0).second).to_uint64();
            if (n < 6) RC_ASSERT(!holds(sign, left.value(n, 0), right.value(n, 0)));
        }
    }));
    MESSAGE(count["proved"] << " proved, " << count["refuted"] << " refuted, " << count["undecided"]
                            << " undecided");
    CHECK(count["proved"] > 5);
    CHECK(count["refuted"] > 20);
}

TEST_CASE("statements about words for all n hold of the words that are written out") {
    std::map<std::string, std::size_t> count;
    CHECK(rc::check([&] {
        const auto [G, left, right, sign] = whole(any_words);
        const auto text_of = [](const std::vector<Factor>& side) {
            return joined(side, " ", [](const Factor& one) { return one.text; });
        };
        const auto word_of = [](const std::vector<Factor>& side, std::uint64_t n) {
            std::string all;
            for (const Factor& one : side) all += one.value(n);
            return all;
        };
        const std::string theorem = text_of(left) + " " + sign + " " + text_of(right);
        if (theorem.find("word(") == std::string::npos) return;
        RC_LOG() << G.text("G") << '\n' << theorem << '\n';
        const Found found = judged("alphabet a b\n" + G.text("G"), "for all numbers n: " + theorem);
        ++count[found.verdict];
        const auto is_so = [&](std::uint64_t n) {
            const std::string u = word_of(left, n), v = word_of(right, n);
            return sign == "=="            ? u == v
                   : sign == "!="          ? u != v
                   : sign == "begins with" ? u.starts_with(v)
                                           : u.ends_with(v);
        };
        if (found.verdict == "undecided") return;
        RC_ASSERT(found.finding.outcome == Outcome::checked);
        if (found.verdict == "proved") {
            for (std::uint64_t n = 0; n < 8; ++n) RC_ASSERT(is_so(n));
        } else {
            const auto n = Integer(found.values.at(0).second).to_uint64();
            if (n < 10) RC_ASSERT(!is_so(n));
        }
    }));
    MESSAGE(count["proved"] << " proved, " << count["refuted"] << " refuted, " << count["undecided"]
                            << " undecided");
    CHECK(count["proved"] > 5);
    CHECK(count["refuted"] > 20);
}

TEST_CASE("sentences of textbooks about all n") {
    const std::string systems =
        "let F = D0L { axiom a; a -> ab; b -> a }\nlet D = D0L { axiom a; a -> aa }\n"
        "let T = D0L { axiom a; a -> ab; b -> ba }\nlet N = D0L { axiom f; f -> f|f }\n"
        "let h = { a -> b; b -> a }";
    const auto verdict = [&](const std::string& theorem) {
        const Found found = judged(systems, theorem);
        INFO(theorem);
        if (found.verdict != "undecided" && found.by != "cases")
            CHECK(found.finding.outcome == Outcome::checked);
        return found.verdict + (found.by.empty() ? "" : " by " + found.by);
    };
    CHECK(verdict("length(F, n + 2) = length(F, n + 1) + length(F, n)") == "proved by recurrences");
    CHECK(verdict("length(F, n) = ((1+sqrt(5))/2)^(n+2)/sqrt(5) - ((1-sqrt(5))/2)^(n+2)/sqrt(5)") ==
          "proved by recurrences");
    CHECK(verdict("length(F, n)*length(F, n+2) - length(F, n+1)^2 = (-1)^(n+1)") ==
          "proved by recurrences");
    CHECK(verdict("length(D, n) = 3*2^n") == "refuted by instance");
    CHECK(verdict("2^(n+1) = 2*2^n") == "proved by recurrences");
    CHECK(verdict("n = 3") == "refuted by instance");
    CHECK(verdict("for all numbers n < 5: n*n <= 16") == "proved by cases");
    CHECK(verdict("for all numbers n <= 5: n*n <= 16") == "refuted by instance");
    // A sum without terms once had the order 0, and the check of its values no end.
    CHECK(verdict("segments(N, n) = 0") == "proved by recurrences");
    CHECK(verdict("segments(N, n) <= 0") == "proved by positive");
    CHECK(verdict("growth(D) = 2^n") == "proved by recurrences");
    CHECK(verdict("for all numbers n, k: length(D, n + k) = length(D, n) * length(D, k)") ==
          "proved by recurrences");
    CHECK(verdict("for all numbers k < n: length(D, n) = length(D, k) * 2^(n-k)") ==
          "proved by recurrences");
    CHECK(verdict("for all numbers n >= 1: length(D, n-1) * 2 = length(D, n)") ==
          "proved by recurrences");
    CHECK(verdict("length(D, n) > n") == "proved by positive");
    CHECK(verdict("for all n >= 4: n^2 <= 2^n") == "proved by positive");
    CHECK(verdict("n^2 <= length(D, n)") == "refuted by instance");
    CHECK(verdict("for some number n: length(F, n) = 21") == "proved by instance");
    CHECK(verdict("for some number n: length(F, n) = 22") == "refuted by positive");
    CHECK(verdict("length(F, n) != 22") == "proved by positive");
    CHECK(verdict("not length(F, n) = 22") == "proved by instance");
    CHECK(verdict("word(F, n + 2) == word(F, n + 1) word(F, n)") == "proved by morphism");
    CHECK(verdict("word(F, n + 1) begins with word(F, n)") == "proved by morphism");
    CHECK(verdict("word(F, n + 2) ends with word(F, n)") == "proved by morphism");
    CHECK(verdict("word(T, n + 1) == word(T, n) h(word(T, n))") == "proved by morphism");
    CHECK(verdict("word(T, 2*n) == word(T, 2*n)^R") == "proved by morphism");
    CHECK(verdict("word(T, n) == word(T, n)^R") == "refuted by instance");
    CHECK(verdict("for all n: length(D, n) = 2^n and word(D, n + 1) == word(D, n)^2") ==
          "proved by each");
    CHECK(verdict("for all n: length(D, n) = 2^n and length(D, n) < 8") == "refuted by instance");
    CHECK(verdict("word(F, 4) == abaababa") == "proved by words");
    CHECK(verdict("length(F, 4) = 8") == "proved by values");
    CHECK(verdict("for all numbers n up to 10: length(D, n) <= 1024").starts_with("proved"));
    CHECK(verdict("for all PD0L systems G up to size 5: length(G, n + 1) >= length(G, n)") ==
          "proved by cases");
}

TEST_CASE("what is said for all numbers tells how it is known") {
    const std::string systems = "let D = D0L { axiom a; a -> aa }";
    CHECK(judged(systems, "length(D, n) = 2^n").argument ==
          std::vector<std::string>{
              "The difference of both sides obeys a linear recurrence of order 2 "
              "at most in n; it is 0 for the first 2 numbers, so it always is."});
    CHECK(judged(systems, "length(D, n) = 2*n").argument ==
          std::vector<std::string>{"It is false for n = 0:", "  length(D,0) is 1, 2*0 is 0."});
    CHECK(
        judged(systems, "length(D, n) > n").argument ==
        std::vector<std::string>{
            "Let u(n) be the left side minus the right one, n from the least number on; it obeys a "
            "linear recurrence of order 3 at most. ",
            "Let v(n) = u(n+1) - u(n). If it is not negative, u(n) is positive, as u(0) is.",
            "Let v'(n) = v(n+1) - v(n). If it is not negative, v(n) is not negative, as v(0) is.",
            "v'(n+1) = 2 v'(n) has no negative coefficient, and the first 1 term is not negative, "
            "so "
            "all are."});
    CHECK(judged(systems, "word(D, n+1) == word(D, n) word(D, n)").argument ==
          std::vector<std::string>{
              "It is true for 0. The morphism { a -> aa } takes both sides to those "
              "for the next number, so it is true for all."});
}

TEST_CASE("certificates of numbers with something changed are found wrong") {
    const std::string systems = "let D = D0L { axiom a; a -> aa }";
    const auto outcome = [&](const std::string& theorem, const std::string& from,
                             const std::string& to) {
        std::string text = judged(systems, theorem).text;
        const std::size_t at = text.find(from);
        REQUIRE(at != std::string::npos);
        text.replace(at, from.size(), to);
        return verify::to_string(verify::check_certificate(text, "x.json", {}).at(0).outcome);
    };
    CHECK(outcome("length(D, n) = 2^n", "\"2^n\"", "\"3^n\"") == "WRONG");
    CHECK(outcome("length(D, n) = 2^n", "\"=\"", "\"<\"") == "WRONG");
    CHECK(outcome("for all n: length(D, n) = 2^n and length(D, n) > n", "\"n\"\n", "\"n^2\"\n") ==
          "WRONG");
    CHECK(outcome("length(D, n) > n", "\"from\": 0", "\"from\": 1") == "checked");  // is true too
    CHECK(outcome("length(D, n) > n", "\"2\"", "\"3\"") == "WRONG");
    CHECK(outcome("length(D, n) > n", "\"left\"", "\"right\"") == "WRONG");
    CHECK(outcome("for all n >= 4: n^2 <= 2^n", "\"4\"", "\"3\"") == "WRONG");
    CHECK(outcome("word(D, n+1) == word(D, n) word(D, n)", "\"a a\"", "\"a\"") == "WRONG");
    CHECK(outcome("word(D, n+1) == word(D, n) word(D, n)", "\"a\": \"a a\"", "\"a\": \"a\"") ==
          "WRONG");
}
