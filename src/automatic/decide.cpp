#include <algorithm>

#include "automatic/detail/relations.hpp"
#include "automatic/detail/statement.hpp"

// Decides statements: every part becomes a relation.
//
// Quantifiers that follow one another, and what they bind as far as `and` goes, are one block: for some x1, ..., xk: A1 and A2 and ... Positions that are
// terms become variables of the block, with an equation each. A variable that stands in linear parts alone and in an equation with the
// coefficient 1 is eliminated by it, so that T[i+k] = T[i+n+k] for some k < n becomes T[u] = T[u+n] for some u with i <= u < i+n. Then one variable after
// the other is projected away, that of the smallest relations first. `for all` is not for some not.

namespace algae {

namespace {

using Kind = FirstOrderNode::Kind;

class Decision {
public:
    explicit Decision(Relations& relations) : relations_(relations) {}

    AutomaticRelation evaluate(const FirstOrderNode& node, bool negated) {
        switch (node.kind) {
            case Kind::negation:
                return evaluate(*node.parts[0], !negated);
            case Kind::for_all:
                if (!negated) return relations_.complement(evaluate(node, true));
                break;
            case Kind::exists:
                if (negated) return relations_.complement(evaluate(node, false));
                break;
            case Kind::conjunction:
                if (negated) return any_of(node.parts, true);
                break;
            case Kind::disjunction:
                if (!negated) return any_of(node.parts, false);
                break;
            case Kind::implication:
                if (!negated)
                    return relations_.either(evaluate(*node.parts[0], true),
                                             evaluate(*node.parts[1], false));
                break;
            case Kind::equivalence: {
                AutomaticRelation found = evaluate(*node.parts[0], negated);
                for (std::size_t i = 1; i < node.parts.size(); ++i) {
                    const AutomaticRelation part = evaluate(*node.parts[i], false);
                    found = relations_.either(
                        relations_.both(found, part),
                        relations_.both(relations_.complement(found), relations_.complement(part)));
                }
                return found;
            }
            default:
                break;
        }
        return block(node, negated, {});
    }

    /// The tuples of the variables of the first quantifiers for which what follows them holds, or does not.
    AutomaticRelation first_block(const FirstOrderNode& node, bool negated) {
        std::set<std::string> shown;
        const FirstOrderNode* inner = &node;
        while (inner->kind == node.kind) {
            shown.insert(inner->variables.begin(), inner->variables.end());
            inner = inner->parts[0].get();
        }
        return block(node, negated, shown);
    }

private:
    /// Parts of a block.
    struct Block {
        std::set<std::string> bound;
        std::vector<LinearTerm> equations, below;  // are 0; are below 0
        std::vector<AutomaticRelation> relations;
        std::set<std::string> fixed;  // variables of the relations: they are not eliminated
    };

    AutomaticRelation any_of(const std::vector<std::shared_ptr<const FirstOrderNode>>& parts,
                             bool negated) {
        AutomaticRelation found = evaluate(*parts[0], negated);
        for (std::size_t i = 1; i < parts.size(); ++i)
            found = relations_.either(found, evaluate(*parts[i], negated));
        return found;
    }

    /// The variable that a position is, or a new one with an equation.
    std::string variable_of(const LinearTerm& term, Block& block) {
        const std::string* variable = term.variable();
        const std::string name = variable ? *variable : named(term, block);
        block.fixed.insert(name);
        return name;
    }

    /// A new variable that is a term.
    std::string named(LinearTerm term, Block& block) {
        const std::string name = relations_.fresh();
        term.coefficients[name] = -1;
        block.equations.push_back(std::move(term));
        block.bound.insert(name);
        return name;
    }

    void add(const AutomaticRelation& relation, Block& block) {
        block.fixed.insert(relation.variables.begin(), relation.variables.end());
        block.relations.push_back(relation);
    }

    void collect(const FirstOrderNode& node, bool negated, Block& block) {
        const auto each = [&](bool sign) {
            for (const auto& part : node.parts) collect(*part, sign, block);
        };
        switch (node.kind) {
            case Kind::negation:
                return collect(*node.parts[0], !negated, block);
            case Kind::conjunction:
                if (!negated) return each(false);
                break;
            case Kind::disjunction:
                if (negated) return each(true);
                break;
            case Kind::implication:
                if (!negated) break;
                collect(*node.parts[0], false, block);
                return collect(*node.parts[1], true, block);
            case Kind::exists:
            case Kind::for_all:
                if ((node.kind == Kind::for_all) != negated) break;
                block.bound.insert(node.variables.begin(), node.variables.end());
                return collect(*node.parts[0], negated, block);
            case Kind::equation:
                if (negated) break;
                block.equations.push_back(node.terms[0]);
                return;
            case Kind::less: {
                LinearTerm term = node.terms[0];
                if (negated) {  // t >= 0 is -t - 1 < 0
                    LinearTerm opposite;
                    opposite.add(term, -1);
                    opposite.constant -= 1;
                    term = opposite;
                }
                block.below.push_back(term);
                return;
            }
            case Kind::same_letter: {
                const std::string left = variable_of(node.terms[0], block),
                                  right = variable_of(node.terms[1], block);
                return add(relations_.same_letter(left, right, !negated), block);
            }
            case Kind::letter: {
                const std::string at = variable_of(node.terms[0], block);
                return add(relations_.letter_is(at, node.letter, !negated), block);
            }
            case Kind::equal:
            case Kind::palindrome:
                return add(predicate(node, negated, block), block);
            case Kind::equivalence:
                break;
        }
        if (node.kind == Kind::equation) {
            LinearTerm less = node.terms[0], greater;
            greater.add(less, -1);
            return add(relations_.either(below(less), below(greater)), block);
        }
        add(evaluate(node, negated), block);
    }

    static LinearTerm term(std::map<std::string, Integer> coefficients, int constant) {
        return LinearTerm{std::move(coefficients), constant};
    }

    /// Factors of n letters at i and j that differ: at a distance d from each other, some letter u of the first of them differs from that at u + d.
    AutomaticRelation unequal() {
        Block apart;
        apart.bound = {"u", "v"};
        apart.below = {term({{"i", 1}, {"u", -1}}, -1), term({{"u", 1}, {"i", -1}, {"n", -1}}, 0)};
        apart.equations = {term({{"u", 1}, {"d", 1}, {"v", -1}}, 0)};
        add(relations_.same_letter("u", "v", false), apart);
        const AutomaticRelation differing = solved(std::move(apart), {});
        const auto placed = [&](const char* first, const char* second) {
            return relations_.without(
                relations_.both(
                    relations_.renamed(differing, {{"i", first}, {"d", "d"}, {"n", "n"}}),
                    relations_.sum({{{first, 1}, {"d", 1}}}, second)),
                {"d"});
        };
        return relations_.either(placed("i", "j"), placed("j", "i"));
    }

    /// Factors of n letters at i that are no palindromes: letters u and s - u differ, for s = 2i + n - 1.
    AutomaticRelation no_palindrome() {
        Block mirrored;
        mirrored.bound = {"u", "v"};
        mirrored.below = {term({{"i", 1}, {"u", -1}}, -1), term({{"i", 1}, {"v", -1}}, -1)};
        mirrored.equations = {term({{"u", 1}, {"v", 1}, {"s", -1}}, 0)};
        add(relations_.same_letter("u", "v", false), mirrored);
        const AutomaticRelation differing = solved(std::move(mirrored), {});
        return relations_.without(
            relations_.both(differing, relations_.equation({{{"i", 2}, {"n", 1}, {"s", -1}}, -1})),
            {"s"});
    }

    /// The relation of equal factors, or of palindromes, of variables.
    AutomaticRelation predicate(const FirstOrderNode& node, bool negated, Block& block) {
        auto& known = node.kind == Kind::equal ? equal_ : palindrome_;
        if (!known) {
            known = relations_.complement(node.kind == Kind::equal ? unequal() : no_palindrome());
        }
        static const std::vector<std::string> places{"i", "j", "n"}, of_palindrome{"i", "n"};
        const auto& from = node.kind == Kind::equal ? places : of_palindrome;
        std::map<std::string, std::string> names;
        std::set<std::string> taken;
        for (std::size_t i = 0; i < from.size(); ++i) {
            std::string name = variable_of(node.terms[i], block);
            if (!taken.insert(name).second) name = named({{{name, 1}}}, block);  // a second time
            names[from[i]] = name;
        }
        AutomaticRelation found = relations_.renamed(*known, names);
        return negated ? relations_.complement(found) : found;
    }

    /// The tuples for which a term is below 0.
    AutomaticRelation below(const LinearTerm& term) {
        if (term.coefficients.empty()) return relations_.constant(term.constant < 0);
        auto [left, right] = term.sides();
        const bool or_equal = right.constant >= 1;  // l < r + 1 is l <= r
        if (or_equal) right.constant -= 1;
        std::set<std::string> helpers;
        std::vector<AutomaticRelation> sums;
        const auto side = [&](const LinearTerm& of) {
            if (of.variable()) return *of.variable();
            const std::string name = relations_.fresh();
            helpers.insert(name);
            sums.push_back(relations_.sum(of, name));
            return name;
        };
        const std::string one = side(left), other = side(right);
        AutomaticRelation found = relations_.less(one, other, or_equal);
        for (const AutomaticRelation& sum : sums) {
            found = relations_.both(found, sum);
            std::set<std::string> over;
            for (const std::string& helper : helpers)
                if (std::ranges::count(sum.variables, helper) > 0) over.insert(helper);
            found = relations_.without(found, over);
        }
        return found;
    }

    AutomaticRelation block(const FirstOrderNode& node, bool negated,
                            const std::set<std::string>& shown) {
        Block found;
        collect(node, negated, found);
        return solved(std::move(found), shown);
    }

    /// Eliminates a variable of linear parts by an equation; false if there is none.
    static bool eliminate(Block& block, const std::set<std::string>& shown) {
        for (std::size_t e = 0; e < block.equations.size(); ++e)
            for (const auto& [name, times] : block.equations[e].coefficients) {
                if (!(times == 1 || times == -1) || !block.bound.contains(name) ||
                    block.fixed.contains(name) || shown.contains(name))
                    continue;
                const std::string variable = name;
                LinearTerm value;  // of the variable
                value.add(block.equations[e], -times);
                value.coefficients.erase(variable);
                block.equations.erase(block.equations.begin() + static_cast<std::ptrdiff_t>(e));
                const auto replace = [&](LinearTerm& term) {
                    const auto at = term.coefficients.find(variable);
                    if (at == term.coefficients.end()) return;
                    const Integer of_it = at->second;
                    term.coefficients.erase(at);
                    term.add(value, of_it);
                };
                std::ranges::for_each(block.equations, replace);
                std::ranges::for_each(block.below, replace);
                LinearTerm negative = value;  // it must not be below 0: -value - 1 < 0
                LinearTerm condition;
                condition.add(negative, -1);
                condition.constant -= 1;
                bool is_sure = value.constant >= 0;
                for (const auto& [other, of_other] : value.coefficients)
                    is_sure = is_sure && of_other > 0;
                if (!is_sure) block.below.push_back(condition);
                block.bound.erase(variable);
                return true;
            }
        return false;
    }

    /// Gives the sums that are compared names of their own, so that what they are compared with can go before them.
    void name_sums(Block& block) {
        std::map<std::pair<std::map<std::string, Integer>, Integer>, std::string> names;
        for (LinearTerm& term : block.below) {
            auto [left, right] = term.sides();
            LinearTerm compared;
            if (right.constant >=
                1) {  // a difference of 1 says < or <=; the rest belongs to its side
                right.constant -= 1;
                compared.constant = -1;
            }
            for (const auto& [side, sign] : {std::pair(&left, 1), {&right, -1}}) {
                if (side->variable() || side->coefficients.empty()) {
                    compared.add(*side, sign);
                    continue;
                }
                std::string& name = names[{side->coefficients, side->constant}];
                if (name.empty()) name = named(*side, block);
                compared.add({{{name, 1}}}, sign);
            }
            term = compared;
        }
    }

    AutomaticRelation solved(Block block, const std::set<std::string>& shown) {
        while (eliminate(block, shown)) continue;
        if (block.bound.size() > 0) name_sums(block);
        std::vector<AutomaticRelation> relations = std::move(block.relations);
        const auto add_new = [&](AutomaticRelation one) {
            if (std::ranges::count(relations, one) == 0) relations.push_back(std::move(one));
        };
        for (const LinearTerm& term : block.below) add_new(below(term));
        for (const LinearTerm& term : block.equations) add_new(relations_.equation(term));
        const auto joined = [&](std::vector<AutomaticRelation> some) {
            std::ranges::sort(some, {},
                              [](const AutomaticRelation& one) { return one.edges.size(); });
            AutomaticRelation found = relations_.constant(true);
            for (const AutomaticRelation& one : some) found = relations_.both(found, one);
            return found;
        };
        std::set<std::string> left;
        for (const std::string& name : block.bound)
            if (!shown.contains(name)) left.insert(name);
        while (!left.empty()) {
            // The variable whose relations have the fewest edges together.
            std::string best;
            double least = 0;
            for (const std::string& name : left) {
                double cost = 0;
                for (const AutomaticRelation& one : relations)
                    if (std::ranges::binary_search(one.variables, name))
                        cost += static_cast<double>(one.edges.size());
                if (best.empty() || cost < least) {
                    best = name;
                    least = cost;
                }
            }
            std::vector<AutomaticRelation> with, without;
            for (AutomaticRelation& one : relations)
                (std::ranges::binary_search(one.variables, best) ? with : without)
                    .push_back(std::move(one));
            relations = std::move(without);
            left.erase(best);
            if (with.empty()) continue;
            // Variables that no other relation has go with it.
            std::set<std::string> gone{best};
            for (const std::string& name : left) {
                bool is_elsewhere = false;
                for (const AutomaticRelation& one : relations)
                    is_elsewhere = is_elsewhere || std::ranges::binary_search(one.variables, name);
                if (!is_elsewhere) gone.insert(name);
            }
            for (const std::string& name : gone) left.erase(name);
            relations.push_back(relations_.without(joined(std::move(with)), gone));
        }
        return joined(std::move(relations));
    }

    Relations& relations_;
    std::optional<AutomaticRelation> equal_, palindrome_;
};

}  // namespace

FirstOrderAnswer decide_first_order(const FirstOrderStatement& statement, const AutomaticWord& word,
                                    const Budget& budget,
                                    const std::function<void(std::size_t)>& progress) {
    Relations relations(word, budget, progress);
    Decision decision(relations);
    FirstOrderAnswer answer;
    const FirstOrderNode* root = &statement.root();
    bool denied = false;
    for (; root->kind == Kind::negation; root = root->parts[0].get()) denied = !denied;
    const bool is_some = root->kind == Kind::exists, is_all = root->kind == Kind::for_all;
    if (statement.free().empty() && (is_some || is_all)) {
        const AutomaticRelation found = decision.first_block(*root, is_all);
        answer.holds = (is_some != found.empty()) != denied;
        if (!found.empty())
            for (auto& [name, value] : relations.witness(found))
                answer.witness.emplace_back(written_name(name), std::move(value));
        answer.relation = relations.constant(answer.holds);
    } else {
        answer.relation =
            relations.over(decision.evaluate(statement.root(), false), statement.free());
        answer.holds = !answer.relation.empty();
    }
    answer.largest = relations.largest();
    return answer;
}

}  // namespace algae
