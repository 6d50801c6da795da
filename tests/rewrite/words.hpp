#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"

namespace algae {

/// The words of generations 0 to n as text, by the rules of the table where there are several.
inline std::vector<std::string> words(const std::string& system, std::uint64_t n,
                                      const RewritingChoices& choices = {}) {
    const Rewriting rewriting(read_lsystem(system, "test.lsys"), choices);
    const ModuleText text(rewriting.rules().system->alphabet, rewriting.rules().kinds);
    std::vector<std::string> out;
    ModuleString word = rewriting.axiom();
    for (std::uint64_t generation = 0;; ++generation) {
        out.push_back(text.text(word));
        if (generation == n) return out;
        word = rewriting.next(word, generation);
    }
}

/// The last of them.
inline std::string word_of(const std::string& system, std::uint64_t n,
                           const RewritingChoices& choices = {}) {
    return words(system, n, choices).back();
}

/// What the engine says against deriving generation n.
inline std::string refusal(const std::string& system, std::uint64_t n) {
    try {
        return word_of(system, n);
    } catch (const Error& error) {
        return error.what();
    } catch (const BoundReached& bound) {
        return bound.what();
    }
}

}  // namespace algae
