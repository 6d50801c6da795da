#include "turtle/turtle.hpp"

#include <doctest/doctest.h>

#include <numeric>

#include "exact/exact.hpp"
#include "model/model.hpp"

using namespace algae;

namespace {

/// A system with these symbols, and interpretations given as pairs.
struct Drawn {
    Model system;

    Symbol symbol(const std::string& name) { return system.alphabet.symbol(name); }
    void interpret(const std::string& name, const std::vector<std::string>& successor) {
        Production rule;
        rule.place = {"x.lsys", system.interpretation.size() + 1, 1};
        rule.predecessor.symbol = symbol(name);
        for (const std::string& part : successor) rule.successor.letters.push_back(symbol(part));
        system.interpretation.push_back(rule);
    }
    std::vector<Command> of(const std::string& name) {
        const Symbol a = symbol(name);
        return Commands(system, {a}).of(a);
    }
};

}  // namespace

TEST_CASE("every symbol of a turtle in the plane has its command") {
    Drawn drawn;
    drawn.system.drawing.scale = drawn.system.drawing.narrow = quantity(Rational(1, 2));
    const std::pair<const char*, Command> commands[] = {
        {"F", Command::draw},        {"F_l", Command::draw},       {"G", Command::draw_unmarked},
        {"f", Command::move},        {"f_1", Command::move},       {"+", Command::left},
        {"-", Command::right},       {"|", Command::back},         {"[", Command::push},
        {"]", Command::pop},         {"{", Command::open_polygon}, {"}", Command::close_polygon},
        {".", Command::vertex},      {"*", Command::scale},        {"!", Command::narrow},
        {"'", Command::next_colour}, {"%", Command::cut}};
    for (const auto& [name, command] : commands)
        CHECK_MESSAGE(drawn.of(name) == std::vector{command}, name);
    for (const char* name : {"X", "G_1", "A", "α", "Fx", "~"})
        CHECK_MESSAGE(drawn.of(name).empty(), name);
}

TEST_CASE("* and ! mean nothing where the file does not say what they do") {
    Drawn drawn;
    CHECK(drawn.of("*").empty());
    CHECK(drawn.of("!").empty());
}

TEST_CASE("interpretations are applied until none applies") {
    Drawn drawn;
    drawn.interpret("L", {"M", "+", "M"});
    drawn.interpret("M", {"F", "X"});
    CHECK(drawn.of("L") == std::vector{Command::draw, Command::left, Command::draw});
    drawn.interpret("F", {"f"});  // also of what is a command itself
    CHECK(drawn.of("M") == std::vector{Command::move});
    drawn.interpret("+", {});
    CHECK(drawn.of("L") == std::vector{Command::move, Command::move});
    const Symbol l = drawn.symbol("L");
    const Commands commands(drawn.system, {l});
    CHECK(commands.uses(Command::move));
    CHECK(!commands.uses(Command::draw));
}

TEST_CASE("an interpretation that goes round in circles is refused") {
    Drawn drawn;
    drawn.interpret("A", {"F", "A"});
    CHECK_THROWS_WITH_AS(drawn.of("A"), "x.lsys:1:1: the interpretation of A goes round in circles",
                         Error);
    Drawn two;
    two.interpret("A", {"B"});
    two.interpret("B", {"A"});
    CHECK_THROWS_WITH_AS(two.of("A"), "x.lsys:2:1: the interpretation of B goes round in circles",
                         Error);
    CHECK(two.of("F") == std::vector{Command::draw});
}

TEST_CASE("interpretations that double again and again are refused or harmless, and quick") {
    const auto doubling = [](const char* last) {
        Drawn drawn;
        for (int i = 0; i < 60; ++i) {
            const std::string next = "X_" + std::to_string(i + 1);
            drawn.interpret("X_" + std::to_string(i), {next, next});
        }
        drawn.interpret("X_60", {last});
        return drawn;
    };
    CHECK(doubling("Y").of("X_0").empty());
    CHECK_THROWS_WITH_AS(doubling("F").of("X_0"),
                         "x.lsys:44:1: the interpretation of X_43 has more than 100000 commands",
                         Error);
}

TEST_CASE("a long chain of interpretations needs no deep stack") {
    Drawn drawn;
    for (int i = 0; i < 100'000; ++i)
        drawn.interpret("X_" + std::to_string(i), {"X_" + std::to_string(i + 1)});
    drawn.interpret("X_100000", {"F"});
    CHECK(drawn.of("X_0") == std::vector{Command::draw});
}

TEST_CASE(
    "two interpretations of a symbol, and interpretations with more than a word, are refused") {
    Drawn drawn;
    drawn.interpret("A", {"F"});
    drawn.interpret("A", {"f"});
    CHECK_THROWS_WITH_AS(drawn.of("A"), "x.lsys:2:1: A has two interpretations, expected one",
                         Error);
    Drawn context;
    context.interpret("A", {"F"});
    context.system.interpretation[0].left = {{0, {}}};
    CHECK_THROWS_WITH_AS(context.of("A"),
                         "x.lsys:1:1: the interpretation of A is not a plain rule: drawing needs "
                         "one without context, "
                         "condition, probability or parameters",
                         Error);
}

TEST_CASE("symbols of a turtle in space are refused by name") {
    for (const char* name : {"&", "^", "\\", "/", "$"}) {
        Drawn drawn;
        drawn.system.name = "bush";
        CHECK_THROWS_WITH_AS(drawn.of(name),
                             ("the symbol " + std::string(name) +
                              " leaves the plane: bush is a figure in space, expected "
                              "one in the plane")
                                 .c_str(),
                             Error);
    }
}
