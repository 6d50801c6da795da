#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include "exact/exact.hpp"
#include "system/detail/interaction.hpp"
#include "system/system.hpp"
#include "watch/watch.hpp"

// Systems with interactions (IL): generations by derivation, one step in time linear in the word.
//
// What a letter becomes depends on its neighbours, so there is no fold. `ContextStep` is the relation of derivation where
// letters have choices; its words are the product of what the letters may become. `Development` chooses an engine by the word at hand: the
// automaton of contexts for any system (interaction_fast.cpp), bit planes for cellular automata, whose words keep their length,
// and a table of windows for long words over few letters that grow. All engines give the same words; tests compare
// each with the others and with a slow oracle.

namespace algae {

std::size_t Windows::bits() const {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::bit_width(letters.size() - 1)));
}

std::optional<Windows> windows(const IL& system) {
    if (system.brackets) return std::nullopt;
    Windows found;
    found.letters = accessible(system.axiom, system.alphabet->size(), [&](Symbol a, auto see) {
        for (const IL::Rule& rule : system.rules[a]) see(rule.successor);
    });
    if (found.letters.size() > 128) return std::nullopt;
    found.numbers.resize(system.alphabet->size());
    for (std::size_t i = 0; i < found.letters.size(); ++i) {
        const Symbol a = found.letters[i];
        if (system.ignored[a]) return std::nullopt;
        found.numbers[a] = static_cast<std::uint8_t>(i);
        for (const IL::Rule& rule : system.rules[a]) {
            found.left = std::max(found.left, rule.left.size());
            found.right = std::max(found.right, rule.right.size());
            if (rule.successor.size() != 1) found.keeps_length = false;
        }
    }
    const bool are_few =
        !found.letters.empty() && found.bits() * found.width() <= Windows::most_bits;
    return are_few ? std::optional(found) : std::nullopt;
}

Letters successor_at(const IL& system, const Word& word, std::size_t place) {
    const auto at = word.begin() + static_cast<std::ptrdiff_t>(place);
    for (const IL::Rule& rule : system.rules[*at])
        if (rule.left.size() <= place && rule.right.size() < word.size() - place &&
            std::equal(rule.left.rbegin(), rule.left.rend(), std::make_reverse_iterator(at)) &&
            std::equal(rule.right.begin(), rule.right.end(), at + 1))
            return {rule.successor.data(), rule.successor.size()};
    return {&*at, 1};
}

std::vector<std::optional<std::vector<std::uint8_t>>> window_table(const IL& system,
                                                                   const Windows& windows) {
    const std::size_t bits = windows.bits(), width = windows.width();
    std::vector<std::optional<std::vector<std::uint8_t>>> table(std::size_t{1} << bits * width);
    Word window(width);
    for (std::size_t number = 0; number < table.size(); ++number) {
        bool occurs = true;
        for (std::size_t i = 0; i < width && occurs; ++i) {
            const std::size_t letter = number >> bits * i & ((std::size_t{1} << bits) - 1);
            occurs = letter < windows.letters.size();
            if (occurs) window[i] = windows.letters[letter];
        }
        if (!occurs) continue;
        const Letters successor = successor_at(system, window, windows.left);
        table[number].emplace();
        for (std::size_t i = 0; i < successor.size; ++i)
            table[number]->push_back(windows.numbers[successor.begin[i]]);
    }
    return table;
}

namespace {

constexpr std::size_t most_bits = 12;  // of the index of a table for several letters at a time
constexpr std::size_t most_width = 8;  // letters that are read at a time
constexpr std::size_t spare = 32;      // bytes behind words
constexpr std::size_t letters_between_checks = std::size_t{1} << 14;

/// The numbers of letters, `bits` bits each, side by side, the first letter lowest: of eight letters,
/// or of three where bits are so many that no table is wider.
template <std::size_t bits>
std::uint64_t packed(std::uint64_t bytes) {
    if constexpr (bits > 4) {
        constexpr std::uint64_t one = (std::uint64_t{1} << bits) - 1;
        return (bytes & one) | (bytes >> (8 - bits) & one << bits) |
               (bytes >> 2 * (8 - bits) & one << 2 * bits);
    } else {
        constexpr std::uint64_t two = (std::uint64_t{1} << 2 * bits) - 1,
                                four = (std::uint64_t{1} << 4 * bits) - 1;
        bytes = (bytes | bytes >> (8 - bits)) & (two * 0x0001'0001'0001'0001);
        bytes = (bytes | bytes >> (16 - 2 * bits)) & (four * 0x0000'0001'0000'0001);
        return bytes | bytes >> (32 - 4 * bits);
    }
}

}  // namespace

std::optional<WindowTable> WindowTable::of(const IL& system, const Windows& windows) {
    const std::size_t bits = windows.bits(), width = windows.width();
    if (bits > 7 || width > most_width) return std::nullopt;
    WindowTable table(system, windows);
    const auto single = window_table(system, windows);
    std::size_t middle = 1;
    while (width + middle <= most_width && bits * (width + middle) <= most_bits) ++middle;
    for (; middle > 0; --middle)
        if (table.build(single, middle)) return table;
    return std::nullopt;
}

/// The table for this many letters at a time, from the one for one letter; false if they become
/// too long.
bool WindowTable::build(const std::vector<std::optional<std::vector<std::uint8_t>>>& single,
                        std::size_t middle) {
    const std::size_t bits = windows_.bits();
    middle_ = middle;
    table_.assign(std::size_t{1} << bits * (windows_.width() + middle - 1), {});
    for (std::size_t window = 0; window < table_.size(); ++window) {
        Entry& entry = table_[window];
        for (std::size_t i = 0; i < middle; ++i) {
            const auto& successor = single[window >> bits * i & (single.size() - 1)];
            if (!successor) continue;  // a window that never occurs
            if (entry.count + successor->size() > most_letters) return false;
            std::copy(successor->begin(), successor->end(), entry.letters.begin() + entry.count);
            entry.count = static_cast<std::uint8_t>(entry.count + successor->size());
        }
    }
    return true;
}

void WindowTable::read(const Word& word) {
    length_ = word.size();
    word_.assign(length_ + spare, 0);
    std::transform(word.begin(), word.end(), word_.begin(),
                   [&](Symbol a) { return windows_.numbers[a]; });
}

void WindowTable::write(Word& word) const {
    word.resize(length_);
    std::transform(word_.begin(), word_.begin() + static_cast<std::ptrdiff_t>(length_),
                   word.begin(), [&](std::uint8_t number) { return windows_.letters[number]; });
}

void WindowTable::make_room(std::size_t letters) {
    if (next_.size() < next_length_ + letters + spare)
        next_.resize(std::max(next_length_ + letters + spare, next_.size() * 3 / 2));
}

void WindowTable::rewrite_alone(std::size_t place) {
    const std::size_t from = place - std::min(place, windows_.left);
    Word window;
    for (std::size_t i = from; i < std::min(length_, place + windows_.right + 1); ++i)
        window.push_back(windows_.letters[word_[i]]);
    const Letters successor = successor_at(*system_, window, place - from);
    make_room(successor.size);
    for (std::size_t i = 0; i < successor.size; ++i)
        next_[next_length_++] = windows_.numbers[successor.begin[i]];
}

/// Rewrites letters from `at` on, several at a time, while all of them stand before `end`.
template <std::size_t bits>
bool WindowTable::step_middle(const Budget& budget, std::size_t& at, std::size_t end) {
    const std::uint64_t mask = table_.size() - 1;
    const std::size_t middle = middle_;
    // As many windows as lie in the letters that are read at a time.
    const std::size_t lookups = bits > 4 ? 1 : (most_width - (windows_.width() - 1)) / middle;
    while (at + lookups * middle <= end) {
        budget.check();
        budget.check_memory(word_.size() + next_.size(), "the words");
        const std::size_t times =
            std::min((end - at) / (lookups * middle), letters_between_checks / lookups);
        make_room(times * lookups * most_letters);
        const std::uint8_t* from = word_.data() + at - windows_.left;
        std::uint8_t* to = next_.data() + next_length_;
        for (std::size_t i = 0; i < times; ++i, from += lookups * middle) {
            std::uint64_t bytes = 0;
            std::memcpy(&bytes, from, sizeof bytes);
            std::uint64_t window = packed<bits>(bytes);
            for (std::size_t j = 0; j < lookups; ++j, window >>= bits * middle) {
                const Entry& entry = table_[static_cast<std::size_t>(window & mask)];
                std::memcpy(to, &entry, sizeof entry);
                to += entry.count;
            }
        }
        at += times * lookups * middle;
        next_length_ = static_cast<std::size_t>(to - next_.data());
        if (next_length_ > budget.letters) return false;
    }
    return true;
}

bool WindowTable::step(const Budget& budget) {
    next_length_ = 0;
    const std::size_t left = std::min(windows_.left, length_);
    const std::size_t end = std::max(left, length_ - std::min(windows_.right, length_));
    std::size_t at = 0;
    while (at < left) rewrite_alone(at++);
    const bool fits = [&] {
        switch (windows_.bits()) {
            case 1:
                return step_middle<1>(budget, at, end);
            case 2:
                return step_middle<2>(budget, at, end);
            case 3:
                return step_middle<3>(budget, at, end);
            case 4:
                return step_middle<4>(budget, at, end);
            case 5:
                return step_middle<5>(budget, at, end);
            case 6:
                return step_middle<6>(budget, at, end);
            default:
                return step_middle<7>(budget, at, end);
        }
    }();
    if (!fits) return false;
    while (at < length_) rewrite_alone(at++);
    if (next_length_ > budget.letters) return false;
    make_room(0);
    std::swap(word_, next_);
    length_ = next_length_;
    return true;
}

namespace {

void must_be_deterministic(const IL& system) {
    if (!is_deterministic(system))
        throw Error(
            (system.name.empty() ? "the system" : system.name) +
            " has a choice between rules with the same contexts, so no generation is one word");
}

}  // namespace

/// A word and what rewrites it: the automaton, until so many letters have been rewritten that it was
/// worth while to work out what becomes of every window of letters.
class Development::Engines {
public:
    Engines(const IL& system, const Budget& budget)
        : system_(system),
          budget_(budget),
          automaton_(system_),
          windows_(windows(system_)),
          word_(system_.axiom) {
        must_be_deterministic(system_);
        check_length(length(), 0);
    }

    void step(std::uint64_t generation) {
        budget_.check();
        if (windows_ &&
            rewritten_ >=
                std::max(few_letters, std::uint64_t{1} << windows_->bits() * windows_->width()))
            tabulate();
        if (planes_) {
            planes_->step(budget_);
        } else if (table_) {
            if (!table_->step(budget_)) refuse(generation + 1);
        } else {
            rewritten_ += word_.size();
            check_length(
                automaton_.choose(word_, "generation " + std::to_string(generation), budget_),
                generation + 1);
            automaton_.write(next_);
            std::swap(word_, next_);
        }
        is_word_written_ = !planes_ && !table_;
    }

    std::uint64_t length() const {
        return planes_ ? planes_->length() : table_ ? table_->length() : word_.size();
    }

    const Word& word() {
        if (!std::exchange(is_word_written_, true)) {
            check_length(length(), 0);
            if (planes_) planes_->write(word_);
            if (table_) table_->write(word_);
        }
        return word_;
    }

private:
    static constexpr std::uint64_t few_letters = 4096;

    void tabulate() {
        if (word_.size() >= few_letters / 16) planes_ = CellPlanes::of(system_, *windows_);
        if (!planes_) table_ = WindowTable::of(system_, *windows_);
        windows_.reset();
        if (planes_) planes_->read(word_);
        if (table_) table_->read(word_);
    }

    [[noreturn]] void refuse(std::uint64_t generation) const {
        throw BoundReached(Bound::letters, "generation " + std::to_string(generation) +
                                               " has more than " + std::to_string(budget_.letters) +
                                               " letters, the bound set" +
                                               budget_.by(Bound::letters));
    }

    void check_length(std::uint64_t letters, std::uint64_t generation) const {
        if (letters > budget_.letters) refuse(generation);
        budget_.check_memory(letters * 3 * sizeof(Symbol), "the words");
    }

    IL system_;
    Budget budget_;
    ContextAutomaton automaton_;
    std::optional<Windows> windows_;  // until they are used
    std::optional<CellPlanes> planes_;
    std::optional<WindowTable> table_;
    Word word_, next_;
    bool is_word_written_ = true;  // in word_, where something else rewrites it
    std::uint64_t rewritten_ = 0;  // letters, by the automaton
};

Development::Development(const IL& system, const Budget& budget)
    : engines_(std::make_unique<Engines>(system, budget)) {}

Development::~Development() = default;

void Development::step() { engines_->step(generation_++); }

void Development::steps(std::uint64_t n) {
    WorkCount generations("generation", generation_ + n), letters("letters");
    while (n-- > 0) {
        step();
        generations.at(generation_);
        letters.at(length());
    }
}

std::uint64_t Development::length() const { return engines_->length(); }

const Word& Development::word() { return engines_->word(); }

Word next_word(const IL& system, const Word& word) {
    must_be_deterministic(system);
    ContextAutomaton automaton(system);
    automaton.choose(word, "the word", {});
    Word next;
    automaton.write(next);
    return next;
}

/// The automaton, and what stands behind the number that it chooses: the first of the rules with the same contexts.
class ContextStep::Matcher {
public:
    explicit Matcher(const IL& system) : automaton_(system) {
        for (Symbol a = 0; a < system.alphabet->size(); ++a) successors_.push_back({Word{a}});
        for (const auto& rules : system.rules)
            for (std::size_t i = 0; i < rules.size(); ++i) {
                auto& all = successors_.emplace_back();
                for (std::size_t j = i; j < rules.size() && rules[j].left == rules[i].left &&
                                        rules[j].right == rules[i].right;
                     ++j)
                    all.push_back(rules[j].successor);
            }
    }

    std::vector<const std::vector<Word>*> successors(const Word& word, const Budget& budget) {
        automaton_.choose(word, "the word", budget);
        std::vector<const std::vector<Word>*> found;
        for (const std::uint32_t number : automaton_.chosen())
            found.push_back(&successors_[number]);
        return found;
    }

private:
    ContextAutomaton automaton_;
    std::vector<std::vector<Word>> successors_;
};

ContextStep::ContextStep(const IL& system) : matcher_(std::make_unique<Matcher>(system)) {}

ContextStep::~ContextStep() = default;

std::vector<const std::vector<Word>*> ContextStep::successors(const Word& word) {
    return matcher_->successors(word, {});
}

std::vector<Word> ContextStep::next(const Word& word, std::optional<std::size_t> longest,
                                    const Budget& budget) {
    const auto choices = matcher_->successors(word, budget);
    std::vector<std::size_t> rest(choices.size() + 1,
                                  0);  // the least that letters from here on become
    for (std::size_t i = choices.size(); i-- > 0;) {
        const auto shortest = std::min_element(
            choices[i]->begin(), choices[i]->end(),
            [](const Word& one, const Word& other) { return one.size() < other.size(); });
        rest[i] = rest[i + 1] + shortest->size();
    }
    std::vector<Word> made;
    if (!longest || rest[0] <= *longest) made.emplace_back();
    for (std::size_t i = 0; i < choices.size() && !made.empty(); ++i) {
        if (choices[i]->size() == 1) {
            const Word& successor = choices[i]->front();
            if (longest)
                std::erase_if(made, [&](const Word& start) {
                    return start.size() + successor.size() + rest[i + 1] > *longest;
                });
            for (Word& start : made) start.insert(start.end(), successor.begin(), successor.end());
            continue;
        }
        // Words with the same end are in the order of their starts: sets that are in order are merged.
        std::vector<Word> longer;
        std::uint64_t bytes = 0;
        for (const Word& successor : *choices[i]) {
            const auto merged = static_cast<std::ptrdiff_t>(longer.size());
            for (const Word& start : made) {
                if (longest && start.size() + successor.size() + rest[i + 1] > *longest) continue;
                Word& next = longer.emplace_back();
                next.reserve(start.size() + successor.size());
                next.insert(next.end(), start.begin(), start.end());
                next.insert(next.end(), successor.begin(), successor.end());
                bytes += sizeof(Word) + next.size() * sizeof(Symbol);
                if (longer.size() % 1024 == 0) budget.check();
                budget.check_memory(bytes * 2, "the words after one step");
            }
            std::inplace_merge(longer.begin(), longer.begin() + merged, longer.end(),
                               shortlex_less);
        }
        longer.erase(std::unique(longer.begin(), longer.end()), longer.end());
        made = std::move(longer);
    }
    return made;
}

bool ContextStep::gives(const Word& from, const Word& to) {
    std::vector<char> reached(to.size() + 1,
                              0);  // how much of `to` the letters so far may have become
    reached[0] = 1;
    for (const std::vector<Word>* const choices : matcher_->successors(from, {})) {
        std::vector<char> next(to.size() + 1, 0);
        for (std::size_t start = 0; start <= to.size(); ++start)
            for (const Word& successor : *choices)
                if (reached[start] && successor.size() <= to.size() - start &&
                    std::equal(successor.begin(), successor.end(),
                               to.begin() + static_cast<std::ptrdiff_t>(start)))
                    next[start + successor.size()] = 1;
        reached = std::move(next);
    }
    return reached[to.size()] != 0;
}

std::vector<std::uint64_t> derived_lengths(const IL& system, std::uint64_t n,
                                           const Budget& budget) {
    Development development(system, budget);
    std::vector<std::uint64_t> lengths{development.length()};
    while (development.generation() < n) {
        development.step();
        lengths.push_back(development.length());
        budget.check_memory(lengths.capacity() * sizeof(std::uint64_t), "the lengths");
    }
    return lengths;
}

Word derive(const IL& system, std::uint64_t n, const Budget& budget) {
    Development development(system, budget);
    development.steps(n);
    return development.word();
}

}  // namespace algae
