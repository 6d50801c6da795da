#include "oracle/turtle.hpp"

#include <numbers>
#include <numeric>
#include <ostream>

namespace algae::oracle {

namespace {

Quantity quantity_of(const Fraction& fraction) {
    return quantity(Rational(Integer(fraction.numerator), Integer(fraction.denominator)));
}

struct State {
    long heading = 0;  // in units of a full turn divided by the order
    Real size = 1, width = 1;
    unsigned colour = 0;
    Spot at;
    Polynomial exact;
};

/// The remainder of p divided by a polynomial with leading coefficient 1.
Polynomial remainder_of(Polynomial p, const Polynomial& divisor) {
    while (p.size() >= divisor.size()) {
        const long leading = p.back();
        for (std::size_t i = 0; i < divisor.size(); ++i)
            p[p.size() - divisor.size() + i] -= leading * divisor[i];
        p.pop_back();
    }
    return p;
}

Polynomial quotient_of(Polynomial p, const Polynomial& divisor) {
    Polynomial quotient(p.size() - divisor.size() + 1, 0);
    while (p.size() >= divisor.size()) {
        const long leading = p.back();
        quotient[p.size() - divisor.size()] = leading;
        for (std::size_t i = 0; i < divisor.size(); ++i)
            p[p.size() - divisor.size() + i] -= leading * divisor[i];
        p.pop_back();
    }
    return quotient;
}

/// The constant that a polynomial is at a primitive m-th root of unity, if it is one.
std::optional<long> constant_of(const Polynomial& p, long m) {
    const Polynomial rest = remainder_of(p, cyclotomic_polynomial(m));
    for (std::size_t i = 1; i < rest.size(); ++i)
        if (rest[i] != 0) return std::nullopt;
    return rest.empty() ? 0 : rest[0];
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const TurtleSettings& settings) {
    const auto show = [&](const char* name, const Fraction& fraction) {
        out << name << ' ' << fraction.numerator << '/' << fraction.denominator << ' ';
    };
    show("angle", settings.angle);
    show("x", settings.x);
    show("y", settings.y);
    show("heading", settings.heading);
    show("spin", settings.spin);
    show("step", settings.step);
    show("shrink", settings.shrink);
    if (settings.scale) show("scale", *settings.scale);
    if (settings.narrow) show("narrow", *settings.narrow);
    return out << (settings.clockwise ? "clockwise" : "");
}

algae::Drawing settings_of(const TurtleSettings& written) {
    algae::Drawing settings;
    settings.angle = quantity_of(written.angle);
    settings.start = algae::Drawing::Start{quantity_of(written.x), quantity_of(written.y),
                                           quantity_of(written.heading)};
    settings.spin = quantity_of(written.spin);
    settings.step = quantity_of(written.step);
    settings.shrink = quantity_of(written.shrink);
    settings.clockwise = written.clockwise;
    if (written.scale) settings.scale = quantity_of(*written.scale);
    if (written.narrow) settings.narrow = quantity_of(*written.narrow);
    return settings;
}

Drawing drawing_of(const std::string& word, const TurtleSettings& settings, unsigned n) {
    // One unit of heading is a degree divided by the product of all denominators.
    const long parts =
        std::lcm(4L, std::lcm(settings.angle.denominator,
                              std::lcm(settings.heading.denominator, settings.spin.denominator)));
    const auto units = [&](const Fraction& degrees) {
        return degrees.numerator * (parts / degrees.denominator);
    };
    long full = 360 * parts;
    long turn = units(settings.angle),
         start = units(settings.heading) + units(settings.spin) * static_cast<long>(n);
    const long common = std::gcd(std::gcd(full / 4, turn), start);
    full /= common;
    turn /= common;
    start /= common;
    if (settings.clockwise) turn = -turn;

    Real unit = settings.step.value();
    for (unsigned k = 0; k < n; ++k) unit *= settings.shrink.value();

    Drawing drawing;
    drawing.order = full;
    State turtle;
    turtle.heading = ((start % full) + full) % full;
    turtle.at = Spot(settings.x.value(), settings.y.value());
    turtle.exact.assign(static_cast<std::size_t>(full), 0);
    std::vector<State> saved;
    std::vector<std::vector<Spot>> open;
    const auto go = [&] {
        const Real radians = 2 * std::numbers::pi_v<Real> * static_cast<Real>(turtle.heading) /
                             static_cast<Real>(full);
        turtle.at += unit * turtle.size * Spot(std::cos(radians), std::sin(radians));
        ++turtle.exact[static_cast<std::size_t>(turtle.heading)];
    };
    const auto turn_by = [&](long by) {
        turtle.heading = (((turtle.heading + by) % full) + full) % full;
    };
    const auto draw = [&] {
        Stroke stroke{turtle.at, {}, turtle.width, turtle.colour};
        drawing.points.push_back(turtle.at);
        drawing.touched.push_back(turtle.exact);
        go();
        stroke.to = turtle.at;
        drawing.points.push_back(turtle.at);
        drawing.touched.push_back(turtle.exact);
        drawing.strokes.push_back(stroke);
    };
    const auto corner = [&] {
        if (!open.empty()) open.back().push_back(turtle.at);
    };
    for (std::size_t i = 0; i < word.size(); ++i) switch (word[i]) {
            case 'F':
                draw();
                corner();
                break;
            case 'G':
                draw();
                break;
            case 'f':
                go();
                corner();
                break;
            case '+':
                turn_by(turn);
                break;
            case '-':
                turn_by(-turn);
                break;
            case '|':
                turn_by(full / 2);
                break;
            case '[':
                saved.push_back(turtle);
                break;
            case ']':
                turtle = saved.back();
                saved.pop_back();
                break;
            case '{':
                open.emplace_back();
                corner();
                break;
            case '.':
                corner();
                break;
            case '}':
                if (open.back().size() > 2) {
                    drawing.points.insert(drawing.points.end(), open.back().begin(),
                                          open.back().end());
                    drawing.polygons.push_back(open.back());
                }
                open.pop_back();
                break;
            case '*':
                turtle.size *= settings.scale ? settings.scale->value() : 1;
                break;
            case '!':
                turtle.width *= settings.narrow ? settings.narrow->value() : 1;
                break;
            case '\'':
                ++turtle.colour;
                break;
            case '%': {  // to just before the bracket that closes this branch, or to the end
                long depth = 0;
                while (i + 1 < word.size() && !(word[i + 1] == ']' && depth == 0)) {
                    ++i;
                    depth += word[i] == '[' ? 1 : word[i] == ']' ? -1 : 0;
                }
                break;
            }
            default:
                break;
        }
    drawing.end = turtle.at;
    drawing.exact_end = turtle.exact;
    return drawing;
}

Polynomial cyclotomic_polynomial(long m) {
    Polynomial p(static_cast<std::size_t>(m) + 1, 0);
    p.front() = -1;
    p.back() = 1;
    for (long d = 1; d < m; ++d)
        if (m % d == 0) p = quotient_of(p, cyclotomic_polynomial(d));
    return p;
}

std::optional<long> twice_real_part(const Polynomial& p, long m) {
    Polynomial sum(static_cast<std::size_t>(m), 0);
    for (std::size_t k = 0; k < p.size(); ++k) {
        const auto size = static_cast<std::size_t>(m);
        sum[k % size] += p[k];
        sum[(size - k % size) % size] += p[k];
    }
    return constant_of(sum, m);
}

std::optional<long> twice_imaginary_part(const Polynomial& p, long m) {
    // The imaginary part of z is the real part of z / i.
    Polynomial turned(static_cast<std::size_t>(m), 0);
    for (std::size_t k = 0; k < p.size(); ++k)
        turned[(k + static_cast<std::size_t>(m - m / 4)) % static_cast<std::size_t>(m)] += p[k];
    return twice_real_part(turned, m);
}

Real distance(Spot point, Spot from, Spot to) {
    const Spot way = to - from;
    const Real length = std::norm(way);
    if (length == 0) return std::abs(point - from);
    Real along = ((point - from) * std::conj(way)).real() / length;
    along = along < 0 ? 0 : along > 1 ? 1 : along;
    return std::abs(point - from - along * way);
}

}  // namespace algae::oracle
