#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace algae {

/// A statement that exercises have and claims have not, about a system called `answer`.
struct OwnStatement {
    enum class Kind {
        form,    // answer is D0L
        count,   // answer has at most 2 rules
        figures  // figure(answer, 4) is similar to figure(koch, 4)
    };
    enum class Counted { rules, letters, axiom_symbols };
    enum class Relation { similar, congruent, same };
    struct Figure {
        std::string system;      // `answer`, or what a system is opened by
        std::size_t offset = 0;  // where its name stands in the statement, in bytes
        std::uint64_t generation = 0;
    };

    Kind kind = Kind::form;
    std::string form;
    Counted counted = Counted::rules;
    bool at_most = false;
    std::uint64_t count = 0;
    Figure left, right;
    Relation relation = Relation::same;
};

/// The statement that a text says, without comments. Throws SyntaxError where it says none.
OwnStatement read_own_statement(std::string_view text);

}  // namespace algae
