#include "verify/modules.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "base/error.hpp"

namespace algae::verify {

namespace {

double number(const Field& field) {
    const std::string& text = field.text();
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        field.fail("expected a number, found '" + text + "'");
    return value;
}

Term term(const Field& field, std::size_t depth = 0) {
    constexpr std::size_t deepest = 2000;
    if (depth > deepest) field.fail("more than 2000 operations inside each other");
    Term read;
    if (field.kind() == JsonValue::Kind::text) {
        read.number = number(field);
    } else if (field.has("parameter")) {
        field.only({"parameter"});
        read.kind = Term::Kind::parameter;
        read.name = field.at("parameter").text();
    } else {
        field.only({"apply", "to"});
        read.kind = Term::Kind::operation;
        read.name = field.at("apply").text();
        for (const Field& part : field.at("to").list()) read.parts.push_back(term(part, depth + 1));
        if (read.parts.empty()) field.at("to").fail("an operation is on something");
    }
    return read;
}

/// The letter and what stands behind it.
std::pair<std::string, std::vector<Field>> module(const Field& field) {
    std::vector<Field> parts = field.list();
    if (parts.empty()) field.fail("a module has a letter");
    std::string letter = parts.front().text();
    parts.erase(parts.begin());
    return {std::move(letter), std::move(parts)};
}

ModuleSystem::Rule rule(const Field& field) {
    field.only({"module", "left", "right", "elsewhere", "condition", "probability", "successor"});
    ModuleSystem::Rule read;
    const auto [letter, parameters] = module(field.at("module"));
    read.letter = letter;
    for (const Field& name : parameters) read.parameters.push_back(name.text());
    for (const char* around : {"left", "right", "elsewhere"})
        read.looks_around = read.looks_around || field.has(around);
    if (field.has("condition")) read.condition = term(field.at("condition"));
    if (field.has("probability")) read.probability = probability(field.at("probability"));
    for (const Field& each : field.at("successor").list()) {
        const auto [name, arguments] = module(each);
        auto& [next, values] = read.successor.emplace_back();
        next = name;
        for (const Field& argument : arguments) values.push_back(term(argument));
    }
    return read;
}

/// Works out the probability of one word.
class Chance {
public:
    Chance(const ModuleSystem& system, const Modules& to, const Field& proof, const Budget& budget)
        : system_(system), to_(to), proof_(proof), budget_(budget) {}

    /// That the word derives all of the other.
    Rational of(const Modules& word, std::uint64_t steps) {
        return of_part(word, steps, 0, to_.size());
    }

private:
    using Choice = std::pair<Rational, Modules>;

    Rational of_part(const Modules& word, std::uint64_t steps, std::size_t begin, std::size_t end);
    Rational of_module(const Module& module, std::uint64_t steps, std::size_t begin,
                       std::size_t end);
    const std::vector<Choice>& choices(const Module& module);
    double value(const Term& term, const ModuleSystem::Rule& rule, const Module& module) const;

    const ModuleSystem& system_;
    const Modules& to_;
    const Field& proof_;
    const Budget& budget_;
    std::map<Module, std::vector<Choice>> choices_;
    std::map<std::tuple<Module, std::uint64_t, std::size_t, std::size_t>, Rational> known_;
};

Rational Chance::of_part(const Modules& word, std::uint64_t steps, std::size_t begin,
                         std::size_t end) {
    std::vector<Rational> ways(end - begin + 1);  // by where the modules so far may end
    ways[0] = Rational(1);
    for (const Module& module : word) {
        budget_.check();
        std::vector<Rational> longer(ways.size());
        for (std::size_t i = 0; i < ways.size(); ++i) {
            if (ways[i].is_zero()) continue;
            for (std::size_t j = i; j < ways.size(); ++j)
                longer[j] += ways[i] * of_module(module, steps, begin + i, begin + j);
        }
        ways = std::move(longer);
    }
    return ways.back();
}

Rational Chance::of_module(const Module& module, std::uint64_t steps, std::size_t begin,
                           std::size_t end) {
    const std::vector<Choice>* next = steps == 0 ? nullptr : &choices(module);
    if (!next || next->empty()) return Rational(end == begin + 1 && to_[begin] == module ? 1 : 0);
    const std::tuple key(module, steps, begin, end);
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    Rational sum;
    for (const auto& [probability, successor] : *next)
        sum += probability * of_part(successor, steps - 1, begin, end);
    known_.emplace(key, sum);
    budget_.check_memory(known_.size() * 300, "the probabilities of parts of a word");
    return sum;
}

/// What the module may become; nothing if it stays.
const std::vector<Chance::Choice>& Chance::choices(const Module& module) {
    const auto [entry, fresh] = choices_.try_emplace(module);
    std::vector<Choice>& all = entry->second;
    if (!fresh) return all;
    std::size_t certain = 0;
    Rational sum;
    for (const ModuleSystem::Rule& rule : system_.rules) {
        if (rule.letter != module.letter || rule.parameters.size() != module.values.size())
            continue;
        if (rule.condition && value(*rule.condition, rule, module) == 0) continue;
        Modules word;
        for (const auto& [letter, arguments] : rule.successor) {
            word.push_back({letter, {}});
            for (const Term& argument : arguments)
                word.back().values.push_back(value(argument, rule, module));
        }
        if (!rule.probability) {
            if (certain > 0 && all.back().second == word) continue;
            ++certain;
        }
        sum += rule.probability.value_or(Rational(1));
        all.emplace_back(rule.probability.value_or(Rational(1)), std::move(word));
    }
    if (!all.empty() && sum != 1)
        proof_.refuse("the rules for a module " + module.letter + " have the sum " +
                      to_string(sum) + " of probabilities");
    return all;
}

double Chance::value(const Term& term, const ModuleSystem::Rule& rule, const Module& module) const {
    if (term.kind == Term::Kind::number) return term.number;
    if (term.kind == Term::Kind::parameter) {
        const auto found = std::find(rule.parameters.begin(), rule.parameters.end(), term.name);
        if (found == rule.parameters.end())
            proof_.fail("a rule for " + term.name + " has a parameter that is not its module's");
        return module.values[static_cast<std::size_t>(found - rule.parameters.begin())];
    }
    const auto part = [&](std::size_t i) { return value(term.parts[i], rule, module); };
    const std::string& name = term.name;
    const std::size_t count = term.parts.size();
    const double x = part(0);
    double result = std::nan("");
    if (count == 1 && name == "-")
        result = -x;
    else if (count == 1 && name == "!")
        result = x == 0;
    else if (name == "abs")
        result = std::abs(x);
    else if (name == "floor")
        result = std::floor(x);
    else if (name == "ceil")
        result = std::ceil(x);
    else if (name == "sqrt")
        result = std::sqrt(x);
    else if (name == "&")
        result = x != 0 && part(1) != 0;
    else if (name == "|")
        result = x != 0 || part(1) != 0;
    else if (name == "min" || name == "max") {
        result = x;
        for (std::size_t i = 1; i < count; ++i)
            result = name == "min" ? std::min(result, part(i)) : std::max(result, part(i));
    } else if (count == 2) {
        const double y = part(1);
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
        else if (name == "<")
            result = x < y;
        else if (name == "<=")
            result = x <= y;
        else if (name == ">")
            result = x > y;
        else if (name == ">=")
            result = x >= y;
        else if (name == "=")
            result = x == y;
        else if (name == "!=")
            result = x != y;
        else
            throw BoundReached("the operation '" + name + "' is not worked out again");
    } else {
        throw BoundReached("the function '" + name + "' is not worked out again");
    }
    if (!std::isfinite(result)) proof_.refuse("an expression of a rule has no value");
    return result;
}

}  // namespace

Rational probability(const Field& field) {
    const std::string& text = field.text();
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto is_number = [](std::string_view digits) {
        return !digits.empty() && std::all_of(digits.begin(), digits.end(),
                                              [](char c) { return c >= '0' && c <= '9'; });
    };
    const std::string below = slash == text.size() ? "1" : text.substr(slash + 1);
    if (!is_number(text.substr(0, slash)) || !is_number(below) || Integer(below) == 0)
        field.fail("expected a probability, found '" + text + "'");
    return Rational(Integer(text.substr(0, slash)), Integer(below));
}

Modules modules(const Field& field) {
    Modules word;
    for (const Field& each : field.list()) {
        const auto [letter, values] = module(each);
        word.push_back({letter, {}});
        for (const Field& value : values) word.back().values.push_back(number(value));
    }
    return word;
}

ModuleSystem module_system(const Field& field) {
    field.only({"axiom", "modules"});
    ModuleSystem system;
    system.axiom = modules(field.at("axiom"));
    for (const Field& each : field.at("modules").list()) system.rules.push_back(rule(each));
    return system;
}

Rational chance(const ModuleSystem& system, const Modules& from, const Modules& to,
                const Integer& steps, const Field& proof, const Budget& budget) {
    constexpr std::uint64_t most = 1000;  // each step is a level of the recursion
    if (steps > Integer(static_cast<long>(most)))
        throw BoundReached("only derivations of at most 1000 steps are worked out again");
    if (std::any_of(system.rules.begin(), system.rules.end(),
                    [](const ModuleSystem::Rule& rule) { return rule.looks_around; }))
        throw BoundReached("rules that look at other modules are not worked out again");
    return Chance(system, to, proof, budget).of(from, steps.to_uint64());
}

}  // namespace algae::verify
