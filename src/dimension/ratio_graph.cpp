#include "dimension/ratio_graph.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "dimension/constant_expression.hpp"
#include "dimension/length_multiple.hpp"
#include "dimension/parameter_meanings.hpp"

namespace algae {

namespace {

using Meaning = ParameterMeanings::Meaning;

/// Builds the graph from the axiom onward.
class Builder {
public:
    Builder(const LSystem& system, const Budget& budget)
        : system_(system), budget_(budget), meanings_(system) {
        check();
    }

    RatioGraph graph() {
        for (std::size_t at = 0; at < system_.axiom.letters.size(); ++at)
            if (auto found = part(system_.axiom, at, {})) out_.axiom.push_back(std::move(*found));
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            if (k % 64 == 0) budget_.check();
            expand(k);
        }
        find_what_matters();
        return std::move(out_);
    }

private:
    struct Key {
        Symbol symbol;
        std::size_t arity;
        std::vector<Rational> numbers;
        auto operator<=>(const Key&) const = default;
    };

    void check() const {
        const auto refuse = [](const std::string& reason) { throw Error(reason); };
        if (!system_.inner.empty()) refuse("there are systems within it");
        if (!system_.tables.empty()) refuse("it has tables");
        if (!system_.terminals.empty()) refuse("it has terminals");
        if (!system_.environments.empty()) refuse("it has an environment");
        if (!system_.interpretation.empty()) refuse("symbols are interpreted");
        if (!system_.axiom.splices.empty()) refuse("the axiom has a word spliced in");
        for (const Production& rule : system_.rules) {
            const std::string at =
                rule.place.line == 0 ? "a rule" : "the rule at " + to_string(rule.place);
            if (!rule.left.empty() || !rule.right.empty()) refuse(at + " has a context");
            if (!rule.elsewhere.empty()) refuse(at + " has a context condition");
            if (rule.probability && *rule.probability != Rational(1))
                refuse(at + " has a probability");
            if (!rule.successor.splices.empty()) refuse(at + " splices a word in");
            if (rule.shape) refuse(at + " is a shape rule");
        }
    }

    static const std::vector<Expression>& arguments_of(const ModuleWord& word, std::size_t at) {
        static const std::vector<Expression> none;
        const auto found = word.arguments.find(at);
        return found == word.arguments.end() ? none : found->second;
    }

    /// The module at a place of a word, or nothing if it has the length 0. Without a ratio where its
    /// length and that of the whole have nothing to do with each other.
    std::optional<RatioGraph::Part> part(const ModuleWord& word, std::size_t at,
                                         const ModuleValues& values) {
        const Symbol symbol = word.letters[at];
        const std::string& name = system_.alphabet.name(symbol);
        RatioGraph::Part found;
        if (name == "[" || name == "]") {
            found.is_fence = true;
            found.opens = name == "[";
            return found;
        }
        const std::vector<Expression>& arguments = arguments_of(word, at);
        Key key{symbol, arguments.size(), {}};
        std::optional<LengthMultiple> length;
        for (std::size_t k = 0; k < arguments.size(); ++k) {
            const Meaning meaning = meanings_.of(symbol, arguments.size(), k);
            if (meaning == Meaning::number)
                key.numbers.push_back(exact_number(arguments[k], values, system_));
            if (meaning != Meaning::length) continue;
            if (length) throw Error("two parameters of " + name + " are lengths");
            length = multiple_of(arguments[k], values, system_);
        }
        if (length && rational_value(length->factor) == Rational(0)) return std::nullopt;
        found.state = state(key);
        found.ratio = length ? length->factor : unit_;
        const bool comes_from_length = length && length->of_length;
        if (values.length.has_value() != comes_from_length) strangers_.push_back(found.state);
        return found;
    }

    std::size_t state(const Key& key) {
        const auto [place, is_new] = numbers_.try_emplace(key, keys_.size());
        if (!is_new) return place->second;
        if (keys_.size() == RatioGraph::most_states)
            throw BoundReached(
                Bound::method,
                "modules have more than " + std::to_string(RatioGraph::most_states) +
                    " different values of parameters that conditions or turns depend on");
        keys_.push_back(key);
        out_.states.push_back(described(key));
        return place->second;
    }

    RatioGraph::State described(const Key& key) const {
        RatioGraph::State state;
        const std::string& name = system_.alphabet.name(key.symbol);
        state.name = name;
        std::string parameters;
        for (std::size_t k = 0, n = 0; k < key.arity; ++k) {
            const bool is_number = meanings_.of(key.symbol, key.arity, k) == Meaning::number;
            parameters += (k > 0 ? "," : "");
            parameters += is_number ? shortest_text(key.numbers[n++]) : "*";
        }
        if (key.arity > 0) state.name += "(" + parameters + ")";
        const auto has = [&](const auto& list, const auto& is) {
            return std::any_of(list.begin(), list.end(), is);
        };
        const Settings& settings = system_.settings;
        if (has(settings.plotters, [&](Symbol a) { return a == key.symbol; }))
            throw Error("the symbol " + name + " draws to points that it names");
        if (has(settings.stamps, [&](const auto& stamp) { return stamp.symbol == key.symbol; }))
            throw Error("the symbol " + name + " stamps a shape");
        const Step step = step_of(system_.alphabet, key.symbol);
        state.draws = step == Step::draw;
        state.moves = step != Step::none;
        if (name.size() != 1) return state;
        if (std::string("&^\\/$@").find(name) != std::string::npos)
            throw Error("the symbol " + name + " makes a figure in space");
        if (name == "*" && (key.arity > 0 || settings.scale))
            throw Error("the symbol * changes the turtle's step");
        if (name == "%") throw Error("the symbol % leaves branches out");
        if (name == "|") state.degrees = 180;
        if (name == "+" || name == "-") {
            if (key.arity == 0 && settings.angle && !settings.angle->exact)
                throw Error("the angle is no rational number of degrees");
            state.degrees = key.arity > 0    ? key.numbers[0]
                            : settings.angle ? *settings.angle->exact
                                             : Rational(90);
            if ((name == "-") != settings.clockwise) state.degrees = -state.degrees;
        }
        return state;
    }

    /// The rule for a state's modules, and what its parameters are.
    const Production* rule_for(const Key& key, ModuleValues& values) const {
        const Production* chosen = nullptr;
        for (const Production& rule : system_.rules) {
            const auto& parameters = rule.predecessor.parameters;
            if (rule.predecessor.symbol != key.symbol || parameters.size() != key.arity) continue;
            ModuleValues own;
            for (std::size_t k = 0, n = 0; k < key.arity; ++k) {
                const Meaning meaning = meanings_.of(key.symbol, key.arity, k);
                if (meaning == Meaning::number) own.numbers[parameters[k]] = key.numbers[n++];
                if (meaning == Meaning::length) own.length = parameters[k];
            }
            if (rule.condition && exact_number(*rule.condition, own, system_).is_zero()) continue;
            if (chosen && chosen->condition == rule.condition)
                throw Error("there are several rules for " + system_.alphabet.name(key.symbol));
            if (chosen) continue;
            chosen = &rule;
            values = std::move(own);
        }
        return chosen;
    }

    void expand(std::size_t k) {
        const Key key = keys_[k];
        ModuleValues values;
        const Production* rule = rule_for(key, values);
        if (!rule) {
            out_.states[k].parts.push_back({false, false, k, unit_});
            return;
        }
        strangers_.clear();
        std::size_t depth = 0;
        std::vector<RatioGraph::Part> parts;
        for (std::size_t at = 0; at < rule->successor.letters.size(); ++at) {
            auto found = part(rule->successor, at, values);
            if (!found) continue;
            if (found->is_fence && found->opens) ++depth;
            if (found->is_fence && !found->opens && depth-- == 0)
                throw Error("brackets do not match within every successor");
            parts.push_back(std::move(*found));
        }
        if (depth != 0) throw Error("brackets do not match within every successor");
        out_.states[k].parts = std::move(parts);
        for (const std::size_t stranger : strangers_) unrelated_.emplace_back(k, stranger);
    }

    void find_what_matters() {
        auto& states = out_.states;
        for (auto& state : states) state.matters = state.moves;
        for (bool changed = true; changed;) {
            changed = false;
            for (auto& state : states)
                for (const auto& part : state.parts)
                    if (!state.matters && !part.is_fence && states[part.state].matters)
                        state.matters = changed = true;
        }
        for (const auto& [whole, part] : unrelated_)
            if (states[part].matters)
                throw Error("the length of " + states[part].name + " in the successor of " +
                            states[whole].name + " is no multiple of its length");
    }

    const LSystem& system_;
    const Budget& budget_;
    ParameterMeanings meanings_;
    Expression unit_ = quantity(Rational(1)).expression;
    RatioGraph out_;
    std::vector<Key> keys_;
    std::map<Key, std::size_t> numbers_;
    std::vector<std::size_t> strangers_;
    std::vector<std::pair<std::size_t, std::size_t>> unrelated_;
};

}  // namespace

RatioGraph ratio_graph(const LSystem& system, const Budget& budget) {
    return Builder(system, budget).graph();
}

std::vector<bool> lasting(const RatioGraph& graph, const std::vector<bool>& holds) {
    const auto any_part = [&](std::size_t k, const std::vector<bool>& of) {
        return std::any_of(graph.states[k].parts.begin(), graph.states[k].parts.end(),
                           [&](const auto& part) { return !part.is_fence && of[part.state]; });
    };
    std::vector<bool> leads = holds;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t k = 0; k < leads.size(); ++k)
            if (!leads[k] && any_part(k, leads)) leads[k] = changed = true;
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t k = 0; k < leads.size(); ++k)
            if (leads[k] && !any_part(k, leads)) {
                leads[k] = false;
                changed = true;
            }
    }
    return leads;
}

}  // namespace algae
