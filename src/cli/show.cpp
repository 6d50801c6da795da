#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.hpp"
#include "cli/axes.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "notation/canonical.hpp"
#include "notation/print.hpp"
#include "notation/settings_grammar.hpp"
#include "system/classes.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file, generation;
    bool axes = false, json = false;
    Bounds bounds;
};

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

nlohmann::ordered_json as_json(const InnerSystem& inner, const Alphabet& alphabet) {
    const Printer printer(alphabet);
    nlohmann::ordered_json out;
    out["name"] = inner.name;
    out["axiom"] = printer.word(inner.system.axiom);
    out["rules"] = rules_text(inner.system, printer);
    out["ignore"] = names(alphabet, inner.system.ignored);
    return out;
}

nlohmann::ordered_json as_json(const Alphabet& alphabet, const EnvironmentSetting& environment) {
    nlohmann::ordered_json out;
    out["module"] = alphabet.name(environment.module);
    out["kind"] = environment.kind;
    out["numbers"] = nlohmann::json::array();
    for (const Quantity& number : environment.numbers) out["numbers"].push_back(number.value);
    return out;
}

nlohmann::ordered_json as_json(const LSystem& system, const Class& kind) {
    nlohmann::ordered_json out;
    out["class"] = kind.name();
    if (!system.title.empty()) out["title"] = system.title;
    if (!system.source.empty()) out["source"] = system.source;
    out["alphabet"] = all_names(system.alphabet);
    out["axiom"] = print_word(system.alphabet, system.axiom);
    const Printer printer(system.alphabet);
    out["rules"] = rules_text(system, printer);
    out["deterministic"] = kind.deterministic;
    out["propagating"] = kind.propagating;
    out["stochastic"] = kind.stochastic;
    out["parametric"] = kind.parametric;
    out["bracketed"] = kind.bracketed;
    out["context"] = {kind.context.first, kind.context.second};
    out["systems"] = nlohmann::json::array();
    for (const InnerSystem& inner : system.inner)
        out["systems"].push_back(as_json(inner, system.alphabet));
    out["tables"] = system.tables;
    out["schedule"] = schedule_names(system);
    out["terminals"] = names(system.alphabet, system.terminals);
    out["environments"] = nlohmann::json::array();
    for (const EnvironmentSetting& environment : system.environments)
        out["environments"].push_back(as_json(system.alphabet, environment));
    out["plot"] = names(system.alphabet, system.settings.plotters);
    out["stamps"] = nlohmann::json::array();
    for (const Settings::Stamp& stamp : system.settings.stamps)
        out["stamps"].push_back(nlohmann::ordered_json{
            {"symbol", system.alphabet.name(stamp.symbol)}, {"shape", shape_name(stamp.shape)}});
    out["solids"] = nlohmann::json::array();
    for (const SolidSetting& solid : system.settings.solids)
        out["solids"].push_back(nlohmann::ordered_json{{"symbol", system.alphabet.name(solid.symbol)},
                                                       {"kind", solid.kind},
                                                       {"measures", solid.measures}});
    out["surfaces"] = nlohmann::json::array();
    for (const SurfaceSetting& surface : system.settings.surfaces)
        out["surfaces"].push_back(nlohmann::ordered_json{
            {"symbol", system.alphabet.name(surface.symbol)}, {"kind", surface.kind}});
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

std::string as_text(const LSystem& system, const Class& kind) {
    std::string out;
    const auto line = [&](const char* label, const std::string& value) {
        if (!value.empty()) out += fmt::format("{:<15}{}\n", label, value);
    };
    const auto answer = [](bool yes) { return std::string(yes ? "yes" : "no"); };
    line("title", system.title);
    line("source", system.source);
    line("class", kind.name());
    line("alphabet", fmt::format("{}", fmt::join(all_names(system.alphabet), " ")));
    const Printer printer(system.alphabet);
    const auto list = [&](const char* label, const std::vector<std::string>& values) {
        for (const std::string& value : values) line(std::exchange(label, ""), value);
    };
    line("axiom", axiom_text(system, printer));
    list("rules", rules_text(system, printer));
    list("systems within", systems_text(system, printer));
    line("tables", fmt::format("{}", fmt::join(system.tables, " ")));
    if (!system.schedule.empty())
        line("schedule", fmt::format("{}, then again", fmt::join(schedule_names(system), " ")));
    line("terminals", fmt::format("{}", fmt::join(names(system.alphabet, system.terminals), " ")));
    std::vector<std::string> environments, stamps;
    for (const EnvironmentSetting& environment : system.environments)
        environments.push_back(print_environment(system.alphabet, environment));
    list("environments", environments);
    line("plot",
         fmt::format("{}", fmt::join(names(system.alphabet, system.settings.plotters), " ")));
    for (const Settings::Stamp& stamp : system.settings.stamps)
        stamps.push_back(system.alphabet.name(stamp.symbol) + ' ' + shape_name(stamp.shape));
    list("stamps", stamps);
    std::vector<std::string> solids, surfaces;
    for (const SolidSetting& solid : system.settings.solids)
        solids.push_back(system.alphabet.name(solid.symbol) + ' ' + print_solid(solid));
    list("solids", solids);
    for (const SurfaceSetting& surface : system.settings.surfaces)
        surfaces.push_back(system.alphabet.name(surface.symbol) + ' ' + print_surface(surface));
    list("surfaces", surfaces);
    line("deterministic", answer(kind.deterministic));
    line("propagating", answer(kind.propagating));
    line("bracketed", answer(kind.bracketed));
    const auto& settings = system.settings;
    line("angle",
         settings.angle ? to_text(settings.angle->expression) : "90 (the file does not say)");
    if (const auto& start = settings.start)
        line("start",
             fmt::format("{} {} {}", to_text(start->x.expression), to_text(start->y.expression),
                         to_text(start->heading.expression)));
    if (const auto& shown = settings.generations)
        line("generation", shown->first == shown->second
                               ? std::to_string(shown->first)
                               : fmt::format("{}..{}", shown->first, shown->second));
    if (kind.context != std::pair<std::size_t, std::size_t>{0, 0})
        line("context", fmt::format("({},{})", kind.context.first, kind.context.second));
    return out;
}

int show(const Options& options) {
    const Budget budget = options.bounds.budget();
    const LSystem system = open_system(options.file, budget);
    if (options.axes != !options.generation.empty()) throw Error("--axes and -n go together");
    if (options.axes) {
        print_axes(system, natural("-n", options.generation), options.json, budget);
        return success;
    }
    const Class kind = class_of(system);
    print(options.json ? as_json(system, kind).dump(2) + "\n" : as_text(system, kind));
    return success;
}

}  // namespace

void add_show(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb =
        add_verb(verbs, "show", "Class, alphabet, rules and properties of a system",
                 "  algae show koch\n  algae show my.lsys --json\n  algae show plant-a --axes -n 4",
                 options, show);
    verb.add_option("FILE", options->file, file_help)->type_name(file_type)->required();
    verb.add_flag("--axes", options->axes,
                  "the axes of the tree that the word of generation N describes, by order");
    verb.add_option("-n", options->generation, "with --axes: the generation")->type_name("N");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
