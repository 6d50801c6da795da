#include <algorithm>
#include <cmath>

#include "render/detail/figure_text.hpp"
#include "render/detail/graph.hpp"

// Figures for documents that are set: TikZ for LaTeX, Typst, and SVG with names.
//
// What a person wants to change stands at the head, under names: the unit, a style for each colour, for each width and for each letter
// that draws. Below there are only paths with points in the units of the figure, as far as TeX can compute in these: its numbers end at
// 16383 and its lengths are whole numbers of 1/65536 point, so where a unit is shorter than a point, points are in points of the page.
// Strokes of one style that follow each other share a statement, up to a length that an editor and TeX can bear.

namespace algae {

namespace {

constexpr std::size_t strokes_of_statement = 400;
constexpr std::size_t most_named = 64;  // styles of a kind; more are written at each path

/// Digits behind the point, so that points are right to a thousandth of a point of the page.
int digits_for(double scale) {
    return std::clamp(static_cast<int>(std::ceil(std::log10(std::max(scale, 1e-9)))) + 3, 0, 12);
}

/// The different values of some property of the styles that are used, in order of appearance.
template <class Value, class Of>
std::vector<Value> different(const FigureDocument& document, Of of) {
    std::vector<Value> found;
    for (const PlacedFigure& figure : document.figures)
        for (const PathStyle& style : figure.paths.styles) {
            const Value value = of(style);
            if (std::ranges::find(found, value) == found.end()) found.push_back(value);
        }
    return found;
}

struct Styles {
    std::vector<Colour> colours;
    std::vector<double> widths;
    std::vector<std::string> letters;

    explicit Styles(const FigureDocument& document)
        : colours(different<Colour>(document, [](const PathStyle& style) { return style.colour; })),
          widths(different<double>(document, [](const PathStyle& style) { return style.width; })),
          letters(different<std::string>(document,
                                         [](const PathStyle& style) { return style.letter; })) {
        std::erase(letters, std::string());
    }
    std::size_t colour(const PathStyle& style) const { return place(colours, style.colour); }
    std::size_t width(const PathStyle& style) const { return place(widths, style.width); }
    bool names_colours() const { return colours.size() <= most_named; }
    bool names_widths() const { return widths.size() <= most_named; }

private:
    template <class Value>
    static std::size_t place(const std::vector<Value>& values, const Value& value) {
        return static_cast<std::size_t>(std::ranges::find(values, value) - values.begin());
    }
};

/// Runs of paths of one style: from and to, places in the list.
std::vector<std::pair<std::size_t, std::size_t>> statements(const FigurePaths& figure) {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    std::size_t strokes = 0;
    for (std::size_t i = 0; i < figure.paths.size(); ++i) {
        const FigurePath& path = figure.paths[i];
        const bool goes_on = i > 0 && !path.filled && !figure.paths[i - 1].filled &&
                             path.style == figure.paths[i - 1].style &&
                             strokes + path.points.size() <= strokes_of_statement;
        if (!goes_on) {
            found.emplace_back(i, i);
            strokes = 0;
        }
        found.back().second = i + 1;
        strokes += path.points.size();
    }
    return found;
}

/// What the figures are, for a comment of one line.
std::string about(const FigureDocument& document) {
    std::uint64_t strokes = 0, polygons = 0;
    for (const PlacedFigure& figure : document.figures) {
        strokes += figure.paths.strokes;
        polygons += figure.paths.polygons;
    }
    std::string text = document.head;
    if (document.figures.size() == 1 && text != document.figures.front().source->plate.name)
        text += ", " + document.figures.front().source->plate.name;
    text += ": " + std::to_string(strokes) + (strokes == 1 ? " stroke" : " strokes");
    if (polygons > 0)
        text += ", " + std::to_string(polygons) + (polygons == 1 ? " polygon" : " polygons");
    std::ranges::replace(text, '\n', ' ');
    return text;
}

/// Points of a path on the page: in the units of the figure, or in points.
struct Scale {
    bool in_units = false;
    double unit = 1;  // points of the page that a coordinate 1 is
    int digits = 3;

    Scale(const PlacedFigure& figure, double least) {
        const Frame& frame = figure.cell.frame;
        const Box& box = figure.source->plate.figure->box();
        const double farthest = std::max({std::fabs(box.low.x), std::fabs(box.low.y),
                                          std::fabs(box.high.x), std::fabs(box.high.y)});
        in_units = frame.scale >= least && farthest < 10000;
        unit = in_units ? frame.scale : 1;
        digits = digits_for(unit);
        factor_ = in_units ? 1 : frame.scale;
        if (in_units) return;
        middle_ = {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
    }
    /// Where the origin of the coordinates is on the page, y downward.
    Point origin(const Frame& frame) const { return frame(middle_); }
    std::string operator()(Point point) const {
        return fixed_text((point.x - middle_.x) * factor_, digits) + "," +
               fixed_text((point.y - middle_.y) * factor_, digits);
    }

private:
    double factor_ = 1;
    Point middle_{};
};

bool is_dark(const std::optional<Colour>& background) {
    return background &&
           0.299 * background->red + 0.587 * background->green + 0.114 * background->blue < 0.5;
}

// --- TikZ ---

std::string tikz_parts(const Colour& colour, const char* green, const char* blue) {
    const auto part = [](double value) {
        return std::to_string(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    };
    return part(colour.red) + green + part(colour.green) + blue + part(colour.blue);
}

/// The colour as a value of a key.
std::string tikz_colour(const Colour& colour) {
    return "{rgb,255:red," + tikz_parts(colour, ";green,", ";blue,") + "}";
}

/// The colour under a name: values with commas do not pass through styles of styles.
std::string defined_colour(const std::string& name, const Colour& colour) {
    return "\\definecolor{" + name + "}{RGB}{" + tikz_parts(colour, ",", ",") + "}\n";
}

std::string tikz_options(const Styles& styles, const PathStyle& style, bool filled) {
    std::string text = styles.names_colours() ? "colour " + std::to_string(styles.colour(style) + 1)
                                              : "color=" + tikz_colour(style.colour);
    if (!filled && styles.widths.size() > 1)
        text += styles.names_widths() ? ", width " + std::to_string(styles.width(style) + 1)
                                      : ", line width=" + fixed_text(style.width, 4) + "bp";
    if (!style.letter.empty()) text += ", letter " + plain_name(style.letter);
    return text;
}

}  // namespace

std::string tikz_text(const FigureDocument& document) {
    const Styles styles(document);
    const Plan& plan = *document.plan;
    std::string out = "% " + about(document) + "\n";
    if (!document.options->picture.source.empty())
        out += "% Source: " + document.options->picture.source + "\n";
    out += "% It needs \\usepackage{tikz}; \\input{...} this file where the figure shall stand.\n";
    out += "\\begin{tikzpicture}[\n  x=1bp, y=1bp, line cap=";
    out += document.options->picture.flat_ends ? "butt" : "round";
    out += ", line join=round";
    if (!styles.widths.empty()) out += ", line width=" + fixed_text(styles.widths[0], 4) + "bp";
    out += ",\n";
    if (styles.names_colours())
        for (std::size_t i = 0; i < styles.colours.size(); ++i)
            out += "  colour " + std::to_string(i + 1) + "/.style={color=algae" +
                   std::to_string(i + 1) + "},\n";
    if (styles.names_widths() && styles.widths.size() > 1)
        for (std::size_t i = 0; i < styles.widths.size(); ++i)
            out += "  width " + std::to_string(i + 1) +
                   "/.style={line width=" + fixed_text(styles.widths[i], 4) + "bp},\n";
    for (const std::string& letter : styles.letters)
        out += "  letter " + plain_name(letter) + "/.style={},\n";
    out += "]\n";
    if (styles.names_colours())
        for (std::size_t i = 0; i < styles.colours.size(); ++i)
            out += defined_colour("algae" + std::to_string(i + 1), styles.colours[i]);
    const double height = plan.page.height;
    if (plan.background)
        out += "\\fill[color=" + tikz_colour(*plan.background) + "] (0,0) rectangle (" +
               fixed_text(plan.page.width, 3) + "," + fixed_text(height, 3) + ");\n";
    else
        out += "\\useasboundingbox (0,0) rectangle (" + fixed_text(plan.page.width, 3) + "," +
               fixed_text(height, 3) + ");\n";
    const std::string ink = is_dark(plan.background) ? "white" : "black";
    const auto font_of = [&](double size) {
        return "font=\\fontsize{" + fixed_text(size, 2) + "}{" + fixed_text(1.2 * size, 2) +
               "}\\selectfont, text=" + ink;
    };
    const std::string font = font_of(plan.font_size);
    for (const PlacedFigure& figure : document.figures) {
        const Cell& cell = figure.cell;
        const Frame& frame = cell.frame;
        const Scale scale(figure, 1);
        const Point origin = scale.origin(frame);
        if (document.figures.size() > 1) out += "% " + figure.source->plate.name + "\n";
        out += "\\begin{scope}[shift={(" + fixed_text(origin.x, 4) + "," +
               fixed_text(height - origin.y, 4) + ")}, x=" + fixed_text(scale.unit, 6) +
               "bp, y=" + fixed_text(scale.unit, 6) + "bp]\n";
        for (const auto& [from, to] : statements(figure.paths)) {
            const FigurePath& first = figure.paths.paths[from];
            out += first.filled ? "\\fill[" : "\\draw[";
            out += tikz_options(styles, figure.paths.styles[first.style], first.filled) + "]";
            std::size_t line = 0;
            for (std::size_t i = from; i < to; ++i) {
                const auto& points = figure.paths.paths[i].points;
                for (std::size_t k = 0; k < points.size(); ++k) {
                    if (line++ % 6 == 0) out += "\n ";
                    out += (k > 0 ? " -- (" : " (") + scale(points[k]) + ")";
                }
            }
            out += first.filled ? " -- cycle;\n" : ";\n";
        }
        for (const PointLabel& label : plan.options.labels)
            if (const auto place = figure.source->plate.figure->place(label.place))
                out += "\\node[anchor=south west, inner sep=1bp, " + font + "] at (" +
                       scale(*place) + ") {" + escaped_latex(label.text) + "};\n";
        out += "\\end{scope}\n";
        double below = height - cell.caption_top;
        if (plan.options.scale_bar) {
            const double length = scale_bar_length(cell.width / frame.scale);
            const double y = below - 0.9 * plan.font_size;
            out += "\\draw[" + ink +
                   ", |-|, line width=" + fixed_text(std::max(0.5, plan.font_size / 14), 3) +
                   "bp] (" + fixed_text(cell.left, 3) + "," + fixed_text(y, 3) + ") -- (" +
                   fixed_text(cell.left + length * frame.scale, 3) + "," + fixed_text(y, 3) +
                   ") node[right, " + font + "] {" + rounded_decimal(length, 10) + "};\n";
            below -= 1.6 * plan.font_size;
        }
        if (!figure.source->plate.caption.empty())
            out += "\\node[anchor=base, " +
                   font_of(fitting_size(figure.source->plate.caption, plan.font_size, cell.width)) +
                   "] at (" + fixed_text(cell.left + cell.width / 2, 3) + "," +
                   fixed_text(below - 1.4 * plan.font_size, 3) + ") {" +
                   escaped_latex(figure.source->plate.caption) + "};\n";
    }
    return out + "\\end{tikzpicture}\n";
}

// --- Typst ---

namespace {

std::string typst_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

}  // namespace

std::string typst_text(const FigureDocument& document) {
    const Styles styles(document);
    const Plan& plan = *document.plan;
    const double height = plan.page.height;
    std::string out = "// " + about(document) + "\n";
    if (!document.options->picture.source.empty())
        out += "// Source: " + document.options->picture.source + "\n";
    out += "// For Typst 0.13 or later; #include \"...\" this file where the figure shall stand.\n";
    for (std::size_t i = 0; i < styles.colours.size(); ++i)
        out += "#let colour-" + std::to_string(i + 1) + " = rgb(\"" +
               hex_colour(styles.colours[i]) + "\")\n";
    // A style for each letter, which a person may change, and what draws paths with it.
    for (const std::string& letter : styles.letters)
        out += "#let letter-" + plain_name(letter) + " = (:)\n";
    out += "#let pen = (cap: \"" +
           std::string(document.options->picture.flat_ends ? "butt" : "round") +
           "\", join: \"round\")\n"
           "#let path-through(origin, unit, style, points) = place(curve(stroke: pen + style,\n"
           "  curve.move(at(origin, unit, points.first())),\n"
           "  ..points.slice(1).map(p => curve.line(at(origin, unit, p)))))\n"
           "#let filled-through(origin, unit, colour, points) = place(curve(fill: colour,\n"
           "  curve.move(at(origin, unit, points.first())),\n"
           "  ..points.slice(1).map(p => curve.line(at(origin, unit, p))), curve.close()))\n";
    const std::string at =
        "#let at(origin, unit, p) = (origin.at(0) + p.at(0) * unit, origin.at(1) - p.at(1) * "
        "unit)\n";
    out.insert(out.find("#let pen = "), at);
    out += "#box(width: " + fixed_text(plan.page.width, 3) +
           "pt, height: " + fixed_text(height, 3) + "pt";
    if (plan.background) out += ", fill: rgb(\"" + hex_colour(*plan.background) + "\")";
    out += ", {\n";
    const std::string ink = is_dark(plan.background) ? "white" : "black";
    for (const PlacedFigure& figure : document.figures) {
        const Cell& cell = figure.cell;
        const Scale scale(figure, 0.001);
        const Point origin = scale.origin(cell.frame);
        if (document.figures.size() > 1) out += "  // " + figure.source->plate.name + "\n";
        const std::string head = "(" + fixed_text(origin.x, 4) + "pt, " + fixed_text(origin.y, 4) +
                                 "pt), " + fixed_text(scale.unit, 6) + "pt, ";
        for (const FigurePath& path : figure.paths.paths) {
            const PathStyle& style = figure.paths.styles[path.style];
            const std::string colour = "colour-" + std::to_string(styles.colour(style) + 1);
            if (path.filled)
                out += "  filled-through(" + head + colour + ", (";
            else
                out += "  path-through(" + head + "(paint: " + colour +
                       ", thickness: " + fixed_text(style.width, 4) + "pt)" +
                       (style.letter.empty() ? "" : " + letter-" + plain_name(style.letter)) +
                       ", (";
            for (std::size_t k = 0; k < path.points.size(); ++k)
                out += (k % 6 == 0 ? "\n    (" : " (") + scale(path.points[k]) + "),";
            out += "))\n";
        }
        const auto text = [&](double x, double y, const std::string& alignment,
                              const std::string& said, double size) {
            out += "  place(dx: " + fixed_text(x, 3) + "pt, dy: " + fixed_text(y, 3) +
                   "pt, box(width: 0pt, height: 0pt, place(" + alignment +
                   ", text(size: " + fixed_text(size, 2) + "pt, fill: " + ink + ", box(" +
                   typst_string(said) + ")))))\n";
        };
        for (const PointLabel& label : plan.options.labels)
            if (const auto place = figure.source->plate.figure->place(label.place)) {
                const Point there = cell.frame(*place);
                text(there.x, there.y, "bottom + left", label.text, plan.font_size);
            }
        double below = cell.caption_top;
        if (plan.options.scale_bar) {
            const double length = scale_bar_length(cell.width / cell.frame.scale);
            const double y = below + 0.9 * plan.font_size;
            out += "  place(dx: " + fixed_text(cell.left, 3) + "pt, dy: " + fixed_text(y, 3) +
                   "pt, line(length: " + fixed_text(length * cell.frame.scale, 3) +
                   "pt, stroke: 0.8pt + " + ink + "))\n";
            text(cell.left + length * cell.frame.scale + plan.font_size / 2,
                 y + 0.4 * plan.font_size, "bottom + left", rounded_decimal(length, 10),
                 plan.font_size);
            below += 1.6 * plan.font_size;
        }
        if (!figure.source->plate.caption.empty())
            text(cell.left + cell.width / 2, below + 1.4 * plan.font_size, "bottom + center",
                 figure.source->plate.caption,
                 fitting_size(figure.source->plate.caption, plan.font_size, cell.width));
    }
    return out + "})\n";
}

// --- Graphs ---

namespace {

/// The colours of a graph's nodes, in order of appearance.
std::vector<Colour> fills_of(const Graph& graph) {
    std::vector<Colour> found;
    for (const Graph::Node& node : graph.nodes)
        if (node.fill && std::ranges::find(found, *node.fill) == found.end())
            found.push_back(*node.fill);
    return found;
}

std::string node_label(const Graph::Node& node) {
    std::string text = letter_latex(node.label);
    if (!node.subscript.empty()) text += "_{" + node.subscript + "}";
    // `$$` would be displayed.
    return text.empty() ? "" : node.bold ? "$\\boldsymbol{" + text + "}$" : "$" + text + "$";
}

std::string shape_of(const Graph::Node& node) {
    using enum Graph::Node::Shape;
    switch (node.shape) {
        case round:
            return "letter";
        case box:
            return "boxed";
        case bare:
            return "bare";
        case triangle:
            return "cut off";
        case start:
            return "start";
    }
    return "letter";
}

std::string graph_styles(const std::vector<Colour>& fills) {
    std::string out =
        "  letter/.style={draw, rounded corners=2mm, minimum size=4mm, inner sep=1mm},\n"
        "  boxed/.style={draw, rounded corners=1mm, inner sep=1.2mm},\n"
        "  bare/.style={inner sep=0.6mm},\n"
        "  cut off/.style={draw, shape border rotate=0, regular polygon, regular polygon sides=3, "
        "inner sep=0.2mm},\n"
        "  start/.style={inner sep=0pt, minimum size=0pt},\n"
        "  context/.style={gray, very thin, ->},\n"
        "  times/.style={font=\\scriptsize},\n";
    for (std::size_t i = 0; i < fills.size(); ++i)
        out += "  fill " + std::to_string(i + 1) + "/.style={fill=algaefill" +
               std::to_string(i + 1) + "},\n";
    return out;
}

std::string defined_fills(const std::vector<Colour>& fills) {
    std::string out;
    for (std::size_t i = 0; i < fills.size(); ++i)
        out += defined_colour("algaefill" + std::to_string(i + 1), fills[i]);
    return out;
}

std::string node_style(const Graph::Node& node, const std::vector<Colour>& fills) {
    std::string style = shape_of(node);
    if (node.fill)
        style +=
            ", fill " + std::to_string(std::ranges::find(fills, *node.fill) - fills.begin() + 1);
    return style;
}

/// A forest: children in their order, contexts as arcs between named nodes.
std::string forest_text(const Graph& graph, const std::vector<Colour>& fills) {
    std::vector<std::vector<std::size_t>> below(graph.nodes.size());  // edges to children
    std::vector<char> is_child(graph.nodes.size());
    std::string arcs;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        const Graph::Edge& edge = graph.edges[i];
        if (edge.thin) {
            arcs += "  \\draw[context] (n" + std::to_string(edge.from) + ") to[bend left=20] (n" +
                    std::to_string(edge.to) + ");\n";
            continue;
        }
        below[edge.from].push_back(i);
        is_child[edge.to] = 1;
    }
    std::vector<std::size_t> place(graph.nodes.size()), row(graph.nodes.size());
    for (std::size_t r = 0; r < graph.rows.size(); ++r)
        for (std::size_t i = 0; i < graph.rows[r].size(); ++i) {
            row[graph.rows[r][i]] = r;
            place[graph.rows[r][i]] = i;
        }
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i)
        if (!is_child[i]) roots.push_back(i);
    for (auto& edges : below)
        std::ranges::sort(edges, {}, [&](std::size_t edge) { return place[graph.edges[edge].to]; });
    std::ranges::sort(roots, {}, [&](std::size_t root) { return place[root]; });
    const bool many = roots.size() != 1;

    std::string out =
        "% It needs \\usepackage{forest}, \\usetikzlibrary{shapes.geometric} and, for bold "
        "letters, "
        "\\usepackage{amsmath}.\n" +
        defined_fills(fills) + "\\tikzset{\n" + graph_styles(fills) +
        "}\n\\begin{forest}\n  for tree={parent anchor=south, child anchor=north, l sep=6mm, s "
        "sep=2mm}\n";
    if (many) out += "  [, phantom\n";
    // Without recursion: a tree may be as deep as its generations.
    struct Open {
        std::size_t node, next;
    };
    for (const std::size_t root : roots) {
        std::vector<Open> open;
        const auto begin = [&](std::size_t node, const std::string& more) {
            out += std::string(2 * (open.size() + (many ? 2 : 1)), ' ') + "[{" +
                   node_label(graph.nodes[node]) + "}, " + node_style(graph.nodes[node], fills) +
                   ", name=n" + std::to_string(node) + more;
            open.push_back({node, 0});
            out += below[node].empty() ? "" : "\n";
        };
        begin(root, "");
        while (!open.empty()) {
            Open& here = open.back();
            if (here.next < below[here.node].size()) {
                const Graph::Edge& edge = graph.edges[below[here.node][here.next++]];
                std::string more;
                if (!edge.label.empty())
                    more = ", edge label={node[midway, times]{$" + letter_latex(edge.label) + "$}}";
                if (edge.dashed) more += ", edge=dashed";
                begin(edge.to, more);
                continue;
            }
            if (!below[here.node].empty())
                out += std::string(2 * (open.size() + (many ? 1 : 0)), ' ');
            out += "]\n";
            open.pop_back();
        }
    }
    if (many) out += "  ]\n";
    return out + arcs + "\\end{forest}\n";
}

}  // namespace

std::string latex_text(const Graph& graph, const Budget& budget) {
    const std::vector<Colour> fills = fills_of(graph);
    const std::string head = graph.caption.empty() ? std::string() : "% " + graph.caption + "\n";
    if (graph.trees) return head + forest_text(graph, fills);
    const GraphLayout layout = graph_layout(graph, budget);
    const auto at = [&](Point point) {
        return "(" + fixed_text(point.x, 2) + "," + fixed_text(layout.height - point.y, 2) + ")";
    };
    std::string out =
        head +
        "% It needs \\usepackage{tikz,amsmath} and \\usetikzlibrary{arrows.meta, "
        "shapes.geometric}.\n" +
        defined_fills(fills) + "\\begin{tikzpicture}[\n  x=1bp, y=1bp, >=Stealth,\n" +
        graph_styles(fills) +
        "  frame/.style={rounded corners=2mm},\n  label/.style={font=\\scriptsize}]\n";
    for (std::size_t i = 0; i < graph.groups.size(); ++i) {
        const GraphLayout::Frame& frame = layout.groups[i];
        out += "\\draw[frame, fill=" + tikz_colour(graph.groups[i].fill) + "] " +
               at({frame.left, frame.bottom}) + " rectangle " + at({frame.right, frame.top}) +
               ";\n\\node[label] at " + at(frame.label) + " {" +
               escaped_latex(graph.groups[i].label) + "};\n";
    }
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const Graph::Node& node = graph.nodes[i];
        const bool is_text = node.label.find(' ') != std::string::npos || graph.upward;
        out += "\\node[" + node_style(node, fills) + "] (n" + std::to_string(i) + ") at " +
               at(layout.nodes[i]) + " {" +
               (is_text ? escaped_latex(node.label + node.subscript) : node_label(node)) + "};\n";
    }
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        const Graph::Edge& edge = graph.edges[i];
        const GraphLayout::Line& line = layout.edges[i];
        if (line.points.empty()) continue;
        std::string style = edge.thin ? "context" : edge.arrow ? "->" : "";
        if (edge.dashed) style += style.empty() ? "dashed" : ", dashed";
        out += "\\draw[" + style + "] " + at(line.points[0]);
        for (std::size_t k = 1; k + 2 < line.points.size(); k += 3)
            out += " .. controls " + at(line.points[k]) + " and " + at(line.points[k + 1]) +
                   " .. " + at(line.points[k + 2]);
        if (line.tip) out += " -- " + at(*line.tip);
        out += ";\n";
        if (!edge.label.empty())
            out +=
                "\\node[label] at " + at(line.label) + " {$" + letter_latex(edge.label) + "$};\n";
    }
    double below = -14;
    for (const Graph::Key& key : graph.keys) {
        out += "\\fill[" + tikz_colour(key.fill).insert(0, "color=") + "] (0," +
               fixed_text(below - 4, 0) + ") rectangle (8," + fixed_text(below + 4, 0) +
               ");\n\\node[anchor=west, label] at (10," + fixed_text(below, 0) + ") {" +
               escaped_latex(key.text) + "};\n";
        below -= 14;
    }
    return out + "\\end{tikzpicture}\n";
}

}  // namespace algae
