#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "system/ol.hpp"

namespace algae {

/// What can become of each letter of an 0L system. All by symbol; letters that are not accessible
/// are left as they begin here.
struct LetterFutures {
    /// Whether some derivation from the letter goes on for ever without becoming empty. The others
    /// are gone after at most as many steps as there are letters, whatever is chosen.
    std::vector<char> lasting;
    /// The least number of steps in which the letter can become the empty word, if it can.
    std::vector<std::optional<std::uint64_t>> shortest_life;
    /// Whether the letter derives words of any length.
    std::vector<char> growing;
    /// Strongly connected lasting letters have the same number; 0 for letters that do not last.
    std::vector<std::size_t> component;
};

/// By fixed points and the strongly connected components of the lasting letters. Time O(size of the
/// rules * number of letters), linear for the components.
///
/// Example: letter_futures(ol("a", {{'a', "ab"}, {'b', ""}})).lasting == std::vector<char>{1, 0}
LetterFutures letter_futures(const OL& system);

/// Whether every accessible letter has one successor, so that the system is a D0L system.
bool is_deterministic(const OL& system);

/// Rule `choice` of `letter` has its component again and another lasting letter, at these places.
struct Pump {
    Symbol letter = 0;
    std::size_t choice = 0;
    std::size_t again = 0;
    std::size_t other = 0;
    bool operator==(const Pump&) const = default;
};

/// The first rule that pumps, in the order of `OL::letters` and of their successors; none if there
/// is no such rule.
std::optional<Pump> first_pump(const OL& system, const LetterFutures& futures);

/// The rule by which a letter that can become the empty word does so soonest. Throws Error if it cannot.
std::uint32_t erasing_choice(const OL& system, const LetterFutures& futures, Symbol letter);

}  // namespace algae
