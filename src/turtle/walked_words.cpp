#include "turtle/detail/environments.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "model/model.hpp"
#include "turtle/detail/module_turtle.hpp"
#include "turtle/detail/plane_figure.hpp"
#include "watch/watch.hpp"

// The words that a turtle walks over: derived with the choices that somebody made, and filled by the
// environment where the system is open.
//
// An open L-system (Mech and Prusinkiewicz 1996) is not a rewriting system alone: between two steps the
// turtle walks the word, and each communication module gets its parameters from what is around the turtle
// there. So a step is: walk (traversal_of writes down segments and queries), ask (Environments), fill the
// parameters, rewrite. Kinds of modules are those of the rules, so filling changes values in place.
//
// Parameters are exact while a word is short, for a condition such as x = 0 must not hold of what is only nearly 0: a figure
// would show modules that no derivation has. Long words keep doubles, which derive ten times as fast, and the result says so.
// Which of both is found by trying: exact first, and from the axiom again with doubles where a bound of work is reached, which
// is so small that nobody waits for it.

namespace algae {

namespace {

void check_tables(const FigureChoices& choices, std::uint64_t n) {
    if (!choices.tables.empty() && choices.tables.size() < n)
        throw Error("expected a table for each of " + std::to_string(n) + " steps, found " +
                    std::to_string(choices.tables.size()));
}

/// Why a system with tables is refused when nobody says which.
std::string open_tables(const LSystem& system) {
    return "it has " + std::to_string(system.tables.size()) +
           " tables, and neither their sequence nor a seed is given";
}

RewritingChoices rewriting_choices(const LSystem& system, const FigureChoices& choices) {
    RewritingChoices out;
    out.seed = choices.seed.value_or(1);
    out.evenly = choices.seed && !class_of(system).stochastic;
    out.random_tables = choices.random_tables;
    return out;
}

}  // namespace

void check_choices(const LSystem& system, std::uint64_t n, const FigureChoices& choices) {
    const auto refuse = [&](const std::string& reason) {
        throw Error("cannot draw " + (system.name.empty() ? "the system" : system.name) + ": " +
                    reason);
    };
    const Class kind = class_of(system);
    if (kind.shape) refuse("it has shape rules, which make boxes and not words for a turtle");
    if (kind.open) refuse("it has communication modules, and there is no environment to fill them");
    check_tables(choices, n);
    if (choices.seed || !choices.tables.empty()) return;
    if (leaves_tables_open(system)) refuse(open_tables(system));
    if (as_ol(system) && !as_d0l(system)) refuse(as_d0l(system).reason());
}

namespace {

// Of exact parameters in figures. Both bounds are reached in a few milliseconds.
constexpr std::uint64_t most_modules = 20'000, most_work = 2'000;

/// The word with exact parameters, rounded at its end; nothing where that costs too much or an enclosure decides nothing, and
/// `reason` says which.
std::optional<DerivedModules> exact_modules(const LSystem& system, std::uint64_t n,
                                            RewritingChoices chosen,
                                            const std::vector<std::size_t>& tables,
                                            const Budget& budget, std::string& reason) {
    chosen.arithmetic = Arithmetic::exact;
    bool is_least = false;  // the bound of letters is that of exact parameters, not the caller's
    try {
        const Rewriting rewriting(system, chosen, budget);
        rewriting.rules().kinds.held()->set_most_work(most_work);
        ModuleString word = rewriting.axiom();
        std::uint64_t modules = word.kinds.size();
        for (std::uint64_t generation = 0; generation < n; ++generation) {
            budget.check();
            Budget rest = budget;
            const std::uint64_t left = modules < most_modules ? most_modules - modules : 0;
            is_least = left < budget.letters;
            if (is_least) rest.letters = left;
            const std::size_t table =
                tables.empty() ? rewriting.own_table(generation) : tables.at(generation);
            word = rewriting.next(word, generation, table, rest);
            modules += word.kinds.size() + 1;  // words without modules are counted too
        }
        DerivedModules out{rewriting.rules().kinds, std::move(word), chosen.seed, {}};
        if (round_numbers(out.kinds, out.word)) return out;
        reason = "a number is too large for a double";
    } catch (const UndecidedValue& undecided) {
        reason = undecided.what();
    } catch (const BoundReached& bound) {
        if (bound.bound() == Bound::letters && is_least)
            reason = "the words up to it have more than " + std::to_string(most_modules) +
                     " modules together";
        else if (bound.bound() == Bound::method || bound.bound() == Bound::memory)
            reason = bound.what();
        else
            throw;
    }
    return std::nullopt;
}

}  // namespace

DerivedModules derived_modules(const LSystem& system, std::uint64_t n, const FigureChoices& choices,
                               const Budget& budget) {
    check_choices(system, n, choices);
    const RewritingChoices chosen = rewriting_choices(system, choices);
    std::string reason;
    if (class_of(system).parametric)
        if (auto exact = exact_modules(system, n, chosen, choices.tables, budget, reason))
            return *std::move(exact);
    const Rewriting rewriting(system, chosen, budget);
    ModuleString word = derive(rewriting, n, choices.tables, budget);
    return {rewriting.rules().kinds, std::move(word), chosen.seed, std::move(reason)};
}

namespace {

/// Writes down what a turtle draws, and its state before the communication modules.
class SceneWriter : public TurtleEvents {
public:
    SceneWriter(const ModuleKinds& kinds, const std::vector<std::string>& names,
                const ModuleString& word, Traversal& course, const Budget& budget)
        : kinds_(kinds), names_(names), word_(word), course_(course), budget_(budget) {}

    bool wants_modules() const override { return true; }

    void before(std::size_t module, const TurtleState& state) override {
        module_ = module;
        const ModuleKind kind = word_.kinds[module];
        const double* const values = word_.values.data() + offset_;
        offset_ += kinds_.arity(kind);
        if (names_[kind].empty()) return;
        course_.queries.push_back({names_[kind],
                                   module,
                                   {values, values + kinds_.arity(kind)},
                                   state.position,
                                   state.attitude});
    }

    void stroke(const Vector& from, const TurtleState& state) override {
        if (from == state.position) return;
        course_.segments.push_back({from, state.position, module_});
        if (course_.segments.size() % 4096 == 0)
            budget_.check_memory(course_.segments.capacity() * sizeof(Segment),
                                 "what an environment sees");
    }

private:
    const ModuleKinds& kinds_;
    const std::vector<std::string>& names_;
    const ModuleString& word_;
    Traversal& course_;
    const Budget& budget_;
    std::size_t module_ = 0, offset_ = 0;
};

/// By kind, the names of those that communicate, "" for the others.
std::vector<std::string> communication_names(const LSystem& system, const ModuleKinds& kinds) {
    std::vector<std::string> names;
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        const std::string& name = system.alphabet.name(kinds.letter(static_cast<ModuleKind>(kind)));
        names.push_back(is_communication(name) ? name : "");
    }
    return names;
}

}  // namespace

Traversal traversal_of(const Model& system, const ModuleKinds& kinds, const ModuleString& word,
                       std::uint64_t generation, std::uint64_t seed, const Budget& budget) {
    Traversal course;
    course.generation = generation;
    const std::vector<std::string> names = communication_names(system, kinds);
    SceneWriter writer(kinds, names, word, course, budget);
    ModuleTurtle(system, kinds, generation, seed).walk(word, writer, budget);
    return course;
}

OpenDevelopment::OpenDevelopment(const Model& system, const RewritingChoices& choices,
                                 std::shared_ptr<Environment> external, const Budget& budget)
    : system_(std::make_shared<const Model>(system)),
      rewriting_(system, choices, budget),
      environments_(std::make_shared<Environments>(system, std::move(external))),
      seed_(choices.seed),
      is_open_(class_of(system).open),
      word_(rewriting_.axiom()) {
    fill(budget);
}

void OpenDevelopment::go_to(std::uint64_t n, const std::vector<std::size_t>& tables,
                            const Budget& budget) {
    WorkCount generations("generation", n);
    while (generation_ < n) {
        budget.check();
        generations.at(generation_ + 1);
        const std::size_t table =
            tables.empty() ? rewriting_.own_table(generation_) : tables.at(generation_);
        word_ = rewriting_.next(word_, generation_, table, budget);
        ++generation_;
        fill(budget);
    }
}

void OpenDevelopment::fill(const Budget& budget) {
    if (!is_open_) return;
    const CompiledRules& rules = rewriting_.rules();
    const Traversal course = traversal_of(*system_, rules.kinds, word_, generation_, seed_, budget);
    const auto answers = environments_->answers(course, budget);
    std::size_t module = 0, offset = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        for (; module < course.queries[i].module; ++module)
            offset += rules.kinds.arity(word_.kinds[module]);
        for (std::size_t k = 0; k < answers[i].size(); ++k)
            word_.values[offset + k] = answers[i][k] + 0.0;  // no negative zero
    }
}

DerivedModules open_modules(const Model& system, std::uint64_t n, const FigureChoices& choices,
                            std::shared_ptr<Environment> external, const Budget& budget) {
    if (!class_of(system).open) return derived_modules(system, n, choices, budget);
    if (leaves_tables_open(system) && !choices.seed && choices.tables.empty())
        throw Error(open_tables(system));
    check_tables(choices, n);
    const RewritingChoices chosen = rewriting_choices(system, choices);
    OpenDevelopment development(system, chosen, std::move(external), budget);
    development.go_to(n, choices.tables, budget);
    return {development.rules().kinds, development.word(), chosen.seed,
            class_of(system).parametric ? "an environment measures a figure" : ""};
}

// --- Between two generations ---

struct ContinuousDevelopment::Way {
    /// What holds of a module of the later word.
    struct Part {
        double begin = 0;     // of the lengths it goes, what they are at the share 0, as a factor
        double size = 0;      // likewise of what it leaves where it stands
        bool turns = false;   // its turns outside brackets begin at 0
        bool joined = false;  // it is of the same module of the earlier word as the part before it
        std::size_t values = 0;            // where its parameters are
        std::optional<std::size_t> older;  // where those of its earlier self are
    };

    Way(const Model& system, const ModuleKinds& kinds, std::uint64_t next, std::uint64_t seed)
        : turtle(system, kinds, next, seed), kinds(kinds), commands(system) {
        commands.interpretation.clear();
        for (const char* const needed : {"+", "*"}) commands.alphabet.symbol(needed);
    }

    ModuleTurtle turtle;  // of the later generation
    ModuleKinds kinds;
    Model commands;  // the system without interpretation
    ModuleString earlier, later;
    std::vector<Part> parts;  // by module of the later word
    double spin = 0;          // degrees that the later figure is turned by
};

namespace {

/// Goes through commands and knows how many brackets are open.
class CommandWalk {
public:
    CommandWalk(const ModuleTurtle& turtle, const ModuleString& word)
        : turtle_(turtle), word_(word), values_(word.values.data()) {}

    const TurtleCommand& command() const { return turtle_.command(kind()); }
    ModuleKind kind() const { return word_.kinds[at_]; }
    const double* values() const { return values_; }
    std::size_t depth() const { return depth_; }

    void begin() { depth_ = 0; }
    void next() {
        if (command().operation == TurtleOperation::push) ++depth_;
        if (command().operation == TurtleOperation::pop && depth_ > 0) --depth_;
        values_ += turtle_.kinds().arity(kind());
        ++at_;
    }

    /// How many steps the turtle goes by the next `count` commands outside brackets; goes past them.
    double way(std::size_t count) {
        double steps = 0;
        for (; count > 0; --count, next()) {
            using enum TurtleOperation;
            const TurtleOperation operation = command().operation;
            if (depth_ > 0 ||
                (operation != draw && operation != draw_unmarked && operation != move))
                continue;
            const double amount = command().parameters > 0 ? *values_ : 1;
            if (!WordValues::is_held(amount)) steps += std::fabs(amount);
        }
        return steps;
    }

private:
    const ModuleTurtle& turtle_;
    const ModuleString& word_;
    const double* values_;
    std::size_t at_ = 0, depth_ = 0;
};

std::vector<std::size_t> offsets_of(const ModuleKinds& kinds, const ModuleString& word) {
    std::vector<std::size_t> offsets;
    std::size_t at = 0;
    for (const ModuleKind kind : word.kinds) {
        offsets.push_back(at);
        at += kinds.arity(kind);
    }
    return offsets;
}

bool same_modules(const ModuleKinds& kinds, const ModuleString& a, std::size_t at_a,
                  std::size_t values_a, const ModuleString& b, std::size_t at_b,
                  std::size_t values_b) {
    const auto from = [](const ModuleString& word, std::size_t offset) {
        return word.values.begin() + static_cast<std::ptrdiff_t>(offset);
    };
    return a.kinds[at_a] == b.kinds[at_b] &&
           std::equal(from(a, values_a), from(a, values_a + kinds.arity(a.kinds[at_a])),
                      from(b, values_b), same_value);
}

}  // namespace

ContinuousDevelopment::~ContinuousDevelopment() = default;

const Model& ContinuousDevelopment::system() const { return way_->commands; }

ContinuousDevelopment::ContinuousDevelopment(const Model& system, std::uint64_t n,
                                             const FigureChoices& choices, const Budget& budget) {
    if (class_of(system).open)
        throw Error(
            "cannot grow " + (system.name.empty() ? "the system" : system.name) +
            " between generations: it has communication modules, which are asked once in each");
    check_choices(system, n + 1, choices);
    const RewritingChoices chosen = rewriting_choices(system, choices);
    const Rewriting rewriting(system, chosen, budget);
    ModuleString earlier = derive(rewriting, n, choices.tables, budget);
    TracedStep step = rewriting.traced(
        earlier, n, choices.tables.empty() ? rewriting.own_table(n) : choices.tables.at(n), budget);
    const ModuleKinds& kinds = rewriting.rules().kinds;
    auto way = std::make_unique<Way>(system, kinds, n + 1, chosen.seed);
    way->earlier = std::move(earlier);
    way->later = std::move(step.word);

    const ModuleTurtle before(system, kinds, n, chosen.seed);
    const double shrunk = before.start().step / way->turtle.start().step;
    way->spin = system.drawing.spin ? system.drawing.spin->value : 0;
    std::vector<std::uint32_t> old_counts, new_counts;
    const ModuleString old_commands = before.interpreted(way->earlier, old_counts, budget),
                       new_commands = way->turtle.interpreted(way->later, new_counts, budget);
    const auto old_offsets = offsets_of(kinds, way->earlier),
               new_offsets = offsets_of(kinds, way->later);
    CommandWalk old_way(before, old_commands), new_way(way->turtle, new_commands);
    way->parts.resize(way->later.kinds.size());
    std::size_t first = 0;  // of the successor
    for (std::size_t m = 0; m < way->earlier.kinds.size(); ++m) {
        if (m % 65536 == 0) budget.check();
        const std::size_t end = first + step.lengths[m];
        old_way.begin();
        const double was = old_way.way(old_counts[m]);
        // The letter itself, if it stands outside brackets once.
        std::size_t own = end;
        bool is_once = true;
        double is = 0;
        new_way.begin();
        for (std::size_t i = first; i < end; ++i) {
            if (new_way.depth() == 0 && way->later.kinds[i] == way->earlier.kinds[m]) {
                is_once = own == end;
                own = i;
            }
            is += new_way.way(new_counts[i]);
        }
        const bool goes_on = own < end && is_once;
        const bool stays = goes_on && end == first + 1 &&
                           same_modules(kinds, way->earlier, m, old_offsets[m], way->later, first,
                                        new_offsets[first]);
        for (std::size_t i = first; i < end; ++i) {
            Way::Part& part = way->parts[i];
            part.joined = i > first;
            part.values = new_offsets[i];
            if (goes_on && i == own) {
                part.begin = part.size = shrunk;
                if (!stays) part.older = old_offsets[m];
            } else {
                part.begin = goes_on || !(is > 0) ? 0 : shrunk * was / is;
                part.turns = true;
            }
        }
        first = end;
    }
    way_ = std::move(way);
}

DerivedModules ContinuousDevelopment::at(double share, const Budget& budget) const {
    const Way& way = *way_;
    ModuleString word = way.later;
    for (std::size_t i = 0; i < way.parts.size(); ++i) {
        const auto& older = way.parts[i].older;
        if (!older) continue;
        for (std::size_t k = 0; k < way.kinds.arity(word.kinds[i]); ++k) {
            double& value = word.values[way.parts[i].values + k];
            const double old = way.earlier.values[*older + k];
            if (WordValues::is_held(value) || WordValues::is_held(old)) continue;
            if (value != old) value = (1 - share) * old + share * value;
        }
    }
    std::vector<std::uint32_t> counts;
    const ModuleString commands = way.turtle.interpreted(word, counts, budget);
    DerivedModules out;
    out.kinds = way.turtle.kinds();
    const auto symbol = [&](const char* name) { return *way.commands.alphabet.find(name); };
    const auto add = [&](ModuleKind kind, const double* values) {
        out.word.kinds.push_back(kind);
        out.word.values.insert(out.word.values.end(), values, values + out.kinds.arity(kind));
    };
    /// The module with another first parameter.
    const auto add_amount = [&](ModuleKind kind, const double* values, double amount) {
        const std::size_t arity = out.kinds.arity(kind);
        out.word.kinds.push_back(arity > 0 ? kind
                                           : out.kinds.kind(way.turtle.kinds().letter(kind), 1));
        out.word.values.push_back(amount);
        if (arity > 1) out.word.values.insert(out.word.values.end(), values + 1, values + arity);
    };
    const auto add_one = [&](const char* name, double amount) {
        add(out.kinds.kind(symbol(name), 1), &amount);
    };
    const TurtleManner& manner = way.turtle.manner();
    const double angle = manner.clockwise ? -manner.angle : manner.angle;
    if (way.spin != 0 && share < 1)
        add_one("+", (manner.clockwise ? 1 : -1) * way.spin * (1 - share));
    CommandWalk course(way.turtle, commands);
    for (std::size_t i = 0; i < way.parts.size(); ++i) {
        if (i % 65536 == 0) budget.check();
        const Way::Part& part = way.parts[i];
        if (!part.joined) course.begin();
        for (std::uint32_t k = 0; k < counts[i]; ++k, course.next()) {
            using enum TurtleOperation;
            const TurtleCommand& command = course.command();
            const double* const values = course.values();
            const double given = command.parameters > 0 ? *values : 0;
            // What opens inside brackets is new, whatever it stands in.
            const bool is_branch = part.turns && course.depth() > 0;
            const double length = (is_branch ? 0 : (1 - share) * part.begin) + share,
                         size = (1 - share) * part.size + share;
            const bool is_turn = command.operation == left || command.operation == right ||
                                 command.operation == down || command.operation == up ||
                                 command.operation == roll_left || command.operation == roll_right;
            const bool leaves = command.operation == stamp || command.operation == surface ||
                                (command.operation == solid && !command.solid->is_rotation());
            if (command.operation == nothing) continue;
            if (WordValues::is_held(given)) {
                add(course.kind(), values);
            } else if (command.operation == draw || command.operation == draw_unmarked ||
                       command.operation == move) {
                if (length == 1)
                    add(course.kind(), values);
                else
                    add_amount(course.kind(), values,
                               length * (command.parameters > 0 ? given : 1));
            } else if (part.turns && !is_branch && share < 1 && is_turn) {
                add_amount(course.kind(), values, share * (command.parameters > 0 ? given : angle));
            } else if (part.turns && !is_branch && share < 1 && command.operation == back) {
                add_one("+", 180 * share);
            } else if (leaves && size != 1) {
                const double factor = std::max(size, 1e-9);  // that the step can be divided by
                add_one("*", factor);
                add(course.kind(), values);
                add_one("*", 1 / factor);
            } else {
                add(course.kind(), values);
            }
        }
        if (out.word.kinds.size() > budget.letters)
            throw BoundReached(Bound::letters, way.turtle.name() + " is drawn by more than " +
                                                   std::to_string(budget.letters) + " commands");
    }
    return out;
}

}  // namespace algae
