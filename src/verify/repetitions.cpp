#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "verify/detail/words.hpp"

// The critical exponent of an infinite word, and circular systems, by windows.
//
// The critical exponent is the least upper bound of 1 + |v|/p, where v is a factor that occurs again p letters later and other letters stand
// before the two v, and others behind. The certificate says which number it is. That is shown again here.
//
// The word u is cut into return words as for bispecial factors (`cuts_of`): u = T(u'). If v has the first letter 1, it is s T(v') 1 p where v' occurs twice
// in u' and other letters stand around it; the letters around v' say which s and p there are. So all v come of those without 1, in finitely many words. Of
// these some have short periods, up to a length N, and are seen in the windows of N letters and a few. The others have long periods, and words shorter than a return word:
// N is taken so great that they and all that comes of them stay below the number.
//
// Let c be the number less 1, M the matrix of one round through the words that come back, and g a vector above 0 with M g - g >= 1. What is added to v in one
// round is at most A in each letter. If c p - v >= t g in each letter, t >= A, the same is so a round later, M (t g) - A >= t g, and for ever. That
// ends all chains but those whose exponents tend to the number itself. There d(k) = c |p(k)| - |v(k)| satisfies a linear recurrence of one term more than M
// has rows; the shortest one is found by so many values (Massey 1969), over the field of c. Without its root 1, the recurrence is that of d less its limit. If it
// has one root, the signs of a few numbers decide; if a power of its matrix is a contraction, finitely many values do. Other recurrences are not judged.
//
// A D0L system is circular with the delay D if all windows of D + 1 letters have a place where each word whose image they stand in is cut; all such words are found in
// the images of windows of D + 1 letters. If different letters have different images, and v is primitive and h^q(v) a power v'^e, e > 1, of a conjugate of v, and vv is a factor,
// then all v^k are factors and the system is not circular: a place with one cut would come back after |v| letters in v v v ..., where there are |v| cuts in e |v| letters; so
// |v|/e letters that come back would make v, which is primitive.

namespace algae::verify {

namespace {

using Numbers = std::vector<Integer>;
using Break = std::pair<Symbol, Symbol>;  // letters beside two occurrences; different ones

constexpr std::size_t most_letters = 4'000'000;  // of windows

[[noreturn]] void not_judged(const std::string& what) { throw BoundReached(Bound::method, what); }

std::vector<Ball> real_roots(const Polynomial& polynomial, long bits) {
    std::vector<Ball> found;
    for (const Root& one : roots(polynomial, bits))
        if (one.is_real) found.push_back(one.real);
    std::sort(found.begin(), found.end(),
              [](const Ball& x, const Ball& y) { return compare(x, y) == Order::less; });
    return found;
}

/// The field of a real root of an irreducible polynomial. Its numbers are polynomials in the root, of smaller degree.
class RootField {
public:
    using Number = std::vector<Rational>;

    RootField(const RealRoot& of, const Budget& budget)
        : of_(of), size_(static_cast<std::size_t>(of.polynomial.degree())), budget_(budget) {}

    Number number(const Rational& value) const {
        Number found(size_);
        found[0] = value;
        return found;
    }
    Number root() const {
        if (size_ == 1)
            return number(Rational(-of_.polynomial.coefficient(0), of_.polynomial.coefficient(1)));
        Number found(size_);
        found[1] = 1;
        return found;
    }
    Number sum(Number left, const Number& right) const {
        for (std::size_t i = 0; i < size_; ++i) left[i] = left[i] + right[i];
        return left;
    }
    Number times(Number left, const Rational& factor) const {
        for (Rational& one : left) one = one * factor;
        return left;
    }
    Number difference(const Number& left, const Number& right) const {
        return sum(left, times(right, Rational(-1)));
    }
    Number product(const Number& left, const Number& right) const {
        std::vector<Rational> all(2 * size_ - 1);
        for (std::size_t i = 0; i < size_; ++i)
            for (std::size_t k = 0; k < size_; ++k) all[i + k] = all[i + k] + left[i] * right[k];
        for (; all.size() > size_; all.pop_back()) {
            const Rational lead = all.back() / Rational(of_.polynomial.leading_coefficient());
            for (std::size_t i = 0; i <= size_; ++i) {
                Rational& one = all[all.size() - 1 - size_ + i];
                one = one - lead * Rational(of_.polynomial.coefficient(i));
            }
        }
        return all;
    }
    /// Of a number that is not 0.
    Number inverse(const Number& of) const {
        // of times x^k in column k, and 1 behind; solved by elimination.
        std::vector<std::vector<Rational>> rows(size_, std::vector<Rational>(size_ + 1));
        rows[0][size_] = 1;
        for (std::size_t k = 0; k < size_; ++k) {
            Number power(size_);
            power[k] = 1;
            const Number column = product(of, power);
            for (std::size_t i = 0; i < size_; ++i) rows[i][k] = column[i];
        }
        for (std::size_t k = 0; k < size_; ++k) {
            budget_.check();
            std::size_t pivot = k;
            while (rows.at(pivot)[k].is_zero()) ++pivot;
            std::swap(rows[k], rows[pivot]);
            const Rational lead = rows[k][k];
            for (Rational& one : rows[k]) one = one / lead;
            for (std::size_t i = 0; i < size_; ++i) {
                const Rational factor = rows[i][k];
                if (i == k || factor.is_zero()) continue;
                for (std::size_t j = 0; j <= size_; ++j)
                    rows[i][j] = rows[i][j] - factor * rows[k][j];
            }
        }
        Number found(size_);
        for (std::size_t i = 0; i < size_; ++i) found[i] = rows[i][size_];
        return found;
    }
    Ball enclosure(const Number& of, long bits) const {
        Ball sum(0, bits);
        for (std::size_t i = size_; i-- > 0;) sum = sum * root(bits) + Ball(of[i], bits);
        return sum;
    }
    int sign(const Number& of) const {
        if (std::all_of(of.begin(), of.end(), [](const Rational& one) { return one.is_zero(); }))
            return 0;
        for (long bits = 128;; bits *= 2) {
            budget_.check();
            if (const auto found = algae::sign(enclosure(of, bits))) return *found;
        }
    }

private:
    const Ball& root(long bits) const {
        auto at = roots_.find(bits);
        if (at == roots_.end())
            at = roots_.emplace(bits, real_roots(of_.polynomial, bits).at(of_.root)).first;
        return at->second;
    }

    const RealRoot& of_;
    std::size_t size_;
    const Budget& budget_;
    mutable std::map<long, Ball> roots_;
};

/// s[k] = found[0] s[k-1] + found[1] s[k-2] + ...: the shortest recurrence of a sequence that has one of at most half as many terms.
std::vector<RootField::Number> shortest_recurrence(const std::vector<RootField::Number>& sequence,
                                                   const RootField& field) {
    using Number = RootField::Number;
    std::vector<Number> now{field.number(1)}, then{field.number(1)};
    std::size_t length = 0, since = 1;
    Number last = field.number(1);
    for (std::size_t n = 0; n < sequence.size(); ++n) {
        Number difference = field.number(0);
        for (std::size_t i = 0; i <= length && i < now.size(); ++i)
            difference = field.sum(difference, field.product(now[i], sequence[n - i]));
        if (field.sign(difference) == 0) {
            ++since;
            continue;
        }
        const std::vector<Number> before = now;
        const Number scale = field.product(difference, field.inverse(last));
        now.resize(std::max(now.size(), then.size() + since), field.number(0));
        for (std::size_t i = 0; i < then.size(); ++i)
            now[i + since] = field.difference(now[i + since], field.product(scale, then[i]));
        if (2 * length <= n) {
            length = n + 1 - length;
            then = before;
            last = difference;
            since = 1;
        } else {
            ++since;
        }
    }
    now.resize(length + 1, field.number(0));
    std::vector<Number> found;
    for (std::size_t i = 1; i <= length; ++i) found.push_back(field.times(now[i], Rational(-1)));
    return found;
}

/// Windows of so many letters of the words that come of a word by a morphism, and those words that are shorter.
template <class Image>
std::set<Word> windows_of(const Word& axiom, std::size_t length, Image image,
                          const Budget& budget) {
    std::set<Word> found;
    std::vector<Word> open;
    std::size_t size = 0;
    const auto add = [&](const Word& word) {
        for (std::size_t begin = 0;; ++begin) {
            const auto from = word.begin() + static_cast<std::ptrdiff_t>(begin);
            Word window(from, from + static_cast<std::ptrdiff_t>(std::min(length, word.size())));
            if ((size += window.size()) > 100 * most_letters)
                not_judged("windows are more than are looked at");
            if (const auto [at, is_new] = found.insert(std::move(window)); is_new) {
                if (found.size() * length > most_letters)
                    not_judged("windows are more than are looked at");
                open.push_back(*at);
            }
            if (begin + length >= word.size()) return;
        }
    };
    add(axiom);
    while (!open.empty()) {
        budget.check();
        const Word word = std::move(open.back());
        open.pop_back();
        Word whole;
        for (const Symbol letter : word) {
            const Word& part = image(letter);
            whole.insert(whole.end(), part.begin(), part.end());
        }
        add(whole);
    }
    return found;
}

/// A word that occurs again, other letters around it: the letters before and behind the two, and how often letters are in it and in the distance.
struct Repetition {
    Break before, behind;
    Numbers word, period;
    bool operator<(const Repetition& other) const {
        return std::tie(before, behind, word, period) <
               std::tie(other.before, other.behind, other.word, other.period);
    }
};

Integer total(const Numbers& numbers) {
    Integer sum = 0;
    for (const Integer& one : numbers) sum += one;
    return sum;
}

class Repetitions {
public:
    Repetitions(const Obligation& task, const RealRoot& exponent)
        : task_(task), field_(exponent, task.budget), h_(morphism_of(task)) {
        Cuts found = cuts_of(h_, task);
        cuts_ = std::move(found.all);
        before_ = found.before;
        c_ = field_.difference(field_.root(), field_.number(1));
        if (field_.sign(c_) < 0) task.refuse("the exponent is below 1");
        least_ = field_.enclosure(c_, 128).lower();
    }

    /// Throws Flaw unless the number is the critical exponent.
    void check() {
        for (const Cut& one : cuts_)
            if (one.returns.size() == 1) task_.refuse("the word is periodic");
        find_growing();
        for (std::size_t level = 0; level < cuts_.size(); ++level) {
            std::size_t longest = 8;
            for (; !stays_below(level, longest); longest *= 2)
                if (longest > 4'096) not_judged("periods are longer than are looked at");
            for (const Repetition& one : roots(level, longest)) follow(level, one);
        }
        if (!is_reached_ && !is_near_)
            task_.refuse("exponents of factors stay below a smaller number");
    }

private:
    const Images& morphism(std::size_t level) const {
        return level == 0 ? h_ : cuts_[level - 1].next;
    }

    static Numbers image(const Cut& in, const Numbers& numbers) {
        Numbers found(in.letters);
        for (std::size_t b = 0; b < numbers.size(); ++b)
            if (!numbers[b].is_zero())
                for (const Symbol letter : in.returns[b]) found[letter] += numbers[b];
        return found;
    }
    /// The letters before the images, and what these have before them in common, which is added.
    static Break before(const Cut& in, const Break& of, Numbers& added) {
        const Word &x = in.returns[of.first], &y = in.returns[of.second];
        for (std::size_t i = 1;; ++i) {
            const Symbol a = x[x.size() - i], b = y[y.size() - i];
            if (a != b) return {a, b};
            added[a] += 1;
        }
    }
    static Break behind(const Cut& in, const Break& of, Numbers& added) {
        const Word &x = in.returns[of.first], &y = in.returns[of.second];
        for (std::size_t i = 0;; ++i) {
            const Symbol a = i < x.size() ? x[i] : 0, b = i < y.size() ? y[i] : 0;
            if (a != b) return {a, b};
            added[a] += 1;
        }
    }
    static Repetition image(const Cut& in, const Repetition& of) {
        Repetition found{{}, {}, image(in, of.word), image(in, of.period)};
        found.before = before(in, of.before, found.word);
        found.behind = behind(in, of.behind, found.word);
        return found;
    }
    /// At least what is added to an image in each letter.
    static Numbers most_added(const Cut& in) {
        Numbers first(in.letters), last(in.letters);
        const auto letters = static_cast<Symbol>(in.returns.size());
        for (Symbol x = 0; x < letters; ++x)
            for (Symbol y = 0; y < x; ++y) {
                Numbers front(in.letters), back(in.letters);
                before(in, {x, y}, front);
                behind(in, {x, y}, back);
                for (std::size_t a = 0; a < in.letters; ++a) {
                    first[a] = std::max(first[a], front[a]);
                    last[a] = std::max(last[a], back[a]);
                }
            }
        for (std::size_t a = 0; a < in.letters; ++a) first[a] += last[a];
        return first;
    }

    template <class Thing>
    Thing round(Thing of) const {
        for (std::size_t level = cuts_.size(); level-- > before_;) of = image(cuts_[level], of);
        return of;
    }
    template <class Thing>
    Thing in_word(std::size_t level, Thing of) const {
        while (level-- > 0) of = image(cuts_[level], of);
        return of;
    }
    /// Numbers that are at least those of all images, and the same without what is added.
    std::pair<Numbers, Numbers> bounded(std::size_t from, std::size_t to, Numbers most,
                                        Numbers least) const {
        for (std::size_t level = from; level-- > to;) {
            most = image(cuts_[level], most);
            const Numbers added = most_added(cuts_[level]);
            for (std::size_t a = 0; a < most.size(); ++a) most[a] += added[a];
            least = image(cuts_[level], least);
        }
        return {std::move(most), std::move(least)};
    }

    void find_growing() {
        const std::size_t letters = cuts_[before_].letters;
        growing_ = Numbers(letters);
        Numbers power(letters, Integer(1));
        const auto is_small = [](const Integer& one) { return one < 2; };
        for (std::size_t i = 0; std::any_of(power.begin(), power.end(), is_small); ++i) {
            task_.budget.check();
            if (i > 100 + letters * letters) not_judged("some letters do not come again and again");
            for (std::size_t a = 0; a < letters; ++a) growing_[a] += power[a];
            power = round(power);
        }
        const Numbers none(letters);
        Integer most = 1;
        for (const Integer& one : bounded(cuts_.size(), before_, none, none).first)
            most = std::max(most, one);
        most = std::max(most, total(bounded(before_, 0, none, none).first));
        for (Integer& one : growing_) one = one * most;
    }

    /// Whether these numbers, at the first word that comes back, show that exponents stay below the number for ever.
    bool is_far(const Numbers& word, const Numbers& period) const {
        for (std::size_t a = 0; a < word.size(); ++a)
            if (least_ * Rational(period[a]) < Rational(word[a] + growing_[a])) return false;
        return true;
    }

    std::set<Word> windows(std::size_t level, std::size_t length) const {
        const Images& h = morphism(level);
        Word beginning{0};
        while (beginning.size() < length) {
            Word next;
            for (const Symbol letter : beginning)
                next.insert(next.end(), h[letter].begin(), h[letter].end());
            beginning = std::move(next);
        }
        beginning.resize(length);
        return windows_of(
            beginning, length, [&](Symbol letter) -> const Word& { return h[letter]; },
            task_.budget);
    }

    /// Whether words without the first letter with longer periods, and all that comes of them, stay below the number.
    bool stays_below(std::size_t level, std::size_t longest) const {
        const Cut& cut = cuts_[level];
        Numbers most(cut.letters);
        for (const Word& word : cut.returns) {
            Numbers here(cut.letters);
            for (const Symbol letter : word) here[letter] += 1;
            for (std::size_t a = 1; a < cut.letters; ++a) most[a] = std::max(most[a], here[a]);
        }
        std::optional<Numbers> least;
        for (const Word& window : windows(level, longest + 1)) {
            Numbers here(cut.letters);
            for (const Symbol letter : window) here[letter] += 1;
            if (!least) least = here;
            for (std::size_t a = 0; a < cut.letters; ++a)
                (*least)[a] = std::min((*least)[a], here[a]);
        }
        if (level >= before_) {
            const auto [word, period] = bounded(level, before_, most, *least);
            return is_far(word, period);
        }
        const auto [word, period] = bounded(level, 0, most, *least);
        return least_ * Rational(total(period)) >= Rational(total(word));
    }

    /// Those of words without the first letter with periods up to this length.
    std::set<Repetition> roots(std::size_t level, std::size_t longest) const {
        const Cut& cut = cuts_[level];
        std::size_t most = 0;
        for (const Word& word : cut.returns) most = std::max(most, word.size());
        std::set<Repetition> found;
        for (const Word& window : windows(level, longest + most + 2)) {
            task_.budget.check();
            for (std::size_t p = 1; p <= longest; ++p) {
                if (window[0] == window[p]) continue;
                Repetition one{
                    {window[0], window[p]}, {}, Numbers(cut.letters), Numbers(cut.letters)};
                std::size_t i = 1;
                for (; window[i] == window[i + p] && window[i] != 0; ++i) one.word[window[i]] += 1;
                if (window[i] == window[i + p]) continue;  // the first letter is in it
                one.behind = {window[i], window[i + p]};
                for (i = 1; i <= p; ++i) one.period[window[i]] += 1;
                found.insert(std::move(one));
            }
        }
        return found;
    }

    /// c p - |v|, in the word itself.
    RootField::Number distance(const Repetition& in_the_word) const {
        return field_.difference(field_.times(c_, Rational(total(in_the_word.period))),
                                 field_.number(Rational(total(in_the_word.word))));
    }
    /// The same; throws Flaw if it is below 0.
    RootField::Number noted(const Repetition& in_the_word) {
        RootField::Number found = distance(in_the_word);
        const int sign = field_.sign(found);
        if (sign < 0)
            task_.refuse("a factor of " +
                         to_string(total(in_the_word.word) + total(in_the_word.period)) +
                         " letters with the period " + to_string(total(in_the_word.period)) +
                         " has a greater exponent");
        is_reached_ = is_reached_ || sign == 0;
        return found;
    }

    void follow(std::size_t level, Repetition one) {
        if (level < before_) {
            noted(in_word(level, std::move(one)));
            return;
        }
        while (level > before_) one = image(cuts_[--level], one);
        std::map<std::pair<Break, Break>, std::size_t> seen;
        constexpr std::size_t most_rounds = 40;  // after the first that has been seen before
        std::size_t rounds = 0, again = 0;
        for (std::size_t i = 0; rounds == 0 || i < again + most_rounds; ++i) {
            task_.budget.check();
            if (is_far(one.word, one.period)) return;
            noted(in_word(before_, one));
            const auto [at, is_new] = seen.try_emplace({one.before, one.behind}, i);
            if (!is_new && rounds == 0) {
                rounds = i - at->second;
                again = i;
                // What is followed to the limit once is not followed again.
                if (!limits_.insert(one).second) return;
            }
            one = round(std::move(one));
        }
        approach(std::move(one), rounds);
    }

    /// A chain whose exponents tend to the number.
    void approach(Repetition one, std::size_t rounds) {
        using Number = RootField::Number;
        const std::size_t terms = cuts_[before_].letters + 1;
        std::vector<Number> values;
        const auto at = [&](std::size_t k) -> const Number& {
            while (values.size() <= k) {
                task_.budget.check();
                values.push_back(noted(in_word(before_, one)));
                for (std::size_t i = 0; i < rounds; ++i) one = round(std::move(one));
            }
            return values[k];
        };
        at(terms);  // what nilpotent parts of the matrix do is over
        values.clear();
        at(2 * terms + 1);
        const std::vector<Number> recurrence = shortest_recurrence(values, field_);
        // x^n - ..., from the greatest power down, without the root 1.
        std::vector<Number> polynomial{field_.number(1)};
        for (const Number& one_term : recurrence)
            polynomial.push_back(field_.times(one_term, Rational(-1)));
        Number limit = field_.number(0);
        const auto at_one = [&] {
            Number sum = field_.number(0);
            for (const Number& term : polynomial) sum = field_.sum(sum, term);
            return sum;
        };
        if (recurrence.empty()) {
            is_reached_ = true;
            return;
        }
        if (field_.sign(at_one()) == 0) {
            for (std::size_t i = 1; i < polynomial.size(); ++i)
                polynomial[i] = field_.sum(polynomial[i], polynomial[i - 1]);
            polynomial.pop_back();
            const Number sum = at_one();
            if (field_.sign(sum) == 0) not_judged("exponents near the number are not judged");
            for (std::size_t i = 0; i < polynomial.size(); ++i)
                limit =
                    field_.sum(limit, field_.product(polynomial[i], at(polynomial.size() - 1 - i)));
            limit = field_.product(limit, field_.inverse(sum));
        }
        if (polynomial.size() == 1)
            is_near_ = true;  // all values are the same
        else if (polynomial.size() == 2)
            with_one_root(field_.times(polynomial[1], Rational(-1)), limit, at(0), rounds);
        else
            with_contraction(polynomial, limit, at);
    }

    [[noreturn]] void passes() const { task_.refuse("exponents of long factors pass the number"); }

    void with_one_root(const RootField::Number& root, const RootField::Number& limit,
                       const RootField::Number& first, std::size_t rounds) {
        const auto above = [&](int value) {
            return field_.sign(field_.difference(root, field_.number(Rational(value)))) > 0;
        };
        if (!above(-1)) not_judged("exponents near the number are not judged");
        if (!above(1)) {
            if (field_.sign(limit) < 0) passes();
            is_near_ = true;
            return;
        }
        if (field_.sign(field_.difference(first, limit)) < 0) passes();
        // Periods grow faster than the root.
        Numbers power(cuts_[before_].letters, Integer(1));
        for (std::size_t i = 0; i < 30; ++i) power = round(power);
        Numbers next = power;
        for (std::size_t i = 0; i < rounds; ++i) next = round(next);
        std::optional<Rational> growth;
        for (std::size_t a = 0; a < power.size(); ++a)
            if (const Rational here(next[a], power[a]); !growth || here < *growth) growth = here;
        if (field_.sign(field_.difference(root, field_.number(*growth))) < 0) is_near_ = true;
    }

    template <class At>
    void with_contraction(const std::vector<RootField::Number>& polynomial,
                          const RootField::Number& limit, At at) {
        if (field_.sign(limit) < 0) passes();
        if (field_.sign(limit) == 0) not_judged("exponents near the number are not judged");
        constexpr long bits = 256;
        const std::size_t size = polynomial.size() - 1;
        using Matrix = std::vector<std::vector<Ball>>;
        Matrix power(size, std::vector<Ball>(size, Ball(0, bits)));
        for (std::size_t i = 0; i + 1 < size; ++i) power[i][i + 1] = Ball(1, bits);
        for (std::size_t i = 0; i < size; ++i)
            power[size - 1][i] = -field_.enclosure(polynomial[size - i], bits);
        const auto contracts = [&] {
            for (const std::vector<Ball>& row : power) {
                Ball sum(0, bits);
                for (const Ball& one : row) sum += abs(one);
                if (compare(sum, Ball(1, bits)) != Order::less) return false;
            }
            return true;
        };
        std::size_t steps = 1;
        for (; !contracts(); steps *= 2) {
            task_.budget.check();
            if (steps > 1'000) not_judged("exponents near the number are not judged");
            Matrix square(size, std::vector<Ball>(size, Ball(0, bits)));
            for (std::size_t i = 0; i < size; ++i)
                for (std::size_t j = 0; j < size; ++j)
                    for (std::size_t k = 0; k < size; ++k)
                        square[i][j] += power[i][k] * power[k][j];
            power = std::move(square);
        }
        // As soon as so many values in a row are as near to the limit as that is to 0, all are.
        std::size_t near = 0;
        for (std::size_t k = 0; near < steps + size; ++k) {
            if (k > 10 * (steps + size) + 1'000)
                not_judged("exponents near the number are not judged");
            const Ball apart = abs(field_.enclosure(field_.difference(at(k), limit), bits));
            near = compare(apart, field_.enclosure(limit, bits)) == Order::less ? near + 1 : 0;
        }
        is_near_ = true;
    }

    const Obligation& task_;
    RootField field_;
    Images h_;
    std::vector<Cut> cuts_;
    std::size_t before_ = 0;
    RootField::Number c_;  // the number less 1
    Rational least_;       // a little less than that
    Numbers growing_;
    std::set<Repetition> limits_;
    bool is_reached_ = false, is_near_ = false;
};

std::strong_ordering compared(const RealRoot& left, const RealRoot& right) {
    if (left.polynomial == right.polynomial) return left.root <=> right.root;
    for (long bits = 64;; bits *= 2) {
        const Order order = compare(real_roots(left.polynomial, bits).at(left.root),
                                    real_roots(right.polynomial, bits).at(right.root));
        if (order == Order::less) return std::strong_ordering::less;
        if (order == Order::greater) return std::strong_ordering::greater;
    }
}

bool is_so(const std::string& comparison, std::strong_ordering order) {
    if (comparison == "=") return order == 0;
    if (comparison == "!=") return order != 0;
    if (comparison == "<") return order < 0;
    if (comparison == "<=") return order <= 0;
    return comparison == ">" ? order > 0 : order >= 0;
}

const Word& image_of(const System& system, Symbol letter) { return system.tables[0][letter][0]; }

Word image_of(const System& system, const Word& word) {
    Word found;
    for (const Symbol letter : word) {
        const Word& part = image_of(system, letter);
        found.insert(found.end(), part.begin(), part.end());
        if (found.size() > most_letters) not_judged("images are longer than are looked at");
    }
    return found;
}

/// The morphism is of a D0L system and erases no letter.
const System& without_erasing(const Obligation& task) {
    const System& system = task.system();
    if (!is_d0l(system)) task.refuse("the system is not D0L");
    for (const Symbol letter : accessible_letters(system, system.axiom))
        if (image_of(system, letter).empty()) task.refuse("a letter is erased");
    return system;
}

std::set<Word> factors_of(const System& system, const Word& axiom, std::size_t length,
                          const Budget& budget) {
    return windows_of(
        axiom, length, [&](Symbol letter) -> const Word& { return image_of(system, letter); },
        budget);
}

bool is_conjugate(const Word& one, const Word& other) {
    if (one.size() != other.size()) return false;
    Word twice = one;
    twice.insert(twice.end(), one.begin(), one.end());
    return std::search(twice.begin(), twice.end(), other.begin(), other.end()) != twice.end();
}

bool is_power_of_shorter(const Word& word) {
    for (std::size_t p = 1; p <= word.size() / 2; ++p)
        if (word.size() % p == 0 &&
            std::equal(word.begin() + static_cast<std::ptrdiff_t>(p), word.end(), word.begin()))
            return true;
    return false;
}

/// Different letters have different images.
void expect_different(const std::map<Symbol, Word>& images, const Obligation& task) {
    std::set<Word> all;
    for (const auto& [letter, image] : images)
        if (!all.insert(image).second) task.refuse("two letters have one image");
}

}  // namespace

void check_repetitions(const Obligation& task) {
    if (!task.statement.coding.empty()) not_judged("words with a coding are not judged");
    const RealRoot exponent = read_real_root(task.proof.at("exponent"));
    if (is_so(task.statement.family, compared(exponent, *task.statement.number)) != task.holds)
        task.refuse("the exponent shows the opposite");
    Repetitions(task, exponent).check();
}

void check_endless_repetition(const Obligation& task) {
    if (!task.statement.coding.empty()) not_judged("words with a coding are not judged");
    const Word word = task.word("word");
    if (word.empty()) not_judged("powers of a word whose letters do not grow are not judged");
    const System& system = without_erasing(task);
    Word axiom = system.axiom;
    if (task.statement.kind == Statement::Kind::critical_exponent) {
        const std::string& comparison = task.statement.family;
        if ((comparison == "!=" || comparison.starts_with('>')) != task.holds)
            task.refuse("an infinite exponent shows the opposite");
        axiom = {first_letter(task)};
    }
    Word square = word;
    square.insert(square.end(), word.begin(), word.end());
    if (!factors_of(system, axiom, square.size(), task.budget).contains(square))
        task.refuse("the square of the word is no factor");
    const Field power = task.proof.at("power");
    if (power.number() == 0 || power.number() > 10'000)
        power.refuse("expected a power from 1 to 10000");
    std::map<Symbol, Word> images;
    for (const Symbol letter : accessible_letters(system, system.axiom)) images[letter] = {letter};
    Word image = word;
    for (std::uint64_t i = 0; i < power.number(); ++i) {
        task.budget.check();
        image = image_of(system, image);
        for (auto& [letter, of] : images) of = image_of(system, of);
        if (task.statement.kind == Statement::Kind::circular) expect_different(images, task);
    }
    const auto period = static_cast<std::ptrdiff_t>(word.size());
    if (is_power_of_shorter(word)) task.refuse("the word is a power of a shorter one");
    if (image.size() <= word.size() || image.size() % word.size() != 0 ||
        !std::equal(image.begin() + period, image.end(), image.begin()) ||
        !is_conjugate(word, Word(image.begin(), image.begin() + period)))
        task.refuse("the image of the word is no power of one of its conjugates");
}

void check_synchronised(const Obligation& task) {
    const System& system = without_erasing(task);
    const std::uint64_t delay = task.proof.at("delay").number();
    if (delay >= most_letters) not_judged("windows are more than are looked at");
    const std::size_t length = static_cast<std::size_t>(delay) + 1;
    std::map<Word, std::set<std::size_t>> cuts;  // that all images have in common
    for (const Word& word : factors_of(system, system.axiom, length, task.budget)) {
        std::set<std::size_t> ends{0};
        Word image;
        for (const Symbol letter : word) {
            const Word& part = image_of(system, letter);
            image.insert(image.end(), part.begin(), part.end());
            ends.insert(image.size());
        }
        for (std::size_t begin = 0; begin + length <= image.size(); ++begin) {
            task.budget.check();
            std::set<std::size_t> here;
            for (auto at = ends.lower_bound(begin); at != ends.end() && *at <= begin + length; ++at)
                here.insert(*at - begin);
            const auto from = image.begin() + static_cast<std::ptrdiff_t>(begin);
            const auto [known, is_new] =
                cuts.try_emplace(Word(from, from + static_cast<std::ptrdiff_t>(length)), here);
            if (!is_new)
                std::erase_if(known->second, [&](std::size_t one) { return !here.contains(one); });
            if (known->second.empty())
                task.refuse("a factor of " + std::to_string(length) +
                            " letters has no place where all words are cut");
        }
    }
}

}  // namespace algae::verify
