#include "word/spelling.hpp"

#include <algorithm>

namespace algae {

Spellings::Spellings(const Alphabet& alphabet) : alphabet_(&alphabet) {
    if (alphabet.long_names().empty()) return;
    auto rests = std::make_shared<Rests>();
    for (const Symbol symbol : alphabet.long_names()) {
        const std::string_view name = alphabet.name(symbol);
        for (std::size_t bytes = 1; bytes < name.size(); ++bytes)
            if (const auto begun = alphabet.find(name.substr(0, bytes)))
                (*rests)[*begun].emplace_back(name.substr(bytes));
    }
    rests_ = std::move(rests);
}

bool Spellings::begins_long_name(Symbol left, std::string_view right) const {
    const auto found = rests_->find(left);
    return found != rests_->end() &&
        std::any_of(found->second.begin(), found->second.end(), [&](const std::string& rest) {
               return rest.starts_with(right) || right.starts_with(rest);
           });
}

}  // namespace algae
