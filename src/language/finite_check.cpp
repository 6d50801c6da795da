#include "language/finite_check.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace algae {

namespace {

struct Flaw {
    std::string text;
};

[[noreturn]] void fail(std::string text) { throw Flaw{std::move(text)}; }

using Possible = std::map<Symbol, std::set<Word>>;
using Rules = std::set<LetterRule>;
using End = ObstructionCase::End;

Word concatenated(const std::vector<Word>& words) {
    Word whole;
    for (const Word& word : words) whole.insert(whole.end(), word.begin(), word.end());
    return whole;
}

class Checker {
public:
    explicit Checker(const FamilyObstruction& proof)
        : proof_(proof), words_(proof.language.words.begin(), proof.language.words.end()) {
        for (const Word& word : words_)
            for (auto end = word.begin();; ++end) {
                beginnings_.emplace(word.begin(), end);
                if (end == word.end()) break;
            }
    }

    void check() {
        Possible possible = factors();
        if (!proof_.family.tables) {
            if (!proof_.impossible.empty()) fail("the family has no tables, but tables are ruled out");
            check_case(proof_.root, possible, {}, true);
            return;
        }
        check_exclusions(proof_.root, possible, {});
        for (const ImpossibleTable& table : proof_.impossible) check_table(table, possible);
        if (proof_.root.end != End::sources) fail("all tables at once can only be ruled out by words never reached");
        check_sources(proof_.root.sources, possible);
    }

private:
    std::string spelled(const Word& word) const {
        for (const Symbol a : word)
            if (a >= proof_.language.alphabet->size()) return "a word with an unknown symbol";
        return spell(*proof_.language.alphabet, word);
    }
    std::string spelled(const LetterRule& rule) const {
        return spelled(Word{rule.letter}) + " -> " + spelled(rule.image);
    }
    void must_be_word(const Word& word) const {
        if (!words_.contains(word)) fail(spelled(word) + " is not a word of the language");
    }

    Possible factors() const {
        std::set<Word> all;
        if (!proof_.family.propagating) all.insert(Word{});
        for (const Word& word : words_)
            for (auto from = word.begin(); from != word.end(); ++from)
                for (auto to = from + 1;; ++to) {
                    all.emplace(from, to);
                    if (to == word.end()) break;
                }
        Possible possible;
        for (const Word& word : words_)
            for (const Symbol a : word) possible.emplace(a, all);
        return possible;
    }

    void check_case(const ObstructionCase& part, Possible possible, Rules there, bool generating) const {
        check_exclusions(part, possible, there);
        switch (part.end) {
            case End::no_image:
                if (!possible.contains(part.letter) || !possible.at(part.letter).empty())
                    fail(spelled(Word{part.letter}) + " has an image left");
                return;
            case End::needed:
                if (part.excluded.empty() || !there.contains(part.excluded.back().rule))
                    fail("the rule excluded last need not be there");
                return;
            case End::sources:
                if (!generating) fail("a table alone need not reach all words");
                check_sources(part.sources, possible);
                return;
            case End::conflict: check_conflict(part, std::move(possible), std::move(there), generating); return;
            case End::choice: check_choice(part, possible, there, generating); return;
        }
        fail("a case without an end");
    }

    void check_exclusions(const ObstructionCase& part, Possible& possible, const Rules& there) const {
        for (const ExcludedRule& excluded : part.excluded) {
            const LetterRule& rule = excluded.rule;
            if (!possible.contains(rule.letter) || !possible.at(rule.letter).contains(rule.image))
                fail(spelled(rule) + " is excluded but was not possible");
            must_be_word(excluded.word);
            if (excluded.images.empty()) {
                if (std::find(excluded.word.begin(), excluded.word.end(), rule.letter) == excluded.word.end())
                    fail(spelled(excluded.word) + " does not show the rule " + spelled(rule));
                std::map<Symbol, Word> chosen{{rule.letter, rule.image}};
                if (lands(excluded.word, 0, {}, possible, chosen))
                    fail(spelled(excluded.word) + " can go to a word of the language with " + spelled(rule));
            } else {
                for (const LetterRule& used : rules_of(excluded.word, excluded.images))
                    if (used != rule && !there.contains(used)) fail(spelled(used) + " need not be there");
            }
            possible[rule.letter].erase(rule.image);
        }
    }

    /// The rules of a step that must leave the language. Only without determinism may every
    /// occurrence of a letter take any of its rules.
    Rules rules_of(const Word& word, const std::vector<Word>& images) const {
        if (proof_.family.deterministic) fail("a letter has one image in a deterministic table");
        must_be_word(word);
        if (word.size() != images.size()) fail("the step does not say what every letter of the word becomes");
        const Word result = concatenated(images);
        if (words_.contains(result)) fail(spelled(result) + " is a word of the language");
        Rules used;
        for (std::size_t i = 0; i < word.size(); ++i) used.insert({word[i], images[i]});
        return used;
    }

    void check_conflict(const ObstructionCase& part, Possible possible, Rules there, bool generating) const {
        for (const LetterRule& used : rules_of(part.word, part.images))
            if (!there.contains(used) && std::find(part.rules.begin(), part.rules.end(), used) == part.rules.end())
                fail("the case without " + spelled(used) + " is not looked at");
        if (part.cases.size() != part.rules.size()) fail("there is not one case for each rule");
        for (std::size_t i = 0; i < part.rules.size(); ++i) {
            const LetterRule& missing = part.rules[i];
            Possible rest = possible;
            rest[missing.letter].erase(missing.image);
            if (there.contains(missing)) fail(spelled(missing) + " is known to be there");
            check_case(part.cases[i], std::move(rest), there, generating);
            there.insert(missing);
        }
    }

    void check_choice(const ObstructionCase& part, const Possible& possible, const Rules& there, bool generating) const {
        if (!proof_.family.deterministic) fail("a letter may have more than one image");
        if (!possible.contains(part.letter)) fail("the letter chosen for does not occur");
        if (part.cases.size() != part.rules.size()) fail("there is not one case for each rule");
        std::set<Word> open = possible.at(part.letter);
        for (std::size_t i = 0; i < part.rules.size(); ++i) {
            if (part.rules[i].letter != part.letter) fail(spelled(part.rules[i]) + " is a rule of another letter");
            open.erase(part.rules[i].image);
            Possible only = possible;
            only[part.letter] = {part.rules[i].image};
            check_case(part.cases[i], std::move(only), there, generating);
        }
        if (!open.empty()) fail("the case " + spelled({part.letter, *open.begin()}) + " is not looked at");
    }

    void check_table(const ImpossibleTable& table, Possible possible) const {
        if (table.rules.empty()) fail("a table is ruled out without a rule");
        for (const LetterRule& rule : table.rules) {
            if (!possible.contains(rule.letter) || !possible.at(rule.letter).contains(rule.image))
                fail(spelled(rule) + " is not possible");
            if (proof_.family.deterministic) possible[rule.letter] = {rule.image};
        }
        check_case(table.why, std::move(possible), Rules(table.rules.begin(), table.rules.end()), false);
    }

    void check_sources(const std::vector<std::vector<Word>>& sets, const Possible& possible) const {
        std::set<Word> seen;
        for (const auto& set : sets) {
            if (set.empty()) fail("an empty set of words is not missed");
            for (const Word& word : set) {
                must_be_word(word);
                if (!seen.insert(word).second) fail(spelled(word) + " is listed twice");
            }
            const std::set<Word> inside(set.begin(), set.end());
            for (const Word& from : words_)
                for (const Word& to : inside)
                    if (!inside.contains(from)) {
                        Rules used;
                        check_no_step(from, 0, to, 0, possible, used);
                    }
        }
        const bool only_empty = sets.size() == 1 && sets[0] == std::vector<Word>{Word{}} && !proof_.empty_axiom;
        if (sets.size() < 2 && !only_empty && !words_.empty()) fail("an axiom may reach all words");
    }

    void check_no_step(const Word& from, std::size_t position, const Word& to, std::size_t done,
                       const Possible& possible, Rules& used) const {
        for (const ImpossibleTable& table : proof_.impossible)
            if (std::all_of(table.rules.begin(), table.rules.end(),
                            [&](const LetterRule& rule) { return used.contains(rule); }))
                return;
        if (position == from.size()) {
            if (done == to.size()) fail(spelled(from) + " may give " + spelled(to));
            return;
        }
        for (std::size_t end = done; end <= to.size(); ++end) {
            const LetterRule rule{from[position], Word(to.begin() + static_cast<std::ptrdiff_t>(done),
                                                       to.begin() + static_cast<std::ptrdiff_t>(end))};
            if (!possible.at(rule.letter).contains(rule.image)) continue;
            if (proof_.family.deterministic && std::any_of(used.begin(), used.end(), [&](const LetterRule& other) {
                    return other.letter == rule.letter && other.image != rule.image;
                }))
                continue;
            const bool is_new = used.insert(rule).second;
            check_no_step(from, position + 1, to, end, possible, used);
            if (is_new) used.erase(rule);
        }
    }

    /// Whether some choice of one possible image for each letter sends the word into the language.
    bool lands(const Word& word, std::size_t position, const Word& built, const Possible& possible,
               std::map<Symbol, Word>& chosen) const {
        if (!beginnings_.contains(built)) return false;
        if (position == word.size()) return words_.contains(built);
        const Symbol letter = word[position];
        const auto goes_on = [&](const Word& image) {
            return lands(word, position + 1, concatenated({built, image}), possible, chosen);
        };
        if (chosen.contains(letter)) return goes_on(chosen.at(letter));
        for (const Word& image : possible.at(letter)) {
            chosen[letter] = image;
            const bool found = goes_on(image);
            chosen.erase(letter);
            if (found) return true;
        }
        return false;
    }

    const FamilyObstruction& proof_;
    std::set<Word> words_;
    std::set<Word> beginnings_;
};

}  // namespace

std::optional<std::string> flaw_in(const FamilyObstruction& obstruction) {
    try {
        Checker(obstruction).check();
    } catch (const Flaw& flaw) {
        return flaw.text;
    }
    return std::nullopt;
}

}  // namespace algae
