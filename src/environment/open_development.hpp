#pragma once

#include <cstdint>
#include <memory>

#include "environment/environments.hpp"
#include "rewrite/rewriting.hpp"

namespace algae {

/// What the turtle draws and is asked on its way over the word of a generation. `seed` is that of
/// the derivation. Throws what ModuleTurtle throws.
Traversal traversal_of(const LSystem& system, const ModuleKinds& kinds, const ModuleString& word,
               std::uint64_t generation, std::uint64_t seed = 1, const Budget& budget = {});

/// The words of an open L-system, one after the other (Mech and Prusinkiewicz 1996): before each step
/// the turtle walks the word, each communication module asks its environment, and the answers become
/// its parameters; then the word is rewritten as always. Words are shown as they are rewritten, with
/// their parameters filled; that of generation 0 is the axiom with its parameters filled.
///
/// Systems without communication modules develop as by Rewriting alone, and no turtle walks.
class OpenDevelopment {
public:
    /// `external` is as for Environments. Throws what Rewriting and Environments throw.
    OpenDevelopment(const LSystem& system, const RewritingChoices& choices,
                    std::shared_ptr<Environment> external = nullptr, const Budget& budget = {});

    /// The word of this generation, filled.
    const ModuleString& word() const { return word_; }
    std::uint64_t generation() const { return generation_; }
    const CompiledRules& rules() const { return rewriting_.rules(); }

    /// Goes on to generation n, by the tables in `tables`, one for each step from generation 0 on, or by
    /// its own ones where there are none. Throws what Rewriting::next, ModuleTurtle and the environments
    /// throw.
    void go_to(std::uint64_t n, const std::vector<std::size_t>& tables = {},
               const Budget& budget = {});

private:
    void fill(const Budget& budget);

    Rewriting rewriting_;
    Environments environments_;
    std::uint64_t seed_;
    bool is_open_ = false;  // some module communicates
    ModuleString word_;
    std::uint64_t generation_ = 0;
};

}  // namespace algae
