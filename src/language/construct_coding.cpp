#include "language/detail/construct.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "exact/exact.hpp"
#include "word/word.hpp"

// Every E0L language with a non-empty word is a coding of an 0L language (Ehrenfeucht and Rozenberg 1974;
// Rozenberg and Salomaa 1980, II.2).
//
// Rules that erase are eliminated and the system is synchronised. The sets B(t) of letters that derive terminal
// words in exactly t steps are those of t - 1 seen through the rules, so from some s on they come again after p
// steps. A terminal word of step n >= s is derived through a word of letters of B(r) in step n - r, where r of
// s, ..., s + p - 1 differs from n by a multiple of p; every letter of B(r) has words of B(r) in p steps, and
// terminal words in r. So L(G) is a finite set and, for each r, what a finite substitution without empty words
// makes of the words of an 0L system with the p-step rules. The new letters are those of the blocks that it
// gives: the first letter of a block is rewritten to the blocks of a successor, the others vanish. The axiom is
// a shortest word of L(G), whose first letter starts everything else.

namespace algae {

namespace {

using Marks = std::vector<char>;
using Derived = std::vector<std::vector<Word>>;  // words of each letter

/// B(0), ..., B(s + p - 1): the letters from which terminal words are derived in so many steps.
struct Spectrum {
    std::vector<Marks> letters;
    std::size_t start = 0;  // s, at least 1

    explicit Spectrum(const ET0L& system) : letters{system.terminal} {
        for (;;) {
            Marks next(system.terminal.size());
            for (Symbol a = 0; a < next.size(); ++a)
                next[a] =
                    std::any_of(system.tables[0][a].begin(), system.tables[0][a].end(),
                                [&](const Word& word) { return all_marked(word, letters.back()); });
            const auto before = std::find(letters.begin() + 1, letters.end(), next);
            if (letters.size() > 1 && before != letters.end()) {
                start = static_cast<std::size_t>(before - letters.begin());
                return;
            }
            letters.push_back(std::move(next));
        }
    }
    std::size_t period() const { return letters.size() - start; }
    /// B(t) for any t.
    const Marks& at(std::size_t t) const {
        return letters[t < letters.size() ? t : start + (t - start) % period()];
    }
};

/// Makes the words that letters derive in many steps, and the 0L system of their blocks.
class Blocks {
public:
    Blocks(const ET0L& system, const Alphabet& base, const Budget& budget)
        : system_(&system),
          budget_(&budget),
          sets_(budget),
          spectrum_(system),
          alphabet_(base),
          names_(alphabet_) {}

    CodedOL result(bool empty) {
        const Symbol axiom = system_->axiom.front();
        // The words that the first letter starts: those that stay, then the blocks of each remainder.
        std::set<Word> first;
        std::vector<Word> found = listed_short_words(axiom);
        for (const Word& word : found) first.insert(staying(word));
        const std::size_t last = spectrum_.start + spectrum_.period();
        for (std::size_t r = spectrum_.start; r < last; ++r) {
            if (!spectrum_.letters[r][axiom]) continue;
            derive(r);
            for (const Word& word : terminal_words_[r][axiom]) {
                found.push_back(word);
                first.insert(block({r, axiom}, word));
            }
        }
        if (found.empty())
            throw Error(
                "expected a system that derives a word of terminals that is not empty, found none");
        if (empty) first.insert(Word{});
        const Word& shortest = *std::min_element(found.begin(), found.end(), shortlex_less);
        Word start;
        for (std::size_t i = 0; i < shortest.size(); ++i) start.push_back(add_letter(shortest[i]));
        add_rules(start, first);
        while (!open_.empty()) {
            const auto [origin, word] = open_.back();
            open_.pop_back();
            add_rules(blocks_.at({origin, word}), successors(origin));
        }
        return finished(std::move(start));
    }

private:
    using Origin = std::pair<std::size_t, Symbol>;  // r and a letter of B(r)

    /// What words of each letter of B(t + 1) become if those of B(t) have these.
    Derived before(const Derived& words, std::size_t t) {
        Derived found(words.size());
        const Marks &now = spectrum_.at(t), &earlier = spectrum_.at(t + 1);
        for (Symbol a = 0; a < words.size(); ++a) {
            if (!earlier[a]) continue;
            for (const Word& successor : system_->tables[0][a])
                if (all_marked(successor, now)) sets_.add(found[a], products(successor, words));
        }
        return found;
    }

    std::vector<Word> products(const Word& word, const Derived& words) {
        std::vector<Word> found = sets_.one();
        for (const Symbol a : word) {
            budget_->check();
            sets_.append(found, words[a]);
        }
        return found;
    }

    Derived letters_themselves(const Marks& letters) const {
        Derived found(letters.size());
        for (Symbol a = 0; a < letters.size(); ++a)
            if (letters[a]) found[a] = {{a}};
        return found;
    }

    /// The terminal words that the axiom derives in fewer than s steps.
    std::vector<Word> listed_short_words(Symbol axiom) {
        std::vector<Word> found;
        Derived words = letters_themselves(spectrum_.at(0));
        for (std::size_t t = 0; t < spectrum_.start; ++t) {
            sets_.add(found, words[axiom]);
            words = before(words, t);
        }
        return found;
    }

    /// The terminal words of the letters of B(r) in r steps, and their words of B(r) in p steps.
    void derive(std::size_t r) {
        Derived words = letters_themselves(spectrum_.at(0));
        for (std::size_t t = 0; t < r; ++t) words = before(words, t);
        terminal_words_[r] = std::move(words);
        words = letters_themselves(spectrum_.at(r));
        for (std::size_t t = 0; t < spectrum_.period(); ++t) words = before(words, r + t);
        rules_[r] = std::move(words);
    }

    Symbol add_letter(Symbol terminal) {
        const Symbol letter = names_.symbol(system_->alphabet->name(terminal));
        coding_.add(letter, {terminal});
        return letter;
    }

    /// Letters that are never rewritten.
    Word staying(const Word& word) {
        Word found;
        for (const Symbol a : word) {
            const auto [place, fresh] = stays_.try_emplace(a, 0);
            if (fresh) {
                place->second = add_letter(a);
                rules_of_[place->second] = {{place->second}};
            }
            found.push_back(place->second);
        }
        return found;
    }

    /// The letters for a terminal word that the letter derives in r steps.
    const Word& block(const Origin& origin, const Word& word) {
        const auto [place, fresh] = blocks_.try_emplace({origin, word});
        if (fresh) {
            for (const Symbol a : word) place->second.push_back(add_letter(a));
            open_.emplace_back(origin, word);
        }
        return place->second;
    }

    /// The blocks of what the letter derives in p steps.
    std::set<Word> successors(const Origin& origin) {
        const auto& [r, letter] = origin;
        std::set<Word> found;
        for (const Word& word : rules_[r][letter]) {
            std::vector<Word> begun{{}};
            for (const Symbol a : word) {
                std::vector<Word> longer;
                for (const Word& terminals : terminal_words_[r][a]) {
                    const Word& letters = block({r, a}, terminals);
                    for (const Word& start : begun) {
                        longer.push_back(start);
                        longer.back().insert(longer.back().end(), letters.begin(), letters.end());
                    }
                    check(longer.size() * (longer.empty() ? 0 : longer.back().size()));
                }
                begun = std::move(longer);
            }
            found.insert(begun.begin(), begun.end());
        }
        return found;
    }

    /// The first letter has these successors, the others vanish.
    void add_rules(const Word& letters, const std::set<Word>& successors) {
        for (const Symbol a : letters) rules_of_[a] = {{}};
        rules_of_[letters.front()] = {successors.begin(), successors.end()};
        for (const Word& word : successors) size_ += word.size() + sizeof(Word) / sizeof(Symbol);
        check(0);
    }

    void check(std::size_t more) const {
        budget_->check();
        budget_->check_memory((size_ + more) * sizeof(Symbol), "the rules of the 0L system");
    }

    CodedOL finished(Word axiom) {
        OL system;
        system.axiom = std::move(axiom);
        system.successors.resize(alphabet_.size());
        for (Symbol a = 0; a < alphabet_.size(); ++a) {
            const auto known = rules_of_.find(a);
            system.successors[a] =
                known == rules_of_.end() ? std::vector<Word>{{a}} : std::move(known->second);
        }
        system.alphabet = std::make_shared<const Alphabet>(std::move(alphabet_));
        system.name = system_->name;
        system.letters = accessible_letters(as_et0l(system));
        return {std::move(system), std::move(coding_)};
    }

    const ET0L* system_;
    const Budget* budget_;
    WordSets sets_;
    Spectrum spectrum_;
    Alphabet alphabet_;
    NewNames names_;
    std::map<std::size_t, Derived> terminal_words_, rules_;  // by r
    std::map<std::pair<Origin, Word>, Word> blocks_;
    std::vector<std::pair<Origin, Word>> open_;
    std::map<Symbol, Symbol> stays_;
    std::map<Symbol, std::vector<Word>> rules_of_;
    Morphism coding_;
    std::size_t size_ = 0;  // symbols written
};

}  // namespace

CodedOL coding_of_0l(const ET0L& system, const Budget& budget) {
    require_one_table(system, "coding");
    const ET0L plain = propagating(system, budget);
    return Blocks(plain, *system.alphabet, budget).result(can_vanish(system, {}, budget));
}

}  // namespace algae
