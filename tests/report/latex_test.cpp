// Formulas as LaTeX have the value of the formula, and messages fall into their parts.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <string>

#include "exact/exact.hpp"
#include "report/report.hpp"

using namespace algae;

namespace {

/// The value of LaTeX mathematics in numbers, read by a reader that shares nothing with the one that sets it.
class LatexValue {
public:
    explicit LatexValue(std::string text) : text_(std::move(text)) {}
    double all() {
        const double value = sum();
        blanks();
        if (at_ != text_.size()) throw std::runtime_error("not read: " + text_.substr(at_));
        return value;
    }

private:
    void blanks() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }
    bool takes(const std::string& word) {
        blanks();
        if (text_.compare(at_, word.size(), word) != 0) return false;
        at_ += word.size();
        return true;
    }
    void needs(const std::string& word) {
        if (!takes(word)) throw std::runtime_error("expected " + word + " in " + text_);
    }
    double sum() {
        double value = takes("-") ? -product() : product();
        while (true) {
            if (takes("+"))
                value += product();
            else if (takes("-"))
                value -= product();
            else
                return value;
        }
    }
    double product() {
        double value = power();
        while (true) {
            takes("\\cdot");
            blanks();
            const bool more =
                at_ < text_.size() &&
                (std::isdigit(static_cast<unsigned char>(text_[at_])) ||
                 text_.compare(at_, 5, "\\left") == 0 || text_.compare(at_, 5, "\\frac") == 0 ||
                 text_.compare(at_, 5, "\\sqrt") == 0);
            if (!more) return value;
            value *= power();
        }
    }
    double power() {
        const double base = atom();
        if (!takes("^{")) return base;
        const double exponent = sum();
        needs("}");
        return std::pow(base, exponent);
    }
    double atom() {
        if (takes("\\frac{")) {
            const double above = sum();
            needs("}{");
            const double below = sum();
            needs("}");
            return above / below;
        }
        if (takes("\\sqrt{")) {
            const double inside = sum();
            needs("}");
            return std::sqrt(inside);
        }
        if (takes("\\left(")) {
            const double inside = sum();
            needs("\\right)");
            return inside;
        }
        blanks();
        std::size_t used = 0;
        const double value = std::stod(text_.substr(at_), &used);
        at_ += used;
        return value;
    }

    std::string text_;
    std::size_t at_ = 0;
};

struct Formula {
    std::string text;
    double value;
};

/// A formula as the rooms below write them.
Formula any_formula(int depth) {
    if (depth == 0) {
        const int number = *rc::gen::inRange(1, 12);
        return {std::to_string(number), static_cast<double>(number)};
    }
    const Formula a = any_formula(depth - 1), b = any_formula(depth - 1);
    const int power = *rc::gen::inRange(0, 4);
    switch (*rc::gen::inRange(0, 6)) {
        case 0:
            return {"(" + a.text + " + " + b.text + ")", a.value + b.value};
        case 1:
            return {"(" + a.text + " - " + b.text + ")", a.value - b.value};
        case 2:
            return {"(" + a.text + ")*(" + b.text + ")", a.value * b.value};
        case 3:
            return {"((" + a.text + ")/(" + b.text + "))", a.value / b.value};
        case 4:
            return {"(" + a.text + ")^" + std::to_string(power), std::pow(a.value, power)};
        default:
            return {"sqrt(" + a.text + ")", std::sqrt(a.value)};
    }
}

}  // namespace

TEST_CASE("a formula as LaTeX has the value of the formula") {
    std::size_t compared = 0;
    CHECK(rc::check([&] {
        const Formula formula = any_formula(*rc::gen::inRange(0, 4));
        if (!std::isfinite(formula.value) || std::fabs(formula.value) > 1e9) return;
        const double value = LatexValue(formula_latex(formula.text)).all();
        RC_ASSERT(std::fabs(value - formula.value) <= 1e-9 * (1 + std::fabs(formula.value)));
        ++compared;
    }));
    CHECK(compared >= 40);
}

TEST_CASE("formulas of growth and dimension") {
    CHECK(formula_latex("a(n) = 5a(n-1) - 4a(n-2)") == "a(n) = 5 a(n - 1) - 4 a(n - 2)");
    CHECK(formula_latex("(x - 1)^2 (x^2 - x - 1)") ==
          "\\left(x - 1\\right)^{2} \\left(x^{2} - x - 1\\right)");
    CHECK(formula_latex("((1+sqrt(5))/2)^n") == "\\left(\\frac{1 + \\sqrt{5}}{2}\\right)^{n}");
    CHECK(formula_latex("2^n*n") == "2^{n} n");
    CHECK(
        formula_latex("log (the largest real root of x^3 - x^2 - 2) / log sqrt 2") ==
        "\\frac{\\log \\left(\\max\\{r \\in \\mathbb{R} : r^{3} - r^{2} - 2 = 0\\}\\right)}{\\log "
        "\\sqrt{2}}");
    CHECK(formula_latex("sum over the roots r of x^3 - x - 1 of (r + 1)*r^n") ==
          "\\sum_{r:\\, x^{3} - x - 1 = 0} \\left(r + 1\\right) r^{n}");
    // What is no formula stays what it is.
    CHECK(formula_latex("no formula & more") == "\\text{no formula \\& more}");
    CHECK(formula_latex("(1") == "\\text{(1}");
}

TEST_CASE("a message falls into its parts") {
    const MessageParts angle = parts_of("expected an angle from 3 to 50, found '51'");
    CHECK(angle.expected == "an angle from 3 to 50");
    CHECK(angle.found == "51");
    CHECK(angle.suggestion.empty());
    CHECK(parts_of("unknown setting 'angel'; did you mean 'angle'?").suggestion == "angle");
    CHECK(parts_of("expected a word, found ';'; say more").found == ";");
    CHECK(parts_of("unmatched ']'").expected.empty());
    const Diagnostic found{{"x.lsys", 3, 5}, "expected '->', found 'abc'", "  F abc", 4};
    CHECK(end_column(found) == 8);
    CHECK(end_column({{"x.lsys", 3, 5}, "unmatched ']'", "F -> ]", 5}) == 6);
}
