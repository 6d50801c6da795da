#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "fold/letter.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file, generation, at = "0", count = "1";
    bool json = false;
    Bounds bounds;
};

int letter(const Options& options) {
    const Budget budget = options.bounds.budget();
    const LSystem system = open_system(options.file, budget);
    if (options.at.empty() || options.at.find_first_not_of("0123456789") != std::string::npos)
        throw Error("--at: expected a position, a whole number from 0 on, found \"" + options.at + '"');
    const Word letters = letters_at(*as_d0l(system), natural("-n", options.generation), Integer(options.at),
                                    natural("--count", options.count), budget);
    const std::string text = spell(system.alphabet, letters);
    if (options.json)
        print(nlohmann::json{{"letters", text}}.dump(2) + "\n");
    else
        print(text + "\n");
    return success;
}

}  // namespace

void add_letter(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "letter", "Letters of a generation from a position on, without the word",
                              "  algae letter dragon -n 300 --at 1000000000000000000000000000000\n"
                              "  algae letter koch -n 1000 --at 10 --count 60",
                              options, letter);
    verb.add_option("FILE", options->file, file_help)->type_name(file_type)->required();
    verb.add_option("-n", options->generation, "the generation")->type_name("N")->required();
    verb.add_option("--at", options->at, "the position, counted from 0, of any size")->type_name("P")->required();
    verb.add_option("--count", options->count, "how many letters (default 1)")->type_name("K");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
