#pragma once
// Random small ET0L systems with terminals a and b, and languages of short words by definition.

#include <rapidcheck.h>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "oracle/table_words.hpp"
#include "system/system.hpp"

namespace algae::construct_tests {

inline std::shared_ptr<const Alphabet> any_alphabet() {
    static const auto alphabet = [] {
        Alphabet letters;
        for (const char* name : {"a", "b", "A", "B", "c"}) letters.symbol(name);
        return std::make_shared<const Alphabet>(letters);
    }();
    return alphabet;
}

struct Kind {
    int most_tables = 1;
    bool erasing = true;
    bool deterministic = false;
    int longest = 2;  // of a successor
};

/// A number from `least` to `most`, all of them as likely in the first cases as in the last.
inline int any_number(int least, int most) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, most + 1));
}

inline Word any_word_over(std::size_t letters, int least, int most) {
    Word word;
    for (int size = any_number(least, most); size > 0; --size)
        word.push_back(static_cast<Symbol>(any_number(0, static_cast<int>(letters) - 1)));
    return word;
}

/// Over a, b, A, B; only a and b are terminals. The letter c does not occur.
inline ET0L any_system(const Kind& kind) {
    ET0L system;
    system.alphabet = any_alphabet();
    system.axiom = any_word_over(4, any_number(0, 9) > 0 || !kind.erasing ? 1 : 0, 2);
    system.name = "G";
    const int tables = any_number(1, kind.most_tables);
    for (int t = 0; t < tables; ++t) {
        Table table(system.alphabet->size());
        for (Symbol a = 0; a < 4; ++a)
            for (int count = kind.deterministic ? 1 : any_number(1, 2); count > 0; --count)
                table[a].push_back(
                    any_word_over(4, kind.erasing && any_number(0, 2) == 0 ? 0 : 1, kind.longest));
        table[4].push_back({4});
        system.tables.push_back(table);
        system.table_names.emplace_back();
    }
    system.terminal = {1, 1, 0, 0, 0};
    return system;
}

inline std::string text_of(const ET0L& system) {
    std::string text = spell(*system.alphabet, system.axiom);
    for (const Table& table : system.tables) {
        text += " |";
        for (Symbol a = 0; a < table.size(); ++a)
            for (const Word& word : table[a])
                text += " " + system.alphabet->name(a) + "->" + spell(*system.alphabet, word);
    }
    return text;
}

/// The words of at most `longest` letters; the case is given up if there is too much to look at.
inline std::set<Word> words_of(const ET0L& system, std::size_t longest) {
    auto found = oracle::short_words(system, longest, 600);
    if (!found) RC_DISCARD("too many families of sets");
    return std::move(*found);
}

inline std::set<Word> words_of(const ET0L& system, const oracle::Meaning& meaning,
                               std::size_t longest) {
    auto found = oracle::meant_words(system, meaning, longest, 600);
    if (!found) RC_DISCARD("too many families of sets");
    return std::move(*found);
}

inline std::set<Word> products(const std::set<Word>& left, const std::set<Word>& right,
                               std::size_t longest) {
    std::set<Word> found;
    for (const Word& u : left)
        for (const Word& v : right)
            if (u.size() + v.size() <= longest) {
                Word word = u;
                word.insert(word.end(), v.begin(), v.end());
                found.insert(word);
            }
    return found;
}

inline std::set<Word> united(std::set<Word> left, const std::set<Word>& right) {
    left.insert(right.begin(), right.end());
    return left;
}

/// One word of the set or several after each other.
inline std::set<Word> several(const std::set<Word>& words, std::size_t longest) {
    std::set<Word> found = words;
    for (std::size_t before = 0; before != found.size();) {
        before = found.size();
        found.merge(products(found, words, longest));
    }
    return found;
}

/// The result keeps the symbols of a, b, ... and has as many tables as expected.
inline void require_form(const ET0L& result, std::size_t tables) {
    RC_ASSERT(result.tables.size() == tables);
    RC_ASSERT(result.table_names.size() == tables);
    RC_ASSERT(result.terminal.size() == result.alphabet->size());
    for (Symbol a = 0; a < any_alphabet()->size(); ++a)
        RC_ASSERT(result.alphabet->name(a) == any_alphabet()->name(a));
    for (const Table& table : result.tables) {
        RC_ASSERT(table.size() == result.alphabet->size());
        for (const auto& successors : table) RC_ASSERT(!successors.empty());
    }
}

}  // namespace algae::construct_tests
