#include "language/language.hpp"

#include <algorithm>
#include <bit>
#include <map>

#include "exact/exact.hpp"
#include "language/detail/letters.hpp"
#include "system/system.hpp"

// Membership in the language of an 0L system, and derivations of members.
//
// For each t the table of all (letter, factor of the word) with letter =>^t factor gives that of t + 1, by one
// product of factors a rule; and it says whether the axiom derives the word in t steps. There are finitely many
// tables, so they repeat, and a repetition is found with one remembered table (Brent 1980). Time O(|word|^3 /
// 64 * size of the rules) a step. The steps before tables repeat are O(|word|) times a number that depends on
// the rules, which can be as large as the least common multiple of the lengths of cycles of letters. Successors
// with a common beginning share its products.
//
// Where each letter has one successor there is one word a generation. If the language is infinite the lengths
// of its words tend to infinity
// (growth functions of D0L systems: Rozenberg and Salomaa 1980, I.3), so the numbers of letters of each
// generation, worked out up to |word|, are followed until all letters that grow have outgrown the word; a
// generation is written out only if it has each letter as often as the word has. If the language is finite the
// generations themselves are followed until they repeat.
//
// A derivation in n steps goes forwards from the axiom and needs the tables of n, n - 1, ..., 0: every
// sqrt(n)-th is kept, those between are worked out again.

namespace algae {

namespace {

/// The factors of one word, and how the rules of one system put them together. A factor is a pair of
/// places from <= to in the word. The system must outlive it.
class FactorTables {
public:
    /// Which letters derive which factors in exactly t steps, for one t: for every letter and every
    /// place a row of bits, one for each place where a factor may end.
    using Table = std::vector<std::uint64_t>;
    using Row = std::vector<std::uint64_t>;

    FactorTables(const OL& system, const Word& word)
        : system_(&system),
          word_(&word),
          places_(word.size() + 1),
          width_((places_ + 63) / 64),
          index_(system.alphabet->size(), 0),
          beginnings_(1) {
        for (std::size_t i = 0; i < system.letters.size(); ++i) index_[system.letters[i]] = i;
        std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;
        for (std::size_t i = 0; i < system.letters.size(); ++i)
            for (const Word& successor : system.successors[system.letters[i]]) {
                std::size_t at = 0;
                for (const Symbol b : successor) {
                    const auto [found, is_new] =
                        known.try_emplace({at, index_[b]}, beginnings_.size());
                    if (is_new) beginnings_.push_back({at, index_[b], {}});
                    at = found->second;
                }
                beginnings_[at].whole_of.push_back(i);
            }
    }

    /// Bytes of one table.
    std::uint64_t bytes() const {
        return system_->letters.size() * places_ * width_ * sizeof(std::uint64_t);
    }

    /// t = 0: every letter derives itself.
    Table first() const {
        Table table(system_->letters.size() * places_ * width_, 0);
        for (std::size_t place = 0; place + 1 < places_; ++place) {
            const std::size_t letter = index_[(*word_)[place]];
            table[(letter * places_ + place) * width_ + (place + 1) / 64] |= std::uint64_t{1}
                                                                             << ((place + 1) % 64);
        }
        return table;
    }

    /// The table of t + 1 steps from that of t.
    void next(const Table& table, Table& following) const {
        following.assign(table.size(), 0);
        std::vector<std::uint64_t> ends(beginnings_.size() * width_);
        for (std::size_t place = 0; place < places_; ++place) {
            std::fill(ends.begin(), ends.end(), 0);
            ends[place / 64] = std::uint64_t{1} << (place % 64);
            for (std::size_t i = 0; i < beginnings_.size(); ++i) {
                const Beginning& beginning = beginnings_[i];
                std::uint64_t* const here = ends.data() + i * width_;
                if (i > 0)
                    extend(table, ends.data() + beginning.shorter * width_, beginning.letter, here);
                for (const std::size_t letter : beginning.whole_of) {
                    std::uint64_t* const to =
                        following.data() + (letter * places_ + place) * width_;
                    for (std::size_t k = place / 64; k < width_; ++k) to[k] |= here[k];
                }
            }
        }
    }

    /// Whether this word of letters derives the whole word.
    bool derives(const Table& table, const Word& letters) const {
        Row ends(width_, 0);
        ends[0] = 1;
        for (const Symbol a : letters) {
            Row further(width_, 0);
            extend(table, ends.data(), index_[a], further.data());
            ends = std::move(further);
        }
        return (ends[(places_ - 1) / 64] >> ((places_ - 1) % 64) & 1) != 0;
    }

    /// Where the factors of the letters end when `letters` derives the factor from..to; nothing if it
    /// does not.
    std::optional<std::vector<std::size_t>> split(const Table& table, const Word& letters,
                                                  std::size_t from, std::size_t to) const {
        std::vector<Row> ends(letters.size() + 1, Row(width_, 0));
        const auto has = [](const std::uint64_t* bits, std::size_t place) {
            return (bits[place / 64] >> (place % 64) & 1) != 0;
        };
        ends[0][from / 64] = std::uint64_t{1} << (from % 64);
        for (std::size_t i = 0; i < letters.size(); ++i)
            extend(table, ends[i].data(), index_[letters[i]], ends[i + 1].data());
        if (!has(ends.back().data(), to)) return std::nullopt;
        std::vector<std::size_t> stops(letters.size());
        for (std::size_t i = letters.size(); i-- > 0;) {
            stops[i] = to;
            std::size_t begin = to;  // the last place where it can begin
            while (!has(ends[i].data(), begin) || !has(row(table, index_[letters[i]], begin), to))
                --begin;
            to = begin;
        }
        return stops;
    }

private:
    /// A beginning of some successors: a shorter one and a letter. The first is the empty word.
    struct Beginning {
        std::size_t shorter = 0;
        std::size_t letter = 0;             // place in OL::letters
        std::vector<std::size_t> whole_of;  // letters that have it as a successor
    };

    const std::uint64_t* row(const Table& table, std::size_t letter, std::size_t place) const {
        return table.data() + (letter * places_ + place) * width_;
    }

    /// to := to united with the ends of factors of `letter` that begin where a factor in `ends` ended.
    void extend(const Table& table, const std::uint64_t* ends, std::size_t letter,
                std::uint64_t* to) const {
        for (std::size_t block = 0; block < width_; ++block)
            for (std::uint64_t bits = ends[block]; bits != 0; bits &= bits - 1) {
                const std::size_t place =
                    block * 64 + static_cast<std::size_t>(std::countr_zero(bits));
                const std::uint64_t* const further = row(table, letter, place);
                for (std::size_t k = block; k < width_; ++k) to[k] |= further[k];
            }
    }

    const OL* system_;
    const Word* word_;
    std::size_t places_;              // one more than the word has letters
    std::size_t width_;               // of a row, in words of 64 bits
    std::vector<std::size_t> index_;  // of a symbol in OL::letters
    std::vector<Beginning> beginnings_;
};

D0L d0l_of(const OL& system) {
    std::vector<Word> images;
    for (const auto& choices : system.successors) images.push_back(choices.front());
    return make_d0l(system.alphabet, system.axiom, std::move(images), system.name);
}

/// Numbers of letters, all above a bound taken as one above it: sums and products of exact numbers
/// and of these agree.
class Saturated {
public:
    explicit Saturated(std::uint64_t bound) : over_(bound + 1) {}
    std::uint64_t sum(std::uint64_t left, std::uint64_t right) const {
        return std::min(left + right, over_);
    }
    bool is_over(std::uint64_t number) const { return number >= over_; }

private:
    std::uint64_t over_;
};

/// How often each letter occurs, by symbol.
std::vector<std::uint64_t> occurrences(const Word& word, std::size_t size,
                                       const Saturated& numbers) {
    std::vector<std::uint64_t> count(size, 0);
    for (const Symbol a : word) count[a] = numbers.sum(count[a], 1);
    return count;
}

/// A letter and how often it occurs in a successor.
using Contents = std::vector<std::vector<std::pair<Symbol, std::uint64_t>>>;

Contents contents(const D0L& system) {
    Contents all(system.alphabet->size());
    for (const Symbol a : system.letters) {
        Word sorted = system.successor(a);
        std::sort(sorted.begin(), sorted.end());
        for (const Symbol b : sorted) {
            if (all[a].empty() || all[a].back().first != b) all[a].emplace_back(b, 0);
            ++all[a].back().second;
        }
    }
    return all;
}

std::uint64_t times(std::uint64_t left, std::uint64_t right, const Saturated& numbers) {
    if (left == 0 || right == 0) return 0;
    if (left > UINT32_MAX || right > UINT32_MAX) return numbers.sum(UINT32_MAX, UINT32_MAX);
    return numbers.sum(left * right, 0);
}

Membership infinite_membership(const D0L& system, const std::vector<char>& growing,
                               const Word& word, const Budget& budget) {
    using enum Membership::Reason;
    const Saturated numbers(word.size());
    const Contents rules = contents(system);
    const auto wanted = occurrences(word, system.alphabet->size(), numbers);
    auto count = occurrences(system.axiom, system.alphabet->size(), numbers);
    // Of what each letter becomes, step by step.
    std::vector<std::uint64_t> length(system.alphabet->size(), 1);
    auto next = count;
    for (std::uint64_t step = 0;; ++step) {
        if (step % 1024 == 0) budget.check();
        if (count == wanted && derive(system, step, budget) == word)
            return {true, derived, step, 0, 0};
        if (std::all_of(system.letters.begin(), system.letters.end(),
                        [&](Symbol a) { return !growing[a] || numbers.is_over(length[a]); }))
            return {false, outgrown, step, 0, 0};
        for (const Symbol a : system.letters) {
            next[a] = 0;
            for (const auto& [b, often] : rules[a])
                next[a] = numbers.sum(next[a], times(often, length[b], numbers));
        }
        for (const Symbol a : system.letters) length[a] = next[a];
        std::fill(next.begin(), next.end(), 0);
        for (const Symbol a : system.letters)
            for (const auto& [b, often] : rules[a])
                next[b] = numbers.sum(next[b], times(often, count[a], numbers));
        std::swap(count, next);
    }
}

Membership finite_membership(const D0L& system, const Word& word, const Budget& budget) {
    using enum Membership::Reason;
    Word now = system.axiom;
    Repetitions repetitions(now);
    for (std::uint64_t step = 0;; ++step) {
        if (step % 1024 == 0) budget.check();
        if (now == word) return {true, derived, step, 0, 0};
        if (repetitions.comes_again(now, step))
            return {false, periodic, step, repetitions.earlier(), 0};
        now = generation_after(system.rules.images(), now, budget);
    }
}

/// Membership for an 0L system whose letters have one successor each.
Membership deterministic_membership(const OL& system, const Word& word, const Budget& budget) {
    const LetterFutures futures = letter_futures(system);
    const D0L rules = d0l_of(system);
    const bool infinite = std::any_of(system.letters.begin(), system.letters.end(),
                                      [&](Symbol a) { return futures.growing[a] != 0; });
    return infinite ? infinite_membership(rules, futures.growing, word, budget)
                    : finite_membership(rules, word, budget);
}

/// The generations from 0 to `step`. Throws BoundReached if they have more than budget.letters letters
/// together.
Derivation deterministic_derivation(const OL& system, std::uint64_t step, const Budget& budget) {
    const D0L rules = d0l_of(system);
    Derivation found{{system.axiom}, {}};
    std::uint64_t letters = system.axiom.size();
    for (std::uint64_t t = 0; t < step; ++t) {
        if (t % 1024 == 0) budget.check();
        found.choices.emplace_back(found.words.back().size(), 0);
        found.words.push_back(generation_after(rules.rules.images(), found.words.back(), budget));
        letters += found.words.back().size() + 1;
        budget.check_memory(letters * 8, "the words of the derivation");
    }
    return found;
}

/// The first letter of the word that is in no word of the language.
std::optional<std::uint64_t> foreign_letter(const OL& system, const Word& word) {
    std::vector<char> known(system.alphabet->size(), 0);
    for (const Symbol a : system.letters) known[a] = 1;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (word[i] >= known.size() || !known[word[i]]) return i;
    return std::nullopt;
}

/// The tables of steps n, n - 1, ..., 0, with every stride-th kept and those between worked out again.
class TablesBackwards {
public:
    TablesBackwards(const FactorTables& tables, std::uint64_t n, const Budget& budget)
        : tables_(&tables), budget_(&budget), stride_(1) {
        while (stride_ * stride_ < n) ++stride_;
        budget.check_memory((n / stride_ + stride_ + 2) * tables.bytes(),
                            "the tables of a derivation");
        FactorTables::Table table = tables.first();
        for (std::uint64_t t = 0;; ++t) {
            budget.check();
            if (t % stride_ == 0) kept_.push_back(table);
            if (t == n) break;
            FactorTables::Table following;
            tables.next(table, following);
            table = std::move(following);
        }
    }

    const FactorTables::Table& of(std::uint64_t t) {
        if (block_.empty() || t / stride_ != number_) {
            budget_->check();
            number_ = t / stride_;
            block_.assign(1, kept_[static_cast<std::size_t>(number_)]);
            while (block_.size() < stride_) {
                FactorTables::Table following;
                tables_->next(block_.back(), following);
                block_.push_back(std::move(following));
            }
        }
        return block_[static_cast<std::size_t>(t % stride_)];
    }

private:
    const FactorTables* tables_;
    const Budget* budget_;
    std::uint64_t stride_;
    std::vector<FactorTables::Table> kept_, block_;
    std::uint64_t number_ = 0;
};

/// A letter and the factor of the word that it derives.
struct Share {
    Symbol letter;
    std::size_t from, to;
};

/// Appends what the letter becomes to `next`; returns the number of the rule.
std::uint32_t take_step(const OL& system, const LetterFutures& futures, const FactorTables& tables,
                        const FactorTables::Table& table, const Share& share,
                        std::vector<Share>& next) {
    const auto& choices = system.successors[share.letter];
    if (share.from == share.to) {
        const std::uint32_t choice = erasing_choice(system, futures, share.letter);
        for (const Symbol b : choices[choice]) next.push_back({b, share.from, share.from});
        return choice;
    }
    for (std::uint32_t choice = 0; choice < choices.size(); ++choice)
        if (const auto stops = tables.split(table, choices[choice], share.from, share.to)) {
            std::size_t from = share.from;
            for (std::size_t i = 0; i < stops->size(); ++i) {
                next.push_back({choices[choice][i], from, (*stops)[i]});
                from = (*stops)[i];
            }
            return choice;
        }
    throw Error("no rule of " + system.alphabet->name(share.letter) + " continues the derivation");
}

}  // namespace

Membership membership(const OL& system, const Word& word, const Budget& budget) {
    using enum Membership::Reason;
    if (const auto position = foreign_letter(system, word))
        return {false, foreign, 0, 0, *position};
    if (is_deterministic(system)) return deterministic_membership(system, word, budget);
    const FactorTables tables(system, word);
    budget.check_memory(3 * tables.bytes(), "the tables of what letters derive");
    FactorTables::Table table = tables.first(), following;
    Repetitions repetitions(table);
    for (std::uint64_t step = 0;; ++step) {
        budget.check();
        if (tables.derives(table, system.axiom)) return {true, derived, step, 0, 0};
        if (repetitions.comes_again(table, step))
            return {false, repeated, step, repetitions.earlier(), 0};
        tables.next(table, following);
        std::swap(table, following);
    }
}

std::optional<Derivation> find_derivation(const OL& system, const Word& word, std::uint64_t step,
                                          const Budget& budget) {
    if (foreign_letter(system, word)) return std::nullopt;
    if (is_deterministic(system)) {
        Derivation only = deterministic_derivation(system, step, budget);
        return only.words.back() == word ? std::optional(std::move(only)) : std::nullopt;
    }
    const FactorTables tables(system, word);
    const LetterFutures futures = letter_futures(system);
    TablesBackwards backwards(tables, step, budget);
    const auto stops = tables.split(backwards.of(step), system.axiom, 0, word.size());
    if (!stops) return std::nullopt;
    std::vector<Share> shares;
    for (std::size_t i = 0, from = 0; i < stops->size(); from = (*stops)[i++])
        shares.push_back({system.axiom[i], from, (*stops)[i]});
    Derivation found{{system.axiom}, {}};
    std::uint64_t letters = system.axiom.size();
    for (std::uint64_t left = step; left-- > 0;) {
        budget.check();
        std::vector<Share> next;
        std::vector<std::uint32_t> choices;
        const FactorTables::Table& table = backwards.of(left);
        for (const Share& share : shares)
            choices.push_back(take_step(system, futures, tables, table, share, next));
        shares = std::move(next);
        letters += shares.size();
        if (letters > budget.letters)
            throw BoundReached(Bound::letters, "the words of the derivation have more than " +
                                                   std::to_string(budget.letters) +
                                                   " letters together, the bound set" +
                                                   budget.by(Bound::letters));
        Word reached;
        for (const Share& share : shares) reached.push_back(share.letter);
        found.words.push_back(std::move(reached));
        found.choices.push_back(std::move(choices));
    }
    return found;
}

Derivation derivation(const OL& system, const Word& word, std::uint64_t step,
                      const Budget& budget) {
    std::optional<Derivation> found = find_derivation(system, word, step, budget);
    if (!found) throw Error("the word is not in generation " + std::to_string(step));
    return *std::move(found);
}

}  // namespace algae
