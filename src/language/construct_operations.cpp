#include <algorithm>
#include <map>
#include <set>

#include "exact/exact.hpp"
#include "language/detail/construct.hpp"
#include "word/word.hpp"

// Closure under union, concatenation, star, plus, reversal and substitution (Herman and Rozenberg 1975;
// Rozenberg and Salomaa 1980, II.1, IV.1 and V.1).
//
// There are two families of constructions. Those that keep one table (e0l_...) synchronise the parts first:
// then a part has terminals only from the same step on, so parts can be started side by side, and each waits as
// long as it likes before it starts. Those with further tables
// (table_...) derive the parts one after the other with copies of the letters that are not terminals, while all
// else stays as it is; a table that finishes a part makes terminals of its letters. They keep deterministic
// tables deterministic.
//
// Images under substitutions where some images are empty are the subtle case with one table: terminals that
// vanish could hide that other letters are not done. So the rules that erase are eliminated together with the
// letters that have empty images, and the empty word is added if it is an image.
//
// Codings. Every E0L language with a non-empty word is a coding of an 0L language (Ehrenfeucht and Rozenberg 1974;
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

ET0L reversed(const ET0L& system) {
    ET0L result = system;
    std::reverse(result.axiom.begin(), result.axiom.end());
    for (Table& rules : result.tables)
        for (auto& successors : rules)
            for (Word& word : successors) std::reverse(word.begin(), word.end());
    return result;
}

namespace {

/// The rules of a synchronised system for the same language, as part of the draft; its axiom.
Symbol synchronised_part(Draft& draft, const ET0L& system, const char* operation) {
    require_one_table(system, operation);
    const ET0L separate = synchronised(system);
    const auto letters = draft.letters(separate);
    draft.add_rules(0, separate, 0, letters);
    return letters[separate.axiom.front()];
}

ET0L e0l_several(const ET0L& system, bool none, const char* operation) {
    Draft draft(*system.alphabet);
    const Symbol axiom = synchronised_part(draft, system, operation), start = draft.fresh("S"),
                 more = draft.fresh("R");
    draft.keep(axiom);
    draft.add_rule(0, start, {more});
    if (none) draft.add_rule(0, start, {});
    draft.add_rule(0, more, {more, axiom});
    draft.add_rule(0, more, {axiom});
    return draft.system({start}, operation);
}

}  // namespace

ET0L e0l_union(const ET0L& left, const ET0L& right) {
    Draft draft(*left.alphabet);
    const Symbol first = synchronised_part(draft, left, "union"),
                 second = synchronised_part(draft, right, "union"), start = draft.fresh("S");
    draft.add_rule(0, start, {first});
    draft.add_rule(0, start, {second});
    return draft.system({start}, "union");
}

ET0L e0l_concatenation(const ET0L& left, const ET0L& right) {
    Draft draft(*left.alphabet);
    const Symbol first = synchronised_part(draft, left, "concatenation"),
                 second = synchronised_part(draft, right, "concatenation");
    draft.keep(first);
    draft.keep(second);
    return draft.system({first, second}, "concatenation");
}

ET0L e0l_plus(const ET0L& system) { return e0l_several(system, false, "plus"); }

ET0L e0l_star(const ET0L& system) { return e0l_several(system, true, "star"); }

namespace {

/// Copies of the letters of a system and its tables, as part of a draft.
struct Part {
    std::vector<Symbol> copies;
    Word axiom;
    std::size_t first = 0, last = 0;  // its tables: first, ..., last - 1
};

Part part_of(Draft& draft, const ET0L& system) {
    Part found;
    found.copies = draft.copies(system);
    found.axiom = replaced(system.axiom, found.copies);
    found.first = draft.add_tables(system);
    found.last = draft.tables();
    for (std::size_t t = found.first; t < found.last; ++t)
        draft.add_rules(t, system, t - found.first, found.copies);
    return found;
}

/// In this table copies of terminals become the terminals; the others fail.
void finish(Draft& draft, std::size_t table, const ET0L& system, const Part& part) {
    for (Symbol a = 0; a < part.copies.size(); ++a)
        if (system.terminal[a])
            draft.add_rule(table, part.copies[a], {draft.terminal(system.alphabet->name(a))});
}

Word joined(Word left, Symbol right) {
    left.push_back(right);
    return left;
}

ET0L table_several(const ET0L& system, bool none) {
    Draft draft(*system.alphabet, 0);
    const Part inner = part_of(draft, system);
    const Symbol rest = draft.fresh("R");
    for (std::size_t t = inner.first; t < inner.last; ++t) draft.add_rule(t, rest, {rest});
    const std::size_t another = draft.add_table(), end = draft.add_table();
    finish(draft, another, system, inner);
    finish(draft, end, system, inner);
    draft.add_rule(another, rest, joined(inner.axiom, rest));
    draft.add_rule(end, rest, {});
    draft.keep_terminals();
    return draft.system(none ? Word{rest} : joined(inner.axiom, rest), none ? "star" : "plus");
}

}  // namespace

ET0L table_union(const ET0L& left, const ET0L& right) {
    Draft draft(*left.alphabet, 0);
    const Symbol start = draft.fresh("S");
    const Part first = part_of(draft, left), second = part_of(draft, right);
    for (std::size_t t = first.first; t < first.last; ++t) draft.add_rule(t, start, first.axiom);
    for (std::size_t t = second.first; t < second.last; ++t) draft.add_rule(t, start, second.axiom);
    const std::size_t end = draft.add_table();
    finish(draft, end, left, first);
    finish(draft, end, right, second);
    return draft.system({start}, "union");
}

ET0L table_concatenation(const ET0L& left, const ET0L& right) {
    Draft draft(*left.alphabet, 0);
    const Symbol rest = draft.fresh("R");
    const Part first = part_of(draft, left), second = part_of(draft, right);
    for (std::size_t t = first.first; t < first.last; ++t) draft.add_rule(t, rest, {rest});
    const std::size_t end = draft.add_table();
    finish(draft, end, left, first);
    finish(draft, end, right, second);
    draft.add_rule(end, rest, second.axiom);
    draft.keep_terminals();
    return draft.system(joined(first.axiom, rest), "concatenation");
}

ET0L table_plus(const ET0L& system) { return table_several(system, false); }

ET0L table_star(const ET0L& system) { return table_several(system, true); }

namespace {

/// Throws Error if a terminal that a synchronised system reaches has no images.
void require_images(const ET0L& separate, const Substitution& images) {
    for (const Symbol a : accessible_letters(separate))
        if (separate.terminal[a] && !images.contains(a))
            throw Error("expected an image of every letter, found none of the letter " +
                        separate.alphabet->name(a));
}

bool has_empty(const std::vector<Word>& words) {
    return std::any_of(words.begin(), words.end(), [](const Word& word) { return word.empty(); });
}

/// The words of terminals that a word becomes if each letter is replaced by one of its non-empty images.
std::vector<Word> choices(Draft& draft, const Alphabet& alphabet, const Word& word,
                          const Substitution& images, const Budget& budget) {
    std::vector<Word> found{{}};
    for (const Symbol a : word) {
        std::vector<Word> longer;
        const auto known = images.find(a);  // absent only for letters that no derivation reaches
        if (known == images.end()) return {};
        for (const Word& image : known->second) {
            if (image.empty()) continue;
            const Word letters = draft.terminals(alphabet, image);
            for (const Word& begun : found) {
                longer.push_back(begun);
                longer.back().insert(longer.back().end(), letters.begin(), letters.end());
                budget.check();
                budget.check_memory(
                    longer.size() * (sizeof(Word) + longer.back().size() * sizeof(Symbol)),
                    "the images of a successor");
            }
        }
        found = std::move(longer);
    }
    return found;
}

}  // namespace

Substitution substitution(const Morphism& morphism) {
    Substitution found;
    for (const Symbol a : morphism.domain()) found[a] = {morphism[a]};
    return found;
}

ET0L e0l_image(const ET0L& system, const Substitution& images, const Budget& budget) {
    ET0L separate = synchronised(system);
    require_images(separate, images);
    bool vanishes = false;
    std::vector<char> may_go(separate.alphabet->size());
    for (const auto& [a, words] : images) may_go.at(a) = has_empty(words);
    if (std::find(may_go.begin(), may_go.end(), 1) != may_go.end()) {
        vanishes = can_vanish(separate, may_go, budget);
        separate = thinned(separate, may_go, budget);
    }

    Draft draft(*system.alphabet, 0);
    draft.add_tables(system);
    const auto letters = draft.copies(separate);
    for (std::size_t t = 0; t < separate.tables.size(); ++t) {
        for (Symbol a = 0; a < letters.size(); ++a)
            if (!separate.terminal[a])
                for (const Word& successor : separate.tables[t][a])
                    for (Word& word :
                         is_terminal_word(separate, successor)
                             ? choices(draft, *system.alphabet, successor, images, budget)
                             : std::vector<Word>{replaced(successor, letters)})
                        draft.add_rule(t, letters[a], std::move(word));
        if (vanishes) draft.add_rule(t, letters[separate.axiom.front()], {});
        draft.check(budget);
    }
    return draft.system({letters[separate.axiom.front()]}, "image");
}

ET0L table_image(const ET0L& system, const Substitution& images) {
    require_images(trimmed(system, *system.alphabet, system.name), images);
    Draft draft(*system.alphabet, 0);
    draft.add_tables(system);
    const auto copies = draft.copies(system);
    for (std::size_t t = 0; t < system.tables.size(); ++t) draft.add_rules(t, system, t, copies);
    const std::size_t end = draft.add_table();
    for (const auto& [a, words] : images)
        if (system.terminal.at(a))
            for (const Word& word : words)
                draft.add_rule(end, copies[a], draft.terminals(*system.alphabet, word));
    return draft.system(replaced(system.axiom, copies), "image");
}

ET0L substituted(const ET0L& system, const std::map<Symbol, ET0L>& languages) {
    const ET0L useful = trimmed(system, *system.alphabet, system.name);
    for (const Symbol a : accessible_letters(useful))
        if (useful.terminal[a] && !languages.contains(a))
            throw Error("expected a language for every letter, found none for the letter " +
                        useful.alphabet->name(a));

    Draft draft(*system.alphabet, 0);
    const std::size_t outer = draft.add_tables(system), turn = draft.add_table();
    const auto copies = draft.copies(system);
    for (std::size_t t = 0; t < system.tables.size(); ++t)
        draft.add_rules(outer + t, system, t, copies);
    std::vector<Symbol> waiting;
    for (const auto& [a, language] : languages) {
        if (!system.terminal.at(a)) continue;
        waiting.push_back(draft.fresh(system.alphabet->name(a)));
        const auto inner = draft.copies(language);
        draft.add_rule(turn, copies[a], {waiting.back()});
        draft.add_rule(turn, waiting.back(), replaced(language.axiom, inner));
        for (Symbol b = 0; b < inner.size(); ++b)
            if (language.terminal[b])
                draft.add_rule(turn, inner[b], draft.terminals(*language.alphabet, {b}));
        const std::size_t first = draft.add_tables(language);
        for (std::size_t t = 0; t < language.tables.size(); ++t)
            draft.add_rules(first + t, language, t, inner);
    }
    for (const Symbol a : waiting) draft.keep(a);
    draft.keep_terminals();
    return draft.system(replaced(system.axiom, copies), "substitution");
}

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
