#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "exact/exact.hpp"
#include "oracle/axes.hpp"
#include "oracle/written_system.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

constexpr Brackets brackets{'[', ']'};

Word word(const std::string& text) { return Word(text.begin(), text.end()); }
std::string text(const Word& letters) { return std::string(letters.begin(), letters.end()); }

AxialTree tree(const std::string& letters) { return axial_tree(word(letters), brackets); }
std::string rewritten(const AxialTree& of) { return text(bracketed_word(of, brackets)); }
std::string normal(const std::string& letters) { return rewritten(canonical(tree(letters))); }

/// A word with matching brackets, [ ] among them, over two letters.
std::string any_word(int depth = 3) {
    std::string out;
    for (int parts = *rc::gen::inRange(0, 5); parts > 0; --parts) {
        if (depth > 0 && *rc::gen::inRange(0, 2))
            out += '[' + any_word(depth - 1) + ']';
        else
            out += *rc::gen::element('a', 'b');
    }
    return out;
}

}  // namespace

TEST_CASE("words and their trees") {
    CHECK(tree("A[B]C").edges ==
          std::vector<AxialTree::Edge>{{'A', 0, true}, {'B', 1, false}, {'C', 1, true}});
    CHECK(rewritten(tree("A[B]C")) == "A[B]C");
    CHECK(rewritten(tree("A[][[]]B")) == "AB");
    CHECK(rewritten(tree("A[[B]C]D")) == "A[B][C]D");
    CHECK(rewritten(tree("[B]")) == "[B]");
    CHECK(rewritten(tree("")) == "");
    CHECK_THROWS_WITH_AS(tree("A]"), "unmatched ']'", Error);
    CHECK_THROWS_WITH_AS(tree("A[B"), "'[' is never closed", Error);
}

TEST_CASE("lateral branches have no order, empty brackets mean nothing") {
    CHECK(normal("A[C][B]D") == normal("A[B][C]D"));
    CHECK(normal("A[]") == normal("A"));
    CHECK(normal("A[B[C][D]E][B[D][C]E]") == normal("A[B[D][C]E][B[C][D]E]"));
    CHECK(normal("A[B]C") != normal("A[C]B"));
    CHECK(normal("A[B]") != normal("AB"));
}

TEST_CASE("axes of the axial tree in the documents: orders 0, 1 and 2, eight segments") {
    std::vector<char> segments(128, 0);
    segments['F'] = 1;
    const AxialTree drawn = restricted(tree("F[+F][-F[-F]F]F[+F][-F]"), segments);
    CHECK(drawn.edges.size() == 8);
    CHECK(order_counts(drawn) == std::vector<OrderCount>{{1, 2}, {4, 5}, {1, 1}});
    CHECK(order_counts(tree("")).empty());
    CHECK(order_counts(tree("[B]")) == std::vector<OrderCount>{{0, 0}, {1, 1}});
}

TEST_CASE("writing a tree and reading it gives the same tree") {
    CHECK(rc::check([] {
        const std::string letters = any_word();
        RC_LOG() << letters;
        const AxialTree read = tree(letters);
        RC_ASSERT(canonical(tree(rewritten(read))) == canonical(read));
        RC_ASSERT(canonical(canonical(read)) == canonical(read));
    }));
}

TEST_CASE("canonical trees are equal exactly when the trees as sets of branches are") {
    CHECK(rc::check([] {
        const std::string left = any_word(2);
        const bool same = *rc::gen::arbitrary<bool>();
        const std::string right =
            same ? oracle::shuffled(left, *rc::gen::arbitrary<std::uint64_t>()) : any_word(2);
        RC_LOG() << left << ' ' << right;
        const bool equal = oracle::branches(left) == oracle::branches(right);
        RC_ASSERT((canonical(tree(left)) == canonical(tree(right))) == equal);
        if (same) RC_ASSERT(equal);
    }));
}

TEST_CASE("axes and edges of each order are those counted along the word") {
    CHECK(rc::check([] {
        const std::string letters = any_word(4);
        RC_LOG() << letters;
        std::map<std::size_t, std::pair<std::uint64_t, std::uint64_t>> found;
        const auto counts = order_counts(tree(letters));
        for (std::size_t order = 0; order < counts.size(); ++order)
            if (counts[order].edges > 0) found[order] = {counts[order].axes, counts[order].edges};
        RC_ASSERT(found == oracle::axes(letters));
    }));
}

TEST_CASE("the number of a branch, the least of its axes, is the order of its main axis") {
    CHECK(rc::check([] {
        const AxialTree read = tree(any_word(4));
        const auto orders = axis_orders(read);
        std::vector<std::size_t> least = orders;  // of the subtree from each edge on
        for (std::size_t i = read.edges.size(); i-- > 0;)
            if (const std::size_t start = read.edges[i].start; start > 0)
                least[start - 1] = std::min(least[start - 1], least[i]);
        RC_ASSERT(least == orders);
    }));
}

TEST_CASE("leaving edges out of a tree is leaving letters out of the word") {
    std::vector<char> labels(128, 0);
    labels['a'] = 1;
    CHECK(rc::check([&] {
        std::string letters = any_word(4);
        RC_LOG() << letters;
        const AxialTree left = restricted(tree(letters), labels);
        std::erase(letters, 'b');
        RC_ASSERT(canonical(left) == canonical(tree(letters)));
    }));
}

TEST_CASE("deriving the tree and deriving the word agree") {
    CHECK(rc::check([] {
        oracle::WrittenSystem system;
        system.axiom = any_word(2);
        for (const char letter : {'a', 'b'}) system.successors[letter] = {any_word(2)};
        RC_LOG() << system;
        const D0L words = oracle::d0l_of(system);
        const View<TreeSystem> trees = as_tree_system(words);
        for (unsigned n = 0; n < 4; ++n) {
            const std::string letters = oracle::rewritten(system, n);
            if (letters.size() > 2000) break;
            Word expected;
            for (const char c : letters)
                expected.push_back(*words.alphabet->find(std::string(1, c)));
            const AxialTree derived = derived_tree(*trees, n);
            RC_ASSERT(canonical(derived) == canonical(axial_tree(expected, trees->brackets)));
        }
    }));
}

TEST_CASE("brackets that are rewritten make no tree system") {
    CHECK(as_tree_system(d0l("[a]", {{'a', "b"}, {'[', "["}, {']', "]a"}})).reason() ==
          "not a tree 0L-system: its brackets are rewritten, or do not match in the axiom or in a "
          "successor");
    CHECK(derived_tree(*as_tree_system(d0l("a", {{'a', "ab"}})), 3).edges.size() == 4);
    Budget small;
    small.letters = 100;
    CHECK_THROWS_WITH_AS(derived_tree(*as_tree_system(d0l("a", {{'a', "aa"}})), 60, small),
                         "the tree has more edges than the 100 allowed", BoundReached);
}
