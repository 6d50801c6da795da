#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <sstream>

#include "exact/exact.hpp"
#include "render/detail/document.hpp"
#include "render/detail/layout.hpp"
#include "render/detail/palette.hpp"
#include "render/render.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"

// A page that explains a turtle: a sketch of its way, and a table of its steps.
//
// The sketch draws strokes with a number for each step and the turtle at every corner, as it comes (pale) and as it
// leaves, with the arc of the turn between. Steps that happen in one place, one after the other, are one stand with one label. What is
// drawn early is covered by what comes later, so the order is: polygons, lines, pale turtles and arcs, turtles, labels. Lines,
// turtles and arcs are told to LabelPlaces, and each label takes the middle where it is least in the way, within the rectangle
// of the sketch.
//
// The table has a row for each step; columns without anything to say are left out, and meanings are broken into lines. In several
// blocks, a block ends before the row whose middle is in the next one's share of the height.
//
// The page decides where the table goes before anything is drawn: beside the sketch, or below it where one of them is wide or the
// table high. The scale is such that the shortest step has a comfortable length, as far as there is room. Texts are
// measured on a surface of one pixel without hinting, so that they have the same size on every surface.

namespace algae {

std::vector<std::vector<std::string>> explanation_rows(const Explanation& explanation) {
    bool in_space = false, branches = false;
    for (const ExplainedStep& step : explanation.steps) {
        in_space = in_space || step.after.position.z != 0 || !heading_angle(step.after);
        branches = branches || step.open > 0;
    }
    const auto place = [in_space](const Vector& at) {
        return "(" + rounded(at.x) + ", " + rounded(at.y) + (in_space ? ", " + rounded(at.z) : "") +
               ")";
    };
    const auto heading = [&](const TurtleState& state) {
        return in_space ? place(state.attitude.heading())
                        : rounded(heading_angle(state).value_or(0)) + "°";
    };
    const auto row = [&](const std::string& number, const std::string& symbol,
                         const std::string& meaning, const TurtleState& state, std::size_t open) {
        std::vector<std::string> cells{number, symbol, meaning, place(state.position),
                                       heading(state)};
        if (branches) cells.push_back(open == 0 ? "" : std::to_string(open));
        return cells;
    };
    std::vector<std::vector<std::string>> rows;
    rows.push_back({"step", "symbol", "what the turtle does", "then it is at", "heading"});
    if (branches) rows.back().push_back("open [");
    rows.push_back(row("", "", "the start", explanation.start, 0));
    for (std::size_t i = 0; i < explanation.steps.size(); ++i) {
        const ExplainedStep& step = explanation.steps[i];
        rows.push_back(
            row(std::to_string(i + 1), step.symbol, step.meaning, step.after, step.open));
    }
    return rows;
}

namespace {

constexpr double stroke_width = 1.6, turtle_length = 11, label_letters = 8.5, arc_radius = 15;
constexpr Colour turtle_colour = turtle_green, turn_colour{0.75, 0.33, 0.05};

Point in_plane(const Vector& at) { return {at.x, at.y}; }

/// The direction of a heading in the picture, where y points down.
double angle_of(const Attitude& attitude) {
    return std::atan2(-attitude.heading().y, attitude.heading().x);
}

Point beside(Point at, double angle, double distance) {
    return {at.x + distance * std::cos(angle), at.y + distance * std::sin(angle)};
}

/// Places around a point, at each distance first those nearest to a direction.
std::vector<Point> around(Point at, double direction, std::initializer_list<double> distances) {
    std::vector<Point> places;
    for (const double distance : distances)
        for (int i = 0; i < 16; ++i) {
            const double aside = (i + 1) / 2 * (i % 2 == 0 ? -1 : 1) * std::numbers::pi / 8;
            places.push_back(beside(at, direction + aside, distance));
        }
    return places;
}

/// The turtle: an arrowhead with its middle at the point.
void draw_turtle(cairo_t* context, Point at, double angle, bool before) {
    cairo_save(context);
    cairo_translate(context, at.x, at.y);
    cairo_rotate(context, angle);
    const double half = turtle_length / 2;
    cairo_move_to(context, half, 0);
    cairo_line_to(context, -half, 0.36 * turtle_length);
    cairo_line_to(context, -0.55 * half, 0);
    cairo_line_to(context, -half, -0.36 * turtle_length);
    cairo_close_path(context);
    if (before) {
        cairo_set_source_rgb(context, 0.86, 0.93, 0.87);
        cairo_fill_preserve(context);
        set_colour(context, turtle_colour, 0.55);
    } else {
        set_colour(context, turtle_colour);
        cairo_fill_preserve(context);
    }
    cairo_set_line_width(context, 0.6);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(context);
    cairo_restore(context);
}

/// The arc of a turn from one direction to another, with its arrow.
void draw_turn(cairo_t* context, Point at, double from, double by) {
    set_colour(context, turn_colour);
    cairo_set_line_width(context, 0.8);
    cairo_new_path(context);
    if (by > 0)
        cairo_arc(context, at.x, at.y, arc_radius, from, from + by);
    else
        cairo_arc_negative(context, at.x, at.y, arc_radius, from, from + by);
    cairo_stroke(context);
    const double side = by > 0 ? 1 : -1;
    const Point tip = beside(at, from + by, arc_radius);
    const double back = from + by - side * (std::numbers::pi / 2 + 0.14);
    const Point left = beside(tip, back - 0.42, 4.2), right = beside(tip, back + 0.42, 4.2);
    cairo_move_to(context, tip.x, tip.y);
    cairo_line_to(context, left.x, left.y);
    cairo_line_to(context, right.x, right.y);
    cairo_close_path(context);
    cairo_fill(context);
}

void draw_label(cairo_t* context, const LabelPlace& place, const std::string& text,
                const Colour& colour) {
    const double radius = place.height / 2;
    const double left = place.middle.x - place.width / 2, right = left + place.width;
    cairo_new_path(context);
    cairo_arc(context, right - radius, place.middle.y, radius, -std::numbers::pi / 2,
              std::numbers::pi / 2);
    cairo_arc(context, left + radius, place.middle.y, radius, std::numbers::pi / 2,
              3 * std::numbers::pi / 2);
    cairo_close_path(context);
    set_colour(context, {1, 1, 1}, 0.9);
    cairo_fill_preserve(context);
    set_colour(context, colour, 0.5);
    cairo_set_line_width(context, 0.5);
    cairo_stroke(context);
    set_colour(context, colour);
    show_text(context, text, place.middle.x - text_width(context, text) / 2,
              place.middle.y + 0.36 * label_letters);
}

/// The drawing of an explanation: strokes, the turtle at every corner, and the numbers of steps.
class ExplanationSketch {
public:
    ExplanationSketch(const Explanation& explanation, const Palette& palette)
        : explanation_(explanation), palette_(palette) {
        box_.add(in_plane(explanation.start.position));
        for (const ExplainedStep& step : explanation.steps) {
            for (const ExplainedLine& line : step.lines) {
                box_.add(in_plane(line.to));
                const double way = length(line.to - line.from);
                if (way > 0 && (shortest_ == 0 || way < shortest_)) shortest_ = way;
            }
            for (const std::vector<Vector>& corners : step.polygons)
                for (const Vector& corner : corners) box_.add(in_plane(corner));
        }
        find_stands();
    }

    /// The ways from left to right and from top to bottom, 0 or more.
    double breadth() const { return box_.breadth(); }
    double height() const { return box_.height(); }
    /// The length that every step should have room for: of the shortest that moves; 0 if none does.
    double shortest() const { return shortest_; }
    /// Whether the turtle turns somewhere, and whether it moves with its pen up.
    bool turns() const { return std::ranges::any_of(stands_, &Stand::turns); }
    bool has_moves() const {
        return std::ranges::any_of(explanation_.steps, [](const ExplainedStep& step) {
            return !std::ranges::all_of(step.lines, &ExplainedLine::drawn);
        });
    }

    /// Draws it in the middle of this rectangle, at most `largest` units of the picture to one of
    /// the figure. Labels stay within the rectangle.
    void draw(cairo_t* context, double left, double top, double width, double height,
              double largest) const {
        double scale = largest;
        if (box_.breadth() > 0) scale = std::min(scale, (width - 2 * room) / box_.breadth());
        if (box_.height() > 0) scale = std::min(scale, (height - 2 * room) / box_.height());
        const Frame frame{scale, left + width / 2 - scale * (box_.low.x / 2 + box_.high.x / 2),
                          top + height / 2 + scale * (box_.low.y / 2 + box_.high.y / 2)};
        const auto on_page = [&](const Vector& at) { return frame(in_plane(at)); };
        LabelPlaces places({left, top}, {left + width, top + height});
        const std::size_t count = explanation_.steps.size();
        const auto colour_at = [&](std::size_t i, const TurtleState& state) {
            if (state.paint) return *state.paint;
            return palette_.colour(palette_.shade(
                state.colour,
                static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(count, 1))));
        };

        for (std::size_t i = 0; i < count; ++i)
            for (const std::vector<Vector>& corners : explanation_.steps[i].polygons) {
                for (const Vector& corner : corners) {
                    const Point at = on_page(corner);
                    cairo_line_to(context, at.x, at.y);
                }
                cairo_close_path(context);
                set_colour(context, colour_at(i, explanation_.steps[i].after), 0.22);
                cairo_fill(context);
            }
        cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
        for (const bool drawn : {false, true})
            for (std::size_t i = 0; i < count; ++i)
                for (const ExplainedLine& line : explanation_.steps[i].lines) {
                    if (line.drawn != drawn) continue;
                    const Point from = on_page(line.from), to = on_page(line.to);
                    const double dashes[] = {1, 3.5};
                    cairo_set_dash(context, dashes, drawn ? 0 : 2, 0);
                    cairo_set_line_width(context, drawn ? stroke_width : 1);
                    set_colour(context,
                               drawn ? colour_at(i, line.state) : Colour{0.45, 0.45, 0.45});
                    draw_line(context, from, to);
                    places.avoid(from, to);
                }
        cairo_set_dash(context, nullptr, 0, 0);

        // Turtles: pale ones first, so that those that leave cover them.
        constexpr double turtle_radius = 5;
        for (const Stand& stand : stands_) {
            const Point at = on_page(stand.position);
            places.avoid(at, turtle_radius);
            if (!stand.turns) continue;
            const double from = angle_of(stand.before);
            double by = std::remainder(angle_of(stand.after) - from, 2 * std::numbers::pi);
            if (std::fabs(std::fabs(by) - std::numbers::pi) < 1e-9) by = -std::numbers::pi;
            draw_turtle(context, at, from, true);
            draw_turn(context, at, from, by);
            const int parts = 1 + static_cast<int>(std::fabs(by) / 0.5);
            for (int part = 0; part <= parts; ++part)
                places.avoid(beside(at, from + by * part / parts, arc_radius), 1.5);
        }
        draw_turtle(context, on_page(explanation_.start.position),
                    angle_of(explanation_.start.attitude),
                    !stands_.empty() && stands_.front().first == 0 && stands_.front().turns);
        for (const Stand& stand : stands_)
            if (stand.turns)
                draw_turtle(context, on_page(stand.position), angle_of(stand.after), false);
        for (std::size_t i = 0; i < count; ++i) {
            const ExplainedStep& step = explanation_.steps[i];
            if (step.lines.empty()) continue;
            const Point at = on_page(step.after.position);
            places.avoid(at, turtle_radius);
            const bool turns_next = std::ranges::any_of(stands_, [&](const Stand& stand) {
                return stand.turns && stand.first > i &&
                       length(stand.position - step.after.position) < 1e-9 &&
                       std::none_of(
                           explanation_.steps.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                           explanation_.steps.begin() + static_cast<std::ptrdiff_t>(stand.first),
                           [](const ExplainedStep& s) { return !s.lines.empty() || s.returns_to; });
            });
            if (!turns_next) draw_turtle(context, at, angle_of(step.after.attitude), false);
        }

        if (count > 0) {
            const TurtleState& end = explanation_.steps.back().after;
            draw_turtle(context, on_page(end.position), angle_of(end.attitude), false);
        }

        choose_font(context, "sans-serif", label_letters);
        const double label_height = 1.35 * label_letters;
        const auto width_of = [&](const std::string& text) {
            return std::max(label_height, text_width(context, text) + 0.8 * label_letters);
        };
        const auto label = [&](const std::string& text, const std::vector<Point>& middles,
                               const Colour& colour) {
            const double label_width = width_of(text);
            draw_label(context, places.place(middles, label_width, label_height), text, colour);
        };
        for (std::size_t i = 0; i < count; ++i) {
            if (explanation_.steps[i].lines.empty()) continue;
            const ExplainedLine& line = explanation_.steps[i].lines.front();
            const Point from = on_page(line.from), to = on_page(line.to);
            const double angle = std::atan2(to.y - from.y, to.x - from.x);
            const std::string number = std::to_string(i + 1);
            // So far that it just does not touch.
            const double near = 2.5 + std::fabs(std::sin(angle)) * width_of(number) / 2 +
                                std::fabs(std::cos(angle)) * label_height / 2;
            std::vector<Point> middles;
            for (const double share : {0.5, 0.42, 0.58, 0.34, 0.66})
                for (const double distance : {near, near + 3, near + 7})
                    for (const double side : {-1.0, 1.0})
                        middles.push_back(beside(
                            {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)},
                            angle + side * std::numbers::pi / 2, distance));
            label(number, middles, {0, 0, 0});
        }
        for (const Stand& stand : stands_) {
            const double straight = angle_of(stand.before);
            const double by =
                std::remainder(angle_of(stand.after) - straight, 2 * std::numbers::pi);
            // Best just outside the arc of the turn; without one behind the turtle.
            const double best =
                stand.turns ? straight + by / 2 : straight + 0.75 * std::numbers::pi;
            const double nearer = stand.turns ? 0 : 8;
            const std::string numbers =
                stand.first == stand.last
                    ? std::to_string(stand.first + 1)
                    : std::to_string(stand.first + 1) + "–" + std::to_string(stand.last + 1);
            label(numbers,
                  around(on_page(stand.position), best,
                         {23 - nearer, 27 - nearer, 31 - nearer, 19 - nearer}),
                  turn_colour);
        }
        const auto mark = [&](const std::string& text, const TurtleState& state) {
            const double back = angle_of(state.attitude) + std::numbers::pi;
            label(text, around(on_page(state.position), back, {20, 26, 32}), turtle_colour);
        };
        if (count == 0) return mark("start and end", explanation_.start);
        mark("start", explanation_.start);
        TurtleState end = explanation_.steps.back().after;
        end.attitude.turn_back();
        mark("end", end);
    }

    /// The room that labels and turtles need around the lines.
    static constexpr double room = 34;

private:
    /// Steps that happen in one place, one after the other.
    struct Stand {
        std::size_t first, last;
        Vector position;
        Attitude before, after;
        bool turns = false;
    };

    void find_stands() {
        bool open = false;
        for (std::size_t i = 0; i < explanation_.steps.size(); ++i) {
            const ExplainedStep& step = explanation_.steps[i];
            if (!step.lines.empty()) {
                open = false;
                continue;
            }
            if (step.returns_to) open = false;
            if (step.meaning == "nothing") continue;
            if (!open)
                stands_.push_back({i, i, step.after.position,
                                   step.returns_to ? step.after.attitude : step.before.attitude,
                                   step.after.attitude});
            open = true;
            Stand& stand = stands_.back();
            stand.last = i;
            stand.after = step.after.attitude;
            stand.turns = length(stand.after.heading() - stand.before.heading()) > 1e-9;
        }
    }

    const Explanation& explanation_;
    const Palette& palette_;
    Box box_;
    double shortest_ = 0;
    std::vector<Stand> stands_;
};

constexpr double gap = 1.1;      // between columns, in letters
constexpr double between = 2.5;  // between blocks
constexpr double line_step = 1.25;
constexpr double widest_meaning = 21;

void choose_column_font(cairo_t* context, std::size_t column, double letters, bool head) {
    choose_font(context, column == 1 && !head ? "monospace" : "sans-serif", letters, head);
}

/// Lines of words, none wider than `most` where words allow it.
std::vector<std::string> broken(cairo_t* context, const std::string& text, double most) {
    std::vector<std::string> lines;
    std::istringstream words(text);
    words.exceptions(std::ios::badbit);
    for (std::string word; words >> word;) {
        const std::string longer = lines.empty() ? word : lines.back() + " " + word;
        if (lines.empty() || text_width(context, longer) > most)
            lines.push_back(word);
        else
            lines.back() = longer;
    }
    if (lines.empty()) lines.emplace_back();
    return lines;
}

/// Which of these columns holds the meanings, which may be broken into lines.
constexpr std::size_t column_of_meanings = 2;

/// The table of an explanation on a page, in several blocks side by side. Lengths are those of the
/// context.
class ExplanationTable {
public:
    /// Measures the text with fonts of this size.
    ExplanationTable(cairo_t* context, const Explanation& explanation, double letters)
        : letters_(letters) {
        bool head = true;
        for (const std::vector<std::string>& cells : explanation_rows(explanation)) {
            Row row;
            columns_.resize(cells.size());
            std::size_t lines = 1;
            for (std::size_t column = 0; column < cells.size(); ++column) {
                choose_column_font(context, column, letters_, head);
                const bool may_break = column == column_of_meanings && !head;
                row.cells.push_back(may_break
                                        ? broken(context, cells[column], widest_meaning * letters)
                                        : std::vector{cells[column]});
                lines = std::max(lines, row.cells.back().size());
                for (const std::string& line : row.cells.back())
                    columns_[column] = std::max(columns_[column], text_width(context, line));
            }
            row.height = (line_step * static_cast<double>(lines) + 0.35) * letters;
            rows_.push_back(std::move(row));
            head = false;
        }
    }

    /// The size with the rows in so many blocks.
    double width(std::size_t blocks) const {
        double one = gap * letters_;
        for (const double column : columns_) one += column + gap * letters_;
        const auto count = static_cast<double>(blocks);
        return count * one + (count - 1) * between * letters_;
    }
    double height(std::size_t blocks) const {
        const std::vector<std::size_t> at = breaks(blocks);
        double highest = 0;
        for (std::size_t block = 0; block + 1 < at.size(); ++block) {
            double sum = rows_.front().height;
            for (std::size_t i = at[block]; i < at[block + 1]; ++i) sum += rows_[i].height;
            highest = std::max(highest, sum);
        }
        return highest + 0.4 * letters_;
    }
    void draw(cairo_t* context, double left, double top, std::size_t blocks) const {
        const std::vector<std::size_t> at = breaks(blocks);
        const double one = width(1);
        for (std::size_t block = 0; block + 1 < at.size(); ++block) {
            double y = top;
            draw_row(context, rows_.front(), left, y, true);
            y += rows_.front().height + 0.2 * letters_;
            cairo_set_line_width(context, 0.08 * letters_);
            draw_line(context, {left, y}, {left + one, y});
            for (std::size_t i = at[block]; i < at[block + 1]; ++i) {
                if (i % 2 == 0) {
                    cairo_set_source_rgb(context, 0.95, 0.95, 0.95);
                    cairo_rectangle(context, left, y, one, rows_[i].height);
                    cairo_fill(context);
                }
                draw_row(context, rows_[i], left, y, false);
                y += rows_[i].height;
            }
            left += one + between * letters_;
        }
    }

private:
    struct Row {
        std::vector<std::vector<std::string>> cells;  // lines of each
        double height = 0;
    };

    /// The rows at which blocks begin, and the end.
    std::vector<std::size_t> breaks(std::size_t blocks) const {
        double all = 0;
        for (std::size_t i = 1; i < rows_.size(); ++i) all += rows_[i].height;
        std::vector<std::size_t> found{1};
        double sum = 0;
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            // A block ends before the row whose middle is in the next one's share.
            const double share =
                all * static_cast<double>(found.size()) / static_cast<double>(blocks);
            if (found.size() < blocks && sum + rows_[i].height / 2 > share) found.push_back(i);
            sum += rows_[i].height;
        }
        found.push_back(rows_.size());
        return found;
    }
    void draw_row(cairo_t* context, const Row& row, double left, double top, bool head) const {
        cairo_set_source_rgb(context, 0, 0, 0);
        double x = left + gap * letters_;
        for (std::size_t column = 0; column < row.cells.size(); ++column) {
            choose_column_font(context, column, letters_, head);
            double y = top + 1.15 * letters_;
            for (const std::string& line : row.cells[column]) {
                const bool number = column == 0 || column == 5;
                const double shift =
                    number && !head ? columns_[column] - text_width(context, line) : 0;
                show_text(context, line, x + shift, y);
                y += line_step * letters_;
            }
            x += columns_[column] + gap * letters_;
        }
    }

    double letters_;
    std::vector<double> columns_;  // widths
    std::vector<Row> rows_;        // the head first
};

constexpr double margin = 18, letters = 9.5, title_letters = 13, word_letters = 10.5;
constexpr double pixels_per_point = 2;  // in png
constexpr double comfortable = 64;      // points for the shortest step

/// Text has the same size on every surface.
void settle_fonts(cairo_t* context) {
    cairo_font_options_t* const options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(context, options);
    cairo_font_options_destroy(options);
}

/// A page whose parts have their places.
class Page {
public:
    Page(const Explanation& explanation, const std::string& title, const Palette& palette)
        : title_(title),
          word_(explanation.word),
          sheet_(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1)),
          context_(cairo_create(sheet_.get())),
          sketch_(explanation, palette),
          table_(measuring(), explanation, letters) {
        decide();
        break_word();
        height += head_height();
    }

    void draw(cairo_t* context) const {
        settle_fonts(context);
        cairo_set_source_rgb(context, 0, 0, 0);
        choose_font(context, "sans-serif", title_letters, true);
        double y = margin + title_letters;
        show_text(context, title_, margin, y);
        choose_font(context, "monospace", word_letters);
        y += 0.45 * word_letters;
        for (const std::string& line : lines_)
            show_text(context, line, margin, y += 1.3 * word_letters);
        const double top = head_height();
        sketch_.draw(context, margin, top, sketch_width_, sketch_height_,
                     sketch_.shortest() > 0 ? 1.5 * comfortable / sketch_.shortest() : 1);
        draw_legend(context, margin, top + sketch_height_ + 11);
        table_.draw(context, below_ ? margin : margin + sketch_width_ + margin,
                    below_ ? top + sketch_height_ + legend_height : top, blocks_);
        check_cairo(context);
    }

    double width = 0, height = 0;

private:
    static constexpr double legend_height = 22;

    cairo_t* measuring() {
        settle_fonts(context_.get());
        return context_.get();
    }

    /// Where the sketch goes: beside the table, or above it where one of them is wide or the table
    /// high, in as large a scale as is comfortable and has room.
    void decide() {
        constexpr double most = 620, least_width = 230, least_height = 130;
        const double room = 2 * ExplanationSketch::room;
        const double shortest = sketch_.shortest() > 0 ? sketch_.shortest() : 1;
        const auto size_within = [&](double across, double down) {
            double scale = comfortable / shortest;
            if (sketch_.breadth() > 0) scale = std::min(scale, (across - room) / sketch_.breadth());
            if (sketch_.height() > 0) scale = std::min(scale, (down - room) / sketch_.height());
            sketch_width_ = std::max(least_width, scale * sketch_.breadth() + room);
            sketch_height_ = std::max(least_height, scale * sketch_.height() + room);
        };
        size_within(most, most);
        const double table_height = table_.height(1);
        below_ = sketch_width_ > 2 * sketch_height_ || sketch_width_ > 1.2 * table_.width(1) ||
                 table_height > 1.25 * std::max(sketch_height_, 330.0);
        if (below_) {
            blocks_ = table_height > 150 ? 2 : 1;
            const double table_width = table_.width(blocks_);
            size_within(std::max(table_width, 400.0), 460);
            sketch_width_ = std::max(sketch_width_, table_width);
            width = sketch_width_ + 2 * margin;
            height = sketch_height_ + legend_height + table_.height(blocks_) + margin;
        } else {
            sketch_height_ = std::max(sketch_height_, table_height - legend_height);
            width = sketch_width_ + table_.width(1) + 3 * margin;
            height = std::max(sketch_height_ + legend_height, table_height) + margin;
        }
    }

    double head_height() const {
        return margin + title_letters + 0.45 * word_letters +
               1.3 * word_letters * static_cast<double>(lines_.size()) + 12;
    }

    /// Breaks the word into lines where it is wider than the page.
    void break_word() {
        cairo_t* const context = context_.get();
        choose_font(context, "monospace", word_letters);
        lines_.emplace_back();
        for (std::size_t at = 0; at < word_.size();) {
            std::size_t next = at + 1;
            while (next < word_.size() && (word_[next] & 0xc0) == 0x80) ++next;
            std::string longer = lines_.back() + word_.substr(at, next - at);
            if (text_width(context, longer) > width - 2 * margin && !lines_.back().empty())
                lines_.push_back(word_.substr(at, next - at));
            else
                lines_.back() = std::move(longer);
            at = next;
        }
    }

    void draw_legend(cairo_t* context, double left, double y) const {
        std::string text = "arrowheads: the turtle";
        if (sketch_.turns()) text += ", pale before it turns";
        if (sketch_.has_moves()) text += "; dots: its pen is up";
        choose_font(context, "sans-serif", 7.5);
        set_colour(context, {0.35, 0.35, 0.35});
        show_text(context, text,
                  left + std::max(0.0, (sketch_width_ - text_width(context, text)) / 2), y);
    }

    std::string title_, word_;
    OwnedSurface sheet_;
    OwnedContext context_;  // to measure text on
    ExplanationSketch sketch_;
    ExplanationTable table_;
    std::vector<std::string> lines_;
    double sketch_width_ = 0, sketch_height_ = 0;
    bool below_ = false;
    std::size_t blocks_ = 1;
};

void check(const Explanation& explanation) {
    if (explanation.steps.size() > longest_explanation)
        throw Error(explanation.name + " has " + std::to_string(explanation.steps.size()) +
                    " symbols: a page explains at most " + std::to_string(longest_explanation));
    for (const ExplainedStep& step : explanation.steps)
        if (step.after.position.z != 0 || !heading_angle(step.after))
            throw Error(explanation.name + ": the symbol " + step.symbol +
                        " leaves the plane: a page explains a turtle in the plane");
}

void draw(const Explanation& explanation, const std::string& title, Output& output,
          PictureFormat format, const PictureOptions& options, const Budget& budget) {
    check(explanation);
    const Palette palette(options.colours, 360);
    const Page page(explanation, title, palette);
    double scale = format == PictureFormat::png ? pixels_per_point : 1;
    if (options.width) scale = *options.width / page.width;
    if (options.height)
        scale = options.width ? std::min(scale, *options.height / page.height)
                              : *options.height / page.height;
    const double width = std::ceil(scale * page.width - 1e-6);
    const double height = std::ceil(scale * page.height - 1e-6);
    constexpr double longest_side = 14'400;
    if (!(width >= 1 && height >= 1 && width <= longest_side && height <= longest_side))
        throw Error("the sides of the page must be from 1 to 14400, not " + std::to_string(width) +
                    " and " + std::to_string(height));
    budget.check_memory(static_cast<std::uint64_t>(4 * width * height), "the page");
    // White behind it in all formats, as in png.
    const auto paper = background_of(options.background, PictureFormat::png);
    Document document(format, width, height, paper, output, budget);
    cairo_scale(document.context(), scale, scale);
    page.draw(document.context());
    document.finish();
}

}  // namespace

void draw_explanation(const Explanation& explanation, const std::string& title,
                      const Target& target, PictureFormat format, const PictureOptions& options,
                      const Budget& budget) {
    write_to(target,
             [&](Output& output) { draw(explanation, title, output, format, options, budget); });
}

}  // namespace algae
