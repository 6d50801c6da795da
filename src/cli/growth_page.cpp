#include <fmt/format.h>

#include "cli/growth_report.hpp"
#include "cli/numbers.hpp"

namespace algae::cli {

namespace {

constexpr std::size_t largest_matrix = 16;      // letters whose matrix is read aloud
constexpr std::size_t longest_polynomial = 400;  // characters of a polynomial on the page
constexpr int rate_digits = 30;
constexpr int share_digits = 10;

/// A text that still can be read; of a longer one its beginning.
std::string shortened(const std::string& text) {
    if (text.size() <= longest_polynomial) return text;
    return text.substr(0, longest_polynomial) + fmt::format("... ({} characters, all in --json)", text.size());
}

class Page {
public:
    Page(const D0L& system, const GrowthAnalysis& analysis) : system_(system), a_(analysis) {}

    std::string text() {
        values();
        matrix();
        polynomials();
        recurrence();
        growth();
        morphism();
        letters();
        return std::move(out_);
    }

private:
    const std::string& name(std::size_t place) const { return system_.alphabet->name(system_.letters[place]); }
    void line(const char* label, const std::string& value) { out_ += fmt::format("{:<24}{}\n", label, value); }

    void values() {
        std::vector<std::string> lengths;
        for (const Integer& length : a_.lengths) lengths.push_back(readable(length));
        line("lengths, n = 0..10", fmt::format("{}", fmt::join(lengths, ", ")));
    }

    void matrix() {
        const std::size_t size = a_.matrix.size();
        line("letters", fmt::format("{}", size));
        if (size == 0 || size > largest_matrix) return;
        const IntegerMatrix full = dense(a_.matrix);
        std::vector<std::size_t> width(size);
        std::size_t names = 0;
        for (std::size_t j = 0; j < size; ++j) {
            names = std::max(names, name(j).size());
            width[j] = name(j).size();
            for (std::size_t i = 0; i < size; ++i) width[j] = std::max(width[j], algae::to_string(full(i, j)).size());
        }
        std::string header(names, ' ');
        for (std::size_t j = 0; j < size; ++j) header += fmt::format("  {:>{}}", name(j), width[j]);
        line("growth matrix", header);
        for (std::size_t i = 0; i < size; ++i) {
            std::string row = fmt::format("{:<{}}", name(i), names);
            for (std::size_t j = 0; j < size; ++j) row += fmt::format("  {:>{}}", algae::to_string(full(i, j)), width[j]);
            line("", row);
        }
    }

    void polynomials() {
        line("characteristic", shortened(factored(a_.polynomials.characteristic_factors)));
        line("minimal polynomial", shortened(factored(a_.polynomials.minimal_factors)));
    }

    void recurrence() {
        const Recurrence& r = a_.recurrence;
        line("shortest recurrence", shortened(r.text()) + fmt::format(", for n >= {}", r.holds_from()));
        if (!r.initial.empty()) {
            std::vector<std::string> first;
            for (const Integer& value : r.initial) first.push_back(algae::to_string(value));
            line("from", shortened(fmt::format("{}", fmt::join(first, ", "))));
        }
        line("generating function", shortened(algae::to_string(a_.generating_function)));
        line("closed form", shortened("a(n) = " + a_.closed_form.text()));
        for (const std::string& roots : root_lines(a_.closed_form)) line("", roots);
        if (!a_.closed_form.exceptions().empty()) {
            std::vector<std::string> first;
            for (const Integer& value : a_.closed_form.exceptions()) first.push_back(algae::to_string(value));
            line("before that", shortened(fmt::format("{}", fmt::join(first, ", "))));
        }
    }

    void growth() {
        const GrowthClass& growth = a_.growth;
        switch (growth.order.kind) {
            case GrowthKind::zero:
                line("growth", fmt::format("zero: the word is empty from generation {} on", growth.preperiod));
                return;
            case GrowthKind::bounded:
                line("growth", fmt::format("bounded: from generation {} on the length has period {}", growth.preperiod,
                                           algae::to_string(growth.period)));
                return;
            case GrowthKind::polynomial:
                line("growth", fmt::format("polynomial of degree {}", growth.order.degree));
                break;
            case GrowthKind::exponential:
                line("growth", "exponential: like " + shortened(growth.order.text()));
                line("rate", shortened(growth.order.rate.exact()));
                if (!growth.order.rate.integer()) line("", growth.order.rate.decimal(rate_digits));
                break;
        }
        if (growth.period != 1)
            line("", fmt::format("the quotient by it has no limit, but one for each n modulo {}",
                                 algae::to_string(growth.period)));
    }

    void morphism() {
        const Primitivity& p = a_.primitivity;
        if (p.exponent)
            line("morphism", fmt::format("primitive: h^{} sends every letter to all letters", *p.exponent));
        else if (p.irreducible)
            line("morphism", "irreducible, not primitive");
        else
            line("morphism", "not irreducible");
        std::size_t shown = 0;
        for (const Prolongation& point : a_.prolongations) {
            if (!point.infinite && !point.fixed) continue;
            const std::string& a = system_.alphabet->name(point.letter);
            const std::string h = point.power == 1 ? "h" : fmt::format("h^{}", point.power);
            if (++shown > largest_matrix) break;
            line(shown == 1 ? "fixed and periodic" : "",
                 point.fixed ? fmt::format("{}({}) = {}", h, a, a)
                             : fmt::format("{}({}) begins with {}: an infinite word that {} leaves as it is", h, a, a, h));
        }
    }

    void letters() {
        const LetterFrequencies& frequencies = a_.frequencies;
        if (frequencies.limits.size() > 1)
            line("shares of the letters", fmt::format("no limits, but for each n modulo {}, in this order: 0, 1, ...",
                                                      algae::to_string(frequencies.period)));
        else if (frequencies.limits.empty() && frequencies.period != 1)
            line("shares of the letters", fmt::format("no limits; they have a period of {}",
                                                      algae::to_string(frequencies.period)));
        if (needs_rate()) line("where", "r is the rate" + std::string(frequencies.limits.size() > 1 ? ", to the power of the period" : ""));
        for (std::size_t i = 0; i < system_.letters.size(); ++i)
            line(i == 0 ? "fate of the letters" : "", fmt::format("{:<4}{}{}", name(i), fate(i), share(i)));
    }

    bool needs_rate() const {
        for (const auto& limit : a_.frequencies.limits)
            for (const Frequency& frequency : limit)
                if (frequency.number() && frequency.exact().find('r') != std::string::npos &&
                    frequency.exact().find("sqrt") == std::string::npos)
                    return true;
        return false;
    }

    std::string fate(std::size_t i) const {
        if (const auto& lifetime = a_.lifetimes[i])
            return fmt::format("mortal: gone after {} {}", *lifetime, *lifetime == 1 ? "step" : "steps");
        const GrowthOrder& order = a_.letters[i];
        if (order.kind == GrowthKind::exponential && order == a_.growth.order && order.rate.degree() > 2)
            return order.degree == 0 ? "exponential, with the rate above" : "exponential, as above";
        if (order.kind == GrowthKind::bounded) return "bounded";
        return to_string(order.kind) + ": " + shortened(order.text());
    }

    std::string share(std::size_t i) const {
        std::vector<std::string> shares;
        for (const auto& limit : a_.frequencies.limits) {
            const Frequency& frequency = limit[i];
            const bool rational = frequency.number() && frequency.number()->numerator.degree() < 1;
            const std::string exact = frequency.exact();
            if (rational && exact.find('/') == std::string::npos)
                shares.push_back(exact);
            else if (frequency.number())
                shares.push_back(fmt::format("{} = {}", exact, frequency.decimal(share_digits)));
            else
                shares.push_back(frequency.decimal(share_digits));
        }
        return shares.empty() ? "" : fmt::format("; share {}", fmt::join(shares, " | "));
    }

    const D0L& system_;
    const GrowthAnalysis& a_;
    std::string out_;
};

}  // namespace

std::string factored(const Factorisation& factors) {
    std::string text;
    for (const auto& [factor, exponent] : factors.powers) {
        if (exponent == 0) continue;
        if (!text.empty()) text += ' ';
        const std::string inner = algae::to_string(factor);
        text += factor == Polynomial({0, 1}) || (factors.powers.size() == 1 && exponent == 1) ? inner : "(" + inner + ")";
        if (exponent > 1) text += "^" + std::to_string(exponent);
    }
    return text.empty() ? "1" : text;
}

std::string rate_decimal(const GrowthOrder& order) { return order.rate.decimal(rate_digits); }

std::string growth_page(const D0L& system, const GrowthAnalysis& analysis) { return Page(system, analysis).text(); }

}  // namespace algae::cli
