#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "claim/judge_family.hpp"
#include "claim/judge_values.hpp"
#include "cli/claims.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string family, expression;
    bool empty_axiom = false, json = false;
    Bounds bounds;
};

Judgement judge(const Options& options, const WrittenLanguage& written, const Budget& budget) {
    if (options.family == "finite")
        return judge_finite(written.language, *written.alphabet, budget);
    if (options.family == "infinite")
        return opposite(judge_finite(written.language, *written.alphabet, budget));
    if (options.family == "empty") return judge_empty(written.language, *written.alphabet, budget);
    const std::string family = options.family == "regular"        ? "REG"
                               : options.family == "context-free" ? "CF"
                                                                  : options.family;
    return judge_family(written.language, {family, options.empty_axiom, {}}, *written.alphabet,
                        budget);
}

int is(const Options& options) {
    const Budget budget = options.bounds.budget();
    const WrittenLanguage written = read_language(options.expression, systems_from({"."}, budget));
    const Judgement found = judge(options, written, budget);
    std::string text = found.truth == Truth::proved    ? "yes"
                       : found.truth == Truth::refuted ? "no"
                                                       : "undecided";
    text += '\n';
    for (const std::string& line : found.argument) text += line + '\n';
    if (options.json) {
        nlohmann::ordered_json out{{"verdict", to_string(found.truth)},
                                   {"argument", found.argument}};
        if (found.truth == Truth::proved) out["witness"] = *found.proof;
        if (found.truth == Truth::refuted) out["obstruction"] = *found.proof;
        text = out.dump(2) + "\n";
    }
    print(text);
    return found.truth == Truth::proved    ? success
           : found.truth == Truth::refuted ? refuted
                                           : undecided;
}

}  // namespace

void add_is(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb =
        add_verb(verbs, "is", "Whether a language is of a family, with the system or the proof",
                 "  algae is 0L '{a, aa}'\n  algae is PD0L 'L(fibonacci)' --json", options, is);
    verb.add_option("CLASS", options->family,
                    "a family of languages, or what else a language may be")
        ->type_name(
            "0L|P0L|D0L|PD0L|T0L|PT0L|DT0L|PDT0L|E0L|ET0L|EDT0L|IL|regular|context-free|finite|"
            "infinite|empty")
        ->required();
    verb.add_option("EXPR", options->expression,
                    "a language as in claims: {a, aa}, /a(ab)*/, L(NAME), | & \\ . * + ~")
        ->required();
    verb.add_flag("--allow-empty-axiom", options->empty_axiom,
                  "systems may have the empty word as axiom");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
