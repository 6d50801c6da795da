#include "notation/claim_operations.hpp"

#include <algorithm>
#include <string>

namespace algae {

namespace {

constexpr std::size_t most_parts = 1'000'000;

/// What the bounds say of an operation on these parts; the language is still missing.
LanguageOperand measured(const std::vector<LanguageOperand>& parts, const char* where) {
    LanguageOperand out;
    for (const LanguageOperand& part : parts) {
        out.levels = std::max(out.levels, part.levels + 1);
        out.parts += part.parts;
    }
    if (out.levels > most_levels) throw too_deep(where);
    if (out.parts > most_parts)
        throw SyntaxError{where, "a language with more than " + std::to_string(most_parts) +
                                     " parts where its names are written out"};
    return out;
}

}  // namespace

SyntaxError too_deep(const char* where) {
    return {where, "a language with more than " + std::to_string(most_levels) +
                       " operations inside each other"};
}

LanguageOperand combined_operand(LanguageTree::Kind kind, std::vector<LanguageOperand> parts,
                                 const char* where) {
    LanguageOperand out = measured(parts, where);
    std::vector<Language> languages;
    for (LanguageOperand& part : parts) languages.push_back(std::move(part.language));
    out.language = combined(kind, std::move(languages));
    return out;
}

LanguageOperand complement_operand(LanguageOperand part, const ClaimReading& reading,
                                   const char* where) {
    LanguageOperand out = measured({part}, where);
    std::vector<Symbol> letters = letters_of(part.language);
    if (!reading.declared.empty()) {
        for (const Symbol letter : letters)
            if (!std::binary_search(reading.declared.begin(), reading.declared.end(), letter))
                throw SyntaxError{
                    where, "expected a language over the letters of 'alphabet', found the letter " +
                               reading.alphabet->name(letter)};
        letters = reading.declared;
    }
    if (letters.empty())
        throw SyntaxError{where,
                          "expected a language with letters after '~', found one without; "
                          "'alphabet a b' says what letters there are"};
    out.language = complement_language(std::move(part.language), std::move(letters));
    return out;
}

LanguageOperand image_operand(LanguageOperand part, const std::map<Symbol, Word>& morphism,
                              std::string_view name, const ClaimReading& reading) {
    LanguageOperand out = measured({part}, name.data());
    for (const Symbol letter : letters_of(part.language))
        if (!morphism.count(letter))
            throw SyntaxError{name.data(),
                              "expected a morphism with an image for each letter of the language, "
                              "found none for " +
                                  reading.alphabet->name(letter)};
    out.language = image_language(std::move(part.language), morphism);
    return out;
}

LanguageOperand inverse_image_operand(LanguageOperand part, const std::map<Symbol, Word>& morphism,
                                      const char* where) {
    LanguageOperand out = measured({part}, where);
    out.language = inverse_image_language(std::move(part.language), morphism);
    return out;
}

}  // namespace algae
