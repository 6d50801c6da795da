#pragma once
// claim: statements about languages, systems and what they draw, what is known of them and why, in sentences and in
// proofs that the room verify checks again.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/place.hpp"
#include "dimension/dimension_value.hpp"
#include "exact/integer.hpp"
#include "language/language.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// What a dimension is compared with.
struct ClaimedDimension {
    DimensionValue value;
    std::string text;  // as written
    bool at_most = false;
};

/// One thing that is said of languages and systems, true or false.
struct Statement {
    enum class Kind {
        family,    // languages[0] is of the family `family`
        finite,    // languages[0] is a finite language
        empty,     // languages[0] has no word
        equal,     // languages[0] == languages[1]
        included,  // languages[0] <= languages[1]
        member,    // `word` is in languages[0]
        size,      // languages[0] has exactly `size` words
        derives,  // systems[0] derives `word` from `from` (or its axiom) in `steps` steps (or some number)
        equal_sequences,  // systems[0] and systems[1], D0L: the same word in every generation
        equal_growth,     // the same length in every generation
        growth_formula,  // the length of generation n of systems[0] is `formula`, an expression in n
        rewrites,  // `rewriting` derives `modules` from `modules_from` (or its axiom) in `steps` steps
        chance,  // it does so with exactly this `probability`
        growth_class,  // the growth of systems[0] is of class `family`: zero, bounded, polynomial, exponential;
                       // polynomial of degree `size` if given
        dimension,  // the limit set that `drawn` draws has this `dimension`, or one at most as large
        boundary,   // its boundary has
    };
    Kind kind = Kind::family;
    bool negated = false;
    std::vector<Language> languages;
    std::vector<std::shared_ptr<const SourceSystem>> systems;
    std::string family;
    Word word;
    std::optional<Word> from;
    std::optional<std::uint64_t> steps;
    std::optional<Integer> size;
    std::optional<Expression> formula;
    std::shared_ptr<const LSystem> rewriting;  // its alphabet has all letters of both words
    ModuleWord modules;
    std::optional<ModuleWord> modules_from;
    std::optional<Rational> probability;
    std::shared_ptr<const LSystem> drawn;  // with the turtle
    std::optional<ClaimedDimension> dimension;
    std::string text;  // as written
    Place place;
};

/// A statement and what the claim says of it.
struct ClaimedStatement {
    Statement statement;
    enum class Purpose { show, lemma, refute } purpose = Purpose::show;  // `refute`: it is false
    std::string citation;  // `by ...`: the source it rests on where it is not decided
};

/// What a claim settles in the table of closure: families closed, or not closed, under an operation.
struct ClosureFact {
    bool closed = false;
    std::string operation;  // "union", "intersection with regular", ...
    std::vector<std::string> families;
    Place place;
};

/// A `.claim` file: definitions and statements about them.
struct Claim {
    std::string name;  // of the file
    std::string title, source;
    std::vector<std::string> notes;  // `note`, in the order of the file, printed by explanations
    bool empty_axiom = false;        // whether families of systems may have the empty word as axiom
    std::shared_ptr<const Alphabet> alphabet;
    std::vector<std::shared_ptr<const SourceSystem>> systems;  // defined by the claim, in order
    /// Defined by the claim: systems whose words are derived module by module.
    std::vector<std::shared_ptr<const LSystem>> rewritings;
    std::vector<Language> languages;  // defined by the claim, each with its name
    std::vector<ClaimedStatement> statements;
    std::vector<ClosureFact> closure;
};

}  // namespace algae
