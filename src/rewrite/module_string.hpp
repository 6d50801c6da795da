#pragma once
// rewrite: derivation of systems whose words are no images of a fold: parameters, probabilities,
// contexts with parameters, conditions on the rest of the word, tables.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "word/alphabet.hpp"

namespace algae {

/// A letter together with the number of its parameters, numbered: F, F(x) and F(x,y) are three.
using ModuleKind = std::uint16_t;

class WordValues;

/// The kinds of modules of one system, and the words that its parameters hold.
class ModuleKinds {
public:
    /// The number of this letter with this many parameters; a new one if it is new. Throws
    /// BoundReached if there are more than 65,535. Logarithmic time.
    ModuleKind kind(Symbol letter, std::size_t arity);

    Symbol letter(ModuleKind kind) const { return letters_[kind]; }
    std::uint32_t arity(ModuleKind kind) const { return arities_[kind]; }
    std::size_t size() const { return letters_.size(); }

    /// The words that parameters stand for; none where all parameters are numbers.
    const WordValues* words() const { return words_.get(); }
    const std::shared_ptr<WordValues>& held() const { return words_; }
    void hold(std::shared_ptr<WordValues> words) { words_ = std::move(words); }

private:
    std::vector<Symbol> letters_;
    std::vector<std::uint32_t> arities_;
    std::map<std::pair<Symbol, std::size_t>, ModuleKind> numbers_;
    std::shared_ptr<WordValues> words_;
};

/// Whether two parameters are equal: numbers, or the same word (see WordValues).
inline bool same_value(double a, double b) {
    return a == b ||
           (a != a && b != b && std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b));
}

/// A total order of parameters: numbers before words.
inline bool value_before(double a, double b) {
    if (a == a && b == b) return a < b;
    if (a != a && b != b) return std::bit_cast<std::uint64_t>(a) < std::bit_cast<std::uint64_t>(b);
    return a == a;
}

/// Memory for words: bytes that may be asked for in large pages where they are many, which takes a
/// fourth of the time to touch first. Throws std::bad_alloc.
void* word_memory(std::size_t bytes);
void free_word_memory(void* memory);

/// Memory for words that is not cleared before it is written.
template <class T>
struct Uncleared {
    using value_type = T;

    Uncleared() = default;
    template <class U>
    Uncleared(const Uncleared<U>&) {}
    T* allocate(std::size_t count) { return static_cast<T*>(word_memory(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t) { free_word_memory(memory); }
    template <class U>
    void construct(U* place) {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Parts>
    void construct(U* place, Parts&&... parts) {
        ::new (static_cast<void*>(place)) U(std::forward<Parts>(parts)...);
    }
    bool operator==(const Uncleared&) const = default;
};

/// A word of modules: the kinds of its modules, and all their parameters one after the other. How
/// many of these are a module's own its kind says, so offsets are only worked out where a step
/// looks at neighbours.
struct ModuleString {
    std::vector<ModuleKind, Uncleared<ModuleKind>> kinds;
    std::vector<double, Uncleared<double>> values;

    bool operator==(const ModuleString& other) const {
        return kinds == other.kinds && std::equal(values.begin(), values.end(), other.values.begin(),
                                                  other.values.end(), same_value);
    }
    bool operator<(const ModuleString& other) const {
        if (kinds != other.kinds) return kinds < other.kinds;
        return std::lexicographical_compare(values.begin(), values.end(), other.values.begin(),
                                            other.values.end(), value_before);
    }
};

/// The letters of a word, without their parameters.
Word letters(const ModuleKinds& kinds, const ModuleString& word);

}  // namespace algae
