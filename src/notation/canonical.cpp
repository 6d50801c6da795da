#include "notation/canonical.hpp"

#include <utility>

#include "notation/print.hpp"
#include "notation/settings_grammar.hpp"

namespace algae {

namespace {

/// Gathers the lines.
class Lines {
public:
    void setting(const char* keyword, const std::string& value) {
        if (!value.empty()) lines_.push_back({keyword, std::string(keyword) + ' ' + value});
    }
    void number(const char* keyword, const std::optional<Quantity>& value) {
        if (value) setting(keyword, to_text(value->expression));
    }
    void system(const std::string& name, std::vector<CanonicalLine> inside) {
        lines_.push_back({"system", "system " + name + " {", std::move(inside)});
    }
    void rule(std::string text) { lines_.push_back({"->", std::move(text)}); }
    std::vector<CanonicalLine> take() { return std::move(lines_); }

private:
    std::vector<CanonicalLine> lines_;
};

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
    return out;
}

void add_rules(const LSystem& system, const Printer& printer, Lines& lines) {
    std::size_t opened = 0;
    const auto open_tables = [&](std::size_t end) {
        for (; opened < end; ++opened) lines.setting("table", system.tables[opened]);
    };
    for (const Production& rule : system.rules) {
        if (!system.tables.empty()) open_tables(rule.table + 1);
        lines.rule(printer.rule(rule));
    }
    open_tables(system.tables.size());
    lines.setting("schedule", joined(schedule_names(system)));
}

/// A number as one piece among several.
std::string piece(const Quantity& number) {
    const std::string text = to_text(number.expression);
    return text.find(' ') == std::string::npos ? text : '(' + text + ')';
}

void add_words(const LSystem& system, const Printer& printer, Lines& lines) {
    lines.setting("axiom", printer.word(system.axiom));
    add_rules(system, printer, lines);
    lines.setting("ignore", printer.apart(system.ignored));
}

std::string print_start(const Settings::Start& start) {
    return joined({piece(start.x), piece(start.y), piece(start.heading)});
}

std::string print_range(const std::pair<std::uint64_t, std::uint64_t>& range) {
    const auto [first, last] = range;
    return std::to_string(first) + (last == first ? "" : ".." + std::to_string(last));
}

std::string print_direction(const Direction& direction) {
    return joined({piece(direction.azimuth), piece(direction.elevation)});
}

/// What symbols leave in space, and where steps bend to.
void add_space(const Settings& settings, const Printer& printer, Lines& lines) {
    for (const SolidSetting& solid : settings.solids)
        lines.setting("solid", printer.apart({solid.symbol}) + ' ' + print_solid(solid));
    for (const SurfaceSetting& surface : settings.surfaces)
        lines.setting("surface", printer.apart({surface.symbol}) + ' ' + print_surface(surface));
    if (const auto& to = settings.tropism)
        lines.setting("tropism", joined({piece(to->x), piece(to->y), piece(to->z)}));
    lines.number("susceptibility", settings.susceptibility);
}

/// How figures in space are looked at.
void add_views(const Settings& settings, Lines& lines) {
    if (const auto& camera = settings.camera) {
        std::vector<std::string> parts{print_direction(camera->from)};
        if (camera->perspective) parts.emplace_back("perspective");
        if (camera->opening) parts.push_back(piece(*camera->opening));
        lines.setting("camera", joined(parts));
    }
    if (settings.light) lines.setting("light", print_direction(*settings.light));
    lines.number("fog", settings.fog);
}

void add_settings(const Settings& settings, const Printer& printer, Lines& lines) {
    lines.number("angle", settings.angle);
    lines.number("step", settings.step);
    lines.number("shrink", settings.shrink);
    if (settings.start) lines.setting("start", print_start(*settings.start));
    lines.number("spin", settings.spin);
    lines.number("scale", settings.scale);
    lines.number("narrow", settings.narrow);
    lines.setting("plot", printer.apart(settings.plotters));
    for (const Settings::Stamp& stamp : settings.stamps)
        lines.setting("stamp", printer.apart({stamp.symbol}) + ' ' + shape_name(stamp.shape));
    add_space(settings, printer, lines);
    lines.number("width", settings.width);
    lines.setting("colour", joined(settings.colours));
    if (settings.clockwise) lines.setting("turn", "clockwise");
    add_views(settings, lines);
    if (settings.generations) lines.setting("generation", print_range(*settings.generations));
    if (settings.seeds) lines.setting("seed", print_range(*settings.seeds));
}

}  // namespace

std::string print_environment(const Alphabet& alphabet, const EnvironmentSetting& environment) {
    std::vector<std::string> parts{alphabet.name(environment.module), environment.kind};
    for (const Quantity& number : environment.numbers) parts.push_back(piece(number));
    return joined(parts);
}

std::string print_solid(const SolidSetting& solid) {
    return solid.kind + (solid.measures.empty() ? "" : ' ' + joined(solid.measures));
}

std::string print_surface(const SurfaceSetting& surface) {
    std::string out = surface.kind;
    for (const Triple& point : surface.points)
        out += " (" + to_text(point.x.expression) + ", " + to_text(point.y.expression) + ", " +
               to_text(point.z.expression) + ')';
    return out;
}

std::vector<CanonicalLine> canonical_lines(const LSystem& system) {
    const Printer printer(system.alphabet);
    Lines lines;
    lines.setting("title", system.title);
    lines.setting("source", system.source);
    lines.setting("id", joined(system.identifiers));
    lines.setting("alphabet", printer.apart(system.declared));
    for (const auto& [name, value] : system.constants)
        lines.setting("let", name + " = " + to_text(value.expression));
    for (const InnerSystem& inner : system.inner) {
        Lines inside;
        add_words(inner.system, printer, inside);
        lines.system(inner.name, inside.take());
    }
    add_words(system, printer, lines);
    lines.setting("terminals", printer.apart(system.terminals));
    for (const Production& rule : system.interpretation)
        lines.setting("interpret", printer.rule(rule));
    for (const EnvironmentSetting& environment : system.environments)
        lines.setting("environment", print_environment(system.alphabet, environment));
    add_settings(system.settings, printer, lines);
    for (const Expectation& expectation : system.expectations)
        lines.setting("expect", expectation.kind + ' ' + std::to_string(expectation.generation) +
                                    ": " + expectation.value);
    return lines.take();
}

}  // namespace algae
