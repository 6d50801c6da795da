#include "growth/realise.hpp"

#include <algorithm>
#include <memory>

#include "base/error.hpp"
#include "exact/polynomial.hpp"
#include "growth/growth_matrix.hpp"
#include "growth/realise_stages.hpp"

namespace algae {

namespace {

constexpr std::size_t most_first_words = 64;

/// The draft with first words before it, of which each letter becomes the next one.
std::optional<StageDraft> after_first_words(StageDraft draft, const std::vector<Integer>& f, std::size_t count, bool fillings_stay) {
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
        if (sign(rule.filling) < 0 || rule.filling > Integer(longest_stage_rule)) return std::nullopt;
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
        alphabet->symbol(many ? "a_" + std::to_string(i + 1) : std::string(1, static_cast<char>('a' + i)));
    std::optional<Symbol> filling;
    const auto word = [&](const StageRule& rule) {
        Word letters;
        for (const std::size_t letter : rule.letters) letters.push_back(static_cast<Symbol>(letter));
        if (!rule.filling.is_zero()) {
            if (!filling) filling = alphabet->symbol("x");
            letters.insert(letters.end(), static_cast<std::size_t>(rule.filling.to_uint64()), *filling);
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
        StageDraft draft{{{0}, f[0] - 1}, {}};
        for (std::size_t i = 0; i < early; ++i) {
            if (f[i] > Integer(longest_stage_rule)) return std::nullopt;
            draft.rules.push_back(i + 1 < early ? StageRule{{i + 1}, f[i + 1] - 1} : StageRule{{}, 0});
        }
        return system_of(draft, false);
    }
    StageSearch search(Polynomial(characteristic), budget);
    if (!search.is_small()) return std::nullopt;
    std::optional<D0L> erasing;
    std::size_t last = early + most_first_words;
    for (std::size_t first = early; first <= last; ++first) {
        const std::vector<Integer> later(f.begin() + static_cast<std::ptrdiff_t>(first), f.end());
        if (first > 0 && f[first - 1] > Integer(longest_stage_rule)) break;  // so are all systems from here on
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
                         (too_long ? "; some would have had rules of more than " + std::to_string(longest_stage_rule) + " letters"
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
