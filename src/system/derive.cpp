#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "system/system.hpp"
#include "watch/watch.hpp"
#include "word/word.hpp"

// Derivation without writing out more than is asked for.
//
// A walk goes through the derivation of generation n depth first and holds one position a generation, so that memory does
// not depend on the word. Text is sent in blocks that are spelled once (what each letter becomes in k steps, for the
// greatest k that fits about 1 MiB). A letter far into a word is found by stepping down: lengths of what each letter
// becomes say which letter holds the position; only about sqrt(n) rows of lengths are kept and the others worked out again.
// The words of a system with choices are a fold into finite sets of words, cut at a length; since there are only finitely many
// such families, the sequence of families repeats, and so all words up to a length are found.

namespace algae {

Fates::Fates(const D0L& system)
    : constant_(system.alphabet->size(), 0), gone_(lifetimes(system.rules)) {
    for (const Symbol a : system.letters) constant_[a] = system.successor(a) == Word{a};
}

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 20;

/// What each letter becomes in `steps` steps, spelled.
struct Blocks {
    Hom<Spellings> text;
    std::uint64_t steps;
};

std::size_t total_bytes(const Hom<Spellings>& row, const std::vector<Symbol>& letters) {
    std::size_t bytes = 0;
    for (const Symbol a : letters) bytes += row.images[a].text.size();
    return bytes;
}

/// The bytes that a further step would take, no more than a little over `block_bytes`.
std::size_t next_bytes(const D0L& system, const Hom<Spellings>& row) {
    std::size_t bytes = 0;
    for (const Symbol a : system.letters)
        for (const Symbol b : system.successor(a)) {
            bytes += row.images[b].text.size();
            if (bytes > block_bytes) return bytes;
        }
    return bytes;
}

Blocks blocks(const D0L& system, std::uint64_t n, const Budget& budget) {
    Blocks found{homomorphism(system, spelling_lift(*system.alphabet)), 0};
    std::size_t written =
        0;  // by all steps: words that grow slowly or not at all must not take long
    while (found.steps < n && next_bytes(system, found.text) <= block_bytes &&
           written < 64 * block_bytes) {
        budget.check();
        found.text = found.text.after(system.rules, system.letters);
        ++found.steps;
        written += total_bytes(found.text, system.letters) + 64 * system.letters.size();
    }
    return found;
}

class StringSink : public TextSink {
public:
    void write(std::string_view piece) override { text += piece; }
    void flush() override {}
    std::string text;
};

}  // namespace

bool derive_text(const D0L& system, std::uint64_t n, TextSink& sink, const Budget& budget) {
    const Fates fates(system);
    const Blocks ready = blocks(system, n, budget);
    const Spellings& spellings = ready.text.monoid;
    bool begun = false;
    Symbol last = 0;
    std::uint64_t visits = 0;
    WorkCount pieces("piece of the word");
    walk(system, fates, n, [&](Symbol a, std::uint64_t steps) {
        if (++visits % 1024 == 0) budget.check();
        pieces.at(visits);
        if (steps > ready.steps) return true;
        // Below the blocks' level (constants, and axioms of young generations) nothing is tabulated
        // but the letter itself and the blocks; a constant is its own block.
        const auto& block = ready.text.images[a];
        if (block.text.empty()) return false;
        if (begun && spellings.blank_between(last, block.first)) sink.write(" ");
        sink.write(block.text);
        begun = true;
        last = block.last;
        return false;
    });
    sink.flush();
    return begun;
}

std::string derived_text(const D0L& system, std::uint64_t n, const Budget& budget) {
    StringSink sink;
    derive_text(system, n, sink, budget);
    return std::move(sink.text);
}

Word derive(const D0L& system, std::uint64_t n, const Budget& budget) {
    const Fates fates(system);
    Word word;
    std::uint64_t visits = 0;
    walk(system, fates, n, [&](Symbol a, std::uint64_t steps) {
        if (++visits % 65536 == 0) budget.check();
        if (steps > 0) return true;
        if (word.size() == budget.letters)
            throw BoundReached(Bound::letters,
                               "generation " + std::to_string(n) + " has more than " +
                                   std::to_string(budget.letters) + " letters, the bound set" +
                                   budget.by(Bound::letters));
        word.push_back(a);
        return true;
    });
    return word;
}

namespace {

/// The lengths of the words that letters become in k steps, none counted beyond a cap. Rows are
/// kept at every `stride`-th k and worked out again between, so n rows take the space of 2 sqrt(n).
class CappedLengths {
public:
    CappedLengths(const D0L& system, std::uint64_t n, const Integer& cap, const Budget& budget)
        : system_(system), cap_(cap), budget_(budget) {
        while (stride_ < std::uint64_t{1} << 32 && stride_ * stride_ < n) stride_ *= 2;
        Row row(system.alphabet->size(), Integer(0));
        for (const Symbol a : system.letters) row[a] = 1;
        for (std::uint64_t k = 0;; ++k) {
            if (k % 1024 == 0) budget.check();
            if (k % stride_ == 0) {
                kept_.push_back(row);
                check_memory();
            }
            if (k == n) break;
            Row next = after(row);
            if (next == row) {  // and so for ever
                settled_ = k;
                break;
            }
            row = std::move(next);
        }
    }

    const Integer& of(Symbol a, std::uint64_t k) {
        k = std::min(k, settled_);
        const std::uint64_t segment = k / stride_;
        if (segment != segment_ || rows_.empty()) {
            segment_ = segment;
            rows_.assign(1, kept_.at(static_cast<std::size_t>(segment)));
        }
        while (rows_.size() <= k % stride_) {
            if (rows_.size() % 1024 == 0) {
                budget_.check();
                check_memory();
            }
            rows_.push_back(after(rows_.back()));
        }
        return rows_[static_cast<std::size_t>(k % stride_)][a];
    }

private:
    using Row = std::vector<Integer>;

    Row after(const Row& row) const {
        Row next(row.size(), Integer(0));
        for (const Symbol a : system_.letters) {
            for (const Symbol b : system_.successor(a)) {
                next[a] += row[b];
                if (next[a] >= cap_) {
                    next[a] = cap_;
                    break;
                }
            }
        }
        return next;
    }

    void check_memory() const {
        const std::uint64_t number =
            sizeof(Integer) + (bit_length(cap_) > 62 ? 16 + bit_length(cap_) / 8 : 0);
        budget_.check_memory((kept_.size() + rows_.size()) * system_.alphabet->size() * number,
                             "the table of lengths");
    }

    const D0L& system_;
    Integer cap_;
    const Budget& budget_;
    std::uint64_t stride_ = 1;
    std::uint64_t settled_ = UINT64_MAX;
    std::vector<Row> kept_;
    std::uint64_t segment_ = UINT64_MAX;
    std::vector<Row> rows_;
};

struct Step {
    const Symbol* next;
    const Symbol* end;
    std::uint64_t steps;
};

}  // namespace

Word letters_at(const D0L& system, std::uint64_t n, const Integer& at, std::uint64_t count,
                const Budget& budget) {
    count = std::min(count, budget.letters == UINT64_MAX ? UINT64_MAX - 1 : budget.letters + 1);
    if (at < 0)
        throw Error("position " + to_string(at) +
                    " is before the beginning: positions count from 0");
    const Fates fates(system);
    CappedLengths lengths(system, n, at + 1, budget);
    // The way down to the letter: at every generation the rest of a successor still to be read.
    std::vector<Step> path{{system.axiom.data(), system.axiom.data() + system.axiom.size(), n}};
    Integer left = at;
    std::uint64_t visits = 0;
    for (;;) {
        Step& here = path.back();
        while (here.next != here.end && lengths.of(*here.next, here.steps) <= left) {
            left -= lengths.of(*here.next, here.steps);
            ++here.next;
        }
        if (here.next == here.end) {
            // Only the axiom's row can end here: below, the letter is known to reach far enough.
            throw Error("position " + to_string(at) + " is past the end: generation " +
                        std::to_string(n) + " has " + to_string(at - left) + " letters");
        }
        if (here.steps == 0 || fates.is_constant(*here.next)) break;
        if (++visits % 4096 == 0) {
            budget.check();
            budget.check_memory(path.capacity() * sizeof(Step), "the way down to the letter");
        }
        const std::uint64_t steps = here.steps - 1;
        const Word& successor = system.successor(*here.next++);
        while (here.next != here.end && fates.is_gone(*here.next, here.steps)) ++here.next;
        if (here.next == here.end) path.pop_back();
        path.push_back({successor.data(), successor.data() + successor.size(), steps});
        // Every row above still gives a letter, so of more rows than letters asked for the uppermost
        // are never read.
        if (path.size() / 2 > count + 512)
            path.erase(path.begin(), path.end() - static_cast<std::ptrdiff_t>(count + 1));
    }
    // From here on letters follow each other without counting.
    Word found;
    while (found.size() < count && !path.empty()) {
        if (++visits % 65536 == 0) budget.check();
        Step& here = path.back();
        if (here.next == here.end) {
            path.pop_back();
            continue;
        }
        const Symbol a = *here.next++;
        const std::uint64_t steps = here.steps;
        if (steps == 0 || fates.is_constant(a)) {
            if (found.size() == budget.letters)
                throw BoundReached(Bound::letters, "more than " + std::to_string(budget.letters) +
                                                       " letters asked for, the bound set" +
                                                       budget.by(Bound::letters));
            found.push_back(a);
        } else if (!fates.is_gone(a, steps)) {
            const Word& successor = system.successor(a);
            while (here.next != here.end && fates.is_gone(*here.next, steps)) ++here.next;
            if (here.next == here.end) path.pop_back();
            path.push_back({successor.data(), successor.data() + successor.size(), steps - 1});
        }
    }
    return found;
}

namespace {

auto word_set_lift(const Budget& budget, std::optional<std::size_t> longest) {
    const WordSets sets(budget, longest.value_or(std::numeric_limits<std::size_t>::max()));
    const bool keep = !longest || *longest > 0;
    return Lift{
        sets, [keep](Symbol a) { return keep ? std::vector<Word>{Word{a}} : std::vector<Word>{}; }};
}

/// The same words in shortlex order of names.
std::vector<Word> by_name(std::vector<Word> words, const Alphabet& alphabet) {
    const auto rank = alphabet.ranks();
    std::sort(words.begin(), words.end(), [&](const Word& left, const Word& right) {
        if (left.size() != right.size()) return left.size() < right.size();
        return std::lexicographical_compare(left.begin(), left.end(), right.begin(), right.end(),
                                            [&](Symbol a, Symbol b) { return rank[a] < rank[b]; });
    });
    return words;
}

}  // namespace

std::vector<Word> words_of_generation(const OL& system, std::uint64_t n,
                                      std::optional<std::size_t> longest, const Budget& budget) {
    return by_name(fold(system, n, word_set_lift(budget, longest), budget), *system.alphabet);
}

std::vector<Word> words_up_to(const OL& system, std::size_t longest, const Budget& budget) {
    const auto lift = word_set_lift(budget, longest);
    const WordSets& sets = lift.monoid;
    using Family = std::vector<std::vector<Word>>;
    Family family(system.alphabet->size());
    for (const Symbol a : system.letters) family[a] = lift.letter(a);
    std::vector<Word> found;
    // The families repeat from some generation on (Brent 1980): one of them is remembered, and a
    // later one each time twice as many generations have passed.
    Family remembered = family;
    for (std::uint64_t steps = 0, until = 1;;) {
        budget.check();
        const Hom<WordSets> phi{sets, family};
        sets.add(found, phi(system.axiom));
        std::uint64_t bytes = 0;
        for (const Symbol a : system.letters) {
            family[a].clear();
            for (const Word& successor : system.successors[a]) sets.add(family[a], phi(successor));
            bytes += sizeof(family[a]);
            for (const Word& word : family[a]) bytes += sizeof(Word) + word.size() * sizeof(Symbol);
        }
        budget.check_memory(bytes, "the sets of words up to that length");
        if (family == remembered) break;
        if (++steps == until) {
            remembered = family;
            until *= 2;
            steps = 0;
        }
    }
    return by_name(std::move(found), *system.alphabet);
}

namespace {

std::uint64_t bytes_of(const std::vector<Word>& words) {
    std::uint64_t bytes = 0;
    for (const Word& word : words) bytes += 3 * sizeof(Word) + word.size() * sizeof(Symbol);
    return bytes;
}

}  // namespace

std::vector<Word> words_of_generation(const IL& system, std::uint64_t n,
                                      std::optional<std::size_t> longest, const Budget& budget) {
    // Where nothing is erased, words that are too long have only descendants that are.
    const std::optional<std::size_t> most = is_propagating(system) ? longest : std::nullopt;
    ContextStep step(system);
    std::vector<Word> words;
    if (!most || system.axiom.size() <= *most) words.push_back(system.axiom);
    for (std::uint64_t t = 0; t < n && !words.empty(); ++t) {
        std::set<Word> next;
        std::uint64_t bytes = 0;
        for (const Word& word : words) {
            std::vector<Word> found = step.next(word, most, budget);
            bytes += bytes_of(found);
            budget.check_memory(bytes, "the words of a generation");
            next.insert(std::make_move_iterator(found.begin()),
                        std::make_move_iterator(found.end()));
        }
        std::vector<Word> sorted(next.begin(), next.end());
        if (sorted == words) break;  // and so for ever
        words = std::move(sorted);
    }
    if (longest) std::erase_if(words, [&](const Word& word) { return word.size() > *longest; });
    return by_name(std::move(words), *system.alphabet);
}

std::vector<Word> words_up_to(const IL& system, std::size_t longest, const Budget& budget) {
    const bool propagating = is_propagating(system);
    const std::optional<std::size_t> most = propagating ? std::optional(longest) : std::nullopt;
    ContextStep step(system);
    std::set<Word> known;
    std::vector<const Word*> open;
    std::uint64_t bytes = 0;
    const auto add = [&](Word word) {
        const std::uint64_t size = 4 * sizeof(Word) + word.size() * sizeof(Symbol);
        const auto [place, is_new] = known.insert(std::move(word));
        if (!is_new) return;
        open.push_back(&*place);
        bytes += size;
        if (propagating) return budget.check_memory(bytes, "the words up to that length");
        constexpr std::uint64_t part = 64;
        if (bytes > budget.memory / part)
            throw BoundReached(Bound::method,
                               "rules erase letters, so longer words may have short descendants, "
                               "and no method finds all of "
                               "them; of the " +
                                   std::to_string(known.size()) +
                                   " words seen none is left out for its length; the words of one "
                                   "generation can be asked for");
    };
    if (!most || system.axiom.size() <= *most) add(system.axiom);
    for (std::size_t i = 0; i < open.size(); ++i) {
        budget.check();
        for (Word& word : step.next(*open[i], most, budget)) add(std::move(word));
    }
    std::vector<Word> words;
    for (const Word& word : known)
        if (word.size() <= longest) words.push_back(word);
    return by_name(std::move(words), *system.alphabet);
}

}  // namespace algae
