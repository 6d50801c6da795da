#include <graphviz/gvc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "exact/exact.hpp"
#include "render/detail/graph.hpp"
#include "watch/watch.hpp"

// Where the nodes and edges of a graph go: by Graphviz's `dot` (Gansner, Koutsofios, North and Vo 1993), and for trees by a
// layout of our own, because `dot` puts a letter with two children over one of them.
//
// Graphviz is a C library with state of the whole process. So there is one context for the process (every new one takes
// memory for good), one lock around all of its work, and its errors are noted instead of printed while the lock is held.
// It sorts by the identifiers of names, which by default are addresses; Names gives numbers in order of first use
// instead, so that equal graphs are equal texts and equal pictures. Its own strings must be made by `agstrdup`: it looks before a string
// for whether that is HTML. Graphviz takes texts as char* and does not write to them. Its y axis points up, that of a page down.
//
// The layout of trees goes over the rows twice, in linear time. From the last row up, each node learns how wide the tree below it
// is and where it stands in it: over the middle between its first and its last child, as far as its own width allows. From the first
// row down, the trees are put side by side. The height of a row then makes the flattest edge steep enough, between two bounds.
// Thin edges, from a letter to another one of its row, have no part in either layout: they are arcs that hang below the row.

namespace algae {

namespace {

constexpr double inch = 72;         // points
constexpr double line_height = 20;  // of a node with one line of text
constexpr double bare_height = 18;
constexpr double beside_label = 9;  // left and right of the label of a node, together
constexpr double along = 0.6;  // of a straight edge, to its label: those of one node stand apart

// Graphviz takes texts as char*, and does not write to them.
char* text(const std::string& value) { return const_cast<char*>(value.c_str()); }

std::string inches(double points) { return rounded_decimal(points / inch, 6); }

std::string code(const Colour& colour) {
    char digits[8];
    const auto part = [](double share) { return static_cast<unsigned>(share * 255 + 0.5); };
    std::snprintf(digits, sizeof digits, "#%02x%02x%02x", part(colour.red), part(colour.green),
                  part(colour.blue));
    return digits;
}

/// A label as Graphviz reads it: a backslash would begin an escape.
std::string escaped(const std::string& label) {
    std::string out;
    for (const char c : label) {
        if (c == '\\') out += '\\';
        out += c;
    }
    return out;
}

std::string full_label(const Graph::Node& node) {
    return node.subscript.empty() ? node.label : node.label + "_" + node.subscript;
}

/// Numbers for Graphviz's names, in order of first use: its own are addresses, by which it sorts,
/// so that equal graphs would not be equal texts.
class Names {
public:
    static void* open(Agraph_t* graph, Agdisc_t*) { return new Names(graph); }
    static void close(void* names) { delete static_cast<Names*>(names); }
    static long map(void* names, int kind, char* name, IDTYPE* id, int create) {
        return static_cast<Names*>(names)->number(kind, name, *id, create != 0);
    }
    static long allocate(void*, int, IDTYPE) { return 0; }
    static void free(void*, int, IDTYPE) {}
    static char* print(void* names, int kind, IDTYPE id) {
        auto& known = static_cast<Names*>(names)->names_;
        const auto found = known.find({family(kind), id});
        return found == known.end() ? nullptr : found->second;
    }
    static void note(void*, int, void*) {}

private:
    explicit Names(Agraph_t* graph) : graph_(graph) {}

    // The two kinds of edges are one.
    static int family(int kind) { return kind == AGINEDGE ? AGOUTEDGE : kind; }

    long number(int kind, const char* name, IDTYPE& id, bool create) {
        if (!name) {  // unnamed objects are odd, as Graphviz has it
            id = 2 * ++unnamed_ + 1;
            return 1;
        }
        const auto found = numbers_.find({family(kind), name});
        if (found != numbers_.end()) {
            id = found->second;
            return 1;
        }
        if (!create) return 0;
        id = 2 * (numbers_.size() + 1);
        numbers_.emplace(std::pair(family(kind), std::string(name)), id);
        names_.emplace(std::pair(family(kind), id), agstrdup(graph_, text(name)));
        return 1;
    }

    Agraph_t* graph_;
    std::map<std::pair<int, std::string>, IDTYPE> numbers_;
    // Graphviz's own strings, which end with the graph: it looks before a string whether it is HTML.
    std::map<std::pair<int, IDTYPE>, char*> names_;
    IDTYPE unnamed_ = 0;
};

Agiddisc_t numbered_names{Names::open,  Names::map,   Names::allocate, Names::free,
                          Names::print, Names::close, Names::note};

/// The graph in Graphviz's hands.
class Handed {
public:
    /// Thin edges are written, and not placed.
    explicit Handed(const Graph& graph, Agiodisc_t* writing = nullptr)
        : graph_(graph),
          with_thin_(writing),
          discipline_{&AgMemDisc, &numbered_names, writing ? writing : &AgIoDisc},
          handed_(agopen(text("algae"), Agdirected, &discipline_)) {
        if (!handed_) throw std::bad_alloc();
        add_defaults();
        add_nodes();
        add_rows();
        add_groups();
        add_edges();
    }
    Handed(const Handed&) = delete;
    Handed& operator=(const Handed&) = delete;
    ~Handed() { agclose(handed_); }

    Agraph_t* get() const { return handed_; }
    Agnode_t* node(std::size_t i) const { return nodes_[i]; }
    Agedge_t* edge(std::size_t i) const { return edges_[i]; }
    Agraph_t* group(std::size_t i) const { return groups_[i]; }

private:
    static void set(void* object, const std::string& name, const std::string& value) {
        agsafeset(object, text(name), text(value), text(""));
    }
    void by_default(int kind, const std::string& name, const std::string& value) {
        agattr(handed_, kind, text(name), text(value));
    }

    void add_defaults() {
        by_default(AGRAPH, "rankdir", graph_.upward ? "BT" : "TB");
        by_default(AGRAPH, "splines", graph_.straight ? "line" : "true");
        by_default(AGRAPH, "nodesep", graph_.trees ? "0.11" : "0.35");
        by_default(AGRAPH, "ranksep", graph_.trees ? "0.28" : "0.45");
        by_default(AGRAPH, "fontname", "DejaVu Sans");
        by_default(AGRAPH, "fontsize", rounded_decimal(graph_small_letters, 6));
        by_default(AGNODE, "fontname", "DejaVu Sans");
        by_default(AGNODE, "fontsize", rounded_decimal(graph_letters, 6));
        by_default(AGNODE, "shape", "box");
        by_default(AGNODE, "style", "rounded,filled");
        by_default(AGNODE, "fillcolor", "white");
        by_default(AGNODE, "fixedsize", "true");
        by_default(AGEDGE, "fontname", "DejaVu Sans");
        by_default(AGEDGE, "fontsize", rounded_decimal(graph_small_letters, 6));
        by_default(AGEDGE, "arrowsize", "0.6");
    }

    void add_nodes() {
        for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
            const Graph::Node& node = graph_.nodes[i];
            Agnode_t* added = agnode(handed_, text("n" + std::to_string(i)), 1);
            nodes_.push_back(added);
            const Point size = node_size(node);
            set(added, "label", escaped(full_label(node)));
            set(added, "width", inches(size.x));
            set(added, "height", inches(size.y));
            using enum Graph::Node::Shape;
            if (node.shape == round && size.x <= size.y) set(added, "shape", "circle");
            if (node.shape == bare) set(added, "shape", "none");
            if (node.shape == triangle) set(added, "shape", "triangle");
            if (node.shape == start) set(added, "shape", "none");
            if (node.fill) set(added, "fillcolor", code(*node.fill));
            if (graph_.ordered) set(added, "group", escaped(full_label(node)));
        }
    }

    void add_rows() {
        for (std::size_t i = 0; i < graph_.rows.size(); ++i) {
            const std::vector<std::size_t>& row = graph_.rows[i];
            Agraph_t* added = agsubg(handed_, text("row" + std::to_string(i)), 1);
            set(added, "rank", "same");
            if (i > 0 && i <= graph_.step_labels.size())
                set(added, "comment", escaped("table " + graph_.step_labels[i - 1]));
            for (std::size_t k = 0; k < row.size(); ++k) {
                agsubnode(added, nodes_[row[k]], 1);
                if (k == 0 || !graph_.ordered) continue;
                const std::string name = "order" + std::to_string(i) + "_" + std::to_string(k);
                Agedge_t* order = agedge(added, nodes_[row[k - 1]], nodes_[row[k]], text(name), 1);
                set(order, "style", "invis");
            }
        }
    }

    void add_groups() {
        for (std::size_t i = 0; i < graph_.groups.size(); ++i) {
            const Graph::Group& group = graph_.groups[i];
            Agraph_t* added = agsubg(handed_, text("cluster" + std::to_string(i)), 1);
            groups_.push_back(added);
            set(added, "style", "rounded,filled");
            set(added, "fillcolor", code(group.fill));
            set(added, "label", escaped(group.label));
            set(added, "margin", "10");
            set(added, "labelloc", "b");  // arrows come from above
            set(added, "labeljust", "l");
            for (const std::size_t node : group.nodes) agsubnode(added, nodes_[node], 1);
        }
    }

    void add_edges() {
        for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
            const Graph::Edge& edge = graph_.edges[i];
            if (edge.thin && !with_thin_) {
                edges_.push_back(nullptr);
                continue;
            }
            Agedge_t* added = agedge(handed_, nodes_[edge.from], nodes_[edge.to],
                                     text("e" + std::to_string(i)), 1);
            edges_.push_back(added);
            // An outer label takes no room of its own.
            if (!edge.label.empty())
                set(added, graph_.straight ? "xlabel" : "label", escaped(edge.label));
            if (!edge.arrow) set(added, "dir", "none");
            if (edge.dashed) set(added, "style", "dashed");
            if (!edge.places) set(added, "constraint", "false");
            if (edge.thin) {
                set(added, "color", "gray60");
                set(added, "penwidth", "0.5");
                set(added, "arrowsize", "0.4");
            }
        }
    }

    const Graph& graph_;
    bool with_thin_;
    Agdisc_t discipline_;
    Agraph_t* handed_;
    std::vector<Agnode_t*> nodes_;
    std::vector<Agedge_t*> edges_;
    std::vector<Agraph_t*> groups_;
};

std::mutex one_at_a_time;     // Graphviz's state is that of the process
std::string what_went_wrong;  // guarded by it

int note_error(char* message) {
    what_went_wrong += message;
    return 0;
}

/// While it lives, Graphviz's errors are noted instead of printed.
class Listening {
public:
    Listening() : level_(agseterr(AGERR)), before_(agseterrf(note_error)) {
        what_went_wrong.clear();
    }
    Listening(const Listening&) = delete;
    Listening& operator=(const Listening&) = delete;
    ~Listening() {
        agseterrf(before_);
        agseterr(level_);
    }
    /// What Graphviz said, as one line.
    std::string said() const {
        std::string line = what_went_wrong;
        if (line.starts_with("Error: ")) line.erase(0, 7);
        std::ranges::replace(line, '\n', ' ');
        while (line.ends_with(' ')) line.pop_back();
        return line;
    }

private:
    agerrlevel_t level_;
    agusererrf before_;
};

/// Turns Graphviz's coordinates, whose y grows upward, into those of a page.
class Page {
public:
    explicit Page(const boxf& whole) : left_(whole.LL.x), top_(whole.UR.y) {}
    Point operator()(const pointf& at) const { return {at.x - left_, top_ - at.y}; }

private:
    double left_, top_;
};

GraphLayout::Line line_of(Agedge_t* edge, const Page& page) {
    GraphLayout::Line line;
    if (const splines* curves = ED_spl(edge)) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(curves->size); ++i) {
            const bezier& curve = curves->list[i];
            for (std::size_t k = i == 0 ? 0 : 1; k < static_cast<std::size_t>(curve.size); ++k)
                line.points.push_back(page(curve.list[k]));
            if (curve.eflag) line.tip = page(curve.ep);
        }
    }
    if (ED_label(edge))
        line.label = page(ED_label(edge)->pos);
    else if (!line.points.empty())
        line.label = {along * line.points.back().x + (1 - along) * line.points.front().x,
                      along * line.points.back().y + (1 - along) * line.points.front().y};
    return line;
}

/// The arc of a thin edge, from the lower corner of a node that looks at the other one to the lower corner of that.
GraphLayout::Line arc_between(const Graph& graph, const Graph::Edge& edge,
                              const GraphLayout& layout) {
    constexpr double least_depth = 7, largest_depth = 15, steepness = 0.3, head = 4;
    constexpr double corner =
        0.70710678118654752;  // of a radius: where a circle is crossed at 45 degrees
    const Point &from = layout.nodes[edge.from], &to = layout.nodes[edge.to];
    const double way = to.x < from.x ? -1 : 1;
    const auto lower_corner = [&](std::size_t node, double side) {
        const Point size = node_size(graph.nodes[node]);
        const double radius = size.y / 2, arm = std::max(0.0, size.x / 2 - radius);
        return Point{layout.nodes[node].x + side * (arm + corner * radius),
                     layout.nodes[node].y + corner * radius};
    };
    const Point start = lower_corner(edge.from, way), end = lower_corner(edge.to, -way);
    const double across = end.x - start.x;
    // Two letters may see each other: one arc hangs lower.
    const double depth =
        std::clamp(std::fabs(across) * steepness, least_depth, largest_depth) + (way < 0 ? 4 : 0);
    const Point first{start.x + across * 0.2, start.y + depth},
        second{end.x - across * 0.2, end.y + depth};
    const double x = second.x - end.x, y = second.y - end.y, length = std::hypot(x, y);
    const Point last{end.x + x / length * head, end.y + y / length * head};
    return {{start, first, second, last}, end, {(start.x + end.x) / 2, start.y + depth}};
}

int put_text(void* into, const char* piece) {
    static_cast<std::string*>(into)->append(piece);
    return 0;
}

int put_nothing(void*) { return 0; }

}  // namespace

Point node_size(const Graph::Node& node) {
    const double width = text_width(node.label, node.subscript, {graph_letters, node.bold});
    using enum Graph::Node::Shape;
    switch (node.shape) {
        case round:
            return {std::max(line_height, width + beside_label), line_height};
        case box:
            return {std::max(40.0, width + 2 * beside_label), 1.3 * line_height};
        case bare:
            return {std::max(bare_height, width + 4), bare_height};
        case triangle: {
            const double small = text_width(node.label, "", {graph_small_letters, false});
            return {std::max(line_height, small + 16), 1.4 * line_height};
        }
        case start:
            return {2, 2};
    }
    return {};
}

GraphLayout graph_layout(const Graph& graph, const Budget& budget) {
    budget.check();
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    const Listening listening;
    // One for the whole process: every new one takes memory for good.
    static GVC_t* const context = gvContext();
    if (!context) throw Error("Graphviz cannot begin: " + listening.said());
    const Handed handed(graph);
    budget.check();
    WorkCount placing("nodes being placed by Graphviz");
    placing.at(graph.nodes.size());
    if (gvLayout(context, handed.get(), "dot") != 0)
        throw Error("Graphviz cannot place the graph: " + listening.said());
    const std::unique_ptr<Agraph_t, void (*)(Agraph_t*)> placed(
        handed.get(), [](Agraph_t* done) { gvFreeLayout(GD_gvc(done), done); });

    GraphLayout layout;
    const boxf whole = GD_bb(handed.get());
    const Page page(whole);
    layout.width = whole.UR.x - whole.LL.x;
    layout.height = whole.UR.y - whole.LL.y;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i)
        layout.nodes.push_back(page(ND_coord(handed.node(i))));
    for (std::size_t i = 0; i < graph.edges.size(); ++i)
        layout.edges.push_back(graph.edges[i].thin ? arc_between(graph, graph.edges[i], layout)
                                                   : line_of(handed.edge(i), page));
    for (std::size_t i = 0; i < graph.groups.size(); ++i) {
        const boxf frame = GD_bb(handed.group(i));
        const Point low = page(frame.LL), high = page(frame.UR);
        GraphLayout::Frame found{low.x, high.y, high.x, low.y, {}};
        if (GD_label(handed.group(i))) found.label = page(GD_label(handed.group(i))->pos);
        layout.groups.push_back(found);
    }
    budget.check();
    return layout;
}

std::string dot_text(const Graph& graph) {
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    const Listening listening;
    Agiodisc_t writing = AgIoDisc;
    writing.putstr = put_text;
    writing.flush = put_nothing;
    const Handed handed(graph, &writing);
    std::string written;
    if (agwrite(handed.get(), &written) != 0 || written.empty())
        throw Error("Graphviz cannot write the graph: " + listening.said());
    return written;
}

namespace {

constexpr double plain_gap = 8, gap_with_arcs = 15;  // between two leaves
constexpr double least_row = 40, largest_row = 80, largest_row_of_modules = 110;
constexpr double least_slope = 0.2;  // of the flattest edge, as long as rows do not get too high
constexpr double slope_of_modules = 0.32;  // where labels are wide, so that edges do not cross them
constexpr double wide = 40;

/// Where an edge leaves a node of this size: on the circle or pill around it.
Point edge_end(const Point& from, const Point& to, const Graph::Node& node) {
    const Point size = node_size(node);
    const double radius = size.y / 2, arm = std::max(0.0, size.x / 2 - radius);
    const double x = to.x - from.x, y = to.y - from.y, length = std::hypot(x, y);
    if (length == 0) return from;
    if (node.shape == Graph::Node::Shape::triangle) return {from.x, from.y - size.y / 2};
    // The edge leads from row to row, so it is steep enough to leave a pill through its straight
    // side, or through the arc at the end of it.
    const double across = std::clamp(x / std::fabs(y) * radius, -arm, arm);
    const double rest = std::hypot(x - across, y);
    return {from.x + across + (x - across) / rest * radius, from.y + y / rest * radius};
}

}  // namespace

GraphLayout tree_layout(const Graph& graph, const Budget& budget) {
    const std::size_t count = graph.nodes.size();
    std::vector<std::vector<std::size_t>> children(count);
    std::vector<char> is_child(count, 0);
    double gap = plain_gap;
    for (const Graph::Edge& edge : graph.edges) {
        if (edge.thin) {
            gap = gap_with_arcs;
            continue;
        }
        children[edge.from].push_back(edge.to);
        is_child[edge.to] = 1;
    }

    // From the last row up: how wide the tree below each node is, and where the node stands in it.
    std::vector<double> widths(count), places(count), shifts(count);
    for (std::size_t row = graph.rows.size(); row-- > 0;) {
        budget.check();
        for (const std::size_t i : graph.rows[row]) {
            const double own = node_size(graph.nodes[i]).x + gap;
            double below = 0;
            for (const std::size_t child : children[i]) below += widths[child];
            widths[i] = std::max(own, below);
            shifts[i] = (widths[i] - below) / 2;
            places[i] = widths[i] / 2;
            if (below < own) continue;
            const std::size_t first = children[i].front(), last = children[i].back();
            places[i] = (places[first] + widths[i] - widths[last] + places[last]) / 2;
            places[i] = std::clamp(places[i], own / 2, widths[i] - own / 2);
        }
    }

    GraphLayout layout;
    layout.nodes.resize(count);
    std::vector<double> lefts(count);
    double flattest = 0, widest = 0;
    for (const std::vector<std::size_t>& row : graph.rows)
        for (const std::size_t i : row) {
            if (!is_child[i]) {
                lefts[i] = layout.width;
                layout.width += widths[i];
            }
            layout.nodes[i].x = lefts[i] + places[i];
            widest = std::max(widest, node_size(graph.nodes[i]).x);
            double left = lefts[i] + shifts[i];
            for (const std::size_t child : children[i]) {
                lefts[child] = left;
                left += widths[child];
                flattest =
                    std::max(flattest, std::fabs(lefts[child] + places[child] - layout.nodes[i].x));
            }
        }
    const double row_height =
        widest > wide ? std::clamp(flattest * slope_of_modules, least_row, largest_row_of_modules)
                      : std::clamp(flattest * least_slope, least_row, largest_row);
    double tallest = 0;
    for (std::size_t row = 0; row < graph.rows.size(); ++row)
        for (const std::size_t i : graph.rows[row]) {
            const double height = node_size(graph.nodes[i]).y;
            tallest = std::max(tallest, height);
            layout.nodes[i].y = static_cast<double>(row) * row_height;
            layout.height = std::max(layout.height, layout.nodes[i].y + height / 2);
        }
    for (Point& node : layout.nodes) node.y += tallest / 2;
    layout.height += tallest / 2;

    for (const Graph::Edge& edge : graph.edges) {
        if (edge.thin) {
            layout.edges.push_back(arc_between(graph, edge, layout));
            continue;
        }
        const Point &from = layout.nodes[edge.from], &to = layout.nodes[edge.to];
        const Point start = edge_end(from, to, graph.nodes[edge.from]);
        const Point end = edge_end(to, from, graph.nodes[edge.to]);
        const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
        layout.edges.push_back({{start, start, end, end}, std::nullopt, middle});
    }
    return layout;
}

}  // namespace algae
