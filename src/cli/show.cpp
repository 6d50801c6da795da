#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/axes.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "notation/print.hpp"
#include "base/error.hpp"
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

nlohmann::ordered_json as_json(const LSystem& system, const Class& kind) {
    nlohmann::ordered_json out;
    out["class"] = kind.name();
    if (!system.title.empty()) out["title"] = system.title;
    if (!system.source.empty()) out["source"] = system.source;
    out["alphabet"] = all_names(system.alphabet);
    out["axiom"] = print_word(system.alphabet, system.axiom);
    out["rules"] = nlohmann::json::array();
    const Printer printer(system.alphabet);
    for (const Production& rule : system.rules) out["rules"].push_back(printer.rule(rule));
    out["deterministic"] = kind.deterministic;
    out["propagating"] = kind.propagating;
    out["stochastic"] = kind.stochastic;
    out["parametric"] = kind.parametric;
    out["bracketed"] = kind.bracketed;
    out["context"] = {kind.context.first, kind.context.second};
    std::vector<std::string> systems;
    for (const InnerSystem& inner : system.inner) systems.push_back(inner.name);
    if (!systems.empty()) out["systems"] = systems;
    out["tables"] = system.tables;
    out["terminals"] = names(system.alphabet, system.terminals);
    return out;
}

/// The word, or its beginning and its length if it would fill the screen.
std::string axiom_text(const LSystem& system) {
    constexpr std::size_t shown = 400, whole = 2000;  // letters
    if (system.axiom.letters.size() <= whole) return print_word(system.alphabet, system.axiom);
    ModuleWord beginning;
    beginning.letters.assign(system.axiom.letters.begin(), system.axiom.letters.begin() + shown);
    for (const auto& [position, arguments] : system.axiom.arguments)
        if (position < shown) beginning.arguments.emplace(position, arguments);
    return fmt::format("{} ... ({} letters)", print_word(system.alphabet, beginning), system.axiom.letters.size());
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
    line("axiom", axiom_text(system));
    const char* label = "rules";
    const Printer printer(system.alphabet);
    for (const Production& rule : system.rules) {
        line(label, printer.rule(rule));
        label = "";
    }
    std::string systems;
    for (const InnerSystem& inner : system.inner)
        systems += (systems.empty() ? "" : " ") + inner.name;
    line("systems within", systems);
    line("tables", fmt::format("{}", fmt::join(system.tables, " ")));
    line("terminals", fmt::format("{}", fmt::join(names(system.alphabet, system.terminals), " ")));
    line("deterministic", answer(kind.deterministic));
    line("propagating", answer(kind.propagating));
    line("bracketed", answer(kind.bracketed));
    const auto& settings = system.settings;
    line("angle", settings.angle ? to_text(settings.angle->expression) : "90 (the file does not say)");
    if (const auto& start = settings.start)
        line("start", fmt::format("{} {} {}", to_text(start->x.expression), to_text(start->y.expression),
                                  to_text(start->heading.expression)));
    if (const auto& shown = settings.generations)
        line("generation", shown->first == shown->second ? std::to_string(shown->first)
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
    CLI::App& verb = add_verb(verbs, "show", "Class, alphabet, rules and properties of a system",
                              "  algae show koch\n  algae show my.lsys --json\n  algae show plant-a --axes -n 4", options, show);
    verb.add_option("FILE", options->file, file_help)->required();
    verb.add_flag("--axes", options->axes, "the axes of the tree that the word of generation N describes, by order");
    verb.add_option("-n", options->generation, "with --axes: the generation")->type_name("N");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
