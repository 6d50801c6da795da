// The class of a system and the content of its file, as a page and as JSON.
//
// Whether a system is deterministic depends on whether conditions exclude each other, which is not always decided: then it
// is "possibly" deterministic, null in JSON. Rules that both match are named, with parameters for which they do.
//
// Only the page shortens a word that is too long for a screen. The page leaves out settings that the file
// does not have; in JSON they are empty.

#include "report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "model/model.hpp"
#include "notation/notation.hpp"

namespace algae {

namespace {

std::vector<std::string> names(const Alphabet& alphabet, const std::vector<Symbol>& symbols) {
    std::vector<std::string> found;
    for (const Symbol a : symbols) found.push_back(alphabet.name(a));
    return found;
}

std::vector<std::string> all_names(const Alphabet& alphabet) {
    std::vector<std::string> found;
    for (Symbol a = 0; a < alphabet.size(); ++a) found.push_back(alphabet.name(a));
    return found;
}

/// The rules, one a line.
std::vector<std::string> rules_text(const LSystem& system, const Printer& printer) {
    std::vector<std::string> rules;
    for (const Production& rule : system.rules) rules.push_back(printer.rule(rule));
    return rules;
}

Json as_json(const InnerSystem& inner, const Alphabet& alphabet) {
    const Printer printer(alphabet);
    Json out;
    out.set("name", inner.name);
    out.set("axiom", printer.word(inner.system.axiom));
    out.set("rules", rules_text(inner.system, printer));
    out.set("ignore", names(alphabet, inner.system.ignored));
    return out;
}

Json as_json(const Alphabet& alphabet, const EnvironmentSetting& environment) {
    Json out;
    out.set("module", alphabet.name(environment.module));
    out.set("kind", environment.kind);
    std::vector<double> numbers;
    for (const Quantity& number : environment.numbers) numbers.push_back(number.value);
    out.set("numbers", numbers);
    return out;
}

/// The word, or its beginning and its length if it would fill the screen.
std::string axiom_text(const LSystem& system, const Printer& printer) {
    constexpr std::size_t shown = 400, whole = 2000;  // letters
    if (system.axiom.letters.size() <= whole) return printer.word(system.axiom);
    ModuleWord beginning;
    beginning.letters.assign(system.axiom.letters.begin(), system.axiom.letters.begin() + shown);
    for (const auto& [position, arguments] : system.axiom.arguments)
        if (position < shown) beginning.arguments.emplace(position, arguments);
    for (const auto& [position, words] : system.axiom.splices)
        if (position < shown) beginning.splices.emplace(position, words);
    return fmt::format("{} ... ({} letters)", printer.word(beginning), system.axiom.letters.size());
}

/// A module with these values or names, `A(2,1)`.
std::string module_text(const std::string& name, const std::vector<std::string>& parameters) {
    return name + (parameters.empty() ? "" : "(" + joined(parameters, ",") + ")");
}

/// The left side of a rule with the values of an overlap: "B(1) < A(2)".
std::string matched_text(const LSystem& system, const Production& rule,
                         const std::vector<std::pair<std::string, Rational>>& values) {
    const auto pattern_text = [&](const Pattern& pattern) {
        return joined(pattern, "", [&](const ModulePattern& module) {
            std::vector<std::string> shown;
            for (const std::string& parameter : module.parameters)
                for (const auto& [name, value] : values)
                    if (name == parameter) shown.push_back(shortest_text(value));
            return module_text(system.alphabet.name(module.symbol), shown);
        });
    };
    std::string text = pattern_text({rule.predecessor});
    if (!rule.left.empty()) text = pattern_text(rule.left) + " < " + text;
    if (!rule.right.empty()) text += " > " + pattern_text(rule.right);
    if (!rule.elsewhere.empty()) text += " ? " + pattern_text(rule.elsewhere);
    return text;
}

/// What rules leave open in a system and those within it.
struct OpenRules {
    struct Overlap {
        std::string first, second;  // places of rules
        std::string matched;        // a module that both match; empty where that was not decided
    };
    struct Unmatched {
        std::string module;
        std::size_t parameters;
        std::vector<std::size_t> expected;
    };
    std::vector<Overlap> overlaps;
    std::vector<Unmatched> unmatched;
};

OpenRules open_rules(const LSystem& system) {
    OpenRules all;
    const auto add = [&](const LSystem& one) {
        for (const RuleOverlap& overlap : overlaps(one)) {
            const Production &first = one.rules[overlap.first], &second = one.rules[overlap.second];
            all.overlaps.push_back(
                {to_string(first.place), to_string(second.place),
                 overlap.both ? matched_text(one, first, *overlap.both) : std::string()});
        }
        for (const UnmatchedModule& module : unmatched_modules(one)) {
            std::vector<std::string> places(module.parameters, "_");
            all.unmatched.push_back({module_text(one.alphabet.name(module.letter), places),
                                     module.parameters, module.expected});
        }
    };
    add(system);
    for (const InnerSystem& inner : system.inner) {
        LSystem within = inner.system;
        within.alphabet = system.alphabet;
        within.constants = system.constants;
        add(within);
    }
    return all;
}

/// Nothing where it is not decided.
std::optional<bool> is_deterministic(const Class& kind, const OpenRules& found) {
    if (kind.deterministic || kind.stochastic) return kind.deterministic;
    const bool is_decided = std::ranges::any_of(
        found.overlaps, [](const auto& overlap) { return !overlap.matched.empty(); });
    return is_decided || found.overlaps.empty() ? std::optional(false) : std::nullopt;
}

std::string deterministic_text(const Class& kind, const OpenRules& found) {
    const std::optional<bool> is = is_deterministic(kind, found);
    if (is == true) return "yes";
    if (is == false && (kind.stochastic || !kind.parametric)) return "no";
    const auto named = std::ranges::find_if(found.overlaps, [&](const auto& overlap) {
        return is.has_value() == !overlap.matched.empty();
    });
    if (named == found.overlaps.end()) return "no";
    const std::string rules = "the rules at " + named->first + " and " + named->second;
    return is ? "no: " + rules + " both match " + named->matched
              : "possibly: whether " + rules + " can match the same module is not decided";
}

/// "no rule matches A(_,_): the rules for A take 1 parameter".
std::string unmatched_text(const OpenRules::Unmatched& module) {
    const std::string name = module.module.substr(0, module.module.find('('));
    std::string counts;
    for (std::size_t i = 0; i < module.expected.size(); ++i)
        counts += (i == 0                            ? ""
                   : i + 1 == module.expected.size() ? " or "
                                                     : ", ") +
                  std::to_string(module.expected[i]);
    return "no rule matches " + module.module + ": the rules for " + name + " take " + counts +
           (counts == "1" ? " parameter" : " parameters");
}

/// "h = sqrt(p*q), about 0.458": as written, then the value where that is not the same.
std::vector<std::string> constants_text(const LSystem& system) {
    std::vector<std::string> lines;
    for (const auto& [name, value] : system.constants) {
        const std::string written = to_text(value.expression);
        std::string line = name + " = " + written;
        if (!value.exact)
            line += fmt::format(", about {}", value.value);
        else if (const std::string exact = shortest_text(*value.exact); exact != written)
            line += " = " + exact;
        lines.push_back(std::move(line));
    }
    return lines;
}

/// The systems within, as they are written.
std::vector<std::string> systems_text(const LSystem& system, const Printer& printer) {
    std::vector<std::string> lines;
    for (const InnerSystem& inner : system.inner) {
        lines.push_back(inner.name + " {");
        lines.push_back("    axiom " + axiom_text(inner.system, printer));
        for (const std::string& rule : rules_text(inner.system, printer))
            lines.push_back("    " + rule);
        if (!inner.system.ignored.empty())
            lines.push_back("    ignore " + printer.apart(inner.system.ignored));
        lines.push_back("}");
    }
    return lines;
}

}  // namespace

Json to_json(const SystemReport& report) {
    const auto& [system, kind] = report;
    Json out;
    out.set("class", kind.name());
    if (!system.title.empty()) out.set("title", system.title);
    if (!system.source.empty()) out.set("source", system.source);
    out.set("alphabet", all_names(system.alphabet));
    out.set("axiom", print_word(system.alphabet, system.axiom));
    const Printer printer(system.alphabet);
    out.set("rules", rules_text(system, printer));
    Json constants = Json::array();
    for (const auto& [name, value] : system.constants) {
        Json one{{"name", name}, {"written", to_text(value.expression)}};
        one.set("exact", value.exact ? Json(shortest_text(*value.exact)) : Json());
        one.set("value", value.value);
        constants.add(std::move(one));
    }
    out.set("constants", std::move(constants));
    const OpenRules found = open_rules(system);
    out.set("deterministic", is_deterministic(kind, found));
    Json overlaps = Json::array();
    for (const auto& [first, second, matched] : found.overlaps) {
        Json one{{"rules", Json::array({first, second})}};
        one.set("match", matched.empty() ? Json() : Json(matched));
        overlaps.add(std::move(one));
    }
    out.set("overlaps", std::move(overlaps));
    Json unmatched = Json::array();
    for (const auto& [module, parameters, expected] : found.unmatched)
        unmatched.add({{"module", module}, {"parameters", parameters}, {"expected", expected}});
    out.set("unmatched", std::move(unmatched));
    out.set("propagating", kind.propagating);
    out.set("stochastic", kind.stochastic);
    out.set("parametric", kind.parametric);
    out.set("bracketed", kind.bracketed);
    out.set("context", Json::array({kind.context.first, kind.context.second}));
    Json systems = Json::array();
    for (const InnerSystem& inner : system.inner) systems.add(as_json(inner, system.alphabet));
    out.set("systems", std::move(systems));
    out.set("tables", system.tables);
    out.set("schedule", schedule_names(system));
    out.set("terminals", names(system.alphabet, system.terminals));
    Json coding = Json::array();
    for (const auto& [letter, image] : system.coding.images)
        coding.add({{"letter", system.alphabet.name(letter)}, {"image", image}});
    out.set("coding", std::move(coding));
    Json environments = Json::array();
    for (const EnvironmentSetting& environment : system.environments)
        environments.add(as_json(system.alphabet, environment));
    out.set("environments", std::move(environments));
    out.set("plot", names(system.alphabet, system.drawing.plotters));
    out.set("elasticity", names(system.alphabet, system.drawing.elastic));
    Json stamps = Json::array();
    for (const Drawing::Stamp& stamp : system.drawing.stamps)
        stamps.add(Json{{"symbol", system.alphabet.name(stamp.symbol)},
                        {"shape", shape_name(stamp.shape)}});
    out.set("stamps", std::move(stamps));
    Json solids = Json::array();
    for (const SolidSetting& solid : system.drawing.solids)
        solids.add({{"symbol", system.alphabet.name(solid.symbol)},
                    {"kind", solid.kind},
                    {"measures", solid.measures}});
    out.set("solids", std::move(solids));
    Json surfaces = Json::array();
    for (const SurfaceSetting& surface : system.drawing.surfaces)
        surfaces.add(
            Json{{"symbol", system.alphabet.name(surface.symbol)}, {"kind", surface.kind}});
    out.set("surfaces", std::move(surfaces));
    return out;
}

std::string to_text(const SystemReport& report) {
    const auto& [system, kind] = report;
    std::string out;
    const auto line = [&](const char* label, const std::string& value) {
        if (!value.empty()) out += fmt::format("{:<15}{}\n", label, value);
    };
    const auto answer = [](bool yes) { return std::string(yes ? "yes" : "no"); };
    line("title", system.title);
    line("source", system.source);
    line("class", kind.name());
    line("alphabet", joined(all_names(system.alphabet), " "));
    const Printer printer(system.alphabet);
    const auto list = [&](const char* label, const std::vector<std::string>& values) {
        for (const std::string& value : values) line(std::exchange(label, ""), value);
    };
    line("axiom", axiom_text(system, printer));
    list("constants", constants_text(system));
    list("rules", rules_text(system, printer));
    list("systems within", systems_text(system, printer));
    line("tables", joined(system.tables, " "));
    if (!system.schedule.empty())
        line("schedule", fmt::format("{}, then again", fmt::join(schedule_names(system), " ")));
    line("terminals", joined(names(system.alphabet, system.terminals), " "));
    std::vector<std::string> images;
    for (const auto& [letter, image] : system.coding.images)
        images.push_back(system.alphabet.name(letter) + " -> " + image);
    line("coding", joined(images, ", "));
    std::vector<std::string> environments, stamps;
    for (const EnvironmentSetting& environment : system.environments)
        environments.push_back(print_environment(system.alphabet, environment));
    list("environments", environments);
    line("plot", joined(names(system.alphabet, system.drawing.plotters), " "));
    line("elasticity", joined(names(system.alphabet, system.drawing.elastic), " "));
    for (const Drawing::Stamp& stamp : system.drawing.stamps)
        stamps.push_back(system.alphabet.name(stamp.symbol) + ' ' + shape_name(stamp.shape));
    list("stamps", stamps);
    std::vector<std::string> solids, surfaces;
    for (const SolidSetting& solid : system.drawing.solids)
        solids.push_back(system.alphabet.name(solid.symbol) + ' ' + print_solid(solid));
    list("solids", solids);
    for (const SurfaceSetting& surface : system.drawing.surfaces)
        surfaces.push_back(system.alphabet.name(surface.symbol) + ' ' + print_surface(surface));
    list("surfaces", surfaces);
    const OpenRules found = open_rules(system);
    std::vector<std::string> notes;
    for (const auto& module : found.unmatched) notes.push_back(unmatched_text(module));
    if (system.drawing.angle && lies_down(system))
        notes.emplace_back(
            "the turtle starts along +x, so that a plant lies: `start upward` lets it stand");
    list("notes", notes);
    line("deterministic", deterministic_text(kind, found));
    line("propagating", answer(kind.propagating));
    line("bracketed", answer(kind.bracketed));
    const auto& drawing = system.drawing;
    line("angle",
         drawing.angle ? to_text(drawing.angle->expression) : "90 (the file does not say)");
    if (const auto& start = drawing.start; start && start->upward)
        line("start", "upward");
    else if (start)
        line("start",
             fmt::format("{} {} {}", to_text(start->x.expression), to_text(start->y.expression),
                         to_text(start->heading.expression)));
    if (const auto& shown = drawing.generations)
        line("generation", shown->first == shown->second
                               ? std::to_string(shown->first)
                               : fmt::format("{}..{}", shown->first, shown->second));
    if (kind.context != std::pair<std::size_t, std::size_t>{0, 0})
        line("context", fmt::format("({},{})", kind.context.first, kind.context.second));
    return out;
}

}  // namespace algae
