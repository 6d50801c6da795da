#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "word/alphabet.hpp"

namespace algae {

/// Writes symbols one after the other so that they are read back as written: with a blank where two
/// names written together would be cut otherwise.
class Spelling {
public:
    explicit Spelling(const Alphabet& alphabet);

    /// Appends a symbol to `out`. The symbol before it is `last`, unless something else was written
    /// in between and `forget` was called.
    void add(Symbol symbol, std::string& out);
    void forget() { last_ = nullptr; }

private:
    bool needs_blank(std::string_view left, std::string_view right) const;

    const Alphabet& alphabet_;
    std::vector<std::string> declared_;  // the names that are read only because they are declared
    const std::string* last_ = nullptr;
};

/// Symbols with a blank between any two.
std::string spell_apart(const Alphabet& alphabet, const Word& symbols);

}  // namespace algae
