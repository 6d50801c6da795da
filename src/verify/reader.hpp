#pragma once

#include "verify/certificate.hpp"

namespace algae::verify {

/// Reads the parts of a certificate. Everything throws Error where the text is not as CERTIFICATES.md says.
class Reader {
public:
    using Systems = std::map<std::string, std::shared_ptr<const System>>;

    using Rewritings = std::map<std::string, std::shared_ptr<const ModuleSystem>>;

    /// All must outlive this.
    Reader(const Alphabet& alphabet, const Systems& systems, const Rewritings& rewritings)
        : alphabet_(alphabet), systems_(systems), rewritings_(rewritings) {}

    const Alphabet& alphabet() const { return alphabet_; }

    Symbol letter(const Field& field) const;
    Word word(const Field& field) const;
    std::vector<Word> words(const Field& field) const;
    System system(const Field& field) const;
    NamedSystem named_system(const Field& field) const;
    Language language(const Field& field) const;
    Statement statement(const Field& field) const;

private:
    Symbol symbol(const Field& field, std::string_view name) const;
    /// Distinct letters, increasing.
    std::vector<Symbol> letters(const Field& field) const;
    std::map<Symbol, Word> morphism(const Field& field) const;
    System::Successors table(const Field& field) const;
    System with_context(const Field& field) const;
    Language on_one(const Field& field, const std::string& name) const;
    bool of_languages(const Field& field, Statement& read) const;
    Statement of_modules(const Field& field, Statement read) const;
    Statement of_dimension(const Field& field, Statement read) const;
    Statement of_systems(const Field& field, Statement read) const;

    const Alphabet& alphabet_;
    const Systems& systems_;
    const Rewritings& rewritings_;
};

}  // namespace algae::verify
