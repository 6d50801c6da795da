#include "claim/decide.hpp"

#include "base/error.hpp"
#include "claim/judge_dimension.hpp"
#include "claim/judge_equality.hpp"
#include "claim/judge_family.hpp"
#include "claim/judge_membership.hpp"
#include "claim/judge_rewriting.hpp"
#include "claim/judge_system.hpp"
#include "claim/judge_values.hpp"

namespace algae {

namespace {

Judgement affirmed(const Statement& statement, const Claim& claim, const Budget& budget) {
    const Alphabet& alphabet = *claim.alphabet;
    const auto language = [&](std::size_t i) -> const Language& {
        return statement.languages.at(i);
    };
    const auto system = [&](std::size_t i) -> const SourceSystem& {
        return *statement.systems.at(i);
    };
    switch (statement.kind) {
        case Statement::Kind::family:
            return judge_family(language(0), {statement.family, claim.empty_axiom, claim.systems},
                                alphabet, budget);
        case Statement::Kind::finite:
            return judge_finite(language(0), alphabet, budget);
        case Statement::Kind::empty:
            return judge_empty(language(0), alphabet, budget);
        case Statement::Kind::equal:
            return judge_equality(language(0), language(1), alphabet, budget);
        case Statement::Kind::included:
            return judge_inclusion(language(0), language(1), alphabet, budget);
        case Statement::Kind::member:
            return judge_membership(language(0), statement.word, alphabet, budget);
        case Statement::Kind::size:
            return judge_size(language(0), *statement.size, alphabet, budget);
        case Statement::Kind::derives:
            return judge_derivation(system(0), statement.word, statement.from, statement.steps,
                                    alphabet, budget);
        case Statement::Kind::rewrites:
            return judge_rewriting(statement, budget);
        case Statement::Kind::chance:
            return judge_chance(statement, budget);
        case Statement::Kind::equal_sequences:
            return judge_sequences(system(0), system(1), alphabet, budget);
        case Statement::Kind::equal_growth:
            return judge_growth(system(0), system(1), budget);
        case Statement::Kind::growth_formula:
            return judge_growth_formula(system(0), *statement.formula, budget);
        case Statement::Kind::growth_class:
            return judge_growth_class(system(0), statement.family, statement.size, budget);
        case Statement::Kind::dimension:
            return judge_dimension(*statement.drawn, *statement.dimension, budget);
        case Statement::Kind::boundary:
            return judge_boundary(*statement.drawn, *statement.dimension, budget);
    }
    return Judgement::undecided({});
}

}  // namespace

//> decide
Judgement decide(const Statement& statement, const Claim& claim, const Budget& budget) {
    try {
        Judgement found = affirmed(statement, claim, budget);
        return statement.negated ? opposite(std::move(found)) : found;
    } catch (const BoundReached& error) {
        return Judgement::undecided({error.what()});
    } catch (const Error& error) {
        const std::string what = error.what(), file = statement.place.file;
        if (statement.place.line == 0 || (!file.empty() && what.starts_with(file + ":"))) throw;
        throw Error(to_string(statement.place) + ": " + what);
    }
}
//< decide

}  // namespace algae
