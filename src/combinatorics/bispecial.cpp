#include <algorithm>
#include <numeric>
#include <set>

#include "combinatorics/detail/levels.hpp"

// How many factors of n letters the infinite word u of a morphism has, for all n.
//
// The second difference of the number of factors is the sum of the bilateral multiplicities of the bispecial factors of that length (Cassaigne,
// Complexite et facteurs speciaux, 1997), so all bispecial factors are wanted. They are usually traced back through the
// morphism h (Klouda, Bispecial factors in circular non-pushy D0L languages, 2012), which needs a synchronising delay, h injective, and
// letters far away to know what prolongs a word. Here they are traced back through returns instead.
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

namespace algae {

namespace {

/// What the pairs say of the families that the word may be in.
struct Extensions {
    bool is_tree = false, has_centre = false, is_full = false;
};

Extensions extensions(const Pairs& pairs, std::size_t letters) {
    std::map<Symbol, std::set<Symbol>> left, right;
    for (const auto& [x, y] : pairs) {
        left[x].insert(y);
        right[y].insert(x);
    }
    Extensions found;
    // Connected, and one edge less than letters on both sides.
    std::set<Symbol> seen_left, seen_right;
    std::vector<Symbol> wanted{pairs.front().first};
    seen_left.insert(wanted.front());
    for (std::size_t i = 0; i < wanted.size(); ++i)
        for (const Symbol y : left[wanted[i]])
            if (seen_right.insert(y).second)
                for (const Symbol x : right[y])
                    if (seen_left.insert(x).second) wanted.push_back(x);
    found.is_tree = seen_left.size() == left.size() && seen_right.size() == right.size() &&
                    pairs.size() + 1 == left.size() + right.size();
    for (const auto& [centre, behind] : left) {
        const Symbol c = centre;
        if (!std::all_of(pairs.begin(), pairs.end(),
                         [&](const auto& pair) { return pair.first == c || pair.second == c; }))
            continue;
        found.has_centre = true;
        const auto before = right.find(c);
        found.is_full = found.is_full || (behind.size() == letters && before != right.end() &&
                                          before->second.size() == letters);
    }
    return found;
}

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

/// All bispecial factors of the word, from those of the derived words.
class Tracing {
public:
    Tracing(std::vector<DerivedLevel> levels, std::size_t before, const Budget& budget)
        : budget_(budget), levels_(std::move(levels)), before_(before) {}

    ComplexityForAll traced() {
        ComplexityForAll found;
        found.letters = levels_.front().letters();
        found.before = before_;
        found.period = levels_.size() - before_;
        found.dendric = found.episturmian = true;
        found.arnoux_rauzy = found.letters > 1;
        for (std::size_t i = 0; i < before_; ++i)
            for (const BispecialRoot& root : levels_[i].roots()) {
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
        for (const Pairs& pairs : extensions_) {
            const Extensions one = extensions(pairs, found.letters);
            found.dendric = found.dendric && one.is_tree;
            found.episturmian = found.episturmian && one.has_centre;
            found.arnoux_rauzy = found.arnoux_rauzy && one.has_centre && one.is_full;
        }
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
                 std::vector<Ending>& ends) {
        if (level == 0) {
            extensions_.insert(pairs);
            if (const auto m = *multiplicity(pairs); m != 0) ends.push_back({size(counts), m});
            return;
        }
        for (const BispecialImage& image : levels_[level - 1].images(pairs))
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
            for (const BispecialRoot& root : levels_[level].roots())
                starts_.emplace_back(state(level, root.pairs), root.counts);
        for (std::size_t i = 0; i < states_.size(); ++i) {
            budget_.check();
            if (states_.size() > most_letters / 100) too_large("have too many bispecial factors");
            const std::size_t level = above(states_[i].level);
            for (BispecialImage& image : levels_[level].images(Pairs(states_[i].pairs))) {
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

    void end(std::size_t at, const Counts& counts, std::vector<Ending>& ends) {
        if (states_[at].level == before_) descend(before_, states_[at].pairs, counts, ends);
    }

    /// All that comes of a factor that is on no circle, in a fixed order.
    void leave(std::size_t at, const Counts& counts, std::vector<Ending>& ends) {
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
    std::vector<DerivedLevel> levels_;
    std::size_t before_;
    std::vector<State> states_;
    std::map<std::pair<std::size_t, Pairs>, std::size_t> numbers_;
    std::vector<std::pair<std::size_t, Counts>> starts_;
    std::size_t rounds_ = 1;
    std::vector<BispecialChain> chains_, merged_;
    std::map<Integer, std::int64_t> single_;
    std::set<Pairs> extensions_;  // of the bispecial factors of the word itself
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

ComplexityForAll complexity_for_all(const Morphism& h, Symbol a, const Budget& budget) {
    DerivedWords all = derived_words(h, a, budget);
    const std::size_t before = all.before;
    return Tracing(levels_of(std::move(all)), before, budget).traced();
}

}  // namespace algae
