#pragma once

#include "render/graph_layout.hpp"

typedef struct _cairo cairo_t;

namespace algae {

/// A placed graph as a page: margins, labels of rows at the left, keys and caption underneath.
class GraphPage {
public:
    GraphPage(const Graph& graph, const GraphLayout& layout);

    /// In points.
    double width() const { return width_; }
    double height() const { return height_; }
    void draw(cairo_t* context) const;

private:
    void draw_rows(cairo_t* context) const;
    void draw_groups(cairo_t* context) const;
    void draw_edges(cairo_t* context) const;
    void draw_nodes(cairo_t* context) const;
    void draw_below(cairo_t* context) const;

    const Graph& graph_;
    const GraphLayout& layout_;
    double left_ = 0;  // of the graph
    double keys_width_ = 0;
    double width_ = 0, height_ = 0;
};

}  // namespace algae
