#include "verify/modules.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <locale>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "base/error.hpp"

namespace algae::verify {

namespace {

/// Whether the whole text is a decimal number that a double holds.
bool read_decimal(const std::string& text, double& value) {
#ifdef __cpp_lib_to_chars
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
#else  // a library that converts integers only
    if (text.find_first_not_of("0123456789-.eE+") != std::string::npos || text.starts_with('+'))
        return false;
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    return in >> value && in.peek() == std::istringstream::traits_type::eof();
#endif
}

double number(const Field& field) {
    const std::string& text = field.text();
    double value = 0;
    if (!read_decimal(text, value) || !std::isfinite(value))
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

ModuleSystem::Pattern pattern(const Field& field) {
    const auto [letter, parameters] = module(field);
    ModuleSystem::Pattern read{letter, {}};
    for (const Field& name : parameters) read.parameters.push_back(name.text());
    return read;
}

ModuleSystem::Rule rule(const Field& field) {
    field.only({"module", "left", "right", "elsewhere", "condition", "probability", "successor"});
    ModuleSystem::Rule read;
    read.module = pattern(field.at("module"));
    const auto around = [&](const char* name, std::vector<ModuleSystem::Pattern>& patterns) {
        if (!field.has(name)) return;
        for (const Field& each : field.at(name).list()) patterns.push_back(pattern(each));
    };
    around("left", read.left);
    around("right", read.right);
    around("elsewhere", read.elsewhere);
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
    Rational of_part(const Modules& word, std::uint64_t steps, std::size_t begin, std::size_t end);
    Rational of_module(const Module& module, std::uint64_t steps, std::size_t begin,
                       std::size_t end);

    const ModuleSystem& system_;
    const Modules& to_;
    const Field& proof_;
    const Budget& budget_;
    std::map<Module, Choices> choices_;
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
    const Rational as_it_is(end == begin + 1 && to_[begin] == module ? 1 : 0);
    if (steps == 0) return as_it_is;
    const auto [entry, is_new] = choices_.try_emplace(module);
    if (is_new) entry->second = choices(system_, {module}, 0, proof_);
    const Choices& next = entry->second;
    if (next.empty()) return as_it_is;
    const std::tuple key(module, steps, begin, end);
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    Rational sum;
    for (const auto& [probability, successor] : next)
        sum += probability * of_part(successor, steps - 1, begin, end);
    known_.emplace(key, sum);
    budget_.check_memory(known_.size() * 300, "the probabilities of parts of a word");
    return sum;
}

/// By deriving all words.
Rational walked(const ModuleSystem& system, const Modules& from, const Modules& to,
                std::uint64_t steps, const Field& proof, const Budget& budget) {
    constexpr std::size_t most = 10'000;
    std::map<Modules, Rational> words{{from, Rational(1)}};
    for (std::uint64_t n = 0; n < steps; ++n) {
        std::map<Modules, Rational> all;
        for (const auto& [word, share] : words) {
            std::map<Modules, Rational> made{{{}, share}};
            for (std::size_t i = 0; i < word.size(); ++i) {
                budget.check();
                Choices next = choices(system, word, i, proof);
                if (next.empty()) next.push_back({Rational(1), {word[i]}});
                std::map<Modules, Rational> longer;
                for (const auto& [beginning, part] : made)
                    for (const auto& [probability, successor] : next) {
                        Modules whole = beginning;
                        whole.insert(whole.end(), successor.begin(), successor.end());
                        longer[std::move(whole)] += part * probability;
                    }
                made = std::move(longer);
                if (made.size() > most)
                    throw BoundReached(Bound::method,
                                       "more than 10,000 words are not derived again");
            }
            for (const auto& [whole, part] : made) all[whole] += part;
            if (all.size() > most)
                throw BoundReached(Bound::method, "more than 10,000 words are not derived again");
        }
        words = std::move(all);
    }
    const auto found = words.find(to);
    return found == words.end() ? Rational(0) : found->second;
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
    field.only({"axiom", "modules", "ignored"});
    ModuleSystem system;
    system.axiom = modules(field.at("axiom"));
    for (const Field& each : field.at("modules").list()) system.rules.push_back(rule(each));
    if (field.has("ignored"))
        for (const Field& letter : field.at("ignored").list()) system.ignored.insert(letter.text());
    return system;
}

Rational chance(const ModuleSystem& system, const Modules& from, const Modules& to,
                const Integer& steps, const Field& proof, const Budget& budget) {
    constexpr std::uint64_t most = 1000;  // each step is a level of the recursion
    if (steps > Integer(most))
        throw BoundReached(Bound::method,
                           "only derivations of at most 1000 steps are worked out again");
    if (std::any_of(system.rules.begin(), system.rules.end(), [](const ModuleSystem::Rule& rule) {
            return !rule.left.empty() || !rule.right.empty() || !rule.elsewhere.empty();
        }))
        return walked(system, from, to, steps.to_uint64(), proof, budget);
    return Chance(system, to, proof, budget).of(from, steps.to_uint64());
}

}  // namespace algae::verify
