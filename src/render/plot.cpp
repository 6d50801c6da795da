#include "render/plot.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "growth/closed_form.hpp"
#include "growth/growth_class.hpp"
#include "render/document.hpp"

namespace algae {

namespace {

constexpr double page_width = 480, page_height = 320;
constexpr double left = 64, right = 20, top = 20, bottom = 64;
constexpr double letters = 11;
constexpr std::uint64_t most_dots = 2000;
constexpr long logarithm_bits = 64;

/// The numbers between two ends that an axis names: multiples of 1, 2 or 5 times a power of ten.
std::vector<double> marks(double low, double high, double at_least) {
    const double rough = std::max((high - low) / 6, at_least);
    const double power = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough * 0.999) {
            step = factor * power;
            break;
        }
    std::vector<double> found;
    for (double mark = std::ceil(low / step - 1e-9) * step; mark <= high + step * 1e-9; mark += step)
        found.push_back(mark);
    return found;
}

std::string number(double value) {
    if (std::abs(value) >= 1e6) {
        const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
        std::string digits = std::to_string(value / std::pow(10, exponent));
        while (digits.ends_with('0')) digits.pop_back();
        if (digits.ends_with('.')) digits.pop_back();
        return digits + "e" + std::to_string(exponent);
    }
    return std::to_string(static_cast<long>(std::llround(value)));
}

/// The diagram on a page: the rectangle of the numbers and how it is drawn.
class Diagram {
public:
    Diagram(const Plot& plot, cairo_t* context) : plot_(plot), context_(context) {
        double high = -std::numeric_limits<double>::infinity();
        low_ = plot.logarithmic ? -high : 0;
        for (const auto* points : {&plot.dots, &plot.line})
            for (const auto& [x, y] : *points) {
                first_ = std::min(first_, x);
                last_ = std::max(last_, x);
                low_ = std::min(low_, y);
                high = std::max(high, y);
            }
        if (plot.logarithmic) low_ = std::floor(low_);
        high_ = high > low_ ? high : low_ + 1;
        if (last_ <= first_) last_ = first_ + 1;
    }

    void draw() {
        cairo_select_font_face(context_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(context_, letters);
        axes();
        line();
        dots();
        cairo_set_source_rgb(context_, 0, 0, 0);
        text(plot_.caption, (page_width + left - right) / 2, page_height - 10, 0.5);
        text(plot_.formula, left + 10, top + 12, 0);
        check_cairo(context_);
    }

private:
    double x(double value) const {
        return left + 6 + (value - first_) / (last_ - first_) * (page_width - left - right - 12);
    }
    double y(double value) const {
        return page_height - bottom - 6 - (value - low_) / (high_ - low_) * (page_height - top - bottom - 24);
    }

    /// Writes a text; share 0 begins at the place, 0.5 has it in the middle, 1 ends there.
    void text(std::string words, double at, double height, double share) {
        if (words.empty()) return;
        cairo_text_extents_t extents{};
        cairo_text_extents(context_, words.c_str(), &extents);
        const double space = page_width - left;
        if (extents.x_advance > space) {
            cairo_set_font_size(context_, std::max(letters * space / extents.x_advance, 4.0));
            cairo_text_extents(context_, words.c_str(), &extents);
        }
        cairo_move_to(context_, at - share * extents.x_advance, height);
        cairo_show_text(context_, words.c_str());
        cairo_new_path(context_);
        cairo_set_font_size(context_, letters);
    }

    void axes() {
        cairo_set_line_width(context_, 0.7);
        for (const double mark : marks(low_, high_, plot_.logarithmic ? 1 : 1e-9)) {
            cairo_set_source_rgb(context_, 0.85, 0.85, 0.85);
            cairo_move_to(context_, left, y(mark));
            cairo_line_to(context_, page_width - right, y(mark));
            cairo_stroke(context_);
            cairo_set_source_rgb(context_, 0, 0, 0);
            text(plot_.logarithmic ? (mark == 0 ? "1" : mark == 1 ? "10" : "10^" + number(mark)) : number(mark), left - 6,
                 y(mark) + 4, 1);
        }
        for (const double mark : marks(first_, last_, 1)) {
            cairo_move_to(context_, x(mark), page_height - bottom);
            cairo_line_to(context_, x(mark), page_height - bottom + 4);
            cairo_stroke(context_);
            text(number(mark), x(mark), page_height - bottom + 17, 0.5);
        }
        cairo_move_to(context_, left, top);
        cairo_line_to(context_, left, page_height - bottom);
        cairo_line_to(context_, page_width - right, page_height - bottom);
        cairo_stroke(context_);
        text(plot_.horizontal, page_width - right, page_height - bottom + 32, 1);
        text(plot_.vertical, left - 40, top - 8, 0);
    }

    void line() {
        cairo_set_source_rgb(context_, 0.55, 0.65, 0.85);
        cairo_set_line_width(context_, 1.2);
        for (const auto& [at, value] : plot_.line) cairo_line_to(context_, x(at), y(value));
        cairo_stroke(context_);
    }

    void dots() {
        cairo_set_source_rgb(context_, 0.1, 0.2, 0.5);
        for (const auto& [at, value] : plot_.dots) {
            cairo_new_sub_path(context_);
            cairo_arc(context_, x(at), y(value), plot_.dots.size() > 100 ? 1 : 2, 0, 8 * std::atan(1));
        }
        cairo_fill(context_);
    }

    const Plot& plot_;
    cairo_t* context_;
    double first_ = std::numeric_limits<double>::infinity();
    double last_ = -std::numeric_limits<double>::infinity();
    double low_, high_;
};

/// A length as a height of the diagram.
double height(const Ball& value, bool logarithmic) {
    if (!logarithmic) return value.midpoint();
    return (log(value) / log(Ball(10, logarithm_bits))).midpoint();
}

}  // namespace

void draw_plot(const Plot& plot, const std::string& path, const Budget& budget) {
    if (plot.dots.empty()) throw Error("nothing to plot: no values");
    const PictureFormat format = picture_format(path);
    const double scale = format == PictureFormat::png ? 2 : 1;
    FileOutput file(path);
    Document document(format, scale * page_width, scale * page_height, Colour{1, 1, 1}, file, budget);
    cairo_scale(document.context(), scale, scale);
    Diagram(plot, document.context()).draw();
    document.finish();
    file.commit();
}

Plot growth_plot(const D0L& system, std::uint64_t first, std::uint64_t last, const Budget& budget) {
    if (last - first >= most_dots)
        throw Error("expected at most " + std::to_string(most_dots) + " generations to plot, found " +
                    std::to_string(last - first + 1));
    const ClosedForm form = closed_form(system, budget);
    Plot plot;
    plot.caption = system.name.empty() ? "length of generation n" : system.name + ": length of generation n";
    plot.formula = form.text();
    if (plot.formula.size() > 120) plot.formula.clear();
    plot.horizontal = "n";
    plot.vertical = "length";
    plot.logarithmic = growth_class(system, budget).order.kind == GrowthKind::exponential;
    const std::vector<Integer> exact = lengths(system, last + 1, budget);
    for (std::uint64_t n = first; n <= last; ++n) {
        const double at = static_cast<double>(n);
        plot.dots.emplace_back(at, height(Ball(exact[n], logarithm_bits), plot.logarithmic));
        if (n < form.exceptions().size()) continue;
        budget.check();
        // The line is the closed form's own value; more bits until it is good enough for a picture.
        for (long bits = logarithm_bits; bits < 1L << 20; bits *= 2) {
            const Ball value = form.value(n, bits + static_cast<long>(bit_length(exact[n])));
            if (!value.has_radius_below(-8)) continue;
            plot.line.emplace_back(at, height(value, plot.logarithmic));
            break;
        }
    }
    return plot;
}

}  // namespace algae
