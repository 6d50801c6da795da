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
// the residuals: by how many per cent each mean is off the line. The line is straight: of the estimated slope, and where it fits the scales
// used best; it is drawn there and nowhere else. A dimension that is known by other means is a dashed line through the same place.
// The numbers of an axis have one notation, digits or powers of ten.
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

/// A power of ten with a raised exponent.
std::string power_of_ten(int exponent) {
    static constexpr const char* raised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                             "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string out = "10";
    for (const char sign : std::to_string(exponent))
        out += sign == '-' ? "\u207b" : raised[sign - '0'];
    return out;
}

/// A number of an axis whose numbers all have one notation: factors and powers of ten, or digits.
std::string number(double value, bool as_power) {
    if (std::abs(value) < 1e-12) return "0";
    if (!as_power) return rounded_decimal(value, 6);
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
    const std::string factor = rounded_decimal(value / std::pow(10, exponent), 4);
    return (factor == "1" ? "" : factor + "\u00b7") + power_of_ten(exponent);
}

/// From here on the numbers of an axis are written with powers of ten.
constexpr double large_number = 1e5;

/// The diagram on a page: the rectangle of the numbers and how it is drawn.
class Diagram : Chart {
public:
    static constexpr double page_height = 320, top = 20, bottom = 64;

    Diagram(const Plot& plot, cairo_t* context)
        : Chart(context, page_width - left - right - 10), plot_(plot) {
        double high = -std::numeric_limits<double>::infinity();
        low_ = plot.logarithmic ? -high : 0;
        for (const auto* points : {&plot.dots, &plot.line})
            for (const auto& [x, y] : *points) {
                first_ = std::min(first_, x);
                last_ = std::max(last_, x);
                low_ = std::min(low_, y);
                high = std::max(high, y);
            }
        if (plot.logarithmic) low_ = std::floor(low_ + 1e-9);
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
            text(plot_.logarithmic ? power_of_ten(static_cast<int>(std::llround(mark)))
                                   : number(mark, high_ >= large_number),
                 left - 6, y(mark) + 4, 1);
        }
        for (const double mark : marks(first_, last_, 1)) {
            stroke(x(mark), page_height - bottom, x(mark), page_height - bottom + 4);
            text(number(mark, last_ >= large_number), x(mark), page_height - bottom + 17, 0.5);
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
    std::optional<double> exact;  // slope
    std::string exact_text;
    std::string caption, upward, sideways;  // underneath, and what the axes are
};

/// The straight line of this slope that fits best at the scales used; nowhere else has it values.
std::vector<double> straight_line(const Series& series, double slope) {
    double above = 0;
    for (std::size_t i = series.first; i <= series.last; ++i)
        above += series.values[i].mean - slope * series.across[i];
    above /= static_cast<double>(series.last - series.first + 1);
    std::vector<double> line(series.across.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = series.first; i <= series.last; ++i)
        line[i] = above + slope * series.across[i];
    return line;
}

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
    }
    made.first = plot.fit.first;
    made.last = plot.fit.last;
    made.estimate = plot.fit.estimate;
    made.exact = plot.exact;
    made.exact_text = plot.exact_text;
    made.caption = plot.caption;
    made.upward = "number of cells touched";
    made.sideways = "size of the whole in cells";
    if (made.estimate) made.line = straight_line(made, made.estimate->value);
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
    made.upward = plot.value + (plot.value == "length" ? " (units of the file)" : "");
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
    made.line = straight_line(made, (n * xy - x * y) / (n * xx - x * x));
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
            lines();
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

    void axes() {
        cairo_set_line_width(context_, 0.7);
        const int lowest = static_cast<int>(std::floor(counts_.low)),
                  highest = static_cast<int>(counts_.high);
        const int step = (highest - lowest) / 7 + 1;
        const auto shown = [&](double value) {
            return value >= counts_.low && value <= counts_.high;
        };
        const bool as_powers = counts_.high >= std::log10(large_number);
        for (int k = lowest; k <= highest; k += step) {
            if (shown(k)) grid_line(counts_, k, number(std::pow(10, k), as_powers));
            if (counts_.high - counts_.low > 1.5) continue;
            for (const int part : {2, 5})
                if (const double value = k + std::log10(part); shown(value))
                    grid_line(counts_, value, number(part * std::pow(10, k), as_powers));
        }
        for (const double share : {-1.0, 0.0, 1.0}) {
            const double value = share * std::floor(residuals_.high / 1.5 + 0.5);
            grid_line(residuals_, value, value == 0 ? "0" : digits("%+.0f %%", value));
        }
        for (std::size_t scale = 0; scale < scales_; ++scale) {
            const double at = residuals_.x(across(scale));
            stroke(at, residuals_.lower, at, residuals_.lower + 3);
        }
        // Numbers stand at powers of ten where the axis is long, otherwise at the scales.
        const bool long_axis = residuals_.last >= std::log10(large_number);
        const int least = static_cast<int>(std::ceil(residuals_.first - 1e-9)),
                  most = static_cast<int>(std::floor(residuals_.last + 1e-9));
        const int stride = (most - least) / 9 + 1;
        for (int k = least; long_axis && k <= most; k += stride) {
            const double at = residuals_.x(k);
            stroke(at, residuals_.lower, at, residuals_.lower + 5);
            text(power_of_ten(k), at, residuals_.lower + 17, 0.5);
        }
        const std::size_t every = scales_ / 9 + 1;
        for (std::size_t scale = 0; !long_axis && scale < scales_; scale += every)
            text(rounded_decimal(std::pow(10, across(scale)), 3), residuals_.x(across(scale)),
                 residuals_.lower + 17, 0.5);
        frame(counts_);
        frame(residuals_);
    }

    /// Draws a line where it has values.
    void line(const std::vector<double>& heights) {
        cairo_save(context_);
        cairo_rectangle(context_, left, counts_.upper, page_width - left - right,
                        counts_.lower - counts_.upper);
        cairo_clip(context_);
        for (std::size_t scale = 0; scale < scales_; ++scale)
            if (const double height = heights[scale]; std::isfinite(height))
                cairo_line_to(context_, counts_.x(across(scale)), counts_.y(height));
        cairo_stroke(context_);
        cairo_restore(context_);
    }

    void lines() {
        constexpr double dashes[] = {4, 3};
        if (plot_.exact) {
            colour(0.8, 0.35, 0.2);
            cairo_set_line_width(context_, 1.2);
            cairo_set_dash(context_, dashes, 2, 0);
            line(straight_line(plot_, *plot_.exact));
            cairo_set_dash(context_, dashes, 0, 0);
        }
        colour(0.35, 0.5, 0.8);
        cairo_set_line_width(context_, 1.2);
        line(plot_.line);
    }

    /// A full dot where the fit uses the scale; a ring where cells are too large for it, a cross where they are too small.
    void mark(double x, double y, std::size_t scale) {
        colour(0.1, 0.2, 0.5);
        cairo_set_line_width(context_, 0.8);
        if (plot_.estimate && scale > plot_.last) {
            stroke(x - 2.2, y - 2.2, x + 2.2, y + 2.2);
            stroke(x - 2.2, y + 2.2, x + 2.2, y - 2.2);
            return;
        }
        cairo_new_sub_path(context_);
        cairo_arc(context_, x, y, 2.5, 0, 2 * std::numbers::pi);
        if (is_used(scale))
            cairo_fill(context_);
        else
            cairo_stroke(context_);
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
            mark(at, counts_.y(value.mean), scale);
        }
    }

    void residuals() {
        for (std::size_t scale = plot_.first; scale <= plot_.last; ++scale)
            mark(residuals_.x(across(scale)), residuals_.y(percent(scale)), scale);
    }

    void words() {
        colour(0, 0, 0);
        text(plot_.upward, left - 40, top - 10, 0);
        text("off the line", left + 6, residuals_.upper - 5, 0);
        text(plot_.sideways, page_width - right, page_height - bottom + 31, 1);
        text(plot_.caption, page_width / 2, page_height - 10, 0.5);
        if (!plot_.estimate) return;
        const Estimate& found = *plot_.estimate;
        double height = top + 12;
        const auto line_of_text = [&](const std::string& words_of_line) {
            text(words_of_line, left + 14, height, 0);
            height += 15;
        };
        line_of_text("measured slope " + digits("%.4f", found.value) + ", between " +
                     digits("%.4f", found.low) + " and " + digits("%.4f", found.high));
        if (plot_.exact)
            line_of_text("exact slope " + digits("%.4f", *plot_.exact) +
                         (plot_.exact_text.empty() ? "" : " = " + plot_.exact_text) + " (dashed)");
        if (plot_.first > 0 || plot_.last + 1 < scales_)
            line_of_text(std::string("not used:") +
                         (plot_.first > 0 ? " \u25cb cells too large" : "") +
                         (plot_.last + 1 < scales_ ? " \u00d7 too small" : ""));
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
    plot.horizontal = "generation n";
    plot.vertical = "length (letters)";
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
