#include "turtle/outline.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/error.hpp"
#include "fold/derive.hpp"
#include "system/classes.hpp"
#include "system/d0l.hpp"
#include "turtle/commands.hpp"
#include "turtle/compass.hpp"
#include "turtle/figure.hpp"
#include "turtle/segment_set.hpp"

namespace algae {

namespace {

constexpr std::size_t most_strokes = 1'000'000;

void check_size(std::size_t strokes) {
    if (strokes > most_strokes)
        throw BoundReached(Bound::method,
                           "more than " + std::to_string(most_strokes) +
                               " strokes are not compared; ask for an earlier generation");
}

template <class T>
void make_set(std::vector<T>& all) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
}

/// Writes down what is drawn on it, points that lie together as one.
class OutlineCanvas : public Canvas {
public:
    explicit OutlineCanvas(double grid) : numbers_(grid) {}

    void move_to(Point point) override { from_ = point; }
    void line_to(Point point) override {
        const std::uint32_t from = number(from_), to = number(point);
        outline.strokes.push_back(std::minmax(from, to));
        check_size(outline.strokes.size());
        from_ = point;
    }
    void polygon(std::span<const Point> corners) override {
        std::vector<std::uint32_t>& polygon = outline.polygons.emplace_back();
        for (const Point corner : corners) polygon.push_back(number(corner));
        make_set(polygon);
        check_size(outline.polygons.size());
    }
    void width(double) override {}
    void width_as_length(double) override {}
    void colour(std::uint32_t) override {}
    void position(double) override {}

    Outline outline;

private:
    std::uint32_t number(Point point) {
        const std::uint32_t found = numbers_.number({point.x, point.y, 0});
        if (found == outline.points.size()) outline.points.emplace_back(point.x, point.y);
        return found;
    }

    NumberedPoints numbers_;
    Point from_;
};

Outline drawn_outline(const LSystem& system, std::uint64_t n, const Budget& budget,
                      const FigureChoices& choices) {
    const auto drawing = figure(system, n, budget, choices);
    OutlineCanvas canvas(drawing->facts().step * 1e-6);
    drawing->draw(canvas, 0, budget);
    return std::move(canvas.outline);
}

/// A turtle whose places are exact.
class LatticeWalk {
public:
    LatticeWalk(const Compass& compass, std::complex<double> start, double unit)
        : compass_(compass),
          ring_(compass.order()),
          start_(start),
          unit_(unit),
          here_{ring_.zero(), compass.start()} {}

    /// False where the commands need more than a place and a heading.
    bool run(Command command) {
        switch (command) {
            case Command::draw:
            case Command::draw_unmarked:
                step(true);
                return true;
            case Command::move:
                step(false);
                return true;
            case Command::left:
                here_.heading = compass_.sum(here_.heading, compass_.turn());
                return true;
            case Command::right:
                here_.heading = compass_.sum(here_.heading, -compass_.turn());
                return true;
            case Command::back:
                here_.heading = compass_.sum(here_.heading, compass_.half());
                return true;
            case Command::push:
                saved_.push_back(here_);
                return true;
            case Command::pop:
                if (saved_.empty()) return false;
                here_ = saved_.back();
                saved_.pop_back();
                return true;
            case Command::narrow:
            case Command::next_colour:
            case Command::vertex:
                return true;
            default:
                return false;
        }
    }

    Outline result(std::optional<Rational> unit) {
        outline_.lattice = {ring_, std::move(points_), std::move(unit)};
        return std::move(outline_);
    }

private:
    struct State {
        CyclotomicInteger place;
        Compass::Heading heading;
    };

    void step(bool drawn) {
        const std::uint32_t from = drawn ? number(here_.place) : 0;
        ring_.add(here_.place, ring_.zeta(static_cast<long>(here_.heading)));
        if (!drawn) return;
        const std::uint32_t to = number(here_.place);
        outline_.strokes.push_back(std::minmax(from, to));
        check_size(outline_.strokes.size());
    }
    std::uint32_t number(const CyclotomicInteger& place) {
        const auto [entry, is_new] =
            numbers_.try_emplace(place, static_cast<std::uint32_t>(points_.size()));
        if (is_new) {
            points_.push_back(place);
            outline_.points.push_back(start_ + unit_ * ring_.to_complex(place));
        }
        return entry->second;
    }

    const Compass& compass_;
    CyclotomicRing ring_;
    std::complex<double> start_;
    double unit_;
    State here_;
    std::vector<State> saved_;
    std::unordered_map<CyclotomicInteger, std::uint32_t> numbers_;
    std::vector<CyclotomicInteger> points_;
    Outline outline_;
};

/// The outline by exact places; nothing where the system needs more than those.
std::optional<Outline> lattice_outline(const LSystem& system, std::uint64_t n,
                                       const Budget& budget) {
    if (!system.settings.stamps.empty() || class_of(system).parametric) return std::nullopt;
    const View<D0L> rules = as_d0l(system);
    const Compass compass(system.settings, n);
    if (!rules || !compass.is_exact()) return std::nullopt;
    const Commands commands(system, rules->letters);
    const Settings& settings = system.settings;
    const Quantity one = quantity(Rational(1));
    const Quantity step = settings.step.value_or(one), shrink = settings.shrink.value_or(one);
    std::optional<Rational> unit;
    if (step.exact && shrink.exact && n < 1000)
        unit = *step.exact * power(*shrink.exact, static_cast<long>(n));
    std::complex<double> start;
    if (settings.start) start = {settings.start->x.value, settings.start->y.value};
    LatticeWalk walk(compass, start, step.value * std::pow(shrink.value, static_cast<double>(n)));
    const Word word = derive(*rules, n, budget);
    for (const Symbol letter : word)
        for (const Command command : commands.of(letter))
            if (!walk.run(command)) return std::nullopt;
    return walk.result(std::move(unit));
}

}  // namespace

Outline outline(const LSystem& system, std::uint64_t n, const Budget& budget,
                const FigureChoices& choices) {
    std::optional<Outline> found = lattice_outline(system, n, budget);
    if (!found) found = drawn_outline(system, n, budget, choices);
    make_set(found->strokes);
    make_set(found->polygons);
    return std::move(*found);
}

}  // namespace algae
