#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "language/finiteness.hpp"
#include "language/finiteness_letters.hpp"
#include "language/tables_finiteness.hpp"
#include "language/tables_membership.hpp"
#include "language/tables_words.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file;
    bool json = false;
    Bounds bounds;
};

std::string rule_text(const OL& system, const RuleUse& rule) {
    return system.alphabet->name(rule.letter) + " -> " + spell(*system.alphabet, system.successors[rule.letter][rule.choice]);
}

std::string endless(const OL& system, const EndlessRound& round) {
    std::string text = "infinite: by ";
    for (std::size_t i = 0; i < round.rules.size(); ++i) text += (i == 0 ? "" : ", ") + rule_text(system, round.rules[i]);
    const std::string& name = system.alphabet->name(round.rules.front().letter);
    const std::string& other = system.alphabet->name(round.other);
    return text + " the letter " + name + " has " + name + " in what it becomes, and beside it " + other +
           ", which can go on for ever\n";
}

nlohmann::ordered_json round_json(const OL& system, const EndlessRound& round) {
    nlohmann::ordered_json rules = nlohmann::ordered_json::array();
    for (const RuleUse& rule : round.rules) rules.push_back(rule_text(system, rule));
    return {{"rules", rules}, {"other", system.alphabet->name(round.other)}};
}

std::string words_text(const Integer& count) {
    return "finite: " + readable(count) + (count == 1 ? " word" : " words");
}

std::string rule_text(const ET0L& system, const TableUse& use) {
    return system.alphabet->name(use.letter) + " -> " + spell(*system.alphabet, system.tables[use.table][use.letter][use.choice]);
}

std::string table_text(const ET0L& system, const TableUse& use) {
    const std::string& name = system.table_names[use.table];
    return name.empty() ? std::to_string(use.table + 1) : name;
}

/// The rules of a course, with their tables where `tables` says so.
std::string course_text(const ET0L& system, const Course& course, bool tables) {
    std::string text;
    for (const TableUse& use : course)
        text += (text.empty() ? "" : ", ") + (tables ? table_text(system, use) + ": " : "") + rule_text(system, use);
    return text;
}

std::string endless(const ET0L& system, const EndlessTables& proof) {
    const std::string again = system.alphabet->name(proof.again), other = system.alphabet->name(proof.other);
    const auto course = [&](const Course& steps) { return course_text(system, steps, system.tables.size() > 1); };
    const auto by = [&](const Course& steps) {  // where it is not what was said already
        const std::string text = course(steps);
        return text == course(proof.round) ? std::string() : " by " + text;
    };
    std::string text = "infinite: by " + course(proof.round) + " the letter " + again + " has " + again +
                       " in what it becomes, and beside it ";
    if (proof.again == proof.other)
        text += again + " once more" + by(proof.beside);
    else
        text += other + by(proof.beside) + ", which has " + other + " in what it becomes" + by(proof.kept);
    if (!proof.after.empty()) text += "; " + other + " can end by " + course(proof.after);
    return text + (has_only_terminals(system) ? "\n" : "; and all letters beside them can become terminals by the same tables\n");
}

nlohmann::ordered_json course_json(const ET0L& system, const Course& course) {
    auto steps = nlohmann::ordered_json::array();
    for (const TableUse& use : course) {
        nlohmann::ordered_json step;
        if (system.tables.size() > 1) step["table"] = table_text(system, use);
        step["rule"] = rule_text(system, use);
        steps.push_back(std::move(step));
    }
    return steps;
}

nlohmann::ordered_json round_json(const ET0L& system, const EndlessTables& proof) {
    return {{"again", system.alphabet->name(proof.again)},   {"other", system.alphabet->name(proof.other)},
            {"before", course_json(system, proof.before)},   {"round", course_json(system, proof.round)},
            {"beside", course_json(system, proof.beside)},   {"kept", course_json(system, proof.kept)},
            {"after", course_json(system, proof.after)}};
}

/// Prints that the language is infinite and why.
int say_infinite(const Options& options, const std::string& text, const nlohmann::ordered_json& round) {
    print(options.json ? nlohmann::ordered_json{{"finite", false}, {"count", nullptr}, {"round", round}}.dump(2) + "\n" : text);
    return refuted;
}

int finite_of_0l(const Options& options, const OL& system, const Budget& budget) {
    const Finiteness found = finiteness(system);
    if (!found.finite) return say_infinite(options, endless(system, *found.round), round_json(system, *found.round));
    nlohmann::ordered_json out{{"finite", true}};
    std::string text;
    if (is_deterministic(system)) {
        const Repetition words = repetition(system, budget);
        const Integer count = Integer(words.preperiod) + words.period;
        out["count"] = json_number(count);
        out["preperiod"] = words.preperiod;
        out["period"] = json_number(words.period);
        text = words_text(count) + "; from generation " + std::to_string(words.preperiod) + " on they repeat with period " +
               readable(words.period) + '\n';
    } else {
        const Integer count = number_of_words(system, budget);
        out["count"] = json_number(count);
        text = words_text(count) + '\n';
    }
    print(options.json ? out.dump(2) + "\n" : text);
    return success;
}

int finite(const Options& options) {
    const Budget budget = options.bounds.budget();
    const View<ET0L> system = as_et0l(open_system(options.file, budget));
    if (system->tables.size() == 1 && has_only_terminals(*system))
        return finite_of_0l(options, without_terminals(*system), budget);
    const TablesFiniteness found = finiteness(*system, budget);
    if (!found.finite) return say_infinite(options, endless(*system, *found.endless), round_json(*system, *found.endless));
    const Integer count = number_of_words(*system, budget);
    print(options.json ? nlohmann::ordered_json{{"finite", true}, {"count", json_number(count)}}.dump(2) + "\n"
                       : words_text(count) + (count.is_zero() ? "; the language is empty\n" : "\n"));
    return success;
}

}  // namespace

void add_finite(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "finite", "Whether the language is finite, and how many words it has",
                              "  algae finite koch\n  algae finite my.lsys --json", options, finite);
    verb.add_option("FILE", options->file, file_help)->type_name(file_type)->required();
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
