#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "verify/verify.hpp"
#include "word/word.hpp"

// That a finite language is not of a family, step by step.
//
// The proof is a tree of cases (FamilyObstruction): which images letters may still have, and why each choice leads out of
// the language. The checker follows single steps on words, letter by letter, and knows nothing of the search.

namespace algae {

/// What is wrong with a proof.
struct ProofFlaw {
    std::string text;
};

namespace {

[[noreturn]] void fail(std::string text) { throw ProofFlaw{std::move(text)}; }

constexpr std::size_t longest = 2000;  // letters of a word that steps are followed through

Word concatenated(const std::vector<Word>& words) {
    Word whole;
    for (const Word& word : words) whole.insert(whole.end(), word.begin(), word.end());
    return whole;
}

}  // namespace

/// What single derivation steps do to the words of a finite language, for the checking of a proof:
/// letter by letter on words, nothing shared with the search.
class StepCheck {
public:
    using Possible = std::map<Symbol, std::set<Word>>;
    using Rules = std::set<LetterRule>;

    /// Both must outlive this. Throws BoundReached if a word is too long.
    StepCheck(const FamilyObstruction& proof, const Budget& budget)
        : proof_(proof),
          budget_(budget),
          words_(proof.language.words.begin(), proof.language.words.end()) {
        for (const Word& word : words_)
            if (word.size() > longest)
                throw BoundReached(Bound::method, "a proof by cases with words of more than " +
                                                      std::to_string(longest) +
                                                      " letters is not checked");
        for (const Word& word : words_)
            for (auto end = word.begin();; ++end) {
                beginnings_.emplace(word.begin(), end);
                if (end == word.end()) break;
            }
    }

    const std::set<Word>& words() const { return words_; }
    std::string spelled(const Word& word) const {
        for (const Symbol a : word)
            if (a >= proof_.language.alphabet->size()) return "a word with an unknown symbol";
        return spell(*proof_.language.alphabet, word);
    }
    std::string spelled(const LetterRule& rule) const {
        return spelled(Word{rule.letter}) + " -> " + spelled(rule.image);
    }

    /// The factors of words, the first possible images of every letter: what beginnings of words, each taken once, end
    /// with. Throws BoundReached if they take too much.
    Possible factors() const {
        std::set<Word> all;
        if (!proof_.family.propagating) all.insert(Word{});
        const std::uint64_t copies = letters_of(proof_.language).size() + 1;
        std::uint64_t bytes = 0;
        for (const Word& beginning : beginnings_) {
            for (auto from = beginning.begin(); from != beginning.end(); ++from)
                if (all.emplace(from, beginning.end()).second)
                    bytes += copies * (100 + beginning.size() * sizeof(Symbol));
            budget_.check();
            budget_.check_memory(bytes, "the factors of the words");
        }
        Possible possible;
        for (const Word& word : words_)
            for (const Symbol a : word) possible.emplace(a, all);
        return possible;
    }
    /// Throws ProofFlaw if this is not a word of the language.
    void must_be_word(const Word& word) const {
        if (!words_.contains(word)) fail(spelled(word) + " is not a word of the language");
    }
    /// The rules of a step that must leave the language. Only without determinism may every
    /// occurrence of a letter take any of its rules. Throws ProofFlaw if the step does not leave it.
    Rules leaving(const Word& word, const std::vector<Word>& images) const {
        if (proof_.family.deterministic) fail("a letter has one image in a deterministic table");
        must_be_word(word);
        if (word.size() != images.size())
            fail("the step does not say what every letter of the word becomes");
        const Word result = concatenated(images);
        if (words_.contains(result)) fail(spelled(result) + " is a word of the language");
        Rules used;
        for (std::size_t i = 0; i < word.size(); ++i) used.insert({word[i], images[i]});
        return used;
    }
    /// Whether some choice of one possible image for each letter, this rule among them, sends the
    /// word into the language.
    bool lands(const Word& word, const LetterRule& rule, const Possible& possible) const {
        std::map<Symbol, Word> chosen{{rule.letter, rule.image}};
        return lands_after(word, 0, {}, possible, chosen);
    }
    /// Throws ProofFlaw if possible rules that no impossible table contains take one word to the other.
    void must_not_give(const Word& from, const Word& to, const Possible& possible) const {
        Rules used;
        Places seen;
        follow(from, 0, to, 0, possible, used, seen);
    }

private:
    using Places = std::set<std::pair<std::size_t, std::size_t>>;

    bool lands_after(const Word& word, std::size_t position, const Word& built,
                     const Possible& possible, std::map<Symbol, Word>& chosen) const {
        budget_.check();
        if (!beginnings_.contains(built)) return false;
        if (position == word.size()) return words_.contains(built);
        const Symbol letter = word[position];
        const auto goes_on = [&](const Word& image) {
            return lands_after(word, position + 1, concatenated({built, image}), possible, chosen);
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
    void follow(const Word& from, std::size_t position, const Word& to, std::size_t done,
                const Possible& possible, Rules& used, Places& seen) const {
        budget_.check();
        const bool rules_matter = proof_.family.deterministic || !proof_.impossible.empty();
        if (!rules_matter && !seen.emplace(position, done).second) return;
        for (const ImpossibleTable& table : proof_.impossible)
            if (std::all_of(table.rules.begin(), table.rules.end(),
                            [&](const LetterRule& rule) { return used.contains(rule); }))
                return;
        if (position == from.size()) {
            if (done == to.size()) fail(spelled(from) + " may give " + spelled(to));
            return;
        }
        for (std::size_t end = done; end <= to.size(); ++end) {
            const LetterRule rule{from[position],
                                  Word(to.begin() + static_cast<std::ptrdiff_t>(done),
                                       to.begin() + static_cast<std::ptrdiff_t>(end))};
            if (!possible.at(rule.letter).contains(rule.image)) continue;
            if (proof_.family.deterministic &&
                std::any_of(used.begin(), used.end(), [&](const LetterRule& other) {
                    return other.letter == rule.letter && other.image != rule.image;
                }))
                continue;
            const bool is_new = used.insert(rule).second;
            follow(from, position + 1, to, end, possible, used, seen);
            if (is_new) used.erase(rule);
        }
    }

    const FamilyObstruction& proof_;
    const Budget& budget_;
    std::set<Word> words_;
    std::set<Word> beginnings_;
};

std::string to_string(Family family) {
    return std::string(family.propagating ? "P" : "") + (family.deterministic ? "D" : "") +
           (family.tables ? "T" : "") + "0L";
}

Family family_named(std::string_view name) {
    for (const Family family : all_families())
        if (to_string(family) == name) return family;
    throw Error(
        "expected one of the families 0L, P0L, D0L, PD0L, T0L, PT0L, DT0L and PDT0L, found '" +
        std::string(name) + "'");
}

const std::array<Family, 8>& all_families() {
    static constexpr std::array<Family, 8> all = {{{false, false, false},
                                                   {true, false, false},
                                                   {false, true, false},
                                                   {true, true, false},
                                                   {false, false, true},
                                                   {true, false, true},
                                                   {false, true, true},
                                                   {true, true, true}}};
    return all;
}

bool FiniteLanguage::contains(const Word& word) const {
    return std::binary_search(words.begin(), words.end(), word, shortlex_less);
}

FiniteLanguage make_finite_language(std::shared_ptr<const Alphabet> alphabet,
                                    std::vector<Word> words) {
    std::sort(words.begin(), words.end(), shortlex_less);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return {std::move(alphabet), std::move(words)};
}

FiniteLanguage finite_language(const std::vector<std::string>& words) {
    std::set<char> characters;
    for (const std::string& word : words) characters.insert(word.begin(), word.end());
    auto alphabet = std::make_shared<Alphabet>();
    for (const char character : characters) alphabet->symbol(std::string(1, character));
    std::vector<Word> all;
    for (const std::string& word : words) {
        Word& symbols = all.emplace_back();
        for (const char character : word)
            symbols.push_back(alphabet->symbol(std::string(1, character)));
    }
    return make_finite_language(std::move(alphabet), std::move(all));
}

std::vector<Symbol> letters_of(const FiniteLanguage& language) {
    std::set<Symbol> letters;
    for (const Word& word : language.words) letters.insert(word.begin(), word.end());
    return {letters.begin(), letters.end()};
}

std::string to_string(const FiniteLanguage& language) {
    std::string text = "{";
    for (const Word& word : language.words)
        text += (text.size() > 1 ? ", " : "") + spell(*language.alphabet, word);
    return text + "}";
}

namespace {

using Possible = StepCheck::Possible;
using Rules = StepCheck::Rules;
using End = ObstructionCase::End;

class Checker {
public:
    Checker(const FamilyObstruction& proof, const Budget& budget)
        : proof_(proof), steps_(proof, budget) {}

    void check() {
        Possible possible = steps_.factors();
        if (!proof_.family.tables) {
            if (!proof_.impossible.empty())
                fail("the family has no tables, but tables are ruled out");
            check_case(proof_.root, possible, {}, true);
            return;
        }
        check_exclusions(proof_.root, possible, {});
        for (const ImpossibleTable& table : proof_.impossible) check_table(table, possible);
        if (proof_.root.end != End::sources)
            fail("all tables at once can only be ruled out by words never reached");
        check_sources(proof_.root.sources, possible);
    }

private:
    void check_case(const ObstructionCase& part, Possible possible, Rules there,
                    bool generating) const {
        check_exclusions(part, possible, there);
        switch (part.end) {
            case End::no_image:
                if (!possible.contains(part.letter) || !possible.at(part.letter).empty())
                    fail(steps_.spelled(Word{part.letter}) + " has an image left");
                return;
            case End::needed:
                if (part.excluded.empty() || !there.contains(part.excluded.back().rule))
                    fail("the rule excluded last need not be there");
                return;
            case End::sources:
                if (!generating) fail("a table alone need not reach all words");
                check_sources(part.sources, possible);
                return;
            case End::conflict:
                check_conflict(part, std::move(possible), std::move(there), generating);
                return;
            case End::choice:
                check_choice(part, possible, there, generating);
                return;
        }
        fail("a case without an end");
    }

    void check_exclusions(const ObstructionCase& part, Possible& possible,
                          const Rules& there) const {
        for (const ExcludedRule& excluded : part.excluded) {
            const LetterRule& rule = excluded.rule;
            if (!possible.contains(rule.letter) || !possible.at(rule.letter).contains(rule.image))
                fail(steps_.spelled(rule) + " is excluded but was not possible");
            steps_.must_be_word(excluded.word);
            if (excluded.images.empty()) {
                if (std::find(excluded.word.begin(), excluded.word.end(), rule.letter) ==
                    excluded.word.end())
                    fail(steps_.spelled(excluded.word) + " does not show the rule " +
                         steps_.spelled(rule));
                if (steps_.lands(excluded.word, rule, possible))
                    fail(steps_.spelled(excluded.word) + " can go to a word of the language with " +
                         steps_.spelled(rule));
            } else {
                for (const LetterRule& used : steps_.leaving(excluded.word, excluded.images))
                    if (used != rule && !there.contains(used))
                        fail(steps_.spelled(used) + " need not be there");
            }
            possible[rule.letter].erase(rule.image);
        }
    }

    void check_conflict(const ObstructionCase& part, Possible possible, Rules there,
                        bool generating) const {
        for (const LetterRule& used : steps_.leaving(part.word, part.images))
            if (!there.contains(used) && !std::count(part.rules.begin(), part.rules.end(), used))
                fail("the case without " + steps_.spelled(used) + " is not looked at");
        if (part.cases.size() != part.rules.size()) fail("there is not one case for each rule");
        for (std::size_t i = 0; i < part.rules.size(); ++i) {
            const LetterRule& missing = part.rules[i];
            Possible rest = possible;
            rest[missing.letter].erase(missing.image);
            if (there.contains(missing)) fail(steps_.spelled(missing) + " is known to be there");
            check_case(part.cases[i], std::move(rest), there, generating);
            there.insert(missing);
        }
    }

    void check_choice(const ObstructionCase& part, const Possible& possible, const Rules& there,
                      bool generating) const {
        if (!proof_.family.deterministic) fail("a letter may have more than one image");
        if (!possible.contains(part.letter)) fail("the letter chosen for does not occur");
        if (part.cases.size() != part.rules.size()) fail("there is not one case for each rule");
        std::set<Word> open = possible.at(part.letter);
        for (std::size_t i = 0; i < part.rules.size(); ++i) {
            if (part.rules[i].letter != part.letter)
                fail(steps_.spelled(part.rules[i]) + " is a rule of another letter");
            open.erase(part.rules[i].image);
            Possible only = possible;
            only[part.letter] = {part.rules[i].image};
            check_case(part.cases[i], std::move(only), there, generating);
        }
        if (!open.empty())
            fail("the case " + steps_.spelled({part.letter, *open.begin()}) + " is not looked at");
    }

    void check_table(const ImpossibleTable& table, Possible possible) const {
        if (table.rules.empty()) fail("a table is ruled out without a rule");
        for (const LetterRule& rule : table.rules) {
            if (!possible.contains(rule.letter) || !possible.at(rule.letter).contains(rule.image))
                fail(steps_.spelled(rule) + " is not possible");
            if (proof_.family.deterministic) possible[rule.letter] = {rule.image};
        }
        check_case(table.why, std::move(possible), Rules(table.rules.begin(), table.rules.end()),
                   false);
    }

    void check_sources(const std::vector<std::vector<Word>>& sets, const Possible& possible) const {
        std::set<Word> seen;
        for (const auto& set : sets) {
            if (set.empty()) fail("an empty set of words is not missed");
            for (const Word& word : set) {
                steps_.must_be_word(word);
                if (!seen.insert(word).second) fail(steps_.spelled(word) + " is listed twice");
            }
            const std::set<Word> inside(set.begin(), set.end());
            for (const Word& from : steps_.words())
                for (const Word& to : inside)
                    if (!inside.contains(from)) steps_.must_not_give(from, to, possible);
        }
        const bool only_empty =
            sets.size() == 1 && sets[0] == std::vector<Word>{Word{}} && !proof_.empty_axiom;
        if (sets.size() < 2 && !only_empty && !steps_.words().empty())
            fail("an axiom may reach all words");
    }

    const FamilyObstruction& proof_;
    StepCheck steps_;
};

}  // namespace

std::optional<std::string> flaw_in(const FamilyObstruction& obstruction, const Budget& budget) {
    try {
        Checker(obstruction, budget).check();
    } catch (const ProofFlaw& flaw) {
        return flaw.text;
    }
    return std::nullopt;
}

}  // namespace algae
