#include <algorithm>
#include <map>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"
#include "verify/verify.hpp"

// Whether a language lies within a regular one.
//
// The right side is an automaton, whose states are its derivatives. Of the left side is worked out between which states its words
// lead: the words of a union, concatenation, star or plus lead where those of the parts do, composed; those of a reversal lead
// backwards where the reversed letters do; those of an image lead where a letter acts as its image does; those of a meeting with a
// regular language are followed in both automata at once. For L(G) the relations of its letters are worked out for all sequences of
// tables, of which there are finitely many; for powers those of their words, which repeat. So the left side may be any expression of such operations over any systems and powers, as long as of
// an intersection or difference one part is regular. No system is constructed for it.

namespace algae::verify {

namespace {

/// Which letter leads between which states.
using Letters = std::vector<BooleanMatrix>;

BooleanMatrix transposed(const BooleanMatrix& matrix) {
    BooleanMatrix result(matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (std::size_t j = 0; j < matrix.size(); ++j)
            if (matrix.at(i, j)) result.set(j, i);
    return result;
}

class Paths {
public:
    Paths(const Alphabet& alphabet, const Budget& budget)
        : budget_(budget), derivatives_(alphabet, budget) {}

    Derivatives::Automaton automaton(const Language& language) {
        return derivatives_.automaton(derivatives_.term(language));
    }

    static Letters letters_of(const Derivatives::Automaton& automaton, std::size_t count) {
        Letters letters(count, BooleanMatrix(automaton.next.size()));
        for (std::size_t i = 0; i < automaton.next.size(); ++i)
            for (Symbol a = 0; a < count; ++a) letters[a].set(i, automaton.next[i][a]);
        return letters;
    }

    /// Between which states the words of the language lead. Throws Error if the language is made otherwise.
    BooleanMatrix of(const Language& language, const Letters& letters, std::size_t states) {
        budget_.check();
        const auto part = [&](std::size_t i) { return of(language->parts[i], letters, states); };
        switch (language->kind) {
            case Tree::Kind::words:
                return of_words(language->words, letters, states);
            case Tree::Kind::generated:
                return generated(*language, letters, states);
            case Tree::Kind::powers:
                return paths_of(*language->powers, letters, states, budget_);
            case Tree::Kind::united: {
                BooleanMatrix both = part(0);
                return both |= part(1);
            }
            case Tree::Kind::concatenation: {
                const BooleanMatrix first = part(0);
                return first.then(part(1));
            }
            case Tree::Kind::star:
                return repeated(part(0));
            case Tree::Kind::plus: {
                const BooleanMatrix once = part(0);
                return once.then(repeated(once));
            }
            case Tree::Kind::reversal: {
                Letters backwards;
                for (const BooleanMatrix& letter : letters) backwards.push_back(transposed(letter));
                return transposed(of(language->parts[0], backwards, states));
            }
            case Tree::Kind::image: {
                Letters images(letters.size(), BooleanMatrix(states));
                for (const auto& [letter, image] : language->morphism)
                    images[letter] = of_words({image}, letters, states);
                return of(language->parts[0], images, states);
            }
            case Tree::Kind::intersection:
            case Tree::Kind::difference:
                return filtered(*language, letters, states);
            default:
                break;
        }
        if (!is_regular(language))
            throw Error(
                "the left side is not made of systems and powers by union, concatenation, star, "
                "plus, image, reversal, and intersection and difference with regular expressions");
        return within_both(language, false, nullptr, letters, states);
    }

private:
    static BooleanMatrix of_words(const std::vector<Word>& words, const Letters& letters,
                                  std::size_t states) {
        BooleanMatrix all(states);
        for (const Word& word : words) {
            BooleanMatrix one = BooleanMatrix::identity(states);
            for (const Symbol a : word) one = one.then(letters[a]);
            all |= one;
        }
        return all;
    }

    BooleanMatrix generated(const Tree& leaf, const Letters& letters, std::size_t states) {
        const System& system = *leaf.system;
        if (system.context) return of_words(finite_values_of_leaf(leaf, budget_), letters, states);
        Relations start;
        for (const Symbol a : accessible_letters(system, system.axiom))
            start.emplace(a, system.terminal[a] ? letters[a] : BooleanMatrix(states));
        BooleanMatrix all(states);
        some_relations(
            system, start, states,
            [&](const Relations& relations) {
                all |= relation_of(system.axiom, relations, states);
                return false;
            },
            budget_);
        return all;
    }

    BooleanMatrix repeated(const BooleanMatrix& once) {
        BooleanMatrix all = BooleanMatrix::identity(once.size());
        all |= once;
        for (BooleanMatrix before(once.size()); !(before == all);) {
            budget_.check();
            before = all;
            all = all.then(all);
        }
        return all;
    }

    BooleanMatrix filtered(const Tree& tree, const Letters& letters, std::size_t states) {
        const bool is_difference = tree.kind == Tree::Kind::difference;
        for (const std::size_t filter : {1u, 0u})
            if (is_regular(tree.parts[filter]) && (filter == 1 || !is_difference))
                return within_both(tree.parts[filter], is_difference, &tree.parts[1 - filter],
                                   letters, states);
        throw Error("no part of an intersection or difference is a regular expression");
    }

    /// Where the words of a regular language lead, or those not in it if `outside`; of these only words of `part`, if there is one.
    BooleanMatrix within_both(const Language& filter, bool outside, const Language* part,
                              const Letters& letters, std::size_t states) {
        const auto other = automaton(filter);
        const std::size_t count = other.next.size(), pairs = states * count;
        budget_.check_memory(static_cast<std::uint64_t>(pairs) * pairs / 8 * (letters.size() + 4),
                             "the relations between pairs of derivatives");
        Letters both(letters.size(), BooleanMatrix(pairs));
        for (Symbol a = 0; a < letters.size(); ++a)
            for (std::size_t i = 0; i < states; ++i)
                for (std::size_t j = 0; j < states; ++j)
                    if (letters[a].at(i, j))
                        for (std::size_t k = 0; k < count; ++k)
                            both[a].set(i * count + k, j * count + other.next[k][a]);
        BooleanMatrix paths(pairs);
        if (part) {
            paths = of(*part, both, pairs);
        } else {
            for (const BooleanMatrix& letter : both) paths |= letter;
            paths = repeated(paths);
        }
        BooleanMatrix all(states);
        for (std::size_t i = 0; i < states; ++i)
            for (std::size_t j = 0; j < states; ++j)
                for (std::size_t k = 0; k < count; ++k)
                    if ((other.accepting[k] != 0) != outside && paths.at(i * count, j * count + k))
                        all.set(i, j);
        return all;
    }

    const Budget& budget_;
    Derivatives derivatives_;
};

}  // namespace

bool within_regular(const Language& left, const Language& right, const Alphabet& alphabet,
                    const Budget& budget) {
    Paths paths(alphabet, budget);
    const auto automaton = paths.automaton(right);
    const std::size_t states = automaton.next.size();
    budget.check_memory(static_cast<std::uint64_t>(states) * states / 8 * (alphabet.size() + 4),
                        "the relations between derivatives");
    const BooleanMatrix words =
        paths.of(left, Paths::letters_of(automaton, alphabet.size()), states);
    for (std::size_t i = 0; i < states; ++i)
        if (words.at(0, i) && !automaton.accepting[i]) return false;
    return true;
}

}  // namespace algae::verify
