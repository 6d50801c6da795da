#include "cli/equal_text.hpp"

#include "cli/numbers.hpp"

namespace algae::cli {

namespace {

constexpr std::size_t most_states = 12, longest_word = 200;  // that are printed

std::string counted(std::uint64_t count, const std::string& noun) {
    return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

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

std::string equal_text(const GrowthComparison& found) {
    if (!found.difference)
        return "equal: the lengths of generations 0 to " +
               std::to_string(found.bound == 0 ? 0 : found.bound - 1) +
               " are the same, and as many as both systems have letters together decide\n";
    return "different: in generation " + std::to_string(found.difference->generation) +
           " the lengths are " + to_string(found.difference->left) + " and " +
           to_string(found.difference->right) + '\n';
}

std::string equal_text(const SequenceEquality& found, const Alphabet& alphabet) {
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

std::string equal_text(const LanguageEquality& found, const Alphabet& alphabet) {
    if (found.difference) {
        const LanguageDifference& difference = *found.difference;
        const std::string one = difference.in_left ? "A" : "B",
                          other = difference.in_left ? "B" : "A";
        std::string text = "different: generation " + std::to_string(difference.generation) +
                           " of " + one + " is no word of " + other;
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

}  // namespace algae::cli
