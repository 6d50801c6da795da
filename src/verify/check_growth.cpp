#include <algorithm>
#include <map>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/verify.hpp"

// Statements about growth: equal lengths of two systems, a formula for lengths, and the class of a growth function.
//
// Lengths and a formula both obey linear recurrences, so as many equal terms as both have together prove equality for all n. The
// formula is read here into a sum of polynomials times powers, exactly, which also gives its order. The class is read off
// the graph of letters: a letter that derives itself twice means exponential growth, otherwise the longest chain of cycles gives
// the degree.

namespace algae::verify {

namespace {

constexpr std::uint64_t most_bits = 200'000;
constexpr std::size_t most_coefficients = 2'000;

[[noreturn]] void too_hard(const Field& field, const std::string& why) {
    throw BoundReached(Bound::method, field.path() + ": " + why);
}

std::uint64_t bits(const Rational& value) {
    return bit_length(value.numerator()) + bit_length(value.denominator());
}

Rational checked_power(const Rational& base, const Integer& exponent, const Field& field) {
    if (!exponent.fits_int64() || abs(exponent) > 100'000 ||
        bits(base) * static_cast<std::uint64_t>(abs(exponent).to_int64()) > most_bits)
        too_hard(field, "the power is too large to be checked");
    if (base.is_zero() && exponent < 0) field.fail("a negative power of 0");
    return power(base, exponent.to_int64());
}

}  // namespace

/// A function of n that is a sum of polynomials in n times powers b^n, exactly; 0^0 is 1.
class ExponentialPolynomial {
public:
    ExponentialPolynomial() = default;

    /// The function that a formula gives: numbers, n, + - * / ^ and brackets; ^ binds tightest and to the
    /// right. Throws Error at `field` if it cannot be read, BoundReached if it is not such a function, or too large.
    static ExponentialPolynomial read(const Field& field);
    /// The sum of the terms that a proof lists: {"coefficient", "power", "base"} each.
    static ExponentialPolynomial read_terms(const Field& field) {
        ExponentialPolynomial all;
        for (const Field& each : field.list()) {
            each.only({"coefficient", "power", "base"});
            const auto rational = [&](const char* name) {
                const Field part = each.at(name);
                if (part.text().size() > 10'000)
                    too_hard(part, "the number is too large to be checked");
                return Rational(part.text());
            };
            const std::uint64_t power = each.at("power").number();
            if (power >= most_coefficients) too_hard(each, "the power is too large to be checked");
            ExponentialPolynomial term;
            Coefficients coefficients(static_cast<std::size_t>(power) + 1);
            coefficients.back() = rational("coefficient");
            term.terms_[rational("base")] = std::move(coefficients);
            term.settle();
            all.add(term, 1);
        }
        return all;
    }

    Rational operator()(std::uint64_t n) const {
        Rational value;
        for (const auto& [base, coefficients] : terms_) {
            Rational polynomial;
            for (auto each = coefficients.rbegin(); each != coefficients.rend(); ++each)
                polynomial = polynomial * Rational(Integer(n)) + *each;
            value += polynomial * power(base, static_cast<std::int64_t>(n));
        }
        return value;
    }
    /// The order of the linear recurrence that it obeys.
    std::size_t order() const {
        std::size_t order = 0;
        for (const auto& [base, coefficients] : terms_) order += coefficients.size();
        return order;
    }

    bool operator==(const ExponentialPolynomial&) const = default;

private:
    friend class FormulaReader;
    using Coefficients = std::vector<Rational>;  // of 1, n, n^2, ...

    static ExponentialPolynomial constant(const Rational& value) {
        ExponentialPolynomial made;
        made.terms_[Rational(1)] = {value};
        made.settle();
        return made;
    }
    static ExponentialPolynomial raised(const ExponentialPolynomial& base,
                                        const ExponentialPolynomial& exponent, const Field& field) {
        if (const Rational* times = exponent.as_constant();
            times && times->denominator() == 1 && times->numerator() >= 0) {
            if (times->numerator() > 1000) {
                if (const Rational* value = base.as_constant())
                    return constant(checked_power(*value, times->numerator(), field));
                too_hard(field, "the power is too large to be checked");
            }
            ExponentialPolynomial product = constant(1);
            for (std::uint64_t i = times->numerator().to_uint64(); i > 0; --i) {
                product = product.times(base);
                product.check_size(field);
            }
            return product;
        }
        const Rational* value = base.as_constant();
        const auto linear = exponent.terms_.find(Rational(1));
        if (!value || exponent.terms_.size() > 1 || linear == exponent.terms_.end() ||
            linear->second.size() > 2)
            too_hard(field, "a formula with such a power cannot be checked");
        const Rational fixed = linear->second[0];
        const Rational slope = linear->second.size() > 1 ? linear->second[1] : Rational();
        if (fixed.denominator() != 1 || slope.denominator() != 1)
            too_hard(field, "a formula with a broken exponent cannot be checked");
        if (value->is_zero() && (sign(fixed) < 0 || sign(slope) < 0))
            field.fail("a negative power of 0");
        ExponentialPolynomial made;
        made.terms_[checked_power(*value, slope.numerator(), field)] = {
            checked_power(*value, fixed.numerator(), field)};
        made.settle();
        return made;
    }
    /// The inverse, of a constant times a power b^n. Throws BoundReached if it is something else.
    ExponentialPolynomial inverse(const Field& field) const {
        if (terms_.empty()) field.fail("a division by 0");
        const auto& [base, coefficients] = *terms_.begin();
        if (terms_.size() != 1 || coefficients.size() != 1 || base.is_zero())
            too_hard(field, "a formula that divides by this cannot be checked");
        ExponentialPolynomial made;
        made.terms_[Rational(1) / base] = {Rational(1) / coefficients.front()};
        return made;
    }
    const Rational* as_constant() const {
        static const Rational zero;
        if (terms_.empty()) return &zero;
        const auto& [base, coefficients] = *terms_.begin();
        return terms_.size() == 1 && base == Rational(1) && coefficients.size() == 1
                   ? &coefficients.front()
                   : nullptr;
    }
    void add(const ExponentialPolynomial& other, const Rational& factor) {
        for (const auto& [base, coefficients] : other.terms_) {
            Coefficients& sum = terms_[base];
            if (sum.size() < coefficients.size()) sum.resize(coefficients.size());
            for (std::size_t i = 0; i < coefficients.size(); ++i)
                sum[i] += factor * coefficients[i];
        }
        settle();
    }
    ExponentialPolynomial times(const ExponentialPolynomial& other) const {
        ExponentialPolynomial product;
        for (const auto& [base, left] : terms_)
            for (const auto& [other_base, right] : other.terms_) {
                Coefficients& sum = product.terms_[base * other_base];
                if (sum.size() < left.size() + right.size() - 1)
                    sum.resize(left.size() + right.size() - 1);
                for (std::size_t i = 0; i < left.size(); ++i)
                    for (std::size_t j = 0; j < right.size(); ++j) sum[i + j] += left[i] * right[j];
            }
        product.settle();
        return product;
    }
    void settle() {
        for (auto term = terms_.begin(); term != terms_.end();) {
            Coefficients& all = term->second;
            if (term->first.is_zero() && all.size() > 1) all.resize(1);  // n 0^n is 0
            while (!all.empty() && all.back().is_zero()) all.pop_back();
            term = all.empty() ? terms_.erase(term) : std::next(term);
        }
    }
    /// Throws BoundReached if it has grown too large.
    void check_size(const Field& field) const {
        if (order() > most_coefficients)
            too_hard(field, "the formula has too many terms to be checked");
        for (const auto& [base, coefficients] : terms_) {
            std::uint64_t most = bits(base);
            for (const Rational& each : coefficients) most = std::max(most, bits(each));
            if (most > most_bits)
                too_hard(field, "the formula has numbers too large to be checked");
        }
    }

    std::map<Rational, Coefficients> terms_;  // by base; no polynomial is zero
};

/// Reads a formula from left to right.
class FormulaReader {
public:
    using Value = ExponentialPolynomial;

    explicit FormulaReader(const Field& field) : field_(field), rest_(field.text()) {}

    Value whole() {
        Value value = sum();
        if (!rest_.empty())
            field_.fail("expected the end of the formula, found '" + std::string(rest_) + "'");
        return value;
    }

private:
    bool take(char c) {
        while (rest_.starts_with(' ')) rest_.remove_prefix(1);
        if (!rest_.starts_with(c)) return false;
        rest_.remove_prefix(1);
        while (rest_.starts_with(' ')) rest_.remove_prefix(1);
        return true;
    }

    Value checked(Value value) const {
        value.check_size(field_);
        return value;
    }

    Value sum() {
        if (++depth_ > 200)
            throw BoundReached(Bound::method, field_.path() + ": brackets nested too deeply");
        Value value = product();
        for (;;) {
            if (take('+'))
                value.add(product(), 1);
            else if (take('-'))
                value.add(product(), -1);
            else
                break;
            value.check_size(field_);
        }
        --depth_;
        return value;
    }

    Value product() {
        Value value = signed_power();
        for (;;) {
            if (take('*'))
                value = checked(value.times(signed_power()));
            else if (take('/'))
                value = checked(value.times(signed_power().inverse(field_)));
            else
                return value;
        }
    }

    Value signed_power() {
        bool negative = false;
        while (take('-')) negative = !negative;
        Value value = power();
        if (!negative) return value;
        Value opposite;
        opposite.add(value, -1);
        return opposite;
    }

    Value power() {
        Value base = operand();
        if (!take('^')) return base;
        if (++depth_ > 200)
            throw BoundReached(Bound::method, field_.path() + ": powers nested too deeply");
        const Value exponent = signed_power();
        --depth_;
        return checked(Value::raised(base, exponent, field_));
    }

    Value operand() {
        if (take('(')) {
            Value value = sum();
            if (!take(')')) field_.fail("a ')' is missing in the formula");
            return value;
        }
        if (take('n')) {
            Value value;
            value.terms_[Rational(1)] = {Rational(0), Rational(1)};
            return value;
        }
        std::size_t size = 0;
        while (size < rest_.size() &&
               ((rest_[size] >= '0' && rest_[size] <= '9') || rest_[size] == '.'))
            ++size;
        if (size == 0)
            field_.fail("expected a number, n or '(' in the formula, found '" + std::string(rest_) +
                        "'");
        if (size > 10'000) too_hard(field_, "the formula has numbers too large to be checked");
        const Rational value(rest_.substr(0, size));
        rest_.remove_prefix(size);
        return checked(Value::constant(value));
    }

    const Field& field_;
    std::string_view rest_;
    std::size_t depth_ = 0;
};

ExponentialPolynomial ExponentialPolynomial::read(const Field& field) {
    return FormulaReader(field).whole();
}

namespace {

void must_be_d0l(const Obligation& task) {
    for (std::size_t i = 0; i < task.statement.systems.size(); ++i)
        if (!is_d0l(task.system(i))) task.refuse("a system is not D0L");
}

}  // namespace

/// The lengths of both systems obey linear recurrences of as many terms as they have letters, so their
/// difference obeys one of as many as both have together.
void check_equal_terms(const Obligation& task) {
    must_be_d0l(task);
    Lengths one(task.system(0)), other(task.system(1));
    const std::size_t terms = one.letters() + other.letters();
    for (std::size_t n = 0; n < terms; ++n) {
        task.budget.check();
        if (one.length() != other.length())
            task.refuse("generation " + std::to_string(n) + " differs in length");
        one.next();
        other.next();
    }
}

void check_other_length(const Obligation& task) {
    must_be_d0l(task);
    check_lengths_differ(task);
}

void check_formula_terms(const Obligation& task) {
    must_be_d0l(task);
    const auto formula = ExponentialPolynomial::read(*task.statement.formula);
    Lengths lengths(task.system());
    const std::size_t terms = lengths.letters() + formula.order();
    if (task.proof.has("terms") &&
        !(ExponentialPolynomial::read_terms(task.proof.at("terms")) == formula))
        task.proof.at("terms").refuse("the formula has other terms");
    for (std::size_t n = 0; n < terms; ++n, lengths.next()) {
        task.budget.check();
        if (formula(n) != Rational(lengths.length()))
            task.refuse("generation " + std::to_string(n) + " has " + to_string(lengths.length()) +
                        " letters");
    }
}

void check_formula_fails(const Obligation& task) {
    must_be_d0l(task);
    const auto formula = ExponentialPolynomial::read(*task.statement.formula);
    const Field field = task.proof.at("generation");
    const Integer generation = field.integer();
    const Integer length = length_of_generation(task.system(), generation, task.budget);
    if (generation > 10'000)
        throw BoundReached(Bound::method, "the formula is not worked out beyond 10000");
    if (formula(generation.to_uint64()) == Rational(length))
        field.refuse("the word has as many letters as the formula says");
}

namespace {

/// Which letters can be reached from which, by one step or more.
class LetterGraph {
public:
    explicit LetterGraph(const System& system)
        : letters_(accessible_letters(system, system.axiom)), table_(system.tables.front()) {
        for (const Symbol a : letters_) reach(a);
    }

    /// A letter that becomes a word with itself in it twice or more.
    bool doubles() const {
        return std::any_of(letters_.begin(), letters_.end(), [&](Symbol a) {
            const Word& image = table_[a].front();
            return std::count_if(image.begin(), image.end(), [&](Symbol b) {
                       return reached_.at(b).contains(a) || b == a;
                   }) > 1;
        });
    }
    /// The most cycles one after the other on a way through the letters, where no letter doubles.
    std::size_t longest_chain() const {
        std::size_t longest = 0;
        std::map<Symbol, std::size_t> found;
        for (const Symbol a : letters_) longest = std::max(longest, chain(a, found));
        return longest;
    }

private:
    void reach(Symbol from) {
        auto& reached = reached_[from];
        std::vector<Symbol> open{from};
        while (!open.empty()) {
            const Symbol a = open.back();
            open.pop_back();
            for (const Symbol b : table_[a].front())
                if (reached.insert(b).second) open.push_back(b);
        }
    }

    /// The most cycles beginning with that of a letter, or after the letter if it is on none.
    std::size_t chain(Symbol a, std::map<Symbol, std::size_t>& found) const {
        if (const auto known = found.find(a); known != found.end()) return known->second;
        const auto& reached = reached_.at(a);
        std::size_t longest = 0;
        for (const Symbol b : reached)
            if (!reached_.at(b).contains(a)) longest = std::max(longest, chain(b, found));
        return found[a] = longest + (reached.contains(a) ? 1 : 0);
    }

    std::vector<Symbol> letters_;
    const System::Successors& table_;
    std::map<Symbol, std::set<Symbol>> reached_;
};

}  // namespace

Growth growth_of(const System& system) {
    const LetterGraph graph(system);
    if (graph.doubles()) return {"exponential", 0};
    const std::size_t cycles = graph.longest_chain();
    if (cycles == 0) return {"zero", 0};
    return {cycles == 1 ? "bounded" : "polynomial", cycles - 1};
}

void check_growth_class(const Obligation& task) {
    must_be_d0l(task);
    const Statement& statement = task.statement;
    const Growth found = growth_of(task.system());
    const bool is =
        found.name == statement.family && (!statement.size || *statement.size == found.degree);
    if (is != task.holds)
        task.refuse(
            "the growth is " + found.name +
            (found.name == "polynomial" ? " of degree " + std::to_string(found.degree) : ""));
}

// Lengths that never fall: no accessible letter is erased. That they always rise is checked on the sets of letters that
// occur together, until a set comes again.

void check_rises(const Obligation& task) {
    must_be_d0l(task);
    const System& system = task.system();
    const System::Successors& table = system.tables[0];
    for (const Symbol a : accessible_letters(system, system.axiom))
        if (table[a][0].empty()) task.refuse("a letter is erased");
    if (!task.statement.strictly) return;
    std::set<std::set<Symbol>> seen;
    std::set<Symbol> now(system.axiom.begin(), system.axiom.end());
    while (seen.insert(now).second) {
        task.budget.check();
        bool rises = false;
        std::set<Symbol> next;
        for (const Symbol a : now) {
            rises = rises || table[a][0].size() > 1;
            next.insert(table[a][0].begin(), table[a][0].end());
        }
        if (!rises)
            task.refuse("generation " + std::to_string(seen.size() - 1) +
                        " is as long as the next one");
        now = std::move(next);
    }
}

void check_falls(const Obligation& task) {
    must_be_d0l(task);
    const Integer generation = task.proof.at("generation").integer();
    const Integer before = length_of_generation(task.system(), generation, task.budget);
    const Integer after = length_of_generation(task.system(), generation + 1, task.budget);
    if (after > before || (after == before && !task.statement.strictly))
        task.refuse("the next generation is not shorter");
}

void check_words(const Obligation& task) {
    must_be_d0l(task);
    constexpr std::size_t most = 10'000'000;  // letters
    std::vector<Word> words;
    for (std::size_t i = 0; i < 2; ++i) {
        const System::Successors& table = task.system(i).tables[0];
        Word word = task.system(i).axiom;
        for (std::uint64_t n = 0; n < task.statement.generations[i]; ++n) {
            task.budget.check();
            Word next;
            for (const Symbol a : word) {
                next.insert(next.end(), table[a][0].begin(), table[a][0].end());
                if (next.size() > most)
                    throw BoundReached(Bound::letters, "a word has more than 10000000 letters");
            }
            if (next == word) break;  // and so for ever
            word = std::move(next);
        }
        words.push_back(std::move(word));
    }
    const Word &left = words[0], &right = words[1];
    const bool is_so =
        task.statement.kind == Statement::Kind::equal_words
            ? left == right
            : left.size() >= right.size() && std::equal(right.begin(), right.end(), left.begin());
    if (is_so != task.holds)
        task.refuse(is_so ? "the words are as the statement says" : "the words are not so");
}

}  // namespace algae::verify
