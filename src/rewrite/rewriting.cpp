#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "rewrite/detail/free_step.hpp"
#include "rewrite/detail/inner_systems.hpp"
#include "rewrite/rewrite.hpp"
#include "watch/watch.hpp"
#include "word/word.hpp"

// Derivation of words of modules, step by step: which engine a step takes, schedules of tables, and what rules see
// around a module.
//
// Contexts are those of trees (see IL in the face of `system`): the left context goes down the axis to the root, the right one may
// choose among branches, and the search goes back where a branch was the wrong one, also when only the condition fails. Modules elsewhere
// in the word are tried in a fixed order, so that the first combination that makes the condition true is a rule's
// meaning and not an accident.

namespace algae {

/// What rules see around the modules of one word: neighbours on the axes of its tree, branches, and
/// where modules stand. What contexts mean is said at IL; a module of a context matches one with
/// the same letter and as many parameters.
class Surroundings {
public:
    /// O(length of the word). Throws Error if the brackets of a tree do not match; `name` is how
    /// the message calls the word.
    Surroundings(const CompiledRules& rules, const ModuleString& word, const std::string& name,
                 const Budget& budget);

    /// Whether the rules' left side matches the module at this position. If so its parameters and
    /// those of the contexts are in `parameters`, the ones of modules elsewhere too: of the
    /// combinations of modules that make the condition true the first, where each module is sought
    /// from left to right and that of the last item moves on first. One module may stand for two
    /// items; the rewritten one itself stands for none. Throws `Undefined`. With `seen`, the positions of
    /// these modules, as they are found.
    bool match(const Alternatives& rules, std::size_t position, std::vector<double>& parameters,
               std::vector<std::size_t>* seen = nullptr) const;

    /// The first parameter of the module at this position.
    const double* values_at(std::size_t position) const {
        return word_.values.data() + (offsets_.empty() ? 0 : offsets_[position]);
    }

private:
    static constexpr std::size_t none = ~std::size_t{0};
    struct Search;

    using Seen = std::vector<std::size_t>*;

    /// A module that is seen while the rest is tried, and forgotten if that fails.
    template <class Rest>
    static bool with(Seen seen, std::size_t position, Rest rest) {
        if (!seen) return rest();
        seen->push_back(position);
        if (rest()) return true;
        seen->pop_back();
        return false;
    }

    void find_left();
    void find_right();
    void bind(std::size_t position, std::vector<double>& parameters, std::size_t& filled) const;
    bool match_left(const Alternatives& rules, std::size_t position,
                    std::vector<double>& parameters, std::size_t& filled, Seen seen) const;
    bool match_elsewhere(const Alternatives& rules, std::size_t position, std::size_t item,
                         std::size_t filled, std::vector<double>& parameters, Seen seen) const;

    const CompiledRules& rules_;
    const ModuleString& word_;
    const std::string& name_;
    const Budget& budget_;
    bool trees_ = false;
    std::vector<std::uint64_t> offsets_;    // of parameters, by position; empty if there are none
    std::vector<std::size_t> left_, axis_;  // the neighbour on the left; the first module that is
                                            // seen from a position on to the right
    std::vector<std::size_t> closes_;       // by position of [: its ]
    std::vector<std::vector<std::size_t>> at_;  // by kind that is sought elsewhere: its positions
};

Surroundings::Surroundings(const CompiledRules& rules, const ModuleString& word,
                           const std::string& name, const Budget& budget)
    : rules_(rules), word_(word), name_(name), budget_(budget) {
    const std::size_t size = word.kinds.size();
    budget.check_memory(size * 4 * sizeof(std::size_t), "what contexts see of a word");
    const auto brackets = brackets_of(rules.system->alphabet);
    const auto& ignored = rules.system->ignored;
    const auto is_ignored = [&](Symbol a) {
        return std::find(ignored.begin(), ignored.end(), a) != ignored.end();
    };
    trees_ = brackets && !(is_ignored(brackets->open) && is_ignored(brackets->close));
    if (!word.values.empty()) {
        offsets_.resize(size);
        std::uint64_t offset = 0;
        for (std::size_t i = 0; i < size; ++i) {
            offsets_[i] = offset;
            offset += rules.kinds.arity(word.kinds[i]);
        }
    }
    at_.resize(rules.kinds.size());
    for (std::size_t i = 0; i < size; ++i)
        if (rules.sought[word.kinds[i]]) at_[word.kinds[i]].push_back(i);
    find_left();
    find_right();
}

void Surroundings::find_left() {
    const std::size_t size = word_.kinds.size();
    left_.resize(size);
    if (trees_) closes_.assign(size, none);
    std::vector<std::pair<std::size_t, std::size_t>> open;  // brackets, and what stands before them
    std::size_t last = none;
    for (std::size_t i = 0; i < size; ++i) {
        if (i % 65536 == 0) budget_.check();
        const ModuleKind kind = word_.kinds[i];
        left_[i] = last;
        if (trees_ && rules_.opens[kind]) {
            open.emplace_back(i, last);
        } else if (trees_ && rules_.closes[kind]) {
            if (open.empty())
                throw Error(name_ + ": the ']' at position " + std::to_string(i) +
                            " closes nothing");
            closes_[open.back().first] = i;
            last = open.back().second;
            open.pop_back();
        } else if (!rules_.ignored[kind]) {
            last = i;
        }
    }
    if (!open.empty())
        throw Error(name_ + ": the '[' at position " + std::to_string(open.back().first) +
                    " is not closed");
}

void Surroundings::find_right() {
    const std::size_t size = word_.kinds.size();
    axis_.resize(size + 1);
    axis_[size] = none;
    for (std::size_t i = size; i-- > 0;) {
        const ModuleKind kind = word_.kinds[i];
        if (trees_ && rules_.closes[kind])
            axis_[i] = none;
        else if (trees_ && rules_.opens[kind])
            axis_[i] = axis_[closes_[i] + 1];
        else
            axis_[i] = rules_.ignored[kind] ? axis_[i + 1] : i;
    }
}

void Surroundings::bind(std::size_t position, std::vector<double>& parameters,
                        std::size_t& filled) const {
    const std::uint32_t arity = rules_.kinds.arity(word_.kinds[position]);
    std::copy_n(values_at(position), arity,
                parameters.begin() + static_cast<std::ptrdiff_t>(filled));
    filled += arity;
}

/// The search for a right context, which goes back where a branch was the wrong one, be it that
/// the condition does not hold.
struct Surroundings::Search {
    const Surroundings& around;
    const Alternatives& rules;
    std::size_t position;
    std::vector<double>& parameters;
    Seen seen;
    std::vector<std::size_t> inside = {};  // the closing brackets of the branches gone into

    bool match(std::size_t item, std::size_t from, std::size_t filled) {
        const auto& context = rules.right;
        if (item == context.size())
            return around.match_elsewhere(rules, position, 0, filled, parameters, seen);
        if (around.trees_ && around.rules_.opens[context[item]])
            return match_branch(item, from, filled);
        if (around.trees_ && around.rules_.closes[context[item]]) {
            const std::size_t close = inside.back();
            inside.pop_back();
            const bool found = match(item + 1, close + 1, filled);
            inside.push_back(close);
            return found;
        }
        const std::size_t next = around.axis_[from];
        if (next == none || around.word_.kinds[next] != context[item]) return false;
        around.bind(next, parameters, filled);
        return with(seen, next, [&] { return match(item + 1, next + 1, filled); });
    }

    bool match_branch(std::size_t item, std::size_t from, std::size_t filled) {
        const auto& kinds = around.word_.kinds;
        for (std::size_t i = from; i < kinds.size(); ++i) {
            if (around.rules_.ignored[kinds[i]]) continue;
            if (!around.rules_.opens[kinds[i]]) return false;
            inside.push_back(around.closes_[i]);
            const bool found = match(item + 1, i + 1, filled);
            inside.pop_back();
            if (found) return true;
            i = around.closes_[i];
        }
        return false;
    }
};

bool Surroundings::match_left(const Alternatives& rules, std::size_t position,
                              std::vector<double>& parameters, std::size_t& filled,
                              Seen seen) const {
    std::size_t total = 0;
    for (const ModuleKind kind : rules.left) total += rules_.kinds.arity(kind);
    std::size_t end = filled + total;
    filled = end;
    std::size_t at = position;
    for (auto wanted = rules.left.rbegin(); wanted != rules.left.rend(); ++wanted) {
        at = left_[at];
        if (at == none || word_.kinds[at] != *wanted) return false;
        if (seen) seen->push_back(at);
        const std::uint32_t arity = rules_.kinds.arity(*wanted);
        end -= arity;
        std::copy_n(values_at(at), arity, parameters.begin() + static_cast<std::ptrdiff_t>(end));
    }
    return true;
}

bool Surroundings::match_elsewhere(const Alternatives& rules, std::size_t position,
                                   std::size_t item, std::size_t filled,
                                   std::vector<double>& parameters, Seen seen) const {
    if (rules.elsewhere.empty())
        return !rules.condition || rules.condition->run(parameters.data()) != 0;
    for (const auto& conjunct : rules.conjuncts)
        if (conjunct.elsewhere == item && conjunct.holds.run(parameters.data()) == 0) return false;
    if (item == rules.elsewhere.size()) return true;
    budget_.check();
    for (const std::size_t at : at_[rules.elsewhere[item]]) {
        if (at == position) continue;
        std::size_t end = filled;
        bind(at, parameters, end);
        const auto rest = [&] {
            return match_elsewhere(rules, position, item + 1, end, parameters, seen);
        };
        if (with(seen, at, rest)) return true;
    }
    return false;
}

bool Surroundings::match(const Alternatives& rules, std::size_t position,
                         std::vector<double>& parameters, std::vector<std::size_t>* seen) const {
    parameters.resize(rules.parameters);
    if (seen) seen->clear();
    std::size_t filled = 0;
    bind(position, parameters, filled);
    if (!match_left(rules, position, parameters, filled, seen)) return false;
    return Search{*this, rules, position, parameters, seen}.match(0, position + 1, filled);
}

namespace {

std::string at(const Production& rule) {
    return rule.place.file.empty() ? std::string("a rule") : to_string(rule.place);
}

/// Another rule, as messages about two of them name it.
std::string other(const Production& rule) {
    return rule.place.line == 0 ? std::string("another rule")
                                : "the rule at " + to_string(rule.place);
}

}  // namespace

Rewriting::Rewriting(const LSystem& system, const RewritingChoices& choices, const Budget& budget)
    : rules_(compiled_rules(system, budget, nullptr, choices.arithmetic)), choices_(choices) {}

std::string Rewriting::name_of(std::uint64_t generation) const {
    return "the word of generation " + std::to_string(generation) + rules_.of;
}

std::string Rewriting::refusal(const std::string& what, const Production& rule, ModuleKind kind,
                               const double* values, std::size_t position,
                               std::uint64_t generation) const {
    return at(rule) + ": the rule for " +
           ModuleText(rules_.system->alphabet, rules_.kinds).text(kind, values) + " at position " +
           std::to_string(position) + " of generation " + std::to_string(generation) + rules_.of +
           ": " + what;
}

void Rewriting::refuse(const std::string& what, const Production& rule, ModuleKind kind,
                       const double* values, std::size_t position, std::uint64_t generation) const {
    throw Error(refusal(what, rule, kind, values, position, generation));
}

void Rewriting::refuse(const Undefined& undefined, const Production& rule, ModuleKind kind,
                       const double* values, std::size_t position, std::uint64_t generation) const {
    const std::string text = refusal(undefined.reason, rule, kind, values, position, generation);
    if (undefined.is_undecided) throw UndecidedValue(text);
    throw Error(text);
}

void Rewriting::refuse_both(const Alternatives& first, const Alternatives& second, ModuleKind kind,
                            const double* values, std::size_t position,
                            std::uint64_t generation) const {
    refuse(other(*rules_.successors[second.successors.front()].rule) + " matches too, and " +
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
    refuse(other(second) + " matches too, and neither has a probability", first, kind, values,
           position, generation);
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
                                        std::vector<double>& others,
                                        std::vector<std::size_t>* seen) const {
    const Alternatives* found = nullptr;
    const auto rule_of = [&](const Alternatives& alternatives) -> const Production& {
        return *rules_.successors[alternatives.successors.front()].rule;
    };
    for (const Alternatives& next : set.of[kind]) {
        if (found && found->context != next.context) break;
        if (found && !found->has_same_context(next)) continue;
        try {
            if (!around.match(next, position, found ? others : parameters, found ? nullptr : seen))
                continue;
        } catch (const Undefined& undefined) {
            refuse(undefined, rule_of(next), kind, around.values_at(position), position,
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
        refuse(undefined, *successor.rule, kind, from.values.data() + offset, position, generation);
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
                                        std::uint64_t generation, const Budget& budget,
                                        TracedStep* trace) const {
    const std::string name = name_of(generation);
    const Surroundings around(rules_, word, name, budget);
    const Draws draws(choices_.seed, generation);
    ModuleString out;
    out.kinds.reserve(word.kinds.size());
    out.values.reserve(word.values.size());
    Outcome outcome;
    std::vector<double> others;
    std::vector<std::size_t> seen;
    std::size_t offset = 0;
    WorkCount modules("module", word.kinds.size());
    for (std::size_t i = 0; i < word.kinds.size(); ++i) {
        if (i % 4096 == 0) budget.check();
        modules.at(i);
        const ModuleKind kind = word.kinds[i];
        const Alternatives* found =
            set.of[kind].empty() ? nullptr
                                 : matching(set, around, kind, i, generation, outcome.parameters,
                                            others, trace ? &seen : nullptr);
        outcome.successor = found ? pick(*found, draws.at(i)) : 0;
        const std::size_t before = out.kinds.size();
        append(outcome, word, i, offset, generation, out);
        if (trace) {
            trace->lengths.push_back(static_cast<std::uint32_t>(out.kinds.size() - before));
            if (!found) seen.clear();
            std::sort(seen.begin(), seen.end());
            seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
            trace->seen.push_back(seen);
        }
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
    if (rules_.kinds.words()) rules_.kinds.held()->set_memory(budget.memory);
    if (set.has_contexts || rules_.inner) return next_in_context(set, word, generation, budget);
    return FreeStep(*this, set, word, generation, budget).next();
}

TracedStep Rewriting::traced(const ModuleString& word, std::uint64_t generation, std::size_t table,
                             const Budget& budget) const {
    if (rules_.inner) rules_.inner->set_budget(budget);
    if (rules_.kinds.words()) rules_.kinds.held()->set_memory(budget.memory);
    TracedStep step;
    step.word = next_in_context(rules_.tables.at(table), word, generation, budget, &step);
    return step;
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
    WorkCount generations("generation", n);
    for (std::uint64_t generation = 0; generation < n; ++generation) {
        budget.check();
        generations.at(generation + 1);
        const std::size_t table = tables.empty() ? rewriting.own_table(generation)
                                                 : tables.at(static_cast<std::size_t>(generation));
        word = rewriting.next(word, generation, table, budget);
    }
    return word;
}

ModuleTrace traced(const Rewriting& rewriting, std::uint64_t n,
                   const std::vector<std::size_t>& tables, std::uint64_t most,
                   const Budget& budget) {
    ModuleTrace trace;
    trace.words.push_back(rewriting.axiom());
    std::uint64_t modules = rewriting.axiom().kinds.size();
    WorkCount generations("generation", n);
    for (std::uint64_t generation = 0; generation < n; ++generation) {
        budget.check();
        generations.at(generation + 1);
        const std::size_t table = tables.empty() ? rewriting.own_table(generation)
                                                 : tables.at(static_cast<std::size_t>(generation));
        Budget rest = budget;
        const bool is_least = modules < most && most - modules < budget.letters;
        if (is_least) rest.letters = most - modules;
        try {
            if (modules >= most) throw BoundReached(Bound::letters, "");
            TracedStep step = rewriting.traced(trace.words.back(), generation, table, rest);
            modules += step.word.kinds.size() + 1;  // words without modules are counted too
            trace.words.push_back(std::move(step.word));
            trace.tables.push_back(table);
            trace.lengths.push_back(std::move(step.lengths));
            trace.seen.push_back(std::move(step.seen));
        } catch (const BoundReached& bound) {
            if (bound.bound() != Bound::letters || (!is_least && modules < most)) throw;
            trace.goes_on = true;
            break;
        }
    }
    return trace;
}

}  // namespace algae
