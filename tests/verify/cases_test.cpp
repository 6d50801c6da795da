// Statements about all values within bounds: a certificate with a case missing is found wrong, whichever it is, and the
// instances that are written down again are those of an oracle.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "oracle/labelled_instances.hpp"
#include "verify/verify.hpp"

using namespace algae;
using Outcome = verify::Finding::Outcome;

namespace {

using Json = nlohmann::ordered_json;

Json certificate_of(const std::string& theorem, const std::string& before = "") {
    return certificate(check(read_claim("claim T\n" + before + "theorem " + theorem, "x", {})));
}

verify::Finding found(const Json& certificate) {
    return verify::check_certificate(certificate.dump(1), "x.json", {}).at(0);
}

/// Whether the certificate is wrong or not even well formed.
bool is_refused(const Json& certificate) {
    try {
        return found(certificate).outcome == Outcome::wrong;
    } catch (const Error&) {
        return true;
    }
}

Json& cases_of(Json& certificate) { return certificate["statements"][0]["proof"]["cases"]; }

/// A statement and the instances that it is about, for the oracle.
struct Sample {
    const char* theorem;
    std::vector<oracle::LabelledDomain> domains = {};
    std::size_t size = 0;     // of the largest instance
    std::size_t letters = 0;  // that occur in one
    bool disjoint = false;
};

const std::vector<Sample>& samples() {
    using Domain = oracle::LabelledDomain;
    static const std::vector<Sample> all{
        {"for all finite languages A up to size 5: A is finite",
         {Domain{.greatest_size = 5}},
         5,
         4},
        {"for all finite languages A, B up to size 3: A | B is finite",
         {Domain{.greatest_size = 3}, Domain{.greatest_size = 3}},
         6,
         4},
        {"for all finite languages A, B up to size 3 over different letters: A | B is finite",
         {Domain{.greatest_size = 3}, Domain{.greatest_size = 3}},
         6,
         4,
         true},
        {"for all D0L systems G up to size 6: L(G) is D0L",
         {Domain{.kind = 'S', .deterministic = true, .greatest_size = 6}},
         6,
         3},
        {"for all P0L systems G up to size 6: L(G) is 0L",
         {Domain{.kind = 'S', .nonempty = true, .greatest_size = 6}},
         6,
         3},
        {"for all DT0L systems G up to size 6 with words up to length 2: L(G) is T0L",
         {Domain{.kind = 'S',
                 .deterministic = true,
                 .tables = true,
                 .greatest_size = 6,
                 .greatest_length = 2}},
         6,
         3},
        {"for all 0L systems G up to size 3 and words w up to length 2: {w} | L(G) is not empty",
         {Domain{.kind = 'S', .greatest_size = 3}, Domain{.kind = 'w', .greatest_length = 2}},
         6,
         4},
        {"for all letters x, y and words w up to length 1: {x w y} is 0L",
         {Domain{.kind = 'x'}, Domain{.kind = 'x'}, Domain{.kind = 'w', .greatest_length = 1}},
         4,
         3},
        {"for all finite languages A up to size 3 and morphisms h with words up to length 1: "
         "h(A) is finite",
         {Domain{.greatest_size = 3}, Domain{.kind = 'h', .greatest_length = 1}},
         7,
         4},
        {"for all finite languages A up to size 3 and codings h: h(A) is finite",
         {Domain{.greatest_size = 3}, Domain{.kind = 'h', .coding = true, .nonempty = true}},
         7,
         4},
        {"for all finite languages A up to size 2 and finite substitutions s up to size 4: "
         "s(A) is finite",
         {Domain{.greatest_size = 2}, Domain{.kind = 's', .greatest_size = 4}},
         6,
         4},
    };
    return all;
}

}  // namespace

TEST_CASE(
    "a statement shown by cases is checked, and there are as many cases as an oracle counts") {
    for (const Sample& sample : samples()) {
        CAPTURE(sample.theorem);
        Json written = certificate_of(sample.theorem);
        CHECK(found(written).outcome == Outcome::checked);
        std::set<std::string> classes;
        for (std::size_t size = 0; size <= sample.size; ++size)
            for (const auto& tuple :
                 oracle::labelled_tuples(sample.domains, size, sample.letters, sample.disjoint))
                classes.insert(oracle::least_renamed(tuple, sample.letters));
        CHECK(cases_of(written).size() == classes.size());
    }
}

TEST_CASE("no case can be left out, also where another one is there twice or has its values") {
    const auto is_missed = [](const Json& bad) {
        const verify::Finding one = found(bad);
        return one.outcome == Outcome::wrong &&
               one.reason.find("there is no case for") != std::string::npos;
    };
    for (const Sample& sample : samples()) {
        CAPTURE(sample.theorem);
        const Json written = certificate_of(sample.theorem);
        CHECK(rc::check([&] {
            Json bad = written;
            Json& cases = cases_of(bad);
            const auto removed = *rc::gen::inRange<std::size_t>(0, cases.size());
            const auto other = *rc::gen::inRange<std::size_t>(0, cases.size());
            RC_PRE(removed != other || cases.size() == 1);
            const int way = *rc::gen::inRange(0, 3);
            if (way == 1) cases.push_back(Json(cases[other]));
            if (way == 2 && cases.size() > 1)
                cases[removed]["values"] = Json(cases[other]["values"]);
            else
                cases.erase(removed);
            const verify::Finding one = found(bad);
            RC_ASSERT(one.outcome == Outcome::wrong);
            RC_ASSERT(way == 2 || is_missed(bad));
        }));
    }
}

TEST_CASE("the order of cases and the names of their letters do not matter") {
    Json written = certificate_of("for all finite languages A up to size 4: A is finite");
    Json& cases = cases_of(written);
    std::reverse(cases.begin(), cases.end());
    CHECK(found(written).outcome == Outcome::checked);
    for (Json& one : cases)
        for (Json& word : one["values"]["A"]["words"]) {
            std::string text = word.get<std::string>();
            for (char& c : text)
                if (c != ' ') c = static_cast<char>('a' + ('k' - c));
            word = text;
        }
    CHECK(found(written).outcome == Outcome::checked);
    // But a letter that the statement names is not renamed.
    Json named = certificate_of("for all finite languages A up to size 2: A | {a} is finite");
    CHECK(found(named).outcome == Outcome::checked);
    for (Json& one : cases_of(named))
        for (Json& word : one["values"]["A"]["words"])
            if (word == "a") word = "c";
    CHECK(found(named).reason == "there is no case for A = {a}");
}

TEST_CASE("a case shows the body, or that a condition does not hold, or that a value is outside") {
    Json written = certificate_of(
        "for all 0L languages A with words up to length 2 over {a}: A is "
        "finite");
    REQUIRE(found(written).outcome == Outcome::checked);
    std::size_t outside = 0, unmet = 0;
    for (Json& one : cases_of(written)) {
        if (one.contains("member")) {
            ++outside;
            Json bad = written;
            for (Json& each : cases_of(bad))
                if (each == one) each.erase("member");
            CHECK(is_refused(bad));
        }
        if (one.contains("condition")) ++unmet;
    }
    CHECK(outside > 0);
    CHECK(unmet == 0);
    Json met = certificate_of(
        "for all finite languages A with words up to length 1 over {a, b} with a in A: {a} <= A");
    REQUIRE(found(met).outcome == Outcome::checked);
    for (Json& one : cases_of(met))
        if (one.contains("condition")) {
            ++unmet;
            Json bad = met;
            for (Json& each : cases_of(bad))
                if (each == one) each["condition"] = 1;
            CHECK(found(bad).outcome == Outcome::wrong);
        }
    CHECK(unmet == 4);
    Json some = certificate_of("for some finite language A up to size 3: A is infinite");
    CHECK(some["statements"][0]["verdict"] == "refuted");
    CHECK(found(some).outcome == Outcome::checked);
    some["statements"][0]["verdict"] = "proved";
    CHECK(found(some).outcome == Outcome::wrong);
}

TEST_CASE("a larger bound needs more cases") {
    for (const Sample& sample : samples()) {
        CAPTURE(sample.theorem);
        Json written = certificate_of(sample.theorem);
        for (Json& name : written["statements"][0]["statement"]["for all"])
            for (const char* bound : {"size", "length"}) {
                if (!name.contains(bound)) continue;
                Json wider = written;
                for (Json& same : wider["statements"][0]["statement"]["for all"])
                    if (same["name"] == name["name"])
                        same[bound] = name[bound].get<std::uint64_t>() + 1;
                const bool is_same = name["of"] == "DT0L systems" && bound[0] == 'l';
                CHECK((found(wider).outcome == Outcome::wrong || is_same));
                Json without = written;
                for (Json& same : without["statements"][0]["statement"]["for all"])
                    if (same["name"] == name["name"]) same.erase(bound);
                CHECK(found(without).outcome != Outcome::checked);
            }
    }
}

TEST_CASE("more cases than a certificate holds are not written, and not checked") {
    const Json many = certificate_of(
        "for all finite languages A, B with words up to length 2 over {a, b}: A is finite or B is "
        "0L");
    CHECK(many["statements"][0]["verdict"] == "proved");
    CHECK(many["statements"][0]["proof"] == Json{{"by", "cases"}, {"instances", 16384}});
    CHECK(found(many).outcome == Outcome::not_checked);
    CHECK(found(many).reason ==
          "there are more cases than a certificate holds, of 16384 instances");
}

TEST_CASE("letters of a quantifier within another one are not renamed") {
    // {a} is a set over the letter a, and {b} is none.
    const Json written = certificate_of(
        "for all finite languages A up to size 2 with A is not empty: for some finite language B "
        "with words up to length 1 over {a}: A == B");
    CHECK(written["statements"][0]["verdict"] == "refuted");
    CHECK(found(written).outcome == Outcome::checked);
    const Json true_one = certificate_of(
        "for all finite languages A up to size 2: for some finite language B up to size 2: A == B");
    CHECK(true_one["statements"][0]["verdict"] == "proved");
    CHECK(found(true_one).outcome == Outcome::checked);
}

TEST_CASE("complements of bound names are over the letters of all values and of the file") {
    const Json written =
        certificate_of("for all finite languages A up to size 3: ~A is infinite or A <= {ε}");
    CHECK(written["statements"][0]["verdict"] == "proved");
    const verify::Finding one = found(written);
    CHECK(one.outcome == Outcome::checked);
    CHECK(one.statement ==
          "for all finite languages A up to size 3: (complement of A over the letters of the "
          "values is not finite) or (A <= {ε})");
    const Json other = certificate_of("for some finite language A up to size 3: a in ~A");
    CHECK(found(other).outcome == Outcome::checked);
    for (const char* const law :
         {"~(A | B) == ~A & ~B", "~(A & B) == ~A | ~B", "~~A == A", "A \\ B == A & ~B",
          "~(A | C) == ~A & ~C", "A & ~A is empty", "~A <= ~B | B"}) {
        const Json all = certificate_of(
            "for all finite languages A, B up to size 2: " + std::string(law), "let C = {c}\n");
        INFO(law);
        CHECK(all["statements"][0]["verdict"] == "proved");
        CHECK(found(all).outcome == Outcome::checked);
    }
}

TEST_CASE(
    "systems with the empty word as axiom are instances too, so cases without them decide "
    "nothing") {
    const Json written = certificate_of("for all D0L systems G up to size 3: L(G) is not empty",
                                        "allow empty axiom\n");
    CHECK(written["statements"][0]["verdict"] == "undecided");
    Json forged = certificate_of("for all D0L systems G up to size 3: L(G) is not empty");
    CHECK(found(forged).outcome == Outcome::checked);
    const Json statements = forged["statements"];
    forged.erase("statements");
    forged["empty axiom"] = true;
    forged["statements"] = statements;  // which come last
    CHECK(found(forged).outcome == Outcome::not_checked);
}
