#pragma once
// One step of a derivation by letters of strings, with nothing of the library.

#include <cstddef>
#include <set>
#include <string>

namespace oracle {

/// The words of at most `kept` letters that a word becomes if the letter at place i becomes one of successors(i); `cut` is set
/// where a longer one is left out.
template <class Successors>
std::set<std::string> next_words(const std::string& word, std::size_t kept,
                                 const Successors& successors, bool& cut) {
    std::set<std::string> made{""};
    for (std::size_t i = 0; i < word.size(); ++i) {
        std::set<std::string> longer;
        for (const std::string& begun : made)
            for (const std::string& successor : successors(i)) {
                if (begun.size() + successor.size() <= kept)
                    longer.insert(begun + successor);
                else
                    cut = true;
            }
        made = std::move(longer);
    }
    return made;
}

}  // namespace oracle
