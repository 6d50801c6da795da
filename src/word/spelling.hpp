#pragma once

#include <string>

#include "word/alphabet.hpp"

namespace algae {

/// Words as text, under concatenation with a blank wherever two names written together would be
/// read otherwise. The empty word is the empty text here; printing makes it `ε`.
class Spellings {
public:
    struct value_type {
        std::string text;
        Symbol first = 0, last = 0;  // meaningless for the empty word
        bool operator==(const value_type& other) const { return text == other.text; }
    };

    explicit Spellings(const Alphabet& alphabet);

    value_type one() const { return {}; }
    value_type letter(Symbol symbol) const { return {alphabet_->name(symbol), symbol, symbol}; }
    void append(value_type& left, const value_type& right) const {
        if (right.text.empty()) return;
        if (left.text.empty()) {
            left = right;
            return;
        }
        if (blank_between(left.last, right.first)) left.text += ' ';
        left.text += right.text;
        left.last = right.last;
    }

    /// Whether a blank stands between these two letters.
    bool blank_between(Symbol left, Symbol right) const {
        return blanks_ && needs_blank(alphabet_->name(left), alphabet_->name(right));
    }

private:
    const Alphabet* alphabet_;
    bool blanks_;  // whether any pair of letters may need a blank
};

}  // namespace algae
