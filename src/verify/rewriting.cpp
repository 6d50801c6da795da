#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <locale>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "exact/exact.hpp"
#include "verify/verify.hpp"

// Systems with parameters and probabilities: the probability that a word of modules derives another one, by a recursion over
// the word that shares nothing with the engines of `rewrite`. Contexts and modules elsewhere in the word are matched
// by definition, position by position.

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
        if (read.parts.empty()) field.at("to").fail("an operation must have an operand");
    }
    return read;
}

/// The letter and what stands behind it.
std::pair<std::string, std::vector<Field>> module(const Field& field) {
    std::vector<Field> parts = field.list();
    if (parts.empty()) field.fail("a module must have a letter");
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
    Rational of_part(const Modules& word, std::uint64_t steps, std::size_t begin, std::size_t end) {
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
    Rational of_module(const Module& module, std::uint64_t steps, std::size_t begin,
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

    const ModuleSystem& system_;
    const Modules& to_;
    const Field& proof_;
    const Budget& budget_;
    std::map<Module, Choices> choices_;
    std::map<std::tuple<Module, std::uint64_t, std::size_t, std::size_t>, Rational> known_;
};

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

namespace {

const std::map<std::string, std::function<double(double)>> of_one{
    {"-", std::negate<double>()},
    {"!", std::logical_not<double>()},
    {"abs", [](double x) { return std::abs(x); }},
    {"floor", [](double x) { return std::floor(x); }},
    {"ceil", [](double x) { return std::ceil(x); }},
    {"sqrt", [](double x) { return std::sqrt(x); }}};

const std::map<std::string, std::function<double(double, double)>> of_two{
    {"<", std::less<double>()},
    {"<=", std::less_equal<double>()},
    {">", std::greater<double>()},
    {">=", std::greater_equal<double>()},
    {"=", std::equal_to<double>()},
    {"!=", std::not_equal_to<double>()},
    {"+", std::plus<double>()},
    {"-", std::minus<double>()},
    {"*", std::multiplies<double>()},
    {"/", std::divides<double>()},
    {"^", [](double x, double y) { return std::pow(x, y); }}};

}  // namespace

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
    double result = x;
    if (name == "min" || name == "max") {
        for (std::size_t i = 1; i < count; ++i)
            result = name == "min" ? std::min(result, part(i)) : std::max(result, part(i));
    } else if (count == 1 && of_one.contains(name)) {
        result = of_one.at(name)(x);
    } else if (count == 2 && (name == "&" || name == "|")) {
        result = (x != 0) == (name == "|") ? x != 0 : part(1) != 0;
    } else if (count == 2) {
        const double y = part(1);
        const auto found = of_two.find(name);
        if (found == of_two.end())
            throw BoundReached(Bound::method,
                               "the operation '" + name + "' is not worked out again");
        result = found->second(x, y);
    } else {
        throw BoundReached(Bound::method, "the function '" + name + "' is not worked out again");
    }
    if (!std::isfinite(result)) proof.refuse("an expression of a rule has no value");
    return result;
}

}  // namespace algae::verify
