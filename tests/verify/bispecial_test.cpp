// The number of factors of n letters for all n, by bispecial factors: certificates of random primitive morphisms, and changed ones.

#include <doctest/doctest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "combinatorics/combinatorics.hpp"
#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "oracle/infinite_words.hpp"
#include "verify/verify.hpp"

using namespace algae;
using Outcome = verify::Finding::Outcome;

namespace {

using Json = nlohmann::ordered_json;

std::string definition(const oracle::Rules& rules) {
    std::string text = "let T = D0L { axiom a";
    for (const auto& [letter, image] : rules) text += std::string("; ") + letter + " -> " + image;
    return text + " }\n";
}

Json certificate_of(const oracle::Rules& rules, const std::string& statement) {
    Budget budget;
    budget.memory = std::uint64_t{64} << 20;
    return certificate(
        check(read_claim("claim T\n" + definition(rules) + "show " + statement, "x", {}), budget));
}

std::string proof_kind(const Json& certificate) {
    return certificate["statements"][0]["proof"]["by"].get<std::string>();
}

verify::Finding found(const Json& certificate) {
    return verify::check_certificate(certificate.dump(1), "x.json", Budget()).at(0);
}

std::string linear_statement(const ComplexityForAll::Linear& linear) {
    std::string text = "for all n with n >= " + to_string(linear.from) +
                       ": complexity(T, n) = " + to_string(linear.slope) + " n";
    if (!linear.constant.is_zero())
        text += (linear.constant > 0 ? " + " : " - ") +
                to_string(linear.constant > 0 ? linear.constant : -linear.constant);
    return text;
}

const oracle::Rules fibonacci{{'a', "ab"}, {'b', "a"}}, stewart{{'a', "aab"}, {'b', "abb"}};

Morphism morphism_of(const oracle::Rules& rules) {
    std::vector<Word> images;
    for (const auto& [letter, image] : rules) {
        images.emplace_back();
        for (const char one : image) images.back().push_back(static_cast<Symbol>(one - 'a'));
    }
    return Morphism(images);
}

}  // namespace

TEST_CASE("numbers of factors: by bispecial factors") {
    for (const oracle::Rules& rules :
         {fibonacci, stewart, oracle::Rules{{'a', "ab"}, {'b', "c"}, {'c', "a"}},
          oracle::Rules{{'a', "abcabc"}, {'b', "a"}, {'c', "bc"}}}) {
        const auto linear = complexity_for_all(morphism_of(rules), 0).linear();
        REQUIRE(linear);
        const Json made = certificate_of(rules, linear_statement(*linear));
        INFO(made.dump(1));
        CHECK(proof_kind(made) == "bispecial");
        CHECK(found(made).outcome == Outcome::checked);
    }
    // The lengths do not follow the recurrence of a Pisot number, so addition is not regular. Multiplicities 1 and -1 of arbitrarily great lengths cancel
    // each other in other words of return words.
    const Json cancelled = certificate_of(oracle::Rules{{'a', "ab"}, {'b', "acc"}, {'c', "cbb"}},
                                          "for all n with n >= 4: complexity(T, n) = 7n - 8");
    CHECK(proof_kind(cancelled) == "bispecial");
    CHECK(found(cancelled).outcome == Outcome::checked);
    // What is not linear, and what is false, is left to automata.
    CHECK(proof_kind(certificate_of(fibonacci, "complexity(T, n) = n + 2")) == "automata");
    CHECK(proof_kind(certificate_of(fibonacci, "complexity(T, 2n) = 2n + 1")) == "automata");
}

TEST_CASE("numbers of factors: a changed certificate is not checked") {
    const Json made = certificate_of(stewart, "for all n with n >= 1: complexity(T, n) = 2n");
    const auto changed = [&](const char* path, const Json& value) {
        Json other = made;
        other.at(Json::json_pointer(std::string("/statements/0/") + path)) = value;
        return found(other);
    };
    REQUIRE(made["statements"][0]["proof"]["sums"] == Json::parse(R"([["0", "1"]])"));
    CHECK(found(made).outcome == Outcome::checked);
    for (const char* sums :
         {"[]", R"([["0", "2"]])", R"([["1", "1"]])", R"([["0", "-1"]])",
          R"([["0", "1"], ["5", "1"]])", R"([["0", "1"], ["5", "1"], ["7", "-1"]])"}) {
        const verify::Finding finding = changed("proof/sums", Json::parse(sums));
        INFO(sums);
        CHECK(finding.outcome == Outcome::wrong);
        CHECK(finding.reason == "the sums over the bispecial factors are others");
    }
    CHECK(changed("statement/plus", "1").reason == "there are 2 factors of 1 letters");
    CHECK(changed("statement/from", "0").reason == "there are 1 factors of 0 letters");
    CHECK(changed("statement/n", "-3").outcome == Outcome::wrong);
    CHECK(changed("verdict", "refuted").outcome == Outcome::wrong);
    CHECK(changed("statement/counts/0/times", "2").outcome == Outcome::wrong);
    for (const char* sums : {R"([["0", "0"]])", R"([["0", "1"], ["0", "1"]])", R"([["0"]])"}) {
        Json other = made;
        other["statements"][0]["proof"]["sums"] = Json::parse(sums);
        CHECK_THROWS_AS(found(other), Error);
    }
    // Other places than those where a factor stands first.
    Json others = made;
    others["statements"][0]["statement"]["counts"][0]["places"] =
        others["statements"][0]["statement"]["counts"][0]["places"]["not"];
    CHECK(found(others).reason ==
          "the statement is not about the number of factors of n letters alone");
    // The Thue-Morse word has 3(n - 1) factors for n = 3 and 5, and not for all n: it has sums of arbitrarily great lengths.
    Json morse = made;
    morse["systems"]["T"]["tables"][0] = Json::parse(R"({"a": ["a b"], "b": ["b a"]})");
    CHECK(found(morse).outcome == Outcome::not_checked);
    // An erased letter, a first letter that does not grow, and one that does not come back.
    for (const char* table : {R"({"a": ["a b"], "b": [""]})", R"({"a": ["a"], "b": ["a"]})",
                              R"({"a": ["a b"], "b": ["b"]})"}) {
        Json other = made;
        other["systems"]["T"]["tables"][0] = Json::parse(table);
        INFO(table);
        CHECK(found(other).outcome != Outcome::checked);
    }
}

TEST_CASE(
    "numbers of factors: certificates of random primitive morphisms are checked, wrong numbers are "
    "not") {
    std::mt19937 generator(7);
    const auto below = [&](std::size_t bound) { return generator() % bound; };
    std::size_t linear_ones = 0, checked = 0, with_sums = 0, changed = 0, drawn = 0;
    while (drawn < 400) {
        oracle::Rules rules;
        const std::size_t letters = 2 + below(2);
        for (std::size_t a = 0; a < letters; ++a) {
            std::string image(1 + below(4), 'a');
            for (char& letter : image) letter = static_cast<char>('a' + below(letters));
            rules[static_cast<char>('a' + a)] = image;
        }
        rules['a'] = "a" + rules['a'];
        if (!oracle::primitive_power(rules, "a")) continue;
        ++drawn;
        const ComplexityForAll all = complexity_for_all(morphism_of(rules), 0);
        const auto linear = all.linear();
        if (!linear) continue;
        ++linear_ones;
        with_sums += all.single.size() > 1;
        const Json made = certificate_of(rules, linear_statement(*linear));
        INFO(made.dump(1));
        REQUIRE(proof_kind(made) == "bispecial");
        const Outcome outcome = found(made).outcome;
        REQUIRE(outcome != Outcome::wrong);
        checked += outcome == Outcome::checked;
        // One number more of each length, by the statement or by the proof.
        for (const char* place : {"plus", "n"}) {
            Json other = made;
            Json& field = other["statements"][0]["statement"][place];
            field = std::to_string(std::stoll(field.get<std::string>()) + 1);
            REQUIRE(found(other).outcome != Outcome::checked);
            ++changed;
        }
    }
    MESSAGE(drawn, " primitive morphisms, ", linear_ones, " with linear numbers of factors, ",
            with_sums, " of them not from the first letters on; ", checked, " checked, ", changed,
            " changed ones refused");
    CHECK(linear_ones >= 40);
    CHECK(with_sums >= 5);
    CHECK(checked == linear_ones);
    CHECK(changed == 2 * linear_ones);
}
