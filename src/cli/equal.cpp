#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/equal_text.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "growth/equal_growth.hpp"
#include "language/sequence_certificate.hpp"

namespace algae::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string left, right, as = "language";
    bool json = false;
    Bounds bounds;
};

/// What is printed.
struct Answer {
    bool equal = false;
    Json witness;
    std::string text;
};

Answer growth_answer(const D0L& left, const D0L& right, const Budget& budget) {
    const GrowthComparison found = equal_growth(left, right, budget);
    Json witness{{"bound", found.bound}};
    if (found.difference)
        witness = {{"generation", found.difference->generation},
                   {"lengths",
                    {json_number(found.difference->left), json_number(found.difference->right)}}};
    return {found.equal, std::move(witness), equal_text(found)};
}

Answer sequence_answer(const D0L& left, const D0L& right, const Budget& budget) {
    const SequenceEquality found = equal_sequences(left, right, budget);
    const auto alphabet = over_common_alphabet(left, right).alphabet;
    Json witness = found.equal ? balance_certificate(*found.balance, *alphabet)
                               : difference_certificate(*found.difference);
    if (!found.equal) {
        witness["lengths"] = {json_number(found.difference->left_length),
                              json_number(found.difference->right_length)};
        witness["from"] = json_number(found.difference->from);
        witness["letters"] = {spell(*alphabet, found.difference->left),
                              spell(*alphabet, found.difference->right)};
    }
    return {found.equal, std::move(witness), equal_text(found, *alphabet)};
}

Answer language_answer(const D0L& left, const D0L& right, const Budget& budget) {
    const LanguageEquality found = equal_languages(left, right, budget);
    const auto alphabet = over_common_alphabet(left, right).alphabet;
    if (found.equal)
        return {true, language_certificate(found, *alphabet), equal_text(found, *alphabet)};
    const LanguageDifference& difference = *found.difference;
    Json witness{{"by", "word"},
                 {"of", difference.in_left ? "A" : "B"},
                 {"generation", difference.generation},
                 {"length", json_number(difference.length)}};
    witness["word"] = difference.word ? Json(spell(*alphabet, *difference.word)) : Json();
    return {false, std::move(witness), equal_text(found, *alphabet)};
}

int equal(const Options& options) {
    const Budget budget = options.bounds.budget();
    const View<D0L> left = as_d0l(open_system(options.left, budget));
    const View<D0L> right = as_d0l(open_system(options.right, budget));
    try {
        const auto answer_of = options.as == "growth"     ? growth_answer
                               : options.as == "sequence" ? sequence_answer
                                                          : language_answer;
        const Answer found = answer_of(*left, *right, budget);
        const Json out{{"verdict", found.equal ? "equal" : "different"},
                       {"witness", found.witness}};
        print(options.json ? out.dump(2) + "\n" : found.text);
        return found.equal ? success : refuted;
    } catch (const BoundReached& bound) {
        if (!options.json) throw;
        print(Json{{"verdict", "undecided"}, {"witness", {{"tried", bound.what()}}}}.dump(2) +
              "\n");
        return undecided;
    }
}

}  // namespace

void add_equal(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb =
        add_verb(verbs, "equal",
                 "Whether two D0L systems have the same language, sequence of words, or growth",
                 "  algae equal koch my.lsys\n  algae equal a.lsys b.lsys --as sequence --json",
                 options, equal);
    verb.add_option("A", options->left, file_help)->type_name(file_type)->required();
    verb.add_option("B", options->right, file_help)->type_name(file_type)->required();
    verb.add_option("--as", options->as,
                    "what is compared: language, the set of words; sequence, the word of every "
                    "generation; growth, its length")
        ->check(CLI::IsMember({"sequence", "language", "growth"}).description(""))
        ->type_name("language|sequence|growth");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
