#include <algorithm>
#include <cctype>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/input.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "language/derivation_tree.hpp"
#include "language/tables_membership.hpp"
#include "notation/read.hpp"
#include "render/graph_families.hpp"
#include "render/graph_growth.hpp"
#include "render/output.hpp"
#include "render/tree.hpp"

namespace algae::cli {

namespace {

struct Options {
    std::string file, generation, word, depth, output, format, width, height, background, most_nodes = "2000";
    bool shared = false, graph = false, families = false, json = false;
    Bounds bounds;
};

using SizeOf = std::function<Integer(const TreeShape&)>;

/// The format that the name of the file or --format says; nothing for Graphviz's own language.
std::optional<PictureFormat> format_of(const Options& options) {
    if (options.output == "-" && options.format.empty())
        throw Error("-o -: say which format with --format: svg, pdf, png, ps, eps or dot");
    const std::string name = options.format.empty() ? options.output : "tree." + options.format;
    std::string end = name.substr(std::min(name.size(), name.find_last_of("./") + 1));
    for (char& letter : end) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    if (end == "dot" || end == "gv") return std::nullopt;
    try {
        return picture_format(name);
    } catch (const Error&) {
        throw Error("expected a file ending in .svg, .pdf, .png, .ps, .eps, .dot or .gv, found \"" + name + '"');
    }
}

void check_usage(const Options& options) {
    const bool tree = !options.generation.empty() || !options.word.empty();
    const int asked = (options.generation.empty() ? 0 : 1) + (options.word.empty() ? 0 : 1) + options.graph + options.families;
    if (asked == 0) throw Error("say which tree: -n N for a generation, --word WORD for a member; or --graph or --families");
    if (asked > 1) throw Error("-n, --word, --graph and --families exclude each other");
    if (options.families != options.file.empty())
        throw Error(options.families ? "--families draws families of languages and takes no FILE, found \"" + options.file + '"'
                                     : std::string("FILE is missing: ") + file_help);
    if (!tree && (options.shared || !options.depth.empty())) throw Error("--dag and --depth are for trees: -n or --word");
}

/// Throws BoundReached with the size, and with shapes that are smaller, if the tree is too large to show.
void check_size(const Options& options, std::uint64_t n, const TreeShape& shape,
                const SizeOf& size) {
    const std::uint64_t most = natural("--max-nodes", options.most_nodes);
    std::string found;
    try {
        const Integer nodes = size(shape);
        if (nodes <= Integer(most)) return;
        found = readable(nodes) + " nodes";
    } catch (const BoundReached& bound) {
        if (bound.bound() == Bound::time) throw;
        found = "more nodes than can be counted";
    }
    std::string message = std::string("the tree has ") + found + ", more than the " + std::to_string(most) + " of --max-nodes";
    const auto suggest = [&](const std::string& option, const TreeShape& smaller) {
        message += "; " + option + " has " + readable(size(smaller));
    };
    const std::uint64_t last = std::min(n, shape.depth.value_or(n));
    if (const auto depth = depth_within(last, most, size, shape.shared))
        suggest("--depth " + std::to_string(*depth), {*depth, shape.shared});
    if (!shape.shared) suggest("--dag", {shape.depth, true});
    throw BoundReached(Bound::nodes, message);
}

struct Drawing {
    Graph graph;
    nlohmann::ordered_json facts;
};

Drawing drawing_of(const DerivationTree& tree, std::uint64_t generation) {
    return {tree_graph(tree),
            {{"generation", generation}, {"nodes", tree.nodes.size()}, {"edges", edge_count(tree)}, {"depth", depth(tree)}}};
}

Drawing generation_tree(const Options& options, const TreeShape& shape, const Budget& budget) {
    const LSystem written = open_system(options.file, budget);
    const View<D0L> system = as_d0l(written);
    if (!system) throw Error(system.reason() + "; --word draws the derivation of one word");
    const std::uint64_t n = natural("-n", options.generation);
    check_size(options, n, shape,
               [&](const TreeShape& asked) { return tree_size(*system, n, asked, budget); });
    return drawing_of(derivation_tree(*system, n, shape, budget), n);
}

Drawing member_tree(const Options& options, const TreeShape& shape, const Budget& budget) {
    const LSystem written = open_system(options.file, budget);
    const View<ET0L> system = as_et0l(written);
    Alphabet alphabet = *system->alphabet;
    const ModuleWord read = read_word(options.word, alphabet);
    if (!read.arguments.empty()) throw Error("--word: WORD has parameters, and the words of such a system have none");
    const Membership found = membership(*system, read.letters, budget);
    if (!found.member)
        throw Error("--word: " + spell(alphabet, read.letters) + " is not in the language, `algae member` says why");
    const Derivation steps = derivation(*system, read.letters, found, budget);
    check_size(options, found.step, shape,
               [&](const TreeShape& asked) { return tree_size(*system, steps, asked, budget); });
    return drawing_of(derivation_tree(*system, steps, shape, budget), found.step);
}

Drawing growth_digraph(const Options& options, const Budget& budget) {
    const LSystem written = open_system(options.file, budget);
    const View<D0L> system = as_d0l(written);
    const std::uint64_t most = natural("--max-nodes", options.most_nodes);
    if (system->letters.size() > most)
        throw BoundReached(Bound::nodes, "the digraph has " +
                                             std::to_string(system->letters.size()) +
                                             " letters, more than the " + std::to_string(most) +
                                             " of --max-nodes");
    Drawing drawing{growth_graph(*system, budget), {}};
    const auto from_letters = std::count_if(drawing.graph.edges.begin(), drawing.graph.edges.end(), [&](const Graph::Edge& edge) {
        return edge.from < system->letters.size();  // and not one of the arrows to the letters of the axiom
    });
    drawing.facts = {{"nodes", system->letters.size()}, {"edges", from_letters}};
    return drawing;
}

Drawing families() {
    Drawing drawing{families_graph(), {}};
    drawing.facts = {{"nodes", drawing.graph.nodes.size()}, {"edges", family_inclusions().size()}};
    return drawing;
}

void write_dot(const Graph& graph, const std::string& path) {
    const std::string text = dot_text(graph);
    if (path == "-") return print(text);
    FileOutput file(path);
    file.write(text.data(), text.size());
    file.commit();
}

int tree(const Options& options) {
    check_usage(options);
    const std::optional<PictureFormat> format = format_of(options);
    const Budget budget = options.bounds.budget();
    TreeShape shape{std::nullopt, options.shared};
    if (!options.depth.empty()) shape.depth = natural("--depth", options.depth);
    GraphOptions picture;
    if (!options.width.empty()) picture.width = positive("--width", options.width);
    if (!options.height.empty()) picture.height = positive("--height", options.height);
    if (!options.background.empty()) picture.background = options.background;

    Drawing drawing = options.families              ? families()
                      : options.graph               ? growth_digraph(options, budget)
                      : !options.generation.empty() ? generation_tree(options, shape, budget)
                                                    : member_tree(options, shape, budget);
    drawing.facts["output"] = options.output;
    if (!format) {
        write_dot(drawing.graph, options.output);
    } else {
        const GraphDrawn drawn = options.output == "-" ? draw_graph(drawing.graph, std::cout, *format, picture, budget)
                                                       : draw_graph(drawing.graph, options.output, *format, picture, budget);
        drawing.facts["width"] = drawn.width;
        drawing.facts["height"] = drawn.height;
    }
    if (options.json) print(drawing.facts.dump(2) + "\n");
    return success;
}

}  // namespace

void add_tree(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = add_verb(verbs, "tree", "The derivation tree of a generation or of a word, the digraph of growth",
                              "  algae tree anabaena -n 4 -o anabaena.pdf\n"
                              "  algae tree all-powers --word aaa -o derivation.svg\n"
                              "  algae tree fibonacci --graph -o growth.png\n"
                              "  algae tree --families -o families.pdf",
                              options, tree);
    verb.add_option("FILE", options->file, file_help)->type_name(file_type);
    verb.add_option("-n", options->generation, "the tree of this generation of a D0L system")->type_name("N");
    verb.add_option("--word", options->word, "the tree of a derivation of this word, in as few steps as possible")->type_name("WORD");
    verb.add_flag("--graph", options->graph, "instead: which letters occur in the successors of which, how often, and what becomes of them");
    verb.add_flag("--families", options->families, "instead: the diagram of families of languages");
    verb.add_option("-o,--output", options->output, "the picture: .svg, .pdf, .png, .ps or .eps; .dot or .gv for Graphviz; - for standard output")->type_name("FILE")->required();
    verb.add_option("--format", options->format, "the format, where the name does not say it")->type_name("svg|pdf|png|ps|eps|dot|gv");
    verb.add_flag("--dag", options->shared, "equal subtrees of one generation are drawn once");
    verb.add_option("--depth", options->depth, "cut the tree after so many generations; triangles say how many letters are left out")->type_name("D");
    verb.add_option("--max-nodes", options->most_nodes, "nodes that may be drawn (default 2000)")->type_name("N");
    verb.add_option("--width", options->width, "of the picture, in points (png: pixels)")->type_name("W");
    verb.add_option("--height", options->height, "of the picture, in points (png: pixels)")->type_name("H");
    verb.add_option("--background", options->background, "a colour, or transparent (default: white in png, none elsewhere)")->type_name("COLOUR");
    verb.add_flag("--json", options->json, "print nodes, edges and depth as one JSON object");
    options->bounds.add_to(verb);
}

}  // namespace algae::cli
