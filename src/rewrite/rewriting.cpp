#include "rewrite/rewriting.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "rewrite/free_step.hpp"
#include "rewrite/inner_systems.hpp"
#include "rewrite/module_text.hpp"
#include "rewrite/surroundings.hpp"

namespace algae {

namespace {

std::string at(const Production& rule) {
    return rule.place.line == 0 ? std::string("a rule") : to_string(rule.place);
}

}  // namespace

Rewriting::Rewriting(const LSystem& system, const RewritingChoices& choices, const Budget& budget)
    : rules_(compiled_rules(system, budget)), choices_(choices) {}

std::string Rewriting::name_of(std::uint64_t generation) const {
    return "the word of generation " + std::to_string(generation) + rules_.of;
}

void Rewriting::refuse(const std::string& what, const Production& rule, ModuleKind kind,
                       const double* values, std::size_t position, std::uint64_t generation) const {
    throw Error(at(rule) + ": the rule for " +
                ModuleText(rules_.system->alphabet, rules_.kinds).text(kind, values) +
                " at position " + std::to_string(position) + " of generation " +
                std::to_string(generation) + rules_.of + ": " + what);
}

void Rewriting::refuse_both(const Alternatives& first, const Alternatives& second, ModuleKind kind,
                            const double* values, std::size_t position,
                            std::uint64_t generation) const {
    const Production& other = *rules_.successors[second.successors.front()].rule;
    refuse("the rule at " + to_string(other.place) + " matches too, and " +
               (first.probabilities.empty() || second.probabilities.empty()
                    ? "not both have probabilities"
                    : "the probabilities add up to more than 1"),
           *rules_.successors[first.successors.front()].rule, kind, values, position, generation);
}

void Rewriting::check_choice(const Alternatives& alternatives, ModuleKind kind,
                             const double* values, std::size_t position,
                             std::uint64_t generation) const {
    if (alternatives.successors.size() == 1 || choices_.evenly ||
        !alternatives.probabilities.empty())
        return;
    const Production& first = *rules_.successors[alternatives.successors[0]].rule;
    const Production& second = *rules_.successors[alternatives.successors[1]].rule;
    refuse("the rule at " + to_string(second.place) + " matches too, and neither has a probability",
           first, kind, values, position, generation);
}

std::uint32_t Rewriting::pick(const Alternatives& alternatives, std::uint64_t number) const {
    const std::size_t count = alternatives.successors.size();
    if (count == 1) return alternatives.successors.front();
    if (alternatives.thresholds.empty())  // evenly: the whole part of count * number / 2^64
        return alternatives.successors[Draws::scaled(number, count)];
    std::size_t i = 0;
    while (i + 1 < count && number >= alternatives.thresholds[i]) ++i;
    return alternatives.successors[i];
}

const Alternatives* Rewriting::matching(const RuleSet& set, const Surroundings& around,
                                        ModuleKind kind, std::size_t position,
                                        std::uint64_t generation, std::vector<double>& parameters,
                                        std::vector<double>& others) const {
    const Alternatives* found = nullptr;
    const auto rule_of = [&](const Alternatives& alternatives) -> const Production& {
        return *rules_.successors[alternatives.successors.front()].rule;
    };
    for (const Alternatives& next : set.of[kind]) {
        if (found && found->context != next.context) break;
        if (found && !found->has_same_context(next)) continue;
        try {
            if (!around.match(next, position, found ? others : parameters)) continue;
        } catch (const Undefined& undefined) {
            refuse(undefined.reason, rule_of(next), kind, around.values_at(position), position,
                   generation);
        }
        if (found)
            refuse_both(*found, next, kind, around.values_at(position), position, generation);
        found = &next;
    }
    if (found) check_choice(*found, kind, around.values_at(position), position, generation);
    return found;
}

void Rewriting::append(const Outcome& outcome, const ModuleString& from, std::size_t position,
                       std::size_t offset, std::uint64_t generation, ModuleString& to) const {
    const ModuleKind kind = from.kinds[position];
    if (outcome.successor == 0) {
        to.kinds.push_back(kind);
        const double* values = from.values.data() + offset;
        to.values.insert(to.values.end(), values, values + rules_.kinds.arity(kind));
        return;
    }
    const Successor& successor = rules_.successors[outcome.successor];
    try {
        algae::append(successor, outcome.parameters.data(), rules_.kinds.words(), to);
    } catch (const Undefined& undefined) {
        refuse(undefined.reason, *successor.rule, kind, from.values.data() + offset, position,
               generation);
    }
}

std::vector<std::vector<Rewriting::Outcome>> Rewriting::outcomes(const ModuleString& word,
                                                                 std::uint64_t generation,
                                                                 std::size_t table,
                                                                 const Budget& budget) const {
    if (rules_.inner) rules_.inner->set_budget(budget);
    const RuleSet& set = rules_.tables.at(table);
    const std::string name = name_of(generation);
    const Surroundings around(rules_, word, name, budget);
    std::vector<std::vector<Outcome>> all(word.kinds.size());
    std::vector<double> parameters, others;
    for (std::size_t i = 0; i < word.kinds.size(); ++i) {
        const Alternatives* found =
            matching(set, around, word.kinds[i], i, generation, parameters, others);
        if (!found) {
            all[i].push_back({0, Rational(1), {}});
            continue;
        }
        for (std::size_t k = 0; k < found->successors.size(); ++k) {
            const Rational probability =
                found->probabilities.empty()
                    ? Rational(1, static_cast<long>(found->successors.size()))
                    : found->probabilities[k];
            all[i].push_back({found->successors[k], probability, parameters});
        }
    }
    return all;
}

ModuleString Rewriting::next_in_context(const RuleSet& set, const ModuleString& word,
                                        std::uint64_t generation, const Budget& budget) const {
    const std::string name = name_of(generation);
    const Surroundings around(rules_, word, name, budget);
    const Draws draws(choices_.seed, generation);
    ModuleString out;
    out.kinds.reserve(word.kinds.size());
    out.values.reserve(word.values.size());
    Outcome outcome;
    std::vector<double> others;
    std::size_t offset = 0;
    for (std::size_t i = 0; i < word.kinds.size(); ++i) {
        if (i % 4096 == 0) budget.check();
        const ModuleKind kind = word.kinds[i];
        const Alternatives* found =
            set.of[kind].empty()
                ? nullptr
                : matching(set, around, kind, i, generation, outcome.parameters, others);
        outcome.successor = found ? pick(*found, draws.at(i)) : 0;
        append(outcome, word, i, offset, generation, out);
        offset += rules_.kinds.arity(kind);
        if (out.kinds.size() > budget.letters)
            throw BoundReached(Bound::letters,
                               "generation " + std::to_string(generation + 1) + rules_.of +
                                   " has more than " + std::to_string(budget.letters) +
                                   " letters, the bound set" + budget.by(Bound::letters));
        budget.check_memory(
            out.kinds.capacity() * sizeof(ModuleKind) + out.values.capacity() * sizeof(double),
            "a word");
    }
    return out;
}

ModuleString Rewriting::next(const ModuleString& word, std::uint64_t generation, std::size_t table,
                             const Budget& budget) const {
    const RuleSet& set = rules_.tables.at(table);
    if (rules_.inner) rules_.inner->set_budget(budget);
    if (set.has_contexts || rules_.inner) return next_in_context(set, word, generation, budget);
    return FreeStep(*this, set, word, generation, budget).next();
}

std::size_t Rewriting::random_table(std::uint64_t generation) const {
    return Draws::scaled(Draws(choices_.seed, generation).of_table(), rules_.tables.size());
}

std::size_t Rewriting::own_table(std::uint64_t generation) const {
    const LSystem& system = *rules_.system;
    return system.schedule.empty() || choices_.random_tables ? random_table(generation)
                                                            : scheduled_table(system, generation);
}

ModuleString derive(const Rewriting& rewriting, std::uint64_t n,
                    const std::vector<std::size_t>& tables, const Budget& budget) {
    ModuleString word = rewriting.axiom();
    for (std::uint64_t generation = 0; generation < n; ++generation) {
        budget.check();
        const std::size_t table =
            tables.empty() ? rewriting.own_table(generation) : tables.at(generation);
        word = rewriting.next(word, generation, table, budget);
    }
    return word;
}

}  // namespace algae
