#include <algorithm>
#include <bit>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <unordered_set>

#include "growth/growth.hpp"
#include "language/detail/interactive.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/letters.hpp"
#include "language/detail/powers.hpp"
#include "language/detail/regular.hpp"
#include "word/word.hpp"

// The words of a language: listed in order, counted by length, drawn at random.
//
// A regular language has its minimal automaton: which states accept a word of exactly k letters says where a listing has to go, how
// many such words each state accepts says how often a draw goes where, and the numbers of words are those of paths, row *
// matrix^n * column, whose shortest recurrence is the generating function.
//
// Of another language all words of at most n letters are worked out (`Bounded`), by what an operation does to the words of its
// parts up to a length. For a system without context let F_k(a) be the words of at most n letters that the letter a derives in k
// steps. F_(k+1)(a) is the union of the products F_k(b) F_k(c) ... over its successors bc..., cut at n letters, so what comes
// depends on the family (F_k(a)) only: when the families repeat, or with several tables no new family comes, nothing new is
// derived. Erasing rules and terminals need nothing more. Where nothing is erased and every letter is a terminal the derived
// words of at most n letters are followed instead, of which there are as many as there are words to be listed.
//
// Each part says for how many lengths it is decided. Words beyond are still words of the language; an operation that denies a
// part (difference, complement) asks there whether each word is in it, by `judge_membership`.
//
// n grows until there are as many words as are wanted: it doubles while the words are few, and otherwise grows by one, since there
// may be exponentially many. A step that is larger than one and needs much memory is taken back.

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

/// A length as an index; lengths of words that are kept fit.
std::size_t at(std::uint64_t length) { return static_cast<std::size_t>(length); }

struct Hash {
    std::size_t operator()(const Word& word) const {
        std::size_t hash = word.size();
        for (const Symbol a : word)
            hash = (hash ^ a) * static_cast<std::size_t>(0x9E3779B97F4A7C15u);
        return hash ^ hash >> 29;
    }
};
using WordSet = std::unordered_set<Word, Hash>;

std::vector<Word> sorted(std::vector<Word> words) {
    std::sort(words.begin(), words.end(), shortlex_less);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return words;
}

bool is_among(const std::vector<Word>& words, const Word& word) {
    return std::binary_search(words.begin(), words.end(), word, shortlex_less);
}

std::uint64_t bytes_of(const Word& word) {
    return sizeof(Word) + 16 + word.size() * sizeof(Symbol);
}

// --- All words up to a length ---

/// The words of at most so many letters that are found, and for how many lengths 0, 1, ... these are all.
struct Found {
    std::vector<Word> words;  // sorted
    std::uint64_t decided = 0;
};

/// The automata of languages, where they have one that is not too large, each worked out once.
class Automata {
public:
    Automata(const Alphabet& alphabet, const Budget& budget)
        : alphabet_(&alphabet), budget_(&budget) {}

    const RegularLanguage* of(const Language& language) {
        auto [place, is_new] = known_.try_emplace(language.get());
        if (is_new) {
            try {
                place->second = regular_value(language, *alphabet_, *budget_);
            } catch (const BoundReached& bound) {
                if (bound.bound() == Bound::time) throw;
            }
        }
        return place->second ? &*place->second : nullptr;
    }

private:
    const Alphabet* alphabet_;
    const Budget* budget_;
    std::map<const LanguageTree*, std::optional<RegularLanguage>> known_;
};

class Bounded {
public:
    /// All must outlive this.
    Bounded(const Alphabet& alphabet, Automata& automata, const Budget& budget)
        : alphabet_(&alphabet), automata_(&automata), budget_(&budget) {}

    Found words(const Language& language, std::uint64_t longest) {
        budget_->check();
        const auto key = std::pair(language.get(), longest);
        if (const auto known = known_.find(key); known != known_.end()) return known->second;
        Found found;
        if (const RegularLanguage* regular = automata_->of(language))
            found = {words_up_to(*regular, at(longest), *budget_), longest + 1};
        else
            found = of(language, longest);
        found.decided = std::min(found.decided, longest + 1);
        for (const Word& word : found.words) bytes_ += bytes_of(word);
        budget_->check_memory(bytes_, "the words up to that length");
        return known_.emplace(key, std::move(found)).first->second;
    }

    /// Why not all lengths are decided.
    const std::string& reason() const { return reason_; }

private:
    Found of(const Language& language, std::uint64_t longest) {
        const LanguageTree& tree = *language;
        switch (tree.kind) {
            case Kind::words:
                break;
            case Kind::generated:
                return tree.system->tables ? of_tables(*tree.system->tables, longest)
                                           : of_interactive(*tree.system, longest);
            case Kind::united:
                return united(words(tree.parts[0], longest), words(tree.parts[1], longest));
            case Kind::intersected:
                return intersected(tree, longest);
            case Kind::difference:
                return sieved(words(tree.parts[0], longest), tree.parts[1], false, longest);
            case Kind::concatenated:
                return concatenated(words(tree.parts[0], longest), words(tree.parts[1], longest),
                                    longest);
            case Kind::star:
            case Kind::plus:
                return iterated(words(tree.parts[0], longest), tree.kind, longest);
            case Kind::complement:
                return complement(tree, longest);
            case Kind::reversed:
                return reversed(words(tree.parts[0], longest));
            case Kind::image:
                return image(tree.parts[0], tree.morphism, longest);
            case Kind::inverse_image:
                return inverse_image(tree, longest);
            case Kind::powers:
                return powers(*tree.powers, longest);
            case Kind::variable:
                break;
        }
        throw Error("a bound name has no words");
    }

    static Found united(const Found& left, const Found& right) {
        std::vector<Word> all = left.words;
        all.insert(all.end(), right.words.begin(), right.words.end());
        return {sorted(std::move(all)), std::min(left.decided, right.decided)};
    }

    /// The words that are in the other language, or that are not.
    Found sieved(Found from, const Language& by, bool keep, std::uint64_t longest) {
        const RegularLanguage* const regular = automata_->of(by);
        Found other;
        if (!regular && !from.words.empty()) {
            try {
                other = words(by, std::min<std::uint64_t>(longest, from.words.back().size()));
            } catch (const BoundReached& bound) {
                if (bound.bound() == Bound::time) throw;
            }
        }
        Found kept{{}, from.decided};
        for (Word& word : from.words) {
            budget_->check();
            Truth in = Truth::proved;
            if (regular)
                in = regular->contains(word) ? Truth::proved : Truth::refuted;
            else if (!is_among(other.words, word))
                in = word.size() < other.decided
                         ? Truth::refuted
                         : judge_membership(by, word, *alphabet_, *budget_).truth;
            if (in == Truth::undecided) {
                kept.decided = std::min<std::uint64_t>(kept.decided, word.size());
                reason_ = "whether " + spell(*alphabet_, word) + " is in " +
                          to_string(by, *alphabet_) + " was not decided";
            } else if ((in == Truth::proved) == keep) {
                kept.words.push_back(std::move(word));
            }
        }
        return kept;
    }

    Found intersected(const LanguageTree& tree, std::uint64_t longest) {
        const Language &left = tree.parts[0], &right = tree.parts[1];
        if (automata_->of(right)) return sieved(words(left, longest), right, true, longest);
        if (automata_->of(left)) return sieved(words(right, longest), left, true, longest);
        const Found one = words(left, longest), other = words(right, longest);
        return one.decided >= other.decided ? sieved(one, right, true, longest)
                                            : sieved(other, left, true, longest);
    }

    /// No word of the language has fewer letters.
    static std::uint64_t shortest(const Found& found) {
        return found.words.empty()
                   ? found.decided
                   : std::min<std::uint64_t>(found.decided, found.words.front().size());
    }

    Found concatenated(const Found& left, const Found& right, std::uint64_t longest) {
        return {sorted(products(left.words, right.words, longest)),
                std::min(left.decided + shortest(right), right.decided + shortest(left))};
    }

    static Found reversed(Found found) {
        for (Word& word : found.words) std::reverse(word.begin(), word.end());
        return {sorted(std::move(found.words)), found.decided};
    }

    /// All products of at most so many letters; some may be there more than once.
    std::vector<Word> products(const std::vector<Word>& left, const std::vector<Word>& right,
                               std::uint64_t longest) {
        std::vector<Word> all;
        std::uint64_t bytes = 0;
        for (const Word& u : left) {
            for (const Word& v : right) {
                if (u.size() + v.size() > longest) break;
                all.push_back(u);
                all.back().insert(all.back().end(), v.begin(), v.end());
                bytes += bytes_of(all.back());
            }
            budget_->check();
            budget_->check_memory(bytes_ + bytes, "the words up to that length");
        }
        return all;
    }

    Found iterated(const Found& base, Kind kind, std::uint64_t longest) {
        const bool has_empty = !base.words.empty() && base.words.front().empty();
        budget_->check_memory(bytes_ + (longest + 1) * sizeof(std::vector<Word>),
                              "the words up to that length");
        std::vector<std::vector<Word>> by_length(at(longest + 1));
        by_length[0] = {Word{}};
        std::uint64_t bytes = 0;
        for (std::uint64_t length = 1; length <= longest; ++length) {
            std::vector<Word>& all = by_length[at(length)];
            for (const Word& first : base.words) {
                if (first.empty()) continue;
                if (first.size() > length) break;
                for (const Word& rest : by_length[at(length - first.size())]) {
                    all.push_back(first);
                    all.back().insert(all.back().end(), rest.begin(), rest.end());
                    bytes += bytes_of(all.back());
                }
                budget_->check();
                budget_->check_memory(bytes_ + bytes, "the words up to that length");
            }
            all = sorted(std::move(all));
        }
        Found found{{}, base.decided};
        for (std::uint64_t length = 0; length <= longest; ++length) {
            if (length == 0 && kind == Kind::plus && !has_empty) continue;
            found.words.insert(found.words.end(), by_length[at(length)].begin(),
                               by_length[at(length)].end());
        }
        return found;
    }

    Found complement(const LanguageTree& tree, std::uint64_t longest) {
        Found all{{Word{}}, longest + 1};
        std::uint64_t bytes = 0;
        for (std::size_t i = 0; i < all.words.size() && all.words[i].size() < longest; ++i) {
            for (const Symbol a : tree.letters) {
                Word longer = all.words[i];
                longer.push_back(a);
                bytes += bytes_of(longer);
                all.words.push_back(std::move(longer));
            }
            budget_->check();
            budget_->check_memory(bytes_ + bytes, "all words up to that length");
        }
        return sieved(std::move(all), tree.parts[0], false, longest);
    }

    /// The images of the words all of whose letters have one. Where a letter is erased, a short image may come from a long word, so
    /// the morphism is taken on to the parts, down to what systems derive from each letter.
    Found image(const Language& of, const Morphism& morphism, std::uint64_t longest) {
        budget_->check();
        const LanguageTree& tree = *of;
        std::uint64_t least = longest + 1;  // letters of an image of a letter
        for (const Symbol a : letters_of(of))
            if (morphism.maps(a)) least = std::min<std::uint64_t>(least, morphism[a].size());
        if (least > 0) {
            const Found from = words(of, longest / least);
            // An image of length l has a source of at most l / least letters.
            return {images(from.words, morphism, longest), from.decided * least};
        }
        if (const RegularLanguage* const regular = automata_->of(of))
            return {words_up_to(algae::image(algae::intersected(
                                                 *regular, all_words(morphism.domain()), *budget_),
                                             morphism.images(), *budget_),
                                at(longest), *budget_),
                    longest + 1};
        const auto part = [&](std::size_t i) { return image(tree.parts[i], morphism, longest); };
        switch (tree.kind) {
            case Kind::united:
                return united(part(0), part(1));
            case Kind::concatenated:
                return concatenated(part(0), part(1), longest);
            case Kind::star:
            case Kind::plus:
                return iterated(part(0), tree.kind, longest);
            case Kind::reversed: {
                Morphism turned;
                for (const Symbol a : morphism.domain())
                    turned.add(a, Word(morphism[a].rbegin(), morphism[a].rend()));
                return reversed(image(tree.parts[0], turned, longest));
            }
            case Kind::image: {
                Morphism both;
                for (const Symbol a : tree.morphism.domain())
                    if (auto further = morphism.image_of(tree.morphism[a]))
                        both.add(a, std::move(*further));
                return image(tree.parts[0], both, longest);
            }
            default:
                break;
        }
        if (const auto tables = table_value(of, *alphabet_, *budget_))
            return of_tables(tables->system, longest, &morphism);
        reason_ = "a letter is erased, and " + to_string(of, *alphabet_) +
                  " is not known to be the language of a system without context";
        return {images(words(of, longest).words, morphism, longest), 0};
    }

    static std::vector<Word> images(const std::vector<Word>& sources, const Morphism& morphism,
                                    std::uint64_t longest) {
        std::vector<Word> all;
        for (const Word& word : sources)
            if (auto mapped = morphism.image_of(word); mapped && mapped->size() <= longest)
                all.push_back(std::move(*mapped));
        return sorted(std::move(all));
    }

    Found inverse_image(const LanguageTree& tree, std::uint64_t longest) {
        const std::vector<Symbol> domain = tree.morphism.domain();
        std::uint64_t most = 0;  // letters of an image of a letter
        for (const Symbol a : domain) most = std::max<std::uint64_t>(most, tree.morphism[a].size());
        const Found in = words(tree.parts[0], longest * most);
        WordSet wanted(in.words.begin(), in.words.end()), beginnings;
        for (const Word& word : in.words)
            for (auto end = word.end(); beginnings.emplace(word.begin(), end).second;) {
                if (end == word.begin()) break;
                --end;
            }
        std::vector<std::pair<Word, Word>> open;  // words with their images
        if (beginnings.contains(Word{})) open.emplace_back();
        Found found;
        std::uint64_t bytes = 0;
        for (std::size_t i = 0; i < open.size(); ++i) {
            budget_->check();
            budget_->check_memory(bytes_ + bytes, "the words up to that length");
            const auto [word, mapped] = open[i];
            if (wanted.contains(mapped)) found.words.push_back(word);
            if (word.size() == longest) continue;
            for (const Symbol a : domain) {
                Word next = mapped;
                next.insert(next.end(), tree.morphism[a].begin(), tree.morphism[a].end());
                if (!beginnings.contains(next)) continue;
                Word longer = word;
                longer.push_back(a);
                bytes += bytes_of(longer) + bytes_of(next);
                open.emplace_back(std::move(longer), std::move(next));
            }
        }
        found.words = sorted(std::move(found.words));
        found.decided = in.decided == 0 ? 0 : most == 0 ? longest + 1 : (in.decided - 1) / most + 1;
        return found;
    }

    Found powers(const Powers& powers, std::uint64_t longest) {
        // Each number stands in an exponent of a word that is not empty, and makes it longer.
        std::vector<std::uint64_t> values;
        for (const Powers::Number& number : powers.numbers) values.push_back(number.least);
        Found found{{}, longest + 1};
        Budget letters = *budget_;
        letters.letters = std::min<std::uint64_t>(letters.letters, longest);
        const auto fits = [&](const std::vector<std::uint64_t>& at) {
            budget_->check();
            try {
                Word word = word_of(powers, at, letters);
                if (word.size() > longest) return false;
                found.words.push_back(std::move(word));
                return true;
            } catch (const BoundReached& bound) {
                if (bound.bound() != Bound::letters) throw;
                return false;
            }
        };
        if (values.size() < 2) {
            if (values.empty())
                fits(values);
            else
                while (fits(values)) ++values[0];
        } else {
            for (const std::uint64_t least = values[1]; fits(values); ++values[0]) {
                for (++values[1]; fits(values);) ++values[1];
                values[1] = least;
            }
        }
        found.words = sorted(std::move(found.words));
        return found;
    }

    // --- Systems ---

    /// Generation after generation, as long as words are not too long. Where nothing is erased they never become shorter again.
    Found of_interactive(const SourceSystem& system, std::uint64_t longest) {
        const bool shrinks = !has_form(system, *system_form("PIL"));
        SearchOfWords search{shrinks ? std::size_t{10'000} : std::size_t{1'000'000},
                             budget_->letters / 100};
        if (!shrinks) search.longest = at(longest);
        FoundWords derived = found_words(*system.interactive, search, *budget_);
        if (!derived.is_all)
            reason_ = "the first " + std::to_string(derived.words.size()) + " words of L(" +
                      system.name + ") are not all, and later ones may be " +
                      (shrinks ? "shorter" : "as short");
        std::erase_if(derived.words, [&](const Word& word) { return word.size() > longest; });
        return {sorted(std::move(derived.words)), derived.is_all ? longest + 1 : 0};
    }

    /// Of the words, or of their images. The terminals of a constructed system have the numbers that they have elsewhere.
    Found of_tables(const ET0L& system, std::uint64_t longest, const Morphism* morphism = nullptr) {
        if (!morphism && has_only_terminals(system) && is_propagating(system))
            return derived(system, longest);
        Derivations process(system, morphism, longest, *budget_);
        static_cast<void>(walk_of_tables(process, system.tables.size(), *budget_));
        return {process.words(), longest + 1};
    }

    /// All derived words, which never become shorter.
    Found derived(const ET0L& system, std::uint64_t longest) {
        WordSet seen;
        std::vector<const Word*> open;
        std::uint64_t bytes = 0;
        const auto add = [&](Word word) {
            const auto [place, is_new] = seen.insert(std::move(word));
            if (!is_new) return;
            bytes += bytes_of(*place) + 3 * sizeof(void*);
            budget_->check_memory(bytes_ + bytes, "the words up to that length");
            open.push_back(&*place);
        };
        if (system.axiom.size() <= longest) add(system.axiom);
        for (std::size_t i = 0; i < open.size(); ++i)
            for (const Table& table : system.tables) {
                const Word& word = *open[i];
                std::vector<Word> made{{}};
                for (std::size_t at = 0; at < word.size() && !made.empty(); ++at) {
                    const std::uint64_t room = longest - (word.size() - at - 1);
                    WordSet longer;
                    for (const Word& begun : made)
                        for (const Word& successor : table[word[at]]) {
                            if (begun.size() + successor.size() > room) continue;
                            Word next = begun;
                            next.insert(next.end(), successor.begin(), successor.end());
                            longer.insert(std::move(next));
                        }
                    budget_->check();
                    budget_->check_memory(
                        bytes_ + bytes +
                            longer.size() * (longest * sizeof(Symbol) + sizeof(Word) + 16),
                        "the words up to that length");
                    made.assign(std::make_move_iterator(longer.begin()),
                                std::make_move_iterator(longer.end()));
                }
                for (Word& next : made) add(std::move(next));
            }
        return {sorted({seen.begin(), seen.end()}), longest + 1};
    }

    /// What sequences of tables make of each letter, cut at a length: a process for `walk_of_tables`.
    class Derivations {
    public:
        using State = std::vector<std::vector<Word>>;  // by number of a letter; sorted

        Derivations(const ET0L& system, const Morphism* morphism, std::uint64_t longest,
                    const Budget& budget)
            : system_(&system),
              morphism_(morphism),
              longest_(longest),
              budget_(&budget),
              letters_(accessible_letters(system)),
              place_(system.alphabet->size(), 0) {
            for (std::size_t i = 0; i < letters_.size(); ++i) place_[letters_[i]] = i;
        }

        State first() const {
            State state(letters_.size());
            for (std::size_t i = 0; i < letters_.size(); ++i) {
                const Symbol a = letters_[i];
                if (!system_->terminal[a] || (morphism_ && !morphism_->maps(a))) continue;
                Word word = morphism_ ? (*morphism_)[a] : Word{a};
                if (word.size() <= longest_) state[i] = {std::move(word)};
            }
            return state;
        }
        State next(const State& state, std::size_t table) const {
            State made(letters_.size());
            for (std::size_t i = 0; i < letters_.size(); ++i) {
                for (const Word& successor : system_->tables[table][letters_[i]]) {
                    std::vector<Word> more = product(successor, state);
                    made[i].insert(made[i].end(), std::make_move_iterator(more.begin()),
                                   std::make_move_iterator(more.end()));
                }
                made[i] = sorted(std::move(made[i]));
            }
            return made;
        }
        bool stops(const State& state) {
            for (Word& word : product(system_->axiom, state)) {
                const std::uint64_t bytes = bytes_of(word);
                if (found_.insert(std::move(word)).second) bytes_ += bytes + 3 * sizeof(void*);
            }
            budget_->check_memory(bytes_, "the words up to that length");
            return false;
        }
        std::uint64_t bytes(const State& state) const {
            std::uint64_t all = 0;
            for (const auto& words : state)
                for (const Word& word : words) all += bytes_of(word);
            return all + state.size() * sizeof(std::vector<Word>);
        }
        std::size_t hash(const State& state) const {
            std::size_t all = state.size();
            for (const auto& words : state)
                for (const Word& word : words) all = all * 31 + Hash()(word);
            return all;
        }

        std::vector<Word> words() const { return sorted({found_.begin(), found_.end()}); }

    private:
        /// The words that the letters of the word derive together.
        std::vector<Word> product(const Word& word, const State& state) const {
            std::vector<Word> made{{}};
            std::uint64_t rest = 0;  // letters that those behind need at least
            for (const Symbol a : word) {
                const auto& of = state[place_[a]];
                if (of.empty()) return {};
                rest += of.front().size();
            }
            if (rest > longest_) return {};
            for (const Symbol a : word) {
                const auto& of = state[place_[a]];
                rest -= of.front().size();
                std::vector<Word> longer;
                std::uint64_t bytes = 0;
                for (const Word& begun : made) {
                    for (const Word& more : of) {
                        if (begun.size() + more.size() + rest > longest_) break;
                        longer.push_back(begun);
                        longer.back().insert(longer.back().end(), more.begin(), more.end());
                        bytes += bytes_of(longer.back());
                    }
                    budget_->check();
                    budget_->check_memory(bytes_ + bytes, "the words up to that length");
                }
                made = sorted(std::move(longer));
            }
            return made;
        }

        const ET0L* system_;
        const Morphism* morphism_;
        std::uint64_t longest_;
        const Budget* budget_;
        std::vector<Symbol> letters_;
        std::vector<std::size_t> place_;
        WordSet found_;
        std::uint64_t bytes_ = 0;
    };

    const Alphabet* alphabet_;
    Automata* automata_;
    const Budget* budget_;
    std::map<std::pair<const LanguageTree*, std::uint64_t>, Found> known_;
    std::uint64_t bytes_ = 0;
    std::string reason_;
};

/// What is found, and why not more where less than was wanted is decided.
struct Deepened {
    Found found;
    std::string stopped;
};

/// The words of at most `longest` letters, or of fewer where these are enough.
Deepened deepened(const Language& language, const Alphabet& alphabet, Automata& automata,
                  std::uint64_t longest, const std::function<bool(const Found&)>& enough,
                  const Budget& budget) {
    Budget little = budget;  // for what may be taken back
    little.memory = std::min<std::uint64_t>(little.memory, 256'000'000);
    longest = std::min(longest, std::uint64_t{1} << 40);
    Deepened best;
    std::uint64_t least = 0;  // the first length that is not decided
    bool is_dense = false;
    for (std::uint64_t next = std::min<std::uint64_t>(longest, 4);;) {
        const bool is_large = next > least;
        try {
            Bounded bounded(alphabet, automata, is_large ? little : budget);
            best.found = bounded.words(language, next);
            if (best.found.decided <= next) {
                best.stopped = bounded.reason();
                // Words that are found up to the end are worth having, although others may be missing.
                if (next < longest && !enough(best.found))
                    best.found = Bounded(alphabet, automata, little).words(language, longest);
                return best;
            }
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time || !is_large || !best.stopped.empty()) {
                if (best.stopped.empty()) best.stopped = bound.what();
                return best;
            }
            is_dense = true;
            next = least;
            continue;
        }
        if (next == longest || enough(best.found)) return best;
        least = next + 1;
        is_dense = is_dense || best.found.words.size() > 4 * least;
        next = std::min(longest, is_dense ? least : 2 * least);
    }
}

// --- Regular languages ---

/// The symbols below a number, by their names.
std::vector<Symbol> by_name(const Alphabet& alphabet, std::size_t count) {
    std::vector<Symbol> letters;
    for (Symbol a = 0; a < count; ++a) letters.push_back(a);
    std::sort(letters.begin(), letters.end(), [&](Symbol left, Symbol right) {
        return alphabet.name(left) < alphabet.name(right);
    });
    return letters;
}

void sort_by_name(std::vector<Word>& words, const Alphabet& alphabet) {
    std::vector<std::size_t> rank(alphabet.size());
    const std::vector<Symbol> letters = by_name(alphabet, alphabet.size());
    for (std::size_t i = 0; i < letters.size(); ++i) rank[letters[i]] = i;
    std::sort(words.begin(), words.end(), [&](const Word& left, const Word& right) {
        if (left.size() != right.size()) return left.size() < right.size();
        return std::lexicographical_compare(left.begin(), left.end(), right.begin(), right.end(),
                                            [&](Symbol a, Symbol b) { return rank[a] < rank[b]; });
    });
}

WordList list_regular(const RegularLanguage& language, const Alphabet& alphabet,
                      const ListLimits& limits, const Budget& budget) {
    const Dfa& automaton = language.automaton();
    const std::vector<Symbol> letters = by_name(alphabet, automaton.letters);
    const std::optional<Integer> count = number_of_words(language);
    WordList list;
    const auto is_whole = [&] { return count && *count == Integer(list.words.size()); };
    // By number of letters: which states accept such a word.
    std::vector<std::vector<char>> accepts;
    std::uint64_t bytes = 0;
    try {
        for (std::uint64_t length = 0; length <= limits.length; ++length) {
            if (length == 0) {
                accepts.push_back(automaton.accepting);
            } else {
                std::vector<char> next(automaton.states(), 0);
                for (std::size_t s = 0; s < automaton.states(); ++s)
                    for (Symbol a = 0; a < automaton.letters && !next[s]; ++a)
                        next[s] = accepts.back()[automaton.step(s, a)];
                accepts.push_back(std::move(next));
            }
            bytes += automaton.states() + sizeof(accepts[0]);
            budget.check();
            budget.check_memory(bytes, "the words of that length");
            // Depth first: the states on the way, and which letter was taken at each.
            std::vector<std::size_t> way{automaton.initial}, taken;
            if (!accepts[at(length)][automaton.initial]) way.clear();
            std::size_t next = 0;  // letter to be tried
            while (!way.empty() && list.words.size() < limits.words) {
                const std::size_t left = at(length - taken.size());
                if (left == 0) {
                    Word word;
                    for (const std::size_t i : taken) word.push_back(letters[i]);
                    bytes += bytes_of(word);
                    budget.check();
                    budget.check_memory(bytes, "the words of that length");
                    list.words.push_back(std::move(word));
                    next = letters.size();
                }
                while (next < letters.size() &&
                       !accepts[left - 1][automaton.step(way.back(), letters[next])])
                    ++next;
                if (next < letters.size()) {
                    way.push_back(automaton.step(way.back(), letters[next]));
                    taken.push_back(next);
                    next = 0;
                    continue;
                }
                way.pop_back();
                if (taken.empty()) break;
                next = taken.back() + 1;
                taken.pop_back();
            }
            list.decided = length + 1;
            list.full = list.words.size() == limits.words;
            list.whole = is_whole();
            if (list.full || list.whole) return list;
        }
    } catch (const BoundReached& bound) {
        list.stopped = bound.what();
    }
    list.whole = is_whole();
    return list;
}

/// By the number of letters k and the state: how many words of k letters it accepts.
std::vector<Integer> one_letter_more(const Dfa& automaton, const std::vector<Integer>& counts) {
    std::vector<Integer> longer(automaton.states(), Integer(0));
    for (std::size_t s = 0; s < automaton.states(); ++s)
        for (Symbol a = 0; a < automaton.letters; ++a) longer[s] += counts[automaton.step(s, a)];
    return longer;
}

std::vector<Integer> accepting_counts(const Dfa& automaton) {
    std::vector<Integer> counts;
    for (const char accepting : automaton.accepting) counts.emplace_back(accepting ? 1 : 0);
    return counts;
}

/// The generating function of the numbers of words by length.
GeneratingFunction counting_function(const Dfa& automaton, const Budget& budget) {
    const std::vector<std::size_t> distance = distances(automaton);
    std::vector<std::size_t> number(automaton.states(), automaton.states());
    std::size_t useful = 0;
    for (std::size_t s = 0; s < automaton.states(); ++s)
        if (distance[s] < automaton.states()) number[s] = useful++;
    if (useful == 0) return {Polynomial(), Polynomial(1)};
    GrowthMatrix matrix;
    std::vector<Integer> row, column;
    for (std::size_t s = 0; s < automaton.states(); ++s) {
        if (number[s] == automaton.states()) continue;
        std::map<std::size_t, Integer> entries;
        for (Symbol a = 0; a < automaton.letters; ++a)
            if (const std::size_t to = number[automaton.step(s, a)]; to < automaton.states())
                entries[to] += 1;
        auto& of = matrix.rows.emplace_back();
        for (const auto& [to, times] : entries) of.push_back({to, times});
        row.emplace_back(s == automaton.initial ? 1 : 0);
        column.emplace_back(automaton.accepting[s] ? 1 : 0);
    }
    return generating_function(shortest_recurrence(row, matrix, column, budget));
}

// --- Chance ---

/// A number below a positive one, all equally likely.
Integer below(const Integer& bound, std::mt19937_64& generator) {
    const Integer word = power(Integer(2), 64);
    Integer range = 1;
    std::size_t words = 0;
    for (; range < bound; range = range * word) ++words;
    const Integer fair = bound * floor_divide(range, bound);
    while (true) {
        Integer drawn = 0;
        for (std::size_t i = 0; i < words; ++i) drawn = drawn * word + Integer(generator());
        if (drawn < fair) return remainder(drawn, bound);
    }
}

}  // namespace

WordList list_words(const Language& language, const Alphabet& alphabet, const ListLimits& limits,
                    const Budget& budget) {
    Automata automata(alphabet, budget);
    if (const RegularLanguage* const regular = automata.of(language))
        return list_regular(*regular, alphabet, limits, budget);
    WordList list;
    const auto take = [&](std::vector<Word> words) {
        sort_by_name(words, alphabet);
        list.full = words.size() >= limits.words;
        if (words.size() > limits.words) words.resize(at(limits.words));
        list.words = std::move(words);
    };
    const auto decided_words = [](const Found& found) {
        return static_cast<std::uint64_t>(
            std::lower_bound(
                found.words.begin(), found.words.end(), found.decided,
                [](const Word& word, std::uint64_t length) { return word.size() < length; }) -
            found.words.begin());
    };
    Deepened known = deepened(
        language, alphabet, automata, limits.length,
        [&](const Found& found) { return decided_words(found) >= limits.words; }, budget);
    const std::uint64_t decided = decided_words(known.found);
    list.decided = known.found.decided;
    list.stopped = std::move(known.stopped);
    take(std::move(known.found.words));
    if (decided >= limits.words) list.stopped.clear();
    return list;
}

WordCounts count_words(const Language& language, const Alphabet& alphabet, std::uint64_t longest,
                       const Budget& budget) {
    WordCounts found;
    Automata automata(alphabet, budget);
    if (const RegularLanguage* const regular = automata.of(language)) {
        const Dfa& automaton = regular->automaton();
        try {
            std::vector<Integer> counts = accepting_counts(automaton);
            Integer all = 0;
            std::uint64_t bytes = 0;
            for (std::uint64_t length = 0; length <= longest; ++length) {
                budget.check();
                budget.check_memory(bytes += sizeof(Integer) + length / 2,
                                    "the numbers of words of each length");
                if (length > 0) counts = one_letter_more(automaton, counts);
                found.counts.push_back(counts[automaton.initial]);
                all += found.counts.back();
            }
            const auto number = number_of_words(*regular);
            found.whole = number && *number == all;
            found.function =
                std::make_shared<const GeneratingFunction>(counting_function(automaton, budget));
        } catch (const BoundReached& bound) {
            found.stopped = bound.what();
        }
        return found;
    }
    Deepened known = deepened(
        language, alphabet, automata, longest, [](const Found&) { return false; }, budget);
    budget.check_memory(known.found.decided * sizeof(Integer),
                        "the numbers of words of each length");
    found.counts.assign(at(std::min(known.found.decided, longest + 1)), Integer(0));
    for (const Word& word : known.found.words)
        if (word.size() < found.counts.size()) found.counts[word.size()] += 1;
    found.stopped = std::move(known.stopped);
    return found;
}

std::vector<Word> draw_words(const Language& language, const Alphabet& alphabet,
                             std::uint64_t length, std::uint64_t count, std::uint64_t seed,
                             const Budget& budget) {
    std::mt19937_64 generator(seed);
    std::vector<Word> drawn;
    Automata automata(alphabet, budget);
    if (const RegularLanguage* const regular = automata.of(language)) {
        const Dfa& automaton = regular->automaton();
        const std::vector<Symbol> letters = by_name(alphabet, automaton.letters);
        std::vector<std::vector<Integer>> counts{accepting_counts(automaton)};
        std::uint64_t bytes = 0;
        while (counts.size() <= length) {
            counts.push_back(one_letter_more(automaton, counts.back()));
            // At most so many bits for each letter of the words.
            const std::uint64_t bits = std::bit_width(automaton.letters);
            bytes += automaton.states() * (sizeof(Integer) + counts.size() * bits / 8 + 16);
            budget.check();
            budget.check_memory(bytes, "the numbers of words of each length");
        }
        if (counts[at(length)][automaton.initial] == 0) return drawn;
        while (drawn.size() < count) {
            budget.check();
            Word word;
            std::size_t state = automaton.initial;
            Integer place = below(counts[at(length)][state], generator);
            for (std::uint64_t left = length; left > 0; --left)
                for (const Symbol a : letters) {
                    const Integer& here = counts[at(left - 1)][automaton.step(state, a)];
                    if (place < here) {
                        word.push_back(a);
                        state = automaton.step(state, a);
                        break;
                    }
                    place -= here;
                }
            drawn.push_back(std::move(word));
        }
        return drawn;
    }
    Bounded bounded(alphabet, automata, budget);
    Found found = bounded.words(language, length);
    if (found.decided <= length)
        throw BoundReached(Bound::method,
                           "which words of " + std::to_string(length) +
                               " letters the language has is not decided: " + bounded.reason());
    std::erase_if(found.words, [&](const Word& word) { return word.size() != length; });
    sort_by_name(found.words, alphabet);
    const Integer number(found.words.size());
    if (found.words.empty()) return drawn;
    while (drawn.size() < count) {
        budget.check();
        drawn.push_back(
            found.words[static_cast<std::size_t>(below(number, generator).to_uint64())]);
    }
    return drawn;
}

}  // namespace algae
