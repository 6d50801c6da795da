#include "fold/interaction.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "fold/interaction_automaton.hpp"
#include "fold/interaction_planes.hpp"
#include "fold/interaction_table.hpp"
#include "fold/interaction_windows.hpp"

namespace algae {

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
    while (n-- > 0) step();
}

std::uint64_t Development::length() const { return engines_->length(); }

const Word& Development::word() { return engines_->word(); }

Word next_word(const IL& system, const Word& word) {
    ContextAutomaton automaton(system);
    automaton.choose(word, "the word", {});
    Word next;
    automaton.write(next);
    return next;
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
