#include "turtle/detail/module_turtle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/model.hpp"

// What a file says that its symbols mean to a turtle, with all their parameters, and how its turtle starts.
//
// A declaration of the file comes first: `plot` with two or three parameters, `stamp`, `solid`, `surface`.
// Otherwise a symbol means what its name says (F and F_x, f and f_x, one character of the table at
// ModuleTurtle). The first parameter of a module says how much; some commands look at all of them.
// Solids, surfaces and stamps become measures and polygons here, in steps along heading, left and up of
// the turtle; the turtle only places them.

namespace algae {

namespace {

using Corners = std::vector<Vector>;

Vector place(const Triple& point) { return {point.x.value, point.y.value, point.z.value}; }

/// The cubic Bernstein polynomials.
std::array<double, 4> weights(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// An outline that is the same on both sides of the heading: a cubic Bezier curve from the turtle to
/// the tip and its mirror image.
Corners mirrored(const std::array<Vector, 4>& side) {
    constexpr int parts = 12;
    Corners out;
    for (int i = 0; i <= parts; ++i) {
        const auto weight = weights(static_cast<double>(i) / parts);
        Vector point;
        for (std::size_t k = 0; k < 4; ++k) point = point + weight[k] * side[k];
        out.push_back(point);
    }
    for (int i = parts - 1; i > 0; --i) {
        const Vector& point = out[static_cast<std::size_t>(i)];
        out.push_back({point.x, -point.y, point.z});
    }
    return out;
}

Corners disc() {
    constexpr int corners = 32;
    Corners out;
    for (int i = 0; i < corners; ++i) {
        const Turn turn = turn_by(360.0 * i / corners);
        out.push_back({turn.cosine / 2, turn.sine / 2, 0});
    }
    return out;
}

std::vector<Corners> patch(const std::vector<Triple>& points) {
    constexpr int parts = 6;
    const auto at = [&](int row, int column) {
        const auto across = weights(static_cast<double>(column) / parts),
                   along = weights(static_cast<double>(row) / parts);
        Vector point;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                point = point + along[i] * across[j] * place(points[4 * i + j]);
        return point;
    };
    std::vector<Corners> out;
    for (int row = 0; row < parts; ++row)
        for (int column = 0; column < parts; ++column) {
            const Vector a = at(row, column), b = at(row + 1, column), c = at(row + 1, column + 1),
                         d = at(row, column + 1);
            out.push_back({a, b, c});
            out.push_back({a, c, d});
        }
    return out;
}

}  // namespace

std::vector<std::vector<Vector>> surface_faces(const SurfaceSetting& surface) {
    if (surface.kind == "leaf")
        return {mirrored({Vector{}, {0.2, 0.8 / 3, 0}, {0.6, 0.8 / 3, 0}, {1, 0, 0}})};
    if (surface.kind == "petal")
        return {mirrored({Vector{}, {0.5, 0.19, 0}, {1, 0.57, 0}, {1, 0, 0}})};
    if (surface.kind == "disc") return {disc()};
    if (surface.kind == "patch") return patch(surface.points);
    Corners corners;
    for (const Triple& point : surface.points) corners.push_back(place(point));
    return {corners};
}

bool is_flat(const SurfaceSetting& surface) {
    return std::all_of(surface.points.begin(), surface.points.end(),
                       [](const Triple& point) { return point.z.value == 0; });
}

SolidModule::SolidModule(const SolidSetting& setting) {
    const SolidKind* const kind = solid_kind(setting.kind);
    if (!kind) throw Error("expected a kind of solid, found '" + setting.kind + "'");
    kind_ = static_cast<Kind>(kind - solid_kinds().data());
    parameters_.fill(absent);
    for (std::size_t i = 0; i < kind->measures.size(); ++i) {
        const auto at =
            std::find(setting.measures.begin(), setting.measures.end(), kind->measures[i].name);
        if (at != setting.measures.end())
            parameters_[i] = static_cast<std::uint32_t>(at - setting.measures.begin());
    }
}

std::optional<SolidShape> SolidModule::shape() const {
    if (kind_ == rotation || kind_ == translation) return std::nullopt;
    return static_cast<SolidShape>(kind_);
}

std::optional<double> SolidModule::measure(std::size_t number, const double* values,
                                           std::uint32_t count) const {
    if (parameters_[number] >= count) return std::nullopt;
    return values[parameters_[number]];
}

Vector SolidModule::size(const double* values, std::uint32_t count) const {
    const double otherwise = shape() ? 1 : 0;
    const auto said = [&](std::size_t number) {
        return measure(number, values, count).value_or(otherwise);
    };
    if (kind_ == sphere) return {said(0), 0, 0};
    if (kind_ == cylinder || kind_ == cone) return {said(1), said(0), 0};
    return {said(0), said(1), said(2)};
}

std::optional<double> SolidModule::colour(const double* values, std::uint32_t count) const {
    if (!shape()) return std::nullopt;
    return measure(solid_kinds()[kind_].measures.size() - 1, values, count);
}

void TurtleEvents::stamp(StampShape shape, double size, const TurtleState& state) {
    polygon(stamp_corners(shape, size, state));
}

std::vector<Vector> stamp_corners(StampShape shape, double size, const TurtleState& state) {
    constexpr int round = 64;
    const int corners = shape == StampShape::square ? 4 : shape == StampShape::triangle ? 3 : round;
    const double first = shape == StampShape::square ? 45 : 0;
    const double radius = shape == StampShape::square     ? size * (std::numbers::sqrt2 / 2)
                          : shape == StampShape::triangle ? size / std::numbers::sqrt3
                                                          : size / 2;
    std::vector<Vector> out;
    for (int i = 0; i < corners; ++i) {
        const Turn turn = turn_by(first + 360.0 * i / corners);
        double ahead = radius * turn.cosine, aside = radius * turn.sine;
        if (shape == StampShape::square) {
            ahead = std::copysign(size / 2, ahead);
            aside = std::copysign(size / 2, aside);
        }
        out.push_back(state.position + ahead * state.attitude.heading() +
                      aside * state.attitude.left());
    }
    return out;
}

namespace {

/// What the file itself says of the letter. False if it says nothing.
bool take_setting(const Drawing& drawing, Symbol letter, TurtleCommand& command) {
    if ((command.parameters == 2 || command.parameters == 3) &&
        std::count(drawing.plotters.begin(), drawing.plotters.end(), letter) > 0) {
        command.operation = TurtleOperation::plot;
        command.leaves_plane = command.parameters > 2;
        return true;
    }
    if ((command.parameters == 1 || command.parameters == 2) &&
        std::ranges::count(drawing.elastic, letter) > 0) {
        command.operation = TurtleOperation::elasticity;
        return true;
    }
    for (const Drawing::Stamp& stamp : drawing.stamps)
        if (stamp.symbol == letter) {
            command.operation = TurtleOperation::stamp;
            command.shape = stamp.shape;
            return true;
        }
    for (const SolidSetting& solid : drawing.solids)
        if (solid.symbol == letter) {
            command.operation = TurtleOperation::solid;
            command.solid.emplace(solid);
            command.leaves_plane = true;
            return true;
        }
    for (const SurfaceSetting& surface : drawing.surfaces)
        if (surface.symbol == letter) {
            command.operation = TurtleOperation::surface;
            command.faces = surface_faces(surface);
            command.leaves_plane = !is_flat(surface);
            return true;
        }
    return false;
}

}  // namespace

TurtleOperation named_operation(const std::string& name, const Drawing& drawing,
                                std::uint32_t parameters) {
    using enum TurtleOperation;
    static constexpr std::pair<char, TurtleOperation> table[] = {{'G', draw_unmarked},
                                                                 {'+', left},
                                                                 {'-', right},
                                                                 {'&', down},
                                                                 {'^', up},
                                                                 {'\\', roll_left},
                                                                 {'/', roll_right},
                                                                 {'|', back},
                                                                 {'$', level},
                                                                 {'@', level},
                                                                 {'[', push},
                                                                 {']', pop},
                                                                 {'{', open_polygon},
                                                                 {'}', close_polygon},
                                                                 {'.', vertex},
                                                                 {'\'', colour},
                                                                 {'%', cut},
                                                                 {'*', scale},
                                                                 {'!', width}};
    if (name == "F" || name.starts_with("F_")) return draw;
    if (name == "f" || name.starts_with("f_")) return move;
    if (name.size() != 1) return nothing;
    for (const auto& [symbol, operation] : table) {
        if (symbol != name[0]) continue;
        const bool wants_factor = parameters == 0 && ((operation == scale && !drawing.scale) ||
                                                      (operation == width && !drawing.narrow));
        return wants_factor ? nothing : operation;
    }
    return nothing;
}

bool is_turtle_name(const std::string& name) {
    return named_operation(name, Drawing{}, 1) != TurtleOperation::nothing;
}

bool turns_out_of_plane(const std::string& name) {
    return name == "&" || name == "^" || name == "\\" || name == "/" || name == "$";
}

std::uint32_t TurtleCommand::read() const {
    const bool all = operation == TurtleOperation::plot || operation == TurtleOperation::colour ||
                     operation == TurtleOperation::solid ||
                     operation == TurtleOperation::elasticity;
    return all ? parameters : std::min(parameters, 1U);
}

TurtleCommand turtle_command(const Alphabet& alphabet, const Drawing& drawing, Symbol letter,
                             std::uint32_t parameters) {
    TurtleCommand command;
    command.parameters = parameters;
    if (take_setting(drawing, letter, command)) return command;
    const std::string& name = alphabet.name(letter);
    command.operation = named_operation(name, drawing, parameters);
    command.leaves_plane = turns_out_of_plane(name);
    return command;
}

namespace {

double value_or(const std::optional<Quantity>& setting, double otherwise) {
    return setting ? setting->value : otherwise;
}

}  // namespace

double step_length(const Drawing& drawing, std::uint64_t generation, const std::string& name) {
    const double step = value_or(drawing.step, 1) *
                        std::pow(value_or(drawing.shrink, 1), static_cast<double>(generation));
    if (!std::isfinite(step) || step == 0)
        throw Error(name + ": the step of the turtle is " + std::to_string(step) +
                    ", expected a length that a drawing can have; see step and shrink");
    return step;
}

TurtleManner turtle_manner(const Model& system, std::uint64_t generation, const std::string& name) {
    const Drawing& drawing = system.drawing;
    TurtleManner manner;
    manner.angle = value_or(drawing.angle, 90);
    manner.clockwise = drawing.clockwise;
    if (manner.clockwise) manner.angle = -manner.angle;
    manner.scale = value_or(drawing.scale, 1);
    manner.narrow = value_or(drawing.narrow, 1);
    if (const auto& to = drawing.tropism)
        manner.tropism = Vector{to->x.value, to->y.value, to->z.value};
    manner.bends_before = drawing.bends_before;
    TurtleState& start = manner.start;
    start.susceptibility = value_or(drawing.susceptibility, 1);
    start.step = step_length(drawing, generation, name);
    double heading = std::fmod(value_or(drawing.spin, 0) * static_cast<double>(generation), 360.0);
    if (drawing.start) {
        start.position = {drawing.start->x.value, drawing.start->y.value, 0};
        heading += drawing.start->heading.value;
    }
    if (!std::isfinite(heading))
        throw Error(name + ": the heading of the start is no number; see start and spin");
    // Upward in space: the plane of the figure stands on its lower side, x stays and y becomes z.
    if (drawing.start && drawing.start->upward && leaves_plane(system))
        start.attitude.roll(turn_by(-90));
    start.attitude.yaw(turn_by(heading));
    return manner;
}

}  // namespace algae
