#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "language/tables_membership.hpp"
#include "notation/read.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file, word;
    bool brief = false, json = false;
    Bounds bounds;
};

std::string generation(std::uint64_t n) { return "generation " + std::to_string(n); }

/// Why the word is not in the language, as a sentence without its capital and full stop.
std::string reason(const Membership& found, const Alphabet& alphabet, const Word& word) {
    using enum Membership::Reason;
    switch (found.reason) {
        case foreign:
            return "the letter " + alphabet.name(word[found.position]) + " at position " + std::to_string(found.position) +
                   " occurs in no word of the language";
        case outgrown:
            return "no generation before " + std::to_string(found.step) + " has it, and from " + generation(found.step) +
                   " on every word is longer";
        case periodic:
            return generation(found.step) + " is the same word as " + generation(found.earlier) +
                   ", so nothing new comes, and no generation before has it";
        case repeated:
            return "what the letters derive within it in " + std::to_string(found.step) + " steps is what they derive in " +
                   std::to_string(found.earlier) + " steps, so nothing new comes, and no generation before has it";
        case nonterminal:
            return "the letter " + alphabet.name(word[found.position]) + " at position " + std::to_string(found.position) +
                   " is no terminal";
        case exhausted:
            return "what the letters derive within it by " + std::to_string(found.step) +
                   " tables they derive by fewer too, so nothing new comes, and in none of the " + std::to_string(found.states) +
                   " cases before is it derived";
        default:
            return {};
    }
}

/// What the table of a step is called; empty where there is nothing to tell apart.
std::string table_name(const ET0L& system, const Derivation& found, std::size_t step) {
    const std::size_t table = found.tables.empty() ? 0 : found.tables[step];
    const std::string& name = system.table_names[table];
    return name.empty() && system.tables.size() > 1 ? std::to_string(table + 1) : name;
}

/// The successors of the letters in the table of a step.
const Table& table_of(const ET0L& system, const Derivation& found, std::size_t step) {
    return system.tables[found.tables.empty() ? 0 : found.tables[step]];
}

/// The rules of one step in the order of the letters, those that stay as they are left out.
std::string rules_used(const ET0L& system, const Derivation& found, std::size_t step) {
    const Word& word = found.words[step];
    const auto& choices = found.choices[step];
    const Table& table = table_of(system, found, step);
    std::string text;
    for (std::size_t i = 0; i < word.size();) {
        std::size_t same = i + 1;
        while (same < word.size() && word[same] == word[i] && choices[same] == choices[i]) ++same;
        const Word& successor = table[word[i]][choices[i]];
        if (!(successor.size() == 1 && successor[0] == word[i] && table[word[i]].size() == 1)) {
            text += (text.empty() ? "" : ", ") + system.alphabet->name(word[i]) + " -> " + spell(*system.alphabet, successor);
            if (same - i > 1) text += " (" + std::to_string(same - i) + " times)";
        }
        i = same;
    }
    return text.empty() ? "every letter stays" : text;
}

std::string as_text(const ET0L& system, const Derivation& found) {
    std::string text;
    for (std::size_t t = 0; t < found.words.size(); ++t) {
        if (t > 0) {
            const std::string table = table_name(system, found, t - 1);
            text += "        " + (table.empty() ? "" : "table " + table + ": ") + rules_used(system, found, t - 1) + '\n';
        }
        const std::string number = std::to_string(t);
        text += std::string(number.size() < 6 ? 6 - number.size() : 0, ' ') + number + "  " +
                spell(*system.alphabet, found.words[t]) + '\n';
    }
    return text;
}

nlohmann::ordered_json as_json(const ET0L& system, const Derivation& found) {
    auto steps = nlohmann::ordered_json::array();
    for (std::size_t t = 0; t < found.words.size(); ++t) {
        nlohmann::ordered_json step{{"word", spell(*system.alphabet, found.words[t])}};
        if (t < found.choices.size()) {
            if (const std::string table = table_name(system, found, t); !table.empty()) step["table"] = table;
            step["successors"] = nlohmann::ordered_json::array();
            for (std::size_t i = 0; i < found.words[t].size(); ++i)
                step["successors"].push_back(
                    spell(*system.alphabet, table_of(system, found, t)[found.words[t][i]][found.choices[t][i]]));
        }
        steps.push_back(std::move(step));
    }
    return steps;
}

int member(const Options& options) {
    const Budget budget = options.bounds.budget();
    const LSystem written = open_system(options.file, budget);
    const View<ET0L> system = as_et0l(written);
    Alphabet alphabet = *system->alphabet;
    const ModuleWord read = read_word(options.word, alphabet);
    if (!read.arguments.empty()) throw Error("WORD has parameters, and the words of a system without parameters have none");
    const Word& word = read.letters;
    const Membership found = membership(*system, word, budget);
    std::optional<Derivation> witness;
    if (found.member && !options.brief) witness = derivation(*system, word, found, budget);
    const std::string text = spell(alphabet, word);
    if (options.json) {
        nlohmann::ordered_json out{{"member", found.member}};
        out["step"] = found.member ? nlohmann::ordered_json(found.step) : nlohmann::ordered_json();
        if (witness) out["derivation"] = as_json(*system, *witness);
        if (!found.member) out["reason"] = reason(found, alphabet, word);
        print(out.dump(2) + "\n");
    } else if (found.member) {
        print("yes: " + text + " is in the language, first in " + generation(found.step) + '\n' +
              (witness ? as_text(*system, *witness) : ""));
    } else {
        print("no: " + text + " is not in the language: " + reason(found, alphabet, word) + '\n');
    }
    return found.member ? success : refuted;
}

}  // namespace

void add_member(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "member", "Whether a word is in the language, with its derivation",
                              "  algae member fibonacci abaab\n  algae member my.lsys ε --json", options, member);
    verb.add_option("FILE", options->file, file_help)->type_name(file_type)->required();
    verb.add_option("WORD", options->word, "the word; ε is the empty word")->required();
    verb.add_flag("--brief", options->brief, "leave the derivation out");
    verb.add_flag("--json", options->json, "print one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
