#include <algorithm>
#include <map>
#include <set>
#include <span>

#include "language/detail/finite_family.hpp"
#include "language/detail/proof.hpp"

// Systems that generate finite languages, checked and written out, and the proof in sentences that there is none.
//
// The sentences follow an obstruction case by case and say what `flaw_in` checks and nothing else. Rules of one
// letter that go by the same word share a sentence. A sentence says as little as it can: what a word would give
// where the other letters have one image left, otherwise the form that the result would have, whatever the
// other letters become.

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

namespace {

/// The rules still possible at some point of a proof, for its sentences.
using RulesLeft = std::map<Symbol, std::set<Word>>;

constexpr std::size_t shown = 4;  // how many words a sentence lists at most

/// What a word becomes where a letter becomes its image and the other letters what `other` says;
/// nothing where a letter may become several things.
std::optional<Word> only_result(const ExcludedRule& excluded, const RulesLeft& left) {
    Word result;
    for (const Symbol a : excluded.word) {
        const Word* image = &excluded.rule.image;
        if (a != excluded.rule.letter) {
            if (left.at(a).size() != 1) return std::nullopt;
            image = &*left.at(a).begin();
        }
        result.insert(result.end(), image->begin(), image->end());
    }
    return result;
}

/// Whether the word is of the form: the image at each place of the letter, anything elsewhere.
bool matches(const ExcludedRule& excluded, const Word& word) {
    std::vector<char> reached(word.size() + 1, 0);
    reached[0] = 1;
    const Word& image = excluded.rule.image;
    for (const Symbol a : excluded.word) {
        std::vector<char> next(word.size() + 1, 0);
        bool before = false;
        for (std::size_t i = 0; i <= word.size(); ++i) {
            before = before || reached[i];
            if (a != excluded.rule.letter) {
                next[i] = before;
            } else if (reached[i] && i + image.size() <= word.size() &&
                       std::equal(image.begin(), image.end(),
                                  word.begin() + static_cast<std::ptrdiff_t>(i))) {
                next[i + image.size()] = 1;
            }
        }
        reached = std::move(next);
    }
    return reached.back();
}

/// The single sentences of a proof that a finite language is not of a family.
class FiniteSentences {
public:
    explicit FiniteSentences(const FiniteLanguage& language) : language_(language) {}

    std::string word(const Word& word) const { return marked_word(*language_.alphabet, word); }

    std::string rule(const LetterRule& rule) const {
        return word({rule.letter}) + " -> " + word(rule.image);
    }

    /// "a -> a and b -> ε | b".
    std::string rules(const std::vector<LetterRule>& rules) const {
        std::vector<std::string> texts;
        const Symbol* letter = nullptr;
        for (const LetterRule& each : rules) {
            if (letter && *letter == each.letter)
                texts.back() += " | " + word(each.image);
            else
                texts.push_back(rule(each));
            letter = &each.letter;
        }
        return listed(texts, " and ");
    }

    std::string left(const RulesLeft& rules_left) const {
        std::vector<LetterRule> all;
        for (const auto& [letter, images] : rules_left)
            for (const Word& image :
                 make_finite_language(language_.alphabet, {images.begin(), images.end()}).words)
                all.push_back({letter, image});
        return rules(all);
    }

    /// Why rules of one letter are impossible, by one word whatever the rules left for other letters,
    /// or by one step with rules that are there.
    std::string impossible(std::span<const ExcludedRule> same, const RulesLeft& rules_left) const {
        const ExcludedRule& first = same.front();
        std::vector<LetterRule> all;
        for (const ExcludedRule& each : same) all.push_back(each.rule);
        std::string text = rules(all) + (same.size() == 1 ? " is" : " are") + " impossible: ";
        if (!first.images.empty()) return text + departure(first.word, first.images) + ".";
        const std::string from = word(first.word);

        std::vector<std::string> results, forms;
        bool fits = false;  // whether some word of the language has one of the forms
        std::set<Symbol> others(first.word.begin(), first.word.end());
        others.erase(first.rule.letter);
        for (const ExcludedRule& each : same) {
            if (const auto result = only_result(each, rules_left)) results.push_back(word(*result));
            forms.push_back(form(each));
            fits = fits || has_form(each);
        }
        std::vector<std::string> names;
        for (const Symbol a : others) names.push_back(word({a}));
        const bool one = same.size() == 1;
        if (results.size() == same.size()) {
            RulesLeft only;
            for (const Symbol a : others) only[a] = rules_left.at(a);
            std::string start = text;
            if (!only.empty())
                start += "with " + left(only) + ", all that is left for " + listed(names, " and ") +
                         ", ";
            start += from;
            if (same.size() > shown) return start + " would give no word of the language.";
            return start + " would give " + listed(results, " or ") + ", which " +
                   (one ? "is" : "are") + " not in the language.";
        }
        if (fits)
            return text + "whichever of the rules left for " + listed(names, " and ") +
                   " goes with " + (one ? "it" : "them") + ", " + from +
                   " would give no word of the language.";
        if (same.size() > shown)
            return text + "whatever " + listed(names, " and ") + " becomes, " + from +
                   " would give no word of the language.";
        return text + from + " would give " + listed(forms, " or ") +
               ", and no word of the language has " + (one ? "this form." : "one of these forms.");
    }

    /// "by a -> aa and b -> b, ab gives aab, which is not in the language".
    std::string departure(const Word& from, const std::vector<Word>& images) const {
        std::set<LetterRule> used;
        Word result;
        for (std::size_t i = 0; i < from.size(); ++i) {
            used.insert({from[i], images[i]});
            result.insert(result.end(), images[i].begin(), images[i].end());
        }
        return "by " + rules({used.begin(), used.end()}) + ", " + word(from) + " gives " +
               word(result) + ", which is not in the language";
    }

    /// Why the words of these sets are not all reached.
    std::string never_reached(const std::vector<std::vector<Word>>& sets) const {
        if (sets.empty()) return "The axiom would be a word of the language, but there is none.";
        const auto closed = [&](const std::vector<Word>& set) {
            if (set.size() == 1) return "no other word gives " + word(set.front());
            const std::string name =
                marked(to_string(make_finite_language(language_.alphabet, set)));
            return "no word outside " + name + " gives a word of it";
        };
        if (sets.size() == 1)
            return "No other word gives ε, and the axiom is not empty, so ε is never reached.";
        const bool single = sets[0].size() == 1 && sets[1].size() == 1;
        return "By what is left, " + closed(sets[0]) + ", and " + closed(sets[1]) +
               ". The axiom is " +
               (single ? "not both, so one of these words is never reached."
                       : "not in both, so the words of one are never reached.");
    }

private:
    /// "aa…b": the word with the letter replaced and dots for what the other letters become.
    std::string form(const ExcludedRule& excluded) const {
        std::string text;
        for (const Symbol a : excluded.word) {
            if (a == excluded.rule.letter)
                text += excluded.rule.image.empty() ? "" : word(excluded.rule.image);
            else if (!text.ends_with("…"))
                text += "…";
        }
        return text;
    }

    bool has_form(const ExcludedRule& excluded) const {
        return std::any_of(language_.words.begin(), language_.words.end(),
                           [&](const Word& each) { return matches(excluded, each); });
    }

    const FiniteLanguage& language_;
};

using End = ObstructionCase::End;

class ProofText {
public:
    explicit ProofText(const FamilyObstruction& proof) : proof_(proof), say_(proof.language) {}

    std::vector<std::string> lines() {
        const std::string name = marked(to_string(proof_.language));
        const std::string family = to_string(proof_.family);
        line(name + " is not " + family + ".");
        RulesLeft left = factors();
        if (!left.empty()) {
            line(
                "Suppose that a system generates it. Each letter occurs in a word of the language, "
                "and what that word "
                "gives is in the language again. So an image of a letter" +
                std::string(proof_.family.tables ? ", in any table," : "") + " is " +
                images(left.begin()->second) + ".");
        }
        exclusions(proof_.root, left);
        if (proof_.family.tables) {
            for (const ImpossibleTable& table : proof_.impossible) impossible(table, left);
            line(say_.never_reached(proof_.root.sources));
        } else {
            end(proof_.root, left, "");
        }
        line("So " + name + " is not " + family + ".");
        return std::move(lines_);
    }

private:
    void line(const std::string& sentence) {
        lines_.push_back(std::string(2 * depth_, ' ') + sentence);
    }

    RulesLeft factors() const {
        std::set<Word> all;
        if (!proof_.family.propagating) all.emplace();
        for (const Word& word : proof_.language.words)
            for (auto from = word.begin(); from != word.end(); ++from)
                for (auto to = from; to != word.end();) all.emplace(from, ++to);
        RulesLeft left;
        for (const Symbol a : letters_of(proof_.language)) left[a] = all;
        return left;
    }

    std::string images(const std::set<Word>& factors) const {
        const std::string what = proof_.family.propagating ? "factors of its words other than ε"
                                                           : "factors of its words";
        if (factors.size() > 12) return "one of the " + std::to_string(factors.size()) + " " + what;
        std::vector<std::string> names;
        for (const Word& image :
             make_finite_language(proof_.language.alphabet, {factors.begin(), factors.end()}).words)
            names.push_back(say_.word(image));
        return (names.size() == 1 ? "the only one of the " : "one of the ") + what + ": " +
               listed(names, " or ");
    }

    void exclusions(const ObstructionCase& part, RulesLeft& left) {
        const auto& all = part.excluded;
        for (std::size_t i = 0; i < all.size();) {
            std::size_t next =
                i + 1;  // one sentence for rules of one letter that go by the same word
            while (next < all.size() && all[i].images.empty() && all[next].images.empty() &&
                   all[next].rule.letter == all[i].rule.letter && all[next].word == all[i].word)
                ++next;
            line(say_.impossible(std::span(all).subspan(i, next - i), left));
            for (; i < next; ++i) left[all[i].rule.letter].erase(all[i].rule.image);
        }
        if (!all.empty() && part.end != End::no_image && part.end != End::needed)
            line(say_.left(left) +
                 (left.size() > 1 || left.begin()->second.size() > 1 ? " are" : " is") + " left.");
    }

    void impossible(const ImpossibleTable& table, RulesLeft left) {
        const std::string claim =
            "No table has " + say_.rules(table.rules) + (table.rules.size() > 1 ? " together" : "");
        const ObstructionCase& why = table.why;
        if (why.excluded.empty() && why.end == End::conflict && why.rules.empty()) {
            line(claim + ": " + say_.departure(why.word, why.images) + ".");
            return;
        }
        line(claim + ". Suppose one has:");
        ++depth_;
        if (proof_.family.deterministic)
            for (const LetterRule& rule : table.rules) left[rule.letter] = {rule.image};
        exclusions(why, left);
        end(why, left, "");
        --depth_;
    }

    void end(const ObstructionCase& part, const RulesLeft& left, const std::string& number) {
        switch (part.end) {
            case End::no_image:
                line("No rule is left for " + say_.word({part.letter}) + ": a contradiction.");
                return;
            case End::needed:
                line("But " + say_.rule(part.excluded.back().rule) + " is there: a contradiction.");
                return;
            case End::sources:
                line(say_.never_reached(part.sources));
                return;
            case End::conflict:
                conflict(part, left, number);
                return;
            case End::choice:
                choice(part, left, number);
                return;
        }
    }

    void conflict(const ObstructionCase& part, RulesLeft left, const std::string& number) {
        std::string step = say_.departure(part.word, part.images);
        step.front() = 'B';
        if (part.rules.empty()) {
            line(step + ", but these rules are there: a contradiction.");
            return;
        }
        line(step + ". So " + listed(texts(part.rules), " or ") + " is missing.");
        for (std::size_t i = 0; i < part.rules.size(); ++i) {
            RulesLeft rest = left;
            rest[part.rules[i].letter].erase(part.rules[i].image);
            const std::vector<LetterRule> before(
                part.rules.begin(), part.rules.begin() + static_cast<std::ptrdiff_t>(i));
            const std::string there =
                i == 0 ? ""
                       : listed(texts(before), " and ") + (i > 1 ? " are" : " is") + " there, ";
            one_case(part.cases[i], rest, number + std::to_string(i + 1),
                     there + say_.rule(part.rules[i]) + " is missing");
        }
    }

    void choice(const ObstructionCase& part, const RulesLeft& left, const std::string& number) {
        for (std::size_t i = 0; i < part.rules.size(); ++i) {
            RulesLeft only = left;
            only[part.letter] = {part.rules[i].image};
            one_case(part.cases[i], only, number + std::to_string(i + 1), say_.rule(part.rules[i]));
        }
    }

    void one_case(const ObstructionCase& part, RulesLeft left, const std::string& number,
                  const std::string& what) {
        line("Case " + number + ": " + what + ".");
        ++depth_;
        exclusions(part, left);
        end(part, left, number + ".");
        --depth_;
    }

    std::vector<std::string> texts(const std::vector<LetterRule>& rules) const {
        std::vector<std::string> all;
        for (const LetterRule& rule : rules) all.push_back(say_.rule(rule));
        return all;
    }

    const FamilyObstruction& proof_;
    FiniteSentences say_;
    std::vector<std::string> lines_;
    std::size_t depth_ = 0;
};

}  // namespace

std::vector<std::string> marked_proof(const FamilyObstruction& obstruction) {
    return ProofText(obstruction).lines();
}

}  // namespace algae
