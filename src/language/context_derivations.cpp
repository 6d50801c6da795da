#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "system/system.hpp"

// How many derivations a word has in a system with context, and all of them.
//
// What a letter becomes depends on its word, so derivations of factors are not counted: words are. They are the nodes of a graph,
// and an edge from u to v has a weight, the number of ways to choose successors for the letters of u that make v. The number of
// derivations of n steps is the sum over the walks of n edges from the axiom to the word, of products of weights. Where no rule is
// erasing, only words that are not longer than the wanted one lead to it, so the graph is finite; with erasing rules
// it may be infinite, and then memory ends the work.
//
// There are infinitely many derivations if and only if some cycle of the graph lies on a walk from the axiom to the word.

namespace algae {

namespace {

class WordGraph {
public:
    struct Edge {
        std::size_t to;
        Integer ways;
    };

    WordGraph(const IL& system, const Word& wanted, const Budget& budget)
        : step_(system), wanted_(wanted), budget_(budget) {
        if (is_propagating(system)) longest_ = wanted.size();
        if (fits(system.axiom.size())) first_ = number(system.axiom);
    }

    /// The axiom; nothing where it is longer than any word that leads to the wanted one.
    const std::optional<std::size_t>& first() const { return first_; }
    std::optional<std::size_t> wanted() const {
        const auto known = numbers_.find(wanted_);
        if (known == numbers_.end()) return std::nullopt;
        return known->second;
    }
    std::size_t size() const { return words_.size(); }
    const Word& word(std::size_t node) const { return words_[node]->first; }

    const std::vector<Edge>& edges(std::size_t node) {
        if (!edges_[node]) {
            std::vector<Edge> found;
            for (auto& [word, ways] : successors(word_of(node)))
                found.push_back({number(word), std::move(ways)});
            edges_[node] = std::move(found);
        }
        return *edges_[node];
    }

    /// Finds all words. Throws BoundReached if they take more than a part of the budget's memory.
    void close() {
        for (std::size_t node = 0; node < size(); ++node) edges(node);
    }

    /// Calls visit(choices) for each way in which the letters of one word make the other one; false stops.
    bool each_way(std::size_t from, std::size_t to,
                  const std::function<bool(const std::vector<std::uint32_t>&)>& visit) {
        const Word &begin = word(from), &end = word(to);
        const auto choices = step_.successors(begin);
        // By letters left and place in the word: whether they make what stands from there on.
        std::vector<std::vector<char>> makes(begin.size() + 1,
                                             std::vector<char>(end.size() + 1, 0));
        makes.back().back() = 1;
        for (std::size_t i = begin.size(); i-- > 0;)
            for (std::size_t at = 0; at <= end.size(); ++at)
                for (const Word& one : *choices[i])
                    if (stands(one, end, at) && makes[i + 1][at + one.size()]) makes[i][at] = 1;
        std::vector<std::uint32_t> chosen;
        const std::function<bool(std::size_t, std::size_t)> go = [&](std::size_t i,
                                                                     std::size_t at) {
            if (i == begin.size()) return visit(chosen);
            for (std::uint32_t k = 0; k < choices[i]->size(); ++k) {
                const Word& one = (*choices[i])[k];
                if (!stands(one, end, at) || !makes[i + 1][at + one.size()]) continue;
                chosen.push_back(k);
                const bool goes_on = go(i + 1, at + one.size());
                chosen.pop_back();
                if (!goes_on) return false;
            }
            return true;
        };
        return !makes.front().front() || go(0, 0);
    }

private:
    static bool stands(const Word& part, const Word& word, std::size_t at) {
        return part.size() <= word.size() - at &&
               std::equal(part.begin(), part.end(), word.begin() + static_cast<std::ptrdiff_t>(at));
    }
    bool fits(std::size_t length) const { return !longest_ || length <= *longest_; }
    const Word word_of(std::size_t node) const { return words_[node]->first; }

    void spend(std::size_t letters) {
        bytes_ += letters * sizeof(Symbol) + 160;
        budget_.check_memory(4 * bytes_, "the words of which derivations are counted");
    }

    std::size_t number(const Word& word) {
        const auto [place, is_new] = numbers_.emplace(word, numbers_.size());
        if (is_new) {
            words_.push_back(place);
            edges_.emplace_back();
            spend(word.size());
        }
        return place->second;
    }

    /// The words after one step that are not too long, each with the number of ways to it.
    std::map<Word, Integer> successors(const Word& word) {
        const auto choices = step_.successors(word);
        std::vector<std::size_t> least(word.size() + 1, 0);  // letters that the rest becomes
        for (std::size_t i = word.size(); i-- > 0;) {
            std::size_t shortest = choices[i]->front().size();
            for (const Word& one : *choices[i]) shortest = std::min(shortest, one.size());
            least[i] = least[i + 1] + shortest;
        }
        std::map<Word, Integer> begun{{Word{}, Integer(1)}};
        for (std::size_t i = 0; i < word.size(); ++i) {
            std::map<Word, Integer> further;
            std::uint64_t letters = 0;
            for (const auto& [made, ways] : begun) {
                budget_.check();
                for (const Word& one : *choices[i]) {
                    if (!fits(made.size() + one.size() + least[i + 1])) continue;
                    Word next = made;
                    next.insert(next.end(), one.begin(), one.end());
                    letters += next.size() + 40;
                    further[std::move(next)] += ways;
                }
                budget_.check_memory(letters * sizeof(Symbol), "the words after one step");
            }
            begun = std::move(further);
        }
        return begun;
    }

    ContextStep step_;
    const Word wanted_;
    const Budget& budget_;
    std::optional<std::size_t> longest_, first_;
    std::map<Word, std::size_t> numbers_;
    std::vector<std::map<Word, std::size_t>::const_iterator> words_;
    std::vector<std::optional<std::vector<Edge>>> edges_;
    std::uint64_t bytes_ = 0;
};

/// By node, whether a walk leads from it to the wanted word. The graph must be closed.
std::vector<char> leading(WordGraph& graph) {
    std::vector<std::vector<std::size_t>> before(graph.size());
    for (std::size_t node = 0; node < graph.size(); ++node)
        for (const WordGraph::Edge& edge : graph.edges(node)) before[edge.to].push_back(node);
    std::vector<char> leads(graph.size(), 0);
    std::vector<std::size_t> open;
    const auto add = [&](std::size_t node) {
        if (leads[node]) return;
        leads[node] = 1;
        open.push_back(node);
    };
    if (const auto wanted = graph.wanted()) add(*wanted);
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        for (const std::size_t earlier : before[node]) add(earlier);
    }
    return leads;
}

/// Whether these nodes have a cycle: some are left when those without an edge to another one are taken away again and again.
bool has_cycle(WordGraph& graph, const std::vector<char>& nodes) {
    std::vector<std::vector<std::size_t>> before(graph.size());
    std::vector<std::size_t> edges(graph.size(), 0), open;
    std::size_t left = 0;
    for (std::size_t node = 0; node < graph.size(); ++node) {
        if (!nodes[node]) continue;
        ++left;
        for (const WordGraph::Edge& edge : graph.edges(node))
            if (nodes[edge.to]) {
                ++edges[node];
                before[edge.to].push_back(node);
            }
        if (edges[node] == 0) open.push_back(node);
    }
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        --left;
        for (const std::size_t earlier : before[node])
            if (--edges[earlier] == 0) open.push_back(earlier);
    }
    return left > 0;
}

/// By word, the derivations of some number of steps.
using Counts = std::map<std::size_t, Integer>;

/// Those of one more step; of the nodes that lead to the wanted word where that is known.
Counts after(WordGraph& graph, const Counts& counts, const std::vector<char>* leads,
             const Budget& budget) {
    Counts next;
    for (const auto& [node, count] : counts) {
        budget.check();
        for (const WordGraph::Edge& edge : graph.edges(node))
            if (!leads || (*leads)[edge.to]) next[edge.to] += count * edge.ways;
    }
    return next;
}

Integer of_wanted(const WordGraph& graph, const Counts& counts) {
    const auto wanted = graph.wanted();
    const auto found = wanted ? counts.find(*wanted) : counts.end();
    return found == counts.end() ? Integer(0) : found->second;
}

}  // namespace

Integer number_of_derivations(const IL& system, const Word& word, std::uint64_t n,
                              const Budget& budget) {
    WordGraph graph(system, word, budget);
    Counts counts;
    if (graph.first()) counts[*graph.first()] = 1;
    for (std::uint64_t t = 0; t < n && !counts.empty(); ++t)
        counts = after(graph, counts, nullptr, budget);
    return of_wanted(graph, counts);
}

DerivationCounts derivation_counts(const IL& system, const Word& word, std::size_t listed,
                                   const Budget& budget) {
    DerivationCounts found;
    found.total = 0;
    WordGraph graph(system, word, budget);
    if (!graph.first()) return found;
    graph.close();
    const std::vector<char> leads = leading(graph);
    if (!leads[*graph.first()]) return found;
    const bool infinite = has_cycle(graph, leads);
    Counts counts{{*graph.first(), Integer(1)}};
    for (std::uint64_t n = 0; !counts.empty(); ++n) {
        if (infinite && found.by_steps.size() == listed) break;
        if (Integer count = of_wanted(graph, counts); !count.is_zero()) {
            *found.total += count;
            found.by_steps.push_back({n, std::move(count)});
        }
        counts = after(graph, counts, &leads, budget);
    }
    if (infinite) found.total.reset();
    return found;
}

std::vector<Derivation> derivations(const IL& system, const Word& word, std::uint64_t n,
                                    std::size_t most, const Budget& budget) {
    std::vector<Derivation> found;
    WordGraph graph(system, word, budget);
    if (most == 0 || !graph.first()) return found;
    // The words of each generation, then those of them from which a walk ends at the word.
    std::vector<std::set<std::size_t>> layers{{*graph.first()}};
    std::uint64_t nodes = 1;
    while (layers.size() <= n) {
        std::set<std::size_t> next;
        for (const std::size_t node : layers.back()) {
            budget.check();
            for (const WordGraph::Edge& edge : graph.edges(node)) next.insert(edge.to);
        }
        if (next.empty()) return found;
        nodes += next.size();
        budget.check_memory(nodes * 48, "the words of all generations");
        layers.push_back(std::move(next));
    }
    const auto wanted = graph.wanted();
    if (!wanted || layers.back().count(*wanted) == 0) return found;
    layers.back() = {*wanted};
    for (std::size_t t = layers.size() - 1; t-- > 0;)
        for (auto node = layers[t].begin(); node != layers[t].end();) {
            const auto& edges = graph.edges(*node);
            const bool leads = std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
                return layers[t + 1].count(edge.to) > 0;
            });
            node = leads ? std::next(node) : layers[t].erase(node);
        }
    if (layers.front().empty()) return found;
    // From word to word without recursion over the steps: ways of the steps so far, as places in lists of all of them.
    struct Way {
        std::size_t to;
        std::vector<std::uint32_t> choices;
    };
    struct Begun {
        std::vector<Way> ways;
        std::size_t next = 0;
    };
    const auto ways_from = [&](std::size_t node, std::size_t t) {
        Begun begun;
        std::uint64_t bytes = 0;
        for (const WordGraph::Edge& edge : graph.edges(node)) {
            if (layers[t + 1].count(edge.to) == 0) continue;
            graph.each_way(node, edge.to, [&](const std::vector<std::uint32_t>& choices) {
                begun.ways.push_back({edge.to, choices});
                bytes += choices.size() * sizeof(std::uint32_t) + 48;
                budget.check_memory(bytes, "the choices of one step");
                return begun.ways.size() < most;  // each leads to a derivation of its own
            });
            if (begun.ways.size() >= most) break;
        }
        return begun;
    };
    Derivation current;
    current.words.push_back(graph.word(*graph.first()));
    std::vector<Begun> path;
    std::uint64_t letters = 0;
    if (n > 0) path.push_back(ways_from(*graph.first(), 0));
    const auto keep = [&] {
        found.push_back(current);
        for (const Word& one : current.words) letters += 2 * one.size() + 16;
        budget.check_memory(letters * sizeof(Symbol), "the derivations");
    };
    if (n == 0) keep();
    while (!path.empty() && found.size() < most) {
        budget.check();
        Begun& here = path.back();
        current.words.resize(path.size());
        current.choices.resize(path.size() - 1);
        if (here.next == here.ways.size()) {
            path.pop_back();
            continue;
        }
        const Way& way = here.ways[here.next++];
        current.words.push_back(graph.word(way.to));
        current.choices.push_back(way.choices);
        if (path.size() == n)
            keep();
        else
            path.push_back(ways_from(way.to, path.size()));
    }
    return found;
}

std::optional<Derivation> shortest_derivation(const IL& system, const Word& word,
                                              const Budget& budget) {
    WordGraph graph(system, word, budget);
    if (!graph.first()) return std::nullopt;
    std::vector<std::size_t> from{0};  // by node, the one that it was found from
    for (std::size_t node = 0; node < graph.size() && !graph.wanted(); ++node) {
        graph.edges(node);
        from.resize(graph.size(), node);
    }
    const auto wanted = graph.wanted();
    if (!wanted) return std::nullopt;
    Derivation found;
    std::vector<std::size_t> nodes{*wanted};
    while (nodes.back() != *graph.first()) nodes.push_back(from[nodes.back()]);
    std::reverse(nodes.begin(), nodes.end());
    for (std::size_t t = 0; t < nodes.size(); ++t) {
        found.words.push_back(graph.word(nodes[t]));
        if (t + 1 < nodes.size())
            graph.each_way(nodes[t], nodes[t + 1], [&](const std::vector<std::uint32_t>& choices) {
                found.choices.push_back(choices);
                return false;
            });
    }
    return found;
}

}  // namespace algae
