// The growth of words, as a page and as JSON.
//
// The page shows everything that fits: a matrix of at most sixteen letters, polynomials of at most 400
// characters, and how much is left out. JSON is complete. Both show the same analysis, whose numbers are
// exact; decimals are digits of exact numbers.

#include "report/report.hpp"

#include <fmt/format.h>

namespace algae {

namespace {

std::string digits(const std::vector<Integer>& values) {
    return joined(values, ", ", [](const Integer& value) { return to_string(value); });
}

constexpr std::size_t largest_matrix = 16;       // letters of a matrix on the page
constexpr std::size_t longest_polynomial = 400;  // characters of a polynomial on the page
constexpr int rate_digits = 30;
constexpr int share_digits = 10;

/// "(x - 1)^2 (x^2 - x - 1)".
std::string factored(const Factorisation& factors) {
    std::string text;
    for (const auto& [factor, exponent] : factors.powers) {
        if (exponent == 0) continue;
        if (!text.empty()) text += ' ';
        const std::string inner = to_string(factor);
        text += factor == Polynomial({0, 1}) || (factors.powers.size() == 1 && exponent == 1)
                    ? inner
                    : "(" + inner + ")";
        if (exponent > 1) text += "^" + std::to_string(exponent);
    }
    return text.empty() ? "1" : text;
}

class Page {
public:
    Page(const GrowthReport& report, const std::string& elsewhere)
        : system_(report.system), a_(report.analysis), elsewhere_(elsewhere) {}

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
    const std::string& name(std::size_t place) const {
        return system_.alphabet->name(system_.letters[place]);
    }
    void line(const char* label, const std::string& value) {
        out_ += fmt::format("{:<24}{}\n", label, value);
    }

    /// The text, or the beginning of one that is too long.
    std::string shortened(const std::string& text) const {
        if (text.size() <= longest_polynomial) return text;
        return text.substr(0, longest_polynomial) +
               fmt::format("... ({} characters{})", text.size(), elsewhere_);
    }

    void values() {
        std::vector<std::string> lengths;
        for (const Integer& length : a_.lengths) lengths.push_back(readable(length));
        line("lengths, n = 0..10", joined(lengths, ", "));
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
            for (std::size_t i = 0; i < size; ++i)
                width[j] = std::max(width[j], to_string(full(i, j)).size());
        }
        std::string header(names, ' ');
        for (std::size_t j = 0; j < size; ++j) header += fmt::format("  {:>{}}", name(j), width[j]);
        line("growth matrix", header);
        for (std::size_t i = 0; i < size; ++i) {
            std::string row = fmt::format("{:<{}}", name(i), names);
            for (std::size_t j = 0; j < size; ++j)
                row += fmt::format("  {:>{}}", to_string(full(i, j)), width[j]);
            line("", row);
        }
    }

    void polynomials() {
        line("characteristic", shortened(factored(a_.polynomials.characteristic_factors)));
        line("minimal polynomial", shortened(factored(a_.polynomials.minimal_factors)));
    }

    void recurrence() {
        const Recurrence& r = a_.recurrence;
        line("shortest recurrence",
             shortened(r.text()) + fmt::format(", for n >= {}", r.holds_from()));
        if (!r.initial.empty()) line("from", shortened(digits(r.initial)));
        line("generating function", shortened(to_string(a_.generating_function)));
        line("closed form", shortened("a(n) = " + a_.closed_form.text()));
        for (const std::string& roots : root_lines(a_.closed_form)) line("", roots);
        if (!a_.closed_form.exceptions().empty())
            line("before that", shortened(digits(a_.closed_form.exceptions())));
    }

    void growth() {
        const GrowthClass& growth = a_.growth;
        switch (growth.order.kind) {
            case GrowthKind::zero:
                line("growth", fmt::format("zero: the word is empty from generation {} on",
                                           growth.preperiod));
                return;
            case GrowthKind::bounded:
                line("growth",
                     fmt::format("bounded: from generation {} on the length has period {}",
                                 growth.preperiod, to_string(growth.period)));
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
                                 to_string(growth.period)));
    }

    void morphism() {
        const Primitivity& p = a_.primitivity;
        if (p.exponent)
            line("morphism",
                 fmt::format("primitive: h^{} sends every letter to all letters", *p.exponent));
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
            line(
                shown == 1 ? "fixed and periodic" : "",
                point.fixed
                    ? fmt::format("{}({}) = {}", h, a, a)
                    : fmt::format("{}({}) begins with {}: an infinite word that {} leaves as it is",
                                  h, a, a, h));
        }
    }

    void letters() {
        const LetterFrequencies& frequencies = a_.frequencies;
        if (frequencies.limits.size() > 1)
            line("shares of the letters",
                 fmt::format("no limits, but for each n modulo {}, in this order: 0, 1, ...",
                             to_string(frequencies.period)));
        else if (frequencies.limits.empty() && frequencies.period != 1)
            line("shares of the letters",
                 fmt::format("no limits; they have a period of {}", to_string(frequencies.period)));
        if (needs_rate())
            line("where", "r is the rate" + std::string(frequencies.limits.size() > 1
                                                            ? ", to the power of the period"
                                                            : ""));
        for (std::size_t i = 0; i < system_.letters.size(); ++i)
            line(i == 0 ? "fate of the letters" : "",
                 fmt::format("{:<4}{}{}", name(i), fate(i), share(i)));
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
            return fmt::format("mortal: gone after {} {}", *lifetime,
                               *lifetime == 1 ? "step" : "steps");
        const GrowthOrder& order = a_.letters[i];
        if (order.kind == GrowthKind::exponential && order == a_.growth.order &&
            order.rate.degree() > 2)
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
    const std::string& elsewhere_;  // where a shortened text is complete
    std::string out_;
};

Json matrix(const GrowthMatrix& sparse) {
    Json out = Json::array();
    for (const auto& row : sparse.rows) {
        std::vector<Integer> full(sparse.size());
        for (const auto& [column, times] : row) full[column] = times;
        out.add(full);
    }
    return out;
}

Json polynomial(const Polynomial& value, const Factorisation& factors) {
    return {{"coefficients", value.coefficients()}, {"factors", factored(factors)}};
}

Json recurrence(const Recurrence& value) {
    std::vector<Integer> coefficients;  // of a(n-1), a(n-2), ...
    for (std::size_t j = 1; j <= value.order(); ++j)
        coefficients.push_back(-value.polynomial.coefficient(value.order() - j));
    return {{"text", value.text()},
            {"order", value.order()},
            {"coefficients", coefficients},
            {"initial", value.initial},
            {"holds_from", value.holds_from()}};
}

Json rate(const GrowthOrder& order) {
    if (order.kind == GrowthKind::zero) return nullptr;
    return {{"exact", order.rate.exact()},
            {"decimal", order.rate.decimal(rate_digits)},
            {"minimal_polynomial", to_string(order.rate.minimal_polynomial())}};
}

Json letters(const D0L& system, const GrowthAnalysis& analysis) {
    Json out = Json::array();
    for (std::size_t i = 0; i < system.letters.size(); ++i) {
        const GrowthOrder& order = analysis.letters[i];
        Json letter{{"letter", system.alphabet->name(system.letters[i])},
                    {"class", analysis.lifetimes[i] ? "mortal" : to_string(order.kind)},
                    {"degree", order.degree},
                    {"rate", order.kind == GrowthKind::zero ? Json() : Json(order.rate.exact())},
                    {"growing", order.kind == GrowthKind::polynomial ||
                                    order.kind == GrowthKind::exponential}};
        if (analysis.lifetimes[i]) letter.set("lifetime", *analysis.lifetimes[i]);
        std::vector<Json> shares;
        for (const auto& limit : analysis.frequencies.limits) {
            Json share{{"exact", nullptr}, {"decimal", limit[i].decimal(15)}};
            if (limit[i].number()) share.set("exact", limit[i].exact());
            shares.push_back(std::move(share));
        }
        if (shares.size() == 1)
            letter.set("frequency", shares[0]);
        else if (!shares.empty())
            letter.set("frequencies", shares);
        out.add(std::move(letter));
    }
    return out;
}

Json points(const D0L& system, const GrowthAnalysis& analysis) {
    Json out = Json::array();
    for (const Prolongation& point : analysis.prolongations)
        out.add({{"letter", system.alphabet->name(point.letter)},
                 {"power", point.power},
                 {"fixed", point.fixed},
                 {"infinite", point.infinite}});
    return out;
}

std::string rules(const OL& system, const std::vector<std::size_t>& choices) {
    std::string out;
    for (std::size_t i = 0; i < system.letters.size(); ++i) {
        const Symbol a = system.letters[i];
        if (system.successors[a].size() < 2) continue;
        if (!out.empty()) out += "; ";
        out += system.alphabet->name(a) + " -> " +
               spell(*system.alphabet, system.successors[a][choices[i]]);
    }
    return out.empty() ? "every letter has one rule" : out;
}

Json numbers_from(const std::vector<Integer>& values, std::uint64_t first) {
    Json out = Json::array();
    for (std::size_t n = first; n < values.size(); ++n) out.add(values[n]);
    return out;
}

constexpr std::size_t longest_factor = 24;  // letters of the factors that are counted
constexpr std::size_t deepest_formula = 8;
constexpr std::size_t longest_shown = 60;  // letters of a word on the page

std::string word(const D0L& system, const Word& letters) {
    if (letters.size() <= longest_shown) return spell(*system.alphabet, letters);
    return fmt::format(
        "{}... ({} letters)",
        spell(*system.alphabet, Word(letters.begin(), letters.begin() + longest_shown)),
        letters.size());
}

}  // namespace

std::string to_text(const GrowthReport& report, const std::string& elsewhere) {
    return Page(report, elsewhere).text();
}

Json to_json(const GrowthReport& report) {
    const auto& [system, a] = report;
    Json out;
    out.set("lengths", a.lengths);
    out.set("matrix", matrix(a.matrix));
    out.set("characteristic_polynomial",
            polynomial(a.polynomials.characteristic, a.polynomials.characteristic_factors));
    out.set("minimal_polynomial", polynomial(a.polynomials.minimal, a.polynomials.minimal_factors));
    out.set("recurrence", recurrence(a.recurrence));
    out.set("generating_function",
            {{"numerator", a.generating_function.numerator.coefficients()},
             {"denominator", a.generating_function.denominator.coefficients()}});
    out.set("closed_form", a.closed_form.text());
    out.set("exceptions", a.closed_form.exceptions());
    out.set("class", to_string(a.growth.order.kind));
    out.set("degree", a.growth.order.degree);
    out.set("rate", rate(a.growth.order));
    out.set("period", a.growth.period);
    if (a.growth.order.kind == GrowthKind::zero || a.growth.order.kind == GrowthKind::bounded)
        out.set("preperiod", a.growth.preperiod);
    out.set("irreducible", a.primitivity.irreducible);
    out.set("primitive", a.primitivity.exponent.has_value());
    out.set("primitivity_exponent", a.primitivity.exponent);
    out.set("fixed_and_periodic", points(system, a));
    out.set("letters", letters(system, a));
    out.set("frequency_period", a.frequencies.period);
    return out;
}

std::string to_text(const LengthBoundsReport& report) {
    const auto& [system, bounds, first] = report;
    std::string out = "generation  least  greatest\n";
    for (std::uint64_t n = first; n < bounds.least.size(); ++n)
        out += fmt::format("{:<10}  {}  {}\n", n, to_string(bounds.least[n]),
                           to_string(bounds.most[n]));
    out +=
        "least(a, n) is the minimum, greatest(a, n) the maximum, over the rules a -> u of the sums "
        "over the letters of u "
        "at n - 1.\n";
    out += fmt::format("First choice for the least in generation {}:     {}\n",
                       bounds.least.size() - 1, rules(system, bounds.least_choice));
    out += fmt::format("First choice for the greatest in generation {}:  {}\n",
                       bounds.least.size() - 1, rules(system, bounds.most_choice));
    return out;
}

Json to_json(const LengthBoundsReport& report) {
    const auto& [system, bounds, first] = report;
    return {{"from", first},
            {"least", numbers_from(bounds.least, first)},
            {"greatest", numbers_from(bounds.most, first)},
            {"least_choice", rules(system, bounds.least_choice)},
            {"greatest_choice", rules(system, bounds.most_choice)}};
}

FactorReport factor_report(const D0L& rules, const Budget& budget) {
    return {rules,
            factor_complexity(rules, longest_factor, budget),
            generates_infinite_word(rules),
            complexity_order(rules, budget),
            pusher_of(rules, budget),
            infinite_repetitions(rules, budget),
            locally_catenative(rules, deepest_formula, 24, budget)};
}

std::string to_text(const FactorReport& found) {
    const D0L& system = found.system;
    std::string text = fmt::format("factors            {}\n", fmt::join(found.complexity, " "));
    text += fmt::format("                   of 0 to {} letters, in all words{}\n", longest_factor,
                        found.infinite_word ? ", which are beginnings of one infinite word" : "");
    if (found.order.is_decided())
        text += fmt::format("class              {}\n", to_string(found.order.at_least));
    else
        text += fmt::format("class              not decided: at least {}, at most {}\n",
                            to_string(found.order.at_least), to_string(found.order.at_most));
    text += fmt::format("                   {}\n", found.order.because);
    if (found.pusher)
        text +=
            fmt::format("pushy              yes: {0} leads to {1} in {2}, and {3} does not grow\n",
                        system.alphabet->name(found.pusher->letter),
                        found.pusher->left ? word(system, found.pusher->run) + " " +
                                                 system.alphabet->name(found.pusher->letter) + "..."
                                           : "..." + system.alphabet->name(found.pusher->letter) +
                                                 " " + word(system, found.pusher->run),
                        counted(found.pusher->steps, "step"), word(system, found.pusher->run));
    else
        text += "pushy              no: factors of letters that do not grow are bounded\n";
    if (found.repetitions.empty()) {
        text += "repetitive         no: no word has all its powers among the factors\n";
    } else {
        text += "repetitive         yes: all powers of";
        for (std::size_t i = 0; i < found.repetitions.size(); ++i)
            text += (i == 0 ? " " : ", ") + word(system, found.repetitions[i].word);
        text += " are factors\n";
    }
    text += fmt::format("locally catenative {}\n",
                        found.formula.formula
                            ? found.formula.formula->text() + ": " + found.formula.because
                        : found.formula.kind == CatenativeAnswer::Kind::none
                            ? "no: " + found.formula.because
                            : "not found: " + found.formula.because);
    return text;
}

Json to_json(const FactorReport& found) {  // keys in alphabetical order
    const D0L& system = found.system;
    static const char* const kinds[] = {"yes", "no", "unknown"};
    Json catenative;
    if (found.formula.formula) catenative.set("back", found.formula.formula->back);
    catenative.set("because", found.formula.because);
    if (found.formula.formula) catenative.set("from", found.formula.formula->from);
    catenative.set("verdict", kinds[static_cast<std::size_t>(found.formula.kind)]);
    Json pushy;
    if (found.pusher)
        pushy = {{"letter", system.alphabet->name(found.pusher->letter)},
                 {"run", spell(*system.alphabet, found.pusher->run)},
                 {"side", found.pusher->left ? "left" : "right"},
                 {"steps", found.pusher->steps}};
    pushy.set("value", found.pusher.has_value());
    Json repetitions = Json::array();
    for (const InfiniteRepetition& repetition : found.repetitions)
        repetitions.add(
            {{"grows", repetition.grows}, {"word", spell(*system.alphabet, repetition.word)}});
    return {{"complexity_class",
             {{"at_least", to_string(found.order.at_least)},
              {"at_most", to_string(found.order.at_most)},
              {"because", found.order.because},
              {"decided", found.order.is_decided()}}},
            {"factor_complexity", found.complexity},
            {"infinite_word", found.infinite_word},
            {"locally_catenative", catenative},
            {"pushy", pushy},
            {"repetitions", repetitions},
            {"repetitive", !found.repetitions.empty()}};
}

}  // namespace algae
