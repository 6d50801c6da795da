#pragma once
// Random systems with tables and terminals, and what they derive by trying everything: strings,
// sets and sums; nothing of the library's but the types that the systems are handed over in.

#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "oracle/random_systems.hpp"
#include "system/system.hpp"

namespace algae::oracle {

/// A system as on paper: a table without successors of a letter leaves it; no terminals means all
/// letters.
struct WrittenTables {
    std::string axiom;
    std::vector<std::map<char, std::vector<std::string>>> tables;
    std::string terminals;

    std::vector<std::string> successors(std::size_t table, char letter) const {
        const auto found = tables[table].find(letter);
        return found == tables[table].end() || found->second.empty()
                   ? std::vector<std::string>{std::string(1, letter)}
                   : found->second;
    }
    bool is_terminal(char letter) const {
        return terminals.empty() || terminals.find(letter) != std::string::npos;
    }
    bool is_terminal_word(const std::string& word) const {
        return std::all_of(word.begin(), word.end(),
                           [&](char letter) { return is_terminal(letter); });
    }
};

inline std::ostream& operator<<(std::ostream& out, const WrittenTables& system) {
    out << "axiom " << system.axiom << "; terminals " << system.terminals;
    for (const auto& table : system.tables) {
        out << "; table";
        for (const auto& [letter, words] : table)
            for (const std::string& word : words) out << ' ' << letter << " -> " << word << ';';
    }
    return out;
}

/// The system in the types of the library; a, b, c are its letters 0, 1, 2.
inline ET0L et0l_of(const WrittenTables& written) {
    LSystem system;
    const auto word = [&](const std::string& text) {
        Word letters;
        for (const char letter : text)
            letters.push_back(system.alphabet.symbol(std::string(1, letter)));
        return letters;
    };
    word("abc");
    system.axiom.letters = word(written.axiom);
    for (std::size_t t = 0; t < written.tables.size(); ++t) {
        if (written.tables.size() > 1)
            system.tables.push_back(std::string(1, static_cast<char>('p' + t)));
        for (const auto& [letter, words] : written.tables[t])
            for (const std::string& successor : words) {
                Production rule;
                rule.predecessor.symbol = word(std::string(1, letter)).front();
                rule.successor.letters = word(successor);
                rule.table = t;
                system.rules.push_back(std::move(rule));
            }
    }
    system.terminals = word(written.terminals);
    return *as_et0l(system);
}

/// Over a, b, c with up to `most` tables; with the letters of one string for terminals.
inline rc::Gen<WrittenTables> any_tables(int most, bool erasing,
                                         const std::vector<std::string>& terminals) {
    const auto word = erasing ? any_word("abc", 2) : any_nonempty_word("abc", 2);
    const auto words = rc::gen::mapcat(rc::gen::inRange(0, 3), [word](int count) {
        return rc::gen::container<std::vector<std::string>>(static_cast<std::size_t>(count), word);
    });
    const auto table = rc::gen::apply(
        [](std::vector<std::string> a, std::vector<std::string> b, std::vector<std::string> c) {
            return std::map<char, std::vector<std::string>>{
                {'a', std::move(a)}, {'b', std::move(b)}, {'c', std::move(c)}};
        },
        words, words, words);
    const auto tables = rc::gen::mapcat(rc::gen::inRange(1, most + 1), [table](int count) {
        return rc::gen::container<std::vector<std::map<char, std::vector<std::string>>>>(
            static_cast<std::size_t>(count), table);
    });
    return rc::gen::resize(
        100, rc::gen::apply(
                 [](std::string axiom, std::vector<std::map<char, std::vector<std::string>>> all,
                    std::string last) {
                     return WrittenTables{std::move(axiom), std::move(all), std::move(last)};
                 },
                 any_nonempty_word("abc", 2), tables, rc::gen::elementOf(terminals)));
}

/// All words that the table makes of this one.
inline std::set<std::string> words_after(const WrittenTables& system, std::size_t table,
                                         const std::string& word) {
    std::set<std::string> found{""};
    for (const char letter : word) {
        std::set<std::string> longer;
        for (const std::string& begun : found)
            for (const std::string& successor : system.successors(table, letter))
                longer.insert(begun + successor);
        found = std::move(longer);
    }
    return found;
}

/// All words, terminal or not, of generation n: by all sequences of n tables.
inline std::set<std::string> words_of_generation(const WrittenTables& system, unsigned n) {
    std::set<std::string> words{system.axiom};
    while (n-- > 0) {
        std::set<std::string> next;
        for (const std::string& word : words)
            for (std::size_t t = 0; t < system.tables.size(); ++t)
                next.merge(words_after(system, t, word));
        words = std::move(next);
    }
    return words;
}

/// Of one sequence of tables: by letter the terminal words of at most so many letters that it
/// derives.
using ShortWords = std::map<char, std::set<std::string>>;

inline std::set<std::string> short_products(const ShortWords& words, const std::string& letters,
                                            std::size_t longest) {
    std::set<std::string> found{""};
    for (const char letter : letters) {
        std::set<std::string> longer;
        for (const std::string& begun : found)
            for (const std::string& word : words.at(letter))
                if (begun.size() + word.size() <= longest) longer.insert(begun + word);
        found = std::move(longer);
    }
    return found;
}

/// The words of L(G) of at most `longest` letters, erasing or not: by all sequences of tables until
/// none derives other short words from the letters than another; nothing if more than `most` of
/// them differ.
inline std::optional<std::set<std::string>> short_words(const WrittenTables& system,
                                                        std::size_t longest, std::size_t most) {
    ShortWords first;
    for (const char letter : std::string("abc"))
        first[letter] = system.is_terminal(letter) && longest > 0
                            ? std::set<std::string>{std::string(1, letter)}
                            : std::set<std::string>{};
    std::set<ShortWords> seen{first};
    std::vector<ShortWords> waiting{first};
    std::set<std::string> found;
    while (!waiting.empty()) {
        const ShortWords rest = waiting.back();
        waiting.pop_back();
        found.merge(short_products(rest, system.axiom, longest));
        for (std::size_t t = 0; t < system.tables.size(); ++t) {
            ShortWords words;
            for (const char letter : std::string("abc"))
                for (const std::string& successor : system.successors(t, letter))
                    words[letter].merge(short_products(rest, successor, longest));
            if (seen.insert(words).second) waiting.push_back(words);
        }
        if (seen.size() > most) return std::nullopt;
    }
    return found;
}

/// The length of a longest terminal word that these tables, one a step, derive; nothing if there is
/// none.
inline std::optional<std::uint64_t> longest_by(const WrittenTables& system,
                                               const std::vector<std::size_t>& tables) {
    using Length = std::optional<std::uint64_t>;
    std::map<char, Length> lengths;
    for (const char letter : std::string("abc"))
        lengths[letter] = system.is_terminal(letter) ? Length(1) : Length();
    const auto of_word = [&](const std::string& word) {
        Length sum = 0;
        for (const char letter : word)
            sum = sum && lengths[letter] ? Length(*sum + *lengths[letter]) : Length();
        return sum;
    };
    for (std::size_t i = tables.size(); i-- > 0;) {
        std::map<char, Length> longer;
        for (const char letter : std::string("abc"))
            for (const std::string& successor : system.successors(tables[i], letter))
                if (const Length length = of_word(successor);
                    length && (!longer[letter] || *length > *longer[letter]))
                    longer[letter] = length;
        lengths = std::move(longer);
    }
    return of_word(system.axiom);
}

}  // namespace algae::oracle
