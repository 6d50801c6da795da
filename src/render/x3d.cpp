#include "render/x3d.hpp"

#include "render/scene_text.hpp"

namespace algae {

namespace {

/// A text as XML has it within double quotes.
std::string attribute(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '"')
            out += "&quot;";
        else if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else
            out += c;
    }
    return out;
}

class X3d {
public:
    X3d(const SceneGraph& graph, Output& output, const Budget& budget)
        : graph_(graph),
          text_(output, budget),
          filled_(graph.colours.size()),
          drawn_(graph.colours.size()) {}

    void write() {
        const std::string title = attribute(graph_.title);
        text_.add(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<X3D profile=\"Interchange\" "
            "version=\"3.3\">\n"
            "<head><meta name=\"title\" content=\"{}\"/><meta name=\"generator\" "
            "content=\"algae\"/></head>\n"
            "<Scene>\n<WorldInfo title=\"{}\"/>\n"
            "<NavigationInfo type='\"EXAMINE\" \"ANY\"'/>\n<Background skyColor=\"",
            title, title);
        text_.colour(graph_.background);
        text_.add("\"/>\n");
        for (const SceneGraph::Viewpoint& view : graph_.viewpoints) {
            text_.add("<Viewpoint description=\"{}\" fieldOfView=\"{}\" position=\"",
                      attribute(view.name), single(view.opening));
            text_.vector(view.place);
            text_.add("\" orientation=\"");
            text_.turn(view.turn);
            text_.add("\"/>\n");
        }
        text_.add("<DirectionalLight intensity=\"0.6\" ambientIntensity=\"0.3\" direction=\"");
        text_.vector(graph_.light);
        text_.add("\"/>\n");
        for (const SceneGraph::Body& body : graph_.bodies) add(body);
        for (const SceneGraph::Surface& surface : graph_.surfaces) add(surface);
        for (const SceneGraph::Lines& lines : graph_.lines) add(lines);
        text_.add("</Scene>\n</X3D>\n");
        text_.flush();
    }

private:
    void add(const SceneGraph::Body& body) {
        text_.add("<Transform translation=\"");
        text_.vector(body.middle);
        text_.add("\" rotation=\"");
        text_.turn(body.turn);
        text_.add("\"><Shape>");
        appearance(body.colour, filled_, "C", "diffuseColor");
        const float x = single(body.size.x), y = single(body.size.y), z = single(body.size.z);
        switch (body.shape) {
            case SolidShape::box:
                text_.add("<Box size=\"{} {} {}\"/>", x, y, z);
                break;
            case SolidShape::cylinder:
                text_.add("<Cylinder radius=\"{}\" height=\"{}\"/>", x, y);
                break;
            case SolidShape::cone:
                text_.add("<Cone bottomRadius=\"{}\" height=\"{}\"/>", x, y);
                break;
            case SolidShape::sphere:
                text_.add("<Sphere radius=\"{}\"/>", x);
                break;
        }
        text_.add("</Shape></Transform>\n");
    }
    void add(const SceneGraph::Surface& surface) {
        text_.add("<Shape>");
        appearance(surface.colour, filled_, "C", "diffuseColor");
        text_.add("<IndexedFaceSet creaseAngle=\"{}\" solid=\"{}\" coordIndex=\"",
                  single(graph_.crease), surface.sheet ? "false" : "true");
        text_.triangles(surface.triangles);
        text_.add("\">\n<Coordinate point=\"");
        text_.points(surface.points);
        text_.add("\"/></IndexedFaceSet></Shape>\n");
    }
    void add(const SceneGraph::Lines& lines) {
        text_.add("<Shape>");
        appearance(lines.colour, drawn_, "L", "diffuseColor=\"0 0 0\" emissiveColor");
        text_.add("<IndexedLineSet coordIndex=\"");
        text_.strokes(lines);
        text_.add("\">\n<Coordinate point=\"");
        text_.points(lines.points);
        text_.add("\"/></IndexedLineSet></Shape>\n");
    }
    void appearance(std::uint32_t colour, std::vector<char>& written, const char* prefix,
                    const char* field) {
        if (written[colour]) {
            text_.add("<Appearance USE=\"{}{}\"/>", prefix, colour);
            return;
        }
        text_.add("<Appearance DEF=\"{}{}\"><Material {}=\"", prefix, colour, field);
        text_.colour(graph_.colours[colour]);
        text_.add("\"/></Appearance>");
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
