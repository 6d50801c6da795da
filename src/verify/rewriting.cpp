#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "exact/exact.hpp"
#include "verify/verify.hpp"

// Systems with parameters and probabilities: the probability that a word of modules derives another one, by a recursion over
// the word that shares nothing with the engines of `rewrite`. Contexts and modules elsewhere in the word are matched
// by definition, position by position.

namespace algae::verify {

namespace {

/// A decimal, with an exponent or without, or a fraction; of at most 10,000 digits.
Rational number(const Field& field) {
    const std::string& text = field.text();
    constexpr std::size_t longest = 20'000, longest_exponent = 4;
    const auto digits = [](std::string_view all) {
        return !all.empty() && all.find_first_not_of("0123456789") == std::string_view::npos;
    };
    std::string_view rest = text;
    if (rest.starts_with('-')) rest.remove_prefix(1);
    const std::size_t slash = rest.find('/'), exponent = std::min(rest.find('e'), rest.size());
    bool is_number = rest.size() <= longest;
    if (slash != std::string_view::npos) {
        is_number = is_number && digits(rest.substr(0, slash)) && digits(rest.substr(slash + 1)) &&
                    rest.find_first_not_of('0', slash + 1) != std::string_view::npos;
    } else {
        const std::string_view mantissa = rest.substr(0, exponent);
        const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
        std::string_view power = rest.substr(std::min(exponent + 1, rest.size()));
        if (power.starts_with('-')) power.remove_prefix(1);
        is_number =
            is_number && digits(mantissa.substr(0, point)) &&
            (point == mantissa.size() || digits(mantissa.substr(point + 1))) &&
            (exponent == rest.size() || (digits(power) && power.size() <= longest_exponent));
    }
    if (!is_number) field.fail("expected a number, found '" + beginning(text, 60) + "'");
    return Rational(text);
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
    read.successor = modules(field.at("successor"));
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

WrittenModules modules(const Field& field) {
    WrittenModules word;
    for (const Field& each : field.list()) {
        const auto [letter, arguments] = module(each);
        auto& [next, terms] = word.emplace_back();
        next = letter;
        for (const Field& argument : arguments) terms.push_back(term(argument));
    }
    return word;
}

ModuleSystem module_system(const Field& field) {
    field.only({"axiom", "modules", "ignored"});
    ModuleSystem system;
    system.axiom = modules(field.at("axiom"));
    for (const Field& each : field.at("modules").list()) {
        system.rules.push_back(rule(each));
        const ModuleSystem::Rule& read = system.rules.back();
        if (std::max({read.left.size(), read.right.size(), read.elsewhere.size()}) > 1'000)
            each.fail("more than 1000 modules around one");
    }
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
            if (close == to) proof_.refuse("the brackets of a right context do not match");
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
            return !rule.condition || sign(value(*rule.condition, names, proof_)) != 0;
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
        Modules successor = values(rule.successor, match.names, proof);
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

QuadraticNumber number_of(Rational value) { return {std::move(value), 0, 1}; }
QuadraticNumber truth(bool holds) { return number_of(holds ? 1 : 0); }

[[noreturn]] void left_out(const std::string& what) {
    throw BoundReached(Bound::method, what + " is not worked out again");
}

QuadraticNumber combination(const QuadraticNumber& x, char operation, const QuadraticNumber& y) {
    const auto made = combined(x, operation, y);
    if (!made) left_out("arithmetic with the roots of different numbers");
    return *made;
}

/// -1, 0 or 1 as x is less than y, equal or greater.
int order(const QuadraticNumber& x, const QuadraticNumber& y) {
    return sign(combination(x, '-', y));
}

QuadraticNumber negative(const QuadraticNumber& x) { return {-x.rational, -x.factor, x.radicand}; }

QuadraticNumber root(const QuadraticNumber& square, const Field& proof) {
    if (sign(square) < 0) proof.refuse("a square root of a negative number has no value");
    if (sign(square) == 0) return {};
    const auto found = square.is_rational() ? square_root(square.rational) : std::nullopt;
    if (!found) left_out("a square root of a root or a large number");
    return *found;
}

QuadraticNumber raised(const QuadraticNumber& base, const QuadraticNumber& exponent,
                       const Field& proof) {
    if (sign(base) == 0 && sign(exponent) < 0) proof.refuse("a negative power of 0 has no value");
    const Rational twice = exponent.rational * 2;
    constexpr int most = 40'000;
    if (!exponent.is_rational() || !twice.is_integer() || abs(twice) > most)
        left_out("a power that is neither half a number nor one, or above 20,000,");
    const QuadraticNumber of = exponent.rational.is_integer() ? base : root(base, proof);
    const Integer times =
        abs(exponent.rational.is_integer() ? exponent.rational : twice).numerator();
    if (times * Integer(bit_length(base.rational.numerator()) +
                        bit_length(base.rational.denominator())) >
        Integer(1'000'000))
        left_out("so large a power");
    QuadraticNumber made = number_of(1);
    for (std::uint64_t left = times.to_uint64(); left > 0; --left)
        made = combination(made, '*', of);
    return sign(exponent) < 0 ? combination(number_of(1), '/', made) : made;
}

QuadraticNumber absolute(const QuadraticNumber& x) { return sign(x) < 0 ? negative(x) : x; }

/// The greatest whole number that is not above.
QuadraticNumber floor_of(const QuadraticNumber& x) {
    if (x.is_rational()) return number_of(floor(x.rational));
    Integer low = -1, high = 1;
    while (order(number_of(low), x) > 0) low *= 2;
    while (order(number_of(high), x) <= 0) high *= 2;
    while (high - low > 1) {
        const Integer middle = floor_divide(low + high, 2);
        (order(number_of(middle), x) <= 0 ? low : high) = middle;
    }
    return number_of(low);
}

const std::map<std::string, std::function<QuadraticNumber(const QuadraticNumber&)>> of_one{
    {"-", negative},
    {"!", [](const QuadraticNumber& x) { return truth(sign(x) == 0); }},
    {"abs", absolute},
    {"floor", floor_of},
    {"ceil", [](const QuadraticNumber& x) { return negative(floor_of(negative(x))); }}};

using OfTwo = std::function<QuadraticNumber(const QuadraticNumber&, const QuadraticNumber&)>;
const std::map<std::string, OfTwo> of_two{
    {"<", [](const auto& x, const auto& y) { return truth(order(x, y) < 0); }},
    {"<=", [](const auto& x, const auto& y) { return truth(order(x, y) <= 0); }},
    {">", [](const auto& x, const auto& y) { return truth(order(x, y) > 0); }},
    {">=", [](const auto& x, const auto& y) { return truth(order(x, y) >= 0); }},
    {"=", [](const auto& x, const auto& y) { return truth(x == y); }},
    {"!=", [](const auto& x, const auto& y) { return truth(!(x == y)); }},
    {"min", [](const auto& x, const auto& y) { return order(y, x) < 0 ? y : x; }},
    {"max", [](const auto& x, const auto& y) { return order(x, y) < 0 ? y : x; }},
    {"+", [](const auto& x, const auto& y) { return combination(x, '+', y); }},
    {"-", [](const auto& x, const auto& y) { return combination(x, '-', y); }},
    {"*", [](const auto& x, const auto& y) { return combination(x, '*', y); }}};

}  // namespace

QuadraticNumber value(const Term& term, const Bindings& names, const Field& proof) {
    if (term.kind == Term::Kind::number) return number_of(term.number);
    const std::string& name = term.name;
    if (term.kind == Term::Kind::parameter) {
        const auto found = names.find(name);
        if (found == names.end())
            proof.refuse("a rule has the parameter " + name + " of no module");
        return found->second;
    }
    const std::size_t count = term.parts.size();
    const auto part = [&](std::size_t i) { return value(term.parts[i], names, proof); };
    const QuadraticNumber x = part(0);
    QuadraticNumber result = x;
    if (count == 1 && name == "sqrt") {
        result = root(x, proof);
    } else if (count == 1 && of_one.contains(name)) {
        result = of_one.at(name)(x);
    } else if (count == 2 && (name == "&" || name == "|")) {
        result = truth((sign(x) == 0) == (name == "&") ? sign(x) != 0 : sign(part(1)) != 0);
    } else if (count == 2 && name == "^") {
        result = raised(x, part(1), proof);
    } else if (count == 2 && name == "/") {
        const QuadraticNumber y = part(1);
        if (sign(y) == 0) proof.refuse("a division by 0 has no value");
        result = combination(x, '/', y);
    } else if (count == 2 ? of_two.contains(name) : name == "min" || name == "max") {
        for (std::size_t i = 1; i < count; ++i) result = of_two.at(name)(result, part(i));
    } else {
        left_out("'" + name + "'");
    }
    constexpr std::uint64_t longest = 40'000;  // bits
    for (const Rational* each : {&result.rational, &result.factor})
        if (bit_length(each->numerator()) > longest || bit_length(each->denominator()) > longest)
            throw BoundReached(Bound::method, "a number has more than 10,000 digits");
    return result;
}

Modules values(const WrittenModules& word, const Bindings& names, const Field& proof) {
    Modules all;
    for (const auto& [letter, arguments] : word) {
        all.push_back({letter, {}});
        for (const Term& argument : arguments)
            all.back().values.push_back(value(argument, names, proof));
    }
    return all;
}

}  // namespace algae::verify
