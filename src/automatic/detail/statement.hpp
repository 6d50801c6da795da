#pragma once

#include <map>
#include <string>
#include <vector>

#include "automatic/automatic.hpp"

namespace algae {

/// A linear term: variables with coefficients, and a constant.
struct LinearTerm {
    std::map<std::string, Integer> coefficients;  // none of them 0
    Integer constant = 0;

    /// Adds so many times another term.
    void add(const LinearTerm& other, const Integer& times);
    /// The variable that it is, if it is one.
    const std::string* variable() const;
    /// Two terms, with nothing negative in them, of which it is the difference.
    std::pair<LinearTerm, LinearTerm> sides() const;
    bool operator==(const LinearTerm&) const = default;
};

/// A statement as a tree. Bound variables have names of their own, `i#3`.
struct FirstOrderNode {
    enum class Kind {
        equation,     // terms[0] is 0
        less,         // terms[0] is below 0
        same_letter,  // the letters at terms[0] and terms[1] are the same
        letter,       // the letter at terms[0] is `letter`
        equal,        // the factors of terms[2] letters at terms[0] and terms[1] are equal
        palindrome,   // the factor of terms[1] letters at terms[0] is one
        negation,
        conjunction,
        disjunction,
        implication,
        equivalence,  // of any number of parts: so many of them are false as makes an even number
        exists,
        for_all
    };
    Kind kind;
    std::vector<LinearTerm> terms;
    std::string letter;
    std::vector<std::string> variables;  // that a quantifier binds
    std::vector<std::shared_ptr<const FirstOrderNode>> parts;
};

/// The name of a variable as it was written.
std::string written_name(const std::string& variable);

}  // namespace algae
