#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "verify/detail/words.hpp"

// The number p(n) of factors of an infinite word u = h(h(h(...(a)...))) for all n, by the windows of finitely many words.
//
// p(n+2) - 2 p(n+1) + p(n) is the sum, over the bispecial factors v of n letters, of the numbers of pairs of letters around v, less those of
// letters before and behind it, plus 1 (Cassaigne 1997). The certificate says where this is not 0. That is worked out again here.
//
// u is cut before each first letter, which comes back: u = T(u') for the word u' of these return words, which has a morphism of its own;
// the same is done with u', until a word comes back. What prolongs a factor without the first letter is seen in the windows of
// the return words with a first letter behind them. A factor with one is s T(v') 1 p, 1 the first letter, for exactly one factor v' of u'; with x before and y
// behind v', s has to end T(x) and 1 p to begin T(y) 1, and the windows of these words show the letters around it. All s and p
// are tried. So each bispecial factor of u is the image, over finitely many words, of one without first letter.
//
// Factors with the same numbers of letters are taken together. What becomes of such a group, and the sum that it adds to a length, depends on the pairs of its
// members alone. Groups that come back add sums for arbitrarily great lengths, which satisfy a recurrence; where such lengths are the same from some place on, their
// sums are added. If some are not 0 then, the number of factors is not linear, and nothing is judged.

namespace algae::verify {

namespace {

using Pairs = std::set<std::pair<Symbol, Symbol>>;
using Group = std::multiset<Pairs>;  // around factors with the same numbers of letters
using Numbers = std::vector<Integer>;

constexpr std::size_t most = 1'000'000;  // letters of return words and of images, windows, lengths

void expect_small(std::size_t size, const char* what) {
    if (size > most)
        throw BoundReached(Bound::method, std::string(what) + " are more than are looked at");
}

Numbers counted(const Word& word, std::size_t letters) {
    Numbers found(letters);
    for (const Symbol letter : word) found[letter] += 1;
    return found;
}

Numbers operator+(Numbers left, const Numbers& right) {
    for (std::size_t i = 0; i < left.size(); ++i) left[i] += right[i];
    return left;
}

std::int64_t multiplicity(const Pairs& pairs) {
    std::set<Symbol> left, right;
    for (const auto& [x, y] : pairs) {
        left.insert(x);
        right.insert(y);
    }
    return static_cast<std::int64_t>(pairs.size()) - static_cast<std::int64_t>(left.size()) -
           static_cast<std::int64_t>(right.size()) + 1;
}

bool is_bispecial(const Pairs& pairs) {
    return std::any_of(pairs.begin(), pairs.end(),
                       [&](const auto& one) { return one.first != pairs.begin()->first; }) &&
           std::any_of(pairs.begin(), pairs.end(),
                       [&](const auto& one) { return one.second != pairs.begin()->second; });
}

}  // namespace

Symbol first_letter(const Obligation& task) {
    const System& system = task.system();
    if (!is_d0l(system)) task.refuse("the system is not D0L");
    const System::Successors& rules = system.tables[0];
    if (system.axiom.empty()) task.refuse("the axiom is empty");
    Symbol first = system.axiom[0];
    const auto head = [&](Symbol letter) {
        if (rules[letter][0].empty()) task.refuse("a letter of the word is erased");
        return rules[letter][0][0];
    };
    for (std::size_t i = 0; i < rules.size(); ++i) first = head(first);
    if (head(first) != first || rules[first][0].size() < 2)
        task.refuse("no word of the system begins with the one before it for ever");
    return first;
}

Images morphism_of(const Obligation& task) {
    if (!task.statement.coding.empty()) task.refuse("the word is coded");
    const Symbol first = first_letter(task);
    const System::Successors& rules = task.system().tables[0];
    std::map<Symbol, Symbol> numbers{{first, 0}};
    std::vector<Symbol> letters{first};
    Images images;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        images.emplace_back();
        if (rules[letters[i]][0].empty()) task.refuse("a letter of the word is erased");
        for (const Symbol letter : rules[letters[i]][0]) {
            if (numbers.try_emplace(letter, static_cast<Symbol>(letters.size())).second)
                letters.push_back(letter);
            images.back().push_back(numbers.at(letter));
        }
    }
    return images;
}

namespace {

Cut cut(const Images& h, const Obligation& task) {
    Cut found;
    found.letters = h.size();
    // The word up to the second 0.
    Word beginning = h[0];
    for (std::size_t i = 1;; ++i) {
        task.budget.check();
        expect_small(i, "letters before the first letter comes back");
        if (i == beginning.size())
            throw BoundReached(Bound::method, "the first letter does not come back");
        if (beginning[i] == 0) {
            beginning.resize(i);
            break;
        }
        if (beginning.size() <= most)
            beginning.insert(beginning.end(), h[beginning[i]].begin(), h[beginning[i]].end());
    }
    std::map<Word, Symbol> numbers{{beginning, 0}};
    found.returns = {beginning};
    std::size_t size = 0;
    for (std::size_t i = 0; i < found.returns.size(); ++i) {
        task.budget.check();
        Word image;
        for (const Symbol letter : found.returns[i])
            image.insert(image.end(), h[letter].begin(), h[letter].end());
        size += image.size() + found.returns[i].size();
        expect_small(size, "letters of return words");
        found.next.emplace_back();
        for (std::size_t begin = 0; begin < image.size();) {
            std::size_t end = begin + 1;
            while (end < image.size() && image[end] != 0) ++end;
            const auto at = image.begin();
            Word piece(at + static_cast<std::ptrdiff_t>(begin),
                       at + static_cast<std::ptrdiff_t>(end));
            const auto [known, is_new] =
                numbers.try_emplace(piece, static_cast<Symbol>(found.returns.size()));
            if (is_new) found.returns.push_back(std::move(piece));
            found.next.back().push_back(known->second);
            begin = end;
        }
    }
    return found;
}

}  // namespace

Cuts cuts_of(Images h, const Obligation& task) {
    Cuts found;
    std::map<Images, std::size_t> seen;
    while (seen.try_emplace(h, found.all.size()).second) {
        expect_small(1000 * found.all.size(), "words of return words");
        found.all.push_back(cut(h, task));
        h = found.all.back().next;
    }
    found.before = seen.at(h);
    return found;
}

namespace {

class Bispecial {
public:
    explicit Bispecial(const Obligation& task) : task_(task) {
        Cuts found = cuts_of(morphism_of(task), task);
        cuts_ = std::move(found.all);
        before_ = found.before;
    }

    std::size_t letters() const { return cuts_.front().letters; }

    /// The sums that are not 0, by length.
    std::map<Integer, std::int64_t> sums() {
        std::map<std::pair<std::size_t, Numbers>, Group> roots;
        for (std::size_t level = 0; level < cuts_.size(); ++level)
            for (const auto& [word, pairs] : without_first(cuts_[level]))
                roots[{level, counted(word, cuts_[level].letters)}].insert(pairs);
        for (const auto& [place, group] : roots)
            if (place.first >= before_) type(place.first, group);
        explore();
        find_circles();
        for (const auto& [place, group] : roots) {
            if (place.first < before_)
                for (const auto& [numbers, sum] : ends(place.first, group))
                    add(length(place.first, place.second, numbers), sum);
            else
                follow(type(place.first, group), place.second);
        }
        for (const Stream& one : streams_)
            if (one.sum != 0)
                throw BoundReached(Bound::method,
                                   "sums for arbitrarily great lengths are not judged");
        std::erase_if(sums_, [](const auto& one) { return one.second == 0; });
        return sums_;
    }

private:
    static constexpr std::size_t none = ~std::size_t{0};

    struct Type {
        std::size_t level;
        Group group;
        std::vector<std::pair<std::size_t, Numbers>> next = {};  // and what is added to the image
        std::map<Numbers, std::int64_t> ends =
            {};                     // in the word itself: what is added, and the sum; none is 0
        bool matters = false;       // some group that comes of it has a sum
        std::size_t circle = none;  // the first type on its circle of types that matter
    };
    /// Lengths of which each is the next one of a circle that is gone round, with the same sum.
    struct Stream {
        std::vector<Integer> lengths;
        std::int64_t sum;
    };
    using Sums = std::vector<std::pair<Integer, std::int64_t>>;

    /// The factors without 0 that are bispecial.
    std::map<Word, Pairs> without_first(const Cut& in) const {
        std::map<Word, Pairs> found;
        std::size_t windows = 0;
        for (const Word& word : in.returns) {
            Word whole = word;
            whole.push_back(0);
            for (std::size_t begin = 1; begin < whole.size(); ++begin) {
                task_.budget.check();
                Word window;
                for (std::size_t end = begin; end < whole.size(); ++end) {
                    found[window].insert({whole[begin - 1], whole[end]});
                    window.push_back(whole[end]);
                    expect_small(windows += window.size(), "windows");
                }
            }
        }
        std::erase_if(found, [](const auto& one) { return !is_bispecial(one.second); });
        return found;
    }

    /// The numbers of letters of the image of a factor of the word of return words.
    static Numbers image(const Cut& in, const Numbers& numbers) {
        Numbers found(in.letters);
        for (std::size_t b = 0; b < numbers.size(); ++b)
            for (const Symbol letter : in.returns[b]) found[letter] += numbers[b];
        return found;
    }

    /// The groups of bispecial factors that come of a group of factors of the word of return words, by what is added to the image.
    std::map<Numbers, Group> images(const Cut& in, const Group& group) const {
        std::map<Numbers, Group> found;
        for (const Pairs& pairs : group) {
            std::map<std::pair<Word, Word>, Pairs> around;
            std::size_t windows = 0;
            for (const auto& [x, y] : pairs) {
                const Word& before = in.returns[x];
                Word behind = in.returns[y];
                behind.push_back(0);
                for (std::size_t i = before.size(); i-- > 0;)  // the letter before s
                    for (std::size_t j = 1; j < behind.size(); ++j) {
                        task_.budget.check();
                        expect_small(windows += before.size() + j, "windows");
                        around[{Word(before.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                     before.end()),
                                Word(behind.begin(),
                                     behind.begin() + static_cast<std::ptrdiff_t>(j))}]
                            .insert({before[i], behind[j]});
                    }
            }
            for (const auto& [words, here] : around)
                if (is_bispecial(here))
                    found[counted(words.first, in.letters) + counted(words.second, in.letters)]
                        .insert(here);
        }
        return found;
    }

    /// What comes of a group in the word itself, not going round: what is added, and the sum.
    std::map<Numbers, std::int64_t> ends(std::size_t level, const Group& group) const {
        std::map<Numbers, std::int64_t> found;
        if (level == 0) {
            std::int64_t sum = 0;
            for (const Pairs& pairs : group) sum += multiplicity(pairs);
            if (sum != 0) found[Numbers(letters())] = sum;
            return found;
        }
        for (const auto& [added, next] : images(cuts_[level - 1], group))
            for (const auto& [more, sum] : ends(level - 1, next))
                found[down(level - 1, added) + more] += sum;
        std::erase_if(found, [](const auto& one) { return one.second == 0; });
        return found;
    }

    /// Numbers of letters at a level as those of the image in the word itself.
    Numbers down(std::size_t level, Numbers numbers) const {
        while (level-- > 0) numbers = image(cuts_[level], numbers);
        return numbers;
    }

    Integer length(std::size_t level, const Numbers& numbers, const Numbers& added) const {
        Integer found = 0;
        for (const Integer& one : down(level, numbers) + added) found += one;
        return found;
    }

    void add(const Integer& length, std::int64_t sum) {
        sums_[length] += sum;
        expect_small(sums_.size(), "lengths");
    }

    std::size_t above(std::size_t level) const {
        return level == before_ ? cuts_.size() - 1 : level - 1;
    }

    std::size_t type(std::size_t level, const Group& group) {
        const auto [at, is_new] = numbers_.try_emplace({level, group}, types_.size());
        if (is_new) types_.push_back({level, group});
        return at->second;
    }

    /// All groups that come of those that are known, and which of them matter.
    void explore() {
        for (std::size_t i = 0; i < types_.size(); ++i) {
            task_.budget.check();
            expect_small(100 * types_.size(), "groups of bispecial factors");
            const std::size_t level = types_[i].level;
            const Group group = types_[i].group;
            if (level == before_) types_[i].ends = ends(level, group);
            types_[i].matters = !types_[i].ends.empty();
            for (const auto& [added, next] : images(cuts_[above(level)], group)) {
                const std::size_t to = type(above(level), next);
                types_[i].next.emplace_back(to, added);
            }
        }
        for (bool changes = true; changes;) {
            changes = false;
            for (Type& one : types_)
                for (const auto& [to, added] : one.next)
                    if (types_[to].matters && !one.matters) changes = one.matters = true;
        }
    }

    /// The circles of types that matter. Of a type on a circle one type comes that matters, and no other: two letters on the left of a factor with
    /// two on the right of it go over into those of one factor, and those of what comes of it are all such, so in a circle none are left for
    /// another one.
    void find_circles() {
        for (std::size_t i = 0; i < types_.size(); ++i) {
            task_.budget.check();
            if (!types_[i].matters || types_[i].circle != none) continue;
            std::set<std::size_t> found;
            std::vector<std::size_t> open{i};
            while (!open.empty()) {
                const std::size_t at = open.back();
                open.pop_back();
                for (const auto& [to, added] : types_[at].next)
                    if (types_[to].matters && found.insert(to).second) open.push_back(to);
            }
            if (!found.contains(i)) continue;
            std::size_t steps = 0;
            for (std::size_t at = i; steps == 0 || at != i; ++steps) {
                types_[at].circle = i;
                at = next_on_circle(at).first;
            }
            steps_ = std::lcm(steps_, steps);
            expect_small(steps_, "steps round a circle of groups");
        }
    }
    /// The only type that comes of one on a circle and matters, and what is added.
    const std::pair<std::size_t, Numbers>& next_on_circle(std::size_t at) const {
        const std::pair<std::size_t, Numbers>* found = nullptr;
        for (const auto& one : types_[at].next)
            if (types_[one.first].matters) {
                if (found)
                    throw BoundReached(Bound::method, "circles of groups that meet are not judged");
                found = &one;
            }
        return *found;
    }

    void collect_here(std::size_t at, const Numbers& numbers, Sums& found) const {
        for (const auto& [added, sum] : types_[at].ends)
            found.emplace_back(length(types_[at].level, numbers, added), sum);
    }

    /// Adds the sums of what comes of a group.
    void follow(std::size_t at, const Numbers& numbers) {
        task_.budget.check();
        if (!types_[at].matters) return;
        if (types_[at].circle != none) return go_round(at, numbers);
        Sums found;
        collect_here(at, numbers, found);
        for (const auto& [one, sum] : found) add(one, sum);
        for (const auto& [to, added] : types_[at].next)
            follow(to, image(cuts_[above(types_[at].level)], numbers) + added);
    }

    /// The same of a group on a circle: the lengths at each place satisfy a recurrence of one term more than there are letters, as soon as nilpotent
    /// parts are gone, so two places have the same lengths for ever if they have so many in a row.
    void go_round(std::size_t at, Numbers numbers) {
        std::size_t terms = 0;
        for (const Cut& one : cuts_) terms = std::max(terms, one.letters + 1);
        const std::size_t most_rounds = 5 * terms + 20;
        std::vector<Stream> own;
        for (std::size_t i = 0; i < most_rounds; ++i) {
            Sums found;
            for (std::size_t step = 0; step < steps_; ++step) {
                collect_here(at, numbers, found);
                const auto& [to, added] = next_on_circle(at);
                numbers = image(cuts_[above(types_[at].level)], numbers) + added;
                at = to;
            }
            own.resize(found.size());
            for (std::size_t k = 0; k < found.size(); ++k) {
                if (i < terms)
                    add(found[k].first, found[k].second);
                else
                    own[k].lengths.push_back(found[k].first);
                own[k].sum = found[k].second;
            }
        }
        for (Stream& one : own) join(std::move(one), terms + 1);
    }

    /// Adds a stream to one that has the same lengths from some place on. What stands before that place is added by itself.
    void join(Stream one, std::size_t needed) {
        const auto cut = [&](Stream& stream, std::size_t before) {
            for (std::size_t i = 0; i < before; ++i) add(stream.lengths[i], stream.sum);
            stream.lengths.erase(stream.lengths.begin(),
                                 stream.lengths.begin() + static_cast<std::ptrdiff_t>(before));
        };
        const auto place = [&](const Stream& in, const Stream& of) {
            const auto to = of.lengths.begin() + static_cast<std::ptrdiff_t>(needed);
            const auto at =
                std::search(in.lengths.begin(), in.lengths.end(), of.lengths.begin(), to);
            return at == in.lengths.end() ? none
                                          : static_cast<std::size_t>(at - in.lengths.begin());
        };
        for (Stream& known : streams_) {
            if (known.lengths.size() < needed) continue;
            if (const std::size_t at = place(known, one); at != none) {
                cut(known, at);
                known.sum += one.sum;
                return;
            }
            if (const std::size_t at = place(one, known); at != none) {
                cut(one, at);
                known.sum += one.sum;
                return;
            }
        }
        streams_.push_back(std::move(one));
    }

    const Obligation& task_;
    std::vector<Cut> cuts_;
    std::size_t before_ = 0;
    std::size_t steps_ = 1;  // after which all circles are where they were
    std::vector<Type> types_;
    std::map<std::pair<std::size_t, Group>, std::size_t> numbers_;
    std::map<Integer, std::int64_t> sums_;
    std::vector<Stream> streams_;
};

/// The number `of`, once, and nothing else.
bool is_name(const LinearSum& sum, const std::string& of) {
    return sum.plus.is_zero() && sum.of.size() == 1 && sum.of.begin()->first == of &&
           sum.of.begin()->second == 1;
}

/// Whether it says of i that no j < i has the same factor of n letters.
bool is_first_place(const Formula& said) {
    using Kind = Formula::Kind;
    if (said.kind != Kind::negation || said.parts[0].kind != Kind::exists) return false;
    const Formula& some = said.parts[0];
    if (some.names.size() != 1 || some.parts[0].kind != Kind::conjunction) return false;
    const std::string& j = some.names[0];
    const std::vector<Formula>& parts = some.parts[0].parts;
    if (parts.size() != 2 || parts[0].kind != Kind::less || parts[1].kind != Kind::equal)
        return false;
    const LinearSum& apart = parts[0].terms[0];
    return apart.plus.is_zero() && apart.of == std::map<std::string, Integer>{{"i", -1}, {j, 1}} &&
           is_name(parts[1].terms[0], "i") && is_name(parts[1].terms[1], j) &&
           is_name(parts[1].terms[2], "n");
}

}  // namespace

void check_bispecial(const Obligation& task) {
    const CountedPlaces& said = *task.statement.counted;
    if (said.parts.size() != 1 || !is_first_place(said.parts[0].second))
        task.refuse("the statement is not about the number of factors of n letters alone");
    std::map<Integer, std::int64_t> known;
    for (const Field& each : task.proof.at("sums").list()) {
        const auto [n, sum] = each.pair();
        const Integer value = sum.integer(true);
        if (value.is_zero() || !value.fits_int64())
            sum.fail("expected a small number that is not 0");
        if (!known.emplace(n.integer(), value.to_int64()).second)
            n.fail("this length stands here twice");
    }
    Bispecial bispecial(task);
    if (bispecial.sums() != known) task.refuse("the sums over the bispecial factors are others");
    // p(n) is linear behind the last length.
    const Integer last = known.empty() ? Integer(0) : known.rbegin()->first + 1;
    const Integer end = std::max(said.from, last) + 1;
    if (end > Integer(most))
        throw BoundReached(Bound::method, "lengths are more than are looked at");
    Integer now = 1, next = bispecial.letters();
    for (Integer n = 0; n <= end; n += 1) {
        if (n >= said.from && !(said.parts[0].first * now + said.slope * n + said.plus).is_zero())
            task.refuse("there are " + to_string(now) + " factors of " + to_string(n) + " letters");
        const auto at = known.find(n);
        Integer after = next + next - now + Integer(at == known.end() ? 0 : at->second);
        now = std::exchange(next, std::move(after));
    }
}

}  // namespace algae::verify
