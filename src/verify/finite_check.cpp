#include "verify/finite_check.hpp"

#include <algorithm>
#include <set>

#include "verify/finite_step_check.hpp"

namespace algae {

namespace {

[[noreturn]] void fail(std::string text) { throw ProofFlaw{std::move(text)}; }

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
            if (!there.contains(used) &&
                std::find(part.rules.begin(), part.rules.end(), used) == part.rules.end())
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
