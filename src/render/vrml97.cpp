#include <fmt/format.h>

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
        put("#VRML V2.0 utf8\nWorldInfo {{ title {} }}\n", quoted(graph_.title));
        put("NavigationInfo {{ type [ \"EXAMINE\", \"ANY\" ] }}\nBackground {{ skyColor [ ");
        text_.colour(graph_.background);
        put(" ] }}\n");
        for (const SceneGraph::Viewpoint& view : graph_.viewpoints) {
            put("Viewpoint {{ description {} fieldOfView {} position ", quoted(view.name),
                single(view.opening));
            text_.vector(view.place);
            put(" orientation ");
            text_.turn(view.turn);
            put(" }}\n");
        }
        put("DirectionalLight {{ intensity 0.6 ambientIntensity 0.3 direction ");
        text_.vector(graph_.light);
        put(" }}\n");
        for (const SceneGraph::Body& body : graph_.bodies) add(body);
        for (const SceneGraph::Surface& surface : graph_.surfaces) add(surface);
        for (const SceneGraph::Lines& lines : graph_.lines) add(lines);
        text_.flush();
    }

private:
    template <class... Parts>
    void put(fmt::format_string<Parts...> pattern, Parts&&... parts) {
        text_.add(fmt::format(pattern, std::forward<Parts>(parts)...));
    }
    void add(const SceneGraph::Body& body) {
        put("Transform {{ translation ");
        text_.vector(body.middle);
        put(" rotation ");
        text_.turn(body.turn);
        put(" children Shape {{ ");
        appearance(body.colour);
        const float x = single(body.size.x), y = single(body.size.y), z = single(body.size.z);
        switch (body.shape) {
            case SolidShape::box:
                put("geometry Box {{ size {} {} {} }}", x, y, z);
                break;
            case SolidShape::cylinder:
                put("geometry Cylinder {{ radius {} height {} }}", x, y);
                break;
            case SolidShape::cone:
                put("geometry Cone {{ bottomRadius {} height {} }}", x, y);
                break;
            case SolidShape::sphere:
                put("geometry Sphere {{ radius {} }}", x);
                break;
        }
        put(" }} }}\n");
    }
    void add(const SceneGraph::Surface& surface) {
        put("Shape {{ ");
        appearance(surface.colour);
        put("geometry IndexedFaceSet {{ creaseAngle {} solid {}\n coord Coordinate {{ point [ ",
            single(graph_.crease), surface.sheet ? "FALSE" : "TRUE");
        text_.points(surface.points);
        put("] }}\n coordIndex [ ");
        text_.triangles(surface.triangles);
        put("] }} }}\n");
    }
    void add(const SceneGraph::Lines& lines) {
        put("Shape {{ appearance ");
        if (drawn_[lines.colour])
            put("USE L{} ", lines.colour);
        else {
            put("DEF L{} Appearance {{ material Material {{ diffuseColor 0 0 0 emissiveColor ",
                lines.colour);
            text_.colour(graph_.colours[lines.colour]);
            put(" }} }} ");
            drawn_[lines.colour] = true;
        }
        put("geometry IndexedLineSet {{\n coord Coordinate {{ point [ ");
        text_.points(lines.points);
        put("] }}\n coordIndex [ ");
        text_.strokes(lines);
        put("] }} }}\n");
    }
    void appearance(std::uint32_t colour) {
        if (filled_[colour]) {
            put("appearance USE C{} ", colour);
            return;
        }
        put("appearance DEF C{} Appearance {{ material Material {{ diffuseColor ", colour);
        text_.colour(graph_.colours[colour]);
        put(" }} }} ");
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
