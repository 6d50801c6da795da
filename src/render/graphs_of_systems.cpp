#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "growth/growth.hpp"
#include "language/language.hpp"
#include "render/detail/graph.hpp"
#include "render/render.hpp"

// The graphs that are drawn: the growth digraph of a D0L system, Rauzy graphs of its factors, a derivation tree, and the diagram of the families.
//
// The growth digraph has an edge from a letter to each letter of its successor. What becomes of a letter in the long run is
// decided by its strongly connected component (Rozenberg and Salomaa 1980, I.3), and colours tell these four fates: a
// component with a rate above 1 multiplies, one with rate 1 is a cycle whose letters come back once a round, and a letter without
// a rate is mortal if its lifetime ends, otherwise it passes. Frames are given from above, because the list of components
// has first what occurs in others.
//
// A derivation tree has a row for each generation, in word order. Shared subtrees make it a graph that is no tree: then `dot` places
// it, and an edge says how often its letter occurs. Letters that are rewritten have a colour each where there are few of them; a
// module is labelled as words are printed, and thin arcs come from what its rule saw. A table stands between the rows of its step.
//
// The inclusions between families are a table from the literature, without those that follow from others.

namespace algae {

namespace {

/// Pale colours that can be told apart, in print too, for as many letters as one can keep in mind.
constexpr std::array<Colour, 8> tints{{{0.78, 0.87, 0.96},
                                       {0.99, 0.87, 0.68},
                                       {0.80, 0.92, 0.77},
                                       {0.96, 0.80, 0.82},
                                       {0.86, 0.81, 0.93},
                                       {1.00, 0.97, 0.72},
                                       {0.76, 0.92, 0.91},
                                       {0.90, 0.85, 0.78}}};

}  // namespace

Graph::Node letter_node(const Alphabet& alphabet, Symbol letter) {
    Graph::Node node;
    node.label = alphabet.name(letter);
    const std::size_t mark = node.label.find('_');
    if (mark == std::string::npos || mark == 0 || mark + 1 == node.label.size() ||
        !is_short_name(node.label))
        return node;
    node.subscript = node.label.substr(mark + 1);
    node.label.resize(mark);
    return node;
}

namespace {

/// An edge that says how often what is below occurs, if more than once.
template <class Times>
Graph::Edge counted_edge(std::size_t from, std::size_t to, const Times& times, bool arrow) {
    using std::to_string;
    Graph::Edge edge;
    edge.from = from;
    edge.to = to;
    if (times > 1) edge.label = "×" + to_string(times);
    edge.arrow = arrow;
    return edge;
}

enum class Fate { mortal, passing, cycle, expanding };

constexpr std::array fates{Fate::expanding, Fate::cycle, Fate::passing, Fate::mortal};

Colour colour_of(Fate fate) {
    constexpr std::array<Colour, 4> colours{
        {{0.88, 0.88, 0.89}, {1, 1, 1}, {0.78, 0.87, 0.96}, {0.99, 0.83, 0.66}}};
    return colours[static_cast<std::size_t>(fate)];
}

/// A paler shade, behind letters of the colour.
Colour frame_colour(Fate fate) {
    const Colour colour = colour_of(fate);
    const auto pale = [](double share) { return 1 - (1 - share) * 0.35; };
    return {pale(colour.red), pale(colour.green), pale(colour.blue)};
}

const char* meaning(Fate fate) {
    constexpr std::array meanings{"mortal", "passes, never comes back", "comes back once a round",
                                  "multiplies"};
    return meanings[static_cast<std::size_t>(fate)];
}

/// "(1+√5)/2": roots with their sign, as one writes them.
std::string with_roots(std::string text) {
    const std::string name = "sqrt(";
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at)) {
        const std::size_t end = text.find_first_not_of("0123456789", at + name.size());
        if (end == std::string::npos || text[end] != ')') {
            at += name.size();
            continue;
        }
        text.replace(end, 1, "");
        text.replace(at, name.size(), "√");
    }
    return text;
}

std::string rate_text(const Rate& rate) {
    if (rate.integer()) return "rate " + rate.exact();
    const std::string exact = with_roots(rate.exact()), decimal = rate.decimal(5) + "...";
    return exact.size() > 24 ? "rate " + decimal : "rate " + exact + " = " + decimal;
}

}  // namespace

Graph growth_graph(const D0L& system, const Budget& budget) {
    const GrowthMatrix matrix = growth_matrix(system);
    const Components found = components(matrix, budget);
    const auto lives = lifetimes(matrix);
    Graph graph;
    std::vector<Fate> of_component;
    for (const Component& component : found.list) {
        Fate fate = Fate::passing;
        if (component.rate)
            fate = *component.rate == Rate(1) ? Fate::cycle : Fate::expanding;
        else if (lives[component.letters.front()])
            fate = Fate::mortal;
        of_component.push_back(fate);
    }
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        Graph::Node node = letter_node(*system.alphabet, system.letters[i]);
        node.fill = colour_of(of_component[found.of_letter[i]]);
        graph.nodes.push_back(std::move(node));
        for (const GrowthMatrix::Entry& entry : matrix.rows[i])
            graph.edges.push_back(counted_edge(i, entry.column, entry.times, true));
    }
    const std::vector<Integer> in_axiom = axiom_counts(system);
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        if (in_axiom[i] == 0) continue;
        Graph::Node start;
        start.shape = Graph::Node::Shape::start;
        graph.edges.push_back(counted_edge(graph.nodes.size(), i, in_axiom[i], true));
        graph.nodes.push_back(start);
    }
    // What stands before others in the list occurs below them, so frames are given from above.
    for (std::size_t k = found.list.size(); k-- > 0;) {
        const Component& component = found.list[k];
        const Fate fate = of_component[k];
        const bool framed =
            fate == Fate::expanding || (fate == Fate::cycle && component.letters.size() > 1);
        if (!framed) continue;
        Graph::Group group;
        group.label = fate == Fate::expanding
                          ? rate_text(*component.rate)
                          : "cycle of " + std::to_string(component.letters.size());
        group.fill = frame_colour(fate);
        group.nodes = component.letters;
        graph.groups.push_back(std::move(group));
    }
    for (const Fate fate : fates)
        if (std::ranges::count(of_component, fate) > 0)
            graph.keys.push_back({colour_of(fate), meaning(fate)});
    return graph;
}

namespace {

/// One Rauzy graph, before it is drawn.
class RauzyGraph {
public:
    explicit RauzyGraph(const std::vector<Word>& factors) {
        std::map<Word, std::size_t> numbers;
        const auto number = [&](Word word) {
            const auto [at, is_new] = numbers.emplace(std::move(word), words_.size());
            if (is_new) {
                words_.push_back(at->first);
                next_.emplace_back();
                before_.push_back(0);
            }
            return at->second;
        };
        for (const Word& factor : factors) {
            const std::size_t from = number(Word(factor.begin(), factor.end() - 1)),
                              to = number(Word(factor.begin() + 1, factor.end()));
            next_[from].emplace_back(to, factor.back());
            ++before_[to];
        }
    }

    /// Adds it to a graph that is drawn; gives the numbers of its nodes there.
    std::vector<std::size_t> draw(Graph& graph, const Alphabet& alphabet, bool reduced) const {
        std::vector<std::size_t> drawn(words_.size(), none), nodes;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (reduced && !is_end(i)) continue;
            drawn[i] = graph.nodes.size();
            nodes.push_back(drawn[i]);
            graph.nodes.push_back(node(i, alphabet));
        }
        if (nodes.empty() && !words_.empty()) {  // a circle
            drawn[0] = graph.nodes.size();
            nodes.push_back(drawn[0]);
            graph.nodes.push_back(node(0, alphabet));
        }
        for (std::size_t i = 0; i < words_.size(); ++i)
            if (drawn[i] != none)
                for (auto [to, letter] : next_[i]) {
                    Word way{letter};
                    while (drawn[to] == none) {
                        way.push_back(next_[to].front().second);
                        to = next_[to].front().first;
                    }
                    Graph::Edge edge;
                    edge.from = drawn[i];
                    edge.to = drawn[to];
                    edge.label = way.size() > letters_shown
                                     ? std::to_string(way.size()) + " letters"
                                     : spell(alphabet, way);
                    edge.arrow = true;
                    graph.edges.push_back(std::move(edge));
                }
        return nodes;
    }

    static void explain(Graph& graph) {
        for (const auto& [fill, text] : keys())
            if (std::ranges::count(graph.nodes, std::optional(fill), &Graph::Node::fill) > 0)
                graph.keys.push_back({fill, text});
    }

private:
    static constexpr std::size_t none = ~std::size_t{0};
    static constexpr std::size_t letters_shown = 14;

    static std::array<std::pair<Colour, const char*>, 3> keys() {
        return {{{tints[0], "left special"}, {tints[2], "right special"}, {tints[1], "bispecial"}}};
    }

    /// Whether a way may not go through it: there are several ways, or none, to it or on from it.
    bool is_end(std::size_t i) const { return before_[i] != 1 || next_[i].size() != 1; }

    Graph::Node node(std::size_t i, const Alphabet& alphabet) const {
        const Word& word = words_[i];
        Graph::Node found;
        if (word.size() <= letters_shown) {
            found.label = spell(alphabet, word);
        } else {
            constexpr std::ptrdiff_t part = letters_shown / 2 - 1;
            found.label = spell(alphabet, Word(word.begin(), word.begin() + part)) + "..." +
                          spell(alphabet, Word(word.end() - part, word.end()));
        }
        const bool left = before_[i] > 1, right = next_[i].size() > 1;
        if (left || right) found.fill = keys()[left && right ? 2 : left ? 0 : 1].first;
        return found;
    }

    std::vector<Word> words_;
    std::vector<std::vector<std::pair<std::size_t, Symbol>>> next_;
    std::vector<std::size_t> before_;  // how many edges lead to a node
};

}  // namespace

Graph rauzy_graph(const std::vector<std::vector<Word>>& factors, const Alphabet& alphabet,
                  bool reduced) {
    Graph graph;
    for (const std::vector<Word>& some : factors) {
        const std::vector<std::size_t> nodes = RauzyGraph(some).draw(graph, alphabet, reduced);
        if (factors.size() < 2 || some.empty()) continue;
        const std::string label = "n = " + std::to_string(some.front().size() - 1);
        graph.groups.push_back({label, {0.96, 0.96, 0.96}, nodes});
    }
    RauzyGraph::explain(graph);
    return graph;
}

namespace {

using Kind = DerivationTree::Node::Kind;

/// "377", "3.5e20" for what has many digits; "ε" for nothing.
std::string leaves_text(const Integer& leaves) {
    if (leaves < 0) return "...";
    if (leaves == 0) return "ε";
    const std::string digits = to_string(leaves);
    if (digits.size() <= 6) return digits;
    return digits.substr(0, 1) + "." + digits.substr(1, 1) + "e" +
           std::to_string(digits.size() - 1);
}

/// The letters that somewhere become something else than themselves, or are never rewritten in the
/// tree, in order of first occurrence.
std::vector<Symbol> rewritten_letters(const DerivationTree& tree) {
    std::vector<Symbol> order;
    std::map<Symbol, bool> stays;  // of letters that have children
    for (const auto& node : tree.nodes) {
        if (node.kind != Kind::letter) continue;
        if (!std::ranges::count(order, node.letter)) order.push_back(node.letter);
        if (node.children.empty()) continue;
        const auto& child = tree.nodes[node.children.front()];
        if (child.kind == Kind::omitted) continue;
        const bool same = node.children.size() == 1 && child.kind == Kind::letter &&
                          child.letter == node.letter && child.text == node.text;
        const auto known = stays.emplace(node.letter, same).first;
        known->second = known->second && same;
    }
    std::erase_if(order, [&](Symbol a) { return stays.contains(a) && stays[a]; });
    return order;
}

bool is_shared(const DerivationTree& tree) {
    return tree.roots.size() + edge_count(tree) != tree.nodes.size();
}

}  // namespace

Graph tree_graph(const DerivationTree& tree) {
    Graph graph;
    graph.straight = true;
    graph.ordered = true;
    graph.trees = !is_shared(tree);
    const std::vector<Symbol> rewritten = rewritten_letters(tree);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const auto& node = tree.nodes[i];
        Graph::Node drawn;
        if (node.kind == Kind::erased) {
            drawn.label = "ε";
            drawn.shape = Graph::Node::Shape::bare;
        } else if (node.kind == Kind::omitted) {
            drawn.label = leaves_text(node.leaves);
            drawn.shape = Graph::Node::Shape::triangle;
        } else {
            if (node.text.empty())
                drawn = letter_node(*tree.alphabet, node.letter);
            else
                drawn.label = node.text;
            const auto found = std::ranges::find(rewritten, node.letter);
            if (found == rewritten.end())
                drawn.shape = Graph::Node::Shape::bare;
            else if (rewritten.size() <= tints.size())
                drawn.fill = tints[static_cast<std::size_t>(found - rewritten.begin())];
        }
        graph.nodes.push_back(std::move(drawn));
        if (graph.rows.size() <= node.generation) graph.rows.resize(node.generation + 1);
        graph.rows[node.generation].push_back(i);

        std::vector<std::pair<std::size_t, std::size_t>> below;  // each child once, and how often
        for (const std::size_t child : node.children) {
            const auto known =
                std::ranges::find(below, child, &std::pair<std::size_t, std::size_t>::first);
            if (known == below.end())
                below.emplace_back(child, 1);
            else
                ++known->second;
        }
        for (const auto& [child, times] : below)
            graph.edges.push_back(counted_edge(i, child, times, false));
        for (const std::size_t other : node.seen) {
            Graph::Edge seen;
            seen.from = other;
            seen.to = i;
            seen.arrow = seen.thin = true;
            seen.places = false;
            graph.edges.push_back(seen);
        }
    }
    // Rows of nothing but marks are no generation of their own.
    for (std::size_t t = 0; t < graph.rows.size(); ++t) {
        const bool letters = std::ranges::any_of(
            graph.rows[t], [&](std::size_t i) { return tree.nodes[i].kind != Kind::omitted; });
        graph.row_labels.push_back(letters ? std::to_string(t) : "");
    }
    graph.step_labels = tree.tables;
    return graph;
}

namespace {

const Colour chomsky{0.99, 0.87, 0.68}, pure{0.78, 0.87, 0.96}, extended{0.80, 0.92, 0.77};

std::size_t node_of(Graph& graph, const std::string& family) {
    const auto found = std::ranges::find(graph.nodes, family, &Graph::Node::label);
    if (found != graph.nodes.end()) return static_cast<std::size_t>(found - graph.nodes.begin());
    Graph::Node node;
    node.label = family;
    node.shape = Graph::Node::Shape::box;
    node.fill = !family.ends_with("L") ? chomsky : family.starts_with("E") ? extended : pure;
    graph.nodes.push_back(std::move(node));
    return graph.nodes.size() - 1;
}

Graph::Edge edge(Graph& graph, const char* lower, const char* upper) {
    const std::size_t from = node_of(graph, lower);
    return counted_edge(from, node_of(graph, upper), 1, false);
}

}  // namespace

const std::vector<std::pair<const char*, const char*>>& family_inclusions() {
    static const std::vector<std::pair<const char*, const char*>> inclusions{
        {"PD0L", "D0L"},  {"PD0L", "P0L"}, {"D0L", "0L"},     {"P0L", "0L"},  {"D0L", "DT0L"},
        {"0L", "T0L"},    {"DT0L", "T0L"}, {"0L", "E0L"},     {"0L", "IL"},   {"DT0L", "EDT0L"},
        {"T0L", "ET0L"},  {"E0L", "ET0L"}, {"EDT0L", "ET0L"}, {"FIN", "REG"}, {"REG", "CF"},
        {"REG", "EDT0L"}, {"REG", "IL"},   {"CF", "E0L"},     {"ET0L", "CS"},
    };
    return inclusions;
}

Graph families_graph() {
    Graph graph;
    graph.upward = true;
    for (const auto& [lower, upper] : family_inclusions())
        graph.edges.push_back(edge(graph, lower, upper));
    for (const char* family : {"REG", "CF"}) {
        Graph::Edge incomparable = edge(graph, "0L", family);
        incomparable.dashed = true;
        incomparable.places = false;
        graph.edges.push_back(incomparable);
    }
    graph.keys = {
        {chomsky, "Chomsky's families and FIN"}, {pure, "L-systems"}, {extended, "with terminals"}};
    graph.caption = "A line leads up to a larger family; dashed: neither contains the other";
    return graph;
}

}  // namespace algae
