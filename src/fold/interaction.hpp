#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/budget.hpp"
#include "system/il.hpp"

namespace algae {

/// The generations of a system with interactions, one after the other, from the axiom on; what
/// rules, contexts and trees mean is said at IL. There is no fold here: what a letter becomes is no
/// function of the letter alone.
///
/// A step takes O(length of the word) whatever the contexts, by an automaton (ContextAutomaton).
/// Long words without trees over few letters are rewritten many letters at a time, as bit planes
/// where their length stays (CellPlanes), by a table of windows where it does not (WindowTable).
class Development {
public:
    /// Throws as step does.
    explicit Development(const IL& system, const Budget& budget = {});
    ~Development();

    /// Goes to the next generation. Throws BoundReached if its word has more than budget.letters
    /// letters, and Error if the brackets of a tree do not match in the word of this one.
    void step();
    /// Takes n steps.
    void steps(std::uint64_t n);

    std::uint64_t generation() const { return generation_; }
    std::uint64_t length() const;
    const Word& word();

private:
    class Engines;
    std::uint64_t generation_ = 0;
    std::unique_ptr<Engines> engines_;
};

/// The word after one step of a system with interactions. Several steps are faster by Development.
/// Throws Error if brackets do not match.
Word next_word(const IL& system, const Word& word);

/// The lengths of generations 0 to n, by deriving them. Throws as Development::step does.
std::vector<std::uint64_t> derived_lengths(const IL& system, std::uint64_t n,
                                           const Budget& budget = {});

/// The word of generation n, by deriving. Throws as Development::step does.
Word derive(const IL& system, std::uint64_t n, const Budget& budget = {});

}  // namespace algae
