// `algae tree`: graphs that Graphviz lays out. The derivation tree of a generation or of one word, the digraph
// of growth, Rauzy graphs of factors, and the diagram of families of languages.
//
// The size of a tree is computed before the tree is made. A tree that is too large is refused with its size and
// with trees that would fit: a smaller depth, or --dag, which draws equal subtrees of one generation once.
//
// Of a D0L system sizes follow from the rules. Systems with parameters, chance, tables or contexts are derived as `derive`
// derives them, with the same choices, as far as words stay short; the tree is made of what came of each module.

#include <algorithm>
#include <cctype>
#include <functional>
#include <optional>

#include "command/detail/choices.hpp"
#include "command/detail/files.hpp"
#include "command/detail/output.hpp"
#include "command/detail/pictures.hpp"
#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "render/render.hpp"
#include "rewrite/rewrite.hpp"
#include "system/system.hpp"

namespace algae::command {

namespace {

struct Options {
    std::string file, word, tables, output, format, background;
    std::vector<std::string> let;
    std::optional<std::uint64_t> generation, depth, seed;
    std::optional<Range> rauzy;
    std::optional<double> width, height;
    std::uint64_t most_nodes = 2000;
    bool shared = false, graph = false, families = false, reduced = false, json = false;
    Bounds bounds;
};

using SizeOf = std::function<Integer(const TreeShape&)>;

/// The format by the name of the file or by --format: a picture, otherwise LaTeX or Graphviz's own language.
struct TreeFormat {
    std::optional<PictureFormat> picture;
    bool latex = false;
    std::optional<AnimationFormat> animation = {};
};

TreeFormat format_of(const Options& options) {
    if (options.output == "-" && options.format.empty())
        throw Error("-o -: say which format with --format: svg, pdf, png, ps, eps, tex or dot");
    const std::string name = options.format.empty() ? options.output : "tree." + options.format;
    std::string end = name.substr(std::min(name.size(), name.find_last_of("./") + 1));
    for (char& letter : end)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    if (end == "dot" || end == "gv") return {};
    if (end == "tex") return {std::nullopt, true};
    if (const auto animation = animation_format(name); animation && options.rauzy)
        return {std::nullopt, false, animation};
    try {
        return {picture_format(name)};
    } catch (const Error&) {
        throw Error(
            "expected a file ending in .svg, .pdf, .png, .ps, .eps, .tex, .dot or .gv, found \"" +
            name + '"');
    }
}

void check_usage(const Options& options) {
    const bool tree = options.generation || !options.word.empty();
    const int asked = (options.generation ? 1 : 0) + (options.word.empty() ? 0 : 1) +
                      (options.rauzy ? 1 : 0) + options.graph + options.families;
    if (asked == 0)
        throw Error(
            "say which tree: -n N for a generation, --word WORD for a member; or --graph, --rauzy "
            "N or --families");
    if (asked > 1) throw Error("-n, --word, --graph, --rauzy and --families exclude each other");
    if (options.reduced && !options.rauzy) throw Error("--reduced is for Rauzy graphs: --rauzy N");
    if (options.families != options.file.empty())
        throw Error(options.families
                        ? "--families draws families of languages and takes no FILE, found \"" +
                              options.file + '"'
                        : std::string("FILE is missing: ") + file_help);
    if (!tree && (options.shared || options.depth))
        throw Error("--dag and --depth are for trees: -n or --word");
    if (!options.generation && (options.seed || !options.tables.empty()))
        throw Error("--seed and --tables go with -n: they say how the generation is derived");
}

/// Throws BoundReached with the size, and with shapes that are smaller, if the tree is too large to show.
void check_size(const Options& options, std::uint64_t n, const TreeShape& shape,
                const SizeOf& size) {
    const std::uint64_t most = options.most_nodes;
    std::string found;
    try {
        const Integer nodes = size(shape);
        if (nodes <= Integer(most)) return;
        found = readable(nodes) + " nodes";
    } catch (const BoundReached& bound) {
        if (bound.bound() == Bound::time) throw;
        found = "more nodes than can be counted";
    }
    std::string message = std::string("the tree has ") + found + ", more than the " +
                          std::to_string(most) + " of --max-nodes";
    const auto suggest = [&](const std::string& option, const TreeShape& smaller) {
        try {
            message += "; " + option + " has " + readable(size(smaller));
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
        }
    };
    const std::uint64_t last = std::min(n, shape.depth.value_or(n));
    if (const auto depth = depth_within(last, most, size, shape.shared))
        suggest("--depth " + std::to_string(*depth), {*depth, shape.shared});
    if (!shape.shared) suggest("--dag", {shape.depth, true});
    throw BoundReached(Bound::nodes, message);
}

struct Drawing {
    Graph graph;
    Json facts;
    std::vector<Graph> frames = {};  // of an animation
};

Drawing drawing_of(const DerivationTree& tree, std::uint64_t generation) {
    return {tree_graph(tree),
            {{"generation", generation},
             {"nodes", tree.nodes.size()},
             {"edges", edge_count(tree)},
             {"depth", depth(tree)},
             {"contexts", context_count(tree)},
             {"tables", tree.tables}}};
}

/// The tree of the generation that `derive` derives with the same options.
Drawing module_tree(const Options& options, const LSystem& system, const TreeShape& shape,
                    const Budget& budget) {
    constexpr std::uint64_t most_modules = 200'000;  // of all words, those below a cut too
    const Class kind = class_of(system);
    if (kind.shape)
        throw Error("it has shape rules, which divide boxes; tree draws derivations of words");
    if (kind.open)
        throw Error(
            "it has communication modules, which an environment fills between two steps; "
            "tree draws derivations by rules alone");
    const std::uint64_t n = *options.generation;
    const bool seeded = options.seed.has_value();
    const std::vector<std::size_t> tables = derivation_tables(system, options.tables, seeded);
    check_long_enough(tables, n);
    const Rewriting rewriting(system, derivation_choices(system, options.seed, seeded), budget);
    const ModuleTrace trace =
        traced(rewriting, n, tables, std::max(most_modules, options.most_nodes), budget);
    const std::uint64_t last = trace.goes_on ? trace.lengths.size() : n;
    check_size(options, last, shape,
               [&](const TreeShape& asked) { return tree_size(rewriting, trace, asked, budget); });
    Drawing drawing = drawing_of(derivation_tree(rewriting, trace, shape, budget), n);
    if (seeded || kind.stochastic) drawing.facts.set("seed", options.seed.value_or(1));
    return drawing;
}

Drawing generation_tree(const Options& options, const TreeShape& shape, const Budget& budget) {
    const LSystem written = open_system(options.file, budget, options.let);
    const View<D0L> system = as_d0l(written);
    const bool picked = options.seed || !options.tables.empty();
    if (!system && !picked && as_ol(written))
        throw Error(system.reason() +
                    "; --word draws the derivation of one word, --seed one picked at random");
    if (!system || picked) return module_tree(options, written, shape, budget);
    const std::uint64_t n = *options.generation;
    check_size(options, n, shape,
               [&](const TreeShape& asked) { return tree_size(*system, n, asked, budget); });
    return drawing_of(derivation_tree(*system, n, shape, budget), n);
}

/// The tree of a derivation of the word of --word by rules with contexts.
Drawing member_tree(const Options& options, const LSystem& written, const IL& system,
                    const TreeShape& shape, const Budget& budget) {
    Alphabet alphabet = *system.alphabet;
    const ModuleWord read = read_word(options.word, alphabet);
    if (!read.arguments.empty())
        throw Error("--word: WORD has parameters, and the words of such a system have none");
    const IL rules = over(system, std::make_shared<const Alphabet>(alphabet));
    const auto steps = shortest_derivation(rules, read.letters, budget);
    if (!steps)
        throw Error("--word: " + spell(alphabet, read.letters) +
                    " is not in the language, `algae member` says why");
    const Rewriting rewriting(written, {.evenly = true}, budget);
    const ModuleTrace trace = traced(rewriting, rules, *steps, budget);
    const std::uint64_t n = trace.lengths.size();
    check_size(options, n, shape,
               [&](const TreeShape& asked) { return tree_size(rewriting, trace, asked, budget); });
    return drawing_of(derivation_tree(rewriting, trace, shape, budget), n);
}

Drawing member_tree(const Options& options, const TreeShape& shape, const Budget& budget) {
    const LSystem written = open_system(options.file, budget, options.let);
    const View<ET0L> system = as_et0l(written);
    if (const View<IL> interactive = as_il(written); !system && interactive)
        return member_tree(options, written, *interactive, shape, budget);
    if (!system) throw Error("--word: " + system.reason() + "; -n draws the tree of a generation");
    Alphabet alphabet = *system->alphabet;
    const ModuleWord read = read_word(options.word, alphabet);
    if (!read.arguments.empty())
        throw Error("--word: WORD has parameters, and the words of such a system have none");
    const Membership found = membership(*system, read.letters, budget);
    if (!found.member)
        throw Error("--word: " + spell(alphabet, read.letters) +
                    " is not in the language, `algae member` says why");
    const Derivation steps = derivation(*system, read.letters, found, budget);
    check_size(options, found.step, shape,
               [&](const TreeShape& asked) { return tree_size(*system, steps, asked, budget); });
    return drawing_of(derivation_tree(*system, steps, shape, budget), found.step);
}

Drawing growth_digraph(const Options& options, const Budget& budget) {
    const LSystem written = open_system(options.file, budget, options.let);
    const View<D0L> system = as_d0l(written);
    const std::uint64_t most = options.most_nodes;
    if (system->letters.size() > most)
        throw BoundReached(Bound::nodes, "the digraph has " +
                                             std::to_string(system->letters.size()) +
                                             " letters, more than the " + std::to_string(most) +
                                             " of --max-nodes");
    Drawing drawing{growth_graph(*system, budget), {}};
    // Without the arrows to the letters of the axiom.
    const auto from_letters = std::ranges::count_if(
        drawing.graph.edges,
        [&](const Graph::Edge& edge) { return edge.from < system->letters.size(); });
    drawing.facts = {{"nodes", system->letters.size()}, {"edges", from_letters}};
    return drawing;
}

Drawing rauzy_graphs(const Options& options, bool moves, const Budget& budget) {
    const Model model = open_model(options.file, budget, options.let);
    const View<D0L> system = as_d0l(model);
    std::optional<LetterCoding> coding;
    if (!model.coding.empty()) coding.emplace(model.alphabet, model.coding);
    const Alphabet& alphabet = coding ? coding->alphabet : model.alphabet;
    std::vector<std::vector<Word>> all;
    std::uint64_t edges = 0;
    for (std::uint64_t n = options.rauzy->first; n <= options.rauzy->last; ++n) {
        const std::size_t length = n + 1;
        std::vector<Word> words = factors(*system, length, budget).words;
        std::erase_if(words, [&](const Word& word) { return word.size() < length; });
        if (coding)
            for (Word& word : words) word = coding->morphism(word);
        std::ranges::sort(words);
        words.erase(std::unique(words.begin(), words.end()), words.end());
        edges += words.size();
        if (!options.reduced && edges > options.most_nodes)
            throw BoundReached(Bound::nodes,
                               "the graph has " + std::to_string(edges) +
                                   " edges up to factors of " + std::to_string(length) +
                                   " letters, more than the " + std::to_string(options.most_nodes) +
                                   " of --max-nodes; --reduced draws special ones");
        all.push_back(std::move(words));
    }
    Drawing drawing{rauzy_graph(all, alphabet, options.reduced), {}};
    if (drawing.graph.nodes.empty())
        throw Error("--rauzy: expected a number of letters below that of the longest word");
    drawing.facts = {{"nodes", drawing.graph.nodes.size()}, {"edges", drawing.graph.edges.size()}};
    if (!moves) return drawing;
    for (const std::vector<Word>& words : all) {
        if (words.empty()) continue;
        drawing.frames.push_back(rauzy_graph({words}, alphabet, options.reduced));
        drawing.frames.back().caption = "n = " + std::to_string(words.front().size() - 1);
    }
    return drawing;
}

Drawing families() {
    Drawing drawing{families_graph(), {}};
    drawing.facts = {{"nodes", drawing.graph.nodes.size()}, {"edges", family_inclusions().size()}};
    return drawing;
}

int tree(const Options& options) {
    check_usage(options);
    const TreeFormat format = format_of(options);
    const Budget budget = options.bounds.budget();
    const TreeShape shape{options.depth, options.shared};
    GraphOptions picture;
    picture.width = options.width;
    picture.height = options.height;
    if (!options.background.empty()) picture.background = options.background;

    Drawing drawing = options.families ? families()
                      : options.graph  ? growth_digraph(options, budget)
                      : options.rauzy  ? rauzy_graphs(options, format.animation.has_value(), budget)
                      : options.generation ? generation_tree(options, shape, budget)
                                           : member_tree(options, shape, budget);
    drawing.facts.set("output", options.output);
    const auto tell_size = [&](const GraphDrawn& drawn) {
        drawing.facts.set("width", drawn.width);
        drawing.facts.set("height", drawn.height);
    };
    if (format.animation) {
        tell_size(draw_animation(drawing.frames, target_of(options.output), *format.animation,
                                 picture, AnimationTiming(), budget));
    } else if (!format.picture) {
        if (format.latex)
            refuse_given({{"--width", options.width.has_value()},
                          {"--height", options.height.has_value()},
                          {"--background", !options.background.empty()}},
                         ": a figure for LaTeX has the size that its text needs");
        const std::string text =
            format.latex ? latex_text(drawing.graph, budget) : dot_text(drawing.graph);
        if (options.output == "-")
            print(text);
        else
            write_file(options.output, text);
    } else {
        tell_size(
            draw_graph(drawing.graph, target_of(options.output), *format.picture, picture, budget));
    }
    if (options.json) print(drawing.facts.text());
    return success;
}

}  // namespace

void add_tree(Verbs& verbs) {
    auto [verb, options] = verbs.add(
        "tree",
        "The derivation tree of a generation or of a word, the digraph of growth, Rauzy graphs",
        {"algae tree anabaena -n 4 -o anabaena.pdf",
         "algae tree all-powers --word aaa -o derivation.svg",
         "algae tree my.lsys -n 4 --seed 7 -o picked.svg",
         "algae tree fibonacci --graph -o growth.png",
         "algae tree thue-morse --rauzy 4 -o rauzy.svg", "algae tree --families -o families.pdf"},
        tree);
    verb.option("FILE", options.file, file_type, file_help);
    add_let_option(verb, options.let);
    verb.option("-n", options.generation, natural, "N",
                "the tree of this generation, with contexts as thin arcs");
    verb.option("--seed", options.seed, natural, "S",
                "with -n: what is picked at random, as in derive (1 for systems with "
                "probabilities)");
    verb.option("--tables", options.tables, "SEQUENCE",
                "with -n: the table of each step: light,dark or, of one character each, abab or "
                "1212");
    verb.option("--word", options.word, "WORD",
                "the tree of a derivation of this word, in as few steps as possible");
    verb.flag(
        "--graph", options.graph,
        "instead: which letters occur in the successors of which, how often, and what becomes "
        "of them");
    verb.option("--rauzy", options.rauzy, range, "N|A..B",
                "instead: the Rauzy graph of factors of N letters, or one for each number of "
                "letters");
    verb.flag("--reduced", options.reduced,
              "with --rauzy: only special factors are nodes, and edges are the ways between them");
    verb.flag("--families", options.families, "instead: the diagram of families of languages");
    verb.output("-o,--output", options.output, "FILE",
                "the picture: .svg, .pdf, .png, .ps or .eps; .tex for LaTeX, trees by its package "
                "forest; .dot or .gv for Graphviz; .gif, .webp, .mp4 or .webm for Rauzy graphs, "
                "one after "
                "the other; - for standard output")
        .required = true;
    verb.option("--format", options.format, "svg|pdf|png|ps|eps|tex|dot|gv|gif|webp|mp4|webm",
                "the format, where the name does not say it");
    verb.flag("--dag", options.shared, "equal subtrees of one generation are drawn once");
    verb.option("--depth", options.depth, natural, "D",
                "cut the tree after so many generations; triangles say how many letters are left "
                "out");
    verb.option("--max-nodes", options.most_nodes, natural, "N",
                "nodes that may be drawn (default 2000)");
    verb.option("--width", options.width, positive, "W", "of the picture, in points (png: pixels)");
    verb.option("--height", options.height, positive, "H",
                "of the picture, in points (png: pixels)");
    verb.option("--background", options.background, "COLOUR",
                "a colour, or transparent (default: white in png, none elsewhere)");
    verb.json_flag(options.json,
                   "print nodes, edges, depth, contexts and tables as one JSON object");
    verb.bounded_by(options.bounds);
}

}  // namespace algae::command
