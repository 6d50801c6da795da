#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

#include "render/detail/document.hpp"
#include "render/detail/figure_text.hpp"
#include "render/detail/graph.hpp"
#include "render/detail/palette.hpp"

// Figures in the plane as text: what is common to TikZ, Typst, tables, GeoJSON, DXF, SVG and pages.
//
// A canvas gathers the strokes of a figure as paths, each with a style: its colour, its width and the letter of the word that draws it.
// A figure tells a canvas how far along the word it is, so the letter is that of the word at this position; nothing else is
// asked of a figure. Writers of formats (figure_typesetting.cpp, figure_data.cpp, figure_page.cpp) turn paths into text, and know no canvas.
// The layout of a page is that of pictures, in points, as if the format were svg.

namespace algae {

namespace {

constexpr std::array format_names{"tex", "typ", "csv", "geojson", "dxf", "html", "abc", "mid"};
constexpr std::uint64_t many_strokes = 100'000;  // from here on svg has no letters
constexpr std::uint32_t hues = 360;              // shades of a colour that runs along the word

/// Gathers what is drawn on it.
class PathCanvas final : public Canvas {
public:
    /// `listed`: how many colours the palette has beside hues.
    PathCanvas(const FigureSource& source, const Palette& palette, std::size_t listed, double width,
               double scale, const Budget& budget)
        : source_(source),
          palette_(palette),
          budget_(budget),
          listed_(static_cast<std::uint32_t>(std::max<std::size_t>(listed, 1))),
          pen_width_(width),
          scale_(scale) {
        now_.width = width;
    }

    void move_to(Point point) override {
        here_ = point;
        goes_on_ = false;
    }
    void line_to(Point point) override {
        const std::uint32_t style = current();
        if (!goes_on_ || found.paths.back().style != style) {
            FigurePath& path = found.paths.emplace_back();
            path.style = style;
            path.points.push_back(here_);
        }
        FigurePath& path = found.paths.back();
        path.points.push_back(point);
        path.positions.push_back(module_);
        here_ = point;
        goes_on_ = true;
        must_be_finite(point.x + point.y);
        if (++found.strokes % 65536 == 0) check();
    }
    void polygon(std::span<const Point> corners) override {
        FigurePath& path = found.paths.emplace_back();
        path.style = current();
        path.filled = true;
        path.points.assign(corners.begin(), corners.end());
        path.positions.push_back(module_);
        goes_on_ = false;
        corners_ += corners.size();
        if (++found.polygons % 4096 == 0) check();
    }
    void width(double factor) override { set_width(narrowed(pen_width_, factor)); }
    void width_as_length(double length) override { set_width(scale_ * std::fabs(length)); }
    void colour(std::uint32_t index) override {
        index_ = index;
        painted_.reset();
        changed_ = true;
    }
    void paint(const Colour& colour) override {
        painted_ = colour;
        changed_ = true;
    }
    void position(double fraction) override {
        fraction_ = fraction;
        if (source_.modules > 0) {
            const double place = std::round(fraction * static_cast<double>(source_.modules));
            const auto module = static_cast<std::uint64_t>(std::max(place, 0.0));
            module_ = std::min(module, source_.modules - 1);
            if (source_.letter) {
                const std::string_view letter = source_.letter(module_);
                if (letter != now_.letter) {
                    now_.letter = letter;
                    changed_ = true;
                }
            }
        }
        if (palette_.runs_along()) changed_ = true;
    }
    bool wants_position() const override { return true; }
    double line_width() const override { return pen_width_ / scale_; }

    FigurePaths found;

private:
    void set_width(double width) {
        if (width == now_.width) return;
        now_.width = width;
        changed_ = true;
    }
    /// The number of the style from here on.
    std::uint32_t current() {
        if (!changed_) return style_;
        changed_ = false;
        const std::uint32_t shade =
            painted_ ? Palette::no_shade : palette_.shade(index_, fraction_);
        now_.colour = painted_ ? *painted_ : palette_.colour(shade);
        now_.listed.reset();
        if (!painted_ && shade < listed_) now_.listed = shade;
        for (std::uint32_t i = 0; i < std::min<std::size_t>(found.styles.size(), 8); ++i)
            if (found.styles[i] == now_) return style_ = i;
        const auto key =
            std::tuple(now_.colour.red, now_.colour.green, now_.colour.blue,
                       now_.listed.value_or(Palette::no_shade), now_.width, now_.letter);
        const auto [entry, is_new] =
            numbers_.try_emplace(key, static_cast<std::uint32_t>(found.styles.size()));
        if (is_new) found.styles.push_back(now_);
        return style_ = entry->second;
    }
    void check() const {
        budget_.check();
        budget_.check_memory((found.strokes + corners_) * 40 + found.paths.size() * 80,
                             "the paths of a figure");
    }

    const FigureSource& source_;
    const Palette& palette_;
    const Budget& budget_;
    std::uint32_t listed_;  // shades from here on are hues
    double pen_width_, scale_;
    Point here_{};
    bool goes_on_ = false, changed_ = true;
    double fraction_ = 0;
    std::uint64_t module_ = 0, corners_ = 0;
    std::uint32_t index_ = 0, style_ = 0;
    std::optional<Colour> painted_;
    PathStyle now_;
    std::map<std::tuple<double, double, double, std::uint32_t, double, std::string>, std::uint32_t>
        numbers_;
};

}  // namespace

bool names_letters(const Figure& figure, FigureFormat format, bool plotter) {
    return format != FigureFormat::svg || plotter || figure.is_layered() ||
           figure.strokes().value_or(many_strokes) < many_strokes;
}

std::optional<FigureFormat> figure_format(std::string_view path) {
    if (const auto found = format_of(format_names, path)) return static_cast<FigureFormat>(*found);
    return std::nullopt;
}

const char* figure_format_name(FigureFormat format) {
    return format == FigureFormat::svg ? "svg" : format_names[static_cast<std::size_t>(format)];
}

FigurePaths paths_of(const FigureSource& source, const std::vector<std::string>& colours,
                     double width, double scale, const Budget& budget) {
    const Palette palette(colours, hues);
    PathCanvas canvas(source, palette, colours.size(), width, scale, budget);
    const Figure& figure = *source.plate.figure;
    figure.draw(canvas, figure.is_layered() ? 0.5 / scale : 0, budget);
    return std::move(canvas.found);
}

// --- Exact points ---

std::string exact_part(const CyclotomicRing& ring, const CyclotomicInteger& value, bool imaginary,
                       const Rational& factor, const Rational& offset) {
    // The real part of zeta^k is cos(360 k / m), the imaginary part cos(360 k / m - 90).
    std::map<std::string, Rational> terms;
    terms[""] = offset;
    const auto add_cosine = [&](long order, long place, const Rational& times) {
        // cos(2 pi place / order), with the angle brought to the first quadrant.
        place = ((place % order) + order) % order;
        if (2 * place > order) place = order - place;
        Rational sign = times;
        long over = order;
        if (4 * place > order) {  // cos(pi - x) = -cos(x)
            sign = -sign;
            place = order - 2 * place;
            over = 2 * order;
        }
        const long common = std::gcd(place, over);
        const long p = place / common, q = over / common;  // cos(2 pi p / q)
        if (p == 0)
            terms[""] += sign;
        else if (q == 4)
            return;
        else if (q == 6)
            terms[""] += sign / 2;
        else if (q == 8)
            terms["sqrt(2)"] += sign / 2;
        else if (q == 12)
            terms["sqrt(3)"] += sign / 2;
        else if (q == 24) {  // 15 degrees, or 75
            terms["sqrt(6)"] += sign / 4;
            terms["sqrt(2)"] += p == 1 ? Rational(sign / 4) : Rational(-sign / 4);
        } else if (q == 5 || q == 10) {  // 72 degrees, or 36
            terms["sqrt(5)"] += sign / 4;
            terms[""] += q == 10 ? Rational(sign / 4) : Rational(-sign / 4);
        } else {
            const std::string angle =
                2 * p % q == 0 ? "" : std::to_string(2 * p / std::gcd(2 * p, q));
            terms["cos(" + (angle == "1" ? "" : angle + "*") + "pi/" +
                  std::to_string(q / std::gcd(2 * p, q)) + ")"] += sign;
        }
    };
    const long order = ring.order();
    const auto& coordinates = value.coefficients;
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
        const Rational times = factor * Rational(coordinates[k]);
        if (sign(times) == 0) continue;
        if (imaginary)
            add_cosine(4 * order, 4 * static_cast<long>(k) - order, times);
        else
            add_cosine(order, static_cast<long>(k), times);
    }
    std::string text;
    for (const auto& [root, times] : terms) {
        if (sign(times) == 0) continue;
        const bool negative = sign(times) < 0;
        const Rational size = negative ? Rational(-times) : times;
        if (!text.empty() || negative) text += negative ? "-" : "+";
        const std::string digits = to_string(size);
        const std::size_t bar = digits.find('/');
        const std::string over = digits.substr(0, bar);
        if (root.empty())
            text += digits;
        else
            text += (over == "1" ? root : over + "*" + root) +
                    (bar == std::string::npos ? "" : digits.substr(bar));
    }
    return text.empty() ? "0" : text;
}

ExactPoints::ExactPoints(const FigureSource& source) {
    const std::shared_ptr<const Outline>& outline = source.outline;
    if (!outline || !outline->lattice || !outline->lattice->unit || !source.start) return;
    const Outline::Lattice& lattice = *outline->lattice;
    grid_ = std::fabs(source.plate.figure->facts().step) * 1e-6;
    for (std::size_t i = 0; i < lattice.points.size(); ++i)
        texts_.try_emplace(
            cell({outline->points[i].real(), outline->points[i].imag()}),
            exact_part(lattice.ring, lattice.points[i], false, *lattice.unit, source.start->first),
            exact_part(lattice.ring, lattice.points[i], true, *lattice.unit, source.start->second));
}

std::pair<std::int64_t, std::int64_t> ExactPoints::cell(Point point) const {
    return {std::llround(point.x / grid_), std::llround(point.y / grid_)};
}

const std::pair<std::string, std::string>& ExactPoints::at(Point point) const {
    static const std::pair<std::string, std::string> unknown;
    const auto [x, y] = cell(point);
    for (const int dx : {0, -1, 1})
        for (const int dy : {0, -1, 1})
            if (const auto found = texts_.find({x + dx, y + dy}); found != texts_.end())
                return found->second;
    return unknown;
}

// --- Texts ---

std::string fixed_text(double value, int digits) {
    std::array<char, 400> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::fixed, digits)
                         .ptr;
    std::string text(buffer.data(), end);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.ends_with('.')) text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

double fitting_size(const std::string& text, double size, double width) {
    const double needed = text_width(text, "", GraphFont{size, false});
    return needed > width ? std::max(0.5, size * width / needed) : size;
}

std::string hex_colour(const Colour& colour) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string text = "#";
    for (const double part : {colour.red, colour.green, colour.blue}) {
        const long value = std::lround(255 * std::clamp(part, 0.0, 1.0));
        text += digits[value / 16];
        text += digits[value % 16];
    }
    return text;
}

std::string escaped_latex(std::string_view text) {
    static const std::map<std::string_view, const char*> special{{"\\", "\\textbackslash{}"},
                                                                 {"^", "\\textasciicircum{}"},
                                                                 {"~", "\\textasciitilde{}"},
                                                                 {"{", "\\{"},
                                                                 {"}", "\\}"},
                                                                 {"#", "\\#"},
                                                                 {"$", "\\$"},
                                                                 {"%", "\\%"},
                                                                 {"&", "\\&"},
                                                                 {"_", "\\_"},
                                                                 {"<", "\\textless{}"},
                                                                 {">", "\\textgreater{}"},
                                                                 {"|", "\\textbar{}"},
                                                                 {"\"", "\\char34{}"},
                                                                 {"°", "$^\\circ$"},
                                                                 {"ε", "$\\varepsilon$"},
                                                                 {"×", "$\\times$"},
                                                                 {"√", "$\\surd$"},
                                                                 {"→", "$\\to$"},
                                                                 {"…", "\\dots{}"},
                                                                 {"π", "$\\pi$"}};
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t size = 1;
        while (i + size < text.size() && (text[i + size] & 0xc0) == 0x80) ++size;
        const std::string_view character = text.substr(i, size);
        const auto found = special.find(character);
        if (character == "\n")
            out += ' ';
        else if (found == special.end())
            out += character;
        else
            out += found->second;
        i += size;
    }
    return out;
}

std::string letter_latex(std::string_view name) {
    static const std::map<std::string_view, const char*> special{
        {"\\", "\\backslash "}, {"^", "{\\wedge}"}, {"~", "{\\sim}"},   {"{", "\\{"},
        {"}", "\\}"},           {"#", "\\#"},       {"$", "\\$"},       {"%", "\\%"},
        {"&", "\\&"},           {"_", "\\_"},       {"'", "{\\prime}"}, {"\"", "{\\prime\\prime}"},
        {"-", "{-}"},           {"+", "{+}"},       {"*", "{*}"},       {"/", "{/}"},
        {"|", "{|}"},           {" ", "\\;"},       {"<", "{<}"},       {">", "{>}"},
        {"=", "{=}"},           {":", "{:}"},       {"!", "{!}"},       {",", "{,}"},
        {"[", "{[}"},           {"]", "{]}"},       {"@", "{@}"},       {"`", "\\grave{}"},
        {"ε", "\\varepsilon"},  {"×", "\\times "},  {"°", "^\\circ"},   {"√", "\\surd "},
        {"…", "\\dots "},       {"π", "\\pi "}};
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    std::string out;
    for (std::size_t i = 0; i < name.size();) {
        std::size_t size = 1;
        if (plain(name[i])) {
            while (i + size < name.size() && plain(name[i + size])) ++size;
            const std::string_view run = name.substr(i, size);
            const bool digits = run.find_first_not_of("0123456789") == std::string_view::npos;
            out += size == 1 || digits ? std::string(run) : "\\mathit{" + std::string(run) + "}";
            // A subscript of one letter or of digits, as names have it.
            if (i + size < name.size() && name[i + size] == '_' && size == 1) {
                std::size_t more = 1;
                while (i + size + more < name.size() && plain(name[i + size + more])) ++more;
                if (more > 1) {
                    out += "_{" + std::string(name.substr(i + size + 1, more - 1)) + "}";
                    size += more;
                }
            }
            i += size;
            continue;
        }
        while (i + size < name.size() && (name[i + size] & 0xc0) == 0x80) ++size;
        const std::string_view character = name.substr(i, size);
        const auto found = special.find(character);
        if (found != special.end())
            out += found->second;
        else if (size > 1)
            out += "\\text{" + std::string(character) + "}";
        else
            out += character;
        i += size;
    }
    return out;
}

std::string plain_name(std::string_view letter) {
    static constexpr char digits[] = "0123456789ABCDEF";
    std::string out;
    for (const char c : letter) {
        const auto byte = static_cast<unsigned char>(c);
        if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_')
            out += c;
        else
            (out += 'u') += {digits[byte / 16], digits[byte % 16]};
    }
    return out;
}

// --- All formats ---

FigureTextDrawn draw_as_text(std::span<const FigureSource> figures, const Target& target,
                             FigureFormat format, const FigureTextOptions& options,
                             const Budget& budget, Progress* progress) {
    std::vector<Plate> plates;
    for (const FigureSource& source : figures) plates.push_back(source.plate);
    const bool one = plates.size() == 1 && !options.panels;
    const Plan decided =
        plan(plates, PictureFormat::svg, one ? Arrangement::one : Arrangement::panels,
             options.picture, budget);
    const bool laid_out =
        format == FigureFormat::tex || format == FigureFormat::typ || format == FigureFormat::svg;
    FigureTextDrawn drawn;
    FigureDocument document;
    document.plan = &decided;
    document.options = &options;
    if (laid_out) {
        drawn.width = decided.page.width;
        drawn.height = decided.page.height;
    }
    std::function<void(const SvgStream&)> draw;  // of one figure of many strokes
    document.head = options.picture.title;
    if (document.head.empty()) document.head = plates.front().name;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const Figure& figure = *plates[i].figure;
        PlacedFigure& placed = document.figures.emplace_back();
        placed.source = &figures[i];
        placed.cell = decided.page.cells[i];
        placed.width = decided.widths[i];
        if (figure.box().empty) drawn.blank.push_back(i);
        const std::vector<std::string> colours = colours_of(figure, options.picture);
        if (!names_letters(figure, format, options.plotter)) {
            const auto runs = [&placed, colours, &decided, &budget,
                               &drawn](const SvgStream* stream) {
                svg_runs(placed, colours, std::max(decided.page.width, decided.page.height), budget,
                         drawn, stream);
            };
            if (figures.size() == 1)
                draw = [runs](const SvgStream& stream) { runs(&stream); };
            else
                runs(nullptr);
            if (progress)
                progress->report(0.7 * static_cast<double>(i + 1) /
                                 static_cast<double>(figures.size()));
            continue;
        }
        placed.paths = paths_of(figures[i], colours, placed.width, placed.cell.frame.scale, budget);
        if (figure.is_layered() && laid_out && !options.plotter)
            leave_out_hidden(placed.paths, placed.cell, budget);
        if (options.plotter) {
            drawn.travelled += travel_of(placed.paths);
            const double size = std::max(figure.box().breadth(), figure.box().height());
            placed.paths = for_plotter(placed.paths, std::max(size, 1e-300) * 1e-9, budget, drawn);
            drawn.travel += travel_of(placed.paths);
        }
        drawn.strokes += placed.paths.strokes;
        drawn.polygons += placed.paths.polygons;
        drawn.paths += placed.paths.paths.size() - placed.paths.polygons;
        if (progress)
            progress->report(0.7 * static_cast<double>(i + 1) /
                             static_cast<double>(figures.size()));
    }
    if (format == FigureFormat::svg) {
        write_to(target, [&](Output& output) { write_svg(document, output, draw); });
        if (progress) progress->report(1);
        return drawn;
    }
    budget.check_memory(60 * (drawn.strokes + drawn.polygons), "the text of the figures");
    std::string text;
    switch (format) {
        case FigureFormat::tex:
            text = tikz_text(document);
            break;
        case FigureFormat::typ:
            text = typst_text(document);
            break;
        case FigureFormat::csv:
            text = csv_text(document, drawn);
            break;
        case FigureFormat::geojson:
            text = geojson_text(document, drawn);
            break;
        case FigureFormat::dxf:
            text = dxf_text(document);
            break;
        case FigureFormat::html:
            text = page_text(document);
            break;
        case FigureFormat::abc:
            text = abc_text(document, drawn);
            break;
        case FigureFormat::mid:
            text = midi_text(document, drawn);
            break;
        case FigureFormat::svg:
            break;  // written above
    }
    write_to(target, [&](Output& output) { output.write(text.data(), text.size()); });
    if (progress) progress->report(1);
    return drawn;
}

}  // namespace algae
