#include "language/detail/equality.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "language/detail/letters.hpp"
#include "system/system.hpp"

// D0L language equivalence, decided by sequence equivalence (after Nielsen 1974).
//
// Finite languages are compared word by word. Let both be infinite, with sequences w and v.
// Theorem. If the words of both languages have the same sets of letter counts, then there is a finite plan of
// single words and sections
// (w_{s+pn}), (v_{t+qn}), n = 0, 1, ..., in which each word of each sequence stands once, and letter counts on
// both sides agree. The languages are equal if and only if all that is paired is equal.
// Proof. No two words of a sequence have the same counts (see GenerationCounts). So there is one bijection n ->
// m(n) for which w_n and v_m(n) have the same counts, and equal words must be paired by it: this is the last
// sentence. Lengths grow like n^d c^n, up to constant factors, c >= 1 (one system's sections all grow alike,
// since one step multiplies the length by a bounded factor). If c > 1, both sequences have the same c and d and
// |m(n) - n| is bounded, otherwise m would not be onto or not be injective; for each difference the n with m(n)
// = n + difference are the zeros of linear recurrences, so an ultimately periodic set (Skolem, Mahler, Lech).
// If c = 1, counts are vectors of polynomials on the classes of numbers modulo some period; where two of them
// of equal degree meet again and again with bounded gaps, m(n) is linear with a rational slope there; other
// meetings have gaps that tend to infinity, and since the meetings with bounded gaps leave nothing out or a
// whole class, which the others could not fill, there are finitely many others.
//
// More and more generations are counted until the plan shows, or a word appears whose counts the other language
// does not have: as soon as all later words of the other are longer.
//
// Inclusion. Whether L(H) <= L(G) is decidable (Ruohonen, The inclusion problem for D0L languages, 1979). If it is so, each word of H
// has its counts in one generation m(n) of G, as above, m is injective, and a plan is one in which each word of H stands. If both
// languages grow exponentially, or both like n^d, the ratio m(n)/n is bounded; the plan is looked for as above, without asking that
// each generation of G stands in it. It does not show where H grows faster than every section of G, as {a^(n^2) b} within {a^n b}: then
// the search ends after 512 generations of H without an answer. It is not needed where L(G) is regular
// (deterministic_regularity.cpp). H cannot grow more slowly than G: then it has a word outside, found by the counts.

namespace algae {

OL ol_of(const D0L& system) {
    OL found{system.alphabet, system.axiom, {}, system.letters, system.name};
    for (const Word& image : system.rules.images()) found.successors.push_back({image});
    return found;
}

namespace {

/// How often each letter occurs, by symbol (the Parikh vector of a word).
using LetterCounts = std::vector<Integer>;

/// The letter counts of the generations of a D0L system with an infinite language, as far as they are asked
/// for. No two are the same: counts that came again would come again for ever, and there are only finitely
/// many words with the same counts, but infinitely many generations, all of them different words.
class GenerationCounts {
public:
    /// The system and the budget must outlive it.
    GenerationCounts(const D0L& system, const Budget& budget)
        : system_(system),
          budget_(budget),
          matrix_(growth_matrix(system)),
          row_(axiom_counts(system)),
          letter_lengths_(matrix_.size(), Integer(1)) {
        const LetterFutures futures = letter_futures(ol_of(system));
        for (std::size_t i = 0; i < system.letters.size(); ++i)
            if (futures.growing[system.letters[i]]) growing_.push_back(i);
    }

    /// Works out generations 0 to size - 1. Throws BoundReached if they take more than budget.memory.
    void extend(std::uint64_t size) {
        while (counts_.size() < size) {
            budget_.check();
            LetterCounts counts(system_.alphabet->size());
            Integer length;
            for (std::size_t i = 0; i < row_.size(); ++i) {
                length += row_[i];
                kept_ += 4 * sizeof(Integer) + bit_length(row_[i]) / 4;
                counts[system_.letters[i]] = std::move(row_[i]);
            }
            budget_.check_memory(kept_, "the numbers of letters of the generations");
            for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = counts[system_.letters[i]];
            row_ = row_ * matrix_;
            letter_lengths_ = matrix_ * letter_lengths_;
            generations_.emplace(counts, counts_.size());
            counts_.push_back(std::move(counts));
            lengths_.push_back(std::move(length));
        }
    }
    std::size_t size() const { return counts_.size(); }
    /// Of a generation below size().
    const LetterCounts& operator[](std::uint64_t generation) const {
        return counts_[static_cast<std::size_t>(generation)];
    }
    const Integer& length(std::uint64_t generation) const {
        return lengths_[static_cast<std::size_t>(generation)];
    }

    /// The generation with these counts, if it is one of those worked out.
    std::optional<std::uint64_t> generation_of(const LetterCounts& counts) const {
        const auto found = generations_.find(counts);
        return found == generations_.end() ? std::nullopt : std::optional(found->second);
    }

    /// All words of generation size() and later have at least so many letters: each such word has some
    /// letter that grows, `size()` steps later.
    Integer least_later_length() const {
        Integer least = letter_lengths_[growing_.front()];
        for (const std::size_t i : growing_) least = std::min(least, letter_lengths_[i]);
        return least;
    }

private:
    const D0L& system_;
    const Budget& budget_;
    GrowthMatrix matrix_;
    std::vector<std::size_t> growing_;     // rows of the letters that grow
    std::vector<Integer> row_;             // of the next generation
    std::vector<Integer> letter_lengths_;  // of what each letter becomes in size() steps
    std::vector<LetterCounts> counts_;
    std::vector<Integer> lengths_;
    std::map<LetterCounts, std::uint64_t> generations_;
    std::uint64_t kept_ = 0;  // bytes
};

void check_size(std::uint64_t letters, const Budget& budget) {
    budget.check();
    budget.check_memory(letters * sizeof(Symbol), "the words of the finite language");
}

}  // namespace

std::set<Word> words_of(const D0L& system, const Budget& budget) {
    std::set<Word> words;
    std::uint64_t letters = 0;
    Word word = system.axiom;
    while (words.insert(word).second) {
        letters += word.size() + 24;
        check_size(letters, budget);
        word = system.rules(word);
    }
    return words;
}

namespace {

/// The first generation whose word is not in the set; none if the language of the system is finite
/// and all its words are. Ends, since a D0L system with an infinite language has no word twice.
std::optional<std::uint64_t> first_generation_outside(const D0L& system,
                                                      const std::set<Word>& words,
                                                      const Budget& budget) {
    Word word = system.axiom;
    for (std::uint64_t generation = 0; generation <= words.size(); ++generation) {
        if (!words.contains(word)) return generation;
        word = system.rules(word);
        check_size(word.size(), budget);
    }
    return std::nullopt;  // some word has come again
}

/// Which words of two sequences are to be compared: single ones (numbers on the left and on the right), and
/// sections. Each sequence's numbers all occur, each once.
struct SectionPlan {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> words;
    std::vector<Section> sections;
};

using Partners = std::vector<
    std::uint64_t>;  // by generation of the left system: the right one's with its counts

constexpr std::uint64_t longest_cycle = 1'000'000;  // of the numbers that progressions cover

Partners partners(const GenerationCounts& left, const GenerationCounts& right) {
    Partners found;
    for (std::size_t n = 0; n < left.size(); ++n) {
        const auto partner = right.generation_of(left[n]);
        if (!partner) break;
        found.push_back(*partner);
    }
    return found;
}

/// Sections with this step that begin where the partners become regular, if that is soon enough to believe it.
std::optional<SectionPlan> plan_with_step(const Partners& found, std::size_t step) {
    if (found.size() < 4 * step) return std::nullopt;
    const auto advance = [&](std::size_t n) {
        return static_cast<std::int64_t>(found[n + step] - found[n]);
    };
    std::size_t begin = found.size() - step;
    while (begin > 0 && advance(begin - 1) > 0 &&
           (begin + step > found.size() - step || advance(begin - 1) == advance(begin - 1 + step)))
        --begin;
    if (found.size() - begin < std::max(4 * step, found.size() / 2)) return std::nullopt;
    SectionPlan plan;
    for (std::size_t n = 0; n < begin; ++n) plan.words.emplace_back(n, found[n]);
    for (std::size_t n = begin; n < begin + step; ++n)
        plan.sections.push_back({n, step, found[n], static_cast<std::uint64_t>(advance(n))});
    return plan;
}

bool covers_right(const SectionPlan& plan) {
    std::vector<std::uint64_t> single;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> progressions;
    for (const auto& [left, right] : plan.words) single.push_back(right);
    for (const Section& section : plan.sections)
        progressions.emplace_back(section.right, section.stride);
    return covers_all(single, progressions);
}

bool counts_agree(const SectionPlan& plan, GenerationCounts& left, GenerationCounts& right,
                  std::size_t letters) {
    for (const Section& section : plan.sections) {
        left.extend(section.left + letters * section.step + 1);
        right.extend(section.right + letters * section.stride + 1);
        for (std::size_t k = 0; k < letters; ++k)
            if (left[section.left + k * section.step] != right[section.right + k * section.stride])
                return false;
    }
    return true;
}

}  // namespace

bool covers_all(const std::vector<std::uint64_t>& single,
                const std::vector<std::pair<std::uint64_t, std::uint64_t>>& progressions) {
    std::uint64_t from = 0, cycle = 1;
    for (const std::uint64_t n : single) from = std::max(from, n + 1);
    for (const auto& [first, difference] : progressions) {
        from = std::max(from, first);
        cycle = std::lcm(cycle, difference);
        if (cycle > longest_cycle || from > longest_cycle) return false;
    }
    std::vector<char> covered(static_cast<std::size_t>(from + cycle), 0);
    for (const std::uint64_t n : single) covered[static_cast<std::size_t>(n)] = 1;
    for (const auto& [first, difference] : progressions)
        for (std::uint64_t n = first; n < covered.size(); n += difference)
            covered[static_cast<std::size_t>(n)] = 1;
    return std::find(covered.begin(), covered.end(), 0) == covered.end();
}

namespace {

/// The plan that pairs words with the same letter counts, for all n, if there is one that shows in the
/// generations worked out. That counts agree throughout a section is proved: both obey linear recurrences
/// whose orders are the numbers of accessible letters, so as many first terms as both together decide.
/// `covers`: each generation of the right system must stand in it. May work out further generations.
std::optional<SectionPlan> section_plan(GenerationCounts& left, GenerationCounts& right,
                                        std::size_t letters, bool covers, const Budget& budget) {
    const Partners found = partners(left, right);
    for (std::size_t step = 1; 4 * step <= found.size(); ++step) {
        budget.check();
        auto plan = plan_with_step(found, step);
        if (plan && (!covers || covers_right(*plan)) && counts_agree(*plan, left, right, letters))
            return plan;
    }
    return std::nullopt;
}

constexpr std::size_t first_size = 16;              // generations that are counted to begin with
constexpr std::uint64_t longest_tried = 4096;       // words up to this length are compared at once
constexpr std::uint64_t longest_shown = 1'000'000;  // letters of a witness

LanguageEquality not_equal(const SequencePair& systems, bool in_left, std::uint64_t generation,
                           std::optional<std::uint64_t> alike, const Budget& budget) {
    const D0L& system = in_left ? systems.left : systems.right;
    LanguageEquality found;
    found.difference = LanguageDifference{in_left, generation, length(system, generation, budget),
                                          std::nullopt, alike};
    if (found.difference->length <= Integer(std::min(longest_shown, budget.letters)))
        found.difference->word = derive(system, generation, budget);
    return found;
}

/// The system whose generation n is generation first + n step of this one.
D0L section_of(const D0L& system, std::uint64_t first, std::uint64_t step, const Budget& budget) {
    return make_d0l(system.alphabet, derive(system, first, budget),
                    power_of_rules(system, step, budget), system.name);
}

/// Whether these generations are the same word.
bool is_same_word(const SequencePair& systems, std::uint64_t left, std::uint64_t right,
                  const Budget& budget) {
    return derive(systems.left, left, budget) == derive(systems.right, right, budget);
}

/// Compares all that is paired.
LanguageEquality compared(const SequencePair& systems, const SectionPlan& plan,
                          const Budget& budget) {
    LanguageEquality found;
    found.words = plan.words;
    for (const auto& [left, right] : plan.words)
        if (!is_same_word(systems, left, right, budget))
            return not_equal(systems, true, left, right, budget);
    std::optional<std::pair<std::uint64_t, std::uint64_t>> different;
    for (const Section& section : plan.sections) {
        SequenceEquality sequences = equal_sequences(
            section_of(systems.left, section.left, section.step, budget),
            section_of(systems.right, section.right, section.stride, budget), budget);
        if (sequences.equal) {
            found.sections.push_back({section, std::move(*sequences.balance)});
            continue;
        }
        const std::uint64_t n = sequences.difference->generation;
        const std::pair at{section.left + n * section.step, section.right + n * section.stride};
        if (!different || at < *different) different = at;
    }
    if (different) return not_equal(systems, true, different->first, different->second, budget);
    found.equal = true;
    return found;
}

/// Both languages infinite.
class InfiniteComparison {
public:
    InfiniteComparison(const SequencePair& systems, const Budget& budget)
        : systems_(systems),
          budget_(budget),
          left_(systems.left, budget),
          right_(systems.right, budget) {}

    LanguageEquality decided() {
        const std::size_t letters = systems_.left.letters.size() + systems_.right.letters.size();
        for (size_ = first_size;; size_ *= 2) {
            left_.extend(size_);
            right_.extend(size_);
            if (auto found = short_difference()) return std::move(*found);
            if (const auto plan = section_plan(left_, right_, letters, true, budget_))
                return compared(systems_, *plan, budget_);
        }
    }

    std::string tried() const {
        return "the numbers of letters of generations 0 to " + std::to_string(size_) +
               " were compared, and neither language is known to have a word that the other has "
               "not";
    }

private:
    /// Of the generations counted: the first word that is not in the other language, as far as that shows in
    /// letter counts, or it is short.
    std::optional<LanguageEquality> short_difference() {
        const Integer least_left = left_.least_later_length(),
                      least_right = right_.least_later_length();
        for (std::uint64_t n = 0; n < std::min(left_.size(), right_.size()); ++n) {
            const auto partner = right_.generation_of(left_[n]);
            if (!partner && left_.length(n) < least_right)
                return not_equal(systems_, true, n, std::nullopt, budget_);
            if (!left_.generation_of(right_[n]) && right_.length(n) < least_left)
                return not_equal(systems_, false, n, std::nullopt, budget_);
            if (partner && left_.length(n) <= Integer(longest_tried) &&
                !is_same_word(systems_, n, *partner, budget_))
                return not_equal(systems_, true, n, partner, budget_);
        }
        return std::nullopt;
    }

    const SequencePair& systems_;
    const Budget& budget_;
    GenerationCounts left_, right_;
    std::size_t size_ = 0;
};

/// At least one language finite.
LanguageEquality finite_comparison(const SequencePair& systems, bool left_finite, bool right_finite,
                                   const Budget& budget) {
    std::set<Word> left, right;
    if (right_finite) {
        right = words_of(systems.right, budget);
        if (const auto n = first_generation_outside(systems.left, right, budget))
            return not_equal(systems, true, *n, std::nullopt, budget);
    }
    if (left_finite) {
        left = words_of(systems.left, budget);
        if (const auto n = first_generation_outside(systems.right, left, budget))
            return not_equal(systems, false, *n, std::nullopt, budget);
    }
    return {true, true, left.size(), {}, {}, std::nullopt};
}

constexpr std::uint64_t most_looked_at = 512;  // generations of the language that is to be within
constexpr std::uint64_t most_of_other = 16;    // times as many of the other one

}  // namespace

std::vector<Word> power_of_rules(const D0L& system, std::uint64_t exponent, const Budget& budget) {
    std::vector<Word> images(system.rules.images().size());
    for (const Symbol a : system.letters) images[a] = {a};
    for (std::uint64_t n = 0; n < exponent; ++n) {
        std::uint64_t letters = 0;
        for (const Symbol a : system.letters) {
            images[a] = system.rules(images[a]);
            letters += images[a].size();
            budget.check_memory(letters * sizeof(Symbol),
                                "the images of the letters under a power of the rules");
        }
        budget.check();
    }
    return images;
}

LanguageInclusion included_language(const D0L& left, const D0L& right, const Budget& budget) {
    const SequencePair systems = over_common_alphabet(left, right);
    const std::size_t letters = systems.left.letters.size() + systems.right.letters.size();
    GenerationCounts inner(systems.left, budget), outer(systems.right, budget);
    LanguageInclusion found;
    const auto outside = [&](LanguageEquality comparison) {
        found.included = false;
        found.difference = std::move(comparison.difference);
    };
    for (std::uint64_t size = first_size; !found.included && size <= most_looked_at; size *= 2) {
        found.generations = size;
        inner.extend(size);
        outer.extend(size);
        Integer longest;
        for (std::uint64_t n = 0; n < size; ++n) longest = std::max(longest, inner.length(n));
        while (outer.least_later_length() <= longest && outer.size() < most_of_other * size)
            outer.extend(2 * outer.size());
        const Integer least = outer.least_later_length();
        for (std::uint64_t n = 0; n < size && !found.included; ++n) {
            const auto partner = outer.generation_of(inner[n]);
            if (partner ? inner.length(n) <= Integer(longest_tried) &&
                              !is_same_word(systems, n, *partner, budget)
                        : inner.length(n) < least)
                outside(not_equal(systems, true, n, partner, budget));
        }
        if (found.included) break;
        const auto plan = section_plan(inner, outer, letters, false, budget);
        if (!plan) continue;
        LanguageEquality paired = compared(systems, *plan, budget);
        if (paired.equal) {
            found.included = true;
            found.words = std::move(paired.words);
            found.sections = std::move(paired.sections);
        } else {
            outside(std::move(paired));
        }
    }
    return found;
}

LanguageEquality equal_languages(const D0L& left, const D0L& right, const Budget& budget) {
    const SequencePair systems = over_common_alphabet(left, right);
    const bool left_finite = finiteness(ol_of(systems.left)).finite,
               right_finite = finiteness(ol_of(systems.right)).finite;
    if (left_finite || right_finite)
        return finite_comparison(systems, left_finite, right_finite, budget);
    InfiniteComparison comparison(systems, budget);
    try {
        return comparison.decided();
    } catch (const BoundReached& bound) {
        throw BoundReached(bound.bound(), bound.what(), comparison.tried());
    }
}

}  // namespace algae
