// Answers as LaTeX, to stand in a document that loads amsmath: formulas, matrices, derivations, dimensions, systems.
//
// Formulas come from the rooms below as text, "((5+3*sqrt(5))/10)*((1+sqrt(5))/2)^n". A reader of a hundred lines reads this language of
// theirs and sets it: quotients as fractions, powers and roots as such, products without a sign where none is needed. What it
// cannot read is set as it stands, in \text, so that nothing is lost and nothing is guessed.

#include <algorithm>
#include <cctype>
#include <optional>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "report/report.hpp"

namespace algae {

namespace {

/// A part of a formula: as LaTeX, how tightly it holds together, and without the brackets around it.
struct Part {
    enum Strength { sum, product, power, atom };
    std::string text;
    Strength strength = atom;
    std::string bare = {};  // what is in the brackets, if it has some
    Strength bare_strength = atom;

    std::string within(Strength least) const {
        return strength < least ? "\\left(" + text + "\\right)" : text;
    }
    /// In a place that holds together by itself, such as above a line.
    const std::string& loose() const { return bare.empty() ? text : bare; }
};

struct NotRead {};

/// Reads and sets a formula.
class Setter {
public:
    explicit Setter(std::string_view text) : text_(text) {}

    std::string all() {
        std::string out = sum().text;
        // "a(n) = ..., for n >= 2"
        while (true) {
            if (takes("="))
                out += " = " + sum().text;
            else if (takes(", for "))
                out += " \\quad\\text{for } " + sum().text;
            else if (takes(">="))
                out += " \\ge " + sum().text;
            else if (takes(", "))
                out += ",\\ " + sum().text;
            else
                break;
        }
        blanks();
        if (at_ != text_.size()) throw NotRead();
        return out;
    }

private:
    void blanks() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }
    char next() {
        blanks();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool takes(std::string_view word) {
        if (!word.starts_with(' ') && !word.starts_with(',')) blanks();
        if (!text_.substr(at_).starts_with(word)) return false;
        at_ += word.size();
        return true;
    }
    void needs(std::string_view word) {
        if (!takes(word)) throw NotRead();
    }

    Part sum() {
        Part left = product();
        while (next() == '+' || next() == '-') {
            const char sign = text_[at_++];
            const Part right = product();
            left = {left.text + (sign == '+' ? " + " : " - ") +
                        (sign == '-' ? right.within(Part::product) : right.text),
                    Part::sum};
        }
        return left;
    }
    Part product() {
        Part left = factor();
        while (true) {
            const char sign = next();
            if (sign == '/') {
                ++at_;
                const Part right = factor();
                left = {"\\frac{" + left.loose() + "}{" + right.loose() + "}", Part::product};
                continue;
            }
            if (sign == '*')
                ++at_;
            else if (!begins_factor(sign))
                return left;
            const Part right = factor();
            const std::string text = right.within(Part::power);
            const bool digits = std::isdigit(static_cast<unsigned char>(text.front())) != 0;
            left = {left.within(Part::product) + (digits ? "\\cdot " : " ") + text, Part::product};
        }
    }
    bool begins_factor(char c) const {
        if (c == '(') return true;
        const auto letter = static_cast<unsigned char>(c);
        if (!std::isalnum(letter)) return false;
        // Words that end a part.
        for (const char* word : {"of ", "for ", "over ", "in "})
            if (text_.substr(at_).starts_with(word)) return false;
        return true;
    }
    Part factor() {
        if (next() == '-') {
            ++at_;
            return {"-" + factor().within(Part::product), Part::sum};
        }
        Part base = atom();
        if (next() != '^') return base;
        ++at_;
        const Part exponent = next() == '-' ? factor() : atom();
        return {base.within(Part::atom) + "^{" + exponent.loose() + "}", Part::power};
    }
    Part atom() {
        if (takes("sum over the roots ")) {
            const std::string root = name();
            needs("of ");
            const Part polynomial = sum();
            needs("of ");
            const Part term = product();
            return {"\\sum_{" + root + ":\\, " + polynomial.text + " = 0} " + term.text, Part::sum};
        }
        if (takes("the largest real root of "))
            return {"\\max\\{r \\in \\mathbb{R} : " + in_root() + " = 0\\}"};
        if (takes("sqrt(")) {
            const Part inside = sum();
            needs(")");
            return {"\\sqrt{" + inside.text + "}"};
        }
        if (takes("sqrt ")) return {"\\sqrt{" + atom().loose() + "}"};
        if (takes("log ")) return {"\\log " + factor().text, Part::power};
        if (takes("log(")) {
            const Part inside = sum();
            needs(")");
            return {"\\log\\left(" + inside.text + "\\right)", Part::power};
        }
        const char c = next();
        if (c == '(') {
            ++at_;
            const Part inside = sum();
            needs(")");
            return {"\\left(" + inside.text + "\\right)", Part::atom, inside.text, inside.strength};
        }
        if (std::isdigit(static_cast<unsigned char>(c))) {
            std::string digits;
            while (at_ < text_.size() &&
                   (std::isdigit(static_cast<unsigned char>(text_[at_])) || text_[at_] == '.'))
                digits += text_[at_++];
            if (text_.substr(at_).starts_with("…")) {
                at_ += 3;
                digits += "\\dots";
            }
            return {digits};
        }
        std::string called = name();
        // a(n-1) is a value of a sequence.
        if (called.size() == 1 && at_ < text_.size() && text_[at_] == '(' &&
            std::string_view("afgwh").find(called[0]) != std::string_view::npos) {
            ++at_;
            const Part inside = sum();
            needs(")");
            return {called + "(" + inside.text + ")"};
        }
        return {called};
    }
    /// A polynomial, whose letters become r.
    std::string in_root() {
        std::string text = sum().text;
        std::ranges::replace(text, 'x', 'r');
        return text;
    }
    std::string name() {
        blanks();
        std::string found;
        while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])))
            found += text_[at_++];
        if (found.empty() || found.size() > 1) throw NotRead();
        return found;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

constexpr std::size_t longest_word = 150;  // letters that a line of a derivation shows

std::string five_digits(double value) { return rounded_decimal(value, 5); }

std::string digits_latex(const std::vector<Integer>& values) {
    return joined(values, ", ", [](const Integer& value) { return readable(value); });
}

std::string factored_latex(const Factorisation& factors) {
    std::string text;
    for (const auto& [factor, exponent] : factors.powers) {
        if (exponent == 0) continue;
        const std::string inner = formula_latex(to_string(factor));
        const bool alone =
            factor == Polynomial({0, 1}) || (factors.powers.size() == 1 && exponent == 1);
        text += alone ? inner : "(" + inner + ")";
        if (exponent > 1) text += "^{" + std::to_string(exponent) + "}";
    }
    return text.empty() ? "1" : text;
}

/// A line of an `align*`.
std::string row(const std::string& left, const std::string& right, bool last = false) {
    return "  " + left + " &= " + right + (last ? "\n" : " \\\\\n");
}

std::string growth_text(const GrowthClass& growth) {
    switch (growth.order.kind) {
        case GrowthKind::zero:
            return "The word is empty from generation " + std::to_string(growth.preperiod) + " on.";
        case GrowthKind::bounded:
            return "The lengths are bounded, with period " + to_string(growth.period) +
                   " from generation " + std::to_string(growth.preperiod) + " on.";
        case GrowthKind::polynomial:
            return "The lengths grow like $n^{" + std::to_string(growth.order.degree) + "}$.";
        case GrowthKind::exponential: {
            std::string text = "The lengths grow exponentially, with the rate $" +
                               formula_latex(growth.order.rate.exact()) + "$";
            if (!growth.order.rate.integer())
                text += " $= " + growth.order.rate.decimal(10) + "\\dots$";
            return text + ".";
        }
    }
    return "";
}

}  // namespace

std::string formula_latex(std::string_view text) {
    try {
        return Setter(text).all();
    } catch (const NotRead&) {
        return "\\text{" + escaped_latex(text) + "}";
    }
}

std::string word_latex(const Alphabet& alphabet, const Word& word) {
    if (word.empty()) return "\\varepsilon";
    std::string text;
    bool blank = false;
    const auto end =
        word.begin() + static_cast<std::ptrdiff_t>(std::min(word.size(), longest_word));
    const bool spaced = std::any_of(word.begin(), end, [&](Symbol letter) {
        const std::string& name = alphabet.name(letter);
        return name.size() > 1 && name.find('_') == std::string::npos &&
               static_cast<unsigned char>(name[0]) < 0x80;
    });
    for (auto it = word.begin(); it != end; ++it) {
        // A line may be broken between letters.
        if (blank) text += spaced ? "\\;\\allowbreak " : "\\allowbreak ";
        text += letter_latex(alphabet.name(*it));
        blank = true;
    }
    if (word.size() > longest_word)
        text += "\\dots\\ \\text{(" + std::to_string(word.size()) + " letters)}";
    return text;
}

std::string derivation_latex(const std::vector<Word>& words, const Alphabet& alphabet) {
    std::string text = "\\begin{align*}\n";
    for (std::size_t i = 0; i < words.size(); ++i)
        text += std::string("  ") + (i == 0 ? "" : "&\\Longrightarrow ") + (i == 0 ? "&" : "") +
                word_latex(alphabet, words[i]) + (i + 1 < words.size() ? " \\\\\n" : "\n");
    return text + "\\end{align*}\n";
}

std::string to_latex(const GrowthReport& report, GrowthPart part) {
    const GrowthAnalysis& a = report.analysis;
    const auto name = [&](std::size_t i) {
        return letter_latex(report.system.alphabet->name(report.system.letters[i]));
    };
    const auto matrix = [&] {
        const std::size_t size = a.matrix.size();
        if (size == 0) return std::string("()");
        const IntegerMatrix full = dense(a.matrix);
        std::string text = "\\begin{array}{c|" + std::string(size, 'c') + "}\n ";
        for (std::size_t j = 0; j < size; ++j) text += " & " + name(j);
        text += " \\\\ \\hline\n";
        for (std::size_t i = 0; i < size; ++i) {
            text += "  " + name(i);
            for (std::size_t j = 0; j < size; ++j) text += " & " + to_string(full(i, j));
            text += i + 1 < size ? " \\\\\n" : "\n";
        }
        return text + "\\end{array}";
    };
    const auto recurrence = [&] {
        return formula_latex(a.recurrence.text()) + " \\quad (n \\ge " +
               std::to_string(a.recurrence.holds_from()) + ")";
    };
    const auto form = [&] { return "a(n) = " + formula_latex(a.closed_form.text()); };
    switch (part) {
        case GrowthPart::matrix:
            return matrix() + "\n";
        case GrowthPart::recurrence:
            return recurrence() + "\n";
        case GrowthPart::function:
            return formula_latex(to_string(a.generating_function)) + "\n";
        case GrowthPart::form:
            return form() + "\n";
        case GrowthPart::rate:
            return a.growth.order.kind == GrowthKind::zero
                       ? "0\n"
                       : formula_latex(a.growth.order.rate.exact()) + "\n";
        case GrowthPart::lengths:
            return digits_latex(a.lengths) + ", \\dots\n";
        case GrowthPart::all:
            break;
    }
    std::string text = "\\[\n" + matrix() + "\n\\]\n\\begin{align*}\n";
    text += row("\\text{lengths}", digits_latex(a.lengths) + ", \\dots");
    text += row("\\chi(x)", factored_latex(a.polynomials.characteristic_factors));
    text += row("\\mu(x)", factored_latex(a.polynomials.minimal_factors));
    const std::string rule = recurrence();
    const std::size_t equals = rule.find(" = ");
    text += equals == std::string::npos ? "  &" + rule + " \\\\\n"
                                        : row(rule.substr(0, equals), rule.substr(equals + 3));
    if (!a.recurrence.initial.empty())
        text += row("a(0), \\dots", digits_latex(a.recurrence.initial));
    text += row("\\sum_{n \\ge 0} a(n)\\, x^n", formula_latex(to_string(a.generating_function)));
    text += row("a(n)", formula_latex(a.closed_form.text()), true);
    return text + "\\end{align*}\n" + growth_text(a.growth) + "\n";
}

std::string to_latex(const DimensionReport& report) {
    std::string text;
    const auto line = [](const std::string& what, const DimensionFormula& dimension) {
        std::string set = "$" + formula_latex(dimension.text()) + "$";
        if (dimension.ratio_sum())
            set = "$" + dimension.decimal(10) + "\\dots$, the $s$ with $" +
                  formula_latex(dimension.text()) + "$";
        else if (!dimension.rational())
            set += " $= " + dimension.decimal(10) + "\\dots$";
        return what + " " + set;
    };
    if (report.exact) {
        const ExactDimension& exact = *report.exact;
        const auto conditions = [&] {
            std::string all;
            for (const std::string& condition : exact.conditions)
                all += (all.empty() ? " (" : "; ") + escaped_latex(condition);
            return all.empty() ? all : all + ")";
        };
        if (exact.status == ExactDimension::Status::exact)
            text += line(exact.almost_surely ? "With probability $1$ the dimension is"
                                             : "The dimension is exactly",
                         *exact.value) +
                    conditions() + ".\n";
        else if (exact.status == ExactDimension::Status::upper_bound)
            text += line(exact.almost_surely ? "With probability $1$ the dimension is at most"
                                             : "The dimension is at most",
                         *exact.value) +
                    conditions() + ".\n";
        else
            text += "The rules give no formula for the dimension" + conditions() + ".\n";
        if (exact.boundary) text += line("The boundary has dimension", *exact.boundary) + ".\n";
        if (exact.others)
            text += line("The box and the packing dimension are", exact.others->box) +
                    line(", Assouad's", exact.others->assouad) +
                    line(", the lower one", exact.others->lower) + "; the Hausdorff measure is " +
                    exact.others->measure + ".\n";
    }
    if (const auto& estimate = report.fit.estimate)
        text += "Counting boxes gives $" + five_digits(estimate->value) + "$, expected between $" +
                five_digits(estimate->low) + "$ and $" + five_digits(estimate->high) + "$.\n";
    return text;
}

std::string to_latex(const std::vector<DimensionRow>& rows) {
    std::string text = "\\begin{tabular}{llll}\n  system & dimension & & boundary \\\\ \\hline\n";
    for (const DimensionRow& one : rows) {
        const ExactDimension& exact = one.exact;
        const bool known = exact.value && (exact.status == ExactDimension::Status::exact ||
                                           exact.status == ExactDimension::Status::upper_bound);
        const std::string bound =
            exact.status == ExactDimension::Status::upper_bound ? "\\le " : "";
        text += "  " + escaped_latex(one.title.empty() ? one.name : one.title) + " & " +
                (known ? "$" + bound + formula_latex(exact.value->text()) + "$" +
                             (exact.almost_surely ? ", almost surely" : "")
                       : "---") +
                " & " + (known ? "$" + exact.value->decimal(5) + "$" : "") + " & " +
                (exact.boundary ? "$" + exact.boundary->decimal(5) + "$" : "") + " \\\\\n";
    }
    return text + "\\end{tabular}\n";
}

std::string to_latex(const Model& system) {
    std::string text = "\\begin{array}{r@{}c@{}l}\n";
    text += "  \\text{axiom} && " + letter_latex(print_word(system.alphabet, system.axiom));
    const auto trimmed = [](std::string part) {
        part.erase(0, std::min(part.find_first_not_of(' '), part.size()));
        part.erase(part.find_last_not_of(' ') + 1);
        return letter_latex(part);
    };
    std::size_t table = 0;
    for (const Production& rule : system.rules) {
        if (!system.tables.empty() && (&rule == &system.rules.front() || rule.table != table)) {
            table = rule.table;
            text += " \\\\\n  \\text{table " + escaped_latex(system.tables[table]) + "} &&";
        }
        const std::string line = print_rule(system.alphabet, rule);
        // A probability stands in the arrow: F -(1/3)-> FF.
        const std::size_t share = line.find(" -("), end = line.find(")-> ");
        text += " \\\\\n  ";
        if (share != std::string::npos && end != std::string::npos && share < end) {
            text += trimmed(line.substr(0, share)) + " &\\xrightarrow{" +
                    formula_latex(line.substr(share + 3, end - share - 3)) + "}& " +
                    trimmed(line.substr(end + 4));
            continue;
        }
        const std::size_t arrow = line.find("->");
        text += trimmed(line.substr(0, arrow)) + " &\\to& " + trimmed(line.substr(arrow + 2));
    }
    return text + "\n\\end{array}\n";
}

}  // namespace algae
