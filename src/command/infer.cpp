// `algae infer`: the smallest system that has given words as its first generations, or in its language.
//
// The words are read over one alphabet, in which a letter is what it is in a word on the command line. What is printed is a file of
// the notation: it is read again and shown to be what was meant before it is printed, so that a letter which cannot open a rule is
// an error and not another system. The proof that nothing smaller does is the search itself, which leaves out only what is
// larger or contradicts a word; the number of cases is part of the answer.

#include <optional>

#include "command/detail/output.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "language/language.hpp"
#include "notation/notation.hpp"
#include "search/search.hpp"
#include "system/system.hpp"

namespace algae::command {

namespace {

struct Options {
    std::vector<std::string> words;
    std::string family = "D0L";
    std::optional<std::uint64_t> largest;
    bool sample = false, json = false;
    Bounds bounds;
};

/// A family by its name, with what it is in the answer.
struct Family {
    const char* name;
    InferenceWish wish;
    const char* note;  // why the answer is of another family; empty if it is not
};

const std::vector<Family>& families() {
    using enum InferenceWish::Family;
    constexpr const char* tables =
        "the rules of all tables in one table derive as much and are not larger";
    constexpr const char* contexts =
        "rules without their contexts derive as much and are not larger; DIL asks for a "
        "deterministic system";
    static const std::vector<Family> all{
        {"D0L", {d0l, false}, ""},     {"PD0L", {d0l, true}, ""},    {"0L", {ol, false}, ""},
        {"P0L", {ol, true}, ""},       {"T0L", {ol, false}, tables}, {"PT0L", {ol, true}, tables},
        {"DT0L", {dt0l, false}, ""},   {"PDT0L", {dt0l, true}, ""},  {"IL", {ol, false}, contexts},
        {"PIL", {ol, true}, contexts}, {"DIL", {dil, false}, ""},    {"PDIL", {dil, true}, ""}};
    return all;
}

/// A reader: the name of a family.
std::string family_name(const std::string& option, const std::string& text) {
    std::vector<std::string> names;
    for (const Family& family : families()) {
        if (family.name == text) return text;
        names.emplace_back(family.name);
    }
    refuse(option, listed(names, ", "), text);
}

/// A letter that the words do not have, and its name.
Alphabet with_letters(Alphabet alphabet, const InferredSystem& system) {
    Symbol most = 0;
    for (const InferredRule& rule : system.rules) most = std::max(most, rule.letter);
    for (char name = 'a'; alphabet.size() <= most && name <= 'z'; ++name)
        if (const std::string text(1, name); !alphabet.find(text)) alphabet.symbol(text);
    while (alphabet.size() <= most) alphabet.symbol("x_" + std::to_string(alphabet.size()));
    return alphabet;
}

std::string text_of(const InferredSystem& system, const Alphabet& alphabet) {
    std::string out = "axiom " + spell(alphabet, system.axiom) + '\n';
    for (std::size_t table = 0; table < system.tables; ++table) {
        if (system.tables > 1) out += "table t_" + std::to_string(table + 1) + '\n';
        for (const InferredRule& rule : system.rules) {
            if (rule.table != table) continue;
            if (!rule.left.empty()) out += spell(alphabet, rule.left) + " < ";
            out += alphabet.name(rule.letter);
            if (!rule.right.empty()) out += " > " + spell(alphabet, rule.right);
            out += " -> " + spell(alphabet, rule.successor) + '\n';
        }
    }
    if (system.tables > 1 && !system.schedule.empty()) {
        out += "schedule";
        for (const std::size_t table : system.schedule) out += " t_" + std::to_string(table + 1);
        out += '\n';
    }
    return out;
}

/// Throws Error unless the text is read as as many rules as there are.
void check_read(const std::string& text, const InferredSystem& system) {
    try {
        if (read_lsystem(text, "").rules.size() == system.rules.size()) return;
    } catch (const Diagnostics&) {
    }
    throw Error(
        "a letter of the words means something else in a file; expected letters such as a, "
        "b, F and +");
}

std::vector<std::string> spelled(const std::vector<Word>& words, const Alphabet& alphabet) {
    std::vector<std::string> out;
    for (const Word& word : words) out.push_back(spell(alphabet, word));
    return out;
}

/// What the words say that no system of the family can do.
std::string why_not(const std::vector<Word>& words, const Alphabet& alphabet, const Family& family,
                    std::uint64_t cases) {
    std::string steps;
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
        steps += (i == 0 ? "" : ", ") + spell(alphabet, words[i]) + " => " +
                 spell(alphabet, words[i + 1]);
    return std::string("no ") + family.name +
           " system has these words as its first generations.\n" + "It would have to derive " +
           steps + ". All " + std::to_string(cases) +
           " ways to cut these words into the successors of their letters, from left to right as "
           "far as "
           "they go, contradict one another.\n";
}

int infer(const Options& options) {
    const Family& family = *std::ranges::find_if(
        families(), [&](const Family& one) { return one.name == options.family; });
    if (options.largest && !options.sample)
        throw Error("--max-size is for --sample: of the first generations all sizes are tried");
    const Budget budget = options.bounds.budget();
    Alphabet alphabet;
    std::vector<Word> words;
    for (const std::string& text : options.words) {
        const ModuleWord read = read_word(text, alphabet);
        if (!read.arguments.empty())
            throw Error("WORD " + text +
                        " has parameters, and the words of an L-system that is inferred have none");
        words.push_back(read.letters);
    }
    const std::uint64_t largest = options.largest.value_or(9);
    const Inference found = options.sample ? infer_sample(
                                                 words, family.wish, largest,
                                                 [&](const ET0L& system, const Word& word) {
                                                     return membership(system, word, budget).member;
                                                 },
                                                 budget)
                                           : infer_generations(words, family.wish, budget);
    const bool is_open = options.sample && !found.system;  // larger ones may do
    std::string text;
    if (found.system) {
        text = text_of(*found.system, with_letters(alphabet, *found.system));
        check_read(text, *found.system);
    }
    if (options.json) {
        Json out{{"family", family.name}, {"words", spelled(words, alphabet)}};
        out.set("as", options.sample ? "sample" : "generations");
        out.set("system", found.system ? Json(text) : Json());
        out.set("size", found.system ? Json(found.system->size) : Json());
        out.set("smaller_refuted", true);
        if (is_open) out.set("refuted_up_to", largest);
        out.set("cases", found.cases);
        print(out.text());
    } else if (found.system) {
        const std::string cases = std::to_string(found.cases);
        std::string said = text + "# size " + std::to_string(found.system->size) +
                           (options.sample ? "; the " + cases +
                                                 " systems before it, in the order of their "
                                                 "sizes, do not have all words\n"
                                           : "; " + cases +
                                                 " partial systems were tried: every smaller one "
                                                 "contradicts a word\n");
        if (*family.note)
            said += std::string("# the smallest ") + family.name + " system: " + family.note + '\n';
        print(said);
    } else if (is_open) {
        print(std::string("no ") + family.name + " system of a size up to " +
              std::to_string(largest) + " has all these words in its language: " +
              std::to_string(found.cases) + " systems were tried; --max-size tries larger ones\n");
    } else {
        print(why_not(words, alphabet, family, found.cases));
    }
    return found.system ? success : is_open ? undecided : refuted;
}

}  // namespace

void add_infer(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "infer", "The smallest system that has words as its first generations, or in its language",
        {"algae infer a ab aba abaab", "algae infer F F+F F+F+F --family 0L",
         "algae infer ab ba ab bb --family DIL --json", "algae infer a aa aaaa --sample"},
        infer);
    verb.option("WORD", options.words, "WORD",
                "the words, in the order of the generations, ε for the empty one")
        .required = true;
    verb.option(
        "--family", options.family, family_name, "D0L|PD0L|0L|P0L|T0L|DT0L|IL|DIL",
        "what the system is (default D0L); D: one successor, P: none is empty, T: tables, I: "
        "contexts");
    verb.flag("--sample", options.sample, "the words are any words of the language, in no order");
    verb.option("--max-size", options.largest, natural, "N",
                "with --sample: the size of the largest systems that are tried (default 9)");
    verb.json_flag(
        options.json,
        "print system, size, smaller_refuted and the number of cases as one JSON object");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
