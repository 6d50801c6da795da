#include <fmt/format.h>

#include "render/scene_text.hpp"
#include "render/vrml.hpp"

namespace algae {

namespace {

class Vrml1 {
public:
    Vrml1(const SceneGraph& graph, Output& output, const Budget& budget)
        : graph_(graph), text_(output, budget), defined_(graph.colours.size()) {}

    void write() {
        put("#VRML V1.0 ascii\nSeparator {{\nDEF BackgroundColor Info {{ string \"");
        text_.colour(graph_.background);
        put("\" }}\nDirectionalLight {{ direction ");
        text_.vector(graph_.light);
        put(" }}\nDEF Cameras Switch {{ whichChild 0\n");
        std::size_t number = 0;
        for (const SceneGraph::Viewpoint& view : graph_.viewpoints) {
            put("DEF View{} PerspectiveCamera {{ position ", ++number);
            text_.vector(view.place);
            put(" orientation ");
            text_.turn(view.turn);
            put(" focalDistance {} heightAngle {} }}\n", single(view.distance),
                single(view.opening));
        }
        put("}}\n");
        for (const SceneGraph::Body& body : graph_.bodies) add(body);
        for (const SceneGraph::Surface& surface : graph_.surfaces) add(surface);
        for (const SceneGraph::Lines& lines : graph_.lines) add(lines);
        put("}}\n");
        text_.flush();
    }

private:
    template <class... Parts>
    void put(fmt::format_string<Parts...> pattern, Parts&&... parts) {
        text_.add(fmt::format(pattern, std::forward<Parts>(parts)...));
    }
    void add(const SceneGraph::Body& body) {
        put("Separator {{ ");
        material(body.colour);
        put("Translation {{ translation ");
        text_.vector(body.middle);
        put(" }} Rotation {{ rotation ");
        text_.turn(body.turn);
        put(" }} ");
        const float x = single(body.size.x), y = single(body.size.y), z = single(body.size.z);
        switch (body.shape) {
            case SolidShape::box:
                put("Cube {{ width {} height {} depth {} }}", x, y, z);
                break;
            case SolidShape::cylinder:
                put("Cylinder {{ radius {} height {} }}", x, y);
                break;
            case SolidShape::cone:
                put("Cone {{ bottomRadius {} height {} }}", x, y);
                break;
            case SolidShape::sphere:
                put("Sphere {{ radius {} }}", x);
                break;
        }
        put(" }}\n");
    }
    void add(const SceneGraph::Surface& surface) {
        put("Separator {{ ");
        material(surface.colour);
        put("ShapeHints {{ vertexOrdering COUNTERCLOCKWISE shapeType {} faceType CONVEX "
            "creaseAngle {} }}\n"
            " Coordinate3 {{ point [ ",
            surface.sheet ? "UNKNOWN_SHAPE_TYPE" : "SOLID", single(graph_.crease));
        text_.points(surface.points);
        put("] }}\n IndexedFaceSet {{ coordIndex [ ");
        text_.triangles(surface.triangles);
        put("] }} }}\n");
    }
    void add(const SceneGraph::Lines& lines) {
        put("Separator {{ Material {{ diffuseColor 0 0 0 emissiveColor ");
        text_.colour(graph_.colours[lines.colour]);
        put(" }}\n Coordinate3 {{ point [ ");
        text_.points(lines.points);
        put("] }}\n IndexedLineSet {{ coordIndex [ ");
        text_.strokes(lines);
        put("] }} }}\n");
    }
    void material(std::uint32_t colour) {
        if (defined_[colour]) {
            put("USE C{} ", colour);
            return;
        }
        put("DEF C{} Material {{ diffuseColor ", colour);
        text_.colour(graph_.colours[colour]);
        put(" }} ");
        defined_[colour] = true;
    }

    const SceneGraph& graph_;
    SceneText text_;
    std::vector<char> defined_;  // colours whose material has been written
};

}  // namespace

void write_vrml1(const SceneGraph& graph, Output& output, const Budget& budget) {
    Vrml1(graph, output, budget).write();
}

}  // namespace algae
