#include "exchange/detail/formats.hpp"
#include "turtle/turtle.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exchange/any_brno.hpp"
#include "exchange/compared.hpp"
#include "exchange/inputs.hpp"
#include "exchange/slow_maple.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;
using namespace algae::exchange_tests;

namespace {

std::string lsys(const std::string& text) { return print_lsystem(read_maple(text, "x.maple")); }
std::string maple(const std::string& text) { return print_maple(read_lsystem(text, "x.lsys")); }
std::string unsaid(const std::string& text) {
    return refusal([&] { maple(text); });
}

std::string names(const slow_maple::Modules& word) {
    std::string out;
    for (const slow_maple::Module& module : word)
        out += std::string(1, module.letter == '?' ? '\\' : module.letter) + ' ';
    return out;
}

bool same_lines(const Scene& scene, const std::vector<slow_maple::Line>& lines) {
    if (scene.rods.size() != lines.size()) return false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto close = [](const Vector& a, const Vector& b) {
            return std::fabs(a.x - b.x) + std::fabs(a.y - b.y) + std::fabs(a.z - b.z) < 1e-6;
        };
        if (!close(scene.rods[i].from, lines[i].from) || !close(scene.rods[i].to, lines[i].to))
            return false;
    }
    return true;
}

/// Whether the lines of two scenes are the same; their widths need not be.
bool same_rods(const Scene& a, const Scene& b) {
    std::vector<slow_maple::Line> lines;
    for (const auto& rod : b.rods) lines.push_back({rod.from, rod.to});
    return same_lines(a, lines);
}

}  // namespace

TEST_CASE("worksheets that call what the gallery has give its words and figures") {
    const std::string up = "> ANGULO:=Pi/2:\n";
    const std::pair<const char*, std::string> worksheets[] = {
        {"koch", "> Lsystem(\"F\",[\"F\",\"F+F--F+F\"],60,5);"},
        {"koch-snowflake", "Lsystem(\"F--F--F\", [\"F\", \"F+F--F+F\"], 60, 4);"},
        {"islands-and-lakes",
         "Lsystem(\"F+F+F+F\", "
         "[\"F\",\"F+f-FF+F+FF+Ff+FF-f+FF-F-FF-Ff-FFF\",\"f\",\"ffffff\"],90,2);"},
        {"plant-a", up + "> Lsystem(\"F\",[\"F\",\"F[+F]F[-F]F\"],25.7,5);"},
        {"plant-b", up + "> Lsystem(\"F\",[\"F\",\"F[+F]F[-F][F]\"],20,5);"},
        {"plant-c", up + "> Lsystem(\"F\",[\"F\",\"FF-[-F+F+F]+[+F-F-F]\"],22.5,4);"},
        {"plant-d", up + "> Lsystem(\"X\",[\"X\",\"F[+X]F[-X]+X\",\"F\",\"FF\"],20,7);"},
        {"plant-e", up + "> Lsystem(\"X\",[\"X\",\"F[+X][-X]FX\",\"F\",\"FF\"],25.7,7);"},
        {"plant-f", example("plant.maple")},
        {"plant-stochastic",
         "> REGRAS:=[\"F\",\"F(+F)F(-F)F\",\"F\",\"F(+F)F\",\"F\",\"F(-F)F\"]:\n"
         "> PROB:=[33,33,34]:\n> Lsystem(\"F\",REGRAS,PROB,22.5,6);"},
        {"hilbert-3d",
         "> Lsystem(\"A\",[\"A\",\"B-F+CFC+F-D&F^D-F+&&CFC+F+B//\",\n"
         ">   \"B\",\"A&F^CFB^F^D^^-F-D^|F^B|FC^F^A//\",\n"
         ">   \"C\",\"|D^|F^B-F+C^F^A&&FA&F^C+F+B^F^D//\",\n"
         ">   \"D\",\"|CFB-F+B|FA&F^A&&FB-F+B|FC//\"],90,3);"},
        {"honda-a", example("honda.maple")},
        {"aono-kunii-a",
         "> r1:=0.9: r2:=0.8: a1:=35: a2:=35: wr:=0.707:\n"
         "> A:=L->[[\"!\",[L[2]]],[\"F\",[L[1]]],[\"[\"],[\"&\",[a1]],[\"B\",[L[1]*r1,L[2]*wr]],\n"
         ">   [\"]\"],[\"/\",[180]],[\"[\"],[\"&\",[a2]],[\"B\",[L[1]*r2,L[2]*wr]],[\"]\"]]:\n"
         "> "
         "B:=L->[[\"!\",[L[2]]],[\"F\",[L[1]]],[\"[\"],[\"+\",[a1]],[\"@\"],[\"B\",[L[1]*r1,L[2]*"
         "wr]],\n"
         ">   [\"]\"],[\"[\"],[\"-\",[a2]],[\"@\"],[\"B\",[L[1]*r2,L[2]*wr]],[\"]\"]]:\n"
         "> F:=L->[[\"F\",[L[1]]]]:\n"
         "> AXIOMA:=[[\"^\",[90]],[\"A\",[1,0.04]]]: N:=8:\n> Lsystem(AXIOMA,N);"},
        {"koch-snowflake-parametric",
         "F := x -> [[\"F\",[x[1]/3]],[\"+\",[60]],[\"F\",[x[1]/3]],[\"-\",[120]],[\"F\",[x[1]/3]],"
         "[\"+\",[60]],[\"F\",[x[1]/3]]]:\n"
         "t := [\"-\",[120]]: s := [\"F\",[1]]: Lsystem([s,t,s,t,s],4);"},
        {"right-triangle",
         "X := L -> [[\"F\",L],[\"+\",[90]],[\"F\",L],[\"+\",[135]],[\"F\",[sqrt(2)*L[1]]]]:\n"
         "F := L -> [[\"F\",L]]: Lsystem([[\"X\",[1]]],1);"}};
    for (const auto& [name, text] : worksheets) {
        INFO(name);
        const Model known = of_gallery(name), read = read_maple(text, "x.maple");
        const std::uint64_t last = known.drawing.generations->second;
        REQUIRE(read.drawing.generations);
        CHECK(read.drawing.generations->second == last);
        const bool open = name == std::string("plant-stochastic");
        for (std::uint64_t n = 0; n <= std::min<std::uint64_t>(last, 5); ++n)
            for (std::uint64_t seed = 1; seed <= (open ? 3u : 1u); ++seed)
                CHECK(word_of(read, n, seed) == word_of(known, n, seed));
        const SpaceDerivation own = scene_of(read, last), theirs = scene_of(known, last);
        CHECK(own.scene.rods.size() > 2);
        if (name == std::string("hilbert-3d"))
            CHECK(same_rods(own.scene, theirs.scene));
        else
            CHECK(same_scene(own.scene, theirs.scene));
    }
}

TEST_CASE("what a worksheet says in the notation") {
    CHECK(lsys("restart; with(plots): with(plottools): # F is drawn\n"
               "AXIOMA := \"F\": REGRAS := [\"F\",\"F+F\"]:\nLsystem(AXIOMA, REGRAS, 25.7, 3);") ==
          "axiom F\nF -> F+F\nangle 25.7\ngeneration 3\n");
    CHECK(lsys("Lsystem(\"\",[],180/7,N);") == "axiom ε\nangle 180/7\n");
    CHECK(lsys("a := 3: b := sqrt(a): c := 7: Lsystem(\"F\",[],60*b,0):") ==
          "let a = 3\nlet b = sqrt(a)\naxiom F\nangle 60*b\ngeneration 0\n");
    // What the procedures do not know is left out, and the backslash is a question mark there.
    CHECK(lsys("Lsystem(\"FG{f?|}@'!*é\",[\"G\",\"\"],90,1);") ==
          "axiom FG{f\\|}@'!*é\nG -> ε\ninterpret G -> ε\ninterpret { -> ε\ninterpret } -> ε\n"
          "interpret @ -> ε\ninterpret ' -> ε\nangle 90\ngeneration 1\n");
    CHECK(lsys("Lsystem(\"F_l1\",[\"_\",\"lF_l\"],90,1);") ==
          "axiom F _l1\n_ -> lF _l\nangle 90\ngeneration 1\n");
    // Probabilities are percentages, as the procedure has them, or fractions, as the text has.
    for (const char* shares : {"[25,75]", "[0.25,0.75]", "[1/4,3/4]", "[100/4,75]"})
        CHECK(
            lsys(std::string("Lsystem(\"F|\",[\"F\",\"F(+F)\",\"F\",\"\"],") + shares +
                 ",30,2);") ==
            "axiom F|\nF -(0.25)-> F[+F]\nF -(0.75)-> ε\ninterpret | -> ε\nangle 30\nstart 0 0 90\n"
            "generation 2\n");
    CHECK(lsys("Lsystem(\"F\",[\"F\",\"F[+F]\"],[100],30,2);") ==
          "axiom F\nF -(1)-> F[+F]\nangle 30\nstart 0 0 90\ngeneration 2\n");
    // Identities are no rules; functions that are never called are left out.
    CHECK(lsys("q := 1/3: A := P -> "
               "[[\"F\",[P[1]^2,-P[2]]],[\"A\",[P[1]*q,P[2]]],[\"x\",P],[\"{\"]]:\n"
               "F := L -> [[\"F\",L]]: B := L -> [[\"C\",[L[9]]]]:\n"
               "Lsystem([[\"A\",[1,2]],[\"+\",[30]],[\"'\",[1,2]]],2);") ==
          "let q = 1/3\naxiom A(1,2)+(30)'(1,2)\nA(p1,p2) -> F(p1^2,-p2)A(p1*q,p2)x(p1,p2){\n"
          "interpret '(p1,p2) -> ε\ninterpret { -> ε\ngeneration 2\n");
    CHECK(lsys("p := 2: F := L -> [[\"F\",[p*L[1]]]]: Lsystem([[\"F\",[1]]],1);") ==
          "let p = 2\naxiom F(1)\nF(pp1) -> F(p*pp1)\ngeneration 1\n");
    CHECK(lsys("X := L -> [[\"X\",[]],[\"[\"],[\"]\"]]: Lsystem([[\"X\",[]]],1);") ==
          "axiom X\nX -> X[]\ngeneration 1\n");
}

TEST_CASE("arithmetic is Maple's: radians, ln and Pi") {
    const auto first = [](const std::string& expression) {
        const std::string text = lsys("a := 2: Lsystem([[\"f\",[" + expression + "]]],N);");
        const std::size_t open = text.find("f(");
        return text.substr(open + 2, text.rfind(')') - open - 2);
    };
    CHECK(first("sin(30*Pi/180)") == "sin(30)");
    CHECK(first("arctan(1)*180/Pi") == "atan(1)");
    CHECK(first("cos(arccos(0.5))") == "cos(acos(0.5))");
    CHECK(first("ln(2)+log(3)+evalf(a)") == "log(2)+log(3)+a");
    CHECK(first("2**3-1.e2+1.5e-1") == "2^3-100+0.15");
    CHECK(first("-a^2*(1-2)-(3-4)") == "-a^2*(1-2)-(3-4)");
    CHECK(first("min(1,a,3)+max(1,2)") == "min(1,a,3)+max(1,2)");
    CHECK(first("tan(Pi/4)").starts_with("tan(3.14159265358979323846"));
    CHECK(word_of(read_maple("Lsystem([[\"f\",[tan(Pi/4)]]],0);", ""), 0) == "f ");
}

TEST_CASE("where the turtle starts: as GRAFICO says, in a procedure or beside it") {
    const std::string procedures =
        "> GRAFICO:=proc(s::string,incremento)\n> local PONTOA, ANGULO, i:\n"
        "> PONTOA:=[0,1/2]: ANGULO:=Pi/2: SEGMENTO:=2.0:\n> for i from 1 to length(s) do\n"
        ">   if (s[i]=\"F\") then\n>     PONTOA:=PONTOB: ANGULO:=ANGULO+ANGSTEP:\n>   end if:\n"
        "> end do:\n> end proc:\n"
        "> Lsystem:=proc(axioma::string,regras::list)\n> option remember:\n> end proc:\n";
    CHECK(lsys(procedures + "> Lsystem(\"F\",[],90,1);") ==
          "axiom F\nangle 90\nstep 2\nstart 0 0.5 90\ngeneration 1\n");
    CHECK(lsys("PONTOA := [1,2,0]: ANGULO := -Pi/6: vH := [1,0,0]: Lsystem(\"F\",[],90,1);") ==
          "axiom F\nangle 90\nstart 1 2 -30\ngeneration 1\n");
    CHECK(lsys("ANGULO := 0.0: Lsystem(\"F\",[\"F\",\"\"],[1],90,1);") ==
          "axiom F\nF -(1)-> ε\nangle 90\ngeneration 1\n");
}

TEST_CASE("what the worksheet of a system says") {
    CHECK(
        maple("title K\nsource S\naxiom F\nF -> F+F--F+F\nangle 60\ngeneration 2..5\ncolour red") ==
        "# K\n# S\nLsystem(\"F\", [\"F\", \"F+F--F+F\"], 60, 5);\n");
    CHECK(maple("axiom X\nX -> F[\\X]\nF -> FF\nstart 1 0 90\nstep 2") ==
          "# where the turtle of GRAFICO starts\nPONTOA := [1,0]:\nANGULO := 90*Pi/180:\n"
          "SEGMENTO := 2:\nLsystem(\"X\", [\n  \"X\", \"F[?X]\",\n  \"F\", \"FF\"\n], 90, N);\n");
    CHECK(maple("axiom F\nF -(1/4)-> FF\nF -(3/4)-> F\nangle 30\nstart 0 0 90") ==
          "Lsystem(\"F\", [\n  \"F\", \"FF\",\n  \"F\", \"F\"\n], [25,75], 30, N);\n");
    CHECK(maple("axiom F\nF -(1/3)-> FF\nF -(2/3)-> F\nangle 30") ==
          "# where the turtle of GRAFICO starts\nANGULO := 0*Pi/180:\n"
          "Lsystem(\"F\", [\n  \"F\", \"FF\",\n  \"F\", \"F\"\n], [1/3,2/3], 30, N);\n");
    CHECK(maple("let s = sin(60)\nlet t = 2^-s\naxiom A(t)\n"
                "A(x) -> F(1)+(asin(x)/2)[&(-x)A(x-(-x))]f(2)|") ==
          "s := sin(60*Pi/180):\nt := 2^(-s):\n"
          "A := L -> [[\"F\",[1]], [\"+\",[arcsin(L[1])*180/Pi/2]], [\"[\"], [\"&\",[-L[1]]], "
          "[\"A\",[L[1]-(-L[1])]], [\"]\"], [\"f\",[2]], [\"|\"]]:\n"
          "F := L -> [[\"F\",L]]:\nAXIOMA := [[\"A\",[t]]]:\nLsystem(AXIOMA, N);\n");
}

TEST_CASE("what a worksheet cannot say is named") {
    CHECK(unsaid("axiom F\nX < F -> FF") ==
          "x.lsys:2:1: maple cannot say the rule X < F -> FF: it has a context");
    CHECK(unsaid("axiom F(1)\nF(x) : x < 3 -> F(x+1)") ==
          "x.lsys:2:1: maple cannot say the rule F(x) : x < 3 -> F(x+1): it has a condition");
    CHECK(unsaid("axiom FX\nF -(1)-> FF\nX -(1)-> X") ==
          "x.lsys:3:1: maple cannot say the rule X -(1)-> X: the rules have several predecessors, "
          "and one list of probabilities");
    CHECK(unsaid("axiom F\nF -> FF\nF -> F") ==
          "x.lsys:3:1: maple cannot say the rule F -> F: it is the second for its letter");
    CHECK(unsaid("axiom a(1)\na(x) -> a(x+1)") ==
          "x.lsys:2:1: maple cannot say the rule a(x) -> a(x+1): functions are called for the "
          "capital letters A to Z alone");
    CHECK(
        unsaid("axiom D(1)\nD(x) -> D(x+1)") ==
        "x.lsys:2:1: maple cannot say the rule D(x) -> D(x+1): Maple keeps the name D for itself");
    CHECK(
        unsaid("axiom A(1)\nA(x) -> A(x+1)A") ==
        "x.lsys:2:1: maple cannot say the rule A(x) -> A(x+1)A: a module A with another number of "
        "parameters, 0, would not stay");
    CHECK(
        unsaid("axiom A(1)+\nA(x) -> A(x+1)") ==
        "x.lsys: maple cannot say the module + without a parameter beside modules that have some");
    CHECK(unsaid("axiom A(1)\nA(x) -> A(x < 2)") ==
          "x.lsys: maple cannot say 'x < 2' in arithmetic");
    CHECK(unsaid("axiom A(N)\nlet N = 2") ==
          "x.lsys: maple cannot say the constant N: the name is taken");
    CHECK(unsaid("axiom F_lG") ==
          "x.lsys: maple cannot say the symbol F_l, which has several characters");
    CHECK(unsaid("axiom FG") ==
          "x.lsys: maple cannot say the symbol G, which is nothing to its turtle");
    CHECK(unsaid("axiom F$") ==
          "x.lsys: maple cannot say the symbol $, which is nothing to its turtle");
    CHECK(unsaid("axiom F&\nF -(1)-> F") ==
          "x.lsys: maple cannot say the symbol &, which is nothing to its turtle");
    CHECK(unsaid("axiom F\"") == "x.lsys: maple cannot say the symbol \", which ends a string");
    CHECK(unsaid("axiom F\ninterpret F -> FF") ==
          "x.lsys: maple cannot say the interpretation of F");
    CHECK(unsaid("axiom F\ninterpret F -> ε") ==
          "x.lsys: maple cannot say the interpretation of F");
    for (const auto& [setting, what] : {std::pair("shrink 1/2", "steps that shrink"),
                                        {"spin 45", "a spin"},
                                        {"turn clockwise", "that + turns clockwise"},
                                        {"stamp F square", "stamps"},
                                        {"solid F box", "solids"},
                                        {"tropism 0 0 1", "a tropism"},
                                        {"surface F leaf", "surfaces"},
                                        {"plot F", "plots"},
                                        {"terminals F", "terminals"},
                                        {"table t", "tables"},
                                        {"start sqrt(2) 0 0", "the start sqrt(2), no fraction"}})
        CHECK(unsaid(std::string("axiom F\n") + setting) ==
              std::string("x.lsys: maple cannot say ") + what);
}

TEST_CASE("random worksheets of strings do what the procedures do") {
    CHECK(rc::check([] {
        const std::string letters = "FfXAG+-&^?/|[]@FFX";
        const auto word = [&](int most) {
            return oracle::balanced(*oracle::any_word(letters, most));
        };
        std::string axiom = "F" + word(5);
        std::vector<std::string> rules;
        for (const char* predecessor : {"F", "X", "A"})
            if (below(4) > 0) {
                rules.push_back(predecessor);
                rules.push_back(word(6));
            }
        const int increment = 1 + below(179);
        const auto gap = [] { return one_of({"", "", " ", "\n> ", "\n", "\t", "# F;\n"}); };
        std::string text =
            gap() + one_of({"", "restart;", "with(plots):"}) + "\n> R" + gap() + ":=" + gap() + "[";
        for (const std::string& part : rules)
            text += (text.back() == '[' ? "" : ",") + gap() + "\"" + part + "\"";
        text += gap() + "]" + gap() + ":" + gap() + "Lsystem" + gap() + "(\"" + axiom + "\"" +
                gap() + ",R," + gap() + std::to_string(increment) + ",2" + gap() + ")" +
                one_of({";", ":"}) + gap();
        const Model read = read_maple(text, "x.maple");
        for (unsigned n = 0; n <= 2; ++n) {
            const auto modules = slow_maple::modules_of(slow_maple::rewritten(axiom, rules, n));
            RC_ASSERT(word_of(read, n) == names(modules));
            RC_ASSERT(same_lines(scene_of(read, n).scene, slow_maple::drawn(modules, increment)));
        }
        RC_ASSERT(read_maple(print_maple(read), "x.maple") == read);
    }));
}

TEST_CASE("Honda's tree is what the procedures make of it") {
    using slow_maple::Modules;
    using List = std::vector<double>;
    const double r1 = 0.9, r2 = 0.8, wr = 0.707;
    const auto side = [=](char turn, char next) {
        return [=](const List& l) {
            return Modules{{'!', {l[1]}}, {'F', {l[0]}},
                           {'[', {}},     {turn, {45}},
                           {'@', {}},     {next, {r2 * l[0], wr * l[1]}},
                           {']', {}},     {next, {r1 * l[0], wr * l[1]}}};
        };
    };
    const std::map<char, std::function<Modules(List)>> functions{
        {'A',
         [=](const List& l) {
             return Modules{{'!', {l[1]}},
                            {'F', {l[0]}},
                            {'[', {}},
                            {'&', {45}},
                            {'B', {r2 * l[0], wr * l[1]}},
                            {']', {}},
                            {'/', {137.5}},
                            {'A', {r1 * l[0], wr * l[1]}}};
         }},
        {'B', side('-', 'C')},
        {'C', side('+', 'B')},
        {'F', [](const List& l) {
             return Modules{{'F', l}};
         }}};
    const Model read = read_maple(example("honda.maple"), "honda.maple");
    for (unsigned n = 0; n <= 8; ++n) {
        const Modules word = slow_maple::rewritten({{'^', {90}}, {'A', {1, 0.04}}}, functions, n);
        CHECK(word_of(read, n) == names(word));
        CHECK(same_lines(scene_of(read, n).scene, slow_maple::drawn(word, 0)));
    }
}

TEST_CASE("systems that a worksheet can say keep their words and their figures") {
    CHECK(rc::check([] {
        const oracle::WrittenSystem written = *oracle::any_bracketed("&/");
        const Model system = read_lsystem(
            print_lsystem({oracle::lsystem_of(written), {}, {}, {}}) + "angle " +
                std::to_string(below(361)) + one_of({"", "\nstep 3", "\nstart 1 2 30"}) +
                one_of({"", "\ninterpret G -> ε", "\ninterpret X -> ε"}) +
                one_of({"", "\ngeneration 1..3"}),
            "x.lsys");
        std::string text;
        try {
            text = print_maple(system);
        } catch (const Error& error) {
            RC_DISCARD(error.what());
        }
        const Model back = read_maple(text, "x.maple");
        for (std::uint64_t n = 0; n <= 2; ++n) {
            RC_ASSERT(word_of(back, n) == word_of(system, n));
            RC_ASSERT(same_scene(scene_of(back, n).scene, scene_of(system, n).scene));
        }
        RC_ASSERT(print_maple(back) == text);
    }));
}

TEST_CASE("functions of a worksheet and rules with parameters are the same, letter by letter") {
    CHECK(rc::check([] {
        const std::function<std::string(int)> expression = [&](int depth) -> std::string {
            const auto part = [&] { return "(" + expression(depth - 1) + ")"; };
            if (depth == 0 || below(4) == 0)
                return one_of({"p1", "p2", "c", "k_1", "2", "0.25", "1e-30", "180", "1/3"});
            if (below(3) == 0)
                return one_of({"sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp", "log",
                               "abs", "floor", "ceil"}) +
                       part();
            if (below(8) == 0) return one_of({"min", "max"}) + "(" + part() + "," + part() + ")";
            if (below(5) == 0) return "-" + part();
            return part() + one_of({"+", "-", "*", "/", "^"}) + part();
        };
        const auto module = [&](const std::string& name) {
            return name + "(" + expression(4) + "," + expression(2) + ")";
        };
        // Constants are printed where they are used.
        const Model system = read_lsystem(
            "let c = 2/3\nlet k_1 = c*2\naxiom A(c,k_1)x(1,2)[&(2)A(2,1)]\nA(p1,p2) -> " +
                module("F") + "[" + module("+") + module("A") + "@]" + module("B") +
                "\nB(p1,p2) -> x(p2)|\ngeneration 2",
            "x.lsys");
        const std::string text = print_maple(system);
        const Model back = read_maple(text, "x.maple");
        RC_ASSERT(print_lsystem(back) == print_lsystem(system));
        RC_ASSERT(print_maple(back) == text);
    }));
}
