#include "growth/realise.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "exact/polynomial.hpp"
#include "growth/growth_matrix.hpp"

namespace algae {

namespace {

constexpr std::size_t longest_rule = 20'000;  // letters
constexpr std::size_t most_first_words = 64;
constexpr std::size_t most_divisors = 256;
constexpr std::size_t most_tries = 4'000;  // for each number of first words

/// One letter of its own for each word of a stage, and how many letters fill the word up.
struct Rule {
    std::vector<std::size_t> letters;
    Integer filling;
};

/// What is built: the axiom and the rules of the letters 0, 1, ...; what fills stays or vanishes.
struct Draft {
    Rule axiom;
    std::vector<Rule> rules;
};

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

/// A multiple of a divisor written as (x-c)^k - c1 (x-c)^(k-1) - ... - ck with natural c, c1, ..., ck.
struct Form {
    Integer c;
    std::vector<Integer> coefficients;  // c1, ..., ck
};

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

/// Looks for stages.
class Search {
public:
    Search(const Polynomial& characteristic, const Budget& budget) : budget_(budget) {
        for (const auto& power : factorise(characteristic).powers) powers_.push_back(power);
    }

    bool is_small() const {
        std::size_t count = 1;
        for (const auto& power : powers_) count *= std::min<std::size_t>(power.exponent + 1, most_divisors + 1);
        return powers_.size() <= 8 && count <= most_divisors;
    }

    /// Whether something was given up because a rule would be too long.
    bool was_too_long() const { return too_long_; }

    /// A draft of a sequence that the characteristic polynomial annuls, from its first values.
    std::optional<Draft> draft(const std::vector<Integer>& f, bool fillings_stay) {
        fillings_stay_ = fillings_stay;
        tries_ = 0;
        rules_.clear();
        std::vector<unsigned> all;
        for (const auto& power : powers_) all.push_back(power.exponent);
        const auto axiom = staged(f, all);
        if (!axiom) return std::nullopt;
        return Draft{*axiom, rules_};
    }

private:
    /// The axiom of a system for f, whose rules are added to rules_.
    std::optional<Rule> staged(const std::vector<Integer>& f, const std::vector<unsigned>& left) {
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
            const bool is_last = std::all_of(rest.begin(), rest.end(), [](unsigned e) { return e == 0; });
            for (const Form& form : forms(choice)) {
                const std::size_t k = form.coefficients.size();
                if (f.size() < k + 1) continue;
                std::vector<Integer> g = f, sizes;  // of w_0, ..., w_(k-1)
                std::vector<std::vector<Integer>> stages;
                for (std::size_t i = 0; i < k; ++i) {
                    stages.push_back(g);
                    sizes.push_back(g[0]);
                    g = step(g, form.c);
                }
                if (std::any_of(sizes.begin(), sizes.end(), [](const Integer& size) { return size < 1; })) continue;
                if (std::any_of(sizes.begin(), sizes.end(),
                                [](const Integer& size) { return size > Integer(longest_rule); })) {
                    too_long_ = true;
                    continue;
                }
                for (std::size_t n = 0; n < g.size(); ++n)
                    for (std::size_t i = 0; i < k; ++i) g[n] -= form.coefficients[i] * stages[k - 1 - i][n];
                const std::size_t before = rules_.size();
                rules_.resize(before + k);
                std::optional<Rule> addend = Rule{{}, 0};
                if (!is_last) addend = all_zero(g) ? std::nullopt : staged(g, rest);
                if (addend && set_rules(before, form, sizes, *addend)) return Rule{{before}, f[0] - 1};
                rules_.resize(before);
            }
        }
        return std::nullopt;
    }

    bool set_rules(std::size_t first, const Form& form, const std::vector<Integer>& sizes, const Rule& addend) {
        const std::size_t k = sizes.size();
        for (std::size_t i = 0; i < k; ++i) {
            Rule rule;
            const auto add = [&](std::size_t which, const Integer& times) {
                if (times + Integer(rule.letters.size()) > Integer(longest_rule)) return false;
                rule.letters.insert(rule.letters.end(), static_cast<std::size_t>(times.to_uint64()), first + which);
                rule.filling += times * (sizes[which] - 1);
                return true;
            };
            bool fits = add(i, form.c);
            if (i + 1 < k) {
                fits = fits && add(i + 1, 1);
            } else {
                for (std::size_t j = 0; j < k; ++j) fits = fits && add(k - 1 - j, form.coefficients[j]);
                rule.letters.insert(rule.letters.end(), addend.letters.begin(), addend.letters.end());
                rule.filling += addend.filling;
            }
            if (fillings_stay_) rule.filling -= sizes[i] - 1;
            if (sign(rule.filling) < 0) return false;
            if (!fits || rule.filling > Integer(longest_rule)) {
                too_long_ = true;
                return false;
            }
            rules_[first + i] = std::move(rule);
        }
        return true;
    }

    /// The first forms of multiples of a divisor. Natural c1, ..., ck leave one root above c, and a
    /// simple one, if any is not 0 (Descartes).
    const std::vector<Form>& forms(const std::vector<unsigned>& exponents) {
        const auto [place, is_new] = forms_.try_emplace(exponents);
        if (!is_new) return place->second;
        Polynomial divisor = 1;
        for (std::size_t i = 0; i < exponents.size(); ++i) divisor *= power(powers_[i].factor, exponents[i]);
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
    std::map<std::vector<unsigned>, std::vector<Form>> forms_;
    std::vector<Rule> rules_;
    std::size_t tries_ = 0;
    bool fillings_stay_ = false;
    bool too_long_ = false;
};

/// The draft with first words before it, of which each letter becomes the next one.
std::optional<Draft> after_first_words(Draft draft, const std::vector<Integer>& f, std::size_t count, bool fillings_stay) {
    if (count == 0) return draft;
    const std::size_t shift = count;
    for (Rule& rule : draft.rules)
        for (std::size_t& letter : rule.letters) letter += shift;
    for (std::size_t& letter : draft.axiom.letters) letter += shift;
    std::vector<Rule> rules;
    for (std::size_t i = 0; i < count; ++i) {
        if (f[i] > Integer(longest_rule)) return std::nullopt;
        Rule rule = i + 1 < count ? Rule{{i + 1}, f[i + 1] - 1} : draft.axiom;
        if (fillings_stay) rule.filling -= f[i] - 1;
        if (sign(rule.filling) < 0 || rule.filling > Integer(longest_rule)) return std::nullopt;
        rules.push_back(std::move(rule));
    }
    rules.insert(rules.end(), draft.rules.begin(), draft.rules.end());
    return Draft{{{0}, f[0] - 1}, std::move(rules)};
}

D0L system_of(const Draft& draft, bool fillings_stay) {
    auto alphabet = std::make_shared<Alphabet>();
    std::vector<Word> images;
    const bool many = draft.rules.size() > 23;  // a to w; x fills
    for (std::size_t i = 0; i < draft.rules.size(); ++i)
        alphabet->symbol(many ? "a_" + std::to_string(i + 1) : std::string(1, static_cast<char>('a' + i)));
    std::optional<Symbol> filling;
    const auto word = [&](const Rule& rule) {
        Word letters;
        for (const std::size_t letter : rule.letters) letters.push_back(static_cast<Symbol>(letter));
        if (!rule.filling.is_zero()) {
            if (!filling) filling = alphabet->symbol("x");
            letters.insert(letters.end(), static_cast<std::size_t>(rule.filling.to_uint64()), *filling);
        }
        return letters;
    };
    Word axiom = word(draft.axiom);
    for (const Rule& rule : draft.rules) images.push_back(word(rule));
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
std::optional<std::size_t> verified(const D0L& system, const SequenceSpecification& sequence, const Budget& budget) {
    const std::size_t count = sequence.initial.size() + system.letters.size();
    const auto values = sequence.values(count);
    const auto found = lengths(system, count, budget);
    for (std::size_t n = 0; n < count; ++n)
        if (values[n] != Rational(found[n])) return std::nullopt;
    return count;
}

/// A system for values that are natural numbers, none of them 0 before another.
std::optional<D0L> built(const SequenceSpecification& sequence, const Budget& budget, bool& too_long) {
    const std::size_t order = sequence.coefficients.size(), early = sequence.initial.size() - order;
    std::vector<Integer> f;
    for (const Rational& value : sequence.values(early + most_first_words + 2 * order + 40)) f.push_back(value.numerator());
    std::vector<Integer> characteristic(order + 1, 1);
    for (std::size_t i = 0; i < order; ++i) characteristic[order - 1 - i] = -sequence.coefficients[i].numerator();
    if (order == 0) {  // 0 from some n on: words that become each other, then nothing
        Draft draft{{{0}, f[0] - 1}, {}};
        for (std::size_t i = 0; i < early; ++i) {
            if (f[i] > Integer(longest_rule)) return std::nullopt;
            draft.rules.push_back(i + 1 < early ? Rule{{i + 1}, f[i + 1] - 1} : Rule{{}, 0});
        }
        return system_of(draft, false);
    }
    Search search(Polynomial(characteristic), budget);
    if (!search.is_small()) return std::nullopt;
    std::optional<D0L> erasing;
    std::size_t last = early + most_first_words;
    for (std::size_t first = early; first <= last; ++first) {
        const std::vector<Integer> later(f.begin() + static_cast<std::ptrdiff_t>(first), f.end());
        if (first > 0 && f[first - 1] > Integer(longest_rule)) break;  // so are all systems from here on
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
    too_long = search.was_too_long();
    return erasing;
}

}  // namespace

Realisation realise(const SequenceSpecification& given, const Budget& budget) {
    const SequenceSpecification sequence = reduced(given);
    Realisation result;
    if (given.terms > 0 && given.terms < 2 * given.initial.size()) {
        result.because = "the " + std::to_string(given.terms) + " terms determine no recurrence: their shortest one has order " +
                         std::to_string(given.initial.size()) + " and rests on " +
                         std::to_string(2 * given.initial.size()) + " terms; give more";
        return result;
    }
    const auto values = sequence.values(sequence.initial.size() + 200);
    if (const auto reason = why_impossible(values)) {
        result.kind = Realisation::Kind::impossible;
        result.because = *reason;
        std::size_t shift = 0;  // what is left may be possible
        for (std::size_t n = 0; n < 10; ++n)
            if (!values[n].is_integer() || sign(values[n]) <= 0) shift = n + 1;
        if (shift == 0 || shift == 10 || std::any_of(sequence.coefficients.begin(), sequence.coefficients.end(),
                                                     [](const Rational& c) { return !c.is_integer(); }))
            return result;
        const SequenceSpecification later = shifted(sequence, shift);
        if (why_impossible(later.values(later.initial.size() + 200)) || later.initial.empty()) return result;
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
                         ", has a coefficient that is no integer, so some term is none (Fatou 1906), but none of the "
                         "first " + std::to_string(values.size());
        return result;
    }
    bool too_long = false;
    result.system = built(sequence, budget, too_long);
    const auto compared = result.system ? verified(*result.system, sequence, budget) : std::nullopt;
    if (!compared) {
        result.system.reset();
        result.because = "no product of stages with natural coefficients was found for " + sequence.text() +
                         ", with up to " + std::to_string(most_first_words) + " first words before them" +
                         (too_long ? "; some would have had rules of more than " + std::to_string(longest_rule) + " letters"
                                   : "");
        return result;
    }
    result.kind = Realisation::Kind::found;
    result.compared = *compared;
    result.because = "the lengths equal the sequence on " + std::to_string(*compared) + " terms: " +
                     std::to_string(sequence.initial.size()) + " for the order of its recurrence and " +
                     std::to_string(result.system->letters.size()) +
                     " for the letters, so for all n, because the difference obeys a recurrence of that order";
    return result;
}

}  // namespace algae
