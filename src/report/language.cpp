// Answers about languages with their proofs: membership, finiteness, equality.
//
// A derivation shows that a word is a member, otherwise a reason is given. A language is infinite if a letter
// derives itself and another lasting letter besides. Equality of sequences rests on a bound on how far
// the image by one morphism is ahead of the other, and on the automaton of overflows.

#include "report/report.hpp"

#include <algorithm>

#include "language/language.hpp"

namespace algae {

namespace {

std::string generation(std::uint64_t n) { return "generation " + std::to_string(n); }

}  // namespace

std::string reason(const Membership& found, const Alphabet& alphabet, const Word& word) {
    using enum Membership::Reason;
    switch (found.reason) {
        case foreign:
            return "the letter " + alphabet.name(word[found.position]) + " at position " +
                   std::to_string(found.position) + " occurs in no word of the language";
        case outgrown:
            return "no generation before " + std::to_string(found.step) + " has it, and from " +
                   generation(found.step) + " on every word is longer";
        case periodic:
            return generation(found.step) + " is the same word as " + generation(found.earlier) +
                   ", so nothing new comes, and no generation before has it";
        case repeated:
            return "what the letters derive within it in " + std::to_string(found.step) +
                   " steps is what they derive in " + std::to_string(found.earlier) +
                   " steps, so nothing new comes, and no generation before has it";
        case nonterminal:
            return "the letter " + alphabet.name(word[found.position]) + " at position " +
                   std::to_string(found.position) + " is not a terminal";
        case exhausted:
            return "what the letters derive within it by " + std::to_string(found.step) +
                   " tables they derive by fewer too, so nothing new comes, and in none of the " +
                   std::to_string(found.states) + " cases before is it derived";
        case short_words:
            if (found.states == 0) return "no rule erases letters, and the axiom is longer";
            return "no rule erases letters, and of the " + std::to_string(found.states) +
                   " words with no more letters none is it";
        case all_words:
            return "of the " + std::to_string(found.states) + " words of the language none is it";
        default:
            return {};
    }
}

namespace {

/// The name of the table of a step; empty if there is only one table.
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
            text += (text.empty() ? "" : ", ") + system.alphabet->name(word[i]) + " -> " +
                    spell(*system.alphabet, successor);
            if (same - i > 1) text += " (" + std::to_string(same - i) + " times)";
        }
        i = same;
    }
    return text.empty() ? "every letter stays" : text;
}

}  // namespace

std::string to_text(const Derivation& found, const ET0L& system) {
    std::string text;
    for (std::size_t t = 0; t < found.words.size(); ++t) {
        if (t > 0) {
            const std::string table = table_name(system, found, t - 1);
            text += "        " + (table.empty() ? "" : "table " + table + ": ") +
                    rules_used(system, found, t - 1) + '\n';
        }
        const std::string number = std::to_string(t);
        text += std::string(number.size() < 6 ? 6 - number.size() : 0, ' ') + number + "  " +
                spell(*system.alphabet, found.words[t]) + '\n';
    }
    return text;
}

std::string to_text(const Derivation& found, const IL& system) {
    ContextStep step(system);
    std::string text;
    for (std::size_t t = 0; t < found.words.size(); ++t) {
        const std::string number = std::to_string(t);
        text += std::string(number.size() < 6 ? 6 - number.size() : 0, ' ') + number + "  " +
                spell(*system.alphabet, found.words[t]) + '\n';
        if (t == found.choices.size()) break;
        const Word& word = found.words[t];
        const auto successors = step.successors(word);
        std::string rules;
        for (std::size_t i = 0; i < word.size();) {
            const Word& successor = (*successors[i])[found.choices[t][i]];
            std::size_t same = i + 1;
            while (same < word.size() && word[same] == word[i] &&
                   (*successors[same])[found.choices[t][same]] == successor)
                ++same;
            if (successor != Word{word[i]} || successors[i]->size() > 1) {
                rules += (rules.empty() ? "" : ", ") + system.alphabet->name(word[i]) + " -> " +
                         spell(*system.alphabet, successor);
                if (same - i > 1) rules += " (" + std::to_string(same - i) + " times)";
            }
            i = same;
        }
        text += "        " + (rules.empty() ? "every letter stays" : rules) + '\n';
    }
    return text;
}

Json to_json(const Derivation& found, const IL& system) {
    ContextStep step(system);
    Json steps = Json::array();
    for (std::size_t t = 0; t < found.words.size(); ++t) {
        Json one{{"word", spell(*system.alphabet, found.words[t])}};
        if (t < found.choices.size()) {
            const auto successors = step.successors(found.words[t]);
            std::vector<std::string> chosen;
            for (std::size_t i = 0; i < found.words[t].size(); ++i)
                chosen.push_back(spell(*system.alphabet, (*successors[i])[found.choices[t][i]]));
            one.set("successors", chosen);
        }
        steps.add(std::move(one));
    }
    return steps;
}

Json to_json(const Derivation& found, const ET0L& system) {
    Json steps = Json::array();
    for (std::size_t t = 0; t < found.words.size(); ++t) {
        Json step{{"word", spell(*system.alphabet, found.words[t])}};
        if (t < found.choices.size()) {
            if (const std::string table = table_name(system, found, t); !table.empty())
                step.set("table", table);
            std::vector<std::string> successors;
            for (std::size_t i = 0; i < found.words[t].size(); ++i)
                successors.push_back(
                    spell(*system.alphabet,
                          table_of(system, found, t)[found.words[t][i]][found.choices[t][i]]));
            step.set("successors", successors);
        }
        steps.add(std::move(step));
    }
    return steps;
}

std::string to_text(const DerivationCounts& counts) {
    const auto derivations = [](const Integer& count) {
        return to_string(count) + (count == 1 ? " derivation" : " derivations");
    };
    constexpr std::size_t shown = 20;
    std::string text;
    for (std::size_t i = 0; i < std::min(shown, counts.by_steps.size()); ++i) {
        const auto& [steps, count] = counts.by_steps[i];
        text += "of " + std::to_string(steps) + (steps == 1 ? " step: " : " steps: ") +
                derivations(count) + '\n';
    }
    if (counts.by_steps.size() > shown)
        text += "... and of " + std::to_string(counts.by_steps.size() - shown) +
                " other numbers of steps, up to " + std::to_string(counts.by_steps.back().steps) +
                '\n';
    if (!counts.total)
        return text +
               "infinitely many derivations: there are some of infinitely many numbers of "
               "steps\n";
    return counts.by_steps.size() == 1 ? text : text + derivations(*counts.total) + " in all\n";
}

Json to_json(const DerivationCounts& counts) {
    Json list = Json::array();
    for (const auto& [steps, count] : counts.by_steps)
        list.add({{"steps", steps}, {"count", count}});
    return Json{{"counts", list}, {"total", counts.total}, {"infinite", !counts.total}};
}

namespace {

std::string rule_text(const OL& system, const RuleUse& rule) {
    return system.alphabet->name(rule.letter) + " -> " +
           spell(*system.alphabet, system.successors[rule.letter][rule.choice]);
}

std::string rule_text(const ET0L& system, const TableUse& use) {
    return system.alphabet->name(use.letter) + " -> " +
           spell(*system.alphabet, system.tables[use.table][use.letter][use.choice]);
}

std::string table_text(const ET0L& system, const TableUse& use) {
    const std::string& name = system.table_names[use.table];
    return name.empty() ? std::to_string(use.table + 1) : name;
}

/// The rules of a course, with their tables if `tables` is true.
std::string course_text(const ET0L& system, const Course& course, bool tables) {
    return joined(course, ", ", [&](const TableUse& use) {
        return (tables ? table_text(system, use) + ": " : "") + rule_text(system, use);
    });
}

Json course_json(const ET0L& system, const Course& course) {
    Json steps = Json::array();
    for (const TableUse& use : course) {
        Json step;
        if (system.tables.size() > 1) step.set("table", table_text(system, use));
        step.set("rule", rule_text(system, use));
        steps.add(std::move(step));
    }
    return steps;
}

}  // namespace

std::string to_text(const EndlessRound& round, const OL& system) {
    const std::string rules =
        joined(round.rules, ", ", [&](const auto& rule) { return rule_text(system, rule); });
    const std::string& name = system.alphabet->name(round.rules.front().letter);
    const std::string& other = system.alphabet->name(round.other);
    return "infinite: by " + rules + " the letter " + name + " has " + name +
           " in what it becomes, and beside it " + other + ", which can go on for ever\n";
}

Json to_json(const EndlessRound& round, const OL& system) {
    Json rules = Json::array();
    for (const RuleUse& rule : round.rules) rules.add(rule_text(system, rule));
    return {{"rules", rules}, {"other", system.alphabet->name(round.other)}};
}

std::string to_text(const EndlessTables& proof, const ET0L& system) {
    const std::string again = system.alphabet->name(proof.again),
                      other = system.alphabet->name(proof.other);
    const auto course = [&](const Course& steps) {
        return course_text(system, steps, system.tables.size() > 1);
    };
    const auto by = [&](const Course& steps) {  // where it is not what was said already
        const std::string text = course(steps);
        return text == course(proof.round) ? std::string() : " by " + text;
    };
    std::string text = "infinite: by " + course(proof.round) + " the letter " + again + " has " +
                       again + " in what it becomes, and beside it ";
    if (proof.again == proof.other)
        text += again + " once more" + by(proof.beside);
    else
        text += other + by(proof.beside) + ", which has " + other + " in what it becomes" +
                by(proof.kept);
    if (!proof.after.empty()) text += "; " + other + " can end by " + course(proof.after);
    return text + (has_only_terminals(system)
                       ? "\n"
                       : "; and all letters beside them can become terminals by the same tables\n");
}

Json to_json(const EndlessTables& proof, const ET0L& system) {
    return {{"again", system.alphabet->name(proof.again)},
            {"other", system.alphabet->name(proof.other)},
            {"before", course_json(system, proof.before)},
            {"round", course_json(system, proof.round)},
            {"beside", course_json(system, proof.beside)},
            {"kept", course_json(system, proof.kept)},
            {"after", course_json(system, proof.after)}};
}

namespace {

constexpr std::size_t most_states = 12, longest_word = 200;  // that are printed

std::string states_text(const Balance& balance, const Alphabet& alphabet) {
    std::string text;
    for (std::size_t i = 0; i < balance.states.size(); ++i) {
        if (i == most_states) return text + ", ...";
        const Overflow& overflow = balance.states[i];
        if (i > 0) text += ", ";
        if (!overflow.word.empty()) text += overflow.ahead == Overflow::Ahead::left ? "A " : "B ";
        text += spell(alphabet, overflow.word);
    }
    return text;
}

std::string balance_text(const Balance& balance, const Alphabet& alphabet) {
    return "  bound: read any of these words from the left; what it becomes by the rules of A is "
           "never more than " +
           counted(balance.bound, "letter") +
           "\n         ahead of or behind what it becomes by the rules of B\n  automaton: " +
           counted(balance.states.size(), "state") +
           ", what is ahead: " + states_text(balance, alphabet) +
           "\n  steps: each of the words of generations 0 to " + std::to_string(balance.steps - 1) +
           " leads from ε back to ε;\n         what the letters become in " +
           counted(balance.steps, "step") + " does the same to the states as in " +
           std::to_string(balance.earlier) + ", so all later words do too\n";
}

/// "generation 3", or "generations 3, 5, 7, ..."
std::string generations(std::uint64_t first, std::uint64_t step) {
    return "generations " + std::to_string(first) + ", " + std::to_string(first + step) + ", " +
           std::to_string(first + 2 * step) + ", ...";
}

/// The letters of a word from a position on; `length` is that of the whole word.
std::string shown(const Word& letters, const Integer& from, const Integer& length,
                  const Alphabet& alphabet) {
    const std::string text = letters.empty() ? "(ends)" : spell(alphabet, letters);
    return (from == 0 ? "" : "...") + text + (from + Integer(letters.size()) < length ? "..." : "");
}

}  // namespace

std::string to_text(const GrowthComparison& found) {
    if (!found.difference)
        return "equal: the lengths of generations 0 to " +
               std::to_string(found.bound == 0 ? 0 : found.bound - 1) +
               " are the same, and as many as both systems have letters together decide\n";
    return "different: in generation " + std::to_string(found.difference->generation) +
           " the lengths are " + to_string(found.difference->left) + " and " +
           to_string(found.difference->right) + '\n';
}

std::string to_text(const SequenceEquality& found, const Alphabet& alphabet) {
    if (found.equal)
        return "equal: A and B have the same word in every generation\n" +
               balance_text(*found.balance, alphabet);
    const SequenceDifference& difference = *found.difference;
    return "different: the words of generation " + std::to_string(difference.generation) +
           " differ at position " + readable(difference.position) +
           (difference.generation > 0 ? ", those before are the same\n" : "\n") +
           "  A, from position " + readable(difference.from) + " of " +
           readable(difference.left_length) + ": " +
           shown(difference.left, difference.from, difference.left_length, alphabet) +
           "\n  B, from position " + readable(difference.from) + " of " +
           readable(difference.right_length) + ": " +
           shown(difference.right, difference.from, difference.right_length, alphabet) + '\n';
}

std::string to_text(const LanguageEquality& found, const Alphabet& alphabet) {
    if (found.difference) {
        const LanguageDifference& difference = *found.difference;
        const std::string one = difference.in_left ? "A" : "B",
                          other = difference.in_left ? "B" : "A";
        std::string text = "different: generation " + std::to_string(difference.generation) +
                           " of " + one + " is not a word of " + other;
        if (difference.word && difference.word->size() <= longest_word)
            text += ": " + spell(alphabet, *difference.word);
        else
            text += "; it has " + readable(difference.length) + " letters";
        if (difference.alike)
            text += "\n  generation " + std::to_string(*difference.alike) + " of " + other +
                    " alone has as many of each letter, in another order";
        return text + '\n';
    }
    if (found.finite)
        return "equal: A and B have the same " + counted(found.words_in_all, "word") + '\n';
    std::string text = "equal: A and B have the same words, infinitely many\n";
    for (const auto& [left, right] : found.words)
        text += "generation " + std::to_string(left) + " of A is generation " +
                std::to_string(right) + " of B\n";
    for (const SectionMatch& match : found.sections) {
        const Section& section = match.section;
        text += generations(section.left, section.step) + " of A are " +
                generations(section.right, section.stride) + " of B\n";
        if (section.step > 1 || section.stride > 1)
            text += "  rules: here a step is " + counted(section.step, "step") + " of A and " +
                    std::to_string(section.stride) + " of B\n";
        text += balance_text(match.balance, alphabet);
    }
    return text;
}

}  // namespace algae
