#include "turtle/trace.hpp"

#include <cstdint>

#include "turtle/segment_set.hpp"

namespace algae {

namespace {

class Tracer : public Canvas {
public:
    Tracer(double grid, const Budget& budget) : segments_(grid, budget) {}

    void move_to(Point point) override { from_ = number(point); }
    void line_to(Point point) override {
        const std::uint32_t to = number(point);
        segments_.add(from_, to);
        from_ = to;
    }
    void polygon(std::span<const Point>) override {}
    void width(double) override {}
    void width_as_length(double) override {}
    void colour(std::uint32_t) override {}
    void position(double) override {}

    Trace result() { return segments_.result(); }

private:
    std::uint32_t number(Point point) { return segments_.number({point.x, point.y, 0}); }

    SegmentSet segments_;
    std::uint32_t from_ = 0;
};

}  // namespace

Trace trace(const Figure& figure, const Budget& budget) {
    Tracer tracer(figure.facts().step * 1e-6, budget);
    figure.draw(tracer, 0, budget);
    return tracer.result();
}

}  // namespace algae
