#include "turtle/module_turtle.hpp"

#include <algorithm>
#include <span>

#include "base/error.hpp"
#include "rewrite/draws.hpp"
#include "rewrite/module_text.hpp"
#include "rewrite/word_values.hpp"

namespace algae {

namespace {

constexpr std::size_t deepest_interpretation = 1000;
constexpr std::uint64_t longest_interpretation = 1'000'000;  // modules for one of the word

/// A system whose rules are the interpretation of this one.
LSystem interpretation_of(const LSystem& system) {
    LSystem out = system;
    out.axiom = {};
    out.tables.clear();
    out.schedule.clear();
    out.rules = std::move(out.interpretation);
    out.interpretation.clear();
    for (Production& rule : out.rules) {
        rule.table = 0;
        if (!rule.left.empty() || !rule.right.empty() || !rule.elsewhere.empty() || rule.shape)
            throw Error(to_string(rule.place) + ": the interpretation of " +
                        out.alphabet.name(rule.predecessor.symbol) +
                        (rule.shape ? " is a shape rule" : " has a context") +
                        ": the turtle sees one module at a time");
    }
    return out;
}

}  // namespace

std::string figure_name(const LSystem& system, std::uint64_t generation) {
    return "generation " + std::to_string(generation) +
           (system.name.empty() ? "" : " of " + system.name);
}

ModuleTurtle::ModuleTurtle(const LSystem& system, const ModuleKinds& kinds,
                           std::uint64_t generation, std::uint64_t seed)
    : rules_(compiled_rules(interpretation_of(system), {}, &kinds)),
      name_(figure_name(system, generation)),
      manner_(turtle_manner(system, generation, name_)),
      generation_(generation),
      seed_(seed) {
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        own_kinds_.push_back(rules_.kinds.kind(kinds.letter(static_cast<ModuleKind>(kind)),
                                               kinds.arity(static_cast<ModuleKind>(kind))));
    for (std::size_t i = 0; i < rules_.kinds.size(); ++i) {
        const auto kind = static_cast<ModuleKind>(i);
        commands_.push_back(
            turtle_command(*rules_.system, rules_.kinds.letter(kind), rules_.kinds.arity(kind)));
        interpreted_.push_back(has_interpretation(kind));
    }
}

bool ModuleTurtle::has_interpretation(ModuleKind kind) const {
    const auto& of = rules_.tables.front().of;
    return kind < of.size() && !of[kind].empty();
}

std::optional<Symbol> ModuleTurtle::symbol_of_space(const ModuleString& word) const {
    std::vector<char> seen(rules_.kinds.size());
    std::vector<ModuleKind> open;
    const auto meet = [&](ModuleKind kind) {
        if (!seen[kind]) open.push_back(kind);
        seen[kind] = 1;
    };
    for (const ModuleKind kind : word.kinds) meet(own_kinds_.at(kind));
    while (!open.empty()) {
        const ModuleKind kind = open.back();
        open.pop_back();
        if (commands_[kind].leaves_plane) return rules_.kinds.letter(kind);
        if (!interpreted_[kind]) continue;
        for (const Alternatives& alternatives : rules_.tables.front().of[kind])
            for (const std::uint32_t successor : alternatives.successors) {
                for (const ModuleKind part : rules_.successors[successor].kinds) meet(part);
                if (rules_.successors[successor].splices.empty()) continue;
                for (std::size_t part = 0; part < rules_.kinds.size(); ++part)
                    meet(static_cast<ModuleKind>(part));  // a word may have any of them
            }
    }
    return std::nullopt;
}

/// One walk.
class ModuleTurtle::Walk {
public:
    Walk(const ModuleTurtle& turtle, TurtleEvents& events)
        : turtle_(turtle),
          events_(events),
          obedient_(turtle.manner_, events),
          draws_(~turtle.seed_, turtle.generation_) {}

    TurtleState all(const ModuleString& word, const Budget& budget) {
        const bool wanted = events_.wants_modules();
        const double* values = word.values.data();
        for (position_ = 0; position_ < word.kinds.size(); ++position_) {
            if (position_ % 65536 == 0) budget.check();
            if (wanted) events_.before(position_, obedient_.state());
            const ModuleKind kind = turtle_.own_kinds_[word.kinds[position_]];
            if (turtle_.interpreted_[kind]) {
                interpreted_ = 0;
                top_ = kind;
                top_values_ = values;
                interpret(kind, values, 0, budget);
                top_values_ = nullptr;
            } else {
                obey(kind, values);
            }
            values += turtle_.rules_.kinds.arity(kind);
        }
        try {
            obedient_.finish();
        } catch (const TurtleRefusal& refusal) {
            throw Error(turtle_.name_ + ": " + refusal.reason);
        }
        return obedient_.state();
    }

private:
    [[noreturn]] void fail(ModuleKind kind, const double* values, const std::string& what) const {
        const ModuleText text(turtle_.rules_.system->alphabet, turtle_.rules_.kinds);
        std::string where = turtle_.name_ + ", position " + std::to_string(position_);
        if (top_values_) where += ", in the interpretation of " + text.text(top_, top_values_);
        throw Error(where + ": " + text.text(kind, values) + ": " + what);
    }

    void obey(ModuleKind kind, const double* values) {
        const TurtleCommand& command = turtle_.commands_[kind];
        if (turtle_.rules_.inner && command.operation != TurtleOperation::nothing &&
            !obedient_.skips(command) &&
            std::any_of(values, values + command.read(), WordValues::is_word))
            fail(kind, values, "expected a number for the turtle, found a word");
        try {
            obedient_.obey(command, values);
        } catch (const TurtleRefusal& refusal) {
            if (refusal.is_unmatched && !top_values_)
                throw Error(turtle_.name_ + ", position " + std::to_string(position_) + ": " +
                            refusal.reason);
            fail(kind, values, refusal.reason);
        }
    }

    /// The rules that a module matches, if any.
    const Alternatives* matching(ModuleKind kind, const double* values) const {
        const Alternatives* found = nullptr;
        for (const Alternatives& next : turtle_.rules_.tables.front().of[kind]) {
            try {
                if (next.condition && next.condition->run(values) == 0) continue;
            } catch (const Undefined& undefined) {
                fail(kind, values, undefined.reason);
            }
            if (found)
                fail(kind, values,
                     "the interpretations at " + place(*found) + " and at " + place(next) +
                         " both apply, expected one");
            found = &next;
        }
        if (found && found->successors.size() > 1 && found->probabilities.empty())
            fail(kind, values,
                 "has two interpretations without probabilities, that at " + place(*found) +
                     " is one; expected one");
        return found;
    }
    std::string place(const Alternatives& alternatives) const {
        return to_string(turtle_.rules_.successors[alternatives.successors.front()].rule->place);
    }

    std::uint32_t pick(const Alternatives& alternatives) {
        const std::size_t count = alternatives.successors.size();
        if (count == 1) return alternatives.successors.front();
        const std::uint64_t number = draws_.at(choices_++);
        std::size_t i = 0;
        while (i + 1 < count && number >= alternatives.thresholds[i]) ++i;
        return alternatives.successors[i];
    }

    void interpret(ModuleKind kind, const double* values, std::size_t depth, const Budget& budget) {
        const Alternatives* const rules = matching(kind, values);
        if (!rules) return obey(kind, values);
        if (depth == deepest_interpretation)
            fail(kind, values,
                 "is interpreted again and again, " + std::to_string(deepest_interpretation) +
                     " times within itself, without an end");
        const Successor& successor = turtle_.rules_.successors[pick(*rules)];
        ModuleString spliced;
        if (rooms_.size() == depth) rooms_.emplace_back();
        try {
            if (!successor.splices.empty()) {
                append(successor, values, turtle_.rules_.kinds.words(), spliced);
            } else {
                rooms_[depth] = successor.values;
                for (const Successor::Slot& slot : successor.slots)
                    rooms_[depth][slot.at] = slot.value.run(values);
            }
        } catch (const Undefined& undefined) {
            fail(kind, values, undefined.reason);
        }
        const bool is_plain = successor.splices.empty();
        // Rooms stay where they are when there come more.
        const double* next = is_plain ? rooms_[depth].data() : spliced.values.data();
        const ModuleKind* const parts = is_plain ? successor.kinds.data() : spliced.kinds.data();
        const std::size_t count = is_plain ? successor.kinds.size() : spliced.kinds.size();
        for (const ModuleKind part : std::span(parts, count)) {
            if (++interpreted_ > longest_interpretation)
                fail(kind, values,
                     "its interpretation has more than " + std::to_string(longest_interpretation) +
                         " modules");
            if (interpreted_ % 65536 == 0) budget.check();
            if (turtle_.interpreted_[part])
                interpret(part, next, depth + 1, budget);
            else
                obey(part, next);
            next += turtle_.rules_.kinds.arity(part);
        }
    }

    const ModuleTurtle& turtle_;
    TurtleEvents& events_;
    Turtle obedient_;
    Draws draws_;
    std::size_t position_ = 0;
    std::vector<std::vector<double>> rooms_;  // parameters of interpretations, by depth
    std::uint64_t interpreted_ = 0, choices_ = 0;
    ModuleKind top_ = 0;
    const double* top_values_ = nullptr;  // of the module of the word that is interpreted
};

TurtleState ModuleTurtle::walk(const ModuleString& word, TurtleEvents& events,
                               const Budget& budget) const {
    return Walk(*this, events).all(word, budget);
}

}  // namespace algae
