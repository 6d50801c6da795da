#include "claim/judge_generated.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "claim/certificate.hpp"
#include "claim/sentences.hpp"
#include "fold/interaction.hpp"
#include "language/system_form.hpp"
#include "language/tables_membership.hpp"
#include "verify/obstruction_json.hpp"
#include "word/spelling.hpp"

namespace algae {

namespace {

constexpr std::size_t longest_shown = 240;          // characters of a derivation on one line
constexpr std::uint64_t most_generations = 10'000;  // that a system with context is followed

/// "generation 0 is", "generations 0 to 3 are": those before a number that is not 0.
std::string generations(std::uint64_t end) {
    return end == 1 ? "generation 0 is" : "generations 0 to " + std::to_string(end - 1) + " are";
}

/// Why no generation has the word, as a sentence without its full stop.
std::string reason(const Membership& found, const std::string& name, const Word& word,
                   const Alphabet& alphabet) {
    const std::string text = spell(alphabet, word);
    using enum Membership::Reason;
    switch (found.reason) {
        case foreign:
            return text + " is not in L(" + name + "): the letter " +
                   alphabet.name(word[found.position]) + " is in none of its words";
        case nonterminal:
            return text + " is not in L(" + name + "): " + alphabet.name(word[found.position]) +
                   " is no terminal";
        case outgrown:
            return text + " is not in L(" + name + "): " +
                   (found.step == 0 ? "all its words are longer"
                                    : generations(found.step) +
                                          " not this word, and from then on all words are longer");
        case periodic:
            return text + " is not in L(" + name + "): generation " + std::to_string(found.step) +
                   " is generation " + std::to_string(found.earlier) +
                   " again, and none before is this word";
        case exhausted:
            return text + " is not in L(" + name + "): what the letters derive within it by any " +
                   counted(found.step, "table") + " they derive by fewer, and none of the " +
                   std::to_string(found.states) + " families of factors has it";
        default:
            return text + " is not in L(" + name +
                   "): the factors of it that the letters derive in " +
                   counted(found.step, "step") + " are those that they derive in " +
                   std::to_string(found.earlier) + ", and no generation before has it";
    }
}

Judgement judge_tables(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                       const Budget& budget) {
    const Membership found = membership(*system.tables, word, budget);
    if (!found.member)
        return Judgement::refuted({reason(found, system.name, word, alphabet) + "."},
                                  {{"by", "membership"}});
    const Derivation witness = derivation(*system.tables, word, found, budget);
    const std::string steps =
        found.step == 0 ? ": it is the axiom." : ": " + arrows(witness, alphabet) + ".";
    return Judgement::proved(
        {spell(alphabet, word) + " is in L(" + system.name + ")" + steps},
        {{"by", "membership"}, {"derivation", derivation_json(witness, alphabet)}});
}

/// Follows the generations. Where no rule has the empty successor, no generation is shorter than the
/// one before, so the first that is longer than the word ends the search: without this the words of
/// a growing system are followed to the bound, for each of the hundreds of short words in which two
/// languages may differ.
Judgement judge_interactive(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                            const Budget& budget) {
    const std::string text = spell(alphabet, word), in = " L(" + system.name + ")";
    Derivation walk{{system.interactive->axiom}, {}};
    const bool propagating = has_form(system, *system_form("PIL"));
    std::map<Word, std::uint64_t> seen;
    for (std::uint64_t n = 0; n < most_generations; ++n) {
        budget.check();
        const Word& current = walk.words.back();
        if (current == word)
            return Judgement::proved(
                {text + " is in" + in +
                 (n == 0 ? ": it is the axiom." : ": " + arrows(walk, alphabet) + ".")},
                {{"by", "membership"}, {"derivation", derivation_json(walk, alphabet)}});
        if (propagating && current.size() > word.size())
            return Judgement::refuted(
                {reason({false, Membership::Reason::outgrown, n}, system.name, word, alphabet) +
                 "."},
                {{"by", "membership"}});
        if (const auto before = seen.find(current); before != seen.end())
            return Judgement::refuted(
                {text + " is not in" + in + ": generation " + std::to_string(n) +
                 " is generation " + std::to_string(before->second) +
                 " again, and none before is this word."},
                {{"by", "membership"}});
        seen.emplace(current, n);
        if (seen.size() * (current.size() + 1) > budget.letters / 100) break;
        walk.words.push_back(next_word(*system.interactive, current));
    }
    return Judgement::undecided({"the first " + std::to_string(walk.words.size()) + " words of" +
                                 in + " are not " + text + ", and they do not repeat"});
}

}  // namespace

std::string arrows(const Derivation& derivation, const Alphabet& alphabet) {
    std::string text;
    for (const Word& word : derivation.words) {
        if (text.size() > longest_shown)
            return counted(derivation.words.size() - 1, "step") + " of derivation, beginning " +
                   text + " => ...";
        text +=
            (text.empty() ? "" : " => ") +
            (word.size() > longest_shown ? counted(word.size(), "letter") : spell(alphabet, word));
    }
    return text;
}

nlohmann::ordered_json derivation_json(const Derivation& derivation, const Alphabet& alphabet) {
    nlohmann::ordered_json words = nlohmann::ordered_json::array();
    for (const Word& word : derivation.words) words.push_back(certificate_text(alphabet, word));
    nlohmann::ordered_json result{{"words", words}};
    if (!derivation.tables.empty()) result["tables"] = derivation.tables;
    return result;
}

Judgement judge_generated(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                          const Budget& budget) {
    return system.tables ? judge_tables(system, word, alphabet, budget)
                         : judge_interactive(system, word, alphabet, budget);
}

}  // namespace algae
