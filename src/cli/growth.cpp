#include "growth/incidence.hpp"

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file, generation;
    bool json = false;
    Bounds bounds;
};

int growth(const Options& options) {
    const Budget budget = options.bounds.budget();
    const LSystem system = open_system(options.file, budget);
    const View<D0L> rules = as_d0l(system);
    const auto [first, last] = range("-n", options.generation);
    std::string text;
    nlohmann::json lengths = nlohmann::json::array();
    for (std::uint64_t n = first; n <= last; ++n) {
        const Integer letters = length(*rules, n, budget);
        if (options.json)
            lengths.push_back(json_number(letters));
        else
            text += to_string(letters) + '\n';
    }
    print(options.json ? nlohmann::json{{"lengths", lengths}}.dump(2) + "\n" : text);
    return success;
}

}  // namespace

void add_growth(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "growth", "The exact length of the words of a D0L system",
                              "  algae growth koch -n 100\n  algae growth my.lsys -n 0..6 --json", options, growth);
    verb.add_option("FILE", options->file, file_help)->required();
    verb.add_option("-n", options->generation, "the generation, or a range such as 0..6")->type_name("N")->required();
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
