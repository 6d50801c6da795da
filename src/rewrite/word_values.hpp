#pragma once

#include <cstdint>
#include <deque>
#include <unordered_map>

#include "base/budget.hpp"
#include "rewrite/module_string.hpp"

namespace algae {

/// Words as values of parameters. A parameter is a double; one that is not a number stands for a word,
/// whose place in this list its bits say. Numbers on their own are always finite, so nothing else is
/// not a number. A word is kept once: equal words have equal values.
class WordValues {
public:
    static bool is_word(double value) { return value != value; }

    /// The value of a word, whose own parameters may be words of this list. Expected time linear in
    /// the word. Throws BoundReached if words stand in each other more than 100 deep, if the word
    /// would be printed with more modules than budget.letters, or if all words together take more
    /// than budget.memory.
    double value(ModuleString word, const Budget& budget);

    /// The word of a value that is one.
    const ModuleString& word(double value) const { return held(value).word; }

private:
    struct Held {
        ModuleString word;
        std::uint64_t modules = 0;  // when it is printed: those of words within counted
        std::size_t depth = 0;      // of words within
    };
    const Held& held(double value) const;

    std::deque<Held> all_;
    std::unordered_multimap<std::uint64_t, std::size_t> places_;  // by a hash of the word
    std::uint64_t bytes_ = 0;
};

}  // namespace algae
