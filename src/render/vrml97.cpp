#include "render/scene_text.hpp"
#include "render/vrml.hpp"

namespace algae {

namespace {

/// A string between quotes, with those within it marked.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

class Vrml97 {
public:
    Vrml97(const SceneGraph& graph, Output& output, const Budget& budget)
        : graph_(graph),
          text_(output, budget),
          filled_(graph.colours.size()),
          drawn_(graph.colours.size()) {}

    void write() {
        text_.add("#VRML V2.0 utf8\nWorldInfo {{ title {} }}\n", quoted(graph_.title));
        text_.add("NavigationInfo {{ type [ \"EXAMINE\", \"ANY\" ] }}\nBackground {{ skyColor [ ");
        text_.colour(graph_.background);
        text_.add(" ] }}\n");
        for (const SceneGraph::Viewpoint& view : graph_.viewpoints) {
            text_.add("Viewpoint {{ description {} fieldOfView {} position ", quoted(view.name),
                      single(view.opening));
            text_.vector(view.place);
            text_.add(" orientation ");
            text_.turn(view.turn);
            text_.add(" }}\n");
        }
        text_.add("DirectionalLight {{ intensity 0.6 ambientIntensity 0.3 direction ");
        text_.vector(graph_.light);
        text_.add(" }}\n");
        for (const SceneGraph::Body& body : graph_.bodies) add(body);
        for (const SceneGraph::Surface& surface : graph_.surfaces) add(surface);
        for (const SceneGraph::Lines& lines : graph_.lines) add(lines);
        text_.flush();
    }

private:
    void add(const SceneGraph::Body& body) {
        text_.add("Transform {{ translation ");
        text_.vector(body.middle);
        text_.add(" rotation ");
        text_.turn(body.turn);
        text_.add(" children Shape {{ ");
        appearance(body.colour);
        const float x = single(body.size.x), y = single(body.size.y), z = single(body.size.z);
        switch (body.shape) {
            case SolidShape::box:
                text_.add("geometry Box {{ size {} {} {} }}", x, y, z);
                break;
            case SolidShape::cylinder:
                text_.add("geometry Cylinder {{ radius {} height {} }}", x, y);
                break;
            case SolidShape::cone:
                text_.add("geometry Cone {{ bottomRadius {} height {} }}", x, y);
                break;
            case SolidShape::sphere:
                text_.add("geometry Sphere {{ radius {} }}", x);
                break;
        }
        text_.add(" }} }}\n");
    }
    void add(const SceneGraph::Surface& surface) {
        text_.add("Shape {{ ");
        appearance(surface.colour);
        text_.add(
            "geometry IndexedFaceSet {{ creaseAngle {} solid {}\n coord Coordinate {{ point [ ",
            single(graph_.crease), surface.sheet ? "FALSE" : "TRUE");
        text_.points(surface.points);
        text_.add("] }}\n coordIndex [ ");
        text_.triangles(surface.triangles);
        text_.add("] }} }}\n");
    }
    void add(const SceneGraph::Lines& lines) {
        text_.add("Shape {{ appearance ");
        if (drawn_[lines.colour])
            text_.add("USE L{} ", lines.colour);
        else {
            text_.add(
                "DEF L{} Appearance {{ material Material {{ diffuseColor 0 0 0 emissiveColor ",
                lines.colour);
            text_.colour(graph_.colours[lines.colour]);
            text_.add(" }} }} ");
            drawn_[lines.colour] = true;
        }
        text_.add("geometry IndexedLineSet {{\n coord Coordinate {{ point [ ");
        text_.points(lines.points);
        text_.add("] }}\n coordIndex [ ");
        text_.strokes(lines);
        text_.add("] }} }}\n");
    }
    void appearance(std::uint32_t colour) {
        if (filled_[colour]) {
            text_.add("appearance USE C{} ", colour);
            return;
        }
        text_.add("appearance DEF C{} Appearance {{ material Material {{ diffuseColor ", colour);
        text_.colour(graph_.colours[colour]);
        text_.add(" }} }} ");
        filled_[colour] = true;
    }

    const SceneGraph& graph_;
    SceneText text_;
    std::vector<char> filled_, drawn_;  // colours whose appearance has been written
};

}  // namespace

void write_vrml97(const SceneGraph& graph, Output& output, const Budget& budget) {
    Vrml97(graph, output, budget).write();
}

}  // namespace algae
