#include "notation/spelling.hpp"

#include <algorithm>

#include "notation/lexicon.hpp"

namespace algae {

Spelling::Spelling(const Alphabet& alphabet) : alphabet_(alphabet) {
    for (Symbol symbol = 0; symbol < alphabet.size(); ++symbol) {
        const std::string& name = alphabet.name(symbol);
        if (undeclared_length(name) != name.size()) declared_.push_back(name);
    }
}

bool Spelling::needs_blank(std::string_view left, std::string_view right) const {
    if (undeclared_length(left) != left.size() || undeclared_length(right) != right.size())
        return true;
    // "X" "_" would begin a subscript, and "X_1" "2" would go on with it.
    if (right.front() == '_' || (left.find('_') != std::string_view::npos && right.front() >= '0' &&
                                 right.front() <= '9'))
        return true;
    // The two might be the beginning of a longer name.
    return std::any_of(declared_.begin(), declared_.end(), [&](std::string_view name) {
        if (!name.starts_with(left)) return false;
        const std::string_view rest = name.substr(left.size());
        return rest.starts_with(right) || right.starts_with(rest);
    });
}

void Spelling::add(Symbol symbol, std::string& out) {
    const std::string& name = alphabet_.name(symbol);
    if (last_ && needs_blank(*last_, name)) out += ' ';
    out += name;
    last_ = &name;
}

std::string spell_apart(const Alphabet& alphabet, const Word& symbols) {
    std::string out;
    for (const Symbol symbol : symbols) out += (out.empty() ? "" : " ") + alphabet.name(symbol);
    return out;
}

}  // namespace algae
