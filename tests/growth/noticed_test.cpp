#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "growth/growth.hpp"

using namespace algae;

namespace {

using Numbers = std::vector<Rational>;
using Integers = std::vector<Integer>;
using Kind = Realisation::Kind;

const Polynomial variable({0, 1});
const Polynomial golden({-1, -1, 1});      // of (1+sqrt(5))/2
const Polynomial plastic({-1, -1, 0, 1});  // the least Pisot number

/// Each letter to the next one, the last one to those that are given.
GrowthMatrix ring(std::size_t size, const std::vector<std::size_t>& last) {
    GrowthMatrix matrix;
    matrix.rows.resize(size);
    for (std::size_t i = 0; i + 1 < size; ++i) matrix.rows[i].push_back({i + 1, 1});
    for (const std::size_t to : last) matrix.rows.back().push_back({to, 1});
    return matrix;
}

/// A system of letters a1, a2, ...: a word of the first ones, and where each of them goes.
D0L numbered(std::size_t letters, const Word& axiom, std::vector<Word> images) {
    auto alphabet = std::make_shared<Alphabet>();
    for (std::size_t i = 0; i < letters; ++i) alphabet->symbol("a" + std::to_string(i + 1));
    return make_d0l(alphabet, axiom, std::move(images), "numbered");
}

Rational value_at(const Polynomial& polynomial, const Rational& x) {
    Rational sum = 0;
    for (std::size_t k = polynomial.coefficients().size(); k-- > 0;)
        sum = sum * x + Rational(polynomial.coefficients()[k]);
    return sum;
}

Rational half_to(std::uint64_t bits) { return Rational(1, power(Integer(2), bits)); }

Realisation realised(const std::string& text) { return realise(read_specification(text)); }

bool has_lengths(const Realisation& result, const SequenceSpecification& sequence) {
    const auto values = sequence.values(40 + result.shift);
    const auto found = lengths(*result.system, 40);
    for (std::size_t n = 0; n < 40; ++n)
        if (Rational(found[n]) != values[n + result.shift]) return false;
    return true;
}

bool has_lengths_of(const std::string& text) {
    const Realisation result = realised(text);
    return result.kind == Kind::found && has_lengths(result, read_specification(text));
}

std::string class_of(const D0L& system) {
    const ComplexityOrder order = complexity_order(system);
    return to_string(order.at_least) + " to " + to_string(order.at_most);
}

std::vector<std::string> repeated_words(const D0L& system) {
    std::vector<std::string> words;
    for (const auto& repetition : infinite_repetitions(system))
        words.push_back(spell(*system.alphabet, repetition.word));
    return words;
}

}  // namespace

TEST_CASE("matrices of more than 64 letters are as primitive as smaller ones") {
    for (const std::size_t size : {5u, 64u, 65u, 66u, 70u, 128u, 130u}) {
        CAPTURE(size);
        const Primitivity cycle = primitivity(ring(size, {0}));
        CHECK(cycle.irreducible);
        CHECK(!cycle.exponent.has_value());
        CHECK(!primitivity(ring(size, {})).irreducible);
        // Wielandt's bound, which only this matrix reaches.
        CHECK(primitivity(ring(size, {0, 1})).exponent == (size - 1) * (size - 1) + 1);
    }
}

TEST_CASE("many copies of a cycle have a power of its polynomial") {
    GrowthMatrix copies;  // 16 letters each
    for (std::size_t i = 0; i < 64; ++i) copies.rows.push_back({{i / 16 * 16 + (i + 1) % 16, 1}});
    Integers coefficients(17);
    coefficients[0] = -1;
    coefficients[16] = 1;
    CHECK(characteristic_polynomial(copies) == power(Polynomial(coefficients), 4));
}

TEST_CASE("numbers that the first prime modulus divides are no zeros") {
    const Integer first = Integer(prime_below(Residue{1} << 61));
    CHECK(first == power(Integer(2), 61) - 1);  // a prime of Mersenne
    CHECK(annihilator(Integers{1}, ring(1, {0}), Integers{first}) == Polynomial({-1, 1}));
    Integers begin(100), end(100);  // 0 for n < 99, then once another number
    begin.front() = 1;
    end.back() = first;
    CHECK(annihilator(begin, ring(100, {}), end) == power(variable, 100));
}

TEST_CASE("few generations take no more memory than their numbers do") {
    std::vector<Word> images;
    for (Symbol a = 0; a < 100; ++a) images.push_back({a, static_cast<Symbol>((a + 1) % 100)});
    const D0L system = numbered(100, {0}, images);
    Budget small;
    small.memory = 65'536;  // a generation of 100 numbers of 200 bits takes 2500 bytes
    Integer sum = 0;
    for (const Integer& count : parikh_vector(system, 200, small)) sum += count;
    CHECK(sum == power(Integer(2), 200));
    // The lengths of 1000 generations of doublings have 500,500 bits.
    small.memory = 1'000'000;
    CHECK(lengths(d0l("a", {{'a', "aa"}}), 1000, small).back() == power(Integer(2), 999));
}

TEST_CASE("a rate is enclosed as well as it is asked for") {
    const Integer large = power(Integer(2), 200);
    const Polynomial quadratic({-1, -large, 1});  // its root is a little more than 2^200
    const Ball root = Rate(quadratic, Rational(large + 1)).enclosure(20);
    CHECK(root.has_radius_below(-20));
    CHECK(value_at(quadratic, root.lower()) <= Rational(0));
    CHECK(value_at(quadratic, root.upper()) >= Rational(0));
}

TEST_CASE("a largest root is found beside two others that are as good as equal to it") {
    const Integer place = power(Integer(2), 100);  // the three are 2^-233 from it
    const Polynomial three = power(Polynomial({-place, 1}), 3) * power(variable, 7) - Polynomial(1);
    for (const Rational& above : {Rational(1), half_to(225)}) {  // so far beyond 2^100
        const auto [low, high] = largest_root(three, Rational(place) + above, 220);
        CHECK(high - low <= half_to(220));
        CHECK(value_at(three, low) <= Rational(0));  // the only sign change above 0
        CHECK(value_at(three, high) >= Rational(0));
    }
}

TEST_CASE("a closed form says which power of n is meant") {
    const AlgebraicNumber none{0, 1}, one{1, 1};
    CHECK(closed_form_text({{golden, {none, one}}}) == "n*((1+sqrt(5))/2)^n + n*((1-sqrt(5))/2)^n");
    CHECK(closed_form_text({{golden, {none, none, one}}}) ==
          "n^2*((1+sqrt(5))/2)^n + n^2*((1-sqrt(5))/2)^n");
    // Perrin's numbers 3, 0, 2, 3, 2, ... from the second one on: sums of powers of the roots.
    CHECK(ClosedForm(Recurrence{plastic, 0, {0, 2, 3}}).text() ==
          "sum over the roots r of x^3 - x - 1 of r*r^n");
}

TEST_CASE("roots are listed where there is no form by radicals, and not for large degrees") {
    CHECK(root_lines(closed_form(d0l("a", {{'a', "ab"}, {'b', "a"}}))).empty());
    const ClosedForm cubic(Recurrence{plastic, 0, {3, 0, 2}});
    CHECK(root_lines(cubic) ==
          std::vector<std::string>{
              "the roots of x^3 - x - 1 are 1.324717957245, -0.662358978622 +- 0.562279512062i"});
    CHECK(root_lines(cubic, 2).empty());
}

TEST_CASE("shares are equal if they are the same number, not if they are written alike") {
    const Rate two_roots(golden, 2), square_root(Polynomial({-2, 0, 1}), 2);
    const bool same = Frequency(two_roots, variable, 1) == Frequency(two_roots, variable, 1);
    const bool alike = Frequency(two_roots, variable, 1) == Frequency(square_root, variable, 1);
    CHECK(same);
    CHECK(!alike);
    CHECK(Frequency(two_roots, 1, 3).decimal(4) == "0.3333");
    CHECK(AlgebraicNumber{variable} == AlgebraicNumber{variable, 1});
}

TEST_CASE("shares of a long period are not listed") {
    // Cycles of 2, 3 and 5 letters: each letter is there in some of 30 generations.
    const D0L system = d0l("ace", {{'a', "b"},
                                   {'b', "a"},
                                   {'c', "d"},
                                   {'d', "g"},
                                   {'g', "c"},
                                   {'e', "f"},
                                   {'f', "h"},
                                   {'h', "i"},
                                   {'i', "j"},
                                   {'j', "e"}});
    const LetterFrequencies shares = letter_frequencies(system);
    CHECK(shares.period == 30);
    CHECK(shares.limits.empty());
}

TEST_CASE("two images of which one is a power of the other are no code") {
    const Injective simple = made_injective({{0, 1}, Morphism({{0, 1}, {0, 1, 0, 1}})});
    CHECK(simple.system.rules.size() == 1);
    CHECK(simple.system.rules[0] == Word{0, 0, 0});  // 01 becomes 01 0101
    CHECK(simple.back[0] == Word{0, 1});
    CHECK(simple.steps == 1);
}

TEST_CASE("words that grow in front of the axiom make no infinite word") {
    CHECK(!generates_infinite_word(d0l("a", {{'a', "ba"}, {'b', "b"}})));
    CHECK(!generates_infinite_word(d0l("ab", {{'a', "a"}, {'b', ""}})));
    CHECK(generates_infinite_word(d0l("a", {{'a', "ab"}, {'b', "b"}})));
}

TEST_CASE("words that vanish have no formula, and that is why") {
    CHECK(locally_catenative(d0l("a", {{'a', "b"}, {'b', ""}}), 5).because ==
          "the words are empty from some n on");
}

TEST_CASE("a pushed word is read from left to right on both sides") {
    const D0L left = d0l("a", {{'a', "bcda"}, {'b', "b"}, {'c', "c"}, {'d', "d"}});
    const auto pusher = pusher_of(left.rules, left.axiom);
    REQUIRE(pusher.has_value());
    CHECK(pusher->left);
    CHECK(spell(*left.alphabet, pusher->run) == "bcd");
    CHECK(repeated_words(left) == std::vector<std::string>{"bcd"});
    CHECK(repeated_words(d0l("a", {{'a', "abcd"}, {'b', "b"}, {'c', "c"}, {'d', "d"}})) ==
          std::vector<std::string>{"bcd"});
}

TEST_CASE("complexities of languages whose words do not contain one another") {
    // b a^(2^n) b: at most four factors of each length.
    CHECK(class_of(d0l("bab", {{'a', "aa"}, {'b', "b"}})) == "1 to 1");
    // d h^n(a) d, where h^n(a) = a b bc bcc ... is as complex as can be.
    CHECK(class_of(d0l("dad", {{'a', "ab"}, {'b', "bc"}, {'c', "c"}, {'d', "d"}})) == "n^2 to n^2");
    // a^(2^n) beside words of Thue and Morse; the two meet only in the image of t.
    CHECK(class_of(d0l("s", {{'s', "t"}, {'t', "ab"}, {'a', "aa"}, {'b', "bc"}, {'c', "cb"}})) ==
          "n to n");
}

TEST_CASE("letters that do not grow on one side make a linear language") {
    const D0L system = d0l("x", {{'x', "cxa"}, {'a', "aa"}, {'c', "c"}});
    CHECK(class_of(system) == "n to n");
    // c^i x a^j for i + j = k - 1, c^k and a^k.
    const auto complexity = factor_complexity(system, 12);
    for (std::size_t k = 1; k <= 12; ++k) CHECK(complexity[k] == k + 2);
}

TEST_CASE("a sequence is written and read without what is 0") {
    CHECK(SequenceSpecification{{0, 1}, {1, 2}, 0}.text() == "a(n) = a(n-2) for n >= 2; 1, 2");
    CHECK(read_specification("a(n) = 2a(n-1) + 0a(n-2); 1").coefficients == Numbers{2});
    CHECK(read_specification("a(n) = 0; 1").values(3) == Numbers{1, 0, 0});
    CHECK(read_specification("5").text() == "a(n) = a(n-1) for n >= 1; 5");
    CHECK(read_specification("(n^2+n)/2^1").values(4) == Numbers{0, 1, 3, 6});
    CHECK(read_specification("n^200").values(2) == Numbers{0, 1});
    CHECK(read_specification("0*n^200*n^200 + n").values(4) == Numbers{0, 1, 2, 3});
}

TEST_CASE("sequences that need a multiple of their polynomial, or many stages, or words before") {
    // x^3 - x^2 + x - 2 times x + 1 is x^4 - x - 2.
    const Realisation four = realised("a(n) = a(n-1) - a(n-2) + 2a(n-3); 1, 1, 1");
    REQUIRE(four.kind == Kind::found);
    CHECK(has_lengths(four, {{0, 0, 1, 2}, {1, 1, 1, 2}, 0}));
    // 2^n and all binomials of n over k < 64 together: a polynomial with 130 divisors.
    const Polynomial polynomial = power(Polynomial({-1, 1}), 64) * Polynomial({-2, 1});
    SequenceSpecification many;
    for (std::size_t i = 1; i <= 65; ++i)
        many.coefficients.push_back(Rational(-polynomial.coefficient(65 - i)));
    for (std::size_t n = 0; n < 64; ++n) many.initial.push_back(Rational(power(Integer(2), n + 1)));
    many.initial.push_back(Rational(power(Integer(2), 65) - 1));  // without n over 64
    CHECK(realise(many).kind == Kind::found);
    // Its first differences are positive after 65 words, of which the first stage takes one.
    CHECK(has_lengths_of("(n-65)^2+1"));
    const Realisation letters = realised("1,2,4,7,11,16,22,29");
    CHECK(letters.system->alphabet->name(0) == "a");
    CHECK(letters.system->alphabet->name(1) == "b");
}

TEST_CASE("at most nine first words are left out of a sequence that is none of lengths") {
    const Realisation nine = realised("n-8");
    CHECK(nine.kind == Kind::impossible);
    CHECK(nine.shift == 9);
    CHECK(has_lengths(nine, read_specification("n-8")));
    CHECK(!realised("n-9").system.has_value());
}

TEST_CASE("where no stages are found the answer is that it is not known") {
    CHECK(realised("a(n) = 30000a(n-1); 1")
              .because.ends_with("; some would have had rules of more than 20000 letters"));
    // A first word that is too long is a reason, too.
    for (const char* lengths : {"a(n) = 0; 30000", "a(n) = 0; 1, 30000", "a(n) = a(n-1); 30000"}) {
        INFO(lengths);
        CHECK(realised(lengths).because.ends_with(
            "; some would have had rules of more than 20000 letters"));
    }
    // Period 12, with the primitive roots of that order.
    CHECK(realised("a(n) = a(n-2) - a(n-4) + 5; 4, 5, 6, 7").kind == Kind::not_known);
    // Two roots above 12: letters that repeat 13 times would do.
    CHECK(realised("a(n) = 27a(n-1) - 181a(n-2); 2, 27").kind == Kind::not_known);
}

TEST_CASE("the largest root is found where another one is nearer to it than was asked for") {
    // ((x-2)x^18 - 1)((x-2)x^18 + 1): both factors have a root near 2, about 2^-17 apart.
    std::vector<Integer> coefficients(20, 0);
    coefficients[19] = 1;
    coefficients[18] = -2;
    Polynomial above(coefficients), below(coefficients);
    above = above - Polynomial(1);
    below = below + Polynomial(1);
    for (const long bits : {8L, 16L, 40L}) {
        const auto [low, high] = largest_root(above * below, Rational(3), bits);
        CHECK(high - low <= Rational(1, power(Integer(2), static_cast<std::uint64_t>(bits))));
        CHECK(*sign(above(Ball(high, 400))) >= 0);
        CHECK(low > Rational(2) - Rational(1, 256));
    }
    const auto [low, high] = largest_root(above * below, Rational(3), 40);
    CHECK(*sign(above(Ball(low, 400))) <= 0);
}

TEST_CASE("a system whose two largest rates are near each other has its rate found") {
    GrowthMatrix two = ring(38, {0});
    two.rows[0].push_back({0, 2});
    two.rows[19].push_back({19, 2});
    const auto all = components(two);
    REQUIRE(all.list.size() == 1);
    REQUIRE(all.list[0].rate.has_value());
    CHECK(all.list[0].rate->degree() == 19);
}
