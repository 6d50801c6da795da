#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/verdict.hpp"
#include "verify/field.hpp"
#include "verify/modules.hpp"
#include "verify/system.hpp"

namespace algae::verify {

struct Tree;
/// An expression for a language.
using Language = std::shared_ptr<const Tree>;

/// One node of such an expression.
struct Tree {
    enum class Kind {
        words,
        generated,
        united,
        intersection,
        difference,
        concatenation,
        star,
        plus,
        reversal,
        complement,
        image,
        inverse_image
    };
    Kind kind = Kind::words;
    std::vector<Word> words;               // in shortlex order, each once
    std::shared_ptr<const System> system;  // of `generated`
    std::string name;                      // of the system
    std::vector<Language> parts;
    std::vector<Symbol> letters;      // of a complement, increasing
    std::map<Symbol, Word> morphism;  // of an image or inverse image
};

Language words_of(std::vector<Word> words);
Language generated_by(std::shared_ptr<const System> system, std::string name);
Language combination(Tree::Kind kind, std::vector<Language> parts);

/// Whether the expressions are the same, whatever their systems are called.
bool same(const Language& left, const Language& right);
/// Whether no system occurs in the expression.
bool is_regular(const Language& language);

/// One system of the certificate.
struct NamedSystem {
    std::string name;
    std::shared_ptr<const System> system;
};

/// What is said, without any "not" before it.
struct Statement {
    enum class Kind {
        family,
        finite,
        empty,
        equal,
        included,
        member,
        size,
        derives,
        rewrites,
        chance,
        equal_sequences,
        equal_growth,
        growth_formula,
        growth_class,
        dimension,
        boundary
    };
    Kind kind = Kind::family;
    bool negated = false;
    std::string family;  // or class of growth; of a dimension, the system
    std::vector<Language> languages;
    std::vector<NamedSystem> systems;
    Word word;
    std::optional<Word> from;
    std::optional<Integer> steps;
    std::optional<Integer> size;  // or degree of growth
    std::optional<Field> formula;  // or the value of a dimension, equal or `at_most`
    bool at_most = false;
    std::shared_ptr<const ModuleSystem> rewriting;  // called `family`
    Modules modules;
    std::optional<Modules> modules_from;
    std::optional<Rational> probability;
};

/// One statement of a certificate and what is said of it.
struct Entry {
    Field field;
    std::string text;
    Statement statement;
    enum class Verdict { proved, refuted, undecided, cited } verdict = Verdict::undecided;
    std::optional<Field> proof;  // of one proved or refuted
    std::string citation;
};

/// A whole certificate. The fields refer to `root` and `file`.
struct Certificate {
    std::string file;
    JsonValue root;
    std::string claim, source;
    bool empty_axiom = false;  // whether the empty word may be the axiom of a system
    std::shared_ptr<const Alphabet> alphabet;
    std::map<std::string, std::shared_ptr<const System>> systems;
    std::map<std::string, std::shared_ptr<const ModuleSystem>> rewritings;
    std::vector<Entry> entries;
};

/// The certificate that a text holds (CERTIFICATES.md). Its proofs are not looked at. Throws Error naming the
/// path and the line of the first field that is missing, unexpected or of the wrong type.
std::unique_ptr<const Certificate> read_certificate(const std::string& text,
                                                    const std::string& file);

}  // namespace algae::verify
