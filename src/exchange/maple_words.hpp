#pragma once

#include "exchange/maple_form.hpp"
#include "exchange/maple_values.hpp"
#include "system/lsystem.hpp"

namespace algae {

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
