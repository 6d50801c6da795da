#include "render/x3d.hpp"

#include <fmt/format.h>

#include "render/markup.hpp"
#include "render/scene_text.hpp"

namespace algae {

namespace {

class X3d {
public:
    X3d(const SceneGraph& graph, Output& output, const Budget& budget)
        : graph_(graph),
          text_(output, budget),
          filled_(graph.colours.size()),
          drawn_(graph.colours.size()) {}

    void write() {
        const std::string title = escaped_markup(graph_.title);
        put("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<X3D profile=\"Interchange\" "
            "version=\"3.3\">\n"
            "<head><meta name=\"title\" content=\"{}\"/><meta name=\"generator\" "
            "content=\"algae\"/></head>\n"
            "<Scene>\n<WorldInfo title=\"{}\"/>\n"
            "<NavigationInfo type='\"EXAMINE\" \"ANY\"'/>\n<Background skyColor=\"",
            title, title);
        text_.colour(graph_.background);
        put("\"/>\n");
        for (const SceneGraph::Viewpoint& view : graph_.viewpoints) {
            put("<Viewpoint description=\"{}\" fieldOfView=\"{}\" position=\"",
                escaped_markup(view.name), single(view.opening));
            text_.vector(view.place);
            put("\" orientation=\"");
            text_.turn(view.turn);
            put("\"/>\n");
        }
        put("<DirectionalLight intensity=\"0.6\" ambientIntensity=\"0.3\" direction=\"");
        text_.vector(graph_.light);
        put("\"/>\n");
        for (const SceneGraph::Body& body : graph_.bodies) add(body);
        for (const SceneGraph::Surface& surface : graph_.surfaces) add(surface);
        for (const SceneGraph::Lines& lines : graph_.lines) add(lines);
        put("</Scene>\n</X3D>\n");
        text_.flush();
    }

private:
    template <class... Parts>
    void put(fmt::format_string<Parts...> pattern, Parts&&... parts) {
        text_.add(fmt::format(pattern, std::forward<Parts>(parts)...));
    }
    void add(const SceneGraph::Body& body) {
        put("<Transform translation=\"");
        text_.vector(body.middle);
        put("\" rotation=\"");
        text_.turn(body.turn);
        put("\"><Shape>");
        appearance(body.colour, filled_, "C", "diffuseColor");
        const float x = single(body.size.x), y = single(body.size.y), z = single(body.size.z);
        switch (body.shape) {
            case SolidShape::box:
                put("<Box size=\"{} {} {}\"/>", x, y, z);
                break;
            case SolidShape::cylinder:
                put("<Cylinder radius=\"{}\" height=\"{}\"/>", x, y);
                break;
            case SolidShape::cone:
                put("<Cone bottomRadius=\"{}\" height=\"{}\"/>", x, y);
                break;
            case SolidShape::sphere:
                put("<Sphere radius=\"{}\"/>", x);
                break;
        }
        put("</Shape></Transform>\n");
    }
    void add(const SceneGraph::Surface& surface) {
        put("<Shape>");
        appearance(surface.colour, filled_, "C", "diffuseColor");
        put("<IndexedFaceSet creaseAngle=\"{}\" solid=\"{}\" coordIndex=\"", single(graph_.crease),
            surface.sheet ? "false" : "true");
        text_.triangles(surface.triangles);
        put("\">\n<Coordinate point=\"");
        text_.points(surface.points);
        put("\"/></IndexedFaceSet></Shape>\n");
    }
    void add(const SceneGraph::Lines& lines) {
        put("<Shape>");
        appearance(lines.colour, drawn_, "L", "diffuseColor=\"0 0 0\" emissiveColor");
        put("<IndexedLineSet coordIndex=\"");
        text_.strokes(lines);
        put("\">\n<Coordinate point=\"");
        text_.points(lines.points);
        put("\"/></IndexedLineSet></Shape>\n");
    }
    void appearance(std::uint32_t colour, std::vector<char>& written, const char* prefix,
                    const char* field) {
        if (written[colour]) {
            put("<Appearance USE=\"{}{}\"/>", prefix, colour);
            return;
        }
        put("<Appearance DEF=\"{}{}\"><Material {}=\"", prefix, colour, field);
        text_.colour(graph_.colours[colour]);
        put("\"/></Appearance>");
        written[colour] = true;
    }

    const SceneGraph& graph_;
    SceneText text_;
    std::vector<char> filled_, drawn_;  // colours whose appearance has been written
};

}  // namespace

void write_x3d(const SceneGraph& graph, Output& output, const Budget& budget) {
    X3d(graph, output, budget).write();
}

}  // namespace algae
