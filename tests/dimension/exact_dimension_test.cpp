#include "dimension/dimension.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;
using Status = ExactDimension::Status;

namespace {

struct Known {
    const char* name;
    const char* text;
    const char* formula;
    const char* decimal;
    const char* boundary;  // its decimal, or nothing
};

// Dimensions from the literature: Falconer, Fractal Geometry (2003); Davis and Knuth (1970); Duvall
// and Keesling (1999) for the boundary of Levy's curve; Mandelbrot (1982) for Gosper's island.
const Known curves[] = {
    {"Koch", "axiom F; F -> F+F--F+F; angle 60", "log 4 / log 3", "1.261859507143", nullptr},
    {"quadratic Koch", "axiom F; F -> F+F-F-F+F; angle 90", "log 5 / log 3", "1.464973520718",
     nullptr},
    {"Minkowski", "axiom F-F-F-F; F -> F-F+F+FF-F-F+F; angle 90", "log 8 / log 4 = 3/2",
     "1.500000000000", nullptr},
    {"islands and lakes",
     "axiom F+F+F+F; F -> F+f-FF+F+FF+Ff+FF-f+FF-F-FF-Ff-FFF; f -> ffffff; angle 90",
     "log 18 / log 6", "1.613147192765", nullptr},
    {"pieces that coincide", "axiom F-F-F-F; F -> FF-F-F-F-F-F+F; angle 90", "log 6 / log sqrt 10",
     "1.556302500767", nullptr},
    {"rings", "axiom F+F+F+F; F -> FF+F+F+F+F+F-F; angle 90", "log 6 / log sqrt 10",
     "1.556302500767", nullptr},
    {"turns that come back in two generations", "axiom F-F-F-F; F -> FF-F--F-F; angle 90",
     "log 5 / log 3", "1.464973520718", nullptr},
    {"hexagonal", "axiom F+F+F; F -> F+F-F+F; angle 60", "log 16^(1/3) / log 4^(1/3) = 2",
     "2.000000000000", nullptr},
    {"pentadendrite", "axiom F; F -> F+F-F--F+F+F; angle 72", "log 6 / log sqrt(6+sqrt(5))",
     "1.699539851193", nullptr},
    {"pentaplexity", "axiom F++F++F++F++F; F -> F++F++F|F-F++F; angle 36",
     "log 6 / log ((3+sqrt(5))/2)", "1.861715959501", nullptr},
    {"Heighway", "axiom F; F -> -F++G-; G -> +F--G+; angle 45", "log 2 / log sqrt 2 = 2",
     "2.000000000000", "1.523627086202"},
    {"dragon by nodes", "axiom FX; X -> X+YF+; Y -> -FX-Y; angle 90", "log 2 / log sqrt 2 = 2",
     "2.000000000000", "1.523627086202"},
    {"terdragon", "axiom F; F -> F+F-F; angle 120", "log 3 / log sqrt 3 = 2", "2.000000000000",
     "1.261859507143"},
    {"Levy", "axiom F; F -> +F--F+; angle 45", "log 2 / log sqrt 2 = 2", "2.000000000000",
     "1.934007182988"},
    {"Gosper",
     "axiom F_a; F_a -> F_a-F_b--F_b+F_a++F_aF_a+F_b-; F_b -> +F_a-F_bF_b--F_b-F_a++F_a+F_b; angle "
     "60",
     "log 7 / log sqrt 7 = 2", "2.000000000000", "1.129150068107"},
    {"Hilbert", "axiom X; X -> -YF+XFX+FY-; Y -> +XF-YFY-FX+; angle 90", "log 4 / log 2 = 2",
     "2.000000000000", "1.000000000000"},
    {"Peano", "axiom X; X -> XFYFX+F+YFXFY-F-XFYFX; Y -> YFXFY-F-XFYFX+F+YFXFY; angle 90",
     "log 9 / log 3 = 2", "2.000000000000", "1.000000000000"},
    {"arrowhead", "axiom F_a; F_a -> F_b+F_a+F_b; F_b -> F_a-F_b-F_a; angle 60", "log 3 / log 2",
     "1.584962500721", nullptr},
    {"gasket", "axiom F-G-G; F -> F-G+F+G-F; G -> GG; angle 120", "log 3 / log 2", "1.584962500721",
     nullptr},
    {"Cantor", "axiom F; F -> FfF; f -> fff", "log 2 / log 3", "0.630929753571", nullptr},
    {"Vicsek", "axiom F; F -> F[+F][-F]FF; angle 90", "log 5 / log 3", "1.464973520718", nullptr},
    {"plant a", "axiom F; F -> F[+F]F[-F]F; angle 180/7", "log 5 / log 3", "1.464973520718",
     nullptr},
    {"line", "axiom F; F -> FF", "log 2 / log 2 = 1", "1.000000000000", nullptr},
    {"Penrose tiling",
     "axiom [X]++[X]++[X]++[X]++[X]; W -> YF++ZF----XF[-YF----WF]++; X -> +YF--ZF[---WF--XF]+; "
     "Y -> -WF++XF[+++YF++ZF]-; Z -> --YF++++WF[+ZF++++XF]--XF; F -> ε; angle 36",
     "log ((3+sqrt(5))/2) / log ((1+sqrt(5))/2) = 2", "2.000000000000", nullptr},
};

}  // namespace

TEST_CASE("curves of the literature have their dimensions") {
    for (const Known& known : curves) {
        CAPTURE(known.name);
        const ExactDimension found = exact_dimension(read_lsystem(known.text, known.name));
        CAPTURE(found.conditions.back());
        REQUIRE(found.status == Status::exact);
        if (known.formula) CHECK(found.value->text() == known.formula);
        CHECK(found.value->decimal(12) == known.decimal);
        if (known.boundary) {
            REQUIRE(found.boundary);
            CHECK(found.boundary->decimal(12) == known.boundary);
        }
    }
}

TEST_CASE("where parts coincide, the value with multiplicity is said beside the true one") {
    const ExactDimension found =
        exact_dimension(read_lsystem("axiom F; F -> FF-F-F-F-F-F+F; angle 90", ""));
    CHECK(found.similarity->text() == "log 8 / log sqrt 10");
    CHECK(found.similarity->decimal(6) == "1.806180");
    CHECK(found.conditions.back() ==
          "parts coincide; different ones, told apart by 1 kind of surroundings, multiply by 6");
}

TEST_CASE("a limit is regular where its parts are of one component and none coincide") {
    const auto is_regular = [](const char* text) {
        const ExactDimension found = exact_dimension(read_lsystem(text, ""));
        CHECK(found.status == Status::exact);
        return found.is_regular;
    };
    CHECK(is_regular("axiom F; F -> F+F--F+F; angle 60"));
    CHECK(
        is_regular("axiom A; A -> A-B--B+A++AA+B-; B -> +A-BB--B-A++A+B; interpret A -> F; "
                   "interpret B -> F; angle 60"));
    CHECK(is_regular("axiom F++F; F -> FfF; f -> fff; angle 90"));  // Cantor's set, twice
    // Parts of the first coincide; twigs and stems of a plant, and a line beside Koch's curve, have dimensions of their own.
    CHECK_FALSE(is_regular("axiom F-F-F-F; F -> FF-F-F-F-F-F+F; angle 90"));
    CHECK_FALSE(is_regular("axiom X; X -> F[+X][-X]FX; F -> FF; angle 90; interpret X -> F"));
    CHECK_FALSE(is_regular("axiom F+G; F -> F+F--F+F; G -> GGG; angle 60"));
}

TEST_CASE("a plant whose twigs meet in ever new ways has an upper bound only") {
    const ExactDimension found =
        exact_dimension(read_lsystem("axiom X; X -> F[+X]F[-X]+X; F -> FF; angle 20", ""));
    CHECK(found.status == Status::upper_bound);
    CHECK(found.value->text() == "log 3 / log 2");
    CHECK_FALSE(found.boundary);
}

TEST_CASE("a bound comes without the search, and roots are written with small numbers") {
    const auto bound = [](const char* text) { return dimension_bound(read_lsystem(text, "")); };
    const ExactDimension found = bound("axiom F; F -> FF-F-F-F-F-F+F; angle 90");
    CHECK(found.status == Status::upper_bound);
    CHECK(found.value->text() == "log 8 / log sqrt 10");
    CHECK(found.limit);
    CHECK(found.conditions.back() == "whether parts coincide has not been looked at");
    CHECK(bound("axiom F; F -> F[+F]").status == Status::none);
    const ExactDimension line = exact_dimension(read_lsystem(
        "axiom F; F -> GGGGGGG; G -> HH; H -> FFFFFFFFFFFFFF; interpret H -> F; angle 90", ""));
    CHECK(line.value->text() == "log 196^(1/3) / log 196^(1/3) = 1");
}

TEST_CASE("systems without a formula say why") {
    const auto reason = [](const char* text) {
        const ExactDimension found = exact_dimension(read_lsystem(text, "a.lsys"));
        CHECK(found.status == Status::none);
        CHECK_FALSE(found.value);
        return found.conditions.back();
    };
    CHECK(reason("axiom F; F -> F; angle 90") ==
          "the way from the beginning of the curve to its end does not grow exponentially");
    CHECK(reason("axiom F; F -> F+F+F+F; angle 90") ==
          "the turtle always comes back to where it began");
    CHECK(reason("axiom X; X -> XX") == "the turtle always comes back to where it began");
    CHECK(reason("axiom f; f -> fff") == "nothing is drawn in late generations");
    CHECK(reason("axiom F; F -> F*F; scale 1/2") == "the symbol * changes the turtle's step");
    CHECK(reason("axiom F; F -> F[+F]F; angle 60; start 0 0 sqrt(2)") ==
          "the start's heading, together with the angle, is no rational part of a turn with a "
          "denominator up to 360");
    CHECK(reason("axiom X; X -> FX; F -> F+G; G -> F").find("grow") != std::string::npos);
    const char* fences = "a polygon goes on from letter to letter";
    CHECK(reason("axiom {F--F--F}; F -> F+F--F+F; angle 60") == fences);
    CHECK(reason("axiom F; F -> FFA; A -> AAA; interpret A -> }f{") == fences);
    CHECK(reason("axiom F; F -> FFA; A -> AAA; interpret A -> {f") == fences);
    CHECK(reason("axiom A(1); A(x) -> F(x){A(x/3)F(x/3)}; angle 60") == fences);
}

TEST_CASE("a letter that only fills polygons is seen in the limit") {
    const auto dimension = [](const std::string& system) {
        const ExactDimension found = exact_dimension(read_lsystem(system, "a.lsys"));
        REQUIRE(found.status == Status::exact);
        return found.value->text();
    };
    const std::string by_a_line = "axiom F[S]; F -> FFF; S -> S+S--S+S; angle 60; ";
    CHECK(dimension(by_a_line + "interpret S -> {.f++f++f}++f") == "log 4 / log 3");
    CHECK(dimension(by_a_line + "interpret S -> [{+f}]f") == "log 3 / log 3 = 1");
    CHECK(dimension("axiom S; S -> S+S--S+S; angle 60; interpret S -> [{f+f}]f") ==
          "log 4 / log 3");
}

TEST_CASE("plants with angles of no lattice have the bound of their ratios, and no more") {
    const ExactDimension found =
        exact_dimension(read_lsystem("axiom F; F -> F[+F]F; angle sqrt(2)", ""));
    CHECK(found.status == ExactDimension::Status::upper_bound);
    CHECK(found.value->decimal(6) == "1.584963");
    CHECK(found.conditions.back() ==
          "whether parts overlap is not known: more than 3000 ways in which two parts may meet");
}

TEST_CASE("past the deadline there is no answer") {
    const Model system = read_lsystem("axiom F; F -> FF-F+F-F-FF; angle 90", "");
    Budget over;
    over.deadline = std::chrono::steady_clock::now();
    CHECK_THROWS_AS(exact_dimension(system, over), BoundReached);
}

TEST_CASE("work on the exact dimension stops when it is asked to") {
    std::atomic<bool> stop = true;
    Budget budget;
    budget.stop = &stop;
    CHECK_THROWS_AS(
        exact_dimension(read_lsystem("axiom F; F -> FF-F+F-F-FF; angle 90", ""), budget),
        Interrupted);
}

TEST_CASE("plant f at right angles: parts in 8,301 kinds of surroundings") {
    const ExactDimension found =
        exact_dimension(read_lsystem("axiom X; X -> F-[[X]+X]+F[+FX]-X; F -> FF; angle 90", ""));
    REQUIRE(found.status == ExactDimension::Status::exact);
    CHECK(found.value->decimal(20) == "1.90932482738044322492");
    CHECK(found.value->log_ratio()->rate().degree() == 66);
}

TEST_CASE("late generations that differ from each other have no common dimension") {
    const auto said = [](const std::string& system) {
        const ExactDimension found = exact_dimension(read_lsystem(system, "a.lsys"));
        return found.value ? found.value->text() : found.conditions.back();
    };
    // Turns that change with the parity: even generations branch, odd ones lie on a line.
    const std::string turns =
        "L -> KKK; A -> a; a -> A; B -> b; b -> B; C -> c; c -> C; D -> d; d -> D; interpret a -> "
        "+; interpret b -> -; interpret c -> -; interpret d -> +; interpret A -> ++; interpret B "
        "-> ++; interpret K -> F; interpret L -> F; angle 90";
    CHECK(said("axiom K; K -> LALBLCLDL; " + turns) ==
          "late generations are made of other parts than those before and behind");
    CHECK(said("axiom K; K -(1/2)-> LALBLCLDL; K -(1/2)-> LDLCLBLAL; " + turns) ==
          "late generations are made of other parts than those before and behind");
    CHECK(said("axiom KL; K -> LALBLCLDL; " + turns) == "log sqrt(15) / log 3");
    // What is drawn changes with it: Koch's curve, then Cantor's set beside it.
    const std::string unseen = "what draws in some late generations does not in others";
    CHECK(said("axiom KM; K -> L+L--L+L; L -> K+K--K+K; M -> NgN; N -> MhM; g -> hhh; h -> ggg; "
               "interpret K -> F; interpret L -> f; interpret N -> F; interpret M -> f; interpret "
               "g -> f; interpret h -> f; angle 60") == unseen);
    CHECK(said("axiom K; K -> L+L--L+L; L -> K+K--K+K; interpret K -> F; interpret L -> f; angle "
               "60") == unseen);
    CHECK(said("axiom F(1)A(1); A(x) -> G(x); G(x) -> A(x); F(x) -> F(x/3)f(x/3)F(x/3); f(x) -> "
               "f(x/3)f(x/3)f(x/3)") == unseen);
    CHECK(said("axiom F(1)A(1); A(x) -> [C]G(x); G(x) -> [C]A(x); C -> C; F(x) -> "
               "F(x/3)f(x/3)F(x/3); f(x) -> f(x)") == unseen);
    // Lengths of several kinds that come in turn do not matter to the dimension.
    CHECK(said("axiom K; K -> L+L--L+L; L -> K+K--K+K; interpret K -> F; interpret L -> FF; angle "
               "60") == "log 4 / log 3");
}

TEST_CASE("nothing is said where what is drawn grows more slowly than what only moves") {
    const auto said = [](const std::string& system) {
        const ExactDimension found = exact_dimension(read_lsystem(system, "a.lsys"));
        return found.value ? found.value->text() : found.conditions.back();
    };
    const std::string slower = "what is drawn grows more slowly than what only moves";
    CHECK(said("axiom F(1)f(1); F(x) -> F(x)F(x); f(x) -> f(3*x)") == slower);
    CHECK(said("axiom F(1)f(1); F(x) -> F(x)+(60)F(x)-(120)F(x)+(60)F(x); f(x) -> f(5*x)") ==
          slower);
    CHECK(said("axiom F(1); F(x) -> F(x/2)[f(x)]F(x/2)[f(3*x)]; f(x) -> f(3*x)") == slower);
    CHECK(said("axiom Ff; F -> FF; f -> fff; angle 25.7") == slower);
    CHECK(said("axiom Ff; F -> FF; f -> fff; angle 90") == slower);
    CHECK(said("axiom Ff; f -> ff; angle 90") == slower);
    CHECK(said("axiom F(1)f(1); F(x) -> F(x); f(x) -> f(2*x)") == slower);
    // Where the moves part what is drawn, it has its dimension.
    CHECK(said("axiom F; F -> FfF; f -> fff; angle 90") == "log 2 / log 3");
    CHECK(said("axiom F(1); F(x) -> F(x)f(x)F(x); f(x) -> f(3*x)").find("= m^s") !=
          std::string::npos);
    CHECK_THROWS_AS(
        dimension_bounds(read_lsystem("axiom Ff; F -> FF; f -> fff; angle 90", ""), {}, {}), Error);
}

TEST_CASE(
    "axioms of several lengths have the dimension of their parts, and no boundary of one length") {
    const std::string rules =
        "F(x) -> -(45)F(x*r)+(90)G(x*r)-(45); G(x) -> +(45)F(x*r)-(90)G(x*r)+(45); f(x) -> "
        "+(45)f(x*r)-(90)f(x*r)+(45)";
    const auto dimension = [&](const std::string& axiom) {
        return exact_dimension(
            read_lsystem("let r = 1/sqrt(2); axiom " + axiom + "; " + rules, ""));
    };
    CHECK(dimension("[F(1)]F(1)").boundary);
    const ExactDimension several = dimension("[F(10)]F(1)");
    CHECK(several.value->rational() == Rational(2));
    CHECK_FALSE(several.boundary);
    CHECK_FALSE(several.limit);
}

TEST_CASE("curves that become themselves after ten generations have their dimension") {
    std::string text = "axiom A; ", draws;
    const std::string letters = "ABCDEGHIJK";
    for (std::size_t k = 0; k < letters.size(); ++k) {
        const std::string next(1, letters[(k + 1) % letters.size()]);
        text += letters.substr(k, 1) + " -> " + (k + 1 < letters.size() ? next : "A+A--A+A") + "; ";
        draws += "; interpret " + letters.substr(k, 1) + " -> F";
    }
    const ExactDimension found = exact_dimension(read_lsystem(text + "angle 60" + draws, ""));
    CHECK(found.value->decimal(9) == "1.261859507");
}

TEST_CASE("the rate at which parts meet is not known where those of another component coincide") {
    for (const char* text :
         {"axiom FfffffG; F -> F+F--F+F; G -> [G][G]f[G]f[G]f; f -> fff; angle 60",
          "axiom GfffffF; F -> F+F--F+F; G -> [G][G]f[G]f[G]f; f -> fff; angle 60",
          "axiom GfffffF; G -> G+G--G+G; F -> [F][F]f[F]f[F]f; f -> fff; angle 60"}) {
        CAPTURE(text);
        const ExactDimension found =
            exact_dimension(read_lsystem(std::string(text) + "; interpret G -> F", ""));
        CHECK(found.value->text() == "log 4 / log 3");
        CHECK_FALSE(found.meeting);
    }
}
