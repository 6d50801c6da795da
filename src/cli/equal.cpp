#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "growth/equal_growth.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string left, right, as = "growth";
    bool json = false;
    Bounds bounds;
};

std::string as_text(const GrowthComparison& found) {
    if (!found.difference)
        return "equal: the lengths of generations 0 to " + std::to_string(found.bound == 0 ? 0 : found.bound - 1) +
               " are the same, and as many as both systems have letters together decide\n";
    return "different: in generation " + std::to_string(found.difference->generation) + " the lengths are " +
           to_string(found.difference->left) + " and " + to_string(found.difference->right) + '\n';
}

nlohmann::ordered_json as_json(const GrowthComparison& found) {
    nlohmann::ordered_json witness{{"bound", found.bound}};
    if (found.difference)
        witness = {{"generation", found.difference->generation},
                   {"lengths", {json_number(found.difference->left), json_number(found.difference->right)}}};
    return {{"verdict", found.equal ? "equal" : "different"}, {"witness", witness}};
}

int equal(const Options& options) {
    const Budget budget = options.bounds.budget();
    const View<D0L> left = as_d0l(open_system(options.left, budget));
    const View<D0L> right = as_d0l(open_system(options.right, budget));
    const GrowthComparison found = equal_growth(*left, *right, budget);
    print(options.json ? as_json(found).dump(2) + "\n" : as_text(found));
    return found.equal ? success : refuted;
}

}  // namespace

void add_equal(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "equal", "Whether two D0L systems grow in the same way",
                              "  algae equal koch my.lsys --as growth\n  algae equal a.lsys b.lsys --as growth --json",
                              options, equal);
    verb.add_option("A", options->left, file_help)->required();
    verb.add_option("B", options->right, file_help)->required();
    verb.add_option("--as", options->as, "what is compared: growth, the lengths of the words")->check(CLI::IsMember({"growth"}))->type_name("WHAT");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
