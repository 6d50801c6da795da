#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "system/detail/determinism.hpp"
#include "system/system.hpp"

// Which rules with parameters can match the same module, and which modules no rule can match.
//
// Two rules of one table with the same modules on their left sides leave a choice if both conditions can hold. A condition is a
// boolean combination of comparisons. The conjunction of two conditions, in disjunctive normal form, is a list of
// systems of comparisons f < 0, f <= 0 or f = 0, where f is linear in terms. A term is a parameter, a constant without
// an exact value, or anything that is not linear, such as x*y or floor(x), which stands for an unknown number; equal texts are the same number, and of
// floor, ceil, abs, min, max, sqrt and exp the simplest inequalities are known. If no system has a solution in rational
// numbers, the rules exclude each other. That is decided by elimination, one term after the other (Fourier 1827, Motzkin 1936; Schrijver, Theory of linear and
// integer programming, 1986, 12.2), which also gives a solution. The conditions are then worked out for the
// parameters of the solution, exactly: if both hold, the rules overlap. Otherwise it is not decided, because a
// term such as x*y need not have the value that the solution has, and some other numbers are tried.
//
// A module elsewhere in the word, and a context with branches, may be found in another place for each of the rules, so
// their parameters are different terms in the two conditions.

namespace algae {

namespace {

constexpr std::size_t most_systems = 512, most_comparisons = 400;
constexpr std::size_t most_overlaps = 1000, most_pairs = 20'000;

/// A sum of terms by their numbers, with what has no term.
struct Linear {
    std::map<std::size_t, Rational> terms;
    Rational constant;

    void add(const Linear& other, const Rational& factor) {
        for (const auto& [term, share] : other.terms) {
            Rational& mine = terms[term];
            mine += share * factor;
            if (mine.is_zero()) terms.erase(term);
        }
        constant += other.constant * factor;
    }
};

/// sum < 0, sum <= 0, sum = 0.
struct Comparison {
    enum class Kind { less, less_equal, equal };
    Linear sum;
    Kind kind = Kind::less;
};
using Comparisons = std::vector<Comparison>;

/// Too many cases to look at.
struct TooMany {};

bool holds(const Rational& value, Comparison::Kind kind) {
    return kind == Comparison::Kind::less         ? value < 0
           : kind == Comparison::Kind::less_equal ? value <= 0
                                                  : value.is_zero();
}

/// A solution by term, if there is one. Throws TooMany.
std::optional<std::map<std::size_t, Rational>> solution(Comparisons all) {
    using enum Comparison::Kind;
    struct Eliminated {
        std::size_t term;
        Comparisons bounds;  // in which it occurs, with terms that are eliminated later
    };
    std::vector<Eliminated> eliminated;
    for (;;) {
        std::optional<std::size_t> term;
        for (const Comparison& one : all)
            if (!one.sum.terms.empty()) {
                // An equation is used up first.
                if (!term || one.kind == equal) term = one.sum.terms.begin()->first;
                if (one.kind == equal) break;
            }
        if (!term) break;
        Comparisons rest, above, below;  // bounds of the term from above and from below
        std::optional<Comparison> equation;
        Eliminated step{*term, {}};
        for (Comparison& one : all) {
            const auto share = one.sum.terms.find(*term);
            if (share == one.sum.terms.end()) {
                rest.push_back(std::move(one));
                continue;
            }
            step.bounds.push_back(one);
            if (one.kind == equal && !equation)
                equation = one;
            else if (one.kind == equal || share->second > 0)
                above.push_back(std::move(one));
            else
                below.push_back(std::move(one));
        }
        const auto joined = [&](const Comparison& one, const Comparison& other) {
            // Positive multiples whose sum has no such term; an equation may be taken any number of times.
            Comparison sum = one;
            const Rational mine = one.sum.terms.at(*term), others = other.sum.terms.at(*term);
            sum.sum.add(other.sum, -(mine / others));
            sum.sum.terms.erase(*term);
            if (other.kind == less && one.kind != equal) sum.kind = less;
            if (sum.sum.terms.empty() && holds(sum.sum.constant, sum.kind)) return;
            rest.push_back(std::move(sum));
            if (rest.size() > most_comparisons) throw TooMany{};
        };
        if (equation) {
            for (const Comparison& one : above) joined(one, *equation);
            for (const Comparison& one : below) joined(one, *equation);
        } else {
            for (const Comparison& one : above)
                for (const Comparison& other : below) joined(one, other);
        }
        eliminated.push_back(std::move(step));
        all = std::move(rest);
    }
    for (const Comparison& one : all)
        if (!holds(one.sum.constant, one.kind)) return std::nullopt;

    std::map<std::size_t, Rational> values;
    for (auto step = eliminated.rbegin(); step != eliminated.rend(); ++step) {
        std::optional<Rational> low, high;
        bool is_low_open = false, is_high_open = false;
        for (const Comparison& one : step->bounds) {
            Rational rest = one.sum.constant;
            for (const auto& [term, share] : one.sum.terms)
                if (term != step->term) rest += share * values[term];  // 0 if it is free
            const Rational share = one.sum.terms.at(step->term), bound = -rest / share;
            const bool is_open = one.kind == less;
            if (one.kind == equal || share > 0)
                if (!high || bound < *high || (bound == *high && is_open)) {
                    high = bound;
                    is_high_open = is_open;
                }
            if (one.kind == equal || share < 0)
                if (!low || bound > *low || (bound == *low && is_open)) {
                    low = bound;
                    is_low_open = is_open;
                }
        }
        // A plain number, if one fits: 0, a bound, the next whole number, the middle.
        const auto fits = [&](const Rational& value) {
            return (!low || (is_low_open ? *low < value : *low <= value)) &&
                   (!high || (is_high_open ? value < *high : value <= *high));
        };
        std::vector<Rational> candidates{0, 1};
        if (low) {
            candidates.push_back(*low);
            candidates.push_back(Rational(floor_divide(low->numerator(), low->denominator()) + 1));
        }
        if (high) {
            candidates.push_back(*high);
            candidates.push_back(
                Rational(-floor_divide(-high->numerator(), high->denominator()) - 1));
        }
        if (low && high) candidates.push_back((*low + *high) / 2);
        values[step->term] = *std::find_if(candidates.begin(), candidates.end(), fits);
    }
    return values;
}

/// The conditions of two rules, over common terms.
class Conditions {
public:
    explicit Conditions(const LSystem& system) : system_(system) {}

    /// The term of a name in a condition; nothing for a constant.
    using Terms = std::map<std::string, std::string>;

    /// The systems of comparisons of which one holds where the expression is true, or is false. Throws TooMany.
    std::vector<Comparisons> cases(const Expression& expression, bool is_true, const Terms& names) {
        using enum Comparison::Kind;
        const std::string& name = expression.name;
        if (expression.kind == Expression::Kind::unary && name == "!")
            return cases(expression.operands[0], !is_true, names);
        if (expression.kind == Expression::Kind::binary) {
            const Expression &left = expression.operands[0], &right = expression.operands[1];
            if (name == "&" || name == "|") {
                auto first = cases(left, is_true, names), second = cases(right, is_true, names);
                return (name == "&") == is_true ? both(first, second) : either(first, second);
            }
            static const std::map<std::string, std::string> opposites{
                {"<", ">="}, {">=", "<"}, {">", "<="}, {"<=", ">"}, {"=", "!="}, {"!=", "="}};
            if (const auto found = opposites.find(name); found != opposites.end()) {
                const std::string& relation = is_true ? found->first : found->second;
                Linear difference = linear(left, names);
                difference.add(linear(right, names), -1);
                Linear opposite;
                opposite.add(difference, -1);
                if (relation == "<") return {{{difference, less}}};
                if (relation == "<=") return {{{difference, less_equal}}};
                if (relation == ">") return {{{opposite, less}}};
                if (relation == ">=") return {{{opposite, less_equal}}};
                if (relation == "=") return {{{difference, equal}}};
                return {{{difference, less}}, {{opposite, less}}};
            }
        }
        const Linear value = linear(expression, names);
        if (!is_true) return {{{value, equal}}};
        Linear opposite;
        opposite.add(value, -1);
        return {{{value, less}}, {{opposite, less}}};
    }

    static std::vector<Comparisons> both(const std::vector<Comparisons>& left,
                                         const std::vector<Comparisons>& right) {
        if (left.size() * right.size() > most_systems) throw TooMany{};
        std::vector<Comparisons> all;
        for (const Comparisons& one : left)
            for (const Comparisons& other : right) {
                all.push_back(one);
                all.back().insert(all.back().end(), other.begin(), other.end());
            }
        return all;
    }

    /// What is known of terms that are no parameters.
    const Comparisons& known() const { return known_; }
    /// The number of a parameter; nothing if no condition has it.
    std::optional<std::size_t> term(const std::string& name) const {
        const auto found = terms_.find(name);
        return found == terms_.end() ? std::nullopt : std::optional(found->second);
    }

private:
    static std::vector<Comparisons> either(std::vector<Comparisons> left,
                                           const std::vector<Comparisons>& right) {
        left.insert(left.end(), right.begin(), right.end());
        if (left.size() > most_systems) throw TooMany{};
        return left;
    }

    Linear of_term(const std::string& name) {
        Linear one;
        one.terms[terms_.try_emplace(name, terms_.size()).first->second] = 1;
        return one;
    }

    Linear linear(const Expression& expression, const Terms& names) {
        using enum Expression::Kind;
        if (expression.kind == number) return {{}, expression.value};
        if (expression.kind == name) {
            if (const auto found = names.find(expression.name); found != names.end())
                return of_term(found->second);
            for (const auto& [constant, value] : system_.constants)
                if (constant == expression.name && value.exact) return {{}, *value.exact};
            return of_term(expression.name);
        }
        const auto is_number = [](const Linear& sum) { return sum.terms.empty(); };
        if (expression.kind == unary && expression.name == "-") {
            Linear negative;
            negative.add(linear(expression.operands[0], names), -1);
            return negative;
        }
        if (expression.kind == binary &&
            std::string("+-*/").find(expression.name) != std::string::npos) {
            Linear left = linear(expression.operands[0], names);
            const Linear right = linear(expression.operands[1], names);
            Linear scaled;
            if (expression.name == "+" || expression.name == "-") {
                left.add(right, expression.name == "+" ? 1 : -1);
                return left;
            }
            if (expression.name == "*" && is_number(right)) {
                scaled.add(left, right.constant);
                return scaled;
            }
            if (expression.name == "*" && is_number(left)) {
                scaled.add(right, left.constant);
                return scaled;
            }
            if (expression.name == "/" && is_number(right) && !right.constant.is_zero()) {
                scaled.add(left, 1 / right.constant);
                return scaled;
            }
        }
        return other(expression, names);
    }

    /// Anything else is a number of its own, of which a little may be known.
    Linear other(const Expression& expression, const Terms& names) {
        const std::string text = to_text(renamed(expression, names));
        const bool is_known = terms_.contains(text);
        const Linear value = of_term(text);
        if (is_known || expression.kind != Expression::Kind::call) return value;
        using enum Comparison::Kind;
        // value + constant <= factor * other, or <.
        const auto at_most = [&](const Linear& left, const Linear& right, const Rational& plus,
                                 Comparison::Kind kind) {
            Linear difference = left;
            difference.add(right, -1);
            difference.constant += plus;
            known_.push_back({difference, kind});
        };
        const std::string& function = expression.name;
        std::vector<Linear> arguments;
        if (std::set<std::string>{"floor", "ceil", "abs", "min", "max"}.contains(function))
            for (const Expression& operand : expression.operands)
                arguments.push_back(linear(operand, names));
        const Linear nothing;
        if (function == "floor") {
            at_most(value, arguments[0], 0, less_equal);
            at_most(arguments[0], value, -1, less);
        } else if (function == "ceil") {
            at_most(arguments[0], value, 0, less_equal);
            at_most(value, arguments[0], -1, less);
        } else if (function == "abs") {
            Linear opposite;
            opposite.add(arguments[0], -1);
            at_most(arguments[0], value, 0, less_equal);
            at_most(opposite, value, 0, less_equal);
        } else if (function == "min" || function == "max") {
            for (const Linear& argument : arguments)
                at_most(function == "min" ? value : argument, function == "min" ? argument : value,
                        0, less_equal);
        } else if (function == "sqrt" || function == "exp") {
            at_most(nothing, value, 0, function == "sqrt" ? less_equal : less);
        }
        return value;
    }

    static Expression renamed(Expression expression, const Terms& names) {
        if (expression.kind == Expression::Kind::name)
            if (const auto found = names.find(expression.name); found != names.end())
                expression.name = found->second;
        for (Expression& operand : expression.operands)
            operand = renamed(std::move(operand), names);
        return expression;
    }

    const LSystem& system_;
    std::map<std::string, std::size_t> terms_;
    Comparisons known_;
};

/// Names of the terms that the parameters of a rule stand for. `side` tells those that the other rule does not share.
Conditions::Terms terms_of(const Production& rule, const Alphabet& alphabet,
                           const std::string& side) {
    Conditions::Terms names;
    std::size_t number = 0;
    const auto add = [&](const ModulePattern& module, const std::string& mark) {
        for (const std::string& parameter : module.parameters)
            names.emplace(parameter, "#" + mark + std::to_string(number++));
    };
    const bool branches = std::any_of(
        rule.right.begin(), rule.right.end(),
        [&](const ModulePattern& module) { return alphabet.name(module.symbol) == "["; });
    add(rule.predecessor, "");
    for (const ModulePattern& module : rule.left) add(module, "");
    for (const ModulePattern& module : rule.right) add(module, branches ? side : "");
    for (const ModulePattern& module : rule.elsewhere) add(module, side);
    return names;
}

bool is_logical(const Expression& expression) {
    static const std::set<std::string> operators{"<", "<=", ">", ">=", "=", "!=", "&", "|", "!"};
    return (expression.kind == Expression::Kind::binary ||
            expression.kind == Expression::Kind::unary) &&
           operators.contains(expression.name);
}

bool has_logic(const Expression& expression) {
    return is_logical(expression) ||
           std::any_of(expression.operands.begin(), expression.operands.end(), has_logic);
}

/// Whether a condition is true; nothing if some number on the way is not exact, or there is none. Throws Error where
/// `evaluate` does.
std::optional<bool> is_true(const Expression& expression, const Names& names) {
    if (!is_logical(expression)) {
        // A comparison of rounded numbers within arithmetic would not be seen.
        if (has_logic(expression)) return std::nullopt;
        const Quantity value = evaluate(expression, names);
        return value.exact ? std::optional(!value.exact->is_zero()) : std::nullopt;
    }
    const std::string& name = expression.name;
    if (name == "!") {
        const std::optional<bool> inner = is_true(expression.operands[0], names);
        return inner ? std::optional(!*inner) : std::nullopt;
    }
    if (name == "&" || name == "|") {
        // The left side may decide, and then the right one need not have a value.
        const std::optional<bool> left = is_true(expression.operands[0], names);
        if (!left || *left == (name == "|")) return left;
        return is_true(expression.operands[1], names);
    }
    for (const Expression& operand : expression.operands)
        if (has_logic(operand) || !evaluate(operand, names).exact) return std::nullopt;
    return !evaluate(expression, names).exact->is_zero();
}

/// Whether the condition holds for these values of terms; nothing if that is not seen exactly.
std::optional<bool> condition_holds(const LSystem& system, const Production& rule,
                                    const Conditions::Terms& names,
                                    const std::map<std::string, Rational>& values) {
    if (!rule.condition) return true;
    std::map<std::string, Quantity> known;
    for (const auto& [parameter, term] : names) {
        const auto found = values.find(term);
        known.emplace(parameter, quantity(found == values.end() ? Rational(0) : found->second));
    }
    try {
        return is_true(*rule.condition, [&](const std::string& name) -> const Quantity* {
            if (const auto found = known.find(name); found != known.end()) return &found->second;
            for (const auto& [constant, quantity] : system.constants)
                if (constant == name) return &quantity;
            return nullptr;
        });
    } catch (const Error&) {
        return std::nullopt;  // it has no value there
    }
}

/// The numbers that stand in an expression.
void add_numbers(const Expression& expression, const LSystem& system, std::set<Rational>& numbers) {
    if (expression.kind == Expression::Kind::number) numbers.insert(expression.value);
    if (expression.kind == Expression::Kind::name)
        for (const auto& [constant, value] : system.constants)
            if (constant == expression.name && value.exact) numbers.insert(*value.exact);
    for (const Expression& operand : expression.operands) add_numbers(operand, system, numbers);
}

/// Compares the conditions of two rules with the same left side; nothing if they exclude each other.
std::optional<RuleOverlap> compared(const LSystem& system, std::size_t first, std::size_t second) {
    const Production &one = system.rules[first], &other = system.rules[second];
    const Conditions::Terms names = terms_of(one, system.alphabet, "a"),
                            others = terms_of(other, system.alphabet, "b");
    // The parameters by which an overlap is shown, in the order in which the rule has them.
    const auto overlap = [&](const std::map<std::string, Rational>& values) {
        RuleOverlap found{first, second, std::vector<std::pair<std::string, Rational>>{}};
        for (const Pattern& part : {one.left, Pattern{one.predecessor}, one.right, one.elsewhere})
            for (const ModulePattern& module : part)
                for (const std::string& parameter : module.parameters) {
                    const auto value = values.find(names.at(parameter));
                    found.both->emplace_back(parameter,
                                             value == values.end() ? Rational(0) : value->second);
                }
        return found;
    };
    const auto both_hold = [&](const std::map<std::string, Rational>& values) {
        return condition_holds(system, one, names, values) == true &&
               condition_holds(system, other, others, values) == true;
    };
    Conditions conditions(system);
    try {
        std::vector<Comparisons> cases{{}};
        if (one.condition) cases = conditions.cases(*one.condition, true, names);
        if (other.condition)
            cases = Conditions::both(cases, conditions.cases(*other.condition, true, others));
        bool is_possible = false;
        for (Comparisons& all : cases) {
            all.insert(all.end(), conditions.known().begin(), conditions.known().end());
            const auto found = solution(std::move(all));
            if (!found) continue;
            is_possible = true;
            std::map<std::string, Rational> values;
            for (const Conditions::Terms& terms : {names, others})
                for (const auto& [parameter, term] : terms)
                    if (const auto number = conditions.term(term))
                        if (const auto value = found->find(*number); value != found->end())
                            values[term] = value->second;
            if (both_hold(values)) return overlap(values);
        }
        if (!is_possible) return std::nullopt;
    } catch (const TooMany&) {
    }
    // Some numbers: those in the conditions, and those one and a half beside them.
    std::set<Rational> numbers{0, 1}, near;
    if (one.condition) add_numbers(*one.condition, system, numbers);
    if (other.condition) add_numbers(*other.condition, system, numbers);
    for (const Rational& number : numbers)
        for (const Rational& step : {Rational(0), Rational(1), Rational(-1), Rational(1, 2)})
            near.insert(number + step);
    std::set<std::string> terms;
    for (const Conditions::Terms& all : {names, others})
        for (const auto& [parameter, term] : all)
            if (conditions.term(term)) terms.insert(term);
    constexpr std::uint64_t most_tried = 500;
    std::uint64_t points = 1;
    for (std::size_t i = 0; i < terms.size() && points <= most_tried; ++i) points *= near.size();
    const std::vector<Rational> choices(near.begin(), near.end());
    for (std::uint64_t point = 0; point < std::min(points, most_tried); ++point) {
        std::map<std::string, Rational> values;
        std::uint64_t rest = point;
        for (const std::string& term : terms) {
            values[term] = choices[static_cast<std::size_t>(rest % choices.size())];
            rest /= choices.size();
        }
        if (both_hold(values)) return overlap(values);
    }
    return RuleOverlap{first, second, std::nullopt};
}

/// The letters of a pattern with the numbers of their parameters.
std::vector<std::pair<Symbol, std::size_t>> kinds_of(const Pattern& pattern) {
    std::vector<std::pair<Symbol, std::size_t>> kinds;
    for (const ModulePattern& module : pattern)
        kinds.emplace_back(module.symbol, module.parameters.size());
    return kinds;
}

bool has_parameters(const Pattern& pattern) {
    return std::any_of(pattern.begin(), pattern.end(),
                       [](const ModulePattern& module) { return !module.parameters.empty(); });
}

bool is_plain(const Production& rule) {
    return !rule.condition && !rule.shape && rule.successor.arguments.empty() &&
           rule.successor.splices.empty() && rule.predecessor.parameters.empty() &&
           !has_parameters(rule.left) && !has_parameters(rule.right) &&
           !has_parameters(rule.elsewhere);
}

}  // namespace

std::vector<RuleOverlap> first_overlaps(const LSystem& system, std::size_t most) {
    using Kinds = std::vector<std::pair<Symbol, std::size_t>>;
    std::map<std::tuple<std::size_t, Kinds, Kinds, Kinds, Kinds>, std::vector<std::size_t>> sides;
    for (std::size_t i = 0; i < system.rules.size(); ++i) {
        const Production& rule = system.rules[i];
        sides[{rule.table, kinds_of({rule.predecessor}), kinds_of(rule.left), kinds_of(rule.right),
               kinds_of(rule.elsewhere)}]
            .push_back(i);
    }
    std::vector<RuleOverlap> found;
    std::size_t pairs = 0;
    for (const auto& [side, rules] : sides)
        for (std::size_t i = 0; i < rules.size(); ++i)
            for (std::size_t k = i + 1; k < rules.size(); ++k) {
                const Production &one = system.rules[rules[i]], &other = system.rules[rules[k]];
                if (one.probability && other.probability) continue;
                if (one == other ||
                    (is_plain(one) && is_plain(other) && one.successor == other.successor))
                    continue;
                if (found.size() >= most) return found;
                if (++pairs > most_pairs) {  // beyond, nothing is compared
                    found.push_back({rules[i], rules[k], std::nullopt});
                    return found;
                }
                if (auto overlap = compared(system, rules[i], rules[k]))
                    found.push_back(std::move(*overlap));
            }
    std::sort(found.begin(), found.end(), [](const RuleOverlap& left, const RuleOverlap& right) {
        return std::pair(left.first, left.second) < std::pair(right.first, right.second);
    });
    return found;
}

std::vector<RuleOverlap> overlaps(const LSystem& system) {
    return first_overlaps(system, most_overlaps);
}

std::vector<UnmatchedModule> unmatched_modules(const LSystem& system) {
    std::map<Symbol, std::set<std::size_t>> expected;
    for (const Production& rule : system.rules)
        // A box of shape rules has three sizes, however it is written.
        if (!rule.shape)
            expected[rule.predecessor.symbol].insert(rule.predecessor.parameters.size());
    std::vector<UnmatchedModule> found;
    std::set<std::pair<Symbol, std::size_t>> seen;
    const auto look_at = [&](const ModuleWord& word) {
        for (std::size_t i = 0; i < word.letters.size(); ++i) {
            const Symbol letter = word.letters[i];
            const auto rules = expected.find(letter);
            if (rules == expected.end()) continue;
            const auto arguments = word.arguments.find(i);
            const std::size_t count =
                arguments == word.arguments.end() ? 0 : arguments->second.size();
            if (rules->second.contains(count) || !seen.emplace(letter, count).second) continue;
            found.push_back({letter, count, {rules->second.begin(), rules->second.end()}});
        }
    };
    look_at(system.axiom);
    for (const Production& rule : system.rules) look_at(rule.successor);
    return found;
}

}  // namespace algae
