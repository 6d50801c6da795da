#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "word/alphabet.hpp"

namespace algae {

/// Words as text, under concatenation with a blank wherever two names written together would be
/// read otherwise. The empty word is the empty text here; printing makes it `ε`. The alphabet must
/// outlive the monoid and must not grow.
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

    /// Whether a blank stands between these two letters. Constant time where no name is long.
    bool blank_between(Symbol left, Symbol right) const {
        if (!alphabet_->may_need_blanks()) return false;
        const std::string& name = alphabet_->name(right);
        return needs_blank(alphabet_->name(left), name) || (rests_ && begins_long_name(left, name));
    }

private:
    /// By symbol: what is missing to every long name that its name begins.
    using Rests = std::unordered_map<Symbol, std::vector<std::string>>;

    bool begins_long_name(Symbol left, std::string_view right) const;

    const Alphabet* alphabet_;
    std::shared_ptr<const Rests> rests_;  // absent where no name is long
};

}  // namespace algae
