#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "language/detail/letters.hpp"
#include "language/language.hpp"
#include "system/system.hpp"

// How many derivations a word has, and all of them.
//
// For a sequence of tables, let c(a, u) be the number of derivations of the factor u of a word from the letter a by
// these tables. Those of the sequence with one more table in front are sums, over the successors of a, of products over
// the ways to cut u: a product of factors a rule, as in the decision of membership. The number of derivations of n steps is the
// sum over all sequences of n tables; sequences with equal numbers are followed as one. Whether c(a, u) > 0 for which a and u is a
// state, of which there are finitely many: if a state from which one can be reached that derives the word from the axiom lies on a
// cycle, there are infinitely many derivations, and otherwise sequences of tables that derive the word have bounded length.
// A derivation is told from the others by its number: those below a letter are counted, rule by rule and cut by cut,
// until the number is reached, so each comes once and none is tried in vain.
//
// In a system with context what a letter becomes depends on its word, so derivations of factors are not counted: words are. They are
// the nodes of a graph, and an edge from u to v has a weight, the number of ways to choose successors for the letters of u that make v. The number of
// derivations of n steps is the sum over the walks of n edges from the axiom to the word, of products of weights. Where no rule is
// erasing, only words that are not longer than the wanted one lead to it, so the graph is finite; with erasing rules
// it may be infinite, and then memory ends the work.
//
// There are infinitely many derivations if and only if some cycle of the graph lies on a walk from the axiom to the word.

namespace algae {

namespace {

/// Truth with the operations of numbers: whether there is a derivation.
struct Some {
    unsigned char is = 0;
    Some() = default;
    explicit Some(int number) : is(number != 0) {}
    bool is_zero() const { return is == 0; }
    Some& operator+=(Some other) {
        is = static_cast<unsigned char>(is | other.is);
        return *this;
    }
    Some operator*(Some other) const { return Some(is & other.is); }
    auto operator<=>(const Some&) const = default;
};

/// What letters derive within one word by a sequence of tables, counted by numbers of a kind: for every
/// accessible letter and every factor a number. The system must outlive it.
template <class Number>
class FactorCounts {
public:
    using State = std::vector<Number>;

    FactorCounts(const ET0L& system, const Word& word, const Budget& budget)
        : system_(system),
          word_(word),
          budget_(budget),
          letters_(accessible_letters(system)),
          place_(system.alphabet->size(), letters_.size()),
          places_(word.size() + 1) {
        for (std::size_t i = 0; i < letters_.size(); ++i) place_[letters_[i]] = i;
        budget.check_memory(4 * bytes(), "the numbers of derivations of factors");
        for (const Table& table : system.tables) {
            rules_.emplace_back();
            for (const Symbol a : letters_) {
                std::vector<std::uint32_t>& choices = rules_.back().emplace_back();
                for (std::uint32_t k = 0; k < table[a].size(); ++k)
                    if (const auto here = table[a].begin() + static_cast<std::ptrdiff_t>(k);
                        std::find(table[a].begin(), here, *here) == here)
                        choices.push_back(k);
            }
        }
    }

    std::uint64_t bytes() const { return letters_.size() * places_ * places_ * sizeof(Number); }

    /// By no table every letter derives itself.
    State first() const {
        State state(letters_.size() * places_ * places_, Number(0));
        for (std::size_t i = 0; i < word_.size(); ++i)
            if (place_[word_[i]] < letters_.size()) state[at(word_[i], i) + i + 1] = Number(1);
        return state;
    }

    /// By one more table, which comes before the others.
    State next(const State& state, std::size_t table) const {
        State following(state.size(), Number(0));
        for (std::size_t i = 0; i < letters_.size(); ++i)
            for (const std::uint32_t choice : rules_[table][i])
                for (std::size_t from = 0; from < places_; ++from) {
                    budget_.check();
                    const State ends =
                        ends_of(state, system_.tables[table][letters_[i]][choice], from);
                    Number* const to = following.data() + at(letters_[i], from);
                    for (std::size_t end = from; end < places_; ++end)
                        if (!ends[end].is_zero()) to[end] += ends[end];
                }
        return following;
    }

    /// The derivations of the whole word from the axiom.
    Number of_axiom(const State& state) const { return ends_of(state, system_.axiom, 0).back(); }

    /// The different choices of a letter in a table.
    const std::vector<std::uint32_t>& choices(std::size_t table, Symbol a) const {
        return rules_[table][place_[a]];
    }
    const Number& number(const State& state, Symbol a, std::size_t from, std::size_t to) const {
        return state[at(a, from) + to];
    }

    /// By number of letters left out at the beginning and place: the derivations of what stands from there up to `to` from
    /// the other letters.
    std::vector<State> from_the_right(const State& state, const Word& letters,
                                      std::size_t to) const {
        std::vector<State> rests(letters.size() + 1, State(to + 1, Number(0)));
        rests.back()[to] = Number(1);
        for (std::size_t k = letters.size(); k-- > 0;)
            for (std::size_t from = 0; from <= to; ++from)
                for (std::size_t end = from; end <= to; ++end) {
                    const Number& begun = number(state, letters[k], from, end);
                    if (!begun.is_zero() && !rests[k + 1][end].is_zero())
                        rests[k][from] += begun * rests[k + 1][end];
                }
        return rests;
    }

private:
    std::size_t at(Symbol a, std::size_t from) const {
        return (place_[a] * places_ + from) * places_;
    }

    /// By place: the derivations from these letters of what stands before it from `from` on.
    State ends_of(const State& state, const Word& letters, std::size_t from) const {
        State ends(places_, Number(0));
        ends[from] = Number(1);
        for (const Symbol a : letters) {
            State further(places_, Number(0));
            for (std::size_t begin = from; begin < places_; ++begin) {
                if (ends[begin].is_zero()) continue;
                for (std::size_t end = begin; end < places_; ++end) {
                    const Number& more = state[at(a, begin) + end];
                    if (!more.is_zero()) further[end] += ends[begin] * more;
                }
            }
            ends = std::move(further);
        }
        return ends;
    }

    const ET0L& system_;
    const Word& word_;
    const Budget& budget_;
    std::vector<Symbol> letters_;
    std::vector<std::size_t> place_;  // by symbol: its place in letters_
    std::size_t places_;              // one more than the word has letters
    std::vector<std::vector<std::vector<std::uint32_t>>> rules_;  // by table and letter
};

/// Which factors letters derive, by all sequences of up to so many tables: the states and how they follow.
class DerivingStates {
public:
    static constexpr std::uint64_t any = ~std::uint64_t{0};

    DerivingStates(const ET0L& system, const Word& word, std::uint64_t most, const Budget& budget) {
        const FactorCounts<Some> counts(system, word, budget);
        std::map<FactorCounts<Some>::State, std::size_t> known;
        std::vector<decltype(known)::const_iterator> states;
        const auto number = [&](FactorCounts<Some>::State state) {
            const auto [found, is_new] = known.try_emplace(std::move(state), known.size());
            if (is_new) {
                budget.check_memory(known.size() * (counts.bytes() + 200),
                                    "which factors letters derive by sequences of tables");
                states.push_back(found);
                derives.push_back(!counts.of_axiom(found->first).is_zero());
            }
            return found->second;
        };
        number(counts.first());
        std::size_t level =
            states.size();  // states before this one come by fewer than `length` tables more
        for (std::uint64_t i = 0, length = 0; i < states.size(); ++i) {
            if (i == level) {
                level = states.size();
                ++length;
            }
            if (length == most) break;
            next.emplace_back();
            for (std::size_t table = 0; table < system.tables.size(); ++table)
                next.back().push_back(
                    number(counts.next(states[static_cast<std::size_t>(i)]->first, table)));
        }
    }

    /// The states from which some more tables lead to one that derives the word from the axiom.
    std::vector<char> useful() const {
        std::vector<char> found = derives;
        for (bool changes = true; changes;) {
            changes = false;
            for (std::size_t state = next.size(); state-- > 0;)
                for (const std::size_t to : next[state])
                    if (found[to] && !found[state]) {
                        found[state] = 1;
                        changes = true;
                    }
        }
        return found;
    }

    std::vector<std::vector<std::size_t>> next;  // by state and table
    std::vector<char> derives;                   // by state: the word from the axiom
};

/// Whether some of these states lie on a cycle of such states.
bool has_cycle(const DerivingStates& states, const std::vector<char>& useful) {
    std::vector<std::size_t> entering(useful.size(), 0);
    std::size_t left = 0;
    for (std::size_t state = 0; state < useful.size(); ++state) {
        if (!useful[state]) continue;
        ++left;
        for (const std::size_t to : states.next[state])
            if (useful[to]) ++entering[to];
    }
    std::vector<std::size_t> open;
    for (std::size_t state = 0; state < useful.size(); ++state)
        if (useful[state] && entering[state] == 0) open.push_back(state);
    for (; !open.empty(); --left) {
        const std::size_t state = open.back();
        open.pop_back();
        for (const std::size_t to : states.next[state])
            if (useful[to] && --entering[to] == 0) open.push_back(to);
    }
    return left > 0;
}

bool can_be_member(const ET0L& system, const Word& word) {
    return std::all_of(word.begin(), word.end(),
                       [&](Symbol a) { return a < system.terminal.size() && system.terminal[a]; });
}

/// The numbers of derivations of 0, 1, ... steps, one after the other. With several tables the
/// sequences are followed together, those with equal numbers as one.
class StepCounts {
public:
    StepCounts(const ET0L& system, const Word& word, const Budget& budget)
        : tables_(system.tables.size()), counts_(system, word, budget), budget_(budget) {
        now_.emplace(counts_.first(), Group{1, 0});
    }

    Integer count() const {
        Integer sum = 0;
        for (const auto& [state, group] : now_) sum += group.times * counts_.of_axiom(state);
        return sum;
    }
    /// Goes on by one table. With `states`, only where the word can still be derived.
    void step(const DerivingStates* states = nullptr, const std::vector<char>* useful = nullptr) {
        std::map<FactorCounts<Integer>::State, Group> following;
        for (const auto& [state, group] : now_)
            for (std::size_t table = 0; table < tables_; ++table) {
                const std::size_t to = states ? states->next[group.state][table] : 0;
                if (useful && !(*useful)[to]) continue;
                const auto [found, is_new] =
                    following.try_emplace(counts_.next(state, table), Group{0, to});
                found->second.times += group.times;
                budget_.check_memory(following.size() * (counts_.bytes() + 200),
                                     "the numbers of derivations by sequences of tables");
            }
        now_ = std::move(following);
    }
    bool is_over() const { return now_.empty(); }

private:
    struct Group {
        Integer times;      // sequences of tables
        std::size_t state;  // which of these numbers are above 0
    };
    std::size_t tables_;
    FactorCounts<Integer> counts_;
    const Budget& budget_;
    std::map<FactorCounts<Integer>::State, Group> now_;
};

/// The numbers of steps in which a system without choices derives a word: `step`, and every `period` more.
struct OnlyDerivations {
    std::optional<std::uint64_t> step;
    std::optional<Integer> period;
};

/// Nothing where the system has choices, or letters that are not terminals.
std::optional<OnlyDerivations> only_derivations(const ET0L& system, const Word& word,
                                                const Budget& budget) {
    if (system.tables.size() > 1 || !has_only_terminals(system)) return std::nullopt;
    const OL plain = without_terminals(system);
    if (!is_deterministic(plain)) return std::nullopt;
    OnlyDerivations found;
    const Membership member = membership(plain, word, budget);
    if (!member.member) return found;
    found.step = member.step;
    // The words of an infinite language are all different.
    if (!finiteness(plain).finite) return found;
    const Repetition words = repetition(plain, budget);
    if (member.step >= words.preperiod) found.period = words.period;
    return found;
}

}  // namespace

Integer number_of_derivations(const ET0L& system, const Word& word, std::uint64_t n,
                              const Budget& budget) {
    if (!can_be_member(system, word)) return 0;
    if (const auto only = only_derivations(system, word, budget)) {
        if (!only->step || n < *only->step) return 0;
        if (!only->period) return n == *only->step;
        return remainder(Integer(n - *only->step), *only->period).is_zero();
    }
    StepCounts counts(system, word, budget);
    for (std::uint64_t t = 0; t < n; ++t) counts.step();
    return counts.count();
}

DerivationCounts derivation_counts(const ET0L& system, const Word& word, std::size_t listed,
                                   const Budget& budget) {
    DerivationCounts found;
    found.total = 0;
    if (!can_be_member(system, word)) return found;
    if (const auto only = only_derivations(system, word, budget)) {
        if (!only->step) return found;
        found.total = 1;
        if (only->period) found.total.reset();
        Integer steps = *only->step;
        for (std::size_t i = 0; i < (only->period ? listed : 1) && steps.fits_uint64(); ++i) {
            found.by_steps.push_back({steps.to_uint64(), 1});
            if (only->period) steps += *only->period;
        }
        return found;
    }
    const DerivingStates states(system, word, DerivingStates::any, budget);
    const std::vector<char> useful = states.useful();
    const bool infinite = has_cycle(states, useful);
    StepCounts counts(system, word, budget);
    for (std::uint64_t n = 0; useful.front() && !counts.is_over(); ++n) {
        if (infinite && found.by_steps.size() == listed) break;
        if (Integer count = counts.count(); !count.is_zero()) {
            *found.total += count;
            found.by_steps.push_back({n, std::move(count)});
        }
        counts.step(&states, &useful);
    }
    if (infinite) found.total.reset();
    return found;
}

namespace {

/// The derivations by one sequence of tables, which are told apart by their numbers.
class NumberedDerivations {
public:
    NumberedDerivations(const ET0L& system, const Word& word, std::vector<std::uint32_t> tables,
                        const Budget& budget)
        : system_(system),
          word_(word),
          tables_(std::move(tables)),
          budget_(budget),
          counts_(system, word, budget) {
        budget.check_memory((tables_.size() + 4) * counts_.bytes(),
                            "the numbers of derivations of factors, by steps");
        states_.push_back(counts_.first());
        for (std::size_t t = tables_.size(); t-- > 0;)
            states_.push_back(counts_.next(states_.back(), tables_[t]));
    }

    Integer count() const { return counts_.of_axiom(states_.back()); }

    Derivation derivation(const Integer& number) const {
        const std::size_t n = tables_.size();
        Derivation found;
        found.words.resize(n + 1);
        found.choices.resize(n);
        if (system_.tables.size() > 1) found.tables = tables_;
        std::vector<Part> open;
        cut(system_.axiom, 0, word_.size(), n, number, open);
        std::uint64_t letters = 0;
        while (!open.empty()) {
            const Part part = std::move(open.back());
            open.pop_back();
            if (++letters > budget_.letters)
                throw BoundReached(Bound::letters, "the words of the derivation have more than " +
                                                       std::to_string(budget_.letters) +
                                                       " letters together, the bound set" +
                                                       budget_.by(Bound::letters));
            const std::size_t step = n - part.left;
            found.words[step].push_back(part.letter);
            if (part.left == 0) continue;
            Integer rest = part.number;
            const Table& table = system_.tables[tables_[step]];
            for (const std::uint32_t choice : counts_.choices(tables_[step], part.letter)) {
                const Word& successor = table[part.letter][choice];
                const Integer ways =
                    counts_.from_the_right(states_[part.left - 1], successor, part.to)
                        .front()
                        .at(part.from);
                if (rest < ways) {
                    found.choices[step].push_back(choice);
                    cut(successor, part.from, part.to, part.left - 1, rest, open);
                    break;
                }
                rest -= ways;
            }
        }
        return found;
    }

private:
    /// A letter that derives a factor by the last `left` tables, in the way of this number.
    struct Part {
        Symbol letter;
        std::size_t from, to, left;
        Integer number;
    };

    /// Puts the letters with the factors that they derive on the stack, the first on top.
    void cut(const Word& letters, std::size_t from, std::size_t to, std::size_t left,
             Integer number, std::vector<Part>& open) const {
        budget_.check();
        const auto& state = states_[left];
        const auto rests = counts_.from_the_right(state, letters, to);
        const std::size_t below = open.size();
        for (std::size_t k = 0; k < letters.size(); ++k)
            for (std::size_t end = from; end <= to; ++end) {
                const Integer& others = rests[k + 1][end];
                const Integer ways = counts_.number(state, letters[k], from, end) * others;
                if (number < ways) {
                    open.push_back({letters[k], from, end, left, floor_divide(number, others)});
                    number = remainder(number, others);
                    from = end;
                    break;
                }
                number -= ways;
            }
        std::reverse(open.begin() + static_cast<std::ptrdiff_t>(below), open.end());
    }

    const ET0L& system_;
    const Word& word_;
    std::vector<std::uint32_t> tables_;
    const Budget& budget_;
    FactorCounts<Integer> counts_;
    std::vector<FactorCounts<Integer>::State> states_;  // by number of tables left
};

/// Goes through the sequences of n tables by which the word is derived, smaller tables first, until `visit` says
/// that it is enough.
void each_sequence(const ET0L& system, const Word& word, std::uint64_t n, const Budget& budget,
                   const std::function<bool(std::vector<std::uint32_t>)>& visit) {
    if (system.tables.size() == 1) {
        budget.check_memory(n * sizeof(std::uint32_t), "a sequence of tables");
        visit(std::vector<std::uint32_t>(static_cast<std::size_t>(n), 0));
        return;
    }
    const DerivingStates states(system, word, n, budget);
    const std::size_t size = states.derives.size();
    budget.check_memory((n + 1) * size, "which states come by how many tables");
    // By number of tables: the states that come by so many.
    std::vector<std::vector<char>> comes(static_cast<std::size_t>(n) + 1,
                                         std::vector<char>(size, 0));
    comes[0][0] = 1;
    for (std::size_t t = 0; t < n; ++t) {
        budget.check();
        for (std::size_t state = 0; state < states.next.size(); ++state)
            if (comes[t][state])
                for (const std::size_t to : states.next[state]) comes[t + 1][to] = 1;
    }
    // The first tables of a sequence are the last that lead to a state: by them, the states that the
    // other tables may come to.
    struct Begun {
        std::vector<char> rest;
        std::uint32_t table = 0;  // that is tried next
    };
    std::vector<Begun> begun(1);
    for (std::size_t state = 0; state < size; ++state)
        begun[0].rest.push_back(comes.back()[state] && states.derives[state]);
    std::vector<std::uint32_t> sequence;
    if (std::count(begun[0].rest.begin(), begun[0].rest.end(), 0U) ==
        static_cast<std::ptrdiff_t>(size))
        return;
    while (!begun.empty()) {
        budget.check();
        Begun& here = begun.back();
        const std::size_t left = static_cast<std::size_t>(n) - sequence.size();
        if (left == 0 && !visit(sequence)) return;
        if (left == 0 || here.table == system.tables.size()) {
            begun.pop_back();
            if (!sequence.empty()) sequence.pop_back();
            continue;
        }
        const std::uint32_t table = here.table++;
        Begun further;
        bool is_any = false;
        for (std::size_t state = 0; state < size; ++state) {
            const bool leads = state < states.next.size() && comes[left - 1][state] &&
                               here.rest[states.next[state][table]];
            further.rest.push_back(leads);
            is_any = is_any || leads;
        }
        if (!is_any) continue;
        sequence.push_back(table);
        begun.push_back(std::move(further));
    }
}

}  // namespace

std::vector<Derivation> derivations(const ET0L& system, const Word& word, std::uint64_t n,
                                    std::size_t most, const Budget& budget) {
    std::vector<Derivation> found;
    if (most == 0 || !can_be_member(system, word)) return found;
    if (only_derivations(system, word, budget)) {
        if (number_of_derivations(system, word, n, budget).is_zero()) return found;
        const OL plain = without_terminals(system);
        found.push_back(derivation(plain, word, n, budget));
        return found;
    }
    std::uint64_t letters = 0;
    each_sequence(system, word, n, budget, [&](std::vector<std::uint32_t> tables) {
        const NumberedDerivations all(system, word, std::move(tables), budget);
        const Integer count = all.count();
        for (Integer number = 0; number < count && found.size() < most; ++number) {
            found.push_back(all.derivation(number));
            for (const Word& one : found.back().words) letters += one.size() + 8;
            budget.check_memory(letters * 2 * sizeof(Symbol), "the derivations");
        }
        return found.size() < most;
    });
    return found;
}

// --- Systems with context ---

namespace {

class WordGraph {
public:
    struct Edge {
        std::size_t to;
        Integer ways;
    };

    WordGraph(const IL& system, const Word& wanted, const Budget& budget)
        : step_(system), wanted_(wanted), budget_(budget) {
        if (is_propagating(system)) longest_ = wanted.size();
        if (fits(system.axiom.size())) first_ = number(system.axiom);
    }

    /// The axiom; nothing where it is longer than any word that leads to the wanted one.
    const std::optional<std::size_t>& first() const { return first_; }
    std::optional<std::size_t> wanted() const {
        const auto known = numbers_.find(wanted_);
        if (known == numbers_.end()) return std::nullopt;
        return known->second;
    }
    std::size_t size() const { return words_.size(); }
    const Word& word(std::size_t node) const { return words_[node]->first; }

    const std::vector<Edge>& edges(std::size_t node) {
        if (!edges_[node]) {
            std::vector<Edge> found;
            for (auto& [word, ways] : successors(word_of(node)))
                found.push_back({number(word), std::move(ways)});
            edges_[node] = std::move(found);
        }
        return *edges_[node];
    }

    /// Finds all words. Throws BoundReached if they take more than a part of the budget's memory.
    void close() {
        for (std::size_t node = 0; node < size(); ++node) edges(node);
    }

    /// Calls visit(choices) for each way in which the letters of one word make the other one; false stops.
    bool each_way(std::size_t from, std::size_t to,
                  const std::function<bool(const std::vector<std::uint32_t>&)>& visit) {
        const Word &begin = word(from), &end = word(to);
        const auto choices = step_.successors(begin);
        // By letters left and place in the word: whether they make what stands from there on.
        std::vector<std::vector<char>> makes(begin.size() + 1,
                                             std::vector<char>(end.size() + 1, 0));
        makes.back().back() = 1;
        for (std::size_t i = begin.size(); i-- > 0;)
            for (std::size_t at = 0; at <= end.size(); ++at)
                for (const Word& one : *choices[i])
                    if (stands(one, end, at) && makes[i + 1][at + one.size()]) makes[i][at] = 1;
        std::vector<std::uint32_t> chosen;
        const std::function<bool(std::size_t, std::size_t)> go = [&](std::size_t i,
                                                                     std::size_t at) {
            if (i == begin.size()) return visit(chosen);
            for (std::uint32_t k = 0; k < choices[i]->size(); ++k) {
                const Word& one = (*choices[i])[k];
                if (!stands(one, end, at) || !makes[i + 1][at + one.size()]) continue;
                chosen.push_back(k);
                const bool goes_on = go(i + 1, at + one.size());
                chosen.pop_back();
                if (!goes_on) return false;
            }
            return true;
        };
        return !makes.front().front() || go(0, 0);
    }

private:
    static bool stands(const Word& part, const Word& word, std::size_t at) {
        return part.size() <= word.size() - at &&
               std::equal(part.begin(), part.end(), word.begin() + static_cast<std::ptrdiff_t>(at));
    }
    bool fits(std::size_t length) const { return !longest_ || length <= *longest_; }
    const Word word_of(std::size_t node) const { return words_[node]->first; }

    void spend(std::size_t letters) {
        bytes_ += letters * sizeof(Symbol) + 160;
        budget_.check_memory(4 * bytes_, "the words of which derivations are counted");
    }

    std::size_t number(const Word& word) {
        const auto [place, is_new] = numbers_.emplace(word, numbers_.size());
        if (is_new) {
            words_.push_back(place);
            edges_.emplace_back();
            spend(word.size());
        }
        return place->second;
    }

    /// The words after one step that are not too long, each with the number of ways to it.
    std::map<Word, Integer> successors(const Word& word) {
        const auto choices = step_.successors(word);
        std::vector<std::size_t> least(word.size() + 1, 0);  // letters that the rest becomes
        for (std::size_t i = word.size(); i-- > 0;) {
            std::size_t shortest = choices[i]->front().size();
            for (const Word& one : *choices[i]) shortest = std::min(shortest, one.size());
            least[i] = least[i + 1] + shortest;
        }
        std::map<Word, Integer> begun{{Word{}, Integer(1)}};
        for (std::size_t i = 0; i < word.size(); ++i) {
            std::map<Word, Integer> further;
            std::uint64_t letters = 0;
            for (const auto& [made, ways] : begun) {
                budget_.check();
                for (const Word& one : *choices[i]) {
                    if (!fits(made.size() + one.size() + least[i + 1])) continue;
                    Word next = made;
                    next.insert(next.end(), one.begin(), one.end());
                    letters += next.size() + 40;
                    further[std::move(next)] += ways;
                }
                budget_.check_memory(letters * sizeof(Symbol), "the words after one step");
            }
            begun = std::move(further);
        }
        return begun;
    }

    ContextStep step_;
    const Word wanted_;
    const Budget& budget_;
    std::optional<std::size_t> longest_, first_;
    std::map<Word, std::size_t> numbers_;
    std::vector<std::map<Word, std::size_t>::const_iterator> words_;
    std::vector<std::optional<std::vector<Edge>>> edges_;
    std::uint64_t bytes_ = 0;
};

/// By node, whether a walk leads from it to the wanted word. The graph must be closed.
std::vector<char> leading(WordGraph& graph) {
    std::vector<std::vector<std::size_t>> before(graph.size());
    for (std::size_t node = 0; node < graph.size(); ++node)
        for (const WordGraph::Edge& edge : graph.edges(node)) before[edge.to].push_back(node);
    std::vector<char> leads(graph.size(), 0);
    std::vector<std::size_t> open;
    const auto add = [&](std::size_t node) {
        if (leads[node]) return;
        leads[node] = 1;
        open.push_back(node);
    };
    if (const auto wanted = graph.wanted()) add(*wanted);
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        for (const std::size_t earlier : before[node]) add(earlier);
    }
    return leads;
}

/// Whether these nodes have a cycle: some are left when those without an edge to another one are taken away again and again.
bool has_cycle(WordGraph& graph, const std::vector<char>& nodes) {
    std::vector<std::vector<std::size_t>> before(graph.size());
    std::vector<std::size_t> edges(graph.size(), 0), open;
    std::size_t left = 0;
    for (std::size_t node = 0; node < graph.size(); ++node) {
        if (!nodes[node]) continue;
        ++left;
        for (const WordGraph::Edge& edge : graph.edges(node))
            if (nodes[edge.to]) {
                ++edges[node];
                before[edge.to].push_back(node);
            }
        if (edges[node] == 0) open.push_back(node);
    }
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        --left;
        for (const std::size_t earlier : before[node])
            if (--edges[earlier] == 0) open.push_back(earlier);
    }
    return left > 0;
}

/// By word, the derivations of some number of steps.
using Counts = std::map<std::size_t, Integer>;

/// Those of one more step; of the nodes that lead to the wanted word where that is known.
Counts after(WordGraph& graph, const Counts& counts, const std::vector<char>* leads,
             const Budget& budget) {
    Counts next;
    for (const auto& [node, count] : counts) {
        budget.check();
        for (const WordGraph::Edge& edge : graph.edges(node))
            if (!leads || (*leads)[edge.to]) next[edge.to] += count * edge.ways;
    }
    return next;
}

Integer of_wanted(const WordGraph& graph, const Counts& counts) {
    const auto wanted = graph.wanted();
    const auto found = wanted ? counts.find(*wanted) : counts.end();
    return found == counts.end() ? Integer(0) : found->second;
}

}  // namespace

Integer number_of_derivations(const IL& system, const Word& word, std::uint64_t n,
                              const Budget& budget) {
    WordGraph graph(system, word, budget);
    Counts counts;
    if (graph.first()) counts[*graph.first()] = 1;
    for (std::uint64_t t = 0; t < n && !counts.empty(); ++t)
        counts = after(graph, counts, nullptr, budget);
    return of_wanted(graph, counts);
}

DerivationCounts derivation_counts(const IL& system, const Word& word, std::size_t listed,
                                   const Budget& budget) {
    DerivationCounts found;
    found.total = 0;
    WordGraph graph(system, word, budget);
    if (!graph.first()) return found;
    graph.close();
    const std::vector<char> leads = leading(graph);
    if (!leads[*graph.first()]) return found;
    const bool infinite = has_cycle(graph, leads);
    Counts counts{{*graph.first(), Integer(1)}};
    for (std::uint64_t n = 0; !counts.empty(); ++n) {
        if (infinite && found.by_steps.size() == listed) break;
        if (Integer count = of_wanted(graph, counts); !count.is_zero()) {
            *found.total += count;
            found.by_steps.push_back({n, std::move(count)});
        }
        counts = after(graph, counts, &leads, budget);
    }
    if (infinite) found.total.reset();
    return found;
}

std::vector<Derivation> derivations(const IL& system, const Word& word, std::uint64_t n,
                                    std::size_t most, const Budget& budget) {
    std::vector<Derivation> found;
    WordGraph graph(system, word, budget);
    if (most == 0 || !graph.first()) return found;
    // The words of each generation, then those of them from which a walk ends at the word.
    std::vector<std::set<std::size_t>> layers{{*graph.first()}};
    std::uint64_t nodes = 1;
    while (layers.size() <= n) {
        std::set<std::size_t> next;
        for (const std::size_t node : layers.back()) {
            budget.check();
            for (const WordGraph::Edge& edge : graph.edges(node)) next.insert(edge.to);
        }
        if (next.empty()) return found;
        nodes += next.size();
        budget.check_memory(nodes * 48, "the words of all generations");
        layers.push_back(std::move(next));
    }
    const auto wanted = graph.wanted();
    if (!wanted || layers.back().count(*wanted) == 0) return found;
    layers.back() = {*wanted};
    for (std::size_t t = layers.size() - 1; t-- > 0;)
        for (auto node = layers[t].begin(); node != layers[t].end();) {
            const auto& edges = graph.edges(*node);
            const bool leads = std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
                return layers[t + 1].count(edge.to) > 0;
            });
            node = leads ? std::next(node) : layers[t].erase(node);
        }
    if (layers.front().empty()) return found;
    // From word to word without recursion over the steps: ways of the steps so far, as places in lists of all of them.
    struct Way {
        std::size_t to;
        std::vector<std::uint32_t> choices;
    };
    struct Begun {
        std::vector<Way> ways;
        std::size_t next = 0;
    };
    const auto ways_from = [&](std::size_t node, std::size_t t) {
        Begun begun;
        std::uint64_t bytes = 0;
        for (const WordGraph::Edge& edge : graph.edges(node)) {
            if (layers[t + 1].count(edge.to) == 0) continue;
            graph.each_way(node, edge.to, [&](const std::vector<std::uint32_t>& choices) {
                begun.ways.push_back({edge.to, choices});
                bytes += choices.size() * sizeof(std::uint32_t) + 48;
                budget.check_memory(bytes, "the choices of one step");
                return begun.ways.size() < most;  // each leads to a derivation of its own
            });
            if (begun.ways.size() >= most) break;
        }
        return begun;
    };
    Derivation current;
    current.words.push_back(graph.word(*graph.first()));
    std::vector<Begun> path;
    std::uint64_t letters = 0;
    if (n > 0) path.push_back(ways_from(*graph.first(), 0));
    const auto keep = [&] {
        found.push_back(current);
        for (const Word& one : current.words) letters += 2 * one.size() + 16;
        budget.check_memory(letters * sizeof(Symbol), "the derivations");
    };
    if (n == 0) keep();
    while (!path.empty() && found.size() < most) {
        budget.check();
        Begun& here = path.back();
        current.words.resize(path.size());
        current.choices.resize(path.size() - 1);
        if (here.next == here.ways.size()) {
            path.pop_back();
            continue;
        }
        const Way& way = here.ways[here.next++];
        current.words.push_back(graph.word(way.to));
        current.choices.push_back(way.choices);
        if (path.size() == n)
            keep();
        else
            path.push_back(ways_from(way.to, path.size()));
    }
    return found;
}

std::optional<Derivation> shortest_derivation(const IL& system, const Word& word,
                                              const Budget& budget) {
    WordGraph graph(system, word, budget);
    if (!graph.first()) return std::nullopt;
    std::vector<std::size_t> from{0};  // by node, the one that it was found from
    for (std::size_t node = 0; node < graph.size() && !graph.wanted(); ++node) {
        graph.edges(node);
        from.resize(graph.size(), node);
    }
    const auto wanted = graph.wanted();
    if (!wanted) return std::nullopt;
    Derivation found;
    std::vector<std::size_t> nodes{*wanted};
    while (nodes.back() != *graph.first()) nodes.push_back(from[nodes.back()]);
    std::reverse(nodes.begin(), nodes.end());
    for (std::size_t t = 0; t < nodes.size(); ++t) {
        found.words.push_back(graph.word(nodes[t]));
        if (t + 1 < nodes.size())
            graph.each_way(nodes[t], nodes[t + 1], [&](const std::vector<std::uint32_t>& choices) {
                found.choices.push_back(choices);
                return false;
            });
    }
    return found;
}

}  // namespace algae
