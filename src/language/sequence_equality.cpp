#include "language/detail/equality.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "language/detail/letters.hpp"
#include "system/system.hpp"

// D0L sequence equivalence: whether two systems have the same word in every generation.
//
// Let g and h be the rules. As long as the words w_0, ..., w_k of both are the same, w_{k+1} is the same if and
// only if g(w_k) = h(w_k). What the letters of w_k do to the overflow of one image over the other is followed
// exactly, letters with the same past taken together, so that no word is written out: this finds the first
// difference, and every overflow that words w_0, ..., w_k have (`OverflowWalk`). When a generation has none
// that was not there before, `try_balance` tests whether these suffice for ever.
//
// Theorem (Culik and Fris 1977; Ehrenfeucht and Rozenberg 1978): if the sequences are the same, the overflows
// are finitely many, so one of the two searches ends.
// Proof. Begin with p = q = the identity of A*, B = A, m = 0; there always is a product f = pq of m factors g
// and h with q: A* -> B*, p: B* -> A*, so w_n = p(q(w_{n-m})) for n >= m. Take e = gp or hp and reduce the
// words e(b): leave empty ones out, keep equal ones once, and where one is a proper prefix of another, take it
// away there; until none is. Then e = p'q' where p' is a prefix code. If there are fewer words than letters in
// B, go on with p', q'q, f' = p'q'q (it is gf or hf) and m + 1: this happens less often than there are letters.
// Otherwise q' is a product of maps b -> cb, and gp and hp have bounded delay. Now let x be a word with gp(x) =
// hp(x), and follow the overflow along x. While it is longer than a bound that depends on the delay, the next
// letter of x is determined by it, and so on until it is shorter again; it gets longer from finitely many short
// overflows by one letter each. So finitely many overflows occur at all. Those along w_n = p(x) are at most a
// fixed number of letters from these. (So systems need not be simplified through smaller alphabets B first: it
// changes no answer.)
//
// The proof that is kept (`Balance`) is the set of overflows. They and a state of refusal form an automaton;
// T_k(a) is the map of its states by the word g^k(a). The maps repeat since there are finitely many of them
// (found as Brent 1980 does).

namespace algae {

namespace {

D0L translated(const D0L& system, const std::shared_ptr<const Alphabet>& alphabet) {
    const auto translate = [&](const Word& word) {
        Word out;
        out.reserve(word.size());
        for (const Symbol a : word) out.push_back(*alphabet->find(system.alphabet->name(a)));
        return out;
    };
    std::vector<Word> images(alphabet->size());
    for (Symbol a = 0; a < images.size(); ++a) images[a] = {a};
    for (Symbol a = 0; a < system.alphabet->size(); ++a)
        images[*alphabet->find(system.alphabet->name(a))] = translate(system.successor(a));
    return make_d0l(alphabet, translate(system.axiom), std::move(images), system.name);
}

}  // namespace

SequencePair over_common_alphabet(const D0L& left, const D0L& right) {
    Alphabet letters = *left.alphabet;
    for (Symbol a = 0; a < right.alphabet->size(); ++a) letters.symbol(right.alphabet->name(a));
    const auto alphabet = std::make_shared<const Alphabet>(std::move(letters));
    return {alphabet, translated(left, alphabet), translated(right, alphabet)};
}

OverflowStep overflow_step(const SequencePair& systems, const Overflow& overflow, Symbol letter) {
    const auto extended = [&](Overflow::Ahead side, const Word& image) {
        Word word = overflow.ahead == side ? overflow.word : Word{};
        word.insert(word.end(), image.begin(), image.end());
        return word;
    };
    const Word left = extended(Overflow::Ahead::left, systems.left.successor(letter));
    const Word right = extended(Overflow::Ahead::right, systems.right.successor(letter));
    const auto [at, other] = std::mismatch(left.begin(), left.end(), right.begin(), right.end());
    OverflowStep step;
    step.agreed = static_cast<std::size_t>(at - left.begin());
    if (at != left.end() && other != right.end()) return step;
    step.next = at != left.end() || other == right.end()
                    ? Overflow{Overflow::Ahead::left, Word(at, left.end())}
                    : Overflow{Overflow::Ahead::right, Word(other, right.end())};
    return step;
}

namespace {

/// Compares the sequences of two D0L systems with the same axiom, generation by generation, without
/// writing the words out: where the letters of g^k(a) lead from an overflow is worked out once for each
/// letter a, overflow and k that occur. The systems and the budget must outlive it.
class OverflowWalk {
public:
    OverflowWalk(const SequencePair& systems, const Budget& budget)
        : systems_(systems),
          budget_(budget),
          matrix_(growth_matrix(systems.left)),
          row_(systems.alphabet->size(), 0) {
        for (std::size_t i = 0; i < systems.left.letters.size(); ++i)
            row_[systems.left.letters[i]] = i;
        lengths_.push_back(std::vector<Integer>(matrix_.size(), Integer(1)));
        number_of({});
    }

    /// Generations 0 to this number are known to be the same.
    std::uint64_t generations() const { return generations_; }
    /// All overflows that prefixes of the words before that generation have; the empty one first.
    const std::vector<Overflow>& overflows() const { return overflows_; }

    /// Compares the next generation: nothing if it is the same, otherwise the position, from 0, of the
    /// first letter that differs or that only one of the words has. After that it must not be called again.
    /// Throws BoundReached if what is kept takes more than budget.memory.
    std::optional<Integer> next_difference() {
        lengths_.push_back(matrix_ * lengths_.back());
        for (const Integer& length : lengths_.back())
            kept_ += sizeof(Integer) + bit_length(length) / 8;
        led_.emplace_back();
        check_memory();
        std::vector<Reading> open{{&systems_.left.axiom, generations_, 0, 0}};
        for (std::uint64_t turn = 1;; ++turn) {
            if (turn % 1024 == 0) check_memory();
            Reading& top = open.back();
            if (top.read == top.word->size()) {
                const Reading done = top;
                open.pop_back();
                if (open.empty()) {
                    if (!overflows_[done.at].word.empty()) return position({done}, 0);
                    break;
                }
                Reading& outer = open.back();
                const Symbol letter = (*outer.word)[outer.read++];
                led_[outer.level].emplace(std::uint64_t{letter} << 32 | outer.at, done.at);
                kept_ += 48;
                outer.at = done.at;
                continue;
            }
            const Symbol letter = (*top.word)[top.read];
            const auto known = led_[top.level].find(std::uint64_t{letter} << 32 | top.at);
            if (known != led_[top.level].end()) {
                top.at = known->second;
                ++top.read;
            } else if (top.level > 0) {
                open.push_back({&systems_.left.successor(letter), top.level - 1, 0, top.at});
            } else if (const auto next = first_step(letter, top.at)) {
                led_[0].emplace(std::uint64_t{letter} << 32 | top.at, *next);
                kept_ += 48;
                top.at = *next;
                ++top.read;
            } else {
                return position(open, agreed_);
            }
        }
        ++generations_;
        return std::nullopt;
    }

private:
    using Number = std::uint32_t;  // of an overflow
    /// A word of which `read` letters have been read, each standing for what it becomes in `level` steps.
    struct Reading {
        const Word* word;
        std::size_t level;
        std::size_t read;
        Number at;
    };

    std::optional<Number> first_step(Symbol letter, Number from) {
        OverflowStep step = overflow_step(systems_, overflows_[from], letter);
        if (step.next) return number_of(std::move(*step.next));
        agreed_ = step.agreed;
        return std::nullopt;
    }

    Number number_of(Overflow overflow) {
        const auto [place, is_new] =
            numbers_.emplace(std::move(overflow), static_cast<Number>(overflows_.size()));
        if (is_new) {
            overflows_.push_back(place->first);
            kept_ += 2 * sizeof(Symbol) * place->first.word.size() + 160;
        }
        return place->second;
    }

    /// What was read stands for a prefix of the last word; the overflow where reading stopped and the letters
    /// agreed on after it say how far the next words agree.
    Integer position(const std::vector<Reading>& open, std::size_t agreed) const {
        Integer found(agreed);
        for (const Reading& reading : open)
            for (std::size_t i = 0; i < reading.read; ++i)
                found += lengths_[reading.level + 1][row_[(*reading.word)[i]]];
        const Overflow& overflow = overflows_[open.back().at];
        if (overflow.ahead == Overflow::Ahead::left) found -= Integer(overflow.word.size());
        return found;
    }

    void check_memory() const {
        budget_.check();
        budget_.check_memory(kept_, "the overflows of one word over the other");
    }

    const SequencePair& systems_;
    const Budget& budget_;
    GrowthMatrix matrix_;
    std::vector<std::size_t> row_;               // of a letter in the matrix
    std::vector<std::vector<Integer>> lengths_;  // of g^k(letter), by k and row
    std::vector<Overflow> overflows_;
    std::map<Overflow, Number> numbers_;
    /// By level: where a letter leads from an overflow.
    std::vector<std::unordered_map<std::uint64_t, Number>> led_;
    std::size_t generations_ = 0;
    std::uint64_t kept_ = 0;  // bytes
    std::size_t agreed_ = 0;  // by the step that found the difference
};

/// A state by number; the number of states stands for refusal.
using State = std::uint32_t;
/// Where each state goes, by letter.
using Maps = std::vector<std::vector<State>>;

Maps first_maps(const SequencePair& systems, const std::vector<Overflow>& states) {
    const State refusal = static_cast<State>(states.size());
    std::map<Overflow, State> numbers;
    for (State q = 0; q < refusal; ++q) numbers.emplace(states[q], q);
    Maps maps(systems.alphabet->size());
    for (const Symbol a : systems.left.letters)
        for (const Overflow& overflow : states) {
            const OverflowStep step = overflow_step(systems, overflow, a);
            const auto found = step.next ? numbers.find(*step.next) : numbers.end();
            maps[a].push_back(found == numbers.end() ? refusal : found->second);
        }
    return maps;
}

/// Where the word leads from a state.
State led(const Maps& maps, const Word& word, State from, State refusal) {
    for (const Symbol a : word) {
        if (from == refusal) return refusal;
        from = maps[a][from];
    }
    return from;
}

}  // namespace

BalanceAttempt try_balance(const SequencePair& systems, std::vector<Overflow> states,
                           const Budget& budget) {
    const State refusal = static_cast<State>(states.size());
    budget.check_memory(states.size() * systems.left.letters.size() * 3 * sizeof(State),
                        "the maps of overflows");
    Maps maps = first_maps(systems, states), next = maps;
    Repetitions repetitions(maps);
    for (std::uint64_t step = 0;; ++step) {
        budget.check();
        if (repetitions.comes_again(maps, step)) {
            std::size_t bound = 0;
            for (const Overflow& overflow : states) bound = std::max(bound, overflow.word.size());
            return {Balance{bound, std::move(states), step, repetitions.earlier()}, 0};
        }
        if (led(maps, systems.left.axiom, 0, refusal) != 0) return {std::nullopt, step};
        for (const Symbol a : systems.left.letters)
            for (State q = 0; q < refusal; ++q)
                next[a][q] = led(maps, systems.left.successor(a), q, refusal);
        std::swap(maps, next);
    }
}

namespace {

constexpr std::uint64_t letters_before = 8, letters_shown = 20;

Word letters_from(const D0L& system, std::uint64_t generation, const Integer& from,
                  const Integer& length, const Budget& budget) {
    return from < length ? letters_at(system, generation, from, letters_shown, budget) : Word{};
}

SequenceEquality different(const SequencePair& systems, std::uint64_t generation, Integer position,
                           const Budget& budget) {
    SequenceDifference found;
    found.generation = generation;
    found.from = std::max<Integer>(Integer(0), position - letters_before);
    found.position = std::move(position);
    found.left_length = length(systems.left, generation, budget);
    found.right_length = length(systems.right, generation, budget);
    found.left = letters_from(systems.left, generation, found.from, found.left_length, budget);
    found.right = letters_from(systems.right, generation, found.from, found.right_length, budget);
    return {false, std::nullopt, std::move(found)};
}

std::string tried(const OverflowWalk& walk) {
    std::size_t longest = 0;
    for (const Overflow& overflow : walk.overflows())
        longest = std::max(longest, overflow.word.size());
    return "generations 0 to " + std::to_string(walk.generations()) + " are the same, with " +
           std::to_string(walk.overflows().size()) + " overflows of up to " +
           std::to_string(longest) + " letters so far, and these do not prove that all are";
}

}  // namespace

SequenceEquality equal_sequences(const D0L& left, const D0L& right, const Budget& budget) {
    const SequencePair systems = over_common_alphabet(left, right);
    const Word &first = systems.left.axiom, &second = systems.right.axiom;
    if (first != second) {
        const auto at =
            std::mismatch(first.begin(), first.end(), second.begin(), second.end()).first;
        return different(systems, 0, Integer(at - first.begin()), budget);
    }
    OverflowWalk walk(systems, budget);
    try {
        for (std::uint64_t next_attempt = 0;;) {
            const std::size_t known = walk.overflows().size();
            const std::uint64_t generation = walk.generations();
            if (auto position = walk.next_difference())
                return different(systems, generation + 1, std::move(*position), budget);
            if (generation < next_attempt || walk.overflows().size() > known) continue;
            BalanceAttempt attempt = try_balance(systems, walk.overflows(), budget);
            if (attempt.balance) return {true, std::move(attempt.balance), std::nullopt};
            next_attempt = attempt.generation + 1;
        }
    } catch (const BoundReached& bound) {
        throw BoundReached(bound.bound(), bound.what(), tried(walk));
    }
}

}  // namespace algae
