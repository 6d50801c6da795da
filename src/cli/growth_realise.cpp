#include "cli/growth_realise.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "growth/realise.hpp"
#include "notation/print.hpp"

namespace algae::cli {

namespace {

/// The system as a file says it.
std::string text_of(const D0L& rules, const std::string& title) {
    LSystem system;
    system.title = title;
    system.alphabet = *rules.alphabet;
    system.axiom.letters = rules.axiom;
    for (const Symbol a : rules.letters) {
        Production rule;
        rule.predecessor.symbol = a;
        rule.successor.letters = rules.successor(a);
        system.rules.push_back(std::move(rule));
    }
    return print_lsystem(system);
}

/// "lengths 1, 1, 2, 3, 5, 8, ..."
std::string title_of(const SequenceSpecification& sequence) {
    std::string title = "lengths ";
    for (const Rational& value : sequence.values(6)) title += to_string(value) + ", ";
    return title + "...";
}

/// Where the sequence was given by terms: on what the recurrence rests.
std::string rests_on(const SequenceSpecification& sequence) {
    const std::size_t needed = 2 * sequence.initial.size();
    if (sequence.terms == 0) return "";
    return fmt::format("the shortest recurrence of the {} terms, {}", sequence.terms,
                       sequence.terms < needed  ? fmt::format("of which {} would determine it", needed)
                       : sequence.terms > needed ? fmt::format("{} determine it, {} confirm it", needed, sequence.terms - needed)
                                                 : "which determine it and leave none to confirm it");
}

}  // namespace

int growth_realise(const std::string& specification, bool json, const Budget& budget) {
    const SequenceSpecification sequence = read_specification(specification);
    const Realisation result = realise(sequence, budget);
    const std::string rests = rests_on(sequence);
    const std::string shift = result.shift == 0 ? "" : "+" + std::to_string(result.shift);
    std::string system;
    if (result.system)
        system = text_of(*result.system, title_of(shifted(sequence, result.shift)));
    if (json) {
        static const char* const verdicts[] = {"found", "impossible", "unknown"};
        nlohmann::json all = {{"sequence", sequence.text()},
                              {"terms", sequence.terms},
                              {"verdict", verdicts[static_cast<std::size_t>(result.kind)]},
                              {"because", result.because}};
        if (result.system) {
            all["system"] = system;
            all["shift"] = result.shift;
            all["compared"] = result.compared;
        }
        print(all.dump(2) + "\n");
    } else {
        std::string text = "# " + sequence.text() + "\n";
        if (!rests.empty()) text += "# " + rests + "\n";
        if (result.kind == Realisation::Kind::impossible) text += "# there is no D0L system with these lengths: ";
        if (result.kind == Realisation::Kind::not_known) text += "# not known: ";
        text += (result.kind == Realisation::Kind::found ? "# " : "") + result.because + "\n";
        if (result.shift != 0)
            text += fmt::format("# the lengths of the following are a(n{}), equal on {} terms, which proves it\n", shift,
                                result.compared);
        print(text + system);
    }
    return result.kind == Realisation::Kind::found        ? success
           : result.kind == Realisation::Kind::impossible ? refuted
                                                          : undecided;
}

}  // namespace algae::cli
