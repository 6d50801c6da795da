#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "render/detail/document.hpp"
#include "render/detail/figure_text.hpp"
#include "render/detail/graph.hpp"
#include "render/detail/palette.hpp"

// Figures for browsers: an SVG document with names for its parts, and a page that shows figures and how they come to be.
//
// SVG: the document has a title and a description, each figure is a group `figure-N`, within it is a group `figure-N-colour-K` wherever
// a colour begins (-2, -3 where it comes again), and the strokes that follow each other in one colour, width and letter are a path whose
// classes are `colour-N`, `width-N` and `letter-F`: a style sheet at the head says what these look like, and a person changes them there.
// Where there are hundreds of colours, paths say their own.
// Points are relative to the one before, in hundredths of a point, and errors do not add up, because each step goes to the rounded place of
// the next point. That takes about ten bytes a stroke.
//
// A figure of many strokes is written while it is drawn, without the letters, as asking for these takes longer than all the rest. Its points
// are whole numbers of a unit: a hundredth of a point, or less where strokes are shorter, but such that a page has fewer than 2^24. Then
// programs that read the steps add them without error even in single precision. A curve on a lattice comes in blocks (StrokeBlock): what
// a letter draws in its last steps, by letter and heading. The text of a block is made once, its places rounded as seen from
// where the block begins, and copied; only its first step is worked out each time, from where the block begins in truth. So a point is
// within a unit of its place on the lattice, however long the word is: half a unit for the beginning, half for the place in the block.
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

/// More colours than these, as the light on a figure in space makes them, have no classes.
constexpr std::size_t most_named_colours = 400;

std::string classes(const PathStyle& style, bool filled, const std::vector<Colour>& colours,
                    const std::vector<double>& widths) {
    std::string out = filled ? "area" : "stroke";
    if (colours.size() <= most_named_colours)
        out += " colour-" +
               std::to_string(std::ranges::find(colours, style.colour) - colours.begin() + 1);
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

/// How many strokes a block has at least that is kept as text: its first step is worked out each time.
constexpr std::size_t strokes_of_kept = 8;
constexpr std::size_t piece_size = std::size_t{1} << 18;  // bytes of text in one piece

/// Writes strokes as steps as they come, in whole numbers of a unit.
class StepCanvas final : public BlockCanvas {
public:
    /// `units`: how many a point has. `stream` may be missing.
    StepCanvas(const Palette& palette, double width, const Frame& frame, double units,
               const Budget& budget, FigurePaths& styles, const SvgStream* stream)
        : palette_(palette),
          budget_(budget),
          stream_(stream),
          frame_{frame.scale * units, frame.x * units, frame.y * units},
          line_width_(width / frame.scale),
          scale_(frame.scale),
          width_(width),
          styles_(styles) {
        now_.width = width;
    }

    void move_to(Point point) override { pen_ = point, down_ = false; }
    void line_to(Point point) override {
        set_down();
        step('l', unit_of(point));
        pen_ = point;
        if (++strokes % 65536 == 0) check();
    }
    void block(const StrokeBlock& block, Point from) override {
        keeps_style_ = true;
        if (block.strokes.size() < strokes_of_kept) {
            for (const StrokeBlock::Stroke& stroke : block.strokes) {
                const Point to{from.x + stroke.to.x, from.y + stroke.to.y};
                stroke.lifted ? move_to(to) : line_to(to);
            }
            return;
        }
        const KeptText& text = kept(block);
        const Unit start = unit_of(from);
        const Unit first{start.x + text.first.x, start.y + text.first.y};
        if (block.strokes.front().lifted) {
            if (changed_) begin_run(false);
            step('m', first);
            ++paths;
            down_ = true;
        } else {
            set_down();
            step('l', first);
        }
        make_room(text.rest.size());
        settled_text() += text.rest;
        here_ = {start.x + text.last.x, start.y + text.last.y};
        pen_ = {from.x + block.strokes.back().to.x, from.y + block.strokes.back().to.y};
        strokes += text.strokes;
        paths += text.lifts;
        if ((++blocks_ & 0xff) == 0) check();
    }
    void polygon(std::span<const Point> corners) override {
        begin_run(true);
        char kind = 'm';
        for (const Point& corner : corners) {
            step(kind, unit_of(corner));
            kind = 'l';
        }
        settled_text() += 'z';
        changed_ = true;
        down_ = false;
        if (++polygons % 4096 == 0) check();
    }
    void width(double factor) override { set_width(narrowed(width_, factor)); }
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
        if (palette_.runs_along()) changed_ = true;
    }
    bool wants_position() const override { return palette_.runs_along(); }
    double line_width() const override { return line_width_; }

    /// What was drawn, in the end.
    std::vector<SvgRun> finish() {
        if (text_) settled_text();
        return std::move(runs_);
    }

    std::uint64_t strokes = 0, polygons = 0, paths = 0;

private:
    /// A place in whole units.
    struct Unit {
        long long x = 0, y = 0;
    };
    /// A step that was written before: few different ones occur.
    struct Known {
        std::int32_t x = 0, y = 0;
        std::uint8_t size = 0;
        std::array<char, 23> text{};
    };
    /// The text of a block from its second stroke on; places are seen from where it begins.
    struct KeptText {
        bool made = false;
        Unit first, last;
        std::string rest;
        std::uint64_t strokes = 0, lifts = 0;  // lifts: behind the first
    };

    /// As std::llround, without a call.
    static long long nearest(double value) {
        return static_cast<long long>(value + std::copysign(0.5, value));
    }
    Unit unit_of(Point point) const {
        const Point there = frame_(point);
        must_be_finite(there.x + there.y);
        return {nearest(there.x), nearest(there.y)};
    }
    const KeptText& kept(const StrokeBlock& block) {
        if (block.number >= kept_.size()) kept_.resize(block.number + 1);
        KeptText& text = kept_[block.number];
        if (text.made) return text;
        text.made = true;
        for (const StrokeBlock::Stroke& stroke : block.strokes) {
            const Unit to{std::llround(frame_.scale * stroke.to.x),
                          std::llround(-frame_.scale * stroke.to.y)};
            const bool is_first = &stroke == &block.strokes.front();
            if (is_first)
                text.first = to;
            else
                put_step(text.rest, stroke.lifted ? 'm' : 'l', to.x - text.last.x,
                         to.y - text.last.y);
            text.last = to;
            if (!stroke.lifted)
                ++text.strokes;
            else if (!is_first)
                ++text.lifts;
        }
        return text;
    }
    void set_width(double width) {
        if (width == now_.width) return;
        now_.width = width;
        changed_ = true;
    }
    /// Begins a path where the pen stands, unless it goes on.
    void set_down() {
        if (changed_) begin_run(false);
        if (down_) return;
        step('m', unit_of(pen_));
        down_ = true;
        ++paths;
    }
    void begin_run(bool filled) {
        if (text_) settled_text();
        changed_ = false;
        const std::uint32_t shade =
            painted_ ? Palette::no_shade : palette_.shade(index_, fraction_);
        const std::pair looks{shade, now_.width};
        if (!filled && looks == looks_ && !runs_.empty() && !runs_.back().filled) return;
        looks_ = painted_ || filled ? std::pair{Palette::no_shade, -1.0} : looks;
        now_.colour = painted_ ? *painted_ : palette_.colour(shade);
        auto found = std::ranges::find(styles_.styles, now_);
        if (found == styles_.styles.end())
            found = styles_.styles.insert(styles_.styles.end(), now_);
        const auto style = static_cast<std::uint32_t>(found - styles_.styles.begin());
        if (!runs_.empty() && runs_.back().style == style && runs_.back().filled == filled &&
            !filled)
            return;
        runs_.push_back({style, filled, {}});
        text_ = &runs_.back().steps.emplace_back();
        down_ = false;
        here_ = {};
    }
    void step(char kind, Unit to) {
        const long long across = to.x - here_.x, down = to.y - here_.y;
        here_ = to;
        make_room(2 * 21);
        constexpr long long most = 1 << 30;
        if (kind == 'm' || std::abs(across) > most || std::abs(down) > most) {
            put_step(settled_text(), kind, across, down);
            return;
        }
        const std::size_t place = (static_cast<std::uint32_t>(across) * 0x9e3779b1u +
                                   static_cast<std::uint32_t>(down) * 0x85ebca77u) >>
                                  (32 - known_bits);
        Known& known = known_[place];
        if (known.size == 0 || known.x != across || known.y != down) {
            std::string made;
            put_step(made, kind, across, down);
            known.x = static_cast<std::int32_t>(across);
            known.y = static_cast<std::int32_t>(down);
            if (made.size() > known.text.size()) {
                known.size = 0;
                settled_text() += made;
                return;
            }
            known.size = static_cast<std::uint8_t>(made.size());
            std::ranges::copy(made, known.text.begin());
        }
        if (fresh_size_ + known.text.size() > fresh_.size()) settled_text();
        // All bytes, as their number is known then.
        std::memcpy(fresh_.data() + fresh_size_, known.text.data(), known.text.size());
        fresh_size_ += known.size;
    }
    /// The text, with all steps in it.
    std::string& settled_text() {
        if (fresh_size_ > 0) text_->append(fresh_.data(), fresh_size_);
        fresh_size_ = 0;
        return *text_;
    }
    /// Long texts are kept in pieces, so that they are not copied as they grow.
    void make_room(std::size_t bytes) {
        if (stream_ && keeps_style_ && !is_streaming_) begin_streaming();
        if (text_->size() + bytes <= piece_size || text_->size() < piece_size / 2) return;
        settled_text();
        if (is_streaming_) {
            stream_->output.write(text_->data(), text_->size());
            text_->clear();
            return;
        }
        text_ = &runs_.back().steps.emplace_back();
        text_->reserve(piece_size);
    }
    /// A figure that sends a block, if only an empty one, keeps its style: what stands before its strokes is known.
    void begin_streaming() {
        if (runs_.size() != 1) return;
        is_streaming_ = true;
        stream_->begin(runs_.front().style);
        text_->reserve(piece_size);
    }
    static void put_step(std::string& out, char kind, long long x, long long y) {
        if (kind == 'm' || (x != 0 && y != 0) || (x == 0 && y == 0)) {
            out += kind;
            put_whole(out, x);
            if (y >= 0) out += ' ';
            put_whole(out, y);
        } else {
            out += y == 0 ? 'h' : 'v';
            put_whole(out, y == 0 ? x : y);
        }
    }
    static void put_whole(std::string& out, long long number) {
        std::array<char, 24> digits;
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
        out.append(digits.data(), end);
    }
    void check() const {
        budget_.check();
        std::uint64_t bytes = 0;
        for (const SvgRun& run : runs_) {
            bytes += sizeof(SvgRun);
            for (const std::string& piece : run.steps) bytes += piece.capacity();
        }
        budget_.check_memory(bytes, "the text of the figures");
    }

    const Palette& palette_;
    const Budget& budget_;
    const SvgStream* stream_;
    bool keeps_style_ = false, is_streaming_ = false;
    const Frame frame_;  // to units
    double line_width_, scale_, width_;
    FigurePaths& styles_;
    PathStyle now_;
    std::vector<SvgRun> runs_;
    std::string* text_ = nullptr;
    std::array<char, 4096> fresh_{};  // steps that come behind the text
    std::size_t fresh_size_ = 0;
    Point pen_{};
    bool down_ = false, changed_ = true;
    Unit here_;
    double fraction_ = 0;
    std::uint32_t index_ = 0;
    std::optional<Colour> painted_;
    std::pair<std::uint32_t, double> looks_{Palette::no_shade, -1};  // of the run, if listed
    static constexpr int known_bits = 11;
    std::array<Known, 1 << known_bits> known_{};
    std::vector<KeptText> kept_;  // by the numbers of blocks
    std::uint64_t blocks_ = 0;
};

}  // namespace

double svg_units(double page, double step) {
    constexpr double exact = 1 << 24, fine = 16;  // whole numbers of single precision; units a step
    double units = steps_of_point;
    while (step * units < fine && page * units * 10 < exact) units *= 10;
    return units;
}

void svg_runs(PlacedFigure& placed, const std::vector<std::string>& colours, double page,
              const Budget& budget, FigureTextDrawn& drawn, const SvgStream* stream) {
    constexpr std::uint32_t hues = 360;
    const Palette palette(colours, hues);
    const Figure& figure = *placed.source->plate.figure;
    placed.units = svg_units(page, figure.facts().step * placed.cell.frame.scale);
    placed.in_units = true;
    placed.paths.strokes = figure.strokes().value_or(0);
    StepCanvas canvas(palette, placed.width, placed.cell.frame, placed.units, budget, placed.paths,
                      stream);
    figure.draw(canvas, 0, budget);
    drawn.strokes += canvas.strokes;
    drawn.polygons += canvas.polygons;
    drawn.paths += canvas.paths;
    placed.paths.strokes = canvas.strokes;
    placed.paths.polygons = canvas.polygons;
    placed.runs = canvas.finish();
}

namespace {

/// Groups of what follows each other in one colour: `figure-1-colour-2`, and `figure-1-colour-2-2` where it comes again.
class ColourGroups {
public:
    ColourGroups(std::string figure, const std::vector<Colour>& colours)
        : figure_(std::move(figure)), colours_(colours), begun_(colours.size()) {}

    /// What stands before a path of this colour.
    std::string before(const Colour& colour) {
        const auto number =
            static_cast<std::size_t>(std::ranges::find(colours_, colour) - colours_.begin());
        if (current_ == number) return {};
        std::string out = after();
        current_ = number;
        out += "<g id=\"" + figure_ + "-colour-" + std::to_string(number + 1);
        if (++begun_[number] > 1) out += "-" + std::to_string(begun_[number]);
        return out + "\">\n";
    }
    /// What stands behind the last one.
    std::string after() {
        if (!current_) return {};
        current_.reset();
        return "</g>\n";
    }

private:
    std::string figure_;
    const std::vector<Colour>& colours_;
    std::vector<std::size_t> begun_;
    std::optional<std::size_t> current_;
};

/// Whether this is the name that CSS has for the colour of the text around a picture. Everywhere else it is black.
bool is_current_colour(std::string_view name) {
    constexpr std::string_view wanted = "currentcolor";
    return std::ranges::equal(name, wanted, {}, [](char c) { return c | 0x20; });
}

/// Writes a document part by part.
class SvgWriter {
public:
    SvgWriter(const FigureDocument& document, Output& output)
        : document_(document), plan_(*document.plan), output_(output) {}

    /// What stands before the figures. The styles of all of them are known then.
    void head() {
        for (const PlacedFigure& figure : document_.figures) {
            for (const PathStyle& style : figure.paths.styles) {
                if (colours_.size() <= most_named_colours) add_new(colours_, style.colour);
                add_new(widths_, style.width);
            }
            for (const std::string& name : colours_of(*figure.source->plate.figure, plan_.options))
                is_current_ = is_current_ || is_current_colour(name);
        }
        const std::string wide = fixed_text(plan_.page.width, 3),
                          high = fixed_text(plan_.page.height, 3);
        out_ =
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
            "width=\"" +
            wide + "pt\" height=\"" + high + "pt\" viewBox=\"0 0 " + wide + " " + high +
            "\" role=\"img\">\n<title>" + escaped_markup(document_.head) + "</title>\n<desc>";
        for (const PlacedFigure& figure : document_.figures)
            out_ += escaped_markup(figure.source->plate.name + ": " +
                                   std::to_string(figure.paths.strokes) + " strokes. ");
        if (!document_.options->picture.source.empty())
            out_ += "Source: " + escaped_markup(document_.options->picture.source) + ". ";
        if (!document_.options->picture.author.empty())
            out_ += "By " + escaped_markup(document_.options->picture.author) + ". ";
        out_ += "Drawn by algae.</desc>\n<style>\n.stroke { fill: none; stroke-linecap: " +
                std::string(document_.options->picture.flat_ends ? "butt" : "round") +
                "; stroke-linejoin: round; stroke-width: " +
                fixed_text(widths_.empty() ? 1 : widths_[0], 4) + " }\n";
        for (std::size_t i = 0; i < colours_.size() && is_named(); ++i) {
            const std::string name = ".colour-" + std::to_string(i + 1),
                              ink = is_current_ && colours_[i] == Colour{}
                                        ? "currentColor"
                                        : hex_colour(colours_[i]);
            out_ += ".stroke" + name + " { stroke: " + ink + " }\n.area" + name +
                    " { fill: " + ink + " }\n";
        }
        for (std::size_t i = 0; i < widths_.size() && widths_.size() > 1; ++i)
            out_ += ".width-" + std::to_string(i + 1) +
                    " { stroke-width: " + fixed_text(widths_[i], 4) + " }\n";
        for (std::size_t f = 0; f < document_.figures.size(); ++f) {
            const PlacedFigure& figure = document_.figures[f];
            if (!figure.in_units) continue;
            const std::string id = "#figure-" + std::to_string(f + 1);  // in its units
            out_ += id + " .stroke { stroke-width: " +
                    fixed_text(figure.units * (widths_.empty() ? 1 : widths_[0]), 4) + " }\n";
            for (std::size_t i = 0; i < widths_.size() && widths_.size() > 1; ++i)
                out_ += id + " .width-" + std::to_string(i + 1) +
                        " { stroke-width: " + fixed_text(figure.units * widths_[i], 4) + " }\n";
        }
        dark_ = plan_.background && 0.299 * plan_.background->red +
                                            0.587 * plan_.background->green +
                                            0.114 * plan_.background->blue <
                                        0.5;
        out_ += "text { font-family: sans-serif; font-size: " + fixed_text(plan_.font_size, 3) +
                "px; fill: " + ink() + " }\n";
        if (!plan_.options.labels.empty())  // a halo lets them be read on strokes
            out_ += ".label { paint-order: stroke; stroke-linejoin: round; stroke: " +
                    (plan_.background ? hex_colour(*plan_.background) : "#fff") +
                    "; stroke-width: " + fixed_text(plan_.font_size / 4, 3) + " }\n";
        out_ += "</style>\n";
        if (plan_.background)
            out_ += "<rect class=\"background\" width=\"" + wide + "\" height=\"" + high +
                    "\" fill=\"" + hex_colour(*plan_.background) + "\"/>\n";
    }

    void begin_figure(std::size_t f) {
        figure_ = &document_.figures[f];
        const std::string id = "figure-" + std::to_string(f + 1);
        out_ += "<g id=\"" + id + "\" class=\"figure\">\n<title>" +
                escaped_markup(figure_->source->plate.name) + "</title>\n";
        groups_.emplace(id, colours_);
        if (figure_->in_units)
            out_ += "<g class=\"strokes\" transform=\"scale(" + fixed_text(1 / figure_->units, 6) +
                    ")\">\n";
    }
    void begin_run(std::uint32_t number, bool filled) {
        const PathStyle& style = figure_->paths.styles[number];
        begin_path(style, filled);
        flush();
    }
    void end_run(const SvgRun& run) {
        for (const std::string& piece : run.steps) output_.write(piece.data(), piece.size());
        out_ += "\"/>\n";
    }
    void paths() {
        const auto& paths = figure_->paths.paths;
        const PlacedFigure& figure = *figure_;
        for (std::size_t i = 0; i < paths.size();) {
            const FigurePath& first = paths[i];
            begin_path(figure.paths.styles[first.style], first.filled);
            Steps steps(figure.cell.frame);
            do {
                const FigurePath& path = paths[i];
                auto [x, y] = steps.to(path.points.front());
                out_ += 'm';  // the first one is from the corner of the page
                put(out_, x, true);
                put(out_, y, false);
                char last = 'm';  // numbers behind it are a line's
                for (std::size_t k = 1; k < path.points.size(); ++k) {
                    std::tie(x, y) = steps.to(path.points[k]);
                    const char kind = y == 0 ? 'h' : x == 0 ? 'v' : 'l';
                    const bool same = kind == last || (kind == 'l' && last == 'm');
                    if (!same) out_ += kind;
                    if (kind == 'l') {
                        put(out_, x, !same);
                        put(out_, y, false);
                    } else {
                        put(out_, kind == 'h' ? x : y, !same);
                    }
                    last = kind == 'l' && last == 'm' ? 'm' : kind;
                }
                if (path.filled) out_ += 'z';
                ++i;
            } while (i < paths.size() && !first.filled && !paths[i].filled &&
                     paths[i].style == first.style);
            out_ += "\"/>\n";
        }
    }
    /// What stands behind the strokes of a figure.
    void end_figure() {
        const PlacedFigure& figure = *figure_;
        if (is_named()) out_ += groups_->after();
        if (figure.in_units) out_ += "</g>\n";
        for (const PointLabel& label : plan_.options.labels)
            if (const auto place = figure.source->plate.figure->place(label.place)) {
                const Point at =
                    label_corner(plan_, figure.cell.frame(*place),
                                 text_width(label.text, "", GraphFont{plan_.font_size, false}));
                out_ += "<text class=\"label\" x=\"" + fixed_text(at.x, 2) + "\" y=\"" +
                        fixed_text(at.y, 2) + "\">" + escaped_markup(label.text) + "</text>\n";
            }
        double below = figure.cell.caption_top;
        if (plan_.options.scale_bar) {
            const double length = scale_bar_length(figure.cell.width / figure.cell.frame.scale);
            const double x = figure.cell.left, y = below + 0.9 * plan_.font_size,
                         end = x + length * figure.cell.frame.scale, tick = plan_.font_size / 4;
            out_ += "<path class=\"scale-bar\" fill=\"none\" stroke=\"" + ink() + "\" d=\"M" +
                    fixed_text(x, 2) + " " + fixed_text(y - tick, 2) + "v" +
                    fixed_text(2 * tick, 2) + "m0-" + fixed_text(tick, 2) + "H" +
                    fixed_text(end, 2) + "m0-" + fixed_text(tick, 2) + "v" +
                    fixed_text(2 * tick, 2) + "\"/>\n<text x=\"" +
                    fixed_text(end + plan_.font_size / 2, 2) + "\" y=\"" +
                    fixed_text(y + 0.35 * plan_.font_size, 2) + "\">" +
                    rounded_decimal(length, 10) + "</text>\n";
            below += 1.6 * plan_.font_size;
        }
        const std::string& caption = figure.source->plate.caption;
        if (!caption.empty()) {
            const double size = fitting_size(caption, plan_.font_size, figure.cell.width);
            out_ += "<text class=\"caption\" text-anchor=\"middle\" x=\"" +
                    fixed_text(figure.cell.left + figure.cell.width / 2, 2) + "\" y=\"" +
                    fixed_text(below + 1.4 * plan_.font_size, 2) + "\"" +
                    (size < plan_.font_size ? " style=\"font-size: " + fixed_text(size, 3) + "px\""
                                            : "") +
                    ">" + escaped_markup(caption) + "</text>\n";
        }
        out_ += "</g>\n";
        flush();
    }
    void end() {
        out_ += "</svg>\n";
        flush();
    }

private:
    void flush() {
        output_.write(out_.data(), out_.size());
        out_.clear();
    }

    const FigureDocument& document_;
    const Plan& plan_;
    Output& output_;
    std::string out_;
    std::vector<Colour> colours_;
    std::vector<double> widths_;
    bool is_named() const { return colours_.size() <= most_named_colours; }
    void begin_path(const PathStyle& style, bool filled) {
        if (is_named()) out_ += groups_->before(style.colour);
        out_ += "<path class=\"" + classes(style, filled, colours_, widths_) + '"';
        if (!is_named())
            out_ += (filled ? " fill=\"" : " stroke=\"") + hex_colour(style.colour) + '"';
        out_ += " d=\"";
    }
    /// Of texts and bars.
    std::string ink() const { return is_current_ ? "currentColor" : dark_ ? "#fff" : "#000"; }

    bool dark_ = false;        // the background
    bool is_current_ = false;  // black is the colour of the text around the picture
    const PlacedFigure* figure_ = nullptr;
    std::optional<ColourGroups> groups_;
};

}  // namespace

void write_svg(const FigureDocument& document, Output& output,
               const std::function<void(const SvgStream&)>& draw) {
    SvgWriter writer(document, output);
    std::size_t begun = 0;  // figures whose only run is on its way
    if (draw)
        draw({output, [&](std::uint32_t style) {
                  writer.head();
                  writer.begin_figure(0);
                  writer.begin_run(style, false);
                  begun = 1;
              }});
    if (begun == 0) writer.head();
    for (std::size_t f = 0; f < document.figures.size(); ++f) {
        if (begun == 0) writer.begin_figure(f);
        for (const SvgRun& run : document.figures[f].runs) {
            if (begun == 0) writer.begin_run(run.style, run.filled);
            writer.end_run(run);
        }
        writer.paths();
        writer.end_figure();
    }
    writer.end();
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
