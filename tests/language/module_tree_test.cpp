#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <set>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/interaction.hpp"
#include "oracle/random_tables.hpp"
#include "rewrite/rewrite.hpp"

using namespace algae;

namespace {

using Node = DerivationTree::Node;
using Kind = DerivationTree::Node::Kind;

std::string any(const std::vector<std::string>& texts) { return *rc::gen::elementOf(texts); }
int below(int bound) { return *rc::gen::inRange(0, bound); }

std::string label(const DerivationTree& tree, const Node& node) {
    return node.text.empty() ? tree.alphabet->name(node.letter) : node.text;
}

/// The modules below a node from left to right.
void add_frontier(const DerivationTree& tree, std::size_t at, std::vector<std::string>& frontier) {
    const Node& node = tree.nodes[at];
    if (node.kind == Kind::letter && node.children.empty()) frontier.push_back(label(tree, node));
    for (const std::size_t child : node.children) add_frontier(tree, child, frontier);
}

std::vector<std::string> frontier_of(const DerivationTree& tree) {
    std::vector<std::string> frontier;
    for (const std::size_t root : tree.roots) add_frontier(tree, root, frontier);
    return frontier;
}

std::vector<std::string> modules_of(const Rewriting& rewriting, const ModuleString& word) {
    const CompiledRules& rules = rewriting.rules();
    const ModuleText text(rules.system->alphabet, rules.kinds);
    std::vector<std::string> modules;
    const double* values = word.values.data();
    for (const ModuleKind kind : word.kinds) {
        modules.push_back(text.text(kind, values));
        values += rules.kinds.arity(kind);
    }
    return modules;
}

/// Whether the tree of generation n has the words of `derive` in its rows and its leaves. Gives how many nodes were compared.
std::size_t check_tree(const Rewriting& rewriting, std::uint64_t n,
                       const std::vector<std::size_t>& tables = {}) {
    const ModuleTrace trace = traced(rewriting, n, tables, 3000);
    if (trace.goes_on) return 0;
    const DerivationTree tree = derivation_tree(rewriting, trace);
    RC_ASSERT(tree_size(rewriting, trace) == Integer(tree.nodes.size()));
    RC_ASSERT(tree.roots.size() + edge_count(tree) == tree.nodes.size());
    RC_ASSERT(frontier_of(tree) == modules_of(rewriting, derive(rewriting, n, tables)));
    for (std::uint64_t t = 0; t <= n; ++t) {
        std::vector<std::string> row;
        for (const Node& node : tree.nodes)
            if (node.kind == Kind::letter && node.generation == t) row.push_back(label(tree, node));
        RC_ASSERT(row == modules_of(rewriting, derive(rewriting, t, tables)));
    }
    // Cut anywhere, the counts below add up to the length of the last word.
    for (std::uint64_t depth = 0; depth < n; ++depth) {
        const TreeShape shape{depth, false};
        const DerivationTree cut = derivation_tree(rewriting, trace, shape);
        RC_ASSERT(tree_size(rewriting, trace, shape) == Integer(cut.nodes.size()));
        Integer sum = 0;
        for (const Node& node : cut.nodes)
            if (node.kind == Kind::omitted) sum += node.leaves;
        RC_ASSERT(sum == Integer(trace.words.back().kinds.size()));
    }
    // With shared subtrees the leaves are the same.
    const DerivationTree shared = derivation_tree(rewriting, trace, {std::nullopt, true});
    RC_ASSERT(frontier_of(shared) == frontier_of(tree));
    return tree.nodes.size();
}

std::string any_number(const std::vector<std::string>& names) {
    const std::string one = any({"1", "2", "0.5", "1/3"});
    return names.empty() || below(3) == 0 ? one : any(names) + any({"", "+", "*", "-"});
}

std::string any_term(const std::vector<std::string>& names) {
    const std::string text = any_number(names);
    return text.find_last_of("+*-") == text.size() - 1 ? text + any({"1", "2", "0.5"}) : text;
}

std::string any_modules(const std::vector<std::string>& names, int most) {
    std::string out;
    for (int i = below(most + 1); i > 0; --i) {
        const int which = below(4);
        out += which == 0   ? "a"
               : which == 1 ? "b"
               : which == 2 ? "A(" + any_term(names) + ")"
                            : "B(" + any_term(names) + "," + any_term(names) + ")";
    }
    return out;
}

/// A system with parameters, conditions that exclude each other, contexts and chance.
std::string any_module_system(bool contexts, bool chance) {
    std::string text = "axiom a" + any_modules({}, 3) + "A(1)B(2,0.5)";
    const std::vector<std::pair<std::string, std::vector<std::string>>> sides{
        {"a", {}}, {"b", {}}, {"A(x)", {"x"}}, {"B(x,y)", {"x", "y"}}};
    for (const auto& [side, names] : sides) {
        if (below(4) == 0) continue;
        if (contexts && below(2) == 0) {
            std::vector<std::string> more = names;
            more.push_back("z");
            const bool left = below(2) == 0;
            text += "; " + (left ? "A(z) < " + side : side + " > A(z)");
            if (!names.empty() && below(2)) text += " : z >= " + names[0];
            text += " -> " + any_modules(more, 3);
        }
        if (chance) {
            text += "; " + side + " -(1/3)-> " + any_modules(names, 3);
            text += "; " + side + " -(2/3)-> " + any_modules(names, 2);
        } else if (!names.empty() && below(2)) {
            text += "; " + side + " : x < 2 -> " + any_modules(names, 3);
            text += "; " + side + " : x >= 2 -> " + any_modules(names, 2);
        } else {
            text += "; " + side + " -> " + any_modules(names, 3);
        }
    }
    return text;
}

std::string written(const oracle::WrittenInteraction& system) {
    std::string text = "axiom " + system.axiom;
    for (const auto& rule : system.rules)
        text += "; " + (rule.left.empty() ? "" : rule.left + " < ") + rule.letter +
                (rule.right.empty() ? "" : " > " + rule.right) + " -> " + rule.successor;
    return text + (system.ignored.empty() ? "" : "; ignore " + system.ignored);
}

std::string written(const oracle::WrittenTables& system) {
    std::string text = "axiom " + system.axiom;
    for (std::size_t t = 0; t < system.tables.size(); ++t) {
        if (system.tables.size() > 1) text += std::string("; table ") + static_cast<char>('p' + t);
        for (const auto& [letter, words] : system.tables[t])
            for (const std::string& word : words)
                text += std::string("; ") + letter + " -> " + word;
    }
    return text;
}

}  // namespace

TEST_CASE("the leaves of a tree of modules are the word of the same steps and seed") {
    std::size_t compared = 0;
    for (const bool contexts : {false, true})
        for (const bool chance : {false, true})
            CHECK(rc::check("modules", [&] {
                const std::string text = *rc::gen::resize(
                    100, rc::gen::exec([&] { return any_module_system(contexts, chance); }));
                RC_LOG() << text << '\n';
                const LSystem system = read_lsystem(text, "random.lsys");
                RewritingChoices choices;
                choices.seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
                if (*rc::gen::arbitrary<bool>()) choices.arithmetic = Arithmetic::exact;
                try {
                    const Rewriting rewriting(system, choices);
                    compared += check_tree(rewriting, *rc::gen::inRange<std::uint64_t>(0, 5)) > 0;
                } catch (const Error&) {  // chance beside a rule without: no word either
                    RC_ASSERT(contexts);
                    RC_ASSERT(chance);
                }
            }));
    CHECK(compared > 200);
}

TEST_CASE("the leaves of a tree of a system with tables are the word by the same tables") {
    std::size_t compared = 0;
    CHECK(rc::check("tables", [&] {
        const auto system = *oracle::any_tables(3, true, {""});
        RC_LOG() << written(system) << '\n';
        RewritingChoices choices;
        choices.seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
        choices.evenly = choices.random_tables = true;
        const Rewriting rewriting(read_lsystem(written(system), "random.lsys"), choices);
        const std::uint64_t n = *rc::gen::inRange<std::uint64_t>(0, 6);
        compared += check_tree(rewriting, n) > 0;
        if (system.tables.size() == 1) return;
        // The tables are named beside the steps, and given ones are used.
        const ModuleTrace trace = traced(rewriting, n, {}, 3000);
        if (trace.goes_on) return;
        const DerivationTree tree = derivation_tree(rewriting, trace);
        RC_ASSERT(tree.tables.size() == n);
        for (std::size_t t = 0; t < n; ++t)
            RC_ASSERT(tree.tables[t] ==
                      std::string(1, static_cast<char>('p' + rewriting.own_table(t))));
        check_tree(rewriting, n, trace.tables);
    }));
    CHECK(compared > 60);
}

TEST_CASE("the leaves of a tree of a system with contexts are its word, derived by another route") {
    std::size_t compared = 0, seen = 0;
    for (const bool trees : {false, true})
        CHECK(rc::check("contexts", [&] {
            const auto system = *rc::gen::resize(100, oracle::any_interaction(trees));
            const LSystem read = read_lsystem(written(system), "random.lsys");
            const View<IL> plain = as_il(read);
            RC_PRE(static_cast<bool>(plain));
            RC_LOG() << written(system) << '\n';
            const Rewriting rewriting(read);
            const std::uint64_t n = *rc::gen::inRange<std::uint64_t>(1, 5);
            std::string word = system.axiom;
            ModuleTrace trace;
            try {
                trace = traced(rewriting, n, {}, 3000);
            } catch (const Error&) {
                RC_ASSERT(trees);  // brackets do not match
                return;
            }
            if (trace.goes_on) return;
            const DerivationTree tree = derivation_tree(rewriting, trace);
            for (std::uint64_t t = 0; t < n; ++t) word = oracle::after(system, word);
            std::string leaves;
            for (const std::string& module : frontier_of(tree)) leaves += module;
            RC_ASSERT(leaves == word);
            ++compared;
            if (trees) return;
            // What a letter saw are the nearest letters that are not ignored, as many as the contexts of the
            // rule with the longest ones that match have.
            std::vector<std::vector<std::size_t>> rows(n + 1);
            for (std::size_t i = 0; i < tree.nodes.size(); ++i)
                if (tree.nodes[i].kind == Kind::letter) rows[tree.nodes[i].generation].push_back(i);
            for (std::uint64_t t = 0; t < n; ++t)
                for (std::size_t i = 0; i < rows[t].size(); ++i) {
                    std::vector<std::size_t> before, behind;
                    std::string left, right;
                    const auto letter = [&](std::size_t k) {
                        return tree.alphabet->name(tree.nodes[rows[t][k]].letter);
                    };
                    for (std::size_t k = 0; k < rows[t].size(); ++k) {
                        if (k == i || system.ignored == letter(k)) continue;
                        (k < i ? before : behind).push_back(rows[t][k]);
                        (k < i ? left : right) += letter(k);
                    }
                    const oracle::WrittenInteraction::Rule* best = nullptr;
                    for (const auto& rule : system.rules)
                        if (std::string(1, rule.letter) == letter(i) && left.ends_with(rule.left) &&
                            right.starts_with(rule.right) &&
                            (!best || best->left.size() + best->right.size() <
                                          rule.left.size() + rule.right.size()))
                            best = &rule;
                    std::vector<std::size_t> expected;
                    if (best) {
                        expected.assign(before.end() - static_cast<long>(best->left.size()),
                                        before.end());
                        expected.insert(expected.end(), behind.begin(),
                                        behind.begin() + static_cast<long>(best->right.size()));
                    }
                    RC_ASSERT(tree.nodes[rows[t][i]].seen == expected);
                    seen += !expected.empty();
                }
        }));
    CHECK(compared > 100);
    CHECK(seen > 20);
}

TEST_CASE("labels are modules as derive prints them, exact numbers among them") {
    const Rewriting rewriting(
        read_lsystem("axiom A(1); A(x) : x > 0.3 -> A(x/3)B; B -> B", "labels.lsys"),
        {.arithmetic = Arithmetic::exact});
    const DerivationTree tree = derivation_tree(rewriting, traced(rewriting, 2));
    std::string labels;
    for (const Node& node : tree.nodes) labels += label(tree, node) + ' ';
    CHECK(labels == "A(1) A(1/3) B A(1/9) B B ");
    CHECK(tree.nodes[1].text == "A(1/3)");
    CHECK(tree.nodes[2].text.empty());
    CHECK(context_count(tree) == 0);
}

TEST_CASE("modules of contexts in branches and elsewhere in the word are seen") {
    const auto seen = [](const std::string& text) {
        const Rewriting rewriting(read_lsystem(text, "seen.lsys"));
        std::string found;
        const ModuleTrace trace = traced(rewriting, 1);
        for (std::size_t i = 0; i < trace.seen[0].size(); ++i)
            for (const std::size_t other : trace.seen[0][i])
                found += std::to_string(i) + "<" + std::to_string(other) + ' ';
        return found;
    };
    // BC < S > G[H]M in ABC[DE][SG[HI[JK]L]MNO]: branches that the context does not name are skipped.
    CHECK(seen("axiom ABC[DE][SG[HI[JK]L]MNO]; BC < S > G[H]M -> X") == "8<1 8<2 8<9 8<11 8<19 ");
    // The condition decides which module elsewhere is meant.
    CHECK(seen("axiom A(1)B(1)B(2)B(3); A(x) ? B(y) : y > x+1 -> C") == "0<3 ");
    CHECK(seen("axiom A(1)B(1)B(2)B(3); A(x) ? B(y) : y > x+5 -> C").empty());
}

TEST_CASE("a derivation that grows too long ends before, and its tree is drawn cut") {
    const Rewriting rewriting(read_lsystem("axiom A(1); A(x) -> A(x)A(x+1)", "long.lsys"));
    const ModuleTrace trace = traced(rewriting, 100, {}, 1000);
    CHECK(trace.goes_on);
    CHECK(trace.words.size() < 12);
    const DerivationTree cut = derivation_tree(rewriting, trace, {2, false});
    CHECK(cut.nodes.back().kind == Kind::omitted);
    CHECK(cut.nodes.back().leaves == -1);
    CHECK_THROWS_AS(tree_size(rewriting, trace), BoundReached);
    CHECK_THROWS_AS(derivation_tree(rewriting, trace, {90, false}), BoundReached);
    Budget late;
    late.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    CHECK_THROWS_AS(traced(rewriting, 3, {}, 1000, late), BoundReached);
    Budget small;
    small.letters = 4;
    CHECK_THROWS_AS(traced(rewriting, 5, {}, 1000, small), BoundReached);
}
