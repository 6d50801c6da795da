#include "turtle/pen.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace algae {

LatticePosition::LatticePosition(const Compass& compass)
    : degree_(0), ring_(static_cast<long>(compass.order())) {
    degree_ = ring_.degree();
    here_.assign(degree_, 0);
    for (long k = 0; k < ring_.order(); ++k) powers_.push_back(ring_.power(k));
    for (std::size_t i = 0; i < degree_; ++i) basis_.push_back(compass.direction(static_cast<Compass::Heading>(i)));
}

template <class Position>
Pen<Position>::Pen(Canvas& canvas, const Compass& compass, const PenSettings& settings)
    : canvas_(canvas), compass_(compass), settings_(settings), position_(compass) {
    state_.heading = compass.start();
}

template <class Position>
Point Pen<Position>::point() const {
    const std::complex<double> at = position_.point();
    return {settings_.start.x + settings_.unit * at.real(), settings_.start.y + settings_.unit * at.imag()};
}

template <class Position>
void Pen<Position>::letter(const std::vector<Command>& commands) {
    for (const Command command : commands) run(command);
    ++letters_;
}

template <class Position>
void Pen<Position>::tell_position() {
    if (canvas_.wants_position()) canvas_.position(letters_ / settings_.letters);
}

template <class Position>
void Pen<Position>::line() {
    if (!at_pen_) canvas_.move_to(point());
    position_.step(state_.heading, state_.size);
    tell_position();
    canvas_.line_to(point());
    at_pen_ = true;
}

template <class Position>
void Pen<Position>::corner() {
    polygons_.back().push_back(point());
}

template <class Position>
void Pen<Position>::restore(const State& state) {
    if (state.width != state_.width) canvas_.width(state.width);
    if (state.colour != state_.colour) canvas_.colour(state.colour);
    state_ = state;
}

template <class Position>
void Pen<Position>::run(Command command) {
    if (cut_ && command != Command::push && command != Command::pop) return;
    switch (command) {
        case Command::draw:
            line();
            if (!polygons_.empty()) corner();
            break;
        case Command::draw_unmarked: line(); break;
        case Command::move:
            position_.step(state_.heading, state_.size);
            at_pen_ = false;
            if (!polygons_.empty()) corner();
            break;
        case Command::left: state_.heading = compass_.sum(state_.heading, compass_.turn()); break;
        case Command::right: state_.heading = compass_.sum(state_.heading, -compass_.turn()); break;
        case Command::back: state_.heading = compass_.sum(state_.heading, compass_.half()); break;
        case Command::push:
            if (cut_) {
                ++cut_depth_;
                break;
            }
            saved_.push_back(state_);
            saved_.back().polygons = polygons_.size();
            position_.push();
            break;
        case Command::pop:
            if (cut_ && cut_depth_ > 0) {
                --cut_depth_;
                break;
            }
            if (saved_.empty()) unmatched("unmatched ']'");
            if (cut_) polygons_.resize(std::min(polygons_.size(), saved_.back().polygons));
            cut_ = false;
            restore(saved_.back());
            saved_.pop_back();
            position_.pop();
            at_pen_ = false;
            break;
        case Command::open_polygon:
            polygons_.emplace_back();
            corner();
            break;
        case Command::close_polygon:
            if (polygons_.empty()) unmatched("unmatched '}'");
            tell_position();
            if (polygons_.back().size() > 2) canvas_.polygon(polygons_.back());
            polygons_.pop_back();
            at_pen_ = false;
            break;
        case Command::vertex:
            if (!polygons_.empty()) corner();
            break;
        case Command::scale: state_.size *= settings_.scale; break;
        case Command::narrow: canvas_.width(state_.width *= settings_.narrow); break;
        case Command::next_colour: canvas_.colour(++state_.colour); break;
        case Command::cut:
            cut_ = true;
            cut_depth_ = 0;
            break;
    }
}

template <class Position>
void Pen<Position>::jump(const Pieces::value_type& part, bool stroke) {
    if constexpr (requires { position_.jump(state_.heading, state_.size, part.move); }) {
        stroke = stroke && part.draws();
        if (stroke && !at_pen_) canvas_.move_to(point());
        position_.jump(state_.heading, state_.size, part.move);
        letters_ += part.letters;
        if (stroke) {
            tell_position();
            canvas_.line_to(point());
        }
        at_pen_ = stroke;
        State state = state_;
        state.heading = compass_.sum(state.heading, part.turn);
        state.size *= part.size;
        state.width *= part.width;
        state.colour += static_cast<std::uint32_t>(std::fmod(part.colours, 4294967296.0));
        restore(state);
    }
}

template <class Position>
void Pen<Position>::finish() const {
    if (!polygons_.empty() && !cut_) unmatched("'{' is never closed");
    if (!saved_.empty()) unmatched("'[' is never closed");
}

template <class Position>
void Pen<Position>::unmatched(const char* what) const {
    std::string place = settings_.figure;
    if (what[0] == 'u') place += ", position " + std::to_string(static_cast<std::uint64_t>(letters_));
    throw Error(place + ": " + what);
}

template class Pen<LatticePosition>;
template class Pen<FloatingPosition>;

}  // namespace algae
