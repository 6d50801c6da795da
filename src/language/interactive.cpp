#include "language/detail/interactive.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <functional>
#include <limits>
#include <set>
#include <string>

#include "language/detail/judge.hpp"
#include "word/word.hpp"

// Languages of systems with context (IL). Every recursively enumerable language is the intersection of one with a regular language, so
// nothing here decides all cases but membership where no rule is erasing, since words do not get shorter (Rozenberg and Salomaa
// 1980, VI).
//
// A step is a relation that an automaton reads: its states are what was seen on the left and a guess of what stands on the right, as
// far as contexts go. So the image of a regular language under a step is regular, and it can be decided whether a regular language is
// closed under steps. A closed one that has the axiom has all words of L(G): an invariant. Three ways lead to invariants.
//
// - Forwards: words are told apart by the state of some automaton that has read them and by their last k letters. The least
//   language of such paths that has the axiom and is closed under steps is found by adding, for each word that a path and a step
//   give, its own path; there are finitely many, so this ends. It is abstract interpretation with locally testable
//   languages (McNaughton and Papert 1971) and the automaton of the property.
// - The same for the reversed system.
// - Backwards: words from which a word outside is reached in 1, 2, ... steps; if at some time there are no new ones, all others
//   are the weakest invariant.
//
// That L(G) is infinite is shown by a measure: a weight for each transition of an invariant, such that every step makes the sum along
// a word larger. The weights are found by corrections: where a path of the product does not raise the sum, its transitions are weighed
// more (the perceptron; Rosenblatt 1958).

namespace algae {

namespace {

using Kind = LanguageTree::Kind;

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// How much may be done for one question, so that it ends soon on any machine.
class Work {
public:
    Work(const Budget& budget, std::uint64_t most) : budget_(budget), left_(most) {}
    /// Whether so much more may be done.
    bool take(std::uint64_t steps) {
        budget_.check();
        if (steps > left_) left_ = 0;
        left_ -= std::min(left_, steps);
        return left_ > 0;
    }
    bool is_over() const { return left_ == 0; }
    const Budget& budget() const { return budget_; }

private:
    const Budget& budget_;
    std::uint64_t left_;
};

}  // namespace

// --- Words ---

Derivation FoundWords::derivation(std::size_t number) const {
    Derivation found;
    for (std::size_t at = number;; at = from[at]) {
        found.words.push_back(words[at]);
        if (from[at] == at) break;
    }
    std::reverse(found.words.begin(), found.words.end());
    return found;
}

FoundWords found_words(const IL& system, const SearchOfWords& search, const Budget& budget,
                       const std::optional<Word>& wanted) {
    FoundWords found;
    std::uint64_t letters = 0;
    const auto add = [&](Word word, std::size_t from) {
        const auto [place, is_new] = found.numbers.emplace(word, found.words.size());
        if (!is_new) return;
        letters += word.size();
        found.from.push_back(from);
        found.words.push_back(std::move(word));
    };
    if (search.longest && system.axiom.size() > *search.longest) {
        found.is_all = true;
        return found;
    }
    add(system.axiom, 0);
    // A step writes the beginnings of its words once more for each letter that has a choice, also where all of these words are known.
    constexpr std::uint64_t writings = 50, least_memory = 1 << 16;
    std::uint64_t work = writings * search.letters;
    const bool deterministic = is_deterministic(system);
    ContextStep step(system);
    Budget one_step = budget;  // its words are kept twice
    const std::uint64_t most_memory = std::min<std::uint64_t>(
        {budget.memory, search.letters * 16 + (1 << 20), std::uint64_t{search.words} * 400});
    for (std::size_t i = 0; i < found.words.size(); ++i) {
        budget.check();
        if (wanted && found.has(*wanted)) return found;
        if (found.words.size() > search.words || letters > search.letters) return found;
        std::uint64_t choices = 0;
        if (!deterministic)
            for (const auto* successors : step.successors(found.words[i]))
                choices += successors->size() > 1;
        one_step.memory = std::min(
            most_memory, std::max(least_memory, 8 * work / std::max<std::uint64_t>(choices, 1)));
        std::vector<Word> next;
        try {
            next = step.next(found.words[i], search.longest, one_step);
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
            return found;
        }
        std::uint64_t written = 1;
        for (const Word& word : next) written += word.size() + 1;
        written *= choices + 1;
        if (written > work) return found;
        work -= written;
        for (Word& word : next) add(std::move(word), i);
    }
    found.is_all = true;
    return found;
}

std::optional<std::vector<Word>> all_words_of(const IL& system, const Budget& budget) {
    // Of a deterministic system every new word is a new generation: one that does not repeat soon is not followed far.
    const bool deterministic = is_deterministic(system);
    FoundWords found = found_words(system,
                                   {deterministic ? std::size_t{1000} : std::size_t{5000},
                                    deterministic ? 1'000'000u : 200'000u,
                                    {}},
                                   budget);
    if (!found.is_all) return std::nullopt;
    return words_language(std::move(found.words))->words;
}

namespace {

// --- Steps as an automaton ---

/// Reads a word letter by letter, and knows at each what the letter may become: the state has the letters seen last and a
/// guess of those to come, which must come true.
class StepAutomaton {
public:
    struct Move {
        std::size_t to = 0;
        Symbol letter = 0;
        const std::vector<Word>* successors = nullptr;
    };

    /// Nothing if there are too many states.
    static std::optional<StepAutomaton> of(const IL& system) {
        StepAutomaton made;
        if (!made.build(system)) return std::nullopt;
        return made;
    }

    std::vector<Symbol> letters;     // that may occur, increasing
    std::vector<std::size_t> first;  // states at the beginning of a word
    std::vector<std::vector<Move>> moves;
    std::vector<char> is_end;

private:
    static constexpr std::size_t most_states = 3000;

    bool build(const IL& system) {
        if (system.brackets) return false;
        letters = accessible(system.axiom, system.alphabet->size(), [&](Symbol a, auto see) {
            for (const IL::Rule& rule : system.rules[a]) see(rule.successor);
        });
        std::sort(letters.begin(), letters.end());
        std::vector<Symbol> visible;
        std::size_t left = 0, right = 0;
        for (const Symbol a : letters) {
            if (!system.ignored[a]) visible.push_back(a);
            for (const IL::Rule& rule : system.rules[a]) {
                left = std::max(left, rule.left.size());
                right = std::max(right, rule.right.size());
            }
        }
        std::vector<Word> guesses{{}};
        for (std::size_t i = 0; i < guesses.size(); ++i) {
            if (guesses.size() > most_states) return false;
            if (guesses[i].size() == right) continue;
            for (const Symbol a : visible) {
                guesses.push_back(guesses[i]);
                guesses.back().push_back(a);
            }
        }
        for (const Word& guess : guesses) first.push_back(number({{}, guess}));
        for (std::size_t s = 0; s < states_.size(); ++s) {
            if (states_.size() > most_states) return false;
            add_moves(system, s, visible, left, right);
        }
        return true;
    }

    using State = std::pair<Word, Word>;

    std::size_t number(const State& state) {
        const auto [place, is_new] = numbers_.emplace(state, states_.size());
        if (is_new) states_.push_back(state);
        return place->second;
    }

    void add_moves(const IL& system, std::size_t s, const std::vector<Symbol>& visible,
                   std::size_t left, std::size_t right) {
        const State from = states_[s];
        std::vector<Move> found;
        const auto add = [&](Symbol a, const Word& before, const Word& behind, const State& to) {
            found.push_back({number(to), a, successors(system, before, a, behind)});
        };
        for (const Symbol a : letters) {
            const auto& [before, guess] = from;
            if (system.ignored[a]) {
                add(a, before, guess, from);
                continue;
            }
            Word seen = before;
            seen.push_back(a);
            if (seen.size() > left) seen.erase(seen.begin());
            if (right == 0) {
                add(a, before, {}, {seen, {}});
            } else if (!guess.empty() && guess.front() == a) {
                Word rest(guess.begin() + 1, guess.end());
                add(a, before, rest, {seen, rest});  // the word ends there
                if (guess.size() < right) continue;
                for (const Symbol b : visible) {
                    Word longer = rest;
                    longer.push_back(b);
                    add(a, before, longer, {seen, longer});
                }
            }
        }
        moves.resize(std::max(moves.size(), s + 1));
        moves[s] = std::move(found);
        is_end.resize(std::max(is_end.size(), s + 1), 0);
        is_end[s] = from.second.empty();
    }

    /// What a letter becomes between these letters, as IL says.
    const std::vector<Word>* successors(const IL& system, const Word& before, Symbol a,
                                        const Word& behind) {
        const auto& rules = system.rules[a];
        std::size_t chosen = none;
        for (std::size_t i = 0; i < rules.size() && chosen == none; ++i) {
            const auto& [left, right, successor] = rules[i];
            if (left.size() <= before.size() && right.size() <= behind.size() &&
                std::equal(left.rbegin(), left.rend(), before.rbegin()) &&
                std::equal(right.begin(), right.end(), behind.begin()))
                chosen = i;
        }
        const auto [place, is_new] = known_.emplace(std::pair(a, chosen), nullptr);
        if (!is_new) return place->second;
        auto& all = choices_.emplace_back();
        if (chosen == none) {
            all.push_back({a});
        } else {
            for (std::size_t i = chosen; i < rules.size() && rules[i].left == rules[chosen].left &&
                                         rules[i].right == rules[chosen].right;
                 ++i)
                all.push_back(rules[i].successor);
        }
        return place->second = &all;
    }

    std::map<State, std::size_t> numbers_;
    std::deque<State> states_;
    std::deque<std::vector<Word>> choices_;  // moves point into it
    std::map<std::pair<Symbol, std::size_t>, const std::vector<Word>*> known_;
};

/// A deterministic automaton that need not be complete. State 0 is the first.
struct Partial {
    std::size_t letters = 0;
    std::vector<std::size_t> to;  // by state and letter; `none`
    std::vector<char> accepting;

    std::size_t add_state() {
        to.resize(to.size() + letters, none);
        accepting.push_back(0);
        return accepting.size() - 1;
    }
    std::size_t step(std::size_t state, Symbol a) const {
        return a < letters ? to[state * letters + a] : none;
    }
    std::size_t walk(std::size_t state, const Word& word) const {
        for (std::size_t i = 0; i < word.size() && state != none; ++i) state = step(state, word[i]);
        return state;
    }
};

/// Without the states from which nothing is accepted.
Partial partial(const Dfa& automaton, std::size_t letters) {
    const std::vector<std::size_t> ways = distances(automaton);
    Partial made{letters, {}, {}};
    std::vector<std::size_t> numbers(automaton.states(), none), order{automaton.initial};
    numbers[automaton.initial] = made.add_state();
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t from = numbers[order[i]];
        made.accepting[from] = automaton.accepting[order[i]];
        for (Symbol a = 0; a < std::min(letters, automaton.letters); ++a) {
            const std::size_t to = automaton.step(order[i], a);
            if (ways[to] == automaton.states()) continue;
            if (numbers[to] == none) {
                numbers[to] = made.add_state();
                order.push_back(to);
            }
            made.to[from * letters + a] = numbers[to];
        }
    }
    return made;
}

Dfa complete(const Partial& automaton) {
    const std::size_t dead = automaton.accepting.size();
    Dfa made{automaton.letters, 0, automaton.accepting, automaton.to};
    made.accepting.push_back(0);
    made.transitions.resize((dead + 1) * automaton.letters, dead);
    std::replace(made.transitions.begin(), made.transitions.end(), none, dead);
    return made;
}

/// What a step does to the words that an automaton accepts: it reads a word, and another automaton what the word becomes.
struct StepProduct {
    struct Node {
        std::size_t step, read, written;
        auto operator<=>(const Node&) const = default;
    };
    struct Arc {
        std::size_t from = 0, to = 0;
        Symbol letter = 0;
        const Word* successor = nullptr;
    };
    std::vector<Node> nodes;
    std::vector<Arc> arcs;
    std::vector<char> is_last;   // a word that is accepted ends here
    std::vector<char> finishes;  // some does behind it
    std::size_t beginnings = 0;  // of words: so many first nodes

    /// `write` gives the state after the successor, `none` to follow that no further. Nothing if the work is over.
    static std::optional<StepProduct> of(
        const StepAutomaton& steps, const Partial& read,
        const std::function<std::size_t(std::size_t, const Word&)>& write, Work& work) {
        StepProduct made;
        std::map<Node, std::size_t> numbers;
        const auto number = [&](const Node& node) {
            const auto [place, is_new] = numbers.emplace(node, made.nodes.size());
            if (is_new) made.nodes.push_back(node);
            return place->second;
        };
        for (const std::size_t s : steps.first) number({s, 0, 0});
        made.beginnings = made.nodes.size();
        for (std::size_t i = 0; i < made.nodes.size(); ++i) {
            const Node at = made.nodes[i];
            if (!work.take(steps.moves[at.step].size() + 1)) return std::nullopt;
            made.is_last.push_back(steps.is_end[at.step] && read.accepting[at.read]);
            for (const StepAutomaton::Move& move : steps.moves[at.step]) {
                const std::size_t next = read.step(at.read, move.letter);
                if (next == none) continue;
                for (const Word& successor : *move.successors) {
                    const std::size_t written =
                        at.written == none ? none : write(at.written, successor);
                    const std::size_t to = number({move.to, next, written});
                    made.arcs.push_back({i, to, move.letter, &successor});
                }
            }
        }
        made.mark_finishing();
        return made;
    }

private:
    void mark_finishing() {
        std::vector<std::vector<std::size_t>> before(nodes.size());
        for (const Arc& arc : arcs) before[arc.to].push_back(arc.from);
        finishes = is_last;
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (finishes[i]) open.push_back(i);
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            for (const std::size_t from : before[at])
                if (!finishes[from]) {
                    finishes[from] = 1;
                    open.push_back(from);
                }
        }
    }
};

std::optional<bool> is_closed(const IL& system, const StepAutomaton& steps, const Partial& language,
                              Work& work) {
    const std::size_t end = language.walk(0, system.axiom);
    if (end == none || !language.accepting[end]) return false;
    const auto product = StepProduct::of(
        steps, language,
        [&](std::size_t state, const Word& word) { return language.walk(state, word); }, work);
    if (!product) return std::nullopt;
    for (std::size_t i = 0; i < product->nodes.size(); ++i)
        if (product->is_last[i]) {
            const std::size_t written = product->nodes[i].written;
            if (written == none || !language.accepting[written]) return false;
        }
    return true;
}

// --- Invariants, forwards ---

/// The least language that has the axiom, is closed under steps, and tells words apart by the states of an automaton and their last
/// letters.
class LocalClosure {
public:
    /// `allowed`: by state of the automaton, whether its words may be in the language; empty: all may.
    LocalClosure(const IL& system, const StepAutomaton& steps, Dfa tags, std::vector<char> allowed,
                 std::size_t last, Work& work)
        : system_(system),
          steps_(steps),
          tags_(std::move(tags)),
          allowed_(std::move(allowed)),
          last_(last),
          work_(work) {
        made_.letters = tags_.letters;
    }

    std::optional<RegularLanguage> language() {
        node({tags_.initial, {}});
        add(0, system_.axiom);
        accept(walk(0, system_.axiom));
        for (is_changed_ = true; is_changed_;) {
            if (is_outside_) return std::nullopt;
            is_changed_ = false;
            const auto product = StepProduct::of(
                steps_, made_,
                [this](std::size_t state, const Word& word) { return walk(state, word); }, work_);
            if (!product || states_.size() > most_states) return std::nullopt;
            for (const StepProduct::Arc& arc : product->arcs)
                if (product->finishes[arc.to])
                    add(product->nodes[arc.from].written, *arc.successor);
            for (std::size_t i = 0; i < product->nodes.size(); ++i)
                if (product->is_last[i]) accept(product->nodes[i].written);
        }
        return RegularLanguage(complete(made_));
    }

private:
    static constexpr std::size_t most_states = 3000;
    using State = std::pair<std::size_t, Word>;

    std::size_t node(const State& state) {
        const auto [place, is_new] = numbers_.emplace(state, states_.size());
        if (is_new) {
            states_.push_back(state);
            made_.add_state();
        }
        return place->second;
    }

    std::size_t after(std::size_t at, Symbol a) {
        State next = states_[at];
        next.first = tags_.step(next.first, a);
        next.second.push_back(a);
        if (next.second.size() > last_) next.second.erase(next.second.begin());
        return node(next);
    }

    std::size_t walk(std::size_t at, const Word& word) {
        for (const Symbol a : word) at = after(at, a);
        return at;
    }

    void add(std::size_t at, const Word& word) {
        for (const Symbol a : word) {
            const std::size_t to = after(at, a);
            std::size_t& known = made_.to[at * made_.letters + a];
            is_changed_ = is_changed_ || known == none;
            known = to;
            at = to;
        }
    }

    void accept(std::size_t at) {
        is_changed_ = is_changed_ || !made_.accepting[at];
        made_.accepting[at] = 1;
        is_outside_ = is_outside_ || (!allowed_.empty() && !allowed_[states_[at].first]);
    }

    const IL& system_;
    const StepAutomaton& steps_;
    Dfa tags_;
    std::vector<char> allowed_;
    std::size_t last_;
    Work& work_;
    Partial made_;
    std::map<State, std::size_t> numbers_;
    std::deque<State> states_;
    bool is_changed_ = false, is_outside_ = false;
};

/// An automaton that tells words apart and accepts all of them.
Dfa one_state(std::size_t letters) {
    return {letters, 0, {1}, std::vector<std::size_t>(letters, 0)};
}

/// Which of the letters have been read.
Dfa seen_letters(const std::vector<Symbol>& which, std::size_t letters) {
    const std::size_t states = std::size_t{1} << which.size();
    Dfa made{letters, 0, std::vector<char>(states, 1), {}};
    for (std::size_t s = 0; s < states; ++s)
        for (Symbol a = 0; a < letters; ++a) {
            const auto place = std::find(which.begin(), which.end(), a) - which.begin();
            const bool counts = static_cast<std::size_t>(place) < which.size();
            made.transitions.push_back(counts ? s | std::size_t{1} << place : s);
        }
    return made;
}

/// How many letters have been read, modulo m.
Dfa length_modulo(std::size_t m, std::size_t letters) {
    Dfa made{letters, 0, std::vector<char>(m, 1), {}};
    for (std::size_t s = 0; s < m; ++s)
        made.transitions.insert(made.transitions.end(), letters, (s + 1) % m);
    return made;
}

/// Both at once; a state accepts where the first one does.
Dfa paired(const Dfa& one, const Dfa& other) {
    Dfa made{one.letters, one.initial * other.states() + other.initial, {}, {}};
    for (std::size_t s = 0; s < one.states(); ++s)
        for (std::size_t t = 0; t < other.states(); ++t) {
            made.accepting.push_back(one.accepting[s]);
            for (Symbol a = 0; a < one.letters; ++a)
                made.transitions.push_back(one.step(s, a) * other.states() + other.step(t, a));
        }
    return made;
}

constexpr std::size_t most_seen = 5;  // letters of which it is told whether they were seen

/// By how words are told apart, the simplest first: automata and numbers of last letters.
std::vector<std::pair<Dfa, std::size_t>> abstractions(const Dfa& property,
                                                      const std::vector<Symbol>& letters) {
    std::vector<std::pair<Dfa, std::size_t>> all;
    for (const std::size_t last : {0u, 1u}) all.emplace_back(property, last);
    const bool few = letters.size() <= most_seen;
    const Dfa seen = few ? seen_letters(letters, property.letters) : one_state(property.letters);
    if (few) all.emplace_back(paired(property, seen), 0);
    all.emplace_back(property, 2);
    for (const std::size_t m : {2u, 3u})
        all.emplace_back(paired(property, length_modulo(m, property.letters)), 1);
    if (few) all.emplace_back(paired(property, seen), 1);
    all.emplace_back(property, 3);
    return all;
}

IL reversed(const IL& system) {
    const auto turn = [](Word& word) { std::reverse(word.begin(), word.end()); };
    IL made = system;
    turn(made.axiom);
    for (auto& rules : made.rules)
        for (IL::Rule& rule : rules) {
            std::swap(rule.left, rule.right);
            turn(rule.left);
            turn(rule.right);
            turn(rule.successor);
        }
    return made;
}

// --- Invariants, backwards ---

/// The words outside, those that become one of them in one step, and so on, until there are no new ones: the rest is closed.
std::optional<RegularLanguage> weakest_invariant(const IL& system, const StepAutomaton& steps,
                                                 const RegularLanguage& outer, Work& work) {
    constexpr std::size_t most_rounds = 12, most_states = 60;
    const std::size_t letters = system.alphabet->size();
    RegularLanguage outside = complement(outer, steps.letters, work.budget());
    for (std::size_t round = 0; round < most_rounds; ++round) {
        if (outside.contains(system.axiom)) return std::nullopt;
        const Partial goal = partial(outside.automaton(), letters);
        if (goal.accepting.size() > most_states) return std::nullopt;
        Nfa before;
        std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;
        std::vector<std::pair<std::size_t, std::size_t>> order;
        const auto number = [&](std::size_t step, std::size_t state) {
            const auto [place, is_new] = numbers.emplace(std::pair(step, state), order.size());
            if (is_new) {
                order.emplace_back(step, state);
                before.add_state(steps.is_end[step] && goal.accepting[state]);
            }
            return place->second;
        };
        for (const std::size_t s : steps.first) before.initial.push_back(number(s, 0));
        for (std::size_t i = 0; i < order.size(); ++i) {
            const auto [step, state] = order[i];
            if (!work.take(steps.moves[step].size() + 1)) return std::nullopt;
            for (const StepAutomaton::Move& move : steps.moves[step])
                for (const Word& successor : *move.successors)
                    if (const std::size_t to = goal.walk(state, successor); to != none) {
                        const std::size_t next = number(move.to, to);
                        before.states[i].moves.emplace_back(move.letter, next);
                    }
        }
        Budget small = work.budget();
        small.memory = std::min<std::uint64_t>(small.memory, std::uint64_t{1} << 26);
        RegularLanguage more = outside;
        try {
            more = united(outside, RegularLanguage(before, small), small);
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
            return std::nullopt;
        }
        if (more == outside)
            return algae::difference(all_words(steps.letters), outside, work.budget());
        outside = std::move(more);
    }
    return std::nullopt;
}

constexpr std::uint64_t most_work = 2'000'000;  // moves of products for one question: seconds

std::optional<RegularLanguage> forwards(const IL& system, const StepAutomaton& steps,
                                        const std::pair<Dfa, std::size_t>& by, Work& work) {
    Work own(work.budget(), most_work / 8);
    auto found =
        LocalClosure(system, steps, by.first, by.first.accepting, by.second, own).language();
    work.take(most_work / 40);
    return found;
}

}  // namespace

std::optional<bool> is_closed(const IL& system, const RegularLanguage& language,
                              const Budget& budget) {
    const auto steps = StepAutomaton::of(system);
    if (!steps) return std::nullopt;
    Work work(budget, 10 * most_work);
    return is_closed(system, *steps, partial(language.automaton(), system.alphabet->size()), work);
}

std::optional<RegularLanguage> invariant_within(const IL& system, const RegularLanguage& outer,
                                                const Budget& budget) {
    const auto steps = StepAutomaton::of(system);
    if (!steps || !outer.contains(system.axiom)) return std::nullopt;
    const IL mirror = reversed(system);
    const auto mirror_steps = StepAutomaton::of(mirror);
    const std::size_t letters = system.alphabet->size();
    const auto by = abstractions(widened(outer.automaton(), letters), steps->letters);
    const RegularLanguage backwards = reversed(outer, budget);
    const auto mirror_by = abstractions(widened(backwards.automaton(), letters), steps->letters);
    Work work(budget, most_work);
    for (std::size_t i = 0; i < by.size(); ++i) {
        if (auto found = forwards(system, *steps, by[i], work)) return found;
        if (mirror_steps)
            if (const auto found = forwards(mirror, *mirror_steps, mirror_by[i], work))
                return reversed(*found, budget);
        if (i == 0)
            if (auto found = weakest_invariant(system, *steps, outer, work)) return found;
        if (work.is_over()) break;
    }
    return std::nullopt;
}

std::optional<RegularLanguage> longer_successors(const IL& system, const RegularLanguage& language,
                                                 const Budget& budget) {
    const auto steps = StepAutomaton::of(system);
    if (!steps) return std::nullopt;
    const Partial read = partial(language.automaton(), system.alphabet->size());
    Nfa made;
    using State =
        std::array<std::size_t, 3>;  // of the step, of the language, whether it has got longer
    std::map<State, std::size_t> numbers;
    std::vector<std::pair<State, std::size_t>> order;
    const auto number = [&](const State& state) {
        const auto [place, is_new] = numbers.emplace(state, 0);
        if (is_new) {
            place->second =
                made.add_state(state[2] && steps->is_end[state[0]] && read.accepting[state[1]]);
            order.emplace_back(state, place->second);
        }
        return place->second;
    };
    for (const std::size_t s : steps->first) made.initial.push_back(number({s, 0, 0}));
    for (std::size_t i = 0; i < order.size(); ++i) {
        budget.check();
        const auto [state, from] = order[i];
        for (const StepAutomaton::Move& move : steps->moves[state[0]]) {
            const std::size_t next = read.step(state[1], move.letter);
            if (next == none) continue;
            for (const Word& successor : *move.successors)
                if (!successor.empty())
                    made.add_path(from, successor,
                                  number({move.to, next, state[2] | (successor.size() > 1)}));
        }
    }
    return RegularLanguage(made, budget);
}

// --- Invariants in expressions ---

bool has_context(const Language& language) {
    if (language->kind == Kind::generated && !language->system->variable)
        return language->system->interactive.has_value();
    return std::any_of(language->parts.begin(), language->parts.end(), has_context);
}

namespace {

using Invariants = std::map<const SourceSystem*, RegularLanguage>;

/// Calls `see` for each system with context, with what its language must lie within for the whole to lie within `outer` (nothing
/// where that is not known); false if one stands where more words do not make the whole larger.
bool visit_context(const Language& language, const std::optional<RegularLanguage>& outer,
                   const Alphabet& alphabet, const Budget& budget,
                   const std::function<void(const std::shared_ptr<const SourceSystem>&,
                                            const std::optional<RegularLanguage>&)>& see) {
    if (!has_context(language)) return true;
    const LanguageTree& tree = *language;
    const auto part = [&](std::size_t i, const std::optional<RegularLanguage>& within) {
        return visit_context(tree.parts[i], within, alphabet, budget, see);
    };
    switch (tree.kind) {
        case Kind::generated:
            see(tree.system, outer);
            return true;
        case Kind::united:
            return part(0, outer) && part(1, outer);
        case Kind::reversed:
            return part(0, outer ? std::optional(reversed(*outer, budget)) : outer);
        case Kind::intersected:
        case Kind::difference:
            for (const std::size_t filter : {1u, 0u}) {
                if (has_context(tree.parts[filter])) continue;
                if (filter == 0 && tree.kind == Kind::difference) return false;
                const auto by = regular_value(tree.parts[filter], alphabet, budget);
                if (!by) return false;
                std::optional<RegularLanguage> within = outer;
                if (within) {
                    const auto letters = letters_of(tree.parts[1 - filter]);
                    within = united(
                        *within,
                        tree.kind == Kind::difference ? *by : complement(*by, letters, budget),
                        budget);
                }
                return part(1 - filter, within);
            }
            return false;
        case Kind::image: {
            std::optional<RegularLanguage> within = outer;
            if (within) {
                const auto letters = letters_of(tree.parts[0]);
                const auto domain = tree.morphism.domain();
                within = united(inverse_image(*within, tree.morphism.images(), domain),
                                difference(all_words(letters), all_words(domain), budget), budget);
            }
            return part(0, within);
        }
        case Kind::concatenated:
            return part(0, std::nullopt) && part(1, std::nullopt);
        case Kind::star:
        case Kind::plus:
            return part(0, std::nullopt);
        default:
            return false;
    }
}

/// The expression with invariants in the place of systems with context.
std::optional<RegularLanguage> with_invariants(const Language& language, const Invariants& found,
                                               const Alphabet& alphabet, const Budget& budget) {
    if (!has_context(language)) return regular_value(language, alphabet, budget);
    const LanguageTree& tree = *language;
    if (tree.kind == Kind::generated) return found.at(tree.system.get());
    if (tree.kind == Kind::complement || tree.kind == Kind::inverse_image) return std::nullopt;
    std::vector<RegularLanguage> parts;
    for (const Language& part : tree.parts) {
        auto value = with_invariants(part, found, alphabet, budget);
        if (!value) return std::nullopt;
        parts.push_back(std::move(*value));
    }
    return operated(tree, parts, budget);
}

/// Invariants of one system that know nothing of a property, the coarsest first; false from `use` for the next one.
bool use_free_invariants(const IL& system, const Budget& budget,
                         const std::function<bool(const RegularLanguage&)>& use) {
    const auto steps = StepAutomaton::of(system);
    if (!steps) return false;
    Work work(budget, most_work);
    for (const auto& by : abstractions(one_state(system.alphabet->size()), steps->letters)) {
        if (const auto found = forwards(system, *steps, by, work); found && use(*found))
            return true;
        if (work.is_over()) return false;
    }
    return false;
}

}  // namespace

std::optional<steps::Invariant> by_invariants(const Language& left, const Language& right,
                                              const std::optional<Word>& word,
                                              const Alphabet& alphabet, const Budget& budget) {
    std::optional<RegularLanguage> outer = RegularLanguage();
    if (word)
        outer = complement(finite_set({*word}), letters_of(left), budget);
    else if (right)
        outer = regular_value(right, alphabet, budget);
    if (!outer) return std::nullopt;
    struct Wanted {
        std::shared_ptr<const SourceSystem> system;
        std::optional<RegularLanguage> within;
        bool is_known = true;  // of every occurrence what it must lie within
    };
    std::map<const SourceSystem*, Wanted> wanted;
    const bool is_monotone = visit_context(left, outer, alphabet, budget,
                                           [&](const std::shared_ptr<const SourceSystem>& system,
                                               const std::optional<RegularLanguage>& within) {
                                               Wanted& entry = wanted[system.get()];
                                               if (!entry.system)
                                                   entry = {system, within, within.has_value()};
                                               entry.is_known = entry.is_known && within;
                                               if (entry.is_known)
                                                   entry.within =
                                                       intersected(*entry.within, *within, budget);
                                           });
    if (!is_monotone || wanted.empty()) return std::nullopt;
    steps::Invariant said{left, right, word, {}};
    Invariants found;
    const auto holds = [&] {
        const auto value = with_invariants(left, found, alphabet, budget);
        return value && !first_outside(*value, *outer, budget);
    };
    const auto finished = [&] {
        for (const auto& [key, entry] : wanted)
            said.closed.push_back(
                {entry.system, std::make_shared<const Dfa>(found.at(key).automaton())});
        return said;
    };
    const bool all_known = std::all_of(wanted.begin(), wanted.end(),
                                       [](const auto& entry) { return entry.second.is_known; });
    if (!all_known) {
        if (wanted.size() > 1) return std::nullopt;
        const auto& key = wanted.begin()->first;
        const auto& entry = wanted.begin()->second;
        const bool is_found = use_free_invariants(*entry.system->interactive, budget,
                                                  [&](const RegularLanguage& invariant) {
                                                      found.insert_or_assign(key, invariant);
                                                      return holds();
                                                  });
        return is_found ? std::optional(finished()) : std::nullopt;
    }
    for (const auto& [key, entry] : wanted) {
        auto invariant = invariant_within(*entry.system->interactive, *entry.within, budget);
        if (!invariant) return std::nullopt;
        found.insert_or_assign(key, std::move(*invariant));
    }
    return holds() ? std::optional(finished()) : std::nullopt;
}

// --- Measures ---

namespace {

/// Weights of the transitions of an automaton that accepts what it becomes in one step, each of which raises the sum along a word.
class MeasureSearch {
public:
    MeasureSearch(const StepAutomaton& steps, const Partial& language, Work& work)
        : language_(language), work_(work) {
        product_ = StepProduct::of(
            steps, language,
            [&](std::size_t state, const Word& word) { return language.walk(state, word); }, work);
    }

    /// By state and letter. `by_length`: only whether words get longer.
    std::optional<std::vector<std::int64_t>> weights(bool by_length) {
        if (!product_) return std::nullopt;
        std::vector<std::int64_t> weights(language_.to.size(), 1);
        for (std::size_t round = 0; round < (by_length ? 1 : most_rounds); ++round) {
            const auto path = unraised_path(weights);
            if (!path) return weights;
            if (path->empty() || work_.is_over()) return std::nullopt;
            bool is_changed = false;
            for (const auto& [transition, times] : *path) {
                weights[transition] += times;
                is_changed = is_changed || times != 0;
                if (std::abs(weights[transition]) > most_weight) return std::nullopt;
            }
            if (!is_changed) return std::nullopt;
        }
        return std::nullopt;
    }

private:
    static constexpr std::size_t most_rounds = 300;
    static constexpr std::int64_t most_weight = 1'000'000;
    /// How often transitions are taken by what is written, less how often by what is read.
    using Effect = std::map<std::size_t, std::int64_t>;

    std::int64_t weight(const StepProduct::Arc& arc,
                        const std::vector<std::int64_t>& weights) const {
        const StepProduct::Node& from = product_->nodes[arc.from];
        std::int64_t sum = -weights[from.read * language_.letters + arc.letter];
        std::size_t at = from.written;
        for (const Symbol a : *arc.successor) {
            sum += weights[at * language_.letters + a];
            at = language_.step(at, a);
        }
        return sum;
    }

    Effect effect(const std::vector<std::size_t>& arcs) const {
        Effect found;
        for (const std::size_t i : arcs) {
            const StepProduct::Arc& arc = product_->arcs[i];
            const StepProduct::Node& from = product_->nodes[arc.from];
            --found[from.read * language_.letters + arc.letter];
            std::size_t at = from.written;
            for (const Symbol a : *arc.successor) {
                ++found[at * language_.letters + a];
                at = language_.step(at, a);
            }
        }
        return found;
    }

    /// What a way through the product does that does not raise the sum, or a cycle that lowers it; nothing if there is none. Only the
    /// effect of an accepted empty word is empty.
    std::optional<Effect> unraised_path(const std::vector<std::int64_t>& weights) {
        const std::size_t nodes = product_->nodes.size();
        constexpr std::int64_t far = std::numeric_limits<std::int64_t>::max() / 4;
        std::vector<std::int64_t> least(nodes, far);
        std::vector<std::size_t> by(nodes, none);
        std::fill_n(least.begin(), product_->beginnings, 0);
        std::vector<std::size_t> used;
        std::vector<std::int64_t> costs;
        for (std::size_t i = 0; i < product_->arcs.size(); ++i)
            if (product_->finishes[product_->arcs[i].to]) {
                used.push_back(i);
                costs.push_back(weight(product_->arcs[i], weights));
            }
        std::size_t changed = none;
        for (std::size_t round = 0; round <= nodes; ++round) {
            changed = none;
            if (!work_.take(used.size() / 4 + 1)) return Effect{};
            for (std::size_t j = 0; j < used.size(); ++j) {
                const StepProduct::Arc& arc = product_->arcs[used[j]];
                if (least[arc.from] == far || least[arc.from] + costs[j] >= least[arc.to]) continue;
                least[arc.to] = least[arc.from] + costs[j];
                by[arc.to] = used[j];
                changed = arc.to;
            }
            if (changed == none) break;
        }
        std::vector<std::size_t> arcs;
        if (changed != none) {  // a cycle that gets lower and lower
            std::size_t at = changed;
            for (std::size_t i = 0; i < nodes; ++i) at = product_->arcs[by[at]].from;
            const std::size_t end = at;
            do {
                arcs.push_back(by[at]);
                at = product_->arcs[by[at]].from;
            } while (at != end);
            return effect(arcs);
        }
        for (std::size_t i = 0; i < nodes; ++i) {
            if (!product_->is_last[i] || least[i] > 0) continue;
            for (std::size_t at = i; by[at] != none; at = product_->arcs[by[at]].from)
                arcs.push_back(by[at]);
            return effect(arcs);
        }
        return std::nullopt;
    }

    const Partial& language_;
    Work& work_;
    std::optional<StepProduct> product_;
};

/// Systems that take the same rule wherever they have a choice, those with long successors first.
std::vector<IL> deterministic_parts(const IL& system, std::size_t most) {
    std::vector<IL> parts(1, system);
    for (auto& rules : parts[0].rules) rules.clear();
    for (Symbol a = 0; a < system.rules.size(); ++a) {
        const auto& rules = system.rules[a];
        for (std::size_t i = 0; i < rules.size();) {
            std::size_t end = i + 1;
            while (end < rules.size() && rules[end].left == rules[i].left &&
                   rules[end].right == rules[i].right)
                ++end;
            std::vector<IL::Rule> choices(rules.begin() + static_cast<std::ptrdiff_t>(i),
                                          rules.begin() + static_cast<std::ptrdiff_t>(end));
            std::stable_sort(choices.begin(), choices.end(),
                             [](const IL::Rule& one, const IL::Rule& other) {
                                 return one.successor.size() > other.successor.size();
                             });
            std::vector<IL> more;
            for (const IL::Rule& rule : choices)
                for (const IL& part : parts) {
                    if (more.size() >= std::max(most, std::size_t{1})) break;
                    more.push_back(part);
                    more.back().rules[a].push_back(rule);
                }
            parts = std::move(more);
            i = end;
        }
    }
    return parts;
}

struct FoundMeasure {
    std::vector<Word> before;  // generations up to the one from which it holds
    Partial language;
    std::vector<std::int64_t> weights;
};

/// Of a deterministic system.
std::optional<FoundMeasure> measure(const IL& system, bool by_length, Work& work) {
    constexpr std::size_t longest = 400;
    IL moved = system;
    std::vector<Word> before{system.axiom};
    for (std::uint64_t n = 0; n <= 16; ++n) {
        if (n > 0) {
            before.push_back(next_word(system, before.back()));
            if (before.back().size() > longest) return std::nullopt;
        }
        if (n > 2 && (n & (n - 1)) != 0) continue;  // 0, 1, 2, 4, 8, 16
        moved.axiom = before.back();
        const auto steps = StepAutomaton::of(moved);
        if (!steps) return std::nullopt;
        for (const auto& by : abstractions(one_state(moved.alphabet->size()), steps->letters)) {
            Work own(work.budget(), most_work / 20);
            const auto language =
                LocalClosure(moved, *steps, by.first, {}, by.second, own).language();
            if (!work.take(most_work / 200)) return std::nullopt;
            if (!language) continue;
            Partial automaton = partial(language->automaton(), moved.alphabet->size());
            MeasureSearch search(*steps, automaton, own);
            if (auto weights = search.weights(by_length))
                return FoundMeasure{std::move(before), std::move(automaton), std::move(*weights)};
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<steps::Measured> endless_measure(const SourceSystem& system, const Budget& budget) {
    if (!system.interactive || system.interactive->brackets) return std::nullopt;
    const IL& rules = *system.interactive;
    Work work(budget, most_work);
    for (const bool by_length : {true, false})
        for (const IL& part : deterministic_parts(rules, 16)) {
            const auto found = measure(part, by_length, work);
            if (work.is_over()) return std::nullopt;
            if (!found) continue;
            steps::Measured said{system.name, {found->before, {}}, {}, nullptr, {}};
            for (Symbol a = 0; a < part.rules.size(); ++a)
                if (part.rules[a].size() != rules.rules[a].size())
                    for (const IL::Rule& rule : part.rules[a]) said.rules.emplace_back(a, rule);
            const Dfa whole = complete(found->language);
            said.automaton = std::make_shared<const Dfa>(whole);
            said.weights = found->weights;
            said.weights.resize(whole.transitions.size(), 0);
            return said;
        }
    return std::nullopt;
}

ContextGrowth context_growth(const IL& system, const Budget& budget) {
    if (!is_deterministic(system)) throw Error("the system is not deterministic");
    if (system.brackets) throw Error("the words of the system are trees");
    ContextGrowth growth;
    const FoundWords found = found_words(system, {20'000, 4'000'000, {}}, budget);
    if (found.is_all) {
        const Word next = next_word(system, found.words.back());
        const std::size_t back = found.numbers.at(next);
        growth.repetition = Repetition{back, Integer(found.words.size() - back)};
        return growth;
    }
    Work work(budget, most_work);
    if (const auto rising = measure(system, true, work)) {
        std::size_t from = rising->before.size() - 1;
        while (from > 0 && rising->before[from - 1].size() < rising->before[from].size()) --from;
        growth.rises_from = from;
    } else if (measure(system, false, work)) {
        growth.endless = true;
    }
    return growth;
}

}  // namespace algae
