#include "oracle/modules.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace algae::oracle {

namespace {

struct NoValue {};
using Bindings = std::map<std::string, double>;

double finite(double value) {
    if (!std::isfinite(value)) throw NoValue{};
    return value;
}

/// Goes down the tree of the expression for every value.
class Evaluation {
public:
    Evaluation(const LSystem& system, const Bindings& bindings)
        : system_(system), bindings_(bindings) {}

    double value(const Expression& expression) const {
        if (!mentions_parameter(expression))  // exact as far as it goes
            return evaluate(expression,
                            [&](const std::string& name) -> const Quantity* {
                                for (const auto& [constant, quantity] : system_.constants)
                                    if (constant == name) return &quantity;
                                return nullptr;
                            })
                .value;
        if (expression.kind == Expression::Kind::name) return bindings_.at(expression.name);
        const std::string& name = expression.name;
        const double first = value(expression.operands[0]);
        if (name == "&" && first == 0) return 0;
        if (name == "|" && first != 0) return 1;
        std::vector<double> values{first};
        for (std::size_t i = 1; i < expression.operands.size(); ++i)
            values.push_back(value(expression.operands[i]));
        return finite(operation(expression, values));
    }

private:
    bool mentions_parameter(const Expression& expression) const {
        if (expression.kind == Expression::Kind::name && bindings_.count(expression.name))
            return true;
        for (const Expression& operand : expression.operands)
            if (mentions_parameter(operand)) return true;
        return false;
    }

    static double degrees(double radians) { return radians * 180 / std::numbers::pi; }

    static double sine(double x) {
        x = std::fmod(x, 360);
        x = x < 0 ? x + 360 : x;
        for (const auto& [angle, sine] : std::map<double, double>{{0, 0},
                                                                  {30, 0.5},
                                                                  {90, 1},
                                                                  {150, 0.5},
                                                                  {180, 0},
                                                                  {210, -0.5},
                                                                  {270, -1},
                                                                  {330, -0.5}})
            if (x == angle) return sine;
        return std::sin(x * std::numbers::pi / 180);
    }
    static double cosine(double x) {
        x = std::fmod(x, 360);
        x = x < 0 ? x + 360 : x;
        for (const auto& [angle, cosine] : std::map<double, double>{{0, 1},
                                                                    {60, 0.5},
                                                                    {90, 0},
                                                                    {120, -0.5},
                                                                    {180, -1},
                                                                    {240, -0.5},
                                                                    {270, 0},
                                                                    {300, 0.5}})
            if (x == angle) return cosine;
        return std::cos(x * std::numbers::pi / 180);
    }

    static double operation(const Expression& expression, const std::vector<double>& v) {
        const std::string& name = expression.name;
        if (expression.kind == Expression::Kind::unary) return name == "!" ? v[0] == 0 : -v[0];
        if (expression.kind == Expression::Kind::call) return call(name, v);
        if (name == "+") return v[0] + v[1];
        if (name == "-") return v[0] - v[1];
        if (name == "*") return v[0] * v[1];
        if (name == "/") return v[0] / v[1];
        if (name == "^") return std::pow(v[0], v[1]);
        if (name == "<") return v[0] < v[1];
        if (name == "<=") return v[0] <= v[1];
        if (name == ">") return v[0] > v[1];
        if (name == ">=") return v[0] >= v[1];
        if (name == "=") return v[0] == v[1];
        if (name == "!=") return v[0] != v[1];
        return v[1] != 0;  // & and |: the left side did not decide
    }

    static double call(const std::string& name, const std::vector<double>& v) {
        if (name == "min") return *std::min_element(v.begin(), v.end());
        if (name == "max") return *std::max_element(v.begin(), v.end());
        if (name == "abs") return std::fabs(v[0]);
        if (name == "floor") return std::floor(v[0]);
        if (name == "ceil") return std::ceil(v[0]);
        if (name == "sqrt") return std::sqrt(v[0]);
        if (name == "exp") return std::exp(v[0]);
        if (name == "log") return std::log(v[0]);
        if (name == "sin") return sine(v[0]);
        if (name == "cos") return cosine(v[0]);
        if (name == "asin") return degrees(std::asin(v[0]));
        if (name == "acos") return degrees(std::acos(v[0]));
        if (name == "atan") return degrees(std::atan(v[0]));
        double x = std::fmod(v[0], 180);
        x = x < 0 ? x + 180 : x;
        if (x == 90) throw NoValue{};
        return x == 0 ? 0 : x == 45 ? 1 : x == 135 ? -1 : std::tan(x * std::numbers::pi / 180);
    }

    const LSystem& system_;
    const Bindings& bindings_;
};

/// Whether a rule matches one module of a word.
class Matching {
public:
    Matching(const LSystem& system, const Modules& word, std::size_t position)
        : system_(system), word_(word), position_(position) {}

    std::optional<Bindings> bindings(const Production& rule) const {
        Bindings found;
        if (!binds(rule.predecessor, word_[position_], found)) return std::nullopt;
        if (!left(rule.left, found)) return std::nullopt;
        return right(rule, 0, position_ + 1, {}, found);
    }

private:
    std::string name(const ModulePattern& pattern) const {
        return system_.alphabet.name(pattern.symbol);
    }

    bool binds(const ModulePattern& pattern, const Module& module, Bindings& found) const {
        if (name(pattern) != module.letter || pattern.parameters.size() != module.values.size())
            return false;
        for (std::size_t i = 0; i < module.values.size(); ++i)
            found[pattern.parameters[i]] = module.values[i];
        return true;
    }

    bool is_ignored(const Module& module) const {
        return std::any_of(system_.ignored.begin(), system_.ignored.end(),
                           [&](Symbol a) { return system_.alphabet.name(a) == module.letter; });
    }

    bool left(const Pattern& pattern, Bindings& found) const {
        Modules path;  // from the root to the module: closed branches are taken away
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < position_; ++i) {
            if (word_[i].letter == "[") {
                open.push_back(path.size());
            } else if (word_[i].letter == "]") {
                path.resize(open.back());
                open.pop_back();
            } else if (!is_ignored(word_[i])) {
                path.push_back(word_[i]);
            }
        }
        if (path.size() < pattern.size()) return false;
        for (std::size_t i = 0; i < pattern.size(); ++i)
            if (!binds(pattern[i], path[path.size() - pattern.size() + i], found)) return false;
        return true;
    }

    std::size_t behind_branch(std::size_t open) const {
        std::size_t depth = 0;
        for (std::size_t i = open;; ++i) {
            if (word_[i].letter == "[") ++depth;
            if (word_[i].letter == "]" && --depth == 0) return i + 1;
        }
    }

    /// `ends` are the positions behind the branches that the context has gone into.
    std::optional<Bindings> right(const Production& rule, std::size_t item, std::size_t at,
                                  std::vector<std::size_t> ends, Bindings found) const {
        if (item == rule.right.size()) return elsewhere(rule, 0, found);
        const std::string wanted = name(rule.right[item]);
        if (wanted == "]") {
            const std::size_t end = ends.back();
            ends.pop_back();
            return right(rule, item + 1, end, ends, found);
        }
        while (at < word_.size() && is_ignored(word_[at])) ++at;
        if (at == word_.size() || word_[at].letter == "]") return std::nullopt;
        if (word_[at].letter == "[") {
            const std::size_t end = behind_branch(at);
            if (wanted == "[") {
                auto inside = ends;
                inside.push_back(end);
                if (auto all = right(rule, item + 1, at + 1, inside, found)) return all;
            }
            return right(rule, item, end, ends, found);
        }
        if (!binds(rule.right[item], word_[at], found)) return std::nullopt;
        return right(rule, item + 1, at + 1, ends, found);
    }

    std::optional<Bindings> elsewhere(const Production& rule, std::size_t item,
                                      const Bindings& found) const {
        if (item == rule.elsewhere.size()) {
            if (rule.condition && Evaluation(system_, found).value(*rule.condition) == 0)
                return std::nullopt;
            return found;
        }
        for (std::size_t i = 0; i < word_.size(); ++i) {
            Bindings more = found;
            if (i == position_ || !binds(rule.elsewhere[item], word_[i], more)) continue;
            if (auto all = elsewhere(rule, item + 1, more)) return all;
        }
        return std::nullopt;
    }

    const LSystem& system_;
    const Modules& word_;
    std::size_t position_;
};

std::size_t context(const LSystem& system, const Production& rule) {
    std::size_t size = rule.left.size() + rule.elsewhere.size();
    for (const ModulePattern& module : rule.right) {
        const std::string name = system.alphabet.name(module.symbol);
        size += name != "[" && name != "]";
    }
    return size;
}

std::vector<std::pair<std::string, std::size_t>> shape(const LSystem& system,
                                                       const Production& rule) {
    std::vector<std::pair<std::string, std::size_t>> all;
    for (const Pattern* pattern : {&rule.left, &rule.right, &rule.elsewhere}) {
        for (const ModulePattern& module : *pattern)
            all.emplace_back(system.alphabet.name(module.symbol), module.parameters.size());
        all.emplace_back("", 0);
    }
    return all;
}

Modules written(const LSystem& system, const ModuleWord& word, const Bindings& bindings) {
    Modules out;
    for (std::size_t i = 0; i < word.letters.size(); ++i) {
        out.push_back({system.alphabet.name(word.letters[i]), {}});
        if (const auto arguments = word.arguments.find(i); arguments != word.arguments.end())
            for (const Expression& argument : arguments->second)
                out.back().values.push_back(Evaluation(system, bindings).value(argument));
    }
    return out;
}

Modules successor(const LSystem& system, const Modules& word, std::size_t position) {
    std::vector<Production> rules = system.rules;
    std::stable_sort(rules.begin(), rules.end(), [&](const Production& a, const Production& b) {
        return context(system, a) > context(system, b);
    });
    const Production* best = nullptr;
    Bindings bindings;
    for (const Production& rule : rules) {
        if (best && context(system, rule) < context(system, *best)) continue;
        const bool same = best && shape(system, rule) == shape(system, *best);
        if (best && !same && context(system, rule) == context(system, *best)) continue;
        const auto found = Matching(system, word, position).bindings(rule);
        if (!found) continue;
        if (same) throw NoValue{};
        best = &rule;
        bindings = *found;
    }
    if (!best) return {word[position]};
    return written(system, best->successor, bindings);
}

}  // namespace

std::optional<std::vector<Modules>> module_words(const LSystem& system, unsigned n) {
    try {
        std::vector<Modules> words{written(system, system.axiom, {})};
        for (unsigned k = 0; k < n; ++k) {
            Modules next;
            for (std::size_t i = 0; i < words.back().size(); ++i) {
                const Modules part = successor(system, words.back(), i);
                next.insert(next.end(), part.begin(), part.end());
            }
            words.push_back(std::move(next));
        }
        return words;
    } catch (const NoValue&) {
        return std::nullopt;
    }
}

}  // namespace algae::oracle
