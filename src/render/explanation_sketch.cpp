#include "render/explanation_sketch.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/label_places.hpp"
#include "render/layout.hpp"
#include "turtle/watched_walk.hpp"

namespace algae {

namespace {

constexpr double stroke_width = 1.6, turtle_length = 11, label_letters = 8.5, arc_radius = 15;
constexpr Colour turtle_colour = turtle_green, turn_colour{0.75, 0.33, 0.05};

void set_colour(cairo_t* context, const Colour& colour, double opacity = 1) {
    cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, opacity);
}

Point in_plane(const Vector& at) { return {at.x, at.y}; }

/// The direction of a heading in the picture, where y points down.
double angle_of(const Attitude& attitude) {
    return std::atan2(-attitude.heading().y, attitude.heading().x);
}

Point beside(Point at, double angle, double distance) {
    return {at.x + distance * std::cos(angle), at.y + distance * std::sin(angle)};
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
    cairo_set_source_rgba(context, 1, 1, 1, 0.9);
    cairo_fill_preserve(context);
    set_colour(context, colour, 0.5);
    cairo_set_line_width(context, 0.5);
    cairo_stroke(context);
    set_colour(context, colour);
    cairo_text_extents_t extents{};
    cairo_text_extents(context, text.c_str(), &extents);
    cairo_move_to(context, place.middle.x - extents.x_advance / 2,
                  place.middle.y + 0.36 * label_letters);
    cairo_show_text(context, text.c_str());
    cairo_new_path(context);
}

}  // namespace

ExplanationSketch::ExplanationSketch(const Explanation& explanation, const Palette& palette)
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

void ExplanationSketch::find_stands() {
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

bool ExplanationSketch::turns() const {
    return std::any_of(stands_.begin(), stands_.end(),
                       [](const Stand& stand) { return stand.turns; });
}

bool ExplanationSketch::has_moves() const {
    return std::any_of(
        explanation_.steps.begin(), explanation_.steps.end(), [](const ExplainedStep& step) {
            return std::any_of(step.lines.begin(), step.lines.end(),
                               [](const ExplainedLine& line) { return !line.drawn; });
        });
}

void ExplanationSketch::draw(cairo_t* context, double left, double top, double width, double height,
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
                set_colour(context, drawn ? colour_at(i, line.state) : Colour{0.45, 0.45, 0.45});
                cairo_move_to(context, from.x, from.y);
                cairo_line_to(context, to.x, to.y);
                cairo_stroke(context);
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
        const bool turns_next =
            std::any_of(stands_.begin(), stands_.end(), [&](const Stand& stand) {
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

    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, label_letters);
    const double label_height = 1.35 * label_letters;
    const auto width_of = [&](const std::string& text) {
        cairo_text_extents_t extents{};
        cairo_text_extents(context, text.c_str(), &extents);
        return std::max(label_height, extents.x_advance + 0.8 * label_letters);
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
                    middles.push_back(
                        beside({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)},
                               angle + side * std::numbers::pi / 2, distance));
        label(number, middles, {0, 0, 0});
    }
    for (const Stand& stand : stands_) {
        const double straight = angle_of(stand.before);
        const double by = std::remainder(angle_of(stand.after) - straight, 2 * std::numbers::pi);
        // Best just outside the arc of the turn; without one behind the turtle.
        const double best = stand.turns ? straight + by / 2 : straight + 0.75 * std::numbers::pi;
        std::vector<Point> middles;
        for (const double distance : {23.0, 27.0, 31.0, 19.0})
            for (int i = 0; i < 16; ++i) {
                const double aside = (i + 1) / 2 * (i % 2 == 0 ? -1 : 1) * std::numbers::pi / 8;
                middles.push_back(beside(on_page(stand.position), best + aside,
                                         stand.turns ? distance : distance - 8));
            }
        const std::string numbers =
            stand.first == stand.last
                ? std::to_string(stand.first + 1)
                : std::to_string(stand.first + 1) + "–" + std::to_string(stand.last + 1);
        label(numbers, middles, turn_colour);
    }
    const auto mark = [&](const std::string& text, const TurtleState& state) {
        std::vector<Point> middles;
        const double back = angle_of(state.attitude) + std::numbers::pi;
        for (const double distance : {20.0, 26.0, 32.0})
            for (int i = 0; i < 16; ++i)
                middles.push_back(beside(
                    on_page(state.position),
                    back + (i + 1) / 2 * (i % 2 == 0 ? -1 : 1) * std::numbers::pi / 8, distance));
        label(text, middles, turtle_colour);
    };
    if (count == 0) return mark("start and end", explanation_.start);
    mark("start", explanation_.start);
    TurtleState end = explanation_.steps.back().after;
    end.attitude.turn_back();
    mark("end", end);
}

}  // namespace algae
