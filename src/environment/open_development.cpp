#include "environment/open_development.hpp"

#include <utility>

#include "system/classes.hpp"
#include "turtle/module_turtle.hpp"

namespace algae {

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

Traversal traversal_of(const LSystem& system, const ModuleKinds& kinds, const ModuleString& word,
               std::uint64_t generation, std::uint64_t seed, const Budget& budget) {
    Traversal course;
    course.generation = generation;
    const std::vector<std::string> names = communication_names(system, kinds);
    SceneWriter writer(kinds, names, word, course, budget);
    ModuleTurtle(system, kinds, generation, seed).walk(word, writer, budget);
    return course;
}

OpenDevelopment::OpenDevelopment(const LSystem& system, const RewritingChoices& choices,
                                 std::shared_ptr<Environment> external, const Budget& budget)
    : rewriting_(system, choices, budget),
      environments_(system, std::move(external)),
      seed_(choices.seed),
      is_open_(class_of(system).open),
      word_(rewriting_.axiom()) {
    fill(budget);
}

void OpenDevelopment::go_to(std::uint64_t n, const std::vector<std::size_t>& tables,
                            const Budget& budget) {
    while (generation_ < n) {
        budget.check();
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
    const Traversal course = traversal_of(*rules.system, rules.kinds, word_, generation_, seed_, budget);
    const auto answers = environments_.answers(course, budget);
    std::size_t module = 0, offset = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        for (; module < course.queries[i].module; ++module)
            offset += rules.kinds.arity(word_.kinds[module]);
        for (std::size_t k = 0; k < answers[i].size(); ++k)
            word_.values[offset + k] = answers[i][k] + 0.0;  // no negative zero
    }
}

}  // namespace algae
