#include <algorithm>
#include <utility>

#include "notation/characters.hpp"
#include "notation/clauses.hpp"
#include "notation/expression_grammar.hpp"
#include "notation/settings_grammar.hpp"
#include "notation/suggestion.hpp"
#include "notation/word_grammar.hpp"

namespace algae {

namespace {

constexpr std::size_t patch_points = 16, least_corners = 3;

const char* end_of(const Clause& clause) { return clause.text.data() + clause.text.size(); }

/// What may stand there, as a message lists it.
std::string listed(const std::vector<std::string>& names) {
    std::string out;
    for (std::size_t i = 0; i < names.size(); ++i)
        out += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
    return out;
}

[[noreturn]] void refuse(std::string_view found, const std::vector<std::string>& names) {
    throw SyntaxError{found.data(), "expected " + listed(names) + ", found " + quoted(found) +
                                        did_you_mean(found, names)};
}

/// So many numbers, and no more than that; `what` is for messages.
std::vector<Quantity> numbers_of(const Clause& clause, std::size_t count, const char* what,
                                 Reading& reading) {
    const auto parts = pieces(clause.value());
    if (parts.size() < count) throw unexpected(what, end_of(clause));
    if (parts.size() > count)
        throw unexpected("the end of the line after " + std::string(what), parts[count].data());
    std::vector<Quantity> out;
    for (const std::string_view part : parts)
        out.push_back(reading.quantity(parse_expression(part, reading.source)));
    return out;
}

Direction direction_of(const std::vector<std::string_view>& parts, const Clause& clause,
                       Reading& reading) {
    if (parts.size() < 2)
        throw unexpected("an azimuth and an elevation in degrees", end_of(clause));
    Direction out{reading.quantity(parse_expression(parts[0], reading.source)),
                  reading.quantity(parse_expression(parts[1], reading.source))};
    if (!(out.elevation.value >= -90 && out.elevation.value <= 90))
        throw SyntaxError{parts[1].data(), "expected an elevation from -90 to 90 degrees, found " +
                                               quoted(parts[1])};
    return out;
}

void read_camera(const Clause& clause, Reading& reading) {
    const auto parts = pieces(clause.value());
    CameraSetting camera;
    camera.from = direction_of(parts, clause, reading);
    if (parts.size() > 2) {
        if (parts[2] != "perspective") refuse(parts[2], {"perspective"});
        camera.perspective = true;
    }
    if (parts.size() > 3) {
        camera.opening = reading.quantity(parse_expression(parts[3], reading.source));
        if (!(camera.opening->value >= 1 && camera.opening->value <= 120))
            throw SyntaxError{parts[3].data(),
                              "expected degrees from 1 to 120, found " + quoted(parts[3])};
    }
    if (parts.size() > 4) throw unexpected("the end of the line", parts[4].data());
    reading.system.settings.camera = std::move(camera);
}

void read_light(const Clause& clause, Reading& reading) {
    const auto parts = pieces(clause.value());
    Direction light = direction_of(parts, clause, reading);
    if (parts.size() > 2) throw unexpected("the end of the line", parts[2].data());
    reading.system.settings.light = std::move(light);
}

/// The symbol that a solid or a surface is for, which has none yet.
Symbol symbol_of(std::string_view text, Reading& reading) {
    const Word symbols = parse_symbols(text, reading.lexicon);
    if (symbols.size() != 1)
        throw SyntaxError{text.data(), "expected one symbol, found " +
                                           std::to_string(symbols.size()) + " symbols"};
    check_unnamed(symbols.front(), text.data(), reading);
    return symbols.front();
}

void read_solid(const Clause& clause, Reading& reading) {
    std::vector<std::string> kinds, measures;
    for (const SolidKind& kind : solid_kinds()) kinds.push_back(kind.name.name);
    const auto parts = pieces(clause.value());
    if (parts.size() < 2) throw unexpected("a symbol and " + listed(kinds), end_of(clause));
    SolidSetting solid;
    solid.symbol = symbol_of(parts[0], reading);
    const SolidKind* const kind = solid_kind(parts[1]);
    if (!kind) refuse(parts[1], kinds);
    solid.kind = kind->name.name;
    for (const SolidKind::Name& measure : kind->measures) measures.push_back(measure.name);
    for (std::size_t i = 2; i < parts.size(); ++i) {
        const auto measure = std::find_if(
            kind->measures.begin(), kind->measures.end(), [&](const SolidKind::Name& name) {
                return name.name == parts[i] || name.reserved == parts[i];
            });
        if (measure == kind->measures.end()) refuse(parts[i], measures);
        if (std::count(solid.measures.begin(), solid.measures.end(), measure->name) > 0)
            throw SyntaxError{parts[i].data(),
                              "the measure " + quoted(parts[i]) + " is given twice"};
        solid.measures.push_back(measure->name);
    }
    reading.system.settings.solids.push_back(std::move(solid));
}

Triple point_at(const char*& here, const char* end, Reading& reading) {
    const char* const begin = here;
    const std::vector<Expression> parts = parse_arguments(here, end, reading.source);
    if (parts.size() != 3)
        throw SyntaxError{begin, "expected a point (x,y,z), found " + std::to_string(parts.size()) +
                                     (parts.size() == 1 ? " number" : " numbers")};
    return {reading.quantity(parts[0]), reading.quantity(parts[1]), reading.quantity(parts[2])};
}

void read_surface(const Clause& clause, Reading& reading) {
    const auto parts = pieces(clause.value());
    if (parts.size() < 2)
        throw unexpected("a symbol and " + listed(surface_kinds()), end_of(clause));
    SurfaceSetting surface;
    surface.symbol = symbol_of(parts[0], reading);
    surface.kind = parts[1];
    const auto& kinds = surface_kinds();
    if (std::find(kinds.begin(), kinds.end(), surface.kind) == kinds.end()) refuse(parts[1], kinds);
    const bool is_patch = surface.kind == "patch",
               has_points = is_patch || surface.kind == "polygon";
    if (!has_points && parts.size() > 2) throw unexpected("the end of the line", parts[2].data());
    for (std::size_t i = 2; i < parts.size(); ++i) {
        const char* here = parts[i].data();
        const char* const end = here + parts[i].size();
        while (here != end) {
            if (*here != '(') throw unexpected("a point (x,y,z)", here);
            surface.points.push_back(point_at(here, end, reading));
        }
    }
    const std::string found = ", found " + std::to_string(surface.points.size());
    if (is_patch && surface.points.size() != patch_points)
        throw SyntaxError{parts[1].data(), "expected 16 points for a patch, row by row" + found};
    if (has_points && surface.points.size() < least_corners)
        throw SyntaxError{parts[1].data(), "expected at least three points for a polygon" + found};
    reading.system.settings.surfaces.push_back(std::move(surface));
}

}  // namespace

bool is_space_setting(std::string_view name) {
    for (const char* known :
         {"solid", "surface", "tropism", "susceptibility", "camera", "light", "fog"})
        if (name == known) return true;
    return false;
}

void check_unnamed(Symbol symbol, const char* place, const Reading& reading) {
    const Settings& settings = reading.system.settings;
    const auto check = [&](const auto& all, const char* what) {
        for (const auto& one : all)
            if (one.symbol == symbol)
                throw SyntaxError{place, "the symbol " +
                                             quoted(reading.system.alphabet.name(symbol)) +
                                             " has a " + what + " already"};
    };
    check(settings.stamps, "stamp");
    check(settings.solids, "solid");
    check(settings.surfaces, "surface");
}

void read_space_setting(const Clause& clause, Reading& reading) {
    const std::string_view name = clause.keyword;
    Settings& settings = reading.system.settings;
    if (name == "solid") return read_solid(clause, reading);
    if (name == "surface") return read_surface(clause, reading);
    if (name == "camera") return read_camera(clause, reading);
    if (name == "light") return read_light(clause, reading);
    if (name == "tropism") {
        const auto to = numbers_of(clause, 3, "three coordinates", reading);
        if (to[0].value == 0 && to[1].value == 0 && to[2].value == 0)
            throw SyntaxError{clause.value().data(), "expected a direction, found the zero vector"};
        settings.tropism = Triple{to[0], to[1], to[2]};
    } else {
        Quantity number = numbers_of(clause, 1, "a number", reading)[0];
        if (name == "fog" && !(number.value >= 0 && number.value <= 1))
            throw SyntaxError{clause.value().data(),
                              "expected a share from 0 to 1, found " + quoted(clause.value())};
        (name == "fog" ? settings.fog : settings.susceptibility) = std::move(number);
    }
}

}  // namespace algae
