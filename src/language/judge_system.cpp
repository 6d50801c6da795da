#include "language/detail/judge.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "growth/growth.hpp"
#include "word/word.hpp"

// What statements say of systems: derivations, equal sequences, equal growth, growth formulas and classes.
//
// A derivation in a given number of steps is decided by the table of factors with one table; with several, by a
// system that counts the steps in copies of its letters. A formula for the growth is read as a sum of terms c
// n^k r^n, which obeys a linear recurrence whose order is known, as do the lengths; so as many first terms as
// both orders together decide whether they agree for ever.

namespace algae {

namespace {

using Terms = std::map<Rational, std::vector<Rational>>;

constexpr std::size_t highest_degree = 200;
constexpr std::size_t most_terms = 1000;

[[noreturn]] void fail(const Expression& part, const std::string& expected) {
    const std::string where = part.place.line == 0 ? "" : to_string(part.place) + ": ";
    throw Error(where + "expected " + expected + ", found " + to_text(part));
}

void trim(Terms& terms) {
    for (auto entry = terms.begin(); entry != terms.end();) {
        auto& coefficients = entry->second;
        while (!coefficients.empty() && coefficients.back().is_zero()) coefficients.pop_back();
        entry = coefficients.empty() ? terms.erase(entry) : std::next(entry);
    }
}

Terms sum(Terms left, const Terms& right, const Rational& times) {
    for (const auto& [base, coefficients] : right) {
        auto& target = left[base];
        target.resize(std::max(target.size(), coefficients.size()));
        for (std::size_t i = 0; i < coefficients.size(); ++i) target[i] += times * coefficients[i];
    }
    trim(left);
    return left;
}

Terms product(const Terms& left, const Terms& right, const Expression& part) {
    Terms result;
    for (const auto& [base, coefficients] : left)
        for (const auto& [other, factors] : right) {
            auto& target = result[base * other];
            target.resize(std::max(target.size(), coefficients.size() + factors.size() - 1));
            for (std::size_t i = 0; i < coefficients.size(); ++i)
                for (std::size_t j = 0; j < factors.size(); ++j)
                    target[i + j] += coefficients[i] * factors[j];
            if (target.size() > highest_degree || result.size() > most_terms)
                fail(part, "a smaller formula");
        }
    trim(result);
    return result;
}

Terms constant(const Rational& value) {
    Terms terms{{Rational(1), {value}}};
    trim(terms);
    return terms;
}

/// The value of terms without n.
std::optional<Rational> constant_of(const Terms& terms) {
    if (terms.empty()) return Rational(0);
    if (terms.size() > 1 || terms.begin()->first != Rational(1) || terms.begin()->second.size() > 1)
        return std::nullopt;
    return terms.begin()->second.front();
}

std::optional<long> small_integer(const Rational& value) {
    for (long n = -1000; n <= 1000; ++n)
        if (value == Rational(n)) return n;
    return std::nullopt;
}

Terms read(const Expression& expression);

Terms read_power(const Expression& expression) {
    const Terms base = read(expression.operands[0]), exponent = read(expression.operands[1]);
    if (const auto value = constant_of(exponent)) {
        const auto times = small_integer(*value);
        if (!times || *times < 0) fail(expression.operands[1], "an exponent from 0 to 1000");
        Terms result = constant(Rational(1));
        for (long i = 0; i < *times; ++i) result = product(result, base, expression);
        return result;
    }
    // r^(s n + t)
    const auto root = constant_of(base);
    if (!root || root->is_zero())
        fail(expression.operands[0],
             "a number that is not 0 as base of a power with n in its exponent");
    const bool linear = exponent.size() == 1 && exponent.begin()->first == Rational(1) &&
                        exponent.begin()->second.size() == 2;
    if (!linear) fail(expression.operands[1], "an exponent like 2n+1");
    const auto slope = small_integer(exponent.begin()->second[1]),
               start = small_integer(exponent.begin()->second[0]);
    if (!slope || !start) fail(expression.operands[1], "an exponent with whole numbers up to 1000");
    return {{power(*root, *slope), {power(*root, *start)}}};
}

Terms read_binary(const Expression& expression) {
    if (expression.name == "^") return read_power(expression);
    const Terms left = read(expression.operands[0]), right = read(expression.operands[1]);
    if (expression.name == "+") return sum(left, right, Rational(1));
    if (expression.name == "-") return sum(left, right, Rational(-1));
    if (expression.name == "*") return product(left, right, expression);
    if (expression.name == "/") {
        const auto divisor = constant_of(right);
        if (!divisor || divisor->is_zero())
            fail(expression.operands[1], "a number that is not 0 to divide by");
        return sum({}, left, Rational(1) / *divisor);
    }
    fail(expression, "a formula in n made by + - * / ^");
}

Terms read(const Expression& expression) {
    switch (expression.kind) {
        case Expression::Kind::number:
            return constant(expression.value);
        case Expression::Kind::name:
            if (expression.name == "n") return {{Rational(1), {Rational(0), Rational(1)}}};
            fail(expression, "n");
        case Expression::Kind::unary:
            if (expression.name == "-") return sum({}, read(expression.operands[0]), Rational(-1));
            fail(expression, "a formula in n made by + - * / ^");
        case Expression::Kind::binary:
            return read_binary(expression);
        default:
            fail(expression, "a formula in n made by + - * / ^");
    }
}

}  // namespace

Rational ExponentialPolynomial::operator()(std::uint64_t n) const {
    Rational value(0);
    for (const auto& [base, coefficients] : terms) {
        Rational polynomial(0);
        for (std::size_t i = coefficients.size(); i-- > 0;)
            polynomial = polynomial * Rational(n) + coefficients[i];
        value += polynomial * power(base, static_cast<std::int64_t>(n));
    }
    return value;
}

std::size_t ExponentialPolynomial::order() const {
    std::size_t order = 0;
    for (const auto& [base, coefficients] : terms) order += coefficients.size();
    return order;
}

ExponentialPolynomial exponential_polynomial(const Expression& expression) {
    return {read(expression)};
}

namespace {

using Json = nlohmann::ordered_json;

std::string derives(const SourceSystem& system, const Word& from, const Word& word,
                    const Alphabet& alphabet) {
    return system.name + ": " + spell(alphabet, from) + " ==> " + spell(alphabet, word);
}

Judgement walked(const SourceSystem& system, const Word& from, const Word& word,
                 std::uint64_t steps, const Alphabet& alphabet, const Budget& budget) {
    Derivation walk{{from}, {}};
    for (std::uint64_t n = 0; n < steps; ++n) {
        budget.check();
        walk.words.push_back(next_word(*system.interactive, walk.words.back()));
        if (walk.words.back().size() > budget.letters)
            throw BoundReached(Bound::letters,
                               "a word of " + system.name + " has more letters than allowed");
    }
    const std::string line =
        derives(system, from, walk.words.back(), alphabet) + " in " + counted(steps, "step");
    if (walk.words.back() == word)
        return Judgement::proved(
            {line + ": " + arrows(walk, alphabet) + "."},
            {{"by", "derivation"}, {"words", derivation_json(walk, alphabet)["words"]}});
    return Judgement::refuted({line + ", and nothing else."}, {{"by", "exhausted"}});
}

/// Why an 0L system does not derive the word in so many steps: the word that it derives, if it is one and short.
std::string derives_not(const OL& rules, const Word& word, std::uint64_t steps,
                        const Alphabet& alphabet) {
    constexpr std::size_t longest_shown = 60;
    const std::string from = spell(alphabet, rules.axiom), in = " in " + counted(steps, "step");
    Word reached = rules.axiom;
    std::uint64_t n = 0;
    for (bool one = true; n < steps && one && reached.size() <= longest_shown; n += one) {
        Word next;
        for (const Symbol a : reached) {
            one = one && rules.successors[a].size() == 1;
            next.insert(next.end(), rules.successors[a].front().begin(),
                        rules.successors[a].front().end());
        }
        if (one) reached = std::move(next);
    }
    if (n == steps && reached.size() <= longest_shown)
        return from + " ==> " + spell(alphabet, reached) + in + ", and nothing else.";
    return "No choice of rules makes " + spell(alphabet, word) + " of " + from + in +
           ": the factors of it that the letters derive in so many steps do not make it up.";
}

/// The proof that a derivation is.
Json derivation_proof(Json witness) {
    Json proof{{"by", "derivation"}};
    proof.update(witness);
    return proof;
}

/// That the axiom of a system without context derives the last word of the derivation.
Judgement derived(const SourceSystem& system, const Derivation& witness, const Alphabet& alphabet) {
    const std::size_t steps = witness.words.size() - 1;
    return Judgement::proved(
        {derives(system, witness.words.front(), witness.words.back(), alphabet) + " in " +
         counted(steps, "step") + (steps > 0 ? ": " + arrows(witness, alphabet) : "") + "."},
        derivation_proof(derivation_json(witness, alphabet)));
}

/// Whether an 0L system derives the word in exactly so many steps, with the derivation.
Judgement exact_steps(const SourceSystem& system, const OL& rules, const Word& word,
                      std::uint64_t steps, const Alphabet& alphabet, const Budget& budget) {
    if (const auto found = find_derivation(rules, word, steps, budget))
        return derived(system, *found, alphabet);
    return Judgement::refuted({derives_not(rules, word, steps, alphabet)}, {{"by", "exhausted"}});
}

/// The system with a copy of each letter for each of so many steps; copies for the last are the terminals.
ET0L counting(const ET0L& system, std::uint64_t steps) {
    const std::size_t letters = system.terminal.size();
    const auto copies = [&](Word word, std::uint64_t n) {
        for (Symbol& a : word) a += static_cast<Symbol>(n * letters);
        return word;
    };
    Alphabet alphabet;
    for (std::uint64_t n = 0; n <= steps; ++n)
        for (Symbol a = 0; a < letters; ++a)
            alphabet.symbol(std::to_string(n) + " " + system.alphabet->name(a));
    ET0L counted{
        std::make_shared<const Alphabet>(std::move(alphabet)), system.axiom,       {},
        std::vector<char>(letters * (steps + 1), 0),           system.table_names, system.name};
    for (const Table& table : system.tables) {
        Table& target = counted.tables.emplace_back();
        for (std::uint64_t n = 0; n < steps; ++n)
            for (Symbol a = 0; a < letters; ++a) {
                auto& choices = target.emplace_back();
                for (const Word& successor : table[a]) choices.push_back(copies(successor, n + 1));
            }
        for (Symbol a = 0; a < letters; ++a) target.push_back({copies({a}, steps)});
    }
    for (Symbol a = 0; a < letters; ++a) counted.terminal[a + steps * letters] = 1;
    return counted;
}

/// The same where there are several tables: whether the counting system derives the word in copies for the last step.
Judgement exact_steps_of_tables(const SourceSystem& source, const ET0L& system, const Word& word,
                                std::uint64_t steps, const Alphabet& alphabet,
                                const Budget& budget) {
    const std::size_t letters = system.terminal.size();
    if (steps > 1000)
        return Judgement::undecided({"with several tables at most 1000 steps are followed"});
    const ET0L copies = counting(system, steps);
    Word goal = word;
    for (Symbol& a : goal) a += static_cast<Symbol>(steps * letters);
    const Membership found = membership(copies, goal, budget);
    if (!found.member)
        return Judgement::refuted(
            {"No choice of tables and rules makes " + spell(alphabet, word) + " of " +
             spell(alphabet, system.axiom) + " in " + counted(steps, "step") +
             ": the factors of it that the letters derive in so many steps do not make it up."},
            {{"by", "exhausted"}});
    Derivation witness = derivation(copies, goal, found, budget);
    for (; witness.words.size() <= steps; witness.tables.push_back(0))
        witness.words.emplace_back();  // ε stays ε
    for (Word& reached : witness.words)
        for (Symbol& a : reached) a %= static_cast<Symbol>(letters);
    return derived(source, witness, alphabet);
}

}  // namespace

D0L as_d0l(const SourceSystem& system) {
    const auto refuse = [&](const std::string& reason) -> Error {
        return Error(system.name + " is not a D0L system: " + reason);
    };
    if (!system.tables) throw refuse("it has contexts");
    if (system.tables->tables.size() > 1) throw refuse("it has several tables");
    if (!has_only_terminals(*system.tables)) throw refuse("not all its letters are terminals");
    if (!is_deterministic(*system.tables)) throw refuse("a letter has several rules");
    std::vector<Word> images;
    for (const auto& choices : system.tables->tables.front()) images.push_back(choices.front());
    return make_d0l(system.tables->alphabet, system.tables->axiom, std::move(images), system.name);
}

Judgement judge_derivation(const Derives& said, const Alphabet& alphabet, const Budget& budget) {
    const auto& [source, word, from, steps] = said;
    const SourceSystem& system = *source;
    if (system.interactive) {
        SourceSystem moved = system;
        if (from) moved.interactive->axiom = *from;
        if (steps) return walked(moved, moved.interactive->axiom, word, *steps, alphabet, budget);
        Judgement found = judge_generated(moved, word, alphabet, budget);
        if (found.truth == Truth::refuted)
            found.proof = std::make_shared<const Json>(Json{{"by", "exhausted"}});
        if (found.truth == Truth::proved)
            found.proof =
                std::make_shared<const Json>(derivation_proof(found.proof->at("derivation")));
        return found;
    }
    ET0L moved = *system.tables;
    if (from) moved.axiom = *from;
    moved.terminal.assign(moved.terminal.size(), 1);  // derivations go through any letters
    if (steps) {
        if (moved.tables.size() > 1)
            return exact_steps_of_tables(system, moved, word, *steps, alphabet, budget);
        return exact_steps(system, without_terminals(moved), word, *steps, alphabet, budget);
    }
    const Membership found = membership(moved, word, budget);
    if (!found.member)
        return Judgement::refuted(
            {spell(alphabet, moved.axiom) + " does not derive " + spell(alphabet, word) + " by " +
             system.name + " in any number of steps."},
            {{"by", "exhausted"}});
    return derived(system, derivation(moved, word, found, budget), alphabet);
}

Judgement judge_sequences(const SourceSystem& left, const SourceSystem& right,
                          const Alphabet& alphabet, const Budget& budget) {
    const SequenceEquality found = equal_sequences(as_d0l(left), as_d0l(right), budget);
    if (found.equal)
        return Judgement::proved(
            {"Generation by generation the words of " + left.name + " and " + right.name +
             " are the same: along each of them the images by the two rules get apart by at most " +
             counted(found.balance->bound, "letter") + ", and " +
             (found.balance->states.size() == 1
                  ? "the one overflow that occurs suffices"
                  : "the " + std::to_string(found.balance->states.size()) +
                        " overflows that occur suffice") +
             " for all generations."},
            balance_certificate(*found.balance, alphabet));
    const SequenceDifference& difference = *found.difference;
    return Judgement::refuted(
        {"Generation " + std::to_string(difference.generation) +
         " is the first that differs: " + left.name + " has " + spell(alphabet, difference.left) +
         " and " + right.name + " has " + spell(alphabet, difference.right) + " from position " +
         to_string(difference.from) + " on."},
        difference_certificate(difference));
}

Judgement judge_growth(const SourceSystem& left, const SourceSystem& right, const Budget& budget) {
    const GrowthComparison found = equal_growth(as_d0l(left), as_d0l(right), budget);
    if (found.equal)
        return Judgement::proved(
            {"The lengths of generations 0 to " +
             std::to_string(found.bound == 0 ? 0 : found.bound - 1) +
             " are the same; both obey one recurrence whose order is the number of letters of both "
             "systems together, so all lengths are."},
            {{"by", "terms"}});
    return Judgement::refuted(
        {"In generation " + std::to_string(found.difference->generation) + " the lengths are " +
         to_string(found.difference->left) + " and " + to_string(found.difference->right) + "."},
        {{"by", "generation"}, {"generation", found.difference->generation}});
}

Judgement judge_growth_formula(const SourceSystem& system, const Expression& formula,
                               const Budget& budget) {
    const D0L rules = as_d0l(system);
    const ExponentialPolynomial function = exponential_polynomial(formula);
    const std::size_t terms = rules.letters.size() + function.order();
    const std::vector<Integer> found = lengths(rules, terms, budget);
    for (std::size_t n = 0; n < terms; ++n) {
        const Rational value = function(n);
        if (Rational(found[n]) != value)
            return Judgement::refuted(
                {"In generation " + std::to_string(n) + " the length is " + to_string(found[n]) +
                 ", and the formula gives " + to_string(value) + "."},
                {{"by", "generation"}, {"generation", n}});
    }
    Json powers = Json::array();
    for (const auto& [base, coefficients] : function.terms)
        for (std::size_t k = 0; k < coefficients.size(); ++k)
            powers.push_back({{"coefficient", to_string(coefficients[k])},
                              {"power", k},
                              {"base", to_string(base)}});
    return Judgement::proved(
        {"The lengths obey a recurrence of order " + std::to_string(rules.letters.size()) +
         " at most (as many as there are letters), the formula one of order " +
         std::to_string(function.order()) + "; generations 0 to " +
         std::to_string(terms == 0 ? 0 : terms - 1) + " agree, so all do."},
        {{"by", "terms"}, {"terms", powers}});
}

Judgement judge_growth_class(const HasGrowthClass& said, const Budget& budget) {
    const GrowthClass found = growth_class(as_d0l(*said.system), budget);
    const bool right = to_string(found.order.kind) == said.growth &&
                       (!said.degree || Integer(found.order.degree) == *said.degree);
    const std::vector<std::string> argument{
        "The length of generation n of " + said.system->name + " grows like " + found.order.text() +
        ": " + to_string(found.order.kind) +
        (found.order.kind == GrowthKind::polynomial
             ? " of degree " + std::to_string(found.order.degree)
             : "") +
        "."};
    const Json proof{{"by", "components"}};
    return right ? Judgement::proved(argument, proof) : Judgement::refuted(argument, proof);
}

}  // namespace algae
