#include <algorithm>
#include <compare>
#include <set>
#include <tuple>

#include "dimension/detail/ratio_graph.hpp"
#include "dimension/detail/recurrent_set.hpp"
#include "model/model.hpp"

// What becomes of lengths in a parametric system: is every module a scaled copy of one of finitely
// many?
//
// The exact dimension needs parts that are similar to the whole. In a parametric system this holds
// where each kind of module has one parameter that is its length, rules multiply lengths by
// constants, and everything that conditions and turns depend on takes finitely many values. The
// plan:
//
// 1. `ParameterMeanings` works backward from what the turtle does. Arguments of turns, and
//    parameters in conditions, are numbers, and so is what they are computed from; first arguments
//    of steps are lengths, and so is what they are computed from; other parameters do not matter. A
//    length that decides what becomes of its module is refused.
// 2. `multiple_of` computes an expression as a number or as a constant times the length of the
//    module that is rewritten.
// 3. `Builder` explores the states from the axiom: a state is a symbol with the values of its
//    numbers. An argument without relation to the length of the whole is allowed only where no
//    turtle ever steps from it.
// 4. Where all ratios are the same, `with_equal_lengths` writes the D0L system that draws the same
//    figures with unit steps, whose dimension `exact_dimension` finds by the recurrent set; turns
//    become powers of one common angle.

namespace algae {

namespace {

/// Whether a symbol makes the turtle step, and whether it draws then.
enum class Step : unsigned char { none, draw, move };

void collect_names(const Expression& expression, std::set<std::string>& into) {
    if (expression.kind == Expression::Kind::name) into.insert(expression.name);
    for (const Expression& operand : expression.operands) collect_names(operand, into);
}

Step step_of(const Alphabet& alphabet, Symbol symbol) {
    const std::string& name = alphabet.name(symbol);
    if (name == "F" || name == "G" || name.starts_with("F_")) return Step::draw;
    if (name == "f" || name.starts_with("f_")) return Step::move;
    return Step::none;
}

/// What the parameters of a system's modules are to the way of its turtle. Backward from what the
/// turtle does: what conditions and turns depend on are numbers, what lengths of steps depend on
/// are lengths, and everything else (widths, colours, ages that nobody asks for) is of no account.
/// What is both is a number.
class ParameterMeanings {
public:
    enum class Meaning : unsigned char { none, length, number };

    /// Throws Error where the length of a step stands in a condition or turns something.
    explicit ParameterMeanings(const LSystem& system) {
        const auto visit = [&](const ModuleWord& word, const auto& see) {
            for (const auto& [at, arguments] : word.arguments)
                see(word.letters[at], arguments.size());
        };
        const auto visit_all = [&](const auto& see) {
            visit(system.axiom, see);
            for (const Production& rule : system.rules) {
                visit(rule.successor, see);
                if (!rule.predecessor.parameters.empty())
                    see(rule.predecessor.symbol, rule.predecessor.parameters.size());
            }
        };
        visit_all([&](Symbol symbol, std::size_t arity) {
            const std::string& name = system.alphabet.name(symbol);
            if (name == "+" || name == "-") meanings_[{symbol, arity, 0}] = Meaning::number;
        });
        for (const Production& rule : system.rules) {
            if (!rule.condition) continue;
            std::set<std::string> names;
            collect_names(*rule.condition, names);
            const auto& parameters = rule.predecessor.parameters;
            for (std::size_t k = 0; k < parameters.size(); ++k)
                if (names.contains(parameters[k]))
                    meanings_[{rule.predecessor.symbol, parameters.size(), k}] = Meaning::number;
        }
        spread(system, Meaning::number);
        visit_all([&](Symbol symbol, std::size_t arity) {
            if (step_of(system.alphabet, symbol) == Step::none) return;
            Meaning& meaning = meanings_[{symbol, arity, 0}];
            if (meaning == Meaning::number)
                throw Error("the length of " + system.alphabet.name(symbol) +
                            " decides what comes of it, so parts are not similar to the whole");
            meaning = Meaning::length;
        });
        spread(system, Meaning::length);
    }

    /// Of a parameter of modules with this symbol and so many parameters.
    Meaning of(Symbol symbol, std::size_t arity, std::size_t place) const {
        const auto found = meanings_.find({symbol, arity, place});
        return found == meanings_.end() ? Meaning::none : found->second;
    }

private:
    struct Slot {
        Symbol symbol;
        std::size_t arity, place;
        auto operator<=>(const Slot&) const = default;
    };
    void spread(const LSystem& system, Meaning meaning) {
        for (bool changed = true; changed;) {
            changed = false;
            for (const Production& rule : system.rules) {
                const auto& parameters = rule.predecessor.parameters;
                std::set<std::string> names;
                for (const auto& [at, arguments] : rule.successor.arguments)
                    for (std::size_t k = 0; k < arguments.size(); ++k)
                        if (of(rule.successor.letters[at], arguments.size(), k) == meaning)
                            collect_names(arguments[k], names);
                for (std::size_t k = 0; k < parameters.size(); ++k) {
                    if (!names.contains(parameters[k])) continue;
                    Meaning& own = meanings_[{rule.predecessor.symbol, parameters.size(), k}];
                    if (own != Meaning::none) continue;
                    own = meaning;
                    changed = true;
                }
            }
        }
    }

    std::map<Slot, Meaning> meanings_;
};

/// What the parameters of a module are, as far as they matter to a turtle's way.
struct ModuleValues {
    std::optional<std::string> length;  // the name of the one that is a length
    std::map<std::string, Rational> numbers;
};

/// A number, or so many times the length of the module that a rule rewrites.
struct LengthMultiple {
    bool of_length = false;
    Expression factor;  // without names, shortened
};

using Kind = Expression::Kind;

Expression number(const Rational& value) { return quantity(value).expression; }

const Quantity* constant(const std::string& name, const LSystem& system) {
    for (const auto& [known, value] : system.constants)
        if (known == name) return &value;
    return nullptr;
}

/// An expression over a module's parameters and a system's constants as a multiple of its length.
/// Throws Error where it is none: x+1, x^2.
LengthMultiple multiple_of(const Expression& expression, const ModuleValues& values,
                           const LSystem& system) {
    if (expression.kind == Kind::name) {
        if (values.length == expression.name) return {true, number(1)};
        const auto known = values.numbers.find(expression.name);
        if (known != values.numbers.end()) return {false, number(known->second)};
        if (const Quantity* named = constant(expression.name, system))
            return multiple_of(named->expression, {}, system);
        throw Error("'" + expression.name + "' is no number that rules keep count of");
    }
    std::vector<LengthMultiple> operands;
    for (const Expression& operand : expression.operands)
        operands.push_back(multiple_of(operand, values, system));
    Expression whole = expression;
    for (std::size_t k = 0; k < operands.size(); ++k) whole.operands[k] = operands[k].factor;
    const auto lengths =
        std::count_if(operands.begin(), operands.end(), [](const LengthMultiple& x) {
            return x.of_length && rational_value(x.factor) != Rational(0);
        });
    if (lengths == 0) return {false, shortened(std::move(whole))};
    const std::string& name = expression.name;
    const bool is_sum = expression.kind == Kind::binary && (name == "+" || name == "-");
    const bool is_multiple =
        (expression.kind == Kind::unary && name == "-") ||
        (expression.kind == Kind::binary && name == "*" && lengths == 1) ||
        (expression.kind == Kind::binary && name == "/" && lengths == 1 && operands[0].of_length) ||
        (is_sum && (lengths == 2 || rational_value(operands[0].factor) == Rational(0) ||
                    rational_value(operands[1].factor) == Rational(0)));
    if (!is_multiple)
        throw Error("the length '" + to_text(expression) +
                    "' is no multiple of that of the module it comes from");
    return {true, shortened(std::move(whole))};
}

/// The value of an expression that does not depend on the length. Throws Error where it is not
/// rational.
Rational exact_number(const Expression& expression, const ModuleValues& values,
                      const LSystem& system) {
    const LengthMultiple found = multiple_of(expression, values, system);
    const auto value = found.of_length ? std::nullopt : rational_value(found.factor);
    if (!value)
        throw Error("'" + to_text(expression) +
                    "', which conditions or turns depend on, is no rational number");
    return *value;
}

using Meaning = ParameterMeanings::Meaning;

/// Builds the graph from the axiom onward.
class Builder {
public:
    Builder(const Model& system, const Budget& budget)
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
        bool operator<(const Key& other) const {
            return std::tie(symbol, arity, numbers) <
                   std::tie(other.symbol, other.arity, other.numbers);
        }
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

    /// The module at a place of a word, or nothing if it has the length 0. Without a ratio where
    /// its length and that of the whole have nothing to do with each other.
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
        const Drawing& drawing = system_.drawing;
        if (has(drawing.plotters, [&](Symbol a) { return a == key.symbol; }))
            throw Error("the symbol " + name + " draws to points that it names");
        if (has(drawing.stamps, [&](const auto& stamp) { return stamp.symbol == key.symbol; }))
            throw Error("the symbol " + name + " stamps a shape");
        const Step step = step_of(system_.alphabet, key.symbol);
        state.draws = step == Step::draw;
        state.moves = step != Step::none;
        if (name.size() != 1) return state;
        if (std::string("&^\\/$@").find(name) != std::string::npos)
            throw Error("the symbol " + name + " makes a figure in space");
        if (name == "*" && (key.arity > 0 || drawing.scale))
            throw Error("the symbol * changes the turtle's step");
        if (name == "{" || name == "}") throw Error("a polygon goes on from letter to letter");
        if (name == "%") throw Error("the symbol % leaves branches out");
        if (name == "|") state.turn = {180, 0};
        if (name == "+" || name == "-") {
            if (key.arity > 0)
                state.turn = Rotation{} + Rotation{key.numbers[0], 0};
            else if (!drawing.angle || drawing.angle->exact)
                state.turn =
                    Rotation{} + Rotation{drawing.angle ? *drawing.angle->exact : Rational(90), 0};
            else
                state.turn = {0, 1};
            if ((name == "-") != drawing.clockwise) state.turn = -state.turn;
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

    const Model& system_;
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

Rotation operator+(const Rotation& left, const Rotation& right) {
    const Rational sum = left.degrees + right.degrees;
    return {sum - Rational(360) * Rational(floor(sum / Rational(360))), left.angles + right.angles};
}

Rotation operator-(const Rotation& turn) {
    return Rotation{} + Rotation{-turn.degrees, -turn.angles};
}

RatioGraph ratio_graph(const Model& system, const Budget& budget) {
    RatioGraph found = Builder(system, budget).graph();
    if (system.drawing.angle) found.angle = system.drawing.angle->expression;
    return found;
}

std::vector<bool> drawing_in_all(const RatioGraph& graph, const std::vector<bool>& draws) {
    std::vector<std::vector<std::size_t>> parts(graph.states.size());
    for (std::size_t k = 0; k < parts.size(); ++k)
        for (const RatioGraph::Part& part : graph.states[k].parts)
            if (!part.is_fence) parts[k].push_back(part.state);
    return drawing_in_all(parts, draws);
}

namespace {

/// Whether all lengths are multiplied by one number.
bool has_one_ratio(const RatioGraph& graph) {
    const Expression* ratio = nullptr;
    for (const RatioGraph::State& state : graph.states)
        for (const RatioGraph::Part& part : state.parts) {
            if (part.is_fence || !graph.states[part.state].matters) continue;
            if (ratio && !(*ratio == part.ratio)) return false;
            ratio = &part.ratio;
        }
    return true;
}

}  // namespace

bool has_one_length(const RatioGraph& graph) {
    const Expression* length = nullptr;
    for (const RatioGraph::Part& part : graph.axiom) {
        if (part.is_fence || !graph.states[part.state].matters) continue;
        if (length && !(*length == part.ratio)) return false;
        length = &part.ratio;
    }
    return true;
}

namespace {

bool stays(const RatioGraph& graph, std::size_t k) {
    const auto& parts = graph.states[k].parts;
    return parts.size() == 1 && !parts[0].is_fence && parts[0].state == k;
}

/// The largest angle that 360 degrees and all turns are multiples of.
Rational common_angle(const RatioGraph& graph) {
    Rational common = 360;
    for (const RatioGraph::State& state : graph.states)
        for (Rational rest = state.turn.degrees; !rest.is_zero();) {
            const Rational next = common - rest * Rational(floor(common / rest));
            common = rest;
            rest = next;
        }
    return common;
}

}  // namespace

std::optional<Model> with_equal_lengths(const RatioGraph& graph) {
    constexpr long most_directions = 360;
    if (!has_one_ratio(graph)) return std::nullopt;
    const Rational unit = common_angle(graph);
    if (unit * Rational(most_directions) < Rational(360)) return std::nullopt;
    Model system;
    system.drawing.angle = quantity(unit);
    std::vector<Word> words;
    for (std::size_t k = 0; k < graph.states.size(); ++k) {
        const RatioGraph::State& state = graph.states[k];
        if (!state.turn.is_zero()) {
            if (!stays(graph, k) || state.turn.angles != 0) return std::nullopt;
            const bool left = state.turn.degrees < Rational(180);
            const Rational turns = (left ? state.turn : -state.turn).degrees / unit;
            const Symbol turn = system.alphabet.symbol(left ? "+" : "-");
            words.emplace_back(static_cast<std::size_t>(turns.numerator().to_int64()), turn);
        } else {
            const std::string kind = state.draws ? "F_" : state.moves ? "f_" : "X_";
            words.push_back({system.alphabet.symbol(kind + std::to_string(k))});
        }
    }
    const Symbol open = system.alphabet.symbol("["), close = system.alphabet.symbol("]");
    const auto word = [&](const std::vector<RatioGraph::Part>& parts) {
        Word found;
        for (const RatioGraph::Part& part : parts) {
            if (part.is_fence)
                found.push_back(part.opens ? open : close);
            else
                found.insert(found.end(), words[part.state].begin(), words[part.state].end());
        }
        return found;
    };
    for (std::size_t k = 0; k < graph.states.size(); ++k) {
        if (!graph.states[k].turn.is_zero()) continue;
        Production rule;
        rule.predecessor.symbol = words[k].front();
        rule.successor.letters = word(graph.states[k].parts);
        system.rules.push_back(std::move(rule));
    }
    system.axiom.letters = word(graph.axiom);
    return system;
}

}  // namespace algae
