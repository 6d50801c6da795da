#include "exchange/maple_file.hpp"

#include "base/error.hpp"
#include "exchange/maple_words.hpp"
#include "notation/characters.hpp"
#include "notation/print.hpp"
#include "notation/read.hpp"

namespace algae {

namespace {

/// Whether the three numbers of a vector are these.
bool is_vector(const MapleValues& values, const MapleValue& list, const std::vector<int>& entries) {
    bool same = list.items.size() == entries.size();
    for (std::size_t i = 0; same && i < entries.size(); ++i)
        same = values.rational(list.items[i], "a number") == entries[i];
    return same;
}

void read_position(const MapleValues& values, const MapleValue& said, Settings::Start& start) {
    const MapleValue& point = values.list(said, "the position, a list of coordinates");
    if (point.items.size() != 2 && point.items.size() != 3)
        values.fail(
            said, "expected two or three coordinates, found " + std::to_string(point.items.size()));
    if (point.items.size() == 3 &&
        !values.rational(point.items[2], "the third coordinate").is_zero())
        values.fail(point.items[2], "expected 0: figures begin in the plane of x and y");
    start.x = quantity(values.rational(point.items[0], "a coordinate"));
    start.y = quantity(values.rational(point.items[1], "a coordinate"));
}

/// An angle in radians as degrees.
Quantity degrees(const MapleValues& values, const MapleValue& said) {
    const Rational pi("3.14159265358979323846264338327950288419716939937511");
    return quantity(values.rational(said, "the heading, radians such as Pi/2") * 180 / pi);
}

/// Where the turtle starts: as GRAFICO says, if the worksheet holds it; otherwise along x, in the
/// stochastic procedure upward.
void read_start(MapleValues& values, MapleForm form, LSystem& system) {
    Settings::Start start{quantity(0), quantity(0),
                          quantity(form == MapleForm::stochastic ? 90 : 0)};
    const auto& said = values.sheet().start;
    if (const auto found = said.find("PONTOA"); found != said.end())
        read_position(values, found->second, start);
    if (const auto found = said.find("ANGULO"); found != said.end())
        start.heading = degrees(values, found->second);
    const std::pair<const char*, std::vector<int>> frame[] = {
        {"vH", {1, 0, 0}}, {"vL", {0, 1, 0}}, {"vU", {0, 0, 1}}};
    for (const auto& [name, entries] : frame)
        if (const auto found = said.find(name); found != said.end())
            if (!is_vector(values, values.list(found->second, "a vector"), entries))
                values.fail(found->second, std::string("expected ") + name +
                                               " as in the procedure: figures in space begin "
                                               "along x, with z up");
    const bool at_rest =
        start.x.exact->is_zero() && start.y.exact->is_zero() && start.heading.exact->is_zero();
    if (!at_rest) system.settings.start = start;
    if (const auto found = said.find("SEGMENTO"); found != said.end()) {
        const Quantity step = values.setting(found->second, "the length of a step");
        if (!(step.value > 0)) values.fail(found->second, "expected a length above 0");
        if (step.value != 1) system.settings.step = step;
    }
}

void read_generation(const MapleValues& values, const MapleValue& said, LSystem& system) {
    if (bare_name(said) == "N" && !values.sheet().find("N")) return;
    const Rational count = values.rational(said, "the number of steps");
    if (!count.is_integer() || sign(count) < 0 || count >= power(Rational(2), 63))
        values.fail(said, "expected a whole number of steps from 0 to 2^63 - 1, found " +
                              shortest_text(count));
    const std::uint64_t generation = std::stoull(to_string(count));
    system.settings.generations = {generation, generation};
}

}  // namespace

LSystem read_maple(std::string_view text, const std::string& name) {
    Scanner scanner(text, name, {"#"}, '>');
    const MapleWorksheet sheet = read_maple_worksheet(scanner);
    MapleValues values(scanner, sheet);
    const std::vector<MapleValue>& arguments = sheet.arguments;
    if (arguments.size() != 2 && arguments.size() != 4 && arguments.size() != 5)
        scanner.fail_at(sheet.call,
                        "expected Lsystem(AXIOMA, REGRAS, INCREMENTO, N), Lsystem(AXIOMA, REGRAS, "
                        "PROB, INCREMENTO, N) or Lsystem(AXIOMA, N), found " +
                            std::to_string(arguments.size()) + " arguments");
    const MapleForm form = arguments.size() == 2   ? MapleForm::parametric
                           : arguments.size() == 4 ? MapleForm::strings
                                                   : MapleForm::stochastic;
    LSystem system;
    if (form == MapleForm::parametric)
        read_maple_modules(values, system);
    else
        read_maple_words(values, system);
    if (form != MapleForm::parametric)
        system.settings.angle =
            values.setting(arguments[arguments.size() - 2], "the increment, degrees");
    read_start(values, form, system);
    read_generation(values, arguments.back(), system);
    system.constants = values.constants();
    try {
        return read_lsystem(print_lsystem(system), name);
    } catch (const Diagnostics& error) {
        scanner.fail_at(sheet.call, "this system cannot be said in the notation: " +
                                        error.findings().front().message);
    }
}

}  // namespace algae
