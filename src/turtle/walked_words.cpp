#include "turtle/detail/environments.hpp"

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

}  // namespace algae
