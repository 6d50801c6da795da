#include "turtle/turtle_command.hpp"

#include <algorithm>

#include "turtle/surface.hpp"

namespace algae {

namespace {

/// What a symbol of one character means where the file does not say otherwise.
TurtleOperation standard_operation(char symbol, const Settings& settings,
                                   std::uint32_t parameters) {
    switch (symbol) {
        case 'G':
            return TurtleOperation::draw_unmarked;
        case '+':
            return TurtleOperation::left;
        case '-':
            return TurtleOperation::right;
        case '&':
            return TurtleOperation::down;
        case '^':
            return TurtleOperation::up;
        case '\\':
            return TurtleOperation::roll_left;
        case '/':
            return TurtleOperation::roll_right;
        case '|':
            return TurtleOperation::back;
        case '$':
        case '@':
            return TurtleOperation::level;
        case '[':
            return TurtleOperation::push;
        case ']':
            return TurtleOperation::pop;
        case '{':
            return TurtleOperation::open_polygon;
        case '}':
            return TurtleOperation::close_polygon;
        case '.':
            return TurtleOperation::vertex;
        case '\'':
            return TurtleOperation::colour;
        case '%':
            return TurtleOperation::cut;
        case '*':
            return parameters > 0 || settings.scale ? TurtleOperation::scale
                                                    : TurtleOperation::nothing;
        case '!':
            return parameters > 0 || settings.narrow ? TurtleOperation::width
                                                     : TurtleOperation::nothing;
        default:
            return TurtleOperation::nothing;
    }
}

/// What the file itself says of the letter. False if it says nothing.
bool take_setting(const Settings& settings, Symbol letter, TurtleCommand& command) {
    if ((command.parameters == 2 || command.parameters == 3) &&
        std::count(settings.plotters.begin(), settings.plotters.end(), letter) > 0) {
        command.operation = TurtleOperation::plot;
        command.leaves_plane = command.parameters > 2;
        return true;
    }
    for (const Settings::Stamp& stamp : settings.stamps)
        if (stamp.symbol == letter) {
            command.operation = TurtleOperation::stamp;
            command.shape = stamp.shape;
            return true;
        }
    for (const SolidSetting& solid : settings.solids)
        if (solid.symbol == letter) {
            command.operation = TurtleOperation::solid;
            command.solid.emplace(solid);
            command.leaves_plane = true;
            return true;
        }
    for (const SurfaceSetting& surface : settings.surfaces)
        if (surface.symbol == letter) {
            command.operation = TurtleOperation::surface;
            command.faces = surface_faces(surface);
            command.leaves_plane = !is_flat(surface);
            return true;
        }
    return false;
}

}  // namespace

std::uint32_t TurtleCommand::read() const {
    const bool all = operation == TurtleOperation::plot || operation == TurtleOperation::colour ||
                     operation == TurtleOperation::solid;
    return all ? parameters : std::min(parameters, 1U);
}

TurtleCommand turtle_command(const LSystem& system, Symbol letter, std::uint32_t parameters) {
    TurtleCommand command;
    command.parameters = parameters;
    if (take_setting(system.settings, letter, command)) return command;
    const std::string& name = system.alphabet.name(letter);
    if (name == "F" || name.starts_with("F_"))
        command.operation = TurtleOperation::draw;
    else if (name == "f" || name.starts_with("f_"))
        command.operation = TurtleOperation::move;
    else if (name.size() == 1)
        command.operation = standard_operation(name[0], system.settings, parameters);
    const bool turns = command.operation >= TurtleOperation::down &&
                       command.operation <= TurtleOperation::roll_right;
    command.leaves_plane = turns || name == "$";
    return command;
}

}  // namespace algae
