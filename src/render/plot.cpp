#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <numbers>

#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "render/detail/document.hpp"
#include "render/render.hpp"

// Diagrams of numbers: lengths against generations, and counts against sizes for dimensions.
//
// The growth diagram has exact lengths as dots and the closed form as a line. The line is computed from the closed form itself,
// with more bits until the value is good enough for a picture, and not from the dots. Where the growth is exponential all heights are decimal logarithms; a length may have far more digits than a double, so the
// logarithm is taken of its enclosure.
//
// The diagram of a dimension is log-log: cells touched (or lengths, for dividers) against the size of the whole in cells. Each scale
// shows the mean over the grids' offsets with its range; scales that the fit uses are filled dots on a shaded strip. Underneath stand
// the residuals: by how many per cent each mean is off the line. The line of a box count is the
// fit's own value at each scale, which is not defined everywhere; that of other measures is least squares through the scales used.
//
// As a page of HTML a diagram is the same picture, as svg within it, with a program that enlarges parts of it and the numbers as a table.

namespace algae {

namespace {

constexpr double page_width = 480, left = 64, right = 20;
constexpr double letters = 11;
constexpr std::uint64_t most_dots = 2000;
constexpr long logarithm_bits = 64;

/// The numbers of a diagram, for those who read a page of it.
struct NumberTable {
    std::string caption;
    std::vector<std::string> head;
    std::vector<std::vector<double>> rows;
};

/// The program of a page: the wheel and the mouse change which part of the picture is seen, and the nearest row is marked.
constexpr const char* page_program = R"(
const picture = document.querySelector("svg"), whole = picture.getAttribute("viewBox").split(/[ ,]+/).map(Number);
let seen = [...whole], last = null;
const show = () => {
    picture.setAttribute("viewBox", seen.join(" "));
    picture.dataset.seen = seen.map(value => Math.round(value)).join(" ");
};
const place = event => {
    const box = picture.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
};
picture.onwheel = event => {
    event.preventDefault();
    const factor = Math.exp(event.deltaY / 400), [x, y] = place(event);
    seen = [seen[0] + x * seen[2] * (1 - factor), seen[1] + y * seen[3] * (1 - factor), seen[2] * factor, seen[3] * factor];
    show();
};
picture.onpointerdown = event => { picture.setPointerCapture(event.pointerId); last = place(event); };
picture.onpointerup = picture.onpointercancel = () => { last = null; };
picture.onpointermove = event => {
    if (!last) return;
    const [x, y] = place(event);
    seen[0] -= (x - last[0]) * seen[2];
    seen[1] -= (y - last[1]) * seen[3];
    last = [x, y];
    show();
};
document.getElementById("reset").onclick = () => { seen = [...whole]; show(); };
const link = new URLSearchParams(location.hash.slice(1)), zoom = +link.get("zoom") || 1;
seen = [whole[0] + whole[2] * (1 - 1 / zoom) / 2, whole[1] + whole[3] * (1 - 1 / zoom) / 2, whole[2] / zoom, whole[3] / zoom];
show();
)";

/// A page of HTML that needs nothing else: the picture, which can be moved and enlarged, and its numbers.
std::string plot_page(const std::string& svg, const NumberTable& table) {
    const std::size_t begin = svg.find("<svg");
    std::string rows = "<tr>";
    for (const std::string& one : table.head) rows += "<th>" + escaped_markup(one) + "</th>";
    rows += "</tr>\n";
    for (const auto& row : table.rows) {
        rows += "<tr>";
        for (const double value : row) rows += "<td>" + rounded_decimal(value, 10) + "</td>";
        rows += "</tr>\n";
    }
    const std::string title = escaped_markup(table.caption);
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>" + title +
           "</title>\n<style>\nbody { font-family: sans-serif; margin: 1em; color: #222 }\n"
           "h1 { font-size: 1.1em }\nsvg { width: 100%; max-height: 75vh; cursor: grab; "
           "touch-action: none }\ntable { border-collapse: collapse; font-size: 0.9em }\n"
           "td, th { text-align: right; padding: 0.1em 0.8em }\n</style>\n<h1>" +
           title + "</h1>\n" + svg.substr(begin == std::string::npos ? 0 : begin) +
           "<p><button id=\"reset\">whole</button> drag to move, wheel to zoom</p>\n"
           "<details><summary>numbers</summary>\n<table>\n" +
           rows + "</table>\n</details>\n<script>" + page_program + "</script>\n</html>\n";
}

/// What is written, kept.
class Kept final : public Output {
public:
    void write(const char* bytes, std::size_t count) override { text.append(bytes, count); }
    std::string text;
};

/// Opens a page of this height in the format that the end of the path says, and completes it. A page of HTML has the picture as svg, and the
/// table.
void draw_page(const std::string& path, double height, const NumberTable& table,
               const Budget& budget, const std::function<void(cairo_t*)>& draw) {
    const bool is_page = figure_format(path) == FigureFormat::html;
    const PictureFormat format = is_page ? PictureFormat::svg : picture_format(path);
    const double scale = format == PictureFormat::png ? 2 : 1;
    const auto picture = [&](Output& file) {
        Document document(format, scale * page_width, scale * height, Colour{1, 1, 1}, file,
                          budget);
        cairo_t* const context = document.context();
        cairo_scale(context, scale, scale);
        choose_font(context, "sans-serif", letters);
        draw(context);
        check_cairo(context);
        document.finish();
    };
    write_to(path, [&](Output& file) {
        if (!is_page) return picture(file);
        Kept svg;
        picture(svg);
        const std::string page = plot_page(svg.text, table);
        file.write(page.data(), page.size());
    });
}

/// What diagrams are drawn with.
class Chart {
protected:
    /// Texts are made smaller where they are wider than `room`.
    Chart(cairo_t* context, double room) : context_(context), room_(room) {}

    void colour(double red, double green, double blue) { set_colour(context_, {red, green, blue}); }
    void stroke(double x1, double y1, double x2, double y2) {
        draw_line(context_, {x1, y1}, {x2, y2});
    }
    /// Writes a text; share 0 begins at the place, 0.5 has it in the middle, 1 ends there.
    void text(const std::string& words, double at, double height, double share) {
        if (words.empty()) return;
        double width = text_width(context_, words);
        if (width > room_) {
            cairo_set_font_size(context_, std::max(letters * room_ / width, 4.0));
            width = text_width(context_, words);
        }
        show_text(context_, words, at - share * width, height);
        cairo_set_font_size(context_, letters);
    }

    cairo_t* context_;

private:
    double room_;
};

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
    for (double mark = std::ceil(low / step - 1e-9) * step; mark <= high + step * 1e-9;
         mark += step)
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
class Diagram : Chart {
public:
    static constexpr double page_height = 320, top = 20, bottom = 64;

    Diagram(const Plot& plot, cairo_t* context) : Chart(context, page_width - left), plot_(plot) {
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
        axes();
        line();
        dots();
        colour(0, 0, 0);
        text(plot_.caption, (page_width + left - right) / 2, page_height - 10, 0.5);
        text(plot_.formula, left + 10, top + 12, 0);
    }

private:
    double x(double value) const {
        return left + 6 + (value - first_) / (last_ - first_) * (page_width - left - right - 12);
    }
    double y(double value) const {
        return page_height - bottom - 6 -
               (value - low_) / (high_ - low_) * (page_height - top - bottom - 24);
    }

    void axes() {
        cairo_set_line_width(context_, 0.7);
        for (const double mark : marks(low_, high_, plot_.logarithmic ? 1 : 1e-9)) {
            colour(0.85, 0.85, 0.85);
            stroke(left, y(mark), page_width - right, y(mark));
            colour(0, 0, 0);
            text(plot_.logarithmic ? (mark == 0   ? "1"
                                      : mark == 1 ? "10"
                                                  : "10^" + number(mark))
                                   : number(mark),
                 left - 6, y(mark) + 4, 1);
        }
        for (const double mark : marks(first_, last_, 1)) {
            stroke(x(mark), page_height - bottom, x(mark), page_height - bottom + 4);
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
        colour(0.55, 0.65, 0.85);
        cairo_set_line_width(context_, 1.2);
        for (const auto& [at, value] : plot_.line) cairo_line_to(context_, x(at), y(value));
        cairo_stroke(context_);
    }

    void dots() {
        colour(0.1, 0.2, 0.5);
        for (const auto& [at, value] : plot_.dots) {
            cairo_new_sub_path(context_);
            cairo_arc(context_, x(at), y(value), plot_.dots.size() > 100 ? 1 : 2, 0,
                      8 * std::atan(1));
        }
        cairo_fill(context_);
    }

    const Plot& plot_;
    double first_ = std::numeric_limits<double>::infinity();
    double last_ = -std::numeric_limits<double>::infinity();
    double low_, high_;
};

/// A length as a height of the diagram.
double height(const Ball& value, bool logarithmic) {
    if (!logarithmic) return value.midpoint();
    return (log(value) / log(Ball(10, logarithm_bits))).midpoint();
}

std::string digits(const char* form, double value) {
    char text[48];
    std::snprintf(text, sizeof text, form, value);
    return text;
}

/// A rectangle of the page with linear scales; what is logarithmic comes as logarithms.
struct Panel {
    double upper, lower;       // on the page
    double first, last;        // across
    double low = 0, high = 1;  // upward

    double x(double value) const {
        return left + 10 + (value - first) / (last - first) * (page_width - left - right - 20);
    }
    double y(double value) const {
        return lower - 6 - (value - low) / (high - low) * (lower - upper - 12);
    }
};

/// What is plotted, as logarithms to the base 10: at each place across, a value with its range.
struct Series {
    struct Value {
        double least, mean, most;
    };
    std::vector<double> across;
    std::vector<Value> values;
    std::vector<double> line;         // empty without a fit; not finite where it has no value
    std::size_t first = 0, last = 0;  // the scales used
    std::optional<Estimate> estimate;
    std::string caption, upward, sideways;  // underneath, and what the axes are
};

Series series_of(const DimensionPlot& plot) {
    const BoxCounts& counts = plot.counts;
    Series made;
    const double whole = counts.whole > 0 ? counts.whole : counts.scales.coarsest;
    for (std::size_t scale = 0; scale < counts.counts.size(); ++scale) {
        made.across.push_back(std::log10(whole / counts.scales.cell(scale)));
        const auto& all = counts.counts[scale];
        const auto [least, most] = std::minmax_element(all.begin(), all.end());
        made.values.push_back({std::log10(static_cast<double>(*least)),
                               std::log10(counts.mean(scale)),
                               std::log10(static_cast<double>(*most))});
        if (plot.fit.estimate)
            made.line.push_back(plot.fit.fitted(counts, scale) / std::numbers::ln10);
    }
    made.first = plot.fit.first;
    made.last = plot.fit.last;
    made.estimate = plot.fit.estimate;
    made.caption = plot.caption;
    made.upward = "cells touched";
    made.sideways = "size of the whole / size of a cell";
    return made;
}

Series series_of(const ScalingPlot& plot) {
    const Scaling& scaling = plot.scaling;
    Series made;
    for (std::size_t i = 0; i < scaling.sizes.size(); ++i) {
        if (!(scaling.values[i] > 0)) throw Error("nothing to plot: expected values above 0");
        const double value = std::log10(scaling.values[i]);
        made.across.push_back(std::log10(scaling.sizes.front() / scaling.sizes[i]));
        made.values.push_back({value, value, value});
    }
    made.first = scaling.first;
    made.last = scaling.last;
    made.estimate = scaling.estimate;
    made.caption = plot.caption;
    made.upward = plot.value;
    made.sideways = "widest " + plot.scale + " / " + plot.scale;
    if (!made.estimate) return made;
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = made.first; i <= made.last; ++i) {
        n += 1;
        x += made.across[i];
        y += made.values[i].mean;
        xx += made.across[i] * made.across[i];
        xy += made.across[i] * made.values[i].mean;
    }
    const double slope = (n * xy - x * y) / (n * xx - x * x), at_0 = (y - slope * x) / n;
    for (const double across : made.across) made.line.push_back(at_0 + slope * across);
    return made;
}

class DimensionDiagram : Chart {
public:
    static constexpr double page_height = 420, top = 26, bottom = 58;
    static constexpr double strip = 84, gap = 22;  // the residuals under the plot

    DimensionDiagram(const Series& plot, cairo_t* context)
        : Chart(context, page_width - 16), plot_(plot), scales_(plot.values.size()) {
        const double first = across(0), last = across(scales_ - 1);
        counts_ = {top, page_height - bottom - strip - gap, first, last};
        double least = plot_.values[0].least, greatest = plot_.values[0].most;
        for (const Series::Value& value : plot_.values) {
            least = std::min(least, value.least);
            greatest = std::max(greatest, value.most);
        }
        counts_.low = std::min(least, 0.0);
        counts_.high = std::max(greatest, 1.0);
        // Cells are counted from 1 on; what changes little is shown alone.
        if (greatest - least < 1) {
            counts_.low = least - 0.1;
            counts_.high = greatest + 0.2;
        }
        residuals_ = {page_height - bottom - strip, page_height - bottom, first, last};
        double most = 0.01;
        if (plot_.estimate)
            for (std::size_t scale = plot_.first; scale <= plot_.last; ++scale)
                most = std::max(most, std::abs(percent(scale)) / 100);
        residuals_.high = std::ceil(150 * most);
        residuals_.low = -residuals_.high;
    }

    void draw() {
        if (plot_.estimate) {
            shade(counts_);
            shade(residuals_);
        }
        axes();
        if (plot_.estimate) {
            line();
            residuals();
        }
        dots();
        words();
    }

private:
    double across(std::size_t scale) const { return plot_.across[scale]; }
    double percent(std::size_t scale) const {
        const double off = plot_.values[scale].mean - plot_.line[scale];
        return 100 * std::expm1(off * std::numbers::ln10);
    }

    void shade(const Panel& panel) {
        const double half = (across(1) - across(0)) / 2;
        const double from = std::max(panel.x(across(plot_.first) - half), left),
                     to = panel.x(across(plot_.last) + half);
        colour(0.91, 0.94, 0.99);
        cairo_rectangle(context_, from, panel.upper, std::min(to, page_width - right) - from,
                        panel.lower - panel.upper);
        cairo_fill(context_);
    }

    void grid_line(const Panel& panel, double value, const std::string& name) {
        colour(0.85, 0.85, 0.85);
        stroke(left, panel.y(value), page_width - right, panel.y(value));
        colour(0, 0, 0);
        text(name, left - 6, panel.y(value) + 4, 1);
    }

    void frame(const Panel& panel) {
        colour(0, 0, 0);
        stroke(left, panel.upper, left, panel.lower);
        stroke(left, panel.lower, page_width - right, panel.lower);
    }

    static std::string power_of_ten(int exponent) {
        if (exponent < 0) return digits("%g", std::pow(10, exponent));
        return exponent < 4 ? digits("%.0f", std::pow(10, exponent))
                            : "10^" + std::to_string(exponent);
    }

    void axes() {
        cairo_set_line_width(context_, 0.7);
        const int lowest = static_cast<int>(std::floor(counts_.low)),
                  highest = static_cast<int>(counts_.high);
        const int step = (highest - lowest) / 7 + 1;
        const auto shown = [&](double value) {
            return value >= counts_.low && value <= counts_.high;
        };
        for (int k = lowest; k <= highest; k += step) {
            if (shown(k)) grid_line(counts_, k, power_of_ten(k));
            if (counts_.high - counts_.low > 1.5) continue;
            for (const int part : {2, 5})
                if (const double value = k + std::log10(part); shown(value))
                    grid_line(counts_, value, digits("%g", part * std::pow(10, k)));
        }
        for (const double share : {-1.0, 0.0, 1.0}) {
            const double value = share * std::floor(residuals_.high / 1.5 + 0.5);
            grid_line(residuals_, value, value == 0 ? "0" : digits("%+.0f %%", value));
        }
        const std::size_t every = scales_ / 9 + 1;
        for (std::size_t scale = 0; scale < scales_; ++scale) {
            const double at = residuals_.x(across(scale));
            stroke(at, residuals_.lower, at, residuals_.lower + 4);
            if (scale % every != 0) continue;
            const double ratio = std::pow(10, across(scale));
            text(ratio < 1e6 ? digits("%.0f", ratio) : digits("%.0e", ratio), at,
                 residuals_.lower + 16, 0.5);
        }
        frame(counts_);
        frame(residuals_);
    }

    void line() {
        colour(0.35, 0.5, 0.8);
        cairo_set_line_width(context_, 1.2);
        cairo_save(context_);
        cairo_rectangle(context_, left, counts_.upper, page_width - left - right,
                        counts_.lower - counts_.upper);
        cairo_clip(context_);
        for (std::size_t scale = 0; scale < scales_; ++scale) {
            const double height = plot_.line[scale];
            if (std::isfinite(height))
                cairo_line_to(context_, counts_.x(across(scale)), counts_.y(height));
        }
        cairo_stroke(context_);
        cairo_restore(context_);
    }

    void dot(double x, double y, bool used) {
        cairo_new_sub_path(context_);
        cairo_arc(context_, x, y, 2.5, 0, 2 * std::numbers::pi);
        colour(0.1, 0.2, 0.5);
        if (used) {
            cairo_fill(context_);
        } else {
            cairo_set_line_width(context_, 0.8);
            cairo_stroke(context_);
        }
    }

    bool is_used(std::size_t scale) const {
        return plot_.estimate && scale >= plot_.first && scale <= plot_.last;
    }

    void dots() {
        for (std::size_t scale = 0; scale < scales_; ++scale) {
            const Series::Value& value = plot_.values[scale];
            const double at = counts_.x(across(scale));
            colour(0.1, 0.2, 0.5);
            cairo_set_line_width(context_, 0.8);
            stroke(at, counts_.y(value.least), at, counts_.y(value.most));
            dot(at, counts_.y(value.mean), is_used(scale));
        }
    }

    void residuals() {
        for (std::size_t scale = 0; scale < scales_; ++scale)
            if (std::abs(percent(scale)) <= residuals_.high)
                dot(residuals_.x(across(scale)), residuals_.y(percent(scale)), is_used(scale));
    }

    void words() {
        colour(0, 0, 0);
        text(plot_.upward, left - 40, top - 10, 0);
        text("off the line", left + 6, residuals_.upper - 5, 0);
        text(plot_.sideways, page_width - right, page_height - bottom + 31, 1);
        text(plot_.caption, page_width / 2, page_height - 10, 0.5);
        if (!plot_.estimate) return;
        const Estimate& found = *plot_.estimate;
        text("dimension " + digits("%.4f", found.value), left + 14, top + 12, 0);
        text("between " + digits("%.4f", found.low) + " and " + digits("%.4f", found.high),
             left + 14, top + 27, 0);
    }

    const Series& plot_;
    std::size_t scales_;
    Panel counts_, residuals_;
};

void draw_series(const Series& series, const std::string& path, const Budget& budget) {
    if (series.values.size() < 2) throw Error("nothing to plot: expected at least two scales");
    NumberTable table{
        series.caption,
        {"log10 " + series.sideways, "log10 " + series.upward, "least", "most", "line"},
        {}};
    for (std::size_t i = 0; i < series.values.size(); ++i) {
        const auto& [least, mean, most] = series.values[i];
        table.rows.push_back({series.across[i], mean, least, most});
        if (i < series.line.size() && std::isfinite(series.line[i]))
            table.rows.back().push_back(series.line[i]);
    }
    draw_page(path, DimensionDiagram::page_height, table, budget,
              [&](cairo_t* context) { DimensionDiagram(series, context).draw(); });
}

}  // namespace

void draw_plot(const Plot& plot, const std::string& path, const Budget& budget) {
    if (plot.dots.empty()) throw Error("nothing to plot: no values");
    NumberTable table{
        plot.caption,
        {plot.horizontal, (plot.logarithmic ? "log10 " : "") + plot.vertical, "formula"},
        {}};
    for (const auto& [x, y] : plot.dots) {
        table.rows.push_back({x, y});
        for (const auto& [at, height] : plot.line)
            if (at == x) table.rows.back().push_back(height);
    }
    draw_page(path, Diagram::page_height, table, budget,
              [&](cairo_t* context) { Diagram(plot, context).draw(); });
}

Plot growth_plot(const D0L& system, std::uint64_t first, std::uint64_t last, const Budget& budget) {
    if (last - first >= most_dots)
        throw Error("expected at most " + std::to_string(most_dots) +
                    " generations to plot, found " + std::to_string(last - first + 1));
    const ClosedForm form = closed_form(system, budget);
    Plot plot;
    plot.caption =
        system.name.empty() ? "length of generation n" : system.name + ": length of generation n";
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

void draw_dimension_plot(const DimensionPlot& plot, const std::string& path, const Budget& budget) {
    draw_series(series_of(plot), path, budget);
}

void draw_scaling_plot(const ScalingPlot& plot, const std::string& path, const Budget& budget) {
    draw_series(series_of(plot), path, budget);
}

}  // namespace algae
