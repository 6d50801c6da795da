#include "turtle/similarity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "turtle/segment_set.hpp"

namespace algae {

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

/// The number of the image of each point under z -> factor (z - from) + to, with z mirrored if asked for;
/// empty if some image is no point.
std::vector<std::uint32_t> images(const Outline& left, const Outline& right, const Spread& from,
                                  const Spread& to, Complex factor, bool mirrored) {
    NumberedPoints numbers(to.mean * fine);
    std::vector<std::uint32_t> of_right;
    for (std::size_t i = 0; i < right.points.size(); ++i)
        if (numbers.number({right.points[i].real(), right.points[i].imag(), 0}) != i) return {};
    std::vector<std::uint32_t> found;
    for (const Complex point : left.points) {
        const Complex way = point - from.middle;
        const Complex image = to.middle + factor * (mirrored ? std::conj(way) : way);
        const std::uint32_t number = numbers.number({image.real(), image.imag(), 0});
        if (number >= right.points.size()) return {};
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

bool is_in_place(const Outline& left, const Outline& right, const Spread& from, const Spread& to) {
    if (std::abs(from.middle - to.middle) > to.mean * fine) return false;
    const auto image = images(left, right, from, to, 1, false);
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

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " different " + noun + (count == 1 ? "" : "s");
}

/// A sentence where the numbers of some parts differ.
std::string number_difference(const Outline& left, const std::string& left_name,
                              const Outline& right, const std::string& right_name) {
    const auto told = [&](std::size_t l, std::size_t r, const std::string& noun) {
        return l == r ? std::string()
                      : "The figure of " + left_name + " has " + counted(l, noun) + ", that of " +
                            right_name + " has " + counted(r, noun) + ".";
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
    const double scale = to.mean / from.mean;
    const Complex arm = left.points[from.farthest] - from.middle;
    for (const bool mirrored : {false, true})
        for (const Complex point : right.points) {
            if (std::abs(std::abs(point - to.middle) - scale * std::abs(arm)) > to.mean * fine)
                continue;
            const Complex factor = (point - to.middle) / (mirrored ? std::conj(arm) : arm);
            const auto image = images(left, right, from, to, factor, mirrored);
            if (image.empty() || !is_onto(left, right, image)) continue;
            found.same_size = std::abs(scale - 1) < fine;
            if (found.exact && !proves(*left.lattice, *right.lattice, image, mirrored, found))
                continue;
            found.similar = true;
            found.same_place = found.same_size && is_in_place(left, right, from, to);
            return found;
        }
    found.same_size = false;
    found.difference = "The figures of " + left_name + " and " + right_name +
                       " have equally many strokes and points, but no motion, mirroring and change "
                       "of size brings one onto the other.";
    return found;
}

}  // namespace algae
