// Certificates of dimensions: sound ones are checked, changed ones are refused, and none that is accepted is false.

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "dimension/dimension.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "verify/verify.hpp"

using namespace algae;

namespace {

using Json = nlohmann::ordered_json;
using Outcome = verify::Finding::Outcome;

Json certificate_of(const std::string& system, const std::string& statement) {
    return certificate(check(
        read_claim("claim T\nlet G = D0L { " + system + " }\nshow " + statement, "x.claim", {})));
}

verify::Finding found(const Json& certificate) {
    Budget budget;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(100);
    return verify::check_certificate(certificate.dump(), "x", budget).front();
}

/// What becomes of a certificate, also where it cannot be read.
Outcome outcome(const Json& certificate) {
    try {
        return found(certificate).outcome;
    } catch (const Error&) {
        return Outcome::wrong;
    }
}

Json& proof(Json& certificate) { return certificate["statements"][0]["proof"]; }

const char* const koch = "axiom F; F -> F+F--F+F; angle 60";
const char* const dragon = "axiom FX; X -> X+YF+; Y -> -FX-Y";

}  // namespace

TEST_CASE("dimensions of curves are checked from the rules and the turtle") {
    struct Case {
        const char *system, *statement;
    };
    const Case cases[] = {
        {koch, "dimension(G) = log 4 / log 3"},
        {koch, "dimension(G) = log 16 / log 9"},
        {koch, "dimension(G) = log 4 / log 3 = 1.26186"},
        {koch, "dimension(G) != 1.26"},
        {koch, "not dimension(G) <= 5/4"},
        {koch, "dimension(G) >= 1.26"},
        {dragon, "dimension(G) = 2"},
        {dragon, "dimension(G) = log 2 / log sqrt 2"},
        {"axiom F; F -> F+F-F; angle 120", "dimension(G) = 2"},
        {"axiom F; F -> FfF; f -> fff", "dimension(G) = log 2 / log 3"},
        {"axiom XF; X -> YF+XF+Y; Y -> XF-YF-X; angle 60", "dimension(G) = log 3 / log 2"},
        {"axiom L; L -> +RF-LFL-FR+; R -> -LF+RFR+FL-", "dimension(G) = 2"},
        {"axiom X; X -> X+YF++YF-FX--FXFX-YF+; Y -> -FX+YFYF++YF+FX--FX-Y; angle 60",
         "dimension(G) = log 7 / log sqrt 7"},
        {"axiom F; F -> F[+F]F[-F]F; angle 180/7", "dimension(G) <= log 5 / log 3"},
    };
    for (const auto& [system, statement] : cases) {
        CAPTURE(std::string(system));
        CAPTURE(std::string(statement));
        const Json certificate = certificate_of(system, statement);
        CAPTURE(certificate.dump());
        const verify::Finding finding = found(certificate);
        CAPTURE(finding.reason);
        CHECK(finding.outcome == Outcome::checked);
    }
}

TEST_CASE("what a limit set is said to be wrongly is refused") {
    const auto refuses = [](const char* system, const char* statement, const char* name,
                            const std::function<void(Json&)>& change) {
        Json changed = certificate_of(system, statement);
        REQUIRE(found(changed).outcome == Outcome::checked);
        change(changed);
        CAPTURE(std::string(name));
        CHECK(outcome(changed) == Outcome::wrong);
    };
    const char* const is = "dimension(G) = log 4 / log 3";
    const auto equals = [](const char* number) {
        return [number](Json& c) { c["statements"][0]["statement"]["equals"] = number; };
    };
    refuses(koch, is, "another number", equals("log 5 / log 3"));
    refuses(koch, is, "a number near it", equals("1.261859507142914874199054228"));
    refuses(koch, is, "two numbers", equals("log 4 / log 3 = 2"));
    refuses(koch, is, "a wrong decimal", equals("log 4 / log 3 = 1.2618"));
    refuses(koch, is, "the opposite", [](Json& c) { c["statements"][0]["verdict"] = "refuted"; });
    refuses(koch, is, "fewer parts",
            [](Json& c) { c["systems"]["G"]["tables"][0]["F"][0] = "F + F - - F"; });
    refuses(koch, is, "another angle", [](Json& c) { c["turtles"]["G"]["turn"] = "1/3"; });
    refuses(koch, is, "no turtle", [](Json& c) { c["turtles"].erase("G"); });
    refuses(koch, is, "no neighbours", [](Json& c) { proof(c)["neighbours"] = Json::array(); });
    refuses(koch, is, "an upper bound only", [](Json& c) {
        for (const char* field : {"neighbours", "component", "discs"}) proof(c).erase(field);
    });
    refuses(koch, is, "discs that are too small", [](Json& c) {
        for (Json& disc : proof(c)["discs"]) disc[4] = "0.1";
    });
    refuses(koch, is, "discs elsewhere", [](Json& c) {
        for (Json& disc : proof(c)["discs"]) disc[2] = "7";
    });
    refuses(koch, is, "another way", [](Json& c) { proof(c)["ways"][0][2][0] = 5; });
    refuses(koch, is, "no ways", [](Json& c) { proof(c)["ways"] = Json::array(); });
    refuses(koch, is, "another scale", [](Json& c) { proof(c)["scale"][0][0] = 4; });
    refuses(koch, is, "another turn", [](Json& c) { proof(c)["turn"] = proof(c)["scale"]; });
    refuses(dragon, "dimension(G) = 2", "no phases", [](Json& c) { proof(c)["phases"] = 0; });
    // What draws nothing has no such set, and nothing is shown of it.
    Json nothing = certificate_of(koch, is);
    nothing["turtles"]["G"]["letters"]["F"] = "f";
    CHECK(outcome(nothing) == Outcome::not_checked);
    // The whole certificate of a curve whose parts lie apart, for one whose parts coincide.
    refuses("axiom F; F -> F+F-F-F+F", "dimension(G) = log 5 / log 3", "parts that coincide",
            [](Json& c) { c["systems"]["G"]["tables"][0]["F"][0] = "F + F - F | F | F"; });
}

namespace {

const char* const folded = "axiom F-F-F-F; F -> FF-F-F-F-F-F+F";
const char* const levy = "axiom F; F -> +F--F+; angle 45";
const char* const gosper =
    "axiom A; A -> A-B--B+A++AA+B-; B -> +A-BB--B-A++A+B; angle 60; interpret A -> F; interpret B "
    "-> F";
const char* const plant_f = "axiom X; X -> F-[[X]+X]+F[+FX]-X; F -> FF";

/// How many changes of a proof are refused, of those that are tried: each numeral of it, by another one.
struct Tampered {
    std::size_t changes = 0, wrong = 0, accepted = 0;
};

Tampered with_other_numbers(const Json& whole, std::size_t every) {
    Tampered out;
    std::vector<Json::json_pointer> places;
    const std::function<void(const Json&, const Json::json_pointer&)> note =
        [&](const Json& at, const Json::json_pointer& path) {
            if (at.is_number()) places.push_back(path);
            if (at.is_object())
                for (const auto& [key, part] : at.items()) note(part, path / key);
            if (at.is_array())
                for (std::size_t i = 0; i < at.size(); ++i) note(at[i], path / i);
        };
    Json copy = whole;
    note(proof(copy), Json::json_pointer("/statements/0/proof"));
    for (std::size_t k = 0; k < places.size(); k += every) {
        Json changed = whole;
        Json& at = changed[places[k]];
        at = at.get<std::uint64_t>() + 1;
        const Outcome what = outcome(changed);
        ++out.changes;
        out.wrong += what == Outcome::wrong ? 1 : 0;
        out.accepted += what == Outcome::checked ? 1 : 0;
    }
    return out;
}

void check_all(const std::vector<std::pair<std::string, std::string>>& cases,
               const std::string& field) {
    for (const auto& [system, statement] : cases) {
        CAPTURE(system);
        CAPTURE(statement);
        const Json certificate = certificate_of(system, statement);
        CAPTURE(certificate.dump().substr(0, 2000));
        CHECK(certificate["statements"][0]["proof"].contains(field));
        const verify::Finding finding = found(certificate);
        CAPTURE(finding.reason);
        CHECK(finding.outcome == Outcome::checked);
    }
}

}  // namespace

TEST_CASE("dimensions of curves whose parts coincide are checked by counting the different ones") {
    check_all({{folded, "dimension(G) = log 6 / log sqrt 10"},
               {folded, "not dimension(G) >= log 8 / log sqrt 10"},
               {"axiom F; F -> FF-F--F-F", "dimension(G) = log 5 / log 3"},
               {"axiom F; F -> F+F|F+F", "dimension(G) = 2"},
               {"axiom F; F -> F[+F]F[-F][F]", "dimension(G) <= 1.9"},
               {"axiom F; F -> F[+F]F[-F][F]", "not dimension(G) = 1.7"}},
              "neighbours");
}

TEST_CASE("dimensions with parts that coincide that are said wrongly are refused") {
    const Json whole = certificate_of(folded, "dimension(G) = log 6 / log sqrt 10");
    REQUIRE(found(whole).outcome == Outcome::checked);
    for (const char* other :
         {"log 8 / log sqrt 10", "log 7 / log sqrt 10", "log 5 / log sqrt 10", "1.5563", "3/2"}) {
        Json changed = whole;
        changed["statements"][0]["statement"]["equals"] = other;
        CHECK(outcome(changed) == Outcome::wrong);
    }
    // A rule with other overlaps, which the neighbours of the first do not show.
    Json rules = whole;
    rules["systems"]["G"]["tables"][0]["F"][0] = "F F - F - F - F - F F + F";
    CHECK(outcome(rules) != Outcome::checked);
    // Each neighbour that leads to parts in one place is needed, or seen to lie apart.
    const std::size_t count = proof(rules)["neighbours"].size();
    REQUIRE(count > 3);
    std::size_t refused = 0;
    for (std::size_t k = 0; k < count; ++k) {
        Json changed = whole;
        proof(changed)["neighbours"].erase(k);
        refused += outcome(changed) == Outcome::wrong ? 1 : 0;
    }
    MESSAGE(refused, " of ", count, " neighbours are needed");
    CHECK(refused == count);
    const Tampered numbers = with_other_numbers(whole, 1);
    MESSAGE(numbers.changes, " numbers changed, ", numbers.wrong, " wrong, ", numbers.accepted,
            " accepted");
    CHECK(numbers.changes > 20);
    // What a number in it does not matter for (a disc that is larger) may stay: the statement is true.
    CHECK(numbers.wrong * 10 > numbers.changes * 8);
}

TEST_CASE("dimensions of boundaries are checked") {
    const std::string cubic = "log the largest real root of x^3 - x^2 - 2 / log sqrt 2";
    check_all({{dragon, "boundary(G) = " + cubic},
               {dragon, "boundary(G) >= 1.5236"},
               {dragon, "not boundary(G) <= 1.5236"},
               {"axiom F; F -> F+F-F; angle 120", "boundary(G) = log 4 / log 3"},
               {"axiom F; F -> F+F-F; angle 120", "not boundary(G) = 1.26"},
               {levy, "boundary(G) >= 1.934007"},
               {levy, "boundary(G) <= 1.934008"},
               {gosper, "boundary(G) = log 3 / log sqrt 7"},
               {"axiom F++++F; F -> -F++G-; G -> +F--G+; angle 45", "boundary(G) = " + cubic},
               {"axiom X; X -> -YF+XFX+FY-; Y -> +XF-YFY-FX+", "boundary(G) = 1"},
               {"axiom F; F -> F+F--F+F; angle 90", "boundary(G) = 1"}},
              "discs");
}

TEST_CASE("boundaries that are said wrongly are refused") {
    for (const auto& [system, is, others] :
         std::vector<std::tuple<std::string, std::string, std::vector<std::string>>>{
             {"axiom F; F -> F+F-F; angle 120",
              "log 4 / log 3",
              {"1", "1.2618", "log 5 / log 3", "2"}},
             {gosper, "log 3 / log sqrt 7", {"1", "1.13", "log 2 / log sqrt 7", "2"}}}) {
        CAPTURE(system);
        const Json whole = certificate_of(system, "boundary(G) = " + is);
        REQUIRE(found(whole).outcome == Outcome::checked);
        for (const std::string& other : others) {
            Json changed = whole;
            changed["statements"][0]["statement"]["equals"] = other;
            CHECK(outcome(changed) == Outcome::wrong);
        }
        // The proof of a boundary is none of the dimension, and the reverse.
        Json of_all = whole;
        of_all["statements"][0]["statement"] = {{"dimension", "G"}, {"equals", is}};
        CHECK(outcome(of_all) == Outcome::wrong);
        const Tampered numbers = with_other_numbers(whole, 1);
        MESSAGE(numbers.changes, " numbers changed, ", numbers.wrong, " wrong, ", numbers.accepted,
                " accepted");
        CHECK(numbers.changes > 8);
        CHECK(numbers.wrong * 2 > numbers.changes);
    }
    // Koch's curve has no inner points, and is of one kind.
    Json koch_boundary = certificate_of(koch, "dimension(G) = log 4 / log 3");
    koch_boundary["statements"][0]["statement"] = {{"boundary", "G"}, {"equals", "1"}};
    CHECK(outcome(koch_boundary) == Outcome::wrong);
    CHECK(found(koch_boundary).reason == "it is not seen that the set fills an area");
    for (const char* name : {"neighbours", "component"}) proof(koch_boundary).erase(name);
    CHECK(outcome(koch_boundary) != Outcome::checked);
    // The boundary of a set of several kinds is not where its parts meet.
    Json kinds = certificate_of(gosper, "dimension(G) = 2");
    kinds["statements"][0]["statement"] = {{"boundary", "G"}, {"equals", "log 3 / log sqrt 7"}};
    CHECK(found(kinds).reason == "the set is not of one kind");
    // Without discs nothing is known of what meets.
    Json discs = certificate_of(gosper, "boundary(G) = log 3 / log sqrt 7");
    proof(discs).erase("discs");
    CHECK(found(discs).reason == "the pieces have no discs");
}

TEST_CASE("certified bounds of dimensions are checked") {
    check_all({{plant_f, "dimension(G) <= 1.97"},
               {plant_f, "not dimension(G) >= 1.97"},
               {plant_f, "dimension(G) >= 1.2"},
               {plant_f, "not dimension(G) <= 1.2"}},
              "bounds");
}

TEST_CASE("nearer certified bounds of dimensions are checked" * doctest::test_suite("long")) {
    check_all({{plant_f, "dimension(G) <= 1.95"}, {plant_f, "dimension(G) >= 1.5"}}, "bounds");
}

TEST_CASE("where cells of pairs take too much memory, that is why a bound is not checked") {
    const Json below = certificate_of(plant_f, "dimension(G) >= 1.2");
    Budget budget;
    budget.memory = 1 << 20;
    const verify::Finding finding = verify::check_certificate(below.dump(), "x", budget).front();
    CHECK(finding.outcome == Outcome::not_checked);
    CHECK(finding.reason == "the cells of pairs would take more than the 1 MiB allowed");
}

TEST_CASE("what is said wrongly of bounds is refused") {
    const Json above = certificate_of(plant_f, "dimension(G) <= 1.97");
    REQUIRE(found(above).outcome == Outcome::checked);
    Json none = above;
    proof(none).erase("bounds");
    CHECK(outcome(none) == Outcome::wrong);
    Json named = above;
    proof(named)["bounds"] = "from aside";
    CHECK_THROWS_WITH_AS(found(named), doctest::Contains("expected 'from above' or 'from below'"),
                         Error);
    Json opposite = above;
    opposite["statements"][0]["verdict"] = "refuted";
    CHECK(outcome(opposite) == Outcome::wrong);
}

#ifdef __SANITIZE_ADDRESS__
constexpr bool takes_minutes = true;  // ten of them; nearer bounds go through the same code
#else
constexpr bool takes_minutes = false;
#endif

TEST_CASE("bounds that are said too near are not accepted" * doctest::test_suite("long") *
          doctest::skip(takes_minutes)) {
    const Json above = certificate_of(plant_f, "dimension(G) <= 1.95");
    REQUIRE(found(above).outcome == Outcome::checked);
    const Json below = certificate_of(plant_f, "dimension(G) >= 1.5");
    REQUIRE(found(below).outcome == Outcome::checked);
    const auto with = [](Json changed, const char* name, const char* number) {
        changed["statements"][0]["statement"][name] = number;
        return outcome(changed);
    };
    CHECK(with(above, "at most", "1.2") == Outcome::not_checked);
    CHECK(with(below, "at least", "1.95") == Outcome::not_checked);
    // Of one side nothing is shown of the other.
    Json other = above;
    other["statements"][0]["statement"] = {{"dimension", "G"}, {"at least", "1.5"}};
    CHECK(outcome(other) == Outcome::not_checked);
}

TEST_CASE("each neighbour of a curve whose parts touch is needed, or seen to lie apart") {
    Json whole = certificate_of(dragon, "dimension(G) = 2");
    const std::size_t count = proof(whole)["neighbours"].size();
    REQUIRE(count > 5);
    std::size_t refused = 0;
    for (std::size_t k = 0; k < count; ++k) {
        Json changed = whole;
        proof(changed)["neighbours"].erase(k);
        refused += outcome(changed) == Outcome::wrong ? 1 : 0;
    }
    CHECK(refused == count);
}

TEST_CASE("no changed certificate of a dimension is accepted with a false statement") {
    const std::vector<std::pair<std::string, std::string>> samples = {
        {koch, "log 4 / log 3"},
        {dragon, "2"},
        {"axiom F; F -> F+F-F; angle 120", "log 3 / log sqrt 3"},
        {"axiom XF; X -> YF+XF+Y; Y -> XF-YF-X; angle 60", "log 3 / log 2"},
        {"axiom F; F -> F+F-F-FF+F+F-F", "log 8 / log 4"},
    };
    std::mt19937_64 random(5);
    const auto below = [&](std::size_t count) {
        return static_cast<std::size_t>(random() % count);
    };
    std::size_t mutants = 0, refused = 0, accepted = 0;
    for (const auto& [system, value] : samples) {
        const Json whole = certificate_of(system, "dimension(G) = " + value);
        REQUIRE(found(whole).outcome == Outcome::checked);
        for (int k = 0; k < 60; ++k) {
            Json changed = whole;
            std::vector<Json::json_pointer> places;
            const std::function<void(const Json&, const Json::json_pointer&)> note =
                [&](const Json& at, const Json::json_pointer& path) {
                    if (at.is_number() || at.is_string()) places.push_back(path);
                    if (at.is_object())
                        for (const auto& [key, part] : at.items()) note(part, path / key);
                    if (at.is_array())
                        for (std::size_t i = 0; i < at.size(); ++i) note(at[i], path / i);
                };
            note(proof(changed), Json::json_pointer("/statements/0/proof"));
            note(changed["turtles"], Json::json_pointer("/turtles"));
            for (int i = 0; i < 20; ++i)
                places.emplace_back("/systems/G/tables/0/" + std::string(below(2) ? "F" : "X"));
            const Json::json_pointer place = places[below(places.size())];
            if (!changed.contains(place)) continue;
            Json& at = changed[place];
            if (at.is_array()) {  // a successor: one letter is another one
                std::string word = at[0].get<std::string>();
                static const std::string letters = "F+-XY ";
                if (word.empty()) continue;
                const std::size_t i = 2 * below((word.size() + 1) / 2);
                word[i] = letters[below(5)];
                at[0] = word;
            } else if (at.is_number()) {
                at = below(4) == 0 ? Json("-1") : Json(at.get<std::uint64_t>() + 1 + below(2));
            } else {
                std::string text = at.get<std::string>();
                if (text.empty()) continue;
                text[below(text.size())] = "0123456789-/F"[below(13)];
                at = text;
            }
            if (changed == whole) continue;
            ++mutants;
            verify::Finding finding;
            try {
                finding = found(changed);
            } catch (const Error&) {
                ++refused;
                continue;
            }
            if (finding.outcome != Outcome::checked) {
                ++refused;
                continue;
            }
            ++accepted;
            // What it says, by the room dimension.
            const Json& rules = changed["systems"]["G"]["tables"][0];
            const Json& turtle = changed["turtles"]["G"];
            std::string text =
                "axiom " + changed["systems"]["G"]["axiom"].get<std::string>() + "; angle " +
                to_string(Rational(turtle["turn"].get<std::string>()) * Rational(360));
            for (const auto& [letter, successors] : rules.items())
                if (letter != "+" && letter != "-")
                    text += "; " + letter + " -> " + successors[0].get<std::string>();
            for (const auto& [letter, told] : turtle["letters"].items())
                if (told.get<std::string>() != letter)
                    text += "; interpret " + letter + " -> " + told.get<std::string>();
            CAPTURE(text);
            const ExactDimension exact = exact_dimension(read_lsystem(text, "m.lsys"));
            REQUIRE(exact.value);
            const double known = exact.value->enclosure(64).midpoint();
            const double said = value == "log 4 / log 3"   ? std::log(4) / std::log(3)
                                : value == "log 3 / log 2" ? std::log(3) / std::log(2)
                                : value == "log 8 / log 4" ? 1.5
                                                           : 2.0;
            CHECK(exact.status == ExactDimension::Status::exact);
            CHECK(std::abs(known - said) < 1e-9);
        }
    }
    MESSAGE(mutants, " changed, ", refused, " refused, ", accepted, " accepted");
    CHECK(mutants > 150);
    CHECK(refused > mutants / 2);
}
