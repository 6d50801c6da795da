#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "language/finiteness.hpp"
#include "language/finiteness_letters.hpp"

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

int finite(const Options& options) {
    const Budget budget = options.bounds.budget();
    const View<OL> system = as_ol(open_system(options.file, budget));
    const Finiteness found = finiteness(*system);
    if (!found.finite) {
        print(options.json ? nlohmann::ordered_json{{"finite", false}, {"count", nullptr}, {"round", round_json(*system, *found.round)}}.dump(2) + "\n"
                           : endless(*system, *found.round));
        return refuted;
    }
    nlohmann::ordered_json out{{"finite", true}};
    std::string text;
    if (is_deterministic(*system)) {
        const Repetition words = repetition(*system, budget);
        const Integer count = Integer(words.preperiod) + words.period;
        out["count"] = json_number(count);
        out["preperiod"] = words.preperiod;
        out["period"] = json_number(words.period);
        text = "finite: " + readable(count) + (count == 1 ? " word" : " words") + "; from generation " +
               std::to_string(words.preperiod) + " on they repeat with period " + readable(words.period) + '\n';
    } else {
        const Integer count = number_of_words(*system, budget);
        out["count"] = json_number(count);
        text = "finite: " + readable(count) + (count == 1 ? " word" : " words") + '\n';
    }
    print(options.json ? out.dump(2) + "\n" : text);
    return success;
}

}  // namespace

void add_finite(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "finite", "Whether the language is finite, and how many words it has",
                              "  algae finite koch\n  algae finite my.lsys --json", options, finite);
    verb.add_option("FILE", options->file, file_help)->required();
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
