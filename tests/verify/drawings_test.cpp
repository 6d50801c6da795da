#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <utility>

#include "exact/exact.hpp"
#include "verify/samples.hpp"

// Segments and boxes of figures, counted again from the turtle that stands in the certificate.

using namespace samples;
using Outcome = algae::verify::Finding::Outcome;

namespace {

const char* const statement = R"j({"numbers": ["distinct segments(X,3)", "=", "48"]})j";

/// The statements are the last field.
Json ordered(Json certificate) {
    const Json statements = certificate["statements"];
    certificate.erase("statements");
    certificate["statements"] = statements;
    return certificate;
}

/// A certificate of the statement with the turtle of X.
Json with_turtle(const Json& turtle, const char* said = statement) {
    Json made = certificate(Json::parse(said), "proved", Json::parse(R"({"by": "values"})"));
    made["turtles"] = Json{{"X", turtle}};
    return ordered(std::move(made));
}

algae::verify::Finding found(const Json& certificate) { return check(certificate).at(0); }

/// What is wrong with a certificate that is none.
std::string refused(const Json& certificate) {
    try {
        check(certificate);
    } catch (const algae::Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("segments are counted by the turtle of the certificate") {
    const auto outcome = [](const char* turtle, const char* said) {
        return found(with_turtle(Json::parse(turtle), said)).outcome;
    };
    const char *three = R"({"turn": "1/3", "letters": {"a": "F", "b": "+"}})",
               *right = R"({"turn": "-2/3", "letters": {"a": "F", "b": "+"}})",
               *square = R"({"turn": "1/4", "letters": {"a": "F", "b": "+"}})",
               *turned =
                   R"({"turn": "1/4", "heading": "1/2", "spin": "3/4", "letters": {"a": "F"}})";
    CHECK(outcome(three, statement) == Outcome::checked);
    CHECK(outcome(right, statement) == Outcome::checked);  // -2/3 of a turn is 1/3
    CHECK(outcome(square, statement) == Outcome::wrong);
    CHECK(outcome(square, R"j({"numbers": ["distinct segments(X,1)", "=", "2"]})j") ==
          Outcome::checked);
    // ab: a step to the left; abb aabba: four steps up.
    const auto boxes = [&](const char* generation, const char* side, const char* number) {
        const Json said{
            {"numbers",
             Json::array({"boxes(X," + std::string(generation) + "," + side + ")", "=", number})}};
        return outcome(turned, said.dump().c_str());
    };
    CHECK(boxes("0", "1", "2") == Outcome::checked);
    CHECK(boxes("0", "2", "2") == Outcome::checked);  // of [-1, 0] the point 0 is in the next one
    CHECK(boxes("1", "2", "3") == Outcome::checked);
    CHECK(boxes("1", "1/2", "9") == Outcome::checked);
    CHECK(boxes("1", "5", "1") == Outcome::checked);
    CHECK(boxes("1", "4", "1") == Outcome::wrong);
    CHECK(boxes("1", "0", "1") == Outcome::wrong);
    CHECK(boxes("1", "-1", "1") == Outcome::wrong);
    CHECK(boxes("1/2", "1", "1") == Outcome::wrong);
}

TEST_CASE("a figure without its turtle, or with a bracket too many, shows nothing") {
    Json bare = with_turtle(Json::parse(R"({"turn": "1/3", "letters": {"a": "F", "b": "+"}})"));
    bare.erase("turtles");
    CHECK(found(bare).outcome == Outcome::wrong);
    CHECK(found(bare).reason == "no turtle of the system 'X' is known");
    const auto closing =
        found(with_turtle(Json::parse(R"({"turn": "1/3", "letters": {"a": "F", "b": "]"}})")));
    CHECK(closing.outcome == Outcome::wrong);
    CHECK(closing.reason == "a bracket ] of the figure closes nothing");
    // The turtle is that of the system of the certificate, not of a bound one with its name.
    Json bound = with_turtle(
        Json::parse(R"({"turn": "1/3", "letters": {"a": "F", "b": "+"}})"),
        R"j({"for some": [{"name": "X", "of": "D0L systems", "size": 4}], "holds": {"numbers": ["distinct segments(X,3)", "=", "1"]}})j");
    bound["statements"][0]["proof"] = Json::parse(
        R"({"by": "instance", "values": {"X": {"axiom": "a", "tables": [{}]}}, "members": [], "with": [], "proof": {"by": "values"}})");
    CHECK(found(bound).outcome != Outcome::checked);
}

TEST_CASE("what goes beyond the bounds of figures is not checked") {
    const auto outcome = [](const char* turtle, const char* said) {
        algae::Budget budget;
        budget.memory = 256 << 20;
        budget.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
        return check(with_turtle(Json::parse(turtle), said), budget).at(0).outcome;
    };
    const char *three = R"({"turn": "1/3", "letters": {"a": "F", "b": "+"}})",
               *fine = R"({"turn": "1/361", "letters": {"a": "F", "b": "+"}})",
               *silent = R"({"turn": "1/4", "letters": {}})";
    CHECK(outcome(fine, statement) == Outcome::not_checked);
    CHECK(outcome(three, R"j({"numbers": ["distinct segments(X,30)", ">", "1"]})j") ==
          Outcome::not_checked);
    CHECK(outcome(silent, R"j({"numbers": ["distinct segments(X,30)", "=", "0"]})j") ==
          Outcome::not_checked);
    CHECK(outcome(three, R"j({"numbers": ["distinct segments(X,1000000)", "=", "0"]})j") ==
          Outcome::not_checked);
    CHECK(outcome(three, R"j({"numbers": ["boxes(X,2,1)", "=", "1"]})j") == Outcome::not_checked);
    const char* right = R"({"turn": "1/4", "letters": {"a": "F"}})";
    CHECK(outcome(right, R"j({"numbers": ["boxes(X,2,1/10^7)", "=", "1"]})j") ==
          Outcome::not_checked);
    CHECK(
        outcome(
            right,
            R"j({"for all": [{"name": "n", "of": "numbers"}], "holds": {"numbers": ["distinct segments(X,n)", "=", "1"]}})j") !=
        Outcome::checked);
}

TEST_CASE("a turtle that is not as it should be is refused") {
    const auto told = [](const char* turtle) { return refused(with_turtle(Json::parse(turtle))); };
    CHECK(told(R"({"turn": "1/3"})").find("turtles.X") != std::string::npos);
    CHECK(told(R"({"turn": "x", "letters": {}})").find("turtles.X.turn") != std::string::npos);
    CHECK(told(R"({"turn": "1/0", "letters": {}})").find("turtles.X.turn") != std::string::npos);
    CHECK(told(R"({"turn": 1, "letters": {}})").find("turtles.X.turn") != std::string::npos);
    CHECK(told(R"({"turn": "1/3", "letters": {"c": "F"}})")
              .find("'c' is not a letter of the alphabet") != std::string::npos);
    CHECK(told(R"({"turn": "1/3", "letters": {"a": "F&"}})")
              .find("expected commands of a turtle: F f + - | [ ]") != std::string::npos);
    CHECK(told(R"({"turn": "1/3", "letters": {}, "step": "2"})").find("step") != std::string::npos);
    Json other = with_turtle(Json::parse(R"({"turn": "1/3", "letters": {}})"));
    other["turtles"] = Json{{"Z", other["turtles"]["X"]}};
    CHECK(refused(other).find("no system is called 'Z'") != std::string::npos);
}

TEST_CASE("the definitions of a certificate tell its turtles") {
    std::vector<std::string> lines;
    Json two = with_turtle(Json::parse(R"({"turn": "1/3", "letters": {"a": "F", "b": "+"}})"));
    two["turtles"]["U"] =
        Json::parse(R"({"turn": "3/4", "heading": "1/4", "letters": {"b": "F[-f]+"}})");
    const std::string text = two.dump();
    algae::verify::check_certificate(
        algae::verify::source_of(text), "x", {},
        {.on_start = [&](const auto& read) { lines = algae::verify::definitions(read); }});
    REQUIRE(lines.size() > 2);
    CHECK(lines[lines.size() - 2] ==
          "the turtle of X: turns by 1/3 of a full turn; a does F; b does +");
    CHECK(lines.back() ==
          "the turtle of U: turns by 3/4 of a full turn, starts at 1/4 of it; b does F[-f]+");
}

namespace {

/// The distinct segments that commands draw, by coordinates (a, b) of a + b zeta for zeta = i or a sixth root of unity.
std::size_t segments_by_hand(const std::string& commands, bool square) {
    struct State {
        long a = 0, b = 0;
        int heading = 0;
    };
    const int full = square ? 4 : 6;
    const std::vector<std::pair<long, long>> ways =
        square ? std::vector<std::pair<long, long>>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}
               : std::vector<std::pair<long, long>>{{1, 0},  {0, 1},  {-1, 1},
                                                    {-1, 0}, {0, -1}, {1, -1}};
    State here;
    std::vector<State> saved;
    std::set<std::array<long, 4>> drawn;
    for (const char c : commands) {
        if (c == '+') here.heading = (here.heading + 1) % full;
        if (c == '-') here.heading = (here.heading + full - 1) % full;
        if (c == '|') here.heading = (here.heading + full / 2) % full;
        if (c == '[') saved.push_back(here);
        if (c == ']') {
            here = saved.back();
            saved.pop_back();
        }
        if (c != 'F' && c != 'f') continue;
        const State before = here;
        here.a += ways[static_cast<std::size_t>(here.heading)].first;
        here.b += ways[static_cast<std::size_t>(here.heading)].second;
        const std::pair from(before.a, before.b), to(here.a, here.b);
        const auto [low, high] = std::minmax(from, to);
        if (c == 'F') drawn.insert({low.first, low.second, high.first, high.second});
    }
    return drawn.size();
}

}  // namespace

TEST_CASE("segments of random commands are those that are counted by hand") {
    std::mt19937 random(3);
    const auto below = [&](std::size_t count) { return std::size_t{random() % count}; };
    std::size_t repeated = 0;
    for (int round = 0; round < 120; ++round) {
        const bool square = below(2) == 0;
        std::string commands;
        std::size_t open = 0, steps = 0;
        for (std::size_t left = 4 + below(30); left > 0; --left) {
            const char c = "FFFFff+-|[]"[below(11)];
            if (c == ']' && open == 0) continue;
            open += c == '[' ? 1u : 0u;
            open -= c == ']' ? 1u : 0u;
            steps += c == 'F' ? 1u : 0u;
            commands += c;
        }
        commands += std::string(open, ']');
        const std::size_t count = segments_by_hand(commands, square);
        repeated += count < steps ? 1u : 0u;
        CAPTURE(commands);
        CAPTURE(square);
        const Json turtle{{"turn", square ? "1/4" : "1/6"}, {"letters", {{"a", commands}}}};
        for (const std::size_t said : {count, count + 1}) {
            const Json numbers{
                {"numbers", Json::array({"distinct segments(X,0)", "=", std::to_string(said)})}};
            CHECK(found(with_turtle(turtle, numbers.dump().c_str())).outcome ==
                  (said == count ? Outcome::checked : Outcome::wrong));
        }
    }
    MESSAGE(repeated, " of 120 figures draw a segment twice");
    CHECK(repeated > 20);
}
