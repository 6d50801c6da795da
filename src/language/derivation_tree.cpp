#include "language/language.hpp"

#include <algorithm>
#include <map>

#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "rewrite/rewrite.hpp"
#include "system/system.hpp"
#include "watch/watch.hpp"

// Derivations as trees, of D0L systems generation by generation, of given derivations and of modules, whole, cut at a
// depth, or with equal subtrees shared.
//
// Sizes are known without the tree: a system in which every letter leaves one more letter behind has as many
// letters in generation n as the tree has nodes. With shared subtrees a generation has each letter once, and
// the sets of letters of the generations repeat. Of systems with parameters, chance or contexts nothing is known without
// the derivation, so they are derived first, and the tree is made of what came of each module.

namespace algae {

namespace {

using Node = DerivationTree::Node;

constexpr double most_bits = 1000;  // of the number of letters below a cut

/// Every letter leaves one more letter behind for each generation that it has: h'(a) = h(a) c, and
/// h'(a) = c c where h(a) is empty. So the length of generation n counts the letters of generation
/// n, all letters of generations before, and what was erased.
D0L leaving_letters_behind(const D0L& system) {
    auto alphabet = std::make_shared<Alphabet>(*system.alphabet);
    std::string name = "c";
    while (alphabet->find(name)) name += 'c';
    const Symbol mark = alphabet->symbol(name);
    std::vector<Word> images = system.rules.images();
    for (Word& image : images) {
        if (image.empty()) image.push_back(mark);
        image.push_back(mark);
    }
    images.push_back({mark});
    return make_d0l(std::move(alphabet), system.axiom, std::move(images), system.name);
}

/// The letters of a word, each once, by first occurrence.
Word distinct(const Word& word) {
    Word found;
    for (const Symbol a : word)
        if (std::find(found.begin(), found.end(), a) == found.end()) found.push_back(a);
    return found;
}

/// The letters of the next generation by first occurrence, and whether something is erased.
std::pair<Word, bool> next_letters(const D0L& system, const Word& letters) {
    Word next;
    std::vector<char> seen(system.alphabet->size(), 0);
    bool erases = false;
    for (const Symbol a : letters) {
        erases = erases || system.successor(a).empty();
        for (const Symbol b : system.successor(a))
            if (!std::exchange(seen[b], 1)) next.push_back(b);
    }
    return {next, erases};
}

/// The nodes of generations 0 to last where each generation has each letter once: the number of
/// letters of every generation repeats when the generation does.
Integer shared_size(const D0L& system, std::uint64_t last, bool cut, const Budget& budget) {
    std::map<Word, std::size_t> first;     // where the letters of a generation first came
    std::vector<std::uint64_t> before{0};  // nodes of all generations before, erased ones with them
    Word letters = distinct(system.axiom);
    WorkCount generations("generation", last);
    for (std::size_t t = 0;; ++t) {
        budget.check();
        generations.at(t);
        budget.check_memory((t + 1) * (letters.size() * sizeof(Symbol) + 100),
                            "letters of generations");
        if (t == last) return Integer(before[t] + letters.size() * (cut ? 2 : 1));
        const auto [found, is_new] = first.emplace(letters, t);
        if (!is_new) {
            const std::size_t from = found->second, period = t - from;
            const std::uint64_t rounds = (last - from) / period;
            const auto rest = static_cast<std::size_t>((last - from) % period);
            // The letters of generation `last` are those of generation from + rest.
            std::uint64_t there = 0;
            for (const auto& [word, generation] : first)
                if (generation == from + rest) there = word.size();
            return Integer(before[t] - before[from]) * Integer(rounds) +
                   Integer(before[from + rest]) + Integer(there * (cut ? 2 : 1));
        }
        auto [next, erases] = next_letters(system, letters);
        before.push_back(before[t] + letters.size() + (erases ? 1 : 0));
        letters = std::move(next);
    }
}

/// Builds a tree generation by generation. `successor(t, i, a)` is what letter number i of the
/// letters of generation t, the letter a, becomes; `below(i, a)` counts what is left out below it.
template <class Successor, class Below>
DerivationTree build(std::shared_ptr<const Alphabet> alphabet, const Word& axiom,
                     std::uint64_t last, bool cut, bool one_of_each, Successor successor,
                     Below below, const Budget& budget) {
    using enum Node::Kind;
    DerivationTree tree;
    tree.alphabet = std::move(alphabet);
    const auto add = [&](Node node) {
        if (tree.nodes.size() >= budget.letters)
            throw BoundReached(Bound::letters,
                               "the tree has more than " + std::to_string(budget.letters) +
                                   " nodes, the letters allowed" + budget.by(Bound::letters));
        tree.nodes.push_back(std::move(node));
        return tree.nodes.size() - 1;
    };
    // In one generation, the only node of each letter, where there is one of each.
    std::map<std::pair<Node::Kind, Symbol>, std::size_t> known;
    const auto place = [&](Node::Kind kind, Symbol a, std::uint64_t generation, auto leaves) {
        if (!one_of_each) return add({kind, a, generation, leaves(), {}});
        const auto [found, is_new] = known.try_emplace({kind, a}, 0);
        if (is_new) found->second = add({kind, a, generation, leaves(), {}});
        return found->second;
    };
    const auto none = [] { return Integer(0); };

    for (const Symbol a : axiom) tree.roots.push_back(place(letter, a, 0, none));
    if (axiom.empty()) tree.roots.push_back(place(erased, 0, 0, none));
    std::size_t begin = 0;
    WorkCount generations("generation", last), nodes("nodes");
    for (std::uint64_t t = 0; begin < tree.nodes.size() && (t < last || cut); ++t) {
        budget.check();
        generations.at(t + 1);
        nodes.at(tree.nodes.size());
        known.clear();
        const std::size_t end = tree.nodes.size();
        for (std::size_t node = begin, i = 0; node < end; ++node) {
            if (tree.nodes[node].kind != letter) continue;
            const Symbol a = tree.nodes[node].letter;
            std::vector<std::size_t> children;
            if (t == last) {
                children.push_back(place(omitted, a, t + 1, [&] { return below(i, a); }));
            } else {
                const Word& word = successor(t, i, a);
                for (const Symbol b : word) children.push_back(place(letter, b, t + 1, none));
                if (word.empty()) children.push_back(place(erased, 0, t + 1, none));
            }
            tree.nodes[node].children = std::move(children);
            ++i;
        }
        begin = end;
        if (t == last) break;
    }
    return tree;
}

/// What letter number i of a word of a derivation becomes.
const Word& successor_in(const ET0L& system, const Derivation& derivation, std::uint64_t t,
                         std::size_t i) {
    const auto step = static_cast<std::size_t>(t);
    const std::uint32_t table = derivation.tables.empty() ? 0 : derivation.tables[step];
    return system.tables.at(table)[derivation.words[step][i]][derivation.choices[step][i]];
}

/// The last generation that is shown, and whether something is left out below it.
std::pair<std::uint64_t, bool> extent(std::uint64_t n, const TreeShape& shape) {
    if (shape.depth && *shape.depth < n) return {*shape.depth, true};
    return {n, false};
}

}  // namespace

Integer tree_size(const D0L& system, std::uint64_t n, const TreeShape& shape,
                  const Budget& budget) {
    const auto [last, cut] = extent(n, shape);
    if (system.axiom.empty()) return 1;
    if (shape.shared) return shared_size(system, last, cut, budget);
    const Integer shown = length(leaving_letters_behind(system), last, budget);
    return cut ? shown + length(system, last, budget) : shown;
}

DerivationTree derivation_tree(const D0L& system, std::uint64_t n, const TreeShape& shape,
                               const Budget& budget) {
    const auto [last, cut] = extent(n, shape);
    const std::uint64_t rest = n - last;
    std::map<Symbol, Integer> lengths;  // of what letters become in the generations left out
    const auto below = [&](std::size_t, Symbol a) {
        const auto found = lengths.find(a);
        if (found != lengths.end()) return found->second;
        D0L from = system;
        from.axiom = {a};
        const bool countable = estimated_log2_length(from, rest) < most_bits;
        return lengths.emplace(a, countable ? length(from, rest, budget) : Integer(-1))
            .first->second;
    };
    const auto successor = [&](std::uint64_t, std::size_t, Symbol a) -> const Word& {
        return system.successor(a);
    };
    return build(system.alphabet, system.axiom, last, cut, shape.shared, successor, below, budget);
}

Integer tree_size(const ET0L& system, const Derivation& derivation, const TreeShape& shape,
                  const Budget& budget) {
    if (shape.shared)
        return Integer(derivation_tree(system, derivation, shape, budget).nodes.size());
    const auto [last, cut] = extent(derivation.choices.size(), shape);
    if (derivation.words.front().empty()) return 1;
    std::uint64_t nodes = 0;
    for (std::size_t t = 0; t <= last; ++t) {
        nodes += derivation.words[t].size();
        if (t == last) break;
        for (std::size_t i = 0; i < derivation.words[t].size(); ++i)
            nodes += successor_in(system, derivation, t, i).empty();
    }
    return Integer(cut ? nodes + derivation.words[static_cast<std::size_t>(last)].size() : nodes);
}

DerivationTree derivation_tree(const ET0L& system, const Derivation& derivation,
                               const TreeShape& shape, const Budget& budget) {
    const auto [last, cut] = extent(derivation.choices.size(), shape);
    const auto successor = [&](std::uint64_t t, std::size_t i, Symbol) -> const Word& {
        return successor_in(system, derivation, t, i);
    };
    // How many letters of the last word stand below each letter of the last generation shown.
    std::vector<std::uint64_t> counts(derivation.words.back().size(), 1);
    for (std::size_t t = derivation.choices.size(); t-- > last;) {
        std::vector<std::uint64_t> above;
        std::size_t next = 0;
        for (std::size_t i = 0; i < derivation.words[t].size(); ++i) {
            std::uint64_t sum = 0;
            for (std::size_t k = successor_in(system, derivation, t, i).size(); k > 0; --k)
                sum += counts.at(next++);
            above.push_back(sum);
        }
        counts = std::move(above);
    }
    const auto below = [&](std::size_t i, Symbol) { return Integer(counts.at(i)); };
    DerivationTree tree = build(system.alphabet, derivation.words.front(), last, cut, false,
                                successor, below, budget);
    for (std::size_t t = 0; t < last && !derivation.tables.empty(); ++t)
        tree.tables.push_back(system.table_names.at(derivation.tables[t]));
    return shape.shared ? with_shared_subtrees(tree, budget) : tree;
}

namespace {

/// The last generation of a trace that is shown, and whether something is left out below it. Throws BoundReached if the
/// trace ends before.
std::pair<std::uint64_t, bool> extent(const ModuleTrace& trace, const TreeShape& shape) {
    const std::uint64_t steps = trace.lengths.size();
    if (!trace.goes_on) return extent(steps, shape);
    if (!shape.depth || *shape.depth > steps)
        throw BoundReached(Bound::letters, "the words of the derivation are too long after " +
                                               std::to_string(steps) + " steps");
    return {*shape.depth, true};
}

/// How many modules of the last word stand below each module of a generation; -1 where the trace ends before the last
/// word.
std::vector<Integer> modules_below(const ModuleTrace& trace, std::size_t generation) {
    if (trace.goes_on)
        return std::vector<Integer>(trace.words[generation].kinds.size(), Integer(-1));
    std::vector<std::uint64_t> counts(trace.words.back().kinds.size(), 1);
    for (std::size_t t = trace.lengths.size(); t-- > generation;) {
        std::vector<std::uint64_t> above;
        std::size_t next = 0;
        for (const std::uint32_t length : trace.lengths[t]) {
            std::uint64_t sum = 0;
            for (std::uint32_t k = 0; k < length; ++k) sum += counts.at(next++);
            above.push_back(sum);
        }
        counts = std::move(above);
    }
    return {counts.begin(), counts.end()};
}

}  // namespace

Integer tree_size(const Rewriting& rewriting, const ModuleTrace& trace, const TreeShape& shape,
                  const Budget& budget) {
    if (shape.shared) return Integer(derivation_tree(rewriting, trace, shape, budget).nodes.size());
    const auto [last, cut] = extent(trace, shape);
    if (trace.words.front().kinds.empty()) return 1;
    std::uint64_t nodes = 0;
    for (std::size_t t = 0; t <= last; ++t) {
        nodes += trace.words[t].kinds.size();
        if (t < last)
            nodes += static_cast<std::uint64_t>(
                std::count(trace.lengths[t].begin(), trace.lengths[t].end(), 0U));
    }
    return Integer(cut ? nodes + trace.words[static_cast<std::size_t>(last)].kinds.size() : nodes);
}

ModuleTrace traced(const Rewriting& rewriting, const IL& system, const Derivation& derivation,
                   const Budget& budget) {
    const ModuleKinds& kinds = rewriting.rules().kinds;
    std::map<std::string, ModuleKind> of_name;
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        if (kinds.arity(static_cast<ModuleKind>(kind)) == 0)
            of_name.emplace(rewriting.rules().system->alphabet.name(
                                kinds.letter(static_cast<ModuleKind>(kind))),
                            static_cast<ModuleKind>(kind));
    ContextStep step(system);
    ModuleTrace trace;
    for (std::size_t t = 0; t < derivation.words.size(); ++t) {
        const Word& word = derivation.words[t];
        ModuleString& modules = trace.words.emplace_back();
        for (const Symbol a : word) modules.kinds.push_back(of_name.at(system.alphabet->name(a)));
        if (t == derivation.choices.size()) break;
        // Which rule is picked of those with the same contexts does not matter for what is looked at.
        trace.seen.push_back(rewriting.traced(modules, t, 0, budget).seen);
        trace.tables.push_back(0);
        const auto successors = step.successors(word);
        std::vector<std::uint32_t>& lengths = trace.lengths.emplace_back();
        for (std::size_t i = 0; i < word.size(); ++i)
            lengths.push_back(
                static_cast<std::uint32_t>((*successors[i])[derivation.choices[t][i]].size()));
    }
    return trace;
}

DerivationTree derivation_tree(const Rewriting& rewriting, const ModuleTrace& trace,
                               const TreeShape& shape, const Budget& budget) {
    using enum Node::Kind;
    const auto [last, cut] = extent(trace, shape);
    const CompiledRules& rules = rewriting.rules();
    const ModuleText text(rules.system->alphabet, rules.kinds);
    DerivationTree tree;
    tree.alphabet = std::make_shared<const Alphabet>(rules.system->alphabet);
    const auto add = [&](Node node) {
        if (tree.nodes.size() >= budget.letters)
            throw BoundReached(Bound::letters,
                               "the tree has more than " + std::to_string(budget.letters) +
                                   " nodes, the letters allowed" + budget.by(Bound::letters));
        tree.nodes.push_back(std::move(node));
        return tree.nodes.size() - 1;
    };
    // The module at a position of generation t, whose parameters begin there.
    const auto add_module = [&](std::size_t t, std::size_t position, std::size_t values) {
        const ModuleString& word = trace.words[t];
        const ModuleKind kind = word.kinds[position];
        Node node{letter, rules.kinds.letter(kind), t, 0, {}};
        if (rules.kinds.arity(kind) > 0) node.text = text.text(kind, word.values.data() + values);
        return add(std::move(node));
    };

    std::vector<std::size_t> row;  // the nodes of one generation, by position
    std::size_t values = 0;
    for (std::size_t i = 0; i < trace.words.front().kinds.size(); ++i) {
        row.push_back(add_module(0, i, values));
        values += rules.kinds.arity(trace.words.front().kinds[i]);
    }
    if (row.empty()) add({erased, 0, 0, 0, {}});
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) tree.roots.push_back(i);
    WorkCount generations("generation", last), nodes("nodes");
    for (std::size_t t = 0; t < last && !row.empty(); ++t) {
        budget.check();
        generations.at(t + 1);
        nodes.at(tree.nodes.size());
        std::vector<std::size_t> next;
        values = 0;
        for (std::size_t i = 0; i < row.size(); ++i) {
            for (const std::size_t position : trace.seen[t][i])
                tree.nodes[row[i]].seen.push_back(row[position]);
            for (std::uint32_t k = 0; k < trace.lengths[t][i]; ++k) {
                const ModuleKind kind = trace.words[t + 1].kinds[next.size()];
                next.push_back(add_module(t + 1, next.size(), values));
                values += rules.kinds.arity(kind);
                tree.nodes[row[i]].children.push_back(next.back());
            }
            if (trace.lengths[t][i] == 0) {
                const std::size_t mark = add({erased, 0, t + 1, 0, {}});
                tree.nodes[row[i]].children.push_back(mark);
            }
        }
        row = std::move(next);
    }
    if (cut) {
        const std::vector<Integer> below = modules_below(trace, static_cast<std::size_t>(last));
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::size_t mark =
                add({omitted, tree.nodes[row[i]].letter, last + 1, below.at(i), {}});
            tree.nodes[row[i]].children.push_back(mark);
        }
    }
    if (rules.system->tables.size() > 1)
        for (std::size_t t = 0; t < last; ++t)
            tree.tables.push_back(rules.system->tables.at(trace.tables[t]));
    return shape.shared ? with_shared_subtrees(tree, budget) : tree;
}

std::optional<std::uint64_t> depth_within(std::uint64_t n, std::uint64_t most_nodes,
                                          const std::function<Integer(const TreeShape&)>& size,
                                          bool shared) {
    const auto fits = [&](std::uint64_t depth) {
        return size({depth, shared}) <= Integer(most_nodes);
    };
    if (n == 0 || !fits(0)) return std::nullopt;
    std::uint64_t low = 0, step = 1;  // low fits
    while (step < n - low && fits(low + step)) {
        low += step;
        step *= 2;
    }
    for (std::uint64_t high = std::min(n, low + step); high - low > 1;) {
        const std::uint64_t middle = low + (high - low) / 2;
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

DerivationTree with_shared_subtrees(const DerivationTree& tree, const Budget& budget) {
    using Key = std::tuple<std::uint64_t, Node::Kind, Symbol, std::string, Integer,
                           std::vector<std::size_t>>;
    std::map<Key, std::size_t> classes;
    std::vector<std::size_t> of_node(tree.nodes.size());
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        if (i % 1024 == 0) budget.check();
        const Node& node = tree.nodes[i];
        std::vector<std::size_t> children;
        for (const std::size_t child : node.children) children.push_back(of_node[child]);
        of_node[i] = classes
                         .try_emplace({node.generation, node.kind, node.letter, node.text,
                                       node.leaves, std::move(children)},
                                      classes.size())
                         .first->second;
    }
    constexpr std::size_t nowhere = SIZE_MAX;
    std::vector<std::size_t> place(classes.size(), nowhere);
    DerivationTree shared;
    shared.alphabet = tree.alphabet;
    shared.tables = tree.tables;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (place[of_node[i]] != nowhere) continue;
        place[of_node[i]] = shared.nodes.size();
        shared.nodes.push_back(tree.nodes[i]);
    }
    for (Node& node : shared.nodes) {
        for (std::size_t& child : node.children) child = place[of_node[child]];
        node.seen.clear();
    }
    // What any of the letters that are one now saw.
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        for (const std::size_t other : tree.nodes[i].seen)
            shared.nodes[place[of_node[i]]].seen.push_back(place[of_node[other]]);
    for (Node& node : shared.nodes) {
        std::sort(node.seen.begin(), node.seen.end());
        node.seen.erase(std::unique(node.seen.begin(), node.seen.end()), node.seen.end());
    }
    for (const std::size_t root : tree.roots) shared.roots.push_back(place[of_node[root]]);
    return shared;
}

std::uint64_t depth(const DerivationTree& tree) {
    std::uint64_t deepest = 0;
    for (const Node& node : tree.nodes)
        if (node.kind == Node::Kind::letter) deepest = std::max(deepest, node.generation);
    return deepest;
}

std::uint64_t edge_count(const DerivationTree& tree) {
    std::uint64_t edges = 0;
    for (const Node& node : tree.nodes) edges += node.children.size();
    return edges;
}

std::uint64_t context_count(const DerivationTree& tree) {
    std::uint64_t seen = 0;
    for (const Node& node : tree.nodes) seen += node.seen.size();
    return seen;
}

Word leaves(const DerivationTree& tree, const Budget& budget) {
    Word word;
    std::vector<std::size_t> open(tree.roots.rbegin(), tree.roots.rend());
    for (std::uint64_t steps = 1; !open.empty(); ++steps) {
        if (steps % 1024 == 0) budget.check();
        const Node& node = tree.nodes[open.back()];
        open.pop_back();
        if (node.kind == Node::Kind::omitted)
            throw Error("the tree is cut: its leaves spell no word");
        if (node.kind == Node::Kind::letter && node.children.empty()) {
            if (word.size() >= budget.letters)
                throw BoundReached(Bound::letters, "the tree has more than " +
                                                       std::to_string(budget.letters) + " leaves");
            word.push_back(node.letter);
        }
        open.insert(open.end(), node.children.rbegin(), node.children.rend());
    }
    return word;
}

}  // namespace algae
