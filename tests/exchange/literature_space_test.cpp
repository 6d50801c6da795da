#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "exchange/compared.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"
#include "turtle/turtle.hpp"

// Systems of the literature in space and with parameters, as people write them for cpfg, lpfg and L-Py. What is read of each must leave the
// same strokes, as many as are known, and so must what is printed of it in each of these formats. In cpfg `/` rolls the other way, and `//` would
// be a comment.

using namespace algae;
using namespace algae::exchange_tests;

namespace {

struct Known {
    const char* name;
    std::string cpfg, lpfg, lpy;
    std::vector<std::size_t> segments;  // of generations 0, 1, ...
};

/// Lengths of the strokes of a generation, added up.
double drawn_length(const Scene& scene) {
    double sum = 0;
    for (const Rod& rod : scene.rods) sum += length(rod.to - rod.from);
    return sum;
}

std::string cpfg(const std::string& axiom, const std::string& rules,
                 const std::string& drawn = "") {
    return "Lsystem: 1\nderivation length: 3\nAxiom: " + axiom + "\n" + rules +
           (drawn.empty() ? "" : "homomorphism\n" + drawn) + "endlsystem\n";
}
std::string lpfg(const std::string& modules, const std::string& axiom, const std::string& rules) {
    return "#include <lpfgall.h>\nderivation length: 3;\n" + modules + "Axiom: " + axiom +
           ";\nproduction:\n" + rules;
}
std::string lpy(const std::string& before, const std::string& axiom, const std::string& rules,
                const std::string& drawn = "") {
    return before + "Axiom: " + axiom + "\nderivation length: 3\nproduction:\n" + rules +
           (drawn.empty() ? "" : "interpretation:\n" + drawn) + "endlsystem\n";
}

/// The turns of a text in the notation of L-Py with this angle, for L+C: each module behind the other, and blanks between.
std::string plus(const std::string& text, const std::string& angle) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const std::string turn = c == '+'    ? "Left"
                                 : c == '-'  ? "Right"
                                 : c == '&'  ? "Down"
                                 : c == '^'  ? "Up"
                                 : c == '/'  ? "RollL"
                                 : c == '\\' ? "RollR"
                                             : "";
        const bool has_number = i + 1 < text.size() && text[i + 1] == '(';
        if (c == '(') {
            const std::size_t end = text.find(')', i);
            out += text.substr(i, end + 1 - i);
            i = end;
            continue;
        }
        out += " ";
        if (!turn.empty())
            out += turn + (has_number ? "" : "(" + angle + ")");
        else if (c == '|')
            out += "TurnAround()";
        else if (c == '[')
            out += "SB()";
        else if (c == ']')
            out += "EB()";
        else if (c == 'F' || c == 'f')
            out += std::string(1, c) + (has_number ? "" : "(1)");
        else
            out += std::string(1, c) + (has_number ? "" : "()");
    }
    return out;
}
/// The same for cpfg: its rolls, apart, but not the quotients in numbers.
std::string other_rolls(const std::string& text) {
    std::string out;
    int inside = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        inside += c == '(' ? 1 : c == ')' ? -1 : 0;
        const bool rolls = inside == 0 && (c == '/' || c == '\\');
        out += !rolls ? c : c == '/' ? '\\' : '/';
        if (rolls && (i + 1 == text.size() || text[i + 1] != '(')) out += ' ';
    }
    return out;
}

struct Rule {
    std::string head, condition, image;
};

/// The files of a system whose rules have parameters `x`, `y` of whatever number.
Known known(const char* name, const std::string& modules, const std::string& axiom,
            const std::vector<Rule>& rules, const std::string& angle,
            const std::vector<std::size_t>& segments) {
    std::string of_cpfg, of_lpfg, of_lpy;
    for (const Rule& rule : rules) {
        const std::string head = rule.head == "F" ? "F(x)" : plus(rule.head, angle);
        of_cpfg += rule.head + (rule.condition.empty() ? "" : " : " + rule.condition) + " --> " +
                   other_rolls(rule.image) + "\n";
        of_lpfg += head + " : {\n  " +
                   (rule.condition.empty() ? "" : "if (" + rule.condition + ") ") + "produce" +
                   plus(rule.image, angle) + ";\n}\n";
        of_lpy += rule.condition.empty() ? rule.head + " --> " + rule.image + "\n"
                                         : rule.head + " :\n    if " + rule.condition +
                                               " : produce " + rule.image + "\n";
    }
    std::string turns;
    for (const char c : std::string("+-&^/\\")) {
        const std::string sign(1, c);
        turns += sign + " --> " + sign + "(" + angle + ")\n";
    }
    return {name, cpfg(other_rolls(axiom), of_cpfg, turns),
            lpfg(modules, plus(axiom, angle), of_lpfg), lpy("", axiom, of_lpy, turns), segments};
}

std::vector<Known> known_systems() {
    return {
        known("Hilbert curve in space, Prusinkiewicz and Lindenmayer 1990, 1.19",
              "module A(); module B(); module C(); module D();\n", "A",
              {{"A", "", "B-F+CFC+F-D&F^D-F+&&CFC+F+B//"},
               {"B", "", "A&F^CFB^F^D^^-F-D^|F^B|FC^F^A//"},
               {"C", "", "|D^|F^B-F+C^F^A&&FA&F^C+F+B^F^D//"},
               {"D", "", "|CFB-F+B|FA&F^A&&FB-F+B|FC//"}},
              "90", {0, 7, 63}),
        known("bush in space, Prusinkiewicz and Lindenmayer 1990, 1.25, without leaves",
              "module A(); module S();\n", "A",
              {{"A", "", "[&FA]/////[&FA]///////[&FA]"}, {"F", "", "S/////F"}, {"S", "", "F"}},
              "22.5", {0, 3, 12, 42}),
        known("row of trees, Prusinkiewicz and Lindenmayer 1990, 1.39", "", "F(1)",
              {{"F(x)", "", "F(x*0.3)+F(x*0.4582)--F(x*0.4582)+F(x*0.7)"}}, "86", {1, 4, 16, 64}),
        known("branches of one ratio, Prusinkiewicz and Lindenmayer 1990, 1.15",
              "module A(float);\n", "A(1)", {{"A(s)", "", "F(s)[+A(s/1.456)][-A(s/1.456)]"}}, "85",
              {0, 1, 3, 7}),
        known("ternary tree, Prusinkiewicz and Lindenmayer 1990, 2.8", "module A();\n",
              "F(200)/(45)A",
              {{"A", "", "F(50)[&(18.95)F(50)A]/(94.74)[&(18.95)F(50)A]/(132.63)[&(18.95)F(50)A]"},
               {"F(l)", "", "F(l*1.109)"}},
              "90", {1, 5, 17, 53}),
        known("compound leaf, Prusinkiewicz and Lindenmayer 1990, 5.11", "module A(float);\n",
              "A(0)",
              {{"A(d)", "d > 0", "A(d-1)"},
               {"A(d)", "d <= 0", "F(1)[+A(1)][-A(1)]F(1)A(0)"},
               {"F(a)", "", "F(a*1.5)"}},
              "45", {0, 2, 4, 10}),
        known("spiral of leaves at 137.5 degrees, after Prusinkiewicz and Lindenmayer 1990, 4",
              "module A(float);\n", "A(0)",
              {{"A(n)", "", "/(137.5)[&(10+n*10)F(1+n/4)]f(0.1)A(n+1)"}}, "90", {0, 1, 2, 3}),
        known("monopodial tree, Honda 1971, without gravity", "module A(float); module B(float);\n",
              "A(1)",
              {{"A(l)", "", "F(l)[&(45)B(l*0.6)]/(137.5)A(l*0.9)"},
               {"B(l)", "l > 0.1", "F(l)[-(45)B(l*0.6)][+(45)B(l*0.9)]"}},
              "90", {0, 1, 3, 7}),
        known("quartering of a cube's edges, after Sierpinski", "module X();\n", "X",
              {{"X", "", "[F+X][F&X][F^X]/F"}, {"F", "", "FF"}}, "90", {0, 4, 20, 76}),
        known("helix with branches", "module A(float);\n", "A(8)",
              {{"A(n)", "n > 0", "F(1)/(40)&(15)[+(50)F(n/8)]A(n-1)"}}, "90", {0, 2, 4, 6}),
    };
}

}  // namespace

TEST_CASE(
    "systems of the literature in space and with parameters are the same in the files of three "
    "programs") {
    const char* const formats[] = {"cpfg", "lpfg", "lpy"};
    std::size_t figures = 0, again = 0, unsaid = 0, in_space = 0;
    for (const Known& system : known_systems()) {
        CAPTURE(system.name);
        std::vector<Model> models;
        for (const std::string* text : {&system.cpfg, &system.lpfg, &system.lpy}) {
            CAPTURE(*text);
            models.push_back(
                system_format(std::string("x.") + formats[models.size()])->read(*text, "x"));
        }
        for (std::size_t n = 0; n < system.segments.size(); ++n) {
            CAPTURE(n);
            const Scene first = scene_of(models[0], n).scene;
            CHECK(first.rods.size() == system.segments[n]);
            in_space += std::ranges::any_of(
                            first.rods, [](const Rod& rod) { return std::fabs(rod.to.z) > 0.1; })
                            ? 1
                            : 0;
            for (std::size_t i = 0; i < models.size(); ++i) {
                CAPTURE(formats[i]);
                CHECK(same_scene(scene_of(models[i], n).scene, first));
                ++figures;
                for (const char* target : formats) {
                    CAPTURE(target);
                    const SystemFormat& format = *system_format(std::string("x.") + target);
                    std::string printed;
                    try {
                        printed = format.print(models[i]);
                    } catch (const Error& error) {
                        CHECK(std::string(error.what()).find("cannot say") != std::string::npos);
                        ++unsaid;
                        continue;
                    }
                    CAPTURE(printed);
                    const Scene back = scene_of(format.read(printed, "back"), n).scene;
                    CHECK(same_scene(back, first));
                    ++again;
                }
            }
        }
    }
    MESSAGE(figures << " figures of three programs compared, " << in_space << " in space; " << again
                    << " written and read again, " << unsaid << " not said");
    CHECK(figures >= 100);
    CHECK(in_space >= 15);
    CHECK(again >= 300);
    CHECK(unsaid == 0);
}

TEST_CASE("the row of trees is as long as its ratios say") {
    const Known row = known_systems()[2];
    const Model system = system_format("x.cpfg")->read(row.cpfg, "x");
    for (std::size_t n = 0; n < 4; ++n)
        CHECK(std::fabs(drawn_length(scene_of(system, n).scene) -
                        std::pow(0.3 + 2 * 0.4582 + 0.7, static_cast<double>(n))) < 1e-9);
}
