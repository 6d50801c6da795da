#pragma once

#include <string>

#include "fold/derive.hpp"
#include "rewrite/module_string.hpp"
#include "word/spelling.hpp"

namespace algae {

/// A parameter as it is printed: whole numbers below 10^21 as integers, others as the shortest
/// decimal that reads back as the same double, with an exponent where that is shorter.
///
/// Example: number_text(4.0) == "4"
/// Example: number_text(0.1 + 0.2) == "0.30000000000000004"
/// Example: number_text(1e-7) == "1e-7"
std::string number_text(double value);

/// Words of modules as text: `CB(1)A(8,7)`, with a blank only where two names written together would
/// be read otherwise; parameters that are words in quotes, `B("FF[+F]")`.
class ModuleText {
public:
    /// Both must outlive it and must not grow.
    ModuleText(const Alphabet& alphabet, const ModuleKinds& kinds)
        : alphabet_(alphabet), kinds_(kinds), spellings_(alphabet) {}

    /// Sends the word, nothing for the empty one; says whether there was anything to send.
    bool write(const ModuleString& word, TextSink& sink, const Budget& budget = {}) const;
    /// The word as one string, `ε` for the empty one.
    std::string text(const ModuleString& word) const;
    /// One module with its parameters.
    std::string text(ModuleKind kind, const double* values) const;

private:
    void add(std::string& out, ModuleKind kind, const double* values) const;
    void add(std::string& out, const ModuleString& word, std::size_t from, std::size_t to,
             const double*& values) const;

    const Alphabet& alphabet_;
    const ModuleKinds& kinds_;
    Spellings spellings_;
};

}  // namespace algae
