#include "language/sequence_pair.hpp"

namespace algae {

namespace {

D0L translated(const D0L& system, const std::shared_ptr<const Alphabet>& alphabet) {
    const auto translate = [&](const Word& word) {
        Word out;
        out.reserve(word.size());
        for (const Symbol a : word) out.push_back(*alphabet->find(system.alphabet->name(a)));
        return out;
    };
    std::vector<Word> images(alphabet->size());
    for (Symbol a = 0; a < images.size(); ++a) images[a] = {a};
    for (Symbol a = 0; a < system.alphabet->size(); ++a)
        images[*alphabet->find(system.alphabet->name(a))] = translate(system.successor(a));
    return make_d0l(alphabet, translate(system.axiom), std::move(images), system.name);
}

}  // namespace

SequencePair over_common_alphabet(const D0L& left, const D0L& right) {
    Alphabet letters = *left.alphabet;
    for (Symbol a = 0; a < right.alphabet->size(); ++a) letters.symbol(right.alphabet->name(a));
    const auto alphabet = std::make_shared<const Alphabet>(std::move(letters));
    return {alphabet, translated(left, alphabet), translated(right, alphabet)};
}

}  // namespace algae
