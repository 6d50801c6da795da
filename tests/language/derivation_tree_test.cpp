#include "language/language.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <set>

#include "exact/exact.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

namespace {

using Kind = DerivationTree::Node::Kind;

/// The letters of one generation from left to right, as the tree has them.
std::string row(const DerivationTree& tree, std::uint64_t generation) {
    Word word;
    for (const auto& node : tree.nodes)
        if (node.kind == Kind::letter && node.generation == generation) word.push_back(node.letter);
    return oracle::text_of(*tree.alphabet, word);
}

std::size_t count(const DerivationTree& tree, Kind kind) {
    std::size_t found = 0;
    for (const auto& node : tree.nodes) found += node.kind == kind;
    return found;
}

/// Every node but the roots is below exactly one, children are in order, one generation below.
bool is_forest(const DerivationTree& tree) {
    std::vector<std::size_t> order = tree.roots;
    for (const auto& node : tree.nodes)
        for (const std::size_t child : node.children) {
            order.push_back(child);
            if (tree.nodes[child].generation != node.generation + 1) return false;
        }
    for (std::size_t i = 0; i < order.size(); ++i)
        if (order[i] != i) return false;
    return order.size() == tree.nodes.size();
}

bool same(const DerivationTree& left, const DerivationTree& right) {
    return left.nodes == right.nodes && left.roots == right.roots;
}

ET0L with_choices(const D0L& system) {
    OL nondeterministic{system.alphabet, system.axiom, {}, system.letters, system.name};
    for (const Word& image : system.rules.images()) nondeterministic.successors.push_back({image});
    return as_et0l(nondeterministic);
}

Derivation derivation_of(const D0L& system, std::uint64_t n) {
    Derivation found{{system.axiom}, {}};
    for (std::uint64_t t = 0; t < n; ++t) {
        found.choices.emplace_back(found.words.back().size(), 0);
        found.words.push_back(oracle::rewritten(found.words.back(), system.rules.images(), 1));
    }
    return found;
}

}  // namespace

TEST_CASE("the rows of a tree are the generations, its leaves spell the last one") {
    CHECK(rc::check("rows, leaves, sizes", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const unsigned n = oracle::last_generation_within(written, 200, 6);
        const DerivationTree tree = derivation_tree(system, n);
        RC_ASSERT(is_forest(tree));
        std::size_t letters = 0, erased = written.axiom.empty() ? 1 : 0;
        for (unsigned t = 0; t <= n; ++t) {
            const std::string word = oracle::rewritten(written, t);
            RC_ASSERT(row(tree, t) == word);
            letters += word.size();
            for (const char a : word)
                if (t < n && oracle::rewritten({std::string(1, a), written.successors}, 1).empty())
                    ++erased;
        }
        RC_ASSERT(count(tree, Kind::letter) == letters);
        RC_ASSERT(count(tree, Kind::erased) == erased);
        RC_ASSERT(count(tree, Kind::omitted) == 0u);
        RC_ASSERT(tree_size(system, n) == Integer(tree.nodes.size()));
        RC_ASSERT(oracle::text_of(*system.alphabet, leaves(tree)) == oracle::rewritten(written, n));
        RC_ASSERT(edge_count(tree) == tree.nodes.size() - tree.roots.size());
    }));
}

TEST_CASE("a cut tree counts what it leaves out") {
    CHECK(rc::check("cuts", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const unsigned n = oracle::last_generation_within(written, 200, 6);
        const auto cut = *rc::gen::inRange(0u, n + 2);
        const DerivationTree tree = derivation_tree(system, n, {cut, false});
        RC_ASSERT(is_forest(tree));
        RC_ASSERT(tree_size(system, n, {cut, false}) == Integer(tree.nodes.size()));
        if (cut >= n) return;
        RC_ASSERT(row(tree, cut) == oracle::rewritten(written, cut));
        RC_ASSERT(depth(tree) <= cut);
        RC_ASSERT(count(tree, Kind::omitted) == row(tree, cut).size());
        Integer leaves_left_out = 0;
        for (const auto& node : tree.nodes) leaves_left_out += node.leaves;
        RC_ASSERT(leaves_left_out == Integer(oracle::rewritten(written, n).size()));
    }));
}

TEST_CASE("shared subtrees: merged in the tree, built at once, and counted by sets of letters") {
    CHECK(rc::check("three ways", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const unsigned n = oracle::last_generation_within(written, 200, 6);
        TreeShape shape{std::nullopt, true};
        if (*rc::gen::arbitrary<bool>()) shape.depth = *rc::gen::inRange(0u, n + 1);
        const DerivationTree shared = derivation_tree(system, n, shape);
        RC_ASSERT(
            same(shared, with_shared_subtrees(derivation_tree(system, n, {shape.depth, false}))));
        RC_ASSERT(tree_size(system, n, shape) == Integer(shared.nodes.size()));
        if (!shape.depth)
            RC_ASSERT(oracle::text_of(*system.alphabet, leaves(shared)) ==
                      oracle::rewritten(written, n));
        // Letters of a generation, once each.
        for (unsigned t = 0; t <= depth(shared); ++t) {
            const std::string word = oracle::rewritten(written, t), nodes = row(shared, t);
            RC_ASSERT(std::set<char>(word.begin(), word.end()) ==
                      std::set<char>(nodes.begin(), nodes.end()));
            RC_ASSERT(nodes.size() == std::set<char>(nodes.begin(), nodes.end()).size());
        }
    }));
}

TEST_CASE("a derivation of a deterministic system has the tree of its generation") {
    CHECK(rc::check("two routes", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const unsigned n = oracle::last_generation_within(written, 200, 6);
        TreeShape shape{std::nullopt, *rc::gen::arbitrary<bool>()};
        if (*rc::gen::arbitrary<bool>()) shape.depth = *rc::gen::inRange(0u, n + 1);
        const ET0L choices = with_choices(system);
        const Derivation found = derivation_of(system, n);
        RC_ASSERT(same(derivation_tree(choices, found, shape), derivation_tree(system, n, shape)));
        RC_ASSERT(tree_size(choices, found, shape) == tree_size(system, n, shape));
    }));
}

TEST_CASE("the tree of a member spells it") {
    CHECK(rc::check("members", [] {
        const auto written = *oracle::any_0l(3, true);
        const OL system = oracle::ol_of(written);
        for (const std::string& text : oracle::words_up_to(written, 4, 6)) {
            Word word;
            for (const char a : text) word.push_back(*system.alphabet->find(std::string(1, a)));
            const Membership found = membership(system, word);
            RC_ASSERT(found.member);
            const Derivation steps = derivation(system, word, found.step);
            const DerivationTree tree = derivation_tree(as_et0l(system), steps);
            RC_ASSERT(is_forest(tree));
            RC_ASSERT(leaves(tree) == word);
            RC_ASSERT(tree_size(as_et0l(system), steps) == Integer(tree.nodes.size()));
            const DerivationTree shared = with_shared_subtrees(tree);
            RC_ASSERT(leaves(shared) == word);
            RC_ASSERT(shared.nodes.size() <= tree.nodes.size());
        }
    }));
}

TEST_CASE("a derivation by tables has their names") {
    const ET0L system = et0l("S", {{{'S', "SS"}, {'a', "a"}}, {{'S', "a"}, {'a', ""}}}, "a");
    const Derivation steps{{{0}, {0, 0}, {1, 1}}, {{0}, {0, 0}}, {0, 1}};
    ET0L named = system;
    named.table_names = {"grow", "end"};
    const DerivationTree tree = derivation_tree(named, steps);
    CHECK(row(tree, 2) == "aa");
    CHECK(tree.tables == std::vector<std::string>{"grow", "end"});
    CHECK(tree_size(named, steps) == 5);
    CHECK(with_shared_subtrees(tree).nodes.size() == 3);
    CHECK(derivation_tree(named, steps, {1, false}).tables == std::vector<std::string>{"grow"});
}

TEST_CASE("sizes of trees far too large to build") {
    const D0L fibonacci = d0l("b", {{'a', "ab"}, {'b', "a"}});
    CHECK(tree_size(fibonacci, 30) == 3524577);
    CHECK(tree_size(fibonacci, 30, {6, false}) == 33 + 13);
    CHECK(tree_size(fibonacci, 30, {std::nullopt, true}) == 60);
    // Three letters take turns beside one that stays, in generations beyond number.
    const D0L turns = d0l("pc", {{'p', "qc"}, {'q', "r"}, {'r', "p"}});
    CHECK(tree_size(turns, 3'000'000'000'000, {std::nullopt, true}) == Integer(6'000'000'000'002));
    // 2^(n+1) - 1 letters, all of them one.
    const D0L doubling = d0l("a", {{'a', "aa"}});
    CHECK(tree_size(doubling, 1000) == power(Integer(2), 1001) - 1);
    CHECK(tree_size(doubling, 1000, {std::nullopt, true}) == 1001);
    CHECK_THROWS_AS(tree_size(doubling, 1'000'000'000'000), BoundReached);
    CHECK_THROWS_WITH_AS(leaves(derivation_tree(doubling, 100, {2, false})),
                         "the tree is cut: its leaves spell no word", Error);
    // Cut in time, what is left out need not be counted.
    CHECK(derivation_tree(doubling, 1'000'000'000'000, {2, false}).nodes.back().leaves == -1);
    CHECK(derivation_tree(doubling, 100, {2, false}).nodes.back().leaves == power(Integer(2), 98));
    const auto size = [&](const TreeShape& shape) { return tree_size(fibonacci, 30, shape); };
    CHECK(depth_within(30, 2000, size) == 13);
    CHECK(tree_size(fibonacci, 30, {13, false}) <= 2000);
    CHECK(tree_size(fibonacci, 30, {14, false}) > 2000);
    CHECK(depth_within(30, 2000, size, true) == 29);
    CHECK(depth_within(30, 1, size) == std::nullopt);
    CHECK(depth_within(30, 2, size) == 0);
    Budget few;
    few.letters = 10;
    CHECK_THROWS_AS(derivation_tree(doubling, 10, {}, few), BoundReached);
}

TEST_CASE("the tree of an empty axiom is one mark without a letter") {
    const DerivationTree tree = derivation_tree(d0l("", {{'a', "b"}}), 3);
    DerivationTree::Node mark;
    mark.kind = Kind::erased;
    CHECK(tree.nodes == std::vector{mark});
}
