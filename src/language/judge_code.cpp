#include <algorithm>
#include <map>
#include <tuple>

#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"
#include "word/word.hpp"

// Codes and palindromes.
//
// A language is a code if no word is a product of its words in two ways (Berstel, Perrin and Reutenauer 2009). For a
// regular language this is a search in its automaton taken twice: both copies read the same word, each may cut it and
// begin again wherever it accepts, and two factorisations differ if at some place one is cut and the other is not. The
// search goes by length, so it finds a shortest word with two factorisations. For finite languages this is the test of
// Sardinas and Patterson (1953), with states of an automaton in the place of remainders.
//
// A prefix code is a code of which no word begins with another one. If no word does and the empty word is none of
// them, the language is a code, so only the two words are looked for. The empty word is in no code.

namespace algae {

namespace {

/// The copies of the automaton after some letters, and whether they have been cut at different places.
struct Cuts {
    std::size_t left = 0, right = 0;
    bool differ = false;
    bool operator==(const Cuts&) const = default;
    bool operator<(const Cuts& other) const {
        return std::tie(left, right, differ) < std::tie(other.left, other.right, other.differ);
    }
};

/// How a state of the search was come by.
struct Step {
    Cuts before;
    Symbol letter = 0;
    bool cut_left = false, cut_right = false;
};

class Ambiguity {
public:
    Ambiguity(const Language& language, const Dfa& automaton, const Budget& budget)
        : language_(language), automaton_(automaton), budget_(budget) {}

    std::optional<steps::TwoFactorisations> found() {
        const std::vector<std::size_t> distance = distances(automaton_);
        std::vector<Cuts> open{begin()};
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (i % 1024 == 0) {
                budget_.check();
                budget_.check_memory(open.size() * 150, "the pairs of factorisations");
            }
            const Cuts from = open[i];
            for (Symbol a = 0; a < automaton_.letters; ++a) {
                const std::size_t left = automaton_.step(from.left, a),
                                  right = automaton_.step(from.right, a);
                for (const bool cut_left : {false, true})
                    for (const bool cut_right : {false, true}) {
                        if ((cut_left && !automaton_.accepting[left]) ||
                            (cut_right && !automaton_.accepting[right]))
                            continue;
                        const Cuts to{cut_left ? automaton_.initial : left,
                                      cut_right ? automaton_.initial : right,
                                      from.differ || cut_left != cut_right};
                        if (!cut_left && distance[left] == automaton_.states()) continue;
                        if (!cut_right && distance[right] == automaton_.states()) continue;
                        // What stands behind a first cut that is the same could be read by itself.
                        if ((cut_left && cut_right && !to.differ) || to == begin()) continue;
                        if (cut_left && cut_right) return factorisations(from, a);
                        if (before_.try_emplace(to, Step{from, a, cut_left, cut_right}).second)
                            open.push_back(to);
                    }
            }
        }
        return std::nullopt;
    }

private:
    Cuts begin() const { return {automaton_.initial, automaton_.initial, false}; }

    steps::TwoFactorisations factorisations(Cuts at, Symbol last) const {
        std::vector<Step> steps{{at, last, true, true}};
        for (; !(at == begin()); at = steps.back().before) steps.push_back(before_.at(at));
        steps::TwoFactorisations found{language_, {}, {}, {}};
        for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
            found.word.push_back(step->letter);
            if (step->cut_left) found.left.push_back(found.word.size());
            if (step->cut_right) found.right.push_back(found.word.size());
        }
        return found;
    }

    const Language& language_;
    const Dfa& automaton_;
    const Budget& budget_;
    std::map<Cuts, Step> before_;
};

}  // namespace

Answer judge_code(const Language& language, bool prefix, const Alphabet& alphabet,
                  const Budget& budget) {
    const auto regular = regular_value(language, alphabet, budget);
    if (!regular)
        return undecided("whether " + to_string(language, alphabet) +
                         " is a code is decided where it is regular, and no regular expression for "
                         "it is at hand");
    const Dfa& automaton = regular->automaton();
    if (automaton.accepting[automaton.initial])
        return refuted(steps::TwoFactorisations{language, {}, {}, {0}});
    const auto count = number_of_words(*regular);
    const std::size_t words =
        count && *count <= Integer(1'000'000) ? static_cast<std::size_t>(count->to_uint64()) : 0;
    if (!prefix) {
        if (auto found = Ambiguity(language, automaton, budget).found())
            return refuted(std::move(*found));
        return proved(steps::Code{language, false, words});
    }
    std::vector<Word> letters;
    for (Symbol a = 0; a < automaton.letters; ++a) letters.push_back({a});
    const RegularLanguage longer =
        concatenated(*regular, plus(finite_set(letters), budget), budget);
    if (const auto word = shortest_word(intersected(*regular, longer, budget))) {
        Word beginning;
        while (!regular->contains(beginning)) beginning.push_back((*word)[beginning.size()]);
        return refuted(steps::Beginning{language, *word, std::move(beginning)});
    }
    return proved(steps::Code{language, true, words});
}

Answer judge_palindrome(const Word& word) {
    for (std::size_t i = 0; i < word.size() / 2; ++i)
        if (word[i] != word[word.size() - 1 - i]) return refuted(steps::Palindrome{word, i});
    return proved(steps::Palindrome{word, {}});
}

}  // namespace algae
