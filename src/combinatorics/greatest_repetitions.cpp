#include <algorithm>
#include <set>

#include "combinatorics/detail/levels.hpp"

// The repetitions of an infinite word that its critical exponent depends on.
//
// Repetitions are traced in the same way. A factor with the period p is a word v that occurs again p letters later; where no letter prolongs it, other
// letters stand before the two v, and others behind. If v has a 1, the cuts in both v are the same, so v = s T(v') 1 p where v' occurs twice in u' and
// is not prolonged either: the letters around v' alone say which s, p and letters around v there are. The critical exponent is the least upper bound of 1 + |v|/p.
// A word without 1 occurs twice with periods as long as you like, but only the least ones in every letter matter: beyond a length
// that is worked out, |v|/p of all images stays below what others have.

namespace algae {

namespace {

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
    Repeating(const std::vector<DerivedLevel>& levels, std::size_t before, const Budget& budget)
        : budget_(budget), levels_(levels), before_(before), letters_(levels[before].letters()) {}

    GreatestRepetitions found() {
        GreatestRepetitions all;
        for (const DerivedLevel& level : levels_)
            all.periodic = all.periodic || level.letters() == 1;
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
    const std::vector<DerivedLevel>& levels_;
    std::size_t before_, letters_;
    Counts growing_;
    std::vector<std::set<std::pair<Symbol, Symbol>>> pairs_;
    std::vector<Greatest> roots_;  // by level
};

}  // namespace

GreatestRepetitions greatest_repetitions(const Morphism& h, Symbol a, const Budget& budget) {
    DerivedWords all = derived_words(h, a, budget);
    const std::size_t before = all.before;
    return Repeating(levels_of(std::move(all)), before, budget).found();
}

}  // namespace algae
