#include "turtle/partial_figure.hpp"

#include <algorithm>

namespace algae {

namespace {

/// Passes on what comes before a part of the word.
class CutCanvas : public Canvas {
public:
    CutCanvas(Canvas& canvas, double part) : canvas_(canvas), part_(part) {}

    void move_to(Point point) override { canvas_.move_to(point); }
    void line_to(Point point) override {
        if (open_) canvas_.line_to(point);
    }
    void polygon(std::span<const Point> corners) override {
        if (open_) canvas_.polygon(corners);
    }
    void width(double factor) override { canvas_.width(factor); }
    void width_as_length(double length) override { canvas_.width_as_length(length); }
    void colour(std::uint32_t index) override { canvas_.colour(index); }
    void paint(const Colour& colour) override { canvas_.paint(colour); }
    void position(double fraction) override {
        open_ = fraction < part_;
        if (open_ && canvas_.wants_position()) canvas_.position(fraction);
    }
    bool wants_position() const override { return true; }
    double line_width() const override { return canvas_.line_width(); }

private:
    Canvas& canvas_;
    double part_;
    bool open_ = true;
};

}  // namespace

void PartialFigure::draw(Canvas& canvas, double resolution, const Budget& budget) const {
    CutCanvas cut(canvas, part_);
    whole_->draw(cut, resolution, budget);
    const auto glyph = [&](double size, const Colour& colour) {
        std::vector<Point> corners;
        for (const Vector& corner : turtle_glyph(turtle_, size))
            corners.push_back({corner.x, corner.y});
        canvas.paint(colour);
        canvas.polygon(corners);
    };
    glyph(1.35 * size_, {1, 1, 1});  // so that it is seen on lines
    glyph(size_, turtle_green);
}

std::vector<std::unique_ptr<Figure>> partial_figures(const LSystem& system,
                                                     const DerivedModules& derived, std::uint64_t n,
                                                     const std::vector<std::size_t>& symbols,
                                                     const Budget& budget) {
    const std::shared_ptr<const Figure> whole =
        figure(system, derived.kinds, derived.word, n, derived.seed, budget);
    const ModuleTurtle turtle(system, derived.kinds, n, derived.seed);
    const WatchedWalk watched = watched_walk(turtle, derived.word, symbols, budget);
    const std::size_t length = derived.word.kinds.size();
    Box room = whole->box();
    room.add(Point{watched.low.x, watched.low.y});
    room.add(Point{watched.high.x, watched.high.y});
    double size = 0.04 * std::max(room.breadth(), room.height());
    if (size == 0) size = std::abs(turtle.start().step);
    room.add(Point{room.low.x - 0.7 * size, room.low.y - 0.7 * size});
    room.add(Point{room.high.x + 0.7 * size, room.high.y + 0.7 * size});
    std::vector<std::unique_ptr<Figure>> figures;
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        // As canvases are told: the symbols before, as a part of all.
        const double part = symbols[i] >= length
                                ? 2
                                : static_cast<double>(symbols[i]) / static_cast<double>(length);
        figures.push_back(
            std::make_unique<PartialFigure>(whole, part, watched.states[i], size, room));
    }
    return figures;
}

}  // namespace algae
