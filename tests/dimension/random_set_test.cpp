// The dimension of random sets: stochastic 0L systems.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

#include "dimension/dimension.hpp"
#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;

namespace {

ExactDimension of(const std::string& system) {
    return exact_dimension(read_lsystem(system, "test"));
}
bool says(const ExactDimension& found, const std::string& part) {
    return std::ranges::any_of(found.conditions, [&](const std::string& condition) {
        return condition.find(part) != std::string::npos;
    });
}

// The second route: a turtle on the square lattice that walks words of F, f, +, - and brackets.

struct Spot {
    long x = 0, y = 0;
    int heading = 0;
    auto operator<=>(const Spot&) const = default;
};

/// Where each F of the word begins, and where the word ends.
std::pair<std::vector<Spot>, Spot> walked(const std::string& word) {
    static constexpr long across[] = {1, 0, -1, 0}, up[] = {0, 1, 0, -1};
    std::vector<Spot> drawn, saved;
    Spot here;
    for (const char c : word) {
        if (c == '+') here.heading = (here.heading + 1) % 4;
        if (c == '-') here.heading = (here.heading + 3) % 4;
        if (c == '[') saved.push_back(here);
        if (c == ']') {
            here = saved.back();
            saved.pop_back();
        }
        if (c == 'F') drawn.push_back(here);
        if (c == 'F' || c == 'f') here.x += across[here.heading], here.y += up[here.heading];
    }
    return {drawn, here};
}

/// A word of letters whose brackets match.
std::string any_word() {
    const auto letters = *rc::gen::container<std::string>(
        *rc::gen::inRange<std::size_t>(3, 9), rc::gen::elementOf(std::string("FFFFf++--[]")));
    std::string word;
    int depth = 0;
    for (const char c : letters) {
        if (c == ']' && depth == 0) continue;
        depth += c == '[' ? 1 : c == ']' ? -1 : 0;
        word += c;
    }
    return word + std::string(static_cast<std::size_t>(depth), ']');
}

}  // namespace

TEST_CASE("random Koch curves have the dimension of the expected number of parts") {
    // Up or down: 4 parts whatever comes (Falconer, Random fractals, 1986).
    const ExactDimension either = of("axiom F; F -(1/2)-> F+F--F+F; F -(1/2)-> F-F++F-F; angle 60");
    REQUIRE(either.status == ExactDimension::Status::exact);
    CHECK(either.almost_surely);
    CHECK(either.value->text() == "log 4 / log 3");
    CHECK(!either.value->log_ratio());  // nothing takes it for that of one curve
    // A tooth or a line: 7/2 parts on average.
    const ExactDimension flat = of("axiom F; F -(1/2)-> F+F--F+F; F -(1/2)-> FFF; angle 60");
    REQUIRE(flat.status == ExactDimension::Status::exact);
    CHECK(flat.value->text() == "log (7/2) / log 3");
    CHECK(flat.value->decimal(9) == "1.140313996");
    CHECK(!flat.value->rational());
    CHECK(says(flat, "on average parts multiply by 7/2"));
    // Alternatives that are the same count together, and a certain rule is no chance.
    CHECK(of("axiom F; F -(1/4)-> F+F--F+F; F -(1/4)-> F+F--F+F; F -(1/2)-> FFF; angle 60")
              .value->text() == "log (7/2) / log 3");
    CHECK(!of("axiom F; F -(1)-> F+F--F+F; angle 60").almost_surely);
}

TEST_CASE("random sets with branches, and with letters of several kinds") {
    // A square without one of its nine parts, which one is a matter of chance.
    std::string carpet = "axiom S; angle 90; interpret S -> F";
    for (int missing = 0; missing < 9; ++missing) {
        std::string word;
        for (int row = 0; row < 3; ++row) {
            word += "[";
            for (int i = 0; i < row; ++i) word += "+f-";
            for (int column = 0; column < 3; ++column)
                word += 3 * row + column == missing ? "f" : "[S]f";
            word += "]";
        }
        carpet += "; S -(1/9)-> " + word + "fff";
    }
    carpet += "; f -> fff";
    const ExactDimension found = of(carpet);
    REQUIRE(found.status == ExactDimension::Status::exact);
    CHECK(found.value->text() == "log 8 / log 3");
    // Expected numbers of parts whose rate is of degree 2: a -> 2a + b or 2a, b -> a and nothing else.
    const ExactDimension two =
        of("axiom a; a -(1/2)-> a+b--a+a; a -(1/2)-> aaa; b -> a+a--a+a; angle 60; "
           "interpret a -> F; interpret b -> F");
    REQUIRE(two.status == ExactDimension::Status::exact);
    CHECK(says(two, "on average parts multiply by (3+sqrt(17))/2"));
    CHECK(two.value->text() == "log ((3+sqrt(17))/2) / log 3");
}

TEST_CASE("what is not known of a random set is said") {
    using enum ExactDimension::Status;
    const ExactDimension ends = of("axiom F; F -(1/2)-> F[+F]F[-F]F; F -(1/2)-> F[+F]F; angle 30");
    CHECK(ends.status == none);
    CHECK(
        says(ends, "the alternatives of F do not all end at the same place with the same heading"));
    // The second part of one alternative may lie upon the third one.
    const ExactDimension twice = of("axiom F; F -(1/2)-> F[F]F; F -(1/2)-> FF; angle 90");
    REQUIRE(twice.status == upper_bound);
    CHECK(says(twice, "parts may coincide"));
    CHECK(twice.value->text() == "log (5/2) / log 2");
    // Percolation may come to an end.
    const ExactDimension may_die =
        of("axiom [S]f; f -> ff; angle 90; interpret S -> F; "
           "S -(3/4)-> [[S]f[S]-f[S]]ff; S -(1/4)-> ff");
    CHECK(may_die.status == none);
    CHECK(says(may_die, "by some choices nothing that is drawn is as large as the whole"));
    // One of two curves, each with its own dimension.
    const ExactDimension either =
        of("axiom S; S -(1/2)-> FFF; S -(1/2)-> GGG; F -> F+F--F+F; G -(1/2)-> G+G--G+G; "
           "G -(1/2)-> GGG; angle 60; interpret G -> F; interpret S -> F");
    REQUIRE(either.status == upper_bound);
    CHECK(says(either, "by some choices there are no parts that multiply as fast"));
    CHECK(either.value->text() == "log 4 / log 3");
    const ExactDimension still = of("axiom F; F -(1/2)-> fFf; F -(1/2)-> Fff; f -> fff; angle 90");
    CHECK(still.status == none);
    CHECK(says(still, "no parts that are drawn multiply on average"));
    const ExactDimension many = exact_dimension(
        read_lsystem("axiom F; F -(1/2)-> F+F--F+F; F -(1/2)-> FFF; angle 60", ""), Budget(), 1);
    REQUIRE(many.status == upper_bound);
    CHECK(says(many, "more than 1 ways in which two parts may meet"));
}

TEST_CASE("what is little in the limit alone may grow by chance") {
    using enum ExactDimension::Status;
    // g goes 5.5 times as far in each step on average, though the curve without it becomes 3 times as large.
    for (const char* rules :
         {"g -(1/2)-> gggggggggg; g -(1/2)-> g", "g -(1/2)-> g; g -(1/2)-> gggggggggg"}) {
        const ExactDimension found =
            of(std::string("axiom F; F -> F+F--F+Fg; angle 60; interpret g -> f; ") + rules);
        CHECK(found.status == none);
        CHECK(says(found, "the alternatives of g do not all end at the same place"));
    }
    // Turns by chance in the first generation alone: those of F add up in all later ones.
    const ExactDimension turns =
        of("axiom F; F -> F+F-F-FF+F+F-Fa; a -(1/2)-> b; a -(1/2)-> c; b -> d; c -> d; angle 90; "
           "interpret b -> +; interpret c -> -");
    CHECK(turns.status == none);
    CHECK(says(turns,
               "the alternatives of a do not all end at the same place with the same heading"));
    // More and more random Cantor sets in one place: their union has a larger dimension of boxes than each.
    const ExactDimension heap =
        of("axiom P; angle 90; P -> PPPPP[D]; D -(1/3)-> DDf; D -(1/3)-> DfD; D -(1/3)-> fDD; "
           "f -> fff; interpret D -> F");
    REQUIRE(heap.status == upper_bound);
    CHECK(heap.value->text() == "log 5 / log 3");
    CHECK(says(heap, "the parts that multiply the fastest lie in one place"));
    // As many as the sets themselves have parts change nothing.
    const ExactDimension few =
        of("axiom P; angle 90; P -> P[D]; D -(1/3)-> DDf; D -(1/3)-> DfD; D -(1/3)-> fDD; "
           "f -> fff; interpret D -> F");
    REQUIRE(few.status == exact);
    CHECK(few.value->text() == "log 2 / log 3");
}

TEST_CASE("what is drawn may grow more slowly than what only moves") {
    using enum ExactDimension::Status;
    CHECK(of("axiom F[g]; F -> F+F--F+F; g -> gggggggggg; angle 60; interpret g -> f").status ==
          none);
    CHECK(of("axiom F[g]; F -(1/2)-> F+F--F+F; F -(1/2)-> F-F++F-F; g -> gggggggggg; angle 60; "
             "interpret g -> f")
              .status == none);
    CHECK(of("axiom S; S -(1/2)-> F; S -(1/2)-> F[g]; F -> F+F--F+F; g -> gggggggggg; angle 60; "
             "interpret g -> F; interpret S -> F")
              .status == none);
    CHECK(says(of("axiom F; stamp F square; F -> F+F--F+F; angle 60"),
               "symbols leave filled shapes"));
}

TEST_CASE("random sets against walks of random words") {
    std::size_t exact = 0, may_coincide = 0, seen_to = 0, none = 0, walks = 0;
    CHECK(rc::check("random sets", [&] {
        // Alternatives that end where the first one does.
        const std::string first = any_word();
        const Spot end = walked(first).second;
        std::vector<std::string> words{first};
        for (int tries = 0; tries < 400 && words.size() < 3; ++tries) {
            const std::string word = any_word();
            if (walked(word).second == end && word != first) words.push_back(word);
        }
        RC_PRE(words.size() > 1 && end.heading == 0 && end.x * end.x + end.y * end.y > 1);
        std::string system = "axiom F; angle 90";
        double average = 0;
        for (const std::string& word : words) {
            system += "; F -(1/" + std::to_string(words.size()) + ")-> " + word;
            average += static_cast<double>(std::ranges::count(word, 'F')) /
                       static_cast<double>(words.size());
        }
        // What does not draw goes as far as what does, in a straight line as the turtle sees it.
        std::string silent = first;
        std::ranges::replace(silent, 'F', 'f');
        system += "; f -> " + silent;
        const ExactDimension found = of(system);
        RC_LOG() << system << '\n';
        if (found.status == ExactDimension::Status::none) {
            // Where each F begins at the place of the one before, all are drawn there.
            const bool stays = std::ranges::all_of(words, [](const std::string& word) {
                return std::ranges::all_of(walked(word).first, [](const Spot& spot) {
                    return spot.x == 0 && spot.y == 0;
                });
            });
            RC_ASSERT(average <= 1 + 1e-9 || says(found, "no parts") ||
                      says(found, "by some choices nothing that is drawn") ||
                      (stays && says(found, "what is drawn grows more slowly")));
            ++none;
            return;
        }
        const double factor = std::sqrt(static_cast<double>(end.x * end.x + end.y * end.y));
        RC_ASSERT(std::fabs(found.value->enclosure(64).midpoint() -
                            std::log(average) / std::log(factor)) < 1e-9);
        bool coincide = false;
        for (int times = 0; times < 30; ++times) {
            std::string word = "F";
            for (int level = 0; level < 4 && word.size() < 3000; ++level) {
                std::string next;
                for (const char c : word)
                    next += c == 'F'   ? words[*rc::gen::inRange<std::size_t>(0, words.size())]
                            : c == 'f' ? silent
                                       : std::string(1, c);
                word = std::move(next);
                const auto drawn = walked(word).first;
                coincide =
                    coincide || std::set<Spot>(drawn.begin(), drawn.end()).size() < drawn.size();
            }
            ++walks;
        }
        if (found.status == ExactDimension::Status::exact) {
            RC_ASSERT(!coincide);
            ++exact;
        } else if (says(found, "parts may coincide")) {
            ++may_coincide;
            seen_to += coincide ? 1 : 0;
        }
    }));
    MESSAGE(exact << " exact, " << may_coincide << " that may coincide, " << seen_to
                  << " of them seen to, " << none << " without parts; " << walks
                  << " random words");
    CHECK(exact > 10);
    CHECK(seen_to > 5);
}
