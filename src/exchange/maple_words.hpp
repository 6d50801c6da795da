#pragma once

#include "exchange/maple_values.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// Which of the procedures of the worksheet a call is for.
enum class MapleForm { strings, stochastic, parametric };

/// What a symbol of a system is to the turtle of a procedure. Used within this room only.
enum class MapleMeaning {
    same,    // the same as in the notation
    none,    // nothing, and something in the notation: the interpretation leaves it out
    refused  // nothing, and in the notation a turn in space that cannot be left out
};
MapleMeaning maple_meaning(MapleForm form, const std::string& symbol);

/// The symbol that a character of a string stands for: `?` for `\`, in the stochastic form `(` and `)`
/// for brackets. Fails at the offset where it is no symbol.
std::string maple_symbol(const Scanner& scanner, MapleForm form, std::string_view character,
                         std::size_t offset);

/// Axiom and rules of `Lsystem(AXIOMA, REGRAS, ...)` into the system, with probabilities if there are
/// five arguments. Fails with the place of what is wrong.
void read_maple_words(MapleValues& values, LSystem& system);

/// The same of `Lsystem(AXIOMA, N)`, whose rules are functions.
void read_maple_modules(MapleValues& values, LSystem& system);

/// Checks that brackets match, one `meet` after the other and `end` last.
class MapleBrackets {
public:
    MapleBrackets(const Scanner& scanner) : scanner_(scanner) {}
    void meet(const std::string& symbol, std::size_t offset);
    void end() const;

private:
    const Scanner& scanner_;
    std::vector<std::size_t> open_;
};

}  // namespace algae
