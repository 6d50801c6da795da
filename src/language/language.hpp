#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "system/et0l.hpp"
#include "system/il.hpp"

namespace algae {

/// An L-system that a language or a statement speaks of: without context (ET0L and all that it
/// includes) or deterministic with context (IL), over the symbols of a common alphabet.
struct SourceSystem {
    std::string name;  // as it is called in text
    std::optional<ET0L> tables;
    std::optional<IL> interactive;  // where `tables` is empty
};

struct LanguageTree;
/// A language as a value: an expression whose parts are languages. All parts are over the symbols of
/// one alphabet that the caller knows. Cheap to copy.
using Language = std::shared_ptr<const LanguageTree>;

/// One node of such an expression. Regular expressions are expressions like any other: finite sets under
/// union, concatenation, star and plus.
struct LanguageTree {
    enum class Kind {
        words,      // a finite set
        generated,  // L(G)
        united,     // the rest: of `parts`
        intersected,
        difference,
        concatenated,
        star,
        plus,
        complement,  // the words over `letters` that are not in the part
        reversed,
        image,          // under `morphism`
        inverse_image,  // the words over the letters that have an image whose image is in the part
    };
    Kind kind = Kind::words;
    std::vector<Word> words;  // sorted: shorter ones first, then by symbol numbers
    std::shared_ptr<const SourceSystem> system;  // of L(G)
    std::vector<Language>
        parts;  // two of a union, intersection, difference, concatenation; otherwise one
    std::map<Symbol, Word> morphism;
    std::vector<Symbol> letters;  // increasing
    std::string name;             // what the text calls it, where it has a name
};

Language words_language(std::vector<Word> words);
Language generated_language(std::shared_ptr<const SourceSystem> system);
/// Any kind with parts and nothing else.
Language combined(LanguageTree::Kind kind, std::vector<Language> parts);
/// The words over `letters` that are not in the language.
Language complement_language(Language language, std::vector<Symbol> letters);
Language image_language(Language language, std::map<Symbol, Word> morphism);
Language inverse_image_language(Language language, std::map<Symbol, Word> morphism);
Language named(Language language, std::string name);

/// The letters that may occur in words of the language, in increasing order: none is missing, but one
/// may be there that occurs in no word.
std::vector<Symbol> letters_of(const Language& language);

/// The expression as claims write it; parts that have names by name.
///
/// Example: to_string(words_language({{}}), Alphabet()) == "{ε}"
std::string to_string(const Language& language, const Alphabet& alphabet);

}  // namespace algae
