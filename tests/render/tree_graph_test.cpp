#include "render/render.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/random_systems.hpp"
#include "render/detail/graph.hpp"
#include "render/dot_reader.hpp"
#include "render/pixels.hpp"
#include "rewrite/rewrite.hpp"

using namespace algae;

namespace {

using test::ReadDot;

std::string drawn(const Graph& graph, PictureFormat format, const GraphOptions& options = {}) {
    std::ostringstream out;
    draw_graph(graph, out, format, options);
    return out.str();
}

/// The word below a node, read from left to right.
std::string spelled(const ReadDot& dot, int node) {
    const std::vector<int> children = dot.children(node);
    const std::string& label = dot.labels.at(node);
    if (children.empty()) return label == "ε" ? "" : label;
    std::string word;
    for (const int child : children) word += spelled(dot, child);
    return word;
}

}  // namespace

TEST_CASE(
    "the leaves of a tree in Graphviz's language spell the word, its rows are as long as the "
    "generations") {
    CHECK(rc::check("D0L trees", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        RC_PRE(!written.axiom.empty());
        const unsigned n = oracle::last_generation_within(written, 60, 5);
        const ReadDot dot(dot_text(tree_graph(derivation_tree(system, n))));
        std::string last;
        const auto& roots = dot.rows.at(0);
        for (const int root : std::set<int>(roots.begin(), roots.end())) last += spelled(dot, root);
        RC_ASSERT(last == oracle::rewritten(written, n));
        for (unsigned t = 0; t <= n; ++t) {
            std::size_t letters = 0;
            if (dot.rows.contains(static_cast<int>(t))) {
                const auto& row = dot.rows.at(static_cast<int>(t));
                for (const int node : std::set<int>(row.begin(), row.end()))
                    letters += dot.labels.at(node) != "ε";
            }
            RC_ASSERT(letters == oracle::rewritten(written, t).size());
        }
        for (const auto& [from, to] : dot.orders) RC_ASSERT(from + 1 == to);
    }));
}

TEST_CASE(
    "a placed tree keeps its order, stands parents over their children and nothing overlaps") {
    CHECK(rc::check("places", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const unsigned n = oracle::last_generation_within(written, 100, 6);
        const Graph graph =
            tree_graph(derivation_tree(system, n, {*rc::gen::inRange(0u, 6u), false}));
        const GraphLayout layout = tree_layout(graph);
        for (const auto& row : graph.rows)
            for (std::size_t i = 0; i < row.size(); ++i) {
                const Point at = layout.nodes[row[i]], size = node_size(graph.nodes[row[i]]);
                RC_ASSERT(at.x - size.x / 2 >= -1e-6);
                RC_ASSERT(at.x + size.x / 2 <= layout.width + 1e-6);
                RC_ASSERT(at.y == layout.nodes[row[0]].y);
                if (i == 0) continue;
                const Point before = layout.nodes[row[i - 1]],
                            other = node_size(graph.nodes[row[i - 1]]);
                RC_ASSERT(before.x + other.x / 2 < at.x - size.x / 2);
            }
        std::vector<std::vector<double>> below(graph.nodes.size());
        for (const Graph::Edge& edge : graph.edges) {
            RC_ASSERT(layout.nodes[edge.from].y < layout.nodes[edge.to].y);
            below[edge.from].push_back(layout.nodes[edge.to].x);
        }
        for (std::size_t i = 0; i < below.size(); ++i) {
            if (below[i].empty()) continue;
            const auto [low, high] = std::minmax_element(below[i].begin(), below[i].end());
            RC_ASSERT(std::fabs(layout.nodes[i].x - (*low + *high) / 2) < 4);
        }
    }));
}

TEST_CASE("names in Graphviz's language are plain on every run, not sometimes in angle brackets") {
    // Graphviz looks before a name's first byte whether it is HTML: names must be strings of its own.
    for (int run = 0; run < 50; ++run) {
        const std::string dot = dot_text(tree_graph(derivation_tree(d0l("a", {{'a', "ab"}}), 2)));
        CHECK(dot.find("digraph algae {") == 0);
        CHECK(dot.find("<row") == std::string::npos);
    }
}

TEST_CASE("what a tree shows") {
    const D0L system = d0l("a", {{'a', "ab+"}, {'b', ""}});
    const Graph graph = tree_graph(derivation_tree(system, 2));
    using enum Graph::Node::Shape;
    CHECK(graph.trees);
    CHECK(graph.row_labels == std::vector<std::string>{"0", "1", "2"});
    std::string shapes;
    for (const Graph::Node& node : graph.nodes)
        shapes += node.label + (node.shape == bare ? "." : " ");
    CHECK(shapes == "a a b +.a b +.ε.+.");
    // Cut after a generation, triangles say what is left out.
    const Graph cut =
        tree_graph(derivation_tree(d0l("a", {{'a', "ab"}, {'b', "a"}}), 12, {1, false}));
    CHECK(cut.nodes.back().shape == triangle);
    CHECK(cut.nodes[3].label == "233");
    CHECK(cut.nodes[4].label == "144");
    CHECK(cut.row_labels.back().empty());
    CHECK(tree_graph(derivation_tree(d0l("a", {{'a', "aa"}}), 100, {0, false})).nodes[1].label ==
          "1.2e30");
    CHECK(tree_graph(derivation_tree(d0l("ab", {{'b', ""}}), 9, {0, false})).nodes[3].label == "ε");
    // Shared subtrees: how often a letter occurs stands at the edge.
    const Graph shared =
        tree_graph(derivation_tree(d0l("F", {{'F', "F+F--F+F"}}), 1, {std::nullopt, true}));
    CHECK_FALSE(shared.trees);
    CHECK(shared.nodes.size() == 4);
    CHECK(shared.edges[0].label == "×4");
    CHECK(shared.edges[1].label == "×2");
}

TEST_CASE("modules, tables and contexts in a tree") {
    const Rewriting rewriting(
        read_lsystem("axiom bA(1)aa; table s; b < A(x) -> A(x/2)a; A(x) > a -> A(9); table t; "
                     "a < a > a -> b",
                     "tables.lsys"),
        {.arithmetic = Arithmetic::exact});
    const Graph graph = tree_graph(derivation_tree(rewriting, traced(rewriting, 2, {0, 1})));
    CHECK(graph.step_labels == std::vector<std::string>{"s", "t"});
    CHECK(graph.row_labels == std::vector<std::string>{"0", "1", "2"});
    std::string labels, arcs;
    for (const Graph::Node& node : graph.nodes) labels += node.label + ' ';
    CHECK(labels == "b A(1) a a b A(0.5) a a a b A(0.5) a b a ");
    for (const Graph::Edge& edge : graph.edges)
        if (edge.thin) {
            arcs += std::to_string(edge.from) + ">" + std::to_string(edge.to) + ' ';
            CHECK(edge.arrow);
            CHECK_FALSE(edge.places);
        }
    CHECK(arcs == "0>1 6>7 8>7 ");
    // Arcs hang below their row, from the one node to the other, and reach neither the next row nor a node.
    for (const bool shared : {false, true}) {
        const Graph drawn_graph =
            tree_graph(derivation_tree(rewriting, traced(rewriting, 2, {0, 1}), {{}, shared}));
        const GraphLayout layout = shared ? graph_layout(drawn_graph) : tree_layout(drawn_graph);
        std::size_t seen = 0;
        for (std::size_t i = 0; i < drawn_graph.edges.size(); ++i) {
            const Graph::Edge& edge = drawn_graph.edges[i];
            if (!edge.thin) continue;
            ++seen;
            const GraphLayout::Line& line = layout.edges[i];
            const Point from = layout.nodes[edge.from], to = layout.nodes[edge.to];
            REQUIRE(line.points.size() == 4);
            CHECK(from.y == to.y);
            for (const Point& point : line.points) {
                CHECK(point.y > from.y);
                CHECK(point.y < from.y + 36);
            }
            CHECK(std::fabs(line.tip->x - to.x) < node_size(drawn_graph.nodes[edge.to]).x / 2);
        }
        CHECK(seen >= 2);
    }
    const ReadDot dot(dot_text(graph));
    CHECK(dot.labels.at(1) == "A(1)");
}

TEST_CASE("subscripts are lowered, and turtle symbols are names like any other") {
    auto alphabet = std::make_shared<Alphabet>();
    const Symbol divided = alphabet->symbol("a_r"), slash = alphabet->symbol("\\"),
                 quote = alphabet->symbol("\"");
    const D0L system = make_d0l(alphabet, {divided}, {{divided, slash, quote}, {slash}, {quote}});
    const Graph graph = tree_graph(derivation_tree(system, 1));
    CHECK(graph.nodes[0].label == "a");
    CHECK(graph.nodes[0].subscript == "r");
    const std::string dot = dot_text(graph);
    CHECK(dot.find("label=a_r") != std::string::npos);
    CHECK(dot.find(R"(label="\\")") != std::string::npos);
    CHECK(dot.find(R"(label="\"")") != std::string::npos);
    for (const PictureFormat format : {PictureFormat::svg, PictureFormat::pdf, PictureFormat::png,
                                       PictureFormat::ps, PictureFormat::eps})
        CHECK(drawn(graph, format).size() > 500);
}

TEST_CASE("equal graphs are equal files, of the size that was asked for") {
    const D0L system = d0l("b", {{'a', "ab"}, {'b', "a"}});
    for (const Graph& graph : {tree_graph(derivation_tree(system, 4)),
                               tree_graph(derivation_tree(system, 4, {std::nullopt, true})),
                               growth_graph(system), families_graph()}) {
        for (const PictureFormat format :
             {PictureFormat::svg, PictureFormat::pdf, PictureFormat::png, PictureFormat::ps,
              PictureFormat::eps})
            CHECK(drawn(graph, format) == drawn(graph, format));
        CHECK(dot_text(graph) == dot_text(graph));
        GraphOptions options;
        options.width = 500;
        CHECK(test::Pixels(drawn(graph, PictureFormat::png, options)).width == 500);
    }
    GraphOptions options;
    options.width = 5;
    CHECK_THROWS_WITH_AS(drawn(families_graph(), PictureFormat::png, options),
                         "the width must be from 10 to 20000 pixels in png, not 5", Error);
    options = {};
    options.background = "blu";
    CHECK_THROWS_AS(drawn(families_graph(), PictureFormat::png, options), Error);
    Budget late;
    late.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    std::ostringstream out;
    CHECK_THROWS_AS(draw_graph(families_graph(), out, PictureFormat::svg, {}, late), BoundReached);
}

TEST_CASE("a tree wider than any page becomes smaller") {
    std::ostringstream out;
    const D0L wide =
        make_d0l(std::make_shared<Alphabet>(*d0l("a", {}).alphabet), Word(2000, 0), {{0}});
    CHECK(draw_graph(tree_graph(derivation_tree(wide, 0)), out, PictureFormat::svg).width <=
          14'400);
}

TEST_CASE("the growth digraph has the letters, their successors and their fates") {
    CHECK(rc::check("edges", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const Graph graph = growth_graph(system);
        std::map<std::pair<std::string, std::string>, std::string> edges, expected;
        for (const Graph::Edge& edge : graph.edges)
            if (graph.nodes[edge.from].shape != Graph::Node::Shape::start)
                RC_ASSERT(edges
                              .emplace(std::pair(graph.nodes[edge.from].label,
                                                 graph.nodes[edge.to].label),
                                       edge.label)
                              .second);
        for (const Symbol a : system.letters) {
            const std::string from = system.alphabet->name(a),
                              word = oracle::rewritten({from, written.successors}, 1);
            for (const char to : word) {
                const auto times = std::count(word.begin(), word.end(), to);
                expected[{from, std::string(1, to)}] = times > 1 ? "×" + std::to_string(times) : "";
            }
        }
        RC_ASSERT(edges == expected);
    }));
    const Graph graph = growth_graph(d0l("s", {{'s', "apmx"},
                                               {'a', "ab"},
                                               {'b', "ac"},
                                               {'c', "c"},
                                               {'p', "q"},
                                               {'q', "pm"},
                                               {'m', ""},
                                               {'x', "xx"}}));
    std::set<std::string> frames;
    for (const Graph::Group& group : graph.groups)
        frames.insert(group.label + " " + std::to_string(group.nodes.size()));
    CHECK(frames ==
          std::set<std::string>{"rate (1+√5)/2 = 1.6180... 2", "rate 2 1", "cycle of 2 2"});
    CHECK(graph.keys.size() == 4);
    CHECK(ReadDot(dot_text(graph)).frames.size() == 3);
    CHECK(growth_graph(d0l("ab", {{'a', "b"}})).keys.size() == 2);
}

TEST_CASE("the diagram of families is an order without lines that follow from others") {
    std::map<std::string, std::set<std::string>> above;
    for (const auto& [lower, upper] : family_inclusions()) above[lower].insert(upper);
    // What is above without the direct line.
    const auto reaches = [&](const auto& self, const std::string& from,
                             const std::string& to) -> bool {
        if (from == to) return true;
        for (const std::string& next : above[from])
            if (self(self, next, to)) return true;
        return false;
    };
    for (const auto& [lower, upper] : family_inclusions()) {
        CHECK_FALSE(reaches(reaches, upper, lower));
        for (const std::string& other : above[lower])
            if (other != upper) CHECK_FALSE(reaches(reaches, other, upper));
    }
    CHECK(reaches(reaches, "PD0L", "CS"));
    CHECK(reaches(reaches, "FIN", "E0L"));
    CHECK(reaches(reaches, "P0L", "IL"));
    for (const char* family : {"REG", "CF", "FIN"}) {
        CHECK_FALSE(reaches(reaches, "0L", family));
        CHECK_FALSE(reaches(reaches, family, "0L"));
    }
}

TEST_CASE("Rauzy graphs have the factors, and the ways between special ones have all letters") {
    std::size_t compared = 0, branching = 0;
    CHECK(rc::check([&] {
        // A word at random, closed to a circle, so that each factor goes on on both sides.
        const std::string letters = *rc::gen::element<std::string>("ab", "abc");
        const auto circle = *rc::gen::container<std::string>(*rc::gen::inRange<std::size_t>(3, 20),
                                                             rc::gen::elementOf(letters));
        const auto n = *rc::gen::inRange<std::size_t>(1, 4);
        std::set<std::string> nodes, edges;
        std::map<std::string, std::set<char>> before, behind;
        std::string text;
        while (text.size() < circle.size() + 2 * n + 2) text += circle;
        for (std::size_t i = 0; i < circle.size(); ++i) {
            const std::string edge = text.substr(i, n + 1);
            edges.insert(edge);
            nodes.insert(edge.substr(0, n));
            behind[edge.substr(0, n)].insert(edge.back());
            before[edge.substr(1)].insert(edge.front());
        }
        Alphabet alphabet;
        std::vector<Word> words;
        for (const std::string& edge : edges) {
            words.emplace_back();
            for (const char letter : edge)
                words.back().push_back(alphabet.symbol(std::string(1, letter)));
        }
        const Graph whole = rauzy_graph({words}, alphabet, false),
                    reduced = rauzy_graph({words}, alphabet, true);
        RC_ASSERT(whole.nodes.size() == nodes.size());
        RC_ASSERT(whole.edges.size() == edges.size());
        for (const Graph::Edge& edge : whole.edges)
            RC_ASSERT(edges.contains(whole.nodes[edge.from].label + edge.label) &&
                      whole.nodes[edge.to].label ==
                          (whole.nodes[edge.from].label + edge.label).substr(1));
        std::set<std::string> special;
        for (const std::string& node : nodes)
            if (before[node].size() > 1 || behind[node].size() > 1) special.insert(node);
        RC_ASSERT(reduced.nodes.size() == std::max<std::size_t>(1, special.size()));
        std::size_t letters_on_ways = 0;
        for (const Graph::Edge& edge : reduced.edges) {
            const std::string way = reduced.nodes[edge.from].label + edge.label;
            if (edge.label.ends_with(" letters")) {
                letters_on_ways += std::stoul(edge.label);
                continue;
            }
            letters_on_ways += edge.label.size();
            for (std::size_t i = 0; i + n < way.size(); ++i)
                RC_ASSERT(edges.contains(way.substr(i, n + 1)));
            RC_ASSERT(way.substr(way.size() - n) == reduced.nodes[edge.to].label);
        }
        RC_ASSERT(letters_on_ways == edges.size());
        for (const Graph::Node& node : reduced.nodes)
            RC_ASSERT(special.empty() || special.contains(node.label));
        ++compared;
        branching += special.size() > 1;
    }));
    CHECK(compared == 100);
    CHECK(branching >= 20);
}
