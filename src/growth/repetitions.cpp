#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "combinatorics/combinatorics.hpp"
#include "growth/growth.hpp"
#include "word/word.hpp"

// Repetitions and the classes of factor complexity of D0L languages.
//
// A system is pushy if its words have arbitrarily long factors over letters that do not grow (Ehrenfeucht and Rozenberg 1983); two
// maps of letters decide it. All infinite repetitions are found by Klouda and Starosta's algorithm (2015), of which pushing
// letters give the first kind. Pansiot's theorem (1984) then tells the class of the complexity by how the letters grow.

namespace algae {

namespace {

/// Of a growing letter a: the last growing letter of h(a), and what stands behind it there.
struct LastGrowing {
    Symbol letter = 0;
    Word after;
};

LastGrowing last_growing(const Word& image, const std::vector<char>& growing) {
    const auto found =
        std::find_if(image.rbegin(), image.rend(), [&](Symbol b) { return growing[b] != 0; });
    return {*found, Word(found.base(), image.end())};
}

/// The letters that come round when each goes to the next, each cycle once, from the letter on at which it is entered
/// from the least letter that leads there; only those of letters that are `asked` for. `next` is called for these.
template <class Next>
std::vector<std::vector<Symbol>> cycles_of(const std::vector<char>& asked, Next next) {
    std::vector<std::vector<Symbol>> cycles;
    std::vector<std::size_t> seen(asked.size(), 0);  // the round in which it was seen
    std::size_t round = 0;
    for (Symbol start = 0; start < asked.size(); ++start) {
        if (!asked[start] || seen[start] != 0) continue;
        ++round;
        Symbol a = start;
        for (; seen[a] == 0; a = next(a)) seen[a] = round;
        if (seen[a] != round) continue;
        std::vector<Symbol>& cycle = cycles.emplace_back();
        do {
            cycle.push_back(a);
            a = next(a);
        } while (a != cycle.front());
    }
    return cycles;
}

/// The cycles of last growing letters of images, of accessible letters.
std::vector<std::vector<Symbol>> last_letter_cycles(const Morphism& rules,
                                                    const std::vector<char>& accessible,
                                                    const std::vector<char>& growing) {
    std::vector<char> both(rules.size());
    for (Symbol a = 0; a < both.size(); ++a) both[a] = accessible[a] && growing[a];
    return cycles_of(both, [&](Symbol a) { return last_growing(rules[a], growing).letter; });
}

/// What the first letter of such a cycle has behind it once it comes round: a letter b with `run` behind it becomes the
/// next one with what stands behind that in h(b), and then h(run). `what` names the word where it takes too much memory.
Word run_of(const Morphism& rules, const std::vector<Symbol>& cycle,
            const std::vector<char>& growing, const char* what, const Budget& budget) {
    Word run;
    for (const Symbol b : cycle) {
        Word longer = last_growing(rules[b], growing).after;
        const Word more = rules(run);
        longer.insert(longer.end(), more.begin(), more.end());
        run = std::move(longer);
        budget.check();
        budget.check_memory(run.size() * sizeof(Symbol), what);
    }
    return run;
}

}  // namespace

std::optional<Pusher> pusher_of(const Morphism& rules, const Word& word, const Budget& budget) {
    const auto accessible = accessible_letters(rules, word);
    const auto growing = growing_letters(rules);
    for (const bool left : {false, true}) {
        const Morphism way = left ? rules.mirrored() : rules;
        for (const auto& cycle : last_letter_cycles(way, accessible, growing)) {
            Word run = run_of(way, cycle, growing, "the word that a letter pushes", budget);
            if (run.empty()) continue;
            if (left) std::reverse(run.begin(), run.end());
            return Pusher{cycle.front(), cycle.size(), std::move(run), left};
        }
    }
    return std::nullopt;
}

std::optional<Pusher> pusher_of(const D0L& system, const Budget& budget) {
    const Iterated rest = skeleton(system);
    auto found = pusher_of(rest.rules, rest.axiom, budget);
    if (!found) return found;
    // Mortal letters within the run: the run as the system itself writes it.
    Word word{found->letter};
    for (std::size_t i = 0; i < found->steps; ++i) {
        word = system.rules(word);
        budget.check();
        budget.check_memory(word.size() * sizeof(Symbol), "the image of the letter that pushes");
    }
    const auto growing = growing_letters(system.rules);
    const auto grows = [&](Symbol a) { return growing[a] != 0; };
    if (found->left)
        found->run = Word(word.begin(), std::find_if(word.begin(), word.end(), grows));
    else
        found->run = Word(std::find_if(word.rbegin(), word.rend(), grows).base(), word.end());
    return found;
}

namespace {

void check_length(const Word& word, const Budget& budget) {
    budget.check();
    budget.check_memory(word.size() * sizeof(Symbol), "a word that is repeated without end");
}

/// The cycles of first letters of images, of growing letters.
std::vector<std::vector<Symbol>> first_letter_cycles(const Iterated& system,
                                                     const std::vector<char>& growing) {
    std::vector<char> asked(system.rules.size());
    for (Symbol a = 0; a < asked.size(); ++a) asked[a] = !system.rules[a].empty();
    auto cycles = cycles_of(asked, [&](Symbol a) { return system.rules[a].front(); });
    std::erase_if(cycles, [&](const auto& cycle) { return !growing[cycle.front()]; });
    return cycles;
}

/// The beginning of a word before a growing letter occurs in it a second time, if that letter is the
/// first one; `repeated` says whether any letter did.
std::optional<Word> before_return(const Word& word, const std::vector<char>& growing,
                                  bool& repeated) {
    std::set<Symbol> seen;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (growing[word[i]] && !seen.insert(word[i]).second) {
            repeated = true;
            if (word[i] != word.front()) return std::nullopt;
            return Word(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(i));
        }
    repeated = false;
    return std::nullopt;
}

/// How often `part` is written one after the other in the word; 0 if it is no power.
std::size_t exponent(const Word& word, const Word& part) {
    if (part.empty() || word.size() % part.size() != 0) return 0;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (word[i] != part[i % part.size()]) return 0;
    return word.size() / part.size();
}

/// The words v_i for which g(v_i) is a power of v_(i+1) around the cycle, and some power above 1.
std::optional<std::vector<Word>> periods(const Iterated& system, const std::vector<Symbol>& cycle,
                                         const std::vector<char>& growing, const Budget& budget) {
    const std::size_t q = cycle.size();
    std::vector<Word> begins;  // of the infinite words that the letters begin
    for (const Symbol a : cycle) begins.push_back({a});
    std::vector<std::optional<Word>> found(q);
    std::vector<char> settled(q, 0);
    // A second growing letter comes within as many rounds as there are letters, or never.
    for (std::size_t round = 0; round < q * (system.rules.size() + 1); ++round) {
        bool all = true;
        std::vector<Word> next(q);
        for (std::size_t i = 0; i < q; ++i) {
            const std::size_t j = (i + 1) % q;
            bool repeated = false;
            if (!settled[i]) {
                found[i] = before_return(begins[i], growing, repeated);
                if (repeated && !found[i]) return std::nullopt;
                settled[i] = repeated;
            }
            all = all && settled[i];
            next[j] = settled[j] ? begins[j] : system.rules(begins[i]);
            check_length(next[j], budget);
        }
        begins = std::move(next);
        if (all) break;
    }
    bool longer = false;
    std::vector<Word> words;
    for (std::size_t i = 0; i < q; ++i) {
        if (!found[i] || !found[(i + 1) % q]) return std::nullopt;
        const std::size_t times = exponent(system.rules(*found[i]), *found[(i + 1) % q]);
        if (times == 0) return std::nullopt;
        longer = longer || times > 1;
        words.push_back(*found[i]);
    }
    if (!longer) return std::nullopt;
    return words;
}

/// What a growing letter leaves behind it for ever: the images of `run` come back after some steps.
Word pushed(const Morphism& rules, const Word& run, std::size_t steps, const Budget& budget) {
    std::map<Word, std::size_t> seen;
    std::vector<Word> parts;
    for (Word part = run;;) {
        const auto [place, is_new] = seen.emplace(part, parts.size());
        if (!is_new) {
            Word all;  // the letter is followed by run, h^q(run), h^(2q)(run), ...
            for (std::size_t i = place->second; i < parts.size(); ++i)
                all.insert(all.end(), parts[i].begin(), parts[i].end());
            check_length(all, budget);
            return all;
        }
        parts.push_back(part);
        for (std::size_t i = 0; i < steps; ++i) part = rules(part);
        check_length(part, budget);
    }
}

}  // namespace

std::vector<InfiniteRepetition> growing_repetitions(const Iterated& system, const Budget& budget) {
    const Injective simple = made_injective(system, budget);
    const auto growing = growing_letters(simple.system.rules);
    std::map<Word, Symbol> found;
    for (const auto& cycle : first_letter_cycles(simple.system, growing))
        if (const auto words = periods(simple.system, cycle, growing, budget))
            for (const Word& word : *words)
                found.emplace(least_conjugate(primitive_root(simple.back(word))),
                              simple.back[word.front()].front());
    std::vector<InfiniteRepetition> repetitions;
    for (const auto& [word, letter] : found) repetitions.push_back({word, true, letter});
    return repetitions;
}

std::vector<InfiniteRepetition> infinite_repetitions(const D0L& system, const Budget& budget) {
    const Iterated rest = skeleton(system);
    const auto growing = growing_letters(rest.rules);
    const auto accessible = accessible_letters(rest.rules, rest.axiom);
    std::vector<InfiniteRepetition> found = growing_repetitions(rest, budget);
    for (const bool left : {false, true}) {
        const Morphism rules = left ? rest.rules.mirrored() : rest.rules;
        std::map<Symbol, std::vector<Symbol>> cycles;  // from each of their letters on
        for (auto& cycle : last_letter_cycles(rules, accessible, growing))
            for (std::size_t turns = 0; turns < cycle.size(); ++turns) {
                cycles.emplace(cycle.front(), cycle);
                std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
            }
        for (const auto& [a, cycle] : cycles) {
            const Word run =
                run_of(rules, cycle, growing, "a word that is repeated without end", budget);
            if (run.empty()) continue;
            Word word = pushed(rules, run, cycle.size(), budget);
            if (left) std::reverse(word.begin(), word.end());
            found.push_back({word, false, a});
        }
    }
    // As the system itself writes them, with the letters that vanish.
    const auto lifetime = lifetimes(system.rules);
    std::uint64_t steps = 0;
    for (const Symbol a : system.letters)
        if (lifetime[a] != lasts) steps = std::max(steps, lifetime[a]);
    std::map<Word, InfiniteRepetition> all;
    for (InfiniteRepetition& repetition : found) {
        for (std::uint64_t i = 0; i < steps; ++i) {
            repetition.word = primitive_root(system.rules(repetition.word));
            check_length(repetition.word, budget);
        }
        repetition.word = least_conjugate(primitive_root(repetition.word));
        all.emplace(repetition.word, repetition);
    }
    std::vector<InfiniteRepetition> repetitions;
    for (auto& [word, repetition] : all) repetitions.push_back(repetition);
    std::stable_sort(repetitions.begin(), repetitions.end(),
                     [](const auto& x, const auto& y) { return x.word.size() < y.word.size(); });
    return repetitions;
}

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

constexpr std::size_t longest_core =
    100'000;  // letters of the words that are looked through for one

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

class Decision {
public:
    Decision(const D0L& system, const Budget& budget)
        : named_(system),
          budget_(budget),
          system_(skeleton(system)),
          growing_(growing_letters(system_.rules)),
          orders_(letter_orders(components(growth_matrix(system_.rules), budget))) {
        const auto lifetime = lifetimes(system.rules);
        vanishing_ = std::any_of(system.letters.begin(), system.letters.end(),
                                 [&](Symbol a) { return lifetime[a] != lasts; });
    }

    ComplexityOrder order() const {
        if (!has_growing(accessible_letters(system_.rules, system_.axiom)))
            return {zero, zero, "the language is finite: no letter of the axiom grows"};
        const Side all = side(system_.axiom);
        const auto core = core_of(system_.axiom);
        ComplexityOrder best{constant, all.at_most, all.because};
        if (core) {
            best = of_core(*core, system_.axiom);
        } else if (all.at_most == linear) {
            best = bounded_or_linear({system_.axiom, system_.rules}, all.because);
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
        const auto letters = accessible_letters(system_.rules, v);
        if (!has_growing(letters)) return {constant, "only letters that do not grow follow"};
        if (const auto pusher = pusher_of(system_.rules, v, budget_))
            return {quadratic, "the letter " + name(pusher->letter) +
                                   " pushes letters that do not grow before it (" +
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
            return {n_log_n, "not pushy, and the letters " + name(rates->first) + " and " +
                                 name(rates->second) + " grow at different rates (Pansiot 1984)"};
        if (exponents)
            return {n_log_log_n,
                    "not pushy, and the letters " + name(exponents->first) + " and " +
                        name(exponents->second) +
                        " grow at the same rate with different powers of n (Pansiot 1984)"};
        return {linear, "not pushy, and all growing letters grow at the same rate (Pansiot 1984)"};
    }

    static std::string steps(std::size_t count) {
        return count == 1 ? "step" : std::to_string(count) + " steps";
    }

    std::optional<Core> core_of(const Word& axiom) const {
        std::vector<Word> words{axiom};
        for (std::size_t n = 1; n <= 2 * system_.rules.size() + 2; ++n) {
            words.push_back(system_.rules(words.back()));
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
        const std::string where = core.left.empty()    ? "the words begin one another"
                                  : core.right.empty() ? "the words end one another"
                                                       : "the words contain one another";
        const Side left = side(core.left), right = side(core.right);
        const Side& more = left.at_most > right.at_most ? left : right;
        if (more.at_most > linear) return {more.at_most, more.at_most, where + "; " + more.because};
        if (!core.left.empty() && !core.right.empty() &&
            (left.at_most == constant || right.at_most == constant))
            return {linear, linear,
                    where +
                        ", on one side of them only letters that do not grow follow, ever more of "
                        "them: the factors that reach over the last growing letter there are "
                        "counted by where it stands in them, the others are at most linear"};
        if (more.at_most == linear)
            return bounded_or_linear({axiom, system_.rules}, where + "; " + more.because);
        return {constant, constant,
                where +
                    ", and outside one of them only letters that do not grow follow: "
                    "the infinite word is ultimately periodic"};
    }

    /// Letters that occur in one of their own images give bounds from below.
    void lower_bound(ComplexityOrder& best) const {
        const auto accessible = accessible_letters(system_.rules, system_.axiom);
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
            best.because = "the words that " + name(letter) +
                           " derives are as complex already: " + found->because;
        } else {
            best.because = "at least: " +
                           (found ? "the words that " + name(letter) + " derives; " + found->because
                                  : std::string("the language is infinite")) +
                           ". At most: " + above;
        }
    }

    /// Not pushy, and all growing letters that occur grow alike: at most linear.
    ComplexityOrder bounded_or_linear(const Iterated& system, const std::string& above) const {
        const auto repetitions = growing_repetitions(system, budget_);
        if (repetitions.empty())
            return {linear, linear,
                    above + "; not ultimately periodic, because no word is repeated without end"};
        if (const auto place = lasting_place(system, repetitions))
            return {linear, linear,
                    above + "; not ultimately periodic, because " + text(*place) +
                        " comes back without end and is no part of a word repeated without end"};
        for (const std::size_t length : {16u, 64u, 256u}) {
            const auto complexity = factor_complexity(system, length, budget_);
            for (std::size_t k = 1; k <= length; ++k)
                if (complexity[k] <= k)
                    return {constant, constant,
                            "p(" + std::to_string(k) + ") = " + std::to_string(complexity[k]) +
                                " is not more than " + std::to_string(k) +
                                (vanishing_ ? ", letters that vanish left out" : "") +
                                ": bounded (Balogh and Bollobas 2005), and the language is "
                                "infinite"};
        }
        return {constant, linear,
                above +
                    "; whether ultimately periodic is open: p(k) > k for k up to 256, and every "
                    "place is part of a word repeated without end"};
    }

    /// The letters around some place between growing letters that come back in infinitely many words,
    /// ever farther from their ends, though no repetition has them.
    std::optional<Word> lasting_place(const Iterated& system,
                                      const std::vector<InfiniteRepetition>& repetitions) const {
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
        const auto accessible = accessible_letters(system.rules, system.axiom);
        for (Symbol a = 0; a < accessible.size(); ++a)
            if (accessible[a]) see(system.rules[a]);
        for (const Place& start : starts) {
            std::vector<Place> path;
            std::map<Place, std::size_t> when;
            for (Place place = start;;) {
                if (seen.contains(place)) break;  // its cycle has been looked at
                const auto [again, is_new] = when.emplace(place, path.size());
                if (!is_new) {
                    for (std::size_t i = again->second; i < path.size(); ++i)
                        if (Word word = around(path[i]); !is_repeated(word, repetitions))
                            return word;
                    break;
                }
                path.push_back(place);
                place = next(place, system.rules, reach);
                budget_.check();
            }
            seen.insert(path.begin(), path.end());
        }
        return std::nullopt;
    }

    static Word around(const Place& place) {
        Word word = place.left;
        word.insert(word.end(), place.between.begin(), place.between.end());
        word.insert(word.end(), place.right.begin(), place.right.end());
        return word;
    }
    static bool is_repeated(const Word& word, const std::vector<InfiniteRepetition>& repetitions) {
        return std::any_of(repetitions.begin(), repetitions.end(), [&](const auto& repetition) {
            return is_factor_of_powers(word, repetition.word);
        });
    }
    static Place next(const Place& place, const Morphism& rules, std::size_t reach) {
        Place after{rules(place.left), rules(place.between), rules(place.right)};
        if (after.left.size() > reach)
            after.left.erase(after.left.begin(),
                             after.left.end() - static_cast<std::ptrdiff_t>(reach));
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

ComplexityOrder complexity_order(const D0L& system, const Budget& budget) {
    return Decision(system, budget).order();
}

}  // namespace algae
