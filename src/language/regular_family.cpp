#include <algorithm>
#include <deque>
#include <map>
#include <numeric>
#include <set>

#include "language/detail/judge.hpp"
#include "language/detail/lengths.hpp"
#include "language/detail/proof.hpp"
#include "language/detail/regular.hpp"

// Which families of L-systems an infinite regular language R is of: 0L, T0L and their propagating and deterministic forms.
//
// Classes. Two words that are not empty are of one class if they do the same to the states of the minimal automaton of R; the
// empty word is a class of its own. Whether a step takes R into R depends on the classes of the successors only: call a map from
// the letters of R to sets of classes closed if every choice of classes for the letters of a word of R makes words of R. The
// successors of a system for R, or those of one of its tables, make a closed map. There are finitely many classes, so the largest
// closed maps are found: begin with all classes for each letter; while a choice leaves R, one of its pairs of a letter and a class
// has to go, and each of them is a case (the method of finite_family.cpp, with classes in the place of words).
//
// That R is not of the family: the ancestors of a word are the words of R that derive it, itself among them. Two words of R that have no
// ancestor in common by any closed map are not derived from one axiom, so there is no system. 0L systems have one map only, so for them
// the two words may be others in each case. Words with infinitely many ancestors, which erasing may give, are not used.
//
// That R is of the family: the more successors, the more words, and a closed map never leaves R. So if there is an 0L system for R
// with successors of k letters at most, one has the words of k letters at most of the classes of a largest closed map as its successors.
// These systems are tried for k = 2, 3, ...; that all words of R are derived is shown by `regular_induction`. Then successors
// are left out as long as that can be shown. D0L systems have one successor a letter: all short ones are tried.
//
// Three arguments for deterministic systems. The lengths of an infinite D0L language grow at least linearly with the generation, so
// it has at most c N words of N letters and fewer; a regular language in whose automaton two cycles follow each other, or share
// a state, has more (Paun and Salomaa 1995: it is not slender). If it is regular they grow linearly (`sparse`), so the letters whose
// descendants grow stand in every word, and a bounded number of them: so they are on no cycle of the automaton, and no word has letters
// on cycles only. And if the numbers of letters in all words are multiples k v of one vector, each deterministic
// table multiplies k by a fixed number, so every k is a product of numbers from a finite set; but the k of an infinite regular language
// have an arithmetic progression among them, in which infinitely many primes divide numbers.

namespace algae {

namespace {

/// A set of classes, by bits.
using Classes = std::uint64_t;
/// By place in the letters of the language.
using Map = std::vector<Classes>;

constexpr std::size_t most_classes = 64;
constexpr std::size_t most_cases = 3'000;  // of the search for closed maps
constexpr std::size_t words_looked_at =
    60;  // of the language, for two that have no ancestor in common
constexpr std::size_t words_looked_at_before = 8;  // where a map is not closed
constexpr std::size_t longest_looked_at = 12;      // letters of these
constexpr std::size_t most_ancestors = 100;
constexpr std::size_t longest_made = 63;     // letters of a word whose ancestors are looked for
constexpr std::size_t most_places = 2'000;   // on the way to it
constexpr std::size_t most_successors = 32;  // of one letter, that are tried at once
constexpr std::size_t longest_successor = 12;
constexpr std::size_t instance_cases = 12;  // where one instance of many is looked at
constexpr std::size_t instance_classes = 12;
constexpr std::size_t instance_successor = 3;  // there too
constexpr std::size_t most_choices = 400;      // of successors of deterministic systems
constexpr std::size_t most_tables = 24;
constexpr std::size_t axioms_tried = 40;
constexpr std::size_t longest_axiom = 8;

/// Whether an accepting state can be reached from each state.
std::vector<char> useful_states(const Dfa& automaton) {
    std::vector<char> useful;
    for (const std::size_t each : distances(automaton)) useful.push_back(each < automaton.states());
    return useful;
}

/// The letters of the words, increasing: the minimal automaton has no others, but numbers between them may stand for other symbols.
std::vector<Symbol> letters_of_words(const Dfa& automaton, const std::vector<char>& useful) {
    std::vector<Symbol> letters;
    for (Symbol a = 0; a < automaton.letters; ++a)
        for (std::size_t s = 0; s < automaton.states(); ++s)
            if (useful[s] && useful[automaton.step(s, a)]) {
                letters.push_back(a);
                break;
            }
    return letters;
}

/// The classes of words, and what the letters of words may become.
class ClassSearch {
public:
    /// Throws BoundReached if there are more than 64 classes.
    ClassSearch(const RegularLanguage& language, bool propagating, const Budget& budget)
        : automaton_(language.automaton()),
          budget_(budget),
          useful_(useful_states(automaton_)),
          letters_(letters_of_words(automaton_, useful_)) {
        make_classes();
        const Classes all =
            classes_.size() == most_classes ? ~Classes{0} : (Classes{1} << classes_.size()) - 1;
        whole_.assign(letters_.size(), propagating ? all & ~Classes{1} : all);
        for (std::size_t length = 0; length <= longest_looked_at; ++length) {
            words_ = words_up_to(language, length, budget);
            if (words_.size() >= words_looked_at) break;
        }
        if (words_.size() > 4 * words_looked_at) words_.resize(4 * words_looked_at);
    }

    const std::vector<Symbol>& letters() const { return letters_; }
    const std::vector<Word>& words() const { return words_; }
    const Map& whole() const { return whole_; }
    /// How many classes there are.
    std::size_t size() const { return classes_.size(); }
    const Word& representative(std::size_t number) const { return representatives_[number]; }
    std::vector<Word> representatives() const { return representatives_; }

    std::size_t class_of(const Word& word) const {
        if (word.empty()) return 0;
        Action action = identity();
        for (const Symbol a : word)
            for (std::size_t& s : action) s = automaton_.step(s, a);
        return numbers_.at(action);
    }

    /// A shortest choice of classes for the letters of a word of the language that leads out of it.
    struct Leaving {
        Word word;
        std::vector<std::size_t> classes;
    };
    std::optional<Leaving> leaving(const Map& map) const {
        budget_.check();
        // Where the word leads, and where what becomes of it does.
        using Pair = std::pair<std::size_t, std::size_t>;
        struct Came {
            Pair from;
            std::size_t letter, number;
        };
        std::map<Pair, Came> came;
        std::deque<Pair> open{{automaton_.initial, automaton_.initial}};
        came.emplace(open.front(), Came{open.front(), 0, 0});
        while (!open.empty()) {
            const Pair at = open.front();
            open.pop_front();
            if (automaton_.accepting[at.first] && !automaton_.accepting[at.second]) {
                Leaving found;
                for (Pair back = at; back != Pair{automaton_.initial, automaton_.initial};
                     back = came.at(back).from) {
                    found.word.push_back(letters_[came.at(back).letter]);
                    found.classes.push_back(came.at(back).number);
                }
                std::reverse(found.word.begin(), found.word.end());
                std::reverse(found.classes.begin(), found.classes.end());
                return found;
            }
            for (std::size_t i = 0; i < letters_.size(); ++i) {
                const std::size_t next = automaton_.step(at.first, letters_[i]);
                if (!useful_[next]) continue;
                for (std::size_t c = 0; c < classes_.size(); ++c) {
                    if (!(map[i] >> c & 1)) continue;
                    const Pair to{next, classes_[c][at.second]};
                    if (came.emplace(to, Came{at, i, c}).second) open.push_back(to);
                }
            }
        }
        return std::nullopt;
    }

    /// The words of the language of which some choice of classes makes the word, by one of the maps, in no order; nothing if there are
    /// too many, or no end to them.
    std::optional<std::vector<Word>> predecessors(const Word& word,
                                                  const std::vector<Map>& maps) const {
        if (word.size() >= longest_made) return std::nullopt;
        // Of which class the factor from i to j is.
        std::vector<std::vector<std::size_t>> factor(word.size() + 1);
        for (std::size_t i = 0; i <= word.size(); ++i) {
            factor[i].assign(word.size() + 1, 0);
            Action action = identity();
            for (std::size_t j = i; j < word.size(); ++j) {
                for (std::size_t& s : action) s = automaton_.step(s, word[j]);
                factor[i][j + 1] = numbers_.at(action);
            }
        }
        std::vector<Word> found;
        for (const Map& map : maps) {
            Making making{word.size(), {}, {}};
            making.ends.resize(letters_.size());
            for (std::size_t a = 0; a < letters_.size(); ++a)
                for (std::size_t i = 0; i <= word.size(); ++i) {
                    std::uint64_t ends = 0;
                    for (std::size_t j = i; j <= word.size(); ++j)
                        if (map[a] >> factor[i][j] & 1) ends |= std::uint64_t{1} << j;
                    making.ends[a].push_back(ends);
                }
            if (!spell_all(making, found)) return std::nullopt;
        }
        return found;
    }

    /// All words of the language that derive the word by the maps, itself among them; nothing as above.
    std::optional<std::set<Word>> ancestors(const Word& word, const std::vector<Map>& maps) const {
        std::set<Word> all{word};
        std::vector<Word> open{word};
        while (!open.empty()) {
            budget_.check();
            const auto before = predecessors(open.back(), maps);
            open.pop_back();
            if (!before) return std::nullopt;
            for (const Word& each : *before)
                if (all.insert(each).second) open.push_back(each);
            if (all.size() > most_ancestors) return std::nullopt;
        }
        return all;
    }

    /// Two of the first `count` words of the language that have no ancestor in common; none where there are no such.
    std::vector<Word> apart(const std::vector<Map>& maps, std::size_t count) const {
        std::vector<std::pair<Word, std::set<Word>>> known;
        for (std::size_t i = 0; i < std::min(count, words_.size()); ++i) {
            auto all = ancestors(words_[i], maps);
            if (!all) continue;
            for (const auto& one : known)
                if (std::none_of(all->begin(), all->end(),
                                 [&](const Word& each) { return one.second.contains(each); }))
                    return {one.first, words_[i]};
            known.emplace_back(words_[i], std::move(*all));
        }
        return {};
    }

    /// The words of at most so many letters of a set of classes; nothing if there are too many words of that length.
    std::optional<std::vector<Word>> words_of(Classes set, std::size_t longest) const {
        std::vector<Word> found, last{{}};
        if (set & 1) found.push_back({});
        for (std::size_t length = 1; length <= longest; ++length) {
            if (last.size() * letters_.size() > 4 * most_successors) return std::nullopt;
            std::vector<Word> next;
            for (const Word& word : last)
                for (const Symbol a : letters_) {
                    next.push_back(word);
                    next.back().push_back(a);
                    if (set >> class_of(next.back()) & 1) found.push_back(next.back());
                }
            last = std::move(next);
        }
        if (found.size() > most_successors) return std::nullopt;
        return found;
    }

private:
    using Action = std::vector<std::size_t>;

    Action identity() const {
        Action action(automaton_.states());
        std::iota(action.begin(), action.end(), 0);
        return action;
    }

    /// How words are spelled of which one word is made.
    struct Making {
        std::size_t length = 0;  // of the word that is made
        /// By place of a letter and how much of the word is made: how much can be with that letter, by bits.
        std::vector<std::vector<std::uint64_t>> ends;
        /// A state, and how much of the word may be made there.
        using Place = std::pair<std::size_t, std::uint64_t>;
        std::map<Place, std::vector<std::pair<std::size_t, Place>>> ways;  // by place of a letter
    };

    /// Adds the words that are spelled so; each goes one way. False if there are too many, or no end to them.
    bool spell_all(Making& making, std::vector<Word>& found) const {
        using Place = Making::Place;
        std::map<Place, std::vector<Place>> before;
        std::vector<Place> open{{automaton_.initial, 1}}, ends;
        making.ways[open.front()];
        while (!open.empty()) {
            const Place at = open.back();
            open.pop_back();
            if (automaton_.accepting[at.first] && (at.second >> making.length & 1))
                ends.push_back(at);
            for (std::size_t a = 0; a < letters_.size(); ++a) {
                Place to{automaton_.step(at.first, letters_[a]), 0};
                if (!useful_[to.first]) continue;
                for (std::size_t i = 0; i <= making.length; ++i)
                    if (at.second >> i & 1) to.second |= making.ends[a][i];
                if (to.second == 0) continue;
                making.ways[at].emplace_back(a, to);
                before[to].push_back(at);
                if (making.ways.try_emplace(to).second) open.push_back(to);
                if (making.ways.size() > most_places) return false;
            }
        }
        std::set<Place> useful;
        open = ends;
        while (!open.empty()) {
            const Place at = open.back();
            open.pop_back();
            if (!useful.insert(at).second) continue;
            open.insert(open.end(), before[at].begin(), before[at].end());
        }
        Word begun;
        std::set<Place> passed;
        return spell(making, {automaton_.initial, 1}, useful, begun, passed, found);
    }

    bool spell(const Making& making, const Making::Place& at, const std::set<Making::Place>& useful,
               Word& begun, std::set<Making::Place>& passed, std::vector<Word>& found) const {
        if (!useful.contains(at)) return true;
        if (!passed.insert(at).second) return false;  // a way round
        if (automaton_.accepting[at.first] && (at.second >> making.length & 1))
            found.push_back(begun);
        if (found.size() > most_ancestors) return false;
        for (const auto& [letter, to] : making.ways.at(at)) {
            begun.push_back(letters_[letter]);
            if (!spell(making, to, useful, begun, passed, found)) return false;
            begun.pop_back();
        }
        passed.erase(at);
        return true;
    }

    void make_classes() {
        classes_.push_back(identity());
        representatives_.push_back({});
        for (std::size_t i = 0; i < classes_.size(); ++i)
            for (const Symbol a : letters_) {
                Action action = classes_[i];
                for (std::size_t& s : action) s = automaton_.step(s, a);
                if (!numbers_.emplace(action, classes_.size()).second) continue;
                if (classes_.size() == most_classes)
                    throw BoundReached(Bound::method, "there are more than " +
                                                          std::to_string(most_classes) +
                                                          " classes of words");
                classes_.push_back(std::move(action));
                representatives_.push_back(representatives_[i]);
                representatives_.back().push_back(a);
            }
    }

    const Dfa& automaton_;
    const Budget& budget_;
    std::vector<char> useful_;
    std::vector<Symbol> letters_;
    std::vector<Action> classes_;  // number 0 is that of the empty word
    std::map<Action, std::size_t> numbers_;
    std::vector<Word> representatives_;
    Map whole_;
    std::vector<Word> words_;
};

/// The cases of the search for closed maps, and the closed maps.
class ClosedMaps {
public:
    ClosedMaps(const ClassSearch& search, bool tables, std::size_t most)
        : search_(search), tables_(tables), most_(most) {}

    /// The largest closed maps; of one table only those by which all words may have an ancestor in common. Nothing if there are too
    /// many cases.
    std::optional<std::vector<Map>> find() {
        visit(search_.whole());
        if (seen_.size() >= most_) return std::nullopt;
        std::vector<Map> largest;
        for (const Map& map : closed_)
            if (std::none_of(closed_.begin(), closed_.end(), [&](const Map& other) {
                    return map != other && is_within(map, other);
                }))
                largest.push_back(map);
        return largest;
    }

    /// The case of a map as a part of the proof that there is no system; of tables with `left`, the largest closed maps. Throws
    /// BoundReached if there are too many cases.
    steps::ByClasses::Case proof(const Map& map, const std::vector<Map>& left,
                                 std::size_t& size) const {
        if (++size > 4 * most_cases)
            throw BoundReached(Bound::method, "the proof has more than " +
                                                  std::to_string(4 * most_cases) + " cases");
        steps::ByClasses::Case found;
        for (std::size_t i = 0; i < map.size(); ++i)
            if (map[i] == 0) {
                found.letter = search_.letters()[i];
                return found;
            }
        if (tables_ && std::any_of(left.begin(), left.end(),
                                   [&](const Map& other) { return is_within(map, other); }))
            return found;
        const auto leaving = search_.leaving(map);
        if (!tables_) {
            found.apart = apart(map, !leaving);
            if (!found.apart.empty()) return found;
        }
        if (!leaving) throw Error("a closed map by which words have ancestors in common");
        found.word = leaving->word;
        for (const std::size_t number : leaving->classes)
            found.images.push_back(search_.representative(number));
        for (const Map& next : without(map, *leaving))
            found.cases.push_back(proof(next, left, size));
        return found;
    }

private:
    static bool is_within(const Map& map, const Map& other) {
        for (std::size_t i = 0; i < map.size(); ++i)
            if ((map[i] & ~other[i]) != 0) return false;
        return true;
    }

    std::vector<Word> apart(const Map& map, bool is_closed) const {
        return search_.apart({map}, is_closed ? words_looked_at : words_looked_at_before);
    }

    /// The map without one of the pairs of the choice each, in the order in which they first stand there.
    std::vector<Map> without(const Map& map, const ClassSearch::Leaving& leaving) const {
        std::vector<Map> all;
        std::set<std::pair<Symbol, std::size_t>> done;
        for (std::size_t i = 0; i < leaving.word.size(); ++i) {
            if (!done.emplace(leaving.word[i], leaving.classes[i]).second) continue;
            const auto letter =
                std::find(search_.letters().begin(), search_.letters().end(), leaving.word[i]);
            all.push_back(map);
            all.back()[static_cast<std::size_t>(letter - search_.letters().begin())] &=
                ~(Classes{1} << leaving.classes[i]);
        }
        return all;
    }

    void visit(const Map& map) {
        if (seen_.size() >= most_ || !seen_.insert(map).second) return;
        if (std::find(map.begin(), map.end(), Classes{0}) != map.end()) return;
        if (std::any_of(closed_.begin(), closed_.end(),
                        [&](const Map& other) { return is_within(map, other); }))
            return;
        const auto leaving = search_.leaving(map);
        if (!tables_ && !apart(map, !leaving).empty()) return;
        if (!leaving) {
            closed_.push_back(map);
            return;
        }
        for (const Map& next : without(map, *leaving)) visit(next);
    }

    const ClassSearch& search_;
    bool tables_;
    std::size_t most_;  // cases
    std::set<Map> seen_;
    std::vector<Map> closed_;
};

/// The cycles of an automaton through useful states.
class Cycles {
public:
    explicit Cycles(const Dfa& automaton)
        : automaton_(automaton), useful_(useful_states(automaton)) {
        // Every state of a minimal automaton is reachable.
        reaches_.assign(states(), std::vector<char>(states(), 0));
        for (std::size_t s = 0; s < states(); ++s) {
            if (!useful_[s]) continue;
            std::vector<std::size_t> open{s};
            while (!open.empty()) {
                const std::size_t at = open.back();
                open.pop_back();
                for (Symbol a = 0; a < automaton.letters; ++a) {
                    const std::size_t to = automaton.step(at, a);
                    if (!useful_[to] || reaches_[s][to]) continue;
                    reaches_[s][to] = 1;
                    open.push_back(to);
                }
            }
        }
    }

    /// Whether there are more than a bounded number of words of some lengths: two cycles share a state, or one leads to another.
    bool are_dense() const {
        for (std::size_t s = 0; s < states(); ++s) {
            if (!reaches_[s][s]) continue;
            std::size_t ways = 0;  // that come back
            for (Symbol a = 0; a < automaton_.letters; ++a) ways += is_on_cycle(s, a) ? 1 : 0;
            if (ways > 1) return true;
            for (std::size_t t = 0; t < states(); ++t)
                if (reaches_[s][t] && reaches_[t][t] && !reaches_[t][s]) return true;
        }
        return false;
    }

    /// The letters that stand any number of times in words.
    std::vector<Symbol> letters() const {
        std::vector<Symbol> found;
        for (Symbol a = 0; a < automaton_.letters; ++a)
            for (std::size_t s = 0; s < states(); ++s)
                if (is_on_cycle(s, a)) {
                    found.push_back(a);
                    break;
                }
        return found;
    }

private:
    std::size_t states() const { return automaton_.states(); }
    bool is_on_cycle(std::size_t s, Symbol a) const {
        const std::size_t to = automaton_.step(s, a);
        return useful_[to] && (to == s || reaches_[to][s]);
    }

    const Dfa& automaton_;
    std::vector<char> useful_;
    std::vector<std::vector<char>> reaches_;  // from one state to another, by a letter or more
};

/// Whether the numbers of letters in all words are multiples of one vector: |w|_a v_b = |w|_b v_a for all w and a, b.
bool is_proportional(const RegularLanguage& language) {
    const Dfa& automaton = language.automaton();
    const std::vector<char> useful = useful_states(automaton);
    const std::vector<Symbol> letters = letters_of_words(automaton, useful);
    Word sample;
    for (const Word& word : words_up_to(language, automaton.states())) sample = word;
    const auto count = [&](Symbol a) {
        return static_cast<std::int64_t>(std::count(sample.begin(), sample.end(), a));
    };
    for (const Symbol b : letters) {
        if (b == letters.front()) continue;
        // The value of |u|_a v_b - |u|_b v_a is to depend on the state that u leads to only, and to be 0 where words end.
        std::vector<std::optional<std::int64_t>> value(automaton.states());
        value[automaton.initial] = 0;
        std::vector<std::size_t> open{automaton.initial};
        while (!open.empty()) {
            const std::size_t s = open.back();
            open.pop_back();
            if (automaton.accepting[s] && *value[s] != 0) return false;
            for (const Symbol c : letters) {
                const std::size_t to = automaton.step(s, c);
                if (!useful[to]) continue;
                const std::int64_t next = *value[s] + (c == letters.front() ? count(b) : 0) -
                                          (c == b ? count(letters.front()) : 0);
                if (value[to] && *value[to] != next) return false;
                if (value[to]) continue;
                value[to] = next;
                open.push_back(to);
            }
        }
    }
    return true;
}

/// That no deterministic system has the language, if the cycles of its automaton or the numbers of letters show it.
std::optional<Answer> beyond_deterministic(const Language& language, const RegularLanguage& value,
                                           const std::string& family, bool tables,
                                           const Budget& budget) {
    if (!tables) {
        const Cycles cycles(value.automaton());
        if (cycles.are_dense()) return refuted(steps::Dense{language, family});
        if (const auto word =
                shortest_word(intersected(value, all_words(cycles.letters()), budget)))
            return refuted(steps::LettersOnCycles{language, family, *word});
    }
    if (is_proportional(value)) return refuted(steps::Proportional{language, family});
    return std::nullopt;
}

/// Languages over one letter: the lengths of their words are ultimately periodic sets S.
///
/// A step by a table takes a length x to all sums of x of its lengths, so a table K is closed if all sums of x of its numbers are in S
/// for all x in S. Let t be the tail of S and p its least period.
///
/// 1. Rules that erase: K with 0 is closed if and only if the sums of its numbers are in S, as S is infinite. So an 0L system with 0 in S
/// generates {m} and a set that is closed under sums, every such set has finitely many generators, and that is all there is to it: S or S without
/// one length is closed under sums. With tables all n whose multiples are in S come of any length, and no others by tables that erase.
///
/// 2. Other tables make no length of a longer one, so each length of S but the least (and those of 1.) is made of a shorter one. Let D be
/// the greatest common divisor of p and the differences of the numbers of K: they leave one rest k when divided by D. The sums of x
/// numbers, x long, leave all rests of x k + D Z when divided by p, so these are rests of S. This is asked for of each pair of D and k first;
/// then sums for x < t remain, whose classes (lengths below t, rests beyond) are finitely many.
///
/// 3. Without tables D = p: all rests of S are made of long lengths, so each with all that differ by D, and p is the least period. So x -> x k
/// takes the rests of S onto themselves.
///
/// 4. A finite table makes long lengths of long ones only. For a set of classes with a long one this depends on rests modulo D. For
/// a finite set it depends on rests modulo powers of the prime divisors of p: a length without other small prime divisors is
/// not made by a set whose numbers have such a divisor in common, and the others make all or none with these rests.
///
/// So S is T0L if and only if (a) all of its lengths but one, and but those of 1., are made of shorter ones by closed sets of classes, and
/// (b) all long ones by such sets of long ones. For (a) and (b), and for all lengths at once without tables, closed sets are looked for
/// by cases: if a sum is not in S, one of its numbers is not in K.
class OneLetterJudge {
public:
    OneLetterJudge(const Language& language, LengthSet set, const FamilyQuestion& question,
                   const SystemForm& form, const Alphabet& alphabet, const Budget& budget)
        : language_(language),
          set_(std::move(set)),
          question_(question),
          form_(form),
          alphabet_(alphabet),
          budget_(budget),
          size_(set_.has.size()) {
        least_ = 1;
        while (!set_.contains(least_)) ++least_;
        refutation_.language = language;
        refutation_.family = question.family;
        refutation_.period = set_.period;
    }

    Answer judge() {
        const bool erases = set_.contains(0) && !form_.propagating;
        if (form_.tables && !(set_.contains(0) && form_.propagating)) {
            // One table is the smaller system.
            SystemForm one = form_;
            one.tables = false;
            const Answer found =
                OneLetterJudge(language_, set_, question_, one, alphabet_, budget_).judge();
            if (found.truth == Truth::proved) return found;
        }
        if (set_.contains(0) && form_.propagating) {
            make_or_refute(0);
            make_or_refute(least_);
            return refuted(refutation_);
        }
        if (form_.tables) return with_tables(erases);
        return erases ? by_sums() : without_tables();
    }

private:
    /// Of the classes, those of the numbers that a table may have.
    using Set = std::vector<char>;
    using Case = steps::ByLengths::Case;
    using Rest = std::pair<std::size_t, std::size_t>;  // and the modulus
    struct Frame {
        std::size_t modulus = 0, rest = 0;
    };
    enum class Reaches { all, none, some };

    // --- Sets of classes ---

    Set whole(const Frame& frame) const {
        Set set(size_, 0);
        for (std::size_t n = 1; n < size_; ++n) set[n] = n % frame.modulus == frame.rest;
        return set;
    }
    bool is_endless(const Set& set) const {
        return std::find(set.begin() + static_cast<std::ptrdiff_t>(set_.tail), set.end(), 1) !=
               set.end();
    }
    LengthTable table_of(const Set& set) const {
        LengthTable table;
        for (std::size_t n = 1; n < size_; ++n)
            if (set[n]) (n < set_.tail ? table.lengths : table.endless).push_back(n);
        table.step = table.endless.empty() ? 0 : set_.period;
        return table;
    }
    /// Its numbers up to a bound.
    LengthTable table_of(const Set& set, std::size_t longest) const {
        LengthTable table;
        for (std::size_t n = 1; n <= longest; ++n)
            if (set[set_.class_of(n)]) table.lengths.push_back(n);
        return table;
    }
    static std::size_t least_of(const Set& set) {
        return static_cast<std::size_t>(std::find(set.begin(), set.end(), 1) - set.begin());
    }

    /// Whether rests of S, each multiplied by the rest of the frame, are rests of S with all that differ by the modulus.
    bool is_possible(const Frame& frame) const {
        for (std::size_t r = 0; r < set_.period; ++r)
            if (set_.contains_long(r))
                for (std::size_t i = 0; i < set_.period; i += frame.modulus)
                    if (!set_.contains_long(r * frame.rest + i)) return false;
        return true;
    }

    /// The possible frames that are not within others; without tables those with all rests.
    std::vector<Frame> frames() const {
        std::vector<Frame> found;
        for (std::size_t modulus = 1; modulus <= set_.period; ++modulus) {
            if (set_.period % modulus != 0 || (!form_.tables && modulus < set_.period)) continue;
            for (std::size_t rest = 0; rest < modulus; ++rest) {
                const Frame frame{modulus, rest};
                if (!is_possible(frame)) continue;
                if (!form_.tables && !is_onto(rest)) continue;
                if (std::none_of(found.begin(), found.end(), [&](const Frame& other) {
                        return modulus % other.modulus == 0 && rest % other.modulus == other.rest;
                    }))
                    found.push_back(frame);
            }
        }
        return found;
    }
    bool is_onto(std::size_t factor) const {
        std::set<std::size_t> before, after;
        for (std::size_t r = 0; r < set_.period; ++r)
            if (set_.contains_long(r)) {
                before.insert(r);
                after.insert(r * factor % set_.period);
            }
        return before == after;
    }

    /// Numbers of the set, as many as a length of S says, whose sum is not in S; none if the set is closed. Of a possible frame sums for
    /// long lengths are in S.
    std::vector<std::size_t> leaving(const Set& set) const {
        budget_.check();
        for (std::size_t x = 1; x < set_.tail; ++x)
            if (set_.contains(x))
                for (std::size_t n = 1; n < size_; ++n)
                    if (set[n] && !set_.contains(x * n)) return std::vector(x, n);
        std::vector<Numbers> sums(1, Numbers(size_ - 1));
        sums[0].set(0);
        for (std::size_t x = 1; x < set_.tail; ++x) {
            Numbers next(2 * size_), wide(2 * size_), classes(size_ - 1);
            for (std::size_t n = 0; n < size_; ++n)
                if (sums.back().at(n)) wide.set(n);
            for (std::size_t n = 1; n < size_; ++n)
                if (set[n]) next.add(wide, n);
            for (std::size_t n = 0; n < next.size(); ++n)
                if (next.at(n)) classes.set(set_.class_of(n));
            sums.push_back(std::move(classes));
            if (!set_.contains(x)) continue;
            for (std::size_t n = 0; n < size_; ++n)
                if (sums.back().at(n) && !set_.contains(n)) return summands(set, sums, n);
        }
        return {};
    }

    std::vector<std::size_t> summands(const Set& set, const std::vector<Numbers>& sums,
                                      std::size_t sum) const {
        std::vector<std::size_t> found;
        for (std::size_t x = sums.size() - 1; x > 0; --x) {
            const auto step = [&] {
                for (std::size_t n = 1; n < size_; ++n)
                    for (std::size_t before = 0; set[n] && before < size_; ++before)
                        if (sums[x - 1].at(before) && set_.class_of(before + n) == sum) {
                            found.push_back(n);
                            sum = before;
                            return;
                        }
            };
            step();
        }
        std::sort(found.begin(), found.end());
        return found;
    }

    // --- What finite tables make of long lengths ---

    bool divides_power(std::size_t number, std::size_t of) const {
        for (std::size_t shared = std::gcd(number, of); shared > 1; shared = std::gcd(number, of))
            number /= shared;
        return number == 1;
    }
    /// The greatest divisor of which all prime divisors divide the period.
    std::size_t periodic_part(std::size_t number) const {
        std::size_t rest = number;
        for (std::size_t shared = std::gcd(rest, set_.period); shared > 1;
             shared = std::gcd(rest, set_.period))
            rest /= shared;
        return number / rest;
    }

    /// The modulus on which it depends whether the set makes long lengths of long shorter ones; 0 if it does not make those without
    /// other small prime divisors than those of the period.
    std::size_t modulus_of(const Set& set) const {
        std::size_t shared = is_endless(set) ? set_.period : 0,
                    differences = is_endless(set) ? set_.period : 0;
        const std::size_t least = least_of(set);
        if (least == set.size()) return 0;
        for (std::size_t n = least; n < size_; ++n)
            if (set[n]) {
                shared = std::gcd(shared, n);
                differences = std::gcd(differences, n - least);
            }
        if (!divides_power(shared, set_.period)) return 0;
        if (differences == 0 && least == 1) return 0;  // it makes each length of itself only
        return differences == 0 ? least * set_.period : periodic_part(differences);
    }

    Reaches reaches(const Set& set, const Rest& rest) const {
        const std::size_t modulus = modulus_of(set);
        if (modulus == 0) return Reaches::none;
        const std::size_t k = least_of(set), known = std::gcd(rest.second, modulus);
        const bool one = !is_endless(set) && std::count(set.begin(), set.end(), 1) == 1;
        // A long x with x k = s modulo what the set and the rest have in common; of one number, modulo all.
        bool some = false;
        const std::size_t same = one ? rest.second : known, all = std::lcm(set_.period, same);
        if (one && rest.second % modulus == 0)
            some = rest.first % k == 0 && set_.contains_long(rest.first / k);
        else
            for (std::size_t x = 0; x < all && !some; ++x)
                some = set_.contains_long(x) && x * k % same == rest.first % same;
        if (!some) return Reaches::none;
        return rest.second % modulus == 0 ? Reaches::all : Reaches::some;
    }

    /// The next prime by which the modulus has to be multiplied to tell.
    static std::size_t prime_to_tell(std::size_t modulus, std::size_t known) {
        const std::size_t left = modulus / std::gcd(modulus, known);
        std::size_t prime = 2;
        while (left % prime != 0) ++prime;
        return prime;
    }

    /// A rest of long lengths that the set does not make of long ones.
    std::optional<Rest> unreached(const Set& set) const {
        std::vector<Rest> open;
        for (std::size_t r = 0; r < set_.period; ++r)
            if (set_.contains_long(r)) open.emplace_back(r, set_.period);
        while (!open.empty()) {
            budget_.check();
            const Rest rest = open.back();
            open.pop_back();
            const Reaches found = reaches(set, rest);
            if (found == Reaches::none) return rest;
            if (found == Reaches::all) continue;
            const std::size_t prime = prime_to_tell(modulus_of(set), rest.second);
            for (std::size_t i = 0; i < prime; ++i)
                open.emplace_back(rest.first + i * rest.second, rest.second * prime);
        }
        return std::nullopt;
    }

    // --- The search by cases ---

    /// Why no closed part of a set is enough: a length that it does not make of a shorter one, or a rest of long lengths that it does not
    /// make of long ones. Nothing if it may be enough.
    struct Goal {
        std::optional<std::size_t> length = {};
        std::optional<Rest> rest = {};

        bool is_all() const { return !length && !rest; }
    };
    std::optional<Goal> missing(const Set& set, const Goal& goal, bool is_closed) const {
        if (goal.length) {
            if (from_shorter(set_, table_of(set), *goal.length, 0, budget_).at(*goal.length))
                return std::nullopt;
            return goal;
        }
        if (goal.rest) {
            if (reaches(set, *goal.rest) != Reaches::none) return std::nullopt;
            return goal;
        }
        const std::size_t longest = size_ + size_ * std::min(least_of(set), size_);
        const Numbers made = from_shorter(set_, table_of(set), longest, 0, budget_);
        for (std::size_t s = least_ + 1; s <= longest; ++s)
            if (set_.contains(s) && !made.at(s)) return Goal{s, {}};
        if (!is_closed || is_endless(set)) return std::nullopt;
        if (const auto rest = unreached(set)) return Goal{{}, rest};
        // The set is the table.
        for (std::size_t most = 1;; most += size_) {
            const auto found =
                length_induction(set_, {table_of(set)}, most, longest_looked_at, budget_);
            if (!found && most < longest_looked_at) continue;
            if (!found) throw too_long();
            for (const std::size_t s : found->base)
                if (s > least_) return Goal{s, {}};
            return std::nullopt;
        }
    }

    /// A closed part of the set that is enough for the goal and has the numbers `kept`; if there is none, the cases that show it.
    std::optional<Set> closed_part(const Set& set, const Set& kept, const Goal& goal, Case& found) {
        if (++refutation_.size > most_cases)
            throw BoundReached(Bound::method, "the lengths of tables make more than " +
                                                  std::to_string(most_cases) + " cases");
        const auto end_with = [&](const Goal& missed) {
            found.length = missed.length;
            found.rest = missed.rest;
        };
        if (const auto missed = missing(set, goal, false)) {
            end_with(*missed);
            return std::nullopt;
        }
        found.sum = leaving(set);
        if (found.sum.empty()) {
            const auto missed = goal.is_all() ? missing(set, goal, true) : std::nullopt;
            if (!missed) return set;
            end_with(*missed);
            return std::nullopt;
        }
        Set keeping = kept;
        for (std::size_t i = 0; i < found.sum.size(); ++i) {
            const std::size_t n = found.sum[i];
            if (keeping[n]) continue;
            Set without = set;
            without[n] = 0;
            found.cases.emplace_back();
            if (auto part = closed_part(without, keeping, goal, found.cases.back())) return part;
            keeping[n] = 1;
        }
        return std::nullopt;
    }

    /// A closed set of classes that is enough for the goal; if there is none, the cases are added to the refutation.
    std::optional<Set> closed_set(const Goal& goal) {
        steps::ByLengths::Target target{goal.length, goal.rest, {}};
        for (const Frame& frame : frames()) {
            target.frames.push_back({frame.modulus, frame.rest, {}});
            if (auto found =
                    closed_part(whole(frame), Set(size_, 0), goal, target.frames.back().root)) {
                for (std::size_t n = 1; form_.tables && n < size_; ++n) {
                    if ((*found)[n] || n % frame.modulus != frame.rest) continue;
                    (*found)[n] = 1;
                    if (!leaving(*found).empty()) (*found)[n] = 0;
                }
                return found;
            }
        }
        refutation_.targets.push_back(std::move(target));
        return std::nullopt;
    }

    // --- The three kinds of systems ---

    /// One table that erases: {m} and a set that is closed under sums.
    Answer by_sums() {
        const auto leaving_sum = [&](std::size_t axiom) -> std::optional<Rest> {
            const auto in = [&](std::size_t n) { return n != axiom && set_.contains(n); };
            // Longer ones make no other sums.
            const std::size_t longest = size_ + set_.period + axiom;
            for (std::size_t u = 1; u <= longest; ++u)
                for (std::size_t v = 1; v <= u && in(u); ++v)
                    if (in(v) && !in(u + v)) return Rest{v, u};
            return std::nullopt;
        };
        const auto all = leaving_sum(0);
        if (!all) return by_generators(0);
        refutation_.sums.push_back(*all);
        for (const std::size_t axiom : {all->first, all->second}) {
            const auto found = leaving_sum(axiom);
            if (!found) return by_generators(axiom);
            refutation_.sums.push_back(*found);
        }
        return refuted(refutation_);
    }

    Answer by_generators(std::size_t other) {
        const auto in = [&](std::size_t n) { return n > 0 && n != other && set_.contains(n); };
        LengthTable table{{0}, {}, 0};
        std::size_t least = 1;
        while (!in(least)) ++least;
        for (std::size_t n = 1; n <= size_ + other + set_.period * least; ++n) {
            bool is_sum = false;
            for (std::size_t u = 1; u <= n / 2 && !is_sum; ++u) is_sum = in(u) && in(n - u);
            if (in(n) && !is_sum) table.lengths.push_back(n);
        }
        if (table.lengths.back() == 1) table.lengths.push_back(2);
        return generated({table}, other == 0 ? least : other);
    }

    /// One table that does not erase.
    Answer without_tables() {
        const auto set = closed_set({});
        if (!set) return refuted(refutation_);
        return generated_by_sets({*set}, {}, least_);
    }

    bool is_multiplied(std::size_t length) const {
        for (std::size_t i = 1; i <= set_.tail + set_.period; ++i)
            if (!set_.contains(i * length)) return false;
        return true;
    }

    /// Of each length whose multiples are in S, all lengths that such a table makes; and the table that makes 0 only.
    std::vector<LengthTable> erasing_tables() const {
        std::vector<LengthTable> found{{{0}, {}, 0}};
        for (std::size_t n = 1; n < set_.tail; ++n)
            if (is_multiplied(n)) found.push_back({{0, n}, {}, 0});
        for (std::size_t d = 1; d <= set_.period; ++d) {
            const std::size_t first = (std::max<std::size_t>(set_.tail, 1) + d - 1) / d * d;
            bool is_in = set_.period % d == 0;
            for (std::size_t n = first; n < first + set_.period && is_in; n += d)
                is_in = set_.contains(n);
            if (!is_in) continue;
            found.push_back({{0}, {}, 0});
            for (std::size_t n = first; n < 2 * first; n += d) found.back().lengths.push_back(n);
        }
        return found;
    }

    /// Whether some table makes the length of a shorter one.
    bool is_made(std::size_t length) const {
        return std::any_of(sets_.begin(), sets_.end(), [&](const Set& set) {
            return from_shorter(set_, table_of(set), length, 0, budget_).at(length);
        });
    }
    bool make_or_refute(std::size_t length) {
        auto set = closed_set({length, {}});
        if (!set) return false;
        sets_.push_back(std::move(*set));
        return true;
    }

    /// Whether closed sets make the long lengths with that rest of long ones. If not, the rest of the last target is one of which no such length is made.
    bool make_or_refute(const Rest& rest) {
        std::optional<std::size_t> modulus;
        for (const Set& set : sets_) {
            const Reaches found = reaches(set, rest);
            if (found == Reaches::all) return true;
            if (found == Reaches::some) modulus = modulus_of(set);
        }
        if (!modulus) {
            auto set = closed_set({{}, rest});
            if (!set) return false;
            sets_.push_back(std::move(*set));
            return make_or_refute(rest);
        }
        const std::size_t prime = prime_to_tell(*modulus, rest.second);
        for (std::size_t i = 0; i < prime; ++i)
            if (!make_or_refute(Rest{rest.first + i * rest.second, rest.second * prime}))
                return false;
        return true;
    }

    Answer with_tables(bool erases) {
        std::vector<std::size_t> alone;  // not made of shorter ones
        const auto is_free = [&](std::size_t n) { return erases && is_multiplied(n); };
        const auto must_be_made = [&](std::size_t s) {
            if (!set_.contains(s) || is_free(s) || is_made(s) ||
                std::find(alone.begin(), alone.end(), s) != alone.end() || make_or_refute(s))
                return true;
            alone.push_back(s);
            return alone.size() < 2;
        };
        for (std::size_t s = 1; s <= 2 * size_; ++s)
            if (!must_be_made(s)) return refuted(refutation_);
        for (std::size_t r = 0; r < set_.period; ++r) {
            if (!set_.contains_long(r) || is_free(r + set_.tail * set_.period)) continue;
            if (make_or_refute(Rest{r, set_.period})) continue;
            refutation_.targets.erase(refutation_.targets.begin(), refutation_.targets.end() - 1);
            return refuted(refutation_);
        }
        // Now all long lengths are made, from some length on.
        std::vector<LengthTable> erasing;
        if (erases) erasing = erasing_tables();
        for (std::size_t longest = size_ + set_.period; longest <= longest_looked_at;) {
            std::vector<LengthTable> tables = erasing;
            for (const Set& set : sets_) tables.push_back(table_of(set, longest));
            const auto found =
                length_induction(set_, tables, 4 * size_ + 16, longest_looked_at, budget_);
            bool is_longer = !found;
            const std::size_t before = sets_.size();
            for (const std::size_t s : found ? found->base : std::vector<std::size_t>{}) {
                if (s == 0 || is_free(s) || (!alone.empty() && s == alone.front())) continue;
                is_longer = is_longer || is_made(s);
                if (!must_be_made(s)) return refuted(refutation_);
            }
            if (is_longer) {
                longest *= 2;
            } else if (sets_.size() == before) {
                return generated_by_sets(sets_, erasing, alone.empty() ? least_ : alone.front());
            }
        }
        throw too_long();
    }

    static BoundReached too_long() {
        return BoundReached(Bound::method,
                            "lengths are looked at up to " + std::to_string(longest_looked_at));
    }

    // --- Systems ---

    Answer generated_by_sets(const std::vector<Set>& sets, const std::vector<LengthTable>& erasing,
                             std::size_t axiom) {
        for (std::size_t longest = size_ + set_.period; longest <= longest_looked_at;
             longest *= 2) {
            std::vector<LengthTable> tables = erasing;
            for (const Set& set : sets) tables.push_back(table_of(set, longest));
            if (generates(tables, axiom, longest_looked_at))
                return generated(std::move(tables), axiom);
        }
        throw too_long();
    }

    bool generates(const std::vector<LengthTable>& tables, std::size_t axiom, std::size_t limit) {
        const auto found = length_induction(set_, tables, most_in_base, limit, budget_);
        if (!found) return false;
        from_ = found->from;
        std::set<std::size_t> missed(found->base.begin(), found->base.end());
        missed.erase(axiom);
        if (missed.empty()) return true;
        // What comes of longer ones comes by erasing, so of the first ones.
        const std::size_t longest = std::max(*missed.rbegin(), axiom) + size_;
        std::set<std::size_t> reached{axiom};
        std::vector<std::size_t> open{axiom};
        while (!open.empty() && !missed.empty()) {
            const std::size_t x = open.back();
            open.pop_back();
            missed.erase(x);
            for (const LengthTable& table : tables) {
                Numbers sums(longest);
                sums.set(0);
                for (std::size_t i = 0; i < x; ++i) {
                    Numbers next(longest);
                    for (const std::size_t k : table.lengths)
                        if (k <= longest) next.add(sums, k);
                    sums = std::move(next);
                }
                for (std::size_t s = 0; s <= longest; ++s)
                    if (sums.at(s) && reached.insert(s).second) open.push_back(s);
            }
        }
        return missed.empty();
    }

    Answer generated(std::vector<LengthTable> tables, std::size_t axiom) {
        if (!generates(tables, axiom, longest_looked_at)) throw too_long();
        const std::size_t limit = 4 * from_ + 200;
        const auto shorter = [&](std::size_t longest) {
            std::vector<LengthTable> some;
            for (const LengthTable& table : tables) {
                some.push_back(table);
                std::erase_if(some.back().lengths, [&](std::size_t k) { return k > longest; });
                if (some.back().lengths.empty()) some.pop_back();
            }
            return some;
        };
        std::size_t low = 0, high = 0;
        for (const LengthTable& table : tables) high = std::max(high, table.lengths.back());
        while (high - low > 1) {
            const std::size_t middle = low + (high - low) / 2;
            (generates(shorter(middle), axiom, limit) ? high : low) = middle;
        }
        tables = shorter(high);
        for (std::size_t t = tables.size(); question_.small && t-- > 0;) {
            std::vector<LengthTable> some = tables;
            some.erase(some.begin() + static_cast<std::ptrdiff_t>(t));
            if (!some.empty() && generates(some, axiom, limit)) tables = std::move(some);
        }
        for (std::size_t t = 0; question_.small && t < tables.size(); ++t)
            for (std::size_t i = tables[t].lengths.size(); i-- > 0;) {
                std::vector<LengthTable> some = tables;
                some[t].lengths.erase(some[t].lengths.begin() + static_cast<std::ptrdiff_t>(i));
                if (!some[t].lengths.empty() && generates(some, axiom, limit))
                    tables = std::move(some);
            }
        return by_system(tables, axiom);
    }

    Answer by_system(const std::vector<LengthTable>& tables, std::size_t axiom) const {
        ET0L system{std::make_shared<const Alphabet>(alphabet_),
                    Word(axiom, set_.letter),
                    {},
                    std::vector<char>(alphabet_.size(), 1),
                    {},
                    {}};
        for (const LengthTable& table : tables) {
            Table& rules = system.tables.emplace_back(alphabet_.size());
            for (Symbol a = 0; a < rules.size(); ++a) rules[a] = {{a}};
            rules[set_.letter].clear();
            for (const std::size_t length : table.lengths)
                rules[set_.letter].push_back(Word(length, set_.letter));
            system.table_names.push_back(std::to_string(system.tables.size()));
        }
        const auto shared = std::make_shared<const SourceSystem>(
            SourceSystem{"G", std::move(system), std::nullopt, {}, {}});
        const Answer equal =
            judge_equality(generated_language(shared), language_, alphabet_, budget_);
        if (equal.truth != Truth::proved)
            return undecided("a system was found, but not that it generates the language");
        return proved(steps::GeneratedBy{shared, question_.family, language_, equal.proof, true});
    }

    static constexpr std::size_t most_cases = 100'000, longest_looked_at = 20'000,
                                 most_in_base = 16;

    const Language& language_;
    LengthSet set_;
    const FamilyQuestion& question_;
    SystemForm form_;
    const Alphabet& alphabet_;
    const Budget& budget_;
    std::size_t size_;   // of the classes
    std::size_t least_;  // length that is not 0
    std::size_t from_ = 0;
    std::vector<Set> sets_;  // closed
    steps::ByLengths refutation_;
};

class RegularFamilyJudge {
public:
    RegularFamilyJudge(const Language& language, const RegularLanguage& value,
                       const FamilyQuestion& question, const SystemForm& form,
                       const Alphabet& alphabet, const Budget& budget)
        : language_(language),
          value_(value),
          question_(question),
          form_(form),
          alphabet_(alphabet),
          budget_(budget),
          search_(value, form.propagating, budget),
          marked_(marked_once(value, budget)) {}

    Answer judge() {
        const std::string name = to_string(language_, alphabet_);
        if (!question_.small && search_.size() > instance_classes)
            return undecided("the words of " + name + " are of more than " +
                             std::to_string(instance_classes) + " classes");
        ClosedMaps closed(search_, form_.tables, limit(most_cases, instance_cases));
        const auto maps = closed.find();
        if (maps) {
            if (auto found = refutation(closed, *maps)) return *found;
            if (auto found =
                    form_.deterministic ? by_single_successors(*maps) : by_successors(*maps))
                return *found;
        }
        if (question_.small)
            if (auto found = by_narrower_family()) return *found;
        if (!maps)
            return undecided("the successors of systems for " + name + " make more than " +
                             std::to_string(limit(most_cases, instance_cases)) + " cases");
        return undecided("no " + question_.family + " system for " + name +
                         " was found among those with successors of at most " +
                         std::to_string(tried_) + (tried_ == 1 ? " letter" : " letters") +
                         ", and the classes of its words do not show that there is none");
    }

private:
    std::optional<Answer> refutation(const ClosedMaps& closed, const std::vector<Map>& maps) const {
        steps::ByClasses found{language_, question_.family, search_.representatives(), {}, {}, 0};
        if (form_.tables) {
            found.apart = search_.apart(maps, words_looked_at);
            if (found.apart.empty()) return std::nullopt;
        } else if (!maps.empty()) {
            return std::nullopt;
        }
        found.root = closed.proof(search_.whole(), maps, found.size);
        return refuted(std::move(found));
    }

    std::size_t limit(std::size_t usual, std::size_t of_instance) const {
        return question_.small ? usual : of_instance;
    }

    /// A system without tables, or one that does not erase, is of the family too.
    std::optional<Answer> by_narrower_family() const {
        for (const char letter : {'T', 'P'}) {
            FamilyQuestion question = question_;
            const auto place = question.family.find('T');
            if (letter == 'T' && form_.tables) {
                question.family.erase(place, 1);
            } else if (letter == 'P' && !form_.propagating) {
                question.family.insert(question.family.begin(), 'P');
            } else {
                continue;
            }
            const Answer found =
                judge_regular_family(language_, value_, question, alphabet_, budget_);
            if (found.truth != Truth::proved) continue;
            auto generated = std::get<steps::GeneratedBy>(found.proof->step);
            generated.family = question_.family;
            return proved(std::move(generated));
        }
        return std::nullopt;
    }

    /// The tables make a system that generates the language, with the first axiom by which all words are derived.
    std::optional<SourceSystem> system_of(const std::vector<Table>& tables) const {
        const auto induction = regular_induction(value_, marked_, tables, 30, budget_);
        if (!induction) return std::nullopt;
        ET0L system{std::make_shared<const Alphabet>(alphabet_), {}, tables,
                    std::vector<char>(alphabet_.size(), 1),      {}, {}};
        for (std::size_t t = 0; t < tables.size(); ++t)
            system.table_names.push_back(std::to_string(t + 1));
        std::size_t tried = 0;
        for (const Word& axiom : search_.words()) {
            if (axiom.empty()) continue;
            if (++tried > axioms_tried || axiom.size() > longest_axiom) break;
            system.axiom = axiom;
            if (std::all_of(induction->base.begin(), induction->base.end(), [&](const Word& word) {
                    return membership(system, word, budget_).member;
                }))
                return SourceSystem{"G", system, std::nullopt, {}, {}};
        }
        return std::nullopt;
    }

    Table table_of(const std::vector<std::vector<Word>>& successors) const {
        Table table(alphabet_.size());
        for (Symbol a = 0; a < table.size(); ++a) table[a] = {{a}};
        for (std::size_t i = 0; i < successors.size(); ++i)
            table[search_.letters()[i]] = successors[i];
        return table;
    }

    std::optional<Answer> by_successors(const std::vector<Map>& maps) {
        for (tried_ = 2; tried_ <= limit(longest_successor, instance_successor); ++tried_) {
            std::vector<Table> tables;
            for (const Map& map : maps) {
                std::vector<std::vector<Word>> successors;
                for (const Classes set : map) {
                    const auto words = search_.words_of(set, tried_);
                    if (!words) {
                        --tried_;
                        return std::nullopt;
                    }
                    if (words->empty()) break;
                    successors.push_back(*words);
                }
                if (successors.size() < map.size()) continue;
                tables.push_back(table_of(successors));
                if (auto found = system_of({tables.back()})) return generated_by(*found);
            }
            if (form_.tables && tables.size() > 1 && tables.size() <= most_tables)
                if (auto found = system_of(tables)) return generated_by(*found);
        }
        --tried_;
        return std::nullopt;
    }

    /// With one successor for each letter.
    std::optional<Answer> by_single_successors(const std::vector<Map>& maps) {
        std::set<Table> seen;
        for (tried_ = 2; tried_ <= limit(longest_successor, instance_successor); ++tried_) {
            std::vector<Table> tables;
            for (const Map& map : maps) {
                std::vector<std::vector<Word>> words;
                double choices = 1;
                for (const Classes set : map) {
                    const auto found = search_.words_of(set, tried_);
                    choices *= found ? static_cast<double>(found->size()) : 1e9;
                    if (found) words.push_back(*found);
                }
                if (choices > static_cast<double>(most_choices)) {
                    --tried_;
                    return std::nullopt;
                }
                std::vector<std::size_t> choice(words.size(), 0);
                for (bool more = choices > 0; more;) {
                    std::vector<std::vector<Word>> successors;
                    for (std::size_t i = 0; i < choice.size(); ++i)
                        successors.push_back({words[i][choice[i]]});
                    const Table table = table_of(successors);
                    tables.push_back(table);
                    if (seen.insert(table).second)
                        if (auto found = system_of({table})) return generated_by(*found);
                    more = false;
                    for (std::size_t i = 0; i < choice.size() && !more; ++i) {
                        more = ++choice[i] < words[i].size();
                        if (!more) choice[i] = 0;
                    }
                }
            }
            if (form_.tables && tables.size() > 1 && tables.size() <= most_tables)
                if (auto found = system_of(tables)) return generated_by(*found);
        }
        --tried_;
        return std::nullopt;
    }

    /// If it is to be small, leaves out tables and successors, the longest first, as long as the system generates the language.
    Answer generated_by(SourceSystem system) const {
        const auto try_without = [&](std::vector<Table> tables) {
            auto found = system_of(tables);
            if (found) system = std::move(*found);
            return found.has_value();
        };
        for (std::size_t t = question_.small ? system.tables->tables.size() : 0; t-- > 0;) {
            std::vector<Table> tables = system.tables->tables;
            if (tables.size() == 1) break;
            tables.erase(tables.begin() + static_cast<std::ptrdiff_t>(t));
            try_without(std::move(tables));
        }
        for (std::size_t t = 0; question_.small && t < system.tables->tables.size(); ++t)
            for (const Symbol a : search_.letters())
                for (std::size_t i = system.tables->tables[t][a].size(); i-- > 0;) {
                    std::vector<Table> tables = system.tables->tables;
                    if (tables[t][a].size() == 1) break;
                    tables[t][a].erase(tables[t][a].begin() + static_cast<std::ptrdiff_t>(i));
                    try_without(std::move(tables));
                }
        const auto shared = std::make_shared<const SourceSystem>(std::move(system));
        const Answer equal =
            judge_equality(generated_language(shared), language_, alphabet_, budget_);
        if (equal.truth != Truth::proved)
            return undecided("a system was found, but not that it generates the language");
        return proved(steps::GeneratedBy{shared, question_.family, language_, equal.proof, true});
    }

    const Language& language_;
    const RegularLanguage& value_;
    const FamilyQuestion& question_;
    const SystemForm& form_;
    const Alphabet& alphabet_;
    const Budget& budget_;
    ClassSearch search_;
    RegularLanguage marked_;
    std::size_t tried_ = 1;  // letters of successors
};

}  // namespace

Answer judge_regular_family(const Language& language, const RegularLanguage& value,
                            const FamilyQuestion& question, const Alphabet& alphabet,
                            const Budget& budget) {
    const SystemForm form = *system_form(question.family);
    if (form.deterministic)
        if (auto found =
                beyond_deterministic(language, value, question.family, form.tables, budget))
            return *found;
    if (auto lengths = lengths_of(value); lengths && !is_finite(value))
        return OneLetterJudge(language, *std::move(lengths), question, form, alphabet, budget)
            .judge();
    return RegularFamilyJudge(language, value, question, form, alphabet, budget).judge();
}

}  // namespace algae
