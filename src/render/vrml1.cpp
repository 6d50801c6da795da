#include "render/scene_text.hpp"
#include "render/vrml.hpp"

namespace algae {

namespace {

class Vrml1 {
public:
    Vrml1(const SceneGraph& graph, Output& output, const Budget& budget)
        : graph_(graph), text_(output, budget), defined_(graph.colours.size()) {}

    void write() {
        text_.add("#VRML V1.0 ascii\nSeparator {{\nDEF BackgroundColor Info {{ string \"");
        text_.colour(graph_.background);
        text_.add("\" }}\nDirectionalLight {{ direction ");
        text_.vector(graph_.light);
        text_.add(" }}\nDEF Cameras Switch {{ whichChild 0\n");
        std::size_t number = 0;
        for (const SceneGraph::Viewpoint& view : graph_.viewpoints) {
            text_.add("DEF View{} PerspectiveCamera {{ position ", ++number);
            text_.vector(view.place);
            text_.add(" orientation ");
            text_.turn(view.turn);
            text_.add(" focalDistance {} heightAngle {} }}\n", single(view.distance),
                      single(view.opening));
        }
        text_.add("}}\n");
        for (const SceneGraph::Body& body : graph_.bodies) add(body);
        for (const SceneGraph::Surface& surface : graph_.surfaces) add(surface);
        for (const SceneGraph::Lines& lines : graph_.lines) add(lines);
        text_.add("}}\n");
        text_.flush();
    }

private:
    void add(const SceneGraph::Body& body) {
        text_.add("Separator {{ ");
        material(body.colour);
        text_.add("Translation {{ translation ");
        text_.vector(body.middle);
        text_.add(" }} Rotation {{ rotation ");
        text_.turn(body.turn);
        text_.add(" }} ");
        const float x = single(body.size.x), y = single(body.size.y), z = single(body.size.z);
        switch (body.shape) {
            case SolidShape::box:
                text_.add("Cube {{ width {} height {} depth {} }}", x, y, z);
                break;
            case SolidShape::cylinder:
                text_.add("Cylinder {{ radius {} height {} }}", x, y);
                break;
            case SolidShape::cone:
                text_.add("Cone {{ bottomRadius {} height {} }}", x, y);
                break;
            case SolidShape::sphere:
                text_.add("Sphere {{ radius {} }}", x);
                break;
        }
        text_.add(" }}\n");
    }
    void add(const SceneGraph::Surface& surface) {
        text_.add("Separator {{ ");
        material(surface.colour);
        text_.add(
            "ShapeHints {{ vertexOrdering COUNTERCLOCKWISE shapeType {} faceType CONVEX "
            "creaseAngle {} }}\n"
            " Coordinate3 {{ point [ ",
            surface.sheet ? "UNKNOWN_SHAPE_TYPE" : "SOLID", single(graph_.crease));
        text_.points(surface.points);
        text_.add("] }}\n IndexedFaceSet {{ coordIndex [ ");
        text_.triangles(surface.triangles);
        text_.add("] }} }}\n");
    }
    void add(const SceneGraph::Lines& lines) {
        text_.add("Separator {{ Material {{ diffuseColor 0 0 0 emissiveColor ");
        text_.colour(graph_.colours[lines.colour]);
        text_.add(" }}\n Coordinate3 {{ point [ ");
        text_.points(lines.points);
        text_.add("] }}\n IndexedLineSet {{ coordIndex [ ");
        text_.strokes(lines);
        text_.add("] }} }}\n");
    }
    void material(std::uint32_t colour) {
        if (defined_[colour]) {
            text_.add("USE C{} ", colour);
            return;
        }
        text_.add("DEF C{} Material {{ diffuseColor ", colour);
        text_.colour(graph_.colours[colour]);
        text_.add(" }} ");
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
