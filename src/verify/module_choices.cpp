#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "verify/modules.hpp"

namespace algae::verify {

namespace {

using Pattern = ModuleSystem::Pattern;

/// Matches rules at one position of a word; names are bound to the parameters of what was found.
class Match {
public:
    Match(const ModuleSystem& system, const Modules& word, std::size_t position, const Field& proof)
        : system_(system), word_(word), position_(position), proof_(proof) {}

    /// Whether the rule matches; then `names` says what its names stand for.
    bool of(const ModuleSystem::Rule& rule) {
        names.clear();
        return fits(rule.module, position_) && left(rule.left) &&
               right(rule.right, 0, rule.right.size(), position_ + 1) && elsewhere(rule, 0);
    }

    Bindings names;

private:
    bool fits(const Pattern& pattern, std::size_t place) {
        const Module& module = word_[place];
        if (module.letter != pattern.letter || module.values.size() != pattern.parameters.size())
            return false;
        for (std::size_t i = 0; i < module.values.size(); ++i)
            names[pattern.parameters[i]] = module.values[i];
        return true;
    }

    bool is(const char* bracket, std::size_t place) const {
        return word_[place].letter == bracket && !system_.ignored.contains(bracket);
    }
    bool is_ignored(std::size_t place) const {
        return system_.ignored.contains(word_[place].letter);
    }

    /// The other bracket of the one at this place, looking forward or back.
    std::size_t partner(std::size_t place, bool forward) const {
        std::size_t depth = 0;
        while (place < word_.size()) {
            if (is("[", place)) depth += forward ? 1 : ~std::size_t{0};
            if (is("]", place)) depth += forward ? ~std::size_t{0} : 1;
            if (depth == 0) return place;
            forward ? ++place : --place;
        }
        proof_.refuse("the brackets of a word do not match");
    }

    /// The path from the module towards the root, the last of the modules first.
    bool left(const std::vector<Pattern>& patterns) {
        std::size_t place = position_;
        for (auto pattern = patterns.rbegin(); pattern != patterns.rend(); ++pattern) {
            for (;;) {
                if (place == 0) return false;
                --place;
                if (is("]", place))
                    place = partner(place, false);
                else if (!is("[", place) && !is_ignored(place))
                    break;
            }
            if (!fits(*pattern, place)) return false;
        }
        return true;
    }

    /// Whether the patterns from one to another stand on an axis from this place on.
    bool right(const std::vector<Pattern>& patterns, std::size_t from, std::size_t to,
               std::size_t place) {
        if (from == to) return true;
        const bool branch = patterns[from].letter == "[" && !system_.ignored.contains("[");
        std::size_t close = from;
        for (std::size_t depth = 0; branch; ++close) {
            if (patterns[close].letter == "[") ++depth;
            if (patterns[close].letter == "]" && --depth == 0) break;
        }
        for (; place < word_.size() && !is("]", place); ++place) {
            if (is_ignored(place)) continue;
            if (!is("[", place))
                return !branch && fits(patterns[from], place) &&
                       right(patterns, from + 1, to, place + 1);
            const std::size_t end = partner(place, true);
            if (branch && right(patterns, from + 1, close, place + 1) &&
                right(patterns, close + 1, to, end + 1))
                return true;
            place = end;
        }
        return false;
    }

    /// The first combination of modules for the items from this one on that makes the condition true.
    bool elsewhere(const ModuleSystem::Rule& rule, std::size_t item) {
        if (item == rule.elsewhere.size())
            return !rule.condition || value(*rule.condition, names, proof_) != 0;
        for (std::size_t place = 0; place < word_.size(); ++place)
            if (place != position_ && fits(rule.elsewhere[item], place) &&
                elsewhere(rule, item + 1))
                return true;
        return false;
    }

    const ModuleSystem& system_;
    const Modules& word_;
    std::size_t position_;
    const Field& proof_;
};

/// The modules around it that a rule asks for; brackets do not count.
std::size_t size_around(const ModuleSystem::Rule& rule) {
    std::size_t size = 0;
    for (const auto* patterns : {&rule.left, &rule.right, &rule.elsewhere})
        for (const Pattern& pattern : *patterns)
            size += pattern.letter != "[" && pattern.letter != "]";
    return size;
}

bool same_kinds(const std::vector<Pattern>& some, const std::vector<Pattern>& others) {
    return std::equal(some.begin(), some.end(), others.begin(), others.end(),
                      [](const Pattern& one, const Pattern& other) {
                          return one.letter == other.letter &&
                                 one.parameters.size() == other.parameters.size();
                      });
}

bool same_around(const ModuleSystem::Rule& one, const ModuleSystem::Rule& other) {
    return same_kinds(one.left, other.left) && same_kinds(one.right, other.right) &&
           same_kinds(one.elsewhere, other.elsewhere);
}

}  // namespace

Choices choices(const ModuleSystem& system, const Modules& word, std::size_t position,
                const Field& proof) {
    Match match(system, word, position, proof);
    const ModuleSystem::Rule* best = nullptr;
    for (const ModuleSystem::Rule& rule : system.rules)
        if ((!best || size_around(rule) > size_around(*best)) && match.of(rule)) best = &rule;
    Choices all;
    if (!best) return all;
    Rational sum;
    for (const ModuleSystem::Rule& rule : system.rules) {
        if (!same_around(rule, *best) || !match.of(rule)) continue;
        Modules successor;
        for (const auto& [letter, arguments] : rule.successor) {
            successor.push_back({letter, {}});
            for (const Term& argument : arguments)
                successor.back().values.push_back(value(argument, match.names, proof));
        }
        if (!rule.probability && !all.empty() && all.back().second == successor) continue;
        const Rational probability = rule.probability.value_or(Rational(1));
        sum += probability;
        all.emplace_back(probability, std::move(successor));
    }
    if (sum != 1)
        proof.refuse("the rules for a module " + word[position].letter + " have the sum " +
                     to_string(sum) + " of probabilities");
    return all;
}

double value(const Term& term, const Bindings& names, const Field& proof) {
    if (term.kind == Term::Kind::number) return term.number;
    const std::string& name = term.name;
    if (term.kind == Term::Kind::parameter) {
        const auto found = names.find(name);
        if (found == names.end())
            proof.refuse("a rule has the parameter " + name + " of no module");
        return found->second;
    }
    const std::size_t count = term.parts.size();
    const auto part = [&](std::size_t i) { return value(term.parts[i], names, proof); };
    const double x = part(0);
    double result = std::nan("");
    if (count == 1 && name == "-") {
        result = -x;
    } else if (count == 1 && name == "!") {
        result = x == 0;
    } else if (count == 1 && name == "abs") {
        result = std::abs(x);
    } else if (count == 1 && name == "floor") {
        result = std::floor(x);
    } else if (count == 1 && name == "ceil") {
        result = std::ceil(x);
    } else if (count == 1 && name == "sqrt") {
        result = std::sqrt(x);
    } else if (count == 2 && name == "&") {
        result = x != 0 && part(1) != 0;
    } else if (count == 2 && name == "|") {
        result = x != 0 || part(1) != 0;
    } else if (name == "min" || name == "max") {
        result = x;
        for (std::size_t i = 1; i < count; ++i)
            result = name == "min" ? std::min(result, part(i)) : std::max(result, part(i));
    } else if (count == 2) {
        const double y = part(1);
        const std::map<std::string, double> comparisons{{"<", x < y},  {"<=", x <= y},
                                                        {">", x > y},  {">=", x >= y},
                                                        {"=", x == y}, {"!=", x != y}};
        const auto comparison = comparisons.find(name);
        if (comparison != comparisons.end()) return comparison->second;
        if (name == "+")
            result = x + y;
        else if (name == "-")
            result = x - y;
        else if (name == "*")
            result = x * y;
        else if (name == "/")
            result = x / y;
        else if (name == "^")
            result = std::pow(x, y);
        else
            throw BoundReached(Bound::method,
                               "the operation '" + name + "' is not worked out again");
    } else {
        throw BoundReached(Bound::method, "the function '" + name + "' is not worked out again");
    }
    if (!std::isfinite(result)) proof.refuse("an expression of a rule has no value");
    return result;
}

}  // namespace algae::verify
