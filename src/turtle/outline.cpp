#include "turtle/turtle.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "model/model.hpp"

// What a figure leaves on the paper, whatever the order and direction of its strokes: how much of it is
// different (trace), the strokes themselves (outline), and whether two figures are similar.
//
// Points that stand for the same number may differ by rounding. So points get numbers by a fine grid, a
// millionth of a step (NumberedPoints): each is looked for in its own cell and in the cells beside it that
// are near. Where all of a figure is on the lattice, points are compared as exact numbers instead.
//
// Similarity: a similar map takes the middle of all points to the middle of the others, and the farthest
// point from it to one that is as far in proportion. So there is one candidate for each such point and
// each orientation; a candidate is tried in doubles, and what is found is proved in the ring where both are
// exact. Strokes are compared with strokes: one stroke is not the same as two that make it up.

namespace algae {

namespace {

/// Gives points numbers, equal ones to points that lie together.
class NumberedPoints {
public:
    explicit NumberedPoints(double grid) : grid_(grid), slots_(1024, none) {}

    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// A new number if there is none yet.
    std::uint32_t number(const Vector& point) {
        const std::uint32_t seen = find(point);
        if (seen != none) return seen;
        const auto fresh = static_cast<std::uint32_t>(cells_.size());
        cells_.push_back({place(point.x).cell, place(point.y).cell, place(point.z).cell});
        slots_[slot(cells_.back())] = fresh;
        if (2 * cells_.size() > slots_.size()) grow();
        return fresh;
    }
    /// Or `none`.
    std::uint32_t find(const Vector& point) const {
        const Place x = place(point.x), y = place(point.y), z = place(point.z);
        for (int dx = x.before; dx <= x.behind; ++dx)
            for (int dy = y.before; dy <= y.behind; ++dy)
                for (int dz = z.before; dz <= z.behind; ++dz) {
                    const std::uint32_t seen =
                        slots_[slot({x.cell + dx, y.cell + dy, z.cell + dz})];
                    if (seen != none) return seen;
                }
        return none;
    }
    std::size_t size() const { return cells_.size(); }
    std::size_t bytes() const {
        return slots_.size() * sizeof(std::uint32_t) + cells_.capacity() * sizeof(Cell);
    }

private:
    using Cell = std::array<double, 3>;  // whole numbers, which may be beyond those of any integer

    /// A coordinate's cell, and the cells beside it that are near.
    struct Place {
        double cell;
        int before, behind;
    };
    Place place(double coordinate) const {
        // A point close to the edge of its cell may have been seen on the other side of it.
        constexpr double edge = 0.25;
        const double exactly = coordinate / grid_;
        const double cell = std::floor(exactly + 0.5);
        const double off = exactly - cell;
        return {cell, off < -edge ? -1 : 0, off > edge ? 1 : 0};
    }
    /// Where the cell is, or would be.
    std::size_t slot(const Cell& cell) const {
        std::uint64_t hash = 0;
        for (const double part :
             cell) {  // their low bits are 0 mostly, so high ones are mixed into them twice
            hash = (hash + std::bit_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15u;
            hash = (hash ^ hash >> 32) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29;
        }
        std::size_t at = hash & (slots_.size() - 1);
        while (slots_[at] != none && cells_[slots_[at]] != cell)
            at = (at + 1) & (slots_.size() - 1);
        return at;
    }
    void grow() {
        slots_.assign(2 * slots_.size(), none);
        for (std::size_t i = 0; i < cells_.size(); ++i)
            slots_[slot(cells_[i])] = static_cast<std::uint32_t>(i);
    }

    double grid_;
    std::vector<std::uint32_t> slots_;  // numbers of points, at most half of them taken
    std::vector<Cell> cells_;           // by number
};

/// Different segments between points that lie on a fine grid.
class SegmentSet {
public:
    /// Points are the same when they round to the same point of a grid as fine as `grid`. The budget
    /// bounds the memory of all segments.
    SegmentSet(double grid, const Budget& budget) : points_(grid), budget_(budget) {}

    std::uint32_t number(const Vector& point) { return points_.number(point); }
    /// Between the points with these numbers. Throws BoundReached past budget.memory.
    void add(std::uint32_t from, std::uint32_t to) {
        const auto [low, high] = std::minmax(from, to);
        segments_.push_back(std::uint64_t{high} << 32 | low);
        if (segments_.size() % 65536 == 0)
            budget_.check_memory(segments_.capacity() * sizeof(std::uint64_t) + points_.bytes(),
                                 "the segments");
    }
    /// How many there are, once all are added.
    Trace result() {
        // Those of a curve that never crosses itself come in order.
        if (!std::is_sorted(segments_.begin(), segments_.end()))
            std::sort(segments_.begin(), segments_.end());
        const auto last = std::unique(segments_.begin(), segments_.end());
        std::vector<char> is_end(points_.size());
        for (auto it = segments_.begin(); it != last; ++it)
            is_end[*it & 0xFFFFFFFF] = is_end[*it >> 32] = 1;
        const auto vertices = std::count(is_end.begin(), is_end.end(), 1);
        return {static_cast<std::uint64_t>(last - segments_.begin()),
                static_cast<std::uint64_t>(vertices)};
    }

private:
    NumberedPoints points_;
    const Budget& budget_;
    std::vector<std::uint64_t> segments_;
};

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

Trace trace(const SpaceDerivation& derivation, const Budget& budget) {
    SegmentSet segments(derivation.facts.step * 1e-6, budget);
    for (const Rod& rod : derivation.scene.rods) {
        const std::uint32_t from = segments.number(rod.from);
        segments.add(from, segments.number(rod.to));
    }
    return segments.result();
}

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

Outline drawn_outline(const Model& system, std::uint64_t n, const Budget& budget,
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
            case Command::right:
            case Command::back:
                here_.heading = compass_.sum(here_.heading, compass_.turn_of(command));
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

    /// About how much memory the points take, which are kept twice.
    std::size_t bytes() const {
        return points_.size() * 2 * (64 + ring_.degree() * sizeof(Integer)) +
               saved_.size() * (32 + ring_.degree() * sizeof(Integer));
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
std::optional<Outline> lattice_outline(const Model& system, std::uint64_t n, const Budget& budget) {
    if (!system.drawing.stamps.empty() || class_of(system).parametric) return std::nullopt;
    const View<D0L> rules = as_d0l(system);
    const Compass compass(system.drawing, n);
    if (!rules || !compass.is_exact()) return std::nullopt;
    const Commands commands(system, rules->letters);
    const Drawing& drawing = system.drawing;
    const Quantity one = quantity(Rational(1));
    const Quantity step = drawing.step.value_or(one), shrink = drawing.shrink.value_or(one);
    std::optional<Rational> unit;
    if (step.exact && shrink.exact && n < 1000)
        unit = *step.exact * power(*shrink.exact, static_cast<long>(n));
    std::complex<double> start;
    if (drawing.start) start = {drawing.start->x.value, drawing.start->y.value};
    LatticeWalk walk(compass, start, step.value * std::pow(shrink.value, static_cast<double>(n)));
    const Word word = derive(*rules, n, budget);
    std::size_t letters = 0;
    for (const Symbol letter : word) {
        if (++letters % 4096 == 0) {
            budget.check();
            budget.check_memory(walk.bytes(), "the points of a figure");
        }
        for (const Command command : commands.of(letter))
            if (!walk.run(command)) return std::nullopt;
    }
    return walk.result(std::move(unit));
}

}  // namespace

Outline outline(const Model& system, std::uint64_t n, const Budget& budget,
                const FigureChoices& choices) {
    std::optional<Outline> found = lattice_outline(system, n, budget);
    if (!found) found = drawn_outline(system, n, budget, choices);
    make_set(found->strokes);
    make_set(found->polygons);
    return std::move(*found);
}

namespace {

using Complex = std::complex<double>;

constexpr double fine = 1e-7;  // of the size of a figure

/// A figure's middle and how far its points lie from it.
struct Spread {
    Complex middle;
    double mean = 0;  // square root of the mean of the squares
    std::size_t farthest = 0;

    explicit Spread(const std::vector<Complex>& points) {
        const auto count = static_cast<double>(points.size());
        middle = std::accumulate(points.begin(), points.end(), Complex()) / count;
        double squares = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            squares += std::norm(points[i] - middle);
            if (std::norm(points[i] - middle) > std::norm(points[farthest] - middle)) farthest = i;
        }
        mean = std::sqrt(squares / count);
    }
};

/// The points by their numbers. Throws BoundReached if doubles do not tell them apart.
NumberedPoints numbered(const std::vector<Complex>& points, const Spread& spread) {
    NumberedPoints numbers(spread.mean > 0 ? spread.mean * fine : 1);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (numbers.number({points[i].real(), points[i].imag(), 0}) != i)
            throw BoundReached(Bound::method,
                               "points of the figure lie too close together to be compared");
    return numbers;
}

/// The number of the image of each point under z -> factor (z - from) + to, with z mirrored if asked for;
/// empty if some image is no point.
std::vector<std::uint32_t> images(const Outline& left, const NumberedPoints& right,
                                  const Spread& from, const Spread& to, Complex factor,
                                  bool mirrored) {
    std::vector<std::uint32_t> found;
    for (const Complex point : left.points) {
        const Complex way = point - from.middle;
        const Complex image = to.middle + factor * (mirrored ? std::conj(way) : way);
        const std::uint32_t number = right.find({image.real(), image.imag(), 0});
        if (number == NumberedPoints::none) return {};
        found.push_back(number);
    }
    return found;
}

bool is_onto(const Outline& left, const Outline& right, const std::vector<std::uint32_t>& image) {
    std::vector<Outline::Stroke> strokes;
    for (const auto& [from, to] : left.strokes)
        strokes.push_back(std::minmax(image[from], image[to]));
    std::sort(strokes.begin(), strokes.end());
    if (strokes != right.strokes) return false;
    std::vector<std::vector<std::uint32_t>> polygons = left.polygons;
    for (std::vector<std::uint32_t>& polygon : polygons) {
        for (std::uint32_t& corner : polygon) corner = image[corner];
        std::sort(polygon.begin(), polygon.end());
    }
    std::sort(polygons.begin(), polygons.end());
    return polygons == right.polygons;
}

bool is_in_place(const Outline& left, const Outline& right, const NumberedPoints& numbers,
                 const Spread& from, const Spread& to) {
    if (std::abs(from.middle - to.middle) > to.mean * fine) return false;
    const auto image = images(left, numbers, from, to, 1, false);
    return !image.empty() && is_onto(left, right, image);
}

/// Points of a ring in a greater one.
std::vector<CyclotomicInteger> lifted(const Outline::Lattice& lattice, const CyclotomicRing& ring,
                                      bool mirrored) {
    const long factor = ring.order() / lattice.ring.order();
    std::vector<CyclotomicInteger> all;
    for (const CyclotomicInteger& point : lattice.points) {
        CyclotomicInteger sum = ring.zero();
        for (std::size_t i = 0; i < point.coefficients.size(); ++i) {
            CyclotomicInteger term = ring.zeta(static_cast<long>(i) * factor);
            ring.scale(term, point.coefficients[i]);
            ring.add(sum, term);
        }
        all.push_back(mirrored ? ring.conjugate(sum) : sum);
    }
    return all;
}

CyclotomicInteger difference(const CyclotomicRing& ring, CyclotomicInteger left,
                             const CyclotomicInteger& right) {
    ring.subtract(left, right);
    return left;
}

/// The square of a length in the ring, times the square of an integer.
CyclotomicInteger squared(const CyclotomicRing& ring, const CyclotomicInteger& way,
                          const Integer& factor) {
    CyclotomicInteger square = ring.multiply(way, ring.conjugate(way));
    ring.scale(square, factor * factor);
    return square;
}

/// Puts into `found` what the ring says of the motion that maps points to these; false if it is none.
bool proves(const Outline::Lattice& left, const Outline::Lattice& right,
            const std::vector<std::uint32_t>& image, bool mirrored, Similarity& found) {
    const CyclotomicRing ring(std::lcm(left.ring.order(), right.ring.order()));
    const auto from = lifted(left, ring, mirrored), to = lifted(right, ring, false);
    const std::size_t other = from.size() > 1 ? 1 : 0;
    const CyclotomicInteger way = difference(ring, from[other], from[0]);
    const CyclotomicInteger its_image = difference(ring, to[image[other]], to[image[0]]);
    for (std::size_t i = 0; i < from.size(); ++i)
        if (ring.multiply(difference(ring, from[i], from[0]), its_image) !=
            ring.multiply(difference(ring, to[image[i]], to[image[0]]), way))
            return false;
    found.exact = true;
    if (left.unit && right.unit)
        found.same_size =
            squared(ring, way, left.unit->numerator() * right.unit->denominator()) ==
            squared(ring, its_image, right.unit->numerator() * left.unit->denominator());
    return true;
}

/// A sentence where the numbers of some parts differ.
std::string number_difference(const Outline& left, const std::string& left_name,
                              const Outline& right, const std::string& right_name) {
    const auto told = [&](std::size_t l, std::size_t r, const std::string& noun) {
        return l == r ? std::string()
                      : "The figure of " + left_name + " has " + counted(l, "different " + noun) +
                            ", that of " + right_name + " has " + counted(r, "different " + noun) +
                            ".";
    };
    std::string found = told(left.strokes.size(), right.strokes.size(), "stroke");
    if (found.empty()) found = told(left.polygons.size(), right.polygons.size(), "filled polygon");
    if (found.empty()) found = told(left.points.size(), right.points.size(), "point");
    return found;
}

}  // namespace

Similarity similarity(const Outline& left, const std::string& left_name, const Outline& right,
                      const std::string& right_name) {
    Similarity found;
    found.difference = number_difference(left, left_name, right, right_name);
    found.exact = left.lattice && right.lattice;
    if (!found.difference.empty()) return found;
    if (left.points.empty()) {
        found.similar = found.same_size = found.same_place = true;
        return found;
    }
    const Spread from(left.points), to(right.points);
    numbered(left.points, from);  // or throws
    const NumberedPoints numbers = numbered(right.points, to);
    const double scale = from.mean > 0 ? to.mean / from.mean : 1;
    const Complex arm = left.points[from.farthest] - from.middle;
    for (const bool mirrored : {false, true})
        for (const Complex point : right.points) {
            if (std::abs(std::abs(point - to.middle) - scale * std::abs(arm)) > to.mean * fine)
                continue;
            const Complex factor =
                arm == Complex() ? 1 : (point - to.middle) / (mirrored ? std::conj(arm) : arm);
            const auto image = images(left, numbers, from, to, factor, mirrored);
            if (image.empty() || !is_onto(left, right, image)) continue;
            found.same_size = std::abs(scale - 1) < fine;
            if (found.exact && !proves(*left.lattice, *right.lattice, image, mirrored, found))
                continue;
            found.similar = true;
            found.same_place = found.same_size && is_in_place(left, right, numbers, from, to);
            return found;
        }
    found.same_size = false;
    found.difference = "The figures of " + left_name + " and " + right_name +
                       " have equally many strokes and points, but no motion, mirroring and change "
                       "of size brings one onto the other.";
    return found;
}

}  // namespace algae
