// First-order statements about infinite words: certificates of random ones against prefixes of the words, and changed ones.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "automatic/known_words.hpp"
#include "automatic/random_formulas.hpp"
#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

using namespace algae;
using Outcome = verify::Finding::Outcome;

namespace {

using Json = nlohmann::ordered_json;

/// The word as claims define it.
std::string definition(const KnownWord& word) {
    std::string text = "let T = D0L { axiom " + std::string(1, word.rules.front().first);
    for (const auto& [letter, image] : word.rules)
        text += "; " + std::string(1, letter) + " -> " + image;
    if (!word.coding.empty()) {
        text += "; coding { ";
        for (const auto& [letter, image] : word.coding)
            text += std::string(1, letter) + " -> " + std::string(1, image) + "; ";
        text += "}";
    }
    return text + " }\n";
}

Json certificate_of(const std::string& before, const std::string& statement,
                    const Budget& budget = {}) {
    return certificate(
        check(read_claim("claim T\n" + before + "show " + statement, "x", {}), budget));
}

Outcome outcome(const Json& certificate) {
    Budget small;
    small.memory = 32 << 20;
    return verify::check_certificate(certificate.dump(1), "x.json", small).at(0).outcome;
}

/// The same with the opposite verdict.
Json opposite_of(Json certificate) {
    Json& verdict = certificate["statements"][0]["verdict"];
    verdict = verdict == "proved" ? "refuted" : "proved";
    return certificate;
}

/// An automaton of addition with one thing changed.
void change(Json& addition) {
    Json& edges = addition["edges"];
    Json& accepting = addition["accepting"];
    const auto at =
        static_cast<std::size_t>(*rc::gen::inRange<int>(0, static_cast<int>(edges.size())));
    switch (*rc::gen::inRange(0, 4)) {
        case 0:
            edges.erase(at);
            return;
        case 1:
            edges[at][4] = *rc::gen::inRange<int>(0, static_cast<int>(accepting.size()));
            return;
        case 2:
            edges[at][static_cast<std::size_t>(*rc::gen::inRange(1, 4))] = *rc::gen::inRange(0, 3);
            return;
        default: {
            Json& one = accepting[at % accepting.size()];
            one = !one.get<bool>();
        }
    }
}

}  // namespace

TEST_CASE(
    "certificates of first-order statements are checked, and never with the opposite verdict") {
    std::size_t checked = 0, large = 0, with_sums = 0, changed = 0, still_right = 0, heavy = 0;
    constexpr std::size_t most = 40;  // certificates of large automata take seconds
    std::vector<KnownWord> short_images;
    for (const KnownWord& word : words())
        if (std::ranges::all_of(word.rules,
                                [](const auto& rule) { return rule.second.size() <= 3; }))
            short_images.push_back(word);
    CHECK(rc::check("statements", [&] {
        if (checked + large + heavy >= most) return;
        const KnownWord word = *rc::gen::elementOf(short_images);
        const std::string prefix = word.prefix(100'000);
        const Formula inner = random_formula(prefix, {"i", "n"}, *rc::gen::inRange(0, 2));
        const bool all = *rc::gen::arbitrary<bool>();
        const std::string text = std::string(all ? "for all i < 4" : "for some i < 4") +
                                 ": for some n <= 5: T[i] = T[i] and (" + inner.text + ")";
        bool said = all;
        for (int i = 0; i < 4; ++i) {
            bool some = false;
            for (int n = 0; n <= 5; ++n) some = some || inner.says({{"i", i}, {"n", n}});
            if (some != all) said = !all;
        }
        RC_LOG(word.name + std::string(": ") + text);
        Budget small;
        small.memory = 8 << 20;
        Json certificate = certificate_of(definition(word), text, small);
        Json& entry = certificate["statements"][0];
        if (entry["verdict"] == "undecided") {
            ++large;
            return;
        }
        RC_ASSERT(entry["verdict"] == (said ? "proved" : "refuted"));
        const Outcome first = outcome(certificate);
        if (first == Outcome::not_checked) {
            ++heavy;
            return;
        }
        RC_ASSERT(first == Outcome::checked);
        RC_ASSERT(outcome(opposite_of(certificate)) == Outcome::wrong);
        ++checked;
        if (!entry["proof"].contains("addition")) return;
        ++with_sums;
        change(entry["proof"]["addition"]);
        try {
            still_right += outcome(certificate) == Outcome::checked;
            RC_ASSERT(outcome(opposite_of(certificate)) != Outcome::checked);
        } catch (const Error&) {  // it is no automaton any more
        }
        ++changed;
    }));
    MESSAGE(checked << " certificates checked, " << large + heavy
                    << " with large automata left out; " << with_sums << " with sums, " << changed
                    << " changed, of which " << still_right << " still prove their statement");
    CHECK(checked >= 20);
    CHECK(with_sums >= 1);
}

TEST_CASE("an automaton of addition that is none is refused") {
    const std::string before = "let T = D0L { axiom a; a -> ab; b -> a }\n";
    const Json good =
        certificate_of(before, "for all i, n: for some m: m = i + n and T[m] = T[i+n]");
    CHECK(outcome(good) == Outcome::checked);
    std::size_t refused = 0, edges = 0;
    const std::size_t count = good["statements"][0]["proof"]["addition"]["edges"].size();
    for (std::size_t e = 0; e < count; ++e) {  // every edge of the minimal automaton is needed
        Json one = good;
        one["statements"][0]["proof"]["addition"]["edges"].erase(e);
        refused += outcome(one) == Outcome::wrong;
        ++edges;
    }
    CHECK(refused == edges);
    CHECK(edges > 20);
    Json none = good;
    none["statements"][0]["proof"].erase("addition");
    CHECK(outcome(none) == Outcome::wrong);
}

namespace {

/// How many factors of 0, 1, ... letters a prefix has, or palindromes among them.
std::vector<int> factors_of(const std::string& prefix, bool palindromes, std::size_t longest) {
    std::vector<int> all;
    for (std::size_t n = 0; n <= longest; ++n) {
        std::set<std::string> different;
        for (std::size_t i = 0; i + n <= prefix.size(); ++i) {
            const std::string factor = prefix.substr(i, n);
            if (!palindromes || factor == std::string(factor.rbegin(), factor.rend()))
                different.insert(factor);
        }
        all.push_back(static_cast<int>(different.size()));
    }
    return all;
}

}  // namespace

TEST_CASE("sums of complexities are those of long prefixes, and verify counts again" *
          doctest::test_suite("long")) {
    std::size_t proofs = 0, refutations = 0, late = 0, changed = 0;
    std::vector<KnownWord> some;
    std::vector<std::vector<int>> complexities, palindromes;
    for (const KnownWord& word : words())
        for (const char* name : {"Thue-Morse", "Fibonacci", "Stewart", "Pell", "Sturmian",
                                 "not primitive", "period doubling"})
            if (word.name == std::string(name)) {
                some.push_back(word);
                const std::string prefix = word.prefix(20'000);
                complexities.push_back(factors_of(prefix, false, 60));
                palindromes.push_back(factors_of(prefix, true, 60));
            }
    CHECK(rc::check("sums", [&] {
        const auto which = *rc::gen::inRange<std::size_t>(0, some.size());
        const bool of_palindromes = *rc::gen::weightedElement<bool>({{3, false}, {1, true}});
        const auto& values = (of_palindromes ? palindromes : complexities)[which];
        const int a = *rc::gen::inRange(1, 4), b = *rc::gen::inRange(0, 3);
        const int c = *rc::gen::inRange(0, 3), d = *rc::gen::inRange(0, 3);
        const int times = *rc::gen::inRange(0, 3), from = *rc::gen::inRange(0, 5);
        const auto left = [&](int n) {
            return values[static_cast<std::size_t>(a * n + b)] -
                   times * values[static_cast<std::size_t>(c * n + d)];
        };
        // A line through the first two values, which is the whole of many such sequences.
        const int slope = left(from + 1) - left(from);
        const int constant =
            left(from) - slope * from + *rc::gen::weightedElement<int>({{9, 0}, {1, 1}});
        const std::string name = of_palindromes ? "palindromic_complexity" : "complexity";
        const auto call = [&](int p, int q) {
            return name + "(T, " + std::to_string(p) + "n + " + std::to_string(q) + ")";
        };
        const std::string text = "for all n with n >= " + std::to_string(from) + ": " + call(a, b) +
                                 " = " + std::to_string(times) + " " + call(c, d) +
                                 (slope < 0 ? " - " : " + ") + std::to_string(std::abs(slope)) +
                                 "n" + (constant < 0 ? " - " : " + ") +
                                 std::to_string(std::abs(constant));
        int fails = -1;
        for (int n = from; n < from + 14 && fails < 0; ++n)
            if (left(n) != slope * n + constant) fails = n;
        RC_LOG(some[which].name + std::string(": ") + text);
        Json certificate = certificate_of(definition(some[which]), text);
        const std::string verdict = certificate["statements"][0]["verdict"];
        RC_ASSERT(verdict != "undecided");
        if (fails >= 0) RC_ASSERT(verdict == "refuted");
        ++(verdict == "proved" ? proofs : refutations);
        late += fails < 0 && verdict == "refuted";
        RC_ASSERT(outcome(certificate) == Outcome::checked);
        RC_ASSERT(outcome(opposite_of(certificate)) == Outcome::wrong);
        if (verdict != "proved") return;
        Json& said = certificate["statements"][0]["statement"];  // another constant is none
        said["plus"] = std::to_string(std::stoi(said["plus"].get<std::string>()) + 1);
        RC_ASSERT(outcome(certificate) == Outcome::wrong);
        ++changed;
    }));
    MESSAGE(proofs << " sums proved for all n, " << refutations << " refuted, " << late
                   << " of them beyond the prefix; " << changed << " changed");
    CHECK(proofs >= 20);
    CHECK(refutations >= 20);
}

TEST_CASE("a certificate with places that cannot be counted is refused") {
    Json certificate =
        certificate_of("let T = D0L { axiom a; a -> ab; b -> a }\n", "complexity(T, n) = n + 1");
    CHECK(outcome(certificate) == Outcome::checked);
    Json& said = certificate["statements"][0]["statement"];
    const Json all = Json::parse(R"({"equation": {"of": {}, "plus": "0"}})");
    const Json places = said["counts"][0]["places"];
    said["counts"][0]["places"] = all;  // all i
    CHECK(outcome(certificate) == Outcome::wrong);
    said["counts"][0]["places"] = places;
    said["from"] = "-1";
    CHECK_THROWS_AS(outcome(certificate), Error);
    said["from"] = "0";
    said["counts"][0]["places"]["not"]["exists"][0] = "i";  // that is free
    CHECK_THROWS_AS(outcome(certificate), Error);
}
