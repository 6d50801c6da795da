#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

#include "growth/growth.hpp"
#include "language/detail/equality.hpp"
#include "language/detail/letters.hpp"
#include "language/detail/progressions.hpp"

// Whether the language of a D0L system is regular, where its lengths grow linearly. Finite languages are regular, and where lengths grow
// faster they are too few (`steps::Sparse`), so this decides all that is left.
//
// The words. Let h be the rules, and m the number of accessible letters. Each letter grows linearly or is bounded. A letter that
// grows becomes, after m steps at most, words in which the only letters that grow are on cycles of letters, each of which has one letter that
// grows in the successor of another: if a letter made two that grow, or one beside its cycle, lengths would grow faster. So let p be a
// common multiple of the lengths of all cycles of letters that last, g = h^p. For a letter c on a cycle g(c) = x c y, where all
// letters of x and y are bounded, and what g^k makes of bounded letters is the same for all k from some K on. So for words in which
// all letters that grow are on cycles g^(K+n)(c) = X^n z Y^n with z = g^K(c), X = g^K(x), Y = g^K(y) and g(X) = X, g(Y) = Y. Hence
// the generations first + n p are u_0 v_1^n u_1 v_2^n ... v_k^n u_k, n = 0, 1, ..., with words v_i that are not empty.
//
// Theorem. Let q be the length of the shortest word of which v_1 is a power. L(G) is regular if and only if, in each of the p sections from first,
// first + 1, ..., on, q divides the lengths of all v_i, and v_1 u_1 v_2 ... u_(k-1) v_k has the period q.
// Proof. If so, the word with n in the place of 1 has this period for all n: where a word has the period q, and in it stands a factor whose length
// is a multiple of q, this factor may be written twice or left out. So each of these words is a beginning of rho^omega, where v_1 is a power of rho,
// |rho| = q, and the section is u_0 (rho^e)* x u_k for some e and x. A finite union of such languages and of a finite one is regular.
// Let L(G) be regular. It has at most a constant times N words of length N or less, so it is a finite union of languages x y* z (Paun and
// Salomaa 1995), and one of these has infinitely many words of the section. For large n the power v_1^n overlaps that of y in
// more than |v_1| + |y| letters, and so does v_k^n; so v_1 and y are powers of words of the same length q (Fine and Wilf 1965), and
// what lies between the ends of these overlaps, hence all of v_1^n u_1 ... v_k^n, has the period q. The same is true of each v_i and y, so
// q divides its length, and the powers may be made shorter until n = 1. QED
//
// For the answer a shorter period and an earlier beginning are looked for. They are right where they show in three words: if w_(n+p) = u v x and
// w_(n+2p) = u v v x for w_n = u x, then w_(n+kp) = u v^k x for all k. (g(u) g(v)^k g(x) and u v v^k x are the same for k = 0 and k = 1, so
// v and g(v) have the same length; if g(u) is the shorter beginning, u v = g(u) t, g(x) = t x, and g(v) t = t v; and
// so they are for all k. Likewise if u v is the shorter one.)

namespace algae {

namespace {

class LinearGrowth {
public:
    LinearGrowth(const D0L& system, const Budget& budget)
        : system_(system), budget_(budget), futures_(letter_futures(ol_of(system))) {}

    std::variant<Progressions, SectionOfPowers> decided() {
        find_period();
        power_ = power_of_rules(system_, period_, budget_);
        find_settled();
        const std::uint64_t first = system_.letters.size() + period_ * settled_;
        add_words(system_.letters.size() + period_);
        for (std::uint64_t n = 0; n < period_; ++n) {
            budget_.check();
            SectionOfPowers section =
                section_of(words_[static_cast<std::size_t>(system_.letters.size() + n)], first + n);
            if (!has_one_period(section)) return section;
        }
        return shortest_form(first);
    }

private:
    std::size_t letters() const { return futures_.lasting.size(); }

    /// The letters on cycles of lasting letters, each with what follows it there, and the common multiple of the lengths of the cycles.
    void find_period() {
        next_.assign(letters(), std::nullopt);
        for (const Symbol a : system_.letters)
            if (futures_.lasting[a])
                for (const Symbol b : system_.successor(a))
                    if (futures_.lasting[b] && futures_.component[a] == futures_.component[b])
                        next_[a] = b;
        for (const Symbol a : system_.letters) {
            if (!next_[a]) continue;
            std::uint64_t length = 1;
            for (Symbol b = *next_[a]; b != a; b = *next_[b]) ++length;
            period_ = std::lcm(period_, length);
            budget_.check_memory(period_ * sizeof(Word), "the words of a period");
        }
    }

    Word applied(Word word, std::uint64_t times) const {
        for (; times > 0; --times) word = generation_after(power_, word, budget_);
        return word;
    }

    /// How often the power of the rules is applied until nothing changes any more.
    std::uint64_t steps_to_rest(Word word) const {
        for (std::uint64_t steps = 0;; ++steps) {
            Word next = generation_after(power_, word, budget_);
            if (next == word) return steps;
            word = std::move(next);
        }
    }

    bool is_turning(Symbol a) const { return futures_.growing[a] && next_[a]; }

    /// Where the letter stands in what it becomes.
    std::ptrdiff_t own_place(Symbol a) const {
        return std::find(power_[a].begin(), power_[a].end(), a) - power_[a].begin();
    }
    Word left_of(Symbol a) const {
        return Word(power_[a].begin(), power_[a].begin() + own_place(a));
    }
    Word right_of(Symbol a) const {
        return Word(power_[a].begin() + own_place(a) + 1, power_[a].end());
    }

    void find_settled() {
        for (const Symbol a : system_.letters)
            if (!futures_.growing[a]) {
                settled_ = std::max(settled_, steps_to_rest({a}));
            } else if (is_turning(a)) {
                settled_ = std::max(settled_, steps_to_rest(left_of(a)));
                settled_ = std::max(settled_, steps_to_rest(right_of(a)));
            }
    }

    /// The section of the generations that `settled_` powers of the rules and more make of a word.
    SectionOfPowers section_of(const Word& word, std::uint64_t first) const {
        SectionOfPowers section{first, period_, {}};
        for (const Symbol a : word) {
            SectionOfPowers::Part part{{}, applied({a}, settled_), {}};
            if (is_turning(a)) {
                part.left = applied(left_of(a), settled_);
                part.right = applied(right_of(a), settled_);
            }
            const bool rests = part.left.empty() && part.right.empty();
            if (rests && !section.parts.empty() && section.parts.back().left.empty() &&
                section.parts.back().right.empty()) {
                Word& last = section.parts.back().word;
                last.insert(last.end(), part.word.begin(), part.word.end());
            } else if (!rests || !part.word.empty()) {
                section.parts.push_back(std::move(part));
            }
        }
        return section;
    }

    /// Whether v_1 u_1 v_2 ... v_k has the period of v_1, which divides the lengths of all v_i.
    static bool has_one_period(const SectionOfPowers& section) {
        Word whole;
        std::size_t period = 0, end = 0;  // of the last power
        bool is_multiple = true;
        const auto add = [&](const Word& word, bool is_power) {
            if (word.empty()) return;
            if (is_power && period == 0) period = shortest_period(word);
            if (period == 0) return;
            whole.insert(whole.end(), word.begin(), word.end());
            if (!is_power) return;
            is_multiple = is_multiple && word.size() % period == 0;
            end = whole.size();
        };
        for (const SectionOfPowers::Part& part : section.parts) {
            add(part.left, true);
            add(part.word, false);
            add(part.right, true);
        }
        for (std::size_t i = period; is_multiple && i < end; ++i)
            is_multiple = whole[i] == whole[i - period];
        return is_multiple;
    }

    /// The length of the shortest word of which this one is a power.
    static std::size_t shortest_period(const Word& word) {
        for (std::size_t length = 1; length < word.size(); ++length)
            if (word.size() % length == 0 &&
                std::equal(word.begin() + static_cast<std::ptrdiff_t>(length), word.end(),
                           word.begin()))
                return length;
        return word.size();
    }

    void add_words(std::uint64_t count) {
        if (words_.empty()) words_.push_back(system_.axiom);
        while (words_.size() < count) {
            budget_.check();
            words_.push_back(system_.rules(words_.back()));
            size_ += words_.back().size() + 8;
            budget_.check_memory(size_ * sizeof(Symbol), "the words of a period");
        }
    }

    /// u, v and x for generations n, n + period, ..., if they are u v^k x.
    std::optional<Progressions::Part> progression(std::uint64_t n, std::uint64_t period) {
        add_words(n + 2 * period + 1);
        const Word &word = words_[static_cast<std::size_t>(n)],
                   &next = words_[static_cast<std::size_t>(n + period)];
        if (next.size() <= word.size()) return std::nullopt;
        const auto place =
            std::mismatch(word.begin(), word.end(), next.begin(), next.end()).first - word.begin();
        const auto more = static_cast<std::ptrdiff_t>(next.size() - word.size());
        Progressions::Part part{Word(word.begin(), word.begin() + place),
                                Word(next.begin() + place, next.begin() + place + more),
                                Word(word.begin() + place, word.end())};
        Word made = part.before;
        for (const Word* each : {&part.repeated, &part.behind})
            made.insert(made.end(), each->begin(), each->end());
        if (made != next) return std::nullopt;
        made.insert(made.begin() + place, part.repeated.begin(), part.repeated.end());
        if (made != words_[static_cast<std::size_t>(n + 2 * period)]) return std::nullopt;
        return part;
    }

    /// What is regular from generation `first` on, with the shortest period.
    Progressions shortest_form(std::uint64_t first) {
        for (std::uint64_t period = 1;; ++period) {
            if (period_ % period != 0) continue;
            Progressions found{first, period, {}, {}};
            for (std::uint64_t n = first; n < first + period; ++n) {
                auto part = progression(n, period);
                if (!part) break;
                found.parts.push_back(std::move(*part));
            }
            // The theorem promises it for `period_` itself.
            if (found.parts.size() < period) continue;
            while (found.first > 0) {
                auto part = progression(found.first - 1, period);
                if (!part) break;
                --found.first;
                found.parts.insert(found.parts.begin(), std::move(*part));
                found.parts.pop_back();
            }
            found.words.assign(words_.begin(),
                               words_.begin() + static_cast<std::ptrdiff_t>(found.first));
            return found;
        }
    }

    const D0L& system_;
    const Budget& budget_;
    LetterFutures futures_;
    std::vector<std::optional<Symbol>> next_;  // on its cycle, by symbol
    std::uint64_t period_ = 1;
    std::uint64_t settled_ = 0;  // powers of the rules after which bounded letters have settled
    std::vector<Word> power_;    // of the rules: images of letters
    std::vector<Word> words_;    // generations
    std::uint64_t size_ = 0;     // letters of these
};

}  // namespace

std::optional<std::variant<Progressions, SectionOfPowers>> regularity(const D0L& system,
                                                                      const Budget& budget) {
    const GrowthOrder order = growth_class(system, budget).order;
    if (order.kind != GrowthKind::polynomial || order.degree != 1) return std::nullopt;
    return LinearGrowth(system, budget).decided();
}

Language as_expression(const Progressions& progressions) {
    Language all = progressions.words.empty() ? nullptr : words_language(progressions.words);
    for (const Progressions::Part& part : progressions.parts) {
        Language one = combined(LanguageTree::Kind::star, {words_language({part.repeated})});
        if (!part.before.empty())
            one = combined(LanguageTree::Kind::concatenated, {words_language({part.before}), one});
        if (!part.behind.empty())
            one = combined(LanguageTree::Kind::concatenated, {one, words_language({part.behind})});
        all = all ? combined(LanguageTree::Kind::united, {all, one}) : one;
    }
    return all;
}

}  // namespace algae
