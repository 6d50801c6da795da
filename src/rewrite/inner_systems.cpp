#include "rewrite/inner_systems.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "rewrite/module_text.hpp"

namespace algae {

struct InnerSystems::Step {
    Step(InnerSystems& systems, std::size_t system, std::size_t generation) : all(systems) {
        all.steps_.emplace_back(system, generation);
    }
    ~Step() { all.steps_.pop_back(); }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

    InnerSystems& all;
};

std::optional<std::size_t> InnerSystems::find(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
}

void InnerSystems::add(Rewriting rewriting, Successor axiom) {
    rewritings_.push_back(std::move(rewriting));
    axioms_.push_back(std::move(axiom));
}

std::string InnerSystems::circle(std::size_t system, std::size_t generation) const {
    const auto first = std::find_if(steps_.begin(), steps_.end(),
                                    [&](const auto& step) { return step.first == system; });
    std::string text = "words need each other in a circle: " + name(first->first, first->second);
    for (auto step = std::next(first); step != steps_.end(); ++step)
        text += " needs " + name(step->first, step->second) + ", which";
    text += " needs " + name(system, generation);
    if (generation != first->second) text += ", which needs " + name(first->first, first->second);
    return text;
}

void InnerSystems::derive_next(std::size_t system) {
    auto& known = known_[system];
    const std::size_t generation = known.size();
    const Step step(*this, system, generation);
    ModuleString word;
    if (generation > 0) {
        word = rewritings_[system].next(words_->word(known.back()), generation - 1, 0, budget_);
    } else {
        try {
            append(axioms_[system], nullptr, words_.get(), word);
        } catch (const Undefined& undefined) {
            throw Error(to_string(undefined.at->place) + ": the axiom of " + names_[system] + ": " +
                        undefined.reason);
        }
    }
    known.push_back(value(std::move(word)));
    budget_.check_memory(known.size() * sizeof(double), "the generations of a system within");
}

double InnerSystems::word(std::size_t system, double generation, const Expression& at) {
    if (generation < 0 || generation != std::floor(generation) || generation > 1e15)
        throw Undefined{&at, "expected a generation from 0 on in '" + to_text(at) + "', found " +
                                 number_text(generation)};
    const auto wanted = static_cast<std::size_t>(generation);
    auto& known = known_[system];
    const bool is_busy = std::any_of(steps_.begin(), steps_.end(),
                                     [&](const auto& step) { return step.first == system; });
    if (wanted >= known.size() && is_busy) throw Undefined{&at, circle(system, wanted)};
    while (wanted >= known.size()) {
        budget_.check();
        derive_next(system);
        // A word that is its own successor stays.
        const std::size_t last = known.size() - 1;
        if (last > 0 && same_value(known[last], known[last - 1])) return known[last];
    }
    return known[wanted];
}

}  // namespace algae
