#include "growth/pansiot.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "growth/factors.hpp"
#include "growth/growth_class.hpp"
#include "growth/pushy.hpp"
#include "growth/repetitions.hpp"
#include "word/alphabet.hpp"

namespace algae {

std::string to_string(ComplexityClass value) {
    static const char* const names[] = {"0", "1", "n", "n log log n", "n log n", "n^2"};
    return names[static_cast<std::size_t>(value)];
}

namespace {

using enum ComplexityClass;

/// h^r(w) = core and h^(r+q)(w) = left core right.
struct Core {
    std::size_t r = 0, q = 0;
    Word core, left, right;
};

constexpr std::size_t longest_core = 100'000;  // letters of the words that are looked through for one

/// What one side of a core, or all letters of a system, say.
struct Side {
    ComplexityClass at_most = constant;
    std::string because;
};

/// A place between growing letters: the growing letter before, letters that do not grow, the growing one after.
struct Place {
    Word left, between, right;
    bool operator==(const Place&) const = default;
    bool operator<(const Place& other) const {
        return std::tie(left, between, right) < std::tie(other.left, other.between, other.right);
    }
};

/// How often each letter occurs in each image.
GrowthMatrix occurrences(const std::vector<Word>& images) {
    GrowthMatrix matrix;
    for (const Word& word : images) {
        std::map<std::size_t, Integer> counts;
        for (const Symbol b : word) counts[b] += 1;
        auto& row = matrix.rows.emplace_back();
        for (const auto& [b, times] : counts) row.push_back({b, times});
    }
    return matrix;
}

class Decision {
public:
    Decision(const D0L& system, const Budget& budget)
        : named_(system), budget_(budget), system_(skeleton(system)), growing_(growing_letters(system_.images)),
          orders_(letter_orders(components(occurrences(system_.images), budget))) {
        const auto lifetime = lifetimes(system.rules.images);
        vanishing_ = std::any_of(system.letters.begin(), system.letters.end(), [&](Symbol a) { return lifetime[a] != lasts; });
    }

    ComplexityOrder order() const {
        if (!has_growing(accessible_letters(system_.images, system_.axiom)))
            return {zero, zero, "the language is finite: no letter of the axiom grows"};
        const Side all = side(system_.axiom);
        const auto core = core_of(system_.axiom);
        ComplexityOrder best{constant, all.at_most, all.because};
        if (core) {
            best = of_core(*core, system_.axiom);
        } else if (all.at_most == linear) {
            best = bounded_or_linear({system_.axiom, system_.images}, all.because);
        } else {
            lower_bound(best);
        }
        return best;
    }

private:
    bool has_growing(const std::vector<char>& letters) const {
        for (Symbol a = 0; a < letters.size(); ++a)
            if (letters[a] && growing_[a]) return true;
        return false;
    }
    const std::string& name(Symbol a) const { return named_.alphabet->name(a); }
    std::string text(const Word& word) const {
        if (word.size() <= 40) return spell(*named_.alphabet, word);
        return spell(*named_.alphabet, Word(word.begin(), word.begin() + 40)) + "... (" +
               std::to_string(word.size()) + " letters)";
    }

    /// The class of an infinite word v h^q(v) h^(2q)(v) ..., exact but for linear, which may be constant.
    Side side(const Word& v) const {
        const auto letters = accessible_letters(system_.images, v);
        if (!has_growing(letters)) return {constant, "only letters that do not grow follow"};
        if (const auto pusher = pusher_of(system_.images, v, budget_))
            return {quadratic, "the letter " + name(pusher->letter) + " pushes letters that do not grow before it (" +
                                   text(pusher->run) + " every " + steps(pusher->steps) +
                                   "): pushy, and not ultimately periodic (Pansiot 1984)"};
        std::optional<Symbol> first;
        std::optional<std::pair<Symbol, Symbol>> rates, exponents;
        for (Symbol a = 0; a < letters.size(); ++a) {
            if (!letters[a] || !growing_[a]) continue;
            if (!first) first = a;
            if (orders_[a].rate != orders_[*first].rate) rates = {*first, a};
            if (orders_[a].degree != orders_[*first].degree) exponents = {*first, a};
        }
        if (rates)
            return {n_log_n, "not pushy, and the letters " + name(rates->first) + " and " + name(rates->second) +
                                 " grow at different rates (Pansiot 1984)"};
        if (exponents)
            return {n_log_log_n, "not pushy, and the letters " + name(exponents->first) + " and " +
                                     name(exponents->second) +
                                     " grow at the same rate with different powers of n (Pansiot 1984)"};
        return {linear, "not pushy, and all growing letters grow at the same rate (Pansiot 1984)"};
    }

    static std::string steps(std::size_t count) {
        return count == 1 ? "step" : std::to_string(count) + " steps";
    }

    std::optional<Core> core_of(const Word& axiom) const {
        std::vector<Word> words{axiom};
        for (std::size_t n = 1; n <= 2 * system_.images.size() + 2; ++n) {
            words.push_back(image(system_.images, words.back()));
            const Word& word = words.back();
            if (word.size() > longest_core) return std::nullopt;
            budget_.check();
            for (std::size_t r = n; r-- > 0;) {
                const Word& core = words[r];
                if (core.size() >= word.size()) continue;
                const auto at = std::search(word.begin(), word.end(), core.begin(), core.end());
                if (at != word.end())
                    return Core{r, n - r, core, Word(word.begin(), at),
                                Word(at + static_cast<std::ptrdiff_t>(core.size()), word.end())};
            }
        }
        return std::nullopt;
    }

    ComplexityOrder of_core(const Core& core, const Word& axiom) const {
        const std::string where =
            core.left.empty() ? "the words begin one another" : core.right.empty() ? "the words end one another"
                                                                                   : "the words contain one another";
        const Side left = side(core.left), right = side(core.right);
        const Side& more = left.at_most > right.at_most ? left : right;
        if (more.at_most > linear) return {more.at_most, more.at_most, where + "; " + more.because};
        if (!core.left.empty() && !core.right.empty() && (left.at_most == constant || right.at_most == constant))
            return {linear, linear, where + ", on one side of them only letters that do not grow follow, ever more of "
                                            "them: the factors that reach over the last growing letter there are "
                                            "counted by where it stands in them, the others are at most linear"};
        if (more.at_most == linear) return bounded_or_linear({axiom, system_.images}, where + "; " + more.because);
        return {constant, constant, where + ", and outside one of them only letters that do not grow follow: "
                                            "the infinite word is ultimately periodic"};
    }

    /// Letters that occur in one of their own images give bounds from below.
    void lower_bound(ComplexityOrder& best) const {
        const auto accessible = accessible_letters(system_.images, system_.axiom);
        std::optional<ComplexityOrder> found;
        Symbol letter = 0;
        for (Symbol a = 0; a < accessible.size(); ++a) {
            if (!accessible[a] || !growing_[a]) continue;
            const auto core = core_of({a});
            if (!core) continue;
            const ComplexityOrder order = of_core(*core, {a});
            if (!found || found->at_least < order.at_least) {
                found = order;
                letter = a;
            }
        }
        const std::string above = best.because;
        if (found) best.at_least = found->at_least;
        if (best.is_decided()) {
            best.because = "the words that " + name(letter) + " derives are as complex already: " + found->because;
        } else {
            best.because = "at least: " + (found ? "the words that " + name(letter) + " derives; " + found->because
                                                 : std::string("the language is infinite")) +
                           ". At most: " + above;
        }
    }

    /// Not pushy, and all growing letters that occur grow alike: at most linear.
    ComplexityOrder bounded_or_linear(const Iterated& system, const std::string& above) const {
        const auto repetitions = growing_repetitions(system, budget_);
        if (repetitions.empty())
            return {linear, linear, above + "; not ultimately periodic, because no word is repeated without end"};
        if (const auto place = lasting_place(system, repetitions))
            return {linear, linear, above + "; not ultimately periodic, because " + text(*place) +
                                        " comes back without end and is no part of a word repeated without end"};
        for (const std::size_t length : {16u, 64u, 256u}) {
            const auto complexity = factor_complexity(system, length, budget_);
            for (std::size_t k = 1; k <= length; ++k)
                if (complexity[k] <= k)
                    return {constant, constant, "p(" + std::to_string(k) + ") = " + std::to_string(complexity[k]) +
                                                    " is not more than " + std::to_string(k) +
                                                    (vanishing_ ? ", letters that vanish left out" : "") +
                                                    ": bounded (Balogh and Bollobas 2005), and the language is "
                                                    "infinite"};
        }
        return {constant, linear, above + "; whether ultimately periodic is open: p(k) > k for k up to 256, and every "
                                          "place is part of a word repeated without end"};
    }

    /// The letters around some place between growing letters that come back in infinitely many words,
    /// ever farther from their ends, though no repetition has them.
    std::optional<Word> lasting_place(const Iterated& system, const std::vector<InfiniteRepetition>& repetitions) const {
        std::size_t reach = 0;
        for (const auto& repetition : repetitions) reach = std::max(reach, repetition.word.size());
        reach = 2 * reach + 2;
        std::set<Place> seen;
        std::vector<Place> starts;
        const auto see = [&](const Word& word) {
            std::optional<std::size_t> before;
            for (std::size_t i = 0; i < word.size(); ++i) {
                if (!growing_[word[i]]) continue;
                if (before)
                    starts.push_back({{word[*before]},
                                      Word(word.begin() + static_cast<std::ptrdiff_t>(*before) + 1,
                                           word.begin() + static_cast<std::ptrdiff_t>(i)),
                                      {word[i]}});
                before = i;
            }
        };
        see(system.axiom);
        const auto accessible = accessible_letters(system.images, system.axiom);
        for (Symbol a = 0; a < accessible.size(); ++a)
            if (accessible[a]) see(system.images[a]);
        for (const Place& start : starts) {
            std::vector<Place> path;
            std::map<Place, std::size_t> when;
            for (Place place = start;;) {
                if (seen.contains(place)) break;  // its cycle has been looked at
                const auto [again, is_new] = when.emplace(place, path.size());
                if (!is_new) {
                    for (std::size_t i = again->second; i < path.size(); ++i)
                        if (const Word around = joined(path[i]); !is_repeated(around, repetitions)) return around;
                    break;
                }
                path.push_back(place);
                place = next(place, system.images, reach);
                budget_.check();
            }
            seen.insert(path.begin(), path.end());
        }
        return std::nullopt;
    }

    static Word joined(const Place& place) {
        Word word = place.left;
        word.insert(word.end(), place.between.begin(), place.between.end());
        word.insert(word.end(), place.right.begin(), place.right.end());
        return word;
    }
    static bool is_repeated(const Word& word, const std::vector<InfiniteRepetition>& repetitions) {
        return std::any_of(repetitions.begin(), repetitions.end(),
                           [&](const auto& repetition) { return is_factor_of_powers(word, repetition.word); });
    }
    static Place next(const Place& place, const std::vector<Word>& images, std::size_t reach) {
        Place after{image(images, place.left), image(images, place.between), image(images, place.right)};
        if (after.left.size() > reach) after.left.erase(after.left.begin(), after.left.end() - static_cast<std::ptrdiff_t>(reach));
        if (after.right.size() > reach) after.right.resize(reach);
        return after;
    }

    const D0L& named_;
    const Budget& budget_;
    Iterated system_;
    std::vector<char> growing_;
    std::vector<GrowthOrder> orders_;
    bool vanishing_ = false;
};

}  // namespace

ComplexityOrder complexity_order(const D0L& system, const Budget& budget) { return Decision(system, budget).order(); }

}  // namespace algae
