#pragma once

#include <string>
#include <utility>
#include <vector>

#include "system/system.hpp"

namespace algae {

/// A D0L system from names with blanks between them, for alphabets whose names are longer than one
/// character: rules are pairs of a name and its successor. All names are numbered first in the
/// order of `names`.
inline D0L named_d0l(const std::vector<std::string>& names, const std::vector<std::string>& axiom,
                     const std::vector<std::pair<std::string, std::vector<std::string>>>& rules) {
    auto alphabet = std::make_shared<Alphabet>();
    for (const std::string& name : names) alphabet->symbol(name);
    const auto word = [&](const std::vector<std::string>& written) {
        Word letters;
        for (const std::string& name : written) letters.push_back(alphabet->symbol(name));
        return letters;
    };
    const Word start = word(axiom);
    std::vector<std::pair<Symbol, Word>> successors;
    for (const auto& [name, successor] : rules) {
        const Symbol predecessor = alphabet->symbol(name);
        successors.emplace_back(predecessor, word(successor));
    }
    std::vector<Word> images;
    for (Symbol a = 0; a < alphabet->size(); ++a) images.push_back({a});
    for (const auto& [a, successor] : successors) images[a] = successor;
    return make_d0l(alphabet, start, images);
}

}  // namespace algae
