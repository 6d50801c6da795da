#include "word/renaming.hpp"

#include <optional>

#include "base/error.hpp"

namespace algae {

std::vector<Symbol> renaming(const Alphabet& from, const Alphabet& to) {
    std::vector<Symbol> letters;
    for (Symbol a = 0; a < from.size(); ++a) {
        const std::optional<Symbol> letter = to.find(from.name(a));
        if (!letter) throw Error("the symbol " + from.name(a) + " is not in the alphabet");
        letters.push_back(*letter);
    }
    return letters;
}

Word replaced(Word word, const std::vector<Symbol>& letters) {
    for (Symbol& a : word) a = letters[a];
    return word;
}

}  // namespace algae
