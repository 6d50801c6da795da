#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"
#include "verify/verify.hpp"

// Statements about numbers and words that may depend on bound numbers.
//
// A term is read here into a tree. What it is worth at a point is reckoned exactly, in numbers a + b sqrt(d). With all else fixed it
// is, as a function of one number, in a space of sequences that the shift takes into itself; `order` bounds the dimension: 1 for
// a constant, which a count of a figure has to be, or a power c^n, 2 for n, the number of accessible letters for a length, the sum of
// both for u + v, the product for
// u v. A function of such a space that is 0 at as many successive numbers as the dimension is 0 everywhere; with several
// numbers, at as many points of a grid.
//
// An equation of words for all n: a morphism has to take each letter's image to the image of what the letter becomes, on
// both sides. Then it takes the words for n to those for n + 1, and it is enough that the equation holds for the first n.

namespace algae::verify {

bool Reader::of_numbers(const Field& field, Statement& read) const {
    using Kind = Statement::Kind;
    const bool is_numbers = field.has("numbers");
    if (!is_numbers && !field.has("words")) return false;
    const char* const name = is_numbers ? "numbers" : "words";
    field.only({name});
    const std::vector<Field> parts = field.at(name).list();
    if (parts.size() != 3) field.at(name).fail("expected two sides and a comparison between them");
    static constexpr std::array comparisons = {"=", "!=", "<", "<=", ">", ">="};
    static constexpr std::array kinds = {"==", "!=", "begins with", "ends with"};
    read.kind = is_numbers ? Kind::numbers : Kind::words;
    read.family = parts[1].text();
    if (is_numbers ? std::count(comparisons.begin(), comparisons.end(), read.family) == 0
                   : std::count(kinds.begin(), kinds.end(), read.family) == 0)
        parts[1].fail("there is no comparison '" + read.family + "'");
    for (const std::size_t side : {std::size_t{0}, std::size_t{2}}) {
        if (is_numbers) {
            parts[side].text();
            read.terms.push_back(parts[side]);
        } else {
            read.sides.push_back(word_factors(parts[side]));
        }
    }
    return true;
}

std::vector<WordFactor> Reader::word_factors(const Field& field) const {
    std::vector<WordFactor> all;
    for (const Field& each : field.list()) {
        WordFactor factor;
        if (each.has("system")) {
            each.only({"system", "generation", "images", "reversed"});
            factor.system = named_system(each.at("system"));
            factor.generation = each.at("generation");
            factor.generation->text();
        } else {
            each.only({"word", "images", "reversed"});
            factor.word = word(each.at("word"));
        }
        if (each.has("images"))
            for (const Field& image : each.at("images").list())
                factor.images.push_back(morphism(image));
        if (each.has("reversed")) factor.reversed = each.at("reversed").truth();
        all.push_back(std::move(factor));
    }
    return all;
}

namespace {

constexpr std::uint64_t latest_generation = 100'000, highest_order = 5'000, most_points = 50'000;

[[noreturn]] void too_hard(const std::string& why) { throw BoundReached(Bound::method, why); }

/// a + b sqrt(d).
struct Number {
    Rational a, b;
    Integer d = 1;

    bool is_rational() const { return b.is_zero(); }
    bool is_zero() const { return a.is_zero() && b.is_zero(); }
};

Integer common_root(const Number& x, const Number& y, const Field& where) {
    if (x.is_rational()) return y.d;
    if (!y.is_rational() && x.d != y.d) where.refuse("the terms have roots of different numbers");
    return x.d;
}

Number plus(const Number& x, const Number& y, const Field& where) {
    return {x.a + y.a, x.b + y.b, common_root(x, y, where)};
}
Number minus(const Number& x) { return {-x.a, -x.b, x.d}; }
Number times(const Number& x, const Number& y, const Field& where) {
    const Integer d = common_root(x, y, where);
    return {x.a * y.a + x.b * y.b * Rational(d), x.a * y.b + x.b * y.a, d};
}
Number one_over(const Number& x, const Field& where) {
    const Rational norm = x.a * x.a - x.b * x.b * Rational(x.d);
    if (norm.is_zero()) where.refuse("a division by 0");
    return {x.a / norm, -x.b / norm, x.d};
}
int sign_of(const Number& x) {
    const int a = sign(x.a), b = sign(x.b);
    if (a == 0 || b == 0 || a == b) return a != 0 ? a : b;
    return x.a * x.a > x.b * x.b * Rational(x.d) ? a : b;
}

/// A term as a tree.
struct NumberTerm {
    enum class Kind {
        constant,
        name,
        sum,
        difference,
        product,
        quotient,
        power,
        negative,
        root,
        count,
        segments,  // of the figure of a generation of the system `name`
        boxes,     // likewise, of a side
        word       // the length of a bound word without a value
    };
    Kind kind = Kind::constant;
    Rational value;
    std::string name;
    std::optional<Symbol> letter;  // that is counted; all without it
    const System* system = nullptr;
    std::vector<NumberTerm> parts;
};

class TermReader {
public:
    TermReader(const Field& field, const Reader& reader)
        : field_(field), reader_(reader), rest_(field.text()) {}

    NumberTerm whole() {
        NumberTerm read = sum();
        if (!rest_.empty()) fail("the end of the term");
        return read;
    }

private:
    using Kind = NumberTerm::Kind;

    [[noreturn]] void fail(const std::string& expected) const {
        field_.fail("expected " + expected + ", found '" + std::string(rest_.substr(0, 40)) + "'");
    }
    void skip() {
        while (rest_.starts_with(' ')) rest_.remove_prefix(1);
    }
    bool take(char c) {
        skip();
        if (!rest_.starts_with(c)) return false;
        rest_.remove_prefix(1);
        skip();
        return true;
    }
    /// The parts move: a copy for each sign would take the square of their number.
    template <class... Parts>
    static NumberTerm made(Kind kind, Parts... parts) {
        NumberTerm term;
        term.kind = kind;
        term.parts.reserve(sizeof...(parts));
        (term.parts.push_back(std::move(parts)), ...);
        return term;
    }

    NumberTerm sum() {
        if (++depth_ > 200) too_hard(field_.path() + ": brackets nested too deeply");
        NumberTerm read = product();
        for (;;) {
            if (take('+'))
                read = made(Kind::sum, std::move(read), product());
            else if (take('-'))
                read = made(Kind::difference, std::move(read), product());
            else
                break;
            if (++size_ > 10'000) too_hard(field_.path() + ": a term of more than 10000 parts");
        }
        --depth_;
        return read;
    }
    NumberTerm product() {
        NumberTerm read = signed_power();
        for (;;) {
            if (take('*'))
                read = made(Kind::product, std::move(read), signed_power());
            else if (take('/'))
                read = made(Kind::quotient, std::move(read), signed_power());
            else
                return read;
            if (++size_ > 10'000) too_hard(field_.path() + ": a term of more than 10000 parts");
        }
    }
    NumberTerm signed_power() {
        bool is_negative = false;
        while (take('-')) is_negative = !is_negative;
        NumberTerm read = power();
        return is_negative ? made(Kind::negative, std::move(read)) : read;
    }
    NumberTerm power() {
        NumberTerm base = operand();
        if (!take('^')) return base;
        if (++depth_ > 200) too_hard(field_.path() + ": powers nested too deeply");
        NumberTerm exponent = signed_power();
        --depth_;
        return made(Kind::power, std::move(base), std::move(exponent));
    }
    NumberTerm operand() {
        if (take('(')) {
            NumberTerm inner = sum();
            if (!take(')')) fail("')'");
            return inner;
        }
        std::size_t size = 0;
        const auto at = [&](std::size_t i) { return i < rest_.size() ? rest_[i] : ' '; };
        const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
        while (is_digit(at(size))) ++size;
        // 1/3 stands as an operator, so a number has digits and a point only.
        if (size > 0) {
            if (size > 10'000) too_hard(field_.path() + ": a number of more than 10000 digits");
            const std::string_view digits = rest_.substr(0, size);
            if (digits.ends_with('.') || std::count(digits.begin(), digits.end(), '.') > 1)
                fail("a number");
            NumberTerm read;
            read.value = Rational(digits);
            rest_.remove_prefix(size);
            return read;
        }
        const auto is_name = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                   c == '_' || c == '\'';
        };
        while (is_name(at(size))) ++size;
        if (size == 0) fail("a number, a name or '('");
        if (constexpr std::string_view two = "distinct segments";
            rest_.starts_with(two) && !is_name(at(two.size())))
            size = two.size();
        const std::string name(rest_.substr(0, size));
        rest_.remove_prefix(size);
        return take('(') ? call(name) : number_called(name);
    }
    NumberTerm number_called(const std::string& name) const {
        const auto bound = reader_.bound().numbers.find(name);
        if (bound == reader_.bound().numbers.end())
            field_.fail("no number is called '" + name + "'");
        NumberTerm read;
        if (bound->second) {
            read.value = Rational(*bound->second);
        } else {
            read.kind = Kind::name;
            read.name = name;
        }
        return read;
    }
    NumberTerm call(const std::string& name) {
        NumberTerm read;
        if (name == "sqrt") {
            read = made(Kind::root, sum());
        } else if (name == "length" && rest_.find(')') < rest_.find(',')) {
            const std::string word(rest_.substr(0, rest_.find(')')));
            rest_.remove_prefix(word.size());
            const auto letter = reader_.alphabet().find(word);
            if (!letter) field_.fail("no word is called '" + word + "'");
            const auto bound = reader_.bound().words.find(*letter);
            if (bound != reader_.bound().words.end()) {
                read.value = Rational(Integer(std::uint64_t{bound->second.size()}));
            } else {
                read.kind = Kind::word;
                read.letter = letter;
            }
        } else if (name == "length" || name == "count") {
            read.kind = Kind::count;
            read.system = reader_.named_system(field_, piece()).system.get();
            if (!read.system)
                too_hard(field_.path() + ": it is about a system that is not known yet");
            if (!is_d0l(*read.system)) field_.refuse("a system is not D0L");
            if (name == "count") {
                const std::string letter = piece();
                read.letter = reader_.alphabet().find(letter);
                if (!read.letter) field_.fail("'" + letter + "' is not a letter of the alphabet");
                if (is_bound_word(reader_.bound(), *read.letter))
                    field_.fail("'" + letter + "' is bound, and stands for a letter in words only");
            }
            read.parts.push_back(sum());
        } else if (name == "distinct segments" || name == "boxes") {
            const bool is_boxes = name == "boxes";
            read.kind = is_boxes ? Kind::boxes : Kind::segments;
            read.name = piece();
            read.system = reader_.named_system(field_, read.name).system.get();
            if (!read.system)
                too_hard(field_.path() + ": it is about a system that is not known yet");
            if (!is_d0l(*read.system)) field_.refuse("a system is not D0L");
            read.parts.push_back(sum());
            if (is_boxes && !take(',')) fail("',' and the side of boxes");
            if (is_boxes) read.parts.push_back(sum());
        } else {
            field_.fail("there is no function '" + name + "'");
        }
        if (!take(')')) fail("')'");
        return read;
    }
    /// What stands before the next comma, which is taken.
    std::string piece() {
        const std::size_t comma = rest_.find(',');
        if (comma == std::string_view::npos) fail("','");
        std::string_view found = rest_.substr(0, comma);
        while (found.ends_with(' ')) found.remove_suffix(1);
        rest_.remove_prefix(comma + 1);
        skip();
        return std::string(found);
    }

    const Field& field_;
    const Reader& reader_;
    std::string_view rest_;
    std::size_t depth_ = 0, size_ = 0;
};

/// A sum of multiples of numbers and a constant.
struct Affine {
    std::map<std::string, Rational> slopes;
    Rational constant;

    Rational slope(const std::string& name) const {
        const auto found = slopes.find(name);
        return found == slopes.end() ? Rational(0) : found->second;
    }
    Affine& add(const Affine& other, const Rational& factor) {
        for (const auto& [name, value] : other.slopes) slopes[name] += factor * value;
        constant += factor * other.constant;
        return *this;
    }
    bool is_constant() const {
        return std::all_of(slopes.begin(), slopes.end(),
                           [](const auto& one) { return one.second.is_zero(); });
    }
    bool is_natural() const {
        return constant.is_integer() && constant >= 0 &&
               std::all_of(slopes.begin(), slopes.end(), [](const auto& one) {
                   return one.second.is_integer() && one.second >= 0;
               });
    }
};

std::optional<Affine> affine(const NumberTerm& term) {
    using Kind = NumberTerm::Kind;
    std::vector<Affine> parts;
    if (term.kind == Kind::count || term.kind == Kind::root || term.kind == Kind::power ||
        term.kind == Kind::word || term.kind == Kind::segments || term.kind == Kind::boxes)
        return std::nullopt;
    for (const NumberTerm& part : term.parts) {
        auto one = affine(part);
        if (!one) return std::nullopt;
        parts.push_back(std::move(*one));
    }
    switch (term.kind) {
        case Kind::constant:
            return Affine{{}, term.value};
        case Kind::name:
            return Affine{{{term.name, Rational(1)}}, {}};
        case Kind::negative:
            return Affine{}.add(parts[0], Rational(-1));
        case Kind::sum:
            return parts[0].add(parts[1], Rational(1));
        case Kind::difference:
            return parts[0].add(parts[1], Rational(-1));
        case Kind::product:
            if (parts[0].is_constant()) return Affine{}.add(parts[1], parts[0].constant);
            if (parts[1].is_constant()) return Affine{}.add(parts[0], parts[1].constant);
            return std::nullopt;
        case Kind::quotient:
            if (!parts[1].is_constant() || parts[1].constant.is_zero()) return std::nullopt;
            return Affine{}.add(parts[0], Rational(1) / parts[1].constant);
        default:
            return std::nullopt;
    }
}

}  // namespace

void Reader::steps_of(const Field& field, Statement& read) const {
    if (field.kind() != JsonValue::Kind::text ||
        field.text().find_first_not_of("0123456789") == std::string::npos) {
        read.steps = field.integer();
        return;
    }
    const auto found = affine(TermReader(field, *this).whole());
    if (!found || !found->is_natural()) field.fail("expected a number of steps");
    if (found->is_constant()) {
        read.steps = found->constant.numerator();
        return;
    }
    read.bound_steps.emplace();
    if (!found->constant.is_zero()) read.bound_steps->emplace("1", found->constant.numerator());
    for (const auto& [name, slope] : found->slopes)
        if (!slope.is_zero()) read.bound_steps->emplace(name, slope.numerator());
}

namespace {

using Point = std::map<std::string, Integer>;

/// What terms are worth, and their orders.
class Reckoning {
public:
    explicit Reckoning(const Obligation& task) : task_(task) {}

    NumberTerm read(const Field& field, const Reader& reader) const {
        return TermReader(field, reader).whole();
    }

    Number value(const NumberTerm& term, const Point& point, const Field& where) {
        using Kind = NumberTerm::Kind;
        task_.budget.check();
        const auto part = [&](std::size_t i) { return value(term.parts[i], point, where); };
        switch (term.kind) {
            case Kind::constant:
                return {term.value, {}, 1};
            case Kind::name: {
                const auto found = point.find(term.name);
                if (found == point.end())
                    where.refuse("the number '" + term.name + "' has no value");
                return {Rational(found->second), {}, 1};
            }
            case Kind::negative:
                return minus(part(0));
            case Kind::sum:
                return plus(part(0), part(1), where);
            case Kind::difference:
                return plus(part(0), minus(part(1)), where);
            case Kind::product:
                return times(part(0), part(1), where);
            case Kind::quotient:
                return times(part(0), one_over(part(1), where), where);
            case Kind::power:
                return raised(part(0), part(1), where);
            case Kind::root:
                return root(part(0), where);
            case Kind::count:
                return {Rational(count(term, part(0), where)), {}, 1};
            case Kind::segments:
                return {Rational(distinct_segments(*term.system, turtle(term, where),
                                                   natural(part(0), where), where, task_.budget)),
                        {},
                        1};
            case Kind::boxes: {
                const Number side = part(1);
                if (!side.is_rational()) where.refuse("the side of boxes is not rational");
                return {Rational(met_boxes(*term.system, turtle(term, where),
                                           natural(part(0), where), side.a, where, task_.budget)),
                        {},
                        1};
            }
            case Kind::word:
                too_hard("the length of a word without a value is not known");
        }
        return {};
    }

    /// The order in a free number, where the numbers of terms are these of free ones.
    std::uint64_t order(const NumberTerm& term, const std::string& in,
                        const std::map<std::string, Affine>& numbers, const Field& where) {
        using Kind = NumberTerm::Kind;
        const auto part = [&](std::size_t i) { return order(term.parts[i], in, numbers, where); };
        const auto within = [](std::uint64_t found) {
            if (found > highest_order) too_hard("a term has a recurrence of more than 5000 terms");
            return found;
        };
        switch (term.kind) {
            case Kind::constant:
                return 1;
            case Kind::word:
                too_hard("the length of a word without a value is not known");
            case Kind::root:
                if (!is_constant(term)) too_hard("such a root is not checked");
                return 1;
            case Kind::segments:
            case Kind::boxes:
                if (!is_constant(term)) too_hard("figures of all generations are not checked");
                return 1;
            case Kind::name:
                return numbers.at(term.name).slope(in).is_zero() ? 1 : 2;
            case Kind::negative:
                return part(0);
            case Kind::sum:
            case Kind::difference:
                return within(part(0) + part(1));
            case Kind::product:
                return within(part(0) * part(1));
            case Kind::quotient:  // by a power c^n, whose inverse is one, or by a constant
                if (!is_power(term.parts[1])) too_hard("a division by this is not checked");
                return within(part(0) * part(1));
            case Kind::power: {
                const auto exponent = affine(term.parts[1]);
                if (!exponent) too_hard("such an exponent is not checked");
                const Affine free = in_free(*exponent, numbers);
                if (!free.is_constant()) {
                    if (!is_constant(term.parts[0])) too_hard("such a power is not checked");
                    for (const auto& [name, slope] : free.slopes)
                        if (!slope.is_integer()) too_hard("a broken exponent is not checked");
                    if (value(term.parts[0], {}, where).is_zero())
                        too_hard("a power of 0 is not checked");
                    return 1;
                }
                if (!free.constant.is_integer() || free.constant < 0 || free.constant > 1000)
                    too_hard("such an exponent is not checked");
                // Products of k sequences of a space of dimension d span one of dimension C(d + k - 1, k).
                std::uint64_t all = 1;
                const std::uint64_t d = part(0), k = free.constant.numerator().to_uint64();
                for (std::uint64_t i = 1; i <= k; ++i) all = within(all * (d + i - 1) / i);
                return all;
            }
            case Kind::count: {
                const auto generation = affine(term.parts[0]);
                if (!generation) too_hard("such a generation is not checked");
                const Affine free = in_free(*generation, numbers);
                if (!free.is_natural())
                    where.refuse("a generation is not a natural number for all numbers");
                if (free.slope(in).is_zero()) return 1;
                return std::max<std::uint64_t>(
                    accessible_letters(*term.system, term.system->axiom).size(), 1);
            }
        }
        return 1;
    }

private:
    static Affine in_free(const Affine& bound, const std::map<std::string, Affine>& numbers) {
        Affine free{{}, bound.constant};
        for (const auto& [name, slope] : bound.slopes) free.add(numbers.at(name), slope);
        return free;
    }
    static bool is_constant(const NumberTerm& term) {
        return term.kind != NumberTerm::Kind::name && term.kind != NumberTerm::Kind::word &&
               std::all_of(term.parts.begin(), term.parts.end(), is_constant);
    }
    /// Whether the inverse is a multiple of a power c^n.
    static bool is_power(const NumberTerm& term) {
        using Kind = NumberTerm::Kind;
        if (term.kind == Kind::product || term.kind == Kind::quotient ||
            term.kind == Kind::negative)
            return std::all_of(term.parts.begin(), term.parts.end(), is_power);
        return is_constant(term) || (term.kind == Kind::power && is_constant(term.parts[0]));
    }

    Number raised(Number base, const Number& exponent, const Field& where) const {
        if (!exponent.is_rational() || !exponent.a.is_integer() ||
            abs(exponent.a) > Rational(100'000))
            too_hard(where.path() + ": such an exponent is not checked");
        std::int64_t left = exponent.a.numerator().to_int64();
        if (left < 0) base = one_over(base, where);
        left = left < 0 ? -left : left;
        const std::uint64_t size =
            bit_length(base.a.numerator()) + bit_length(base.a.denominator()) +
            bit_length(base.b.numerator()) + bit_length(base.b.denominator());
        task_.budget.check_memory(size * static_cast<std::uint64_t>(left), "the digits of a power");
        Number made{Rational(1), {}, 1};
        for (; left > 0; left /= 2) {
            if (left % 2 == 1) made = times(made, base, where);
            if (left > 1) base = times(base, base, where);
        }
        return made;
    }

    static Number root(const Number& of, const Field& where) {
        if (!of.is_rational() || !of.a.is_integer() || of.a < 0 || of.a > Rational(1'000'000))
            too_hard(where.path() + ": such a root is not checked");
        std::uint64_t rest = of.a.numerator().to_uint64(), outside = 1;
        if (rest == 0) return {};
        for (std::uint64_t k = 1000; k > 1; --k)
            if (rest % (k * k) == 0) {
                rest /= k * k;
                outside *= k;
            }
        if (rest == 1) return {Rational(outside), {}, 1};
        return {{}, Rational(outside), Integer(rest)};
    }

    static std::uint64_t natural(const Number& generation, const Field& where) {
        if (!generation.is_rational() || !generation.a.is_integer() || generation.a < 0)
            where.refuse("a generation is not a natural number");
        if (generation.a > Rational(latest_generation))
            too_hard("generations beyond 100000 are not counted");
        return generation.a.numerator().to_uint64();
    }

    /// The turtle that the certificate has of the system of this name, which no bound name hides.
    Turtle turtle(const NumberTerm& term, const Field& where) const {
        const auto known = task_.certificate.systems.find(term.name);
        const Field root(task_.certificate.header, "", task_.certificate.file);
        if (known == task_.certificate.systems.end() || known->second.get() != term.system ||
            !root.has("turtles") || !root.at("turtles").has(term.name))
            where.refuse("no turtle of the system '" + term.name + "' is known");
        return read_turtle(root.at("turtles").at(term.name), task_.alphabet());
    }

    Integer count(const NumberTerm& term, const Number& generation, const Field& where) {
        const std::uint64_t n = natural(generation, where);
        Counts& counts = counts_[term.system];
        if (counts.empty()) {
            counts.emplace_back();
            for (const Symbol a : term.system->axiom) counts.back()[a] += Integer(1);
        }
        const System::Successors& table = term.system->tables[0];
        for (; counts.size() <= n; kept_ += 64 * counts.back().size()) {
            task_.budget.check();
            task_.budget.check_memory(kept_, "the counts of letters");
            std::map<Symbol, Integer> next;
            for (const auto& [a, times] : counts.back())
                for (const Symbol b : table[a][0]) next[b] += times;
            counts.push_back(std::move(next));
        }
        const auto& found = counts[static_cast<std::size_t>(n)];
        if (term.letter) {
            const auto one = found.find(*term.letter);
            return one == found.end() ? Integer(0) : one->second;
        }
        Integer all;
        for (const auto& [a, times] : found) all += times;
        return all;
    }

    using Counts = std::vector<std::map<Symbol, Integer>>;  // by generation
    const Obligation& task_;
    std::map<const System*, Counts> counts_;
    std::uint64_t kept_ = 0;
};

}  // namespace

std::optional<Symbol> word_measured(const Field& field, const Reader& reader) {
    const NumberTerm term = TermReader(field, reader).whole();
    return term.kind == NumberTerm::Kind::word ? term.letter : std::nullopt;
}

namespace {

bool compares(const std::string& comparison, int sign_of_difference) {
    if (comparison == "=") return sign_of_difference == 0;
    if (comparison == "!=") return sign_of_difference != 0;
    if (comparison == "<") return sign_of_difference < 0;
    if (comparison == "<=") return sign_of_difference <= 0;
    if (comparison == ">") return sign_of_difference > 0;
    return sign_of_difference >= 0;
}

std::string opposite(const std::string& comparison) {
    static const std::map<std::string, std::string> all{{"=", "!="}, {"!=", "="}, {"<", ">="},
                                                        {">=", "<"}, {">", "<="}, {"<=", ">"}};
    return all.at(comparison);
}

/// A comparison of numbers that a proof shows of all numbers that meet the conditions.
struct ForAll {
    const Quantified* said = nullptr;
    Statement body;
    std::string comparison;
    Reader reader;
    std::map<std::string, Affine> numbers;  // what the bound ones are of free ones
};

/// The least values of numbers, by conditions k < n and n >= 1.
std::map<std::string, Affine> free_numbers(const Obligation& task, const Quantified& said,
                                           const Reader& reader) {
    std::map<std::string, Affine> least;
    for (const Quantified::Name& name : said.names) least[name.name] = {};
    std::set<std::string> has_bound;
    for (const Field& field : said.conditions) {
        const Statement condition = reader.statement(field);
        const std::string& is = condition.family;
        if (condition.kind != Statement::Kind::numbers || condition.negated || is == "=" ||
            is == "!=")
            field.refuse("a condition is not a bound of a number");
        const bool to_right = is == "<" || is == "<=";
        const NumberTerm smaller = TermReader(condition.terms[to_right ? 0 : 1], reader).whole(),
                         larger = TermReader(condition.terms[to_right ? 1 : 0], reader).whole();
        auto bound = affine(smaller);
        if (larger.kind != NumberTerm::Kind::name || !least.count(larger.name) || !bound)
            field.refuse("a condition is not a bound of a number");
        if (is == "<" || is == ">") bound->constant += Rational(1);
        for (const auto& [name, slope] : bound->slopes)
            if (!least.count(name)) field.refuse("a condition is about another number");
        // A bound below 0 says nothing: the number is 0 at least.
        if (bound->is_constant() && bound->constant.is_integer() && bound->constant < 0) continue;
        if (!bound->is_natural()) field.refuse("a condition is not a bound of a number");
        if (bound->is_constant() && least[larger.name].is_constant()) {
            Affine& now = least[larger.name];
            now.constant = std::max(now.constant, bound->constant);
        } else if (has_bound.insert(larger.name).second && least[larger.name].constant.is_zero()) {
            least[larger.name] = *bound;
            continue;
        } else {
            field.refuse("two bounds of one number are not checked");
        }
        has_bound.insert(larger.name);
    }
    // Each number is its bound, in free numbers, and one free number more.
    std::map<std::string, Affine> found;
    for (std::size_t turn = 0; turn <= least.size(); ++turn)
        for (const auto& [name, bound] : least) {
            if (found.count(name)) continue;
            Affine made{{{name, Rational(1)}}, bound.constant};
            bool is_known = true;
            for (const auto& [other, slope] : bound.slopes) {
                if (slope.is_zero()) continue;
                is_known = is_known && found.count(other);
                if (is_known) made.add(found.at(other), slope);
            }
            if (is_known) found[name] = std::move(made);
        }
    if (found.size() != least.size()) task.refuse("the bounds of numbers go round in a circle");
    return found;
}

BoundNames open_numbers(const Obligation& task, const Quantified& said) {
    for (const Quantified::Name& name : said.names)
        if (name.of != "numbers" || name.most || name.size) task.wrong_kind();
    return open_names(said, task.alphabet());
}

ForAll for_all(const Obligation& task) {
    const auto said = task.statement.quantified;
    if (said->universal != task.holds) task.wrong_kind();
    const Reader reader = task.reader.with(open_numbers(task, *said));
    Statement body = reader.statement(said->body.front());
    if (body.kind != Statement::Kind::numbers) task.wrong_kind();
    std::string comparison = body.family;
    if (body.negated == said->universal) comparison = opposite(comparison);
    return {said.get(), body, comparison, reader, free_numbers(task, *said, reader)};
}

Rational at(const Affine& number, const Point& free) {
    Rational value = number.constant;
    for (const auto& [name, slope] : number.slopes) value += slope * Rational(free.at(name));
    return value;
}

}  // namespace

void check_numbers(const Obligation& task) {
    Reckoning reckoning(task);
    const Field &left = task.statement.terms[0], &right = task.statement.terms[1];
    const Number difference =
        plus(reckoning.value(reckoning.read(left, task.reader), {}, left),
             minus(reckoning.value(reckoning.read(right, task.reader), {}, right)), left);
    if (compares(task.statement.family, sign_of(difference)) != task.holds)
        task.refuse("the numbers are not so");
}

void check_recurrences(const Obligation& task) {
    const ForAll all = for_all(task);
    if (all.comparison != "=") task.wrong_kind();
    Reckoning reckoning(task);
    const Field &left_field = all.body.terms[0], &right_field = all.body.terms[1];
    const NumberTerm left = reckoning.read(left_field, all.reader),
                     right = reckoning.read(right_field, all.reader);
    std::vector<std::pair<std::string, std::uint64_t>> orders;
    std::uint64_t points = 1;
    for (const Quantified::Name& name : all.said->names) {
        const std::uint64_t order = reckoning.order(left, name.name, all.numbers, left_field) +
                                    reckoning.order(right, name.name, all.numbers, right_field);
        orders.emplace_back(name.name, order);
        points *= order;
        if (points > most_points) too_hard("it would take more than 50000 values of the numbers");
    }
    for (std::uint64_t number = 0; number < points; ++number) {
        Point free, point;
        std::uint64_t rest = number;
        for (const auto& [name, order] : orders) {
            free[name] = Integer(rest % order);
            rest /= order;
        }
        for (const auto& [name, of] : all.numbers) point[name] = at(of, free).numerator();
        const Number difference =
            plus(reckoning.value(left, point, left_field),
                 minus(reckoning.value(right, point, right_field)), left_field);
        if (difference.is_zero()) continue;
        std::string where;
        for (const auto& [name, value] : point)
            where += (where.empty() ? "" : ", ") + name + " = " + to_string(value);
        task.refuse("both sides differ for " + where);
    }
}

void check_positive(const Obligation& task) {
    const ForAll all = for_all(task);
    if (all.said->names.size() != 1 || all.comparison == "=") task.wrong_kind();
    const std::string& name = all.said->names.front().name;
    const bool left_is_larger = task.proof.at("larger").text() == "left";
    if (!left_is_larger && task.proof.at("larger").text() != "right")
        task.proof.at("larger").fail("expected 'left' or 'right'");
    const std::string& is = all.comparison;
    if (left_is_larger ? is == "<" || is == "<=" : is == ">" || is == ">=") task.wrong_kind();
    const bool strictly = is != "<=" && is != ">=";
    Reckoning reckoning(task);
    const Field &left_field = all.body.terms[0], &right_field = all.body.terms[1];
    const NumberTerm left = reckoning.read(left_field, all.reader),
                     right = reckoning.read(right_field, all.reader);
    const std::uint64_t order = reckoning.order(left, name, all.numbers, left_field) +
                                reckoning.order(right, name, all.numbers, right_field);
    const auto rationals = [&](const char* field) {
        std::vector<Rational> numbers;
        for (const Field& each : task.proof.at(field).list()) {
            numbers.emplace_back(each.text());
            if (numbers.back() < 0) each.refuse("the number is negative");
            if (numbers.size() > 1000) too_hard("more than 1000 numbers are not checked");
        }
        return numbers;
    };
    const std::vector<Rational> roots = rationals("roots"), recurrence = rationals("recurrence");
    const std::uint64_t from = task.proof.at("from").number();
    if (from > 10'000) too_hard("more than 10000 first terms are not looked up");
    const std::size_t terms = static_cast<std::size_t>(from) + roots.size() + recurrence.size() +
                              static_cast<std::size_t>(order) + 1;
    std::vector<Rational> now;
    for (std::size_t n = 0; n < terms; ++n) {
        const Point point{
            {name, at(all.numbers.at(name), {{name, Integer(std::uint64_t{n})}}).numerator()}};
        Number value = plus(reckoning.value(left, point, left_field),
                            minus(reckoning.value(right, point, right_field)), left_field);
        if (!left_is_larger) value = minus(value);
        if (!value.is_rational()) task.refuse("the difference of both sides is not rational");
        now.push_back(value.a);
    }
    const auto is_fine = [&](const Rational& term, bool positive) {
        return positive ? term > 0 : term >= 0;
    };
    for (std::size_t n = 0; n < from; ++n)
        if (!compares(is, left_is_larger ? sign(now[n]) : -sign(now[n])))
            task.refuse("one of the first terms is not as it should be");
    now.erase(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(from));
    // u > 0 follows from its first term and u(n+1) >= c u(n) where c > 0; then later sequences need not be positive.
    bool positive = strictly;
    for (const Rational& root : roots) {
        if (!is_fine(now.front(), positive))
            task.refuse("the first term of a sequence is not as it should be");
        if (positive && root.is_zero()) task.refuse("a sequence is not shown to be positive");
        positive = false;
        for (std::size_t i = 0; i + 1 < now.size(); ++i) now[i] = now[i + 1] - root * now[i];
        now.pop_back();
    }
    const std::size_t length = recurrence.size();
    for (std::size_t n = 0; n < length; ++n)
        if (!is_fine(now[n], positive))
            task.refuse("a first term of the last sequence is not as it should be");
    const bool is_zero = std::all_of(recurrence.begin(), recurrence.end(),
                                     [](const Rational& one) { return one.is_zero(); });
    if (positive && is_zero) task.refuse("the last sequence is not shown to be positive");
    // What the recurrence misses is in the space of the difference, so it is 0 if that many terms are.
    for (std::size_t n = 0; n < order; ++n) {
        Rational next;
        for (std::size_t i = 0; i < length; ++i) next += recurrence[i] * now[n + i];
        if (next != now[n + length]) task.refuse("the last sequence does not obey the recurrence");
    }
}

namespace {

constexpr std::size_t most_letters = 10'000'000;

Word backwards(Word word) {
    std::reverse(word.begin(), word.end());
    return word;
}

Word next_generation(const System& system, const Word& word, const Budget& budget) {
    const System::Successors& table = system.tables[0];
    Word next;
    budget.check();
    for (const Symbol a : word) {
        next.insert(next.end(), table[a][0].begin(), table[a][0].end());
        if (next.size() > most_letters)
            throw BoundReached(Bound::letters, "a word has more than 10000000 letters");
    }
    return next;
}

Word generation(const System& system, Word word, std::uint64_t steps, const Budget& budget) {
    for (; steps > 0; --steps) {
        Word next = next_generation(system, word, budget);
        if (next == word) break;  // and so for ever
        word = std::move(next);
    }
    return word;
}

Word image_by(const WordFactor& factor, Word word, const Obligation& task) {
    for (const auto& morphism : factor.images) {
        auto image = image_of(word, morphism, task.budget);
        if (!image) task.refuse("a morphism has no image for a letter of its word");
        word = std::move(*image);
    }
    return factor.reversed ? backwards(std::move(word)) : word;
}

/// The generation of a factor as a n + b, n from its least value on.
struct Course {
    std::uint64_t slope = 0, start = 0;
};

Course course(const WordFactor& factor, const Reader& reader,
              const std::map<std::string, Affine>& numbers) {
    const auto found = affine(TermReader(*factor.generation, reader).whole());
    if (!found) too_hard("such a generation is not checked");
    Affine free{{}, found->constant};
    for (const auto& [name, slope] : found->slopes) free.add(numbers.at(name), slope);
    if (!free.is_natural()) factor.generation->refuse("a generation is not a natural number");
    Rational slope;
    for (const auto& [name, one] : free.slopes) slope += one;
    if (slope > Rational(latest_generation) || free.constant > Rational(latest_generation))
        too_hard("generations beyond 100000 are not derived");
    return {slope.numerator().to_uint64(), free.constant.numerator().to_uint64()};
}

/// The word of a side for the first value of the number.
Word first_word(const std::vector<WordFactor>& side, const Obligation& task, const Reader& reader,
                const std::map<std::string, Affine>& numbers) {
    Word all;
    for (const WordFactor& factor : side) {
        Word word = factor.word;
        if (factor.generation) {
            const System* system = factor.system.system.get();
            if (!system) too_hard("it is about a system that is not known yet");
            if (!is_d0l(*system)) task.refuse("a system is not D0L");
            word = generation(*system, system->axiom, course(factor, reader, numbers).start,
                              task.budget);
        }
        word = image_by(factor, std::move(word), task);
        all.insert(all.end(), word.begin(), word.end());
        if (all.size() > most_letters)
            throw BoundReached(Bound::letters, "a word has more than 10000000 letters");
    }
    return all;
}

bool compares(const std::string& kind, const Word& left, const Word& right) {
    if (kind == "==") return left == right;
    if (kind == "!=") return left != right;
    if (left.size() < right.size()) return false;
    return stands_at(right, left, kind == "begins with" ? 0 : left.size() - right.size());
}

}  // namespace

void check_words(const Obligation& task) {
    const Word left = first_word(task.statement.sides[0], task, task.reader, {}),
               right = first_word(task.statement.sides[1], task, task.reader, {});
    if (compares(task.statement.family, left, right) != task.holds)
        task.refuse("the words are not so");
}

void check_step_of_words(const Obligation& task) {
    const auto said = task.statement.quantified;
    if (!said->universal || !task.holds || said->names.size() != 1) task.wrong_kind();
    const Reader reader = task.reader.with(open_numbers(task, *said));
    const Statement body = reader.statement(said->body.front());
    if (body.kind != Statement::Kind::words || body.negated || body.family == "!=")
        task.wrong_kind();
    const auto numbers = free_numbers(task, *said, reader);
    std::map<Symbol, Word> step;
    for (const auto& [letter, images] : task.reader.images(task.proof.at("morphism"), false))
        step[letter] = images.front();
    for (const auto& side : body.sides)
        for (const WordFactor& factor : side) {
            // Each letter that occurs in the factor's words, and what it becomes from one number to the next.
            std::map<Symbol, Word> becomes;
            if (!factor.generation) {
                for (const Symbol a : factor.word) becomes[a] = {a};
            } else {
                const System* system = factor.system.system.get();
                if (!system) too_hard("it is about a system that is not known yet");
                if (!is_d0l(*system)) task.refuse("a system is not D0L");
                const Course of = course(factor, reader, numbers);
                std::vector<Symbol> open =
                    generation(*system, system->axiom, of.start, task.budget);
                while (!open.empty()) {
                    const Symbol a = open.back();
                    open.pop_back();
                    if (becomes.count(a)) continue;
                    const Word& next = becomes[a] = generation(*system, {a}, of.slope, task.budget);
                    open.insert(open.end(), next.begin(), next.end());
                }
            }
            for (const auto& [letter, word] : becomes) {
                const auto moved = image_of(image_by(factor, {letter}, task), step, task.budget);
                if (!moved || *moved != image_by(factor, word, task))
                    task.refuse("the morphism does not take the image of '" +
                                task.alphabet().name(letter) + "' to that of its successor");
            }
        }
    const Word left = first_word(body.sides[0], task, reader, numbers),
               right = first_word(body.sides[1], task, reader, numbers);
    if (!compares(body.family, left, right)) task.refuse("it is not so for the first number");
}

}  // namespace algae::verify
