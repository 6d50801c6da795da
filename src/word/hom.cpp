#include "word/hom.hpp"

namespace algae {

std::optional<Brackets> brackets_of(const Alphabet& alphabet) {
    const auto open = alphabet.find("["), close = alphabet.find("]");
    if (!open || !close) return std::nullopt;
    return Brackets{*open, *close};
}

}  // namespace algae
