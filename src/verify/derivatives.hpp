#pragma once

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "verify/certificate.hpp"

namespace algae::verify {

/// Regular expressions with complement, intersection, images and inverse images, each known by a number,
/// and their derivatives (Brzozowski 1964): the derivative by a letter has what may follow it.
class Derivatives {
public:
    using Term = std::size_t;

    /// Both must outlive this.
    Derivatives(const Alphabet& alphabet, const Budget& budget);

    /// The expression, where all systems in it have finite languages; throws Error if one has not,
    /// BoundReached if that cannot be found out.
    Term term(const Language& language) { return convert(*language, false); }

    /// Whether the language has the empty word.
    bool nullable(Term term);
    Term derivative(Term term, Symbol letter);
    Term derivative(Term term, const Word& word);
    /// Whether no word is in the left language and not in the right one, worked out by comparing all
    /// derivatives of both that can be reached.
    bool included(Term left, Term right);
    bool equal(Term left, Term right);

    /// All derivatives of a term, itself first, and where each letter leads.
    struct Automaton {
        std::vector<char> accepting;
        std::vector<std::vector<std::size_t>> next;  // by state and symbol
    };
    Automaton automaton(Term term);

private:
    enum class Kind {
        none,
        empty_word,
        letter,
        product,
        star,
        any,
        all,
        complement,
        image,
        inverse_image
    };
    struct Node {
        Kind kind = Kind::none;
        std::size_t number = 0;  // of the letter or morphism
        std::vector<Term> parts;
        bool operator==(const Node&) const = default;
        bool operator<(const Node& other) const {
            return std::tie(kind, number, parts) < std::tie(other.kind, other.number, other.parts);
        }
    };
    using Morphism = std::map<Symbol, Word>;

    Term made(Node node);
    Term letter(Symbol a) { return made({Kind::letter, a, {}}); }
    Term product(Term left, Term right);
    Term star(Term part);
    Term any(std::vector<Term> parts);
    Term all(std::vector<Term> parts);
    Term complement(Term part);
    Term word(const Word& word, Term rest);
    Term convert(const Tree& tree, bool reversed);
    Term convert_morphism(const Tree& tree, bool reversed);
    std::vector<Term> after_erased(Term part, std::size_t morphism);
    bool find_nullable(Term term);
    Term find_derivative(Term term, Symbol letter);

    const Alphabet& alphabet_;
    const Budget& budget_;
    std::vector<Node> nodes_;
    std::map<Node, Term> numbers_;
    std::vector<Morphism> morphisms_;
    std::map<Term, bool> nullable_;
    std::map<std::pair<Term, Symbol>, Term> derivatives_;
    Term none_ = 0, empty_word_ = 0;
};

}  // namespace algae::verify
