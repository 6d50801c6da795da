// Decisions about random small systems of every family against words that are written out: by letters of strings, with nothing
// of the library.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "language/language.hpp"
#include "notation/notation.hpp"
#include "oracle/written_out.hpp"

using namespace algae;

namespace {

constexpr std::size_t kept = 7;          // letters of words that are followed
constexpr std::size_t most_words = 400;  // that are followed

struct RandomSystem {
    std::string family, axiom;
    std::vector<std::map<char, std::vector<std::string>>> tables;
    std::string terminals;  // of an E0L or ET0L system
    /// Of a 1L system: the neighbour and the letter, and what the letter becomes beside it.
    std::map<std::pair<char, char>, std::vector<std::string>> beside;
    bool looks_right = false;

    const std::vector<std::string>& successors(std::size_t table, const std::string& word,
                                               std::size_t i) const {
        if (looks_right ? i + 1 < word.size() : i > 0) {
            const auto found = beside.find({word[looks_right ? i + 1 : i - 1], word[i]});
            if (found != beside.end()) return found->second;
        }
        return tables[table].at(word[i]);
    }

    std::string text() const {
        std::string made = family + " { axiom " + axiom;
        if (!terminals.empty()) made += "; terminals " + spaced(terminals);
        for (std::size_t t = 0; t < tables.size(); ++t) {
            if (family.find('T') != std::string::npos) made += "; table t" + std::to_string(t);
            for (const auto& [letter, words] : tables[t])
                made += rules(std::string(1, letter), words);
        }
        for (const auto& [place, words] : beside) {
            const std::string neighbour(1, place.first), letter(1, place.second);
            made +=
                rules(looks_right ? letter + " > " + neighbour : neighbour + " < " + letter, words);
        }
        return made + " }";
    }

private:
    static std::string rules(const std::string& left, const std::vector<std::string>& words) {
        std::string made;
        for (const std::string& word : words)
            made += "; " + left + " -> " + (word.empty() ? "ε" : word);
        return made;
    }
    static std::string spaced(const std::string& letters) {
        std::string made;
        for (const char letter : letters)
            made += (made.empty() ? "" : " ") + std::string(1, letter);
        return made;
    }
};

RandomSystem random_system() {
    static const std::array<std::string, 12> families{"0L",   "P0L",   "D0L", "PD0L", "T0L", "PT0L",
                                                      "DT0L", "PDT0L", "E0L", "ET0L", "1L",  "1L"};
    RandomSystem made;
    made.family = *rc::gen::elementOf(families);
    const auto is = [&](char letter) { return made.family.find(letter) != std::string::npos; };
    const std::string letters = is('E') ? "abS" : "ab";
    const auto word = [&](int least, int most) {
        std::string text;
        for (int left = *rc::gen::inRange(least, most + 1); left > 0; --left)
            text += *rc::gen::elementOf(letters);
        return text;
    };
    const bool propagating = is('P') || (is('1') && *rc::gen::arbitrary<bool>());
    const auto successors = [&] {
        std::set<std::string> words;
        for (int count = is('D') ? 1 : *rc::gen::inRange(1, 3); count > 0; --count)
            words.insert(word(propagating ? 1 : 0, 2));
        return std::vector<std::string>(words.begin(), words.end());
    };
    made.axiom = word(1, 3);
    for (int table = is('T') ? 2 : 1; table > 0; --table) {
        auto& rules = made.tables.emplace_back();
        for (const char letter : letters) rules[letter] = successors();
    }
    if (is('1')) {
        made.looks_right = *rc::gen::arbitrary<bool>();
        for (int left = *rc::gen::inRange(1, 4); left > 0; --left)
            made.beside[{*rc::gen::elementOf(letters), *rc::gen::elementOf(letters)}] =
                successors();
    }
    if (is('E')) made.terminals = "ab";
    return made;
}

/// The words of a system as far as they are written out.
struct Written {
    std::set<std::string> words;  // of terminals
    bool whole = true;            // no other word is derived
    bool short_words = true;      // no other word of at most `kept` letters is
};

Written written(const RandomSystem& system) {
    Written found;
    bool erases = false;
    const auto see = [&](const auto& rules) {
        for (const auto& [place, successors] : rules)
            for (const std::string& successor : successors) erases = erases || successor.empty();
    };
    for (const auto& table : system.tables) see(table);
    see(system.beside);
    std::set<std::string> all{system.axiom};
    std::vector<std::string> open{system.axiom};
    while (!open.empty()) {
        const std::string word = open.back();
        open.pop_back();
        for (std::size_t table = 0; table < system.tables.size(); ++table) {
            bool cut = false;
            const std::set<std::string> made = oracle::next_words(
                word, kept, [&](std::size_t i) { return system.successors(table, word, i); }, cut);
            if (cut) found.whole = false;
            for (const std::string& each : made) {
                if (all.contains(each)) continue;
                if (all.size() == most_words) {
                    found.whole = found.short_words = false;
                    continue;
                }
                all.insert(each);
                open.push_back(each);
            }
        }
    }
    if (erases && !found.whole) found.short_words = false;
    for (const std::string& word : all)
        if (system.terminals.empty() ||
            word.find_first_not_of(system.terminals) == std::string::npos)
            found.words.insert(word);
    return found;
}

std::string shown(const std::string& word) { return word.empty() ? "ε" : word; }

std::string shown(const std::set<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + shown(word);
    return "{" + text + "}";
}

Truth truth(const std::string& lets, const std::string& statement) {
    return check(read_claim("claim T\n" + lets + "show " + statement, "x", {}))
        .statements.at(0)
        .answer.truth;
}

}  // namespace

TEST_CASE("decisions about random systems agree with words that are written out") {
    std::size_t asked = 0, comparable = 0, decided = 0;
    std::map<std::string, std::size_t> systems;
    CHECK(rc::check([&] {
        const auto [one, other, word, kind] = *rc::gen::resize(
            100, rc::gen::exec([] {
                std::string text;
                for (int left = *rc::gen::inRange(0, 6); left > 0; --left)
                    text += *rc::gen::element('a', 'b');
                return std::tuple(random_system(), random_system(), text, *rc::gen::inRange(0, 4));
            }));
        const std::string lets = "let G = " + one.text() + "\nlet H = " + other.text() + "\n";
        RC_LOG() << lets << shown(word);
        const Written left = written(one), right = written(other);
        ++asked;
        ++systems[one.family];
        // What is true, where the words that are written out say so.
        std::string statement;
        std::optional<bool> expected;
        if (kind == 0) {
            statement = shown(word) + " in L(G)";
            if (left.words.contains(word))
                expected = true;
            else if (left.whole || left.short_words)
                expected = false;
        } else if (kind == 1) {
            statement = "L(G) is finite";
            if (left.whole) expected = true;
        } else if (kind == 2) {
            // The words that were found, all or all but one.
            std::set<std::string> some = left.words;
            if (!some.empty() && *rc::gen::arbitrary<bool>()) some.erase(some.begin());
            statement = "L(G) <= " + shown(some);
            if (some != left.words)
                expected = false;
            else if (left.whole)
                expected = true;
        } else {
            statement = "L(G) == L(H)";
            const auto differ = [](const Written& here, const Written& there) {
                for (const std::string& each : here.words)
                    if (!there.words.contains(each) && (there.whole || there.short_words))
                        return true;
                return false;
            };
            if (differ(left, right) || differ(right, left))
                expected = false;
            else if (left.whole && right.whole)
                expected = true;
        }
        if (!expected && !left.words.empty()) {
            const std::vector<std::string> some(left.words.begin(), left.words.end());
            statement = shown(*rc::gen::elementOf(some)) + " in L(G)";
            expected = true;
        }
        if (!expected) return;
        ++comparable;
        const Truth found = truth(lets, statement);
        RC_LOG() << statement;
        decided += found != Truth::undecided;
        RC_ASSERT(found != (*expected ? Truth::refuted : Truth::proved));
    }));
    std::string counts;
    for (const auto& [family, count] : systems)
        counts += " " + std::to_string(count) + " " + family;
    MESSAGE(comparable << " of " << asked << " comparable, " << decided << " decided:" << counts);
    CHECK(comparable * 10 >= asked * 9);
    CHECK(decided * 10 >= comparable * 9);
}

TEST_CASE("the words that are listed of random systems are those that are written out") {
    std::size_t asked = 0, comparable = 0, whole = 0, words = 0;
    CHECK(rc::check([&] {
        const RandomSystem system = *rc::gen::resize(100, rc::gen::exec(random_system));
        const Written expected = written(system);
        ++asked;
        const Claim claim =
            read_claim("claim T\nlet G = " + system.text() + "\nshow a in L(G)", "x", {});
        const Language language = std::get<HasWord>(claim.statements.at(0).statement.says).language;
        constexpr std::uint64_t longest = 4;
        const WordList found = list_words(language, *claim.alphabet, {longest, 1'000});
        std::set<std::string> listed;
        for (const Word& word : found.words) listed.insert(spell(*claim.alphabet, word));
        listed.erase("ε");
        RC_LOG() << system.text() << " " << shown(listed);
        const bool all_known = expected.whole || expected.short_words;
        const bool is_whole = found.decided == longest + 1 || found.whole;
        if (all_known)
            for (const std::string& word : listed) RC_ASSERT(expected.words.contains(word));
        if (is_whole)
            for (const std::string& word : expected.words)
                if (!word.empty() && word.size() <= longest) RC_ASSERT(listed.contains(word));
        comparable += all_known || is_whole;
        whole += is_whole;
        words += listed.size();
    }));
    MESSAGE(comparable << " of " << asked << " comparable, " << whole << " whole, " << words
                       << " words");
    CHECK(comparable * 10 >= asked * 9);
    CHECK(whole * 10 >= asked * 7);
}
