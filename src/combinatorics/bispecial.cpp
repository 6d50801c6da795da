#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "combinatorics/combinatorics.hpp"

// How many factors of n letters the infinite word u of a morphism has, for all n.
//
// The second difference of the number of factors is the sum of the bilateral multiplicities of the bispecial factors of that length (Cassaigne,
// Complexite et facteurs speciaux, 1997), so all bispecial factors are wanted. They are usually traced back through the
// morphism h (Klouda, Bispecial factors in circular non-pushy D0L languages, 2012), which needs a synchronising delay, h injective, and
// letters far away to know what prolongs a word. Here they are traced back through returns instead.
//
// Let 1 be the first letter of u, and let it come back. u is cut before each 1 into return words 1x, x without 1; number them in order, and u is
// the image of a derived word u' under the morphism T that gives each its return word. h(u) = u makes the cuts of u cuts of its
// image, so u' is the infinite word of a morphism h' with T h' = h T, found letter by letter from the first return word on. The derived words
// u, u', u'', ... are finitely many for a primitive h (Durand, A characterization of substitutive sequences using return words,
// 1998, where this is about returns to prefixes of u; deriving again and again by first letters gives such). Two of them are equal
// as soon as their morphisms are, numbered by first occurrence; from there on everything repeats.
//
// A factor v of u that has a 1 is s T(v') 1 p in one way, s and p without 1: the cuts in it stand before each 1. So v and v' occur together, v
// is bispecial only if v' is, and which letters prolong v on both sides is known from the pairs (x, y) of letters with x v' y
// in u': s ends T(x), 1 p begins T(y) 1, and the next letters of these are the ones. No letters farther away are needed, h
// need not be injective, and nothing is found twice. Factors without 1, with their neighbours, stand in the words T(b) 1, the
// empty word among them. So a bispecial factor of u is a bispecial factor without 1 of some derived word, and the images of it up to u.
//
// What the images of a bispecial factor are depends on its pairs alone, of which there are finitely many sets; its length is a sum over
// its letters, of which only the numbers matter. Where derived words repeat, sets of pairs go round in circles, and in each circle the numbers of
// letters go through an affine map again and again. A circle never leads to another one, for else there would be more and more
// bispecial factors of about one length, and the word is linearly recurrent; this is checked all the same. All circles are walked through
// so often that the affine map is the same for all of them; then all lengths satisfy one recurrence, of as many terms as the word has letters and one, and
// two chains are the same from some length on if so many lengths in a row are.
//
// Repetitions are traced in the same way. A factor with the period p is a word v that occurs again p letters later; where no letter prolongs it, other
// letters stand before the two v, and others behind. If v has a 1, the cuts in both v are the same, so v = s T(v') 1 p where v' occurs twice in u' and
// is not prolonged either: the letters around v' alone say which s, p and letters around v there are. The critical exponent is the least upper bound of 1 + |v|/p.
// A word without 1 occurs twice with periods as long as you like, but only the least ones in every letter matter: beyond a length
// that is worked out, |v|/p of all images stays below what others have.

namespace algae {

namespace {

using Pairs = std::vector<std::pair<Symbol, Symbol>>;  // in order, each once
using Counts = std::vector<Integer>;                   // of each letter of a word
using Images = std::vector<Word>;  // of letters 0, 1, ...; 0 is the first letter of the word

constexpr std::size_t most_levels = 2'000;
constexpr std::size_t most_letters = 4'000'000;  // of the images at one level, and of a return word

[[noreturn]] void too_large(const std::string& what) {
    throw BoundReached(Bound::method, "the words derived by returns " + what);
}

/// The word cut before each 0, numbered by first occurrence: the return words are added to the list.
class Cutting {
public:
    Symbol number(const Word& piece) {
        const auto [at, is_new] = numbers_.emplace(piece, static_cast<Symbol>(pieces_.size()));
        if (is_new) {
            pieces_.push_back(piece);
            size_ += piece.size();
            if (size_ > most_letters) too_large("get too large");
        }
        return at->second;
    }
    const Images& pieces() const { return pieces_; }

private:
    std::map<Word, Symbol> numbers_;
    Images pieces_;
    std::size_t size_ = 0;
};

/// The images with letters numbered by first occurrence in the word that the first one begins.
Images in_order(const Morphism& h, Symbol first) {
    std::map<Symbol, Symbol> numbers{{first, 0}};
    std::vector<Symbol> letters{first};
    Images images;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        Word image;
        for (const Symbol letter : h[letters[i]]) {
            const auto [at, is_new] = numbers.emplace(letter, static_cast<Symbol>(letters.size()));
            if (is_new) letters.push_back(letter);
            image.push_back(at->second);
        }
        images.push_back(std::move(image));
    }
    return images;
}

/// The first return word: the beginning of the infinite word before 0 comes back.
Word first_return(const Images& h, const Budget& budget) {
    Word word = h[0];
    for (std::size_t i = 1;; ++i) {
        if (i % 4096 == 0) budget.check();
        if (i >= word.size())
            throw Error("the first letter of the infinite word does not come back in it");
        if (word[i] == 0) {
            word.resize(i);
            return word;
        }
        if (word.size() < most_letters)
            word.insert(word.end(), h[word[i]].begin(), h[word[i]].end());
        if (i >= most_letters) too_large("have return words that are too long");
    }
}

/// The return words of the infinite word of h to its first letter, and the morphism of the derived word.
struct Derived {
    Images returns, h;
};

Derived derived(const Images& h, const Budget& budget) {
    Cutting cutting;
    cutting.number(first_return(h, budget));
    Derived found;
    std::size_t size = 0;
    for (std::size_t i = 0; i < cutting.pieces().size(); ++i) {
        budget.check();
        Word image, piece;
        for (const Symbol letter : Word(cutting.pieces()[i]))
            for (const Symbol next : h[letter]) {
                if (next == 0 && !piece.empty()) {
                    image.push_back(cutting.number(piece));
                    piece.clear();
                }
                piece.push_back(next);
            }
        image.push_back(cutting.number(piece));
        size += image.size();
        if (size > most_letters) too_large("get too large");
        found.h.push_back(std::move(image));
    }
    found.returns = cutting.pieces();
    return found;
}

/// The bilateral multiplicity of a word with these pairs of letters around it; nothing if it is not bispecial.
std::optional<std::int64_t> multiplicity(const Pairs& pairs) {
    std::set<Symbol> left, right;
    for (const auto& [x, y] : pairs) {
        left.insert(x);
        right.insert(y);
    }
    if (left.size() < 2 || right.size() < 2) return std::nullopt;
    return static_cast<std::int64_t>(pairs.size()) - static_cast<std::int64_t>(left.size()) -
           static_cast<std::int64_t>(right.size()) + 1;
}

void put_in_order(Pairs& pairs) {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// A word that several texts begin with, and the letter that comes next in each of them.
struct Beginning {
    Word word;
    std::map<Symbol, Symbol> next;  // by the letter whose text it is
};

/// The words that texts begin with and go on after in several ways, none past a second 0.
void branchings(const std::map<Symbol, Word>& texts, const std::vector<Symbol>& these,
                std::size_t length, std::vector<Beginning>& found) {
    std::map<Symbol, std::vector<Symbol>> by_next;
    for (const Symbol one : these) by_next[texts.at(one)[length]].push_back(one);
    if (by_next.size() > 1) {
        Beginning here;
        const Word& text = texts.at(these.front());
        here.word.assign(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
        for (const auto& [letter, those] : by_next)
            for (const Symbol one : those) here.next.emplace(one, letter);
        found.push_back(std::move(here));
    }
    for (const auto& [letter, those] : by_next)
        if (letter != 0 && those.size() > 1) branchings(texts, those, length + 1, found);
}

/// An image of a bispecial word: what is added to the image of its letters, and its own pairs.
struct Image {
    Pairs pairs;
    Counts added;
};

/// A bispecial factor without the first letter.
struct Root {
    Pairs pairs;
    Counts counts;
};

/// One derived word, as far as its factors are seen from the return words that make it of the next one.
class Level {
public:
    explicit Level(Images returns) : returns_(std::move(returns)) {
        Symbol greatest = 0;
        for (const Word& word : returns_)
            for (const Symbol letter : word) greatest = std::max(greatest, letter);
        letters_ = greatest + std::size_t{1};
    }

    std::size_t letters() const { return letters_; }
    const Images& returns() const { return returns_; }

    /// The numbers of letters of the image of a word under the return words.
    Counts image(const Counts& counts) const {
        Counts found(letters_);
        for (std::size_t b = 0; b < counts.size(); ++b)
            if (!counts[b].is_zero())
                for (const auto& [letter, times] : parikh(b))
                    found[letter] += counts[b] * Integer(times);
        return found;
    }

    /// Of a bispecial factor of the next derived word, those of this one that come of it.
    std::vector<Image> images(const Pairs& pairs) const {
        std::map<Symbol, Word> before, after;
        std::vector<Symbol> left, right;
        for (const auto& [x, y] : pairs) {
            const Word &ends = returns_[x], &begins = returns_[y];
            if (before.emplace(x, Word(ends.rbegin(), ends.rend())).second) left.push_back(x);
            if (const auto at = after.emplace(y, begins); at.second) {
                at.first->second.push_back(0);
                right.push_back(y);
            }
        }
        std::vector<Beginning> ends, begins;
        branchings(before, left, 0, ends);
        branchings(after, right, 1, begins);
        std::vector<Image> found;
        for (const Beginning& s : ends)
            for (const Beginning& p : begins) {
                Image one;
                for (const auto& [x, y] : pairs) {
                    const auto a = s.next.find(x), b = p.next.find(y);
                    if (a != s.next.end() && b != p.next.end())
                        one.pairs.emplace_back(a->second, b->second);
                }
                put_in_order(one.pairs);
                if (!multiplicity(one.pairs)) continue;
                one.added = Counts(letters_);
                for (const Word* word : {&s.word, &p.word})
                    for (const Symbol letter : *word) one.added[letter] += 1;
                found.push_back(std::move(one));
            }
        return found;
    }

    /// The bispecial factors of this derived word that have no 0.
    std::vector<Root> roots() const {
        std::vector<Word> texts = returns_;
        std::vector<Place> places;
        for (std::size_t b = 0; b < texts.size(); ++b) {
            texts[b].push_back(0);
            for (std::size_t i = 1; i < texts[b].size(); ++i) places.push_back({b, i});
        }
        std::vector<Root> found;
        look(texts, places, 0, found);
        return found;
    }

private:
    struct Place {
        std::size_t text, begin;
    };

    void look(const std::vector<Word>& texts, const std::vector<Place>& places, std::size_t length,
              std::vector<Root>& found) const {
        Pairs pairs;
        std::map<Symbol, std::vector<Place>> by_next;
        for (const Place& place : places) {
            const Word& text = texts[place.text];
            const Symbol next = text[place.begin + length];
            pairs.emplace_back(text[place.begin - 1], next);
            by_next[next].push_back(place);
        }
        put_in_order(pairs);
        if (multiplicity(pairs)) {
            Root one{std::move(pairs), Counts(letters_)};
            for (std::size_t i = 0; i < length; ++i)
                one.counts[texts[places.front().text][places.front().begin + i]] += 1;
            found.push_back(std::move(one));
        }
        for (const auto& [letter, those] : by_next) {
            if (letter == 0) continue;
            std::set<Symbol> left;
            for (const Place& place : those) left.insert(texts[place.text][place.begin - 1]);
            if (left.size() > 1) look(texts, those, length + 1, found);
        }
    }

    const std::map<Symbol, std::size_t>& parikh(std::size_t b) const {
        if (parikh_.empty())
            for (const Word& word : returns_) {
                parikh_.emplace_back();
                for (const Symbol letter : word) ++parikh_.back()[letter];
            }
        return parikh_[b];
    }

    Images returns_;
    std::size_t letters_ = 1;
    mutable std::vector<std::map<Symbol, std::size_t>> parikh_;
};

/// The shortest linear recurrence of a sequence that has one of at most half as many terms as are given (Massey 1969); whole numbers,
/// because the sequence is of whole numbers (Fatou 1906).
std::vector<Integer> shortest_recurrence(const std::vector<Integer>& sequence) {
    std::vector<Rational> now{1}, then{1};  // connection polynomials
    std::size_t length = 0, since = 1;
    Rational last = 1;
    for (std::size_t n = 0; n < sequence.size(); ++n) {
        Rational difference = 0;
        for (std::size_t i = 0; i <= length && i < now.size(); ++i)
            difference = difference + now[i] * Rational(sequence[n - i]);
        if (difference.is_zero()) {
            ++since;
            continue;
        }
        const std::vector<Rational> before = now;
        const Rational scale = difference / last;
        now.resize(std::max(now.size(), then.size() + since));
        for (std::size_t i = 0; i < then.size(); ++i)
            now[i + since] = now[i + since] - scale * then[i];
        if (2 * length <= n) {
            length = n + 1 - length;
            then = before;
            last = difference;
            since = 1;
        } else {
            ++since;
        }
    }
    std::vector<Integer> found(length);
    for (std::size_t i = 1; i <= length && i < now.size(); ++i) found[i - 1] = -now[i].numerator();
    return found;
}

Integer size(const Counts& counts) {
    return std::accumulate(counts.begin(), counts.end(), Integer(0));
}

Counts sum(Counts left, const Counts& right) {
    for (std::size_t i = 0; i < left.size(); ++i) left[i] += right[i];
    return left;
}

/// All bispecial factors of the word, from those of the derived words.
class Tracing {
public:
    Tracing(std::vector<Level> levels, std::size_t before, const Budget& budget)
        : budget_(budget), levels_(std::move(levels)), before_(before) {}

    ComplexityForAll traced() {
        ComplexityForAll found;
        found.letters = levels_.front().letters();
        found.before = before_;
        found.period = levels_.size() - before_;
        for (std::size_t i = 0; i < before_; ++i)
            for (const Root& root : levels_[i].roots()) {
                std::vector<Ending> ends;
                descend(i, root.pairs, root.counts, ends);
                add_single(ends);
            }
        find_circles();
        for (const auto& [state, counts] : starts_) walk(state, counts);
        for (std::size_t i = 0; i < chains_.size(); ++i) merge(chains_[i]);
        for (BispecialChain& chain : merged_) {
            if (chain.multiplicity == 0) continue;
            chain.recurrence = shortest_recurrence(chain.lengths);
            chain.lengths.resize(std::max<std::size_t>(chain.recurrence.size(), 4));
            found.chains.push_back(std::move(chain));
        }
        for (const auto& [length, multiplicity] : single_)
            if (multiplicity != 0) found.single.emplace_back(length, multiplicity);
        return found;
    }

private:
    /// A bispecial factor of the word itself.
    struct Ending {
        Integer length;
        std::int64_t multiplicity;
    };
    /// Sets of pairs at the levels that repeat.
    struct State {
        std::size_t level;
        Pairs pairs;
        std::vector<std::pair<std::size_t, Counts>> next;  // states one level up, and what is added
        std::size_t circle = none;                         // where it is on one
    };
    static constexpr std::size_t none = ~std::size_t{0};

    std::size_t above(std::size_t level) const {
        return level == before_ ? levels_.size() - 1 : level - 1;
    }

    /// The images in the word itself of a bispecial factor of a derived word, before it goes round.
    void descend(std::size_t level, const Pairs& pairs, const Counts& counts,
                 std::vector<Ending>& ends) const {
        if (level == 0) {
            if (const auto m = *multiplicity(pairs); m != 0) ends.push_back({size(counts), m});
            return;
        }
        for (const Image& image : levels_[level - 1].images(pairs))
            descend(level - 1, image.pairs, sum(levels_[level - 1].image(counts), image.added),
                    ends);
    }

    void add_single(const std::vector<Ending>& ends) {
        for (const Ending& end : ends) single_[end.length] += end.multiplicity;
    }

    std::size_t state(std::size_t level, const Pairs& pairs) {
        const auto [at, is_new] = numbers_.emplace(std::pair(level, pairs), states_.size());
        if (is_new) states_.push_back({level, pairs, {}});
        return at->second;
    }

    void find_circles() {
        for (std::size_t level = before_; level < levels_.size(); ++level)
            for (const Root& root : levels_[level].roots())
                starts_.emplace_back(state(level, root.pairs), root.counts);
        for (std::size_t i = 0; i < states_.size(); ++i) {
            budget_.check();
            if (states_.size() > most_letters / 100) too_large("have too many bispecial factors");
            const std::size_t level = above(states_[i].level);
            for (Image& image : levels_[level].images(Pairs(states_[i].pairs))) {
                const std::size_t to = state(level, image.pairs);
                states_[i].next.emplace_back(to, std::move(image.added));
            }
        }
        std::vector<std::vector<std::size_t>> successors;
        for (const State& one : states_) {
            successors.emplace_back();
            for (const auto& [to, added] : one.next) successors.back().push_back(to);
        }
        const std::vector<std::size_t> parts = strong_components(successors);
        std::map<std::size_t, std::size_t> sizes;
        for (const std::size_t part : parts) ++sizes[part];
        std::vector<char> leads(states_.size(), 0);  // to a circle, by components
        std::vector<std::size_t> order(states_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(),
                  [&](std::size_t x, std::size_t y) { return parts[x] < parts[y]; });
        std::map<std::size_t, bool> reaches;  // a circle, from this component on
        for (const std::size_t i : order) {
            std::size_t inside = 0;
            bool outside = false;
            for (const std::size_t to : successors[i]) {
                if (parts[to] == parts[i])
                    ++inside;
                else
                    outside = outside || reaches[parts[to]];
            }
            if (inside > 1 || (inside == 1 && outside))
                too_large("have more and more bispecial factors");
            if (inside == 1) states_[i].circle = sizes[parts[i]] / (levels_.size() - before_);
            if (inside == 1 || outside) reaches[parts[i]] = true;
        }
        for (const State& one : states_)
            if (one.circle != none) rounds_ = std::lcm(rounds_, one.circle);
        if (rounds_ > 5'000) too_large("have bispecial factors that repeat too late");
    }

    /// Follows a bispecial factor; what it comes to before a circle is single.
    void walk(std::size_t at, const Counts& counts) {
        budget_.check();
        if (states_[at].circle != none) {
            go_round(at, counts);
            return;
        }
        std::vector<Ending> ends;
        end(at, counts, ends);
        add_single(ends);
        for (const auto& [to, added] : states_[at].next) walk(to, step(at, counts, added));
    }

    Counts step(std::size_t at, const Counts& counts, const Counts& added) const {
        return sum(levels_[above(states_[at].level)].image(counts), added);
    }

    void end(std::size_t at, const Counts& counts, std::vector<Ending>& ends) const {
        if (states_[at].level == before_) descend(before_, states_[at].pairs, counts, ends);
    }

    /// All that comes of a factor that is on no circle, in a fixed order.
    void leave(std::size_t at, const Counts& counts, std::vector<Ending>& ends) const {
        end(at, counts, ends);
        for (const auto& [to, added] : states_[at].next) leave(to, step(at, counts, added), ends);
    }

    void go_round(std::size_t begin, Counts counts) {
        const std::size_t terms = 2 * (levels_[before_].letters() + 2);
        std::size_t at = begin;
        std::vector<BispecialChain> found;
        for (std::size_t term = 0; term < terms; ++term) {
            budget_.check();
            std::vector<Ending> ends;
            for (std::size_t round = 0; round < rounds_; round += states_[begin].circle) do {
                    end(at, counts, ends);
                    std::size_t next = none;
                    Counts after;
                    for (const auto& [to, added] : states_[at].next) {
                        Counts there = step(at, counts, added);
                        if (states_[to].circle == none) {
                            leave(to, there, ends);
                        } else {
                            next = to;
                            after = std::move(there);
                        }
                    }
                    at = next;
                    counts = std::move(after);
                } while (at != begin);
            found.resize(ends.size());
            for (std::size_t i = 0; i < ends.size(); ++i) {
                found[i].multiplicity = ends[i].multiplicity;
                found[i].lengths.push_back(ends[i].length);
            }
        }
        chains_.insert(chains_.end(), found.begin(), found.end());
    }

    /// Adds a chain to another one that has the same lengths from some length on; the lengths before are single.
    void merge(const BispecialChain& one) {
        const std::size_t enough = levels_[before_].letters() + 2;
        for (BispecialChain& other : merged_)
            for (const bool is_turned : {false, true}) {
                const auto &all = is_turned ? one.lengths : other.lengths,
                           &tail = is_turned ? other.lengths : one.lengths;
                const auto at = std::lower_bound(all.begin(), all.end(), tail.front());
                const auto rest = static_cast<std::size_t>(all.end() - at);
                if (rest < enough || !std::equal(at, all.end(), tail.begin())) continue;
                for (auto early = all.begin(); early != at; ++early)
                    single_[*early] += is_turned ? one.multiplicity : other.multiplicity;
                if (!is_turned) other.lengths = one.lengths;
                other.multiplicity += one.multiplicity;
                return;
            }
        merged_.push_back(one);
    }

    const Budget& budget_;
    std::vector<Level> levels_;
    std::size_t before_;
    std::vector<State> states_;
    std::map<std::pair<std::size_t, Pairs>, std::size_t> numbers_;
    std::vector<std::pair<std::size_t, Counts>> starts_;
    std::size_t rounds_ = 1;
    std::vector<BispecialChain> chains_, merged_;
    std::map<Integer, std::int64_t> single_;
};

}  // namespace

std::vector<Integer> BispecialChain::lengths_to(const Integer& most) const {
    std::vector<Integer> found;
    for (std::size_t k = 0;; ++k) {
        Integer next = 0;
        if (k < lengths.size())
            next = lengths[k];
        else
            for (std::size_t i = 0; i < recurrence.size(); ++i)
                next += recurrence[i] * found[k - 1 - i];
        if (next > most) return found;
        found.push_back(std::move(next));
    }
}

Integer ComplexityForAll::value(const Integer& n) const {
    Integer found = Integer(1) + n * (Integer(letters) - Integer(1));
    const auto add = [&](const Integer& length, std::int64_t times) {
        if (length < n) found += Integer(times) * (n - length - Integer(1));
    };
    for (const auto& [length, times] : single) add(length, times);
    for (const BispecialChain& chain : chains)
        for (const Integer& length : chain.lengths_to(n)) add(length, chain.multiplicity);
    return found;
}

std::optional<ComplexityForAll::Linear> ComplexityForAll::linear() const {
    if (!chains.empty()) return std::nullopt;
    const Integer late = single.empty() ? Integer(0) : single.back().first + Integer(1);
    const Integer there = value(late), slope = value(late + Integer(1)) - there;
    return Linear{slope, there - slope * late, late};
}

namespace {

/// Derived words until one comes back, and how many there are before those that do.
std::pair<std::vector<Level>, std::size_t> derived_words(const Morphism& h, Symbol a,
                                                         const Budget& budget) {
    if (!h.maps(a) || h[a].size() < 2 || h[a].front() != a)
        throw Error("expected a letter whose image begins with it and is longer");
    Images now = in_order(h, a);
    std::map<Images, std::size_t> seen;
    std::vector<Level> levels;
    for (;;) {
        const auto [at, is_new] = seen.emplace(now, levels.size());
        if (!is_new) return {std::move(levels), at->second};
        if (levels.size() == most_levels) too_large("do not repeat");
        Derived next = derived(now, budget);
        levels.emplace_back(std::move(next.returns));
        now = std::move(next.h);
    }
}

/// The letters that stand on one side of the two occurrences of a word, which differ.
using Break = std::pair<Symbol, Symbol>;

/// A word that occurs twice, and no letter on either side prolongs it.
struct Repetition {
    Break before, behind;
    Counts word,
        period;  // numbers of letters, of the word and of what is between the two places where it begins
};

bool is_at_most(const Counts& left, const Counts& right) {
    return std::equal(left.begin(), left.end(), right.begin(),
                      [](const Integer& x, const Integer& y) { return x <= y; });
}

/// The repetitions that none of the others exceeds with the same letters around it.
class Greatest {
public:
    /// Whether it is a new one.
    bool add(const Repetition& one) {
        auto& all = found_[{one.before, one.behind}];
        for (const Repetition& other : all)
            if (is_at_most(one.word, other.word) && is_at_most(other.period, one.period))
                return false;
        std::erase_if(all, [&](const Repetition& other) {
            return is_at_most(other.word, one.word) && is_at_most(one.period, other.period);
        });
        all.push_back(one);
        return true;
    }
    std::vector<Repetition> all() const {
        std::vector<Repetition> list;
        for (const auto& [around, these] : found_)
            list.insert(list.end(), these.begin(), these.end());
        return list;
    }

private:
    std::map<std::pair<Break, Break>, std::vector<Repetition>> found_;
};

class Repeating {
public:
    Repeating(const std::vector<Level>& levels, std::size_t before, const Budget& budget)
        : budget_(budget), levels_(levels), before_(before), letters_(levels[before].letters()) {}

    GreatestRepetitions found() {
        GreatestRepetitions all;
        for (const Level& level : levels_) all.periodic = all.periodic || level.letters() == 1;
        if (all.periodic) return all;
        all.step = IntegerMatrix(letters_, letters_);
        for (std::size_t b = 0; b < letters_; ++b) {
            Counts unit(letters_);
            unit[b] = 1;
            Repetition one{{0, 1}, {0, 1}, {}, unit};
            const Repetition image = round(one), end = in_word(std::move(one));
            for (std::size_t a = 0; a < letters_; ++a) all.step(a, b) = image.period[a];
            all.lengths.push_back(size(end.period));
        }
        find_growing(all);
        find_pairs();
        constexpr std::size_t first = 50;
        roots_.resize(levels_.size());
        for (std::size_t level = 0; level < levels_.size(); ++level) collect(level, first);
        all.least = ratio();
        for (std::size_t level = 0; level < levels_.size(); ++level)
            if (const std::size_t needed = sufficient(level, all.least); needed > first)
                collect(level, needed);
        chains(all);
        return all;
    }

private:
    /// The letters before the images of a word between such letters of the next derived word, and what the images have before them in common.
    Break before(std::size_t level, const Break& of, Counts& word) const {
        const Images& returns = levels_[level].returns();
        const Word &x = returns[of.first], &y = returns[of.second];
        std::size_t same = 1;
        for (; x[x.size() - same] == y[y.size() - same]; ++same) word[x[x.size() - same]] += 1;
        return {x[x.size() - same], y[y.size() - same]};
    }
    Break behind(std::size_t level, const Break& of, Counts& word) const {
        const Images& returns = levels_[level].returns();
        const auto at = [](const Word& letters, std::size_t i) {
            return i < letters.size() ? letters[i] : Symbol{0};
        };
        const Word &x = returns[of.first], &y = returns[of.second];
        std::size_t same = 0;
        for (; at(x, same) == at(y, same); ++same) word[at(x, same)] += 1;
        return {at(x, same), at(y, same)};
    }

    /// The image of a repetition of the next derived word.
    Repetition image(std::size_t level, const Repetition& of) const {
        Repetition found{{}, {}, levels_[level].image(of.word), levels_[level].image(of.period)};
        found.before = before(level, of.before, found.word);
        found.behind = behind(level, of.behind, found.word);
        return found;
    }

    /// What comes of a repetition of a level that repeats when all of them are gone through.
    Repetition round(Repetition one) const {
        for (std::size_t level = levels_.size(); level-- > before_;) one = image(level, one);
        return one;
    }
    Repetition in_word(Repetition one) const {
        for (std::size_t level = before_; level-- > 0;) one = image(level, one);
        return one;
    }

    /// A vector w of the matrix with matrix w - w above 0 in all places.
    void find_growing(const GreatestRepetitions& all) {
        growing_ = Counts(letters_);
        for (Counts power(letters_, Integer(1));;) {
            budget_.check();
            for (std::size_t a = 0; a < letters_; ++a) growing_[a] += power[a];
            power = all.step * power;
            if (std::all_of(power.begin(), power.end(),
                            [](const Integer& one) { return one >= 2; }))
                return;
        }
    }

    /// The level of the next derived word.
    std::size_t next_level(std::size_t level) const {
        return level + 1 == levels_.size() ? before_ : level + 1;
    }

    /// The factors of two letters of each derived word: those of return words with the 0 behind them.
    void find_pairs() {
        pairs_.resize(levels_.size());
        for (std::size_t level = 0; level < levels_.size(); ++level)
            for (const Word& word : levels_[level].returns())
                for (std::size_t i = 0; i < word.size(); ++i)
                    pairs_[level].insert({word[i], i + 1 < word.size() ? word[i + 1] : Symbol{0}});
    }

    /// Words of a level that have all its factors of so many letters.
    std::vector<Word> texts(std::size_t level, std::size_t length) const {
        Images images = levels_[level].returns();
        std::size_t of = next_level(level);  // these are images of its letters
        const auto is_short = [&](const Word& word) { return word.size() < length; };
        while (std::any_of(images.begin(), images.end(), is_short)) {
            budget_.check();
            Images next;
            std::size_t size = 0;
            for (const Word& word : levels_[of].returns()) {
                next.emplace_back();
                for (const Symbol letter : word)
                    next.back().insert(next.back().end(), images[letter].begin(),
                                       images[letter].end());
                if ((size += next.back().size()) > most_letters)
                    too_large("have repetitions that are too long");
            }
            images = std::move(next);
            of = next_level(of);
        }
        std::vector<Word> found;
        std::size_t size = 0;
        for (const auto& [x, y] : pairs_[of]) {
            // Factors that begin in the image of x.
            Word word = images[x];
            word.insert(word.end(), images[y].begin(),
                        images[y].begin() + static_cast<std::ptrdiff_t>(length));
            if ((size += word.size()) > most_letters)
                too_large("have repetitions that are too long");
            found.push_back(std::move(word));
        }
        return found;
    }

    /// The repetitions of words without 0 with periods up to `longest` at a level.
    void collect(std::size_t level, std::size_t longest) {
        std::size_t most = 0;
        for (const Word& word : levels_[level].returns()) most = std::max(most, word.size());
        const std::vector<Word> all = texts(level, longest + most + 2);
        std::size_t size = 0;
        for (const Word& text : all) size += text.size();
        constexpr std::size_t most_compared = 20'000'000;
        if (size > most_compared / longest) too_large("have repetitions with too many periods");
        for (const Word& text : all)
            for (std::size_t period = 1; period <= longest; ++period) {
                budget_.check();
                repetitions(level, text, period);
            }
    }

    void repetitions(std::size_t level, const Word& text, std::size_t period) {
        // `begin` is behind the last place where the letters differ.
        std::size_t begin = 0, zeros = 0;
        for (std::size_t i = 0; i + period < text.size(); ++i) {
            if (text[i] == text[i + period]) {
                zeros += text[i] == 0;
                continue;
            }
            if (begin > 0 && zeros == 0) {
                Repetition one{{text[begin - 1], text[begin - 1 + period]},
                               {text[i], text[i + period]},
                               Counts(levels_[level].letters()),
                               Counts(levels_[level].letters())};
                for (std::size_t j = begin; j < i; ++j) one.word[text[j]] += 1;
                for (std::size_t j = begin; j < begin + period; ++j) one.period[text[j]] += 1;
                roots_[level].add(one);
            }
            begin = i + 1;
            zeros = 0;
        }
    }

    /// The repetitions of the first word that repeats that come of those of the levels that repeat, before they go round.
    std::vector<Repetition> at_base() const {
        Greatest found;
        for (std::size_t level = before_; level < levels_.size(); ++level)
            for (Repetition one : roots_[level].all()) {
                for (std::size_t i = level; i-- > before_;) one = image(i, one);
                found.add(one);
            }
        return found.all();
    }

    /// A little less than a limit of |v|/p.
    Rational ratio() const {
        constexpr int rounds = 12;
        Rational best = 0;
        for (Repetition one : at_base()) {
            for (int i = 0; i < rounds; ++i) one = round(std::move(one));
            const Repetition end = in_word(std::move(one));
            best = std::max(best, Rational(size(end.word), size(end.period)));
        }
        // Rounded down to a number that is quickly reckoned with.
        return Rational(floor(best * Rational(980)), 1000);
    }

    /// A length such that repetitions of a level with longer periods have |v| < ratio p, and so have all that come of them.
    std::size_t sufficient(std::size_t level, const Rational& ratio) const {
        if (ratio <= Rational(0)) too_large("have too few repetitions");
        Counts word(levels_[level].letters());
        for (const Word& one : levels_[level].returns()) {
            Counts counts(levels_[level].letters());
            for (const Symbol letter : one) counts[letter] += 1;
            for (std::size_t a = 1; a < counts.size(); ++a) word[a] = std::max(word[a], counts[a]);
        }
        // With y = times growing_, a repetition with ratio p - v >= y in all letters has it for ever, and less than ratio in the word itself.
        Counts wanted;
        if (level < before_) {
            wanted = {size(greatest(level, 0, word)) + 1};
        } else {
            Integer times = size(greatest(before_, 0, Counts(letters_))) + 1;
            for (const Integer& number : greatest(levels_.size(), before_, Counts(letters_)))
                times = std::max(times, number);
            wanted = greatest(level, before_, word);
            for (std::size_t a = 0; a < letters_; ++a) wanted[a] += times * growing_[a];
        }
        // What a letter of this level counts for each of those.
        std::vector<std::vector<std::uint64_t>> counts_for(wanted.size());
        for (std::size_t b = 0; b < levels_[level].letters(); ++b) {
            Counts counts(levels_[level].letters());
            counts[b] = 1;
            for (std::size_t i = level; i-- > (level < before_ ? 0 : before_);)
                counts = levels_[i].image(counts);
            if (level < before_) counts = {size(counts)};
            for (std::size_t a = 0; a < counts.size(); ++a)
                counts_for[a].push_back(counts[a].to_uint64());
        }
        std::vector<std::uint64_t> least;
        for (const Integer& one : wanted)
            least.push_back(ceiling(Rational(one) / ratio).to_uint64());
        for (std::size_t length = 128;; length *= 2)
            if (const auto found = shortest(texts(level, length), length, counts_for, least))
                return *found;
    }

    /// The least length such that all factors count for so much; nothing if it is greater than `length`.
    std::optional<std::size_t> shortest(const std::vector<Word>& texts, std::size_t length,
                                        const std::vector<std::vector<std::uint64_t>>& counts_for,
                                        const std::vector<std::uint64_t>& least) const {
        std::size_t found = 0;
        for (const Word& text : texts) {
            budget_.check();
            for (std::size_t a = 0; a < least.size(); ++a) {
                std::uint64_t sum = 0;
                for (std::size_t begin = 0, end = 0; begin + length <= text.size(); ++begin) {
                    for (; sum < least[a] && end < text.size(); ++end)
                        sum += counts_for[a][text[end]];
                    if (sum < least[a] || end - begin > length) return std::nullopt;
                    found = std::max(found, end - begin);
                    sum -= counts_for[a][text[begin]];
                }
            }
        }
        return found;
    }

    /// At least the numbers of letters of what comes, levels down, of words with at most so many letters.
    Counts greatest(std::size_t from, std::size_t to, Counts counts) const {
        const auto letters = static_cast<Symbol>(counts.size());
        for (std::size_t level = from; level-- > to;) counts = levels_[level].image(counts);
        for (const auto side : {&Repeating::before, &Repeating::behind}) {
            Counts most(counts.size());
            for (Symbol x = 0; x < letters; ++x)
                for (Symbol y = 0; y < x; ++y) {
                    budget_.check();
                    Break around{x, y};
                    Counts added(letters);
                    for (std::size_t level = from; level-- > to;) {
                        added = levels_[level].image(added);
                        around = (this->*side)(level, around, added);
                    }
                    for (std::size_t a = 0; a < most.size(); ++a)
                        most[a] = std::max(most[a], added[a]);
                }
            counts = sum(std::move(counts), most);
        }
        return counts;
    }

    void chains(GreatestRepetitions& all) const {
        for (std::size_t level = 0; level < before_; ++level)
            for (Repetition one : roots_[level].all()) {
                for (std::size_t i = level; i-- > 0;) one = image(i, one);
                all.single.emplace_back(size(one.word), size(one.period));
            }
        using Around = std::pair<Break, Break>;
        Greatest circling;
        for (Repetition one : at_base()) {
            std::set<Around> seen;
            std::vector<Repetition> line;
            while (seen.insert({one.before, one.behind}).second) {
                line.push_back(one);
                one = round(std::move(one));
            }
            const Around back{one.before, one.behind};
            auto at = line.begin();
            for (; Around(at->before, at->behind) != back; ++at) {
                const Repetition end = in_word(*at);
                all.single.emplace_back(size(end.word), size(end.period));
            }
            for (; at != line.end(); ++at) circling.add(*at);
        }
        for (const Repetition& one : circling.all()) {
            budget_.check();
            Repetition turned{one.before, one.behind, Counts(letters_), Counts(letters_)};
            RepetitionChain chain{one.word, one.period, 0, {}, 0};
            do {
                turned = round(std::move(turned));
                ++chain.rounds;
            } while (turned.before != one.before || turned.behind != one.behind);
            chain.added = turned.word;
            chain.behind =
                size(in_word({one.before, one.behind, Counts(letters_), Counts(letters_)}).word);
            all.chains.push_back(std::move(chain));
        }
    }

    const Budget& budget_;
    const std::vector<Level>& levels_;
    std::size_t before_, letters_;
    Counts growing_;
    std::vector<std::set<std::pair<Symbol, Symbol>>> pairs_;
    std::vector<Greatest> roots_;  // by level
};

}  // namespace

ComplexityForAll complexity_for_all(const Morphism& h, Symbol a, const Budget& budget) {
    auto [levels, before] = derived_words(h, a, budget);
    return Tracing(std::move(levels), before, budget).traced();
}

GreatestRepetitions greatest_repetitions(const Morphism& h, Symbol a, const Budget& budget) {
    const auto [levels, before] = derived_words(h, a, budget);
    return Repeating(levels, before, budget).found();
}

}  // namespace algae
