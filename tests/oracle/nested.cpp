#include "oracle/nested.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <vector>

namespace algae::oracle {

namespace {

struct NoValue {};
struct TooMuch {};

struct Leaf;
using Tree = std::vector<Leaf>;

/// A number, or a word.
struct Thing {
    double number = 0;
    std::shared_ptr<const Tree> word;

    double as_number() const {
        if (word || !std::isfinite(number)) throw NoValue{};
        return number;
    }
    const Tree& as_word() const {
        if (!word) throw NoValue{};
        return *word;
    }
};

struct Leaf {
    std::string letter;
    std::vector<Thing> values;
};

using Bindings = std::map<std::string, Thing>;

class Derivation {
public:
    explicit Derivation(const LSystem& outer) : outer_(outer) {}

    Tree word(const LSystem& system, unsigned n) {
        struct Deeper {
            explicit Deeper(unsigned& of) : depth(of) { ++depth; }
            ~Deeper() { --depth; }
            unsigned& depth;
        } deeper(depth_);
        constexpr unsigned endless = 300;  // generations stay below 30, so this is a circle
        if (depth_ > endless) throw NoValue{};
        if (n == 0) return written(system.axiom, {});
        const Tree before = word(system, n - 1);
        Tree after;
        for (const Leaf& leaf : before) {
            const Tree part = successor(system, leaf);
            after.insert(after.end(), part.begin(), part.end());
            constexpr std::size_t most = 100'000;
            if ((modules_ += part.size() + 1) > most) throw TooMuch{};
        }
        return after;
    }

private:
    Tree successor(const LSystem& system, const Leaf& leaf) {
        const Production* found = nullptr;
        Bindings bindings;
        for (const Production& rule : system.rules) {
            const auto& names = rule.predecessor.parameters;
            if (outer_.alphabet.name(rule.predecessor.symbol) != leaf.letter ||
                names.size() != leaf.values.size())
                continue;
            Bindings own;
            for (std::size_t i = 0; i < names.size(); ++i) own[names[i]] = leaf.values[i];
            if (rule.condition && value(*rule.condition, own).as_number() == 0) continue;
            if (found) throw NoValue{};
            found = &rule;
            bindings = own;
        }
        return found ? written(found->successor, bindings) : Tree{leaf};
    }

    Tree written(const ModuleWord& word, const Bindings& bindings) {
        Tree out;
        for (std::size_t i = 0; i <= word.letters.size(); ++i) {
            if (const auto splices = word.splices.find(i); splices != word.splices.end())
                for (const Expression& expression : splices->second) {
                    const Thing given = value(expression, bindings);
                    out.insert(out.end(), given.as_word().begin(), given.as_word().end());
                }
            if (i == word.letters.size()) break;
            out.push_back({outer_.alphabet.name(word.letters[i]), {}});
            if (const auto arguments = word.arguments.find(i); arguments != word.arguments.end())
                for (const Expression& argument : arguments->second)
                    out.back().values.push_back(value(argument, bindings));
        }
        return out;
    }

    static Thing number(double value) { return {value, nullptr}; }
    static Thing held(Tree tree) { return {0, std::make_shared<const Tree>(std::move(tree))}; }

    Thing value(const Expression& expression, const Bindings& bindings) {
        switch (expression.kind) {
            case Expression::Kind::number:
                return number(expression.value.to_double());
            case Expression::Kind::name:
                return bindings.at(expression.name);
            case Expression::Kind::word:
                return held(written(*expression.word, {}));
            case Expression::Kind::unary:
                return number(-value(expression.operands[0], bindings).as_number());
            case Expression::Kind::call:
                return called(expression, bindings);
            case Expression::Kind::binary:
                break;
        }
        const std::string& name = expression.name;
        const double x = value(expression.operands[0], bindings).as_number();
        if (name == "&" && x == 0) return number(0);
        if (name == "|" && x != 0) return number(1);
        const double y = value(expression.operands[1], bindings).as_number();
        if (name == "+") return number(x + y);
        if (name == "-") return number(x - y);
        if (name == "*") return number(x * y);
        if (name == "<") return number(x < y);
        if (name == ">") return number(x > y);
        if (name == "=") return number(x == y);
        if (name == "!=") return number(x != y);
        return number(y != 0);
    }

    Thing called(const Expression& call, const Bindings& bindings) {
        const Thing first = value(call.operands[0], bindings);
        if (call.name == "length") return number(static_cast<double>(first.as_word().size()));
        if (call.name == "max")
            return number(
                std::max(first.as_number(), value(call.operands[1], bindings).as_number()));
        const double n = first.as_number();
        if (n < 0 || n != std::floor(n)) throw NoValue{};
        if (n > 30) throw TooMuch{};
        for (const InnerSystem& inner : outer_.inner)
            if (inner.name == call.name) return held(word(inner.system, static_cast<unsigned>(n)));
        throw NoValue{};
    }

    const LSystem& outer_;
    unsigned depth_ = 0;
    std::size_t modules_ = 0;
};

std::string text(const Tree& tree) {
    std::string out;
    for (const Leaf& leaf : tree) {
        out += leaf.letter;
        for (std::size_t i = 0; i < leaf.values.size(); ++i) {
            const Thing& thing = leaf.values[i];
            out += i == 0 ? "(" : ",";
            if (thing.word)
                out += '"' + (thing.word->empty() ? "" : text(*thing.word)) + '"';
            else
                out += std::to_string(static_cast<long long>(thing.number));
        }
        if (!leaf.values.empty()) out += ')';
    }
    return out;
}

}  // namespace

NestedWord nested_word(const LSystem& system, unsigned n) {
    try {
        const Tree word = Derivation(system).word(system, n);
        return {word.empty() ? "ε" : text(word), false};
    } catch (const NoValue&) {
        return {std::nullopt, false};
    } catch (const TooMuch&) {
        return {std::nullopt, true};
    }
}

}  // namespace algae::oracle
