#include "cli/growth_words.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "growth/catenative.hpp"
#include "growth/factors.hpp"
#include "growth/pansiot.hpp"
#include "growth/pushy.hpp"
#include "growth/repetitions.hpp"
#include "system/d0l.hpp"

namespace algae::cli {

namespace {

constexpr std::size_t longest_factor = 24;   // letters of the factors that are counted
constexpr std::size_t deepest_formula = 8;
constexpr std::size_t longest_shown = 60;    // letters of a word on the page

struct Findings {
    std::vector<std::uint64_t> complexity;
    bool infinite_word;
    ComplexityOrder order;
    std::optional<Pusher> pusher;
    std::vector<InfiniteRepetition> repetitions;
    CatenativeAnswer formula;
};

std::string word(const D0L& system, const Word& letters) {
    if (letters.size() <= longest_shown) return spell(*system.alphabet, letters);
    return fmt::format("{}... ({} letters)", spell(*system.alphabet, Word(letters.begin(), letters.begin() + longest_shown)),
                       letters.size());
}

std::string page(const D0L& system, const Findings& found) {
    std::string text = fmt::format("factors            {}\n", fmt::join(found.complexity, " "));
    text += fmt::format("                   of 0 to {} letters, in all words{}\n", longest_factor,
                        found.infinite_word ? ", which are beginnings of one infinite word" : "");
    if (found.order.is_decided())
        text += fmt::format("class              {}\n", to_string(found.order.at_least));
    else
        text += fmt::format("class              not decided: at least {}, at most {}\n", to_string(found.order.at_least),
                            to_string(found.order.at_most));
    text += fmt::format("                   {}\n", found.order.because);
    if (found.pusher)
        text += fmt::format("pushy              yes: {0} leads to {1} in {2} step{3}, and {4} does not grow\n",
                            system.alphabet->name(found.pusher->letter),
                            found.pusher->left ? word(system, found.pusher->run) + " " + system.alphabet->name(found.pusher->letter) + "..."
                                               : "..." + system.alphabet->name(found.pusher->letter) + " " + word(system, found.pusher->run),
                            found.pusher->steps, found.pusher->steps == 1 ? "" : "s", word(system, found.pusher->run));
    else
        text += "pushy              no: factors of letters that do not grow are bounded\n";
    if (found.repetitions.empty()) {
        text += "repetitive         no: no word has all its powers among the factors\n";
    } else {
        text += "repetitive         yes: all powers of";
        for (std::size_t i = 0; i < found.repetitions.size(); ++i)
            text += (i == 0 ? " " : ", ") + word(system, found.repetitions[i].word);
        text += " are factors\n";
    }
    text += fmt::format("locally catenative {}\n",
                        found.formula.formula ? found.formula.formula->text() + ": " + found.formula.because
                        : found.formula.kind == CatenativeAnswer::Kind::none ? "no: " + found.formula.because
                                                                              : "not found: " + found.formula.because);
    return text;
}

nlohmann::json object(const D0L& system, const Findings& found) {
    nlohmann::json all;
    all["factor_complexity"] = found.complexity;
    all["infinite_word"] = found.infinite_word;
    all["complexity_class"] = {{"decided", found.order.is_decided()},
                               {"at_least", to_string(found.order.at_least)},
                               {"at_most", to_string(found.order.at_most)},
                               {"because", found.order.because}};
    all["pushy"] = {{"value", found.pusher.has_value()}};
    if (found.pusher) {
        all["pushy"]["letter"] = system.alphabet->name(found.pusher->letter);
        all["pushy"]["steps"] = found.pusher->steps;
        all["pushy"]["run"] = spell(*system.alphabet, found.pusher->run);
        all["pushy"]["side"] = found.pusher->left ? "left" : "right";
    }
    all["repetitive"] = !found.repetitions.empty();
    all["repetitions"] = nlohmann::json::array();
    for (const InfiniteRepetition& repetition : found.repetitions)
        all["repetitions"].push_back({{"word", spell(*system.alphabet, repetition.word)}, {"grows", repetition.grows}});
    static const char* const kinds[] = {"yes", "no", "unknown"};
    all["locally_catenative"] = {{"verdict", kinds[static_cast<std::size_t>(found.formula.kind)]},
                                 {"because", found.formula.because}};
    if (found.formula.formula) {
        all["locally_catenative"]["back"] = found.formula.formula->back;
        all["locally_catenative"]["from"] = found.formula.formula->from;
    }
    return all;
}

}  // namespace

int growth_words(const LSystem& system, bool json, const Budget& budget) {
    const View<D0L> view = as_d0l(system);
    const D0L& rules = *view;
    const Findings found{factor_complexity(rules, longest_factor, budget), generates_infinite_word(rules),
                         complexity_order(rules, budget), pusher_of(rules, budget), infinite_repetitions(rules, budget),
                         locally_catenative(rules, deepest_formula, 24, budget)};
    print(json ? object(rules, found).dump(2) + "\n" : page(rules, found));
    return found.order.is_decided() ? success : undecided;
}

}  // namespace algae::cli
