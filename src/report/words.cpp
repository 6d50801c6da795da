// Combinatorics of one finite word, as a page and as JSON.
//
// The page shows the first entries of long lists and says how many more there are; JSON is complete.

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "render/render.hpp"
#include "report/detail/page.hpp"
#include "report/report.hpp"
#include "watch/watch.hpp"

namespace algae {

namespace {

constexpr std::size_t letters_shown = 60;  // of a word on the page
constexpr std::size_t runs_listed = 1000;  // in JSON

/// Words over letters with names.
class Spelling {
public:
    explicit Spelling(const std::vector<std::string>& letters) {
        for (const std::string& letter : letters) alphabet_.symbol(letter);
    }
    std::string whole(const Word& word) const { return spell(alphabet_, word); }
    std::string whole(const Word& word, const Occurrence& place) const {
        const auto at = word.begin() + static_cast<std::ptrdiff_t>(place.begin);
        return whole(Word(at, at + static_cast<std::ptrdiff_t>(place.length)));
    }
    /// The beginning of a long word.
    std::string some(const Word& word, const Occurrence& place) const {
        if (place.length <= letters_shown) return whole(word, place);
        return whole(word, {place.begin, letters_shown}) +
               fmt::format("... ({} letters)", place.length);
    }
    std::string some(const Word& word) const { return some(word, {0, word.size()}); }

private:
    Alphabet alphabet_;
};

/// The factors of a factorisation of the word that begin at these places.
std::vector<Occurrence> parts(const WordReport& report, const std::vector<std::size_t>& begins) {
    std::vector<Occurrence> found;
    for (std::size_t i = 0; i < begins.size(); ++i) {
        const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : report.word.size();
        found.push_back({begins[i], end - begins[i]});
    }
    return found;
}

/// "balanced: a factor of Sturmian words; a central word".
std::string sturmian_text(const SturmianProperties& found) {
    if (!found.balanced) return "not balanced, so a factor of none";
    std::vector<std::string> all{"balanced: a factor of Sturmian words"};
    if (found.central) all.push_back("central");
    if (found.standard) all.push_back("standard");
    if (found.christoffel) all.push_back("Christoffel");
    return joined(all, ", ");
}

std::optional<Rational> exponent(const WordReport& report) {
    if (report.word.empty()) return std::nullopt;
    return Rational(Integer(report.word.size()), Integer(report.periods.front()));
}

std::uint64_t total(const std::vector<std::uint64_t>& values) {
    std::uint64_t sum = 0;
    for (const std::uint64_t value : values) sum += value;
    return sum;
}

}  // namespace

WordReport word_report(Word word, std::vector<std::string> letters, const Budget& budget) {
    WordReport report;
    report.letters = std::move(letters);
    report.word = std::move(word);
    const Word& w = report.word;
    report.borders = borders(w);
    report.periods = periods(w);
    report.lyndon = lyndon_factorisation(w);
    report.root = primitive_root(w);
    report.conjugate = least_conjugate(w);
    budget.check();
    report.palindromes = palindromic_factors(w, budget);
    report.repetitions = repetitions_in(w, budget);
    report.factors = factor_counts(w, budget);
    report.lempel_ziv = lempel_ziv_factorisation(w, budget);
    report.sturmian = sturmian_properties(w);
    if (w.size() <= WordReport::abelian_letters) report.abelian = abelian_periods(w, budget);
    return report;
}

std::string to_text(const WordReport& report) {
    const Word& word = report.word;
    const Spelling spelling(report.letters);
    const auto shown = [&](const Occurrence& place) { return spelling.some(word, place); };
    std::string page = line("word", spelling.some(word)) + line("length", number(word.size())) +
                       line("order of letters", joined(report.letters, " < "));
    if (word.empty()) return page;
    const PalindromicFactors& palindromes = report.palindromes;
    const WordRepetitions& repetitions = report.repetitions;
    const bool is_primitive = report.root.size() == word.size();
    page += line("periods", some_of(report.periods, ", ", number));
    page += line("borders", report.borders.empty()
                                ? "none: the word is unbordered"
                                : some_of(report.borders, ", ", [&](std::size_t length) {
                                      return shown({0, length});
                                  }));
    page += line("exponent", to_string(*exponent(report)));
    page += line("primitive root", is_primitive
                                       ? "the word itself"
                                       : fmt::format("{}, {} times", spelling.some(report.root),
                                                     word.size() / report.root.size()));
    page += line("least conjugate",
                 fmt::format("{}, of {}", spelling.some(report.conjugate), report.root.size()));
    page += line("Lyndon factorisation", some_of(parts(report, report.lyndon), " | ", shown));
    page +=
        line("Lempel-Ziv", fmt::format("{}: {}", report.lempel_ziv.size(),
                                       some_of(parts(report, report.lempel_ziv), " | ", shown)));
    if (report.sturmian) page += line("Sturmian words", sturmian_text(*report.sturmian));
    page +=
        line("palindromes", fmt::format("{} and the empty one; the longest: {}", palindromes.count,
                                        some_of(palindromes.longest, ", ", shown)));
    page += line("defect",
                 palindromes.defect == 0 ? "0: the word is rich" : number(palindromes.defect));
    page += line("palindromic length", fmt::format("{}: {}", palindromes.fewest.size(),
                                                   some_of(palindromes.fewest, " | ", shown)));
    page += line("runs", repetitions.runs.empty()
                             ? "none: the word is square-free"
                             : fmt::format("{}: {}", repetitions.runs.size(),
                                           some_of(repetitions.runs, ", ", [&](const Run& run) {
                                               return fmt::format(
                                                   "{} at {} with period {}",
                                                   shown({run.begin, run.end - run.begin}),
                                                   run.begin, run.period);
                                           })));
    page += line("distinct squares", number(repetitions.distinct_squares));
    if (repetitions.greatest_exponent)
        page +=
            line("greatest exponent", to_string(*repetitions.greatest_exponent) + " of a factor");
    page += line("distinct factors",
                 fmt::format("{}, the empty one among them", total(report.factors)));
    page += line("  of 0, 1, ... letters", some_of(report.factors, ", ", number));
    if (report.abelian)
        page += line(
            "Abelian periods", some_of(*report.abelian, ", ", [](const AbelianPeriod& one) {
                return one.head == 0
                           ? number(one.period)
                           : fmt::format("{} after {}", one.period, counted(one.head, "letter"));
            }));
    return page;
}

namespace {

/// The first entries of a long list, as LaTeX mathematics.
template <class Things, class Text>
std::string latex_of(const Things& things, const char* between, Text text) {
    return first_of(things, between, text, "\\dots");
}

}  // namespace

std::string to_latex(const WordReport& report) {
    Alphabet alphabet;
    for (const std::string& letter : report.letters) alphabet.symbol(letter);
    const Word& word = report.word;
    const auto part = [&](const Occurrence& place) {
        const auto at = word.begin() + static_cast<std::ptrdiff_t>(place.begin);
        return word_latex(alphabet, Word(at, at + static_cast<std::ptrdiff_t>(place.length)));
    };
    std::vector<std::pair<std::string, std::string>> rows{{"word", word_latex(alphabet, word)},
                                                          {"length", number(word.size())}};
    if (!word.empty()) {
        rows.insert(
            rows.end(),
            {{"periods", latex_of(report.periods, ", ", number)},
             {"borders", latex_of(report.borders, ", ",
                                  [&](std::size_t length) {
                                      return part({0, length});
                                  })},
             {"exponent", formula_latex(to_string(*exponent(report)))},
             {"primitive root", word_latex(alphabet, report.root)},
             {"least conjugate", word_latex(alphabet, report.conjugate)},
             {"Lyndon factorisation", latex_of(parts(report, report.lyndon), " \\mid ", part)},
             {"palindromes but the empty one", number(report.palindromes.count)},
             {"defect", number(report.palindromes.defect)},
             {"palindromic factorisation", latex_of(report.palindromes.fewest, " \\mid ", part)},
             {"runs", number(report.repetitions.runs.size())},
             {"distinct squares", number(report.repetitions.distinct_squares)},
             {"distinct factors", number(total(report.factors))}});
        if (report.repetitions.greatest_exponent)
            rows.emplace_back("greatest exponent of a factor",
                              formula_latex(to_string(*report.repetitions.greatest_exponent)));
    }
    std::string text = "\\begin{tabular}{ll}\n";
    for (const auto& [name, value] : rows)
        text += "  " + name + " & " + (value.empty() ? "---" : "$" + value + "$") + " \\\\\n";
    return text + "\\end{tabular}\n";
}

Json to_json(const WordReport& report) {
    const Word& word = report.word;
    const Spelling spelling(report.letters);
    const auto words = [&](const std::vector<Occurrence>& places) {
        Json all = Json::array();
        for (const Occurrence& place : places) all.add(spelling.whole(word, place));
        return all;
    };
    Json runs = Json::array();
    for (std::size_t i = 0; i < std::min(runs_listed, report.repetitions.runs.size()); ++i) {
        const Run& run = report.repetitions.runs[i];
        runs.add(
            {{"begin", run.begin},
             {"end", run.end},
             {"period", run.period},
             {"exponent", to_string(Rational(Integer(run.end - run.begin), Integer(run.period)))}});
    }
    Json abelian;
    if (report.abelian) {
        abelian = Json::array();
        for (const AbelianPeriod& one : *report.abelian)
            abelian.add(Json{{"head", one.head}, {"period", one.period}});
    }
    const auto sturmian = [&](bool SturmianProperties::*property) {
        return report.sturmian ? Json((*report.sturmian).*property) : Json();
    };
    const auto text = [](const std::optional<Rational>& value) {
        return value ? Json(to_string(*value)) : Json();
    };
    return {{"length", word.size()},
            {"letters", report.letters},
            {"periods", report.periods},
            {"borders", report.borders},
            {"primitive_root", spelling.whole(report.root)},
            {"primitive", !word.empty() && report.root.size() == word.size()},
            {"exponent", text(exponent(report))},
            {"least_conjugate", spelling.whole(report.conjugate)},
            {"conjugates", word.empty() ? 1 : report.root.size()},
            {"lyndon_factorisation", words(parts(report, report.lyndon))},
            {"lempel_ziv_factorisation", words(parts(report, report.lempel_ziv))},
            {"balanced", sturmian(&SturmianProperties::balanced)},
            {"central", sturmian(&SturmianProperties::central)},
            {"standard", sturmian(&SturmianProperties::standard)},
            {"christoffel", sturmian(&SturmianProperties::christoffel)},
            {"palindromes", report.palindromes.count},
            {"longest_palindromes", words(report.palindromes.longest)},
            {"defect", report.palindromes.defect},
            {"palindromic_length", report.palindromes.fewest.size()},
            {"palindromic_factorisation", words(report.palindromes.fewest)},
            {"runs", report.repetitions.runs.size()},
            {"first_runs", std::move(runs)},
            {"greatest_exponent", text(report.repetitions.greatest_exponent)},
            {"distinct_squares", report.repetitions.distinct_squares},
            {"distinct_factors", total(report.factors)},
            {"factors_by_length", report.factors},
            {"abelian_periods", std::move(abelian)}};
}

}  // namespace algae
