#include <algorithm>
#include <map>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/detail/languages.hpp"
#include "verify/verify.hpp"

// Whether a language lies within a regular one; languages of linear systems as regular expressions; and facts, by which a
// language stands in the place of an equal one.
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
    Paths(const Alphabet& alphabet, const Invariants& invariants, const Budget& budget)
        : invariants_(invariants), budget_(budget), derivatives_(alphabet, budget) {}

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
        return within_both(automaton(language), false, nullptr, letters, states);
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
        if (const auto known = invariants_.find(&system); known != invariants_.end())
            return within_both(known->second, false, nullptr, letters, states);
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
                return within_both(automaton(tree.parts[filter]), is_difference,
                                   &tree.parts[1 - filter], letters, states);
        throw Error("no part of an intersection or difference is a regular expression");
    }

    /// Where the words that an automaton accepts lead, or those that it does not if `outside`; of these only words of `part`, if
    /// there is one.
    BooleanMatrix within_both(const Derivatives::Automaton& other, bool outside,
                              const Language* part, const Letters& letters, std::size_t states) {
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

    const Invariants& invariants_;
    const Budget& budget_;
    Derivatives derivatives_;
};

}  // namespace

bool within_regular(const Language& left, const Language& right, const Alphabet& alphabet,
                    const Budget& budget, const Invariants& invariants) {
    Paths paths(alphabet, invariants, budget);
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

namespace {

/// A letter is constant if it stays as it is.
bool is_constant(const System& system, Symbol a) {
    return system.tables.front()[a] == std::vector<Word>{{a}};
}

/// What stands beside the only letter of a word that is not constant: on its left if that is the last one, otherwise on its
/// right; and the letter, if there is one. Nothing where another letter is not constant.
struct Parted {
    Word constant;
    std::optional<Symbol> active;
};
std::optional<Parted> parted(const System& system, const Word& word, bool is_last) {
    Parted found{word, {}};
    if (!word.empty() && !is_constant(system, is_last ? word.back() : word.front())) {
        found.active = is_last ? word.back() : word.front();
        found.constant.erase(is_last ? found.constant.end() - 1 : found.constant.begin());
    }
    for (const Symbol a : found.constant)
        if (!is_constant(system, a)) return std::nullopt;
    return found;
}

/// Languages X_a with X_a = K_a and, for each b, C_ab X_b (or X_b C_ab): solved by Arden's rule, one letter after the other.
class Equations {
public:
    Equations(const System& system, bool is_last) : is_last_(is_last) {
        const std::vector<Symbol> letters = accessible_letters(system, system.axiom);
        for (const Symbol a : letters) {
            if (is_constant(system, a)) continue;
            add(known_[a], words_of({{a}}));
            for (const Word& successor : system.tables.front()[a]) {
                const auto parts = parted(system, successor, is_last);
                if (!parts) {
                    is_linear = false;
                    return;
                }
                add(parts->active ? factors_[{a, *parts->active}] : known_[a],
                    words_of({parts->constant}));
            }
        }
    }

    bool is_linear = true;

    /// X_a.
    Language of(Symbol wanted) {
        std::vector<Symbol> letters;
        for (const auto& [a, language] : known_)
            if (a != wanted) letters.push_back(a);
        letters.push_back(wanted);
        for (const Symbol a : letters) {
            if (const auto loop = factors_.find({a, a}); loop != factors_.end()) {
                const Language rounds = combination(Tree::Kind::star, {loop->second}, {});
                factors_.erase(loop);
                known_[a] = beside(rounds, known_[a]);
                for (auto& [places, factor] : factors_)
                    if (places.first == a) factor = beside(rounds, factor);
            }
            const auto factors = factors_;
            for (const auto& [into, factor] : factors) {
                if (into.second != a || into.first == a) continue;
                factors_.erase(into);
                add(known_[into.first], beside(factor, known_[a]));
                for (const auto& [places, next] : factors)
                    if (places.first == a)
                        add(factors_[{into.first, places.second}], beside(factor, next));
            }
        }
        return known_.at(wanted);
    }

    /// A factor and what it stands before, or behind.
    Language beside(const Language& factor, const Language& language) const {
        return is_last_ ? combination(Tree::Kind::concatenation, {factor, language}, {})
                        : combination(Tree::Kind::concatenation, {language, factor}, {});
    }

private:
    static void add(Language& to, const Language& more) {
        to = to ? combination(Tree::Kind::united, {to, more}, {}) : more;
    }

    bool is_last_;
    std::map<Symbol, Language> known_;
    std::map<std::pair<Symbol, Symbol>, Language> factors_;
};

/// The language of a linear system as a regular expression: in its words all letters are constant but one at most, which is
/// the last one of all words, or the first one. Other languages as they are.
Language without_linear_system(const Language& language) {
    if (language->kind != Tree::Kind::generated || !language->system) return language;
    const System& system = *language->system;
    if (system.context || system.tables.size() != 1 || !has_only_terminals(system)) return language;
    for (const bool is_last : {true, false}) {
        const auto axiom = parted(system, system.axiom, is_last);
        if (!axiom) continue;
        if (!axiom->active) return words_of({system.axiom});
        Equations equations(system, is_last);
        if (equations.is_linear)
            return equations.beside(words_of({axiom->constant}), equations.of(*axiom->active));
    }
    return language;
}

/// A language with another one in the place of each part that is the same as `from`.
Language replaced(const Language& language, const Language& from, const Language& to) {
    if (same(language, from)) return to;
    Tree tree = *language;
    for (Language& part : tree.parts) part = replaced(part, from, to);
    return std::make_shared<const Tree>(std::move(tree));
}

/// Not in statements about all values, which may bind the names of systems again.
void replace(Statement& statement, const Language& from, const Language& to) {
    if (statement.kind == Statement::Kind::quantified) return;
    for (Language& language : statement.languages) language = replaced(language, from, to);
    for (Statement& part : statement.parts) replace(part, from, to);
}

}  // namespace

void check_linear(const Obligation& task) {
    Statement regular = task.statement;
    for (Language& language : regular.languages) {
        language = without_linear_system(language);
        if (!is_regular(language)) task.refuse("a system is not linear");
    }
    check_derivatives(task.part(regular, true, task.proof));
}

void check_facts(const Obligation& task) {
    if (task.statement.kind == Statement::Kind::quantified)
        task.refuse("facts about languages are not put into statements about all values");
    Statement changed = task.statement;
    for (const Field& fact : task.proof.at("facts").list()) {
        fact.only({"equal", "replaced", "proof"});
        const auto [left, right] = fact.at("equal").pair();
        Statement equal;
        equal.kind = Statement::Kind::equal;
        equal.languages = {task.reader.language(left), task.reader.language(right)};
        check_proof(task.part(equal, true, fact.at("proof")));
        const std::uint64_t number = fact.at("replaced").number();
        if (number > 1) fact.at("replaced").fail("expected 0 or 1");
        const auto which = static_cast<std::size_t>(number);
        replace(changed, equal.languages[which], equal.languages[1 - which]);
    }
    check_proof(task.part(changed, task.holds, task.proof.at("proof")));
}

}  // namespace algae::verify
