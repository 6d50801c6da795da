#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "render/detail/document.hpp"
#include "render/detail/figure_text.hpp"
#include "render/detail/palette.hpp"

// Figures for browsers: an SVG document with names for its parts, and a page that shows figures and how they come to be.
//
// SVG: the document has a title and a description, each figure is a group `figure-N`, and within it the strokes that follow each other
// in one colour, width and letter are a path whose classes are `colour-N`, `width-N` and `letter-F`: a style sheet at the head
// says what these look like, and a person changes them there. Points are relative to the one before, in hundredths of a point, and errors do not
// add up, because each step goes to the rounded place of the next point. That takes about ten bytes a stroke. A figure of many strokes is
// written while it is drawn, without the letters, as asking for these takes longer than all the rest.
//
// The page has the paths of all figures as numbers in the same way and a program of a hundred lines that draws them on a canvas: a slider for
// the generation, one for the strokes drawn so far, and the mouse or the fingers move, turn and zoom. It asks nothing of the network. What a
// link says behind `#` is shown first.

namespace algae {

namespace {

constexpr double steps_of_point = 100;  // coordinates are hundredths of a point

/// Steps from point to point, in whole hundredths.
class Steps {
public:
    explicit Steps(const Frame& frame) : frame_(frame) {}
    std::pair<long long, long long> to(Point point) {
        const Point there = frame_(point);
        const long long x = std::llround(there.x * steps_of_point),
                        y = std::llround(there.y * steps_of_point);
        const std::pair<long long, long long> step{x - x_, y - y_};
        x_ = x;
        y_ = y;
        return step;
    }

private:
    Frame frame_;
    long long x_ = 0, y_ = 0;
};

/// A whole number of hundredths as a decimal; `joined` without a blank before a sign.
void put(std::string& out, long long hundredths, bool joined) {
    if (hundredths < 0)
        out += '-';
    else if (!joined)
        out += ' ';
    const unsigned long long size = hundredths < 0
                                        ? 0ULL - static_cast<unsigned long long>(hundredths)
                                        : static_cast<unsigned long long>(hundredths);
    if (size >= 100 || size == 0) out += std::to_string(size / 100);
    const unsigned long long rest = size % 100;
    if (rest == 0) return;
    out += '.';
    out += static_cast<char>('0' + rest / 10);
    if (rest % 10 > 0) out += static_cast<char>('0' + rest % 10);
}

std::string classes(const PathStyle& style, bool filled, const std::vector<Colour>& colours,
                    const std::vector<double>& widths) {
    std::string out =
        "colour-" + std::to_string(std::ranges::find(colours, style.colour) - colours.begin() + 1);
    if (!filled && widths.size() > 1)
        out +=
            " width-" + std::to_string(std::ranges::find(widths, style.width) - widths.begin() + 1);
    if (!style.letter.empty()) out += " letter-" + plain_name(style.letter);
    return out;
}

template <class Value>
void add_new(std::vector<Value>& values, const Value& value) {
    if (std::ranges::find(values, value) == values.end()) values.push_back(value);
}

}  // namespace

namespace {

/// Writes strokes as steps as they come.
class StepCanvas final : public Canvas {
public:
    StepCanvas(const Palette& palette, double width, const Frame& frame, const Budget& budget,
               FigurePaths& styles)
        : palette_(palette), budget_(budget), frame_(frame), width_(width), styles_(styles) {
        now_.width = width;
    }

    void move_to(Point point) override { pen_ = point, down_ = false; }
    void line_to(Point point) override {
        if (changed_) begin_run(false);
        if (!down_) {
            step('m', pen_);
            down_ = true;
            ++paths;
        }
        step('l', point);
        pen_ = point;
        if (++strokes % 65536 == 0) check();
    }
    void polygon(std::span<const Point> corners) override {
        begin_run(true);
        char kind = 'm';
        for (const Point& corner : corners) {
            step(kind, corner);
            kind = 'l';
        }
        *text_ += 'z';
        changed_ = true;
        down_ = false;
        if (++polygons % 4096 == 0) check();
    }
    void width(double factor) override { set_width(narrowed(width_, factor)); }
    void width_as_length(double length) override { set_width(frame_.scale * std::fabs(length)); }
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
        if (palette_.runs_along()) changed_ = true;
    }
    bool wants_position() const override { return palette_.runs_along(); }
    double line_width() const override { return width_ / frame_.scale; }

    std::vector<SvgRun> runs;
    std::uint64_t strokes = 0, polygons = 0, paths = 0;

private:
    /// A step that was written before: few different ones occur.
    struct Known {
        std::int32_t x = 0, y = 0;
        std::uint8_t size = 0;
        std::array<char, 23> text{};
    };

    void set_width(double width) {
        if (width == now_.width) return;
        now_.width = width;
        changed_ = true;
    }
    void begin_run(bool filled) {
        changed_ = false;
        now_.colour = painted_ ? *painted_ : palette_.colour(palette_.shade(index_, fraction_));
        auto found = std::ranges::find(styles_.styles, now_);
        if (found == styles_.styles.end())
            found = styles_.styles.insert(styles_.styles.end(), now_);
        const auto style = static_cast<std::uint32_t>(found - styles_.styles.begin());
        if (!runs.empty() && runs.back().style == style && runs.back().filled == filled && !filled)
            return;
        runs.push_back({style, filled, {}});
        text_ = &runs.back().steps;
        down_ = false;
        x_ = y_ = 0;
    }
    void step(char kind, Point point) {
        const Point there = frame_(point);
        must_be_finite(there.x + there.y);
        const auto x = std::llround(there.x * steps_of_point),
                   y = std::llround(there.y * steps_of_point);
        const long long across = x - x_, down = y - y_;
        x_ = x;
        y_ = y;
        constexpr long long most = 1 << 30;
        if (kind == 'm' || std::abs(across) > most || std::abs(down) > most) {
            put_step(*text_, kind, across, down);
            return;
        }
        const std::size_t place =
            static_cast<std::size_t>(across * 31 + down) & (known_.size() - 1);
        Known& known = known_[place];
        if (known.size == 0 || known.x != across || known.y != down) {
            std::string made;
            put_step(made, kind, across, down);
            known.x = static_cast<std::int32_t>(across);
            known.y = static_cast<std::int32_t>(down);
            if (made.size() > known.text.size()) {
                known.size = 0;
                *text_ += made;
                return;
            }
            known.size = static_cast<std::uint8_t>(made.size());
            std::ranges::copy(made, known.text.begin());
        }
        text_->append(known.text.data(), known.size);
    }
    static void put_step(std::string& out, char kind, long long x, long long y) {
        if (kind == 'm' || (x != 0 && y != 0) || (x == 0 && y == 0)) {
            out += kind;
            put(out, x, true);
            put(out, y, false);
        } else {
            out += y == 0 ? 'h' : 'v';
            put(out, y == 0 ? x : y, true);
        }
    }
    void check() const {
        budget_.check();
        std::uint64_t bytes = 0;
        for (const SvgRun& run : runs) bytes += run.steps.capacity() + sizeof(SvgRun);
        budget_.check_memory(2 * bytes, "the text of the figures");
    }

    const Palette& palette_;
    const Budget& budget_;
    const Frame frame_;
    double width_;
    FigurePaths& styles_;
    PathStyle now_;
    std::string* text_ = nullptr;
    Point pen_{};
    bool down_ = false, changed_ = true;
    long long x_ = 0, y_ = 0;
    double fraction_ = 0;
    std::uint32_t index_ = 0;
    std::optional<Colour> painted_;
    std::array<Known, 1024> known_{};
};

}  // namespace

std::vector<SvgRun> svg_runs(const FigureSource& source, const std::vector<std::string>& colours,
                             double width, const Frame& frame, const Budget& budget,
                             FigurePaths& styles, FigureTextDrawn& drawn) {
    constexpr std::uint32_t hues = 360;
    const Palette palette(colours, hues);
    StepCanvas canvas(palette, width, frame, budget, styles);
    source.plate.figure->draw(canvas, 0, budget);
    drawn.strokes += canvas.strokes;
    drawn.polygons += canvas.polygons;
    drawn.paths += canvas.paths;
    styles.strokes = canvas.strokes;
    return std::move(canvas.runs);
}

std::string svg_text(const FigureDocument& document) {
    const Plan& plan = *document.plan;
    std::vector<Colour> colours;
    std::vector<double> widths;
    for (const PlacedFigure& figure : document.figures)
        for (const PathStyle& style : figure.paths.styles) {
            add_new(colours, style.colour);
            add_new(widths, style.width);
        }
    const std::string wide = fixed_text(plan.page.width, 3), high = fixed_text(plan.page.height, 3);
    std::string out =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "width=\"" +
        wide + "pt\" height=\"" + high + "pt\" viewBox=\"0 0 " + wide + " " + high +
        "\" role=\"img\">\n<title>" + escaped_markup(document.head) + "</title>\n<desc>";
    for (const PlacedFigure& figure : document.figures)
        out += escaped_markup(figure.source->plate.name + ": " +
                              std::to_string(figure.paths.strokes) + " strokes. ");
    if (!document.options->picture.source.empty())
        out += "Source: " + escaped_markup(document.options->picture.source) + ". ";
    if (!document.options->picture.author.empty())
        out += "By " + escaped_markup(document.options->picture.author) + ". ";
    out +=
        "Drawn by algae.</desc>\n<style>\n.stroke { fill: none; stroke-linecap: " +
        std::string(document.options->picture.flat_ends ? "butt" : "round") +
        "; stroke-linejoin: round; stroke-width: " + fixed_text(widths.empty() ? 1 : widths[0], 4) +
        " }\n";
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const std::string name = ".colour-" + std::to_string(i + 1), hex = hex_colour(colours[i]);
        out += ".stroke" + name + " { stroke: " + hex + " }\n.area" + name + " { fill: " + hex +
               " }\n";
    }
    for (std::size_t i = 0; i < widths.size() && widths.size() > 1; ++i)
        out += ".width-" + std::to_string(i + 1) + " { stroke-width: " + fixed_text(widths[i], 4) +
               " }\n";
    const bool dark = plan.background && 0.299 * plan.background->red +
                                                 0.587 * plan.background->green +
                                                 0.114 * plan.background->blue <
                                             0.5;
    out += "text { font-family: sans-serif; font-size: " + fixed_text(plan.font_size, 3) +
           "px; fill: " + (dark ? "#fff" : "#000") + " }\n</style>\n";
    if (plan.background)
        out += "<rect class=\"background\" width=\"" + wide + "\" height=\"" + high + "\" fill=\"" +
               hex_colour(*plan.background) + "\"/>\n";
    for (std::size_t f = 0; f < document.figures.size(); ++f) {
        const PlacedFigure& figure = document.figures[f];
        const auto& paths = figure.paths.paths;
        out += "<g id=\"figure-" + std::to_string(f + 1) + "\" class=\"figure\">\n<title>" +
               escaped_markup(figure.source->plate.name) + "</title>\n";
        for (const SvgRun& run : figure.runs) {
            out += std::string("<path class=\"") + (run.filled ? "area " : "stroke ") +
                   classes(figure.paths.styles[run.style], run.filled, colours, widths) +
                   "\" d=\"" + run.steps + "\"/>\n";
        }
        for (std::size_t i = 0; i < paths.size();) {
            const FigurePath& first = paths[i];
            out += std::string("<path class=\"") + (first.filled ? "area " : "stroke ") +
                   classes(figure.paths.styles[first.style], first.filled, colours, widths) +
                   "\" d=\"";
            Steps steps(figure.cell.frame);
            do {
                const FigurePath& path = paths[i];
                auto [x, y] = steps.to(path.points.front());
                out += 'm';  // the first one is from the corner of the page
                put(out, x, true);
                put(out, y, false);
                char last = 'm';  // numbers behind it are a line's
                for (std::size_t k = 1; k < path.points.size(); ++k) {
                    std::tie(x, y) = steps.to(path.points[k]);
                    const char kind = y == 0 ? 'h' : x == 0 ? 'v' : 'l';
                    const bool same = kind == last || (kind == 'l' && last == 'm');
                    if (!same) out += kind;
                    if (kind == 'l') {
                        put(out, x, !same);
                        put(out, y, false);
                    } else {
                        put(out, kind == 'h' ? x : y, !same);
                    }
                    last = kind == 'l' && last == 'm' ? 'm' : kind;
                }
                if (path.filled) out += 'z';
                ++i;
            } while (i < paths.size() && !first.filled && !paths[i].filled &&
                     paths[i].style == first.style);
            out += "\"/>\n";
        }
        for (const PointLabel& label : plan.options.labels)
            if (const auto place = figure.source->plate.figure->place(label.place)) {
                const Point at = figure.cell.frame(*place);
                out += "<text class=\"label\" x=\"" + fixed_text(at.x + plan.font_size / 4, 2) +
                       "\" y=\"" + fixed_text(at.y - plan.font_size / 4, 2) + "\">" +
                       escaped_markup(label.text) + "</text>\n";
            }
        double below = figure.cell.caption_top;
        if (plan.options.scale_bar) {
            const double length = scale_bar_length(figure.cell.width / figure.cell.frame.scale);
            const double x = figure.cell.left, y = below + 0.9 * plan.font_size,
                         end = x + length * figure.cell.frame.scale, tick = plan.font_size / 4;
            out += "<path class=\"scale-bar\" fill=\"none\" stroke=\"" +
                   std::string(dark ? "#fff" : "#000") + "\" d=\"M" + fixed_text(x, 2) + " " +
                   fixed_text(y - tick, 2) + "v" + fixed_text(2 * tick, 2) + "m0-" +
                   fixed_text(tick, 2) + "H" + fixed_text(end, 2) + "m0-" + fixed_text(tick, 2) +
                   "v" + fixed_text(2 * tick, 2) + "\"/>\n<text x=\"" +
                   fixed_text(end + plan.font_size / 2, 2) + "\" y=\"" +
                   fixed_text(y + 0.35 * plan.font_size, 2) + "\">" + rounded_decimal(length, 10) +
                   "</text>\n";
            below += 1.6 * plan.font_size;
        }
        const std::string& caption = figure.source->plate.caption;
        if (!caption.empty()) {
            const double size = fitting_size(caption, plan.font_size, figure.cell.width);
            out += "<text class=\"caption\" text-anchor=\"middle\" x=\"" +
                   fixed_text(figure.cell.left + figure.cell.width / 2, 2) + "\" y=\"" +
                   fixed_text(below + 1.4 * plan.font_size, 2) + "\"" +
                   (size < plan.font_size ? " style=\"font-size: " + fixed_text(size, 3) + "px\""
                                          : "") +
                   ">" + escaped_markup(caption) + "</text>\n";
        }
        out += "</g>\n";
    }
    return out + "</svg>\n";
}

// --- A page ---

namespace {

constexpr const char* page_head = R"(<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<style>
body { font-family: sans-serif; margin: 0; display: flex; flex-direction: column; height: 100vh; color: #222; background: #fff }
header, footer { padding: 0.5em 1em; flex: none }
h1 { font-size: 1.1em; margin: 0 }
p { margin: 0.2em 0 0; font-size: 0.85em; color: #555 }
#stage { flex: 1; min-height: 0; position: relative }
canvas { position: absolute; width: 100%; height: 100%; cursor: grab; touch-action: none }
footer { display: flex; flex-wrap: wrap; gap: 0.3em 1.5em; align-items: center; border-top: 1px solid #ddd; font-size: 0.9em }
label { display: flex; gap: 0.5em; align-items: center }
input[type=range] { width: 14em }
output { min-width: 7em }
[hidden] { display: none }
</style>
)";

constexpr const char* page_program = R"(
const canvas = document.getElementById("picture"), pen = canvas.getContext("2d");
const generation = document.getElementById("generation"), strokes = document.getElementById("strokes");
let view = {x: 0, y: 0, zoom: 1, turn: 0}, playing = 0;
const shown = () => figures[+generation.value];

function total(figure) {
    return figure.paths.reduce((sum, path) => sum + (path[1] ? 1 : path.length / 2 - 2), 0);
}
function draw() {
    const ratio = window.devicePixelRatio || 1, figure = shown();
    canvas.width = canvas.clientWidth * ratio;
    canvas.height = canvas.clientHeight * ratio;
    const fit = 0.94 * Math.min(canvas.width / (figure.width || 1), canvas.height / (figure.height || 1));
    const scale = fit * view.zoom;
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.translate(canvas.width / 2 + view.x * ratio, canvas.height / 2 + view.y * ratio);
    pen.rotate(view.turn);
    pen.scale(scale, scale);
    pen.translate(-figure.width / 2, -figure.height / 2);
    pen.lineCap = pen.lineJoin = "round";
    let left = +strokes.value, tip = null, letter = "";
    for (const path of figure.paths) {
        if (left <= 0) break;
        const style = figure.styles[path[0]];
        let x = path[2], y = path[3];
        pen.beginPath();
        pen.moveTo(x, y);
        for (let i = 4; i < path.length && (path[1] || left > 0); i += 2) {
            pen.lineTo(x += path[i], y += path[i + 1]);
            if (!path[1]) --left;
        }
        if (path[1]) {
            --left;
            pen.fillStyle = style.colour;
            pen.fill();
        } else {
            pen.strokeStyle = style.colour;
            pen.lineWidth = Math.max(style.width * 100, 0.7 * ratio / scale);
            pen.stroke();
        }
        tip = [x, y];
        letter = style.letter;
    }
    const all = total(figure);
    if (tip && +strokes.value < all) {
        pen.beginPath();
        pen.arc(tip[0], tip[1], 5 * ratio / scale, 0, 7);
        pen.fillStyle = "#d22";
        pen.fill();
    }
    document.getElementById("name").textContent = figure.name;
    document.getElementById("count").textContent = strokes.value + " of " + all + (letter ? ", " + letter : "");
    document.title = figure.name;
    canvas.dataset.drawn = strokes.value;
}
function choose() {
    strokes.max = total(shown());
    strokes.value = strokes.max;
    draw();
}
function play() {
    cancelAnimationFrame(playing);
    const all = total(shown()), begin = performance.now(), time = Math.min(15000, 500 + 100 * all);
    const step = now => {
        strokes.value = Math.min(all, Math.ceil(all * (now - begin) / time));
        draw();
        if (+strokes.value < all) playing = requestAnimationFrame(step);
    };
    playing = requestAnimationFrame(step);
}
const fingers = new Map();
canvas.onpointerdown = event => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, event);
};
canvas.onpointerup = canvas.onpointercancel = event => fingers.delete(event.pointerId);
canvas.onpointermove = event => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    if (fingers.size === 2) {
        const other = [...fingers.values()].find(finger => finger.pointerId !== event.pointerId);
        const was = [before.clientX - other.clientX, before.clientY - other.clientY];
        const is = [event.clientX - other.clientX, event.clientY - other.clientY];
        view.zoom *= Math.hypot(...is) / (Math.hypot(...was) || 1);
        view.turn += Math.atan2(is[1], is[0]) - Math.atan2(was[1], was[0]);
    } else if (event.shiftKey) {
        view.turn += (event.clientX - before.clientX) / 100;
    } else {
        view.x += event.clientX - before.clientX;
        view.y += event.clientY - before.clientY;
    }
    fingers.set(event.pointerId, event);
    draw();
};
canvas.onwheel = event => {
    event.preventDefault();
    const box = canvas.getBoundingClientRect(), factor = Math.exp(-event.deltaY / 400);
    const x = event.clientX - box.left - box.width / 2, y = event.clientY - box.top - box.height / 2;
    view.x = x + (view.x - x) * factor;
    view.y = y + (view.y - y) * factor;
    view.zoom *= factor;
    draw();
};
document.getElementById("reset").onclick = () => { view = {x: 0, y: 0, zoom: 1, turn: 0}; draw(); };
document.getElementById("play").onclick = play;
generation.oninput = choose;
strokes.oninput = () => { cancelAnimationFrame(playing); draw(); };
window.onresize = draw;
generation.max = figures.length - 1;
generation.value = generation.max;
document.getElementById("which").hidden = figures.length < 2;
// A link can say what is shown first: page.html#figure=1&strokes=20&turn=45&zoom=2
const link = new URLSearchParams(location.hash.slice(1));
if (link.has("figure")) generation.value = link.get("figure");
choose();
if (location.hash) {
    if (link.has("strokes")) strokes.value = link.get("strokes");
    if (link.has("turn")) view.turn = link.get("turn") * Math.PI / 180;
    if (link.has("zoom")) view.zoom = +link.get("zoom") || 1;
    draw();
}
)";

}  // namespace

std::string script_string(std::string_view text) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\' || c == '<' || byte < 0x20)
            ((out += "\\u00") += digits[byte / 16]) += digits[byte % 16];
        else
            out += c;
    }
    return out + '"';
}

std::string page_text(const FigureDocument& document) {
    std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<title>" +
                      escaped_markup(document.head) + "</title>\n" + page_head + "<header><h1>" +
                      escaped_markup(document.head) + "</h1><p><span id=\"name\"></span>";
    if (!document.options->picture.source.empty())
        out += " &middot; " + escaped_markup(document.options->picture.source);
    if (!document.options->picture.author.empty())
        out += " &middot; " + escaped_markup(document.options->picture.author);
    out +=
        "</p></header>\n<div id=\"stage\"><canvas id=\"picture\"></canvas></div>\n<footer>\n<label "
        "id=\"which\">figure <input id=\"generation\" type=\"range\" min=\"0\" "
        "step=\"1\"></label>\n<label>strokes <input id=\"strokes\" type=\"range\" min=\"0\" "
        "step=\"1\"><output id=\"count\"></output></label>\n<button "
        "id=\"play\">draw</button>\n<button id=\"reset\">whole</button>\n<span>drag to move, wheel "
        "to zoom, shift and drag to turn</span>\n</footer>\n<script>\n";
    out +=
        "// Of each figure the paths: its style, 1 if it is filled, the first point, then steps, "
        "in hundredths of a point.\n"
        "const figures = [\n";
    for (const PlacedFigure& figure : document.figures) {
        const Box& box = figure.source->plate.figure->box();
        // The page of each figure is the figure.
        Frame frame = figure.cell.frame;
        frame.x = -frame.scale * box.low.x;
        frame.y = frame.scale * box.high.y;
        out += "{name: " + script_string(figure.source->plate.name) +
               ", width: " + fixed_text(frame.scale * box.breadth() * steps_of_point, 0) +
               ", height: " + fixed_text(frame.scale * box.height() * steps_of_point, 0) +
               ", styles: [";
        for (const PathStyle& style : figure.paths.styles)
            out += "{colour: \"" + hex_colour(style.colour) +
                   "\", width: " + fixed_text(style.width, 4) +
                   ", letter: " + script_string(style.letter) + "}, ";
        out += "], paths: [\n";
        for (const FigurePath& path : figure.paths.paths) {
            Steps steps(frame);
            out += "[" + std::to_string(path.style) + (path.filled ? ",1" : ",0");
            for (const Point point : path.points) {
                const auto [x, y] = steps.to(point);
                out += "," + std::to_string(x) + "," + std::to_string(y);
            }
            out += "],\n";
        }
        out += "]},\n";
    }
    return out + "];" + page_program + "</script>\n</html>\n";
}

}  // namespace algae
