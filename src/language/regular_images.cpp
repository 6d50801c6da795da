#include "language/regular_images.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"

namespace algae {

namespace {

template <class Image>
const Image& image_of(Symbol a, const std::vector<Image>& images) {
    if (a >= images.size()) throw Error("letter number " + std::to_string(a) + " has no image");
    return images[a];
}

}  // namespace

RegularLanguage image(const RegularLanguage& language, const std::vector<Word>& images, const Budget& budget) {
    const Nfa letters = as_nfa(language.automaton());
    Nfa words;
    for (const Nfa::State& state : letters.states) words.add_state(state.accepting);
    words.initial = letters.initial;
    for (std::size_t s = 0; s < letters.states.size(); ++s)
        for (const auto& [letter, to] : letters.states[s].moves) words.add_path(s, image_of(letter, images), to);
    return RegularLanguage(words, budget);
}

RegularLanguage image(const RegularLanguage& language, const std::vector<RegularLanguage>& images, const Budget& budget) {
    const Nfa letters = as_nfa(language.automaton());
    Nfa words;
    for (const Nfa::State& state : letters.states) words.add_state(state.accepting);
    words.initial = letters.initial;
    for (std::size_t s = 0; s < letters.states.size(); ++s)
        for (const auto& [letter, to] : letters.states[s].moves) {
            const Nfa part = as_nfa(image_of(letter, images).automaton());
            const std::size_t shift = words.add_states(part);
            for (const std::size_t begin : part.initial) words.states[s].silent.push_back(begin + shift);
            for (std::size_t t = shift; t < words.states.size(); ++t)
                if (words.states[t].accepting) {
                    words.states[t].accepting = false;
                    words.states[t].silent.push_back(to);
                }
        }
    return RegularLanguage(words, budget);
}

RegularLanguage inverse_image(const RegularLanguage& language, const std::vector<Word>& images,
                              const std::vector<Symbol>& domain) {
    std::size_t letters = language.automaton().letters;
    for (const Symbol a : domain)
        for (const Symbol b : image_of(a, images)) letters = std::max<std::size_t>(letters, b + 1);
    const Dfa before = widened(language.automaton(), letters);
    Nfa found;
    for (const char accepting : before.accepting) found.add_state(accepting != 0);
    found.initial.push_back(before.initial);
    for (std::size_t s = 0; s < before.states(); ++s)
        for (const Symbol a : domain) {
            std::size_t to = s;
            for (const Symbol b : images[a]) to = before.step(to, b);
            found.states[s].moves.emplace_back(a, to);
        }
    return RegularLanguage(found);
}

}  // namespace algae
