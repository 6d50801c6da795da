#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>

#include "model/model.hpp"
#include "oracle/modules.hpp"
#include "oracle/random_systems.hpp"
#include "rewrite/words.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

std::string any(const std::vector<std::string>& texts) { return *rc::gen::elementOf(texts); }

int below(int bound) { return *rc::gen::inRange(0, bound); }

/// An expression over these names, with few that have no value.
std::string any_expression(const std::vector<std::string>& names, int depth) {
    if (depth == 0 || below(4) == 0) {
        if (!names.empty() && below(3) > 0) return any(names);
        return any({"0", "1", "2", "3", "0.5", "0.1", "90", "k"});
    }
    const auto part = [&] { return any_expression(names, depth - 1); };
    switch (below(9)) {
        case 0:
            return "(-" + part() + ")";
        case 1:
            return any({"abs", "floor", "ceil", "sin", "cos", "tan", "atan"}) + "(" + part() + ")";
        case 2:
            return any({"sqrt", "log", "exp", "asin", "acos"}) + "(" + part() + "/3)";
        case 3:
            return any({"min", "max"}) + "(" + part() + "," + part() + "," + part() + ")";
        case 4:
            return "(" + part() + any({"/", "^"}) + part() + ")";
        default:
            return "(" + part() + any({"+", "-", "*", "+", "-"}) + part() + ")";
    }
}

std::string any_condition(const std::vector<std::string>& names, int depth) {
    if (depth > 0 && below(3) == 0)
        return "(" + any_condition(names, depth - 1) + any({"&", "|"}) +
               any_condition(names, depth - 1) + ")";
    if (below(8) == 0) return "!(" + any_condition(names, 0) + ")";
    return "(" + any_expression(names, 1) + any({" < ", " <= ", " > ", " >= ", " = ", " != "}) +
           any_expression(names, 1) + ")";
}

/// A word of A, B(x), C(x,y) and brackets, with these names in its arguments.
std::string any_modules(const std::vector<std::string>& names, int most, bool brackets,
                        int depth = 2) {
    std::string out;
    for (int i = below(most + 1); i > 0; --i) {
        switch (below(brackets ? 6 : 5)) {
            case 0:
                out += "A";
                break;
            case 1:
                out += "+";
                break;
            case 2:
            case 3:
                out += "B(" + any_expression(names, depth) + ")";
                break;
            case 4:
                out +=
                    "C(" + any_expression(names, depth) + "," + any_expression(names, depth) + ")";
                break;
            default:
                out += "[" + any_modules(names, 2, false, depth) + "]";
        }
    }
    return out;
}

/// A module of a left side; its parameters are new names.
std::string any_pattern(std::vector<std::string>& names) {
    const auto name = [&] {
        names.push_back(std::string(1, static_cast<char>('p' + names.size())));
        return names.back();
    };
    switch (below(3)) {
        case 0:
            return "A";
        case 1:
            return "B(" + name() + ")";
        default: {
            const std::string first = name();
            return "C(" + first + "," + name() + ")";
        }
    }
}

std::string any_rule(bool contexts) {
    std::vector<std::string> names;
    std::string rule = any_pattern(names);
    if (contexts) {
        std::string left, right;
        for (int i = below(3); i > 0; --i) left += any_pattern(names);
        for (int i = below(2); i > 0; --i)
            right += below(2) ? any_pattern(names) : "[" + any_pattern(names) + "]";
        if (!left.empty()) rule = left + " < " + rule;
        if (!right.empty()) rule += " > " + right;
    }
    if (below(3) > 0) rule += " : " + any_condition(names, 1);
    return rule + " -> " + any_modules(names, 4, contexts);
}

std::string any_system(bool contexts) {
    std::string text = "let k = 7/3; axiom A" + any_modules({}, 6, contexts, 1) + "B(1)C(2,3)";
    for (int i = 1 + below(6); i > 0; --i)
        text += "; " + any_rule(contexts) + "D(" + std::to_string(i) + ")";
    if (contexts && below(2)) text += "; ignore +";
    return text;
}

/// Whether the engine derives what the slow route derives, and refuses what it refuses.
void check_as_slow_route(const std::string& text, unsigned n) {
    const LSystem system = read_lsystem(text, "random.lsys");
    RC_LOG() << text << "\n";
    std::optional<Rewriting> compiled;
    try {
        compiled.emplace(system, RewritingChoices{.threads = 3});
    } catch (const Diagnostics&) {
        return;  // a part without parameters has no value
    }
    const Rewriting& rewriting = *compiled;
    std::optional<std::vector<oracle::Modules>> slow;
    for (; n > 0; --n) {  // words must not be too long for the slow route
        slow = oracle::module_words(system, n);
        if (!slow || slow->back().size() < 300) break;
    }
    std::optional<ModuleString> fast;
    try {
        fast = derive(rewriting, n);
    } catch (const Error&) {
    } catch (const BoundReached&) {
    }
    RC_ASSERT(fast.has_value() == (n == 0 || slow.has_value()));
    if (!slow || n == 0) return;
    std::size_t value = 0;
    oracle::Modules found;
    for (const ModuleKind kind : fast->kinds) {
        found.push_back({system.alphabet.name(rewriting.rules().kinds.letter(kind)), {}});
        for (std::uint32_t i = 0; i < rewriting.rules().kinds.arity(kind); ++i)
            found.back().values.push_back(fast->values[value++]);
    }
    RC_ASSERT(found == slow->back());
}

}  // namespace

TEST_CASE("parametric words are those of a walk through the expressions") {
    CHECK(rc::check([] { check_as_slow_route(any_system(false), 4); }));
}

TEST_CASE("so they are with contexts, brackets and ignored letters") {
    CHECK(rc::check([] { check_as_slow_route(any_system(true), 3); }));
}

TEST_CASE("so they are with conditions on modules elsewhere") {
    CHECK(rc::check([] {
        std::string text = "let k = 7/3; axiom B(1)" + any_modules({}, 5, true, 1) + "C(2,3)A";
        for (int i = 1 + below(3); i > 0; --i) {
            const std::string condition =
                "x" + any({"+", "*", "-"}) + "y" + any({" < ", " >= ", " = "}) + "z" +
                any({"", "+1", "*x"}) + any({"", " & y < 3", " & y < z & x != 2", " | y > 2"});
            text += "; B(x) ? B(y), C(z,w) : " + condition + " -> " +
                    any_modules({"x", "y", "z"}, 3, false, 1) + "D" + std::to_string(i);
            text += "; A > B(x) ? C(y,z), B(w) : " + condition + " & w > 1 -> A" +
                    any_modules({"x", "w"}, 2, false, 1) + "E" + std::to_string(i);
        }
        check_as_slow_route(text, 2);
    }));
}

TEST_CASE("a D0L system without parameters has its words") {
    CHECK(rc::check([] {
        const auto written = *oracle::any_d0l();
        const unsigned n = oracle::last_generation_within(written, 5000, 8);
        const Rewriting rewriting(oracle::lsystem_of(written));
        const ModuleText text(rewriting.rules().system->alphabet, rewriting.rules().kinds);
        const std::string word = oracle::rewritten(written, n);
        RC_ASSERT(text.text(derive(rewriting, n)) == (word.empty() ? "ε" : word));
    }));
}

TEST_CASE("read as stochastic with probability 1 it has the same words, whatever the seed") {
    CHECK(rc::check([](std::uint64_t seed) {
        const auto written = *oracle::any_d0l();
        const unsigned n = oracle::last_generation_within(written, 5000, 8);
        LSystem system = oracle::lsystem_of(written);
        for (Production& rule : system.rules) rule.probability = Rational(1);
        const Rewriting rewriting(system, {.seed = seed});
        const ModuleText text(rewriting.rules().system->alphabet, rewriting.rules().kinds);
        const std::string word = oracle::rewritten(written, n);
        RC_ASSERT(text.text(derive(rewriting, n)) == (word.empty() ? "ε" : word));
    }));
}

TEST_CASE("with the same parameter everywhere it has the same letters") {
    CHECK(rc::check([] {
        const auto written = *oracle::any_d0l();
        const unsigned n = oracle::last_generation_within(written, 5000, 8);
        LSystem system = oracle::lsystem_of(written);
        const auto dress = [](ModuleWord& word, Expression value) {
            for (std::size_t i = 0; i < word.letters.size(); ++i) word.arguments[i] = {value};
        };
        dress(system.axiom, read_expression("3"));
        for (Production& rule : system.rules) {
            rule.predecessor.parameters = {"x"};
            dress(rule.successor, read_expression("x"));
        }
        const Rewriting rewriting(system);
        const ModuleString word = derive(rewriting, n);
        std::string letters;
        for (const ModuleKind kind : word.kinds)
            letters += system.alphabet.name(rewriting.rules().kinds.letter(kind));
        RC_ASSERT(letters == oracle::rewritten(written, n));
        RC_ASSERT(word.values.size() == word.kinds.size());
        for (const double value : word.values) RC_ASSERT(value == 3);
    }));
}

TEST_CASE(
    "systems with context over plain letters have the words that the engine for these derives") {
    CHECK(rc::check([] {
        const auto letters = [](int most) {
            std::string out;
            for (int i = below(most + 1); i > 0; --i) out += any({"a", "b", "c"});
            return out;
        };
        std::string text = "axiom ab[" + letters(3) + "]" + letters(2) + "[b[" + letters(2) +
                           "]c]" + letters(4) + "a";
        for (int i = 2 + below(5); i > 0; --i) {
            const std::string left = letters(2);
            const std::string right =
                any({"", "", "a", "b", "[a]b", "[b]", "a[c]", "[a][b]", "[]"});
            text += "; " + (left.empty() ? "" : left + " < ") + any({"a", "b", "c"}) +
                    (right.empty() ? "" : " > " + right) + " -> " + letters(2) +
                    any({"", "", "[" + letters(2) + "]"});
        }
        if (below(2)) text += "; ignore c";
        const LSystem system = read_lsystem(text, "random.lsys");
        RC_LOG() << text << "\n";
        const View<IL> plain = as_dil(system);
        RC_PRE(bool(plain));
        const Rewriting rewriting(system);
        for (std::uint64_t n = 0; n <= 4; ++n)
            RC_ASSERT(algae::letters(rewriting.rules().kinds, derive(rewriting, n)) ==
                      derive(*plain, n));
    }));
}

TEST_CASE("read as a system with contexts of no letters it has the same words") {
    CHECK(rc::check([] {
        const auto written = *oracle::any_d0l();
        const unsigned n = oracle::last_generation_within(written, 5000, 8);
        const LSystem system = oracle::lsystem_of(written);
        const View<IL> interactive = as_il(system);
        RC_ASSERT(bool(interactive));
        std::string word;
        for (const Symbol a : derive(*interactive, n)) word += system.alphabet.name(a);
        RC_ASSERT(word == oracle::rewritten(written, n));
    }));
}

namespace {

/// Rules of a system with contexts of the same lengths everywhere, and with none; those in front first.
std::vector<std::array<std::string, 4>> any_context_rules(std::size_t left, std::size_t right) {
    const auto letters = [](std::size_t count) {
        std::string out;
        for (; count > 0; --count) out += any({"a", "b"});
        return out;
    };
    std::vector<std::array<std::string, 4>> rules;
    const auto add = [&](std::size_t before, std::size_t behind) {
        std::array<std::string, 4> rule{letters(before), letters(1), letters(behind),
                                        letters(static_cast<std::size_t>(below(3)))};
        for (const auto& known : rules)
            if (known[0] == rule[0] && known[1] == rule[1] && known[2] == rule[2]) return;
        rules.push_back(std::move(rule));
    };
    for (int i = 1 + below(6); i > 0; --i) add(left, right);
    if (below(2)) add(0, 0);
    return rules;
}

std::string rules_text(const std::vector<std::array<std::string, 4>>& rules) {
    std::string text;
    for (const auto& [left, letter, right, successor] : rules)
        text += "; " + (left.empty() ? "" : left + " < ") + letter +
                (right.empty() ? "" : " > " + right) + " -> " + successor;
    return text;
}

}  // namespace

TEST_CASE(
    "a (k,l) system has the words of its (k+1,l+1) form, with any letter or the end of the word "
    "around") {
    CHECK(rc::check([] {
        const auto rules = any_context_rules(static_cast<std::size_t>(below(3)),
                                             static_cast<std::size_t>(below(3)));
        std::vector<std::array<std::string, 4>> padded;
        for (const auto& [left, letter, right, successor] : rules)
            for (const char* before : {"a", "b", ""})
                for (const char* behind : {"a", "b", ""})
                    padded.push_back({before + left, letter, right + behind, successor});
        const std::string axiom = "axiom " + *oracle::any_nonempty_word("ab", 6) + "ab";
        RC_LOG() << axiom << rules_text(rules) << "\n";
        // Of padded rules that are the same the one from the longer context stands first.
        std::vector<std::array<std::string, 4>> once;
        for (const auto& rule : padded)
            if (std::none_of(once.begin(), once.end(), [&](const auto& known) {
                    return known[0] == rule[0] && known[1] == rule[1] && known[2] == rule[2];
                }))
                once.push_back(rule);
        unsigned n = 0;
        std::vector<std::string> all = words(axiom + rules_text(rules), 0);
        while (n < 4 && all.back().size() < 2000) all = words(axiom + rules_text(rules), ++n);
        RC_ASSERT(words(axiom + rules_text(once), n) == all);
        const LSystem system = read_lsystem(axiom + rules_text(once), "padded.lsys");
        const std::string text = spell(system.alphabet, derive(*as_il(system), n));
        RC_ASSERT(text == all.back());
    }));
}

TEST_CASE("the word does not depend on the number of threads, whatever the system") {
    CHECK(rc::check([](std::uint64_t seed) {
        const LSystem system = read_lsystem(any_system(below(2)), "random.lsys");
        const auto word = [&](unsigned threads) -> std::optional<ModuleString> {
            try {
                Budget budget;
                budget.letters = 20'000;
                return derive(Rewriting(system, {.seed = seed, .evenly = true, .threads = threads}),
                              5, {}, budget);
            } catch (const Error&) {
                return std::nullopt;
            } catch (const BoundReached&) {
                return std::nullopt;
            }
        };
        const auto one = word(1);
        RC_ASSERT(word(2) == one);
        RC_ASSERT(word(3) == one);
    }));
}
