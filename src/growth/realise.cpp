#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "exact/exact.hpp"
#include "growth/growth.hpp"

// D0L systems whose lengths are a given sequence.
//
// The specification (numbers, a recurrence or a formula) is reduced to first values and a recurrence. What cannot be lengths is said
// at once: a term that is negative or not an integer, a 0 before another number. Otherwise the search goes by stages: the
// characteristic polynomial is split into factors, each written as (x-c)^k - c1 (x-c)^(k-1) - ... - ck with natural numbers, which
// k letters with rules of their own realise, and what is left goes to the next stage; first words may come before. The system
// that is found is proved by comparing as many lengths as both recurrences have terms together.

namespace algae {

std::vector<Rational> SequenceSpecification::values(std::size_t count) const {
    std::vector<Rational> all(
        initial.begin(),
        initial.begin() + static_cast<std::ptrdiff_t>(std::min(count, initial.size())));
    while (all.size() < count) {
        Rational next = 0;
        for (std::size_t i = 0; i < coefficients.size(); ++i)
            if (!coefficients[i].is_zero()) next += coefficients[i] * all[all.size() - 1 - i];
        all.push_back(next);
    }
    return all;
}

std::string SequenceSpecification::text() const {
    std::string text = "a(n) =";
    bool first = true;
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        const Rational& c = coefficients[i];
        if (c.is_zero()) continue;
        text += sign(c) < 0 ? (first ? " -" : " - ") : (first ? " " : " + ");
        if (abs(c) != Rational(1)) text += to_string(abs(c)) + ' ';
        text += "a(n-" + std::to_string(i + 1) + ")";
        first = false;
    }
    if (first) text += " 0";
    text += " for n >= " + std::to_string(initial.size());
    for (std::size_t i = 0; i < initial.size(); ++i)
        text += (i == 0 ? "; " : ", ") + to_string(initial[i]);
    return text;
}

SequenceSpecification reduced(const SequenceSpecification& sequence) {
    SequenceSpecification result =
        recurrence_of_terms(sequence.values(2 * std::max<std::size_t>(sequence.initial.size(), 1)));
    result.terms = sequence.terms;
    return result;
}

SequenceSpecification shifted(const SequenceSpecification& sequence, std::size_t shift) {
    SequenceSpecification result = sequence;
    const auto values = sequence.values(sequence.initial.size() + shift);
    result.initial.assign(values.begin() + static_cast<std::ptrdiff_t>(shift), values.end());
    return reduced(result);
}

namespace {

using Coefficients = std::vector<Rational>;  // of a polynomial in n, from the constant one upwards

constexpr std::size_t highest_degree = 200;

Coefficients sum(Coefficients left, const Coefficients& right, const Rational& times) {
    left.resize(std::max(left.size(), right.size()));
    for (std::size_t i = 0; i < right.size(); ++i) left[i] += times * right[i];
    while (!left.empty() && left.back().is_zero()) left.pop_back();
    return left;
}

Coefficients product(const Coefficients& left, const Coefficients& right) {
    if (left.empty() || right.empty()) return {};
    Coefficients result(left.size() + right.size() - 1);
    for (std::size_t i = 0; i < left.size(); ++i)
        for (std::size_t j = 0; j < right.size(); ++j) result[i + j] += left[i] * right[j];
    return result;
}

/// Reads a specification from left to right.
class Reader {
public:
    explicit Reader(const std::string& text) : text_(text) {}

    bool at_end() {
        skip();
        return at_ == text_.size();
    }
    bool take(char c) {
        skip();
        if (at_ == text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    void expect(char c, const std::string& why) {
        if (!take(c)) fail(std::string("expected '") + c + "' " + why);
    }
    bool digit_follows() {
        skip();
        return at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0;
    }
    bool letter_follows() {
        skip();
        return at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0;
    }
    bool follows(char c) {
        skip();
        return at_ < text_.size() && text_[at_] == c;
    }
    char letter() { return text_[at_++]; }
    Rational natural(const std::string& what = "a number") {
        if (!digit_follows()) fail("expected " + what);
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0)
            ++at_;
        return Rational(Integer(std::string_view(text_).substr(begin, at_ - begin)));
    }
    std::size_t small(const std::string& what, std::size_t most) {
        const std::size_t begin = at_;
        const Rational value = natural(what + " written as a number");
        if (value > Rational(most)) {
            at_ = begin;
            skip();
            fail("expected " + what + " of at most " + std::to_string(most));
        }
        return static_cast<std::size_t>(value.numerator().to_uint64());
    }
    [[noreturn]] void fail(const std::string& expected) {
        skip();
        throw Error("the sequence \"" + text_ + "\", place " + std::to_string(at_ + 1) + ": " +
                    expected + ", found " +
                    (at_ < text_.size() ? std::string("\"") + text_.substr(at_, 12) + '"'
                                        : std::string("its end")));
    }

private:
    void skip() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
            ++at_;
    }
    const std::string& text_;
    std::size_t at_ = 0;
};

Rational signed_number(Reader& in) {
    const bool minus = in.take('-');
    Rational value = in.natural();
    if (in.take('/')) {
        const Rational divisor = in.natural();
        if (divisor.is_zero()) in.fail("expected a divisor other than 0");
        value /= divisor;
    }
    return minus ? -value : value;
}

std::vector<Rational> terms(Reader& in) {
    std::vector<Rational> values;
    do {
        if (in.follows('.')) {
            for (int i = 0; i < 3; ++i) in.expect('.', "of the dots that stand for further terms");
            break;
        }
        values.push_back(signed_number(in));
    } while (in.take(','));
    if (!in.at_end()) in.fail("expected a comma between terms");
    return values;
}

/// A polynomial: sums of products of powers; a number, ) or n before ( or n multiplies it.
Coefficients polynomial(Reader& in, int depth = 0);

Coefficients atom(Reader& in, int depth) {
    if (depth > 100) in.fail("expected at most 100 brackets within each other");
    if (in.take('(')) {
        Coefficients inside = polynomial(in, depth + 1);
        in.expect(')', "after what it encloses");
        return inside;
    }
    if (in.digit_follows()) {
        const Rational value = in.natural();
        return value.is_zero() ? Coefficients{} : Coefficients{value};
    }
    if (in.take('n')) return {0, 1};
    in.fail("expected a number, n or '('");
}

Coefficients power(Reader& in, int depth) {
    const Coefficients base = atom(in, depth);
    if (!in.take('^')) return base;
    const std::size_t exponent = in.small("an exponent", highest_degree);
    Coefficients result{1};
    for (std::size_t i = 0; i < exponent; ++i) {
        result = product(result, base);
        if (result.size() > highest_degree + 1)
            in.fail("expected a degree of at most " + std::to_string(highest_degree));
    }
    return result;
}

Coefficients factors_of(Reader& in, int depth) {
    Coefficients value = power(in, depth);
    for (;;) {
        if (in.take('/')) {
            const Coefficients divisor = power(in, depth);
            if (divisor.size() != 1) in.fail("expected a number other than 0 as the divisor");
            for (Rational& coefficient : value) coefficient /= divisor[0];
        } else if (in.take('*') || in.follows('(') || in.follows('n')) {
            value = product(value, power(in, depth));
            if (value.size() > highest_degree + 1)
                in.fail("expected a degree of at most " + std::to_string(highest_degree));
        } else {
            return value;
        }
    }
}

Coefficients polynomial(Reader& in, int depth) {
    Coefficients value;
    Rational times = in.take('-') ? -1 : 1;
    for (;;) {
        value = sum(value, factors_of(in, depth), times);
        if (in.take('+'))
            times = 1;
        else if (in.take('-'))
            times = -1;
        else
            return value;
    }
}

SequenceSpecification of_polynomial(const Coefficients& polynomial) {
    SequenceSpecification sequence;
    const std::size_t order = std::max<std::size_t>(polynomial.size(), 1);
    for (std::size_t n = 0; n < order; ++n) {
        Rational value = 0;
        for (std::size_t i = polynomial.size(); i-- > 0;)
            value = value * Rational(n) + polynomial[i];
        sequence.initial.push_back(value);
    }
    Rational binomial = 1;  // f has order-th difference 0
    for (std::size_t i = 1; i <= order; ++i) {
        binomial = binomial * Rational(order + 1 - i) / Rational(i);
        sequence.coefficients.push_back(i % 2 == 1 ? binomial : -binomial);
    }
    return sequence;
}

/// "a(n) = 2a(n-1) - a(n-3) + 5; 1, 1, 2".
SequenceSpecification recurrence(Reader& in) {
    const char name = in.letter();
    in.expect('(', "as in a(n)");
    in.expect('n', "as in a(n)");
    in.expect(')', "as in a(n)");
    in.expect('=', "after a(n)");
    std::vector<Rational> coefficients;
    Rational constant = 0, times = in.take('-') ? -1 : 1;
    for (;;) {
        Rational value = times;
        if (in.digit_follows()) {
            value *= in.natural();
            if (in.take('/')) {
                const Rational divisor = in.natural();
                if (divisor.is_zero()) in.fail("expected a divisor other than 0");
                value /= divisor;
            }
            in.take('*');
            if (!in.letter_follows()) {
                constant += value;
                value = 0;
            }
        }
        if (in.letter_follows()) {
            in.expect(name, "as on the left side");
            in.expect('(', "as in a(n-1)");
            in.expect('n', "as in a(n-1)");
            in.expect('-', "as in a(n-1)");
            const std::size_t back = in.small("a number of steps back", 1000);
            if (back == 0) in.fail("expected an earlier term than a(n)");
            in.expect(')', "as in a(n-1)");
            if (coefficients.size() < back) coefficients.resize(back);
            coefficients[back - 1] += value;
        } else if (!value.is_zero()) {
            in.fail("expected a number or an earlier term");
        }
        if (in.take('+'))
            times = 1;
        else if (in.take('-'))
            times = -1;
        else
            break;
    }
    while (!coefficients.empty() && coefficients.back().is_zero()) coefficients.pop_back();
    in.expect(';', "and first values after the recurrence");
    SequenceSpecification sequence{coefficients, terms(in), 0};
    if (sequence.initial.size() < coefficients.size())
        in.fail("expected " + std::to_string(coefficients.size()) +
                " first values, as many as the recurrence goes back");
    if (!constant.is_zero()) {  // the difference of two neighbours has no constant
        Rational next = constant;
        for (std::size_t i = 0; i < coefficients.size(); ++i)
            next += coefficients[i] * sequence.initial[sequence.initial.size() - 1 - i];
        sequence.initial.push_back(next);
        sequence.coefficients.assign(coefficients.size() + 1, 0);
        sequence.coefficients[0] = 1;
        for (std::size_t i = 0; i < coefficients.size(); ++i) {
            sequence.coefficients[i] += coefficients[i];
            sequence.coefficients[i + 1] -= coefficients[i];
        }
    }
    return sequence;
}

}  // namespace

SequenceSpecification read_specification(const std::string& text) {
    Reader in(text);
    if (in.at_end()) in.fail("expected terms such as 1,1,2,3, a recurrence or a polynomial in n");
    if (text.find('=') != std::string::npos) {
        if (!in.letter_follows()) in.fail("expected a(n) on the left side of the recurrence");
        return recurrence(in);
    }
    if (text.find(',') != std::string::npos) return recurrence_of_terms(terms(in));
    const Coefficients value = polynomial(in);
    if (!in.at_end()) in.fail("expected an operator or the end of the polynomial");
    return of_polynomial(value);
}

namespace {

/// A word of a system under construction: its letters, each with a rule of its own, and how many
/// letters fill it up.
struct StageRule {
    std::vector<std::size_t> letters;
    Integer filling;
};

/// A system under construction: the axiom and the rules of the letters 0, 1, ...; the filling letter
/// stays or vanishes.
struct StageDraft {
    StageRule axiom;
    std::vector<StageRule> rules;
};

/// A multiple of a divisor written as (x-c)^k - c1 (x-c)^(k-1) - ... - ck with natural c, c1, ..., ck.
struct StageForm {
    Integer c;
    std::vector<Integer> coefficients;  // c1, ..., ck
};

/// Rules with more letters than this are not written.
constexpr std::size_t longest_stage_rule = 20'000;

constexpr std::size_t most_divisors = 256;
constexpr std::size_t most_tries = 4'000;  // for each draft

/// x^k - c1 x^(k-1) - ... - ck as c1, ..., ck, if these are natural numbers.
std::optional<std::vector<Integer>> natural_coefficients(const Polynomial& polynomial) {
    std::vector<Integer> coefficients;
    for (long i = polynomial.degree() - 1; i >= 0; --i) {
        coefficients.push_back(-polynomial.coefficient(static_cast<std::size_t>(i)));
        if (sign(coefficients.back()) < 0) return std::nullopt;
    }
    return coefficients;
}

/// What a divisor may be multiplied by: 1, then monic polynomials of small degree and coefficients.
const std::vector<Polynomial>& multipliers() {
    static const std::vector<Polynomial> all = [] {
        std::vector<Polynomial> found{Polynomial(1)};
        for (int degree = 1; degree <= 3; ++degree) {
            std::vector<Integer> coefficients(static_cast<std::size_t>(degree) + 1, -1);
            coefficients.back() = 1;
            for (std::size_t i = 0; i < static_cast<std::size_t>(degree);) {
                found.emplace_back(coefficients);
                for (i = 0; i < static_cast<std::size_t>(degree); ++i) {
                    if (coefficients[i] < 3) {
                        coefficients[i] += 1;
                        break;
                    }
                    coefficients[i] = -1;
                }
            }
        }
        return found;
    }();
    return all;
}

/// p(x + c).
Polynomial moved(const Polynomial& p, const Integer& c) {
    const Polynomial x_and_c({c, 1});
    Polynomial result;
    for (long i = p.degree(); i >= 0; --i)
        result = result * x_and_c + Polynomial(p.coefficient(static_cast<std::size_t>(i)));
    return result;
}

/// (E - c) f, where E is the shift: f(n+1) - c f(n).
std::vector<Integer> step(const std::vector<Integer>& f, const Integer& c) {
    std::vector<Integer> g;
    for (std::size_t n = 0; n + 1 < f.size(); ++n) g.push_back(f[n + 1] - c * f[n]);
    return g;
}

bool all_zero(const std::vector<Integer>& f) {
    return std::all_of(f.begin(), f.end(), [](const Integer& value) { return value.is_zero(); });
}

/// Looks for the stages that the essay above tells of.
class StageSearch {
public:
    /// For sequences that this polynomial, monic and without the root 0, annuls.
    StageSearch(const Polynomial& characteristic, const Budget& budget) : budget_(budget) {
        for (const auto& power : factorise(characteristic).powers) powers_.push_back(power);
    }

    /// Whether the polynomial has few enough divisors to try them all.
    bool is_small() const {
        std::size_t count = 1;
        for (const auto& power : powers_)
            count *= std::min<std::size_t>(power.exponent + 1, most_divisors + 1);
        return powers_.size() <= 8 && count <= most_divisors;
    }

    /// Whether something was given up because a rule would be too long.
    bool was_too_long() const { return too_long_; }

    /// A draft of the sequence with these first values, or nothing. `fillings_stay` says that the filling
    /// letter stays, so that the rules may not fall short of it.
    std::optional<StageDraft> draft(const std::vector<Integer>& f, bool fillings_stay) {
        fillings_stay_ = fillings_stay;
        tries_ = 0;
        rules_.clear();
        std::vector<unsigned> all;
        for (const auto& power : powers_) all.push_back(power.exponent);
        const auto axiom = staged(f, all);
        if (!axiom) return std::nullopt;
        return StageDraft{*axiom, rules_};
    }

private:
    /// The axiom of a system for f, whose rules are added to rules_.
    std::optional<StageRule> staged(const std::vector<Integer>& f,
                                    const std::vector<unsigned>& left) {
        if (++tries_ > most_tries) return std::nullopt;
        budget_.check();
        std::vector<std::vector<unsigned>> choices{left};
        std::vector<unsigned> chosen(left.size(), 0);
        for (;;) {  // all parts of what is left, small ones first
            std::size_t i = 0;
            while (i < left.size() && chosen[i] == left[i]) chosen[i++] = 0;
            if (i == left.size()) break;
            ++chosen[i];
            if (chosen != left) choices.push_back(chosen);
        }
        for (const auto& choice : choices) {
            std::vector<unsigned> rest = left;
            for (std::size_t i = 0; i < left.size(); ++i) rest[i] -= choice[i];
            const bool is_last =
                std::all_of(rest.begin(), rest.end(), [](unsigned e) { return e == 0; });
            for (const StageForm& form : forms(choice)) {
                const std::size_t k = form.coefficients.size();
                if (f.size() < k + 1) continue;
                std::vector<Integer> g = f, sizes;  // of w_0, ..., w_(k-1)
                std::vector<std::vector<Integer>> stages;
                for (std::size_t i = 0; i < k; ++i) {
                    stages.push_back(g);
                    sizes.push_back(g[0]);
                    g = step(g, form.c);
                }
                if (std::any_of(sizes.begin(), sizes.end(),
                                [](const Integer& size) { return size < 1; }))
                    continue;
                if (std::any_of(sizes.begin(), sizes.end(), [](const Integer& size) {
                        return size > Integer(longest_stage_rule);
                    })) {
                    too_long_ = true;
                    continue;
                }
                for (std::size_t n = 0; n < g.size(); ++n)
                    for (std::size_t i = 0; i < k; ++i)
                        g[n] -= form.coefficients[i] * stages[k - 1 - i][n];
                const std::size_t before = rules_.size();
                rules_.resize(before + k);
                std::optional<StageRule> addend = StageRule{{}, 0};
                if (!is_last) addend = all_zero(g) ? std::nullopt : staged(g, rest);
                if (addend && set_rules(before, form, sizes, *addend))
                    return StageRule{{before}, f[0] - 1};
                rules_.resize(before);
            }
        }
        return std::nullopt;
    }

    bool set_rules(std::size_t first, const StageForm& form, const std::vector<Integer>& sizes,
                   const StageRule& addend) {
        const std::size_t k = sizes.size();
        for (std::size_t i = 0; i < k; ++i) {
            StageRule rule;
            const auto add = [&](std::size_t which, const Integer& times) {
                if (times + Integer(rule.letters.size()) > Integer(longest_stage_rule))
                    return false;
                rule.letters.insert(rule.letters.end(), static_cast<std::size_t>(times.to_uint64()),
                                    first + which);
                rule.filling += times * (sizes[which] - 1);
                return true;
            };
            bool fits = add(i, form.c);
            if (i + 1 < k) {
                fits = fits && add(i + 1, 1);
            } else {
                for (std::size_t j = 0; j < k; ++j)
                    fits = fits && add(k - 1 - j, form.coefficients[j]);
                rule.letters.insert(rule.letters.end(), addend.letters.begin(),
                                    addend.letters.end());
                rule.filling += addend.filling;
            }
            if (fillings_stay_) rule.filling -= sizes[i] - 1;
            if (sign(rule.filling) < 0) return false;
            if (!fits || rule.filling > Integer(longest_stage_rule)) {
                too_long_ = true;
                return false;
            }
            rules_[first + i] = std::move(rule);
        }
        return true;
    }

    /// The first forms of multiples of a divisor. Natural c1, ..., ck leave one root above c, and a
    /// simple one, if any is not 0 (Descartes).
    const std::vector<StageForm>& forms(const std::vector<unsigned>& exponents) {
        const auto [place, is_new] = forms_.try_emplace(exponents);
        if (!is_new) return place->second;
        Polynomial divisor = 1;
        for (std::size_t i = 0; i < exponents.size(); ++i)
            divisor *= power(powers_[i].factor, exponents[i]);
        for (const Polynomial& multiplier : multipliers())
            for (int c = 0; c <= (multiplier.degree() == 0 ? 12 : 2); ++c) {
                if (const auto found = natural_coefficients(moved(divisor * multiplier, c)))
                    place->second.push_back({c, *found});
                if (place->second.size() == 4) return place->second;
            }
        return place->second;
    }

    const Budget& budget_;
    std::vector<Factorisation::Power> powers_;
    std::map<std::vector<unsigned>, std::vector<StageForm>> forms_;
    std::vector<StageRule> rules_;
    std::size_t tries_ = 0;
    bool fillings_stay_ = false;
    bool too_long_ = false;
};

constexpr std::size_t most_first_words = 64;

/// The draft with first words before it, of which each letter becomes the next one.
std::optional<StageDraft> after_first_words(StageDraft draft, const std::vector<Integer>& f,
                                            std::size_t count, bool fillings_stay) {
    if (count == 0) return draft;
    const std::size_t shift = count;
    for (StageRule& rule : draft.rules)
        for (std::size_t& letter : rule.letters) letter += shift;
    for (std::size_t& letter : draft.axiom.letters) letter += shift;
    std::vector<StageRule> rules;
    for (std::size_t i = 0; i < count; ++i) {
        if (f[i] > Integer(longest_stage_rule)) return std::nullopt;
        StageRule rule = i + 1 < count ? StageRule{{i + 1}, f[i + 1] - 1} : draft.axiom;
        if (fillings_stay) rule.filling -= f[i] - 1;
        if (sign(rule.filling) < 0 || rule.filling > Integer(longest_stage_rule))
            return std::nullopt;
        rules.push_back(std::move(rule));
    }
    rules.insert(rules.end(), draft.rules.begin(), draft.rules.end());
    return StageDraft{{{0}, f[0] - 1}, std::move(rules)};
}

D0L system_of(const StageDraft& draft, bool fillings_stay) {
    auto alphabet = std::make_shared<Alphabet>();
    std::vector<Word> images;
    const bool many = draft.rules.size() > 23;  // a to w; x fills
    for (std::size_t i = 0; i < draft.rules.size(); ++i)
        alphabet->symbol(many ? "a_" + std::to_string(i + 1)
                              : std::string(1, static_cast<char>('a' + i)));
    std::optional<Symbol> filling;
    const auto word = [&](const StageRule& rule) {
        Word letters;
        for (const std::size_t letter : rule.letters)
            letters.push_back(static_cast<Symbol>(letter));
        if (!rule.filling.is_zero()) {
            if (!filling) filling = alphabet->symbol("x");
            letters.insert(letters.end(), static_cast<std::size_t>(rule.filling.to_uint64()),
                           *filling);
        }
        return letters;
    };
    Word axiom = word(draft.axiom);
    for (const StageRule& rule : draft.rules) images.push_back(word(rule));
    if (filling) images.push_back(fillings_stay ? Word{*filling} : Word{});
    return make_d0l(alphabet, std::move(axiom), std::move(images), "realisation");
}

/// Why the values cannot be lengths, if some first ones tell.
std::optional<std::string> why_impossible(const std::vector<Rational>& values) {
    std::optional<std::size_t> zero;
    for (std::size_t n = 0; n < values.size(); ++n) {
        const std::string term = "a(" + std::to_string(n) + ") = " + to_string(values[n]);
        if (!values[n].is_integer()) return term + " is not a natural number, so it is no length";
        if (sign(values[n]) < 0) return term + " is negative, so it is no length";
        if (zero && !values[n].is_zero())
            return "a(" + std::to_string(*zero) + ") = 0 but " + term +
                   ": the empty word stays empty, so lengths that are once 0 stay 0";
        if (values[n].is_zero() && !zero) zero = n;
    }
    return std::nullopt;
}

/// A proof that the lengths are the values: how many terms were compared, or nothing if one differs.
std::optional<std::size_t> verified(const D0L& system, const SequenceSpecification& sequence,
                                    const Budget& budget) {
    const std::size_t count = sequence.initial.size() + system.letters.size();
    const auto values = sequence.values(count);
    const auto found = lengths(system, count, budget);
    for (std::size_t n = 0; n < count; ++n)
        if (values[n] != Rational(found[n])) return std::nullopt;
    return count;
}

/// A system for values that are natural numbers, none of them 0 before another.
std::optional<D0L> built(const SequenceSpecification& sequence, const Budget& budget,
                         bool& too_long) {
    const std::size_t order = sequence.coefficients.size(), early = sequence.initial.size() - order;
    std::vector<Integer> f;
    for (const Rational& value : sequence.values(early + most_first_words + 2 * order + 40))
        f.push_back(value.numerator());
    std::vector<Integer> characteristic(order + 1, 1);
    for (std::size_t i = 0; i < order; ++i)
        characteristic[order - 1 - i] = -sequence.coefficients[i].numerator();
    if (order == 0) {  // 0 from some n on: words that become each other, then nothing
        StageDraft draft{{{0}, f[0] - 1}, {}};
        for (std::size_t i = 0; i < early; ++i) {
            too_long = f[i] > Integer(longest_stage_rule);
            if (too_long) return std::nullopt;
            draft.rules.push_back(i + 1 < early ? StageRule{{i + 1}, f[i + 1] - 1}
                                                : StageRule{{}, 0});
        }
        return system_of(draft, false);
    }
    StageSearch search(Polynomial(characteristic), budget);
    if (!search.is_small()) return std::nullopt;
    std::optional<D0L> erasing;
    std::size_t last = early + most_first_words;
    for (std::size_t first = early; first <= last; ++first) {
        const std::vector<Integer> later(f.begin() + static_cast<std::ptrdiff_t>(first), f.end());
        if (first > 0 && f[first - 1] > Integer(longest_stage_rule)) {  // so are all from here on
            too_long = true;
            break;
        }
        for (const bool stays : {true, false}) {
            if (!stays && erasing) continue;
            auto draft = search.draft(later, stays);
            if (draft) draft = after_first_words(std::move(*draft), f, first, stays);
            if (!draft) continue;
            if (stays) return system_of(*draft, stays);
            erasing = system_of(*draft, stays);
            last = std::min(last, first + 3);
        }
    }
    too_long = too_long || search.was_too_long();
    return erasing;
}

}  // namespace

Realisation realise(const SequenceSpecification& given, const Budget& budget) {
    const SequenceSpecification sequence = reduced(given);
    Realisation result;
    if (given.terms > 0 && given.terms < 2 * given.initial.size()) {
        result.because = "the " + std::to_string(given.terms) +
                         " terms determine no recurrence: their shortest one has order " +
                         std::to_string(given.initial.size()) + " and rests on " +
                         std::to_string(2 * given.initial.size()) + " terms; give more";
        return result;
    }
    // Fractions grow longer with each term, so few terms come first.
    auto values = sequence.values(sequence.initial.size() + 10);
    auto reason = why_impossible(values);
    if (!reason) {
        values = sequence.values(sequence.initial.size() + 200);
        reason = why_impossible(values);
    }
    if (reason) {
        result.kind = Realisation::Kind::impossible;
        result.because = *reason;
        std::size_t shift = 0;  // what is left may be possible
        for (std::size_t n = 0; n < 10; ++n)
            if (!values[n].is_integer() || sign(values[n]) <= 0) shift = n + 1;
        if (shift == 0 || shift == 10 ||
            std::any_of(sequence.coefficients.begin(), sequence.coefficients.end(),
                        [](const Rational& c) { return !c.is_integer(); }))
            return result;
        const SequenceSpecification later = shifted(sequence, shift);
        if (why_impossible(later.values(later.initial.size() + 200)) || later.initial.empty())
            return result;
        bool too_long = false;
        if (auto system = built(later, budget, too_long))
            if (const auto compared = verified(*system, later, budget)) {
                result.system = std::move(system);
                result.shift = shift;
                result.compared = *compared;
            }
        return result;
    }
    if (sequence.initial.empty()) {
        result.kind = Realisation::Kind::impossible;
        result.because = "a(0) = 0: an axiom has at least one letter";
        return result;
    }
    if (std::any_of(sequence.coefficients.begin(), sequence.coefficients.end(),
                    [](const Rational& c) { return !c.is_integer(); })) {
        result.because = "the shortest recurrence, " + sequence.text() +
                         ", has a coefficient that is no integer, so some term is none (Fatou "
                         "1906), but none of the "
                         "first " +
                         std::to_string(values.size());
        return result;
    }
    bool too_long = false;
    result.system = built(sequence, budget, too_long);
    const auto compared = result.system ? verified(*result.system, sequence, budget) : std::nullopt;
    if (!compared) {
        result.system.reset();
        result.because = "no product of stages with natural coefficients was found for " +
                         sequence.text() + ", with up to " + std::to_string(most_first_words) +
                         " first words before them" +
                         (too_long ? "; some would have had rules of more than " +
                                         std::to_string(longest_stage_rule) + " letters"
                                   : "");
        return result;
    }
    result.kind = Realisation::Kind::found;
    result.compared = *compared;
    result.because =
        "the lengths equal the sequence on " + std::to_string(*compared) +
        " terms: " + std::to_string(sequence.initial.size()) +
        " for the order of its recurrence and " + std::to_string(result.system->letters.size()) +
        " for the letters, so for all n, because the difference obeys a recurrence of that order";
    return result;
}

}  // namespace algae
