#include "system/s0l.hpp"

#include "system/ol.hpp"

namespace algae {

View<S0L> as_s0l(const LSystem& system) {
    const auto refused = [](const std::string& reason) {
        return View<S0L>::refused("not a stochastic 0L system: " + reason);
    };
    if (std::string reason = beyond_ol(system, false); !reason.empty()) return refused(reason);
    S0L out;
    out.alphabet = std::make_shared<const Alphabet>(system.alphabet);
    out.axiom = system.axiom.letters;
    out.name = system.name;
    out.alternatives.resize(out.alphabet->size());
    for (const Production& rule : system.rules) {
        auto& known = out.alternatives[rule.predecessor.symbol];
        if (!rule.probability && !known.empty()) {
            if (known.size() == 1 && known.front().first == rule.successor.letters) continue;
            return refused(system.alphabet.name(rule.predecessor.symbol) +
                           " has several rules without probabilities");
        }
        known.emplace_back(rule.successor.letters, rule.probability.value_or(Rational(1)));
    }
    for (Symbol a = 0; a < out.alternatives.size(); ++a) {
        auto& known = out.alternatives[a];
        if (known.empty()) known.emplace_back(Word{a}, Rational(1));
        Rational sum;
        for (const auto& [word, probability] : known) sum += probability;
        if (sum != 1)
            return refused("the probabilities of " + system.alphabet.name(a) + " add up to " +
                           to_string(sum) + ", expected 1");
    }
    return out;
}

}  // namespace algae
