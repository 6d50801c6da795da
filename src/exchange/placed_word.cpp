#include "exchange/placed_word.hpp"

namespace algae {

void PlacedWord::add(std::string_view letter, std::size_t offset) {
    text += letter;
    offsets.resize(text.size(), offset);
}

void check_brackets(const PlacedWord& word, Findings& findings) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < word.text.size(); ++i) {
        if (word.text[i] == '[') open.push_back(word.offsets[i]);
        if (word.text[i] != ']') continue;
        if (open.empty())
            findings.add(word.offsets[i], "unmatched ']'");
        else
            open.pop_back();
    }
    for (const std::size_t at : open) findings.add(at, "'[' is never closed");
}

}  // namespace algae
