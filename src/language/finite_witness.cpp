#include "language/finite_witness.hpp"

#include <algorithm>
#include <set>

namespace algae {

namespace {

bool is_of_family(const FiniteWitness& witness, const FiniteLanguage& language, Family family) {
    if (witness.tables.empty() || (!family.tables && witness.tables.size() != 1)) return false;
    for (const RuleTable& table : witness.tables)
        for (const Symbol a : letters_of(language)) {
            if (a >= table.size() || table[a].empty()) return false;
            if (family.deterministic && table[a].size() > 1) return false;
            if (family.propagating && std::any_of(table[a].begin(), table[a].end(),
                                                  [](const Word& image) { return image.empty(); }))
                return false;
        }
    return true;
}

/// The words that `word` gives by the table in one step; nothing if one lies outside the language.
/// Beginnings that no word of the language has are outside whatever follows.
bool step(const Word& word, const RuleTable& table, const FiniteLanguage& language,
          const std::set<Word>& beginnings, std::set<Word>& results) {
    std::set<Word> built{Word{}};
    for (const Symbol a : word) {
        std::set<Word> longer;
        for (const Word& start : built)
            for (const Word& image : table[a]) {
                Word next = start;
                next.insert(next.end(), image.begin(), image.end());
                if (!beginnings.contains(next)) return false;
                longer.insert(std::move(next));
            }
        built = std::move(longer);
    }
    for (const Word& result : built)
        if (!language.contains(result)) return false;
    results.merge(built);
    return true;
}

}  // namespace

bool generates(const FiniteWitness& witness, const FiniteLanguage& language, Family family,
               const Budget& budget) {
    if (!is_of_family(witness, language, family) || !language.contains(witness.axiom)) return false;
    std::set<Word> beginnings;
    for (const Word& word : language.words)
        for (std::size_t size = 0; size <= word.size(); ++size)
            beginnings.emplace(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(size));
    std::set<Word> reached{witness.axiom};
    std::vector<Word> open{witness.axiom};
    while (!open.empty()) {
        budget.check();
        const Word word = open.back();
        open.pop_back();
        std::set<Word> results;
        for (const RuleTable& table : witness.tables)
            if (!step(word, table, language, beginnings, results)) return false;
        for (const Word& result : results)
            if (reached.insert(result).second) open.push_back(result);
    }
    return reached.size() == language.words.size();
}

LSystem to_lsystem(const FiniteWitness& witness, const std::string& name) {
    LSystem system;
    system.name = name;
    system.alphabet = *witness.alphabet;
    system.axiom.letters = witness.axiom;
    if (witness.tables.size() > 1)
        for (std::size_t i = 1; i <= witness.tables.size(); ++i)
            system.tables.push_back(std::to_string(i));
    for (std::size_t i = 0; i < witness.tables.size(); ++i)
        for (Symbol a = 0; a < witness.tables[i].size(); ++a)
            for (const Word& image : witness.tables[i][a]) {
                Production rule;
                rule.predecessor.symbol = a;
                rule.successor.letters = image;
                rule.table = i;
                system.rules.push_back(std::move(rule));
            }
    return system;
}

std::string to_string(const FiniteWitness& witness) {
    const Alphabet& alphabet = *witness.alphabet;
    std::string text = "axiom " + spell(alphabet, witness.axiom);
    for (const RuleTable& table : witness.tables) {
        std::string rules;
        for (Symbol a = 0; a < table.size(); ++a) {
            if (table[a].empty()) continue;
            rules += (rules.empty() ? "" : "; ") + alphabet.name(a) + " -> ";
            for (std::size_t i = 0; i < table[a].size(); ++i)
                rules += (i > 0 ? " | " : "") + spell(alphabet, table[a][i]);
        }
        if (rules.empty()) continue;
        text += witness.tables.size() > 1 ? "; [" + rules + "]" : "; " + rules;
    }
    return text;
}

}  // namespace algae
