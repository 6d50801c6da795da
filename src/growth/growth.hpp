#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

// growth: how long the words of a D0L system are, for all generations at once. The growth matrix counts letters; from it
// come the shortest recurrence, a closed form, the growth class with its exact rate, letter frequencies, and equality of two
// growth functions (Rozenberg and Salomaa 1980, I.3; Salomaa and Soittola 1978). Beside it stand what the same
// matrices and morphisms decide of the infinite word: factors and their complexity (Pansiot's classes), repetitions, locally catenative
// formulas, and systems that realise a given sequence as their lengths.

namespace algae {

/// A square matrix of natural numbers without its zeros, row by row. The growth matrix of a system
/// has one row for each accessible letter, with as many entries as its successor has letters.
struct GrowthMatrix {
    struct Entry {
        std::size_t column;
        Integer times;
        bool operator==(const Entry&) const = default;
    };
    std::vector<std::vector<Entry>> rows;  // columns ascending

    std::size_t size() const { return rows.size(); }
    bool operator==(const GrowthMatrix&) const = default;
};

/// The matrix of `incidence_matrix`.
///
/// Example: growth_matrix(d0l("a", {{'a', "aba"}, {'b', ""}})).rows[0].size() == 2
GrowthMatrix growth_matrix(const D0L& system);
/// The same for a morphism, by symbol.
GrowthMatrix growth_matrix(const Morphism& rules);
GrowthMatrix growth_matrix(const IntegerMatrix& matrix);
IntegerMatrix dense(const GrowthMatrix& matrix);

/// How often each accessible letter occurs in the axiom.
std::vector<Integer> axiom_counts(const D0L& system);

/// A row vector times the matrix: from the letters of one generation to those of the next.
std::vector<Integer> operator*(const std::vector<Integer>& row, const GrowthMatrix& matrix);
/// The matrix times a column vector.
std::vector<Integer> operator*(const GrowthMatrix& matrix, const std::vector<Integer>& column);

/// The lengths of the words of generations 0 to count - 1.
///
/// Example: lengths(d0l("b", {{'a', "ab"}, {'b', "a"}}), 5) == std::vector<Integer>{1, 1, 2, 3, 5}
std::vector<Integer> lengths(const D0L& system, std::uint64_t count, const Budget& budget = {});

/// A complex number known to lie in a rectangle.
struct ComplexBall {
    Ball real;
    Ball imaginary;

    friend ComplexBall operator+(const ComplexBall& a, const ComplexBall& b) {
        return {a.real + b.real, a.imaginary + b.imaginary};
    }
    friend ComplexBall operator*(const ComplexBall& a, const ComplexBall& b) {
        return {a.real * b.real - a.imaginary * b.imaginary,
                a.real * b.imaginary + a.imaginary * b.real};
    }
    friend ComplexBall operator/(const ComplexBall& a, const ComplexBall& b) {
        const Ball size = b.real * b.real + b.imaginary * b.imaginary;
        const ComplexBall product = a * ComplexBall{b.real, -b.imaginary};
        return {product.real / size, product.imaginary / size};
    }
    bool contains_zero() const {
        return real.contains(Rational(0)) && imaginary.contains(Rational(0));
    }
};

inline ComplexBall power(ComplexBall base, std::uint64_t exponent) {
    ComplexBall result{Ball(1, base.real.bits()), Ball(0, base.real.bits())};
    for (; exponent != 0; exponent >>= 1) {
        if (exponent & 1) result = result * base;
        if (exponent > 1) base = base * base;
    }
    return result;
}

/// Horner's rule.
inline ComplexBall value_at(const Polynomial& polynomial, const ComplexBall& x) {
    const long bits = x.real.bits();
    ComplexBall result{Ball(0, bits), Ball(0, bits)};
    for (std::size_t k = polynomial.coefficients().size(); k-- > 0;)
        result = result * x + ComplexBall{Ball(polynomial.coefficients()[k], bits), Ball(0, bits)};
    return result;
}

/// A rate of growth: a positive algebraic integer that is the largest real root of its minimal
/// polynomial and in size at least as large as all its other roots, as the theorem of Perron and
/// Frobenius says of the spectral radius of a matrix of natural numbers. So two rates are equal
/// exactly if their minimal polynomials are.
class Rate {
public:
    /// A natural number.
    Rate(const Integer& value = 1);
    /// The largest real root of a monic irreducible polynomial, which is below `above`. That it is
    /// a rate is not checked.
    Rate(Polynomial minimal_polynomial, Rational above);

    const Polynomial& minimal_polynomial() const { return minimal_; }
    long degree() const { return minimal_.degree(); }
    /// The number itself, if it is rational; it is then an integer.
    std::optional<Integer> integer() const;
    /// An enclosure with a radius of at most 2^-bits. By Newton's method from above, which
    /// converges because no derivative has a root beyond the largest one (Gauss and Lucas).
    Ball enclosure(long bits) const;

    /// "2", "(1+sqrt(5))/2", "2^(1/3)", "((3+sqrt(5))/2)^(1/2)", otherwise "the largest real root of x^3 - x - 1".
    ///
    /// Example: Rate(Polynomial({-1, -1, 1}), 2).exact() == "(1+sqrt(5))/2"
    std::string exact() const;
    /// Correctly rounded to so many significant digits, without zeros behind the point of an integer.
    ///
    /// Example: Rate(Polynomial({-1, -1, 1}), 2).decimal(5) == "1.6180"
    std::string decimal(int digits) const;

    friend bool operator==(const Rate& left, const Rate& right) {
        return left.minimal_ == right.minimal_;
    }
    friend std::strong_ordering operator<=>(const Rate& left, const Rate& right);

private:
    Polynomial minimal_;
    Rational above_;
};

/// The largest real root of a squarefree monic polynomial none of whose roots is larger in size,
/// between two rationals at most 2^-bits apart. `above` is an upper bound.
std::pair<Rational, Rational> largest_root(const Polynomial& value, const Rational& above,
                                           long bits);

/// The spectral radius of an irreducible matrix with this characteristic polynomial, which is not a
/// power of x, below `above`: found among the irreducible factors given, exactly.
Rate spectral_radius(const std::vector<Factorisation::Power>& factors, const Rational& above);

std::ostream& operator<<(std::ostream& out, const Rate& rate);

/// The root with the positive sign before the square root of an irreducible polynomial of degree 2.
///
/// Example: to_string(larger_root(Polynomial({-1, -1, 1}))) == "(1+sqrt(5))/2"
QuadraticNumber larger_root(const Polynomial& irreducible);

/// first + second * number.
QuadraticNumber combination(const Rational& first, const Rational& second,
                            const QuadraticNumber& number);

/// "(5+3*sqrt(5))/10", "2*sqrt(2)", "(-1+i*sqrt(3))/2", "i", "3/2".
std::string to_string(const QuadraticNumber& number);

/// A quotient p(r)/q(r) of integer polynomials in a root r of a monic irreducible polynomial; where
/// the denominator is an integer, the number is a polynomial in r with rational coefficients.
struct AlgebraicNumber {
    Polynomial numerator;
    Polynomial denominator = 1;
    bool operator==(const AlgebraicNumber&) const = default;
};

/// The ring Z[r] for a root r of a monic irreducible polynomial. Elements are polynomials of smaller degree.
class NumberField {
public:
    explicit NumberField(Polynomial modulus) : modulus_(std::move(modulus)) {}

    const Polynomial& modulus() const { return modulus_; }
    Polynomial reduced(const Polynomial& value) const { return remainder(value, modulus_); }
    Polynomial multiply(const Polynomial& left, const Polynomial& right) const {
        return reduced(left * right);
    }
    Polynomial power(Polynomial base, std::size_t exponent) const;
    /// The quotient with an integer as its denominator, positive and in lowest terms: multiplies
    /// by the other conjugates of the denominator, which Cayley and Hamilton give. For small degrees:
    /// the numbers grow.
    ///
    /// Example: NumberField(Polynomial({-2, 0, 1})).simplified({1, Polynomial({0, 1})}) == AlgebraicNumber{Polynomial({0, 1}), 2}
    AlgebraicNumber simplified(const AlgebraicNumber& value) const;

private:
    Polynomial modulus_;
};

/// Letters that all occur in what each of them becomes, or one letter alone. All numbers are places
/// in `D0L::letters`.
struct Component {
    std::vector<std::size_t> letters;
    std::vector<std::size_t> below;  // components that occur in successors, without itself
    Factorisation characteristic;    // of its part of the matrix
    std::optional<Rate> rate;        // its spectral radius; none for a letter that never returns
    std::uint64_t cyclicity =
        0;  // the greatest common divisor of its cycles' lengths; 0 without a cycle
};

/// The strongly connected components of the letters.
struct Components {
    std::vector<Component> list;         // what occurs in a component's successors stands before it
    std::vector<std::size_t> of_letter;  // the component of each letter
};

/// Components by Tarjan's algorithm (Boost.Graph), rates exactly.
///
/// Example: components(growth_matrix(d0l("a", {{'a', "ab"}, {'b', "a"}}))).list[0].rate->exact() == "(1+sqrt(5))/2"
Components components(const GrowthMatrix& matrix, const Budget& budget = {});

/// det(x - matrix) and the monic polynomial of least degree that the matrix is a root of, with the
/// irreducible factors of both.
struct MatrixPolynomials {
    Polynomial characteristic;
    Polynomial minimal;
    Factorisation characteristic_factors;
    Factorisation minimal_factors;
};

/// From the characteristic polynomials of the components. Where the nonzero roots are simple, the
/// minimal polynomial needs ranks of powers of the matrix only, otherwise FLINT's elimination.
///
/// Example: matrix_polynomials(growth_matrix(d0l("F", {{'F', "F+F--F+F"}}))).minimal == Polynomial({4, -5, 1})
MatrixPolynomials matrix_polynomials(const GrowthMatrix& matrix, const Budget& budget = {});
MatrixPolynomials matrix_polynomials(const GrowthMatrix& matrix, const Components& components,
                                     const Budget& budget = {});

/// det(x - matrix): by FLINT for small matrices; for large ones, which have few entries in a row, by
/// the annihilator of a random vector, and Newton's identities for what it leaves.
Polynomial characteristic_polynomial(const GrowthMatrix& matrix, const Budget& budget = {});

/// Whether row * p(matrix) * matrix^n * column == 0 for all n, exactly: the first `matrix.size()`
/// of these numbers decide, by the theorem of Cayley and Hamilton.
bool annihilates(const Polynomial& p, const std::vector<Integer>& row, const GrowthMatrix& matrix,
                 const std::vector<Integer>& column, const Budget& budget = {});

/// The monic polynomial of least degree that annihilates the sequence row * matrix^n * column. Its
/// coefficients are integers (it divides the characteristic polynomial; Gauss's lemma).
///
/// The algorithm of Berlekamp and Massey modulo primes below 2^61, put together until the result
/// stands, which is then proved by `annihilates`; its degree is the least because no prime can ask
/// for a longer recurrence than the integers do. O(size^2) operations for each prime.
Polynomial annihilator(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                       const std::vector<Integer>& column, const Budget& budget = {});

/// The monic polynomial m of least degree with row * m(matrix) == 0.
Polynomial annihilator(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                       const Budget& budget = {});

/// A number from 0 to prime - 1.
using Residue = std::uint64_t;

/// The integers modulo a prime below 2^62.
class PrimeField {
public:
    explicit PrimeField(Residue prime) : prime_(prime) {}
    Residue prime() const { return prime_; }
    Residue residue(const Integer& value) const;
    Residue add(Residue left, Residue right) const {
        const Residue sum = left + right;
        return sum >= prime_ ? sum - prime_ : sum;
    }
    Residue subtract(Residue left, Residue right) const {
        return left >= right ? left - right : left + prime_ - right;
    }
    Residue multiply(Residue left, Residue right) const;
    Residue power(Residue base, std::uint64_t exponent) const;
    /// Of a number other than 0.
    Residue inverse(Residue value) const { return power(value, prime_ - 2); }

private:
    Residue prime_;
};

/// The largest prime below a number from 4 to 2^62.
///
/// Example: prime_below(100) == 97
Residue prime_below(Residue bound);

/// The monic polynomial, coefficients from the constant one upwards, of the shortest linear
/// recurrence of these terms (Berlekamp 1968, Massey 1969): for a sequence of order k, 2k terms
/// give it. O(terms^2).
///
/// Example: shortest_recurrence_modulo({1, 1, 2, 3, 5, 8}, PrimeField(101)) == std::vector<Residue>{100, 100, 1}
std::vector<Residue> shortest_recurrence_modulo(const std::vector<Residue>& terms,
                                                const PrimeField& field);

/// A sequence of integers that obeys a linear recurrence with constant integer coefficients from
/// some index on, given by the shortest one.
struct Recurrence {
    /// q, monic, q(0) not 0: a(n+k) + q_(k-1) a(n+k-1) + ... + q_0 a(n) == 0 for n >= exceptions;
    /// 1 where the sequence is 0 from `exceptions` on.
    Polynomial polynomial = 1;
    /// How many first values stand outside: the multiplicity of the root 0.
    std::size_t exceptions = 0;
    /// a(0), ..., a(exceptions + order - 1): what the recurrence starts from.
    std::vector<Integer> initial;

    std::size_t order() const { return static_cast<std::size_t>(polynomial.degree()); }
    /// The first n for which a(n) follows from the values before it.
    std::size_t holds_from() const { return exceptions + order(); }
    /// The first values. O(count * order) products.
    std::vector<Integer> values(std::size_t count) const;
    /// "a(n) = 5a(n-1) - 4a(n-2)"; "a(n) = 0" of order 0.
    std::string text() const;

    bool operator==(const Recurrence&) const = default;
};

/// The shortest recurrence of the lengths of the words. Its order is at most the number of
/// accessible letters, so twice as many terms decide it (Salomaa and Soittola 1978, II.3).
///
/// Example: shortest_recurrence(d0l("F", {{'F', "F+F--F+F"}})).text() == "a(n) = 5a(n-1) - 4a(n-2)"
Recurrence shortest_recurrence(const D0L& system, const Budget& budget = {});
/// The same of the numbers row * matrix^n * column.
Recurrence shortest_recurrence(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                               const std::vector<Integer>& column, const Budget& budget = {});

/// The power series with these coefficients as a quotient in lowest terms; the constant term of the
/// denominator is 1.
struct GeneratingFunction {
    Polynomial numerator;
    Polynomial denominator;
    bool operator==(const GeneratingFunction&) const = default;
};

/// Example: generating_function(shortest_recurrence(d0l("b", {{'a', "ab"}, {'b', "a"}}))).denominator == Polynomial({1, -1, -1})
GeneratingFunction generating_function(const Recurrence& recurrence);

/// "(1 + 3x)/(1 - 5x + 4x^2)", in order of rising powers, as power series are written.
std::string to_string(const GeneratingFunction& function);

/// How a sequence of lengths grows: 0 from some n on; bounded but not that; like n^k with k > 0; like
/// n^k rho^n with rho > 1.
enum class GrowthKind { zero, bounded, polynomial, exponential };

std::string to_string(GrowthKind kind);

/// f(n) lies between two positive multiples of n^degree rate^n from some n on.
struct GrowthOrder {
    GrowthKind kind = GrowthKind::zero;
    std::uint64_t degree = 0;  // k
    Rate rate = Rate(1);       // rho; 1 unless exponential

    /// "0 from some n on", "bounded", "n^2", "2^n", "n*2^n", "((1+sqrt(5))/2)^n".
    std::string text() const;
    friend bool operator==(const GrowthOrder&, const GrowthOrder&) = default;
};

/// Whether a grows more slowly than b.
bool grows_slower(const GrowthOrder& a, const GrowthOrder& b);

/// The order of |h^n(a)| for each letter a of `D0L::letters`: the largest rate of the components that
/// it reaches, and how many components of that rate follow each other on a path, less one (Salomaa
/// and Soittola 1978, II; Rozenberg and Salomaa 1980, I.3).
std::vector<GrowthOrder> letter_orders(const Components& components);

/// The order of the length of the words.
GrowthOrder growth_order(const D0L& system, const std::vector<GrowthOrder>& letters);

/// The growth of the length of a system.
struct GrowthClass {
    GrowthOrder order;
    /// Kind zero: the first n with an empty word. Kind bounded: the length is periodic from here on.
    std::uint64_t preperiod = 0;
    /// f(n)/(n^k rho^n) comes closer and closer to a function of n mod `period`; 1 if it has a limit.
    /// For kind bounded the period of the length itself; 1 for kind zero.
    Integer period = 1;
};

/// Decided with the components, the period with the roots of the shortest recurrence.
///
/// Example: growth_class(d0l("a", {{'a', "bb"}, {'b', "a"}})).period == 2
GrowthClass growth_class(const D0L& system, const Budget& budget = {});
GrowthClass growth_class(const D0L& system, const Components& components,
                         const Recurrence& recurrence);

/// The least p for which the limits of a(pn + r)/((pn + r)^k rho^(pn + r)) exist for all r, where
/// `annihilator` is the polynomial of the shortest recurrence of a.
Integer limit_period(const Polynomial& annihilator, const GrowthOrder& order,
                     const Components& components);

/// What the roots r of one irreducible polynomial add to a sequence: the sum over all of them of
/// (c_0(r) + c_1(r) n + c_2(r) n^2 + ...) r^n.
struct ClosedFormTerm {
    Polynomial polynomial;  // monic, irreducible, not x
    std::vector<AlgebraicNumber>
        coefficients;  // of the powers of n, in the field of r; the last one is not 0
};

/// a(n) as a sum of powers of algebraic numbers, from some n on; exactly.
class ClosedForm {
public:
    /// Coefficients in fields of at most this degree are polynomials in the root, of larger ones quotients.
    static constexpr long largest_written_degree = 8;

    /// By partial fractions of the generating function: the coefficients are its residues.
    explicit ClosedForm(const Recurrence& recurrence, const Budget& budget = {});

    /// By rising degree of the polynomials.
    const std::vector<ClosedFormTerm>& terms() const { return terms_; }
    /// The values that stand outside, those of n = 0, 1, ...: the form holds from there on.
    const std::vector<Integer>& exceptions() const { return exceptions_; }

    /// An enclosure of the value of the form for some n >= exceptions().size(), from enclosures of the
    /// roots with about this many bits.
    Ball value(std::uint64_t n, long bits) const;

    /// "(7*4^n - 4)/3", "((5+3*sqrt(5))/10)*((1+sqrt(5))/2)^n + ...", "sum over the roots r of
    /// x^3 - x - 1 of ((...)/23)*r^n", followed by ", for n >= 2" if there are exceptions.
    std::string text() const;

private:
    std::vector<ClosedFormTerm> terms_;
    std::vector<Integer> exceptions_;
};

/// Example: closed_form(d0l("F", {{'F', "F+F--F+F"}})).text() == "(7*4^n - 4)/3"
ClosedForm closed_form(const D0L& system, const Budget& budget = {});

/// A form as text; what `ClosedForm::text` calls.
std::string closed_form_text(const std::vector<ClosedFormTerm>& terms);

/// The roots of the polynomials of degree 3 and more that a form needs, to 12 digits, one polynomial a line:
/// "the roots of x^3 - x - 1 are 1.324717957245, ...". Only polynomials of at most this degree.
std::vector<std::string> root_lines(const ClosedForm& form, long largest_degree = 12);

/// The limit of the share of a letter, a number in the field of a rate of growth r.
class Frequency {
public:
    /// The quotient above(r)/below(r).
    Frequency(const Rate& rate, const Polynomial& above, const Polynomial& below);

    /// Where the degree of the rate is at most 8: "1/3", "(-1+sqrt(5))/2", "(r^2 - 1)/2" with r the rate.
    const std::optional<AlgebraicNumber>& number() const { return number_; }
    std::string exact() const;
    Ball enclosure(long bits) const;
    /// Correctly rounded to so many digits after the point.
    std::string decimal(int digits_after_point) const;

    friend bool operator==(const Frequency& left, const Frequency& right);
    /// Of two numbers in the field of one rate.
    friend Frequency operator+(const Frequency& left, const Frequency& right) {
        return {left.rate_, left.above_ * right.below_ + right.above_ * left.below_,
                left.below_ * right.below_};
    }

private:
    Rate rate_;
    Polynomial above_, below_;
    std::optional<AlgebraicNumber> number_;
};

/// The shares of the letters in h^n(axiom) as n grows.
struct LetterFrequencies {
    /// 1 if all shares have limits; otherwise the least p for which they have limits over n = r mod p.
    Integer period = 1;
    /// limits[r][i]: the limit for the i-th letter over n = r mod period. Empty if the words die out,
    /// or if the period is greater than `largest_period`.
    std::vector<std::vector<Frequency>> limits;

    static constexpr std::uint64_t largest_period = 24;
};

/// By the residues of the generating function of all letter counts at the rate of growth.
///
/// Example: letter_frequencies(d0l("a", {{'a', "ab"}, {'b', "a"}})).limits[0][0].exact() == "(-1+sqrt(5))/2"
LetterFrequencies letter_frequencies(const D0L& system, const Budget& budget = {});
LetterFrequencies letter_frequencies(const std::vector<Integer>& counts, const GrowthMatrix& matrix,
                                     const Components& components, const Budget& budget = {});

/// For each letter of `D0L::letters` the least n with h^n(a) empty, if there is one: then the letter
/// is mortal. O(size of the rules).
///
/// Example: lifetimes(growth_matrix(d0l("a", {{'a', "ab"}, {'b', ""}})))[1] == 1
std::vector<std::optional<std::uint64_t>> lifetimes(const GrowthMatrix& matrix);

/// A letter a with h^power(a) = a v, for the least such power.
struct Prolongation {
    Symbol letter;
    std::uint64_t power;
    bool fixed;  // v is empty: h^power(a) = a
    bool
        infinite;  // v never dies: a, h^power(a), h^(2 power)(a), ... are prefixes of one infinite word,
    // which h^power leaves as it is; a fixed point for power 1, otherwise a periodic one
    bool operator==(const Prolongation&) const = default;
};

/// All such letters, in the order of `D0L::letters`. The leftmost letter of h(a) that is not mortal
/// gives a map of letters; a must lie on one of its cycles, and what stands before it must have died
/// when the cycle closes.
///
/// Example: prolongations(d0l("a", {{'a', "ab"}, {'b', "a"}})).size() == 1
std::vector<Prolongation> prolongations(const D0L& system);

/// Whether every letter occurs in what each letter becomes at some time, and whether there is one
/// power of the morphism for which each becomes a word with all of them.
struct Primitivity {
    bool irreducible = false;
    std::optional<std::uint64_t> exponent;  // the least such power: then the morphism is primitive
};

/// By powers of the matrix of zeros and ones; the exponent by halving. O(letters^3 log(letters) / 64).
///
/// Example: primitivity(growth_matrix(d0l("a", {{'a', "ab"}, {'b', "a"}}))).exponent == 2
Primitivity primitivity(const GrowthMatrix& matrix);

/// The growth matrix: entry (i, j) is how often the j-th accessible letter occurs in the successor
/// of the i-th, in the order of `system.letters` (Rozenberg and Salomaa 1980, I.3).
///
/// Example: incidence_matrix(d0l("b", {{'a', "ab"}, {'b', "a"}})) == IntegerMatrix({{0, 1}, {1, 1}})
IntegerMatrix incidence_matrix(const D0L& system);

/// How often each accessible letter occurs in the word of generation n, in the order of
/// `system.letters`; brackets are letters.
///
/// For few generations by iterating, otherwise by repeated squaring of the growth matrix,
/// O(letters^3 log n) products of exact integers. Throws BoundReached when the numbers would have
/// more digits than budget.letters, or take more than budget.memory.
///
/// Example: parikh_vector(d0l("b", {{'a', "ab"}, {'b', "a"}}), 5) == std::vector<Integer>{3, 5}
std::vector<Integer> parikh_vector(const D0L& system, std::uint64_t n, const Budget& budget = {});

/// About the binary logarithm of the length of the word of generation n, at once for any n: by
/// repeated squaring in floating point. Good to a few parts in 10^9; minus infinity for the empty
/// word. For deciding what to try, never for an answer.
double estimated_log2_length(const D0L& system, std::uint64_t n, const Budget& budget = {});

/// The length of the word of generation n. Throws BoundReached, at once, if it has more digits than
/// budget.letters.
///
/// Example: length(d0l("F", {{'F', "F+F--F+F"}}), 6) == 9556
Integer length(const D0L& system, std::uint64_t n, const Budget& budget = {});

/// How short and how long the words of an 0L system can be, generation by generation.
struct LengthBounds {
    std::vector<Integer> least, most;  // of generations 0, 1, ..., n
    /// By letter of `OL::letters`: which of its successors leads to the shortest, or the longest, word
    /// when all n steps are still to go; the first one of several.
    std::vector<std::size_t> least_choice, most_choice;
};

/// Exact, for generations 0 to n: letters choose apart from each other, so
/// least(a, n) is the minimum over its successors u of the sum of least(b, n-1) over the letters b
/// of u, and the same with the maximum. O(n * size of the rules) additions.
///
/// Example: length_bounds(ol("a", {{'a', "a"}, {'a', "aa"}}), 3).most == std::vector<Integer>{1, 2, 4, 8}
LengthBounds length_bounds(const OL& system, std::uint64_t n, const Budget& budget = {});

/// The D0L system in which every accessible letter always makes this choice.
D0L chosen_system(const OL& system, const std::vector<std::size_t>& choices);

/// Whether the words of two systems have the same lengths in every generation, and why.
struct GrowthComparison {
    /// The first generation whose words differ in length, with both lengths.
    struct Difference {
        std::uint64_t generation;
        Integer left, right;
    };
    bool equal = false;
    /// So many first lengths decide: the difference of two sequences that obey recurrences of orders
    /// n1 and n2, the numbers of accessible letters, obeys one of order n1 + n2; if its first n1 + n2
    /// values are 0, all are.
    std::uint64_t bound = 0;
    std::optional<Difference> difference;  // if not equal
};

/// Growth equivalence of D0L systems (Rozenberg and Salomaa 1980, I.3). O(bound * size) additions.
///
/// Example: equal_growth(d0l("a", {{'a', "ab"}, {'b', "a"}}), d0l("b", {{'a', "ab"}, {'b', "a"}})).difference->generation == 1
GrowthComparison equal_growth(const D0L& left, const D0L& right, const Budget& budget = {});

/// Everything this room says about the lengths of a D0L system and its letters, exactly.
struct GrowthAnalysis {
    std::vector<Integer> lengths;  // of generations 0 to 10
    GrowthMatrix matrix;
    Components components;
    MatrixPolynomials polynomials;
    Recurrence recurrence;
    GeneratingFunction generating_function;
    ClosedForm closed_form;
    GrowthClass growth;
    // By place in D0L::letters:
    std::vector<GrowthOrder> letters;
    std::vector<std::optional<std::uint64_t>> lifetimes;
    LetterFrequencies frequencies;
    Primitivity primitivity;
    std::vector<Prolongation> prolongations;
};

/// Example: growth_analysis(d0l("F", {{'F', "F+F--F+F"}})).closed_form.text() == "(7*4^n - 4)/3"
GrowthAnalysis growth_analysis(const D0L& system, const Budget& budget = {});

/// A word and a morphism with images of the letters 0, 1, ...: a D0L system without names. What is said
/// about the factors of a D0L language is worked out on one of these, after the letters that vanish have
/// been left out or the morphism has been made injective.
struct Iterated {
    Word axiom;
    Morphism rules;
};

/// Which letters occur in h^n(u) for a letter u of `word` and some n >= 0.
std::vector<char> accessible_letters(const Morphism& rules, const Word& word);

/// The system without mortal letters, over the same numbers. No image of a letter that is left is
/// empty, and what it derives is what the first system derives with the mortal letters deleted.
Iterated skeleton(const D0L& system);

/// For each letter whether |h^n(a)| is unbounded. Linear time: it is where from the letter a
/// component can be reached in which some letter has two letters in its image that last.
std::vector<char> growing_letters(const Morphism& rules);

/// An injective morphism that does the same: h^n(w) = back(g^(n-steps)(axiom)) for n >= steps, where
/// g is `system`. Needs a morphism without empty images of accessible letters.
struct Injective {
    Iterated system;
    Morphism back;  // from its letters to the first ones; injective
    std::size_t steps = 0;
};
/// While the images are not a code they are products of fewer words, the base of the least
/// submonoid that contains them and is generated by a prefix code (the defect theorem; Berstel,
/// Perrin, Perrot and Restivo 1979): then h = f g through a smaller alphabet, and g f goes on.
Injective made_injective(const Iterated& system, const Budget& budget = {});

/// Whether the word is a factor of z z z ...
///
/// Example: is_factor_of_powers({1, 0, 1}, {0, 1})
bool is_factor_of_powers(const Word& word, const Word& z);

/// The factors of all words h^n(w) of a D0L system, up to some length.
struct FactorSet {
    std::size_t length = 0;
    std::vector<Word>
        words;  // the factors of that length, and the words of the language that are shorter
};

/// All factors of so many letters, and the whole words that have fewer; each once.
///
/// Exact, with erasing rules too: let p_j delete the letters that vanish within j steps. A factor of
/// p_j(h^(n+1)(w)) of k letters lies in p_j(h(u)) for a factor u of p_(j+1)(h^n(w)) of at most k
/// letters, because p_j(h(a)) is not empty for any letter a that p_(j+1) leaves. For j so great that
/// only letters that last are left this is a closure, and then there are finitely many steps down to
/// j = 0. O(k * number of factors * longest image) letters are looked at for each j. Throws
/// BoundReached if the factors take more than budget.memory.
FactorSet factors(const D0L& system, std::size_t length, const Budget& budget = {});

/// How many factors of 0, 1, ..., length letters the words of the language have together: the factor
/// complexity of the language (Ehrenfeucht, Lee and Rozenberg 1975), and of the infinite word where
/// the axiom begins its image, for then every word begins the next one.
///
/// Example: factor_complexity(d0l("a", {{'a', "ab"}, {'b', "a"}}), 5) ==
///     std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6}
std::vector<std::uint64_t> factor_complexity(const D0L& system, std::size_t length,
                                             const Budget& budget = {});

/// The same for a system without names whose images are not empty.
std::vector<std::uint64_t> factor_complexity(const Iterated& system, std::size_t length,
                                             const Budget& budget = {});

/// Whether h^n(w) begins h^(n+1)(w) and their lengths are unbounded, so that the words are
/// beginnings of one infinite word.
///
/// Example: generates_infinite_word(d0l("a", {{'a', "ab"}, {'b', "a"}}))
bool generates_infinite_word(const D0L& system);

/// w_n = w_(n-i1) w_(n-i2) ... w_(n-ik) for all n >= from, where w_n = h^n(w).
struct CatenativeFormula {
    std::vector<std::size_t> back;  // i1, i2, ..., ik
    std::size_t from = 0;

    /// "w(n) = w(n-1) w(n-2) for n >= 2".
    std::string text() const;
};

/// What a search for locally catenative formulas found.
struct CatenativeAnswer {
    enum class Kind { found, none, not_found };
    Kind kind = Kind::not_found;
    std::optional<CatenativeFormula> formula;
    std::string because;
};

/// A locally catenative formula of at most `depth` (its greatest i), two words or more on its right
/// side; the one of least depth, then from the least n, then with the fewest words (Rozenberg and
/// Lindenmayer 1973).
///
/// A formula that holds for one n >= depth holds for all later ones: h maps w_m to w_(m+1), so it maps
/// the equation for n to the one for n + 1. That is the whole proof, so one comparison of words
/// decides, and `from` is where it was made. None is proved where the lengths are bounded or grow
/// like a polynomial: |w_n| >= 2 |w_(n-depth)| from some n on would make them grow exponentially, or
/// bounded ones that are not 0 double. Otherwise the search ends at generation depth + `further`, or
/// when the words together have more than a million letters (or budget.letters), and says so.
///
/// Example: locally_catenative(d0l("a", {{'a', "ab"}, {'b', "a"}}), 4).formula->text() ==
///     "w(n) = w(n-1) w(n-2) for n >= 2"
CatenativeAnswer locally_catenative(const D0L& system, std::size_t depth, std::size_t further = 24,
                                    const Budget& budget = {});

/// Why a D0L system is pushy: `letter` grows, and h^steps(letter) = ... letter run, or run letter ...
/// if `left`, where `run` is not empty and has only letters that do not grow. So the letter pushes ever
/// longer words of such letters before it: run, run h^steps(run), run h^steps(run) h^(2 steps)(run), ...
/// to the right, and the same towards the left.
struct Pusher {
    Symbol letter = 0;
    std::size_t steps = 0;
    Word run;
    bool left = false;
};

/// Whether the words h^n(w) have unboundedly long factors over letters that do not grow (Ehrenfeucht
/// and Rozenberg 1983: the system is pushy), and if so, why. Decided: next to a growing letter a
/// stands the last (or first) growing letter of h(a) with what follows (or precedes) it; the system is
/// pushy exactly if in one of these two maps some cycle of accessible letters adds letters, for
/// otherwise every run between growing letters gets longer only a bounded number of times (Klouda and
/// Starosta 2015). Linear time but for writing the run.
///
/// Example: pusher_of(d0l("a", {{'a', "ab"}, {'b', "b"}})).has_value()
std::optional<Pusher> pusher_of(const D0L& system, const Budget& budget = {});

/// The same for the letters that `word` leads to, for a morphism without empty images of these.
std::optional<Pusher> pusher_of(const Morphism& rules, const Word& word, const Budget& budget = {});

/// A primitive word all of whose powers are factors of the language.
struct InfiniteRepetition {
    Word word;           // the least of its conjugates
    bool grows = false;  // whether it has a growing letter; then one letter generates it
    Symbol letter = 0;   // a growing letter that begins, or pushes, the repetition
};

/// All words of which every power is a factor of some h^n(w), one of each class of conjugates; none
/// exactly if the language is not repetitive. Decided, for every D0L system: Klouda and Starosta
/// (2015), "An algorithm for enumerating all infinite repetitions in a D0L-system"; that
/// repetitiveness is decidable is due to Ehrenfeucht and Rozenberg (1983) and to Mignosi and Seebold (1993).
///
/// Made injective, the morphism g has two kinds. Repetitions over letters that do not grow are what
/// pushing letters leave behind. The others are infinite words g^q(a) g^(2q)(a) ... that are
/// periodic: the period has each growing letter once, so it ends before the second occurrence of a,
/// and v is one exactly if the image of v is a power of the next word in the cycle, some power above 1.
/// Throws BoundReached if a repetition is longer than budget.memory allows.
///
/// Example: infinite_repetitions(d0l("a", {{'a', "ab"}, {'b', "ba"}})).empty()
std::vector<InfiniteRepetition> infinite_repetitions(const D0L& system, const Budget& budget = {});

/// Those with growing letters, of a system without names and without empty images of accessible letters.
std::vector<InfiniteRepetition> growing_repetitions(const Iterated& system,
                                                    const Budget& budget = {});

/// The orders of growth that the factor complexity of a D0L language can have; `zero` for a finite
/// language, which has no long factors. In increasing order.
enum class ComplexityClass { zero, constant, linear, n_log_log_n, n_log_n, quadratic };

/// "0", "1", "n", "n log log n", "n log n", "n^2".
///
/// Example: to_string(ComplexityClass::linear) == "n"
std::string to_string(ComplexityClass value);

/// The class, or what is known of it: p(n) grows at least like one class and at most like another.
struct ComplexityOrder {
    ComplexityClass at_least = ComplexityClass::constant;
    ComplexityClass at_most = ComplexityClass::quadratic;
    std::string because;  // what was found, and the theorem

    bool is_decided() const { return at_least == at_most; }
};

/// The class of the factor complexity of the language {h^n(w)}.
///
/// For infinite words v h^q(v) h^(2q)(v)... it is Pansiot's theorem (1984; Cassaigne and Nicolas 2010,
/// section 4.7): if only letters that do not grow occur, bounded; if the system is pushy, n^2; else,
/// for a word that is not ultimately periodic, n, n log log n or n log n as the growing letters all grow
/// like rate^n, like n^e rate^n with different e, or with different rates. Letters that vanish do not
/// matter: they make every word at most a constant times as long and can be deleted.
///
/// A language is as complex as the infinite words on both sides where h^r(w) occurs in h^(r+q)(w), up
/// to O(n) factors that lie across the middle. Otherwise the letters that come back give a bound from
/// below, all letters one from above; the class is decided where they meet.
///
/// That p is bounded is shown by p(n) <= n for one n (Morse and Hedlund 1938 for words; Balogh and
/// Bollobas 2005 for any language closed under factors); that it is not by a place that comes
/// back next to growing letters and is no part of an infinite repetition.
///
/// Example: complexity_order(d0l("a", {{'a', "ab"}, {'b', "ba"}})).at_most == ComplexityClass::linear
ComplexityOrder complexity_order(const D0L& system, const Budget& budget = {});

/// A sequence f(0), f(1), ... given by its first values and f(n) = c1 f(n-1) + ... + ck f(n-k) for
/// n >= initial.size(), which is k or more.
struct SequenceSpecification {
    std::vector<Rational> coefficients;  // c1, ..., ck
    std::vector<Rational> initial;
    std::size_t terms = 0;  // how many terms the recurrence was found from; 0 where it was given

    /// f(0), ..., f(count - 1).
    std::vector<Rational> values(std::size_t count) const;
    /// "a(n) = a(n-1) + a(n-2) for n >= 2; 1, 1".
    std::string text() const;
};

/// The shortest recurrence of a list of terms, with the fewest terms before it holds (Berlekamp 1968,
/// Massey 1969, over the rationals). It is the only one of its order exactly if there are at
/// least twice as many terms as `initial` has.
///
/// Example: recurrence_of_terms({1, 1, 2, 3, 5, 8}).coefficients == std::vector<Rational>{1, 1}
SequenceSpecification recurrence_of_terms(const std::vector<Rational>& terms);

/// The same sequence, with its shortest recurrence.
SequenceSpecification reduced(const SequenceSpecification& sequence);

/// f(n + shift).
SequenceSpecification shifted(const SequenceSpecification& sequence, std::size_t shift);

/// What a person wrote: terms "1,1,2,3,5,8", at the end "..." if they like; a recurrence with first values,
/// "a(n) = a(n-1) + a(n-2); 1, 1"; or a polynomial in n, "(n^3+5n+6)/6". Throws Error that names the place.
///
/// Example: read_specification("n^2+1").values(4) == std::vector<Rational>{1, 2, 5, 10}
SequenceSpecification read_specification(const std::string& text);

/// A D0L system with given lengths, or why there is none, or that none was found.
struct Realisation {
    enum class Kind { found, impossible, not_known };
    Kind kind = Kind::not_known;
    std::optional<D0L> system;  // of f; where that is impossible perhaps of f(n + shift)
    std::size_t shift = 0;
    std::size_t compared = 0;  // terms that were found equal, enough to prove it
    std::string because;
};

/// A D0L system with |h^n(w)| = f(n), without empty successors where that comes out at once.
///
/// Impossible if some term is not a natural number, or is 0 before one that is not: the empty word
/// stays empty. (A sequence of integers has a shortest recurrence with integer coefficients: Fatou 1906.)
///
/// Otherwise f is built in stages. Let E be the shift, c, c1, ..., ck natural numbers and f_i = (E-c)^i f.
/// If f_k = c1 f_(k-1) + ... + ck f_0 + g and g has a system with axiom u, then f has one: words w_i of
/// f_i(0) letters, each of a letter of its own and of letters that fill it up; the first becomes
/// w_i^c w_(i+1), the last of them w_(k-1)^c w_(k-1)^c1 ... w_0^ck u. (For c = 0 these are the locally
/// catenative systems of Rozenberg and Lindenmayer 1973 with an addend; for c = 1, c1 = ... = ck = 0
/// Newton's formula for polynomials.) A stage takes a divisor of the characteristic polynomial, times
/// a small polynomial, that has the form (x-c)^k - c1 (x-c)^(k-1) - ... - ck, and g has what is left. That
/// does it for every polynomial f with natural values above 0, after so many first words that the differences
/// are positive, unless these are more than 64 or a rule gets too long (20000 letters); for other sequences it is tried.
///
/// Whatever is found is compared with f on as many terms as the order of its recurrence and the number
/// of letters together: both sequences obey recurrences of these orders, so their difference obeys
/// one of the sum and is 0 if so many first terms are.
///
/// Example: realise(read_specification("1,1,2,3,5,8")).system->letters.size() == 2
Realisation realise(const SequenceSpecification& sequence, const Budget& budget = {});

}  // namespace algae
