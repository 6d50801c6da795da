// Critical exponents and circular systems: certificates of known words and of random ones, and changed ones.

#include <doctest/doctest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "oracle/infinite_words.hpp"
#include "verify/verify.hpp"

using namespace algae;
using Outcome = verify::Finding::Outcome;

namespace {

using Json = nlohmann::ordered_json;

Json certificate_of(const std::string& rules, const std::string& statement) {
    Budget budget;
    budget.memory = std::uint64_t{24} << 20;
    return certificate(check(
        read_claim("claim T\nlet T = D0L { axiom a; " + rules + " }\nshow " + statement, "x", {}),
        budget));
}

verify::Finding found(const Json& certificate) {
    return verify::check_certificate(certificate.dump(1), "x.json", Budget()).at(0);
}

const Json& entry(const Json& certificate) { return certificate["statements"][0]; }

Json changed(Json certificate, const char* path, const Json& value) {
    certificate.at(Json::json_pointer(std::string("/statements/0/") + path)) = value;
    return certificate;
}

constexpr const char* fibonacci = "a -> ab; b -> a";
constexpr const char* thue_morse = "a -> ab; b -> ba";

}  // namespace

TEST_CASE("critical exponents of known words are numbers of claims, and verify finds them again") {
    struct Known {
        const char *rules, *exponent;
    };
    for (const Known& known :
         {Known{fibonacci, "2 + (1+sqrt(5))/2"}, Known{"a -> aab; b -> a", "3 + sqrt 2"},
          Known{thue_morse, "2"}, Known{"a -> aab; b -> abb", "3"},
          Known{"a -> ab; b -> ac; c -> a", "the largest real root of 2x^3 - 12x^2 + 22x - 13"},
          Known{"a -> aabaa; b -> baab", "3 + sqrt(3)"}, Known{"a -> ab; b -> aa", "4"}}) {
        const std::string rules = known.rules, number = known.exponent;
        INFO(rules);
        for (const auto& [sign, holds] : std::map<std::string, bool>{
                 {"=", true}, {"<=", true}, {">=", true}, {"<", false}, {">", false}}) {
            const Json made = certificate_of(rules, "critical_exponent(T) " + sign + " " + number);
            INFO(made.dump(1));
            CHECK(entry(made)["verdict"] == (holds ? "proved" : "refuted"));
            CHECK(entry(made)["proof"]["by"] == "repetitions");
            const verify::Finding finding = found(made);
            INFO(finding.reason);
            CHECK(finding.outcome == Outcome::checked);
        }
        CHECK(entry(certificate_of(rules, "critical_exponent(T) != " + number))["verdict"] ==
              "refuted");
    }
    CHECK(entry(certificate_of(fibonacci, "critical_exponent(T) < 37/10"))["verdict"] == "proved");
    CHECK(entry(certificate_of(fibonacci, "critical_exponent(T) <= 18/5"))["verdict"] == "refuted");
}

TEST_CASE("infinite critical exponents are shown by a word all powers of which are factors") {
    for (const char* rules : {"a -> aba; b -> bbbb", "a -> abcabc; b -> a; c -> bc"}) {
        INFO(rules);
        const Json above = certificate_of(rules, "critical_exponent(T) > 1000");
        CHECK(entry(above)["verdict"] == "proved");
        CHECK(entry(above)["proof"]["by"] == "repetition");
        CHECK(found(above).outcome == Outcome::checked);
        const Json equal = certificate_of(rules, "critical_exponent(T) = 4");
        CHECK(entry(equal)["verdict"] == "refuted");
        CHECK(found(equal).outcome == Outcome::checked);
        CHECK(found(changed(above, "verdict", "refuted")).reason ==
              "an infinite exponent shows the opposite");
    }
    // The letter that has all its powers does not grow: decided, and not checked.
    const Json constant = certificate_of("a -> ab; b -> b", "critical_exponent(T) > 5");
    CHECK(entry(constant)["verdict"] == "proved");
    CHECK(found(constant).outcome == Outcome::not_checked);
}

TEST_CASE("a changed certificate of a critical exponent is not checked") {
    const Json made = certificate_of(fibonacci, "critical_exponent(T) = 2 + (1+sqrt(5))/2");
    REQUIRE(entry(made)["proof"]["exponent"] ==
            Json::parse(R"({"polynomial": ["5", "-5", "1"], "root": 1})"));
    const auto with = [&](const char* polynomial, int root, const char* is) {
        Json other = made;
        for (const char* place : {"statement/critical exponent", "proof/exponent"})
            other =
                changed(other, place, {{"polynomial", Json::parse(polynomial)}, {"root", root}});
        return found(changed(other, "statement/compared", is));
    };
    CHECK(with(R"(["5", "-5", "1"])", 1, "<=").outcome == Outcome::checked);
    CHECK(with(R"(["5", "-5", "1"])", 1, "<").reason == "the exponent shows the opposite");
    // Too small: 3, 3.6, 3.618, and the other root; too great: 4, 3.61805, 2 + sqrt 3.
    for (const char* small : {R"(["-3", "1"])", R"(["-18", "5"])", R"(["-1809", "500"])"}) {
        const verify::Finding finding = with(small, 0, "=");
        INFO(small);
        CHECK(finding.outcome == Outcome::wrong);
        CHECK(finding.reason.find("has a greater exponent") != std::string::npos);
    }
    CHECK(with(R"(["5", "-5", "1"])", 0, "=").outcome == Outcome::wrong);
    for (const char* great : {R"(["-4", "1"])", R"(["-72361", "20000"])"}) {
        const verify::Finding finding = with(great, 0, "=");
        INFO(great);
        CHECK(finding.outcome == Outcome::wrong);
        CHECK(finding.reason == "exponents of factors stay below a smaller number");
    }
    CHECK(with(R"(["1", "-4", "1"])", 1, "=").reason ==
          "exponents of factors stay below a smaller number");
    for (const char* polynomial :
         {R"(["1"])", R"(["0", "1", "1"])", R"(["4", "-4", "1"])", R"(["5", "-5", "-1"])",
          R"(["10", "-10", "2"])", R"([])", R"(["1", "0", "1"])"})
        CHECK_THROWS_AS(with(polynomial, 0, "="), Error);
    CHECK_THROWS_AS(with(R"(["5", "-5", "1"])", 2, "="), Error);
    CHECK_THROWS_AS(with(R"(["5", "-5", "1"])", 1, "~"), Error);
    // Another word, an erased letter, one that does not come back.
    for (const char* table : {R"({"a": ["a a b"], "b": ["a"]})", R"({"a": ["a b"], "b": [""]})",
                              R"({"a": ["a b"], "b": ["b"]})", R"({"a": ["a b"], "b": ["b a"]})"}) {
        Json other = made;
        other["systems"]["T"]["tables"][0] = Json::parse(table);
        INFO(table);
        CHECK(found(other).outcome != Outcome::checked);
    }
}

TEST_CASE("circular systems have a synchronising delay, others powers of a word that grows") {
    struct Known {
        const char* rules;
        int delay;  // -1: not circular
    };
    for (const auto& [rules, delay] :
         {Known{fibonacci, 0}, Known{thue_morse, 3}, Known{"a -> aba; b -> bbbb", -1},
          Known{"a -> abc; b -> bcc; c -> c", 2}, Known{"a -> aab; b -> abb", 2}}) {
        const Json made = certificate_of(rules, "T is circular");
        INFO(made.dump(1));
        CHECK(entry(made)["verdict"] == (delay >= 0 ? "proved" : "refuted"));
        CHECK(found(made).outcome == Outcome::checked);
        if (delay < 0) continue;
        CHECK(entry(made)["proof"]["delay"] == delay);
        CHECK(found(changed(made, "proof/delay", delay + 1)).outcome == Outcome::checked);
        if (delay > 0)
            CHECK(found(changed(made, "proof/delay", delay - 1)).outcome == Outcome::wrong);
        CHECK(found(changed(made, "verdict", "refuted")).outcome == Outcome::wrong);
    }
    const Json made = certificate_of("a -> aba; b -> bbbb", "T is not circular");
    REQUIRE(entry(made)["proof"] == Json::parse(R"({"by":"repetition","word":"b","power":1})"));
    CHECK(found(changed(made, "proof/word", "a")).reason == "the square of the word is no factor");
    CHECK(found(changed(made, "proof/word", "b b")).reason ==
          "the word is a power of a shorter one");
    CHECK(found(changed(made, "proof/word", "")).outcome == Outcome::not_checked);
    CHECK(found(changed(made, "proof/power", 0)).outcome == Outcome::wrong);
    Json other = made;
    other["systems"]["T"]["tables"][0] = Json::parse(R"({"a": ["a b a"], "b": ["b b b a"]})");
    CHECK(found(other).reason == "the image of the word is no power of one of its conjugates");
    other["systems"]["T"]["tables"][0] = Json::parse(R"({"a": ["b b"], "b": ["b b"]})");
    CHECK(found(other).reason == "two letters have one image");
    // Not injective: windows may show it, or nothing is said.
    CHECK(entry(certificate_of("a -> abc; b -> a; c -> a", "T is circular"))["verdict"] ==
          "proved");
    CHECK(entry(certificate_of("a -> abcabc; b -> a; c -> bc", "T is circular"))["verdict"] ==
          "undecided");
    CHECK(entry(certificate_of("a -> abb; b -> ε", "T is circular"))["verdict"] == "undecided");
}

TEST_CASE("random morphisms: certificates of exponents and of circularity are checked" *
          doctest::test_suite("long")) {
    std::mt19937 generator(22);
    const auto below = [&](std::size_t bound) { return generator() % bound; };
    std::size_t drawn = 0, exponents = 0, checked = 0, changed_ones = 0, circular = 0,
                not_circular = 0;
    while (drawn < 40) {
        oracle::Rules rules;
        const std::size_t letters = 2 + below(2);
        std::string text;
        for (std::size_t a = 0; a < letters; ++a) {
            std::string image(1 + below(3), 'a');
            for (char& letter : image) letter = static_cast<char>('a' + below(letters));
            if (a == 0) image = "a" + image;
            rules[static_cast<char>('a' + a)] = image;
            text += (a ? "; " : "") + std::string(1, static_cast<char>('a' + a)) + " -> " + image;
        }
        if (!oracle::primitive_power(rules, "a")) continue;
        ++drawn;
        INFO(text);
        const Json cut = certificate_of(text, "T is circular");
        if (entry(cut)["verdict"] != "undecided") {
            REQUIRE(found(cut).outcome == Outcome::checked);
            ++(entry(cut)["verdict"] == "proved" ? circular : not_circular);
        }
        const Json made = certificate_of(text, "critical_exponent(T) >= 2");
        if (entry(made)["verdict"] == "undecided" || entry(made)["proof"]["by"] != "repetitions")
            continue;
        ++exponents;
        const verify::Finding finding = found(made);
        INFO(made.dump(1), finding.reason);
        REQUIRE(finding.outcome != Outcome::wrong);
        checked += finding.outcome == Outcome::checked;
        // A little more and a little less than the exponent.
        for (const char* number : {"5/2", "10"}) {
            const std::string digits = number;
            Json other =
                changed(made, "proof/exponent",
                        Json::parse(digits == "10" ? R"({"polynomial": ["-10", "1"], "root": 0})"
                                                   : R"({"polynomial": ["-5", "2"], "root": 0})"));
            if (other == made) continue;
            REQUIRE(found(other).outcome != Outcome::checked);
            ++changed_ones;
        }
    }
    MESSAGE(drawn, " primitive morphisms; ", exponents, " exponents, ", checked, " checked, ",
            changed_ones, " changed ones refused; ", circular, " circular, ", not_circular, " not");
    CHECK(exponents >= 15);
    CHECK(checked * 10 >= exponents * 9);
    CHECK(changed_ones >= exponents);
    CHECK(circular >= 20);
    CHECK(not_circular >= 5);
}
